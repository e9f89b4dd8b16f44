"""pba: arithmetic with probability boxes, no sampling.

It has no sine of an interval, so that c sin p and c cos p enter as [-0.5, 0.5]. The crank occurs twice; the operations assume
nothing of dependence (the package's default, Frechet bounds). Its operations with a constant or an interval fail in this version
(a name is used before it exists), as does the method for square roots: constants are written as probability boxes, and roots go
through `unary`. The result is the same for every seed; one evaluation is one pass of the arithmetic.
"""

import numpy as np
import pba
from problem import CLEARANCE_MM, COSINE, CRANK_MM, IS_ROUGH, LIMITS_MM, NOMINAL_MM, QUANTILES, ROD_MM, SINE, Bounds, conduct

STEPS = pba.Pbox.STEPS


def between(low: float, high: float) -> pba.Pbox:
    """An interval as a probability box."""
    return pba.Pbox(left=np.full(STEPS, float(low)), right=np.full(STEPS, float(high)))


def scaled(factor: float, box: pba.Pbox) -> pba.Pbox:
    """A positive factor times a box."""
    return pba.Pbox(left=factor * box.left, right=factor * box.right)


def arithmetic(_seed: int) -> tuple[Bounds, int]:
    """y, and the six statistics of its probability box."""
    crank_mm, rod_mm = pba.N(*CRANK_MM), pba.N(*ROD_MM)
    offset_mm = between(-CLEARANCE_MM[1], CLEARANCE_MM[1])
    height_mm = scaled(SINE, crank_mm) + offset_mm
    square_mm2 = rod_mm * rod_mm - height_mm * height_mm
    foot_mm = square_mm2.unary(func=lambda interval: interval.sqrt())
    box = scaled(COSINE, crank_mm) + foot_mm + offset_mm + between(-NOMINAL_MM, -NOMINAL_MM)
    variance = [max(0.0, float(end)) for end in (box.var.left, box.var.right)]
    bounds = {
        "mean": (float(box.mean.left), float(box.mean.right)),
        "deviation": (variance[0] ** 0.5, variance[1] ** 0.5),
    }
    for level in QUANTILES:
        cut = box.get_interval(level)
        bounds[f"quantile {level}"] = (float(cut.left), float(cut.right))
    low, high = np.minimum(box.left, box.right), np.maximum(box.left, box.right)
    for limit_mm in LIMITS_MM:
        least = (low > limit_mm).mean() + (high < -limit_mm).mean()
        most = ((high > limit_mm) | (low < -limit_mm)).mean()
        bounds[f"beyond {limit_mm:.2f}"] = (float(least), float(most))
    return bounds, 1


if __name__ == "__main__":
    conduct([] if IS_ROUGH else [("arithmetic with probability boxes", arithmetic)])

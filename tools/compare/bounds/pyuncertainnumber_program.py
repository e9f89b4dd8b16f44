"""pyuncertainnumber: the propagation of random numbers and intervals together, which is what it is made for.

`interval_monte_carlo` bounds y over the box for each sample: by its corners, by the corners of subintervals (four an input, also
of the lengths), or by interval arithmetic. The result is a probability box, from which all statistics are read. It lets
the intervals differ from sample to sample, so that its deviation is not that of one unknown clearance.
`double_monte_carlo` of this version takes one random input; here are two.
"""

import numpy as np
from problem import BOX, COSINE, CRANK_MM, IS_ROUGH, LIMITS_MM, NOMINAL_MM, QUANTILES, ROD_MM, SINE, Bounds, Response, conduct
from pyuncertainnumber import pba
from pyuncertainnumber.propagation.mixed_up import interval_monte_carlo


def inputs() -> list:
    """r, l, c, p."""
    lengths = [pba.Distribution("gaussian", parameters) for parameters in (CRANK_MM, ROD_MM)]
    return [*lengths, *(pba.I(*interval) for interval in BOX)]


def read(box) -> Bounds:
    """The six statistics of a probability box, whose sides are quantiles at even levels."""
    low, high = np.asarray(box.left), np.asarray(box.right)
    deviations = [float(np.sqrt(max(0.0, end))) for end in (box.var.lo, box.var.hi)]
    bounds = {"mean": (float(box.mean.lo), float(box.mean.hi)), "deviation": (deviations[0], deviations[1])}
    for level in QUANTILES:
        cut = box.alpha_cut(level)
        bounds[f"quantile {level}"] = (float(cut.lo), float(cut.hi))
    for limit_mm in LIMITS_MM:
        least = (low > limit_mm).mean() + (high < -limit_mm).mean()
        most = ((high > limit_mm) | (low < -limit_mm)).mean()
        bounds[f"beyond {limit_mm:.2f}"] = (float(least), float(most))
    return bounds


def corners(seed: int) -> tuple[Bounds, int]:
    """400 samples, the corners of the box at each."""
    response = Response()
    box = interval_monte_carlo(inputs(), response.rows, "endpoints", n_sam=400, random_state=seed)
    return read(box), response.evaluations


def subintervals(seed: int) -> tuple[Bounds, int]:
    """40 samples, the corners of 256 parts of the box at each."""
    response = Response()
    box = interval_monte_carlo(
        inputs(), response.rows, "subinterval", n_sam=40, random_state=seed, n_sub=4, subinterval_style="endpoints"
    )
    return read(box), response.evaluations


def arithmetic(seed: int) -> tuple[Bounds, int]:
    """400 samples, y in interval arithmetic at each."""
    evaluations = 0

    def response(quantities: list):
        nonlocal evaluations
        evaluations += 1
        crank_mm, rod_mm, clearance_mm, direction_rad = quantities
        height_mm = crank_mm * SINE + clearance_mm * np.sin(direction_rad)
        foot_mm = np.sqrt(rod_mm**2 - height_mm**2)
        return crank_mm * COSINE + foot_mm + clearance_mm * np.cos(direction_rad) - NOMINAL_MM

    box = interval_monte_carlo(inputs(), response, "direct", n_sam=400, random_state=seed)
    return read(box), evaluations


if __name__ == "__main__":
    methods = [
        ("interval_monte_carlo, corners", corners),
        ("interval_monte_carlo, corners of subintervals", subintervals),
        ("interval_monte_carlo, interval arithmetic", arithmetic),
    ]
    conduct(methods[:2] if IS_ROUGH else methods)

"""The slider-crank with play at 60 degrees, the same for every program, and its exact bounds.

`y = r cos t + sqrt(l^2 - (r sin t + c sin p)^2) + c cos p - y0` in mm: r and l are normal, the clearance c and its direction p
lie in intervals and are not random. Called as a program it prints the exact bounds as JSON.
"""

import json
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import numpy as np

CRANK_ANGLE_RAD = np.pi / 3
CRANK_MM = (50.0, 0.02)  # mean, standard deviation
ROD_MM = (120.0, 0.03)
CLEARANCE_MM = (0.1, 0.5)
DIRECTION_RAD = (0.0, 2.0 * np.pi)
BOX = np.array([CLEARANCE_MM, DIRECTION_RAD])

QUANTILES = (0.025, 0.975)
LIMITS_MM = (0.45, 0.60)
STATISTICS = ("mean", "deviation", "quantile 0.025", "quantile 0.975", "beyond 0.45", "beyond 0.60")

SINE, COSINE = np.sin(CRANK_ANGLE_RAD), np.cos(CRANK_ANGLE_RAD)
NOMINAL_MM = CRANK_MM[0] * COSINE + np.sqrt(ROD_MM[0] ** 2 - (CRANK_MM[0] * SINE) ** 2)

Bounds = dict[str, tuple[float, float]]


def deviation_mm(crank_mm, rod_mm, clearance_mm, direction_rad):
    """The response y, of numbers or arrays."""
    height_mm = crank_mm * SINE + clearance_mm * np.sin(direction_rad)
    return crank_mm * COSINE + np.sqrt(rod_mm**2 - height_mm**2) + clearance_mm * np.cos(direction_rad) - NOMINAL_MM


class Response:
    """The response, with a count of how often a program asked for it."""

    def __init__(self) -> None:
        self.evaluations = 0

    def __call__(self, crank_mm, rod_mm, clearance_mm, direction_rad):
        value_mm = deviation_mm(crank_mm, rod_mm, clearance_mm, direction_rad)
        self.evaluations += np.size(value_mm)
        return value_mm

    def rows(self, table: np.ndarray) -> np.ndarray:
        """The response of each row (r, l, c, p)."""
        return self(*np.asarray(table, dtype=float).T)


def statistics_of(sample: np.ndarray) -> np.ndarray:
    """The six statistics of samples, which lie along the last axis."""
    sample = np.asarray(sample, dtype=float)
    return np.stack(
        [
            sample.mean(axis=-1),
            sample.std(axis=-1, ddof=1),
            *(np.quantile(sample, share, axis=-1) for share in QUANTILES),
            *((np.abs(sample) > limit_mm).mean(axis=-1) for limit_mm in LIMITS_MM),
        ],
        axis=-1,
    )


def envelope(rows: np.ndarray) -> Bounds:
    """Least and greatest of each statistic over rows of them."""
    rows = np.asarray(rows)
    return {
        name: (float(rows[:, column].min()), float(rows[:, column].max())) for column, name in enumerate(STATISTICS)
    }


def scaled(unit: np.ndarray) -> np.ndarray:
    """Points of the unit square as (c, p)."""
    return BOX[:, 0] + np.asarray(unit) * (BOX[:, 1] - BOX[:, 0])


# What a program prints


@contextmanager
def timed() -> Iterator[Callable[[], float]]:
    """Seconds of this process since the start of the block."""
    started_s = time.process_time()
    yield lambda: time.process_time() - started_s


Method = tuple[str, Callable[[int], tuple[Bounds, int]]]


def conduct(methods: list[Method]) -> None:
    """Each method over the seeds named on the command line; one line of JSON for each."""
    for name, method in methods:
        for seed in range(1, int(sys.argv[1]) + 1):
            with timed() as seconds:
                bounds, evaluations = method(seed)
                told = {"method": name, "seed": seed, "evaluations": evaluations, "seconds": seconds(), "bounds": bounds}
            print(json.dumps(told), flush=True)


# Exact bounds

NODES, WEIGHTS = np.polynomial.hermite_e.hermegauss(40)
WEIGHTS = WEIGHTS / WEIGHTS.sum()


def exact_statistics(points: np.ndarray) -> np.ndarray:
    """The six statistics at each row (c, p): Gauss-Hermite in both lengths, or in the crank with the normal distribution of the
    rod, of which y is a rising function."""
    from scipy.special import ndtr

    clearance_mm, direction_rad = points[:, 0, None], points[:, 1, None]
    crank_mm = CRANK_MM[0] + CRANK_MM[1] * NODES
    rod_mm = ROD_MM[0] + ROD_MM[1] * NODES
    values = deviation_mm(crank_mm[:, None], rod_mm, clearance_mm[..., None], direction_rad[..., None])
    mean = np.einsum("uij,i,j->u", values, WEIGHTS, WEIGHTS)
    variance = np.einsum("uij,i,j->u", (values - mean[:, None, None]) ** 2, WEIGHTS, WEIGHTS)

    def share(level_mm: np.ndarray, sign: float) -> np.ndarray:
        foot_mm = level_mm[:, None] + NOMINAL_MM - crank_mm * COSINE - clearance_mm * np.cos(direction_rad)
        rod_at_level_mm = np.hypot(foot_mm, crank_mm * SINE + clearance_mm * np.sin(direction_rad))
        return ndtr(sign * (rod_at_level_mm - ROD_MM[0]) / ROD_MM[1]) @ WEIGHTS

    below, above = (lambda level_mm: share(level_mm, 1.0)), (lambda level_mm: share(level_mm, -1.0))

    def quantile(probability: float) -> np.ndarray:
        low, high = mean - 1.0, mean + 1.0
        for _ in range(60):
            middle = 0.5 * (low + high)
            too_low = below(middle) < probability
            low, high = np.where(too_low, middle, low), np.where(too_low, high, middle)
        return 0.5 * (low + high)

    beyond = [above(np.full_like(mean, limit)) + below(np.full_like(mean, -limit)) for limit in LIMITS_MM]
    return np.stack([mean, np.sqrt(variance), *map(quantile, QUANTILES), *beyond], axis=-1)


def exact_bounds() -> Bounds:
    """A grid over the box, then ever smaller grids around each extreme."""
    unit = np.stack(np.meshgrid(np.linspace(0, 1, 9), np.linspace(0, 1, 121), indexing="ij"), axis=-1).reshape(-1, 2)
    coarse = exact_statistics(scaled(unit))
    step = np.stack(np.meshgrid(np.linspace(-1, 1, 5), np.linspace(-1, 1, 5), indexing="ij"), axis=-1).reshape(-1, 2)

    def extreme(column: int, sign: float) -> float:
        best = (sign * coarse[:, column]).max()
        centre = unit[(sign * coarse[:, column]).argmax()]
        reach = np.array([0.125, 1 / 120])
        for _ in range(28):
            around = np.clip(centre + reach * step, 0.0, 1.0)
            values = sign * exact_statistics(scaled(around))[:, column]
            if values.max() > best:
                best, centre = values.max(), around[values.argmax()]
            reach = 0.5 * reach
        return float(sign * best)

    return {name: (extreme(column, -1.0), extreme(column, 1.0)) for column, name in enumerate(STATISTICS)}


if __name__ == "__main__":
    print(json.dumps(exact_bounds()))

"""The slider-crank with play at 60 degrees, the same for every program, and its exact bounds.

`y = r cos t + sqrt(l^2 - (r sin t + c sin p)^2) + c cos p - y0` in mm: r and l are normal, the clearance c and its direction p
lie in intervals and are not random. Called as a program it prints the exact bounds as JSON.

With `rough` behind the other arguments, y is rough over the box and chaotic in the lengths: each of 60 x 60 cells of (c, p) adds a
normal number of its own, and each evaluation another one.
"""

import json
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import numpy as np
from scipy.special import ndtr, ndtri

CRANK_ANGLE_RAD = np.pi / 3
CRANK_MM = (50.0, 0.02)  # mean, standard deviation
ROD_MM = (120.0, 0.03)
CLEARANCE_MM = (0.1, 0.5)
DIRECTION_RAD = (0.0, 2.0 * np.pi)
BOX = np.array([CLEARANCE_MM, DIRECTION_RAD])

QUANTILES = (0.025, 0.975)
LIMITS_MM = (0.45, 0.60)
STATISTICS = ("mean", "deviation", "quantile 0.025", "quantile 0.975", "beyond 0.45", "beyond 0.60")

IS_ROUGH = "rough" in sys.argv[1:]
CELLS = 60  # along each side of the box
ROUGHNESS_MM = 0.07  # standard deviation of what the cells add
NOISE_MM = 0.03  # of what each evaluation adds

SINE, COSINE = np.sin(CRANK_ANGLE_RAD), np.cos(CRANK_ANGLE_RAD)
NOMINAL_MM = CRANK_MM[0] * COSINE + np.sqrt(ROD_MM[0] ** 2 - (CRANK_MM[0] * SINE) ** 2)

Bounds = dict[str, tuple[float, float]]


def deviation_mm(crank_mm, rod_mm, clearance_mm, direction_rad):
    """The response y, of numbers or arrays."""
    height_mm = crank_mm * SINE + clearance_mm * np.sin(direction_rad)
    return crank_mm * COSINE + np.sqrt(rod_mm**2 - height_mm**2) + clearance_mm * np.cos(direction_rad) - NOMINAL_MM


def hashed(key: np.ndarray, counter: np.ndarray) -> np.ndarray:
    """64 bits of a key and a counter, the same as `loosepin::uncertainty::hash`: SplitMix64."""

    def mix(bits: np.ndarray) -> np.ndarray:
        bits = (bits ^ (bits >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
        bits = (bits ^ (bits >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
        return bits ^ (bits >> np.uint64(31))

    golden = np.uint64(0x9E3779B97F4A7C15)
    return mix(mix(np.atleast_1d(key) + golden) + np.atleast_1d(counter) * golden)


def normal_number(bits: np.ndarray) -> np.ndarray:
    """A standard normal number of 64 bits."""
    return ndtri(((bits >> np.uint64(11)).astype(float) + 0.5) / 2.0**53)


def cell_offset_mm(row: np.ndarray, column: np.ndarray) -> np.ndarray:
    """What a cell adds: `row` counts along the clearance, `column` along the direction."""
    place = np.asarray(row, dtype=np.uint64) * np.uint64(CELLS) + np.asarray(column, dtype=np.uint64)
    return ROUGHNESS_MM * normal_number(hashed(np.zeros(1, dtype=np.uint64), place))


def rough_part_mm(crank_mm, rod_mm, clearance_mm, direction_rad):
    """What the cell adds, and what this evaluation adds."""
    inputs = np.broadcast_arrays(crank_mm, rod_mm, clearance_mm, direction_rad)
    inputs = [np.atleast_1d(np.ascontiguousarray(one, dtype=float)) for one in inputs]
    shares = [(one - low) / (high - low) for one, (low, high) in zip(inputs[2:], BOX, strict=True)]
    cell = [np.clip(np.floor(CELLS * share), 0, CELLS - 1).astype(np.uint64) for share in shares]
    bits = [one.view(np.uint64) for one in inputs]
    own = hashed(hashed(hashed(bits[0], bits[1]), bits[2]), bits[3])
    added = cell_offset_mm(*cell) + NOISE_MM * normal_number(own)
    return added.reshape(np.broadcast(crank_mm, rod_mm, clearance_mm, direction_rad).shape)


class Response:
    """The response, with a count of how often a program asked for it."""

    def __init__(self) -> None:
        self.evaluations = 0

    def __call__(self, crank_mm, rod_mm, clearance_mm, direction_rad):
        value_mm = deviation_mm(crank_mm, rod_mm, clearance_mm, direction_rad)
        if IS_ROUGH:
            value_mm = value_mm + rough_part_mm(crank_mm, rod_mm, clearance_mm, direction_rad)
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


def rough_statistics(points: np.ndarray, offsets_mm: np.ndarray) -> np.ndarray:
    """The six statistics at each row (c, p) where its cell adds an offset: Gauss-Hermite in both lengths, and the normal distribution
    of what each evaluation adds."""
    clearance_mm, direction_rad = points[:, 0, None, None], points[:, 1, None, None]
    crank_mm, rod_mm = CRANK_MM[0] + CRANK_MM[1] * NODES, ROD_MM[0] + ROD_MM[1] * NODES
    values = deviation_mm(crank_mm[:, None], rod_mm, clearance_mm, direction_rad).reshape(len(points), -1)
    weights = np.outer(WEIGHTS, WEIGHTS).ravel()
    mean = values @ weights
    variance = (values - mean[:, None]) ** 2 @ weights + NOISE_MM**2

    def below(level_mm: np.ndarray) -> np.ndarray:
        return ndtr((level_mm[:, None] - values) / NOISE_MM) @ weights

    def quantile(probability: float) -> np.ndarray:
        low, high = mean - 0.5, mean + 0.5
        for _ in range(40):
            middle = 0.5 * (low + high)
            too_low = below(middle) < probability
            low, high = np.where(too_low, middle, low), np.where(too_low, high, middle)
        return 0.5 * (low + high) + offsets_mm

    beyond = [1.0 - below(limit - offsets_mm) + below(-limit - offsets_mm) for limit in LIMITS_MM]
    return np.stack([mean + offsets_mm, np.sqrt(variance), *map(quantile, QUANTILES), *beyond], axis=-1)


def rough_bounds() -> Bounds:
    """Each statistic at the corners of all cells; then ever smaller grids in the cells with the furthest corners. Within a cell the
    statistics are smooth, and change by less than the best cells differ."""
    cells = np.stack(np.meshgrid(np.arange(CELLS), np.arange(CELLS), indexing="ij"), axis=-1).reshape(-1, 2)
    offsets_mm = cell_offset_mm(cells[:, 0], cells[:, 1])
    corners = np.array([[0, 0], [0, 1], [1, 0], [1, 1]])
    coarse = [
        rough_statistics(scaled((part[:, None] + corners).reshape(-1, 2) / CELLS), np.repeat(offset_mm, 4))
        for part, offset_mm in zip(np.array_split(cells, 90), np.array_split(offsets_mm, 90), strict=True)
    ]
    coarse = np.concatenate(coarse).reshape(len(cells), 4, len(STATISTICS))
    step = np.stack(np.meshgrid(np.linspace(-1, 1, 5), np.linspace(-1, 1, 5), indexing="ij"), axis=-1).reshape(-1, 2)

    def extreme(column: int, sign: float) -> float:
        best_of_cells = (sign * coarse[..., column]).max(axis=1)
        best = best_of_cells.max()
        for cell in np.argsort(best_of_cells)[-5:]:
            low, high = cells[cell] / CELLS, (cells[cell] + 1) / CELLS
            centre, reach = 0.5 * (low + high), 0.5 / CELLS
            for _ in range(14):
                around = np.clip(centre + reach * step, low, high)
                values = sign * rough_statistics(scaled(around), np.full(len(around), offsets_mm[cell]))[:, column]
                centre, best = around[values.argmax()], max(best, values.max())
                reach = 0.5 * reach
        return float(sign * best)

    return {name: (extreme(column, -1.0), extreme(column, 1.0)) for column, name in enumerate(STATISTICS)}


if __name__ == "__main__":
    print(json.dumps(rough_bounds() if IS_ROUGH else exact_bounds()))

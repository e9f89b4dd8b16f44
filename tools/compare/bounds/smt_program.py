"""SMT: Kriging of the response over all four inputs with a sample in a sample on it; Kriging of the statistics over the two
intervals; and its efficient global optimisation around a sample. SMT has no distributions and no bounds of its own."""

import numpy as np
from problem import BOX, CRANK_MM, ROD_MM, STATISTICS, Bounds, Response, conduct, envelope, scaled, statistics_of
from scipy.stats import norm
from smt.applications import EGO
from smt.sampling_methods import LHS
from smt.surrogate_models import KRG

SPREAD = 4.0  # the surrogate covers the lengths to so many standard deviations


def latin(limits: np.ndarray, size: int, seed: int) -> np.ndarray:
    """SMT's Latin hypercube, with its default criterion."""
    return LHS(xlimits=limits, criterion="c", seed=seed)(size)


def lengths(size: int, seed: int) -> np.ndarray:
    """r and l: a Latin hypercube through the normal distributions."""
    unit = latin(np.array([[0.0, 1.0]] * 2), size, seed)
    return np.array([CRANK_MM[0], ROD_MM[0]]) + norm.ppf(unit) * np.array([CRANK_MM[1], ROD_MM[1]])


def trained(inputs: np.ndarray, outputs: np.ndarray) -> KRG:
    """Kriging with SMT's defaults."""
    surrogate = KRG(print_global=False)
    surrogate.set_training_values(inputs, outputs)
    surrogate.train()
    return surrogate


def kriging_of_response(seed: int) -> tuple[Bounds, int]:
    """150 evaluations; then 300 points of the box and 300 lengths at each on the surrogate."""
    response = Response()
    around = [[mean - SPREAD * spread, mean + SPREAD * spread] for mean, spread in (CRANK_MM, ROD_MM)]
    inputs = latin(np.vstack([around, BOX]), 150, seed)
    surrogate = trained(inputs, response.rows(inputs))
    sample, points = lengths(300, seed + 100), latin(BOX, 300, seed + 200)
    rows = [surrogate.predict_values(np.hstack([sample, np.tile(point, (300, 1))])).ravel() for point in points]
    return envelope(statistics_of(np.array(rows))), response.evaluations


def kriging_of_statistics(seed: int) -> tuple[Bounds, int]:
    """60 points of the box with 200 lengths at each; a Kriging of each statistic, read on a grid."""
    response = Response()
    sample, points = lengths(200, seed + 100), latin(BOX, 60, seed)
    rows = np.array([statistics_of(response(*sample.T, *point)) for point in points])
    across, around = np.meshgrid(np.linspace(0, 1, 21), np.linspace(0, 1, 121), indexing="ij")
    grid = scaled(np.column_stack([across.ravel(), around.ravel()]))
    read = [trained(points, rows[:, column]).predict_values(grid).ravel() for column in range(len(STATISTICS))]
    return envelope(np.column_stack(read)), response.evaluations


def optimised(seed: int) -> tuple[Bounds, int]:
    """EGO with expected improvement for each end of each statistic: 20 points, then four more, 200 lengths at each."""
    response = Response()
    sample = lengths(200, seed + 100)
    start = latin(BOX, 20, seed)
    known = np.array([statistics_of(response(*sample.T, *point)) for point in start])
    bounds = {}
    for column, name in enumerate(STATISTICS):
        ends = []
        for sign in (1.0, -1.0):

            def objective(points: np.ndarray, sign: float = sign, column: int = column) -> np.ndarray:
                rows = [statistics_of(response(*sample.T, *point))[column] for point in points]
                return sign * np.array(rows).reshape(-1, 1)

            surrogate = KRG(design_space=BOX, print_global=False)
            search = EGO(
                n_iter=4, xdoe=start, ydoe=sign * known[:, [column]], surrogate=surrogate, n_start=3, n_max_optim=3, seed=seed
            )
            ends.append(sign * float(np.ravel(search.optimize(fun=objective)[1])[0]))
        bounds[name] = (ends[0], ends[1])
    return bounds, response.evaluations


if __name__ == "__main__":
    conduct(
        [
            ("Kriging of y, then samples on it", kriging_of_response),
            ("Kriging of the statistics over the intervals", kriging_of_statistics),
            ("EGO around a sample (200)", optimised),
        ]
    )

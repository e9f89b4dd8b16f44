"""chaospy: pseudo-spectral polynomial chaos in the two normal inputs at each point of the box, with an outer sample or SciPy's
differential evolution; and one chaos in all four inputs. It has no method of its own for bounds over intervals."""

import chaospy
import numpy as np
from problem import BOX, CRANK_MM, LIMITS_MM, QUANTILES, ROD_MM, STATISTICS, Bounds, Response, conduct, envelope, statistics_of
from scipy.optimize import differential_evolution

RANDOM = chaospy.J(chaospy.Normal(*CRANK_MM), chaospy.Normal(*ROD_MM))
INTERVALS = chaospy.J(*(chaospy.Uniform(*interval) for interval in BOX))
ORDER = 3
NODES, WEIGHTS = chaospy.generate_quadrature(ORDER, RANDOM, rule="gaussian")
EXPANSION = chaospy.generate_expansion(ORDER, RANDOM, normed=True)


def statistics_at(point: np.ndarray, response: Response, terms: np.ndarray) -> np.ndarray:
    """Mean and deviation from the coefficients, the rest from 10,000 values of the expansion, as chaospy has them in `Perc`."""
    _, coefficients = chaospy.fit_quadrature(EXPANSION, NODES, WEIGHTS, response(*NODES, *point), retall=1)
    sample = coefficients @ terms
    beyond = [(np.abs(sample) > limit_mm).mean() for limit_mm in LIMITS_MM]
    deviation = np.sqrt((coefficients[1:] ** 2).sum())
    return np.array([coefficients[0], deviation, *np.quantile(sample, QUANTILES), *beyond])


def sampled(seed: int) -> tuple[Bounds, int]:
    """200 points of the box."""
    response = Response()
    terms = EXPANSION(*RANDOM.sample(10_000, rule="latin_hypercube", seed=seed))
    points = INTERVALS.sample(200, rule="latin_hypercube", seed=1000 + seed)
    return envelope(np.array([statistics_at(point, response, terms) for point in points.T])), response.evaluations


def optimised(seed: int) -> tuple[Bounds, int]:
    """Differential evolution, and what it ends with (L-BFGS-B), for each end of each statistic."""
    response = Response()
    terms = EXPANSION(*RANDOM.sample(10_000, rule="latin_hypercube", seed=seed))
    bounds = {}
    for column, name in enumerate(STATISTICS):
        ends = []
        for sign in (1.0, -1.0):
            found = differential_evolution(
                lambda point, sign=sign, column=column: sign * statistics_at(point, response, terms)[column],
                BOX,
                popsize=8,
                maxiter=8,
                rng=seed,
            )
            ends.append(sign * float(found.fun))
        bounds[name] = (ends[0], ends[1])
    return bounds, response.evaluations


def regression(seed: int) -> tuple[Bounds, int]:
    """A chaos of order 6 in all four inputs by least squares from 500 runs, the intervals taken as uniform while it is fitted; then
    400 points of the box and 500 lengths at each on it."""
    response = Response()
    everything = chaospy.J(*RANDOM, *INTERVALS)
    inputs = everything.sample(500, rule="latin_hypercube", seed=seed)
    model = chaospy.fit_regression(chaospy.generate_expansion(6, everything), inputs, response(*inputs))
    lengths = RANDOM.sample(500, rule="latin_hypercube", seed=1000 + seed)
    points = INTERVALS.sample(400, rule="latin_hypercube", seed=2000 + seed)
    across = [np.repeat(values[None, :], 400, axis=0) for values in lengths]
    down = [np.repeat(values[:, None], 500, axis=1) for values in points]
    rows = model(*across, *down)
    return envelope(statistics_of(rows)), response.evaluations


if __name__ == "__main__":
    conduct(
        [
            ("sample (200) around polynomial chaos", sampled),
            ("polynomial chaos of y, then samples on it", regression),
            ("differential evolution of SciPy around polynomial chaos", optimised),
        ]
    )

"""OpenTURNS: a sample in a sample, an optimiser around a sample, and the metamodels of its manual with a sample in a sample on
them. It has no method of its own for bounds over intervals; these are its building blocks as their examples use them."""

import numpy as np
import openturns as ot
from problem import BOX, CRANK_MM, LIMITS_MM, QUANTILES, ROD_MM, STATISTICS, Bounds, Response, conduct, envelope, statistics_of

RANDOM = ot.JointDistribution([ot.Normal(*CRANK_MM), ot.Normal(*ROD_MM)])
INTERVALS = ot.JointDistribution([ot.Uniform(*interval) for interval in BOX])
ALL = ot.JointDistribution([ot.Normal(*CRANK_MM), ot.Normal(*ROD_MM), *(ot.Uniform(*interval) for interval in BOX)])


def latin(distribution: ot.Distribution, size: int) -> np.ndarray:
    """A Latin hypercube sample."""
    return np.array(ot.LHSExperiment(distribution, size).generate())


def sample_statistics(sample: np.ndarray) -> list[float]:
    """The six statistics as `ot.Sample` computes them."""
    values = ot.Sample(np.asarray(sample).reshape(-1, 1))
    # Below -limit and above +limit.
    beyond = [
        values.computeEmpiricalCDF([-limit_mm]) + values.computeEmpiricalCDF([limit_mm], True) for limit_mm in LIMITS_MM
    ]
    quantiles = [values.computeQuantile(share)[0] for share in QUANTILES]
    return [values.computeMean()[0], values.computeStandardDeviation()[0], *quantiles, *beyond]


def nested(seed: int) -> tuple[Bounds, int]:
    """100 points of the box, 200 lengths at each."""
    ot.RandomGenerator.SetSeed(seed)
    response = Response()
    lengths = latin(RANDOM, 200)
    rows = [sample_statistics(response(*lengths.T, *point)) for point in latin(INTERVALS, 100)]
    return envelope(np.array(rows)), response.evaluations


def optimised(seed: int) -> tuple[Bounds, int]:
    """`MultiStart` of `Cobyla`, five starts for each end of each statistic, around 200 lengths that stay the same."""
    ot.RandomGenerator.SetSeed(seed)
    response = Response()
    lengths = latin(RANDOM, 200)
    known: dict[tuple, list[float]] = {}

    def statistics(point: ot.Point) -> list[float]:
        key = tuple(point)
        if key not in known:
            known[key] = sample_statistics(response(*lengths.T, *point))
        return known[key]

    starts = ot.LHSExperiment(INTERVALS, 5).generate()
    bounds = {}
    for column, name in enumerate(STATISTICS):
        objective = ot.PythonFunction(2, 1, lambda point, column=column: [statistics(point)[column]])
        ends = []
        for minimise in (True, False):
            problem = ot.OptimizationProblem(objective)
            problem.setBounds(ot.Interval(*BOX.T.tolist()))
            problem.setMinimization(minimise)
            solver = ot.Cobyla(problem)
            solver.setMaximumCallsNumber(60)
            solver.setCheckStatus(False)
            search = ot.MultiStart(solver, starts)
            search.setMaximumCallsNumber(300)
            search.run()
            ends.append(search.getResult().getOptimalValue()[0])
        bounds[name] = (ends[0], ends[1])
    return bounds, response.evaluations


def on_metamodel(metamodel: ot.Function, evaluations: int) -> tuple[Bounds, int]:
    """A sample in a sample on a metamodel: 400 points of the box, 500 lengths at each."""
    lengths, points = latin(RANDOM, 500), latin(INTERVALS, 400)
    rows = []
    for point in points:
        table = np.hstack([lengths, np.tile(point, (len(lengths), 1))])
        rows.append(np.array(metamodel(table)).ravel())
    return envelope(statistics_of(np.array(rows))), evaluations


def kriging(seed: int) -> tuple[Bounds, int]:
    """Gaussian process regression of y over all four inputs."""
    ot.RandomGenerator.SetSeed(seed)
    response = Response()
    inputs = latin(ALL, 150)
    # The lengths vary by hundredths: the regression sees all inputs in the same size.
    centre, size = inputs.mean(axis=0), inputs.std(axis=0)
    scaling = ot.LinearFunction(centre, [0.0] * 4, ot.Matrix(np.diag(1.0 / size)))
    outputs = response.rows(inputs).reshape(-1, 1)
    covariance = ot.MaternModel([1.0] * 4, 2.5)
    fitter = ot.GaussianProcessFitter(scaling(inputs), outputs, covariance, ot.ConstantBasisFactory(4).build())
    fitter.run()
    regression = ot.GaussianProcessRegression(fitter.getResult())
    regression.run()
    return on_metamodel(ot.ComposedFunction(regression.getResult().getMetaModel(), scaling), response.evaluations)


def chaos(seed: int) -> tuple[Bounds, int]:
    """`LeastSquaresExpansion` of y over all four inputs, the intervals taken as uniform while it is fitted."""
    ot.RandomGenerator.SetSeed(seed)
    response = Response()
    inputs = latin(ALL, 500)
    outputs = response.rows(inputs).reshape(-1, 1)
    basis = ot.OrthogonalProductPolynomialFactory([ALL.getMarginal(index) for index in range(4)])
    selection = ot.LeastSquaresMetaModelSelectionFactory(ot.LARS(), ot.CorrectedLeaveOneOut())
    strategy = ot.LeastSquaresStrategy(selection)
    size = basis.getEnumerateFunction().getBasisSizeFromTotalDegree(6)
    algorithm = ot.FunctionalChaosAlgorithm(inputs, outputs, ALL, ot.FixedStrategy(basis, size), strategy)
    algorithm.run()
    return on_metamodel(algorithm.getResult().getMetaModel(), response.evaluations)


if __name__ == "__main__":
    conduct(
        [
            ("sample (100) of samples (200)", nested),
            ("MultiStart of Cobyla around a sample (200)", optimised),
            ("Kriging of y, then samples on it", kriging),
            ("polynomial chaos of y, then samples on it", chaos),
        ]
    )

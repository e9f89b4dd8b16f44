"""Fits one package to the designs that our program wrote, and prints its Q² at the test points.

    python peers.py PROGRAM CASE INPUTS RUNS DESIGNS FOLDER

All packages get inputs scaled to [-1, 1] and outputs scaled to mean 0 and deviation 1; curves are reduced to as few principal
components as leave 1e-5 of the variance, at most 20, as in our own program.
"""

import json
import sys
import time
import warnings
from pathlib import Path

import numpy as np

LEFT_SHARE = 1e-5
MOST_MODES = 20
STARTS = 5


def sklearn_mlp(x, y, where):
    """The best of five starts and three sizes, by an inner split."""
    from sklearn.neural_network import MLPRegressor

    order = np.random.default_rng(1).permutation(len(x))
    held, kept = order[: len(x) // 5], order[len(x) // 5 :]
    best = None
    for size in (6, 12, 24):
        for start in range(STARTS):
            net = MLPRegressor(hidden_layer_sizes=(size,), activation="tanh", solver="lbfgs", alpha=1e-3, max_iter=3000, random_state=start)
            net.fit(x[kept], y[kept])
            error = np.mean((net.predict(x[held]) - y[held]) ** 2)
            if best is None or error < best[0]:
                best = (error, size, start)
    net = MLPRegressor(hidden_layer_sizes=(best[1],), activation="tanh", solver="lbfgs", alpha=1e-3, max_iter=3000, random_state=best[2])
    return net.fit(x, y).predict(where)


def smt_kriging(x, y, where):
    """KRG with Matérn 5/2 and its defaults."""
    from smt.surrogate_models import KRG

    model = KRG(print_global=False, corr="matern52")
    model.set_training_values(x, y[:, None])
    model.train()
    return model.predict_values(where)[:, 0]


def egobox_kriging(x, y, where):
    """Gpx with Matérn 5/2."""
    import egobox as egx

    model = egx.Gpx.builder(corr_spec=egx.CorrelationSpec.MATERN52, regr_spec=egx.RegressionSpec.CONSTANT)
    return np.asarray(model.fit(x, y[:, None]).predict(where)).reshape(-1)


def openturns_chaos(x, y, where):
    """Functional chaos by least-angle regression with corrected leave-one-out, hyperbolic enumeration."""
    import openturns as ot

    inputs = x.shape[1]
    law = ot.JointDistribution([ot.Uniform(-1, 1)] * inputs)
    enumerate_ = ot.HyperbolicAnisotropicEnumerateFunction(inputs, 0.75)
    basis = ot.OrthogonalProductPolynomialFactory([ot.LegendreFactory()] * inputs, enumerate_)
    degree = 10 if inputs < 10 else 3
    size = enumerate_.getBasisSizeFromTotalDegree(degree)
    strategy = ot.FixedStrategy(basis, size)
    selection = ot.LeastSquaresMetaModelSelectionFactory(ot.LARS(), ot.CorrectedLeaveOneOut())
    projection = ot.LeastSquaresStrategy(selection)
    algorithm = ot.FunctionalChaosAlgorithm(ot.Sample(x), ot.Sample(y[:, None]), law, strategy, projection)
    algorithm.run()
    return np.asarray(algorithm.getResult().getMetaModel()(ot.Sample(where)))[:, 0]


def chaospy_chaos(x, y, where):
    """Legendre expansion fitted by scikit-learn's least-angle lasso with cross-validation."""
    import chaospy
    from sklearn.linear_model import LassoLarsCV

    inputs = x.shape[1]
    law = chaospy.Iid(chaospy.Uniform(-1, 1), inputs)
    degree = 8 if inputs < 10 else 2
    expansion = chaospy.generate_expansion(degree, law, cross_truncation=1.0, normed=True)
    model = LassoLarsCV(fit_intercept=False, max_iter=500)
    return chaospy.fit_regression(expansion, x.T, y, model=model)(*where.T)


PROGRAMS = {
    "sklearn-mlp": sklearn_mlp,
    "smt-kriging": smt_kriging,
    "egobox-kriging": egobox_kriging,
    "openturns-chaos": openturns_chaos,
    "chaospy-chaos": chaospy_chaos,
}


def predict(program, x, curves, where):
    """All outputs at `where`, each mode of a curve by itself."""
    if curves.shape[1] == 1:
        mean, shapes = np.zeros(1), np.ones((1, 1))
    else:
        mean = curves.mean(axis=0)
        _, sizes, shapes = np.linalg.svd(curves - mean, full_matrices=False)
        left = 1 - np.cumsum(sizes**2) / np.sum(sizes**2)
        shapes = shapes[: min(MOST_MODES, int(np.argmax(left <= LEFT_SHARE)) + 1)]
    scores = (curves - mean) @ shapes.T
    answers = []
    for score in scores.T:
        middle, deviation = score.mean(), score.std()
        answers.append(middle + deviation * program(x, (score - middle) / deviation, where))
    return mean + np.stack(answers, axis=1) @ shapes


def main():
    name, case, inputs, runs, designs, folder = sys.argv[1:]
    inputs = int(inputs)
    warnings.simplefilter("ignore")
    test = np.loadtxt(Path(folder) / f"{case}-test.csv", delimiter=",", ndmin=2)
    nominal = (0.4, 0.3, 0.2, 0.1, 30, 22, 18, 14, 10, 6, 0.5, 0.35, 0.2, 0.15, 0.05, 0.3, 1.1, 2.1, 7.0, 0.4)
    middle, half = (0.0, np.pi) if case == "ishigami" else (np.array(nominal), 0.25 * np.array(nominal))
    truth = test[:, inputs:]
    for design in range(int(designs)):
        table = np.loadtxt(Path(folder) / f"{case}-{runs}-{design}.csv", delimiter=",", ndmin=2)
        x, where = (table[:, :inputs] - middle) / half, (test[:, :inputs] - middle) / half
        begin = time.perf_counter()
        values = predict(PROGRAMS[name], x, table[:, inputs:], where)
        seconds = time.perf_counter() - begin
        q2 = 1 - np.sum((values - truth) ** 2) / np.sum((truth - truth.mean(axis=0)) ** 2)
        row = {"case": case, "runs": int(runs), "design": design, "program": name, "q2": float(q2), "seconds": seconds}
        print(json.dumps(row), flush=True)


if __name__ == "__main__":
    main()

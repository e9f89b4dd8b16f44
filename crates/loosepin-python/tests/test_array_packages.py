"""Packages that choose inputs and take arrays: each needs ten lines, and agrees with what a study says itself.

Expected numbers come from the bounds of a study, from the package's own error, or from the value that made the data.
"""

import emcee
import loosepin as lp
import numpy as np
import openturns
import pytest
from conftest import MODEL, RANDOM_STUDY
from SALib.analyze import sobol as sobol_indices
from SALib.sample import sobol as sobol_sample
from scipy.stats import qmc
from sklearn.gaussian_process import GaussianProcessRegressor
from sklearn.gaussian_process.kernels import RBF, ConstantKernel
from sklearn.preprocessing import StandardScaler

LARGEST = "slider total maximum_absolute"
CLEARANCE = "joint.gudgeon.radial_clearance"
# A tenth of a turn from the start: milliseconds.
SHORT = {"turns": 0.1, "transient": 0, "samples": 10, "tolerance": "1e-6 m", "progress": False}


@pytest.fixture(scope="module")
def study():
    """Two lengths that scatter, nothing unknown."""
    return lp.Study.from_text(RANDOM_STUDY.replace("inner = 8", "inner = 256"), lp.Model.load(MODEL))


@pytest.fixture(scope="module")
def result(study):
    return study.run(progress=False)


@pytest.fixture(scope="module")
def mean(result):
    """The mean of the largest deviation with its numerical error, m."""
    values = result.samples[LARGEST][result.samples["purpose"] == "mixed"]
    return values.mean(), values.std() / np.sqrt(len(values)), values.std()


def test_peer_salib_finds_the_indices_of_the_study(study, result):
    names = [each.name for each in study.inputs]
    problem = {"num_vars": len(names), "names": names, "bounds": [[0, 1]] * len(names)}
    points = sobol_sample.sample(problem, 256, calc_second_order=False, seed=1)
    found = study.evaluate(study.design(points), progress=False)
    indices = sobol_indices.analyze(problem, found[LARGEST], calc_second_order=False, seed=1)
    # Both sides state errors of 95 %: together they are far enough apart once in hundreds of designs.
    of_study = {each["paths"][0]: each for each in result.summary["contributors"][0]["random"]}
    for place, name in enumerate(names):
        for own, word in (("first", "S1"), ("total", "ST")):
            error = of_study[name][own]["error"] + indices[f"{word}_conf"][place]
            assert abs(of_study[name][own]["centre"] - indices[word][place]) < error, (name, word)


def test_peer_scipy_designs_give_the_mean_of_the_study(study, mean):
    points = qmc.LatinHypercube(d=2, seed=1).random(128)
    found = study.evaluate(study.design(points), progress=False)
    # A Latin hypercube errs less than a sample of the same size, which this allows three times.
    allowed = 3 * (mean[1] + mean[2] / np.sqrt(128))
    assert abs(found[LARGEST].mean() - mean[0]) < allowed


def test_scikit_learn_learns_the_deviation(study):
    design = study.design(qmc.Sobol(d=2, seed=1).random(64))
    values = study.evaluate(design, progress=False)[LARGEST]
    inputs, outputs = StandardScaler().fit(design[:48]), StandardScaler().fit(values[:48, None])
    kernel = ConstantKernel(1.0, (1e-2, 1e8)) * RBF([1.0, 1.0])
    process = GaussianProcessRegressor(kernel, alpha=1e-6).fit(inputs.transform(design[:48]), outputs.transform(values[:48, None])[:, 0])
    predicted = outputs.inverse_transform(process.predict(inputs.transform(design[48:]))[:, None])[:, 0]
    # The largest of several values has kinks: a fifth of the scatter is what is left.
    assert np.sqrt(np.mean((predicted - values[48:]) ** 2)) < 0.2 * values.std()


def test_emcee_finds_the_clearance_that_made_the_data():
    model, true_m, noise_m = lp.Model.load(MODEL), 2.5e-4, 5e-6
    curve = model.evaluate({CLEARANCE: true_m}, "slider value", **SHORT)["slider value"][0]
    data = curve + np.random.default_rng(1).normal(0, noise_m, len(curve))

    def log_probability(theta):
        inside = (theta[:, 0] > 1e-4) & (theta[:, 0] < 5e-4)
        run = model.evaluate({CLEARANCE: np.where(inside, theta[:, 0], true_m)}, "slider value", **SHORT)
        misfit = -0.5 * np.sum(((run["slider value"] - data) / noise_m) ** 2, axis=1)
        return np.where(inside & ~run.failed, misfit, -np.inf)

    sampler = emcee.EnsembleSampler(8, 1, log_probability, vectorize=True)
    sampler.random_state = np.random.RandomState(1).get_state()
    sampler.run_mcmc(np.linspace(2e-4, 3e-4, 8)[:, None], 60)
    chain = sampler.get_chain(discard=20, flat=True)
    assert abs(chain.mean() - true_m) < 4 * chain.std() and chain.std() < 1e-4


def test_peer_openturns_gives_the_mean_and_scatter_of_the_study(study, mean):
    def largest(rows):
        return study.evaluate(np.array(rows), progress=False)[LARGEST][:, None]

    function = openturns.PythonFunction(2, 1, func_sample=largest)
    lengths = openturns.JointDistribution([openturns.Normal(0.05, 2e-5), openturns.Normal(0.12, 3e-5)])
    design = openturns.LowDiscrepancyExperiment(openturns.SobolSequence(), lengths, 128).generate()
    values = function(design)
    # Within three errors of a sample of as many runs, although such points err less.
    assert abs(values.computeMean()[0] - mean[0]) < 3 * (mean[1] + mean[2] / np.sqrt(128))
    assert values.computeStandardDeviation()[0] == pytest.approx(mean[2], rel=0.3)

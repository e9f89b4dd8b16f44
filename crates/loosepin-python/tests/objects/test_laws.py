"""Laws as functions, laws of SciPy as inputs, and seeds."""

import math
import subprocess
import sys
import tomllib

import loosepin as lp
import numpy as np
import pytest
from conftest import STUDY, write_study
from scipy import stats

LOG = math.sqrt(math.log(1 + (0.5 / 3) ** 2))
# A law of ours, and the same one by the formulas of SciPy.
PAIRS = {
    "normal": (lp.Normal(3, 0.5), stats.norm(3, 0.5)),
    "truncated normal": (lp.TruncatedNormal(3, 0.5, 2.2, 4.5), stats.truncnorm(-1.6, 3, loc=3, scale=0.5)),
    "uniform": (lp.Uniform(1.5, 4), stats.uniform(1.5, 2.5)),
    "lognormal": (lp.Lognormal(3, 0.5), stats.lognorm(LOG, scale=3 * math.exp(-(LOG**2) / 2))),
    "triangular": (lp.Triangular(1, 2.5, 5), stats.triang(0.375, 1, 4)),
    "beta": (lp.Beta(2.5, 3.5, 1, 4), stats.beta(2.5, 3.5, loc=1, scale=3)),
    "Weibull": (lp.Weibull(1.7, 3, 0.4), stats.weibull_min(1.7, loc=0.4, scale=3)),
    "Rayleigh": (lp.Weibull(2, 3 * math.sqrt(2), 0.4), stats.rayleigh(0.4, 3)),
    "gamma": (lp.Gamma(2.3, 0.7, 0.4), stats.gamma(2.3, 0.4, 0.7)),
    "chi square": (lp.Gamma(2.5, 2), stats.chi2(5)),
    "Gumbel": (lp.Gumbel(3, 0.5), stats.gumbel_r(loc=3, scale=0.5)),
    "exponential": (lp.Exponential(3, 0.4), stats.expon(0.4, 2.6)),
}
PROBABILITIES = np.array([[1e-6, 0.01, 0.3], [0.5, 0.97, 1 - 1e-6]])
# Relative; both libraries compute in doubles, by series and iterations of their own.
TOLERANCE = 1e-9


@pytest.mark.parametrize("pair", PAIRS)
def test_peer_ppf_and_cdf_are_those_of_scipy(pair):
    law, of_scipy = PAIRS[pair]
    values = law.ppf(PROBABILITIES)
    assert values.shape == PROBABILITIES.shape
    np.testing.assert_allclose(values, of_scipy.ppf(PROBABILITIES), rtol=TOLERANCE)
    np.testing.assert_allclose(law.cdf(values), PROBABILITIES, rtol=TOLERANCE)
    inside = np.linspace(of_scipy.ppf(0.001), of_scipy.ppf(0.999), 7)
    np.testing.assert_allclose(law.cdf(inside), of_scipy.cdf(inside), rtol=TOLERANCE)
    assert isinstance(law.ppf(0.3), float) and law.ppf(0.3) == values[0, 2]
    assert isinstance(law.cdf(3.1), float) and law.cdf(3.1) == law.cdf([3.1])[0]
    ends = law.ppf([0.0, 1.0, -0.1, 1.1, math.nan])
    np.testing.assert_allclose(ends[:2], of_scipy.support(), rtol=TOLERANCE)
    assert np.isnan(ends[2:]).all() and math.isnan(law.cdf(math.nan))


def test_analytic_steps():
    steps = lp.Discrete([1, 2, 4], [0.2, 0.3, 0.5])
    assert list(steps.cdf([0.9, 1, 1.9, 2, 4])) == pytest.approx([0, 0.2, 0.2, 0.5, 1])
    assert list(steps.ppf([0.1, 0.3, 0.9])) == [1, 2, 4]
    sample = lp.Empirical([4.0, 1.0, 2.0, 7.0])
    assert list(sample.ppf([0.0, 0.2, 0.3, 0.6, 1.0])) == [1, 1, 2, 4, 7]
    assert list(sample.cdf([0.5, 1, 3, 7])) == [0, 0.25, 0.5, 1]


def test_what_has_no_distribution_function():
    with pytest.raises(ValueError, match=r"^mean of Normal is unknown \(epistemic\), so it has no single distribution function; must be a number$"):
        lp.Normal(lp.Interval(1, 2), 1).ppf(0.5)
    with pytest.raises(lp.LoosepinValueError, match="standard deviation"):
        lp.Normal(1, -1).cdf(0.5)
    for wrong, words in (("0.5", "a str"), (None, "a NoneType"), ([True], "an array of bool"), (["x"], "an array of <U1")):
        with pytest.raises(TypeError, match=rf"^q is {words}; must be a number or an array of numbers$"):
            lp.Normal(0, 1).ppf(wrong)


@pytest.mark.parametrize("pair", PAIRS)
def test_identity_bounds_with_a_law_of_scipy_are_those_with_ours(pair):
    ours, theirs = (
        lp.bounds(lambda x, u: x + u, {"x": law, "u": lp.Interval(0, 1)}, ["mean", {"quantile": 0.9}], outer=8, inner=32)
        for law in PAIRS[pair]
    )
    # A parameter may differ in its last bits: mean and deviation of a lognormal go through exp and log.
    np.testing.assert_allclose(theirs.inputs["x"], ours.inputs["x"], rtol=TOLERANCE)
    for one, other in zip(ours.bounds, theirs.bounds):
        assert other.widened == pytest.approx(one.widened, rel=TOLERANCE)


def test_analytic_discrete_laws_of_scipy():
    found = lp.bounds(lambda n: n, {"n": stats.binom(4, 0.3)}, ["mean"])
    assert found.bounds[0].lower.widened <= 1.2 <= found.bounds[0].upper.widened
    assert set(found.inputs["n"][found.purpose == "mixed"]) == {0, 1, 2, 3, 4}


REFUSED = {
    "no counterpart": (stats.t(5), r"^input 'x' is scipy\.stats\.t, which has no exact counterpart; known are beta, .*\nhint: loosepin\.Empirical"),
    "shifted": (stats.lognorm(0.2, loc=1), r"^input 'x' is scipy\.stats\.lognorm with loc, which has no exact"),
    "no end": (stats.poisson(3), r"^input 'x' is scipy\.stats\.poisson with values from 0 to inf; .* at most 10000 values$"),
    "not frozen": (stats.norm, r"^input 'x' is a norm_gen of SciPy; must be a frozen distribution"),
    "several": (stats.norm([1, 2], 1), r"^input 'x' is scipy\.stats\.norm with an array as loc; must be one number"),
    "new kind": (stats.Normal(mu=1, sigma=2), r"^input 'x' is a Normal of SciPy; must be a frozen distribution"),
}


@pytest.mark.parametrize("wrong", REFUSED)
def test_other_laws_of_scipy_are_refused_by_name(wrong):
    law, text = REFUSED[wrong]
    with pytest.raises(TypeError, match=text):
        lp.bounds(lambda x: x, {"x": law})


def test_scipy_is_not_imported():
    code = (
        "import sys, loosepin as lp; lp.bounds(lambda x: x, {'x': lp.Normal(0, 1)}); lp.Normal(0, 1).ppf(0.3); "
        "print('scipy' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout == "False\n"


def of_seed(seed):
    return lp.bounds(lambda x: x, {"x": lp.Normal(0, 1)}, ["mean"], seed=seed)


@pytest.mark.parametrize(
    "make",
    [lambda: 5, lambda: np.int64(5), lambda: np.random.default_rng(5), lambda: np.random.SeedSequence(5)],
    ids=["int", "NumPy's int", "generator", "sequence"],
)
def test_the_result_tells_a_seed_that_gives_it_again(make):
    found = of_seed(make())
    assert isinstance(found.seed, int) and of_seed(found.seed) == found == of_seed(make())
    assert found != of_seed(found.seed + 1)


def test_a_generator_goes_on_and_the_system_is_never_the_same():
    generator = np.random.default_rng(5)
    seeds = {of_seed(generator).seed, of_seed(generator).seed, of_seed(None).seed, of_seed(None).seed}
    assert len(seeds) == 4
    sequence = np.random.SeedSequence(5)
    assert of_seed(sequence).seed == of_seed(sequence).seed


@pytest.mark.parametrize(
    "wrong, kind, text",
    [
        (-1, ValueError, r"^error\[E0501\]: seed -1; must be >= 0$"),
        (2**64, ValueError, r"^error\[E0501\]: seed 18446744073709551616; must be <= 18446744073709551615$"),
        (0.5, TypeError, "seed is a float; must be an int, a numpy.random.Generator, a SeedSequence or None"),
        (True, TypeError, "seed is a bool; must be"),
        ("1", TypeError, "seed is a str; must be"),
    ],
)
def test_wrong_seeds(wrong, kind, text):
    with pytest.raises(kind, match=text.replace(".", r"\.")):
        of_seed(wrong)


def test_a_study_takes_the_same_seeds(tmp_path):
    model = lp.Study.load(write_study(tmp_path)).model
    mapping = tomllib.loads(STUDY)
    texts = [lp.Study.from_dict(mapping | {"seed": seed}, model).text for seed in (None, None, np.random.default_rng(5), 7)]
    seeds = [tomllib.loads(text)["seed"] for text in texts]
    assert len(set(seeds)) == 4 and seeds[3] == 7 and all(0 <= seed < 2**53 for seed in seeds)
    with pytest.raises(TypeError, match="seed is a str"):
        lp.Study.from_dict(mapping | {"seed": "7"}, model)

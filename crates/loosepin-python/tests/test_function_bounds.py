"""Bounds of functions whose bounds are known in closed form, without any mechanism."""

import math
import re
import statistics

import loosepin as lp
import numpy as np
import pytest

NORMAL = statistics.NormalDist()
# Quantiles of normal inputs are integrated, not sampled: what is left is far below this.
SHIFT_TOLERANCE = 2e-3

# Of means of 512 quasi-random samples.
MEAN_TOLERANCE = 5e-3


def shift(x, u):
    return x + u


INPUTS = {"x": lp.Normal(0.5, 1.5), "u": lp.Interval(-2.0, 0.75)}


@pytest.fixture(scope="module")
def shifted():
    asked = ["mean", "standard_deviation", {"quantile": 0.975}, {"probability_above": 3.0}, "cdf"]
    return lp.bounds(shift, INPUTS, asked, outer=16)


def test_analytic_bounds_of_a_shift(shifted):
    mean, deviation, quantile, probability = shifted.bounds
    z = NORMAL.inv_cdf(0.975)
    expected = {
        "mean": (-1.5, 1.25),
        "standard_deviation": (1.5, 1.5),
        "quantile": (-1.5 + 1.5 * z, 1.25 + 1.5 * z),
        "probability_above": (1 - NORMAL.cdf(3.0), 1 - NORMAL.cdf(1.75 / 1.5)),
    }
    for bound in (mean, deviation, quantile, probability):
        low, high = expected[bound.statistic]
        assert bound.lower.value == pytest.approx(low, abs=SHIFT_TOLERANCE)
        assert bound.upper.value == pytest.approx(high, abs=SHIFT_TOLERANCE)
        assert bound.lower.widened <= low + 1e-9 and high - 1e-9 <= bound.upper.widened
    assert quantile.upper.witness == {"u": 0.75} and quantile.lower.witness == {"u": -2.0}


def test_analytic_box_and_bands_of_a_shift(shifted):
    [box] = shifted.boxes
    exact_low = [NORMAL.cdf((value - 1.25) / 1.5) for value in box.values]
    exact_high = [NORMAL.cdf((value + 1.5) / 1.5) for value in box.values]
    assert np.all(box.lower <= np.array(exact_low) + 1e-9) and np.all(box.upper >= np.array(exact_high) - 1e-9)
    bands = {band.treatment: band for band in shifted.bands}
    z = NORMAL.inv_cdf(0.975)
    assert bands["mixed"].upper == pytest.approx(1.25 + 1.5 * z, abs=SHIFT_TOLERANCE)
    # Cut at three standard deviations.
    assert bands["interval_only"].upper == pytest.approx(0.5 + 4.5 + 0.75, abs=1e-9)


def test_analytic_minimum_inside():
    # Variance of uX over u in [-1, 1.5]: from 0, inside, to 2.25.
    result = lp.bounds(lambda x, u: u * x, {"x": lp.Normal(0, 1), "u": lp.Interval(-1, 1.5)}, ["standard_deviation"])
    [bound] = result.bounds
    assert bound.lower.value == pytest.approx(0, abs=5e-3)
    assert bound.upper.value == pytest.approx(1.5, abs=5e-3)


def test_analytic_probability_box_of_a_parameter():
    result = lp.bounds(lambda x: 2 * x, {"x": lp.Normal(lp.Interval(-1, 3), 0.25)}, ["mean"])
    [bound] = result.bounds
    assert bound.lower.value == pytest.approx(-2, abs=SHIFT_TOLERANCE)
    assert bound.upper.value == pytest.approx(6, abs=SHIFT_TOLERANCE)
    assert bound.upper.witness == {"x.mean": 3.0}


def test_analytic_correlation():
    # Standard deviation of X + Y with normal correlation r = 2 sin(pi rank / 6): sqrt(2 + 2 r).
    inputs = {"x": lp.Normal(0, 1), "y": lp.Normal(0, 1)}
    result = lp.bounds(lambda x, y: x + y, inputs, ["standard_deviation"], correlation={("x", "y"): 0.6}, inner=1024)
    expected = (2 + 4 * np.sin(np.pi * 0.6 / 6)) ** 0.5
    [bound] = result.bounds
    assert bound.lower.widened <= expected <= bound.upper.widened
    assert bound.upper.value == pytest.approx(expected, rel=0.02)


def test_several_outputs_and_every_run():
    result = lp.bounds(
        lambda x, u: np.stack([x + u, x - u], axis=1), INPUTS, ["mean"], outputs=["sum", "difference"], outer=8, inner=64
    )
    assert [bound.output for bound in result.bounds] == ["sum", "difference"]
    np.testing.assert_array_equal(result.outputs["difference"], result.inputs["x"] - result.inputs["u"])
    assert len(result.purpose) == result.runs == len(result.inputs["x"])
    assert set(result.purpose) == {"mixed", "probability_only", "interval_only"}
    assert len(result.to_pandas()) == 2


def test_identity_the_same_seed_gives_the_same_bits():
    first, again, other = (lp.bounds(shift, INPUTS, ["mean"], outer=8, inner=64, seed=seed) for seed in (3, 3, 4))
    assert again.bounds == first.bounds
    np.testing.assert_array_equal(again.outputs["y"], first.outputs["y"])
    assert not np.array_equal(other.inputs["x"], first.inputs["x"])


def test_analytic_failures_widen_probabilities():
    def fails_often(x, u):
        return np.where(x > 0.5, np.nan, x + u)

    result = lp.bounds(fails_often, INPUTS, [{"probability_above": 10.0}])
    [bound] = result.bounds
    # Nothing that finishes is above 10; half of the runs fail, and they might be.
    assert bound.lower.value == 0
    assert bound.upper.widened >= 0.5 - 0.02


def test_failures_leave_a_mean_without_a_bound():
    def fails_sometimes(x, u):
        return np.where(x > 1.5, np.nan, x + u)

    result = lp.bounds(fails_sometimes, INPUTS, ["mean", {"quantile": 0.5}], outer=8, inner=64)
    mean, quantile = result.bounds
    assert mean.guarantee == "finished_runs"
    assert mean.widened == (-np.inf, np.inf)
    # What was found is that of the finished runs: x at most 1.5, u in its interval.
    assert np.isfinite([mean.lower.value, mean.upper.value]).all()
    assert quantile.guarantee != "finished_runs"
    assert result.failed_runs == np.count_nonzero(np.isnan(result.outputs["y"])) > 0


def test_what_the_function_raises_comes_out_unchanged():
    class Broken(Exception):
        pass

    def breaks(x, u):
        raise Broken("at once")

    with pytest.raises(Broken, match="at once"):
        lp.bounds(breaks, INPUTS)


def test_wrong_shapes_inputs_and_statistics_are_refused():
    with pytest.raises(ValueError, match=r"shape \(3, 1\) for \d+ runs"):
        lp.bounds(lambda x, u: np.zeros(3), INPUTS)
    with pytest.raises(lp.LoosepinError, match="input 'x': .*standard deviation -1; must be > 0") as refused:
        lp.bounds(shift, {"x": lp.Normal(0, -1), "u": lp.Interval(0, 1)})
    assert refused.value.code == "E0604"
    with pytest.raises(lp.LoosepinError, match="input 'u'"):
        lp.bounds(shift, {"x": lp.Normal(0, 1), "u": lp.Interval(1, 0)})
    with pytest.raises(TypeError, match="input 'u' is a float; must be a distribution"):
        lp.bounds(shift, {"x": lp.Normal(0, 1), "u": 3.0})
    with pytest.raises(ValueError, match="statistic 'median'"):
        lp.bounds(shift, INPUTS, ["median"])
    with pytest.raises(lp.LoosepinError, match="quantile 1.5"):
        lp.bounds(shift, INPUTS, [{"quantile": 1.5}])
    with pytest.raises(lp.LoosepinError, match="multiple of the 8 replicates") as refused:
        lp.bounds(shift, INPUTS, inner=100)
    assert refused.value.code == "E0611"
    with pytest.raises(ValueError, match="correlation of 'z'"):
        lp.bounds(shift, INPUTS, correlation={("x", "z"): 0.5})
    with pytest.raises(ValueError, match="seed -1; must be >= 0"):
        lp.bounds(shift, INPUTS, seed=-1)
    with pytest.raises(ValueError, match="reading 'mixed'"):
        lp.bounds(shift, INPUTS, reading="mixed")


CUT = (NORMAL.pdf(-2) - NORMAL.pdf(4)) / (NORMAL.cdf(4) - NORMAL.cdf(-2))


@pytest.mark.parametrize(
    "known, mean",
    [
        (lp.TruncatedNormal(1, 0.5, 0, 3), 1 + 0.5 * CUT),
        (lp.Uniform(0.25, 2), 1.125),
        (lp.Lognormal(1.5, 0.25), 1.5),
        (lp.Triangular(0, 0.5, 2), 2.5 / 3),
        (lp.Beta(2, 3, -1, 2), -1 + 3 * 2 / 5),
        (lp.Weibull(1.5, 2), 2 * math.gamma(1 + 1 / 1.5)),
        (lp.Gamma(2.5, 0.75, 0.5), 0.5 + 2.5 * 0.75),
        (lp.Gumbel(1, 0.25), 1 + 0.25 * 0.5772156649015329),
        (lp.Exponential(1.25), 1.25),
        (lp.Discrete([1, 2.5], [0.25, 0.75]), 2.125),
        # The mean of the sample, whatever runs between its values; the order in which they were measured does not matter.
        (lp.Empirical([0.5, 0.75, 1.5, 1.25]), 1.0),
    ],
    ids=lambda known: type(known).__name__,
)
def test_analytic_mean_of_every_distribution(known, mean):
    [bound] = lp.bounds(lambda x: x, {"x": known}, ["mean"], inner=512).bounds
    assert bound.lower.value == pytest.approx(mean, abs=MEAN_TOLERANCE)
    assert bound.lower.value == bound.upper.value


def test_analytic_other_kinds_of_ignorance():
    kinds = {"u": lp.OneOf([1.0, 4.0]), "v": lp.Periodic(0, 2 * np.pi), "w": lp.Evidence([(0, 1, 0.25), (2, 3, 0.75)])}
    result = lp.bounds(lambda u, v, w: u + 0.5 * np.sin(v) + w, kinds, ["mean"], outer=256)
    [bound] = result.bounds
    # Evidence: masses add, 0.25 * 0 + 0.75 * 2 and 0.25 * 1 + 0.75 * 3.
    assert bound.lower.value == pytest.approx(1 - 0.5 + 1.5, abs=0.02)
    assert bound.upper.value == pytest.approx(4 + 0.5 + 2.5, abs=0.02)
    fuzzy = lp.bounds(lambda u: u, {"u": lp.Fuzzy((0, 1, 2, 4))}, ["mean"])
    assert [alpha for alpha, _ in fuzzy.cuts] == [0.0, 0.25, 0.5, 0.75, 1.0]
    assert fuzzy.cuts[-1][1][0].upper.value == pytest.approx(2, abs=1e-6)


def test_samples_grow_until_an_accuracy_is_reached():
    kink = lambda x, u: np.abs(x - u)
    # E|X| of a normal number with the mean 0; with another mean it is larger.
    exact = 1.5 * math.sqrt(2 / math.pi)
    result = lp.bounds(kink, INPUTS, ["mean"], outer=8, inner=64, accuracy=0.01)
    (bound,) = result.bounds
    assert result.accuracy.stop == "reached"
    assert result.accuracy.steps[0].share > 1 >= result.accuracy.steps[-1].share
    assert result.accuracy.steps[-1].runs == result.runs
    assert abs(bound.lower.widened - bound.lower.value) <= 0.01
    assert bound.lower.widened <= exact <= bound.lower.widened + 0.02
    alone = lp.bounds(kink, INPUTS, ["mean", {"probability_above": 1.0}], outer=8, inner=64, accuracy={"y.mean": 0.01})
    assert alone.accuracy.stop == "reached"


def test_a_budget_ends_what_grows():
    kink = lambda x, u: np.abs(x - u)
    result = lp.bounds(kink, INPUTS, ["mean"], outer=8, inner=64, accuracy=1e-9, budget=4000)
    assert result.accuracy.stop == "budget" and result.runs <= 4000
    assert lp.bounds(shift, INPUTS, ["mean"], outer=8, inner=64).accuracy is None


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"accuracy": 0.0}, "accuracy 0.0 of 'y'; must be a number above 0"),
        ({"accuracy": {"z": 0.1}}, "accuracy of 'z'; must be of y, y.mean, y.standard_deviation"),
        ({"budget": 4000}, "budget without accuracy"),
        ({"accuracy": 0.1, "budget": -1}, "budget -1; must be >= 0"),
        ({"accuracy": 0.1, "budget": 10}, "budget 10; the first round takes"),
    ],
)
def test_an_accuracy_that_cannot_be(arguments, says):
    with pytest.raises(ValueError, match=re.escape(says)):
        lp.bounds(shift, INPUTS, **arguments)

"""Bounds of a function as a Dataset, as a figure, and selected."""

import statistics

import loosepin as lp
import numpy as np
import pytest

NORMAL = statistics.NormalDist()
# Of quantiles, which are integrated where the inputs are normal.
SHIFT_TOLERANCE = 2e-3


@pytest.fixture(scope="module")
def found() -> lp.FunctionBounds:
    """Two outputs of one random and one unknown input: their sum, and three times the random one."""

    def both(x, u):
        return np.stack([x + u, 3 * x], axis=1)

    asked = ["mean", {"quantile": 0.975}, {"probability_above": 3.0}, "cdf"]
    return lp.bounds(both, {"x": lp.Normal(0.5, 1.5), "u": lp.Interval(-2.0, 0.75)}, asked, outputs=["sum", "triple"], outer=16)


def test_selection(found):
    (quantile,) = found.select(output="triple", statistic="quantile", parameter=0.975)
    assert quantile.upper.value == pytest.approx(1.5 + 4.5 * NORMAL.inv_cdf(0.975), abs=3 * SHIFT_TOLERANCE)
    assert len(found.select(output="sum")) == 3 and found.select(output="sum", parameter=3.5 - 0.5)[0].statistic == "probability_above"
    with pytest.raises(lp.LoosepinValueError, match="no bound has output='product'; must be one of 'sum', 'triple'"):
        found.select(output="product")
    with pytest.raises(TypeError, match="a bound has no property 'colour'; must be one of output"):
        found.select(colour="red")


def test_analytic_bounds_in_a_dataset(found):
    dataset = found.to_xarray()
    mean = dataset["sum_mean"]
    assert mean.dims == ("end",) and list(dataset["end"].values) == ["lower", "upper"]
    # The mean of the sum lies between -1.5 and 1.25; the widened bound holds it.
    assert mean.sel(end="lower") <= -1.5 + 1e-9 and mean.sel(end="upper") >= 1.25 - 1e-9
    np.testing.assert_allclose(mean, [-1.5, 1.25], atol=2e-2)
    assert set(dataset.data_vars) == {
        f"{output}_{name}" for output in ("sum", "triple") for name in ("mean", "quantile_0.975", "probability_above_3", "cdf")
    }
    function = dataset["sum_cdf"]
    assert function.dims == ("sum", "end")
    exact = np.array([[NORMAL.cdf((value - 1.25) / 1.5), NORMAL.cdf((value + 1.5) / 1.5)] for value in function["sum"].values])
    assert (function.sel(end="lower") <= exact[:, 0] + 1e-9).all() and (function.sel(end="upper") >= exact[:, 1] - 1e-9).all()
    assert dataset["sum_mean"].attrs["guarantee"] == found.bounds[0].guarantee


def test_a_figure_shows_the_distribution_functions(found):
    figure = found.plot()
    assert [axis.get_xlabel() for axis in figure.axes] == ["sum", "triple"]
    # The band of the function and that of the mean; bars of the quantile and the probability.
    (quantile, probability) = figure.axes[0].lines
    bound = found.select(output="sum", statistic="quantile")[0]
    assert list(quantile.get_xdata()) == list(bound.widened) and list(quantile.get_ydata()) == [0.975, 0.975]
    above = found.select(output="sum", statistic="probability_above")[0]
    np.testing.assert_allclose(probability.get_ydata(), [1 - above.upper.widened, 1 - above.lower.widened])
    assert list(probability.get_xdata()) == [3.0, 3.0]
    assert len(figure.axes[0].collections) == 1 and len(found.plot("sum").axes) == 1


def test_a_figure_on_an_axis_of_the_caller(found):
    pyplot = pytest.importorskip("matplotlib.pyplot")
    figure, axis = pyplot.subplots()
    try:
        assert found.plot("triple", ax=axis) is figure
        assert axis.get_xlabel() == "triple" and axis.lines
        with pytest.raises(ValueError, match="ax: 1 axes; must be 2, for sum, triple"):
            found.plot(ax=axis)
    finally:
        pyplot.close(figure)


def test_what_cannot_be_drawn_is_refused(found):
    with pytest.raises(KeyError, match="there is no output 'product'; must be one of sum, triple"):
        found.plot("product")
    spread = lp.bounds(lambda x: x, {"x": lp.Normal(0, 1)}, ["standard_deviation"])
    with pytest.raises(ValueError, match="no bound of 'y' is drawn"):
        spread.plot()

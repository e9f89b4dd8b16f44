"""Bounds of functions of what the runs of a study record."""

import loosepin as lp
import numpy as np
import pytest


@pytest.fixture(scope="module")
def study(desk):
    return lp.Study.load(desk / "study.toml")


def test_identity_an_output_of_the_study_keeps_its_bounds(study, result):
    name = "slider total maximum_absolute"
    assert study.recorded[name] == "m"
    found = study.bounds(lambda run: run[name], [{"quantile": 0.975}], progress=False)
    [of_study] = result.select(statistic="quantile", treatment="mixed")
    [bound] = found.bounds
    assert bound.upper == of_study.upper
    # The study knows that a largest deviation is not negative; of what a function returns nothing is known.
    assert bound.lower.value == of_study.lower.value and bound.lower.witness == of_study.lower.witness
    assert max(bound.lower.widened, 0.0) == of_study.lower.widened
    # The same inputs, run by run; what the study runs for its contributors comes behind them.
    for path in ("parameter.crank_length", "joint.gudgeon.radial_clearance"):
        mixed = found.inputs[path][found.purpose == "mixed"]
        np.testing.assert_array_equal(mixed, result.samples[path][result.samples["purpose"] == "mixed"])


def test_identity_curves_and_inputs_reach_the_function(study):
    shapes = []

    def largest(run):
        shapes.append((run["slider total"].shape, run["parameter.rod_length"].shape))
        return np.stack([np.abs(run["slider total"]).max(axis=1), run["slider total maximum_absolute"]], axis=1)

    found = study.bounds(largest, ["mean"], outputs=["at_poses", "located"], progress=False)
    assert shapes[0][0] == (shapes[0][1][0], 5)
    # What is located between the poses is never below what is seen at them, in any run.
    assert np.all(found.outputs["located"] >= found.outputs["at_poses"])
    assert [bound.output for bound in found.bounds] == ["at_poses", "located"]


def test_samples_grow_until_an_accuracy_is_reached(study):
    spread = lambda run: np.ptp(run["slider total"], axis=1)
    plain = study.bounds(spread, ["mean"], progress=False)
    (bound,) = plain.bounds
    error = bound.upper.widened - bound.upper.value
    assert plain.accuracy is None and error > 0
    closer = study.bounds(spread, ["mean"], accuracy=0.5 * error, progress=False)
    (bound,) = closer.bounds
    assert closer.accuracy.stop == "reached" and closer.runs > plain.runs
    assert bound.upper.widened - bound.upper.value <= 0.5 * error
    short = study.bounds(spread, ["mean"], accuracy={"y.mean": 1e-15}, budget=plain.runs + 100, progress=False)
    assert short.accuracy.stop == "budget" and short.runs <= plain.runs + 100
    with pytest.raises(ValueError, match="budget without accuracy"):
        study.bounds(spread, ["mean"], budget=100, progress=False)


def test_what_the_function_raises_comes_out_unchanged(study):
    class Broken(Exception):
        pass

    def breaks(run):
        raise Broken("at once")

    with pytest.raises(Broken, match="at once"):
        study.bounds(breaks, progress=False)
    with pytest.raises(ValueError, match=r"shape \(3, 1\) for"):
        study.bounds(lambda run: np.zeros(3), progress=False)
    with pytest.raises(lp.LoosepinError, match="quantile 1.5"):
        study.bounds(lambda run: run["slider total"][:, 0], [{"quantile": 1.5}], progress=False)

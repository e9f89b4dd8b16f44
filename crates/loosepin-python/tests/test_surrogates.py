"""Surrogates that a study has saved predict what was learned, and nothing beyond."""

import math

import loosepin as lp
import numpy as np
import pytest
from conftest import STUDY, write_study

ANGLE_RAD = 1.1


@pytest.fixture(scope="module")
def surrogates(tmp_path_factory):
    """Of the ideal position of the slider at one angle, which has a closed form."""
    folder = tmp_path_factory.mktemp("surrogates")
    head, _, _ = STUDY.partition("[[ask]]")
    head = head.replace('standard_deviation = "0.02 mm"', 'standard_deviation = "0.2 mm"')
    head = head.replace('standard_deviation = "0.03 mm"', 'standard_deviation = "0.3 mm"')
    ask = f'[[ask]]\noutput = "slider"\nof = "dimensional"\nposes = {{ crank = ["{ANGLE_RAD} rad"] }}\nstatistics = ["mean"]\n'
    head = head.replace("recorded_turns = 0.1", "recorded_turns = 0.2")
    text = head + "[surrogate]\nkind = \"chaos\"\ndirect = \"confirming\"\ntraining_runs = 60\nconfirming_runs = 8\n" + ask
    result = lp.Study.load(write_study(folder, text)).run(folder / "results", progress=False)
    return result, lp.Surrogates.load(folder / "results/surrogates.json")


def slider_m(crank_m, rod_m):
    return crank_m * math.cos(ANGLE_RAD) + np.sqrt(rod_m**2 - (crank_m * math.sin(ANGLE_RAD)) ** 2)


def test_analytic_predictions_follow_the_closed_form(surrogates):
    _, saved = surrogates
    assert saved.inputs == {"parameter.crank_length": "m", "parameter.rod_length": "m", "joint.gudgeon.radial_clearance": "m"}
    output = saved.outputs[0]
    assert (output.output, output.of, output.unit) == ("slider", "dimensional", "m")
    assert output.pose_rad == pytest.approx([ANGLE_RAD])
    crank_m, rod_m = np.array([0.0499, 0.0501, 0.0502]), np.array([0.1203, 0.1199, 0.12])
    values = {"parameter.crank_length": crank_m, "parameter.rod_length": rod_m, "joint.gudgeon.radial_clearance": 0.0003}
    predicted, deviations = saved.predict(0, values)
    assert predicted.shape == deviations.shape == (3, 1)
    # m; the deviations are 1e-4 m, and what is left of a smooth function of degree 3 or so is far below a micrometre.
    np.testing.assert_allclose(predicted[:, 0], slider_m(crank_m, rod_m) - slider_m(0.05, 0.12), atol=1e-7)


def test_identity_numbers_and_arrays_give_the_same(surrogates):
    result, saved = surrogates
    point = {"parameter.crank_length": 0.0501, "parameter.rod_length": 0.1199, "joint.gudgeon.radial_clearance": 0.0003}
    single, _ = saved.predict(0, point)
    several, _ = saved.predict(0, {path: np.array([value, value]) for path, value in point.items()})
    of_result, _ = result.surrogates.predict(0, point)
    assert single.shape == (1,) and several.shape == (2, 1)
    assert single[0] == several[0, 0] == several[1, 0] == of_result[0]


def test_nothing_is_extrapolated(surrogates):
    _, saved = surrogates
    point = {"parameter.crank_length": 0.06, "parameter.rod_length": 0.1199, "joint.gudgeon.radial_clearance": 0.0003}
    with pytest.raises(lp.LoosepinError, match="'parameter.crank_length' is 0.06 m; learned was from .* nothing is extrapolated") as refused:
        saved.predict(0, point)
    assert refused.value.code == "E0920"
    with pytest.raises(lp.LoosepinError, match="no value of 'parameter.rod_length'"):
        saved.predict(0, {"parameter.crank_length": 0.05})
    with pytest.raises(lp.LoosepinError, match="'mass' is not an input of these surrogates"):
        saved.predict(0, {**point, "mass": 1.0})
    with pytest.raises(IndexError, match="output 2; there are 2, counted from 0"):
        saved.predict(2, point)
    with pytest.raises(lp.LoosepinError):
        lp.Surrogates.from_text("{}")

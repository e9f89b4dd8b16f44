"""Models in space and their studies: against the closed form of a four-bar with two balls."""

import math
import pathlib
import pickle

import loosepin as lp
import numpy as np
import pytest

TEMPLATE = pathlib.Path(__file__).parents[3] / "loosepin-import/templates/spatial-four-bar"


def rocker_rad(crank_rad, coupler_m):
    """Angle of the rocker about the axis (0.6, 0.8, 0), counted from z."""
    crank_m, rocker_m = 0.05, 0.12
    d = (0.22 - crank_m * math.cos(crank_rad), 0.04 - crank_m * math.sin(crank_rad), 0.06)
    p, q = 2 * rocker_m * d[2], 2 * rocker_m * (0.8 * d[0] - 0.6 * d[1])
    s = coupler_m**2 - rocker_m**2 - sum(x * x for x in d)
    return math.atan2(q, p) + math.acos(s / math.hypot(p, q))


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("space")
    (folder / "model.toml").write_text((TEMPLATE / "model.toml").read_text())
    (folder / "study.toml").write_text(
        """
name = "four-bar"
model = "model.toml"
[sampling]
outer = 16
inner = 8
[epistemic]
"joint.rocker_ball.radial_clearance" = { interval = ["0.05 mm", "0.2 mm"] }
[[ask]]
output = "rocker"
of = "clearance"
poses = { crank = ["60 deg"] }
statistics = ["mean"]
"""
    )
    return folder


def test_analytic_a_study_in_space_reaches_the_ends_of_the_closed_form(folder):
    result = lp.Study.load(folder / "study.toml").run()
    at = math.radians(60)
    # Both balls, 0.1 mm and up to 0.2 mm, make the coupler longer or shorter.
    ends = sorted(rocker_rad(at, 0.25 + play) - rocker_rad(at, 0.25) for play in (-3e-4, 3e-4))
    bound = result.bounds[0]
    assert bound.lower.value == pytest.approx(ends[0], rel=1e-9)
    assert bound.upper.value == pytest.approx(ends[1], rel=1e-9)
    result.report(folder / "page.html")
    assert "every place of the journals in their play" in (folder / "page.html").read_text(encoding="utf-8")


def test_analytic_a_model_in_space_moves_as_the_closed_form_does(folder):
    model = lp.Model.load(folder / "model.toml")
    assert lp.Study.load(folder / "study.toml").model.text == model.text
    outputs = [(output.name, output.words, output.unit) for output in model.outputs]
    assert outputs == [("rocker", "turn of rocker", "rad"), ("ball_height", "position of rocker.ball", "m")]
    nominal = {parameter.name: parameter.nominal for parameter in model.parameters}
    assert nominal["joint.rocker_ball.radial_clearance"] == pytest.approx(1e-4, rel=1e-12)
    motion = model.motion(set={"joint.rocker_ball.radial_clearance": "0.2 mm"}, paths=["coupler.rocker_end"])
    start = rocker_rad(motion.drive_angle_rad[0], 0.25)
    for angle, value in zip(motion.drive_angle_rad, motion["rocker"].value, strict=True):
        assert value == pytest.approx(rocker_rad(angle, 0.25) - start, abs=1e-9)
    assert motion["rocker"].searched[0]["found_si"][1] > 0
    path = motion.paths["coupler.rocker_end"]
    # The end of the coupler turns with the rocker, 120 mm about an axis that does not move.
    speed = 0.12 * abs(np.gradient(motion["rocker"].value, motion.drive_angle_rad)) * motion.summary["drive_speed_rad_s"]
    assert path.speed_m_s[5:-5] == pytest.approx(speed[5:-5], rel=0.02, abs=1e-3)
    assert np.all(path.play_longest_m >= path.play_along_m) and path.z_m.shape == path.x_m.shape
    assert path.zone_m.shape == (0, 32, 2)
    assert "rocker" in str(motion) and "rocker" in str(model.check())
    assert pickle.loads(pickle.dumps(model)).text == model.text


@pytest.mark.parametrize(
    "call",
    [
        lambda model: model.simulate(),
        lambda model: model.evaluate({"joint.rocker_ball.radial_clearance": [1e-4]}, "rocker value"),
        lambda model: model.simulate_many({"joint.rocker_ball.radial_clearance": [1e-4]}),
        lambda model: model.sweep(over="joint.rocker_ball.radial_clearance", values=[1e-4]),
        lambda model: model.wear(),
    ],
)
def test_what_needs_dynamics_says_so_in_space(folder, call):
    with pytest.raises(lp.LoosepinError, match=r"needs a planar model: there is no dynamics in space"):
        call(lp.Model.load(folder / "model.toml"))

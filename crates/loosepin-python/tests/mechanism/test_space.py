"""Studies of models in space: against the closed form of a four-bar with two balls."""

import math
import pathlib

import loosepin as lp
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


def test_what_is_for_planar_models_says_so(folder):
    with pytest.raises(lp.LoosepinError, match="works on planar models"):
        lp.Model.load(folder / "model.toml")
    with pytest.raises(lp.LoosepinError, match="works on planar models"):
        _ = lp.Study.load(folder / "study.toml").model

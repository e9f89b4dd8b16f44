"""Identification in Python: the answer of the command."""

import json
import shutil

import loosepin as lp
import pytest
from conftest import REPOSITORY, command

CASE = REPOSITORY / "cases/backlash_test"

# The stroke is twice the crank, whatever else is: 100.3 mm ± 0.2 mm say 50.05 to 50.25 mm.
STROKE = """
name = "crank"
model = "model.toml"
[cycle]
transient_turns = 0
recorded_turns = 1
[epistemic]
"parameter.crank_length" = { interval = ["49 mm", "51 mm"] }
[[ask]]
output = "slider"
of = "total"
reduce = "rms"
statistics = ["mean"]
[[measured]]
kind = "motion"
output = "slider"
feature = "range"
value = "100.3 mm"
error = "± 0.2 mm"
"""


@pytest.fixture
def rig(tmp_path):
    for name in ["model.toml", "first.toml", "study.toml"]:
        shutil.copy(CASE / name, tmp_path / name)
    return tmp_path


def test_readings_give_the_answer_of_the_command(rig):
    found = lp.Study.load(rig / "study.toml").identify(progress=False)
    ended = command("identify", "study.toml", "--json", cwd=rig)
    assert ended.returncode == 0, ended.stderr
    assert found.record == json.loads(ended.stdout)
    assert str(found) == command("identify", "study.toml", cwd=rig).stdout
    assert len(found.unknowns) == 3 and all(unknown.is_narrowed for unknown in found.unknowns)
    command("identify", "study.toml", "--write", "narrowed.toml", cwd=rig)
    assert found.narrowed().text == (rig / "narrowed.toml").read_text(encoding="utf-8")
    found.report(rig / "page.html")
    assert "Values consistent with the readings" in (rig / "page.html").read_text(encoding="utf-8")


def test_a_motion_narrows_its_unknown_and_a_misfit_is_none(tmp_path):
    # Without play: the three lines of the gudgeon that say so.
    text = (REPOSITORY / "cases/slider_crank_worn_pin/model.toml").read_text(encoding="utf-8")
    lines = [line for line in text.splitlines() if not line.startswith(("bearing_radius", "radial_clearance", "contact ="))]
    model = lp.Model.from_text("\n".join(lines))
    told = []
    found = lp.Study.from_text(STROKE, model=model).identify(progress=lambda *seen: told.append(seen))
    (crank,) = found.unknowns
    assert crank.unit == "m" and not found.is_misfit
    # A cell and a half of a twentieth of the set at either end.
    assert 50.03e-3 < crank.after[0] <= 50.05e-3 and 50.25e-3 <= crank.after[1] < 50.27e-3
    assert told and told[-1][0] <= told[-1][1]
    plan = lp.Study.from_text(STROKE, model=model).plan_motion(progress=False)
    assert list(plan.features) == ["slider, range"] and "most telling alone: slider, range" in str(plan)
    wrong = lp.Study.from_text(STROKE.replace("100.3 mm", "103 mm"), model=model).identify(progress=False)
    assert wrong.is_misfit
    with pytest.raises(lp.LoosepinError, match="no values explain the measurements"):
        wrong.narrowed()


def test_a_posterior_distribution_is_that_of_the_command(tmp_path):
    text = (REPOSITORY / "cases/slider_crank_worn_pin/model.toml").read_text(encoding="utf-8")
    lines = [line for line in text.splitlines() if not line.startswith(("bearing_radius", "radial_clearance", "contact ="))]
    (tmp_path / "model.toml").write_text("\n".join(lines), encoding="utf-8")
    # 2 r = 100.3 mm with a standard deviation of 0.3 mm; 19 errors are drawn.
    study = STROKE.replace('error = "± 0.2 mm"', 'scatter = "0.3 mm"')
    (tmp_path / "study.toml").write_text(study, encoding="utf-8")
    asked = {"confidence": 0.9, "points": 60, "progress": False}
    loaded = lp.Study.load(tmp_path / "study.toml")
    assert loaded.identify(**asked).posterior == ()
    found = loaded.identify(posterior=True, **asked)
    (crank,) = found.posterior
    assert (crank.path, crank.unit, crank.specimen) == ("parameter.crank_length", "m", None)
    assert crank.credible[0] < crank.mean < crank.credible[1] and sum(crank.probabilities) == pytest.approx(1.0)
    # The mean of 19 errors is off by 0.23 standard deviations, 0.034 mm of the crank: three of them.
    assert abs(crank.mean - 50.15e-3) < 0.11e-3
    words = ["identify", "study.toml", "--posterior", "--confidence", "0.9", "--points", "60"]
    ended = command(*words, "--json", cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    assert found.record == json.loads(ended.stdout)
    assert str(found) == command(*words, cwd=tmp_path).stdout
    assert "Posterior distribution" in str(found) and "prior: uniform" in str(found)


def test_lengths_of_a_specimen_go_on_in_the_narrowed_study(tmp_path):
    text = (REPOSITORY / "cases/slider_crank_worn_pin/model.toml").read_text(encoding="utf-8")
    lines = [line for line in text.splitlines() if not line.startswith(("bearing_radius", "radial_clearance", "contact ="))]
    (tmp_path / "model.toml").write_text("\n".join(lines), encoding="utf-8")
    study = STROKE.replace('error = "± 0.2 mm"', 'scatter = "0.3 mm"') + (
        '[random]\n"parameter.rod_length" = { normal = { mean = "120 mm", standard_deviation = "0.03 mm" } }\n'
    )
    (tmp_path / "study.toml").write_text(study, encoding="utf-8")
    found = lp.Study.load(tmp_path / "study.toml").identify(lengths=True, confidence=0.9, progress=False)
    rows = found.record["motion"][0]["lengths"]["given"]
    assert len(rows["rows_si"]) == 1000 and rows["effective"] > 100
    assert 'mechanisms = "narrowed-specimen.csv"' in found.narrowed().text

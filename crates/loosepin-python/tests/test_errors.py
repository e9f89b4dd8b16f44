"""Errors have the text of the terminal, and are never a panic."""

import random

import loosepin as lp
import pytest
from conftest import MODEL, REPOSITORY, STUDY, command, write_study

def refusal(path):
    with pytest.raises(lp.LoosepinError) as refused:
        lp.Model.load(path)
    return refused.value


def test_text_place_code_and_hint(tmp_path):
    (tmp_path / "model.toml").write_text('name = "x"\ngravity = 3\n', encoding="utf-8")
    error = refusal(tmp_path / "model.toml")
    assert str(error) == command("check", str(tmp_path / "model.toml"), cwd=tmp_path).stderr.strip()
    diagnostic = error.diagnostics[-1]
    assert (diagnostic.code, diagnostic.severity, diagnostic.line, diagnostic.column) == ("E0303", "error", 2, 11)
    assert diagnostic.message == "gravity is 3 without a unit; must be an acceleration"
    assert diagnostic.hint == 'write the unit, for example "3 m/s^2"'
    assert diagnostic.file == str(tmp_path / "model.toml")
    assert error.code == error.diagnostics[0].code == "E0202"


def test_kinds_of_files_are_not_mixed_up(tmp_path):
    study = write_study(tmp_path)
    with pytest.raises(lp.LoosepinError, match="this is a study; expected a model"):
        lp.Model.load(study)
    with pytest.raises(lp.LoosepinError, match="this is a model; expected a study"):
        lp.Study.load(MODEL)
    with pytest.raises(lp.LoosepinError, match="there is no such file") as refused:
        lp.Study.load(tmp_path / "nothing.toml")
    assert refused.value.code == "E0101"


def test_values_that_break_a_rule():
    model = lp.Model.load(MODEL)
    with pytest.raises(lp.LoosepinError, match="0.3 without a unit; must be a length"):
        model.simulate(set={"joint.gudgeon.radial_clearance": "0.3"})
    with pytest.raises(lp.LoosepinError, match="tolerance is a mass; must be a length"):
        model.simulate(tolerance="3 kg")
    for name, value in [("turns", float("nan")), ("turns", 0.0), ("turns", -0.5), ("turns", 1e300), ("transient", -1.0)]:
        with pytest.raises(ValueError, match="must be a number"):
            model.simulate(**{name: value})
    with pytest.raises(ValueError, match="samples 0; must be between 1 and 1000000"):
        model.simulate(samples=0)


def test_a_run_that_failed_in_the_end_is_kept_in_the_error():
    model = lp.Model.load(REPOSITORY / "cases/slider_crank_5000/model.toml")
    # 0.5 mm of a clearance of 0.5 mm: the steps are as long as they may be, too long for the contacts.
    with pytest.warns(lp.LoosepinWarning, match="E0822"), pytest.raises(lp.LoosepinError, match="energy balance") as failed:
        model.simulate(tolerance="0.5 mm")
    assert failed.value.code == "E0820"
    assert len(failed.value.simulation.time_s) > 100
    with pytest.raises(lp.LoosepinError, match="larger than the smallest clearance") as refused:
        model.simulate(tolerance="0.6 mm")
    assert refused.value.code == "E0822"


def test_what_is_no_toml_is_refused_by_name():
    with pytest.raises(TypeError, match=r"gravity is a NoneType; must be a str"):
        lp.Model.from_dict({"gravity": None})
    with pytest.raises(TypeError, match="a key is 3"):
        lp.Model.from_dict({"body": {3: {}}})
    with pytest.raises(lp.LoosepinError, match="gravity is nan"):
        lp.Model.from_dict({"gravity": float("nan")})


def test_oversights_are_warnings():
    text = MODEL.read_text(encoding="utf-8").replace("[parameter]", '[parameter]\nspare = "3 mm"', 1)
    with pytest.warns(lp.LoosepinWarning, match="parameter 'spare' is not used") as warned:
        lp.Model.from_text(text)
    assert warned[0].filename == __file__


def test_a_folder_with_other_things_is_refused(tmp_path):
    study = lp.Study.load(write_study(tmp_path))
    with pytest.raises(lp.LoosepinError) as refused:
        study.run(tmp_path)
    assert refused.value.code == "E0901"


@pytest.mark.parametrize("seed", range(40))
def test_mutated_files_raise_and_never_panic(seed):
    chance = random.Random(seed)
    for text, read in ((MODEL.read_text(encoding="utf-8"), lp.Model.from_text), (STUDY, read_study)):
        characters = list(text)
        for _ in range(chance.randrange(1, 5)):
            at = chance.randrange(len(characters))
            characters[at : at + chance.randrange(4)] = chance.choice(["", "-", "[", "]", '"', "=", "1e999", "é", "\n", "mm"])
        try:
            read("".join(characters))
        except lp.LoosepinError as error:
            assert error.code is not None and error.diagnostics


def read_study(text):
    return lp.Study.from_text(text, lp.Model.load(MODEL))

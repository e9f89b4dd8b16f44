"""A folder of results that the command wrote is read as the result of a study."""

import shutil

import loosepin as lp
import numpy as np
import pytest
from conftest import MODEL, command


def test_identity_a_folder_of_the_command_is_the_result_of_python(desk, result):
    stored = lp.StudyResult.load(desk / "command")
    assert stored._native.summary_json() == (desk / "command/summary.json").read_text(encoding="utf-8")
    assert stored._native.bounds_csv() == (desk / "command/bounds.csv").read_bytes()
    assert stored.name == "a tenth of a turn" and stored.bounds == result.bounds
    assert list(stored.samples) == list(result.samples)
    for name, values in result.samples.items():
        np.testing.assert_array_equal(stored.samples[name], values, err_msg=name)
    assert stored.is_met == result.is_met and str(stored) == str(result)


def test_reading_changes_nothing_and_needs_no_page(desk, tmp_path):
    shutil.copytree(desk / "command", tmp_path / "copy")
    (tmp_path / "copy/report.html").unlink()
    before = {path.name: path.read_bytes() for path in (tmp_path / "copy").iterdir()}
    stored = lp.StudyResult.load(tmp_path / "copy")
    assert {path.name: path.read_bytes() for path in (tmp_path / "copy").iterdir()} == before
    assert stored.report(tmp_path / "page.html").read_bytes() == (desk / "command/report.html").read_bytes()


def test_a_file_that_is_not_as_it_was_written_is_refused(desk, tmp_path):
    shutil.copytree(desk / "command", tmp_path / "copy")
    summary = tmp_path / "copy/summary.json"
    summary.write_text(summary.read_text(encoding="utf-8").replace("a tenth of a turn", "a turn"), encoding="utf-8")
    with pytest.raises(lp.LoosepinError, match="summary.json is not the file that the study 'a tenth of a turn' wrote"):
        lp.StudyResult.load(tmp_path / "copy")


def test_a_folder_of_something_else_is_refused(tmp_path):
    with pytest.raises(lp.LoosepinError, match="there is no folder"):
        lp.StudyResult.load(tmp_path / "nothing")
    (tmp_path / "empty").mkdir()
    with pytest.raises(lp.LoosepinError, match="contains no results"):
        lp.StudyResult.load(tmp_path / "empty")
    ended = command("motion", str(MODEL), "--out", "motion", cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    with pytest.raises(lp.LoosepinError, match="contains the motion 'slider-crank with a worn gudgeon pin'; expected a study"):
        lp.StudyResult.load(tmp_path / "motion")

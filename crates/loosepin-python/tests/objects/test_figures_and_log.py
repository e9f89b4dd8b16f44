"""Figures in axes of the caller, and what the log is told."""

import logging

import loosepin as lp
import numpy as np
import pytest
from conftest import MODEL
from every_object import every_object
from matplotlib import pyplot


@pytest.fixture
def screen():
    """Open figures of the caller."""
    pyplot.switch_backend("agg")
    yield pyplot
    pyplot.close("all")


def test_a_simulation_is_drawn_into_given_axes(screen, monkeypatch):
    monkeypatch.setattr(screen, "show", lambda *arguments, **options: pytest.fail("shown"))
    run = every_object()["Simulation"][0]
    figure, axes = screen.subplots(2, 2)
    drawn = run.plot("slider", "gudgeon_force", ax=axes[0])
    assert drawn is figure
    assert [axis.get_ylabel() for axis in axes[0]] == ["slider [mm]", "gudgeon_force [N]"]
    assert not axes[1, 0].lines and not axes[1, 1].lines
    assert run.plot("slider", deviation=True, ax=axes[1, 0]) is figure and axes[1, 0].lines
    # The line is the output in the unit of the axis, mm.
    np.testing.assert_allclose(axes[0, 0].lines[-1].get_ydata(), run["slider"] * 1000)
    assert screen.get_fignums() == [figure.number]


def test_a_study_is_drawn_into_given_axes(screen, result):
    figure, axes = screen.subplots(1, 2)
    assert result.plot("curves", ax=axes[0]) is figure
    assert result.plot("box", ax=[axes[1]]) is figure
    assert [axis.get_ylabel() for axis in axes] == ["slider, total [mm]", "probability to stay below"]
    assert screen.fignum_exists(figure.number)


def test_a_new_figure_leaves_those_of_the_caller_alone(screen):
    mine = screen.figure()
    drawn = every_object()["Simulation"][0].plot("slider")
    assert drawn is not mine and screen.gcf() is mine and not mine.axes
    assert screen.get_fignums() == [mine.number]


def test_wrong_axes_are_refused_by_name(screen, result):
    run = every_object()["Simulation"][0]
    figure, axes = screen.subplots(1, 3)
    with pytest.raises(ValueError, match="^ax: 3 axes; must be 2, for slider, gudgeon_force$"):
        run.plot("slider", "gudgeon_force", ax=axes)
    with pytest.raises(ValueError, match="^ax: 3 axes; must be 1, for slider total$"):
        result.plot("box", ax=axes)
    with pytest.raises(TypeError, match="^ax is a int; must be axes of matplotlib, or a list of them$"):
        run.plot("slider", ax=3)
    with pytest.raises(TypeError, match="^ax is a Figure; must be axes"):
        run.plot("slider", ax=figure)
    assert not any(axis.lines for axis in axes)


def test_a_program_without_logging_hears_nothing(capfd):
    logger = logging.getLogger("loosepin")
    assert [type(handler) for handler in logger.handlers] == [logging.NullHandler]
    assert logger.level == logging.NOTSET and logger.propagate
    lp.Model.load(MODEL).evaluate({}, "slider total rms", turns=0.1, transient=0, progress=False)
    assert capfd.readouterr() == ("", "")


def test_runs_tell_the_log_when_they_begin_and_end(caplog):
    study = every_object()["Study"][0]
    with caplog.at_level(logging.INFO, logger="loosepin"):
        study.evaluate(study.design(np.full((3, len(study.inputs)), 0.5)), progress=False)
    begun, ended = (record.getMessage() for record in caplog.records)
    assert begun == "evaluation of 3 runs begins"
    assert ended.startswith("evaluation of 3 runs is finished after ") and ended.endswith(" s")
    assert {record.levelno for record in caplog.records} == {logging.INFO} and {record.name for record in caplog.records} == {"loosepin"}


def test_the_log_tells_what_has_ended_a_run(caplog):
    study = every_object()["Study"][0]

    def stop(finished, most):
        raise RuntimeError("no more")

    with caplog.at_level(logging.INFO, logger="loosepin"), pytest.raises(RuntimeError, match="no more"):
        study.evaluate(study.design(np.full((3, len(study.inputs)), 0.5)), progress=stop)
    assert caplog.records[-1].getMessage().endswith(" s by RuntimeError")


def test_the_log_tells_how_far_a_long_run_is(caplog, monkeypatch):
    from loosepin._objects import logs

    monkeypatch.setattr(logs, "_EVERY_S", 0.0)
    study, told = every_object()["Study"][0], []
    with caplog.at_level(logging.INFO, logger="loosepin"):
        study.evaluate(study.design(np.full((3, len(study.inputs)), 0.5)), progress=lambda *numbers: told.append(numbers))
    messages = [record.getMessage() for record in caplog.records]
    assert "evaluation of 3 runs: 3 of at most 3 finished" in messages
    assert told[-1] == (3, 3)


def test_warnings_go_to_the_log_as_well(caplog):
    text = MODEL.read_text(encoding="utf-8").replace("[parameter]", '[parameter]\nspare = "3 mm"', 1)
    with pytest.warns(lp.LoosepinWarning, match="parameter 'spare' is not used") as warned:
        lp.Model.from_text(text)
    [record] = caplog.records
    assert (record.levelno, record.name, record.getMessage()) == (logging.WARNING, "loosepin", str(warned[0].message))


def test_deviation_is_that_of_the_clearance():
    """The motion without play is that of the values that were set, as for the deviation "clearance" of an evaluation."""
    model = lp.Model.load(MODEL)
    values = {"parameter.rod_length": 0.1203, "joint.gudgeon.radial_clearance": 3e-4}
    texts = {"parameter.rod_length": "120.3 mm", "joint.gudgeon.radial_clearance": "0.3 mm"}
    run = model.simulate(turns=0.5, transient=0, samples=40, set=texts, second_run=False)
    asked = ["slider clearance", "slider total"]
    runs = model.evaluate(values, asked, turns=0.5, transient=0, samples=40, progress=False)
    angle_rad, pose_rad = run.drive_angle_rad, runs.pose_rad["slider clearance"]
    own = np.interp(pose_rad, angle_rad, run.deviation["slider"])
    # m: two runs with their own steps, and straight lines between rows; 0.3 mm of the rod tell the two deviations apart.
    np.testing.assert_allclose(own, runs["slider clearance"][0], atol=2e-5)
    assert np.min(np.abs(own - runs["slider total"][0])) > 2e-4


def test_extremes_are_those_over_time():
    model = lp.Model.load(MODEL)
    coarse, fine = (model.simulate(turns=0.5, transient=0, samples=samples, second_run=False) for samples in (20, 2000))
    by_name = {(each.output, each.of): each for each in coarse.extremes}
    assert {name for name, of in by_name if of == "value"} == set(coarse)
    for (name, of), extreme in by_name.items():
        rows = coarse[name] if of == "value" else coarse.deviation[name]
        dense = fine[name] if of == "value" else fine.deviation[name]
        assert extreme.unit == coarse.units[name]
        assert extreme.minimum.value <= rows.min() and rows.max() <= extreme.maximum.value
        assert coarse.time_s[0] <= extreme.minimum.time_s <= coarse.time_s[-1]
        # A hundred times as many rows come nearer to them, from inside.
        assert extreme.maximum.value >= dense.max() - 1e-6 * abs(dense.max()) - 1e-6
    force = by_name["gudgeon_force", "value"]
    assert force.maximum.value > 1.01 * coarse["gudgeon_force"].max()
    assert f"{force.maximum.value:.6g}" in coarse._repr_html_()

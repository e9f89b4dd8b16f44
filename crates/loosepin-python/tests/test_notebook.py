"""What a notebook gets to show of a run and a study; tests/browser/test_widget.py looks at it in a browser."""

import sys
import types

import IPython
import loosepin as lp
import nbclient
import nbformat
import numpy as np
import pytest
import traitlets
from conftest import MODEL

VIEW = "application/vnd.jupyter.widget-view+json"
STATE = "application/vnd.jupyter.widget-state+json"


@pytest.fixture(scope="module")
def run():
    return lp.Model.load(MODEL).simulate(turns=0.25, transient=0, samples=40, second_run=False)


@pytest.fixture
def kernel(monkeypatch):
    """This process taken for the kernel of a notebook."""
    monkeypatch.setattr(IPython, "get_ipython", lambda: types.SimpleNamespace(kernel=object()))


def test_outside_of_notebooks_no_widget_is_made(run):
    assert set(run._repr_mimebundle_()) == {"text/plain", "text/html"}


def test_a_notebook_gets_the_view_and_the_still_figure(run, result, kernel):
    for shown in (run, result):
        bundle = shown._repr_mimebundle_()
        assert set(bundle) == {VIEW, "text/plain", "text/html"}
        assert bundle["text/plain"] == repr(shown) and bundle["text/html"] == shown._repr_html_()
        # Shown again, it is the same figure; another one is made by hand.
        assert shown._repr_mimebundle_()[VIEW] == bundle[VIEW]
        assert shown.widget().model_id != bundle[VIEW]["model_id"]
        data = shown.widget()._repr_mimebundle_()
        data = data[0] if isinstance(data, tuple) else data
        assert data["text/html"] == bundle["text/html"] and VIEW in data


def test_a_closed_figure_is_made_again(run, kernel):
    first = run._own_widget()
    first.close()
    assert run._own_widget() is not first and run._own_widget().comm is not None


def test_without_anywidget_the_figure_stands_still(run, kernel, monkeypatch):
    monkeypatch.setattr(sys, "path", [])
    monkeypatch.delitem(sys.modules, "anywidget", raising=False)
    for name in [name for name in sys.modules if name.startswith(("anywidget.", "loosepin._notebook.widget"))]:
        monkeypatch.delitem(sys.modules, name)
    assert set(run._repr_mimebundle_()) == {"text/plain", "text/html"}
    with pytest.raises(ImportError, match=r"widget\(\) needs anywidget, which cannot be imported\nhint: pip install anywidget"):
        run.widget()


def test_the_angle_is_a_number(run):
    figure = run.widget()
    # It begins at the pose of the still drawing: after a sixth of the rows of a turn. Pages have 8 digits.
    assert figure.drive_angle_rad == pytest.approx(run.drive_angle_rad[len(run.time_s) // 6], rel=1e-7)
    figure.drive_angle_rad = run.drive_angle_rad[3]
    assert figure.drive_angle_rad == run.drive_angle_rad[3]
    figure.drive_angle_rad = 1
    for wrong in (np.nan, np.inf):
        with pytest.raises(traitlets.TraitError, match=f"drive_angle_rad is {wrong}; must be finite"):
            figure.drive_angle_rad = wrong
    with pytest.raises(traitlets.TraitError):
        figure.drive_angle_rad = "1 rad"
    assert figure.drive_angle_rad == 1.0 and "drive_angle_rad=1.0" in repr(figure)


def test_a_kernel_shows_run_and_study_and_ends_its_bar(tmp_path, desk):
    cells = [
        f"import loosepin as lp\nmodel = lp.Model.load({str(MODEL)!r})",
        "model.simulate(turns=0.25, transient=0, samples=40, second_run=False)",
        f"result = lp.Study.load({str(desk / 'study.toml')!r}).run(threads=1)\nresult",
    ]
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(cell) for cell in cells])
    nbclient.NotebookClient(notebook, timeout=120, resources={"metadata": {"path": str(tmp_path)}}).execute()
    _, run, study = (cell.outputs for cell in notebook.cells)
    assert [output.output_type for output in run] == ["execute_result"]
    # Warnings go to the stream of errors.
    bar, shown = (output for output in study if output.output_type != "stream")
    assert bar.output_type == "display_data" and bar.data == {"text/plain": "", "text/html": ""}
    states = notebook.metadata.widgets[STATE]["state"]
    for output in (run[0], shown):
        assert {VIEW, "text/html", "text/plain"} <= set(output.data)
        state = states[output.data[VIEW]["model_id"]]
        assert state["model_module"] == "anywidget" and state["state"]["_document"].startswith("<!DOCTYPE html>")
        assert "<script" not in output.data["text/html"]

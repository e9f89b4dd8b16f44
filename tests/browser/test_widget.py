"""A run and a study in a notebook: the figure is live, a cursor moves mechanism and chart, Python reads and sets it, and two do not meet."""

import math
import pathlib
import sys

import numpy as np
import pytest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from check_pages import AXE, SIDEWAYS, seen_by_axe  # noqa: E402
from chromium import Chromium  # noqa: E402
from notebook_page import Notebook  # noqa: E402

import loosepin as lp  # noqa: E402

CASE = REPOSITORY / "cases/slider_crank_worn_pin"
STUDY = """
name = "two lengths"
model = "slider-crank"
seed = 7
[cycle]
transient_turns = 0
recorded_turns = 0.5
samples_per_turn = 40
[sampling]
outer = 3
inner = 8
tolerance = "1e-6 m"
[random]
"parameter.crank_length" = { normal = { mean = "50 mm", standard_deviation = "0.02 mm" } }
[epistemic]
"joint.gudgeon.radial_clearance" = { interval = ["0.1 mm", "0.5 mm"] }
[[ask]]
output = "slider"
of = "total"
at = "cycle"
statistics = ["mean"]
"""
# Where the crank is drawn, where the cursor of the chart stands in it, and what both say.
SHOWN = """(() => {
    const crank = document.querySelector('[data-body="1"]').getAttribute('transform');
    const line = document.querySelector('.chart .cursor');
    return {
        crank_deg: Number(/rotate\\\\(([^)]+)\\\\)/.exec(crank)[1]),
        angle: document.querySelector('.mechanism .angle').textContent,
        position: document.querySelector('.position').textContent,
        is_cursor_shown: line.getAttribute('visibility') === 'visible', cursor: Number(line.getAttribute('x1')),
        are_drawn: document.querySelectorAll('[data-drawn]').length, page: getComputedStyle(document.body).color,
        is_playing: document.querySelector('.play').getAttribute('aria-pressed') === 'true',
        outline: getComputedStyle(document.querySelector('svg')).outlineStyle, height: document.body.getBoundingClientRect().height,
    };
})()""".replace("\\\\", "\\")
SLIDER = """((value) => {
    const slider = document.querySelector('.pose');
    slider.value = String(value);
    slider.dispatchEvent(new Event('input', { bubbles: true }));
})(%s)"""
KEY = """document.querySelector('[data-chart]').dispatchEvent(new KeyboardEvent('keydown', { key: '%s', bubbles: true }))"""


@pytest.fixture(scope="module")
def browser():
    with Chromium() as browser:
        browser.view(1000)
        yield browser


@pytest.fixture(scope="module")
def run():
    return lp.Model.load(CASE / "model.toml").simulate(turns=2, transient=1, samples=60, second_run=False)


@pytest.fixture(scope="module")
def result():
    return lp.Study.from_text(STUDY, lp.Model.load(CASE / "model.toml")).run(progress=False)


@pytest.fixture
def notebook(browser, tmp_path, monkeypatch):
    return Notebook(browser, tmp_path, monkeypatch)


def is_turned_to(shown, angle_rad):
    """Whether the crank is drawn at an angle, to a pose of the drawing."""
    return abs((shown["crank_deg"] - math.degrees(angle_rad) + 180) % 360 - 180) < 0.1


def test_a_run_is_a_live_figure_whose_cursor_python_sees(notebook, run):
    figure = run.widget()
    seen = []
    figure.observe(lambda change: seen.append(change["new"]), "drive_angle_rad")
    start = figure.drive_angle_rad
    notebook.show("one", figure)
    shown = notebook.inside("one", SHOWN)
    # It begins at the pose that the still picture shows, and rests there; Python counts turns as the run does.
    assert shown["are_drawn"] == 2 and shown["is_cursor_shown"] and not shown["is_playing"]
    assert run.drive_angle_rad[0] <= figure.drive_angle_rad <= run.drive_angle_rad[-1]
    assert is_turned_to(shown, figure.drive_angle_rad)
    # The slider of the mechanism moves the cursor of the chart, and the trait.
    notebook.inside("one", SLIDER % 40)
    notebook.wait(lambda: figure.drive_angle_rad != start)
    moved = notebook.inside("one", SHOWN)
    assert is_turned_to(moved, figure.drive_angle_rad) and moved["cursor"] != shown["cursor"]
    # The pose of the drawing is the row of the run, turns of start-up included.
    assert figure.drive_angle_rad == pytest.approx(run.drive_angle_rad[40], rel=1e-7)
    # A key in the chart moves the mechanism, by a row of the run.
    before = figure.drive_angle_rad
    notebook.inside("one", KEY % "ArrowRight")
    notebook.wait(lambda: figure.drive_angle_rad != before)
    stepped = notebook.inside("one", SHOWN)
    assert is_turned_to(stepped, figure.drive_angle_rad) and stepped["crank_deg"] != moved["crank_deg"]
    assert figure.drive_angle_rad - before == pytest.approx(run.drive_angle_rad[1] - run.drive_angle_rad[0], rel=1e-3)
    assert seen == [before, figure.drive_angle_rad]
    assert not notebook.browser.diagnostics() and not notebook.browser.requests()


def test_python_moves_the_cursor(notebook, run):
    figure = run.widget()
    notebook.show("one", figure)
    for row in (10, 70, 115):
        figure.drive_angle_rad = run.drive_angle_rad[row]
        notebook.exchange()
        notebook.wait(lambda: is_turned_to(notebook.inside("one", SHOWN), run.drive_angle_rad[row]))
        # Nothing comes back that is not what Python has said.
        notebook.exchange()
        assert figure.drive_angle_rad == run.drive_angle_rad[row]
        turns = math.floor(run.drive_angle_rad[0] / (2 * math.pi) + 1e-9)
        position = notebook.inside("one", SHOWN)["position"]
        assert f"{math.degrees(run.drive_angle_rad[row]) - 360 * turns:.0f}" in position, position
    # Two values set before the figure is there: the last one holds.
    second = run.widget()
    second.drive_angle_rad = run.drive_angle_rad[5]
    second.drive_angle_rad = run.drive_angle_rad[40]
    notebook.show("two", second)
    notebook.wait(lambda: is_turned_to(notebook.inside("two", SHOWN), run.drive_angle_rad[40]))
    assert second.drive_angle_rad == run.drive_angle_rad[40]
    assert not notebook.browser.diagnostics()


def test_two_figures_do_not_meet(notebook, run, result):
    notebook.show("one", run.widget())
    notebook.show("two", result.widget())
    one, two = (notebook.inside(name, SHOWN) for name in ("one", "two"))
    notebook.inside("two", SLIDER % 3)
    notebook.exchange()
    assert notebook.inside("one", SHOWN) == one
    moved = notebook.inside("two", SHOWN)
    assert moved["crank_deg"] != two["crank_deg"]
    # Nor do they meet the notebook: its styles stay outside, and it keeps its address, its elements and its names.
    assert one["outline"] == two["outline"] == "none"
    assert notebook.browser.evaluate("typeof pageCursor === 'undefined' && location.hash === ''")
    assert notebook.browser.evaluate("document.querySelectorAll('style').length") == 1
    # Each is as high as what is in it, once it is seen: a browser lays out nothing anew that is out of sight.
    for name in ("one", "two"):
        notebook.browser.evaluate(f"document.getElementById({name!r}).scrollIntoView()")
        height = f"document.querySelector('#{name} iframe').clientHeight"
        notebook.wait(lambda: 0 <= notebook.browser.evaluate(height) - notebook.inside(name, SHOWN)["height"] < 2)
    assert not notebook.browser.diagnostics()


def test_what_plays_streams_its_angle_until_it_is_stopped(notebook, run):
    figure = run.widget()
    angles = []
    figure.observe(lambda change: angles.append(change["new"]), "drive_angle_rad")
    notebook.show("one", figure)
    notebook.inside("one", "document.querySelector('.play').click()")
    notebook.wait(lambda: len(angles) > 5)
    assert notebook.inside("one", SHOWN)["is_playing"]
    assert np.all(np.diff(angles[1:5]) != 0)
    # Setting the angle stops it, as a cursor that is moved does.
    figure.drive_angle_rad = 7.0
    notebook.wait(lambda: not notebook.inside("one", SHOWN)["is_playing"])


def test_the_figure_has_the_colours_of_the_notebook(notebook, result):
    # The system is light; the notebook decides.
    notebook.show("one", result.widget())
    light = notebook.inside("one", SHOWN)["page"]
    notebook.browser.evaluate("document.body.className = 'dark'")
    notebook.wait(lambda: notebook.inside("one", SHOWN)["page"] != light)
    assert (light, notebook.inside("one", SHOWN)["page"]) == ("rgb(27, 36, 48)", "rgb(229, 233, 238)")
    notebook.browser.evaluate("document.body.className = 'light'")
    notebook.wait(lambda: notebook.inside("one", SHOWN)["page"] == light)


@pytest.mark.parametrize("width", [1000, 400])
def test_everybody_can_use_the_figure(browser, run, result, tmp_path, width):
    browser.view(width, reduced_motion=True)
    for shown in (run, result):
        page = tmp_path / "frame.html"
        page.write_text(shown._figure().document, encoding="utf-8")
        browser.open(page)
        assert browser.evaluate(SIDEWAYS) == [] and seen_by_axe(browser, AXE.read_text(encoding="utf-8")) == []
        assert not browser.diagnostics() and not browser.requests()
    browser.view(1000)


def test_a_closed_figure_hears_nothing(notebook, run):
    notebook.show("one", run.widget())
    assert notebook.browser.evaluate("(models.one.close(), models.one.listeners.length)") == 0


def test_without_a_front_end_the_figure_stands_still(browser, run, result, tmp_path):
    for shown in (run, result):
        page = tmp_path / "still.html"
        page.write_text(f'<!DOCTYPE html><html lang="en"><meta charset="utf-8"><title>still</title>{shown._repr_html_()}</html>', encoding="utf-8")
        browser.run_scripts(False)
        browser.open(page)
        browser.run_scripts(True)
        images = browser.evaluate("[...document.images].map((image) => [image.alt, image.naturalWidth > 100, image.complete])")
        assert [image[1:] for image in images] == [[True, True]] * 2
        assert images[0][0].startswith("Drawing of the mechanism") and images[1][0].startswith("Chart of the")
        assert not browser.diagnostics() and not browser.requests()
        assert browser.evaluate("document.scripts.length") == 0

"""Paths and curves of an ideal motion in its page: one cursor moves them all, and one chart of several is shown."""

import json
import math
import pathlib
import subprocess
import sys

import pytest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from chromium import Chromium  # noqa: E402


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    folder = tmp_path_factory.mktemp("motion")
    study = REPOSITORY / "cases/four_bar_coupler_path/study.toml"
    command = [REPOSITORY / "target/debug/loosepin", "motion", study, "--path", "coupler.head", "--out", folder / "out"]
    # Status 1: a requirement cannot be decided without dynamics.
    assert subprocess.run(command, stdout=subprocess.DEVNULL).returncode == 1
    return str(folder / "out/report.html")


@pytest.fixture(scope="module", params=[(1280, False), (400, True)], ids=["wide light", "narrow dark"])
def browser(page, request):
    width, dark = request.param
    with Chromium() as browser:
        browser.view(width, dark=dark, reduced_motion=True)
        browser.open(page)
        browser.evaluate("document.querySelector('.fold-all button').click()")
        yield browser


def marker(browser, name):
    """Place of the marker in the unit of the table, mm, and the row of the table that is nearest to it."""
    return browser.evaluate(
        f"""(() => {{
          const figure = document.getElementById({json.dumps(name)});
          const ideal = figure.querySelector('.ideal').dataset;
          const [, x, y] = /translate\\(([-\\d.]+) ([-\\d.]+)\\)/.exec(figure.querySelector('.now').getAttribute('transform'));
          return [(x - ideal.x0) / ideal.scale, (ideal.y0 - y) / ideal.scale];
        }})()"""
    )


def test_the_cursor_moves_the_marker_along_the_path(browser):
    # Crank 80 mm about (0, 0), coupler 260 mm, rocker 180 mm about (300, 0) mm: the head is at the end of the rocker.
    for angle_deg in (90, 215):
        browser.evaluate(f"pageCursor.set({angle_deg}, null, 'chosen')")
        x, y = marker(browser, "path.coupler-head")
        assert math.hypot(x - 300, y) == pytest.approx(180, abs=0.05)
        # The record has a position each degree, from 34.4° on.
        crank = math.radians(angle_deg)
        distance = math.hypot(x - 80 * math.cos(crank), y - 80 * math.sin(crank))
        assert distance == pytest.approx(260, abs=80 * math.radians(0.5))
    assert "±" in browser.evaluate("document.querySelector('[id=\"path.coupler-head\"] .reading').textContent")


def test_the_path_moves_the_cursor_of_mechanism_and_charts(browser):
    browser.evaluate("pageCursor.set(90, null, 'chosen')")
    before = browser.evaluate("document.querySelector('[data-mechanism] .angle').textContent")
    browser.evaluate(
        """(() => {
          const svg = document.querySelector('[id="path.tool"] svg');
          svg.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight', shiftKey: true, bubbles: true }));
        })()"""
    )
    angles = "[document.querySelector('[data-mechanism] .angle').textContent, document.querySelector('[id=\"position.tool\"] .position').textContent]"
    mechanism, chart = browser.evaluate(angles)
    assert before == "90°" and mechanism == "100°" and chart == "angle of crank: 100.4°"


def test_one_chart_is_shown_and_buttons_choose_another(browser):
    shown = "['position', 'velocity', 'acceleration'].filter((what) => document.getElementById(what + '.tool').offsetHeight > 0)"
    assert browser.evaluate(shown) == ["position"]
    press = "[...document.getElementById('velocity.tool').closest('.chooser').querySelectorAll('.choices button')].find((button) => button.textContent === 'velocity').click()"
    browser.evaluate(press)
    assert browser.evaluate(shown) == ["velocity"]
    # It fits the room that it did not have while it was hidden.
    frames = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
    fits = f"{frames}.then(() => {{ const plot = document.querySelector('[id=\"velocity.tool\"] .plot'); return Math.abs(plot.querySelector('svg').viewBox.baseVal.width - plot.clientWidth); }})"
    assert browser.evaluate(fits) < 1
    assert browser.evaluate("document.documentElement.scrollWidth <= innerWidth")
    assert browser.diagnostics() == []

"""What if the unknown values were known: each value that was run gives the first chart its own band, and the outer band stays."""

import pathlib
import subprocess
import sys

import pytest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from chromium import Chromium  # noqa: E402

STORED = "JSON.parse(document.querySelector('[data-what-if] script').textContent)"
# Chooses a value on the map, then reads the inner and the outer band where the cursor stands.
CHOSEN = """((place) => {
    const holder = document.querySelector('[data-what-if]');
    const dot = holder.querySelectorAll('.map circle')[place];
    dot.dispatchEvent(new KeyboardEvent('keydown', { key: 'Enter', bubbles: true, cancelable: true }));
    const chart = document.getElementById(holder.dataset.whatIf);
    const read = (entry) => chart.querySelector(`[data-value="${entry}"]`).textContent;
    const path = (kind) => chart.querySelector(`.fill.${kind}`).getAttribute('d');
    return {
        isShown: !holder.hidden, words: holder.querySelector('.chosen').textContent, pressed: dot.getAttribute('aria-pressed'),
        inner: read(1), outer: read(0), innerPath: path('random'), outerPath: path('mixed'),
    };
})(%d)"""
MOVED = """(() => {
    const holder = document.getElementById('deviation.slider').querySelector('[data-chart]');
    const key = (name) => holder.dispatchEvent(new KeyboardEvent('keydown', { key: name, bubbles: true, cancelable: true }));
    key('ArrowRight');
    return [...document.querySelectorAll('[data-figure="deviation.slider"] .cursor')].length;
})()"""


def numbers(text):
    return [float(part.strip().split("\u202f")[0].replace("−", "-").split()[0]) for part in text.split("…")]


@pytest.fixture(scope="module")
def browser(tmp_path_factory):
    folder = tmp_path_factory.mktemp("what-if")
    subprocess.run([REPOSITORY / "target/debug/examples/report_pages", folder], check=True)
    with Chromium() as browser:
        browser.view(1280, reduced_motion=True)
        browser.open(str(folder / "study.html"))
        yield browser


def test_every_value_that_was_run_gives_its_own_band(browser):
    stored = browser.evaluate(STORED)
    assert browser.evaluate(MOVED) == 1
    # The cursor begins in the middle of the curve, and the arrow has moved it by one.
    row = len(stored["points"][0]["lower"]) // 2 + 1
    low, high = stored["range"]
    before = browser.evaluate(CHOSEN % 0)
    for place, point in enumerate(stored["points"]):
        now = browser.evaluate(CHOSEN % place)
        assert now["isShown"] and now["pressed"] == "true"
        assert now["words"].startswith(point["words"]) and f"counted from {point['runs']} runs" in now["words"]
        due = [low + point[end][row] / 9999 * (high - low) for end in ("lower", "upper")]
        # Read off to a thousandth of the axis; stored in 9999 steps of all bands.
        for found, value in zip(numbers(now["inner"]), due, strict=True):
            assert abs(found - value) < 1e-3 + 1e-4 * (high - low), (point["words"], now["inner"], due)
        assert now["outer"] == before["outer"] and now["outerPath"] == before["outerPath"]
    bands = {browser.evaluate(CHOSEN % place)["innerPath"] for place in range(len(stored["points"]))}
    assert len(bands) == len(stored["points"]), "each value has a band of its own"
    assert not browser.complaints()

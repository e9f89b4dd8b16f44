"""Charts that are enlarged: what they show fits into their height, dots and curves alike."""

import pathlib
import subprocess
import sys

import pytest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from chromium import Chromium  # noqa: E402

# Presses a key on a chart so many times.
KEY = """((chart, name, times, shiftKey) => {
    const holder = document.querySelector(`[data-chart="${chart}"]`);
    for (let time = 0; time < times; time += 1)
        holder.dispatchEvent(new KeyboardEvent('keydown', { key: name, shiftKey, bubbles: true, cancelable: true }));
})("%s", "%s", %d, true)"""
# Those dots of a chart that stand between the ends of its axis, and how far each is below the upper end and above the lower one, pixels.
DOTS = """((chart) => {
    const svg = document.querySelector(`[data-chart="${chart}"] svg`);
    const frame = svg.querySelector('clipPath rect');
    const [left, top, width, height] = ['x', 'y', 'width', 'height'].map((name) => Number(frame.getAttribute(name)));
    return [...svg.querySelectorAll('path.dots')].flatMap((path) => {
        const { a, d, e, f } = path.parentElement.transform.baseVal.consolidate().matrix;
        return [...path.getAttribute('d').matchAll(/M(\\S+) (\\S+)h0/g)]
            .map(([, x, y]) => [a * Number(x) + e, d * Number(y) + f])
            .filter(([x]) => x >= left && x <= left + width)
            .map(([, y]) => [y - top, top + height - y]);
    });
})("%s")"""
# The lowest and the highest place of a shown curve within the frame of its chart, pixels below the upper end and above the lower one.
CURVES = """((chart) => {
    const holder = document.querySelector(`[data-chart="${chart}"]`);
    const svg = holder.querySelector('svg');
    const frame = svg.querySelector('clipPath rect');
    const [left, top, width, height] = ['x', 'y', 'width', 'height'].map((name) => Number(frame.getAttribute(name)));
    return [...svg.querySelectorAll('path.line[data-of]')].filter((path) => getComputedStyle(path).display !== 'none').flatMap((path) => {
        const { a, d, e, f } = path.parentElement.transform.baseVal.consolidate().matrix;
        const points = [...path.getAttribute('d').matchAll(/[ML](\\S+?) ([\\d.-]+)/g)].map(([, x, y]) => [a * Number(x) + e, d * Number(y) + f]);
        const inside = points.filter(([x]) => x >= left && x <= left + width).map(([, y]) => y);
        // A level line has its ends alone.
        return inside.length === 0 ? [] : [[Math.min(...inside) - top, top + height - Math.max(...inside)]];
    });
})("%s")"""
PRESS = """document.querySelector('[data-chart="%s"]').closest('figure').querySelector('[data-entry="%d"]').click()"""


@pytest.fixture(scope="module")
def browser(tmp_path_factory):
    folder = tmp_path_factory.mktemp("charts")
    subprocess.run([REPOSITORY / "target/debug/examples/report_pages", folder], check=True)
    with Chromium() as browser:
        browser.view(1280, reduced_motion=True)
        browser.pages = folder
        yield browser


def test_dots_stay_inside_an_enlarged_chart(browser):
    browser.open(str(browser.pages / "simulation.html"))
    chart = "contact-force"
    seen = 0
    # Enlarged about many places: at most of them the curve has no sample where a dot is.
    for _ in range(40):
        browser.evaluate(KEY % (chart, "0", 1))
        browser.evaluate(KEY % (chart, "ArrowLeft", 1))
        browser.evaluate(KEY % (chart, "+", 5))
        dots = browser.evaluate(DOTS % chart)
        seen += len(dots)
        for above, below in dots:
            assert above >= 0 and below >= 0, (above, below)
    assert seen > 20
    assert not browser.diagnostics()


def test_a_curve_that_is_shown_again_has_room_in_an_enlarged_chart(browser):
    browser.open(str(browser.pages / "study.html"))
    chart = "deviation.slider"
    entries = browser.evaluate(f"""document.getElementById("{chart}").querySelectorAll('[data-entry]').length""")
    # The band for all unknown values and that of scatter alone are left: limits are wider than both.
    for entry in range(2, entries):
        browser.evaluate(PRESS % (chart, entry))
    browser.evaluate(KEY % (chart, "+", 3))
    whole = browser.evaluate(CURVES % chart)
    browser.evaluate(PRESS % (chart, 0))
    narrow = browser.evaluate(CURVES % chart)
    assert len(whole) == 4 and len(narrow) == 2
    assert narrow != whole[2:], "the narrow band fills the frame alone"
    browser.evaluate(PRESS % (chart, 0))
    assert browser.evaluate(CURVES % chart) == whole
    # Hidden before it was enlarged, shown afterwards.
    browser.evaluate(KEY % (chart, "0", 1))
    browser.evaluate(PRESS % (chart, 0))
    browser.evaluate(KEY % (chart, "+", 3))
    browser.evaluate(PRESS % (chart, 0))
    again = browser.evaluate(CURVES % chart)
    assert again == whole
    for above, below in again:
        assert above >= 0 and below >= 0, again
    assert not browser.diagnostics()

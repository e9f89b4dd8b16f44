"""The report of a study is a page that one forwards: its height before a section is opened, its sheets, its sections and its chooser."""

import pathlib
import subprocess
import sys

import pytest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from chromium import Chromium  # noqa: E402
from paper import Paper  # noqa: E402

SCREEN_PX = 800
# Screens before any section is opened, by the width of the window.
MOST_SCREENS = {1280: 4, 400: 6}
MOST_SHEETS = 4
HEIGHT = "document.documentElement.scrollHeight"
FRAMES = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))"
OPEN_SECTIONS = "[...document.querySelectorAll('.folds details.fold[open]')].map((fold) => fold.parentElement.id)"
SHOWN_ORBITS = """[...document.querySelectorAll('figure.orbit')].filter((figure) => figure.getClientRects().length > 0)
    .map((figure) => figure.querySelector('strong').textContent)"""
# Where the drawing and the middle of the plot are in the window, and whether the drawing is whole in it.
IN_VIEW = """(() => {
    const plot = document.querySelector('.opening [data-chart]').getBoundingClientRect();
    const drawing = document.querySelector('.opening .mechanism svg').getBoundingClientRect();
    return {
        isDrawingSeen: drawing.top >= 0 && drawing.bottom <= innerHeight && drawing.height > 80,
        isPlotSeen: plot.top < innerHeight && plot.bottom > 0,
        isPlotFree: drawing.right <= plot.left || drawing.left >= plot.right || drawing.bottom <= plot.top + plot.height / 2,
    };
})()"""


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    folder = tmp_path_factory.mktemp("folds")
    subprocess.run([REPOSITORY / "target/debug/examples/report_pages", folder], check=True)
    return folder


@pytest.fixture(scope="module")
def browser():
    with Chromium() as browser:
        yield browser


def opened(browser, page, width=1280, fragment=""):
    browser.view(width, SCREEN_PX, reduced_motion=True)
    browser.open(str(page), fragment)


def press(browser, *keys):
    """Keys as a person presses them."""
    codes = {"Tab": 9, "Enter": 13, "ArrowDown": 40}
    for key in keys:
        named = {"key": key, "code": key, "windowsVirtualKeyCode": codes[key]}
        text = {"text": "\r"} if key == "Enter" else {}
        browser.call("Input.dispatchKeyEvent", type="keyDown", **named, **text)
        browser.call("Input.dispatchKeyEvent", type="keyUp", **named)
    browser.evaluate(FRAMES)


@pytest.mark.parametrize("name", ["study", "lists"])
@pytest.mark.parametrize("width", MOST_SCREENS)
def test_the_closed_page_is_a_few_screens_high(pages, browser, name, width):
    opened(browser, pages / f"{name}.html", width)
    assert browser.evaluate(OPEN_SECTIONS) == []
    assert browser.evaluate(HEIGHT) <= MOST_SCREENS[width] * SCREEN_PX


@pytest.mark.parametrize("name", ["study", "lists"])
def test_four_sheets_are_printed_and_what_was_opened_comes_on_top(pages, browser, name, tmp_path):
    def sheets():
        browser.pdf(str(tmp_path / "page.pdf"))
        return len(Paper((tmp_path / "page.pdf").read_bytes()).sheets)

    opened(browser, pages / f"{name}.html")
    closed = sheets()
    assert closed <= MOST_SHEETS
    assert browser.evaluate(OPEN_SECTIONS) == [], "as it was before printing"
    browser.evaluate("document.querySelectorAll('.folds details.fold').forEach((fold) => { fold.open = true; })")
    assert sheets() > closed


def test_sections_open_by_keyboard_by_links_and_all_at_once(pages, browser):
    opened(browser, pages / "study.html")
    browser.evaluate("document.querySelector('#bounds summary').focus()")
    press(browser, "Enter")
    assert browser.evaluate(OPEN_SECTIONS) == ["bounds"]
    browser.evaluate("document.querySelector('#contributors-overview a').click()")
    browser.evaluate(FRAMES)
    assert sorted(browser.evaluate(OPEN_SECTIONS)) == ["bounds", "contributors"]
    browser.evaluate("document.querySelector('.fold-all button').click()")
    browser.evaluate(FRAMES)
    count = browser.evaluate("document.querySelectorAll('.folds > section').length")
    assert len(browser.evaluate(OPEN_SECTIONS)) == count
    assert browser.evaluate("document.querySelector('.fold-all button').textContent") == "Close all sections"
    opened(browser, pages / "study.html", fragment="#method")
    assert browser.evaluate(OPEN_SECTIONS) == ["method"]


def test_one_orbit_is_shown_and_the_keyboard_chooses_it(pages, browser):
    opened(browser, pages / "study.html", fragment="#orbits")
    names = browser.evaluate("[...document.querySelectorAll('figure.orbit strong')].map((title) => title.textContent)")
    assert len(names) > 1 and browser.evaluate(SHOWN_ORBITS) == names[:1]
    browser.evaluate("document.querySelector('[data-chooser] select').focus()")
    press(browser, "ArrowDown")
    assert browser.evaluate(SHOWN_ORBITS) == names[1:2]
    # Without scripts all of them are there.
    browser.run_scripts(False)
    try:
        opened(browser, pages / "study.html")
        assert browser.evaluate(SHOWN_ORBITS) == names
    finally:
        browser.run_scripts(True)


@pytest.mark.parametrize("width", MOST_SCREENS)
def test_the_drawing_stays_in_view_while_the_chart_is_pointed_at(pages, browser, width):
    opened(browser, pages / "study.html", width)
    browser.evaluate("document.documentElement.style.scrollBehavior = 'auto'")
    for block in ("start", "center", "end"):
        # As far down as the chart is still pointed at: its middle in the middle of the window at least.
        browser.evaluate(f"document.querySelector('.opening [data-chart]').scrollIntoView({{ block: '{block}' }})")
        if block == "start" and width == 400:
            # The drawing sticks above the chart: below it there is room for the chart.
            browser.evaluate("scrollBy(0, -document.querySelector('.opening .mechanism svg').getBoundingClientRect().height)")
        browser.evaluate(FRAMES)
        assert browser.evaluate(IN_VIEW) == {"isDrawingSeen": True, "isPlotSeen": True, "isPlotFree": True}, block


def test_bounds_are_lines_on_a_phone(pages, browser):
    opened(browser, pages / "study.html", 400, "#bounds")
    lines = browser.evaluate("""[...document.querySelectorAll('#bounds tbody td')].map((cell) => cell.parentElement).map((row) => {
        const [style, box] = [getComputedStyle(row.cells[0]), row.getBoundingClientRect()];
        return (box.height - parseFloat(style.paddingTop) - parseFloat(style.paddingBottom)) / parseFloat(style.lineHeight);
    })""")
    assert lines and max(lines) < 1.5, lines

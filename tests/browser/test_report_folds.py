"""Reports are pages that one forwards: their height before a section is opened, their sheets, their sections and their chooser; what stands
in them, whole and in one line."""

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
# A study, one with lists and several treatments, one with eight outputs: with the sheets that they take, at most.
STUDIES = {"study": 4, "lists": 4, "outputs": 4}
# Motions, one with two paths, one with a coupler, two in space, one of them over time; a run; a sweep.
OTHERS = dict.fromkeys(["motion", "four_bar", "coupler_path", "space", "space_over_time", "simulation", "sweep"], 2)
MOST_SHEETS = STUDIES | OTHERS
PAGES = list(MOST_SHEETS)
MOST_SENTENCES = 5
# Sentences of the answer: a point ends one where the next one begins.
SENTENCES = r"""[...document.querySelectorAll('.answer p, .answer li')].filter((words) => words.getClientRects().length > 0)
    .flatMap((words) => words.textContent.split(/(?<=\.) (?=[^a-z\s])/))"""
SHOWN = "[...document.querySelectorAll('%s')].filter((element) => !element.closest('details:not([open])')).length"
# Numbers that a line could part from their unit or their power of ten; files and commands are shown as they are.
PARTED = r"""(() => {
    const units = 'mm|µm|um|m|s|ms|µs|N|kN|J|W|rad|mrad|%|Hz|kHz|rpm|kg|deg|MPa|GPa|K';
    const parted = new RegExp('\\d (?:' + units + ')(?![\\w/-])|\\d [·×] ?10|N m(?![\\w])', 'g');
    const found = [];
    let count = 0;
    for (const block of document.querySelectorAll('p, li, td, th, dt, dd, label, figcaption, summary, h2, h3')) {
        if (block.closest('script, style, pre, svg, .numbers, .legend, .readout') || block.querySelector('p, li, td, pre, svg')) continue;
        count += 1;
        for (const match of block.textContent.matchAll(parted)) found.push(block.textContent.slice(Math.max(0, match.index - 20), match.index + 20));
    }
    return [count, found];
})()"""
# Words of drawings that the edge of their picture cuts, in each view and position.
CUT = """(async () => {
    const frames = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    const found = new Set();
    let count = 0;
    const look = (where) => document.querySelectorAll('figure:is(.space, .mechanism) svg').forEach((svg) => {
        const edge = svg.getBoundingClientRect();
        svg.querySelectorAll('text').forEach((text) => {
            count += 1;
            const box = text.getBoundingClientRect();
            if (box.width && (box.left < edge.left - 1 || box.right > edge.right + 1 || box.top < edge.top - 1 || box.bottom > edge.bottom + 1)) {
                found.add(where + ': ' + text.textContent);
            }
        });
    });
    look('first');
    for (const view of document.querySelectorAll('[data-space] .views button')) {
        view.click();
        const slider = view.closest('figure').querySelector('.pose');
        for (const share of [0, 0.3, 0.6, 1]) {
            slider.value = String(Math.round(share * Number(slider.max)));
            slider.dispatchEvent(new Event('input', { bubbles: true }));
            await frames();
            look(view.textContent);
        }
    }
    return [count, document.querySelectorAll('[data-space] .views button').length, [...found]];
})()"""
# What is left out of the paper, as the reader of a sheet sees it.
LEFT_OUT = """(() => {
    dispatchEvent(new Event('beforeprint'));
    const line = document.querySelector('.left-out');
    const found = line.hidden ? '' : line.textContent;
    dispatchEvent(new Event('afterprint'));
    return [found, line.hidden];
})()"""
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


@pytest.mark.parametrize("name", PAGES)
@pytest.mark.parametrize("width", MOST_SCREENS)
def test_the_closed_page_is_a_few_screens_high(pages, browser, name, width):
    opened(browser, pages / f"{name}.html", width)
    assert browser.evaluate(OPEN_SECTIONS) == []
    assert browser.evaluate(HEIGHT) <= MOST_SCREENS[width] * SCREEN_PX


@pytest.mark.parametrize("name", OTHERS)
def test_the_page_begins_with_few_sentences_one_table_and_one_chart(pages, browser, name):
    opened(browser, pages / f"{name}.html")
    assert 1 <= len(browser.evaluate(SENTENCES)) <= MOST_SENTENCES
    assert browser.evaluate(SHOWN % "table") == 1
    assert browser.evaluate(SHOWN % "main :is([data-chart], figure.section, figure.zone)") == 1


@pytest.mark.parametrize("name", PAGES)
def test_no_line_parts_a_number_from_its_unit(pages, browser, name):
    opened(browser, pages / f"{name}.html")
    count, found = browser.evaluate(PARTED)
    assert count > 10
    assert found == []


@pytest.mark.parametrize("width", MOST_SCREENS)
@pytest.mark.parametrize("name", ["motion", "space", "space_over_time"])
def test_names_in_drawings_are_whole(pages, browser, name, width):
    opened(browser, pages / f"{name}.html", width)
    browser.evaluate("document.querySelectorAll('details.fold').forEach((fold) => { fold.open = true; })")
    browser.evaluate(FRAMES)
    count, views, found = browser.evaluate(CUT)
    assert count > 0
    assert (views > 0) == name.startswith("space")
    assert found == []


def printed(browser, folder):
    browser.pdf(str(folder / "page.pdf"))
    return Paper((folder / "page.pdf").read_bytes())


@pytest.mark.parametrize("name", PAGES)
def test_paper_has_what_the_screen_has_and_names_the_rest(pages, browser, name, tmp_path):
    opened(browser, pages / f"{name}.html")
    closed = printed(browser, tmp_path)
    assert len(closed.sheets) <= MOST_SHEETS[name]
    assert closed.torn_rows() == [] and closed.lonely_heads() == []
    titles = browser.evaluate("[...document.querySelectorAll('details.fold > summary')].map((summary) => summary.textContent)")
    assert browser.evaluate(LEFT_OUT) == [
        f"Closed sections are not printed: {'; '.join(titles)}. “Open all sections” on the page prints them too.", True
    ]
    # What a reader opens comes on top.
    browser.evaluate("document.querySelector('.fold-all button').click()")
    browser.evaluate(FRAMES)
    assert browser.evaluate(LEFT_OUT) == ["", True]
    whole = printed(browser, tmp_path)
    assert len(whole.sheets) > len(closed.sheets)
    # The title, and a head for each section.
    assert len(whole.of_kind(b"H2")) >= len(closed.of_kind(b"H2")) + browser.evaluate("document.querySelectorAll('.folds > section').length")


def test_contributors_stand_on_the_first_sheet(pages, browser, tmp_path):
    opened(browser, pages / "study.html")
    paper = printed(browser, tmp_path)
    rows = paper.of_kind(b"TR")
    # The head and four inputs; no other table is open.
    assert len(rows) == 5
    assert [paper.sheets_of(row) for row in rows] == [{1}] * 5


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

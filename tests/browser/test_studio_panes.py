"""Around the canvas of the studio: panes and their splitters, the drawer of runs, the one place for problems, both texts; by mouse and by keys alone."""

import subprocess
import time

import pytest  # noqa: F401
from check_pages import AXE, seen_by_axe
from test_studio import PROGRAM, browser, studio  # noqa: F401
from test_studio_edit import open_small, press_mm, take_tool
from test_studio_journeys import Keyboard

# Left, top, width and height of the first element that a selector finds.
BOX = "(() => { const { x, y, width, height } = document.querySelector(%r).getBoundingClientRect(); return [x, y, width, height]; })()"
SPLITTER = "[...document.querySelectorAll('.splitter')].find((one) => one.getAttribute('aria-controls') === %r)"
# Of what moves while a study runs, nothing.
AT_REST = [".drawing .ground", ":is(.play-bar, .tool-options)", ".band", ".band svg", ".outline", ".side", ".status-bar"]


def box(studio, selector):  # noqa: F811
    return studio.browser.evaluate(BOX % selector)


def value(studio, pane):  # noqa: F811
    return studio.browser.evaluate(f"Number(({SPLITTER % pane}).getAttribute('aria-valuenow'))")


def mouse(studio, kind, place, **more):  # noqa: F811
    studio.browser.call("Input.dispatchMouseEvent", type=kind, x=place[0], y=place[1], **more)


def middle(studio, pane):  # noqa: F811
    return studio.browser.evaluate(f"(() => {{ const {{ x, y, width, height }} = ({SPLITTER % pane}).getBoundingClientRect(); return [x + width / 2, y + height / 2]; }})()")


def pull(studio, pane, by):  # noqa: F811
    """Drags the line beside a pane."""
    x, y = middle(studio, pane)
    mouse(studio, "mousePressed", (x, y), button="left", clickCount=1)
    for share in (0.3, 0.7, 1):
        mouse(studio, "mouseMoved", (x + share * by[0], y + share * by[1]), button="left", buttons=1)
    mouse(studio, "mouseReleased", (x + by[0], y + by[1]), button="left", clickCount=1)


def reload(studio):  # noqa: F811
    studio.browser.reload()
    studio.wait("document.querySelector('svg.chart') && document.querySelector('.field')")
    studio.settle()


def test_the_canvas_has_three_fifths_of_the_width_and_all_is_seen_at_once(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    studio.take("rank, coupler and rocker")
    assert box(studio, ".drawing .ground")[2] >= 0.6 * 1280
    assert box(studio, ".drawing .ground")[3] >= 0.4 * 800
    foot = box(studio, ".status-bar")
    assert foot[1] + foot[3] == 800
    for selector in (".drawing .ground", ".play-bar", ".band svg", ".band .largest", ".band .kept"):
        _, top, _, height = box(studio, selector)
        assert 0 <= top and top + height <= foot[1], selector
    studio.browser.view(1440, 900, reduced_motion=True)
    studio.wait("innerWidth === 1440")
    assert box(studio, ".drawing .ground")[2] >= 0.6 * 1440
    # A drag, a tool and its hints leave the canvas as large as it is.
    before = box(studio, ".drawing .ground")
    take_tool(studio, "link")
    assert box(studio, ".drawing .ground") == before
    assert studio.browser.diagnostics() == []


def test_a_splitter_is_moved_by_keys_and_set_back(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    studio.take("rank, coupler and rocker")
    keyboard = Keyboard(studio)
    keyboard.reach(".splitter")
    assert studio.browser.evaluate(f"document.activeElement === {SPLITTER % 'outline'}"), "after the outline comes its line"
    first = value(studio, "outline")
    width = box(studio, ".outline")[2]
    for _ in range(3):
        keyboard.press("ArrowRight")
    assert value(studio, "outline") == first + 3
    assert box(studio, ".outline")[2] == pytest.approx(width + 0.03 * 1280, abs=1)
    keyboard.press("End")
    assert box(studio, ".outline")[2] == pytest.approx(0.3 * 1280, abs=1)
    keyboard.press("Home")
    assert box(studio, ".outline")[2] == pytest.approx(150, abs=1), "so narrow it can be read"
    keyboard.press("Enter")
    assert (value(studio, "outline"), box(studio, ".outline")[2]) == (first, width)
    keyboard.reach(".splitter[aria-controls=chart]")
    height = box(studio, ".band")[3]
    keyboard.press("ArrowUp")
    keyboard.press("ArrowUp")
    assert box(studio, ".band")[3] > height + 10
    assert studio.browser.diagnostics() == []


def test_a_splitter_is_dragged_and_stays_there_over_a_reload(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    studio.take("rank, coupler and rocker")
    side, chart = box(studio, ".side")[2], box(studio, ".band")[3]
    pull(studio, "side", (-120, 0))
    pull(studio, "chart", (0, 60))
    wider = [box(studio, ".side")[2], box(studio, ".band")[3]]
    assert wider == pytest.approx([side + 120, chart - 60], abs=2)
    reload(studio)
    assert [box(studio, ".side")[2], box(studio, ".band")[3]] == pytest.approx(wider, abs=0.5)
    # Half of the width, and no more.
    pull(studio, "side", (-700, 0))
    assert box(studio, ".side")[2] == pytest.approx(640, abs=1)
    x, y = middle(studio, "side")
    for clicks in (1, 2):
        mouse(studio, "mousePressed", (x, y), button="left", clickCount=clicks)
        mouse(studio, "mouseReleased", (x, y), button="left", clickCount=clicks)
    assert box(studio, ".side")[2] == pytest.approx(side, abs=0.5)
    # The canvas fits its new size: all pins are on it.
    left, top, width, height = box(studio, ".drawing .ground")
    for joint in ("crank_pivot", "rocker_pin", "rocker_pivot"):
        x, y = studio.pin(joint)
        assert left < x < left + width and top < y < top + height, joint
    assert studio.browser.diagnostics() == []


def test_panes_are_one_below_the_other_on_a_phone(studio):  # noqa: F811
    studio.browser.view(400, 800, reduced_motion=True)
    studio.take("rank, coupler and rocker")
    assert studio.browser.evaluate("[...document.querySelectorAll('.splitter')].every((one) => one.getClientRects().length === 0)")
    tops = [box(studio, selector)[1] for selector in (".bar", ".status-bar", ".outline", ".drawing", ".play-bar", ".band", ".side")]
    assert tops == sorted(tops)
    assert studio.browser.evaluate("document.documentElement.scrollWidth") <= 400


def test_a_run_pushes_nothing_and_its_list_opens_over_the_stage(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    folder = studio.folder / "mine"
    subprocess.run([PROGRAM, "new", "four-bar", folder], check=True, capture_output=True)
    studio.open()
    studio.click("a, button", "four-bar with play")
    studio.wait("document.querySelector('svg.chart') && document.querySelector('.field')")
    studio.settle()

    def boxes():
        # The keyboard scrolls the chart's pane to what it reaches.
        studio.browser.evaluate("(document.querySelector('.band').scrollTop = 0, true)")
        return {selector: box(studio, selector) for selector in AT_REST}

    before = boxes()
    studio.click("button", "Save and run")
    studio.wait("document.querySelector('.runs > progress')?.value > 0", 120)
    assert boxes() == before, "while it runs"
    keyboard = Keyboard(studio)
    keyboard.reach(".runs > button.plain")
    keyboard.press("Enter")
    studio.wait("document.querySelector('#runs-list .coarse svg')", 120)
    assert boxes() == before, "while its list is open"
    top, foot = box(studio, "#runs-list")[1], before[".status-bar"][1]
    assert before[".drawing .ground"][1] < top < foot
    reload(studio)
    assert studio.browser.evaluate("document.querySelector('#runs-list').getClientRects().length > 0"), "it is open as it was left"
    keyboard.reach("#runs-list summary, #runs-list button")
    keyboard.press("Escape")
    assert studio.browser.evaluate("document.querySelector('#runs-list').getClientRects().length === 0")
    assert studio.browser.evaluate("document.activeElement.matches('.runs > button.plain')"), "the keyboard is at the button that opens it"
    studio.click(".runs > button", "Cancel")
    studio.wait("document.querySelector('.runs .now').innerText.includes('stopped')", 60)
    assert boxes() == before
    reload(studio)
    assert studio.browser.evaluate("document.querySelector('#runs-list').getClientRects().length === 0")
    assert studio.browser.diagnostics() == []


def test_one_missing_constraint_is_said_once_with_its_ways_out(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    open_small(studio, "four-bar")
    before = [box(studio, selector) for selector in AT_REST]
    take_tool(studio, "link")
    press_mm(studio, 200, 230)
    press_mm(studio, 330, 250)
    # As long as a tool is in use it is no error, but what is left to do: one line, which opens the ways out.
    studio.wait("document.querySelector('.problems button.counted')?.innerText.includes('degrees of freedom too many')")
    assert studio.browser.evaluate("document.querySelector('.problems .above')") is None
    # What is spoken follows once a second.
    studio.wait("[...document.querySelectorAll('.unseen[role=status]')].some((one) => one.innerText.includes('does not move yet'))")
    said = studio.browser.evaluate("document.body.innerText")
    assert said.count("of freedom") == 1 and "error" not in said, said
    studio.click(".problems button.counted")
    studio.wait("document.querySelector('.problems .message')?.innerText.includes('degrees of freedom too many')")
    said = studio.browser.evaluate("document.body.innerText")
    assert said.count("of freedom") == 1, said
    assert said.count("E0701") == 1
    assert [box(studio, selector) for selector in AT_REST if selector != ".band svg"] == before[:3] + before[4:], "nothing is pushed"
    # The list lies below the canvas.
    canvas = box(studio, ".drawing .ground")
    assert box(studio, ".problems .above")[1] >= canvas[1] + canvas[3]
    # Without a tool it is one: the list opens, its count stays where it is put away, and leads to the problem.
    studio.click(".problems button.counted", "1 error")
    studio.wait("document.querySelector('.problems .above') === null")
    studio.browser.evaluate("(document.activeElement.blur(), true)")
    # The next link that has begun ends, then the tool is put away.
    studio.key("Escape")
    studio.key("Escape")
    studio.wait("document.querySelector('.problems button.counted').innerText.includes('1 error')")
    studio.click(".problems button.counted", "1 error")
    studio.wait("document.activeElement.closest('.problem') !== null")
    studio.click(".problem button.remedy", "Place the motor")
    studio.wait("document.querySelector('.tools.build input[value=motor]').checked")
    assert studio.browser.diagnostics() == []


def test_what_is_missing_is_cut_short_in_a_narrow_window(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    open_small(studio, "four-bar")
    take_tool(studio, "link")
    press_mm(studio, 200, 230)
    press_mm(studio, 330, 250)
    studio.wait("document.querySelector('.problems .missing')?.innerText.includes('degrees of freedom too many')")
    studio.browser.view(400, 800, reduced_motion=True)
    time.sleep(0.3)
    assert studio.browser.evaluate("document.documentElement.scrollWidth") <= 400
    assert studio.browser.diagnostics() == []


def test_the_words_of_a_drag_cover_nothing_and_have_no_names_of_the_file(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    studio.take("rank, coupler and rocker")
    canvas = box(studio, ".drawing .ground")
    x, y = studio.drag("crank_pin", (45, -30), is_let_go=False)
    studio.wait("document.querySelector('.drawing .over')?.innerText.includes('crank length')")
    _, top, _, height = box(studio, ".drawing .over")
    assert top >= canvas[1] + canvas[3] and height < 40
    assert box(studio, ".drawing .ground") == canvas
    assert "_" not in studio.browser.evaluate("document.querySelector('.drawing .over').innerText")
    studio.key("Escape")
    mouse(studio, "mouseReleased", (x, y), button="left", clickCount=1)
    studio.wait_until_saved()


def test_both_texts_stand_beside_the_canvas_and_no_line_goes_beyond_them(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    studio.take("rank, coupler and rocker")
    canvas = box(studio, ".drawing .ground")
    keyboard = Keyboard(studio)
    keyboard.reach("[role=tab]", "Numbers")
    keyboard.press("ArrowLeft")
    studio.wait("document.querySelectorAll('.cm-content').length === 2")
    assert studio.browser.evaluate("document.querySelector('#tab-both').ariaSelected") == "true"
    seen = "[...document.querySelectorAll('.cm-scroller')].map((one) => [one.scrollWidth - one.clientWidth, one.getBoundingClientRect().height])"
    time.sleep(0.3)
    for beyond, height in studio.browser.evaluate(seen):
        assert beyond == 0 and height > 200
    assert box(studio, ".drawing .ground") == canvas
    # What is typed in one of them is a text that can be saved, with both in sight.
    studio.browser.evaluate("(document.querySelector('#text-study .cm-content').focus(), true)")
    studio.browser.call("Input.insertText", text="# tried ")
    assert studio.saved("four-bar")[1].startswith("# tried ")
    keyboard.reach(".splitter[aria-controls=text-study]")
    height = box(studio, "#text-study")[3]
    keyboard.press("ArrowUp")
    assert box(studio, "#text-study")[3] > height
    assert studio.browser.diagnostics() == []


@pytest.mark.parametrize("width", [1280, 400])
@pytest.mark.parametrize("dark", [False, True])
def test_panes_problems_runs_and_texts_are_accessible(studio, width, dark):  # noqa: F811
    axe = AXE.read_text()
    studio.browser.view(width, 800, dark=dark, reduced_motion=True)
    open_small(studio, "four-bar")
    studio.click("button", "Save and run")
    studio.wait("document.querySelector('.runs a')?.textContent.includes('Open the report')", 300)
    studio.click(".runs > button.plain")
    assert seen_by_axe(studio.browser, axe) == [], "runs"
    studio.key("Escape")
    studio.click("[role=tab]", "Both texts")
    studio.wait("document.querySelectorAll('.cm-content').length === 2")
    assert seen_by_axe(studio.browser, axe) == [], "texts"
    studio.click("[role=tab]", "Numbers")
    studio.type_number("crank_length", "80 mn")
    studio.wait("document.querySelector('.problems button.counted')")
    if width == 400:
        studio.click(".problems button.counted")
    studio.click(".problem button", "Explain")
    studio.wait("document.querySelector('.explanation').innerText.length > 100")
    assert seen_by_axe(studio.browser, axe) == [], "problems"

"""Help where it is needed: a sentence for every term, the list of keys, the steps of a first visit, examples in empty places."""

import re
import time

import pytest  # noqa: F401
from check_pages import AXE, seen_by_axe
from test_studio import REPOSITORY, browser, studio  # noqa: F401
from test_studio_journeys import Keyboard

# The sentence that is shown now.
SHOWN = "[...document.querySelectorAll('.term .meaning')].filter((one) => one.matches(':popover-open')).map((one) => one.innerText)"
TERM = "[...document.querySelectorAll('.term button')].find((one) => one.innerText === %r)"
CARD = "document.querySelector('.first-visit')"
DONE = "document.querySelectorAll('.first-visit .done').length"

# Nothing in it has play or a tolerance.
RIGID = """name = "rigid crank"

[body.ground]
points = { pivot = ["0 mm", "0 mm"] }

[body.crank]
points = { pivot = ["0 mm", "0 mm"], tip = ["30 mm", "0 mm"] }
mass = "1 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["10 mm", "0 mm"]

[joint.pivot]
kind = "revolute"
bearing = "ground.pivot"
journal = "crank.pivot"

[drive.crank]
joint = "pivot"
speed = "60 rpm"
start_angle = "0 deg"

[cycle]
drive = "crank"
transient_turns = 1
recorded_turns = 1

[output.tip]
position_of = "crank.tip"
along = "x"
"""


def glossary():
    """The terms of the report with their sentences."""
    source = (REPOSITORY / "crates/loosepin-report/src/words/glossary.rs").read_text()
    found = re.findall(r'\(\s*"([^"]*)",\s*"((?:[^"\\]|\\\n)*)",?\s*\)', source)
    return {term: re.sub(r"\\\n\s*", "", sentence) for term, sentence in found}


def middle(studio, element):  # noqa: F811
    return studio.browser.evaluate(f"(() => {{ const {{ x, y, width, height }} = ({element}).getBoundingClientRect(); return [x + width / 2, y + height / 2]; }})()")


def point(studio, place):  # noqa: F811
    studio.browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=place[0], y=place[1])


def test_a_term_has_the_sentence_of_the_report_under_the_pointer(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    studio.take("rank, coupler and rocker")
    deviation = glossary()["Deviation"]
    assert deviation.startswith("Actual position minus")
    word = middle(studio, TERM % "Deviation")
    point(studio, word)
    studio.wait(f"({SHOWN}).length === 1")
    assert studio.browser.evaluate(SHOWN) == [deviation]
    # It can be pointed at itself, and stays.
    note = middle(studio, "document.querySelector('.meaning:popover-open')")
    for share in (0.3, 0.6, 1):
        point(studio, [a + share * (b - a) for a, b in zip(word, note, strict=True)])
    time.sleep(0.5)
    assert studio.browser.evaluate(SHOWN) == [deviation]
    # Escape puts it away where the pointer is, and nothing else.
    studio.key("Escape")
    assert studio.browser.evaluate(SHOWN) == []
    point(studio, (600, 300))
    point(studio, word)
    studio.wait(f"({SHOWN}).length === 1")
    point(studio, (600, 300))
    studio.wait(f"({SHOWN}).length === 0")
    assert studio.browser.diagnostics() == []


def test_a_term_is_read_by_keyboard_and_by_tap(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    studio.take("rank, coupler and rocker")
    keyboard = Keyboard(studio)
    keyboard.reach(".term button", "Joints")
    assert studio.browser.evaluate(SHOWN)[0].startswith("Connects two bodies")
    described = "document.getElementById(document.activeElement.getAttribute('aria-describedby')).innerText"
    assert studio.browser.evaluate(described) == studio.browser.evaluate(SHOWN)[0]
    keyboard.press("Escape")
    assert studio.browser.evaluate(SHOWN) == []
    assert studio.browser.evaluate("document.activeElement.innerText") == "Joints", "the keyboard stays"
    keyboard.press("Enter")
    assert len(studio.browser.evaluate(SHOWN)) == 1
    keyboard.press("Tab")
    assert not any("Connects two bodies" in one for one in studio.browser.evaluate(SHOWN))
    # A finger.
    studio.browser.view(400, 800, reduced_motion=True)
    studio.browser.evaluate(f"(({TERM % 'without dynamics'}).scrollIntoView({{ block: 'center' }}), true)")
    time.sleep(0.2)
    x, y = middle(studio, TERM % "without dynamics")
    studio.browser.call("Emulation.setTouchEmulationEnabled", enabled=True)
    for kind, points in (("touchStart", [{"x": x, "y": y}]), ("touchEnd", [])):
        studio.browser.call("Input.dispatchTouchEvent", type=kind, touchPoints=points)
    studio.wait(f"({SHOWN})[0]?.startsWith('Computed without inertia')")
    left, right = studio.browser.evaluate("(() => { const { left, right } = document.querySelector('.meaning:popover-open').getBoundingClientRect(); return [left, right]; })()")
    assert 0 <= left and right <= 400
    for kind, points in (("touchStart", [{"x": 200, "y": 20}]), ("touchEnd", [])):
        studio.browser.call("Input.dispatchTouchEvent", type=kind, touchPoints=points)
    studio.wait(f"({SHOWN}).length === 0")
    studio.browser.call("Emulation.setTouchEmulationEnabled", enabled=False)
    assert studio.browser.diagnostics() == []


def test_terms_stand_in_outline_chart_and_chosen_pin(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    studio.take("rank, coupler and rocker")
    studio.click(".outline button", "rocker_pin")
    studio.wait("document.querySelector('.chosen .known')")
    terms = "[...document.querySelectorAll(%r)].map((one) => one.innerText)"
    named = lambda place: studio.browser.evaluate(terms % f"{place} .term button")  # noqa: E731
    assert set(named(".outline")) >= {"Bodies", "Joints", "Drives", "Outputs", "1 degree of freedom, 1 drive", "play 0.3 mm"}
    assert set(named(".band")) >= {"Deviation", "without dynamics", "Contributions of tolerances and play to the band"}
    assert set(named(".legend")) >= {"±2 standard deviations of play and parts"}
    assert set(named(".chosen")) >= {"Radial play", "Unknown: any value in this range"}
    empty = studio.browser.evaluate("[...document.querySelectorAll('.meaning')].filter((one) => one.textContent.trim().length < 20).length")
    assert empty == 0


def test_the_list_of_keys_is_opened_by_a_key_and_says_all_groups(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    studio.take("rank, coupler and rocker")
    keyboard = Keyboard(studio)
    is_open = "document.querySelector('details.keys').open"
    keyboard.press("?")
    assert studio.browser.evaluate(is_open)
    groups = studio.browser.evaluate("[...document.querySelectorAll('.keys section')].map((one) => [one.querySelector('h2').innerText, one.querySelectorAll('dt').length])")
    assert [name for name, _ in groups] == ["Canvas", "Parts of the drawing", "Tools", "Texts and numbers", "Panes", "Pages"]
    assert all(count > 0 for _, count in groups)
    keys = studio.browser.evaluate("[...document.querySelectorAll('.keys dt')].map((one) => one.innerText)")
    for key in ("Space", "[", "]", "+", "0", "V", "L", "D", "Ctrl+S", "Ctrl+Z", "?", "/", "Escape"):
        assert key in keys, key
    _, top, _, height = studio.browser.evaluate("(() => { const { x, y, width, height } = document.querySelector('.keys .sheet').getBoundingClientRect(); return [x, y, width, height]; })()")
    assert top + height <= 800
    keyboard.press("Escape")
    assert not studio.browser.evaluate(is_open)
    # What the list says is what the keys do.
    angle = "document.querySelector('.play-bar .angle').innerText"
    first = studio.browser.evaluate(angle)
    studio.browser.evaluate("document.activeElement.blur()")
    keyboard.press("]")
    assert studio.browser.evaluate(angle) != first
    keyboard.press("[")
    assert studio.browser.evaluate(angle) == first
    keyboard.press("l")
    assert studio.browser.evaluate("document.querySelector('.tools.build input[value=link]').checked")
    keyboard.press("Escape")
    # Who types by voice switches single keys off.
    studio.click(".keys summary")
    studio.click(".keys input[type=checkbox]")
    keyboard.press("Escape")
    studio.browser.evaluate("document.activeElement.blur()")
    keyboard.press("?")
    assert not studio.browser.evaluate(is_open)
    assert studio.browser.diagnostics() == []


def test_the_steps_of_a_first_visit_are_ticked_when_they_are_done(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    point(studio, (1270, 790))
    studio.take("rank, coupler and rocker")
    assert studio.browser.evaluate(f"{CARD} !== null && {DONE} === 0")
    # The pointer goes through it.
    x, y = middle(studio, CARD)
    assert studio.browser.evaluate(f"document.elementFromPoint({x}, {y}).closest('.first-visit') === null")
    place = studio.drag("crank_pin", (20, -10), is_let_go=False)
    studio.wait(f"{DONE} === 1")
    studio.browser.call("Input.dispatchMouseEvent", type="mouseReleased", x=place[0], y=place[1], button="left", clickCount=1)
    studio.settle()
    studio.click(".outline button", "rocker_pin")
    studio.wait("document.querySelector('.chosen .known input')")
    studio.browser.evaluate("(document.querySelector('.chosen .known input').focus(), document.querySelector('.chosen .known input').select(), true)")
    studio.browser.call("Input.insertText", text="0.05..0.2 mm")
    studio.key("Enter")
    studio.wait(f"{DONE} === 2")
    point(studio, middle(studio, "document.querySelector('.band svg')"))
    studio.wait(f"{DONE} === 3")
    studio.click("button", "Save")
    studio.wait_until_saved()
    studio.browser.reload()
    studio.wait("document.querySelector('svg.chart')")
    assert studio.browser.evaluate(f"{CARD} === null"), "it is seen"
    assert studio.browser.diagnostics() == []


def test_the_first_steps_are_closed_for_good(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    studio.take("rank, coupler and rocker")
    keyboard = Keyboard(studio)
    keyboard.reach(".first-visit button")
    keyboard.press("Enter")
    studio.wait(f"{CARD} === null")
    studio.browser.reload()
    studio.wait("document.querySelector('svg.chart')")
    assert studio.browser.evaluate(f"{CARD} === null")


def test_an_empty_chart_opens_an_example(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    folder = studio.folder / "rigid"
    folder.mkdir()
    (folder / "model.toml").write_text(RIGID)
    studio.open()
    studio.click("a, button", "rigid crank")
    studio.wait("document.querySelector('.band')?.innerText.includes('No output has a deviation')")
    studio.click(".band a", "Open an example: slider-crank")
    studio.wait("document.querySelector('svg.chart') && document.querySelector('h1').innerText.length > 0 && location.hash.includes('slider-crank')")
    assert not (studio.folder / "slider-crank").exists(), "it is looked at before anything is written"


@pytest.mark.parametrize("width", [1280, 400])
@pytest.mark.parametrize("dark", [False, True])
def test_help_is_accessible(studio, width, dark):  # noqa: F811
    axe = AXE.read_text()
    studio.browser.view(width, 800, dark=dark, reduced_motion=True)
    studio.take("rank, coupler and rocker")
    studio.click(".band .term button", "Deviation")
    studio.wait(f"({SHOWN}).length === 1")
    assert seen_by_axe(studio.browser, axe) == [], "term and first steps"
    studio.key("Escape")
    studio.click(".keys summary")
    studio.wait("document.querySelector('details.keys').open")
    assert seen_by_axe(studio.browser, axe) == [], "keys"

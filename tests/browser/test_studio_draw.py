"""A mechanism drawn on an empty sheet, in the one editor: by mouse with counted clicks, by keys alone, and over a reload."""

import subprocess
import time

from test_studio import PROBLEMS, PROGRAM, browser, studio  # noqa: F401
from test_studio_edit import HINT, MOBILITY, enter_target, press, press_mm, press_target, undo

SHIFT = 8
OUTLINE = "document.querySelector('.outline').innerText"
# An output whose zone is drawn about its path.
ZONE = "document.querySelector('.drawing .zone-of-path')?.getAttribute('d')"


class Hand:
    """A mouse that counts its clicks."""

    def __init__(self, studio):
        self.studio = studio
        self.clicks = 0

    def button(self, selector, text=None):
        place = self.studio.browser.evaluate(f"""(() => {{
            const found = [...document.querySelectorAll({selector!r})].find((one) => one.textContent.includes({text or ''!r}));
            found.scrollIntoView({{ block: 'nearest' }});
            const box = found.getBoundingClientRect();
            return [box.left + box.width / 2, box.top + box.height / 2];
        }})()""")
        self.place(place)

    def mm(self, x, y, modifiers=0):
        self.clicks += 1
        press_mm(self.studio, x, y, modifiers)

    def place(self, place):
        self.clicks += 1
        press(self.studio, place)


def new_sheet(studio):
    studio.open()
    studio.wait("[...document.querySelectorAll('button')].some((one) => one.textContent.includes('Draw from nothing'))")


def wait_for_sheet(studio):
    studio.wait("document.querySelector('.tools.build input[value=link]')?.checked && document.querySelector('.drawing svg')")


def test_a_four_bar_with_its_coupler_curve_and_zone_in_ten_clicks(studio):  # noqa: F811
    studio.browser.view(1280, 800)
    new_sheet(studio)
    hand = Hand(studio)
    hand.button("button", "Draw from nothing")
    wait_for_sheet(studio)
    assert "No problems" in studio.browser.evaluate(PROBLEMS), "an empty sheet is no error"
    # Crank, coupler, rocker: the first pin is on the ground by itself, the last one by Shift.
    for place in [(0, 0), (20, 40), (120, 80)]:
        hand.mm(*place)
    hand.mm(140, 0, SHIFT)
    studio.wait(f"({OUTLINE}).includes('link_3')")
    studio.wait(f"({MOBILITY}).includes('1 degree of freedom, 1 drive')")
    # A point beside the coupler, of which the path is recorded.
    hand.button(".tools.build label", "Record")
    hand.mm(70, 60)
    studio.wait(f"{HINT}.includes('link_2')")
    hand.mm(60, 100)
    studio.wait("document.querySelector('.drawing .trace')")
    # The play of the pin between crank and coupler, typed where it is.
    studio.key("Escape")
    hand.mm(20, 40)
    studio.wait("[...document.querySelectorAll('.drawing text.editable')].some((one) => one.textContent === 'play none')")
    hand.place(studio.browser.evaluate("""(() => {
        const text = [...document.querySelectorAll('.drawing text.editable')].find((one) => one.textContent === 'play none');
        const box = text.getBoundingClientRect();
        return [box.left + box.width / 2, box.top + box.height / 2];
    })()"""))
    studio.wait("document.querySelector('.in-place input') === document.activeElement")
    studio.browser.call("Input.insertText", text="0,05..0,2 mm")
    studio.key("Enter")
    studio.wait(f"({ZONE} ?? '').length > 100")
    # The zone at the crank angle, about the point itself, magnified as said.
    studio.wait("document.querySelector('.drawing .zones-now .zone[data-point=\"link_2.p1\"]')?.getAttribute('d').length > 100")
    assert "zone of the path × " in studio.browser.evaluate("document.querySelector('.drawing .scale-bar').innerText")
    assert hand.clicks <= 10, hand.clicks
    studio.wait("document.querySelector('svg.chart')")
    studio.settle()
    assert "No problems" in studio.browser.evaluate(PROBLEMS)
    model, study = studio.saved("drawn")
    # From (20, 40) to (120, 80), by Pythagoras, but for the thousandth of a millimetre to which the crank is written.
    assert 'link_2_length = "107.70' in model and 'path_of = "link_2.p1"' in model
    assert '"joint.link_2_a.radial_clearance" = { interval = ["0.05 mm", "0.2 mm"] }' in study and 'output = "p1"' in study
    done = subprocess.run([PROGRAM, "check", "drawn/model.toml", "drawn/study.toml"], cwd=studio.folder, capture_output=True, text=True)
    assert done.returncode == 0 and "1 degree of freedom" in done.stdout, done.stdout + done.stderr
    # Each link, the recorded point and the play are one step each.
    undo(studio, 5)
    studio.wait(f"!({OUTLINE}).includes('link_1')")
    assert studio.browser.diagnostics() == []


def test_a_typed_place_is_the_point_that_lies_there(studio):  # noqa: F811
    new_sheet(studio)
    studio.click("button", "Draw from nothing")
    wait_for_sheet(studio)

    def place(text, modifiers=0):
        studio.browser.evaluate("(document.querySelector('.tool-options .place').focus(), true)")
        studio.browser.call("Input.insertText", text=text)
        studio.key("Enter", modifiers)

    place("0, 0")
    place("20, 40")
    studio.wait(f"({OUTLINE}).includes('link_1')")
    studio.wait(f"{HINT}.includes('click link_1.b again')")
    studio.browser.evaluate("(document.querySelector('.drawing .ground').focus(), true)")
    studio.key("Escape")
    studio.wait(f"!{HINT}.includes('click link_1.b again')")
    place("60, 0", SHIFT)
    place("20, 40")
    studio.wait(f"({OUTLINE}).includes('link_2')")
    # Both links have one pin there: a triangle that cannot move.
    studio.wait(f"({PROBLEMS}).includes('block one another')")
    assert studio.browser.diagnostics() == []


def test_the_same_by_keys_alone(studio):  # noqa: F811
    new_sheet(studio)
    studio.browser.evaluate("([...document.querySelectorAll('button')].find((one) => one.textContent.includes('Draw from nothing')).focus(), true)")
    studio.browser.call("Input.dispatchKeyEvent", type="keyDown", key="Enter", code="Enter", windowsVirtualKeyCode=13, text="\r")
    wait_for_sheet(studio)
    # The canvas has the focus; places are typed in the field of the tool, or taken by the cross that the arrows move.
    studio.browser.evaluate("(document.querySelector('.tool-options .place').focus(), true)")

    def place(text, modifiers=0):
        studio.browser.call("Input.insertText", text=text)
        studio.key("Enter", modifiers)

    for text in ("0, 0", "20 40", "120; 80"):
        place(text)
    place("140, 0", SHIFT)
    studio.wait(f"({OUTLINE}).includes('link_3')")
    studio.wait(f"({MOBILITY}).includes('1 degree of freedom, 1 drive')")
    place("140 0 0")
    studio.wait("document.querySelector('.tool-options .wrong')?.innerText.includes('two numbers')")
    # The coupler is chosen in the outline, so that it is meant at a pin of two links: it gets a point beside it.
    studio.browser.evaluate("([...document.querySelectorAll('.outline button')].find((one) => one.textContent.trim() === 'link_2').focus(), true)")
    studio.browser.call("Input.dispatchKeyEvent", type="keyDown", key="Enter", code="Enter", windowsVirtualKeyCode=13, text="\r")
    studio.wait("document.querySelector('#part-heading')?.innerText === 'link_2'")
    studio.key("p")
    enter_target(studio, "link_2.a")
    studio.wait("document.querySelector('.tool-options .place')")
    studio.browser.evaluate("(document.querySelector('.tool-options .place').focus(), true)")
    place("60, 100")
    studio.browser.evaluate("(document.querySelector('.drawing .ground').focus(), true)")
    studio.key("r")
    studio.wait("document.querySelector('.tools.build input[value=record]').checked")
    enter_target(studio, "link_2.p1")
    studio.wait("document.querySelector('.drawing .trace')")
    studio.key("v")
    studio.wait("document.querySelector('.drawing .grip.joint')")
    studio.browser.evaluate("([...document.querySelectorAll('.drawing .grip')].find((one) => one.dataset.joint === 'link_2_a').focus(), true)")
    studio.key("Enter")
    studio.wait("[...document.querySelectorAll('.drawing text.editable')].some((one) => one.textContent === 'play none')")
    studio.browser.evaluate("([...document.querySelectorAll('.drawing text.editable')].find((one) => one.textContent === 'play none').focus(), true)")
    studio.key("Enter")
    studio.wait("document.querySelector('.in-place input') === document.activeElement")
    studio.browser.call("Input.insertText", text="0.05..0.2")
    studio.key("Enter")
    studio.wait(f"({ZONE} ?? '').length > 100")
    assert 'link_2_length = "107.70' in studio.saved("drawn")[0]
    assert studio.browser.diagnostics() == []


def test_a_link_ends_on_the_ground_by_a_second_click_and_takes_a_known_length(studio):  # noqa: F811
    new_sheet(studio)
    studio.click("button", "Draw from nothing")
    wait_for_sheet(studio)
    press_mm(studio, 0, 0)
    press_mm(studio, 0, 50)
    studio.wait(f"{HINT}.includes('click link_1.b again to pin it')")
    studio.wait("[...document.querySelectorAll('.drawing text.dimension')].some((one) => one.textContent === '50 mm')")
    # Near the length of the first link: it takes that length, and says so.
    studio.browser.call("Input.dispatchMouseEvent", type="mouseMoved", **dict(zip("xy", studio.browser.evaluate(
        "(({ x, y }) => [x, y])(new DOMPoint(30.5, -90.5).matrixTransform(document.querySelector('.drawing svg').getScreenCTM()))"), strict=True)))
    studio.wait("document.querySelector('.drawing text.rubber')?.textContent.includes('as long as link_1')")
    press_mm(studio, 30.5, 90.5)
    studio.wait(f"({OUTLINE}).includes('link_2')")
    # A second click at the end: it is on the ground.
    press_mm(studio, *studio.browser.evaluate("""(() => {
        const target = [...document.querySelectorAll('.drawing .target')].find((one) => one.getAttribute('aria-label').includes('link_2.b'));
        return /translate\\(([-\\d.]+) ([-\\d.]+)\\)/.exec(target.getAttribute('transform')).slice(1).map(Number);
    })()"""))
    studio.wait(f"({OUTLINE}).includes('pin_1')")
    model = studio.saved("drawn")[0]
    assert 'link_1_length = "50 mm"' in model and 'link_2_length = "50 mm"' in model
    assert studio.browser.diagnostics() == []


def test_a_link_is_added_in_four_clicks(studio):  # noqa: F811
    studio.browser.view(1280, 800)
    studio.take("rank, coupler and rocker")
    hand = Hand(studio)
    hand.button(".tools.build label", "Link")
    studio.wait("document.querySelectorAll('.drawing .target').length > 0")
    hand.clicks += 1
    press_target(studio, "coupler.tracer")
    hand.mm(250, 230)
    studio.wait(f"({OUTLINE}).includes('link_1')")
    assert hand.clicks <= 4
    assert 'joint.link_1_a]' in studio.saved("four-bar")[0]
    assert studio.browser.diagnostics() == []


def test_what_is_drawn_is_there_after_a_reload(studio):  # noqa: F811
    new_sheet(studio)
    studio.click("button", "Draw from nothing")
    wait_for_sheet(studio)
    assert list(studio.folder.glob("drawn*")) == [], "nothing is written before it is saved"
    before = studio.saved("drawn")
    studio.wait("location.hash === '#/edit/drawn/study.toml'")
    # The page goes on under the address of the file.
    wait_for_sheet(studio)
    press_mm(studio, 0, 0)
    press_mm(studio, 20, 40)
    studio.wait(f"({OUTLINE}).includes('link_1')")
    time.sleep(0.6)
    # A crash: nobody is asked whether to leave.
    studio.browser.evaluate("(addEventListener('beforeunload', (event) => event.stopImmediatePropagation(), true), true)")
    studio.browser.reload()
    studio.wait("document.querySelector('.notice')?.innerText.includes('that were not saved are here again')")
    studio.wait(f"({OUTLINE}).includes('link_1')")
    assert [(studio.folder / "drawn" / name).read_text() for name in ("model.toml", "study.toml")] == before
    undo(studio)
    studio.wait(f"!({OUTLINE}).includes('link_1')")
    studio.click("button", "Redo")
    studio.wait(f"({OUTLINE}).includes('link_1')")
    # The file changes meanwhile: what was not saved is offered, and does not stand over what is new.
    time.sleep(0.6)
    (studio.folder / "drawn/model.toml").write_text(before[0].replace("9.81", "1.62"))
    studio.browser.reload()
    studio.wait("document.querySelector('.notice.warning')?.innerText.includes('of an older text')")
    assert "link_1" not in studio.browser.evaluate(OUTLINE)
    studio.click("button", "Show them")
    studio.wait(f"({OUTLINE}).includes('link_1')")
    undo(studio)
    studio.wait(f"!({OUTLINE}).includes('link_1')")
    studio.wait("!document.querySelector('.notice.warning')")
    # At once: what was taken back just now does not come again.
    studio.browser.reload()
    studio.wait("document.querySelector('.drawing svg')")
    studio.settle()
    assert studio.browser.evaluate("document.querySelector('.notice')") is None
    assert studio.browser.diagnostics() == []


def test_a_sheet_that_was_never_saved_is_there_after_a_reload(studio):  # noqa: F811
    new_sheet(studio)
    studio.click("button", "Draw from nothing")
    wait_for_sheet(studio)
    press_mm(studio, 0, 0)
    press_mm(studio, 20, 40)
    studio.wait(f"({OUTLINE}).includes('link_1')")
    time.sleep(0.6)
    studio.browser.evaluate("(addEventListener('beforeunload', (event) => event.stopImmediatePropagation(), true), true)")
    studio.browser.reload()
    studio.wait("document.querySelector('.notice')?.innerText.includes('that were not saved are here again')")
    studio.wait(f"({OUTLINE}).includes('link_1')")
    assert list(studio.folder.glob("drawn*")) == []
    # It is saved to a folder of its own, and the next sheet is empty again.
    assert 'link_1_length = "44.721 mm"' in studio.saved("drawn")[0]
    studio.open()
    studio.click("button", "Draw from nothing")
    wait_for_sheet(studio)
    assert "link_1" not in studio.browser.evaluate(OUTLINE)
    assert studio.browser.diagnostics() == []


def test_a_tool_holds_the_mechanism_at_its_start_and_undo_ends_a_chain(studio):  # noqa: F811
    new_sheet(studio)
    studio.click("button", "Draw from nothing")
    wait_for_sheet(studio)
    for place in [(0, 0), (20, 40), (120, 80)]:
        press_mm(studio, *place)
    press_mm(studio, 140, 0, SHIFT)
    studio.wait(f"({OUTLINE}).includes('link_3')")
    studio.wait(f"({MOBILITY}).includes('1 degree of freedom, 1 drive')")
    crank = "[...document.querySelectorAll('.drawing .target')].find((one) => one.getAttribute('aria-label').includes('link_1.b')).getAttribute('transform')"
    at_rest = studio.browser.evaluate(crank)
    studio.browser.evaluate("(document.querySelector('.drawing .ground').focus(), true)")
    studio.key("]")
    time.sleep(0.3)
    assert studio.browser.evaluate(crank) == at_rest, "the mechanism stands while a tool is on"
    # A link with a free end, taken back: the next click begins anew.
    press_target(studio, "link_2.b")
    press_mm(studio, 180, 120)
    studio.wait(f"{HINT}.includes('click link_4.b again to pin it')")
    undo(studio)
    studio.wait(f"!({OUTLINE}).includes('link_4')")
    studio.wait(f"{HINT}.includes('Click where the link begins')")
    assert studio.browser.diagnostics() == []

"""Links, joints and names of a mechanism that is there already, changed in the studio by mouse, by keys and by lists: what counts stands in the files."""

import re
import subprocess

import pytest
from check_pages import AXE, seen_by_axe
from test_studio import PROBLEMS, PROGRAM, browser, studio  # noqa: F401

SHIFT = 8
# The target of a tool at a point, by its name: where it is on the screen.
TARGET = """((name) => {
    const found = [...document.querySelectorAll('.drawing .target')].find((one) => one.getAttribute('aria-label').includes(name));
    if (!found) return null;
    const place = found.getScreenCTM();
    return [place.e, place.f];
})(%s)"""
# A place of the drawing, mm, on the screen.
PLACE_MM = """((x, y) => {
    const place = new DOMPoint(x, -y).matrixTransform(document.querySelector('.drawing svg').getScreenCTM());
    return [place.x, place.y];
})(%s, %s)"""
HINT = "(document.querySelector('.building-hint')?.innerText ?? '')"
MOBILITY = "(document.querySelector('.outline .mobility')?.innerText ?? '')"


def take_tool(studio, tool):
    studio.browser.evaluate(f"(document.querySelector('.tools.build input[value={tool}]').click(), true)")
    studio.browser.evaluate("(document.querySelector('.drawing').scrollIntoView({ block: 'center' }), true)")
    if tool != "move":
        studio.wait("document.querySelectorAll('.drawing .target').length > 0")


def press(studio, place, modifiers=0):
    for kind in ("mouseMoved", "mousePressed", "mouseReleased"):
        studio.browser.call("Input.dispatchMouseEvent", type=kind, x=place[0], y=place[1], button="left", clickCount=1, modifiers=modifiers)


def press_target(studio, name):
    studio.wait(TARGET % repr(name))
    press(studio, studio.browser.evaluate(TARGET % repr(name)))


def press_mm(studio, x, y, modifiers=0):
    press(studio, studio.browser.evaluate(PLACE_MM % (x, y)), modifiers)


def option(studio, label, value):
    """Sets a field beside the tools, as the keyboard does."""
    studio.wait(f"""((label) => {{
        const field = [...document.querySelectorAll('.tool-options label')].find((one) => one.textContent.trim().startsWith(label))?.querySelector('select, input');
        if (!field) return false;
        field.focus();
        field.value = {value!r};
        field.dispatchEvent(new Event(field.tagName === 'SELECT' ? 'change' : 'input', {{ bubbles: true }}));
        return true;
    }})({label!r})""")


def place(studio, text, modifiers=0):
    """A place that is typed for a tool."""
    option(studio, "Place", text)
    studio.key("Enter", modifiers)


def enter_target(studio, name):
    """A point that is taken by Enter."""
    studio.wait(TARGET % repr(name))
    studio.browser.evaluate(f"([...document.querySelectorAll('.drawing .target')].find((one) => one.getAttribute('aria-label').includes({name!r})).focus(), true)")
    studio.key("Enter")


def open_small(studio, template):
    """A template whose study ends soon."""
    folder = studio.folder / template
    subprocess.run([PROGRAM, "new", template, folder], check=True, capture_output=True)
    study = folder / "study.toml"
    text = study.read_text().replace("inner = 1024", "inner = 32").replace("inner = 256", "inner = 32").replace("outer = 16", "outer = 4")
    # So few runs show a share of 80 %, and none that is larger.
    text = re.sub("probability_at_least = 0.9[0-9]*", "probability_at_least = 0.8", text)
    study.write_text(text)
    studio.open()
    studio.click("a, button", text.split('name = "')[1].split('"')[0])
    studio.wait("document.querySelector('svg.chart') && document.querySelector('.field')")
    studio.settle()


def undo(studio, times=1):
    studio.browser.evaluate("document.activeElement.blur()")
    for _ in range(times):
        studio.click("button", "Undo")


def lost(before, after):
    """Lines of a text that are not in another one, each as often as it is missing."""
    left = after.split("\n")
    missing = []
    for line in before.split("\n"):
        if line in left:
            left.remove(line)
        else:
            missing.append(line)
    return missing


def test_a_dyad_is_drawn_onto_a_four_bar_and_its_study_runs(studio):  # noqa: F811
    open_small(studio, "four-bar")
    before = studio.saved("four-bar")
    take_tool(studio, "link")
    press_target(studio, "coupler.tracer")
    studio.wait(f"{HINT}.includes('The link begins at coupler.tracer')")
    press_mm(studio, 250, 230)
    studio.wait(f"({PROBLEMS}).includes(\"1 degree of freedom too many: 'link_1' can move\")")
    # It is drawn, and can be built on, although it does not move yet: the next link begins at its end.
    studio.wait(f"{HINT}.includes('click link_1.b again to pin it')")
    press_mm(studio, 330, 20, SHIFT)
    studio.wait(f"{HINT}.includes('1 degree of freedom, 1 drive')")
    studio.settle()
    assert "No problems" in studio.browser.evaluate(PROBLEMS)
    assert "1 degree of freedom" in studio.browser.evaluate(MOBILITY)
    take_tool(studio, "move")
    after = studio.saved("four-bar")
    assert after[1] == before[1], "the study has nothing new"
    # All lines of before are there, but for the two to which a point of the ground and the guesses were added.
    assert [line.split("=")[0] for line in lost(before[0], after[0])] == ["points ", "guess "]
    assert 'rocker_pivot = ["base_length", "0 mm"], p1 = ["330 mm", "20 mm"] }\n' in after[0]
    # From (250, 230) to (330, 20), by Pythagoras.
    assert 'link_2_length = "224.722 mm"' in after[0]
    assert 'bearing = "ground.p1"' in after[0]
    done = subprocess.run([PROGRAM, "check", "four-bar/model.toml", "four-bar/study.toml"], cwd=studio.folder, capture_output=True, text=True)
    assert done.returncode == 0 and "1 degree of freedom" in done.stdout, done.stdout + done.stderr
    studio.click("button", "Save and run")
    studio.wait("[...document.querySelectorAll('button, a')].some((one) => one.textContent.includes('Open the report'))", 300)
    undo(studio, 2)
    studio.wait("!document.querySelector('.outline').innerText.includes('link_1')")
    assert studio.saved("four-bar") == before, "a link is one step to undo"
    assert studio.browser.diagnostics() == []


def test_the_same_by_keys_alone(studio):  # noqa: F811
    studio.take("rank, coupler and rocker")
    before = studio.saved("four-bar")
    studio.key("l")
    enter_target(studio, "coupler.tracer")
    studio.wait(f"{HINT}.includes('The link begins at coupler.tracer')")
    place(studio, "250, 230")
    studio.wait("document.querySelector('.outline').innerText.includes('link_1')")
    place(studio, "330, 20", SHIFT)
    studio.wait(f"{HINT}.includes('1 degree of freedom, 1 drive')")
    studio.settle()
    after = studio.saved("four-bar")
    assert 'link_2_length = "224.722 mm"' in after[0] and after[1] == before[1]
    # The tools by keys: a point is chosen by Enter, a tool is put away by Escape.
    for name in ("coupler.tracer", "ground.p1"):
        enter_target(studio, name)
    # A third link between the same bodies holds them: that is said, and not refused.
    studio.wait(f"({PROBLEMS}).includes('block one another')")
    studio.key("Escape")
    studio.wait("document.querySelector('.tools.build input[value=move]').checked")
    undo(studio, 3)
    studio.wait("!document.querySelector('.outline').innerText.includes('link_1')")
    assert studio.saved("four-bar") == before
    assert studio.browser.diagnostics() == []


def test_a_body_goes_with_all_that_names_it_after_that_is_told(studio):  # noqa: F811
    studio.take("rank, coupler and rocker")
    before = studio.saved("four-bar")
    studio.click(".outline button", "rocker")
    studio.wait("document.querySelector('#part-heading')?.innerText === 'rocker'")
    studio.click(".chosen .links button", "Delete")
    studio.wait("document.querySelector('[role=alertdialog]')")
    told = studio.browser.evaluate("document.querySelector('[role=alertdialog]').innerText")
    for words in ("joint 'rocker_pivot'", "output 'rocker_speed'", "parameter 'rocker_mass'", "the distribution of parameter 'rocker_length' in the study",
                  "question 2 of the study", "requirement 1 of the study"):
        assert words in told, told
    studio.click("[role=alertdialog] button", "Keep it")
    studio.wait_until_saved()
    studio.click(".chosen .links button", "Delete")
    studio.wait("document.activeElement.closest('[role=alertdialog]') !== null")
    studio.browser.call("Input.dispatchKeyEvent", type="keyDown", key="Enter", code="Enter", windowsVirtualKeyCode=13, text="\r")
    studio.wait(f"({PROBLEMS}).includes('error')")
    after = studio.saved("four-bar")
    assert not any("rocker" in line.split("#")[0] for line in after[0].split("\n") if "points = {" not in line), after[0]
    assert "[[ask]]" not in after[1] and "[sampling]" in after[1]
    undo(studio)
    studio.wait("document.querySelector('svg.chart')")
    studio.settle()
    assert studio.saved("four-bar") == before, "it is one step to undo"
    # By the tool: a pin, which nothing else names but its force, goes likewise.
    take_tool(studio, "delete")
    press_target(studio, "crank.pin")
    studio.wait(f"({PROBLEMS}).includes('degrees of freedom too many')")
    assert "[joint.crank_pin]" not in studio.saved("four-bar")[0]
    undo(studio)
    studio.wait(f"({MOBILITY}).includes('1 degree of freedom, 1 drive')")
    assert studio.saved("four-bar") == before
    assert studio.browser.diagnostics() == []


def test_an_output_is_added_and_shows_its_band(studio):  # noqa: F811
    studio.take("rank, coupler and rocker")
    before = studio.saved("four-bar")
    take_tool(studio, "record")
    option(studio, "Record", "angle")
    press_target(studio, "coupler.tracer")
    studio.wait("document.querySelector('.outline').innerText.includes('coupler_angle')")
    studio.settle()
    studio.wait("[...document.querySelectorAll('.band select.of option')].some((one) => one.textContent.includes('coupler_angle'))")
    after = studio.saved("four-bar")
    assert '[output.coupler_angle]\nangle_of = "coupler"\n' in after[0] and lost(before[0], after[0]) == [] and after[1] == before[1]
    undo(studio)
    studio.wait("!document.querySelector('.outline').innerText.includes('coupler_angle')")
    assert studio.saved("four-bar") == before
    assert studio.browser.diagnostics() == []


def test_another_name_is_written_in_both_texts(studio):  # noqa: F811
    studio.take("rank, coupler and rocker")
    before = studio.saved("four-bar")
    studio.click(".outline button", "rocker_pin")
    name = ".chosen .naming input"

    def say(text):
        studio.browser.evaluate(f"(document.querySelector({name!r}).focus(), document.querySelector({name!r}).select(), true)")
        studio.browser.call("Input.insertText", text=text)
        studio.key("Enter")

    say("crank_pin")
    studio.wait("document.querySelector('.naming .message')?.innerText.includes('there is a joint')")
    say("top pin")
    studio.wait("document.querySelector('.naming .message')?.innerText.includes(\"'top pin' is not a valid name\")")
    say("top_pin")
    studio.wait("document.querySelector('#chosen-heading')?.innerText === 'top_pin'")
    studio.settle()
    after = studio.saved("four-bar")
    assert [old.replace("rocker_pin", "top_pin") for old in before] == after
    undo(studio)
    studio.wait("document.querySelector('.outline').innerText.includes('rocker_pin')")
    assert studio.saved("four-bar") == before
    assert studio.browser.diagnostics() == []


def test_a_slider_with_play_a_plate_and_the_ground(studio):  # noqa: F811
    studio.take("rank, coupler and rocker")
    before = studio.saved("four-bar")
    # A link whose end slides on the ground: drawn as a block, then as a pin in a slot.
    take_tool(studio, "link")
    press_target(studio, "coupler.tracer")
    press_mm(studio, 250, 230)
    studio.wait(f"({PROBLEMS}).includes('link_1')")
    take_tool(studio, "slider")
    press_target(studio, "link_1.b")
    studio.wait(f"{HINT}.includes('1 degree of freedom, 1 drive')")
    studio.settle()
    model = studio.saved("four-bar")[0]
    assert '[joint.guide_1]\nkind = "prismatic"\nguide = { point = "ground.p1", angle = "0 deg" }\nslider = "block_1.pin"\n' in model
    undo(studio)
    studio.wait(f"({PROBLEMS}).includes('link_1')")
    take_tool(studio, "join")
    option(studio, "As", "slot")
    option(studio, "Line at", "30")
    place(studio, "250, 230", SHIFT)
    enter_target(studio, "link_1.b")
    studio.wait(f"{HINT}.includes('1 degree of freedom, 1 drive')")
    assert 'slot = { point = "ground.p1", angle = "30 deg" }' in studio.saved("four-bar")[0]
    undo(studio, 2)
    studio.wait("!document.querySelector('.outline').innerText.includes('link_1')")
    # A plate: a further point of the rocker, held at the middle of the link.
    take_tool(studio, "plate")
    press_mm(studio, 294.3, 89.8)
    studio.wait(f"{HINT}.includes('belong to rocker')")
    press_mm(studio, 360, 120)
    studio.wait(f"{HINT}.includes('1 degree of freedom, 1 drive')")
    assert 'pin = ["rocker_length", "0 mm"], p1 = [' in studio.saved("four-bar")[0]
    undo(studio)
    studio.settle()
    assert studio.saved("four-bar") == before
    assert studio.browser.diagnostics() == []


def test_a_locked_length_is_not_dragged(studio):  # noqa: F811
    studio.take("rank, coupler and rocker")
    before = studio.saved("four-bar")
    lock = "button.lock[aria-label*=coupler_length]"
    studio.click(lock)
    studio.wait(f"document.querySelector({lock!r}).getAttribute('aria-pressed') === 'true'")
    studio.settle()
    locked = studio.saved("four-bar")
    assert locked[0] == before[0].replace('coupler_length = "260 mm"', 'coupler_length = "260 mm"  # locked') and locked[1] == before[1]
    x, y = studio.drag("crank_pin", (40, -20), is_let_go=False)
    studio.wait("document.querySelector('.drawing .over')?.innerText.includes('coupler length')")
    assert "is locked" in studio.browser.evaluate("document.querySelector('.drawing .over').innerText")
    studio.browser.call("Input.dispatchMouseEvent", type="mouseReleased", x=x, y=y, button="left", clickCount=1)
    studio.settle()
    assert studio.saved("four-bar") == locked
    studio.click(lock)
    studio.wait(f"document.querySelector({lock!r}).getAttribute('aria-pressed') === 'false'")
    assert studio.saved("four-bar") == before
    assert studio.browser.diagnostics() == []


def test_a_chosen_link_shows_its_length_with_its_tolerance(studio):  # noqa: F811
    studio.take("rank, rod and slider")
    text = "[...document.querySelectorAll('.drawing text.dimension')].map((one) => one.textContent).join('|')"
    assert studio.browser.evaluate(text) == ""
    studio.click(".outline button", "rod")
    studio.wait(f"({text}) !== ''")
    assert studio.browser.evaluate(text) == "120 mm, sd 0.03 mm"
    studio.type_number("rod_length", "150 mm")
    studio.wait(f"({text}).startsWith('150 mm')")
    studio.click(".outline button", "guide")
    studio.wait(f"({text}) === '0 deg'")
    assert studio.browser.diagnostics() == []


@pytest.mark.parametrize("width", [1280, 400])
@pytest.mark.parametrize("dark", [False, True])
def test_tools_lists_and_questions_are_accessible(studio, width, dark):  # noqa: F811
    axe = AXE.read_text()
    studio.browser.view(width, dark=dark, reduced_motion=True)
    studio.take("rank, coupler and rocker")
    studio.browser.evaluate("(document.querySelector('details.outline').open = true)")
    studio.click(".outline button", "rocker")
    studio.wait("document.querySelector('#part-heading')")
    assert seen_by_axe(studio.browser, axe) == [], "a chosen body"
    take_tool(studio, "link")
    press_target(studio, "coupler.tracer")
    press_mm(studio, 250, 230)
    studio.wait("document.querySelector('.problems button.counted')")
    if width == 400:
        studio.click(".problems button.counted")
    studio.settle()
    assert seen_by_axe(studio.browser, axe) == [], "a mechanism that is not complete"
    studio.click(".chosen .links button", "Delete")
    studio.wait("document.querySelector('[role=alertdialog]')")
    assert seen_by_axe(studio.browser, axe) == [], "a question"
    assert studio.browser.diagnostics() == []

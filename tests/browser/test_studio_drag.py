"""What can be dragged in the studio beside pins: points onto points, lines of guides, what does not move yet; springs and loads."""

import time

import pytest  # noqa: F401
from check_pages import AXE, seen_by_axe
from test_studio import PROBLEMS, browser, studio  # noqa: F401
from test_studio_edit import HINT, MOBILITY, PLACE_MM, open_small, press_mm, press_target, take_tool, undo

# Where something that can be taken is on the screen: a pin, a point, the line of a guide.
GRIP = """((key) => {
    const found = [...document.querySelectorAll('.drawing .grip')].find((one) => one.dataset.grip === key);
    if (!found) return null;
    const place = found.getScreenCTM();
    return [place.e, place.f];
})(%r)"""
OVER = "(document.querySelector('.drawing .over')?.innerText ?? '')"
SPRING = """
[spring.back]
kind = "linear"
first = "ground.rocker_pivot"
second = "coupler.tracer"
stiffness = "1 N/mm"
free_length = "100 mm"

[load.push]
kind = "force"
point = "rocker.pin"
direction = "180 deg"
force = "10 N"
"""


def mouse(studio, kind, place, **more):
    studio.browser.call("Input.dispatchMouseEvent", type=kind, x=place[0], y=place[1], button="left", **more)


def drag(studio, key, to, is_let_go=True, modifiers=0):
    """From a grip to a place of the screen, which may lie on another one."""
    studio.wait(GRIP % key)
    begin = studio.browser.evaluate(GRIP % key)
    mouse(studio, "mousePressed", begin, clickCount=1)
    for step in range(1, 16):
        share = step / 15
        mouse(studio, "mouseMoved", [a + share * (b - a) for a, b in zip(begin, to, strict=True)], buttons=1, modifiers=modifiers)
        time.sleep(0.02)
    if is_let_go:
        mouse(studio, "mouseReleased", to, clickCount=1, modifiers=modifiers)


def add_dyad(studio):
    """A link with a free end at the tracer of a four-bar, and one that stands on the ground beside it."""
    open_small(studio, "four-bar")
    take_tool(studio, "link")
    press_target(studio, "coupler.tracer")
    press_mm(studio, 250, 230)
    studio.wait(f"({PROBLEMS}).includes(\"'link_1' can move\")")
    # The chain ends, and another link begins elsewhere.
    studio.wait(f"{HINT}.includes('click link_1.b again to pin it')")
    studio.key("Escape")
    press_mm(studio, 380, 40, modifiers=8)
    press_mm(studio, 320, 190)
    studio.wait("[...document.querySelectorAll('.outline button')].some((one) => one.textContent === 'link_2')")
    take_tool(studio, "move")
    studio.settle()


def test_a_point_dropped_on_a_point_is_pinned_to_it_in_one_step(studio):  # noqa: F811
    add_dyad(studio)
    missing = "document.querySelector('.problems .message').innerText"
    before = studio.browser.evaluate(missing)
    texts = studio.saved("four-bar")
    onto = studio.browser.evaluate(GRIP % "point link_2.b")
    drag(studio, "point link_1.b", onto, is_let_go=False)
    studio.wait("document.querySelector('.drawing circle.drop')")
    studio.wait(f"{OVER}.includes('Release to pin it to link_2.b')")
    mouse(studio, "mouseReleased", onto, clickCount=1)
    # Two links more with three pins: the mechanism moves again.
    studio.wait(f"{MOBILITY}.includes('1 degree of freedom, 1 drive')")
    assert "No problems" in studio.browser.evaluate(PROBLEMS)
    studio.settle()
    assert studio.browser.evaluate("document.querySelector('.drawing circle.drop')") is None
    model = studio.saved("four-bar")[0]
    assert '"link_2.b"' in model and '"link_1.b"' in model
    undo(studio)
    studio.wait(f"document.querySelector('.problems .message') && {missing} === {before!r}")
    assert studio.saved("four-bar") == texts, "one step back"


def test_with_alt_or_escape_nothing_is_pinned(studio):  # noqa: F811
    add_dyad(studio)
    joints = "document.querySelectorAll('.outline ul')[1].children.length"
    count = studio.browser.evaluate(joints)
    texts = studio.saved("four-bar")
    onto = studio.browser.evaluate(GRIP % "point link_2.b")
    drag(studio, "point link_1.b", onto, is_let_go=False)
    studio.wait("document.querySelector('.drawing circle.drop')")
    studio.key("Escape")
    studio.wait("document.querySelector('.drawing circle.drop') === null")
    mouse(studio, "mouseReleased", onto, clickCount=1)
    studio.settle()
    assert studio.saved("four-bar") == texts
    drag(studio, "point link_1.b", onto, modifiers=1)
    studio.settle()
    assert studio.browser.evaluate(joints) == count
    assert studio.saved("four-bar") != texts, "it has moved"


def test_a_guide_is_turned_by_its_line_in_steps_of_15_degrees(studio):  # noqa: F811
    open_small(studio, "slider-crank")
    before = studio.saved("slider-crank")
    studio.click(".outline button", "guide")
    studio.wait(GRIP % "guide guide")
    at, centre = studio.browser.evaluate(GRIP % "guide guide"), studio.browser.evaluate(PLACE_MM % (0, 0))
    far = at[0] - centre[0]
    # About 40° up: 45° is the nearest step.
    drag(studio, "guide guide", (centre[0] + 0.77 * far, centre[1] - 0.64 * far))
    studio.settle()
    assert 'angle = "45 deg"' in studio.saved("slider-crank")[0]
    # By keys, a step back.
    studio.browser.evaluate("([...document.querySelectorAll('.drawing .grip')].find((one) => one.dataset.grip === 'guide guide').focus(), true)")
    studio.key("ArrowRight")
    studio.wait("document.querySelector('.chosen .forms').innerText.includes('30 deg')")
    undo(studio, 2)
    studio.settle()
    assert studio.saved("slider-crank") == before


def test_a_spring_and_a_load_are_seen_chosen_and_deleted(studio):  # noqa: F811
    open_small(studio, "four-bar")
    time.sleep(1.2)
    model = studio.folder / "four-bar/model.toml"
    model.write_text(model.read_text() + SPRING)
    studio.click("button", "Load the version on disk")
    studio.wait("document.querySelectorAll('.drawing .force').length === 2")
    assert studio.browser.evaluate(PROBLEMS).find("error") == -1
    assert seen_by_axe(studio.browser, AXE.read_text()) == []
    # The sign of the spring goes with its ends.
    place = "document.querySelector('.drawing .force.spring [data-from]').getAttribute('transform')"
    first = studio.browser.evaluate(place)
    for _ in range(5):
        studio.click("button", "+1°")
    assert studio.browser.evaluate(place) != first
    # By list.
    studio.click(".outline button", "push")
    studio.wait("document.querySelector('.chosen h3')?.innerText === 'push'")
    studio.click(".chosen button", "Delete load 'push'")
    studio.wait("document.querySelectorAll('.drawing .force').length === 1")
    # By mouse, with the tool.
    take_tool(studio, "delete")
    middle = """(() => { const box = document.querySelector('.drawing .force.spring .sign').getBoundingClientRect();
        return [box.x + box.width / 2, box.y + box.height / 2]; })()"""
    place = studio.browser.evaluate(middle)
    for kind in ("mousePressed", "mouseReleased"):
        mouse(studio, kind, place, clickCount=1)
    studio.wait("document.querySelectorAll('.drawing .force').length === 0")
    model = studio.saved("four-bar")[0]
    assert "[spring" not in model and "[load" not in model
    undo(studio, 2)
    studio.wait("document.querySelectorAll('.drawing .force').length === 2")


def test_a_pin_dragged_over_the_dead_centre_stays_at_the_pointer(studio):  # noqa: F811
    open_small(studio, "four-bar")
    before = studio.browser.evaluate(GRIP % "joint rocker_pin")
    pivots = [studio.browser.evaluate(GRIP % f"joint {name}") for name in ("crank_pivot", "rocker_pivot")]
    below = (before[0] - 20, 2 * pivots[1][1] - before[1] - 30)
    drag(studio, "joint rocker_pin", below)
    studio.settle()
    # The drawing has another frame now: the pin is below the pivots where it was above them.
    after, pivot = [studio.browser.evaluate(GRIP % f"joint {name}") for name in ("rocker_pin", "rocker_pivot")]
    assert before[1] < pivots[1][1] and after[1] > pivot[1] + 20, f"{after} at {pivot}: it has jumped to the other closure"
    assert 'rocker = "-' in studio.saved("four-bar")[0], "the guess says on which side"

"""The canvas of the studio: zoom, pan, names that hide nothing, paths of points, numbers edited where they stand."""

import re
import time

import pytest  # noqa: F401
from test_studio import browser, studio  # noqa: F401
from test_studio_edit import open_small

# Of the plane: names of a mechanism in space stand where its picture has them.
TEMPLATES = "[...document.querySelectorAll('button.card')].filter((card) => card.querySelector('svg.mechanism')).map((card) => card.querySelector('.name')?.textContent ?? card.textContent)"
BOX = "document.querySelector('.drawing svg').getAttribute('viewBox').split(' ').map(Number)"
# Names whose box meets the box of another name, or a stroke or a fill of a body (by the shapes that are drawn, not by the points from
# which names are placed): pairs of words.
HIDDEN = """(() => {
    const svg = document.querySelector('.drawing svg');
    const canvas = document.querySelector('.drawing .ground').getBoundingClientRect();
    const texts = [...svg.querySelectorAll('.labels text')].map((text) => ({ text, box: text.getBoundingClientRect() }));
    const found = [];
    texts.forEach(({ text, box }, index) => {
        if (box.left < canvas.left || box.right > canvas.right || box.top < canvas.top || box.bottom > canvas.bottom) found.push([text.textContent, 'edge']);
        texts.slice(index + 1).forEach((other) => {
            if (box.left < other.box.right && other.box.left < box.right && box.top < other.box.bottom && other.box.top < box.bottom) found.push([text.textContent, other.text.textContent]);
        });
        for (const shape of svg.querySelectorAll('.body .bar, .body .plate, .body .block, circle.pin, circle.bearing, circle.journal')) {
            const inverse = shape.getScreenCTM().inverse();
            let isMet = false;
            // The letters themselves: without the space above and below them.
            for (let x = box.left; x <= box.right && !isMet; x += 2) {
                for (let y = box.top + 0.2 * box.height; y <= box.bottom - 0.2 * box.height && !isMet; y += 2) {
                    const point = new DOMPoint(x, y).matrixTransform(inverse);
                    isMet = shape.isPointInStroke(point) || (shape.matches('.plate, .block, circle') && shape.isPointInFill(point));
                }
            }
            if (isMet) found.push([text.textContent, shape.getAttribute('class')]);
        }
    });
    return found;
})()"""


def settle(studio):  # noqa: F811
    studio.wait("document.querySelector('.drawing .labels')?.childElementCount >= 0 && document.querySelector('.band')?.getAttribute('aria-busy') === 'false'")
    time.sleep(0.2)


@pytest.mark.parametrize(("width", "height"), [(1280, 800), (1440, 900), (400, 800)])
def test_names_of_all_templates_hide_neither_each_other_nor_links(studio, width, height):  # noqa: F811
    studio.browser.view(width, height, reduced_motion=True)
    studio.open()
    names = studio.browser.evaluate(TEMPLATES)
    assert len(names) == 17
    faults = {}
    for name in names:
        studio.open()
        studio.click("button.card", name)
        settle(studio)
        # The words of the scale stand apart from the buttons.
        assert studio.browser.evaluate("document.querySelector('.scale-bar').getBoundingClientRect().right <= document.querySelector('.drawing .zoom').getBoundingClientRect().left"), name
        if hidden := studio.browser.evaluate(HIDDEN):
            faults[name] = hidden
    assert not faults, faults



def mouse(studio, kind, place, **more):  # noqa: F811
    studio.browser.call("Input.dispatchMouseEvent", type=kind, x=place[0], y=place[1], **more)


def box(studio):  # noqa: F811
    return studio.browser.evaluate(BOX)


def canvas_width(studio):  # noqa: F811
    """In pixels: the width of the view box in millimetres lies along it, or the height along the height."""
    return studio.browser.evaluate("(() => { const svg = document.querySelector('.drawing svg'); return svg.viewBox.baseVal.width * svg.getScreenCTM().a; })()")


def mm_at(studio, place):  # noqa: F811
    """What lies in the drawing at a place of the screen."""
    return studio.browser.evaluate(f"(() => {{ const at = new DOMPoint({place[0]}, {place[1]}).matrixTransform(document.querySelector('.drawing svg').getScreenCTM().inverse()); return [at.x, at.y]; }})()")


def test_the_wheel_zooms_about_the_pointer_and_keys_fit_again(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    open_small(studio, "four-bar")
    settle(studio)
    before = box(studio)
    # Whole pixels: a wheel has no others.
    place = [round(x) for x in studio.pin("rocker_pin")]
    held = mm_at(studio, place)
    for _ in range(5):
        mouse(studio, "mouseWheel", place, deltaX=0, deltaY=-120)
    studio.wait(f"{BOX}[2] < 0.5 * {before[2]}")
    zoomed = mm_at(studio, place)
    scale_mm = box(studio)[2] / 600
    assert max(abs(a - b) for a, b in zip(held, zoomed, strict=True)) < 0.5 * scale_mm, "the place under the pointer stays, to half a pixel"
    # Names are as large as before.
    assert studio.browser.evaluate("document.querySelector('.labels text').getBoundingClientRect().height") == pytest.approx(15, abs=3)
    studio.browser.evaluate("(document.querySelector('.drawing .ground').focus(), true)")
    for key in ("ArrowRight", "-", "+"):
        studio.browser.call("Input.dispatchKeyEvent", type="keyDown", key=key)
    assert box(studio) != before
    studio.browser.call("Input.dispatchKeyEvent", type="keyDown", key="0")
    studio.wait(f"Math.abs({BOX}[2] - {before[2]}) < 1e-3 * {before[2]}")


def test_a_press_beside_all_parts_moves_the_canvas(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    open_small(studio, "four-bar")
    settle(studio)
    left, top = studio.browser.evaluate("(() => { const { x, y } = document.querySelector('.drawing .ground').getBoundingClientRect(); return [x, y]; })()")
    before = studio.pin("rocker_pin")
    mouse(studio, "mousePressed", (left + 20, top + 20), button="left", clickCount=1)
    mouse(studio, "mouseMoved", (left + 60, top + 50), button="left", buttons=1)
    mouse(studio, "mouseReleased", (left + 60, top + 50), button="left", clickCount=1)
    after = studio.pin("rocker_pin")
    assert [b - a for a, b in zip(before, after, strict=True)] == pytest.approx([40, 30], abs=0.6)
    assert studio.browser.evaluate("document.querySelector('.bar').innerText.includes('· saved')"), "no text has changed"


def touch(studio, kind, *places):  # noqa: F811
    points = [{"x": x, "y": y, "id": index} for index, (x, y) in enumerate(places)]
    studio.browser.call("Input.dispatchTouchEvent", type=kind, touchPoints=points)


def test_two_fingers_zoom_about_their_middle_and_move_the_canvas(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    open_small(studio, "four-bar")
    settle(studio)
    before = box(studio)
    x, y = (round(at) for at in studio.pin("rocker_pin"))
    held = mm_at(studio, (x, y))
    # The first finger comes down on the pin: a second one makes it a zoom, and no length changes.
    touch(studio, "touchStart", (x, y))
    touch(studio, "touchStart", (x, y), (x - 80, y))
    for step in range(1, 11):
        touch(studio, "touchMove", (x + 4 * step, y), (x - 80 - 4 * step, y))
    # From 80 to 160 pixels: twice as large.
    studio.wait(f"Math.abs({BOX}[2] - {before[2]} / 2) < 0.02 * {before[2]}")
    middle = mm_at(studio, (x - 40, y))
    assert middle[0] == pytest.approx(held[0] - 40 * before[2] / canvas_width(studio), abs=before[2] / canvas_width(studio)), "to a pixel"
    scale = box(studio)[2] / canvas_width(studio)
    at = mm_at(studio, (x, y))
    for step in range(1, 11):
        touch(studio, "touchMove", (x + 40 + 3 * step, y + 2 * step), (x - 120 + 3 * step, y + 2 * step))
    # Moves of fingers reach the page once a frame.
    time.sleep(0.2)
    moved = mm_at(studio, (x + 30, y + 20))
    assert moved == pytest.approx(at, abs=scale), "both fingers together: what was under them stays there, to a pixel"
    touch(studio, "touchEnd")
    settle(studio)
    assert studio.browser.evaluate("document.querySelector('.bar').innerText.includes('· saved')"), "no text has changed"
    # One finger on a pin drags it.
    x, y = studio.pin("rocker_pin")
    touch(studio, "touchStart", (x, y))
    for step in range(1, 11):
        touch(studio, "touchMove", (x + 3 * step, y + step))
        time.sleep(0.02)
    touch(studio, "touchEnd")
    studio.wait("document.querySelector('.bar').innerText.includes('unsaved')")
    studio.settle()
    assert studio.pin("rocker_pin") == pytest.approx([x + 30, y + 10], abs=4.0), "to the step of its rounding"


def test_a_dragged_pin_is_under_the_pointer_after_its_release_and_the_view_holds_still(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    open_small(studio, "four-bar")
    settle(studio)
    before = box(studio)
    # Alt: without rounding, so that the pin is where the pointer is.
    x, y = studio.pin("rocker_pin")
    mouse(studio, "mousePressed", (x, y), button="left", clickCount=1)
    for step in range(1, 16):
        mouse(studio, "mouseMoved", (x + 3 * step, y + 2 * step), button="left", buttons=1, modifiers=1)
        time.sleep(0.02)
    mouse(studio, "mouseReleased", (x + 45, y + 30), button="left", clickCount=1, modifiers=1)
    settle(studio)
    studio.settle()
    assert studio.pin("rocker_pin") == pytest.approx([x + 45, y + 30], abs=1.0)
    assert box(studio) == before


def test_the_path_of_an_output_is_drawn_and_that_of_a_pin_pointed_at(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    open_small(studio, "four-bar")
    settle(studio)
    # The tracer of the coupler is on its path at every angle.
    on_path = """(() => {
        const path = document.querySelector('.drawing .trace.output');
        const mark = document.querySelector('.drawing .labels .mark').getBoundingClientRect();
        const [x, y] = [mark.x + mark.width / 2, mark.y + mark.height / 2];
        const length = path.getTotalLength();
        let best = Infinity;
        for (let at = 0; at <= length; at += length / 2000) {
            const point = path.getPointAtLength(at).matrixTransform(path.getScreenCTM());
            best = Math.min(best, Math.hypot(point.x - x, point.y - y));
        }
        return best;
    })()"""
    for _ in range(3):
        assert studio.browser.evaluate(on_path) < 0.8
        for _ in range(25):
            studio.click("button", "+1°")
    assert not studio.browser.evaluate("document.querySelector('.drawing .trace.pointed')")
    mouse(studio, "mouseMoved", studio.pin("rocker_pin"))
    studio.wait("document.querySelector('.drawing .trace.pointed')")


def test_a_length_is_edited_where_it_stands_with_its_tolerance(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    open_small(studio, "four-bar")
    settle(studio)
    studio.click(".outline button", "rocker")
    studio.wait("document.querySelector('.drawing text.editable')")
    place = studio.browser.evaluate("(() => { const box = document.querySelector('.drawing text.editable').getBoundingClientRect(); return [box.x + box.width / 2, box.y + box.height / 2]; })()")
    mouse(studio, "mousePressed", place, button="left", clickCount=1)
    mouse(studio, "mouseReleased", place, button="left", clickCount=1)
    studio.wait("document.activeElement.closest('.in-place')")
    # A decimal comma can mean nothing else here.
    studio.browser.call("Input.insertText", text="181,5 ±0,2 mm")
    studio.key("Enter")
    studio.wait("[...document.querySelectorAll('.drawing text.dimension')].some((text) => text.textContent.includes('181.5'))")
    model, study = studio.saved("four-bar")
    # The nominal value stands in the model, the tolerance in the study.
    assert re.search(r'^rocker_length = "181.5 mm"', model, re.MULTILINE), model
    assert re.search(r'^"parameter.rocker_length" = \{ tolerance = "181.5 mm ± 0.2 mm" \}', study, re.MULTILINE), study


def test_a_number_in_place_closes_when_it_is_left_and_nothing_changes(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    open_small(studio, "four-bar")
    settle(studio)
    # One that is known exactly, so that its field is not empty.
    studio.click(".outline button", "crank")
    studio.wait("document.querySelector('.drawing text.editable')")
    studio.browser.evaluate("(document.querySelector('.drawing text.editable').focus(), true)")
    studio.key("Enter")
    studio.wait("document.activeElement.closest('.in-place')")
    assert studio.browser.evaluate("document.activeElement.value") == "80 mm"
    studio.browser.evaluate("(document.activeElement.blur(), true)")
    studio.wait("!document.querySelector('.in-place')")
    assert studio.browser.evaluate("document.querySelector('.bar').innerText.includes('· saved')")

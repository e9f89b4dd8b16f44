"""The canvas of the studio: zoom, pan, names that hide nothing, paths of points, numbers edited where they stand."""

import time

import pytest  # noqa: F401
from test_studio import browser, studio  # noqa: F401
from test_studio_edit import open_small

TEMPLATES = "[...document.querySelectorAll('button.card')].map((card) => card.querySelector('.name')?.textContent ?? card.textContent)"
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
        if hidden := studio.browser.evaluate(HIDDEN):
            faults[name] = hidden
    assert not faults, faults


def open_template(studio, template="four-bar"):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    open_small(studio, template)
    studio.click(".recent .open, .recent button", template) if False else None
    settle(studio)
    return studio.browser.evaluate("(() => { const { x, y, width, height } = document.querySelector('.drawing .ground').getBoundingClientRect(); return [x, y, width, height]; })()")

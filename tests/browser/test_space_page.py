"""The page of a motion in space: the picture is turned and moved, and starts as the library drew it."""

import pathlib
import subprocess
import sys

import pytest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from check_pages import main as check  # noqa: E402
from chromium import Chromium  # noqa: E402

PROGRAM = REPOSITORY / "target/debug/loosepin"
MODELS = ("spatial-slider-crank", "rssr-four-bar")

# Class and numbers of all that is drawn, in its order.
SCENE = """[...document.querySelectorAll('[data-space] .scene > *')].map((shape) => [shape.getAttribute('class'),
    (shape.getAttribute('d') ?? ['cx', 'cy', 'r'].map((name) => shape.getAttribute(name)).join(' ')).match(/-?[\\d.]+/g).map(Number)])"""
NAMES = "[...document.querySelectorAll('[data-space] .names text')].map((text) => [text.textContent, Number(text.getAttribute('x'))])"
ANGLE = "document.querySelector('[data-space] .angle').textContent"
CHART = "document.querySelector('.position').textContent"
PRESSED = "document.querySelector('[data-space] .views [aria-pressed=\"true\"]')?.textContent ?? null"
VIEW = "[...document.querySelectorAll('[data-space] .views button')].find((button) => button.textContent === '%s').click()"
KEY = "document.querySelector('[data-space] svg').dispatchEvent(new KeyboardEvent('keydown', { key: '%s', bubbles: true, cancelable: true }))"
# Drags with a real mouse.
BOX = "(({ left, top, width, height }) => [left, top, width, height])(document.querySelector('[data-space] svg').getBoundingClientRect())"
SLIDE = """((value) => {
    const slider = document.querySelector('[data-space] .pose');
    slider.value = value;
    slider.dispatchEvent(new Event('input', { bubbles: true }));
})(%d)"""


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    folder = tmp_path_factory.mktemp("space")
    for model in MODELS:
        command = [PROGRAM, "motion", REPOSITORY / f"docs/examples/{model}.toml", "--out", folder / model]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return folder


@pytest.fixture(scope="module")
def browser():
    with Chromium() as browser:
        browser.view(1280, reduced_motion=True)
        yield browser


def opened(browser, pages, model=MODELS[0]):
    browser.open(str(pages / model / "report.html"))


def mouse(browser, kind, x, y, **more):
    browser.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", **more)


def drag(browser, right, down):
    left, top, width, height = browser.evaluate(BOX)
    x, y = left + width / 2, top + height / 2
    mouse(browser, "mousePressed", x, y, buttons=1, clickCount=1)
    mouse(browser, "mouseMoved", x + right, y + down, buttons=1)
    mouse(browser, "mouseReleased", x + right, y + down)


def box(numbers):
    return [end(numbers[axis::2]) for axis in (0, 1) for end in (min, max)]


@pytest.mark.parametrize("model", MODELS)
def test_the_script_starts_with_the_picture_of_the_library(browser, pages, model):
    browser.run_scripts(False)
    opened(browser, pages, model)
    drawn, names = browser.evaluate(SCENE), browser.evaluate(NAMES)
    browser.run_scripts(True)
    opened(browser, pages, model)
    turned = browser.evaluate(SCENE)
    # The page has seven digits of each coordinate of the library.
    assert [name for name, _ in drawn] == [name for name, _ in turned]
    for (name, due), (_, own) in zip(drawn, turned):
        if name.split()[0] in ("bearing", "pin", "zone") and not name.endswith("end"):
            # An outline may have other points on its straight sides.
            due, own = box(due), box(own)
        assert len(due) == len(own), name
        assert max(abs(a - b) for a, b in zip(due, own)) < 0.01, (name, due, own)
    for (text, due), (other, own) in zip(names, browser.evaluate(NAMES)):
        assert text == other and abs(due - own) < 0.01, (text, due, own)
    assert not browser.diagnostics()


def test_dragging_turns_the_picture_and_keys_do(browser, pages):
    opened(browser, pages)
    start = browser.evaluate(SCENE)
    assert browser.evaluate(PRESSED) == "Isometric"
    drag(browser, 40, 0)
    right = browser.evaluate(SCENE)
    assert right != start and browser.evaluate(PRESSED) is None
    # Half a degree a pixel, as four steps of a key.
    drag(browser, -40, 0)
    back = browser.evaluate(SCENE)
    assert [name for name, _ in back] == [name for name, _ in start]
    for _ in range(4):
        browser.evaluate(KEY % "ArrowRight")
    by_key = browser.evaluate(SCENE)
    for (_, a), (_, b) in zip(sorted(by_key), sorted(right)):
        assert max(abs(x - y) for x, y in zip(a, b)) < 0.01
    browser.evaluate(KEY % "Home")
    assert browser.evaluate(PRESSED) == "Isometric"
    assert not browser.diagnostics()


def test_standard_views_show_coordinates(browser, pages):
    opened(browser, pages)
    # The rod is 300 mm long, the slider at y = z = 0 and the bearing at (0, 100, 120) mm: from the pieces of its bar.
    browser.evaluate(VIEW % "Front")
    assert browser.evaluate(PRESSED) == "Front"
    front = [numbers for name, numbers in browser.evaluate(SCENE) if name.startswith("bar ")]
    browser.evaluate(VIEW % "Top")
    top = [numbers for name, numbers in browser.evaluate(SCENE) if name.startswith("bar ")]

    def extent(pieces, axis):
        values = [number for piece in pieces for number in piece[axis::2]]
        return max(values) - min(values)

    # Both show x to the right.
    assert abs(extent(front, 0) - extent(top, 0)) < 0.01
    # At 40 degrees, where the worst case is largest: pin at z = 120 + 80 cos 40, y = 100 - 80 sin 40; the bearing is at y = 100.
    assert abs(extent(front, 1) - (120 + 80 * 0.766044443)) < 0.05, extent(front, 1)
    assert abs(extent(top, 1) - 100) < 0.05, extent(top, 1)


def test_the_slider_moves_mechanism_and_curves(browser, pages):
    opened(browser, pages)
    before = browser.evaluate(SCENE)
    browser.evaluate(SLIDE % 9)
    assert browser.evaluate(ANGLE) == "90°"
    assert browser.evaluate(CHART) == "angle of crank: 90.00°"
    moved = browser.evaluate(SCENE)
    assert moved != before
    # The other way: an arrow key on the chart moves the mechanism by a position.
    browser.evaluate("""document.querySelector('[data-chart]').dispatchEvent(
        new KeyboardEvent('keydown', { key: 'ArrowRight', bubbles: true, cancelable: true }))""")
    assert browser.evaluate(ANGLE) == "100°"
    assert browser.evaluate(SCENE) != moved
    assert not browser.diagnostics()


def test_the_pages_have_no_fault(pages, monkeypatch):
    paths = []
    for model in MODELS:
        path = pages / f"{model}.html"
        path.write_bytes((pages / model / "report.html").read_bytes())
        paths.append(str(path))
    monkeypatch.setattr(sys, "argv", ["check_pages", *paths])
    assert check() == 0

"""Mechanisms in space in the studio: from the gallery to a report, turned by mouse and keys, with the band at every number that is typed."""

import json
import re
import subprocess

import pytest
from check_pages import AXE, seen_by_axe
from test_studio import BAND, LARGEST, PROBLEMS, PROGRAM, browser, studio  # noqa: F401

CANVAS = ".drawing.in-space .ground"
# The bars of the mechanism as they are drawn: they change where it is turned or moved.
BARS = "[...document.querySelectorAll('.drawing svg.space .scene .bar')].map((one) => one.getAttribute('d')).join()"
PRESSED = "[...document.querySelectorAll('.sides button[aria-pressed=true]')].map((one) => one.innerText)"
SHOWN = "document.querySelector('.drawing svg.space') && document.querySelector('.band .largest')"


def take(studio, name):  # noqa: F811
    studio.open()
    studio.click("button.card", name)
    studio.wait(SHOWN)
    studio.settle()


def middle(studio):  # noqa: F811
    return studio.browser.evaluate(f"""(() => {{
        const box = document.querySelector('{CANVAS}').getBoundingClientRect();
        return [box.x + box.width / 2, box.y + box.height / 2];
    }})()""")


def drag(studio, by, modifiers=0):  # noqa: F811
    (x, y), (right, down) = middle(studio), by
    mouse = lambda kind, share, **more: studio.browser.call(  # noqa: E731
        "Input.dispatchMouseEvent", type=kind, x=x + share * right, y=y + share * down, button="left", modifiers=modifiers, **more)
    mouse("mousePressed", 0, clickCount=1)
    for step in range(1, 9):
        mouse("mouseMoved", step / 8, buttons=1)
    mouse("mouseReleased", 1, clickCount=1)


def test_every_template_in_space_moves_in_the_gallery(studio):  # noqa: F811
    studio.open()
    studio.wait("document.querySelectorAll('button.card svg.space .scene .bar').length > 0")
    cards = "[...document.querySelectorAll('button.card')].filter((card) => card.querySelector('svg.space')).map((card) => card.querySelector('.name').innerText)"
    assert set(studio.browser.evaluate(cards)) == {
        "spatial-slider-crank", "spatial-four-bar", "universal-joint-shaft", "spherical-platform", "six-axis-arm", "bricard",
        "suspension-corner", "steering-linkage",
    }


def test_it_is_turned_moved_and_shown_from_its_sides(studio):  # noqa: F811
    take(studio, "spatial-four-bar")
    assert "No problems" in studio.browser.evaluate(PROBLEMS)
    assert studio.browser.evaluate(PRESSED) == ["Isometric"]
    first = studio.browser.evaluate(BARS)
    drag(studio, (60, 25))
    studio.wait(f"({BARS}) !== {first!r}")
    assert studio.browser.evaluate(PRESSED) == []
    studio.click(".sides button", "Top")
    # From above, the bearing of the crank is a circle, and x and y are the sheet: the triad has no z.
    studio.wait("[...document.querySelectorAll('.drawing .triad text')].map((one) => one.textContent).sort().join('') === 'xy'")
    assert studio.browser.evaluate(PRESSED) == ["Top"]
    studio.browser.evaluate(f"(document.querySelector('{CANVAS}').focus(), true)")
    studio.key("Home")
    studio.wait(f"({PRESSED})[0] === 'Isometric'")
    studio.wait(f"({BARS}) === {first!r}")
    studio.key("ArrowRight")
    studio.wait(f"({BARS}) !== {first!r}")
    studio.key("ArrowLeft")
    studio.wait(f"({BARS}) === {first!r}")
    # Shift and a drag move the canvas, as the wheel zooms it: what is drawn stays.
    box = studio.browser.evaluate("document.querySelector('.drawing svg.space').getAttribute('viewBox')")
    drag(studio, (40, 0), modifiers=8)
    studio.wait(f"document.querySelector('.drawing svg.space').getAttribute('viewBox') !== {box!r}")
    assert studio.browser.evaluate(BARS) == first
    # The play bar moves it.
    studio.click(".play-bar button", "+1°")
    studio.wait(f"({BARS}) !== {first!r}")


def test_the_band_follows_a_dimension_a_tolerance_and_a_play(studio):  # noqa: F811
    take(studio, "spatial-four-bar")
    before = studio.browser.evaluate(BAND)
    studio.type_number("coupler_length", "255 mm")
    studio.wait(f"({BAND}) !== {before!r}")
    largest = studio.browser.evaluate(LARGEST)
    # A click on the name of a joint in the drawing selects it.
    place = studio.browser.evaluate("""(() => {
        const box = [...document.querySelectorAll('.drawing .names text')].find((one) => one.textContent === 'crank_ball').getBoundingClientRect();
        return [box.x + box.width / 2, box.y + box.height / 2];
    })()""")
    for kind in ("mousePressed", "mouseReleased"):
        studio.browser.call("Input.dispatchMouseEvent", type=kind, x=place[0], y=place[1], button="left", clickCount=1)
    studio.wait("document.querySelector('#chosen-heading')?.innerText === 'crank_ball'")
    assert not studio.browser.evaluate("Boolean(document.querySelector('.chosen .naming'))"), "names are changed in the text"
    studio.browser.evaluate("(document.querySelector('.chosen .known input').focus(), document.querySelector('.chosen .known input').select(), true)")
    studio.browser.call("Input.insertText", text="0.1..0.4 mm")
    studio.key("Enter")
    studio.wait(f"({LARGEST}) !== {largest!r}")
    number = lambda text: float(re.search(r"±([0-9.]+)", text)[1])  # noqa: E731
    assert number(studio.browser.evaluate(LARGEST)) > 1.3 * number(largest)
    studio.click("button:not(.primary)", "Save")
    studio.wait_until_saved()
    study = next(studio.folder.glob("*/study.toml"))
    assert '"joint.crank_ball.radial_clearance" = { interval = ["0.1 mm", "0.4 mm"] }' in study.read_text()
    # The band is that of the command.
    moved = subprocess.run([PROGRAM, "motion", study, "--out", studio.folder / "moved"], capture_output=True, text=True)
    assert moved.returncode == 0, moved.stderr
    rocker = json.loads((studio.folder / "moved/summary.json").read_text())["outputs"][0]
    play, scatter = rocker["clearance"]["first_order_si"], rocker["dimensional_standard_deviation_si"]
    widest_deg = max(a + 2 * b for a, b in zip(play, scatter, strict=True)) * 180 / 3.141592653589793
    assert number(studio.browser.evaluate(LARGEST)) == pytest.approx(widest_deg, rel=1e-3)


def test_time_is_the_input_of_a_robot_arm(studio):  # noqa: F811
    take(studio, "six-axis-arm")
    assert studio.browser.evaluate("document.querySelector('.play-bar .angle').innerText").endswith(" s")
    before = studio.browser.evaluate(BARS)
    studio.click(".play-bar button", "−")
    studio.wait(f"({BARS}) !== {before!r}")


def test_a_study_runs_and_its_report_shows_the_mechanism(studio):  # noqa: F811
    folder = studio.folder / "four-bar"
    subprocess.run([PROGRAM, "new", "spatial-four-bar", folder], check=True, capture_output=True)
    study = folder / "study.toml"
    study.write_text(study.read_text().replace("inner = 256", "inner = 32"))
    studio.open()
    studio.click("a.card", "play in its balls")
    studio.wait(SHOWN)
    studio.settle()
    studio.click("button", "Save and run")
    studio.wait("[...document.querySelectorAll('button, a')].some((one) => one.textContent.includes('Open the report'))", 180)
    studio.click("button, a", "Open the report")
    studio.wait("document.querySelector('iframe')?.getAttribute('src')?.includes('/view/')")
    assert studio.browser.diagnostics() == []


@pytest.mark.parametrize("width", [1280, 400])
@pytest.mark.parametrize("dark", [False, True])
def test_axe_finds_nothing(studio, width, dark):  # noqa: F811
    studio.browser.view(width, 900, dark=dark, reduced_motion=True)
    for name in ("spatial-four-bar", "six-axis-arm"):
        take(studio, name)
        found = seen_by_axe(studio.browser, AXE.read_text())
        assert found == [], found
        assert studio.browser.diagnostics() == []
    # Nothing is wider than the window.
    assert studio.browser.evaluate("document.documentElement.scrollWidth") <= width

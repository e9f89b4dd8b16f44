"""Curves over the crank angle on one cursor with the mechanism, zones of paths at that angle, and traced points: by mouse and by keys, against `loosepin motion`."""

import csv
import json
import math
import re
import subprocess

import pytest  # noqa: F401
from check_pages import AXE, seen_by_axe
from test_studio import PROGRAM, browser, studio  # noqa: F401
from test_studio_edit import open_small
from test_studio_journeys import Keyboard
from test_studio_panes import box, mouse

CHOSEN = "[...document.querySelectorAll('.band .choose select')].map((one) => one.value)"
# The readings as [name, number, unit], with the angle before them.
READINGS = """(() => {
    const at = document.querySelector('.readings .at').innerText;
    return [at, ...[...document.querySelectorAll('.readings .reading')].map((one) => one.innerText)];
})()"""
ANGLE = "Number(document.querySelector('.band .ground').getAttribute('aria-valuenow'))"
# Turn of the crank, the first body that moves, in degrees.
CRANK = "Number(/rotate\\(([^)]*)\\)/.exec(document.querySelector('.drawing .body[data-body]').getAttribute('transform'))[1])"
CURVE = "document.querySelector('.band svg.chart .line.first')?.getAttribute('d') ?? ''"
# Corners of the zone and of that of the play alone, mm, with y up, and the larger semi-axis of the ellipse.
ZONE = """(() => {
    const pairs = (d) => [...d.matchAll(/[ML]\\s*(\\S+)\\s+([^\\sLMZh]+)/g)].map(([, x, y]) => [Number(x), Number(y)]);
    const read = (name) => pairs(document.querySelector('.drawing .zones-now .' + name).getAttribute('d'));
    return { corners: read('zone'), play: read('play'), ellipse: document.querySelector('.drawing .zones-now .scatter').getAttribute('rx') };
})()"""
TRACES = "[...document.querySelectorAll('.drawing .trace')].map((one) => one.getAttribute('class'))"
# Directions in which a zone is recorded.
DIRECTIONS = 16


def choose(studio, name, value):  # noqa: F811
    """A choice in a list, as a click in its menu makes it: headless Chromium shows none."""
    studio.wait(f"[...(document.querySelector('.band select.{name}')?.options ?? [])].some((one) => one.value === {value!r})")
    studio.browser.evaluate(f"""(() => {{
        const list = document.querySelector('.band select.{name}');
        list.value = {value!r};
        list.dispatchEvent(new Event('change', {{ bubbles: true }}));
    }})()""")
    studio.wait(f"document.querySelector('.band select.{name}').value === {value!r} && document.querySelector('.readings')")
    studio.settle()


def turn_to(studio, degrees):  # noqa: F811
    """By the slider of the player, whose steps of a degree are those of `loosepin motion`; gives the angle."""
    studio.browser.evaluate(f"""(() => {{
        const slider = document.querySelector('.play-bar input[type=range]');
        slider.value = {degrees};
        slider.dispatchEvent(new Event('input', {{ bubbles: true }}));
    }})()""")
    studio.wait(f"Math.abs({ANGLE} - {degrees}) <= 0.5")
    return studio.browser.evaluate(ANGLE)


def moved(studio, *more):  # noqa: F811
    """The columns of motion.csv and the summary that the command gives for the saved files."""
    command = [PROGRAM, "motion", "four-bar/study.toml", "--out", "moved", *more]
    done = subprocess.run(command, cwd=studio.folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    with open(studio.folder / "moved/motion.csv", newline="") as lines:
        rows = list(csv.DictReader(lines))
    columns = {name: [float(row[name]) for row in rows] for name in rows[0]}
    return columns, json.loads((studio.folder / "moved/summary.json").read_text())


def row_at(columns, degrees):
    angles = [math.degrees(angle) for angle in columns["crank_rad"]]
    found = min(range(len(angles)), key=lambda row: abs(angles[row] - degrees))
    assert abs(angles[found] - degrees) < 1e-4, f"no row at {degrees}°"
    return found


def number(reading):
    """The number of a reading, and half a unit of its last place."""
    text = re.search(r"−?[0-9][0-9.]*", reading)[0].replace("−", "-")
    return float(text), 0.5 * 10.0 ** -len(text.partition(".")[2])


def test_the_velocity_is_chosen_and_read_at_each_angle(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    open_small(studio, "four-bar")
    assert studio.browser.evaluate(CHOSEN)[0] == "", "the band is first"
    choose(studio, "quantity", "velocity")
    assert studio.browser.evaluate(CHOSEN) == ["velocity", "rocker"]
    # Chooser, readings and the whole chart are seen without scrolling.
    foot = box(studio, ".status-bar")[1]
    for selector in (".band select.quantity", ".band select.of", ".readings", ".band svg.chart"):
        _, top, _, height = box(studio, selector)
        assert 0 <= top and top + height <= foot, selector
    columns, _ = moved(studio)
    seen = set()
    for degrees in (40, 100, 217, 300, 360):
        degrees = turn_to(studio, degrees)
        at, reading = studio.browser.evaluate(READINGS)
        assert at == f"at {degrees % 360:.1f}°" and reading.endswith("rpm")
        shown, half = number(reading)
        due = columns["rocker_velocity_rad_s"][row_at(columns, degrees)] * 60 / math.tau
        assert abs(shown - due) <= 1.001 * half, f"{degrees}°: {reading} {due}"
        seen.add(reading)
    assert len(seen) == 5
    choose(studio, "of", "tracer")
    row = row_at(columns, turn_to(studio, 100))
    _, x, y, magnitude = studio.browser.evaluate(READINGS)
    dues = [columns[f"tracer_{axis}_velocity_m_s"][row] for axis in "xy"]
    for reading, due in zip((x, y, magnitude), (*dues, math.hypot(*dues)), strict=True):
        shown, half = number(reading)
        assert abs(shown - due) <= 1.001 * half and reading.endswith("m/s"), f"{reading} {due}"
    # Transmission angle and mechanical advantage are those of the command too.
    for quantity, of, column, factor in (
        ("transmission_angle", "coupler and rocker", "coupler_rocker_transmission_angle_rad", 180 / math.pi),
        ("mechanical_advantage", "rocker", "rocker_mechanical_advantage_1", 1.0),
    ):
        choose(studio, "quantity", quantity)
        assert studio.browser.evaluate(CHOSEN)[1] == of
        column = next(name for name in columns if name.startswith(column.rsplit("_", 1)[0]))
        shown, half = number(studio.browser.evaluate(READINGS)[1])
        assert abs(shown - factor * columns[column][row]) <= 1.001 * half
    assert studio.browser.diagnostics() == []


def test_the_cursor_of_the_chart_and_the_mechanism_are_one(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    open_small(studio, "four-bar")
    choose(studio, "quantity", "position")
    plot = studio.browser.evaluate("""(() => {
        const svg = document.querySelector('.band svg.chart');
        const [left, top, width, height] = svg.dataset.plot.split(' ').map(Number);
        const to = svg.getScreenCTM();
        const ends = [new DOMPoint(left, top).matrixTransform(to), new DOMPoint(left + width, top + height).matrixTransform(to)];
        return [ends[0].x, ends[0].y, ends[1].x, ends[1].y, ...svg.dataset.x.split(' ').map(Number)];
    })()""")
    x0, y0, x1, y1, first, last = plot
    for share in (0.25, 0.6, 0.9):
        mouse(studio, "mouseMoved", (x0 + share * (x1 - x0), 0.5 * (y0 + y1)))
        due = first + share * (last - first)
        studio.wait(f"Math.abs({ANGLE} - {due}) < 0.5")
        assert (studio.browser.evaluate(CRANK) - due + 180) % 360 - 180 == pytest.approx(0, abs=0.5), "the crank stands there"
        cursor = studio.browser.evaluate("document.querySelector('.band .cursor').getBoundingClientRect().x")
        assert cursor == pytest.approx(x0 + share * (x1 - x0), abs=1.5)
        # What is read is what is drawn there.
        at, reading = studio.browser.evaluate(READINGS)
        assert float(at.removeprefix("at ").removesuffix("°")) == pytest.approx(due % 360, abs=0.5)
    mouse(studio, "mouseMoved", (5, 5))
    # The player moves the cursor as well.
    before = studio.browser.evaluate(ANGLE)
    studio.click("button", "+1°")
    studio.wait(f"{ANGLE} === {round(before) + 1}")
    assert studio.browser.evaluate(READINGS)[0] == f"at {(round(before) + 1) % 360}°"
    studio.click(".play-bar button", "Play")
    studio.wait(f"Math.abs({ANGLE} - {round(before) + 1}) > 2")
    studio.click(".play-bar button", "Pause")
    assert studio.browser.diagnostics() == []


def test_a_curve_is_chosen_and_read_by_keys_alone_and_stays_over_a_reload(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    open_small(studio, "four-bar")
    keyboard = Keyboard(studio)
    keyboard.reach("select.quantity")
    keyboard.press("v")
    studio.wait("document.querySelector('.readings')")
    studio.settle()
    assert studio.browser.evaluate(CHOSEN) == ["velocity", "rocker"]
    keyboard.reach("select.of")
    keyboard.press("ArrowDown")
    studio.wait(f"({CHOSEN})[1] === 'tracer'")
    studio.settle()
    keyboard.reach(".band .ground")
    first = studio.browser.evaluate(ANGLE)
    for _ in range(3):
        keyboard.press("ArrowRight")
    assert studio.browser.evaluate(ANGLE) == pytest.approx(first + 3)
    keyboard.press("ArrowLeft", 8)
    assert studio.browser.evaluate(ANGLE) == pytest.approx(first - 7)
    # A screen reader says where the drive stands, and every value with its unit.
    said = studio.browser.evaluate("document.activeElement.getAttribute('aria-valuetext')")
    assert re.fullmatch(r"at [0-9.]+°: x −?[0-9.]+ m/s, y −?[0-9.]+ m/s, magnitude [0-9.]+ m/s", said), said
    assert studio.browser.evaluate("document.activeElement.role") == "slider"
    studio.browser.reload()
    studio.wait("document.querySelector('.readings') && document.querySelector('.field')")
    studio.settle()
    assert studio.browser.evaluate(CHOSEN) == ["velocity", "tracer"]
    # Another mechanism has no tracer: its first velocity is shown.
    studio.look_at("rank, rod and slider")
    assert studio.browser.evaluate(CHOSEN) == ["velocity", "slider"]
    keyboard.reach("select.quantity")
    keyboard.press("Home")
    studio.wait("document.querySelector('.band .largest')")
    assert studio.browser.evaluate("localStorage.getItem('loosepin-curve')") is None
    assert studio.browser.diagnostics() == []


def test_a_curve_follows_a_drag_and_a_number(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    open_small(studio, "four-bar")
    choose(studio, "quantity", "velocity")
    turn_to(studio, 100)
    before, reading = studio.browser.evaluate(CURVE), studio.browser.evaluate(READINGS)[1]
    x, y = studio.drag("rocker_pivot", (60, 20), is_let_go=False)
    studio.wait(f"({CURVE}) !== {before!r} && ({READINGS})[1] !== {reading!r}")
    mouse(studio, "mouseReleased", (x, y), button="left", clickCount=1)
    studio.settle()
    studio.click("button", "Undo")
    studio.settle()
    studio.wait(f"({CURVE}) === {before!r}")
    # Where nothing moves there is no curve, and the choice stays.
    studio.type_number("crank_length", "900 mm")
    studio.wait("document.querySelector('.band').classList.contains('stale') || document.querySelector('.readings') === null")
    studio.browser.evaluate("document.activeElement.blur()")
    studio.click("button", "Undo")
    studio.settle()
    studio.wait(f"({CURVE}) === {before!r}")
    assert studio.browser.diagnostics() == []


def test_the_zone_at_the_cursor_reaches_as_far_as_motion_says(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    open_small(studio, "four-bar")
    choose(studio, "quantity", "position")
    columns, summary = moved(studio)
    path = summary["paths"][0]
    # Reaches come to five digits of the largest, which corners of a thin zone enlarge five times.
    within_mm = 5e-4 * 1e3 * max(path["play_reach_m"])
    words = studio.browser.evaluate("document.querySelector('.drawing .scale-bar').innerText")
    factor = float(re.search(r"zone of the path × (\d+)", words)[1])
    for degrees in (100, 217):
        row = row_at(columns, turn_to(studio, degrees))
        found = studio.browser.evaluate(ZONE)
        spot = [1e3 * path["x_m"][row], 1e3 * path["y_m"][row]]
        major, minor, angle = (path[name][row] for name in ("scatter_major_m", "scatter_minor_m", "scatter_angle_rad"))
        for direction in range(DIRECTIONS):
            turned = math.pi * direction / DIRECTIONS
            # The support function of a polygon is that of its corners.
            reach = lambda corners: max((x - spot[0]) * math.cos(turned) + (y - spot[1]) * math.sin(turned) for x, y in corners) / factor  # noqa: B023, E731
            play_mm = 1e3 * path["play_reach_m"][DIRECTIONS * row + direction]
            scatter_mm = 1e3 * math.hypot(major * math.cos(turned - angle), minor * math.sin(turned - angle))
            assert reach(found["play"]) == pytest.approx(play_mm, abs=within_mm)
            assert reach(found["corners"]) == pytest.approx(play_mm + scatter_mm, abs=within_mm)
        assert float(found["ellipse"]) / factor == pytest.approx(1e3 * major, rel=1e-3)
    assert re.fullmatch("[125]0*", str(int(factor))), factor
    # The zone over the whole path is one of pieces that overlap.
    drawn = studio.browser.evaluate("document.querySelector('.drawing .zone-of-path').getAttribute('d')")
    assert drawn.count("M") == drawn.count("Z") == 120
    is_inside = """(() => {
        const whole = document.querySelector('.drawing .zone-of-path');
        const [x, y] = %s;
        return whole.isPointInFill(new DOMPoint(x, y));
    })()"""
    middle = [0.5 * (found["corners"][0][axis] + spot[axis]) for axis in (0, 1)]
    assert studio.browser.evaluate(is_inside % json.dumps(middle))
    beyond = [spot[axis] + 3 * (found["corners"][0][axis] - spot[axis]) for axis in (0, 1)]
    assert not studio.browser.evaluate(is_inside % json.dumps(beyond))
    # It follows a drag.
    before = studio.browser.evaluate(ZONE)["corners"]
    x, y = studio.drag("rocker_pivot", (40, 10), is_let_go=False)
    studio.wait(f"JSON.stringify(({ZONE}).corners) !== {json.dumps(before, separators=(',', ':'))!r}")
    mouse(studio, "mouseReleased", (x, y), button="left", clickCount=1)
    assert studio.browser.diagnostics() == []


def test_any_point_is_traced_by_a_click_and_by_keys(studio):  # noqa: F811
    studio.browser.view(1280, 800, reduced_motion=True)
    open_small(studio, "four-bar")
    choose(studio, "quantity", "velocity")
    assert studio.browser.evaluate(TRACES) == ["trace output"]
    # A click on the pin, and one on what its panel offers.
    studio.click(".outline button", "rocker_pin")
    studio.wait("document.querySelector('.chosen .trace-point')")
    name = studio.browser.evaluate("document.querySelector('.chosen .trace-point').getAttribute('aria-label')")
    point = re.search(r"Trace (\S+):", name)[1]
    studio.click(".chosen .trace-point")
    studio.wait(f"({TRACES}).includes('trace traced')")
    studio.settle()
    choose(studio, "of", point)
    columns, _ = moved(studio, "--path", point)
    row = row_at(columns, turn_to(studio, 100))
    _, x, y, _ = studio.browser.evaluate(READINGS)
    for reading, axis in ((x, "x"), (y, "y")):
        shown, half = number(reading)
        assert abs(shown - columns[f"{point}_{axis}_velocity_m_s"][row]) <= 1.001 * half
    assert studio.browser.evaluate(f"document.querySelector('.drawing .zones-now .zone[data-point=\"{point}\"]') !== null"), "with its zone"
    # Nothing is written for it.
    studio.wait_until_saved()
    # The list of points of a body offers it as well; what is recorded is said.
    studio.click(".outline button", "coupler")
    studio.wait("document.querySelectorAll('.chosen .points .trace-point').length > 0")
    assert "path recorded" in studio.browser.evaluate("document.querySelector('.chosen .points').innerText")
    studio.click(".outline button", "rocker_pin")
    studio.click(".chosen .trace-point")
    studio.wait(f"!({TRACES}).includes('trace traced')")
    keyboard = Keyboard(studio)
    keyboard.reach(".drawing .grip", "rocker_pin")
    keyboard.press("t")
    studio.wait(f"({TRACES}).includes('trace traced')")
    studio.settle()
    keyboard.press("t")
    studio.wait(f"!({TRACES}).includes('trace traced')")
    studio.settle()
    assert studio.browser.diagnostics() == []


@pytest.mark.parametrize("width", [1280, 400])
@pytest.mark.parametrize("dark", [False, True])
def test_curves_and_zones_are_accessible(studio, width, dark):  # noqa: F811
    axe = AXE.read_text()
    studio.browser.view(width, 800, dark=dark, reduced_motion=True)
    open_small(studio, "four-bar")
    choose(studio, "quantity", "velocity")
    choose(studio, "of", "tracer")
    if width == 400 and studio.browser.evaluate("!document.querySelector('.outline').open"):
        studio.click(".outline summary")
    studio.click(".outline button", "rocker_pin")
    studio.wait("document.querySelector('.chosen .trace-point')")
    studio.click(".chosen .trace-point")
    studio.wait(f"({TRACES}).includes('trace traced')")
    assert seen_by_axe(studio.browser, axe) == []
    assert studio.browser.evaluate("document.documentElement.scrollWidth") <= width
    assert studio.browser.diagnostics() == []

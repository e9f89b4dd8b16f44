"""The studio as a person uses it, in a real browser before the real program: what is done with the mouse stands in the files."""

import math
import pathlib
import subprocess
import sys
import time

import pytest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from check_pages import AXE, seen_by_axe  # noqa: E402
from chromium import Chromium  # noqa: E402

PROGRAM = REPOSITORY / "target/debug/loosepin"
# The middle of the first visible element that a selector finds and whose text contains some words; null until it is at rest
# (a chart above that appears moves it between the look and the click) and until a click there would reach it.
PLACE = """(async (selector, words) => {
    const found = [...document.querySelectorAll(selector)].find((one) => one.getClientRects().length > 0 && one.textContent.includes(words));
    if (!found) return null;
    found.scrollIntoView({ block: 'center' });
    const middle = () => { const box = found.getBoundingClientRect(); return [box.x + box.width / 2, box.y + box.height / 2]; };
    const before = middle();
    for (let frame = 0; frame < 3; frame += 1) await new Promise((next) => requestAnimationFrame(next));
    const [x, y] = middle();
    const hit = document.elementFromPoint(x, y);
    const isReached = found.isConnected && hit !== null && (found.contains(hit) || hit.contains(found));
    return isReached && x === before[0] && y === before[1] ? [x, y] : null;
})(%s, %s)"""
# The field of a number by its name.
FIELD = """((name) => [...document.querySelectorAll('.field')].find((field) => field.querySelector('label')?.textContent.replace('↔', '').trim() === name))(%s)"""
# Where a pin of the drawing is on the screen.
PIN = """((name) => {
    const place = [...document.querySelectorAll('.drawing .grip')].find((grip) => grip.dataset.joint === name).getScreenCTM();
    return [place.e, place.f];
})(%s)"""
BAND = "document.querySelector('svg.chart .fill')?.getAttribute('d') ?? ''"
LARGEST = "document.querySelector('.band .largest').innerText"
PROBLEMS = "document.querySelector('.problems').innerText"


class Studio:
    """A server of a folder, and the browser in front of it."""

    def __init__(self, folder, browser, *arguments):
        self.folder, self.browser = folder, browser
        command = [PROGRAM, "serve", folder, "--no-open", *arguments]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.address = self.process.stdout.readline().strip()
        assert self.address.startswith("http://127.0.0.1:"), self.process.stderr.read()
        self.clicks = 0

    def close(self):
        self.browser.leave()
        self.process.terminate()
        _, messages = self.process.communicate(timeout=60)
        assert "panicked" not in messages, messages
        assert self.process.returncode == 0, messages

    def open(self):
        self.browser.load(self.address)
        self.wait("document.querySelectorAll('button.card svg.mechanism').length === 17")

    def wait(self, condition, timeout_s=60.0):
        """Until a condition in the page is true."""
        deadline = time.monotonic() + timeout_s
        while time.monotonic() < deadline:
            if self.browser.evaluate(f"Boolean({condition})"):
                return
            time.sleep(0.05)
        raise AssertionError(f"not within {timeout_s} s: {condition}\n{self.browser.evaluate('document.body.innerText')}")

    def place(self, selector, words, timeout_s=60.0):
        """Where a click reaches an element that is at rest."""
        deadline = time.monotonic() + timeout_s
        while time.monotonic() < deadline:
            place = self.browser.evaluate(PLACE % (repr(selector), repr(words)))
            if place is not None:
                return place
            time.sleep(0.05)
        raise AssertionError(f"not at rest within {timeout_s} s: {selector} {words}\n{self.browser.evaluate('document.body.innerText')}")

    def click(self, selector, words=""):
        x, y = self.place(selector, words)
        self.clicks += 1
        for kind in ("mousePressed", "mouseReleased"):
            self.browser.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def key(self, key, modifiers=0):
        code = {"Enter": 13, "Escape": 27, "Home": 36, "ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40}.get(key) or ord(key.upper())
        for kind in ("rawKeyDown", "keyUp"):
            self.browser.call("Input.dispatchKeyEvent", type=kind, key=key, windowsVirtualKeyCode=code, modifiers=modifiers,
                              code=f"Key{key.upper()}" if len(key) == 1 else key)

    def pin(self, joint):
        """Where a pin of the drawing is on the screen."""
        return self.browser.evaluate(PIN % repr(joint))

    def drag(self, joint, by, steps=15, is_let_go=True):
        """Takes a pin and moves it by pixels of the screen."""
        (x, y), (right, down) = self.pin(joint), by
        mouse = lambda kind, share, **more: self.browser.call(  # noqa: E731
            "Input.dispatchMouseEvent", type=kind, x=x + share * right, y=y + share * down, button="left", **more)
        mouse("mousePressed", 0, clickCount=1)
        for step in range(1, steps + 1):
            mouse("mouseMoved", step / steps, buttons=1)
            time.sleep(0.02)
        if is_let_go:
            mouse("mouseReleased", 1, clickCount=1)
        return x + right, y + down

    def wait_until_saved(self):
        """Until both texts are again, letter for letter, as they are on the disk."""
        self.wait("document.querySelector('.bar').innerText.includes('· saved')")
        self.settle()

    def saved(self, folder):
        """Both texts as they are on the disk, after what is not saved yet is."""
        if any(word in self.browser.evaluate("document.querySelector('.bar').innerText") for word in ("unsaved", "not saved yet")):
            self.click("button:not(.primary)", "Save")
        self.wait_until_saved()
        return [(self.folder / folder / name).read_text() for name in ("model.toml", "study.toml")]

    def wait_for_line(self, folder, line):
        """Until the study has a line."""
        deadline = time.monotonic() + 30
        while line not in self.saved(folder)[1]:
            if time.monotonic() > deadline:
                raise AssertionError(f"not saved: {line}")
            time.sleep(0.05)

    def type_number(self, name, text):
        """Replaces what stands in the field of a number."""
        self.wait(FIELD % repr(name))
        self.browser.evaluate(f"(({FIELD % repr(name)}).querySelector('input').focus(), true)")
        self.browser.evaluate(f"(({FIELD % repr(name)}).querySelector('input').select(), true)")
        self.browser.call("Input.insertText", text=text)
        self.key("Enter")

    def number(self, name):
        return self.browser.evaluate(f"({FIELD % repr(name)})?.querySelector('input').value")

    def look_at(self, template):
        """Opens a template, whose title has these words: nothing is written."""
        self.open()
        self.click("button.card", template)
        self.wait("document.querySelector('svg.chart') && document.querySelector('.field')")
        self.settle()

    def take(self, template):
        """Begins with a template, and saves it."""
        self.look_at(template)
        self.click("button:not(.primary)", "Save")
        self.wait("location.hash.startsWith('#/edit/')")
        self.wait_until_saved()

    def settle(self):
        """Until the band is of the texts as they are, at the most positions."""
        self.wait("document.querySelector('.band')?.ariaBusy === 'false'")


@pytest.fixture(scope="module")
def browser():
    with Chromium() as browser:
        browser.view(1280, reduced_motion=True)
        yield browser


@pytest.fixture
def studio(tmp_path, browser):
    browser.view(1280, reduced_motion=True)
    studio = Studio(tmp_path, browser)
    yield studio
    studio.close()


def test_from_the_gallery_to_a_report_by_eight_clicks(studio):
    studio.take("rank, rod and slider")
    before = studio.browser.evaluate(BAND)
    studio.type_number("crank_length", "55 mm")
    # A dimension has one nominal value: that of the study follows.
    studio.wait(f"({BAND}) !== {before!r}")
    assert "No problems" in studio.browser.evaluate(PROBLEMS)
    studio.click("button", "Save and run")
    studio.wait("[...document.querySelectorAll('button, a')].some((one) => one.textContent.includes('Open the report'))", 300)
    studio.click("button, a", "Open the report")
    studio.wait("document.querySelector('iframe')?.getAttribute('src')?.includes('/view/')")
    assert studio.clicks <= 8
    assert studio.browser.diagnostics() == []
    model = studio.folder / "slider-crank/model.toml"
    assert 'crank_length = "55 mm"' in model.read_text()
    # The command on the saved files gives the same bytes.
    found = list((studio.folder / "results").glob("*/*/summary.json"))
    assert len(found) == 1
    out = studio.folder / "by_command"
    command = [PROGRAM, "study", "slider-crank/study.toml", "--out", out]
    done = subprocess.run(command, cwd=studio.folder, capture_output=True, text=True)
    assert done.returncode in (0, 1), done.stderr
    assert (out / "summary.json").read_bytes() == found[0].read_bytes()


def test_a_study_goes_on_after_the_server_was_killed(tmp_path, browser):
    folder = tmp_path / "mine"
    subprocess.run([PROGRAM, "new", "four-bar", folder], check=True, capture_output=True)
    study = folder / "study.toml"
    # Long enough to be killed, short enough for a test.
    study.write_text(study.read_text().replace("inner = 1024", "inner = 128"))
    done = "[...document.querySelectorAll('button, a')].some((one) => one.textContent.includes('Open the report'))"

    def run(studio):
        studio.open()
        studio.click("a, button", "four-bar with play")
        studio.wait("document.querySelector('svg.chart')")
        studio.click("button", "Save and run")

    first = Studio(tmp_path, browser)
    run(first)
    store = lambda: list((tmp_path / "results").glob("*/*/runs.sqlite"))  # noqa: E731
    deadline = time.monotonic() + 60
    while not (store() and store()[0].stat().st_size > 50_000) and time.monotonic() < deadline:
        time.sleep(0.05)
    assert not browser.evaluate(done), "it is killed in the middle"
    first.process.kill()
    first.process.communicate(timeout=60)
    assert store(), "the runs are kept"
    second = Studio(tmp_path, browser)
    run(second)
    second.wait(done, 300)
    second.close()
    found = list((tmp_path / "results").glob("*/*/summary.json"))
    assert len(found) == 1 and not store()
    out = tmp_path / "by_command"
    command = [PROGRAM, "study", "mine/study.toml", "--out", out]
    assert subprocess.run(command, cwd=tmp_path, capture_output=True, text=True).returncode in (0, 1)
    assert (out / "summary.json").read_bytes() == found[0].read_bytes()


def test_a_wrong_unit_is_told_at_its_place_and_undone(studio):
    studio.take("rank, coupler and rocker")
    first = studio.number("crank_length")
    # A busy machine begins with fewer positions.
    studio.settle()
    largest = studio.browser.evaluate(LARGEST)
    studio.type_number("crank_length", "80 mn")
    studio.wait(f"({PROBLEMS}).includes('mn')")
    assert studio.browser.evaluate("document.querySelector('svg.mechanism') !== null"), "the last good drawing stays"
    studio.browser.evaluate("document.activeElement.blur()")
    studio.click("button", "Undo")
    studio.wait(f"({FIELD % repr('crank_length')})?.querySelector('input').value === {first!r}")
    studio.wait(f"!({PROBLEMS}).includes('mn')")
    studio.settle()
    assert studio.browser.evaluate(LARGEST) == largest
    studio.click("[role=tab]", "model.toml")
    studio.wait("document.querySelector('.cm-content')")
    assert "80 mn" not in studio.browser.evaluate("document.querySelector('.cm-content').innerText")
    assert studio.browser.diagnostics() == []


def test_a_number_that_is_dragged_moves_the_band_and_is_one_step_to_undo(studio):
    studio.take("rank, coupler and rocker")
    first = studio.number("rocker_length")
    name = repr("rocker_length")
    studio.browser.evaluate(f"(({FIELD % name}).scrollIntoView({{block: 'center'}}), true)")
    x, y = studio.browser.evaluate(f"""(() => {{
        const box = ({FIELD % name}).querySelector('label').getBoundingClientRect();
        return [box.x + box.width - 8, box.y + box.height / 2];
    }})()""")
    bands = {studio.browser.evaluate(BAND)}
    studio.browser.call("Input.dispatchMouseEvent", type="mousePressed", x=x, y=y, button="left", clickCount=1)
    for step in range(1, 31):
        studio.browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=x + 2 * step, y=y, button="left", buttons=1)
        time.sleep(0.02)
        bands.add(studio.browser.evaluate(BAND))
    studio.browser.call("Input.dispatchMouseEvent", type="mouseReleased", x=x + 60, y=y, button="left", clickCount=1)
    assert studio.number("rocker_length") != first
    assert len(bands) > 3, "the band follows while the number is dragged"
    studio.click("button", "Undo")
    studio.wait(f"({FIELD % name})?.querySelector('input').value === {first!r}")
    assert studio.browser.diagnostics() == []


def test_a_pin_is_dragged_and_its_lengths_follow_in_both_texts(studio):
    studio.take("rank, coupler and rocker")
    before = studio.saved("four-bar")
    others = {joint: studio.pin(joint) for joint in ("crank_pivot", "rocker_pin", "rocker_pivot")}
    x, y = studio.drag("crank_pin", (45, -30), is_let_go=False)
    # What counts first is the text, and only then the picture. Lengths are round to the next of 1, 2, 5 above four pixels.
    crank, coupler = (f"{name}_length" for name in ("crank", "coupler"))
    scale = studio.browser.evaluate("document.querySelector('.drawing svg').getScreenCTM().a")
    step = next(step for step in (1, 2, 5, 10) if step * scale >= 4)
    lengths = [step * round(math.dist((x, y), others[joint]) / scale / step) for joint in ("crank_pivot", "rocker_pin")]
    studio.wait(f"document.querySelector('.drawing .over')?.innerText.includes('{coupler.replace('_', ' ')} {lengths[1]} mm')")
    found = studio.pin("crank_pin")
    # Lengths are round to a step of four pixels.
    assert abs(found[0] - x) < 4 and abs(found[1] - y) < 4
    for joint, (left, top) in others.items():
        found = studio.pin(joint)
        assert abs(found[0] - left) < 4 and abs(found[1] - top) < 4, joint
    studio.browser.call("Input.dispatchMouseEvent", type="mouseReleased", x=x, y=y, button="left", clickCount=1)
    studio.wait("document.querySelector('.drawing .over') === null")
    studio.settle()
    assert (studio.number(crank), studio.number(coupler)) == tuple(f"{length} mm" for length in lengths)
    after = studio.saved("four-bar")
    # The model has two other numbers, which the study follows. All else stays, comments too.
    changed = [[(old, new) for old, new in zip(first.split("\n"), second.split("\n"), strict=True) if old != new]
               for first, second in zip(before, after, strict=True)]
    assert [len(lines) for lines in changed] == [2, 0]
    assert all(new == old.replace("80 mm", f"{lengths[0]} mm").replace("260 mm", f"{lengths[1]} mm") for lines in changed for old, new in lines), changed
    # The texts have no fault. Whether the crank can turn fully is a matter of the lengths: ground 300 mm, rocker 180 mm.
    turns = lengths[0] + 300 <= lengths[1] + 180 and abs(300 - lengths[0]) >= abs(lengths[1] - 180)
    assert ("No problems" if turns else "the lengths do not permit a whole turn") in studio.browser.evaluate(PROBLEMS)
    studio.click("button", "Undo")
    studio.wait(f"({FIELD % repr('crank_length')})?.querySelector('input').value === '80 mm'")
    assert studio.saved("four-bar") == before, "one drag is one step to undo"
    assert studio.browser.diagnostics() == []


def test_a_drag_is_given_up_and_a_pin_is_moved_by_keys(studio):
    studio.take("rank, coupler and rocker")
    x, y = studio.drag("crank_pin", (45, -30), is_let_go=False)
    studio.wait("document.querySelector('.drawing .over')?.innerText.includes('crank length')")
    studio.key("Escape")
    studio.browser.call("Input.dispatchMouseEvent", type="mouseReleased", x=x, y=y, button="left", clickCount=1)
    studio.wait_until_saved()
    focus = "[...document.querySelectorAll('.drawing .grip')].find((grip) => grip.dataset.joint === 'rocker_pivot')"
    first = studio.number("base_length")
    studio.browser.evaluate(f"({focus}.focus(), true)")
    lengths = [first]
    for _ in range(3):
        studio.key("ArrowRight")
        studio.wait(f"({FIELD % repr('base_length')})?.querySelector('input').value !== {lengths[-1]!r}")
        lengths.append(studio.number("base_length"))
    assert sorted(lengths) == lengths, "the pin goes to the right"
    assert studio.browser.evaluate(f"document.activeElement === {focus}"), "the keyboard stays at its pin"
    studio.browser.evaluate("document.activeElement.blur()")
    while studio.number("base_length") != first:
        studio.click("button", "Undo")
        studio.settle()
    assert studio.browser.diagnostics() == []


def test_play_and_scatter_are_said_as_people_say_them(studio):
    studio.take("rank, coupler and rocker")
    clean = studio.saved("four-bar")
    x, y = studio.pin("crank_pin")
    for kind in ("mousePressed", "mouseReleased"):
        studio.browser.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)
    studio.wait("document.querySelector('.chosen')")
    band = studio.browser.evaluate(LARGEST)

    def say(text, field=".chosen .known input"):
        studio.browser.evaluate(f"(document.querySelector({field!r}).focus(), document.querySelector({field!r}).select(), true)")
        studio.browser.call("Input.insertText", text=text)
        studio.key("Enter")

    say("0.05..0.2 mn")
    studio.wait("document.querySelector('.chosen .kind').innerText.includes(\"'mn' is not a known unit\")")
    for text, entry in [("0.05..0.2", 'interval = ["0.05 mm", "0.2 mm"]'), ("H7/f7", 'fit = "H7/f7", diameter = "16 mm"'),
                        ("0.1, 0.2 mm", 'any_of = ["0.1 mm", "0.2 mm"]')]:
        say(text)
        studio.wait_for_line("four-bar", f'"joint.crank_pin.radial_clearance" = {{ {entry} }}')
        assert studio.browser.evaluate("document.querySelector('.chosen .kind').classList.contains('unknown')")
        shown = "document.querySelector('.chosen .known input').value"
        assert studio.browser.evaluate(shown) == (text if "m" in text or "/" in text else text + " mm")
    studio.settle()
    assert studio.browser.evaluate(LARGEST) != band, "a second pin with play widens the band"
    studio.click("button.more[aria-label*=crank_length]")
    known = "div.known input"
    say("±0.05", f".with-more + {known}")
    studio.wait(f"document.querySelector('.with-more + {known}').value === '± 0.05 mm'")
    studio.wait_for_line("four-bar", '"parameter.crank_length" = { tolerance = "± 0.05 mm" }')
    assert "No problems" in studio.browser.evaluate(PROBLEMS)
    studio.browser.evaluate("document.activeElement.blur()")
    for _ in range(4):
        studio.click("button", "Undo")
    studio.wait("document.querySelector('.chosen .kind').classList.contains('none')")
    assert studio.saved("four-bar") == clean, "each is one step to undo"
    assert studio.browser.diagnostics() == []


def test_a_link_that_is_taken_turns_the_mechanism(studio):
    studio.take("rank, coupler and rocker")
    (x, y), (right, bottom) = studio.pin("crank_pivot"), studio.pin("crank_pin")
    middle = [(x + right) / 2, (y + bottom) / 2]
    angle = "document.querySelector('.play-bar .angle').innerText"
    first = studio.browser.evaluate(angle)
    for kind, by in (("mousePressed", 0), ("mouseMoved", 15), ("mouseMoved", 30), ("mouseReleased", 30)):
        studio.browser.call("Input.dispatchMouseEvent", type=kind, x=middle[0] + by, y=middle[1], button="left", buttons=1, clickCount=1)
    assert studio.browser.evaluate(angle) != first
    assert studio.pin("crank_pin")[0] > right + 10, "the crank goes with the mouse"
    studio.settle()
    assert "unsaved" not in studio.browser.evaluate("document.querySelector('.bar').innerText"), "no text changes"
    assert studio.browser.diagnostics() == []


def test_a_limit_is_dragged_in_the_chart_and_added_where_there_is_none(studio):
    studio.take("rank, coupler and rocker")
    before = studio.saved("four-bar")
    kept = "document.querySelector('.band .kept')?.innerText"
    assert "stays within ±0.2" in studio.browser.evaluate(kept)
    place = """(() => {
        const box = document.querySelector('.band [data-limit="0"]').getBoundingClientRect();
        return [box.x + box.width / 2, box.y + box.height / 2];
    })()"""
    x, y = studio.browser.evaluate(place)
    for kind, by in [("mousePressed", 0)] + [("mouseMoved", by) for by in range(1, 26)]:
        studio.browser.call("Input.dispatchMouseEvent", type=kind, x=x, y=y + by, button="left", buttons=1, clickCount=1)
        time.sleep(0.02)
    studio.browser.call("Input.dispatchMouseEvent", type="mouseReleased", x=x, y=y + 25, button="left", clickCount=1)
    studio.wait(f"!({kept}).includes('±0.2°')")
    studio.settle()
    assert "does not" in studio.browser.evaluate(kept) or "goes beyond" in studio.browser.evaluate(kept)
    assert 'within = "0.2 deg"' not in studio.saved("four-bar")[1]
    studio.click("button", "Undo")
    studio.wait(f"({kept}).includes('stays within ±0.2°')")
    assert studio.saved("four-bar") == before, "one drag is one step to undo"
    studio.browser.evaluate("""(() => {
        const output = document.querySelector('.band select.of');
        output.value = 'tracer x';
        output.dispatchEvent(new Event('change', { bubbles: true }));
    })()""")
    studio.click("button", "Add a limit")
    studio.wait(f"({kept})?.includes('stays within')")
    studio.settle()
    assert "No problems" in studio.browser.evaluate(PROBLEMS)
    studio.click("button", "Undo")
    studio.wait_until_saved()
    assert studio.browser.diagnostics() == []


def test_a_drawing_is_imported_and_says_what_is_missing(studio, tmp_path):
    # A crank of 30 mm on the ground with its pin, and a text, which is no part of it; the unit is not said.
    crank = tmp_path.parent / "crank.dxf"
    crank.write_text("0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n1.5\n20\n2.5\n11\n31.5\n21\n2.5\n0\nCIRCLE\n8\nground\n10\n1.5\n20\n2.5\n"
                     "40\n4.5\n0\nCIRCLE\n8\n0\n10\n31.5\n20\n2.5\n40\n2.25\n0\nTEXT\n8\n0\n10\n5\n20\n5\n40\n2\n1\ncrank\n0\nENDSEC\n0\nEOF\n")

    def bring():
        document = studio.browser.call("DOM.getDocument")["root"]["nodeId"]
        field = studio.browser.call("DOM.querySelector", nodeId=document, selector="input[type=file]")["nodeId"]
        studio.browser.call("DOM.setFileInputFiles", nodeId=field, files=[str(crank)])

    studio.open()
    bring()
    studio.wait("document.body.innerText.includes('choose the unit beside the button')")
    studio.browser.evaluate("""(() => {
        const unit = document.querySelector('.unit select');
        unit.value = 'mm';
        unit.dispatchEvent(new Event('change', { bubbles: true }));
    })()""")
    bring()
    studio.wait("document.querySelector('.problems')?.innerText.includes('E0209')")
    said = studio.browser.evaluate("document.body.innerText")
    assert "1 thing is neither line nor polyline nor circle, and ignored" in said
    assert '"?"' in (studio.folder / "crank/model.toml").read_text()


def test_names_of_files_are_shown_as_text(studio):
    folder = studio.folder / "mine"
    subprocess.run([PROGRAM, "new", "four-bar", folder], check=True, capture_output=True)
    study = folder / "study.toml"
    text = study.read_text()
    hostile = '<img src=x onerror="window.isBroken = true"><script>window.isBroken = true</script>'
    study.write_text(text.replace('name = "', "name = '" + hostile, 1).replace('\nmodel', "'\nmodel", 1).replace("\"'", "'", 1))
    assert hostile in study.read_text()
    studio.open()
    studio.wait("document.body.innerText.includes('onerror')")
    studio.click("a, button", "onerror")
    studio.wait("document.querySelector('svg.chart')")
    assert studio.browser.evaluate("document.body.innerText.includes('onerror') && window.isBroken === undefined")
    assert studio.browser.diagnostics() == []


@pytest.mark.parametrize("width", [1280, 400])
@pytest.mark.parametrize("dark", [False, True])
def test_every_screen_is_accessible(studio, width, dark):
    axe = AXE.read_text()
    studio.browser.view(width, dark=dark, reduced_motion=True)
    studio.open()
    assert seen_by_axe(studio.browser, axe) == [], "gallery"
    studio.click("button", "Draw from nothing")
    studio.wait("document.querySelector('.tool-options .place')")
    studio.settle()
    assert seen_by_axe(studio.browser, axe) == [], "an empty sheet"
    studio.open()
    studio.click("button.card", "rank, coupler and rocker")
    studio.wait("document.querySelector('svg.chart') && document.querySelector('.field')")
    studio.browser.evaluate("(document.querySelector('details.outline').open = true)")
    studio.click(".outline button", "rocker_pin")
    studio.click("button.more")
    studio.wait("document.querySelectorAll('.known').length === 2")
    assert seen_by_axe(studio.browser, axe) == [], "editor"
    studio.click("[role=tab]", "study.toml")
    studio.wait("document.querySelector('.cm-content')")
    assert seen_by_axe(studio.browser, axe) == [], "text"
    assert studio.browser.diagnostics() == []

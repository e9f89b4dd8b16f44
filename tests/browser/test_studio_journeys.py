"""Ways through the studio from end to end: the first minute by keyboard alone; reloading, files that change outside, two tabs."""

import importlib.util
import json
import pathlib
import re
import subprocess
import sys
import time

import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from chromium import Chromium  # noqa: E402
from test_studio import FIELD, PROGRAM, REPOSITORY, Studio  # noqa: E402

# Windows key codes, and the text that the key types.
KEYS = {"Tab": (9, ""), "Enter": (13, "\r"), " ": (32, " "), "ArrowRight": (39, ""), "ArrowLeft": (37, ""), "ArrowDown": (40, ""), "ArrowUp": (38, ""),
        "Escape": (27, ""), "Home": (36, ""), "End": (35, "")}
CONTROL = 2
# Whether the keyboard is at the first element that a selector finds and whose text or name has some words.
AT = """((selector, words) => {
    const at = document.activeElement;
    return at !== null && at.matches(selector) && (at.textContent + ' ' + (at.getAttribute('aria-label') ?? '')).includes(words);
})(%r, %r)"""
DONE = "[...document.querySelectorAll('a')].some((one) => one.textContent.includes('Open the report'))"


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


class Keyboard:
    """Hands at the keys: no mouse, no script that moves the focus."""

    def __init__(self, studio):
        self.studio, self.browser = studio, studio.browser
        self.pressed = 0

    def press(self, key, modifiers=0):
        # Codes of other characters than letters and digits are those of other keys.
        own = lambda: (ord(key.upper()) if key.isascii() and key.isalnum() else 0, key)  # noqa: E731
        code, text = KEYS[key] if key in KEYS else own()
        typed = {} if modifiers & CONTROL or not text else {"text": text}
        kind = "keyDown" if typed else "rawKeyDown"
        self.browser.call("Input.dispatchKeyEvent", type=kind, key=key, windowsVirtualKeyCode=code, modifiers=modifiers, **typed)
        self.browser.call("Input.dispatchKeyEvent", type="keyUp", key=key, windowsVirtualKeyCode=code, modifiers=modifiers)
        self.pressed += 1

    def reach(self, selector, words="", most=120):
        """Tab until the keyboard is at an element."""
        for _ in range(most):
            if self.browser.evaluate(AT % (selector, words)):
                seen = self.browser.evaluate("document.activeElement.getClientRects().length > 0")
                assert seen, f"{selector} {words}: the keyboard is at what is not shown"
                return
            self.press("Tab")
        raise AssertionError(f"not reached by {most} tabs: {selector} {words}\n{self.browser.evaluate('document.body.innerText')}")

    def write(self, text):
        """Replaces what stands in the field, and takes it over."""
        self.press("a", CONTROL)
        for letter in text:
            self.press(letter)
        self.press("Enter")


def test_the_first_minute_by_keyboard_alone(studio):
    """Journey 2: from the gallery to the report, with play, tolerance and limit said on the way."""
    keyboard = Keyboard(studio)
    studio.open()
    keyboard.reach("button.card")
    for _ in range(14):
        if studio.browser.evaluate("document.activeElement.querySelector('.name')?.textContent") == "slider-crank":
            break
        keyboard.press("ArrowRight")
    keyboard.press("Enter")
    studio.wait("document.querySelector('svg.chart') && document.querySelector('.field')")
    studio.settle()
    assert list(studio.folder.iterdir()) == [], "nothing is written before it is saved"
    subprocess.run([PROGRAM, "new", "slider-crank", studio.folder / "template"], check=True, capture_output=True)
    before = (studio.folder / "template/study.toml").read_text()
    # Play: the pin is chosen in the outline.
    keyboard.reach(".outline summary")
    if not studio.browser.evaluate("document.querySelector('details.outline').open"):
        keyboard.press("Enter")
    keyboard.reach(".outline button", "gudgeon")
    keyboard.press("Enter")
    studio.wait("document.querySelector('.chosen .known input')")
    keyboard.reach(".chosen .known input")
    keyboard.write("0.1..0.3 mm")
    studio.wait("document.querySelector('.chosen .known input').value === '0.1..0.3 mm'")
    # A tolerance.
    keyboard.reach("button.more", "rod_length")
    keyboard.press("Enter")
    studio.wait("document.querySelector('.with-more + div.known input')")
    keyboard.reach(".with-more + div.known input")
    keyboard.write("±0.09")
    studio.wait("document.querySelector('.with-more + div.known input').value.includes('0.09 mm')")
    # The limit is a slider in the chart.
    keyboard.reach("[data-limit]")
    for _ in range(3):
        keyboard.press("ArrowDown")
    keyboard.reach("button.primary", "Save and run")
    keyboard.press("Enter")
    studio.wait(DONE, 300)
    keyboard.reach("a", "Open the report")
    keyboard.press("Enter")
    studio.wait("document.querySelector('iframe')?.getAttribute('src')?.includes('/view/')")
    # Until the page is there, Tab stays at the body of this one.
    studio.wait("!document.querySelector('.loading')")
    keyboard.reach("iframe")
    # What was said stands in the files, and nothing else has changed in the study but for these three.
    study = (studio.folder / "slider-crank/study.toml").read_text()
    assert 'interval = ["0.1 mm", "0.3 mm"]' in study and '{ tolerance = "±0.09 mm" }' in study.replace("± ", "±")
    limit = [line.split('"')[1] for line in study.split("\n") if line.startswith("within")]
    assert len(limit) == 1 and 0.4 < float(limit[0].split()[0]) < 0.6, limit
    changed = [(old, new) for old, new in zip(before.split("\n"), study.split("\n"), strict=True) if old != new]
    assert len(changed) == 3, changed
    # Each thing was near: a person would not sit there tabbing.
    assert keyboard.pressed < 250, keyboard.pressed
    assert studio.clicks == 0 and studio.browser.diagnostics() == []


def reload(studio):
    studio.browser.reload()
    studio.wait("document.querySelector('.bar')")


def run_four_bar(studio):
    """Starts the study of a four-bar that takes some seconds, in the folder `mine`."""
    folder = studio.folder / "mine"
    subprocess.run([PROGRAM, "new", "four-bar", folder], check=True, capture_output=True)
    study = folder / "study.toml"
    study.write_text(study.read_text().replace("inner = 1024", "inner = 128"))
    studio.open()
    studio.click("a, button", "four-bar with play")
    studio.wait("document.querySelector('svg.chart')")
    studio.click("button", "Save and run")


def test_a_study_is_followed_after_the_page_was_loaded_again(studio):
    """Journey 9: the server goes on; the page finds its study again."""
    run_four_bar(studio)
    studio.wait("document.querySelector('.job.running progress')?.value > 0", 120)
    assert not studio.browser.evaluate(DONE), "it is loaded again in the middle"
    reload(studio)
    studio.wait("document.querySelector('.job.running, .job.done')")
    studio.wait(DONE, 300)
    found = list((studio.folder / "results").glob("*/*/summary.json"))
    assert len(found) == 1 and json.loads(found[0].read_text())["counts"]["runs"] > 0
    assert studio.browser.diagnostics() == []


COARSE = "document.querySelector('.coarse svg.chart .fill')?.getAttribute('d') ?? ''"


def test_the_band_of_a_study_is_seen_while_it_runs_and_becomes_finer(studio):
    """Journey 7: from a few hundred runs first, then from all of each round."""
    run_four_bar(studio)
    studio.wait(f"({COARSE}) !== ''", 120)
    studio.click(".runs > button", "Runs")
    first, shown = studio.browser.evaluate(f"[{COARSE}, document.querySelector('.coarse').innerText]")
    # Words say what it is, and that it is none of the bounds.
    assert "Deviation of rocker" in shown and "No bound yet: it can still grow." in shown, shown
    runs = int(re.search(r"from ([0-9,]+) runs", shown)[1].replace(",", ""))
    assert 32 <= runs <= 1024, shown
    # It is put away, and stays so while it is refined.
    studio.click(".coarse summary")
    assert studio.browser.evaluate("document.querySelector('.coarse')?.open !== true")
    studio.wait(f"({COARSE}) !== {first!r} || ({DONE})", 300)
    assert studio.browser.evaluate("document.querySelector('.coarse')?.open !== true")
    studio.wait(DONE, 300)
    assert studio.browser.evaluate("document.querySelector('.coarse')") is None, "the report has the band"
    assert studio.browser.diagnostics() == []


def test_loading_again_in_the_middle_of_a_drag_leaves_the_files_as_they_are(studio):
    studio.take("rank, coupler and rocker")
    texts = lambda: [(studio.folder / "four-bar" / name).read_bytes() for name in ("model.toml", "study.toml")]  # noqa: E731
    before = texts()
    studio.drag("crank_pin", (45, -30), is_let_go=False)
    studio.wait("document.querySelector('.drawing .over')?.innerText.includes('crank length')")
    reload(studio)
    studio.wait("document.querySelector('svg.chart') && document.querySelector('.field')")
    studio.settle()
    assert texts() == before
    # What the drag had written is there again, as one step that Undo takes back.
    assert "unsaved" in studio.browser.evaluate("document.querySelector('.bar').innerText")
    assert studio.number("crank_length") != "80 mm"
    studio.click("button", "Undo")
    studio.wait(f"({FIELD % repr('crank_length')})?.querySelector('input').value === '80 mm'")
    studio.wait_until_saved()
    assert texts() == before


CHANGED = "[...document.querySelectorAll('.notice')].some((one) => one.innerText.includes('was changed on disk'))"


def test_a_file_that_changes_outside_is_loaded_or_written_over_as_the_person_says(studio):
    studio.take("rank, coupler and rocker")
    model = studio.folder / "four-bar/model.toml"
    first = model.read_text()
    # Changes are told by the time of the file, which is looked at each second.
    time.sleep(1.2)
    model.write_text(first.replace('crank_length = "80 mm"', 'crank_length = "90 mm"'))
    studio.wait(CHANGED)
    assert studio.number("crank_length") == "80 mm", "nothing is changed behind the person's back"
    studio.click("button", "Load the version on disk")
    studio.wait(f"({FIELD % repr('crank_length')})?.querySelector('input').value === '90 mm'")
    studio.wait(f"!({CHANGED})")
    studio.click("button", "Undo")
    studio.wait(f"({FIELD % repr('crank_length')})?.querySelector('input').value === '80 mm'")
    # Now both have changed it.
    studio.type_number("rocker_length", "170 mm")
    time.sleep(1.2)
    model.write_text(first.replace('crank_length = "80 mm"', 'crank_length = "70 mm"'))
    studio.wait(CHANGED)
    studio.click("button", "Keep mine and overwrite")
    studio.wait(f"!({CHANGED})")
    studio.wait_until_saved()
    assert model.read_text() == first.replace('rocker_length = "180 mm"', 'rocker_length = "170 mm"')


# A plain message: neither an alarm nor "another program".
IN_ANOTHER_TAB = "[...document.querySelectorAll('.notice.plain')].some((one) => one.innerText.includes('was saved in another tab of the studio'))"


def test_a_save_in_another_tab_is_no_alarm(studio):
    studio.take("rank, coupler and rocker")
    browser = studio.browser
    # The looks of this tab have told the server which files it has.
    time.sleep(1.2)
    with browser.another_tab(studio.address):
        studio.wait("document.querySelectorAll('button.card').length === 25")
        browser.evaluate("(location.hash = '#/edit/four-bar/study.toml', true)")
        studio.wait("document.querySelector('svg.chart') && document.querySelector('.field')")
        studio.type_number("crank_length", "90 mm")
        assert 'crank_length = "90 mm"' in studio.saved("four-bar")[0]
    studio.wait(IN_ANOTHER_TAB)
    assert not browser.evaluate(CHANGED) and studio.number("crank_length") == "80 mm"
    studio.click("button", "Load the version on disk")
    studio.wait(f"({FIELD % repr('crank_length')})?.querySelector('input').value === '90 mm'")
    assert browser.evaluate("document.querySelector('.notice') === null")


def test_two_tabs_see_the_same_files_and_runs(studio):
    studio.take("rank, rod and slider")
    with Chromium() as other:
        other.view(1280, reduced_motion=True)
        second = Studio.__new__(Studio)
        second.folder, second.browser, second.address, second.clicks = studio.folder, other, studio.address, 0
        second.open()
        second.click("a, button", "slider-crank with a worn pin")
        second.wait("document.querySelector('svg.chart') && document.querySelector('.field')")
        second.settle()
        # The looks of the second tab have told the server which files it has.
        time.sleep(1.2)
        studio.type_number("rod_length", "150 mm")
        studio.click("button", "Save and run")
        # Another browser before the same program: that is no other program.
        second.wait(IN_ANOTHER_TAB)
        assert second.number("rod_length") == "120 mm"
        # What the other tab has saved is not written over in silence.
        second.type_number("crank_length", "55 mm")
        second.click("button:not(.primary)", "Save")
        # It is refused, and asked anew what becomes of the texts.
        second.wait("[...document.querySelectorAll('.actions button')].some((one) => one.textContent.trim() === 'Save' && !one.disabled)")
        second.wait(IN_ANOTHER_TAB)
        assert not other.evaluate(CHANGED)
        model = studio.folder / "slider-crank/model.toml"
        assert 'rod_length = "150 mm"' in model.read_text() and 'crank_length = "50 mm"' in model.read_text()
        second.click("button", "Load the version on disk")
        second.wait(f"({FIELD % repr('rod_length')})?.querySelector('input').value === '150 mm'")
        for tab in (studio, second):
            tab.wait(DONE, 300)
        assert len(list((studio.folder / "results").glob("*/*/summary.json"))) == 1


def test_an_analysis_that_takes_too_long_is_cut_off_and_the_last_drawing_stays(studio):
    spec = importlib.util.spec_from_file_location("frames", REPOSITORY / "tools/studio/frames.py")
    frames = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(frames)
    texts = {}
    for four_bars in (1, 40):
        frames.FOUR_BARS = four_bars
        frames.chain(studio.folder / f"chain{four_bars}")
        texts[four_bars] = (studio.folder / f"chain{four_bars}/model.toml").read_text()
    studio.open()
    studio.browser.evaluate("(location.hash = '#/edit/chain1/study.toml', true)")
    studio.wait("document.querySelector('svg.mechanism') && document.querySelector('.field')")
    studio.settle()
    bodies = "document.querySelectorAll('.drawing [data-body]').length"
    before = studio.browser.evaluate(bodies)
    # The model becomes one of 81 bodies.
    time.sleep(1.2)
    (studio.folder / "chain1/model.toml").write_text(texts[40])
    studio.wait(CHANGED)
    studio.click("button", "Load the version on disk")
    studio.wait("document.querySelector('.drawing .over')?.innerText.includes('took longer than 2 s and was stopped')", 30)
    assert "shows the texts before" in studio.browser.evaluate("document.querySelector('.drawing .over').innerText")
    assert studio.browser.evaluate("document.querySelector('.drawing').classList.contains('stale')"), "it is seen to be of earlier texts"
    assert studio.browser.evaluate(bodies) == before, "the last good drawing stays"
    assert studio.browser.evaluate("document.querySelector('.band').ariaBusy") == "true"
    studio.click("button", "Undo")
    studio.wait("document.querySelector('.drawing .over') === null", 120)
    studio.settle()
    assert studio.browser.evaluate(bodies) == before
    assert studio.browser.diagnostics() == []

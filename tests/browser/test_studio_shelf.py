"""The gallery as a shelf of one's own work: pictures and verdicts, a template before it is saved, deletion with its way back, copies."""

import os
import pathlib
import subprocess
import sys
import time

import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from check_pages import AXE, seen_by_axe  # noqa: E402
from test_studio import PROGRAM, browser, studio  # noqa: E402, F401
from test_studio_journeys import Keyboard, reload  # noqa: E402

TITLE = "slider-crank with a worn pin"
# The card of a study by its path, and its words.
CARD = "[...document.querySelectorAll('.own')].find((one) => one.querySelector('.path').textContent === %r)"
WORDS = "((card) => card?.innerText ?? '')(" + CARD + ")"
CARDS = "[...document.querySelectorAll('.own .path')].map((one) => one.textContent)"
GALLERY = "document.querySelector('.shelf, #continue')"


def new(studio, name, template="slider-crank", replaced=()):  # noqa: F811
    """A study of one's own in the folder, short to run."""
    subprocess.run([PROGRAM, "new", template, studio.folder / name], check=True, capture_output=True)
    study = studio.folder / name / "study.toml"
    text = study.read_text().replace("outer = 16 ", "outer = 5 ").replace("at_least = 0.95 ", "at_least = 0.9 ")
    for old, with_ in replaced:
        assert old in text
        text = text.replace(old, with_)
    study.write_text(text)


def run(studio, name):  # noqa: F811
    done = subprocess.run([PROGRAM, "study", f"{name}/study.toml"], cwd=studio.folder, capture_output=True, text=True)
    assert done.returncode in (0, 1), done.stderr


def go_to_gallery(studio):  # noqa: F811
    studio.browser.evaluate("(location.hash = '#/', true)")
    studio.wait(GALLERY)


def files(studio):  # noqa: F811
    return sorted(str(path.relative_to(studio.folder)) for path in studio.folder.rglob("*") if path.is_file())


def test_ones_own_work_has_pictures_and_the_last_changed_is_first(studio):  # noqa: F811
    for name, template in [("old", "slider-crank"), ("broken", "four-bar"), ("newest", "scotch-yoke")]:
        new(studio, name, template)
    (studio.folder / "lone.toml").write_text((studio.folder / "old/model.toml").read_text())
    model = studio.folder / "broken/model.toml"
    model.write_text(model.read_text().replace('"80 mm"', '"80 mn"'))
    for age, path in enumerate(["newest/study.toml", "newest/model.toml", "lone.toml", "broken/model.toml", "broken/study.toml", "old/study.toml", "old/model.toml"]):
        os.utime(studio.folder / path, (time.time() - 60 * age,) * 2)
    studio.open()
    assert studio.browser.evaluate(CARDS) == ["newest/study.toml", "lone.toml", "broken/study.toml", "old/study.toml"]
    for path in ("newest/study.toml", "lone.toml", "old/study.toml"):
        studio.wait(f"({CARD % path}).querySelector('svg.mechanism')")
    studio.wait(f"({WORDS % 'broken/study.toml'}).includes(\"model.toml, line 8: 'mn' is not a known unit\")")
    assert "four-bar with play" in studio.browser.evaluate(WORDS % "broken/study.toml")
    assert "a model without a study" in studio.browser.evaluate(WORDS % "lone.toml")
    # They move as the templates do, where motion is welcome.
    pose = f"({CARD % 'old/study.toml'}).querySelector('[data-body=\"1\"], [data-body]:nth-of-type(2)')?.getAttribute('transform') + ({CARD % 'old/study.toml'}).querySelector('svg').innerHTML"
    before = studio.browser.evaluate(pose)
    studio.click("label.check", "Move the drawings")
    studio.wait(f"({pose}) !== {before!r}")
    # A file that changes comes to the front.
    (studio.folder / "old/model.toml").write_text((studio.folder / "old/model.toml").read_text() + "# changed\n")
    studio.open()
    assert studio.browser.evaluate(CARDS)[0] == "old/study.toml"
    assert studio.browser.diagnostics() == []


def test_a_verdict_knows_that_the_text_has_changed(studio):  # noqa: F811
    new(studio, "mine")
    run(studio, "mine")
    words = WORDS % "mine/study.toml"
    since = "the text has changed since"
    results = "document.querySelector('.results').innerText"
    studio.open()
    verdict = next(one for one in ("not met", "undecided", "met") if one in studio.browser.evaluate(words))
    assert since not in studio.browser.evaluate(words) and since not in studio.browser.evaluate(results)
    # Only the time is another one.
    model = studio.folder / "mine/model.toml"
    text = model.read_text()
    model.write_text(text)
    studio.open()
    assert since not in studio.browser.evaluate(words)
    model.write_text(text + "# changed\n")
    studio.open()
    assert verdict in studio.browser.evaluate(words) and since in studio.browser.evaluate(words)
    assert since in studio.browser.evaluate(results)
    studio.click(".own .actions a", "Report")
    studio.wait(f"document.querySelector('.bar').innerText.includes({since!r})")
    model.write_text(text)
    studio.open()
    assert since not in studio.browser.evaluate(words)
    assert studio.browser.diagnostics() == []


def test_a_template_is_looked_at_without_a_file_and_survives_a_reload(studio):  # noqa: F811
    studio.look_at("rank, coupler and rocker")
    bar = "document.querySelector('.bar').innerText"
    assert files(studio) == [] and "not saved yet" in studio.browser.evaluate(bar)
    # Left without a change, nothing is asked and nothing is left.
    studio.click("a", "Gallery")
    studio.wait("document.querySelectorAll('button.card').length === 25")
    assert files(studio) == []
    studio.click("button.card", "rank, coupler and rocker")
    studio.wait("document.querySelector('svg.chart') && document.querySelector('.field')")
    studio.type_number("crank_length", "85 mm")
    studio.settle()
    reload(studio)
    studio.wait("document.querySelector('svg.chart') && document.querySelector('.field')")
    # What is not saved is kept for its tab, and is no file of anybody's.
    (kept,) = files(studio)
    assert studio.number("crank_length") == "85 mm" and kept.startswith(".drafts/")
    # A changed one is not left without a question.
    studio.click("a", "Gallery")
    studio.click("button", "Stay")
    studio.click("button:not(.primary)", "Save")
    studio.wait("location.hash === '#/edit/four-bar/study.toml'")
    studio.wait_until_saved()
    assert files(studio) == ["four-bar/model.toml", "four-bar/study.toml"]
    assert 'crank_length = "85 mm"' in (studio.folder / "four-bar/model.toml").read_text()
    # The same desk goes on: what was done before can be undone.
    studio.browser.evaluate("document.activeElement.blur()")
    studio.click("button", "Undo")
    studio.wait("document.querySelector('.bar').innerText.includes('unsaved')")
    assert 'crank_length = "80 mm"' in studio.saved("four-bar")[0]
    # Back leads to the gallery, not to the template.
    studio.browser.evaluate("(history.back(), true)")
    studio.wait("document.querySelectorAll('button.card').length === 25")
    # A second one gets the next name, with the texts of the template.
    studio.click("button.card", "rank, coupler and rocker")
    studio.wait("document.querySelector('svg.chart') && document.querySelector('.field')")
    assert studio.number("crank_length") == "80 mm"
    studio.click("button:not(.primary)", "Save")
    studio.wait("location.hash === '#/edit/four-bar-2/study.toml'")
    # The browser notes that the first name was refused.
    assert [one for one in studio.browser.diagnostics() if "409 (Conflict)" not in one] == []


def test_a_template_that_is_changed_can_be_left_and_is_forgotten(studio):  # noqa: F811
    studio.look_at("rank, coupler and rocker")
    studio.type_number("crank_length", "85 mm")
    studio.click("a", "Gallery")
    studio.click("button", "Leave without saving")
    studio.wait("document.querySelectorAll('button.card').length === 25")
    studio.click("button.card", "rank, coupler and rocker")
    studio.wait("document.querySelector('svg.chart') && document.querySelector('.field')")
    assert studio.number("crank_length") == "80 mm" and files(studio) == []
    # *Save and leave* ends where the person wanted to go.
    studio.type_number("crank_length", "86 mm")
    studio.click("a", "Gallery")
    studio.click("button", "Save and leave")
    studio.wait("document.querySelectorAll('button.card').length === 25")
    studio.wait(f"({CARDS}).includes('four-bar/study.toml')")
    assert 'crank_length = "86 mm"' in (studio.folder / "four-bar/model.toml").read_text()


def test_a_study_is_deleted_and_comes_back(studio):  # noqa: F811
    new(studio, "mine")
    new(studio, "other", "four-bar")
    before = {path: (studio.folder / path).read_bytes() for path in files(studio)}
    studio.open()
    studio.clicks = 0
    studio.click("button[aria-label='Delete " + TITLE + "']")
    studio.wait(f"!({CARDS}).includes('mine/study.toml')")
    assert "It is in .trash/mine-study." in studio.browser.evaluate("document.querySelector('.undo').innerText")
    assert [path for path in files(studio) if not path.startswith(".trash/")] == ["other/model.toml", "other/study.toml"]
    studio.click(".undo button", "Undo")
    studio.wait(f"({CARDS}).includes('mine/study.toml')")
    assert {path: (studio.folder / path).read_bytes() for path in files(studio)} == before
    assert studio.browser.evaluate("document.querySelector('.undo')") is None and studio.clicks == 2
    # By keyboard alone: Delete on the card, Enter on Undo, and the keyboard is at the card again.
    keyboard = Keyboard(studio)
    keyboard.reach("a.card", TITLE)
    for kind in ("rawKeyDown", "keyUp"):
        studio.browser.call("Input.dispatchKeyEvent", type=kind, key="Delete", windowsVirtualKeyCode=46, modifiers=0)
    studio.wait(f"!({CARDS}).includes('mine/study.toml')")
    studio.wait("document.activeElement?.closest('.undo')")
    keyboard.press("Enter")
    studio.wait(f"({CARDS}).includes('mine/study.toml')")
    studio.wait("document.activeElement?.querySelector('.path')?.textContent === 'mine/study.toml'")
    keyboard.press("ArrowLeft")
    assert studio.browser.evaluate("document.activeElement.querySelector('.path').textContent") != "mine/study.toml"
    assert studio.browser.diagnostics() == []


def test_a_listing_from_before_a_deletion_brings_nothing_back(studio):  # noqa: F811
    new(studio, "mine")
    new(studio, "other", "four-bar")
    # The first listing is held up: the one after it fills the shelf.
    held = studio.browser.call("Page.addScriptToEvaluateOnNewDocument", source="""
        const straight = window.fetch;
        window.fetch = async (address, options) => {
            const answer = await straight(address, options);
            if (String(address).endsWith('/api/folder') && window.isHeld === undefined) {
                window.isHeld = true;
                await new Promise((next) => { window.goOn = next; });
                setTimeout(() => { window.isHeld = false; }, 200);
            }
            return answer;
        };""")["identifier"]
    try:
        studio.open()
        studio.wait("window.isHeld === true && window.goOn")
        studio.click("button[aria-label='Delete " + TITLE + "']")
        studio.wait(f"!({CARDS}).includes('mine/study.toml')")
        studio.browser.evaluate("(window.goOn(), true)")
        studio.wait("window.isHeld === false")
        assert studio.browser.evaluate(CARDS) == ["other/study.toml"]
    finally:
        studio.browser.call("Page.removeScriptToEvaluateOnNewDocument", identifier=held)


def test_a_result_is_deleted_and_what_cannot_be_moved_back_says_why(studio):  # noqa: F811
    new(studio, "mine")
    run(studio, "mine")
    studio.open()
    rows = "document.querySelectorAll('.results li').length"
    studio.wait(f"{rows} === 1")
    studio.click(".results button", "Delete")
    studio.wait(f"{rows} === 0 || document.querySelector('.results') === null")
    studio.wait(f"({WORDS % 'mine/study.toml'}).includes('not run yet')")
    # It was run again meanwhile: nothing is replaced.
    run(studio, "mine")
    studio.click(".undo button", "Undo")
    studio.wait("document.querySelector('.notice.error')?.innerText.includes('is there again; nothing was moved back')")
    assert len(list(studio.folder.glob(".trash/*/results/*/*/summary.json"))) == 1
    assert len(list(studio.folder.glob("results/*/*/summary.json"))) == 1


def test_a_study_is_copied_beside_itself(studio):  # noqa: F811
    new(studio, "mine")
    studio.open()
    keyboard = Keyboard(studio)
    keyboard.reach("a.card", TITLE)
    keyboard.reach("button", "Duplicate")
    keyboard.press("Enter")
    studio.wait(f"({CARDS}).includes('mine/study-2.toml')")
    studio.wait("document.activeElement?.querySelector('.path')?.textContent === 'mine/study-2.toml'")
    keyboard.press("Enter")
    studio.wait("document.querySelector('svg.chart') && document.querySelector('.field')")
    studio.settle()
    assert f"{TITLE} 2" in studio.browser.evaluate("document.querySelector('.bar').innerText")
    assert "No problems" in studio.browser.evaluate("document.querySelector('.problems').innerText")
    assert studio.clicks == 0 and studio.browser.diagnostics() == []


@pytest.mark.parametrize("width", [1280, 400])
@pytest.mark.parametrize("dark", [False, True])
def test_the_shelf_is_accessible(studio, width, dark):  # noqa: F811
    new(studio, "mine")
    run(studio, "mine")
    new(studio, "broken", "four-bar")
    for path in ("broken/model.toml", "mine/model.toml"):
        text = (studio.folder / path).read_text()
        (studio.folder / path).write_text(text.replace('"80 mm"', '"80 mn"') + "# changed\n")
    new(studio, "third", "scotch-yoke")
    studio.browser.view(width, dark=dark, reduced_motion=True)
    studio.open()
    studio.wait("document.querySelector('.own .fault') && document.querySelector('.own svg.mechanism')")
    studio.click("button[aria-label^='Delete Scotch']")
    studio.wait("document.querySelector('.undo')")
    assert seen_by_axe(studio.browser, AXE.read_text()) == []
    assert studio.browser.evaluate("document.documentElement.scrollWidth <= document.documentElement.clientWidth")
    assert studio.browser.diagnostics() == []

"""Results in the studio, in a real browser before the real program: two compared, a witness run by itself, a value made the model."""

import csv
import io
import json
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree

import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from check_pages import AXE, check, seen_by_axe  # noqa: E402
from chromium import Chromium  # noqa: E402
from test_studio import PROGRAM, Studio  # noqa: E402
from test_studio_journeys import Keyboard  # noqa: E402

NARROWER = ('["0.1 mm", "0.5 mm"]', '["0.1 mm", "0.15 mm"]')
# A choice of a list, as a person makes it.
CHOOSE = """((place, path) => {
    const list = document.querySelectorAll('.choose select')[place];
    list.value = path;
    list.dispatchEvent(new Event('change', { bubbles: true }));
    return list.value === path;
})(%d, %s)"""
HEADLINE = "document.querySelector('.headline')?.innerText ?? ''"
ROWS = "[...document.querySelectorAll('%s tbody tr')].map((row) => [...row.cells].map((cell) => cell.innerText.trim()))"
# What stands in a report: the value farthest from the middle on the map, chosen by its key.
CHOSEN = """(() => {
    const dots = [...document.querySelectorAll('[data-what-if] .map circle')];
    dots[0].dispatchEvent(new KeyboardEvent('keydown', { key: 'Enter', bubbles: true, cancelable: true }));
    return document.querySelector('[data-what-if] .chosen').textContent;
})()"""


# The list stands where it stays, and is drawn there.
SETTLED = """new Promise((done) => {
    document.querySelector('.witnesses button').scrollIntoView({ block: 'center' });
    setTimeout(() => requestAnimationFrame(() => requestAnimationFrame(() => done(true))), 1500);
})"""


@pytest.fixture(scope="module")
def browser():
    with Chromium() as browser:
        browser.view(1280, reduced_motion=True)
        yield browser


@pytest.fixture(scope="module")
def conducted(tmp_path_factory):
    """A folder with a slider-crank and the same with less play, both conducted by the command."""
    folder = tmp_path_factory.mktemp("conducted")
    results = {}
    for name, replaced in [("worn", []), ("measured", [NARROWER])]:
        subprocess.run([PROGRAM, "new", "slider-crank", folder / name], check=True, capture_output=True)
        study = folder / name / "study.toml"
        text = study.read_text().replace("outer = 16 ", "outer = 6 ").replace("at_least = 0.95 ", "at_least = 0.9 ")
        for old, new in replaced:
            assert old in text
            text = text.replace(old, new)
        study.write_text(text.replace('worn pin"', f'{name} pin"', 1))
        done = subprocess.run([PROGRAM, "study", f"{name}/study.toml"], cwd=folder, capture_output=True, text=True)
        assert done.returncode in (0, 1), done.stderr
    for summary in (folder / "results").glob("*/*/summary.json"):
        results[json.loads(summary.read_text())["name"].split()[-2]] = str(summary.parent.relative_to(folder))
    assert set(results) == {"worn", "measured"}
    return folder, results


@pytest.fixture
def studio(conducted, browser):
    browser.view(1280, reduced_motion=True)
    studio = Studio(conducted[0], browser)
    yield studio
    studio.close()


def in_report(browser, expression):
    """The value of an expression in the page of the report, which has an origin of its own."""
    targets = browser.call("Target.getTargets")["targetInfos"]
    frames = [target for target in targets if target["type"] == "iframe" and "/view/" in target["url"]]
    if frames:
        session = browser.session
        browser.session = browser.call("Target.attachToTarget", targetId=frames[0]["targetId"], flatten=True)["sessionId"]
        try:
            return browser.evaluate(expression)
        finally:
            browser.session = session
    tree = browser.call("Page.getFrameTree")["frameTree"]
    frame = tree["childFrames"][0]["frame"]["id"]
    world = browser.call("Page.createIsolatedWorld", frameId=frame)["executionContextId"]
    answer = browser.call("Runtime.evaluate", expression=expression, contextId=world, returnByValue=True)
    assert "exceptionDetails" not in answer, answer
    return answer["result"].get("value")


def open_report(studio, result):
    studio.open()
    studio.browser.evaluate(f"(location.hash = '#/report/{result}', true)")
    studio.wait("document.querySelector('.doings') && document.querySelector('iframe')?.getAttribute('src')?.includes('/view/')")
    studio.wait("document.querySelector('.report .loading') === null")


def test_two_results_are_compared_side_by_side(studio, conducted):
    _, results = conducted
    studio.open()
    studio.click("a", "Compare two results")
    studio.wait("document.querySelectorAll('.choose option').length >= 6")
    assert studio.browser.evaluate(CHOOSE % (0, json.dumps(results["worn"])))
    studio.wait("document.querySelectorAll('.choose select')[0].value !== ''")
    assert studio.browser.evaluate(CHOOSE % (1, json.dumps(results["measured"])))
    studio.wait("document.querySelector('.compare svg.chart')")
    # The same result is not offered on the other side.
    assert studio.browser.evaluate("[...document.querySelectorAll('.choose select')[1].options].find((one) => one.disabled && one.value !== '').value") == results["worn"]
    # The verdicts first. At the poses at which the bands are widest the errors are smaller than the difference; elsewhere they are not.
    headline = studio.browser.evaluate(HEADLINE)
    assert headline.startswith("Deviation of slider over the whole cycle: not met in A, met in B. ") and headline.endswith("smaller."), headline
    assert studio.browser.evaluate("document.querySelectorAll('.compare svg.chart .curves .fill').length") == 2
    inputs = studio.browser.evaluate(ROWS % ".inputs")
    told = {row[0].split("\n")[-1]: row[1:] for row in inputs}
    assert told["joint.gudgeon.radial_clearance"] == ["uncertain", "somewhere between 0.1 mm and 0.5 mm", "somewhere between 0.1 mm and 0.15 mm"]
    assert told["name"][0] == "study" and len(told) == 2, told
    # Each number is that of the two summaries: the upper mean of the largest deviation, and its difference.
    ends = []
    for name in ("worn", "measured"):
        summary = json.loads((studio.folder / results[name] / "summary.json").read_text())
        bound = next(bound for bound in summary["bounds"] if bound["at"]["kind"] == "reduced" and bound["statistic"]["kind"] == "mean")
        ends.append(bound["upper"])
    rows = studio.browser.evaluate(ROWS % ".numbers")
    row = next(row for row in rows[1:] if row[0] == "upper")
    number = lambda text: float(text.replace("−", "-").replace(" ", " ").split()[0])  # noqa: E731
    for shown, end in zip(row[1:3], ends, strict=True):
        # The value found and its error, which reach to the bound to rely on.
        value, error = shown.split("±")
        assert abs(number(value) - 1e3 * end["value_si"]) < 0.05 * number(value), (shown, end)
        assert 0 <= number(value) + number(error) - 1e3 * end["widened_si"] < 0.05 * number(value), (shown, end)
    difference = 1e3 * (ends[1]["value_si"] - ends[0]["value_si"])
    assert abs(number(row[3]) - difference) < 0.05 * abs(difference) and row[4] == "larger", (row, difference)
    before = studio.browser.evaluate(HEADLINE)
    studio.click("button", "Swap A and B")
    studio.wait(f"({HEADLINE}) !== {before!r}")
    # What was in A is in B now.
    (limit, *bounds), (same_limit, *swapped) = (re.findall(r"±([\d.]+)", headline) for headline in (before, studio.browser.evaluate(HEADLINE)))
    assert limit == same_limit and swapped == bounds[::-1]
    studio.browser.evaluate("(history.back(), true)")
    studio.wait(f"({HEADLINE}) === {before!r}")
    assert studio.browser.diagnostics() == []


def test_what_is_no_pair_is_refused_with_words(studio, conducted):
    _, results = conducted
    studio.open()
    studio.browser.evaluate(f"(location.hash = '#/compare/{results['worn'].replace('/', '%2F')}/{results['worn'].replace('/', '%2F')}', true)")
    studio.wait("document.querySelector('.notice.error')?.innerText.includes('both are the same result')")
    studio.browser.evaluate(f"(location.hash = '#/compare/{results['worn'].replace('/', '%2F')}/..%2Fsecret', true)")
    studio.wait("document.querySelector('.notice.error')?.innerText.includes('is not a path in the served folder')")
    assert studio.browser.evaluate("document.querySelector('.headline') === null")


COMPARED = "document.querySelector('.compare .headline')"
PICKED = "document.querySelectorAll('.pick button:not([aria-disabled=true])').length"


def test_two_results_are_compared_by_three_clicks(studio, conducted):
    _, results = conducted
    studio.open()
    studio.clicks = 0
    top = studio.browser.evaluate("[...document.querySelectorAll('a')].find((one) => one.textContent === 'Compare two results').getBoundingClientRect().top")
    assert top < 100, "seen without scrolling"
    studio.click("a", "Compare two results")
    studio.click(".pick button", results["worn"])
    studio.wait("(document.querySelector('.compare')?.innerText ?? '').includes('Choose result B.')")
    studio.click(".pick button:not([aria-disabled=true])", results["measured"])
    studio.wait(COMPARED)
    assert studio.clicks == 3
    # What differs in the inputs stands before the answers of both.
    assert studio.browser.evaluate("""Boolean(document.querySelector('#inputs').compareDocumentPosition(document.querySelector('.sides'))
        & Node.DOCUMENT_POSITION_FOLLOWING)""")
    assert studio.browser.evaluate("document.querySelector('.pick') === null")
    assert studio.browser.diagnostics() == []


def test_two_results_are_compared_by_keyboard_alone(studio, conducted):
    studio.open()
    keyboard = Keyboard(studio)
    keyboard.reach("a", "Compare two results")
    keyboard.press("Enter")
    studio.wait(f"{PICKED} >= 2")
    keyboard.reach(".pick button")
    keyboard.press("ArrowDown")
    keyboard.press("Enter")
    studio.wait("(document.querySelector('.compare')?.innerText ?? '').includes('Choose result B.')")
    # The keyboard is where it was.
    keyboard.press("ArrowUp")
    keyboard.press("Enter")
    studio.wait(f"{COMPARED} || document.querySelector('.notice.error')")
    assert studio.browser.evaluate(f"{COMPARED} !== null")
    assert studio.browser.diagnostics() == []


def test_without_results_the_page_says_what_to_do(tmp_path, browser):
    studio = Studio(tmp_path, browser)
    studio.open()
    studio.click("a", "Compare two results")
    studio.wait("(document.querySelector('.compare')?.innerText ?? '').includes('No study is finished yet.')")
    studio.click("a", "Choose a mechanism")
    studio.wait("document.querySelectorAll('button.card').length === 25")
    studio.close()


def test_the_run_behind_a_bound_is_made_by_one_click(studio, conducted):
    folder, results = conducted
    open_report(studio, results["worn"])
    studio.click(".doings summary")
    studio.wait("document.querySelector('.witnesses button')")
    told = studio.browser.evaluate("document.querySelector('.witnesses li').innerText")
    assert "gudgeon radial clearance 0.5" in told and "fewest mechanisms stay within the limit" in told
    # Where a frame of another process was a moment ago, the mouse still meets it.
    studio.wait("document.querySelector('.witnesses button:not(:disabled)')")
    studio.browser.evaluate(SETTLED)
    studio.click(".witnesses button:not(:disabled)", "Run")
    studio.wait("document.querySelector('.bar .path')?.innerText.startsWith('results/slider-crank/')", 120)
    studio.wait("document.querySelector('iframe')?.getAttribute('src')?.includes('/view/') && !document.querySelector('.report .loading')")
    # It moves, it has the curve of the output, and says with what it was run.
    page = in_report(studio.browser, "document.body.innerText")
    assert "gudgeon" in page and "0.5" in page
    assert in_report(studio.browser, "document.querySelectorAll('[data-mechanism] svg').length") == 1
    assert in_report(studio.browser, "[...document.querySelectorAll('[data-chart] svg.chart')].length") >= 1
    # The command that the study tells gives the same bytes, but for the minute that the page states.
    without_minute = lambda path: re.sub(rb"\d{4}-\d\d-\d\d \d\d:\d\d UTC", b"", path.read_bytes())  # noqa: E731
    run = studio.browser.evaluate("document.querySelector('.bar .path').innerText")
    summary = json.loads((folder / results["worn"] / "summary.json").read_text())
    command = summary["witness_commands"][0]["command"].replace("loosepin ", f"{PROGRAM} ", 1)
    done = subprocess.run(f"{command} --out {folder / 'by_command'}", shell=True, cwd=folder / "worn", capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    for name in ("summary.json", "history.csv", "impacts.csv", "report.html"):
        assert without_minute(folder / "by_command" / name) == without_minute(folder / run / name), name


def test_a_value_of_the_report_is_made_the_model(studio, conducted):
    folder, results = conducted
    texts = lambda: [(folder / "worn" / name).read_text() for name in ("model.toml", "study.toml")]  # noqa: E731
    before = texts()
    open_report(studio, results["worn"])
    said = in_report(studio.browser, CHOSEN)
    studio.wait("document.querySelector('.doings [role=status]')?.innerText.includes('Chosen in the report')")
    shown = studio.browser.evaluate("document.querySelector('.doings [role=status]').innerText")
    assert said.split(":")[0].lower() in shown.lower()
    studio.click("button", "Make it the model")
    studio.wait("document.querySelector('svg.chart') && document.querySelector('.field')")
    studio.wait("document.querySelector('.notice.plain')?.innerText.includes('Now known exactly')")
    studio.settle()
    assert "No problems" in studio.browser.evaluate("document.querySelector('.problems').innerText")
    assert "unsaved" in studio.browser.evaluate("document.querySelector('.bar').innerText")
    after = studio.saved("worn")
    assert "joint.gudgeon" not in after[1] and "joint.gudgeon" in before[1]
    changed = [(old, new) for old, new in zip(before[0].split("\n"), after[0].split("\n"), strict=True) if old != new]
    assert 1 <= len(changed) <= 2 and all(old.split("=")[0] == new.split("=")[0] for old, new in changed), changed
    assert all(old.partition("#")[2] == new.partition("#")[2] for old, new in changed), "comments stay"
    studio.click("button", "Undo")
    assert studio.saved("worn") == before, "it is one step to undo"
    assert studio.browser.diagnostics() == []


def test_a_page_in_the_frame_cannot_choose_what_is_not_there(studio, conducted):
    _, results = conducted
    open_report(studio, results["worn"])
    for message in ("{kind: 'loosepin-known', place: 99999}", "{kind: 'loosepin-known', place: '0'}", "{kind: 'other', place: 0}", "null", "'loosepin-known'",
                    "{kind: 'loosepin-known', place: 0.5}", "{kind: 'loosepin-known', place: -1}"):
        in_report(studio.browser, f"(parent.postMessage({message}, '*'), true)")
    # From another window than the frame.
    studio.browser.evaluate("(postMessage({kind: 'loosepin-known', place: 0}, '*'), true)")
    studio.browser.evaluate("new Promise((done) => setTimeout(() => done(true), 200))")
    assert studio.browser.evaluate("document.querySelector('.doings [role=status]') === null")
    assert studio.browser.diagnostics() == []


def test_a_report_of_the_studio_is_whole_without_it(browser, conducted, tmp_path):
    """Journey 10: opened from the disk, without a network: play, linked cursors, scripts off, paper; its figures are pictures and tables."""
    folder, results = conducted
    assert check(browser, str(folder / results["worn"] / "report.html"), AXE.read_text(encoding="utf-8"), None) == []
    names = subprocess.run([PROGRAM, "report", folder / results["worn"], "--list"], check=True, capture_output=True, text=True).stdout
    assert "deviation.slider" in names
    picture, table = tmp_path / "band.svg", tmp_path / "band.csv"
    subprocess.run([PROGRAM, "report", folder / results["worn"], "--figure", "deviation.slider", "--svg", picture, "--csv", table],
                   check=True, capture_output=True)
    assert xml.etree.ElementTree.parse(picture).getroot().tag.endswith("svg")
    curve = json.loads((folder / results["worn"] / "summary.json").read_text())["curves"][0]
    rows = list(csv.reader(io.StringIO("".join(line for line in table.open() if not line.startswith("#")))))
    assert len(rows) == 1 + len(curve["pose_rad"])
    # The first columns are the angle and the band for all unknown values, mm.
    for row, low, high in zip(rows[1:], curve["mixed"]["lower_si"], curve["mixed"]["upper_si"], strict=True):
        assert abs(float(row[1]) - 1e3 * low) < 1e-4 and abs(float(row[2]) - 1e3 * high) < 1e-4


@pytest.mark.parametrize("width", [1280, 400])
@pytest.mark.parametrize("dark", [False, True])
def test_screens_of_results_are_accessible(studio, conducted, width, dark):
    _, results = conducted
    axe = AXE.read_text()
    studio.browser.view(width, dark=dark, reduced_motion=True)
    studio.open()
    studio.browser.evaluate("(location.hash = '#/compare//', true)")
    studio.wait("document.querySelectorAll('.choose option').length >= 6")
    assert seen_by_axe(studio.browser, axe) == [], "nothing chosen"
    pair = [results[name].replace("/", "%2F") for name in ("worn", "measured")]
    studio.browser.evaluate(f"(location.hash = '#/compare/{pair[0]}/{pair[1]}', true)")
    studio.wait("document.querySelector('.compare svg.chart')")
    assert seen_by_axe(studio.browser, axe) == [], "compared"
    wide = studio.browser.evaluate("document.documentElement.scrollWidth - document.documentElement.clientWidth")
    assert wide <= 0, "no sideways scrolling of the page"
    open_report(studio, results["worn"])
    studio.click(".doings summary")
    studio.wait("document.querySelector('.witnesses button')")
    in_report(studio.browser, CHOSEN)
    studio.wait("document.querySelector('.doings [role=status]')")
    assert seen_by_axe(studio.browser, axe) == [], "report"
    assert studio.browser.diagnostics() == []


def test_one_cursor_reads_both_bands(studio, conducted):
    _, results = conducted
    studio.open()
    pair = "/".join(results[name].replace("/", "%2F") for name in ("worn", "measured"))
    studio.browser.evaluate(f"(location.hash = '#/compare/{pair}', true)")
    studio.wait("document.querySelector('.compare svg.chart')")
    reading = "document.querySelector('.compare .reading').innerText"
    assert "Point at a chart" in studio.browser.evaluate(reading)
    studio.browser.evaluate("(document.querySelector('.compare svg.chart').scrollIntoView({ block: 'center' }), true)")
    box = studio.browser.evaluate("""(() => { const box = document.querySelector('.compare svg.chart').getBoundingClientRect();
        return [box.x + box.width / 2, box.y + box.height / 2]; })()""")
    studio.browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=box[0], y=box[1])
    studio.wait("document.querySelector('.compare svg.chart line.cursor')")
    first = studio.browser.evaluate(reading)
    assert re.fullmatch(r"At \d+°: A from .+\smm to .+\smm, B from .+\smm to .+\smm\.", first), first
    studio.browser.evaluate("(document.querySelector('.compare .ground').focus(), true)")
    for _ in range(3):
        studio.key("ArrowRight")
    studio.wait(f"{reading} !== {first!r}")
    assert studio.browser.diagnostics() == []

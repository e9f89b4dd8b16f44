"""What a page saves, and the rules that its scripts share with the library: the library's own texts are beside the pages."""

import csv
import io
import json
import pathlib
import re
import subprocess
import sys
import tarfile
from xml.etree import ElementTree

import pytest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from chromium import Chromium  # noqa: E402

TICKS = REPOSITORY / "crates/loosepin-report/scripts/ticks_cases.json"
SAVED = "[...savedFigures].map(([name, texts]) => [name, texts.svg, texts.csv])"
SVG = "{http://www.w3.org/2000/svg}"
# A chart with more rows than this draws the extremes of stretches only.
MOST_POINTS = 1600


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    folder = tmp_path_factory.mktemp("pages")
    subprocess.run([REPOSITORY / "target/debug/examples/report_pages", folder], check=True)
    return folder


@pytest.fixture(scope="module")
def browser():
    with Chromium() as browser:
        browser.view(1280, reduced_motion=True)
        yield browser


@pytest.mark.parametrize("name", ["study", "simulation", "motion", "four_bar", "coupler_path"])
def test_the_page_saves_what_the_library_writes(pages, browser, name):
    browser.open(str(pages / f"{name}.html"))
    saved = {figure: (svg, table) for figure, svg, table in browser.evaluate(SAVED)}
    written = pages / f"{name}.figures"
    svgs = {path.stem: path.read_bytes().decode() for path in written.glob("*.svg")}
    tables = {path.stem: path.read_bytes().decode() for path in written.glob("*.csv")}
    assert saved and sorted(saved) == sorted(svgs)
    for figure, (svg, table) in saved.items():
        assert svg == svgs[figure], figure
        assert table == tables.get(figure), figure
        root = ElementTree.fromstring(svg)
        assert root.tag == f"{SVG}svg" and root.find(f"{SVG}title").text, figure
        assert "var(--" not in svg, figure
        # The table of an orbit has its poses, and no curve for each column.
        if root.get("class") == "figure chart":
            columns_are_drawn(root, table, figure)


# Clicks every button below the input files, and gives the name and the bytes of what is saved.
SAVED_FILES = """(async () => {
  const saved = [], blobs = new Map(), made = URL.createObjectURL, clicked = HTMLAnchorElement.prototype.click;
  URL.createObjectURL = (blob) => { const url = made.call(URL, blob); blobs.set(url, blob); return url; };
  HTMLAnchorElement.prototype.click = function () { saved.push([this.download, blobs.get(this.href)]); };
  document.querySelectorAll('.save.plain button').forEach((button) => button.click());
  URL.createObjectURL = made;
  HTMLAnchorElement.prototype.click = clicked;
  return Promise.all(saved.map(async ([name, blob]) => [name, [...new Uint8Array(await blob.arrayBuffer())]]));
})()"""


def test_the_page_saves_its_input_files_byte_for_byte_and_in_their_folders(pages, browser):
    browser.open(str(pages / "study.html"))
    saved = {name: bytes(content) for name, content in browser.evaluate(SAVED_FILES)}
    archive = saved.pop("inputs.tar")
    with tarfile.open(fileobj=io.BytesIO(archive)) as opened:
        members = {member.name: opened.extractfile(member).read() for member in opened.getmembers()}
    assert members == {
        "study.toml": b'name = "worn pin"\n',
        "model.toml": b'name = "slider-crank"\r\n# mm\r\n',
        "parts/rod.csv": b"\nrod [mm]\n119.98\n<120.01>",
    }
    assert saved == {name.rpartition("/")[2]: content for name, content in members.items()}


def columns_are_drawn(root, table, figure):
    """Every column of the table is a curve with a point for each row, but for points within level stretches."""
    assert table.startswith(f"# figure {figure} of "), figure
    head, *rows = csv.reader(io.StringIO(table.split("\n", 1)[1]))
    assert len(rows) > 1 and all(len(row) == len(head) for row in rows), figure
    # The key below the picture has lines of its own.
    drawn = [group for group in root.iter(f"{SVG}g") if group.get("class") == "curves"]
    curves = [path for group in drawn for path in group.iter(f"{SVG}path") if path.get("class", "").startswith("line ")]
    assert len(curves) == len(head) - 1, figure
    for column, curve in enumerate(curves, 1):
        points = len(re.findall("[ML]", curve.get("d")))
        wanted = drawn_rows([row[0] for row in rows], [row[column] for row in rows])
        assert points == wanted or (len(rows) > MOST_POINTS and 1 < points < wanted), f"{figure}, {head[column]}"


def drawn_rows(xs, cells):
    """How many of the rows have a point: those with a value that differs from one of its neighbours."""
    count, is_down = 0, False
    for row, cell in enumerate(cells):
        if cell == "" or xs[row] == "":
            is_down = False
            continue
        is_level = is_down and cells[row - 1] == cell and row + 1 < len(cells) and cells[row + 1] == cell
        count += not is_level
        is_down = True
    return count


def test_ticks_are_those_of_the_library(pages, browser):
    browser.open(str(pages / "motion.html"))
    for case in json.loads(TICKS.read_text(encoding="utf-8")):
        arguments = json.dumps([case["from"], case["to"], case["least"], case["are_angles"]])
        texts = f"(({{ values, step }}) => values.map((value) => tickText(value, step)))(ticks(...{arguments}))"
        assert browser.evaluate(texts) == case["texts"], case


def test_ticks_drawn_by_the_library_are_drawn_again_by_the_page(pages, browser):
    """At the width of the library's own picture both make the same axis."""
    browser.open(str(pages / "motion.html"))
    browser.evaluate("document.querySelector('.fold-all button').click()")
    browser.evaluate("document.querySelectorAll('.plot').forEach((plot) => { plot.style.width = '760px'; })")
    browser.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))")
    shown = dict(browser.evaluate("""[...document.querySelectorAll('[data-chart]')].map((holder) =>
        [holder.dataset.chart, [...holder.querySelectorAll('g.across text, g.up text')].map((text) => text.textContent).sort()])"""))
    assert shown
    for figure, texts in shown.items():
        root = ElementTree.parse(pages / "motion.figures" / f"{figure}.svg").getroot()
        axes = [group for group in root.iter(f"{SVG}g") if group.get("class") in ("across", "up")]
        drawn = sorted(text.text for group in axes for text in group.iter(f"{SVG}text"))
        assert drawn == texts and len(drawn) > 4, figure

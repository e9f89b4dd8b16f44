"""The look at paper finds what it is to find: a page made for it tears a row of a table and leaves a head alone."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from chromium import Chromium  # noqa: E402
from paper import Paper  # noqa: E402

# The sheet is 1,040 px high between its margins, about.
PAGE = """<!doctype html><html lang="en"><head><title>torn</title><style>
@page { margin: 10mm } body { margin: 0 } p { margin: 0; line-height: 20px } h2 { margin: 0; break-after: auto } td { width: 60px }
</style></head><body>
<section><p style="height: 900px">a</p><table><thead><tr><th scope="col">head</th></tr></thead>
<tbody><tr><td>WORDS</td></tr><tr><td>whole</td></tr></tbody></table></section>
<section style="break-before: page"><p style="height: 1000px">b</p><h2>A head</h2><p style="break-inside: avoid">WORDS</p></section>
</body></html>"""


def printed(folder, page):
    path = folder / "page.html"
    path.write_text(page.replace("WORDS", "word " * 40), encoding="utf-8")
    with Chromium() as browser:
        browser.view(1280)
        browser.open(str(path))
        browser.pdf(str(folder / "page.pdf"))
    return Paper((folder / "page.pdf").read_bytes())


def test_a_torn_row_and_a_lonely_head_are_found(tmp_path):
    paper = printed(tmp_path, PAGE)
    assert paper.torn_rows() == [[1, 2]]
    assert paper.lonely_heads() == [3]


def test_rows_and_heads_that_are_kept_together_are_not(tmp_path):
    kept = "tr { break-inside: avoid } h2 { break-after: avoid !important }</style>"
    paper = printed(tmp_path, PAGE.replace("</style>", kept))
    assert len(paper.sheets) >= 4
    assert paper.torn_rows() == [] and paper.lonely_heads() == []

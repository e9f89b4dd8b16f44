"""docs/research.md and docs/research.ipynb are one text: the notebook is made from the page, runs, and prints what the page quotes.

`LOOSEPIN_REWRITE_PAGES=1` writes the notebook, and what it prints into the page.
"""

import json
import os
import re

import nbclient
import nbformat
import pytest
from conftest import REPOSITORY, program

PAGE = REPOSITORY / "docs/research.md"
NOTEBOOK = REPOSITORY / "docs/research.ipynb"
# A block of Python, and what it prints.
BLOCK = re.compile(r"^```python\n(.*?)^```\n(?:\n```text\n(.*?)^```\n)?", re.DOTALL | re.MULTILINE)
IS_WRITING = bool(os.environ.get("LOOSEPIN_REWRITE_PAGES"))
LIMIT_S = 300
# The two lines of the page that speak of its notebook.
OF_THE_PAGE = re.compile(r"^The same steps are \[a notebook\].*?\n\n", re.DOTALL | re.MULTILINE)


def notebook_of(page: str) -> str:
    """The cells of the page; what its blocks print is left for the reader to make."""
    page, cells, begin = OF_THE_PAGE.sub("", page), [], 0
    for block in BLOCK.finditer(page):
        cells += [("markdown", page[begin : block.start()]), ("code", block[1])]
        begin = block.end()
    cells.append(("markdown", page[begin:]))
    found = []
    for number, (kind, text) in enumerate((kind, text.strip("\n")) for kind, text in cells if text.strip()):
        cell = {"cell_type": kind, "id": f"cell-{number}", "metadata": {}, "source": text.splitlines(keepends=True)}
        found.append(cell | ({"execution_count": None, "outputs": []} if kind == "code" else {}))
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    return json.dumps({"cells": found, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}, indent=1, ensure_ascii=False) + "\n"


@pytest.fixture(scope="module")
def page():
    return PAGE.read_text(encoding="utf-8")


def test_the_notebook_is_made_from_the_page(page):
    if IS_WRITING:
        NOTEBOOK.write_text(notebook_of(page), encoding="utf-8")
    assert NOTEBOOK.read_text(encoding="utf-8") == notebook_of(page)
    nbformat.validate(nbformat.read(NOTEBOOK, as_version=4))


def test_the_notebook_prints_what_the_page_quotes(page, tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", f"{program().parent}{os.pathsep}{os.environ['PATH']}")
    notebook = nbformat.reads(notebook_of(page), as_version=4)
    nbclient.NotebookClient(notebook, timeout=LIMIT_S, resources={"metadata": {"path": str(tmp_path)}}).execute()
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    printed = ["".join(output.text for output in cell.outputs if output.get("name") == "stdout") for cell in code]
    if IS_WRITING:
        ready = iter(printed)

        def with_output(block):
            text = next(ready)
            return f"```python\n{block[1]}```\n" + (f"\n```text\n{text}```\n" if text else "")

        PAGE.write_text(BLOCK.sub(with_output, page), encoding="utf-8")
    else:
        assert printed == [block[2] or "" for block in BLOCK.finditer(page)]
    pictures = [output for cell in code for output in cell.outputs if "image/png" in output.get("data", {})]
    assert len(pictures) == 6

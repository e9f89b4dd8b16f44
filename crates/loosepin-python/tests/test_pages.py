"""The Python of the documentation runs: the blocks of every page in their order. docs/research.md runs as a notebook (test_research.py).

A block whose first line begins with `# not run by the tests:` is not run; NOT_RUN lists these.
"""

import re

import loosepin as lp
import matplotlib
import numpy as np
import pytest

from conftest import MODEL, REPOSITORY, STUDY

NOT_RUN: set[tuple[str, str]] = {
    (
        "docs/files/study-results.md",
        "it reads the folder of a finished study; test_study.py reads units in the same way",
    ),
    ("docs/python.md", "a minute of runs; test_identification.py does the same with a small study"),
}
MARK = "# not run by the tests: "
BLOCK = re.compile(r"^```python\n(.*?)^```", re.DOTALL | re.MULTILINE)
PAGES = sorted(path.relative_to(REPOSITORY).as_posix() for path in (REPOSITORY / "docs").rglob("*.md"))
ELSEWHERE = {"docs/research.md"}
WITH_PYTHON = [page for page in PAGES if page not in ELSEWHERE and BLOCK.search((REPOSITORY / page).read_text(encoding="utf-8"))]
# Surrogates beside the bounds, so that the page finds some to load, over the inputs that it names.
CRANK = '"parameter.crank_length" = { normal = { mean = "50 mm", standard_deviation = "0.02 mm" } }\n'
WITH_SURROGATES = 'surrogate = { kind = "chaos", training_runs = 24, confirming_runs = 8 }\n' + STUDY.replace(CRANK, "")


def test_pages_with_python_are_known():
    assert "docs/python.md" in WITH_PYTHON


@pytest.mark.parametrize("page", WITH_PYTHON)
def test_blocks_of_a_page(page, tmp_path, monkeypatch):
    matplotlib.use("Agg")
    (tmp_path / "model.toml").write_text(MODEL.read_text(encoding="utf-8"), encoding="utf-8")
    (tmp_path / "study.toml").write_text(WITH_SURROGATES, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    names = {"np": np, "lp": lp}
    for block in BLOCK.findall((REPOSITORY / page).read_text(encoding="utf-8")):
        if block.startswith(MARK):
            assert (page, block.splitlines()[0].removeprefix(MARK)) in NOT_RUN
            continue
        exec(compile(block, page, "exec"), names)

"""The lines of Python in the README run as they stand."""

import re

from conftest import REPOSITORY, RANDOM_STUDY, write_study


def test_lines_of_the_readme(tmp_path, monkeypatch, capsys):
    [lines] = re.findall(r"```python\n(.*?)```", (REPOSITORY / "README.md").read_text(encoding="utf-8"), re.DOTALL)
    assert len(lines.splitlines()) == 4
    path = re.search(r'"(cases/.*?)"', lines).group(1)
    assert (REPOSITORY / path).is_file()
    # The same lines over a study that takes seconds also in an unoptimised build.
    (tmp_path / path).parent.mkdir(parents=True)
    write_study((tmp_path / path).parent, RANDOM_STUDY)
    monkeypatch.chdir(tmp_path)
    exec(compile(lines, "README.md", "exec"), {})
    assert "a tenth of a turn" in capsys.readouterr().out
    assert (tmp_path / "report.html").stat().st_size > 10_000

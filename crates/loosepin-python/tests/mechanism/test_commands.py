"""The table of docs/python.md names every command and option of the program, and only Python that there is."""

import inspect
import re

import loosepin as lp
import pytest
from conftest import REPOSITORY, command

PAGE = (REPOSITORY / "docs/python.md").read_text(encoding="utf-8")
# `Model.simulate(turns=, set=)` or `Simulation.summary`.
PYTHON = re.compile(r"`([A-Z]\w+)\.(\w+)(?:\(([^`]*)\))?`")
NOT_IN_PYTHON = "not in Python: "


def table() -> list[tuple[str, str, str]]:
    """Command, options and Python of each row."""
    section = PAGE.split("## Commands and their Python", 1)[1]
    rows = [line.strip("|").split("|") for line in section.splitlines() if line.startswith("| `")]
    return [(cells[0].strip(" `"), cells[1], cells[2].strip()) for cells in rows if len(cells) == 3]


def help_of(*words: str, folder) -> str:
    ended = command(*words, "--help", cwd=folder)
    assert ended.returncode == 0, ended.stderr
    return ended.stdout


def part(text: str, head: str) -> list[str]:
    """The lines of a part of a help, up to the next empty line at the end of it."""
    found = re.search(rf"^{head}:\n(.*?)(?=^\S|\Z)", text, re.DOTALL | re.MULTILINE)
    return found[1].splitlines() if found else []


def subcommands(text: str) -> list[str]:
    return [line.split()[0] for line in part(text, "Commands") if line.startswith("  ") and line[2] != " "]


def in_help(text: str) -> set[str]:
    """The arguments and options of a command."""
    arguments = {match[1] for line in part(text, "Arguments") if (match := re.match(r"  [<\[]([A-Z]+)[>\]]", line))}
    options = {match[1] for line in part(text, "Options") if (match := re.match(r"(?: {6}|  -\w, )(--[a-z-]+)", line))}
    return arguments | options - {"--help", "--version"}


@pytest.fixture(scope="module")
def commands(tmp_path_factory: pytest.TempPathFactory) -> dict[str, set[str]]:
    """Arguments and options of each command, by its name."""
    folder = tmp_path_factory.mktemp("help")
    found = {}
    for name in subcommands(help_of(folder=folder)):
        text = help_of(name, folder=folder)
        found[name] = in_help(text)
        found |= {f"{name} {inner}": in_help(help_of(name, inner, folder=folder)) for inner in subcommands(text)}
    return found


def test_the_help_is_understood(commands):
    assert {"new", "simulate", "study", "cases run", "manual"} <= commands.keys()
    assert commands["motion"] == {"FILE", "--all", "--set", "--path", "--out", "--force"}
    assert {"MODEL", "--no-second-run"} <= commands["simulate"] and commands["completions"] == {"SHELL"}


def test_identity_every_command_and_option_has_a_row(commands):
    rows: dict[str, set[str]] = {}
    for name, options, _ in table():
        rows.setdefault(name, set()).update(re.findall(r"`([^`]+)`", options))
    assert rows == commands


def test_every_row_names_python_that_there_is_or_says_why_not():
    for name, options, python in table():
        named = PYTHON.findall(python)
        assert named or python.startswith(NOT_IN_PYTHON), (name, options)
        assert not python.startswith(NOT_IN_PYTHON) or len(python) > len(NOT_IN_PYTHON) + 10, (name, options)
        for owner, member, arguments in named:
            found = inspect.getattr_static(getattr(lp, owner), member, None)
            assert found is not None, f"{owner}.{member}"
            taken = re.findall(r"(\w+)=", arguments)
            if taken:
                assert set(taken) <= inspect.signature(getattr(getattr(lp, owner), member)).parameters.keys(), (owner, member)

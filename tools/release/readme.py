"""What the README says that users type, and what it says that they see."""

import re

from errors import ReleaseError
from paths import REPOSITORY

COMMAND = "    cargo run --release -- "
INDENT = "    "


def text() -> str:
    return (REPOSITORY / "README.md").read_text(encoding="utf-8")


def commands() -> list[str]:
    """The arguments of each command that stands on a line of its own, the first example first."""
    lines = (line.removeprefix(COMMAND) for line in text().splitlines() if line.startswith(COMMAND))
    return [line.split(" #")[0].strip() for line in lines]


def printed() -> list[str]:
    """The lines that the first command prints."""
    [_, behind] = text().split("The command prints:\n")
    lines = []
    for line in behind.splitlines():
        if line and not line.startswith(INDENT):
            break
        lines.append(line.strip())
    return [line for line in lines if line]


def python_lines() -> str:
    [lines] = re.findall(r"```python\n(.*?)```", text(), re.DOTALL)
    return str(lines)


def compare(found: str, where: str) -> int:
    """The number of lines that the README prints, all of them found in this order."""
    rest, wanted = [line.strip() for line in found.splitlines()], printed()
    for line in wanted:
        if line not in rest:
            raise ReleaseError(f"{where}: the README prints a line that is not printed here: {line}", "is the README of this commit?")
        rest = rest[rest.index(line) + 1 :]
    return len(wanted)

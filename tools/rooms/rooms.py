"""Counts the lines of each crate, production and tests apart: `python3 tools/rooms/rooms.py [CHECKOUT]`.

A line is counted if it is not blank. Tests are: files below `tests`, modules declared behind `#[cfg(test)]` in files of their
own, and what stands behind `#[cfg(test)]` at the end of a file. Where a checkout has one crate for the library, its top
folders are counted in place of crates.
"""

import re
import sys
from pathlib import Path

TEST_MODULE = re.compile(r"#\[cfg\(test\)\]\s*(?:#\[[^\]]*\]\s*)*(?:pub(?:\([a-z]+\))? )?mod (\w+);")
TEST_BLOCK = re.compile(r"^#\[cfg\(test\)\]\n(?:#\[[^\]]*\]\n)*mod \w+ \{", re.MULTILINE)


def test_files(sources: list[Path]) -> set[Path]:
    """Files, and all below their folders, that are declared behind `#[cfg(test)]`."""
    found: set[Path] = set()
    for source in sources:
        folder = source.parent if source.name in ("mod.rs", "lib.rs", "main.rs") else source.with_suffix("")
        for name in TEST_MODULE.findall(source.read_text()):
            found.add(folder / f"{name}.rs")
            found.update(other for other in sources if folder / name in other.parents)
    return found


def lines(text: str) -> int:
    return sum(1 for line in text.splitlines() if line.strip())


def room(source: Path, crates: Path) -> str:
    """The crate of a file; for the library of one crate its top folder."""
    parts = source.relative_to(crates).parts
    is_one_crate = (crates / "loosepin/src/contact").exists()
    if parts[0] == "loosepin" and is_one_crate and parts[1] == "src" and len(parts) > 2:
        return f"loosepin: {parts[2].removesuffix('.rs')}"
    return parts[0]


def main(checkout: Path) -> None:
    crates = checkout / "crates"
    sources = sorted(path for path in crates.rglob("*.rs") if "target" not in path.parts)
    tests = test_files(sources)
    rooms: dict[str, list[int]] = {}
    for source in sources:
        text = source.read_text()
        counts = rooms.setdefault(room(source, crates), [0, 0, 0])
        counts[2] += 1
        if source in tests or "tests" in source.relative_to(crates).parts[1:-1]:
            counts[1] += lines(text)
            continue
        block = TEST_BLOCK.search(text)
        end = block.start() if block else len(text)
        counts[0] += lines(text[:end])
        counts[1] += lines(text[end:])
    print("| Room | Production lines | Test lines | Files |\n|---|--:|--:|--:|")
    for name, (production, test, files) in sorted(rooms.items()):
        print(f"| `{name}` | {production} | {test} | {files} |")
    totals = [sum(counts[k] for counts in rooms.values()) for k in range(3)]
    print(f"| all | {totals[0]} | {totals[1]} | {totals[2]} |")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[2])

"""Adds one more of a kind to a copy of the tree, builds the program, runs it, and counts the source files that it took.

Each file NAME.toml beside this one is an addition:

    [[file]]                       a file that is new, with its text
    path = "crates/..."
    text = '''...'''
    [[line]]                       lines that go in front of the first line of a file that is there and begins so
    path = "crates/..."
    before = "..."
    text = "..."
    [run]                          what is run then, with files of its own, and what it must print
    files = { "model.toml" = '''...''' }
    arguments = ["check", "model.toml"]
    prints = ["..."]
    most = 3                       source files that it may take
"""

import pathlib
import subprocess
import sys
import tempfile
import tomllib

HERE = pathlib.Path(__file__).parent
TREE = HERE.parent.parent


def added(name: str) -> str | None:
    """Nothing if the addition works and costs no more than it may; else what is wrong."""
    addition = tomllib.loads((HERE / f"{name}.toml").read_text())
    # Always at the same place, so that what one addition has compiled serves the next.
    copy = TREE / "target" / "additions" / "tree"
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["git", "worktree", "add", "--quiet", "--force", "--detach", copy, "HEAD"], cwd=TREE, check=True)
        try:
            return added_to(copy, addition, pathlib.Path(folder), name)
        finally:
            subprocess.run(["git", "worktree", "remove", "--force", copy], cwd=TREE, check=True)


def added_to(copy: pathlib.Path, addition: dict, folder: pathlib.Path, name: str) -> str | None:
    for new in addition.get("file", []):
        path = copy / new["path"]
        if path.exists():
            return f"{new['path']} is there"
        path.write_text(new["text"])
    for line in addition.get("line", []):
        path = copy / line["path"]
        lines = path.read_text().split("\n")
        place = next((index for index, own in enumerate(lines) if own.startswith(line["before"])), None)
        if place is None:
            return f"{line['path']} has no line that begins '{line['before']}'"
        lines.insert(place, line["text"])
        path.write_text("\n".join(lines))
    touched = sorted({entry["path"] for key in ("file", "line") for entry in addition.get(key, [])})
    sources = [path for path in touched if path.endswith(".rs")]
    target = TREE / "target" / "additions" / "target"
    build = ["cargo", "build", "--quiet", "--locked", "--bin", "loosepin", "--target-dir", target]
    if subprocess.run(build, cwd=copy).returncode != 0:
        return "it does not build"
    run = addition["run"]
    for path, text in run["files"].items():
        (folder / path).write_text(text)
    command = [target / "debug" / "loosepin", *run["arguments"]]
    answer = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    printed = " ".join((answer.stdout + answer.stderr).split())
    missing = [words for words in run["prints"] if words not in printed]
    if missing:
        return f"it does not print {missing}: {printed}"
    print(f"{name}: {len(sources)} source files, at most {run['most']}: {', '.join(sources)}")
    return None if len(sources) <= run["most"] else "it takes too many files"


def main() -> int:
    names = sys.argv[1:] or sorted(path.stem for path in HERE.glob("*.toml"))
    failures = {name: wrong for name in names if (wrong := added(name)) is not None}
    for name, wrong in failures.items():
        print(f"error: {name}: {wrong}", file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())

"""Adds one more of each kind to a copy of the tree, builds the program, runs each, and counts the source files that each took.

Each file NAME.toml beside this one is an addition:

    [[file]]                       a file that is new, with its text
    path = "crates/..."
    text = '''...'''
    [[line]]                       lines that go in front of the first line of a file that is there and begins so
    path = "crates/..."
    before = "..."
    text = "..."
    [test]                         tests of the copy that must pass, if there is something false to put in
    arguments = ["--package", "..."]
    [[false]]                      lines that are false of the addition, put in as above: then one of these tests must fail
    path = "crates/..."
    before = "..."
    text = "..."
    fails = "its name"
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


def add_all(names: list[str]) -> dict[str, str]:
    """What is wrong, by addition. All stand in one copy of the tree: one build serves them, and none may hinder another."""
    additions = {name: tomllib.loads((HERE / f"{name}.toml").read_text()) for name in names}
    # Always at the same place, so that what one call has compiled serves the next.
    copy = TREE / "target" / "additions" / "tree"
    subprocess.run(["git", "worktree", "add", "--quiet", "--force", "--detach", copy, "HEAD"], cwd=TREE, check=True)
    try:
        failures = {name: wrong for name in names if (wrong := write(copy, additions[name])) is not None}
        target = TREE / "target" / "additions" / "target"
        build = ["cargo", "build", "--quiet", "--locked", "--bin", "loosepin", "--target-dir", target]
        if subprocess.run(build, cwd=copy).returncode != 0:
            return {name: "the tree with the additions does not build" for name in names}
        for name in names:
            if name not in failures and (wrong := test(copy, target, additions[name])) is not None:
                failures[name] = wrong
    finally:
        subprocess.run(["git", "worktree", "remove", "--force", copy], cwd=TREE, check=True)
    for name in names:
        wrong = failures.get(name) or run(target / "debug" / "loosepin", additions[name]["run"]) or count(name, additions[name])
        if wrong is not None:
            failures[name] = wrong
    return failures


def write(copy: pathlib.Path, addition: dict) -> str | None:
    for new in addition.get("file", []):
        path = copy / new["path"]
        if path.exists():
            return f"{new['path']} is there"
        path.write_text(new["text"])
    for line in addition.get("line", []):
        if (wrong := insert(copy, line)) is not None:
            return wrong
    return None


def insert(copy: pathlib.Path, line: dict) -> str | None:
    path = copy / line["path"]
    lines = path.read_text().split("\n")
    place = next((index for index, own in enumerate(lines) if own.startswith(line["before"])), None)
    if place is None:
        return f"{line['path']} has no line that begins '{line['before']}'"
    lines.insert(place, line["text"])
    path.write_text("\n".join(lines))
    return None


def test(copy: pathlib.Path, target: pathlib.Path, addition: dict) -> str | None:
    """What is wrong with the tests of an addition: they must pass, and each falsehood by itself must fail one."""
    if "test" not in addition:
        return None

    def tested() -> subprocess.CompletedProcess:
        command = ["cargo", "test", "--quiet", "--locked", "--target-dir", target, *addition["test"]["arguments"]]
        return subprocess.run(command, cwd=copy, capture_output=True, text=True)

    if (answer := tested()).returncode != 0:
        return f"its tests fail: {answer.stdout}{answer.stderr}"
    for false in addition.get("false", []):
        path = copy / false["path"]
        text = path.read_text()
        if (wrong := insert(copy, false)) is not None:
            return wrong
        answer = tested()
        path.write_text(text)
        if not any(line.endswith(false["fails"]) for line in answer.stdout.split("failures:")[-1].splitlines()):
            return f"'{false['fails']}' does not fail with what is false: {answer.stdout}{answer.stderr}"
    return None


def run(program: pathlib.Path, what: dict) -> str | None:
    with tempfile.TemporaryDirectory() as folder:
        for path, text in what["files"].items():
            (pathlib.Path(folder) / path).write_text(text)
        answer = subprocess.run([program, *what["arguments"]], cwd=folder, capture_output=True, text=True)
    printed = " ".join((answer.stdout + answer.stderr).split())
    missing = [words for words in what["prints"] if words not in printed]
    return f"it does not print {missing}: {printed}" if missing else None


def count(name: str, addition: dict) -> str | None:
    touched = sorted({entry["path"] for key in ("file", "line") for entry in addition.get(key, [])})
    sources = [path for path in touched if path.endswith(".rs")]
    print(f"{name}: {len(sources)} source files, at most {addition['run']['most']}: {', '.join(sources)}")
    return None if len(sources) <= addition["run"]["most"] else "it takes too many files"


def main() -> int:
    names = sys.argv[1:] or sorted(path.stem for path in HERE.glob("*.toml"))
    failures = add_all(names)
    for name, wrong in failures.items():
        print(f"error: {name}: {wrong}", file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())

"""Counts what plane and space have twice, and where variants of enums are named: structure.py [REVISION] (default HEAD).

Counted is the Rust code below `crates/*/src` of a commit, without modules of tests, comments and empty lines.
"""

import re
import subprocess
import sys
from pathlib import PurePosixPath

SPACE = "loosepin-space"
# A file that asks whether a model is of the plane or of space.
ASKS = re.compile(r"\.(?:spatial|planar)\(\)|StudyModel::(?:Spatial|Planar)")
# A type of space that has its own name for what the plane has too.
TWIN = re.compile(r"\b(?:struct|enum|trait) Spatial\w+")
ENUMS = [
    "Deviation",
    "Reduction",
    "Attachment",
    "PlaneAttachment",
    "SpaceAttachment",
    "Where",
    "Location",
    "Guarantee",
    "Recorded",
    "Treatment",
    "PlayPart",
    "ModelOutputKind",
    "JointSign",
]
TEST_MODULE = re.compile(r"(\s*)#\[cfg\(test\)\]$")
MODULE = re.compile(r"\s*(?:pub(?:\(.*\))? )?mod (\w+)( \{|;)$")


def git(*arguments: str, sent: bytes = b"") -> bytes:
    return subprocess.run(["git", *arguments], input=sent, stdout=subprocess.PIPE, check=True).stdout


def texts(revision: str) -> dict[str, str]:
    """The sources of a commit by their paths."""
    names = git("ls-tree", "-r", "--name-only", revision).decode().splitlines()
    paths = [name for name in names if re.match(r"crates/[^/]+/src/.*\.rs$", name)]
    stored = git("cat-file", "--batch", sent="".join(f"{revision}:{path}\n" for path in paths).encode())
    found, at = {}, 0
    for path in paths:
        end = stored.index(b"\n", at)
        size = int(stored[at:end].split()[-1])
        found[path] = stored[end + 1 : end + 1 + size].decode()
        at = end + 1 + size + 1
    return found


def without_tests(text: str) -> tuple[list[str], list[str]]:
    """The lines that are compiled for use, and the names of modules of tests in files of their own."""
    lines, kept, modules, at = text.splitlines(), [], [], 0
    while at < len(lines):
        test = TEST_MODULE.match(lines[at])
        following = MODULE.match(lines[at + 1]) if test and at + 1 < len(lines) else None
        if test and following:
            at += 1
            if following[2] == ";":
                modules.append(following[1])
            else:
                while at < len(lines) and lines[at].rstrip() != f"{test[1]}}}":
                    at += 1
        else:
            kept.append(lines[at])
        at += 1
    return kept, modules


def production(revision: str) -> dict[str, list[str]]:
    """The lines of code of each file, without tests, comments and empty ones."""
    kept, tests = {}, set()
    for path, text in texts(revision).items():
        kept[path], modules = without_tests(text)
        file = PurePosixPath(path)
        folder = file.parent if file.name in ("lib.rs", "main.rs", "mod.rs") else file.with_suffix("")
        tests |= {str(folder / module) for module in modules}
    used = {path: lines for path, lines in kept.items() if not any(path == f"{test}.rs" or path.startswith(f"{test}/") for test in tests)}
    return {path: [line for line in lines if line.strip() and not line.lstrip().startswith("//")] for path, lines in used.items()}


def is_of_space(path: str) -> bool:
    """Whether a file is of space alone, by its name."""
    parts = PurePosixPath(path).with_suffix("").parts[3:]
    return any(part == "space" or part.startswith(("spatial", "space_")) or "_spatial" in part for part in parts)


def main(revision: str) -> None:
    files = production(revision)

    def lines(paths):
        return sum(len(files[path]) for path in paths)

    def naming(pattern):
        return [path for path, code in files.items() if any(pattern.search(line) for line in code)]

    crate = [path for path in files if path.startswith(f"crates/{SPACE}/")]
    elsewhere = [path for path in files if path not in crate and is_of_space(path)]
    twins = {name for code in files.values() for line in code for name in TWIN.findall(line)}
    print(f"{git('rev-parse', '--short=8', revision).decode().strip()}")
    print(f"{lines(files):7} lines of code in {len(files)} files")
    print(f"{lines(crate):7} of them in {SPACE}")
    print(f"{lines(elsewhere):7} in {len(elsewhere)} files of space in other crates")
    print(f"{len(naming(ASKS)):7} files that ask whether a model is of the plane or of space")
    print(f"{len(twins):7} types called Spatial...")
    for enum in ENUMS:
        variant = re.compile(rf"\b{enum}::[A-Z]")
        count = sum(len(variant.findall(line)) for code in files.values() for line in code)
        print(f"{count:7} mentions of variants of {enum} in {len(naming(variant))} files")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "HEAD")

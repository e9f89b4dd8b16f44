#!/usr/bin/env python3
"""Builds what a release consists of, from the present commit: `just release`; docs/release.md says what and how.

The sources are taken from git into a folder of their own, so that nothing else of the working tree enters. With --twice it builds in two folders
with names of different lengths and compares the bytes of every file. Exit status: 0 built (and equal), 1 different bytes, 2 not built.
"""

import argparse
import hashlib
import os
import shutil
import subprocess
import sys
import tarfile
from io import BytesIO
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
FILES = REPOSITORY / "target/release-files"
FOLDERS = (REPOSITORY / "target/release-build", REPOSITORY / "target/release-build-in-another-folder")
SHELLS = ("bash", "zsh", "fish", "powershell", "elvish")
COMMIT_DIGITS = 10


def output(*command: str | Path, **options: object) -> bytes:
    return subprocess.run([str(part) for part in command], check=True, stdout=subprocess.PIPE, **options).stdout  # type: ignore[call-overload,no-any-return]


def git(*arguments: str) -> str:
    return output("git", *arguments, cwd=REPOSITORY).decode().strip()


def environment(folder: Path, commit: str) -> dict[str, str]:
    """What makes the bytes depend on the commit and the tools alone."""
    sources, target = folder / "sources", folder / "target"
    cargo_home = Path(os.environ.get("CARGO_HOME", Path.home() / ".cargo"))
    places = ((sources, "/loosepin"), (target, "/target"), (cargo_home, "/cargo"))
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("CARGO_PROFILE", "RUSTFLAGS", "CARGO_BUILD_RUSTFLAGS"))}
    return kept | {
        "CARGO_TARGET_DIR": str(target),
        "CARGO_INCREMENTAL": "0",
        "CARGO_PROFILE_RELEASE_DEBUG": "false",
        "CARGO_PROFILE_RELEASE_STRIP": "symbols",
        "CARGO_ENCODED_RUSTFLAGS": "\x1f".join(f"--remap-path-prefix={place}={name}" for place, name in places),
        "CFLAGS": " ".join(f"-ffile-prefix-map={place}={name}" for place, name in places),
        "LOOSEPIN_COMMIT": commit[:COMMIT_DIGITS],
        "SOURCE_DATE_EPOCH": git("log", "-1", "--format=%ct", commit),
        "ZERO_AR_DATE": "1",
    }


def build(folder: Path, commit: str, quick: bool) -> dict[str, bytes]:
    """The files of a release by their names."""
    sources = folder / "sources"
    shutil.rmtree(sources, ignore_errors=True)
    sources.mkdir(parents=True)
    with tarfile.open(fileobj=BytesIO(output("git", "archive", commit, cwd=REPOSITORY))) as archive:
        archive.extractall(sources, filter="data")
    variables = environment(folder, commit)
    if quick:
        variables["CARGO_PROFILE_RELEASE_OPT_LEVEL"] = "0"
    subprocess.run(["cargo", "build", "--release", "--locked", "--package", "loosepin-cli"], cwd=sources, env=variables, check=True)
    wheels = folder / "wheels"
    shutil.rmtree(wheels, ignore_errors=True)
    maturin = (sys.executable, "-m", "maturin", "build", "--release", "--locked", "--interpreter", sys.executable, "--out", str(wheels))
    subprocess.run(maturin, cwd=sources / "crates/loosepin-python", env=variables, check=True)
    program = folder / "target/release/loosepin"
    files = {"loosepin": program.read_bytes()}
    files |= {wheel.name: wheel.read_bytes() for wheel in wheels.glob("*.whl")}
    files |= {f"completions/loosepin.{shell}": output(program, "completions", shell) for shell in SHELLS}
    files["man/loosepin.1"] = output(program, "manual")
    listed = output(program, "--help").decode().split("Commands:\n")[1].split("\n\n")[0]
    commands = [line.split()[0] for line in listed.splitlines() if line.startswith("  ") and not line.startswith("   ")]
    files |= {f"man/loosepin-{command}.1": output(program, "manual", command) for command in commands}
    files["RUSTC"] = output("rustc", "--version", "--verbose")
    return files


def sums(files: dict[str, bytes]) -> dict[str, str]:
    return {name: hashlib.sha256(files[name]).hexdigest() for name in sorted(files)}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--twice", action="store_true", help="build in two folders and compare the bytes")
    parser.add_argument("--quick", action="store_true", help="without optimisation: only to try --twice")
    options = parser.parse_args()
    if changes := git("status", "--porcelain"):
        print(f"error: the working tree has changes, and the version names the commit\n{changes}\nhint: commit or stash them", file=sys.stderr)
        return 2
    commit = git("rev-parse", "HEAD")
    try:
        files = build(FOLDERS[0], commit, options.quick)
        others = sums(build(FOLDERS[1], commit, options.quick)) if options.twice else None
    except subprocess.CalledProcessError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    own = sums(files)
    shutil.rmtree(FILES, ignore_errors=True)
    for name, content in files.items():
        (FILES / name).parent.mkdir(parents=True, exist_ok=True)
        (FILES / name).write_bytes(content)
    (FILES / "loosepin").chmod(0o755)
    (FILES / "SHA256SUMS").write_text("".join(f"{digest}  {name}\n" for name, digest in own.items()), encoding="utf-8")
    for name, digest in own.items():
        compared = "" if others is None else ("equal      " if others.get(name) == digest else "DIFFERENT  ")
        print(f"{compared}{digest}  {len(files[name]):>10}  {name}")
    if others is not None and others != own:
        print("error: two builds of one commit differ", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

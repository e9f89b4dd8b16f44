#!/usr/bin/env python3
"""Builds what a release consists of, from the present commit, and tries it in clean roots: `just release`; docs/release.md says what and how.

With --twice it builds in two folders with names of different lengths and compares the bytes of every file. Exit status: 0 built (and equal),
1 different bytes, 2 not built, or a check failed.
"""

import argparse
import hashlib
import shutil
import subprocess
import sys
import time
from pathlib import Path

import check
import installed
import roots
import toolchain
from build import build, git
from errors import ReleaseError
from paths import FILES, REPOSITORY

FOLDERS = (REPOSITORY / "target/release-build", REPOSITORY / "target/release-build-in-another-folder")


def sums(files: dict[str, bytes]) -> dict[str, str]:
    return {name: hashlib.sha256(files[name]).hexdigest() for name in sorted(files)}


def write(files: dict[str, bytes]) -> None:
    shutil.rmtree(FILES, ignore_errors=True)
    for name, content in files.items():
        (FILES / name).parent.mkdir(parents=True, exist_ok=True)
        (FILES / name).write_bytes(content)
    (FILES / "loosepin").chmod(0o755)
    listed = "".join(f"{digest}  {name}\n" for name, digest in sums(files).items())
    (FILES / "SHA256SUMS").write_text(listed, encoding="utf-8")


def build_all(twice: bool, quick: bool) -> bool:
    """Writes the files; whether two builds, where there are two, gave the same bytes."""
    if changes := git("status", "--porcelain"):
        raise ReleaseError(f"the working tree has changes, and the version names the commit\n{changes}", "commit or stash them")
    commit = git("rev-parse", "HEAD")
    tools = toolchain.prepare()
    started = time.monotonic()
    files = build(FOLDERS[0], commit, tools, quick)
    print(f"built in {time.monotonic() - started:.0f} s")
    others = sums(build(FOLDERS[1], commit, tools, quick)) if twice else None
    own = sums(files)
    write(files)
    for name, digest in own.items():
        compared = "" if others is None else ("equal      " if others.get(name) == digest else "DIFFERENT  ")
        print(f"{compared}{digest}  {len(files[name]):>10}  {name}")
    return others is None or others == own


def check_files() -> None:
    for name, needed in check.glibc().items():
        print(f"glibc {needed:<6} is what {name} needs at least")
    for name, size, limit in check.sizes():
        print(f"{size / 1e6:5.1f} MB of at most {limit / 1e6:4.1f} MB  {name}")


def check_roots() -> None:
    print(f"{'seconds':>8}  in a clean root")
    for suite, checks in installed.CHECKS:
        for one in checks:
            for step in one(suite):
                print(f"{step.seconds:8.1f}  {step.system}  {step.what}", flush=True)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--twice", action="store_true", help="build in two folders and compare the bytes")
    parser.add_argument("--quick", action="store_true", help="without optimisation: only to try --twice; sizes are not checked")
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--only-checks", action="store_true", help="check what an earlier call has built")
    which.add_argument("--without-roots", action="store_true", help="build, without trying the files in clean roots")
    options = parser.parse_args()
    try:
        # Before minutes of building.
        if not options.without_roots:
            roots.refuse_without_means()
        if not options.only_checks and not build_all(options.twice, options.quick):
            print("error: two builds of one commit differ", file=sys.stderr)
            return 1
        if not options.quick:
            check_files()
        if not options.without_roots:
            check_roots()
    except ReleaseError as error:
        print(error, file=sys.stderr)
        return 2
    except subprocess.CalledProcessError as error:
        print(f"error: {error}\nhint: its own message stands above", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())

"""Runs the unit and integration tests of all crates: rust_tests.py [ARGUMENT OF CARGO...]

As many programs of tests run at once as there are processors. `cargo test` runs one after another, and the last tests of each leave
processors idle: a tenth of the time on two of them.
"""

import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from threading import Lock
from typing import NamedTuple

# How cargo names the tests of a target, by its kind.
OPTIONS = {"lib": "--lib", "bin": "--bin", "test": "--test", "example": "--example"}
ONE_AT_A_TIME = Lock()


class Program(NamedTuple):
    """The tests of a target."""

    path: Path
    package: Path
    # What `cargo test` takes to run these alone.
    arguments: str


def programs(messages: list[str]) -> list[Program]:
    """The programs that cargo has built, by its messages."""
    found = []
    for line in messages:
        message = json.loads(line)
        if message.get("reason") != "compiler-artifact" or not message["profile"]["test"] or not message["executable"]:
            continue
        package, target = Path(message["manifest_path"]).parent, message["target"]
        option = next((OPTIONS[kind] for kind in target["kind"] if kind in OPTIONS), "--lib")
        named = option if option == "--lib" else f"{option} {target['name']}"
        found.append(Program(Path(message["executable"]), package, f"-p {package.name} {named}"))
    # The largest programs have the most tests, and what begins last should be short.
    return sorted(found, key=lambda program: program.path.stat().st_size, reverse=True)


def passes(program: Program) -> bool:
    """Runs the tests of a program in the folder of their package, as cargo does, and shows what they print."""
    environment = os.environ | {"CARGO_MANIFEST_DIR": str(program.package)}
    with ONE_AT_A_TIME:
        print(f"     Started {program.arguments}", flush=True)
    done = subprocess.run([program.path], cwd=program.package, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    with ONE_AT_A_TIME:
        print(f"     Running {program.arguments}\n{done.stdout}", end="", flush=True)
        if done.returncode not in (0, 101):
            print(f"error: {program.path.name} ended with {done.returncode}", flush=True)
    return done.returncode == 0


def main(arguments: list[str]) -> int:
    """0, or 101 as cargo has it where tests fail, or its status where they cannot be built."""
    command = ["cargo", "test", "--no-run", "--message-format=json-render-diagnostics", *arguments]
    built = subprocess.run(command, stdout=subprocess.PIPE, text=True)
    if built.returncode != 0:
        return built.returncode
    found = programs(built.stdout.splitlines())
    if not found:
        print("error: cargo has built no tests")
        return 1
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        failed = [program.arguments for program, is_passed in zip(found, pool.map(passes, found)) if not is_passed]
    if failed:
        print(f"error: {len(failed)} targets failed:", *(f"    `{name}`" for name in failed), sep="\n")
    return 101 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

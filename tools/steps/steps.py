"""Runs the steps of `./test`, each to its end whatever the others do, and says at the end which of them failed, by which tests.

`just everything` calls it: steps.py JUST STEP...
"""

import re
import subprocess
import sys
import time

# What a line says of a failure, by the programs that the steps call; the first group names it.
FAILURES = [
    # Tests of Rust, and examples of its documentation.
    re.compile(r"test (\S.*?)(?: - should panic| - compile(?: fail)?)? \.\.\. FAILED$"),
    # pytest.
    re.compile(r"(?:FAILED|ERROR) (\S+?\.py(?:::.*?)?)(?: - .*)?$"),
    # cargo: a crate that is not compiled, and at its end the targets of which a test failed or the process ended.
    re.compile(r"error: (could not compile `[^`]+`)"),
    re.compile(r" {4}`(-p .*)`$"),
]


def failure(line: str) -> str | None:
    """What has failed by this line of the output of a step; None where it tells of no failure."""
    found = (pattern.match(line) for pattern in FAILURES)
    return next((match[1] for match in found if match), None)


def run(just: str, step: str) -> tuple[int, list[str]]:
    """Runs a step with its output shown: its exit status, and what failed in it."""
    process = subprocess.Popen([just, step], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    failed: dict[str, None] = {}
    assert process.stdout is not None
    for line in process.stdout:
        print(line, end="", flush=True)
        if name := failure(line.rstrip()):
            failed[name] = None
    return process.wait(), list(failed)


def main(just: str, steps: list[str]) -> int:
    """Runs the steps in their order: 0, or the status of the first one that failed."""
    failed: list[tuple[str, int, list[str]]] = []
    for step in steps:
        started = time.monotonic()
        status, names = run(just, step)
        print(f"==> {step}: {time.monotonic() - started:.0f} s{', failed' if status else ''}", flush=True)
        if status:
            failed.append((step, status, names))
    for step, status, names in failed:
        print(f"error: {step} failed with status {status}{':' if names else ''}")
        for name in names:
            print(f"  {name}")
    return failed[0][1] if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))

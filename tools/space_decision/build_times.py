"""Build time of each crate alone, its dependencies warm, for the numbers that it compiles: `python3 build_times.py [rounds]`."""

import os
import subprocess
import sys
import time
from pathlib import Path
from statistics import median

FOLDER = Path(__file__).resolve().parent
# Crate, features, what it compiles.
BUILDS = [
    ("today", "", "today, nothing"),
    ("today", "compiled", "today, plain and traced"),
    ("spatial", "", "(a), nothing"),
    ("spatial", "compiled", "(a), plain and traced"),
    ("generic", "", "(b), nothing"),
    ("generic", "plane", "(b), plane, plain and traced"),
    ("generic", "space", "(b), space, plain and traced"),
    ("generic", "plane,space-plain", "(b), plane, plain and traced; space, plain"),
    ("generic", "plane-plain,space", "(b), plane, plain; space, plain and traced"),
    ("generic", "plane,space", "(b), both, plain and traced"),
]


def build(crate: str, features: str) -> float:
    """Seconds for one build after its sources were touched."""
    os.utime(FOLDER / crate / "src" / "lib.rs")
    command = ["cargo", "build", "--release", "--locked", "--package", crate, "--no-default-features", "--features", features]
    started = time.monotonic()
    subprocess.run(command, cwd=FOLDER, check=True, capture_output=True)
    return time.monotonic() - started


def main() -> None:
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 3
    times_s = {name: [] for _, _, name in BUILDS}
    for crate, features, _ in BUILDS:
        build(crate, features)
    for _ in range(rounds):
        for crate, features, name in BUILDS:
            times_s[name].append(build(crate, features))
    for name, seconds in times_s.items():
        listed = ", ".join(f"{value:.2f}" for value in sorted(seconds))
        print(f"{name}: {median(seconds):.2f} s ({listed})")


if __name__ == "__main__":
    main()

"""Build time of each crate alone, its dependencies warm, for the numbers that it compiles: `python3 build_times.py [rounds]`.

Seconds of the processor, then of the clock; the medians of the rounds, in which the builds take turns, and all rounds in brackets.
"""

import os
import resource
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


def processor_s() -> float:
    """Seconds that finished programs have used."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def build(crate: str, features: str) -> tuple[float, float]:
    """Seconds of the processor and of the clock for one build after its sources were touched."""
    os.utime(FOLDER / crate / "src" / "lib.rs")
    command = ["cargo", "build", "--release", "--locked", "--package", crate, "--no-default-features", "--features", features]
    started, used = time.monotonic(), processor_s()
    subprocess.run(command, cwd=FOLDER, check=True, capture_output=True)
    return processor_s() - used, time.monotonic() - started


def main() -> None:
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 3
    times_s = {name: [] for _, _, name in BUILDS}
    for crate, features, _ in BUILDS:
        build(crate, features)
    for _ in range(rounds):
        for crate, features, name in BUILDS:
            times_s[name].append(build(crate, features))
    for name, seconds in times_s.items():
        middle = [median(values) for values in zip(*seconds)]
        listed = ", ".join(f"{processor:.2f}" for processor, _ in sorted(seconds))
        print(f"{name}: {middle[0]:.2f} s ({listed}); {middle[1]:.2f} s by the clock")


if __name__ == "__main__":
    main()

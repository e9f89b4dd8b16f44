"""Holds `loosepin identify` against approximate Bayesian computation, by the same runs and readings; identify/README.md says what and how.

    python3 tools/compare/identify.py [--keep FOLDER] [--seeds N]

Makes `.venv` in the folder identify. Prints coverage, width and seconds of each method over the readings of the worn pin that
`cases/oracle` made, and what each says of mechanisms that the study does not allow.
"""

import argparse
import csv
import io
import json
import os
import statistics
import sys
import tempfile
from pathlib import Path

from compare import HERE, REPOSITORY, check_python, exit_status, prepare_venv, run, say

FOLDER = HERE / "identify"
VENV = FOLDER / ".venv"
READINGS = REPOSITORY / "cases/slider_crank_worn_pin/motion_repetitions.csv"
CONFIDENCE = 0.99
HEADINGS = ["method", "truths held", "median width", "no answer", "runs", "processor s of runs", "of the rest"]


def our_program() -> str:
    """The example of `loosepin-identify`, built for release; `WORN_PIN_READINGS` names one that is built already."""
    if given := os.environ.get("WORN_PIN_READINGS"):
        return given
    say("building worn_pin_readings")
    name = "worn_pin_readings"
    build = ["cargo", "build", "--release", "--locked", "--quiet", "--package", "loosepin-identify", "--example", name]
    run(build, "install Rust from https://rustup.rs")
    target = Path(os.environ.get("CARGO_TARGET_DIR", "target"))
    return str(REPOSITORY / target / "release" / "examples" / name)


def row(method: str, intervals: list[tuple[float, float, float]], asked: int, runs: float, seconds: tuple[float, float]) -> list[str]:
    """A line of the table: of each interval the truth and both ends, mm; seconds of runs and of the rest, a reading."""
    held = sum(low <= play <= high for play, low, high in intervals)
    width = statistics.median(high - low for _, low, high in intervals)
    return [
        method,
        f"{held} of {len(intervals)}",
        f"{width:.3f} mm",
        str(asked - len(intervals)),
        f"{runs:.0f}",
        f"{seconds[0]:.1f}",
        f"{seconds[1]:.3f}",
    ]


def compare_identify() -> None:
    """Runs ours, then the other methods on its runs; prints the table."""
    check_python()
    # Every program computes on one thread; `run` says so to the libraries of linear algebra.
    os.environ["RAYON_NUM_THREADS"] = "1"
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--keep", type=Path, metavar="FOLDER", help="where the tables of runs and answers are kept")
    parser.add_argument("--seeds", type=int, metavar="N", help="only the first N readings of each kind")
    asked = parser.parse_args()
    keep = asked.keep
    with tempfile.TemporaryDirectory() as temporary:
        folder = keep or Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        table = folder / "runs.csv"
        lines = READINGS.read_text(encoding="utf-8").splitlines(keepends=True)
        kept = [line for line in lines[1:] if asked.seeds is None or int(line.split(",")[1]) < asked.seeds]
        readings = folder / "readings.csv"
        readings.write_text("".join([lines[0], *kept]), encoding="utf-8")
        say("runs, and our answers")
        printed = run([our_program(), str(table), str(readings)], "call the example by hand to see more")
        (folder / "ours.csv").write_text(printed, encoding="utf-8")
        head, rest = printed.split("\n", 1)
        runs_s = float(head.rsplit(": ", 1)[1].split()[0])
        ours = list(csv.DictReader(io.StringIO(rest)))
        runs = len(table.read_text(encoding="utf-8").splitlines()) - 1
        prepare_venv(VENV, FOLDER / "requirements.txt")
        say("approximate Bayesian computation")
        program = [str(VENV / "bin/python"), str(FOLDER / "abc_program.py"), str(table), str(readings), str(CONFIDENCE)]
        peers = [json.loads(line) for line in run(program, "its last lines say why").splitlines()]
    own = [answer for answer in ours if answer["alternative"] == "none"]
    tested = statistics.median(int(answer["values"]) for answer in own)
    used = tested * runs / 128
    spent = (used * runs_s / runs, statistics.median(float(answer["seconds"]) for answer in own))
    numbers = lambda names, answers: [tuple(float(answer[name]) for name in names) for answer in answers]  # noqa: E731
    consistent = [answer for answer in own if answer["is_misfit"] == "false"]
    sets = numbers(["play_mm", "set_low_mm", "set_high_mm"], consistent)
    given = [answer for answer in own if answer["credible_low_mm"] != "NaN"]
    credible = numbers(["play_mm", "credible_low_mm", "credible_high_mm"], given)
    rows = [
        row("loosepin, set", sets, len(own), used, spent),
        row("loosepin, posterior", credible, len(own), used, spent),
    ]
    for method in ("rejection", "regression"):
        for share in sorted({peer["share"] for peer in peers}):
            found = [peer for peer in peers if (peer["method"], peer["share"], peer["alternative"]) == (method, share, "none")]
            intervals = numbers(["play_mm", "low_mm", "high_mm"], found)
            seconds = (runs_s, statistics.median(peer["seconds"] for peer in found))
            rows.append(row(f"ABC, {method}, {100 * share:g} %", intervals, len(found), runs, seconds))
    print("\n".join("| " + " | ".join(line) + " |" for line in [HEADINGS, ["---"] * len(HEADINGS), *rows]))
    for alternative in sorted({answer["alternative"] for answer in ours} - {"none", "friction_known_play"}):
        found = [answer for answer in ours if answer["alternative"] == alternative]
        told = sum(answer["is_misfit"] == "true" for answer in found)
        print(f"\n{alternative}: misfit told by ours in {told} of {len(found)}; ABC gives an interval in all {len(found)}")


if __name__ == "__main__":
    sys.exit(exit_status(compare_identify))

"""What the programs in Python share: the command line.

    PROGRAM --history      the nominal run as a table of `time_s,slider_x_m`
    PROGRAM --runs N       {"runs": N, "seconds": S, ...}: N runs, S the processor time of all of them
"""

import argparse
import json
import sys
import time
from collections.abc import Callable

import numpy as np

from model import Model

TURNS = 2
READINGS_PER_TURN = 1000
RUNS_AHEAD = 3  # before the clock starts: they compile and fill caches
VARIATION = 0.1  # clearances lie evenly within this share around the nominal one

Run = Callable[[float], np.ndarray]


def reading_times_s(turn_s: float) -> np.ndarray:
    """When the slider's position is read, s."""
    return turn_s / READINGS_PER_TURN * np.arange(TURNS * READINGS_PER_TURN + 1)


def clearances_m(nominal_m: float, runs: int) -> list[float]:
    """Clearances of a batch, m."""
    return [nominal_m * (1.0 + VARIATION * (2.0 * (index + 0.5) / runs - 1.0)) for index in range(runs)]


def print_history(run: Run, model: Model) -> None:
    """The nominal run."""
    print("time_s,slider_x_m")
    for time_s, slider_x_m in zip(reading_times_s(model.turn_s), run(model.clearance_m), strict=True):
        print(f"{time_s:.12e},{slider_x_m:.15e}")


def print_batch(run: Run, model: Model, runs: int) -> None:
    """The processor time of a batch."""
    for clearance_m in clearances_m(model.clearance_m, RUNS_AHEAD):
        run(clearance_m)
    sum_m = 0.0
    started_s = time.process_time()
    for clearance_m in clearances_m(model.clearance_m, runs):
        sum_m += run(clearance_m).sum()
    seconds = time.process_time() - started_s
    readings = runs * (TURNS * READINGS_PER_TURN + 1)
    print(json.dumps({"runs": runs, "seconds": round(seconds, 6), "mean_x_m": round(sum_m / readings, 6)}))


def main(run: Run) -> None:
    """Reads the command line and obeys."""
    parser = argparse.ArgumentParser()
    wish = parser.add_mutually_exclusive_group(required=True)
    wish.add_argument("--history", action="store_true")
    wish.add_argument("--runs", type=int)
    arguments = parser.parse_args()
    if arguments.history:
        print_history(run, Model.read())
    elif arguments.runs > 0:
        print_batch(run, Model.read(), arguments.runs)
    else:
        sys.exit(f"--runs {arguments.runs}; must be >= 1")

"""Random mechanisms against Newton and Euler, the balance of power, and themselves at a tenth of the tolerance.

Every mechanism is written as a model file and run by `loosepin simulate --states` over a quarter turn of its drive, once at 1e-9 m and
once at 1e-10 m. Forces, power and energy are computed anew in numpy from the positions and velocities of history.csv, with laws
written from the documentation; the library is not used. `tests/campaigns/mechanisms` says how it is called.
"""

import collections
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

import balance
import figures
import generate
import laws
import model_file

ROOT = Path(__file__).resolve().parents[2]
ROWS = 2000
MOST_S = 10
TOLERANCE_M = 1e-9
# What each figure may be at most, and what it is a share of.
LIMITS = {
    "newton-euler": (1e-6, "of the largest force of the row"),
    "newton-euler, mass at the onset": (1e-2, "the same where a law in a guide needs the mass at the onset, which lies between rows"),
    "power": (1e-6, "of the power of all forces of the row"),
    "power, mass at the onset": (1e-2, "the same where a law in a guide needs the mass at the onset"),
    "work": (1e-5, "of the largest energy: work of drives and loads against the power, where rows resolve it"),
    "kinetic": (1e-9, "of the largest energy"),
    "potential": (1e-9, "of the largest energy"),
    "stored": (1e-6, "of the largest energy"),
    "closure": (1e-11, "m: joints without play"),
    "closing rate": (1e-9, "m/s: joints without play, and drives"),
    "own account": (1e-6, "of the energy exchanged: what the run says of itself"),
    "bristles": (1e-2, "of the largest deflection, between two rows"),
    "film": (3e-2, "of the force: finite-length films against the Reynolds equation"),
    "damper": (1e-3, "of itself: dampers set by the mass at the onset, over one contact"),
    "itself, up to 8 contacts": (1e-8, "m: difference of positions to a run at a tenth of the tolerance; impacts amplify it"),
    "convergence": (np.inf, "difference at 1e-9 and 1e-10 m over that at 1e-8 and 1e-9 m, where the latter passes 1e-8 m"),
}


def program():
    if path := os.environ.get("LOOSEPIN"):
        return path
    subprocess.run(["cargo", "build", "--release", "--locked", "--quiet", "--package", "loosepin-cli"], cwd=ROOT, check=True)
    return str(ROOT / "target/release/loosepin")


def simulate(loosepin, file, folder, tolerance_m):
    command = [loosepin, "simulate", str(file), "--states", "--out", str(folder), "--force", "--tolerance", f"{tolerance_m!r} m"]
    try:
        return subprocess.run(command, capture_output=True, text=True, timeout=MOST_S)
    except subprocess.TimeoutExpired:
        return subprocess.CompletedProcess(command, -1, "", f"error[more than {MOST_S} s]")


def code_of(outcome):
    codes = re.findall(r"error\[(.*?)\]", outcome.stderr)
    return codes[0] if codes else f"status {outcome.returncode}: {outcome.stderr[-200:]}"


class Tally:
    """Counts of what was run, and the worst of every figure with the mechanism that has it."""

    def __init__(self):
        self.seen, self.refused, self.worst, self.above = collections.Counter(), collections.defaultdict(list), {}, []
        self.distances, self.checked, self.finished = [], 0, 0

    def note(self, number, name, value):
        if not value <= self.worst.get(name, (-1.0, None))[0]:
            self.worst[name] = (value, number)
        if not value <= LIMITS[name][0]:
            self.above.append((number, name, value))

    def see(self, mechanism):
        for joint in mechanism.joints:
            self.seen[f"joint {joint.kind}" + (" with play" if joint.play else "")] += 1
            if joint.friction:
                self.seen[f"friction of an ideal joint {joint.friction.name}"] += 1
            if joint.play:
                play = joint.play
                self.seen[f"contact {play.contact.law}"] += 1
                if play.friction:
                    self.seen[f"friction {play.friction.name}" + (" (literal)" if play.literal else "")] += 1
                if play.film:
                    self.seen[f"film {play.film.law}"] += 1
            if joint.drive:
                self.seen[f"drive {joint.drive.kind}"] += 1
        for spring in mechanism.springs:
            self.seen[f"spring {spring.kind}"] += 1
        for load in mechanism.loads:
            self.seen[f"load {load.kind}"] += 1


def check(number, seed, loosepin, folder, tally):
    rng = np.random.default_rng([seed, number])
    mechanism = generate.random_mechanism(rng)
    file = folder / "model.toml"
    file.write_text(model_file.text(mechanism, ROWS))
    outcome = simulate(loosepin, file, folder / "a", TOLERANCE_M)
    if outcome.returncode != 0:
        tally.refused[code_of(outcome)].append(number)
        return
    tally.finished += 1
    tally.see(mechanism)
    run = balance.evaluate(mechanism, folder / "a")
    in_guides = [joint.play.contact.law for joint in mechanism.joints if joint.play and joint.kind == "prismatic"]
    needs_mass = any(law in laws.LINEAR[1:] for law in in_guides)
    for name, value in figures.figures(mechanism, run).items():
        is_loose = needs_mass and name in ("newton-euler", "power")
        tally.note(number, name + (", mass at the onset" if is_loose else ""), value)
    tally.checked += int(np.sum(run.spare))
    compare_with_itself(number, loosepin, file, folder, mechanism, run, tally)


def compare_with_itself(number, loosepin, file, folder, mechanism, run, tally):
    """The run against one at a tenth of its tolerance; where impacts have parted them, against one at ten times it too."""
    def motion(share):
        other = simulate(loosepin, file, folder / "b", share * TOLERANCE_M)
        if other.returncode != 0:
            tally.refused[f"at {share:g} times the tolerance: {code_of(other)}"].append(number)
            return None
        return balance.Motion(mechanism, folder / "b")

    if (finer := motion(0.1)) is None:
        return
    apart = figures.distances(run.motion, finer)
    contacts = sum(joint["contacts"] for joint in run.summary["joints"])
    tally.distances.append((float(apart[-1]), contacts, number))
    if contacts <= 8:
        tally.note(number, "itself, up to 8 contacts", float(apart[-1]))
    if apart[-1] <= TOLERANCE_M or (coarser := motion(10)) is None:
        return
    # Where the coarse one is only just off: later impacts part all runs, whatever their tolerance.
    off = figures.distances(run.motion, coarser)
    row = np.argmax(off > 10 * TOLERANCE_M) if off[-1] > 10 * TOLERANCE_M else -1
    tally.note(number, "convergence", float(apart[row] / off[row]))


def show(tally, count, seed):
    print(f"{count} mechanisms, seed {seed}: {tally.finished} ran, {tally.checked} equations more than unknown forces were checked")
    for code, numbers in sorted(tally.refused.items(), key=lambda each: -len(each[1])):
        print(f"  {len(numbers)} ended with {code}: mechanisms {', '.join(map(str, numbers[:5]))}" + (", ..." if len(numbers) > 5 else ""))
    print("seen: " + ", ".join(f"{name} {times}" for name, times in sorted(tally.seen.items())))
    print(f"\n{'figure':34} {'worst':>9} {'limit':>8}  mechanism")
    for name, (limit, words) in LIMITS.items():
        value, number = tally.worst.get(name, (0.0, None))
        print(f"{name:34} {value:9.1e} {limit:8.0e}  {number}  {words}")
    distances = np.array([each[0] for each in tally.distances] or [0.0])
    print(f"\nat 1e-9 m against 1e-10 m, largest difference of positions: half below {np.quantile(distances, 0.5):.1e} m, "
          f"90 % below {np.quantile(distances, 0.9):.1e} m, 99 % below {np.quantile(distances, 0.99):.1e} m")
    within = np.mean(distances <= TOLERANCE_M)
    print(f"{100 * within:.1f} % within the tolerance; the largest (m, contacts, mechanism): "
          + ", ".join(f"({d:.1e}, {c}, {n})" for d, c, n in sorted(tally.distances, reverse=True)[:8]))
    for number, name, value in tally.above:
        print(f"ABOVE ITS LIMIT: mechanism {number}, {name}: {value:.2e}")


def main():
    count, seed, first = (int(word) for word in (sys.argv[1:] + ["500", "1", "0"][len(sys.argv) - 1 :])[:3])
    loosepin, tally = program(), Tally()
    with tempfile.TemporaryDirectory() as folder:
        for done, number in enumerate(range(first, first + count)):
            if done % 25 == 0:
                print(f"{done} of {count}", file=sys.stderr, flush=True)
            try:
                check(number, seed, loosepin, Path(folder), tally)
            except Exception as error:
                raise RuntimeError(f"mechanism {number} of seed {seed}") from error
    show(tally, count, seed)
    return 1 if tally.above else 0


if __name__ == "__main__":
    sys.exit(main())

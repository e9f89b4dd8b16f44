"""Makes the reference history of a case: `reference.csv` and `expected.toml` beside its `model.toml`.

Two runs at different accuracies must agree over the whole span; the case is refused otherwise.
"""

import sys
from pathlib import Path

import numpy as np

import mechanics
import model_file
from integrate import CUT_CHANGE, END, ONSET, ZONE_CHANGE, Settings, run

AGREEMENT_M = 1e-9  # position agreement asked of the two runs
LISTED_ONSETS = 12
PROBE_M = 1e-11  # change of the clearances that measures how fast differences grow
FINE = Settings(position_error=1e-15, velocity_error=1e-12, largest_step_s=5e-6)
FINER = Settings(position_error=2e-16, velocity_error=2e-13, largest_step_s=2.3e-6)


def history_of(path, settings, wider_m=0.0):
    """The mechanism at `path` and its history over the recorded turns of its cycle; every radial clearance, and
    half of every backlash, is made `wider_m` larger, at the same stiffness."""
    mechanism = model_file.read(path)
    for joint in mechanism.clearances:
        joint.radial_clearance_m += wider_m
    for mesh in mechanism.meshes:
        mesh.backlash_m += 2.0 * wider_m
    system = mechanics.tables(mechanism)
    start, _ = mechanics.assemble(mechanism, system)
    turn_s = 2.0 * np.pi / abs(mechanism.drive_speed_rad_s)
    count = round(mechanism.recorded_turns * mechanism.samples_per_turn)
    times = np.linspace(0.0, mechanism.recorded_turns * turn_s, count + 1)
    return mechanism, run(start, times, system, settings)


def differences(fine, finer, bodies):
    """Largest differences in positions (m, rad), velocities and accelerations, row by row."""
    difference = np.abs(fine.rows - finer.rows)[:, 1:].reshape(len(fine.rows), 3, 3 * bodies)
    return difference.max(axis=2)


def header(bodies):
    names = ["time"]
    for columns in (("x", "y", "a"), ("vx", "vy", "w"), ("ax", "ay", "al")):
        names += [f"b{b + 1}_{column}" for b in range(bodies) for column in columns]
    return ",".join(names)


def events_of(history, contacts):
    return history.events[np.isin(history.events[:, 1], contacts)]


def contacts_of(mechanism):
    """Each clearance joint and each pair of gears with the numbers of its contacts: gears have a contact for each flank."""
    joints = [(joint, [k]) for k, joint in enumerate(mechanism.clearances)]
    first = len(joints)
    return joints + [(mesh.contact, [first + 2 * k, first + 2 * k + 1]) for k, mesh in enumerate(mechanism.meshes)]


def count_of(history, kind, joint=None):
    """How many logged events are of a kind (at some contacts); cuts count where they begin."""
    mine = history.events if joint is None else events_of(history, joint)
    return int(np.sum((mine[:, 2] == kind) & ((mine[:, 5] == 1) if kind == CUT_CHANGE else True)))


def longest_predictable(path):
    """Prints the agreement of the two runs and the growth of differences along the span, to choose `recorded_turns`."""
    mechanism, fine = history_of(path, FINE)
    _, finer = history_of(path, FINER)
    _, wider = history_of(path, FINE, PROBE_M)
    size = differences(fine, finer, len(mechanism.bodies))[:, 0]
    growth = differences(fine, wider, len(mechanism.bodies))[:, 0] / PROBE_M
    for share in np.linspace(0.1, 1.0, 10):
        last = int(share * (len(size) - 1))
        agreement_m, grown = size[: last + 1].max(), growth[: last + 1].max()
        print(f"{share * mechanism.recorded_turns:8.4f} turns: {agreement_m:.2e} m, growth {grown:.2g}")
    onsets = fine.events[fine.events[:, 2] == ONSET]
    print(
        f"{len(onsets)} onsets, {count_of(fine, CUT_CHANGE)} cuts, {count_of(fine, ZONE_CHANGE)} changes"
        f" of friction zone, {fine.steps} steps, energy residual {fine.energy_residual_j:.2e} J"
    )
    return mechanism, fine, finer


def write(folder):
    """Writes `reference.csv` and `expected.toml` of the case in `folder`."""
    folder = Path(folder)
    mechanism, fine = history_of(folder / "model.toml", FINE)
    _, finer = history_of(folder / "model.toml", FINER)
    worst = differences(fine, finer, len(mechanism.bodies)).max(axis=0)
    _, wider = history_of(folder / "model.toml", FINE, PROBE_M)
    growth = differences(fine, wider, len(mechanism.bodies)).max(axis=0)[0] / PROBE_M
    if not worst[0] < AGREEMENT_M:
        raise SystemExit(f"{folder.name}: the two runs differ by {worst[0]:.2e} m; record a shorter span")
    np.savetxt(
        folder / "reference.csv", fine.rows, delimiter=",", header=header(len(mechanism.bodies)), comments="",
        fmt="%.13g",
    )  # fmt: skip
    (folder / "expected.toml").write_text(expected(mechanism, fine, finer, worst, growth))
    print(f"{folder.name}: {len(fine.rows)} rows, agreement {worst[0]:.1e} m, {worst[1]:.1e} m/s, growth {growth:.2g}")


def expected(mechanism, fine, finer, worst, growth):
    """Text of `expected.toml`."""
    loss, friction, work = fine.integrals[-1, :3]
    other = finer.integrals[-1, :3]
    lines = [
        "# Written by make_reference.py with cases/oracle (maximal coordinates, multipliers, DOP853, located events).",
        "# SI units. `b1`.. in reference.csv: " + ", ".join(b.name for b in mechanism.bodies) + ".",
        "",
        "[reference]",
        'source = "peer: cases/oracle"',
        f"rows = {len(fine.rows)}",
        f"span_s = {fine.rows[-1, 0]:.13g}",
        "# Largest difference from a second run at other tolerances, over all bodies and rows (m and rad mixed).",
        f"agreement_position_m = {worst[0]:.1e}",
        f"agreement_velocity_m_s = {worst[1]:.1e}",
        f"agreement_acceleration_m_s2 = {worst[2]:.1e}",
        f"# Largest change of a position in the span for a change of {PROBE_M:g} m of every clearance, divided by it.",
        f"growth = {growth:.2g}",
        "",
        "[energy]",
        f"contact_loss_j = {loss:.9e}",
        f"friction_loss_j = {friction:.9e}",
        f"drive_work_j = {work:.9e}",
        f"agreement_j = {np.max(np.abs(fine.integrals[-1, :3] - other)):.1e}",
        f"residual_j = {fine.energy_residual_j:.1e}",
    ]
    for joint, k in contacts_of(mechanism):
        mine, theirs = events_of(fine, k), events_of(finer, k)
        onsets, ends = mine[mine[:, 2] == ONSET], mine[mine[:, 2] == END]
        other_onsets, other_ends = theirs[theirs[:, 2] == ONSET], theirs[theirs[:, 2] == END]
        if len(onsets) != len(other_onsets):
            raise SystemExit(f"joint '{joint.name}': {len(onsets)} and {len(other_onsets)} onsets in the two runs")
        lines += [
            "",
            f"[joint.{joint.name}]",
            f'law = "{joint.law}"',
            f"stiffness_n_m_n = {joint.stiffness_n_m_n:.12e}",
            f"exponent = {joint.exponent:.12g}",
            f"damping_factor = {joint.damping_factor:.12g}",
            f"onsets = {len(onsets)}",
            f"floored_onsets = {int(np.sum(onsets[:, 3] < joint.minimum_impact_speed_m_s))}",
            f"ends = {len(ends)}",
            f"force_cuts = {count_of(fine, CUT_CHANGE, k)}",
            f"friction_zone_changes = {count_of(fine, ZONE_CHANGE, k)}",
        ]
        if len(ends):
            lines += [
                f"peak_force_n = {ends[:, 5].max():.9e} # of the contacts that ended within the span",
                f"agreement_peak_force_n = {np.max(np.abs(ends[:, 5] - other_ends[:, 5])):.1e}",
            ]
        if len(onsets):
            lines += [
                f"agreement_onset_s = {np.max(np.abs(onsets[:, 0] - other_onsets[:, 0])):.1e}",
                f"agreement_speed_m_s = {np.max(np.abs(onsets[:, 3] - other_onsets[:, 3])):.1e}",
            ]
        for n, onset in enumerate(onsets[:LISTED_ONSETS]):
            end = ends[n] if n < len(ends) else None
            tail = "" if end is None else (
                f", duration_s = {end[0] - onset[0]:.9e}, peak_force_n = {end[5]:.9e},"
                f" separation_speed_m_s = {-end[3]:.9e}"
            )  # fmt: skip
            if n == 0:
                lines.append("impact = [")
            lines.append(f"  {{ time_s = {onset[0]:.12e}, speed_m_s = {onset[3]:.9e}{tail} }},")
        if len(onsets):
            lines.append("]")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    longest_predictable(sys.argv[1])

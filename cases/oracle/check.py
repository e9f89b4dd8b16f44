"""Checks of the reference program itself: derivatives, conservation, restitution, and two published histories.

    python check.py        # prints one line a check; exit status 1 if one fails
"""

import math
import sys
from pathlib import Path

import numpy as np

import mechanics
import model_file
from integrate import END, ONSET, Settings, run
from model_file import Clearance
from reference import FINE
from reporting import report, status

CASES = Path(__file__).parent.parent
STEP = 1e-6  # of the central differences; their error is about STEP² times third derivatives
DIFFERENCE_TOLERANCE = 1e-7
CONSERVATION_TOLERANCE = 1e-12  # of energy J and angular momentum kg m²/s of order 1
RESTITUTION_TOLERANCE = 5e-5  # the table has four digits
RESTITUTION = {  # nominal 0.5, 0.7, 0.9
    "hunt-crossley": (0.6630, 0.7680, 0.9090), "lankarani-nikravesh": (0.7252, 0.7960, 0.9132),
    "lee-wang": (0.7992, 0.8693, 0.9524), "herbert-mcwhannell": (0.5936, 0.7227, 0.9009),
    "zhiying-qishao": (0.4826, 0.6796, 0.8959), "gonthier": (0.4877, 0.6696, 0.8764),
    "flores": (0.4704, 0.6832, 0.8939), "hu-guo": (0.4877, 0.6973, 0.8999),
    "carvalho-martins": (0.5002, 0.7000, 0.9000), "exact-restitution": (0.5, 0.7, 0.9), "hertz": (1.0, 1.0, 1.0),
}  # fmt: skip
# Distances that the histories of the named cases state for themselves, m.
PUBLISHED = {"slider_crank_5000": 1e-8, "four_bar_600": 1e-8}
# Cases with what the reader of models does not know: links that bend, no drive, contacts alone, friction without a law.
NOT_READ = {
    "backlash_test", "double_four_bar", "flexible_four_bar", "flexible_slider_crank", "free_impacts", "slider_crank_guide",
    "static_forces",
}  # fmt: skip


def constraint_derivatives():
    """J against ∂C/∂q, and γ against -(d/dt)(J v) along constant v, on every case that the reader knows."""
    for path in sorted(path for path in CASES.glob("*/model.toml") if path.parent.name not in NOT_READ):
        mechanism = model_file.read(path)
        system = mechanics.tables(mechanism)
        start, _ = mechanics.assemble(mechanism, system)
        size = 3 * len(mechanism.bodies)
        generator = np.random.default_rng(7)
        q, v = start[:size] + 0.02 * generator.standard_normal(size), generator.standard_normal(size)
        _, jacobian, _, gamma = mechanics.constraint_rows(0.0, q, v, system)
        worst = 0.0
        for column in range(size):
            moved = np.zeros(size)
            moved[column] = STEP
            above, below = (mechanics.constraint_rows(0.0, q + s * moved, v, system)[0] for s in (1, -1))
            worst = max(worst, np.max(np.abs((above - below) / (2 * STEP) - jacobian[:, column])))
        above, below = (mechanics.constraint_rows(0.0, q + s * STEP * v, v, system)[1] @ v for s in (1, -1))
        worst = max(worst, np.max(np.abs((above - below) / (2 * STEP) + gamma)))
        report(f"derivatives of the constraints of {path.parent.name}", worst, DIFFERENCE_TOLERANCE)


def free_pair(law, restitution, friction, is_literal=False, spin_rad_s=(0.0, 0.0)):
    """Two free bodies, pin in hole, no gravity, moving towards contact from the centred position."""
    joint = Clearance(
        "pair", 0, 1, (0.013, -0.004), (0.0, 0.0), 0.01, 0.0005, 6.610198e10, 1.5,
        model_file.damping_factor(law, restitution), 1e-3, friction, 1e-4, 1e-3, is_literal, law, restitution,
    )  # fmt: skip
    masses = np.array([[1.7, 2.3e-3], [0.14, 1.1e-5]])
    empty_integers, empty_numbers = np.zeros((0, 4), dtype=np.int64), np.zeros((0, 8))
    pair = np.array([[0, 1, int(is_literal)]], dtype=np.int64)
    numbers = np.array([[
        *joint.point_i_m, *joint.point_j_m, joint.bearing_radius_m, joint.radial_clearance_m, joint.stiffness_n_m_n,
        joint.exponent, joint.damping_factor, joint.minimum_impact_speed_m_s, friction, 1e-4, 1e-3,
    ]])  # fmt: skip
    system = (masses, 0.0, empty_integers, empty_numbers, 0, pair, numbers, np.zeros((1, 8)), *mechanics.load_tables([]))
    start = np.zeros(12 + mechanics.INTEGRALS)
    start[:6] = 0.0, 0.0, 0.3, 0.0, 0.0, 0.0
    start[3:5] = mechanics.arm(start[:6], 0, *joint.point_i_m)
    start[6:12] = 0.05, -0.02, spin_rad_s[0], 0.9, 0.4, spin_rad_s[1]
    return start, system


def conservation():
    """Energy with its losses, momentum and angular momentum of two free bodies through an impact with friction."""
    for is_literal in (False, True):
        start, system = free_pair("flores", 0.7, 0.3, is_literal, (2.0, -31.0))
        history = run(start, np.linspace(0.0, 3e-3, 31), system, Settings(1e-16, 1e-13, 1e-6))
        masses = system[0]

        def momenta(row):
            q, v = row[1:7], row[7:13]
            linear = sum(masses[b, 0] * v[3 * b : 3 * b + 2] for b in (0, 1))
            angular = sum(
                masses[b, 1] * v[3 * b + 2] + masses[b, 0] * (q[3 * b] * v[3 * b + 1] - q[3 * b + 1] * v[3 * b])
                for b in (0, 1)
            )
            return np.array([*linear, angular])

        change = np.max(np.abs(momenta(history.rows[-1]) - momenta(history.rows[0])))
        reading = "literal" if is_literal else "material"
        assert np.sum(history.events[:, 2] == ONSET) >= 1
        report(f"momenta of a free pair, {reading}", change, CONSERVATION_TOLERANCE)
        report(f"energy of a free pair, {reading}", history.energy_residual_j, CONSERVATION_TOLERANCE)


def restitutions():
    """The delivered restitution of a free central impact."""
    for law, delivered in RESTITUTION.items():
        for nominal, expected in zip((0.5, 0.7, 0.9), delivered, strict=True):
            start, system = free_pair(law, nominal, 0.0)
            system[0][0] = 1e9, 1e9  # a wall
            start[6:12] = 0.0, 0.0, 0.0, 0.8, 0.6, 0.0
            history = run(start, np.array([0.0, 8e-4]), system, FINE)
            onset, end = (history.events[history.events[:, 2] == kind][0] for kind in (ONSET, END))
            report(f"restitution of {law} {nominal}", abs(-end[3] / onset[3] - expected), RESTITUTION_TOLERANCE)


def published_histories():
    """The two histories that this program did not make, where their cases lie beside."""
    for name, tolerance_m in PUBLISHED.items():
        if not (CASES / name / "reference.csv").exists():
            print(f"     {name} is not here")
            continue
        table = np.loadtxt(CASES / name / "reference.csv", delimiter=",", skiprows=1)
        mechanism = model_file.read(CASES / name / "model.toml")
        system = mechanics.tables(mechanism)
        start, _ = mechanics.assemble(mechanism, system)
        history = run(start, table[:, 0].copy(), system, FINE)
        columns = slice(1, 1 + 3 * len(mechanism.bodies))
        report(f"history of {name}", np.max(np.abs(history.rows - table)[:, columns]), tolerance_m)


if __name__ == "__main__":
    assert math.isclose(model_file.Expression("2 mm + 3 * 10^2 um", {}).value(), 2.3e-3)
    constraint_derivatives()
    conservation()
    restitutions()
    published_histories()
    sys.exit(status())

"""Figures of one run: how far it is from Newton and Euler, from its own power and energy, and from the laws with a memory."""

import sys
from pathlib import Path

import numpy as np

import generate
import laws
from balance import LENGTH, dot

sys.path.append(str(Path(__file__).resolve().parents[2] / "tools" / "film"))
import ruptured as relaxed  # noqa: E402

# Rows in which LuGre's bristles move by less than this share of their settling length are resolved.
RESOLVED = 0.1


def figures(mechanism, run):
    motion, energy, summary = run.motion, run.energy, run.summary
    found = {"newton-euler": float(run.relative.max(initial=0.0)),
             "closure": float(run.closure[0]), "closing rate": float(run.closure[1])}
    found |= power(run)
    account = summary["energy"]
    scale = max(np.max(energy.kinetic), 1e-12)
    for name in ("kinetic", "potential", "stored"):
        own = getattr(energy, name) + np.zeros(len(motion.time))
        size = max(scale, np.max(np.abs(own)))
        found[name] = float(np.max(np.abs(own - np.array(account[name + "_j"]))) / size)
    found["own account"] = account["relative_residual"]
    found["bristles"] = bristles(run)
    found["film"] = film(run)
    found["damper"] = damper(run)
    return found


def power(run):
    """Power of all forces against the change of kinetic energy; drives against the work that is recorded."""
    motion, forces = run.motion, run.forces
    velocity = motion.velocity
    gain = np.einsum("ijk,ijk->i", run.inertia, velocity)
    applied = np.einsum("ijk,ijk->i", run.total, velocity)
    size = np.einsum("ijk,ijk->i", np.abs(run.inertia) + np.abs(run.total), np.abs(velocity))
    supplied = run.energy.loads + np.zeros(len(motion.time))
    is_known = np.ones(len(motion.time), bool)
    for k, (wrench, note) in enumerate(zip(forces.unknowns, forces.notes)):
        if note is None:
            continue
        if note[0] == "drive":
            work = run.values[:, k] * note[1]
            supplied = supplied + work
            is_known &= run.is_known[:, k]
        else:
            work = run.values[:, k] * np.einsum("ijk,ijk->i", wrench, velocity)
        applied = applied + work
        size = size + np.abs(work)
    rest = np.abs(gain - applied) / np.maximum(size, 1e-6 * np.max(size, initial=1e-300) + 1e-300)
    # Simpson's rule over two rows against the work recorded. Where a force jumps between rows it is off by up to four times its
    # difference from the trapezoidal rule; an impact between rows it does not see, so that nine tenths of the pairs are looked at.
    step = motion.time[2::2] - motion.time[:-2:2][: len(motion.time[2::2])]
    p0, p1, p2 = supplied[:-2:2][: len(step)], supplied[1:-1:2][: len(step)], supplied[2::2]
    simpson, trapezoid = step / 6 * (p0 + 4 * p1 + p2), step / 4 * (p0 + 2 * p1 + p2)
    work = np.array(run.summary["energy"]["supplied_j"])
    recorded = (work[2::2] - work[:-2:2][: len(step)])
    doubt = 4 * np.abs(simpson - trapezoid)
    largest = max(np.max(np.abs(work)), np.max(run.energy.kinetic), 1e-12)
    excess = np.maximum(np.abs(recorded - simpson) - doubt, 0.0) / largest
    excess = excess[is_known[:-2:2][: len(step)] & is_known[1:-1:2][: len(step)] & is_known[2::2]]
    if len(excess) == 0:
        excess = np.zeros(1)
    return {"power": float(rest.max(initial=0.0)), "work": float(np.quantile(excess, 0.9))}


def bristles(run):
    """LuGre: from the friction that Newton and Euler need, the deflection; its change between rows against the law's."""
    worst = 0.0
    for k, note in enumerate(run.forces.notes):
        if note is None or note[0] not in ("lugre", "joint lugre"):
            continue
        if note[0] == "lugre":
            entry = note[1]
            play = next(play for play in run.plays if any(each is entry for each in play.contacts))
            law, v, mu = play.joint.play.friction, entry.sliding, run.values[:, k]
            good = entry.closed & (entry.normal > 1e-3 * np.max(entry.normal, initial=0.0)) & (entry.begin >= 0)
            same = good[1:] & good[:-1] & (entry.begin[1:] == entry.begin[:-1])
        else:
            joint = note[1]
            law, v = joint.friction, joint.sliding
            normal = normal_of(joint, run.values)
            good = normal > 1e-3 * np.max(normal, initial=0.0)
            if joint.drive:
                continue
            mu = np.where(good, run.values[:, k] / np.where(good, normal, 1.0), 0.0)
            same = good[1:] & good[:-1]
        same &= run.is_known[1:, k] & run.is_known[:-1, k]
        n = law.numbers
        g = laws.settled(law, v)
        # -μ = σ0 z + σ1 (v - σ0 |v| z/g) + η v
        stiff = n["bristle_stiffness"] * (1 - n["bristle_damping"] * np.abs(v) / g)
        z = (-mu - (n["bristle_damping"] + n["viscous"]) * v) / stiff
        largest = n["static_coefficient"] / n["bristle_stiffness"]
        step = np.diff(run.motion.time)
        relax = n["bristle_stiffness"] * np.abs(v) / g
        middle = 0.5 * (relax[1:] + relax[:-1]) * step
        smooth = same & (middle < RESOLVED) & (np.abs(stiff[1:]) > 0.1 * n["bristle_stiffness"]) & (np.abs(stiff[:-1]) > 0.1 * n["bristle_stiffness"])
        rates = v - relax * z
        change = 0.5 * (rates[1:] + rates[:-1]) * step
        bend = 0.5 * np.abs(rates[1:] - rates[:-1]) * step
        excess = np.maximum(np.abs(np.diff(z) - change) - bend, 0.0) / largest
        # Bristles that swing between two rows are not resolved by them: the median of the pairs is looked at.
        worst = max(worst, float(np.median(excess[smooth])) if np.any(smooth) else 0.0)
    return worst


def damper(run):
    """Linear laws whose damper is set by the mass at the onset: it stays the same until the contact ends."""
    worst = 0.0
    for k, note in enumerate(run.forces.notes):
        if note is None or note[0] != "damper" or note[1] is None:
            continue
        entry, size = note[1], run.values[:, k]
        pull = size * entry.rate
        good = entry.closed & run.is_known[:, k] & (np.abs(pull) > 1e-3 * entry.spring) & (entry.spring + pull > 0.01 * entry.spring)
        for begin in np.unique(entry.begin[good & (entry.begin >= 0)]):
            found = (size / entry.share)[good & (entry.begin == begin)]
            worst = max(worst, float((found.max() - found.min()) / np.abs(found).max()))
    return worst


def normal_of(joint, values):
    first, second = (values[:, k] for k in joint.columns[:2])
    if joint.kind == "revolute":
        return np.hypot(first, second)
    return np.abs(0.5 * first - second / joint.size) + np.abs(0.5 * first + second / joint.size)


def film(run, rows=2):
    """Films of any length: the force that Newton and Euler need against a solution of the Reynolds equation, in a few rows."""
    solutions = {"finite-length": reynolds, "reynolds": ruptured}
    worst = 0.0
    for play in run.plays:
        if play.joint.play.film is None or play.joint.play.film.law not in solutions:
            continue
        data, found = play.joint.play, play.film
        is_known = np.all(run.is_known[:, found.columns], axis=1)
        thick = np.flatnonzero(is_known & found.thick & (found.ratio < 0.95) & (found.ratio > 0.01))
        for row in thick[:: max(len(thick) // rows, 1)][:rows]:
            solution = solutions[data.film.law]
            own = solution(data.length / (2 * data.radius), found.ratio[row], found.squeeze[row], found.wedge[row])
            own = own * 3 * data.film.viscosity * data.length * data.radius**3 / data.clearance**2
            needed = np.array([run.values[row, k] for k in found.columns])
            worst = max(worst, float(np.max(np.abs(own - needed)) / np.linalg.norm(own)))
    return worst


def reynolds(length_ratio, ratio, squeeze, wedge, places=600, modes=15, stations=41):
    """∫∫ max(p, 0) (cos θ, sin θ) dθ dζ: cosines along the bearing, finite volumes around it."""
    step = 2 * np.pi / places
    theta = step * (np.arange(places) + 0.5)
    film = (1 + ratio * np.cos(theta)) ** 3
    face = (1 + ratio * np.cos(step * np.arange(places))) ** 3
    around = np.diag(-(face + np.roll(face, -1))) + np.diag(face[1:], 1) + np.diag(face[1:], -1)
    around[0, -1] += face[0]
    around[-1, 0] += face[0]
    right = 2 * squeeze * np.cos(theta) - wedge * np.sin(theta)
    zeta = (np.arange(stations) + 0.5) / stations
    pressure = np.zeros((places, stations))
    for m in range(modes):
        k = (2 * m + 1) * np.pi / 2
        system = around / step**2 - np.diag(film) * (k / length_ratio) ** 2
        pressure += np.outer(np.linalg.solve(system, right * 2 * (-1) ** m / k), np.cos(k * zeta))
    sums = 2 * np.maximum(pressure, 0).mean(axis=1) * step
    return np.array([np.sum(sums * np.cos(theta)), np.sum(sums * np.sin(theta))])


def ruptured(length_ratio, ratio, squeeze, wedge, places=160, stations=16):
    """∫∫ p (cos θ, sin θ) dθ dζ of a film that ruptures without a slope; two grids, tools/film/ruptured.py."""
    scale = np.hypot(2 * squeeze, wedge)
    coarse, fine = (
        relaxed.force(ratio, length_ratio, squeeze / scale, wedge / scale, k * places, k * stations) for k in (1, 2)
    )
    return scale * (4 * fine - coarse) / 9


def distances(first, second):
    """Largest difference of the positions of two runs of one mechanism up to each row, m; angles at the length."""
    apart = np.abs(first.position - second.position) * np.array([1.0, 1.0, LENGTH])
    return np.maximum.accumulate(np.max(apart, axis=(1, 2)))

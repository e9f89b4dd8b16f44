"""Newton and Euler for every recorded row: forces from positions and velocities by the laws, accelerations as recorded.

What an ideal joint or a drive carries is not known beforehand. It is fitted to m a - F by least squares, row for row; a mechanism that
moves has more equations than such unknowns, and what is left of them must vanish. The same goes for the power of all forces.
"""

import csv
import json
from types import SimpleNamespace as Numbers

import numpy as np

import generate
import laws

LENGTH = 0.1  # turns moments into forces where both are compared, m
ROUND_OFF = 1e-12  # of times in files
MOST_ITERATIONS = 1000


class Motion:
    """Positions, velocities and accelerations of all bodies, row by row; body 0 is the ground."""

    def __init__(self, mechanism, folder):
        with open(folder / "history.csv") as file:
            header = next(csv.reader(file))
        table = np.loadtxt(folder / "history.csv", delimiter=",", skiprows=1, ndmin=2)
        column = {name: table[:, k] for k, name in enumerate(header)}
        self.time = column["time_s"]
        rows = len(self.time)
        nothing = np.zeros((rows, 3))
        def of(*suffixes):
            moving = [np.stack([column[f"{b.name}.{s}"] for s in suffixes], axis=1) for b in mechanism.bodies[1:]]
            return np.stack([nothing, *moving], axis=1)
        self.position = of("x_m", "y_m", "angle_rad")
        self.velocity = of("vx_m_s", "vy_m_s", "omega_rad_s")
        self.acceleration = of("ax_m_s2", "ay_m_s2", "alpha_rad_s2")
        self.mechanism = mechanism

    def arm(self, body, point):
        """From the centre of mass to a point of the body, in the world."""
        local = np.asarray(point) - (self.mechanism.bodies[body].centre if body else 0.0)
        return self.turned(body, local)

    def turned(self, body, local):
        angle = self.position[:, body, 2]
        cos, sin = np.cos(angle), np.sin(angle)
        return np.stack([cos * local[0] - sin * local[1], sin * local[0] + cos * local[1]], axis=1)

    def point(self, body, point):
        return self.position[:, body, :2] + self.arm(body, point)

    def speed_at(self, body, place):
        """Velocity of the body's material at a place of the world."""
        arm = place - self.position[:, body, :2]
        spin = self.velocity[:, body, 2:3]
        return self.velocity[:, body, :2] + spin * turn(arm)


def turn(vector):
    return np.stack([-vector[:, 1], vector[:, 0]], axis=1)


def dot(a, b):
    return np.einsum("ij,ij->i", a, b)


def cross(a, b):
    return a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]


class Forces:
    """Forces and moments on all bodies about their centres of mass, and the directions of those that are not known."""

    def __init__(self, motion):
        self.motion = motion
        self.total = np.zeros_like(motion.position)
        self.size = np.zeros(len(motion.time))
        self.unknowns = []
        self.notes = []

    def wrench(self, bodies, place, force, moment=None):
        """A force on the second of both bodies at a place, and a moment; the opposite on the first."""
        wrench = np.zeros_like(self.total)
        for body, sign in zip(bodies, (-1.0, 1.0)):
            if body == generate.GROUND:
                continue
            arm = place - self.motion.position[:, body, :2]
            wrench[:, body, :2] += sign * force
            wrench[:, body, 2] += sign * (cross(arm, force) + (0.0 if moment is None else moment))
        return wrench

    def add(self, wrench):
        self.total += wrench
        self.size = np.maximum(self.size, norm(wrench))

    def unknown(self, wrench, note=None):
        self.unknowns.append(wrench)
        self.notes.append(note)
        return len(self.unknowns) - 1


def norm(wrench):
    """Largest force on a body, moments over the length."""
    return np.max(np.abs(wrench * np.array([1.0, 1.0, 1 / LENGTH])), axis=(1, 2))


def read_impacts(folder):
    with open(folder / "impacts.csv") as file:
        return [(row["joint"], float(row["time_s"]), float(row["duration_s"]), float(row["speed_m_s"])) for row in csv.DictReader(file)]


def impact_speed(play, name, impacts, time):
    """v0 of the contact at hand: that of its impact, or the floor of the law."""
    speed = np.full_like(time, play.contact.floor)
    begin = np.full_like(time, -1.0)
    for joint, start, duration, found in impacts:
        if joint == name:
            within = (time >= start) & (time <= start + duration + ROUND_OFF * time[-1])
            speed[within], begin[within] = max(found, play.contact.floor), start
    return speed, begin


def evaluate(mechanism, folder):
    """All figures of one run."""
    motion = Motion(mechanism, folder)
    forces = Forces(motion)
    impacts = read_impacts(folder)
    summary = json.loads((folder / "summary.json").read_text())
    energy = Numbers(kinetic=0.0, potential=0.0, stored=0.0, damping=0.0, loads=0.0)
    for index, body in enumerate(mechanism.bodies[1:], start=1):
        weight = np.zeros_like(forces.total)
        weight[:, index, 1] = -body.mass * mechanism.gravity
        forces.add(weight)
        v = motion.velocity[:, index]
        energy.kinetic += 0.5 * body.mass * dot(v[:, :2], v[:, :2]) + 0.5 * body.inertia * v[:, 2] ** 2
        energy.potential += body.mass * mechanism.gravity * motion.position[:, index, 1]
    add_springs(mechanism, motion, forces, energy)
    add_loads(mechanism, motion, forces, energy)
    closure = join_ideal(mechanism, motion, forces)
    forces.ideal = len(forces.unknowns)
    # Solved instead of integrated: without play, and every freedom driven.
    forces.is_driven = summary["counters"]["evaluations"] == 0
    add_joint_bristles(mechanism, forces)
    plays = [add_play(joint, motion, forces, impacts, energy) for joint in mechanism.joints if joint.play]
    return solve(mechanism, motion, forces, energy, plays, closure, summary)


def add_springs(mechanism, motion, forces, energy):
    for spring in mechanism.springs:
        first, second = spring.bodies
        if spring.kind == "linear":
            ends = [motion.point(b, p) for b, p in zip(spring.bodies, spring.points)]
            along = ends[1] - ends[0]
            extent = np.linalg.norm(along, axis=1)
            direction = along / extent[:, None]
            rate = dot(motion.speed_at(second, ends[1]) - motion.speed_at(first, ends[0]), direction)
        else:
            extent = motion.position[:, second, 2] - motion.position[:, first, 2]
            rate = motion.velocity[:, second, 2] - motion.velocity[:, first, 2]
        change = extent - spring.free
        if spring.kind == "torsional":
            # The angle counts on over whole turns from where the bodies are at time zero.
            start = mechanism.bodies[second].pose[2] - mechanism.bodies[first].pose[2]
            change += 2 * np.pi * np.round((start - extent[0]) / (2 * np.pi))
        pull = spring.preload + spring.stiffness * change + spring.damping * rate
        if spring.kind == "linear":
            # Equal and opposite along the line: the second end is as good a place as any.
            forces.add(forces.wrench(spring.bodies, ends[1], -pull[:, None] * direction))
        else:
            forces.add(forces.wrench(spring.bodies, np.zeros_like(motion.position[:, 0, :2]), np.zeros((len(pull), 2)), -pull))
        energy.stored += 0.5 * spring.stiffness * change**2 + spring.preload * change
        energy.damping += spring.damping * rate**2


def add_loads(mechanism, motion, forces, energy):
    for load in mechanism.loads:
        size = generate.load_size(load, motion.time)
        if load.kind == "force":
            direction = np.array([np.cos(load.direction), np.sin(load.direction)])
            vector = size[:, None] * (motion.turned(load.body, direction) if load.follows else direction)
            place = motion.point(load.body, load.point)
            forces.add(forces.wrench((0, load.body), place, vector))
            energy.loads += dot(vector, motion.speed_at(load.body, place))
        else:
            zero = np.zeros((len(size), 2))
            forces.add(forces.wrench((0, load.body), zero, zero, size))
            energy.loads += size * motion.velocity[:, load.body, 2]


def join_ideal(mechanism, motion, forces):
    """Unknown forces of the ideal joints and drives; gives how far the joints are from closed, in position and velocity."""
    rows = len(motion.time)
    x, y, zero = np.tile([1.0, 0.0], (rows, 1)), np.tile([0.0, 1.0], (rows, 1)), np.zeros((rows, 2))
    one = np.ones(rows)
    gaps, rates = [np.zeros(rows)], [np.zeros(rows)]
    for joint in mechanism.joints:
        if joint.play:
            continue
        first, second = joint.bodies
        places = [motion.point(b, p) for b, p in zip(joint.bodies, joint.points)]
        here = places[1]
        gap = places[1] - places[0]
        rate = motion.speed_at(second, here) - motion.speed_at(first, here)
        spin = motion.velocity[:, second, 2] - motion.velocity[:, first, 2]
        angle = motion.position[:, second, 2] - motion.position[:, first, 2]
        joint.columns, joint.rubbing = [], None
        if joint.kind in ("revolute", "rigid"):
            joint.columns = [forces.unknown(forces.wrench(joint.bodies, here, axis)) for axis in (x, y)]
            gaps += [gap[:, 0], gap[:, 1]]
            rates += [rate[:, 0], rate[:, 1]]
        else:
            line = motion.turned(first, np.array([np.cos(joint.angles[0]), np.sin(joint.angles[0])]))
            joint.columns = [forces.unknown(forces.wrench(joint.bodies, here, turn(line)))]
            gaps.append(dot(gap, turn(line)))
            rates.append(dot(rate, turn(line)))
            joint.line = line
        if joint.kind in ("prismatic", "rigid"):
            joint.columns.append(forces.unknown(forces.wrench(joint.bodies, here, zero, one)))
            turned = angle + joint.angles[1] - joint.angles[0] if joint.kind == "prismatic" else angle - joint.angles[0]
            gaps.append(np.sin(turned) * LENGTH)
            rates.append(spin * LENGTH)
        if joint.drive:
            asked = generate.drive_rate(joint.drive, motion.time)
            if joint.kind == "revolute":
                column, is_at = forces.wrench(joint.bodies, here, zero, one), spin
            else:
                column, is_at = forces.wrench(joint.bodies, here, joint.line), dot(rate, joint.line)
            rates.append((is_at - asked) * (LENGTH if joint.kind == "revolute" else 1.0))
            forces.unknown(column, ("drive", asked))
        if joint.friction:
            if joint.kind == "revolute":
                joint.push, joint.sliding = forces.wrench(joint.bodies, here, zero, joint.size * one), joint.size * spin
            else:
                joint.push, joint.sliding = forces.wrench(joint.bodies, here, joint.line), dot(rate, joint.line)
    return np.max(np.abs(gaps)), np.max(np.abs(rates))


def add_joint_bristles(mechanism, forces):
    """LuGre's friction of ideal joints, where forces move the mechanism, is known by its history alone: an unknown here."""
    if forces.is_driven:
        return
    for joint in mechanism.joints:
        if joint.friction and joint.friction.name == "lugre":
            joint.rubbing = forces.unknown(joint.push, ("joint lugre", joint))


def add_play(joint, motion, forces, impacts, energy):
    """Contact, friction and film of one joint with play; what is not repeated here becomes an unknown."""
    play, (first, second) = joint.play, joint.bodies
    centres = [motion.point(b, p) for b, p in zip(joint.bodies, joint.points)]
    found = Numbers(joint=joint, contacts=[])
    if joint.kind == "prismatic":
        line = motion.turned(first, np.array([np.cos(joint.angles[0]), np.sin(joint.angles[0])]))
        axis = motion.turned(second, np.array([np.cos(joint.angles[1]), np.sin(joint.angles[1])]))
        for place, name in enumerate(["upper rear", "upper front", "lower rear", "lower front"]):
            along, up = (1.0 if place % 2 else -1.0), (1.0 if place < 2 else -1.0)
            corner = centres[1] + along * play.half_length * axis + up * play.half_height * turn(axis)
            normal = up * turn(line)
            depth = dot(normal, corner - centres[0]) - (play.half_height + play.clearance)
            add_contact(joint, f"{joint.name} ({name})", motion, forces, impacts, energy, found, corner, normal, depth)
        return found
    offset = centres[1] - centres[0]
    share, push = 1.0, None
    if joint.kind == "slot":
        line = motion.turned(first, np.array([np.cos(joint.angles[0]), np.sin(joint.angles[0])]))
        held = np.clip(dot(offset, line), -play.slot_half_length, play.slot_half_length)
        offset = offset - held[:, None] * line
    distance = np.maximum(np.linalg.norm(offset, axis=1), 1e-300)
    normal = offset / distance[:, None]
    # |e| - c from the difference of squares: the digits that are left near contact.
    depth = (distance**2 - play.clearance**2) / (distance + play.clearance)
    if joint.kind == "slot":
        n_x, n_y = dot(normal, line), dot(normal, turn(line))
        growth = np.minimum(4 * n_x**2, 1.0)
        share = 1 + play.stiffening * growth**2 * (3 - 2 * growth)
        # -∂V/∂φ/|w| along the wall, towards the softer face.
        slope = play.stiffening * 48 * growth * (1 - growth) * n_x * n_y
        push = laws.stored(play, np.maximum(depth, 0)) * slope / distance
    middle = centres[1] + normal * (play.radius - play.clearance - 0.5 * np.maximum(depth, 0))[:, None]
    add_contact(joint, joint.name, motion, forces, impacts, energy, found, middle, normal, depth, share, push, centres)
    if play.film:
        add_film(joint, motion, forces, centres, normal, distance, found)
    return found


def add_contact(joint, name, motion, forces, impacts, energy, found, place, normal, depth, share=1.0, push=None, centres=None):
    play, (first, second) = joint.play, joint.bodies
    tangent = turn(normal)
    slip = motion.speed_at(second, place) - motion.speed_at(first, place)
    if centres is None:
        rate = dot(normal, slip)
    else:
        rate = dot(normal, motion.speed_at(second, centres[1]) - motion.speed_at(first, centres[1]))
    speed, begin = impact_speed(play, name, impacts, motion.time)
    closed = depth > 0
    is_floored = begin < 0
    # The mass that a contact meets where it begins: a guide's normal hardly turns between rows, a pin's does.
    needs_mass = play.contact.law in laws.LINEAR[1:]
    has_unknown_damper = needs_mass and joint.kind != "prismatic"
    is_mass_known = needs_mass and not has_unknown_damper
    mass = effective_mass(joint, name, motion, forces, place, normal, impacts) if is_mass_known else 0.0
    size, spring = laws.normal(play, depth, rate, speed, mass, share)
    size = np.where(closed, size, 0.0)
    if is_mass_known and np.any(closed & is_floored):
        # Nothing tells where it began, nor so the mass that it met there.
        unknown = np.where(closed & is_floored, 1.0, 0.0)[:, None] * normal
        forces.unknown(forces.wrench(joint.bodies, place, unknown), ("damper", None))
    sliding = dot(slip, tangent)
    material = sliding
    if play.literal:
        orbit = motion.speed_at(second, centres[1]) - velocity_of(motion, first, joint.points[0])
        distance = np.maximum(np.linalg.norm(centres[1] - centres[0], axis=1), 1e-300)
        sliding = dot(orbit, tangent) * (1 - play.clearance / distance)
    forces.add(forces.wrench(joint.bodies, place, -size[:, None] * normal))
    if push is not None:
        forces.add(forces.wrench(joint.bodies, centres[1], np.where(closed, push, 0.0)[:, None] * tangent))
    entry = Numbers(name=name, closed=closed, normal=size, sliding=sliding, material=material, begin=begin, rate=rate, spring=np.where(closed, spring, 0.0), share=share)
    if has_unknown_damper:
        rubbing = 0.0
        if play.friction and play.friction.name != "lugre":
            rubbing = laws.friction(play.friction, sliding)[:, None] * tangent
        column = np.where(closed, rate, 0.0)[:, None] * (rubbing - normal)
        forces.unknown(forces.wrench(joint.bodies, place, column), ("damper", entry))
    if play.friction:
        if play.friction.name == "lugre":
            column = np.where(closed, size, 0.0)[:, None] * tangent
            forces.unknown(forces.wrench(joint.bodies, place, column), ("rubbing" if has_unknown_damper else "lugre", entry))
        else:
            entry.friction = np.where(closed, laws.friction(play.friction, sliding) * size, 0.0)
            forces.add(forces.wrench(joint.bodies, place, entry.friction[:, None] * tangent))
    energy.stored = energy.stored + np.where(closed, laws.stored(play, depth) * share, 0.0)
    found.contacts.append(entry)


def velocity_of(motion, body, point):
    return motion.speed_at(body, motion.point(body, point))


def effective_mass(joint, name, motion, forces, place, normal, impacts):
    """Mass that the contact meets along its normal where it began: the inverse of the mobility there, of the row nearest."""
    mechanism = motion.mechanism
    wrench = forces.wrench(joint.bodies, place, normal)
    masses = np.array([[b.mass, b.mass, b.inertia] for b in mechanism.bodies[1:]]).ravel()
    ideal = np.stack([u[:, 1:].reshape(len(motion.time), -1) for u in forces.unknowns[: forces.ideal]], axis=2) if forces.ideal else None
    mobility = np.empty(len(motion.time))
    for row in range(len(motion.time)):
        load = wrench[row, 1:].ravel()
        answer = load / masses
        if ideal is not None:
            a = ideal[row]
            answer = answer - (a @ (np.linalg.pinv(a.T @ (a / masses[:, None]), rcond=1e-11) @ (a.T @ answer))) / masses
        mobility[row] = load @ answer
    at_begin = mobility.copy()
    for contact, start, duration, _ in impacts:
        if contact == name:
            within = (motion.time >= start) & (motion.time <= start + duration + ROUND_OFF * motion.time[-1])
            at_begin[within] = between_rows(motion.time, mobility, start)
    return 1 / np.maximum(at_begin, 1e-300)


def between_rows(time, values, at):
    """The value at a time between rows, by the polynomial through the six rows around it."""
    first = int(np.clip(np.searchsorted(time, at) - 3, 0, max(len(time) - 6, 0)))
    t, v = (time[first : first + 6] - at) / (time[1] - time[0]), values[first : first + 6]
    weights = [np.prod([-t[j] / (t[i] - t[j]) for j in range(len(t)) if j != i]) for i in range(len(t))]
    return float(np.dot(weights, v))


def add_film(joint, motion, forces, centres, normal, distance, found):
    play, film, (first, second) = joint.play, joint.play.film, joint.bodies
    c = play.clearance
    spins = [motion.velocity[:, b, 2] for b in joint.bodies]
    e = centres[1] - centres[0]
    orbit = velocity_of(motion, second, joint.points[1]) - velocity_of(motion, first, joint.points[0])
    approach = orbit - 0.5 * (spins[0] + spins[1])[:, None] * turn(e)
    ratio = distance / c
    squeeze, wedge = dot(approach, normal) / c, -2 * dot(approach, turn(normal)) / c
    # A centred pin has no direction; what is thinner than the roughness is not repeated here.
    thick = (distance < c - 1.5 * film.roughness) & (ratio > 1e-6)
    slip = spins[1] - spins[0]
    drag = 2 * np.pi * film.viscosity * play.radius**3 * play.length / (c * np.sqrt(np.maximum(1 - ratio**2, 1e-12))) * slip
    known = laws.film_force(film, play, np.where(thick, ratio, 0.5), squeeze, wedge)
    found.film = Numbers(thick=thick, ratio=ratio, squeeze=squeeze, wedge=wedge, columns=[])
    weight = np.ones(len(ratio)) if known is None else np.where(thick, 0.0, 1.0)
    if known is not None:
        for size, direction, is_tangential in ((known[0], normal, False), (known[1], turn(normal), True)):
            forces.add(film_wrench(joint, forces, centres, distance, np.where(thick, size, 0.0), direction, is_tangential))
    for direction, is_tangential in ((normal, False), (turn(normal), True)):
        found.film.columns.append(forces.unknown(film_wrench(joint, forces, centres, distance, weight, direction, is_tangential), ("film", None)))
    shear = np.where(thick, drag, 0.0)
    forces.add(couples(joint, forces, shear, -shear))
    # Near the wall the drag is led over to that of the thinnest film: not repeated.
    forces.unknown(couples(joint, forces, np.where(thick, 0.0, 1.0), np.where(thick, 0.0, -1.0)), ("film", None))


def film_wrench(joint, forces, centres, distance, size, direction, is_tangential):
    """A force at both centres, and the moments that share its couple between both bodies."""
    first, second = joint.bodies
    wrench = forces.wrench((0, second), centres[1], size[:, None] * direction) + forces.wrench((0, first), centres[0], -size[:, None] * direction)
    if is_tangential:
        half = -0.5 * distance * size
        wrench += couples(joint, forces, half, half)
    return wrench


def couples(joint, forces, on_first, on_second):
    zero = np.zeros((len(on_first), 2))
    return forces.wrench((0, joint.bodies[0]), zero, zero, on_first) + forces.wrench((0, joint.bodies[1]), zero, zero, on_second)


def solve(mechanism, motion, forces, energy, plays, closure, summary):
    rows = len(motion.time)
    masses = np.array([[b.mass, b.mass, b.inertia] for b in mechanism.bodies])
    inertia = masses * motion.acceleration
    forces.size = np.maximum(forces.size, norm(inertia))
    scale = np.array([1.0, 1.0, 1 / LENGTH])
    flat = lambda wrench: (wrench[:, 1:] * scale).reshape(rows, -1)
    matrix = np.stack([flat(u) for u in forces.unknowns], axis=2) if forces.unknowns else np.zeros((rows, 3 * len(mechanism.bodies) - 3, 0))
    # Columns of equal size, so that round-off is told from nothing.
    sizes = np.maximum(np.linalg.norm(matrix, axis=1), 1e-300)
    inverse = np.linalg.pinv(matrix / sizes[:, None, :], rcond=1e-11)
    rubbing = [joint for joint in mechanism.joints if joint.friction and joint.rubbing is None]
    total = forces.total.copy()
    # Friction grows with what a joint carries: repeated until it stays, slowly in a short guide.
    for _ in range(MOST_ITERATIONS if rubbing else 0):
        values = np.einsum("ijk,ik->ij", inverse, flat(inertia - total)) / sizes
        before, total = total, forces.total.copy()
        for joint in rubbing:
            total += (laws.friction(joint.friction, joint.sliding) * carried(joint, values))[:, None, None] * joint.push
        if np.all(np.abs(total - before) <= 1e-13 * np.max(np.abs(total))):
            break
    needed = flat(inertia - total)
    values = np.einsum("ijk,ik->ij", inverse, needed) / sizes
    # Of unknowns that do the same only the sum is known.
    is_known = np.abs(np.einsum("ikj,ijk->ik", inverse, matrix / sizes[:, None, :]) - 1) < 1e-6
    rank = np.round(np.einsum("ikj,ijk->i", inverse, matrix / sizes[:, None, :]))
    rest = needed - np.einsum("ijk,ik->ij", matrix, values)
    reactions = np.max(np.abs(matrix * values[:, None, :]), axis=(1, 2), initial=0.0)
    size = np.maximum(np.maximum(forces.size, reactions), 1e-9)
    relative = np.max(np.abs(rest), axis=1, initial=0.0) / size
    return Numbers(motion=motion, relative=relative, size=size, values=values, total=total, closure=closure, plays=plays,
                   energy=energy, summary=summary, forces=forces, inertia=inertia, is_known=is_known, spare=matrix.shape[1] - rank)


def carried(joint, values):
    """N of an ideal joint: |R| of a pin, the sum of what both ends of a guide carry."""
    first, second = (values[:, k] for k in joint.columns[:2])
    if joint.kind == "revolute":
        return np.hypot(first, second)
    return np.abs(0.5 * first - second / joint.size) + np.abs(0.5 * first + second / joint.size)

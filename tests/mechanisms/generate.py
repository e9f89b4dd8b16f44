"""Random mechanisms as plain numbers, and the model file of each: bodies, joints, contacts, springs, loads, drives.

Bodies are put down at random where they are at time zero; joints are then cut into them, so that every loop closes.
"""

from dataclasses import dataclass, field
from types import SimpleNamespace as Numbers

import numpy as np

import laws

GROUND = 0


@dataclass
class Body:
    name: str
    pose: np.ndarray  # x, y of the frame's origin and its angle at time zero
    mass: float = 0.0
    inertia: float = 0.0
    centre: np.ndarray = field(default_factory=lambda: np.zeros(2))
    points: list = field(default_factory=list)

    def cut(self, world):
        """A point of the body at a place of the world at time zero; gives its name and its coordinates."""
        local = rotation(self.pose[2]).T @ (world - self.pose[:2])
        self.points.append(local)
        return f"{self.name}.p{len(self.points) - 1}", local


@dataclass
class Joint:
    name: str
    kind: str
    bodies: tuple  # bearing or guide or slot or first; journal or slider or pin or second
    names: tuple
    points: tuple
    angles: tuple  # of the line in both bodies; of a rigid joint the angle of the second body in the first
    play: Numbers | None = None
    friction: Numbers | None = None
    size: float = 0.0
    drive: Numbers | None = None
    rates: dict = field(default_factory=dict)  # initial angle, position and their rates


@dataclass
class Mechanism:
    gravity: float
    bodies: list
    joints: list = field(default_factory=list)
    springs: list = field(default_factory=list)
    loads: list = field(default_factory=list)
    looped: set = field(default_factory=set)
    duration: float = 0.1
    family: str = ""


def rotation(angle):
    return np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])


def between(rng, low, high):
    """Evenly in the logarithm."""
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def pick(rng, *choices):
    return choices[rng.integers(len(choices))]


def random_mechanism(rng):
    bodies = [Body("ground", np.zeros(3))]
    mechanism = Mechanism(gravity=float(pick(rng, 0.0, 9.81)), bodies=bodies)
    speed = between(rng, 5, 150)
    mechanism.duration = 0.5 * np.pi / speed
    mechanism.family = pick(rng, "tree", "tree", "loop", "loop", "loop with a branch")
    if mechanism.family == "tree":
        add_tree(rng, mechanism, int(rng.integers(1, 5)), speed)
    else:
        add_loop(rng, mechanism, speed)
        if mechanism.family == "loop with a branch":
            add_tree(rng, mechanism, 1, speed)
    if not any(joint.play for joint in mechanism.joints) and rng.random() < 0.8:
        free = [joint for joint in mechanism.joints if joint.kind != "rigid" and not joint.drive]
        if free:
            give_play(rng, free[rng.integers(len(free))])
    for joint in mechanism.joints:
        if joint.play is None and joint.kind in ("revolute", "prismatic") and rng.random() < 0.25:
            joint.friction = random_friction(rng, of_joint=True)
            joint.size = between(rng, 3e-3, 1e-2) if joint.kind == "revolute" else between(rng, 0.05, 0.2)
    add_elements(rng, mechanism)
    return mechanism


def add_body(rng, mechanism, place):
    body = Body(f"b{len(mechanism.bodies)}", np.array([*(place + rng.normal(0, 0.02, 2)), rng.uniform(-3, 3)]))
    body.mass = between(rng, 0.05, 2)
    body.inertia = body.mass * between(rng, 0.02, 0.08) ** 2
    body.centre = rng.normal(0, 0.03, 2)
    mechanism.bodies.append(body)
    return len(mechanism.bodies) - 1


def add_joint(rng, mechanism, kind, first, second, place, play_share):
    bodies = (first, second) if rng.random() < 0.5 else (second, first)
    pair = [mechanism.bodies[index] for index in bodies]
    line = rng.uniform(-np.pi, np.pi)
    places = [place, place]
    if kind in ("prismatic", "slot"):
        places[0] = place - rng.uniform(-0.03, 0.03) * np.array([np.cos(line), np.sin(line)])
    cuts = [body.cut(world) for body, world in zip(pair, places)]
    angles = [line - body.pose[2] for body in pair]
    if kind == "rigid":
        angles = [pair[1].pose[2] - pair[0].pose[2], 0.0]
    joint = Joint(f"j{len(mechanism.joints)}", kind, bodies, tuple(cut[0] for cut in cuts),
                  tuple(cut[1] for cut in cuts), tuple(angles))
    joint.rates = {"angle": pair[1].pose[2] - pair[0].pose[2],
                   "position": float(np.array([np.cos(line), np.sin(line)]) @ (places[1] - places[0]))}
    if kind != "rigid" and rng.random() < play_share:
        give_play(rng, joint)
    mechanism.joints.append(joint)
    return joint


def add_tree(rng, mechanism, count, speed):
    """Each body hangs on one before it; drives move a joint or leave it its initial rate."""
    for _ in range(count):
        parent = int(rng.integers(len(mechanism.bodies))) if rng.random() < 0.7 else len(mechanism.bodies) - 1
        place = mechanism.bodies[parent].pose[:2] + rng.normal(0, 0.08, 2)
        child = add_body(rng, mechanism, place)
        kind = pick(rng, "revolute", "revolute", "revolute", "prismatic", "prismatic", "slot", "rigid")
        joint = add_joint(rng, mechanism, kind, parent, child, place, 0.55)
        if joint.play is None and kind in ("revolute", "prismatic") and rng.random() < 0.35:
            joint.drive = random_drive(rng, joint, speed)
        else:
            start_freely(rng, joint, speed, child)


def add_loop(rng, mechanism, speed):
    kinds = pick(rng, "RRRR", "RRRR", "RRRP", "RRRP", "RRPR", "RPRR", "PRRR", "RSR", "RSP", "RRRRR")
    count = len(kinds) - 1
    places = [np.zeros(2)] + [rng.normal(0, 0.12, 2) for _ in range(count)]
    crank = between(rng, 0.02, 0.05)
    places[1] = crank * np.array([np.cos(a := rng.uniform(-3, 3)), np.sin(a)])
    members = [GROUND] + [add_body(rng, mechanism, places[k]) for k in range(count)] + [GROUND]
    mechanism.looped = set(members[1:-1])
    names = {"R": "revolute", "P": "prismatic", "S": "slot"}
    ends = [0, len(kinds) - 1] if kinds == "RRRRR" else [0]
    is_driven = rng.random() < 0.75
    for k, letter in enumerate(kinds):
        share = 0.0 if k in ends and is_driven else 0.45
        joint = add_joint(rng, mechanism, names[letter], members[k], members[k + 1], places[k], share)
        if k in ends:
            if is_driven and joint.play is None:
                joint.drive = random_drive(rng, joint, speed if k == 0 else 0.2 * speed, smooth=True)
            else:
                start_freely(rng, joint, speed)


def start_freely(rng, joint, speed, child=None):
    joint.rates["turning_body"] = child if joint.kind == "slot" else None
    keys = {"revolute": ["angle"], "prismatic": ["position"], "slot": ["angle", "position"], "rigid": []}[joint.kind]
    for key in keys:
        rate = rng.normal(0, 0.5 * speed if key == "angle" else 0.02 * speed)
        joint.rates[key + "_rate"] = rate
    joint.rates["is_initial"] = keys


def random_drive(rng, joint, speed, smooth=False):
    scale = 1.0 if joint.kind == "revolute" else 0.03
    start = joint.rates["angle" if joint.kind == "revolute" else "position"]
    kind = pick(rng, "constant", "constant", "harmonic") if smooth else pick(rng, "constant", "harmonic", "polynomial")
    sign = float(pick(rng, -1.0, 1.0))
    if kind == "constant":
        return Numbers(kind=kind, start=start, rate=sign * speed * scale)
    if kind == "harmonic":
        amplitude, frequency, phase = rng.uniform(0.1, 0.6) * scale, speed / (2 * np.pi), rng.uniform(-3, 3)
        return Numbers(kind=kind, mean=start - amplitude * np.sin(phase), amplitude=amplitude, frequency=frequency, phase=phase)
    return Numbers(kind=kind, coefficients=[start, sign * 0.4 * speed * scale, 0.1 * speed**2 * scale * rng.normal()])


def drive_rate(drive, time):
    if drive.kind == "constant":
        return np.full_like(time, drive.rate)
    if drive.kind == "harmonic":
        rate = 2 * np.pi * drive.frequency
        return drive.amplitude * rate * np.cos(rate * time + drive.phase)
    return drive.coefficients[1] + 2 * drive.coefficients[2] * time


def give_play(rng, joint):
    """A contact of the joint's own, with any law that its shape takes."""
    play = Numbers(clearance=between(rng, 5e-5, 8e-4), radius=between(rng, 5e-3, 1.5e-2), length=between(rng, 5e-3, 4e-2))
    play.half_length, play.half_height = rng.uniform(0.02, 0.05), rng.uniform(0.008, 0.02)
    play.corner_radius, play.slot_half_length = between(rng, 1e-3, 8e-3), rng.uniform(0.04, 0.09)
    play.literal = joint.kind == "revolute" and rng.random() < 0.15
    names = list(laws.CHI) + laws.LINEAR + (laws.LINE if joint.kind == "revolute" else [])
    law = names[rng.integers(len(names))]
    contact = Numbers(law=law, restitution=rng.uniform(0.3, 0.98), exponent=1.5, stiffness=None, damping=0.0)
    contact.modulus, contact.poisson = [between(rng, 2e8, 2e11) for _ in range(2)], list(rng.uniform(0.2, 0.4, 2))
    contact.compliance = sum((1 - v * v) / e for e, v in zip(contact.modulus, contact.poisson))
    contact.damping_law = None
    if law in laws.LINEAR:
        contact.exponent, contact.stiffness = 1.0, between(rng, 1e5, 3e7)
        contact.damping = between(rng, 1, 300)
    elif law in laws.LINE:
        default = "zhiying-qishao" if law == "bai-zhao" else "lankarani-nikravesh"
        contact.damping_law = None if rng.random() < 0.5 else list(laws.CHI)[rng.integers(len(laws.CHI))]
        contact.chi = laws.CHI[contact.damping_law or default](contact.restitution)
    else:
        contact.chi = laws.CHI[law](contact.restitution)
        if rng.random() < 0.3:
            contact.exponent = float(pick(rng, 1.5, 1.5, 1.2, 2.0))
            contact.stiffness = between(rng, 1e8, 2e10) * 1e-4 ** (1.5 - contact.exponent)
    contact.floor = between(rng, 1e-4, 1e-2)
    play.friction = random_friction(rng) if rng.random() < 0.7 else None
    play.film = None
    if joint.kind == "revolute" and not play.literal and rng.random() < 0.25:
        play.film = Numbers(law=pick(rng, "ocvirk", "ocvirk-printed", "pinkus-sternlicht", "finite-length", "reynolds"),
                            viscosity=between(rng, 0.005, 0.2), roughness=play.clearance * rng.uniform(0.01, 0.2))
    play.contact = contact
    play.stiffness, play.stiffening = stiffness(joint.kind, play)
    joint.play = play


def stiffness(kind, play):
    """K, and by what share the round ends of a slot are stiffer than its faces."""
    if play.contact.stiffness is not None:
        return play.contact.stiffness, 0.0
    base, c = 4 / (3 * play.contact.compliance), play.clearance
    if kind == "prismatic":
        return base * np.sqrt(play.corner_radius), 0.0
    if kind == "slot":
        return base * np.sqrt(play.radius - c), np.sqrt(play.radius / c) - 1
    return base * np.sqrt(play.radius * (play.radius - c) / c), 0.0


def random_friction(rng, of_joint=False):
    name = pick(rng, "ambrosio", "threlfall", "stribeck", "brown-mcphee", "bengisu-akay", "lugre")
    mu = rng.uniform(0.01, 0.3)
    numbers = {"coefficient": mu}
    static = mu * rng.uniform(1.0, 1.6)
    speed = between(rng, 1e-3, 1e-1)
    further = {
        "ambrosio": {"lower_speed": 0.1 * speed, "upper_speed": speed},
        "threlfall": {"transition_speed": speed},
        "stribeck": {"static_coefficient": static, "stribeck_speed": 3 * speed, "transition_speed": speed, "viscous": rng.uniform(0, 0.02)},
        "brown-mcphee": {"static_coefficient": static, "transition_speed": speed, "viscous": rng.uniform(0, 0.02)},
        "bengisu-akay": {"static_coefficient": static, "transition_speed": speed, "decay": rng.uniform(1, 30)},
        "lugre": {"static_coefficient": static, "stribeck_speed": 3 * speed, "bristle_stiffness": between(rng, 1e3, 5e4),
                  "bristle_damping": rng.uniform(0, 0.3), "viscous": rng.uniform(0, 0.02)},
    }
    return Numbers(name=name, numbers=numbers | further[name])


def add_elements(rng, mechanism):
    count = len(mechanism.bodies)
    for index in range(int(rng.integers(0, 3))):
        first, second = rng.choice(count, 2, replace=False)
        kind = pick(rng, "linear", "linear", "torsional")
        spring = Numbers(name=f"s{index}", kind=kind, bodies=(int(first), int(second)))
        if kind == "linear":
            ends = [mechanism.bodies[b].pose[:2] + rng.normal(0, 0.2, 2) for b in spring.bodies]
            cuts = [mechanism.bodies[b].cut(end) for b, end in zip(spring.bodies, ends)]
            spring.names, spring.points = zip(*cuts)
            spring.free = np.linalg.norm(ends[1] - ends[0]) * rng.uniform(0.5, 1.3)
            spring.stiffness, spring.damping, spring.preload = between(rng, 10, 2e3), between(rng, 0.1, 20), rng.normal(0, 3)
        else:
            angle = mechanism.bodies[second].pose[2] - mechanism.bodies[first].pose[2]
            spring.free = angle + rng.normal(0, 0.5)
            spring.stiffness, spring.damping, spring.preload = between(rng, 0.05, 5), between(rng, 1e-4, 1e-2), rng.normal(0, 0.1)
        mechanism.springs.append(spring)
    for index in range(int(rng.integers(0, 3))):
        body = int(rng.integers(1, count))
        load = Numbers(name=f"l{index}", kind=pick(rng, "force", "torque"), body=body, harmonic=rng.random() < 0.5,
                       follows=rng.random() < 0.5, direction=rng.uniform(-3, 3))
        load.mean, load.amplitude = rng.normal(0, 10, 2) * (1.0 if load.kind == "force" else 0.02)
        load.frequency, load.phase = rng.uniform(0.2, 3) / mechanism.duration, rng.uniform(-3, 3)
        if load.kind == "force":
            load.point_name, load.point = mechanism.bodies[body].cut(mechanism.bodies[body].pose[:2] + rng.normal(0, 0.05, 2))
        mechanism.loads.append(load)


def load_size(load, time):
    if not load.harmonic:
        return np.full_like(time, load.mean)
    return load.mean + load.amplitude * np.sin(2 * np.pi * load.frequency * time + load.phase)

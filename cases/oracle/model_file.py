"""Reads a `model.toml` into plain tables for the reference program.

Deliberately small: it evaluates every value as arithmetic over SI unit factors and checks no dimensions. It shares no
code with the library, so that a slip in either shows as a difference.
"""

import math
import re
import tomllib
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from scipy.interpolate import CubicSpline, PchipInterpolator

# SI factor of each unit symbol used in the cases.
UNITS = {
    "m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6, "kg": 1.0, "g": 1e-3, "s": 1.0, "ms": 1e-3,
    "N": 1.0, "kN": 1e3, "Pa": 1.0, "MPa": 1e6, "GPa": 1e9, "bar": 1e5,
    "rad": 1.0, "deg": math.pi / 180.0, "rpm": math.pi / 30.0,
}  # fmt: skip
TOKEN = re.compile(r"\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+)|([A-Za-z_]\w*)|([-+*/^()]))")

# DRIVE is of a revolute joint, SLIDE of a prismatic one; MESH is a pair of gears.
REVOLUTE, PRISMATIC, RIGID, DRIVE, SLIDE, MESH = 0, 1, 2, 3, 4, 5
GROUND = -1


class Expression:
    """Recursive descent over `+ - * / ^`, parentheses, numbers, units and parameters; `50 mm` multiplies."""

    def __init__(self, text, names):
        self.text, self.names, self.tokens, self.place = text, names, [], 0
        at = 0
        while text[at:].strip():
            match = TOKEN.match(text, at)
            if not match:
                raise ValueError(f"cannot read '{text}' at column {at + 1}")
            self.tokens.append(match.groups())
            at = match.end()

    def peek(self):
        return self.tokens[self.place] if self.place < len(self.tokens) else (None, None, None)

    def take(self, symbols):
        symbol = self.peek()[2]
        if symbol is not None and symbol in symbols:
            self.place += 1
            return symbol
        return None

    def value(self):
        result = self.sum()
        if self.place != len(self.tokens):
            raise ValueError(f"cannot read the end of '{self.text}'")
        return result

    def sum(self):
        result = self.product()
        while symbol := self.take("+-"):
            term = self.product()
            result = result + term if symbol == "+" else result - term
        return result

    def product(self):
        result = self.power()
        while True:
            if symbol := self.take("*/"):
                factor = self.power()
                result = result * factor if symbol == "*" else result / factor
            elif self.peek()[0] or self.peek()[1] or self.peek()[2] == "(":
                result = result * self.power()
            else:
                return result

    def power(self):
        if self.take("-"):
            return -self.power()
        base = self.atom()
        return base ** self.power() if self.take("^") else base

    def atom(self):
        number, name, symbol = self.peek()
        self.place += 1
        if number:
            return float(number)
        if name:
            if name in self.names:
                return self.names[name]
            return UNITS[name]
        if symbol == "(":
            result = self.sum()
            if not self.take(")"):
                raise ValueError(f"missing ')' in '{self.text}'")
            return result
        raise ValueError(f"cannot read '{self.text}'")


@dataclass
class Body:
    name: str
    mass_kg: float
    inertia_kg_m2: float
    centre_of_mass_m: tuple
    points_m: dict


@dataclass
class Constraint:
    """An ideal joint or a drive between body `i` (bearing, guide, first) and body `j` (journal, slider, second).

    `point_*_m` are measured from the centre of mass, in the axes of the body (from the origin for the ground).
    `angle_*_rad` is the angle of a prismatic line in each body; `angle_j_rad` of a rigid joint is the turn of `j`
    from `i`; a drive keeps θ_j - θ_i = `start` + `speed` t (rad, rad/s) or the slide (r_j - r_i)·u = `start` + `speed` t
    (m, m/s), u the direction of the prismatic line.
    """

    name: str
    kind: int
    i: int
    j: int
    point_i_m: tuple
    point_j_m: tuple
    angle_i_rad: float = 0.0
    angle_j_rad: float = 0.0
    start: float = 0.0
    speed: float = 0.0


@dataclass
class Clearance:
    """A revolute joint with play; body `i` has the hole, body `j` the pin."""

    name: str
    i: int
    j: int
    point_i_m: tuple
    point_j_m: tuple
    bearing_radius_m: float
    radial_clearance_m: float
    stiffness_n_m_n: float
    exponent: float
    damping_factor: float
    minimum_impact_speed_m_s: float
    friction_coefficient: float
    lower_speed_m_s: float
    upper_speed_m_s: float
    is_literal: bool
    law: str
    restitution: float


@dataclass
class Load:
    """A force of a given direction in the ground's frame on a point of body `body`, measured from its centre of mass.

    Its size, N, is a cubic in pieces `pieces`: rows of where it begins and the coefficients of the third to the zeroth
    power from there. They are over the time or, with `joint` = (i, j), over θ_j - θ_i; `period` is 0 for a curve that does
    not come again.
    """

    body: int
    point_m: tuple
    direction_rad: float
    joint: tuple | None
    period: float
    pieces: np.ndarray


@dataclass
class Mesh:
    """Two gears `first` and `second` on the carrier `carrier`, seen at the pitch point: the rim of the second gear is ahead of
    that of the first by x = r2 (φ2 - offset) ± r1 φ1 (+ in external mesh), φ counted from the carrier. It has two flanks, each
    with half of the backlash."""

    name: str
    first: int
    second: int
    carrier: int
    first_arm_m: float  # ±r1
    second_arm_m: float  # r2
    offset_m: float  # r2 times the offset
    backlash_m: float
    contact: "Clearance"


@dataclass
class Mechanism:
    name: str
    gravity_m_s2: float
    bodies: list
    constraints: list
    clearances: list
    meshes: list
    guess_rad: dict
    recorded_turns: float
    samples_per_turn: int
    drive_speed_rad_s: float
    loads: list
    document: dict = field(repr=False)


def exact_restitution_factor(restitution):
    """χ that delivers `restitution` = ε: the root of χ(1 + ε) = ln((1 + χ)/(1 - χε)) in (0, 1/ε)."""
    if restitution == 1.0:
        return 0.0

    def difference(chi):
        return chi * (1.0 + restitution) - math.log((1.0 + chi) / (1.0 - chi * restitution))

    # χ = 0 is a root too; the difference is positive just above it and falls to minus infinity at 1/ε.
    low, high = 1e-6, (1.0 - 1e-15) / restitution
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if difference(middle) > 0.0 else (low, middle)
    return 0.5 * (low + high)


def damping_factor(law, restitution):
    """χ(c_e) of the point-contact laws F_N = K δⁿ (1 + χ δ̇/v0)."""
    c = restitution
    return {
        "hertz": lambda: 0.0,
        "hunt-crossley": lambda: 1.5 * (1 - c),
        "herbert-mcwhannell": lambda: 6 * (1 - c) / ((2 * c - 1) ** 2 + 3),
        "lee-wang": lambda: 0.75 * (1 - c),
        "lankarani-nikravesh": lambda: 0.75 * (1 - c * c),
        "gonthier": lambda: (1 - c * c) / c,
        "zhiying-qishao": lambda: 0.75 * (1 - c * c) * math.exp(2 * (1 - c)),
        "flores": lambda: 8 * (1 - c) / (5 * c),
        "hu-guo": lambda: 1.5 * (1 - c) / c,
        "carvalho-martins": lambda: 1.5 * (1 - c) * (11 - c) / (1 + 9 * c),
        "exact-restitution": lambda: exact_restitution_factor(c),
    }[law]()


def read(path):
    """The mechanism described by the file `path`, in SI."""
    document = tomllib.loads(Path(path).read_text())
    names = {}
    for key, text in document.get("parameter", {}).items():
        names[key] = Expression(text, names).value()

    def si(value):
        return float(value) if isinstance(value, (int, float)) else Expression(value, names).value()

    bodies, index = [], {"ground": GROUND}
    for name, table in document["body"].items():
        if name == "ground":
            continue
        index[name] = len(bodies)
        bodies.append(Body(
            name, si(table["mass"]), si(table["inertia"]), tuple(si(v) for v in table["centre_of_mass"]),
            {key: tuple(si(v) for v in pair) for key, pair in table.get("points", {}).items()},
        ))  # fmt: skip
    ground_m = {key: tuple(si(v) for v in pair) for key, pair in document["body"]["ground"]["points"].items()}

    def point(text):
        body_name, point_name = text.split(".")
        body = index[body_name]
        if body == GROUND:
            return body, ground_m[point_name]
        x, y = bodies[body].points_m[point_name]
        cx, cy = bodies[body].centre_of_mass_m
        return body, (x - cx, y - cy)

    def place(entry):
        """A point with the angle of a line through it: `{ point, angle }`, or the point alone."""
        table = {"point": entry} if isinstance(entry, str) else entry
        return *point(table["point"]), si(table.get("angle", "0 rad"))

    constraints, clearances = [], []
    for name, table in document["joint"].items():
        match table["kind"]:
            case "revolute":
                i, point_i = point(table["bearing"])
                j, point_j = point(table["journal"])
                if si(table.get("radial_clearance", 0.0)) == 0.0:
                    constraints.append(Constraint(name, REVOLUTE, i, j, point_i, point_j))
                else:
                    contact = document["contact"][table["contact"]]
                    clearances.append(clearance(name, i, j, point_i, point_j, table, contact, si))
            case "prismatic":
                i, point_i, angle_i = place(table["guide"])
                j, point_j, angle_j = place(table["slider"])
                constraints.append(Constraint(name, PRISMATIC, i, j, point_i, point_j, angle_i, angle_j))
            case "rigid":
                i, point_i = point(table["first"])
                j, point_j = point(table["second"])
                constraints.append(Constraint(name, RIGID, i, j, point_i, point_j, 0.0, si(table["angle"])))
            case kind:
                raise ValueError(f"joint '{name}' has kind '{kind}'")
    meshes = []
    for name, table in document.get("coupling", {}).items():
        meshes.append(mesh(name, table, document, index, si))
    speeds = {}
    for name, table in document["drive"].items():
        joint = next(c for c in constraints if c.name == table["joint"] and c.kind in (REVOLUTE, PRISMATIC))
        turns = joint.kind == REVOLUTE
        speeds[name] = si(table["speed"])
        start = si(table["start_angle" if turns else "start_position"])
        constraints.append(Constraint(
            name, DRIVE if turns else SLIDE, joint.i, joint.j, joint.point_i_m, joint.point_j_m, joint.angle_i_rad,
            joint.angle_j_rad, start, speeds[name],
        ))  # fmt: skip

    angles = {c.name: (c.i, c.j) for c in constraints if c.kind == REVOLUTE}
    loads = [load(name, table, Path(path).parent, si, point, angles) for name, table in document.get("load", {}).items()]
    cycle = document["cycle"]
    guess = {index[name]: si(value) for name, value in document.get("assembly", {}).get("guess", {}).items()}
    return Mechanism(
        document["name"], si(document["gravity"]), bodies, constraints, clearances, meshes, guess,
        float(cycle["recorded_turns"]), int(cycle["samples_per_turn"]), speeds[cycle["drive"]], loads, document,
    )  # fmt: skip


def load(name, table, folder, si, point, angles):
    """The force by a table of points: its curve is scipy's, whose `PchipInterpolator` has the slopes of Fritsch and
    Butland."""
    if table["kind"] != "force" or table["of"] not in ("time", "angle") or table.get("frame", "ground") != "ground":
        raise ValueError(f"load '{name}' is not in this program")
    if "csv" in table:
        lines = [line for line in (folder / table["csv"]).read_text().splitlines() if line and not line.startswith("#")]
        units = [si("1 " + cell.split("[")[1].rstrip("] ")) for cell in lines[0].split(",")]
        points = np.array([[float(cell) for cell in line.split(",")] for line in lines[1:]]) * units
    else:
        points = np.array([[si(value) for value in pair] for pair in table["points"]])
    x, y = points.T
    if "area" in table:
        y = (y - si(table.get("back_pressure", 0.0))) * si(table["area"])
    period = si(table.get("period", 0.0))
    is_spline = table.get("curve", "monotone") == "spline"
    if period == 0.0:
        curve = CubicSpline(x, y, bc_type="natural") if is_spline else PchipInterpolator(x, y)
        level = [[-1e300, 0, 0, 0, y[0]], *np.column_stack([x[:-1], curve.c.T]), [x[-1], 0, 0, 0, y[-1]]]
        pieces = np.array(level)
    else:
        if x[-1] - x[0] > period * (1 - 1e-9):
            x, y = x[:-1], y[:-1]
        count = len(x)
        thrice = np.concatenate([x - period, x, x + period, [x[0] + 2 * period]])
        values = np.concatenate([y, y, y, y[:1]])
        if is_spline:
            curve = CubicSpline(thrice[count : 2 * count + 1], values[count : 2 * count + 1], bc_type="periodic")
            coefficients = curve.c.T
        else:
            coefficients = PchipInterpolator(thrice, values).c.T[count : 2 * count]
        pieces = np.column_stack([x, coefficients])
    body, point_m = point(table["point"])
    joint = angles[table["joint"]] if table["of"] == "angle" else None
    return Load(body, point_m, si(table["direction"]), joint, period, pieces)


def mesh(name, table, document, index, si):
    """A pair of gears on one body, which has the bearing of both."""
    if table["kind"] != "gears":
        raise ValueError(f"coupling '{name}' has kind '{table['kind']}'")
    joints = [document["joint"][table[side]] for side in ("first", "second")]
    first, second = (index[joint["journal"].split(".")[0]] for joint in joints)
    carriers = {index[joint["bearing"].split(".")[0]] for joint in joints}
    if len(carriers) != 1:
        raise ValueError(f"coupling '{name}' has its bearings on two bodies")
    first_radius_m, second_radius_m = (si(radius) for radius in table["radii"])
    sign = 1.0 if table["mesh"] == "external" else -1.0
    contact = document["contact"][table["contact"]]
    law, restitution = contact.get("law", "lankarani-nikravesh"), si(contact["restitution"])
    return Mesh(
        name, first, second, carriers.pop(), sign * first_radius_m, second_radius_m,
        second_radius_m * si(table.get("offset", "0 rad")), si(table["backlash"]),
        Clearance(
            name, -1, -1, (0.0, 0.0), (0.0, 0.0), 0.0, 0.0, si(contact["stiffness"]), si(contact["exponent"]),
            damping_factor(law, restitution), si(contact.get("minimum_impact_speed", 1e-3)), 0.0, 1e-4, 1e-3, False, law,
            restitution,
        ),
    )  # fmt: skip


def clearance(name, i, j, point_i, point_j, table, contact, si):
    """The clearance joint with its contact numbers: K by eq. (9) of the source, or as given."""
    bearing_radius_m = si(table["bearing_radius"])
    gap_m = si(table["radial_clearance"])
    if "stiffness" in contact:
        stiffness, exponent = si(contact["stiffness"]), si(contact["exponent"])
    else:

        def compliance(side):
            def number(key):
                return si(contact.get(f"{side}_{key}", contact.get(key)))

            return (1.0 - number("poisson_ratio") ** 2) / number("youngs_modulus")

        journal_radius_m = bearing_radius_m - gap_m
        radius_m = bearing_radius_m * journal_radius_m / gap_m
        stiffness = 4.0 / (3.0 * (compliance("bearing") + compliance("journal"))) * math.sqrt(radius_m)
        exponent = 1.5
    friction = contact.get("friction", {})
    if friction and friction["law"] != "ambrosio":
        raise ValueError(f"friction law '{friction['law']}' is not in this program")
    law = contact.get("law", "lankarani-nikravesh")
    restitution = si(contact["restitution"])
    return Clearance(
        name, i, j, point_i, point_j, bearing_radius_m, gap_m, stiffness, exponent, damping_factor(law, restitution),
        si(contact.get("minimum_impact_speed", 1e-3)), si(friction.get("coefficient", 0.0)),
        si(friction.get("lower_speed", 1e-4)), si(friction.get("upper_speed", 1e-3)),
        friction.get("sliding_velocity", "material") == "literal", law, restitution,
    )  # fmt: skip

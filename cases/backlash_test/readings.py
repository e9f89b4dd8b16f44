"""Readings of a backlash test, made by moving the closed loop. It shares nothing with the program.

The crank of the four-bar of model.toml is locked. Each of its three pins may lie anywhere on the rim of its play; the loop is closed
as the meeting of two circles. Where a push leaves it is found by statics: forces on coupler and rocker, each through the place where
pin and hole touch, are solved for, and a position holds where every one of them lies within the angle of friction of the normal there.
Without friction one position holds in each direction of the push; with friction a small region does, and all of it is tried.

    python readings.py            the readings of study.toml, with the truth behind them
    python readings.py --write    repetitions.csv: 100 seeds, with the reference set of each by brute force

Needs numpy.
"""

import sys
from pathlib import Path

import numpy as np

GROUND_PIVOT = np.array([0.200, -0.020])
TOOL = np.array([0.095, 0.070])
EAR = np.array([0.060, 0.025])
LENGTHS = {"crank": 0.060, "coupler": 0.180, "rocker": 0.130}
DEVIATIONS = {"crank": 0.02e-3, "coupler": 0.03e-3, "rocker": 0.03e-3}  # standard deviations of study.toml
RADII = np.array([0.009, 0.008, 0.010])  # holes of crank_pin, coupler_pin, rocker_pivot
# h = (1 - nu^2)/E of bronze and steel; Hertz for a cylinder in a hole as the paper of the contact law has it.
COMPLIANCE = (1 - 0.34**2) / 110e9 + (1 - 0.3**2) / 207e9

# A test: name, crank angle (deg), what is pushed, direction (deg) or None for a moment, size (N or N m), what is read.
TESTS = [
    ("rocker, turned", 60.0, "rocker", None, 1.5, "angle"),
    ("tool, sideways", 60.0, "tool", 0.0, 15.0, "x"),
    ("tool, up and down", 150.0, "tool", 90.0, 15.0, "y"),
    ("ear, up and down", 60.0, "ear", 90.0, 15.0, "y"),
]
STEPS = 21  # places of each pin that are tried
FRICTION = 0.12


def unit(angle):
    return np.stack([np.cos(angle), np.sin(angle)], axis=-1)


def cross(a, b):
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def closed(angle_deg, offsets, lengths):
    """Poses for offsets (..., 3, 2): journal minus hole of each pin. Angles of coupler and rocker, and the points that they carry."""
    pin = lengths["crank"] * unit(np.radians(angle_deg))
    tail = pin + offsets[..., 0, :]
    pivot = GROUND_PIVOT - offsets[..., 2, :]  # the hole is in the rocker
    # tail + l u = head, pivot + b v = tip, tip = head + offset.
    base = pivot - offsets[..., 1, :]
    between = base - tail
    distance = np.linalg.norm(between, axis=-1)
    l, b = lengths["coupler"], lengths["rocker"]
    corner = np.arccos((l * l + distance**2 - b * b) / (2 * l * distance))
    coupler = np.arctan2(between[..., 1], between[..., 0]) + corner
    head = tail + l * unit(coupler)
    along = head - base
    rocker = np.arctan2(along[..., 1], along[..., 0])
    turned = lambda point, phi: np.stack(
        [point[0] * np.cos(phi) - point[1] * np.sin(phi), point[0] * np.sin(phi) + point[1] * np.cos(phi)], axis=-1
    )
    return {
        "pin": np.broadcast_to(pin, tail.shape),
        "tail": tail,
        "head": head,
        "pivot": pivot,
        "coupler": coupler,
        "rocker": rocker,
        "tool": tail + turned(TOOL, coupler),
        "ear": pivot + turned(EAR, rocker),
    }


def read(pose, test):
    _, _, pushed, _, _, what = test
    if what == "angle":
        return pose["rocker"]
    return pose[pushed][..., {"x": 0, "y": 1}[what]]


def forces(pose, normals, test, sign):
    """Forces of crank pin on coupler, rocker on coupler and ground pin on rocker, by the equilibrium of coupler and rocker."""
    _, _, pushed, direction, size, _ = test
    shape = pose["tail"].shape[:-1]
    matrix = np.zeros(shape + (6, 6))
    right = np.zeros(shape + (6,))
    touch = [
        pose["pin"] + RADII[0] * normals[..., 0, :],
        pose["head"] + RADII[1] * normals[..., 1, :],
        pose["pivot"] + RADII[2] * normals[..., 2, :],
    ]
    # Unknown: a on the coupler at the crank pin, b on the coupler at its head, d on the rocker at its pivot.
    for axis in (0, 1):
        matrix[..., axis, axis] = 1
        matrix[..., axis, 2 + axis] = 1
        matrix[..., 3 + axis, 2 + axis] = -1
        matrix[..., 3 + axis, 4 + axis] = 1
    for row, column, place, factor in ((2, 0, 0, 1), (2, 2, 1, 1), (5, 2, 1, -1), (5, 4, 2, 1)):
        matrix[..., row, column] = -factor * touch[place][..., 1]
        matrix[..., row, column + 1] = factor * touch[place][..., 0]
    if direction is None:
        right[..., 5] = -sign * size
    else:
        force = sign * size * unit(np.radians(direction))
        first = 0 if pushed == "tool" else 3
        right[..., first : first + 2] = -force
        right[..., first + 2] = -cross(pose[pushed], force)
    solved = np.linalg.solve(matrix, right[..., None])[..., 0]
    # What the journal feels is opposite to what presses the hole along its normal: journals are coupler, rocker and ground pin.
    return np.stack([-solved[..., 0:2], solved[..., 2:4], solved[..., 4:6]], axis=-2)


def holds(angles, test, sign, radii_m, friction, lengths):
    """Angles (..., 3) of the pins on their rims: travel, and the largest angle of a force from its normal."""
    normals = unit(angles)
    pose = closed(test[1], radii_m[:, None] * normals, lengths)
    pressing = forces(pose, normals, test, sign)
    off = np.arctan2(cross(normals, pressing), (normals * pressing).sum(axis=-1))
    return read(pose, test), off


def frictionless(test, sign, radii_m, lengths):
    """The one position that holds without friction: each normal along its force. A fixed point that contracts by play over length."""
    angles = np.zeros(3)
    for _ in range(200):
        _, off = holds(angles, test, sign, radii_m, 0.0, lengths)
        # Half steps: the force turns with its normal by the arm of the contact.
        angles = angles + 0.9 * off
        if np.abs(off).max() < 1e-13:
            return angles
    raise SystemExit("no position holds")


def loads(test, sign, radii_m, lengths):
    angles = frictionless(test, sign, radii_m, lengths)
    normals = unit(angles)
    pose = closed(test[1], radii_m[:, None] * normals, lengths)
    return np.linalg.norm(forces(pose, normals, test, sign), axis=-1)


def with_yield(test, clearances_m, lengths):
    """Radii of the rims: clearance and how far the contacts give way, K d^1.5 = N."""
    journals = RADII - clearances_m
    stiffness = 4 / (3 * COMPLIANCE) * np.sqrt(RADII * journals / clearances_m)
    return clearances_m + (loads(test, 1, clearances_m, lengths) / stiffness) ** (2 / 3)


def region(test, sign, radii_m, friction, lengths):
    """Readings of all positions that hold, on a grid about the frictionless one."""
    centre = frictionless(test, sign, radii_m, lengths)
    reach = np.arctan(friction) * 1.5 + 0.01
    found = on_grid(test, sign, radii_m, friction, lengths, centre, reach)[0]
    at_centre, _ = holds(centre, test, sign, radii_m, friction, lengths)
    return np.append(found, at_centre)


def on_grid(test, sign, radii_m, friction, lengths, centre, reach):
    """Readings and angles of the positions on a grid that hold."""
    steps = np.linspace(-reach, reach, STEPS)
    grid = np.stack(np.meshgrid(steps, steps, steps, indexing="ij"), axis=-1).reshape(-1, 3) + centre
    travel, off = holds(grid, test, sign, radii_m, friction, lengths)
    kept = np.abs(off).max(axis=-1) <= np.arctan(friction)
    return travel[kept], grid[kept]


def extreme(test, sign, radii_m, friction, lengths, wanted):
    """The least (wanted -1) or largest (1) reading of all positions that hold: the grid closes in on the best place."""
    centre = frictionless(test, sign, radii_m, lengths)
    best, _ = holds(centre, test, sign, radii_m, friction, lengths)
    reach = np.arctan(friction) * 1.5 + 0.01
    for _ in range(5):
        travel, angles = on_grid(test, sign, radii_m, friction, lengths, centre, reach)
        if len(travel):
            place = np.argmax(wanted * travel)
            if wanted * (travel[place] - best) > 0:
                best, centre = travel[place], angles[place]
        reach *= 0.3
    return best


def travels(test, clearances_m, friction, lengths):
    """Least and largest dead travel over everything that friction allows."""
    radii_m = with_yield(test, clearances_m, lengths)
    ends = {
        (sign, wanted): extreme(test, sign, radii_m, friction, lengths, wanted) for sign in (1, -1) for wanted in (1, -1)
    }
    return ends[1, -1] - ends[-1, 1], ends[1, 1] - ends[-1, -1]


def stopped(test, clearances_m, friction, lengths, random):
    """A dead travel as it may come out: a stop in each direction, anywhere that holds."""
    radii_m = with_yield(test, clearances_m, lengths)
    ends = []
    for sign in (1, -1):
        ends.append(random.choice(region(test, sign, radii_m, friction, lengths)))
    return ends[0] - ends[1]


def scale(test):
    """Errors of a gauge in metres, and of an inclinometer in radians that is as good at 0.1 m."""
    return 10.0 if test[5] == "angle" else 1.0


COMMON = 0.003e-3  # largest error of calibration
SCATTER = 0.001e-3  # standard deviation of one reading
REPEATS = 3
BOX = np.array([[0.01e-3, 0.30e-3]] * 3)


def drawn_lengths(random):
    return {name: LENGTHS[name] + DEVIATIONS[name] * random.standard_normal() for name in LENGTHS}


def measured(clearances_m, random, lengths=None):
    """Mean of the repeats of every test: lengths of the specimen, a common error of each instrument, friction that nobody knows."""
    lengths = lengths or drawn_lengths(random)
    friction = random.uniform(0.0, FRICTION)
    common = {what: random.uniform(-COMMON, COMMON) for what in ("angle", "tool x", "tool y", "ear y")}
    means = []
    for test in TESTS:
        key = "angle" if test[5] == "angle" else f"{test[2]} {test[5]}"
        travel = stopped(test, clearances_m, friction, lengths, random)
        errors = common[key] + SCATTER * random.standard_normal(REPEATS)
        means.append(travel + scale(test) * errors)
    return means


# ---- the reference set, by brute force ----

NODES = np.array([0.01e-3, 0.155e-3, 0.30e-3])
FINE = 81
CHOSEN = [0, 1, 3]  # three readings that tell the three pins apart: the grid follows them
LARGEST_RESIDUAL = 1.5e-7  # m, of the surfaces between the nodes: three hundredths of the errors


def terms(points):
    """1, c_k, c_k c_l of points in units of 0.1 mm."""
    x, y, z = (points / 1e-4).T
    return np.stack([np.ones_like(x), x, y, z, x * x, y * y, z * z, x * y, y * z, z * x], axis=1)


LENGTH_FACTOR = 3.1440  # normal quantile of 1 - 0.005/3/2: half of what may go wrong, shared by three lengths


def by_lengths(test, clearances_m):
    """Least and largest ratio of the frictionless travel to the nominal one, over the corners of the intervals of the lengths."""
    def travel(lengths):
        radii_m = with_yield(test, clearances_m, lengths)
        ends = []
        for sign in (1, -1):
            angles = frictionless(test, sign, radii_m, lengths)
            ends.append(holds(angles, test, sign, radii_m, 0.0, lengths)[0])
        return ends[0] - ends[1]

    corners = []
    for signs in np.ndindex(2, 2, 2):
        moved = {
            name: LENGTHS[name] + LENGTH_FACTOR * DEVIATIONS[name] * (2 * sign - 1)
            for name, sign in zip(LENGTHS, signs, strict=True)
        }
        corners.append(travel(moved))
    nominal = travel(LENGTHS)
    return min(corners) / nominal, max(corners) / nominal


def surfaces():
    """Least and largest travels of every test, over friction and lengths, as quadratic surfaces through 27 sets of clearances: they are
    all but planes."""
    points = np.array([NODES[list(place)] for place in np.ndindex(3, 3, 3)])
    columns = []
    for test in TESTS:
        ratios = by_lengths(test, NODES[[1, 1, 1]])
        ends = np.array([travels(test, point, FRICTION, LENGTHS) for point in points]) * ratios
        columns += [ends[:, 0], ends[:, 1]]
    values = np.stack(columns, axis=1)
    found, *_ = np.linalg.lstsq(terms(points), values, rcond=None)
    residual = np.abs(terms(points) @ found - values).max(axis=0) / np.repeat([scale(test) for test in TESTS], 2)
    if residual.max() > LARGEST_RESIDUAL:
        raise SystemExit(f"the surfaces are off by {residual.max():.1e} m")
    return found


def reference(means, halves, surface):
    """Ends of each clearance and of their sum over all grid points that are consistent.

    The set is thin: the grid lies along three readings instead of the clearances, and closes in on what is consistent.
    """
    slopes = 0.5 * (surface[1:4, 0::2] + surface[1:4, 1::2]).T[CHOSEN] / 1e-4
    offsets = 0.5 * (surface[0, 0::2] + surface[0, 1::2])[CHOSEN]
    backwards = np.linalg.inv(slopes)
    middle = np.array(means)[CHOSEN]
    reach = np.array(halves)[CHOSEN] * 1.5 + 0.02 * middle
    ranges = np.stack([middle - reach, middle + reach], axis=1)
    for _ in range(3):
        axes = [np.linspace(low, high, FINE) for low, high in ranges]
        along = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
        points = (along - offsets) @ backwards.T
        values = terms(points) @ surface
        kept = ((points >= BOX[:, 0]) & (points <= BOX[:, 1])).all(axis=1)
        for number in range(4):
            low, high = values[:, 2 * number], values[:, 2 * number + 1]
            kept &= (low <= means[number] + halves[number]) & (high >= means[number] - halves[number])
        if not kept.any():
            return None
        inside, step = along[kept], (ranges[:, 1] - ranges[:, 0]) / (FINE - 1)
        ranges = np.stack([inside.min(axis=0) - step, inside.max(axis=0) + step], axis=1)
        found = points[kept]
    ends = np.stack([found.min(axis=0), found.max(axis=0)], axis=1)
    return ends, [found.sum(axis=1).min(), found.sum(axis=1).max()]


def main():
    if "--write" not in sys.argv:
        truth = np.array([0.062e-3, 0.118e-3, 0.041e-3])
        random = np.random.default_rng(2026)
        print("truth", truth)
        for test, values in zip(TESTS, measured(truth, random), strict=True):
            shown = [f"{np.degrees(v):.4f} deg" if test[5] == "angle" else f"{v * 1e3:.4f} mm" for v in values]
            print(test[0], shown, "least and largest without errors", travels(test, truth, FRICTION, LENGTHS))
        return
    # 99 % together: half of what may go wrong for four readings, as the program shares it; normal quantile of 1 - 0.005/4/2.
    factor = 3.2272
    halves = [scale(test) * (COMMON + factor * SCATTER / np.sqrt(REPEATS)) for test in TESTS]
    surface = surfaces()
    lines = ["seed," + ",".join(f"clearance_{k}_m" for k in (1, 2, 3)) + "," + ",".join(f"reading_{k}_si" for k in (1, 2, 3, 4))
             + "," + ",".join(f"reference_{k}_{end}_m" for k in ("1", "2", "3", "sum") for end in ("lower", "upper"))]
    for seed in range(100):
        random = np.random.default_rng(1000 + seed)
        truth = random.uniform(0.02e-3, 0.25e-3, 3)
        means = [values.mean() for values in measured(truth, random)]
        found = reference(means, halves, surface)
        if found is None:
            raise SystemExit(f"seed {seed}: the reference set is empty")
        ends = np.append(found[0].ravel(), found[1])
        lines.append(",".join([str(seed)] + [f"{value:.9e}" for value in [*truth, *means, *ends]]))
    Path(__file__).with_name("repetitions.csv").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()

"""Equations of motion in maximal coordinates: x, y, θ of every body at its centre of mass, Lagrange multipliers for
the ideal joints and drives.

    [ M  Jᵀ ] [ a ]   [ f ]
    [ J  0  ] [ λ ] = [ γ ],     C(q, t) = 0,  J = ∂C/∂q,  γ = -(J̇ v + C_tt)

Force of a constraint on the bodies: -Jᵀ λ. State vector y = (q, v, w): q and v of length 3 nb, w the integrals of
contact loss, friction loss and work of the drives and loads, J.

`system` is the tuple made by `tables`; `mode` has a row per clearance joint:
[in contact 0/1, cut 0/1, friction zone -2..2], `v0_m_s` its impact speed.
"""

import numpy as np

from compiled import njit
from model_file import DRIVE, GROUND, MESH, PRISMATIC, REVOLUTE, RIGID, SLIDE, Constraint, Mechanism

ROWS = {REVOLUTE: 2, PRISMATIC: 2, RIGID: 3, DRIVE: 1, SLIDE: 1, MESH: 1}
CONTACT, CUT, ZONE = 0, 1, 2
INTEGRALS = 3


def tables(mechanism):
    """Flat arrays of a mechanism: (masses, gravity, constraint integers, constraint numbers, joint integers and
    numbers of the clearance joints, rims of the gears, integers, numbers and pieces of the loads). The contacts of the gears
    stand behind the clearance joints; a row of rims is [first, second, carrier, ±r1, r2, offset, half of the backlash, -1 for the
    second gear behind, 1 for ahead], side 0 for a clearance joint."""
    masses = np.array([[b.mass_kg, b.inertia_kg_m2] for b in mechanism.bodies])
    integers, numbers, row = [], [], 0
    for c in mechanism.constraints:
        integers.append([c.kind, c.i, c.j, row])
        numbers.append([*c.point_i_m, *c.point_j_m, c.angle_i_rad, c.angle_j_rad, c.start, c.speed])
        row += ROWS[c.kind]
    pair = [[c.i, c.j, int(c.is_literal)] for c in mechanism.clearances]
    contacts = list(mechanism.clearances)
    rims = [[-1.0, -1.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0] for _ in contacts]
    # Two contacts for each pair of gears: the second gear behind the first, then ahead.
    for m in mechanism.meshes:
        for side in (-1.0, 1.0):
            pair.append([GROUND, GROUND, 0])
            contacts.append(m.contact)
            rims.append([
                float(m.first), float(m.second), float(m.carrier), m.first_arm_m, m.second_arm_m, m.offset_m,
                0.5 * m.backlash_m, side,
            ])  # fmt: skip
    joint = [
        [*c.point_i_m, *c.point_j_m, c.bearing_radius_m, c.radial_clearance_m, c.stiffness_n_m_n, c.exponent,
         c.damping_factor, c.minimum_impact_speed_m_s, c.friction_coefficient, c.lower_speed_m_s, c.upper_speed_m_s]
        for c in contacts
    ]  # fmt: skip
    return (
        masses, mechanism.gravity_m_s2, np.array(integers, dtype=np.int64).reshape(-1, 4),
        np.array(numbers).reshape(-1, 8), row,
        np.array(pair, dtype=np.int64).reshape(-1, 3), np.array(joint).reshape(-1, 13),
        np.array(rims).reshape(-1, 8), *load_tables(mechanism.loads),
    )  # fmt: skip


def load_tables(loads):
    """Integers (body, is over an angle, its bodies, first piece, pieces), numbers (point, direction, period) and pieces."""
    integers, numbers, pieces, first = [], [], [np.zeros((0, 5))], 0
    for load in loads:
        i, j = load.joint or (-1, -1)
        integers.append([load.body, int(load.joint is not None), i, j, first, len(load.pieces)])
        numbers.append([*load.point_m, np.cos(load.direction_rad), np.sin(load.direction_rad), load.period])
        pieces.append(load.pieces)
        first += len(load.pieces)
    return np.array(integers, dtype=np.int64).reshape(-1, 6), np.array(numbers).reshape(-1, 5), np.concatenate(pieces)


@njit()
def load_size(argument, pieces, period):
    """The curve of a load at `argument`."""
    start = pieces[0, 0]
    if period > 0.0:
        argument -= np.floor((argument - start) / period) * period
    piece = pieces[max(np.searchsorted(pieces[:, 0], argument, side="right") - 1, 0)]
    u = argument - piece[0]
    return ((piece[1] * u + piece[2]) * u + piece[3]) * u + piece[4]


@njit()
def arm(q, body, x, y):
    """Vector from the centre of mass to the point, in ground axes (for the ground: the point itself)."""
    if body < 0:
        return x, y
    cosine, sine = np.cos(q[3 * body + 2]), np.sin(q[3 * body + 2])
    return cosine * x - sine * y, sine * x + cosine * y


@njit()
def place(q, body, ax, ay):
    if body < 0:
        return ax, ay
    return q[3 * body] + ax, q[3 * body + 1] + ay


@njit()
def velocity(v, body, ax, ay):
    if body < 0:
        return 0.0, 0.0
    return v[3 * body] - v[3 * body + 2] * ay, v[3 * body + 1] + v[3 * body + 2] * ax


@njit()
def turn(q, body):
    return 0.0 if body < 0 else q[3 * body + 2]


@njit()
def rim(angles, first, second, carrier, first_arm, second_arm):
    """r2 φ2 ± r1 φ1 of two gears, φ from the carrier; of the angles, or of the angular velocities."""
    base = turn(angles, carrier)
    return first_arm * (turn(angles, first) - base) + second_arm * (turn(angles, second) - base)


@njit()
def put(jacobian, row, body, fx, fy, moment):
    if body >= 0:
        jacobian[row, 3 * body] += fx
        jacobian[row, 3 * body + 1] += fy
        jacobian[row, 3 * body + 2] += moment


@njit()
def constraint_rows(time_s, q, v, system):
    """C, J, C_t and γ of all ideal joints and drives."""
    integers, numbers, rows = system[2], system[3], system[4]
    c = np.zeros(rows)
    c_t = np.zeros(rows)
    gamma = np.zeros(rows)
    jacobian = np.zeros((rows, q.size))
    for k in range(integers.shape[0]):
        kind, i, j, row = integers[k]
        number = numbers[k]
        if kind == DRIVE:
            c[row] = turn(q, j) - turn(q, i) - number[6] - number[7] * time_s
            c_t[row] = -number[7]
            put(jacobian, row, j, 0.0, 0.0, 1.0)
            put(jacobian, row, i, 0.0, 0.0, -1.0)
            continue
        if kind == MESH:
            carrier = int(number[3])
            c[row] = rim(q, i, j, carrier, number[0], number[1]) - number[2]
            put(jacobian, row, i, 0.0, 0.0, number[0])
            put(jacobian, row, j, 0.0, 0.0, number[1])
            put(jacobian, row, carrier, 0.0, 0.0, -number[0] - number[1])
            continue
        ix, iy = arm(q, i, number[0], number[1])
        jx, jy = arm(q, j, number[2], number[3])
        px, py = place(q, i, ix, iy)
        rx, ry = place(q, j, jx, jy)
        dx, dy = rx - px, ry - py
        w_i, w_j = turn(v, i), turn(v, j)
        # Difference of the centripetal accelerations of the two points.
        nx = -w_j * w_j * jx + (w_i * w_i * ix if i >= 0 else 0.0)
        ny = -w_j * w_j * jy + (w_i * w_i * iy if i >= 0 else 0.0)
        if kind == PRISMATIC or kind == SLIDE:
            line = turn(q, i) + number[4]
            ux, uy = np.cos(line), np.sin(line)
            vix, viy = velocity(v, i, ix, iy)
            vjx, vjy = velocity(v, j, jx, jy)
            along = ux * dx + uy * dy
            across = -uy * dx + ux * dy
            if kind == SLIDE:
                c[row] = along - number[6] - number[7] * time_s
                c_t[row] = -number[7]
                put(jacobian, row, j, ux, uy, ux * -jy + uy * jx)
                put(jacobian, row, i, -ux, -uy, -ux * -iy - uy * ix + across)
                gamma[row] = -(
                    ux * nx + uy * ny + 2.0 * w_i * (-uy * (vjx - vix) + ux * (vjy - viy)) - w_i * w_i * along
                )
                continue
            c[row] = across
            put(jacobian, row, j, -uy, ux, -uy * -jy + ux * jx)
            put(jacobian, row, i, uy, -ux, uy * -iy - ux * ix - along)
            gamma[row] = -(
                -uy * nx + ux * ny - 2.0 * w_i * (ux * (vjx - vix) + uy * (vjy - viy)) - w_i * w_i * c[row]
            )
            c[row + 1] = turn(q, j) + number[5] - line
            put(jacobian, row + 1, j, 0.0, 0.0, 1.0)
            put(jacobian, row + 1, i, 0.0, 0.0, -1.0)
            continue
        c[row], c[row + 1] = dx, dy
        put(jacobian, row, j, 1.0, 0.0, -jy)
        put(jacobian, row + 1, j, 0.0, 1.0, jx)
        put(jacobian, row, i, -1.0, 0.0, iy)
        put(jacobian, row + 1, i, 0.0, -1.0, -ix)
        gamma[row], gamma[row + 1] = -nx, -ny
        if kind == RIGID:
            c[row + 2] = turn(q, j) - turn(q, i) - number[5]
            put(jacobian, row + 2, j, 0.0, 0.0, 1.0)
            put(jacobian, row + 2, i, 0.0, 0.0, -1.0)
    return c, jacobian, c_t, gamma


@njit()
def gap(q, v, system, k):
    """Penetration δ, δ̇, sliding velocity by the reading of the joint, material sliding velocity, n, common contact
    point. Bearing i, journal j; both bodies are touched in one point with arms R_j - δ/2 and R_i + δ/2."""
    i, j, literal = system[5][k]
    number = system[6][k]
    teeth = system[7][k]
    if teeth[7] != 0.0:
        first, second, carrier = int(teeth[0]), int(teeth[1]), int(teeth[2])
        ahead = rim(q, first, second, carrier, teeth[3], teeth[4]) - teeth[5]
        ahead_rate = rim(v, first, second, carrier, teeth[3], teeth[4])
        return teeth[7] * ahead - teeth[6], teeth[7] * ahead_rate, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    ix, iy = arm(q, i, number[0], number[1])
    jx, jy = arm(q, j, number[2], number[3])
    px, py = place(q, i, ix, iy)
    rx, ry = place(q, j, jx, jy)
    ex, ey = rx - px, ry - py
    vix, viy = velocity(v, i, ix, iy)
    vjx, vjy = velocity(v, j, jx, jy)
    sx, sy = vjx - vix, vjy - viy
    eccentricity = np.sqrt(ex * ex + ey * ey)
    clearance = number[5]
    delta = eccentricity - clearance
    if eccentricity == 0.0:
        return delta, 0.0, 0.0, 0.0, 1.0, 0.0, rx, ry
    nx, ny = ex / eccentricity, ey / eccentricity
    rate = sx * nx + sy * ny
    swirl = -sx * ny + sy * nx
    arm_j = number[4] - clearance - 0.5 * delta
    arm_i = number[4] + 0.5 * delta
    material = swirl + arm_j * turn(v, j) - arm_i * turn(v, i)
    sliding = swirl * (1.0 - clearance / eccentricity) if literal else material
    return delta, rate, sliding, material, nx, ny, rx + arm_j * nx, ry + arm_j * ny


@njit()
def friction_share(sliding, zone, lower, upper):
    """μ(|v|) sign(v)/μ by Ambrósio, smooth inside each zone: ±2 full, ±1 ramp, 0 none."""
    if zone == 0:
        return 0.0
    sign = 1.0 if zone > 0 else -1.0
    if zone == 2 or zone == -2:
        return sign
    return sign * (sign * sliding - lower) / (upper - lower)


@njit()
def contact_force(delta, rate, sliding, number, mode, v0):
    """F_N, its elastic part, and F_T."""
    if mode[CONTACT] == 0 or delta <= 0.0:
        return 0.0, 0.0, 0.0
    elastic = number[6] * delta ** number[7]
    if mode[CUT] == 1:
        return 0.0, elastic, 0.0
    normal = elastic * (1.0 + number[8] * rate / v0)
    tangential = -number[10] * friction_share(sliding, mode[ZONE], number[11], number[12]) * normal
    return normal, elastic, tangential


@njit()
def push(force, q, body, x, y, fx, fy):
    if body >= 0:
        force[3 * body] += fx
        force[3 * body + 1] += fy
        force[3 * body + 2] += (x - q[3 * body]) * fy - (y - q[3 * body + 1]) * fx


@njit()
def derivative(time_s, y, system, mode, v0_m_s):
    """ẏ of the state y, and the multipliers."""
    masses, gravity = system[0], system[1]
    size = 3 * masses.shape[0]
    q, v = y[:size], y[size : 2 * size]
    rows = system[4]
    result = np.zeros_like(y)
    force = np.zeros(size)
    for b in range(masses.shape[0]):
        force[3 * b + 1] = -masses[b, 0] * gravity
    for k in range(system[5].shape[0]):
        if mode[k, CONTACT] == 0:
            continue
        i, j, _ = system[5][k]
        delta, rate, sliding, material, nx, ny, x, y_point = gap(q, v, system, k)
        normal, elastic, tangential = contact_force(delta, rate, sliding, system[6][k], mode[k], v0_m_s[k])
        teeth = system[7][k]
        if teeth[7] != 0.0:
            # Virtual work: -N δ(rim), a torque on each of the three bodies.
            pressed = -normal * teeth[7]
            first, second, carrier = int(teeth[0]), int(teeth[1]), int(teeth[2])
            for body, lever in ((first, teeth[3]), (second, teeth[4]), (carrier, -teeth[3] - teeth[4])):
                if body >= 0:
                    force[3 * body + 2] += pressed * lever
            result[2 * size] += (normal - elastic) * rate
            continue
        fx = -normal * nx - tangential * ny
        fy = -normal * ny + tangential * nx
        push(force, q, j, x, y_point, fx, fy)
        push(force, q, i, x, y_point, -fx, -fy)
        result[2 * size] += (normal - elastic) * rate
        result[2 * size + 1] -= tangential * material
    for k in range(system[8].shape[0]):
        body, is_angle, i, j, first, count = system[8][k]
        number = system[9][k]
        argument = turn(q, j) - turn(q, i) if is_angle == 1 else time_s
        size_n = load_size(argument, system[10][first : first + count], number[4])
        ax, ay = arm(q, body, number[0], number[1])
        x, y_point = place(q, body, ax, ay)
        vx, vy = velocity(v, body, ax, ay)
        push(force, q, body, x, y_point, size_n * number[2], size_n * number[3])
        result[2 * size + 2] += size_n * (number[2] * vx + number[3] * vy)
    _, jacobian, _, gamma = constraint_rows(time_s, q, v, system)
    matrix = np.zeros((size + rows, size + rows))
    right = np.zeros(size + rows)
    for b in range(masses.shape[0]):
        matrix[3 * b, 3 * b] = masses[b, 0]
        matrix[3 * b + 1, 3 * b + 1] = masses[b, 0]
        matrix[3 * b + 2, 3 * b + 2] = masses[b, 1]
    matrix[size:, :size] = jacobian
    matrix[:size, size:] = jacobian.T
    right[:size] = force
    right[size:] = gamma
    solution = np.linalg.solve(matrix, right)
    result[:size] = v
    result[size : 2 * size] = solution[:size]
    for k in range(system[2].shape[0]):
        if system[2][k, 0] == DRIVE or system[2][k, 0] == SLIDE:
            result[2 * size + 2] -= solution[size + system[2][k, 3]] * system[3][k, 7]
    return result


@njit()
def project(time_s, y, system):
    """y moved onto C = 0 and J v + C_t = 0 by the smallest correction in the mass norm; the largest position and
    velocity corrections."""
    masses, rows = system[0], system[4]
    size = 3 * masses.shape[0]
    result = y.copy()
    inverse = np.zeros(size)
    for b in range(masses.shape[0]):
        inverse[3 * b] = inverse[3 * b + 1] = 1.0 / masses[b, 0]
        inverse[3 * b + 2] = 1.0 / masses[b, 1]
    moved, kicked = 0.0, 0.0
    if rows == 0:
        return result, moved, kicked
    c, jacobian, c_t, _ = constraint_rows(time_s, result[:size], result[size : 2 * size], system)
    weighted = jacobian * inverse
    step = weighted.T @ np.linalg.solve(weighted @ jacobian.T, c)
    result[:size] -= step
    moved = np.max(np.abs(step))
    c, jacobian, c_t, _ = constraint_rows(time_s, result[:size], result[size : 2 * size], system)
    weighted = jacobian * inverse
    step = weighted.T @ np.linalg.solve(weighted @ jacobian.T, jacobian @ result[size : 2 * size] + c_t)
    result[size : 2 * size] -= step
    kicked = np.max(np.abs(step))
    return result, moved, kicked


@njit()
def energy(y, system):
    """Kinetic and potential energy of the bodies, and elastic energy in the contacts, J."""
    masses, gravity = system[0], system[1]
    size = 3 * masses.shape[0]
    kinetic, potential, elastic = 0.0, 0.0, 0.0
    for b in range(masses.shape[0]):
        vx, vy, w = y[size + 3 * b], y[size + 3 * b + 1], y[size + 3 * b + 2]
        kinetic += 0.5 * (masses[b, 0] * (vx * vx + vy * vy) + masses[b, 1] * w * w)
        potential += masses[b, 0] * gravity * y[3 * b + 1]
    for k in range(system[5].shape[0]):
        delta = gap(y[:size], y[size : 2 * size], system, k)[0]
        if delta > 0.0:
            exponent = system[6][k, 7]
            elastic += system[6][k, 6] * delta ** (exponent + 1.0) / (exponent + 1.0)
    return kinetic, potential, elastic


def assemble(mechanism, system, tolerance=1e-15):
    """Ideal configuration and velocities at time zero with every journal centred: Newton from the guessed angles."""
    ideal_constraints = list(mechanism.constraints)  # and the clearance joints as constraints
    for c in mechanism.clearances:
        ideal_constraints.append(Constraint(c.name, REVOLUTE, c.i, c.j, c.point_i_m, c.point_j_m))
    for m in mechanism.meshes:
        arms = (m.first_arm_m, m.second_arm_m)
        ideal_constraints.append(Constraint(m.name, MESH, m.first, m.second, arms, (m.offset_m, float(m.carrier))))
    twin = Mechanism(**{**mechanism.__dict__, "constraints": ideal_constraints, "clearances": [], "meshes": []})
    ideal = tables(twin)
    size = 3 * len(mechanism.bodies)
    if ideal[4] != size:
        raise ValueError(f"{ideal[4]} constraints for {size} coordinates: the ideal mechanism must be driven fully")
    q = guess(twin, size)
    zero = np.zeros(size)
    for _ in range(100):
        c, jacobian, c_t, _ = constraint_rows(0.0, q, zero, ideal)
        step = np.linalg.solve(jacobian, c)
        # A long step may change the assembly: bodies are moved by at most 0.2 rad or 50 mm at a time.
        q = q - step * min(1.0, 0.05 / max(np.max(np.abs(step)) / 4.0, 1e-300))
        if np.max(np.abs(step)) < tolerance:
            break
    c, jacobian, c_t, _ = constraint_rows(0.0, q, zero, ideal)
    if np.max(np.abs(c)) > 1e-14:
        raise ValueError(f"the ideal mechanism does not close: residual {np.max(np.abs(c)):.3g}")
    v = np.linalg.solve(jacobian, -c_t)
    return np.concatenate([q, v, np.zeros(INTEGRALS)]), ideal


def guess(mechanism, size):
    """Angles from the hints and the driven bodies, then positions by walking along revolute and rigid joints."""
    q = np.zeros(size)
    for body, angle_rad in mechanism.guess_rad.items():
        q[3 * body + 2] = angle_rad
    for c in mechanism.constraints:
        if c.kind == DRIVE and c.i < 0:
            q[3 * c.j + 2] = c.start
        if c.kind == DRIVE and c.j < 0:
            q[3 * c.i + 2] = -c.start
        if c.kind == DRIVE and c.i >= 0 and c.j >= 0:
            q[3 * c.j + 2] = q[3 * c.i + 2] + c.start
    for c in mechanism.constraints:
        if c.kind == PRISMATIC and c.i < 0:
            q[3 * c.j + 2] = c.angle_i_rad - c.angle_j_rad
    for c in mechanism.constraints:
        if c.kind in (PRISMATIC, RIGID) and c.i >= 0 and c.j not in mechanism.guess_rad:
            turn_rad = c.angle_i_rad - c.angle_j_rad if c.kind == PRISMATIC else c.angle_j_rad
            q[3 * c.j + 2] = q[3 * c.i + 2] + turn_rad
    known = {-1}
    for _ in mechanism.constraints:
        for c in mechanism.constraints:
            if c.kind not in (REVOLUTE, RIGID):
                continue
            for (a, point_a), (b, point_b) in (
                ((c.i, c.point_i_m), (c.j, c.point_j_m)), ((c.j, c.point_j_m), (c.i, c.point_i_m)),
            ):  # fmt: skip
                if a in known and b not in known:
                    x, y = place(q, a, *arm(q, a, *point_a))
                    dx, dy = arm(q, b, *point_b)
                    q[3 * b], q[3 * b + 1] = x - dx, y - dy
                    known.add(b)
    return q

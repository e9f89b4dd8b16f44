"""DOP853 (Hairer, Norsett, Wanner; coefficients as shipped with scipy) with one leg per contact mode.

A step never straddles a change of mode: the change is found on the dense output, the step is taken again so that it
ends there, and its length is corrected by the secant rule until the event function is zero to round-off. Modes of a
clearance joint: flight or contact; normal force cut at zero or not; the five zones of Ambrósio's friction. After
every step the state is projected onto the ideal joints.
"""

from dataclasses import dataclass

import numpy as np
from scipy.integrate._ivp import dop853_coefficients as table

from compiled import njit
from mechanics import (
    CONTACT, CUT, ZONE, INTEGRALS, constraint_rows, contact_force, derivative, energy, gap, project,
)  # fmt: skip

STAGES, NODES, FUNCTIONS = 12, 12, 4
A, B, C, D = (np.ascontiguousarray(x) for x in (table.A, table.B, table.C, table.D))
E3, E5 = np.ascontiguousarray(table.E3), np.ascontiguousarray(table.E5)
RESTART_STEP_S = 1e-9  # after a change of mode; the force starts like δ^n there
EVENT_LIMIT = 200_000
ONSET, END, CUT_CHANGE, ZONE_CHANGE = 1, 0, 2, 3  # kinds of logged event


@dataclass
class Settings:
    """Accuracy of a run: scale of the local error in positions (m, rad) and velocities (m/s, rad/s); largest step."""

    position_error: float = 1e-15
    velocity_error: float = 1e-12
    largest_step_s: float = 5e-6


@dataclass
class History:
    """`rows`: time, then x, y, θ of every body, velocities, accelerations. `events`: time s, joint, kind, δ̇ m/s, impact
    speed m/s, and: at an end the peak force of that contact N, at a change the new mode. `integrals` per row: contact
    loss, friction loss, work of drives, kinetic, potential, elastic energy, J."""

    rows: np.ndarray
    events: np.ndarray
    integrals: np.ndarray
    steps: int
    rejected: int
    largest_correction: float

    @property
    def energy_residual_j(self):
        """Largest |kinetic + potential + elastic + losses - work - start| over the rows."""
        loss, friction, work, kinetic, potential, elastic = self.integrals.T
        total = kinetic + potential + elastic + loss + friction - work
        return float(np.max(np.abs(total - total[0])))


@njit()
def step(time_s, y, slope, h, system, mode, v0, scale):
    """One DOP853 step: new state, its slope, the stages, the error in units of `scale`."""
    n = y.size
    stages = np.zeros((16, n))
    stages[0] = slope
    for s in range(1, STAGES):
        stages[s] = derivative(time_s + C[s] * h, y + h * (A[s, :s] @ stages[:s]), system, mode, v0)
    new = y + h * (B @ stages[:STAGES])
    stages[STAGES] = derivative(time_s + h, new, system, mode, v0)
    counted = n - INTEGRALS
    fifth = (E5 @ stages[: STAGES + 1])[:counted] / scale
    third = (E3 @ stages[: STAGES + 1])[:counted] / scale
    five, three = np.dot(fifth, fifth), np.dot(third, third)
    error = 0.0
    if five > 0.0 or three > 0.0:
        error = abs(h) * five / np.sqrt((five + 0.01 * three) * counted)
    return new, stages, error


@njit()
def dense(time_s, y, new, stages, h, system, mode, v0):
    """Coefficients of the dense output of degree 7."""
    for s in range(STAGES + 1, 16):
        stages[s] = derivative(time_s + C[s] * h, y + h * (A[s, :s] @ stages[:s]), system, mode, v0)
    f = np.empty((7, y.size))
    change = new - y
    f[0] = change
    f[1] = h * stages[0] - change
    f[2] = 2.0 * change - h * (stages[STAGES] + stages[0])
    f[3:] = h * (D @ stages)
    return f


@njit()
def between(y, f, x):
    """Dense output at the share x of the step."""
    result = np.zeros_like(y)
    for i in range(7):
        result += f[6 - i]
        result *= x if i % 2 == 0 else 1.0 - x
    return result + y


@njit()
def zone_of(sliding, lower, upper):
    size = abs(sliding)
    zone = 0 if size <= lower else (1 if size <= upper else 2)
    return zone if sliding >= 0.0 else -zone


@njit()
def event_values(y, system, mode, v0):
    """Per clearance joint four functions that stay positive while the mode lasts."""
    size = 3 * system[0].shape[0]
    joints = system[5].shape[0]
    values = np.ones(FUNCTIONS * joints)
    for k in range(joints):
        delta, rate, sliding, _, _, _, _, _ = gap(y[:size], y[size : 2 * size], system, k)
        number = system[6][k]
        at = FUNCTIONS * k
        if mode[k, CONTACT] == 0:
            values[at] = -delta
            continue
        values[at] = delta
        if number[8] > 0.0:
            share = 1.0 + number[8] * rate / v0[k]
            values[at + 1] = -share if mode[k, CUT] == 1 else share
        if number[10] > 0.0:
            zone = mode[k, ZONE]
            lower, upper = number[11], number[12]
            if zone == 0:
                values[at + 2], values[at + 3] = lower - sliding, sliding + lower
            elif zone == 1:
                values[at + 2], values[at + 3] = upper - sliding, sliding - lower
            elif zone == -1:
                values[at + 2], values[at + 3] = -lower - sliding, sliding + upper
            elif zone == 2:
                values[at + 3] = sliding - upper
            else:
                values[at + 2] = -upper - sliding
    return values


@njit()
def value_at(which, y, f, x, system, mode, v0):
    return event_values(between(y, f, x), system, mode, v0)[which]


@njit()
def lowest(which, y, f, left, right, system, mode, v0):
    """Golden section for the lowest value of an event function between two shares of the step."""
    ratio = 0.5 * (np.sqrt(5.0) - 1.0)
    a, b = left, right
    c, d = b - ratio * (b - a), a + ratio * (b - a)
    gc = value_at(which, y, f, c, system, mode, v0)
    gd = value_at(which, y, f, d, system, mode, v0)
    for _ in range(40):
        if gc < gd:
            b, d, gd = d, c, gc
            c = b - ratio * (b - a)
            gc = value_at(which, y, f, c, system, mode, v0)
        else:
            a, c, gc = c, d, gd
            d = a + ratio * (b - a)
            gd = value_at(which, y, f, d, system, mode, v0)
    return (c, gc) if gc < gd else (d, gd)


@njit()
def first_event(y, f, system, mode, v0):
    """First share of the step at which an event function reaches zero: (which, share), (-1, 1.0) if none.
    (-2, share): a function that begins at zero rises and falls again before the first node; take a step so short."""
    nodes = np.linspace(0.0, 1.0, NODES + 1)
    values = np.empty((NODES + 1, FUNCTIONS * system[5].shape[0]))
    for m in range(NODES + 1):
        values[m] = event_values(between(y, f, nodes[m]), system, mode, v0)
    found, share = -1, 1.0
    for which in range(values.shape[1]):
        g = values[:, which]
        for m in range(NODES):
            left, right = nodes[m], nodes[m + 1]
            if left >= share:
                break
            if m == 0 and g[0] <= 0.0 and g[1] <= 0.0:
                x = nodes[1]
                for _ in range(60):
                    x *= 0.5
                    if value_at(which, y, f, x, system, mode, v0) > 0.0:
                        return -2, x
                return which, 0.0
            if g[m + 1] > 0.0:
                # A dip between nodes: three nodes whose middle is lowest, low against their spread.
                if m == 0 or not (g[m] <= g[m - 1] and g[m] <= g[m + 1]):
                    continue
                if g[m] > 2.0 * max(g[m - 1] - g[m], g[m + 1] - g[m]):
                    continue
                x, bottom = lowest(which, y, f, nodes[m - 1], right, system, mode, v0)
                if bottom > 0.0:
                    continue
                left, right = nodes[m - 1], x
            a, b = left, right
            for _ in range(60):
                x = 0.5 * (a + b)
                if value_at(which, y, f, x, system, mode, v0) > 0.0:
                    a = x
                else:
                    b = x
            if b < share:
                found, share = which, b
            break
    return found, share


@njit()
def land(time_s, y, slope, h, which, system, mode, v0, scale):
    """The step taken again with a length at which the event function is zero to round-off."""
    new, stages, _ = step(time_s, y, slope, h, system, mode, v0, scale)
    g = event_values(new, system, mode, v0)[which]
    f = dense(time_s, y, new, stages, h, system, mode, v0)
    back = 1.0 - 1e-4
    rate = (g - value_at(which, y, f, back, system, mode, v0)) / (1e-4 * h)
    for _ in range(6):
        if g == 0.0 or rate == 0.0:
            break
        length = h - g / rate
        if not abs(length - h) < 1e-3 * h:
            break
        trial, trial_stages, _ = step(time_s, y, slope, length, system, mode, v0, scale)
        trial_g = event_values(trial, system, mode, v0)[which]
        if abs(trial_g) >= abs(g):
            break
        if trial_g != g:
            rate = (trial_g - g) / (length - h) if length != h else rate
        new, h, g = trial, length, trial_g
    return new, h


@njit()
def normal_at(k, y, f, x, system, mode, v0):
    size = 3 * system[0].shape[0]
    inside = between(y, f, x)
    delta, rate, sliding, _, _, _, _, _ = gap(inside[:size], inside[size : 2 * size], system, k)
    return contact_force(delta, rate, sliding, system[6][k], mode[k], v0[k])[0]


@njit()
def note_peaks(y, f, reach, system, mode, v0, peaks):
    """Raises `peaks` to the largest normal force on the shares [0, reach] of the step."""
    for k in range(system[5].shape[0]):
        if mode[k, CONTACT] == 0:
            continue
        best, place_of_best = -1.0, 0
        for m in range(NODES + 1):
            force = normal_at(k, y, f, reach * m / NODES, system, mode, v0)
            if force > best:
                best, place_of_best = force, m
        if best < 0.9 * peaks[k]:
            continue
        a, b = reach * max(place_of_best - 1, 0) / NODES, reach * min(place_of_best + 1, NODES) / NODES
        for _ in range(60):
            c, d = a + (b - a) / 3.0, b - (b - a) / 3.0
            if normal_at(k, y, f, c, system, mode, v0) > normal_at(k, y, f, d, system, mode, v0):
                b = d
            else:
                a = c
        peaks[k] = max(peaks[k], best, normal_at(k, y, f, 0.5 * (a + b), system, mode, v0))


@njit()
def change_mode(time_s, y, which, system, mode, v0, peaks, events, count):
    """Switches the mode whose event function number `which` reached zero and logs it."""
    size = 3 * system[0].shape[0]
    k, function = which // FUNCTIONS, which % FUNCTIONS
    delta, rate, sliding, _, _, _, _, _ = gap(y[:size], y[size : 2 * size], system, k)
    number = system[6][k]
    if function == 0 and mode[k, CONTACT] == 0:
        mode[k, CONTACT], mode[k, CUT] = 1, 0
        v0[k] = max(rate, number[9])
        mode[k, ZONE] = zone_of(sliding, number[11], number[12])
        peaks[k] = 0.0
        events[count] = np.array([time_s, k, ONSET, rate, v0[k], 0.0])
        return count + 1
    if function == 0:
        mode[k, CONTACT] = 0
        events[count] = np.array([time_s, k, END, rate, v0[k], peaks[k]])
        return count + 1
    if function == 1:
        mode[k, CUT] = 1 - mode[k, CUT]
    elif function == 2:
        mode[k, ZONE] += 1
    else:
        mode[k, ZONE] -= 1
    kind = CUT_CHANGE if function == 1 else ZONE_CHANGE
    events[count] = np.array([time_s, k, kind, rate, v0[k], mode[k, CUT] if function == 1 else mode[k, ZONE]])
    return count + 1


@njit()
def integrate(y, times, system, position_error, velocity_error, largest_step):
    size = 3 * system[0].shape[0]
    joints = system[5].shape[0]
    mode = np.zeros((joints, 3), dtype=np.int64)
    v0, peaks = np.ones(joints), np.zeros(joints)
    events, count = np.zeros((EVENT_LIMIT, 6)), 0
    rows, integrals = np.zeros((times.size, 1 + 3 * size)), np.zeros((times.size, 6))
    scale = np.empty(2 * size)
    scale[:size], scale[size:] = position_error, velocity_error
    steps, rejected, still, largest = 0, 0, 0, 0.0
    t, h = times[0], RESTART_STEP_S
    y, _, _ = project(t, y, system)
    for target in range(times.size):
        while t < times[target]:
            slope = derivative(t, y, system, mode, v0)
            h = min(h, largest_step)
            remaining = times[target] - t
            is_last = h >= remaining * (1.0 - 1e-12)
            length = remaining if is_last else (0.5 * remaining if h > 0.5 * remaining else h)
            new, stages, error = step(t, y, slope, length, system, mode, v0, scale)
            if not error <= 1.0:
                h = length * max(0.2, 0.9 * error ** (-0.125)) if error == error else 0.1 * length
                rejected += 1
                if h < 1e-18:
                    raise ValueError("step below 1e-18 s")
                continue
            f = dense(t, y, new, stages, length, system, mode, v0)
            which, share = first_event(y, f, system, mode, v0)
            if which == -2:
                h = share * length
                rejected += 1
                continue
            grown = length * min(5.0, 0.9 * error ** (-0.125) if error > 0.0 else 5.0)
            steps += 1
            if which == -1:
                note_peaks(y, f, 1.0, system, mode, v0, peaks)
                t = times[target] if is_last else t + length
                y = new
                # A step shortened to meet a row says nothing against longer ones.
                h = max(grown, h) if length < h else grown
                still = 0
            else:
                if share > 0.0:
                    note_peaks(y, f, share, system, mode, v0, peaks)
                    y, length = land(t, y, slope, share * length, which, system, mode, v0, scale)
                    t += length
                    still = 0
                still += 1
                if still > 40:
                    raise ValueError("more than 40 changes of mode at one instant")
            y, moved, _ = project(t, y, system)
            largest = max(largest, moved)
            if which >= 0:
                count = change_mode(t, y, which, system, mode, v0, peaks, events, count)
                h = min(h, RESTART_STEP_S)
        slope = derivative(t, y, system, mode, v0)
        rows[target, 0] = t
        rows[target, 1 : 1 + 2 * size] = y[: 2 * size]
        rows[target, 1 + 2 * size :] = slope[size : 2 * size]
        integrals[target, :INTEGRALS] = y[2 * size :]
        kinetic, potential, elastic = energy(y, system)
        integrals[target, 3], integrals[target, 4], integrals[target, 5] = kinetic, potential, elastic
    return rows, events[:count].copy(), integrals, steps, rejected, largest


def run(start, times, system, settings):
    """The history from the state `start` at `times[0]` through the instants `times`, s."""
    return History(*integrate(
        start, times, system, settings.position_error, settings.velocity_error, settings.largest_step_s,
    ))  # fmt: skip

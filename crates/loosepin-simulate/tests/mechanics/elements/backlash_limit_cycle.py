"""The limit cycle of a servo through backlash, by an independent program.

A motor turns a load about the same axis through a pin in a hole with play; a PID controller turns the motor by the error of the
load. In terms of the two angles alone: with phi = motor - load and the pin at radius r, the distance of the centres is
2 r sin|phi/2|, the penetration that minus c, and the contact force K d^1.5 (1 + chi d'/v0) turns both with the lever r cos(phi/2).
Prints amplitude and period of the load's angle once the swings repeat themselves.
"""

import numpy as np
from scipy.integrate import solve_ivp

J_MOTOR, J_LOAD = 3.1e-4, 5.3e-4  # kg m2, about the axis
D_MOTOR, D_LOAD = 4e-3, 7e-3  # N m s/rad
RADIUS, CLEARANCE = 0.030, 0.3e-3  # m
STIFFNESS = 2e7  # N/m^1.5
CHI = 8 * (1 - 0.2) / (5 * 0.2)  # Flores, restitution 0.2
V_MIN = 1e-3  # m/s
K_P, K_I, K_D = 0.35, 1.6, 0.012
TARGET, START = 0.4, 0.38  # rad


def penetration(state):
    phi = state[0] - state[2]
    half = abs(phi) / 2
    depth = 2 * RADIUS * np.sin(half) - CLEARANCE
    rate = RADIUS * np.cos(half) * np.sign(phi) * (state[1] - state[3])
    return depth, rate, RADIUS * np.cos(half) * np.sign(phi)


def slope(_, state, in_contact, v0):
    error, error_rate = TARGET - state[2], -state[3]
    drive = K_P * error + K_I * state[4] + K_D * error_rate
    torque = 0.0
    if in_contact:
        depth, rate, lever = penetration(state)
        force = STIFFNESS * max(depth, 0.0) ** 1.5 * (1 + CHI * rate / v0)
        torque = -max(force, 0.0) * lever
    return [
        state[1],
        (drive - D_MOTOR * state[1] + torque) / J_MOTOR,
        state[3],
        (-D_LOAD * state[3] - torque) / J_LOAD,
        error,
    ]


def run(end_s):
    time_s, state, in_contact, v0 = 0.0, np.array([START, 0, START, 0, 0.0]), False, V_MIN
    times, loads = [], []

    def crossing(_, state, *__):
        return penetration(state)[0]

    crossing.terminal = True
    while time_s < end_s:
        crossing.direction = -1 if in_contact else 1
        part = solve_ivp(slope, (time_s, end_s), state, "DOP853", args=(in_contact, v0), events=crossing,
                         rtol=1e-10, atol=1e-12, dense_output=True, max_step=0.01)
        grid = np.arange(np.ceil(time_s / 1e-4) * 1e-4, part.t[-1], 1e-4)
        if grid.size:
            times.append(grid)
            loads.append(part.sol(grid)[2])
        time_s, state = part.t[-1], part.y[:, -1]
        if part.status == 1:
            in_contact = not in_contact
            v0 = max(penetration(state)[1], V_MIN)
            # Off the surface, so that the event just met is not met again.
            side = np.sign(state[0] - state[2])
            state[0] += side * (1e-13 if in_contact else -1e-13)
    return np.concatenate(times), np.concatenate(loads)


if __name__ == "__main__":
    import sys

    end_s = float(sys.argv[1]) if len(sys.argv) > 1 else 24.0
    times, loads = run(end_s)
    half = times > end_s / 2
    times, error = times[half], TARGET - loads[half]
    middle = (error.max() + error.min()) / 2
    up = np.nonzero((error[:-1] < middle) & (error[1:] >= middle))[0]
    begins = times[up] + (times[up + 1] - times[up]) * (middle - error[up]) / (error[up + 1] - error[up])
    periods = np.diff(begins)
    amplitudes = [np.ptp(error[a:b]) / 2 for a, b in zip(up[:-1], up[1:])]
    print("periods s", periods)
    print("amplitudes rad", np.array(amplitudes))
    print("mean period s", periods.mean(), "mean amplitude rad", np.mean(amplitudes), "mean error rad", error.mean())

"""The largest Lyapunov exponent of the driven damped pendulum, from the equations of its small differences.

    th'' + th'/q + sin(th) = F cos(w t),    q = 2, F = 1.5, w = 2/3

(G. L. Baker and J. P. Gollub, Chaotic Dynamics: An Introduction, Cambridge 1990, call this motion chaotic.) The small
difference (a, b) of two motions obeys a' = b, b' = -b/q - cos(th) a; the exponent is the mean rate of ln sqrt(a^2 + b^2).
Many pendulums start at different angles, so that their means also give the standard error. Nothing here is shared with
the library: no neighbouring run, no events, classical Runge-Kutta steps.

    python3 cases/oracle/exponent.py
"""

import argparse

import numpy as np

Q, FORCE, FREQUENCY = 2.0, 1.5, 2.0 / 3.0


def slopes(time, state):
    angle, rate, a, b = state
    push = FORCE * np.cos(FREQUENCY * time)
    return np.array([rate, push - rate / Q - np.sin(angle), b, -b / Q - np.cos(angle) * a])


def exponent(pendulums, transient, turns, steps):
    period = 2.0 * np.pi / FREQUENCY
    h = period / steps
    spread = np.linspace(-1.0, 1.0, pendulums)
    state = np.array([0.5 + 0.4 * spread, 0.3 - 0.2 * spread, 0.6 + 0.0 * spread, 0.8 + 0.0 * spread])
    growth = np.zeros(pendulums)
    for turn in range(transient + turns):
        for step in range(steps):
            time = (step + 0.0) * h
            k1 = slopes(time, state)
            k2 = slopes(time + h / 2, state + h / 2 * k1)
            k3 = slopes(time + h / 2, state + h / 2 * k2)
            k4 = slopes(time + h, state + h * k3)
            state = state + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        size = np.hypot(state[2], state[3])
        state[2:] /= size
        if turn >= transient:
            growth += np.log(size)
    means = growth / (turns * period)
    return means.mean(), means.std(ddof=1) / np.sqrt(pendulums)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--pendulums", type=int, default=64)
    parser.add_argument("--transient", type=int, default=50)
    parser.add_argument("--turns", type=int, default=2000)
    parser.add_argument("--steps", type=int, default=200, help="Runge-Kutta steps a period")
    arguments = parser.parse_args()
    value, error = exponent(arguments.pendulums, arguments.transient, arguments.turns, arguments.steps)
    print(f"{value:.5f} +- {error:.5f} (standard error), over the time unit of the equation")


if __name__ == "__main__":
    main()

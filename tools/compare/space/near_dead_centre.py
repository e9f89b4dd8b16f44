"""A four-bar with two balls, nearer and nearer to its dead centre: worst case of first order against the exact one.

    python3 tools/compare/space/near_dead_centre.py

The four-bar of docs/examples/rssr-near-dead-centre.toml. A ball with play makes the coupler as long as L - c to L + c, so the extremes
are in closed form. A search over where the ball is in its socket, which knows nothing of that, has to find the same.
"""

import numpy as np
from scipy.optimize import brentq, minimize

CRANK, COUPLER, ROCKER, CLEARANCE = 0.05, 0.2, 0.12, 0.2e-3
PIVOT, AXIS, ZERO = np.array([0.22, 0.04, 0.06]), np.array([0.6, 0.8, 0.0]), np.array([0.0, 0.0, 1.0])
ACROSS = np.cross(AXIS, ZERO)
ANGLES_DEG = (100, 120, 150, 158, 160, 160.5, 160.7)
BEYOND_DEG = (160.8, 160.9, 161)


def crank_pin(crank: float) -> np.ndarray:
    return CRANK * np.array([np.cos(crank), np.sin(crank), 0.0])


def socket(rocker: float) -> np.ndarray:
    return PIVOT + ROCKER * (np.cos(rocker) * ZERO + np.sin(rocker) * ACROSS)


def rocker_angle(crank: float, coupler: float, side: float = 1.0) -> float:
    """The angle of the rocker in closed form; `side` chooses one of both ways to assemble."""
    between = PIVOT - crank_pin(crank)
    p, q = 2 * ROCKER * between @ ZERO, 2 * ROCKER * between @ ACROSS
    s = coupler**2 - ROCKER**2 - between @ between
    return np.arctan2(q, p) + side * np.arccos(s / np.hypot(p, q))


def shortest_coupler(crank: float) -> float:
    """The length with which this position is the dead centre."""
    between = PIVOT - crank_pin(crank)
    reach = 2 * ROCKER * np.hypot(between @ ZERO, between @ ACROSS)
    return np.sqrt(ROCKER**2 + between @ between - reach)


def first_order(crank: float) -> float:
    """|d angle / d length| c: the coupler pushes along itself, the ball of the rocker moves across its arm."""
    rocker = rocker_angle(crank, COUPLER)
    along = (socket(rocker) - crank_pin(crank)) / COUPLER
    return CLEARANCE / abs(along @ np.cross(AXIS, socket(rocker) - PIVOT))


def searched(crank: float, sign: float) -> float:
    """The largest turn to one side over all places of the ball in its socket, each closed by Newton's method."""
    start, pin = rocker_angle(crank, COUPLER), crank_pin(crank)

    def turn(place: np.ndarray) -> float:
        polar, azimuth = place
        inside = CLEARANCE * np.array([np.sin(polar) * np.cos(azimuth), np.sin(polar) * np.sin(azimuth), np.cos(polar)])
        angle = start
        for _ in range(50):
            ball = socket(angle) + inside - pin
            step = (ball @ ball - COUPLER**2) / (2 * ball @ np.cross(AXIS, socket(angle) - PIVOT))
            angle -= step
            if abs(step) < 1e-15:
                break
        return -sign * (angle - start)

    starts = [(polar, azimuth) for polar in (0.8, 2.3) for azimuth in (0.5, 2.6, 4.7)]
    options = {"xatol": 1e-9, "fatol": 1e-14, "maxiter": 2000}
    return sign * max(-minimize(turn, place, method="Nelder-Mead", options=options).fun for place in starts)


def main() -> None:
    low, high = np.radians([150, 175])
    dead = np.degrees(brentq(lambda crank: shortest_coupler(crank) - COUPLER, low, high))
    jammed = np.degrees(brentq(lambda crank: shortest_coupler(crank) - (COUPLER - CLEARANCE), low, high))
    print(f"dead centre at {dead:.4f} deg; from {jammed:.4f} deg on, play reaches it")
    print("crank, deg  first order, mrad  exact, up  exact, down  searched, up  searched, down  first order is")
    for degrees in ANGLES_DEG:
        crank = np.radians(degrees)
        middle, linear = rocker_angle(crank, COUPLER), first_order(crank)
        up, down = (rocker_angle(crank, COUPLER - side * CLEARANCE) - middle for side in (1, -1))
        by_search = [1e3 * searched(crank, side) for side in (1, -1)]
        error = f"{100 * (linear / up - 1):+6.1f} % and {100 * (linear / -down - 1):+6.1f} %"
        print(f"{degrees:10} {1e3 * linear:18.4f} {1e3 * up:10.4f} {1e3 * down:12.4f} {by_search[0]:13.4f} {by_search[1]:15.4f}  {error}")
    print("beyond: the play takes the rocker through the dead centre, to the other way to assemble")
    for degrees in BEYOND_DEG:
        crank = np.radians(degrees)
        middle = rocker_angle(crank, COUPLER)
        up = (rocker_angle(crank, COUPLER + CLEARANCE, -1.0) - middle) % (2 * np.pi)
        down = rocker_angle(crank, COUPLER + CLEARANCE) - middle
        print(f"{degrees:10} {1e3 * first_order(crank):18.4f} {1e3 * up:10.4f} {1e3 * down:12.4f}"
              f"   in degrees {np.degrees(first_order(crank)):.4g}, {np.degrees(up):.4g}, {np.degrees(down):.4g}")


main()

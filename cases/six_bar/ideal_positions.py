#!/usr/bin/env python3
"""Ideal positions of the six-bar in model.toml beside it, by intersecting circles.

Prints the numbers of expected.toml, and the transmission angles, which tell how far the loops stay from their singular
positions. Usage, with Python 3.11 or newer: python3 cases/six_bar/ideal_positions.py
"""

import cmath
import math
import pathlib
import tomllib

MODEL = tomllib.loads((pathlib.Path(__file__).parent / "model.toml").read_text())


def length_m(text):
    """A length in the file: a number with mm, or the name of a parameter that is one."""
    text = MODEL["parameter"].get(text, text)
    return float(text.removesuffix(" mm")) / 1000.0


def point(body, name):
    """A point in its body's frame, as a complex number, m."""
    x, y = MODEL["body"][body]["points"][name]
    return complex(length_m(x), length_m(y))


MAIN = point("ground", "o")
ROCKER_PIVOT = point("ground", "rocker_pivot")
ARM_PIVOT = point("ground", "arm_pivot")
CRANK_M = length_m("crank_length")
COUPLER_M = length_m("coupler_length")
ROCKER_M = length_m("rocker_length")
LINK_M = length_m("link_length")
ARM_M = length_m("arm_length")
LINK_PIN = point("rocker", "link_pin")
TRACER = point("link", "tracer")


def left_intersection(start, start_radius_m, end, end_radius_m):
    """The point at the given distances from both centres, to the left of the line from start to end."""
    distance_m = abs(end - start)
    along_m = (start_radius_m**2 - end_radius_m**2 + distance_m**2) / (2.0 * distance_m)
    across_m = math.sqrt(start_radius_m**2 - along_m**2)  # ValueError: the links cannot close
    return start + (along_m + 1j * across_m) * (end - start) / distance_m


def angle_between_deg(first, second):
    return abs(math.degrees(cmath.phase(first / second)))


def positions(crank_rad):
    crank_pin = MAIN + cmath.rect(CRANK_M, crank_rad)
    coupler_pin = left_intersection(crank_pin, COUPLER_M, ROCKER_PIVOT, ROCKER_M)
    rocker = (coupler_pin - ROCKER_PIVOT) / ROCKER_M
    link_tail = ROCKER_PIVOT + rocker * LINK_PIN
    link_head = left_intersection(link_tail, LINK_M, ARM_PIVOT, ARM_M)
    link = (link_head - link_tail) / LINK_M
    return {
        "coupler_rad": cmath.phase(coupler_pin - crank_pin),
        "rocker_rad": cmath.phase(rocker),
        "link_rad": cmath.phase(link),
        "arm_rad": cmath.phase(link_head - ARM_PIVOT),
        "tracer_x_m": (link_tail + link * TRACER).real,
        "tracer_y_m": (link_tail + link * TRACER).imag,
        "first_transmission_deg": angle_between_deg(crank_pin - coupler_pin, ROCKER_PIVOT - coupler_pin),
        "second_transmission_deg": angle_between_deg(link_tail - link_head, ARM_PIVOT - link_head),
    }


def main():
    start = positions(math.radians(34.0))
    print("at the start angle, 34 deg:")
    for name, value in start.items():
        print(f"  {name} = {value:.15g}")
    angles_deg = [34.0, 107.0, 191.0, 283.0]
    for name in ("coupler_rad", "rocker_rad", "link_rad", "arm_rad", "tracer_x_m", "tracer_y_m"):
        values = [positions(math.radians(angle_deg))[name] for angle_deg in angles_deg]
        print(f"{name} at {angles_deg} deg: " + ", ".join(f"{value:.15g}" for value in values))
    turn = [positions(math.radians(tenth / 10.0)) for tenth in range(3600)]
    for name in ("first_transmission_deg", "second_transmission_deg", "rocker_rad", "arm_rad"):
        values = [pose[name] for pose in turn]
        print(f"{name} over the turn: {min(values):.6f} to {max(values):.6f}")


if __name__ == "__main__":
    main()

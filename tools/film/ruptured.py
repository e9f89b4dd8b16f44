#!/usr/bin/env python3
"""Forces of films that rupture, for the test in ruptured.rs: finite differences over the whole film, projected relaxation.

    python3 -m venv .venv && .venv/bin/pip install numpy && .venv/bin/python tools/film/ruptured.py

p >= 0, 2ε̇ cos θ - wε sin θ - (h³ p')' - h³ p_ζζ/Λ² >= 0, and one of the two zero everywhere: on a grid that is even in θ and in ζ,
p = 0 at ζ = 1, p_ζ = 0 at ζ = 0, every other place and station in turn, no pressure below zero (Christopherson 1941, Cryer 1971).
Forces in units of μ L R³/c², from two grids by Richardson's extrapolation.
"""

import numpy as np


def force(ratio, length, squeeze, wedge, places, stations):
    step, across = 2 * np.pi / places, 1 / stations
    theta = step * (np.arange(places) + 0.5)
    film = ((1 + ratio * np.cos(theta)) ** 3)[:, None] / (length * across) ** 2
    before = ((1 + ratio * np.cos(step * np.arange(places))) ** 3)[:, None] / step**2
    after = np.roll(before, -1, axis=0)
    ends = np.full(stations, 2.0)
    ends[0], ends[-1] = 1.0, 3.0
    diagonal = before + after + film * ends
    right = (wedge * np.sin(theta) - 2 * squeeze * np.cos(theta))[:, None]
    colour = (np.arange(places)[:, None] + np.arange(stations)) % 2
    pressure = np.zeros((places, stations))
    relaxation = 2 / (1 + 2.2 / stations / max(length, 1.0))
    while True:
        largest = 0.0
        for which in (0, 1):
            flow = right + before * np.roll(pressure, 1, axis=0) + after * np.roll(pressure, -1, axis=0)
            flow[:, 1:] += film * pressure[:, :-1]
            flow[:, :-1] += film * pressure[:, 1:]
            new = np.maximum(pressure + relaxation * (flow / diagonal - pressure), 0)
            change = np.where(colour == which, new - pressure, 0)
            largest = max(largest, np.abs(change).max())
            pressure += change
        if largest < 1e-12 * pressure.max():
            break
    sums = 6 * pressure.sum(axis=1) * step * across
    return np.array([np.sum(sums * np.cos(theta)), np.sum(sums * np.sin(theta))])


if __name__ == "__main__":
    for case in [(0.3, 0.5, 0.8, 0.9), (0.6, 1.0, 0.0, 1.1), (0.6, 1.3, -0.4, 0.7), (0.85, 0.4, 0.3, -1.2), (0.85, 2.5, 0.6, 0.5)]:
        coarse, fine = (force(*case, 320 * k, 32 * k) for k in (1, 2))
        print(case, (4 * fine - coarse) / 3, abs(fine - coarse).max() / np.hypot(*fine), flush=True)

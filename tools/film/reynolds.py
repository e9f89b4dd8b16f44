#!/usr/bin/env python3
"""Forces of films of finite length, for the test in reynolds.rs: finite differences over the whole film, one sparse system.

    python3 -m venv .venv && .venv/bin/pip install numpy scipy && .venv/bin/python tools/film/reynolds.py

(h³ p')' + h³ p_ζζ/Λ² = 2ε̇ cos θ - wε sin θ on a grid that is even in θ and in ζ, p = 0 at ζ = 1, p_ζ = 0 at ζ = 0; negative
pressure is dropped. Forces in units of μ L R³/c², from two grids by Richardson's extrapolation.
"""

import numpy as np
from scipy.sparse import diags, identity, kron
from scipy.sparse.linalg import spsolve


def force(ratio, length, squeeze, wedge, places, stations):
    step, across = 2 * np.pi / places, 1 / stations
    theta = step * (np.arange(places) + 0.5)
    film = (1 + ratio * np.cos(theta)) ** 3
    face = (1 + ratio * np.cos(step * np.arange(places))) ** 3  # before each place
    after = np.roll(face, -1)
    around = diags([-(face + after), after[:-1], face[1:]], [0, 1, -1], format="lil")
    around[0, -1] = around[-1, 0] = face[0]
    ends = np.full(stations, -2.0)
    ends[0], ends[-1] = -1.0, -3.0
    along = diags([ends, np.ones(stations - 1), np.ones(stations - 1)], [0, 1, -1])
    system = kron(around.tocsc() / step**2, identity(stations)) + kron(diags(film), along / (length * across) ** 2)
    right = np.repeat(2 * squeeze * np.cos(theta) - wedge * np.sin(theta), stations)
    pressure = np.maximum(spsolve(system.tocsc(), right), 0).reshape(places, stations)
    sums = 6 * pressure.sum(axis=1) * step * across
    return np.array([np.sum(sums * np.cos(theta)), np.sum(sums * np.sin(theta))])


for case in [(0.3, 0.5, 0.8, 0.9), (0.6, 1.0, 0.0, 1.1), (0.6, 1.3, -0.4, 0.7), (0.85, 0.4, 0.3, -1.2), (0.85, 2.5, 0.6, 0.5)]:
    coarse, fine = (force(*case, 400 * k, 60 * k) for k in (1, 2))
    print(case, (4 * fine - coarse) / 3, abs(fine - coarse).max() / np.hypot(*fine))

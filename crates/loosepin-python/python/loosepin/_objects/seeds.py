"""Seeds as NumPy's users state them."""

from __future__ import annotations

import secrets
from numbers import Integral

import numpy as np

from .errors import refused

Seed = int | np.random.Generator | np.random.SeedSequence | None
"""A whole number from 0 to 2**64 - 1, a generator or a seed sequence of NumPy, or None for one from the operating system."""

# What a double holds exactly: the largest seed of a study file, and of what is drawn here.
_LARGEST_DRAWN = 2**53 - 1
_LARGEST = 2**64 - 1


def seed_number(seed: Seed) -> int:
    """The whole number that a seed stands for. A generator gives its next number, so that two calls have two seeds; a sequence always
    gives the same one.
    """
    if seed is None:
        return secrets.randbelow(_LARGEST_DRAWN + 1)
    if isinstance(seed, np.random.Generator):
        return int(seed.integers(_LARGEST_DRAWN, endpoint=True))
    if isinstance(seed, np.random.SeedSequence):
        return int(seed.generate_state(1, np.uint64)[0]) & _LARGEST_DRAWN
    if isinstance(seed, bool) or not isinstance(seed, Integral):
        raise TypeError(f"seed is a {type(seed).__name__}; must be an int, a numpy.random.Generator, a SeedSequence or None")
    if seed < 0:
        raise refused(f"seed {seed}; must be >= 0")
    if seed > _LARGEST:
        raise refused(f"seed {seed}; must be <= {_LARGEST}")
    return int(seed)

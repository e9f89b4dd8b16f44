"""The arm of `loosepin new six-axis-arm` at the end of its cycle, written anew from its sizes: a chain of six bearings."""

import numpy as np
from journals import Plays, frame, inverse, journal

X, Y, Z = np.eye(3)
CLEARANCES = [5e-6, 5e-6, 5e-6, 5e-6, 4e-6, 4e-6]
LENGTHS = [0.12, 0.12, 0.1, 0.1, 0.06, 0.05]
PLAYS = Plays(CLEARANCES, [5e-6] * 6)
# Each joint: its place on the body before, its axis, the direction from which its angle is counted; on the next body it is at the origin.
SEATS = [
    frame([0, 0, 0.2], Z, X),
    frame([0.025, 0, 0.2], Y, X),
    frame([0, 0, 0.455], Y, X),
    frame([0.15, 0, 0.035], X, Y),
    frame([0.27, 0, 0], Y, X),
    frame([0.08, 0, 0], X, Y),
]
TIP = np.array([0.15, 0, 0, 1])
ANGLES = np.radians([-25 + 50, 0 + 30, 20 - 35, -30 + 60, 60 - 40, 0 + 90])  # at 1 s


def height(rows: np.ndarray) -> np.ndarray:
    """z of the tip."""
    here = np.broadcast_to(np.eye(4), (len(rows), 4, 4))
    for joint, (seat, angle, length) in enumerate(zip(SEATS, ANGLES, LENGTHS)):
        held = journal(rows[:, 4 * joint : 4 * joint + 4], rows[:, 24 + joint], length, np.full(len(rows), angle))
        turned = seat.copy()
        turned[:3, 3] = 0
        here = here @ seat @ held @ inverse(turned)
    return here[:, 2] @ TIP

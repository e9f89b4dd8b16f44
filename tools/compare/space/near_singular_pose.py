"""The spherical platform, all nine bearings with play, nearer and nearer to a singular pose: first order against exact.

    python3 tools/compare/space/near_singular_pose.py

Motor 2 turns back from its start; after some 35 degrees the platform can turn either way.
"""

import numpy as np
from journals import Output
from spherical_platform import MOTORS, PLAYS, START, Platform

BACK_DEG = (0, 20, 30, 33, 33.5)
FORWARD = np.array([0.96893835, -0.20504688, -0.13825433])  # on the platform: along x of the ground at the start
STARTS = 2
FARTHEST = 0.2  # rotation vectors of neighbouring poses, for a step of 1 degree: more is another way to assemble


def turn(platform: Platform) -> Output:
    """Component along `FORWARD` of the rotation vector of the platform against its ideal pose, radians."""
    still = platform.poses(np.zeros((1, 39)))[0, :3, :3]

    def of_rows(rows: np.ndarray) -> np.ndarray:
        relative = still.T @ platform.poses(rows)[:, :3, :3]
        axial = np.stack([relative[:, 2, 1] - relative[:, 1, 2], relative[:, 0, 2] - relative[:, 2, 0],
                          relative[:, 1, 0] - relative[:, 0, 1]], axis=-1) / 2
        sine = np.linalg.norm(axial, axis=1)
        return axial @ FORWARD / np.linalg.norm(FORWARD) * np.where(sine > 1e-9, np.arcsin(np.clip(sine, 0, 1)) / np.maximum(sine, 1e-300), 1.0)

    return of_rows


def at(back_deg: float, start: np.ndarray) -> Platform:
    return Platform(MOTORS - np.radians([0, back_deg, 0]), start)


def singular_deg() -> float:
    """How far back motor 2 turns until the pose is singular: the ideal pose is followed in ever smaller steps."""
    back, step, vector = 0.0, 1.0, START
    while step > 1e-5:
        try:
            found = at(back + step, vector).vector
        except (ValueError, np.linalg.LinAlgError):
            found = vector + 1
        if np.linalg.norm(found - vector) < FARTHEST * np.sqrt(step):
            back, vector = back + step, found
        else:
            step /= 2
    return back


def main() -> None:
    print(f"singular {singular_deg():.3f} deg back")
    generator = np.random.default_rng(1)
    print("motor 2 back, deg  first order, mrad  exact, up  exact, down  first order is")
    vector = START
    for back in BACK_DEG:
        platform = at(back, vector)
        vector = platform.vector  # the next pose is found from here
        output = turn(platform)
        linear = PLAYS.first_order(output)
        up, down = (side * PLAYS.largest(output, side, STARTS, generator)[0] for side in (1, -1))
        error = f"{100 * (linear / up - 1):+6.1f} % and {100 * (linear / -down - 1):+6.1f} %"
        print(f"{back:17} {1e3 * linear:18.3f} {1e3 * up:10.3f} {1e3 * down:12.3f}  {error}", flush=True)


main()

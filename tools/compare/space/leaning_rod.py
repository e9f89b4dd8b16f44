"""A slider-crank whose rod may lean: an overconstrained loop, exactly, to first order, and as linear stacks would have it.

    python3 tools/compare/space/leaning_rod.py

The mechanism of docs/examples/leaning-rod.toml with its crank along x. Unknown are the displacement and the rotation of the rod and where
the slider is: seven numbers. The ball at the crank and the gudgeon pin say eight things of them, one of which repeats others.
"""

import numpy as np
from scipy.optimize import minimize
from scipy.spatial.transform import Rotation

CRANK, ROD, TIP = 0.05, 0.12, np.array([0.06, 0.0, 0.05])
CLEARANCE, LENGTH = 0.2e-3, 0.02
AXIALS = (0.1e-3, 5e-3)
BALL = np.array([CRANK, 0.0, 0.0])
UNIT = 1e-4  # of the numbers that the searches change: metres and radians
REACH = np.array([100.0, 10.0, 10.0, 2.0])  # of the starts: the rotation of the rod, about x most, and the slider
STARTS = 40
NAMES = ("ball x", "ball y", "ball z", "pin offset x", "pin offset y", "pin along its axis", "pin lean x", "pin lean y")


def rod_frame(numbers: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    return BALL + numbers[:3], Rotation.from_rotvec(numbers[3:6]).as_matrix(), BALL + [ROD + numbers[6], 0, 0]


def rows(numbers: np.ndarray) -> np.ndarray:
    """What the joints say: the displacement of the ball, and offset, displacement along, and lean of the gudgeon pin in the rod."""
    origin, turned, slider = rod_frame(numbers)
    relative = turned.T @ (slider - origin) - [ROD, 0, 0]
    axis = turned.T @ [0, 0, 1]
    lean = axis[:2] / axis[2]
    return np.concatenate([numbers[:3], relative[:2] - relative[2] * lean, relative[2:], lean])


def tip(numbers: np.ndarray) -> float:
    origin, turned, _ = rod_frame(numbers)
    return float((origin + turned @ TIP)[2] - TIP[2])


def slopes(function, size: int = 7) -> np.ndarray:
    return np.stack([(np.asarray(function(h)) - np.asarray(function(-h))) / 2e-6 for h in 1e-6 * np.eye(size)], axis=-1)


def room(said: np.ndarray, axial: float) -> np.ndarray:
    """What is left of the clearances, at both ends of the pin and at both stops; never negative where the pose is possible."""
    ends = [said[3:5] + side * said[6:8] * LENGTH / 2 for side in (-1, 1)]
    return np.concatenate([[1 - end @ end / CLEARANCE**2 for end in ends], [1 - said[5] / axial, 1 + said[5] / axial]])


def largest(sign: float, axial: float, output, said) -> float:
    """Largest output over the poses that the joints allow; the ball stays, so four numbers are free."""
    generator = np.random.default_rng(1)

    def whole(free: np.ndarray) -> np.ndarray:
        return np.concatenate([np.zeros(3), free]) * UNIT

    best = -np.inf
    for _ in range(STARTS):
        start = generator.uniform(-1, 1, 4) * REACH
        found = minimize(lambda free: -sign * 1e6 * output(whole(free)), start, method="SLSQP",
                         constraints=[{"type": "ineq", "fun": lambda free: room(said(whole(free)), axial)}],
                         options={"ftol": 1e-11, "maxiter": 1000})
        if found.success and room(said(whole(found.x)), axial).min() > -1e-8:
            best = max(best, -found.fun)
    return sign * best


def stacked(gains: np.ndarray, axial: float) -> float:
    """The linear worst case of the gudgeon pin from the gains of its rows, in micrometres: both ends share the clearance."""
    offset, along, lean = gains[3:5], gains[5], gains[6:8]
    ends = [np.linalg.norm(offset / 2 + side * lean / LENGTH) for side in (-1, 1)]
    return 1e6 * (CLEARANCE * sum(ends) + axial * abs(along))


def main() -> None:
    jacobian, gradient = slopes(rows), slopes(tip)
    print(f"{len(jacobian)} rows, rank {np.linalg.matrix_rank(jacobian, tol=1e-9)}; height of the tip, um")
    for axial in AXIALS:
        exact = [largest(sign, axial, tip, rows) for sign in (1, -1)]
        linear = largest(1, axial, lambda numbers: gradient @ numbers, lambda numbers: jacobian @ numbers)
        print(f"axial clearance {1e3 * axial:g} mm: first order, with the loop closed, {linear:.3f}; exact {exact[0]:+.3f} and {exact[1]:+.3f}")
        for row, name in enumerate(NAMES):
            kept = np.delete(np.arange(len(NAMES)), row)
            if np.linalg.matrix_rank(jacobian[kept], tol=1e-9) == jacobian.shape[1]:
                gains = np.zeros(len(NAMES))
                gains[kept] = np.linalg.solve(jacobian[kept].T, gradient)
                print(f"  linear stack without '{name}': {stacked(gains, axial):.1f}")


main()

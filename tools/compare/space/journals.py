"""Journals in their bearings, as rigid displacements, many at once. Lengths in metres, angles in radians.

A frame is a 4x4 matrix; arrays of frames have their number in front. Where a journal is in its bearing is (u1, u2, a): u1 and u2 are
the points, in two coordinates each, where its axis pierces the end planes of the bearing, each within the radial clearance of the
bearing's axis; a is its displacement along the axis.
"""

from collections.abc import Callable, Sequence

import numpy as np
from scipy.optimize import minimize

ROUNDS = 8  # of Newton's method: twice what the poses here need
STEP_M = 1e-6  # of central differences over places of journals

Output = Callable[[np.ndarray], np.ndarray]  # of rows of places of the journals


def frame(origin: Sequence[float], z_axis: Sequence[float], x_axis: Sequence[float]) -> np.ndarray:
    """A frame at a point: z along the axis of a joint, x across it."""
    z = np.asarray(z_axis, float) / np.linalg.norm(z_axis)
    x = np.asarray(x_axis, float) - z * (np.asarray(x_axis, float) @ z)
    x /= np.linalg.norm(x)
    made = np.eye(4)
    made[:3, :3] = np.stack([x, np.cross(z, x), z], axis=-1)
    made[:3, 3] = origin
    return made


def inverse(frames: np.ndarray) -> np.ndarray:
    made = np.zeros_like(frames)
    made[..., :3, :3] = np.swapaxes(frames[..., :3, :3], -1, -2)
    made[..., :3, 3] = -(made[..., :3, :3] @ frames[..., :3, 3:])[..., 0]
    made[..., 3, 3] = 1.0
    return made


def leaning(slope: np.ndarray, turn: np.ndarray) -> np.ndarray:
    """Rotations whose z axis is along (slope, 1) and whose x axis, looked at along the bearing's axis, is turned by `turn`."""
    z = np.concatenate([slope, np.ones(slope.shape[:-1] + (1,))], axis=-1)
    across = np.stack([np.cos(turn), np.sin(turn)], axis=-1)
    x = np.concatenate([across, -np.sum(slope * across, axis=-1, keepdims=True)], axis=-1)
    z = z / np.linalg.norm(z, axis=-1, keepdims=True)
    x = x / np.linalg.norm(x, axis=-1, keepdims=True)
    return np.stack([x, np.cross(z, x), z], axis=-1)


def journal(ends: np.ndarray, along: np.ndarray, length: float, turn: np.ndarray) -> np.ndarray:
    """Frames of the journal in the frame of its bearing; `ends` are u1 and u2, (n, 4), `turn` is the angle that a drive holds."""
    slope = (ends[:, 2:] - ends[:, :2]) / length
    made = np.zeros((len(ends), 4, 4))
    made[:, :3, :3] = leaning(slope, turn)
    made[:, :2, 3] = (ends[:, :2] + ends[:, 2:]) / 2 + along[:, None] * slope
    made[:, 2, 3] = along
    made[:, 3, 3] = 1.0
    return made


class Plays:
    """Where all journals are, in one row of numbers: u1, u2 of each bearing, then `a` of each that has stops."""

    def __init__(self, clearances: Sequence[float], axial: Sequence[float]) -> None:
        self.clearances, self.axial = np.asarray(clearances, float), np.asarray(axial, float)
        self.discs = 2 * len(self.clearances)
        self.radii = np.repeat(self.clearances, 2)

    def rows(self, share: np.ndarray, angle: np.ndarray, along: np.ndarray) -> np.ndarray:
        """Rows from polar coordinates in each disc, the radius as a share of the clearance, and shares of the axial clearances."""
        reach = share * self.radii
        points = np.stack([reach * np.cos(angle), reach * np.sin(angle)], axis=-1)
        return np.concatenate([points.reshape(len(share), -1), along * self.axial], axis=1)

    def anywhere(self, count: int, generator: np.random.Generator) -> np.ndarray:
        """Each journal anywhere in its play, all places alike."""
        share = np.sqrt(generator.random((count, self.discs)))
        return self.rows(share, self.angles(count, generator), generator.uniform(-1, 1, (count, len(self.axial))))

    def on_rims(self, count: int, generator: np.random.Generator) -> np.ndarray:
        """Each journal at the rims of its bearing and at a stop."""
        ends = generator.integers(0, 2, (count, len(self.axial))) * 2.0 - 1.0
        return self.rows(np.ones((count, self.discs)), self.angles(count, generator), ends)

    def angles(self, count: int, generator: np.random.Generator) -> np.ndarray:
        return generator.uniform(0, 2 * np.pi, (count, self.discs))

    def first_order(self, output: Output) -> float:
        """Largest value of the linear function with the derivatives of the output at the middle of all plays."""
        count = 2 * self.discs + len(self.axial)
        step = STEP_M
        moved = output(np.concatenate([np.eye(count), -np.eye(count)]) * step)
        gains = (moved[:count] - moved[count:]) / (2 * step)
        of_discs = np.linalg.norm(gains[: 2 * self.discs].reshape(-1, 2), axis=1)
        return float(of_discs @ self.radii + np.abs(gains[2 * self.discs :]) @ self.axial)

    def as_separate_tolerances(self, output: Output) -> float:
        """The sum where both coordinates of the offset, and both of the lean, of each journal count as tolerances of their own."""
        step, total = STEP_M, 0.0
        for k, clearance in enumerate(self.clearances):
            for pattern in ([1, 0, 1, 0], [0, 1, 0, 1], [-1, 0, 1, 0], [0, -1, 0, 1]):
                row = np.zeros((2, 2 * self.discs + len(self.axial)))
                row[0, 4 * k : 4 * k + 4] = np.array(pattern) * step
                row[1] = -row[0]
                ends = output(row)
                total += abs(ends[0] - ends[1]) / (2 * step) * clearance
        for k, clearance in enumerate(self.axial):
            row = np.zeros((2, 2 * self.discs + len(self.axial)))
            row[:, 2 * self.discs + k] = [step, -step]
            ends = output(row)
            total += abs(ends[0] - ends[1]) / (2 * step) * clearance
        return total

    def largest(self, output: Output, sign: float, starts: int, generator: np.random.Generator) -> tuple[float, float]:
        """Largest sign * output over all places of the journals, by a quasi-Newton method in polar coordinates from random starts; the
        best end, and how far the worst of the starts ended below it. Radii may be negative: a search that could not cross the middle
        of a disc would end there."""
        count = 2 * self.discs + len(self.axial)
        bounds = [(-1, 1)] * self.discs + [(None, None)] * self.discs + [(-1, 1)] * len(self.axial)
        unit = float(np.abs(output(self.on_rims(64, generator))).max())
        step = 1e-4  # of a clearance, of a radian

        def rows(numbers: np.ndarray) -> np.ndarray:
            return self.rows(numbers[:, : self.discs], numbers[:, self.discs : 2 * self.discs], numbers[:, 2 * self.discs :])

        def value(numbers: np.ndarray) -> tuple[float, np.ndarray]:
            moves = np.concatenate([np.zeros((1, count)), np.eye(count) * step, -np.eye(count) * step])
            found = -sign * output(rows(numbers + moves)) / unit
            return found[0], (found[1 : count + 1] - found[count + 1 :]) / (2 * step)

        ends = []
        for _ in range(starts):
            start = np.concatenate([generator.uniform(-1, 1, self.discs), generator.uniform(0, 2 * np.pi, self.discs),
                                    generator.uniform(-1, 1, len(self.axial))])
            options = {"ftol": 1e-15, "gtol": 1e-8, "maxiter": 1000}
            ends.append(minimize(value, start, jac=True, method="L-BFGS-B", bounds=bounds, options=options).fun)
        return -min(ends) * unit, (max(ends) - min(ends)) * unit

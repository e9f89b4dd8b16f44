"""The spherical platform of `loosepin new spherical-platform`, written anew from its sizes: three legs, twists along them."""

import numpy as np
from journals import ROUNDS, Plays, frame, inverse, journal, leaning

BASE_CONE, PLATFORM_CONE, LOWER_ARC, UPPER_ARC = np.radians([50.0, 55.0, 75.0, 80.0])
BASE_ARM, MIDDLE_ARM, PLATFORM_ARM = 0.2, 0.18, 0.15
CLEARANCE, LENGTH, AXIAL = 20e-6, 0.02, 30e-6
MOTORS = np.radians([116.105176, 107.677050, 120.084777])
START = np.array([0.1, -0.15, 0.2])  # rotation vector of the platform
LEGS = range(3)
PLAYS = Plays([CLEARANCE] * 9, [AXIAL] * 3)  # base, middle, platform of each leg; the bases have stops

X, Z = np.eye(3)[0], np.eye(3)[2]


def polar(cone: float, azimuth: float) -> np.ndarray:
    return np.array([np.sin(cone) * np.cos(azimuth), np.sin(cone) * np.sin(azimuth), np.cos(cone)])


def rotation(vector: np.ndarray) -> np.ndarray:
    angle = np.linalg.norm(vector)
    x, y, z = vector / angle
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * skew + (1 - np.cos(angle)) * skew @ skew


def arc(angle: float) -> np.ndarray:
    return np.array([np.sin(angle), 0.0, np.cos(angle)])


class Platform:
    """The platform at angles of its motors; its ideal pose is searched from `start`, a rotation vector."""

    def __init__(self, motors: np.ndarray = MOTORS, start: np.ndarray = START) -> None:
        self.motors, self.vector = motors, start
        azimuths = np.radians([0.0, 120.0, 240.0])
        bases = [polar(np.pi - BASE_CONE, azimuth) for azimuth in azimuths]
        self.bases = [frame(BASE_ARM * base, base, np.array([-np.sin(a), np.cos(a), 0.0])) for base, a in zip(bases, azimuths)]
        self.feet = [polar(PLATFORM_CONE, azimuth + np.pi / 3) for azimuth in azimuths]
        self.to_lower = inverse(frame([0, 0, BASE_ARM], Z, X))
        self.middle = frame(MIDDLE_ARM * arc(LOWER_ARC), arc(LOWER_ARC), X)
        self.to_upper = inverse(frame([0, 0, MIDDLE_ARM], Z, X))
        self.end = frame(PLATFORM_ARM * arc(UPPER_ARC), arc(UPPER_ARC), X)
        self.to_platform = [inverse(frame(PLATFORM_ARM * foot, foot, X)) for foot in self.feet]
        self.free = self.ideal()

    def ideal(self) -> np.ndarray:
        """Turns and slides of the two free joints of each leg, where nothing has play: the loops of the arcs, then both turns."""
        vector = self.vector
        middles = []
        for leg in LEGS:
            turn = np.array([[np.cos(self.motors[leg]), -np.sin(self.motors[leg]), 0],
                             [np.sin(self.motors[leg]), np.cos(self.motors[leg]), 0], [0, 0, 1]])
            middles.append(self.bases[leg][:3, :3] @ turn @ arc(LOWER_ARC))

        def gaps(vector: np.ndarray) -> np.ndarray:
            return np.array([middles[k] @ rotation(vector) @ self.feet[k] - np.cos(UPPER_ARC) for k in LEGS])

        for _ in range(60):
            jacobian = np.stack([(gaps(vector + h) - gaps(vector - h)) / 2e-6 for h in 1e-6 * np.eye(3)], axis=-1)
            vector = vector - np.linalg.solve(jacobian, gaps(vector))
        if not np.abs(gaps(vector)).max() < 1e-12:
            raise ValueError("the legs do not meet")
        self.vector, turned = vector, rotation(vector)
        free = np.zeros(12)
        nothing = np.zeros((1, 4))
        for leg in LEGS:
            lower = self.bases[leg] @ journal(nothing, np.zeros(1), LENGTH, self.motors[leg : leg + 1])[0] @ self.to_lower
            hinge = (lower @ self.middle)[:3, :3]
            foot = hinge.T @ turned @ self.feet[leg]  # in the frame of the middle bearing; the upper link turns its x-z plane there
            free[4 * leg] = np.arctan2(foot[1], foot[0])
            upper = lower @ self.middle @ journal(nothing, np.zeros(1), LENGTH, free[4 * leg : 4 * leg + 1])[0] @ self.to_upper
            seat, pin = (upper @ self.end)[:3, :3], turned @ np.linalg.inv(self.to_platform[leg])[:3, :3]
            relative = seat.T @ pin
            free[4 * leg + 2] = np.arctan2(relative[1, 0], relative[0, 0])
        return free

    def poses(self, rows: np.ndarray) -> np.ndarray:
        """Frames of the platform for each row of places of the journals: the legs are made to meet, by Newton's method."""
        count = len(rows)
        free = np.broadcast_to(self.free, (count, 12)).copy()
        none = np.zeros(count)
        lowers = []
        for leg in LEGS:
            held = journal(rows[:, 12 * leg : 12 * leg + 4], rows[:, 36 + leg], LENGTH, np.full(count, self.motors[leg]))
            lowers.append(self.bases[leg] @ held @ self.to_lower)
        for _ in range(ROUNDS):
            ends, twists = [], []
            for leg in LEGS:
                here, columns = lowers[leg], []
                for joint, (bearing, to_next) in enumerate([(self.middle, self.to_upper), (self.end, self.to_platform[leg])]):
                    at = 12 * leg + 4 + 4 * joint
                    seat = here @ bearing
                    turn, slide = free[:, 4 * leg + 2 * joint], free[:, 4 * leg + 2 * joint + 1]
                    pin = seat @ journal(rows[:, at : at + 4], slide, LENGTH, none)
                    axis, at_point = pin[:, :3, 2], pin[:, :3, 3]
                    slope = (rows[:, at + 2 : at + 4] - rows[:, at : at + 2]) / LENGTH
                    stretch = np.sqrt(1 + np.sum(slope**2, axis=1))[:, None]
                    turned = np.zeros((count, 4, 4))
                    turned[:, :3, :3] = leaning(np.zeros((count, 2)), turn)
                    turned[:, 3, 3] = 1.0
                    here = pin @ turned @ to_next
                    columns += [np.concatenate([-np.cross(axis, at_point), axis], axis=1),
                                np.concatenate([axis * stretch, np.zeros((count, 3))], axis=1)]
                ends.append(here)
                twists.append(np.stack(columns, axis=-1))  # velocity at the origin, angular velocity
            gaps, jacobian = np.zeros((count, 12)), np.zeros((count, 12, 12))
            for pair in (1, 2):
                between = np.swapaxes(ends[0][:, :3, :3], 1, 2) @ ends[pair][:, :3, :3]
                skew = np.stack([between[:, 2, 1] - between[:, 1, 2], between[:, 0, 2] - between[:, 2, 0],
                                 between[:, 1, 0] - between[:, 0, 1]], axis=-1) / 2
                at = slice(6 * pair - 6, 6 * pair)
                gaps[:, at.start : at.start + 3] = ends[pair][:, :3, 3] - ends[0][:, :3, 3]
                gaps[:, at.start + 3 : at.stop] = np.einsum("nij,nj->ni", ends[0][:, :3, :3], skew)
                for leg, sign in ((0, -1.0), (pair, 1.0)):
                    moved = twists[leg].copy()
                    moved[:, :3] += np.cross(twists[leg][:, 3:], ends[leg][:, :3, 3, None], axis=1)
                    jacobian[:, at, 4 * leg : 4 * leg + 4] = sign * moved
            free -= np.linalg.solve(jacobian, gaps[..., None])[..., 0]
        self.left = float(np.abs(gaps).max())
        return ends[0]

    def centre_z(self, rows: np.ndarray) -> np.ndarray:
        return self.poses(rows)[:, 2, 3]

    def centre_x(self, rows: np.ndarray) -> np.ndarray:
        return self.poses(rows)[:, 0, 3]

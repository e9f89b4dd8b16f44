"""What random places of the journals reach of the worst case, for the spherical platform and the six-axis arm.

    python3 tools/compare/space/sampling.py
"""

import numpy as np
import six_axis_arm
import spherical_platform
from journals import Output, Plays

SIZES = (1_000, 10_000, 100_000)
DRAWN = 100_000  # in all; a size has as many repetitions as fit
STARTS = 8


def reached(values: np.ndarray, size: int, worst: float) -> str:
    shares = values.reshape(-1, size).max(axis=1) / worst
    return f"{100 * shares.mean():5.1f} %"


def show(name: str, plays: Plays, output: Output) -> None:
    generator = np.random.default_rng(1)
    middle = output(np.zeros((1, len(plays.axial) + 2 * plays.discs)))[0]

    def deviation(rows: np.ndarray) -> np.ndarray:
        return output(rows) - middle

    up, spread_up = plays.largest(deviation, 1.0, STARTS, generator)
    down, spread_down = plays.largest(deviation, -1.0, STARTS, generator)
    print(f"{name}: {len(plays.clearances)} joints, {len(plays.axial) + 2 * plays.discs} numbers say where the journals are")
    print(f"  first order        {1e6 * plays.first_order(deviation):9.3f} um")
    spread = 1e6 * max(spread_up, spread_down)
    print(f"  exact, up and down {1e6 * up:9.3f} um {-1e6 * down:9.3f} um; {STARTS} searches each end within {spread:.0e} um")
    drawn = {"anywhere": plays.anywhere(DRAWN, generator), "on the rims": plays.on_rims(DRAWN, generator)}
    for places, rows in drawn.items():
        values = np.concatenate([deviation(part) for part in np.array_split(rows, 20)])
        shares = "  ".join(f"{size:7,}: {reached(values, size, up)}" for size in SIZES)
        print(f"  random, {places:12} {shares};  three standard deviations {100 * 3 * values.std() / up:5.1f} %")
    separate = plays.as_separate_tolerances(deviation)
    print(f"  x and y, offset and lean as separate tolerances {1e6 * separate:9.3f} um, {100 * separate / up:5.1f} %")


show("spherical platform, centre along z", spherical_platform.PLAYS, spherical_platform.Platform().centre_z)
show("six-axis arm, height of the tip at 1 s", six_axis_arm.PLAYS, six_axis_arm.height)

"""Makes indicator_diagram.csv: the pressure in the cylinder of a small four-stroke engine over two turns of its crank.

Calculated, not measured: one zone of ideal gas, polytropic compression and expansion, heat by Wiebe's function
x = 1 - exp(-5 s^3) over 50 degrees, and a gas exchange in which the pressure goes to that of the manifold. 0 degrees
is the top dead centre of ignition.
"""

import math
from pathlib import Path

BORE_M, CRANK_M, ROD_M, COMPRESSION = 0.080, 0.040, 0.140, 9.5
GAMMA = 1.32  # ratio of the heat capacities
HEAT_J = 680.0  # of a cycle
IGNITION_DEG, DURATION_DEG = -12.0, 50.0
INTAKE_CLOSES_DEG, EXHAUST_OPENS_DEG = -140.0, 130.0
INTAKE_BAR, EXHAUST_BAR = 0.93, 1.09
BLOW_DOWN_DEG, CHANGE_DEG = 16.0, 20.0  # angles in which the difference to the manifold falls to 1/e
STEP_DEG = 0.05
ROW_DEG = 2

AREA_M2 = math.pi / 4 * BORE_M**2
CLEARANCE_M3 = AREA_M2 * 2 * CRANK_M / (COMPRESSION - 1)


def volume_m3(angle_deg):
    angle = math.radians(angle_deg)
    reach_m = CRANK_M * math.cos(angle) + math.sqrt(ROD_M**2 - (CRANK_M * math.sin(angle)) ** 2)
    return CLEARANCE_M3 + AREA_M2 * (CRANK_M + ROD_M - reach_m)


def burnt(angle_deg):
    share = (angle_deg - IGNITION_DEG) / DURATION_DEG
    return 0.0 if share <= 0.0 else 1.0 - math.exp(-5.0 * share**3)


def pressures_bar():
    """Pressure at every STEP_DEG from the closing of the intake valve on, over 720 degrees."""
    result = {}
    pressure, volume = INTAKE_BAR, volume_m3(INTAKE_CLOSES_DEG)
    for step in range(round(720 / STEP_DEG)):
        angle = INTAKE_CLOSES_DEG + step * STEP_DEG
        result[round(angle / STEP_DEG)] = pressure
        new = volume_m3(angle + STEP_DEG)
        if angle < EXHAUST_OPENS_DEG:
            heat_bar = (GAMMA - 1) * HEAT_J * (burnt(angle + STEP_DEG) - burnt(angle)) / (0.5 * (volume + new)) * 1e-5
            pressure = pressure * (volume / new) ** GAMMA + heat_bar
        else:
            goal, within = (EXHAUST_BAR, BLOW_DOWN_DEG) if angle < 355.0 else (INTAKE_BAR, CHANGE_DEG)
            pressure = goal + (pressure - goal) * math.exp(-STEP_DEG / within)
        volume = new
    return result


def main():
    pressure = pressures_bar()
    period = round(720 / STEP_DEG)
    rows = []
    for angle in range(-360, 360, ROW_DEG):
        step = round(angle / STEP_DEG)
        rows.append((angle, pressure[step] if step in pressure else pressure[step + period]))
    lines = [
        "# Calculated, not measured: made by make_diagram.py with Wiebe's function and polytropic changes of state.",
        "# 0 deg is the top dead centre of ignition; after 720 deg the cycle begins again.",
        "crank angle [deg], pressure [bar]",
        *(f"{angle}, {pressure:.4f}" for angle, pressure in rows),
    ]
    (Path(__file__).parent / "indicator_diagram.csv").write_text("\n".join(lines) + "\n")
    highest = max(rows, key=lambda row: row[1])
    print(f"{len(rows)} rows, highest {highest[1]:.1f} bar at {highest[0]} deg")


if __name__ == "__main__":
    main()

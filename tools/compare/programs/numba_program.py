"""Dormand and Prince's pair with located contacts, hand-written equations, compiled by numba: cpp_program.cpp in Python."""

import hashlib
import math
from pathlib import Path

import numba
import numpy as np

from model import CASE, Model

# Constants of the model are compiled in, so a kept compilation belongs to one text of these files.
_texts = b"".join(path.read_bytes() for path in [CASE / "model.toml", *sorted(Path(__file__).parent.glob("*.py"))])
numba.config.CACHE_DIR = str(Path(__file__).parents[1] / f"build/numba-{hashlib.sha256(_texts).hexdigest()[:12]}")

import program  # noqa: E402

MODEL = Model.read()
ALLOWED_ERROR = 1e-7
FIRST_STEP_S = 1e-6
LARGEST_STEP_S = 1e-4

R = MODEL.crank_length_m
L = MODEL.rod_length_m
SPEED_RAD_S = MODEL.crank_speed_rad_s
PIN_M_S2 = SPEED_RAD_S**2 * R
GRAVITY_M_S2 = MODEL.gravity_m_s2
ROD_MOMENT_KG_M = MODEL.rod_mass_kg * MODEL.rod_centre_m
ROD_INVERSE_INERTIA = 1.0 / (MODEL.rod_inertia_kg_m2 + MODEL.rod_mass_kg * MODEL.rod_centre_m**2)
SLIDER_INVERSE_MASS = 1.0 / MODEL.slider_mass_kg
DAMPING_FACTOR = 0.75 * (1.0 - MODEL.restitution**2)
SMALLEST_IMPACT_SPEED_M_S = MODEL.smallest_impact_speed_m_s
TURN_S = MODEL.turn_s

State = tuple[float, float, float, float]  # angle of the rod, x of the slider, their rates
Contact = tuple[float, float, float]  # stiffness (zero in flight), clearance, χ/v0

compiled = numba.njit(cache=True, fastmath=True, error_model="numpy")
inlined = numba.njit(cache=True, fastmath=True, error_model="numpy", inline="always")


@inlined
def eccentricity(time_s: float, y: State) -> tuple[float, float, float, float, float, float, float, float]:
    """Journal (slider) minus bearing (rod), its rate, and the sines and cosines of crank and rod."""
    crank_sine, crank_cosine = math.sin(SPEED_RAD_S * time_s), math.cos(SPEED_RAD_S * time_s)
    rod_sine, rod_cosine = math.sin(y[0]), math.cos(y[0])
    x_m = y[1] - R * crank_cosine - L * rod_cosine
    y_m = -R * crank_sine - L * rod_sine
    x_m_s = y[3] + R * SPEED_RAD_S * crank_sine + L * y[2] * rod_sine
    y_m_s = -R * SPEED_RAD_S * crank_cosine - L * y[2] * rod_cosine
    return x_m, y_m, x_m_s, y_m_s, crank_sine, crank_cosine, rod_sine, rod_cosine


@inlined
def derivative(time_s: float, y: State, contact: Contact) -> State:
    """The right-hand side."""
    x_m, y_m, x_m_s, y_m_s, crank_sine, crank_cosine, rod_sine, rod_cosine = eccentricity(time_s, y)
    stiffness, clearance_m, damping_s_m = contact
    force_x_n = force_y_n = 0.0  # on the rod; the slider gets the opposite
    if stiffness > 0.0:
        length_m = math.sqrt(x_m * x_m + y_m * y_m)
        depth_m = length_m - clearance_m
        if depth_m > 0.0:
            depth_m_s = (x_m * x_m_s + y_m * y_m_s) / length_m
            normal_n = stiffness * depth_m * math.sqrt(depth_m) * (1.0 + damping_s_m * depth_m_s)
            force_x_n = max(normal_n, 0.0) / length_m * x_m
            force_y_n = max(normal_n, 0.0) / length_m * y_m
    moment_n_m = ROD_MOMENT_KG_M * (
        (PIN_M_S2 * crank_sine - GRAVITY_M_S2) * rod_cosine - PIN_M_S2 * crank_cosine * rod_sine
    ) + L * (rod_cosine * force_y_n - rod_sine * force_x_n)
    return y[2], y[3], moment_n_m * ROD_INVERSE_INERTIA, -force_x_n * SLIDER_INVERSE_MASS


@inlined
def gap(time_s: float, y: State, clearance_m: float) -> tuple[float, float]:
    """|e|² - c² and half its rate."""
    x_m, y_m, x_m_s, y_m_s, _, _, _, _ = eccentricity(time_s, y)
    return x_m * x_m + y_m * y_m - clearance_m * clearance_m, x_m * x_m_s + y_m * y_m_s


@inlined
def moved(y: State, h: float, a: float, k: State) -> State:
    """y + h a k."""
    b = h * a
    return y[0] + b * k[0], y[1] + b * k[1], y[2] + b * k[2], y[3] + b * k[3]


@inlined
def moved2(y: State, h: float, a: float, k: State, b: float, m: State) -> State:
    """y + h (a k + b m)."""
    return moved(moved(y, h, a, k), h, b, m)


@inlined
def attempt(time_s: float, h: float, y: State, k1: State, contact: Contact):
    """One step: its end, the slopes of its stages, its error over the allowed one."""
    k2 = derivative(time_s + h / 5.0, moved(y, h, 1.0 / 5.0, k1), contact)
    k3 = derivative(time_s + h * (3.0 / 10.0), moved2(y, h, 3.0 / 40.0, k1, 9.0 / 40.0, k2), contact)
    y4 = moved(moved2(y, h, 44.0 / 45.0, k1, -56.0 / 15.0, k2), h, 32.0 / 9.0, k3)
    k4 = derivative(time_s + h * (4.0 / 5.0), y4, contact)
    y5 = moved2(y, h, 19372.0 / 6561.0, k1, -25360.0 / 2187.0, k2)
    y5 = moved2(y5, h, 64448.0 / 6561.0, k3, -212.0 / 729.0, k4)
    k5 = derivative(time_s + h * (8.0 / 9.0), y5, contact)
    y6 = moved(moved2(y, h, 9017.0 / 3168.0, k1, -355.0 / 33.0, k2), h, 46732.0 / 5247.0, k3)
    y6 = moved2(y6, h, 49.0 / 176.0, k4, -5103.0 / 18656.0, k5)
    k6 = derivative(time_s + h, y6, contact)
    end = moved(moved2(y, h, 35.0 / 384.0, k1, 500.0 / 1113.0, k3), h, 125.0 / 192.0, k4)
    end = moved2(end, h, -2187.0 / 6784.0, k5, 11.0 / 84.0, k6)
    k7 = derivative(time_s + h, end, contact)
    defect = moved2((0.0, 0.0, 0.0, 0.0), h, 71.0 / 57600.0, k1, -71.0 / 16695.0, k3)
    defect = moved2(defect, h, 71.0 / 1920.0, k4, -17253.0 / 339200.0, k5)
    defect = moved2(defect, h, 22.0 / 525.0, k6, -1.0 / 40.0, k7)
    return end, k3, k4, k5, k6, k7, error_over_allowed(defect, y, end)


@inlined
def error_over_allowed(defect: State, start: State, end: State) -> float:
    """Root mean square of the defects over what is allowed."""
    a = defect[0] / (1.0 + max(abs(start[0]), abs(end[0])))
    b = defect[1] / (1.0 + max(abs(start[1]), abs(end[1])))
    c = defect[2] / (1.0 + max(abs(start[2]), abs(end[2])))
    d = defect[3] / (1.0 + max(abs(start[3]), abs(end[3])))
    return math.sqrt(0.25 * (a * a + b * b + c * c + d * d)) / ALLOWED_ERROR


@inlined
def fill_extension(table, h: float, start: State, end: State, k1: State, k3, k4, k5, k6, k7) -> None:
    """Coefficients of the continuous extension, a row for each entry of the state."""
    for i in range(4):
        difference = end[i] - start[i]
        bump = h * k1[i] - difference
        table[i, 0] = start[i]
        table[i, 1] = difference
        table[i, 2] = bump
        table[i, 3] = difference - h * k7[i] - bump
        table[i, 4] = h * (
            (-12715105075.0 / 11282082432.0) * k1[i]
            + (87487479700.0 / 32700410799.0) * k3[i]
            - (10690763975.0 / 1880347072.0) * k4[i]
            + (701980252875.0 / 199316789632.0) * k5[i]
            - (1453857185.0 / 822651844.0) * k6[i]
            + (69997945.0 / 29380423.0) * k7[i]
        )


@inlined
def extension(table, i: int, share: float) -> float:
    """Entry i of the state within a step."""
    rest = 1.0 - share
    return table[i, 0] + share * (
        table[i, 1] + rest * (table[i, 2] + share * (table[i, 3] + rest * table[i, 4]))
    )


@inlined
def state_at(table, share: float) -> State:
    """The state within a step."""
    return extension(table, 0, share), extension(table, 1, share), extension(table, 2, share), extension(table, 3, share)


@compiled
def top_of_gap(time_s: float, h: float, sign: float, table, clearance_m: float) -> float:
    """A share of the step where a touch that begins and ends inside it is seen; 2 where there is none."""
    left, right = 0.0, 1.0
    while right - left > 1e-6:
        middle = 0.5 * (left + right)
        square_m2, half_rate_m2_s = gap(time_s + middle * h, state_at(table, middle), clearance_m)
        if sign * square_m2 > 0.0:
            return middle
        if sign * half_rate_m2_s > 0.0:
            left = middle
        else:
            right = middle
    return 2.0


@compiled
def event_share(time_s: float, h: float, sign: float, start, end, table, clearance_m: float) -> float:
    """Where in the step the contact changes, as a share of the step; 2 where it does not."""
    low, high = 0.0, 1.0
    if not sign * end[0] > 0.0:
        if not (sign * start[1] > 0.0 and sign * end[1] < 0.0):
            return 2.0
        high = top_of_gap(time_s, h, sign, table, clearance_m)
        if high > 1.0:
            return 2.0
    # Newton's iteration, kept inside the bracket.
    share = high * start[0] / (start[0] - end[0]) if sign * start[0] < 0.0 else 0.5 * high
    if not (low < share < high):
        share = 0.5 * high
    for _ in range(60):
        square_m2, half_rate_m2_s = gap(time_s + share * h, state_at(table, share), clearance_m)
        if sign * square_m2 > 0.0:
            high = share
        else:
            low = share
        following = share - square_m2 / (2.0 * h * half_rate_m2_s)
        if not (low < following < high):
            following = 0.5 * (low + high)
        change = abs(following - share)
        share = following
        if change < 1e-13:
            break
    return share


@compiled
def integrate(clearance_m: float, stiffness: float, interval_s: float, readings: int) -> np.ndarray:
    """Positions of the slider at the ends of the intervals, after that at the start."""
    values, table = np.empty(readings + 1), np.empty((4, 5))
    time_s, end_s = 0.0, interval_s * readings
    y = (0.0, R + L, -SPEED_RAD_S * R / L, 0.0)
    values[0] = y[1]
    reading = 1
    contact = (0.0, clearance_m, 0.0)
    k1 = derivative(time_s, y, contact)
    start_gap = gap(time_s, y, clearance_m)
    step_s = after_onset_s = after_end_s = FIRST_STEP_S
    last_event = 0
    while reading <= readings:
        h = min(step_s, LARGEST_STEP_S, end_s - time_s)
        end, k3, k4, k5, k6, k7, error = attempt(time_s, h, y, k1, contact)
        if not error <= 1.0:
            if not h > 1e-18:
                raise FloatingPointError("the step has become too small")
            step_s = h * max(0.2, 0.9 * error**-0.2)
            continue
        end_gap = gap(time_s + h, end, clearance_m)
        fill_extension(table, h, y, end, k1, k3, k4, k5, k6, k7)
        sign = -1.0 if contact[0] > 0.0 else 1.0
        share = event_share(time_s, h, sign, start_gap, end_gap, table, clearance_m)
        taken_s = share * h if share < 1.0 else h
        reached_s = end_s if end_s - (time_s + taken_s) < 1e-15 else time_s + taken_s
        while reading <= readings and interval_s * reading <= reached_s:
            values[reading] = extension(table, 1, (interval_s * reading - time_s) / h)
            reading += 1
        time_s = reached_s
        if share < 1.0:
            y = state_at(table, share)
            start_gap = gap(time_s, y, clearance_m)
            if contact[0] > 0.0:
                contact = (0.0, clearance_m, 0.0)
                step_s, last_event = after_end_s, 2
            else:
                speed_m_s = max(start_gap[1] / clearance_m, SMALLEST_IMPACT_SPEED_M_S)
                contact = (stiffness, clearance_m, DAMPING_FACTOR / speed_m_s)
                step_s, last_event = after_onset_s, 1
            k1 = derivative(time_s, y, contact)
            continue
        if last_event == 1:
            after_onset_s = h
        elif last_event == 2:
            after_end_s = h
        last_event = 0
        y, k1, start_gap = end, k7, end_gap
        step_s = h * min(6.0, 0.9 * max(error, 1e-10) ** -0.2)
    return values


def run(clearance_m: float) -> np.ndarray:
    """Positions of the slider at the reading times, m."""
    compliance = (1.0 - MODEL.poisson_ratio**2) / MODEL.youngs_modulus_pa
    radii_m = MODEL.bearing_radius_m * (MODEL.bearing_radius_m - clearance_m) / clearance_m
    stiffness = 4.0 / (3.0 * 2.0 * compliance) * math.sqrt(radii_m)
    readings = program.TURNS * program.READINGS_PER_TURN
    return integrate(clearance_m, stiffness, TURN_S / program.READINGS_PER_TURN, readings)


if __name__ == "__main__":
    program.main(run)

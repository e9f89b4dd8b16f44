"""Parts of one run as plain records: motion of pins, spectra, comparisons with measurements."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from .._objects.arrays import read_only
from .._objects.records import Record
from .._records import Array, numbers


@dataclass(frozen=True, eq=False, repr=False)
class BodyStates(Record):
    """Motion of the centre of mass of a body; all arrays have one entry for each row of the history.

    Of a flexible body it is the motion of the middle of its straight frame.
    """

    x_m: Array
    y_m: Array
    angle_rad: Array
    vx_m_s: Array
    vy_m_s: Array
    omega_rad_s: Array
    ax_m_s2: Array
    ay_m_s2: Array
    alpha_rad_s2: Array


STATE_UNITS = {
    "x_m": "m",
    "y_m": "m",
    "angle_rad": "rad",
    "vx_m_s": "m/s",
    "vy_m_s": "m/s",
    "omega_rad_s": "rad/s",
    "ax_m_s2": "m/s^2",
    "ay_m_s2": "m/s^2",
    "alpha_rad_s2": "rad/s^2",
}
"""SI unit of each array of `BodyStates`."""


@dataclass(frozen=True, eq=False, repr=False)
class Orbit(Record):
    """Path of the centre of a pin in the frame of its bearing; both arrays have one entry for each row of the history."""

    joint: str
    """Name of the joint."""
    radial_clearance_m: float
    """The circle that the path stays in, but for penetration."""
    x_m: Array
    """From the centre of the bearing."""
    y_m: Array
    """From the centre of the bearing."""

    @property
    def eccentricity_m(self) -> Array:
        """Distances from the centre of the bearing."""
        return read_only(np.hypot(self.x_m, self.y_m))


@dataclass(frozen=True, eq=False, repr=False)
class Spectrum(Record):
    """Oscillations over orders of the drive, which are waves in a turn; the arrays have one entry for each order.

    It is that of the last whole turns, eight at most. The amplitudes are those of a motion that repeats itself over these turns.
    """

    of: str
    """Name of the output, or of a contact force: "gudgeon.contact_force"."""
    unit: str
    """SI unit of the amplitudes."""
    order: Array
    """Orders above 0, increasing."""
    frequency_hz: Array
    """Their frequencies."""
    amplitude: Array
    """Their amplitudes, in `unit`."""
    mean: float
    """Mean of the values, in `unit`."""
    rms: float
    """Root mean square of the values, the mean included."""
    peak: float
    """Largest magnitude of the values."""


@dataclass(frozen=True, eq=False, repr=False)
class Lyapunov(Record):
    """The largest Lyapunov exponent: two motions that differ by next to nothing part, or meet, as exp(exponent * time)."""

    exponent_1_s: float
    """The exponent, 1/s: the mean over the turns."""
    standard_error_1_s: float
    """Its standard error, from the means of 20 batches of turns."""
    interval_1_s: tuple[float, float]
    """The interval that holds the exponent with 95 % confidence."""
    kind: str
    """"part", "meet", or "undecided" where the exponent is compatible with zero."""
    turn_s: float
    """Duration of a turn."""
    growth: Array
    """Logarithm of the growth of the separation in each turn that counts."""


@dataclass(frozen=True, eq=False, repr=False)
class MeasuredCurve(Record):
    """A measured curve beside the computed one; all arrays have one entry for each measured value."""

    file: str
    """The file, as its path was given."""
    output: str
    """Name of the output."""
    unit: str
    """SI unit of the values."""
    abscissa: str
    """Quantity of `at`: "time" in s, or "drive_angle" in rad."""
    at: Array
    """Times since the start of the run, or angles of the drive, moved by whole turns into the recorded ones."""
    measured: Array
    """Measured values."""
    computed: Array
    """Computed values at the same places, between the rows of the history."""
    rms: float
    """Root mean square of `residual`."""

    @property
    def residual(self) -> Array:
        """Measured minus computed."""
        return read_only(self.measured - self.computed)


def body_states(history: Mapping[str, Array], outputs: int) -> dict[str, BodyStates]:
    """Motion of each body by name, from the columns of the history behind the first `outputs`: `coupler.x_m` and so on."""
    columns: dict[str, dict[str, Array]] = {}
    for name, values in list(history.items())[outputs:]:
        body, _, part = name.rpartition(".")
        columns.setdefault(body, {})[part] = values
    return {body: BodyStates(**parts) for body, parts in columns.items()}


def spectra(native: Iterable[tuple[str, str, list[Array], list[float]]]) -> dict[str, Spectrum]:
    """The columns of `spectrum.csv` by what they are of."""
    found = {}
    for of, unit, (order, frequency_hz, amplitude), (mean, rms, peak) in native:
        found[of] = Spectrum(of, unit, read_only(order), read_only(frequency_hz), read_only(amplitude), mean, rms, peak)
    return found


def lyapunov(record: dict[str, Any] | None) -> Lyapunov | None:
    """The exponent of `summary.json`."""
    if record is None:
        return None
    return Lyapunov(
        exponent_1_s=float(record["exponent_1_s"]),
        standard_error_1_s=float(record["standard_error_1_s"]),
        interval_1_s=(float(record["lower_1_s"]), float(record["upper_1_s"])),
        kind=record["kind"],
        turn_s=float(record["turn_s"]),
        growth=numbers(record["growth"]),
    )


def measured_curves(records: Iterable[dict[str, Any]]) -> tuple[MeasuredCurve, ...]:
    """The measured curves of `summary.json`."""
    return tuple(
        MeasuredCurve(
            file=record["file"],
            output=record["output"],
            unit=record["unit"],
            abscissa=record["abscissa"],
            at=numbers(record["at_si"]),
            measured=numbers(record["measured_si"]),
            computed=numbers(record["computed_si"]),
            rms=float(record["rms_si"]),
        )
        for record in records
    )

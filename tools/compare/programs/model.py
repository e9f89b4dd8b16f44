"""The numbers of `cases/slider_crank_5000/model.toml`, in SI, for programs that cannot read the file themselves."""

import dataclasses
import math
import tomllib
from dataclasses import dataclass
from pathlib import Path

CASE = Path(__file__).resolve().parents[3] / "cases/slider_crank_5000"

UNITS = {
    "m": 1.0,
    "mm": 1e-3,
    "kg": 1.0,
    "kg m^2": 1.0,
    "m/s^2": 1.0,
    "GPa": 1e9,
    "rpm": math.tau / 60.0,
}

# Not in the file: the smallest impact speed that the library takes by default.
SMALLEST_IMPACT_SPEED_M_S = 1e-3


def to_si(text: str) -> float:
    """The value of `text`, a number and one of `UNITS`."""
    number, unit = text.split(" ", 1)
    if unit not in UNITS:
        raise ValueError(f"'{text}': the unit '{unit}' is not known here; known are {', '.join(UNITS)}")
    return float(number) * UNITS[unit]


@dataclass(frozen=True)
class Model:
    """The slider-crank: SI units; centres of mass as distances along the part."""

    gravity_m_s2: float
    crank_length_m: float
    crank_mass_kg: float
    crank_speed_rad_s: float
    rod_length_m: float
    rod_mass_kg: float
    rod_centre_m: float
    rod_inertia_kg_m2: float
    slider_mass_kg: float
    bearing_radius_m: float
    clearance_m: float
    youngs_modulus_pa: float
    poisson_ratio: float
    restitution: float
    smallest_impact_speed_m_s: float

    @classmethod
    def read(cls) -> "Model":
        """Reads the file of the case."""
        tables = tomllib.loads((CASE / "model.toml").read_text(encoding="utf-8"))
        body, contact = tables["body"], tables["contact"]["steel_pin"]
        gudgeon = tables["joint"]["gudgeon"]
        rod_length_m = to_si(tables["parameter"]["rod_length"])
        if body["rod"]["centre_of_mass"] != ["rod_length / 2", "0 mm"]:
            raise ValueError("the rod's centre of mass is expected at 'rod_length / 2'")
        return cls(
            gravity_m_s2=to_si(tables["gravity"]),
            crank_length_m=to_si(tables["parameter"]["crank_length"]),
            crank_mass_kg=to_si(body["crank"]["mass"]),
            crank_speed_rad_s=to_si(tables["drive"]["crank"]["speed"]),
            rod_length_m=rod_length_m,
            rod_mass_kg=to_si(body["rod"]["mass"]),
            rod_centre_m=rod_length_m / 2.0,
            rod_inertia_kg_m2=to_si(body["rod"]["inertia"]),
            slider_mass_kg=to_si(body["slider"]["mass"]),
            bearing_radius_m=to_si(gudgeon["bearing_radius"]),
            clearance_m=to_si(gudgeon["radial_clearance"]),
            youngs_modulus_pa=to_si(contact["youngs_modulus"]),
            poisson_ratio=contact["poisson_ratio"],
            restitution=contact["restitution"],
            smallest_impact_speed_m_s=SMALLEST_IMPACT_SPEED_M_S,
        )

    @property
    def turn_s(self) -> float:
        """Duration of a turn of the crank, s."""
        return math.tau / self.crank_speed_rad_s

    def as_header(self) -> str:
        """The numbers as constants of C++."""
        lines = (f"constexpr double {name.upper()} = {value!r};" for name, value in dataclasses.asdict(self).items())
        return "#pragma once\n" + "\n".join(lines) + "\n"

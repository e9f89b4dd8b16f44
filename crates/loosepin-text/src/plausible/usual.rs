//! Ranges in which numbers of models usually lie, by their keys.

use crate::units::Dimension;

/// The usual range of a number.
pub(super) struct UsualRange {
    /// Ends of paths that name it.
    pub keys: &'static [&'static str],
    /// Dimension of its value.
    pub dimension: Dimension,
    /// Smallest and largest usual magnitude, SI; zero is usual too.
    pub range: [f64; 2],
    /// The range in words.
    pub words: &'static str,
    /// Units that are taken for one another: written, meant.
    pub units: &'static [(&'static str, &'static str)],
    /// Factors by which a number without a unit is off.
    pub factors: &'static [f64],
}

/// The usual ranges.
pub(super) static USUAL_RANGES: &[UsualRange] = &[
    UsualRange {
        keys: &[".youngs_modulus", ".bearing_youngs_modulus", ".journal_youngs_modulus"],
        dimension: Dimension::PRESSURE,
        range: [1e9, 1.3e12],
        words: "1 GPa (plastics) to 1300 GPa (diamond)",
        units: &[("MPa", "GPa"), ("N/mm^2", "GPa"), ("kPa", "GPa"), ("Pa", "GPa"), ("GPa", "MPa"), ("bar", "GPa")],
        factors: &[1e-3, 1e3],
    },
    UsualRange {
        keys: &[".poisson_ratio", ".bearing_poisson_ratio", ".journal_poisson_ratio"],
        dimension: Dimension::NUMBER,
        range: [0.1, 0.49],
        words: "0.1 to 0.49; metals have 0.2 to 0.45",
        units: &[],
        factors: &[10.0],
    },
    UsualRange {
        keys: &[".density"],
        dimension: Dimension::DENSITY,
        range: [100.0, 23_000.0],
        words: "100 kg/m^3 (foams) to 23000 kg/m^3 (osmium)",
        units: &[
            ("kg/m^3", "g/cm^3"),
            ("kg/m^3", "g/m^3"),
            ("g/m^3", "kg/m^3"),
            ("kg/dm^3", "kg/m^3"),
            ("g/cm^3", "kg/m^3"),
        ],
        factors: &[],
    },
    UsualRange {
        keys: &[".thermal_expansion"],
        dimension: Dimension::THERMAL_EXPANSION,
        range: [1e-7, 4e-4],
        words: "1e-7 1/K (glass ceramics) to 4e-4 1/K (rubber); steels have 1.2e-5 1/K",
        units: &[],
        factors: &[1e-6],
    },
    UsualRange {
        keys: &["temperature_rise"],
        dimension: Dimension::TEMPERATURE,
        range: [0.0, 1500.0],
        words: "up to 1500 K",
        units: &[],
        factors: &[],
    },
    UsualRange {
        keys: &[".viscosity"],
        dimension: Dimension::VISCOSITY,
        range: [1e-5, 10.0],
        words: "1e-5 Pa s (air) to 10 Pa s (gear oil in the cold)",
        units: &[("Pa s", "mPa s"), ("mPa s", "Pa s"), ("Pa s", "cP")],
        factors: &[],
    },
    UsualRange {
        keys: &[".coefficient", ".static_coefficient"],
        dimension: Dimension::NUMBER,
        range: [0.0, 2.0],
        words: "0.001 (oil) to 1 (dry)",
        units: &[],
        factors: &[0.01],
    },
    UsualRange {
        keys: &[".speed"],
        dimension: Dimension::ANGULAR_VELOCITY,
        range: [0.0, 2000.0],
        words: "up to 19100 rpm (2000 rad/s)",
        units: &[("rad/s", "rpm"), ("rad/s", "deg/s"), ("Hz", "rpm"), ("rev/s", "rpm"), ("rpm", "deg/s")],
        factors: &[],
    },
    UsualRange {
        keys: &[".speed"],
        dimension: Dimension::VELOCITY,
        range: [0.0, 100.0],
        words: "up to 100 m/s",
        units: &[("m/s", "mm/s")],
        factors: &[],
    },
    UsualRange {
        keys: &[".minimum_impact_speed"],
        dimension: Dimension::VELOCITY,
        range: [1e-9, 1.0],
        words: "up to 1 m/s; slower impacts lose energy as impacts of this speed do",
        units: &[("m/s", "mm/s"), ("m/s", "um/s"), ("cm/s", "mm/s")],
        factors: &[],
    },
    UsualRange {
        keys: &[".mass"],
        dimension: Dimension::MASS,
        range: [1e-9, 1e7],
        words: "1e-9 kg (1 µg) to 1e7 kg (10000 t)",
        units: &[("kg", "g"), ("t", "kg"), ("g", "kg")],
        factors: &[],
    },
    UsualRange {
        keys: &["gravity"],
        dimension: Dimension::ACCELERATION,
        range: [0.1, 100.0],
        words: "9.81 m/s^2 on earth, up to 100 m/s^2 elsewhere",
        units: &[("m/s^2", "mm/s^2"), ("mm/s^2", "m/s^2")],
        factors: &[],
    },
];

impl UsualRange {
    /// Whether it is the range of the number at `path`.
    pub fn is_of(&self, path: &str, dimension: Dimension) -> bool {
        self.dimension == dimension && self.keys.iter().any(|key| path.ends_with(key))
    }

    /// Whether a value is usual.
    pub fn holds(&self, value_si: f64) -> bool {
        let [least, most] = self.range;
        value_si == 0.0 || (least..=most).contains(&value_si.abs())
    }
}

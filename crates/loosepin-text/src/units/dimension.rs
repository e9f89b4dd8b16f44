//! Dimensions: exponents of length, mass, time, angle and temperature.

use std::fmt;

/// Two exponents closer than this are the same: they are sums of a few decimal fractions.
const EXPONENT_TOLERANCE: f64 = 1e-9;

/// The dimension of a quantity, as exponents of metre, kilogram, second, radian and kelvin.
///
/// Exponents need not be whole (`N/m^1.5`). The angle is counted although SI calls the radian 1, so that a bare number
/// is not taken for an angle; a product such as `speed * radius` therefore carries it until divided by `1 rad`.
#[derive(Debug, Clone, Copy)]
pub struct Dimension {
    /// Exponent of the metre.
    pub length: f64,
    /// Exponent of the kilogram.
    pub mass: f64,
    /// Exponent of the second.
    pub time: f64,
    /// Exponent of the radian.
    pub angle: f64,
    /// Exponent of the kelvin. Temperatures are differences: a scale that does not begin at zero has no factor.
    pub temperature: f64,
}

/// Names of a dimension that has a constant; a missing one is an empty text.
struct NamedDimension {
    dimension: Dimension,
    /// Its SI unit, where that is not written with kg, m, rad and s.
    si_unit: &'static str,
    /// The name by which messages call it.
    name: &'static str,
    /// A value for hints.
    example: &'static str,
}

macro_rules! dimensions {
    ($($constant:ident [$($exponent:expr),+] $si_unit:literal, $name:literal, $example:literal, $doc:literal;)+) => {
        impl Dimension {
            $(#[doc = $doc] pub const $constant: Dimension = new($($exponent),+);)+
        }

        static ROWS: &[NamedDimension] = &[$(
            NamedDimension { dimension: Dimension::$constant, si_unit: $si_unit, name: $name, example: $example },
        )+];
    };
}

// Exponents of metre, kilogram, second, radian and kelvin; SI unit; name; example; unit in documentation.
dimensions! {
    NUMBER [0.0, 0.0, 0.0, 0.0, 0.0] "", "a number without unit", "0.5", "A pure number.";
    LENGTH [1.0, 0.0, 0.0, 0.0, 0.0] "", "a length", "0.5 mm", "m.";
    MASS [0.0, 1.0, 0.0, 0.0, 0.0] "", "a mass", "0.3 kg", "kg.";
    TIME [0.0, 0.0, 1.0, 0.0, 0.0] "", "a time", "10 ms", "s.";
    ANGLE [0.0, 0.0, 0.0, 1.0, 0.0] "", "an angle", "30 deg", "rad.";
    VELOCITY [1.0, 0.0, -1.0, 0.0, 0.0] "", "a velocity", "1 mm/s", "m/s.";
    ACCELERATION [1.0, 0.0, -2.0, 0.0, 0.0] "", "an acceleration", "9.81 m/s^2", "m/s².";
    ANGULAR_VELOCITY [0.0, 0.0, -1.0, 1.0, 0.0] "", "an angular velocity", "5000 rpm", "rad/s.";
    ANGULAR_ACCELERATION [0.0, 0.0, -2.0, 1.0, 0.0] "", "an angular acceleration", "10 rad/s^2", "rad/s².";
    FORCE [1.0, 1.0, -2.0, 0.0, 0.0] "N", "a force", "100 N", "N.";
    TORQUE [2.0, 1.0, -2.0, 0.0, 0.0] "N m", "a torque or an energy", "1 N m", "N m, J.";
    POWER [2.0, 1.0, -3.0, 0.0, 0.0] "W", "a power", "1 kW", "W.";
    PRESSURE [-1.0, 1.0, -2.0, 0.0, 0.0] "Pa", "a pressure or a modulus", "207 GPa", "Pa.";
    DENSITY [-3.0, 1.0, 0.0, 0.0, 0.0] "", "a density", "7800 kg/m^3", "kg/m³.";
    INERTIA [2.0, 1.0, 0.0, 0.0, 0.0] "", "a moment of inertia", "1e-4 kg m^2", "kg m².";
    AREA [2.0, 0.0, 0.0, 0.0, 0.0] "", "an area", "1 mm^2", "m².";
    VOLUME [3.0, 0.0, 0.0, 0.0, 0.0] "", "a volume", "1 mm^3", "m³.";
    SECOND_MOMENT [4.0, 0.0, 0.0, 0.0, 0.0] "", "a second moment of area", "1 mm^4", "m⁴.";
    FREQUENCY [0.0, 0.0, -1.0, 0.0, 0.0] "", "a frequency", "50 Hz", "Hz.";
    SPRING_STIFFNESS [0.0, 1.0, -2.0, 0.0, 0.0] "", "a stiffness (force per length)", "20 N/mm", "N/m.";
    DAMPING [0.0, 1.0, -1.0, 0.0, 0.0] "N s/m", "a damping", "5 N s/m", "N s/m.";
    TORSIONAL_STIFFNESS [2.0, 1.0, -2.0, -1.0, 0.0] "N m/rad", "the stiffness of a torsional spring", "2 N m/rad", "N m/rad.";
    TORSIONAL_DAMPING [2.0, 1.0, -1.0, -1.0, 0.0] "N m s/rad", "a torsional damping", "0.01 N m s/rad", "N m s/rad.";
    VISCOSITY [-1.0, 1.0, -1.0, 0.0, 0.0] "Pa s", "a dynamic viscosity", "0.02 Pa s", "Pa s.";
    WEAR_COEFFICIENT [1.0, -1.0, 2.0, 0.0, 0.0] "m^2/N", "a wear coefficient", "1e-15 m^2/N", "m²/N.";
    FOUNDATION [-2.0, 1.0, -2.0, 0.0, 0.0] "Pa/m", "the stiffness of an elastic foundation (pressure per length)", "6.7e12 Pa/m", "Pa/m.";
    TEMPERATURE [0.0, 0.0, 0.0, 0.0, 1.0] "", "a difference of temperatures", "40 K", "K.";
    THERMAL_EXPANSION [0.0, 0.0, 0.0, 0.0, -1.0] "", "a coefficient of thermal expansion", "11.7e-6 1/K", "1/K.";
    INVERSE_VELOCITY [-1.0, 0.0, 1.0, 0.0, 0.0] "", "", "", "One over a velocity.";
    INVERSE_LENGTH [-1.0, 0.0, 0.0, 0.0, 0.0] "", "", "", "One over a length.";
}

const fn new(length: f64, mass: f64, time: f64, angle: f64, temperature: f64) -> Dimension {
    Dimension { length, mass, time, angle, temperature }
}

impl Dimension {
    /// The dimension of a contact stiffness K in F = K δⁿ: N/m^n, `exponent` is n.
    pub fn contact_stiffness(exponent: f64) -> Dimension {
        new(1.0 - exponent, 1.0, -2.0, 0.0, 0.0)
    }

    /// The dimension of a product.
    pub fn times(self, other: Dimension) -> Dimension {
        let [a, b] = [self, other].map(Self::exponents);
        Self::of_exponents(std::array::from_fn(|k| a[k] + b[k]))
    }

    /// The dimension of a quotient.
    pub fn over(self, other: Dimension) -> Dimension {
        self.times(other.power(-1.0))
    }

    /// The dimension of a power.
    pub fn power(self, exponent: f64) -> Dimension {
        Self::of_exponents(self.exponents().map(|own| own * exponent))
    }

    fn exponents(self) -> [f64; 5] {
        [self.length, self.mass, self.time, self.angle, self.temperature]
    }

    fn of_exponents([length, mass, time, angle, temperature]: [f64; 5]) -> Dimension {
        new(length, mass, time, angle, temperature)
    }

    /// Whether this is the dimension of a pure number.
    pub fn is_number(self) -> bool {
        self == Dimension::NUMBER
    }

    /// Whether every exponent is finite; a power of a power may overflow.
    pub fn is_finite(self) -> bool {
        self.exponents().iter().all(|exponent| exponent.is_finite())
    }

    /// What is said of it; absent for a dimension without a name.
    fn row(self) -> Option<&'static NamedDimension> {
        ROWS.iter().find(|row| row.dimension == self && !row.name.is_empty())
    }

    /// A value of this dimension as one would write it, for hints; absent for a dimension without a name.
    pub fn example(self) -> Option<&'static str> {
        self.row().map(|row| row.example)
    }

    /// The SI unit, for example `kg m^2` or `rad/s`; empty for a number.
    pub fn si_unit(self) -> String {
        let own = ROWS.iter().find(|row| row.dimension == self).map_or("", |row| row.si_unit);
        if !own.is_empty() {
            return own.to_owned();
        }
        // A stiffness reads best as N/m^n.
        let stiffness_exponent = 1.0 - self.length;
        if stiffness_exponent > 0.0 && self == Self::contact_stiffness(stiffness_exponent) {
            return format!("N/m{}", exponent_text(stiffness_exponent));
        }
        let factors =
            [(self.mass, "kg"), (self.length, "m"), (self.angle, "rad"), (self.time, "s"), (self.temperature, "K")];
        let over: Vec<String> = factors
            .iter()
            .filter(|(exponent, _)| *exponent > EXPONENT_TOLERANCE)
            .map(|(exponent, symbol)| format!("{symbol}{}", exponent_text(*exponent)))
            .collect();
        let under: Vec<String> = factors
            .iter()
            .filter(|(exponent, _)| *exponent < -EXPONENT_TOLERANCE)
            .map(|(exponent, symbol)| format!("{symbol}{}", exponent_text(-*exponent)))
            .collect();
        match (over.is_empty(), under.len()) {
            (_, 0) => over.join(" "),
            (true, _) => format!("1/{}", parenthesised(&under)),
            (false, _) => format!("{}/{}", over.join(" "), parenthesised(&under)),
        }
    }
}

fn parenthesised(factors: &[String]) -> String {
    if factors.len() == 1 { factors[0].clone() } else { format!("({})", factors.join(" ")) }
}

fn exponent_text(exponent: f64) -> String {
    let rounded = (exponent / EXPONENT_TOLERANCE).round() * EXPONENT_TOLERANCE;
    if (rounded - 1.0).abs() < EXPONENT_TOLERANCE {
        String::new()
    } else {
        format!("^{}", super::format_number(rounded))
    }
}

impl PartialEq for Dimension {
    fn eq(&self, other: &Self) -> bool {
        let [a, b] = [*self, *other].map(Self::exponents);
        std::iter::zip(a, b).all(|(a, b)| (a - b).abs() < EXPONENT_TOLERANCE)
    }
}

/// The name with its article, for example `a length`; `a value in kg m` where there is no name.
impl fmt::Display for Dimension {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.row() {
            Some(row) => formatter.write_str(row.name),
            None => write!(formatter, "a value in {}", self.si_unit()),
        }
    }
}

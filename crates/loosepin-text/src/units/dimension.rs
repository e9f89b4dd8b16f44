//! Dimensions: exponents of length, mass, time and angle.

use std::fmt;

/// Two exponents closer than this are the same: they are sums of a few decimal fractions.
const EXPONENT_TOLERANCE: f64 = 1e-9;

/// The dimension of a quantity, as exponents of metre, kilogram, second and radian.
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
}

/// A dimension that has a name, with the example shown in hints.
struct Named {
    dimension: Dimension,
    name: &'static str,
    example: &'static str,
}

const fn new(length: f64, mass: f64, time: f64, angle: f64) -> Dimension {
    Dimension { length, mass, time, angle }
}

impl Dimension {
    /// A pure number.
    pub const NUMBER: Dimension = new(0.0, 0.0, 0.0, 0.0);
    /// m.
    pub const LENGTH: Dimension = new(1.0, 0.0, 0.0, 0.0);
    /// kg.
    pub const MASS: Dimension = new(0.0, 1.0, 0.0, 0.0);
    /// s.
    pub const TIME: Dimension = new(0.0, 0.0, 1.0, 0.0);
    /// rad.
    pub const ANGLE: Dimension = new(0.0, 0.0, 0.0, 1.0);
    /// m/s.
    pub const VELOCITY: Dimension = new(1.0, 0.0, -1.0, 0.0);
    /// m/s².
    pub const ACCELERATION: Dimension = new(1.0, 0.0, -2.0, 0.0);
    /// rad/s.
    pub const ANGULAR_VELOCITY: Dimension = new(0.0, 0.0, -1.0, 1.0);
    /// rad/s².
    pub const ANGULAR_ACCELERATION: Dimension = new(0.0, 0.0, -2.0, 1.0);
    /// N.
    pub const FORCE: Dimension = new(1.0, 1.0, -2.0, 0.0);
    /// N m, J.
    pub const TORQUE: Dimension = new(2.0, 1.0, -2.0, 0.0);
    /// W.
    pub const POWER: Dimension = new(2.0, 1.0, -3.0, 0.0);
    /// Pa.
    pub const PRESSURE: Dimension = new(-1.0, 1.0, -2.0, 0.0);
    /// kg/m³.
    pub const DENSITY: Dimension = new(-3.0, 1.0, 0.0, 0.0);
    /// kg m².
    pub const INERTIA: Dimension = new(2.0, 1.0, 0.0, 0.0);
    /// m².
    pub const AREA: Dimension = new(2.0, 0.0, 0.0, 0.0);
    /// m³.
    pub const VOLUME: Dimension = new(3.0, 0.0, 0.0, 0.0);
    /// Hz.
    pub const FREQUENCY: Dimension = new(0.0, 0.0, -1.0, 0.0);
    /// N/m.
    pub const SPRING_STIFFNESS: Dimension = new(0.0, 1.0, -2.0, 0.0);
    /// N s/m.
    pub const DAMPING: Dimension = new(0.0, 1.0, -1.0, 0.0);
    /// N m/rad.
    pub const TORSIONAL_STIFFNESS: Dimension = new(2.0, 1.0, -2.0, -1.0);
    /// N m s/rad.
    pub const TORSIONAL_DAMPING: Dimension = new(2.0, 1.0, -1.0, -1.0);
    /// Pa s.
    pub const VISCOSITY: Dimension = new(-1.0, 1.0, -1.0, 0.0);
    /// One over a velocity.
    pub const INVERSE_VELOCITY: Dimension = new(-1.0, 0.0, 1.0, 0.0);
    /// One over a length.
    pub const INVERSE_LENGTH: Dimension = new(-1.0, 0.0, 0.0, 0.0);

    /// The dimension of a contact stiffness K in F = K δⁿ: N/m^n, `exponent` is n.
    pub fn contact_stiffness(exponent: f64) -> Dimension {
        new(1.0 - exponent, 1.0, -2.0, 0.0)
    }

    /// The dimension of a product.
    pub fn times(self, other: Dimension) -> Dimension {
        new(self.length + other.length, self.mass + other.mass, self.time + other.time, self.angle + other.angle)
    }

    /// The dimension of a quotient.
    pub fn over(self, other: Dimension) -> Dimension {
        self.times(other.power(-1.0))
    }

    /// The dimension of a power.
    pub fn power(self, exponent: f64) -> Dimension {
        new(self.length * exponent, self.mass * exponent, self.time * exponent, self.angle * exponent)
    }

    /// Whether this is the dimension of a pure number.
    pub fn is_number(self) -> bool {
        self == Dimension::NUMBER
    }

    /// Whether every exponent is finite; a power of a power may overflow.
    pub fn is_finite(self) -> bool {
        [self.length, self.mass, self.time, self.angle].iter().all(|exponent| exponent.is_finite())
    }

    /// A value of this dimension as one would write it, for hints; absent for a dimension without a name.
    pub fn example(self) -> Option<&'static str> {
        NAMED.iter().find(|named| named.dimension == self).map(|named| named.example)
    }

    /// The SI unit, for example `kg m^2` or `rad/s`; empty for a number.
    pub fn si_unit(self) -> String {
        for (dimension, symbol) in [
            (Self::FORCE, "N"),
            (Self::PRESSURE, "Pa"),
            (Self::POWER, "W"),
            (Self::TORQUE, "N m"),
            (Self::DAMPING, "N s/m"),
            (Self::TORSIONAL_STIFFNESS, "N m/rad"),
            (Self::TORSIONAL_DAMPING, "N m s/rad"),
            (Self::VISCOSITY, "Pa s"),
        ] {
            if self == dimension {
                return symbol.to_owned();
            }
        }
        // A stiffness reads best as N/m^n.
        let stiffness_exponent = 1.0 - self.length;
        if stiffness_exponent > 0.0 && self == Self::contact_stiffness(stiffness_exponent) {
            return format!("N/m{}", exponent_text(stiffness_exponent));
        }
        let factors = [(self.mass, "kg"), (self.length, "m"), (self.angle, "rad"), (self.time, "s")];
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
        (self.length - other.length).abs() < EXPONENT_TOLERANCE
            && (self.mass - other.mass).abs() < EXPONENT_TOLERANCE
            && (self.time - other.time).abs() < EXPONENT_TOLERANCE
            && (self.angle - other.angle).abs() < EXPONENT_TOLERANCE
    }
}

/// The name with its article, for example `a length`; `a value in kg m` where there is no name.
impl fmt::Display for Dimension {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match NAMED.iter().find(|named| named.dimension == *self) {
            Some(named) => formatter.write_str(named.name),
            None => write!(formatter, "a value in {}", self.si_unit()),
        }
    }
}

const fn named(dimension: Dimension, name: &'static str, example: &'static str) -> Named {
    Named { dimension, name, example }
}

/// The dimensions that messages call by name.
static NAMED: &[Named] = &[
    named(Dimension::NUMBER, "a number without unit", "0.5"),
    named(Dimension::LENGTH, "a length", "0.5 mm"),
    named(Dimension::MASS, "a mass", "0.3 kg"),
    named(Dimension::TIME, "a time", "10 ms"),
    named(Dimension::ANGLE, "an angle", "30 deg"),
    named(Dimension::VELOCITY, "a velocity", "1 mm/s"),
    named(Dimension::ACCELERATION, "an acceleration", "9.81 m/s^2"),
    named(Dimension::ANGULAR_VELOCITY, "an angular velocity", "5000 rpm"),
    named(Dimension::ANGULAR_ACCELERATION, "an angular acceleration", "10 rad/s^2"),
    named(Dimension::FORCE, "a force", "100 N"),
    named(Dimension::TORQUE, "a torque or an energy", "1 N m"),
    named(Dimension::POWER, "a power", "1 kW"),
    named(Dimension::PRESSURE, "a pressure or a modulus", "207 GPa"),
    named(Dimension::DENSITY, "a density", "7800 kg/m^3"),
    named(Dimension::INERTIA, "a moment of inertia", "1e-4 kg m^2"),
    named(Dimension::AREA, "an area", "1 mm^2"),
    named(Dimension::VOLUME, "a volume", "1 mm^3"),
    named(Dimension::FREQUENCY, "a frequency", "50 Hz"),
    named(Dimension::SPRING_STIFFNESS, "a stiffness in N/m", "20 N/mm"),
    named(Dimension::DAMPING, "a damping", "5 N s/m"),
    named(Dimension::TORSIONAL_STIFFNESS, "the stiffness of a torsional spring", "2 N m/rad"),
    named(Dimension::TORSIONAL_DAMPING, "a torsional damping", "0.01 N m s/rad"),
    named(Dimension::VISCOSITY, "a dynamic viscosity", "0.02 Pa s"),
];

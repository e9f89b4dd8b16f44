//! The unit symbols that files may use.
//!
//! Which symbols are known, and how they are spelt, is decided here; their factors are those of `uom`, which follows
//! the NIST tables. The pound, and what is built on it, is defined exactly (international yard and pound agreement of
//! 1959), since those tables give it to seven digits.

use std::sync::LazyLock;

use uom::Conversion;
use uom::si::time;
use uom::si::{
    angle, angular_velocity, dynamic_viscosity, energy, force, frequency, length, mass, power, pressure, ratio,
};

use super::Dimension;

/// A unit: its symbol, its dimension and what one of it is in SI.
#[derive(Debug, Clone, Copy)]
pub struct Unit {
    /// The symbol as written in files.
    pub symbol: &'static str,
    /// Its dimension.
    pub dimension: Dimension,
    /// Numerator of the SI value of one unit.
    numerator: f64,
    /// Denominator of the SI value of one unit: 1000 for the millimetre, so that the value is rounded once.
    denominator: f64,
}

impl Unit {
    fn new(symbol: &'static str, dimension: Dimension, coefficient: f64) -> Unit {
        let reciprocal = (1.0 / coefficient).round();
        if coefficient < 1.0 && 1.0 / reciprocal == coefficient {
            Unit { symbol, dimension, numerator: 1.0, denominator: reciprocal }
        } else {
            Unit { symbol, dimension, numerator: coefficient, denominator: 1.0 }
        }
    }

    /// `value` of this unit in SI.
    pub fn to_si(&self, value: f64) -> f64 {
        value * self.numerator / self.denominator
    }

    /// Numerator and denominator of the SI value of one unit.
    pub(super) fn factor(&self) -> (f64, f64) {
        (self.numerator, self.denominator)
    }
}

fn of<U: Conversion<f64, T = f64>>(symbol: &'static str, dimension: Dimension) -> Unit {
    Unit::new(symbol, dimension, U::coefficient())
}

/// kg, exact by definition.
const POUND_KG: f64 = 0.453_592_37;
/// m/s², exact by definition.
const STANDARD_GRAVITY_M_S2: f64 = 9.806_65;
/// m, exact by definition.
const INCH_M: f64 = 0.0254;

/// Every unit that a file may use.
pub static UNITS: LazyLock<Vec<Unit>> = LazyLock::new(|| {
    use Dimension as D;
    let pound_force_n = POUND_KG * STANDARD_GRAVITY_M_S2;
    vec![
        of::<length::meter>("m", D::LENGTH),
        of::<length::millimeter>("mm", D::LENGTH),
        of::<length::micrometer>("µm", D::LENGTH),
        of::<length::micrometer>("um", D::LENGTH),
        of::<length::nanometer>("nm", D::LENGTH),
        of::<length::centimeter>("cm", D::LENGTH),
        of::<length::decimeter>("dm", D::LENGTH),
        of::<length::kilometer>("km", D::LENGTH),
        of::<length::inch>("in", D::LENGTH),
        of::<length::foot>("ft", D::LENGTH),
        of::<length::mil>("mil", D::LENGTH),
        of::<length::mil>("thou", D::LENGTH),
        of::<mass::kilogram>("kg", D::MASS),
        of::<mass::gram>("g", D::MASS),
        of::<mass::milligram>("mg", D::MASS),
        of::<mass::ton>("t", D::MASS),
        Unit::new("lb", D::MASS, POUND_KG),
        of::<time::second>("s", D::TIME),
        of::<time::millisecond>("ms", D::TIME),
        of::<time::microsecond>("µs", D::TIME),
        of::<time::microsecond>("us", D::TIME),
        of::<time::nanosecond>("ns", D::TIME),
        of::<time::minute>("min", D::TIME),
        of::<time::hour>("h", D::TIME),
        of::<angle::radian>("rad", D::ANGLE),
        Unit::new("mrad", D::ANGLE, 1e-3),
        of::<angle::degree>("deg", D::ANGLE),
        of::<angle::degree>("°", D::ANGLE),
        of::<angle::revolution>("rev", D::ANGLE),
        of::<angular_velocity::revolution_per_minute>("rpm", D::ANGULAR_VELOCITY),
        of::<frequency::hertz>("Hz", D::FREQUENCY),
        of::<frequency::kilohertz>("kHz", D::FREQUENCY),
        of::<force::newton>("N", D::FORCE),
        of::<force::millinewton>("mN", D::FORCE),
        of::<force::kilonewton>("kN", D::FORCE),
        of::<force::meganewton>("MN", D::FORCE),
        Unit::new("lbf", D::FORCE, pound_force_n),
        of::<pressure::pascal>("Pa", D::PRESSURE),
        of::<pressure::kilopascal>("kPa", D::PRESSURE),
        of::<pressure::megapascal>("MPa", D::PRESSURE),
        of::<pressure::gigapascal>("GPa", D::PRESSURE),
        of::<pressure::bar>("bar", D::PRESSURE),
        Unit::new("psi", D::PRESSURE, pound_force_n / (INCH_M * INCH_M)),
        of::<energy::joule>("J", D::TORQUE),
        of::<energy::millijoule>("mJ", D::TORQUE),
        of::<energy::kilojoule>("kJ", D::TORQUE),
        of::<power::watt>("W", D::POWER),
        of::<power::milliwatt>("mW", D::POWER),
        of::<power::kilowatt>("kW", D::POWER),
        Unit::new("cP", D::VISCOSITY, viscosity_of_a_centipoise_pa_s()),
        of::<ratio::percent>("%", D::NUMBER),
    ]
});

fn viscosity_of_a_centipoise_pa_s() -> f64 {
    <dynamic_viscosity::centipoise as Conversion<f64>>::coefficient()
}

/// The unit with this symbol. The micro sign may be written as U+00B5, U+03BC or `u`.
pub fn find_unit(symbol: &str) -> Option<&'static Unit> {
    let symbol = symbol.replace('\u{3bc}', "\u{b5}");
    UNITS.iter().find(|unit| unit.symbol == symbol)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_decimal_prefixes_round_once() {
        let millimetre = find_unit("mm").expect("mm");
        assert_eq!(millimetre.to_si(0.3), 0.0003);
        assert_eq!(find_unit("µm").expect("µm").to_si(53.0), 53e-6);
        assert_eq!(find_unit("\u{3bc}m").expect("µm with a Greek letter").to_si(1.0), 1e-6);
        assert_eq!(find_unit("g").expect("g").to_si(140.0), 0.14);
    }

    #[test]
    fn analytic_compound_units_equal_their_definitions() {
        let radian_per_second = 5000.0 * 2.0 * std::f64::consts::PI / 60.0;
        let error = find_unit("rpm").expect("rpm").to_si(5000.0) / radian_per_second - 1.0;
        assert!(error.abs() < 4.0 * f64::EPSILON, "rpm differs by {error:e}");
        assert_eq!(find_unit("deg").expect("deg").to_si(180.0), std::f64::consts::PI);
        assert_eq!(find_unit("cP").expect("cP").to_si(1.0), 1e-3);
    }

    #[test]
    fn identity_symbols_are_unique() {
        for (index, unit) in UNITS.iter().enumerate() {
            assert!(UNITS[..index].iter().all(|other| other.symbol != unit.symbol), "{} twice", unit.symbol);
        }
    }
}

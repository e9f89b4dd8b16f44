//! The unit symbols that files may use, and their factors.
//!
//! Factors are the definitions of the SI brochure (9th edition, 2019), of the international yard and pound agreement of
//! 1959 (inch and pound, exact) and of the standard acceleration of free fall (3rd CGPM, 1901, exact).

use std::f64::consts::PI;

use super::Dimension;
use super::Dimension as D;

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

const fn unit(symbol: &'static str, dimension: Dimension, numerator: f64, denominator: f64) -> Unit {
    Unit { symbol, dimension, numerator, denominator }
}

impl Unit {
    /// `value` of this unit in SI.
    pub fn to_si(&self, value: f64) -> f64 {
        value * self.numerator / self.denominator
    }

    /// Numerator and denominator of the SI value of one unit.
    pub(super) fn factor(&self) -> (f64, f64) {
        (self.numerator, self.denominator)
    }
}

/// m, exact by definition.
const INCH_M: f64 = 0.0254;
/// kg, exact by definition.
const POUND_KG: f64 = 0.453_592_37;
/// m/s², exact by definition.
const STANDARD_GRAVITY_M_S2: f64 = 9.806_65;
/// N.
const POUND_FORCE_N: f64 = POUND_KG * STANDARD_GRAVITY_M_S2;
/// Pa.
const PSI_PA: f64 = POUND_FORCE_N / (INCH_M * INCH_M);

/// Every unit that a file may use: symbol, dimension, and what one of it is in SI as a fraction.
///
/// A new unit is a line here and a line in the test below. Hints name the first of equally near symbols.
#[rustfmt::skip]
pub static UNITS: &[Unit] = &[
    unit("m",     D::LENGTH,           1.0,           1.0),
    unit("mm",    D::LENGTH,           1.0,           1e3),
    unit("µm",    D::LENGTH,           1.0,           1e6),
    unit("um",    D::LENGTH,           1.0,           1e6),
    unit("nm",    D::LENGTH,           1.0,           1e9),
    unit("cm",    D::LENGTH,           1.0,           100.0),
    unit("dm",    D::LENGTH,           1.0,           10.0),
    unit("km",    D::LENGTH,           1e3,           1.0),
    unit("in",    D::LENGTH,           INCH_M,        1.0),
    unit("ft",    D::LENGTH,           0.3048,        1.0), // exact: 12 in
    unit("mil",   D::LENGTH,           2.54e-5,       1.0), // exact: 0.001 in
    unit("thou",  D::LENGTH,           2.54e-5,       1.0), // exact: 0.001 in

    unit("kg",    D::MASS,             1.0,           1.0),
    unit("g",     D::MASS,             1.0,           1e3),
    unit("mg",    D::MASS,             1.0,           1e6),
    unit("t",     D::MASS,             1e3,           1.0),
    unit("lb",    D::MASS,             POUND_KG,      1.0),

    unit("s",     D::TIME,             1.0,           1.0),
    unit("ms",    D::TIME,             1.0,           1e3),
    unit("µs",    D::TIME,             1.0,           1e6),
    unit("us",    D::TIME,             1.0,           1e6),
    unit("ns",    D::TIME,             1.0,           1e9),
    unit("min",   D::TIME,             60.0,          1.0),
    unit("h",     D::TIME,             3600.0,        1.0),

    unit("rad",   D::ANGLE,            1.0,           1.0),
    unit("mrad",  D::ANGLE,            1.0,           1e3),
    unit("deg",   D::ANGLE,            PI / 180.0,    1.0),
    unit("°",     D::ANGLE,            PI / 180.0,    1.0),
    unit("rev",   D::ANGLE,            2.0 * PI,      1.0),
    unit("rpm",   D::ANGULAR_VELOCITY, PI / 30.0,     1.0), // 2 π / 60 s, one rounding below the nearest double
    unit("Hz",    D::FREQUENCY,        1.0,           1.0),
    unit("kHz",   D::FREQUENCY,        1e3,           1.0),

    unit("K",     D::TEMPERATURE,      1.0,           1.0),

    unit("N",     D::FORCE,            1.0,           1.0),
    unit("mN",    D::FORCE,            1.0,           1e3),
    unit("kN",    D::FORCE,            1e3,           1.0),
    unit("MN",    D::FORCE,            1e6,           1.0),
    unit("lbf",   D::FORCE,            POUND_FORCE_N, 1.0),
    unit("Pa",    D::PRESSURE,         1.0,           1.0),
    unit("kPa",   D::PRESSURE,         1e3,           1.0),
    unit("MPa",   D::PRESSURE,         1e6,           1.0),
    unit("GPa",   D::PRESSURE,         1e9,           1.0),
    unit("bar",   D::PRESSURE,         1e5,           1.0),
    unit("psi",   D::PRESSURE,         PSI_PA,        1.0), // lbf/in², one rounding below the nearest double
    unit("J",     D::TORQUE,           1.0,           1.0),
    unit("mJ",    D::TORQUE,           1.0,           1e3),
    unit("kJ",    D::TORQUE,           1e3,           1.0),
    unit("W",     D::POWER,            1.0,           1.0),
    unit("mW",    D::POWER,            1.0,           1e3),
    unit("kW",    D::POWER,            1e3,           1.0),
    unit("cP",    D::VISCOSITY,        1.0,           1e3), // mPa s

    unit("%",     D::NUMBER,           1.0,           100.0),
    unit("ppm",   D::NUMBER,           1.0,           1e6),
];

/// The unit with this symbol. The micro sign may be written as U+00B5, U+03BC or `u`.
pub fn find_unit(symbol: &str) -> Option<&'static Unit> {
    let symbol = symbol.replace('\u{3bc}', "\u{b5}");
    UNITS.iter().find(|unit| unit.symbol == symbol)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One unit in SI, as a decimal from its definition, and the exponents of m, kg, s, rad and K. The decimals of
    /// π are those of tables; the pound-force is 0.453 592 37 · 9.806 65 N, the psi 4.448 221 615 260 5 / 0.0254² Pa.
    #[rustfmt::skip]
    const DEFINITIONS: &[(&str, &str, [f64; 5])] = &[
        ("m mm", "1 0.001", [1.0, 0.0, 0.0, 0.0, 0.0]),
        ("µm um nm", "0.000001 0.000001 0.000000001", [1.0, 0.0, 0.0, 0.0, 0.0]),
        ("cm dm km", "0.01 0.1 1000", [1.0, 0.0, 0.0, 0.0, 0.0]),
        ("in ft mil thou", "0.0254 0.3048 0.0000254 0.0000254", [1.0, 0.0, 0.0, 0.0, 0.0]),
        ("kg g mg t lb", "1 0.001 0.000001 1000 0.45359237", [0.0, 1.0, 0.0, 0.0, 0.0]),
        ("s ms µs us", "1 0.001 0.000001 0.000001", [0.0, 0.0, 1.0, 0.0, 0.0]),
        ("ns min h", "0.000000001 60 3600", [0.0, 0.0, 1.0, 0.0, 0.0]),
        ("rad mrad", "1 0.001", [0.0, 0.0, 0.0, 1.0, 0.0]),
        ("deg °", "0.01745329251994329576923690768 0.01745329251994329576923690768", [0.0, 0.0, 0.0, 1.0, 0.0]),
        ("rev", "6.28318530717958647692528676655900577", [0.0, 0.0, 0.0, 1.0, 0.0]),
        ("rpm", "0.10471975511965977461542144610931676", [0.0, 0.0, -1.0, 1.0, 0.0]),
        ("Hz kHz", "1 1000", [0.0, 0.0, -1.0, 0.0, 0.0]),
        ("K", "1", [0.0, 0.0, 0.0, 0.0, 1.0]),
        ("N mN kN MN lbf", "1 0.001 1000 1000000 4.4482216152605", [1.0, 1.0, -2.0, 0.0, 0.0]),
        ("Pa kPa MPa GPa", "1 1000 1000000 1000000000", [-1.0, 1.0, -2.0, 0.0, 0.0]),
        ("bar psi", "100000 6894.75729316836133672267344534689069", [-1.0, 1.0, -2.0, 0.0, 0.0]),
        ("J mJ kJ", "1 0.001 1000", [2.0, 1.0, -2.0, 0.0, 0.0]),
        ("W mW kW", "1 0.001 1000", [2.0, 1.0, -3.0, 0.0, 0.0]),
        ("cP", "0.001", [-1.0, 1.0, -1.0, 0.0, 0.0]),
        ("% ppm", "0.01 0.000001", [0.0, 0.0, 0.0, 0.0, 0.0]),
    ];

    /// Bits that a factor may be below the double nearest to its definition: one where it is a product of rounded
    /// factors (π/30, lbf/in²), none elsewhere. To round them once more would change the numbers of every result.
    fn bits_below(symbol: &str) -> u64 {
        u64::from(matches!(symbol, "rpm" | "psi"))
    }

    #[test]
    fn published_factors_are_those_of_the_definitions() {
        let mut symbols = Vec::new();
        for (of_dimension, factors, exponents) in DEFINITIONS {
            let (of_dimension, factors): (Vec<&str>, Vec<&str>) =
                (of_dimension.split(' ').collect(), factors.split(' ').collect());
            assert_eq!(of_dimension.len(), factors.len(), "{of_dimension:?}");
            for (symbol, factor) in of_dimension.into_iter().zip(factors) {
                let unit = find_unit(symbol).unwrap_or_else(|| panic!("no unit {symbol}"));
                let nearest: f64 = factor.parse().expect("a decimal");
                assert_eq!(unit.to_si(1.0).to_bits() + bits_below(symbol), nearest.to_bits(), "{symbol}");
                let D { length, mass, time, angle, temperature } = unit.dimension;
                assert_eq!([length, mass, time, angle, temperature], *exponents, "{symbol}");
                symbols.push(symbol);
            }
        }
        assert_eq!(symbols, UNITS.iter().map(|unit| unit.symbol).collect::<Vec<_>>());
    }

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

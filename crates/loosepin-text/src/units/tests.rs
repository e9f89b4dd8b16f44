//! Texts that are values and texts that are not.

use proptest::prelude::*;

use super::*;

fn value(text: &str) -> Measured {
    parse_quantity(text).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn refused(text: &str) -> String {
    match parse_quantity(text) {
        Ok(measured) => panic!("{text} was read as {measured:?}"),
        Err(error) => format!("{}..{}: {error}", error.span.start, error.span.end),
    }
}

#[test]
fn analytic_values_with_units_are_read() {
    use Dimension as D;
    for (text, value_si, dimension) in [
        ("0.5 mm", 0.0005, D::LENGTH),
        ("0.03 mm", 3e-5, D::LENGTH),
        ("  -0.05mm ", -5e-5, D::LENGTH),
        ("9.81 m/s^2", 9.81, D::ACCELERATION),
        ("9.81 m/s²", 9.81, D::ACCELERATION),
        ("1.0e-4 kg m^2", 1e-4, D::INERTIA),
        ("1.0e-4 kg*m^2", 1e-4, D::INERTIA),
        ("1.0e-4 kg·m²", 1e-4, D::INERTIA),
        ("100 g mm^2", 1e-7, D::INERTIA),
        ("207 GPa", 207e9, D::PRESSURE),
        ("207000 N/mm^2", 207e9, D::PRESSURE),
        ("6.6e10 N/m^1.5", 6.6e10, D::contact_stiffness(1.5)),
        ("6.6e10 N/m^(3/2)", 6.6e10, D::contact_stiffness(1.5)),
        ("7.8 g/cm^3", 7800.0, D::DENSITY),
        ("2 N m/rad", 2.0, D::TORQUE.over(D::ANGLE)),
        ("3 kg/(m s)", 3.0, D::VISCOSITY),
        ("10 %", 0.1, D::NUMBER),
        ("50 µm", 50e-6, D::LENGTH),
        ("2 1/s", 2.0, D::FREQUENCY),
        ("11.7e-6 1/K", 11.7e-6, D::THERMAL_EXPANSION),
        ("23 um/(m K)", 23e-6, D::THERMAL_EXPANSION),
        ("11.7 ppm/K", 11.7e-6, D::THERMAL_EXPANSION),
        ("1e3", 1000.0, D::NUMBER),
        ("1 m/s/s", 1.0, D::ACCELERATION),
        ("2 m^-1", 2.0, D::LENGTH.power(-1.0)),
    ] {
        let measured = value(text);
        assert_eq!(measured.dimension, dimension, "{text}");
        // Two roundings at most: of the number and of its unit.
        const ROUNDING: f64 = 2.0 * f64::EPSILON;
        assert!((measured.value_si - value_si).abs() <= ROUNDING * value_si.abs(), "{text}: {}", measured.value_si);
    }
}

#[test]
fn two_numbers_in_a_row_are_no_value() {
    for text in ["2 1", "2 2/s", "2 1/", "2 1/(3 s)"] {
        assert!(refused(text).starts_with("2..3: found the number"), "{}", refused(text));
    }
    for text in ["11.7e-6 1/C", "11.7e-6 1/°C"] {
        assert!(refused(text).ends_with("C' is not a known unit"), "{}", refused(text));
    }
    // What speeds of turning are written in elsewhere; they are rpm here.
    assert_eq!(refused("1500 1/min"), "5..6: found the number 1; expected an operator or the end");
}

#[test]
fn analytic_arithmetic_has_its_usual_order() {
    for (text, expected) in [
        ("1 + 2 * 3", 7.0),
        ("(1 + 2) * 3", 9.0),
        ("2 - 3 - 4", -5.0),
        ("16 / 4 / 2", 2.0),
        ("2^3^2", 512.0),
        ("-2^2", -4.0),
        ("2^-1", 0.5),
        ("--3", 3.0),
        ("+3", 3.0),
        ("sqrt(16)", 4.0),
        ("sin(30 deg)", 0.5),
        ("cos(pi * 1 rad)", -1.0),
        ("tan(45 deg)", 1.0),
        ("asin(1) / (1 rad)", std::f64::consts::FRAC_PI_2),
        ("acos(0) / 1 rad", std::f64::consts::FRAC_PI_2),
        ("atan(1) / 1 rad", std::f64::consts::FRAC_PI_4),
        ("atan2(1 mm, -1 mm) / 1 rad", 0.75 * std::f64::consts::PI),
        ("abs(-3)", 3.0),
        ("min(2, 3) + max(2, 3)", 5.0),
        ("min(1 min, 59 s) / 1 s", 59.0),
        ("(3 mm + 4 mm) / 1 m", 0.007),
        ("sqrt(9 mm^2) / 1 mm", 3.0),
        ("1 m / 2 mm", 500.0),
        ("exp(2) * exp(-2)", 1.0),
        ("log(exp(0.7))", 0.7),
        ("log(1000) / log(10)", 3.0),
        ("2^0.3 * 2^0.7", 2.0),
        ("(-2)^3 + 0^0.3", -8.0),
        ("(4 mm)^0.5 * (4 mm)^0.5 / 1 mm", 4.0),
        ("2(3)", f64::NAN),
    ] {
        if expected.is_nan() {
            assert_eq!(refused(text), "1..2: found '('; expected an operator or the end");
            continue;
        }
        const ROUNDING: f64 = 4.0 * f64::EPSILON;
        let found = value(text);
        assert!(found.dimension.is_number(), "{text}");
        assert!((found.value_si - expected).abs() <= ROUNDING * expected.abs().max(1.0), "{text}: {}", found.value_si);
    }
}

#[test]
fn a_unit_belongs_to_the_number_before_it() {
    // Otherwise "1 m / 2 mm" would be an area over a length.
    assert_eq!(value("1 m / 2 mm").dimension, Dimension::NUMBER);
    assert_eq!(value("6 N / 2 m").dimension, Dimension::FORCE.over(Dimension::LENGTH));
    assert_eq!(value("2 * 3 mm^2").value_si, 2.0 * 3e-6);
}

#[test]
fn units_alone_are_read() {
    assert_eq!(parse_unit("mm").map(|unit| unit.value_si), Ok(1e-3));
    assert_eq!(parse_unit("kN").map(|unit| unit.value_si), Ok(1e3));
    assert_eq!(parse_unit("").map(|unit| unit.dimension), Ok(Dimension::NUMBER));
    assert!(parse_unit("2 mm").is_err());
    assert!(parse_unit("millimetre").is_err());
}

#[test]
fn places_of_errors_are_exact() {
    assert_eq!(
        refused("1 mm + 3 kg"),
        "5..6: + needs two values of one dimension; the first is a length, the second a mass"
    );
    assert_eq!(refused("1 mmm"), "2..5: 'mmm' is not a known unit");
    assert_eq!(refused("1 mm^x"), "5..6: found 'x'; expected the exponent of a unit, for example 2, -1, 1.5 or (3/2)");
    assert_eq!(refused("(1 + 2"), "6..6: found the end of the value; expected ')'");
    assert_eq!(refused("µ = 3"), "3..4: the character '=' is not permitted in a value");
    assert_eq!(refused("1 / 0"), "0..5: the value is infinity; must be finite");
    assert_eq!(refused("2 + log(1 - 3)"), "4..7: log of -2; must be > 0");
    assert_eq!(refused("log(0)"), "0..3: log of 0; must be > 0");
    assert_eq!(refused("sqrt(2 mm^2 - 3 mm^2)"), "0..4: sqrt of -1e-6 m^2; must be >= 0");
    assert_eq!(refused("1 + acos(2) / 1 rad"), "4..8: acos of 2; must be in [-1, 1]");
    assert_eq!(refused("3 * (1 - 2)^0.3"), "11..12: -1 has no power 0.3");
    assert_eq!(refused("0^-1.5"), "1..2: 0 has no power -1.5");
    assert_eq!(refused("log(1 mm)"), "0..3: log needs a number without unit; found a length");
}

#[test]
fn identity_shown_values_are_read_back() {
    for (value_si, dimension) in [
        (0.000_123_4, Dimension::LENGTH),
        (523.598_8, Dimension::ANGULAR_VELOCITY),
        (6.610_198e10, Dimension::contact_stiffness(1.5)),
        (1e-4, Dimension::INERTIA),
        (0.02, Dimension::VISCOSITY),
        (3.0, Dimension::TORQUE.over(Dimension::ANGLE)),
        (5.0, Dimension::ANGULAR_ACCELERATION),
    ] {
        let text = format_value(value_si, dimension);
        let read = value(&text);
        assert_eq!(read.dimension, dimension, "{text}");
        // Seven digits are shown.
        const SHOWN: f64 = 1e-6;
        assert!((read.value_si / value_si - 1.0).abs() < SHOWN, "{text}");
    }
}

/// Words that expressions are made of, right and wrong ones.
const WORDS: &[&str] = &[
    "1", "0", "2.5e3", "1e308", "1e-308", "mm", "kg", "s", "deg", "rpm", "N", "%", "+", "-", "*", "/", "^", "(", ")",
    ",", "sqrt(", "log(", "exp(", "sin(", "min(", "atan2(", "abs(", "pi", "²", "x", "µm", "·", "−", " ", "1.2.3",
    "999", "0.5", "max(",
];

proptest! {
    #[test]
    fn no_sequence_of_words_makes_the_parser_panic(words in proptest::collection::vec(0..WORDS.len(), 0..40)) {
        let text: String = words.iter().map(|word| format!("{} ", WORDS[*word])).collect();
        match parse_quantity(&text) {
            Ok(measured) => prop_assert!(measured.value_si.is_finite()),
            Err(error) => prop_assert!(text.get(error.span.clone()).is_some(), "{text}: {error:?}"),
        }
    }
}

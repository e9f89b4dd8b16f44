//! A value with its tolerance, as on a drawing: `50 ± 0.05 mm`, `50 +0.02 -0.01 mm`.

use crate::units::{Dimension, Measured, parse_quantity};

/// The limits that a drawing allows, SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    /// The nominal value.
    pub nominal: Measured,
    /// Lower and upper limit, in the order in which they were written.
    pub limits: [Measured; 2],
}

/// A number with its unit, as they are written.
type Piece<'t> = (&'t str, &'t str);

/// A value with its tolerance as a model and a study say it: the model has the nominal value, the study the deviations.
#[derive(Debug, Clone, PartialEq)]
pub struct SeparateTolerance {
    /// The nominal value with its unit; `None` where the text begins with the deviations.
    pub nominal: Option<String>,
    /// The deviations as `tolerance` of a random input has them: `± 0.05 mm`, `+0.02 -0.01 mm`.
    pub deviations: String,
    /// What the deviations measure.
    pub dimension: Dimension,
}

/// Reads a value with its tolerance; `None` if the text is none. A part without a unit has that of the last part with one. Where the text
/// begins with its deviations, the nominal value is `in_model`.
pub fn parse_tolerance(text: &str, in_model: Measured) -> Option<Tolerance> {
    let text = plain_signs(text);
    let (nominal, [(first_is_negated, first), (_, second)]) = pieces(&text)?;
    let nominal = nominal.map_or(Some(in_model), measured)?;
    let (first, second) = (measured(first)?, measured(second)?);
    if first.dimension != nominal.dimension || second.dimension != nominal.dimension {
        return None;
    }
    let first_si = if first_is_negated { -first.value_si } else { first.value_si };
    let limit = |deviation_si: f64| Measured { value_si: nominal.value_si + deviation_si, ..nominal };
    let mut limits = [limit(first_si), limit(second.value_si)];
    // A drawing writes the upper deviation first, or above the other one.
    if limits[0].value_si > limits[1].value_si && !text.contains('±') {
        limits.swap(0, 1);
    }
    Some(Tolerance { nominal, limits })
}

/// The nominal value and the deviations of a text, each by itself; `None` if the text is no value with its tolerance.
pub fn separate_tolerance(text: &str) -> Option<SeparateTolerance> {
    let text = plain_signs(text);
    let (nominal, [(is_symmetric, first), (_, second)]) = pieces(&text)?;
    let dimension = measured(second)?.dimension;
    if [Some(first), nominal]
        .into_iter()
        .flatten()
        .any(|piece| measured(piece).is_none_or(|m| m.dimension != dimension))
    {
        return None;
    }
    let with_unit = |(number, unit): Piece<'_>| format!("{number} {unit}").trim_end().to_owned();
    let signed = |(number, unit): Piece<'_>| {
        let sign = if number.starts_with('-') { "" } else { "+" };
        format!("{sign}{}", with_unit((number, unit)))
    };
    let deviations = if is_symmetric {
        format!("± {}", with_unit(second))
    } else if first.1 == second.1 {
        format!("{} {}", signed((first.0, "")), signed(second))
    } else {
        format!("{} {}", signed(first), signed(second))
    };
    Some(SeparateTolerance { nominal: nominal.map(with_unit), deviations, dimension })
}

/// A deviation, and whether it is to be negated.
type WrittenDeviation<'t> = (bool, Piece<'t>);

/// The nominal value, where it is written, and two deviations; numbers without a unit have the last one.
fn pieces<'t>(text: &'t str) -> Option<(Option<Piece<'t>>, [WrittenDeviation<'t>; 2])> {
    let [(_, nominal), (is_negated, first), (_, second)] = nominal_and_deviations(text)?;
    let nominal = if nominal.trim().is_empty() { None } else { Some(number_and_unit(nominal)?) };
    let (first, second) = (number_and_unit(first)?, number_and_unit(second)?);
    let units = [second.1, first.1, nominal.map_or("", |(_, unit)| unit)];
    let common = units.into_iter().find(|unit| !unit.is_empty()).unwrap_or("");
    let filled = |(number, unit): Piece<'t>| (number, if unit.is_empty() { common } else { unit });
    Some((nominal.map(filled), [(is_negated, filled(first)), (false, filled(second))]))
}

/// A number with its unit.
fn measured((number, unit): Piece<'_>) -> Option<Measured> {
    parse_quantity(&format!("{number} {unit}")).ok()
}

/// Whether a tolerance states its nominal value: deviations alone, such as `+0.02 -0.01 mm`, count from the model.
pub fn states_nominal(text: &str) -> bool {
    nominal_and_deviations(&plain_signs(text)).is_none_or(|parts| !parts[0].1.trim().is_empty())
}

fn plain_signs(text: &str) -> String {
    text.replace('−', "-").replace("+/-", "±").replace("+-", "±")
}

/// The nominal value, empty where there is none, and two deviations: whether each is to be negated, and how it is written.
fn nominal_and_deviations(text: &str) -> Option<[(bool, &str); 3]> {
    if let Some((nominal, half)) = text.split_once('±') {
        let half = half.trim();
        return (!half.starts_with(['+', '-'])).then_some([(false, nominal), (true, half), (false, half)]);
    }
    let parts = signed_parts(text).or_else(|| deviations(text))?;
    Some(parts.map(|part| (false, part)))
}

/// `50 +0.02 -0.01 mm`: the nominal value and two deviations with their signs.
pub fn signed_parts(text: &str) -> Option<[&str; 3]> {
    let mut starts = Vec::new();
    let mut before = ' ';
    for (place, letter) in text.char_indices() {
        if matches!(letter, '+' | '-') && (before.is_whitespace() || before == '/') && !text[..place].trim().is_empty()
        {
            starts.push(place);
        }
        before = letter;
    }
    let [first, second] = starts[..] else { return None };
    let clean = |part: &'_ str| part.trim().trim_end_matches('/').trim().len();
    let part = |from: usize, to: usize| {
        let part = text[from..to].trim_start();
        &part[..clean(part)]
    };
    Some([part(0, first), part(first, second), part(second, text.len())])
}

/// `+0.02 -0.01 mm`: two deviations with their signs, and no nominal value.
fn deviations(text: &str) -> Option<[&str; 3]> {
    let text = text.trim();
    let second = text.get(1..)?.find(['+', '-'])? + 1;
    let is_signed = text.starts_with(['+', '-']) && text[..second].ends_with([' ', '/']);
    is_signed.then(|| ["", text[..second].trim_end_matches('/').trim(), text[second..].trim()])
}

/// A number and the unit behind it; the unit may be missing.
pub fn number_and_unit(part: &str) -> Option<(&str, &str)> {
    let part = part.trim();
    let unsigned = part.strip_prefix('+').unwrap_or(part).trim_start();
    let mut ends = unsigned.char_indices().map(|(place, letter)| place + letter.len_utf8());
    let end = ends.rfind(|&end| unsigned[..end].parse::<f64>().is_ok_and(f64::is_finite))?;
    Some((&unsigned[..end], unsigned[end..].trim()))
}

#[cfg(test)]
mod tests {
    use super::{SeparateTolerance, parse_tolerance, separate_tolerance, states_nominal};
    use crate::units::{Dimension, Measured};

    /// What the model has where the text has no nominal value.
    const IN_MODEL: Measured = Measured { value_si: 0.0713, dimension: Dimension::LENGTH };

    /// Lower and upper limit, µm.
    fn limits_um(text: &str) -> Option<[f64; 2]> {
        let tolerance = parse_tolerance(text, IN_MODEL)?;
        assert!(tolerance.limits.iter().all(|limit| limit.dimension == Dimension::LENGTH), "{text}");
        Some(tolerance.limits.map(|limit| (limit.value_si * 1e9).round() / 1e3))
    }

    #[test]
    fn analytic_limits_of_what_drawings_say() {
        for text in
            ["50 ± 0.05 mm", "50±0.05mm", "50 mm ± 50 µm", "50 +/- 0.05 mm", "50 +- 0.05 mm", "50 +0.05 -0.05 mm"]
        {
            assert_eq!(limits_um(text), Some([49_950.0, 50_050.0]), "{text}");
        }
        for text in [
            "20 +0.021 -0.007 mm",
            "20 mm +0.021 -0.007",
            "20 -0.007 +0.021 mm",
            "20 +0.021/-0.007 mm",
            "20 mm +21 µm / -7 µm",
            "20 −0.007 +0.021 mm",
        ] {
            assert_eq!(limits_um(text), Some([19_993.0, 20_021.0]), "{text}");
        }
        assert_eq!(limits_um("20 -0.007 -0.020 mm"), Some([19_980.0, 19_993.0]));
        assert_eq!(limits_um("-3 ± 0.5 mm"), Some([-3_500.0, -2_500.0]));
        assert_eq!(limits_um("0 +0.1 +0 mm"), Some([0.0, 100.0]));
        assert_eq!(
            parse_tolerance("0.9 ± 0.02", IN_MODEL).map(|tolerance| tolerance.limits[0].dimension),
            Some(Dimension::NUMBER)
        );
    }

    #[test]
    fn analytic_deviations_alone_count_from_the_model() {
        for text in ["± 0.05 mm", "±50 µm", "+/- 0.05 mm", "+0.05 -0.05 mm", "+0.05/-0.05 mm", "-0.05 +0.05 mm"] {
            assert_eq!(limits_um(text), Some([71_250.0, 71_350.0]), "{text}");
        }
        assert_eq!(limits_um("+0.02 -0.01 mm"), Some([71_290.0, 71_320.0]));
        assert_eq!(limits_um("-0.01 -0.02 mm"), Some([71_280.0, 71_290.0]));
        let nominal = |text: &str| parse_tolerance(text, IN_MODEL).map(|tolerance| tolerance.nominal.value_si);
        assert_eq!((nominal("± 0.05 mm"), nominal("50 ± 0.05 mm")), (Some(0.0713), Some(0.05)));
    }

    #[test]
    fn deviations_alone_state_no_nominal_value() {
        for text in ["± 0.05 mm", "+/- 0.05 mm", "+0.02 -0.01 mm", "-0.01 −0.02 mm", "+0.05/-0.05 mm"] {
            assert!(!states_nominal(text), "{text}");
        }
        for text in ["50 ± 0.05 mm", "-3 ± 0.5 mm", "50 +0.02 -0.01 mm", "-20 −0.007 +0.021 mm", "50 mm"] {
            assert!(states_nominal(text), "{text}");
        }
    }

    #[test]
    fn what_is_no_tolerance_is_none() {
        for text in [
            "",
            "50 mm",
            "± mm",
            "+0.02 mm",
            "50 ± mm",
            "50 ± -0.05 mm",
            "50 mm ± 1 deg",
            "50 +0.02 mm",
            "5 ± 0.1 ± 0.2 mm",
            "a ± b mm",
            "50 ± 1 xyz",
        ] {
            assert_eq!(parse_tolerance(text, IN_MODEL), None, "{text}");
        }
    }

    #[test]
    fn nominal_values_and_deviations_are_told_apart() {
        for (text, nominal, deviations, dimension) in [
            ("30 mm +- 0.05 mm", Some("30 mm"), "± 0.05 mm", Dimension::LENGTH),
            ("30 +/- 0.05 mm", Some("30 mm"), "± 0.05 mm", Dimension::LENGTH),
            ("30 mm ±50 µm", Some("30 mm"), "± 50 µm", Dimension::LENGTH),
            ("0.6 ± 0.1", Some("0.6"), "± 0.1", Dimension::NUMBER),
            ("± 0.05 mm", None, "± 0.05 mm", Dimension::LENGTH),
            ("30 mm +0.02 −0.01", Some("30 mm"), "+0.02 -0.01 mm", Dimension::LENGTH),
            ("30 mm +20 µm / -0.01 mm", Some("30 mm"), "+20 µm -0.01 mm", Dimension::LENGTH),
            ("-0.01 -0.03 mm", None, "-0.01 -0.03 mm", Dimension::LENGTH),
        ] {
            let nominal = nominal.map(str::to_owned);
            let due = SeparateTolerance { nominal, deviations: deviations.to_owned(), dimension };
            assert_eq!(separate_tolerance(text), Some(due), "{text}");
            let again = parse_tolerance(&format!("71.3 mm {deviations}"), IN_MODEL);
            assert!(dimension == Dimension::NUMBER || again.is_some(), "a study reads {deviations}");
        }
        for text in ["30 mm", "30 mm ± 1 deg", "a ± 0.1 mm", "30 ± 0.05 xyz", "30 h9"] {
            assert_eq!(separate_tolerance(text), None, "{text}");
        }
    }
}

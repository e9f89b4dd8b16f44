//! Limits of requirements in words.

use crate::numbers::number::NumberWriter;
use crate::numbers::tag::Tag;
use crate::words::wording::path_part;
use loosepin_result::study::{PathError, RequirementOutcome, StudyResult};
use loosepin_text::units::SiUnit;

/// The limits of a requirement; a distance stays within its limit, which has no sign.
pub(crate) fn requirement_words(
    result: &StudyResult,
    requirement: &RequirementOutcome,
    unit: &SiUnit,
    writer: &NumberWriter,
) -> String {
    let RequirementOutcome { lower_si, upper_si, .. } = *requirement;
    let is_distance = matches!(path_part(&requirement.output, &result.outputs), Some((_, PathError::Magnitude)));
    if is_distance && lower_si == -upper_si && upper_si.is_finite() {
        return format!("within {}", writer.with_tag(&Tag::Given("required limit")).value_shortest(upper_si, unit));
    }
    limits_words(lower_si, upper_si, unit, writer)
}

/// "within ±0.6 mm", "below 0.6 mm", "between −0.2 and 0.6 mm".
pub(crate) fn limits_words(lower_si: f64, upper_si: f64, unit: &SiUnit, writer: &NumberWriter) -> String {
    let writer = writer.with_tag(&Tag::Given("required limit"));
    match (lower_si.is_finite(), upper_si.is_finite()) {
        (true, true) if lower_si == -upper_si => format!("within ±{}", writer.value_shortest(upper_si, unit)),
        (true, true) => {
            format!("between {} and {}", writer.shortest(lower_si, unit), writer.value_shortest(upper_si, unit))
        }
        (true, false) => format!("above {}", writer.value_shortest(lower_si, unit)),
        (false, true) => format!("below {}", writer.value_shortest(upper_si, unit)),
        (false, false) => "anywhere".to_owned(),
    }
}

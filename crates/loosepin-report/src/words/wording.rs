//! Words for the parts of a result.

use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::Tag;
use crate::words::bound::NO_ERROR;
use loosepin_result::simulation::SimulationRecord;
use loosepin_result::study::{
    BoundRecord, Deviation, Guarantee, InputDescription, InputKind, NumberKind, OutputDescription, PathError,
    PromiseRecord, Reading, ResponsePoint, Statistic, StudyResult, SurrogateRecord, TreatmentBand, TreatmentComparison,
    Verdict,
};
use loosepin_text::article::Text;
use loosepin_text::units::SiUnit;

/// What runs of a mechanism whose pins lean do not know.
pub(crate) const RUNS_WITHOUT_LEAN: &str = "Pins lean out of the plane, and runs do not: bands, forces and verdicts are without lean. Zones of \
                                            play and shares of joints without dynamics are with it; `loosepin motion` says how much it is.";

pub(crate) fn deviation_words(of: Deviation) -> String {
    if of.is_value() { of.noun().to_owned() } else { format!("{}{}", of.noun(), due_to_words(of)) }
}

/// The cause of a deviation, behind the word for it; empty where all of it is meant.
fn due_to_words(of: Deviation) -> String {
    of.cause().map_or_else(String::new, |cause| format!(" due to {cause}"))
}

pub(crate) fn place_words(at: ResponsePoint, writer: &NumberWriter) -> String {
    match at {
        ResponsePoint::Whole => "over the whole cycle".to_owned(),
        ResponsePoint::Pose { pose_rad } | ResponsePoint::Curve { pose_rad } => {
            format!("at {}", writer.with_tag(&Tag::Given("pose")).value_trimmed(pose_rad, &SiUnit::ANGLE))
        }
        ResponsePoint::Reduced { reduction } => reduction.description().words.to_owned(),
    }
}

pub(crate) fn statistic_words(statistic: Statistic, unit: &SiUnit, writer: &NumberWriter) -> String {
    let writer = writer.with_tag(&Tag::Given("parameter of a statistic"));
    let description = statistic.description();
    let number = description.number.zip(statistic.parameter()).map(|(number, value)| match number.kind {
        NumberKind::Share => writer.percent(value, Rounding::Nearest),
        NumberKind::Limit | NumberKind::LimitOfMagnitude => writer.value_trimmed(value, unit),
    });
    number.map_or_else(|| description.words.to_owned(), |number| description.words.replace("{}", &number))
}

/// Digits of the ends of bands, beside those in which the ends of the narrowest band are the same.
const WIDTH_DIGITS: usize = 3;

/// Digits of the ends of bands that resolve the least of their widths.
pub(crate) fn band_digits(comparison: &TreatmentComparison) -> usize {
    let ends = comparison.bands.iter().flat_map(|band| [band.lower_si, band.upper_si]);
    let largest = ends.map(f64::abs).filter(|end| end.is_finite()).fold(0.0, f64::max);
    let widths = comparison.bands.iter().map(TreatmentBand::width_si).filter(|width| *width > 0.0 && width.is_finite());
    let more = (largest / widths.fold(f64::INFINITY, f64::min)).log10().floor();
    WIDTH_DIGITS + if more.is_finite() { more.clamp(0.0, 9.0) as usize } else { 0 }
}

/// "93 % to 100 %": the share inside a band, over the epistemic inputs.
pub(crate) fn share_words(band: &TreatmentBand, comparison: &TreatmentComparison, writer: &NumberWriter) -> String {
    writer.with_tag(&Tag::band(comparison, band, "share")).percent_range(band.least_share(), band.coverage_maximum)
}

/// Whether the errors of the ends of bands are known.
pub(crate) fn has_errors(comparison: &TreatmentComparison) -> bool {
    comparison.bands.iter().any(|band| band.ends.is_some())
}

/// Whether the ends of a band may be further off than it is wide: then the error says no more than that.
pub(crate) fn is_error_beyond_band(band: &TreatmentBand) -> bool {
    band.error_si().is_some_and(|error_si| error_si.is_finite() && error_si > band.width_si())
}

/// The larger numerical error of the ends of a band.
pub(crate) fn band_error(band: &TreatmentBand, comparison: &TreatmentComparison, writer: &NumberWriter) -> String {
    // An end that is infinite has no error.
    if band.width_si().is_infinite() && band.error_si().is_some_and(f64::is_finite) {
        return NO_ERROR.to_owned();
    }
    if is_error_beyond_band(band) {
        return "> band".to_owned();
    }
    let tag = Tag::band(comparison, band, "error");
    band.error_si().map_or_else(String::new, |error| writer.with_tag(&tag).error(error, &comparison.unit))
}

/// Whether a band holds the share of mechanisms that it claims: "yes", "no, 65 %" or "not decided".
pub(crate) fn holds_words(band: &TreatmentBand, comparison: &TreatmentComparison, writer: &NumberWriter) -> String {
    let claimed = comparison.promised_coverage;
    if band.is_promise_unknown(claimed) {
        "not decided".to_owned()
    } else if band.keeps_promise(claimed) {
        "yes".to_owned()
    } else {
        let tag = Tag::band(comparison, band, "share lower");
        format!("no, {}", writer.with_tag(&tag).percent(band.least_share(), Rounding::Down))
    }
}

pub(crate) fn reading_words(reading: Reading) -> &'static str {
    match reading {
        Reading::FixedButUnknown => "fixed but unknown: one value, the same for all mechanisms (reading A)",
        Reading::UnknownDistribution => "with an unknown distribution, independent of the random inputs (reading A2)",
        Reading::RandomSet => "any value in each mechanism, even dependent on the random inputs (reading B)",
    }
}

/// How intervals are read in `bound`, where the study reads them in several ways: what follows the place of the bound.
pub(crate) fn reading_beside(result: &StudyResult, bound: &BoundRecord) -> String {
    if result.bounds.iter().all(|other| other.reading == bound.reading) {
        return String::new();
    }
    format!("; intervals {}", reading_words(bound.reading))
}

pub(crate) fn guarantee_words(guarantee: Guarantee, writer: &NumberWriter) -> String {
    let writer = writer.with_tag(&Tag::Given("confidence"));
    let confidence = guarantee.confidence().map(|confidence| writer.percent(confidence, Rounding::Nearest));
    guarantee.words().replace("{}", &confidence.unwrap_or_default())
}

/// A verdict in a word or two: `met`, `not met`, `undecided`, `promised`.
pub fn verdict_words(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Met => "met",
        Verdict::Promised => "promised",
        Verdict::NotMet => "not met",
        Verdict::Undecided => "undecided",
    }
}

/// Name of the unknown (epistemic) inputs.
pub(crate) const UNKNOWN_INPUTS: &str = "unknown inputs";

/// Whether anything is known as an interval, a list or so.
pub(crate) fn has_unknown(inputs: &[InputDescription]) -> bool {
    inputs.iter().any(|input| !input.kind.is_random())
}

/// Note on bounds that are put together from several intervals.
pub(crate) const MASSES_ADD: &str = "A bound from evidence adds the masses of its intervals. Each interval has its own worst value, so the table names no single one. \
     The probability-only treatment draws an interval with its mass as probability, and a uniform value inside it. The mass of a cut of a \
     fuzzy number is the difference of the degrees.";

/// Whether an input is made of several intervals.
pub(crate) fn has_parts(inputs: &[InputDescription]) -> bool {
    inputs.iter().any(|input| matches!(input.kind, InputKind::Evidence { .. } | InputKind::Fuzzy { .. }))
}

/// Note on lists in the probability-only and the interval-only treatment.
pub(crate) const EQUALLY_PROBABLE: &str = "The probability-only treatment gives all members of a list the same probability. The interval-only treatment tries all combinations.";

/// Whether an input is one of a list.
pub(crate) fn has_lists(inputs: &[InputDescription]) -> bool {
    inputs.iter().any(|input| matches!(input.kind, InputKind::Choice { .. }))
}

/// The unit of an output; that of a pure number where the result does not describe it.
pub(crate) fn output_unit(result: &StudyResult, name: &str) -> SiUnit {
    let output = result.outputs.iter().find(|output| output.name == name);
    output.map_or(SiUnit::NONE, |output| output.unit.clone())
}

/// `slider` with its meaning where there is one: `slider (x of slider.pin)`.
pub(crate) fn output_words(name: &str, outputs: &[OutputDescription]) -> String {
    let words = outputs.iter().find(|output| output.name == name).map_or("", |output| &output.words);
    named_words(name, words)
}

/// The point of a path and the part of its error, where an output is one.
pub(crate) fn path_part<'o>(name: &str, outputs: &'o [OutputDescription]) -> Option<(&'o str, PathError)> {
    let path = outputs.iter().find(|output| output.name == name)?.path.as_ref()?;
    Some((&path.point, path.part))
}

/// `deviation of slider`; of a path `error of tool (coupler.tool) across its path`.
pub(crate) fn deviation_of(name: &str, of: Deviation, outputs: &[OutputDescription]) -> String {
    let Some((point, part)) = path_part(name, outputs) else { return format!("{} of {name}", deviation_words(of)) };
    let due_to = due_to_words(of);
    let error = match part {
        PathError::Along => format!("error of {point} along its path"),
        PathError::Normal => format!("error of {point} across its path"),
        PathError::Magnitude => format!("distance of {point} from where it should be"),
        PathError::Contour => format!("distance of {point} from its path"),
    };
    format!("{error}{due_to}")
}

/// `slider (x of slider.pin): deviation, largest in the cycle`, as headings have it.
pub(crate) fn response_words(
    result: &StudyResult,
    (output, of, at): (&str, Deviation, ResponsePoint),
    writer: &NumberWriter,
) -> String {
    format!("{}: {}, {}", output_words(output, &result.outputs), deviation_words(of), place_words(at, writer))
}

/// Whether the bounds of the study are those of a surrogate that stands alone.
pub(crate) fn is_by_surrogate(result: &StudyResult) -> bool {
    result.surrogate.as_ref().is_some_and(SurrogateRecord::is_alone)
}

/// A name with its meaning where there is one.
pub(crate) fn named_words(name: &str, words: &str) -> String {
    if words.is_empty() { name.to_owned() } else { format!("{name} ({words})") }
}

/// With a capital at its beginning.
pub(crate) fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// The head of a column, on a page with a capital.
pub(crate) fn head(words: &str) -> Text {
    Text::by_medium(capitalised(words), words)
}

/// A remark below a table, of which a page makes a sentence.
pub(crate) fn remark(words: impl Into<String>) -> Text {
    let words = words.into();
    Text::by_medium(format!("{}.", capitalised(&words)), words)
}

/// A count, on a page with thousands apart: `16 384`.
pub(crate) fn count(value: u64, writer: &NumberWriter) -> String {
    writer.count(value)
}

/// Share of the scale of a quantity below which a value is round-off of the computation.
const ROUND_OFF: f64 = 1e-13;

/// A value of an extreme as it is shown: 0 where it is round-off beside the largest value of its unit, and of lengths beside the bodies.
pub(crate) fn without_round_off(record: &SimulationRecord, value_si: f64, unit: &SiUnit) -> f64 {
    if value_si.abs() < round_off_si(record, unit) { 0.0 } else { value_si }
}

/// The same of the values of a history.
pub(crate) fn all_without_round_off(record: &SimulationRecord, values_si: &[f64], unit: &SiUnit) -> Vec<f64> {
    let least_si = round_off_si(record, unit);
    values_si.iter().map(|value_si| if value_si.abs() < least_si { 0.0 } else { *value_si }).collect()
}

fn round_off_si(record: &SimulationRecord, unit: &SiUnit) -> f64 {
    let of_unit = record.extremes.iter().filter(|extreme| extreme.unit == *unit);
    let ends = of_unit.flat_map(|extreme| [extreme.minimum.value_si.abs(), extreme.maximum.value_si.abs()]);
    let points = record.drawing.bodies.iter().flat_map(|body| &body.points);
    let lengths = points.filter(|_| *unit == SiUnit::LENGTH).map(|point| point.x_m.hypot(point.y_m));
    ROUND_OFF * ends.chain(lengths).filter(|size| size.is_finite()).fold(0.0, f64::max)
}

/// `1 run`, `2 runs`.
pub(crate) fn counted(value: u64, singular: &str, writer: &NumberWriter) -> String {
    counted_as(value, singular, &format!("{singular}s"), writer)
}

/// "2 of the 533 values that were tried".
pub(crate) fn failed_words(promise: &PromiseRecord, failed: u64, writer: &NumberWriter) -> String {
    let tried = count(promise.values * promise.boxes, writer);
    format!("{} of the {tried} values that were tried", count(failed, writer))
}

/// Place of the bounds if all `count` of them are points of curves and no table shows them; `None` if there are none.
pub(crate) fn only_curves(count: usize, writer: &NumberWriter) -> Option<String> {
    (count > 0).then(|| {
        format!(
            "All bounds are points of curves: {} in bounds.csv. For one number over the whole cycle, use 'reduce' in the question.",
            counted(count as u64, "row", &writer.with_tag(&Tag::Count("points of curves")))
        )
    })
}

/// `3 more bounds are in `, `1 more bound is in `; `which` stands behind the noun, with a space at its end; `tag`: what is counted.
pub(crate) fn further(others: usize, singular: &str, which: &str, tag: &Tag, writer: &NumberWriter) -> String {
    let number = count(others as u64, &writer.with_tag(tag));
    match others {
        1 => format!("{number} more {singular} {which}is in "),
        _ => format!("{number} more {singular}s {which}are in "),
    }
}

/// `1 study`, `2 studies`.
pub(crate) fn counted_as(value: u64, singular: &str, plural: &str, writer: &NumberWriter) -> String {
    format!("{}{}{}", count(value, writer), writer.space(), if value == 1 { singular } else { plural })
}

/// `a`, `a and b`, `a, b and c`.
pub(crate) fn listed(parts: &[String]) -> String {
    loosepin_text::units::listed(parts, "and")
}

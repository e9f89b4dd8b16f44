//! What each of the three treatments assumes, which share of mechanisms its band holds, and how wide that is.

use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::{Tag, same_wording};
use crate::words::wording::{band_error, is_error_beyond_band};
use loosepin_result::study::{JointImpacts, StudyResult, TreatmentBand, TreatmentComparison};

/// Digits of proven ends, as `motion` has them.
const PROVEN_DIGITS: usize = 4;

/// One paragraph a treatment.
pub(super) fn treatment_sentences(
    result: &StudyResult,
    comparison: &TreatmentComparison,
    writer: &NumberWriter,
) -> Vec<String> {
    let sentence = |band: &TreatmentBand| {
        let share = share_sentence(band, comparison, writer);
        let width = width_sentence(band, comparison, writer);
        let ends = if band.treatment.is_mixed() {
            let tail = 0.5 * (1.0 - comparison.promised_coverage);
            let given = Tag::Given("probability");
            let [low, high] = [tail, 1.0 - tail].map(|p| writer.with_tag(&given).percent(p, Rounding::Nearest));
            let bridge = bridge(result, comparison, band, writer);
            format!(": from the least {low} to the largest {high} quantile.{bridge}")
        } else {
            ".".to_owned()
        };
        let is_worst_case = band.treatment.is_worst_case();
        let proven = if is_worst_case { proven_sentence(result, comparison, writer) } else { String::new() };
        format!("{}{ends} {share}{width}{proven}", band.treatment.assumption())
    };
    comparison.bands.iter().map(sentence).collect()
}

/// That the upper end is the quantile of the table of bounds before its error, where that was asked for.
fn bridge(
    result: &StudyResult,
    comparison: &TreatmentComparison,
    band: &TreatmentBand,
    writer: &NumberWriter,
) -> String {
    let of_band = 0.5 + 0.5 * comparison.promised_coverage;
    let bound = result.bounds.iter().find(|bound| {
        let is_of_same = (&bound.output, bound.of, bound.at) == (&comparison.output, comparison.of, comparison.at)
            && bound.treatment.is_mixed();
        let probability = bound.statistic.probability_of_quantile();
        let is_end = probability.is_some_and(|p| (p - of_band).abs() < 1e-9);
        is_of_same && is_end && bound.upper.value_si == band.upper_si && bound.upper.widened_si.is_finite()
    });
    let Some(bound) = bound else { return String::new() };
    let (end, tag) = (&bound.upper, Tag::bound(bound, "upper"));
    let widened = writer.with_tag(&tag).for_sentence(end.widened_si, end.error.total_si(), &bound.unit, Rounding::Up);
    format!(" With its error, the upper end is {widened}, as in the bounds.")
}

/// The share of mechanisms inside a band at the worst of the unknown values, beside the one that is claimed.
fn share_sentence(band: &TreatmentBand, comparison: &TreatmentComparison, writer: &NumberWriter) -> String {
    let claimed = comparison.promised_coverage;
    let claim = writer.with_tag(&Tag::Given("promised share")).percent(claimed, Rounding::Nearest);
    let tag = |part: &str| Tag::band(comparison, band, part);
    let (worst, error) = (tag("share at the worst values"), tag("error of the share"));
    let least = writer.with_tag(&tag("counted share")).percent(band.coverage_minimum, Rounding::Down);
    let writer = writer.with_tag(&worst);
    if band.is_promise_unknown(claimed) {
        let (of_what, least_share) = if band.is_by_surrogate {
            ("surrogate", band.least_share())
        } else {
            ("runs", (band.coverage_minimum - band.coverage_error).max(0.0))
        };
        return format!(
            "At the worst unknown values, {} of mechanisms lie inside the band. The {of_what} cannot show whether {claim} do.",
            writer.percent_range(least_share, band.coverage_minimum)
        );
    }
    if band.coverage_minimum >= 1.0 {
        return "Every run lies inside the band.".to_owned();
    }
    if !band.keeps_promise(claimed) {
        let is_less = band.least_share() < band.coverage_minimum;
        let least = if is_less { writer.percent_range(band.least_share(), band.coverage_minimum) } else { least };
        return format!("At the worst unknown values, only {least} of mechanisms lie inside the band, not {claim}.");
    }
    if band.coverage_minimum < claimed {
        return format!(
            "At the worst unknown values, {least} ± {} of mechanisms lie inside the band. This agrees with {claim}.",
            writer.with_tag(&error).percent(band.coverage_error, Rounding::Up)
        );
    }
    format!("At all unknown values tested, at least {least} of mechanisms lie inside the band.")
}

/// Difference in width from the mixed band, as far as its error resolves it; empty if both hardly differ.
fn width_sentence(band: &TreatmentBand, comparison: &TreatmentComparison, writer: &NumberWriter) -> String {
    let mixed = comparison.bands.iter().find(|band| band.treatment.is_mixed()).map(TreatmentBand::width_si);
    let is_known = |width: f64| width > 0.0 && width.is_finite();
    let Some(mixed) = mixed.filter(|mixed| !band.treatment.is_mixed() && is_known(*mixed)) else {
        return String::new();
    };
    // Beside a band without an end no width compares.
    if !band.width_si().is_finite() {
        return String::new();
    }
    let wider = (100.0 * (band.width_si() / mixed - 1.0)).round() / 100.0;
    let tag = Tag::band(comparison, band, "width compared with the mixed band");
    let by = writer.with_tag(&tag).percent(wider.abs(), Rounding::Nearest);
    let compared = match wider {
        0.02.. => format!("{by} wider than the mixed band"),
        ..=-0.02 => format!("{by} narrower than the mixed band"),
        _ => return String::new(),
    };
    if is_error_beyond_band(band) {
        return format!(" The band found is {compared}. How far worse cases go, its search does not show.");
    }
    if band.error_si().is_some_and(|error_si| error_si > (band.width_si() - mixed).abs()) {
        let error = band_error(band, comparison, writer);
        return format!(
            " The band found is {compared}, but the error of its ends, {error}, is larger than this difference."
        );
    }
    format!(" The band is {compared}.")
}

/// What is proven without dynamics, and what runs add to it.
fn proven_sentence(result: &StudyResult, comparison: &TreatmentComparison, writer: &NumberWriter) -> String {
    let Some([lowest_si, highest_si]) = comparison.proven_without_dynamics_si else { return String::new() };
    let end = |part: &str, value_si: f64, rounding| {
        let tag = Tag::comparison(comparison, part);
        writer.with_tag(&tag).rounded(value_si, &comparison.unit, PROVEN_DIGITS, rounding)
    };
    let highest = end("proven upper", highest_si, Rounding::Up);
    let opposite = end("proven lower, opposite", -lowest_si, Rounding::Up);
    let range = if lowest_si == 0.0 {
        format!("at most {highest}")
    } else if same_wording(&highest, &opposite) {
        format!("within ±{highest}")
    } else {
        format!("between {} and {highest}", end("proven lower", lowest_si, Rounding::Down))
    };
    let deepest =
        |a: &&JointImpacts, b: &&JointImpacts| a.largest_penetration_share.total_cmp(&b.largest_penetration_share);
    let penetration = result.impacts.iter().max_by(deepest).filter(|joint| joint.largest_penetration_share > 0.0);
    let added = penetration.map_or_else(String::new, |joint| {
        let tag = Tag::joint(&joint.joint, "penetration", "largest share");
        let share = writer.with_tag(&tag).percent(joint.largest_penetration_share, Rounding::Up);
        format!(" In the runs, parts also penetrate each other, by up to {share} of the clearance: this adds to it.")
    });
    format!(
        " Worst case without dynamics, proven: {range}, with parts within their limits or ±{} standard deviations, and any position within the play.{added}",
        writer.with_tag(&Tag::Given("standard deviations")).count(3)
    )
}

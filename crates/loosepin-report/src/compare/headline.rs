//! How much smaller or larger the main answer is in the second study.

use super::outputs::SharedOutputs;
use super::sides::for_both;
use super::statistics::{Weight, is_same};
use crate::numbers::number::{NumberWriter, Rounding};
use crate::study::output_summary::{OutputSummary, output_summaries};
use crate::words::wording::deviation_of;
use loosepin_result::study::{DeviationCurve, StudyResult};
use loosepin_text::units::SiUnit;

/// Headline if the studies share no main answer.
pub const NOTHING_IN_COMMON: &str = "The two studies have no answer in common.";
/// Digits of the values.
const DIGITS: usize = 3;

/// A number that both studies answer with.
struct Main<'r> {
    subject: String,
    values_si: [f64; 2],
    errors_si: f64,
    unit: &'r SiUnit,
}

/// The answer that A puts first of those that B has as well.
pub fn headline(pair: [&StudyResult; 2], outputs: &SharedOutputs, writer: &NumberWriter) -> String {
    let Some(main) = output_summaries(pair[0]).into_iter().find_map(|summary| main(summary, pair, outputs, writer))
    else {
        return NOTHING_IN_COMMON.to_owned();
    };
    let [before, after] = main.values_si;
    let values =
        main.values_si.map(|value_si| format!("±{}", writer.rounded(value_si, main.unit, DIGITS, Rounding::Up)));
    let sentence = format!("{} stays within {}.", main.subject, for_both(values));
    match Weight::of(after - before, main.errors_si) {
        Weight::None => format!("{sentence} There is no difference."),
        Weight::WithinErrors => format!("{sentence} The difference is within the numerical errors."),
        Weight::BeyondErrors if before > 0.0 => {
            let change = writer.percent((after / before - 1.0).abs(), Rounding::Nearest);
            format!("{sentence} The bound of B is {change} {}.", if after < before { "smaller" } else { "larger" })
        }
        Weight::BeyondErrors => sentence,
    }
}

fn main<'r>(
    summary: OutputSummary<'r>,
    pair: [&'r StudyResult; 2],
    outputs: &SharedOutputs,
    writer: &NumberWriter,
) -> Option<Main<'r>> {
    if !outputs.has(summary.output()) {
        return None;
    }
    let [before, after] = pair;
    match summary {
        OutputSummary::Largest(bound, probability) => {
            let other = after.bounds.iter().find(|other| is_same(bound, other))?;
            let ends = [&bound.upper, &other.upper];
            Some(Main {
                subject: format!(
                    "The largest {} of {} of mechanisms",
                    deviation_of(&bound.output, bound.of, &before.outputs),
                    writer.percent(probability, Rounding::Nearest)
                ),
                values_si: ends.map(|end| end.widened_si),
                errors_si: ends.iter().map(|end| end.error.total_si()).sum(),
                unit: &bound.unit,
            })
        }
        OutputSummary::Curve(curve) => {
            let other = after.curves.iter().find(|other| is_same_curve(curve, other))?;
            let share = writer.percent(curve.probabilities[1] - curve.probabilities[0], Rounding::Nearest);
            let subject = deviation_of(&curve.output, curve.of, &before.outputs);
            Some(Main {
                subject: format!("The {share} band of the {subject}"),
                values_si: [reach_si(curve)?.1, reach_si(other)?.1],
                errors_si: curve.numerical_error_si + other.numerical_error_si,
                unit: &curve.unit,
            })
        }
        OutputSummary::Bound(_) => None,
    }
}

/// Whether two curves bound the same share of the same number.
pub(super) fn is_same_curve(a: &DeviationCurve, b: &DeviationCurve) -> bool {
    a.output == b.output && a.of == b.of && a.unit == b.unit && a.probabilities == b.probabilities
}

/// Pose at which the band is farthest from zero, rad, and its distance there; `None` if the study has none.
pub(super) fn reach_si(curve: &DeviationCurve) -> Option<(f64, f64)> {
    let band = &curve.mixed;
    let at = |list: &[f64], pose: usize| list.get(pose).copied().filter(|value| value.is_finite()).map(f64::abs);
    let reach = |pose: usize| Some((curve.pose_rad[pose], at(&band.lower_si, pose)?.max(at(&band.upper_si, pose)?)));
    (0..curve.pose_rad.len()).filter_map(reach).max_by(|a, b| a.1.total_cmp(&b.1))
}

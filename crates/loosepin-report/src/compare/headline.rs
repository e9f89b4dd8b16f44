//! Which verdicts differ and by which shares, and how much smaller or larger the main answer is in the second study.

use super::outputs::SharedOutputs;
use super::requirements::ComparedRequirement;
use super::sides::{for_both, same_or_both};
use super::statistics::{Weight, is_same};
use crate::numbers::number::{NumberWriter, Rounding, significant};
use crate::study::output_summary::{OutputSummary, output_summaries};
use crate::words::wording::{capitalised, deviation_of, verdict_words};
use loosepin_result::study::{BoundRecord, DeviationCurve, ResponsePoint, StudyResult, Verdict};
use loosepin_text::units::SiUnit;

/// Headline if the studies share no main answer.
pub const NOTHING_IN_COMMON: &str = "The two studies have no answer in common.";
/// Requirements with other verdicts that the headline names.
const MAX_NAMED: usize = 2;
/// Digits of a factor.
const TIMES_DIGITS: usize = 2;

/// A bound that both studies answer with.
struct Main<'r> {
    subject: String,
    /// The bounds, each with its numerical error included: the value found and the error added.
    bounds_si: [f64; 2],
    /// Numerical errors of the values found, or more.
    errors_si: [f64; 2],
    /// Errors to which each study rounds its bound.
    rounded_to_si: [f64; 2],
    unit: &'r SiUnit,
}

impl Main<'_> {
    /// Whether the values found are so far apart that their errors do not explain it: the larger bound less both its errors, above and
    /// below the value found, is still beyond the smaller bound.
    fn weight(&self) -> Weight {
        let [before, after] = self.bounds_si;
        let larger = usize::from(after > before);
        Weight::of(after - before, 2.0 * self.errors_si[larger])
    }
}

/// What changed of the verdicts and by which shares, and the answer that A puts first of those that B has as well.
pub fn headline(
    pair: [&StudyResult; 2],
    outputs: &SharedOutputs,
    requirements: &[ComparedRequirement],
    writer: &NumberWriter,
) -> String {
    let mut sentences = verdict_sentences(pair, requirements);
    let main = output_summaries(pair[0]).into_iter().find_map(|summary| main(summary, pair, outputs, writer));
    sentences.extend(main.map(|main| main_sentences(&main, writer)));
    if sentences.is_empty() { NOTHING_IN_COMMON.to_owned() } else { sentences.join(" ") }
}

/// Each requirement whose verdict differs, with the shares that decide it.
fn verdict_sentences(pair: [&StudyResult; 2], requirements: &[ComparedRequirement]) -> Vec<String> {
    let changed: Vec<_> = requirements.iter().filter_map(|row| Some((row, changed_verdicts(row)?))).collect();
    let mut sentences = Vec::new();
    if let [Some(first), Some(second)] = pair.map(StudyResult::verdict)
        && first != second
        && requirements.len() > 1
    {
        sentences.push(format!("Requirements: {}.", for_both([first, second].map(verdict_words))));
    }
    sentences.extend(changed.iter().take(MAX_NAMED).map(|(row, verdicts)| {
        let words =
            |sides: &[Option<String>; 2]| same_or_both(sides.each_ref().map(|side| side.as_deref().unwrap_or("-")));
        let beyond = if is_decided_otherwise(row) { "; they differ by more than their errors" } else { "" };
        format!(
            "{}: {}. Required: {}; shares inside: {}{beyond}.",
            capitalised(&row.what),
            for_both(verdicts.map(verdict_words)),
            words(&row.required),
            words(&row.kept),
        )
    }));
    match changed.len().saturating_sub(MAX_NAMED) {
        0 => {}
        1 => sentences.push("1 more requirement has another verdict.".to_owned()),
        more => sentences.push(format!("{more} more requirements have other verdicts.")),
    }
    sentences
}

/// The verdicts of a requirement of both studies, where they differ.
fn changed_verdicts(row: &ComparedRequirement) -> Option<[Verdict; 2]> {
    let [Some(first), Some(second)] = row.verdicts else { return None };
    (first != second).then_some([first, second])
}

/// The bound of both studies and its change.
fn main_sentences(main: &Main<'_>, writer: &NumberWriter) -> String {
    let [before, after] = main.bounds_si;
    // As the sentences of each study have it.
    let bounds = [0, 1].map(|side| {
        let bound = writer.for_sentence(main.bounds_si[side], main.rounded_to_si[side], main.unit, Rounding::Up);
        format!("±{bound}")
    });
    let mut sentences = vec![format!("{} stays within {}.", main.subject, for_both(bounds))];
    match main.weight() {
        Weight::None => sentences.push("There is no difference.".to_owned()),
        Weight::WithinErrors => {
            let errors = main.errors_si.map(|error_si| writer.error(error_si, main.unit));
            sentences.push(format!("This difference may be numerical: the errors are {}.", for_both(errors)));
        }
        Weight::BeyondErrors if before > 0.0 && after >= 2.0 * before => {
            let times = significant(after / before, TIMES_DIGITS, Rounding::Nearest);
            sentences.push(format!("The bound of B is {times} times as large."));
        }
        Weight::BeyondErrors if before > 0.0 => {
            let change = writer.percent((after / before - 1.0).abs(), Rounding::Nearest);
            let word = if after < before { "smaller" } else { "larger" };
            sentences.push(format!("The bound of B is {change} {word}."));
        }
        Weight::BeyondErrors => {}
    }
    sentences.join(" ")
}

/// Whether a requirement with the same limits is met in one study and not in the other, whatever their errors.
fn is_decided_otherwise(requirement: &ComparedRequirement) -> bool {
    let is_pair = matches!(
        requirement.verdicts,
        [Some(Verdict::Met), Some(Verdict::NotMet)] | [Some(Verdict::NotMet), Some(Verdict::Met)]
    );
    is_pair && requirement.required[0] == requirement.required[1]
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
            let errors_si = ends.map(|end| end.error.total_si());
            Some(Main {
                subject: format!(
                    "The largest {} of {} of mechanisms",
                    deviation_of(&bound.output, bound.of, &before.outputs),
                    writer.percent(probability, Rounding::Nearest)
                ),
                bounds_si: ends.map(|end| end.widened_si),
                errors_si,
                rounded_to_si: errors_si,
                unit: &bound.unit,
            })
        }
        OutputSummary::Curve(curve) => {
            let other = after.curves.iter().find(|other| is_same_curve(curve, other))?;
            let share = writer.percent(curve.probabilities[1] - curve.probabilities[0], Rounding::Nearest);
            let subject = deviation_of(&curve.output, curve.of, &before.outputs);
            let reaches = [reach_si(curve)?, reach_si(other)?];
            Some(Main {
                subject: format!("The {share} band of the {subject}"),
                bounds_si: reaches.map(|(_, reach_si)| reach_si),
                errors_si: [error_at_si(before, curve, reaches[0]), error_at_si(after, other, reaches[1])],
                rounded_to_si: [curve, other].map(|curve| curve.numerical_error_si),
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

/// Numerical error of the band at a pose at which it reaches so far. Elsewhere it may be much larger: where the record does not hold the
/// bound of this pose, the largest error of the curve is given.
fn error_at_si(result: &StudyResult, curve: &DeviationCurve, (pose_rad, reach_si): (f64, f64)) -> f64 {
    let is_there = |bound: &&BoundRecord| {
        (&bound.output, bound.of) == (&curve.output, curve.of)
            && bound.treatment.is_mixed()
            && bound.at == ResponsePoint::Curve { pose_rad }
            && bound.statistic.probability_of_quantile().is_some_and(|p| curve.probabilities.contains(&p))
    };
    let ends = result.bounds.iter().filter(is_there).flat_map(|bound| [&bound.lower, &bound.upper]);
    // A band that is narrowed to the limit over the whole cycle is no bound of its pose any more.
    let errors = ends.filter(|end| end.widened_si.abs().total_cmp(&reach_si).is_eq()).map(|end| end.error.total_si());
    errors.reduce(f64::max).unwrap_or(curve.numerical_error_si)
}

/// Pose at which the band is farthest from zero, rad, and its distance there; `None` if the study has none.
pub(super) fn reach_si(curve: &DeviationCurve) -> Option<(f64, f64)> {
    let band = &curve.mixed;
    let at = |list: &[f64], pose: usize| list.get(pose).copied().filter(|value| value.is_finite()).map(f64::abs);
    let reach = |pose: usize| Some((curve.pose_rad[pose], at(&band.lower_si, pose)?.max(at(&band.upper_si, pose)?)));
    (0..curve.pose_rad.len()).filter_map(reach).max_by(|a, b| a.1.total_cmp(&b.1))
}

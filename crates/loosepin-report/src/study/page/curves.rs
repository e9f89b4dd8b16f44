//! The deviation over the cycle, and probability boxes.

use maud::{Markup, html};

use super::what_if::what_if;
use crate::charts::chart::{Chart, Entry, EntryValues, Mark, Role, scaled};
use crate::charts::figure::name_of;
use crate::charts::path_figure::path_figure;
use crate::charts::zone_figure::zone_figure;
use crate::medium::script_data::round_to_digits;
use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::{Tag, same_wording};
use crate::words::failed::why_quantile_has_no_end;
use crate::words::few_samples::too_few_samples;
use crate::words::limits::requirement_words;
use crate::words::wording::{capitalised, deviation_words, output_words, path_part, place_words};
use loosepin_result::study::{
    BoundRecord, CurveRange, Deviation, DeviationCurve, Event, InputKind, ProbabilityBox, RequirementOutcome,
    ResponsePoint, SimultaneousCurve, StudyResult, ValueBand, Witness,
};
use loosepin_text::units::SiUnit;

/// The chart below the answer on the first screen.
pub(super) struct FirstChart {
    pub markup: Markup,
    /// Probability boxes in it.
    pub boxes: usize,
}

/// The band of the curve that a requirement is about, else of the first one; where no curve was asked for, the first distribution.
pub(super) fn first_chart(result: &StudyResult, writer: &NumberWriter) -> FirstChart {
    if let Some(curve) = first_curve(result).and_then(|index| result.curves.get(index)) {
        let chart = deviation_chart(result, curve, writer);
        let inner = chart.entries.iter().position(|entry| entry.role == Role::Random);
        let known = what_if(result, curve, &chart.id, (inner, &share_inside(curve, writer)), writer);
        return FirstChart { markup: html! { (chart.figure()) (known) }, boxes: 0 };
    }
    let first = result.boxes.first().map(|pbox| box_chart(result, pbox, 0, writer).figure());
    FirstChart { boxes: usize::from(first.is_some()), markup: first.unwrap_or_default() }
}

/// The curve that a requirement is about, else the first one.
fn first_curve(result: &StudyResult) -> Option<usize> {
    let is_required = |curve: &DeviationCurve| !limits_of(result, curve).is_empty();
    (!result.curves.is_empty()).then(|| result.curves.iter().position(is_required).unwrap_or(0))
}

/// Values of the epistemic inputs that the page offers below its first chart.
#[derive(Debug, Clone, PartialEq)]
pub struct KnownValue {
    /// All of them in words.
    pub words: String,
    /// The same by path.
    pub values: Witness,
}

/// Inputs whose value can be chosen on the page, in its order; empty if there are none.
pub fn known_values(result: &StudyResult) -> Vec<KnownValue> {
    let writer = NumberWriter::for_page(&result.display_units);
    let curve = first_curve(result).and_then(|index| result.curves.get(index));
    let values = curve.map_or(&[][..], |curve| &curve.at_values);
    let told =
        |value: &ValueBand| KnownValue { words: writer.witness(&value.at, &result.inputs), values: value.at.clone() };
    // One value alone is no choice.
    if values.len() > 1 { values.iter().map(told).collect() } else { Vec::new() }
}

/// The bands that the first screen does not have.
pub(super) fn other_charts(result: &StudyResult, writer: &NumberWriter) -> Markup {
    let first = first_curve(result);
    html! {
        @for (index, curve) in result.curves.iter().enumerate() {
            @if Some(index) != first { (deviation_chart(result, curve, writer).figure()) }
        }
    }
}

/// Paths with the zones about them: of the studied deviations, then to first order.
pub(super) fn zones(result: &StudyResult, writer: &NumberWriter) -> Markup {
    html! {
        @for curve in &result.curves {
            @let name = name_of("path", &format!("{} {}", curve.output, curve.of.word()));
            (zone_figure(curve, name, &point_words(result, curve), writer))
        }
        @if let Some(of_cycle) = &result.paths {
            div.charts {
                @for path in &of_cycle.paths { (path_figure(path, &of_cycle.drive, &of_cycle.drive_angle_rad, writer)) }
            }
        }
    }
}

/// The point whose path a curve is about; the output where it is none.
fn point_words(result: &StudyResult, curve: &DeviationCurve) -> String {
    let part = path_part(&curve.output, &result.outputs);
    part.map_or_else(|| curve.output.clone(), |(point, _)| point.to_owned())
}

/// The name of a figure: `deviation.slider`, `clearance.slider`.
fn curve_name(curve: &DeviationCurve) -> String {
    let kind = if curve.of == Deviation::of_all_causes() { "deviation" } else { curve.of.word() };
    name_of(kind, &curve.output)
}

/// Which share of mechanisms a band at one angle holds, in words.
fn share_inside(curve: &DeviationCurve, writer: &NumberWriter) -> String {
    writer
        .with_tag(&Tag::Given("probability"))
        .percent(curve.probabilities[1] - curve.probabilities[0], Rounding::Nearest)
}

fn deviation_chart(result: &StudyResult, curve: &DeviationCurve, writer: &NumberWriter) -> Chart {
    let share = share_inside(curve, writer);
    let range = |range: &CurveRange| {
        (scaled(&range.lower_si, &curve.unit, writer), scaled(&range.upper_si, &curve.unit, writer))
    };
    let mut entries = Vec::new();
    let mut add = |label: String, role, dashed, values| entries.push(Entry::new(label, role, dashed, values));
    if !curve.mixed.lower_si.is_empty() {
        let (lower, upper) = range(&curve.mixed);
        let label = format!("{share}, all unknown values");
        add(label, Role::Mixed, false, EntryValues::band(&lower, &upper));
    }
    for each in curve.simultaneous.iter().filter(|each| !each.band.lower_si.is_empty()) {
        let (lower, upper) = range(&each.band);
        let label = format!(
            "{} for the whole cycle",
            writer.with_tag(&Tag::Given("probability")).percent(each.share, Rounding::Nearest)
        );
        add(label, Role::Mixed, true, EntryValues::pair(&lower, &upper));
    }
    let has_random = curve.random.lower_si.iter().any(|value| value.is_finite());
    if has_random {
        let (lower, upper) = range(&curve.random);
        add(format!("{share}, random scatter only"), Role::Random, false, EntryValues::band(&lower, &upper));
    }
    if !curve.nominal_si.is_empty() {
        let values = scaled(&curve.nominal_si, &curve.unit, writer);
        add("nominal parts".to_owned(), Role::Nominal, true, EntryValues::line(&values));
    }
    for (label, lower_si, upper_si) in limits(result, curve, writer) {
        let constant = |value_si: f64| vec![writer.scaled(value_si, &curve.unit); curve.pose_rad.len()];
        add(label, Role::Limit, true, EntryValues::pair(&constant(lower_si), &constant(upper_si)));
    }
    let (worst_angle, worst) = worst_pose(curve);
    let subject = output_words(&curve.output, &result.outputs);
    let centre = writer.with_tag(&Tag::curve(curve, "centre")).witness(&curve.centre, &result.inputs);
    let worst_words = if worst.is_finite() {
        let [angle, reach] = ["mixed reach angle", "mixed reach"].map(|part| Tag::curve(curve, part));
        let angle = writer.with_tag(&angle).angle_in_turn(worst_angle, 3);
        let reach = writer.with_tag(&reach).for_sentence(worst, curve.numerical_error_si, &curve.unit, Rounding::Up);
        format!("is largest at {angle}, {reach} from zero")
    } else {
        let reason = too_few_samples(result, &curve.probabilities, writer);
        let failed = why_quantile_has_no_end(result, &curve.probabilities, writer);
        let reason = reason.as_deref().or(failed).unwrap_or("some quantiles have none");
        format!("has no end at some angles: {reason}")
    };
    Chart {
        y_label: format!("{} of {}", deviation_words(curve.of), curve.output),
        y_symbol: writer.symbol(&curve.unit),
        entries,
        height: 380,
        is_periodic: is_periodic(result, curve),
        caption: html! {
            strong { (capitalised(&deviation_words(curve.of))) " of " (subject) ". " }
            "At each angle, " (share) " of mechanisms lie inside the orange band for all unknown values"
            @if has_random {
                ", and inside the blue band for "
                // The script says which value was chosen.
                span data-inner="" {
                    "mid-range values of the unknown inputs"
                    @if !centre.is_empty() { " (" (centre) ")" }
                }
            } @else if has_evidence(result) {
                ". With evidence, mechanisms belong to several intervals, so there is no band for a single value of the unknown inputs"
            }
            ". The orange band " (worst_words) "."
            @for each in &curve.simultaneous {
                " " (simultaneous_words(curve, each, writer))
            }
        },
        alternative: format!(
            "Chart of the {} of {} over one turn of {}; the band for all unknown values {worst_words}.",
            deviation_words(curve.of),
            subject,
            result.cycle.drive
        ),
        ..Chart::over_angle(curve_name(curve), &result.cycle.drive, &curve.pose_rad, writer)
    }
}

/// Whether the last pose of a turn is followed by the first one: not where the runs begin with the recorded part, in a position without
/// play that they do not come back to. The ideal motion does.
fn is_periodic(result: &StudyResult, curve: &DeviationCurve) -> bool {
    result.cycle.recorded_turns == 1.0 && (result.cycle.transient_turns >= 1.0 || !curve.of.has_play())
}

/// Whether an input has several intervals with masses.
fn has_evidence(result: &StudyResult) -> bool {
    result.inputs.iter().any(|input| matches!(input.kind, InputKind::Evidence { .. }))
}

/// Sentence on the band for whole curves.
fn simultaneous_words(curve: &DeviationCurve, each: &SimultaneousCurve, writer: &NumberWriter) -> String {
    let share = writer.with_tag(&Tag::Given("probability")).percent(each.share, Rounding::Nearest);
    if each.band.lower_si.is_empty() {
        return format!("The runs give no band in which {share} of mechanisms stay for the whole cycle.");
    }
    let factor = writer.with_tag(&Tag::curve(curve, &format!("factor of the band of {}", each.share))).rounded(
        each.factor,
        &SiUnit::NONE,
        3,
        Rounding::Up,
    );
    format!(
        "{share} of mechanisms stay between the dashed lines for the whole cycle, for all unknown values. That band is {factor} times as \
         wide as the band of the same share at each single angle."
    )
}

/// The limits that a requirement puts on this deviation over the cycle.
fn limits(result: &StudyResult, curve: &DeviationCurve, writer: &NumberWriter) -> Vec<(String, f64, f64)> {
    limits_of(result, curve)
        .into_iter()
        .map(|requirement| {
            let words = requirement_words(result, requirement, &curve.unit, writer);
            (format!("required: {words}"), requirement.lower_si, requirement.upper_si)
        })
        .collect()
}

fn limits_of<'a>(result: &'a StudyResult, curve: &DeviationCurve) -> Vec<&'a RequirementOutcome> {
    let concerns = |requirement: &&RequirementOutcome| {
        requirement.output == curve.output && requirement.of == curve.of && requirement.at == ResponsePoint::Whole
    };
    result.requirements.iter().filter(concerns).collect()
}

fn worst_pose(curve: &DeviationCurve) -> (f64, f64) {
    let reach = |pose: usize| {
        let at = |list: &[f64]| list.get(pose).copied().unwrap_or(0.0).abs();
        at(&curve.mixed.lower_si).max(at(&curve.mixed.upper_si))
    };
    (0..curve.pose_rad.len())
        .map(|pose| (curve.pose_rad[pose], reach(pose)))
        .max_by(|a, b| a.1.total_cmp(&b.1))
        .unwrap_or((0.0, 0.0))
}

/// Probability boxes but the first `shown` ones.
pub(super) fn box_charts(result: &StudyResult, shown: usize, writer: &NumberWriter) -> Markup {
    html! {
        p {
            "The share of mechanisms that stay below a given value lies inside the orange band. The height of the band shows the \
             effect of the unknown inputs."
        }
        @for (index, probability_box) in result.boxes.iter().enumerate().skip(shown) {
            (box_chart(result, probability_box, index, writer).figure())
        }
    }
}

/// The name of a figure: `distribution.slider`, with a number from the second one of an output on.
fn box_name(result: &StudyResult, index: usize) -> String {
    let output = &result.boxes[index].output;
    let name = name_of("distribution", output);
    match result.boxes[..index].iter().filter(|before| before.output == *output).count() {
        0 => name,
        before => format!("{name}.{}", before + 1),
    }
}

fn box_chart(result: &StudyResult, pbox: &ProbabilityBox, index: usize, writer: &NumberWriter) -> Chart {
    let percent = |list: &[f64]| -> Vec<f64> { list.iter().map(|share| 100.0 * share).collect() };
    let response = format!(
        "{} of {}, {}",
        deviation_words(pbox.of),
        output_words(&pbox.output, &result.outputs),
        place_words(pbox.at, writer)
    );
    let values = EntryValues::band(&percent(&pbox.lower), &percent(&pbox.upper));
    let mut entries = vec![Entry::new("bounds of the share", Role::Mixed, false, values)];
    if !pbox.probability_only.is_empty() {
        let values = EntryValues::line(&percent(&pbox.probability_only));
        entries.push(Entry::new("probability only", Role::Probability, true, values));
    }
    let marks: Vec<Mark> = pbox
        .limit_si
        .iter()
        .map(|limit_si| Mark {
            at: round_to_digits(writer.scaled(*limit_si, &pbox.unit), 6),
            label: writer.with_tag(&Tag::Given("limit")).value_trimmed(*limit_si, &pbox.unit),
        })
        .collect();
    let limit_words = pbox.limit_si.map(|limit_si| limit_sentence(result, pbox, limit_si, writer)).unwrap_or_default();
    let [from_tag, to_tag] = ["median lower", "median upper"].map(|part| Tag::distribution(pbox, part));
    let (of_from, of_to) = (writer.with_tag(&from_tag), writer.with_tag(&to_tag));
    let median = match median_range(&pbox.value_si, &pbox.lower, &pbox.upper) {
        [Some(from), Some(to)] => format!(
            "The median lies between {} and {}.",
            of_from.rounded_without_unit(from, &pbox.unit, 2, Rounding::Down),
            of_to.rounded(to, &pbox.unit, 2, Rounding::Up)
        ),
        [None, Some(to)] => format!("The median is at most {}.", of_to.rounded(to, &pbox.unit, 2, Rounding::Up)),
        [Some(from), None] => {
            format!("The median is at least {}.", of_from.rounded(from, &pbox.unit, 2, Rounding::Down))
        }
        [None, None] => String::new(),
    };
    let x_label = format!("{} of {}", deviation_words(pbox.of), pbox.output);
    Chart {
        y_label: "share of mechanisms below".to_owned(),
        y_symbol: "%".to_owned(),
        y_range: Some([0.0, 100.0]),
        entries,
        marks,
        height: 320,
        caption: html! {
            strong { (capitalised(&response)) ". " } (median) " " (limit_words)
            " Shares ± " (writer.with_tag(&Tag::distribution(pbox, "error")).percent(pbox.numerical_error, Rounding::Up)) "."
        },
        alternative: format!("Probability box: {response}. {median}"),
        ..Chart::over(box_name(result, index), &x_label, &pbox.value_si, &pbox.unit, writer)
    }
}

/// Between which of the values at which the shares are known the median lies: at the first the upper share is still below one half,
/// at the second the lower one is not. Nothing where no value is known to be beyond it.
fn median_range(value_si: &[f64], lower: &[f64], upper: &[f64]) -> [Option<f64>; 2] {
    let first_half = |shares: &[f64]| shares.iter().position(|share| *share >= 0.5).unwrap_or(shares.len());
    let from = first_half(upper).checked_sub(1).and_then(|place| value_si.get(place));
    [from, value_si.get(first_half(lower))].map(Option::<&f64>::copied)
}

/// Between what the share below `limit_si` lies, by the values on both sides of it.
fn share_range(limit_si: f64, value_si: &[f64], lower: &[f64], upper: &[f64]) -> [f64; 2] {
    let above = value_si.partition_point(|value_si| *value_si < limit_si);
    let least = above.checked_sub(1).and_then(|place| lower.get(place));
    [least.copied().unwrap_or(0.0), upper.get(above).copied().unwrap_or(1.0)]
}

/// The share below the limit that was asked about: as its own bound has it, with its error; else read off the box outwards.
fn limit_sentence(result: &StudyResult, pbox: &ProbabilityBox, limit_si: f64, writer: &NumberWriter) -> String {
    if pbox.value_si.is_empty() {
        return String::new();
    }
    let bounded = bounded_share(result, pbox, limit_si).map(|share| (share, ""));
    let read_off = || (share_range(limit_si, &pbox.value_si, &pbox.lower, &pbox.upper), " that were run");
    let ([least, most], which) = bounded.unwrap_or_else(read_off);
    let limit = writer.with_tag(&Tag::Given("limit")).value_trimmed(limit_si, &pbox.unit);
    let [lower, upper] = ["share below lower", "share below upper"].map(|part| Tag::distribution(pbox, part));
    let [least, most] =
        [writer.with_tag(&lower).percent(least, Rounding::Down), writer.with_tag(&upper).percent(most, Rounding::Up)];
    if same_wording(&least, &most) {
        return format!("Below {limit}: {least} of mechanisms{which}.");
    }
    format!("Below {limit}: between {least} and {most} of mechanisms{which}.")
}

/// Least and largest share below the limit, where a probability of the same was asked for.
fn bounded_share(result: &StudyResult, pbox: &ProbabilityBox, limit_si: f64) -> Option<[f64; 2]> {
    let is_own = |bound: &&BoundRecord| {
        bound.treatment.is_mixed() && (&bound.output, bound.of, bound.at) == (&pbox.output, pbox.of, pbox.at)
    };
    result.bounds.iter().filter(is_own).find_map(|bound| {
        let ends = [bound.lower.widened_si, bound.upper.widened_si];
        match bound.statistic.event()? {
            Event::Above(own) if own == limit_si => Some([1.0 - ends[1], 1.0 - ends[0]]),
            Event::Below(own) if own == limit_si => Some(ends),
            _ => None,
        }
    })
}

#[cfg(test)]
mod tests {
    use super::{median_range, share_range};

    /// Least and greatest share of Y below y: Y uniform between u - 1 and u + 1, u anywhere in [-1, 1].
    fn shares(y: f64) -> [f64; 2] {
        [(0.5 * y).clamp(0.0, 1.0), (0.5 * y + 1.0).clamp(0.0, 1.0)]
    }

    fn sampled(values: &[f64]) -> [Vec<f64>; 2] {
        [0, 1].map(|end| values.iter().map(|&y| shares(y)[end]).collect())
    }

    #[test]
    fn analytic_the_median_lies_between_values_outside_of_its_range() {
        // The median is u: from -1 to 1.
        let values = [-1.7, -0.6, 0.4, 1.3, 2.2];
        let [lower, upper] = sampled(&values);
        assert_eq!(median_range(&values, &lower, &upper), [Some(-1.7), Some(1.3)]);
        let ends = |from: usize, to: usize| median_range(&values[from..to], &lower[from..to], &upper[from..to]);
        assert_eq!(ends(1, 5), [None, Some(1.3)]);
        assert_eq!(ends(0, 3), [Some(-1.7), None]);
        assert_eq!(median_range(&[], &[], &[]), [None, None]);
    }

    #[test]
    fn analytic_shares_below_any_limit_lie_in_what_is_read_off() {
        let values = [0.4, 0.9, 1.7];
        let [lower, upper] = sampled(&values);
        for limit in [-2.5, -0.2, 0.3, 0.4, 0.6, 1.7, 1.9, 2.5] {
            let ([least, most], [from, to]) = (shares(limit), share_range(limit, &values, &lower, &upper));
            assert!(from <= least && most <= to, "{limit}: {from} to {to}, not {least} to {most}");
        }
        // On either side of 0.6: 0.2 at 0.4 and 1 at 0.9.
        assert_eq!(share_range(0.6, &values, &lower, &upper), [0.2, 1.0]);
    }
}

//! The page of a sweep: period of the motion, impacts and forces over the swept value.

use maud::{Markup, html};

use super::chart::{Chart, Entry, Role};
use super::number::{NumberWriter, Rounding};
use super::page::{Page, Section, facts, sentences};
use super::repeat_section::repeat_section;
use super::section_figure::section_figure;
use super::wording::{capitalised, counted};
use loosepin_result::simulation::REPEAT_SHARE;
use loosepin_result::sweep::{SweepRecord, SweptJoint};
use loosepin_text::units::SiUnit;

/// The page of a sweep as one HTML text that needs no network: a bifurcation diagram for each position and angle, impacts,
/// loss of contact and peak forces of each joint. Text from files is escaped.
pub fn sweep_page(record: &SweepRecord) -> String {
    let writer = NumberWriter::for_page(&record.display_units);
    let mut sections =
        vec![Section::new("sections", "Periodic and non-periodic motion", bifurcations(record, &writer))];
    if !record.joints.is_empty() {
        sections.push(Section::new("joints", "Impacts and forces in the joints", joints(record, &writer)));
    }
    sections.push(Section::new("method", "How this was computed", method(record, &writer)));
    sections.extend(repeat_section(&record.repeat));
    Page {
        title: record.model.clone(),
        kicker: "Sweep",
        subtitle: html! {
            (record.path) " from " (end(record, 0, &writer)) " to " (end(record, record.points.len() - 1, &writer))
            @for change in &record.overrides { " · " code { (change.path) " = " (change.written) } }
        },
        answer: sentences(&headline_sentences(record, &writer)),
        is_answer_short: true,
        beside: html! {},
        below: html! {},
        sections,
        identity: "sweep".to_owned(),
        version: record.version.clone(),
    }
    .into_html()
}

fn end(record: &SweepRecord, index: usize, writer: &NumberWriter) -> String {
    record.points.get(index).map_or_else(String::new, |point| writer.value_trimmed(point.value_si, &record.unit))
}

/// Neighbouring values whose motion is of one kind.
pub(super) struct Stretch {
    /// Turns after which the motion repeats itself; none where it does not; `Err` where the runs failed.
    pub period: Result<Option<u32>, ()>,
    /// First and last index.
    pub range: [usize; 2],
}

/// The kinds of motion in the order of the values.
pub(super) fn stretches(record: &SweepRecord) -> Vec<Stretch> {
    let mut stretches: Vec<Stretch> = Vec::new();
    for (index, point) in record.points.iter().enumerate() {
        let period = if point.failure.is_some() { Err(()) } else { Ok(point.period_turns) };
        match stretches.last_mut() {
            Some(last) if last.period == period => last.range[1] = index,
            _ => stretches.push(Stretch { period, range: [index, index] }),
        }
    }
    stretches
}

/// `repeats itself every turn`.
pub(super) fn period_words(period: Result<Option<u32>, ()>) -> String {
    match period {
        Ok(Some(1)) => "repeats every turn".to_owned(),
        Ok(Some(turns)) => format!("repeats every {turns} turns"),
        Ok(None) => "does not repeat".to_owned(),
        Err(()) => "could not be computed".to_owned(),
    }
}

/// The answer in sentences, the most important first; for pages and terminals alike.
pub(super) fn headline_sentences(record: &SweepRecord, writer: &NumberWriter) -> Vec<String> {
    let runs = record.points.len();
    let repeating = record.points.iter().filter(|point| point.period_turns.is_some()).count();
    let failed: Vec<&str> = record.points.iter().filter_map(|point| point.failure.as_deref()).collect();
    let irregular = runs - repeating - failed.len();
    let first = if irregular == 0 && failed.is_empty() {
        format!("The motion repeats at all {runs} values of {}.", record.path)
    } else if failed.len() == runs {
        format!("All {runs} runs failed: no value of {} gives a motion.", record.path)
    } else if repeating == 0 && failed.is_empty() {
        format!(
            "The motion repeats at none of the {runs} values of {}. Use statistics over many turns, not a single history.",
            record.path
        )
    } else {
        format!(
            "The motion repeats at {repeating} of {runs} values of {} and does not repeat at {irregular}. Where it does not repeat, use \
             statistics over many turns, not a single history.",
            record.path
        )
    };
    let mut sentences = vec![first];
    let mut parts: Vec<Stretch> = stretches(record).into_iter().filter(|stretch| stretch.period.is_ok()).collect();
    parts.sort_by_key(|stretch| std::cmp::Reverse(stretch.range[1] - stretch.range[0]));
    parts.truncate(4);
    parts.sort_by_key(|stretch| stretch.range[0]);
    let words: Vec<String> = parts
        .iter()
        .filter(|stretch| stretch.range[1] > stretch.range[0])
        .map(|stretch| {
            format!(
                "from {} to {} it {}",
                end(record, stretch.range[0], writer),
                end(record, stretch.range[1], writer),
                period_words(stretch.period)
            )
        })
        .collect();
    if words.len() > 1 {
        sentences.push(format!("Longest ranges: {}.", words.join("; ")));
    }
    if let Some(reason) = failed.first() {
        let failed = counted(failed.len() as u64, "run", writer);
        sentences.push(format!("{failed} failed. The first reason: {reason}"));
    }
    sentences
}

fn bifurcations(record: &SweepRecord, writer: &NumberWriter) -> Markup {
    html! {
        p {
            "A motion that repeats every turn gives one dot above its value, every second turn two dots. A motion that is not periodic \
             gives a cloud. The first " (record.transient_turns) " turns are not shown."
        }
        @for output in 0..record.outputs.len() { (section_figure(record, output, writer)) }
    }
}

fn joints(record: &SweepRecord, writer: &NumberWriter) -> Markup {
    let forces = |joint: &SweptJoint| joint.peak_force_n;
    html! {
        (joint_chart(record, "impacts", "impacts a turn", &SiUnit::NONE, |joint| joint.impacts_per_turn, writer))
        (joint_chart(record, "flight", "share of the time without contact", &SiUnit::NONE, |joint| joint.flight_share, writer))
        (joint_chart(record, "force", "largest normal force", &SiUnit::FORCE, forces, writer))
    }
}

fn joint_chart(
    record: &SweepRecord,
    id: &str,
    what: &str,
    unit: &SiUnit,
    read: impl Fn(&SweptJoint) -> f64,
    writer: &NumberWriter,
) -> Markup {
    let values_si: Vec<f64> = record.points.iter().map(|point| point.value_si).collect();
    let entries = record.joints.iter().enumerate().map(|(index, joint)| {
        let of_joint: Vec<f64> =
            record.points.iter().map(|point| point.joints.get(index).map_or(f64::NAN, &read)).collect();
        Entry::line(joint, Role::of_index(index), false, &of_joint, unit, writer)
    });
    let all = record.points.iter().flat_map(|point| point.joints.iter().map(&read));
    let (least, most) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    let range = if least.is_finite() {
        format!(
            "between {} and {}",
            writer.rounded(least, unit, 3, Rounding::Nearest),
            writer.rounded(most, unit, 3, Rounding::Nearest)
        )
    } else {
        "not computed".to_owned()
    };
    Chart {
        y_label: what.to_owned(),
        y_symbol: writer.symbol(unit),
        entries: entries.collect(),
        height: 240,
        caption: html! { strong { (capitalised(what)) } ": " (range) "." },
        alternative: format!("Chart of {what} over {}: {range}.", record.path),
        ..Chart::over(id.to_owned(), &record.path, &values_si, &record.unit, writer)
    }
    .figure()
}

fn method(record: &SweepRecord, writer: &NumberWriter) -> Markup {
    let rows = vec![
        (
            "Runs".to_owned(),
            html! {
                (record.points.len()) ", each from the ideal position and velocities; " (record.transient_turns)
                " turns of start-up, " (record.recorded_turns) " turns examined"
            },
        ),
        (
            "Period".to_owned(),
            html! {
                "p turns, if every journal is back within " (writer.percent(REPEAT_SHARE, Rounding::Nearest))
                " of its clearance after every p turns; p is at most half of the turns examined"
            },
        ),
        (
            "Tolerance of a step".to_owned(),
            html! { (format!("{:e}", record.tolerance_m)) " m; contacts located as events" },
        ),
        ("Version".to_owned(), html! { "loosepin " (record.version) }),
    ];
    facts(&rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use loosepin_result::sweep::SweepPoint;
    use loosepin_text::units::DisplayUnits;

    #[test]
    fn a_sweep_that_could_not_be_computed_says_nothing_of_its_motion() {
        let failed = |value_si: f64| SweepPoint {
            value_si,
            failure: Some("the loops cannot be closed".to_owned()),
            period_turns: None,
            sections_si: Vec::new(),
            joints: Vec::new(),
        };
        let record = SweepRecord {
            repeat: Default::default(),
            model: "slider-crank".to_owned(),
            version: "0.1.0".to_owned(),
            overrides: Vec::new(),
            path: "parameter.rod_length".to_owned(),
            unit: SiUnit::LENGTH,
            drive: "crank".to_owned(),
            section_angle_rad: 0.3,
            transient_turns: 20,
            recorded_turns: 8,
            tolerance_m: 1e-8,
            outputs: Vec::new(),
            joints: vec!["gudgeon".to_owned()],
            points: vec![failed(0.02), failed(0.03)],
            display_units: DisplayUnits::default(),
        };
        assert_eq!(
            headline_sentences(&record, &NumberWriter::for_terminal(&record.display_units)),
            [
                "All 2 runs failed: no value of parameter.rod_length gives a motion.",
                "2\u{a0}runs failed. The first reason: the loops cannot be closed"
            ]
        );
        assert!(sweep_page(&record).contains("not computed"));
    }
}

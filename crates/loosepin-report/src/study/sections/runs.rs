//! How many runs a study took, which of them failed, and what the nominal one shows; on a page the impacts of all runs too.

use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::{Tag, same_wording};
use crate::study::answer::turn_word;
use crate::words::force::{JointForces, min_impact_speed_words};
use crate::words::trust::nominal_sentences;
use crate::words::turn::share_of_runs;
use crate::words::wording::{UNKNOWN_INPUTS, count, counted, has_unknown, is_by_surrogate, listed};
use loosepin_result::study::{FailureGroup, JointImpacts, Purpose, StudyResult};
use loosepin_text::article::{Cell, Column, Content, Fact, Medium, Section, Table, Text};
use loosepin_text::units::SiUnit;

/// The section.
pub(crate) fn runs_section(result: &StudyResult, writer: &NumberWriter) -> Section {
    let mut section = Section::headed_on_page("runs", "Runs, failures and impacts");
    section.push_on(Medium::Page, Content::Sentences(vec![counts_words(result, writer)]));
    section.push(Content::sentences([nominal_sentences(result, writer).join(" ")]));
    let columns = vec![Column::words("Reason"), Column::numbers("Runs"), Column::words("Example")];
    let rows = result.failures.iter().map(|failure| failure_row(failure, writer));
    section.push_on(Medium::Page, Content::Table(Table::new(columns, rows)));
    push_failures(&mut section, &result.failures, writer);
    for joint in &result.impacts {
        section.push_on(Medium::Page, Content::Heading(format!("Impacts in {}", joint.joint).into()));
        let facts = impact_facts(joint, turn_word(result.cycle.drive_speed_rad_s), writer);
        section.push_on(Medium::Page, Content::Facts(facts));
    }
    section
}

/// The most frequent failures, for a terminal; `None` if no run failed.
pub(crate) fn failures_section(result: &StudyResult, writer: &NumberWriter) -> Option<Section> {
    /// The others stand in the whole text.
    const MOST: usize = 2;
    let mut section = Section::headed_on_page("failures", "Failures");
    let (shown, others) = result.failures.split_at(result.failures.len().min(MOST));
    push_failures(&mut section, shown, writer);
    let left: u64 = others.iter().map(|failure| failure.count).sum();
    if left > 0 {
        let runs = counted(left, "run", &writer.with_tag(&Tag::whole("failed runs", "for other reasons")));
        section.push_on(Medium::Terminal, Content::sentences([format!("{runs} failed for other reasons: see --all")]));
    }
    (!result.failures.is_empty()).then_some(section)
}

/// Each reason with how many runs failed for it, and one of them as a command.
fn push_failures(section: &mut Section, failures: &[FailureGroup], writer: &NumberWriter) {
    for failure in failures {
        let runs = counted(failure.count, "run", &writer.with_tag(&Tag::whole("failed runs", &failure.code)));
        section.push_on(Medium::Terminal, Content::sentences([format!("{runs} failed: {}", failure.words)]));
        // A command is one line, so that it can be copied.
        let again = Content::Facts(vec![Fact::nameless(format!("again: {}", failure.example.command))]);
        section.push_close_on(Medium::Terminal, again);
    }
}

/// All runs, those that failed, and those whose motion is periodic.
fn counts_words(result: &StudyResult, writer: &NumberWriter) -> Text {
    let counts = &result.counts;
    let runs = counted(counts.runs, "run", &writer.with_tag(&Tag::Count("runs")));
    let loops = if is_by_surrogate(result) {
        format!("{runs}, to train a surrogate and to check it. ")
    } else {
        let of_loop = || count(double_loop_runs(result), &writer.with_tag(&Tag::Count("runs of the double loop")));
        let of_loop =
            if counts.by_purpose.len() > 1 { format!(", {} in the double loop", of_loop()) } else { String::new() };
        let same = has_unknown(&result.inputs) && has_scatter(result);
        let same = if same { ", the same samples for every value" } else { "" };
        format!("{runs}{of_loop}: {}{same}. ", double_loop_words(result, ", each with ", writer))
    };
    let failed = match counts.failed {
        0 => Text::from("No run failed. "),
        failed => {
            let share = writer
                .with_tag(&Tag::whole("failed runs", "share"))
                .percent(failed as f64 / counts.runs.max(1) as f64, Rounding::Up);
            Text::default()
                .strong(format!("{} failed", counted(failed, "run", &writer.with_tag(&Tag::Count("failed runs")))))
                .plain(format!(" ({share}). Probabilities allow for both outcomes of a failed run. "))
        }
    };
    let text = Text::from(loops).then(failed);
    let Some(settled) = result.settled_share else { return text };
    let periodic = share_of_runs(settled, counts.runs - counts.failed, &writer.with_tag(&Tag::whole("settled", "")));
    let more = if settled < 0.5 { "Most motions do not repeat from turn to turn: record more turns." } else { "" };
    text.plain(format!("In {periodic} the motion is periodic; the other runs count as well. {more}"))
}

/// Why runs failed, how many, and one of them.
fn failure_row(failure: &FailureGroup, writer: &NumberWriter) -> Vec<Cell> {
    let index = count(failure.example.index, &writer.with_tag(&Tag::Count("index of a run")));
    vec![
        Text::from(failure.words.as_str()).plain(" ").quiet(failure.code.as_str()).into(),
        count(failure.count, &writer.with_tag(&Tag::whole("failed runs", &failure.code))).into(),
        Text::from(format!("run {index}: ")).code(failure.example.command.as_str()).into(),
    ]
}

fn impact_facts(joint: &JointImpacts, turn: &str, writer: &NumberWriter) -> Vec<Fact> {
    let [least, median, most] = joint.impacts_per_turn;
    let tag = |statistic: &str, part: &str| Tag::joint(&joint.joint, statistic, part);
    let per_turn = |part: &str, value: f64| plain(value, &writer.with_tag(&tag("impacts per turn", part)));
    let impacts = format!(
        "{} in the median run ({} to {})",
        per_turn("median", median),
        per_turn("least", least),
        per_turn("most", most)
    );
    let share =
        |statistic: &str, part: &str, share: f64| writer.with_tag(&tag(statistic, part)).percent(share, Rounding::Up);
    let penetration = share("penetration", "largest share", joint.largest_penetration_share);
    let laws = JointForces::study(joint).laws(writer);
    let force = writer.with_tag(&tag("normal force", "largest")).value(joint.peak_force_n, &SiUnit::FORCE);
    let restitution = joint.nominal_restitution.zip(joint.delivered_restitution).map(|(nominal, delivered)| {
        Text::from(format!(
            "stated {}; a free impact under this contact law gives ",
            range(nominal, &writer.with_tag(&tag("restitution", "stated")))
        ))
        .strong(range(delivered, &writer.with_tag(&tag("restitution", "delivered"))))
    });
    let outside = joint.share_outside_validity.map(|outside| {
        format!(
            "{} of the impacts are faster than the contact law is valid for",
            share("impacts", "outside validity", outside)
        )
    });
    let rows = [
        (format!("Impacts per {turn}"), Some(impacts.into())),
        ("Largest penetration".to_owned(), Some(format!("{penetration} of the clearance of its run").into())),
        ("Contact law".to_owned(), (!laws.is_empty()).then(|| listed(&laws).into())),
        ("Largest normal contact force".to_owned(), Some(force.into())),
        ("Restitution".to_owned(), restitution),
        ("Outside the law's validity".to_owned(), outside.map(Text::from)),
        (
            "Very slow contacts".to_owned(),
            min_impact_speed_words(&joint.joint, joint.floored_contacts, writer).map(Text::from),
        ),
    ];
    rows.into_iter().filter_map(|(name, words)| Some(Fact::new(name, [words?]))).collect()
}

fn plain(value: f64, writer: &NumberWriter) -> String {
    writer.shortest((value * 100.0).round() / 100.0, &SiUnit::NONE)
}

fn range(ends: [f64; 2], writer: &NumberWriter) -> String {
    let of_end = |part: &str, end: f64| {
        let tag = writer.tag().map(|tag| tag.part(part));
        writer.with_optional_tag(tag.as_ref()).shortest((end * 1e4).round() / 1e4, &SiUnit::NONE)
    };
    let (from, to) = (of_end("least", ends[0]), of_end("most", ends[1]));
    if same_wording(&from, &to) { from } else { format!("{from} to {to}") }
}

/// Runs of the double loop.
fn double_loop_runs(result: &StudyResult) -> u64 {
    let parts = result.counts.by_purpose.iter();
    parts.filter(|part| part.purpose == Purpose::DoubleLoop).map(|part| part.runs).sum()
}

/// Whether anything scatters with a known distribution.
fn has_scatter(result: &StudyResult) -> bool {
    result.inputs.iter().any(|input| input.kind.is_random())
}

/// The double loop: values of what is unknown, samples of what scatters at each of them.
pub(crate) fn double_loop_words(result: &StudyResult, each: &str, writer: &NumberWriter) -> String {
    let counts = &result.counts;
    let values = format!(
        "{} of the {}",
        counted(counts.outer, "value", &writer.with_tag(&Tag::Count("values of the unknown inputs"))),
        UNKNOWN_INPUTS
    );
    let samples = counted(counts.inner, "random sample", &writer.with_tag(&Tag::Count("random samples")));
    match (has_unknown(&result.inputs), has_scatter(result)) {
        (true, true) => format!("{values}{each}{samples}"),
        (true, false) => values,
        (false, _) => samples,
    }
}

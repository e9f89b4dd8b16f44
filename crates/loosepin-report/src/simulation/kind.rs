//! Kind of motion of a run: period, motion once a turn, growth of small differences.

use maud::{Markup, html};

use crate::charts::chart::{Chart, Entry, EntryValues, Role};
use crate::charts::figure::name_of;
use crate::charts::still_figures::journal_sections;
use crate::medium::short_answer::Said;
use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::Tag;
use crate::words::wording::counted;
use loosepin_result::simulation::{
    JournalOrbit, LyapunovRecord, MotionKind, NeighbourKind, SectionedOutput, SimulationRecord,
};
use loosepin_text::units::SiUnit;

/// Confidence of the interval of a Lyapunov exponent.
const CONFIDENCE: f64 = 0.95;

/// Period and Lyapunov exponent in sentences; for pages and terminals alike. What does not repeat itself is a caveat: one history is one of many.
pub(super) fn kind_said(record: &SimulationRecord, writer: &NumberWriter) -> Vec<Said> {
    let said = |is_regular: bool, words: String| if is_regular { Said::answer(words) } else { Said::caveat(words) };
    let period = record.kind.as_ref().map(|kind| said(kind.period_turns.is_some(), period_sentence(kind, writer)));
    let exponent = |found: &LyapunovRecord| said(found.kind != NeighbourKind::Part, exponent_sentence(found, writer));
    period.into_iter().chain(record.lyapunov.as_ref().map(exponent)).collect()
}

fn period_sentence(kind: &MotionKind, writer: &NumberWriter) -> String {
    let turns = counted(u64::from(kind.turns), "turn", &writer.with_tag(&Tag::Given("turns that are examined")));
    match kind.period_turns {
        Some(1) => format!("The motion repeats every turn ({turns} examined)."),
        Some(period) => {
            format!(
                "The motion repeats every {} ({turns} examined).",
                counted(u64::from(period), "turn", &writer.with_tag(&Tag::whole("motion", "period")))
            )
        }
        None => format!(
            "The motion does not repeat within half of the {turns} examined. It has not settled yet, or it is not periodic."
        ),
    }
}

fn exponent_sentence(found: &LyapunovRecord, writer: &NumberWriter) -> String {
    let number = |part: &str, value: f64| exponent(writer, part, value, 3, Rounding::Nearest);
    let space = writer.space();
    // The unit: one over seconds.
    let one = writer.with_tag(&Tag::Given("unit")).count(1);
    let measured = format!(
        "Largest Lyapunov exponent {}{space}{one}/s, with {} confidence between {} and {}{space}{one}/s",
        number("value", found.exponent_1_s),
        writer.with_tag(&Tag::Given("confidence")).percent(CONFIDENCE, Rounding::Nearest),
        exponent(writer, "lower", found.lower_1_s, 3, Rounding::Down),
        exponent(writer, "upper", found.upper_1_s, 3, Rounding::Up)
    );
    let tenfold = number("turns of tenfold growth", std::f64::consts::LN_10 / found.growth_per_turn().abs());
    match found.kind {
        NeighbourKind::Part => format!(
            "{measured}. Small differences grow tenfold every {tenfold}{space}turns. A single history is not representative: use \
             statistics over many turns."
        ),
        NeighbourKind::Meet => format!("{measured}. Small differences shrink tenfold every {tenfold}{space}turns."),
        NeighbourKind::Undecided => {
            format!(
                "{measured}. Its sign is not certain after {}.",
                counted(found.growth.len() as u64, "turn", &writer.with_tag(&Tag::Given("turns that are examined")))
            )
        }
    }
}

/// A number of the exponent, without its unit.
fn exponent(writer: &NumberWriter, part: &str, value: f64, digits: usize, rounding: Rounding) -> String {
    writer.with_tag(&Tag::whole("Lyapunov exponent", part)).rounded(value, &SiUnit::NONE, digits, rounding)
}

/// The section of the page; `None` if a run says nothing about it.
pub(super) fn kind_section(record: &SimulationRecord, writer: &NumberWriter) -> Option<Markup> {
    if record.kind.is_none() && record.lyapunov.is_none() {
        return None;
    }
    Some(html! {
        @for said in kind_said(record, writer) { p { (said.words) } }
        @if let Some(kind) = &record.kind { (sections(kind, &record.settings.drive, writer)) }
        @if let Some(found) = &record.lyapunov { (growth_chart(found, writer)) }
    })
}

fn sections(kind: &MotionKind, drive: &str, writer: &NumberWriter) -> Markup {
    let angle =
        writer.with_tag(&Tag::Given("angle of the section")).value_trimmed(kind.section_angle_rad, &SiUnit::ANGLE);
    html! {
        p {
            "Once a turn, at " (angle) " of " (drive) " (Poincaré section). A motion that repeats every turn gives one dot, every second \
            turn two dots. A motion that is not periodic gives a cloud. A journal counts as back within "
            (writer.with_tag(&Tag::Given("share of a clearance")).percent(kind.repeat_share, Rounding::Nearest)) " of its clearance."
        }
        @if !kind.journals.is_empty() {
            div.orbits { @for journal in &kind.journals { (journal_sections(journal as &JournalOrbit, writer)) } }
        }
        @for output in &kind.outputs { (output_chart(output, writer)) }
    }
}

fn output_chart(output: &SectionedOutput, writer: &NumberWriter) -> Markup {
    let turns: Vec<f64> = (1..=output.deviation_si.len()).map(|turn| turn as f64).collect();
    let label = format!("deviation of {}", output.name);
    Chart {
        y_label: label.clone(),
        y_symbol: writer.symbol(&output.unit),
        entries: vec![Entry::line("at the end of the turn", Role::Mixed, false, &output.deviation_si, &output.unit, writer)],
        height: 200,
        caption: html! { strong { "Deviation of " (output.name) " once a turn." } " The line is level if the motion repeats every turn." },
        alternative: format!("Chart of the {label} at the end of each turn."),
        ..Chart::over(name_of("each-turn", &output.name), "turn", &turns, &SiUnit::NONE, writer)
    }
    .figure()
}

fn growth_chart(found: &LyapunovRecord, writer: &NumberWriter) -> Markup {
    let mut sum = 0.0;
    let total: Vec<f64> = std::iter::once(0.0)
        .chain(found.growth.iter().map(|growth| {
            sum += growth;
            sum / std::f64::consts::LN_10
        }))
        .collect();
    let turns: Vec<f64> = (0..total.len()).map(|turn| turn as f64).collect();
    let given = |what: &'static str, value: f64| writer.with_tag(&Tag::Given(what)).shortest(value, &SiUnit::NONE);
    let separation =
        writer.with_tag(&Tag::Given("separation")).rounded(found.separation, &SiUnit::NONE, 2, Rounding::Nearest);
    let settling = given("turns to settle", found.transient_turns);
    let aligning = given("turns to align", f64::from(found.aligning_turns));
    let [one, batches] = [given("unit", 1.0), given("batches", 20.0)];
    let error = exponent(writer, "standard error", found.standard_error_1_s, 2, Rounding::Up);
    let mean = found.growth_per_turn() / std::f64::consts::LN_10;
    let even: Vec<f64> = turns.iter().map(|turn| turn * mean).collect();
    Chart {
        y_label: "powers of ten".to_owned(),
        entries: vec![
            Entry::new("growth of the distance", Role::First, false, EntryValues::line(&total)),
            Entry::new("mean growth", Role::Worst, true, EntryValues::line(&even)),
        ],
        height: 260,
        caption: html! {
            strong { "Growth of a small difference, in powers of ten." }
            " A second run starts at a distance of " (separation)
            " natural scales and is brought back to that distance again and again. Before the measurement: " (settling)
            " turns for the motion to settle, " (aligning)
            " turns for the direction. The slope is the largest Lyapunov exponent. Its standard error is " (error) " " (one) "/s, from "
            (batches) " batches of turns."
        },
        alternative: "Chart of the growth of a small difference over the turns, in powers of ten.".to_owned(),
        ..Chart::over("lyapunov".to_owned(), "turn", &turns, &SiUnit::NONE, writer)
    }
    .figure()
}

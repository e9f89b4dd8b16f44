//! The energy check of a study, and how it was computed.

use maud::{Markup, html};

use crate::charts::still_figures::histogram_figure;
use crate::medium::article_page::push_figure;
use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::{Tag, same_wording};
use crate::study::answer::turns;
use crate::study::sections::double_loop_words;
use crate::words::glossary::glossary;
use crate::words::wording::{count, guarantee_words, is_by_surrogate, listed, reading_words};
use loosepin_result::study::{CorrelationDescription, EnergyResiduals, Guarantee, InputKind, Purpose, StudyResult};
use loosepin_text::article::{Cell, Column, Content, Fact, Section, Table, Text};
use loosepin_text::units::SiUnit;

pub(super) fn energy(energy: &EnergyResiduals, writer: &NumberWriter) -> Markup {
    let share = |part: &str, value: f64| {
        writer.with_tag(&Tag::whole("energy residual", part)).rounded(value, &SiUnit::NONE, 2, Rounding::Up)
    };
    let of_runs = |share: f64| writer.with_tag(&Tag::Given("probability")).percent(share, Rounding::Nearest);
    let alternative = format!(
        "Histogram of the energy residuals of the runs; half lie below {}, the largest is {}.",
        share("median", energy.median),
        share("largest", energy.maximum)
    );
    html! {
        p {
            "Every run checks its energy balance: kinetic, potential and stored energy, losses in contact and friction, work of \
             the drive. The residual is given as a share of the largest energy exchanged."
        }
        (histogram_figure(
            &energy.histogram,
            "energy-residuals",
            "relative energy residual",
            html! {
                strong { "Energy residuals of the runs. " }
                "Half lie below " (share("median", energy.median)) ", " (of_runs(0.9)) " below " (share("0.9", energy.quantile_90)) ", " (of_runs(0.99)) " below "
                (share("0.99", energy.quantile_99)) "; the largest is " (share("largest", energy.maximum)) ". Bars: number of runs, over the \
                 relative residual."
            },
            alternative,
        ))
    }
}

/// Inputs, runs, and the terms of the page.
pub(super) fn method_section(result: &StudyResult, writer: &NumberWriter) -> Section {
    let mut section = Section::new("method", "How this was computed");
    section.push(Content::Heading("Uncertain inputs".into()));
    let columns = ["Input", "Kind", "Range or distribution"].map(Column::words);
    let rows = result.inputs.iter().map(|input| -> Vec<Cell> {
        vec![Text::default().code(&input.path).into(), kind_words(&input.kind).into(), input.words.as_str().into()]
    });
    section.push(Content::Table(Table::new(columns.into(), rows)));
    if !result.correlations.is_empty() {
        let one = |correlation: &CorrelationDescription| {
            let number = |value: f64| writer.with_tag(&Tag::Given("correlation")).shortest(value, &SiUnit::NONE);
            let kind = match correlation.linear {
                Some(linear) => format!("linear {}", number(linear)),
                None => format!("rank {}", number(correlation.rank)),
            };
            format!("{} {kind}", listed(&correlation.of))
        };
        let all: Vec<String> = result.correlations.iter().map(one).collect();
        section.push(Content::sentences([format!(
            "Correlations (Gaussian copula): {}. All other random inputs are independent. The interval-only treatment ignores correlations.",
            all.join("; ")
        )]));
    }
    section.push(Content::Heading("Runs".into()));
    section.push(Content::Facts(run_facts(result, writer)));
    push_figure(&mut section, writer, glossary);
    section
}

fn purpose_words(purpose: Purpose) -> &'static str {
    match purpose {
        Purpose::DoubleLoop => "of the mixed treatment",
        Purpose::Mixture => "of the probability-only treatment",
        Purpose::Extreme => "of the interval-only treatment",
        Purpose::Contributors => "for sensitivities",
        Purpose::Rare => "for small probabilities",
        Purpose::Training => "to train surrogates",
        Purpose::Confirming => "to confirm surrogates",
        Purpose::Promise => "for the promise",
    }
}

fn kind_words(kind: &InputKind) -> &'static str {
    match kind {
        InputKind::Random => "random",
        InputKind::Interval { .. } => "interval",
        InputKind::Periodic { .. } => "periodic",
        InputKind::SecondOrder { .. } => "parameter with a distribution",
        InputKind::Evidence { is_scattering: false, .. } => "evidence",
        InputKind::Evidence { is_scattering: true, .. } => "probability box",
        InputKind::Fuzzy { .. } => "fuzzy number",
        InputKind::Play => "places of journals",
        InputKind::DrawnPlay => "random places of journals",
        InputKind::Choice { .. } => "one of a list",
    }
}

fn run_facts(result: &StudyResult, writer: &NumberWriter) -> Vec<Fact> {
    let mixed = || result.bounds.iter().filter(|bound| bound.treatment.is_mixed());
    let guarantees = guarantees_words(mixed().map(|bound| bound.guarantee), writer);
    let mut readings: Vec<&'static str> = mixed().map(|bound| reading_words(bound.reading)).collect();
    readings.sort_unstable();
    readings.dedup();
    let cycle = &result.cycle;
    let speed = cycle.drive_speed_rad_s.map_or_else(String::new, |speed_rad_s| {
        let given = Tag::Given("speed of the drive");
        format!(" at {}", writer.with_tag(&given).value_shortest(speed_rad_s, &SiUnit::ANGULAR_VELOCITY))
    });
    let turns = |number: f64| turns(number, cycle.drive_speed_rad_s, writer);
    let tolerance = writer.with_tag(&Tag::Given("tolerance")).value_shortest(cycle.tolerance_m, &SiUnit::LENGTH);
    // Positions that are closed have neither steps nor a start.
    let is_integrated = !cycle.method.is_empty();
    let integration = if is_integrated { format!("{}, tolerance {tolerance}", cycle.method) } else { String::new() };
    let (start_up, recorded) = (turns(cycle.transient_turns), turns(cycle.recorded_turns));
    let known = [
        ("Cycle", format!("{}{speed}; {start_up} of start-up, then {recorded} recorded", cycle.drive)),
        ("Runs", runs_words(result, writer)),
        ("Integration", integration),
        ("Reading of an interval", readings.join("; ")),
        ("Guarantee of the bounds", guarantees),
        ("Seed", count(result.seed, &writer.with_tag(&Tag::Given("seed")))),
    ];
    let known = known.into_iter().filter(|(_, words)| !words.is_empty());
    let mut facts: Vec<Fact> = known.map(|(name, words)| Fact::new(name, [words])).collect();
    facts.push(Fact::new("Hash of all inputs", [Text::default().code(&result.input_hash)]));
    facts.push(Fact::new("Version", [format!("loosepin {}", result.version)]));
    facts
}

/// Each kind of guarantee once, confidences from the least to the most.
fn guarantees_words(all: impl Iterator<Item = Guarantee>, writer: &NumberWriter) -> String {
    let mut others: Vec<String> = Vec::new();
    let mut confidences: Option<[f64; 2]> = None;
    for guarantee in all {
        if let Some(confidence) = guarantee.confidence() {
            let [least, most] = confidences.unwrap_or([confidence; 2]);
            confidences = Some([least.min(confidence), most.max(confidence)]);
        } else {
            others.push(guarantee_words(guarantee, writer));
        }
    }
    others.sort();
    others.dedup();
    let given = Tag::Given("confidence");
    let sampled = confidences.map(|ends| {
        let [least, most] = ends.map(|share| writer.with_tag(&given).percent(share, Rounding::Nearest));
        let range = if same_wording(&least, &most) { least } else { format!("{least} to {most}") };
        format!("estimated from samples, with {range} confidence in each statistic by itself")
    });
    others.into_iter().chain(sampled).collect::<Vec<String>>().join(", or ")
}

/// All runs as a sum of those for each purpose.
fn runs_words(result: &StudyResult, writer: &NumberWriter) -> String {
    let counts = &result.counts;
    let number = |tag: Tag, value: u64| count(value, &writer.with_tag(&tag));
    let (what, plus) = match is_by_surrogate(result) {
        true => (", to train a surrogate and to check it".to_owned(), "; "),
        false => (format!(" = {}", double_loop_words(result, " × ", writer)), " + "),
    };
    let mut words = format!("{}{what}", number(Tag::Count("runs"), counts.runs));
    if counts.replicates > 1 {
        words.push_str(&format!(
            " ({} independent replicates of {})",
            number(Tag::Given("replicates"), counts.replicates),
            number(Tag::Count("random samples of a replicate"), counts.inner / counts.replicates)
        ));
    }
    if counts.rounds > 1 {
        words.push_str(&format!(", in {} rounds", number(Tag::Count("rounds"), counts.rounds)));
    }
    for part in counts.by_purpose.iter().filter(|part| part.purpose != Purpose::DoubleLoop) {
        let purpose = purpose_words(part.purpose);
        words.push_str(&format!("{plus}{} {purpose}", number(Tag::Count(purpose), part.runs)));
    }
    words
}

//! Failed runs with their reasons, the energy check, and the method.

use maud::{Markup, html};

use crate::answer::{turn_word, turns};
use crate::force_words::ForcesOf;
use crate::glossary::glossary;
use crate::number::{NumberWriter, Rounding};
use crate::page::{cards, facts};
use crate::simulation_page::speed_facts;
use crate::still_figures::histogram_figure;
use crate::tag::{Tag, read_the_same};
use crate::trust_words::nominal_sentences;
use crate::turn_words::share_of_runs;
use crate::wording::{
    count, counted, guarantee_words, has_unknown, is_by_surrogate, listed, reading_words, unknown_words,
};
use loosepin_result::study::{EnergyResiduals, InputKind, JointImpacts, Purpose, StudyResult, Treatment};
use loosepin_text::units::SiUnit;

pub(super) fn runs(result: &StudyResult, writer: &NumberWriter) -> Markup {
    let share = result.counts.failed as f64 / result.counts.runs.max(1) as f64;
    html! {
        p {
            @if is_by_surrogate(result) { (counted(result.counts.runs, "run", &writer.about(&Tag::Count("runs")))) ", to train a surrogate and to check it. " }
            @else {
                (counted(result.counts.runs, "run", &writer.about(&Tag::Count("runs"))))
                @if result.counts.by_purpose.len() > 1 { ", " (count(double_loop_runs(result), &writer.about(&Tag::Count("runs of the double loop")))) " in the double loop" }
                ": " (double_loop_words(result, ", each with ", writer))
                @if has_unknown(&result.inputs) && has_scatter(result) { ", the same samples for every value" }
                ". "
            }
            @if result.counts.failed == 0 { "No run failed. " }
            @else {
                strong { (counted(result.counts.failed, "run", &writer.about(&Tag::Count("failed runs")))) " failed" }
                " (" (writer.about(&Tag::whole("failed runs", "share")).percent(share, Rounding::Up)) "). Probabilities allow for both outcomes of a failed run. "
            }
            @if let Some(settled) = result.settled_share {
                "In " (share_of_runs(settled, result.counts.runs - result.counts.failed, &writer.about(&Tag::whole("settled", "")))) " the motion is periodic; the other runs count as well. "
                @if settled < 0.5 {
                    "Most motions do not repeat from turn to turn: record more turns."
                }
            }
        }
        @let nominal = nominal_sentences(result, writer);
        @if !nominal.is_empty() { p { (nominal.join(" ")) } }
        @if !result.failures.is_empty() {
            (cards(["Reason", "#Runs", "Example"], result.failures.iter().map(|failure| [
                html! { (failure.words) br; code.quiet { (failure.code) } },
                html! { (count(failure.count, &writer.about(&Tag::whole("failed runs", &failure.code)))) },
                html! { "run " (count(failure.example.index, &writer.about(&Tag::Count("index of a run")))) ":" pre { code { (failure.example.command) } } },
            ])))
        }
        @for joint in &result.impacts { (impacts(joint, turn_word(result.cycle.drive_speed_rad_s), writer)) }
    }
}

fn impacts(joint: &JointImpacts, turn: &str, writer: &NumberWriter) -> Markup {
    let [least, median, most] = joint.impacts_per_turn;
    let tag = |statistic: &str, part: &str| Tag::joint(&joint.joint, statistic, part);
    let a_turn = |part: &str, value: f64| plain(value, &writer.about(&tag("impacts per turn", part)));
    let mut rows = vec![(
        format!("Impacts per {turn}"),
        html! {
            (a_turn("median", median)) " in the median run (" (a_turn("least", least)) " to " (a_turn("most", most)) ")"
        },
    )];
    let share =
        writer.about(&tag("penetration", "largest share")).percent(joint.largest_penetration_share, Rounding::Up);
    rows.push(("Largest penetration".to_owned(), html! { (share) " of the clearance of its run" }));
    let laws = ForcesOf::study(joint).laws(writer);
    if !laws.is_empty() {
        rows.push(("Contact law".to_owned(), html! { (listed(&laws)) }));
    }
    rows.push((
        "Largest normal contact force".to_owned(),
        html! { (writer.about(&tag("normal force", "largest")).value(joint.peak_force_n, &SiUnit::FORCE)) },
    ));
    if let (Some(nominal), Some(delivered)) = (joint.nominal_restitution, joint.delivered_restitution) {
        rows.push((
            "Restitution".to_owned(),
            html! {
                "stated " (range(nominal, &writer.about(&tag("restitution", "stated")))) "; a free impact under this contact law gives "
                strong { (range(delivered, &writer.about(&tag("restitution", "delivered")))) }
            },
        ));
    }
    rows.extend(speed_facts(&joint.joint, joint.share_outside_validity, joint.floored_contacts, writer));
    html! { h3 { "Impacts in " (joint.joint) } (facts(&rows)) }
}

fn plain(value: f64, writer: &NumberWriter) -> String {
    writer.shortest((value * 100.0).round() / 100.0, &SiUnit::NONE)
}

fn range(ends: [f64; 2], writer: &NumberWriter) -> String {
    let of_end = |part: &str, end: f64| {
        let tag = writer.tag().map(|tag| tag.part(part));
        writer.about_maybe(tag.as_ref()).shortest((end * 1e4).round() / 1e4, &SiUnit::NONE)
    };
    let (from, to) = (of_end("least", ends[0]), of_end("most", ends[1]));
    if read_the_same(&from, &to) { from } else { format!("{from} to {to}") }
}

pub(super) fn energy(energy: &EnergyResiduals, writer: &NumberWriter) -> Markup {
    let share = |part: &str, value: f64| {
        writer.about(&Tag::whole("energy residual", part)).rounded(value, &SiUnit::NONE, 2, Rounding::Up)
    };
    let of_runs = |share: f64| writer.about(&Tag::Given("probability")).percent(share, Rounding::Nearest);
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

pub(super) fn method(result: &StudyResult, writer: &NumberWriter) -> Markup {
    html! {
        h3 { "Uncertain inputs" }
        (cards(["Input", "Kind", "Range or distribution"], result.inputs.iter().map(|input| [
            html! { code { (input.path) } },
            html! { (kind_words(&input.kind)) },
            html! { (input.words) },
        ])))
        @if !result.correlations.is_empty() {
            p {
                "Correlations (Gaussian copula): "
                @for (index, correlation) in result.correlations.iter().enumerate() {
                    @if index > 0 { "; " }
                    (listed(&correlation.of)) " "
                    @if let Some(linear) = correlation.linear { "linear " (writer.about(&Tag::Given("correlation")).shortest(linear, &SiUnit::NONE)) }
                    @else { "rank " (writer.about(&Tag::Given("correlation")).shortest(correlation.rank, &SiUnit::NONE)) }
                }
                ". All other random inputs are independent. The interval-only treatment ignores correlations."
            }
        }
        h3 { "Runs" }
        (facts(&run_facts(result, writer)))
        (glossary())
    }
}

/// Runs of the double loop.
fn double_loop_runs(result: &StudyResult) -> u64 {
    let parts = result.counts.by_purpose.iter();
    parts.filter(|part| part.purpose == Purpose::DoubleLoop).map(|part| part.runs).sum()
}

/// Whether anything scatters with a known distribution.
fn has_scatter(result: &StudyResult) -> bool {
    result.inputs.iter().any(|input| input.kind == InputKind::Random)
}

/// The double loop: values of what is unknown, samples of what scatters at each of them.
fn double_loop_words(result: &StudyResult, each: &str, writer: &NumberWriter) -> String {
    let counts = &result.counts;
    let values = format!(
        "{} of the {}",
        counted(counts.outer, "value", &writer.about(&Tag::Count("values of the unknown inputs"))),
        unknown_words(&result.inputs)
    );
    let samples = counted(counts.inner, "random sample", &writer.about(&Tag::Count("random samples")));
    match (has_unknown(&result.inputs), has_scatter(result)) {
        (true, true) => format!("{values}{each}{samples}"),
        (true, false) => values,
        (false, _) => samples,
    }
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
        InputKind::Choice { .. } => "one of a list",
    }
}

fn run_facts(result: &StudyResult, writer: &NumberWriter) -> Vec<(String, Markup)> {
    let mixed = || result.bounds.iter().filter(|bound| bound.treatment == Treatment::Mixed);
    let mut guarantees: Vec<String> = mixed().map(|bound| guarantee_words(bound.guarantee, writer)).collect();
    guarantees.sort();
    guarantees.dedup();
    let mut readings: Vec<&'static str> = mixed().map(|bound| reading_words(bound.reading)).collect();
    readings.sort_unstable();
    readings.dedup();
    let counts = &result.counts;
    let mut rows = vec![
        (
            "Cycle".to_owned(),
            html! {
                (result.cycle.drive)
                @if let Some(speed) = result.cycle.drive_speed_rad_s {
                    " at " (writer.about(&Tag::Given("speed of the drive")).value_shortest(speed, &SiUnit::ANGULAR_VELOCITY))
                }
                "; " (turns(result.cycle.transient_turns, result.cycle.drive_speed_rad_s, writer)) " of start-up, then "
                (turns(result.cycle.recorded_turns, result.cycle.drive_speed_rad_s, writer)) " recorded"
            },
        ),
        (
            "Runs".to_owned(),
            html! {
                (count(counts.runs, &writer.about(&Tag::Count("runs"))))
                @if is_by_surrogate(result) { ", to train a surrogate and to check it" }
                @else {
                    " = " (double_loop_words(result, " × ", writer))
                }
                @if counts.replicates > 1 { " (" (count(counts.replicates, &writer.about(&Tag::Given("replicates")))) " independent replicates of "
                    (count(counts.inner / counts.replicates, &writer.about(&Tag::Count("random samples of a replicate")))) ")"
                }
                @if counts.rounds > 1 { ", in " (count(counts.rounds, &writer.about(&Tag::Count("rounds")))) " rounds" }
                @for part in counts.by_purpose.iter().filter(|part| part.purpose != Purpose::DoubleLoop) {
                    @if is_by_surrogate(result) { "; " } @else { " + " }
                    (count(part.runs, &writer.about(&Tag::Count(purpose_words(part.purpose))))) " " (purpose_words(part.purpose))
                }
            },
        ),
        (
            "Integration".to_owned(),
            html! {
                (result.cycle.method) ", tolerance "
                (writer.about(&Tag::Given("tolerance")).value_shortest(result.cycle.tolerance_m, &SiUnit::LENGTH))
            },
        ),
    ];
    if !readings.is_empty() {
        let text = readings.join("; ");
        rows.push(("Reading of an interval".to_owned(), html! { (text) }));
    }
    if !guarantees.is_empty() {
        let text = guarantees.join(", or ");
        rows.push(("Guarantee of the bounds".to_owned(), html! { (text) }));
    }
    rows.push(("Seed".to_owned(), html! { (count(result.seed, &writer.about(&Tag::Given("seed")))) }));
    rows.push(("Hash of all inputs".to_owned(), html! { code.hash { (result.input_hash) } }));
    rows.push(("Version".to_owned(), html! { "loosepin " (result.version) }));
    rows
}

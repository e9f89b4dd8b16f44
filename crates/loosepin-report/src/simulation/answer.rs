//! The answer of a run in sentences, the most important first; for pages and terminals alike.

use crate::numbers::number::{NumberWriter, PLAIN_DIGITS, Rounding};
use crate::numbers::tag::Tag;
use crate::study::answer::turns;
use crate::words::force::{law_sentences, run_sentences, run_warnings};
use crate::words::trust::TrustedRun;
use crate::words::wording::{capitalised, count, counted, listed, without_round_off};
use loosepin_result::simulation::{
    ControlHistory, ExtremePoint, OscillationTrend, QuasiStaticShare, SimulationRecord, SimulationSettings,
};
use loosepin_text::units::SiUnit;

use super::bending::bending_sentences;
use super::kind::kind_sentences;
use super::life::life_sentence;

/// All sentences of the answer.
pub(super) fn headline_sentences(record: &SimulationRecord, writer: &NumberWriter) -> Vec<String> {
    let mut sentences = main_sentences(record, writer);
    sentences.extend(run_sentences(record, writer));
    sentences.extend(motion_sentences(record, writer));
    sentences.push(energy_sentence(record, writer));
    sentences.extend(trusted_run(record).sentences(writer));
    sentences.extend(bending_sentences(&record.bending, writer));
    let checks = checks(record);
    sentences.extend(quasi_static_sentence(record, &checks, writer));
    sentences
}

/// What a terminal says of a run.
pub(super) struct RunSentences {
    /// How far it deviates, what the joints carry, how long its positions can be trusted.
    pub answers: Vec<String>,
    /// What puts these in doubt, each with its consequence.
    pub warnings: Vec<String>,
    /// The laws behind the forces, and checks that hold.
    pub details: Vec<String>,
}

/// The sentences of [`headline_sentences`] in the order of a terminal: answers, warnings, details.
pub(super) fn run_answer(record: &SimulationRecord, writer: &NumberWriter) -> RunSentences {
    /// Error of the energy balance from which on a run is in doubt.
    const LARGE_RESIDUAL: f64 = 1e-3;
    let mut answers = main_sentences(record, writer);
    answers.extend(motion_sentences(record, writer));
    answers.extend(bending_sentences(&record.bending, writer));
    answers.extend(trusted_run(record).sentences(writer));
    let (mut warnings, mut details) = (run_warnings(record, writer), law_sentences(record, writer));
    let energy = energy_sentence(record, writer);
    let is_large = record.energy.relative_residual > LARGE_RESIDUAL;
    if is_large {
        warnings.insert(0, energy)
    } else {
        details.push(energy)
    }
    let checks = checks(record);
    let check = quasi_static_sentence(record, &checks, writer);
    if checks.iter().any(|check| check.is_exceeded) {
        warnings.splice(0..0, check);
    } else {
        details.extend(check);
    }
    RunSentences { answers, warnings, details }
}

/// How far the motion deviates, the wear of a life, and what the joints carry.
fn main_sentences(record: &SimulationRecord, writer: &NumberWriter) -> Vec<String> {
    let mut sentences = Vec::new();
    let deviation = record.extremes.iter().find(|extreme| !extreme.of.is_value());
    let play: Vec<String> = record
        .joints
        .iter()
        .map(|joint| {
            let drawn = record.drawing.joints.iter().find(|drawn| drawn.name == joint.joint);
            let value = |kind: &str, value_m: f64| {
                writer.with_tag(&Tag::joint(&joint.joint, "clearance", kind)).value_trimmed(value_m, &SiUnit::LENGTH)
            };
            let (kind, clearance) = match drawn.map(|drawn| drawn.kind) {
                // No joint but a coupling: a cam has no clearance, teeth have half of their backlash on each side.
                None if joint.radial_clearance_m == 0.0 => {
                    return format!("a follower that may lift off in {}", joint.joint);
                }
                None => ("backlash", value("backlash", 2.0 * joint.radial_clearance_m)),
                // In a guide or a slot it lies between faces.
                Some(kind) if kind.has_faces() => ("clearance", value("radial", joint.radial_clearance_m)),
                Some(_) => ("radial clearance", value("radial", joint.radial_clearance_m)),
            };
            format!("a {kind} of {clearance} in {}", joint.joint)
        })
        .collect();
    let with = if play.is_empty() { "Without play".to_owned() } else { format!("With {}", listed(&play)) };
    if let Some(extreme) = deviation {
        let shown = |part: &str, point: &ExtremePoint| {
            let value_si = without_round_off(record, point.value_si, &extreme.unit);
            writer.with_tag(&Tag::extreme(extreme, part)).value(value_si, &extreme.unit)
        };
        sentences.push(format!(
            "{with}, the {} deviates from its ideal motion by {} to {}.",
            extreme.name,
            shown("minimum", &extreme.minimum),
            shown("maximum", &extreme.maximum),
        ));
    } else {
        sentences.push(format!(
            "{with}, {} were recorded.",
            turns(record.settings.recorded_turns, record.settings.drive_speed_rad_s, writer)
        ));
    }
    sentences.extend(record.life.as_ref().and_then(|life| life_sentence(life, writer)));
    for joint in &record.joints {
        let tag = |statistic: &str, part: &str| Tag::joint(&joint.joint, statistic, part);
        let force = writer.with_tag(&tag("normal force", "largest")).value(joint.peak_force_n, &SiUnit::FORCE);
        let contact = if joint.impacts == 0 {
            format!("no impact, normal contact force up to {force}")
        } else {
            format!(
                "{}, approach speed up to {}, normal contact force up to {force}",
                counted(joint.impacts, "impact", &writer.with_tag(&tag("impacts", "number"))),
                writer.with_tag(&tag("impacts", "largest speed")).value(joint.largest_speed_m_s, &SiUnit::VELOCITY),
            )
        };
        sentences.push(format!(
            "{}: {contact}, penetration up to {}.",
            joint.joint,
            writer.with_tag(&tag("penetration", "largest")).value(joint.largest_penetration_m, &SiUnit::LENGTH),
        ));
    }
    sentences
}

/// What the controls do, and of which kind the motion is.
fn motion_sentences(record: &SimulationRecord, writer: &NumberWriter) -> Vec<String> {
    let controls = record.controls.iter().flat_map(|control| control_sentences(control, writer));
    controls.chain(kind_sentences(record, writer)).collect()
}

fn energy_sentence(record: &SimulationRecord, writer: &NumberWriter) -> String {
    let tag = Tag::whole("energy residual", "relative");
    let residual = writer.with_tag(&tag);
    format!(
        "The energy balance closes to {} of the largest energy exchanged.",
        residual.rounded(record.energy.relative_residual, &SiUnit::NONE, 2, Rounding::Up)
    )
}

/// The quasi-static checks that mean something: where neither play nor the motion moves an output, round-off is divided by round-off.
fn checks(record: &SimulationRecord) -> Vec<&QuasiStaticShare> {
    let moves = |check: &&QuasiStaticShare| {
        check.is_exceeded || without_round_off(record, check.deviation_si, &check.unit) != 0.0
    };
    record.quasi_static_check.iter().filter(moves).collect()
}

/// The trust in the positions of the run.
pub(super) fn trusted_run(record: &SimulationRecord) -> TrustedRun<'_> {
    let SimulationSettings { transient_turns, drive_speed_rad_s, .. } = record.settings;
    TrustedRun { trust: &record.trust, subject: "Positions", has_start_up: transient_turns > 0.0, drive_speed_rad_s }
}

/// The outcome of the quasi-static check: the output that breaks it, or else the one that comes nearest.
fn quasi_static_sentence(
    record: &SimulationRecord,
    checks: &[&QuasiStaticShare],
    writer: &NumberWriter,
) -> Option<String> {
    let place_of = |check: &QuasiStaticShare| place_words(record, check.time_s, writer);
    let worst = checks.iter().max_by(|a, b| {
        (a.is_exceeded, a.largest_share)
            .partial_cmp(&(b.is_exceeded, b.largest_share))
            .unwrap_or(std::cmp::Ordering::Equal)
    })?;
    let skipped: usize = checks.iter().map(|check| check.samples_without_worst_case).sum();
    let tag = |part: &str| Tag::joint(&worst.output, "quasi-static check", part);
    let deviates = || {
        let (output, place) = (&worst.output, place_of(worst));
        let found = writer.with_tag(&tag("deviation")).value(worst.deviation_si, &worst.unit);
        let allowed = writer.with_tag(&tag("worst case")).value(worst.worst_case_si, &worst.unit);
        format!("the {output} deviates by {found}{place}, but clearances and penetrations permit only {allowed}")
    };
    let mut sentence = if worst.is_exceeded && skipped > 0 {
        // A dead point within the clearances lets the links pass to their other way of assembly, and no worst case is of both.
        format!(
            "{} in this assembly of the links. Either a dead point lies within the clearances, where the links can change to the other assembly, or this run is wrong: avoid the dead point to find out.",
            capitalised(&deviates())
        )
    } else if worst.is_exceeded {
        format!("This run is wrong: {}.", deviates())
    } else {
        format!(
            "No output deviates more than clearances and penetrations permit. The {} has the largest share: {} of the permitted deviation.",
            worst.output,
            writer.with_tag(&tag("share")).percent(worst.largest_share, Rounding::Up)
        )
    };
    if skipped > 0 {
        sentence.push_str(&format!(
            " {} could not be checked: a dead point lies within the clearances, or a slider overhangs its guide.",
            counted(skipped as u64, "sample", &writer.with_tag(&Tag::Count("samples that were not checked")))
        ));
    }
    Some(sentence)
}

/// ", crank at 104.2°" at an instant among the samples; the time where no drive turns at a constant speed.
fn place_words(record: &SimulationRecord, time_s: Option<f64>, writer: &NumberWriter) -> String {
    let Some(time_s) = time_s else { return String::new() };
    let row = record.time_s.partition_point(|sample_s| *sample_s < time_s);
    match record.drive_angle_rad.get(row).filter(|_| record.settings.drive_speed_rad_s.is_some()) {
        Some(angle_rad) => {
            format!(" with {} at {}", record.settings.drive, writer.angle_in_turn(*angle_rad, PLAIN_DIGITS))
        }
        None => format!(" at {}", writer.value(time_s, &SiUnit::TIME)),
    }
}

/// Largest error and effort of a control, and its oscillation where the reference rests.
fn control_sentences(control: &ControlHistory, writer: &NumberWriter) -> Vec<String> {
    let largest = |values: &[f64]| values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    let tag = |part: &str| Tag::joint(&control.name, "control", part);
    let mut sentences = vec![format!(
        "Control {}: {} deviates from its reference by up to {}, with an effort of up to {} in {}.",
        control.name,
        control.measured,
        writer.with_tag(&tag("largest error")).value(largest(&control.error_si), &control.unit),
        writer.with_tag(&tag("largest effort")).value(largest(&control.effort_si), &control.effort_unit),
        control.joint,
    )];
    if let Some(swing) = &control.swing {
        let amplitude = writer.with_tag(&tag("amplitude")).value(swing.amplitude_si, &control.unit);
        let period = writer.with_tag(&tag("period")).value(swing.period_s, &SiUnit::TIME);
        sentences.push(match swing.course {
            OscillationTrend::Steady => format!(
                "Control {}: {} does not come to rest although its reference does. It oscillates with amplitude {amplitude} and period \
                 {period} (a limit cycle, {} oscillations).",
                control.name,
                control.measured,
                count(swing.swings as u64, &writer.with_tag(&tag("oscillations")))
            ),
            OscillationTrend::Grows => format!(
                "Control {}: {} is unstable although its reference rests. It oscillates with period {period}, at the end with amplitude \
                 {amplitude}.",
                control.name, control.measured
            ),
        });
    }
    sentences
}

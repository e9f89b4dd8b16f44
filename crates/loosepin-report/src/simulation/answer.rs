//! The answer of a run in sentences, the most important first; for pages and terminals alike.

use crate::medium::short_answer::{Said, Weight};
use crate::numbers::number::{NumberWriter, PLAIN_DIGITS, Rounding};
use crate::numbers::tag::Tag;
use crate::study::answer::turns;
use crate::words::force::run_said;
use crate::words::trust::TrustedRun;
use crate::words::wording::{RUNS_WITHOUT_LEAN, capitalised, count, counted, listed, without_round_off};
use loosepin_result::simulation::{
    ControlHistory, ExtremePoint, OscillationTrend, QuasiStaticShare, SimulationRecord, SimulationSettings,
};
use loosepin_text::units::SiUnit;

use super::bending::bending_said;
use super::kind::kind_said;
use super::life::life_sentence;

/// All paragraphs of the answer, with what each matters to who reads a few of them.
pub(super) fn all_said(record: &SimulationRecord, writer: &NumberWriter) -> Vec<Said> {
    let mut said = Vec::new();
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
        said.push(Said::answer(format!(
            "{with}, the {} deviates from its ideal motion by {} to {}.",
            extreme.name,
            shown("minimum", &extreme.minimum),
            shown("maximum", &extreme.maximum),
        )));
    } else {
        said.push(Said::answer(format!(
            "{with}, {} were recorded.",
            turns(record.settings.recorded_turns, record.settings.drive_speed_rad_s, writer)
        )));
    }
    said.extend(record.life.as_ref().and_then(|life| life_sentence(life, writer)).map(Said::answer));
    // The others stand in a table.
    let most_loaded = record.joints.iter().max_by(|a, b| a.peak_force_n.total_cmp(&b.peak_force_n));
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
        let is_most_loaded = most_loaded.is_some_and(|most| most.joint == joint.joint);
        let weight = if is_most_loaded { Weight::Answer } else { Weight::Detail };
        let penetration =
            writer.with_tag(&tag("penetration", "largest")).value(joint.largest_penetration_m, &SiUnit::LENGTH);
        said.push(Said { weight, words: format!("{}: {contact}, penetration up to {penetration}.", joint.joint) });
    }
    said.extend(run_said(record, writer));
    said.extend(record.leans.then(|| Said::caveat(RUNS_WITHOUT_LEAN.to_owned())));
    for control in &record.controls {
        said.extend(control_said(control, writer));
    }
    said.extend(kind_said(record, writer));
    said.push(Said::detail(format!(
        "The energy balance closes to {} of the largest energy exchanged.",
        writer.with_tag(&Tag::whole("energy residual", "relative")).rounded(
            record.energy.relative_residual,
            &SiUnit::NONE,
            2,
            Rounding::Up
        )
    )));
    said.extend(trusted_run(record).said(writer));
    said.extend(bending_said(&record.bending, writer));
    // Where neither play nor the motion moves an output, round-off is divided by round-off.
    let moves = |check: &&QuasiStaticShare| {
        check.is_exceeded || without_round_off(record, check.deviation_si, &check.unit) != 0.0
    };
    let checks: Vec<&QuasiStaticShare> = record.quasi_static_check.iter().filter(moves).collect();
    let is_in_doubt = |check: &&QuasiStaticShare| check.is_exceeded || check.samples_without_worst_case > 0;
    let weight = if checks.iter().any(is_in_doubt) { Weight::Caveat } else { Weight::Detail };
    said.extend(quasi_static_sentence(record, &checks, writer).map(|words| Said { weight, words }));
    said
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
fn control_said(control: &ControlHistory, writer: &NumberWriter) -> Vec<Said> {
    let largest = |values: &[f64]| values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    let tag = |part: &str| Tag::joint(&control.name, "control", part);
    let mut said = vec![Said::detail(format!(
        "Control {}: {} deviates from its reference by up to {}, with an effort of up to {} in {}.",
        control.name,
        control.measured,
        writer.with_tag(&tag("largest error")).value(largest(&control.error_si), &control.unit),
        writer.with_tag(&tag("largest effort")).value(largest(&control.effort_si), &control.effort_unit),
        control.joint,
    ))];
    if let Some(swing) = &control.swing {
        let amplitude = writer.with_tag(&tag("amplitude")).value(swing.amplitude_si, &control.unit);
        let period = writer.with_tag(&tag("period")).value(swing.period_s, &SiUnit::TIME);
        said.push(Said::caveat(match swing.course {
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
        }));
    }
    said
}

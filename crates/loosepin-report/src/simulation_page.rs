//! The page of one run: outputs over time, deviation, impacts, contact force, journal paths, energy, the mechanism.

use maud::{Markup, html};
use std::f64::consts::TAU;

use super::answer::{turn_word, turns};
use super::bending_words::bending_sentences;
use super::chart::{Chart, Dots, Entry, Role};
use super::figure::name_of;
use super::force_words::{ForcesOf, run_sentences};
use super::life_section::life_sentence;
use super::measured_figures::measured_figures;
use super::mechanism_figure::mechanism_figure;
use super::motion_kind_section::{kind_section, kind_sentences};
use super::number::{NumberWriter, PLAIN_DIGITS, Rounding};
use super::page::{Page, Section, cards, facts, sentences};
use super::repeat_section::repeat_section;
use super::spectrum_section::spectrum_section;
use super::still_figures::orbit_figure;
use super::tag::Tag;
use super::trust_words::TrustedRun;
use super::wear_section::wear_section;
use super::wording::{capitalised, count, counted, deviation_words, listed, named_words, without_round_off};
use loosepin_result::simulation::{
    ControlHistory, Extreme, ExtremePoint, ImpactRecord, JointSummary, OutputHistory, QuasiStaticShare,
    SimulationRecord, SimulationSettings, StopReason, SwingCourse,
};
use loosepin_result::study::Deviation;
use loosepin_text::units::SiUnit;

/// Rows of the table of impacts; the others stand in `impacts.csv`.
const MOST_IMPACTS: usize = 30;
/// A record that begins this share of a turn before a whole number of turns, by round-off, begins at 0°.
const SHARE_OF_TURN: f64 = 1e-9;

/// The page of one run as one HTML text that needs no network: outputs and their deviation over time, impacts, contact
/// force, journal paths, the energy account, and the moving mechanism. Text from files is escaped.
pub fn simulation_page(record: &SimulationRecord) -> String {
    let writer = NumberWriter::for_page(&record.display_units);
    let first = record.outputs.iter().position(|output| !output.deviation_si.is_empty());
    let below = first.map(|index| deviation_chart(record, &record.outputs[index], &writer).figure());
    let mut sections = Vec::new();
    if !record.orbits.is_empty() {
        let words = "The path of the pin centre relative to the hole, in the frame of the part with the hole.";
        let markup = html! {
            p { (words) }
            div.orbits { @for orbit in &record.orbits { (orbit_figure(orbit, &writer)) } }
        };
        sections.push(Section::new("orbits", "The journal in its bearing", markup));
    }
    // The numbers before the charts: on a narrow screen those are several screens high.
    if !record.extremes.is_empty() {
        sections.push(Section::new("extremes", "Smallest and largest values", extremes(record, &writer)));
    }
    sections.push(Section::new("outputs", "Outputs", outputs(record, &writer)));
    if record.outputs.iter().filter(|output| !output.deviation_si.is_empty()).count() > 1 {
        sections.push(Section::new(
            "deviation",
            "Other deviations from the ideal motion",
            deviations(record, first, &writer),
        ));
    }
    if !record.measured.is_empty() {
        sections.push(Section::new("measured", "Measured against computed", measured_figures(record, &writer)));
    }
    if let Some(spectra) = spectrum_section(record, &writer) {
        sections.push(Section::new("spectra", "Oscillations", spectra));
    }
    if !record.joints.is_empty() {
        sections.push(Section::new("contact", "Contact and impacts", contact(record, &writer)));
    }
    if !record.wear.is_empty() {
        sections.push(Section::new("wear", "Wear", wear_section(record)));
    }
    if !record.controls.is_empty() {
        sections.push(Section::new("control", "Controls", controls(record, &writer)));
    }
    if let Some(kind) = kind_section(record, &writer) {
        sections.push(Section::new("kind", "Kind of motion", kind));
    }
    if let Some(trust) = trusted_run(record).section(&writer) {
        sections.push(Section::new("trust", "How long the positions can be trusted", trust));
    }
    sections.push(Section::new("energy", "Energy balance", energy(record, &writer)));
    sections.push(Section::new("method", "How this was computed", method(record, &writer)));
    sections.extend(repeat_section(&record.repeat));
    Page {
        title: record.model.clone(),
        kicker: "Simulation",
        subtitle: html! {
            @if let Some(speed) = record.settings.drive_speed_rad_s {
                (record.settings.drive) " at "
                (writer.about(&Tag::Given("speed of the drive")).value_shortest(speed, &SiUnit::ANGULAR_VELOCITY)) ", "
            }
            (turns(record.settings.recorded_turns, record.settings.drive_speed_rad_s, &writer))
            @for change in &record.overrides { " · " code { (change.path) " = " (change.written) } }
        },
        answer: answer(record, &writer),
        is_answer_short: true,
        beside: mechanism_figure(&record.drawing, &record.settings.drive),
        below: below.unwrap_or_default(),
        sections,
        identity: "simulation".to_owned(),
        version: record.version.clone(),
    }
    .into_html()
}

fn answer(record: &SimulationRecord, writer: &NumberWriter) -> Markup {
    html! {
        @if let StopReason::Failed { words, .. } = &record.stop {
            p.verdict.not-met { "The run failed" }
            p { (words) ". This page shows what was computed." }
        }
        (sentences(&headline_sentences(record, writer)))
    }
}

/// The answer of a run in sentences, the most important first; for pages and terminals alike.
pub(super) fn headline_sentences(record: &SimulationRecord, writer: &NumberWriter) -> Vec<String> {
    let mut sentences = Vec::new();
    let deviation = record.extremes.iter().find(|extreme| extreme.of != Deviation::Value);
    let play: Vec<String> = record
        .joints
        .iter()
        .map(|joint| {
            let drawn = record.drawing.joints.iter().find(|drawn| drawn.name == joint.joint);
            let value = |kind: &str, value_m: f64| {
                writer.about(&Tag::joint(&joint.joint, "clearance", kind)).value_trimmed(value_m, &SiUnit::LENGTH)
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
            writer.about(&Tag::extreme(extreme, part)).value(value_si, &extreme.unit)
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
        let force = writer.about(&tag("normal force", "largest")).value(joint.peak_force_n, &SiUnit::FORCE);
        let contact = if joint.impacts == 0 {
            format!("no impact, normal contact force up to {force}")
        } else {
            format!(
                "{}, approach speed up to {}, normal contact force up to {force}",
                counted(joint.impacts, "impact", &writer.about(&tag("impacts", "number"))),
                writer.about(&tag("impacts", "largest speed")).value(joint.largest_speed_m_s, &SiUnit::VELOCITY),
            )
        };
        sentences.push(format!(
            "{}: {contact}, penetration up to {}.",
            joint.joint,
            writer.about(&tag("penetration", "largest")).value(joint.largest_penetration_m, &SiUnit::LENGTH),
        ));
    }
    sentences.extend(run_sentences(record, writer));
    for control in &record.controls {
        sentences.extend(control_sentences(control, writer));
    }
    sentences.extend(kind_sentences(record, writer));
    sentences.push(format!(
        "The energy balance has an error of {} of the largest energy exchanged.",
        writer.about(&Tag::whole("energy residual", "relative")).rounded(
            record.energy.relative_residual,
            &SiUnit::NONE,
            2,
            Rounding::Up
        )
    ));
    sentences.extend(trusted_run(record).sentences(writer));
    sentences.extend(bending_sentences(&record.bending, writer));
    // Where neither play nor the motion moves an output, round-off is divided by round-off.
    let moves = |check: &&QuasiStaticShare| {
        check.is_exceeded || without_round_off(record, check.deviation_si, &check.unit) != 0.0
    };
    let checks: Vec<&QuasiStaticShare> = record.quasi_static_check.iter().filter(moves).collect();
    sentences.extend(quasi_static_sentence(record, &checks, writer));
    sentences
}

fn trusted_run(record: &SimulationRecord) -> TrustedRun<'_> {
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
        let found = writer.about(&tag("deviation")).value(worst.deviation_si, &worst.unit);
        let allowed = writer.about(&tag("worst case")).value(worst.worst_case_si, &worst.unit);
        format!("the {output} deviates by {found}{place}, but clearances and penetrations allow only {allowed}")
    };
    let mut sentence = if worst.is_exceeded && skipped > 0 {
        // A dead point within the clearances lets the links pass to their other way of assembly, and no worst case is of both.
        format!(
            "{} as the links are assembled. A dead point lies within the clearances, where they can pass to the other way of \
             assembling, or this run is wrong: avoid the dead point to tell.",
            capitalised(&deviates())
        )
    } else if worst.is_exceeded {
        format!("This run is wrong: {}.", deviates())
    } else {
        format!(
            "No output deviates more than clearances and penetrations allow. The {} comes nearest, with {} of the allowed deviation.",
            worst.output,
            writer.about(&tag("share")).percent(worst.largest_share, Rounding::Up)
        )
    };
    if skipped > 0 {
        sentence.push_str(&format!(
            " {} could not be checked: a dead point lies within the clearances, or a slider overhangs its guide.",
            counted(skipped as u64, "sample", &writer.about(&Tag::Count("samples that were not checked")))
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
        writer.about(&tag("largest error")).value(largest(&control.error_si), &control.unit),
        writer.about(&tag("largest effort")).value(largest(&control.effort_si), &control.effort_unit),
        control.joint,
    )];
    if let Some(swing) = &control.swing {
        let amplitude = writer.about(&tag("amplitude")).value(swing.amplitude_si, &control.unit);
        let period = writer.about(&tag("period")).value(swing.period_s, &SiUnit::TIME);
        sentences.push(match swing.course {
            SwingCourse::Steady => format!(
                "Control {}: {} does not come to rest although its reference does. It oscillates with amplitude {amplitude} and period \
                 {period} (a limit cycle, {} oscillations).",
                control.name,
                control.measured,
                count(swing.swings as u64, &writer.about(&tag("oscillations")))
            ),
            SwingCourse::Grows => format!(
                "Control {}: {} is unstable although its reference rests. It oscillates with period {period}, at the end with amplitude \
                 {amplitude}.",
                control.name, control.measured
            ),
        });
    }
    sentences
}

/// A chart over the angle of the drive, from 0° on, where it turns forwards at constant speed; else over time.
fn run_chart(record: &SimulationRecord, id: String, writer: &NumberWriter) -> Chart {
    if !record.settings.drive_speed_rad_s.is_some_and(|speed| speed > 0.0) {
        return Chart::over(id, "time", &record.time_s, &SiUnit::TIME, writer);
    }
    let before_rad = before_rad(record);
    let angles_rad: Vec<f64> = record.drive_angle_rad.iter().map(|angle_rad| angle_rad - before_rad).collect();
    Chart::over_angle(id, &record.settings.drive, &angles_rad, writer)
}

/// Where an impact stands in the charts of a run.
fn impact_place(record: &SimulationRecord, impact: &ImpactRecord, writer: &NumberWriter) -> f64 {
    if !record.settings.drive_speed_rad_s.is_some_and(|speed| speed > 0.0) {
        return writer.scaled(impact.time_s, &SiUnit::TIME);
    }
    writer.scaled(impact.drive_angle_rad - before_rad(record), &SiUnit::ANGLE)
}

/// Whole turns before the recorded part, rad.
fn before_rad(record: &SimulationRecord) -> f64 {
    let first_rad = record.drive_angle_rad.first().copied().unwrap_or_default();
    (first_rad / TAU + SHARE_OF_TURN).floor() * TAU
}

/// What the charts of a run are over, in words.
fn abscissa_words(record: &SimulationRecord) -> String {
    match record.settings.drive_speed_rad_s {
        Some(speed) if speed > 0.0 => format!("over the angle of {}", record.settings.drive),
        _ => "over time".to_owned(),
    }
}

fn outputs(record: &SimulationRecord, writer: &NumberWriter) -> Markup {
    html! {
        div.charts {
            @for output in &record.outputs {
                (output_chart(record, output, writer).figure())
            }
        }
    }
}

fn output_chart(record: &SimulationRecord, output: &OutputHistory, writer: &NumberWriter) -> Chart {
    let mut chart = run_chart(record, name_of("output", &output.name), writer);
    chart.y_label.clone_from(&output.name);
    chart.y_symbol = writer.symbol(&output.unit);
    chart.entries.push(Entry::line("with play", Role::First, false, &output.value_si, &output.unit, writer));
    if !output.ideal_si.is_empty() {
        chart.entries.push(Entry::line("ideal", Role::Worst, true, &output.ideal_si, &output.unit, writer));
    }
    let over = abscissa_words(record);
    chart.caption = html! { strong { (named_words(&output.name, &output.words)) } " " (over) "." };
    chart.alternative = format!("Chart of {} {over}.", named_words(&output.name, &output.words));
    chart
}

fn deviations(record: &SimulationRecord, shown: Option<usize>, writer: &NumberWriter) -> Markup {
    html! {
        div.charts {
            @for (index, output) in record.outputs.iter().enumerate() {
                @if !output.deviation_si.is_empty() && Some(index) != shown { (deviation_chart(record, output, writer).figure()) }
            }
        }
    }
}

fn deviation_chart(record: &SimulationRecord, output: &OutputHistory, writer: &NumberWriter) -> Chart {
    let mut chart = run_chart(record, name_of("deviation", &output.name), writer);
    chart.y_label = format!("deviation of {}", output.name);
    chart.y_symbol = writer.symbol(&output.unit);
    chart.entries.push(Entry::line(
        "actual minus ideal",
        Role::Mixed,
        false,
        &output.deviation_si,
        &output.unit,
        writer,
    ));
    chart.caption = html! { strong { "Deviation of " (named_words(&output.name, &output.words)) } ": actual minus ideal at the same time." };
    chart.alternative = format!(
        "Chart of the deviation of {} from its ideal value {}.",
        named_words(&output.name, &output.words),
        abscissa_words(record)
    );
    chart
}

/// What an extreme is of: `slider`, or `slider, deviation`.
pub(super) fn extreme_words(extreme: &Extreme) -> String {
    match extreme.of {
        Deviation::Value => extreme.name.clone(),
        of => format!("{}, {}", extreme.name, deviation_words(of)),
    }
}

fn extremes(record: &SimulationRecord, writer: &NumberWriter) -> Markup {
    let point = |extreme: &Extreme, part: &str, point: &ExtremePoint| {
        let tag = Tag::extreme(extreme, part);
        let value_si = without_round_off(record, point.value_si, &extreme.unit);
        html! {
            strong { (writer.about(&tag).value(value_si, &extreme.unit)) } " "
            span.quiet {
                (writer.about(&tag.part("time")).value(point.time_s, &SiUnit::TIME))
                @if record.settings.drive_speed_rad_s.is_some() {
                    ", " (record.settings.drive) " at "
                    (writer.about(&tag.part("angle")).angle_in_turn(point.drive_angle_rad, PLAIN_DIGITS))
                }
            }
        }
    };
    html! {
        p {
            "Extremes of the continuous motion, also between the samples."
            @if record.joints.iter().any(|joint| joint.impacts + joint.contacts > 0) {
                " A force in a joint is the whole force, with friction and damping; the contact forces of the joints are normal to the surfaces."
            }
        }
        (cards(["Quantity", "#Smallest", "#Largest"], record.extremes.iter().map(|extreme| [
            html! { (extreme_words(extreme)) },
            point(extreme, "minimum", &extreme.minimum),
            point(extreme, "maximum", &extreme.maximum),
        ])))
    }
}

fn contact(record: &SimulationRecord, writer: &NumberWriter) -> Markup {
    let shown = record.impacts.len().min(MOST_IMPACTS);
    let number_shown = count(shown as u64, &writer.about(&Tag::Count("impacts that are shown")));
    html! {
        @for joint in &record.joints { h3 { (joint.joint) } (facts(&joint_facts(joint, turn_word(record.settings.drive_speed_rad_s), writer))) }
        @if record.contact_forces.iter().any(|history| !history.force_n.is_empty()) {
            (force_chart(record, writer).figure())
        }
        @if !record.impacts.is_empty() {
            details.numbers {
                summary {
                    @if shown < record.impacts.len() {
                        "The first " (number_shown) " of "
                        (count(record.impacts.len() as u64, &writer.about(&Tag::Count("impacts")))) " impacts"
                    }
                    @else if shown == 1 { "The impact" }
                    @else { "All " (number_shown) " impacts" }
                }
                div.scroll tabindex="0" role="region" aria-label="Table of impacts" { (impact_table(record, shown, writer)) }
            }
        }
    }
}

fn impact_table(record: &SimulationRecord, shown: usize, writer: &NumberWriter) -> Markup {
    // The phase of a cycle in which no drive turns tells nothing that the time does not.
    let has_angle = record.settings.drive_speed_rad_s.is_some();
    let row = |place: usize, impact: &ImpactRecord| {
        let number = format!("impact {place}");
        let tag = |part: &str| Tag::joint(&impact.joint, &number, part);
        html! {
            tr {
                th scope="row" { (writer.about(&tag("time")).value(impact.time_s, &SiUnit::TIME)) }
                @if has_angle { td { (writer.about(&tag("angle")).angle_in_turn(impact.drive_angle_rad, PLAIN_DIGITS)) } }
                td { (impact.joint) }
                td { (writer.about(&tag("speed")).value(impact.speed_m_s, &SiUnit::VELOCITY)) }
                td { (writer.about(&tag("duration")).value(impact.duration_s, &SiUnit::TIME)) }
                td { (writer.about(&tag("peak force")).value(impact.peak_force_n, &SiUnit::FORCE)) }
                td {
                    @match impact.separation_speed_m_s {
                        Some(speed) => (writer.about(&tag("separation speed")).value(speed, &SiUnit::VELOCITY)),
                        None => "still touching",
                    }
                }
            }
        }
    };
    html! {
        table {
            thead {
                tr {
                    th scope="col" { "Onset" }
                    @if has_angle { th scope="col" { "Angle of " (record.settings.drive) } }
                    th scope="col" { "Joint" }
                    th scope="col" { "Approach speed" }
                    th scope="col" { "Duration" }
                    th scope="col" { "Peak force" }
                    th scope="col" { "Separation speed" }
                }
            }
            tbody { @for (place, impact) in record.impacts.iter().take(shown).enumerate() { (row(place, impact)) } }
        }
    }
}

fn force_chart(record: &SimulationRecord, writer: &NumberWriter) -> Chart {
    let mut chart = run_chart(record, "contact-force".to_owned(), writer);
    chart.y_label = "contact force".to_owned();
    chart.y_symbol = writer.symbol(&SiUnit::FORCE);
    for (index, history) in record.contact_forces.iter().enumerate() {
        let role = Role::of_index(index);
        let own = record.impacts.iter().filter(|impact| impact.joint == history.joint);
        let point = |impact: &ImpactRecord| {
            [impact_place(record, impact, writer), writer.scaled(impact.peak_force_n, &SiUnit::FORCE)]
        };
        chart.dots.push(Dots { entry: index, role, points: own.map(point).collect() });
        chart.entries.push(Entry::line(&history.joint, role, false, &history.force_n, &SiUnit::FORCE, writer));
    }
    chart.caption = html! {
        strong { "Normal contact force" } " at the sample times. Dots: the largest force of each impact, which lies between samples."
    };
    chart.alternative =
        format!("Chart of the normal contact force of each joint with play {}.", abscissa_words(record));
    chart
}

fn controls(record: &SimulationRecord, writer: &NumberWriter) -> Markup {
    html! {
        @for control in &record.controls {
            h3 { (control.name) }
            @let about = html! { strong { "Error." } " Reference minus " (control.measured) "." };
            (control_chart(record, name_of("control-error", &control.name), "error", (&control.error_si, &control.unit), about, writer))
            @let about = html! { strong { "Effort." } " Force or torque of the actuator in " (control.joint) "." };
            (control_chart(record, name_of("control-effort", &control.name), "effort", (&control.effort_si, &control.effort_unit), about, writer))
        }
    }
}

fn control_chart(
    record: &SimulationRecord,
    id: String,
    label: &str,
    (values_si, unit): (&[f64], &SiUnit),
    caption: Markup,
    writer: &NumberWriter,
) -> Markup {
    let mut chart = run_chart(record, id, writer);
    chart.height = 220;
    chart.y_label = label.to_owned();
    chart.y_symbol = writer.symbol(unit);
    chart.entries.push(Entry::line(label, Role::Mixed, false, values_si, unit, writer));
    chart.caption = caption;
    chart.alternative = format!("Chart of the {label} of a control {}.", abscissa_words(record));
    chart.figure()
}

/// The law with what it rests on; in records of older versions its name.
fn law_words(joint: &JointSummary, writer: &NumberWriter) -> String {
    ForcesOf::run(joint).laws(writer).pop().unwrap_or_else(|| joint.law.clone())
}

fn joint_facts(joint: &JointSummary, turn: &str, writer: &NumberWriter) -> Vec<(String, Markup)> {
    let tag = |statistic: &str, part: &str| Tag::joint(&joint.joint, statistic, part);
    let tenths = |statistic: &str, value: f64| {
        writer.about(&tag(statistic, "per turn")).shortest((value * 10.0).round() / 10.0, &SiUnit::NONE)
    };
    let mut rows = vec![
        ("Contact law".to_owned(), html! { (law_words(joint, writer)) }),
        (
            "Contacts".to_owned(),
            html! {
                (count(joint.contacts, &writer.about(&tag("contacts", "number")))) ", of which " (count(joint.impacts, &writer.about(&tag("impacts", "number")))) " impacts"
                @if let Some(per_turn) = joint.impacts_per_turn {
                    " (" (tenths("impacts", per_turn)) " per " (turn) ")"
                }
            },
        ),
        (
            "Loss of contact".to_owned(),
            html! {
                "no contact during " (writer.about(&tag("flight", "share")).percent(joint.flight_share, Rounding::Nearest)) " of the time; contact lost "
                (tenths("losses", joint.losses_per_turn)) " times per " (turn)
            },
        ),
        (
            "Largest penetration".to_owned(),
            html! {
                (writer.about(&tag("penetration", "largest")).value(joint.largest_penetration_m, &SiUnit::LENGTH))
                @if joint.radial_clearance_m > 0.0 {
                    ", " (writer
                        .about(&tag("penetration", "largest share"))
                        .percent(joint.largest_penetration_m / joint.radial_clearance_m, Rounding::Up))
                    " of the clearance of " (writer.about(&tag("clearance", "radial")).value_trimmed(joint.radial_clearance_m, &SiUnit::LENGTH))
                }
            },
        ),
        (
            "Largest normal contact force".to_owned(),
            html! { (writer.about(&tag("normal force", "largest")).value(joint.peak_force_n, &SiUnit::FORCE)) },
        ),
        (
            "Largest approach speed".to_owned(),
            html! { (writer.about(&tag("impacts", "largest speed")).value(joint.largest_speed_m_s, &SiUnit::VELOCITY)) },
        ),
    ];
    if let (Some(nominal), Some(delivered)) = (joint.nominal_restitution, joint.delivered_restitution) {
        rows.push((
            "Restitution".to_owned(),
            html! {
                "stated " (writer.about(&tag("restitution", "stated")).shortest(nominal, &SiUnit::NONE)) "; a free impact under this law gives "
                strong { (writer.about(&tag("restitution", "delivered")).value_trimmed(delivered, &SiUnit::NONE)) }
            },
        ));
    }
    rows.extend(speed_facts(&joint.joint, joint.share_outside_validity, joint.floored_contacts, writer));
    rows
}

/// Impacts faster than the contact law is valid for, and contacts slower than it can be computed with.
pub(super) fn speed_facts(
    joint: &str,
    share_outside_validity: Option<f64>,
    floored_contacts: u64,
    writer: &NumberWriter,
) -> impl Iterator<Item = (String, Markup)> {
    let outside = share_outside_validity.map(|share| {
        let share = writer.about(&Tag::joint(joint, "impacts", "outside validity")).percent(share, Rounding::Up);
        let words = html! { (share) " of the impacts are faster than the contact law is valid for" };
        ("Outside the law's validity".to_owned(), words)
    });
    let slow = (floored_contacts > 0).then(|| {
        let words = html! { (count(floored_contacts, &writer.about(&Tag::joint(joint, "impacts", "very slow")))) " computed with the smallest impact speed of the law" };
        ("Very slow contacts".to_owned(), words)
    });
    outside.into_iter().chain(slow)
}

fn energy(record: &SimulationRecord, writer: &NumberWriter) -> Markup {
    let account = &record.energy;
    let unit = SiUnit::ENERGY;
    let mut chart = run_chart(record, "energy-account".to_owned(), writer);
    chart.y_label = "energy".to_owned();
    chart.y_symbol = writer.symbol(&unit);
    let histories = [
        ("kinetic", Role::First, false, &account.kinetic_j),
        ("potential", Role::Third, false, &account.potential_j),
        ("stored in contacts and springs", Role::Fourth, false, &account.stored_j),
        ("lost in contacts", Role::Second, false, &account.contact_loss_j),
        ("lost in friction", Role::Limit, false, &account.friction_loss_j),
        ("lost in dampers", Role::Mixed, false, &account.damping_loss_j),
        ("supplied", Role::Worst, true, &account.supplied_j),
    ];
    for (label, role, is_dashed, values_j) in histories {
        if values_j.iter().any(|value| *value != 0.0) {
            chart.entries.push(Entry::line(label, role, is_dashed, values_j, &unit, writer));
        }
    }
    chart.caption = html! {
        strong { "Energy balance." } " Kinetic, potential and stored energy, losses, and the work supplied since the start. Parts \
        that are always zero are not drawn."
    };
    chart.alternative = "Chart of the parts of the energy balance over time.".to_owned();
    let mut rest = run_chart(record, "energy-residual".to_owned(), writer);
    rest.height = 200;
    rest.y_label = "residual".to_owned();
    rest.y_symbol = writer.symbol(&unit);
    rest.entries.push(Entry::line("residual", Role::Worst, false, &account.residual_j, &unit, writer));
    rest.caption = html! {
        strong { "Residual of the energy balance." } " At most "
        (writer
            .about(&Tag::whole("energy residual", "relative"))
            .rounded(account.relative_residual, &SiUnit::NONE, 2, Rounding::Up))
        " of the largest energy exchanged. It checks the run."
    };
    rest.alternative = "Chart of the energy residual over time.".to_owned();
    html! {
        @if !chart.entries.is_empty() { (chart.figure()) }
        @if !account.residual_j.is_empty() { (rest.figure()) }
    }
}

fn method(record: &SimulationRecord, writer: &NumberWriter) -> Markup {
    let settings = &record.settings;
    let counters = &record.counters;
    facts(&[
        (
            "Turns".to_owned(),
            html! {
                (turns(settings.transient_turns, settings.drive_speed_rad_s, writer)) " of start-up, then "
                (turns(settings.recorded_turns, settings.drive_speed_rad_s, writer)) " recorded, "
                (count(settings.samples_per_turn as u64, &writer.about(&Tag::Given("samples")))) " samples per " (turn_word(settings.drive_speed_rad_s))
            },
        ),
        (
            "Integration".to_owned(),
            html! {
                (settings.method) ", tolerance " (writer.about(&Tag::Given("tolerance")).value_shortest(settings.tolerance_m, &SiUnit::LENGTH))
            },
        ),
        (
            "Work".to_owned(),
            html! {
                (count(counters.steps, &writer.about(&Tag::Count("steps")))) " steps, " (count(counters.rejections, &writer.about(&Tag::Count("rejections")))) " rejected, "
                (count(counters.evaluations, &writer.about(&Tag::Count("evaluations")))) " evaluations of the equations of motion, "
                @if counters.factorizations > 0 { (count(counters.factorizations, &writer.about(&Tag::Count("factorizations")))) " factorizations, " }
                (count(counters.contact_changes, &writer.about(&Tag::Count("contact changes")))) " contact changes located"
            },
        ),
        trusted_run(record).fact(writer),
        ("Version".to_owned(), html! { "loosepin " (record.version) }),
    ])
}

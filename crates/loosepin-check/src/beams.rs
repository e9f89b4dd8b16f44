//! Descriptions of flexible bodies.

use loosepin_mechanics::contact::NormalContact;
use loosepin_mechanics::mechanism::{
    Condensed, Mechanism, NodalGeometry, PlayGeometry, Sample, TreeBeam, TreeNodalBeam,
};
use loosepin_mechanics::model::{Body, BodyId, LumpedMass, Model, PlayId, Values};
use loosepin_simulate::{estimate_bending, other_formulation};
use loosepin_text::article::{Fact, Section};
use loosepin_text::units::{Dimension, counted, counted_or_no, format_value, listed};

use super::bending::bending_lines;

/// Penetration at which the stiffness of a contact is compared with that of the beam, m: that of a hard impact.
const PENETRATION_M: f64 = 10e-6;

/// Evaluations of the equations for a second of motion above which a beam counts as costly: 4 + 4 shapes of a slender rod take half of them.
const MANY_EVALUATIONS_1_S: f64 = 1e6;

/// Evaluations for a second of motion that the fastest shape asks of the integrator, by its stability: twelve for a step h with |λ|h up to
/// 5.96 on the imaginary axis and 6.39 on the real one; λ of a shape at ω with the damping ratio ζ is at most ω (ζ + √(ζ² - 1)), or ω.
fn evaluations_1_s(frequency_hz: f64, damping_ratio: f64) -> f64 {
    let omega_rad_s = std::f64::consts::TAU * frequency_hz;
    let beyond = (damping_ratio * damping_ratio - 1.0).max(0.0).sqrt();
    let decay_1_s = if damping_ratio > 1.0 { omega_rad_s * (damping_ratio + beyond) } else { 0.0 };
    12.0 * (omega_rad_s / 5.961).max(decay_1_s / 6.394)
}

/// Shapes, frequencies, Euler load and stiffness of each flexible body; `None` if there are none.
pub fn beams(mechanism: &Mechanism, values: &Values, turn_s: f64) -> Option<Section> {
    let real = &mechanism.real;
    let sample = Sample::<f64>::new(mechanism, values).ok()?;
    let count = real.flexible_bodies().count();
    if count == 0 {
        return None;
    }
    let model = &mechanism.model;
    let cycle = &model.cycle;
    let span_s = turn_s * (cycle.transient_turns + cycle.recorded_turns).min(1.0);
    let estimates = estimate_bending(mechanism, values, span_s);
    let estimate_lines = |body: BodyId| match &estimates {
        Ok(estimates) => {
            let estimate = estimates.iter().find(|estimate| estimate.body == body);
            estimate.map_or_else(Vec::new, |estimate| bending_lines(model, estimate, mechanism.is_driven()))
        }
        Err(failure) => vec![format!("its bending could not be estimated: {failure}")],
    };
    let name = |body: BodyId| &model.bodies[body.0].name;
    let floating = real.beams.iter().enumerate().map(|(index, place)| {
        let contacts =
            contact_lines((mechanism, &sample), place.body, sample.real.beams[index].beam.axial_stiffness_n_m);
        let lines = floating_lines((mechanism, &sample), index, values);
        Fact::new(name(place.body), lines.into_iter().chain(estimate_lines(place.body)).chain(contacts))
    });
    let nodal = real.nodal_beams.iter().zip(&sample.real.nodal_beams).map(|(place, numbers)| {
        let lines = nodal_lines((mechanism, &sample), place, numbers);
        Fact::new(name(place.body), lines.into_iter().chain(estimate_lines(place.body)))
    });
    let heading = counted_or_no(count, "flexible body", "flexible bodies");
    Some(Section::of_facts("flexible-bodies", heading, floating.chain(nodal)))
}

/// Length, Euler load and axial stiffness of a body.
fn stiffness_words(length_m: f64, euler_load_n: f64, axial_stiffness_n_m: f64) -> String {
    format!(
        "beam of {}: Euler load {}, EA/L {}",
        format_value(length_m, Dimension::LENGTH),
        format_value(euler_load_n, Dimension::FORCE),
        format_value(axial_stiffness_n_m, Dimension::SPRING_STIFFNESS),
    )
}

/// Shapes, frequencies and cost of a body in a floating frame.
fn floating_lines((mechanism, sample): (&Mechanism, &Sample<f64>), index: usize, values: &Values) -> Vec<String> {
    let model = &mechanism.model;
    let (place, numbers) = (&mechanism.real.beams[index], &sample.real.beams[index]);
    let beam = &numbers.beam;
    let mut lines = vec![stiffness_words(beam.length_m, beam.euler_load_n(), beam.axial_stiffness_n_m)];
    let lumps = lumps_in_words(model, place, values);
    let [axial, lateral] = match lumps.is_empty() {
        true => beam.frequencies_hz(&place.shapes),
        false => sample.real.held_beam(&mechanism.real, index).frequencies_hz(),
    };
    let condensed = numbers.condensed.as_ref();
    let limit_hz = condensed.map_or(f64::INFINITY, |condensed| condensed.above_hz);
    let fastest_hz = axial.iter().chain(&lateral).fold(0.0_f64, |fastest, hz| fastest.max(*hz)).min(limit_hz);
    let lowest_hz = axial.iter().chain(&lateral).fold(f64::INFINITY, |lowest, hz| lowest.min(*hz));
    for (frequencies_hz, one, many) in
        [(lateral, "lateral shape", "lateral shapes"), (axial, "axial shape", "axial shapes")]
    {
        let in_words = |hz: &f64| format!("{} Hz", format_value(*hz, Dimension::NUMBER));
        let hz: Vec<String> = frequencies_hz.iter().map(in_words).collect();
        let at = if hz.is_empty() { String::new() } else { format!(" at {} with the frame held", listed(&hz, "and")) };
        lines.push(format!("{}{at}", counted_or_no(frequencies_hz.len(), one, many)));
    }
    if let Some(Condensed { above_hz, were_hz }) = condensed.filter(|condensed| !condensed.were_hz.is_empty()) {
        lines.push(format!(
            "{} above {} Hz condensed: static flexibility is kept, faster vibrations are not",
            counted(were_hz.len(), "shape"),
            format_value(*above_hz, Dimension::NUMBER),
        ));
        if *above_hz <= lowest_hz {
            lines.push(format!(
                "warning: all its shapes are condensed: condense_above lies below the lowest of them, {} Hz",
                format_value(lowest_hz, Dimension::NUMBER),
            ));
            lines.push(
                "hint: use condense_above greater than 3 divided by the duration of a contact, or omit it".to_owned(),
            );
        }
    }
    if !lumps.is_empty() {
        lines.push(format!("with {}", listed(&lumps, "and")));
    }
    let points = &model.bodies[place.body.0].points;
    let held: Vec<String> =
        place.points_with_static_shapes().iter().map(|point| format!("'{}'", points[*point].name)).collect();
    if !held.is_empty() {
        lines.push(format!("static shapes at {} among them", listed(&held, "and")));
    }
    lines.push(format!("starts {}", start_of(mechanism, place.body)));
    let evaluations_1_s = evaluations_1_s(fastest_hz, beam.damping_ratio);
    if evaluations_1_s > MANY_EVALUATIONS_1_S {
        lines.push(format!("warning: its fastest shape needs {evaluations_1_s:.1e} evaluations per second of motion"));
        lines.push(format!(
            "hint: use condense_above, fewer shapes, or a smaller damping_ratio{}",
            if held.is_empty() { "" } else { ", or static_shapes = \"none\"" }
        ));
    }
    lines
}

/// The lumps of a body, each with its mass and its point.
fn lumps_in_words(model: &Model, place: &TreeBeam, values: &Values) -> Vec<String> {
    let Body { points, beam, .. } = &model.bodies[place.body.0];
    let in_words = |lump: &LumpedMass| {
        let mass = format_value(values[lump.mass_kg], Dimension::MASS);
        format!("{mass} ('{}') at '{}'", lump.name, points[lump.point].name)
    };
    beam.iter().flat_map(|beam| &beam.lumps).map(in_words).collect()
}

/// How a flexible body starts.
fn start_of(mechanism: &Mechanism, body: BodyId) -> &'static str {
    let settles = mechanism.model.bodies[body.0].beam.as_ref().is_some_and(|beam| beam.starts_settled);
    if settles { "settled" } else { "undeformed" }
}

/// Mesh, Euler load, stiffness and cost of a body in absolute nodal coordinates.
fn nodal_lines(
    (mechanism, sample): (&Mechanism, &Sample<f64>),
    place: &TreeNodalBeam,
    numbers: &NodalGeometry<f64>,
) -> Vec<String> {
    let beam = &numbers.beam;
    let euler_n = std::f64::consts::PI.powi(2) * beam.bending_stiffness_n_m / beam.length_m;
    let fastest_rad_s = beam.largest_frequency_rad_s(&place.mesh);
    let fastest_hz = fastest_rad_s / std::f64::consts::TAU;
    let evaluations_1_s = evaluations_1_s(fastest_hz, 0.5 * fastest_rad_s * beam.retardation_s);
    let mut lines = vec![
        stiffness_words(beam.length_m, euler_n, beam.axial_stiffness_n_m),
        format!(
            "absolute nodal coordinates, {}, {} coordinates; largest frequency of the mesh {fastest_hz:.3e} Hz",
            counted_or_no(place.mesh.elements(), "element", "elements"),
            place.coordinates.len(),
        ),
        format!("starts {}", start_of(mechanism, place.body)),
    ];
    if evaluations_1_s > MANY_EVALUATIONS_1_S {
        let floating = other_formulation(&mechanism.model, place.body).floating_frame();
        let or_floating =
            floating.map_or_else(String::new, |keys| format!(", or {keys} if its sections turn by less than 0.1 rad"));
        lines.push(format!("warning: its mesh needs {evaluations_1_s:.1e} evaluations per second of motion"));
        lines.push(format!(
            "hint: use fewer elements, a smaller retardation_time, or --integrator implicit if contacts are rare{or_floating}"
        ));
    }
    lines.extend(contact_lines((mechanism, sample), place.body, beam.axial_stiffness_n_m));
    lines
}

/// How much stiffer the contacts at a flexible body are than the body.
fn contact_lines(
    (mechanism, sample): (&Mechanism, &Sample<f64>),
    body: BodyId,
    axial_stiffness_n_m: f64,
) -> Vec<String> {
    let model = &mechanism.model;
    let of_play = |(play, id): (&PlayGeometry<f64>, &PlayId)| {
        let (Some(_), PlayId::Joint(joint)) = (play.shape.hole(), id) else { return None };
        let joint = &model.joints[joint.0];
        if !joint.kind.bodies().contains(&body) {
            return None;
        }
        let step_m = 1e-3 * PENETRATION_M;
        let [below, above] = [-step_m, step_m].map(|step_m| play.normal.elastic_n(PENETRATION_M + step_m));
        let ratio = (above - below) / (2.0 * step_m) / axial_stiffness_n_m;
        let name = &joint.name;
        Some(format!("the contact in '{name}' has {ratio:.2} times its axial stiffness EA/L at a penetration of 10 µm"))
    };
    sample.plays.iter().zip(&mechanism.plays).filter_map(of_play).collect()
}

#[cfg(test)]
mod tests {
    use super::beams;
    use loosepin_mechanics::mechanism::Mechanism;
    use loosepin_mechanics::model::Model;
    use loosepin_report::article_text;
    use loosepin_text::article::Article;

    fn words(keys: &str) -> String {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/flexible_slider_crank/model.toml");
        let text = std::fs::read_to_string(path).expect("the case is there");
        let shapes = "lateral_shapes = 2\naxial_shapes = 2";
        assert!(text.contains(shapes));
        let text = text.replace(shapes, &format!("{shapes}\n{keys}"));
        let model = Model::from_text("model.toml", &text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        let values = model.quantities.nominal();
        let mechanism = Mechanism::new(&model, &values).unwrap_or_else(|error| panic!("{error}"));
        let sections = beams(&mechanism, &values, 0.04).into_iter().collect();
        article_text(&Article { title: model.name.clone(), sections }, None)
    }

    /// The lowest shape of the rod is π/2 √(EI/ρA)/L² = 203.2 Hz.
    #[test]
    fn warning_of_a_condensed_body_that_keeps_no_shape() {
        let lowest_hz = std::f64::consts::FRAC_PI_2 * (200e9_f64 / 7870.0 / 12.0).sqrt() * 0.008 / 0.09;
        let of = |above_hz: f64| words(&format!("condense_above = \"{above_hz} Hz\""));
        let warned = of(lowest_hz - 0.1);
        assert!(warned.contains("4 shapes above "), "{warned}");
        assert!(
            warned.contains(
                "warning: all its shapes are condensed: condense_above lies below the lowest of them, 203.19"
            ) && warned
                .contains("hint: use condense_above greater than 3 divided by the duration of a contact, or omit it"),
            "{warned}"
        );
        let kept = of(lowest_hz + 0.1);
        assert!(kept.contains("3 shapes above ") && !kept.contains("all its shapes"), "{kept}");
    }
}

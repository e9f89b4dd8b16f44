//! Flexible bodies in words.

use std::fmt::Write;

use loosepin::contact::NormalContact;
use loosepin::mechanism::{Mechanism, PlayShape, Sample};
use loosepin::model::{PlayId, Values};
use loosepin::units::{Dimension, format_value, listed};

use crate::console::counted;

/// Penetration at which the stiffness of a contact is compared with that of the beam, m: that of a hard impact.
const PENETRATION_M: f64 = 10e-6;

/// Shapes, frequencies, Euler load and stiffness of each flexible body; nothing where there are none.
pub fn push_beams(text: &mut String, mechanism: &Mechanism, values: &Values) {
    let beams = &mechanism.real.beams;
    let Ok(sample) = Sample::<f64>::new(mechanism, values) else { return };
    if beams.is_empty() {
        return;
    }
    let _ = writeln!(text, "\n{}", counted(beams.len(), "flexible body", "flexible bodies"));
    let model = &mechanism.model;
    let width = beams.iter().map(|place| model.bodies[place.body.0].name.chars().count()).max().unwrap_or(0);
    for (place, numbers) in beams.iter().zip(&sample.real.beams) {
        let beam = &numbers.beam;
        let _ = writeln!(
            text,
            "  {:width$}  beam of {}: Euler load {}, EA/L {}",
            model.bodies[place.body.0].name,
            format_value(beam.length_m, Dimension::LENGTH),
            format_value(beam.euler_load_n(), Dimension::FORCE),
            format_value(beam.axial_stiffness_n_m, Dimension::SPRING_STIFFNESS),
        );
        let indent = " ".repeat(width + 4);
        let [axial, lateral] = beam.frequencies_hz(&place.shapes);
        for (frequencies_hz, one, many) in
            [(lateral, "lateral shape", "lateral shapes"), (axial, "axial shape", "axial shapes")]
        {
            let in_words = |hz: &f64| format!("{} Hz", format_value(*hz, Dimension::NUMBER));
            let hz: Vec<String> = frequencies_hz.iter().map(in_words).collect();
            let at =
                if hz.is_empty() { String::new() } else { format!(" at {} with the frame held", listed(&hz, "and")) };
            let _ = writeln!(text, "{indent}{}{at}", counted(frequencies_hz.len(), one, many));
        }
        for (index, (play, id)) in sample.plays.iter().zip(&mechanism.plays).enumerate() {
            let (PlayShape::Pin { .. }, PlayId::Joint(joint)) = (&play.shape, id) else { continue };
            if !model.joints[joint.0].kind.bodies().contains(&place.body) {
                continue;
            }
            let step_m = 1e-3 * PENETRATION_M;
            let [below, above] =
                [-step_m, step_m].map(|step_m| sample.plays[index].normal.elastic_n(PENETRATION_M + step_m));
            let ratio = (above - below) / (2.0 * step_m) / beam.axial_stiffness_n_m;
            let _ = writeln!(
                text,
                "{indent}the contact in '{}' has {ratio:.2} times its axial stiffness EA/L at a penetration of 10 µm",
                model.joints[joint.0].name
            );
        }
    }
}

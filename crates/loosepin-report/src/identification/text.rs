//! The answer of an identification on a terminal: readings, plays, sums that are fixed, what to measure next; or the misfit.

use super::gain::gain_section;
use super::grounds::grounds;
use super::lengths::push_lengths;
use super::motion::{push_features, push_runs, push_unknowns};
use super::plan::plan_section;
use super::posterior::push_posterior;
use super::readings::push_readings;
use crate::medium::article_text::terminal_text;
use crate::numbers::number::NumberWriter;
use loosepin_result::identification::Identification;
use loosepin_result::motion_identification::MotionPlan;
use loosepin_text::article::{Content, Medium, Section};
use loosepin_text::units::DisplayUnits;

/// The answer as text.
pub fn identification_text(answer: &Identification) -> String {
    let writer = NumberWriter::for_terminal(&answer.display_units);
    let readings = answer.specimens.iter().enumerate().map(|(index, specimen)| {
        let mut section = named("plays", &specimen.name, "");
        push_readings(&mut section, specimen, index, &writer);
        section
    });
    let motion = answer.motion.iter().enumerate().map(|(index, specimen)| {
        let mut section = named("unknowns", &specimen.name, ", motion");
        push_unknowns(&mut section, specimen, index, &writer);
        push_features(&mut section, specimen, index, &writer);
        push_runs(&mut section, specimen, Medium::Terminal);
        push_posterior(&mut section, specimen, index, &writer);
        push_lengths(&mut section, specimen, &writer);
        section
    });
    let gain = answer.gain.iter().map(|gain| gain_section(gain, &writer));
    let mut ground = Section::new("method", "");
    let words = Content::points(grounds(answer, &writer));
    // What a motion alone rests on stands below how it was tested.
    if answer.specimens.is_empty() && answer.gain.is_none() {
        ground.push_close(words)
    } else {
        ground.push(words)
    }
    terminal_text(&answer.study, readings.chain(motion).chain(gain).chain([ground]))
}

/// A section below the name of its specimen, where it has one.
fn named(id: &'static str, name: &Option<String>, what: &str) -> Section {
    Section::new(id, name.as_ref().map_or_else(String::new, |name| format!("Specimen {name}{what}")))
}

/// Expected information in features, as text.
pub fn motion_plan_text(plan: &MotionPlan, units: &DisplayUnits) -> String {
    terminal_text(&plan.study, [plan_section(plan, &NumberWriter::for_terminal(units))])
}

#[cfg(test)]
mod tests {
    use super::motion_plan_text;
    use loosepin_result::motion_identification::{
        IndistinguishableMembers, MotionPlan, PlannedFeature, PlannedUnknown,
    };
    use loosepin_text::units::DisplayUnits;

    #[test]
    fn a_plan_names_laws_and_says_how_many_measurements_are_missing() {
        let feature = PlannedFeature { name: "peak".to_owned(), share_of_box: 0.5, shares_of_width: vec![0.5] };
        let plan = MotionPlan {
            study: "laws".to_owned(),
            unknowns: vec![PlannedUnknown {
                path: "contact.pin.normal".to_owned(),
                name: "pin normal".to_owned(),
                is_list: true,
            }],
            features: vec![feature.clone()],
            together: feature,
            not_distinguishable: vec![IndistinguishableMembers {
                unknown: 0,
                members: ["flores".to_owned(), "hunt-crossley".to_owned()],
                told: 0.25,
            }],
            points: 2,
            imagined: 8,
            failed: 3,
            runs_per_point: 199,
        };
        let text = motion_plan_text(&plan, &DisplayUnits::default());
        let flat = text.split_whitespace().collect::<Vec<&str>>().join(" ");
        assert!(flat.contains("if pin normal is flores, hunt-crossley is rejected in 25"), "{text}");
        assert!(flat.contains("3 of 8 simulated measurements have no values"), "{text}");
    }
}

//! Reasons why the numbers of two studies are less comparable.

use super::sides::for_both;
use crate::numbers::number::NumberWriter;
use crate::words::force::JointForces;
use loosepin_result::study::{JointImpacts, StudyResult};
use loosepin_text::units::SiUnit;

/// The warnings, in sentences.
pub fn warnings(pair: [&StudyResult; 2], writer: &NumberWriter) -> Vec<String> {
    let [before, after] = pair;
    let mut found = Vec::new();
    let mut differ = |what: &str, values: [String; 2]| {
        if values[0] != values[1] {
            found.push(format!("{what}: {}.", for_both(values)));
        }
    };
    differ("Other model", pair.map(|result| format!("'{}'", result.model)));
    let cycles = pair.map(|result| &result.cycle);
    differ("Other cycle, drive", cycles.map(|cycle| cycle.drive.clone()));
    let speed = |speed: Option<f64>| match speed {
        Some(speed) => writer.value_shortest(speed, &SiUnit::ANGULAR_VELOCITY),
        None => "not constant".to_owned(),
    };
    differ("Other cycle, speed", cycles.map(|cycle| speed(cycle.drive_speed_rad_s)));
    let turns = |turns: f64| writer.shortest(turns, &SiUnit::NONE);
    differ("Other cycle, turns of start-up", cycles.map(|cycle| turns(cycle.transient_turns)));
    differ("Other cycle, recorded turns", cycles.map(|cycle| turns(cycle.recorded_turns)));
    let tolerance = |tolerance_m: f64| writer.value_shortest(tolerance_m, &SiUnit::LENGTH);
    for (joint, laws) in laws_of_both(pair, writer) {
        differ(&format!("Other contact law in {joint}"), laws);
    }
    differ("Other tolerance of the integration", cycles.map(|cycle| tolerance(cycle.tolerance_m)));
    differ("Other integration method", cycles.map(|cycle| cycle.method.clone()));
    let sampling = |result: &StudyResult| format!("{} × {} runs", result.counts.outer, result.counts.inner);
    differ("Other sampling", pair.map(sampling));
    differ("Other seed", pair.map(|result| result.seed.to_string()));
    differ("Other version of the program", pair.map(|result| result.version.clone()));
    if before.input_hash == after.input_hash {
        found.insert(0, "Both studies have the same inputs.".to_owned());
    }
    found
}

/// The laws of every joint with play that both have, in words.
fn laws_of_both(pair: [&StudyResult; 2], writer: &NumberWriter) -> Vec<(String, [String; 2])> {
    let words = |joint: &JointImpacts| JointForces::study(joint).laws(writer).join(", ");
    let of_both = pair[0].impacts.iter().filter_map(|joint| {
        let other = pair[1].impacts.iter().find(|other| other.joint == joint.joint)?;
        let laws = [words(joint), words(other)];
        // Records of older versions do not name them.
        laws.iter().all(|laws| !laws.is_empty()).then(|| (joint.joint.clone(), laws))
    });
    of_both.collect()
}

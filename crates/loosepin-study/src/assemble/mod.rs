//! From the runs and bounds of a study to its result: names, units, curves, boxes, pictures. What a question adds is written in `question`.
//! Nothing here makes a run.

mod accuracy;
mod bounds;
mod boxes;
mod coherent;
mod curves;
pub(crate) mod describe;
mod drawing;
#[cfg(test)]
mod few_runs;
mod material;
mod motion;
mod paths;
mod requirements;
mod summary;
mod treatments;
mod value_bands;
mod witness_commands;

pub(super) use bounds::asked_bounds;
pub(super) use drawing::pictures;
pub(super) use material::Material;
pub(super) use requirements::requirements;
pub(super) use summary::SETTLED;
pub(super) use treatments::{learned_treatments, treatments_by_surrogates_alone};
pub(super) use witness_commands::witness_commands;

use super::question::Found;
use crate::runs::failures::failures;
use crate::written::inputs::repeat;
use drawing::Pictures;
use loosepin_result::study::{FORMAT, StudyResult};
use loosepin_text::units::DisplayUnits;

/// The result as far as bounds and pictures go; questions write the rest.
pub(super) fn assemble(found: &Found, material: &Material<'_>, input_hash: &str, pictures: Pictures) -> StudyResult {
    let study = material.study;
    let motion = motion::motion(study);
    StudyResult {
        format: FORMAT,
        name: study.name.clone(),
        model: study.model.name().to_owned(),
        leans: study.model.leans_beside_runs(),
        version: loosepin_text::VERSION.to_owned(),
        input_hash: input_hash.to_owned(),
        seed: study.seed,
        inputs: describe::shown_inputs(study),
        correlations: describe::correlations(study),
        cycle: describe::cycle(material),
        outputs: describe::outputs(material),
        counts: summary::counts(material),
        gaps: summary::gaps(material),
        accuracy: accuracy::accuracy(material, &found.ended),
        failures: failures(material.study, material.response, material.table),
        settled_share: summary::settled_share(material),
        further_turns: None,
        requirements: requirements(material),
        allowances: Vec::new(),
        together: None,
        allocation: None,
        bounds: bounds::all_bounds(material, &found.curve_bands, &found.other_readings),
        cuts: bounds::cuts(material),
        percentiles: bounds::percentiles(material),
        rare: Vec::new(),
        promise: None,
        surrogate: None,
        contributors: Vec::new(),
        answers: Vec::new(),
        treatments: treatments::treatments(material),
        energy: summary::energy(material),
        impacts: summary::impacts(material),
        repeat: repeat(material.study),
        witness_commands: Vec::new(),
        display_units: material.study.model.shown_in(DisplayUnits::default()),
        curves: curves::curves(material, &pictures, &found.curve_bands),
        boxes: boxes::boxes(material),
        nominal_trust: pictures.nominal_trust,
        orbits: pictures.orbits,
        paths: paths::paths(study, motion.as_ref()),
        motion,
        drawing: pictures.drawing,
    }
}

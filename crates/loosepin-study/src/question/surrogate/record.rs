//! Quality of surrogates, and the bounds that they give.

use super::saved::{SavedInput, SavedOutput, SavedSurrogates};
use crate::assemble::{Material, asked_bounds, learned_treatments};
use loosepin_bounds::{GroupBounds, SurrogateBounds, SurrogateInput, SurrogatePlan};
use loosepin_result::study::{
    ResponsePoint, SurrogateAlong, SurrogateLearning, SurrogateOutput, SurrogatePicture, SurrogateRecord,
};
use loosepin_surrogate::{OutputSurrogate, Surrogate, SurrogateVerdict};
use loosepin_text::units::SiUnit;

/// The surrogates, with their bounds if they stand beside direct ones.
pub fn surrogate_record(material: &Material<'_>, plan: &SurrogatePlan, found: &SurrogateBounds) -> SurrogateRecord {
    let is_alone = material.study.surrogate.is_some_and(|surrogate| surrogate.is_alone);
    let pairs = found.to_bounds(plan, 0).pairs;
    let of_surrogate = material.with_pairs(&pairs);
    SurrogateRecord {
        training_runs: found.training_runs as u64,
        confirming_runs: found.confirming_runs as u64,
        runs_at_bounds: found.runs_at_bounds as u64,
        failed: found.failed_runs as u64,
        direct_runs: if is_alone { 0 } else { material.bounds.runs as u64 },
        outputs: found.groups.iter().map(|group| output(material, plan, group)).collect(),
        bounds: if is_alone { Vec::new() } else { asked_bounds(&of_surrogate) },
        treatments: if is_alone { Vec::new() } else { learned_treatments(material, plan, found) },
    }
}

fn output(material: &Material<'_>, plan: &SurrogatePlan, group: &GroupBounds) -> SurrogateOutput {
    let columns = &group.learned.group.columns;
    let column = columns[0];
    let is_curve = columns.len() > 1;
    let mut record = SurrogateOutput {
        output: material.name_of(column),
        of: material.response.plan().columns[column].deviation,
        at: if is_curve { ResponsePoint::Whole } else { material.point_of(column, false) },
        unit: material.unit_of(column),
        problem: None,
        kinds: Vec::new(),
        runs: 0,
        missing: group.learned.failed as u64,
        failed: group.failed as u64,
        share_outside: group.share_outside,
        held_out_si: f64::NAN,
        q2: None,
        verdict: None,
        learning: Vec::new(),
        reach: group.reach,
        largest_ratio: group.largest_ratio,
        along: None,
        picture: None,
    };
    let surrogates = match &group.learned.surrogates {
        Ok(surrogates) => surrogates,
        Err(error) => {
            record.problem = Some(error.to_string());
            return record;
        }
    };
    let outputs: Vec<&OutputSurrogate> =
        surrogates.iter().filter_map(|surrogate| surrogate.outputs().first()).collect();
    let worst =
        |most: usize, next: usize| if outputs[next].quality.rms > outputs[most].quality.rms { next } else { most };
    let combination = (0..outputs.len()).fold(0, worst);
    let Some(learned) = outputs.get(combination) else { return record };
    record.kinds = learned.kinds().into_iter().map(|kind| kind.name().to_owned()).collect();
    record.runs = learned.quality.runs as u64;
    record.held_out_si = learned.quality.rms;
    record.q2 = learned.quality.q2;
    // What does not fall and yet is too small to be drawn from makes no difference.
    let is_small = learned.residual.verdict.keeps_residual() && !group.learned.keeps_residual();
    record.verdict = Some(if is_small { SurrogateVerdict::Resolved } else { learned.residual.verdict });
    let learning = learned.residual.learning.iter();
    record.learning =
        learning.map(|&(runs, held_out_si)| SurrogateLearning { runs: runs as u64, held_out_si }).collect();
    let pose = |column: usize| material.response.plan().columns[column].spot.pose().map(|pose| pose.angle_rad);
    record.along = is_curve.then(|| SurrogateAlong {
        pose_rad: columns.iter().map(|&column| pose(column).unwrap_or(f64::NAN)).collect(),
        held_out_si: learned.quality.rms_along.clone(),
    });
    record.picture = plan.section(group, combination, material.table).map(|section| {
        let (path, input_unit) = input_names(material, section.input);
        SurrogatePicture {
            path,
            input_unit,
            pose_rad: if is_curve { pose(columns[section.place]) } else { None },
            run_input_si: section.runs.iter().map(|run| run[0]).collect(),
            run_output_si: section.runs.iter().map(|run| run[1]).collect(),
            input_si: section.line.iter().map(|point| point[0]).collect(),
            output_si: section.line.iter().map(|point| point[1]).collect(),
            half_width_si: section.line.iter().map(|point| point[2]).collect(),
        }
    });
    record
}

/// All surrogates in the form of their file.
pub fn saved_surrogates(
    material: &Material<'_>,
    input_hash: &str,
    plan: &SurrogatePlan,
    found: &SurrogateBounds,
) -> SavedSurrogates {
    let inputs = plan.inputs().iter().map(|&input| {
        let (path, unit) = input_names(material, input);
        SavedInput { path, unit }
    });
    let of_group = |group: &GroupBounds| {
        let columns = &group.learned.group.columns;
        let surrogates = group.learned.surrogates.iter().flatten().enumerate();
        let saved = |(combination, surrogate): (usize, &Surrogate)| {
            let mut epistemic: Vec<f64> =
                material.study.epistemic.iter().map(|input| input.variable.middle()).collect();
            let members = plan.members(combination);
            members.iter().for_each(|&(index, value)| epistemic[index] = value);
            let lists: Vec<&str> = members.iter().map(|&(i, _)| material.study.epistemic[i].path.as_str()).collect();
            let named = material.witness(&epistemic).into_iter();
            SavedOutput {
                output: material.name_of(columns[0]),
                of: material.response.plan().columns[columns[0]].deviation,
                at: columns.iter().map(|&column| material.point_of(column, columns.len() > 1)).collect(),
                unit: material.unit_of(columns[0]),
                members: named.filter(|(path, _)| lists.contains(&path.as_str())).collect(),
                surrogate: surrogate.clone(),
            }
        };
        surrogates.map(saved).collect::<Vec<_>>()
    };
    let outputs = found.groups.iter().flat_map(of_group).collect();
    SavedSurrogates::new(&material.study.name, input_hash, inputs.collect(), outputs)
}

/// Path and unit of an input.
fn input_names(material: &Material<'_>, input: SurrogateInput) -> (String, SiUnit) {
    match input {
        SurrogateInput::Random(index) => {
            let input = &material.study.random[index];
            (input.path.clone(), input.unit(&material.study.model))
        }
        SurrogateInput::Epistemic(index) => {
            let input = &material.study.epistemic[index];
            (input.path.clone(), input.unit(&material.study.model))
        }
    }
}

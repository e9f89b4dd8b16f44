//! From the runs and answers of a study to its result: names, units, curves, boxes, pictures.

mod accuracy;
mod bounds;
mod boxes;
mod coherent;
mod contributors;
mod curves;
mod describe;
mod drawing;
#[cfg(test)]
mod few_runs;
pub(super) mod material;
mod promise;
mod rare;
mod requirements;
mod summary;
mod surrogate;
mod treatments;
mod value_bands;
mod witness_commands;

pub(super) use bounds::asked_bounds;
pub(super) use drawing::pictures;
pub(super) use material::Material;
pub(super) use requirements::requirements;
pub(super) use summary::SETTLED;
pub(super) use surrogate::saved_surrogates;

use super::contributors::ContributorPlan;
use super::failures::failures;
use super::goals::Ended;
use super::inputs::repeat;
use super::learned::LearnedBounds;
use super::promise::Promised;
use super::simultaneous::CurveBand;
use loosepin_bounds::{Bounds, DoubleLoop};
use loosepin_result::study::{
    AllocationRecord, AllowanceRecord, Contributors, FORMAT, FurtherTurns, StudyResult, SurrogateRecord, TogetherRecord,
};
use loosepin_text::units::DisplayUnits;

/// Answers of a study beside its bounds.
pub(super) struct Answers {
    /// The direct double loop with the samples that it came to have; nothing where the surrogate stands alone.
    pub plan: Option<DoubleLoop>,
    /// How the steps towards the goals ended.
    pub ended: Ended,
    /// The runs of the contributors, where they were asked for.
    pub contributors: Option<ContributorPlan>,
    pub learned: Option<LearnedBounds>,
    /// What is promised for a share of the box.
    pub promise: Option<Promised>,
    pub allowances: Vec<AllowanceRecord>,
    pub together: Option<TogetherRecord>,
    pub allocation: Option<AllocationRecord>,
    pub curve_bands: Vec<CurveBand>,
    /// What turns after the recorded ones change.
    pub further_turns: Option<FurtherTurns>,
    /// Bounds by the other readings of intervals.
    pub beside: Vec<Bounds>,
    /// What is drawn from runs with nominal dimensions.
    pub pictures: drawing::Pictures,
}

/// Puts the result together.
pub(super) fn assemble(material: &Material<'_>, input_hash: &str, answers: Answers) -> StudyResult {
    let Answers {
        plan,
        ended,
        contributors,
        learned,
        promise,
        allowances,
        together,
        allocation,
        curve_bands,
        further_turns,
        beside,
        pictures,
    } = answers;
    let study = material.study;
    let contributors = plan.as_ref().map_or_else(Vec::new, |plan| -> Vec<Contributors> {
        contributors::contributors(material, plan, contributors.as_ref())
    });
    let surrogate: Option<SurrogateRecord> =
        learned.as_ref().map(|learned| surrogate::surrogate_record(material, &learned.plan, &learned.bounds));
    let treatments = match &learned {
        Some(learned) if plan.is_none() => treatments::learned_treatments(material, &learned.plan, &learned.bounds),
        _ => treatments::treatments(material),
    };
    let mut requirements = requirements(material);
    let promise = promise.map(|promised| {
        promise::decide(material, &promised.ends, &mut requirements);
        promise::promise_record(material, &promised)
    });
    let mut result = StudyResult {
        format: FORMAT,
        name: study.name.clone(),
        model: study.model.name.clone(),
        version: loosepin_text::VERSION.to_owned(),
        input_hash: input_hash.to_owned(),
        seed: study.seed,
        inputs: describe::inputs(study),
        correlations: describe::correlations(study),
        cycle: describe::cycle(material),
        outputs: describe::outputs(material),
        counts: summary::counts(material),
        accuracy: accuracy::accuracy(material, &ended),
        failures: failures(material.study, material.response, material.table),
        settled_share: summary::settled_share(material),
        further_turns,
        requirements,
        allowances,
        together,
        allocation,
        bounds: bounds::all_bounds(material, &curve_bands, &beside),
        cuts: bounds::cuts(material),
        percentiles: bounds::percentiles(material),
        rare: rare::rare_records(material),
        promise,
        surrogate,
        contributors,
        treatments,
        energy: summary::energy(material),
        impacts: summary::impacts(material),
        repeat: repeat(material.study),
        witness_commands: Vec::new(),
        display_units: material.study.model.shown_in(DisplayUnits::default()),
        curves: curves::curves(material, &pictures, &curve_bands),
        boxes: boxes::boxes(material),
        nominal_trust: pictures.nominal_trust,
        orbits: pictures.orbits,
        drawing: pictures.drawing,
    };
    result.witness_commands = witness_commands::witness_commands(study, &result);
    result
}

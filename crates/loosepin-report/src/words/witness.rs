//! Which bounds of a study its witnesses attain, in words.

use crate::numbers::number::NumberWriter;
use crate::words::wording::{deviation_of, output_unit, place_words, response_words, statistic_words};
use loosepin_result::study::{BoundRecord, StudyResult, Witness};

/// Bounds that are named at a witness, at most.
const MAX_NAMED: usize = 3;

/// The mechanism of a witness.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WitnessWords {
    /// The unknown values, each with its unit: `gudgeon radial clearance 0.5 mm`.
    pub values: Vec<String>,
    /// The requirements and bounds that are attained there, the most important first.
    pub attains: Vec<String>,
    /// The command that runs it.
    pub command: String,
}

/// The witnesses whose mechanisms can be run, in the order of [`StudyResult::witness_commands`].
pub fn witness_words(result: &StudyResult) -> Vec<WitnessWords> {
    let writer = NumberWriter::for_page(&result.display_units);
    let told = |run: &loosepin_result::study::WitnessCommand| WitnessWords {
        values: values(result, &run.witness, &writer),
        attains: attained(result, &run.witness, &writer),
        command: run.command.clone(),
    };
    result.witness_commands.iter().map(told).collect()
}

/// Each value by itself, in the order of the study.
fn values(result: &StudyResult, witness: &Witness, writer: &NumberWriter) -> Vec<String> {
    let alone = |path: &String| {
        let value = witness.get(path)?;
        Some(writer.witness(&Witness::from([(path.clone(), value.clone())]), &result.inputs))
    };
    let known = result.inputs.iter().filter_map(|input| alone(&input.path));
    let is_other = |path: &&String| result.inputs.iter().all(|input| input.path != **path);
    known.chain(witness.keys().filter(is_other).filter_map(alone)).collect()
}

fn attained(result: &StudyResult, witness: &Witness, writer: &NumberWriter) -> Vec<String> {
    let of_requirements = result.requirements.iter().filter(|requirement| requirement.witness == *witness).map(|own| {
        let subject = deviation_of(&own.output, own.of, &result.outputs);
        format!("fewest mechanisms stay within the limit: {subject} {}", place_words(own.at, writer))
    });
    let bounds = || result.bounds.iter().filter(|bound| bound.treatment.is_mixed() && bound.at.pose_rad().is_none());
    let told = |end: &str, bound: &BoundRecord| {
        let response = response_words(result, (&bound.output, bound.of, bound.at), writer);
        let statistic = statistic_words(bound.statistic, &output_unit(result, &bound.output), writer);
        format!("{end} {statistic}: {response}")
    };
    let upper = bounds().filter(|bound| bound.upper.witness == *witness).map(|bound| told("largest", bound));
    let lower = bounds().filter(|bound| bound.lower.witness == *witness).map(|bound| told("smallest", bound));
    let mut all: Vec<String> = of_requirements.chain(upper).chain(lower).collect();
    let more = all.len().saturating_sub(MAX_NAMED);
    all.truncate(MAX_NAMED);
    if more > 0 {
        all.push(format!("{more} more"));
    }
    all
}

//! Two studies beside each other, A and B: verdicts, bands in one picture, statistics with their differences, and what differs in
//! their inputs.
//!
//! Only what means the same is compared. An output that is another point, a bound that reads intervals in another way and a band over
//! another drive are named and left out; what makes numbers less comparable, such as another cycle or another seed, is a warning.

mod band;
mod changed_inputs;
mod headline;
mod outputs;
mod requirements;
mod sides;
mod statistics;
mod warnings;

use serde::Serialize;

use crate::numbers::number::NumberWriter;
use crate::study::short_answer::study_sentences;
use loosepin_result::study::{StudyResult, Verdict};

pub use band::ComparedBand;
pub use changed_inputs::{ChangedInput, InputPlace};
pub(crate) use headline::NOTHING_IN_COMMON;
pub use requirements::ComparedRequirement;
pub use statistics::{ComparedEnd, ComparedStatistic, Weight};

/// Two studies beside each other.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Comparison {
    /// How much smaller or larger the main answer is in B.
    pub headline: String,
    /// The studies, A first.
    pub sides: [ComparedSide; 2],
    /// Reasons why the numbers are less comparable.
    pub warnings: Vec<String>,
    /// Parts that are not compared, with the reasons.
    pub left_out: Vec<String>,
    /// Requirements with both verdicts.
    pub requirements: Vec<ComparedRequirement>,
    /// Both bands of an output in one picture.
    pub bands: Vec<ComparedBand>,
    /// Bounds of single statistics with their differences.
    pub statistics: Vec<ComparedStatistic>,
    /// Differences of the inputs, uncertain ones first.
    pub inputs: Vec<ChangedInput>,
}

/// One of the two studies.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ComparedSide {
    /// Name of the study.
    pub name: String,
    /// Name of the model.
    pub model: String,
    /// Over all requirements.
    pub verdict: Option<Verdict>,
    /// The answer in sentences.
    pub words: Vec<String>,
}

/// Compares two studies; numbers are in the units of the first one.
pub fn compare_studies(before: &StudyResult, after: &StudyResult) -> Comparison {
    let writer = NumberWriter::for_page(&before.display_units);
    let pair = [before, after];
    let outputs = outputs::shared(pair);
    let (statistics, mut left_out) = statistics::compared(pair, &outputs, &writer);
    let (bands, of_bands) = band::compared(pair, &outputs, &writer);
    left_out.splice(0..0, outputs.left_out.iter().cloned().chain(of_bands));
    let (inputs, of_inputs) = changed_inputs::changed(pair);
    left_out.extend(of_inputs);
    let requirements = requirements::compared(pair, &writer);
    Comparison {
        headline: headline::headline(pair, &outputs, &requirements, &writer),
        sides: pair.map(|result| ComparedSide {
            name: result.name.clone(),
            model: result.model.clone(),
            verdict: result.verdict(),
            words: study_sentences(result),
        }),
        warnings: warnings::warnings(pair, &writer),
        left_out,
        requirements,
        bands,
        statistics,
        inputs,
    }
}

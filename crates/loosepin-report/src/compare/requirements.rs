//! Requirements of two studies with both verdicts.

use serde::Serialize;

use crate::numbers::number::{NumberWriter, Rounding};
use crate::words::limits::requirement_words;
use crate::words::wording::{deviation_of, output_unit, place_words};
use loosepin_result::study::{RequirementOutcome, StudyResult, Verdict};

/// A requirement on one number, as each study has it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ComparedRequirement {
    /// On what: `deviation of slider over the whole cycle`.
    pub what: String,
    /// The limits and the required share in A and in B, in words; `None` if the study does not require it.
    pub required: [Option<String>; 2],
    /// Bounds of the share that keeps the limits.
    pub kept: [Option<String>; 2],
    /// The verdicts.
    pub verdicts: [Option<Verdict>; 2],
}

/// Requirements in the order of A, those of B alone at the end.
pub fn compared(pair: [&StudyResult; 2], writer: &NumberWriter) -> Vec<ComparedRequirement> {
    let [before, after] = pair;
    let is_on_same =
        |a: &RequirementOutcome, b: &RequirementOutcome| a.output == b.output && a.of == b.of && a.at == b.at;
    let mut left: Vec<&RequirementOutcome> = after.requirements.iter().collect();
    let mut rows = Vec::new();
    for own in &before.requirements {
        // One with the same limits, else the first on the same number.
        let same = left.iter().position(|other| is_on_same(own, other) && limits(own) == limits(other));
        let place = same.or_else(|| left.iter().position(|other| is_on_same(own, other)));
        let other = place.map(|place| left.remove(place));
        rows.push(row(pair, [Some(own), other], writer));
    }
    rows.extend(left.into_iter().map(|other| row(pair, [None, Some(other)], writer)));
    rows
}

fn limits(requirement: &RequirementOutcome) -> [f64; 3] {
    [requirement.lower_si, requirement.upper_si, requirement.probability_at_least]
}

fn row(
    results: [&StudyResult; 2],
    both: [Option<&RequirementOutcome>; 2],
    writer: &NumberWriter,
) -> ComparedRequirement {
    let side = |which: usize| both[which].map(|requirement| (results[which], requirement));
    let what = side(0).or(side(1)).map_or(String::new(), |(result, requirement)| {
        let subject = deviation_of(&requirement.output, requirement.of, &result.outputs);
        format!("{subject} {}", place_words(requirement.at, writer))
    });
    let required = |(result, requirement): (&StudyResult, &RequirementOutcome)| {
        let unit = output_unit(result, &requirement.output);
        let share = writer.percent(requirement.probability_at_least, Rounding::Nearest);
        format!("{} in at least {share}", requirement_words(result, requirement, &unit, writer))
    };
    let kept = |(_, requirement): (&StudyResult, &RequirementOutcome)| {
        writer.percent_range(requirement.probability[0], requirement.probability[1])
    };
    ComparedRequirement {
        what,
        required: [0, 1].map(|which| side(which).map(required)),
        kept: [0, 1].map(|which| side(which).map(kept)),
        verdicts: both.map(|requirement| requirement.map(|requirement| requirement.verdict)),
    }
}

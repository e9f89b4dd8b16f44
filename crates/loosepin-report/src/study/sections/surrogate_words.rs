//! Quality of surrogates in sentences.

use crate::numbers::number::{NumberWriter, Rounding};
use crate::words::history::history_words;
use crate::words::wording::{count, counted, deviation_words, listed, output_words, place_words};
use loosepin_result::study::{
    BoundRecord, ResponsePoint, StudyResult, SurrogateLearning, SurrogateOutput, SurrogateRecord, SurrogateVerdict,
};
use loosepin_text::units::distinct;

/// Title of the section.
pub(super) fn title(record: &SurrogateRecord) -> &'static str {
    if record.is_alone() { "The surrogate" } else { "Bounds by surrogate" }
}

/// How many runs the surrogates needed, beside the direct bounds.
pub(super) fn runs_sentence(record: &SurrogateRecord, writer: &NumberWriter) -> String {
    let runs = |runs: u64| counted(runs, "run", writer);
    let checked = match (record.confirming_runs, record.runs_at_bounds > 0) {
        (0, _) => "not checked by other runs".to_owned(),
        (more, true) => format!("checked by {} at the values that attain the bounds", runs(more)),
        (more, false) => format!("checked by {} at extreme values, none of them at a bound", runs(more)),
    };
    let failed = if record.failed > 0 {
        format!(" {} of these runs failed.", count(record.failed, writer))
    } else {
        String::new()
    };
    let direct = match record.direct_runs {
        0 => "There are no direct bounds to compare with.".to_owned(),
        direct => format!("The direct bounds took {}.", runs(direct)),
    };
    format!("Trained on {}, {checked}.{failed} {direct}", runs(record.training_runs))
}

/// One sentence or more for each output: kind of surrogate, error, and the effect of more runs.
pub(super) fn output_sentences(result: &StudyResult, record: &SurrogateRecord, writer: &NumberWriter) -> Vec<String> {
    // Where the surrogate is alone its bounds are those of the study.
    let bounds = if record.is_alone() { &result.bounds } else { &record.bounds };
    let is_asked = |output: &&SurrogateOutput| {
        let own = |bound: &BoundRecord| bound.output == output.output && bound.of == output.of && bound.at == output.at;
        output.at == ResponsePoint::Whole || bounds.iter().any(own)
    };
    // A failure to learn is always said.
    let shown = record.outputs.iter().filter(|output| output.problem.is_some() || is_asked(output));
    shown.map(|output| output_sentence(result, (output, &record.outputs), writer)).collect()
}

fn output_sentence(
    result: &StudyResult,
    (output, all): (&SurrogateOutput, &[SurrogateOutput]),
    writer: &NumberWriter,
) -> String {
    let subject = format!(
        "{}, {}, {}",
        output_words(&output.output, &result.outputs),
        deviation_words(output.of),
        if output.at == ResponsePoint::Whole { "over the cycle".to_owned() } else { place_words(output.at, writer) }
    );
    if let Some(problem) = &output.problem {
        let problem = problem.split("\nhint:").next().unwrap_or_default();
        return format!("{subject}: no surrogate. {problem}.");
    }
    let q2 = output.q2.map_or(String::new(), |q2| {
        format!(", {} of the variance explained", writer.percent(q2.max(0.0), Rounding::Down))
    });
    let size = |si: f64| writer.rounded(si, &output.unit, 2, Rounding::Up);
    let mut sentence = format!(
        "{subject}: {} from {}; held-out error {}{q2}. {}",
        kinds(output),
        counted(output.runs, "run", writer),
        size(output.held_out_si),
        verdict_words(output, &size, writer)
    );
    if let Some(words) = history_words(output, all, writer) {
        sentence.push_str(&format!(" {words}"));
    }
    if output.failed > 0 {
        sentence.push_str(&format!(
            " {} failed. The surrogate does not learn failures, so probabilities and quantiles have no bounds.",
            counted(output.failed, "run", writer)
        ));
    }
    if output.share_outside > 0.0 {
        sentence.push_str(&format!(
            " At a bound, {} of the mechanisms lie outside the training range and count as failed: increase 'training_runs'.",
            writer.percent(output.share_outside, Rounding::Up)
        ));
    }
    if output.largest_ratio > 0.0 {
        sentence
            .push_str(&format!(" Check runs differ by {:.1}σ; {:.1}σ is allowed.", output.largest_ratio, output.reach));
    }
    sentence
}

/// "polynomial chaos", or "4 modes by polynomial chaos and Kriging".
fn kinds(output: &SurrogateOutput) -> String {
    let different: Vec<String> = distinct(output.kinds.iter().cloned());
    match (output.at, output.kinds.len()) {
        (ResponsePoint::Whole, 0) => "the mean curve".to_owned(),
        (ResponsePoint::Whole, 1) => format!("1 mode by {}", listed(&different)),
        (ResponsePoint::Whole, modes) => format!("{modes} modes by {}", listed(&different)),
        _ => listed(&different),
    }
}

fn verdict_words(output: &SurrogateOutput, size: &dyn Fn(f64) -> String, writer: &NumberWriter) -> String {
    let learned: Vec<String> = output
        .learning
        .iter()
        .map(|step| format!("{} from {}", size(step.held_out_si), count(step.runs, writer)))
        .collect();
    let learned = if learned.is_empty() { String::new() } else { format!(" ({})", listed(&learned)) };
    match output.verdict {
        Some(SurrogateVerdict::Constant) => "All runs gave the same value.".to_owned(),
        Some(SurrogateVerdict::Resolved) => "The remaining error is negligible.".to_owned(),
        Some(SurrogateVerdict::Falling) => format!("The error falls with more runs{learned}."),
        Some(SurrogateVerdict::Floor) if still_falls(&output.learning) => format!(
            "The error falls more and more slowly with more runs{learned}. The rest is treated as scatter of the response."
        ),
        Some(SurrogateVerdict::Floor) => format!(
            "The error does not fall with more runs{learned}. It is a property of the response and is treated as its scatter."
        ),
        Some(SurrogateVerdict::Nothing) => {
            format!("Nothing was learned{learned}: the response is noise. The bounds use the runs themselves.")
        }
        Some(SurrogateVerdict::Jump) => format!(
            "Most errors are small and a few are large{learned}: the response jumps, and the surrogate is wrong near the jump. Use \
             direct bounds (direct = \"double-loop\")."
        ),
        Some(SurrogateVerdict::Unknown) | None => {
            "There are too few runs to see the effect of more. The rest is treated as scatter.".to_owned()
        }
    }
}

/// Whether the last doubling of the runs made the error visibly smaller.
fn still_falls(learning: &[SurrogateLearning]) -> bool {
    const VISIBLY: f64 = 0.9;
    matches!(learning, [.., half, all] if all.held_out_si < VISIBLY * half.held_out_si)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_that_falls_less_and_less_is_not_said_to_stand_still() {
        let learning = |errors: [f64; 3]| {
            [15, 30, 60].into_iter().zip(errors).map(|(runs, held_out_si)| SurrogateLearning { runs, held_out_si })
        };
        let falls = |errors| still_falls(&learning(errors).collect::<Vec<_>>());
        assert!(falls([0.34e-3, 0.18e-3, 0.12e-3]));
        assert!(!falls([0.34e-3, 0.18e-3, 0.17e-3]));
        assert!(!falls([0.34e-3, 0.18e-3, 0.20e-3]));
        assert!(!still_falls(&[]));
    }
}

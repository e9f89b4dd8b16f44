//! Words on a history that no surrogate can learn, and on the statistics of the cycle that it does learn.

use crate::numbers::number::{NumberWriter, Rounding};
use crate::words::wording::{listed, place_words};
use loosepin_result::study::{ResponsePoint, SurrogateOutput, SurrogateVerdict};

/// Where less of the variance of a history is explained and the rest does not fall with more runs, its statistics are those of the
/// rest: what is left scatters by a third of the whole, and only direct runs tell how.
const LEARNED_SHARE: f64 = 0.9;
/// Doublings of the runs within which an error that falls must leave that little: more than 32 times the runs are a direct study.
const MAX_DOUBLINGS: f64 = 5.0;

/// The sentences of such a history, a value at a pose or a curve, with what stands beside it; of anything else only that it is noise, where
/// it is.
pub(crate) fn history_words(
    output: &SurrogateOutput,
    all: &[SurrogateOutput],
    writer: &NumberWriter,
) -> Option<String> {
    let is_history = matches!(output.at, ResponsePoint::Whole | ResponsePoint::Pose { .. });
    let is_lost = match output.verdict? {
        SurrogateVerdict::Nothing => true,
        SurrogateVerdict::Floor | SurrogateVerdict::Jump => output.q2? < LEARNED_SHARE,
        SurrogateVerdict::Falling => falls_too_slowly(output),
        _ => false,
    };
    if !is_history || !is_lost {
        let is_noise = output.verdict? == SurrogateVerdict::Nothing;
        return is_noise.then(|| "Use direct bounds here.".to_owned());
    }
    let is_statistic = |other: &&SurrogateOutput| {
        let is_same = other.output == output.output && other.of == output.of;
        let is_learned = other.q2.is_none_or(|q2| q2 >= LEARNED_SHARE) && other.problem.is_none();
        is_same && is_learned && matches!(other.at, ResponsePoint::Reduced { .. })
    };
    let words = |other: &SurrogateOutput| {
        let explained = other.q2.map_or("constant".to_owned(), |q2| {
            format!("{} of the variance explained", writer.percent(q2.max(0.0), Rounding::Down))
        });
        format!("{} ({explained})", place_words(other.at, writer))
    };
    let learned: Vec<String> = all.iter().filter(is_statistic).map(words).collect();
    let what_instead = if learned.is_empty() {
        "Ask for a statistic of the cycle (reduce = \"rms\" or \"mean\"), or use direct bounds.".to_owned()
    } else {
        format!("It is used for statistics of the cycle: {}.", listed(&learned))
    };
    Some(format!("The surrogate is of no use for this history. {what_instead}"))
}

/// Whether an error that continues to fall as it did from half to all of the runs stays too large.
fn falls_too_slowly(output: &SurrogateOutput) -> bool {
    let (Some(q2), [.., half, all]) = (output.q2, &output.learning[..]) else { return false };
    let each = (all.held_out_si / half.held_out_si) * (all.held_out_si / half.held_out_si);
    let left = (1.0 - q2) * libm::pow(each, MAX_DOUBLINGS);
    left > 1.0 - LEARNED_SHARE
}

#[cfg(test)]
mod tests {
    use super::*;
    use loosepin_result::study::Reduction;
    use loosepin_result::study::{Deviation, SurrogateLearning};
    use loosepin_text::units::{DisplayUnits, SiUnit};

    fn output(at: ResponsePoint, q2: f64, verdict: SurrogateVerdict) -> SurrogateOutput {
        SurrogateOutput {
            output: "slider".into(),
            of: Deviation::Total,
            at,
            unit: SiUnit::LENGTH,
            problem: None,
            kinds: vec!["Kriging".into()],
            runs: 80,
            missing: 0,
            failed: 0,
            share_outside: 0.0,
            held_out_si: 2.3e-5,
            q2: Some(q2),
            verdict: Some(verdict),
            learning: Vec::new(),
            reach: 3.0,
            largest_ratio: 0.7,
            along: None,
            picture: None,
        }
    }

    fn words(output: &SurrogateOutput, all: &[SurrogateOutput]) -> Option<String> {
        let units = DisplayUnits::default();
        let words = history_words(output, all, &NumberWriter::for_terminal(&units))?;
        Some(words.replace('\u{a0}', " "))
    }

    #[test]
    fn a_history_that_is_noise_names_the_statistics_of_the_cycle_that_are_none() {
        let rms = ResponsePoint::Reduced { reduction: Reduction::RootMeanSquare };
        let mean = ResponsePoint::Reduced { reduction: Reduction::Mean };
        let all = [
            output(ResponsePoint::Whole, 0.03, SurrogateVerdict::Nothing),
            output(rms, 0.9747, SurrogateVerdict::Floor),
            output(mean, 0.74, SurrogateVerdict::Floor),
            SurrogateOutput { output: "rocker".into(), ..output(rms, 0.99, SurrogateVerdict::Falling) },
        ];
        assert_eq!(
            words(&all[0], &all).as_deref(),
            Some(
                "The surrogate is of no use for this history. It is used for statistics of the cycle: root mean square over the \
                 cycle (97.4 % of the variance explained)."
            )
        );
        assert_eq!(
            words(&all[0], &all[..1]).as_deref(),
            Some(
                "The surrogate is of no use for this history. Ask for a statistic of the cycle (reduce = \"rms\" or \"mean\"), or use \
                 direct bounds."
            )
        );
        assert_eq!(words(&all[1], &all), None);
        assert_eq!(
            words(&output(rms, 0.02, SurrogateVerdict::Nothing), &all).as_deref(),
            Some("Use direct bounds here.")
        );
    }

    #[test]
    fn an_error_that_falls_must_fall_fast_enough() {
        let falling = |half: f64| SurrogateOutput {
            learning: [(40, half), (80, 0.11e-3)]
                .map(|(runs, held_out_si)| SurrogateLearning { runs, held_out_si })
                .into(),
            ..output(ResponsePoint::Whole, 0.53, SurrogateVerdict::Falling)
        };
        // 0.47 (0.11/0.12)^10 is 0.20, 0.47 (0.11/0.13)^10 is 0.09: less than a tenth.
        assert!(words(&falling(0.12e-3), &[]).is_some());
        assert_eq!(words(&falling(0.13e-3), &[]), None);
    }

    #[test]
    fn a_history_that_is_learned_has_no_such_words() {
        let pose = ResponsePoint::Pose { pose_rad: 0.7 };
        assert_eq!(words(&output(pose, 0.4, SurrogateVerdict::Falling), &[]), None);
        assert_eq!(words(&output(pose, 0.93, SurrogateVerdict::Floor), &[]), None);
        assert!(words(&output(pose, 0.78, SurrogateVerdict::Floor), &[]).is_some());
    }
}

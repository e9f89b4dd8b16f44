//! Assumptions of the bounds of an identification.

use crate::numbers::number::{NumberWriter, Rounding};
use loosepin_result::identification::Identification;
use loosepin_text::units::{SiUnit, counted};

/// Digits of an error.
const ERROR_DIGITS: usize = 2;

/// Assumptions of the bounds.
pub(super) fn grounds(answer: &Identification, writer: &NumberWriter<'_>) -> Vec<String> {
    let percent = writer.percent(answer.confidence, Rounding::Nearest);
    let of_motion = || {
        let scatter = "the scatter of the random inputs, independent errors and chaotic motion";
        format!("the set of a motion holds the true values with {percent} confidence over {scatter}")
    };
    if answer.specimens.is_empty() {
        return vec![of_motion()];
    }
    let readings = || answer.specimens.iter().flat_map(|specimen| &specimen.readings);
    let has_scatter = readings().any(|reading| reading.independent_error_si > 0.0);
    let has_random = !answer.random_inputs.is_empty();
    let inputs = counted(answer.random_inputs.len(), "random input");
    let mut words = vec![match (has_scatter, has_random) {
        (false, false) => "all bounds hold for every value within the stated errors".to_owned(),
        (true, false) => {
            format!("all bounds hold at the same time with {percent} confidence over the scatter of the readings")
        }
        (false, true) => format!("all bounds hold at the same time with {percent} confidence over the {inputs}"),
        (true, true) => format!(
            "all bounds hold at the same time with {percent} confidence over the scatter of the readings and the {inputs}; over everything else \
             they hold for every value"
        ),
    }];
    let share = readings().map(|reading| reading.linearisation_share).fold(0.0, f64::max);
    words.push(format!(
        "the exact loops differ from the linear model by at most {} % of the dead travel, found at the corners of the intervals and at the \
         bounds, and doubled; the bounds include it",
        writer.rounded(100.0 * share, &SiUnit::NONE, ERROR_DIGITS, Rounding::Up)
    ));
    if !answer.motion.is_empty() {
        words.push(of_motion());
    }
    if answer.specimens.len() > 1 {
        words.push("each specimen is analysed separately, with its own plays and lengths".to_owned());
    }
    words
}

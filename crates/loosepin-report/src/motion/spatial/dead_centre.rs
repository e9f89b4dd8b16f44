//! What is said where play takes a mechanism to a dead centre.

use super::numbers::shown_input;
use loosepin_result::spatial_motion::SpatialMotionRecord;
use loosepin_text::article::Medium;
use loosepin_text::units::counted;

/// Where it is, and what does not hold there; `None` where none was found.
pub(super) fn dead_centre_sentence(record: &SpatialMotionRecord, medium: Medium) -> Option<String> {
    let samples = &record.dead_centre_samples;
    let [first, last] = [samples.first()?, samples.last()?].map(|sample| shown_input(record, *sample, medium));
    let places = match samples.len() {
        1 => format!("at {first}"),
        2 => format!("at {first} and {last}"),
        count => format!("at {} between {first} and {last}", counted(count, "position")),
    };
    Some(format!(
        "Play takes the mechanism to a dead centre {places}: there it can go over to its other assembly, and the worst case of first order says \
         nothing. What was found there is no bound: more may be possible."
    ))
}

//! What is said where play takes a mechanism to a dead centre.

use super::numbers::{shown_deviation, shown_input};
use loosepin_result::spatial_motion::{SpatialMotionRecord, SpatialOutputRecord};
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

/// The worst regular position of each output whose worst one is near a dead centre.
pub(super) fn regular_sentences(record: &SpatialMotionRecord, medium: Medium) -> Vec<String> {
    let sentence = |output: &SpatialOutputRecord| {
        let own = output.worst_regular.as_ref()?;
        let deviation = |value_si: f64| shown_deviation(value_si, output, medium);
        let first_order_si = output.first_order_si.get(own.sample).copied()?;
        let [first_order, up, down] = [first_order_si, own.largest_si, own.smallest_si].map(deviation);
        Some(format!(
            "{}: where play comes near no dead centre, the worst case of first order is {first_order}, at {}; found there: {up} and {down}.",
            output.name,
            shown_input(record, own.sample, medium)
        ))
    };
    record.outputs.iter().filter_map(sentence).collect()
}

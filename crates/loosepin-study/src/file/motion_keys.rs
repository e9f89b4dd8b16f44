//! The keys of a feature of a measured motion.

use super::measurement::FEATURES;
use super::words::{DEVIATIONS, words};
use loosepin_text::document::{Keys, Kind, optional, required};

/// Repeats of a motion, at most: each is a stretch of recorded turns that is simulated.
pub(super) const MOST_STRETCHES: u64 = 20;
/// Highest order of a spectrum, at most: two samples a period.
const MOST_ORDER: u64 = 1000;

const FEATURE_WORDS: [&str; FEATURES.len()] = words(&FEATURES);
const DEVIATION_WORDS: [&str; DEVIATIONS.len()] = words(&DEVIATIONS);

pub(super) static MOTION_KEYS: Keys = Keys::new(
    "a feature of a motion that was measured over the recorded turns: one number, or one for each repeat",
    &[
        required(
            "kind",
            Kind::Choice(&["motion"]),
            "\"motion\"",
            "that it is of a motion; left out for a backlash test",
        ),
        optional(
            "output",
            Kind::Reference("output"),
            "\"slider_acceleration\"",
            "an output of the model: what was measured",
        ),
        optional(
            "component",
            Kind::Choice(&["x", "y"]),
            "\"x\"",
            "of a path, and only there: the coordinate that was measured",
        ),
        optional(
            "of",
            Kind::Choice(&DEVIATION_WORDS),
            "\"total\"",
            "a deviation in place of the value, where the feature is located between samples; \"value\" if left out",
        ),
        optional(
            "joint",
            Kind::Reference("joint"),
            "\"gudgeon\"",
            "in place of an output: the joint whose impacts were counted",
        ),
        required(
            "feature",
            Kind::Choice(&FEATURE_WORDS),
            "\"rms\"",
            "number that the motion of all recorded turns is reduced to",
        ),
        optional(
            "order",
            Kind::Count { least: 1, most: MOST_ORDER },
            "3",
            "of the amplitude of an order: periods in a turn",
        ),
        optional("within", Kind::AnyQuantity, "\"0.1 mm\"", "of a dwell: distance from the largest value"),
        optional(
            "highest_order",
            Kind::Count { least: 1, most: MOST_ORDER },
            "40",
            "low-pass filter: orders above are taken off the samples; measured and simulated samples alike",
        ),
        optional(
            "sampled",
            Kind::Choice(&["between", "samples"]),
            "\"samples\"",
            "whether extremes are located between samples, or are those of samples_per_turn of the study; samples where a curve, \
             a filter or an order is given",
        ),
        optional(
            "value",
            Kind::AnyOf(&[Kind::AnyQuantity, Kind::List(&Kind::AnyQuantity)]),
            "[\"5210 m/s^2\", \"5340 m/s^2\"]",
            "the feature as it was measured: one value, or all repeats; left out for what could be measured",
        ),
        optional(
            "file",
            Kind::Text,
            "\"acceleration.csv\"",
            "in place of a value: a table with the time or the angle of the drive and a column of the output; as many repeats as \
             it holds the recorded turns",
        ),
        optional(
            "repeats",
            Kind::Count { least: 1, most: MOST_STRETCHES },
            "5",
            "beside one value: the number of repeats whose mean it is; 1 if left out",
        ),
        optional(
            "error",
            Kind::AnyQuantity,
            "\"± 5 %\"",
            "largest error that all values of the instrument have in common, of either sign, or its share of the true value; 0 if left out",
        ),
        optional(
            "scatter",
            Kind::AnyQuantity,
            "\"2 %\"",
            "standard deviation of the independent error of one repeat, or its share of the true value; 0 if left out",
        ),
        optional(
            "instrument",
            Kind::Text,
            "\"accelerometer\"",
            "what has the common error; one for each output if left out",
        ),
        optional("specimen", Kind::Text, "\"A\"", "the mechanism that was measured: its lengths and plays are its own"),
        optional("name", Kind::Text, "\"peak\"", "for messages; output and feature if left out"),
    ],
);

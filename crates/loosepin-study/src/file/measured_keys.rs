//! The keys of a reading of a backlash test.

use loosepin_text::document::{Keys, Kind, optional, quantity, required};
use loosepin_text::units::{Dimension, Rule};

/// Repeats of a reading, at most.
const MOST_REPEATS: u64 = 1_000_000;

pub(super) static MEASURED_KEYS: Keys = Keys::new(
    "a reading of a backlash test: an output is pushed to and fro with the drives locked, and the dead travel between the two \
     settled positions is read",
    &[
        required("output", Kind::Reference("output"), "\"slider\"", "a position or an angle of the model: what is read"),
        optional("component", Kind::Choice(&["x", "y"]), "\"x\"", "of a path, and only there: the coordinate that is read"),
        required(
            "pose",
            Kind::Values(&quantity(Dimension::ANGLE, Rule::Finite)),
            "{ crank = \"60 deg\" }",
            "angle at which the drive that the cycle counts is locked",
        ),
        optional(
            "pose_error",
            quantity(Dimension::ANGLE, Rule::NonNegative),
            "\"0.5 deg\"",
            "largest error of that angle, of either sign; 0 if left out",
        ),
        optional(
            "force",
            quantity(Dimension::FORCE, Rule::Positive),
            "\"20 N\"",
            "force of the push, the same to and fro",
        ),
        optional(
            "moment",
            quantity(Dimension::TORQUE, Rule::Positive),
            "\"0.5 N m\"",
            "in place of a force: the moment that turns the body whose angle is read",
        ),
        optional(
            "at",
            Kind::Point,
            "\"slider.pin\"",
            "the point that is pushed; the one whose coordinate is read if left out",
        ),
        optional(
            "direction",
            quantity(Dimension::ANGLE, Rule::Finite),
            "\"0 deg\"",
            "direction of the push to, from the ground's x axis; along the coordinate that is read if left out",
        ),
        required(
            "dead_travel",
            Kind::AnyOf(&[Kind::AnyQuantity, Kind::List(&Kind::AnyQuantity)]),
            "[\"0.412 mm\", \"0.409 mm\", \"0.413 mm\"]",
            "travel between the two settled positions, under load: one value, or all repeats",
        ),
        optional(
            "repeats",
            Kind::Count { least: 1, most: MOST_REPEATS },
            "5",
            "beside one value: the number of readings whose mean it is; 1 if left out",
        ),
        optional(
            "error",
            Kind::AnyQuantity,
            "\"± 0.005 mm\"",
            "largest error that all readings of the instrument have in common, of either sign: repeats do not make it smaller; \
             0 if left out",
        ),
        optional(
            "scatter",
            Kind::AnyQuantity,
            "\"0.002 mm\"",
            "standard deviation of one reading: repeats make it smaller; from three or more repeats themselves if left out",
        ),
        optional("instrument", Kind::Text, "\"dial gauge\"", "what has the error; one for each output if left out"),
        optional("specimen", Kind::Text, "\"A\"", "the mechanism that was measured: its lengths and plays are its own"),
        optional(
            "friction",
            Kind::Number { rule: Rule::NonNegative },
            "0.15",
            "largest coefficient of friction in the joints, anything from 0 to it; that of the contacts in the model if left out",
        ),
        optional("name", Kind::Text, "\"tip, sideways\"", "for messages; its place in the file if left out"),
    ],
)
.with_exactly_one(&[&["force", "moment"]]);

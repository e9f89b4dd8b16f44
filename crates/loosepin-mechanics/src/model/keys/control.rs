//! The keys of controls.

use crate::model::drive::MOTION_KINDS;
use loosepin_text::document::{Keys, Kind, optional, quantity, required};
use loosepin_text::units::{Dimension as D, Rule};

/// Value of `feed_forward` that asks for the torques that the references need.
pub(in crate::model) const INVERSE_DYNAMICS: &str = "inverse dynamics";

pub(in crate::model) static CONTROL_KEYS: Keys = Keys::new(
    "a controlled joint: its actuator turns or pushes by the error of a joint against a reference, by the integral of the error and by its rate",
    &[
        required(
            "joint",
            Kind::Reference("joint"),
            "\"elbow\"",
            "the revolute (with or without play) or prismatic joint in which the actuator sits",
        ),
        optional(
            "measured",
            Kind::Reference("joint"),
            "\"wrist\"",
            "the joint whose angle or position follows the reference; the one of the actuator if left out",
        ),
        required("proportional", Kind::AnyQuantity, "\"40 N m/rad\"", "torque or force by error, >= 0"),
        optional(
            "integral",
            Kind::AnyQuantity,
            "\"100 N m/(rad s)\"",
            "torque or force by the error integrated over time, >= 0; none if left out",
        ),
        optional(
            "derivative",
            Kind::AnyQuantity,
            "\"2 N m s/rad\"",
            "torque or force by the rate of the error, >= 0; none if left out",
        ),
        optional(
            "feed_forward",
            Kind::AnyOf(&[
                Kind::Choice(&[INVERSE_DYNAMICS]),
                quantity(D::TORQUE, Rule::Finite),
                quantity(D::FORCE, Rule::Finite),
            ]),
            "\"inverse dynamics\"",
            "torque or force beside that: constant, an expression over time, angle (or position) and speed, or what the \
             bodies need to follow the references without play; none if left out",
        ),
        optional(
            "limit",
            Kind::AnyOf(&[quantity(D::TORQUE, Rule::Positive), quantity(D::FORCE, Rule::Positive)]),
            "\"8 N m\"",
            "largest torque or force of the actuator, either way; none if left out",
        ),
        optional(
            "speed",
            Kind::AnyOf(&[quantity(D::ANGULAR_VELOCITY, Rule::Finite), quantity(D::VELOCITY, Rule::Finite)]),
            "\"90 deg/s\"",
            "constant speed of the reference",
        ),
        optional(
            "start_angle",
            quantity(D::ANGLE, Rule::Finite),
            "\"0 deg\"",
            "angle of the reference at time zero, beside speed",
        ),
        optional(
            "start_position",
            quantity(D::LENGTH, Rule::Finite),
            "\"0 mm\"",
            "position of the reference at time zero, beside speed",
        ),
        optional(
            "motion",
            Kind::Tagged { tag: "kind", variants: MOTION_KINDS },
            "{ kind = \"cycloidal\", from = \"0 deg\", to = \"90 deg\", duration = \"0.5 s\" }",
            "the reference over time, in place of a constant speed",
        ),
    ],
)
.with_exactly_one(&[&["speed", "motion"], &["start_angle", "start_position", "motion"]]);

//! The keys of drives.

use crate::model::drive::MOTION_KINDS;
use loosepin_text::document::{Keys, Kind, optional, quantity, required};
use loosepin_text::units::{Dimension as D, Rule};

pub(in crate::model) static DRIVE_KEYS: Keys = Keys::new(
    "a joint that is moved: at constant speed, or by a motion",
    &[
        required("joint", Kind::Reference("joint"), "\"main\"", "an ideal revolute or a prismatic joint"),
        optional(
            "speed",
            Kind::AnyOf(&[quantity(D::ANGULAR_VELOCITY, Rule::Finite), quantity(D::VELOCITY, Rule::Finite)]),
            "\"5000 rpm\"",
            "constant speed of the journal's body against the bearing's, or of the slider along the guide",
        ),
        optional(
            "start_angle",
            quantity(D::ANGLE, Rule::Finite),
            "\"0 deg\"",
            "angle of the journal's body from the bearing's at time zero, beside speed",
        ),
        optional(
            "start_position",
            quantity(D::LENGTH, Rule::Finite),
            "\"0 mm\"",
            "position of the slider along the guide at time zero, beside speed",
        ),
        optional(
            "motion",
            Kind::Tagged { tag: "kind", variants: MOTION_KINDS },
            "{ kind = \"harmonic\", mean = \"90 deg\", amplitude = \"30 deg\", frequency = \"2 Hz\" }",
            "angle or position over time, in place of a constant speed",
        ),
    ],
)
.with_exactly_one(&[&["speed", "motion"], &["start_angle", "start_position", "motion"]]);

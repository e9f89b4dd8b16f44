//! The keys of loads.

use loosepin_text::document::{Keys, Kind, optional, quantity, required};
use loosepin_text::units::{Dimension as D, Rule};

const FREQUENCY_DOC: &str = "oscillations in a second";
const PHASE_DOC: &str = "phase at time zero, 0 for the middle on the way up; 0 deg if left out";
const JOINT_DOC: &str = "the joint whose angle (or position) and speed the expression reads";

pub(in crate::model) static HARMONIC_FORCE_KEYS: Keys = Keys::new(
    "a force that goes up and down: mean + amplitude sin(360 deg frequency time + phase)",
    &[
        optional("mean", quantity(D::FORCE, Rule::Finite), "\"0 N\"", "its middle; 0 N if left out"),
        required("amplitude", quantity(D::FORCE, Rule::Finite), "\"5 N\"", "largest departure from the middle"),
        required("frequency", quantity(D::FREQUENCY, Rule::Positive), "\"20 Hz\"", FREQUENCY_DOC),
        optional("phase", quantity(D::ANGLE, Rule::Finite), "\"90 deg\"", PHASE_DOC),
    ],
);

pub(in crate::model) static HARMONIC_TORQUE_KEYS: Keys = Keys::new(
    "a torque that goes up and down: mean + amplitude sin(360 deg frequency time + phase)",
    &[
        optional("mean", quantity(D::TORQUE, Rule::Finite), "\"0 N m\"", "its middle; 0 N m if left out"),
        required("amplitude", quantity(D::TORQUE, Rule::Finite), "\"0.2 N m\"", "largest departure from the middle"),
        required("frequency", quantity(D::FREQUENCY, Rule::Positive), "\"20 Hz\"", FREQUENCY_DOC),
        optional("phase", quantity(D::ANGLE, Rule::Finite), "\"90 deg\"", PHASE_DOC),
    ],
);

static FORCE_KEYS: Keys = Keys::new(
    "a force on a point of a body",
    &[
        required("kind", Kind::Choice(&["force"]), "\"force\"", "the kind of load"),
        required("point", Kind::Point, "\"rocker.tip\"", "the point that it acts on"),
        required(
            "force",
            Kind::AnyOf(&[quantity(D::FORCE, Rule::Finite), Kind::Table(&HARMONIC_FORCE_KEYS)]),
            "\"10 N\"",
            "its size: constant, an expression over time, or a table with amplitude and frequency",
        ),
        required("direction", quantity(D::ANGLE, Rule::Finite), "\"-90 deg\"", "its direction from the x axis"),
        optional(
            "frame",
            Kind::Choice(&["ground", "body"]),
            "\"ground\"",
            "whose x axis: the ground's, if left out, or the body's, with which it then turns",
        ),
        optional("joint", Kind::Reference("joint"), "\"main\"", JOINT_DOC),
    ],
);

static TORQUE_KEYS: Keys = Keys::new(
    "a torque on a body",
    &[
        required("kind", Kind::Choice(&["torque"]), "\"torque\"", "the kind of load"),
        required("body", Kind::Reference("body"), "\"rocker\"", "the body that it acts on"),
        required(
            "torque",
            Kind::AnyOf(&[quantity(D::TORQUE, Rule::Finite), Kind::Table(&HARMONIC_TORQUE_KEYS)]),
            "\"0.2 N m\"",
            "its size: constant, an expression over time, or a table with amplitude and frequency",
        ),
        optional("joint", Kind::Reference("joint"), "\"main\"", JOINT_DOC),
    ],
);

pub(in crate::model) static LOAD_KINDS: &[(&str, &Keys)] = &[("force", &FORCE_KEYS), ("torque", &TORQUE_KEYS)];

//! The keys of loads.

use super::table::CSV;
use loosepin_text::document::{Key, Keys, Kind, optional, quantity, required};
use loosepin_text::units::{Dimension as D, Rule};

const FREQUENCY_DOC: &str = "oscillations in a second";
const PHASE_DOC: &str = "phase at time zero, 0 for the middle on the way up; 0 deg if left out";
const JOINT_DOC: &str = "the joint whose angle (or position) and speed the expression reads, or the table is over";

/// The words for what a table is over.
pub(in crate::model) const ARGUMENTS: [&str; 4] = ["time", "angle", "position", "speed"];

const OF: Key = optional(
    "of",
    Kind::Choice(&ARGUMENTS),
    "\"angle\"",
    "beside points or csv, needed there: what the first column is: the time, or angle, position or speed of the joint",
);
const PERIOD: Key = optional(
    "period",
    Kind::AnyQuantity,
    "\"720 deg\"",
    "beside points or csv: after which the table begins again; if left out, it keeps the value of each end beyond it",
);
const CURVE: Key = optional(
    "curve",
    Kind::Choice(&["monotone", "spline"]),
    "\"spline\"",
    "beside points or csv: monotone, if left out: between two points nowhere beyond them; spline: smoother, and it may swing beyond them",
);

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
        optional(
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
        optional(
            "points",
            Kind::List(&Kind::List(&Kind::AnyQuantity)),
            "[[\"0 deg\", \"40 N\"], [\"90 deg\", \"65 N\"], [\"270 deg\", \"10 N\"]]",
            "in place of force: pairs of what it is over and the force there, or the pressure where there is an area; the first ones \
             increasing",
        ),
        CSV,
        OF,
        PERIOD,
        CURVE,
        optional(
            "area",
            quantity(D::AREA, Rule::Positive),
            "\"50 cm^2\"",
            "beside points or csv: the points are pressures on this area; the force is (pressure - back_pressure) area",
        ),
        optional(
            "back_pressure",
            quantity(D::PRESSURE, Rule::Finite),
            "\"1 bar\"",
            "beside area: the pressure on its other side; 0 Pa if left out",
        ),
    ],
)
.with_exactly_one(&[&["force", "points", "csv"]]);

static TORQUE_KEYS: Keys = Keys::new(
    "a torque on a body",
    &[
        required("kind", Kind::Choice(&["torque"]), "\"torque\"", "the kind of load"),
        required("body", Kind::Reference("body"), "\"rocker\"", "the body that it acts on"),
        optional(
            "torque",
            Kind::AnyOf(&[quantity(D::TORQUE, Rule::Finite), Kind::Table(&HARMONIC_TORQUE_KEYS)]),
            "\"0.2 N m\"",
            "its size: constant, an expression over time, or a table with amplitude and frequency",
        ),
        optional("joint", Kind::Reference("joint"), "\"main\"", JOINT_DOC),
        optional(
            "points",
            Kind::List(&Kind::List(&Kind::AnyQuantity)),
            "[[\"0 rpm\", \"12 N m\"], [\"2000 rpm\", \"15 N m\"], [\"3000 rpm\", \"0 N m\"]]",
            "in place of torque: pairs of what it is over and the torque there, the first ones increasing",
        ),
        CSV,
        OF,
        PERIOD,
        CURVE,
    ],
)
.with_exactly_one(&[&["torque", "points", "csv"]]);

pub(in crate::model) static LOAD_KINDS: &[(&str, &Keys)] = &[("force", &FORCE_KEYS), ("torque", &TORQUE_KEYS)];

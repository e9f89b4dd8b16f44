//! The keys of drives and of the motions that they prescribe.

use super::table::CSV;
use loosepin_text::document::{Key, Keys, Kind, optional, quantity, required};
use loosepin_text::units::{Dimension as D, Rule};

const COORDINATE: Kind = Kind::AnyOf(&[quantity(D::ANGLE, Rule::Finite), quantity(D::LENGTH, Rule::Finite)]);

const fn kind(choice: &'static [&'static str], example: &'static str) -> Key {
    required("kind", Kind::Choice(choice), example, "the kind of motion")
}

static POLYNOMIAL_KEYS: Keys = Keys::new(
    "c0 + c1 time + c2 time^2 + ...",
    &[
        kind(&["polynomial"], "\"polynomial\""),
        required(
            "coefficients",
            Kind::List(&Kind::AnyQuantity),
            "[\"10 deg\", \"5 rad/s\", \"20 rad/s^2\"]",
            "c0, c1, c2, ... with their units",
        ),
    ],
);

static HARMONIC_KEYS: Keys = Keys::new(
    "mean + amplitude sin(360 deg frequency time + phase)",
    &[
        kind(&["harmonic"], "\"harmonic\""),
        required("mean", COORDINATE, "\"90 deg\"", "its middle"),
        required("amplitude", COORDINATE, "\"30 deg\"", "largest departure from the middle"),
        required("frequency", quantity(D::FREQUENCY, Rule::Positive), "\"2 Hz\"", "oscillations in a second"),
        optional(
            "phase",
            quantity(D::ANGLE, Rule::Finite),
            "\"90 deg\"",
            "phase at time zero, 0 for the middle on the way up; 0 deg if left out",
        ),
    ],
);

static CYCLOIDAL_KEYS: Keys = Keys::new(
    "a rise without a jump of the acceleration, between two rests",
    &[
        kind(&["cycloidal"], "\"cycloidal\""),
        required("from", COORDINATE, "\"0 deg\"", "where it rests before"),
        required("to", COORDINATE, "\"90 deg\"", "where it rests afterwards"),
        required("duration", quantity(D::TIME, Rule::Positive), "\"0.2 s\"", "duration of the rise"),
        optional("dwell", quantity(D::TIME, Rule::NonNegative), "\"0.05 s\"", "rest before the rise; none if left out"),
    ],
);

static TABLE_KEYS: Keys = Keys::new(
    "a cubic spline through points, whose acceleration does not jump between them",
    &[
        kind(&["table"], "\"table\""),
        optional(
            "points",
            Kind::List(&Kind::List(&Kind::AnyQuantity)),
            "[[\"0 s\", \"0 deg\"], [\"0.1 s\", \"40 deg\"], [\"0.3 s\", \"0 deg\"]]",
            "pairs of a time and the angle or position there, times increasing",
        ),
        required(
            "ends",
            Kind::Choice(&["clamped", "periodic"]),
            "\"clamped\"",
            "clamped: at rest before the first point and after the last; periodic: the same course again and again, each \
             time from where the last one ended",
        ),
        CSV,
    ],
)
.with_exactly_one(&[&["points", "csv"]]);

static EXPRESSION_KEYS: Keys = Keys::new(
    "an expression over time",
    &[
        kind(&["expression"], "\"expression\""),
        required("position", COORDINATE, "\"30 deg * sin(3 rad/s * time)\"", "the angle or position at the time"),
    ],
);

pub(in crate::model) static MOTION_KINDS: &[(&str, &Keys)] = &[
    ("polynomial", &POLYNOMIAL_KEYS),
    ("harmonic", &HARMONIC_KEYS),
    ("cycloidal", &CYCLOIDAL_KEYS),
    ("table", &TABLE_KEYS),
    ("expression", &EXPRESSION_KEYS),
];

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

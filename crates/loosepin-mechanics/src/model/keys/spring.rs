//! The keys of springs.

use super::table::CSV;
use loosepin_text::document::{Key, Keys, Kind, optional, quantity, required};
use loosepin_text::units::{Dimension as D, Rule};

const CURVE: Key = optional(
    "curve",
    Kind::Choice(&["monotone", "spline"]),
    "\"spline\"",
    "beside points or csv: monotone, if left out: between two points nowhere beyond them; spline: smoother, with no jump of the \
     stiffness' slope",
);

static LINEAR_SPRING_KEYS: Keys = Keys::new(
    "a spring with its damper between points of two bodies; it pulls where it is longer than its free length",
    &[
        required("kind", Kind::Choice(&["linear"]), "\"linear\"", "the kind of spring"),
        required("first", Kind::Point, "\"ground.hook\"", "point of the first body"),
        required("second", Kind::Point, "\"rocker.eye\"", "point of the second body"),
        optional("stiffness", quantity(D::SPRING_STIFFNESS, Rule::NonNegative), "\"2 N/mm\"", "force by extension"),
        optional(
            "free_length",
            quantity(D::LENGTH, Rule::NonNegative),
            "\"40 mm\"",
            "length at which it is not extended",
        ),
        optional(
            "damping",
            quantity(D::DAMPING, Rule::NonNegative),
            "\"5 N s/m\"",
            "force by speed of extension, along the spring; none if left out",
        ),
        optional(
            "preload",
            quantity(D::FORCE, Rule::Finite),
            "\"10 N\"",
            "pull at the free length, below zero for a push; none if left out",
        ),
        optional(
            "points",
            Kind::List(&Kind::List(&Kind::AnyQuantity)),
            "[[\"30 mm\", \"-4 N\"], [\"40 mm\", \"0 N\"], [\"55 mm\", \"12 N\"]]",
            "pairs of a length and the pull there, in place of stiffness and free length; lengths increasing, straight beyond both ends",
        ),
        CSV,
        CURVE,
    ],
)
.with_exactly_one(&[&["stiffness", "points", "csv"], &["free_length", "points", "csv"]]);

static TORSIONAL_SPRING_KEYS: Keys = Keys::new(
    "a spring with its damper that turns two bodies back to their free angle",
    &[
        required("kind", Kind::Choice(&["torsional"]), "\"torsional\"", "the kind of spring"),
        optional(
            "joint",
            Kind::Reference("joint"),
            "\"pivot\"",
            "the revolute joint around which it lies: from its bearing's body to its journal's",
        ),
        optional("first", Kind::Reference("body"), "\"ground\"", "the first body, in place of a joint"),
        optional("second", Kind::Reference("body"), "\"rocker\"", "the second body, in place of a joint"),
        optional("stiffness", quantity(D::TORSIONAL_STIFFNESS, Rule::NonNegative), "\"2 N m/rad\"", "torque by angle"),
        optional(
            "free_angle",
            quantity(D::ANGLE, Rule::Finite),
            "\"30 deg\"",
            "angle of the second body from the first at which it is not wound up",
        ),
        optional(
            "damping",
            quantity(D::TORSIONAL_DAMPING, Rule::NonNegative),
            "\"0.01 N m s/rad\"",
            "torque by angular velocity; none if left out",
        ),
        optional(
            "preload",
            quantity(D::TORQUE, Rule::Finite),
            "\"0.1 N m\"",
            "torque at the free angle that turns the second body backwards; none if left out",
        ),
        optional(
            "points",
            Kind::List(&Kind::List(&Kind::AnyQuantity)),
            "[[\"-20 deg\", \"-0.4 N m\"], [\"0 deg\", \"0 N m\"], [\"30 deg\", \"1 N m\"]]",
            "pairs of an angle and the torque there, in place of stiffness and free angle; angles increasing, straight beyond both ends",
        ),
        CSV,
        CURVE,
    ],
)
.with_exactly_one(&[&["stiffness", "points", "csv"], &["free_angle", "points", "csv"]]);

pub(in crate::model) static SPRING_KINDS: &[(&str, &Keys)] =
    &[("linear", &LINEAR_SPRING_KEYS), ("torsional", &TORSIONAL_SPRING_KEYS)];

//! Keys of friction, in contacts and in ideal joints.

use crate::contact::FRICTION_LAWS;
use loosepin_text::document::{Key, Keys, Kind, optional, quantity, required};
use loosepin_text::units::{Dimension as D, Rule};

fn friction_law_names() -> Vec<&'static str> {
    FRICTION_LAWS.iter().map(|law| law.name).collect()
}

/// Keys of friction, that of a contact alone last.
static FRICTION: [Key; 12] = [
    optional("law", Kind::ChoiceOf(friction_law_names), "\"ambrosio\"", "the friction law; ambrosio if left out"),
    required("coefficient", quantity(D::NUMBER, Rule::NonNegative), "0.03", "coefficient of friction at full sliding"),
    optional(
        "lower_speed",
        quantity(D::VELOCITY, Rule::NonNegative),
        "\"0.1 mm/s\"",
        "ambrosio: sliding speed up to which there is no friction; 0.1 mm/s if left out",
    ),
    optional(
        "upper_speed",
        quantity(D::VELOCITY, Rule::Positive),
        "\"1 mm/s\"",
        "ambrosio: sliding speed from which friction is full; 1 mm/s if left out",
    ),
    optional(
        "static_coefficient",
        quantity(D::NUMBER, Rule::NonNegative),
        "0.05",
        "coefficient of friction at the onset of sliding",
    ),
    optional(
        "transition_speed",
        quantity(D::VELOCITY, Rule::Positive),
        "\"1 mm/s\"",
        "sliding speed at which friction has risen from nothing; 1 mm/s if left out",
    ),
    optional(
        "stribeck_speed",
        quantity(D::VELOCITY, Rule::Positive),
        "\"10 mm/s\"",
        "sliding speed over which friction falls from its static to its dynamic value",
    ),
    optional(
        "decay",
        quantity(D::INVERSE_VELOCITY, Rule::NonNegative),
        "\"30 s/m\"",
        "bengisu-akay: how fast friction falls from its static to its dynamic value",
    ),
    optional(
        "bristle_stiffness",
        quantity(D::INVERSE_LENGTH, Rule::Positive),
        "\"1e5 m^-1\"",
        "lugre: what the coefficient gains for each unit of deflection of the bristles",
    ),
    optional(
        "bristle_damping",
        quantity(D::INVERSE_VELOCITY, Rule::NonNegative),
        "\"0.4 s/m\"",
        "lugre: what the coefficient gains for each unit of speed of the bristles; nothing if left out",
    ),
    optional(
        "viscous",
        quantity(D::INVERSE_VELOCITY, Rule::NonNegative),
        "\"0.02 s/m\"",
        "what the coefficient gains for each unit of sliding speed; nothing if left out",
    ),
    optional(
        "sliding_velocity",
        Kind::Choice(&["material", "literal"]),
        "\"material\"",
        "between the material points (material, if left out) or of the geometric contact point (literal)",
    ),
];

pub(in crate::model) static FRICTION_KEYS: Keys = Keys::new("friction between pin and hole", &FRICTION);

pub(in crate::model) static JOINT_FRICTION_KEYS: Keys =
    Keys::new("friction of an ideal joint", FRICTION.split_at(11).0);

//! Keys of friction, in contacts and in ideal joints.

use crate::contact::{FRICTION_KEYS as NUMBERS, FRICTION_LAWS};
use loosepin_text::document::{Key, Keys, Kind, joined, optional};

fn friction_law_names() -> Vec<&'static str> {
    FRICTION_LAWS.iter().map(|law| law.name).collect()
}

const LAW: Key =
    optional("law", Kind::ChoiceOf(friction_law_names), "\"ambrosio\"", "the friction law; ambrosio if left out");

const SLIDING_VELOCITY: Key = optional(
    "sliding_velocity",
    Kind::Choice(&["material", "literal"]),
    "\"material\"",
    "between the material points (material, if left out) or of the geometric contact point (literal)",
);

/// Keys of friction in contacts: the law, its numbers, and how it reads the sliding velocity.
static OF_CONTACTS: [Key; NUMBERS.len() + 2] = joined(&[&[LAW], NUMBERS, &[SLIDING_VELOCITY]]);

pub(in crate::model) static FRICTION_KEYS: Keys = Keys::new("friction between pin and hole", &OF_CONTACTS);

/// In ideal joints there is one sliding velocity alone.
pub(in crate::model) static JOINT_FRICTION_KEYS: Keys = match &OF_CONTACTS {
    [of_joints @ .., _] => Keys::new("friction of an ideal joint", of_joints),
};

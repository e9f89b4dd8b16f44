//! Keys of numbers that several friction laws have, and the list of the keys of all.

use super::law::{FrictionDescription, FrictionKey, FrictionPart, friction_key};
use loosepin_text::document::{Key, quantity};
use loosepin_text::units::{Dimension as D, Rule};

friction_key!(
    /// coefficient of friction at full sliding
    pub(super) COEFFICIENT of Sliding: required coefficient = quantity(D::NUMBER, Rule::NonNegative), "0.03"
);
friction_key!(
    /// coefficient of friction at the onset of sliding
    pub(super) STATIC_COEFFICIENT of Onset: optional static_coefficient = quantity(D::NUMBER, Rule::NonNegative), "0.05"
);
friction_key!(
    /// sliding speed up to which friction rises from zero to its full value
    pub(super) TRANSITION_SPEED of Rise:
        optional transition_speed = quantity(D::VELOCITY, Rule::Positive), "\"1 mm/s\"", or "1 mm/s"
);
friction_key!(
    /// sliding speed over which friction falls from its static to its dynamic value
    pub(super) STRIBECK_SPEED of Fall: optional stribeck_speed = quantity(D::VELOCITY, Rule::Positive), "\"10 mm/s\""
);
friction_key!(
    /// increase of the coefficient per sliding speed
    pub(super) VISCOUS of Viscous:
        optional viscous = quantity(D::INVERSE_VELOCITY, Rule::NonNegative), "\"0.02 s/m\"", or "0 s/m" called "nothing"
);

/// Number of different keys of `laws`.
pub(super) const fn count(laws: &[FrictionDescription]) -> usize {
    let (mut count, mut law) = (0, 0);
    while law < laws.len() {
        let mut number = 0;
        while number < laws[law].numbers.len() {
            count += is_new(laws, law, number) as usize;
            number += 1;
        }
        law += 1;
    }
    count
}

/// The keys of `laws`, each once: in the order of the parts, and within a part in that of the laws. There are [`count`] of them.
pub(super) const fn keys<const COUNT: usize>(laws: &[FrictionDescription]) -> [Key; COUNT] {
    let mut keys = [COEFFICIENT.key; COUNT];
    let (mut count, mut part) = (0, 0);
    while part <= FrictionPart::LAST as u8 {
        let mut law = 0;
        while law < laws.len() {
            let mut number = 0;
            while number < laws[law].numbers.len() {
                let FrictionKey { of, key, .. } = laws[law].numbers[number];
                if of as u8 == part && is_new(laws, law, number) {
                    keys[count] = key;
                    count += 1;
                }
                number += 1;
            }
            law += 1;
        }
        part += 1;
    }
    keys
}

/// Whether no law before has the key of a number.
const fn is_new(laws: &[FrictionDescription], law: usize, number: usize) -> bool {
    let name = laws[law].numbers[number].name();
    let mut before = 0;
    while before < law {
        let mut other = 0;
        while other < laws[before].numbers.len() {
            if is_same(name, laws[before].numbers[other].name()) {
                return false;
            }
            other += 1;
        }
        before += 1;
    }
    true
}

/// Whether two texts are equal, where the compiler must know.
const fn is_same(a: &str, b: &str) -> bool {
    let (a, b) = (a.as_bytes(), b.as_bytes());
    if a.len() != b.len() {
        return false;
    }
    let mut k = 0;
    while k < a.len() {
        if a[k] != b[k] {
            return false;
        }
        k += 1;
    }
    true
}

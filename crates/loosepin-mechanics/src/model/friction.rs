//! Friction, in contacts and in ideal joints.

use super::joint::JointReader;
use super::quantity::QuantityId;
use crate::contact::{FRICTION_LAWS, FrictionDescription, friction_law};
use loosepin_text::document::{Entry, Keys};

/// The friction law where the file names none.
const DEFAULT_FRICTION_LAW: &str = "ambrosio";

/// Friction between the parts of a joint.
#[derive(Debug, Clone)]
pub struct Friction {
    /// The law.
    pub law: &'static FrictionDescription,
    /// Its numbers, in the order of [`FrictionDescription::numbers`].
    pub numbers: Vec<QuantityId>,
    /// Which reading of eq. (7) gives the sliding velocity.
    pub sliding_velocity: SlidingVelocity,
}

/// The two readings of eq. (7) of the source.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SlidingVelocity {
    /// Velocity between the material points in contact, with the spin of both bodies (default).
    Material,
    /// Velocity of the geometric contact point, as eq. (7) differentiates eq. (5).
    Literal,
}

impl Friction {
    /// Reads a friction law with its numbers from a table with these keys; `None` after a complaint.
    pub(super) fn read(entry: &Entry<'_>, keys: &'static Keys, reader: &mut dyn JointReader) -> Option<Self> {
        let table = reader.document().table(entry, keys)?;
        let laws: Vec<_> = FRICTION_LAWS.iter().map(|law| (law.name, law)).collect();
        let law = reader.document().choice_or(&table, "law", &laws, friction_law(DEFAULT_FRICTION_LAW)?);
        let has_readings = keys.find("sliding_velocity").is_some();
        let sliding_velocity = if has_readings {
            let readings = [("material", SlidingVelocity::Material), ("literal", SlidingVelocity::Literal)];
            reader.document().choice_or(&table, "sliding_velocity", &readings, SlidingVelocity::Material)
        } else {
            Some(SlidingVelocity::Material)
        };
        let Some(law) = law else {
            // What is wrong with the numbers is said nevertheless.
            for key in keys.keys {
                reader.quantity(&table, key.name);
            }
            return None;
        };
        for key in keys.keys.iter().filter(|key| table.due_quantity(key.name).is_some()) {
            if law.numbers.iter().all(|number| number.name() != key.name) {
                reader.refuse_beside(&table, key.name, law.name);
            }
        }
        let numbers = law.numbers.iter().map(|number| match number.default_si {
            Some(default_si) => reader.quantity_or(&table, number.name(), default_si),
            None => {
                let key = number.name();
                reader.document().demand(&table, key).then(|| reader.quantity(&table, key)).flatten()
            }
        });
        // All of them are read, so that all complaints come together.
        let numbers: Vec<Option<QuantityId>> = numbers.collect();
        if let Some(keys) = law.below {
            let place = |key: &str| law.numbers.iter().position(|number| number.name() == key);
            let [smaller, larger] = keys.map(|key| place(key).and_then(|place| numbers[place]));
            let written = keys.into_iter().find_map(|key| table.get(key));
            let span = written.map_or(table.span, |entry| entry.span);
            reader.demand_order(smaller?, larger?, span).then_some(())?;
        }
        let numbers = numbers.into_iter().collect::<Option<Vec<QuantityId>>>()?;
        Some(Self { law, numbers, sliding_velocity: sliding_velocity? })
    }
}

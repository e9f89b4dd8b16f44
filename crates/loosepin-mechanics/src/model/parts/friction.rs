//! Friction, in contacts and in ideal joints.

use crate::contact::{FRICTION_KEYS, FRICTION_LAWS, FrictionDescription};
use crate::model::joint::JointReader;
use loosepin_text::document::{Choice, DefaultValue, Entry, Keys, Table, choice};
use loosepin_text::numbers::QuantityId;
use loosepin_text::{choices, record};

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

choices!(SlidingVelocity: "material" => Self::Material, "literal" => Self::Literal);

impl Choice for &'static FrictionDescription {
    fn choices() -> Vec<(&'static str, Self)> {
        FRICTION_LAWS.iter().map(|law| (law.name, law)).collect()
    }
}

/// The numbers of all friction laws, of which a law reads its own.
pub(in crate::model) struct FrictionNumbers;

impl FrictionNumbers {
    const KEYS: Keys = Keys::new("the numbers of friction laws", FRICTION_KEYS);

    fn of<R: ?Sized>(_reader: &mut R, _table: Table<'_>) -> Option<Self> {
        Some(Self)
    }
}

record! {
    /// friction of an ideal joint
    pub(in crate::model) struct JointFrictionTable for JointReader;
    /// the friction law
    optional law: Option<&'static FrictionDescription> =
        choice::<&'static FrictionDescription>(), "\"ambrosio\"", or "ambrosio";
    #[allow(dead_code)]
    include numbers: FrictionNumbers;
}

record! {
    /// friction between pin and hole
    pub(in crate::model) struct FrictionTable for JointReader;
    include own: JointFrictionTable<'t>;
    /// sliding velocity: between the material points (material), or of the geometric contact point (literal)
    optional sliding_velocity: Option<SlidingVelocity> = choice::<SlidingVelocity>(), "\"material\"", or "material";
}

impl Friction {
    /// Reads friction of a contact; `None` after a diagnostic.
    pub(in crate::model) fn of_contact(entry: &Entry<'_>, reader: &mut dyn JointReader) -> Option<Self> {
        let FrictionTable { own, sliding_velocity, .. } = FrictionTable::read(reader, entry)?;
        let friction = Self::read(&own, reader)?;
        Some(Self { sliding_velocity: sliding_velocity?, ..friction })
    }

    /// Reads friction of an ideal joint, in which there is one sliding velocity alone; `None` after a diagnostic.
    pub(in crate::model) fn of_joint(entry: &Entry<'_>, reader: &mut dyn JointReader) -> Option<Self> {
        let own = JointFrictionTable::read(reader, entry)?;
        Self::read(&own, reader)
    }

    fn read(own: &JointFrictionTable<'_>, reader: &mut dyn JointReader) -> Option<Self> {
        let table = &own.table;
        let Some(law) = own.law else {
            // What is wrong with the numbers is said nevertheless.
            for key in FRICTION_KEYS {
                reader.quantity(table, key.name);
            }
            return None;
        };
        for key in FRICTION_KEYS {
            if law.numbers.iter().all(|number| number.name() != key.name) {
                reader.refuse_beside(table, key.name, law.name);
            }
        }
        let numbers = law.numbers.iter().map(|number| match (table.get(number.name()), number.usual) {
            (None, Some(usual)) => QuantityId::default_value(reader, table, number.name(), usual),
            _ => {
                let key = number.name();
                reader.document().demand(table, key).then(|| reader.quantity(table, key)).flatten()
            }
        });
        // All of them are read, so that all diagnostics come together.
        let numbers: Vec<Option<QuantityId>> = numbers.collect();
        if let Some(keys) = law.below {
            let place = |key: &str| law.numbers.iter().position(|number| number.name() == key);
            let [smaller, larger] = keys.map(|key| place(key).and_then(|place| numbers[place]));
            let written = keys.into_iter().find_map(|key| table.get(key));
            let span = written.map_or(table.span, |entry| entry.span);
            reader.demand_order(smaller?, larger?, span).then_some(())?;
        }
        let numbers = numbers.into_iter().collect::<Option<Vec<QuantityId>>>()?;
        Some(Self { law, numbers, sliding_velocity: SlidingVelocity::Material })
    }
}

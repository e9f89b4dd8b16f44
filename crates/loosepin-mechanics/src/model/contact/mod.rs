//! Contacts of joints and couplings with play: the normal force law ([`ContactLaw`], `law.rs`), friction and a film of oil.
//! Keys, how they are read, and the numbers of a run. The forces stand in `contact` of the crate.

mod description;
mod law;
mod law_error;
mod lubrication;
mod materials;

pub use description::NormalDescription;
pub use law::ContactLaw;
pub use law_error::LawError;
pub use lubrication::Lubrication;
pub use materials::Materials;

use super::entry_reader::EntryReader;
use super::part_reader::DeferredQuantity;
use crate::contact::{DEFAULT_LAW, PointLaw, largest_valid_impact_speed_m_s};
use crate::model::parts::friction::{Friction, FrictionTable, SlidingVelocity};
use law::LawTable;
use loosepin_text::document::{Entry, Kind, quantity};
use loosepin_text::numbers::{QuantityId, Values};
use loosepin_text::record;
use loosepin_text::units::{Dimension as D, Rule};
use lubrication::FilmTable;

/// Contact between pin and hole or slot, between the corners of a slider and its guide, or between flanks.
#[derive(Debug, Clone)]
pub struct Contact {
    /// Name in the file.
    pub name: String,
    /// Normal force law.
    pub law: ContactLaw,
    /// Whether the file names it.
    pub is_law_named: bool,
    /// The law named for the energy loss of a line-contact law, whichever law the contact has; `None` if none is named.
    pub line_loss: Option<&'static PointLaw>,
    /// Floor v_min of the impact speed, m/s, > 0.
    pub minimum_impact_speed_m_s: QuantityId,
    /// Density for the validity limit of the law, kg/m³, > 0.
    pub density_kg_m3: Option<QuantityId>,
    /// Friction, if any.
    pub friction: Option<Friction>,
    /// Film of oil, if any.
    pub film: Option<Lubrication>,
    /// A missing contact: joints have play and name no contact, so that the model is complete for its motion only.
    pub is_missing: bool,
}

impl Contact {
    /// Reads it from its table; `None` after a diagnostic.
    pub(super) fn read(name: &str, own: &ContactTable<'_>, reader: &mut dyn EntryReader) -> Option<Self> {
        let law = ContactLaw::read(&own.law, reader);
        let minimum_impact_speed_m_s = own.minimum_impact_speed.quantity(reader);
        let density_kg_m3 = own.density.as_ref().and_then(|entry| reader.quantity_at(entry));
        let friction = own.friction.as_ref().and_then(|entry| Friction::of_contact(entry, reader));
        let film = own.film.as_ref().map(|entry| Lubrication::read(entry, reader));
        let law = law?;
        Some(Self {
            name: name.to_owned(),
            law,
            is_law_named: own.law.law.is_some(),
            line_loss: law.line().and_then(|_| law.loss()).filter(|_| own.law.damping.is_some()),
            minimum_impact_speed_m_s: minimum_impact_speed_m_s?,
            density_kg_m3,
            friction,
            film: film.map_or(Some(None), |film| film.map(Some))?,
            is_missing: false,
        })
    }

    /// One that stands for none, with numbers that stand for nothing: `number` adds one of a key and dimension.
    pub(super) fn missing(name: &str, mut number: impl FnMut(&str, D) -> QuantityId) -> Self {
        let exponent = number("exponent", D::NUMBER);
        let stiffness_n_m_n = number("stiffness", D::contact_stiffness(1.0));
        let restitution = number("restitution", D::NUMBER);
        Self {
            name: name.to_owned(),
            law: ContactLaw::GivenPoint { law: DEFAULT_LAW, restitution, stiffness_n_m_n, exponent },
            is_law_named: true,
            line_loss: None,
            minimum_impact_speed_m_s: number("minimum_impact_speed", D::VELOCITY),
            density_kg_m3: None,
            friction: None,
            film: None,
            is_missing: true,
        }
    }

    /// Whether its friction uses the literal reading of the sliding velocity.
    pub fn is_literal(&self) -> bool {
        self.friction.as_ref().is_some_and(|friction| friction.sliding_velocity == SlidingVelocity::Literal)
    }

    /// Impact speed beyond which the law is not meant to hold, m/s; infinite where no density is given.
    pub fn largest_valid_impact_speed_m_s(&self, values: &Values) -> f64 {
        let Some((materials, density)) = self.law.materials().zip(self.density_kg_m3) else { return f64::INFINITY };
        let [first_pa, second_pa] = materials.youngs_modulus_pa.map(|id| values[id]);
        largest_valid_impact_speed_m_s(first_pa.min(second_pa), values[density])
    }
}

record! {
    /// contact between pin and hole; its stiffness comes from the materials or is given (for a point-contact law with its exponent)
    pub(in crate::model) struct ContactTable for EntryReader;
    include law: LawTable<'t>;
    /// smallest impact speed that the force law uses
    // What it is if omitted is our choice.
    optional minimum_impact_speed: DeferredQuantity<'t> = quantity(D::VELOCITY, Rule::Positive), "\"1 mm/s\"", or "1 mm/s";
    /// density, to detect impacts that are too fast for the law
    optional density: Entry<'t> = quantity(D::DENSITY, Rule::Positive), "\"7800 kg/m^3\"";
    /// friction; none if omitted
    optional friction: Entry<'t> = Kind::Table(&FrictionTable::KEYS), "{ coefficient = 0.03 }";
    /// film of oil, for joints with a bearing_length; none if omitted
    optional film: Entry<'t> = Kind::Table(&FilmTable::KEYS), "{ viscosity = \"0.04 Pa s\", roughness = \"2 um\" }";
}

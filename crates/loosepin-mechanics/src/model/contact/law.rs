//! The normal force law of a contact: its keys, how they are read, and the law with the numbers of a run.
//!
//! The way of a number, for example of `restitution`: [`ContactLaw::read`] takes it from `[contact.NAME]`, [`ContactLaw::normal`] makes of
//! it, and of the sizes of the parts that touch, the form of force that the file of the law names (`contact/point/flores.rs`); this form,
//! `contact/normal/point.rs`, gives the force, and `dynamics/contact.rs` asks for it at each state.

use super::description::NormalDescription;
use super::law_error::LawError;
use super::materials::{MaterialTable, Materials, material_keys};
use crate::contact::{
    DEFAULT_LAW, LONG_PIN_LAW, LineLaw, LinearLaw, NormalLaw, POINT_LAWS, PointLaw, TouchingParts,
    delivered_restitution,
};
use crate::model::entry_reader::EntryReader;
use crate::model::problem::{ModelProblem, needs_keys};
use loosepin_text::document::{Choice, Entry, Kind, choice, quantity};
use loosepin_text::numbers::{QuantityId, UNREAD, Values};
use loosepin_text::record;
use loosepin_text::units::{Dimension as D, Rule};

/// The normal force law of a contact with what the file gives for it; c_e is the nominal coefficient of restitution.
#[derive(Debug, Clone, Copy)]
pub enum ContactLaw {
    /// A point contact `F_N = K δⁿ (1 + χ δ̇/v0)` with K by eq. (9) and n = 3/2.
    Point {
        /// The law.
        law: &'static PointLaw,
        /// c_e, in (0, 1].
        restitution: QuantityId,
        /// The materials from which K follows.
        materials: Materials,
    },
    /// A point contact with K and n as given.
    GivenPoint {
        /// The law.
        law: &'static PointLaw,
        /// c_e, in (0, 1].
        restitution: QuantityId,
        /// K, N/mⁿ, > 0.
        stiffness_n_m_n: QuantityId,
        /// n, >= 1.
        exponent: QuantityId,
    },
    /// A cylinder in a cylinder.
    Line {
        /// The law.
        law: &'static LineLaw,
        /// The law whose χ is the energy loss.
        loss: &'static PointLaw,
        /// c_e, in (0, 1].
        restitution: QuantityId,
        /// The materials of both cylinders.
        materials: Materials,
    },
    /// `F_N = K δ + D δ̇` with K as given.
    Linear {
        /// The law, which defines D.
        law: &'static LinearLaw,
        /// K, N/m, > 0.
        stiffness_n_m: QuantityId,
        /// c_e, in (0, 1], or for a law with D given that, N s/m, >= 0.
        damping: QuantityId,
    },
}

impl ContactLaw {
    /// Reads it from the table of a contact; `None` after a diagnostic.
    pub(super) fn read(own: &LawTable<'_>, reader: &mut dyn EntryReader) -> Option<Self> {
        let (table, default) = (&own.table, NormalDescription::Point(DEFAULT_LAW));
        let known = own.law.unwrap_or(Some(default));
        // Where the law is not known, what else is wrong is said nevertheless.
        let law = known.unwrap_or(default);
        for key in known.map(keys_of_other_laws).unwrap_or_default() {
            reader.refuse_beside(table, key, law.name());
        }
        let (key, loss) = match loss_key(law) {
            DAMPING_COEFFICIENT => (DAMPING_COEFFICIENT, &own.damping_coefficient),
            key => (key, &own.restitution),
        };
        reader.document().demand(table, key);
        let restitution = loss.as_ref().and_then(|entry| reader.quantity_at(entry)).unwrap_or(UNREAD);
        let found = match law {
            NormalDescription::Point(law) => Self::read_point(law, restitution, own, reader),
            NormalDescription::Line(law) => {
                let materials = Materials::read(&own.materials, reader);
                let loss = match &own.damping {
                    Some(entry) => reader.document().choice(entry, &<&PointLaw>::choices()),
                    None => Some(law.default_damping),
                };
                loss.zip(materials).map(|(loss, materials)| Self::Line { law, loss, restitution, materials })
            }
            NormalDescription::Linear(law) => {
                reader.document().demand(table, "stiffness");
                let entry = own.stiffness.as_ref();
                let stiffness =
                    entry.and_then(|entry| reader.quantity_of(entry, D::contact_stiffness(1.0), Rule::Positive));
                stiffness.map(|stiffness_n_m| Self::Linear { law, stiffness_n_m, damping: restitution })
            }
        };
        known.and(found)
    }

    /// A point-contact law, whose stiffness comes from the materials or is given with its exponent.
    fn read_point(
        law: &'static PointLaw,
        restitution: QuantityId,
        own: &LawTable<'_>,
        reader: &mut dyn EntryReader,
    ) -> Option<Self> {
        let table = &own.table;
        let material = material_keys().find(|key| table.has(key));
        let (given, at) = match (&own.stiffness, &own.exponent) {
            (Some(stiffness), Some(exponent)) if material.is_none() => {
                // The exponent fixes the unit of the stiffness, so that neither a study nor a setting may move it.
                let (exponent, value) = reader.fixed_number(exponent, Rule::AtLeastOne)?;
                let dimension = D::contact_stiffness(value);
                let stiffness_n_m_n = reader.quantity_of(stiffness, dimension, Rule::Positive)?;
                return Some(Self::GivenPoint { law, restitution, stiffness_n_m_n, exponent });
            }
            (Some(stiffness), _) => (["stiffness", "exponent"], stiffness),
            (None, Some(exponent)) => (["exponent", "stiffness"], exponent),
            (None, None) if material.is_some() => {
                let materials = Materials::read(&own.materials, reader)?;
                return Some(Self::Point { law, restitution, materials });
            }
            (None, None) => {
                let problem = ModelProblem::NoStiffness { entry: table.path.describe() };
                return reader.document().refuse(&problem, table.span);
            }
        };
        let ([given, needs], entry) = (given, table.path.describe());
        let (problem, span) = match material {
            Some(material) => (ModelProblem::StiffnessTwice { entry, material, given }, at.key_span),
            None => (needs_keys(entry, given, vec![needs]).into(), table.span),
        };
        reader.document().refuse(&problem, span)
    }

    /// The law with the numbers of a run between `parts`. `None` where the stiffness comes from materials and nothing tells the radius of
    /// the parts: such models are refused.
    pub fn normal(&self, values: &Values, parts: &TouchingParts) -> Option<NormalLaw<f64>> {
        match *self {
            Self::Linear { law, stiffness_n_m, damping } => Some(law.contact(values[stiffness_n_m], values[damping])),
            Self::GivenPoint { law, restitution, stiffness_n_m_n, exponent } => {
                Some(law.contact(values[stiffness_n_m_n], values[exponent], values[restitution]))
            }
            Self::Point { law, restitution, materials } => {
                let stiffness_n_m1_5 = parts.stiffness_n_m1_5(materials.compliances_1_pa(values))?;
                Some(law.contact(stiffness_n_m1_5, 1.5, values[restitution]))
            }
            Self::Line { law, loss, restitution, materials } => {
                match parts.line_pair(materials.compliances_1_pa(values)) {
                    Some(pair) => Some((law.contact)(&pair, (loss.damping_factor)(values[restitution]))),
                    // No line touches: of parts on a plane, to which a study may carry the law.
                    None => Self::Point { law: loss, restitution, materials }.normal(values, parts),
                }
            }
        }
    }

    /// The same contact with another law; `named_loss` is the law named for the loss of a line contact, `table` the contact in words.
    ///
    /// # Errors
    /// The law needs what the model does not give.
    pub(in crate::model) fn with(
        &self,
        law: NormalDescription,
        named_loss: Option<&'static PointLaw>,
        table: &str,
    ) -> Result<Self, LawError> {
        let name = law.name();
        let needs = |key: &'static str| LawError::NeedsKey { law: name, key, table: table.to_owned() };
        match (law, *self) {
            (
                NormalDescription::Point(law),
                Self::Point { restitution, materials, .. } | Self::Line { restitution, materials, .. },
            ) => Ok(Self::Point { law, restitution, materials }),
            (
                NormalDescription::Line(law),
                Self::Point { restitution, materials, .. } | Self::Line { restitution, materials, .. },
            ) => Ok(Self::Line { law, loss: named_loss.unwrap_or(law.default_damping), restitution, materials }),
            (NormalDescription::Point(law), Self::GivenPoint { restitution, stiffness_n_m_n, exponent, .. }) => {
                Ok(Self::GivenPoint { law, restitution, stiffness_n_m_n, exponent })
            }
            (NormalDescription::Line(_), Self::GivenPoint { .. }) => Err(needs("youngs_modulus")),
            (NormalDescription::Linear(law), Self::Linear { law: own, stiffness_n_m, damping }) => {
                if own.has_given_damping() == law.has_given_damping() {
                    Ok(Self::Linear { law, stiffness_n_m, damping })
                } else {
                    Err(needs(loss_key(NormalDescription::Linear(law))))
                }
            }
            (NormalDescription::Linear(_), _) | (_, Self::Linear { .. }) => {
                Err(LawError::OtherStiffness { law: name, beside: self.name(), table: table.to_owned() })
            }
        }
    }

    /// The law that a point contact of long pins has where the file names none; `None` where the stiffness is given.
    pub(in crate::model) fn of_long_pins(&self) -> Option<Self> {
        let Self::Point { restitution, materials, .. } = *self else { return None };
        Some(Self::Line { law: LONG_PIN_LAW, loss: LONG_PIN_LAW.default_damping, restitution, materials })
    }

    /// The name used in model files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Point { law, .. } | Self::GivenPoint { law, .. } => law.name,
            Self::Line { law, .. } => law.name,
            Self::Linear { law, .. } => law.name,
        }
    }

    /// The materials from which the stiffness comes; `None` where it is given.
    pub fn materials(&self) -> Option<&Materials> {
        match self {
            Self::Point { materials, .. } | Self::Line { materials, .. } => Some(materials),
            Self::GivenPoint { .. } | Self::Linear { .. } => None,
        }
    }

    /// The law of a line contact; `None` of others.
    pub fn line(&self) -> Option<&'static LineLaw> {
        if let Self::Line { law, .. } = self { Some(law) } else { None }
    }

    /// The point-contact law whose χ is the energy loss: the law itself, or the one beside a line-contact law. `None` of a linear law.
    pub fn loss(&self) -> Option<&'static PointLaw> {
        match self {
            Self::Point { law, .. } | Self::GivenPoint { law, .. } => Some(law),
            Self::Line { loss, .. } => Some(loss),
            Self::Linear { .. } => None,
        }
    }

    /// The nominal restitution; `None` where the damping coefficient is given.
    pub fn restitution(&self) -> Option<QuantityId> {
        match *self {
            Self::Point { restitution, .. } | Self::GivenPoint { restitution, .. } | Self::Line { restitution, .. } => {
                Some(restitution)
            }
            Self::Linear { law, damping, .. } => (!law.has_given_damping()).then_some(damping),
        }
    }

    /// The damping coefficient D where it is given.
    pub fn damping_coefficient(&self) -> Option<QuantityId> {
        match *self {
            Self::Linear { law, damping, .. } => law.has_given_damping().then_some(damping),
            _ => None,
        }
    }

    /// The restitution that a free impact delivers; `None` where it depends on the masses that meet.
    pub fn delivered_restitution(&self, values: &Values) -> Option<f64> {
        if let Self::Linear { law, damping, .. } = self {
            return law.delivered_restitution(values[*damping]);
        }
        // The identity of χ and ε holds for every elastic force.
        let (law, restitution) = self.loss().zip(self.restitution())?;
        Some(delivered_restitution((law.damping_factor)(values[restitution])))
    }
}

/// The key of the damping coefficient.
const DAMPING_COEFFICIENT: &str = "damping_coefficient";

/// The key of the energy loss.
fn loss_key(law: NormalDescription) -> &'static str {
    match law {
        NormalDescription::Linear(law) if law.has_given_damping() => DAMPING_COEFFICIENT,
        _ => "restitution",
    }
}

/// The keys that mean nothing beside a law.
fn keys_of_other_laws(law: NormalDescription) -> Vec<&'static str> {
    match law {
        NormalDescription::Point(_) => vec!["damping", DAMPING_COEFFICIENT],
        NormalDescription::Line(_) => vec!["stiffness", "exponent", DAMPING_COEFFICIENT],
        NormalDescription::Linear(law) => {
            let loss = if law.has_given_damping() { "restitution" } else { DAMPING_COEFFICIENT };
            material_keys().chain(["exponent", "density", "damping", loss]).collect()
        }
    }
}

impl Choice for NormalDescription {
    fn choices() -> Vec<(&'static str, Self)> {
        Self::all().map(|law| (law.name(), law)).collect()
    }
}

impl Choice for &'static PointLaw {
    fn choices() -> Vec<(&'static str, Self)> {
        POINT_LAWS.iter().map(|law| (law.name, law)).collect()
    }
}

record! {
    /// the normal force law of a contact
    pub(super) struct LawTable for EntryReader;
    /// the normal force law; if omitted: johnson if all joints with this contact are pins with a bearing_length and the stiffness comes
    /// from materials, otherwise lankarani-nikravesh
    optional law: Option<NormalDescription> = choice::<NormalDescription>(), "\"lankarani-nikravesh\"";
    /// nominal coefficient of restitution, in (0, 1]
    optional restitution: Entry<'t> = quantity(D::NUMBER, Rule::Restitution), "0.9";
    /// the point-contact law from which a line-contact law takes its energy loss; if omitted: lankarani-nikravesh, or zhiying-qishao for
    /// bai-zhao
    optional damping: Entry<'t> = choice::<&'static PointLaw>(), "\"flores\"";
    /// damping coefficient D of kelvin-voigt, instead of the restitution
    optional damping_coefficient: Entry<'t> = quantity(D::DAMPING, Rule::NonNegative), "\"900 N s/m\"";
    include materials: MaterialTable<'t>;
    /// stiffness K of F = K x^n, instead of materials; a linear law has n = 1 and K in N/m
    optional stiffness: Entry<'t> = Kind::Stiffness, "\"6.6e10 N/m^1.5\"";
    /// exponent n of F = K x^n, together with stiffness
    optional exponent: Entry<'t> = quantity(D::NUMBER, Rule::AtLeastOne), "1.5";
}

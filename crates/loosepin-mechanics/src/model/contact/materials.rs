//! The materials of bearing and journal, from which the stiffness of their contact follows.

use crate::contact::compliance_1_pa;
use crate::model::entry_reader::EntryReader;
use crate::model::problem::ModelProblem;
use crate::model::quantity::{QuantityId, Values};
use loosepin_text::document::{Key, Table, optional, quantity};
use loosepin_text::units::{Dimension as D, Rule};

const YOUNGS_MODULUS: [&str; 3] = ["youngs_modulus", "bearing_youngs_modulus", "journal_youngs_modulus"];
const POISSON_RATIO: [&str; 3] = ["poisson_ratio", "bearing_poisson_ratio", "journal_poisson_ratio"];

/// Names of all keys of materials.
pub(super) fn material_keys() -> impl Iterator<Item = &'static str> {
    YOUNGS_MODULUS.into_iter().chain(POISSON_RATIO)
}

/// Materials of the two parts that touch; order: bearing, journal.
#[derive(Debug, Clone, Copy)]
pub struct Materials {
    /// Young's moduli E_i, E_j, Pa, > 0.
    pub youngs_modulus_pa: [QuantityId; 2],
    /// Poisson's ratios ν_i, ν_j in [0, 0.5].
    pub poisson_ratio: [QuantityId; 2],
}

impl Materials {
    /// Reads them from the table of a contact; `None` after a complaint.
    pub(super) fn read(table: &Table<'_>, reader: &mut dyn EntryReader) -> Option<Self> {
        if !material_keys().any(|key| table.has(key)) {
            reader.document().demand(table, YOUNGS_MODULUS[0]);
            reader.document().demand(table, POISSON_RATIO[0]);
            return None;
        }
        let youngs_modulus_pa = of_both_parts(table, YOUNGS_MODULUS, reader);
        let poisson_ratio = of_both_parts(table, POISSON_RATIO, reader);
        Some(Self { youngs_modulus_pa: youngs_modulus_pa?, poisson_ratio: poisson_ratio? })
    }

    /// Compliances (1 - ν²)/E of bearing and journal, 1/Pa.
    pub fn compliances_1_pa(&self, values: &Values) -> [f64; 2] {
        [0, 1].map(|side| compliance_1_pa(values[self.youngs_modulus_pa[side]], values[self.poisson_ratio[side]]))
    }
}

/// A material value for bearing and journal: one key for both, or one each.
fn of_both_parts(table: &Table<'_>, keys: [&'static str; 3], reader: &mut dyn EntryReader) -> Option<[QuantityId; 2]> {
    let [both, bearing, journal] = keys;
    let [for_both, of_bearing, of_journal] = keys.map(|key| reader.quantity(table, key));
    let one = [bearing, journal].into_iter().find(|key| table.has(key));
    match (table.has(both), one) {
        (true, Some(one)) => {
            let span = table.get(one).map_or(table.span, |entry| entry.key_span);
            let problem = ModelProblem::MaterialTwice { entry: table.path.describe(), both, one };
            reader.document().refuse(&problem, span)
        }
        (true, None) => for_both.map(|id| [id, id]),
        (false, Some(one)) => {
            let missing: Vec<&'static str> = [bearing, journal].into_iter().filter(|key| !table.has(key)).collect();
            if missing.is_empty() {
                return of_bearing.zip(of_journal).map(|(bearing, journal)| [bearing, journal]);
            }
            reader.complain_of_missing(table, one, missing);
            None
        }
        (false, None) => {
            // The other material value is there, or we would not be here.
            let other = if both == YOUNGS_MODULUS[0] { POISSON_RATIO } else { YOUNGS_MODULUS };
            let key = other.into_iter().find(|key| table.has(key)).unwrap_or(other[0]);
            reader.complain_of_missing(table, key, vec![both]);
            None
        }
    }
}

pub(super) const MATERIAL_KEYS: [Key; 6] = [
    optional(
        YOUNGS_MODULUS[0],
        quantity(D::PRESSURE, Rule::Positive),
        "\"207 GPa\"",
        "Young's modulus of bearing and journal",
    ),
    optional(YOUNGS_MODULUS[1], quantity(D::PRESSURE, Rule::Positive), "\"110 GPa\"", "Young's modulus of the bearing"),
    optional(YOUNGS_MODULUS[2], quantity(D::PRESSURE, Rule::Positive), "\"207 GPa\"", "Young's modulus of the journal"),
    optional(
        POISSON_RATIO[0],
        quantity(D::NUMBER, Rule::PoissonRatio),
        "0.3",
        "Poisson's ratio of bearing and journal",
    ),
    optional(POISSON_RATIO[1], quantity(D::NUMBER, Rule::PoissonRatio), "0.34", "Poisson's ratio of the bearing"),
    optional(POISSON_RATIO[2], quantity(D::NUMBER, Rule::PoissonRatio), "0.3", "Poisson's ratio of the journal"),
];

//! The materials of bearing and journal, from which the stiffness of their contact follows.

use crate::contact::compliance_1_pa;
use crate::model::entry_reader::EntryReader;
use crate::model::problem::ModelProblem;
use loosepin_text::document::{Entry, Table, quantity};
use loosepin_text::numbers::{QuantityId, Values};
use loosepin_text::record;
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
    /// Reads them from the table of a contact; `None` after a diagnostic.
    pub(super) fn read(own: &MaterialTable<'_>, reader: &mut dyn EntryReader) -> Option<Self> {
        let moduli = [&own.youngs_modulus, &own.bearing_youngs_modulus, &own.journal_youngs_modulus];
        let ratios = [&own.poisson_ratio, &own.bearing_poisson_ratio, &own.journal_poisson_ratio];
        let first = |keys: [&'static str; 3]| keys.into_iter().find(|key| own.table.has(key)).unwrap_or(keys[0]);
        if moduli.iter().chain(&ratios).all(|entry| entry.is_none()) {
            reader.document().demand(&own.table, YOUNGS_MODULUS[0]);
            reader.document().demand(&own.table, POISSON_RATIO[0]);
            return None;
        }
        let youngs_modulus_pa = of_both_parts(&own.table, YOUNGS_MODULUS, moduli, first(POISSON_RATIO), reader);
        let poisson_ratio = of_both_parts(&own.table, POISSON_RATIO, ratios, first(YOUNGS_MODULUS), reader);
        Some(Self { youngs_modulus_pa: youngs_modulus_pa?, poisson_ratio: poisson_ratio? })
    }

    /// Compliances (1 - ν²)/E of bearing and journal, 1/Pa.
    pub fn compliances_1_pa(&self, values: &Values) -> [f64; 2] {
        [0, 1].map(|side| compliance_1_pa(values[self.youngs_modulus_pa[side]], values[self.poisson_ratio[side]]))
    }
}

/// A material value for bearing and journal: one key for both, or one each. `other` is a key of the other value.
fn of_both_parts(
    table: &Table<'_>,
    [both, bearing, journal]: [&'static str; 3],
    entries: [&Option<Entry<'_>>; 3],
    other: &'static str,
    reader: &mut dyn EntryReader,
) -> Option<[QuantityId; 2]> {
    let [for_both, of_bearing, of_journal] = entries.map(|entry| reader.quantity_at(entry.as_ref()?));
    let (key, missing) = match entries {
        [Some(_), None, None] => return for_both.map(|id| [id, id]),
        [None, Some(_), Some(_)] => return of_bearing.zip(of_journal).map(|(bearing, journal)| [bearing, journal]),
        [Some(_), of_bearing, of_journal] => {
            let one = if of_bearing.is_some() { bearing } else { journal };
            let span = of_bearing.as_ref().or(of_journal.as_ref()).map_or(table.span, |entry| entry.key_span);
            let problem = ModelProblem::MaterialTwice { entry: table.path.describe(), both, one };
            return reader.document().refuse(&problem, span);
        }
        [None, Some(_), None] => (bearing, journal),
        [None, None, Some(_)] => (journal, bearing),
        [None, None, None] => (other, both),
    };
    reader.report_missing(table, key, vec![missing]);
    None
}

record! {
    /// the materials of both parts
    pub(super) struct MaterialTable for EntryReader;
    /// Young's modulus of bearing and journal
    optional youngs_modulus: Entry<'t> = quantity(D::PRESSURE, Rule::Positive), "\"207 GPa\"";
    /// Young's modulus of the bearing
    optional bearing_youngs_modulus: Entry<'t> = quantity(D::PRESSURE, Rule::Positive), "\"110 GPa\"";
    /// Young's modulus of the journal
    optional journal_youngs_modulus: Entry<'t> = quantity(D::PRESSURE, Rule::Positive), "\"207 GPa\"";
    /// Poisson's ratio of bearing and journal
    optional poisson_ratio: Entry<'t> = quantity(D::NUMBER, Rule::PoissonRatio), "0.3";
    /// Poisson's ratio of the bearing
    optional bearing_poisson_ratio: Entry<'t> = quantity(D::NUMBER, Rule::PoissonRatio), "0.34";
    /// Poisson's ratio of the journal
    optional journal_poisson_ratio: Entry<'t> = quantity(D::NUMBER, Rule::PoissonRatio), "0.3";
}

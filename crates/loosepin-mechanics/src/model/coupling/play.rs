//! The play of couplings: backlash between the flanks of teeth, and followers that may lift off.

use super::reading::CouplingReader;
use crate::model::ids::ContactId;
use crate::model::joint::PlayKeys;
use crate::model::words::part_names::Names;
use loosepin_text::document::{Entry, Kind, Table, quantity};
use loosepin_text::numbers::QuantityId;
use loosepin_text::record;
use loosepin_text::units::{Dimension as D, Rule};

/// The play of a coupling: contact in place of the relation of both coordinates.
#[derive(Debug, Clone, Copy)]
pub struct CouplingPlay {
    /// Backlash j, m, >= 0; zero makes the coupling ideal. None of a follower that may lift off its cam.
    pub backlash_m: Option<QuantityId>,
    /// Radius on which the angle of the second joint counts as a length, m; `None` if its coordinate is a length.
    pub second_radius_m: Option<QuantityId>,
    /// The contact between the flanks, or between cam and follower.
    pub contact: ContactId,
}

impl CouplingPlay {
    /// `play: backlash 0.1 mm`.
    pub fn words(&self, names: &dyn Names) -> String {
        match self.backlash_m {
            Some(backlash_m) => format!("play: backlash {}", names.length(backlash_m)),
            None => "play: the follower may lift off".to_owned(),
        }
    }
}

record! {
    /// the play between the flanks of teeth
    pub(super) struct BacklashTable for CouplingReader;
    /// distance between the flanks along the pitch circles; none if zero or omitted
    optional backlash: Entry<'t> = quantity(D::LENGTH, Rule::NonNegative), "\"0.1 mm\"";
    /// contact between the flanks; needed with a backlash above zero
    optional contact: Option<ContactId> = Kind::Reference("contact"), "\"teeth\"";
}

/// Backlash and contact as a table states them.
pub(super) struct Backlash {
    contact: Option<Option<ContactId>>,
    /// The outer option is absent after a diagnostic, the inner for an ideal coupling.
    backlash_m: Option<Option<QuantityId>>,
}

impl Backlash {
    /// Reads both keys.
    pub fn read(own: &BacklashTable<'_>, reader: &mut dyn CouplingReader) -> Self {
        const KEYS: PlayKeys =
            PlayKeys { clearance: "backlash", needed: &["contact"], with_contact: &[], beside: &["contact"] };
        Self { contact: own.contact, backlash_m: reader.play_clearance(&own.table, &KEYS) }
    }

    /// Whether there is a backlash, be it zero.
    pub fn is_stated(&self) -> bool {
        self.backlash_m.flatten().is_some()
    }

    /// The same after a diagnostic about it.
    pub fn refused(self) -> Self {
        Self { backlash_m: None, ..self }
    }

    /// The play between flanks; the outer option is absent after a diagnostic, the inner for an ideal coupling.
    pub fn between_flanks(
        self,
        table: &Table<'_>,
        second_radius_m: Option<QuantityId>,
        reader: &mut dyn CouplingReader,
    ) -> Option<Option<CouplingPlay>> {
        let Some(backlash_m) = self.backlash_m? else { return Some(None) };
        let contact = self.contact.unwrap_or_else(|| Some(reader.no_contact()))?;
        reader.demand_contact_of_flanks(table, contact, "the flanks of teeth")?;
        Some(Some(CouplingPlay { backlash_m: Some(backlash_m), second_radius_m, contact }))
    }
}

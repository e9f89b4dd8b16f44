//! The reader of a model, as far as contacts, couplings and motions know it, beside what joints know.

use super::joint::JointReader;
use loosepin_text::document::Entry;
use loosepin_text::numbers::QuantityId;
use loosepin_text::units::{Dimension, Rule};

/// A column of a table of points: its name in paths, and its dimension.
pub type Column = (&'static str, Dimension);

/// The reader of a model. What returns nothing has reported.
pub trait EntryReader: JointReader {
    /// A number that neither a study nor a setting may change, with its value.
    fn fixed_number(&mut self, entry: &Entry<'_>, rule: Rule) -> Option<(QuantityId, f64)>;

    /// The points of a table that has either `points` or `csv`, which are given in this order, arguments increasing; at least three.
    fn table_points(&mut self, given: [&Option<Entry<'_>>; 2], columns: [Column; 2]) -> Option<Vec<[QuantityId; 2]>>;
}

//! Reader of a motion, beyond that of couplings.

use crate::model::entry_reader::EntryReader;
use crate::model::values::function::Changing;
use loosepin_text::document::Entry;
use loosepin_text::units::Dimension;

/// The reader of a model, as far as motions know it. What returns nothing has reported.
pub trait DriveReader: EntryReader {
    /// An expression over parameters and the time.
    fn over_time(&mut self, entry: &Entry<'_>, dimension: Dimension) -> Option<Changing>;
}

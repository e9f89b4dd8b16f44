//! The key of tables of points.

use loosepin_text::document::{Key, Kind, optional};

/// The key of a table in a file of its own.
pub(in crate::model) const CSV: Key = optional(
    "csv",
    Kind::Text,
    "\"profile.csv\"",
    "a CSV file in place of points, its path from the folder of this file; two columns, with their units in the header: time [s], angle [deg]",
);

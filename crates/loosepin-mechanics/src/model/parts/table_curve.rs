//! Tables of points: their keys, and the curves through the points.

use loosepin_text::choices;
use loosepin_text::document::{Key, Kind, optional};

/// How a curve goes between its points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TableCurve {
    /// Nowhere beyond the points on both sides; its slope does not jump.
    Monotone,
    /// A cubic spline: its curvature does not jump either.
    Spline,
}

choices!(TableCurve: "monotone" => Self::Monotone, "spline" => Self::Spline);

/// Value of `points`: pairs.
pub(in crate::model) const POINTS: Kind = Kind::List(&Kind::List(&Kind::AnyQuantity));

/// The key of a table in a file of its own.
pub(in crate::model) const CSV: Key = optional(
    "csv",
    Kind::Text,
    "\"profile.csv\"",
    "a CSV file instead of points, relative to the folder of this file; two columns, with their units in the header: time [s], angle [deg]",
);

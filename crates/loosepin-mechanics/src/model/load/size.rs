//! How the size of a load is written: constant, over time or the motion of a joint, or by points.

use super::course::TimeCourse;
use crate::model::part_reader::{DeferredQuantity, PartReader};
use crate::model::parts::table_curve::{CSV, TableCurve};
use loosepin_text::document::{Entry, Key, Kind, Table, choice, optional, quantity};
use loosepin_text::numbers::QuantityId;
use loosepin_text::record;
use loosepin_text::units::{Dimension, Rule};

/// The keys under which a kind of load has its size.
#[derive(Debug, Clone, Copy)]
pub struct SizeKeys {
    /// The key of the size itself.
    pub key: &'static str,
    /// Its dimension.
    pub dimension: Dimension,
    /// Reads the table of a size that goes up and down; `None` after a diagnostic.
    pub harmonic: fn(&mut dyn PartReader, &Entry<'_>) -> Option<TimeCourse>,
}

/// The size of a load as it stands in a table.
pub struct SizeTable<'t> {
    /// The table of the load.
    pub table: Table<'t>,
    /// The size itself.
    pub size: Option<Entry<'t>>,
    /// The joint whose motion it is over.
    pub joint: Option<Entry<'t>>,
    /// Points in place of the size.
    pub points: Option<Entry<'t>>,
    /// Further keys of loads on points.
    pub(in crate::model) rest: PointsOfLoad<'t>,
    /// Area and back pressure, of a kind whose points may be pressures.
    pub pressures: Option<(Option<Entry<'t>>, DeferredQuantity<'t>)>,
}

record! {
    /// frequency and phase of a harmonic load
    pub(super) struct Oscillation for PartReader;
    /// oscillations per second
    required frequency: QuantityId = quantity(Dimension::FREQUENCY, Rule::Positive), "\"20 Hz\"";
    /// phase at time zero; at 0 the load passes its mean upwards
    optional phase: QuantityId = quantity(Dimension::ANGLE, Rule::Finite), "\"90 deg\"", or "0 deg";
}

pub(super) const JOINT: Key = optional(
    "joint",
    Kind::Reference("joint"),
    "\"main\"",
    "the joint whose angle (or position) and speed are the variables of the expression or of the table",
);

/// The words for what a table is over.
pub(in crate::model) const ARGUMENTS: [&str; 4] = ["time", "angle", "position", "speed"];

record! {
    /// the options of a load given by points
    pub(in crate::model) struct PointsOfLoad for PartReader;
    optional csv: Entry<'t> as CSV;
    /// needed with points or csv: the variable in the first column: time, or angle, position or speed of the joint
    optional of: Entry<'t> = Kind::Choice(&ARGUMENTS), "\"angle\"";
    /// with points or csv: period after which the table repeats; if omitted, the first and the last value continue outside the table
    optional period: Entry<'t> = Kind::AnyQuantity, "\"720 deg\"";
    /// with points or csv: monotone: between two points, no value outside theirs; spline: smoother, but it may overshoot
    optional curve: Option<TableCurve> = choice::<TableCurve>(), "\"spline\"", or "monotone";
}

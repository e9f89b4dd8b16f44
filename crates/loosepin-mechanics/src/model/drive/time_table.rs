//! A table of times and coordinates.

use super::kind::{KindOfDrive, MotionLaw, MotionTable, Period, TimeDual, Written, kind};
use super::reading::DriveReader;
use super::table_motion::{AtTime, TableMotion, TablePiece, polynomial_at};
use crate::model::keys::table::CSV;
use crate::model::part_names::Names;
use crate::model::quantity::QuantityId;
use loosepin_math::Real;
use loosepin_text::document::{Keys, Kind, Table, optional, required};
use loosepin_text::units::Dimension;

/// A cubic spline.
#[derive(Debug, Clone)]
pub struct TimeTable {
    /// Times, s, increasing, and coordinates, rad or m; at least three.
    pub points: Vec<[QuantityId; 2]>,
    /// Whether it goes on with the same course, from where it ended; else it rests before and after.
    pub is_periodic: bool,
}

impl TimeTable {
    fn table<T: AtTime>(&self, number: &dyn Fn(QuantityId) -> T) -> TableMotion<T> {
        let points = self.points.iter().map(|[time, value]| [number(*time), number(*value)]).collect();
        TableMotion::new(points, self.is_periodic)
    }
}

impl KindOfDrive for TimeTable {
    type Motion<T: Real> = TablePiece<T>;

    const WORD: &'static str = "table";

    fn quantities(&self) -> Vec<QuantityId> {
        self.points.iter().flatten().copied().collect()
    }

    fn motion<T: AtTime>(&self, number: &dyn Fn(QuantityId) -> T, time_s: f64) -> TablePiece<T> {
        let table = self.table(number);
        table.piece(table.index(time_s))
    }

    fn words(&self, _names: &dyn Names) -> String {
        let how_often = if self.is_periodic { "again and again" } else { "once" };
        format!("by a table of {} points, {how_often}", self.points.len())
    }

    fn period(&self) -> Option<Period> {
        let ([first_s, _], [last_s, _]) = (self.points.first()?, self.points.last()?);
        self.is_periodic.then_some(Period::Between([*first_s, *last_s]))
    }

    fn pieces(&self, number: &dyn Fn(QuantityId) -> f64) -> Option<TableMotion<f64>> {
        Some(self.table(number))
    }
}

impl<T: Real> MotionLaw<T> for TablePiece<T> {
    #[inline(always)]
    fn at(&self, time_s: T, _room: &mut [TimeDual<T>]) -> [T; 3] {
        polynomial_at(self.origin_s, &self.coefficients, time_s)
    }
}

impl MotionTable for TimeTable {
    const KEYS: &'static Keys = &KEYS;

    fn read(table: &Table<'_>, dimension: Dimension, reader: &mut dyn DriveReader) -> Option<Written<Self>> {
        let ends = table.get("ends");
        let is_periodic =
            ends.and_then(|entry| reader.document().choice(&entry, &[("clamped", false), ("periodic", true)]));
        let points = reader.table_points(table, [("time", Dimension::TIME), ("position", dimension)])?;
        Some(Written::Motion(Self { points, is_periodic: is_periodic? }))
    }
}

static KEYS: Keys = Keys::new(
    "a cubic spline through points, whose acceleration does not jump between them",
    &[
        kind(&["table"], "\"table\""),
        optional(
            "points",
            Kind::List(&Kind::List(&Kind::AnyQuantity)),
            "[[\"0 s\", \"0 deg\"], [\"0.1 s\", \"40 deg\"], [\"0.3 s\", \"0 deg\"]]",
            "pairs of a time and the angle or position there, times increasing",
        ),
        required(
            "ends",
            Kind::Choice(&["clamped", "periodic"]),
            "\"clamped\"",
            "clamped: at rest before the first point and after the last; periodic: the same course again and again, each \
             time from where the last one ended",
        ),
        CSV,
    ],
)
.with_exactly_one(&[&["points", "csv"]]);

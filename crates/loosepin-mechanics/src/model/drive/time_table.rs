//! A table of times and coordinates.

use super::kind::{KindOfDrive, MotionLaw, MotionTable, Period, TimeDual, Written};
use super::reading::DriveReader;
use super::table_motion::{AtTime, TableMotion, TablePiece, polynomial_at};
use crate::model::parts::table_curve::{CSV, POINTS};
use crate::model::words::part_names::Names;
use loosepin_math::Real;
use loosepin_text::document::{Entry, Keys, Table, choice};
use loosepin_text::numbers::QuantityId;
use loosepin_text::units::Dimension;
use loosepin_text::{choices, record};

/// A cubic spline.
#[derive(Debug, Clone)]
pub struct TimeTable {
    /// Times, s, increasing, and coordinates, rad or m; at least three.
    pub points: Vec<[QuantityId; 2]>,
    /// Whether the motion is periodic, from its end; else it rests before and after.
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

    const WORD: &'static str = PointsTable::WORD;

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
    fn at(&self, time_s: T, _workspace: &mut [TimeDual<T>]) -> [T; 3] {
        polynomial_at(self.origin_s, &self.coefficients, time_s)
    }
}

impl MotionTable for TimeTable {
    const KEYS: &'static Keys = &PointsTable::KEYS;

    fn read(table: &Table<'_>, dimension: Dimension, reader: &mut dyn DriveReader) -> Option<Written<Self>> {
        let own = PointsTable::of(reader, table.clone())?;
        let points =
            reader.table_points([&own.points, &own.csv], [("time", Dimension::TIME), ("position", dimension)])?;
        own.ends.map(|IsPeriodic(is_periodic)| Written::Motion(Self { points, is_periodic }))
    }
}

choices!(
    /// Whether the motion is periodic.
    struct IsPeriodic(bool): "clamped" => false, "periodic" => true
);

record! {
    /// a cubic spline through points; its acceleration does not jump between them
    struct PointsTable for DriveReader, kind "table" of motion, exactly one of [points, csv];
    /// pairs of a time and the angle or position at that time; the times increase
    optional points: Entry<'t> = POINTS, "[[\"0 s\", \"0 deg\"], [\"0.1 s\", \"40 deg\"], [\"0.3 s\", \"0 deg\"]]";
    /// clamped: at rest before the first point and after the last; periodic: the motion repeats, and each period starts where the last
    /// one ended
    required ends: Option<IsPeriodic> = choice::<IsPeriodic>(), "\"clamped\"";
    optional csv: Entry<'t> as CSV;
}

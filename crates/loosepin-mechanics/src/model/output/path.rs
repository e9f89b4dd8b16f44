//! The path of a point.

use super::kind::{KindOfOutput, Measure, NoReading};
use super::position::{Relative, relative_point};
use super::reader::OutputReader;
use crate::model::ids::PointId;
use loosepin_text::document::{Kind, Table, optional};
use loosepin_text::units::Dimension;

/// Path of a point: two columns, x and y, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointPath {
    /// The point.
    pub point: Relative<PointId>,
}

impl KindOfOutput for PointPath {
    const MEASURES: &'static [Measure] = &[Measure {
        key: optional("path_of", Kind::Point, "\"coupler.tracer\"", "the path of a point: two columns"),
        beside: &["relative_to"],
    }];
    type Reading = NoReading;

    fn read(measure: &'static str, table: &Table<'_>, reader: &mut dyn OutputReader) -> Option<Self> {
        relative_point(reader, table, &table.get(measure)?).map(|point| Self { point })
    }

    fn dimension(&self) -> Dimension {
        Dimension::LENGTH
    }

    fn path(&self) -> Option<Relative<PointId>> {
        Some(self.point)
    }

    fn drawn_point(&self) -> Option<PointId> {
        Some(self.point.of)
    }
}

//! Outputs in files.

use super::kind::ModelOutputKind;
use crate::model::direction::DIRECTION;
use crate::model::parts::ModelOutput;
use crate::model::reader::SpaceReader;
use loosepin_text::document::{Entry, Kind};
use loosepin_text::numbers::ReadsNumbers;
use loosepin_text::record;

record! {
    /// what is read off a position
    pub(in crate::model) struct SpatialOutputTable for ReadsNumbers, exactly one of [position_of, path_of, turn_of, orientation_of],
        planned &[
            ("velocity_of", "outputs in space are positions and turns"),
            ("acceleration_of", "outputs in space are positions and turns"),
            ("angle_of", "give turn_of a body about an axis of it"),
            ("force_in", "there are no runs in space yet"),
            ("unit", "outputs in space are shown in units of their size"),
        ];
    /// the point whose place is read off, along a direction
    optional position_of: Entry<'t> = Kind::Point, "\"slider.pin\"";
    /// the point whose displacement from its ideal path is read off
    optional path_of: Entry<'t> = Kind::Point, "\"rod.tip\"";
    /// the body whose turn is read off, about an axis
    optional turn_of: Entry<'t> = Kind::Reference("body"), "\"rocker\"";
    /// the body whose rotation from its ideal orientation is read off, about whatever axis
    optional orientation_of: Entry<'t> = Kind::Reference("body"), "\"platform\"";
    /// direction of position_of in the frame of the ground: x, y, z, the name of an axis of the ground, or three numbers
    optional along: Entry<'t> = DIRECTION, "\"x\"";
    /// axis of turn_of in the frame of the body: x, y, z, the name of an axis of the body, or three numbers
    optional about: Entry<'t> = DIRECTION, "\"z\"";
}

impl SpaceReader {
    /// Reads the table of outputs.
    pub fn read_outputs(&mut self, entry: &Entry<'_>) -> Vec<ModelOutput> {
        let mut outputs = Vec::new();
        for entry in self.numbers.reader.named(entry, "an output") {
            self.numbers.remember(&entry);
            let kind = SpatialOutputTable::read(self, &entry).and_then(|own| self.output(&own));
            outputs.extend(kind.map(|kind| ModelOutput { name: entry.name.to_owned(), kind }));
        }
        outputs
    }

    fn output(&mut self, own: &SpatialOutputTable<'_>) -> Option<ModelOutputKind> {
        let table = &own.table;
        if let Some(point) = &own.position_of {
            self.numbers.refuse_beside(table, "about", "position_of");
            let point = self.point(point);
            let Some(along) = &own.along else {
                self.numbers.report_missing(table, "position_of", vec!["along"]);
                return None;
            };
            let along = self.direction(along, 0)?;
            return Some(ModelOutputKind::Position { point: point?, along });
        }
        let of = match own {
            SpatialOutputTable { path_of: Some(_), .. } => "path_of",
            SpatialOutputTable { orientation_of: Some(_), .. } => "orientation_of",
            _ => "turn_of",
        };
        self.numbers.refuse_beside(table, "along", of);
        if own.turn_of.is_none() {
            self.numbers.refuse_beside(table, "about", of);
        }
        if let Some(point) = &own.path_of {
            return Some(ModelOutputKind::Path { point: self.point(point)? });
        }
        let entry = own.orientation_of.as_ref().or(own.turn_of.as_ref())?;
        let name = self.numbers.reader.text(entry)?;
        let body = self.body(entry, name)?;
        if own.orientation_of.is_some() {
            return Some(ModelOutputKind::Orientation { body });
        }
        let Some(about) = &own.about else {
            self.numbers.report_missing(table, "turn_of", vec!["about"]);
            return None;
        };
        Some(ModelOutputKind::Turn { body, about: self.direction(about, body)? })
    }
}

//! Joints: which there are, each read by its kind.

use super::direction::Direction;
use super::marker::PointId;
use super::parts::ModelJoint;
use super::reader::SpaceReader;
use crate::kind::joint_reader::JointReader;
use crate::kind::{JOINT_KINDS, SpatialKind};
use loosepin_text::document::Entry;
use loosepin_text::numbers::EntryProblem;

impl SpaceReader {
    /// Reads the table of joints.
    pub fn read_joints(&mut self, entry: &Entry<'_>) {
        for entry in self.numbers.reader.named(entry, "a joint") {
            self.numbers.remember(&entry);
            let number = self.read_joint(&entry).map(|joint| {
                self.joints.push(joint);
                self.joints.len() - 1
            });
            self.joint_names.push((entry.name.to_owned(), number));
        }
    }

    fn read_joint(&mut self, entry: &Entry<'_>) -> Option<ModelJoint> {
        let (word, table) = self.numbers.table_of_kind(entry, JOINT_KINDS)?;
        let read = SpatialKind::read(word, table, self)?;
        let [bearing, journal] = read.markers;
        if bearing.point.body == journal.point.body {
            let body = self.bodies[bearing.point.body].name.clone();
            let problem = EntryProblem::SameBody { entry: entry.path.describe(), body };
            return self.numbers.reader.refuse(&problem, entry.key_span);
        }
        let (kind, numbers, play) = (read.kind, read.numbers, read.play);
        Some(ModelJoint { name: entry.name.to_owned(), kind, numbers, bearing, journal, play })
    }
}

impl JointReader for SpaceReader {
    fn point(&mut self, entry: &Entry<'_>) -> Option<PointId> {
        self.point(entry)
    }

    fn direction(&mut self, entry: &Entry<'_>, body: usize) -> Option<Direction> {
        self.direction(entry, body)
    }
}

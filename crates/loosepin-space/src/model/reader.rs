//! A model in space being read: its parts so far, and the reader of points, directions and names.

use super::direction::{Direction, NUMBERS};
use super::marker::PointId;
use super::parts::{ModelBody, ModelDrive, ModelJoint};
use super::problem::{SpatialModelProblem, hint_of_needs};
use loosepin_text::diagnostics::{Diagnostic, Source, nearest_name};
use loosepin_text::document::{Entry, Kind, Reader, Reads};
use loosepin_text::numbers::{EntryProblem, NameTable, NumberReader, ReadsNumbers};
use loosepin_text::record;
use loosepin_text::units::Dimension;
use std::collections::HashSet;
use std::sync::Arc;

/// A model in the making.
pub(super) struct SpaceReader {
    pub numbers: NumberReader,
    pub bodies: Vec<ModelBody>,
    /// Bodies whose points could not be read.
    pub without_points: HashSet<usize>,
    pub joint_names: NameTable<usize>,
    pub joints: Vec<ModelJoint>,
    pub drive_names: NameTable<usize>,
    pub drives: Vec<ModelDrive>,
    pub warnings: Vec<Diagnostic>,
}

impl Reads for SpaceReader {
    fn document(&mut self) -> &mut Reader {
        &mut self.numbers.reader
    }
}

impl ReadsNumbers for SpaceReader {
    fn numbers(&mut self) -> &mut NumberReader {
        &mut self.numbers
    }
}

record! {
    /// a direction from one point of the body to another
    struct BetweenTable for ReadsNumbers;
    /// the point where it begins
    required from: Entry<'t> = Kind::Reference("point"), "\"a\"";
    /// the point that it goes to
    required to: Entry<'t> = Kind::Reference("point"), "\"b\"";
}

/// A named axis of a body.
pub(super) const NAMED_AXIS: Kind = Kind::AnyOf(&[Kind::Text, NUMBERS, Kind::Table(&BetweenTable::KEYS)]);

impl SpaceReader {
    pub fn new(source: &Arc<Source>) -> SpaceReader {
        let ground = ModelBody {
            name: "ground".to_owned(),
            mass_kg: None,
            centre_of_mass_m: None,
            inertia_kg_m2: Vec::new(),
            points: Vec::new(),
            axes: Vec::new(),
        };
        SpaceReader {
            numbers: NumberReader::new(source, hint_of_needs),
            bodies: vec![ground],
            without_points: HashSet::new(),
            joint_names: Vec::new(),
            joints: Vec::new(),
            drive_names: Vec::new(),
            drives: Vec::new(),
            warnings: Vec::new(),
        }
    }

    /// The body called `name`.
    pub fn body(&mut self, entry: &Entry<'_>, name: &str) -> Option<usize> {
        let found = self.bodies.iter().position(|body| body.name == name);
        if found.is_none() {
            let known = self.bodies.iter().map(|body| format!("'{}'", body.name)).collect();
            let nearest = nearest_name(name, self.bodies.iter().map(|body| body.name.as_str())).map(str::to_owned);
            self.numbers.unknown(entry, "body", name, nearest, known);
        }
        found
    }

    /// The point that an entry names as `body.point`.
    pub fn point(&mut self, entry: &Entry<'_>) -> Option<PointId> {
        let text = self.numbers.reader.text(entry)?;
        let Some((body_name, point_name)) = text.split_once('.') else {
            let problem = EntryProblem::NotAPoint { entry: entry.path.describe(), text: text.to_owned() };
            return self.numbers.reader.refuse(&problem, entry.span);
        };
        let body = self.body(entry, body_name)?;
        let point = self.point_of(entry, body, point_name, text)?;
        Some(PointId { body, point })
    }

    /// The point `name` of a body; `text` is how the file names it.
    pub fn point_of(&mut self, entry: &Entry<'_>, body: usize, name: &str, text: &str) -> Option<usize> {
        let own = self.bodies.get(body)?;
        let found = own.points.iter().position(|point| point.name == name);
        // Points that could not be read have a diagnostic already.
        if found.is_none() && !self.without_points.contains(&body) {
            let prefix = text.strip_suffix(name).unwrap_or_default();
            let known = own.points.iter().map(|point| format!("'{prefix}{}'", point.name)).collect();
            let nearest = nearest_name(name, own.points.iter().map(|point| point.name.as_str()));
            let nearest = nearest.map(|nearest| format!("{prefix}{nearest}"));
            self.numbers.unknown(entry, "point", text, nearest, known);
        }
        found
    }

    /// The direction at an entry, in the frame of a body.
    pub fn direction(&mut self, entry: &Entry<'_>, body: usize) -> Option<Direction> {
        if !entry.is_text() {
            return self.numbers.three(entry, Dimension::NUMBER).map(Direction::Numbers);
        }
        let name = self.numbers.reader.text(entry)?;
        self.axis_called(name, entry, body)
    }

    /// The axis `name` in the frame of a body: x, y, z, or one that the body names.
    pub fn axis_called(&mut self, name: &str, entry: &Entry<'_>, body: usize) -> Option<Direction> {
        let own = self.bodies.get(body)?;
        let named = own.axes.iter().find(|(own, _)| own == name).map(|(_, direction)| *direction);
        if let Some(direction) = Direction::from_word(name).or(named) {
            return Some(direction);
        }
        let problem = SpatialModelProblem::UnknownAxis {
            entry: entry.path.describe(),
            body: own.name.clone(),
            name: name.to_owned(),
            known: own.axes.iter().map(|(name, _)| name.clone()).collect(),
        };
        self.numbers.reader.refuse(&problem, entry.span)
    }

    /// The named axis at an entry, in the frame of a body whose points are read.
    pub fn named_axis(&mut self, entry: &Entry<'_>, body: usize) -> Option<Direction> {
        if !entry.is_table() {
            return self.direction(entry, body);
        }
        let BetweenTable { from, to, .. } = BetweenTable::read(self, entry)?;
        let [from, to] = [from, to].map(|end| {
            let name = self.numbers.reader.text(&end)?;
            let point = self.point_of(&end, body, name, name)?;
            self.bodies.get(body)?.points.get(point).map(|point| point.position_m)
        });
        Some(Direction::Between([from?, to?]))
    }

    /// The joint at an entry, written `joint.NAME` or by its name alone.
    pub fn joint(&mut self, entry: &Entry<'_>) -> Option<usize> {
        let text = self.numbers.reader.text(entry)?;
        let name = text.strip_prefix("joint.").unwrap_or(text);
        self.numbers.named(entry, "joint", name, &self.joint_names)
    }
}

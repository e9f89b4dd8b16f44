//! Reading the initial state.

use super::reader::ModelReader;
use crate::model::ids::{Axis, BodyId, JointId};
use crate::model::initial::{InitialNumber, InitialOf, InitialOffset, InitialValue, OffsetPlace};
use crate::model::keys::{INITIAL_BODY_KEYS, INITIAL_JOINT_KEYS, INITIAL_KEYS};
use crate::model::problem::ModelProblem;
use crate::model::quantity::QuantityId;
use loosepin_text::document::{Entry, Table};
use loosepin_text::units::{Dimension, Rule};

/// Keys of positions and of their rates, with what both measure.
const COORDINATES: [(&str, bool, Dimension); 4] = [
    ("angle", false, Dimension::ANGLE),
    ("angular_velocity", true, Dimension::ANGULAR_VELOCITY),
    ("position", false, Dimension::LENGTH),
    ("velocity", true, Dimension::VELOCITY),
];

/// Keys of the place of a journal in its bearing.
const OFFSET_KEYS: [&str; 3] = ["offset", "offset_velocity", "start"];

impl ModelReader {
    /// Reads the initial state, and where journals are in their bearings.
    pub fn read_initial(&mut self, entry: &Entry<'_>) -> (Vec<InitialValue>, Vec<InitialOffset>) {
        let Some(table) = self.reader.table(entry, &INITIAL_KEYS) else { return Default::default() };
        self.remember(entry);
        let (mut values, mut offsets) = (Vec::new(), Vec::new());
        if let Some(bodies) = table.get("body") {
            for entry in self.reader.any_keys(&bodies) {
                self.initial_body(&entry, &mut values);
            }
        }
        if let Some(joints) = table.get("joint") {
            for entry in self.reader.any_keys(&joints) {
                self.initial_joint(&entry, &mut values, &mut offsets);
            }
        }
        (values, offsets)
    }

    fn initial_body(&mut self, entry: &Entry<'_>, values: &mut Vec<InitialValue>) {
        self.remember(entry);
        let table = self.reader.table(entry, &INITIAL_BODY_KEYS);
        let (Some(table), Some(body)) = (table, self.body(&entry.at_key(), entry.name)) else { return };
        if body == BodyId(0) {
            self.reader.complain(&ModelProblem::InitialOfGround, entry.key_span);
            return;
        }
        for (key, is_rate, dimension) in COORDINATES {
            let Some(entry) = table.get(key) else { continue };
            if matches!(key, "angle" | "angular_velocity") {
                self.initial_value(&entry, InitialOf::BodyAngle(body), is_rate, dimension, values);
                continue;
            }
            let Some(pair) = self.reader.pair(&entry) else { continue };
            for (mut element, (axis, name)) in pair.into_iter().zip([(Axis::X, "x"), (Axis::Y, "y")]) {
                element.path = entry.path.join(name);
                self.initial_value(&element, InitialOf::BodyPosition(body, axis), is_rate, dimension, values);
            }
        }
    }

    fn initial_joint(&mut self, entry: &Entry<'_>, values: &mut Vec<InitialValue>, offsets: &mut Vec<InitialOffset>) {
        self.remember(entry);
        let table = self.reader.table(entry, &INITIAL_JOINT_KEYS);
        let joint = self.named(&entry.at_key(), "joint", entry.name, |file| &file.joint_names);
        let (Some(table), Some(joint)) = (table, joint) else { return };
        offsets.extend(self.initial_offset(&table, joint));
        let Some(coordinate) = self.joints[joint.0].kind.coordinate() else {
            self.reader.complain(&self.does_not_move("initial".to_owned(), joint), entry.key_span);
            return;
        };
        let of = InitialOf::joint(joint, coordinate);
        for (key, is_rate, dimension) in COORDINATES {
            let fits = matches!(key, "angle" | "angular_velocity") == matches!(of, InitialOf::JointAngle(_));
            match table.get(key) {
                Some(entry) if fits => self.initial_value(&entry, of, is_rate, dimension, values),
                Some(entry) => self.refuse_coordinate(&table, &entry, key),
                None => {}
            }
        }
    }

    /// Where the journal of `joint` is in its bearing; nothing where that is not said.
    fn initial_offset(&mut self, table: &Table<'_>, joint: JointId) -> Option<InitialOffset> {
        let key = OFFSET_KEYS.into_iter().find(|key| table.has(key))?;
        let (entry, name) = (table.path.describe(), self.joints[joint.0].name.clone());
        let span = table.get(key).map_or(table.span, |entry| entry.key_span);
        if self.joints[joint.0].kind.pin_clearance().is_none() {
            return self.reader.refuse(&ModelProblem::OffsetWithoutPlay { entry, key, joint: name }, span);
        }
        let mut vector = |key: &str, dimension: Dimension| {
            let written = table.get(key)?;
            let pair = self.reader.pair(&written)?;
            let parts = pair.into_iter().zip(["x", "y"]).map(|(mut element, axis)| {
                element.path = written.path.join(axis);
                self.quantity_of(&element, dimension, Rule::Finite)
            });
            let parts = parts.collect::<Option<Vec<QuantityId>>>()?;
            <[QuantityId; 2]>::try_from(parts).ok()
        };
        let offset_m = vector("offset", Dimension::LENGTH);
        let velocity_m_s = vector("offset_velocity", Dimension::VELOCITY);
        let place = if table.has("start") {
            for key in ["offset", "offset_velocity"] {
                self.refuse_beside(table, key, "start");
            }
            self.reader.choice_or(table, "start", &[("resting", OffsetPlace::Resting)], OffsetPlace::Resting)?
        } else {
            OffsetPlace::Given { offset_m, velocity_m_s }
        };
        Some(InitialOffset { path: table.path.dotted(), joint, place })
    }

    fn refuse_coordinate(&mut self, table: &Table<'_>, entry: &Entry<'_>, key: &'static str) {
        let problem = ModelProblem::WrongCoordinate { entry: table.path.describe(), key };
        self.reader.complain(&problem, entry.key_span);
    }

    fn initial_value(
        &mut self,
        entry: &Entry<'_>,
        of: InitialOf,
        is_rate: bool,
        dimension: Dimension,
        values: &mut Vec<InitialValue>,
    ) {
        let value = self.quantity_of(entry, dimension, Rule::Finite);
        let number = value.map(InitialNumber::Given);
        values.extend(number.map(|number| InitialValue { path: entry.path.dotted(), of, is_rate, number }));
    }
}

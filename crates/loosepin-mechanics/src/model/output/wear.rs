//! The wear of a joint.

use super::kind::{KindOfOutput, Measure, NoReading};
use super::reader::{NeededKey, OutputReader, needed_choice};
use crate::model::ids::JointId;
use crate::model::parts::wear::WearMeasure;
use crate::model::problem::ModelProblem;
use loosepin_text::document::{Kind, Table, optional};
use loosepin_text::units::Dimension;

/// Wear of a joint after all cycles: one number of a run, without a history.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wear {
    /// The joint.
    pub joint: JointId,
    /// Which measure.
    pub measure: WearMeasure,
}

impl KindOfOutput for Wear {
    const MEASURES: &'static [Measure] = &[Measure {
        key: optional(
            "wear_of",
            Kind::Reference("joint"),
            "\"joint.gudgeon\"",
            "the wear of a joint after all cycles: one number for each run",
        ),
        beside: &["component"],
    }];
    const COMPONENTS: &'static [&'static str] = &WearMeasure::WORDS;
    type Reading = NoReading;

    fn read(measure: &'static str, table: &Table<'_>, reader: &mut dyn OutputReader) -> Option<Self> {
        const COMPONENT: NeededKey =
            NeededKey { key: "component", example: "\"bearing_volume\"", doc: "the measure of wear" };
        let measures = WearMeasure::ALL.map(|measure| (measure.word(), measure));
        let component = needed_choice(reader, table, &COMPONENT, &measures);
        let entry = table.get(measure)?;
        let joint = reader.joint(&entry)?;
        if !reader.wears(joint) {
            let problem = ModelProblem::DoesNotWear { entry: entry.path.describe(), joint: reader.joint_name(joint) };
            return reader.document().refuse(&problem, entry.span);
        }
        Some(Self { joint, measure: component? })
    }

    fn dimension(&self) -> Dimension {
        self.measure.dimension()
    }

    fn wear(&self) -> Option<(JointId, WearMeasure)> {
        Some((self.joint, self.measure))
    }
}

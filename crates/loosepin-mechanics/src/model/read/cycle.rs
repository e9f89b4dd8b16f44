//! Reading the cycle.

use super::reader::ModelReader;
use crate::model::drive::Drive;
use crate::model::ids::JointId;
use crate::model::part_reader::PartReader;
use crate::model::parts::cycle::{Cycle, CycleNumbers, CycleSpan};
use crate::model::problem::ModelProblem;
use loosepin_text::document::{Entry, Kind, quantity};
use loosepin_text::numbers::QuantityId;
use loosepin_text::record;
use loosepin_text::units::{Dimension, Rule};

record! {
    /// the turns to simulate and to record; a command can override every number
    pub(super) struct CycleTable for PartReader, exactly one of [drive, duration];
    /// the drive whose turns (constant speed) or periods (any other motion) are counted
    optional drive: Entry<'t> = Kind::Reference("drive"), "\"crank\"";
    /// the time that counts as one turn, instead of a drive; transient_turns is then 0 if omitted
    optional duration: QuantityId = quantity(Dimension::TIME, Rule::Positive), "\"0.2 s\"";
    include numbers: CycleNumbers<'t>;
}

impl ModelReader {
    /// Reads what is run and recorded.
    pub fn read_cycle(&mut self, entry: &Entry<'_>) -> Option<Cycle> {
        let CycleTable { drive, duration, numbers, .. } = CycleTable::read(self, entry)?;
        self.numbers.remember(entry);
        // A span of time has no turns to settle over.
        let no_transient = duration.is_some() && !numbers.table.has("transient_turns");
        let span = match duration {
            Some(duration) => CycleSpan::Duration(duration),
            None => self.counted_drive(&drive?)?,
        };
        let transient_turns = if no_transient { 0.0 } else { numbers.transient_turns? };
        let (recorded_turns, samples_per_turn) = (numbers.recorded_turns?, numbers.samples_per_turn?);
        Some(Cycle { span, transient_turns, recorded_turns, samples_per_turn })
    }

    fn counted_drive(&mut self, entry: &Entry<'_>) -> Option<CycleSpan> {
        let name = self.numbers.reader.text(entry)?;
        let drive = self.numbers.named(entry, "drive", name, &self.drive_names)?;
        let Drive { joint, law, .. } = &self.drives[drive.0];
        if law.period().is_some() {
            return Some(CycleSpan::Periods(drive));
        }
        let problem = if law.steady().is_none() {
            ModelProblem::CycleNeedsPeriod { drive: name.to_owned(), kind: law.word() }
        } else if !self.turns(*joint) {
            ModelProblem::CycleNeedsTurns { drive: name.to_owned() }
        } else {
            return Some(CycleSpan::Turns(drive));
        };
        self.numbers.reader.refuse(&problem, entry.span)
    }

    /// Whether a joint has an angle, whose turns can be counted.
    fn turns(&self, joint: JointId) -> bool {
        self.joints[joint.0].kind.turns()
    }
}

//! Reading the cycle.

use super::reader::ModelReader;
use crate::model::cycle::{Cycle, CycleSpan};
use crate::model::drive::Drive;
use crate::model::ids::JointId;
use crate::model::keys::CYCLE_KEYS;
use crate::model::problem::ModelProblem;
use loosepin_text::document::Entry;

/// Turns run before recording, where the file does not say.
const TRANSIENT_TURNS: f64 = 2.0;
/// Turns recorded, where the file does not say.
const RECORDED_TURNS: f64 = 1.0;
/// Rows recorded in a turn, where the file does not say.
const SAMPLES_PER_TURN: usize = 500;

impl ModelReader {
    /// Reads what is run and recorded.
    pub fn read_cycle(&mut self, entry: &Entry<'_>) -> Option<Cycle> {
        let table = self.reader.table(entry, &CYCLE_KEYS)?;
        self.remember(entry);
        // A span of time has no turns to settle over.
        let transient_turns = if table.has("duration") { 0.0 } else { TRANSIENT_TURNS };
        let transient_turns = self.reader.number(&table, "transient_turns").unwrap_or(transient_turns);
        let recorded_turns = self.reader.number(&table, "recorded_turns").unwrap_or(RECORDED_TURNS);
        let samples_per_turn =
            self.reader.count(&table, "samples_per_turn").map_or(SAMPLES_PER_TURN, |count| count as usize);
        let span = match table.get("duration") {
            Some(_) => CycleSpan::Duration(self.quantity(&table, "duration")?),
            None => self.counted_drive(&table.get("drive")?)?,
        };
        Some(Cycle { span, transient_turns, recorded_turns, samples_per_turn })
    }

    fn counted_drive(&mut self, entry: &Entry<'_>) -> Option<CycleSpan> {
        let name = self.reader.text(entry)?;
        let drive = self.named(entry, "drive", name, |file| &file.drive_names)?;
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
        self.reader.refuse(&problem, entry.span)
    }

    /// Whether a joint has an angle, whose turns can be counted.
    fn turns(&self, joint: JointId) -> bool {
        self.joints[joint.0].kind.turns()
    }
}

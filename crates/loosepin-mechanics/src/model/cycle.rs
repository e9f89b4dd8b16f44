//! What is run and recorded, and by what it is counted.

use super::drive::{Drive, DriveLaw};
use super::file::ModelReader;
use super::keys::CYCLE_KEYS;
use super::problem::ModelProblem;
use super::quantity::{QuantityId, Values};
use super::topology::{DriveId, JointId, JointKind, Model};
use loosepin_math::Real;
use loosepin_text::document::Entry;

/// Turns run before recording, where the file does not say.
const TRANSIENT_TURNS: f64 = 2.0;
/// Turns recorded, where the file does not say.
const RECORDED_TURNS: f64 = 1.0;
/// Rows recorded in a turn, where the file does not say.
const SAMPLES_PER_TURN: usize = 500;

/// What `simulate` runs and a study records.
#[derive(Debug, Clone)]
pub struct Cycle {
    /// What a turn is.
    pub span: CycleSpan,
    /// Turns run before recording, >= 0.
    pub transient_turns: f64,
    /// Turns recorded, > 0.
    pub recorded_turns: f64,
    /// Rows of the history per recorded turn, >= 1.
    pub samples_per_turn: usize,
}

/// What is counted as a turn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CycleSpan {
    /// A turn of a revolute drive at constant speed: 2π of its joint coordinate.
    Turns(DriveId),
    /// A period of the motion that a drive prescribes.
    Periods(DriveId),
    /// This time, s.
    Duration(QuantityId),
}

/// The input of a mechanism over its cycle: an angle that grows evenly with time, start + speed · t.
///
/// Where a drive turns at constant speed it is the angle of that drive; else the phase of the cycle, which grows by 2π over
/// a period or a duration.
#[derive(Debug, Clone, PartialEq)]
pub struct CycleInput {
    /// Name of the drive, or `cycle`.
    pub name: String,
    /// Whether it is the angle of a drive.
    pub is_drive: bool,
    /// At time zero, rad.
    pub start_rad: f64,
    /// rad/s; zero where the drive stands still.
    pub speed_rad_s: f64,
}

impl CycleInput {
    /// The angle at `time_s`, rad.
    pub fn angle_rad(&self, time_s: f64) -> f64 {
        self.start_rad + self.speed_rad_s * time_s
    }

    /// Duration of a turn, s.
    pub fn turn_s(&self) -> f64 {
        std::f64::consts::TAU / self.speed_rad_s.abs()
    }
}

/// What the phase of a cycle that counts no drive is called.
const PHASE: &str = "cycle";

impl Model {
    /// The input of the cycle that counts by `span`.
    pub fn input(&self, span: CycleSpan, values: &Values) -> CycleInput {
        if let CycleSpan::Turns(drive) = span
            && let Drive { name, law: DriveLaw::Constant { speed, start }, .. } = &self.drives[drive.0]
        {
            let (start_rad, speed_rad_s) = (values[*start], values[*speed]);
            return CycleInput { name: name.clone(), is_drive: true, start_rad, speed_rad_s };
        }
        let speed_rad_s =
            self.period_s(span, &|id| values[id]).map_or(0.0, |period_s| std::f64::consts::TAU / period_s);
        CycleInput { name: PHASE.to_owned(), is_drive: false, start_rad: 0.0, speed_rad_s }
    }

    /// The input of the model's own cycle.
    pub fn cycle_input(&self, values: &Values) -> CycleInput {
        self.input(self.cycle.span, values)
    }

    /// Duration of a period, s, with the numbers that `number` gives; none where the turns of a drive are counted.
    pub fn period_s<T: Real>(&self, span: CycleSpan, number: &dyn Fn(QuantityId) -> T) -> Option<T> {
        match span {
            CycleSpan::Turns(_) => None,
            CycleSpan::Duration(duration_s) => Some(number(duration_s)),
            CycleSpan::Periods(drive) => match &self.drives[drive.0].law {
                DriveLaw::Harmonic { frequency, .. } => Some(T::one() / number(*frequency)),
                DriveLaw::Table { points, .. } => {
                    let ([first, _], [last, _]) = (points.first()?, points.last()?);
                    Some(number(*last) - number(*first))
                }
                _ => None,
            },
        }
    }
}

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
        if law.has_period() {
            return Some(CycleSpan::Periods(drive));
        }
        let problem = if !matches!(law, DriveLaw::Constant { .. }) {
            ModelProblem::CycleNeedsPeriod { drive: name.to_owned(), kind: law.kind() }
        } else if !self.turns(*joint) {
            ModelProblem::CycleNeedsTurns { drive: name.to_owned() }
        } else {
            return Some(CycleSpan::Turns(drive));
        };
        self.reader.complain(&problem, entry.span);
        None
    }

    /// Whether a joint has an angle, whose turns can be counted.
    fn turns(&self, joint: JointId) -> bool {
        matches!(self.joints[joint.0].kind, JointKind::Revolute { .. })
    }
}

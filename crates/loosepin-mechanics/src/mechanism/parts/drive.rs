//! The motions that drives prescribe: position, velocity and acceleration of the driven coordinates.

use crate::model::{DriveId, DriveLaw, DriveMotion, Model, QuantityId, TableMotion, TimeDual, Values};
use loosepin_math::{Dual, Real, numbers};
use std::sync::Arc;

/// The motions of all drives of a model in one sample.
#[derive(Debug, Clone)]
pub struct Drives<T> {
    motions: Vec<DriveMotion<T>>,
    schedule: Arc<Schedule>,
}

numbers!(struct Drives { motions; schedule });

/// When motions that consist of pieces change from one to the next.
#[derive(Debug, Default)]
struct Schedule {
    /// Tables, with the indices of their drives.
    tables: Vec<(usize, TableMotion<f64>)>,
    /// Single breaks of other motions, s.
    breaks_s: Vec<f64>,
}

impl Drives<f64> {
    /// Lays out `values` for the drives of `model`, tables in their pieces at time zero.
    pub fn new(model: &Model, values: &Values) -> Self {
        Self::of_laws(model.drives.iter().map(|drive| &drive.law), values)
    }

    /// Lays out `values` for the references of the controls of `model`, in the same way.
    pub fn of_controls(model: &Model, values: &Values) -> Self {
        Self::of_laws(model.controls.iter().map(|control| &control.reference), values)
    }

    fn of_laws<'l>(laws: impl Iterator<Item = &'l DriveLaw>, values: &Values) -> Self {
        let number = |id: QuantityId| values[id];
        let mut motions = Vec::new();
        let mut schedule = Schedule::default();
        for (index, law) in laws.enumerate() {
            motions.push(law.motion(&number, 0.0));
            schedule.tables.extend(law.pieces(&number).map(|table| (index, table)));
            schedule.breaks_s.extend(law.breaks_s(&number));
        }
        Self { motions, schedule: Arc::new(schedule) }
    }

    /// The first time after `time_s` at which the pieces of a motion meet, s; infinite where there is none.
    pub fn next_break_s(&self, time_s: f64) -> f64 {
        let tables = self.schedule.tables.iter().map(|(_, table)| table.start_s(table.index(time_s) + 1));
        let single = self.schedule.breaks_s.iter().copied().filter(|at_s| *at_s > time_s);
        tables.chain(single).fold(f64::INFINITY, f64::min)
    }

    /// Puts every table into the piece that holds `time_s`. True where there are tables.
    pub fn take_pieces_at(&mut self, time_s: f64) -> bool {
        for (index, table) in &self.schedule.tables {
            self.motions[*index] = table.piece(table.index(time_s)).into();
        }
        self.has_pieces()
    }

    /// Whether any motion consists of pieces.
    pub fn has_pieces(&self) -> bool {
        !self.schedule.tables.is_empty()
    }

    /// Times and values of all tables: of their pieces only the present one is among the numbers that are shown.
    pub fn table_points(&self) -> impl Iterator<Item = f64> + '_ {
        self.schedule.tables.iter().flat_map(|(_, table)| table.points().iter().flatten().copied())
    }

    /// Position, velocity and acceleration of a drive at `time_s`, in the present piece.
    pub fn at(&self, model: &Model, drive: DriveId, time_s: f64) -> [f64; 3] {
        self.law_at(&model.drives[drive.0].law, drive.0, time_s)
    }

    /// Position, velocity and acceleration of the motion of index `index`, whose law is `law`.
    pub fn law_at(&self, law: &DriveLaw, index: usize, time_s: f64) -> [f64; 3] {
        self.motions[index].at(time_s, &mut vec![Dual::constant(Dual::constant(0.0)); law.workspace_length()])
    }

    /// The constant speed of a drive, m/s or rad/s; `None` for any other motion.
    pub fn constant_speed(&self, drive: DriveId) -> Option<f64> {
        self.motions[drive.0].constant_speed()
    }

    /// How fast the motion of index `index` changes between time zero and `end_s`, 1/s: its velocity over `scale`, and what its acceleration and
    /// its frequency say about it.
    pub fn pace_1_s(&self, law: &DriveLaw, index: usize, end_s: f64, scale: f64) -> f64 {
        /// Instants at which a motion without closed form is looked at.
        const LOOKS: u32 = 256;
        self.motions[index].pace_1_s(scale).unwrap_or_else(|| {
            let mut drives = self.clone();
            let looks = (0..=LOOKS).map(|k| {
                let time_s = end_s * f64::from(k) / f64::from(LOOKS);
                drives.take_pieces_at(time_s);
                let [_, rate, acceleration] = drives.law_at(law, index, time_s);
                (rate.abs() / scale).max((acceleration.abs() / scale).sqrt())
            });
            // Where it has no value the run will end.
            looks.filter(|pace| pace.is_finite()).fold(0.0, f64::max)
        })
    }
}

impl<T: Real> Drives<T> {
    /// Position, velocity and acceleration of a drive at `time_s`, in the present piece; `workspace` holds [`workspace_length`] numbers.
    #[inline(always)]
    pub fn motion(&self, drive: DriveId, time_s: T, workspace: &mut [TimeDual<T>]) -> [T; 3] {
        self.law_motion(drive.0, time_s, workspace)
    }

    /// Position, velocity and acceleration of the motion of index `index`.
    #[inline(always)]
    pub fn law_motion(&self, index: usize, time_s: T, workspace: &mut [TimeDual<T>]) -> [T; 3] {
        self.motions[index].at(time_s, workspace)
    }
}

/// Numbers that the functions of the drives and references of `model` need as room.
pub fn workspace_length(model: &Model) -> usize {
    let drives = model.drives.iter().map(|drive| drive.law.workspace_length());
    drives.chain(model.controls.iter().map(|control| control.reference.workspace_length())).max().unwrap_or(0)
}

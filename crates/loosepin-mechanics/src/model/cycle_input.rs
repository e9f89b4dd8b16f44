//! The input of a mechanism over its cycle.

use super::drive::{Drive, Steady};
use crate::model::parts::cycle::CycleSpan;
use crate::model::parts::topology::Model;
use loosepin_math::Real;
use loosepin_text::numbers::{QuantityId, Values};
use std::f64::consts::TAU;

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
        TAU / self.speed_rad_s.abs()
    }

    /// The place in the turn at which it has this angle, from 0 to 1.
    pub fn turn_at(&self, angle_rad: f64) -> f64 {
        (self.speed_rad_s.signum() * (angle_rad - self.start_rad) / TAU).rem_euclid(1.0)
    }

    /// The angle at a place in the turn, rad.
    pub fn angle_at_turn_rad(&self, turn: f64) -> f64 {
        self.start_rad + self.speed_rad_s.signum() * TAU * turn
    }
}

/// Name of the phase of a cycle that counts no drive.
const PHASE: &str = "cycle";

impl Model {
    /// The input of the cycle that counts by `span`.
    pub fn input(&self, span: CycleSpan, values: &Values) -> CycleInput {
        if let CycleSpan::Turns(drive) = span
            && let Drive { name, law, .. } = &self.drives[drive.0]
            && let Some(Steady { speed, start }) = law.steady()
        {
            let (start_rad, speed_rad_s) = (values[start], values[speed]);
            return CycleInput { name: name.clone(), is_drive: true, start_rad, speed_rad_s };
        }
        let speed_rad_s = self.period_s(span, &|id| values[id]).map_or(0.0, |period_s| TAU / period_s);
        CycleInput { name: PHASE.to_owned(), is_drive: false, start_rad: 0.0, speed_rad_s }
    }

    /// The input of the model's own cycle.
    pub fn cycle_input(&self, values: &Values) -> CycleInput {
        self.input(self.cycle.span, values)
    }

    /// Duration of a period, s, with the numbers that `number` gives; `None` if the turns of a drive are counted.
    pub fn period_s<T: Real>(&self, span: CycleSpan, number: &dyn Fn(QuantityId) -> T) -> Option<T> {
        match span {
            CycleSpan::Turns(_) => None,
            CycleSpan::Duration(duration_s) => Some(number(duration_s)),
            CycleSpan::Periods(drive) => self.drives[drive.0].law.period().map(|period| period.duration_s(number)),
        }
    }
}

//! A constant speed.

use super::kind::{KindOfDrive, MotionLaw, Steady, TimeDual};
use super::table_motion::AtTime;
use crate::model::words::part_names::Names;
use loosepin_math::{Real, numbers};
use loosepin_text::numbers::QuantityId;

/// start + speed t. It is written with keys of the drive itself.
#[derive(Debug, Clone)]
pub struct ConstantSpeed {
    /// Start and speed.
    pub steady: Steady,
}

/// Numbers of start + speed t.
#[derive(Debug, Clone)]
pub struct ConstantSpeedMotion<T> {
    /// At time zero, m or rad.
    start: T,
    /// Rate, m/s or rad/s.
    speed: T,
}

numbers!(struct ConstantSpeedMotion { start, speed });

impl KindOfDrive for ConstantSpeed {
    type Motion<T: Real> = ConstantSpeedMotion<T>;

    const WORD: &'static str = "constant";

    fn quantities(&self) -> Vec<QuantityId> {
        vec![self.steady.start, self.steady.speed]
    }

    fn motion<T: AtTime>(&self, number: &dyn Fn(QuantityId) -> T, _time_s: f64) -> ConstantSpeedMotion<T> {
        ConstantSpeedMotion { start: number(self.steady.start), speed: number(self.steady.speed) }
    }

    fn words(&self, names: &dyn Names) -> String {
        format!("at {} from {}", names.quantity(self.steady.speed), names.quantity(self.steady.start))
    }

    fn steady(&self) -> Option<Steady> {
        Some(self.steady)
    }
}

impl<T: Real> MotionLaw<T> for ConstantSpeedMotion<T> {
    #[inline(always)]
    fn at(&self, time_s: T, _workspace: &mut [TimeDual<T>]) -> [T; 3] {
        [self.start + self.speed * time_s, self.speed, T::zero()]
    }

    fn constant_speed(&self) -> Option<T> {
        Some(self.speed)
    }

    fn pace_1_s(&self, scale: T) -> Option<T> {
        Some(self.speed.abs() / scale)
    }
}

//! A rise between two rests.

use super::kind::{COORDINATE, KindOfDrive, MotionLaw, MotionTable, TimeDual, Written};
use super::reading::DriveReader;
use super::table_motion::AtTime;
use crate::model::part_reader::DeferredQuantity;
use crate::model::words::part_names::Names;
use loosepin_math::{Real, numbers};
use loosepin_text::document::{Entry, Keys, Table, quantity};
use loosepin_text::numbers::QuantityId;
use loosepin_text::record;
use loosepin_text::units::{Dimension, Dimension as D, Rule};

/// from + (to - from) (τ - sin(2π τ)/2π) with τ = (t - dwell)/duration cut to [0, 1].
#[derive(Debug, Clone)]
pub struct Cycloidal {
    /// Position before the motion, rad or m.
    pub from: QuantityId,
    /// Position after the motion, rad or m.
    pub to: QuantityId,
    /// Duration of the rise, s, > 0.
    pub duration_s: QuantityId,
    /// Rest before the rise, s, >= 0.
    pub dwell_s: QuantityId,
}

/// Numbers of from + rise (τ - sin(2π τ)/2π), τ = (t - dwell)/duration cut to [0, 1].
#[derive(Debug, Clone)]
pub struct CycloidalMotion<T> {
    /// Position before the motion, m or rad.
    from: T,
    /// How far it rises, m or rad.
    rise: T,
    /// Duration of the rise, s.
    duration_s: T,
    /// Rest before the rise, s.
    dwell_s: T,
}

numbers!(struct CycloidalMotion { from, rise, duration_s, dwell_s });

impl KindOfDrive for Cycloidal {
    type Motion<T: Real> = CycloidalMotion<T>;

    const WORD: &'static str = CycloidalTable::WORD;

    fn quantities(&self) -> Vec<QuantityId> {
        vec![self.from, self.to, self.duration_s, self.dwell_s]
    }

    fn motion<T: AtTime>(&self, number: &dyn Fn(QuantityId) -> T, _time_s: f64) -> CycloidalMotion<T> {
        CycloidalMotion {
            from: number(self.from),
            rise: number(self.to) - number(self.from),
            duration_s: number(self.duration_s),
            dwell_s: number(self.dwell_s),
        }
    }

    fn words(&self, names: &dyn Names) -> String {
        let [from, to, duration, dwell] =
            [self.from, self.to, self.duration_s, self.dwell_s].map(|id| names.quantity(id));
        format!("from {from} to {to} within {duration} after a rest of {dwell}")
    }

    fn breaks_s(&self, number: &dyn Fn(QuantityId) -> f64) -> Vec<f64> {
        let dwell_s = number(self.dwell_s);
        vec![dwell_s, dwell_s + number(self.duration_s)]
    }
}

impl<T: Real> MotionLaw<T> for CycloidalMotion<T> {
    #[inline(always)]
    fn at(&self, time_s: T, _workspace: &mut [TimeDual<T>]) -> [T; 3] {
        let share = ((time_s - self.dwell_s) / self.duration_s).max(T::zero()).min(T::one());
        let turn = T::from_f64(std::f64::consts::TAU);
        let (sine, cosine) = (turn * share).sin_cos();
        let pace = self.rise / self.duration_s;
        [
            self.rise.mul_add(share - sine / turn, self.from),
            pace * (T::one() - cosine),
            pace * turn * sine / self.duration_s,
        ]
    }

    fn pace_1_s(&self, scale: T) -> Option<T> {
        let turn = T::from_f64(std::f64::consts::TAU);
        Some((T::from_f64(2.0) * self.rise.abs() / scale).max(turn) / self.duration_s)
    }
}

impl MotionTable for Cycloidal {
    const KEYS: &'static Keys = &CycloidalTable::KEYS;

    fn read(table: &Table<'_>, dimension: Dimension, reader: &mut dyn DriveReader) -> Option<Written<Self>> {
        let own = CycloidalTable::of(reader, table.clone())?;
        let [from, to] = [&own.from, &own.to].map(|entry| reader.quantity_of(entry.as_ref()?, dimension, Rule::Finite));
        let duration_s = own.duration.and_then(|entry| reader.quantity_at(&entry));
        let dwell_s = own.dwell.quantity(reader);
        Some(Written::Motion(Self { from: from?, to: to?, duration_s: duration_s?, dwell_s: dwell_s? }))
    }
}

record! {
    /// a rise between two dwells, without a jump of the acceleration
    struct CycloidalTable for DriveReader, kind "cycloidal" of motion;
    /// angle or position before the rise
    required from: Option<Entry<'t>> = COORDINATE, "\"0 deg\"";
    /// angle or position after the rise
    required to: Option<Entry<'t>> = COORDINATE, "\"90 deg\"";
    /// duration of the rise
    required duration: Option<Entry<'t>> = quantity(D::TIME, Rule::Positive), "\"0.2 s\"";
    /// duration of the dwell before the rise
    optional dwell: DeferredQuantity<'t> = quantity(D::TIME, Rule::NonNegative), "\"0.05 s\"", or "0 s" called "none";
}

//! A harmonic motion.

use super::kind::{COORDINATE, KindOfDrive, MotionLaw, MotionTable, Period, TimeDual, Written};
use super::reading::DriveReader;
use super::table_motion::AtTime;
use crate::model::part_reader::DeferredQuantity;
use crate::model::words::part_names::Names;
use loosepin_math::{Real, numbers};
use loosepin_text::document::{Entry, Keys, Table, quantity};
use loosepin_text::numbers::QuantityId;
use loosepin_text::record;
use loosepin_text::units::{Dimension, Dimension as D, Rule};

/// mean + amplitude sin(2π frequency t + phase).
#[derive(Debug, Clone)]
pub struct Harmonic {
    /// Its middle, rad or m.
    pub mean: QuantityId,
    /// Largest departure from the middle, rad or m.
    pub amplitude: QuantityId,
    /// Oscillations in a second, 1/s, > 0.
    pub frequency_1_s: QuantityId,
    /// At time zero, rad.
    pub phase_rad: QuantityId,
}

/// Numbers of mean + amplitude sin(ω t + φ).
#[derive(Debug, Clone)]
pub struct HarmonicMotion<T> {
    /// Its middle, m or rad.
    mean: T,
    /// Largest departure from the middle, m or rad.
    amplitude: T,
    /// ω, rad/s.
    angular_frequency_rad_s: T,
    /// φ, rad.
    phase_rad: T,
}

numbers!(struct HarmonicMotion { mean, amplitude, angular_frequency_rad_s, phase_rad });

impl KindOfDrive for Harmonic {
    type Motion<T: Real> = HarmonicMotion<T>;

    const WORD: &'static str = HarmonicTable::WORD;

    fn quantities(&self) -> Vec<QuantityId> {
        vec![self.mean, self.amplitude, self.frequency_1_s, self.phase_rad]
    }

    fn motion<T: AtTime>(&self, number: &dyn Fn(QuantityId) -> T, _time_s: f64) -> HarmonicMotion<T> {
        HarmonicMotion {
            mean: number(self.mean),
            amplitude: number(self.amplitude),
            angular_frequency_rad_s: number(self.frequency_1_s) * T::from_f64(std::f64::consts::TAU),
            phase_rad: number(self.phase_rad),
        }
    }

    fn words(&self, names: &dyn Names) -> String {
        let [amplitude, mean, frequency] = [self.amplitude, self.mean, self.frequency_1_s].map(|id| names.quantity(id));
        format!("up and down by {amplitude} about {mean} at {frequency}")
    }

    fn period(&self) -> Option<Period> {
        Some(Period::Frequency(self.frequency_1_s))
    }
}

impl<T: Real> MotionLaw<T> for HarmonicMotion<T> {
    #[inline(always)]
    fn at(&self, time_s: T, _workspace: &mut [TimeDual<T>]) -> [T; 3] {
        let (sine, cosine) = self.angular_frequency_rad_s.mul_add(time_s, self.phase_rad).sin_cos();
        let speed = self.amplitude * self.angular_frequency_rad_s;
        [self.amplitude.mul_add(sine, self.mean), speed * cosine, -(speed * self.angular_frequency_rad_s * sine)]
    }

    fn pace_1_s(&self, scale: T) -> Option<T> {
        Some(self.angular_frequency_rad_s * (self.amplitude.abs() / scale).max(T::one()))
    }
}

impl MotionTable for Harmonic {
    const KEYS: &'static Keys = &HarmonicTable::KEYS;

    fn read(table: &Table<'_>, dimension: Dimension, reader: &mut dyn DriveReader) -> Option<Written<Self>> {
        let own = HarmonicTable::of(reader, table.clone())?;
        let [mean, amplitude] =
            [&own.mean, &own.amplitude].map(|entry| reader.quantity_of(entry.as_ref()?, dimension, Rule::Finite));
        let frequency = own.frequency.and_then(|entry| reader.quantity_at(&entry));
        let phase_rad = own.phase.quantity(reader);
        let (mean, amplitude) = (mean?, amplitude?);
        Some(Written::Motion(Self { mean, amplitude, frequency_1_s: frequency?, phase_rad: phase_rad? }))
    }
}

record! {
    /// mean + amplitude sin(360 deg frequency time + phase)
    struct HarmonicTable for DriveReader, kind "harmonic" of motion;
    /// mean angle or position
    required mean: Option<Entry<'t>> = COORDINATE, "\"90 deg\"";
    /// amplitude: largest distance from the mean
    required amplitude: Option<Entry<'t>> = COORDINATE, "\"30 deg\"";
    /// oscillations per second
    required frequency: Option<Entry<'t>> = quantity(D::FREQUENCY, Rule::Positive), "\"2 Hz\"";
    /// phase at time zero; at 0 the motion passes its mean upwards
    optional phase: DeferredQuantity<'t> = quantity(D::ANGLE, Rule::Finite), "\"90 deg\"", or "0 deg";
}

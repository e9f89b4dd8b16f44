//! The spectrum of a history over orders of the drive.

use super::SimulationRecord;
use std::f64::consts::TAU;

/// Largest number of turns of a spectrum, the last ones: the resolution of orders is one over their number.
const MAX_TURNS: usize = 8;
/// The highest order.
const HIGHEST_ORDER: usize = 60;
/// Round-off of the angle between two samples.
const ROUND_OFF: f64 = 1e-9;
/// A history that ends further from its start than this share of its range runs away, as the angle of a shaft does.
const RUNS_AWAY: f64 = 0.5;

/// Oscillations in a history, by orders of the drive: waves a turn.
///
/// With N samples x_k of n whole turns, the mean is x̄ = Σ x_k/N and the amplitude of the order h = j/n
///
/// ```text
/// a_h = (2/N) |Σ x_k exp(-2π i j k/N)|
/// ```
///
/// which is that of the wave of this order where the motion repeats itself over the n turns; otherwise waves of other orders
/// leak into it. Waves shorter than two samples are taken for longer ones.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// Orders h > 0, increasing: waves a turn.
    pub orders: Vec<f64>,
    /// Amplitudes of the orders, in the unit of the history.
    pub amplitudes_si: Vec<f64>,
    /// The mean x̄.
    pub mean_si: f64,
    /// Root mean square √(Σ x_k²/N), the mean included.
    pub rms_si: f64,
    /// The largest |x_k|.
    pub peak_si: f64,
}

impl SimulationRecord {
    /// Last whole turns of a drive at constant speed that are looked at, and samples in each; absent where there are none.
    fn turns_of_spectrum(&self) -> Option<(usize, usize)> {
        self.settings.drive_speed_rad_s?;
        let in_turn = self.settings.samples_per_turn;
        let whole = self.time_s.len().saturating_sub(1) / in_turn.max(1);
        // Where the recorded turns are no whole number of samples, these are a little further apart, or nearer.
        let is_even = match self.drive_angle_rad[..] {
            [first, second, ..] => ((second - first).abs() * in_turn as f64 / TAU - 1.0).abs() < ROUND_OFF,
            _ => false,
        };
        (whole > 0 && is_even).then_some((whole.min(MAX_TURNS), in_turn))
    }

    /// The spectrum of a history of this run over its last whole turns, eight at most, up to order 60 or half of the samples a turn. Absent where
    /// no drive turns at constant speed, less than a turn was recorded, samples do not divide the turn evenly, a value is not finite, or the
    /// history runs away, as the angle of a shaft does.
    pub fn spectrum(&self, values_si: &[f64]) -> Option<Spectrum> {
        let (turns, in_turn) = self.turns_of_spectrum()?;
        let count = turns * in_turn;
        // The last sample of a turn is the first one of the next.
        let start = values_si.len().checked_sub(count + 1)?;
        let growth_si = values_si[start + count] - values_si[start];
        let values_si = &values_si[start..start + count];
        let (least, most) = values_si.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), value| {
            (f64::min(least, *value), f64::max(most, *value))
        });
        if !values_si.iter().all(|value| value.is_finite()) || growth_si.abs() > RUNS_AWAY * (most - least) {
            return None;
        }
        let number = count as f64;
        let mean_si = values_si.iter().sum::<f64>() / number;
        let rms_si = (values_si.iter().map(|value| value * value).sum::<f64>() / number).sqrt();
        let peak_si = values_si.iter().fold(0.0_f64, |peak, value| peak.max(value.abs()));
        let waves: Vec<(f64, f64)> = (0..count).map(|k| (TAU * k as f64 / number).sin_cos()).collect();
        // Below half of the samples: two for a wave.
        let highest = (HIGHEST_ORDER * turns).min((count - 1) / 2);
        let amplitude_si = |wave: usize| {
            let mut sum = (0.0, 0.0);
            for (k, value) in values_si.iter().enumerate() {
                let (sine, cosine) = waves[wave * k % count];
                sum = (sum.0 + (value - mean_si) * cosine, sum.1 + (value - mean_si) * sine);
            }
            2.0 / number * f64::hypot(sum.0, sum.1)
        };
        Some(Spectrum {
            orders: (1..=highest).map(|wave| wave as f64 / turns as f64).collect(),
            amplitudes_si: (1..=highest).map(amplitude_si).collect(),
            mean_si,
            rms_si,
            peak_si,
        })
    }
}

impl Spectrum {
    /// Frequencies of the orders at a speed of the drive, Hz.
    pub fn frequencies_hz(&self, drive_speed_rad_s: f64) -> Vec<f64> {
        self.orders.iter().map(|order| order * drive_speed_rad_s.abs() / TAU).collect()
    }

    /// The orders with the largest amplitudes, the largest first; only those above a hundredth of the largest.
    pub fn dominant(&self, most: usize) -> Vec<(f64, f64)> {
        const MIN_SHARE: f64 = 0.01;
        let mut all: Vec<(f64, f64)> = self.orders.iter().copied().zip(self.amplitudes_si.iter().copied()).collect();
        all.sort_by(|a, b| b.1.total_cmp(&a.1));
        let least_si = all.first().map_or(0.0, |(_, largest)| MIN_SHARE * largest);
        all.truncate(most);
        all.retain(|(_, amplitude_si)| *amplitude_si > 0.0 && *amplitude_si >= least_si);
        all
    }
}

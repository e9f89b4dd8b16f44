//! Persistent oscillation of an error that should come to rest.

use loosepin_result::simulation::{ErrorOscillation, OscillationTrend};

/// Share of the recorded part, counted from its end, that is looked at: what went before is taken for settling.
const LOOKED_AT: f64 = 0.5;
/// Whole swings below which nothing is said.
const MIN_SWINGS: usize = 4;
/// A value has crossed the middle when it is further beyond than this share of half the range.
const BAND: f64 = 0.1;
/// Last swings over first ones below which the swings die out, and above which they grow.
const STEADY: [f64; 2] = [0.8, 1.25];

/// The swings of `error_si` about its mean over the last part of `time_s`; `None` if there are fewer than four whole ones, where
/// they die out, or where they are no wider than `resolved_si` either way.
///
/// A swing lasts from one upward crossing of the middle of the range to the next; its amplitude is half its range.
pub fn error_oscillation(time_s: &[f64], error_si: &[f64], resolved_si: f64) -> Option<ErrorOscillation> {
    let from_s = time_s.last()? - LOOKED_AT * (time_s.last()? - time_s.first()?);
    let start = time_s.partition_point(|time| *time < from_s);
    let (time_s, error_si) = (&time_s[start..], error_si.get(start..)?);
    let [low, high] = range(error_si);
    let (middle, band) = (0.5 * (low + high), 0.5 * BAND * (high - low));
    // Rows before which a swing begins, and when.
    let mut begins: Vec<(usize, f64)> = Vec::new();
    let (mut is_below, mut crossing) = (false, None);
    for k in 1..error_si.len() {
        let [before, now] = [error_si[k - 1] - middle, error_si[k] - middle];
        if before < 0.0 && now >= 0.0 {
            crossing = Some((k, time_s[k - 1] + (time_s[k] - time_s[k - 1]) * before / (before - now)));
        }
        is_below |= now < -band;
        if is_below && now > band {
            begins.extend(crossing);
            is_below = false;
        }
    }
    let count = begins.len().checked_sub(1).filter(|count| *count >= MIN_SWINGS)?;
    let amplitudes: Vec<f64> = begins
        .windows(2)
        .map(|pair| range(&error_si[pair[0].0..pair[1].0]))
        .map(|[low, high]| 0.5 * (high - low))
        .collect();
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let part = (count / 3).max(1);
    let (first, last) = (mean(&amplitudes[..part]), mean(&amplitudes[count - part..]));
    let growth = last / first;
    if !(last > resolved_si) || !(growth > STEADY[0]) {
        return None;
    }
    let (from, to) = (begins[0], begins[count]);
    Some(ErrorOscillation {
        course: if growth > STEADY[1] { OscillationTrend::Grows } else { OscillationTrend::Steady },
        amplitude_si: if growth > STEADY[1] { last } else { mean(&amplitudes) },
        period_s: (to.1 - from.1) / count as f64,
        mean_si: mean(&error_si[from.0..to.0]),
        swings: count,
    })
}

fn range(values: &[f64]) -> [f64; 2] {
    values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(*value), high.max(*value)])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows of a signal over 8 s.
    fn rows(signal: impl Fn(f64) -> f64) -> (Vec<f64>, Vec<f64>) {
        let time_s: Vec<f64> = (0..=4000).map(|k| f64::from(k) * 2e-3).collect();
        let error = time_s.iter().map(|t| signal(*t)).collect();
        (time_s, error)
    }

    #[test]
    fn analytic_a_steady_swing_is_measured() {
        let (time_s, error) = rows(|t| 0.03 + 0.4 * (-3.0 * t).exp() + 0.02 * (11.0 * t).sin());
        let found = error_oscillation(&time_s, &error, 1e-6).expect("it swings");
        // Upward crossings after 4 s stand at 2πk/11 s, k = 8 to 14; the last, at 7.997 s, is not followed beyond the band.
        assert_eq!((found.course, found.swings), (OscillationTrend::Steady, 5));
        // Rows stand 2 ms apart: the largest value lies within (11 · 1 ms)²/2 of the true one, the period is interpolated.
        assert!((found.amplitude_si - 0.02).abs() < 2e-6, "{found:?}");
        assert!((found.period_s - std::f64::consts::TAU / 11.0).abs() < 1e-5, "{found:?}");
        assert!((found.mean_si - 0.03).abs() < 1e-5, "{found:?}");
    }

    #[test]
    fn analytic_what_dies_out_or_is_not_resolved_is_no_swing_and_what_grows_is_told() {
        let (time_s, dying) = rows(|t| 0.4 * (-0.3 * t).exp() * (11.0 * t).sin());
        assert_eq!(error_oscillation(&time_s, &dying, 1e-6), None);
        let (time_s, small) = rows(|t| 1e-9 * (11.0 * t).sin());
        assert_eq!(error_oscillation(&time_s, &small, 1e-8), None);
        let (time_s, growing) = rows(|t| 0.01 * (0.3 * t).exp() * (11.0 * t).sin());
        assert_eq!(error_oscillation(&time_s, &growing, 1e-6).map(|found| found.course), Some(OscillationTrend::Grows));
        let (time_s, straight) = rows(|t| 0.01 * t);
        assert_eq!(error_oscillation(&time_s, &straight, 1e-6), None);
    }
}

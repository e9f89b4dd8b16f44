//! Features of equidistant samples: the same for measured and for simulated values.

use crate::file::SampledFeature;
use loosepin_result::study::Course;
use std::f64::consts::TAU;

/// Cosine and sine amplitude of the `harmonic`-th harmonic of the whole record.
fn harmonic(samples: &[f64], harmonic: usize) -> [f64; 2] {
    let count = samples.len();
    let turned = |place: usize| TAU * ((harmonic * place) % count) as f64 / count as f64;
    let sums = samples.iter().enumerate().fold([0.0, 0.0], |[cosine, sine], (place, value)| {
        let angle = turned(place);
        [cosine + value * angle.cos(), sine + value * angle.sin()]
    });
    // The mean and the highest harmonic of an even number of samples stand once in the sum, all others twice.
    let twice = if harmonic == 0 || 2 * harmonic == count { 1.0 } else { 2.0 };
    sums.map(|sum| twice * sum / count as f64)
}

/// `samples` over `turns` whole turns without what has more than `highest_order` periods in a turn.
fn low_pass(samples: &[f64], turns: usize, highest_order: usize) -> Vec<f64> {
    let count = samples.len();
    let highest = (highest_order * turns).min(count / 2);
    let kept: Vec<[f64; 2]> = (0..=highest).map(|order| harmonic(samples, order)).collect();
    let value = |place: usize| {
        kept.iter().enumerate().fold(0.0, |sum, (order, [cosine, sine])| {
            let angle = TAU * ((order * place) % count) as f64 / count as f64;
            sum + cosine * angle.cos() + sine * angle.sin()
        })
    };
    (0..count).map(value).collect()
}

/// A feature of samples over `turns` whole turns.
pub fn sampled_feature(samples: &[f64], turns: usize, feature: SampledFeature, highest_order: Option<usize>) -> f64 {
    if samples.is_empty() {
        return f64::NAN;
    }
    let filtered;
    let samples = match highest_order {
        Some(highest_order) => {
            filtered = low_pass(samples, turns, highest_order);
            &filtered[..]
        }
        None => samples,
    };
    let count = samples.len() as f64;
    let largest = samples.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let smallest = samples.iter().copied().fold(f64::INFINITY, f64::min);
    match feature {
        SampledFeature::Reduced(reduction) => reduction.of(&Course {
            largest,
            smallest,
            mean: samples.iter().sum::<f64>() / count,
            mean_square: samples.iter().map(|value| value * value).sum::<f64>() / count,
        }),
        SampledFeature::Order(order) => {
            let [cosine, sine] = harmonic(samples, order * turns);
            cosine.hypot(sine)
        }
        SampledFeature::Dwell(within) => {
            let near = samples.iter().filter(|value| largest - **value <= within).count();
            TAU * near as f64 / count
        }
    }
}

#[cfg(test)]
mod tests {
    use super::sampled_feature;
    use crate::file::SampledFeature;
    use loosepin_result::study::Reduction;
    use std::f64::consts::{PI, TAU};

    /// Two turns of 2 + 3 cos(3 φ - 0.4) + 0.5 sin 20 φ, 64 samples a turn.
    fn samples() -> Vec<f64> {
        let at = |place: usize| TAU * place as f64 / 64.0;
        (0..128).map(at).map(|angle| 2.0 + 3.0 * (3.0 * angle - 0.4).cos() + 0.5 * (20.0 * angle).sin()).collect()
    }

    #[test]
    fn analytic_orders_and_what_a_filter_leaves() {
        const ROUND_OFF: f64 = 1e-12;
        let of = |feature, highest| sampled_feature(&samples(), 2, feature, highest);
        let rms = SampledFeature::Reduced(Reduction::RootMeanSquare);
        for (found, due) in [
            (of(SampledFeature::Order(3), None), 3.0),
            (of(SampledFeature::Order(20), None), 0.5),
            (of(SampledFeature::Order(20), Some(10)), 0.0),
            (of(SampledFeature::Order(4), None), 0.0),
            (of(rms, None), (4.0_f64 + 4.5 + 0.125).sqrt()),
            (of(rms, Some(10)), (4.0_f64 + 4.5).sqrt()),
            (of(rms, Some(2)), 2.0),
            (of(SampledFeature::Reduced(Reduction::Mean), None), 2.0),
        ] {
            assert!((found - due).abs() < ROUND_OFF, "{found} in place of {due}");
        }
    }

    #[test]
    fn analytic_a_cosine_dwells_where_it_is_near_its_largest_value() {
        let samples: Vec<f64> = (0..3600).map(|place| (TAU * f64::from(place) / 3600.0).cos()).collect();
        // cos φ >= 0.5 for |φ| <= 60 deg: both ends are samples, and round-off decides on each.
        let found = sampled_feature(&samples, 1, SampledFeature::Dwell(0.5), None);
        assert!((found - TAU / 3.0).abs() <= 2.0 * PI / 1800.0, "{found}");
    }
}

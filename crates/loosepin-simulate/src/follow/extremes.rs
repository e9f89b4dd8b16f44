//! Extremes of a deviation within a step.

use crate::stepping::search::{POINTS_PER_STEP, maximum_within};

/// A function of the share of a step at equal distances, ends included: each share with the value there.
pub fn points_within(mut f: impl FnMut(f64) -> f64) -> [(f64, f64); POINTS_PER_STEP] {
    std::array::from_fn(|k| {
        let share = k as f64 / (POINTS_PER_STEP - 1) as f64;
        (share, f(share))
    })
}

/// The largest and the smallest of two `known` values and of `f`, which is known at `points` and stays between two `limits`: located if
/// these are beyond the known values.
pub fn extremes_within<const N: usize>(
    points: &[(f64, f64); N],
    [low, high]: [f64; 2],
    [mut largest, mut smallest]: [f64; 2],
    mut f: impl FnMut(f64) -> f64,
) -> [f64; 2] {
    if high > largest {
        largest = largest.max(maximum_within(points, &mut f).value);
    }
    if low < smallest {
        let turned = points.map(|(share, value)| (share, -value));
        smallest = smallest.min(-maximum_within(&turned, |share| -f(share)).value);
    }
    [largest, smallest]
}

#[cfg(test)]
mod tests {
    use super::{extremes_within, points_within};
    use loosepin_math::Quintic;

    #[test]
    fn analytic_the_extremes_of_a_cubic_are_located_where_they_count() {
        // 1 + 6 τ (τ - 1/2) (τ - 1) has its extremes at 1/2 ± 1/√12, ±1/√12 beside 1.
        let cubic = Quintic { coefficients: [1.0, 3.0, -9.0, 6.0, 0.0, 0.0] };
        let height = 1.0 / 12.0_f64.sqrt();
        let value = |share: f64| cubic.value(share);
        let of = |known| extremes_within(&points_within(value), cubic.limits(), known, value);
        let [largest, smallest] = of([f64::NEG_INFINITY, f64::INFINITY]);
        assert!((largest - 1.0 - height).abs() < 1e-12 && (smallest - 1.0 + height).abs() < 1e-12);
        assert_eq!(of([1.3, smallest]), [1.3, smallest]);
        assert_eq!(of([largest, 0.5]), [largest, 0.5]);
    }
}

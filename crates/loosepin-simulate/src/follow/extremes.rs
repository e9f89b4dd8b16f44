//! Extremes of a deviation within a step.

use crate::search::maximum_within;
use loosepin_math::Quintic;

/// Points of a step at which a deviation is looked at before its extremes are located, ends included.
const POINTS_PER_STEP: usize = 5;

/// The largest and the smallest of two values and of a polynomial on [0, 1].
pub(crate) fn with_extremes_of(polynomial: &Quintic, [largest, smallest]: [f64; 2]) -> [f64; 2] {
    let [low, high] = polynomial.limits();
    let points: [(f64, f64); POINTS_PER_STEP] = std::array::from_fn(|k| {
        let share = k as f64 / (POINTS_PER_STEP - 1) as f64;
        (share, polynomial.value(share))
    });
    let mut extremes = [largest, smallest];
    if high > largest {
        extremes[0] = largest.max(maximum_within(&points, |share| polynomial.value(share)).value);
    }
    if low < smallest {
        let turned = points.map(|(share, value)| (share, -value));
        extremes[1] = smallest.min(-maximum_within(&turned, |share| -polynomial.value(share)).value);
    }
    extremes
}

#[cfg(test)]
mod tests {
    use super::with_extremes_of;
    use loosepin_math::Quintic;

    #[test]
    fn analytic_the_extremes_of_a_cubic_are_located_where_they_count() {
        // 1 + 6 τ (τ - 1/2) (τ - 1) has its extremes at 1/2 ± 1/√12, ±1/√12 beside 1.
        let cubic = Quintic { coefficients: [1.0, 3.0, -9.0, 6.0, 0.0, 0.0] };
        let height = 1.0 / 12.0_f64.sqrt();
        let [largest, smallest] = with_extremes_of(&cubic, [f64::NEG_INFINITY, f64::INFINITY]);
        assert!((largest - 1.0 - height).abs() < 1e-12 && (smallest - 1.0 + height).abs() < 1e-12);
        assert_eq!(with_extremes_of(&cubic, [1.3, smallest]), [1.3, smallest]);
        assert_eq!(with_extremes_of(&cubic, [largest, 0.5]), [largest, 0.5]);
    }
}

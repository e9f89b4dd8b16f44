//! Student's factor of a confidence interval.

use crate::functions::incomplete_beta::inverse_incomplete_beta;

/// The t with P(|T| <= t) = `confidence` for Student's distribution with `degrees_of_freedom` >= 1.
///
/// P(|T| > t) = I_x(ν/2, 1/2) with x = ν/(ν + t²) (Abramowitz and Stegun 26.7.1). Infinite for a confidence of 1.
pub fn student_factor(confidence: f64, degrees_of_freedom: usize) -> f64 {
    let freedom = degrees_of_freedom as f64;
    let (x, rest) = inverse_incomplete_beta(0.5 * freedom, 0.5, 1.0 - confidence, confidence);
    (freedom * rest / x).sqrt()
}

#[cfg(test)]
mod tests {
    use super::student_factor;

    #[test]
    fn published_table_of_students_distribution() {
        const TOLERANCE: f64 = 5e-4; // the tables give three decimals
        for (confidence, freedom, expected) in
            [(0.95, 1, 12.706), (0.95, 7, 2.365), (0.99, 7, 3.499), (0.95, 30, 2.042), (0.90, 15, 1.753)]
        {
            assert!((student_factor(confidence, freedom) - expected).abs() < TOLERANCE);
        }
    }
}

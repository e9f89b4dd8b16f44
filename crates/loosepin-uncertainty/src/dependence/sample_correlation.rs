//! Correlation of values that were drawn together.

/// Pearson's linear correlation of two lists of the same length, Σ(a - ā)(b - b̄)/√(Σ(a - ā)² Σ(b - b̄)²); 0 where one of them does not scatter.
pub fn sample_correlation(a: &[f64], b: &[f64]) -> f64 {
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let (mean_a, mean_b) = (mean(a), mean(b));
    let (mut ab, mut aa, mut bb) = (0.0, 0.0, 0.0);
    for (a, b) in a.iter().zip(b) {
        let (a, b) = (a - mean_a, b - mean_b);
        (ab, aa, bb) = (ab + a * b, aa + a * a, bb + b * b);
    }
    if aa * bb > 0.0 { ab / (aa * bb).sqrt() } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::sample_correlation;

    #[test]
    fn analytic_linear_correlation_of_three_rows() {
        // Deviations (-1, 0, 1) and (-1, 2, -1) have the product 0; with (-4, -1, 5) it is 9/√(2 · 42).
        let [first, second, third] = [[1.0, 2.0, 3.0], [3.0, 6.0, 3.0], [0.0, 3.0, 9.0]];
        assert!(sample_correlation(&first, &second).abs() < 1e-15);
        assert!((sample_correlation(&first, &third) - 9.0 / 84.0_f64.sqrt()).abs() < 1e-15);
        assert_eq!(sample_correlation(&[0.0, 1.0, 2.0], &[5.0, 3.0, 1.0]), -1.0);
        assert_eq!(sample_correlation(&[0.0, 1.0], &[2.0, 2.0]), 0.0);
    }
}

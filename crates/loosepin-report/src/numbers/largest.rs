//! The largest of several numbers, with ties that round-off does not decide.

/// Relative difference of numbers that is round-off.
const SAME: f64 = 1e-9;

/// The first and the last place of what is the largest of `values` but for round-off; `None` if there are none.
pub(crate) fn places_of_largest(values: &[f64]) -> Option<[usize; 2]> {
    let most = values.iter().copied().max_by(f64::total_cmp)?;
    let is_alike = |value: &f64| value.total_cmp(&most).is_eq() || *value >= most - SAME * most.abs();
    Some([values.iter().position(is_alike)?, values.iter().rposition(is_alike)?])
}

#[cfg(test)]
mod tests {
    use super::places_of_largest;

    #[test]
    fn round_off_decides_no_place() {
        let beside = 2.5 * (1.0 - 4.0 * f64::EPSILON);
        assert_eq!(places_of_largest(&[1.5, beside, 0.5, 2.5, 1.25]), Some([1, 3]));
        assert_eq!(places_of_largest(&[1.5, 2.5, 0.5, beside, 1.25]), Some([1, 3]));
        assert_eq!(places_of_largest(&[-2.5, f64::NEG_INFINITY]), Some([0, 0]));
        assert_eq!(places_of_largest(&[2.5, f64::INFINITY]), Some([1, 1]));
        assert_eq!(places_of_largest(&[]), None);
    }
}

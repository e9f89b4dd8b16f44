//! Orders of numbers. A sort is five kilobytes of code for each type of its items and each comparison: here it is compiled once.
//!
//! All follow the total order of IEEE 754: -0 before 0, and what is not a number at the ends, by its sign.

/// An integer that is ordered as the bits of a number are by [`f64::total_cmp`]: integers are sorted in half the time.
#[inline]
pub fn order_key(value: f64) -> i64 {
    flipped(value.to_bits() as i64)
}

/// The number of a key.
#[inline]
pub fn number_of_key(key: i64) -> f64 {
    f64::from_bits(flipped(key) as u64)
}

/// Flips all bits of a negative number but the sign; applied twice it is the identity.
#[inline]
fn flipped(bits: i64) -> i64 {
    bits ^ (((bits >> 63) as u64) >> 1) as i64
}

/// `values` in increasing order.
#[must_use]
pub fn in_order(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut keys: Vec<i64> = values.map(order_key).collect();
    sort_keys(&mut keys);
    keys.into_iter().map(number_of_key).collect()
}

/// The one sort of keys that callers share.
fn sort_keys(keys: &mut [i64]) {
    keys.sort_unstable();
}

/// Sorts `values`, the least first.
pub fn sort_ascending(values: &mut [f64]) {
    let mut keys: Vec<i64> = values.iter().map(|value| order_key(*value)).collect();
    sort_keys(&mut keys);
    for (value, key) in values.iter_mut().zip(keys) {
        *value = number_of_key(key);
    }
}

/// The places of `keys` from the least key to the largest. Of equal keys the first comes first.
#[must_use]
pub fn places_in_order(keys: &[f64]) -> Vec<usize> {
    let mut places: Vec<(i64, usize)> = keys.iter().enumerate().map(|(place, key)| (order_key(*key), place)).collect();
    places.sort_unstable();
    places.into_iter().map(|(_, place)| place).collect()
}

/// Sorts `items` by the number that each has, the least first; for the largest first, give its negative. Equal ones stay in their order.
pub fn sort_by_number<T>(items: &mut [T], number: impl FnMut(&T) -> f64) {
    let keys: Vec<f64> = items.iter().map(number).collect();
    let mut places = places_in_order(&keys);
    for place in 0..items.len() {
        let mut from = places[place];
        // What stood there has been moved to where its own successor came from.
        while from < place {
            from = places[from];
        }
        places[place] = from;
        items.swap(place, from);
    }
}

#[cfg(test)]
mod tests {
    use super::{in_order, places_in_order, sort_ascending, sort_by_number};

    const NUMBERS: [f64; 16] = [
        2.5,
        -0.0,
        0.0,
        f64::NAN,
        -1.0,
        2.5,
        f64::NEG_INFINITY,
        -0.0,
        7e300,
        -1.0,
        5e-324,
        -f64::MIN_POSITIVE,
        f64::INFINITY,
        -5e-324,
        f64::MAX,
        -1e300,
    ];

    fn bits(values: &[f64]) -> Vec<u64> {
        values.iter().map(|value| value.to_bits()).collect()
    }

    #[test]
    fn identity_numbers_are_sorted_as_the_total_order_says() {
        let (mut ours, mut expected) = (NUMBERS, NUMBERS);
        sort_ascending(&mut ours);
        expected.sort_by(f64::total_cmp);
        assert_eq!(bits(&ours), bits(&expected));
        assert_eq!(bits(&in_order(NUMBERS.into_iter())), bits(&expected));
        assert_eq!(
            bits(&places_in_order(&NUMBERS).into_iter().map(|place| NUMBERS[place]).collect::<Vec<_>>()),
            bits(&expected)
        );
    }

    #[test]
    fn identity_items_are_moved_as_a_stable_sort_moves_them() {
        // Sixteen keys of up to 64 items: equal ones show whether their order stays. Both directions.
        for count in [0, 1, 2, 3, 17, 64] {
            for is_ascending in [true, false] {
                let items: Vec<(usize, f64)> =
                    (0..count).map(|i| (i, NUMBERS[(3 * i + i / NUMBERS.len()) % NUMBERS.len()])).collect();
                let (mut ours, mut expected) = (items.clone(), items);
                sort_by_number(&mut ours, |item| if is_ascending { item.1 } else { -item.1 });
                expected.sort_by(|a, b| if is_ascending { a.1.total_cmp(&b.1) } else { b.1.total_cmp(&a.1) });
                let places = |items: &[(usize, f64)]| items.iter().map(|item| item.0).collect::<Vec<_>>();
                assert_eq!(places(&ours), places(&expected), "{count} items, ascending: {is_ascending}");
            }
        }
    }
}

//! Which products of polynomials are candidates.

/// All multi-indices α ≠ 0 with (Σ α_i^q)^(1/q) <= p, as pairs of input and degree, in the order of their total degree; `None` if there are
/// more than `most`.
pub(crate) fn hyperbolic_set(
    inputs: usize,
    degree: usize,
    exponent: f64,
    most: usize,
) -> Option<Vec<Vec<(usize, usize)>>> {
    // A little above, so that the corners α_i = p are inside after rounding.
    let limit = libm::pow(degree as f64, exponent) * (1.0 + 1e-12);
    let costs: Vec<f64> = (0..=degree).map(|k| if k == 0 { 0.0 } else { libm::pow(k as f64, exponent) }).collect();
    let mut sets = Vec::new();
    let mut current = Vec::new();
    if !extend(0, inputs, limit, &costs, &mut current, &mut sets, most) {
        return None;
    }
    sets.sort_by_key(|set: &Vec<(usize, usize)>| set.iter().map(|(_, degree)| degree).sum::<usize>());
    Some(sets)
}

/// Adds `current` and all its extensions by inputs from `from` on; false where there are too many.
fn extend(
    from: usize,
    inputs: usize,
    left: f64,
    costs: &[f64],
    current: &mut Vec<(usize, usize)>,
    sets: &mut Vec<Vec<(usize, usize)>>,
    most: usize,
) -> bool {
    for input in from..inputs {
        for (degree, cost) in costs.iter().enumerate().skip(1).take_while(|(_, cost)| **cost <= left) {
            current.push((input, degree));
            sets.push(current.clone());
            let is_small = sets.len() <= most && extend(input + 1, inputs, left - cost, costs, current, sets, most);
            current.pop();
            if !is_small {
                return false;
            }
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::hyperbolic_set;

    #[test]
    fn analytic_a_set_with_exponent_one_holds_all_of_a_total_degree() {
        // (d + p over p) - 1
        assert_eq!(hyperbolic_set(3, 4, 1.0, 1_000).unwrap().len(), 34);
        assert_eq!(hyperbolic_set(20, 2, 1.0, 1_000).unwrap().len(), 230);
        assert!(hyperbolic_set(20, 3, 1.0, 1_000).is_none());
    }

    #[test]
    fn analytic_a_smaller_exponent_leaves_out_products() {
        // p = 4, q = 1/2: √a + √b <= 2 allows the single powers and (1, 1).
        let set = hyperbolic_set(2, 4, 0.5, 100).unwrap();
        assert_eq!(set.len(), 9);
        assert!(set.contains(&vec![(0, 1), (1, 1)]));
    }
}

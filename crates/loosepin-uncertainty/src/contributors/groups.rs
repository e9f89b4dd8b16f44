//! Inputs that belong together.

/// The inputs 0 to `inputs` - 1 in groups that are independent of each other: inputs that a chain of `dependent` pairs connects are
/// in one group. Groups in the order of their first inputs.
pub fn independent_groups(inputs: usize, dependent: &[(usize, usize)]) -> Vec<Vec<usize>> {
    let mut group_of: Vec<usize> = (0..inputs).collect();
    for &(first, second) in dependent {
        let (Some(&a), Some(&b)) = (group_of.get(first), group_of.get(second)) else { continue };
        for group in &mut group_of {
            if *group == a.max(b) {
                *group = a.min(b);
            }
        }
    }
    let members = |group: usize| (0..inputs).filter(|&input| group_of[input] == group).collect::<Vec<usize>>();
    (0..inputs).map(members).filter(|members| !members.is_empty()).collect()
}

#[cfg(test)]
mod tests {
    use super::independent_groups;

    #[test]
    fn analytic_chains_make_one_group() {
        assert_eq!(independent_groups(3, &[]), [[0], [1], [2]]);
        assert_eq!(independent_groups(6, &[(4, 1), (5, 4), (0, 3)]), [vec![0, 3], vec![1, 4, 5], vec![2]]);
    }
}

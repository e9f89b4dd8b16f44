//! Which sums of plays the readings fix.

use loosepin_math::reduced_echelon;

/// Columns whose directions differ by less than this are alike: above the round-off of derivatives, far below what two places of a
/// push differ by.
const ALIKE: f64 = 1e-7;

/// Sums of plays that the nominal factors of all readings can identify.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct IdentifiableSums {
    /// Sums that the readings fix, as weights of the plays: a basis of the row space of the factors in reduced echelon form, so that each
    /// has the weight one for a play that no other has.
    pub combinations: Vec<Vec<f64>>,
    /// Plays that enter every reading alike, two or more in a group.
    pub alike: Vec<Vec<usize>>,
}

impl IdentifiableSums {
    /// Whether the readings fix a play by itself.
    pub fn is_identifiable(&self, play: usize) -> bool {
        self.combinations
            .iter()
            .any(|weights| weights.iter().enumerate().all(|(other, weight)| (other == play) == (*weight != 0.0)))
    }
}

/// Sums of plays that `factors` can identify (a row for each reading, a column for each play of the widths `widths_si`).
pub(crate) fn identifiable_sums(factors: &[Vec<f64>], widths_si: &[f64]) -> IdentifiableSums {
    let plays = widths_si.len();
    // Rows of order one over plays of order one: a row counts by its shape.
    let rows: Vec<Vec<f64>> = factors
        .iter()
        .filter_map(|row| {
            let scaled: Vec<f64> = row.iter().zip(widths_si).map(|(factor, width)| factor * width).collect();
            let size = scaled.iter().fold(0.0_f64, |size, entry| size.max(entry.abs()));
            (size > 0.0).then(|| scaled.into_iter().map(|entry| entry / size).collect())
        })
        .collect();
    let alike = groups(&rows, plays);
    let mut matrix = rows.concat();
    let pivots = reduced_echelon(&mut matrix, plays, ALIKE);
    let weights = pivots.iter().enumerate().map(|(rank, &column)| {
        let in_plays = |(play, entry): (usize, &f64)| {
            let weight = entry * widths_si[column] / widths_si[play];
            if entry.abs() <= ALIKE { 0.0 } else { nearly_whole(weight) }
        };
        matrix[rank * plays..(rank + 1) * plays].iter().enumerate().map(in_plays).collect()
    });
    let combinations = weights.collect();
    IdentifiableSums { combinations, alike }
}

/// A weight that is a whole number but for round-off is that number.
fn nearly_whole(weight: f64) -> f64 {
    if (weight - weight.round()).abs() <= ALIKE { weight.round() } else { weight }
}

/// Plays whose columns have the same direction, in groups of two or more.
fn groups(rows: &[Vec<f64>], plays: usize) -> Vec<Vec<usize>> {
    let direction = |play: usize| -> Option<Vec<f64>> {
        let column: Vec<f64> = rows.iter().map(|row| row[play]).collect();
        let size = column.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
        (size > ALIKE).then(|| column.into_iter().map(|entry| entry / size).collect())
    };
    let directions: Vec<Option<Vec<f64>>> = (0..plays).map(direction).collect();
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for play in 0..plays {
        let Some(own) = &directions[play] else { continue };
        let is_alike = |first: usize| {
            directions[first].as_ref().is_some_and(|other| {
                let apart = |sign: f64| own.iter().zip(other).map(|(a, b)| (a - sign * b).abs()).fold(0.0, f64::max);
                apart(1.0) <= ALIKE || apart(-1.0) <= ALIKE
            })
        };
        match groups.iter_mut().find(|group| is_alike(group[0])) {
            Some(group) => group.push(play),
            None => groups.push(vec![play]),
        }
    }
    groups.retain(|group| group.len() > 1);
    groups
}

#[cfg(test)]
mod tests {
    use super::identifiable_sums;

    /// Widths that differ, so that a forgotten scale shows.
    const WIDTHS_M: [f64; 3] = [3e-4, 5e-4, 2e-4];

    #[test]
    fn analytic_equal_factors_fix_the_sum_alone() {
        let found = identifiable_sums(&[vec![2.2; 3], vec![3.1; 3]], &WIDTHS_M);
        assert_eq!(found.combinations, [[1.0, 1.0, 1.0]]);
        assert_eq!(found.alike, [[0, 1, 2]]);
        assert!((0..3).all(|play| !found.is_identifiable(play)));
    }

    #[test]
    fn analytic_two_alike_and_one_apart() {
        let found = identifiable_sums(&[vec![2.0, 2.0, 2.0], vec![1.5, 1.5, 0.4]], &WIDTHS_M);
        assert_eq!(found.combinations, [[1.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
        assert_eq!(found.alike, [[0, 1]]);
        assert!(found.is_identifiable(2) && !found.is_identifiable(0));
    }

    #[test]
    fn analytic_rank_two_of_three() {
        // (1, 0, a) and (0, 1, b) from 2x + y + z and x + y + 2z: a = -1, b = 3.
        let found = identifiable_sums(&[vec![2.0, 1.0, 1.0], vec![1.0, 1.0, 2.0]], &WIDTHS_M);
        assert_eq!(found.combinations, [[1.0, 0.0, -1.0], [0.0, 1.0, 3.0]]);
        assert!(found.alike.is_empty());
        let alone = identifiable_sums(&[vec![0.0, 1.7, 0.0]], &WIDTHS_M);
        assert_eq!(alone.combinations, [[0.0, 1.0, 0.0]]);
        assert!(alone.is_identifiable(1) && !alone.is_identifiable(0));
    }
}

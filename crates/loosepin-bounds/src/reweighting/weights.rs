//! What the runs of the pool weigh at a place, and to how many independent ones that comes.

use crate::search_box::Place;

/// One place and the pool as it is seen from there.
#[derive(Debug)]
pub struct Seen {
    pub place: Place,
    /// Weights of all runs, replicate by replicate; their sum is 1.
    pub weights: Vec<f64>,
    /// Independent runs that would know as much.
    pub effective: f64,
    /// The same where runs with the same random numbers count by themselves: they have different values, each of which a polynomial is
    /// fitted to.
    pub covering: f64,
}

/// How the runs of the pool lie behind one another: replicate by replicate, in each outer point by outer point.
#[derive(Debug, Clone, Copy)]
pub struct Layout {
    pub replicates: usize,
    /// Outer points.
    pub outer: usize,
    /// Runs of one replicate at one outer point.
    pub each: usize,
}

impl Layout {
    /// Runs of one replicate.
    pub fn runs(self) -> usize {
        self.outer * self.each
    }

    /// Points of the unit cube that the runs were drawn at.
    pub fn rows(self) -> usize {
        self.replicates * self.each
    }

    /// The sums of `of` over the runs at all outer points that belong to one point of the unit cube. These are one draw, not several: the
    /// same random numbers are used at every outer point.
    pub fn by_row(self, of: impl Fn(usize) -> f64) -> Vec<f64> {
        let row = |row: usize| {
            let first = row / self.each * self.runs() + row % self.each;
            (0..self.outer).map(|point| of(first + point * self.each)).sum()
        };
        (0..self.rows()).map(row).collect()
    }
}

/// (Σ w)²/Σ w² (L. Kish 1965); 0 where nothing has a weight.
pub fn kish(weights: &[f64]) -> f64 {
    let (sum, square) = weights.iter().fold((0.0, 0.0), |(sum, square), w| (sum + w, square + w * w));
    if square > 0.0 { sum * sum / square } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::{Layout, kish};

    #[test]
    fn analytic_a_draw_that_is_used_at_several_points_counts_once() {
        const TOLERANCE: f64 = 1e-12;
        let layout = Layout { replicates: 2, outer: 3, each: 4 };
        // Runs of one draw: the same place in the replicate at each outer point.
        assert_eq!((layout.runs(), layout.rows()), (12, 8));
        let rows = layout.by_row(|run| run as f64);
        assert_eq!(rows[1], 1.0 + 5.0 + 9.0);
        assert_eq!(rows[6], 14.0 + 18.0 + 22.0);
        // 24 equal weights are those of 8 draws.
        assert!((kish(&layout.by_row(|_| 0.25)) - 8.0).abs() < TOLERANCE);
        assert!((kish(&[3.0, 0.5]) - 3.5 * 3.5 / 9.25).abs() < TOLERANCE);
    }
}

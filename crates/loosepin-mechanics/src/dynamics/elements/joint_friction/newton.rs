//! Normal forces of joints with friction, by Newton's method with a fixed number of steps.

use super::{JointFrictions, PARTS};
use loosepin_math::{Real, solve_in_order};

/// Steps of Newton's method. Its error squares from step to step; friction coefficient times pin radius over link length is what
/// it starts with.
const ITERATIONS: usize = 6;

impl<T: Real> JointFrictions<T> {
    /// N = f(ρ0 + B m N) by Newton's method, and its residual.
    #[inline(always)]
    pub(super) fn solve(&mut self) {
        for entry in &mut self.entries {
            entry.normal_n = entry.carried(entry.free).0;
        }
        for _ in 0..ITERATIONS {
            self.linearise();
            self.eliminate();
            for (entry, change) in self.entries.iter_mut().zip(&self.defects) {
                entry.normal_n += *change;
            }
        }
        self.linearise();
        // Pivots of the matrix tell whether friction grows faster than what causes it.
        for index in 0..self.entries.len() {
            let defect = self.defects[index].abs();
            let entry = &mut self.entries[index];
            let size = entry.carried(entry.free).0 + entry.normal_n.abs() + T::from_f64(f64::MIN_POSITIVE.sqrt());
            entry.residual = defect / size;
        }
        self.eliminate();
        let count = self.entries.len();
        for (index, entry) in self.entries.iter_mut().enumerate() {
            let is_sound = T::zero().less_than(self.matrix[index * count + index]);
            entry.residual = T::select(is_sound, entry.residual, T::one());
        }
    }

    /// 1 - df/dN and f - N at the present N.
    #[inline(always)]
    fn linearise(&mut self) {
        let count = self.entries.len();
        for index in 0..count {
            let influence = &self.influence[index * count..(index + 1) * count];
            let mut parts = self.entries[index].free;
            for (added, other) in influence.iter().zip(&self.entries) {
                let force = other.coefficient * other.normal_n;
                for part in 0..PARTS {
                    parts[part] = added[part].mul_add(force, parts[part]);
                }
            }
            let (carried, slopes) = self.entries[index].carried(parts);
            self.defects[index] = carried - self.entries[index].normal_n;
            for (column, (added, other)) in influence.iter().zip(&self.entries).enumerate() {
                let slope = slopes[0].mul_add(added[0], slopes[1] * added[1]) * other.coefficient;
                let one = if column == index { T::one() } else { T::zero() };
                self.matrix[index * count + column] = one - slope;
            }
        }
    }

    /// Replaces the defects by the change of N (Gauss, without a choice of pivots: they are near one).
    #[inline(always)]
    fn eliminate(&mut self) {
        solve_in_order(&mut self.matrix, self.entries.len(), &mut self.defects, 1, |_| true);
    }
}

//! The bordered loop equations of a place, factored in the same memory again and again.

use super::sparse_lu::SparseLu;
use crate::closure::bordered::Borders;
use crate::closure::loops::Loops;
use crate::kind::frames::JointFrames;

/// [[J, N], [Vᵀ, 0]], as [`crate::closure::bordered::Bordered`] has it.
#[derive(Debug, Clone, Default)]
pub(super) struct PlaceSystem {
    lu: SparseLu,
}

impl PlaceSystem {
    /// The system at these frames, instead of what there was.
    pub(super) fn factor(&mut self, loops: &Loops, frames: &[JointFrames], borders: &Borders) {
        let (rows, columns) = (loops.rows.len(), loops.unknowns());
        let size = columns + borders.left.len();
        let matrix = self.lu.cleared(size);
        for (row, entries) in loops.rows.iter().zip(matrix.chunks_exact_mut(size.max(1))) {
            for (first, values) in loops.row_entries(row, frames).into_iter().flatten() {
                entries[first..first + 6].iter_mut().zip(values).for_each(|(entry, value)| *entry += value);
            }
        }
        for (k, null) in borders.left.iter().enumerate() {
            null.iter().enumerate().for_each(|(row, entry)| matrix[row * size + columns + k] = *entry);
        }
        for (k, null) in borders.right.iter().enumerate() {
            matrix[(rows + k) * size..(rows + k) * size + columns].copy_from_slice(null);
        }
        self.lu.factor();
    }

    /// Number of unknowns, borders included.
    pub(super) fn order(&self) -> usize {
        self.lu.order()
    }

    /// x and ν with J x + N ν = b, Vᵀx = 0, in place of b.
    pub(super) fn solve(&self, vector: &mut [f64]) {
        self.lu.solve(vector);
    }

    /// y and ρ with Jᵀy + V ρ = c, Nᵀy = 0, in place of c.
    pub(super) fn solve_gradient(&self, vector: &mut [f64]) {
        self.lu.solve_transposed(vector);
    }

    /// Sign of the determinant.
    pub(super) fn sign(&self) -> f64 {
        self.lu.determinant_sign()
    }

    /// Size of the smallest pivot over that of the largest.
    pub(super) fn pivot_ratio(&self) -> f64 {
        self.lu.pivot_ratio()
    }
}

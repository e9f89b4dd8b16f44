//! The bordered loop equations of a place, factored in the same memory again and again.

use crate::closure::bordered::Borders;
use crate::closure::loops::Loops;
use crate::kind::frames::JointFrames;
use loosepin_math::RealLu;

/// [[J, N], [Vᵀ, 0]], as [`crate::closure::bordered::Bordered`] has it. Its transpose is what is factored: then the solution for changes of
/// rows, which is wanted most, goes through the factors row by row.
#[derive(Debug, Clone)]
pub(super) struct PlaceSystem {
    transposed: RealLu,
}

impl Default for PlaceSystem {
    /// No equations.
    fn default() -> Self {
        Self { transposed: RealLu::new(0) }
    }
}

impl PlaceSystem {
    /// The system at these frames, instead of what there was.
    pub(super) fn factor(&mut self, loops: &Loops, frames: &[JointFrames], borders: &Borders) {
        let (rows, columns) = (loops.rows.len(), loops.unknowns());
        let size = columns + borders.left.len();
        if self.transposed.order() != size {
            self.transposed = RealLu::new(size);
        }
        let matrix = &mut self.transposed.matrix;
        matrix.fill(0.0);
        for (number, row) in loops.rows.iter().enumerate() {
            for (first, values) in loops.row_entries(row, frames).into_iter().flatten() {
                for (k, value) in values.into_iter().enumerate() {
                    matrix[(first + k) * size + number] += value;
                }
            }
        }
        for (k, null) in borders.left.iter().enumerate() {
            matrix[(columns + k) * size..(columns + k) * size + rows].copy_from_slice(null);
        }
        for (k, null) in borders.right.iter().enumerate() {
            null.iter().enumerate().for_each(|(column, entry)| matrix[column * size + rows + k] = *entry);
        }
        self.transposed.factor();
    }

    /// Number of unknowns, borders included.
    pub(super) fn order(&self) -> usize {
        self.transposed.order()
    }

    /// x and ν with J x + N ν = b, Vᵀx = 0, in place of b.
    pub(super) fn solve(&self, vector: &mut [f64]) {
        self.transposed.solve_transposed(vector);
    }

    /// y and ρ with Jᵀy + V ρ = c, Nᵀy = 0, in place of c.
    pub(super) fn solve_gradient(&self, vector: &mut [f64]) {
        self.transposed.solve(vector);
    }

    /// Sign of the determinant.
    pub(super) fn sign(&self) -> f64 {
        self.transposed.determinant_sign()
    }

    /// Size of the smallest pivot over that of the largest.
    pub(super) fn pivot_ratio(&self) -> f64 {
        self.transposed.pivot_ratio()
    }
}

//! Lower triangles, and products with them.

use crate::solve::four_rows::FourTriangleRows;

/// A lower triangular matrix T.
#[derive(Debug, Clone)]
pub struct LowerTriangle(pub(super) FourTriangleRows);

impl LowerTriangle {
    /// T x
    pub fn multiply(&self, vector: &[f64]) -> Vec<f64> {
        self.0.multiply(vector)
    }

    /// Tᵀ x
    pub fn multiply_transposed(&self, vector: &[f64]) -> Vec<f64> {
        self.0.multiply_transposed(vector)
    }

    /// T x of N vectors side by side.
    pub fn multiply_each<const N: usize>(&self, vectors: &[[f64; N]]) -> Vec<[f64; N]> {
        self.0.multiply_each(vectors)
    }

    /// Tᵀ x of N vectors side by side.
    pub fn multiply_transposed_each<const N: usize>(&self, vectors: &[[f64; N]]) -> Vec<[f64; N]> {
        self.0.multiply_transposed_each(vectors)
    }

    /// TᵀT, row by row, its lower triangle; the rest is zero.
    pub fn gram(&self) -> Vec<f64> {
        let order = self.0.order();
        let mut product = vec![0.0; order * order];
        for last in 0..order {
            let row: Vec<f64> = self.0.row(last).collect();
            for (i, factor) in row.iter().enumerate() {
                if *factor != 0.0 {
                    for (sum, entry) in product[i * order..=i * order + i].iter_mut().zip(&row) {
                        *sum += factor * entry;
                    }
                }
            }
        }
        product
    }

    /// Sum of squares of each column.
    pub fn column_squares(&self) -> Vec<f64> {
        self.0.column_squares()
    }
}

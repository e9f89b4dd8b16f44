//! Dense systems that are solved for many right-hand sides.

use super::elimination::{largest_in_column, reduce};

/// P A = L U of a square matrix A, L with ones on its diagonal.
///
/// A is filled into `matrix`, row by row, before [`Self::factor`]. A singular matrix has factors too, and [`Self::pivot_ratio`] tells.
#[derive(Debug, Clone)]
pub struct RealLu {
    order: usize,
    /// The matrix, row by row; then its factors.
    pub matrix: Vec<f64>,
    /// The row that was exchanged with each one.
    rows: Vec<usize>,
}

impl RealLu {
    /// Room for an order.
    pub fn new(order: usize) -> Self {
        Self { order, matrix: vec![0.0; order * order], rows: (0..order).collect() }
    }

    /// Number of rows.
    pub fn order(&self) -> usize {
        self.order
    }

    /// Replaces the matrix by its factors.
    pub fn factor(&mut self) {
        let (n, rows) = (self.order, &mut self.rows);
        let choose = |a: &[f64], j: usize| {
            rows[j] = largest_in_column(a, n, j);
            Some(rows[j])
        };
        let over = |pivot: f64| {
            let inverse = 1.0 / pivot;
            move |entry| entry * inverse
        };
        reduce(&mut self.matrix, n, &mut [], 0, choose, over, |factor| factor == 0.0);
    }

    /// Solves A x = b in place of b.
    pub fn solve(&self, right: &mut [f64]) {
        let (n, a) = (self.order, &self.matrix);
        for j in 0..n {
            right.swap(j, self.rows[j]);
        }
        for i in 0..n {
            let sum: f64 = a[i * n..i * n + i].iter().zip(&right[..i]).map(|(entry, value)| entry * value).sum();
            right[i] -= sum;
        }
        for i in (0..n).rev() {
            let row = &a[i * n..(i + 1) * n];
            let sum: f64 = row[i + 1..].iter().zip(&right[i + 1..n]).map(|(entry, value)| entry * value).sum();
            right[i] = (right[i] - sum) / row[i];
        }
    }

    /// Solves Aᵀ x = b in place of b.
    pub fn solve_transposed(&self, right: &mut [f64]) {
        let (n, a) = (self.order, &self.matrix);
        for i in 0..n {
            right[i] /= a[i * n + i];
            let value = right[i];
            (i + 1..n).for_each(|k| right[k] -= a[i * n + k] * value);
        }
        for i in (0..n).rev() {
            let value = right[i];
            (0..i).for_each(|k| right[k] -= a[i * n + k] * value);
        }
        for j in (0..n).rev() {
            right.swap(j, self.rows[j]);
        }
    }

    /// Sign of the determinant of the matrix; 0 where it is singular, or not of numbers.
    pub fn determinant_sign(&self) -> f64 {
        let n = self.order;
        let exchanges = (0..n).filter(|&j| self.rows[j] != j).count();
        let start = if exchanges % 2 == 0 { 1.0 } else { -1.0 };
        (0..n)
            .map(|j| self.matrix[j * n + j])
            .fold(start, |sign, pivot| if pivot == 0.0 || !pivot.is_finite() { 0.0 } else { sign * pivot.signum() })
    }

    /// Size of the smallest pivot over that of the largest; 0 where the matrix is singular, or not of numbers.
    pub fn pivot_ratio(&self) -> f64 {
        let n = self.order;
        let pivots = || (0..n).map(|j| self.matrix[j * n + j].abs());
        if !pivots().all(f64::is_finite) {
            return 0.0;
        }
        let (smallest, largest) = (pivots().fold(f64::INFINITY, f64::min), pivots().fold(0.0, f64::max));
        if largest > 0.0 { smallest / largest } else { f64::from(u8::from(n == 0)) }
    }
}

#[cfg(test)]
mod tests {
    use super::RealLu;

    #[test]
    fn analytic_both_solutions_and_the_sign() {
        // 0 (1·7 - 4·2) - 2 (3·7 - 4·5) + 1 (3·2 - 1·5) = -1.
        let matrix = [0.0, 2.0, 1.0, 3.0, 1.0, 4.0, 5.0, 2.0, 7.0];
        let mut lu = RealLu::new(3);
        lu.matrix.copy_from_slice(&matrix);
        lu.factor();
        assert_eq!(lu.determinant_sign(), -1.0);
        let solution = [0.7, -1.3, 2.9];
        let mut straight: Vec<f64> = (0..3).map(|i| (0..3).map(|j| matrix[3 * i + j] * solution[j]).sum()).collect();
        let mut transposed: Vec<f64> = (0..3).map(|j| (0..3).map(|i| matrix[3 * i + j] * solution[i]).sum()).collect();
        lu.solve(&mut straight);
        lu.solve_transposed(&mut transposed);
        for found in [straight, transposed] {
            assert!(found.iter().zip(solution).all(|(a, b)| (a - b).abs() < 1e-13), "{found:?}");
        }
        assert!(lu.pivot_ratio() > 0.0);
        let mut singular = RealLu::new(2);
        singular.matrix.copy_from_slice(&[1.0, 2.0, 2.0, 4.0]);
        singular.factor();
        assert_eq!((singular.determinant_sign(), singular.pivot_ratio()), (0.0, 0.0));
    }
}

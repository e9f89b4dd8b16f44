//! Dense systems that are solved for many right-hand sides.

/// Factors of a square matrix, with row exchanges.
#[derive(Debug, Clone)]
pub struct RealLu {
    order: usize,
    /// The matrix, row by row; then its factors.
    pub matrix: Vec<f64>,
    rows: Vec<usize>,
}

impl RealLu {
    /// Room for an order.
    pub fn new(order: usize) -> Self {
        Self { order, matrix: vec![0.0; order * order], rows: (0..order).collect() }
    }

    /// Replaces the matrix by its factors.
    pub fn factor(&mut self) {
        let (n, a) = (self.order, &mut self.matrix);
        for j in 0..n {
            let best = (j..n).max_by(|&i, &k| a[i * n + j].abs().total_cmp(&a[k * n + j].abs())).unwrap_or(j);
            self.rows[j] = best;
            if best != j {
                (0..n).for_each(|k| a.swap(j * n + k, best * n + k));
            }
            let inverse = 1.0 / a[j * n + j];
            for i in j + 1..n {
                let factor = a[i * n + j] * inverse;
                a[i * n + j] = factor;
                if factor != 0.0 {
                    let (above, below) = a.split_at_mut(i * n);
                    for (entry, pivot) in below[j + 1..n].iter_mut().zip(&above[j * n + j + 1..(j + 1) * n]) {
                        *entry -= factor * pivot;
                    }
                }
            }
        }
    }

    /// Solves in place.
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
}

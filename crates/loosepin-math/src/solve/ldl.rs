//! Symmetric systems by a = L D Lᵀ: small dense ones inside the equations of motion, on any [`Real`]; ones with blocks; and the normal
//! equations of many loops, most of whose entries are zero.

use crate::Real;
use crate::fused::multiply_add;

/// Replaces the lower triangle of the symmetric n × n matrix `a` (row-major) by L and D of a = L D Lᵀ: unit lower
/// triangle L below the diagonal, 1/D on it.
#[inline(always)]
pub fn factor_ldl<T: Real>(a: &mut [T], n: usize) {
    factor_within(a, n, |_| 0);
}

/// Solves a x = b in place with the factors of [`factor_ldl`].
#[inline(always)]
pub fn solve_ldl<T: Real>(a: &[T], n: usize, b: &mut [T]) {
    solve_within(a, n, b, |_| 0, |_| n);
}

/// The possibly non-zero entries of a symmetric matrix: in row i not before column `first[i]`. Its factors L keep within it.
///
/// A mass matrix of parts that no ideal joint connects has a block for each of them.
#[derive(Debug, Clone)]
pub struct Envelope {
    first: Vec<usize>,
    /// Behind the last row that may have an entry in this column.
    end: Vec<usize>,
}

impl Envelope {
    /// The envelope whose row i begins at column `first[i]`, at most i.
    pub fn new(first: Vec<usize>) -> Self {
        let mut end: Vec<usize> = (1..=first.len()).collect();
        for (row, &begin) in first.iter().enumerate() {
            end[begin..row].iter_mut().for_each(|end| *end = (*end).max(row + 1));
        }
        Self { first, end }
    }

    /// As [`factor_ldl`]: the same bits, without the operations on zeros.
    #[inline(always)]
    pub fn factor_ldl<T: Real>(&self, a: &mut [T]) {
        factor_within(a, self.first.len(), |row| self.first[row]);
    }

    /// As [`solve_ldl`].
    #[inline(always)]
    pub fn solve_ldl<T: Real>(&self, a: &[T], b: &mut [T]) {
        solve_within(a, self.first.len(), b, |row| self.first[row], |column| self.end[column]);
    }

    /// Multiplications of a factorisation.
    pub fn multiplications(&self) -> f64 {
        let widths = self.first.iter().enumerate().map(|(row, first)| (row - first) as f64);
        widths.map(|width| 0.5 * width * width).sum()
    }
}

#[inline(always)]
fn factor_within<T: Real>(a: &mut [T], n: usize, first: impl Fn(usize) -> usize) {
    for j in 0..n {
        let mut pivot = a[j * n + j];
        for k in first(j)..j {
            // The diagonal already holds 1/D, so D = 1/(1/D) is avoided by keeping L·D in the upper triangle.
            pivot = (-a[j * n + k]).mul_add(a[k * n + j], pivot);
        }
        let inverse = T::one() / pivot;
        a[j * n + j] = inverse;
        for i in j + 1..n {
            if first(i) > j {
                continue;
            }
            let mut sum = a[i * n + j];
            for k in first(i).max(first(j))..j {
                sum = (-a[i * n + k]).mul_add(a[k * n + j], sum);
            }
            a[j * n + i] = sum; // L·D, used by later columns
            a[i * n + j] = sum * inverse;
        }
    }
}

#[inline(always)]
fn solve_within<T: Real>(a: &[T], n: usize, b: &mut [T], first: impl Fn(usize) -> usize, end: impl Fn(usize) -> usize) {
    for i in 1..n {
        let mut sum = b[i];
        for k in first(i)..i {
            sum = (-a[i * n + k]).mul_add(b[k], sum);
        }
        b[i] = sum;
    }
    for i in 0..n {
        b[i] *= a[i * n + i];
    }
    for i in (0..n).rev() {
        let mut sum = b[i];
        for k in i + 1..end(i) {
            sum = (-a[k * n + i]).mul_add(b[k], sum);
        }
        b[i] = sum;
    }
}

/// Solves the symmetric n × n system a x = b in place by a = L D Lᵀ. Of `a` (row-major) the upper triangle is read and destroyed.
///
/// The operations are those of [`factor_ldl`] and [`solve_ldl`] in their order, without those on zeros, so that the
/// bits are the same and a matrix of many small blocks costs as much as its blocks.
pub fn solve_sparse_symmetric(a: &mut [f64], n: usize, b: &mut [f64]) {
    let mut inverses = vec![0.0; n];
    // Columns and values of L, one row after the other of its transpose.
    let mut factors: Vec<(usize, f64)> = Vec::new();
    let mut begins = vec![0; n + 1];
    for k in 0..n {
        let inverse = 1.0 / a[k * n + k];
        inverses[k] = inverse;
        let begin = factors.len();
        let filled = (k + 1..n).filter(|i| a[k * n + i] != 0.0).map(|i| (i, a[k * n + i] * inverse));
        factors.extend(filled);
        for (place, &(j, _)) in factors[begin..].iter().enumerate() {
            let scaled = a[k * n + j];
            for &(i, factor) in &factors[begin + place..] {
                a[j * n + i] = multiply_add(-factor, scaled, a[j * n + i]);
            }
        }
        for &(i, factor) in &factors[begin..] {
            b[i] = multiply_add(-factor, b[k], b[i]);
        }
        begins[k + 1] = factors.len();
    }
    for (value, inverse) in b.iter_mut().zip(&inverses) {
        *value *= inverse;
    }
    for k in (0..n).rev() {
        for &(i, factor) in &factors[begins[k]..begins[k + 1]] {
            b[k] = multiply_add(-factor, b[i], b[k]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Round-off of systems of order one with four unknowns.
    const ROUND_OFF: f64 = 1e-13;

    #[test]
    fn identity_ldl_solves_a_symmetric_system() {
        let n = 4;
        let matrix: Vec<f64> = vec![4.1, 1.2, -0.7, 0.3, 1.2, 5.3, 0.9, -1.1, -0.7, 0.9, 3.7, 0.6, 0.3, -1.1, 0.6, 2.9];
        let x = [0.3, -1.7, 2.2, 0.9];
        let mut b: Vec<f64> = (0..n).map(|i| (0..n).map(|j| matrix[i * n + j] * x[j]).sum()).collect();
        let mut factors = matrix.clone();
        factor_ldl(&mut factors, n);
        solve_ldl(&factors, n, &mut b);
        for (solved, exact) in b.iter().zip(x) {
            assert!((solved - exact).abs() < ROUND_OFF);
        }
    }

    #[test]
    fn identity_an_envelope_leaves_the_bits_as_they_are() {
        // Blocks of 3, 1 and 4; row 6 begins one later than its block.
        let first = vec![0, 0, 0, 3, 4, 4, 5, 4];
        let n = first.len();
        let mut dense = vec![0.0; n * n];
        for (i, &begin) in first.iter().enumerate() {
            for j in begin..i {
                dense[i * n + j] = 0.3 + 0.1 * (i * n + j) as f64 % 0.7;
                dense[j * n + i] = dense[i * n + j];
            }
            dense[i * n + i] = 3.1 + 0.2 * i as f64;
        }
        let (mut narrow, envelope) = (dense.clone(), Envelope::new(first));
        let mut expected: Vec<f64> = (0..n).map(|i| 0.9 - 0.37 * i as f64).collect();
        let mut found = expected.clone();
        factor_ldl(&mut dense, n);
        solve_ldl(&dense, n, &mut expected);
        envelope.factor_ldl(&mut narrow);
        envelope.solve_ldl(&narrow, &mut found);
        assert_eq!((narrow, found), (dense, expected));
        assert_eq!(envelope.multiplications(), 0.5 * (1.0 + 4.0 + 1.0 + 1.0 + 9.0));
    }

    /// A positive definite matrix of order `n` with `band` entries beside the diagonal, and a right-hand side.
    fn system(n: usize, band: usize) -> (Vec<f64>, Vec<f64>) {
        let mut a = vec![0.0; n * n];
        for i in 0..n {
            for j in i.saturating_sub(band)..i {
                a[i * n + j] = (0.7 * (i * j + 3) as f64).sin();
                a[j * n + i] = a[i * n + j];
            }
            a[i * n + i] = 2.3 * (band + 1) as f64 + (1.3 * i as f64).cos();
        }
        (a, (0..n).map(|i| (0.9 * i as f64).sin() - 0.4).collect())
    }

    #[test]
    fn identity_same_bits_as_the_dense_factors() {
        for (n, band) in [(1, 0), (7, 6), (12, 1), (30, 4), (9, 0)] {
            let (a, b) = system(n, band);
            let (mut dense, mut expected) = (a.clone(), b.clone());
            factor_ldl(&mut dense, n);
            solve_ldl(&dense, n, &mut expected);
            let (mut sparse, mut found) = (a, b);
            solve_sparse_symmetric(&mut sparse, n, &mut found);
            assert_eq!(found, expected, "{n} unknowns, {band} beside the diagonal");
        }
    }

    #[test]
    fn identity_zeros_below_the_diagonal_are_not_read() {
        let (a, b) = system(12, 2);
        let mut upper = a.clone();
        for i in 0..12 {
            upper[i * 12..i * 12 + i].fill(f64::NAN);
        }
        let mut found = b.clone();
        solve_sparse_symmetric(&mut upper, 12, &mut found);
        for (i, right) in b.iter().enumerate() {
            let left: f64 = (0..12).map(|j| a[i * 12 + j] * found[j]).sum();
            assert!((left - right).abs() < 1e-13);
        }
    }
}

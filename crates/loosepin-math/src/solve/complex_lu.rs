//! Dense complex systems that are solved for many right-hand sides.

/// Factors of a square complex matrix, with row exchanges.
#[derive(Debug, Clone)]
pub struct ComplexLu {
    order: usize,
    /// Real parts of the matrix, row by row; then of its factors.
    pub real: Vec<f64>,
    /// Imaginary parts.
    pub imaginary: Vec<f64>,
    rows: Vec<usize>,
}

impl ComplexLu {
    /// Room for an order.
    pub fn new(order: usize) -> Self {
        let zeros = || vec![0.0; order * order];
        Self { order, real: zeros(), imaginary: zeros(), rows: (0..order).collect() }
    }

    /// Replaces the matrix by its factors.
    pub fn factor(&mut self) {
        let n = self.order;
        let (re, im) = (&mut self.real, &mut self.imaginary);
        for j in 0..n {
            let size = |i: usize| re[i * n + j].abs() + im[i * n + j].abs();
            let best = (j..n).max_by(|&i, &k| size(i).total_cmp(&size(k))).unwrap_or(j);
            self.rows[j] = best;
            if best != j {
                for k in 0..n {
                    re.swap(j * n + k, best * n + k);
                    im.swap(j * n + k, best * n + k);
                }
            }
            let (p, q) = (re[j * n + j], im[j * n + j]);
            let square = p * p + q * q;
            for i in j + 1..n {
                let (x, y) = (re[i * n + j], im[i * n + j]);
                if x == 0.0 && y == 0.0 {
                    continue;
                }
                let (f, g) = ((x * p + y * q) / square, (y * p - x * q) / square);
                re[i * n + j] = f;
                im[i * n + j] = g;
                let (re_above, re_below) = re.split_at_mut(i * n);
                let (im_above, im_below) = im.split_at_mut(i * n);
                let range = j * n + j + 1..(j + 1) * n;
                let pivots = re_above[range.clone()].iter().zip(&im_above[range]);
                for ((re, im), (p, q)) in re_below[j + 1..n].iter_mut().zip(&mut im_below[j + 1..n]).zip(pivots) {
                    *re -= f * p - g * q;
                    *im -= f * q + g * p;
                }
            }
        }
    }

    /// Solves in place.
    pub fn solve(&self, real: &mut [f64], imaginary: &mut [f64]) {
        let n = self.order;
        for j in 0..n {
            real.swap(j, self.rows[j]);
            imaginary.swap(j, self.rows[j]);
        }
        for i in 0..n {
            let [x, y] = self.row_times(i, 0..i, real, imaginary);
            real[i] -= x;
            imaginary[i] -= y;
        }
        for i in (0..n).rev() {
            let [x, y] = self.row_times(i, i + 1..n, real, imaginary);
            let (x, y) = (real[i] - x, imaginary[i] - y);
            let (p, q) = (self.real[i * n + i], self.imaginary[i * n + i]);
            let square = p * p + q * q;
            real[i] = (x * p + y * q) / square;
            imaginary[i] = (y * p - x * q) / square;
        }
    }

    fn row_times(&self, row: usize, columns: std::ops::Range<usize>, real: &[f64], imaginary: &[f64]) -> [f64; 2] {
        let entries = row * self.order + columns.start..row * self.order + columns.end;
        let (re, im) = (&self.real[entries.clone()], &self.imaginary[entries]);
        let values = real[columns.clone()].iter().zip(&imaginary[columns]);
        re.iter().zip(im).zip(values).fold([0.0; 2], |[x, y], ((p, q), (u, v))| [x + p * u - q * v, y + p * v + q * u])
    }
}

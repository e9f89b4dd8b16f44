//! Dense linear algebra of the independent optimiser: one-sided Jacobi rotations (M. R. Hestenes, J. SIAM 6 (1958) 51).

/// A matrix by its columns.
pub type Columns = Vec<Vec<f64>>;

pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

pub fn length(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

pub fn add(sum: &mut [f64], part: &[f64], factor: f64) {
    sum.iter_mut().zip(part).for_each(|(sum, part)| *sum += factor * part);
}

/// Columns times a vector.
pub fn times(columns: &Columns, vector: &[f64]) -> Vec<f64> {
    let mut sum = vec![0.0; columns.first().map_or(0, Vec::len)];
    for (column, factor) in columns.iter().zip(vector) {
        add(&mut sum, column, *factor);
    }
    sum
}

/// A V = images, V orthogonal, the images at right angles to each other: their lengths are the singular values.
pub struct Jacobi {
    pub images: Columns,
    pub right: Columns,
}

impl Jacobi {
    pub fn new(matrix: &Columns) -> Self {
        let count = matrix.len();
        let mut images = matrix.clone();
        let mut right: Columns =
            (0..count).map(|k| (0..count).map(|i| f64::from(u8::from(i == k))).collect()).collect();
        for _ in 0..60 {
            let mut largest: f64 = 0.0;
            for i in 0..count {
                for j in i + 1..count {
                    let (a, b, c) =
                        (dot(&images[i], &images[i]), dot(&images[j], &images[j]), dot(&images[i], &images[j]));
                    // Columns that are zero but for round-off have no angle.
                    if c.abs() <= 1e-15 * (a * b).sqrt() || c.abs() < 1e-300 {
                        continue;
                    }
                    largest = largest.max(c.abs() / (a * b).sqrt());
                    let half = (b - a) / (2.0 * c);
                    let tangent = half.signum() / (half.abs() + (1.0 + half * half).sqrt());
                    let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
                    for pair in [&mut images, &mut right] {
                        let (first, second) = pair.split_at_mut(j);
                        for (x, y) in first[i].iter_mut().zip(&mut second[0]) {
                            (*x, *y) = (cosine * (*x - tangent * *y), cosine * (*y + tangent * *x));
                        }
                    }
                }
            }
            if largest < 1e-13 {
                break;
            }
        }
        Self { images, right }
    }

    /// The largest singular value.
    pub fn largest(&self) -> f64 {
        self.images.iter().map(|image| length(image)).fold(0.0, f64::max)
    }

    /// Right vectors of singular values that are at most `threshold` of the largest.
    pub fn null_space(&self, threshold: f64) -> Columns {
        let least = threshold * self.largest();
        let pairs = self.images.iter().zip(&self.right);
        pairs.filter(|(image, _)| length(image) <= least).map(|(_, right)| right.clone()).collect()
    }

    /// The shortest x with A x nearest to b.
    pub fn solve(&self, b: &[f64], threshold: f64) -> Vec<f64> {
        let least = threshold * self.largest();
        let mut x = vec![0.0; self.right.len()];
        for (image, right) in self.images.iter().zip(&self.right).filter(|(image, _)| length(image) > least) {
            add(&mut x, right, dot(image, b) / dot(image, image));
        }
        x
    }
}

//! Singular values, and what they say of a rectangular system: rank, null spaces, the shortest least-squares solution.

/// Sweeps after which the columns are taken as they are; eight are usual.
const MAX_SWEEPS: usize = 40;
/// Columns are orthogonal when the cosine between them is below this.
const ORTHOGONAL: f64 = 1e-15;

/// A = U Σ Vᵀ of a `rows` × `columns` matrix, by rotations of its columns (one-sided Jacobi, M. R. Hestenes, J. SIAM 6 (1958) 51). Small
/// singular values keep their digits. U and V are square: their last vectors span the null spaces.
#[derive(Debug, Clone)]
pub struct SingularValues {
    rows: usize,
    columns: usize,
    values: Vec<f64>,
    left: Vec<Vec<f64>>,
    right: Vec<Vec<f64>>,
}

impl SingularValues {
    /// Decomposes `matrix`, row by row. Entries that are not finite give values that are not.
    pub fn new(matrix: &[f64], rows: usize, columns: usize) -> Self {
        let mut found = Self::thin(matrix, rows, columns);
        let (side, size) = if columns > rows { (&mut found.right, columns) } else { (&mut found.left, rows) };
        *side = completed(std::mem::take(side), size);
        found
    }

    /// The same without vectors of null spaces that no rotation makes: of the longer side there are only those of singular values above round-off.
    pub fn thin(matrix: &[f64], rows: usize, columns: usize) -> Self {
        let is_wide = columns > rows;
        let (height, width) = if is_wide { (columns, rows) } else { (rows, columns) };
        let entry = |i: usize, j: usize| if is_wide { matrix[j * columns + i] } else { matrix[i * columns + j] };
        let mut images: Vec<Vec<f64>> = (0..width).map(|j| (0..height).map(|i| entry(i, j)).collect()).collect();
        let mut turned: Vec<Vec<f64>> = (0..width).map(|j| unit(width, j)).collect();
        for _ in 0..MAX_SWEEPS {
            let mut is_done = true;
            for p in 0..width {
                for q in p + 1..width {
                    is_done &= !rotate(&mut images, &mut turned, p, q);
                }
            }
            if is_done {
                break;
            }
        }
        let mut order: Vec<usize> = (0..width).collect();
        let lengths: Vec<f64> = images.iter().map(|image| dot(image, image).sqrt()).collect();
        order.sort_by(|&a, &b| lengths[b].total_cmp(&lengths[a]));
        let values: Vec<f64> = order.iter().map(|&k| lengths[k]).collect();
        // A column at round-off has no direction of its own: its place is filled with those of the null space.
        let smallest = values.first().map_or(0.0, |largest| largest * f64::EPSILON);
        let long = order.iter().filter(|&&k| lengths[k] > smallest);
        let image_side = long.map(|&k| images[k].iter().map(|entry| entry / lengths[k]).collect()).collect();
        let turned_side: Vec<Vec<f64>> = order.iter().map(|&k| turned[k].clone()).collect();
        let (left, right) = if is_wide { (turned_side, image_side) } else { (image_side, turned_side) };
        Self { rows, columns, values, left, right }
    }

    /// The singular values, largest first.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// How many singular values are larger than `relative_threshold` times the largest.
    pub fn rank(&self, relative_threshold: f64) -> usize {
        let Some(largest) = self.values.first() else { return 0 };
        self.values.iter().take_while(|value| **value > largest * relative_threshold).count()
    }

    /// The left vector of singular value `k`; from the rank on: x with xᵀA = 0.
    pub fn left(&self, k: usize) -> &[f64] {
        &self.left[k]
    }

    /// The right vector of singular value `k`; from the rank on: x with A x = 0.
    pub fn right(&self, k: usize) -> &[f64] {
        &self.right[k]
    }

    /// The vectors x with xᵀA = 0 that a rank leaves: orthonormal.
    pub fn left_null_space(&self, rank: usize) -> Vec<Vec<f64>> {
        self.left[rank.min(self.rows)..].to_vec()
    }

    /// The vectors x with A x = 0 that a rank leaves: orthonormal.
    pub fn right_null_space(&self, rank: usize) -> Vec<Vec<f64>> {
        self.right[rank.min(self.columns)..].to_vec()
    }

    /// The shortest x that comes nearest to A x = b, over the first `rank` singular values.
    pub fn solve(&self, right_hand_side: &[f64], rank: usize) -> Vec<f64> {
        let mut solution = vec![0.0; self.columns];
        for k in 0..rank.min(self.values.len()) {
            let share = dot(&self.left[k], right_hand_side) / self.values[k];
            solution.iter_mut().zip(&self.right[k]).for_each(|(sum, entry)| *sum += share * entry);
        }
        solution
    }
}

/// Turns columns p and q, with `turned` alike, so that they are orthogonal; whether they were not.
fn rotate(images: &mut [Vec<f64>], turned: &mut [Vec<f64>], p: usize, q: usize) -> bool {
    let (first, second) = (dot(&images[p], &images[p]), dot(&images[q], &images[q]));
    let product = dot(&images[p], &images[q]);
    // What is not a number is left alone.
    if !(product.abs() > ORTHOGONAL * (first * second).sqrt()) || product.abs() < f64::MIN_POSITIVE {
        return false;
    }
    let half = (second - first) / (2.0 * product);
    let tangent = half.signum() / (half.abs() + (1.0 + half * half).sqrt());
    let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
    let sine = tangent * cosine;
    for pair in [images, turned] {
        let (head, tail) = pair.split_at_mut(q);
        for (a, b) in head[p].iter_mut().zip(&mut tail[0]) {
            (*a, *b) = (cosine * *a - sine * *b, sine * *a + cosine * *b);
        }
    }
    true
}

/// Orthonormal vectors, with others appended until they span all of `size` dimensions.
fn completed(mut vectors: Vec<Vec<f64>>, size: usize) -> Vec<Vec<f64>> {
    while vectors.len() < size {
        // The axis that sticks out most is at least 1/√size outside.
        let outside = |k: usize| vectors.iter().map(|vector| vector[k] * vector[k]).sum::<f64>();
        let axis = (0..size).min_by(|&a, &b| outside(a).total_cmp(&outside(b))).unwrap_or(0);
        let mut next = unit(size, axis);
        for _ in 0..2 {
            for vector in &vectors {
                let share = dot(&next, vector);
                next.iter_mut().zip(vector).for_each(|(entry, part)| *entry -= share * part);
            }
        }
        let length = dot(&next, &next).sqrt();
        next.iter_mut().for_each(|entry| *entry /= length);
        vectors.push(next);
    }
    vectors
}

fn unit(size: usize, axis: usize) -> Vec<f64> {
    (0..size).map(|k| f64::from(u8::from(k == axis))).collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

#[cfg(test)]
mod tests {
    use super::{SingularValues, dot};

    /// Round-off of sums of a dozen products of numbers of order one.
    const ROUND_OFF: f64 = 1e-13;

    /// Numbers without a pattern.
    fn numbers(count: usize) -> Vec<f64> {
        (0..count).map(|k| libm::sin(1.7 + 3.1 * k as f64 + 0.37 * (k * k) as f64)).collect()
    }

    #[test]
    fn identity_the_factors_are_orthonormal_and_give_the_matrix() {
        for (rows, columns) in [(5, 5), (7, 4), (4, 7), (1, 3), (3, 1)] {
            let matrix = numbers(rows * columns);
            let found = SingularValues::new(&matrix, rows, columns);
            for side in [&found.left, &found.right] {
                for (i, a) in side.iter().enumerate() {
                    for (j, b) in side.iter().enumerate() {
                        assert!((dot(a, b) - f64::from(u8::from(i == j))).abs() < ROUND_OFF);
                    }
                }
            }
            assert_eq!((found.left.len(), found.right.len()), (rows, columns));
            for i in 0..rows {
                for j in 0..columns {
                    let sum: f64 =
                        (0..found.values.len()).map(|k| found.left(k)[i] * found.values[k] * found.right(k)[j]).sum();
                    assert!((sum - matrix[i * columns + j]).abs() < ROUND_OFF);
                }
            }
        }
    }

    #[test]
    fn analytic_singular_values_rank_and_null_spaces() {
        // Singular values of [[1, 1], [0, 1]]: the golden ratio and its inverse.
        let golden = 0.5 * (1.0 + 5.0_f64.sqrt());
        let found = SingularValues::new(&[1.0, 1.0, 0.0, 1.0], 2, 2);
        assert!((found.values()[0] - golden).abs() < ROUND_OFF && (found.values()[1] - 1.0 / golden).abs() < ROUND_OFF);
        // Third row is the sum of the others, and so is the third column.
        let matrix = [1.0, 2.0, 3.0, 4.0, -1.0, 3.0, 5.0, 1.0, 6.0];
        let found = SingularValues::new(&matrix, 3, 3);
        assert_eq!(found.rank(1e-9), 2);
        let root = 1.0 / 3.0_f64.sqrt();
        for null in [&found.left_null_space(2)[0], &found.right_null_space(2)[0]] {
            let sign = null[0].signum();
            for (entry, expected) in null.iter().zip([root, root, -root]) {
                assert!((sign * entry - expected).abs() < ROUND_OFF, "{null:?}");
            }
        }
        // The shortest solution of a consistent system is across the null space.
        let solution = found.solve(&[3.0, 3.0, 6.0], 2);
        assert!((solution[0] + solution[1] - solution[2]).abs() < ROUND_OFF);
        assert!((solution[0] + 2.0 * solution[1] + 3.0 * solution[2] - 3.0).abs() < ROUND_OFF);
        assert!((4.0 * solution[0] - solution[1] + 3.0 * solution[2] - 3.0).abs() < ROUND_OFF);
    }

    #[test]
    fn analytic_a_matrix_of_zeros_and_one_without_columns() {
        let zero = SingularValues::new(&[0.0; 6], 2, 3);
        assert_eq!((zero.rank(1e-9), zero.left_null_space(0).len(), zero.right_null_space(0).len()), (0, 2, 3));
        let empty = SingularValues::new(&[], 2, 0);
        assert_eq!((empty.rank(1e-9), empty.left_null_space(0).len()), (0, 2));
    }
}

//! Rectangular systems of known rank, made square by their null spaces.

use crate::closure::loops::{Loops, RowEntries};
use crate::closure::sparse_lu::SparseLu;
use crate::kind::frames::JointFrames;
use loosepin_math::SingularValues;

/// What is left of null vectors, lengths over L and rad, where the rank is as it was.
const RANK_DEFECT: f64 = 1e-6;

/// Bases of the left and right null spaces of a Jacobian of rank r: m - r vectors of m entries, n - r vectors of n entries.
#[derive(Debug, Clone, Default)]
pub(crate) struct Borders {
    pub left: Vec<Vec<f64>>,
    pub right: Vec<Vec<f64>>,
}

impl Borders {
    pub(crate) fn new(values: &SingularValues, rank: usize) -> Self {
        Self { left: values.left_null_space(rank), right: values.right_null_space(rank) }
    }
}

/// [[J, N], [Vᵀ, 0]], N and V spanning the null spaces of J, or of a J close by. It is regular where J has the rank of the borders.
#[derive(Debug, Clone, Default)]
pub(crate) struct Bordered {
    rows: usize,
    columns: usize,
    lu: SparseLu,
}

/// The smallest singular value and its vectors.
#[derive(Debug, Clone)]
pub(crate) struct Weakest {
    pub sigma: f64,
    /// y, of the rows.
    pub row: Vec<f64>,
    /// w, of the unknowns.
    pub motion: Vec<f64>,
}

impl Bordered {
    /// The system at these frames.
    pub(crate) fn new(loops: &Loops, frames: &[JointFrames], borders: &Borders) -> Self {
        let mut system = Self::default();
        system.factor(loops, frames, borders);
        system
    }

    /// The system at these frames in the memory of another.
    pub(crate) fn factor(&mut self, loops: &Loops, frames: &[JointFrames], borders: &Borders) {
        (self.rows, self.columns) = (loops.rows.len(), loops.unknowns());
        self.lu.clear(self.columns + borders.left.len());
        for (number, row) in loops.rows.iter().enumerate() {
            for (first, values) in loops.row_entries(row, frames).into_iter().flatten() {
                self.lu.add(number, first, &values);
            }
        }
        for (k, null) in borders.left.iter().enumerate() {
            null.iter().enumerate().for_each(|(row, entry)| self.lu.add(row, self.columns + k, &[*entry]));
        }
        for (k, null) in borders.right.iter().enumerate() {
            self.lu.add(self.rows + k, 0, null);
        }
        self.lu.factor();
    }

    /// Number of unknowns, borders included.
    pub(crate) fn order(&self) -> usize {
        self.lu.order()
    }

    /// x and ν with J x + N ν = b, Vᵀx = 0, in place of b and zeros.
    pub(crate) fn solve_in_place(&self, vector: &mut Vec<f64>) {
        vector.resize(self.lu.order(), 0.0);
        self.lu.solve(vector);
    }

    /// y and ρ with Jᵀy + V ρ = c, Nᵀy = 0, in place of c and zeros.
    pub(crate) fn solve_transposed_in_place(&self, vector: &mut Vec<f64>) {
        vector.resize(self.lu.order(), 0.0);
        self.lu.solve_transposed(vector);
    }

    /// x and ν with J x + N ν = b, Vᵀx = 0: ν is the part of b that no motion can make.
    pub(crate) fn solve(&self, right_hand_side: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let mut vector = right_hand_side.to_vec();
        self.solve_in_place(&mut vector);
        let apart = vector.split_off(self.columns);
        (vector, apart)
    }

    /// y and ρ with Jᵀy + V ρ = c, Nᵀy = 0: y turns changes of rows into changes of an output with gradient c, but for the part ρ of it that is
    /// along free motions.
    pub(crate) fn solve_transposed(&self, gradient: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let mut vector = gradient.to_vec();
        self.solve_transposed_in_place(&mut vector);
        let along = vector.split_off(self.rows);
        (vector, along)
    }

    /// The null spaces of this J itself, with the orientation of those that border it. `None` if they have fewer dimensions.
    pub(crate) fn null_spaces(&self) -> Option<Borders> {
        let size = self.lu.order();
        let unit = |place: usize| {
            let mut vector = vec![0.0; size];
            vector[place] = 1.0;
            vector
        };
        let mut defects: Vec<f64> = Vec::new();
        let mut left: Vec<Vec<f64>> = Vec::new();
        for place in self.columns..size {
            let mut vector = unit(place);
            self.lu.solve_transposed(&mut vector);
            defects.extend_from_slice(&vector[self.rows..]);
            vector.truncate(self.rows);
            push_orthonormal(&mut left, vector);
        }
        let mut right: Vec<Vec<f64>> = Vec::new();
        for place in self.rows..size {
            let mut vector = unit(place);
            self.lu.solve(&mut vector);
            defects.extend_from_slice(&vector[self.columns..]);
            vector.truncate(self.columns);
            push_orthonormal(&mut right, vector);
        }
        // Not a number is no defect that is small.
        defects.iter().all(|defect| defect.abs() <= RANK_DEFECT).then_some(Borders { left, right })
    }

    /// The vectors y with Jᵀy + V ρ = 0 and Nᵀy = e_k, one for each redundant row: the parts of ν that rows make.
    pub(crate) fn redundant_rows(&self) -> Vec<Vec<f64>> {
        let size = self.lu.order();
        (self.columns..size)
            .map(|place| {
                let mut vector = vec![0.0; size];
                vector[place] = 1.0;
                self.lu.solve_transposed(&mut vector);
                vector.truncate(self.rows);
                vector
            })
            .collect()
    }

    /// The smallest singular value σ with its vectors y and w, J w = σ y, by inverse iteration. Near a dead centre y is what the loops can hardly
    /// follow, and w how they move then.
    pub(crate) fn weakest(&self) -> Weakest {
        const STEPS: usize = 8;
        let size = self.lu.order();
        // No direction of its own.
        let mut vector: Vec<f64> = (0..size).map(|k| 1.0 + 0.37 * ((3 * k + 1) % 7) as f64).collect();
        for _ in 0..STEPS {
            self.lu.solve(&mut vector);
            self.lu.solve_transposed(&mut vector);
            let length = dot(&vector, &vector).sqrt();
            vector.iter_mut().for_each(|entry| *entry /= length);
        }
        let mut motion = vector.clone();
        self.lu.solve(&mut motion);
        let sigma = 1.0 / dot(&motion, &motion).sqrt();
        motion.truncate(self.columns);
        motion.iter_mut().for_each(|entry| *entry *= sigma);
        vector.truncate(self.rows);
        Weakest { sigma, row: vector, motion }
    }

    /// Sign of the determinant: it changes where a mechanism passes from one assembly to another.
    pub(crate) fn sign(&self) -> f64 {
        self.lu.determinant_sign()
    }

    /// Size of the smallest pivot over that of the largest.
    pub(crate) fn pivot_ratio(&self) -> f64 {
        self.lu.pivot_ratio()
    }

    /// Smallest singular value over the largest, each by steps of the power method, to about 1 %. With borders that are the null spaces these
    /// are the singular values of J that count, and ones. 0 where it is singular. `frames` and `borders` are those that it was made with.
    pub(crate) fn singular_ratio(&self, loops: &Loops, frames: &[JointFrames], borders: &Borders) -> f64 {
        if !(self.lu.pivot_ratio() > f64::EPSILON) {
            return 0.0;
        }
        let size = self.lu.order();
        let inverse_square = power_method(size, |vector| {
            self.lu.solve_transposed(vector);
            self.lu.solve(vector);
        });
        let rows: Vec<RowEntries> = loops.rows.iter().map(|row| loops.row_entries(row, frames)).collect();
        let mut image = vec![0.0; size];
        let square = power_method(size, |vector| {
            image.clear();
            image.extend(rows.iter().map(|row| {
                let parts = row.iter().flatten();
                parts.map(|(first, values)| dot(values, &vector[*first..first + 6])).sum::<f64>()
            }));
            for (null, share) in borders.left.iter().zip(&vector[self.columns..]) {
                image.iter_mut().zip(null).for_each(|(sum, entry)| *sum += entry * share);
            }
            image.extend(borders.right.iter().map(|null| dot(null, vector)));
            vector.fill(0.0);
            for (row, value) in rows.iter().zip(&image) {
                for (first, values) in row.iter().flatten() {
                    vector[*first..first + 6].iter_mut().zip(values).for_each(|(sum, entry)| *sum += entry * value);
                }
            }
            for (k, null) in borders.left.iter().enumerate() {
                vector[self.columns + k] = dot(null, &image);
            }
            for (null, value) in borders.right.iter().zip(&image[self.rows..]) {
                vector.iter_mut().zip(null).for_each(|(sum, entry)| *sum += entry * value);
            }
        });
        1.0 / (inverse_square * square).sqrt()
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn push_orthonormal(basis: &mut Vec<Vec<f64>>, mut vector: Vec<f64>) {
    for known in basis.iter() {
        let share = dot(&vector, known);
        vector.iter_mut().zip(known).for_each(|(entry, part)| *entry -= share * part);
    }
    let length = dot(&vector, &vector).sqrt();
    vector.iter_mut().for_each(|entry| *entry /= length);
    basis.push(vector);
}

/// The largest eigenvalue of a symmetric positive operator, to about 1 %.
fn power_method(size: usize, mut apply: impl FnMut(&mut [f64])) -> f64 {
    const MAX_STEPS: usize = 60;
    // No direction of its own.
    let mut vector: Vec<f64> = (0..size).map(|k| 1.0 + 0.37 * ((3 * k + 1) % 7) as f64).collect();
    let mut found = 0.0;
    for _ in 0..MAX_STEPS {
        let length = vector.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
        vector.iter_mut().for_each(|entry| *entry /= length);
        apply(&mut vector);
        let next = vector.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
        if !(next.is_finite() && (next - found).abs() > 1e-3 * next) {
            return next;
        }
        found = next;
    }
    found
}

//! Rectangular systems of known rank, made square by their null spaces.

use loosepin_math::{RealLu, SingularValues};

/// Bases of the left and right null spaces of a Jacobian of rank r: m - r vectors of m entries, n - r vectors of n entries.
#[derive(Debug, Clone)]
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
#[derive(Debug, Clone)]
pub(crate) struct Bordered {
    rows: usize,
    columns: usize,
    lu: RealLu,
}

impl Bordered {
    pub(crate) fn new(jacobian: &[f64], rows: usize, columns: usize, borders: &Borders) -> Self {
        let size = columns + borders.left.len();
        let mut lu = RealLu::new(size);
        for (row, entries) in jacobian.chunks(columns.max(1)).enumerate().take(rows) {
            lu.matrix[row * size..row * size + columns].copy_from_slice(entries);
        }
        for (k, null) in borders.left.iter().enumerate() {
            null.iter().enumerate().for_each(|(row, entry)| lu.matrix[row * size + columns + k] = *entry);
        }
        for (k, null) in borders.right.iter().enumerate() {
            lu.matrix[(rows + k) * size..(rows + k) * size + columns].copy_from_slice(null);
        }
        lu.factor();
        Self { rows, columns, lu }
    }

    /// x and ν with J x + N ν = b, Vᵀx = 0: ν is the part of b that no motion can make.
    pub(crate) fn solve(&self, right_hand_side: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let mut vector = right_hand_side.to_vec();
        vector.resize(self.lu.order(), 0.0);
        self.lu.solve(&mut vector);
        let apart = vector.split_off(self.columns);
        (vector, apart)
    }

    /// y and ρ with Jᵀy + V ρ = c, Nᵀy = 0: y turns changes of rows into changes of an output with gradient c, but for the part ρ of it that is
    /// along free motions.
    pub(crate) fn solve_transposed(&self, gradient: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let mut vector = gradient.to_vec();
        vector.resize(self.lu.order(), 0.0);
        self.lu.solve_transposed(&mut vector);
        let along = vector.split_off(self.rows);
        (vector, along)
    }

    /// The null spaces of this J itself, with the orientation of those that border it.
    pub(crate) fn null_spaces(&self) -> Borders {
        let size = self.lu.order();
        let unit = |place: usize| {
            let mut vector = vec![0.0; size];
            vector[place] = 1.0;
            vector
        };
        let mut left: Vec<Vec<f64>> = Vec::new();
        for place in self.columns..size {
            let mut vector = unit(place);
            self.lu.solve_transposed(&mut vector);
            vector.truncate(self.rows);
            push_orthonormal(&mut left, vector);
        }
        let mut right: Vec<Vec<f64>> = Vec::new();
        for place in self.rows..size {
            let mut vector = unit(place);
            self.lu.solve(&mut vector);
            vector.truncate(self.columns);
            push_orthonormal(&mut right, vector);
        }
        Borders { left, right }
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

    /// Sign of the determinant: it changes where a mechanism passes from one assembly to another.
    pub(crate) fn sign(&self) -> f64 {
        self.lu.determinant_sign()
    }

    /// Whether it can be solved at all.
    pub(crate) fn is_regular(&self) -> bool {
        self.lu.pivot_ratio() > f64::EPSILON
    }
}

fn push_orthonormal(basis: &mut Vec<Vec<f64>>, mut vector: Vec<f64>) {
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    for known in basis.iter() {
        let share = product(&vector, known);
        vector.iter_mut().zip(known).for_each(|(entry, part)| *entry -= share * part);
    }
    let length = product(&vector, &vector).sqrt();
    vector.iter_mut().for_each(|entry| *entry /= length);
    basis.push(vector);
}

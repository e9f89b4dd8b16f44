//! Small linear programmes over the unit box, with bounds that hold whatever rounding did.

/// Entries of a tableau below this size are round-off: rows and variables are scaled to order one.
const ROUND_OFF: f64 = 1e-11;
/// Pivots, at most, for each row and column: Bland's rule ends before, but round-off could cycle.
const PIVOTS: usize = 200;

/// max c·y over 0 <= y <= 1 and a_j·y <= b_j.
#[derive(Debug, Clone, Default)]
pub(crate) struct LinearProgram {
    variables: usize,
    rows: Vec<Inequality>,
}

#[derive(Debug, Clone)]
struct Inequality {
    coefficients: Vec<f64>,
    limit: f64,
}

/// The largest value of an objective.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Largest {
    /// A number that no point of the set exceeds: bᵀλ + Σ max(0, c - Aᵀλ), the dual objective at the multipliers λ >= 0 that
    /// the simplex method ended with. It bounds from above for any λ >= 0, so that round-off widens it at most.
    pub value: f64,
    /// The point where it is attained, to round-off.
    pub point: Vec<f64>,
}

impl LinearProgram {
    /// The unit box of `variables` dimensions.
    pub fn new(variables: usize) -> Self {
        Self { variables, rows: Vec::new() }
    }

    /// Demands coefficients·y <= limit. Rows are scaled, so that their units do not matter.
    pub fn add_constraint(&mut self, coefficients: Vec<f64>, limit: f64) {
        debug_assert_eq!(coefficients.len(), self.variables, "a coefficient for each variable");
        let size = coefficients.iter().fold(limit.abs(), |size, entry| size.max(entry.abs()));
        let scale = if size > 0.0 { 1.0 / size } else { 1.0 };
        let coefficients = coefficients.into_iter().map(|entry| entry * scale).collect();
        self.rows.push(Inequality { coefficients, limit: limit * scale });
    }

    /// The largest `objective`·y over the set; `None` if the set is empty.
    pub fn largest(&self, objective: &[f64]) -> Option<Largest> {
        let mut tableau = Tableau::new(self);
        if !tableau.find_feasible() {
            if self.is_proof_of_emptiness(&tableau.multipliers()) {
                return None;
            }
            // Undecided: the bound of the box holds.
            let value = objective.iter().map(|entry| entry.max(0.0)).sum();
            return Some(Largest { value, point: tableau.point(self.variables) });
        }
        tableau.set_objective(objective);
        tableau.climb();
        let point = tableau.point(self.variables);
        let multipliers = tableau.multipliers();
        let value = self.dual_value(objective, &multipliers);
        Some(Largest { value, point })
    }

    /// Whether no y keeps all rows, with proof: what is undecided is not empty.
    pub fn is_empty(&self) -> bool {
        let mut tableau = Tableau::new(self);
        !tableau.find_feasible() && self.is_proof_of_emptiness(&tableau.multipliers())
    }

    /// Whether λ >= 0 proves that no y keeps all rows (Farkas): then 0·y has the upper bound bᵀλ + Σ max(0, -Aᵀλ) < 0, which a point
    /// of the set would contradict. It holds for any λ, wherever the simplex method stopped; the sum is taken with its round-off.
    fn is_proof_of_emptiness(&self, multipliers: &[f64]) -> bool {
        let size: f64 = multipliers.iter().sum();
        let terms = (self.rows.len() * (self.variables + 1)) as f64;
        self.dual_value(&vec![0.0; self.variables], multipliers) < -f64::EPSILON * terms * size
    }

    /// bᵀλ + Σ max(0, c - Aᵀλ): by weak duality an upper bound of c·y over the set, since 0 <= y <= 1.
    fn dual_value(&self, objective: &[f64], multipliers: &[f64]) -> f64 {
        let mut left = objective.to_vec();
        let mut value = 0.0;
        for (row, multiplier) in self.rows.iter().zip(multipliers) {
            value += multiplier * row.limit;
            for (left, coefficient) in left.iter_mut().zip(&row.coefficients) {
                *left -= multiplier * coefficient;
            }
        }
        value + left.iter().map(|entry| entry.max(0.0)).sum::<f64>()
    }
}

/// Simplex tableau with Bland's rule (Chvátal, Linear Programming, 1983, chapters 2 and 3): x_basic = constant + Σ entry·x_nonbasic.
///
/// Variables: y_1 … y_n; a slack for each row, then for each upper limit y_i <= 1; last the one that is subtracted from every row
/// while a first point is looked for.
struct Tableau {
    /// Rows: constant first, then the entries of the nonbasic variables.
    rows: Vec<Vec<f64>>,
    objective: Vec<f64>,
    basic: Vec<usize>,
    nonbasic: Vec<usize>,
    variables: usize,
    limits: usize,
}

impl Tableau {
    fn new(program: &LinearProgram) -> Self {
        let n = program.variables;
        let mut rows: Vec<Vec<f64>> = Vec::with_capacity(program.rows.len() + n);
        for row in &program.rows {
            let entries = row.coefficients.iter().map(|entry| -entry);
            rows.push(std::iter::once(row.limit).chain(entries).chain([1.0]).collect());
        }
        for upper in 0..n {
            let entry = |variable: usize| if variable == upper { -1.0 } else { 0.0 };
            rows.push(std::iter::once(1.0).chain((0..n).map(entry)).chain([0.0]).collect());
        }
        let count = rows.len();
        let helper = n + count;
        Self {
            basic: (n..n + count).collect(),
            nonbasic: (0..n).chain([helper]).collect(),
            objective: vec![0.0; n + 2],
            rows,
            variables: n,
            limits: program.rows.len(),
        }
    }

    /// Phase one: the helper is brought to zero, or cannot be.
    fn find_feasible(&mut self) -> bool {
        let column = self.nonbasic.len() - 1;
        let helper = self.nonbasic[column];
        let worst = (0..self.rows.len()).min_by(|a, b| self.rows[*a][0].total_cmp(&self.rows[*b][0]));
        if let Some(worst) = worst.filter(|row| self.rows[*row][0] < 0.0) {
            self.objective.fill(0.0);
            self.objective[column + 1] = -1.0;
            self.pivot(worst, column);
            self.climb();
            if self.objective[0] < -ROUND_OFF {
                return false;
            }
            if let Some(row) = self.basic.iter().position(|variable| *variable == helper) {
                // It is zero and may leave for anything.
                let entries = &self.rows[row][1..];
                let largest = (0..entries.len()).max_by(|a, b| entries[*a].abs().total_cmp(&entries[*b].abs()));
                if let Some(column) = largest.filter(|column| entries[*column].abs() > ROUND_OFF) {
                    self.pivot(row, column);
                }
            }
        }
        // It stays at zero: its column goes.
        if let Some(column) = self.nonbasic.iter().position(|variable| *variable == helper) {
            self.nonbasic.remove(column);
            self.rows.iter_mut().for_each(|row| {
                row.remove(column + 1);
            });
            self.objective.remove(column + 1);
        }
        true
    }

    fn set_objective(&mut self, objective: &[f64]) {
        self.objective = vec![0.0; self.nonbasic.len() + 1];
        for (variable, &weight) in objective.iter().enumerate() {
            if let Some(column) = self.nonbasic.iter().position(|known| *known == variable) {
                self.objective[column + 1] += weight;
            } else if let Some(row) = self.basic.iter().position(|known| *known == variable) {
                for (sum, entry) in self.objective.iter_mut().zip(&self.rows[row]) {
                    *sum += weight * entry;
                }
            }
        }
    }

    /// Pivots until no variable improves the objective.
    fn climb(&mut self) {
        let size = self.objective[1..].iter().fold(0.0_f64, |size, entry| size.max(entry.abs()));
        for _ in 0..PIVOTS * (self.rows.len() + self.nonbasic.len()) {
            // Bland: of the variables that improve, and of those that stop it, the one with the smallest number.
            let improving = (0..self.nonbasic.len()).filter(|column| self.objective[column + 1] > ROUND_OFF * size);
            let Some(column) = improving.min_by_key(|column| self.nonbasic[*column]) else { return };
            let mut stop: Option<(f64, usize)> = None;
            for (index, row) in self.rows.iter().enumerate() {
                let entry = row[column + 1];
                if entry >= -ROUND_OFF {
                    continue;
                }
                let step = (-row[0] / entry).max(0.0);
                let is_sooner = stop.is_none_or(|(shortest, at)| {
                    step < shortest || step == shortest && self.basic[index] < self.basic[at]
                });
                if is_sooner {
                    stop = Some((step, index));
                }
            }
            // The set lies in a box: something stops every variable but the helper, which only falls.
            let Some((_, row)) = stop else { return };
            self.pivot(row, column);
        }
    }

    fn pivot(&mut self, row: usize, column: usize) {
        let entry = self.rows[row][column + 1];
        let mut leaving = std::mem::take(&mut self.rows[row]);
        leaving.iter_mut().for_each(|value| *value /= -entry);
        leaving[column + 1] = 1.0 / entry;
        let replace = |target: &mut Vec<f64>| {
            let factor = target[column + 1];
            if factor != 0.0 {
                target[column + 1] = 0.0;
                for (value, known) in target.iter_mut().zip(&leaving) {
                    *value += factor * known;
                }
            }
        };
        self.rows.iter_mut().filter(|other| !other.is_empty()).for_each(replace);
        replace(&mut self.objective);
        self.rows[row] = leaving;
        std::mem::swap(&mut self.basic[row], &mut self.nonbasic[column]);
    }

    fn point(&self, variables: usize) -> Vec<f64> {
        let mut point = vec![0.0; variables];
        for (row, &variable) in self.basic.iter().enumerate() {
            if variable < variables {
                point[variable] = self.rows[row][0].clamp(0.0, 1.0);
            }
        }
        point
    }

    /// What each row of the programme holds back: minus the entry of its slack in the objective.
    fn multipliers(&self) -> Vec<f64> {
        let mut multipliers = vec![0.0; self.limits];
        for (column, &variable) in self.nonbasic.iter().enumerate() {
            if (self.variables..self.variables + self.limits).contains(&variable) {
                multipliers[variable - self.variables] = (-self.objective[column + 1]).max(0.0);
            }
        }
        multipliers
    }
}

#[cfg(test)]
mod tests {
    use super::LinearProgram;

    /// Round-off of numbers of order one.
    const TOLERANCE: f64 = 1e-12;

    #[test]
    fn analytic_corner_of_two_limits() {
        let mut program = LinearProgram::new(2);
        program.add_constraint(vec![2.0, 1.0], 1.3);
        program.add_constraint(vec![1.0, 3.0], 1.9);
        // 2x + y = 1.3 and x + 3y = 1.9 meet at (0.4, 0.5).
        let largest = program.largest(&[0.7, 0.6]).expect("the set holds zero");
        assert!((largest.value - 0.58).abs() < TOLERANCE, "{largest:?}");
        assert!((largest.point[0] - 0.4).abs() < TOLERANCE && (largest.point[1] - 0.5).abs() < TOLERANCE);
    }

    #[test]
    fn analytic_slab_away_from_zero() {
        let mut program = LinearProgram::new(3);
        program.add_constraint(vec![1.0, 1.0, 1.0], 1.1);
        program.add_constraint(vec![-1.0, -1.0, -1.0], -0.9);
        let sum = program.largest(&[1.0, 1.0, 1.0]).expect("there are points");
        let least = program.largest(&[-1.0, -1.0, -1.0]).expect("there are points");
        assert!((sum.value - 1.1).abs() < TOLERANCE && (least.value + 0.9).abs() < TOLERANCE);
        assert!((program.largest(&[0.0, 1.0, 0.0]).expect("there are points").value - 1.0).abs() < TOLERANCE);
        assert!(program.largest(&[0.0, -1.0, 0.0]).expect("there are points").value.abs() < TOLERANCE);
    }

    #[test]
    fn contradictions_are_empty() {
        let mut program = LinearProgram::new(2);
        program.add_constraint(vec![-1.0, -1.0], -0.7);
        assert!(!program.is_empty());
        program.add_constraint(vec![1.0, 0.4], 0.2);
        // x + y >= 0.7 and x + 0.4 y <= 0.2: y = 1 leaves x <= -0.2 or, at x = 0, y <= 0.5.
        assert!(program.is_empty());
        assert_eq!(program.largest(&[1.0, 0.0]), None);
        let mut beyond = LinearProgram::new(1);
        beyond.add_constraint(vec![-1e-4], -1.2e-4);
        assert!(beyond.is_empty(), "no y <= 1 reaches 1.2");
    }

    #[test]
    fn identity_no_multipliers_prove_a_set_with_points_empty_and_some_prove_an_empty_one() {
        let mut program = LinearProgram::new(2);
        program.add_constraint(vec![-1.0, -1.0], -0.7);
        program.add_constraint(vec![1.0, 0.4], 0.3);
        // (0.02, 0.68) keeps both rows, to two parts in a thousand.
        for multipliers in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.4, 1.0], [1.0, 2.5], [1e9, 2.5e9]] {
            assert!(!program.is_proof_of_emptiness(&multipliers), "{multipliers:?}");
        }
        program.add_constraint(vec![0.0, 1.0], 0.5);
        // x >= 0.2 and 0.3 - 0.2 >= x: 1.0 of the first, 1.0 of the second, 0.6 of the third say 0 <= -0.1.
        assert!(program.is_proof_of_emptiness(&[1.0, 1.0, 0.6]) && program.is_empty());
        // Multipliers of a simplex method that stopped early prove nothing.
        assert!(!program.is_proof_of_emptiness(&[1.0, 0.0, 0.0]));
    }

    #[test]
    fn identity_random_programmes_agree_with_their_corners() {
        // Two variables: every corner is the meeting of two lines, so that all of them can be tried.
        let mut state = 12345_u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let (mut empty, mut full) = (0, 0);
        for _ in 0..400 {
            let mut lines = vec![([-1.0, 0.0], 0.0), ([0.0, -1.0], 0.0), ([1.0, 0.0], 1.0), ([0.0, 1.0], 1.0)];
            let mut program = LinearProgram::new(2);
            for _ in 0..5 {
                let line = ([2.0 * random() - 1.0, 2.0 * random() - 1.0], random() - 0.35);
                program.add_constraint(line.0.to_vec(), line.1);
                lines.push(line);
            }
            let objective = [2.0 * random() - 1.0, 2.0 * random() - 1.0];
            let mut best: Option<f64> = None;
            for first in 0..lines.len() {
                for second in 0..first {
                    let ([a, b], [c, d]) = (lines[first].0, lines[second].0);
                    let determinant = a * d - b * c;
                    let x = (lines[first].1 * d - b * lines[second].1) / determinant;
                    let y = (a * lines[second].1 - lines[first].1 * c) / determinant;
                    if lines.iter().all(|([a, b], limit)| a * x + b * y <= limit + 1e-10) {
                        let value = objective[0] * x + objective[1] * y;
                        best = Some(best.map_or(value, |known| known.max(value)));
                    }
                }
            }
            let found = program.largest(&objective);
            match (best, &found) {
                (None, None) => empty += 1,
                (Some(best), Some(found)) => {
                    full += 1;
                    assert!((best - found.value).abs() < 1e-8, "{best} {found:?}");
                }
                _ => panic!("{best:?} {found:?}"),
            }
        }
        assert!(empty > 30 && full > 100, "{empty} {full}");
    }
}

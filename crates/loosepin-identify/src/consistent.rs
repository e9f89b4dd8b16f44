//! The plays that are consistent with readings: a polytope in the box of the study.
//!
//! A reading m of an instrument with the common error C s, -1 <= s <= 1, and an independent error of at most e says
//!
//! ```text
//! m - e <= T + C s <= m + e,    Σ low_k c_k <= T <= Σ high_k c_k,    c_k >= 0
//! ```
//!
//! Since no clearance c_k is negative, this holds for some T exactly if Σ low_k c_k + C s <= m + e and Σ high_k c_k + C s >= m - e:
//! two rows that are linear in the plays and in s.

use super::influence::Influence;
use super::linear_program::{Largest, LinearProgram};
use super::rig::Rig;

/// A reading as two rows.
#[derive(Debug, Clone)]
pub(crate) struct ReadingRow {
    /// Factors of the play inputs: least, nominal, largest.
    pub factors: Vec<[f64; 3]>,
    /// Terms that do not depend on the plays, SI: least and largest.
    pub constant_si: [f64; 2],
    /// Mean of the reading, with the independent error taken and added, SI.
    pub interval_si: [f64; 2],
    /// The common error, SI, and its instrument.
    pub common_si: f64,
    pub instrument: usize,
}

/// Plays with the readings that they have to explain.
#[derive(Debug, Clone)]
pub(crate) struct ConsistentSet {
    pub intervals_si: Vec<[f64; 2]>,
    pub instruments: usize,
    pub rows: Vec<ReadingRow>,
}

/// An end of a bound: its value, and plays at which it is attained.
#[derive(Debug, Clone)]
pub(crate) struct End {
    pub value_si: f64,
    pub plays_si: Vec<f64>,
}

impl ReadingRow {
    /// The rows of a reading with this influence.
    pub fn new(rig: &Rig<'_>, influence: &Influence, interval_si: [f64; 2], common_si: f64, instrument: usize) -> Self {
        let mut factors = vec![[0.0; 3]; rig.plays.len()];
        let mut constant_si = [0.0; 2];
        for (joint, clearance) in rig.clearances.iter().enumerate() {
            let [least, largest] = influence.limits(joint);
            let nominal = influence.factors[joint][1];
            for (factors, slope) in factors.iter_mut().zip(&clearance.slopes) {
                for (factor, own) in factors.iter_mut().zip([least, nominal, largest]) {
                    *factor += own * slope;
                }
            }
            let ends_m = [clearance.offset_m - clearance.spread_m, clearance.offset_m + clearance.spread_m];
            let [yield_least_si, yield_most_si] = influence.yield_si(joint);
            constant_si[0] += f64::min(least * ends_m[0], least * ends_m[1]) + yield_least_si;
            constant_si[1] += f64::max(largest * ends_m[0], largest * ends_m[1]) + yield_most_si;
        }
        Self { factors, constant_si, interval_si, common_si, instrument }
    }
}

impl ConsistentSet {
    /// The rows of all readings but those that `leaves_out`.
    fn program(&self, leaves_out: impl Fn(usize) -> bool) -> LinearProgram {
        let mut program = LinearProgram::new(self.variables());
        for (_, row) in self.rows.iter().enumerate().filter(|(index, _)| !leaves_out(*index)) {
            for (coefficients, limit) in self.two_rows(row, 1.0) {
                program.add_constraint(coefficients, limit);
            }
        }
        program
    }

    fn variables(&self) -> usize {
        self.intervals_si.len() + self.instruments
    }

    /// The two rows of a reading over the unit box, its errors multiplied by `errors`.
    fn two_rows(&self, row: &ReadingRow, errors: f64) -> [(Vec<f64>, f64); 2] {
        let [lower, upper] = row.interval_si;
        let (middle, half) = (0.5 * (lower + upper), 0.5 * (upper - lower) * errors);
        let common_si = row.common_si * errors;
        [(1.0, 0, middle + half), (-1.0, 2, -(middle - half))].map(|(sign, which, limit)| {
            let mut coefficients = vec![0.0; self.variables()];
            let mut limit = limit - sign * row.constant_si[which / 2];
            for ((coefficient, factors), [low, high]) in
                coefficients.iter_mut().zip(&row.factors).zip(&self.intervals_si)
            {
                *coefficient = sign * factors[which] * (high - low);
                limit -= sign * factors[which] * low;
            }
            coefficients[self.intervals_si.len() + row.instrument] = sign * 2.0 * common_si;
            limit += sign * common_si;
            (coefficients, limit)
        })
    }

    /// Whether no plays explain all readings.
    pub fn is_empty(&self) -> bool {
        self.program(|_| false).is_empty()
    }

    /// Whether no plays explain the readings that `counts` names.
    pub fn is_empty_of(&self, counts: impl Fn(usize) -> bool) -> bool {
        self.program(|reading| !counts(reading)).is_empty()
    }

    /// Whether the readings bound a play by itself, wherever the factors are between least and largest: there is no direction, with this
    /// play up or down and the others up (no play is negative), in which all readings can stay as they are.
    pub fn fixes(&self, play: usize) -> bool {
        /// Share of the width of the play for that of another: round-off.
        const STANDS: f64 = 1e-7;
        [1.0, -1.0].into_iter().all(|sign| {
            let mut program = LinearProgram::new(self.intervals_si.len());
            for row in &self.rows {
                // Least travel <= 0 and largest travel >= 0; a play that goes down has its largest factor in the least travel.
                for (side, which) in [(1.0, 0), (-1.0, 2)] {
                    let of = |(k, ([least, _, largest], [low, high])): (usize, (&[f64; 3], &[f64; 2]))| {
                        let is_down = k == play && sign < 0.0;
                        let factor = if (which == 0) == is_down { *largest } else { *least };
                        let direction = if is_down { -1.0 } else { 1.0 };
                        side * direction * factor * (high - low)
                    };
                    program
                        .add_constraint(row.factors.iter().zip(&self.intervals_si).enumerate().map(of).collect(), 0.0);
                }
            }
            let mut objective = vec![0.0; self.intervals_si.len()];
            objective[play] = 1.0;
            program.largest(&objective).is_some_and(|largest| largest.value <= STANDS)
        })
    }

    /// Whether no plays explain all readings where errors are `errors` times as large.
    pub fn is_empty_with(&self, errors: f64) -> bool {
        let mut program = LinearProgram::new(self.variables());
        for row in &self.rows {
            for (coefficients, limit) in self.two_rows(row, errors) {
                program.add_constraint(coefficients, limit);
            }
        }
        program.is_empty()
    }

    /// Lower and upper end of Σ weight · play; `None` if no plays are consistent.
    pub fn bounds(&self, weights: &[f64]) -> Option<[End; 2]> {
        let program = self.program(|_| false);
        Some([self.end(&program, weights, -1.0)?, self.end(&program, weights, 1.0)?])
    }

    fn end(&self, program: &LinearProgram, weights: &[f64], sign: f64) -> Option<End> {
        let mut objective = vec![0.0; self.variables()];
        let mut constant = 0.0;
        for ((entry, weight), [low, high]) in objective.iter_mut().zip(weights).zip(&self.intervals_si) {
            *entry = sign * weight * (high - low);
            constant += weight * low;
        }
        let Largest { value, point } = program.largest(&objective)?;
        Some(End { value_si: constant + sign * value, plays_si: self.plays_at(&point) })
    }

    fn plays_at(&self, point: &[f64]) -> Vec<f64> {
        self.intervals_si.iter().zip(point).map(|([low, high], share)| low + share * (high - low)).collect()
    }

    /// Possible values of a further reading of `row`, SI: from the least to the largest travel, its common error included. The readings
    /// that `leaves_out` names do not count.
    pub fn expected_si(&self, row: &ReadingRow, leaves_out: impl Fn(usize) -> bool) -> Option<[f64; 2]> {
        let program = self.program(leaves_out);
        let mut ends = [0.0; 2];
        for (end, (sign, which)) in ends.iter_mut().zip([(-1.0, 0), (1.0, 2)]) {
            let mut objective = vec![0.0; self.variables()];
            let mut constant = row.constant_si[which / 2];
            for ((entry, factors), [low, high]) in objective.iter_mut().zip(&row.factors).zip(&self.intervals_si) {
                *entry = sign * factors[which] * (high - low);
                constant += factors[which] * low;
            }
            objective[self.intervals_si.len() + row.instrument] = sign * 2.0 * row.common_si;
            constant -= row.common_si;
            *end = constant + sign * program.largest(&objective)?.value;
        }
        Some(ends)
    }

    /// Values of an error-free reading that the intervals of the study alone allow, SI.
    pub fn allowed_si(&self, row: &ReadingRow) -> [f64; 2] {
        let mut ends = row.constant_si;
        for (factors, interval) in row.factors.iter().zip(&self.intervals_si) {
            ends[0] += f64::min(factors[0] * interval[0], factors[0] * interval[1]);
            ends[1] += f64::max(factors[2] * interval[0], factors[2] * interval[1]);
        }
        ends
    }
}

#[cfg(test)]
mod tests {
    use super::{ConsistentSet, ReadingRow};

    fn set(rows: &[[f64; 2]], loose: f64) -> ConsistentSet {
        let row = |factors: &[f64; 2]| ReadingRow {
            factors: factors.iter().map(|factor| [factor - loose, *factor, factor + loose]).collect(),
            constant_si: [0.0; 2],
            interval_si: [1e-4, 1.1e-4],
            common_si: 0.0,
            instrument: 0,
        };
        ConsistentSet { intervals_si: vec![[1e-5, 3e-4]; 2], instruments: 1, rows: rows.iter().map(row).collect() }
    }

    #[test]
    fn analytic_a_play_is_fixed_by_itself_only_beyond_what_the_factors_leave_open() {
        let fixed = |rows: &[[f64; 2]], loose: f64| [0, 1].map(|play| set(rows, loose).fixes(play));
        assert_eq!(fixed(&[[1.0, 1.0]], 0.0), [false, false]);
        assert_eq!(fixed(&[[1.0, 0.0]], 0.0), [true, false]);
        // The determinant of (1, 1), (1, 1.001) is 0.001: factors that are known to a percent leave it open, exact ones do not.
        let near = [[1.0, 1.0], [1.0, 1.001]];
        assert_eq!(fixed(&near, 0.0), [true, true]);
        assert_eq!(fixed(&near, 0.01), [false, false]);
        assert_eq!(fixed(&[[1.0, 1.0], [1.0, 2.0]], 0.01), [true, true]);
        // A factor of the other play that may be nought leaves this one alone only where it is known to be nought.
        assert_eq!(fixed(&[[0.0, 1.0]], 0.01), [false, false]);
    }
}

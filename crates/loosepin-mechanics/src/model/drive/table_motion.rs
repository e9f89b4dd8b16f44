//! Motions given by points: cubic splines, piece by piece.

use loosepin_math::{Dual, Real, clamped_spline, cubic_piece, numbers, periodic_spline};

/// Numbers with a time, for finding the piece of a table.
pub trait AtTime: Real {
    /// The plain value.
    fn plain(self) -> f64;
}

impl AtTime for f64 {
    fn plain(self) -> f64 {
        self
    }
}

impl AtTime for Dual<f64> {
    fn plain(self) -> f64 {
        self.value
    }
}

/// A piece of a table: Σ c_k (t - t0)^k, m or rad.
#[derive(Debug, Clone, Copy)]
pub struct TablePiece<T> {
    /// t0, s.
    pub origin_s: T,
    /// c_0 to c_3.
    pub coefficients: [T; 4],
}

numbers!(struct TablePiece { origin_s, coefficients });

/// Value, rate and acceleration of Σ c_k (t - t0)^k at `time_s`, by Horner's scheme for the value and both derivatives.
#[inline(always)]
pub(super) fn polynomial_at<T: Real>(origin_s: T, coefficients: &[T], time_s: T) -> [T; 3] {
    let u = time_s - origin_s;
    let [mut value, mut rate, mut half] = [T::zero(); 3];
    for coefficient in coefficients.iter().rev() {
        half = half.mul_add(u, rate);
        rate = rate.mul_add(u, value);
        value = value.mul_add(u, *coefficient);
    }
    [value, rate, half + half]
}

/// A spline through points of time and coordinate, at rest outside of them or repeated for ever.
///
/// Pieces are numbered in the order of time, 0 from the first point to the second. A clamped table rests in all others than
/// its own; a periodic one has pieces for ever in both directions.
#[derive(Debug, Clone)]
pub struct TableMotion<T> {
    points: Vec<[T; 2]>,
    /// Second derivatives at the points.
    moments: Vec<T>,
    is_periodic: bool,
}

impl<T: AtTime> TableMotion<T> {
    /// Through `points`, at least three, with increasing times.
    pub fn new(points: Vec<[T; 2]>, is_periodic: bool) -> Self {
        let moments = if is_periodic { periodic_spline(&points) } else { clamped_spline(&points) };
        Self { points, moments, is_periodic }
    }

    /// The points that it passes through.
    pub fn points(&self) -> &[[T; 2]] {
        &self.points
    }

    /// Pieces between the points.
    fn count(&self) -> i64 {
        self.points.len() as i64 - 1
    }

    /// Which period a piece belongs to, and which one it is there.
    fn place(&self, index: i64) -> (i64, usize) {
        (index.div_euclid(self.count()), index.rem_euclid(self.count()) as usize)
    }

    /// When piece `index` starts, s: infinite for what never comes.
    pub fn start_s(&self, index: i64) -> f64 {
        let times_s = |k: usize| self.points[k][0].plain();
        if !self.is_periodic {
            return match index {
                ..0 => f64::NEG_INFINITY,
                _ if index <= self.count() => times_s(index as usize),
                _ => f64::INFINITY,
            };
        }
        let (period, k) = self.place(index);
        period as f64 * (times_s(self.points.len() - 1) - times_s(0)) + times_s(k)
    }

    /// The piece that holds `time_s`: it starts there or before, and the next one after.
    pub fn index(&self, time_s: f64) -> i64 {
        let last = self.points.len() - 1;
        let first_s = self.points[0][0].plain();
        let span_s = self.points[last][0].plain() - first_s;
        let periods = if self.is_periodic { ((time_s - first_s) / span_s).floor() as i64 } else { 0 };
        // Round-off may place it a piece or two aside.
        let mut index = (periods - 1) * self.count();
        let most = (periods + 2) * self.count();
        while index < most && self.start_s(index + 1) <= time_s {
            index += 1;
        }
        index
    }

    /// The motion within piece `index`.
    pub fn piece(&self, index: i64) -> TablePiece<T> {
        let last = self.points.len() - 1;
        let rest =
            |value: T| TablePiece { origin_s: T::zero(), coefficients: [value, T::zero(), T::zero(), T::zero()] };
        if !self.is_periodic && index < 0 {
            return rest(self.points[0][1]);
        }
        if !self.is_periodic && index >= self.count() {
            return rest(self.points[last][1]);
        }
        let (period, k) = self.place(index);
        let mut coefficients = cubic_piece(self.points[k], self.points[k + 1], [self.moments[k], self.moments[k + 1]]);
        let periods = T::from_f64(period as f64);
        coefficients[0] += periods * (self.points[last][1] - self.points[0][1]);
        let origin_s = periods * (self.points[last][0] - self.points[0][0]) + self.points[k][0];
        TablePiece { origin_s, coefficients }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINTS: [[f64; 2]; 4] = [[0.2, 1.0], [0.5, 1.8], [0.9, 2.7], [1.1, 4.0]];

    #[test]
    fn identity_a_break_belongs_to_the_piece_that_starts_there() {
        let table = TableMotion::new(POINTS.to_vec(), true);
        for index in -7..40 {
            let start_s = table.start_s(index);
            assert_eq!(table.index(start_s), index);
            assert_eq!(table.index(start_s - 1e-12), index - 1);
        }
    }

    #[test]
    fn identity_a_periodic_table_goes_on_from_where_it_ended() {
        let table = TableMotion::new(POINTS.to_vec(), true);
        let TablePiece { origin_s, coefficients } = table.piece(3);
        // One period of 0.9 s later and 3 higher than the first piece.
        assert!((origin_s - 1.1).abs() < 1e-15 && (coefficients[0] - 4.0).abs() < 1e-15);
    }

    #[test]
    fn analytic_a_clamped_table_rests_outside() {
        let table = TableMotion::new(POINTS.to_vec(), false);
        for (time_s, value) in [(-3.0, 1.0), (0.0, 1.0), (1.1, 4.0), (7.0, 4.0)] {
            assert_eq!(table.piece(table.index(time_s)).coefficients, [value, 0.0, 0.0, 0.0]);
        }
        assert_eq!(table.start_s(4), f64::INFINITY);
    }
}

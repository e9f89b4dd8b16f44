//! The profile of a cam: a periodic cubic spline.

use super::pieces::Pieces;
use loosepin_math::{Real, cubic_piece, numbers, periodic_spline};

/// The coordinate of a follower over that of its cam: a spline through points, repeated for ever, each time from where the last one
/// ended. Its second derivative does not jump.
#[derive(Debug, Clone)]
pub struct CamProfile<T> {
    /// Where the first point is.
    start: T,
    /// From the first point to the last.
    period: T,
    /// Value of the last point minus that of the first.
    rise: T,
    /// Origin and coefficients c_0 to c_3 of each piece.
    pieces: Pieces<T, 5>,
}

numbers!(struct CamProfile { start, period, rise, pieces });

impl<T: Real> CamProfile<T> {
    /// Through `points`, at least three, with increasing arguments.
    pub fn new(points: &[[T; 2]]) -> Self {
        let (moments, last) = (periodic_spline(points), points.len() - 1);
        let piece = |k: usize| {
            let [c0, c1, c2, c3] = cubic_piece(points[k], points[k + 1], [moments[k], moments[k + 1]]);
            [points[k][0], c0, c1, c2, c3]
        };
        Self {
            start: points[0][0],
            period: points[last][0] - points[0][0],
            rise: points[last][1] - points[0][1],
            pieces: Pieces::new(points[1..last].iter().map(|point| point[0]).collect(), (0..last).map(piece).collect()),
        }
    }

    /// Value and first two derivatives at `coordinate`.
    #[inline(always)]
    pub fn at(&self, coordinate: T) -> [T; 3] {
        let (half, two, three) = (T::from_f64(0.5), T::from_f64(2.0), T::from_f64(3.0));
        let periods = ((coordinate - self.start) / self.period - half).nearest_whole();
        let within = coordinate - periods * self.period;
        let [origin, c0, c1, c2, c3] = self.pieces.at(within);
        let u = within - origin;
        let value = c3.mul_add(u, c2).mul_add(u, c1).mul_add(u, c0);
        let slope = (three * c3).mul_add(u, two * c2).mul_add(u, c1);
        [periods.mul_add(self.rise, value), slope, two * (three * c3).mul_add(u, c2)]
    }
}

impl CamProfile<f64> {
    /// The steepest slope at a point, and points in a unit of the coordinate.
    pub fn steepness(&self) -> [f64; 2] {
        let steepest = self.pieces.all().iter().fold(0.0_f64, |steepest, [_, _, c1, ..]| steepest.max(c1.abs()));
        [steepest, self.pieces.all().len() as f64 / self.period.abs()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use loosepin_math::{Dual, Numbers};

    const POINTS: [[f64; 2]; 5] = [[0.3, 1.1], [1.5, 1.7], [2.9, 0.4], [4.9, 0.6], [6.3, 2.9]];

    /// Round-off of a few operations on numbers up to ten.
    const ROUND_OFF: f64 = 1e-13;

    #[test]
    fn identity_goes_through_its_points_again_and_again() {
        let profile = CamProfile::new(&POINTS);
        for periods in [-3.0, 0.0, 7.0] {
            for [x, y] in POINTS {
                let found = profile.at(x + periods * 6.0)[0];
                assert!((found - y - periods * 1.8).abs() < 10.0 * ROUND_OFF, "{x} {periods}: {found}");
            }
        }
    }

    #[test]
    fn identity_slopes_are_the_derivatives_and_do_not_jump() {
        let profile = CamProfile::new(&POINTS);
        let dual = CamProfile::broadcast(&profile);
        for k in -40..40 {
            let x = 0.17 * f64::from(k);
            let [value, slope, bend] = profile.at(x);
            let [of_value, of_slope, _] = dual.at(Dual::variable(x));
            assert_eq!(of_value.value, value);
            assert!((of_value.derivative - slope).abs() < ROUND_OFF && (of_slope.derivative - bend).abs() < ROUND_OFF);
        }
        for [x, _] in POINTS {
            let (before, after) = (profile.at(x - 1e-13), profile.at(x + 1e-13));
            // A third derivative of ten times the distance, and round-off.
            assert!((0..3).all(|k| (before[k] - after[k]).abs() < 1e-11), "{x}: {before:?} {after:?}");
        }
    }
}

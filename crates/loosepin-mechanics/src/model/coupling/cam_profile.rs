//! The profile of a cam: a periodic cubic spline with dwells.

use super::kind::Curve;
use loosepin_math::{Pieces, Real, cubic_piece, joined_all, numbers, periodic_spline, resting_spline};

/// The coordinate of a follower over that of its cam: a spline through points, repeated for ever, each time from where the last one
/// ended. Its second derivative does not jump. In a dwell the follower rests: the spline reaches it and leaves it with slope and second
/// derivative zero, so that it goes nowhere beyond.
#[derive(Debug, Clone)]
pub struct CamProfile<T> {
    /// Abscissa of the first point.
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
    /// Through `points`, at least three, with increasing arguments; `dwells` says of each interval between them whether the follower rests
    /// there.
    pub fn new(points: &[[T; 2]], dwells: &[bool]) -> Self {
        let last = points.len() - 1;
        let period = points[last][0] - points[0][0];
        let rise = points[last][1] - points[0][1];
        let (nodes, moments) = match dwells.iter().position(|is_dwell| *is_dwell) {
            None => (points.to_vec(), periodic_spline(points)),
            // Begun where a dwell ends, so that no stretch between dwells is cut.
            Some(dwell) => {
                let point = |k: usize| {
                    let [x, y] = points[k % last];
                    if k < last { [x, y] } else { [x + period, y + rise] }
                };
                stretches(dwells, dwell + 1, point)
            }
        };
        let piece = |k: usize| {
            let [c0, c1, c2, c3] = cubic_piece(nodes[k], nodes[k + 1], [moments[k], moments[k + 1]]);
            [nodes[k][0], c0, c1, c2, c3]
        };
        let count = nodes.len() - 1;
        let breaks = nodes[1..count].iter().map(|node| node[0]).collect();
        Self { start: nodes[0][0], period, rise, pieces: Pieces::new(breaks, (0..count).map(piece).collect()) }
    }
}

impl<T: Real> CamProfile<T> {
    /// Value, slope and second derivative, so many periods behind the first one.
    #[inline(always)]
    fn in_period(&self, coordinate: T, periods: T) -> [T; 3] {
        let (two, three) = (T::from_f64(2.0), T::from_f64(3.0));
        let within = coordinate - periods * self.period;
        let [value, slope, bend] = self.pieces.over(
            within,
            #[inline(always)]
            |within, [origin, c0, c1, c2, c3]| {
                let u = within - origin;
                let value = c3.mul_add(u, c2).mul_add(u, c1).mul_add(u, c0);
                let slope = (three * c3).mul_add(u, two * c2).mul_add(u, c1);
                [value, slope, two * (three * c3).mul_add(u, c2)]
            },
        );
        [periods.mul_add(self.rise, value), slope, bend]
    }

    /// Over a set of coordinates: over the part of it in each period, joined; `None` if it touches too many.
    fn over_periods(&self, coordinate: T) -> Option<[T; 3]> {
        const MOST: f64 = 8.0;
        let [first, last] = ((coordinate - self.start) / self.period).ends().map(f64::floor);
        if !(last - first < MOST) {
            return None;
        }
        let parts = (0..=(last - first) as usize).filter_map(|k| {
            let periods = T::from_f64(first + k as f64);
            let low = (self.start + periods * self.period).ends()[0];
            let high = (self.start + (periods + T::one()) * self.period).ends()[1];
            Some(self.in_period(coordinate.part(low, high)?, periods))
        });
        parts.reduce(joined_all)
    }
}

impl<T: Real> Curve<T> for CamProfile<T> {
    #[inline(always)]
    fn at(&self, coordinate: T) -> [T; 3] {
        let half = T::from_f64(0.5);
        let periods = ((coordinate - self.start) / self.period - half).nearest_whole();
        if T::IS_SET {
            return self.over_periods(coordinate).unwrap_or_else(|| self.in_period(coordinate, periods));
        }
        self.in_period(coordinate, periods)
    }

    /// A follower stays on its cam.
    fn offset(&self) -> Option<T> {
        None
    }

    fn offset_mut(&mut self) -> Option<&mut T> {
        None
    }

    fn gain(&self, scale: T) -> T {
        /// Points to a wave of the profile.
        const POINTS_OF_WAVE: f64 = 8.0;
        let pieces = self.pieces.all();
        let steepest = pieces.iter().fold(T::zero(), |steepest, [_, _, c1, ..]| steepest.max(c1.abs()));
        let density = T::from_f64(pieces.len() as f64) / self.period.abs();
        (steepest * scale).max(density * T::from_f64(std::f64::consts::TAU / POINTS_OF_WAVE))
    }
}

/// Nodes and second derivatives over one period from the point `first` on, which ends a dwell. Each dwell, and each stretch between two of
/// them, is a spline that begins and ends at rest. `point` is periodic.
fn stretches<T: Real>(dwells: &[bool], first: usize, point: impl Fn(usize) -> [T; 2]) -> (Vec<[T; 2]>, Vec<T>) {
    let count = dwells.len();
    let (mut nodes, mut moments) = (vec![point(first)], vec![T::zero()]);
    let mut begin = first;
    for end in first + 1..=first + count {
        // Points end a stretch where a dwell begins or ends.
        if dwells[(end - 1) % count] || dwells[end % count] {
            let stretch: Vec<[T; 2]> = (begin..=end).map(&point).collect();
            let (its_nodes, its_moments) = resting_spline(&stretch);
            nodes.extend(&its_nodes[1..]);
            moments.extend(&its_moments[1..]);
            begin = end;
        }
    }
    (nodes, moments)
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
        let profile = CamProfile::new(&POINTS, &[false; 4]);
        for periods in [-3.0, 0.0, 7.0] {
            for [x, y] in POINTS {
                let found = profile.at(x + periods * 6.0)[0];
                assert!((found - y - periods * 1.8).abs() < 10.0 * ROUND_OFF, "{x} {periods}: {found}");
            }
        }
    }

    #[test]
    fn identity_slopes_are_the_derivatives_and_do_not_jump() {
        let profile = CamProfile::new(&POINTS, &[false; 4]);
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

    /// Dwells at 5 from 1 to 2 and at 0.5 from 5.5 over the end of the period to 6.4, and a stretch with points and one without.
    const WITH_DWELLS: [[f64; 2]; 7] =
        [[0.0, 0.5], [0.4, 0.5], [1.0, 5.0], [2.0, 5.0], [3.1, 3.0], [4.2, 1.5], [5.5, 0.5]];

    fn with_dwells() -> CamProfile<f64> {
        let mut points = WITH_DWELLS.to_vec();
        points.push([6.0, 0.5]);
        CamProfile::new(&points, &[true, false, true, false, false, false, true])
    }

    #[test]
    fn identity_a_dwell_is_flat_and_nothing_goes_beyond_it() {
        let profile = with_dwells();
        for k in 0..=12_000 {
            let x = -6.0 + 0.001 * f64::from(k);
            let [value, slope, bend] = profile.at(x);
            let place = x.rem_euclid(6.0);
            assert!((0.5 - ROUND_OFF..=5.0 + ROUND_OFF).contains(&value), "{x}: {value}");
            if (1.0..=2.0).contains(&place) || !(0.4..=5.5).contains(&place) {
                let level = if (0.5..=5.0).contains(&place) { 5.0 } else { 0.5 };
                assert!((value - level).abs() < ROUND_OFF, "{x}: {value}");
                // Second derivatives of up to a hundred beside it.
                assert!(slope.abs() < 1e-11 && bend.abs() < 1e-11, "{x}: {slope} {bend}");
            }
        }
    }

    #[test]
    fn identity_a_profile_with_dwells_goes_through_its_points_and_its_slopes_do_not_jump() {
        let profile = with_dwells();
        for [x, y] in WITH_DWELLS {
            for periods in [-2.0, 0.0, 1.0] {
                let found = profile.at(x + 6.0 * periods)[0];
                assert!((found - y).abs() < 10.0 * ROUND_OFF, "{x} {periods}: {found}");
            }
            let (before, after) = (profile.at(x - 1e-13), profile.at(x + 1e-13));
            // A third derivative of a thousand times the distance, and round-off.
            assert!((0..3).all(|k| (before[k] - after[k]).abs() < 1e-9), "{x}: {before:?} {after:?}");
        }
    }
}

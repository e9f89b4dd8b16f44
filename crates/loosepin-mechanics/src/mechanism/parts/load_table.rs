//! The numbers of loads given by points.

use crate::model::{LoadTable, PeriodProblem, TableCurve, Values};
use loosepin_math::{
    Pieces, Real, cubic_piece, cubic_with_slopes, monotone_slopes, natural_spline, numbers, periodic_spline,
};

/// A curve over the time or over the motion of a joint, N or N m: cubic pieces between points. Its slope does not jump, except
/// at the ends of one that does not go round: beyond them it is constant.
#[derive(Debug, Clone)]
pub struct TableNumbers<T> {
    /// Abscissa of the first point.
    start: T,
    /// After which it begins again; no number of a table that does not.
    period: T,
    /// Origin and coefficients c_0 to c_3 of each piece.
    pieces: Pieces<T, 5>,
    is_periodic: bool,
}

numbers!(struct TableNumbers { start, period, pieces; is_periodic });

impl TableNumbers<f64> {
    /// Lays out `values` for `table`.
    ///
    /// # Errors
    /// The points and the period do not fit.
    pub fn new(table: &LoadTable, values: &Values) -> Result<Self, PeriodProblem> {
        let mut points = table.course(values)?;
        if let Some(piston) = table.piston {
            for [_, value] in &mut points {
                *value = (*value - values[piston.back_pressure_pa]) * values[piston.area_m2];
            }
        }
        Ok(Self::through(&points, table.curve, table.period.is_some()))
    }

    /// Through `points`, from the first to where it comes again where it is periodic.
    fn through(points: &[[f64; 2]], curve: TableCurve, is_periodic: bool) -> Self {
        let last = points.len() - 1;
        let pieces = cubics(points, curve, is_periodic).into_iter().zip(points);
        let mut pieces: Vec<[f64; 5]> = pieces.map(|([c0, c1, c2, c3], [x, _])| [*x, c0, c1, c2, c3]).collect();
        let mut breaks: Vec<f64> = points.iter().map(|[x, _]| *x).collect();
        if is_periodic {
            breaks = breaks[1..last].to_vec();
        } else {
            let rest = |[x, value]: [f64; 2]| [x, value, 0.0, 0.0, 0.0];
            pieces.insert(0, rest(points[0]));
            pieces.push(rest(points[last]));
        }
        let period = points[last][0] - points[0][0];
        Self { start: points[0][0], period, pieces: Pieces::new(breaks, pieces), is_periodic }
    }

    /// The first time after `time_s` at which two pieces meet, where the argument is `start + rate · time`; infinite where there is
    /// none.
    pub fn next_break_s(&self, [start, rate]: [f64; 2], time_s: f64) -> f64 {
        let argument = start + rate * time_s;
        let periods = if self.is_periodic { ((argument - self.start) / self.period).floor() } else { 0.0 };
        let within = argument - if self.is_periodic { periods * self.period } else { 0.0 };
        let passed = self.pieces.breaks().partition_point(|x| *x <= within) as i64;
        let near = periods as i64 * self.pieces.all().len() as i64 + passed;
        // Round-off may place it aside.
        let meetings = (near - 2..=near + 2).filter_map(|index| self.meeting(index));
        meetings.map(|x| (x - start) / rate).filter(|meeting_s| *meeting_s > time_s).fold(f64::INFINITY, f64::min)
    }

    /// Boundary of two pieces, numbered upwards; of a periodic table from the first of all pieces at number 0 on, in both directions.
    fn meeting(&self, index: i64) -> Option<f64> {
        let breaks = self.pieces.breaks();
        if !self.is_periodic {
            return usize::try_from(index).ok().and_then(|index| breaks.get(index)).copied();
        }
        let count = self.pieces.all().len() as i64;
        let within = match index.rem_euclid(count) as usize {
            0 => self.start,
            k => breaks[k - 1],
        };
        Some(within + index.div_euclid(count) as f64 * self.period)
    }
}

impl<T: Real> TableNumbers<T> {
    /// The value at `argument`.
    #[inline(always)]
    pub fn value(&self, argument: T) -> T {
        let mut within = argument;
        if self.is_periodic {
            let periods = ((argument - self.start) / self.period - T::from_f64(0.5)).nearest_whole();
            within = argument - periods * self.period;
        }
        let [origin, c0, c1, c2, c3] = self.pieces.at(within);
        let u = within - origin;
        c3.mul_add(u, c2).mul_add(u, c1).mul_add(u, c0)
    }
}

/// Coefficients of the cubic from each point to the next.
fn cubics(points: &[[f64; 2]], curve: TableCurve, is_periodic: bool) -> Vec<[f64; 4]> {
    let pairs = 0..points.len() - 1;
    match curve {
        TableCurve::Spline => {
            let moments = if is_periodic { periodic_spline(points) } else { natural_spline(points) };
            pairs.map(|k| cubic_piece(points[k], points[k + 1], [moments[k], moments[k + 1]])).collect()
        }
        TableCurve::Monotone => {
            let slopes = if is_periodic { periodic_slopes(points) } else { monotone_slopes(points) };
            pairs.map(|k| cubic_with_slopes(points[k], points[k + 1], [slopes[k], slopes[k + 1]])).collect()
        }
    }
}

/// Slopes of a monotone curve that goes round: those of the middle one of three periods.
fn periodic_slopes(points: &[[f64; 2]]) -> Vec<f64> {
    let count = points.len() - 1;
    let period = points[count][0] - points[0][0];
    let mut three: Vec<[f64; 2]> = Vec::with_capacity(3 * count + 1);
    for shift in [-period, 0.0, period] {
        three.extend(points[..count].iter().map(|[x, y]| [x + shift, *y]));
    }
    three.push([points[count][0] + period, points[count][1]]);
    monotone_slopes(&three)[count..=2 * count].to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINTS: [[f64; 2]; 5] = [[0.3, 1.1], [1.5, 1.7], [2.9, 0.4], [4.9, 0.6], [6.3, 1.1]];
    /// Round-off of a few operations on numbers up to ten.
    const ROUND_OFF: f64 = 1e-13;

    fn numbers(curve: TableCurve, is_periodic: bool) -> TableNumbers<f64> {
        TableNumbers::through(&POINTS, curve, is_periodic)
    }

    #[test]
    fn identity_goes_through_its_points_and_its_slope_does_not_jump() {
        for curve in [TableCurve::Monotone, TableCurve::Spline] {
            let [round, once] = [true, false].map(|is_periodic| numbers(curve, is_periodic));
            for [x, y] in POINTS {
                for periods in [-3.0, 0.0, 7.0] {
                    let found = round.value(x + periods * 6.0);
                    assert!((found - y).abs() < 10.0 * ROUND_OFF, "{x} {periods}: {found}");
                }
                assert!((once.value(x) - y).abs() < ROUND_OFF);
                let slope = |from: f64| (round.value(from + 1e-6) - round.value(from)) / 1e-6;
                // A second derivative of ten times the distance, and round-off over it.
                assert!((slope(x) - slope(x - 1e-6)).abs() < 1e-4, "{x}: {} {}", slope(x), slope(x - 1e-6));
            }
            assert_eq!([once.value(-7.0), once.value(9.0)], [1.1, 1.1]);
            for x in (0..60).map(|k| 0.3 + 0.1 * f64::from(k)) {
                assert!((round.value(x) - round.value(x + 12.0)).abs() < 10.0 * ROUND_OFF);
            }
        }
    }

    #[test]
    fn identity_breaks_come_one_after_the_other() {
        // Argument 0.3 + 2 t: points at t = 0, 0.6, 1.3, 2.3, 3, 3.6, ...; backwards at the mirrored ones.
        for (rate, due) in [(2.0, [0.6, 1.3, 2.3, 3.0, 3.6]), (-2.0, [0.7, 1.7, 2.4, 3.0, 3.7])] {
            let round = numbers(TableCurve::Monotone, true);
            let mut time_s = 0.0;
            for due_s in due {
                time_s = round.next_break_s([0.3, rate], time_s);
                assert!((time_s - due_s).abs() < ROUND_OFF, "{rate}: {time_s} {due_s}");
            }
        }
        let once = numbers(TableCurve::Spline, false);
        let breaks =
            std::iter::successors(Some(-1.0), |t| Some(once.next_break_s([0.0, 1.0], *t)).filter(|t| t.is_finite()));
        assert_eq!(breaks.skip(1).collect::<Vec<f64>>(), POINTS.map(|[x, _]| x));
    }
}

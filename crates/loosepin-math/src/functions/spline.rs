//! Cubic splines: smooth curves through points.

use crate::Real;

/// The second derivatives at the nodes of the cubic spline through `points` (argument and value, arguments increasing, at
/// least three) whose slope is zero at both ends.
///
/// Between nodes i and i + 1, h apart, the spline's second derivative goes evenly from M_i to M_(i+1); that its slope does not
/// jump gives h_(i-1) M_(i-1) + 2 (h_(i-1) + h_i) M_i + h_i M_(i+1) = 6 (s_i - s_(i-1)), s the slopes of the chords.
pub fn clamped_spline<T: Real>(points: &[[T; 2]]) -> Vec<T> {
    let last = points.len() - 1;
    let (two, six) = (T::from_f64(2.0), T::from_f64(6.0));
    let (h, s) = chords(points);
    let mut lower = vec![T::zero(); last + 1];
    let mut diagonal = vec![T::zero(); last + 1];
    let mut upper = vec![T::zero(); last + 1];
    let mut right = vec![T::zero(); last + 1];
    (diagonal[0], upper[0], right[0]) = (two * h[0], h[0], six * s[0]);
    (diagonal[last], lower[last], right[last]) = (two * h[last - 1], h[last - 1], -(six * s[last - 1]));
    for i in 1..last {
        (lower[i], diagonal[i], upper[i]) = (h[i - 1], two * (h[i - 1] + h[i]), h[i]);
        right[i] = six * (s[i] - s[i - 1]);
    }
    tridiagonal(&lower, &diagonal, &upper, right)
}

/// Second derivatives of a periodic spline: slope and second derivative at both ends agree.
pub fn periodic_spline<T: Real>(points: &[[T; 2]]) -> Vec<T> {
    let count = points.len() - 1;
    let (two, six) = (T::from_f64(2.0), T::from_f64(6.0));
    let (h, s) = chords(points);
    let before = |i: usize| (i + count - 1) % count;
    let mut lower: Vec<T> = (0..count).map(|i| h[before(i)]).collect();
    let mut diagonal: Vec<T> = (0..count).map(|i| two * (h[before(i)] + h[i])).collect();
    let mut upper = h.clone();
    let right: Vec<T> = (0..count).map(|i| six * (s[i] - s[before(i)])).collect();
    // The corners, as a product u vᵀ beside a tridiagonal matrix (Sherman and Morrison).
    let corner = lower[0];
    let gamma = -diagonal[0];
    diagonal[0] -= gamma;
    diagonal[count - 1] -= corner * corner / gamma;
    (lower[0], upper[count - 1]) = (T::zero(), T::zero());
    let mut u = vec![T::zero(); count];
    u[0] = gamma;
    u[count - 1] += corner;
    let plain = tridiagonal(&lower, &diagonal, &upper, right);
    let shift = tridiagonal(&lower, &diagonal, &upper, u);
    let along = |x: &[T]| x[0] + x[count - 1] * (corner / gamma);
    let factor = along(&plain) / (T::one() + along(&shift));
    let mut moments: Vec<T> = plain.iter().zip(&shift).map(|(a, b)| *a - factor * *b).collect();
    moments.push(moments[0]);
    moments
}

/// Second derivatives of a natural spline: zero at both ends, from where it continues as a straight line.
pub fn natural_spline<T: Real>(points: &[[T; 2]]) -> Vec<T> {
    let last = points.len() - 1;
    let (two, six) = (T::from_f64(2.0), T::from_f64(6.0));
    let (h, s) = chords(points);
    let inner = 1..last;
    let lower: Vec<T> = inner.clone().map(|i| h[i - 1]).collect();
    let diagonal: Vec<T> = inner.clone().map(|i| two * (h[i - 1] + h[i])).collect();
    let upper: Vec<T> = inner.clone().map(|i| h[i]).collect();
    let right: Vec<T> = inner.map(|i| six * (s[i] - s[i - 1])).collect();
    let mut moments = vec![T::zero()];
    moments.extend(tridiagonal(&lower, &diagonal, &upper, right));
    moments.push(T::zero());
    moments
}

/// The cubic spline through `points`, at least two, that begins and ends at rest: slope and second derivative are zero at both ends. Gives
/// its nodes, two more than there are points, and the second derivatives there.
///
/// A spline through the points alone has two numbers to choose, and rest at both ends asks for four. So the first and the last interval have
/// a further node each, in their middle (at the thirds of an only interval). Its value follows from the slope at the end:
/// y_1 = y_0 + h_0² M_1/6 with M_0 = 0, and the same from the other end. Put into the rows of [`clamped_spline`], that leaves a
/// tridiagonal system in M_1 to M_(m-1).
pub fn resting_spline<T: Real>(points: &[[T; 2]]) -> (Vec<[T; 2]>, Vec<T>) {
    let (two, six) = (T::from_f64(2.0), T::from_f64(6.0));
    let count = points.len() - 1;
    let between = |k: usize, share: f64| {
        let share = T::from_f64(share);
        let [[x0, y0], [x1, _]] = [points[k], points[k + 1]];
        [x0 + share * (x1 - x0), y0]
    };
    let shares = if count == 1 { [1.0 / 3.0, 2.0 / 3.0] } else { [0.5, 0.5] };
    let mut nodes = vec![points[0], between(0, shares[0])];
    nodes.extend(&points[1..count]);
    nodes.extend([between(count - 1, shares[1]), points[count]]);
    let last = nodes.len() - 1;
    let (h, _) = chords(&nodes);
    // Values without what the unknown ones depend on: M_1 and M_(last-1).
    let value = |i: usize| match i {
        0 | 1 => points[0][1],
        i if i + 1 >= last => points[count][1],
        i => points[i - 1][1],
    };
    let inner = 1..last;
    let mut lower: Vec<T> = inner.clone().map(|i| h[i - 1]).collect();
    let mut diagonal: Vec<T> = inner.clone().map(|i| two * (h[i - 1] + h[i])).collect();
    let mut upper: Vec<T> = inner.clone().map(|i| h[i]).collect();
    let chord = |i: usize| (value(i + 1) - value(i)) / h[i];
    let right: Vec<T> = inner.map(|i| six * (chord(i) - chord(i - 1))).collect();
    let end = last - 2;
    let (first, final_) = (h[0] * h[0] / h[1], h[last - 1] * h[last - 1] / h[last - 2]);
    diagonal[0] += first + h[0];
    diagonal[end] += final_ + h[last - 1];
    lower[1] -= first;
    upper[end - 1] -= final_;
    let mut moments = vec![T::zero()];
    moments.extend(tridiagonal(&lower, &diagonal, &upper, right));
    moments.push(T::zero());
    nodes[1][1] = points[0][1] + h[0] * h[0] * moments[1] / six;
    nodes[last - 1][1] = points[count][1] + h[last - 1] * h[last - 1] * moments[last - 1] / six;
    (nodes, moments)
}

/// Slopes at the nodes of a curve of cubic pieces through `points` that rises only where they rise and falls only where they fall,
/// and whose slope does not jump: the weighted harmonic mean of the chords' slopes on both sides, zero where they differ in sign;
/// at the ends the slope of a parabola through three points, as far as it keeps the shape.
///
/// F. N. Fritsch and J. Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300-304, eq. (5) with Brodlie's weights.
pub fn monotone_slopes(points: &[[f64; 2]]) -> Vec<f64> {
    let last = points.len() - 1;
    let (h, s) = chords(points);
    let end = |near: usize, far: usize| {
        let slope = ((2.0 * h[near] + h[far]) * s[near] - h[near] * s[far]) / (h[near] + h[far]);
        if slope * s[near] <= 0.0 {
            0.0
        } else if s[near] * s[far] <= 0.0 && slope.abs() > 3.0 * s[near].abs() {
            3.0 * s[near]
        } else {
            slope
        }
    };
    let inner = (1..last).map(|i| {
        if s[i - 1] * s[i] <= 0.0 {
            return 0.0;
        }
        let (before, after) = (2.0 * h[i] + h[i - 1], h[i] + 2.0 * h[i - 1]);
        (before + after) / (before / s[i - 1] + after / s[i])
    });
    let mut slopes = vec![end(0, 1)];
    slopes.extend(inner);
    slopes.push(end(last - 1, last - 2));
    slopes
}

/// Coefficients of the cubic c0 + c1 u + c2 u² + c3 u³ between two points, u from the first, with the slopes there.
pub fn cubic_with_slopes([x0, y0]: [f64; 2], [x1, y1]: [f64; 2], [m0, m1]: [f64; 2]) -> [f64; 4] {
    let h = x1 - x0;
    let s = (y1 - y0) / h;
    [y0, m0, (3.0 * s - 2.0 * m0 - m1) / h, (m0 + m1 - 2.0 * s) / (h * h)]
}

/// Coefficients of the cubic c0 + c1 u + c2 u² + c3 u³ between two points, u from the first, with the second derivatives
/// there.
pub fn cubic_piece<T: Real>([x0, y0]: [T; 2], [x1, y1]: [T; 2], [m0, m1]: [T; 2]) -> [T; 4] {
    let h = x1 - x0;
    let six = T::from_f64(6.0);
    [y0, (y1 - y0) / h - h * (m0 + m0 + m1) / six, T::from_f64(0.5) * m0, (m1 - m0) / (six * h)]
}

/// Widths of the intervals and slopes of the chords.
fn chords<T: Real>(points: &[[T; 2]]) -> (Vec<T>, Vec<T>) {
    points
        .windows(2)
        .map(|pair| (pair[1][0] - pair[0][0], (pair[1][1] - pair[0][1]) / (pair[1][0] - pair[0][0])))
        .unzip()
}

/// Solves a tridiagonal system by elimination without pivots: spline matrices are dominated by their diagonal.
fn tridiagonal<T: Real>(lower: &[T], diagonal: &[T], upper: &[T], mut right: Vec<T>) -> Vec<T> {
    let n = right.len();
    let mut pivots = diagonal.to_vec();
    for i in 1..n {
        let factor = lower[i] / pivots[i - 1];
        pivots[i] -= factor * upper[i - 1];
        let before = right[i - 1];
        right[i] -= factor * before;
    }
    for i in (0..n).rev() {
        let beyond = if i + 1 < n { upper[i] * right[i + 1] } else { T::zero() };
        right[i] = (right[i] - beyond) / pivots[i];
    }
    right
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Largest jump of value, slope and second derivative between neighbouring pieces.
    fn jumps(points: &[[f64; 2]], moments: &[f64]) -> f64 {
        let piece = |i: usize| cubic_piece(points[i], points[i + 1], [moments[i], moments[i + 1]]);
        let mut largest = 0.0_f64;
        for i in 0..points.len() - 2 {
            let (h, c, next) = (points[i + 1][0] - points[i][0], piece(i), piece(i + 1));
            let end = [
                c[0] + h * (c[1] + h * (c[2] + h * c[3])),
                c[1] + h * (2.0 * c[2] + h * 3.0 * c[3]),
                2.0 * c[2] + 6.0 * h * c[3],
            ];
            let start = [next[0], next[1], 2.0 * next[2]];
            largest = end.iter().zip(start).fold(largest, |l, (a, b)| l.max((a - b).abs()));
        }
        largest
    }

    const POINTS: [[f64; 2]; 5] = [[0.3, 1.1], [0.5, 1.7], [1.2, 0.4], [1.9, 0.6], [2.3, 2.9]];

    #[test]
    fn identity_pieces_fit_together() {
        for (name, moments) in [("clamped", clamped_spline(&POINTS)), ("periodic", periodic_spline(&POINTS))] {
            // Round-off of moments up to a hundred.
            assert!(jumps(&POINTS, &moments) < 1e-12, "{name}: {}", jumps(&POINTS, &moments));
        }
        let moments = clamped_spline(&POINTS);
        let first = cubic_piece(POINTS[0], POINTS[1], [moments[0], moments[1]]);
        assert!(first[1].abs() < 1e-13, "it starts at rest: {}", first[1]);
        let (last, h) = (cubic_piece(POINTS[3], POINTS[4], [moments[3], moments[4]]), 0.4);
        assert!((last[1] + h * (2.0 * last[2] + h * 3.0 * last[3])).abs() < 1e-12, "it ends at rest");
        let moments = periodic_spline(&POINTS);
        let first = cubic_piece(POINTS[0], POINTS[1], [moments[0], moments[1]]);
        let last = cubic_piece(POINTS[3], POINTS[4], [moments[3], moments[4]]);
        assert!((last[1] + h * (2.0 * last[2] + h * 3.0 * last[3]) - first[1]).abs() < 1e-12, "it goes on as it began");
        assert_eq!(moments[0], moments[4]);
    }

    #[test]
    fn identity_a_natural_spline_ends_straight() {
        let moments = natural_spline(&POINTS);
        assert!(jumps(&POINTS, &moments) < 1e-12, "{}", jumps(&POINTS, &moments));
        assert_eq!((moments[0], moments[4]), (0.0, 0.0));
        // Points on a line stay on it.
        let line = POINTS.map(|[x, _]| [x, 0.3 - 1.7 * x]);
        assert!(natural_spline(&line).iter().all(|moment| moment.abs() < 1e-12));
    }

    #[test]
    fn identity_a_resting_spline_goes_through_its_points_and_rests_at_both_ends() {
        for count in 2..=POINTS.len() {
            let points = &POINTS[..count];
            let (nodes, moments) = resting_spline(points);
            assert_eq!((nodes.len(), moments.len()), (count + 2, count + 2));
            assert!(points.iter().all(|point| nodes.contains(point)), "{nodes:?}");
            // Round-off of moments up to a thousand.
            assert!(jumps(&nodes, &moments) < 1e-11, "{count}: {}", jumps(&nodes, &moments));
            assert_eq!((moments[0], moments[count + 1]), (0.0, 0.0));
            let piece = |i: usize| cubic_piece(nodes[i], nodes[i + 1], [moments[i], moments[i + 1]]);
            let (first, last, h) = (piece(0), piece(count), nodes[count + 1][0] - nodes[count][0]);
            let final_slope = last[1] + h * (2.0 * last[2] + h * 3.0 * last[3]);
            assert!(first[1].abs() < 1e-12 && final_slope.abs() < 1e-12, "{count}: {} {final_slope}", first[1]);
        }
    }

    #[test]
    fn analytic_a_rise_from_rest_to_rest_is_three_cubics_of_equal_length() {
        // Second derivative 0, a, -a, 0 at the thirds of a length of 3: the rise is a, and a/6 of it lies in the first third.
        let (nodes, moments) = resting_spline(&[[0.0, 0.7], [3.0, 1.9]]);
        let expected = [0.0, 1.2, -1.2, 0.0];
        assert!(
            moments.iter().zip(expected).all(|(found, due): (&f64, f64)| (found - due).abs() < 1e-14),
            "{moments:?}"
        );
        assert!((nodes[1][1] - 0.9).abs() < 1e-14 && (nodes[2][1] - 1.7).abs() < 1e-14, "{nodes:?}");
    }

    #[test]
    fn identity_a_monotone_curve_keeps_between_its_points() {
        let points = [[0.0, 0.1], [0.3, 0.2], [0.4, 5.0], [1.9, 5.1], [2.0, 5.1], [2.7, 9.0], [3.1, 8.0]];
        let slopes = monotone_slopes(&points);
        for i in 0..points.len() - 1 {
            let c = cubic_with_slopes(points[i], points[i + 1], [slopes[i], slopes[i + 1]]);
            let (low, high) = (points[i][1].min(points[i + 1][1]), points[i][1].max(points[i + 1][1]));
            for k in 0..=20 {
                let u = (points[i + 1][0] - points[i][0]) * f64::from(k) / 20.0;
                let value = c[0] + u * (c[1] + u * (c[2] + u * c[3]));
                assert!(value > low - 1e-14 && value < high + 1e-14, "piece {i}: {value} outside of {low} to {high}");
            }
        }
        let line = points.map(|[x, _]| [x, 0.3 - 1.7 * x]);
        assert!(monotone_slopes(&line).iter().all(|slope| (slope + 1.7).abs() < 1e-12));
    }

    #[test]
    fn analytic_error_falls_with_the_fourth_power_of_the_distance() {
        let error = |count: usize| {
            let tau = std::f64::consts::TAU;
            let points: Vec<[f64; 2]> =
                (0..=count).map(|k| tau * k as f64 / count as f64).map(|x| [x, 0.7 * x + x.sin()]).collect();
            let moments = periodic_spline(&points);
            (0..count)
                .map(|i| {
                    let c = cubic_piece(points[i], points[i + 1], [moments[i], moments[i + 1]]);
                    let u = 0.5 * (points[i + 1][0] - points[i][0]);
                    let x = points[i][0] + u;
                    (c[0] + u * (c[1] + u * (c[2] + u * c[3])) - 0.7 * x - x.sin()).abs()
                })
                .fold(0.0, f64::max)
        };
        // Half a power is left for higher terms.
        assert!((error(12) / error(24)).log2() > 3.5);
    }
}

//! Locating extremes inside a step.

/// A value and when it is attained.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// The value.
    pub value: f64,
    /// Time, s.
    pub time_s: f64,
}

impl Peak {
    /// Below every value.
    pub fn none() -> Self {
        Self { value: f64::NEG_INFINITY, time_s: f64::NAN }
    }
    /// Takes `value` at `time_s` where it is larger.
    pub fn raise(&mut self, value: f64, time_s: f64) {
        if value > self.value {
            *self = Self { value, time_s };
        }
    }
}

/// Points of a step at which a value is looked at before its extremes are located, at equal distances, ends included.
pub(crate) const POINTS_PER_STEP: usize = 5;

/// Between the points at which a step is looked at a value can rise above them by this share of their range only.
pub(crate) const ROOM: f64 = 0.25;

/// Whether a value that has these `points` inside a step may exceed `record` between them.
pub(crate) fn may_exceed(points: &[(f64, f64)], record: f64) -> bool {
    let (low, high) = points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p.1), h.max(p.1)));
    // Negated: what is not a number may exceed anything.
    !(high + ROOM * (high - low) <= record)
}

/// The largest value of `f` on the closed interval, given its values at `points` (increasing, at least two, the ends
/// among them): the highest point is improved between its neighbours.
pub fn maximum_within(points: &[(f64, f64)], mut f: impl FnMut(f64) -> f64) -> Peak {
    let Some(top) = (0..points.len()).max_by(|&a, &b| points[a].1.total_cmp(&points[b].1)) else {
        return Peak::none();
    };
    let (time_s, value) = points[top];
    if top > 0 && top + 1 < points.len() {
        return refine_maximum(points[top - 1].0, time_s, points[top + 1].0, f);
    }
    // At an end the maximum may still lie inside: look for a higher point ever closer to the end.
    if clearly_rises_to(points, top) {
        return Peak { value, time_s };
    }
    let neighbour_s = if top == 0 { points[1].0 } else { points[top - 1].0 };
    let mut outer_s = neighbour_s;
    for _ in 0..4 {
        let inner_s = time_s + 0.25 * (outer_s - time_s);
        if f(inner_s) > value {
            let (left_s, right_s) = if top == 0 { (time_s, outer_s) } else { (outer_s, time_s) };
            return refine_maximum(left_s, inner_s, right_s, f);
        }
        outer_s = inner_s;
    }
    Peak { value, time_s }
}

/// Whether a value rises so steeply towards the end of its `points` with index `end` that nothing higher lies just inside: there the slope of
/// the parabola through the last three points, and that of the cubic through the last four, are at least half of the last slope between two.
fn clearly_rises_to(points: &[(f64, f64)], end: usize) -> bool {
    let from_end = |k: usize| if end == 0 { points[k] } else { points[end - k] };
    if points.len() < 4 {
        return false;
    }
    let [(t0, y0), (t1, y1), (t2, y2), (t3, y3)] = [0, 1, 2, 3].map(from_end);
    // Newton's divided differences; with times that run away from the end all slopes are negative where the value rises to it.
    let [first, second, third] = [(y1 - y0) / (t1 - t0), (y2 - y1) / (t2 - t1), (y3 - y2) / (t3 - t2)];
    let [curved, curved_before] = [(second - first) / (t2 - t0), (third - second) / (t3 - t1)];
    let parabola = first + curved * (t0 - t1);
    let cubic = parabola + (curved_before - curved) / (t3 - t0) * (t0 - t1) * (t0 - t2);
    parabola / first >= 0.5 && cubic / first >= 0.5
}

/// The maximum of `f` between `left_s` and `right_s`, where `middle_s` lies higher than both, by golden sections and
/// parabolas until it no longer matters: the value is then within 1e-12 of its change over the bracket.
fn refine_maximum(left_s: f64, middle_s: f64, right_s: f64, mut f: impl FnMut(f64) -> f64) -> Peak {
    const GOLDEN: f64 = 0.381_966_011_250_105_1;
    let (mut a, mut m, mut b) = (left_s, middle_s, right_s);
    let (mut fa, mut fm, mut fb) = (f(a), f(m), f(b));
    for _ in 0..60 {
        // Parabola through the three points; a golden section where it leaves the bracket or degenerates.
        let (p, q) = ((m - a) * (fm - fb), (m - b) * (fm - fa));
        let parabola = m - 0.5 * ((m - a) * p - (m - b) * q) / (p - q);
        let margin = 1e-3 * (b - a);
        let golden = if m - a > b - m { m - GOLDEN * (m - a) } else { m + GOLDEN * (b - m) };
        let next = if parabola > a + margin && parabola < b - margin && (parabola - m).abs() > 1e-4 * (b - a) {
            parabola
        } else {
            golden
        };
        let fnext = f(next);
        let ((left, fleft), (right, fright)) =
            if next < m { ((next, fnext), (m, fm)) } else { ((m, fm), (next, fnext)) };
        if fleft > fright {
            (b, fb, m, fm) = (right, fright, left, fleft);
        } else {
            (a, fa, m, fm) = (left, fleft, right, fright);
        }
        let change = (fm - fa).max(fm - fb);
        if change <= 1e-12 * fm.abs() || b - a <= 1e-9 * (right_s - left_s) {
            break;
        }
    }
    Peak { value: fm, time_s: m }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_maximum_of_a_skewed_hump() {
        let f = |t: f64| 3.0 + (t * 2.1).sin() * (-0.7 * t).exp();
        let peak = refine_maximum(0.1, 0.5, 1.4, f);
        let exact = (2.1_f64 / 0.7).atan() / 2.1;
        // A maximum is flat: its place is known to the root of the last place.
        assert!((peak.time_s - exact).abs() < 1e-6);
        assert!((peak.value - f(exact)).abs() < 1e-13);
    }

    #[test]
    fn analytic_no_further_point_is_looked_at_where_a_value_clearly_rises_to_an_end() {
        let points = |f: fn(f64) -> f64| [0.0, 0.25, 0.5, 0.75, 1.0].map(|t| (t, f(t)));
        let rises: [fn(f64) -> f64; 3] = [|t| t, |t| t.exp(), |t| (0.9 * t).sin()];
        for f in rises {
            let expected = Peak { value: f(1.0), time_s: 1.0 };
            assert_eq!(maximum_within(&points(f), |_| unreachable!("the end is higher")), expected);
        }
        let falls: fn(f64) -> f64 = |t| -t.exp();
        assert_eq!(maximum_within(&points(falls), |_| unreachable!("the start is higher")).time_s, 0.0);
        // A maximum just inside, of a curve of the second, third and fourth degree.
        let inside: [fn(f64) -> f64; 3] =
            [|t| -(t - 0.97).powi(2), |t| t - (t / 0.97).powi(3) * 0.97 / 3.0, |t| t - (t / 0.97).powi(4) * 0.97 / 4.0];
        for f in inside {
            let peak = maximum_within(&points(f), f);
            assert!((peak.value - f(0.97)).abs() < 1e-12 && (peak.time_s - 0.97).abs() < 1e-5, "{peak:?}");
        }
    }

    #[test]
    fn analytic_maximum_just_inside_an_end_and_at_it() {
        let f = |t: f64| -(t - 0.03) * (t - 0.03);
        let points: Vec<(f64, f64)> = [0.0, 0.5, 1.0].map(|t| (t, f(t))).to_vec();
        assert!(maximum_within(&points, f).value.abs() < 1e-13);
        let falling: Vec<(f64, f64)> = [0.0, 0.5, 1.0].map(|t| (t, 2.0 - t)).to_vec();
        assert_eq!(maximum_within(&falling, |t| 2.0 - t), Peak { value: 2.0, time_s: 0.0 });
    }
}

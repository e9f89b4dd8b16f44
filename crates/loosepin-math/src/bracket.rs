//! A sign change of a function between two places.

/// Two places between which a function changes its sign, narrowed by false position with the Illinois rule (M. Dowell and P. Jarratt,
/// "A modified regula falsi method for computing the root of an equation", BIT 11 (1971) 168-174): where the same end moves twice, the
/// value at the other one is halved. The caller evaluates the function, and says when it is enough.
pub struct Bracket {
    /// Left and right place, in increasing order.
    places: [f64; 2],
    values: [f64; 2],
    has_moved_left: Option<bool>,
}

impl Bracket {
    /// Between two places in increasing order, with values of different signs.
    pub fn new(places: [f64; 2], values: [f64; 2]) -> Self {
        Self { places, values, has_moved_left: None }
    }

    /// Left and right place.
    pub fn places(&self) -> [f64; 2] {
        self.places
    }

    /// Where the function is wanted next: on the chord, or in the middle where round-off puts that at an end.
    pub fn next(&self) -> f64 {
        let ([left, right], [at_left, at_right]) = (self.places, self.values);
        let between = right - at_right * (right - left) / (at_right - at_left);
        if between > left && between < right { between } else { 0.5 * (left + right) }
    }

    /// Takes the value at a place in between; whether that is the left end now.
    pub fn take(&mut self, place: f64, value: f64) -> bool {
        let is_left = (value > 0.0) == (self.values[0] > 0.0);
        let [moved, other] = if is_left { [0, 1] } else { [1, 0] };
        (self.places[moved], self.values[moved]) = (place, value);
        if self.has_moved_left == Some(is_left) {
            self.values[other] *= 0.5;
        }
        self.has_moved_left = Some(is_left);
        is_left
    }
}

#[cfg(test)]
mod tests {
    use super::Bracket;

    #[test]
    fn analytic_a_cube_root_is_bracketed_ever_more_closely() {
        let of = |x: f64| x * x * x - 2.0;
        let mut bracket = Bracket::new([0.0, 4.0], [of(0.0), of(4.0)]);
        for _ in 0..40 {
            let next = bracket.next();
            bracket.take(next, of(next));
        }
        let [left, right] = bracket.places();
        assert!(left <= 2.0_f64.cbrt() && 2.0_f64.cbrt() <= right, "{left} {right}");
        assert!((bracket.next() - 2.0_f64.cbrt()).abs() < 1e-12, "{left} {right}");
    }
}

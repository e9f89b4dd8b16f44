//! The polynomial of degree five through values, slopes and curvatures at both ends of an interval.

use crate::Real;

/// p(τ) = Σ coefficient_k τᵏ on τ in [0, 1], matching value, first and second derivative at both ends.
///
/// For a smooth function on an interval of length h its error is at most h⁶/46080 times the sixth derivative.
#[derive(Debug, Clone, Copy)]
pub struct Quintic<T = f64> {
    /// Coefficients of τᵏ.
    pub coefficients: [T; 6],
}

impl<T: Real> Quintic<T> {
    /// From `[value, slope, curvature]` at the start and at the end of an interval of length `h`.
    #[inline]
    pub fn new(start: [T; 3], end: [T; 3], h: T) -> Self {
        let [half, three, four, six, seven, ten, fifteen] = [0.5, 3.0, 4.0, 6.0, 7.0, 10.0, 15.0].map(T::from_f64);
        let [p0, v0, a0] = [start[0], start[1] * h, start[2] * h * h];
        let [p1, v1, a1] = [end[0], end[1] * h, end[2] * h * h];
        let d = p1 - p0 - v0 - half * a0;
        let dv = v1 - v0 - a0;
        let da = a1 - a0;
        Self {
            coefficients: [
                p0,
                v0,
                half * a0,
                ten * d - four * dv + half * da,
                seven * dv - fifteen * d - da,
                six * d - three * dv + half * da,
            ],
        }
    }
    /// p(τ).
    #[inline]
    pub fn value(&self, tau: T) -> T {
        let c = &self.coefficients;
        c[0] + tau * (c[1] + tau * (c[2] + tau * (c[3] + tau * (c[4] + tau * c[5]))))
    }
    /// dp/dτ.
    #[inline]
    pub fn slope(&self, tau: T) -> T {
        let [two, three, four, five] = [2.0, 3.0, 4.0, 5.0].map(T::from_f64);
        let c = &self.coefficients;
        c[1] + tau * (two * c[2] + tau * (three * c[3] + tau * (four * c[4] + tau * (five * c[5]))))
    }
    /// d²p/dτ².
    #[inline]
    pub fn curvature(&self, tau: T) -> T {
        let [two, six, twelve, twenty] = [2.0, 6.0, 12.0, 20.0].map(T::from_f64);
        let c = &self.coefficients;
        two * c[2] + tau * (six * c[3] + tau * (twelve * c[4] + tau * (twenty * c[5])))
    }
    /// The smallest and the largest Bernstein coefficient over both halves of [0, 1]: the polynomial stays between them.
    #[inline]
    pub fn limits(&self) -> [T; 2] {
        let [half, tenth, fifth, three_tenths, two_fifths, three_fifths, four_fifths] =
            [0.5, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8].map(T::from_f64);
        let c = &self.coefficients;
        // b_i = Σ_k binomial(i, k) / binomial(5, k) c_k.
        let mut row = [
            c[0],
            c[0] + fifth * c[1],
            c[0] + two_fifths * c[1] + tenth * c[2],
            c[0] + three_fifths * c[1] + three_tenths * c[2] + tenth * c[3],
            c[0] + four_fifths * c[1] + three_fifths * c[2] + two_fifths * c[3] + fifth * c[4],
            self.value(T::one()),
        ];
        // De Casteljau's means: the first and the last of each row are coefficients of the halves.
        let [mut low, mut high] = [row[0].min(row[5]), row[0].max(row[5])];
        for length in (1..6).rev() {
            for k in 0..length {
                row[k] = half * (row[k] + row[k + 1]);
            }
            low = low.min(row[0]).min(row[length - 1]);
            high = high.max(row[0]).max(row[length - 1]);
        }
        [low, high]
    }
}

#[cfg(test)]
mod tests {
    use super::Quintic;

    #[test]
    fn analytic_reproduces_a_polynomial_of_degree_five() {
        let f = |x: f64| 0.3 - 1.1 * x + 0.7 * x.powi(2) - 0.2 * x.powi(3) + 0.9 * x.powi(4) - 0.4 * x.powi(5);
        let df = |x: f64| -1.1 + 1.4 * x - 0.6 * x.powi(2) + 3.6 * x.powi(3) - 2.0 * x.powi(4);
        let ddf = |x: f64| 1.4 - 1.2 * x + 10.8 * x.powi(2) - 8.0 * x.powi(3);
        let (a, h) = (0.4, 1.7);
        let quintic = Quintic::new([f(a), df(a), ddf(a)], [f(a + h), df(a + h), ddf(a + h)], h);
        for k in 0..=10 {
            let tau = f64::from(k) / 10.0;
            // Round-off on numbers of order ten.
            assert!((quintic.value(tau) - f(a + tau * h)).abs() < 1e-13);
            assert!((quintic.slope(tau) - h * df(a + tau * h)).abs() < 1e-12);
            assert!((quintic.curvature(tau) - h * h * ddf(a + tau * h)).abs() < 1e-11);
            let [low, high] = quintic.limits();
            assert!(low <= quintic.value(tau) && quintic.value(tau) <= high);
        }
    }

    #[test]
    fn analytic_the_limits_of_a_parabola_are_those_of_its_halves() {
        // τ (1 - τ) has the coefficients 0, 1/4, 1/4 over its first half as a parabola, 0, 1/10, ..., 1/4 as a quintic; those of the whole
        // go up to 0.3.
        let parabola = Quintic { coefficients: [0.0, 1.0, -1.0, 0.0, 0.0, 0.0] };
        let [low, high] = parabola.limits();
        assert!(low.abs() < 1e-15 && (high - 0.25).abs() < 1e-15, "{low} {high}");
    }
}

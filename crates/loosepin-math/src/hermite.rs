//! The polynomial of degree five through values, slopes and curvatures at both ends of an interval.

/// p(τ) = Σ coefficient_k τᵏ on τ in [0, 1], matching value, first and second derivative at both ends.
///
/// For a smooth function on an interval of length h its error is at most h⁶/46080 times the sixth derivative.
#[derive(Debug, Clone, Copy)]
pub struct Quintic {
    coefficients: [f64; 6],
}

impl Quintic {
    /// From `[value, slope, curvature]` at the start and at the end of an interval of length `h`.
    pub fn new(start: [f64; 3], end: [f64; 3], h: f64) -> Self {
        let [p0, v0, a0] = [start[0], start[1] * h, start[2] * h * h];
        let [p1, v1, a1] = [end[0], end[1] * h, end[2] * h * h];
        let d = p1 - p0 - v0 - 0.5 * a0;
        let dv = v1 - v0 - a0;
        let da = a1 - a0;
        Self {
            coefficients: [
                p0,
                v0,
                0.5 * a0,
                10.0 * d - 4.0 * dv + 0.5 * da,
                -15.0 * d + 7.0 * dv - da,
                6.0 * d - 3.0 * dv + 0.5 * da,
            ],
        }
    }
    /// p(τ).
    #[inline]
    pub fn value(&self, tau: f64) -> f64 {
        let c = &self.coefficients;
        c[0] + tau * (c[1] + tau * (c[2] + tau * (c[3] + tau * (c[4] + tau * c[5]))))
    }
    /// d²p/dτ².
    #[inline]
    pub fn curvature(&self, tau: f64) -> f64 {
        let c = &self.coefficients;
        2.0 * c[2] + tau * (6.0 * c[3] + tau * (12.0 * c[4] + tau * 20.0 * c[5]))
    }
    /// The largest and the smallest Bernstein coefficient: the polynomial stays between them on [0, 1].
    #[inline]
    pub fn limits(&self) -> [f64; 2] {
        let c = &self.coefficients;
        // b_i = Σ_k binomial(i, k) / binomial(5, k) c_k.
        let b1 = c[0] + 0.2 * c[1];
        let b2 = c[0] + 0.4 * c[1] + 0.1 * c[2];
        let b3 = c[0] + 0.6 * c[1] + 0.3 * c[2] + 0.1 * c[3];
        let b4 = c[0] + 0.8 * c[1] + 0.6 * c[2] + 0.4 * c[3] + 0.2 * c[4];
        let b5 = c[0] + c[1] + c[2] + c[3] + c[4] + c[5];
        let (low, high) = (c[0].min(b1).min(b2), c[0].max(b1).max(b2));
        [low.min(b3).min(b4).min(b5), high.max(b3).max(b4).max(b5)]
    }
    /// dp/dτ.
    #[inline]
    pub fn slope(&self, tau: f64) -> f64 {
        let c = &self.coefficients;
        c[1] + tau * (2.0 * c[2] + tau * (3.0 * c[3] + tau * (4.0 * c[4] + tau * 5.0 * c[5])))
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
}

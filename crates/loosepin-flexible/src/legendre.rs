//! Points and weights of Gauss and Legendre on [0, 1].

/// Newton steps; the start is right to a few digits, so that five are enough.
const NEWTON_STEPS: usize = 8;

/// `count` pairs of a point and its weight, points increasing: exact for polynomials up to the degree 2 count - 1.
pub(crate) fn gauss_points(count: usize) -> Vec<[f64; 2]> {
    let mut points = vec![[0.0; 2]; count];
    for k in 0..count.div_ceil(2) {
        let mut x = loosepin_math::sin_cos(std::f64::consts::PI * (k as f64 + 0.75) / (count as f64 + 0.5)).1;
        let mut slope = 1.0;
        for _ in 0..NEWTON_STEPS {
            // Legendre's polynomial and the one before it.
            let (mut before, mut value) = (1.0, x);
            for degree in 2..=count {
                let n = degree as f64;
                (before, value) = (value, ((2.0 * n - 1.0) * x * value - (n - 1.0) * before) / n);
            }
            slope = count as f64 * (x * value - before) / (x * x - 1.0);
            x -= value / slope;
        }
        let weight = 1.0 / ((1.0 - x * x) * slope * slope);
        points[k] = [0.5 * (1.0 - x), weight];
        points[count - 1 - k] = [0.5 * (1.0 + x), weight];
    }
    points
}

#[cfg(test)]
mod tests {
    use super::gauss_points;

    #[test]
    fn analytic_powers_are_integrated_exactly() {
        for count in [2, 5, 12, 16, 24, 40] {
            for degree in 0..2 * count {
                let sum: f64 = gauss_points(count).iter().map(|[x, weight]| weight * x.powi(degree as i32)).sum();
                let exact = 1.0 / (degree as f64 + 1.0);
                assert!((sum - exact).abs() < 4e-15, "{count} points, degree {degree}: {sum} for {exact}");
            }
        }
    }
}

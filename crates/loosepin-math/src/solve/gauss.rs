//! Polynomials that are orthonormal for a distribution, and Gauss rules of them.
//!
//! ```text
//! b_(k+1) p_(k+1) = (t - a_k) p_k - b_k p_(k-1),   p_0 = 1,  p_(-1) = 0
//! ∫ f(t) dF(t) ≈ Σ w_i f(t_i),   p_n(t_i) = 0,   w_i = 1/Σ_(k<n) p_k(t_i)²
//! ```
//!
//! Exact for polynomials up to the degree 2n - 1. Source: W. Gautschi, "Orthogonal polynomials: computation and approximation" (2004),
//! section 1.3 and table 1.1.

/// Distance of the values among which roots are sought; the closest ones of Legendre's polynomial of order 32 lie 0.011 apart.
const ROOT_STEP: f64 = 0.005;

/// From that order on the distance is this over (n + ½)²: half of that of the outermost two roots of Legendre's polynomial.
const ROOT_STEP_OF_ORDER: f64 = 6.0;

/// p_0 to p_degree at `t`; `coefficients` gives a_k and b_(k+1).
pub fn orthonormal_values(t: f64, degree: usize, coefficients: &dyn Fn(usize) -> (f64, f64)) -> Vec<f64> {
    let mut values = Vec::with_capacity(degree + 1);
    values.push(1.0);
    let (mut before, mut weight_before) = (0.0, 0.0);
    for n in 0..degree {
        let (shift, weight) = coefficients(n);
        let last = values[n];
        values.push(((t - shift) * last - weight_before * before) / weight);
        (before, weight_before) = (last, weight);
    }
    values
}

/// b_k of Legendre's polynomials, orthonormal for a uniform variable in [-1, 1]; a_k = 0.
pub fn legendre_coefficient(k: usize) -> f64 {
    let k = k as f64;
    k / (4.0 * k * k - 1.0).max(1.0).sqrt()
}

/// The Gauss rule of `count` nodes for a distribution that is symmetric about 0, with a_k = 0 and b_k = `coefficient(k)`, whose roots lie
/// within ±`end`: nodes in increasing order, each with its weight; the weights add up to 1.
pub fn symmetric_gauss_rule(count: usize, end: f64, coefficient: &dyn Fn(usize) -> f64) -> Vec<(f64, f64)> {
    let values = |t: f64, degree: usize| orthonormal_values(t, degree, &|k| (0.0, coefficient(k + 1)));
    let last = |t: f64| values(t, count)[count];
    let order = count as f64 + 0.5;
    // An even number of steps would put one of them on the root 0 of odd orders.
    let steps = 2 * (end / ROOT_STEP.min(ROOT_STEP_OF_ORDER / (order * order))) as usize + 1;
    let at = |step: usize| end * (2.0 * step as f64 / steps as f64 - 1.0);
    let mut nodes = Vec::with_capacity(count);
    for step in 0..steps {
        let (mut low, mut high) = (at(step), at(step + 1));
        let sign = last(low).signum();
        if sign == last(high).signum() {
            continue;
        }
        while high - low > f64::EPSILON * end {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if last(middle).signum() == sign { low = middle } else { high = middle }
        }
        let node = 0.5 * (low + high);
        let weight = 1.0 / values(node, count - 1).iter().map(|value| value * value).sum::<f64>();
        nodes.push((node, weight));
    }
    nodes
}

/// The Gauss rule of Legendre for a uniform variable in [-1, 1].
pub fn legendre_rule(count: usize) -> Vec<(f64, f64)> {
    symmetric_gauss_rule(count, 1.0, &legendre_coefficient)
}

#[cfg(test)]
mod tests {
    use super::legendre_rule;

    #[test]
    fn analytic_powers_are_integrated_exactly() {
        // Nodes and weights are rounded, and there are up to 80 terms.
        const TOLERANCE: f64 = 4e-15;
        for count in [1, 2, 5, 12, 16, 24, 33, 40, 64, 80] {
            let rule = legendre_rule(count);
            assert_eq!(rule.len(), count);
            for degree in 0..2 * count {
                let sum: f64 = rule.iter().map(|(t, weight)| weight * (0.5 * (1.0 + t)).powi(degree as i32)).sum();
                let exact = 1.0 / (degree as f64 + 1.0);
                assert!((sum - exact).abs() < TOLERANCE, "{count} points, degree {degree}: {sum} for {exact}");
            }
        }
    }

    #[test]
    fn published_the_rule_of_five_points() {
        // M. Abramowitz and I. A. Stegun, "Handbook of mathematical functions" (1964), table 25.4, whose weights add up to 2.
        let expected = [
            (-0.906_179_845_938_664, 0.236_926_885_056_189),
            (-0.538_469_310_105_683, 0.478_628_670_499_366),
            (0.0, 0.568_888_888_888_889),
            (0.538_469_310_105_683, 0.478_628_670_499_366),
            (0.906_179_845_938_664, 0.236_926_885_056_189),
        ];
        let rule = legendre_rule(5);
        assert_eq!(rule.len(), expected.len());
        for ((node, weight), (abscissa, factor)) in rule.into_iter().zip(expected) {
            assert!((node - abscissa).abs() < 1e-15 && (2.0 * weight - factor).abs() < 1e-15, "{node} {weight}");
        }
    }
}

//! The regularised incomplete gamma functions and their inverse, for the gamma distribution.
//!
//! `statrs` has both, but on the platform's `ln` and `exp`, whose bits differ between platforms.

use crate::functions::normal::normal_quantile;

/// P(a, x) = γ(a, x)/Γ(a) and Q(a, x) = 1 - P(a, x), each with its own digits, for `a > 0` and `x >= 0`.
///
/// The series 6.5.29 of Abramowitz and Stegun below x = a + 1, the continued fraction 6.5.31 by Lentz's method above.
pub(crate) fn incomplete_gamma(a: f64, x: f64) -> [f64; 2] {
    if x <= 0.0 {
        return [0.0, 1.0];
    }
    if x == f64::INFINITY {
        return [1.0, 0.0];
    }
    let [ln_below, ln_above] = ln_incomplete_gamma(a, x);
    [libm::exp(ln_below), libm::exp(ln_above)]
}

/// ln P(a, x) and ln Q(a, x).
fn ln_incomplete_gamma(a: f64, x: f64) -> [f64; 2] {
    let ln_front = ln_front(a, x);
    if x < a + 1.0 {
        let ln_below = ln_front + libm::log(series(a, x));
        [ln_below, libm::log1p(-libm::exp(ln_below).min(1.0))]
    } else {
        let ln_above = ln_front + libm::log(a * continued_fraction(a, x));
        [libm::log1p(-libm::exp(ln_above).min(1.0)), ln_above]
    }
}

/// ln(x^a e^-x/Γ(a + 1)).
///
/// For large a by Stirling's series with u = (x - a)/a, so that the large terms do not cancel:
/// -a (u - ln(1 + u)) - ln(2π a)/2 - 1/(12 a) + 1/(360 a³) - 1/(1260 a⁵).
fn ln_front(a: f64, x: f64) -> f64 {
    const STIRLING_FROM: f64 = 30.0;
    if a < STIRLING_FROM {
        return a * libm::log(x) - x - libm::lgamma(a + 1.0);
    }
    let inverse = 1.0 / a;
    let square = inverse * inverse;
    let correction = inverse * (1.0 / 12.0 - square * (1.0 / 360.0 - square / 1260.0));
    -a * excess_over_logarithm(x, a) - 0.5 * libm::log(2.0 * core::f64::consts::PI * a) - correction
}

/// u - ln(1 + u) with u = (x - a)/a, by its series where the difference would lose digits; 1 + u = x/a keeps them where x is
/// small.
fn excess_over_logarithm(x: f64, a: f64) -> f64 {
    const SERIES_BELOW: f64 = 0.1;
    let u = (x - a) / a;
    if u.abs() > SERIES_BELOW {
        return u - libm::log(x / a);
    }
    let (mut power, mut sum, mut order) = (u * u, 0.0, 2.0);
    while power.abs() > f64::EPSILON * 1e-3 * u * u {
        sum += power / order;
        power *= -u;
        order += 1.0;
    }
    sum
}

/// Σ xⁿ/((a + 1) ... (a + n)).
fn series(a: f64, x: f64) -> f64 {
    const MAX_TERMS: u32 = 1_000_000;
    let (mut term, mut sum) = (1.0, 1.0);
    for n in 1..=MAX_TERMS {
        term *= x / (a + f64::from(n));
        sum += term;
        if term <= f64::EPSILON * sum {
            break;
        }
    }
    sum
}

/// Q(a, x) Γ(a)/(x^a e^-x).
fn continued_fraction(a: f64, x: f64) -> f64 {
    const SMALLEST: f64 = 1e-300;
    const MAX_TERMS: u32 = 1_000_000;
    let guard = |value: f64| if value.abs() < SMALLEST { SMALLEST } else { value };
    let mut b = x + 1.0 - a;
    let mut c = 1.0 / SMALLEST;
    let mut d = 1.0 / guard(b);
    let mut fraction = d;
    for n in 1..=MAX_TERMS {
        let n = f64::from(n);
        let numerator = -n * (n - a);
        b += 2.0;
        d = 1.0 / guard(numerator * d + b);
        c = guard(b + numerator / c);
        let change = d * c;
        fraction *= change;
        if (change - 1.0).abs() <= f64::EPSILON {
            break;
        }
    }
    fraction
}

/// The x with P(a, x) = `below`, where `above` = 1 - `below` is given by itself.
///
/// Newton's method on the logarithm of the smaller tail as a function of ln x, held inside a bracket that only shrinks; it
/// starts from the cube of a normal variable (E. B. Wilson and M. M. Hilferty 1931).
pub(crate) fn inverse_incomplete_gamma(a: f64, below: f64, above: f64) -> f64 {
    const MAX_STEPS: usize = 200;
    if below <= 0.0 {
        return 0.0;
    }
    if above <= 0.0 {
        return f64::INFINITY;
    }
    let is_lower = below <= above;
    let ln_tail = libm::log(if is_lower { below } else { above });
    // How far the tail at exp(t) is beyond the one that is wanted, increasing with t, and its slope.
    let excess = |t: f64| {
        let x = libm::exp(t);
        if x <= 0.0 {
            return (a * t - libm::lgamma(a + 1.0) - ln_tail, a);
        }
        let ln_tails = ln_incomplete_gamma(a, x);
        let [ln_value, sign] = if is_lower { [ln_tails[0], 1.0] } else { [ln_tails[1], -1.0] };
        (sign * (ln_value - ln_tail), a * libm::exp(ln_front(a, x) - ln_value))
    };
    // P(a, x) <= x^a/Γ(a + 1), with equality as x -> 0.
    let mut low = (libm::log(below) + libm::lgamma(a + 1.0)) / a - 1e-9;
    let z = if is_lower { normal_quantile(below) } else { -normal_quantile(above) };
    let root = 1.0 - 1.0 / (9.0 * a) + z / (3.0 * a.sqrt());
    let mut t = if root > 0.0 { libm::log(a) + 3.0 * libm::log(root) } else { low }.max(low);
    let mut high = t.max(low) + 1.0;
    while excess(high).0 < 0.0 {
        low = high;
        high += (high - t).abs().max(1.0);
    }
    for _ in 0..MAX_STEPS {
        let (over, slope) = excess(t);
        if over > 0.0 {
            high = t;
        } else {
            low = t;
        }
        let newton = t - over / slope;
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        let change = (next - t).abs();
        t = next;
        if change <= f64::EPSILON * t.abs().max(1.0) {
            break;
        }
    }
    libm::exp(t)
}

/// ψ(x), the derivative of ln Γ, for `x > 0`: by the recurrence to x >= 10, then the asymptotic series 6.3.18 of Abramowitz and
/// Stegun.
pub(crate) fn digamma(x: f64) -> f64 {
    const ASYMPTOTIC_FROM: f64 = 10.0;
    /// Coefficients of 1/x², 1/x⁴, ...
    const SERIES: [f64; 7] =
        [1.0 / 12.0, -1.0 / 120.0, 1.0 / 252.0, -1.0 / 240.0, 5.0 / 660.0, -691.0 / 32_760.0, 1.0 / 12.0];
    let (mut x, mut sum) = (x, 0.0);
    while x < ASYMPTOTIC_FROM {
        sum -= 1.0 / x;
        x += 1.0;
    }
    let square = 1.0 / (x * x);
    let tail = SERIES.iter().rev().fold(0.0, |tail, coefficient| (tail + coefficient) * square);
    sum + libm::log(x) - 0.5 / x - tail
}

#[cfg(test)]
mod tests {
    use super::{digamma, incomplete_gamma, inverse_incomplete_gamma};

    #[test]
    fn analytic_whole_shapes_are_sums_of_a_poisson_distribution() {
        const RELATIVE_TOLERANCE: f64 = 1e-13; // the error of lgamma
        for x in [0.01, 0.7, 2.5, 4.5, 30.0, 200.0] {
            // Q(3, x) = e^-x (1 + x + x²/2)
            let exact = libm::exp(-x) * (1.0 + x + 0.5 * x * x);
            assert!((incomplete_gamma(3.0, x)[1] / exact - 1.0).abs() < RELATIVE_TOLERANCE, "{x}");
        }
        for x in [1e-8, 0.3, 5.0] {
            // P(1/2, x) = erf(√x)
            assert!((incomplete_gamma(0.5, x)[0] / libm::erf(x.sqrt()) - 1.0).abs() < RELATIVE_TOLERANCE, "{x}");
        }
    }

    #[test]
    fn identity_the_inverse_inverts_in_both_tails() {
        // The error of the functions themselves, which grows with the root of the shape.
        const RELATIVE_TOLERANCE: f64 = 2e-11;
        for a in [0.05, 0.5, 1.0, 3.7, 29.0, 31.0, 400.0, 1e6] {
            for exponent in 1..=300 {
                let tail = libm::pow(10.0, -f64::from(exponent));
                let x = inverse_incomplete_gamma(a, tail, 1.0 - tail);
                // Below, x itself has fewer digits or none.
                if x > 1e-290 {
                    let back = incomplete_gamma(a, x)[0];
                    assert!(
                        (back / tail - 1.0).abs() < RELATIVE_TOLERANCE * (1.0 + f64::from(exponent)),
                        "{a} {tail} {back}"
                    );
                }
                let x = inverse_incomplete_gamma(a, 1.0 - tail, tail);
                let back = incomplete_gamma(a, x)[1];
                assert!(
                    (back / tail - 1.0).abs() < RELATIVE_TOLERANCE * (1.0 + f64::from(exponent)),
                    "{a} {tail} {back}"
                );
            }
        }
    }

    #[test]
    fn peer_statrs() {
        const RELATIVE_TOLERANCE: f64 = 1e-11; // that of the peer
        for (a, x) in [(2.5, 1.3), (12.0, 20.0), (0.3, 0.05), (150.0, 140.0)] {
            let [below, above] = incomplete_gamma(a, x);
            assert!((below / statrs::function::gamma::gamma_lr(a, x) - 1.0).abs() < RELATIVE_TOLERANCE, "{a} {x}");
            assert!((above / statrs::function::gamma::gamma_ur(a, x) - 1.0).abs() < RELATIVE_TOLERANCE, "{a} {x}");
        }
    }

    #[test]
    fn analytic_digamma() {
        const TOLERANCE: f64 = 1e-14;
        assert!((digamma(1.0) + 0.577_215_664_901_532_9).abs() < TOLERANCE);
        // ψ(1/2) = -γ - 2 ln 2
        let half = -0.577_215_664_901_532_9 - 2.0 * core::f64::consts::LN_2;
        assert!((digamma(0.5) - half).abs() < TOLERANCE);
    }
}

//! The regularised incomplete beta function and its inverse, for the beta distribution and Student's factor.
//!
//! `statrs` has both, but on the platform's `ln` and `exp`, whose bits differ between platforms.

/// I_x(a, b) = B(x; a, b)/B(a, b), and its logarithm, for `a, b > 0` and `x` in \[0, 1\].
///
/// Continued fraction 26.5.8 of Abramowitz and Stegun by Lentz's method (W. J. Lentz 1976, as modified by Thompson and
/// Barnett 1986); beyond its fast range through I_x(a, b) = 1 - I_(1-x)(b, a). `one_minus_x` is given by itself so that
/// nothing is lost near x = 1.
pub(crate) fn incomplete_beta(a: f64, b: f64, x: f64, one_minus_x: f64) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    if one_minus_x <= 0.0 {
        return 1.0;
    }
    if x < (a + 1.0) / (a + b + 2.0) {
        libm::exp(ln_lower_part(a, b, x, one_minus_x))
    } else {
        1.0 - libm::exp(ln_lower_part(b, a, one_minus_x, x))
    }
}

/// ln B(a, b).
pub(crate) fn ln_beta(a: f64, b: f64) -> f64 {
    libm::lgamma(a) + libm::lgamma(b) - libm::lgamma(a + b)
}

/// ln I_x(a, b) where the continued fraction converges fast.
fn ln_lower_part(a: f64, b: f64, x: f64, one_minus_x: f64) -> f64 {
    let ln_front = a * libm::log(x) + b * libm::log(one_minus_x) - ln_beta(a, b) - libm::log(a);
    ln_front + libm::log(continued_fraction(a, b, x))
}

fn continued_fraction(a: f64, b: f64, x: f64) -> f64 {
    const SMALLEST: f64 = 1e-300;
    const MAX_TERMS: u32 = 100_000;
    let guard = |value: f64| if value.abs() < SMALLEST { SMALLEST } else { value };
    let mut c = 1.0;
    let mut d = 1.0 / guard(1.0 - (a + b) * x / (a + 1.0));
    let mut fraction = d;
    for term in 1..=MAX_TERMS {
        let m = f64::from(term);
        let even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
        d = 1.0 / guard(1.0 + even * d);
        c = guard(1.0 + even / c);
        fraction *= d * c;
        let odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        d = 1.0 / guard(1.0 + odd * d);
        c = guard(1.0 + odd / c);
        let change = d * c;
        fraction *= change;
        if (change - 1.0).abs() <= f64::EPSILON {
            break;
        }
    }
    fraction
}

/// The pair (x, 1 - x) with I_x(a, b) = `probability`, where `complement` = 1 - `probability` is given by itself.
///
/// Newton's method on ln I as a function of ln x (of the smaller tail), held inside a bracket that only shrinks.
pub(crate) fn inverse_incomplete_beta(a: f64, b: f64, probability: f64, complement: f64) -> (f64, f64) {
    if probability <= 0.0 {
        return (0.0, 1.0);
    }
    if complement <= 0.0 {
        return (1.0, 0.0);
    }
    if probability <= complement {
        let x = solve_lower_tail(a, b, probability);
        (x, 1.0 - x)
    } else {
        let rest = solve_lower_tail(b, a, complement);
        (1.0 - rest, rest)
    }
}

/// Solves I_x(a, b) = p for p <= 1/2.
fn solve_lower_tail(a: f64, b: f64, probability: f64) -> f64 {
    const MAX_STEPS: usize = 200;
    let ln_probability = libm::log(probability);
    let ln_normalisation = ln_beta(a, b);
    // I_x <= x^a/(a B) max(1, (1-x)^(b-1)): the bound with equality as x -> 0 starts the bracket, t = ln x.
    let mut low = ((ln_probability + libm::log(a) + ln_normalisation) / a - 1.0).min(-1.0);
    while ln_incomplete_beta(a, b, low) > ln_probability && low > -745.0 {
        low *= 2.0;
    }
    let mut high = 0.0;
    let mut t = low;
    for _ in 0..MAX_STEPS {
        let x = libm::exp(t);
        let ln_value = ln_incomplete_beta(a, b, t);
        let excess = ln_value - ln_probability;
        if excess > 0.0 {
            high = t;
        } else {
            low = t;
        }
        // d ln I/dt = x^a (1-x)^(b-1)/(B I)
        let slope = libm::exp(a * t + (b - 1.0) * libm::log1p(-x) - ln_normalisation - ln_value);
        let newton = t - excess / slope;
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if (next - t).abs() <= 2.0 * f64::EPSILON * t.abs().max(f64::MIN_POSITIVE) || next == t {
            t = next;
            break;
        }
        t = next;
    }
    libm::exp(t)
}

fn ln_incomplete_beta(a: f64, b: f64, ln_x: f64) -> f64 {
    let x = libm::exp(ln_x);
    let one_minus_x = -libm::expm1(ln_x);
    if x <= 0.0 {
        a * ln_x - ln_beta(a, b) - libm::log(a)
    } else if x < (a + 1.0) / (a + b + 2.0) {
        ln_lower_part(a, b, x, one_minus_x)
    } else {
        libm::log1p(-libm::exp(ln_lower_part(b, a, one_minus_x, x)))
    }
}

#[cfg(test)]
mod tests {
    use super::{incomplete_beta, inverse_incomplete_beta};

    #[test]
    fn analytic_closed_forms() {
        const RELATIVE_TOLERANCE: f64 = 1e-13; // the error of lgamma
        for step in 1..100 {
            let x = f64::from(step) / 100.0;
            let value = incomplete_beta(2.0, 3.0, x, 1.0 - x);
            let exact = x * x * (6.0 - 8.0 * x + 3.0 * x * x);
            assert!((value / exact - 1.0).abs() < RELATIVE_TOLERANCE, "{x} {value} {exact}");
            let arcsine = incomplete_beta(0.5, 0.5, x, 1.0 - x);
            let exact = 2.0 / core::f64::consts::PI * x.sqrt().asin();
            assert!((arcsine / exact - 1.0).abs() < RELATIVE_TOLERANCE, "{x} {arcsine} {exact}");
        }
    }

    #[test]
    fn identity_the_inverse_inverts_in_both_tails() {
        const RELATIVE_TOLERANCE: f64 = 1e-11; // shape 300 multiplies the error of ln x
        for (a, b) in [(0.5, 0.5), (2.0, 5.0), (0.2, 7.0), (30.0, 300.0), (1.0, 1.0), (3.5, 0.5)] {
            for exponent in -48_i32..=48 {
                let tail = libm::exp2(-f64::from(exponent.abs()) - 0.5);
                let (probability, complement) = if exponent < 0 { (tail, 1.0 - tail) } else { (1.0 - tail, tail) };
                let (x, rest) = inverse_incomplete_beta(a, b, probability, complement);
                let back = if exponent < 0 { incomplete_beta(a, b, x, rest) } else { incomplete_beta(b, a, rest, x) };
                assert!((back / tail - 1.0).abs() < RELATIVE_TOLERANCE, "{a} {b} {tail} {back}");
            }
        }
    }

    #[test]
    fn peer_statrs() {
        const TOLERANCE: f64 = 1e-12;
        for (a, b, x) in [(2.5, 4.5, 0.3), (12.0, 0.7, 0.9), (100.0, 90.0, 0.52)] {
            let expected = statrs::function::beta::beta_reg(a, b, x);
            assert!((incomplete_beta(a, b, x, 1.0 - x) - expected).abs() < TOLERANCE);
        }
    }
}

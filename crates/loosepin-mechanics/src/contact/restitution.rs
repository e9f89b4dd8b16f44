//! Delivered restitution: that of a free impact, a function of χ alone.

/// The restitution ε that a free impact under `F = K δⁿ (1 + χ δ̇/v0)` delivers.
///
/// Solves `χ(1 + ε) = ln((1 + χ)/(1 - χε))` (`docs/theory/contact.md`), which holds for every K, n, mass and speed.
/// χ = 0 gives 1.
pub fn delivered_restitution(damping_factor: f64) -> f64 {
    if damping_factor <= 0.0 {
        return 1.0;
    }
    bisect(0.0, f64::min(1.0, 1.0 / damping_factor), |restitution| imbalance(damping_factor, restitution))
}

/// The χ with which a free impact delivers exactly `restitution` in (0, 1].
///
/// The inverse of [`delivered_restitution`]; grows without limit as the restitution goes to zero.
pub fn damping_factor_that_delivers(restitution: f64) -> f64 {
    if restitution >= 1.0 {
        return 0.0;
    }
    bisect(0.0, 1.0 / restitution, |damping_factor| imbalance(damping_factor, restitution))
}

/// The identity as `φ(χ) - ε² φ(-χε)`, which keeps its digits for small χ: negative for χ or ε too small.
fn imbalance(damping_factor: f64, restitution: f64) -> f64 {
    log_remainder(damping_factor) - restitution * restitution * log_remainder(-damping_factor * restitution)
}

/// φ(x) = (ln(1 + x) - x)/x², by its series near zero.
pub(super) fn log_remainder(x: f64) -> f64 {
    if x.abs() < 1e-2 {
        // Σ (-1)^(k+1) xᵏ/(k + 2): the ninth term is below the last place at |x| < 0.01.
        let mut sum = 0.0;
        for k in (0..9).rev() {
            sum = -sum * x - 1.0 / (f64::from(k) + 2.0);
        }
        sum
    } else {
        (libm::log1p(x) - x) / (x * x)
    }
}

/// The sign change of `f` from negative to positive between `lower` and `upper`, to the last place.
pub(super) fn bisect(mut lower: f64, mut upper: f64, f: impl Fn(f64) -> f64) -> f64 {
    loop {
        let middle = 0.5 * (lower + upper);
        if middle <= lower || middle >= upper {
            return middle;
        }
        if f(middle) < 0.0 { lower = middle } else { upper = middle }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_of_restitution_and_its_inverse() {
        for restitution in [1e-3, 0.05, 0.31, 0.77, 0.999, 0.999_999] {
            let damping_factor = damping_factor_that_delivers(restitution);
            // Bisection to the last place; the slope dε/dχ is of order one for all but the smallest ε.
            assert!((delivered_restitution(damping_factor) - restitution).abs() < 1e-12);
            // Below 0.3 the difference 1 - χε is e^-χ and loses its digits in this plain form.
            if restitution > 0.3 {
                let left = damping_factor * (1.0 + restitution);
                let right = ((1.0 + damping_factor) / (1.0 - damping_factor * restitution)).ln();
                assert!((left - right).abs() < 1e-12, "{restitution}: {left} {right}");
            }
        }
        assert_eq!(delivered_restitution(0.0), 1.0);
        assert_eq!(damping_factor_that_delivers(1.0), 0.0);
    }
}

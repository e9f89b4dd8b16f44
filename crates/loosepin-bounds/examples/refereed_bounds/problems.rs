//! The problems, each with exact bounds by a closed form or by quadrature.

use crate::exact::{Case, NORMAL, UNIT};
use loosepin_bounds::Statistic;
use loosepin_uncertainty::{Distribution, normal_cdf};
use std::f64::consts::PI;

fn density(z: f64) -> f64 {
    libm::exp(-0.5 * z * z) / (2.0 * PI).sqrt()
}

/// E f(X), X standard normal, by the trapezoidal rule, which converges geometrically for what is analytic.
fn expected(f: impl Fn(f64) -> f64) -> f64 {
    const STEPS: i32 = 4000;
    const END: f64 = 10.0;
    let step = 2.0 * END / f64::from(STEPS);
    (0..=STEPS).map(|k| -END + step * f64::from(k)).map(|x| step * density(x) * f(x)).sum()
}

/// Least and greatest of `f` between `low` and `high`, by a grid that is refined about its extremes.
fn ends_over(low: f64, high: f64, f: impl Fn(f64) -> f64) -> [f64; 2] {
    const POINTS: u32 = 400;
    [1.0, -1.0].map(|sign| {
        let (mut from, mut to) = (low, high);
        let mut least = f64::INFINITY;
        for _ in 0..6 {
            let at = |k: u32| from + (to - from) * f64::from(k) / f64::from(POINTS);
            let best = (0..=POINTS).min_by(|&a, &b| (sign * f(at(a))).total_cmp(&(sign * f(at(b))))).expect("points");
            least = least.min(sign * f(at(best)));
            (from, to) = (at(best.saturating_sub(1)), at((best + 1).min(POINTS)));
        }
        sign * least
    })
}

/// The amplification of a damped oscillator, H(r, ζ).
fn resonance(r: f64, damping: f64) -> f64 {
    1.0 / ((1.0 - r * r).powi(2) + (2.0 * damping * r).powi(2)).sqrt()
}

/// The root of an increasing `f` between `low` and `high`.
fn root(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if f(middle) < 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// E max(0, X - c), X standard normal.
fn excess(c: f64) -> f64 {
    density(c) - c * normal_cdf(-c)
}

/// All problems.
pub fn cases() -> Vec<Case> {
    let half = (2.0 / PI).sqrt();
    let deviation_of_kink = |a: f64| (1.0 + a * a * (1.0 - half * half)).sqrt();
    let hinge = excess(1.0);
    let of_hinge = |a: f64| {
        // Var(max(0, X - 1)) and Cov(X, max(0, X - 1)) = Φ(-1).
        let square = 2.0 * normal_cdf(-1.0) - density(1.0);
        (1.0 + 2.0 * a * normal_cdf(-1.0) + a * a * (square - hinge * hinge)).sqrt()
    };
    let rare = normal_cdf(-2.7);
    let rarer = normal_cdf(-2.6);
    let above = |u: f64| (1.0 - rare) * normal_cdf(-6.5 / (1.0 + u)) + rare * normal_cdf(-2.5 / (1.0 + u));
    let spread = |u: f64| ((1.0 + u).powi(2) + 16.0 * rare * (1.0 - rare)).sqrt();
    let quantile_of_rare = |u: f64| {
        let cdf = |y: f64| (1.0 - rare) * normal_cdf(y / (1.0 + u)) + rare * normal_cdf((y - 4.0) / (1.0 + u));
        root(-30.0, 30.0, |y| cdf(y) - 0.975)
    };
    // exp(1.5 X)
    let mean_of_tail = libm::exp(0.5 * 1.5 * 1.5);
    let deviation_of_tail = mean_of_tail * libm::expm1(1.5 * 1.5).sqrt();
    let lognormal = Distribution::Lognormal { mean: mean_of_tail, standard_deviation: deviation_of_tail };
    let at_r = |r: f64, damping: f64| expected(|x| resonance(r * (1.0 + 0.01 * x), damping));
    let ten = |u: &[f64]| {
        let signs = [1.0, -0.9, 0.8, -0.7, 0.3, -0.5, 0.4, 0.6, -0.3, 0.2];
        let sum: f64 = u.iter().zip(signs).map(|(u, sign)| u * sign).sum();
        sum + u[0] * u[1] - u[2] * u[3]
    };
    let corner = move |k: u32| -> Vec<f64> { (0..10).map(|axis| f64::from(k >> axis & 1)).collect() };
    let over_corners = |of: &dyn Fn(&[f64]) -> f64| {
        (0..1024)
            .map(|k| of(&corner(k)))
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
    };
    let ten_mean = over_corners(&ten);
    let ten_above = over_corners(&|u| normal_cdf(-(3.0 - ten(u)) / (1.0 + 0.5 * u[4])));
    let folded = |y: f64, u: f64| {
        expected(|b| {
            let rest = y - u - 0.5 * b * b;
            if rest > 0.0 { 2.0 * normal_cdf(rest) - 1.0 } else { 0.0 }
        })
    };
    let folded_quantile = |u: f64| root(0.0, 40.0, |y| folded(y, u) - 0.999);
    vec![
        Case::new("x + 1e-3|x| + u", &[NORMAL], &[UNIT], |x, u| x[0] + 1e-3 * x[0].abs() + u[0])
            .with(Statistic::Mean, [1e-3 * half, 1.0 + 1e-3 * half])
            .with(Statistic::StandardDeviation, [deviation_of_kink(1e-3); 2])
            .with(Statistic::Quantile(0.975), [1.001 * 1.959_963_984_540_054, 1.0 + 1.001 * 1.959_963_984_540_054]),
        Case::new("x + 5e-4 max(0, x - 1) + u", &[NORMAL], &[UNIT], |x, u| x[0] + 5e-4 * (x[0] - 1.0).max(0.0) + u[0])
            .with(Statistic::Mean, [5e-4 * hinge, 1.0 + 5e-4 * hinge])
            .with(Statistic::StandardDeviation, [of_hinge(5e-4); 2]),
        Case::new("x + y + 4e-4|x + y| + u", &[NORMAL, NORMAL], &[UNIT], |x, u| {
            x[0] + x[1] + 4e-4 * (x[0] + x[1]).abs() + u[0]
        })
        .with(Statistic::Mean, [8e-4 / PI.sqrt(), 1.0 + 8e-4 / PI.sqrt()])
        .with(Statistic::StandardDeviation, [2.0_f64.sqrt() * deviation_of_kink(4e-4); 2]),
        Case::new("a (1 + u) + 4 [b > 2.7]", &[NORMAL, NORMAL], &[UNIT], |x, u| {
            x[0] * (1.0 + u[0]) + if x[1] > 2.7 { 4.0 } else { 0.0 }
        })
        .with(Statistic::ProbabilityAbove(6.5), [above(0.0), above(1.0)])
        .with(Statistic::StandardDeviation, [spread(0.0), spread(1.0)])
        .with(Statistic::Quantile(0.975), [quantile_of_rare(0.0), quantile_of_rare(1.0)]),
        Case::new("a (2 + sin 3u) - 3 [b < -2.6]", &[NORMAL, NORMAL], &[UNIT], |x, u| {
            x[0] * (2.0 + libm::sin(3.0 * u[0])) - if x[1] < -2.6 { 3.0 } else { 0.0 }
        })
        .with(Statistic::Mean, [-3.0 * rarer; 2])
        .with(Statistic::StandardDeviation, [2.0, 3.0].map(|s: f64| (s * s + 9.0 * rarer * (1.0 - rarer)).sqrt()))
        .with(
            Statistic::ProbabilityBelow(-8.0),
            [2.0, 3.0].map(|s: f64| (1.0 - rarer) * normal_cdf(-8.0 / s) + rarer * normal_cdf(-5.0 / s)),
        ),
        Case::new("a + b + u + 5 [c > 2.6, d > 0]", &[NORMAL; 4], &[UNIT], |x, u| {
            x[0] + x[1] + u[0] + if x[2] > 2.6 && x[3] > 0.0 { 5.0 } else { 0.0 }
        })
        .with(Statistic::Mean, UNIT.map(|u| u + 2.5 * rarer))
        .with(Statistic::StandardDeviation, [(2.0 + 12.5 * rarer * (1.0 - 0.5 * rarer)).sqrt(); 2]),
        Case::new("max(0, x + u - 1.5)", &[NORMAL], &[UNIT], |x, u| (x[0] + u[0] - 1.5).max(0.0))
            .with(Statistic::ProbabilityAbove(0.0), [normal_cdf(-1.5), normal_cdf(-0.5)])
            .with(Statistic::Mean, [excess(1.5), excess(0.5)]),
        Case::new("max(0, x + u - 1.5), inner 1024", &[NORMAL], &[UNIT], |x, u| (x[0] + u[0] - 1.5).max(0.0))
            .with(Statistic::ProbabilityAbove(0.0), [normal_cdf(-1.5), normal_cdf(-0.5)])
            .with_inner(1024),
        Case::new("|a| + b²/2 + u", &[NORMAL, NORMAL], &[UNIT], |x, u| x[0].abs() + 0.5 * x[1] * x[1] + u[0])
            .with(Statistic::Quantile(0.999), [folded_quantile(0.0), folded_quantile(1.0)])
            .with(Statistic::ProbabilityAbove(12.0), [1.0 - folded(12.0, 0.0), 1.0 - folded(12.0, 1.0)]),
        Case::new("max(a, b) + u", &[NORMAL, NORMAL], &[UNIT], |x, u| x[0].max(x[1]) + u[0])
            .with(Statistic::Quantile(0.999), UNIT.map(|u| u + root(0.0, 9.0, |y| normal_cdf(y).powi(2) - 0.999)))
            .with(Statistic::ProbabilityAbove(5.0), UNIT.map(|u| 1.0 - normal_cdf(5.0 - u).powi(2))),
        Case::new("u times lognormal, sigma 1.5", &[lognormal], &[[1.0, 2.0]], |x, u| u[0] * x[0])
            .with(Statistic::Mean, [mean_of_tail, 2.0 * mean_of_tail])
            .with(Statistic::StandardDeviation, [deviation_of_tail, 2.0 * deviation_of_tail]),
        Case::new("a peak of width 0.03 in [-1, 1]^4", &[NORMAL], &[[-1.0, 1.0]; 4], |x, u| {
            let square: f64 = u.iter().zip([0.31, -0.47, 0.22, 0.63]).map(|(u, at)| (u - at) * (u - at)).sum();
            0.2 * x[0] + libm::exp(-square / (0.03 * 0.03))
        })
        .with(Statistic::Mean, UNIT),
        Case::new("resonance in r", &[NORMAL], &[[0.7, 1.4], [0.01, 0.05]], |x, u| {
            resonance(u[0] * (1.0 + 0.01 * x[0]), u[1])
        })
        .with(Statistic::Mean, [at_r(1.4, 0.05), ends_over(0.9, 1.1, |r| at_r(r, 0.01))[1]]),
        Case::new("(1 + 0.05 x) H", &[NORMAL], &[[0.5, 1.6], [0.02, 0.1]], |x, u| {
            (1.0 + 0.05 * x[0]) * resonance(u[0], u[1])
        })
        .with(Statistic::Mean, [resonance(1.6, 0.1), 1.0 / (0.04 * (1.0_f64 - 0.0004).sqrt())]),
        Case::new("ten unknowns", &[NORMAL], &[UNIT; 10], move |x, u| ten(u) + (1.0 + 0.5 * u[4]) * x[0])
            .with(Statistic::Mean, ten_mean)
            .with(Statistic::ProbabilityAbove(3.0), ten_above),
        Case::new("product of eight", &[NORMAL], &[[-1.0, 1.0]; 8], |x, u| u.iter().product::<f64>() + 0.2 * x[0])
            .with(Statistic::Mean, [-1.0, 1.0]),
        Case::new("tanh((u + v - 1)/0.05)", &[NORMAL], &[UNIT; 2], |x, u| {
            libm::tanh((u[0] + u[1] - 1.0) / 0.05) + 0.1 * x[0]
        })
        .with(Statistic::Mean, [-libm::tanh(20.0), libm::tanh(20.0)]),
        Case::new("sin 3u + 0.05 sin 1000u", &[NORMAL], &[UNIT], |x, u| {
            libm::sin(3.0 * u[0]) + 0.05 * libm::sin(1000.0 * u[0]) + 0.2 * x[0]
        })
        .with(Statistic::Mean, fast_ripple()),
    ]
}

/// Ends of sin 3u + 0.05 sin 1000u over [0, 1].
fn fast_ripple() -> [f64; 2] {
    let at = |u: f64| libm::sin(3.0 * u) + 0.05 * libm::sin(1000.0 * u);
    let ends = (0..500).map(|k| ends_over(f64::from(k) / 500.0, f64::from(k + 1) / 500.0, at));
    ends.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], own| [low.min(own[0]), high.max(own[1])])
}

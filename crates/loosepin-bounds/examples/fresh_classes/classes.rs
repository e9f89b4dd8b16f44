//! The classes, each with the problem that a draw makes. Exact ends by monotony, at corners, or by closed forms; x, y standard normal, u in their
//! intervals.

use crate::draw::Draw;
use crate::exact::Exact;
use crate::problem::{Problem, Shared};
use loosepin_bounds::Statistic;
use loosepin_uncertainty::{normal_cdf, normal_quantile};
use std::f64::consts::TAU;
use std::sync::Arc;

/// Name, and what draws one.
pub type Class = (&'static str, fn(&mut Draw) -> Problem);

pub const CLASSES: [Class; 11] = [
    ("multiplicative", multiplicative),
    ("multilinear", multilinear),
    ("resonance", resonance),
    ("near-singular ratio", ratio),
    ("bifurcation", bifurcation),
    ("plateau", plateau),
    ("atom", atom),
    ("rare event", rare_event),
    ("extreme statistic", extreme),
    ("offset 1e9", offset),
    ("aliasing", aliasing),
];

const SIGMA: f64 = 1.959_963_984_540_054;

fn ends_of(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
}

/// The corners of the unit box.
fn corners(dimensions: usize) -> impl Iterator<Item = Vec<f64>> {
    (0..1_u32 << dimensions).map(move |k| (0..dimensions).map(|axis| f64::from(k >> axis & 1)).collect())
}

/// Y = m(u) + s(u) x, where m, s and (m - L)/s have their extremes among `candidates`.
fn linear_in_x(
    dimensions: usize,
    m: Shared,
    s: Shared,
    candidates: &[Vec<f64>],
    limit: f64,
    magnitude: f64,
) -> Problem {
    let over = |of: &dyn Fn(&[f64]) -> f64| ends_of(candidates.iter().map(|u| of(u)));
    let location_ends = over(&|u| m(u));
    let exact = vec![
        Exact { statistic: Statistic::Mean, ends: location_ends },
        Exact { statistic: Statistic::StandardDeviation, ends: over(&|u| s(u)) },
        Exact { statistic: Statistic::Quantile(0.975), ends: over(&|u| m(u) + SIGMA * s(u)) },
        Exact { statistic: Statistic::ProbabilityAbove(limit), ends: over(&|u| normal_cdf((m(u) - limit) / s(u))) },
    ];
    let scatter = candidates.iter().map(|u| s(u)).fold(0.0, f64::max);
    let location = (m.clone(), location_ends);
    let response = move |x: &[f64], u: &[f64]| m(u) + s(u) * x[0];
    Problem::new([1, dimensions], location, scatter, response, exact).with_magnitude(magnitude)
}

/// A limit that the median passes somewhere: between the ends of m, and a little beyond.
fn limit(draw: &mut Draw, m: &Shared, candidates: &[Vec<f64>], scatter: f64) -> f64 {
    let [low, high] = ends_of(candidates.iter().map(|u| m(u)));
    draw.between(low - 0.5 * scatter, high + 0.5 * scatter)
}

/// Π (1 + a_i u_i), a_i in (-0.8, 2), of up to ten unknown numbers.
fn multiplicative(draw: &mut Draw) -> Problem {
    let dimensions = 2 + draw.below(9);
    let factors: Vec<f64> = (0..dimensions).map(|_| draw.between(-0.8, 2.0)).collect();
    let m: Shared = Arc::new(move |u| u.iter().zip(&factors).map(|(u, a)| 1.0 + a * u).product());
    with_linear_scatter(draw, dimensions, m)
}

/// Σ b_i u_i + Σ c_ij u_i u_j with some of the products, of up to ten unknown numbers.
fn multilinear(draw: &mut Draw) -> Problem {
    let dimensions = 2 + draw.below(9);
    let m = bilinear(draw, dimensions);
    with_linear_scatter(draw, dimensions, m)
}

fn bilinear(draw: &mut Draw, dimensions: usize) -> Shared {
    let slopes: Vec<f64> = (0..dimensions).map(|_| draw.between(-1.0, 1.0)).collect();
    let products: Vec<(usize, usize, f64)> = (0..dimensions)
        .map(|i| (i, draw.below(dimensions), draw.between(-1.5, 1.5)))
        .filter(|(i, j, _)| i != j)
        .collect();
    Arc::new(move |u| {
        let linear: f64 = u.iter().zip(&slopes).map(|(u, b)| b * u).sum();
        linear + products.iter().map(|(i, j, c)| c * u[*i] * u[*j]).sum::<f64>()
    })
}

/// m with its extremes at corners, and a scatter that is linear in one unknown number.
fn with_linear_scatter(draw: &mut Draw, dimensions: usize, m: Shared) -> Problem {
    let all: Vec<Vec<f64>> = corners(dimensions).collect();
    let [low, high] = ends_of(all.iter().map(|u| m(u)));
    let (least, axis) = (draw.of_size(0.02, 0.5) * (high - low), draw.below(dimensions));
    let growth = draw.between(0.0, 1.5);
    let s: Shared = Arc::new(move |u| least * (1.0 + growth * u[axis]));
    let limit = limit(draw, &m, &all, least);
    linear_in_x(dimensions, m, s, &all, limit, high.abs().max(low.abs()))
}

/// Amplification of a damped oscillator over its frequency ratio and its damping.
fn resonance(draw: &mut Draw) -> Problem {
    let (from, to) = (draw.between(0.3, 0.9), draw.between(1.1, 2.0));
    let least = draw.of_size(0.02, 0.15);
    let most = least * draw.between(1.2, 4.0);
    let h = |r: f64, damping: f64| 1.0 / ((1.0 - r * r).powi(2) + (2.0 * damping * r).powi(2)).sqrt();
    let m: Shared = Arc::new(move |u| h(from + (to - from) * u[0], least + (most - least) * u[1]));
    let peak = |damping: f64| (((1.0 - 2.0 * damping * damping).sqrt() - from) / (to - from)).clamp(0.0, 1.0);
    // It falls with the damping; over the frequency it has one maximum.
    let all = vec![vec![peak(least), 0.0], vec![0.0, 1.0], vec![1.0, 1.0], vec![0.0, 0.0], vec![1.0, 0.0]];
    let scatter = draw.of_size(0.01, 0.3) * h(1.0, least);
    let s: Shared = Arc::new(move |_| scatter);
    let limit = limit(draw, &m, &all, scatter);
    linear_in_x(2, m, s, &all, limit, h(1.0, least))
}

/// (1 + a Σ u_i)/(d + Σ u_j), d down to 0.05.
fn ratio(draw: &mut Draw) -> Problem {
    let dimensions = 2 + draw.below(3);
    let above = 1 + draw.below(dimensions - 1);
    let (a, least) = (draw.between(0.1, 1.0), draw.of_size(0.05, 1.0));
    let m: Shared =
        Arc::new(move |u| (1.0 + a * u[..above].iter().sum::<f64>()) / (least + u[above..].iter().sum::<f64>()));
    let all: Vec<Vec<f64>> = corners(dimensions).collect();
    let [low, high] = ends_of(all.iter().map(|u| m(u)));
    let scatter = draw.of_size(0.02, 0.5) * (high - low);
    let s: Shared = Arc::new(move |_| scatter);
    let limit = limit(draw, &m, &all, scatter);
    linear_in_x(dimensions, m, s, &all, limit, high)
}

/// Y = ±√max(0, λ - λ0) + s y, either branch by x: the amplitude grows with λ and falls with λ0.
fn bifurcation(draw: &mut Draw) -> Problem {
    let (from, to) = (draw.between(0.0, 0.6), draw.between(0.3, 1.0));
    let amplitude = move |u: &[f64]| (u[0] * 1.5 - from - (to - from).abs() * u[1]).max(0.0).sqrt();
    let all: Vec<Vec<f64>> = corners(2).collect();
    let [low, high] = ends_of(all.iter().map(|u| amplitude(u)));
    let (share, scatter) = (draw.between(0.05, 0.5), draw.of_size(0.02, 0.3) * (high - low).max(0.1));
    let threshold = normal_quantile(share);
    // Below the threshold the lower branch.
    let mean = |a: f64| (1.0 - 2.0 * share) * a;
    let deviation = |a: f64| (4.0 * share * (1.0 - share) * a * a + scatter * scatter).sqrt();
    let limit = draw.between(0.0, high + scatter);
    let above = |a: f64| (1.0 - share) * normal_cdf((a - limit) / scatter) + share * normal_cdf((-a - limit) / scatter);
    // Of a P above a limit at 0 or more: it grows with a as the upper branch does more than the lower one falls where its share is no larger.
    let ends = |of: &dyn Fn(f64) -> f64| ends_of([low, high].into_iter().map(of));
    let exact = vec![
        Exact { statistic: Statistic::Mean, ends: ends(&mean) },
        Exact { statistic: Statistic::StandardDeviation, ends: ends(&deviation) },
        Exact { statistic: Statistic::ProbabilityAbove(limit), ends: ends(&above) },
    ];
    let response = move |x: &[f64], u: &[f64]| {
        let a = amplitude(u);
        (if x[0] < threshold { -a } else { a }) + scatter * x[1]
    };
    let location: Shared = Arc::new(amplitude);
    Problem::new([2, 2], (location, [low, high]), scatter, response, exact).with_magnitude(1.0)
}

/// Flat at both ends: tanh of a sum over a width.
fn plateau(draw: &mut Draw) -> Problem {
    let dimensions = 1 + draw.below(4);
    let (centre, width) = (draw.between(0.2, 0.8) * dimensions as f64, draw.of_size(0.03, 0.3));
    let m: Shared = Arc::new(move |u| libm::tanh((u.iter().sum::<f64>() - centre) / width));
    let all: Vec<Vec<f64>> = corners(dimensions).collect();
    let scatter = draw.of_size(0.02, 0.5);
    let s: Shared = Arc::new(move |_| scatter);
    let limit = limit(draw, &m, &all, scatter);
    linear_in_x(dimensions, m, s, &all, limit, 1.0)
}

/// Y = max(0, m(u) + x): rests at 0.
fn atom(draw: &mut Draw) -> Problem {
    let dimensions = 1 + draw.below(4);
    let slopes: Vec<f64> = (0..dimensions).map(|_| draw.between(-1.0, 1.0)).collect();
    let offset = draw.between(-2.0, 0.5);
    let m: Shared = Arc::new(move |u| offset + u.iter().zip(&slopes).map(|(u, b)| b * u).sum::<f64>());
    let all: Vec<Vec<f64>> = corners(dimensions).collect();
    let location_ends = ends_of(all.iter().map(|u| m(u)));
    let density = |z: f64| libm::exp(-0.5 * z * z) / TAU.sqrt();
    // E max(0, m + x) and its square.
    let mean = move |m: f64| density(m) + m * normal_cdf(m);
    let deviation = move |m: f64| ((1.0 + m * m) * normal_cdf(m) + m * density(m) - mean(m).powi(2)).sqrt();
    let ends = |of: &dyn Fn(f64) -> f64| location_ends.map(of);
    let exact = vec![
        Exact { statistic: Statistic::Mean, ends: ends(&mean) },
        Exact { statistic: Statistic::StandardDeviation, ends: ends(&deviation) },
        Exact { statistic: Statistic::ProbabilityAbove(0.0), ends: ends(&normal_cdf) },
        Exact { statistic: Statistic::ProbabilityAbove(1.0), ends: ends(&|m| normal_cdf(m - 1.0)) },
    ];
    let location = (m.clone(), location_ends);
    let response = move |x: &[f64], u: &[f64]| (m(u) + x[0]).max(0.0);
    Problem::new([1, dimensions], location, 1.0, response, exact).with_magnitude(1.0)
}

/// Y = m(u) + x + D where y is beyond z: in 0.1 to 2 % of the mechanisms.
fn rare_event(draw: &mut Draw) -> Problem {
    let dimensions = 1 + draw.below(3);
    let m = bilinear(draw, dimensions);
    let (rare, jump) = (draw.of_size(1e-3, 0.02), draw.sign() * draw.between(2.0, 6.0));
    let threshold = -normal_quantile(rare);
    let all: Vec<Vec<f64>> = corners(dimensions).collect();
    let location_ends = ends_of(all.iter().map(|u| m(u)));
    let far = jump.signum() * (jump.abs() + location_ends[1].abs().max(location_ends[0].abs()));
    let beyond = |m: f64| {
        let of = |at: f64| if far > 0.0 { normal_cdf(at - far) } else { normal_cdf(far - at) };
        (1.0 - rare) * of(m) + rare * of(m + jump)
    };
    let of_ends = location_ends.map(beyond);
    let statistic = if far > 0.0 { Statistic::ProbabilityAbove(far) } else { Statistic::ProbabilityBelow(far) };
    let exact = vec![
        Exact { statistic: Statistic::Mean, ends: location_ends.map(|m| m + rare * jump) },
        Exact { statistic: Statistic::StandardDeviation, ends: [(1.0 + rare * (1.0 - rare) * jump * jump).sqrt(); 2] },
        Exact { statistic, ends: ends_of(of_ends.into_iter()) },
    ];
    let location = (m.clone(), location_ends);
    let response = move |x: &[f64], u: &[f64]| m(u) + x[0] + if x[1] > threshold { jump } else { 0.0 };
    Problem { rarest: rare, ..Problem::new([2, dimensions], location, 1.0, response, exact) }
}

/// Far quantiles and small probabilities of m(u) + s x, or of m(u) + s |x|, which is not smooth.
fn extreme(draw: &mut Draw) -> Problem {
    let dimensions = 1 + draw.below(4);
    let m = bilinear(draw, dimensions);
    let (scatter, is_magnitude) = (draw.of_size(0.05, 1.0), draw.chance(0.5));
    let all: Vec<Vec<f64>> = corners(dimensions).collect();
    let location_ends = ends_of(all.iter().map(|u| m(u)));
    let share = if is_magnitude { 0.5 } else { 1.0 };
    let quantile = |tail: f64| -normal_quantile(share * tail) * scatter;
    let far = location_ends[1] + quantile(draw.of_size(1e-6, 1e-3));
    let above = |m: f64| normal_cdf((m - far) / scatter) / share;
    let exact = vec![
        Exact { statistic: Statistic::Quantile(0.999), ends: location_ends.map(|m| m + quantile(1e-3)) },
        Exact { statistic: Statistic::Quantile(0.9999), ends: location_ends.map(|m| m + quantile(1e-4)) },
        Exact { statistic: Statistic::ProbabilityAbove(far), ends: location_ends.map(above) },
    ];
    let location = (m.clone(), location_ends);
    let response = move |x: &[f64], u: &[f64]| m(u) + scatter * if is_magnitude { x[0].abs() } else { x[0] };
    Problem::new([1, dimensions], location, scatter, response, exact)
}

/// 10⁹ beside all that differs.
fn offset(draw: &mut Draw) -> Problem {
    let dimensions = 1 + draw.below(4);
    let m = bilinear(draw, dimensions);
    let size = draw.of_size(0.1, 1e3);
    let shifted: Shared = Arc::new(move |u| 1e9 + size * m(u));
    with_linear_scatter(draw, dimensions, shifted)
}

/// A line and a wave of one to sixty turns over the box.
fn aliasing(draw: &mut Draw) -> Problem {
    let (slope, amplitude) = (draw.between(-1.0, 1.0), draw.of_size(0.05, 1.0));
    let (turns, phase) = (draw.of_size(1.0, 60.0), draw.between(0.0, TAU));
    let m: Shared = Arc::new(move |u| slope * u[0] + amplitude * libm::sin(TAU * turns * u[0] + phase));
    // m' = 0 where the cosine is -slope/(2π turns amplitude), and both ends.
    let cosine = -slope / (TAU * turns * amplitude);
    let mut all = vec![vec![0.0], vec![1.0]];
    if cosine.abs() <= 1.0 {
        for sign in [1.0, -1.0] {
            let first = (sign * libm::acos(cosine) - phase) / (TAU * turns);
            let from = (-first * turns).ceil() as i64;
            let at = (from..from + turns.ceil() as i64 + 1).map(|k| first + k as f64 / turns);
            all.extend(at.filter(|u| (0.0..=1.0).contains(u)).map(|u| vec![u]));
        }
    }
    let scatter = draw.of_size(0.02, 0.3) * (amplitude + slope.abs());
    let s: Shared = Arc::new(move |_| scatter);
    let limit = limit(draw, &m, &all, scatter);
    linear_in_x(1, m, s, &all, limit, 2.0)
}

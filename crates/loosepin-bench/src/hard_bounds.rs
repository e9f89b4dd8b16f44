//! Responses with known bounds on which the search or the sampling error once failed: too narrow, or far too wide. The search is developed
//! on them, so they prove less than problems that are drawn afresh.

use loosepin::bounds::Statistic;
use loosepin::uncertainty::{Distribution, hash, normal, normal_cdf};

use super::known_bounds::extremes;
use super::known_case::KnownCase;

/// All of them.
pub fn hard() -> Vec<KnownCase> {
    let narrow = [(0.015, 1), (0.0075, 1), (0.06, 2), (0.04, 2), (0.15, 3), (0.1, 3)];
    let narrow = narrow.into_iter().map(|(width, dimensions)| narrow_hill(width, dimensions));
    let in_u = [twin_hills(), ripple(), step(), chaotic()];
    let in_x =
        [heavy_tail(), rare_branch(), discrete(), discrete_absolute(), absolute(), two_peaks(), greater_of_two()];
    let with_mixture = |case: KnownCase| KnownCase { compared_columns: vec![0], ..case };
    narrow.chain(in_u).chain(in_x).map(with_mixture).collect()
}

/// exp(-|u - centre|²/width²).
fn hill(u: &[f64], centre: &[f64], width: f64) -> f64 {
    let square: f64 = u.iter().zip(centre).map(|(u, c)| (u - c) * (u - c)).sum();
    libm::exp(-square / (width * width))
}

/// Statistics of m(u) + deviation · X where m has these extremes.
fn normal_around((low, high): (f64, f64), deviation: f64) -> Vec<(Statistic, (f64, f64))> {
    let quantile = 1.959_963_984_540_054 * deviation;
    vec![
        (Statistic::Mean, (low, high)),
        (Statistic::StandardDeviation, (deviation, deviation)),
        (Statistic::Quantile(0.975), (low + quantile, high + quantile)),
    ]
}

/// A hill between the points of the search, on a slope that a few points show exactly.
fn narrow_hill(width: f64, dimensions: usize) -> KnownCase {
    const TOP: [f64; 3] = [0.37, 0.62, 0.44];
    /// Widths beside the top in which the greatest value is sought.
    const BESIDE: f64 = 3.0;
    let mean = move |u: &[f64]| 0.3 * u.iter().sum::<f64>() / dimensions as f64 + hill(u, &TOP[..dimensions], width);
    let beside: Vec<(f64, f64)> =
        TOP[..dimensions].iter().map(|top| (top - BESIDE * width, top + BESIDE * width)).collect();
    let (_, greatest) = extremes(&mean, &beside);
    // The slope alone: its least value is at the corner 0, where the hill has ended.
    KnownCase::new(
        &format!("a hill {width} wide, {dimensions} intervals"),
        &vec![(0.0, 1.0); dimensions],
        normal_around((mean(&vec![0.0; dimensions]), greatest), 0.1),
        move |x, u| 0.1 * x[0] + mean(u),
    )
}

/// Two hills far apart, nearly as high.
fn twin_hills() -> KnownCase {
    let mean = |u: &[f64]| hill(u, &[0.15, 0.2], 0.15) + 1.003 * hill(u, &[0.83, 0.77], 0.1);
    let statistics = normal_around(extremes(&mean, &[(0.0, 1.0); 2]), 0.1);
    KnownCase::new("twin hills", &[(0.0, 1.0); 2], statistics, move |x, u| 0.1 * x[0] + mean(u))
}

/// A fast ripple of u alone.
fn ripple() -> KnownCase {
    /// A turn of the ripple has 600 of them.
    const POINTS: usize = 100_000;
    let mean = |u: f64| libm::sin(3.0 * u) + 0.05 * libm::sin(1e3 * u);
    // By a grid, then by a second one between the neighbours of its best point.
    let greatest = |sign: f64| {
        let best = |from: f64, to: f64| {
            let at = |point: usize| from + (to - from) * point as f64 / POINTS as f64;
            let at_best = (0..=POINTS).map(at).max_by(|a, b| (sign * mean(*a)).total_cmp(&(sign * mean(*b))));
            at_best.unwrap_or(from)
        };
        let coarse = best(0.0, 1.0);
        let step = 1.0 / POINTS as f64;
        mean(best((coarse - step).max(0.0), (coarse + step).min(1.0)))
    };
    let statistics = normal_around((greatest(-1.0), greatest(1.0)), 0.2);
    KnownCase::new("a fast ripple", &[(0.0, 1.0)], statistics, move |x, u| mean(u[0]) + 0.2 * x[0])
}

/// A step down on a slope: the mean comes as near as one likes to its least value.
fn step() -> KnownCase {
    const EDGE: f64 = 0.6371;
    const LIMIT: f64 = 0.5;
    let (low, high) = (EDGE - 2.0, EDGE);
    let above = |mean: f64| normal_cdf((mean - LIMIT) / 0.1);
    let mut statistics = normal_around((low, high), 0.1);
    statistics.push((Statistic::ProbabilityAbove(LIMIT), (above(low), above(high))));
    KnownCase::new("a step on a slope", &[(0.0, 1.0)], statistics, |x, u| {
        0.1 * x[0] + u[0] - if u[0] > EDGE { 2.0 } else { 0.0 }
    })
}

/// 0.5 u1 + 0.6 X + 0.8 × (standard normal noise that any change of X or u draws anew), as a chaotic motion would have it.
fn chaotic() -> KnownCase {
    let above = |mean: f64| normal_cdf(mean - 2.0);
    let mut statistics = normal_around((0.0, 0.5), 1.0);
    statistics.push((Statistic::Quantile(0.5), (0.0, 0.5)));
    statistics.push((Statistic::ProbabilityAbove(2.0), (above(0.0), above(0.5))));
    KnownCase::new("chaotic noise", &[(0.0, 1.0); 2], statistics, |x, u| {
        let noise = normal(hash(x[0].to_bits(), u[0].to_bits()), u[1].to_bits());
        0.5 * u[0] + 0.6 * x[0] + 0.8 * noise
    })
}

/// u times a lognormal number.
fn heavy_tail() -> KnownCase {
    const SIGMA: f64 = 1.5;
    const U: (f64, f64) = (0.5, 1.5);
    let mean = libm::exp(0.5 * SIGMA * SIGMA);
    let deviation = mean * libm::expm1(SIGMA * SIGMA).sqrt();
    let scaled = |value: f64| (U.0 * value, U.1 * value);
    KnownCase {
        random: vec![Distribution::Lognormal { mean, standard_deviation: deviation }],
        ..KnownCase::new(
            "u times a lognormal number",
            &[U],
            vec![
                (Statistic::Mean, scaled(mean)),
                (Statistic::StandardDeviation, scaled(deviation)),
                (Statistic::Quantile(0.975), scaled(libm::exp(SIGMA * 1.959_963_984_540_054))),
            ],
            |x, u| u[0] * x[0],
        )
    }
}

/// Two standard normal inputs.
fn two_inputs(case: KnownCase) -> KnownCase {
    let random = vec![Distribution::Normal { mean: 0.0, standard_deviation: 1.0 }; 2];
    KnownCase { random, ..case }
}

/// Four more in one run of 290.
fn rare_branch() -> KnownCase {
    const THRESHOLD: f64 = 2.7;
    const JUMP: f64 = 4.0;
    let probability = normal_cdf(-THRESHOLD);
    let mean = JUMP * probability;
    let deviation = |scale: f64| (scale * scale + JUMP * JUMP * probability * (1.0 - probability)).sqrt();
    let statistics =
        vec![(Statistic::Mean, (mean, mean)), (Statistic::StandardDeviation, (deviation(1.0), deviation(2.0)))];
    two_inputs(KnownCase::new("a rare branch", &[(0.0, 1.0)], statistics, |x, u| {
        x[0] * (1.0 + u[0]) + if x[1] > THRESHOLD { JUMP } else { 0.0 }
    }))
}

const VALUES: [f64; 3] = [-1.0, 0.2, 1.7];
const PROBABILITIES: [f64; 3] = [0.3, 0.5, 0.2];

/// Mean and deviation of a function of a discrete number.
fn of_discrete(of: impl Fn(f64) -> f64) -> [f64; 2] {
    let expected = |of: &dyn Fn(f64) -> f64| VALUES.iter().zip(PROBABILITIES).map(|(x, p)| p * of(*x)).sum::<f64>();
    let mean = expected(&|x| of(x));
    [mean, expected(&|x| (of(x) - mean) * (of(x) - mean)).sqrt()]
}

fn discrete_input(case: KnownCase) -> KnownCase {
    let (values, probabilities) = (VALUES.to_vec(), PROBABILITIES.to_vec());
    KnownCase { random: vec![Distribution::Discrete { values, probabilities }], ..case }
}

/// u + (1 + u) X of a discrete X.
fn discrete() -> KnownCase {
    let of = |u: f64| of_discrete(|x| u + (1.0 + u) * x);
    let ([low_mean, low], [high_mean, high]) = (of(0.0), of(1.0));
    let statistics = vec![(Statistic::Mean, (low_mean, high_mean)), (Statistic::StandardDeviation, (low, high))];
    discrete_input(KnownCase::new("a discrete number", &[(0.0, 1.0)], statistics, |x, u| u[0] + (1.0 + u[0]) * x[0]))
}

/// |X - u| of a discrete X: between two of its values the mean is a line, the variance a parabola.
fn discrete_absolute() -> KnownCase {
    const U: (f64, f64) = (-0.5, 1.0);
    let of = |part: usize| extremes(&move |u: &[f64]| of_discrete(|x| (x - u[0]).abs())[part], &[U]);
    let statistics = vec![(Statistic::Mean, of(0)), (Statistic::StandardDeviation, of(1))];
    discrete_input(KnownCase::new("distance to a discrete number", &[U], statistics, |x, u| (x[0] - u[0]).abs()))
}

/// The number at which a rising function reaches `wanted`.
fn root_of_increasing(wanted: f64, rising: impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (-20.0, 20.0);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if rising(middle) < wanted { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// |X - u|, folded normal: mean, deviation and quantiles change with |u| in one direction all the way.
fn absolute() -> KnownCase {
    const U: (f64, f64) = (-0.4, 1.3);
    let mean = |u: f64| std::f64::consts::FRAC_2_PI.sqrt() * libm::exp(-0.5 * u * u) + u * (1.0 - 2.0 * normal_cdf(-u));
    let deviation = |u: f64| (1.0 + u * u - mean(u) * mean(u)).sqrt();
    let quantile = |p: f64, u: f64| root_of_increasing(p, |y| normal_cdf(u + y) - normal_cdf(u - y));
    let mut statistics = vec![
        (Statistic::Mean, (mean(0.0), mean(U.1))),
        (Statistic::StandardDeviation, (deviation(0.0), deviation(U.1))),
    ];
    for p in [0.5, 0.975] {
        statistics.push((Statistic::Quantile(p), (quantile(p, 0.0), quantile(p, U.1))));
    }
    KnownCase::new("distance to a normal number", &[U], statistics, |x, u| (x[0] - u[0]).abs())
}

/// Two peaks, the median between them.
fn two_peaks() -> KnownCase {
    let lower_share = normal_cdf(0.1);
    let below = |y: f64| lower_share * normal_cdf((y + 2.0) / 0.5) + (1.0 - lower_share) * normal_cdf((y - 2.0) / 0.5);
    let statistics = [0.025, 0.5, 0.975].map(|p| {
        let quantile = root_of_increasing(p, below);
        (Statistic::Quantile(p), (quantile, quantile + 1.0))
    });
    two_inputs(KnownCase::new("two peaks", &[(0.0, 1.0)], statistics.to_vec(), |x, u| {
        u[0] + 0.5 * x[0] + if x[1] > 0.1 { 2.0 } else { -2.0 }
    }))
}

/// The greater of two numbers, beyond a limit in one run of ten thousand.
fn greater_of_two() -> KnownCase {
    const LIMIT: f64 = 4.4;
    let beyond = |limit: f64, u: f64| {
        let one = normal_cdf(0.5 * u - limit);
        2.0 * one - one * one
    };
    let statistics =
        [LIMIT, 2.5].map(|limit| (Statistic::ProbabilityAbove(limit), (beyond(limit, 0.0), beyond(limit, 1.0))));
    two_inputs(KnownCase::new("the greater of two", &[(0.0, 1.0)], statistics.to_vec(), |x, u| {
        x[0].max(x[1]) + 0.5 * u[0]
    }))
}

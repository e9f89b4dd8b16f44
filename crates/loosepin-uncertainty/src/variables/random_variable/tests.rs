use super::RandomVariable;
use crate::{Distribution, DistributionError};

fn truncated(of: Distribution, lower: f64, upper: f64) -> Distribution {
    Distribution::Truncated { of: Box::new(of), lower, upper }
}

fn all_kinds() -> Vec<RandomVariable> {
    [
        Distribution::Normal { mean: 0.05, standard_deviation: 2.0e-5 },
        Distribution::TruncatedNormal { mean: 3.0, standard_deviation: 0.7, lower: 2.0, upper: 6.0 },
        Distribution::TruncatedNormal { mean: 0.0, standard_deviation: 0.3, lower: 2.0, upper: 2.5 },
        Distribution::Uniform { lower: -0.3, upper: 1.9 },
        Distribution::Lognormal { mean: 2.5, standard_deviation: 1.5 },
        Distribution::Triangular { lower: -2.0, mode: 0.5, upper: 1.0 },
        Distribution::Triangular { lower: 1.5, mode: 1.5, upper: 4.0 },
        Distribution::Beta { alpha: 2.5, beta: 0.7, lower: 4.0, upper: 9.0 },
        Distribution::Beta { alpha: 30.0, beta: 50.0, lower: -1.0, upper: 1.5 },
        Distribution::Weibull { shape: 2.3, scale: 1.7, lower: 0.4 },
        Distribution::Gamma { shape: 3.7, scale: 0.8, lower: -0.5 },
        Distribution::Gamma { shape: 2500.0, scale: 0.02, lower: 0.0 },
        Distribution::Gumbel { mode: 3.0, scale: 0.6 },
        Distribution::Exponential { mean: 2.3, lower: 0.7 },
        truncated(Distribution::Lognormal { mean: 0.85, standard_deviation: 0.2 }, f64::NEG_INFINITY, 1.0),
        truncated(Distribution::Gumbel { mode: 3.0, scale: 0.6 }, 3.5, f64::INFINITY),
        truncated(Distribution::Gamma { shape: 3.7, scale: 0.8, lower: 0.0 }, 1.0, 4.0),
    ]
    .into_iter()
    .map(|distribution| RandomVariable::try_new(distribution).unwrap())
    .collect()
}

#[test]
fn identity_the_distribution_function_undoes_the_quantile_in_both_tails() {
    // Near an end x itself is rounded: one unit in the last place of x moves the lower tail by density times that.
    const RELATIVE_TOLERANCE: f64 = 1e-9;
    const ROUNDING_OF_X: f64 = 4.0 * f64::EPSILON;
    for variable in all_kinds() {
        for exponent in 1..=40 {
            for probability in [libm::exp2(-f64::from(exponent)), 1.0 - libm::exp2(-f64::from(exponent))] {
                let x = variable.quantile(probability);
                let step = ROUNDING_OF_X * x.abs();
                let (low, high) = (variable.cdf(x - step), variable.cdf(x + step));
                let slack = RELATIVE_TOLERANCE * probability.min(1.0 - probability) + f64::EPSILON * probability;
                assert!(
                    low - slack <= probability && probability <= high + slack,
                    "{:?} {probability}",
                    variable.distribution()
                );
            }
        }
    }
}

/// Density at x inside the support, as textbooks have it.
fn density(distribution: &Distribution, x: f64) -> f64 {
    let normal = |mean: f64, deviation: f64| {
        let z = (x - mean) / deviation;
        libm::exp(-0.5 * z * z) / (core::f64::consts::TAU.sqrt() * deviation)
    };
    match *distribution {
        Distribution::Normal { mean, standard_deviation } => normal(mean, standard_deviation),
        Distribution::TruncatedNormal { mean, standard_deviation, lower, upper } => {
            let whole = Distribution::Normal { mean, standard_deviation };
            density(&truncated(whole, lower, upper), x)
        }
        Distribution::Uniform { lower, upper } => 1.0 / (upper - lower),
        Distribution::Lognormal { mean, standard_deviation } => {
            let square = libm::log1p((standard_deviation / mean).powi(2));
            let z = (libm::log(x / mean) + 0.5 * square) / square.sqrt();
            libm::exp(-0.5 * z * z) / ((core::f64::consts::TAU * square).sqrt() * x)
        }
        Distribution::Triangular { lower, mode, upper } => {
            let share = if x < mode { (x - lower) / (mode - lower) } else { (upper - x) / (upper - mode) };
            2.0 * share / (upper - lower)
        }
        Distribution::Beta { alpha, beta, lower, upper } => {
            let share = (x - lower) / (upper - lower);
            let scale = libm::lgamma(alpha + beta) - libm::lgamma(alpha) - libm::lgamma(beta);
            let powers = (alpha - 1.0) * libm::log(share) + (beta - 1.0) * libm::log1p(-share);
            libm::exp(scale + powers) / (upper - lower)
        }
        Distribution::Weibull { shape, scale, lower } => {
            let t = (x - lower) / scale;
            shape / scale * libm::pow(t, shape - 1.0) * libm::exp(-libm::pow(t, shape))
        }
        Distribution::Gamma { shape, scale, lower } => {
            let t = (x - lower) / scale;
            libm::exp((shape - 1.0) * libm::log(t) - t - libm::lgamma(shape)) / scale
        }
        Distribution::Gumbel { mode, scale } => {
            let t = (x - mode) / scale;
            libm::exp(-t - libm::exp(-t)) / scale
        }
        Distribution::Exponential { mean, lower } => libm::exp(-(x - lower) / (mean - lower)) / (mean - lower),
        Distribution::Truncated { ref of, lower, upper } => {
            let whole = RandomVariable::try_new((**of).clone()).unwrap();
            let kept = if lower > whole.mean() {
                whole.survival(lower) - whole.survival(upper)
            } else {
                whole.cdf(upper) - whole.cdf(lower)
            };
            density(of, x) / kept
        }
        Distribution::Discrete { .. } | Distribution::Empirical { .. } => panic!("no density"),
    }
}

#[test]
fn analytic_the_slope_of_the_distribution_function_is_the_density() {
    // A central difference over 1e-5 of the deviation leaves 1e-8 of the density where that rises steeply to an end (beta), and the digits
    // of the function 1e-11.
    const TOLERANCE: f64 = 1e-6; // over the inverse of the deviation, the scale of a density
    for variable in all_kinds() {
        let deviation = variable.standard_deviation();
        for probability in [0.03, 0.2, 0.47, 0.71, 0.95] {
            let x = variable.quantile(probability);
            let step = 1e-5 * deviation;
            let slope = (variable.cdf(x + step) - variable.cdf(x - step)) / (2.0 * step);
            let density = density(variable.distribution(), x);
            assert!(
                (density - slope).abs() * deviation < TOLERANCE,
                "{:?} {probability}: {density} {slope}",
                variable.distribution()
            );
        }
        for end in [variable.quantile(0.0), variable.quantile(1.0)].into_iter().filter(|end| end.is_finite()) {
            let outside = if end <= variable.mean() { end - deviation } else { end + deviation };
            let below = if end <= variable.mean() { 0.0 } else { 1.0 };
            assert_eq!(variable.cdf(outside), below, "{:?}", variable.distribution());
        }
    }
}

#[test]
fn identity_the_quantile_increases() {
    for variable in all_kinds() {
        let mut last = variable.quantile(1e-12);
        let steps = (1..2000).map(|step| f64::from(step) / 2000.0);
        for probability in
            steps.chain((11..40).rev().map(|bits| libm::exp2(-f64::from(bits))).map(|tail| 1.0 - tail).rev())
        {
            let x = variable.quantile(probability);
            assert!(x > last || probability > 0.9995, "{:?} {probability}", variable.distribution());
            last = x;
        }
    }
}

#[test]
fn identity_mean_and_deviation_are_the_integrals_of_the_quantile() {
    // Midpoint rule with 200,000 cells: the tails of the widest distribution cut the variance by about 1e-4 of itself.
    const CELLS: u32 = 200_000;
    const RELATIVE_TOLERANCE: f64 = 5e-4;
    for variable in all_kinds() {
        let (mut mean, mut square) = (0.0, 0.0);
        let centre = variable.mean();
        for cell in 0..CELLS {
            let deviation = variable.quantile((f64::from(cell) + 0.5) / f64::from(CELLS)) - centre;
            mean += deviation / f64::from(CELLS);
            square += deviation * deviation / f64::from(CELLS);
        }
        let expected = variable.standard_deviation();
        assert!(mean.abs() < RELATIVE_TOLERANCE * expected, "{:?}: mean off by {mean}", variable.distribution());
        assert!((square.sqrt() / expected - 1.0).abs() < RELATIVE_TOLERANCE, "{:?}", variable.distribution());
    }
}

#[test]
fn analytic_quantiles_in_the_tails() {
    // The closed form as x -> lower end; relative to the distance from the end.
    const RELATIVE_TOLERANCE: f64 = 1e-6;
    let triangular = RandomVariable::try_new(Distribution::Triangular { lower: 0.0, mode: 0.5, upper: 2.0 }).unwrap();
    assert!((triangular.quantile(1e-12) / 1e-6 - 1.0).abs() < RELATIVE_TOLERANCE);
    let beta = Distribution::Beta { alpha: 0.5, beta: 0.5, lower: 0.0, upper: 2.0 };
    let beta = RandomVariable::try_new(beta).unwrap();
    let arcsine = 2.0 * libm::pow(libm::sin(0.5 * core::f64::consts::PI * 1e-12), 2.0);
    assert!((beta.quantile(1e-12) / arcsine - 1.0).abs() < RELATIVE_TOLERANCE);
    // Lognormal: exp(μ + σ z) with z of the normal tables.
    let lognormal = RandomVariable::try_new(Distribution::Lognormal { mean: 2.0, standard_deviation: 1.0 }).unwrap();
    let variance = libm::log(1.25);
    let expected = libm::exp(libm::log(2.0) - 0.5 * variance + variance.sqrt() * -7.034_483_825_301_132);
    assert!((lognormal.quantile(1e-12) / expected - 1.0).abs() < RELATIVE_TOLERANCE);
}

#[test]
fn the_ends_of_the_support_are_met_exactly() {
    for variable in all_kinds() {
        if let Distribution::Uniform { lower, upper }
        | Distribution::Triangular { lower, upper, .. }
        | Distribution::Beta { lower, upper, .. }
        | Distribution::TruncatedNormal { lower, upper, .. } = *variable.distribution()
        {
            assert_eq!((variable.quantile(0.0), variable.quantile(1.0)), (lower, upper));
        }
        assert!(variable.quantile(-1e-9).is_nan() && variable.quantile(f64::NAN).is_nan());
    }
}

#[test]
fn each_broken_rule_is_told_with_its_numbers() {
    let text = |distribution| RandomVariable::try_new(distribution).unwrap_err().to_string();
    assert_eq!(
        text(Distribution::Normal { mean: 50.0, standard_deviation: -0.02 }),
        "standard deviation -0.02; must be > 0"
    );
    assert_eq!(text(Distribution::Normal { mean: f64::NAN, standard_deviation: 1.0 }), "mean NaN; must be finite");
    assert_eq!(text(Distribution::Lognormal { mean: -2.0, standard_deviation: 1.0 }), "mean -2; must be > 0");
    assert_eq!(
        text(Distribution::Uniform { lower: 2.0, upper: 2.0 }),
        "lower end 2, upper end 2; the lower end must be below the upper end"
    );
    assert_eq!(
        text(Distribution::Triangular { lower: 0.0, mode: 3.0, upper: 2.0 }),
        "mode 3; must be between the ends 0 and 2"
    );
    assert_eq!(text(Distribution::Beta { alpha: 0.0, beta: 1.0, lower: 0.0, upper: 2.0 }), "alpha 0; must be > 0");
    let error = RandomVariable::try_new(Distribution::TruncatedNormal {
        mean: 0.0,
        standard_deviation: 1.0,
        lower: 40.0,
        upper: 41.0,
    });
    assert!(matches!(error, Err(DistributionError::NothingKept { share, .. }) if share < 1e-100));
}

fn variable(distribution: Distribution) -> RandomVariable {
    RandomVariable::try_new(distribution).unwrap()
}

#[test]
fn peer_scipy() {
    // Quantiles at 1e-12, 1e-4, 0.3, 0.8, the one above which 1e-12 lies, mean and standard deviation, as printed by
    // `random_variable/peer_quantiles.py`; relative to the distance from the lower end where there is one.
    const RELATIVE_TOLERANCE: f64 = 1e-11;
    const LEVELS: [f64; 4] = [1e-12, 1e-4, 0.3, 0.8];
    let cases = [
        (
            Distribution::Weibull { shape: 0.6, scale: 2.5, lower: 0.0 },
            [2.500000000002078e-20, 5.38653560304671e-07, 0.448464094867955, 5.525824078453815],
            [631.3471629611083, 3.761438720628891, 6.612857205984295],
        ),
        (
            Distribution::Gamma { shape: 0.35, scale: 2.0, lower: 0.0 },
            [7.452809770505469e-35, 5.36368041544651e-12, 0.04694818211408607, 1.1083799889975268],
            [49.1795682382585, 0.7, 1.1832159566199232],
        ),
        (
            Distribution::Gamma { shape: 3.7, scale: 0.8, lower: -0.5 },
            [-0.4990424795540761, -0.35551202575024055, 1.5049809149493374, 3.618384150684431],
            [28.260411277564124, 2.46, 1.5388307249337076],
        ),
        (
            Distribution::Gamma { shape: 2500.0, scale: 0.02, lower: 0.0 },
            [43.28534521253303, 46.36623525457531, 49.470805448577416, 50.83961799996388],
            [57.36095601685276, 50.0, 1.0],
        ),
        (
            Distribution::Weibull { shape: 2.3, scale: 1.7, lower: 0.4 },
            [0.40001030522828895, 0.4309975898961675, 1.485887503218673, 2.4907749166409228],
            [7.596863088296356, 1.9060549973686851, 0.6944174740202466],
        ),
        (
            Distribution::Gumbel { mode: 3.0, scale: 0.6 },
            [1.0086365429784265, 1.6678039161792924, 2.8886239446825805, 3.899963992055709],
            [19.57861266955683, 3.3463293989409197, 0.7695298980971185],
        ),
        (
            Distribution::Exponential { mean: 2.3, lower: 0.7 },
            [0.7000000000016, 0.7001600080005334, 1.270679910301972, 3.2751006598945613],
            [44.90963378548568, 2.3, 1.6],
        ),
    ];
    for (distribution, quantiles, [upper, mean, deviation]) in cases {
        let variable = variable(distribution);
        let upper_z = 7.034_483_825_301_132; // Φ(-z) = 1e-12
        let found = LEVELS.map(|level| variable.quantile(level)).into_iter().zip(quantiles).chain([
            (variable.at_standard_normal(upper_z), upper),
            (variable.mean(), mean),
            (variable.standard_deviation(), deviation),
        ]);
        for (found, expected) in found {
            assert!((found / expected - 1.0).abs() < RELATIVE_TOLERANCE, "{variable:?}: {found} {expected}");
        }
    }
}

#[test]
fn analytic_a_cut_normal_distribution_is_the_same_by_both_ways() {
    const RELATIVE_TOLERANCE: f64 = 1e-12;
    const MOMENTS_TOLERANCE: f64 = 1e-10; // of the double exponential rule
    let (mean, standard_deviation, lower, upper) = (0.9, 0.08, 0.75, 1.0);
    let closed = variable(Distribution::TruncatedNormal { mean, standard_deviation, lower, upper });
    let general = variable(truncated(Distribution::Normal { mean, standard_deviation }, lower, upper));
    for step in 0..=1000 {
        let probability = f64::from(step) / 1000.0;
        let [a, b] = [&closed, &general].map(|variable| variable.quantile(probability));
        assert!((a / b - 1.0).abs() < RELATIVE_TOLERANCE, "{probability} {a} {b}");
        assert!((general.cdf(a) - probability).abs() < 1e-9);
    }
    assert!((closed.mean() / general.mean() - 1.0).abs() < MOMENTS_TOLERANCE);
    assert!((closed.standard_deviation() / general.standard_deviation() - 1.0).abs() < MOMENTS_TOLERANCE);
    assert_eq!((general.quantile(0.0), general.quantile(1.0)), (lower, upper));
}

#[test]
fn analytic_an_exponential_distribution_forgets_its_cut() {
    // What lies above a cut is the same distribution, begun there.
    const RELATIVE_TOLERANCE: f64 = 1e-12;
    let cut = variable(truncated(Distribution::Exponential { mean: 2.3, lower: 0.7 }, 5.0, f64::INFINITY));
    let shifted = variable(Distribution::Exponential { mean: 6.6, lower: 5.0 });
    for z in [-6.0, -1.5, 0.2, 3.0, 7.5] {
        assert!((cut.at_standard_normal(z) / shifted.at_standard_normal(z) - 1.0).abs() < RELATIVE_TOLERANCE, "{z}");
    }
    assert!((cut.mean() - 6.6).abs() < 1e-9 && (cut.standard_deviation() - 1.6).abs() < 1e-9);
}

#[test]
fn analytic_discrete_values() {
    const ROUND_OFF: f64 = 1e-15;
    let (values, probabilities) = (vec![0.5, -2.0, 4.0], vec![0.3, 0.45, 0.25]);
    let discrete = variable(Distribution::Discrete { values, probabilities });
    for (probability, expected) in [(0.0, -2.0), (0.449, -2.0), (0.451, 0.5), (0.749, 0.5), (0.751, 4.0), (1.0, 4.0)] {
        assert_eq!(discrete.quantile(probability), expected, "{probability}");
    }
    assert!((discrete.mean() - 0.25).abs() < ROUND_OFF);
    // 0.3 · 0.0625 + 0.45 · 5.0625 + 0.25 · 14.0625
    assert!((discrete.standard_deviation() - 5.8125_f64.sqrt()).abs() < ROUND_OFF);
    assert!((discrete.cdf(0.5) - 0.75).abs() < ROUND_OFF && discrete.cdf(-2.1) == 0.0 && discrete.survival(4.0) == 0.0);
    let cut = Distribution::Discrete { values: vec![0.5, -2.0, 4.0], probabilities: vec![0.3, 0.45, 0.25] };
    let cut = variable(truncated(cut, -1.0, 5.0));
    assert_eq!((cut.quantile(0.54), cut.quantile(0.55)), (0.5, 4.0));
}

#[test]
fn analytic_a_sample_taken_as_it_is() {
    const ROUND_OFF: f64 = 1e-15;
    let values = [0.25, 0.5, 0.5, 1.5, 2.25];
    let sample = variable(Distribution::Empirical { values: values.into() });
    // Definition 1 of Hyndman and Fan: the value with the number ⌈n p⌉.
    for (probability, expected) in
        [(0.0, 0.25), (0.19, 0.25), (0.21, 0.5), (0.59, 0.5), (0.61, 1.5), (0.81, 2.25), (1.0, 2.25)]
    {
        assert_eq!(sample.quantile(probability), expected, "{probability}");
    }
    assert!((sample.mean() - 1.0).abs() < ROUND_OFF);
    assert!((sample.standard_deviation() - 0.575_f64.sqrt()).abs() < ROUND_OFF);
    let equal_steps = (0..1000).map(|i| sample.quantile((f64::from(i) + 0.5) / 1000.0));
    assert!((equal_steps.sum::<f64>() / 1000.0 - 1.0).abs() < 1e-12);
}

#[test]
fn each_broken_rule_of_the_further_families_is_told_with_its_numbers() {
    let text = |distribution| RandomVariable::try_new(distribution).unwrap_err().to_string();
    let discrete = |values: &[f64], probabilities: &[f64]| Distribution::Discrete {
        values: values.to_vec(),
        probabilities: probabilities.to_vec(),
    };
    assert_eq!(text(Distribution::Weibull { shape: 0.0, scale: 2.0, lower: 0.5 }), "shape 0; must be > 0");
    assert_eq!(text(Distribution::Gamma { shape: 2.0, scale: -2.0, lower: 0.5 }), "scale -2; must be > 0");
    assert_eq!(text(Distribution::Gumbel { mode: f64::NAN, scale: 2.0 }), "mode NaN; must be finite");
    assert_eq!(text(Distribution::Exponential { mean: 0.5, lower: 0.5 }), "mean 0.5; must be above the lower end 0.5");
    assert_eq!(text(discrete(&[0.5, 2.0], &[0.5])), "2 values, 1 probabilities; each value needs one");
    assert_eq!(text(discrete(&[0.5, 2.0], &[0.5, 0.4])), "the probabilities sum up to 0.9; must be 1 within 1e-9");
    assert_eq!(text(discrete(&[2.0, 2.0], &[0.5, 0.5])), "the value 2 is there twice");
    let sample = |values: &[f64]| Distribution::Empirical { values: values.into() };
    assert_eq!(text(sample(&[0.5, 0.5])), "a sample of 2 without two different values; it says nothing of scatter");
    assert_eq!(text(sample(&[f64::NAN, 0.5])), "value NaN; must be finite");
    let normal = Distribution::Normal { mean: 0.5, standard_deviation: 0.1 };
    assert_eq!(
        text(truncated(normal, 9.0, f64::INFINITY)),
        "truncation to [9, inf] keeps the share 0 of a normal distribution; the share must be at least 1e-100\n\
         hint: truncate nearer to the mean, or use a uniform distribution"
    );
}

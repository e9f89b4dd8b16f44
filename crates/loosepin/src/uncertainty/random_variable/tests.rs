use super::RandomVariable;
use crate::uncertainty::{Distribution, DistributionError};

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
        "mode 3; must lie between the ends 0 and 2"
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

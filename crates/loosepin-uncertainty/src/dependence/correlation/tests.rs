use super::{CopulaError, GaussianCopula, Pair, normal_of_rank, rank_of_normal};
use crate::{Distribution, RandomVariable, ScrambledSobol};

fn pair(first: usize, second: usize, normal: f64) -> Pair {
    Pair { first, second, normal }
}

fn variables() -> Vec<RandomVariable> {
    [
        Distribution::Normal { mean: 0.05, standard_deviation: 2.0e-5 },
        Distribution::Uniform { lower: -0.3, upper: 1.9 },
        Distribution::Lognormal { mean: 2.5, standard_deviation: 1.5 },
        Distribution::Gumbel { mode: 4.0, scale: 0.7 },
    ]
    .into_iter()
    .map(|distribution| RandomVariable::try_new(distribution).unwrap())
    .collect()
}

/// Ranks of a column, counted from 0.
fn ranks(rows: &[Vec<f64>], column: usize) -> Vec<f64> {
    let mut order: Vec<usize> = (0..rows.len()).collect();
    order.sort_by(|&a, &b| rows[a][column].total_cmp(&rows[b][column]));
    let mut ranks = vec![0.0; rows.len()];
    for (rank, row) in order.into_iter().enumerate() {
        ranks[row] = rank as f64;
    }
    ranks
}

fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let (ma, mb) = (mean(a), mean(b));
    let product =
        |x: &[f64], mx: f64, y: &[f64], my: f64| -> f64 { x.iter().zip(y).map(|(x, y)| (x - mx) * (y - my)).sum() };
    product(a, ma, b, mb) / (product(a, ma, a, ma) * product(b, mb, b, mb)).sqrt()
}

#[test]
fn analytic_rank_correlations_of_samples_lie_within_their_standard_error() {
    // Kendall and Stuart: the standard error of Spearman's correlation of n independent draws is below 1/√n; the points here
    // spread more evenly. Eight seeds: 3.5 standard errors of their mean.
    const ROWS: u32 = 1024;
    const SEEDS: u64 = 8;
    let wanted = [(0, 2, 0.6), (2, 3, -0.45), (0, 3, 0.1)];
    let pairs = wanted.map(|(a, b, rank)| pair(a, b, normal_of_rank(rank))).to_vec();
    let copula = GaussianCopula::try_new(4, pairs).unwrap();
    let variables = variables();
    let mut sums = [0.0; 4];
    for seed in 0..SEEDS {
        let sobol = ScrambledSobol::try_new(seed, 4).unwrap();
        let mut point = [0.0; 4];
        let rows: Vec<Vec<f64>> = (0..ROWS)
            .map(|index| {
                sobol.write_point(0, index, &mut point);
                copula.sample(&variables, &point)
            })
            .collect();
        for ((a, b, _), sum) in wanted.iter().chain(&[(1, 2, 0.0)]).zip(&mut sums) {
            *sum += correlation(&ranks(&rows, *a), &ranks(&rows, *b)) / SEEDS as f64;
        }
    }
    let standard_error = 1.0 / f64::from(ROWS).sqrt() / (SEEDS as f64).sqrt();
    for ((_, _, rank), found) in wanted.iter().chain(&[(1, 2, 0.0)]).zip(sums) {
        assert!((found - rank).abs() < 3.5 * standard_error, "{rank} {found}");
    }
}

#[test]
fn identity_what_is_not_correlated_and_the_first_of_a_group_keep_their_bits() {
    let copula = GaussianCopula::try_new(4, vec![pair(1, 3, 0.7)]).unwrap();
    let variables = variables();
    for index in 0..200 {
        let point = [0.1, 0.3, 0.5, 0.7].map(|start| (start + f64::from(index) * 0.618) % 1.0);
        let sample = copula.sample(&variables, &point);
        for input in [0, 1, 2] {
            assert_eq!(sample[input].to_bits(), variables[input].quantile(point[input]).to_bits());
        }
    }
    let nothing = GaussianCopula::try_new(4, Vec::new()).unwrap();
    let point = [0.2, 0.9, 0.4, 0.3];
    let direct: Vec<f64> = variables.iter().zip(point).map(|(variable, p)| variable.quantile(p)).collect();
    assert_eq!(nothing.sample(&variables, &point), direct);
}

#[test]
fn identity_ranks_and_normal_correlations_are_inverse() {
    const TOLERANCE: f64 = 1e-14;
    for rank in [-0.999, -0.3, 0.05, 0.6, 0.95] {
        assert!((rank_of_normal(normal_of_rank(rank)) - rank).abs() < TOLERANCE);
    }
    // 2 sin(π/12) = (√6 - √2)/2
    assert!((normal_of_rank(0.5) - (6.0_f64.sqrt() - 2.0_f64.sqrt()) / 2.0).abs() < TOLERANCE);
}

#[test]
fn analytic_contradictions_are_found_with_their_least_eigenvalue() {
    // Three equal correlations r: eigenvalues 1 + 2 r, 1 - r, 1 - r.
    const TOLERANCE: f64 = 1e-13;
    let of = |r: f64| GaussianCopula::try_new(6, vec![pair(4, 1, r), pair(1, 3, r), pair(3, 4, r), pair(0, 2, 0.3)]);
    assert!(of(-0.499).is_ok() && of(0.999).is_ok());
    let Err(CopulaError::NotPositiveDefinite { inputs, least_eigenvalue }) = of(-0.6) else { panic!("{:?}", of(-0.6)) };
    assert_eq!(inputs, [1, 3, 4]);
    assert!((least_eigenvalue + 0.2).abs() < TOLERANCE, "{least_eigenvalue}");
    let error = |pairs: &[Pair]| GaussianCopula::try_new(3, pairs.to_vec()).unwrap_err();
    assert_eq!(error(&[pair(0, 1, 0.2), pair(1, 0, 0.3)]), CopulaError::PairTwice { first: 1, second: 0 });
    assert_eq!(error(&[pair(2, 2, 0.2)]), CopulaError::NoSuchPair { first: 2, second: 2, inputs: 3 });
    assert_eq!(error(&[pair(0, 1, -1.0)]), CopulaError::OutOfRange { normal: -1.0 });
}

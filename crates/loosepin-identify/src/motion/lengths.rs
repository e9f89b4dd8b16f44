//! Mechanisms that agree with the measurement: the random inputs, given the measurement.
//!
//! ```text
//! p(x, u | y) ∝ p(y | f(x, u)) p(x) p(u)
//! ```
//!
//! u is drawn evenly from the cells of the consistent set and those beside them, x from the distributions of the study, and each pair is
//! weighed by the likelihood of its features f. Rows are drawn from the pairs by systematic resampling (G. Kitagawa, "Monte Carlo filter
//! and smoother for non-Gaussian nonlinear state space models", Journal of Computational and Graphical Statistics 5 (1996) 1-25). The
//! pairs count as (Σ w)²/Σ w² draws from p(x, u | y) (A. Kong, J. S. Liu, W. H. Wong, "Sequential imputations and Bayesian missing data
//! problems", Journal of the American Statistical Association 89 (1994) 278-288).

use super::agreement::Agreement;
use super::grid::{Axis, Grid};
use super::run_cache::{Mechanism, RunCache};
use super::scatter::Observation;
use super::unknowns::value;
use loosepin_math::{places_in_order, solve_square};
use loosepin_result::motion_identification::{
    LengthColumn, LengthsRefusal, MechanismRows, SpecimenLengths, TiedLength, TiedToLengths,
};
use loosepin_study::{MIN_SPECIMEN_ROWS, RandomInput, StudyError};
use loosepin_uncertainty::{hash, sample_correlation, uniform};

/// Rows that are written.
const ROWS: usize = 1000;
/// Effective rows at which no further mechanisms are drawn.
const ENOUGH: f64 = 400.0;
/// Effective rows, at least.
const LEAST: f64 = MIN_SPECIMEN_ROWS as f64;
/// Mechanisms that are drawn before it is looked at whether they are enough.
const BATCH: usize = 2000;
/// Largest share of drawn mechanisms whose run failed.
const MAX_FAILED: f64 = 0.05;
/// Rank correlation of a length and an unknown from which they count as tied, unless it is by chance.
const TIED: f64 = 0.3;
/// Standard deviations beyond which a rank correlation is no chance.
const CHANCE: f64 = 3.0;
/// Streams of random numbers of the seed of the study.
const VALUES: u64 = 0x7661_6c75_6573;
const ROWS_DRAWN: u64 = 0x726f_7773;

/// Mechanisms that agree with `seen`, of at most `most` runs.
pub(crate) fn lengths(
    bank: &RunCache<'_>,
    seen: &Observation,
    grid: &Grid,
    most: usize,
) -> Result<SpecimenLengths, StudyError> {
    Ok(match drawn(bank, seen, grid, most)? {
        Ok(rows) => SpecimenLengths::Given(rows),
        Err(refusal) => SpecimenLengths::Refused(refusal),
    })
}

fn drawn(
    bank: &RunCache<'_>,
    seen: &Observation,
    grid: &Grid,
    most: usize,
) -> Result<Result<MechanismRows, LengthsRefusal>, StudyError> {
    let study = bank.study;
    let mut cells: Vec<usize> = grid.consistent().collect();
    cells.extend(cells.clone().into_iter().flat_map(|cell| grid.neighbours(cell)));
    cells.sort_unstable();
    cells.dedup();
    if cells.is_empty() {
        return Ok(Err(LengthsRefusal::Misfit));
    }
    if study.random.is_empty() {
        return Ok(Err(LengthsRefusal::NothingRandom));
    }
    if let Some(input) = study.random.iter().find(|input| !input.parameters.is_empty()) {
        return Ok(Err(LengthsRefusal::UncertainParameter { path: input.path.clone() }));
    }
    let agreement = match Agreement::new(seen, &bank.features) {
        Ok(agreement) => agreement,
        Err(places) => {
            let features = places.into_iter().map(|place| bank.features[place].name.clone()).collect();
            return Ok(Err(LengthsRefusal::NotScattered { features }));
        }
    };
    let point = |number: usize| -> Vec<f64> {
        let key = hash(hash(study.seed, VALUES), number as u64);
        let cell = cells[((uniform(key, 0) * cells.len() as f64) as usize).min(cells.len() - 1)];
        let place = grid.place(cell);
        let share = |k: usize| match grid.axes[k] {
            Axis::Continuous => (place[k] as f64 + uniform(key, 1 + k as u64)) / grid.counts[k] as f64,
            Axis::Members(_) => place[k] as f64,
        };
        study.epistemic.iter().enumerate().map(|(k, input)| value(input, share(k))).collect()
    };
    let mut all: Vec<Mechanism> = Vec::new();
    let mut logs: Vec<f64> = Vec::new();
    let mut shares = Vec::new();
    while all.len() < most && effective(&shares) < ENOUGH {
        let points: Vec<Vec<f64>> = (all.len()..most.min(all.len() + BATCH)).map(point).collect();
        let new = bank.mechanisms(all.len(), &points)?;
        logs.extend(new.iter().map(|mechanism| agreement.log_likelihood(&mechanism.features)));
        all.extend(new);
        shares = weights(&logs);
    }
    let failed = all.iter().filter(|mechanism| mechanism.features.iter().any(|value| !value.is_finite())).count();
    if failed as f64 > MAX_FAILED * all.len() as f64 {
        return Ok(Err(LengthsRefusal::Failed { failed, runs: all.len(), most: MAX_FAILED }));
    }
    let effective = effective(&shares);
    if effective < LEAST {
        return Ok(Err(LengthsRefusal::FewMechanisms { effective, runs: all.len(), least: LEAST }));
    }
    let places = resampled(&shares, ROWS, uniform(hash(study.seed, ROWS_DRAWN), 0));
    let mut times = vec![0.0; all.len()];
    places.iter().for_each(|at| times[*at] += 1.0 / ROWS as f64);
    let effective_rows = self::effective(&times);
    let mut rows: Vec<&Mechanism> = places.into_iter().map(|at| &all[at]).collect();
    // Neighbours in the file are alike: points that fill the unit interval evenly fill the rows evenly.
    rows.sort_by(|a, b| {
        a.random
            .iter()
            .zip(&b.random)
            .map(|(a, b)| a.total_cmp(b))
            .find(|order| order.is_ne())
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    let ranks = Ranks::new(&rows, grid);
    let tied = ranks.tied(effective);
    let columns = study.random.iter().enumerate().map(|(input, known)| column(bank, known, input, &all, &shares));
    Ok(Ok(MechanismRows {
        columns: columns.collect(),
        rows_si: rows.iter().map(|row| row.random.clone()).collect(),
        runs: all.len(),
        failed,
        effective,
        effective_rows,
        tied_together: ranks.tied_together(effective, &tied),
        tied,
    }))
}

/// Likelihoods over their sum; empty if none is above 0.
fn weights(logs: &[f64]) -> Vec<f64> {
    let most = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if most == f64::NEG_INFINITY {
        return Vec::new();
    }
    let raw: Vec<f64> = logs.iter().map(|log| (log - most).exp()).collect();
    let sum: f64 = raw.iter().sum();
    raw.into_iter().map(|weight| weight / sum).collect()
}

/// Number of equally probable draws that would say as much.
fn effective(shares: &[f64]) -> f64 {
    let squares: f64 = shares.iter().map(|share| share * share).sum();
    if squares > 0.0 { 1.0 / squares } else { 0.0 }
}

/// Which of all are drawn, `count` times: at equal steps of the sum of their shares, the first of them after `offset` steps.
fn resampled(shares: &[f64], count: usize, offset: f64) -> Vec<usize> {
    let (mut at, mut passed) = (0, shares.first().copied().unwrap_or(0.0));
    let mut drawn = Vec::with_capacity(count);
    for step in 0..count {
        let due = (step as f64 + offset) / count as f64;
        while passed <= due && at + 1 < shares.len() {
            at += 1;
            passed += shares[at];
        }
        drawn.push(at);
    }
    drawn
}

fn column(bank: &RunCache<'_>, input: &RandomInput, place: usize, all: &[Mechanism], shares: &[f64]) -> LengthColumn {
    let middle = input.variable.mean();
    let moment = |power: i32, about: f64| -> f64 {
        all.iter().zip(shares).map(|(mechanism, share)| share * (mechanism.random[place] - about).powi(power)).sum()
    };
    let mean = middle + moment(1, middle);
    LengthColumn {
        path: input.path.clone(),
        name: super::unknowns::name(&input.path),
        unit: input.unit(&bank.study.model),
        before_si: [middle, input.variable.standard_deviation()],
        after_si: [mean, moment(2, mean).sqrt()],
    }
}

/// Ranks of the rows by what the pairs were drawn of.
struct Ranks {
    lengths: Vec<Vec<f64>>,
    /// Unknowns that are no list, each with its index.
    unknowns: Vec<(usize, Vec<f64>)>,
}

impl Ranks {
    fn new(rows: &[&Mechanism], grid: &Grid) -> Self {
        let of = |values: &dyn Fn(&Mechanism) -> f64| ranks(&rows.iter().map(|row| values(row)).collect::<Vec<f64>>());
        let [lengths, unknowns] = rows.first().map_or([0; 2], |row| [row.random.len(), row.epistemic.len()]);
        let is_between = |unknown: &usize| grid.axes[*unknown] == Axis::Continuous;
        Self {
            lengths: (0..lengths).map(|column| of(&|row| row.random[column])).collect(),
            unknowns: (0..unknowns)
                .filter(is_between)
                .map(|unknown| (unknown, of(&|row| row.epistemic[unknown])))
                .collect(),
        }
    }

    /// Lengths that trade off against an unknown.
    fn tied(&self, effective: f64) -> Vec<TiedLength> {
        let least = TIED.max(CHANCE / effective.sqrt());
        let mut found = Vec::new();
        for (unknown, of_unknown) in &self.unknowns {
            for (column, of_length) in self.lengths.iter().enumerate() {
                let rank_correlation = sample_correlation(of_length, of_unknown);
                if rank_correlation.abs() >= least {
                    found.push(TiedLength { column, unknown: *unknown, rank_correlation });
                }
            }
        }
        found
    }

    /// Unknowns that no single length determines and that all of them together do: many lengths, each with a small share.
    fn tied_together(&self, effective: f64, tied: &[TiedLength]) -> Vec<TiedToLengths> {
        // By chance R² of `count` lengths is count/n, with the variance 2 count/n².
        let count = self.lengths.len() as f64;
        let least = TIED.max(((count + CHANCE * (2.0 * count).sqrt()) / effective).sqrt());
        let is_told = |unknown: usize| tied.iter().any(|tied| tied.unknown == unknown);
        self.unknowns
            .iter()
            .filter(|(unknown, _)| self.lengths.len() > 1 && !is_told(*unknown))
            .filter_map(|(unknown, of_unknown)| {
                let rank_correlation = multiple_correlation(&self.lengths, of_unknown);
                (rank_correlation >= least).then_some(TiedToLengths { unknown: *unknown, rank_correlation })
            })
            .collect()
    }
}

/// Multiple correlation √(rᵀ C⁻¹ r) of `of` with all `columns`; 0 if they do not determine it.
fn multiple_correlation(columns: &[Vec<f64>], of: &[f64]) -> f64 {
    /// Added to the diagonal: columns that go exactly together are no equations of their own.
    const ROUND_OFF: f64 = 1e-9;
    let count = columns.len();
    let mut matrix: Vec<f64> = columns.iter().flat_map(|a| columns.iter().map(|b| sample_correlation(a, b))).collect();
    (0..count).for_each(|at| matrix[at * count + at] = 1.0 + ROUND_OFF);
    let right: Vec<f64> = columns.iter().map(|column| sample_correlation(column, of)).collect();
    let mut factors = right.clone();
    if solve_square(&mut matrix, count, &mut factors) == 0.0 {
        return 0.0;
    }
    right.iter().zip(&factors).map(|(right, factor)| right * factor).sum::<f64>().clamp(0.0, 1.0).sqrt()
}

/// Ranks of values; those that are equal have the middle of their ranks.
fn ranks(values: &[f64]) -> Vec<f64> {
    let order = places_in_order(values);
    let mut ranks = vec![0.0; values.len()];
    let mut from = 0;
    while from < order.len() {
        let same = order[from..].iter().take_while(|at| values[**at] == values[order[from]]).count();
        for at in &order[from..from + same] {
            ranks[*at] = from as f64 + 0.5 * (same as f64 - 1.0);
        }
        from += same;
    }
    ranks
}

#[cfg(test)]
mod tests {
    use super::{effective, multiple_correlation, ranks, resampled, weights};
    use loosepin_uncertainty::sample_correlation;

    #[test]
    fn analytic_rows_come_out_as_often_as_their_shares_say() {
        let shares = [0.1, 0.0, 0.45, 0.45];
        for offset in [0.01, 0.5, 0.99] {
            let drawn = resampled(&shares, 40, offset);
            let times = |at: usize| drawn.iter().filter(|drawn| **drawn == at).count();
            assert_eq!([times(0), times(1), times(2), times(3)], [4, 0, 18, 18], "{offset}");
        }
    }

    #[test]
    fn analytic_effective_number_of_weights() {
        let shares = weights(&[0.0, f64::NEG_INFINITY, 3.0_f64.ln()]);
        assert_eq!(shares[1], 0.0);
        // 1/(1/16 + 9/16).
        assert!((effective(&shares) - 1.6).abs() < 1e-12);
        assert_eq!(effective(&weights(&[f64::NEG_INFINITY])), 0.0);
    }

    /// Of y = a + b with columns that do not go together, each has the share 1/2 of the square; a column twice tells nothing more.
    #[test]
    fn analytic_multiple_correlation_of_a_sum() {
        let [a, b] = [[-1.0, 1.0, -1.0, 1.0], [-1.0, -1.0, 1.0, 1.0]].map(Vec::from);
        let sum: Vec<f64> = a.iter().zip(&b).map(|(a, b)| a + b).collect();
        assert!((sample_correlation(&a, &sum) - 0.5_f64.sqrt()).abs() < 1e-15);
        assert!((multiple_correlation(&[a.clone(), b], &sum) - 1.0).abs() < 1e-8);
        assert!((multiple_correlation(&[a.clone(), a], &sum) - 0.5_f64.sqrt()).abs() < 1e-8);
    }

    #[test]
    fn analytic_ranks_of_ties() {
        assert_eq!(ranks(&[3.0, 1.0, 3.0, 2.0]), [2.5, 0.0, 2.5, 1.0]);
    }
}

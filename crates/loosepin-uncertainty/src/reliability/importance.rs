//! Importance sampling around design points.

use super::design_point::DesignPoint;
use super::{RARE_CONFIDENCE, RareEstimate, RareProbability, square};
use crate::{ScrambledSobol, SobolError, hash, normal_cdf, normal_quantile, student_factor};

/// Share of the points that are drawn wide around the origin, whatever the design points say.
const WIDE_SHARE: f64 = 0.25;
/// Independent scramblings, for the standard error.
const REPLICATES: usize = 16;
/// Points of each replicate in the first round.
const FIRST_POINTS: usize = 32;
/// Separates the stream of random numbers.
const IMPORTANCE: u64 = 0x0069_6d70_6f72_7400;

/// How much is sampled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImportanceSampling {
    /// Evaluations, at most; at least 512 are made. Default: 16,000.
    pub most_runs: usize,
    /// Coefficient of variation at which sampling ends. Default: 0.05.
    pub target: f64,
    /// Seed. Default: 1.
    pub seed: u64,
}

impl Default for ImportanceSampling {
    fn default() -> Self {
        Self { most_runs: 16_000, target: 0.05, seed: 1 }
    }
}

/// P(g <= 0) by sampling around `designs`.
///
/// ```text
/// q(u) = (1 - a) Σ_k w_k φ(u - u_k) + a φ(u/s)/sⁿ,   w_k ∝ Φ(-|u_k|),   s² = 1 + |u_1|²/n,   a = 0.25
/// P = mean of φ(u)/q(u) over the points u from q with g(u) <= 0
/// ```
///
/// The weight is taken with the whole mixture (E. Veach, L. Guibas, SIGGRAPH 1995), so that it is at most sⁿ/a anywhere: an event
/// that no design point has shown is met by the wide part, and makes the stated error large instead of being left out. Without design
/// points all is drawn wide, s = 3. Points are scrambled Sobol' points in 16 replicates, doubled in rounds until the target or the
/// budget is reached; the error is that of the mean over the replicates with Student's factor.
///
/// # Errors
/// That of the limit state; [`SobolError`] where there are more inputs than Sobol' points have dimensions.
pub fn importance_sampling<E: From<SobolError>>(
    limit_state: &mut impl FnMut(&[Vec<f64>]) -> Result<Vec<f64>, E>,
    dimensions: usize,
    designs: &[DesignPoint],
    settings: &ImportanceSampling,
) -> Result<RareProbability, E> {
    let mixture = Mixture::new(dimensions, designs);
    let sobol = ScrambledSobol::try_new(hash(settings.seed, IMPORTANCE), dimensions + 1)?;
    // Without and with the runs that failed.
    let (mut low, mut high) = ([0.0; REPLICATES], [0.0; REPLICATES]);
    let (mut done, mut failed) = (0_usize, 0);
    let mut coordinates = vec![0.0; dimensions + 1];
    loop {
        let next = if done == 0 { FIRST_POINTS } else { done };
        let mut points = Vec::with_capacity(REPLICATES * next);
        for replicate in 0..REPLICATES {
            for index in done..done + next {
                sobol.write_point(replicate as u32, index as u32, &mut coordinates);
                points.push(mixture.point(&coordinates));
            }
        }
        let values = limit_state(&points)?;
        for (position, (point, value)) in points.iter().zip(&values).enumerate() {
            failed += usize::from(value.is_nan());
            if !(*value > 0.0) {
                let weight = mixture.weight(point);
                high[position / next] += weight;
                low[position / next] += if value.is_nan() { 0.0 } else { weight };
            }
        }
        done += next;
        let runs = REPLICATES * done;
        let [low, high] = [low, high].map(|sums| estimate(&sums, done));
        if high.coefficient_of_variation() <= settings.target || 2 * runs > settings.most_runs {
            return Ok(RareProbability { low, high, runs, failed });
        }
    }
}

fn estimate(sums: &[f64; REPLICATES], done: usize) -> RareEstimate {
    let means = sums.map(|sum| sum / done as f64);
    let value = means.iter().sum::<f64>() / REPLICATES as f64;
    let squares: f64 = means.iter().map(|mean| (mean - value) * (mean - value)).sum();
    let standard_error = (squares / ((REPLICATES - 1) * REPLICATES) as f64).sqrt();
    let half = student_factor(RARE_CONFIDENCE, REPLICATES - 1) * standard_error;
    // Where nothing was met, nothing is known.
    let interval = if value > 0.0 { [value - half, value + half].map(|end| end.clamp(0.0, 1.0)) } else { [0.0, 1.0] };
    RareEstimate { value: value.min(1.0), standard_error, interval }
}

/// The density that is drawn from.
struct Mixture {
    centres: Vec<Vec<f64>>,
    /// Share of each centre; the rest is wide.
    shares: Vec<f64>,
    /// Standard deviation of the wide part.
    wide: f64,
}

impl Mixture {
    fn new(dimensions: usize, designs: &[DesignPoint]) -> Self {
        let weights: Vec<f64> = designs.iter().map(|design| normal_cdf(-square(&design.point).sqrt())).collect();
        let sum: f64 = weights.iter().sum();
        let nearest = designs.iter().map(|design| square(&design.point)).fold(f64::INFINITY, f64::min);
        let wide = if designs.is_empty() { 3.0 } else { (1.0 + nearest / dimensions as f64).sqrt() };
        Self {
            centres: designs.iter().map(|design| design.point.clone()).collect(),
            shares: weights.iter().map(|weight| (1.0 - WIDE_SHARE) * weight / sum).collect(),
            wide,
        }
    }

    /// From uniform coordinates, the first of which chooses the part.
    fn point(&self, coordinates: &[f64]) -> Vec<f64> {
        let mut rest = coordinates[0];
        let centre = self.shares.iter().position(|share| {
            rest -= share;
            rest < 0.0
        });
        let numbers = coordinates[1..].iter().map(|&share| normal_quantile(share));
        match centre {
            Some(centre) => numbers.zip(&self.centres[centre]).map(|(x, at)| x + at).collect(),
            None => numbers.map(|x| self.wide * x).collect(),
        }
    }

    /// φ(u)/q(u).
    fn weight(&self, point: &[f64]) -> f64 {
        let radius = square(point);
        // Each part over φ(u): exp(u·c - |c|²/2) around a centre c.
        let around: f64 = self
            .centres
            .iter()
            .zip(&self.shares)
            .map(|(centre, share)| share * libm::exp(super::dot(point, centre) - 0.5 * square(centre)))
            .sum();
        let share = 1.0 - self.shares.iter().sum::<f64>();
        let ln_scale = point.len() as f64 * libm::log(self.wide);
        let wide = share * libm::exp(0.5 * radius * (1.0 - 1.0 / (self.wide * self.wide)) - ln_scale);
        1.0 / (around + wide)
    }
}

#[cfg(test)]
mod tests {
    use super::{ImportanceSampling, importance_sampling};
    use crate::SobolError;
    use crate::reliability::tests::{FOUR_BRANCHES, KnownLimitState, LIMIT_STATES};
    use crate::reliability::{DesignSearch, RareProbability, design_points};

    fn estimate(known: &KnownLimitState, seed: u64) -> RareProbability {
        let mut limit_state = |points: &[Vec<f64>]| -> Result<Vec<f64>, SobolError> {
            Ok(points.iter().map(|point| (known.limit_state)(point)).collect())
        };
        let search = DesignSearch { seed, ..DesignSearch::default() };
        let (designs, runs) = design_points(&mut limit_state, known.dimensions, &search).unwrap();
        let settings = ImportanceSampling { seed, ..ImportanceSampling::default() };
        let found = importance_sampling(&mut limit_state, known.dimensions, &designs, &settings).unwrap();
        RareProbability { runs: found.runs + runs, ..found }
    }

    #[test]
    fn analytic_one_in_a_hundred_thousand_to_a_tenth() {
        const SEEDS: u64 = 60;
        /// 95 % of 60 less three standard deviations of that count.
        const MIN_CONTAINED: usize = 52;
        for known in LIMIT_STATES.iter().chain([&FOUR_BRANCHES]) {
            let truth = (known.probability)();
            let found: Vec<RareProbability> = (0..SEEDS).map(|seed| estimate(known, seed)).collect();
            let contained = found.iter().filter(|f| f.high.interval[0] <= truth && truth <= f.high.interval[1]).count();
            assert!(contained >= MIN_CONTAINED, "{}: {contained} of {SEEDS}", known.name);
            let squares: f64 = found.iter().map(|f| (f.high.value / truth - 1.0).powi(2)).sum();
            let deviation = (squares / SEEDS as f64).sqrt();
            assert!(deviation < 0.1, "{}: {deviation}", known.name);
            let most_runs = found.iter().map(|f| f.runs).max();
            assert!(most_runs < Some(20_000), "{}: {most_runs:?} runs", known.name);
        }
    }

    #[test]
    fn a_design_point_that_is_missing_shows_in_the_error() {
        // Only one of two equal planes is known: the wide part meets the other.
        let both = |point: &[f64]| 4.3 - point[0].abs();
        let mut limit_state = |points: &[Vec<f64>]| -> Result<Vec<f64>, SobolError> {
            Ok(points.iter().map(|point| both(point)).collect())
        };
        let search = DesignSearch { starts: 0, ..DesignSearch::default() };
        let mut one_sided = |points: &[Vec<f64>]| -> Result<Vec<f64>, SobolError> {
            Ok(points.iter().map(|point| 4.3 - point[0]).collect())
        };
        let (designs, _) = design_points(&mut one_sided, 2, &search).unwrap();
        let settings = ImportanceSampling { target: 0.02, ..ImportanceSampling::default() };
        let found = importance_sampling(&mut limit_state, 2, &designs, &settings).unwrap();
        let truth = 2.0 * crate::normal_cdf(-4.3);
        assert!((found.high.value / truth - 1.0).abs() < 0.2, "{found:?} against {truth}");
    }

    #[test]
    fn analytic_failed_runs_count_as_the_event_in_the_upper_end_alone() {
        // Φ(-3) of the mechanisms fail; none is seen at the limit.
        let mut limit_state = |points: &[Vec<f64>]| -> Result<Vec<f64>, SobolError> {
            Ok(points.iter().map(|point| if point[0] > 3.0 { f64::NAN } else { 2.5 }).collect())
        };
        let found = importance_sampling(&mut limit_state, 2, &[], &ImportanceSampling::default()).unwrap();
        let truth = crate::normal_cdf(-3.0);
        assert!(found.failed > 0 && (found.high.value / truth - 1.0).abs() < 0.2, "{found:?}");
        assert!(found.low.interval[0] == 0.0 && found.high.interval[1] >= truth, "{found:?}");
    }
}

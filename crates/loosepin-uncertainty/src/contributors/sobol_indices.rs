//! First-order and total Sobol' indices by picking and freezing.

use thiserror::Error;

use crate::{MAXIMUM_DIMENSIONS, ScrambledSobol, SobolError, hash, student_factor};

/// Confidence of the errors of indices.
pub const SHARES_CONFIDENCE: f64 = 0.95;

/// Separates the stream of random numbers.
const INDICES: u64 = 0x696e_6469_6365_7300;

/// The runs for the Sobol' indices of groups of inputs.
///
/// ```text
/// S_i = Var(E[Y | X_i])/Var(Y),   T_i = E[Var(Y | all but X_i)]/Var(Y)
/// A, B: independent points of the unit cube; C_i: A with the inputs of group i taken from B
/// T_i Var = ½ mean (f(A) - f(C_i))²
/// S_i Var = w (Var - ½ mean (f(B) - f(C_i))²) + (1 - w) mean (f(B) - m)(f(C_i) - f(A)),   w = T_i between 0 and 1
/// ```
///
/// m and Var are mean and variance over all f(A) and f(B). The first estimate of S_i is exact where X_i is all that matters, the
/// second one where it does not matter; w takes the better one. Sources: M. J. W. Jansen, Computer Physics Communications 117
/// (1999) 35-43 (T, first S); A. Saltelli et al., Computer Physics Communications 181 (2010) 259-270, table 2 (second S; centred
/// here). A response of several numbers has the sums of numerators and variances over them, as in M. Lamboni, H. Monod,
/// D. Makowski, Reliability Engineering & System Safety 96 (2011) 450-459.
///
/// A and B are the two halves of scrambled Sobol' points, so that the errors fall faster than those of random points; the errors
/// stated come from the spread of independent scramblings. Groups must be independent of each other; inputs that are correlated
/// belong to one group.
#[derive(Debug, Clone)]
pub struct IndexPlan {
    sobol: ScrambledSobol,
    dimensions: usize,
    groups: Vec<Vec<usize>>,
    replicates: usize,
    /// Pairs of A and B in a replicate.
    pairs: usize,
}

/// Errors of a plan for Sobol' indices.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum IndexPlanError {
    #[error(
        "{dimensions} random inputs; Sobol' indices can be had of at most {}\nhint: fix the inputs that matter least",
        MAXIMUM_DIMENSIONS / 2
    )]
    TooManyInputs { dimensions: usize },
    #[error("{replicates} replicates of {pairs} pairs of points; must be at least 2 of each")]
    TooFew {
        replicates: usize,
        /// Pairs in each.
        pairs: usize,
    },
    #[error("input {input} of {dimensions} is in {times} groups; must be in one")]
    Groups { input: usize, dimensions: usize, times: usize },
}

impl From<SobolError> for IndexPlanError {
    fn from(error: SobolError) -> Self {
        let SobolError::TooManyDimensions { dimensions } = error;
        Self::TooManyInputs { dimensions: dimensions / 2 }
    }
}

/// A share of the variance with its error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Index {
    /// The estimate; by sampling it may lie slightly outside of 0 to 1.
    pub value: f64,
    /// Half the width of its interval of confidence [`SHARES_CONFIDENCE`].
    pub error: f64,
}

/// The indices of one response.
#[derive(Debug, Clone, PartialEq)]
pub struct Indices {
    /// The variance, in the square of the unit of the response; the sum of variances where it has several numbers.
    pub variance: f64,
    /// First-order index of each group.
    pub first: Vec<Index>,
    /// Total index of each group.
    pub total: Vec<Index>,
    /// Pairs of points that were left out, since one of their runs has no value.
    pub left_out: usize,
}

impl IndexPlan {
    /// Indices of `groups` of the inputs 0 to `dimensions` - 1, from `replicates` times `pairs` pairs of points.
    ///
    /// # Errors
    /// [`IndexPlanError`] where there are too many inputs, fewer than 2 replicates or pairs, or an input not in exactly one group.
    pub fn try_new(
        dimensions: usize,
        groups: Vec<Vec<usize>>,
        replicates: usize,
        pairs: usize,
        seed: u64,
    ) -> Result<Self, IndexPlanError> {
        if replicates < 2 || pairs < 2 {
            return Err(IndexPlanError::TooFew { replicates, pairs });
        }
        let named: Vec<usize> = groups.iter().flatten().copied().collect();
        let most = named.iter().map(|&input| input + 1).max().unwrap_or(0).max(dimensions);
        for input in 0..most {
            let times = named.iter().filter(|&&other| other == input).count();
            if times != 1 || input >= dimensions {
                return Err(IndexPlanError::Groups { input, dimensions, times });
            }
        }
        let sobol = ScrambledSobol::try_new(hash(seed, INDICES), 2 * dimensions)?;
        Ok(Self { sobol, dimensions, groups, replicates, pairs })
    }

    /// The points of the unit cube to run at: for each replicate and each pair A, B and every C.
    pub fn points(&self) -> Vec<Vec<f64>> {
        let mut points = Vec::with_capacity(self.runs());
        let mut both = vec![0.0; 2 * self.dimensions];
        for replicate in 0..self.replicates {
            for pair in 0..self.pairs {
                self.sobol.write_point(replicate as u32, pair as u32, &mut both);
                let (a, b) = both.split_at(self.dimensions);
                points.push(a.to_vec());
                points.push(b.to_vec());
                for group in &self.groups {
                    let mut mixed = a.to_vec();
                    for &input in group {
                        mixed[input] = b[input];
                    }
                    points.push(mixed);
                }
            }
        }
        points
    }

    /// Number of points.
    pub fn runs(&self) -> usize {
        self.replicates * self.pairs * self.runs_per_pair()
    }

    fn runs_per_pair(&self) -> usize {
        2 + self.groups.len()
    }

    /// The indices of a response of one or several `columns`, each with one value a point; a value that is not finite leaves its pair
    /// out. `None` if a replicate has no pair left or where the response does not vary.
    pub fn indices(&self, columns: &[Vec<f64>]) -> Option<Indices> {
        let groups = self.groups.len();
        // For each replicate: the variance, then the numerators of first-order (both kinds) and total indices.
        let mut variances = vec![0.0; self.replicates];
        let mut frozen = vec![vec![0.0; groups]; self.replicates];
        let mut moved = vec![vec![0.0; groups]; self.replicates];
        let mut totals = vec![vec![0.0; groups]; self.replicates];
        let mut left_out = 0;
        for column in columns {
            let blocks: Vec<&[f64]> = column.chunks_exact(self.runs_per_pair()).collect();
            let is_whole = |block: &&&[f64]| block.iter().all(|value| value.is_finite());
            let whole = || blocks.iter().filter(is_whole);
            let count = whole().count();
            left_out += blocks.len() - count;
            let mean = whole().map(|block| block[0] + block[1]).sum::<f64>() / (2 * count) as f64;
            for (replicate, own) in blocks.chunks(self.pairs).enumerate() {
                let count = own.iter().filter(is_whole).count() as f64;
                if count == 0.0 {
                    return None;
                }
                for block in own.iter().filter(is_whole) {
                    let (a, b) = (block[0] - mean, block[1] - mean);
                    variances[replicate] += 0.5 * (a * a + b * b) / count;
                    for (group, value) in block[2..].iter().enumerate() {
                        let c = value - mean;
                        frozen[replicate][group] += 0.5 * (b - c) * (b - c) / count;
                        moved[replicate][group] += b * (c - a) / count;
                        totals[replicate][group] += 0.5 * (a - c) * (a - c) / count;
                    }
                }
            }
        }
        let variance = variances.iter().sum::<f64>() / self.replicates as f64;
        if !(variance > 0.0) {
            return None;
        }
        let mut first = Vec::with_capacity(groups);
        let mut total = Vec::with_capacity(groups);
        for group in 0..groups {
            let numerators: Vec<f64> = totals.iter().map(|of| of[group]).collect();
            let share = ratio(&numerators, &variances, variance);
            let weight = share.value.clamp(0.0, 1.0);
            let mixed = |replicate: usize| {
                weight * (variances[replicate] - frozen[replicate][group]) + (1.0 - weight) * moved[replicate][group]
            };
            let numerators: Vec<f64> = (0..self.replicates).map(mixed).collect();
            first.push(ratio(&numerators, &variances, variance));
            total.push(share);
        }
        Some(Indices { variance, first, total, left_out })
    }
}

/// The ratio of the means of both, with the error that the replicates show: that of the mean of numerator - ratio x variance.
fn ratio(numerators: &[f64], variances: &[f64], variance: f64) -> Index {
    let count = numerators.len() as f64;
    let value = numerators.iter().sum::<f64>() / count / variance;
    let square = |(numerator, own): (&f64, &f64)| ((numerator - value * own) / variance).powi(2);
    let squares: f64 = numerators.iter().zip(variances).map(square).sum();
    let standard_error = (squares / (count - 1.0) / count).sqrt();
    Index { value, error: student_factor(SHARES_CONFIDENCE, numerators.len() - 1) * standard_error }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::{Index, IndexPlan, IndexPlanError};
    use crate::normal_quantile;

    /// What the issue asks for, absolute.
    const INDEX_TOLERANCE: f64 = 0.01;

    /// T. Ishigami, T. Homma (1990) with a = 7, b = 0.1, inputs uniform between -π and π.
    fn ishigami(point: &[f64]) -> f64 {
        let [x, y, z] = [0, 1, 2].map(|k: usize| PI * (2.0 * point[k] - 1.0));
        x.sin() + 7.0 * y.sin().powi(2) + 0.1 * z.powi(4) * x.sin()
    }

    fn separate(dimensions: usize) -> Vec<Vec<usize>> {
        (0..dimensions).map(|input| vec![input]).collect()
    }

    fn run(plan: &IndexPlan, f: impl Fn(&[f64]) -> f64) -> Vec<f64> {
        plan.points().iter().map(|point| f(point)).collect()
    }

    fn assert_near(found: &[Index], expected: &[f64], seed: u64) {
        for (index, expected) in found.iter().zip(expected) {
            assert!((index.value - expected).abs() < INDEX_TOLERANCE, "seed {seed}: {found:?}");
            assert!(index.error < 2.0 * INDEX_TOLERANCE, "seed {seed}: {found:?}");
        }
    }

    #[test]
    fn published_indices_of_ishigamis_function() {
        for seed in 0..10 {
            let plan = IndexPlan::try_new(3, separate(3), 8, 2048, seed).unwrap();
            let indices = plan.indices(&[run(&plan, ishigami)]).unwrap();
            assert_near(&indices.first, &[0.3139, 0.4424, 0.0], seed);
            assert_near(&indices.total, &[0.5576, 0.4424, 0.2437], seed);
        }
    }

    #[test]
    fn analytic_indices_of_a_linear_function_of_normal_inputs() {
        // Variances 9 · 0.16, 0.25 · 4, 0.04 · 2.25 of a sum of 2.53.
        let expected = [1.44 / 2.53, 1.0 / 2.53, 0.09 / 2.53];
        for seed in 0..10 {
            let plan = IndexPlan::try_new(3, separate(3), 8, 256, seed).unwrap();
            let linear = |p: &[f64]| {
                let [x, y, z] = [0, 1, 2].map(|k: usize| normal_quantile(p[k]));
                7.3 + 3.0 * 0.4 * x - 0.5 * 2.0 * y + 0.2 * 1.5 * z
            };
            let indices = plan.indices(&[run(&plan, linear)]).unwrap();
            assert_near(&indices.first, &expected, seed);
            assert_near(&indices.total, &expected, seed);
        }
    }

    #[test]
    fn identity_stated_errors_contain_the_truth_as_often_as_they_promise() {
        const SEEDS: u64 = 200;
        /// 95 % of 200 less three standard deviations of that count.
        const MIN_CONTAINED: usize = 180;
        let truth = [0.313_905_2, 0.442_411_1, 0.0, 0.557_588_9, 0.442_411_1, 0.243_683_7];
        let mut contained = [0; 6];
        for seed in 0..SEEDS {
            let plan = IndexPlan::try_new(3, separate(3), 8, 64, 1000 + seed).unwrap();
            let indices = plan.indices(&[run(&plan, ishigami)]).unwrap();
            let found = indices.first.iter().chain(&indices.total);
            for ((index, truth), count) in found.zip(truth).zip(&mut contained) {
                *count += usize::from((index.value - truth).abs() <= index.error);
            }
        }
        assert!(contained.iter().all(|&count| count >= MIN_CONTAINED), "{contained:?} of {SEEDS}");
    }

    #[test]
    fn analytic_groups_take_interactions_within_them() {
        const TOLERANCE: f64 = 0.02; // four times the error with so few runs
        // Y = U V + W with independent standard normal inputs: half the variance is the product's, none of it U's or V's alone.
        let product = |p: &[f64]| normal_quantile(p[0]) * normal_quantile(p[2]) + normal_quantile(p[1]);
        let plan = IndexPlan::try_new(3, vec![vec![0, 2], vec![1]], 8, 512, 5).unwrap();
        let indices = plan.indices(&[run(&plan, product)]).unwrap();
        for index in indices.first.iter().chain(&indices.total) {
            assert!((index.value - 0.5).abs() < TOLERANCE, "{indices:?}");
        }
    }

    #[test]
    fn analytic_several_numbers_weigh_by_their_variances() {
        // Variances 4 and 9 of X alone, 1 and 4 of Y alone: 13/18 and 5/18.
        let plan = IndexPlan::try_new(2, separate(2), 8, 512, 3).unwrap();
        let first = run(&plan, |p| 2.0 * normal_quantile(p[0]) + normal_quantile(p[1]));
        let second = run(&plan, |p| 3.0 * normal_quantile(p[0]) - 2.0 * normal_quantile(p[1]));
        let indices = plan.indices(&[first, second]).unwrap();
        assert_near(&indices.total, &[13.0 / 18.0, 5.0 / 18.0], 3);
    }

    #[test]
    fn runs_without_a_value_leave_their_pair_out() {
        let plan = IndexPlan::try_new(2, separate(2), 4, 64, 3).unwrap();
        let mut values = run(&plan, |p| normal_quantile(p[0]) + 0.5 * normal_quantile(p[1]));
        values[2] = f64::NAN;
        values[41] = f64::INFINITY;
        assert_eq!(plan.indices(&[values.clone()]).unwrap().left_out, 2);
        values[..4 * 64].fill(f64::NAN);
        assert_eq!(plan.indices(&[values]), None);
        assert_eq!(plan.indices(&[vec![2.5; plan.runs()]]), None, "nothing varies");
    }

    #[test]
    fn what_is_no_plan_is_refused() {
        let groups = |groups| IndexPlan::try_new(2, groups, 4, 8, 1).unwrap_err();
        assert_eq!(groups(vec![vec![0]]), IndexPlanError::Groups { input: 1, dimensions: 2, times: 0 });
        assert_eq!(groups(vec![vec![0, 1], vec![1]]), IndexPlanError::Groups { input: 1, dimensions: 2, times: 2 });
        assert_eq!(
            groups(vec![vec![0], vec![1], vec![2]]),
            IndexPlanError::Groups { input: 2, dimensions: 2, times: 1 }
        );
        let few = IndexPlan::try_new(2, separate(2), 1, 8, 1).unwrap_err();
        assert_eq!(few.to_string(), "1 replicates of 8 pairs of points; must be at least 2 of each");
        let many = IndexPlan::try_new(200, separate(200), 2, 8, 1).unwrap_err();
        assert_eq!(many, IndexPlanError::TooManyInputs { dimensions: 200 });
    }
}

//! How much narrower the band would be if one epistemic input were known.

use super::experiment::Experiment;
use crate::data::direction::{Direction, extreme_point};
use crate::measures::measure::{Estimator, Measure};
use crate::measures::quantile::Quantile;
use crate::parallel;
use crate::search::models::of_points::Branch;
use crate::search::models::prediction::Allowance;
use crate::search::target::Target;

/// Values of an interval at which it is taken as known, in shares of its width.
const FRACTIONS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// Places of the box, besides those that were run, at which the models are asked.
const MAX_PLACES: usize = 96;

/// The error of a model, in its standard deviations.
const ERROR_FACTOR: f64 = 2.0;

/// The band of the mixed treatment, from the least lower to the largest upper quantile over u, and its remaining width where one epistemic
/// input is known.
///
/// ```text
/// W = max over u of q_up(u) - min over u of q_low(u),   W_k(t) = the same over the u with u_k = t
/// ```
///
/// Elements of evidence and cuts of a fuzzy number count by what holds them all, whatever their masses and degrees: what is asked is
/// what becomes of the widest band if the value were known.
///
/// Both from the models of the quantiles over u that the search has made from the existing runs; no new runs. For several columns
/// the widths are added.
#[derive(Debug, Clone, PartialEq)]
pub struct Pinching {
    /// W, in the unit of the response.
    pub width: f64,
    /// Error of W by the models, two standard deviations at both ends.
    pub width_error: f64,
    /// The part of W that lies within the ends of the bands at single values of u, where W is: from the mean to the quantiles.
    pub scatter: f64,
    /// Where both ends of the band of each column are.
    pub ends: Vec<[PinchedEnd; 2]>,
    /// One for each epistemic input.
    pub inputs: Vec<PinchedInput>,
}

/// An end of a band at the value of u among those that were run at which it is furthest.
#[derive(Debug, Clone, PartialEq)]
pub struct PinchedEnd {
    /// The quantile there.
    pub quantile: f64,
    /// u.
    pub epistemic: Vec<f64>,
}

/// Width of the band that is left where one input is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PinchedInput {
    /// The least and the largest W_k(t) over the values t that the input may turn out to have.
    pub remaining: [f64; 2],
    /// Error of both by the models, two standard deviations at both ends.
    pub error: f64,
}

/// The extreme of the model of a quantile.
#[derive(Debug, Clone, Copy)]
struct Extreme {
    value: f64,
    deviation: f64,
}

impl Experiment<'_> {
    /// The pinching of the band of `columns`; `None` if a quantile has no model, as with too few points.
    pub fn pinching(&self, columns: &[usize]) -> Option<Pinching> {
        let measures: Vec<[Measure; 2]> = columns
            .iter()
            .map(|&column| {
                let samples = self.pool.samples(column);
                let quantiles = self.setup.band_quantiles();
                quantiles.map(|(probability, _)| Quantile(probability).measure(&samples, &self.setup.confidence))
            })
            .collect();
        let search = self.search(measures.iter().flatten());
        let of_columns = parallel::map_indices(columns.len(), |index| {
            let ends = measures[index].each_ref().map(|measure| (&measure.target, search.branches(&measure.target)));
            let samples = self.pool.samples(columns[index]);
            let means: Vec<f64> = samples.iter().map(|sample| mean(sample.values())).collect();
            self.pinched(&ends, &means)
        });
        of_columns.into_iter().collect::<Option<Vec<Pinching>>>()?.into_iter().reduce(Pinching::add)
    }

    fn pinched(&self, ends: &[(&Target, Vec<Branch<'_>>); 2], means: &[f64]) -> Option<Pinching> {
        let search_box = &self.setup.epistemic_box;
        let whole = [0, 1].map(|end| self.extreme(&ends[end], Direction::BOTH[end], &|_| true, None));
        let [low, high] = [whole[0]?, whole[1]?];
        let width = high.value - low.value;
        let attained = [0, 1].map(|end| {
            let values = &ends[end].0.values;
            let point = extreme_point(values, Direction::BOTH[end])?;
            let epistemic = self.pool.points[point].epistemic.clone();
            Some(((values[point] - means[point]).abs(), PinchedEnd { quantile: values[point], epistemic }))
        });
        let [(below, low_end), (above, high_end)] = [attained[0].clone()?, attained[1].clone()?];
        let scatter = below + above;
        let mut inputs = Vec::new();
        for (index, input) in search_box.inputs().iter().enumerate() {
            // A discrete input is known by its combinations, any other by its axis.
            let (mut remaining, mut error) = ([f64::INFINITY, f64::NEG_INFINITY], 0.0_f64);
            let axis = search_box.axis_of(index);
            let known = if axis.is_some() { FRACTIONS.len() } else { input.choices() };
            for level in 0..known {
                let holds = |combination: usize| axis.is_some() || search_box.member_of(combination, index) == level;
                let fixed = axis.map(|axis| (axis, FRACTIONS[level]));
                let [low, high] = [0, 1].map(|end| self.extreme(&ends[end], Direction::BOTH[end], &holds, fixed));
                let (low, high) = (low?, high?);
                let left = (high.value - low.value).max(0.0);
                remaining = [remaining[0].min(left), remaining[1].max(left)];
                error = error.max(ERROR_FACTOR * (low.deviation + high.deviation));
            }
            // Knowing more never widens; what a model says beyond that is its error.
            let excess = (remaining[1] - width).max(0.0);
            let remaining = remaining.map(|left| left.min(width));
            inputs.push(PinchedInput { remaining, error: error + excess });
        }
        let width_error = ERROR_FACTOR * (low.deviation + high.deviation);
        Some(Pinching { width, width_error, scatter, ends: vec![[low_end, high_end]], inputs })
    }

    /// The furthest that the models of a quantile expect it to go, in the combinations that `holds` allows and where one axis is
    /// `fixed` only there. Where failed runs leave the quantile undefined, it takes no part.
    fn extreme(
        &self,
        (target, branches): &(&Target, Vec<Branch<'_>>),
        direction: Direction,
        holds: &dyn Fn(usize) -> bool,
        fixed: Option<(usize, f64)>,
    ) -> Option<Extreme> {
        let mut best: Option<Extreme> = None;
        let mut take = |value: f64, deviation: f64| {
            if best.is_none_or(|best| direction.is_beyond(value, best.value)) {
                best = Some(Extreme { value, deviation });
            }
        };
        for (combination, branch) in branches.iter().enumerate().filter(|(combination, _)| holds(*combination)) {
            if self.setup.has_no_epistemic_inputs() {
                let values = branch.points.iter().map(|&point| target.values[point]);
                values.filter(|value| value.is_finite()).for_each(|value| take(value, 0.0));
                continue;
            }
            let own = self.places.iter().filter(|place| place.combination == combination).map(|place| &place.at);
            let stride = self.setup.candidates.len().div_ceil(MAX_PLACES);
            for place in self.setup.candidates.iter().step_by(stride).chain(own) {
                let mut at = place.clone();
                if let Some((axis, value)) = fixed {
                    at[axis] = value;
                }
                let forecast = branch.at(&at, Allowance::ONE)?;
                take(forecast.mean(), forecast.deviation());
            }
        }
        best
    }
}

impl Pinching {
    fn add(self, other: Self) -> Self {
        let inputs: Vec<PinchedInput> = self
            .inputs
            .iter()
            .zip(&other.inputs)
            .map(|(a, b)| PinchedInput {
                remaining: [a.remaining[0] + b.remaining[0], a.remaining[1] + b.remaining[1]],
                error: a.error + b.error,
            })
            .collect();
        Self {
            inputs,
            width: self.width + other.width,
            width_error: self.width_error + other.width_error,
            scatter: self.scatter + other.scatter,
            ends: self.ends.into_iter().chain(other.ends).collect(),
        }
    }
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

#[cfg(test)]
mod tests {
    use crate::cases::exact::{STANDARD_NORMAL, problem};
    use crate::{DoubleLoop, Failure, Problem, Request, Response, SampleTable, Sampling, Statistic, execute};
    use loosepin_uncertainty::{
        Distribution, EpistemicVariable, Evidence, FocalElement, FuzzyNumber, Interval, Members, RandomVariable,
    };

    /// Share of a width: a hundredth of what the inputs do.
    const TOLERANCE: f64 = 0.01;

    struct Sum;

    impl Response for Sum {
        fn evaluate(&self, random: &[f64], epistemic: &[f64], columns: &mut [f64]) -> Result<(), Failure> {
            // The second interval matters in one direction only, and the list shifts.
            columns[0] = random[0] + 3.0 * epistemic[0] + 2.0 * epistemic[1] * epistemic[1] + epistemic[2];
            Ok(())
        }
    }

    #[test]
    fn analytic_pinching_of_a_sum() {
        let interval = |lower, upper| EpistemicVariable::from(Interval::try_new(lower, upper).unwrap());
        check_sum(interval(-0.4, 1.6), interval(-0.7, 0.7));
    }

    #[test]
    fn analytic_pinching_of_evidence_is_that_of_what_holds_it() {
        let element = |(lower, upper, mass)| FocalElement { interval: Interval::try_new(lower, upper).unwrap(), mass };
        let evidence = Evidence::try_new([(-0.4, 0.9, 0.3), (0.2, 1.6, 0.7)].map(element).to_vec()).unwrap();
        let fuzzy = FuzzyNumber::trapezoidal([-0.7, 0.3, 0.3, 0.7], &[0.0, 0.5, 1.0]).unwrap();
        check_sum(EpistemicVariable::from(evidence), EpistemicVariable::from(fuzzy));
    }

    fn check_sum(first: EpistemicVariable, second: EpistemicVariable) {
        let normal = Distribution::Normal { mean: 0.3, standard_deviation: 0.5 };
        let problem = Problem {
            random: vec![RandomVariable::try_new(normal).unwrap()],
            epistemic: vec![first, second, EpistemicVariable::from(Members::try_new(vec![0.25, 1.75]).unwrap())],
            parameters: Vec::new(),
            copula: None,
            reading: crate::Reading::FixedButUnknown,
            readings_beside: Vec::new(),
            columns: 1,
            requests: vec![
                Request { column: 0, statistic: Statistic::Quantile(0.025) },
                Request { column: 0, statistic: Statistic::Quantile(0.975) },
            ],
            compared_columns: Vec::new(),
            band_probability: 0.95,
            cut_standard_deviations: 3.0,
            percentiles: Vec::new(),
            sampling: Sampling { outer: 104, inner: 256, ..Sampling::default() },
        };
        let plan = DoubleLoop::try_new(problem).unwrap();
        let mut table = SampleTable::new(1);
        loop {
            let round = plan.next_round(&table).unwrap();
            if round.is_empty() {
                break;
            }
            execute(round, &Sum, &mut table).unwrap();
        }
        let pinching = plan.pinching(&table, &[0]).unwrap().unwrap();
        let scatter = 2.0 * 1.959_964 * 0.5;
        let width = 6.0 + 0.98 + 1.5 + scatter;
        assert!((pinching.width / width - 1.0).abs() < TOLERANCE, "{pinching:?}");
        assert!((pinching.scatter / scatter - 1.0).abs() < TOLERANCE, "{pinching:?}");
        for (input, gone) in pinching.inputs.iter().zip([6.0, 0.98, 1.5]) {
            for remaining in input.remaining {
                assert!((remaining - (width - gone)).abs() < TOLERANCE * width, "{pinching:?}");
                assert!((remaining - (width - gone)).abs() < input.error + TOLERANCE * width, "{pinching:?}");
            }
        }
    }

    /// x + a + b, and nothing where both members are their larger ones.
    struct FailsAtBoth;

    impl Response for FailsAtBoth {
        fn evaluate(&self, random: &[f64], epistemic: &[f64], columns: &mut [f64]) -> Result<(), Failure> {
            if epistemic[0] + epistemic[1] > 4.5 {
                return Err(Failure(1));
            }
            columns[0] = random[0] + epistemic[0] + epistemic[1];
            Ok(())
        }
    }

    #[test]
    fn analytic_pinching_of_lists_counts_only_the_combinations_that_ran() {
        let list = |second| EpistemicVariable::from(Members::try_new(vec![0.0, second]).unwrap());
        let statistics = [Statistic::Quantile(0.025), Statistic::Quantile(0.975)];
        let problem = Problem {
            epistemic: vec![list(1.0), list(4.0)],
            sampling: Sampling { inner: 256, ..Sampling::default() },
            ..problem(&[STANDARD_NORMAL], &[], &statistics)
        };
        let plan = DoubleLoop::try_new(problem).unwrap();
        let mut table = SampleTable::new(1);
        execute(plan.next_round(&table).unwrap(), &FailsAtBoth, &mut table).unwrap();
        let pinching = plan.pinching(&table, &[0]).unwrap().unwrap();
        // The sums 0, 1 and 4 ran. With a known: 0 and 4, or 1 alone; with b known: 0 and 1, or 4 alone.
        let scatter = 2.0 * 1.959_964;
        assert!((pinching.width - (4.0 + scatter)).abs() < 0.05, "{pinching:?}");
        for (input, most) in pinching.inputs.iter().zip([4.0, 1.0]) {
            let [least, largest] = input.remaining;
            assert!((least - scatter).abs() < 0.05 && (largest - most - scatter).abs() < 0.05, "{pinching:?}");
        }
    }
}

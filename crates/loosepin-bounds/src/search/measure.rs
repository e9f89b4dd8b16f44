//! A statistic at every outer point, and the quantities by which its extremes are searched.

use super::noise::Noise;
use super::target::{SEARCH_RESOLUTION, Target, TargetKind};
use crate::data::direction::{Direction, extreme_point, range_of};
use crate::data::statistic::{Estimation, Event, Statistic};
use crate::estimators::estimate::{Confidence, EitherWay, Estimate, mean_of, standard_deviation};
use crate::estimators::in_order::in_order;
use crate::estimators::index::{Index, probability_of_index};
use crate::estimators::moments::{mean, variance};
use crate::estimators::probability::{ShareLimits, probability};
use crate::estimators::quantile::quantile_and_slope;
use crate::estimators::replicates::{differences, differences_of_quantiles, variance_of_replicates};
use crate::estimators::sample::Sample;
use crate::estimators::sampled::sampled;

/// A gain below this share of the sampling error at the extreme is not worth a point.
const SHARE_OF_SAMPLING_ERROR: f64 = 0.1;

/// Gain of a counted probability that is worth a point, at least.
const PROBABILITY_RESOLUTION: f64 = 1e-3;

/// Noise below this share of the range of a target is none: the search never resolves it, and models with noise need not be tried.
const NEGLIGIBLE_NOISE: f64 = 1e-9;

/// Gain of a probability of smooth responses that is worth a point, as a share of its range.
const SMOOTH_PROBABILITY_RESOLUTION: f64 = 1e-6;

/// Where a response hardly scatters its probability still has a scale: this share of the range of all responses.
const LEAST_SCALE: f64 = 1e-6;

/// A statistic at every outer point.
#[derive(Debug, Clone)]
pub(crate) struct Measure {
    pub kind: MeasureKind,
    /// With every failed run taken as low as possible, and as high as possible.
    pub low: Vec<Estimate>,
    pub high: Vec<Estimate>,
    /// Errors of the target's values, downwards and upwards.
    pub target_errors: Vec<(f64, f64)>,
    /// Quantity that is searched: the statistic itself, or for a deviation the variance, which is smooth where it vanishes.
    pub target: Target,
    /// For probabilities: a margin that still tells where to go where the probability is flat at 0 or 1.
    pub margin: Option<Margin>,
}

/// Kind of statistic, which tells how its target relates to it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum MeasureKind {
    /// The target is the statistic.
    Plain,
    /// The target is the square of the statistic.
    Deviation,
    /// The target is the statistic, of which no more is known than it states itself.
    Sampled(Statistic),
    /// A probability.
    Probability(Event),
    /// A probability of responses that are smooth in the random inputs; the target is its index.
    SmoothProbability(Event),
}

/// The distance of a column's mean from a limit, in its standard deviations; grows with the probability of the event.
///
/// ```text
/// above: (m - L)/s   below, up to: (L - m)/s   beyond: (m² - L²)/(D s), D = L + max |m|
/// ```
///
/// where s² = deviation² + (1e-3 of the range of m and the largest deviation together)², so that it exists for a response that does
/// not scatter.
#[derive(Debug, Clone)]
pub(crate) struct Margin {
    pub target: Target,
    event: Event,
    means: Vec<f64>,
    spreads: Vec<f64>,
    size: f64,
}

impl MeasureKind {
    /// The statistic where its target has this value.
    pub fn statistic_of(self, target: f64) -> f64 {
        match self {
            Self::Plain => target,
            Self::Sampled(_) => self.limited(target),
            Self::Deviation => target.max(0.0).sqrt(),
            Self::Probability(_) => target.clamp(0.0, 1.0),
            Self::SmoothProbability(_) => probability_of_index(target),
        }
    }

    /// `value` moved into the range that the statistic can have at all.
    pub fn limited(self, value: f64) -> f64 {
        match self {
            Self::Plain => value,
            Self::Sampled(statistic) => {
                let [least, greatest] = statistic.range();
                value.clamp(least, greatest)
            }
            Self::Deviation => value.max(0.0),
            Self::Probability(_) | Self::SmoothProbability(_) => value.clamp(0.0, 1.0),
        }
    }
}

impl Measure {
    /// Measures `statistic` on the samples of all outer points; nothing for one that is more than a number.
    pub fn new(samples: &[&Sample], statistic: Statistic, confidence: &Confidence) -> Option<Self> {
        Some(match statistic.estimation()? {
            Estimation::Mean => Self::mean(samples, confidence),
            Estimation::RootOfVariance => Self::deviation(samples, confidence),
            Estimation::Ordered(probability) => Self::quantile(samples, probability, confidence),
            Estimation::Counted(event) => Self::probability(samples, event, confidence),
            Estimation::Sampled => Self::sampled(samples, statistic, confidence),
        })
    }

    /// Measures the mean.
    pub fn mean(samples: &[&Sample], confidence: &Confidence) -> Self {
        let at = samples.iter().map(|sample| EitherWay::both(mean(sample, confidence)));
        Self::plain(at, confidence).with_replicates(differences(samples, |values, _| mean_of(values)))
    }

    /// Measures the quantile at `probability`.
    pub fn quantile(samples: &[&Sample], probability: f64, confidence: &Confidence) -> Self {
        let found = samples.iter().map(|sample| quantile_and_slope(sample, confidence, probability));
        let (at, slopes): (Vec<EitherWay>, Vec<f64>) = found.unzip();
        let mut measure = Self::plain(at.into_iter(), confidence);
        // Far out an interval has no end on one side: the noise is that of the replicates, where these are known.
        let replicates = differences_of_quantiles(samples, &measure.target.values, &slopes);
        // Stratified samples may have the same share below it in all replicates: that says nothing.
        if let Some(variance) = variance_of_replicates(&replicates).filter(|variance| *variance > 0.0) {
            measure.target.noise.variance = heard(variance, &measure.target.values);
        }
        measure.with_replicates(replicates)
    }

    /// Measures the probability of `event`.
    pub fn probability(samples: &[&Sample], event: Event, confidence: &Confidence) -> Self {
        Self::probability_with(samples, event, confidence, &ShareLimits::default())
    }

    /// [`Self::probability`] with `limits` that may be known from other events.
    pub fn probability_with(samples: &[&Sample], event: Event, confidence: &Confidence, limits: &ShareLimits) -> Self {
        let at = samples.iter().map(|sample| probability(sample, event, confidence, limits));
        let (low, high): (Vec<Estimate>, Vec<Estimate>) = at.map(|at| (at.low, at.high)).unzip();
        if let Some(target) = index_target(samples, event, &low, confidence) {
            let target_errors = vec![(0.0, 0.0); low.len()];
            return Self {
                kind: MeasureKind::SmoothProbability(event),
                low,
                high,
                target_errors,
                target,
                margin: None,
            };
        }
        let mut target = target(&low, confidence);
        target.resolutions = target.resolutions.map(|resolution| resolution.max(PROBABILITY_RESOLUTION));
        let margin = Margin::new(samples, event, confidence);
        let share =
            |values: &[f64], _| values.iter().filter(|&&value| event.holds(value)).count() as f64 / values.len() as f64;
        Self { kind: MeasureKind::Probability(event), target_errors: errors(&low), low, high, target, margin }
            .with_replicates(differences(samples, share))
    }

    /// Measures the standard deviation, by way of the variance.
    pub fn deviation(samples: &[&Sample], confidence: &Confidence) -> Self {
        let variances: Vec<Estimate> = samples.iter().map(|sample| variance(sample, confidence)).collect();
        let at: Vec<Estimate> = variances.iter().copied().map(standard_deviation).collect();
        let (target, target_errors) = (target(&variances, confidence), errors(&variances));
        let means: Vec<f64> = samples.iter().map(|sample| mean(sample, confidence).value).collect();
        let square = |values: &[f64], point: usize| {
            values.iter().map(|y| (y - means[point]) * (y - means[point])).sum::<f64>() / values.len() as f64
        };
        Self { kind: MeasureKind::Deviation, low: at.clone(), high: at, target_errors, target, margin: None }
            .with_replicates(differences(samples, square))
    }

    /// Measures a statistic by its value for the sample, and for each replicate.
    fn sampled(samples: &[&Sample], statistic: Statistic, confidence: &Confidence) -> Self {
        let at = samples.iter().map(|sample| EitherWay::both(sampled(sample, statistic, confidence)));
        let of = |values: &[f64], _| statistic.of_sorted(&in_order(values.iter().copied()));
        let measure = Self::plain(at, confidence).with_replicates(differences(samples, of));
        Self { kind: MeasureKind::Sampled(statistic), ..measure }
    }

    fn plain(at: impl Iterator<Item = EitherWay>, confidence: &Confidence) -> Self {
        let (low, high): (Vec<Estimate>, Vec<Estimate>) = at.map(|at| (at.low, at.high)).unzip();
        let (target, target_errors) = (target(&low, confidence), errors(&low));
        Self { kind: MeasureKind::Plain, low, high, target_errors, target, margin: None }
    }

    /// This with what the replicates of the sample say of the target; nothing where no noise is seen.
    fn with_replicates(mut self, replicates: Vec<Vec<f64>>) -> Self {
        if self.target.noise.variance > 0.0 {
            self.target.noise.replicates = replicates;
        }
        self
    }

    /// The estimates that tell of the end in `direction`.
    pub fn estimates(&self, direction: Direction) -> &[Estimate] {
        direction.of(&self.low, &self.high)
    }

    /// All that is searched for its extremes.
    pub fn targets(&self) -> impl Iterator<Item = &Target> {
        [Some(&self.target), self.margin.as_ref().map(|margin| &margin.target)].into_iter().flatten()
    }

    /// [`Self::targets`], to be kept.
    pub fn into_targets(self) -> Vec<Target> {
        [Some(self.target), self.margin.map(|margin| margin.target)].into_iter().flatten().collect()
    }
}

impl Margin {
    fn new(samples: &[&Sample], event: Event, confidence: &Confidence) -> Option<Self> {
        let estimates: Vec<Estimate> = samples.iter().map(|sample| mean(sample, confidence)).collect();
        let means: Vec<f64> = estimates.iter().map(|estimate| estimate.value).collect();
        let deviations: Vec<f64> =
            samples.iter().map(|sample| variance(sample, confidence).value.max(0.0).sqrt()).collect();
        let range = range(&means) + deviations.iter().fold(0.0, |most: f64, deviation| most.max(*deviation));
        if range <= 0.0 || !range.is_finite() {
            return None;
        }
        let least = 1e-3 * range;
        let spreads: Vec<f64> =
            deviations.iter().map(|deviation| (deviation * deviation + least * least).sqrt()).collect();
        let largest = means.iter().filter(|mean| mean.is_finite()).fold(0.0, |most: f64, mean| most.max(mean.abs()));
        let size = match event {
            Event::Beyond(limit) => limit + largest,
            _ => 1.0,
        };
        let values: Vec<f64> = means
            .iter()
            .zip(&spreads)
            .map(|(mean, spread)| match event {
                Event::Above(limit) => (mean - limit) / spread,
                Event::Below(limit) | Event::UpTo(limit) => (limit - mean) / spread,
                Event::Beyond(limit) => (mean * mean - limit * limit) / (size * spread),
            })
            .collect();
        let noise: Vec<f64> = estimates
            .iter()
            .zip(&spreads)
            .map(|(estimate, spread)| estimate.variance(confidence) / (spread * spread))
            .collect();
        let nearest =
            values.iter().filter(|value| value.is_finite()).fold(f64::INFINITY, |least, value| least.min(value.abs()));
        // Far from the limit a change of the margin changes next to nothing.
        let resolutions = [0.02 * (1.0 + nearest * nearest); 2];
        let of_mean = differences(samples, |values, point| mean_of(values) / spreads[point]);
        let noise = Noise { variance: finite_mean(&noise), replicates: of_mean };
        let target = Target { values, kind: TargetKind::Plain, noise, resolutions };
        Some(Self { target, event, means, spreads, size })
    }

    /// By how much the sample at `point` must be moved for its margin to become `margin`.
    pub fn shift(&self, point: usize, margin: f64) -> f64 {
        let (mean, spread) = (self.means[point], self.spreads[point]);
        match self.event {
            Event::Above(limit) => limit + margin * spread - mean,
            Event::Below(limit) | Event::UpTo(limit) => limit - margin * spread - mean,
            Event::Beyond(limit) => {
                let magnitude = (limit * limit + margin * self.size * spread).max(0.0).sqrt();
                if mean < 0.0 { -magnitude - mean } else { magnitude - mean }
            }
        }
    }
}

/// The index of the probability of `event` as something to search; nothing where the response is not smooth, or scatters nowhere.
fn index_target(samples: &[&Sample], event: Event, shares: &[Estimate], confidence: &Confidence) -> Option<Target> {
    let spread = |sample: &&Sample| sample.ends().map_or(0.0, |(low, high)| high - low);
    if samples.iter().all(|sample| spread(sample) == 0.0) {
        return None;
    }
    let means: Vec<f64> = samples.iter().map(|sample| mean(sample, confidence).value).collect();
    let largest_spread = samples.iter().map(spread).fold(0.0, f64::max);
    let least_scale = LEAST_SCALE * (range(&means) + largest_spread);
    let index = |sample: &&Sample| Some(sample.smooth()?.index(event, least_scale, sample.values(), confidence));
    let indices: Vec<Index> = samples.iter().map(index).collect::<Option<_>>()?;
    let values: Vec<f64> = indices.iter().map(|index| index.value()).collect();
    let sides: Option<Vec<[f64; 2]>> = indices.iter().map(|index| index.sides()).collect();
    let kind = sides.map_or(TargetKind::Index, |sides| {
        TargetKind::Either([0, 1].map(|side| sides.iter().map(|sides| sides[side]).collect()))
    });
    let change = SMOOTH_PROBABILITY_RESOLUTION * range(&shares.iter().map(|share| share.value).collect::<Vec<f64>>());
    Some(Target { values, kind, noise: Noise::NONE, resolutions: [change; 2] })
}

/// Estimates as something to search the extremes of.
pub(crate) fn target(estimates: &[Estimate], confidence: &Confidence) -> Target {
    let values: Vec<f64> = estimates.iter().map(|estimate| estimate.value).collect();
    let variances: Vec<f64> = estimates.iter().map(|estimate| estimate.variance(confidence)).collect();
    let noise_variance = heard(finite_mean(&variances), &values);
    let least = (SEARCH_RESOLUTION * range(&values)).max(f64::MIN_POSITIVE);
    let resolutions = Direction::BOTH.map(|direction| {
        let error = extreme_point(&values, direction)
            .map_or(0.0, |point| 0.5 * (estimates[point].below + estimates[point].above));
        if error.is_finite() { (SHARE_OF_SAMPLING_ERROR * error).max(least) } else { least }
    });
    let noise = Noise { variance: noise_variance, replicates: Vec::new() };
    Target { values, kind: TargetKind::Plain, noise, resolutions }
}

/// The variance of noise among `values`, 0 where it is negligible.
fn heard(noise_variance: f64, values: &[f64]) -> f64 {
    if noise_variance.sqrt() > NEGLIGIBLE_NOISE * range(values) { noise_variance } else { 0.0 }
}

/// Distances to both ends of the confidence intervals.
fn errors(estimates: &[Estimate]) -> Vec<(f64, f64)> {
    estimates.iter().map(|estimate| (estimate.below, estimate.above)).collect()
}

/// Mean of the finite values, 0 of none.
fn finite_mean(values: &[f64]) -> f64 {
    let (sum, count) = values
        .iter()
        .filter(|value| value.is_finite())
        .fold((0.0, 0.0), |(sum, count), value| (sum + value, count + 1.0));
    if count > 0.0 { sum / count } else { 0.0 }
}

/// Greatest less least of the finite values.
fn range(values: &[f64]) -> f64 {
    let (low, high) = range_of(values.iter().copied().filter(|value| value.is_finite()));
    (high - low).max(0.0)
}

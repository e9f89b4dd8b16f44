//! A statistic at every outer point, and the quantities by which its extremes are searched.

use super::index::Index;
use super::moments::{mean, standard_deviation, variance};
use super::probability::share;
use super::quantile::quantile;
use super::sample::{Confidence, Estimate, Sample};
use super::search::{Direction, SEARCH_RESOLUTION, extreme_point};
use super::statistic::Statistic;
use super::target::{Target, TargetKind};

/// A gain below this share of the sampling error at the extreme is not worth a point.
const SHARE_OF_SAMPLING_ERROR: f64 = 0.1;

/// The same for a probability.
const PROBABILITY_RESOLUTION: f64 = 1e-3;

/// Noise below this share of the range of a target is none: the search never resolves it, and models with noise need not be tried.
const NEGLIGIBLE_NOISE: f64 = 1e-9;

/// The same for a probability of smooth responses, as a share of its range.
const SMOOTH_PROBABILITY_RESOLUTION: f64 = 1e-6;

/// Where a response hardly scatters its probability still has a scale: this share of the range of all responses.
const LEAST_SCALE: f64 = 1e-6;

/// A property of a value, whose probability is asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Event {
    Above(f64),
    Below(f64),
    UpTo(f64),
    Beyond(f64),
}

impl Event {
    /// Whether `value` has the property.
    pub fn holds(self, value: f64) -> bool {
        match self {
            Self::Above(limit) => value > limit,
            Self::Below(limit) => value < limit,
            Self::UpTo(limit) => value <= limit,
            Self::Beyond(limit) => value.abs() > limit,
        }
    }
}

/// A statistic at every outer point.
#[derive(Debug, Clone)]
pub(super) struct Measure {
    pub kind: MeasureKind,
    /// With every failed run taken as low as possible, and as high as possible.
    pub low: Vec<Estimate>,
    pub high: Vec<Estimate>,
    /// Errors of the target's values, downwards and upwards.
    pub target_errors: Vec<(f64, f64)>,
    /// What is searched: the statistic itself, or for a deviation the variance, which is smooth where it vanishes.
    pub target: Target,
    /// For probabilities: a margin that still tells where to go where the probability is flat at 0 or 1.
    pub margin: Option<Margin>,
}

/// What is measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum MeasureKind {
    /// The target is the statistic.
    Plain,
    /// The target is the square of the statistic.
    Deviation,
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
pub(super) struct Margin {
    pub target: Target,
    event: Event,
    means: Vec<f64>,
    spreads: Vec<f64>,
    size: f64,
}

impl Measure {
    /// Measures `statistic`, which is not a whole distribution function, on the samples of all outer points.
    pub fn new(samples: &[&Sample], statistic: Statistic, confidence: &Confidence) -> Option<Self> {
        Some(match statistic {
            Statistic::Mean => {
                let at: Vec<Estimate> = samples.iter().map(|sample| mean(sample, confidence)).collect();
                Self::plain(at.clone(), at, confidence)
            }
            Statistic::StandardDeviation => {
                let variances: Vec<Estimate> = samples.iter().map(|sample| variance(sample, confidence)).collect();
                let at: Vec<Estimate> = variances.iter().copied().map(standard_deviation).collect();
                let target = target(&variances, confidence);
                let target_errors = errors(&variances);
                Self { kind: MeasureKind::Deviation, low: at.clone(), high: at, target_errors, target, margin: None }
            }
            Statistic::Quantile(probability) => {
                let (low, high) = samples
                    .iter()
                    .map(|sample| quantile(sample, confidence, probability))
                    .map(|at| (at.low, at.high))
                    .unzip();
                Self::plain(low, high, confidence)
            }
            Statistic::ProbabilityAbove(limit) => Self::probability(samples, Event::Above(limit), confidence),
            Statistic::ProbabilityBelow(limit) => Self::probability(samples, Event::Below(limit), confidence),
            Statistic::ProbabilityBeyond(limit) => Self::probability(samples, Event::Beyond(limit), confidence),
            Statistic::Cdf | Statistic::SimultaneousBand(_) => return None,
        })
    }

    /// Measures the probability of `event`.
    pub fn probability(samples: &[&Sample], event: Event, confidence: &Confidence) -> Self {
        let (low, high): (Vec<Estimate>, Vec<Estimate>) = samples
            .iter()
            .map(|sample| match sample.smooth() {
                Some(smooth) => {
                    let at = smooth.probability(event, 0.0);
                    (at, at)
                }
                None => {
                    let at = share(sample, confidence, |value| event.holds(value));
                    (at.low, at.high)
                }
            })
            .unzip();
        if let Some(target) = index_target(samples, event, &low, confidence) {
            let target_errors = vec![(0.0, 0.0); low.len()];
            let kind = MeasureKind::SmoothProbability(event);
            return Self { kind, low, high, target_errors, target, margin: None };
        }
        let mut target = target(&low, confidence);
        target.resolutions = target.resolutions.map(|resolution| resolution.max(PROBABILITY_RESOLUTION));
        let margin = Margin::new(samples, event, confidence);
        let target_errors = errors(&low);
        Self { kind: MeasureKind::Probability(event), low, high, target_errors, target, margin }
    }

    /// What is searched for its extremes.
    pub fn into_targets(self) -> Vec<Target> {
        [Some(self.target), self.margin.map(|margin| margin.target)].into_iter().flatten().collect()
    }

    fn plain(low: Vec<Estimate>, high: Vec<Estimate>, confidence: &Confidence) -> Self {
        let target = target(&low, confidence);
        let target_errors = errors(&low);
        Self { kind: MeasureKind::Plain, low, high, target_errors, target, margin: None }
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
        let target = Target { values, kind: TargetKind::Plain, noise_variance: finite_mean(&noise), resolutions };
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
    let index = |sample: &&Sample| Some(sample.smooth()?.index(event, least_scale, sample, confidence));
    let indices: Vec<Index> = samples.iter().map(index).collect::<Option<_>>()?;
    let values: Vec<f64> = indices.iter().map(|index| index.value()).collect();
    let sides: Option<Vec<[f64; 2]>> = indices.iter().map(|index| index.sides()).collect();
    let kind = sides.map_or(TargetKind::Index, |sides| {
        TargetKind::Either([0, 1].map(|side| sides.iter().map(|sides| sides[side]).collect()))
    });
    let change = SMOOTH_PROBABILITY_RESOLUTION * range(&shares.iter().map(|share| share.value).collect::<Vec<f64>>());
    Some(Target { values, kind, noise_variance: 0.0, resolutions: [change; 2] })
}

/// Estimates as something to search the extremes of.
pub(super) fn target(estimates: &[Estimate], confidence: &Confidence) -> Target {
    let values: Vec<f64> = estimates.iter().map(|estimate| estimate.value).collect();
    let variances: Vec<f64> = estimates.iter().map(|estimate| estimate.variance(confidence)).collect();
    let noise_variance = finite_mean(&variances);
    let is_noisy = noise_variance.sqrt() > NEGLIGIBLE_NOISE * range(&values);
    let noise_variance = if is_noisy { noise_variance } else { 0.0 };
    let least = (SEARCH_RESOLUTION * range(&values)).max(f64::MIN_POSITIVE);
    let resolutions = Direction::BOTH.map(|direction| {
        let error = extreme_point(&values, direction)
            .map_or(0.0, |point| 0.5 * (estimates[point].below + estimates[point].above));
        if error.is_finite() { (SHARE_OF_SAMPLING_ERROR * error).max(least) } else { least }
    });
    Target { values, kind: TargetKind::Plain, noise_variance, resolutions }
}

fn errors(estimates: &[Estimate]) -> Vec<(f64, f64)> {
    estimates.iter().map(|estimate| (estimate.below, estimate.above)).collect()
}

fn finite_mean(values: &[f64]) -> f64 {
    let (sum, count) = values
        .iter()
        .filter(|value| value.is_finite())
        .fold((0.0, 0.0), |(sum, count), value| (sum + value, count + 1.0));
    if count > 0.0 { sum / count } else { 0.0 }
}

fn range(values: &[f64]) -> f64 {
    let finite = || values.iter().filter(|value| value.is_finite());
    let (low, high) =
        finite().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(*value), high.max(*value)));
    (high - low).max(0.0)
}

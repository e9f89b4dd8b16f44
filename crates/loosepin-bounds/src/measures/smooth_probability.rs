//! The probability of an event by its index, which guides the search where the probability is flat at 0 or 1.

use super::measure::Measured;
use super::targets::range;
use crate::estimators::estimate::{Confidence, Estimate};
use crate::estimators::index::{Index, probability_of_index};
use crate::estimators::moments::mean;
use crate::estimators::sample::Sample;
use crate::search::models::noise::Noise;
use crate::search::target::{Target, TargetKind};
use loosepin_terms::Event;

/// Gain of a probability of smooth responses that is worth a point, as a share of its range.
const SMOOTH_PROBABILITY_RESOLUTION: f64 = 1e-6;

/// Least scale of a probability where a response hardly scatters: this share of the range of all responses.
const MIN_SCALE: f64 = 1e-6;

/// The probability of this event, of responses that are smooth in the random inputs. Its target is its index.
#[derive(Debug)]
pub(super) struct SmoothProbability(pub Event);

impl Measured for SmoothProbability {
    fn event(&self) -> Option<Event> {
        Some(self.0)
    }

    fn limited(&self, value: f64) -> f64 {
        value.clamp(0.0, 1.0)
    }

    fn statistic_of(&self, target: f64) -> f64 {
        probability_of_index(target)
    }

    fn compared(&self, _target: f64, estimate: f64) -> f64 {
        estimate
    }

    fn reached(&self, value: f64, attained: f64, most: f64) -> f64 {
        self.limited(value + (probability_of_index(most) - probability_of_index(attained)))
    }
}

/// The index of the probability of `event` as something to search; `None` if the response is not smooth, or scatters nowhere.
pub(super) fn index_target(
    samples: &[&Sample],
    event: Event,
    shares: &[Estimate],
    confidence: &Confidence,
) -> Option<Target> {
    let spread = |sample: &&Sample| sample.ends().map_or(0.0, |(low, high)| high - low);
    if samples.iter().all(|sample| spread(sample) == 0.0) {
        return None;
    }
    let means: Vec<f64> = samples.iter().map(|sample| mean(sample, confidence).value).collect();
    let largest_spread = samples.iter().map(spread).fold(0.0, f64::max);
    let least_scale = MIN_SCALE * (range(&means) + largest_spread);
    let index = |sample: &&Sample| Some(sample.smooth()?.index(event, least_scale, sample.values()));
    let indices: Vec<Index> = samples.iter().map(index).collect::<Option<_>>()?;
    let values: Vec<f64> = indices.iter().map(|index| index.value()).collect();
    let sides: Option<Vec<[f64; 2]>> = indices.iter().map(|index| index.sides()).collect();
    let kind = sides.map_or(TargetKind::Index, |sides| {
        TargetKind::Either([0, 1].map(|side| sides.iter().map(|sides| sides[side]).collect()))
    });
    let change = SMOOTH_PROBABILITY_RESOLUTION * range(&shares.iter().map(|share| share.value).collect::<Vec<f64>>());
    Some(Target { values, kind, noise: Noise::NONE, resolutions: [change; 2] })
}

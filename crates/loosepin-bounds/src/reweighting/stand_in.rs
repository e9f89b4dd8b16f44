//! Polynomials that stand for a smooth response at every u.

use std::sync::Arc;

use rayon::prelude::*;

use super::ground::Ground;
use crate::inner_basis::{CrossFit, Design};
use crate::measure::Sought;
use crate::moments::{mean, standard_deviation, variance};
use crate::quantile::quantile;
use crate::sample::{Confidence, Estimate, Sample};
use crate::search::Direction;
use crate::search_box::Place;
use crate::smooth::smooth;
use loosepin_uncertainty::RandomVariable;

/// Polynomials that leave no more than this share of the deviation of the pool at any run stand for the response; between the runs it
/// may be more, by the second factor.
const LARGEST_RESIDUAL: f64 = 1e-3;
const RESIDUAL_MARGIN: f64 = 2.0;

/// Polynomials that stand for the response at every u.
#[derive(Debug)]
pub struct StandIn {
    ground: Arc<Ground>,
    design: Arc<Design>,
    fit: CrossFit,
    /// A sample at each place.
    pub samples: Vec<Sample>,
    /// How far the response may be from them.
    left: f64,
}

impl StandIn {
    /// Polynomials of `design` where they follow every run, `deviation` that of all of them; else nothing.
    pub fn new(ground: &Arc<Ground>, (design, fit): (&Arc<Design>, &CrossFit), deviation: f64) -> Option<Self> {
        let basis = ground.basis.as_deref()?;
        let left = fit.residuals.iter().fold(0.0_f64, |most, left| most.max(left.abs()));
        if left > LARGEST_RESIDUAL * deviation {
            return None;
        }
        let sample = |variables: Vec<RandomVariable>| Self::sample(ground, (design, fit), &variables);
        let at = |place: &Place| ground.variables(place).map(sample);
        let mut samples: Vec<Sample> = ground.seen.par_iter().map(|seen| at(&seen.place)).collect::<Option<_>>()?;
        smooth(basis, &mut samples.iter_mut().collect::<Vec<_>>());
        let is_smooth = samples.iter().all(|sample| sample.smooth().is_some());
        let (ground, design, fit) = (ground.clone(), design.clone(), fit.clone());
        is_smooth.then_some(Self { ground, design, fit, samples, left: RESIDUAL_MARGIN * left })
    }

    /// The sample at `variables`, without its polynomials.
    fn sample(ground: &Ground, by: (&Design, &CrossFit), variables: &[RandomVariable]) -> Sample {
        let values = ground.expected(by, variables, ground.layout.each, false);
        Sample::new(values.chunks(ground.layout.each).map(|own| own.iter().copied()))
    }

    /// The sample at `place`; nothing where the polynomials are not smooth there.
    pub fn at(&self, place: &Place) -> Option<Sample> {
        let mut sample = Self::sample(&self.ground, (&self.design, &self.fit), &self.ground.variables(place)?);
        smooth(self.ground.basis.as_deref()?, &mut [&mut sample]);
        sample.smooth().is_some().then_some(sample)
    }

    /// By how much the statistic of `sample` may lie beyond `value`.
    pub fn gain(
        &self,
        sample: &Sample,
        sought: Sought,
        direction: Direction,
        value: f64,
        confidence: &Confidence,
    ) -> Option<f64> {
        let (sign, left) = (direction.sign(), self.left);
        let outward = |at: Estimate| {
            let error = if direction == Direction::Maximum { at.above } else { at.below };
            sign * at.value + error
        };
        let gain = match sought {
            Sought::Mean => outward(mean(sample, confidence)) + left - sign * value,
            Sought::Variance => {
                let deviation = (sign * (outward(standard_deviation(variance(sample, confidence))) + left)).max(0.0);
                sign * (deviation * deviation - value * value)
            }
            Sought::Quantile(probability) => {
                let at = quantile(sample, confidence, probability);
                outward(if direction == Direction::Maximum { at.high } else { at.low }) + left - sign * value
            }
            Sought::Probability(event) => {
                let smooth = sample.smooth()?;
                let moved = [left, -left].map(|shift| outward(smooth.probability(event, shift)));
                moved[0].max(moved[1]) - sign * value
            }
        };
        Some(gain)
    }
}

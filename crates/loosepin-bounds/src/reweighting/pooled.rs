//! One column of the pool: by how much its statistics may lie beyond those at an outer point.

use std::sync::Arc;

use rayon::prelude::*;

use super::Beyond;
use super::climb::climb;
use super::gains::Gain;
use super::ground::Ground;
use super::stand_in::StandIn;
use super::weights::Seen;
use crate::inner_basis::{CrossFit, Design};
use crate::measure::Sought;
use crate::sample::{Confidence, Sample};
use crate::search::{Direction, SEARCH_RESOLUTION};
use crate::search_box::{Place, Region};

/// Weights must be worth so many independent runs.
const LEAST_EFFECTIVE: f64 = 64.0;
/// Of these so many must lie beyond a quantile.
pub const LEAST_BEYOND: f64 = 8.0;
/// Polynomials of a higher degree only stand for a response that they follow everywhere.
const MOST_DEGREE_BESIDE: usize = 4;
/// A polynomial of a higher degree must leave less of the squares by this factor: else it follows what it should not.
const CLEARLY_LESS: f64 = 0.7;

/// The furthest places are moved on by steps from the first length down to the last, in units of the box: of polynomials, of weights, and
/// of weights where there are many columns.
const STEPS_OF_POLYNOMIALS: [f64; 2] = [0.05, 1e-4];
const STEPS_OF_WEIGHTS: [f64; 2] = [0.05, 0.003];
const STEPS_OF_CURVES: [f64; 2] = [0.05, 0.0125];
/// From so many of the places the search goes on by steps, each so far from the others; from fewer where there are many columns.
const STARTS: usize = 3;
const STARTS_OF_CURVES: usize = 1;
const STARTS_APART: f64 = 0.1;

/// One column of the pool.
#[derive(Debug)]
pub struct Pooled {
    pub ground: Arc<Ground>,
    by: By,
}

/// What tells the column at other u.
#[derive(Debug)]
enum By {
    Polynomials(Box<StandIn>),
    Weights(Weighted),
}

/// The runs themselves, weighted, beside polynomials.
#[derive(Debug)]
pub struct Weighted {
    pub ground: Arc<Ground>,
    /// Values of the runs, replicate by replicate.
    pub values: Vec<f64>,
    /// The runs in the order of their values.
    pub order: Vec<usize>,
    /// Those of the polynomials, each replicate by the other ones; the mean of all runs where there are none.
    pub explained: Vec<f64>,
    polynomials: Option<(Arc<Design>, CrossFit)>,
    mean: f64,
    /// The polynomials at points at each place, replicate by replicate.
    expected: Vec<Vec<f64>>,
}

/// The column as it is seen from a place.
#[derive(Debug, Clone, Copy)]
pub struct At<'a> {
    pub seen: &'a Seen,
    /// The polynomials at points there, replicate by replicate.
    pub expected: &'a [f64],
    /// Whether it is the outer point that others are compared with.
    pub is_witness: bool,
}

impl Pooled {
    /// One column; nothing where a run failed.
    pub fn new(ground: &Arc<Ground>, designs: &[Arc<Design>], samples: &[&Sample]) -> Option<Self> {
        if samples.iter().any(|sample| sample.failed() > 0) {
            return None;
        }
        let (each, replicates) = (ground.layout.each, ground.layout.replicates);
        let mut values = Vec::with_capacity(ground.layout.runs() * replicates);
        for replicate in 0..replicates {
            for sample in samples {
                values.extend_from_slice(&sample.values()[replicate * each..(replicate + 1) * each]);
            }
        }
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let spread = values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>();
        let is_smooth = samples.iter().all(|sample| sample.smooth().is_some());
        if let Some((design, fit)) = is_smooth.then(|| best(designs, usize::MAX, &values, spread)).flatten() {
            let deviation = (spread / values.len() as f64).sqrt();
            if let Some(stand_in) = StandIn::new(ground, (&design, &fit), deviation) {
                return Some(Self { ground: ground.clone(), by: By::Polynomials(Box::new(stand_in)) });
            }
        }
        let polynomials = best(designs, MOST_DEGREE_BESIDE, &values, spread);
        let weighted = Weighted::new(ground, values, polynomials, mean)?;
        Some(Self { ground: ground.clone(), by: By::Weights(weighted) })
    }

    /// Whether the polynomials stand for the response.
    pub fn is_smooth(&self) -> bool {
        matches!(self.by, By::Polynomials(_))
    }

    /// Independent runs that the weights must be worth.
    fn needed(&self, sought: Sought) -> f64 {
        match sought {
            // Polynomials only need runs wherever they are asked.
            _ if self.is_smooth() => LEAST_EFFECTIVE,
            Sought::Quantile(probability) => (LEAST_BEYOND / probability.min(1.0 - probability)).max(LEAST_EFFECTIVE),
            Sought::Mean | Sought::Variance | Sought::Probability(_) => LEAST_EFFECTIVE,
        }
    }

    /// Where the statistic, `value` at the outer point `witness`, goes furthest beyond that in `region`, errors conceded.
    ///
    /// # Errors
    ///
    /// A place at which the pool cannot tell.
    pub fn furthest(
        &self,
        sought: Sought,
        direction: Direction,
        (witness, value): (usize, f64),
        region: &Region,
        confidence: &Confidence,
    ) -> Result<Beyond, Place> {
        let seen = &self.ground.seen;
        let needed = self.needed(sought);
        let places: Vec<usize> = (0..seen.len()).filter(|&k| region.holds(&seen[k].place.at)).collect();
        let worth = |place: usize| if self.is_smooth() { seen[place].covering } else { seen[place].effective };
        let least = places.iter().min_by(|&&a, &&b| worth(a).total_cmp(&worth(b)));
        if let Some(unseen) = least.filter(|&&place| worth(place) < needed) {
            return Err(seen[*unseen].place.clone());
        }
        let found = match &self.by {
            By::Polynomials(stand_in) => {
                let gain = |sample: &Sample| stand_in.gain(sample, sought, direction, value, confidence);
                // The runs at an outer point speak for themselves.
                let outer = self.ground.layout.outer;
                let at = |place: usize| if place < outer { Some(0.0) } else { gain(&stand_in.samples[place]) };
                let anywhere = |place: &Place| gain(&stand_in.at(place)?);
                self.search((witness, &places), region, STEPS_OF_POLYNOMIALS, at, anywhere)?
            }
            By::Weights(weighted) => {
                let gain: Gain<'_> = weighted.gain(sought, direction, (witness, value), confidence);
                let at = |place: usize| gain(&weighted.at(place, witness));
                let anywhere = |place: &Place| {
                    let seen = self.ground.seen_from(place).filter(|seen| seen.effective >= needed)?;
                    let expected = weighted.expected(&seen)?;
                    gain(&At { seen: &seen, expected: &expected, is_witness: false })
                };
                let steps = if self.ground.is_of_curves { STEPS_OF_CURVES } else { STEPS_OF_WEIGHTS };
                self.search((witness, &places), region, steps, at, anywhere)?
            }
        };
        Ok(found)
    }

    /// The largest gain `at` any of `places`, then up from the furthest of them by steps.
    fn search(
        &self,
        (witness, places): (usize, &[usize]),
        region: &Region,
        steps: [f64; 2],
        at: impl Fn(usize) -> Option<f64> + Sync,
        anywhere: impl Fn(&Place) -> Option<f64> + Sync,
    ) -> Result<Beyond, Place> {
        let place = |k: usize| &self.ground.seen[k].place;
        let known = |k: usize| at(k).filter(|gain| !gain.is_nan()).ok_or_else(|| place(k).clone());
        let gains: Vec<f64> = places.par_iter().map(|&k| known(k)).collect::<Result<_, _>>()?;
        let mut order: Vec<usize> = (0..places.len()).collect();
        order.sort_by(|&a, &b| gains[b].total_cmp(&gains[a]));
        let most = if self.ground.is_of_curves { STARTS_OF_CURVES } else { STARTS };
        let axes = self.ground.epistemic_box.axes();
        // From the outer point as well, whose own gain is 0 by its runs.
        let mut starts: Vec<&Place> = if self.ground.is_of_curves { Vec::new() } else { vec![place(witness)] };
        for k in order.iter().map(|&k| place(places[k])) {
            if starts.len() < most && starts.iter().all(|other| axes.distance(other, k) > STARTS_APART) {
                starts.push(k);
            }
        }
        let mut beyond = Beyond { gain: 0.0, place: place(witness).clone() };
        if let Some(&best) = order.first().filter(|&&best| gains[best] > 0.0) {
            beyond = Beyond { gain: gains[best], place: place(places[best]).clone() };
        }
        let climbed: Vec<Beyond> = starts
            .into_par_iter()
            .map(|start| climb(axes, start.clone(), region, steps, &anywhere))
            .collect::<Result<_, _>>()?;
        for climbed in climbed {
            if climbed.gain > beyond.gain {
                beyond = climbed;
            }
        }
        // What a search does not resolve, as in the one without weights.
        if let (Some(&best), Some(&least)) = (order.first(), order.last()) {
            beyond.gain += SEARCH_RESOLUTION * (gains[best] - gains[least]);
        }
        Ok(beyond)
    }

    /// How far `h` of the response may go in `direction` at the outer point `witness` itself, in units of what is searched, by the runs of
    /// all points: those at this point alone may agree by chance (each replicate of a stratified sample meets a jump as often as the
    /// others), or hit a rare event too often. Nothing where polynomials stand for the response, and for quantiles.
    pub fn outermost(
        &self,
        sought: Sought,
        direction: Direction,
        witness: usize,
        confidence: &Confidence,
    ) -> Option<f64> {
        let By::Weights(weighted) = &self.by else { return None };
        weighted.outermost(sought, direction, witness, confidence)
    }
}

impl Weighted {
    fn new(
        ground: &Arc<Ground>,
        values: Vec<f64>,
        polynomials: Option<(Arc<Design>, CrossFit)>,
        mean: f64,
    ) -> Option<Self> {
        let explained = match &polynomials {
            Some((_, fit)) => values.iter().zip(&fit.residuals).map(|(value, left)| value - left).collect(),
            None => vec![mean; values.len()],
        };
        let mut order: Vec<usize> = (0..values.len()).collect();
        order.sort_by(|&a, &b| values[a].total_cmp(&values[b]));
        let ground = ground.clone();
        let mut weighted = Self { ground, values, order, explained, polynomials, mean, expected: Vec::new() };
        weighted.expected =
            weighted.ground.seen.par_iter().map(|seen| weighted.expected(seen)).collect::<Option<_>>()?;
        Some(weighted)
    }

    /// The polynomials at points at a place, replicate by replicate.
    fn expected(&self, seen: &Seen) -> Option<Vec<f64>> {
        let ground = &self.ground;
        match &self.polynomials {
            Some((design, fit)) => {
                Some(ground.expected((design, fit), &ground.variables(&seen.place)?, ground.points, true))
            }
            None => Some(vec![self.mean; ground.points * ground.layout.replicates]),
        }
    }

    /// The column from one of the places that all are compared at.
    pub fn at(&self, place: usize, witness: usize) -> At<'_> {
        At { seen: &self.ground.seen[place], expected: &self.expected[place], is_witness: place == witness }
    }
}

/// The polynomials up to `most_degree` that leave clearly the least; nothing where none leaves less than the mean.
fn best(designs: &[Arc<Design>], most_degree: usize, values: &[f64], spread: f64) -> Option<(Arc<Design>, CrossFit)> {
    let mut least = spread;
    let mut best = None;
    for design in designs.iter().filter(|design| design.degree <= most_degree) {
        let fit = design.fit(values);
        let left = fit.residuals.iter().map(|left| left * left).sum::<f64>();
        if left < CLEARLY_LESS * least {
            least = left;
            best = Some((design.clone(), fit));
        }
    }
    best
}

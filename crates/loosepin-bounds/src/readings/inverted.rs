//! The probability of an event by quantiles, where its own model leaves it wide.
//!
//! ```text
//! P(Y > L | u) <= p for every u,   where the greatest quantile of Y at 1 - p over u does not exceed L
//! P(Y > L | u) >  p for every u,   where the least one exceeds L
//! ```
//!
//! The models of a probability search its index or the margin to the limit, a distance in standard deviations of the response. Where the
//! response hardly scatters at some u, as where play alone reaches every deviation, these have a spike, and a model of a spike excludes
//! nothing. A quantile has the unit of the response, and no spike there. Its bound includes all errors of its own: sampling, the search over
//! u, failed runs. So the least p for which the bound of the quantile keeps the limit is a bound of the probability.

use super::experiment::{Experiment, Focal};
use super::interval::Modelled;
use crate::data::bound::{Bound, BoundError};
use crate::data::direction::Direction;
use crate::estimators::sample::Sample;
use crate::measures::measure::Estimator;
use crate::measures::quantile::Quantile;
use loosepin_terms::Event;
use loosepin_uncertainty::{normal_cdf, normal_quantile};

/// An error of the search below this is not worth another model: a tenth of a per cent of the mechanisms.
const LARGE_ERROR: f64 = 1e-3;

/// Halvings of the range of z = Φ⁻¹(p), which leave less than 0.003 of z, and the probability at which that range ends.
const HALVINGS: usize = 12;
const LEAST_PROBABILITY: f64 = 1e-6;

/// Of the probability at which nothing is added for the search: its quantile ends at an order statistic, which round-off would miss.
const ROUND_OFF: f64 = 1e-9;

/// What is searched: the extreme of the probability of an event of these samples over a part of the box.
#[derive(Clone, Copy)]
struct Sought<'a> {
    samples: &'a [&'a Sample],
    event: Event,
    direction: Direction,
    focal: &'a Focal<'a>,
}

impl Experiment<'_> {
    /// `bound` of the probability of `event` in `direction` over `focal`, with no larger error of the search than quantiles of the `samples` leave it.
    pub(super) fn narrowed_by_quantiles(
        &self,
        bound: Bound,
        event: Event,
        samples: &[&Sample],
        direction: Direction,
        focal: &Focal<'_>,
    ) -> Bound {
        if !(bound.error.optimisation > LARGE_ERROR && bound.value.is_finite()) {
            return bound;
        }
        let least = bound.value + direction.sign() * bound.error.sampling;
        let sought = Sought { samples, event, direction, focal };
        let shown = self.shown_probability(&sought, [least, bound.widened]);
        let optimisation = (direction.sign() * (shown - least)).max(0.0).min(bound.error.optimisation);
        let error = BoundError { optimisation, ..bound.error };
        Bound { widened: error.widen(bound.value, direction).clamp(0.0, 1.0), error, ..bound }
    }

    /// The probability nearest to `from` at which quantiles keep the limit; `to` where none does.
    fn shown_probability(&self, sought: &Sought<'_>, ends: [f64; 2]) -> f64 {
        let Event::Beyond(limit) = sought.event else { return self.shown_of_one(sought, ends) };
        if sought.samples.iter().all(|sample| sample.smooth().is_none()) {
            let magnitudes: Vec<Sample> = sought.samples.iter().map(|sample| sample.magnitudes()).collect();
            let samples: Vec<&Sample> = magnitudes.iter().collect();
            return self.shown_of_one(&Sought { samples: &samples, event: Event::Above(limit), ..*sought }, ends);
        }
        // Magnitudes are not smooth: both sides have their quantiles by polynomials, and their probabilities add.
        let sides = [Event::Above(limit), Event::Below(-limit)];
        let side = |event| self.shown_of_one(&Sought { event, ..*sought }, ends_of_side(sought.direction, ends[1]));
        sides.into_iter().map(side).sum::<f64>().clamp(0.0, 1.0)
    }

    /// [`Self::shown_probability`] of an event with one edge.
    fn shown_of_one(&self, sought: &Sought<'_>, [from, to]: [f64; 2]) -> f64 {
        let within = |probability: f64| probability.clamp(LEAST_PROBABILITY, 1.0 - LEAST_PROBABILITY);
        let away = sought.direction.sign() * ROUND_OFF;
        let nearest = within(from + away * from.min(1.0 - from));
        if self.is_shown(sought, nearest) {
            return nearest;
        }
        let (mut near, mut far, mut shown) = (normal_quantile(nearest), normal_quantile(within(to)), to);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (near + far);
            let probability = normal_cdf(middle);
            if self.is_shown(sought, probability) {
                (far, shown) = (middle, probability);
            } else {
                near = middle;
            }
        }
        shown
    }

    /// Whether a bound of a quantile shows that no probability in the part of the box lies beyond `probability`.
    fn is_shown(&self, sought: &Sought<'_>, probability: f64) -> bool {
        let &Sought { samples, event, direction, focal } = sought;
        let (level, end) = match event {
            Event::Above(_) | Event::Beyond(_) => (1.0 - probability, direction),
            Event::Below(_) | Event::UpTo(_) => (probability, direction.opposite()),
        };
        let measure = Quantile(level).measure(samples, &self.setup.confidence);
        let search = self.search([&measure].into_iter());
        let quantile = self.bound(&Modelled::new(&search, &measure, samples), end, focal).widened;
        // Where the whole of it lies on one side of the limit, the event holds there or it does not.
        quantile.is_finite() && event.holds(quantile) == (direction == Direction::Minimum)
    }
}

/// Where the probability of one side is looked for, if that of both together lies within `of_both`: it is at most as large as both, and may
/// be 0 however large the other side is.
fn ends_of_side(direction: Direction, of_both: f64) -> [f64; 2] {
    direction.of([1.0, 0.0], [0.0, of_both])
}

#[cfg(test)]
mod tests {
    use super::ends_of_side;
    use crate::data::direction::Direction;

    /// Both sides of |Y| > L with Y ~ N(0, 1) and P = 0.5: where nothing is shown of either, the sum of their ends must not pass what was known
    /// of both.
    #[test]
    fn analytic_two_sides_of_which_nothing_is_shown_say_no_more_than_both_together() {
        let known = 0.29;
        let [_, least] = ends_of_side(Direction::Minimum, known);
        assert!(least + least <= known, "each side may be 0: {least}");
        let [_, most] = ends_of_side(Direction::Maximum, known);
        assert!(most + most >= known && most >= known, "each side may be all of it: {most}");
    }
}

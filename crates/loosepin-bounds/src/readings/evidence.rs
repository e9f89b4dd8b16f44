//! Statistics over several focal elements: masses add (A. P. Dempster 1967, G. Shafer 1976).

use super::added_quantile::QuantileJob;
use super::experiment::{Experiment, Focal};
use super::interval::Modelled;
use crate::data::bound::{Bound, BoundPair};
use crate::data::direction::Direction;
use crate::data::problem::Request;
use crate::estimators::estimate::Estimate;
use crate::measures::measure::Measure;
use crate::parallel;
use crate::search::models::of_points::Search;
use loosepin_terms::Estimation;

impl Experiment<'_> {
    /// Bounds of all `requests` over `elements`, together.
    pub fn pairs_over_elements(
        &self,
        requests: &[Request],
        measures: &[Option<Measure>],
        search: &Search<'_>,
        elements: &[Focal<'_>],
    ) -> Vec<BoundPair> {
        let is_one = elements.len() == 1;
        let centre = self.centre(elements);
        let jobs: Vec<QuantileJob> = requests
            .iter()
            .filter(|_| !is_one)
            .filter_map(|request| Some((request.column, request.statistic.probability_of_quantile()?)))
            .flat_map(|(column, probability)| {
                Direction::BOTH.map(|direction| QuantileJob { column, probability, direction })
            })
            .collect();
        let quantiles: Vec<Bound> = self.quantiles(&jobs, elements);
        let pairs = parallel::map_indices(requests.len(), |index| {
            let (Request { column, statistic }, measure) = (requests[index], &measures[index]);
            let samples = self.pool.samples(column);
            let measure = measure.as_ref()?;
            let modelled = Modelled::new(search, measure, &samples);
            let ends = match statistic.estimation()? {
                Estimation::Ordered(probability) if !is_one => Direction::BOTH.map(|direction| {
                    let job = QuantileJob { column, probability, direction };
                    let place = jobs.iter().position(|known| *known == job);
                    place.map_or_else(|| self.unknown(direction), |place| quantiles[place].clone())
                }),
                Estimation::RootOfVariance if !is_one || self.is_mixed() => self.deviations(column, elements),
                // A mean over a mixture is the sum of mass times mean; a probability is the mean of a hit.
                Estimation::Mean | Estimation::Counted(_) => {
                    Direction::BOTH.map(|direction| self.added(&modelled, elements, direction))
                }
                // Of one element nothing is added.
                Estimation::Ordered(_) | Estimation::RootOfVariance => {
                    Direction::BOTH.map(|direction| self.bound(&modelled, direction, &elements[0]))
                }
                // What it is of a mixture is not known.
                Estimation::Sampled => Direction::BOTH.map(|direction| self.unknown_of(statistic, direction)),
            };
            let at: Vec<f64> = measure.low.iter().map(Estimate::lower_limit).collect();
            // Of several elements the sum has been attained, at no single point.
            let seen = if is_one {
                at
            } else {
                Direction::BOTH.map(|direction| sum_of_extremes(elements, &at, direction)).to_vec()
            };
            let central = centre.map(|point| modelled.at(point));
            Some(BoundPair { seen, central, ..BoundPair::new(column, statistic, ends, self.failed_runs(column)) })
        });
        pairs.into_iter().flatten().collect()
    }
}

/// Sum of mass times the extreme of the `values` at the outer points of each element; NaN if an element has none.
fn sum_of_extremes(elements: &[Focal<'_>], values: &[f64], direction: Direction) -> f64 {
    let extreme = |element: &Focal<'_>| {
        let own = element.members.iter().map(|&point| values[point]).filter(|value| value.is_finite());
        own.reduce(|a, b| direction.further(a, b)).unwrap_or(f64::NAN)
    };
    elements.iter().map(|element| element.mass * extreme(element)).sum()
}

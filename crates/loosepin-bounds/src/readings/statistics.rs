//! Bounds of all single statistics, cut by cut.

use super::experiment::{Experiment, Focal};
use super::interval::Modelled;
use crate::data::bound::{BoundPair, CutBounds};
use crate::data::direction::Direction;
use crate::data::problem::{Reading, Request};
use crate::estimators::estimate::Estimate;
use crate::estimators::sample::Sample;
use crate::measures::measure::Measure;
use crate::measures::of_statistic::{estimator, work_out};
use crate::parallel;
use crate::search::models::of_points::{Search, TARGETS_AT_ONCE};
use crate::search::parts::Cut;

/// More probabilities than this, as those at every pose of several curves, have their own models alone: quantiles take up to 26 more of each side of a limit.
const MOST_NARROWED: usize = 128;

impl Experiment<'_> {
    /// The bounds over every α-cut, what is possible at all first; those over a cut hold those over the cuts within it.
    pub fn cuts(&self) -> Vec<CutBounds> {
        let requests = self.setup.single_statistics();
        let confidence = &self.setup.confidence;
        work_out(self.pool, &requests, confidence);
        let measures: Vec<Option<Measure>> = parallel::map(&requests, |request| {
            Some(estimator(request.statistic)?.measure(&self.pool.samples(request.column), confidence))
        });
        let search = self.search(measures.iter().flatten());
        let of_cut = |cut: &Cut| CutBounds { alpha: cut.alpha, pairs: self.pairs(&requests, &measures, &search, cut) };
        let mut cuts: Vec<CutBounds> = self.setup.structure.cuts.iter().map(of_cut).collect();
        nest(&mut cuts);
        cuts
    }

    fn pairs(
        &self,
        requests: &[Request],
        measures: &[Option<Measure>],
        search: &Search<'_>,
        cut: &Cut,
    ) -> Vec<BoundPair> {
        let elements = self.focal_elements(cut);
        match (self.setup.problem.reading, &elements[..]) {
            (Reading::RandomSet, _) => self.pairs_of_random_set(requests, &elements),
            (_, [whole]) if !self.is_mixed() => self.pairs_over(requests, measures, search, whole),
            _ => self.pairs_over_elements(requests, measures, search, &elements),
        }
    }

    /// Bounds where u is one value, the same for every sample, anywhere in the box.
    fn pairs_over(
        &self,
        requests: &[Request],
        measures: &[Option<Measure>],
        search: &Search<'_>,
        whole: &Focal<'_>,
    ) -> Vec<BoundPair> {
        let centre = self.centre(std::slice::from_ref(whole));
        let are_narrowed = requests.iter().filter(|own| own.statistic.event().is_some()).count() <= MOST_NARROWED;
        let pair = |(&Request { column, statistic }, modelled): (&Request, &Modelled<'_>)| {
            let ends = Direction::BOTH.map(|direction| {
                let bound = self.bound(modelled, direction, whole);
                match modelled.measure.of.event().filter(|_| are_narrowed) {
                    Some(event) => {
                        self.narrowed_by_quantiles(bound, event, &self.pool.samples(column), direction, whole)
                    }
                    None => bound,
                }
            });
            let seen = modelled.measure.low.iter().map(Estimate::lower_limit).collect();
            let central = centre.map(|point| modelled.at(point));
            BoundPair { seen, central, ..BoundPair::new(column, statistic, ends, self.failed_runs(column)) }
        };
        let chunks: Vec<(&[Request], &[Option<Measure>])> =
            requests.chunks(TARGETS_AT_ONCE).zip(measures.chunks(TARGETS_AT_ONCE)).collect();
        parallel::flat_map(&chunks, |(requests, measures)| {
            let samples: Vec<Vec<&Sample>> = requests.iter().map(|request| self.pool.samples(request.column)).collect();
            let modelled = Modelled::all(search, measures, &samples);
            let pairs =
                requests.iter().zip(&modelled).filter_map(|(request, own)| Some(pair((request, own.as_ref()?))));
            pairs.collect::<Vec<BoundPair>>()
        })
    }
}

/// Widens the bounds of every cut to those of the cuts within it.
fn nest(cuts: &mut [CutBounds]) {
    for cut in (1..cuts.len()).rev() {
        let (outer, inner) = cuts.split_at_mut(cut);
        for (outer, inner) in outer[cut - 1].pairs.iter_mut().zip(&inner[0].pairs) {
            outer.lower.widen_to(inner.lower.widened, Direction::Minimum);
            outer.upper.widen_to(inner.upper.widened, Direction::Maximum);
        }
    }
}

//! Which estimator is right for a statistic.

use std::collections::BTreeMap;

use super::mean::Mean;
use super::measure::Estimator;
use super::probability::Probability;
use super::quantile::Quantile;
use super::sampled::Sampled;
use super::standard_deviation::StandardDeviation;
use crate::data::problem::Request;
use crate::estimators::estimate::Confidence;
use crate::estimators::ordered::Ordered;
use crate::estimators::pool::Pool;
use crate::parallel;
use loosepin_terms::{Estimation, Statistic};

/// The estimator of `statistic`; `None` if it is more than one number.
pub(crate) fn estimator(statistic: Statistic) -> Option<Box<dyn Estimator>> {
    Some(match statistic.estimation()? {
        Estimation::Mean => Box::new(Mean),
        Estimation::RootOfVariance => Box::new(StandardDeviation),
        Estimation::Ordered(probability) => Box::new(Quantile(probability)),
        Estimation::Counted(event) => Box::new(Probability(event)),
        Estimation::Sampled => Box::new(Sampled(statistic)),
    })
}

/// Computes everything that `requests` need of each sample of `pool`, column by column: queries of the same sample share the order of its
/// values.
pub(crate) fn work_out(pool: &Pool, requests: &[Request], confidence: &Confidence) {
    let mut columns: BTreeMap<usize, Vec<Statistic>> = BTreeMap::new();
    for request in requests {
        columns.entry(request.column).or_default().push(request.statistic);
    }
    let columns: Vec<(usize, Vec<Statistic>)> = columns.into_iter().collect();
    parallel::for_each_index(columns.len(), &|index| {
        let (column, statistics) = &columns[index];
        let estimators: Vec<Box<dyn Estimator>> = statistics.iter().copied().filter_map(estimator).collect();
        for sample in pool.samples(*column) {
            let ordered = Ordered::new(sample);
            estimators.iter().for_each(|estimator| estimator.work_out(&ordered, confidence));
        }
    });
}

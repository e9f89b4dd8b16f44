//! Several statistics of one sample, which share the order of its values.

use super::estimate::Confidence;
use super::known::Asked;
use super::moments::{mean_of_ordered, variance_of_ordered};
use super::ordered::Ordered;
use super::quantile::quantile_of_ordered;
use super::sample::Sample;
use super::sampled::sampled_of_ordered;
use crate::data::statistic::{Estimation, Statistic};

/// Works out what `statistics` need of `sample`, which keeps it.
pub(crate) fn work_out(sample: &Sample, statistics: &[Statistic], confidence: &Confidence) {
    if sample.known().has(statistics.iter().filter_map(|statistic| asked(*statistic)), confidence) {
        return;
    }
    let ordered = Ordered::new(sample);
    for &statistic in statistics {
        match statistic.estimation() {
            Some(Estimation::Mean) => {
                mean_of_ordered(&ordered, confidence);
            }
            Some(Estimation::RootOfVariance) => {
                mean_of_ordered(&ordered, confidence);
                variance_of_ordered(&ordered, confidence);
            }
            Some(Estimation::Ordered(probability)) => {
                quantile_of_ordered(&ordered, confidence, probability);
            }
            Some(Estimation::Sampled) => {
                sampled_of_ordered(&ordered, statistic, confidence);
            }
            // Shares of runs are counted, not read off an order.
            Some(Estimation::Counted(_)) | None => {}
        }
    }
}

/// What is kept of a statistic; nothing where shares of runs are counted. A deviation is kept after the mean that it needs.
fn asked(statistic: Statistic) -> Option<Asked> {
    match statistic.estimation()? {
        Estimation::Mean => Some(Asked::Mean),
        Estimation::RootOfVariance => Some(Asked::Variance),
        Estimation::Ordered(probability) => Some(Asked::Quantile(probability)),
        Estimation::Sampled => Some(Asked::Sampled(statistic)),
        Estimation::Counted(_) => None,
    }
}

//! Several statistics of one sample, which share the order of its values.

use super::estimate::Confidence;
use super::known::Asked;
use super::moments::{mean_of_ordered, variance_of_ordered};
use super::ordered::Ordered;
use super::quantile::quantile_of_ordered;
use super::sample::Sample;
use crate::data::statistic::Statistic;

/// Works out what `statistics` need of `sample`, which keeps it.
pub(crate) fn work_out(sample: &Sample, statistics: &[Statistic], confidence: &Confidence) {
    if sample.known().has(statistics.iter().filter_map(|statistic| asked(*statistic)), confidence) {
        return;
    }
    let ordered = Ordered::new(sample);
    for &statistic in statistics {
        match statistic {
            Statistic::Mean => {
                mean_of_ordered(&ordered, confidence);
            }
            Statistic::StandardDeviation => {
                mean_of_ordered(&ordered, confidence);
                variance_of_ordered(&ordered, confidence);
            }
            Statistic::Quantile(probability) => {
                quantile_of_ordered(&ordered, confidence, probability);
            }
            // Shares of runs are counted, not read off an order.
            _ => {}
        }
    }
}

/// What is kept of a statistic; nothing where shares of runs are counted. A deviation is kept after the mean that it needs.
fn asked(statistic: Statistic) -> Option<Asked> {
    match statistic {
        Statistic::Mean => Some(Asked::Mean),
        Statistic::StandardDeviation => Some(Asked::Variance),
        Statistic::Quantile(probability) => Some(Asked::Quantile(probability)),
        _ => None,
    }
}

//! Words of study files with what they mean: each stands here once, for the keys as for what reads them.

use super::description::{Deviation, RareMethod};
use loosepin_bounds::{Reading, Statistic};
use loosepin_result::study::Reduction;
use loosepin_surrogate::{Choice, Kind};

/// The words of a table.
pub(super) const fn words<T, const N: usize>(table: &[(&'static str, T); N]) -> [&'static str; N] {
    let mut words = [""; N];
    let mut place = 0;
    while place < N {
        words[place] = table[place].0;
        place += 1;
    }
    words
}

/// How an interval is read.
pub(super) const READINGS: [(&str, Reading); 3] = [
    ("fixed", Reading::FixedButUnknown),
    ("unknown-distribution", Reading::UnknownDistribution),
    ("random-set", Reading::RandomSet),
];

/// Which deviation of an output.
pub(super) const DEVIATIONS: [(&str, Deviation); 4] = [
    ("value", Deviation::Value),
    ("dimensional", Deviation::Dimensional),
    ("clearance", Deviation::Clearance),
    ("total", Deviation::Total),
];

/// How a curve becomes one number; the words are those of results too.
pub(super) const REDUCTIONS: [(&str, Reduction); 6] = {
    let mut table = [("", Reduction::Maximum); 6];
    let mut place = 0;
    while place < table.len() {
        let reduction = Reduction::ALL[place];
        table[place] = (reduction.word(), reduction);
        place += 1;
    }
    table
};

/// Ways to estimate a probability; nothing where it is only counted.
pub(super) const METHODS: [(&str, Option<RareMethod>); 4] = [
    ("count", None),
    ("importance", Some(RareMethod::Importance)),
    ("subset", Some(RareMethod::Subset)),
    ("automatic", Some(RareMethod::Automatic)),
];

/// Kinds of surrogates; nothing stands for no surrogate.
pub(super) const SURROGATES: [(&str, Option<Choice>); 5] = [
    ("auto", Some(Choice::Auto)),
    ("chaos", Some(Choice::Only(Kind::Chaos))),
    ("kriging", Some(Choice::Only(Kind::Kriging))),
    ("network", Some(Choice::Only(Kind::Network))),
    ("none", None),
];

/// Which direct runs are made beside a surrogate, and whether it is then alone.
pub(super) const DIRECT_RUNS: [(&str, bool); 2] = [("double-loop", false), ("confirming", true)];

/// Statistics without a number; nothing stands for what contributes.
pub(super) const PLAIN_STATISTICS: [(&str, Option<Statistic>); 4] = [
    (MEAN, Some(Statistic::Mean)),
    (STANDARD_DEVIATION, Some(Statistic::StandardDeviation)),
    ("cdf", Some(Statistic::Cdf)),
    ("contributors", None),
];

const MEAN: &str = "mean";
const STANDARD_DEVIATION: &str = "standard_deviation";

/// Statistics with a number, by their keys.
pub(super) const QUANTILE: &str = "quantile";
pub(super) const PROBABILITY_ABOVE: &str = "probability_above";
pub(super) const PROBABILITY_BELOW: &str = "probability_below";
pub(super) const PROBABILITY_BEYOND: &str = "probability_beyond";
pub(super) const SIMULTANEOUS_BAND: &str = "simultaneous_band";
pub(super) const STATISTICS: [&str; 5] =
    [QUANTILE, PROBABILITY_ABOVE, PROBABILITY_BELOW, PROBABILITY_BEYOND, SIMULTANEOUS_BAND];

/// Statistics that are one number each, which an accuracy can be of.
pub(super) const NUMBERS: [&str; 6] =
    [MEAN, STANDARD_DEVIATION, QUANTILE, PROBABILITY_ABOVE, PROBABILITY_BELOW, PROBABILITY_BEYOND];

/// The name that a statistic of one number has in study files; nothing for others.
pub(crate) fn statistic_name(statistic: Statistic) -> Option<&'static str> {
    Some(match statistic {
        Statistic::Mean => MEAN,
        Statistic::StandardDeviation => STANDARD_DEVIATION,
        Statistic::Quantile(_) => QUANTILE,
        Statistic::ProbabilityAbove(_) => PROBABILITY_ABOVE,
        Statistic::ProbabilityBelow(_) => PROBABILITY_BELOW,
        Statistic::ProbabilityBeyond(_) => PROBABILITY_BEYOND,
        Statistic::Cdf => return None,
    })
}

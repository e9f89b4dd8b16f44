//! Words of study files with what they mean: each stands here once, for the keys as for what reads them.

use loosepin_bounds::{Reading, Statistic};
use loosepin_result::study::{Deviation, Reduction};

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
pub(super) const READINGS: [(&str, Reading); 3] = {
    let mut table = [("", Reading::FixedButUnknown); 3];
    let mut place = 0;
    while place < table.len() {
        let reading = Reading::ALL[place];
        table[place] = (reading.file_word(), reading);
        place += 1;
    }
    table
};

/// Which deviation of an output.
pub(super) const DEVIATIONS: [(&str, Deviation); 4] = [
    (Deviation::Value.word(), Deviation::Value),
    (Deviation::Dimensional.word(), Deviation::Dimensional),
    (Deviation::Clearance.word(), Deviation::Clearance),
    (Deviation::Total.word(), Deviation::Total),
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

/// Statistics without a number; nothing stands for what contributes.
pub(super) const PLAIN_STATISTICS: [(&str, Option<Statistic>); Statistic::PLAIN.len() + 1] = {
    let mut table = [("contributors", None); Statistic::PLAIN.len() + 1];
    let mut place = 0;
    while place < Statistic::PLAIN.len() {
        let statistic = Statistic::PLAIN[place];
        table[place] = (statistic.word(), Some(statistic));
        place += 1;
    }
    table
};

/// Statistics with a number, whatever it is, and their keys.
pub(super) const WITH_A_NUMBER: [Statistic; Statistic::with_parameter(f64::NAN).len()] =
    Statistic::with_parameter(f64::NAN);
pub(super) const STATISTICS: [&str; WITH_A_NUMBER.len()] = {
    let mut words = [""; WITH_A_NUMBER.len()];
    let mut place = 0;
    while place < words.len() {
        words[place] = WITH_A_NUMBER[place].word();
        place += 1;
    }
    words
};

/// Statistics that are one number each, which an accuracy can be of.
pub(super) const NUMBERS: [&str; NUMBER_COUNT] = {
    let (mut words, mut filled, mut place) = ([""; NUMBER_COUNT], 0, 0);
    while place < EVERY {
        if every(place).is_single() {
            words[filled] = every(place).word();
            filled += 1;
        }
        place += 1;
    }
    words
};
const NUMBER_COUNT: usize = {
    let (mut count, mut place) = (0, 0);
    while place < EVERY {
        count += every(place).is_single() as usize;
        place += 1;
    }
    count
};
const EVERY: usize = Statistic::PLAIN.len() + WITH_A_NUMBER.len();

/// The statistics in the order of their lists.
const fn every(place: usize) -> Statistic {
    let plain = Statistic::PLAIN.len();
    if place < plain { Statistic::PLAIN[place] } else { WITH_A_NUMBER[place - plain] }
}

/// The name that a statistic of one number has in study files; nothing for others.
pub(crate) fn statistic_name(statistic: Statistic) -> Option<&'static str> {
    statistic.is_single().then(|| statistic.word())
}

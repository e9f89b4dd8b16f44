//! Words of study files with what they mean: each stands here once, for the keys as for what reads them.

use loosepin_bounds::{Reading, Statistic};
use loosepin_result::study::{Deviation, Reduction};
use loosepin_text::units::Dimension;

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

/// All values of a list, each with its word.
macro_rules! worded {
    ($all:expr, $word:ident) => {{
        let (mut table, mut place) = ([("", $all[0]); $all.len()], 0);
        while place < table.len() {
            table[place] = ($all[place].$word(), $all[place]);
            place += 1;
        }
        table
    }};
}

/// How an interval is read.
pub(super) const READINGS: [(&str, Reading); Reading::ALL.len()] = worded!(Reading::ALL, file_word);

/// Which deviation of an output.
pub(super) const DEVIATIONS: [(&str, Deviation); Deviation::ALL.len()] = worded!(Deviation::ALL, word);

/// How a curve becomes one number; the words are those of results too.
pub(super) const REDUCTIONS: [(&str, Reduction); Reduction::ALL.len()] = worded!(Reduction::ALL, word);

/// Statistics without a number; `None` stands for contributors.
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
pub(super) const STATISTICS: [&str; WITH_A_NUMBER.len()] = words(&worded!(WITH_A_NUMBER, word));

/// Statistics that are one number each, which an accuracy can be of.
pub(super) fn numbers() -> impl Iterator<Item = &'static str> {
    Statistic::PLAIN.into_iter().chain(WITH_A_NUMBER).filter_map(statistic_name)
}

/// Dimension of a statistic, `of_output` that of the output: a probability is a number.
pub(crate) fn dimension_of_statistic(statistic: Statistic, of_output: Dimension) -> Dimension {
    if statistic.is_probability() { Dimension::NUMBER } else { of_output }
}

/// The name that a statistic of one number has in study files; `None` for others.
pub(crate) fn statistic_name(statistic: Statistic) -> Option<&'static str> {
    statistic.is_single().then(|| statistic.word())
}

//! Which reading no plays explain, and by how much.

use super::consistent::ConsistentSet;
use loosepin_result::identification::{InconsistentReading, Misfit};

/// Largest factor of the errors that is looked for.
const MAX_FACTOR: f64 = 1e9;
/// Share to which the factor of the errors is located.
const LOCATED: f64 = 1e-6;

/// The misfit of an empty set.
pub(crate) fn misfit(set: &ConsistentSet) -> Misfit {
    let found_si = |reading: usize| {
        let row = &set.rows[reading];
        row.interval_si
    };
    let mut culprits = Vec::new();
    for reading in 0..set.rows.len() {
        // First what the study's own intervals exclude without any other reading.
        let alone = set.expected_si(&set.rows[reading], |_| true);
        let among = || set.expected_si(&set.rows[reading], |index| index == reading);
        let is_alone = alone.is_some_and(|expected| apart(expected, found_si(reading)) > 0.0);
        let expected = if is_alone { alone } else { among() };
        // Nothing where the others contradict one another already: then none of them is told.
        let Some(expected_si) = expected else { continue };
        let apart_si = apart(expected_si, found_si(reading));
        if apart_si > 0.0 {
            culprits.push(InconsistentReading {
                reading,
                is_alone,
                expected_si,
                found_si: found_si(reading),
                apart_si,
            });
        }
    }
    if culprits.iter().any(|culprit| culprit.is_alone) {
        culprits.retain(|culprit| culprit.is_alone);
    }
    let mut pairs = Vec::new();
    if culprits.is_empty() {
        for second in 0..set.rows.len() {
            let contradicts = |first: &usize| set.is_empty_of(|reading| reading == *first || reading == second);
            pairs.extend((0..second).filter(contradicts).map(|first| [first, second]));
        }
    }
    let error_factor = error_factor(set);
    let is_strained = |reading: usize, factor: f64| {
        let mut without = set.clone();
        without.rows.remove(reading);
        // With a little less than the factor only readings at their ends stand in the way.
        !without.is_empty_with(factor * (1.0 - 1e-3))
    };
    let strained = error_factor
        .map_or_else(Vec::new, |factor| (0..set.rows.len()).filter(|reading| is_strained(*reading, factor)).collect());
    Misfit { culprits, pairs, error_factor, strained }
}

/// How far two intervals are apart; zero where they meet.
fn apart(expected: [f64; 2], found: [f64; 2]) -> f64 {
    f64::max(found[0] - expected[1], expected[0] - found[1]).max(0.0)
}

/// The factor by which all errors have to grow for the set not to be empty; `None` if none is large enough.
fn error_factor(set: &ConsistentSet) -> Option<f64> {
    let (mut low, mut high) = (1.0, 2.0);
    while set.is_empty_with(high) {
        low = high;
        high *= 4.0;
        if high > MAX_FACTOR {
            return None;
        }
    }
    while high - low > LOCATED * low {
        let middle = 0.5 * (low + high);
        if set.is_empty_with(middle) { low = middle } else { high = middle }
    }
    Some(high)
}

//! The table of an output in a model file, put together from what its kinds say.

use super::kind::Measure;
use loosepin_text::document::{Key, Kind, optional};

/// What a kind says of the table of its outputs.
pub(super) struct KindTable {
    /// Its measures.
    pub measures: &'static [Measure],
    /// Keys that stand beside a measure.
    pub keys: &'static [Key],
    /// Words of the key `component`.
    pub components: &'static [&'static str],
}

/// The number of measures of all kinds.
pub(super) const fn measure_count(kinds: &[KindTable]) -> usize {
    let (mut count, mut kind) = (0, 0);
    while kind < kinds.len() {
        count += kinds[kind].measures.len();
        kind += 1;
    }
    count
}

/// The measures of all kinds, in their order.
pub(super) const fn measures<const COUNT: usize>(kinds: &[KindTable]) -> [Measure; COUNT] {
    let mut all = [kinds[0].measures[0]; COUNT];
    let (mut count, mut kind) = (0, 0);
    while kind < kinds.len() {
        let mut own = 0;
        while own < kinds[kind].measures.len() {
            all[count] = kinds[kind].measures[own];
            count += 1;
            own += 1;
        }
        kind += 1;
    }
    all
}

/// The names of measures.
pub(super) const fn names<const COUNT: usize>(measures: &[Measure; COUNT]) -> [&'static str; COUNT] {
    let (mut names, mut place) = ([""; COUNT], 0);
    while place < COUNT {
        names[place] = measures[place].key.name;
        place += 1;
    }
    names
}

/// The number of keys of the table: measures, what stands beside them, component and unit.
pub(super) const fn key_count(kinds: &[KindTable]) -> usize {
    let (mut count, mut kind) = (measure_count(kinds) + 2, 0);
    while kind < kinds.len() {
        count += kinds[kind].keys.len();
        kind += 1;
    }
    count
}

/// The keys of the table: measures, what stands beside them, component and unit.
pub(super) const fn keys<const COUNT: usize>(
    kinds: &[KindTable],
    measures: &[Measure],
    component_words: fn() -> Vec<&'static str>,
) -> [Key; COUNT] {
    let mut all = [UNIT; COUNT];
    let mut count = 0;
    while count < measures.len() {
        all[count] = measures[count].key;
        count += 1;
    }
    let mut kind = 0;
    while kind < kinds.len() {
        let mut own = 0;
        while own < kinds[kind].keys.len() {
            all[count] = kinds[kind].keys[own];
            count += 1;
            own += 1;
        }
        kind += 1;
    }
    // The last one is the unit.
    all[count] = optional(
        "component",
        Kind::ChoiceOf(component_words),
        "\"magnitude\"",
        "the component of a force, or the measure of wear",
    );
    all
}

/// The words behind `component`, each once.
pub(super) fn component_words(kinds: &[KindTable]) -> Vec<&'static str> {
    let mut words: Vec<&'static str> = Vec::new();
    for word in kinds.iter().flat_map(|kind| kind.components) {
        if !words.contains(word) {
            words.push(word);
        }
    }
    words
}

const UNIT: Key =
    optional("unit", Kind::Unit, "\"mm\"", "the unit in which people read it; chosen by what it measures if left out");

//! The table of an output in a model file, put together from what its kinds say.

use super::kind::Measure;
use loosepin_text::document::{Key, Kind, optional};

/// The names of the keys of measures.
pub(super) const fn names<const COUNT: usize>(keys: &[Key; COUNT]) -> [&'static str; COUNT] {
    let (mut names, mut place) = ([""; COUNT], 0);
    while place < COUNT {
        names[place] = keys[place].name;
        place += 1;
    }
    names
}

/// The keys of measures.
pub(super) const fn keys<const COUNT: usize>(measures: &[Measure; COUNT]) -> [Key; COUNT] {
    let (mut keys, mut place) = ([UNIT; COUNT], 0);
    while place < COUNT {
        keys[place] = measures[place].key;
        place += 1;
    }
    keys
}

/// The key of the component, whose words are those of all kinds.
pub(super) const fn component(words: fn() -> Vec<&'static str>) -> Key {
    optional("component", Kind::ChoiceOf(words), "\"magnitude\"", "the component of a force, or the measure of wear")
}

/// The key of the unit.
pub(super) const UNIT: Key =
    optional("unit", Kind::Unit, "\"mm\"", "the unit in which it is shown; if omitted, chosen by its dimension");

//! The keys of a study file: those that questions share, then the tables of single questions.

use super::keys::SHARED_KEYS;
use crate::question::question_keys;
use loosepin_text::document::Keys;
use std::sync::LazyLock;

pub(super) static STUDY_KEYS: LazyLock<Keys> = LazyLock::new(|| {
    let keys = SHARED_KEYS.keys.iter().copied().chain(question_keys()).collect::<Vec<_>>();
    // They live as long as the program.
    Keys::new(SHARED_KEYS.doc, keys.leak())
});

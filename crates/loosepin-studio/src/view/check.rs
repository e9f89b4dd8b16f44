//! What `loosepin check` finds in the texts of the page.

use std::sync::atomic::{AtomicBool, Ordering};

use loosepin::check::try_until;

use crate::messages::CheckAnswer;
use crate::view::diagnostics::diagnostic_views;
use crate::view::texts::Texts;

/// Moves the mechanism that the look `seq` has shown all round and makes the first steps of its run. `None` where `stop` was set before
/// the end.
pub fn answer_check(seq: u64, texts: &Texts, stop: &AtomicBool) -> Option<CheckAnswer> {
    let tried = texts.read().and_then(|file| try_until(&file, stop));
    let found = tried.map_or_else(|found| found, |warnings| warnings.into_iter().collect());
    if stop.load(Ordering::Relaxed) {
        return None;
    }
    Some(CheckAnswer { seq, diagnostics: diagnostic_views(&found, texts) })
}

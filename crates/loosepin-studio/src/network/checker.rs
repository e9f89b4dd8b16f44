//! Checks of texts that rest, in a thread of their own: no look waits for one, and each look stops the one that goes on.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use axum::extract::ws::Utf8Bytes;
use tokio::sync::watch;

use crate::messages::ToPage;
use crate::network::mailbox::Mailbox;
use crate::view::check::answer_check;
use crate::view::texts::Texts;

/// The checks of a page.
pub struct Checker {
    waiting: Mailbox<(u64, Texts, Arc<AtomicBool>)>,
    /// That of the newest check.
    stop: Mutex<Arc<AtomicBool>>,
}

impl Checker {
    /// Without any.
    pub fn new() -> Self {
        Self { waiting: Mailbox::new(), stop: Mutex::default() }
    }

    fn newest(&self) -> MutexGuard<'_, Arc<AtomicBool>> {
        self.stop.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Stops the check that goes on: its texts are old.
    pub fn stop(&self) {
        self.newest().store(true, Ordering::Relaxed);
    }

    /// Checks the texts that the look `seq` has shown instead of what was checked before.
    pub fn check(&self, seq: u64, texts: Texts) {
        self.stop();
        let stop = Arc::new(AtomicBool::new(false));
        *self.newest() = Arc::clone(&stop);
        self.waiting.put((seq, texts, stop));
    }

    /// Ends all checks.
    pub fn close(&self) {
        self.stop();
        self.waiting.close();
    }

    /// Answers until it is closed.
    pub fn check_on(&self, answers: &watch::Sender<Utf8Bytes>) {
        while let Some((seq, texts, stop)) = self.waiting.take() {
            let Some(found) = answer_check(seq, &texts, &stop) else { continue };
            let text = serde_json::to_string(&ToPage::CheckAnswer(&found)).unwrap_or_default();
            if answers.send(text.into()).is_err() {
                return;
            }
        }
    }
}

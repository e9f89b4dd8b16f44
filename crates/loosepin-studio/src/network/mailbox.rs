//! A place for one message: a newer one replaces the one that waits, so that no queue can grow.

use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

/// The place, shared by who puts and who takes.
pub struct Mailbox<T> {
    state: Mutex<State<T>>,
    changed: Condvar,
}

struct State<T> {
    message: Option<T>,
    is_closed: bool,
}

impl<T> Mailbox<T> {
    /// An empty one.
    pub fn new() -> Self {
        Self { state: Mutex::new(State { message: None, is_closed: false }), changed: Condvar::new() }
    }

    fn state(&self) -> MutexGuard<'_, State<T>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Puts a message in place of the one that waits.
    pub fn put(&self, message: T) {
        self.state().message = Some(message);
        self.changed.notify_one();
    }

    /// Closes the mailbox.
    pub fn close(&self) {
        self.state().is_closed = true;
        self.changed.notify_one();
    }

    /// Waits for the message; `None` after the end.
    pub fn take(&self) -> Option<T> {
        let mut state = self.state();
        loop {
            if state.is_closed {
                return None;
            }
            if let Some(message) = state.message.take() {
                return Some(message);
            }
            state = self.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Mailbox;

    #[test]
    fn the_newest_message_wins() {
        let mailbox = Mailbox::new();
        (0..1000).for_each(|number| mailbox.put(number));
        assert_eq!(mailbox.take(), Some(999));
        mailbox.put(1);
        mailbox.close();
        assert_eq!(mailbox.take(), None);
    }
}

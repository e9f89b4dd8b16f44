//! A run that somebody may stop.

use std::sync::atomic::{AtomicBool, Ordering};

use super::observer::{Observer, Onset, Separation, Step};

/// An observer whose run is given up once `stop` is set. What it sees, and the bits of the run, are the same.
pub(super) struct StoppableObserver<'w, O> {
    pub observer: &'w mut O,
    pub stop: &'w AtomicBool,
}

impl<O: Observer> Observer for StoppableObserver<'_, O> {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        self.observer.step(step);
    }

    fn contact_begins(&mut self, onset: &Onset) {
        self.observer.contact_begins(onset);
    }

    fn contact_ends(&mut self, separation: &Separation) {
        self.observer.contact_ends(separation);
    }

    fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}

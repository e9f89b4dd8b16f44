//! A queue as the passes over lanes see it: runs whose observers sit elsewhere, so that the passes are compiled once for all
//! kinds of observers.

use super::queue::{Queue, Run};
use crate::failure::RunFailure;
use crate::observer::Observer;
use crate::recording::report::RunReport;

/// Handle of the observer of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RunHandle(usize);

/// A queue of runs whose observers are reached by their seats.
pub(crate) trait QueueOfHandles {
    /// The next run, if any is left.
    fn next(&mut self) -> Option<Run<RunHandle>>;
    /// The observer of a handle; `None` once its run is over.
    fn observer(&mut self, seat: RunHandle) -> Option<&mut dyn Observer>;
    /// Gives back the observer of a run that is over.
    fn finished(&mut self, seat: RunHandle, outcome: Result<RunReport, RunFailure>);
}

/// The observers of a queue while their runs are on lanes.
pub(crate) struct HandledQueue<'q, O> {
    queue: &'q mut dyn Queue<Observer = O>,
    seats: Vec<Option<O>>,
}

impl<'q, O> HandledQueue<'q, O> {
    /// HandledQueue for the observers of `queue`.
    pub fn new(queue: &'q mut dyn Queue<Observer = O>) -> Self {
        Self { queue, seats: Vec::new() }
    }
}

impl<O: Observer> QueueOfHandles for HandledQueue<'_, O> {
    fn next(&mut self) -> Option<Run<RunHandle>> {
        let Run { sample, arms, window, observer, followed, resume } = self.queue.next()?;
        let free = self.seats.iter().position(Option::is_none).unwrap_or_else(|| {
            self.seats.push(None);
            self.seats.len() - 1
        });
        self.seats[free] = Some(observer);
        Some(Run { sample, arms, window, observer: RunHandle(free), followed, resume })
    }

    fn observer(&mut self, seat: RunHandle) -> Option<&mut dyn Observer> {
        let observer = self.seats.get_mut(seat.0)?.as_mut()?;
        Some(observer)
    }

    fn finished(&mut self, seat: RunHandle, outcome: Result<RunReport, RunFailure>) {
        if let Some(observer) = self.seats.get_mut(seat.0).and_then(Option::take) {
            self.queue.finished(observer, outcome);
        }
    }
}

//! Connected visitors: their limit, and who makes room when all places are taken.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use tokio::sync::{Notify, oneshot};
use tokio::time::{Instant, sleep_until};

/// State of a connection: whether it has shown the token.
#[derive(Debug, Clone, Default)]
pub struct Visitor(Arc<Shown>);

#[derive(Debug, Default)]
struct Shown {
    has_token: AtomicBool,
    is_live: AtomicBool,
}

impl Visitor {
    /// Marks the visitor as one with the token: it makes room for nobody.
    pub fn show_token(&self) {
        self.0.has_token.store(true, Ordering::Relaxed);
    }

    /// Marks the visitor as one with the token on a live connection, which may stay open.
    pub fn go_live(&self) {
        self.show_token();
        self.0.is_live.store(true, Ordering::Relaxed);
    }

    /// Whether it has shown the token.
    pub fn has_token(&self) -> bool {
        self.0.has_token.load(Ordering::Relaxed)
    }

    /// Whether it is a live connection that has shown the token.
    pub fn is_live(&self) -> bool {
        self.0.is_live.load(Ordering::Relaxed)
    }
}

/// All connections.
pub struct Visitors {
    most: usize,
    stay: Duration,
    state: Mutex<State>,
    changed: Notify,
}

#[derive(Default)]
struct State {
    next: u64,
    /// By their numbers, oldest first.
    inside: BTreeMap<u64, Inside>,
}

struct Inside {
    visitor: Visitor,
    since: Instant,
    /// Dropped to end the connection.
    _end: oneshot::Sender<()>,
}

/// A place among the connections; free again when this is dropped.
pub struct ConnectionSlot {
    number: u64,
    /// Who has it.
    pub visitor: Visitor,
    visitors: Arc<Visitors>,
}

/// What happens to somebody who wants in.
enum Admission {
    Admitted(ConnectionSlot, oneshot::Receiver<()>),
    /// Try again then, or when a place is free.
    Wait(Option<Instant>),
}

impl Visitors {
    /// At most `most` visitors at once; one without the token is open for `stay` before it makes room.
    pub fn new(most: usize, stay: Duration) -> Arc<Self> {
        Arc::new(Self { most, stay, state: Mutex::default(), changed: Notify::new() })
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// A place, and a receiver that ends when its connection has to. Where all are taken, the oldest connection that has not shown the
    /// token makes room; where all have shown it, the next place that is free is taken.
    pub async fn admit(self: &Arc<Self>) -> (ConnectionSlot, oneshot::Receiver<()>) {
        loop {
            let changed = self.changed.notified();
            match self.try_admit() {
                Admission::Admitted(place, end) => return (place, end),
                Admission::Wait(None) => changed.await,
                Admission::Wait(Some(until)) => tokio::select! {
                    () = changed => {}
                    () = sleep_until(until) => {}
                },
            }
        }
    }

    fn try_admit(self: &Arc<Self>) -> Admission {
        let mut state = self.state();
        if state.inside.len() >= self.most {
            let oldest = state.inside.iter().find(|(_, inside)| !inside.visitor.has_token());
            let Some((number, until)) = oldest.map(|(number, inside)| (*number, inside.since + self.stay)) else {
                return Admission::Wait(None);
            };
            if Instant::now() < until {
                return Admission::Wait(Some(until));
            }
            state.inside.remove(&number);
        }
        let (number, visitor) = (state.next, Visitor::default());
        let (end, ended) = oneshot::channel();
        state.next += 1;
        state.inside.insert(number, Inside { visitor: visitor.clone(), since: Instant::now(), _end: end });
        Admission::Admitted(ConnectionSlot { number, visitor, visitors: Arc::clone(self) }, ended)
    }
}

impl Drop for ConnectionSlot {
    fn drop(&mut self) {
        self.visitors.state().inside.remove(&self.number);
        self.visitors.changed.notify_one();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn admitted(visitors: &Arc<Visitors>) -> Option<(ConnectionSlot, oneshot::Receiver<()>)> {
        match visitors.try_admit() {
            Admission::Admitted(place, end) => Some((place, end)),
            Admission::Wait(_) => None,
        }
    }

    #[test]
    fn the_oldest_without_the_token_makes_room() {
        let visitors = Visitors::new(3, Duration::ZERO);
        let mut inside: Vec<_> = (0..3).map(|_| admitted(&visitors).unwrap()).collect();
        inside[0].0.visitor.show_token();
        let newest = admitted(&visitors).unwrap();
        let is_ended = |end: &mut oneshot::Receiver<()>| end.try_recv() == Err(oneshot::error::TryRecvError::Closed);
        assert_eq!([0, 1, 2].map(|place| is_ended(&mut inside[place].1)), [false, true, false]);
        // Its place was given away already: that it ends frees no other.
        inside.remove(1);
        inside[1].0.visitor.show_token();
        newest.0.visitor.go_live();
        assert!(admitted(&visitors).is_none(), "all have shown the token");
        drop(newest);
        assert!(admitted(&visitors).is_some());
    }

    #[test]
    fn who_has_just_come_may_stay_for_a_while() {
        let visitors = Visitors::new(1, Duration::from_secs(600));
        let _first = admitted(&visitors).unwrap();
        assert!(matches!(visitors.try_admit(), Admission::Wait(Some(_))));
    }
}

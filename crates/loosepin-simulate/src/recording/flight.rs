//! How long and how often the parts of a joint with play do not touch.

use crate::observer::Step;
use loosepin_mechanics::mechanism::Mechanism;
use std::ops::Range;

/// Counts of the loss of contact in every joint with play during the recorded part of a run.
#[derive(Debug, Clone)]
pub struct FlightClock {
    start_s: f64,
    /// Contacts by joint with play.
    contacts: Vec<Range<usize>>,
    /// Whether the joint touched in the step before; unknown at first.
    touched: Vec<Option<bool>>,
    /// Time without contact by joint with play, s.
    flight_s: Vec<f64>,
    /// How often a joint with play stopped touching anywhere.
    losses: Vec<u64>,
}

impl FlightClock {
    /// At zero for the joints with play of `mechanism`, from `start_s` on.
    pub fn new(mechanism: &Mechanism, start_s: f64) -> Self {
        let plays = mechanism.plays.len();
        Self {
            start_s,
            contacts: (0..plays).map(|play| mechanism.contacts_of(play)).collect(),
            touched: vec![None; plays],
            flight_s: vec![0.0; plays],
            losses: vec![0; plays],
        }
    }

    /// Takes a step in. Contacts begin and end where steps do.
    pub fn step(&mut self, step: &Step<'_, '_>) {
        let within_s = step.end_s - step.start_s.max(self.start_s);
        for (play, contacts) in self.contacts.iter().enumerate() {
            let touches = contacts.clone().any(|contact| step.is_in_contact(contact));
            if !touches {
                self.flight_s[play] += within_s;
                self.losses[play] += u64::from(self.touched[play] == Some(true));
            }
            self.touched[play] = Some(touches);
        }
    }

    /// Share of the time up to `end_s` without contact in the joint with play `play`, 0 to 1.
    pub fn share(&self, play: usize, end_s: f64) -> f64 {
        (self.flight_s[play] / (end_s - self.start_s)).clamp(0.0, 1.0)
    }

    /// How often the joint with play `play` stopped touching.
    pub fn losses(&self, play: usize) -> u64 {
        self.losses[play]
    }
}

//! Looks at a run once a turn.

use std::ops::Range;

use crate::math::Vec2;
use crate::mechanism::SampleError;
use crate::simulate::{Arms, Column, IdealReference, Observer, Step, Window};

/// The turns that are looked at, and when they end.
#[derive(Debug, Clone, Copy)]
pub struct Turns {
    /// The recorded part of the run.
    pub window: Window,
    /// Duration of a turn, s.
    pub turn_s: f64,
    /// How many turns.
    pub count: usize,
}

impl Turns {
    /// When turn `index` ends, s: the last one exactly with the run.
    pub fn end_s(&self, index: usize) -> f64 {
        if index + 1 == self.count { self.window.end_s } else { self.window.start_s + (index + 1) as f64 * self.turn_s }
    }
}

/// Collects the sections of one run.
pub struct TurnsRecorder<'a> {
    /// Place of its value among all values.
    pub index: usize,
    turns: Turns,
    outputs: &'a [Column],
    arms: Arms,
    ideal: IdealReference<'a>,
    /// Deviations by output, once a turn.
    pub sections_si: Vec<Vec<f64>>,
    /// Eccentricities of all joints with play, m, once a turn.
    pub eccentricities_m: Vec<Vec<Vec2<f64>>>,
    /// Time without contact by joint with play, s.
    pub flight_s: Vec<f64>,
    /// Radial clearances by joint with play, m.
    pub clearances_m: Vec<f64>,
    /// Contacts by joint with play.
    contacts: Vec<Range<usize>>,
    /// Why the ideal motion could not be followed.
    pub failure: Option<SampleError>,
}

impl<'a> TurnsRecorder<'a> {
    /// Ready for a run over `turns`; `outputs` are positions and angles.
    pub fn new(
        index: usize,
        turns: Turns,
        outputs: &'a [Column],
        arms: Arms,
        ideal: IdealReference<'a>,
        clearances_m: Vec<f64>,
        contacts: Vec<Range<usize>>,
    ) -> Self {
        Self {
            index,
            turns,
            outputs,
            arms,
            ideal,
            sections_si: vec![Vec::with_capacity(turns.count); outputs.len()],
            eccentricities_m: Vec::with_capacity(turns.count),
            flight_s: vec![0.0; clearances_m.len()],
            clearances_m,
            contacts,
            failure: None,
        }
    }

    /// The turns that it looks at.
    pub fn turns(&self) -> &Turns {
        &self.turns
    }

    fn look(&mut self, step: &mut Step<'_, '_>, time_s: f64) {
        let dynamics = step.set_state(time_s);
        self.eccentricities_m.push(dynamics.plays().iter().map(|motion| motion.eccentricity_m).collect());
        match self.ideal.at(time_s, false) {
            Ok(ideal) => {
                for (output, section_si) in self.outputs.iter().zip(&mut self.sections_si) {
                    let deviation =
                        output.reading.value(&self.arms, dynamics) - output.reading.value(&self.arms, ideal);
                    section_si.push(deviation);
                }
            }
            Err(error) => {
                self.failure.get_or_insert(error);
            }
        }
    }
}

impl Observer for TurnsRecorder<'_> {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        let within_s = step.end_s - step.start_s.max(self.turns.window.start_s);
        for (contacts, flight_s) in self.contacts.iter().zip(&mut self.flight_s) {
            if !contacts.clone().any(|contact| step.is_in_contact(contact)) {
                *flight_s += within_s;
            }
        }
        while self.eccentricities_m.len() < self.turns.count
            && self.turns.end_s(self.eccentricities_m.len()) <= step.end_s
        {
            let time_s = self.turns.end_s(self.eccentricities_m.len());
            self.look(step, time_s);
        }
    }
}

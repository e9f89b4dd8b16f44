//! Looks at a run once a turn.

use crate::{Arms, Column, FlightClock, IdealReference, Observer, Step, Turns, section};
use loosepin_math::Vec2;
use loosepin_mechanics::mechanism::SampleError;
use std::sync::atomic::{AtomicBool, Ordering};

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
    /// Numbers that return where the motion repeats itself, once a turn.
    pub sections: Vec<Vec<Vec2<f64>>>,
    /// Loss of contact.
    pub flight: FlightClock,
    /// Sizes of the entries of a section.
    pub sizes: Vec<f64>,
    /// Why the ideal motion could not be followed.
    pub failure: Option<SampleError>,
    stop: &'a AtomicBool,
}

impl<'a> TurnsRecorder<'a> {
    /// Ready for a run over `turns`, given up once `stop` is set; `outputs` are positions and angles. `sizes` go with the sections.
    #[allow(clippy::too_many_arguments, reason = "they are its fields")]
    pub fn new(
        index: usize,
        turns: Turns,
        outputs: &'a [Column],
        arms: Arms,
        ideal: IdealReference<'a>,
        sizes: Vec<f64>,
        flight: FlightClock,
        stop: &'a AtomicBool,
    ) -> Self {
        Self {
            index,
            turns,
            outputs,
            arms,
            ideal,
            sections_si: vec![Vec::with_capacity(turns.count); outputs.len()],
            sections: Vec::with_capacity(turns.count),
            flight,
            sizes,
            failure: None,
            stop,
        }
    }

    /// The turns that it looks at.
    pub fn turns(&self) -> &Turns {
        &self.turns
    }

    fn look(&mut self, step: &mut Step<'_, '_>, time_s: f64) {
        let dynamics = step.set_state(time_s);
        self.sections.push(section(dynamics, self.turns.turn_s));
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
        self.flight.step(step);
        while self.sections.len() < self.turns.count && self.turns.end_s(self.sections.len()) <= step.end_s {
            let time_s = self.turns.end_s(self.sections.len());
            self.look(step, time_s);
        }
    }

    fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}

//! How far flexible bodies bend over a run.

use super::observer::Step;
use loosepin_mechanics::mechanism::{BeamEnd, Mechanism};
use loosepin_result::simulation::BendingRecord;

/// Largest angles of the sections at both ends of each flexible body from its frame, |φ'·b|, at the ends of the steps, rad.
#[derive(Debug, Clone)]
pub struct BendingRecorder {
    largest_rad: Vec<f64>,
}

impl BendingRecorder {
    /// Nothing seen yet.
    pub fn new(mechanism: &Mechanism) -> Self {
        Self { largest_rad: vec![0.0; mechanism.real.beams.len()] }
    }

    /// Takes the end of a step in.
    pub fn step(&mut self, step: &mut Step<'_, '_>) {
        if self.largest_rad.is_empty() {
            return;
        }
        let dynamics = step.end();
        let coordinates = dynamics.free_state().0;
        for (largest_rad, beam) in self.largest_rad.iter_mut().zip(&dynamics.mechanism().real.beams) {
            let lateral = &coordinates[beam.axial().end..beam.coordinates.end];
            for end in [BeamEnd::Root, BeamEnd::Tip] {
                let slopes = &beam.station(end).slopes;
                let angle_rad: f64 = slopes.iter().zip(lateral).map(|(slope, turn)| slope * turn).sum();
                *largest_rad = largest_rad.max(angle_rad.abs());
            }
        }
    }

    /// What was seen, body by body.
    pub fn records(&self, mechanism: &Mechanism) -> Vec<BendingRecord> {
        let name = |body: usize| mechanism.model.bodies[body].name.clone();
        let beams = mechanism.real.beams.iter().zip(&self.largest_rad);
        beams.map(|(beam, &largest_angle_rad)| BendingRecord { body: name(beam.body.0), largest_angle_rad }).collect()
    }
}

//! How far flexible bodies bend over a run.

use super::observer::Step;
use loosepin_mechanics::mechanism::{BeamEnd, Mechanism, TreeBeam};
use loosepin_mechanics::model::Body;
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
        let record = |(place, &largest_angle_rad): (&TreeBeam, &f64)| {
            let Body { name, beam, .. } = &mechanism.model.bodies[place.body.0];
            let starts_settled = beam.as_ref().is_some_and(|beam| beam.starts_settled);
            BendingRecord { body: name.clone(), largest_angle_rad, starts_settled }
        };
        mechanism.real.beams.iter().zip(&self.largest_rad).map(record).collect()
    }
}

//! How far flexible bodies bend over a run.

use super::observer::Step;
use loosepin_mechanics::mechanism::Mechanism;
use loosepin_mechanics::model::{Body, BodyId};
use loosepin_result::simulation::BendingRecord;

/// Largest angles of the sections of each flexible body, at the ends of the steps, rad: of those at both ends and at the points from its
/// frame, |φ'·b|; in absolute nodal coordinates of those at all nodes from the way from root to tip.
#[derive(Debug, Clone)]
pub struct BendingRecorder {
    largest_rad: Vec<f64>,
}

impl BendingRecorder {
    /// Nothing seen yet.
    pub fn new(mechanism: &Mechanism) -> Self {
        Self { largest_rad: vec![0.0; mechanism.real.flexible_bodies().count()] }
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
            for place in beam.all_places() {
                let slopes = &beam.station(place).slopes;
                let angle_rad: f64 = slopes.iter().zip(lateral).map(|(slope, turn)| slope * turn).sum();
                *largest_rad = largest_rad.max(angle_rad.abs());
            }
        }
        let beams = dynamics.mechanism().real.beams.len();
        for (index, largest_rad) in self.largest_rad[beams..].iter_mut().enumerate() {
            *largest_rad = largest_rad.max(dynamics.nodal_turn_rad(index));
        }
    }

    /// What was seen, body by body.
    pub fn records(&self, mechanism: &Mechanism) -> Vec<BendingRecord> {
        let record = |(body, &largest_angle_rad): (BodyId, &f64)| {
            let Body { name, beam, .. } = &mechanism.model.bodies[body.0];
            let starts_settled = beam.as_ref().is_some_and(|beam| beam.starts_settled);
            let is_nodal = beam.as_ref().is_some_and(|beam| beam.is_nodal());
            BendingRecord { body: name.clone(), largest_angle_rad, starts_settled, is_nodal }
        };
        mechanism.real.flexible_bodies().zip(&self.largest_rad).map(record).collect()
    }
}

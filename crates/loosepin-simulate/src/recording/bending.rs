//! How far flexible bodies bend over a run.

use crate::observer::Step;
use loosepin_mechanics::mechanism::{Condensed, Mechanism};
use loosepin_mechanics::model::{Body, BodyId, Model, PointId};
use loosepin_result::simulation::{BendingRecord, CondensedRecord, OtherFormulation};

/// Largest angles of the sections of each flexible body, at the ends of the steps, rad: of those at both ends and at the points from its
/// frame, |φ'·b|; in absolute nodal coordinates of those at all nodes from the way from root to tip.
#[derive(Debug, Clone)]
pub struct BendingRecorder {
    largest_rad: Vec<f64>,
    /// Condensed shapes of each flexible body; those in absolute nodal coordinates have none.
    condensed: Vec<Option<CondensedRecord>>,
}

impl BendingRecorder {
    /// An empty record.
    pub fn new(mechanism: &Mechanism) -> Self {
        let count = mechanism.real.flexible_bodies().count();
        Self { largest_rad: vec![0.0; count], condensed: vec![None; count] }
    }

    /// Takes the end of a step in.
    pub fn step(&mut self, step: &mut Step<'_, '_>) {
        if self.largest_rad.is_empty() {
            return;
        }
        let dynamics = step.end();
        for (condensed, numbers) in self.condensed.iter_mut().zip(&dynamics.sample().real.beams) {
            let record = |condensed: &Condensed| CondensedRecord {
                shapes: condensed.were_hz.len(),
                above_hz: condensed.above_hz,
            };
            *condensed = numbers.condensed.as_ref().map(record);
        }
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

    /// The records, body by body.
    pub fn records(&self, mechanism: &Mechanism) -> Vec<BendingRecord> {
        let record = |((body, &largest_angle_rad), &condensed): ((BodyId, &f64), &Option<CondensedRecord>)| {
            let Body { name, beam, .. } = &mechanism.model.bodies[body.0];
            let starts_settled = beam.as_ref().is_some_and(|beam| beam.starts_settled);
            let is_nodal = beam.as_ref().is_some_and(|beam| beam.is_nodal());
            let other_formulation = other_formulation(&mechanism.model, body);
            BendingRecord {
                body: name.clone(),
                largest_angle_rad,
                starts_settled,
                is_nodal,
                other_formulation,
                condensed,
            }
        };
        mechanism.real.flexible_bodies().zip(&self.largest_rad).zip(&self.condensed).map(record).collect()
    }
}

/// Demands of the other formulation of a body; none for a rigid one.
pub fn other_formulation(model: &Model, body: BodyId) -> OtherFormulation {
    let Body { points, beam: Some(beam), .. } = &model.bodies[body.0] else { return OtherFormulation::AsItIs };
    if beam.is_nodal() {
        let [is_held_at_from, is_held_at_to] = beam.ends.map(|point| model.holds_section(PointId { body, point }));
        return match (is_held_at_from, is_held_at_to) {
            (_, true) => OtherFormulation::FreeAtTo,
            (true, false) => OtherFormulation::TangentFrame,
            (false, false) => OtherFormulation::AsItIs,
        };
    }
    let has_points_between = (0..points.len()).any(|point| !beam.ends.contains(&point));
    if has_points_between || !beam.lumps.is_empty() {
        OtherFormulation::EndsAlone
    } else if beam.damping_ratio.is_some() {
        OtherFormulation::RetardationTime
    } else {
        OtherFormulation::AsItIs
    }
}

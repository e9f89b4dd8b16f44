//! A run looked at once a turn (Poincaré section).

use crate::ideal::column::Column;
use crate::repeats::period::{period_turns, section, section_sizes};
use crate::repeats::turns::Turns;
use loosepin_math::Vec2;
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_mechanics::mechanism::{Mechanism, Sample};
use loosepin_result::simulation::{JournalOrbit, MotionKind, REPEAT_SHARE, SectionedOutput};

/// Record of one look.
#[derive(Debug, Clone)]
pub struct SectionRecorder {
    turns: Turns,
    /// Numbers that return where the motion repeats itself, by turn.
    pub compared: Vec<Vec<Vec2<f64>>>,
    /// Eccentricities in the frames of their bearings, m: x and y by joint with play.
    pub journals: Vec<(Vec<f64>, Vec<f64>)>,
    /// Deviations by output.
    pub deviations_si: Vec<Vec<f64>>,
}

impl SectionRecorder {
    /// For a mechanism with `plays` joints with play and `outputs` outputs.
    pub fn new(turns: Turns, plays: usize, outputs: usize) -> Self {
        Self {
            compared: Vec::with_capacity(turns.count),
            journals: vec![(Vec::with_capacity(turns.count), Vec::with_capacity(turns.count)); plays],
            deviations_si: vec![Vec::with_capacity(turns.count); outputs],
            turns,
        }
    }

    /// When to look next, s.
    pub fn next_s(&self) -> Option<f64> {
        (self.turns() < self.turns.count).then(|| self.turns.end_s(self.turns()))
    }

    /// Turns that were looked at.
    pub fn turns(&self) -> usize {
        self.compared.len()
    }

    /// Takes a look at the end of a turn: the state that was set, and the deviations there.
    pub fn look(&mut self, dynamics: &Dynamics<'_, f64>, deviations_si: &[f64]) {
        self.compared.push(section(dynamics, self.turns.turn_s));
        for (motion, (slots, (x_m, y_m))) in
            dynamics.plays().iter().zip(dynamics.play_slots().iter().zip(&mut self.journals))
        {
            let bearing = &dynamics.kinematics.poses[slots[0]];
            let e = bearing.turn_back(motion.eccentricity_m);
            x_m.push(e.x);
            y_m.push(e.y);
        }
        for (kept, deviation_si) in self.deviations_si.iter_mut().zip(deviations_si) {
            kept.push(*deviation_si);
        }
    }

    /// The kind of motion; `None` for a mechanism that follows its drives alone, and for less than two turns. `angle_rad`: the
    /// angle of the drive, or the phase of the cycle, where each turn begins.
    pub fn kind(
        &self,
        mechanism: &Mechanism,
        sample: &Sample<f64>,
        columns: &[Column],
        angle_rad: f64,
    ) -> Option<MotionKind> {
        if mechanism.is_ideal() || self.turns() < 2 {
            return None;
        }
        let period = period_turns(&self.compared, &section_sizes(mechanism, sample));
        let journals = mechanism.plays.iter().zip(&sample.plays).zip(&self.journals);
        let outputs = columns.iter().zip(&self.deviations_si).filter(|(column, _)| column.reading.is_position());
        Some(MotionKind {
            turns: self.turns() as u32,
            period_turns: period.map(|turns| turns as u32),
            repeat_share: REPEAT_SHARE,
            section_angle_rad: angle_rad.rem_euclid(std::f64::consts::TAU),
            // What is no pin has no orbit in a hole.
            journals: journals
                .filter(|((_, numbers), _)| numbers.shape.hole().is_some())
                .map(|((joint, numbers), (x_m, y_m))| JournalOrbit {
                    joint: mechanism.model.play_name(*joint).to_owned(),
                    label: String::new(),
                    radial_clearance_m: numbers.clearance_m,
                    x_m: x_m.clone(),
                    y_m: y_m.clone(),
                    // All at the angle of the section.
                    drive_angle_rad: Vec::new(),
                    force_n: Vec::new(),
                })
                .collect(),
            outputs: outputs
                .map(|(column, deviation_si)| SectionedOutput {
                    name: column.name.clone(),
                    unit: column.unit.clone(),
                    deviation_si: deviation_si.clone(),
                })
                .collect(),
        })
    }
}

//! How controls follow their references, for the record of a run.

use crate::repeats::error_oscillation::error_oscillation;
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_mechanics::mechanism::Mechanism;
use loosepin_mechanics::model::JointId;
use loosepin_result::simulation::ControlHistory;
use loosepin_text::units::SiUnit;

/// An error swings where it is wider than the tolerance of positions times this.
const RESOLVED: f64 = 1e3;

/// The histories of all controls in the making.
#[derive(Debug, Clone)]
pub struct ControlRecorder {
    histories: Vec<ControlHistory>,
    /// By control: error above which a swing is one, rad or m.
    resolved_si: Vec<f64>,
}

impl ControlRecorder {
    /// For the controls of `mechanism`, run with `tolerance_m`.
    pub fn new(mechanism: &Mechanism, tolerance_m: f64) -> Self {
        let model = &mechanism.model;
        let is_prismatic = |joint: JointId| model.joints[joint.0].kind.slides();
        let histories = model.controls.iter().map(|control| ControlHistory {
            name: control.name.clone(),
            joint: model.joints[control.joint.0].name.clone(),
            measured: model.joints[control.measured.0].name.clone(),
            unit: if is_prismatic(control.measured) { SiUnit::LENGTH } else { SiUnit::ANGLE },
            effort_unit: if is_prismatic(control.joint) { SiUnit::FORCE } else { SiUnit::MOMENT },
            reference_si: Vec::new(),
            error_si: Vec::new(),
            effort_si: Vec::new(),
            swing: None,
        });
        let resolved =
            |joint: JointId| RESOLVED * tolerance_m / if is_prismatic(joint) { 1.0 } else { mechanism.size_m };
        Self {
            histories: histories.collect(),
            resolved_si: model.controls.iter().map(|control| resolved(control.measured)).collect(),
        }
    }

    /// Whether there is nothing to record.
    pub fn is_empty(&self) -> bool {
        self.histories.is_empty()
    }

    /// Records the evaluation at the next sample time.
    pub fn record(&mut self, dynamics: &Dynamics<'_, f64>) {
        for (history, actuator) in self.histories.iter_mut().zip(dynamics.actuators()) {
            history.reference_si.push(actuator.reference);
            history.error_si.push(actuator.error);
            history.effort_si.push(actuator.effort);
        }
    }

    /// The histories, with the swings of those whose reference rests in the part of the run that is looked at.
    pub fn into_histories(mut self, time_s: &[f64]) -> Vec<ControlHistory> {
        for (history, resolved_si) in self.histories.iter_mut().zip(&self.resolved_si) {
            let second_half = &history.reference_si[history.reference_si.len() / 2..];
            if second_half.windows(2).all(|pair| pair[0] == pair[1]) {
                history.swing = error_oscillation(time_s, &history.error_si, *resolved_si);
            }
        }
        self.histories
    }
}

//! Expressions that have no value: the logarithm of a negative number, a division by zero; springs that have no direction.

use crate::dynamics::equations::Dynamics;

/// The element without a value at an evaluation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum WithoutValue {
    /// A drive, load or control, by its path.
    Element(String),
    /// A spring along a line whose ends meet, by its name.
    Spring(String),
}

impl Dynamics<'_, f64> {
    /// The first drive, spring, load or control that had no finite value at the last evaluation. `None` if the state itself is not
    /// finite: then nothing can be told.
    pub fn element_without_value(&self) -> Option<WithoutValue> {
        let model = &self.mechanism.model;
        let is_lost = |numbers: &[f64]| numbers.iter().any(|number| !number.is_finite());
        let tree = &self.mechanism.real;
        for (k, drive) in tree.drives.iter().enumerate() {
            let place = tree.free + k;
            if is_lost(&[self.coordinates[place], self.rates[place], self.driven_accelerations[k]]) {
                return Some(WithoutValue::Element(format!("drive.{}", model.drives[drive.0].name)));
            }
        }
        let (coordinates, rates) = self.free_state();
        if is_lost(coordinates) || is_lost(rates) {
            return None;
        }
        let lost_spring = (0..self.spring_slots.len()).find(|&index| self.spring_force(index).stored_j.is_nan());
        if let Some(index) = lost_spring {
            return Some(WithoutValue::Spring(model.springs[index].name.clone()));
        }
        let load = self.loads.iter().position(|load| is_lost(&[load.force_n.x, load.force_n.y, load.torque_n_m]));
        let control = self.actuators.iter().position(|actuator| is_lost(&[actuator.reference, actuator.effort]));
        load.map(|index| format!("load.{}", model.loads[index].name))
            .or_else(|| control.map(|index| format!("control.{}", model.controls[index].name)))
            .map(WithoutValue::Element)
    }
}

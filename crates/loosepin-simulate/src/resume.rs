//! State at the end of a run, from which another one can resume.

use crate::stepping::motion::Layout;
use loosepin_mechanics::contact::PlayState;

/// Positions, velocities, deflections of bristles, integrals of the errors of controls and contact states at one instant: all that the motion after it depends on.
///
/// The speed at which a contact began belongs to it, since contact laws remember that speed. The root of a penetration does not:
/// a run that goes on reads the penetration off the positions until the next contact begins.
#[derive(Debug, Clone)]
pub struct MotionState {
    /// As [`Layout`] has it; roots of penetrations and the energy account are zero.
    pub(super) state: Vec<f64>,
    /// By contact.
    pub(super) contacts: Vec<PlayState<f64>>,
}

impl MotionState {
    /// Takes what the motion depends on out of `state`, which is that at `time_s`.
    pub(super) fn new(layout: &Layout, state: &[f64], time_s: f64, contacts: Vec<PlayState<f64>>) -> Self {
        let mut kept = vec![0.0; layout.length()];
        for place in Self::places(layout) {
            kept[place] = state[place];
        }
        kept[layout.time()] = time_s;
        Self { state: kept, contacts }
    }

    /// When it is, s.
    pub(super) fn time_s(&self, layout: &Layout) -> f64 {
        self.state[layout.time()]
    }

    /// Places of coordinates, rates, deflections of bristles and integrals of the errors of controls.
    pub(super) fn places(layout: &Layout) -> impl Iterator<Item = usize> + '_ {
        let further = layout.bristles.iter().chain(&layout.joint_bristles).chain(&layout.error_integrals);
        (0..layout.time()).chain(further.flatten().copied())
    }
}

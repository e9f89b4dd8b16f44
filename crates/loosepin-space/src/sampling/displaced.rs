//! Positions with the journals in given places, close to an ideal one.

use super::closing::{CONTRACTION, move_little};
use super::nominal::Base;
use crate::closure::bordered::Bordered;
use crate::closure::loops::Loops;
use crate::closure::newton::largest;
use crate::kind::frames::{JointFrames, MarkerShift};
use loosepin_math::{Frame, Pose};

/// Most steps; five are usual.
const MAX_STEPS: usize = 30;
/// What a step may leave at the end, lengths over L and rad.
const CLOSED_TO: f64 = 1e-16;
/// A step below this may be the last one where the next is no smaller.
const ROUND_OFF: f64 = 1e-14;
/// Longest way, lengths over L and rad.
const LONGEST_WAY: f64 = 0.3;
/// Where steps are a larger share of those before, a system of the displaced position is worth its factors.
const SLOW: f64 = 2e-3;
/// Steps below this are few, whatever the system.
const NEARLY_CLOSED: f64 = 1e-10;

/// Poses with play, and what the joints are in them.
#[derive(Debug, Clone, Default)]
pub(super) struct Displaced {
    pub poses: Vec<Pose>,
    pub frames: Vec<JointFrames>,
}

/// The system that displaced positions are closed with: that of the ideal position, or one of a displaced position.
#[derive(Debug, Clone, Default)]
pub(super) struct DisplacedSystem {
    own: Bordered,
    has_own: bool,
    bodies: Vec<Frame>,
    step: Vec<f64>,
}

impl DisplacedSystem {
    /// Begins with the ideal position.
    pub(super) fn reset(&mut self) {
        self.has_own = false;
    }

    /// The system that is used now.
    pub(super) fn system<'a>(&'a self, ideal: &'a Bordered) -> &'a Bordered {
        if self.has_own { &self.own } else { ideal }
    }

    /// Closes the loops with play from the poses that are there. Whether that came to an end not far from them.
    pub(super) fn close(
        &mut self,
        loops: &Loops,
        base: &Base,
        ideal: &Bordered,
        shifts: &[MarkerShift],
        at: &mut Displaced,
    ) -> bool {
        let unknowns = loops.unknowns();
        let (mut way, mut before, mut is_slow) = (0.0, f64::INFINITY, false);
        for _ in 0..MAX_STEPS {
            loops.frames_into(&at.poses, shifts, &mut self.bodies, &mut at.frames);
            if is_slow {
                self.own.factor(loops, &at.frames, &base.position.borders);
                self.has_own = true;
                before = f64::INFINITY;
            }
            self.step.clear();
            self.step.extend(loops.residuals(&at.frames, &base.drives).map(|value| -value));
            let system = if self.has_own { &self.own } else { ideal };
            system.solve_in_place(&mut self.step);
            let size = largest(&self.step[..unknowns]);
            way += size;
            if !(way <= LONGEST_WAY) {
                return false;
            }
            move_little(loops, &mut at.poses, &self.step);
            // The first step does not say how good the system is.
            let share = if before.is_finite() { size / before } else { CONTRACTION };
            if size * share.min(CONTRACTION) <= CLOSED_TO {
                return true;
            }
            if share > 0.5 {
                return size <= ROUND_OFF;
            }
            is_slow = before.is_finite() && share > SLOW && size > NEARLY_CLOSED;
            before = size;
        }
        false
    }
}

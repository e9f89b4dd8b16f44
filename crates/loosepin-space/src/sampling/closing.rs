//! Closes the loops of a sample, place after place, in the same memory.
//!
//! ```text
//! Φ(x) + N ν = 0,  Vᵀ(x - x0) = 0,  N and V the null spaces of the nominal Jacobian
//! ```
//!
//! The first steps of Newton's method are made with the nominal system, which is off by as much as the sample's sizes are, the last one with
//! the sample's own.

use super::nominal::Base;
use crate::closure::bordered::Bordered;
use crate::closure::loops::Loops;
use crate::closure::newton::{Closed, largest};
use crate::kind::frames::JointFrames;
use loosepin_math::{Frame, Pose, Quaternion, Vec3};

/// What Newton's method may move from a position close by, lengths over the characteristic length and rad: more is a hint at another branch.
pub(super) const START_LIMIT: f64 = 0.1;
/// Most steps; three are usual.
const MAX_STEPS: usize = 30;
/// What a step may leave, lengths over L and rad, for the next one to be the last.
const NEARLY_CLOSED: f64 = 1e-11;
/// A step with the sample's own system below this is the last one: what it leaves is its square, and the system is off by as much as it.
const LAST_STEP: f64 = 1e-9;
/// A step that is a larger share of the one before asks for a system of its own.
pub(super) const CONTRACTION: f64 = 0.1;
/// Smallest pivot of a sample's system relative to that of the nominal one, both over their largest: below it the position may be singular.
const SMALLEST_PIVOT: f64 = 1e-2;

/// Poses, what the joints are in them, and their system.
#[derive(Debug, Clone, Default)]
pub(super) struct Closing {
    pub poses: Vec<Pose>,
    pub frames: Vec<JointFrames>,
    /// Of the ideal position.
    pub system: Bordered,
    /// How far redundant rows are from closing.
    pub apart: Vec<f64>,
    bodies: Vec<Frame>,
    step: Vec<f64>,
}

impl Closing {
    /// Closes the loops of ideal joints from a position close by, or says that this may have led to another branch: if the way was longer than
    /// `limit`, or the determinant of the system has another sign.
    pub(super) fn close_ideal(&mut self, loops: &Loops, base: &Base, limit: f64) -> bool {
        self.poses.clone_from(&base.position.poses);
        let (mut way, mut before, mut is_own) = (0.0, f64::INFINITY, false);
        for _ in 0..MAX_STEPS {
            loops.frames_into(&self.poses, &[], &mut self.bodies, &mut self.frames);
            if is_own {
                self.system.factor(loops, &self.frames, &base.position.borders);
            }
            let size = self.newton_step(loops, &base.drives, if is_own { None } else { Some(&base.system) });
            way += size;
            if !(way <= limit) {
                return false;
            }
            if is_own && size <= LAST_STEP {
                self.apart.clear();
                self.apart.extend_from_slice(&self.step[loops.unknowns()..]);
                let has_pivots = self.system.pivot_ratio() > SMALLEST_PIVOT * base.pivot_ratio;
                return has_pivots && self.system.sign() == base.sign;
            }
            let share = size / before;
            is_own |= size * share <= NEARLY_CLOSED || (share > CONTRACTION && before.is_finite());
            // The first step does not say how good the nominal system is.
            is_own |= size <= NEARLY_CLOSED;
            before = size;
        }
        false
    }

    /// The same for searches of other kinds.
    pub(super) fn closed(&self) -> Closed {
        Closed {
            poses: self.poses.clone(),
            frames: self.frames.clone(),
            system: self.system.clone(),
            apart: self.apart.clone(),
            way: 0.0,
        }
    }

    /// One step with the given system or that of these poses; its size.
    fn newton_step(&mut self, loops: &Loops, drives: &[f64], known: Option<&Bordered>) -> f64 {
        let unknowns = loops.unknowns();
        let system = known.unwrap_or(&self.system);
        self.step.clear();
        self.step.extend(loops.residuals(&self.frames, drives).map(|value| -value));
        system.solve_in_place(&mut self.step);
        move_little(loops, &mut self.poses, &self.step);
        largest(&self.step[..unknowns])
    }
}

/// Moves poses by a vector of scaled unknowns, turns by 2 atan(θ/2): what Newton's method adds is made up for by its next step.
pub(super) fn move_little(loops: &Loops, poses: &mut [Pose], unknowns: &[f64]) {
    for (body, pose) in poses.iter_mut().enumerate().skip(1) {
        let (displacement_m, rotation_rad): (Vec3, Vec3) = loops.velocities(unknowns, body);
        let turn = Quaternion { w: 1.0, vector: rotation_rad * 0.5 };
        pose.position_m += displacement_m;
        pose.orientation = turn.compose(&pose.orientation).normalised();
    }
}

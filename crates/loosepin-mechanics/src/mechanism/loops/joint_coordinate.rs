//! The coordinate of a joint, read off the motion of its two bodies, whether the tree holds the joint or not.
//!
//! Revolute: the angle θ_j - θ_i of the journal's body from the bearing's; it exists with play as well. Prismatic: the position
//! s = d·e of the slider along the guide, d the direction of its line and e from the guide's point to the slider's; a pin in a
//! slot likewise.

use crate::mechanism::loops::joint_geometry::JointGeometry;
use crate::mechanism::tree::kinematics::{Kinematics, Twist, acceleration_at};
use crate::mechanism::tree::spanning_tree::{JointPlace, Tree};
use loosepin_math::{Real, Vec2};

/// Motion of the slider of a prismatic joint against its guide, in the ground's frame.
#[derive(Debug, Clone, Copy)]
struct Sliding<T> {
    line: Vec2<T>,
    arms_m: [Vec2<T>; 2],
    gap_m: Vec2<T>,
}

impl<T: Real> JointGeometry<T> {
    #[inline(always)]
    fn sliding(&self, [i, j]: [usize; 2], kinematics: &Kinematics<T>) -> Sliding<T> {
        let poses = &kinematics.poses;
        let arms_m = [poses[i].turn(self.arms_m[0]), poses[j].turn(self.arms_m[1])];
        let gap_m = poses[j].position_m + arms_m[1] - poses[i].position_m - arms_m[0];
        Sliding { line: poses[i].turn(self.line), arms_m, gap_m }
    }

    /// The coordinate, rad or m, and its rate: θ_j - θ_i, or s = d·e with ṡ = d·ė + ω d⊥·e, ω of the guide.
    #[inline(always)]
    pub fn motion(&self, place: &JointPlace, kinematics: &Kinematics<T>) -> [T; 2] {
        let ([i, j], twists) = (place.slots, &kinematics.twists);
        if !place.is_prismatic {
            let angle_rad = kinematics.poses[j].angle_rad() - kinematics.poses[i].angle_rad();
            return [angle_rad, twists[j].angular - twists[i].angular];
        }
        let Sliding { line, arms_m, gap_m } = self.sliding(place.slots, kinematics);
        let gap_rate = twists[j].at(arms_m[1]) - twists[i].at(arms_m[0]);
        [line.dot(gap_m), line.dot(gap_rate) + twists[i].angular * line.turned().dot(gap_m)]
    }

    /// The rate of the coordinate for other velocities of its two bodies: of the origins of their frames, and angular.
    #[inline(always)]
    pub fn rate(&self, place: &JointPlace, kinematics: &Kinematics<T>, velocities: [(Vec2<T>, T); 2]) -> T {
        let [(linear_i, spin_i), (linear_j, spin_j)] = velocities;
        if !place.is_prismatic {
            return spin_j - spin_i;
        }
        let Sliding { line, arms_m, gap_m } = self.sliding(place.slots, kinematics);
        let gap_rate = linear_j.plus(arms_m[1].turned(), spin_j) - linear_i.plus(arms_m[0].turned(), spin_i);
        line.dot(gap_rate) + spin_i * line.turned().dot(gap_m)
    }

    /// The second derivative of the coordinate for the accelerations `changes` of the frames of its two bodies.
    ///
    /// s̈ = d·ë + 2 ω d⊥·ė + α d⊥·e - ω² d·e, ω and α of the guide.
    #[inline(always)]
    pub fn acceleration(&self, place: &JointPlace, kinematics: &Kinematics<T>, changes: [Twist<T>; 2]) -> T {
        let ([i, j], twists) = (place.slots, &kinematics.twists);
        if !place.is_prismatic {
            return changes[1].angular - changes[0].angular;
        }
        let Sliding { line, arms_m, gap_m } = self.sliding(place.slots, kinematics);
        let gap_rate = twists[j].at(arms_m[1]) - twists[i].at(arms_m[0]);
        let acceleration =
            acceleration_at(&changes[1], &twists[j], arms_m[1]) - acceleration_at(&changes[0], &twists[i], arms_m[0]);
        let (normal, spin) = (line.turned(), twists[i].angular);
        line.dot(acceleration) + T::from_f64(2.0) * spin * normal.dot(gap_rate) + changes[0].angular * normal.dot(gap_m)
            - spin.squared() * line.dot(gap_m)
    }

    /// Adds `factor` times the gradient of the coordinate over all coordinates of `tree` to `row`.
    #[inline(always)]
    pub fn add_gradient(&self, place: &JointPlace, tree: &Tree, kinematics: &Kinematics<T>, factor: T, row: &mut [T]) {
        let sliding = place.is_prismatic.then(|| self.sliding(place.slots, kinematics));
        for (side, sign) in [(0, -1.0), (1, 1.0)] {
            let slot = place.slots[side];
            if slot == 0 {
                continue;
            }
            let signed = factor * T::from_f64(sign);
            for column in kinematics.columns(tree, slot) {
                let to = &mut row[column.coordinate];
                let turning = T::from_f64(column.turning);
                let Some(Sliding { line, arms_m, gap_m }) = &sliding else {
                    *to += signed * turning;
                    continue;
                };
                *to += signed * line.dot(column.at(arms_m[side]));
                if side == 0 {
                    // The line turns with the guide.
                    *to += factor * turning * line.turned().dot(*gap_m);
                }
            }
        }
    }

    /// Points of attack on both bodies, m from their origins, of a force along the line of a prismatic joint, and that line:
    /// both at the slider's point. All in the ground's frame.
    #[inline(always)]
    pub fn line_of_action(&self, place: &JointPlace, kinematics: &Kinematics<T>) -> ([Vec2<T>; 2], Vec2<T>) {
        let Sliding { line, arms_m, gap_m } = self.sliding(place.slots, kinematics);
        ([arms_m[0] + gap_m, arms_m[1]], line)
    }
}

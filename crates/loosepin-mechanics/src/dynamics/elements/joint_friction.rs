//! Friction in ideal joints: a force as large as what the joint carries, which depends on the accelerations, which depend on it.
//!
//! Joint k, between first and second body (bearing and journal, guide and slider), slides at v_k: r ω_rel at the surface of a
//! pin of radius r, the velocity along the guide for a slider. Its friction is w_k F_k with the unit wrench w_k (torque r, or
//! force along the guide through the slider point) and F_k = m_k N_k; m_k is the friction law's force at v_k for a normal force
//! of one newton. N_k is |R| of the constraint force R of a revolute joint. A slider touches its guide at both ends of the guide
//! length ℓ with N1,2 = R_n/2 ∓ M/ℓ, R_n and M being constraint force across the guide and constraint moment about the slider
//! point: N_k = |N1| + |N2|.
//!
//! Constraint forces are affine in all F: ρ = ρ0 + Σ B_j F_j, from the motion without friction and from what each unit wrench
//! adds to accelerations and multipliers. What is left, N_k = f_k(ρ_k), is solved by six steps of Newton's method
//! from the motion without friction: always as many, so that lanes stay together. The residual is kept for every joint; where
//! it does not vanish, or where friction grows faster with N than N itself does (the pivot of 1 - df/dN is not positive:
//! jamming, Painlevé's paradox), there is no solution that begins at no friction, and the run fails.

mod carried;
mod newton;

use crate::mechanism::{JointFriction, Kinematics, Mechanism, Sample};
use crate::model::JointId;
use loosepin_math::{Real, Vec2};

/// Components of the force that a joint carries: at both its ends, or in both directions.
const PARTS: usize = 2;

/// Source of the constraint force of a joint with friction.
#[derive(Debug, Clone)]
enum Carrier {
    /// A joint of the tree: the balance of forces on the bodies beyond it, by slot.
    Tree { beyond: Vec<bool> },
    /// A joint that closes a loop: the multipliers from this row on.
    Cut { row: usize },
}

/// A rigid motion of all bodies beyond a joint that the joint forbids: its power is a constraint force.
#[derive(Debug, Clone, Copy)]
struct Forbidden<T> {
    /// Velocity at the joint.
    linear: Vec2<T>,
    angular: T,
}

/// A joint with friction at the last evaluation.
#[derive(Debug, Clone)]
struct Entry<T> {
    joint: JointId,
    carrier: Carrier,
    slots: [usize; 2],
    is_slider: bool,
    /// Position of the joint, m, and direction of the guide.
    place_m: Vec2<T>,
    line: Vec2<T>,
    /// Force of the unit wrench on the second body, and its moment about the joint.
    wrench: (Vec2<T>, T),
    sliding_m_s: T,
    /// m_k, and the rate of the bristles, m/s.
    coefficient: T,
    bristle_rate_m_s: T,
    forbidden: [Forbidden<T>; PARTS],
    /// Power of the applied forces on the forbidden motions.
    applied: [T; PARTS],
    /// ρ0.
    free: [T; PARTS],
    /// N_k.
    normal_n: T,
    residual: T,
}

/// All joints with friction, with room for everything that their equations need.
#[derive(Debug, Clone)]
pub(in crate::dynamics) struct JointFrictions<T> {
    entries: Vec<Entry<T>>,
    /// Generalised forces of the unit wrenches, a row over all coordinates for each joint.
    pushes: Vec<T>,
    /// Effect of unit forces on accelerations and multipliers.
    answers: Vec<T>,
    multipliers: Vec<T>,
    /// B: parts of joint k by joint j.
    influence: Vec<[T; PARTS]>,
    /// 1 - df/dN, and the defects of N = f.
    matrix: Vec<T>,
    defects: Vec<T>,
    /// Constraint rows for one forbidden motion.
    gradient: Vec<T>,
    /// Deflections of bristles, m, by joint with friction: unknowns of a run. Empty if they have settled.
    pub bristles_m: Vec<Option<T>>,
}

impl<T: Real> JointFrictions<T> {
    /// Workspace for `mechanism`; `None` without such joints.
    pub fn new(mechanism: &Mechanism, sample: &Sample<T>) -> Option<Self> {
        let tree = &mechanism.real;
        let entries: Vec<Entry<T>> = sample
            .frictions
            .iter()
            .map(|friction| {
                let joint = friction.joint;
                let kind = &mechanism.model.joints[joint.0].kind;
                let bodies = kind.bodies();
                let mut row = 0;
                let mut carrier = None;
                for cut in &tree.cuts {
                    if cut.joint == joint {
                        carrier = Some(Carrier::Cut { row });
                    }
                    row += cut.count();
                }
                let carrier = carrier.unwrap_or_else(|| {
                    let mut beyond = vec![false; tree.links.len() + 1];
                    for (index, link) in tree.links.iter().enumerate() {
                        beyond[index + 1] =
                            beyond[link.parent_slot] || link.joint().is_some_and(|(own, _)| own == joint);
                    }
                    Carrier::Tree { beyond }
                });
                let nothing = Forbidden { linear: Vec2::zero(), angular: T::zero() };
                Entry {
                    joint,
                    carrier,
                    slots: bodies.map(|body| tree.slot_of_body[body.0]),
                    is_slider: kind.slides(),
                    place_m: Vec2::zero(),
                    line: Vec2::zero(),
                    wrench: (Vec2::zero(), T::zero()),
                    sliding_m_s: T::zero(),
                    coefficient: T::zero(),
                    bristle_rate_m_s: T::zero(),
                    forbidden: [nothing; PARTS],
                    applied: [T::zero(); PARTS],
                    free: [T::zero(); PARTS],
                    normal_n: T::zero(),
                    residual: T::zero(),
                }
            })
            .collect();
        let (count, rows) = (entries.len(), tree.constraint_rows());
        (count > 0).then(|| Self {
            pushes: vec![T::zero(); count * tree.coordinates()],
            answers: vec![T::zero(); count * tree.free],
            multipliers: vec![T::zero(); count * rows],
            influence: vec![[T::zero(); PARTS]; count * count],
            matrix: vec![T::zero(); count * count],
            defects: vec![T::zero(); count],
            gradient: vec![T::zero(); rows],
            bristles_m: vec![None; count],
            entries,
        })
    }

    /// Reads places, sliding velocities and coefficients off the motion, before forces are added.
    #[inline(never)]
    pub fn begin(&mut self, kinematics: &Kinematics<T>, frictions: &[JointFriction<T>]) {
        let half = T::from_f64(0.5);
        for ((entry, friction), bristle_m) in self.entries.iter_mut().zip(frictions).zip(&self.bristles_m) {
            let [first, second] = entry.slots;
            let (poses, twists) = (&kinematics.poses, &kinematics.twists);
            let own_arm = poses[second].turn(friction.second_arm_m);
            entry.place_m = poses[second].position_m + own_arm;
            let nothing = Forbidden { linear: Vec2::zero(), angular: T::zero() };
            if entry.is_slider {
                entry.line = poses[first].turn(friction.guide_direction);
                let gap_rate = twists[second].at(own_arm) - twists[first].at(entry.place_m - poses[first].position_m);
                entry.sliding_m_s = entry.line.dot(gap_rate);
                entry.wrench = (entry.line, T::zero());
                let across = entry.line.turned() * half;
                let turning = T::one() / friction.size_m;
                entry.forbidden =
                    [Forbidden { linear: across, angular: -turning }, Forbidden { linear: across, angular: turning }];
            } else {
                entry.sliding_m_s = friction.size_m * (twists[second].angular - twists[first].angular);
                entry.wrench = (Vec2::zero(), friction.size_m);
                let (one, none) = (T::one(), T::zero());
                entry.forbidden = [
                    Forbidden { linear: Vec2::new(one, none), ..nothing },
                    Forbidden { linear: Vec2::new(none, one), ..nothing },
                ];
            }
            entry.applied = [T::zero(); PARTS];
            (entry.coefficient, entry.bristle_rate_m_s) = match bristle_m {
                None => (friction.law.force_n(entry.sliding_m_s, T::one()), T::zero()),
                Some(bristle_m) => {
                    let force = friction.law.force_with_bristle(entry.sliding_m_s, T::one(), *bristle_m);
                    (force.force_n, force.rate_m_s)
                }
            };
        }
    }

    /// Takes in a force on the body in `slot` at `point_m`, and a torque.
    #[inline(never)]
    pub fn take_force(&mut self, slot: usize, point_m: Vec2<T>, force_n: Vec2<T>, moment_n_m: T) {
        for entry in &mut self.entries {
            if entry.moves(slot) {
                for part in 0..PARTS {
                    entry.applied[part] += entry.power(part, point_m, force_n, moment_n_m);
                }
            }
        }
    }
}

impl<T: Real> Entry<T> {
    /// Whether the forbidden motions move the body in `slot`.
    fn moves(&self, slot: usize) -> bool {
        matches!(&self.carrier, Carrier::Tree { beyond } if beyond[slot])
    }

    /// Velocity of the point `point_m` in a forbidden motion.
    #[inline(always)]
    fn velocity(&self, part: usize, point_m: Vec2<T>) -> Vec2<T> {
        let forbidden = &self.forbidden[part];
        forbidden.linear.plus((point_m - self.place_m).turned(), forbidden.angular)
    }

    #[inline(always)]
    fn power(&self, part: usize, point_m: Vec2<T>, force_n: Vec2<T>, moment_n_m: T) -> T {
        force_n.dot(self.velocity(part, point_m)) + moment_n_m * self.forbidden[part].angular
    }

    /// f and its gradient: |R| of a revolute joint, |N1| + |N2| of a slider.
    #[inline(always)]
    fn carried(&self, parts: [T; PARTS]) -> (T, [T; PARTS]) {
        let [a, b] = parts;
        if self.is_slider {
            let sign = |value: T| T::select(value.less_than(T::zero()), -T::one(), T::one());
            return (a.abs() + b.abs(), [sign(a), sign(b)]);
        }
        let size = a.mul_add(a, b * b).sqrt();
        let inverse = T::one() / size.max(T::from_f64(f64::MIN_POSITIVE.sqrt()));
        (size, [a * inverse, b * inverse])
    }
}

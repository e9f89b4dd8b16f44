//! Outputs read off the state of a mechanism.

use super::equations::Dynamics;
use crate::mechanism::{Arms, Kinematics, Mechanism, Twist};
use crate::model::{Actuator, BodyId, JointId, OutputState, Position, Reading};
use loosepin_math::{Real, Vec2};

/// The last state of the equations of motion, with the points of the bodies.
struct LastState<'s, 'd, T: Real> {
    arms: &'s Arms<T>,
    dynamics: &'s Dynamics<'d, T>,
}

impl<T: Real> OutputState<T> for LastState<'_, '_, T> {
    #[inline(always)]
    fn position(&self, of: Position) -> T {
        let (mechanism, kinematics) = (self.dynamics.mechanism(), &self.dynamics.kinematics);
        of.value(&mechanism.real, kinematics, |point| self.arms.of(point))
    }

    #[inline(always)]
    fn velocity(&self, of: Position) -> T {
        let (mechanism, kinematics) = (self.dynamics.mechanism(), &self.dynamics.kinematics);
        of.velocity(&mechanism.real, kinematics, |point| self.arms.of(point))
    }

    #[inline(always)]
    fn acceleration(&self, of: Position) -> T {
        let (mechanism, kinematics) = (self.dynamics.mechanism(), &self.dynamics.kinematics);
        let acceleration = |slot| self.dynamics.acceleration(slot);
        of.acceleration(&mechanism.real, kinematics, acceleration, |point| self.arms.of(point))
    }

    #[inline(always)]
    fn joint_force_n(&self, joint: JointId) -> Vec2<T> {
        self.dynamics.joint_force_n(joint)
    }

    #[inline(always)]
    fn effort_and_rate(&self, actuator: Actuator) -> [T; 2] {
        self.dynamics.effort_and_rate(actuator)
    }

    #[inline(always)]
    fn largest_stress_pa(&self, body: BodyId) -> T {
        self.dynamics.largest_stress_pa(body)
    }
}

impl Reading {
    /// The value at the last state of `dynamics`, SI.
    #[inline(always)]
    pub fn value<T: Real>(&self, arms: &Arms<T>, dynamics: &Dynamics<'_, T>) -> T {
        self.value_at(&LastState { arms, dynamics })
    }

    /// Value and first two time derivatives of a position or angle at the last state of `dynamics`.
    #[inline(always)]
    pub fn jet<T: Real>(&self, arms: &Arms<T>, dynamics: &Dynamics<'_, T>) -> [T; 3] {
        self.position_jet(arms, dynamics.mechanism(), &dynamics.kinematics, |slot| dynamics.acceleration(slot))
    }

    /// The value from poses and velocities by slot of the real tree, and the acceleration of each slot. Zeros for what is
    /// neither a position nor an angle.
    #[inline(always)]
    pub fn position_jet<T: Real>(
        &self,
        arms: &Arms<T>,
        mechanism: &Mechanism,
        kinematics: &Kinematics<T>,
        acceleration: impl Fn(usize) -> Twist<T>,
    ) -> [T; 3] {
        match self.position() {
            Some(of) => of.jet(&mechanism.real, kinematics, acceleration, |point| arms.of(point)),
            None => [T::zero(); 3],
        }
    }
}

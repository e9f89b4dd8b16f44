//! Positions and angles with their time derivatives, seen from the ground or from another body.
//!
//! An observer sits at a point O of a body with angle θ, angular velocity ω and angular acceleration α. With d the way from O to
//! the point that is seen, R the rotation by θ and J the turn by 90°, the point is seen at r and moves with r′ and r″:
//!
//! ```text
//! r  = Rᵀ d
//! r′ = Rᵀ (d′ - ω J d)
//! r″ = Rᵀ (d″ - α J d - 2 ω J d′ - ω² d)
//! ```
//!
//! The last three terms are the Euler, Coriolis and centrifugal parts.

use crate::mechanism::tree::kinematics::{Kinematics, Pose, Twist, acceleration_at};
use crate::mechanism::tree::spanning_tree::Tree;
use crate::model::{Axis, BodyId, PointId, Position};
use loosepin_math::{Real, Vec2};

impl Position {
    /// The value, m or rad. `arm_m` gives the position of a point in its body's frame.
    #[inline(always)]
    pub fn value<T: Real>(self, tree: &Tree, kinematics: &Kinematics<T>, arm_m: impl Fn(PointId) -> Vec2<T>) -> T {
        match self {
            Self::Point(relative, axis) => {
                let of = Point::new(relative.of, tree, kinematics, &arm_m);
                let Some(from) = relative.to else { return along(of.position_m, axis) };
                along(of.seen_from(&Point::new(from, tree, kinematics, &arm_m)), axis)
            }
            Self::Angle(relative) => {
                let angle_rad = |body: BodyId| kinematics.poses[tree.slot_of_body[body.0]].angle_rad();
                relative.to.map_or(angle_rad(relative.of), |from| angle_rad(relative.of) - angle_rad(from))
            }
        }
    }

    /// The first time derivative, m/s or rad/s.
    #[inline(always)]
    pub fn velocity<T: Real>(self, tree: &Tree, kinematics: &Kinematics<T>, arm_m: impl Fn(PointId) -> Vec2<T>) -> T {
        match self {
            Self::Point(relative, axis) => {
                let of = Point::new(relative.of, tree, kinematics, &arm_m);
                let Some(from) = relative.to else { return along(of.velocity_m_s(), axis) };
                along(of.velocity_seen_from(&Point::new(from, tree, kinematics, &arm_m)), axis)
            }
            Self::Angle(relative) => {
                let rate_rad_s = |body: BodyId| kinematics.twists[tree.slot_of_body[body.0]].angular;
                relative.to.map_or(rate_rad_s(relative.of), |from| rate_rad_s(relative.of) - rate_rad_s(from))
            }
        }
    }

    /// The second time derivative, m/s² or rad/s². `acceleration` gives the acceleration of the frame in a slot.
    #[inline(always)]
    pub fn acceleration<T: Real>(
        self,
        tree: &Tree,
        kinematics: &Kinematics<T>,
        acceleration: impl Fn(usize) -> Twist<T>,
        arm_m: impl Fn(PointId) -> Vec2<T>,
    ) -> T {
        match self {
            Self::Point(relative, axis) => {
                let of = Point::new(relative.of, tree, kinematics, &arm_m);
                let Some(from) = relative.to else { return along(of.acceleration_m_s2(&acceleration), axis) };
                let from = Point::new(from, tree, kinematics, &arm_m);
                along(of.acceleration_seen_from(&from, &acceleration), axis)
            }
            Self::Angle(relative) => {
                let change_rad_s2 = |body: BodyId| acceleration(tree.slot_of_body[body.0]).angular;
                relative.to.map_or(change_rad_s2(relative.of), |from| change_rad_s2(relative.of) - change_rad_s2(from))
            }
        }
    }

    /// Value and first two time derivatives.
    #[inline(always)]
    pub fn jet<T: Real>(
        self,
        tree: &Tree,
        kinematics: &Kinematics<T>,
        acceleration: impl Fn(usize) -> Twist<T>,
        arm_m: impl Fn(PointId) -> Vec2<T>,
    ) -> [T; 3] {
        [
            self.value(tree, kinematics, &arm_m),
            self.velocity(tree, kinematics, &arm_m),
            self.acceleration(tree, kinematics, acceleration, &arm_m),
        ]
    }
}

/// A point of a body with the motion of that body, all in the frame of the ground.
struct Point<'a, T: Real> {
    slot: usize,
    pose: &'a Pose<T>,
    twist: &'a Twist<T>,
    /// From the origin of the body to the point, m.
    arm_m: Vec2<T>,
    position_m: Vec2<T>,
}

impl<'a, T: Real> Point<'a, T> {
    #[inline(always)]
    fn new(id: PointId, tree: &Tree, kinematics: &'a Kinematics<T>, arm_m: &impl Fn(PointId) -> Vec2<T>) -> Self {
        let slot = tree.slot_of_point(id);
        let (pose, twist) = (&kinematics.poses[slot], &kinematics.twists[slot]);
        let arm_m = pose.turn(arm_m(id));
        Self { slot, pose, twist, arm_m, position_m: pose.position_m + arm_m }
    }

    #[inline(always)]
    fn velocity_m_s(&self) -> Vec2<T> {
        self.twist.at(self.arm_m)
    }

    #[inline(always)]
    fn acceleration_m_s2(&self, acceleration: &impl Fn(usize) -> Twist<T>) -> Vec2<T> {
        acceleration_at(&acceleration(self.slot), self.twist, self.arm_m)
    }

    /// r = Rᵀ d.
    #[inline(always)]
    fn seen_from(&self, from: &Self) -> Vec2<T> {
        from.pose.turn_back(self.position_m - from.position_m)
    }

    /// r′ = Rᵀ (d′ - ω J d).
    #[inline(always)]
    fn velocity_seen_from(&self, from: &Self) -> Vec2<T> {
        let way_m = self.position_m - from.position_m;
        let rate_m_s = self.velocity_m_s() - from.velocity_m_s();
        from.pose.turn_back(rate_m_s.plus(way_m.turned(), -from.twist.angular))
    }

    /// r″ = Rᵀ (d″ - α J d - 2 ω J d′ - ω² d).
    #[inline(always)]
    fn acceleration_seen_from(&self, from: &Self, acceleration: &impl Fn(usize) -> Twist<T>) -> Vec2<T> {
        let way_m = self.position_m - from.position_m;
        let rate_m_s = self.velocity_m_s() - from.velocity_m_s();
        let change_m_s2 = self.acceleration_m_s2(acceleration) - from.acceleration_m_s2(acceleration);
        let rate_rad_s = from.twist.angular;
        let seen_m_s2 = change_m_s2
            .plus(way_m.turned(), -acceleration(from.slot).angular)
            .plus(rate_m_s.turned(), -(rate_rad_s + rate_rad_s))
            .plus(way_m, -rate_rad_s.squared());
        from.pose.turn_back(seen_m_s2)
    }
}

#[inline(always)]
fn along<T>(vector: Vec2<T>, axis: Axis) -> T {
    match axis {
        Axis::X => vector.x,
        Axis::Y => vector.y,
    }
}

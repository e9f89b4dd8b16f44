//! Poses, velocities and accelerations of all bodies from the coordinates of the tree.
//!
//! Everything is linear in the rates: the velocity of a body origin is Σ partial_k · rate_k, its angular velocity
//! Σ turning_k · rate_k (Kane's partial velocities). Accelerations are that plus a bias from the rates alone.

use crate::mechanism::tree::beam::BeamPlace;
use crate::mechanism::tree::geometry::{Geometry, LinkGeometry};
use crate::mechanism::tree::spanning_tree::{Attachment, Tree};
use loosepin_math::{KnownAngle, Real, Vec2, sin_cos_near};

/// Position and angle of a body frame, seen from the ground.
#[derive(Debug, Clone, Copy)]
pub struct Pose<T> {
    /// p_wb: position of the frame's origin, m.
    pub position_m: Vec2<T>,
    /// Angle of the frame's x axis from the ground's, rad, continuous.
    pub angle_rad: T,
    /// Sine of the angle.
    pub sine: T,
    /// Cosine of the angle.
    pub cosine: T,
}

impl<T: Real> Pose<T> {
    #[inline(always)]
    fn ground() -> Self {
        Self { position_m: Vec2::zero(), angle_rad: T::zero(), sine: T::zero(), cosine: T::one() }
    }
    /// A vector of the body frame, seen from the ground.
    #[inline(always)]
    pub fn turn(&self, arm_m: Vec2<T>) -> Vec2<T> {
        arm_m.rotated(self.sine, self.cosine)
    }
    /// A vector of the ground's frame, seen from the body.
    #[inline(always)]
    pub fn turn_back(&self, vector: Vec2<T>) -> Vec2<T> {
        vector.rotated(-self.sine, self.cosine)
    }
    /// A point of the body frame, seen from the ground.
    #[inline(always)]
    pub fn point_m(&self, arm_m: Vec2<T>) -> Vec2<T> {
        self.position_m + self.turn(arm_m)
    }
}

/// A velocity of a body frame, or an acceleration: linear part of the origin and angular part.
#[derive(Debug, Clone, Copy)]
pub struct Twist<T> {
    /// Vector of the frame's origin, m/s or m/s².
    pub linear: Vec2<T>,
    /// rad/s or rad/s².
    pub angular: T,
}

impl<T: Real> Twist<T> {
    #[inline(always)]
    fn zero() -> Self {
        Self { linear: Vec2::zero(), angular: T::zero() }
    }
    /// Velocity of the point that lies at `arm_m` (ground's frame) from the origin.
    #[inline(always)]
    pub fn at(&self, arm_m: Vec2<T>) -> Vec2<T> {
        self.linear.plus(arm_m.turned(), self.angular)
    }
}

/// Acceleration of the point at `arm_m` (ground's frame) of a body with velocity `twist` and acceleration `change`.
#[inline(always)]
pub fn acceleration_at<T: Real>(change: &Twist<T>, twist: &Twist<T>, arm_m: Vec2<T>) -> Vec2<T> {
    change.at(arm_m).plus(arm_m, -twist.angular.squared())
}

/// Poses, partial velocities, velocities and acceleration biases of all bodies, by slot.
#[derive(Debug, Clone)]
pub struct Kinematics<T> {
    /// Poses by slot.
    pub poses: Vec<Pose<T>>,
    /// Velocities by slot.
    pub twists: Vec<Twist<T>>,
    /// Accelerations by slot when the free coordinates have none.
    pub biases: Vec<Twist<T>>,
    /// Directions of the prismatic lines by slot (ground's frame), zero elsewhere.
    lines: Vec<Vec2<T>>,
    /// Partial velocities of the frame origins, m per unit of the coordinate, for all dependences of all links in turn.
    partials: Vec<Vec2<T>>,
    /// Offset of the partials of each slot.
    offsets: Vec<usize>,
    /// Angles by slot with their sines and cosines.
    known: Vec<KnownAngle<T>>,
    /// Whether the bodies are no further from these than [`loosepin_math::NEAR_RAD`].
    is_near: bool,
}

impl<T: Real> Kinematics<T> {
    /// Room for `tree`.
    pub fn new(tree: &Tree) -> Self {
        let slots = tree.links.len() + 1;
        let mut offsets = vec![0; slots];
        let mut next = 0;
        for (index, link) in tree.links.iter().enumerate() {
            offsets[index + 1] = next;
            next += link.dependences.len();
        }
        Self {
            poses: vec![Pose::ground(); slots],
            twists: vec![Twist::zero(); slots],
            biases: vec![Twist::zero(); slots],
            lines: vec![Vec2::zero(); slots],
            partials: vec![Vec2::zero(); next],
            offsets,
            known: vec![KnownAngle::zero(); slots],
            is_near: false,
        }
    }

    /// Sets the known angle of a slot.
    #[inline(always)]
    pub fn set_known_angle(&mut self, slot: usize, known: KnownAngle<T>) {
        self.known[slot] = known;
    }

    /// Says whether positions from now on are near the known angles.
    #[inline(always)]
    pub fn set_near(&mut self, is_near: bool) {
        self.is_near = is_near;
    }

    /// A pose of `slot` at the origin with this angle.
    #[inline(always)]
    fn pose(&self, slot: usize, angle_rad: T) -> Pose<T> {
        let (sine, cosine) =
            if self.is_near { sin_cos_near(angle_rad, &self.known[slot]) } else { angle_rad.sin_cos() };
        Pose { position_m: Vec2::zero(), angle_rad, sine, cosine }
    }

    /// Partial velocities of the frame origin of `slot`, in the order of the link's dependences.
    #[inline(always)]
    pub fn partials(&self, slot: usize) -> &[Vec2<T>] {
        match slot {
            0 => &[],
            _ => {
                let end = self.offsets.get(slot + 1).copied().unwrap_or(self.partials.len());
                &self.partials[self.offsets[slot]..end]
            }
        }
    }

    /// Adds the generalised force of a force on the body in `slot` and of its moment about the body's origin to `to`, which has a
    /// number for each coordinate.
    #[inline(always)]
    pub fn add_push(&self, tree: &Tree, slot: usize, force_n: Vec2<T>, about_origin_n_m: T, to: &mut [T]) {
        for (dependence, partial) in tree.links[slot - 1].dependences.iter().zip(self.partials(slot)) {
            let sum = turned_by(to[dependence.coordinate], about_origin_n_m, dependence.turning);
            to[dependence.coordinate] = force_n.x.mul_add(partial.x, force_n.y.mul_add(partial.y, sum));
        }
    }

    /// Poses and partial velocities at `coordinates` (m and rad, free ones first).
    #[inline(never)]
    pub fn set_positions(&mut self, tree: &Tree, geometry: &Geometry<T>, coordinates: &[T]) {
        for (index, (link, numbers)) in tree.links.iter().zip(&geometry.links).enumerate() {
            let slot = index + 1;
            let parent = self.poses[link.parent_slot];
            let parent_arm = parent.turn(numbers.parent_arm_m);
            let inherited = link.dependences.len();
            let offset = self.offsets[slot];
            let parent_offset = self.offsets[link.parent_slot];
            match link.attachment {
                Attachment::Free { first } => {
                    self.poses[slot] = self.pose(slot, coordinates[first + 2]);
                    self.poses[slot].position_m = Vec2::new(coordinates[first], coordinates[first + 1]);
                    self.partials[offset] = Vec2::new(T::one(), T::zero());
                    self.partials[offset + 1] = Vec2::new(T::zero(), T::one());
                    self.partials[offset + 2] = Vec2::zero();
                }
                Attachment::Revolute { coordinate, .. } => {
                    let mut own = self.pose(slot, coordinates[coordinate]);
                    let own_arm = own.turn(numbers.own_arm_m);
                    own.position_m = parent.position_m + parent_arm + numbers.eccentricity_m - own_arm;
                    self.poses[slot] = own;
                    let arm = parent_arm.turned();
                    for k in 0..inherited - 1 {
                        let turning = self.turning_of_parent(tree, link.parent_slot, k);
                        self.partials[offset + k] = moved(self.partials[parent_offset + k], arm, turning);
                    }
                    self.partials[offset + inherited - 1] = -own_arm.turned();
                }
                Attachment::DrivenRevolute { coordinate, forward, .. } => {
                    let angle = coordinates[coordinate];
                    let mut own = self.pose(slot, parent.angle_rad + if forward { angle } else { -angle });
                    let own_arm = own.turn(numbers.own_arm_m);
                    own.position_m = parent.position_m + parent_arm - own_arm;
                    self.poses[slot] = own;
                    self.carry_partials(tree, link.parent_slot, slot, inherited - 1);
                    let arm = own_arm.turned();
                    self.partials[offset + inherited - 1] = if forward { -arm } else { arm };
                }
                Attachment::Prismatic { coordinate, forward, .. } => {
                    let direction = parent.turn(numbers.parent_direction);
                    let direction = if forward { direction } else { -direction };
                    let mut own = turned_with(&parent, numbers);
                    let own_arm = own.turn(numbers.own_arm_m);
                    own.position_m = parent.position_m + parent_arm + direction * coordinates[coordinate] - own_arm;
                    self.poses[slot] = own;
                    self.lines[slot] = direction;
                    self.carry_partials(tree, link.parent_slot, slot, inherited - 1);
                    self.partials[offset + inherited - 1] = direction;
                }
                Attachment::Section { beam, place } => {
                    self.set_section(tree, geometry, slot, (beam, place), coordinates)
                }
                Attachment::Node { beam, first } => {
                    let mut own = self.pose(slot, coordinates[first + 2]);
                    let arm = own.turn(geometry.nodal_beams[beam].tip_m);
                    own.position_m = Vec2::new(coordinates[first], coordinates[first + 1]) - arm;
                    self.poses[slot] = own;
                    self.partials[offset] = Vec2::new(T::one(), T::zero());
                    self.partials[offset + 1] = Vec2::new(T::zero(), T::one());
                    self.partials[offset + 2] = -arm.turned();
                }
                Attachment::Rigid { .. } => {
                    let mut own = turned_with(&parent, numbers);
                    own.position_m = parent.position_m + parent_arm - own.turn(numbers.own_arm_m);
                    self.poses[slot] = own;
                    self.carry_partials(tree, link.parent_slot, slot, inherited);
                }
            }
        }
    }

    /// Velocities for the rates of all coordinates (m/s and rad/s). Needs [`Self::set_positions`].
    #[inline(never)]
    pub fn set_velocities(&mut self, tree: &Tree, rates: &[T]) {
        for (index, link) in tree.links.iter().enumerate() {
            let slot = index + 1;
            let offset = self.offsets[slot];
            let mut twist = Twist::zero();
            for (k, dependence) in link.dependences.iter().enumerate() {
                let rate = rates[dependence.coordinate];
                twist.linear = twist.linear.plus(self.partials[offset + k], rate);
                twist.angular = turned_by(twist.angular, rate, dependence.turning);
            }
            self.twists[slot] = twist;
        }
    }

    /// Accelerations that the rates cause when the free coordinates have none and the driven ones have
    /// `driven_accelerations` (in the order of the tree's drives). Needs [`Self::set_velocities`].
    #[inline(never)]
    pub fn set_biases(&mut self, tree: &Tree, geometry: &Geometry<T>, rates: &[T], driven_accelerations: &[T]) {
        for (index, (link, numbers)) in tree.links.iter().zip(&geometry.links).enumerate() {
            let slot = index + 1;
            let parent_arm = self.poses[link.parent_slot].turn(numbers.parent_arm_m);
            let parent_bias = self.biases[link.parent_slot];
            let parent_twist = self.twists[link.parent_slot];
            let own_twist = self.twists[slot];
            let at_joint = acceleration_at(&parent_bias, &parent_twist, parent_arm);
            self.biases[slot] = match link.attachment {
                Attachment::Free { .. } => Twist::zero(),
                Attachment::Revolute { .. } => {
                    let own_arm = self.poses[slot].turn(numbers.own_arm_m);
                    Twist { linear: at_joint.plus(own_arm, own_twist.angular.squared()), angular: T::zero() }
                }
                Attachment::DrivenRevolute { coordinate, forward, .. } => {
                    let driven = driven_accelerations[coordinate - tree.free];
                    let angular = parent_bias.angular + if forward { driven } else { -driven };
                    let own_arm = self.poses[slot].turn(numbers.own_arm_m);
                    let linear = at_joint.plus(own_arm.turned(), -angular).plus(own_arm, own_twist.angular.squared());
                    Twist { linear, angular }
                }
                Attachment::Prismatic { coordinate, .. } => {
                    let reach = self.poses[slot].position_m - self.poses[link.parent_slot].position_m;
                    let direction = self.lines[slot];
                    let two = T::from_f64(2.0);
                    let coriolis = direction.turned() * (two * parent_twist.angular * rates[coordinate]);
                    let mut linear = acceleration_at(&parent_bias, &parent_twist, reach) + coriolis;
                    if coordinate >= tree.free {
                        linear += direction * driven_accelerations[coordinate - tree.free];
                    }
                    Twist { linear, angular: parent_bias.angular }
                }
                Attachment::Section { beam, place } => self.section_bias(tree, geometry, slot, (beam, place), rates),
                Attachment::Node { beam, .. } => {
                    let arm = self.poses[slot].turn(geometry.nodal_beams[beam].tip_m);
                    Twist { linear: arm * own_twist.angular.squared(), angular: T::zero() }
                }
                Attachment::Rigid { .. } => {
                    let reach = self.poses[slot].position_m - self.poses[link.parent_slot].position_m;
                    let linear = acceleration_at(&parent_bias, &parent_twist, reach);
                    Twist { linear, angular: parent_bias.angular }
                }
            };
        }
    }

    /// Acceleration of the frame of `slot` when the free coordinates accelerate with `free_accelerations`.
    #[inline(always)]
    pub fn acceleration(&self, tree: &Tree, slot: usize, free_accelerations: &[T]) -> Twist<T> {
        let mut total = self.biases[slot];
        if slot > 0 {
            for (dependence, partial) in tree.links[slot - 1].dependences.iter().zip(self.partials(slot)) {
                if let Some(&acceleration) = free_accelerations.get(dependence.coordinate) {
                    total.linear = total.linear.plus(*partial, acceleration);
                    total.angular = turned_by(total.angular, acceleration, dependence.turning);
                }
            }
        }
        total
    }

    /// Pose and partial velocities of a section. Out of line: few mechanisms have one.
    #[inline(never)]
    fn set_section(
        &mut self,
        tree: &Tree,
        geometry: &Geometry<T>,
        slot: usize,
        (index, at): (usize, BeamPlace),
        coordinates: &[T],
    ) {
        let (place, numbers) = (&tree.beams[index], &geometry.beams[index]);
        let (station, q) = (place.station(at), &coordinates[place.coordinates.clone()]);
        let frame = self.poses[place.slot];
        let axis = frame.turn(numbers.axis);
        let mut own = self.pose(slot, frame.angle_rad + numbers.beam.angle_rad(station, q));
        let from_root_m = numbers.beam.point_m(station, q).rotated(axis.y, axis.x);
        let arm = own.turn(numbers.axis_point_m(place, at));
        own.position_m = frame.position_m + frame.turn(numbers.root_m) + from_root_m - arm;
        self.poses[slot] = own;
        let inherited = tree.links[place.slot - 1].dependences.len();
        self.carry_partials(tree, place.slot, slot, inherited);
        let of_shapes = self.offsets[slot] + inherited;
        let dependences = &tree.links[slot - 1].dependences[inherited..];
        let partials = &mut self.partials[of_shapes..of_shapes + dependences.len()];
        match at {
            // The root does not move in the frame.
            BeamPlace::Root => partials.fill(Vec2::zero()),
            BeamPlace::Tip | BeamPlace::Inside(_) => numbers.beam.partials(station, q, partials),
        }
        for (partial, dependence) in partials.iter_mut().zip(dependences) {
            *partial = moved(partial.rotated(axis.y, axis.x), -arm.turned(), dependence.turning);
        }
    }

    /// Acceleration of a section when the free coordinates have none.
    #[inline(never)]
    fn section_bias(
        &self,
        tree: &Tree,
        geometry: &Geometry<T>,
        slot: usize,
        (index, at): (usize, BeamPlace),
        rates: &[T],
    ) -> Twist<T> {
        let (place, numbers) = (&tree.beams[index], &geometry.beams[index]);
        let (frame, twist, bias) = (self.poses[place.slot], self.twists[place.slot], self.biases[place.slot]);
        let own_twist = self.twists[slot];
        let arm = self.poses[slot].turn(numbers.axis_point_m(place, at));
        let reach = self.poses[slot].position_m + arm - frame.position_m;
        // The end moves in the frame with what is left of its velocity.
        let relative = own_twist.at(arm) - twist.at(reach);
        let along = numbers.beam.shortening_m_s2(place.station(at), &rates[place.coordinates.clone()]);
        let at_end = acceleration_at(&bias, &twist, reach)
            .plus(relative.turned(), twist.angular + twist.angular)
            .plus(frame.turn(numbers.axis), along);
        let linear = at_end.plus(arm.turned(), -bias.angular).plus(arm, own_twist.angular.squared());
        Twist { linear, angular: bias.angular }
    }

    /// The first `count` partials of `slot` follow those of its parent, with which it turns.
    #[inline(always)]
    fn carry_partials(&mut self, tree: &Tree, parent_slot: usize, slot: usize, count: usize) {
        let reach = (self.poses[slot].position_m - self.poses[parent_slot].position_m).turned();
        for k in 0..count {
            let turning = self.turning_of_parent(tree, parent_slot, k);
            self.partials[self.offsets[slot] + k] = moved(self.partials[self.offsets[parent_slot] + k], reach, turning);
        }
    }

    #[inline(always)]
    fn turning_of_parent(&self, tree: &Tree, parent_slot: usize, k: usize) -> f64 {
        tree.links[parent_slot - 1].dependences[k].turning
    }
}

/// `velocity + arm · turning`; without a product for a turning of 0, 1 or -1.
#[inline(always)]
pub fn moved<T: Real>(velocity: Vec2<T>, arm: Vec2<T>, turning: f64) -> Vec2<T> {
    if turning == 0.0 {
        velocity
    } else if turning == 1.0 {
        velocity + arm
    } else if turning == -1.0 {
        velocity - arm
    } else {
        velocity.plus(arm, T::from_f64(turning))
    }
}

/// `sum + value · turning`; without a product for a turning of 0, 1 or -1.
#[inline(always)]
pub fn turned_by<T: Real>(sum: T, value: T, turning: f64) -> T {
    if turning == 0.0 {
        sum
    } else if turning == 1.0 {
        sum + value
    } else if turning == -1.0 {
        sum - value
    } else {
        value.mul_add(T::from_f64(turning), sum)
    }
}

/// A pose at the origin of a link that does not turn against its parent: sine and cosine by the addition theorem.
#[inline(always)]
fn turned_with<T: Real>(parent: &Pose<T>, numbers: &LinkGeometry<T>) -> Pose<T> {
    let direction = parent.turn(numbers.turn_from_parent);
    Pose {
        position_m: Vec2::zero(),
        angle_rad: parent.angle_rad + numbers.parent_angle_rad - numbers.own_angle_rad,
        sine: direction.y,
        cosine: direction.x,
    }
}

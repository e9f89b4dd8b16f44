//! Poses, velocities and accelerations of all bodies of a tree, in every geometry: what [`motion`](super::motion) finds from its coordinates.
//!
//! Everything is linear in the rates: the velocity of a body origin is Σ partial_k · rate_k, its angular velocity
//! Σ turning_k · rate_k (Kane's partial velocities). Accelerations are that plus a bias from the rates alone.

use crate::mechanism::attachment::TreeGeometry;
use crate::mechanism::tree::spanning_tree::{Link, Tree};
use loosepin_math::{Geometry, KnownAngle, Plane, Real, Vector};

/// Position and orientation of a body frame, seen from the ground.
#[derive(Debug, Clone, Copy)]
pub struct Pose<T: Real, G: Geometry = Plane> {
    /// p_wb: position of the frame's origin, m.
    pub position_m: G::Vector<T>,
    /// The turn of its axes from the ground's.
    pub rotation: G::Rotation<T>,
}

impl<T: Real, G: Geometry> Pose<T, G> {
    #[inline(always)]
    pub(super) fn ground() -> Self {
        Self { position_m: G::Vector::zero(), rotation: G::unturned() }
    }
    /// A vector of the body frame, seen from the ground.
    #[inline(always)]
    pub fn turn(&self, arm_m: G::Vector<T>) -> G::Vector<T> {
        G::turn(&self.rotation, arm_m)
    }
    /// A vector of the ground's frame, seen from the body.
    #[inline(always)]
    pub fn turn_back(&self, vector: G::Vector<T>) -> G::Vector<T> {
        G::turn_back(&self.rotation, vector)
    }
    /// A point of the body frame, seen from the ground.
    #[inline(always)]
    pub fn point_m(&self, arm_m: G::Vector<T>) -> G::Vector<T> {
        self.position_m + self.turn(arm_m)
    }
}

impl<T: Real> Pose<T> {
    /// Angle of the frame's x axis from the ground's, rad, continuous.
    #[inline(always)]
    pub fn angle_rad(&self) -> T {
        self.rotation.angle_rad
    }
}

/// A velocity of a body frame, or an acceleration: linear part of the origin and angular part.
#[derive(Debug, Clone, Copy)]
pub struct Twist<T: Real, G: Geometry = Plane> {
    /// Vector of the frame's origin, m/s or m/s².
    pub linear: G::Vector<T>,
    /// rad/s or rad/s².
    pub angular: G::Spin<T>,
}

impl<T: Real, G: Geometry> Twist<T, G> {
    /// At rest.
    #[inline(always)]
    pub fn zero() -> Self {
        Self { linear: G::Vector::zero(), angular: G::at_rest() }
    }
    /// Velocity of the point that lies at `arm_m` (ground's frame) from the origin.
    #[inline(always)]
    pub fn at(&self, arm_m: G::Vector<T>) -> G::Vector<T> {
        G::carried(self.linear, self.angular, arm_m)
    }
}

/// Acceleration of the point at `arm_m` (ground's frame) of a body with velocity `twist` and acceleration `change`.
#[inline(always)]
pub fn acceleration_at<T: Real, G: Geometry>(
    change: &Twist<T, G>,
    twist: &Twist<T, G>,
    arm_m: G::Vector<T>,
) -> G::Vector<T> {
    G::centripetal(change.at(arm_m), twist.angular, arm_m)
}

/// Velocity of a body for a unit rate of a coordinate.
#[derive(Debug, Clone, Copy)]
pub struct Column<T: Real, G: Geometry = Plane> {
    /// Index of the coordinate, among the speeds.
    pub coordinate: usize,
    /// Of the frame's origin, m per unit of the coordinate.
    pub linear: G::Vector<T>,
    /// Angular velocity: in the plane 0, 1 or -1 (0 for a displacement, whose rate is a length); at a point inside a beam, φ' of its lateral
    /// shapes there.
    pub turning: G::Turning<T>,
}

impl<T: Real, G: Geometry> Column<T, G> {
    /// Velocity of the point at `arm_m` (ground's frame) from the origin.
    #[inline(always)]
    pub fn at(&self, arm_m: G::Vector<T>) -> G::Vector<T> {
        G::moved(self.linear, self.turning, arm_m)
    }
}

/// Poses, partial velocities, velocities and acceleration biases of all bodies, by slot.
#[derive(Debug, Clone)]
pub struct Kinematics<T: Real, G: TreeGeometry = Plane> {
    /// Poses by slot.
    pub poses: Vec<Pose<T, G>>,
    /// Velocities by slot.
    pub twists: Vec<Twist<T, G>>,
    /// Accelerations by slot when the free coordinates have none.
    pub biases: Vec<Twist<T, G>>,
    /// Partial velocities of the frame origins, m per unit of the coordinate, for all dependences of all links in turn.
    pub(super) partials: Vec<G::Vector<T>>,
    /// Partial angular velocities, for the same.
    pub(super) turnings: Vec<G::Turning<T>>,
    /// Offset of the partials of each slot.
    pub(super) offsets: Vec<usize>,
    /// Angles by slot with their sines and cosines.
    pub(super) known: Vec<KnownAngle<T>>,
    /// Whether the bodies are no further from these than [`loosepin_math::NEAR_RAD`].
    pub(super) is_near: bool,
}

impl<T: Real, G: TreeGeometry> Kinematics<T, G> {
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

    #[inline(always)]
    fn range(&self, slot: usize) -> core::ops::Range<usize> {
        if slot == 0 { 0..0 } else { self.offsets[slot]..self.offsets[slot + 1] }
    }

    /// Velocities of the body in `slot` for unit rates of the coordinates on which its motion depends; none of the ground.
    #[inline(always)]
    pub fn columns<'a>(&'a self, tree: &'a Tree<G>, slot: usize) -> impl Iterator<Item = Column<T, G>> + 'a {
        let (range, dependences) = (self.range(slot), tree.dependences(slot));
        let partials = self.partials[range.clone()].iter().zip(&self.turnings[range]);
        dependences.iter().zip(partials).map(|(coordinate, (linear, turning))| Column {
            coordinate: *coordinate,
            linear: *linear,
            turning: *turning,
        })
    }

    /// The first turning of the own coordinates of a body.
    #[inline(always)]
    pub(in crate::mechanism) fn own_turning(&self, slot: usize, link: &Link<G>) -> G::Turning<T> {
        self.turnings[self.offsets[slot] + link.inherited]
    }

    /// The first partial velocity of the own coordinates of a body.
    #[inline(always)]
    pub(in crate::mechanism) fn own_linear(&self, slot: usize, link: &Link<G>) -> G::Vector<T> {
        self.partials[self.offsets[slot] + link.inherited]
    }

    /// Acceleration of the point at `arm_m` (ground's frame) of a body when the free coordinates have none.
    #[inline(always)]
    pub(in crate::mechanism) fn bias_at(&self, slot: usize, arm_m: G::Vector<T>) -> G::Vector<T> {
        acceleration_at(&self.biases[slot], &self.twists[slot], arm_m)
    }

    /// Adds the generalised force of a force on the body in `slot` and of its moment about the body's origin to `to`, which has a
    /// number for each coordinate.
    #[inline(always)]
    pub fn add_push(
        &self,
        tree: &Tree<G>,
        slot: usize,
        force_n: G::Vector<T>,
        about_origin_n_m: G::Spin<T>,
        to: &mut [T],
    ) {
        for Column { coordinate, linear, turning } in self.columns(tree, slot) {
            to[coordinate] = force_n.inner_plus(linear, G::push(about_origin_n_m, turning, to[coordinate]));
        }
    }

    /// Velocities for the rates of all coordinates (m/s and rad/s). Needs [`Self::set_positions`].
    #[inline(never)]
    pub fn set_velocities(&mut self, tree: &Tree<G>, rates: &[T]) {
        for slot in 1..self.twists.len() {
            let mut twist = Twist::<T, G>::zero();
            for Column { coordinate, linear, turning } in self.columns(tree, slot) {
                let rate = rates[coordinate];
                twist.linear = twist.linear.plus(linear, rate);
                twist.angular = G::turned(twist.angular, turning, rate);
            }
            self.twists[slot] = twist;
        }
    }

    /// Acceleration of the frame of `slot` when the free coordinates accelerate with `free_accelerations`.
    #[inline(always)]
    pub fn acceleration(&self, tree: &Tree<G>, slot: usize, free_accelerations: &[T]) -> Twist<T, G> {
        let mut total = self.biases[slot];
        for Column { coordinate, linear, turning } in self.columns(tree, slot) {
            if let Some(&acceleration) = free_accelerations.get(coordinate) {
                total.linear = total.linear.plus(linear, acceleration);
                total.angular = G::turned(total.angular, turning, acceleration);
            }
        }
        total
    }
}

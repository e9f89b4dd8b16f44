//! The equations of motion in space (Kane). A planar mechanism lies in it with z = 0 and all axes along z.

use crate::joints::{held, oriented, quaternion_rates, revolved};
use crate::numbers::{LinkNumbers, Numbers};
use loosepin_math::{Envelope, GramSystem, Real};
use loosepin_mechanics::contact::{NormalContact, PlayState};
use parts::{Attachment, Link, Matrix3, Tree, Vector3};

/// Rows of a revolute joint that closes a loop: three of the point, two of the axis.
const ROWS: usize = 5;

/// Position of the origin of a body, and its orientation.
#[derive(Debug, Clone, Copy)]
pub struct Pose<T: Real> {
    pub position: Vector3<T>,
    pub rotation: Matrix3<T>,
}

/// A velocity of a body, or an acceleration.
#[derive(Debug, Clone, Copy)]
pub struct Twist<T: Real> {
    pub linear: Vector3<T>,
    pub spin: Vector3<T>,
}

/// A contact at the last evaluation.
#[derive(Debug, Clone, Copy)]
pub struct Contact<T: Real> {
    pub penetration: T,
    pub rate: T,
    pub normal_force: T,
    pub normal: Vector3<T>,
    arms: [Vector3<T>; 2],
}

/// The equations with room for an evaluation.
#[derive(Debug, Clone)]
pub struct Kernel<'t, T: Real> {
    tree: &'t Tree,
    numbers: Numbers<T>,
    pub poses: Vec<Pose<T>>,
    pub twists: Vec<Twist<T>>,
    biases: Vec<Twist<T>>,
    lines: Vec<Vector3<T>>,
    /// Partial velocities of the origins and turnings, for all dependences of all links in turn.
    partials: Vec<Vector3<T>>,
    turnings: Vec<Vector3<T>>,
    offsets: Vec<usize>,
    centre_partials: Vec<(Vector3<T>, [Vector3<T>; 2])>,
    pub contacts: Vec<Contact<T>>,
    envelope: Envelope,
    mass: Vec<T>,
    forces: Vec<T>,
    pub accelerations: Vec<T>,
    jacobian: Vec<T>,
    multipliers: Vec<T>,
    gram: GramSystem<T>,
}

impl<'t, T: Real> Kernel<'t, T> {
    pub fn new(tree: &'t Tree, numbers: Numbers<T>) -> Self {
        let slots = tree.links.len() + 1;
        let (offsets, partials) = tree.offsets();
        let (free, speeds) = (tree.free_speeds, tree.free_speeds + tree.driven);
        let rows = ROWS * tree.cuts.len();
        let scales = (0..tree.cuts.len()).flat_map(|cut| {
            let first = cut * ROWS;
            (0..ROWS).map(move |row| if row < 2 { [first, first + 1] } else { [first + row; 2] })
        });
        let ground = Pose { position: Vector3::zero(), rotation: Matrix3::identity() };
        let rest = Twist { linear: Vector3::zero(), spin: Vector3::zero() };
        let zero = Vector3::zero();
        let open =
            Contact { penetration: T::zero(), rate: T::zero(), normal_force: T::zero(), normal: zero, arms: [zero; 2] };
        Self {
            poses: vec![ground; slots],
            twists: vec![rest; slots],
            biases: vec![rest; slots],
            lines: vec![zero; slots],
            partials: vec![zero; partials],
            turnings: vec![Vector3::zero(); partials],
            offsets,
            centre_partials: Vec::with_capacity(speeds),
            contacts: vec![open; tree.plays.len()],
            envelope: Envelope::new(tree.mass_rows()),
            mass: vec![T::zero(); free * free],
            forces: vec![T::zero(); speeds],
            accelerations: vec![T::zero(); free],
            jacobian: vec![T::zero(); rows * speeds],
            multipliers: vec![T::zero(); rows],
            gram: GramSystem::new(scales.collect(), free),
            tree,
            numbers,
        }
    }

    /// Accelerations, from coordinates and speeds with the driven ones last, and the accelerations of the driven ones.
    #[inline(always)]
    pub fn evaluate(&mut self, coordinates: &[T], speeds: &[T], driven: &[T], states: &[PlayState<T>]) {
        self.set_positions(coordinates);
        self.set_velocities(speeds);
        self.set_biases(speeds, driven);
        self.set_contacts(states);
        self.add_bodies();
        self.add_contacts();
        self.solve();
    }

    /// Rates of the free coordinates.
    pub fn coordinate_rates(&self, coordinates: &[T], speeds: &[T], rates: &mut [T]) {
        for link in self.tree.links.iter().filter(|link| !link.is_driven) {
            let (first, speed) = (link.coordinates.start, link.speeds.start);
            let plain = match link.attachment {
                Attachment::Revolute { .. } | Attachment::Prismatic { .. } => 1,
                Attachment::Free => 3,
                Attachment::Ball | Attachment::Rigid => 0,
            };
            rates[first..first + plain].copy_from_slice(&speeds[speed..speed + plain]);
            if let Attachment::Ball | Attachment::Free = link.attachment {
                quaternion_rates(&coordinates[first + plain..], &speeds[speed + plain..], &mut rates[first + plain..]);
            }
        }
    }

    #[inline(always)]
    fn set_positions(&mut self, coordinates: &[T]) {
        for (index, link) in self.tree.links.iter().enumerate() {
            let slot = index + 1;
            let LinkNumbers { parent_arm, own_arm, mount, .. } = self.numbers.links[index].clone();
            let parent = self.poses[link.parent];
            let own = &coordinates[link.coordinates.start..];
            let parent_arm = parent.rotation.turn(parent_arm);
            let at_joint = parent.position + parent_arm;
            let place = self.offsets[slot] + link.inherited;
            match link.attachment {
                Attachment::Revolute { forward, turns_alone } => {
                    let (rotation, axis) = revolved(&parent.rotation, &mount, own[0], turns_alone, forward);
                    let own_arm = rotation.turn(own_arm);
                    self.poses[slot] = Pose { position: at_joint - own_arm, rotation };
                    self.carry(link, slot, parent_arm);
                    self.partials[place] = Vector3::zero().plus_cross(axis, -own_arm);
                    self.turnings[place] = axis;
                }
                Attachment::Prismatic { forward } => {
                    let line = parent.rotation.turn(mount.parent.column(0));
                    let line = if forward { line } else { -line };
                    let rotation = held(&parent.rotation, &mount);
                    let position = at_joint + line * own[0] - rotation.turn(own_arm);
                    self.poses[slot] = Pose { position, rotation };
                    self.lines[slot] = line;
                    self.carry(link, slot, parent_arm);
                    self.partials[place] = line;
                    self.turnings[place] = Vector3::zero();
                }
                Attachment::Rigid => {
                    let rotation = held(&parent.rotation, &mount);
                    let position = at_joint - rotation.turn(own_arm);
                    self.poses[slot] = Pose { position, rotation };
                    self.carry(link, slot, parent_arm);
                }
                Attachment::Ball => {
                    let rotation = oriented(own);
                    let own_arm = rotation.turn(own_arm);
                    self.poses[slot] = Pose { position: at_joint - own_arm, rotation };
                    self.carry(link, slot, parent_arm);
                    self.orient(place, &rotation, -own_arm);
                }
                Attachment::Free => {
                    let rotation = oriented(&own[3..]);
                    let position = Vector3([own[0], own[1], own[2]]);
                    self.poses[slot] = Pose { position, rotation };
                    for k in 0..3 {
                        self.partials[place + k] = Matrix3::identity().0[k];
                        self.turnings[place + k] = Vector3::zero();
                    }
                    self.orient(place + 3, &rotation, Vector3::zero());
                }
            }
        }
    }

    /// Partial velocities of the parent, carried to the origin of `slot`.
    #[inline(always)]
    fn carry(&mut self, link: &Link, slot: usize, parent_arm: Vector3<T>) {
        let (from, to) = (self.offsets[link.parent], self.offsets[slot]);
        let alone = link.attachment.turns_alone();
        let reach = if alone { parent_arm } else { self.poses[slot].position - self.poses[link.parent].position };
        for k in 0..link.inherited {
            let turning = self.turnings[from + k];
            self.partials[to + k] = self.partials[from + k].plus_cross(turning, reach);
            self.turnings[to + k] = if alone { Vector3::zero() } else { turning };
        }
    }

    #[inline(always)]
    fn orient(&mut self, place: usize, rotation: &Matrix3<T>, arm: Vector3<T>) {
        for (k, turning) in rotation.transposed().0.iter().enumerate() {
            self.partials[place + k] = Vector3::zero().plus_cross(*turning, arm);
            self.turnings[place + k] = *turning;
        }
    }

    #[inline(always)]
    fn set_velocities(&mut self, speeds: &[T]) {
        for (index, link) in self.tree.links.iter().enumerate() {
            let (slot, offset) = (index + 1, self.offsets[index + 1]);
            let mut twist: Twist<T> = Twist { linear: Vector3::zero(), spin: Vector3::zero() };
            for (k, speed) in link.dependences.iter().enumerate() {
                twist.linear = twist.linear.plus(self.partials[offset + k], speeds[*speed]);
                twist.spin = twist.spin.plus(self.turnings[offset + k], speeds[*speed]);
            }
            self.twists[slot] = twist;
        }
    }

    /// Accelerations when the free speeds do not change.
    #[inline(always)]
    fn set_biases(&mut self, speeds: &[T], driven: &[T]) {
        for (index, link) in self.tree.links.iter().enumerate() {
            let (slot, numbers) = (index + 1, &self.numbers.links[index]);
            let (bias, twist) = (self.biases[link.parent], self.twists[link.parent]);
            let own = self.twists[slot];
            let speed = || speeds[link.speeds.start];
            let driven = link.is_driven.then(|| driven[link.speeds.start - self.tree.free_speeds]);
            self.biases[slot] = match link.attachment {
                Attachment::Free => Twist { linear: Vector3::zero(), spin: Vector3::zero() },
                Attachment::Prismatic { .. } | Attachment::Rigid => {
                    let reach = self.poses[slot].position - self.poses[link.parent].position;
                    let mut linear = acceleration_at(&bias, &twist, reach);
                    if let Attachment::Prismatic { .. } = link.attachment {
                        let line = self.lines[slot];
                        linear = linear + twist.spin.cross(line) * (T::from_f64(2.0) * speed());
                        if let Some(driven) = driven {
                            linear = linear + line * driven;
                        }
                    }
                    Twist { linear, spin: bias.spin }
                }
                Attachment::Revolute { .. } | Attachment::Ball => {
                    let parent_arm = self.poses[link.parent].rotation.turn(numbers.parent_arm);
                    let own_arm = self.poses[slot].rotation.turn(numbers.own_arm);
                    let mut linear = acceleration_at(&bias, &twist, parent_arm);
                    let mut spin = Vector3::zero();
                    if !link.attachment.turns_alone() {
                        let axis = self.turnings[self.offsets[slot] + link.inherited];
                        spin = bias.spin.plus_cross(twist.spin, axis * speed());
                        if let Some(driven) = driven {
                            spin = spin.plus(axis, driven);
                        }
                        linear = linear.plus_cross(own_arm, spin);
                    }
                    Twist { linear: pulled_back(linear, own.spin, own_arm), spin }
                }
            };
        }
    }

    #[inline(always)]
    fn set_contacts(&mut self, states: &[PlayState<T>]) {
        for (index, (slots, play)) in self.tree.plays.iter().zip(&self.numbers.plays).enumerate() {
            let arms = [0, 1].map(|side| self.poses[slots[side]].rotation.turn(play.arms[side]));
            let point = |side: usize| self.poses[slots[side]].position + arms[side];
            let velocity = |side: usize| {
                let twist = self.twists[slots[side]];
                twist.linear.plus_cross(twist.spin, arms[side])
            };
            let (eccentricity, change) = (point(1) - point(0), velocity(1) - velocity(0));
            let squared = eccentricity.dot(eccentricity);
            let length = squared.sqrt();
            let normal = eccentricity * (T::one() / length.max(T::from_f64(f64::MIN_POSITIVE)));
            let penetration = (squared - play.clearance.squared()) / (length + play.clearance);
            let rate = change.dot(normal);
            let force = play.law.force(penetration * states[index].contact, rate, &states[index]);
            self.contacts[index] = Contact { penetration, rate, normal_force: force.total_n, normal, arms };
        }
    }

    #[inline(always)]
    fn add_bodies(&mut self) {
        let free = self.tree.free_speeds;
        self.mass.fill(T::zero());
        self.forces.fill(T::zero());
        for (index, (link, numbers)) in self.tree.links.iter().zip(&self.numbers.links).enumerate() {
            let (slot, offset) = (index + 1, self.offsets[index + 1]);
            let rotation = &self.poses[slot].rotation;
            let arm = rotation.turn(numbers.centre_of_mass);
            let (bias, twist) = (self.biases[slot], self.twists[slot]);
            let force = (self.numbers.gravity - acceleration_at(&bias, &twist, arm)) * numbers.mass;
            let (change, spin) = (rotation.turn_back(bias.spin), rotation.turn_back(twist.spin));
            let moment = -numbers.inertia.turn(change).plus_cross(spin, numbers.inertia.turn(spin));
            self.centre_partials.clear();
            for (k, speed) in link.dependences.iter().enumerate() {
                let turning = self.turnings[offset + k];
                let velocity = self.partials[offset + k].plus_cross(turning, arm);
                let in_body = rotation.turn_back(turning);
                let swing = [in_body, numbers.inertia.turn(in_body)];
                self.centre_partials.push((velocity, swing));
                self.forces[*speed] = force.dot_plus(velocity, moment.dot_plus(swing[0], self.forces[*speed]));
            }
            for (k, row) in link.dependences.iter().enumerate() {
                for (l, column) in link.dependences[..=k].iter().enumerate() {
                    let (high, low) = (*row.max(column), *row.min(column));
                    if high >= free {
                        continue;
                    }
                    let (first, second) = (&self.centre_partials[k], &self.centre_partials[l]);
                    let place = &mut self.mass[high * free + low];
                    let sum = first.0.dot(second.0).mul_add(numbers.mass, *place);
                    *place = first.1[0].dot_plus(second.1[1], sum);
                }
            }
        }
    }

    #[inline(always)]
    fn add_contacts(&mut self) {
        for (contact, slots) in self.contacts.iter().zip(&self.tree.plays) {
            let on_journal = contact.normal * -contact.normal_force;
            for (side, force) in [-on_journal, on_journal].into_iter().enumerate().filter(|(side, _)| slots[*side] > 0)
            {
                let (slot, moment) = (slots[side], contact.arms[side].cross(force));
                let offset = self.offsets[slot];
                for (k, speed) in self.tree.links[slot - 1].dependences.iter().enumerate() {
                    let sum = moment.dot_plus(self.turnings[offset + k], self.forces[*speed]);
                    self.forces[*speed] = force.dot_plus(self.partials[offset + k], sum);
                }
            }
        }
    }

    /// Rows of revolute joints that close loops, and their biases as right sides.
    #[inline(always)]
    fn set_rows(&mut self) {
        let speeds = self.tree.free_speeds + self.tree.driven;
        self.jacobian.fill(T::zero());
        let mut row = 0;
        for (slots, (arms, mount)) in self.tree.cuts.iter().zip(&self.numbers.cuts) {
            let rotations = slots.map(|slot| self.poses[slot].rotation);
            let arms = [0, 1].map(|side| rotations[side].turn(arms[side]));
            let [i, j] = slots.map(|slot| (self.biases[slot], self.twists[slot]));
            let bias = acceleration_at(&j.0, &j.1, arms[1]) - acceleration_at(&i.0, &i.1, arms[0]);
            let b = rotations[1].turn(mount.own.column(2));
            let alignments = [0, 1].map(|axis| {
                let a = rotations[0].turn(mount.parent.column(axis));
                (a, a.cross(b))
            });
            for k in 0..3 {
                self.multipliers[row + k] = -bias.0[k];
            }
            for (k, (a, cross)) in alignments.into_iter().enumerate() {
                let (spin_i, spin_j) = (i.1.spin, j.1.spin);
                let turned = spin_i.cross(a).cross(b).plus_cross(a, spin_j.cross(b));
                let bias = cross.dot_plus(i.0.spin - j.0.spin, turned.dot(spin_i - spin_j));
                self.multipliers[row + 3 + k] = -bias;
            }
            for (side, sign) in [(0, -T::one()), (1, T::one())].into_iter().filter(|(side, _)| slots[*side] > 0) {
                let offset = self.offsets[slots[side]];
                for (k, speed) in self.tree.links[slots[side] - 1].dependences.iter().enumerate() {
                    let turning = self.turnings[offset + k];
                    let velocity = self.partials[offset + k].plus_cross(turning, arms[side]) * sign;
                    for point in 0..3 {
                        self.jacobian[(row + point) * speeds + speed] += velocity.0[point];
                    }
                    for (axis, (_, cross)) in alignments.iter().enumerate() {
                        self.jacobian[(row + 3 + axis) * speeds + speed] -= cross.dot(turning) * sign;
                    }
                }
            }
            row += ROWS;
        }
    }

    #[inline(always)]
    fn solve(&mut self) {
        let (free, speeds) = (self.tree.free_speeds, self.tree.free_speeds + self.tree.driven);
        self.envelope.factor_ldl(&mut self.mass);
        self.accelerations.copy_from_slice(&self.forces[..free]);
        self.envelope.solve_ldl(&self.mass, &mut self.accelerations);
        if self.multipliers.is_empty() {
            return;
        }
        self.set_rows();
        for (row, multiplier) in self.multipliers.iter_mut().enumerate() {
            let gradient = &self.jacobian[row * speeds..row * speeds + free];
            for (slope, acceleration) in gradient.iter().zip(&self.accelerations) {
                *multiplier = (-*slope).mul_add(*acceleration, *multiplier);
            }
        }
        self.gram.set(&self.jacobian, speeds, &self.mass, free);
        self.gram.solve(&mut self.multipliers);
        self.gram.add_correction(&self.multipliers, &mut self.accelerations);
    }
}

/// Acceleration of the point at `arm` of a body.
#[inline(always)]
fn acceleration_at<T: Real>(change: &Twist<T>, twist: &Twist<T>, arm: Vector3<T>) -> Vector3<T> {
    pulled_back(change.linear.plus_cross(change.spin, arm), twist.spin, -arm)
}

/// `linear - spin × (spin × arm)`, written so that a spin across the plane of the arm leaves the plane's sums.
#[inline(always)]
fn pulled_back<T: Real>(linear: Vector3<T>, spin: Vector3<T>, arm: Vector3<T>) -> Vector3<T> {
    linear.plus(spin, -spin.dot(arm)).plus(arm, spin.dot(spin))
}

//! The equations of motion, once for every geometry (Kane; the order of operations is that of the planar program).

use crate::geometry::{Geometry, Vector};
use crate::numbers::{LinkNumbers, Numbers};
use loosepin_math::{Envelope, GramSystem, Real};
use loosepin_mechanics::contact::{NormalContact, PlayState};
use parts::{Attachment, Link, Tree};

/// Position of the origin of a body, and its orientation.
#[derive(Debug, Clone, Copy)]
pub struct Pose<T: Real, G: Geometry<T>> {
    pub position: G::Vector,
    pub rotation: G::Rotation,
}

/// A velocity of a body, or an acceleration.
#[derive(Debug, Clone, Copy)]
pub struct Twist<T: Real, G: Geometry<T>> {
    pub linear: G::Vector,
    pub spin: G::Spin,
}

/// A contact at the last evaluation.
#[derive(Debug, Clone, Copy)]
pub struct Contact<T: Real, G: Geometry<T>> {
    pub penetration: T,
    pub rate: T,
    pub normal_force: T,
    pub normal: G::Vector,
    arms: [G::Vector; 2],
}

/// The equations with room for an evaluation.
#[derive(Debug, Clone)]
pub struct Kernel<'t, T: Real, G: Geometry<T>> {
    tree: &'t Tree,
    numbers: Numbers<T, G>,
    pub poses: Vec<Pose<T, G>>,
    pub twists: Vec<Twist<T, G>>,
    biases: Vec<Twist<T, G>>,
    lines: Vec<G::Vector>,
    /// Partial velocities of the origins and turnings, for all dependences of all links in turn.
    partials: Vec<G::Vector>,
    turnings: Vec<G::Turning>,
    offsets: Vec<usize>,
    centre_partials: Vec<(G::Vector, G::Swing)>,
    pub contacts: Vec<Contact<T, G>>,
    envelope: Envelope,
    mass: Vec<T>,
    forces: Vec<T>,
    pub accelerations: Vec<T>,
    jacobian: Vec<T>,
    multipliers: Vec<T>,
    gram: GramSystem<T>,
}

impl<'t, T: Real, G: Geometry<T>> Kernel<'t, T, G> {
    pub fn new(tree: &'t Tree, numbers: Numbers<T, G>) -> Self {
        let slots = tree.links.len() + 1;
        let (offsets, partials) = tree.offsets();
        let (free, speeds) = (tree.free_speeds, tree.free_speeds + tree.driven);
        let points = G::COUNTS.position;
        let rows = (points + G::AXIS_ROWS) * tree.cuts.len();
        let scales = (0..tree.cuts.len()).flat_map(|cut| {
            let first = cut * (points + G::AXIS_ROWS);
            (0..points + G::AXIS_ROWS).map(move |row| if row < 2 { [first, first + 1] } else { [first + row; 2] })
        });
        let ground = Pose { position: G::Vector::zero(), rotation: G::unturned() };
        let rest = Twist { linear: G::Vector::zero(), spin: G::at_rest() };
        let zero = G::Vector::zero();
        let open =
            Contact { penetration: T::zero(), rate: T::zero(), normal_force: T::zero(), normal: zero, arms: [zero; 2] };
        Self {
            poses: vec![ground; slots],
            twists: vec![rest; slots],
            biases: vec![rest; slots],
            lines: vec![zero; slots],
            partials: vec![zero; partials],
            turnings: vec![G::still(); partials],
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
        let position = G::COUNTS.position;
        for link in self.tree.links.iter().filter(|link| !link.is_driven) {
            let (first, speed) = (link.coordinate, link.speed);
            let plain = match link.attachment {
                Attachment::Revolute { .. } | Attachment::Prismatic { .. } => 1,
                Attachment::Free => position,
                Attachment::Ball | Attachment::Rigid => 0,
            };
            rates[first..first + plain].copy_from_slice(&speeds[speed..speed + plain]);
            if let Attachment::Ball | Attachment::Free = link.attachment {
                G::orientation_rates(
                    &coordinates[first + plain..],
                    &speeds[speed + plain..],
                    &mut rates[first + plain..],
                );
            }
        }
    }

    #[inline(always)]
    fn set_positions(&mut self, coordinates: &[T]) {
        for (index, link) in self.tree.links.iter().enumerate() {
            let slot = index + 1;
            let LinkNumbers { parent_arm, own_arm, mount, .. } = self.numbers.links[index].clone();
            let parent = self.poses[link.parent];
            let own = &coordinates[link.coordinate..];
            let parent_arm = G::turn(&parent.rotation, parent_arm);
            let at_joint = parent.position + parent_arm;
            let place = self.offsets[slot] + link.inherited;
            match link.attachment {
                Attachment::Revolute { forward, turns_alone } => {
                    let (rotation, axis) = G::revolved(&parent.rotation, &mount, own[0], turns_alone, forward);
                    let own_arm = G::turn(&rotation, own_arm);
                    self.poses[slot] = Pose { position: at_joint - own_arm, rotation };
                    self.carry(link, slot, parent_arm);
                    self.partials[place] = G::moved(G::Vector::zero(), axis, -own_arm);
                    self.turnings[place] = axis;
                }
                Attachment::Prismatic { forward } => {
                    let line = G::line(&parent.rotation, &mount);
                    let line = if forward { line } else { -line };
                    let rotation = G::held(&parent.rotation, &mount);
                    let position = at_joint + line * own[0] - G::turn(&rotation, own_arm);
                    self.poses[slot] = Pose { position, rotation };
                    self.lines[slot] = line;
                    self.carry(link, slot, parent_arm);
                    self.partials[place] = line;
                    self.turnings[place] = G::still();
                }
                Attachment::Rigid => {
                    let rotation = G::held(&parent.rotation, &mount);
                    let position = at_joint - G::turn(&rotation, own_arm);
                    self.poses[slot] = Pose { position, rotation };
                    self.carry(link, slot, parent_arm);
                }
                Attachment::Ball => {
                    let rotation = G::oriented(own);
                    let own_arm = G::turn(&rotation, own_arm);
                    self.poses[slot] = Pose { position: at_joint - own_arm, rotation };
                    self.carry(link, slot, parent_arm);
                    self.orient(place, &rotation, -own_arm);
                }
                Attachment::Free => {
                    let count = G::COUNTS.position;
                    let rotation = G::oriented(&own[count..]);
                    let sum = |sum: G::Vector, k: usize| sum.plus(G::unit(k), own[k]);
                    let position = (0..count).fold(G::Vector::zero(), sum);
                    self.poses[slot] = Pose { position, rotation };
                    for k in 0..count {
                        self.partials[place + k] = G::unit(k);
                        self.turnings[place + k] = G::still();
                    }
                    self.orient(place + count, &rotation, G::Vector::zero());
                }
            }
        }
    }

    /// Partial velocities of the parent, carried to the origin of `slot`.
    #[inline(always)]
    fn carry(&mut self, link: &Link, slot: usize, parent_arm: G::Vector) {
        let (from, to) = (self.offsets[link.parent], self.offsets[slot]);
        let alone = link.attachment.turns_alone();
        let reach = if alone { parent_arm } else { self.poses[slot].position - self.poses[link.parent].position };
        for k in 0..link.inherited {
            let turning = self.turnings[from + k];
            self.partials[to + k] = G::moved(self.partials[from + k], turning, reach);
            self.turnings[to + k] = if alone { G::still() } else { turning };
        }
    }

    #[inline(always)]
    fn orient(&mut self, place: usize, rotation: &G::Rotation, arm: G::Vector) {
        for (k, turning) in G::turnings(rotation).as_ref().iter().enumerate() {
            self.partials[place + k] = G::moved(G::Vector::zero(), *turning, arm);
            self.turnings[place + k] = *turning;
        }
    }

    #[inline(always)]
    fn set_velocities(&mut self, speeds: &[T]) {
        for (index, link) in self.tree.links.iter().enumerate() {
            let (slot, offset) = (index + 1, self.offsets[index + 1]);
            let mut twist: Twist<T, G> = Twist { linear: G::Vector::zero(), spin: G::at_rest() };
            for (k, speed) in link.dependences.iter().enumerate() {
                twist.linear = twist.linear.plus(self.partials[offset + k], speeds[*speed]);
                twist.spin = G::turned(twist.spin, self.turnings[offset + k], speeds[*speed]);
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
            let speed = || speeds[link.speed];
            let driven = link.is_driven.then(|| driven[link.speed - self.tree.free_speeds]);
            self.biases[slot] = match link.attachment {
                Attachment::Free => Twist { linear: G::Vector::zero(), spin: G::at_rest() },
                Attachment::Prismatic { .. } | Attachment::Rigid => {
                    let reach = self.poses[slot].position - self.poses[link.parent].position;
                    let mut linear = acceleration_at::<T, G>(&bias, &twist, reach);
                    if let Attachment::Prismatic { .. } = link.attachment {
                        let line = self.lines[slot];
                        linear = linear + G::coriolis(twist.spin, line, speed());
                        if let Some(driven) = driven {
                            linear = linear + line * driven;
                        }
                    }
                    Twist { linear, spin: bias.spin }
                }
                Attachment::Revolute { .. } | Attachment::Ball => {
                    let parent_arm = G::turn(&self.poses[link.parent].rotation, numbers.parent_arm);
                    let own_arm = G::turn(&self.poses[slot].rotation, numbers.own_arm);
                    let mut linear = acceleration_at::<T, G>(&bias, &twist, parent_arm);
                    let mut spin = G::at_rest();
                    if !link.attachment.turns_alone() {
                        let axis = self.turnings[self.offsets[slot] + link.inherited];
                        spin = G::precessed(bias.spin, twist.spin, axis, speed());
                        if let Some(driven) = driven {
                            spin = G::turned(spin, axis, driven);
                        }
                        linear = G::swept_back(linear, spin, own_arm);
                    }
                    Twist { linear: G::pulled_back(linear, own.spin, own_arm), spin }
                }
            };
        }
    }

    #[inline(always)]
    fn set_contacts(&mut self, states: &[PlayState<T>]) {
        for (index, (slots, play)) in self.tree.plays.iter().zip(&self.numbers.plays).enumerate() {
            let arms = [0, 1].map(|side| G::turn(&self.poses[slots[side]].rotation, play.arms[side]));
            let point = |side: usize| self.poses[slots[side]].position + arms[side];
            let velocity = |side: usize| {
                let twist = self.twists[slots[side]];
                G::swept(twist.linear, twist.spin, arms[side])
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
            let arm = G::turn(rotation, numbers.centre_of_mass);
            let (bias, twist) = (self.biases[slot], self.twists[slot]);
            let force = (self.numbers.gravity - acceleration_at::<T, G>(&bias, &twist, arm)) * numbers.mass;
            let moment = G::inertia_moment(rotation, &numbers.inertia, bias.spin, twist.spin);
            self.centre_partials.clear();
            for (k, speed) in link.dependences.iter().enumerate() {
                let turning = self.turnings[offset + k];
                let velocity = G::moved(self.partials[offset + k], turning, arm);
                let swing = G::swing(rotation, &numbers.inertia, turning);
                self.centre_partials.push((velocity, swing));
                self.forces[*speed] = force.dot_plus(velocity, G::inertia_push(moment, &swing, self.forces[*speed]));
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
                    *place = G::coupled(&first.1, &second.1, sum);
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
                let (slot, moment) = (slots[side], G::moment(contact.arms[side], force));
                let offset = self.offsets[slot];
                for (k, speed) in self.tree.links[slot - 1].dependences.iter().enumerate() {
                    let sum = G::push(moment, self.turnings[offset + k], self.forces[*speed]);
                    self.forces[*speed] = force.dot_plus(self.partials[offset + k], sum);
                }
            }
        }
    }

    /// Rows of revolute joints that close loops, and their biases as right sides.
    #[inline(always)]
    fn set_rows(&mut self) {
        let (points, speeds) = (G::COUNTS.position, self.tree.free_speeds + self.tree.driven);
        self.jacobian.fill(T::zero());
        let mut row = 0;
        for (slots, (arms, mount)) in self.tree.cuts.iter().zip(&self.numbers.cuts) {
            let rotations = slots.map(|slot| self.poses[slot].rotation);
            let arms = [0, 1].map(|side| G::turn(&rotations[side], arms[side]));
            let [i, j] = slots.map(|slot| (self.biases[slot], self.twists[slot]));
            let bias = acceleration_at::<T, G>(&j.0, &j.1, arms[1]) - acceleration_at::<T, G>(&i.0, &i.1, arms[0]);
            for k in 0..points {
                self.multipliers[row + k] = -bias.component(k);
            }
            for axis in 0..G::AXIS_ROWS {
                let [a, b] = G::axes(axis, [&rotations[0], &rotations[1]], mount);
                let zero = G::Vector::zero();
                // a·b, twice differentiated.
                let [first, second] = [(&i, a), (&j, b)].map(|((bias, twist), axis)| {
                    let change = G::pulled(G::swept(zero, bias.spin, axis), twist.spin, axis);
                    (G::swept(zero, twist.spin, axis), change)
                });
                let bias = first.1.dot_plus(b, a.dot(second.1)) + T::from_f64(2.0) * first.0.dot(second.0);
                self.multipliers[row + points + axis] = -bias;
            }
            for (side, sign) in [(0, -T::one()), (1, T::one())].into_iter().filter(|(side, _)| slots[*side] > 0) {
                let offset = self.offsets[slots[side]];
                for (k, speed) in self.tree.links[slots[side] - 1].dependences.iter().enumerate() {
                    let turning = self.turnings[offset + k];
                    let velocity = G::moved(self.partials[offset + k], turning, arms[side]) * sign;
                    for point in 0..points {
                        self.jacobian[(row + point) * speeds + speed] += velocity.component(point);
                    }
                    for axis in 0..G::AXIS_ROWS {
                        let [a, b] = G::axes(axis, [&rotations[0], &rotations[1]], mount);
                        let slope = G::push(G::moment(a, b), turning, T::zero());
                        self.jacobian[(row + points + axis) * speeds + speed] -= slope * sign;
                    }
                }
            }
            row += points + G::AXIS_ROWS;
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
        self.gram.add_answer(&self.multipliers, &mut self.accelerations);
    }
}

/// Acceleration of the point at `arm` of a body.
#[inline(always)]
fn acceleration_at<T: Real, G: Geometry<T>>(change: &Twist<T, G>, twist: &Twist<T, G>, arm: G::Vector) -> G::Vector {
    G::pulled(G::swept(change.linear, change.spin, arm), twist.spin, arm)
}

//! The equations of motion, once for every geometry (Kane; the order of operations is that of the planar program).

use crate::geometry::{Geometry, Vector};
use crate::kinds::{Column, Kind, Moving, Speeds, Twist};
use crate::numbers::Numbers;
use loosepin_math::{Envelope, GramSystem, Real};
use loosepin_mechanics::contact::{NormalContact, PlayState};
use parts::Tree;

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
    pub bodies: Vec<Moving<T, G>>,
    /// Velocities for unit speeds, for all dependences of all links in turn.
    columns: Vec<Column<T, G>>,
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
        let (offsets, columns) = tree.offsets();
        let (free, speeds) = (tree.free_speeds, tree.free_speeds + tree.driven);
        let points = G::COUNTS.position;
        let rows = (points + G::AXIS_ROWS) * tree.cuts.len();
        let scales = (0..tree.cuts.len()).flat_map(|cut| {
            let first = cut * (points + G::AXIS_ROWS);
            (0..points + G::AXIS_ROWS).map(move |row| if row < 2 { [first, first + 1] } else { [first + row; 2] })
        });
        let zero = G::Vector::zero();
        let open =
            Contact { penetration: T::zero(), rate: T::zero(), normal_force: T::zero(), normal: zero, arms: [zero; 2] };
        Self {
            bodies: vec![Moving::ground(); slots],
            columns: vec![Column::sliding(zero); columns],
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
            let (own, speeds) = (link.coordinates.clone(), &speeds[link.speeds.clone()]);
            Kind::<T, G>::rates(&link.attachment, &coordinates[own.clone()], speeds, &mut rates[own]);
        }
    }

    #[inline(always)]
    fn set_positions(&mut self, coordinates: &[T]) {
        for (index, link) in self.tree.links.iter().enumerate() {
            let (slot, kind, numbers) = (index + 1, &link.attachment, &self.numbers.links[index]);
            let parent = self.bodies[link.parent].pose;
            let own = kind.pose(numbers, &parent, &coordinates[link.coordinates.clone()]);
            self.bodies[slot].pose = own;
            let (before, columns) = self.columns.split_at_mut(self.offsets[slot]);
            let (inherited, columns) = columns[..link.dependences.len()].split_at_mut(link.inherited);
            kind.columns(numbers, &parent, &own, columns);
            if inherited.is_empty() {
                continue;
            }
            // What turns alone follows the point of its joint, and leaves the turning behind.
            let alone = Kind::<T, G>::turns_alone(kind);
            let reach =
                if alone { G::turn(&parent.rotation, numbers.parent_arm) } else { own.position - parent.position };
            for (column, from) in inherited.iter_mut().zip(&before[self.offsets[link.parent]..]) {
                let linear = G::moved(from.linear, from.turning, reach);
                *column = Column { linear, turning: if alone { G::still() } else { from.turning } };
            }
        }
    }

    #[inline(always)]
    fn set_velocities(&mut self, speeds: &[T]) {
        for (index, link) in self.tree.links.iter().enumerate() {
            let columns = &self.columns[self.offsets[index + 1]..];
            let mut twist: Twist<T, G> = Twist::zero();
            for (column, speed) in columns.iter().zip(&link.dependences) {
                twist.linear = twist.linear.plus(column.linear, speeds[*speed]);
                twist.spin = G::turned(twist.spin, column.turning, speeds[*speed]);
            }
            self.bodies[index + 1].twist = twist;
        }
    }

    /// Accelerations when the free speeds do not change.
    #[inline(always)]
    fn set_biases(&mut self, speeds: &[T], driven: &[T]) {
        for (index, link) in self.tree.links.iter().enumerate() {
            let slot = index + 1;
            let (parent, own) = (&self.bodies[link.parent], &self.bodies[slot]);
            let columns = &self.columns[self.offsets[slot] + link.inherited..];
            let driven = link.is_driven.then(|| driven[link.speeds.start - self.tree.free_speeds]);
            let speeds = Speeds { own: &speeds[link.speeds.clone()], driven };
            self.bodies[slot].bias = link.attachment.bias(&self.numbers.links[index], parent, own, columns, speeds);
        }
    }

    #[inline(always)]
    fn set_contacts(&mut self, states: &[PlayState<T>]) {
        for (index, (slots, play)) in self.tree.plays.iter().zip(&self.numbers.plays).enumerate() {
            let arms = [0, 1].map(|side| G::turn(&self.bodies[slots[side]].pose.rotation, play.arms[side]));
            let point = |side: usize| self.bodies[slots[side]].pose.position + arms[side];
            let velocity = |side: usize| {
                let twist = self.bodies[slots[side]].twist;
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
            let body = &self.bodies[slot];
            let rotation = &body.pose.rotation;
            let arm = G::turn(rotation, numbers.centre_of_mass);
            let force = (self.numbers.gravity - body.acceleration_at(arm)) * numbers.mass;
            let moment = G::inertia_moment(rotation, &numbers.inertia, body.bias.spin, body.twist.spin);
            self.centre_partials.clear();
            for (k, speed) in link.dependences.iter().enumerate() {
                let Column { linear, turning } = self.columns[offset + k];
                let velocity = G::moved(linear, turning, arm);
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
                    let Column { linear, turning } = self.columns[offset + k];
                    let sum = G::push(moment, turning, self.forces[*speed]);
                    self.forces[*speed] = force.dot_plus(linear, sum);
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
            let rotations = slots.map(|slot| self.bodies[slot].pose.rotation);
            let arms = [0, 1].map(|side| G::turn(&rotations[side], arms[side]));
            let [i, j] = slots.map(|slot| self.bodies[slot]);
            let bias = j.acceleration_at(arms[1]) - i.acceleration_at(arms[0]);
            for k in 0..points {
                self.multipliers[row + k] = -bias.component(k);
            }
            for axis in 0..G::AXIS_ROWS {
                let [a, b] = G::axes(axis, [&rotations[0], &rotations[1]], mount);
                let zero = G::Vector::zero();
                // a·b, twice differentiated.
                let [first, second] = [(&i, a), (&j, b)].map(|(body, axis)| {
                    let change = G::pulled(G::swept(zero, body.bias.spin, axis), body.twist.spin, axis);
                    (G::swept(zero, body.twist.spin, axis), change)
                });
                let bias = first.1.dot_plus(b, a.dot(second.1)) + T::from_f64(2.0) * first.0.dot(second.0);
                self.multipliers[row + points + axis] = -bias;
            }
            for (side, sign) in [(0, -T::one()), (1, T::one())].into_iter().filter(|(side, _)| slots[*side] > 0) {
                let offset = self.offsets[slots[side]];
                for (k, speed) in self.tree.links[slots[side] - 1].dependences.iter().enumerate() {
                    let Column { linear, turning } = self.columns[offset + k];
                    let velocity = G::moved(linear, turning, arms[side]) * sign;
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
        self.gram.add_correction(&self.multipliers, &mut self.accelerations);
    }
}

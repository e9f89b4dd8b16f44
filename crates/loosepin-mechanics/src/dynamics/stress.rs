//! Stress along a link, by summing up the forces beyond each cut.

use super::equations::Dynamics;
use crate::mechanism::{StressedBody, acceleration_at};
use crate::model::{ActsOn, BodyId, JointId, PlayId, PointId};
use loosepin_flexible::{Nodal, Station};
use loosepin_math::{Real, Vec2};

/// Force of the part of a link nearer to its root on the part beyond a cut.
#[derive(Debug, Clone, Copy)]
pub struct SectionForce<T> {
    /// Force along the axis of the section, N: negative under tension, as the inner part pulls the outer one back.
    pub along_n: T,
    /// Couple, N m.
    pub moment_n_m: T,
}

/// What acts on a link at one of its points.
struct PointLoad<T> {
    /// Share of the length at which it enters.
    share: f64,
    /// The point, in the axes of the frame from the root, m.
    at_m: Vec2<T>,
    /// Force in the axes of the frame, N.
    force_n: Vec2<T>,
    /// Couple, N m.
    couple_n_m: T,
}

/// Motion of the link in the axes of its frame, at the last evaluation.
struct LinkMotion<T> {
    /// Slot of the frame, at the root.
    slot: usize,
    /// Direction of the x axis of the frame, in the ground's frame: that of the ground in absolute nodal coordinates.
    axis: Vec2<T>,
    /// Acceleration of the root minus that of gravity, m/s².
    fall_m_s2: Vec2<T>,
    /// Angular velocity, rad/s, and angular acceleration, rad/s², of the frame.
    turning: [T; 2],
    /// What carries the points.
    carrier: Carrier<T>,
}

/// What carries the points of a link.
enum Carrier<T> {
    /// A rigid body.
    Rigid,
    /// A floating frame with the shapes of this flexible body of the tree.
    Shapes(usize),
    /// A flexible body in absolute nodal coordinates.
    Nodes(Nodes<T>),
}

/// The nodes of a link.
struct Nodes<T> {
    /// The flexible body in absolute nodal coordinates of the tree.
    beam: usize,
    /// Whether the root of the link is the tip of its mesh.
    is_turned: bool,
    accelerations: Vec<Nodal<T>>,
}

impl<T> Nodes<T> {
    /// Share of the length of the mesh.
    fn share(&self, station: &Station) -> f64 {
        if self.is_turned { 1.0 - station.share } else { station.share }
    }
}

impl<T: Real> Dynamics<'_, T> {
    /// Largest stress along a link at the last evaluation, Pa: at the outer fibre, by bending moment and axial force together.
    ///
    /// ```text
    /// F(x) = ∫_x^L ρA (a - g) dξ - Σ F_p                                          force of the inner part on the outer one, N
    /// M(x) = ∫_x^L (d(ξ) - d(x)) × ρA (a - g) dξ - Σ ((r_p - d(x)) × F_p + T_p)   its couple, N m
    /// σ = max_x |F·t|/A + |M|/W                                                   t the axis of the section, W = I/c its section modulus
    /// ```
    ///
    /// The accelerations are those of the points of the beam as it bends, or of a rigid link where it is ideal. Force summation converges
    /// faster than EI w'' of few shapes, and feels a force at once. F_p and T_p come from joints, springs and loads at the points p beyond x, and from
    /// the inertia of lumps there, -m (a - g) and -J α̇; at a point itself both sides of it count.
    pub fn largest_stress_pa(&self, body: BodyId) -> T {
        let Some(index) = self.mechanism.stressed.iter().position(|stressed| stressed.body == body) else {
            return T::from_f64(f64::NAN);
        };
        let numbers = &self.sample.sections[index];
        let mut largest_pa = T::zero();
        self.at_each_cut(index, &mut |_, cut| {
            let axial_pa = cut.along_n.abs() * T::from_f64(1.0 / numbers.area_m2);
            let stress_pa = cut.moment_n_m.abs().mul_add(T::from_f64(1.0 / numbers.modulus_m3), axial_pa);
            largest_pa = largest_pa.max(stress_pa);
        });
        largest_pa
    }

    /// Forces at all cuts of the link `index` of [`crate::mechanism::Mechanism::stressed`] at the last evaluation, from root to tip, with their share of the length: twice
    /// at a point, once before it and once behind it.
    pub fn section_forces(&self, index: usize) -> Vec<(f64, SectionForce<T>)> {
        let mut found = Vec::new();
        self.at_each_cut(index, &mut |share, cut| found.push((share, cut)));
        found
    }

    /// Shows the forces at each cut with its share of the length.
    fn at_each_cut(&self, index: usize, show: &mut impl FnMut(f64, SectionForce<T>)) {
        let (stressed, numbers) = (&self.mechanism.stressed[index], &self.sample.sections[index]);
        let motion = self.link_motion(stressed, index);
        let points: Vec<(Vec2<T>, Vec2<T>)> = stressed
            .cuts
            .points
            .iter()
            .map(|station| {
                let d = self.place_m(&motion, station, numbers.length_m);
                (d, self.pull_m_s2(&motion, station, d) * T::from_f64(numbers.mass_kg))
            })
            .collect();
        let loads = self.point_loads(stressed, index, &motion);
        for (cut, station) in stressed.cuts.stations.iter().enumerate() {
            let at_m = self.place_m(&motion, station, numbers.length_m);
            let section = self.section_axis(&motion, station);
            let mut look = |is_beyond: &dyn Fn(f64) -> bool| {
                let (mut force_n, mut moment_n_m) = (Vec2::zero(), T::zero());
                for load in loads.iter().filter(|load| is_beyond(load.share)) {
                    force_n += -load.force_n;
                    moment_n_m += -(load.at_m - at_m).cross(load.force_n) - load.couple_n_m;
                }
                for (weight, (d, pull_n)) in stressed.cuts.beyond(cut).iter().zip(&points) {
                    let share_n = *pull_n * T::from_f64(*weight);
                    force_n += share_n;
                    moment_n_m += (*d - at_m).cross(share_n);
                }
                let along_n = force_n.dot(section);
                show(station.share, SectionForce { along_n, moment_n_m });
            };
            look(&|share| share >= station.share);
            if station.share < 1.0 && loads.iter().any(|load| load.share == station.share) {
                look(&|share| share > station.share);
            }
        }
    }

    fn link_motion(&self, stressed: &StressedBody, index: usize) -> LinkMotion<T> {
        let tree = &self.mechanism.real;
        let shapes = tree.beams.iter().position(|beam| beam.body == stressed.body);
        let nodal = tree.nodal_beams.iter().position(|beam| beam.body == stressed.body);
        let (slot, carrier) = match (shapes, nodal) {
            (Some(beam), _) => (tree.beams[beam].slot, Carrier::Shapes(beam)),
            (None, Some(beam)) => {
                let (is_turned, accelerations) = (stressed.is_turned, self.nodal_accelerations(beam));
                (tree.nodal_beams[beam].slot, Carrier::Nodes(Nodes { beam, is_turned, accelerations }))
            }
            (None, None) => (tree.slot_of_body[stressed.body.0], Carrier::Rigid),
        };
        let [root_m, tip_m] =
            self.sample.sections[index].ends_m.map(|end| Vec2::new(T::from_f64(end.x), T::from_f64(end.y)));
        let (pose, twist, change) =
            (&self.kinematics.poses[slot], &self.kinematics.twists[slot], self.acceleration(slot));
        let axis = match carrier {
            Carrier::Nodes(_) => Vec2::new(T::one(), T::zero()),
            Carrier::Shapes(_) | Carrier::Rigid => {
                pose.turn((tip_m - root_m) * T::from_f64(1.0 / self.sample.sections[index].length_m))
            }
        };
        let fall = acceleration_at(&change, twist, pose.turn(root_m)) - self.sample.real.gravity_m_s2;
        LinkMotion {
            slot,
            axis,
            fall_m_s2: fall.rotated(-axis.y, axis.x),
            turning: [twist.angular, change.angular],
            carrier,
        }
    }

    /// Coordinates of the shapes of a flexible body, with their rates or accelerations `of`.
    fn shapes_of<'s>(&self, beam: usize, of: &'s [T]) -> &'s [T] {
        &of[self.mechanism.real.beams[beam].coordinates.clone()]
    }

    /// d(x), m, in the axes of the frame.
    fn place_m(&self, motion: &LinkMotion<T>, station: &Station, length_m: f64) -> Vec2<T> {
        match &motion.carrier {
            Carrier::Shapes(beam) => {
                self.sample.real.beams[*beam].beam.point_m(station, self.shapes_of(*beam, &self.coordinates))
            }
            Carrier::Nodes(link) => {
                let (mesh, nodes) =
                    (&self.mechanism.real.nodal_beams[link.beam].mesh, &self.nodal_workspaces[link.beam].nodes);
                let numbers = &self.sample.real.nodal_beams[link.beam].beam;
                numbers.point_m(mesh, nodes, link.share(station)) - nodes[0].position
            }
            Carrier::Rigid => Vec2::new(T::from_f64(length_m * station.share), T::zero()),
        }
    }

    /// Acceleration of a point at `d` minus that of gravity, m/s², in the axes of the frame (F2).
    fn pull_m_s2(&self, motion: &LinkMotion<T>, station: &Station, d: Vec2<T>) -> Vec2<T> {
        let [spin, change] = motion.turning;
        let carried = motion.fall_m_s2.plus(d.turned(), change).plus(d, -spin.squared());
        let index = match &motion.carrier {
            Carrier::Rigid => return carried,
            Carrier::Nodes(link) => {
                let mesh = &self.mechanism.real.nodal_beams[link.beam].mesh;
                let numbers = &self.sample.real.nodal_beams[link.beam].beam;
                return numbers.point_m(mesh, &link.accelerations, link.share(station)) - self.sample.real.gravity_m_s2;
            }
            Carrier::Shapes(beam) => *beam,
        };
        let beam = &self.sample.real.beams[index].beam;
        let [q, rates, changes] =
            [&self.coordinates, &self.rates, &self.equations.accelerations].map(|of| self.shapes_of(index, of));
        let rate = beam.rate_m_s(station, q, rates);
        carried + beam.rate_m_s(station, q, changes) + beam.relative_acceleration_m_s2(station, rate, rates, spin)
    }

    /// Direction of the axis of a section, in the axes of the frame.
    fn section_axis(&self, motion: &LinkMotion<T>, station: &Station) -> Vec2<T> {
        match &motion.carrier {
            Carrier::Shapes(beam) => {
                let numbers = &self.sample.real.beams[*beam].beam;
                let (sine, cosine) = numbers.angle_rad(station, self.shapes_of(*beam, &self.coordinates)).sin_cos();
                Vec2::new(cosine, sine)
            }
            Carrier::Nodes(link) => {
                let (mesh, nodes) =
                    (&self.mechanism.real.nodal_beams[link.beam].mesh, &self.nodal_workspaces[link.beam].nodes);
                let slope = self.sample.real.nodal_beams[link.beam].beam.slope(mesh, nodes, link.share(station));
                let along = slope * (T::one() / slope.length());
                if link.is_turned { -along } else { along }
            }
            Carrier::Rigid => Vec2::new(T::one(), T::zero()),
        }
    }

    /// What joints, springs, loads and the inertia of lumps do at the points of a link beyond its root.
    fn point_loads(&self, stressed: &StressedBody, index: usize, motion: &LinkMotion<T>) -> Vec<PointLoad<T>> {
        let tree = &self.mechanism.real;
        let numbers = &self.sample.sections[index];
        let place_m = |slot: usize, arm_m: Vec2<f64>| self.kinematics.poses[slot].point_m(Vec2::from_f64(arm_m));
        let root_m = match &motion.carrier {
            // The places along it count from the root of the mesh.
            Carrier::Nodes(link) => self.nodal_workspaces[link.beam].nodes[0].position,
            Carrier::Shapes(_) | Carrier::Rigid => place_m(motion.slot, numbers.ends_m[0]),
        };
        let into_frame = |vector: Vec2<T>| vector.rotated(-motion.axis.y, motion.axis.x);
        let load = |index: usize| {
            let ((point, share), arm_m, lump) = (stressed.points[index], numbers.arms_m[index], numbers.lumps[index]);
            let point = PointId { body: stressed.body, point };
            let slot = tree.slot_of_point(point);
            let (mut force_n, mut couple_n_m) = self.load_at(point);
            if lump != [0.0; 2] {
                let [mass_kg, inertia_kg_m2] = lump.map(T::from_f64);
                let (twist, change) = (&self.kinematics.twists[slot], self.acceleration(slot));
                let arm = self.kinematics.poses[slot].turn(Vec2::from_f64(arm_m));
                let pull = acceleration_at(&change, twist, arm) - self.sample.real.gravity_m_s2;
                force_n += -(pull * mass_kg);
                couple_n_m -= inertia_kg_m2 * change.angular;
            }
            let at_m = into_frame(place_m(slot, arm_m) - root_m);
            PointLoad { share, at_m, force_n: into_frame(force_n), couple_n_m }
        };
        (0..stressed.points.len()).map(load).collect()
    }

    /// Force, N, in the ground's frame, and couple, N m, of joints, springs and loads at a point.
    fn load_at(&self, own: PointId) -> (Vec2<T>, T) {
        let model = &self.mechanism.model;
        let (mut force_n, mut couple_n_m) = (Vec2::zero(), T::zero());
        for (index, joint) in model.joints.iter().enumerate() {
            for (side, point) in joint.kind.points().into_iter().enumerate() {
                if point == own {
                    let on_second_n = self.joint_force_n(JointId(index));
                    force_n += if side == 1 { on_second_n } else { -on_second_n };
                }
            }
        }
        // Friction has a couple about the centre of the pin, at which joints of a link have their points.
        for (contact, at) in self.contacts.iter().zip(&self.sample.contacts) {
            let PlayId::Joint(joint) = self.mechanism.plays[at.play] else { continue };
            let [bearing, journal] = model.joints[joint.0].kind.points();
            if bearing == own {
                couple_n_m += contact.moment_on_bearing_n_m;
            }
            if journal == own {
                couple_n_m += contact.moment_on_journal_n_m;
            }
        }
        for (index, spring) in model.springs.iter().enumerate() {
            let Some([first, second]) = spring.kind.points() else { continue };
            let on_second_n = self.spring_force(index).on_second_n;
            if second == own {
                force_n += on_second_n;
            }
            if first == own {
                force_n += -on_second_n;
            }
        }
        for (load, force) in model.loads.iter().zip(self.loads()) {
            if load.kind.acts_on() == ActsOn::Point(own) {
                force_n += force.force_n;
            }
        }
        (force_n, couple_n_m)
    }
}

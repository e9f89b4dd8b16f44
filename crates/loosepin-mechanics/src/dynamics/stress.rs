//! Stress along a link, by summing up the forces beyond each cut.

use super::equations::Dynamics;
use crate::mechanism::{StressedBody, acceleration_at};
use crate::model::{BodyId, JointId, LoadKind, PlayId, PointId, SpringKind};
use loosepin_flexible::Station;
use loosepin_math::{Real, Vec2};

/// Motion of the link in the axes of its frame, at the last evaluation.
struct LinkMotion<T> {
    /// Direction of the x axis of the frame, in the ground's frame.
    axis: Vec2<T>,
    /// Acceleration of the root minus that of gravity, m/s².
    fall_m_s2: Vec2<T>,
    /// Angular velocity, rad/s, and angular acceleration, rad/s², of the frame.
    turning: [T; 2],
    /// Index of the flexible body among those of the tree; a rigid body has none.
    beam: Option<usize>,
}

impl<T: Real> Dynamics<'_, T> {
    /// Largest stress along a link at the last evaluation, Pa: at the outer fibre, by bending moment and axial force together.
    ///
    /// ```text
    /// F(x) = ∫_x^L ρA (a - g) dξ - F_tip                             force of the inner part on the outer one, N
    /// M(x) = ∫_x^L (d(ξ) - d(x)) × ρA (a - g) dξ - (d(L) - d(x)) × F_tip - T_tip                 its couple, N m
    /// σ = max_x |F·t|/A + |M|/W                                t the axis of the section, W = I/c its section modulus
    /// ```
    ///
    /// The accelerations are those of the points of the beam as it bends, or of a rigid link where it is ideal. Force summation converges
    /// faster than EI w'' of few shapes, and feels a force at the tip at once. F_tip and T_tip come from joints, springs and loads there.
    pub fn largest_stress_pa(&self, body: BodyId) -> T {
        let Some(index) = self.mechanism.stressed.iter().position(|stressed| stressed.body == body) else {
            return T::from_f64(f64::NAN);
        };
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
        let (tip_n, tip_n_m) = self.tip_load(stressed);
        let tip_n = tip_n.rotated(-motion.axis.y, motion.axis.x);
        let tip_m =
            stressed.cuts.stations.last().map_or(Vec2::zero(), |tip| self.place_m(&motion, tip, numbers.length_m));
        let mut largest_pa = T::zero();
        for (cut, station) in stressed.cuts.stations.iter().enumerate() {
            let at_m = self.place_m(&motion, station, numbers.length_m);
            let (mut force_n, mut moment_n_m) = (-tip_n, -(tip_m - at_m).cross(tip_n) - tip_n_m);
            for (weight, (d, pull_n)) in stressed.cuts.beyond(cut).iter().zip(&points) {
                let share_n = *pull_n * T::from_f64(*weight);
                force_n += share_n;
                moment_n_m += (*d - at_m).cross(share_n);
            }
            let (sine, cosine) = self.section_angle_rad(&motion, station).sin_cos();
            let along_n = force_n.dot(Vec2::new(cosine, sine));
            let axial_pa = along_n.abs() * T::from_f64(1.0 / numbers.area_m2);
            let stress_pa = moment_n_m.abs().mul_add(T::from_f64(1.0 / numbers.modulus_m3), axial_pa);
            largest_pa = largest_pa.max(stress_pa);
        }
        largest_pa
    }

    fn link_motion(&self, stressed: &StressedBody, index: usize) -> LinkMotion<T> {
        let tree = &self.mechanism.real;
        let beam = tree.beams.iter().position(|beam| beam.body == stressed.body);
        let slot = beam.map_or(tree.slot_of_body[stressed.body.0], |beam| tree.beams[beam].slot);
        let [root_m, tip_m] =
            self.sample.sections[index].ends_m.map(|end| Vec2::new(T::from_f64(end.x), T::from_f64(end.y)));
        let (pose, twist, change) =
            (&self.kinematics.poses[slot], &self.kinematics.twists[slot], self.acceleration(slot));
        let axis = pose.turn((tip_m - root_m) * T::from_f64(1.0 / self.sample.sections[index].length_m));
        let fall = acceleration_at(&change, twist, pose.turn(root_m)) - self.sample.real.gravity_m_s2;
        LinkMotion { axis, fall_m_s2: fall.rotated(-axis.y, axis.x), turning: [twist.angular, change.angular], beam }
    }

    /// Coordinates of the shapes of a flexible body, with their rates or accelerations `of`.
    fn shapes_of<'s>(&self, beam: usize, of: &'s [T]) -> &'s [T] {
        &of[self.mechanism.real.beams[beam].coordinates.clone()]
    }

    /// d(x), m, in the axes of the frame.
    fn place_m(&self, motion: &LinkMotion<T>, station: &Station, length_m: f64) -> Vec2<T> {
        match motion.beam {
            Some(beam) => self.sample.real.beams[beam].beam.point_m(station, self.shapes_of(beam, &self.coordinates)),
            None => Vec2::new(T::from_f64(length_m * station.share), T::zero()),
        }
    }

    /// Acceleration of a point at `d` minus that of gravity, m/s², in the axes of the frame (F2).
    fn pull_m_s2(&self, motion: &LinkMotion<T>, station: &Station, d: Vec2<T>) -> Vec2<T> {
        let [spin, change] = motion.turning;
        let carried = motion.fall_m_s2.plus(d.turned(), change).plus(d, -spin.squared());
        let Some(index) = motion.beam else { return carried };
        let beam = &self.sample.real.beams[index].beam;
        let [q, rates, changes] =
            [&self.coordinates, &self.rates, &self.accelerations].map(|of| self.shapes_of(index, of));
        let rate = beam.rate_m_s(station, q, rates);
        carried + beam.rate_m_s(station, q, changes) + beam.relative_acceleration_m_s2(station, rate, rates, spin)
    }

    /// α, rad: angle of a section from the frame.
    fn section_angle_rad(&self, motion: &LinkMotion<T>, station: &Station) -> T {
        motion.beam.map_or(T::zero(), |beam| {
            self.sample.real.beams[beam].beam.angle_rad(station, self.shapes_of(beam, &self.coordinates))
        })
    }

    /// Force, N, in the ground's frame, and couple, N m, of joints, springs and loads on the tip of a link.
    fn tip_load(&self, stressed: &StressedBody) -> (Vec2<T>, T) {
        let tip = PointId { body: stressed.body, point: stressed.ends[1] };
        let model = &self.mechanism.model;
        let (mut force_n, mut couple_n_m) = (Vec2::zero(), T::zero());
        for (index, joint) in model.joints.iter().enumerate() {
            for (side, point) in joint.kind.points().into_iter().enumerate() {
                if point == tip {
                    let on_second_n = self.joint_force_n(JointId(index));
                    force_n += if side == 1 { on_second_n } else { -on_second_n };
                }
            }
        }
        // Friction has a couple about the centre of the pin, at which joints of a link have their points.
        for (contact, at) in self.contacts.iter().zip(&self.sample.contacts) {
            let PlayId::Joint(joint) = self.mechanism.plays[at.play] else { continue };
            let [bearing, journal] = model.joints[joint.0].kind.points();
            if bearing == tip {
                couple_n_m += contact.moment_on_bearing_n_m;
            }
            if journal == tip {
                couple_n_m += contact.moment_on_journal_n_m;
            }
        }
        for (index, spring) in model.springs.iter().enumerate() {
            let SpringKind::Linear { first, second } = spring.kind else { continue };
            let on_second_n = self.spring_force(index).on_second_n;
            if second == tip {
                force_n += on_second_n;
            }
            if first == tip {
                force_n += -on_second_n;
            }
        }
        for (load, force) in model.loads.iter().zip(self.loads()) {
            if matches!(load.kind, LoadKind::Force { point, .. } if point == tip) {
                force_n += force.force_n;
            }
        }
        (force_n, couple_n_m)
    }
}

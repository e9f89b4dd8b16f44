//! A section of a beam at an end or at a point inside, on the frame of its body: the frame of the body as this section carries it. In the plane.

use super::form::FormOfAttachment;
use super::kind::{Columns, Hung, KindOfAttachment, Place, Rates};
use crate::mechanism::tree::beam::BeamPlace;
use crate::mechanism::tree::kinematics::{Kinematics, Pose, Twist};
use crate::mechanism::tree::spanning_tree::Tree;
use loosepin_math::{Geometry, KnownAngle, Plane, Real, Vec2};

/// A section of a beam.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Section {
    /// Index in [`Tree::beams`](crate::mechanism::Tree::beams).
    pub beam: usize,
    /// Which one.
    pub place: BeamPlace,
}

impl FormOfAttachment<Plane> for Section {
    /// Those of the shapes are the beam's, which counts them.
    fn counts(&self) -> [usize; 2] {
        [0, 0]
    }
}

/// Out of line: few mechanisms have a section.
impl KindOfAttachment<Plane> for Section {
    #[inline(never)]
    fn hang<T: Real>(
        &self,
        place: &Place<'_, T, Plane>,
        frame: &Pose<T>,
        coordinates: &[T],
        near: Option<&KnownAngle<T>>,
        Columns { linear, turnings }: Columns<'_, T, Plane>,
    ) -> Hung<T, Plane> {
        let (beam, numbers) = (&place.tree.beams[self.beam], &place.numbers.beams[self.beam]);
        let (station, q) = (beam.station(self.place), &coordinates[beam.coordinates.clone()]);
        let axis = frame.turn(numbers.axis);
        let rotation = Plane::oriented(&[frame.angle_rad() + numbers.beam.angle_rad(station, q)], near);
        let from_root_m = numbers.beam.point_m(station, q).rotated(axis.y, axis.x);
        let arm = Plane::turn(&rotation, numbers.axis_point_m(beam, self.place));
        match self.place {
            // The root does not move in the frame.
            BeamPlace::Root => linear.fill(Vec2::zero()),
            BeamPlace::Tip | BeamPlace::Inside(_) => numbers.beam.partials(station, q, linear),
        }
        for (linear, turning) in linear.iter_mut().zip(turnings) {
            *linear = Plane::moved(linear.rotated(axis.y, axis.x), *turning, -arm);
        }
        let position_m = frame.position_m + frame.turn(numbers.root_m) + from_root_m - arm;
        Hung::with(frame, Pose { position_m, rotation })
    }
    #[inline(never)]
    fn bias<T: Real>(&self, place: &Place<'_, T, Plane>, kinematics: &Kinematics<T>, rates: Rates<'_, T>) -> Twist<T> {
        let (beam, numbers) = (&place.tree.beams[self.beam], &place.numbers.beams[self.beam]);
        let (frame, twist) = (&kinematics.poses[beam.slot], &kinematics.twists[beam.slot]);
        let (bias, own) = (&kinematics.biases[beam.slot], &kinematics.twists[place.slot]);
        let arm = kinematics.poses[place.slot].turn(numbers.axis_point_m(beam, self.place));
        let reach = kinematics.poses[place.slot].position_m + arm - frame.position_m;
        // The end moves in the frame with what is left of its velocity.
        let relative = own.at(arm) - twist.at(reach);
        let along = numbers.beam.shortening_m_s2(beam.station(self.place), &rates.rates[beam.coordinates.clone()]);
        let at_end = kinematics
            .bias_at(beam.slot, reach)
            .plus(relative.turned(), twist.angular + twist.angular)
            .plus(frame.turn(numbers.axis), along);
        let linear = at_end.plus(arm.turned(), -bias.angular).plus(arm, own.angular.squared());
        Twist { linear, angular: bias.angular }
    }
    /// φ' of the lateral shapes; the axial ones, which move all but the root, do not turn it.
    fn first_turnings<T: Real>(&self, tree: &Tree) -> Vec<f64> {
        let beam = &tree.beams[self.beam];
        let axial = if self.place == BeamPlace::Root { 0 } else { beam.shapes.axial() };
        let slopes = beam.station(self.place).slopes.iter().copied();
        core::iter::repeat_n(0.0, axial).chain(slopes).collect()
    }
}

//! The force of teeth on the joints of two gears, or of a rack and its pinion.
//!
//! At the pitch point P, where the pitch circles touch, the second wheel gets the force G and the first one -G. Along the common
//! tangent of the circles G is the torque τ on the second wheel over its pitch radius (of a rack: the force along its guide). Across
//! it G has |G_t| tan α, with the pressure angle α, whichever flank carries: two gears are pushed apart, and in an internal mesh the
//! pinion is pushed from the rim towards the middle of the ring.
//!
//! Torques alone move the mechanism in the same way: at the centres of ideal joints a force does no work. It adds to what these two
//! joints carry, and to nothing else, since torque and force on the body that carries both wheels are the same. That is exact
//! where the distance of the centres fits the pitch radii; else the couple of the forces differs by the same share as the distance.

use crate::mechanism::error::MechanismError;
use crate::mechanism::loops::joint_geometry::JointGeometry;
use crate::mechanism::loops::tooth_geometry::ToothForce;
use crate::mechanism::tree::kinematics::Kinematics;
use crate::mechanism::tree::spanning_tree::{CouplingPlace, Tree};
use crate::model::{Model, QuantityId, Values};
use loosepin_math::{Real, Vec2};
use loosepin_text::units::{Dimension, format_apart};

impl<T: Real> ToothForce<T> {
    /// What the force of the teeth adds to the force of the first or second joint (`side`) on its second body, N, in the ground's
    /// frame, where the coupling acts with `effort` along the coordinate of the second joint, N m or N. Of the joint of a rack
    /// only what acts across the guide: along it the coupling acts already.
    pub fn on_second_body_n(
        &self,
        joints: &[JointGeometry<T>; 2],
        places: &CouplingPlace,
        kinematics: &Kinematics<T>,
        effort: T,
        side: usize,
    ) -> Vec2<T> {
        let signed = |value: T, is_positive: bool| if is_positive { value } else { -value };
        let on_wheel = signed(effort, self.is_second[1]);
        let [along_n, across_n] = self.mesh.force_n(
            on_wheel,
            self.slope,
            self.radii_m,
            || joints[1].line_of_action(&places[1], kinematics).1,
            || centres_m(joints, places, kinematics),
        );
        let is_rack = self.mesh.is_rack() && side == 1;
        let on_second_wheel_n = if is_rack { across_n } else { along_n + across_n };
        // The joint holds its wheel against the teeth; the body that carries it gets the force itself.
        if (side == 1) == self.is_second[side] { -on_second_wheel_n } else { on_second_wheel_n }
    }
}

/// Positions of the second bodies of both joints at their holding points, m.
fn centres_m<T: Real>(
    joints: &[JointGeometry<T>; 2],
    places: &CouplingPlace,
    kinematics: &Kinematics<T>,
) -> [Vec2<T>; 2] {
    [0, 1].map(|side| kinematics.poses[places[side].slots[1]].point_m(joints[side].arms_m[1]))
}

/// Pitch circles must touch where the joints feel the force of the teeth.
pub(in crate::mechanism) fn demand_fit(
    model: &Model,
    values: &Values,
    tree: &Tree,
    kinematics: &Kinematics<f64>,
) -> Result<(), MechanismError> {
    let number = |id: QuantityId| values[id];
    for (index, coupling) in model.couplings.iter().enumerate() {
        let Some(teeth) = ToothForce::new(coupling, &number) else { continue };
        let Some(due_m) = teeth.mesh.distance_m(teeth.radii_m) else { continue };
        let joints = [coupling.first, coupling.second].map(|joint| JointGeometry::new(model, joint, &number));
        let [first, second] = centres_m(&joints, &tree.coupling_place(model, index), kinematics);
        let distance_m = (second - first).length();
        if !teeth.mesh.fits(distance_m, due_m) {
            let [distance, due] = format_apart([distance_m, due_m], Dimension::LENGTH);
            return Err(MechanismError::PitchCirclesApart { path: coupling.path.clone(), distance, due });
        }
    }
    Ok(())
}

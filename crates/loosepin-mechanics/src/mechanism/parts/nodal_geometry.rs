//! The numbers of a flexible body in absolute nodal coordinates.

use crate::mechanism::tree::nodal_beam::TreeNodalBeam;
use crate::mechanism::tree::points::numbered_point_m;
use crate::model::{Model, PointId, QuantityId};
use loosepin_flexible::NodalBeam;
use loosepin_math::{Real, Vec2, numbers};

/// Numbers of a flexible body in absolute nodal coordinates.
#[derive(Debug, Clone)]
pub struct NodalGeometry<T> {
    /// The beam.
    pub beam: NodalBeam<T>,
    /// Its root in the frame of the body, m.
    pub root_m: Vec2<T>,
    /// Its tip in the frame of the body, undeformed, m.
    pub tip_m: Vec2<T>,
    /// Direction from root to tip in the frame of the body.
    pub axis: Vec2<T>,
}

numbers!(struct NodalGeometry { beam, root_m, tip_m, axis });

impl<T: Real> NodalGeometry<T> {
    /// Numbers of a body in absolute nodal coordinates; `None` for a body without a beam.
    pub(in crate::mechanism) fn new(
        model: &Model,
        place: &TreeNodalBeam,
        number: &dyn Fn(QuantityId) -> T,
    ) -> Option<Self> {
        let body = &model.bodies[place.body.0];
        let (beam, mass_kg) = (body.beam.as_ref()?, body.mass_kg?);
        let [root_m, tip_m] =
            place.points().map(|point| numbered_point_m(model, number, PointId { body: place.body, point }));
        let length_m = number(beam.length_m);
        Some(Self {
            beam: NodalBeam {
                length_m,
                mass_kg: number(mass_kg),
                axial_stiffness_n_m: number(beam.axial_stiffness_n_m),
                bending_stiffness_n_m: number(beam.bending_stiffness_n_m),
                retardation_s: beam.retardation_s.map_or(T::zero(), number),
            },
            root_m,
            tip_m,
            axis: (tip_m - root_m) * (T::one() / length_m),
        })
    }
}

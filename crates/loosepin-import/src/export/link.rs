//! A body with its mass.

use super::closed_model::Export;
use loosepin_space::Vec3;

/// Mass, centre of mass, and moments of inertia about it, xx, yy, zz, xy, xz, yz.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mass {
    pub mass_kg: f64,
    pub centre_m: Vec3,
    pub inertia_kg_m2: [f64; 6],
}

impl Mass {
    /// The mass of a body, if its model has mass and inertia; its centre is the origin where none is given.
    pub fn of(export: &Export<'_>, body: usize) -> Option<Mass> {
        let own = export.model.bodies.get(body)?;
        let mass_kg = export.values[own.mass_kg?];
        if own.inertia_kg_m2.is_empty() {
            return None;
        }
        let centre = own.centre_of_mass_m.map(|ids| Vec3::from(ids.map(|id| export.values[id])));
        let moment = |number: usize| own.inertia_kg_m2.get(number).map_or(0.0, |id| export.values[*id]);
        let inertia_kg_m2 = [0, 1, 2, 3, 4, 5].map(moment);
        Some(Mass { mass_kg, centre_m: centre.unwrap_or(Vec3::ZERO), inertia_kg_m2 })
    }
}

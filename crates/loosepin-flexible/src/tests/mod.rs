//! The beam against second codings, closed forms, published numbers and runs of other programs.

mod elastic_slider_crank;
mod frequencies;
mod inertia;
mod invariants;
mod lumps;
mod motion;
mod nodal_element;
mod nodal_pendulum;
mod nodal_statics;
mod points;
mod spin_up;
mod turning;

use crate::Beam;

/// A beam of rectangular section without damping, with foreshortening: modulus, density, length, width, height.
fn rectangular([modulus_pa, density_kg_m3, length_m, width_m, height_m]: [f64; 5]) -> Beam<f64> {
    let area_m2 = width_m * height_m;
    Beam {
        length_m,
        mass_kg: density_kg_m3 * area_m2 * length_m,
        axial_stiffness_n_m: modulus_pa * area_m2 / length_m,
        bending_stiffness_n_m: modulus_pa * area_m2 * height_m * height_m / 12.0 / length_m,
        damping_ratio: 0.0,
        foreshortening: true,
    }
}

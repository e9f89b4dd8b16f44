//! How far flexible bodies bend, before a run: by the loads of the rigid mechanism.
//!
//! ```text
//! κ = M/(E I),   θ(x) = ∫₀ˣ κ dξ - w(L)/L,   w(x) = ∫₀ˣ θ dξ         bending moment M and axial force N of the rigid links
//! ```
//!
//! Inertia, weight, springs and loads at the speed of the drives; impacts and ringing come on top. Without the chord w(L)/L in a tangent frame.
//! x goes from the end that a drive or a rigid joint holds, whose couple is then not needed; from `from` between pins. Where both ends are held
//! rigid links do not say how the couples share the load.

use crate::failure::RunFailure;
use crate::start::supports::buckling_factor;
use loosepin_mechanics::dynamics::{Dynamics, SectionForce};
use loosepin_mechanics::mechanism::{IdealMotion, Mechanism, Sample};
use loosepin_mechanics::model::{Beam, BodyId, PointId, Values};

/// Positions that are looked at: of a moment with three waves in a turn the largest is missed by 1 %.
const POSITIONS: u32 = 72;

/// Bending of a flexible body under the loads of the rigid mechanism.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BendingEstimate {
    /// The body.
    pub body: BodyId,
    /// Largest angle of a section from the frame of the body, rad; in absolute nodal coordinates from the line through its ends. NaN
    /// if both ends are held.
    pub largest_angle_rad: f64,
    /// Largest pull in it, N, >= 0.
    pub largest_tension_n: f64,
    /// Largest push in it, N, >= 0.
    pub largest_compression_n: f64,
    /// Push under which the straight beam buckles as its ends are held, N: π² EI/L² between pins, a quarter of it clamped and free.
    pub buckling_load_n: f64,
    /// Largest strain of its axis, |N|/(E A).
    pub largest_strain: f64,
}

/// Estimates for all flexible bodies of a mechanism: over `span_s` of its ideal motion where its drives move it, else at its start.
///
/// # Errors
/// The ideal mechanism cannot be closed.
pub fn estimate_bending(
    mechanism: &Mechanism,
    values: &Values,
    span_s: f64,
) -> Result<Vec<BendingEstimate>, RunFailure> {
    let cut = mechanism.with_rigid_links_cut(values);
    let sample = Sample::<f64>::new(&cut, values)?.without_play();
    let ideal = cut.without_play();
    let links: Vec<Link<'_>> =
        ideal.stressed.iter().filter_map(|stressed| Link::new(mechanism, stressed.body, values)).collect();
    let mut estimates: Vec<BendingEstimate> = links.iter().map(Link::unloaded).collect();
    let mut dynamics = Dynamics::new(&ideal, &sample);
    let n = ideal.real.free;
    let mut look = |time_s: f64, coordinates: &[f64], rates: &[f64]| {
        dynamics.sample_mut().take_pieces_at(time_s);
        dynamics.evaluate(time_s, &coordinates[..n], &rates[..n], &[]);
        for (index, (link, estimate)) in links.iter().zip(&mut estimates).enumerate() {
            link.take_in(&dynamics.section_forces(index), estimate);
        }
    };
    if ideal.is_driven() {
        let mut motion = IdealMotion::new(&ideal, &sample.ideal, &sample.drives)?;
        for position in 0..=POSITIONS {
            let time_s = span_s * f64::from(position) / f64::from(POSITIONS);
            motion.move_to(time_s)?;
            let (coordinates, rates) = motion.real_state();
            look(time_s, coordinates, rates);
        }
    } else {
        let (coordinates, rates) = ideal.start(&sample)?;
        look(0.0, &coordinates, &rates);
    }
    Ok(estimates)
}

/// A flexible body as a rigid link.
struct Link<'m> {
    body: BodyId,
    beam: &'m Beam,
    length_m: f64,
    /// EA, N, and EI, N m².
    stiffness: [f64; 2],
    /// Push under which it buckles, N.
    buckling_load_n: f64,
    is_held_at_both_ends: bool,
}

impl<'m> Link<'m> {
    /// `None` for a rigid body.
    fn new(mechanism: &'m Mechanism, body: BodyId, values: &Values) -> Option<Self> {
        let beam = mechanism.model.bodies[body.0].beam.as_ref()?;
        let length_m = values[beam.length_m];
        let stiffness = [beam.axial_stiffness_n_m, beam.bending_stiffness_n_m].map(|id| values[id] * length_m);
        let ends = beam.ends.map(|point| PointId { body, point });
        let factor = buckling_factor(&mechanism.model, values, ends);
        let is_held_at_both_ends = ends.into_iter().all(|end| mechanism.model.holds_section(end));
        let buckling_load_n = factor * factor * stiffness[1] / (length_m * length_m);
        Some(Self { body, beam, length_m, stiffness, buckling_load_n, is_held_at_both_ends })
    }

    fn unloaded(&self) -> BendingEstimate {
        BendingEstimate {
            body: self.body,
            largest_angle_rad: if self.is_held_at_both_ends { f64::NAN } else { 0.0 },
            largest_tension_n: 0.0,
            largest_compression_n: 0.0,
            buckling_load_n: self.buckling_load_n,
            largest_strain: 0.0,
        }
    }

    /// Takes the forces at the cuts of one position in.
    fn take_in(&self, cuts: &[(f64, SectionForce<f64>)], estimate: &mut BendingEstimate) {
        let (mut angles_rad, mut deflection_m) = (vec![0.0], 0.0);
        for pair in cuts.windows(2) {
            let [(before, left), (behind, right)] = [pair[0], pair[1]];
            let step_m = (behind - before) * self.length_m;
            let angle_rad = angles_rad[angles_rad.len() - 1];
            let turn_rad = 0.5 * step_m * (left.moment_n_m + right.moment_n_m) / self.stiffness[1];
            deflection_m += step_m * (angle_rad + 0.5 * turn_rad);
            angles_rad.push(angle_rad + turn_rad);
        }
        let chord_rad = if self.beam.has_tangent_frame() { 0.0 } else { deflection_m / self.length_m };
        let largest_rad = angles_rad.iter().fold(0.0_f64, |largest, angle| largest.max((angle - chord_rad).abs()));
        if !self.is_held_at_both_ends {
            estimate.largest_angle_rad = estimate.largest_angle_rad.max(largest_rad);
        }
        for (_, cut) in cuts {
            estimate.largest_tension_n = estimate.largest_tension_n.max(-cut.along_n);
            estimate.largest_compression_n = estimate.largest_compression_n.max(cut.along_n);
            estimate.largest_strain = estimate.largest_strain.max(cut.along_n.abs() / self.stiffness[0]);
        }
    }
}

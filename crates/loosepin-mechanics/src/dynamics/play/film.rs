//! A film of oil between pin and hole (`docs/lubrication.md`).

use crate::contact::Film;
use crate::dynamics::play::contact_motion::ContactForce;
use crate::dynamics::play::motion::PlayMotion;
use loosepin_math::{Real, Vec2};

/// Below this, m, the journal is centred: n may then be any direction, and nothing that follows depends on it.
const CENTRED_M: f64 = 1e-150;

/// Adds the force and the moments of a film to those of the contact. What the film loses counts as friction.
///
/// The film sees q = ė - ½(ω_i + ω_j) k × e, so that w = ω_i + ω_j - 2γ̇ is never computed and nothing is divided by |e|.
///
/// Long, and so out of line.
#[inline(never)]
pub(in crate::dynamics) fn add<T: Real>(
    motion: &PlayMotion<T>,
    film: &Film<T>,
    clearance_m: T,
    to: &mut ContactForce<T>,
) {
    let e = motion.eccentricity_m;
    let length_m = e.length();
    let is_centred = length_m.less_than(T::from_f64(CENTRED_M));
    let inverse_1_m = T::one() / length_m.max(T::from_f64(CENTRED_M));
    let normal = Vec2::new(
        T::select(is_centred, T::one(), e.x * inverse_1_m),
        T::select(is_centred, T::zero(), e.y * inverse_1_m),
    );
    let tangent = normal.turned();
    let [spin_i, spin_j] = motion.spins_rad_s;
    let mean_rad_s = T::from_f64(0.5) * (spin_i + spin_j);
    let velocity_m_s = motion.eccentricity_rate_m_s.plus(e.turned(), -mean_rad_s);
    let along_m_s = [velocity_m_s.dot(normal), velocity_m_s.dot(tangent)];
    let load = film.load(clearance_m, length_m, along_m_s, motion.spins_rad_s);
    to.on_journal_n += normal * load.force.radial_n + tangent * load.force.tangential_n;
    to.moment_on_bearing_n_m += load.moments_n_m[0];
    to.moment_on_journal_n_m += load.moments_n_m[1];
    to.friction_loss_w += load.loss_w;
    to.film_loss_w = load.loss_w;
}

//! A pin on the elastic foundation of its worn hole: the one contact of such a joint.
//!
//! The foundation is computed on plain numbers; mechanisms with one are never written down for lanes.

use crate::contact::{Foundation, FoundationMotion, PlayState};
use crate::dynamics::play::contact_motion::{ContactForce, ContactMotion, GapMotion};
use crate::dynamics::play::motion::PlayMotion;
use loosepin_math::{Real, Vec2};

/// Sine and cosine of the bearing's angle.
fn turn<T: Real>(motion: &PlayMotion<T>) -> (f64, f64) {
    motion.angles_rad[0].to_f64().sin_cos()
}

fn plain<T: Real>(vector: Vec2<T>) -> Vec2<f64> {
    Vec2::new(vector.x.to_f64(), vector.y.to_f64())
}

/// A motion in the axes of the bearing.
pub fn foundation_motion<T: Real>(motion: &PlayMotion<T>) -> FoundationMotion {
    let (sine, cosine) = turn(motion);
    let of_bearing = |vector: Vec2<T>| plain(vector).rotated(-sine, cosine);
    let [bearing_rad, journal_rad] = motion.angles_rad.map(Real::to_f64);
    FoundationMotion {
        eccentricity_m: of_bearing(motion.eccentricity_m),
        rate_m_s: of_bearing(motion.eccentricity_rate_m_s),
        turn_rad: bearing_rad - journal_rad,
        spins_rad_s: motion.spins_rad_s.map(Real::to_f64),
    }
}

/// Normal, penetration and rate of the deepest sector.
#[inline(never)]
pub(in crate::dynamics) fn contact<T: Real>(motion: &PlayMotion<T>, foundation: &Foundation) -> ContactMotion<T> {
    let deepest = foundation.deepest(&foundation_motion(motion));
    let (sine, cosine) = turn(motion);
    ContactMotion {
        normal: Vec2::from_f64(deepest.normal.rotated(sine, cosine)),
        penetration_m: T::from_f64(deepest.penetration_m),
        penetration_rate_m_s: T::from_f64(deepest.rate_m_s),
        reaches_m: [Vec2::zero(); 2],
    }
}

/// The energy stored in all sectors, J; zero if `penetration_m`, that of the deepest, is not positive.
#[inline(never)]
pub(in crate::dynamics) fn stored_energy_j<T: Real>(
    motion: &PlayMotion<T>,
    foundation: &Foundation,
    penetration_m: T,
) -> T {
    if !(penetration_m.to_f64() > 0.0) {
        return T::zero();
    }
    T::from_f64(foundation.load(&foundation_motion(motion), 0.0, &mut |_| {}).stored_j)
}

/// The force of all sectors, zero in flight.
#[inline(never)]
pub(in crate::dynamics) fn force<T: Real>(
    motion: &PlayMotion<T>,
    foundation: &Foundation,
    state: &PlayState<T>,
) -> ContactForce<T> {
    let own = foundation_motion(motion);
    let is_closed = state.contact.to_f64() > 0.0;
    let inverse_impact_speed_s_m = state.inverse_impact_speed_s_m.to_f64();
    let load =
        if is_closed { foundation.load(&own, inverse_impact_speed_s_m, &mut |_| {}) } else { Default::default() };
    let (sine, cosine) = turn(motion);
    let normal_n = load.normal_on_journal_n.length();
    let number = T::from_f64;
    ContactForce {
        on_journal_n: Vec2::from_f64(load.on_journal_n.rotated(sine, cosine)),
        moment_on_journal_n_m: number(load.moments_n_m[1]),
        moment_on_bearing_n_m: number(load.moments_n_m[0]),
        contact_loss_w: number(load.contact_loss_w),
        friction_loss_w: number(load.friction_loss_w),
        film_loss_w: T::zero(),
        normal_n: number(normal_n),
        penetration_rate_m_s: number(load.deepest_rate_m_s),
        bristle_rate_m_s: T::zero(),
        // Without load that of the nearest sector, to which the mean over the sectors goes where contact ends.
        sliding_m_s: number(if load.sum_n > 0.0 {
            load.sliding_w / load.sum_n
        } else {
            foundation.deepest(&own).sliding_m_s
        }),
        spread_path_w: Some(number(load.path_w)),
        force_share: number(normal_n),
        along_m: T::zero(),
    }
}

/// δ of the deepest sector and its derivatives.
#[inline(never)]
pub(in crate::dynamics) fn gap<T: Real>(
    motion: &PlayMotion<T>,
    foundation: &Foundation,
    acceleration_m_s2: Vec2<T>,
    spin_rates_rad_s2: [T; 2],
) -> GapMotion<T> {
    let own = foundation_motion(motion);
    let deepest = foundation.deepest(&own);
    let (sine, cosine) = turn(motion);
    let acceleration_m_s2 = plain(acceleration_m_s2).rotated(-sine, cosine);
    let changes = spin_rates_rad_s2.map(Real::to_f64);
    let bent = T::from_f64(foundation.penetration_acceleration_m_s2(&own, &deepest, acceleration_m_s2, changes));
    GapMotion::without_slot([T::from_f64(deepest.penetration_m), T::from_f64(deepest.rate_m_s), bent], bent)
}

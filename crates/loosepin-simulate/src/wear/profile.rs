//! Friction path by sectors of both surfaces.

use super::joint::WearingJoint;
use crate::observer::FoundationAt;
use loosepin_mechanics::contact::share_below;
use std::f64::consts::TAU;

/// The friction path ∫F_N |v_T| dt of one joint, by sectors fixed to each surface: sector s reaches from sΔ to (s + 1)Δ, Δ = 2π/n,
/// counted from the x axis of the body that has the surface.
#[derive(Debug, Clone, PartialEq)]
pub struct WearProfile {
    /// Friction path of the bearing and of the journal, by sector, J.
    pub path_j: [Vec<f64>; 2],
    /// Sum over all sectors, J.
    pub total_j: f64,
    /// The part of it under a force whose patch is half the circumference, and so cut off, J.
    pub capped_j: f64,
    /// Largest half-width of the patch, m.
    pub widest_m: f64,
    /// Sliding path of each sector of the bearing and of the journal under load, m, if the joint has an elastic foundation.
    pub slid_m: [Vec<f64>; 2],
    /// The same joint: smallest and largest angle of the bearing from the journal, rad.
    pub turns_rad: [f64; 2],
}

/// The contact at an instant, with the friction path that it stands for.
#[derive(Debug, Clone, Copy)]
pub struct ContactSample {
    /// Angle of the normal n, from the bearing's centre to the contact, in the ground's frame, rad.
    pub normal_rad: f64,
    /// Angles of the bearing's and of the journal's body, rad.
    pub bodies_rad: [f64; 2],
    /// Normal force, N.
    pub force_n: f64,
    /// F_N |v_T| times the time that it stands for, J.
    pub path_j: f64,
}

impl WearProfile {
    /// An unworn profile.
    pub fn new(joint: &WearingJoint) -> Self {
        let none = vec![0.0; joint.sectors];
        Self {
            path_j: [none.clone(), none.clone()],
            total_j: 0.0,
            capped_j: 0.0,
            widest_m: 0.0,
            slid_m: [none.clone(), none],
            turns_rad: [f64::INFINITY, f64::NEG_INFINITY],
        }
    }

    /// Takes in the load of an elastic foundation that stands for `weight_s`: each sector of the bearing its own, and the journal's
    /// beside it by the weights of its spline, which add up to one.
    pub(super) fn add_foundation(&mut self, at: &FoundationAt, weight_s: f64) {
        let weights = at.foundation.journal_weights(at.motion.turn_rad);
        let count = at.foundation.sectors();
        let Self { path_j: [bearing_j, journal_j], slid_m: [bearing_m, journal_m], .. } = self;
        let load = at.foundation.load(&at.motion, at.inverse_impact_speed_s_m, &mut |pressed| {
            let slid = pressed.sliding_m_s.abs() * weight_s;
            bearing_m[pressed.sector] += slid;
            bearing_j[pressed.sector] += pressed.force_n * slid;
            for (sector, weight) in weights.sectors(pressed.sector, count).into_iter().zip(weights.value) {
                journal_m[sector] += weight * slid;
                journal_j[sector] += weight * pressed.force_n * slid;
            }
        });
        self.total_j += load.path_w * weight_s;
        let half_sector_m = at.foundation.bearing_radius_m * 0.5 * TAU / count as f64;
        self.widest_m = self.widest_m.max(load.carrying as f64 * half_sector_m);
        let [least, most] = self.turns_rad;
        self.turns_rad = [least.min(at.motion.turn_rad), most.max(at.motion.turn_rad)];
    }

    /// k_f (k_i s_i + k_j s_j), s_i and s_j the longest sliding paths of a sector of bearing and journal: the most by which a cycle
    /// takes from a foundation of `stiffness_pa_m` what it is pressed, as a share of it.
    pub(super) fn stiffening(&self, coefficients_m2_n: [Option<f64>; 2], stiffness_pa_m: f64) -> f64 {
        let of_side = |side: usize| {
            let longest_m = self.slid_m[side].iter().copied().fold(0.0, f64::max);
            coefficients_m2_n[side].unwrap_or(0.0) * longest_m
        };
        stiffness_pa_m * (of_side(0) + of_side(1))
    }

    /// Distributes a friction path over the sectors.
    pub fn add(&mut self, joint: &WearingJoint, pressed: &ContactSample) {
        if !(pressed.path_j > 0.0) {
            return;
        }
        let (half_width_m, is_capped) = joint.patch.map_or((0.0, false), |patch| patch.half_width_m(pressed.force_n));
        self.total_j += pressed.path_j;
        self.widest_m = self.widest_m.max(half_width_m);
        if is_capped {
            self.capped_j += pressed.path_j;
        }
        // The same directions for both surfaces: the journal touches with its side towards n.
        let half_rad = half_width_m / joint.radii_m[0];
        for side in [0, 1] {
            let middle_rad = pressed.normal_rad - pressed.bodies_rad[side];
            distribute(&mut self.path_j[side], pressed.path_j, middle_rad, half_rad);
        }
    }
}

/// Adds `amount` to the sectors as a semi-ellipse of `half_rad` around `middle_rad`. The shares add up to one.
fn distribute(sectors: &mut [f64], amount: f64, middle_rad: f64, half_rad: f64) {
    let count = sectors.len();
    let width_rad = TAU / count as f64;
    let place = |number: i64| number.rem_euclid(count as i64) as usize;
    let number = |angle_rad: f64| (angle_rad / width_rad).floor() as i64;
    let (first, last) = (number(middle_rad - half_rad), number(middle_rad + half_rad));
    let mut below = 0.0;
    for sector in first..last {
        let edge_rad = (sector + 1) as f64 * width_rad;
        let until = share_below((edge_rad - middle_rad) / half_rad);
        sectors[place(sector)] += amount * (until - below);
        below = until;
    }
    sectors[place(last)] += amount * (1.0 - below);
}

#[cfg(test)]
mod tests {
    use super::{WearProfile, distribute};
    use crate::observer::FoundationAt;
    use crate::wear::WearingJoint;
    use loosepin_math::Vec2;
    use loosepin_mechanics::contact::{Foundation, FoundationMotion, FrictionLaw};
    use loosepin_mechanics::model::JointId;
    use std::f64::consts::TAU;
    use std::sync::Arc;

    #[test]
    fn analytic_a_journal_under_one_load_slides_as_long_as_a_bearing_that_turns_below_it_does_in_all_its_sectors() {
        let (sectors, [radius_m, clearance_m, length_m]) = (36, [0.01, 1e-4, 0.02]);
        let joint = WearingJoint {
            joint: JointId(0),
            play: Some(0),
            radii_m: [radius_m, radius_m - clearance_m],
            length_m,
            coefficients_m2_n: [Some(0.0), Some(1e-14)],
            cycles: 1.0,
            sectors,
            patch: None,
        };
        let (stiffness_pa_m, spin_rad_s, penetration_m) = (6.7e12, 10.0, 5e-5);
        let numbers = [radius_m, clearance_m, length_m];
        let friction = FrictionLaw::None;
        let foundation = Arc::new(Foundation::unworn(numbers, stiffness_pa_m, 0.0, friction, sectors));
        let mut profile = WearProfile::new(&joint);
        // The pin stands, pressed to one side; the bearing turns once around it, from one middle of a sector to the next.
        let steps = 50 * sectors;
        let weight_s = TAU / spin_rad_s / steps as f64;
        let eccentricity_m = clearance_m + penetration_m;
        for step in 0..steps {
            let turn_rad = (step as f64 + 0.5) * TAU / steps as f64;
            let towards = Vec2::new(turn_rad.cos(), -turn_rad.sin());
            let motion = FoundationMotion {
                eccentricity_m: towards * eccentricity_m,
                rate_m_s: Vec2::zero(),
                turn_rad,
                spins_rad_s: [spin_rad_s, 0.0],
            };
            let at = FoundationAt { foundation: foundation.clone(), motion, inverse_impact_speed_s_m: 0.0 };
            profile.add_foundation(&at, weight_s);
        }
        // A sector that carries slides by 2π (R_i + a), a between 0 and δ/2; one of the journal at the load all the time, one of the
        // bearing while cos β > c/(c + δ).
        let turn_m = TAU * radius_m;
        let share = 2.0 * (clearance_m / eccentricity_m).acos() / TAU;
        let longest_m = profile.slid_m.each_ref().map(|own| own.iter().copied().fold(0.0, f64::max));
        let tolerance = 0.5 * penetration_m / radius_m;
        assert!((longest_m[1] / turn_m - 1.0) > 0.0 && (longest_m[1] / turn_m - 1.0) < tolerance, "{longest_m:?}");
        // Its time under load is counted in steps, of which 50 pass a sector.
        let least = share - 2.0 / steps as f64;
        let of_turn = longest_m[0] / turn_m;
        assert!(least < of_turn && of_turn < (share + 2.0 / steps as f64) * (1.0 + tolerance), "{of_turn} {share}");
        let sums_m = profile.slid_m.each_ref().map(|own| own.iter().sum::<f64>());
        assert!((sums_m[1] / sums_m[0] - 1.0).abs() < 1e-12, "{sums_m:?}");
        // The bearing does not wear: the journal alone limits the jumps.
        let stiffening = |coefficients| profile.stiffening(coefficients, stiffness_pa_m);
        let of_journal = stiffness_pa_m * 1e-14 * turn_m;
        assert!((stiffening(joint.coefficients_m2_n) / of_journal - 1.0).abs() < tolerance);
        assert_eq!(stiffening([None, Some(1e-14)]), stiffening(joint.coefficients_m2_n));
        let ratio = stiffening([Some(1e-14), None]) / of_journal;
        assert!((ratio / share - 1.0).abs() < 0.02, "{ratio} {share}");
    }

    #[test]
    fn analytic_a_semi_ellipse_lies_half_on_each_side_of_its_middle() {
        let mut sectors = vec![0.0; 8];
        // Around the edge between the last sector and the first, within both.
        distribute(&mut sectors, 3.0, -7.0 * TAU, 0.3);
        assert!((sectors[7] - 1.5).abs() < 1e-14 && (sectors[0] - 1.5).abs() < 1e-14, "{sectors:?}");
        assert_eq!(sectors[1..7], [0.0; 6]);
    }

    #[test]
    fn identity_the_shares_of_the_sectors_add_up_and_coarse_sectors_are_sums_of_fine_ones() {
        for (middle_rad, half_rad) in [(0.1, 0.0), (5.9, 0.02), (-2.0, 0.4), (31.0, 1.57)] {
            let [mut fine, mut coarse] = [vec![0.0; 90], vec![0.0; 30]];
            distribute(&mut fine, 0.7, middle_rad, half_rad);
            distribute(&mut coarse, 0.7, middle_rad, half_rad);
            assert!((fine.iter().sum::<f64>() - 0.7).abs() < 1e-14);
            assert!(fine.iter().all(|own| *own >= 0.0));
            for (sum, own) in fine.chunks(3).map(|three| three.iter().sum::<f64>()).zip(&coarse) {
                assert!((sum - own).abs() < 1e-14, "{middle_rad} {half_rad}: {sum} {own}");
            }
        }
    }
}

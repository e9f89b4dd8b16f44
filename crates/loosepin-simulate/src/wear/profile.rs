//! Friction path by sectors of both surfaces.

use super::joint::WearingJoint;
use crate::observer::FoundationAt;
use loosepin_mechanics::contact::share_below;
use std::f64::consts::TAU;

/// The friction path ∫F_N |v_T| dt of one joint, by sectors fixed to each surface: sector s reaches from sΔ to (s + 1)Δ, Δ = 2π/n,
/// counted from the x axis of the body that has the surface.
#[derive(Debug, Clone, PartialEq)]
pub struct WearProfile {
    /// Of the bearing and of the journal, by sector, J.
    pub path_j: [Vec<f64>; 2],
    /// Sum over all sectors, J.
    pub total_j: f64,
    /// The part of it under a force whose patch is half the circumference, and so cut off, J.
    pub capped_j: f64,
    /// Largest half-width of the patch, m.
    pub widest_m: f64,
    /// Where the joint has an elastic foundation: sliding path of each sector of the bearing under load, m. The journal's is as long.
    pub slid_m: Vec<f64>,
    /// The same joint: smallest and largest angle of the bearing from the journal, rad.
    pub turns_rad: [f64; 2],
}

/// The contact at an instant, with the friction path that it stands for.
#[derive(Debug, Clone, Copy)]
pub struct Pressed {
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
    /// Nothing worn.
    pub fn new(joint: &WearingJoint) -> Self {
        let none = vec![0.0; joint.sectors];
        Self {
            path_j: [none.clone(), none],
            total_j: 0.0,
            capped_j: 0.0,
            widest_m: 0.0,
            slid_m: vec![0.0; joint.sectors],
            turns_rad: [f64::INFINITY, f64::NEG_INFINITY],
        }
    }

    /// Takes in the load of an elastic foundation that stands for `weight_s`: each sector of the bearing its own, and the journal's
    /// beside it by the weights of its spline, which add up to one.
    pub(super) fn add_foundation(&mut self, at: &FoundationAt, weight_s: f64) {
        let weights = at.foundation.journal_weights(at.motion.turn_rad);
        let count = at.foundation.sectors();
        let Self { path_j: [bearing_j, journal_j], slid_m, .. } = self;
        let load = at.foundation.load(&at.motion, at.inverse_impact_speed_s_m, &mut |pressed| {
            let slid = pressed.sliding_m_s.abs() * weight_s;
            slid_m[pressed.sector] += slid;
            bearing_j[pressed.sector] += pressed.force_n * slid;
            for (sector, weight) in weights.sectors(pressed.sector, count).into_iter().zip(weights.value) {
                journal_j[sector] += weight * pressed.force_n * slid;
            }
        });
        self.total_j += load.path_w * weight_s;
        let half_sector_m = at.foundation.bearing_radius_m * 0.5 * TAU / count as f64;
        self.widest_m = self.widest_m.max(load.carrying as f64 * half_sector_m);
        let [least, most] = self.turns_rad;
        self.turns_rad = [least.min(at.motion.turn_rad), most.max(at.motion.turn_rad)];
    }

    /// Distributes a friction path over the sectors.
    pub fn add(&mut self, joint: &WearingJoint, pressed: &Pressed) {
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
    use super::distribute;
    use std::f64::consts::TAU;

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

//! An elastic foundation between a worn pin and its worn hole (`docs/theory/wear.md`, equations 9 to 16).
//!
//! Plain numbers alone: which sectors touch depends on the state, so that nothing of it can be written down for lanes.

use super::friction::FrictionLaw;
use super::worn_profile::{Weights, WornProfile, wrapped};
use loosepin_math::Vec2;
use std::f64::consts::{FRAC_1_SQRT_2, PI, TAU};

/// Angles at which the clearance between two worn surfaces is looked at are no closer, rad.
const CLOSEST_RAD: f64 = TAU / 180.0;

/// Foundation between the worn surfaces of a joint: independent springs over the sectors of the bearing.
#[derive(Debug, Clone)]
pub struct Foundation {
    /// Radius R_i of the bearing, m.
    pub bearing_radius_m: f64,
    /// Radial clearance c of the unworn joint, m.
    pub clearance_m: f64,
    /// Length L_b of the bearing, m.
    pub length_m: f64,
    /// Stiffness k_f: pressure over penetration, Pa/m.
    pub stiffness_pa_m: f64,
    /// χ of F = F_el (1 + χ δ̇/v0).
    pub damping_factor: f64,
    /// Friction, without memory.
    pub friction: FrictionLaw<f64>,
    /// Worn depths of bearing and journal.
    profiles: [WornProfile; 2],
    /// H_i at the middles of the sectors, m.
    bearing_m: Vec<f64>,
    /// Directions of the middles of the sectors in the frame of the bearing.
    normals: Vec<Vec2<f64>>,
}

/// Motion of a journal in its bearing, in the axes of the bearing.
#[derive(Debug, Clone, Copy)]
pub struct FoundationMotion {
    /// Eccentricity e, m.
    pub eccentricity_m: Vec2<f64>,
    /// ė as seen from the ground, m/s.
    pub rate_m_s: Vec2<f64>,
    /// θ_i - θ_j: angle of the bearing's body from that of the journal's, rad.
    pub turn_rad: f64,
    /// ω_i and ω_j, rad/s.
    pub spins_rad_s: [f64; 2],
}

/// Load of a foundation: sums over its sectors, in the axes of the bearing.
#[derive(Debug, Clone, Copy, Default)]
pub struct FoundationLoad {
    /// Force on the journal, N.
    pub on_journal_n: Vec2<f64>,
    /// Its normal part alone, -Σ F_s n_s, N.
    pub normal_on_journal_n: Vec2<f64>,
    /// Moments on the bearing's body about P_i and on the journal's about P_j, N m.
    pub moments_n_m: [f64; 2],
    /// Σ F_s, N.
    pub sum_n: f64,
    /// Σ F_s v_s, W.
    pub sliding_w: f64,
    /// Σ F_s |v_s|: the rate of the friction path, W.
    pub path_w: f64,
    /// Power that the normal contact turns into heat, W.
    pub contact_loss_w: f64,
    /// Power that friction turns into heat, W.
    pub friction_loss_w: f64,
    /// Σ k_f R_i Δ L_b δ_s²/2, J.
    pub stored_j: f64,
    /// Sectors that carry.
    pub carrying: usize,
    /// δ̇ of the deepest of them, m/s.
    pub deepest_rate_m_s: f64,
}

/// One sector of the bearing, pressed.
#[derive(Debug, Clone, Copy)]
pub struct PressedSector {
    /// The sector.
    pub sector: usize,
    /// Force F_s, N.
    pub force_n: f64,
    /// Sliding velocity v_s, m/s.
    pub sliding_m_s: f64,
}

/// The sector that is nearest to contact, or deepest in it.
#[derive(Debug, Clone, Copy)]
pub struct DeepestSector {
    /// n_s in the axes of the bearing.
    pub normal: Vec2<f64>,
    /// δ_s, m: positive in contact.
    pub penetration_m: f64,
    /// δ̇_s, m/s.
    pub rate_m_s: f64,
    /// Sliding velocity v_s, m/s.
    pub sliding_m_s: f64,
    /// H_j' and H_j'' at the sector, m/rad and m/rad².
    journal_slopes: [f64; 2],
}

/// k_f = 3π E*/(16 R_i), Pa/m: for a small penetration of the unworn joint the force of Liu and others 2006.
pub fn liu_foundation_pa_m(compliances_1_pa: [f64; 2], bearing_radius_m: f64) -> f64 {
    3.0 * PI / (16.0 * bearing_radius_m * (compliances_1_pa[0] + compliances_1_pa[1]))
}

/// k_f = 3 K √c/(4√2 R_i L_b), Pa/m: for a small penetration of the unworn joint the force K δ^1.5.
pub fn point_law_foundation_pa_m(stiffness_n_m1_5: f64, clearance_m: f64, bearing_radius_m: f64, length_m: f64) -> f64 {
    0.75 * FRAC_1_SQRT_2 * stiffness_n_m1_5 * clearance_m.sqrt() / (bearing_radius_m * length_m)
}

impl Foundation {
    /// For an unworn joint with `sectors` on each surface.
    pub fn unworn(
        [bearing_radius_m, clearance_m, length_m]: [f64; 3],
        stiffness_pa_m: f64,
        damping_factor: f64,
        friction: FrictionLaw<f64>,
        sectors: usize,
    ) -> Self {
        let middle = |sector: usize| {
            let (sine, cosine) = ((sector as f64 + 0.5) * TAU / sectors as f64).sin_cos();
            Vec2::new(cosine, sine)
        };
        Self {
            bearing_radius_m,
            clearance_m,
            length_m,
            stiffness_pa_m,
            damping_factor,
            friction,
            profiles: [0, 1].map(|_| WornProfile::unworn(sectors)),
            bearing_m: vec![0.0; sectors],
            normals: (0..sectors).map(middle).collect(),
        }
    }

    /// The same joint worn to other depths of the sectors of bearing and journal, m; both lists have a depth for each sector.
    #[must_use]
    pub fn worn(&self, depths_m: [&[f64]; 2]) -> Self {
        let profiles = depths_m.map(|depths_m| WornProfile::new(depths_m.to_vec()));
        let bearing_m = (0..self.sectors()).map(|sector| profiles[0].at_middle_m(sector)).collect();
        Self { profiles, bearing_m, ..self.clone() }
    }

    /// Sectors of each surface.
    pub fn sectors(&self) -> usize {
        self.normals.len()
    }

    /// k_f R_i Δ L_b: stiffness of a sector, N/m.
    fn sector_stiffness_n_m(&self) -> f64 {
        self.stiffness_pa_m * self.bearing_radius_m * TAU / self.sectors() as f64 * self.length_m
    }

    /// The weights of the journal's profile at the middles of the bearing's sectors: the same for all of them.
    pub fn journal_weights(&self, turn_rad: f64) -> Weights {
        Weights::at(turn_rad, self.sectors())
    }

    /// H_j, H_j' and H_j'' at a sector of the bearing.
    fn journal_jet(&self, sector: usize, weights: &Weights) -> [f64; 3] {
        if self.profiles[1].is_unworn() { [0.0; 3] } else { self.profiles[1].jet(sector, weights) }
    }

    /// The sectors over which the foundation may be pressed: a first one and a number. δ_s <= e·n_s - c.
    fn window(&self, eccentricity_m: Vec2<f64>) -> (usize, usize) {
        let count = self.sectors();
        let length_m = eccentricity_m.length();
        if !(length_m > self.clearance_m) {
            return (0, 0);
        }
        let half = (self.clearance_m / length_m).acos() * count as f64 / TAU + 1.0;
        let middle = eccentricity_m.y.atan2(eccentricity_m.x) * count as f64 / TAU;
        let first = (middle - 0.5 - half).floor() as i64;
        let reach = ((2.0 * half).ceil() as usize + 2).min(count);
        (first.rem_euclid(count as i64) as usize, reach)
    }

    /// Load in a motion with 1/v0 of the impact, s/m; `show` sees every sector that carries.
    pub fn load(
        &self,
        motion: &FoundationMotion,
        inverse_impact_speed_s_m: f64,
        show: &mut dyn FnMut(&PressedSector),
    ) -> FoundationLoad {
        let mut load = FoundationLoad::default();
        let (first, reach) = self.window(motion.eccentricity_m);
        if reach == 0 {
            return load;
        }
        let weights = self.journal_weights(motion.turn_rad);
        let stiffness_n_m = self.sector_stiffness_n_m();
        let damping_s_m = self.damping_factor * inverse_impact_speed_s_m;
        let has_friction = self.friction.acts();
        let [spin_i, spin_j] = motion.spins_rad_s;
        let mut deepest_m = 0.0;
        for offset in 0..reach {
            let sector = wrapped(first + offset, self.sectors());
            let normal = self.normals[sector];
            let along_m = motion.eccentricity_m.dot(normal);
            let into_bearing_m = along_m - self.clearance_m - self.bearing_m[sector];
            // Depths of the journal are never negative.
            if !(into_bearing_m > 0.0) {
                continue;
            }
            let journal = self.journal_jet(sector, &weights);
            let penetration_m = into_bearing_m - journal[0];
            if !(penetration_m > 0.0) {
                continue;
            }
            let tangent = normal.turned();
            let arm_m = motion.eccentricity_m.dot(tangent) - journal[1];
            let rate_m_s = motion.rate_m_s.dot(normal) + spin_i * arm_m + spin_j * journal[1];
            let elastic_n = stiffness_n_m * penetration_m;
            let force_n = elastic_n * (1.0 + damping_s_m * rate_m_s).max(0.0);
            let (sliding_m_s, arms_m) = self.sliding(motion, along_m, tangent);
            load.normal_on_journal_n -= normal * force_n;
            load.moments_n_m[0] -= force_n * arm_m;
            load.moments_n_m[1] -= force_n * journal[1];
            load.sum_n += force_n;
            load.sliding_w += force_n * sliding_m_s;
            load.path_w += force_n * sliding_m_s.abs();
            load.contact_loss_w += (force_n - elastic_n) * rate_m_s;
            load.stored_j += 0.5 * elastic_n * penetration_m;
            load.carrying += 1;
            if penetration_m > deepest_m {
                (deepest_m, load.deepest_rate_m_s) = (penetration_m, rate_m_s);
            }
            if has_friction {
                let friction_n = self.friction.force_n(sliding_m_s, force_n);
                load.on_journal_n += tangent * friction_n;
                load.moments_n_m[0] -= arms_m[0] * friction_n;
                load.moments_n_m[1] += arms_m[1] * friction_n;
                load.friction_loss_w -= friction_n * sliding_m_s;
            }
            show(&PressedSector { sector, force_n, sliding_m_s });
        }
        load.on_journal_n += load.normal_on_journal_n;
        load
    }

    /// v_s, m/s, and the arms of both surfaces, m, of a sector where e·n_s is `along_m`: the surfaces meet half way.
    fn sliding(&self, motion: &FoundationMotion, along_m: f64, tangent: Vec2<f64>) -> (f64, [f64; 2]) {
        let half_m = 0.5 * (along_m - self.clearance_m);
        let arms_m = [self.bearing_radius_m + half_m, self.bearing_radius_m - self.clearance_m - half_m];
        let [spin_i, spin_j] = motion.spins_rad_s;
        (motion.rate_m_s.dot(tangent) + arms_m[1] * spin_j - arms_m[0] * spin_i, arms_m)
    }

    /// The largest δ_s of `reach` sectors from `first` on, m, and its sector: of equal ones the first from zero on.
    fn deepest_of(&self, (first, reach): (usize, usize), eccentricity_m: Vec2<f64>, weights: &Weights) -> (f64, usize) {
        let (mut penetration_m, mut deepest) = (f64::NEG_INFINITY, 0);
        for offset in 0..reach {
            let sector = wrapped(first + offset, self.sectors());
            let into_bearing_m = eccentricity_m.dot(self.normals[sector]) - self.clearance_m - self.bearing_m[sector];
            // Depths of the journal are never negative.
            if into_bearing_m >= penetration_m {
                let own_m = into_bearing_m - self.journal_jet(sector, weights)[0];
                if own_m > penetration_m || (own_m == penetration_m && sector < deepest) {
                    (penetration_m, deepest) = (own_m, sector);
                }
            }
        }
        (penetration_m, deepest)
    }

    /// The sector with the largest δ_s, in contact or not.
    pub fn deepest(&self, motion: &FoundationMotion) -> DeepestSector {
        let weights = self.journal_weights(motion.turn_rad);
        // All sectors that may be pressed are in the window.
        let (mut penetration_m, mut deepest) =
            self.deepest_of(self.window(motion.eccentricity_m), motion.eccentricity_m, &weights);
        if !(penetration_m > 0.0) {
            (penetration_m, deepest) = self.deepest_of((0, self.sectors()), motion.eccentricity_m, &weights);
        }
        let normal = self.normals[deepest];
        let tangent = normal.turned();
        let [_, slope, bend] = self.journal_jet(deepest, &weights);
        let [spin_i, spin_j] = motion.spins_rad_s;
        let arm_m = motion.eccentricity_m.dot(tangent) - slope;
        DeepestSector {
            normal,
            // Not a number where the motion is none.
            penetration_m: if motion.eccentricity_m.x.is_nan() { f64::NAN } else { penetration_m },
            rate_m_s: motion.rate_m_s.dot(normal) + spin_i * arm_m + spin_j * slope,
            sliding_m_s: self.sliding(motion, motion.eccentricity_m.dot(normal), tangent).0,
            journal_slopes: [slope, bend],
        }
    }

    /// δ̈_s of that sector for ë as seen from the ground, in the axes of the bearing, m/s², and the rates of both spins, rad/s².
    pub fn penetration_acceleration_m_s2(
        &self,
        motion: &FoundationMotion,
        deepest: &DeepestSector,
        acceleration_m_s2: Vec2<f64>,
        [change_i, change_j]: [f64; 2],
    ) -> f64 {
        let (normal, tangent) = (deepest.normal, deepest.normal.turned());
        let [spin_i, spin_j] = motion.spins_rad_s;
        let [slope, bend] = deepest.journal_slopes;
        let across_m = motion.eccentricity_m.dot(tangent);
        acceleration_m_s2.dot(normal) + 2.0 * spin_i * motion.rate_m_s.dot(tangent) + change_i * across_m
            - spin_i * spin_i * motion.eccentricity_m.dot(normal)
            - bend * (spin_i - spin_j) * (spin_i - spin_j)
            - slope * (change_i - change_j)
    }

    /// Free gap c + H_i + H_j in the direction of each sector of the bearing with the journal turned by `turn_rad`, m.
    pub fn gaps_m(&self, turn_rad: f64) -> Vec<f64> {
        let weights = self.journal_weights(turn_rad);
        let gap = |sector: usize| self.clearance_m + self.bearing_m[sector] + self.journal_jet(sector, &weights)[0];
        (0..self.sectors()).map(gap).collect()
    }

    /// Smallest and largest distance that the journal's centre can go from the bearing's, m: in each direction u the least of
    /// c(ψ_s)/cos(ψ_s - u) over the sectors in front.
    pub fn effective_clearances_m(&self, turn_rad: f64) -> [f64; 2] {
        let gaps_m = self.gaps_m(turn_rad);
        let count = self.sectors();
        let least_m = gaps_m.iter().copied().fold(f64::INFINITY, f64::min);
        let reach_m = |(sector, direction): (usize, &Vec2<f64>)| {
            let mut reach_m = gaps_m[sector];
            for offset in 1..count.div_ceil(4) {
                let cosine = direction.dot(self.normals[(sector + offset) % count]);
                // No gap further away is as narrow as to count.
                if cosine * reach_m <= least_m {
                    break;
                }
                let beside_m = gaps_m[(sector + offset) % count].min(gaps_m[(sector + count - offset) % count]);
                reach_m = reach_m.min(beside_m / cosine);
            }
            reach_m
        };
        let reaches_m = self.normals.iter().enumerate().map(reach_m);
        reaches_m.fold([f64::INFINITY, 0.0], |[low, high], own_m| [low.min(own_m), high.max(own_m)])
    }

    /// Distances over all angles of the bearing from the journal between two, rad: every second sector, and no closer than 2°, of one turn
    /// at most.
    pub fn clearances_within_m(&self, [least_rad, most_rad]: [f64; 2]) -> [f64; 2] {
        if !(least_rad < most_rad) || self.profiles[1].is_unworn() {
            let turn_rad = if least_rad.is_finite() { least_rad } else { 0.0 };
            return self.effective_clearances_m(turn_rad);
        }
        let span_rad = (most_rad - least_rad).min(TAU);
        let step_rad = (2.0 * TAU / self.sectors() as f64).max(CLOSEST_RAD);
        let steps = (span_rad / step_rad).ceil().max(1.0) as usize;
        let ranges_m = (0..=steps).map(|k| least_rad + span_rad * k as f64 / steps as f64);
        ranges_m
            .map(|turn_rad| self.effective_clearances_m(turn_rad))
            .fold([f64::INFINITY, 0.0], |[low, high]: [f64; 2], own_m| [low.min(own_m[0]), high.max(own_m[1])])
    }
}

#[cfg(test)]
mod tests;

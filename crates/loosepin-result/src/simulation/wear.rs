//! Wear of the joints of a run.

use loosepin_text::units::extended;
use serde::{Deserialize, Serialize};

/// Wear of a joint after all cycles by Archard's law, with the unworn geometry: V = N k W.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct JointWearRecord {
    /// Name of the joint.
    pub joint: String,
    /// Cycles N; a cycle is the recorded part of the run.
    #[serde(with = "extended")]
    pub cycles: f64,
    /// Friction path W = ∫F_N |v_T| dt of a cycle, J.
    #[serde(with = "extended")]
    pub friction_path_j: f64,
    /// Radial clearance.
    #[serde(with = "extended")]
    pub radial_clearance_m: f64,
    /// The surfaces that wear: bearing, journal.
    pub surfaces: Vec<SurfaceWear>,
    /// The run's own checks.
    pub checks: WearChecks,
}

/// Wear of one surface after all cycles.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SurfaceWear {
    /// Which surface.
    pub surface: WornSurface,
    /// Wear coefficient k, m²/N.
    #[serde(with = "extended")]
    pub coefficient_m2_n: f64,
    /// Worn volume V = N k W, m³.
    #[serde(with = "extended")]
    pub volume_m3: f64,
    /// Greatest depth among the sectors.
    #[serde(with = "extended")]
    pub greatest_depth_m: f64,
    /// The sector of the greatest depth.
    pub deepest_sector: usize,
    /// Mean depth of each sector. Sector s of n reaches from 360°·s/n to 360°·(s + 1)/n, from the x axis of the body with the surface.
    #[serde(with = "extended")]
    pub depth_m: Vec<f64>,
    /// Sum of the volumes of all sectors over the volume that was distributed over them, less one; how that differs from the worn volume
    /// stands in [`WearChecks::path_error`].
    #[serde(with = "extended")]
    pub sum_of_sectors_error: f64,
    /// Greatest depth with half as many sectors; absent where their number is odd.
    #[serde(with = "extended")]
    pub coarse_greatest_depth_m: Option<f64>,
}

/// A surface of a revolute joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum WornSurface {
    /// The hole.
    Bearing,
    /// The pin.
    Journal,
}

/// Checks that a run makes of its wear.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct WearChecks {
    /// Friction path of a cycle summed over sectors, over that integrated with the motion, less one; absent for an ideal joint, whose
    /// friction path is the sum.
    #[serde(with = "extended")]
    pub path_error: Option<f64>,
    /// Width of the widest patch of pressure in sectors of the bearing; zero where the pressure is in one sector.
    #[serde(with = "extended")]
    pub widest_patch_sectors: f64,
    /// Share of the friction path under forces whose patch was cut to half the circumference.
    #[serde(with = "extended")]
    pub capped_share: f64,
    /// Greatest depths of bearing and journal together, over the radial clearance; infinite without clearance.
    #[serde(with = "extended")]
    pub depth_over_clearance: f64,
}

impl WornSurface {
    /// Its name.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Bearing => "bearing",
            Self::Journal => "journal",
        }
    }
}

impl SurfaceWear {
    /// Both ends of the sector of the greatest depth, rad.
    pub fn deepest_rad(&self) -> [f64; 2] {
        let width_rad = std::f64::consts::TAU / self.depth_m.len() as f64;
        [self.deepest_sector as f64 * width_rad, (self.deepest_sector + 1) as f64 * width_rad]
    }
}

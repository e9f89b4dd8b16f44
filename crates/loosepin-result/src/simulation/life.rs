//! Wear over the cycles of a life in which the worn shape acts back.

use super::wear::WornSurface;
use loosepin_text::units::{SiUnit, extended};
use serde::{Deserialize, Serialize};

/// Wear over the cycles of a life, at the ends of its jumps.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WearLifeRecord {
    /// Cycles, from zero to all.
    #[serde(with = "extended")]
    pub cycles: Vec<f64>,
    /// The joints that wear, in the order of [`super::SimulationRecord::wear`].
    pub joints: Vec<JointLifeRecord>,
    /// Deviations of the outputs.
    pub outputs: Vec<OutputLifeRecord>,
    /// How long a limit is met, where one is given.
    pub limit: Option<LifeLimitRecord>,
    /// Cycles that were run.
    pub runs: usize,
    /// Largest error of a jump in a depth: half of the jump times the change of the growth over it.
    #[serde(with = "extended")]
    pub largest_error_m: f64,
    /// Largest part of a jump in a depth by which turns differ, as a standard error; zero of one recorded turn.
    #[serde(with = "extended")]
    pub largest_noise_m: f64,
    /// Longest jump over the cycles N_s up to which jumps are stable there.
    #[serde(with = "extended")]
    pub longest_over_stable: f64,
}

/// A joint over the cycles of a life.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct JointLifeRecord {
    /// Name of the joint.
    pub joint: String,
    /// Friction path of the cycle there, J.
    #[serde(with = "extended")]
    pub friction_path_j: Vec<f64>,
    /// Smallest and largest distance that the journal can go from the bearing's centre.
    #[serde(with = "extended")]
    pub least_clearance_m: Vec<f64>,
    /// The largest.
    #[serde(with = "extended")]
    pub largest_clearance_m: Vec<f64>,
    /// The surfaces that wear.
    pub surfaces: Vec<SurfaceLifeRecord>,
}

/// A surface over the cycles of a life.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SurfaceLifeRecord {
    /// Which surface.
    pub surface: WornSurface,
    /// Worn volume.
    #[serde(with = "extended")]
    pub volume_m3: Vec<f64>,
    /// Greatest depth among the sectors.
    #[serde(with = "extended")]
    pub greatest_depth_m: Vec<f64>,
    /// Depths of all sectors.
    #[serde(with = "extended")]
    pub depth_m: Vec<Vec<f64>>,
    /// Volume after all cycles if all were as the first one.
    #[serde(with = "extended")]
    pub first_order_volume_m3: f64,
    /// Greatest depth in that case.
    #[serde(with = "extended")]
    pub first_order_depth_m: f64,
}

/// An output over the cycles of a life.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct OutputLifeRecord {
    /// Name of the output.
    pub name: String,
    /// Unit of its values.
    pub unit: SiUnit,
    /// Largest deviation from the ideal motion in the cycle, in either direction.
    #[serde(with = "extended")]
    pub deviation_si: Vec<f64>,
}

/// How long the deviation of an output stays within its limit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LifeLimitRecord {
    /// Name of the output.
    pub output: String,
    /// Unit of its values.
    pub unit: SiUnit,
    /// The limit.
    #[serde(with = "extended")]
    pub limit_si: f64,
    /// Cycles until it is passed, by a straight line between two jumps; absent where it never is.
    #[serde(with = "extended")]
    pub cycles: Option<f64>,
    /// The two jumps.
    #[serde(with = "extended")]
    pub between: Option<[f64; 2]>,
}

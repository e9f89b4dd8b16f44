//! What the ideal motion and the quasi-static answer leave behind for pages, tables and files: plain data in SI.

use crate::repeat::Repeat;
use serde::{Deserialize, Serialize};

use crate::simulation::{Drawing, Override};
use crate::study::PathError;
use loosepin_text::units::{DisplayUnits, SiUnit, extended};

/// The ideal motion over one cycle and the quasi-static effect of the clearances: no dynamics.
///
/// All histories have one entry per element of `drive_angle_rad`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MotionRecord {
    /// Name of the model.
    pub model: String,
    /// Version of the program that made the record, `major.minor.patch`.
    pub version: String,
    /// Quantities that were set on the command line, in that order.
    pub overrides: Vec<Override>,
    /// How it is made again; empty in records of older versions.
    #[serde(default, skip_serializing_if = "Repeat::is_empty")]
    pub repeat: Repeat,
    /// Name of the drive whose angle is the input.
    pub drive: String,
    /// Speed of the drive, to which velocities and accelerations belong, where it is constant.
    #[serde(with = "extended")]
    pub drive_speed_rad_s: Option<f64>,
    /// The mobility in words, for example `1 degree of freedom, 1 drive`.
    pub mobility: String,
    /// Positions at which the ideal mechanism is singular, or nearly so.
    pub singular_positions: Vec<SingularPosition>,
    /// Joints whose block may reach over an end of its guide. The quasi-static answer takes it as held over its whole length.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub guide_overhangs: Vec<GuideOverhang>,
    /// Units that pages and tables use.
    pub display_units: DisplayUnits,
    /// Angle of the drive over one cycle, increasing.
    #[serde(with = "extended")]
    pub drive_angle_rad: Vec<f64>,
    /// One entry per position or angle among the outputs, in file order; behind the coordinates of a path its error along and across
    /// it, where its point never stands still.
    pub outputs: Vec<OutputMotion>,
    /// One entry per torque, force or power of a drive among the outputs, in file order.
    #[serde(default)]
    pub efforts: Vec<EffortMotion>,
    /// The mechanism and its ideal poses.
    pub drawing: Drawing,
}

/// A position where the mechanism cannot transmit motion.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SingularPosition {
    /// Angle of the drive.
    #[serde(with = "extended")]
    pub drive_angle_rad: f64,
    /// What happens there, in words.
    pub words: String,
}

/// A block that may reach over an end of its guide.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct GuideOverhang {
    /// Name of the joint.
    pub joint: String,
    /// Angles of the drive, from and to, between which each recorded position overhangs.
    #[serde(with = "extended")]
    pub spans_rad: Vec<[f64; 2]>,
}

/// Ideal motion of one output and what clearance does to it quasi-statically.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct OutputMotion {
    /// Name of the output.
    pub name: String,
    /// What it is in words, for example `x of slider.pin`.
    pub words: String,
    /// Unit of the values.
    pub unit: SiUnit,
    /// The path and which part of its error, where it is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub path_error: Option<PathMotion>,
    /// Ideal value; empty for an error of a path, as velocity and acceleration are then.
    #[serde(with = "extended")]
    pub value_si: Vec<f64>,
    /// Its time derivative at the speed of the drive.
    #[serde(with = "extended")]
    pub velocity_si: Vec<f64>,
    /// Its second time derivative at the speed of the drive.
    #[serde(with = "extended")]
    pub acceleration_si: Vec<f64>,
    /// The clearance answer.
    pub clearance: ClearanceAnswer,
    /// Standard deviation from the scatter of the dimensions (root of the sum of squares), where a study names
    /// distributions; empty otherwise.
    #[serde(with = "extended")]
    pub dimensional_standard_deviation_si: Vec<f64>,
    /// Shares of each scattering dimension in that variance; empty where there is none.
    pub dimensional_contributors: Vec<DimensionContributor>,
}

/// A path, and the part of its error that is meant.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PathMotion {
    /// Name of the output that is the path.
    pub path: String,
    /// The part.
    pub part: PathError,
}

/// What a drive must do to make the ideal motion at its speed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct EffortMotion {
    /// Name of the output.
    pub name: String,
    /// What it is in words, for example `torque of drive crank`.
    pub words: String,
    /// Unit of the values.
    pub unit: SiUnit,
    /// Its value.
    #[serde(with = "extended")]
    pub value_si: Vec<f64>,
}

/// Quasi-static effect of all clearances on one output, to first order in the clearances.
///
/// Each eccentricity e_k lies in the disc |e_k| <= c_k and moves the output by g_k·e_k. Worst case: sum c_k |g_k|;
/// uniform in the disc: variance sum c_k² |g_k|²/4; on the rim with uniform direction: sum c_k² |g_k|²/2.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct ClearanceAnswer {
    /// Worst case: the output lies within plus and minus this.
    #[serde(with = "extended")]
    pub worst_case_si: Vec<f64>,
    /// Standard deviation when the journals are anywhere in their discs.
    #[serde(with = "extended")]
    pub disc_standard_deviation_si: Vec<f64>,
    /// Standard deviation when the journals are on the rims.
    #[serde(with = "extended")]
    pub rim_standard_deviation_si: Vec<f64>,
    /// What each joint contributes.
    pub contributors: Vec<JointContributor>,
}

/// What one clearance joint contributes to the worst case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct JointContributor {
    /// Name of the joint.
    pub joint: String,
    /// Radial clearance c_k.
    #[serde(with = "extended")]
    pub radial_clearance_m: f64,
    /// c_k |g_k| over the cycle.
    #[serde(with = "extended")]
    pub worst_case_si: Vec<f64>,
}

/// Share of one scattering dimension.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DimensionContributor {
    /// Path of the quantity.
    pub path: String,
    /// |derivative of the output| times the standard deviation of the quantity, over the cycle.
    #[serde(with = "extended")]
    pub standard_deviation_si: Vec<f64>,
}

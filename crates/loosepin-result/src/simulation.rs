//! Record of one run for pages, tables and files: plain data in SI, no physics.

mod control;
mod drawing;
mod drawn_joint;
mod end_state;
mod life;
mod measured;
mod motion_kind;
mod run_path;
mod spectrum;
mod trust;
mod wear;

use crate::contact_basis::{ContactBasis, LongPinForce};
use crate::repeat::Repeat;
use crate::study::accuracy::is_zero_count;
pub use control::{ControlHistory, ErrorOscillation, OscillationTrend};
pub use drawing::{
    Drawing, DrawnBeam, DrawnBody, DrawnDrive, DrawnJoint, DrawnOutput, DrawnPoint, DriveSense, JournalOrbit,
    PointReference, PoseTable,
};
pub use drawn_joint::{DrawnJointKind, DrawnPin};
pub use end_state::EndState;
pub use life::{JointLifeRecord, LifeLimitRecord, OutputLifeRecord, SurfaceLifeRecord, WearLifeRecord};
use loosepin_terms::Deviation;
pub use measured::{Abscissa, MeasuredCurve};
pub use motion_kind::{LyapunovRecord, MotionKind, NeighbourKind, REPEAT_SHARE, SectionedOutput};
pub use run_path::RunPath;
use serde::{Deserialize, Serialize};
pub use spectrum::Spectrum;
pub use trust::{MeasuredTrust, Trust, TrustHorizon};
pub use wear::{JointWearRecord, SurfaceWear, WearChecks, WornSurface};

use loosepin_text::units::{DisplayUnits, SiUnit, extended};

/// One dynamic run, complete: histories, impacts, joints, energy, counters, and what a page draws.
///
/// All histories have one entry per element of `time_s`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SimulationRecord {
    /// Name of the model.
    pub model: String,
    /// Version of the program that made the record, `major.minor.patch`.
    pub version: String,
    /// Quantities that were set on the command line, in that order.
    pub overrides: Vec<Override>,
    /// How the run was made.
    pub settings: SimulationSettings,
    /// Why the run ended.
    pub stop: StopReason,
    /// How it is made again; empty in records of older versions.
    #[serde(default, skip_serializing_if = "Repeat::is_empty")]
    pub repeat: Repeat,
    /// Counters of the integration.
    pub counters: RunCounters,
    /// Smallest and largest value of each output and of each deviation.
    pub extremes: Vec<Extreme>,
    /// One entry per clearance joint.
    pub joints: Vec<JointSummary>,
    /// Whether the recorded turns repeat each other; absent for a mechanism that follows its drives alone, and for less than
    /// two whole turns.
    #[serde(default)]
    pub kind: Option<MotionKind>,
    /// The largest Lyapunov exponent, where it was asked for.
    #[serde(default)]
    pub lyapunov: Option<LyapunovRecord>,
    /// How long its positions can be trusted.
    #[serde(default)]
    pub trust: Trust,
    /// The energy account at the end, and its history.
    pub energy: EnergyAccount,
    /// Units that pages and tables use.
    pub display_units: DisplayUnits,
    /// Sample times, increasing.
    #[serde(with = "extended")]
    pub time_s: Vec<f64>,
    /// Angle of the drive at the sample times, continuous over turns.
    #[serde(with = "extended")]
    pub drive_angle_rad: Vec<f64>,
    /// The outputs in file order.
    pub outputs: Vec<OutputHistory>,
    /// Paths of points among the outputs; empty in records of older versions.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub paths: Vec<RunPath>,
    /// Normal contact force of each clearance joint at the sample times. Peaks between samples stand in `impacts`.
    pub contact_forces: Vec<ContactForceHistory>,
    /// How controls followed their references; empty, and not written, where there are none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub controls: Vec<ControlHistory>,
    /// Every impact in the order of time.
    pub impacts: Vec<ImpactRecord>,
    /// Path of each journal in its bearing.
    pub orbits: Vec<JournalOrbit>,
    /// Whether pins with play lean out of the plane, which runs do not know.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub leans: bool,
    /// The mechanism and its poses.
    pub drawing: Drawing,
    /// How much of the quasi-static worst case the positions of the run use, by position output. Empty until the check was
    /// made, and for a mechanism without play.
    pub quasi_static_check: Vec<QuasiStaticShare>,
    /// Measured curves laid over the outputs; empty, and not written, where none were given.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub measured: Vec<MeasuredCurve>,
    /// Wear of the joints that wear; empty, and not written, where there are none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub wear: Vec<JointWearRecord>,
    /// Wear over the cycles, where the worn shape acts back.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub life: Option<WearLifeRecord>,
    /// How far flexible bodies bend; empty, and not written, where there are none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub bending: Vec<BendingRecord>,
    /// State at the end, from which another run can continue; absent where the run failed, and in records of older versions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub end_state: Option<EndState>,
}

/// How far a flexible body bends.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BendingRecord {
    /// Name of the body.
    pub body: String,
    /// Largest angle of the section at either end from the frame of the body.
    #[serde(with = "extended")]
    pub largest_angle_rad: f64,
    /// Whether it starts bent and stretched as inertia and loads hold it; else undeformed.
    #[serde(default)]
    pub starts_settled: bool,
    /// Whether it is described in absolute nodal coordinates; the angle is then that of any node from the way from root to tip.
    #[serde(default)]
    pub is_nodal: bool,
    /// Demands of the other formulation.
    #[serde(default)]
    pub other_formulation: OtherFormulation,
    /// Its condensed shapes; absent, and not written, where none may be condensed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub condensed: Option<CondensedRecord>,
}

/// Changes with which a flexible body can have the other formulation: absolute nodal coordinates in place of a floating frame, or the reverse.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum OtherFormulation {
    /// None but for its own keys.
    #[default]
    AsItIs,
    /// A retardation time in place of the damping ratio.
    RetardationTime,
    /// Neither lumps nor points between the ends, and no damping ratio.
    EndsAlone,
    /// A tangent frame: a drive or a rigid joint holds it at `from`.
    TangentFrame,
    /// No drive and no rigid joint at `to`.
    FreeAtTo,
}

impl OtherFormulation {
    /// Keys with which a body in absolute nodal coordinates can have a floating frame; `None` if it can have none.
    pub fn floating_frame(self) -> Option<&'static str> {
        match self {
            Self::FreeAtTo => None,
            Self::TangentFrame => Some("formulation = \"floating-frame\" with frame = \"tangent\""),
            Self::AsItIs | Self::RetardationTime | Self::EndsAlone => Some("formulation = \"floating-frame\""),
        }
    }
}

/// Condensed shapes of a flexible body: they keep their static flexibility.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct CondensedRecord {
    /// Number of shapes.
    pub shapes: usize,
    /// The frequency above which they are, and which they have instead.
    #[serde(with = "extended")]
    pub above_hz: f64,
}

/// The run's own check of one position output: a journal within its clearance and the largest penetration of the run cannot
/// move the output beyond the worst case of the exact loops.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct QuasiStaticShare {
    /// Name of the output.
    pub output: String,
    /// Unit of its values.
    pub unit: SiUnit,
    /// Largest deviation over worst case among the samples, 0 to 1 for a sound run.
    #[serde(with = "extended")]
    pub largest_share: f64,
    /// When; absent where no sample deviates.
    #[serde(with = "extended")]
    pub time_s: Option<f64>,
    /// The deviation there.
    #[serde(with = "extended")]
    pub deviation_si: f64,
    /// The worst case on the same side there, with the sign of the deviation.
    #[serde(with = "extended")]
    pub worst_case_si: f64,
    /// Whether a sample lies beyond its worst case by more than tolerance and round-off: then the run is wrong.
    pub is_exceeded: bool,
    /// Samples that could not be compared: a dead point lies within the clearances, or a slider overhangs an end of its guide, so that there is
    /// no worst case.
    pub samples_without_worst_case: usize,
}

/// A quantity of the model that replaces what the file says.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Override {
    /// Path in the model, for example `joint.gudgeon.radial_clearance`.
    pub path: String,
    /// The value as it was written, for example `0.3 mm`.
    pub written: String,
}

impl Override {
    /// The overrides of settings `path=value`.
    pub fn from_settings(settings: &[String]) -> Vec<Override> {
        let pairs = settings.iter().filter_map(|text| text.split_once('='));
        pairs.map(|(path, written)| Override { path: path.trim().into(), written: written.trim().into() }).collect()
    }
}

/// How a run was made.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SimulationSettings {
    /// Name of the drive whose angle is the input; `cycle` where it is the phase of the cycle.
    pub drive: String,
    /// Speed of the drive where it is constant.
    #[serde(with = "extended")]
    pub drive_speed_rad_s: Option<f64>,
    /// Time at which the run continued another one; absent for a run from the initial state of the model.
    #[serde(with = "extended", default, skip_serializing_if = "Option::is_none")]
    pub continued_at_s: Option<f64>,
    /// Turns that were run and thrown away.
    #[serde(with = "extended")]
    pub transient_turns: f64,
    /// Turns that were recorded.
    #[serde(with = "extended")]
    pub recorded_turns: f64,
    /// Samples per turn.
    pub samples_per_turn: usize,
    /// Position tolerance of the integration.
    #[serde(with = "extended")]
    pub tolerance_m: f64,
    /// Name of the integration method.
    pub method: String,
}

/// Why a run ended.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum StopReason {
    /// The run reached its end.
    Finished,
    /// The run failed.
    Failed {
        /// Short name that does not change, for example `step_below_minimum`.
        code: String,
        /// The reason in words, with numbers and units.
        words: String,
    },
}

/// Counters of one run. They repeat exactly, unlike times.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct RunCounters {
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejections: u64,
    /// Evaluations of the equations of motion.
    pub evaluations: u64,
    /// Factorizations of implicit steps, each of a real and of a complex matrix; not written where there are none.
    #[serde(default, skip_serializing_if = "is_zero_count")]
    pub factorizations: u64,
    /// Located onsets and ends of contact.
    pub contact_changes: u64,
}

/// The values of one output over time, and how far they are from the ideal motion.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct OutputHistory {
    /// Name of the output.
    pub name: String,
    /// Description, for example `x of slider.pin`.
    pub words: String,
    /// Unit of the values.
    pub unit: SiUnit,
    /// The joint whose force it is, as a magnitude; `None`, and not written, for any other quantity.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub magnitude_of_force_in: Option<String>,
    /// Actual values.
    #[serde(with = "extended")]
    pub value_si: Vec<f64>,
    /// Values of the ideal mechanism; empty where the ideal mechanism has no such output (a contact force).
    #[serde(with = "extended")]
    pub ideal_si: Vec<f64>,
    /// Actual minus ideal, computed before rounding; empty where there is no ideal value.
    #[serde(with = "extended")]
    pub deviation_si: Vec<f64>,
}

/// Normal contact force of one joint at the sample times.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ContactForceHistory {
    /// Name of the joint.
    pub joint: String,
    /// Normal force, 0 in free flight.
    #[serde(with = "extended")]
    pub force_n: Vec<f64>,
}

/// One impact: an onset of contact with an approach speed above the least impact speed of the law.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ImpactRecord {
    /// Time of the onset.
    #[serde(with = "extended")]
    pub time_s: f64,
    /// Angle of the drive at the onset.
    #[serde(with = "extended")]
    pub drive_angle_rad: f64,
    /// Name of the joint.
    pub joint: String,
    /// Approach speed at the onset.
    #[serde(with = "extended")]
    pub speed_m_s: f64,
    /// Time from onset to the end of contact.
    #[serde(with = "extended")]
    pub duration_s: f64,
    /// Largest normal force while the contact lasted.
    #[serde(with = "extended")]
    pub peak_force_n: f64,
    /// Speed at which the parts separated; absent when the run ended in contact.
    #[serde(with = "extended")]
    pub separation_speed_m_s: Option<f64>,
}

/// Summary of one clearance joint.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct JointSummary {
    /// Name of the joint.
    pub joint: String,
    /// Radial clearance of this run.
    #[serde(with = "extended")]
    pub radial_clearance_m: f64,
    /// Name of the contact law.
    pub law: String,
    /// Assumptions behind its force; absent in records of older versions.
    #[serde(default)]
    pub basis: Option<ContactBasis>,
    /// The largest force as a line-contact law would have it; absent beside other than point-contact laws of pins.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub long_pin: Option<LongPinForce>,
    /// Located onsets of contact, floored ones included.
    pub contacts: u64,
    /// Onsets above the least impact speed.
    pub impacts: u64,
    /// Impacts per turn of the drive, where it turns.
    #[serde(with = "extended")]
    pub impacts_per_turn: Option<f64>,
    /// Largest penetration.
    #[serde(with = "extended")]
    pub largest_penetration_m: f64,
    /// Largest normal force.
    #[serde(with = "extended")]
    pub peak_force_n: f64,
    /// Largest approach speed.
    #[serde(with = "extended")]
    pub largest_speed_m_s: f64,
    /// Coefficient of restitution as the file states it; absent for a law without one.
    #[serde(with = "extended")]
    pub nominal_restitution: Option<f64>,
    /// Coefficient of restitution that a free impact under this law delivers.
    #[serde(with = "extended")]
    pub delivered_restitution: Option<f64>,
    /// Share of the impacts outside the validity limit of the law, 0 to 1; absent where no limit is known.
    #[serde(with = "extended")]
    pub share_outside_validity: Option<f64>,
    /// Contacts that began more slowly than the least impact speed and were computed with that speed.
    pub floored_contacts: u64,
    /// Share of the time without contact, 0 to 1.
    #[serde(with = "extended")]
    pub flight_share: f64,
    /// Contacts that ended, a turn.
    #[serde(with = "extended")]
    pub losses_per_turn: f64,
}

/// Smallest and largest value of one quantity, located on the dense output and not read off samples.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Extreme {
    /// Name of the output.
    pub name: String,
    /// Whether the output itself or its deviation from the ideal motion is meant.
    #[serde(default = "Extreme::of_older_records")]
    pub of: Deviation,
    /// Unit of the values.
    pub unit: SiUnit,
    /// The smallest value.
    pub minimum: ExtremePoint,
    /// The largest value.
    pub maximum: ExtremePoint,
}

impl Extreme {
    /// Records of older versions do not say which are deviations.
    fn of_older_records() -> Deviation {
        Deviation::of_value()
    }
}

/// A value and where it was found.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ExtremePoint {
    /// The value.
    #[serde(with = "extended")]
    pub value_si: f64,
    /// Time.
    #[serde(with = "extended")]
    pub time_s: f64,
    /// Angle of the drive.
    #[serde(with = "extended")]
    pub drive_angle_rad: f64,
}

/// kinetic + potential + stored + lost = supplied + what was there at the start; the residual is the difference.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct EnergyAccount {
    /// Largest |residual| over the run divided by the largest energy exchanged: the run's own check.
    #[serde(with = "extended")]
    pub relative_residual: f64,
    /// Kinetic energy at the sample times.
    #[serde(with = "extended")]
    pub kinetic_j: Vec<f64>,
    /// Potential energy of gravity at the sample times.
    #[serde(with = "extended")]
    pub potential_j: Vec<f64>,
    /// Energy stored in contacts and springs at the sample times.
    #[serde(with = "extended")]
    pub stored_j: Vec<f64>,
    /// Energy lost in contacts up to the sample time.
    #[serde(with = "extended")]
    pub contact_loss_j: Vec<f64>,
    /// Energy lost in friction up to the sample time.
    #[serde(with = "extended")]
    pub friction_loss_j: Vec<f64>,
    /// Energy lost in dampers up to the sample time; empty, and not written, for a mechanism without dampers.
    #[serde(with = "extended", default, skip_serializing_if = "Vec::is_empty")]
    pub damping_loss_j: Vec<f64>,
    /// Work of drives and loads up to the sample time.
    #[serde(with = "extended")]
    pub supplied_j: Vec<f64>,
    /// Residual of the energy account at the sample times.
    #[serde(with = "extended")]
    pub residual_j: Vec<f64>,
}

//! Record of the ideal motion and the quasi-static answer for pages, tables and files: plain data in SI.

use std::f64::consts::TAU;

use crate::point_path::PointPath;
use crate::repeat::Repeat;
use crate::round_off::drop_round_off;
use serde::{Deserialize, Serialize};

use crate::kinematics::KinematicProperties;
use crate::simulation::{Drawing, Override};
use crate::spatial_picture::SpatialPicture;
use crate::study::PathError;
use loosepin_terms::Deviation;
use loosepin_text::units::{DisplayUnits, SiUnit, extended};

/// What is said of a motion that begins elsewhere than the file places its bodies.
pub const OTHER_START: &str = "the joints do not close from where bodies are placed at the start; of the positions found near there, this is the \
                               nearest; [assembly] guess says where bodies are";

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
    /// Name of the drive whose angle is the input, or `time`.
    pub drive: String,
    /// Speed of the drive, to which velocities and accelerations belong, where it is constant.
    #[serde(with = "extended")]
    pub drive_speed_rad_s: Option<f64>,
    /// The mobility in words, for example `1 degree of freedom, 1 drive`.
    pub mobility: String,
    /// Positions at which the ideal mechanism is singular, or nearly so.
    pub singular_positions: Vec<SingularPosition>,
    /// Classes of loops, swings, dead centres and transmission angles; empty in records of older versions.
    #[serde(default, skip_serializing_if = "KinematicProperties::is_empty")]
    pub kinematics: KinematicProperties,
    /// Joints whose block may reach over an end of its guide. The quasi-static answer takes it as held over its whole length.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub guide_overhangs: Vec<GuideOverhang>,
    /// Spans in which no end of the worst cases is proven, so that they are the largest found and no more.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub unproven_spans: Vec<UnprovenSpan>,
    /// Whether proven ends hold between the recorded angles too, not only at them.
    #[serde(default)]
    pub is_proven_between_angles: bool,
    /// What else is to be known of the motion, in sentences.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub remarks: Vec<String>,
    /// Units that pages and tables use.
    pub display_units: DisplayUnits,
    /// Angle of the drive over one cycle, increasing.
    #[serde(with = "extended")]
    pub drive_angle_rad: Vec<f64>,
    /// Time where it is the input, and the angle above the phase of the cycle; empty where a drive turns.
    #[serde(default, with = "extended", skip_serializing_if = "Vec::is_empty")]
    pub time_s: Vec<f64>,
    /// One entry per position or angle among the outputs, in file order; behind the coordinates of a path its error along and across
    /// it, where its point never stands still.
    pub outputs: Vec<OutputMotion>,
    /// Paths of points with the zones about them: of each output that is a path, in file order, then of further points that were asked for.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub paths: Vec<PointPath>,
    /// One entry per torque, force or power of a drive among the outputs, in file order.
    #[serde(default)]
    pub efforts: Vec<EffortMotion>,
    /// The requirements of the study, judged without dynamics, in file order; one for each pose.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub requirements: Vec<MotionRequirement>,
    /// Tolerances that the study may loosen, judged without dynamics, in file order.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub allowances: Vec<MotionAllowance>,
    /// What play and scatter do at the poses that the study asks about: those of requirements first, then those of questions.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub asked: Vec<PoseEffect>,
    /// The mechanism and its ideal poses in a plane; empty where `picture` has them.
    #[serde(default, skip_serializing_if = "Drawing::is_empty")]
    pub drawing: Drawing,
    /// The mechanism and its ideal poses in space; empty where `drawing` has them.
    #[serde(default, skip_serializing_if = "SpatialPicture::is_empty")]
    pub picture: SpatialPicture,
}

/// A requirement of a study, judged without dynamics: by the play at its worst and all parts within their limits.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MotionRequirement {
    /// Name of the output.
    pub output: String,
    /// Its unit.
    pub unit: SiUnit,
    /// Which deviation.
    pub of: Deviation,
    /// The pose, an angle of the drive; absent where the limit holds over the cycle.
    #[serde(default, with = "extended", skip_serializing_if = "Option::is_none")]
    pub pose_rad: Option<f64>,
    /// Least allowed value; minus infinity where there is none.
    #[serde(with = "extended")]
    pub lower_si: f64,
    /// Largest allowed value; infinity where there is none.
    #[serde(with = "extended")]
    pub upper_si: f64,
    /// The least share of mechanisms that must keep the limits.
    #[serde(with = "extended")]
    pub probability_at_least: f64,
    /// The least share of mechanisms of which all parts lie within the limits that they are taken to.
    #[serde(with = "extended")]
    pub share_within_limits: f64,
    /// Ends that nothing passes; infinite where nothing is proven.
    #[serde(with = "extended")]
    pub proven_si: [f64; 2],
    /// The lowest and the highest that were found.
    #[serde(with = "extended")]
    pub found_si: [f64; 2],
    /// Angles of the drive at which they were found.
    #[serde(with = "extended")]
    pub found_at_rad: [f64; 2],
    /// The verdict.
    pub verdict: MotionVerdict,
    /// Why there is none, in words.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
}

/// The verdict on a requirement without dynamics.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum MotionVerdict {
    /// The proven ends keep the limit, in a large enough share of mechanisms.
    Met,
    /// Play and parts within their limits break it.
    NotMetInTheWorstCase,
    /// The limit lies between the found and the proven value, or too few mechanisms lie within the limits of the parts.
    Undecided,
    /// The requirement cannot be judged without dynamics.
    NeedsDynamics,
}

/// How far an input may be loosened so that every requirement that can be judged without dynamics is still met there.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MotionAllowance {
    /// Path of the input.
    pub path: String,
    /// Its unit.
    pub unit: SiUnit,
    /// The largest value that was asked about.
    #[serde(with = "extended")]
    pub up_to_si: f64,
    /// The loosest value that was tried and is met; absent where none is.
    #[serde(default, with = "extended", skip_serializing_if = "Option::is_none")]
    pub loosest_si: Option<f64>,
    /// The fit of that value, where fits were asked about.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fit: Option<String>,
    /// Why it was not judged, in words.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
}

/// What play and scatter do to an output, to first order, at a pose that a study asks about.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PoseEffect {
    /// Name of the output.
    pub output: String,
    /// The pose as it was asked for: an angle of the drive.
    #[serde(with = "extended")]
    pub pose_rad: f64,
    /// Whether a requirement names the pose, not a question alone.
    pub is_required: bool,
    /// Sum of the first-order effects of all joints; not a number where it is not known.
    #[serde(with = "extended")]
    pub first_order_si: f64,
    /// That of each joint with play, in their order; empty where it is not known.
    pub joints: Vec<NamedEffect>,
    /// Standard deviation from the scatter of the dimensions, correlations included; 0 where none scatters.
    #[serde(with = "extended")]
    pub standard_deviation_si: f64,
    /// That of each dimension alone.
    pub dimensions: Vec<NamedEffect>,
}

/// The effect of one joint or one dimension.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct NamedEffect {
    /// Name of the joint, or path of the dimension.
    pub name: String,
    /// Its effect, >= 0.
    #[serde(with = "extended")]
    pub value_si: f64,
}

/// A position where the mechanism cannot transmit motion.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SingularPosition {
    /// Angle of the drive.
    #[serde(with = "extended")]
    pub drive_angle_rad: f64,
    /// Description of the position in words.
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
    /// Description, for example `x of slider.pin`.
    pub words: String,
    /// Unit of the values.
    pub unit: SiUnit,
    /// Name of the output that is the path, where it is a coordinate of one; absent in records of older versions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coordinate_of: Option<String>,
    /// The path and which part of its error, where it is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub path_error: Option<PathMotion>,
    /// Ideal value; empty for an error of a path, as velocity and acceleration are then, and for the displacement of a point and the rotation
    /// of a body, which are no numbers. Effects on these are lengths and angles: of the longest displacement, of the largest rotation.
    #[serde(with = "extended")]
    pub value_si: Vec<f64>,
    /// Its time derivative at the speed of the drive; empty where it is not known.
    #[serde(with = "extended")]
    pub velocity_si: Vec<f64>,
    /// Its second time derivative at the speed of the drive; empty where it is not known.
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

/// Effort of a drive for the ideal motion at its speed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct EffortMotion {
    /// Name of the output.
    pub name: String,
    /// Description, for example `torque of drive crank`.
    pub words: String,
    /// Unit of the values.
    pub unit: SiUnit,
    /// Its value.
    #[serde(with = "extended")]
    pub value_si: Vec<f64>,
}

/// Quasi-static effect of all clearances on one output.
///
/// Each eccentricity e_k lies in the disc |e_k| <= c_k and to first order moves the output by g_k·e_k: at most by sum c_k |g_k|;
/// uniform in the disc: variance sum c_k² |g_k|²/4; on the rim with uniform direction: sum c_k² |g_k|²/2. The worst case is that of the
/// loops themselves, not of their first order. Where plays must meet conditions together, in space, and where pins lean, the first order is the
/// largest over all places that the loops allow, and `searched` stands in place of the worst case at every position.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct ClearanceAnswer {
    /// Sum of the first-order effects of all joints: a preview of the worst case, which may be larger.
    #[serde(with = "extended", default)]
    pub first_order_si: Vec<f64>,
    /// The same with pins that do not lean; empty where pins do not lean anyway.
    #[serde(with = "extended", default, skip_serializing_if = "Vec::is_empty")]
    pub held_first_order_si: Vec<f64>,
    /// The largest magnitude of the deviation that was found; empty in previews.
    #[serde(with = "extended", default)]
    pub worst_case_si: Vec<f64>,
    /// The lowest deviation that was found, <= 0; empty in previews.
    #[serde(with = "extended", default)]
    pub lowest_si: Vec<f64>,
    /// The highest deviation that was found, >= 0; empty in previews.
    #[serde(with = "extended", default)]
    pub highest_si: Vec<f64>,
    /// A proven end: no play makes a deviation below it; minus infinity where nothing is proven. Empty in previews.
    #[serde(with = "extended", default)]
    pub proven_lowest_si: Vec<f64>,
    /// A proven end: no play makes a deviation above it; infinite where nothing is proven. Empty in previews.
    #[serde(with = "extended", default)]
    pub proven_highest_si: Vec<f64>,
    /// Positions of the joints in the worst case over the cycle; absent in previews and where play moves nothing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub witness: Option<WorstCaseWitness>,
    /// Searches at single positions, where there is none at all of them (in space, and in the plane where plays must meet conditions together): where the first-order sum is largest; then, if play comes near a dead
    /// centre there, where it is largest of the positions in which play comes near none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub searched: Vec<SearchedPosition>,
    /// Standard deviation when the journals are anywhere in their discs; empty where there is no closed form.
    #[serde(with = "extended")]
    pub disc_standard_deviation_si: Vec<f64>,
    /// Standard deviation when the journals are on the rims; empty where there is no closed form.
    #[serde(with = "extended")]
    pub rim_standard_deviation_si: Vec<f64>,
    /// Contribution of each joint; without effects where nothing is known of play.
    pub contributors: Vec<JointContributor>,
}

/// Deviations of an output that a search found at one position, with the loops closed exactly; of a displacement along the longest one of
/// first order, of a rotation about the axis of the largest one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SearchedPosition {
    /// Number of the position.
    pub position: usize,
    /// The lowest and the highest deviation.
    #[serde(with = "extended")]
    pub found_si: [f64; 2],
    /// Ends that no deviation passes; infinite where nothing is proven, absent where none was sought.
    #[serde(default, with = "extended", skip_serializing_if = "Option::is_none")]
    pub proven_si: Option<[f64; 2]>,
    /// Conditions that the plays must meet together so that the loops close.
    pub conditions: usize,
}

/// Positions of the joints with play at the largest deviation of an output.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WorstCaseWitness {
    /// Angle of the drive.
    #[serde(with = "extended")]
    pub drive_angle_rad: f64,
    /// The deviation there, with its sign.
    #[serde(with = "extended")]
    pub deviation_si: f64,
    /// The joints, in their order.
    pub joints: Vec<WitnessJoint>,
}

/// Position of one joint with play in a worst case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WitnessJoint {
    /// Name of the joint.
    pub joint: String,
    /// Eccentricity (x, y) of a journal, m; ordinate, m, and angle, rad, of a slider in its guide; ordinate of a pin in a slot, or length
    /// by which a coupling deviates, m, and zero.
    #[serde(with = "extended")]
    pub displacement_si: [f64; 2],
}

/// Angles of the drive at which no end of the worst case is proven.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct UnprovenSpan {
    /// From and to.
    #[serde(with = "extended")]
    pub span_rad: [f64; 2],
    /// Why, in words.
    pub words: String,
    /// Whether play was found to take the mechanism to a dead centre there: what was found is then the largest in both assemblies.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub reaches_dead_centre: bool,
}

/// Contribution of one clearance joint to the first-order sum.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct JointContributor {
    /// Name of the joint.
    pub joint: String,
    /// Radial clearance c_k.
    #[serde(with = "extended")]
    pub radial_clearance_m: f64,
    /// c_k |g_k| over the cycle: its part of the first-order sum.
    #[serde(with = "extended")]
    pub first_order_si: Vec<f64>,
    /// The largest effect of an offset of the journal without a lean, over the cycle. Both share the clearance: with the next it adds up to more
    /// than the part. Empty in the plane, where a journal has no other freedom; 0 in space where it has none.
    #[serde(default, with = "extended", skip_serializing_if = "Vec::is_empty")]
    pub offset_si: Vec<f64>,
    /// The largest effect of a lean of the journal without an offset; empty where it cannot lean.
    #[serde(default, with = "extended", skip_serializing_if = "Vec::is_empty")]
    pub lean_si: Vec<f64>,
    /// The effect of the axial clearance; empty where there is none.
    #[serde(default, with = "extended", skip_serializing_if = "Vec::is_empty")]
    pub axial_si: Vec<f64>,
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

impl MotionRecord {
    /// The poses at which an output is asked about, those of requirements first.
    pub fn asked_of<'r>(&'r self, output: &'r str) -> impl Iterator<Item = &'r PoseEffect> {
        self.asked.iter().filter(move |asked| asked.output == output)
    }

    /// The time at an angle; `None` where the angle of a drive is the input.
    pub fn time_at_s(&self, angle_rad: f64) -> Option<f64> {
        let ([from_s, .., to_s], [from_rad, .., to_rad]) = (&self.time_s[..], &self.drive_angle_rad[..]) else {
            return None;
        };
        Some(from_s + (to_s - from_s) * (angle_rad - from_rad) / (to_rad - from_rad))
    }

    /// Number of the position with this angle.
    pub fn position_at(&self, angle_rad: f64) -> Option<usize> {
        self.drive_angle_rad.iter().position(|angle| *angle == angle_rad)
    }

    /// Whether the record holds one whole turn of the drive.
    pub fn is_whole_turn(&self) -> bool {
        const ROUND_OFF: f64 = 1e-9;
        match self.drive_angle_rad[..] {
            [first, .., last] => ((last - first) / TAU - 1.0).abs() < ROUND_OFF,
            _ => false,
        }
    }
}

impl ClearanceAnswer {
    /// Leaves of the answer which joints have play: nothing is known of what it does.
    pub fn forget(&mut self) {
        let joints = std::mem::take(&mut self.contributors).into_iter().map(|own| JointContributor {
            joint: own.joint,
            radial_clearance_m: own.radial_clearance_m,
            ..JointContributor::default()
        });
        *self = Self { contributors: joints.collect(), ..Self::default() };
    }

    /// Whether joints have play, and nothing is known of what it does.
    pub fn is_forgotten(&self) -> bool {
        let has_numbers = !(self.first_order_si.is_empty() && self.worst_case_si.is_empty());
        !has_numbers && self.contributors.iter().any(|own| own.radial_clearance_m > 0.0)
    }

    /// Puts 0 in the place of effects below `threshold_si`, which are nothing but round-off. Proven ends stay as they are: they are never narrowed.
    pub fn drop_round_off(&mut self, threshold_si: f64) {
        let histories = [
            &mut self.first_order_si,
            &mut self.held_first_order_si,
            &mut self.worst_case_si,
            &mut self.lowest_si,
            &mut self.highest_si,
            &mut self.disc_standard_deviation_si,
            &mut self.rim_standard_deviation_si,
        ];
        let of_joints = self
            .contributors
            .iter_mut()
            .flat_map(|own| [&mut own.first_order_si, &mut own.offset_si, &mut own.lean_si, &mut own.axial_si]);
        let searched = self.searched.iter_mut().flat_map(|own| &mut own.found_si);
        let effects = histories.into_iter().chain(of_joints).flatten().chain(searched);
        drop_round_off(effects, threshold_si);
        self.witness.take_if(|witness| witness.deviation_si.abs() < threshold_si);
    }
}

impl OutputMotion {
    /// Whether it is a displacement or a rotation, whose deviations are sizes: they have no sign.
    pub fn is_size(&self) -> bool {
        self.value_si.is_empty() && !self.is_of_path()
    }

    /// Whether it is a coordinate or an error of a path: it has no motion of its own.
    pub fn is_of_path(&self) -> bool {
        self.coordinate_of.is_some() || self.path_error.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_off_is_dropped_wherever_it_stands_but_proven_ends_stay() {
        const EFFECTS_M: [f64; 3] = [1e-5, 1e-20, -3e-20];
        let effects = || EFFECTS_M.to_vec();
        let searched =
            SearchedPosition { position: 0, found_si: [-3e-20, 1e-5], proven_si: Some([-4e-20, 2e-5]), conditions: 0 };
        let joint = JointContributor {
            first_order_si: effects(),
            offset_si: effects(),
            lean_si: effects(),
            axial_si: effects(),
            ..JointContributor::default()
        };
        let mut answer = ClearanceAnswer {
            first_order_si: effects(),
            lowest_si: effects(),
            proven_lowest_si: effects(),
            rim_standard_deviation_si: effects(),
            searched: vec![searched],
            contributors: vec![joint],
            ..ClearanceAnswer::default()
        };
        answer.drop_round_off(1e-12);
        let [joint] = &answer.contributors[..] else { panic!("one joint") };
        let dropped = [&answer.first_order_si, &answer.lowest_si, &answer.rim_standard_deviation_si];
        let of_joint = [&joint.first_order_si, &joint.offset_si, &joint.lean_si, &joint.axial_si];
        assert!(dropped.into_iter().chain(of_joint).all(|own| *own == [1e-5, 0.0, 0.0]), "{answer:?}");
        assert_eq!(answer.searched[0].found_si, [0.0, 1e-5]);
        assert_eq!(answer.searched[0].proven_si, Some([-4e-20, 2e-5]));
        assert_eq!(answer.proven_lowest_si, EFFECTS_M);
    }
}

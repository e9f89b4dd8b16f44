//! Kinematic properties of an ideal motion: classes of loops, swings and strokes, dead centres, transmission angles.

use loosepin_text::units::{SiUnit, extended};
use serde::{Deserialize, Serialize};

/// What a designer asks of an ideal motion first.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct KinematicProperties {
    /// Four-bar loops and slider-cranks through the ground.
    pub loops: Vec<LoopProperties>,
    /// Bodies that oscillate and joints that slide, over a whole turn of the drive; empty where it cannot go through one.
    pub ranges: Vec<MotionRange>,
    /// Transmission and pressure angles of the loops that a drive at the ground moves.
    pub transmission_angles: Vec<TransmissionAngle>,
    /// Mechanical advantage of each output that moves, but for the angle of the drive itself, where one drive at constant speed moves all;
    /// empty in records of older versions.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub mechanical_advantages: Vec<MechanicalAdvantage>,
}

impl KinematicProperties {
    /// Whether nothing is known.
    pub fn is_empty(&self) -> bool {
        self.loops.is_empty()
            && self.ranges.is_empty()
            && self.transmission_angles.is_empty()
            && self.mechanical_advantages.is_empty()
    }
}

/// A planar loop through the ground, and which of its links can turn fully.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LoopProperties {
    /// Four-bar: the ground, a link at the ground, the coupler, the other link. Slider-crank: the crank, the rod, the slider.
    pub bodies: Vec<String>,
    /// Four-bar: distances of the joint centres of these bodies. Slider-crank: crank, rod, distance of the crank's bearing from the line
    /// of the slider's pin.
    #[serde(with = "extended")]
    pub lengths_m: Vec<f64>,
    /// Which link turns fully.
    pub class: LoopClass,
    /// The shortest link of a four-bar.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shortest: Option<String>,
}

/// Class of a loop: of a four-bar by Grashof's rule on shortest + longest against the sum of the others.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LoopClass {
    /// Four-bar, Grashof: a link at the ground is the shortest, and turns fully.
    CrankRocker,
    /// Four-bar, Grashof: the ground is the shortest, and both links at it turn fully.
    DoubleCrank,
    /// Four-bar, Grashof: the coupler is the shortest, and turns fully.
    DoubleRocker,
    /// Four-bar: both sums are equal, and the links can come to lie on one line.
    ChangePoint,
    /// Four-bar, not Grashof: no link turns fully.
    TripleRocker,
    /// Slider-crank: crank + |offset| < rod, the crank turns fully.
    TurningCrank,
    /// Slider-crank: crank + |offset| = rod, the crank turns fully through a position where the rod is at right angles to the guide.
    TurningCrankAtLimit,
    /// Slider-crank: crank + |offset| > rod, the crank does not turn fully.
    RockingCrank,
}

impl LoopClass {
    /// The class in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::CrankRocker => "crank-rocker",
            Self::DoubleCrank => "double crank",
            Self::DoubleRocker => "double rocker (Grashof)",
            Self::ChangePoint => "change-point four-bar",
            Self::TripleRocker => "triple rocker (not Grashof)",
            Self::TurningCrank => "slider-crank whose crank turns fully",
            Self::TurningCrankAtLimit => "slider-crank at the limit of a full turn",
            Self::RockingCrank => "slider-crank whose crank cannot turn fully",
        }
    }
}

impl LoopProperties {
    /// `ground, crank, coupler, rocker: crank-rocker, shortest link crank`.
    pub fn words(&self) -> String {
        let shortest = self.shortest.as_ref().map_or_else(String::new, |name| format!(", shortest link {name}"));
        format!("{}: {}{shortest}", self.bodies.join(", "), self.class.words())
    }
}

/// Swing of a body or stroke of a sliding joint.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MotionRange {
    /// Name of the body, or of the joint.
    pub name: String,
    /// Unit of the extent: an angle for a swing, a length for a stroke.
    pub unit: SiUnit,
    /// Whether the body, or one of the joint's bodies, is joined to the ground.
    pub is_at_ground: bool,
    /// Highest less lowest value.
    #[serde(with = "extended")]
    pub extent_si: f64,
    /// Angles of the drive at the lowest and the highest value.
    #[serde(with = "extended")]
    pub ends_rad: [f64; 2],
    /// Angles of the drive at which it stands still and turns back, increasing: its dead centres.
    #[serde(with = "extended")]
    pub dead_centres_rad: Vec<f64>,
    /// Larger over smaller of the drive's turns between both ends, where the drive has a constant speed.
    #[serde(default, with = "extended", skip_serializing_if = "Option::is_none")]
    pub time_ratio: Option<f64>,
}

/// Smallest and largest angle by which a loop transmits motion.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TransmissionAngle {
    /// Coupler and output link of a four-bar; rod and slider of a slider-crank.
    pub bodies: [String; 2],
    /// A pressure angle, between rod and guide, 0 to 90° and best at 0; else a transmission angle, 0 to 180° and best at 90°.
    pub is_pressure_angle: bool,
    /// Smallest and largest value.
    #[serde(with = "extended")]
    pub extremes_rad: [f64; 2],
    /// Angles of the drive there.
    #[serde(with = "extended")]
    pub at_rad: [f64; 2],
    /// Its value at each angle of the drive; empty in records of older versions.
    #[serde(with = "extended", default, skip_serializing_if = "Vec::is_empty")]
    pub value_rad: Vec<f64>,
}

/// Force or torque on an output that balances a unit torque of the drive, without losses, weight and inertia.
///
/// Virtual power: T ω = F v, with the torque T and the speed ω of the drive, the force F on the output along its motion and the output's
/// speed v. So A = F/T = ω/|v|. It is infinite where the output stands still: in a dead centre no force on it reaches the drive.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MechanicalAdvantage {
    /// Name of the output, or of the path: then the force is along its motion.
    pub name: String,
    /// 1 for an angle (torque per torque), 1/m for a position (force per torque).
    pub unit: SiUnit,
    /// Its value at each angle of the drive.
    #[serde(with = "extended")]
    pub value_si: Vec<f64>,
    /// The smallest value over the whole motion, between the recorded angles too; `None` in records of older versions.
    #[serde(default, with = "extended", skip_serializing_if = "Option::is_none")]
    pub least_si: Option<f64>,
}

//! Mechanism and journal paths as a page draws them.

use super::drawn_joint::DrawnJointKind;
use loosepin_text::units::extended;
use serde::{Deserialize, Serialize};

/// Path of a journal's centre in its bearing: the eccentricity, turned into the frame of the bearing's body.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct JournalOrbit {
    /// Name of the joint.
    pub joint: String,
    /// Which run this is, in words; empty where there is only one.
    pub label: String,
    /// Radial clearance: the circle that the path stays in, but for penetration.
    #[serde(with = "extended")]
    pub radial_clearance_m: f64,
    /// Eccentricity along x of the bearing frame.
    #[serde(with = "extended")]
    pub x_m: Vec<f64>,
    /// Eccentricity along y of the bearing frame.
    #[serde(with = "extended")]
    pub y_m: Vec<f64>,
    /// Angle of the drive at each sample, as of [`Drawing::poses`]; empty where it is not known.
    #[serde(default, with = "extended")]
    pub drive_angle_rad: Vec<f64>,
    /// Normal contact force at each sample, 0 in free flight; empty where it is not known.
    #[serde(default, with = "extended")]
    pub force_n: Vec<f64>,
}

/// The mechanism as a page draws it: shapes in body frames, and poses of one cycle.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Drawing {
    /// The bodies; `poses` follow this order.
    pub bodies: Vec<DrawnBody>,
    /// The joints.
    pub joints: Vec<DrawnJoint>,
    /// The drives; empty in records of older versions.
    #[serde(default)]
    pub drives: Vec<DrawnDrive>,
    /// Points whose position is an output; empty in records of older versions.
    #[serde(default)]
    pub output_points: Vec<DrawnOutput>,
    /// Poses of the mechanism with clearance over one cycle.
    pub poses: PoseTable,
    /// Poses of the ideal mechanism at the same inputs; empty where it is not drawn.
    pub ideal_poses: PoseTable,
    /// How flexible bodies bend; empty, and not written, where there are none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub beams: Vec<DrawnBeam>,
}

impl Drawing {
    /// Whether there is nothing to draw.
    pub fn is_empty(&self) -> bool {
        self.bodies.is_empty()
    }
}

/// How a flexible body bends.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DrawnBeam {
    /// Index of the body.
    pub body: usize,
    /// Indices of its points at root and tip of the beam.
    pub ends: [usize; 2],
    /// Deflection of each lateral shape at places evenly from root to tip, to the left of the way from root to tip, m for each rad.
    #[serde(with = "extended")]
    pub deflections_m: Vec<Vec<f64>>,
    /// Coordinate of each lateral shape at each pose, rad.
    #[serde(with = "extended")]
    pub turns_rad: Vec<Vec<f64>>,
    /// Frequencies of the lateral shapes with the frame held, Hz.
    #[serde(with = "extended")]
    pub lateral_hz: Vec<f64>,
    /// Frequencies of the axial shapes with the frame held, Hz.
    #[serde(with = "extended")]
    pub axial_hz: Vec<f64>,
    /// x of places evenly from root to tip at each pose, in the frame in which the body is drawn, m: of a body in absolute nodal
    /// coordinates, which has no shapes. Empty, and not written, for others.
    #[serde(default, with = "extended", skip_serializing_if = "Vec::is_empty")]
    pub axis_x_m: Vec<Vec<f64>>,
    /// y of these places.
    #[serde(default, with = "extended", skip_serializing_if = "Vec::is_empty")]
    pub axis_y_m: Vec<Vec<f64>>,
}

/// One body.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DrawnBody {
    /// Name of the body.
    pub name: String,
    /// Whether it is the fixed one.
    pub is_ground: bool,
    /// Named points in the frame of the body.
    pub points: Vec<DrawnPoint>,
}

/// A named point of a body.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DrawnPoint {
    /// Name without the body's.
    pub name: String,
    /// x in the frame of the body.
    #[serde(with = "extended")]
    pub x_m: f64,
    /// y in the frame of the body.
    #[serde(with = "extended")]
    pub y_m: f64,
}

/// One joint between two points.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DrawnJoint {
    /// Name of the joint.
    pub name: String,
    /// Kind of the joint.
    pub kind: DrawnJointKind,
    /// Point of the bearing, or a point of the guide.
    pub first: PointReference,
    /// Point of the journal, or of the slider.
    pub second: PointReference,
    /// Direction of the guide or slot in the frame of the first point's body; 0 for other kinds.
    #[serde(with = "extended")]
    pub guide_angle_rad: f64,
    /// Radial clearance; 0 for an ideal joint.
    #[serde(with = "extended")]
    pub radial_clearance_m: f64,
}

/// Prescribed quantity of a drive, and its direction.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct DrawnDrive {
    /// Name of the drive.
    pub name: String,
    /// Index of its joint in [`Drawing::joints`].
    pub joint: usize,
    /// Sense of the turn of the joint's second body against the first, or of its travel along the guide.
    pub sense: DriveSense,
}

/// Sense of a drive over one cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum DriveSense {
    /// Anticlockwise, or along the guide.
    Forward,
    /// Clockwise, or against the guide.
    Backward,
    /// Both, one after the other.
    ToAndFro,
    /// The drive holds its joint.
    Still,
}

/// An output that is the position of a point: its path, or one of its coordinates.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct DrawnOutput {
    /// Name of the output.
    pub name: String,
    /// The point that moves.
    pub point: PointReference,
}

/// A point by the index of its body in [`Drawing::bodies`] and of itself in [`DrawnBody::points`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct PointReference {
    /// Index of the body.
    pub body: usize,
    /// Index of the point in the body.
    pub point: usize,
}

/// Poses of all bodies at chosen inputs. `x_m[b][k]` is the origin of body `b` at pose `k`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct PoseTable {
    /// Angle of the drive at each pose.
    #[serde(with = "extended")]
    pub drive_angle_rad: Vec<f64>,
    /// x of the origin of each body's frame, by body and pose.
    #[serde(with = "extended")]
    pub x_m: Vec<Vec<f64>>,
    /// y of the origin of each body's frame, by body and pose.
    #[serde(with = "extended")]
    pub y_m: Vec<Vec<f64>>,
    /// Angle of each body's frame from the ground's, by body and pose.
    #[serde(with = "extended")]
    pub angle_rad: Vec<Vec<f64>>,
}

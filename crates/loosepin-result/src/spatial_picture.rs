//! The picture of a mechanism in space: what is drawn of each body and joint in the frame of its body, and where the bodies are. SI.
//!
//! A point s of a body stands at r + R(q) s of the ground, [`PicturePose::point_m`]. How it is projected and drawn is no part of the record.

use serde::{Deserialize, Serialize};

/// A mechanism in space as it is drawn. Body 0 is the ground.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct SpatialPicture {
    /// Diagonal of the box around all its points in all positions, m; signs without a size of their own are shares of it.
    pub extent_m: f64,
    /// The bodies.
    pub bodies: Vec<PictureBody>,
    /// The joints, in their order.
    pub joints: Vec<PictureJoint>,
    /// What is drawn, in frames of bodies.
    pub elements: Vec<PictureElement>,
    /// Pose of each body, for each position of the turn.
    pub poses: Vec<Vec<PicturePose>>,
    /// Paths of points over the turn.
    pub traces: Vec<PictureTrace>,
}

impl SpatialPicture {
    /// Whether there is nothing to draw.
    pub fn is_empty(&self) -> bool {
        self.bodies.is_empty()
    }
}

/// A body.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PictureBody {
    /// Its name.
    pub name: String,
    /// Its named points.
    pub points: Vec<PicturePoint>,
}

/// A named point of a body.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PicturePoint {
    /// Its name.
    pub name: String,
    /// In the frame of the body, m.
    pub at_m: [f64; 3],
}

/// A joint: where its bearing is.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PictureJoint {
    /// Its name.
    pub name: String,
    /// Word for its kind, such as `revolute`.
    pub kind: String,
    /// Body of the bearing.
    pub body: usize,
    /// Middle of the bearing in the frame of that body, m.
    pub at_m: [f64; 3],
    /// Axis of the bearing in that frame, a unit vector.
    pub axis: [f64; 3],
    /// Whether it has play.
    pub has_play: bool,
    /// Body with which its sign moves: that of the journal where it slides.
    pub sign_body: usize,
    /// Middle of its sign in the frame of that body, m.
    pub sign_at_m: [f64; 3],
    /// The points of bearing and journal.
    pub ends: [PictureEnd; 2],
}

/// A point of a body at a joint.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PictureEnd {
    /// The body.
    pub body: usize,
    /// In its frame, m.
    pub at_m: [f64; 3],
}

/// Something that is drawn and moves with a body.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PictureElement {
    /// What it is.
    pub role: PictureRole,
    /// The body with which it moves.
    pub body: usize,
    /// Name of the body or joint that it shows.
    pub of: String,
    /// Whether it belongs to a joint with play.
    pub has_play: bool,
    /// Its shape in the frame of the body.
    pub shape: PictureShape,
}

/// What an element is; pages choose colour and width by it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PictureRole {
    /// A body between two of its points.
    Bar,
    /// A face of a body.
    Plate,
    /// A slider.
    Block,
    /// A hole.
    Bearing,
    /// A pin or shaft in it.
    Pin,
    /// A ball in its socket.
    Ball,
    /// A rail.
    Guide,
    /// The axis of a joint.
    Axis,
    /// The foot of a joint on the ground.
    Foot,
    /// The hatching of a foot.
    Hatch,
    /// The arrow of a drive.
    Drive,
}

impl PictureRole {
    /// Its word, the class in pages.
    pub fn word(self) -> &'static str {
        match self {
            Self::Bar => "bar",
            Self::Plate => "plate",
            Self::Block => "block",
            Self::Bearing => "bearing",
            Self::Pin => "pin",
            Self::Ball => "ball",
            Self::Guide => "guide",
            Self::Axis => "axis",
            Self::Foot => "foot",
            Self::Hatch => "hatch",
            Self::Drive => "drive",
        }
    }
}

/// A shape in the frame of a body, m.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PictureShape {
    /// A line through points.
    Line {
        /// The points.
        points_m: Vec<[f64; 3]>,
    },
    /// A flat convex face.
    Face {
        /// Its corners in their order round.
        corners_m: Vec<[f64; 3]>,
    },
    /// A round cylinder.
    Cylinder {
        /// Middles of both ends.
        ends_m: [[f64; 3]; 2],
        /// Its radius, m.
        radius_m: f64,
    },
    /// A ball.
    Ball {
        /// Its middle.
        centre_m: [f64; 3],
        /// Its radius, m.
        radius_m: f64,
    },
}

/// Pose of a body: a point s of it stands at r + R(q) s.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PicturePose {
    /// r, the origin of its frame in that of the ground, m.
    pub at_m: [f64; 3],
    /// q = (w, x, y, z), a unit quaternion.
    pub turn: [f64; 4],
}

impl PicturePose {
    /// The pose of the ground.
    pub const GROUND: Self = Self { at_m: [0.0; 3], turn: [1.0, 0.0, 0.0, 0.0] };

    /// A point of the body in the frame of the ground: s + 2 v × (v × s + w s) + r, with q = (w, v).
    pub fn point_m(&self, point_m: [f64; 3]) -> [f64; 3] {
        let [w, x, y, z] = self.turn;
        let cross = |[a, b, c]: [f64; 3]| [y * c - z * b, z * a - x * c, x * b - y * a];
        let first = cross(point_m);
        let inner: [f64; 3] = std::array::from_fn(|k| first[k] + w * point_m[k]);
        let second = cross(inner);
        std::array::from_fn(|k| point_m[k] + 2.0 * second[k] + self.at_m[k])
    }
}

/// The path of a point over the turn.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PictureTrace {
    /// The point, such as `rod.tip`, or the joint in whose middle it is.
    pub point: String,
    /// The output that it belongs to; `None` where it belongs to none.
    pub output: Option<String>,
    /// Its body.
    pub body: usize,
    /// The point in the frame of the body, m.
    pub point_m: [f64; 3],
    /// Its ideal place in the frame of the ground at each position, m.
    pub at_m: Vec<[f64; 3]>,
    /// Where play takes it, at some positions; empty where nothing has play.
    pub zones: Vec<PictureZone>,
    /// Which of the zones belongs to the position with the largest worst case of its output.
    pub worst_zone: Option<usize>,
}

/// Where play takes a point in one position, to first order. The places that it reaches are the convex hull of the boundary, which is
/// symmetric about the ideal place.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PictureZone {
    /// Number of the position.
    pub sample: usize,
    /// Displacements that go farthest in directions spread over the sphere, m.
    pub boundary_m: Vec<[f64; 3]>,
}

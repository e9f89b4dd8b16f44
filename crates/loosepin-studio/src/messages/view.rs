//! The mechanism as the page shows it.

use loosepin::report::{CurveChoice, LiveBand, LiveCurve, LivePath, MovingDrawing, SpaceDrawing};
use serde::Serialize;

use super::diagnostics::Document;

/// Kind of a written number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum QuantityKind {
    /// Its value in the model.
    Number,
    /// How it scatters.
    Scatter,
    /// What is unknown of it.
    Unknown,
}

/// A number of the texts.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct QuantityView {
    /// Path in the file: `joint.gudgeon.radial_clearance`.
    pub path: String,
    /// In words.
    pub words: String,
    /// The text.
    pub document: Document,
    /// The written text, without quotes.
    pub written: String,
    /// First UTF-16 unit.
    pub from: usize,
    /// Behind the last UTF-16 unit.
    pub to: usize,
    /// Its kind.
    pub kind: QuantityKind,
    /// Dragging leaves it as it is.
    pub is_locked: bool,
}

/// A pin and its position.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PinView {
    /// Index of a body that carries it, in the drawing.
    pub body: usize,
    /// x in the frame of that body, mm.
    pub x: f64,
    /// y in it, mm.
    pub y: f64,
}

/// A joint in the outline.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct JointView {
    /// Its name.
    pub name: String,
    /// Its kind, in words.
    pub kind: &'static str,
    /// Its play, where it has any.
    pub play: Option<String>,
    /// Whether it can have play.
    pub takes_play: bool,
    /// Its centre, where it is a pin that can be dragged.
    pub pin: Option<PinView>,
    /// The points that it joins: `rod.small_end`, `slider.pin`.
    pub points: [String; 2],
}

/// A point of a body.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PointView {
    /// Its name.
    pub name: String,
    /// x in the frame of its body, mm.
    pub x: f64,
    /// y in it, mm.
    pub y: f64,
}

/// A body with its points; the ground too.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BodyView {
    /// Its name.
    pub name: String,
    /// Its points.
    pub points: Vec<PointView>,
}

/// Kind of a dimension.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum DimensionKind {
    /// Length of a body.
    Length,
    /// Angle of the line of a joint.
    Angle,
}

/// A dimension of a body or a joint.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DimensionView {
    /// Its kind.
    pub kind: DimensionKind,
    /// Name of the body, or of the joint whose line it is.
    pub of: String,
    /// Index of the body that it moves with, in the drawing.
    pub body: usize,
    /// Its beginning in the frame of that body, mm.
    pub from: [f64; 2],
    /// Its end; for a line, a millimetre along it.
    pub to: [f64; 2],
    /// With its unit.
    pub written: String,
    /// The number behind it, where there is one.
    pub path: Option<String>,
}

/// Tables of what acts on bodies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ForceTable {
    /// Springs and dampers.
    Spring,
    /// Forces and torques.
    Load,
}

/// A spring or a load, with where it stands in the drawing.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ForceView {
    /// Which of both.
    pub table: ForceTable,
    /// Its name.
    pub name: String,
    /// Its kind, in words.
    pub kind: &'static str,
    /// Both ends of a spring along a line; the one place of all others; empty if no point says where.
    pub ends: Vec<PinView>,
    /// Direction of a force from the x axis of the body at `ends`, or from that of the ground, degrees.
    pub direction_deg: Option<f64>,
    /// The direction turns with the body.
    pub turns: bool,
}

/// An output in the outline.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OutputView {
    /// Its name.
    pub name: String,
    /// Its description, in words.
    pub words: String,
}

/// Parts of the mechanism.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Outline {
    /// Bodies that move.
    pub bodies: Vec<String>,
    /// Joints.
    pub joints: Vec<JointView>,
    /// Drives.
    pub drives: Vec<String>,
    /// Outputs.
    pub outputs: Vec<OutputView>,
    /// Springs and loads.
    pub forces: Vec<ForceView>,
    /// All bodies with their points, in the order of the drawing.
    pub parts: Vec<BodyView>,
    /// Dimensions of bodies and joints.
    pub dimensions: Vec<DimensionView>,
    /// Four-bars and slider-cranks through the ground with their classes, in words, where it moves.
    pub loops: Vec<String>,
}

/// A limit of the study that is a line in the chart of a band.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LimitView {
    /// Name of the output.
    pub output: String,
    /// The limit, SI.
    pub within_si: f64,
    /// As the study has it, quotes left out.
    pub written: String,
    /// First UTF-16 unit of it.
    pub from: usize,
    /// Behind the last one.
    pub to: usize,
}

/// The mechanism that was read.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct View {
    /// Its name, or that of the study.
    pub title: String,
    /// Degrees of freedom and drives, in words.
    pub mobility: String,
    /// Why it does not move yet; what is drawn is where its bodies were put.
    pub incomplete: Option<String>,
    /// Quasi-static effects of play and scatter, in sentences.
    pub sentences: Vec<String>,
    /// The mechanism, moving; `None` of one in space.
    pub drawing: Option<MovingDrawing>,
    /// The mechanism in space, moving.
    pub space: Option<SpaceDrawing>,
    /// The band of each output that has one.
    pub bands: Vec<LiveBand>,
    /// The paths of output points and of traced points, with their zones.
    pub paths: Vec<LivePath>,
    /// Curves that there are.
    pub curves: Vec<CurveChoice>,
    /// The wanted one, or the first of its quantity.
    pub curve: Option<LiveCurve>,
    /// The angles between which the drive can turn, degrees, where it cannot go through its whole turn.
    pub drive_range_deg: Option<[f64; 2]>,
    /// The limits among them.
    pub limits: Vec<LimitView>,
    /// Its parts.
    pub outline: Outline,
    /// Its numbers.
    pub quantities: Vec<QuantityView>,
}

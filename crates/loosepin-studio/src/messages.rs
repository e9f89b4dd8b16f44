//! What the page and the server say to each other over the live connection, as JSON. `front/src/messages.ts` has the same types, and
//! `just studio-messages` writes them there.

use loosepin::diagnostics::Severity;
use loosepin::report::{DraftBand, LiveBand, MovingDrawing};
use loosepin::study::result::Verdict;
use serde::{Deserialize, Serialize};

use crate::drawing::still::NamedPoses;

/// A text with the path of its file, by which complaints name it.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
pub struct SentText {
    /// Path in the served folder.
    pub path: String,
    /// What it says.
    pub text: String,
}

/// A study and its model, as the page shows them.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
pub struct Shown {
    /// The model.
    pub model: SentText,
    /// The study.
    pub study: SentText,
}

/// What the page asks to be read.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Look {
    /// Counts up; comes back with the answer.
    pub seq: u64,
    /// The model.
    pub model: SentText,
    /// The study of it, where there is one.
    pub study: Option<SentText>,
    /// Positions in a turn.
    pub positions: usize,
    /// What is dragged, where anything is: what is looked at are the texts that the drag makes of these.
    #[serde(default)]
    pub grip: Option<Grip>,
    /// Where bodies were last: a mechanism that does not move yet is drawn there.
    #[serde(default)]
    pub poses: Option<NamedPoses>,
}

/// What a drag takes.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(tag = "take", rename_all = "snake_case")]
pub enum Held {
    /// The centre of a pin.
    Joint {
        /// Its name.
        joint: String,
    },
    /// A point that no pin holds.
    Point {
        /// Its body; `ground` too.
        body: String,
        /// Its name.
        point: String,
    },
    /// The line of a guide or a slot, which turns about its point.
    Guide {
        /// Name of the joint.
        joint: String,
    },
}

/// A drag.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Grip {
    /// What is dragged.
    pub held: Held,
    /// Where a centre or point is to be, or a place on the line of a guide, mm.
    pub to_mm: [f64; 2],
    /// Written values are rounded to the next round step that is not below this one, mm.
    pub step_mm: f64,
    /// Values are as they come: no round steps.
    pub is_free: bool,
    /// Where each body is: x and y of its origin, mm, and its angle, degrees.
    pub poses: Vec<[f64; 3]>,
}

/// What comes over the live connection from the page.
#[derive(Debug, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum FromPage {
    /// The first message.
    Hello {
        /// The secret of the address.
        token: String,
    },
    /// Read these texts.
    Look(Box<Look>),
    /// Run a study that is saved.
    Run {
        /// Its path in the served folder.
        study: String,
        /// The texts that the page shows: these are run, whatever is on the disk by then.
        #[serde(default)]
        shown: Option<Box<Shown>>,
    },
    /// Run the mechanism at a witness of a finished study.
    Simulate {
        /// Path of the result in the served folder.
        result: String,
        /// Place among the witnesses that it lists.
        witness: usize,
    },
    /// Stop a job, or take it out of the queue.
    Stop {
        /// Its number.
        id: u64,
    },
}

/// What goes over the live connection to the page.
#[derive(Debug, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum ToPage<'a> {
    /// The token was right.
    Hello {
        /// Version of the program.
        version: &'a str,
        /// Jobs of this server.
        jobs: Vec<Job>,
    },
    /// What was read.
    Seen(&'a Seen),
    /// How far a job is.
    Job {
        /// It.
        job: &'a Job,
    },
    /// A file of the last look is not as it was.
    Changed {
        /// Its path.
        path: &'a str,
    },
    /// A message that is not taken.
    Refused {
        /// Why.
        message: &'a str,
    },
}

/// Which of the two texts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Document {
    /// The mechanism.
    Model,
    /// What is uncertain in it, and what is asked.
    Study,
}

/// A stretch of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Stretch {
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// First UTF-16 unit.
    pub from: usize,
    /// Behind the last UTF-16 unit.
    pub to: usize,
}

/// A second place that matters to a complaint.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SeenLabel {
    /// The text; nothing where it is none of the two.
    pub document: Option<Document>,
    /// Where in it.
    #[serde(flatten)]
    pub stretch: Option<Stretch>,
    /// What is said of it.
    pub text: String,
}

/// Something wrong, or worth a warning.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SeenComplaint {
    /// The text at fault; nothing where it is none of the two.
    pub document: Option<Document>,
    /// Path of the file at fault.
    pub path: Option<String>,
    /// For `explain`.
    pub code: &'static str,
    /// How grave it is.
    pub severity: Severity,
    /// What is wrong.
    pub message: String,
    /// The way out.
    pub hint: Option<String>,
    /// Where.
    #[serde(flatten)]
    pub stretch: Option<Stretch>,
    /// Other places.
    pub labels: Vec<SeenLabel>,
    /// A change that mends it, where one is known.
    pub fix: Option<Fix>,
}

/// A stretch of a text that is replaced.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Change {
    /// The text.
    pub document: Document,
    /// First UTF-16 unit that goes.
    pub from: usize,
    /// Behind the last UTF-16 unit that goes.
    pub to: usize,
    /// What comes in its place.
    pub insert: String,
}

/// A change that mends a complaint.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Fix {
    /// It.
    #[serde(flatten)]
    pub change: Change,
    /// What it does, in words.
    pub words: String,
}

/// What is written of a number.
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
pub struct SeenQuantity {
    /// Where it stands: `joint.gudgeon.radial_clearance`.
    pub path: String,
    /// In words.
    pub words: String,
    /// The text.
    pub document: Document,
    /// What is written, quotes left out.
    pub written: String,
    /// First UTF-16 unit.
    pub from: usize,
    /// Behind the last UTF-16 unit.
    pub to: usize,
    /// What it is.
    pub kind: QuantityKind,
    /// Dragging leaves it as it is.
    pub is_locked: bool,
}

/// Where a pin is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SeenPin {
    /// Index of a body that carries it, in the drawing.
    pub body: usize,
    /// x in the frame of that body, mm.
    pub x: f64,
    /// y in it, mm.
    pub y: f64,
}

/// A joint in the outline.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SeenJoint {
    /// Its name.
    pub name: String,
    /// What it is, in words.
    pub kind: &'static str,
    /// Its play, where it has any.
    pub play: Option<String>,
    /// Its centre, where it is a pin that can be dragged.
    pub pin: Option<SeenPin>,
    /// The points that it joins: `rod.small_end`, `slider.pin`.
    pub points: [String; 2],
}

/// A point of a body.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SeenPoint {
    /// Its name.
    pub name: String,
    /// x in the frame of its body, mm.
    pub x: f64,
    /// y in it, mm.
    pub y: f64,
}

/// A body with its points; the ground too.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SeenBody {
    /// Its name.
    pub name: String,
    /// Its points.
    pub points: Vec<SeenPoint>,
}

/// What a dimension is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum DimensionKind {
    /// Of a body.
    Length,
    /// Of the line of a joint.
    Angle,
}

/// A dimension of a body or a joint.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SeenDimension {
    /// What it is.
    pub kind: DimensionKind,
    /// Name of the body, or of the joint whose line it is.
    pub of: String,
    /// Index of the body that it moves with, in the drawing.
    pub body: usize,
    /// Where it begins in the frame of that body, mm.
    pub from: [f64; 2],
    /// Where it ends; of a line, a millimetre along it.
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
pub struct SeenForce {
    /// Which of both.
    pub table: ForceTable,
    /// Its name.
    pub name: String,
    /// What it is, in words.
    pub kind: &'static str,
    /// Both ends of a spring along a line; the one place of all others; nothing where no point says where.
    pub ends: Vec<SeenPin>,
    /// Direction of a force from the x axis of the body at `ends`, or from that of the ground, degrees.
    pub direction_deg: Option<f64>,
    /// The direction turns with the body.
    pub turns: bool,
}

/// An output in the outline.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SeenOutput {
    /// Its name.
    pub name: String,
    /// What it is, in words.
    pub words: String,
}

/// What the mechanism is made of.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Outline {
    /// Bodies that move.
    pub bodies: Vec<String>,
    /// Joints.
    pub joints: Vec<SeenJoint>,
    /// Drives.
    pub drives: Vec<String>,
    /// Outputs.
    pub outputs: Vec<SeenOutput>,
    /// Springs and loads.
    pub forces: Vec<SeenForce>,
    /// All bodies with their points, in the order of the drawing.
    pub parts: Vec<SeenBody>,
    /// Dimensions of bodies and joints.
    pub dimensions: Vec<SeenDimension>,
}

/// A limit of the study that is a line in the chart of a band.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SeenLimit {
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
    /// What play and scatter do without dynamics, in sentences.
    pub sentences: Vec<String>,
    /// The mechanism, moving.
    pub drawing: Option<MovingDrawing>,
    /// The band of each output that has one.
    pub bands: Vec<LiveBand>,
    /// The limits among them.
    pub limits: Vec<SeenLimit>,
    /// What it is made of.
    pub outline: Outline,
    /// Its numbers.
    pub quantities: Vec<SeenQuantity>,
}

/// What a drag does to the texts that were sent.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Reshaped {
    /// The changes, all in units of the texts that were sent, in their order.
    pub changes: Vec<Change>,
    /// The new values, in words.
    pub words: Vec<String>,
    /// The angle of the drive at which the joints lie where the drag left them.
    pub angle_deg: Option<f64>,
    /// Where the bodies are that the drag has moved, by name: so a mechanism is drawn that does not move yet.
    pub poses: NamedPoses,
    /// Why nothing can be changed.
    pub refusal: Option<String>,
}

/// The answer to a look.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Seen {
    /// That of the look.
    pub seq: u64,
    /// Everything wrong, and warnings.
    pub complaints: Vec<SeenComplaint>,
    /// The mechanism; nothing where the model cannot be read, or does not move.
    pub view: Option<View>,
    /// What a drag did: `complaints` and `view` are of the texts with its changes.
    pub reshaped: Option<Reshaped>,
    /// How long it took.
    pub cost_ms: f64,
    /// It took too long and was stopped: nothing is known of these texts.
    pub is_cut: bool,
}

/// The state of a job.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum JobState {
    /// Others are before it.
    Waiting,
    /// It runs.
    Running,
    /// Its results are there.
    Done,
    /// It came to no result.
    Failed,
    /// Somebody stopped it; its runs are kept.
    Stopped,
}

/// What a job runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum JobKind {
    /// A study.
    Study,
    /// One mechanism by itself.
    Run,
}

/// What is run in the background.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Job {
    /// Its number.
    pub id: u64,
    /// Which of both.
    pub kind: JobKind,
    /// The study; of a single run the result that it belongs to.
    pub study: String,
    /// Its name.
    pub title: String,
    /// What becomes of it.
    pub state: JobState,
    /// Finished runs.
    pub finished: usize,
    /// The runs that it may come to.
    pub most: usize,
    /// Since it began to run.
    pub seconds: f64,
    /// What came out, in sentences.
    pub words: Vec<String>,
    /// What is known before it is finished.
    pub draft: Option<JobDraft>,
    /// What is wrong, where it failed.
    pub complaints: Vec<String>,
    /// Folder of its results, in the served folder.
    pub result: Option<String>,
    /// Over all requirements.
    pub verdict: Option<Verdict>,
}

/// What is known of a study before it is finished.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct JobDraft {
    /// In sentences.
    pub words: Vec<String>,
    /// Bands over the cycle from the runs so far.
    pub bands: Vec<DraftBand>,
}

//! Messages of the live connection.

use loosepin::diagnostics::Severity;
use loosepin::report::CurveKey;
use serde::{Deserialize, Serialize};

use super::diagnostics::{Change, DiagnosticView};
use super::jobs::Job;
use super::view::View;
use crate::drawing::still::NamedPoses;

/// A text with the path of its file, by which diagnostics name it.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
pub struct SentText {
    /// Path in the served folder.
    pub path: String,
    /// Its text.
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

/// A request of the page to read its texts.
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
    /// The drag, if any: the texts are read as the drag changes them.
    #[serde(default)]
    pub grip: Option<Grip>,
    /// Previous poses of the bodies: a mechanism that does not move yet is drawn there.
    #[serde(default)]
    pub poses: Option<NamedPoses>,
    /// The curve that is shown, if any.
    #[serde(default)]
    pub curve: Option<CurveKey>,
    /// Points that are traced although no output is their path: `coupler.tip`. Those that the model does not have are left out.
    #[serde(default)]
    pub traced: Vec<String>,
    /// Nothing changes now: the texts are then also tried as by `loosepin check`, which is told in a [`CheckAnswer`].
    #[serde(default)]
    pub is_at_rest: bool,
}

impl Look {
    /// Of these texts, without anything else.
    pub fn of(model: SentText, study: Option<SentText>, positions: usize) -> Self {
        Self {
            seq: 0,
            model,
            study,
            positions,
            grip: None,
            poses: None,
            curve: None,
            traced: Vec::new(),
            is_at_rest: false,
        }
    }
}

/// The dragged object.
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
    /// The dragged object.
    pub held: Held,
    /// Target of a centre or point, or a place on the line of a guide, mm.
    pub to_mm: [f64; 2],
    /// Written values are rounded to the next round step that is not below this one, mm.
    pub step_mm: f64,
    /// Values are as they come: no round steps.
    pub is_free: bool,
    /// Pose of each body: x and y of its origin, mm, and its angle, degrees.
    pub poses: Vec<[f64; 3]>,
}

/// Messages from the page over the live connection.
#[derive(Debug, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum FromPage {
    /// The first message.
    Hello {
        /// The secret of the address.
        token: String,
        /// Name of the tab, where it has one.
        #[serde(default)]
        tab: Option<String>,
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

/// Messages to the page over the live connection.
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
    LookAnswer(&'a LookAnswer),
    /// What keeps the texts of a look from running.
    CheckAnswer(&'a CheckAnswer),
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

/// Effect of a drag on the sent texts.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct DragResult {
    /// The changes, all in units of the texts that were sent, in their order.
    pub changes: Vec<Change>,
    /// The new values, in words.
    pub words: Vec<String>,
    /// The angle of the drive at which the joints lie where the drag left them.
    pub angle_deg: Option<f64>,
    /// Poses of the dragged bodies, by name: for drawing a mechanism that does not move yet.
    pub poses: NamedPoses,
    /// Why nothing can be changed.
    pub refusal: Option<String>,
}

/// The answer to a look.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LookAnswer {
    /// Sequence number of the look.
    pub seq: u64,
    /// Everything wrong, and warnings.
    pub diagnostics: Vec<DiagnosticView>,
    /// The mechanism; `None` if the model cannot be read, or does not move.
    pub view: Option<View>,
    /// Effect of a drag: `diagnostics` and `view` are of the texts with its changes.
    pub reshaped: Option<DragResult>,
    /// How long it took.
    pub cost_ms: f64,
    /// The look took too long and was stopped: these texts were not read.
    pub is_cut: bool,
}

impl LookAnswer {
    /// The mechanism moves, and nothing is wrong in the texts.
    pub fn is_sound(&self) -> bool {
        let has_error = self.diagnostics.iter().any(|one| one.severity == Severity::Error);
        !has_error && self.view.as_ref().is_some_and(|view| view.incomplete.is_none())
    }
}

/// What `loosepin check` finds in the texts of a look that has a view.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CheckAnswer {
    /// Sequence number of the look.
    pub seq: u64,
    /// What keeps them from running; none where they run.
    pub diagnostics: Vec<DiagnosticView>,
}

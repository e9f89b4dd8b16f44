//! Plain requests and their answers, as JSON. `front/src/messages.ts` has the same types, and `just studio-messages` writes them there.

use loosepin::report::Comparison;
use serde::{Deserialize, Serialize};

use crate::drawing::still::NamedPoses;
use crate::edit::{Edit, Restructured};
use crate::files::adopt::AdoptedTexts;
use crate::files::drafts::{Draft, DraftText};
use crate::messages::{Change, SentText};
use crate::network::refusal::Refused;

/// Description of the server.
#[derive(Serialize)]
pub struct HelloAnswer {
    /// Version of the program.
    pub version: &'static str,
    /// Path of the served folder.
    pub folder: String,
    /// Its limits.
    pub limits: Limits,
}

/// Limits of the server.
#[derive(Serialize)]
pub struct Limits {
    /// Largest text, bytes.
    pub text_bytes: usize,
}

/// A file to be opened.
#[derive(Deserialize)]
pub struct OpenRequest {
    /// Path in the served folder.
    pub path: String,
}

/// A model, or a study with its model.
#[derive(Serialize)]
pub struct OpenAnswer {
    /// `None` if the model of the study cannot be read.
    pub model: Option<OpenedText>,
    /// `None` if a model was asked for.
    pub study: Option<OpenedText>,
}

/// A text of the served folder.
#[derive(Serialize)]
pub struct OpenedText {
    /// Its path.
    pub path: String,
    /// Its text.
    pub text: String,
    /// Tag by which it is recognised when it is saved.
    pub tag: String,
    /// Whether it is what this server has saved there last: no other program has changed it since.
    pub is_saved_here: bool,
}

/// A text to be saved.
#[derive(Deserialize)]
pub struct SaveRequest {
    /// Path in the served folder.
    pub path: String,
    /// Its text.
    pub text: String,
    /// Tag of the text that it changes; `None` for a new one.
    pub tag: Option<String>,
}

/// A text was saved.
#[derive(Serialize)]
pub struct SaveAnswer {
    /// Tag of the present text.
    pub tag: String,
}

/// How well a number is known, to be written into both texts.
#[derive(Deserialize)]
pub struct SetUncertaintyRequest {
    /// The model.
    pub model: SentText,
    /// The study of it, where there is one.
    pub study: Option<SentText>,
    /// Path of the number.
    pub path: String,
    /// As it is typed.
    pub text: String,
}

/// Effect on the texts of an entry of a number's uncertainty. What somebody types is no fault of the page: a refusal is an answer.
#[derive(Serialize)]
pub struct SetUncertaintyAnswer {
    /// In units of the texts that were sent, in their order.
    pub changes: Vec<Change>,
    /// Why there are none.
    pub refusal: Option<Refused>,
}

/// A change of the mechanism.
#[derive(Deserialize)]
pub struct RestructureRequest {
    /// The model.
    pub model: SentText,
    /// The study of it, where there is one.
    pub study: Option<SentText>,
    /// The requested change.
    pub edit: Edit,
    /// Displayed poses of the bodies.
    #[serde(default)]
    pub poses: NamedPoses,
}

/// Effect of a change of the mechanism, or why there is none.
#[derive(Serialize)]
pub struct RestructureAnswer {
    /// It.
    #[serde(flatten)]
    pub done: Option<Restructured>,
    /// Why not.
    pub refusal: Option<Refused>,
}

/// Unsaved texts of a tab, to be kept in place of those before.
#[derive(Deserialize)]
pub struct KeepDraftRequest {
    /// Name of the tab: 32 hexadecimal digits.
    pub tab: String,
    /// The path by which they were opened.
    pub path: String,
    /// The model, where it has changed.
    #[serde(default)]
    pub model: Option<DraftText>,
    /// The study, where it has changed.
    #[serde(default)]
    pub study: Option<DraftText>,
}

/// A path whose unsaved texts a tab asks for.
#[derive(Deserialize)]
pub struct TakeDraftRequest {
    /// Name of the tab.
    pub tab: String,
    /// The path.
    pub path: String,
}

/// Unsaved texts that belong to the tab from now on.
#[derive(Serialize)]
pub struct TakeDraftAnswer {
    /// They, where there are any.
    pub draft: Option<Draft>,
    /// Another tab that is open has unsaved texts of the path.
    pub is_elsewhere: bool,
}

/// A template, or two texts, to be made a mechanism of one's own.
#[derive(Deserialize)]
pub struct NewRequest {
    /// Name of the template; `None` where both texts are given.
    #[serde(default)]
    pub template: Option<String>,
    /// Text of the model.
    #[serde(default)]
    pub model: Option<String>,
    /// Text of the study.
    #[serde(default)]
    pub study: Option<String>,
    /// Name of the new folder.
    pub folder: String,
}

/// A model and a study were written.
#[derive(Serialize)]
pub struct NewAnswer {
    /// Path of the model.
    pub model: String,
    /// Path of the study.
    pub study: String,
    /// Tag of the text of the model.
    pub model_tag: String,
    /// Tag of the text of the study.
    pub study_tag: String,
}

/// Both texts of a template, or of an empty sheet.
#[derive(Serialize)]
pub struct TemplateTexts {
    /// The model.
    pub model: &'static str,
    /// The study.
    pub study: &'static str,
}

/// A model, a study or a result that goes into the trash.
#[derive(Deserialize)]
pub struct TrashRequest {
    /// Path of the file, or of the folder of the result.
    pub path: String,
}

/// What was deleted, to be moved back.
#[derive(Deserialize)]
pub struct RestoreRequest {
    /// Its entry in the trash.
    pub entry: String,
    /// The paths that it had.
    pub paths: Vec<String>,
}

/// What was deleted is back.
#[derive(Serialize)]
pub struct RestoreAnswer {
    /// Number of files and folders.
    pub restored: usize,
}

/// A model or a study, with its model, to be copied.
#[derive(Deserialize)]
pub struct DuplicateRequest {
    /// Its path.
    pub path: String,
}

/// Paths of a copy.
#[derive(Serialize)]
pub struct DuplicateAnswer {
    /// The model.
    pub model: Option<String>,
    /// The study.
    pub study: Option<String>,
}

/// Destination of a drawing in the DXF format.
#[derive(Deserialize)]
pub struct ImportRequest {
    /// Path of the new folder.
    pub folder: String,
    /// Name of the mechanism.
    pub title: String,
    /// Unit of the drawing, where it names none itself.
    pub unit: Option<String>,
}

/// Result of an import of a drawing in the DXF format.
#[derive(Serialize)]
pub struct ImportAnswer {
    /// Path of the model.
    pub model: String,
    /// Findings in the drawing, and omitted parts.
    pub notes: Vec<String>,
}

/// Meaning of a code of a diagnostic.
#[derive(Serialize)]
pub struct ExplainAnswer {
    /// The code.
    pub code: &'static str,
    /// In a few words.
    pub title: &'static str,
    /// In whole.
    pub text: &'static str,
}

/// A report to be shown.
#[derive(Deserialize)]
pub struct ViewRequest {
    /// Path of the folder of the result.
    pub path: String,
}

/// Address at which a report is shown once.
#[derive(Serialize)]
pub struct ViewAnswer {
    /// Its address.
    pub address: String,
}

/// Two studies to be shown beside each other.
#[derive(Deserialize)]
pub struct CompareRequest {
    /// Path of the result A.
    pub before: String,
    /// Path of the result B.
    pub after: String,
}

/// Both studies beside each other.
#[derive(Serialize)]
pub struct CompareAnswer(pub Comparison);

/// A result of which it is asked what can be done with it.
#[derive(Deserialize)]
pub struct ResultRequest {
    /// Path of its folder.
    pub path: String,
}

/// Values of a result to be taken into the texts of the page.
#[derive(Deserialize)]
pub struct AdoptRequest {
    /// The model.
    pub model: SentText,
    /// The study of it, where there is one.
    pub study: Option<SentText>,
    /// Path of the folder of the result.
    pub path: String,
    /// Place among the values that it lists.
    pub place: usize,
}

/// Both texts with the values of a result in them, or why they do not take them.
#[derive(Serialize)]
pub struct AdoptAnswer {
    /// They.
    pub adopted: Option<AdoptedTexts>,
    /// Why not.
    pub refusal: Option<Refused>,
}

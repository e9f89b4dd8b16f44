//! Why readings say nothing of the plays.

use loosepin_mechanics::model::QuantityError;
use loosepin_simulate::accuracy::AccuracyError;
use loosepin_text::diagnostics::{Code, problems};
use loosepin_text::document::listed;

/// Largest confidence: beyond it quantiles of the normal distribution lose their digits, and no error of a reading is known so well.
pub const MAX_CONFIDENCE: f64 = 0.999_999_999;

/// Why a reading has no linear model.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The mechanism does not settle there.
    Accuracy(AccuracyError),
    /// A contact law does not carry the push.
    TooLoaded { joint: String },
}

impl From<AccuracyError> for Failure {
    fn from(error: AccuracyError) -> Self {
        Self::Accuracy(error)
    }
}

problems! {
    /// Why nothing can be identified.
    #[derive(Debug, Clone, PartialEq)]
    pub enum IdentifyProblem {
        NoReadings => Code::NothingAsked,
            says("the study has no readings"),
            hint("add [[measured]] with output, pose, force, dead_travel and the error of the reading");
        PinsLean => Code::ConflictingKeys,
            says("pins of the model lean out of the plane, which readings are not compared with"),
            hint("write lean = \"held\" in the model, and measure where nothing leans");
        NoPlay => Code::NothingUncertain,
            says("no input of the study is the play of a joint, so there is nothing to identify"),
            hint("add one under [epistemic], for example \"joint.pin.radial_clearance\" = {{ interval = [\"0.01 mm\", \"0.5 mm\"] }}");
        Flexible { body: String } => Code::NoQuasiStaticAnswer,
            says("body '{body}' bends under a push; the identification does not model this yet"),
            hint("give it a mass and an inertia instead of its beam, and subtract its bending from the readings");
        PlayMovesGeometry { path: String } => Code::AskNotPossible,
            says("'{path}' is both a play and a dimension: it moves the mechanism, not only its journals"),
            hint("give the clearance its own parameter");
        PlayNotLinear { path: String } => Code::AskNotPossible,
            says("the clearances are not linear in '{path}'"),
            hint("use the clearance of the joint itself under [epistemic]");
        Conditioned => Code::AskNotPossible,
            says("this study already has the lengths of a measured specimen ([specimen]), so the measurement would count twice"),
            hint("identify the original study, from which this one was written");
        NoMotion => Code::AskNotPossible,
            says("only features of a motion (kind = \"motion\") depend on the lengths; readings of dead travel are used for all lengths within \
                  their intervals"),
            hint("omit --lengths, or add features of a motion");
        NoLengths { reason: String } => Code::AskNotPossible,
            says("no mechanisms are written: {reason}");
        UnknownSpecimen { name: String, known: Vec<String> } => Code::UnknownReference,
            says("there are no measurements of a specimen '{name}'"),
            hint_of(Some(if known.is_empty() {
                "no measurement names a specimen: omit --specimen".to_owned()
            } else {
                format!("available: {}", listed(known, "and"))
            }));
        SeveralSpecimens { found: usize } => Code::AskNotPossible,
            says("the readings are from {found} specimens; a study can be narrowed to only one of them"),
            hint("choose one: --specimen NAME");
        Unexplained { specimen: Option<String> } => Code::AskNotPossible,
            says("no values explain {}", match specimen {
                Some(name) => format!("the measurements of specimen '{name}'"),
                None => "the measurements".to_owned(),
            }),
            hint("check the readings, their errors and the intervals; the study is not narrowed");
        Contradiction { path: String } => Code::AskNotPossible,
            says("no value of '{path}' agrees with both the dead travels and the motion"),
            hint("check the readings and the features; the study is not narrowed");
        NoJson { reason: String } => Code::ResultNotStorable,
            says("the result cannot be written as JSON: {reason}");
        LiftOff { play: String } => Code::NoQuasiStaticAnswer,
            says("{play} can lift off its cam, so a push moves it without limit"),
            hint("guide the follower in a groove with backlash");
        Unknowns { found: usize, most: usize } => Code::NothingUncertain,
            says("the study has {found} inputs under [epistemic]; an identification from motion needs 1 to {most}"),
            hint("keep only the inputs to be identified under [epistemic]; give all others a value or a distribution");
        NotMeasured { feature: String } => Code::AskNotPossible,
            says("'{feature}' has no value"),
            hint("write value = ... or file = ..., or use --plan to see how much it would narrow the unknowns");
        NothingImagined { runs: usize } => Code::AllRunsFailed,
            says("all {runs} runs of simulated measurements failed, so the features cannot be compared"),
            hint("`loosepin check` makes one run of the study and shows why it fails");
        MotionConfidence { found: f64 } => Code::BadProbability,
            says("the confidence is {found}; must be between 0.5 and 0.99998: a higher one needs more than 100000 runs at each value");
        Confidence { found: f64 } => Code::BadProbability,
            says("the confidence is {found}; must be from 0.5 to {MAX_CONFIDENCE}");
        Locked { reading: String, error: AccuracyError } => error.code(),
            says("{reading}: {error}"),
            hint_of(error.hint());
        TooLoaded { reading: String, joint: String } => Code::NoQuasiStaticAnswer,
            says("{reading}: the push loads '{joint}' with a larger force than its contact law can give"),
            hint("use a smaller push, or a contact law with a larger range");
        DoesNotMove { reading: String } => Code::AskNotPossible,
            says("{reading}: this push moves no play, so its dead travel contains no information"),
            hint("push a point that can move while the drive is locked, in a direction in which it can move");
        Values { error: QuantityError } => error.code(),
            says("{error}"),
            hint_of(error.hint());
        NotBeside { file: String, folder: String } => Code::FolderNotUsable,
            says("{file} is not in {folder}, the folder of the study; the path of its model is relative to this folder"),
            hint("write it into the folder of the study");
        Exists { file: String } => Code::FileExists,
            says("{file} exists already; nothing is overwritten"),
            hint("choose another name, or remove it");
        NotWritten { file: String, reason: String } => Code::FolderNotUsable,
            says("{file} cannot be written: {reason}");
    }
}

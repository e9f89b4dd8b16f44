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
            hint("add [[measured]] with output, pose, force, dead_travel and its error");
        NoPlay => Code::NothingUncertain,
            says("no input of the study is the play of a joint: there is nothing to identify"),
            hint("name one under [epistemic], for example \"joint.pin.radial_clearance\" = {{ interval = [\"0.01 mm\", \"0.5 mm\"] }}");
        Flexible { body: String } => Code::NoQuasiStaticAnswer,
            says("body '{body}' bends under a push, which is not computed yet"),
            hint("give it a mass and an inertia in place of its beam, and take off the readings what it bends");
        PlayMovesGeometry { path: String } => Code::AskNotPossible,
            says("'{path}' is a play and a dimension at once: it moves the mechanism, and not only its journals"),
            hint("give the clearance a parameter of its own");
        PlayNotLinear { path: String } => Code::AskNotPossible,
            says("the clearances do not follow '{path}' in a straight line"),
            hint("name the clearance of the joint itself under [epistemic]");
        Conditioned => Code::AskNotPossible,
            says("the lengths of this study are those of a measured specimen already ([specimen]): the measurement would count twice"),
            hint("identify the study that it was written from");
        NoMotion => Code::AskNotPossible,
            says("only features of a motion say something of lengths (kind = \"motion\"); dead travels hold for all lengths within their intervals"),
            hint("leave --lengths out, or add features of a motion");
        NoLengths { reason: String } => Code::AskNotPossible,
            says("no mechanisms are written: {reason}");
        UnknownSpecimen { name: String, known: Vec<String> } => Code::UnknownReference,
            says("nothing was measured at a specimen '{name}'"),
            hint_of(Some(if known.is_empty() {
                "nothing measured names a specimen: leave --specimen out".to_owned()
            } else {
                format!("there is {}", listed(known, "and"))
            }));
        SeveralSpecimens { found: usize } => Code::AskNotPossible,
            says("the readings are of {found} specimens; a study is narrowed to one of them"),
            hint("name it: --specimen NAME");
        Unexplained { specimen: Option<String> } => Code::AskNotPossible,
            says("no values explain {}", match specimen {
                Some(name) => format!("what was measured at specimen '{name}'"),
                None => "what was measured".to_owned(),
            }),
            hint("no study is narrowed by what nothing explains");
        Contradiction { path: String } => Code::AskNotPossible,
            says("the dead travels and the motion leave no value of '{path}' in common"),
            hint("no study is narrowed by what contradicts itself");
        NoJson { reason: String } => Code::ResultNotStorable,
            says("the result has no form in JSON: {reason}");
        LiftOff { play: String } => Code::NoQuasiStaticAnswer,
            says("{play} may lift off its cam, and goes then as far as it is pushed"),
            hint("hold the follower with a groove, which has backlash");
        Unknowns { found: usize, most: usize } => Code::NothingUncertain,
            says("the study has {found} inputs under [epistemic]; an identification from motion needs 1 to {most}"),
            hint("name what is to be identified, with its interval; give everything else a value or a distribution");
        NotMeasured { feature: String } => Code::AskNotPossible,
            says("'{feature}' has no value"),
            hint("write value = ... or file = ..., or ask with --plan what it would tell");
        NothingImagined { runs: usize } => Code::AllRunsFailed,
            says("all {runs} runs of measurements that were to be imagined failed: nothing can be said of what features would tell"),
            hint("`loosepin check` runs the study once and says why it fails");
        MotionConfidence { found: f64 } => Code::BadProbability,
            says("the confidence is {found}; must be between 0.5 and 0.99998: of a higher one more than 100000 runs at each value would be needed");
        Confidence { found: f64 } => Code::BadProbability,
            says("the confidence is {found}; must be from 0.5 to {MAX_CONFIDENCE}");
        Locked { reading: String, error: AccuracyError } => error.code(),
            says("{reading}: {error}"),
            hint_of(error.hint());
        TooLoaded { reading: String, joint: String } => Code::NoQuasiStaticAnswer,
            says("{reading}: the push loads '{joint}' by more than its contact law carries"),
            hint("push with less, or give the contact a law that reaches deeper");
        DoesNotMove { reading: String } => Code::AskNotPossible,
            says("{reading}: no play gives way to this push, so that its dead travel says nothing"),
            hint("push a point that moves with the drive locked, in a direction that it can go");
        Values { error: QuantityError } => error.code(),
            says("{error}"),
            hint_of(error.hint());
        NotBeside { file: String, folder: String } => Code::FolderNotUsable,
            says("{file} is not in {folder}, the folder of the study, from which it names its model"),
            hint("write it beside the study");
        Exists { file: String } => Code::FileExists,
            says("{file} exists already; nothing is overwritten"),
            hint("choose another name, or remove it");
        NotWritten { file: String, reason: String } => Code::FolderNotUsable,
            says("{file} cannot be written: {reason}");
    }
}

//! Errors of the quasi-static answer as diagnostics at a place of the model file.

use super::error::AccuracyError;
use loosepin_mechanics::model::Model;
use loosepin_text::diagnostics::{Code, Diagnostic, Problem};

impl Problem for AccuracyError {
    fn code(&self) -> Code {
        match self {
            Self::Sample(error) => error.code(),
            Self::Quantity(error) => error.code(),
            Self::NotDriven => Code::TooFewDrives,
            Self::StandsStill { .. } => Code::DriveStandsStill,
            Self::TooFewPositions { .. } => Code::BadCount,
            Self::TooLong { .. } => Code::BreaksRule,
            Self::BadStandardDeviation { .. } => Code::BadDistribution,
            Self::CannotCloseWithPlay { .. } => Code::CannotClose,
            Self::SingularWithPlay => Code::SingularPosition,
            Self::TurnsOver { .. } => Code::NoQuasiStaticAnswer,
            Self::Stopped => Code::Interrupted,
        }
    }

    fn hint(&self) -> Option<String> {
        match self {
            Self::Sample(error) => error.hint(),
            Self::Quantity(error) => error.hint(),
            Self::NotDriven => Some(
                "use `loosepin simulate` or a study: their ideal motion is that under the same forces without play"
                    .to_owned(),
            ),
            Self::StandsStill { .. } => Some("give it a speed, or use another drive in [cycle]".to_owned()),
            Self::TooLong { .. } => Some(
                "slow it down, or make the cycle shorter: [cycle] may count its turns where it turns evenly".to_owned(),
            ),
            Self::TooFewPositions { .. } | Self::BadStandardDeviation { .. } | Self::Stopped => None,
            Self::TurnsOver { .. } => Some("make the slider longer, or the clearance smaller".to_owned()),
            Self::CannotCloseWithPlay { .. } | Self::SingularWithPlay => {
                Some("so close to a dead point, only a dynamic run shows the effect of the play".to_owned())
            }
        }
    }
}

impl AccuracyError {
    /// The diagnostic at the part of the model that it concerns.
    pub fn diagnostic(&self, model: &Model) -> Diagnostic {
        match self {
            Self::Sample(error) => error.diagnostic(model),
            Self::Quantity(error) => Diagnostic::error(error, model.place(error.path())),
            Self::NotDriven => Diagnostic::error(self, model.place("initial")),
            Self::StandsStill { drive } => Diagnostic::error(self, model.place(&format!("drive.{drive}.speed"))),
            Self::BadStandardDeviation { path, .. } => Diagnostic::error(self, model.place(path)),
            Self::CannotCloseWithPlay { open } => Diagnostic::error(self, model.place(&open.path)),
            Self::TurnsOver { joint } => Diagnostic::error(self, model.place(&format!("joint.{joint}"))),
            Self::TooLong { drive, .. } => Diagnostic::error(self, model.place(&format!("drive.{drive}"))),
            Self::TooFewPositions { .. } | Self::SingularWithPlay | Self::Stopped => Diagnostic::error(self, None),
        }
    }
}

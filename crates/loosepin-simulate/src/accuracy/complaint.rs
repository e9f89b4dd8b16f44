//! Errors of the quasi-static answer as complaints at a place of the model file.

use super::error::AccuracyError;
use loosepin_mechanics::model::Model;
use loosepin_text::diagnostics::{Code, Complaint, Problem};

impl Problem for AccuracyError {
    fn code(&self) -> Code {
        match self {
            Self::Sample(error) => error.code(),
            Self::Quantity(error) => error.code(),
            Self::NotDriven => Code::TooFewDrives,
            Self::StandsStill { .. } => Code::DriveStandsStill,
            Self::TooFewPositions { .. } => Code::BadCount,
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
            Self::NotDriven => Some("use `loosepin simulate`, which computes the motion from the forces".to_owned()),
            Self::StandsStill { .. } => Some("give it a speed, or use another drive in [cycle]".to_owned()),
            Self::TooFewPositions { .. } | Self::BadStandardDeviation { .. } | Self::Stopped => None,
            Self::TurnsOver { .. } => Some("make the slider longer, or the clearance smaller".to_owned()),
            Self::CannotCloseWithPlay { .. } | Self::SingularWithPlay => {
                Some("so close to a dead point, only a dynamic run shows the effect of the play".to_owned())
            }
        }
    }
}

impl AccuracyError {
    /// The complaint about the model, at what it is about.
    pub fn complaint(&self, model: &Model) -> Complaint {
        match self {
            Self::Sample(error) => error.complaint(model),
            Self::Quantity(error) => Complaint::error(error, model.place(error.path())),
            Self::NotDriven => Complaint::error(self, model.place("initial")),
            Self::StandsStill { drive } => Complaint::error(self, model.place(&format!("drive.{drive}.speed"))),
            Self::BadStandardDeviation { path, .. } => Complaint::error(self, model.place(path)),
            Self::CannotCloseWithPlay { open } => Complaint::error(self, model.place(&open.path)),
            Self::TurnsOver { joint } => Complaint::error(self, model.place(&format!("joint.{joint}"))),
            Self::TooFewPositions { .. } | Self::SingularWithPlay | Self::Stopped => Complaint::error(self, None),
        }
    }
}

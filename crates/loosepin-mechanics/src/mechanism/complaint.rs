//! Compile and sample errors as complaints at a place of the model file.

use super::error::{MechanismError, SampleError};
use crate::model::{CycleSpan, Model};
use loosepin_text::diagnostics::{Code, Complaint, Place, Problem};

impl Problem for MechanismError {
    fn code(&self) -> Code {
        match self {
            Self::Quantity(error) => error.code(),
            Self::TooFewDrives { .. } => Code::TooFewDrives,
            Self::TooManyDrives { .. } => Code::TooManyDrives,
            Self::DrivenLoop { .. } => Code::DrivenLoop,
            Self::CarriedNotDetermined { .. } => Code::FrictionNotPossible,
            Self::CannotClose { .. } => Code::CannotClose,
            Self::SingularStart { .. } => Code::SingularPosition,
            Self::StartNotDetermined { .. }
            | Self::StartNotNeeded
            | Self::StartContradicts { .. }
            | Self::CannotCloseAsGiven { .. } => Code::StartNotPossible,
            Self::NothingToControl { .. } | Self::NoInverseDynamics { .. } => Code::ControlNotPossible,
        }
    }

    fn hint(&self) -> Option<String> {
        let hint = match self {
            Self::Quantity(error) => return error.hint(),
            Self::TooFewDrives { .. } => {
                "add a drive, or a joint that holds what can still move; what only forces move needs its start under \
                 [initial]"
            }
            Self::StartNotDetermined { is_rate: false, .. } => {
                "give the angle or position of one of them under [initial]"
            }
            Self::StartNotDetermined { .. } => "give the angular velocity or velocity of one of them under [initial]",
            Self::StartNotNeeded => "remove [initial], or a drive",
            Self::StartContradicts { .. } => "leave it out: it follows from the others; or change those",
            Self::CannotCloseAsGiven { .. } => "leave out what follows from the other values under [initial]",
            Self::NothingToControl { .. } => "remove the drive of what the control is to move, or the control",
            Self::NoInverseDynamics { .. } => {
                "it is worked out for open chains on the ground whose every joint is driven or controlled; feed forward an \
                 expression over time instead, or nothing"
            }
            Self::TooManyDrives { .. } => "remove a drive",
            Self::CarriedNotDetermined { .. } => "remove what holds the mechanism twice, or the friction",
            Self::DrivenLoop { .. } => "remove one of the drives of this loop",
            Self::CannotClose { .. } => {
                "check the lengths and the start angle; if the loop does close, give [assembly] guess an angle near the \
                 true one"
            }
            Self::SingularStart { .. } => "start the drive a few degrees away",
        };
        Some(hint.to_owned())
    }
}

impl MechanismError {
    /// The complaint about the model that could not be compiled, at the joint, body or drive that it is about.
    pub fn complaint(&self, model: &Model) -> Complaint {
        match self {
            Self::Quantity(error) => Complaint::error(error, model.place(error.path())),
            Self::TooFewDrives { undetermined: bodies, .. } | Self::SingularStart { bodies } => {
                labelled(self, bodies.iter().map(|body| model.place(&format!("body.{body}"))), "this can move too")
            }
            Self::StartNotDetermined { bodies, .. } => labelled(
                self,
                bodies.iter().map(|body| model.place(&format!("body.{body}"))),
                "this is not determined either",
            ),
            Self::StartNotNeeded | Self::CannotCloseAsGiven { .. } => Complaint::error(self, model.place("initial")),
            Self::StartContradicts { path, .. } => Complaint::error(self, model.place(path)),
            Self::NothingToControl { control } | Self::NoInverseDynamics { control, .. } => {
                Complaint::error(self, model.place(&format!("control.{control}")))
            }
            Self::TooManyDrives { .. } => {
                // The last drive is as good as any; the others are shown beside it.
                let drives = model.drives.iter().rev().map(|drive| model.place(&format!("drive.{}", drive.name)));
                labelled(self, drives, "this is driven too")
            }
            Self::DrivenLoop { joint } | Self::CarriedNotDetermined { joint } => {
                Complaint::error(self, model.place(&format!("joint.{joint}")))
            }
            Self::CannotClose { open } => Complaint::error(self, model.place(&open.path)),
        }
    }
}

/// A complaint at the first place, with the others beside it.
fn labelled(error: &MechanismError, mut places: impl Iterator<Item = Option<Place>>, text: &str) -> Complaint {
    let complaint = Complaint::error(error, places.next().flatten());
    places.flatten().fold(complaint, |complaint, place| complaint.with_label(place, text))
}

impl Problem for SampleError {
    fn code(&self) -> Code {
        match self {
            Self::Quantity(error) => error.code(),
            Self::ClearanceChangesTopology { .. } => Code::ClearanceTouchesZero,
            Self::ClearanceOutsideFit { .. } => Code::ClearanceOutsideFit,
            Self::RoughnessOutsideFilm { .. } => Code::RoughnessOutsideFilm,
            Self::CannotClose { .. } => Code::CannotClose,
            Self::StartContradicts { .. } => Code::StartNotPossible,
            Self::Singular { .. } => Code::SingularPosition,
        }
    }

    fn hint(&self) -> Option<String> {
        let hint = match self {
            Self::Quantity(error) => return error.hint(),
            Self::ClearanceChangesTopology { .. } => "with and without play are two mechanisms; run them one by one",
            Self::ClearanceOutsideFit { .. } => "take another law for this clearance",
            Self::RoughnessOutsideFilm { .. } => {
                "the roughness is the thickness below which the film no longer stiffens"
            }
            Self::CannotClose { .. } => "the lengths do not allow the whole turn; check them, or drive another joint",
            Self::StartContradicts { .. } => "leave it out: it follows from the others; or change those",
            Self::Singular { .. } => "drive another joint, or stay away from this position",
        };
        Some(hint.to_owned())
    }
}

impl SampleError {
    /// The complaint about the model whose values give no motion.
    pub fn complaint(&self, model: &Model) -> Complaint {
        let path = match self {
            Self::Quantity(error) => return Complaint::error(error, model.place(error.path())),
            Self::ClearanceChangesTopology { joint, .. }
            | Self::ClearanceOutsideFit { joint, .. }
            | Self::RoughnessOutsideFilm { joint, .. } => format!("joint.{joint}.radial_clearance"),
            Self::CannotClose { open, .. } => open.path.clone(),
            Self::StartContradicts { path, .. } => path.clone(),
            Self::Singular { .. } => match model.cycle.span {
                CycleSpan::Turns(drive) | CycleSpan::Periods(drive) => format!("drive.{}", model.drives[drive.0].name),
                CycleSpan::Duration(_) => "cycle".to_owned(),
            },
        };
        Complaint::error(self, model.place(&path))
    }
}

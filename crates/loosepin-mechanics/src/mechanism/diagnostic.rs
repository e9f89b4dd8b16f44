//! Compile and sample errors as diagnostics at a place of the model file.

use super::error::{MechanismError, SampleError};
use crate::mechanism::tree::blocking::{Blocking, blocking};
use crate::model::{CycleSpan, Model};
use loosepin_text::diagnostics::{Diagnostic, Place, Problem};

impl MechanismError {
    /// The diagnostic about the model that could not be compiled, at the joint, body or drive that it is about.
    pub fn diagnostic(&self, model: &Model) -> Diagnostic {
        let may_be_blocked = match self {
            Self::CannotClose { .. } | Self::CannotCloseAsGiven { .. } | Self::SingularStart { .. } => true,
            Self::TooManyDrives { mobility, .. } => *mobility == 0,
            _ => false,
        };
        if let Some(blocking) = may_be_blocked.then(|| blocking(model)).flatten() {
            return blocking.diagnostic(model);
        }
        match self {
            Self::Quantity(error) => Diagnostic::error(error, model.place(error.path())),
            Self::TooFewDrives { undetermined: bodies, .. } | Self::SingularStart { bodies } => {
                labelled(self, bodies.iter().map(|body| model.place(&format!("body.{body}"))), "this can move too")
            }
            Self::StartNotDetermined { bodies, .. } => labelled(
                self,
                bodies.iter().map(|body| model.place(&format!("body.{body}"))),
                "this is not determined either",
            ),
            Self::StartNotNeeded | Self::CannotCloseAsGiven { .. } => Diagnostic::error(self, model.place("initial")),
            Self::StartContradicts { path, .. }
            | Self::PitchCirclesApart { path, .. }
            | Self::OffsetOfFreeMotion { path } => Diagnostic::error(self, model.place(path)),
            Self::NothingToControl { control } | Self::NoInverseDynamics { control, .. } => {
                Diagnostic::error(self, model.place(&format!("control.{control}")))
            }
            Self::TooManyDrives { .. } => {
                // The last drive is as good as any; the others are shown beside it.
                let drives = model.drives.iter().rev().map(|drive| model.place(&format!("drive.{}", drive.name)));
                labelled(self, drives, "this is driven too")
            }
            Self::DrivenLoop { joint } | Self::CarriedNotDetermined { joint } => {
                Diagnostic::error(self, model.place(&format!("joint.{joint}")))
            }
            Self::BeamHangs { body } => Diagnostic::error(self, model.place(&format!("body.{body}.beam"))),
            Self::BeyondBeam { body, point } => {
                Diagnostic::error(self, model.place(&format!("body.{body}.points.{point}")))
            }
            Self::CannotClose { open, .. } => Diagnostic::error(self, model.place(&open.path)),
            Self::ClosesTurned { path, .. } => Diagnostic::error(self, model.place(path)),
        }
    }
}

impl Blocking {
    /// The diagnostic at the last of the drives or joints, the others beside it.
    fn diagnostic(&self, model: &Model) -> Diagnostic {
        let (kind, names, text) = match self {
            Self::Drives { drives } => ("drive", drives, "this moves the same freedom"),
            Self::Joints { joints } => ("joint", joints, "this holds the others too"),
        };
        labelled(self, names.iter().rev().map(|name| model.place(&format!("{kind}.{name}"))), text)
    }
}

/// A diagnostic at the first place, with the others beside it.
fn labelled(error: &dyn Problem, mut places: impl Iterator<Item = Option<Place>>, text: &str) -> Diagnostic {
    let diagnostic = Diagnostic::error(error, places.next().flatten());
    places.flatten().fold(diagnostic, |diagnostic, place| diagnostic.with_label(place, text))
}

impl SampleError {
    /// The diagnostic about the model whose values give no motion.
    pub fn diagnostic(&self, model: &Model) -> Diagnostic {
        if let Some(blocking) = matches!(self, Self::CannotClose { .. }).then(|| blocking(model)).flatten() {
            return blocking.diagnostic(model);
        }
        let path = match self {
            Self::Quantity(error) => return Diagnostic::error(error, model.place(error.path())),
            Self::ClearanceChangesTopology { joint, .. }
            | Self::ClearanceOutsideFit { joint, .. }
            | Self::RoughnessOutsideFilm { joint, .. } => format!("joint.{joint}.radial_clearance"),
            Self::LengthOutsideFilm { joint, .. } => format!("joint.{joint}.bearing_length"),
            Self::BacklashChangesTopology { path, .. } => format!("{path}.backlash"),
            Self::PointOffSection { body, point, .. } => format!("body.{body}.points.{point}"),
            Self::CannotClose { open, .. } => open.path.clone(),
            Self::StartContradicts { path, .. } | Self::OffsetBeyondPlay { path, .. } => path.clone(),
            Self::Period(problem) => format!("load.{}", problem.load()),
            Self::DriveWithoutValue { drive, .. } => format!("drive.{drive}"),
            Self::Singular { .. } => match model.cycle.span {
                CycleSpan::Turns(drive) | CycleSpan::Periods(drive) => format!("drive.{}", model.drives[drive.0].name),
                CycleSpan::Duration(_) => "cycle".to_owned(),
            },
        };
        Diagnostic::error(self, model.place(&path))
    }
}

//! Why a run ends without a result.

use loosepin_mechanics::mechanism::SampleError;
use loosepin_mechanics::model::Model;
use loosepin_text::diagnostics::{Code, Complaint, Problem};
use loosepin_text::units::{Dimension, format_value};
use thiserror::Error;

/// The one reason why a run failed.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum RunFailure {
    /// The sample is impossible or its loops cannot close.
    #[error(transparent)]
    Sample(#[from] SampleError),
    /// The step became too small.
    #[error(
        "at {} the step fell to {step_s:.1e} s, below the smallest of {smallest_s:.1e} s",
        format_value(*time_s, Dimension::TIME)
    )]
    StepTooSmall {
        /// Time, s.
        time_s: f64,
        /// The step, s.
        step_s: f64,
        /// The smallest step, s.
        smallest_s: f64,
    },
    /// A position or velocity is not a number.
    #[error("at {} a position or velocity is not a finite number", format_value(*time_s, Dimension::TIME))]
    NotFinite {
        /// Time, s.
        time_s: f64,
    },
    /// The drive whose turns are counted does not turn.
    #[error("drive '{drive}' stands still: its turns cannot be counted")]
    StandsStill {
        /// The drive.
        drive: String,
    },
    /// The penetration is so deep that the pin's centre leaves the hole: no contact law means anything there.
    #[error(
        "at {time_s} s the pin of joint '{joint}' is pressed {:.4} mm into its hole of radius {:.4} mm: beyond any contact law",
        penetration_m * 1e3,
        bearing_radius_m * 1e3
    )]
    LeavesBearing {
        /// The joint.
        joint: String,
        /// Penetration, m.
        penetration_m: f64,
        /// Radius of the bearing, m.
        bearing_radius_m: f64,
        /// Time, s.
        time_s: f64,
    },
    /// The penetration is so deep that the slider's axis leaves the guide.
    #[error(
        "at {} a corner of the slider of joint '{joint}' is pressed {} into its guide; its half-height is {}",
        format_value(*time_s, Dimension::TIME),
        format_value(*penetration_m, Dimension::LENGTH),
        format_value(*half_height_m, Dimension::LENGTH)
    )]
    LeavesGuide {
        /// The joint.
        joint: String,
        /// Penetration, m.
        penetration_m: f64,
        /// Half-height of the slider, m.
        half_height_m: f64,
        /// Time, s.
        time_s: f64,
    },
    /// A corner leaves the faces of its guide.
    #[error(
        "at {} the corner {contact} of the slider is at {} of its guide, whose faces reach from {} to {}",
        format_value(*time_s, Dimension::TIME),
        format_value(*along_m, Dimension::LENGTH),
        format_value(ends_m[0], Dimension::LENGTH),
        format_value(ends_m[1], Dimension::LENGTH)
    )]
    BeyondGuide {
        /// The corner, with the name of its joint.
        contact: String,
        /// The joint.
        joint: String,
        /// Abscissa of the corner along the guide, m.
        along_m: f64,
        /// Where the faces begin and end, m.
        ends_m: [f64; 2],
        /// Time, s.
        time_s: f64,
    },
    /// The penetration is deeper than the contact law can tell a force for.
    #[error(
        "at {} the pin of joint '{joint}' is pressed {} into its hole; '{law}' has a force up to {}",
        format_value(*time_s, Dimension::TIME),
        format_value(*penetration_m, Dimension::LENGTH),
        format_value(*limit_m, Dimension::LENGTH)
    )]
    BeyondLaw {
        /// The joint.
        joint: String,
        /// The law.
        law: &'static str,
        /// Penetration, m.
        penetration_m: f64,
        /// The largest penetration for which the law has a force, m.
        limit_m: f64,
        /// Time, s.
        time_s: f64,
    },
    /// The limit of evaluations is reached.
    #[error("at {} the limit of {limit} evaluations was reached", format_value(*time_s, Dimension::TIME))]
    TooManyEvaluations {
        /// Time, s.
        time_s: f64,
        /// The limit.
        limit: u64,
    },
    /// More rows than a history can hold.
    #[error("{rows} rows would be recorded; must be at most {most}")]
    TooManyRows {
        /// Turns times rows a turn.
        rows: f64,
        /// The limit.
        most: usize,
    },
    /// Friction in an ideal joint has no solution.
    #[error("at {} joint '{joint}' jams: no friction force fits what it carries", format_value(*time_s, Dimension::TIME))]
    Jams {
        /// The joint.
        joint: String,
        /// Time, s.
        time_s: f64,
    },
    /// Whoever looked at the run has stopped it.
    #[error("stopped at {} of its time", format_value(*time_s, Dimension::TIME))]
    Stopped {
        /// Time, s.
        time_s: f64,
    },
    /// The drives leave nothing free that a neighbouring motion could differ in.
    #[error("the drives alone move the mechanism: no motion lies beside it, and there is no Lyapunov exponent")]
    NothingIsFree,
}

/// Short names of all reasons, in the order of [`RunFailure::number`].
const CODES: [&str; 19] = [
    "impossible_value",
    "clearance_changes_topology",
    "cannot_close",
    "singular_position",
    "step_too_small",
    "not_finite",
    "drive_stands_still",
    "too_many_evaluations",
    "too_many_rows",
    "pin_leaves_bearing",
    "beyond_contact_law",
    "clearance_outside_fit",
    "start_contradicts",
    "roughness_outside_film",
    "nothing_is_free",
    "joint_jams",
    "slider_leaves_guide",
    "slider_beyond_guide",
    "stopped",
];

impl RunFailure {
    /// A short name for tables.
    pub fn code(&self) -> &'static str {
        Self::code_of(self.number())
    }

    /// A number for tables.
    pub fn number(&self) -> u16 {
        match self {
            Self::Sample(SampleError::Quantity(_)) => 0,
            Self::Sample(SampleError::ClearanceChangesTopology { .. }) => 1,
            Self::Sample(SampleError::CannotClose { .. }) => 2,
            Self::Sample(SampleError::Singular { .. }) => 3,
            Self::StepTooSmall { .. } => 4,
            Self::NotFinite { .. } => 5,
            Self::StandsStill { .. } => 6,
            Self::TooManyEvaluations { .. } => 7,
            Self::TooManyRows { .. } => 8,
            Self::LeavesBearing { .. } => 9,
            Self::BeyondLaw { .. } => 10,
            Self::Sample(SampleError::ClearanceOutsideFit { .. }) => 11,
            Self::Sample(SampleError::StartContradicts { .. }) => 12,
            Self::Sample(SampleError::RoughnessOutsideFilm { .. }) => 13,
            Self::NothingIsFree => 14,
            Self::Jams { .. } => 15,
            Self::LeavesGuide { .. } => 16,
            Self::BeyondGuide { .. } => 17,
            Self::Stopped { .. } => 18,
        }
    }

    /// The short name of a number that [`Self::number`] gave.
    pub fn code_of(number: u16) -> &'static str {
        CODES.get(usize::from(number)).copied().unwrap_or("unknown")
    }
}

impl Problem for RunFailure {
    fn code(&self) -> Code {
        match self {
            Self::Sample(error) => error.code(),
            Self::StandsStill { .. } => Code::DriveStandsStill,
            Self::StepTooSmall { .. } => Code::StepTooSmall,
            Self::NotFinite { .. } => Code::RunNotFinite,
            Self::TooManyEvaluations { .. } => Code::RunTooLong,
            Self::TooManyRows { .. } => Code::BadCount,
            Self::LeavesBearing { .. } | Self::LeavesGuide { .. } => Code::PinLeavesBearing,
            Self::BeyondGuide { .. } => Code::SliderBeyondGuide,
            Self::BeyondLaw { .. } => Code::BeyondContactLaw,
            Self::NothingIsFree => Code::NothingIsFree,
            Self::Jams { .. } => Code::Jams,
            Self::Stopped { .. } => Code::Interrupted,
        }
    }

    fn hint(&self) -> Option<String> {
        match self {
            Self::Sample(error) => error.hint(),
            Self::StandsStill { .. } => Some("give it a speed, or let [cycle] name another drive".to_owned()),
            Self::StepTooSmall { .. } | Self::NotFinite { .. } => Some(
                "look for a stiffness, mass or inertia far from those of a real part, or a tolerance below round-off"
                    .to_owned(),
            ),
            Self::TooManyEvaluations { .. } => Some("ask for fewer turns or a looser tolerance".to_owned()),
            Self::TooManyRows { .. } => Some("ask for fewer turns or fewer samples a turn".to_owned()),
            Self::LeavesBearing { .. } | Self::LeavesGuide { .. } => {
                Some("the contact is too soft, or the drive too fast, for these masses".to_owned())
            }
            Self::Jams { .. } => {
                Some("less friction, a longer guide or a smaller pin; rigid bodies have no motion here".to_owned())
            }
            Self::Stopped { .. } => None,
            Self::NothingIsFree => Some("leave --lyapunov out, or give a joint some play".to_owned()),
            Self::BeyondGuide { .. } => {
                Some("give the guide other ends, or none: what overhangs is not computed".to_owned())
            }
            Self::BeyondLaw { .. } => Some("take a law without such a limit, liu or bai-zhao".to_owned()),
        }
    }
}

impl RunFailure {
    /// The complaint about the model whose run failed, at what it is about.
    pub fn complaint(&self, model: &Model) -> Complaint {
        match self {
            Self::Sample(error) => error.complaint(model),
            Self::StandsStill { drive } => Complaint::error(self, model.place(&format!("drive.{drive}.speed"))),
            Self::LeavesBearing { joint, .. }
            | Self::LeavesGuide { joint, .. }
            | Self::BeyondGuide { joint, .. }
            | Self::BeyondLaw { joint, .. }
            | Self::Jams { joint, .. } => Complaint::error(self, model.place(&format!("joint.{joint}"))),
            Self::StepTooSmall { .. }
            | Self::NotFinite { .. }
            | Self::TooManyEvaluations { .. }
            | Self::Stopped { .. } => Complaint::error(self, None),
            Self::TooManyRows { .. } => Complaint::error(self, model.place("cycle")),
            Self::NothingIsFree => Complaint::error(self, None),
        }
    }
}

//! Errors of a model beyond its single entries.

use thiserror::Error;

use loosepin_text::diagnostics::{Code, Problem};
use loosepin_text::document::listed;
use loosepin_text::units::{Dimension, quoted};

/// An error in a model file. `entry` is a path in words.
#[derive(Debug, Clone, PartialEq, Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum ModelProblem {
    #[error("a parameter cannot be called '{name}'")]
    BadParameterName {
        name: String,
        /// Whether it is the name of a unit or a function.
        is_reserved: bool,
    },
    #[error("parameters are defined by one another: {}", .circle.join(" -> "))]
    ParameterCycle {
        /// The names, the first again at the end.
        circle: Vec<String>,
    },
    #[error("{entry}: there is no {what} '{name}'")]
    UnknownReference {
        entry: String,
        /// A body, point, joint, contact or drive.
        what: &'static str,
        name: String,
        nearest: Option<String>,
        known: Vec<String>,
    },
    #[error("{entry} is '{text}'; must be body.point")]
    NotAPoint { entry: String, text: String },
    #[error("{entry} connects body '{body}' to itself")]
    SameBody { entry: String, body: String },
    #[error(
        "{entry}: '{material}' and '{given}' cannot be used together; the stiffness comes from materials or is given"
    )]
    StiffnessTwice { entry: String, material: &'static str, given: &'static str },
    #[error("{entry}: the stiffness is missing")]
    NoStiffness { entry: String },
    /// A material value for both parts and for one of them.
    #[error("{entry}: '{both}' and '{one}' cannot be used together")]
    MaterialTwice { entry: String, both: &'static str, one: &'static str },
    #[error("{entry}: '{key}' needs {}", quoted(.needs))]
    NeedsKeys { entry: String, key: &'static str, needs: Vec<&'static str> },
    #[error("{entry}: 'contact' needs 'bearing_length'")]
    FilmNeedsLength { entry: String },
    /// A key without effect in this combination.
    #[error("{entry}: '{key}' cannot be used with '{beside}'")]
    KeyWithoutEffect { entry: String, key: &'static str, beside: &'static str },
    #[error("{entry}: the two bodies are missing")]
    NoBodies { entry: String },
    #[error("{entry}: joint '{joint}' does not turn; a torsional spring lies around a revolute joint")]
    DoesNotTurn { entry: String, joint: String },
    #[error("{entry} acts on the ground, which does not move")]
    LoadOnGround { entry: String },
    #[error("{entry}: joint '{joint}' is rigid; it has neither angle nor position")]
    DoesNotMove { entry: String, joint: String },
    #[error("{entry}: 'joint' has no effect here; '{key}' is no expression over its angle, position or speed")]
    JointNotRead { entry: String, key: &'static str },
    #[error("{entry}: '{name}' is a parameter of this file and a variable of this expression")]
    NameTaken { entry: String, name: &'static str },
    #[error("{entry}: inverse trigonometric functions cannot be used together with what changes in time")]
    InverseFunction { entry: String },
    #[error("{entry}: exponents of what changes in time are whole or half numbers, written out, up to 32")]
    ExponentOfFunction { entry: String },
    #[error("{entry}: contact '{contact}' has {what}, which cannot be used for {what_touches}")]
    NotForPlanes {
        entry: String,
        contact: String,
        /// The numbers of it that do not apply, in words.
        what: String,
        what_touches: &'static str,
    },
    #[error("{entry}: joint '{joint}' {why} and cannot be driven")]
    NotDrivable { entry: String, joint: String, why: &'static str },
    #[error("{entry}: '{found}' does not fit the {kind} joint '{joint}'")]
    WrongStart { entry: String, found: &'static str, due: &'static str, kind: &'static str, joint: String },
    #[error("{entry}: joint '{joint}' is already driven by '{other}'")]
    DrivenTwice { entry: String, joint: String, other: String },
    #[error("a row has {found} {}; expected two", if *found == 1 { "column" } else { "columns" })]
    CsvColumns { found: usize },
    #[error("the header is '{text}'; must be a name with a unit in brackets")]
    CsvHeader { text: String },
    #[error("the column '{text}' must hold {due}")]
    CsvDimension { text: String, due: Dimension },
    #[error("'{text}' is not a number")]
    CsvNumber { text: String },
    #[error("{entry} couples joint '{joint}' to itself")]
    SameJoint { entry: String, joint: String },
    #[error("{entry}: joint '{joint}' is not {due}")]
    WrongJoint { entry: String, joint: String, due: &'static str },
    #[error("{entry}: joints '{first}' and '{second}' must have exactly one body in common, which carries both wheels")]
    NoCarrier { entry: String, first: String, second: String },
    #[error("{entry}: joint '{joint}' is already moved by {other}")]
    ControlledTwice { entry: String, joint: String, other: String },
    #[error("cycle: drive '{drive}' moves a prismatic joint; its turns cannot be counted")]
    CycleNeedsTurns { drive: String },
    #[error("cycle: drive '{drive}' follows a motion of kind {kind}, which has neither turns nor a period to count")]
    CycleNeedsPeriod { drive: String, kind: &'static str },
    #[error("{entry} has too few entries; must be at least {least}")]
    TooFewPoints { entry: String, least: usize },
    #[error("initial: the ground does not move; it has no initial state")]
    InitialOfGround,
    #[error("{entry}: '{key}' does not fit this kind of joint")]
    WrongCoordinate { entry: String, key: &'static str },
    #[error("assembly: the ground does not move; its angle cannot be guessed")]
    GuessOfGround,
    #[error("{entry} is '{unit}'; must be a unit of {due}")]
    WrongUnit { entry: String, unit: String, due: loosepin_text::units::Dimension },
    /// A parameter or contact that nothing refers to.
    #[error("{entry} is not used")]
    Unused { entry: String },
}

impl Problem for ModelProblem {
    fn code(&self) -> Code {
        match self {
            Self::BadParameterName { .. } => Code::BadName,
            Self::ParameterCycle { .. } => Code::ParameterCycle,
            Self::UnknownReference { .. } | Self::NotAPoint { .. } => Code::UnknownReference,
            Self::CsvColumns { .. } | Self::CsvHeader { .. } | Self::CsvDimension { .. } | Self::CsvNumber { .. } => {
                Code::TableNotReadable
            }
            Self::SameBody { .. } | Self::SameJoint { .. } => Code::SameBody,
            Self::WrongJoint { .. } | Self::NoCarrier { .. } => Code::CouplingNotPossible,
            Self::StiffnessTwice { .. }
            | Self::MaterialTwice { .. }
            | Self::NeedsKeys { .. }
            | Self::FilmNeedsLength { .. }
            | Self::NotForPlanes { .. }
            | Self::KeyWithoutEffect { .. }
            | Self::JointNotRead { .. } => Code::ConflictingKeys,
            Self::NoStiffness { .. } | Self::NoBodies { .. } => Code::MissingKey,
            Self::DoesNotTurn { .. } | Self::LoadOnGround { .. } | Self::DoesNotMove { .. } => Code::UnknownReference,
            Self::NameTaken { .. } => Code::BadName,
            Self::InverseFunction { .. } | Self::ExponentOfFunction { .. } => Code::FunctionNotPossible,
            Self::NotDrivable { .. }
            | Self::WrongStart { .. }
            | Self::CycleNeedsTurns { .. }
            | Self::CycleNeedsPeriod { .. } => Code::DriveNotPossible,
            Self::TooFewPoints { .. } => Code::BadCount,
            Self::WrongCoordinate { .. } => Code::ConflictingKeys,
            Self::DrivenTwice { .. } | Self::ControlledTwice { .. } => Code::DrivenTwice,
            Self::GuessOfGround | Self::InitialOfGround => Code::UnknownReference,
            Self::WrongUnit { .. } => Code::WrongDimension,
            Self::Unused { .. } => Code::Unused,
        }
    }

    fn hint(&self) -> Option<String> {
        match self {
            Self::BadParameterName { name, is_reserved: true } => Some(format!(
                "'{name}' is a unit or a function in expressions; choose another name, for example {name}_value"
            )),
            Self::BadParameterName { .. } => {
                Some("names of parameters begin with a letter or _ and have letters, digits and _".to_owned())
            }
            Self::UnknownReference { nearest: Some(nearest), .. } => Some(format!("did you mean '{nearest}'?")),
            Self::UnknownReference { what: "point", name, known, .. } if known.is_empty() => {
                let body = name.split_once('.').map_or("", |(body, _)| body);
                Some(format!("body '{body}' has no points"))
            }
            Self::UnknownReference { what, known, .. } if known.is_empty() => {
                Some(format!("the file defines no {what}"))
            }
            Self::UnknownReference { known, .. } => Some(format!("there is {}", listed(known, "and"))),
            Self::NotAPoint { .. } => Some("for example \"crank.pin\": point 'pin' of body 'crank'".to_owned()),
            Self::NoStiffness { .. } => {
                Some("give youngs_modulus and poisson_ratio, or stiffness and exponent".to_owned())
            }
            Self::NeedsKeys { key: "contact", needs, .. } if needs.contains(&"bearing_length") => {
                Some("the contact has a line-contact law, whose force is proportional to the length".to_owned())
            }
            Self::FilmNeedsLength { .. } => {
                Some("the contact has a film of oil, whose force depends on the length of the bearing".to_owned())
            }
            Self::NeedsKeys { key: "contact", needs, .. } if needs.contains(&"corner_radius") => Some(
                "the stiffness of the contact comes from the materials: a sphere of that radius on a plane".to_owned(),
            ),
            Self::NotForPlanes { .. } => {
                Some("take a point-contact or a linear law without a film, and the material sliding velocity".to_owned())
            }
            Self::NeedsKeys { key: "radial_clearance" | "clearance", .. } => {
                Some("a joint without play is written without a clearance, or with \"0 mm\"".to_owned())
            }
            Self::NoBodies { .. } => {
                Some("name a revolute joint as joint, or two bodies as first and second".to_owned())
            }
            Self::DoesNotTurn { .. } => Some("name a revolute joint, or two bodies as first and second".to_owned()),
            Self::NameTaken { name, .. } => Some(format!("give the parameter another name, for example {name}_value")),
            Self::InverseFunction { .. } => {
                Some("give what does not change a name under [parameter] and use that".to_owned())
            }
            Self::WrongStart { due, .. } => Some(format!("write {due}")),
            Self::NotDrivable { why, .. } if *why == HAS_PLAY => {
                Some("drive an ideal joint, or set the radial clearance of this one to \"0 mm\"".to_owned())
            }
            Self::CsvColumns { .. } | Self::CsvHeader { .. } => {
                Some("for example: time [s], angle [deg]".to_owned())
            }
            Self::CsvNumber { .. } => Some("with a point and no thousands separator, for example 0.25 or 1e-3".to_owned()),
            Self::NoCarrier { .. } => Some(
                "mount both wheels on the same body: the frame, or the carrier of a planetary gear; kind = \"ratio\" couples any two joints"
                    .to_owned(),
            ),
            Self::NotDrivable { why, .. } if *why == HAS_PLAY_IN_GUIDE => {
                Some("drive an ideal joint, or set the clearance of this one to \"0 mm\"".to_owned())
            }
            Self::NotDrivable { .. } => Some("drive a revolute or prismatic joint".to_owned()),
            Self::CycleNeedsTurns { .. } => {
                Some("name a drive of a revolute joint, or give duration in place of drive".to_owned())
            }
            Self::CycleNeedsPeriod { .. } => Some("give duration in place of drive".to_owned()),
            Self::WrongCoordinate { .. } => Some(
                "a revolute joint has angle and angular_velocity, a prismatic one position and velocity".to_owned(),
            ),
            Self::Unused { .. } => Some("changing it has no effect on the results".to_owned()),
            _ => None,
        }
    }
}

/// Why a joint with clearance cannot be driven.
pub(super) const HAS_PLAY: &str = "has play";
/// Why a prismatic joint with clearance cannot be driven.
pub(super) const HAS_PLAY_IN_GUIDE: &str = "has play in its guide";
/// Why a pin in a slot cannot be driven.
pub(super) const IS_SLOT: &str = "is a slot";
/// Why a rigid joint cannot be driven.
pub(super) const IS_RIGID: &str = "is rigid";

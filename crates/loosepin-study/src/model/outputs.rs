//! Outputs that a study can ask about: the columns of its model, and the errors of its paths.

use loosepin_mechanics::model::{JointId, Position, WearMeasure};
use loosepin_result::study::PathError;
use loosepin_simulate::Reading;
use loosepin_space::{PartOfOutput, SampledPart};
use loosepin_text::units::{Dimension, SiUnit};

/// One number of a model that a study can ask about.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyOutput {
    /// Index among the outputs of the model.
    pub output: usize,
    /// Name of the output; a path adds ` x`, ` y`, ` along`, ` normal`, ` magnitude` or ` contour`.
    pub name: String,
    /// Which part of a path it is; `None` if the output is one number.
    pub component: Option<&'static str>,
    /// Its quantity in words, for example `x of slider.pin`.
    pub words: String,
    /// Of an error of a path the output and its point, `tool (coupler.tool)`.
    pub point: Option<String>,
    /// Its unit.
    pub unit: SiUnit,
    /// Its dimension.
    pub dimension: Dimension,
    /// Its source in a run.
    pub seen: OutputSource,
}

/// Source of an output in a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum OutputSource {
    /// A number that can be read at any instant.
    Reading(Reading),
    /// A part of the error of a point from its ideal path; x and y of the point.
    Path([Reading; 2], PathError),
    /// The wear of a joint after all cycles: one number of a run.
    Wear(JointId, WearMeasure),
    /// A number of a mechanism in space.
    InSpace(SampledPart),
}

impl OutputSource {
    /// The position or angle that it is.
    pub fn position(&self) -> Option<Position> {
        match self {
            Self::Reading(reading) => reading.position(),
            Self::Path(..) | Self::Wear(..) | Self::InSpace(_) => None,
        }
    }

    /// The joint whose force it is.
    pub fn force_in(&self) -> Option<JointId> {
        match self {
            Self::Reading(reading) => reading.force_in(),
            Self::Path(..) | Self::Wear(..) | Self::InSpace(_) => None,
        }
    }

    /// Whether it is an error from the ideal path, and no value of its own.
    pub fn is_error_of_path(&self) -> bool {
        match self {
            Self::Path(..) => true,
            Self::InSpace(own) => own.part.is_never_negative() || own.part == PartOfOutput::Along,
            Self::Reading(_) | Self::Wear(..) => false,
        }
    }

    /// The readings that it is made of.
    pub fn readings(&self) -> impl Iterator<Item = Reading> + use<> {
        let (first, second) = match *self {
            Self::Reading(reading) => (Some(reading), None),
            Self::Path([x, y], _) => (Some(x), Some(y)),
            Self::Wear(..) | Self::InSpace(_) => (None, None),
        };
        first.into_iter().chain(second)
    }
}

/// The coordinate that a path has in space alone.
pub const HEIGHT: &str = "z";

/// The names of a path's parts in study files: coordinates, then parts of the error.
pub const COMPONENTS: [&str; 6] = {
    let mut names = ["x", "y", "", "", "", ""];
    let mut part = 0;
    while part < PathError::ALL.len() {
        names[2 + part] = PathError::ALL[part].word();
        part += 1;
    }
    names
};

/// The names of all components, those of paths in space last.
pub const ALL_COMPONENTS: [&str; 8] = {
    let mut names = [""; 8];
    let mut place = 0;
    while place < COMPONENTS.len() {
        names[place] = COMPONENTS[place];
        place += 1;
    }
    names[COMPONENTS.len()] = HEIGHT;
    names[COMPONENTS.len() + 1] = "across";
    names
};

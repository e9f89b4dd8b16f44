//! Outputs that a study can ask about: the columns of its model, and the errors of its paths.

use super::spatial_outputs::spatial_outputs;
use crate::model::StudyModel;
use loosepin_mechanics::model::{JointId, Model, Position, Recorded, WearMeasure};
use loosepin_result::study::PathError;
use loosepin_simulate::{Reading, columns, relative_words};
use loosepin_space::SampledPart;
use loosepin_text::units::{Dimension, SiUnit};

/// One number of a model that a study can ask about.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyOutput {
    /// Index in [`Model::outputs`].
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
    names[COMPONENTS.len()] = "z";
    names[COMPONENTS.len() + 1] = "across";
    names
};

/// All that can be asked of a model, in file order; of a path each of its parts.
pub fn study_outputs(model: &StudyModel) -> Vec<StudyOutput> {
    match model {
        StudyModel::Planar(model) => planar_outputs(model),
        StudyModel::Spatial(model) => spatial_outputs(model),
    }
}

/// Outputs of a planar model; of a path in the order of [`COMPONENTS`].
fn planar_outputs(model: &Model) -> Vec<StudyOutput> {
    let mut outputs = Vec::new();
    let columns = columns(model);
    for (index, output) in model.outputs.iter().enumerate() {
        let dimension = output.kind.dimension();
        let own: Vec<_> = columns.iter().filter(|column| column.output == index).collect();
        let is_path = own.len() > 1;
        for (place, column) in own.iter().enumerate() {
            outputs.push(StudyOutput {
                output: index,
                name: column.name.clone(),
                component: is_path.then(|| COMPONENTS[place]),
                words: column.words.clone(),
                point: None,
                unit: column.unit.clone(),
                dimension,
                seen: OutputSource::Reading(column.reading),
            });
        }
        match output.kind.recorded() {
            Recorded::Number(_) => {}
            Recorded::Wear(joint, measure) => outputs.push(StudyOutput {
                output: index,
                name: output.name.clone(),
                component: None,
                words: measure.words(&model.joints[joint.0].name),
                point: None,
                unit: SiUnit::of_dimension(dimension),
                dimension,
                seen: OutputSource::Wear(joint, measure),
            }),
            Recorded::Path(point) => {
                let [x, y] = own[..] else { continue };
                let words = relative_words(model, point);
                outputs.extend(PathError::ALL.map(|part| StudyOutput {
                    output: index,
                    name: format!("{} {}", output.name, part.word()),
                    component: Some(part.word()),
                    words: part.words(&words),
                    point: Some(format!("{} ({})", output.name, words)),
                    unit: x.unit.clone(),
                    dimension,
                    seen: OutputSource::Path([x.reading, y.reading], part),
                }));
            }
        }
    }
    outputs
}

//! All that can be asked of a model in the plane.

use super::outputs::{COMPONENTS, OutputSource, StudyOutput};
use loosepin_mechanics::model::Model;
use loosepin_result::study::PathError;
use loosepin_simulate::{columns, relative_words};
use loosepin_text::units::SiUnit;

/// All that can be asked, in file order; of a path each of its parts, in the order of [`COMPONENTS`], then its errors.
pub(super) fn planar_outputs(model: &Model) -> Vec<StudyOutput> {
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
        outputs.extend(output.kind.wear().map(|(joint, measure)| StudyOutput {
            output: index,
            name: output.name.clone(),
            component: None,
            words: measure.words(&model.joints[joint.0].name),
            point: None,
            unit: SiUnit::of_dimension(dimension),
            dimension,
            seen: OutputSource::Wear(joint, measure),
        }));
        if let (Some(point), [x, y]) = (output.kind.path(), &own[..]) {
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
    outputs
}

//! What can be asked of a model in space: one number of a position or a turn, the parts of a path, and the angle from an ideal orientation.

use super::outputs::{OutputSource, StudyOutput};
use loosepin_space::{PartOfOutput, SampledPart, SpatialModel};
use loosepin_text::units::SiUnit;

/// All that can be asked, in file order.
pub(super) fn spatial_outputs(model: &SpatialModel) -> Vec<StudyOutput> {
    let mut outputs = Vec::new();
    for (index, output) in model.outputs.iter().enumerate() {
        let (kind, name) = (output.kind, model.name_of(output.kind));
        outputs.extend(kind.asked_parts().iter().map(|&part| {
            let component = (part != PartOfOutput::Number).then(|| part.word());
            StudyOutput {
                output: index,
                name: component.map_or_else(|| output.name.clone(), |word| format!("{} {word}", output.name)),
                component,
                words: kind.words_of_part(part, &name),
                point: kind.is_path().then(|| format!("{} ({name})", output.name)),
                unit: SiUnit::of_dimension(kind.dimension()),
                dimension: kind.dimension(),
                seen: OutputSource::InSpace(SampledPart { output: index, part }),
            }
        }));
    }
    outputs
}

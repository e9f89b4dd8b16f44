//! What can be asked of a model in space: one number of a position or a turn, the parts of a path, and the angle from an ideal orientation.

use super::outputs::{OutputSource, StudyOutput};
use loosepin_space::{ModelOutputKind, PartOfOutput, SampledPart, SpatialModel};
use loosepin_text::units::{Dimension, SiUnit};

/// The parts of a path, in the order in which they are listed.
const PARTS: [(PartOfOutput, &str); 6] = [
    (PartOfOutput::X, "x"),
    (PartOfOutput::Y, "y"),
    (PartOfOutput::Z, "z"),
    (PartOfOutput::Along, "along"),
    (PartOfOutput::Across, "across"),
    (PartOfOutput::Magnitude, "magnitude"),
];

/// All that can be asked, in file order.
pub(super) fn spatial_outputs(model: &SpatialModel) -> Vec<StudyOutput> {
    let mut outputs = Vec::new();
    for (index, output) in model.outputs.iter().enumerate() {
        let number = |words: String, dimension: Dimension| StudyOutput {
            output: index,
            name: output.name.clone(),
            component: None,
            words,
            point: None,
            unit: SiUnit::of_dimension(dimension),
            dimension,
            seen: OutputSource::InSpace(SampledPart { output: index, part: PartOfOutput::Number }),
        };
        match output.kind {
            ModelOutputKind::Position { point, .. } => {
                outputs.push(number(format!("position of {}", model.point_name(point)), Dimension::LENGTH));
            }
            ModelOutputKind::Turn { body, .. } => {
                outputs.push(number(format!("turn of {}", model.bodies[body].name), Dimension::ANGLE));
            }
            ModelOutputKind::Orientation { body } => {
                // Components of the rotation are turns about axes, which turn_of has.
                let (part, word) = (PartOfOutput::Magnitude, PartOfOutput::Magnitude.word());
                outputs.push(StudyOutput {
                    name: format!("{} {word}", output.name),
                    component: Some(word),
                    seen: OutputSource::InSpace(SampledPart { output: index, part }),
                    ..number(
                        format!("angle of {} from its ideal orientation", model.bodies[body].name),
                        Dimension::ANGLE,
                    )
                });
            }
            ModelOutputKind::Path { point } => {
                let point = model.point_name(point);
                outputs.extend(PARTS.map(|(part, word)| StudyOutput {
                    name: format!("{} {word}", output.name),
                    component: Some(word),
                    point: Some(format!("{} ({point})", output.name)),
                    seen: OutputSource::InSpace(SampledPart { output: index, part }),
                    ..number(words(part, &point), Dimension::LENGTH)
                }));
            }
        }
    }
    outputs
}

fn words(part: PartOfOutput, point: &str) -> String {
    match part {
        PartOfOutput::Number => format!("position of {point}"),
        PartOfOutput::X => format!("x of {point}"),
        PartOfOutput::Y => format!("y of {point}"),
        PartOfOutput::Z => format!("z of {point}"),
        PartOfOutput::Along => format!("error of {point} along its path"),
        PartOfOutput::Across => format!("distance of {point} from the line along its path"),
        PartOfOutput::Magnitude => format!("distance of {point} from its ideal place"),
    }
}

//! Poses that a study asks about: what answers without dynamics is said of these places first.

use crate::file::Study;
use crate::model::outputs::{OutputSource, StudyOutput};
use loosepin_result::study::PathError;
use loosepin_simulate::accuracy::AskedPose;
use loosepin_space::{PartOfOutput, SampledPart};

impl Study {
    /// The poses of all requirements, then those of questions that are not among them, each with its output.
    pub(crate) fn asked_poses(&self) -> Vec<AskedPose> {
        let required = self.requirements.iter().map(|own| (own.output, &own.location, true));
        let asked = self.asks.iter().map(|own| (own.output, &own.location, false));
        let mut poses: Vec<AskedPose> = Vec::new();
        for (output, location, is_required) in required.chain(asked) {
            let Some(angles_rad) = location.angles_rad() else { continue };
            let output = self.name_without_dynamics(&self.outputs[output]);
            for &pose_rad in angles_rad {
                if !poses.iter().any(|known| known.output == output && known.pose_rad == pose_rad) {
                    poses.push(AskedPose { output: output.clone(), pose_rad, is_required });
                }
            }
        }
        poses
    }

    /// The name that the answer without dynamics has for an output: to first order the distance from a path is the error across it; of a path in
    /// space it has the displacement as a whole.
    pub(crate) fn name_without_dynamics(&self, output: &StudyOutput) -> String {
        let names = self.model.output_names();
        let path = names.get(output.output).copied().unwrap_or_default();
        match output.seen {
            OutputSource::Path(_, PathError::Contour) => format!("{path} {}", PathError::Normal.word()),
            OutputSource::InSpace(SampledPart { part: PartOfOutput::Magnitude, .. }) => path.to_owned(),
            _ => output.name.clone(),
        }
    }
}

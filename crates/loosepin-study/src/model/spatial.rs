//! What a model in space says of itself: its positions are closed, without dynamics.

use super::kind::{Clearance, KindOfModel, PlayProofs, ValuesUnderSettings};
use super::motion_request::MotionRequest;
use super::outputs::StudyOutput;
use super::spatial_motion::{moved, play_with_scatter};
use super::spatial_outputs::spatial_outputs;
use super::spatial_settings::SpatialSettings;
use super::{spatial_paths, spatial_turn};
use loosepin_mechanics::model::{Cycle, CycleInput, CycleSpan, PathError};
use loosepin_result::motion::MotionRecord;
use loosepin_space::{IsStopped, PlayDistribution, PlayEnds, PlayQuestion, SpatialModel, stop_after};
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Place, Source};
use loosepin_text::numbers::{QuantityId, QuantityTable, Values};
use loosepin_text::units::SiUnit;
use std::sync::Arc;

/// Steps along the motion that show whether a mechanism moves.
const MAX_STEPS: u64 = 3000;

impl KindOfModel for SpatialModel {
    fn name(&self) -> &str {
        &self.name
    }

    fn quantities(&self) -> &QuantityTable {
        &self.quantities
    }

    fn source(&self) -> &Arc<Source> {
        SpatialModel::source(self)
    }

    fn warnings(&self) -> &[Diagnostic] {
        &self.warnings
    }

    fn place(&self, path: &str) -> Option<Place> {
        SpatialModel::place(self, path)
    }

    fn output_names(&self) -> Vec<&str> {
        self.outputs.iter().map(|output| output.name.as_str()).collect()
    }

    fn outputs(&self) -> Vec<StudyOutput> {
        spatial_outputs(self)
    }

    fn described_outputs(&self) -> Vec<(String, String, SiUnit)> {
        let described = self.outputs.iter().map(|output| {
            let words = format!("{} of {}", output.kind.word(), self.name_of(output.kind));
            (output.name.clone(), words, SiUnit::of_dimension(output.kind.dimension()))
        });
        described.collect()
    }

    fn find(&self, path: &str) -> Result<QuantityId, PathError> {
        spatial_paths::find(self, path)
    }

    fn largest_extent_m(&self, values: &Values) -> f64 {
        SpatialModel::largest_extent_m(self, values)
    }

    fn cycle(&self) -> Cycle {
        spatial_turn::cycle(self)
    }

    fn input(&self, span: CycleSpan, values: &Values) -> CycleInput {
        spatial_turn::input(self, span, values)
    }

    fn take_settings(&mut self, texts: &[String]) -> Result<ValuesUnderSettings, Diagnostics> {
        let set = SpatialSettings::read(self, texts)?;
        Ok(ValuesUnderSettings { warnings: set.warnings(self, texts), values: set.values })
    }

    fn take_values(&mut self, ValuesUnderSettings { values, warnings }: ValuesUnderSettings) {
        self.quantities.set_nominal(values);
        self.warnings.extend(warnings);
    }

    fn warnings_of_settings(&self, texts: &[String]) -> Vec<Diagnostic> {
        SpatialSettings::read(self, texts).map_or(Vec::new(), |set| set.warnings(self, texts))
    }

    fn play_names(&self) -> Vec<String> {
        let with_play = self.joints.iter().filter(|joint| joint.play.is_some());
        with_play.map(|joint| joint.name.clone()).collect()
    }

    fn play_from(&self, id: QuantityId) -> Vec<Clearance> {
        clearances(self).filter(|clearance| self.quantities.depends_on(clearance.quantity, id)).collect()
    }

    fn keys_of_new_play(&self, joint: &str) -> &'static [&'static str] {
        let joint = self.joints.iter().find(|known| known.name == joint && known.play.is_none());
        joint.map_or(&[], |joint| joint.kind.play_keys())
    }

    fn first_bearing_length(&self) -> Option<QuantityId> {
        self.joints.iter().find_map(|joint| joint.play?.bearing_length_m())
    }

    fn motion(&self, request: &MotionRequest<'_>) -> Result<MotionRecord, Diagnostics> {
        moved(self, request)
    }

    fn motion_with_findings(&self, request: &MotionRequest<'_>) -> (Option<MotionRecord>, Diagnostics) {
        play_with_scatter(self, request)
    }

    fn drawn_motion(&self, request: &MotionRequest<'_>) -> Result<MotionRecord, Diagnostics> {
        self.drawn_motion_until(&self.quantities.nominal(), &|| request.is_stopped())
    }

    fn try_to_move(&self, request: &MotionRequest<'_>) -> Result<(), Diagnostics> {
        let values = self.quantities.nominal();
        let mechanism = self.mechanism(&values).map_err(|error| self.diagnostic(&error))?;
        let is_stopped = || request.is_stopped();
        let is_enough = stop_after(MAX_STEPS, &is_stopped);
        self.first_positions(&mechanism, &values, &is_enough).map(|_| ())
    }

    fn uniforms_of_joints(&self, distribution: PlayDistribution) -> Vec<(String, usize)> {
        let joints = SpatialModel::uniforms_of_joints(self, distribution).into_iter();
        joints.map(|(joint, count)| (joint.to_owned(), count)).collect()
    }

    fn play_proofs(&self) -> Option<&dyn PlayProofs> {
        Some(self)
    }

    fn motion_of_page(&self, settings: &[String], paths: &[String]) -> Option<MotionRecord> {
        let SpatialSettings { values, .. } = SpatialSettings::read(self, settings).ok()?;
        let points = self.points_of_paths(paths).ok()?;
        self.motion_with_paths_until(&values, &points, false, &|| false).ok()
    }
}

impl PlayProofs for SpatialModel {
    fn play_ends(
        &self,
        values: &Values,
        question: &PlayQuestion,
        is_stopped: IsStopped<'_>,
    ) -> Result<PlayEnds, Diagnostics> {
        self.play_ends_until(values, question, is_stopped)
    }

    fn moves(&self, id: QuantityId) -> bool {
        let aside: Vec<QuantityId> =
            clearances(self).map(|clearance| clearance.quantity).chain(self.unused_quantities()).collect();
        let counts = |own: QuantityId, path: &str| !path.starts_with("parameter.") && !aside.contains(&own);
        self.quantities.iter().any(|(own, known)| counts(own, &known.path) && self.quantities.depends_on(own, id))
    }
}

/// The clearances of its joints, in file order: of a pin the radial one and that along its axis.
fn clearances(model: &SpatialModel) -> impl Iterator<Item = Clearance> {
    model.joints.iter().flat_map(|joint| {
        let own = joint.play.map_or([None, None], |play| play.clearances_m());
        own.into_iter().flatten().map(|quantity| Clearance { name: joint.name.clone(), quantity })
    })
}

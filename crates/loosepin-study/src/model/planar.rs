//! What a model in the plane says of itself.

use super::kind::{Clearance, DeviationProofs, KindOfModel, ProvenDeviations, ValuesUnderSettings};
use super::motion_request::MotionRequest;
use super::outputs::StudyOutput;
use super::planar_outputs::planar_outputs;
use loosepin_mechanics::mechanism::{Mechanism, MechanismError};
use loosepin_mechanics::model::{
    BodyId, ContactId, Cycle, CycleInput, CycleSpan, LawError, Model, NormalDescription, PathError, PlayId, PointId,
};
use loosepin_result::motion::MotionRecord;
use loosepin_result::simulation::Drawing;
use loosepin_simulate::accuracy::{
    AccuracyError, AllDeviationEnds, DeviationQuestion, DimensionLimit, MotionPlan, deviation_ends_until,
    dimension_direction, motion_until, motion_with_worst_cases_until,
};
use loosepin_simulate::record::Override;
use loosepin_simulate::{RunFailure, SmallestClearance, columns, controlled_drawing};
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Place, Source};
use loosepin_text::numbers::{QuantityId, QuantityTable, Values};
use loosepin_text::units::{DisplayUnits, SiUnit};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

impl KindOfModel for Model {
    fn name(&self) -> &str {
        &self.name
    }

    fn quantities(&self) -> &QuantityTable {
        &self.quantities
    }

    fn source(&self) -> &Arc<Source> {
        Model::source(self)
    }

    fn tables(&self) -> &[Arc<Source>] {
        Model::tables(self)
    }

    fn warnings(&self) -> &[Diagnostic] {
        &self.warnings
    }

    fn place(&self, path: &str) -> Option<Place> {
        Model::place(self, path)
    }

    fn output_names(&self) -> Vec<&str> {
        self.outputs.iter().map(|output| output.name.as_str()).collect()
    }

    fn outputs(&self) -> Vec<StudyOutput> {
        planar_outputs(self)
    }

    fn described_outputs(&self) -> Vec<(String, String, SiUnit)> {
        columns(self).into_iter().map(|column| (column.name, column.words, column.unit)).collect()
    }

    fn shown_in(&self, usual: DisplayUnits) -> DisplayUnits {
        Model::shown_in(self, usual)
    }

    fn find(&self, path: &str) -> Result<QuantityId, PathError> {
        Model::find(self, path)
    }

    fn largest_extent_m(&self, values: &Values) -> f64 {
        Model::largest_extent_m(self, values)
    }

    fn cycle(&self) -> Cycle {
        self.cycle.clone()
    }

    fn input(&self, span: CycleSpan, values: &Values) -> CycleInput {
        Model::input(self, span, values)
    }

    fn take_settings(&mut self, texts: &[String]) -> Result<ValuesUnderSettings, Diagnostics> {
        let set = self.set_values(texts)?;
        let warnings = set.warnings();
        *self = set.model;
        Ok(ValuesUnderSettings { values: set.values, warnings })
    }

    fn take_values(&mut self, ValuesUnderSettings { values, warnings }: ValuesUnderSettings) {
        self.quantities.set_nominal(values);
        self.warnings.extend(warnings);
    }

    fn warnings_of_settings(&self, texts: &[String]) -> Vec<Diagnostic> {
        self.set_values(texts).map_or(Vec::new(), |set| set.warnings())
    }

    fn play_names(&self) -> Vec<String> {
        self.plays().map(|play| self.play_name(play).to_owned()).collect()
    }

    fn play_from(&self, id: QuantityId) -> Vec<Clearance> {
        let plays = Model::play_from(self, id);
        plays.map(|(play, quantity)| Clearance { name: self.play_name(play).to_owned(), quantity }).collect()
    }

    fn bearings_with_play_from(&self, id: QuantityId) -> Vec<(String, Option<QuantityId>)> {
        let joints = Model::play_from(self, id).filter_map(|(play, _)| match play {
            PlayId::Joint(joint) => Some(&self.joints[joint.0]),
            PlayId::Coupling(_) => None,
        });
        joints
            .map(|joint| {
                let pin = joint.kind.pin_clearance().filter(|pin| pin.has_radius);
                (joint.name.clone(), pin.map(|pin| pin.bearing_radius_m))
            })
            .collect()
    }

    fn leans_beside_runs(&self) -> bool {
        self.plays().any(|play| self.has_leaning_pin(play))
    }

    fn keys_of_new_play(&self, joint: &str) -> &'static [&'static str] {
        let joint = self.joints.iter().find(|known| known.name == joint);
        let can_have_play = joint.is_some_and(|joint| joint.kind.turns() && joint.kind.play().is_none());
        match (can_have_play, self.leans) {
            (true, true) => &["bearing_radius", "radial_clearance", "bearing_length", "contact"],
            (true, false) => &["bearing_radius", "radial_clearance", "contact"],
            (false, _) => &[],
        }
    }

    fn contact_names(&self) -> Vec<&str> {
        self.contacts.iter().map(|contact| contact.name.as_str()).collect()
    }

    fn motion(&self, request: &MotionRequest<'_>) -> Result<MotionRecord, Diagnostics> {
        let set = self.set_values(&request.settings)?;
        let paths = self.points_of_paths(request.paths)?;
        let mechanism = Mechanism::new(&set.model, &set.values).map_err(|error| error.diagnostic(self))?;
        let plan = MotionPlan {
            span: self.cycle.span,
            positions: request.positions,
            scatter: request.scatter.clone(),
            correlations: request.correlations.clone(),
            paths,
            asked: request.asked.clone(),
            overrides: Override::from_settings(&request.settings),
        };
        let motion = if request.has_worst_cases { motion_with_worst_cases_until } else { motion_until };
        Ok(motion(&mechanism, &set.values, &plan, request.stop).map_err(|error| error.diagnostic(self))?)
    }

    fn mobility_check(&self) -> Option<Result<(), MechanismError>> {
        Some(Mechanism::new(self, &self.quantities.nominal()).map(|_| ()))
    }

    fn has_dynamics(&self) -> bool {
        true
    }

    fn demand_complete(&self) -> Result<(), Diagnostics> {
        self.demand_dynamics()
    }

    fn takes_readings(&self) -> bool {
        true
    }

    fn points_to_push(&self) -> Vec<(String, PointId)> {
        let bodies = self.bodies.iter().enumerate();
        bodies
            .flat_map(|(body, known)| {
                let points = known.points.iter().enumerate();
                points.map(move |(point, named)| {
                    (format!("{}.{}", known.name, named.name), PointId { body: BodyId(body), point })
                })
            })
            .collect()
    }

    fn cycles_of_wear(&self) -> Option<QuantityId> {
        self.wear.map(|wear| wear.cycles)
    }

    fn contact_of_law(&self, path: &str) -> Option<Result<ContactId, PathError>> {
        Model::contact_of_law(self, path)
    }

    fn check_law(&self, contact: ContactId, law: NormalDescription) -> Result<(), LawError> {
        self.with_law(contact, law).map(|_| ())
    }

    fn plays_with_contact(&self, values: &Values) -> Vec<PlayId> {
        self.plays().filter(|&play| Model::has_play(self, play, values)).collect()
    }

    fn integrated_clearances(&self) -> Vec<(String, QuantityId)> {
        self.play_clearances().map(|(play, id)| (self.play_words(play), id)).collect()
    }

    fn smallest_clearance(&self, values: &Values) -> Option<SmallestClearance> {
        SmallestClearance::of(self, values)
    }

    fn has_paths_with_zones(&self) -> bool {
        self.outputs.iter().any(|output| output.kind.path().is_some())
    }

    fn controlled_drawing(&self, settings: &[String], positions: usize) -> Option<Drawing> {
        let set = self.set_values(settings).ok()?;
        let mechanism = Mechanism::new(&set.model, &set.values).ok()?;
        if mechanism.is_driven() {
            return None;
        }
        controlled_drawing(&mechanism, &set.values, positions).ok()
    }

    fn deviation_proofs(&self) -> Option<&dyn DeviationProofs> {
        Some(self)
    }

    fn diagnostic_of_mechanism(&self, error: &MechanismError) -> Option<Diagnostic> {
        Some(error.diagnostic(self))
    }

    fn diagnostic_of_run(&self, failure: &RunFailure) -> Option<Diagnostic> {
        Some(failure.diagnostic(self))
    }
}

impl DeviationProofs for Model {
    fn prove(
        &self,
        values: &Values,
        turn: (CycleSpan, usize),
        limits: &[DimensionLimit],
        questions: &[DeviationQuestion],
        stop: &AtomicBool,
    ) -> Result<ProvenDeviations, AccuracyError> {
        let mechanism = Mechanism::new(self, values).map_err(|_| AccuracyError::NotDriven)?;
        let moves = |limit: &DimensionLimit| match dimension_direction(&mechanism, values, limit.quantity) {
            Ok(direction) => !direction.leaves_motion_alone(&mechanism),
            Err(_) => false,
        };
        let moves: Vec<bool> = limits.iter().map(moves).collect();
        let dimensions: Vec<DimensionLimit> =
            limits.iter().zip(&moves).filter(|(_, moves)| **moves).map(|(limit, _)| *limit).collect();
        let mut ends = if questions.is_empty() {
            AllDeviationEnds { of_questions: Vec::new(), unproven: None, is_whole_turn: true }
        } else {
            deviation_ends_until(&mechanism, values, turn, (&dimensions, questions), stop)?
        };
        // What is found is for pins that lean as they are drawn.
        if let Some(limit) = limits.iter().find(|limit| limit.most_si > 0.0 && self.decides_lean(limit.quantity)) {
            ends.unproven = Some(format!("{} decides how far pins lean", self.quantities[limit.quantity].path));
            for (question, own) in questions.iter().zip(&mut ends.of_questions) {
                if question.of.has_play() {
                    own.found.iter_mut().for_each(|found| found.deviation_si = f64::NAN);
                }
            }
        }
        Ok(ProvenDeviations { moves, ends })
    }

    fn diagnostic(&self, error: &AccuracyError) -> Diagnostic {
        error.diagnostic(self)
    }
}

//! What every kind of model says of itself, and all that a study asks of one. A kind without a capability leaves its method out.

use super::motion_request::MotionRequest;
use super::outputs::StudyOutput;
use loosepin_mechanics::mechanism::MechanismError;
use loosepin_mechanics::model::{
    ContactId, Cycle, CycleInput, CycleSpan, LawError, NormalDescription, PathError, PlayId, PointId,
};
use loosepin_result::motion::MotionRecord;
use loosepin_result::simulation::Drawing;
use loosepin_simulate::accuracy::{AccuracyError, AllDeviationEnds, DeviationQuestion, DimensionLimit};
use loosepin_simulate::{RunFailure, SmallestClearance};
use loosepin_space::{IsStopped, PlayDistribution, PlayEnds, PlayQuestion};
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Place, Source};
use loosepin_text::numbers::{QuantityId, QuantityTable, Values};
use loosepin_text::units::{Dimension, DisplayUnits, SiUnit};
use std::fmt::Debug;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Path of the input that a study adds for the places of all journals, where nothing decides them.
pub const PLAY: &str = "play";

/// A clearance of something that has play.
#[derive(Debug, Clone, PartialEq)]
pub struct Clearance {
    /// Name of the joint or coupling.
    pub name: String,
    /// The clearance, m.
    pub quantity: QuantityId,
}

/// The values of a model under settings.
#[derive(Debug, Clone)]
pub struct ValuesUnderSettings {
    /// All of them.
    pub values: Values,
    /// Warnings of those that the settings make hardly possible.
    pub warnings: Vec<Diagnostic>,
}

/// A kind of model.
pub trait KindOfModel: Debug + Send + Sync {
    /// Its name.
    fn name(&self) -> &str;

    /// Every number of it.
    fn quantities(&self) -> &QuantityTable;

    /// The file that it was read from.
    fn source(&self) -> &Arc<Source>;

    /// The CSV files that were read with it.
    fn tables(&self) -> &[Arc<Source>] {
        &[]
    }

    /// Likely mistakes in it.
    fn warnings(&self) -> &[Diagnostic];

    /// Place of an entry of the file, by its dotted path.
    fn place(&self, path: &str) -> Option<Place>;

    /// Names of its outputs, in file order.
    fn output_names(&self) -> Vec<&str>;

    /// All that can be asked of it, in file order; of a path each of its parts.
    fn outputs(&self) -> Vec<StudyOutput>;

    /// Name, words and unit of each output, in file order; a path in the plane is two of them.
    fn described_outputs(&self) -> Vec<(String, String, SiUnit)>;

    /// How numbers are shown to people.
    fn shown_in(&self, usual: DisplayUnits) -> DisplayUnits {
        usual
    }

    /// Dimension of a quantity by its path.
    fn dimension_of(&self, path: &str) -> Option<Dimension> {
        self.quantities().id(path).map(|id| self.quantities()[id].dimension)
    }

    /// The quantity with this path, if it can be set.
    ///
    /// # Errors
    /// No such quantity (with the nearest name); a quantity given by an expression (with what it depends on).
    fn find(&self, path: &str) -> Result<QuantityId, PathError>;

    /// The scale of the mechanism, m: the size of its largest body.
    fn largest_extent_m(&self, values: &Values) -> f64;

    /// The turn that a study counts by.
    fn cycle(&self) -> Cycle;

    /// The input of the cycle that counts by `span`.
    fn input(&self, span: CycleSpan, values: &Values) -> CycleInput;

    /// The input of the model's own cycle.
    fn cycle_input(&self, values: &Values) -> CycleInput {
        self.input(self.cycle().span, values)
    }

    /// Takes over what settings `path=value` choose beside numbers, and gives the values under all of them.
    ///
    /// # Errors
    /// Every setting that cannot be read, a quantity that is set twice, and values that break a rule together.
    fn take_settings(&mut self, texts: &[String]) -> Result<ValuesUnderSettings, Diagnostics>;

    /// Takes values in place of those of the file, with the warnings about them.
    fn take_values(&mut self, under: ValuesUnderSettings);

    /// Warnings of values that settings `path=value` make hardly possible; none where they cannot be read, which is refused elsewhere.
    fn warnings_of_settings(&self, texts: &[String]) -> Vec<Diagnostic>;

    /// Names of the joints and couplings that may have play, in file order.
    fn play_names(&self) -> Vec<String>;

    /// Whether anything may have play.
    fn has_play(&self) -> bool {
        !self.play_names().is_empty()
    }

    /// The joints and couplings with play whose clearance is this quantity or depends on it.
    fn play_from(&self, id: QuantityId) -> Vec<Clearance>;

    /// Whether a play follows from this quantity.
    fn has_play_from(&self, id: QuantityId) -> bool {
        !self.play_from(id).is_empty()
    }

    /// The joints, not couplings, with play whose clearance is this quantity or depends on it, each with the radius of its bearing where the
    /// model has one.
    fn bearings_with_play_from(&self, id: QuantityId) -> Vec<(String, Option<QuantityId>)> {
        self.play_from(id).into_iter().map(|play| (play.name, None)).collect()
    }

    /// The keys that give an ideal joint its play; none of a joint that has play or can have none, and where there is no such joint.
    fn keys_of_new_play(&self, joint: &str) -> &'static [&'static str];

    /// Names of its contacts, in file order.
    fn contact_names(&self) -> Vec<&str> {
        Vec::new()
    }

    /// Whether pins with play lean, which its runs do not know.
    fn leans_beside_runs(&self) -> bool {
        false
    }

    /// The length of the first bearing that has play and a length.
    fn first_bearing_length(&self) -> Option<QuantityId> {
        None
    }

    /// The motion over one turn, with the answer without dynamics.
    ///
    /// # Errors
    /// A setting that the model does not take; a mechanism that cannot be assembled, or is not driven; a path of a point that it does not
    /// have; that it was stopped.
    fn motion(&self, request: &MotionRequest<'_>) -> Result<MotionRecord, Diagnostics>;

    /// The motion, and what is wrong although there is one: it is without what scatters, where that alone has no answer.
    fn motion_with_findings(&self, request: &MotionRequest<'_>) -> (Option<MotionRecord>, Diagnostics) {
        match self.motion(request) {
            Ok(record) => (Some(record), Diagnostics::new()),
            Err(found) => (None, found),
        }
    }

    /// The motion to be drawn, which may be without outputs and what play does to them.
    ///
    /// # Errors
    /// As for [`Self::motion`].
    fn drawn_motion(&self, request: &MotionRequest<'_>) -> Result<MotionRecord, Diagnostics> {
        self.motion(request)
    }

    /// Whether the mechanism moves, looked at as shortly as that can be known.
    ///
    /// # Errors
    /// As for [`Self::motion`].
    fn try_to_move(&self, request: &MotionRequest<'_>) -> Result<(), Diagnostics> {
        self.motion(request).map(|_| ())
    }

    /// What is wrong with its drives against its freedoms; `None` where these are not counted apart from a motion.
    fn mobility_check(&self) -> Option<Result<(), MechanismError>> {
        None
    }

    /// Whether forces are known, so that its runs are integrated through time.
    fn has_dynamics(&self) -> bool {
        false
    }

    /// That all is there which its runs need.
    ///
    /// # Errors
    /// Each missing entry, at its place.
    fn demand_complete(&self) -> Result<(), Diagnostics> {
        Ok(())
    }

    /// Whether its motion depends on what was before, so that it has a start-up, and later turns may differ.
    fn has_start_up(&self) -> bool {
        self.has_dynamics()
    }

    /// Whether forces decide where in their play its journals are. Else a study says how they are drawn, or takes the worst case.
    fn decides_journals(&self) -> bool {
        self.has_dynamics()
    }

    /// The joints whose journals can be drawn, with the uniform numbers that each place takes.
    fn uniforms_of_joints(&self, _distribution: PlayDistribution) -> Vec<(String, usize)> {
        Vec::new()
    }

    /// Whether readings of a rig can be held against it.
    fn takes_readings(&self) -> bool {
        false
    }

    /// The points that a rig can push, by their names `BODY.POINT`.
    fn points_to_push(&self) -> Vec<(String, PointId)> {
        Vec::new()
    }

    /// The number of cycles after which wear is stated, where something wears.
    fn cycles_of_wear(&self) -> Option<QuantityId> {
        None
    }

    /// The contact whose law `path` names; `None` if it names no law.
    fn contact_of_law(&self, _path: &str) -> Option<Result<ContactId, PathError>> {
        None
    }

    /// Whether a contact can have a law.
    ///
    /// # Errors
    /// The numbers that the law needs are missing.
    fn check_law(&self, _contact: ContactId, _law: NormalDescription) -> Result<(), LawError> {
        Ok(())
    }

    /// The joints and couplings with contacts at these values; none where nothing is integrated.
    fn plays_with_contact(&self, _values: &Values) -> Vec<PlayId> {
        Vec::new()
    }

    /// The clearances which decide how finely a run is resolved, each with what has it in words; none where nothing is integrated.
    fn integrated_clearances(&self) -> Vec<(String, QuantityId)> {
        Vec::new()
    }

    /// The smallest of them at these values.
    fn smallest_clearance(&self, _values: &Values) -> Option<SmallestClearance> {
        None
    }

    /// Whether its outputs have paths with zones of play and scatter.
    fn has_paths_with_zones(&self) -> bool {
        false
    }

    /// The motion under settings `path=value`, with the paths of the points called `paths`, as the page of a study shows it, where the study has
    /// no run to draw. `None` if it has no answer.
    fn motion_of_page(&self, _settings: &[String], _paths: &[String]) -> Option<MotionRecord> {
        None
    }

    /// The mechanism under settings `path=value` over one cycle where actuators move it, so that it has no ideal motion; `None` if drives
    /// alone do, or where it cannot be followed.
    fn controlled_drawing(&self, _settings: &[String], _positions: usize) -> Option<Drawing> {
        None
    }

    /// Proofs of how far play and limits of parts move an output, where it has them.
    fn deviation_proofs(&self) -> Option<&dyn DeviationProofs> {
        None
    }

    /// Ends of how far play alone moves an output, where it has them.
    fn play_proofs(&self) -> Option<&dyn PlayProofs> {
        None
    }

    /// An error of its mechanism at the part that it concerns, where that is known.
    fn diagnostic_of_mechanism(&self, _error: &MechanismError) -> Option<Diagnostic> {
        None
    }

    /// A failure of a run at the part that it concerns, where that is known.
    fn diagnostic_of_run(&self, _failure: &RunFailure) -> Option<Diagnostic> {
        None
    }
}

/// A model of which it is known how far play alone moves its outputs.
pub trait PlayProofs {
    /// The ends of a deviation, found and proven, at these values.
    ///
    /// # Errors
    /// The loops do not close; a position has no answer; that it was stopped.
    fn play_ends(
        &self,
        values: &Values,
        question: &PlayQuestion,
        is_stopped: IsStopped<'_>,
    ) -> Result<PlayEnds, Diagnostics>;

    /// Whether outputs may depend on this quantity otherwise than through clearances.
    fn moves(&self, id: QuantityId) -> bool;
}

/// A model of which it can be proven how far its outputs go without dynamics.
pub trait DeviationProofs {
    /// The ends of deviations over a turn with dimensions within `limits`, counted from the mechanism of `values`, until `stop` is set.
    ///
    /// # Errors
    /// The mechanism has no ideal motion; that it was stopped.
    fn prove(
        &self,
        values: &Values,
        turn: (CycleSpan, usize),
        limits: &[DimensionLimit],
        questions: &[DeviationQuestion],
        stop: &AtomicBool,
    ) -> Result<ProvenDeviations, AccuracyError>;

    /// An error of [`Self::prove`] at the part that it concerns.
    fn diagnostic(&self, error: &AccuracyError) -> Diagnostic;
}

/// What is proven of deviations.
pub struct ProvenDeviations {
    /// Of each limit whether its quantity changes the ideal motion.
    pub moves: Vec<bool>,
    /// The ends, one for each question.
    pub ends: AllDeviationEnds,
}

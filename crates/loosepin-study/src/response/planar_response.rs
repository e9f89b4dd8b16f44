//! A planar mechanism whose runs are integrated, as a function from uncertain inputs to numbers.

use crate::file::{EpistemicSubject, MAX_POSES, Study};
use crate::model::outputs::OutputSource;
use crate::places::Pose;
use crate::response::columns::ColumnPlan;
#[cfg(test)]
use crate::response::extras::RunExtras;
use crate::response::ideal_tables::IdealTables;
use crate::response::input_targets::{InputTargets, in_the_middle};
use crate::response::limits::{MAX_COLUMNS, MAX_LAWS, MAX_RECORDED_TURNS, MAX_TURNS};
use crate::response::problem::PrepareError;
use crate::response::recorder::{Shared, positions};
use loosepin_math::sort_by_number;
use loosepin_mechanics::mechanism::{IdealMotion, Mechanism, MechanismError, Sample, SampleError};
use loosepin_mechanics::model::{
    ContactId, CycleInput, CycleSpan, LawError, Model, NormalDescription, PlayId, Position, QuantityError, QuantityId,
    Steady, Values,
};
use loosepin_result::study::PathError;
use loosepin_simulate::{
    Arms, IdealCurve, IdealNodes, IdealReference, Reading, RunFailure, Settings, Window, demand_dynamics,
};
use loosepin_uncertainty::EpistemicVariable;
use std::sync::Arc;

/// A compiled study: one mechanism for each combination of laws (a single one where no law is uncertain), one table of inputs.
///
/// A law is no number: all lanes of a batch have the same. So the runs of each combination are batches of their own, with the
/// same random numbers.
#[derive(Debug)]
pub struct PlanarResponse {
    /// The mechanism of each combination of laws, that of the first laws first, the law of the first contact changing fastest;
    /// compiled at the nominal values with the epistemic inputs in the middle of their intervals and at the first of a list.
    pub mechanisms: Vec<Mechanism>,
    /// Columns of a run, and the nominal ideal motion.
    pub shared: Shared,
    /// Names of the joints with play, each of which has extras in a row.
    pub joints: Vec<String>,
    /// Nominal values with the epistemic inputs in the middle.
    pub nominal: Values,
    /// The mechanism with every clearance at zero, and its nominal sample: what deviations are measured against.
    pub(crate) ideal: Mechanism,
    pub(crate) nominal_ideal: Sample<f64>,
    pub(crate) nominal_window: Window,
    pub(crate) ideal_tables: IdealTables,
    targets: InputTargets,
    pub(crate) restitutions: Vec<Option<QuantityId>>,
    pub(crate) transient_turns: f64,
    pub(crate) recorded_turns: f64,
    pub(crate) span: CycleSpan,
    pub(crate) settings: Settings,
    /// Evaluations after which a run is given up; its ideal motion has as many as the settings say.
    pub(crate) largest_evaluations: u64,
}

impl PlanarResponse {
    /// Compiles a study of `model`, with the joints with play that the values `at` of inputs give. All else is that of the nominal mechanism:
    /// what deviations are measured against, and the columns.
    ///
    /// # Errors
    /// The nominal mechanism has no ideal motion over the recorded part.
    pub(crate) fn with_plays(study: &Study, model: &Model, at: &[(QuantityId, f64)]) -> Result<Self, PrepareError> {
        let middle = in_the_middle(study);
        demand_dynamics(model)?;
        check_drive(study, model)?;
        check_turns(study.cycle.transient_turns, study.cycle.recorded_turns)?;
        let poses = study.cycle.recorded_turns * study.cycle.samples_per_turn as f64;
        if poses > MAX_POSES as f64 && study.asks.iter().any(|ask| ask.location.is_cycle()) {
            return Err(PrepareError::TooManyPoses { poses });
        }
        let nominal = model.quantities.evaluate(&middle)?;
        // The drawing is at its own temperature, whatever the file and the study say of the parts in use.
        let drawing = model.quantities.at_drawing(&nominal);
        let models = models_with_laws(study, model)?;
        let compiled_at = model.quantities.evaluate(&[&middle[..], at].concat())?;
        let mechanisms = models.iter().map(|model| Mechanism::new(model, &compiled_at));
        let mechanisms = mechanisms.collect::<Result<Vec<Mechanism>, MechanismError>>()?;
        let mechanism = &mechanisms[0];
        let of_drawing = if at.is_empty() { mechanism.clone() } else { Mechanism::new(&models[0], &nominal)? };
        let nominal_input = model.input(study.cycle.span, &nominal);
        let plan = ColumnPlan::new(study, nominal_input.start_rad, nominal_input.speed_rad_s.signum());
        if plan.columns.len() > MAX_COLUMNS {
            return Err(PrepareError::TooManyColumns { columns: plan.columns.len() });
        }
        check_poses(study, &plan)?;
        let nominal_window = window(&nominal_input, study.cycle.transient_turns, study.cycle.recorded_turns)?;
        let ideal = mechanism.without_play();
        let nominal_ideal = Sample::new(&of_drawing, &drawing).map_err(RunFailure::from)?.without_play();
        let settings = Settings { tolerance_m: study.sampling.tolerance_m, ..Settings::for_study() };
        // Where all motion is solved there are no steps with a dense output.
        let turns = (study.cycle.recorded_turns, !mechanism.is_ideal());
        let shared = share_nominal(plan, &ideal, &drawing, &nominal_ideal, &nominal_window, &settings, turns);
        let shared = shared.map_err(|error| match error {
            PrepareError::Nominal { failure } if !moves_alone(study, model) => PrepareError::OfModel { failure },
            error => error,
        })?;
        let play_name = |&play: &PlayId| model.play_name(play).to_owned();
        let restitutions = mechanism
            .plays
            .iter()
            .map(|&play| model.play_contact(play))
            .map(|contact| contact.and_then(|contact| model.contacts[contact.0].law.restitution()))
            .collect();
        Ok(Self {
            joints: mechanism.plays.iter().map(play_name).collect(),
            ideal,
            nominal_ideal,
            nominal_window,
            ideal_tables: IdealTables::default(),
            targets: InputTargets::new(study),
            restitutions,
            transient_turns: study.cycle.transient_turns,
            recorded_turns: study.cycle.recorded_turns,
            span: study.cycle.span,
            largest_evaluations: settings.largest_evaluations,
            settings,
            mechanisms,
            shared,
            nominal,
        })
    }

    /// The mechanism with the first law of every list: where the laws do not matter, and where one has to stand for all.
    pub fn mechanism(&self) -> &Mechanism {
        &self.mechanisms[0]
    }

    /// Which of the mechanisms runs with these epistemic inputs.
    pub fn variant(&self, epistemic: &[f64]) -> usize {
        self.targets.variant(epistemic)
    }

    /// How every run is integrated.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Gives every run up after this many evaluations.
    pub fn limit_evaluations(&mut self, largest_evaluations: u64) {
        self.largest_evaluations = largest_evaluations;
    }

    /// Time at the end of the nominal run, s.
    pub fn nominal_end_s(&self) -> f64 {
        self.nominal_window.end_s
    }

    /// The values of the model for these inputs.
    ///
    /// # Errors
    /// A value breaks its rule.
    pub fn values(&self, random: &[f64], epistemic: &[f64]) -> Result<Values, QuantityError> {
        self.targets.values(&self.mechanism().model.quantities, random, epistemic)
    }
}

#[cfg(test)]
impl PlanarResponse {
    /// Compiles `study`, whose model is planar.
    pub fn new(study: &Study) -> Result<Self, PrepareError> {
        Self::with_plays(study, study.model.demand_planar().unwrap(), &[])
    }

    /// Numbers of a row: columns, then extras.
    pub fn row_length(&self) -> usize {
        self.shared.plan.columns.len() + RunExtras::count(self.joints.len())
    }

    /// Extras of a run, read from its row.
    pub fn extras(&self, row: &[f64]) -> RunExtras {
        RunExtras::read(row, self.joints.len())
    }
}

/// The model with each combination of laws, those of the first contact changing fastest; the model alone where no law is
/// uncertain.
fn models_with_laws(study: &Study, model: &Model) -> Result<Vec<Model>, PrepareError> {
    let lists: Vec<(ContactId, &[NormalDescription])> = study
        .epistemic
        .iter()
        .filter_map(|input| match &input.subject {
            EpistemicSubject::Quantity(_) | EpistemicSubject::Parameter { .. } | EpistemicSubject::Play => None,
            EpistemicSubject::Law { contact, laws } => Some((*contact, &laws[..])),
        })
        .collect();
    let combinations = lists.iter().fold(1_usize, |product, (_, laws)| product.saturating_mul(laws.len()));
    if combinations > MAX_LAWS {
        return Err(PrepareError::TooManyLaws { combinations });
    }
    let of = |combination: usize| {
        let mut rest = combination;
        lists.iter().try_fold(model.clone(), |model, (contact, laws)| {
            let law = laws[rest % laws.len()];
            rest /= laws.len();
            model.with_law(*contact, law)
        })
    };
    Ok((0..combinations).map(of).collect::<Result<Vec<Model>, LawError>>()?)
}

/// Checks that a run of `transient` turns and `recorded` ones ends within a practical time.
pub fn check_turns(transient: f64, recorded: f64) -> Result<(), PrepareError> {
    for (turns, what, most, key) in [
        (recorded, "recorded", MAX_RECORDED_TURNS, "recorded_turns"),
        (transient + recorded, "run", MAX_TURNS, "transient_turns"),
    ] {
        if turns > most {
            return Err(PrepareError::TooManyTurns { turns, what, most, table: "cycle", key });
        }
    }
    Ok(())
}

/// The drive that the cycle counts must start where it always starts, and turn one way.
fn check_drive(study: &Study, model: &Model) -> Result<(), PrepareError> {
    let CycleSpan::Turns(drive) = study.cycle.span else { return Ok(()) };
    let Some(Steady { speed, start }) = model.drives[drive.0].law.steady() else { return Ok(()) };
    let random = study.random.iter().filter_map(|input| {
        let corners = |known: &EpistemicVariable| known.ends().to_vec();
        let range = input
            .variables(&study.epistemic, corners)
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[lower, upper], variable| {
                [lower.min(variable.quantile(1e-9)), upper.max(variable.quantile(1.0 - 1e-9))]
            });
        Some((&input.path, input.quantity()?, range))
    });
    let epistemic =
        study.epistemic.iter().filter_map(|input| Some((&input.path, input.quantity()?, input.variable.ends())));
    for (path, quantity, [lower, upper]) in random.chain(epistemic) {
        if model.quantities.depends_on(start, quantity) {
            return Err(PrepareError::UncertainStart { path: path.clone() });
        }
        if quantity == speed && lower <= 0.0 && upper >= 0.0 {
            return Err(PrepareError::SpeedThroughZero { path: path.clone() });
        }
    }
    Ok(())
}

/// By this share of a turn a pose may lie beyond the end of the record: round-off of angles.
pub(super) const POSE_ROUND_OFF: f64 = 1e-9;

/// The tables of the ideal motion may err by this share of the tolerance of positions, angles at the size of the mechanism.
const SHARE_OF_TOLERANCE: f64 = 0.1;

/// Loops are closed to less than this share of the size of the mechanism: no table can be held against anything nearer.
const ROUND_OFF_OF_LOOPS: f64 = 1e-11;

/// Every pose must be passed while the run is recorded.
pub(super) fn check_poses(study: &Study, plan: &ColumnPlan) -> Result<(), PrepareError> {
    let recorded_turns = study.cycle.recorded_turns;
    for column in &plan.columns {
        if let Some(Pose { turns, angle_rad }) = column.spot.pose()
            && turns > recorded_turns + POSE_ROUND_OFF
        {
            let output = plan.outputs[column.output].name.clone();
            return Err(PrepareError::PoseNotRecorded { output, angle_deg: angle_rad.to_degrees(), recorded_turns });
        }
    }
    Ok(())
}

/// A path has a direction wherever its point moves: where a part of its error counts that needs one, the point may be no slower than a share
/// of its mean speed anywhere.
fn check_paths(plan: &ColumnPlan, positions: &[Reading], curve: &IdealCurve, span_s: f64) -> Result<(), PrepareError> {
    /// Speeds that are looked at, for each piece of the curve.
    const LOOKS: usize = 4;
    const MIN_SHARE: f64 = 0.01;
    for output in plan.outputs.iter().enumerate().filter(|(index, _)| plan.is_used(*index)).map(|(_, output)| output) {
        let OutputSource::Path(readings, part) = output.seen else { continue };
        let places = readings.map(|reading| positions.iter().position(|known| *known == reading));
        let ([Some(x), Some(y)], true) = (places, part != PathError::Magnitude) else { continue };
        let looks = LOOKS * curve.nodes.pieces().iter().sum::<usize>();
        let velocity = |look: usize| [x, y].map(|reading| curve.jet(reading, look as f64 / looks as f64, span_s)[1]);
        let velocities: Vec<[f64; 2]> = (0..=looks).map(velocity).collect();
        let mean = velocities.iter().map(|[x, y]| x.hypot(*y)).sum::<f64>() / velocities.len() as f64;
        let slow = velocities.windows(2).position(|pair| !(least_length(pair[0], pair[1]) > MIN_SHARE * mean));
        if let Some(look) = slow {
            let share_percent = 100.0 * (look as f64 + 0.5) / looks as f64;
            return Err(PrepareError::PathStandsStill { output: output.name.clone(), share_percent });
        }
    }
    Ok(())
}

/// The least length of a vector on its straight way from one to another.
fn least_length([x, y]: [f64; 2], to: [f64; 2]) -> f64 {
    let [along_x, along_y] = [to[0] - x, to[1] - y];
    let square = along_x * along_x + along_y * along_y;
    let share = if square > 0.0 { (-(x * along_x + y * along_y) / square).clamp(0.0, 1.0) } else { 0.0 };
    (x + share * along_x).hypot(y + share * along_y)
}

/// The recorded part of a run.
pub(crate) fn window(input: &CycleInput, transient_turns: f64, recorded_turns: f64) -> Result<Window, RunFailure> {
    if !(input.speed_rad_s.abs() > 0.0) {
        return Err(RunFailure::StandsStill { drive: input.name.clone() });
    }
    let turn_s = input.turn_s();
    let start_s = transient_turns * turn_s;
    Ok(Window { start_s, end_s: start_s + recorded_turns * turn_s })
}

/// Whether the values of the model alone, without those of the study, have an ideal motion through all turns.
fn moves_alone(study: &Study, model: &Model) -> bool {
    let values = model.quantities.nominal();
    let moves = || -> Result<(), PrepareError> {
        let mechanism = Mechanism::new(model, &values)?;
        if mechanism.is_driven() {
            let sample = Sample::new(&mechanism, &values)?;
            let input = model.input(study.cycle.span, &values);
            let window = window(&input, study.cycle.transient_turns, study.cycle.recorded_turns)?;
            IdealMotion::new(&mechanism, &sample.ideal, &sample.drives)?.move_to(window.end_s)?;
        }
        Ok(())
    };
    moves().is_ok()
}

/// The nominal ideal motion: a table over the recorded part, and its exact values at the poses.
fn share_nominal(
    plan: ColumnPlan,
    ideal: &Mechanism,
    drawing: &Values,
    nominal_ideal: &Sample<f64>,
    nominal_window: &Window,
    settings: &Settings,
    (turns, is_integrated): (f64, bool),
) -> Result<Shared, PrepareError> {
    let arms = Arms::new(ideal, drawing);
    let span_s = nominal_window.end_s - nominal_window.start_s;
    let positions = positions(&plan);
    let arm_m =
        |reading: &Reading| if matches!(reading.position(), Some(Position::Angle(_))) { ideal.size_m } else { 1.0 };
    let mut reference = IdealReference::new(ideal, nominal_ideal, nominal_window.end_s, settings)?;
    let nominal_motion = reference.free_motion();
    // Where the search for a position begins decides on its last bits; a motion that forces decide is integrated once and for all.
    let fresh =
        || IdealReference::with_motion(ideal, nominal_ideal, nominal_motion.as_ref(), nominal_window.end_s, settings);
    let largest_error_m = (SHARE_OF_TOLERANCE * settings.tolerance_m).max(ROUND_OFF_OF_LOOPS * ideal.size_m);
    let nodes = IdealNodes::new(turns, span_s, largest_error_m, |share| {
        let time_s = nominal_window.start_s + share * span_s;
        let jet = |reading: &Reading| {
            Ok(reference.jet(reading, &arms, time_s)?.map(|derivative| derivative * arm_m(reading)))
        };
        positions.iter().map(jet).collect::<Result<Vec<_>, SampleError>>()
    })?;
    reference = fresh()?;
    let (start_s, nodes) = (nominal_window.start_s, Arc::new(nodes));
    let nominal_curve = reference.curve(&positions, &arms, (start_s, span_s), nodes)?;
    let mut pose_order: Vec<(f64, usize)> = plan
        .columns
        .iter()
        .enumerate()
        .filter_map(|(index, column)| Some((column.spot.pose()?.turns, index)))
        .collect();
    sort_by_number(&mut pose_order, |(turns, _)| *turns);
    let mut nominal_at_pose = vec![f64::NAN; plan.columns.len()];
    reference = fresh()?;
    for (at, index) in pose_order {
        let time_s = nominal_window.start_s + at * span_s / turns;
        let dynamics = reference.at(time_s, true)?;
        nominal_at_pose[index] = match plan.outputs[plan.columns[index].output].seen {
            OutputSource::Reading(reading) => reading.value(&arms, dynamics),
            // The ideal motion has no error.
            OutputSource::Path(..) => 0.0,
            // Wear is no number of a pose, and no planar model has outputs in space.
            OutputSource::Wear(..) | OutputSource::InSpace(_) => f64::NAN,
        };
    }
    check_paths(&plan, &positions, &nominal_curve, span_s)?;
    Ok(Shared::new(plan, nominal_curve, nominal_motion, nominal_at_pose, is_integrated))
}

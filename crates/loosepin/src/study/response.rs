//! A mechanism as a function from uncertain inputs to numbers: what the uncertainty wing sees.

use super::columns::{ColumnPlan, Spot};
use super::file::{Deviation, Study, Where};
use super::ideal_curve::IdealCurve;
use super::recorder::{Recorder, References, Shared};
use crate::bounds::{Failure, Response};
use crate::math::Vectors;
use crate::mechanism::{Mechanism, MechanismError, Sample};
use crate::model::{QuantityError, QuantityId, Values};
use crate::simulate::{
    Arms, IdealReference, Observer, Queue, Run, RunFailure, RunReport, Settings, Step, Window, conduct,
};

/// Poses of a curve, at most: every one has bounds of its own.
pub const LARGEST_POSES: f64 = 2000.0;

/// Why a study cannot begin.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PrepareError {
    /// The nominal mechanism.
    #[error(transparent)]
    Mechanism(#[from] MechanismError),
    /// The start of the drive is uncertain, so that samples would not be compared at the same input.
    #[error(
        "'{path}' is where the drive starts: every sample must start at the same place to be compared with the ideal motion"
    )]
    UncertainStart {
        /// Path of the quantity.
        path: String,
    },
    /// The speed of the drive may change its sign.
    #[error("'{path}' may be zero or change its direction: the turns of such a drive cannot be counted")]
    SpeedThroughZero {
        /// Path of the quantity.
        path: String,
    },
    /// A pose that the recorded part does not reach.
    #[error("output '{output}' is asked at {angle_deg:.6} deg; the recorded {recorded_turns} turns do not pass there")]
    PoseNotRecorded {
        /// The output.
        output: String,
        /// The angle asked for, degrees.
        angle_deg: f64,
        /// Recorded turns.
        recorded_turns: f64,
    },
    /// More poses than a study can bound.
    #[error("curves of {poses} poses are asked for; must be at most {LARGEST_POSES}")]
    TooManyPoses {
        /// Recorded turns times samples a turn.
        poses: f64,
    },
    /// The nominal run.
    #[error("the nominal mechanism, epistemic inputs in the middle of their intervals: {0}")]
    Nominal(#[from] RunFailure),
}

impl From<QuantityError> for PrepareError {
    fn from(error: QuantityError) -> Self {
        Self::Mechanism(error.into())
    }
}

/// Numbers of a run beside its columns, for the report and `runs.parquet`. They follow the columns in the sample table.
#[derive(Debug, Clone)]
pub struct Extras {
    /// Names of the joints with play.
    pub joints: Vec<String>,
}

/// Extras that every run has: energy residual, evaluations, steps, change over the last turn.
const COMMON_EXTRAS: usize = 4;
/// Extras of each joint with play: contacts, floored ones, those beyond validity, largest penetration, peak force,
/// nominal and delivered restitution.
const EXTRAS_PER_JOINT: usize = 7;

/// The extras of one run, read back from its row.
#[derive(Debug, Clone)]
pub struct RunExtras {
    /// Relative energy residual; not a number where the motion was not integrated.
    pub energy_residual: f64,
    /// Evaluations of the equations of motion.
    pub evaluations: f64,
    /// Accepted steps.
    pub steps: f64,
    /// Largest relative change of a pose over the last turn; not a number where no whole turn was recorded.
    pub change_over_last_turn: f64,
    /// One for each joint with play.
    pub joints: Vec<JointExtras>,
}

/// The extras of one joint with play.
#[derive(Debug, Clone, Copy)]
pub struct JointExtras {
    /// Contacts that began in the recorded turns.
    pub contacts: f64,
    /// Those that began slower than the floor of the law.
    pub floored: f64,
    /// Impacts faster than the law is meant for; not a number where its limit is unknown.
    pub beyond_validity: f64,
    /// Largest penetration, m.
    pub largest_penetration_m: f64,
    /// Largest normal force, N.
    pub peak_force_n: f64,
    /// Restitution as stated.
    pub nominal_restitution: f64,
    /// Restitution that a free impact delivers.
    pub delivered_restitution: f64,
}

impl Extras {
    /// How many numbers follow the columns.
    pub fn count(&self) -> usize {
        COMMON_EXTRAS + EXTRAS_PER_JOINT * self.joints.len()
    }

    /// Reads the extras back from the tail of a row.
    pub fn read(&self, row: &[f64]) -> RunExtras {
        let tail = &row[row.len() - self.count()..];
        let joints = tail[COMMON_EXTRAS..]
            .chunks_exact(EXTRAS_PER_JOINT)
            .map(|joint| JointExtras {
                contacts: joint[0],
                floored: joint[1],
                beyond_validity: joint[2],
                largest_penetration_m: joint[3],
                peak_force_n: joint[4],
                nominal_restitution: joint[5],
                delivered_restitution: joint[6],
            })
            .collect();
        RunExtras {
            energy_residual: tail[0],
            evaluations: tail[1],
            steps: tail[2],
            change_over_last_turn: tail[3],
            joints,
        }
    }
}

/// A compiled study: one mechanism, one table of inputs.
#[derive(Debug)]
pub struct StudyResponse {
    /// The mechanism, compiled at the nominal values with the epistemic inputs in the middle of their intervals.
    pub mechanism: Mechanism,
    /// What a run delivers, and the nominal ideal motion.
    pub shared: Shared,
    /// What follows the columns.
    pub extras: Extras,
    /// Nominal values with the epistemic inputs in the middle.
    pub nominal: Values,
    /// The mechanism with every clearance at zero, and its nominal sample: what deviations are measured against.
    ideal: Mechanism,
    nominal_ideal: Sample<f64>,
    nominal_window: Window,
    random: Vec<QuantityId>,
    epistemic: Vec<QuantityId>,
    restitutions: Vec<QuantityId>,
    transient_turns: f64,
    recorded_turns: f64,
    drive_speed: QuantityId,
    settings: Settings,
    needs_nominal_reference: bool,
}

impl StudyResponse {
    /// Compiles `study`.
    ///
    /// # Errors
    /// The nominal mechanism has no ideal motion over the recorded part.
    pub fn new(study: &Study) -> Result<Self, PrepareError> {
        let middle: Vec<(QuantityId, f64)> = study
            .epistemic
            .iter()
            .map(|input| (input.quantity, 0.5 * (input.interval.lower() + input.interval.upper())))
            .collect();
        check_drive(study)?;
        let poses = study.cycle.recorded_turns * study.cycle.samples_per_turn as f64;
        if poses > LARGEST_POSES && study.asks.iter().any(|ask| ask.location == Where::Cycle) {
            return Err(PrepareError::TooManyPoses { poses });
        }
        let nominal = study.model.quantities.evaluate(&middle)?;
        let mechanism = Mechanism::new(&study.model, &nominal)?;
        let drive = &study.model.drives[study.cycle.drive.0];
        let plan = ColumnPlan::new(study, &mechanism, nominal[drive.start], nominal[drive.speed].signum());
        let nominal_window =
            window(nominal[drive.speed], &drive.name, study.cycle.transient_turns, study.cycle.recorded_turns)?;
        let ideal = mechanism.without_play();
        let nominal_ideal = Sample::new(&mechanism, &nominal).map_err(RunFailure::from)?.without_play();
        let mut is_used = vec![false; plan.outputs.len()];
        for column in &plan.columns {
            is_used[column.output] = true;
        }
        let shared = share_nominal(plan, is_used, &ideal, &nominal, &nominal_ideal, &nominal_window, study)?;
        let joint_name = |joint: &crate::model::JointId| study.model.joints[joint.0].name.clone();
        let restitutions = mechanism
            .plays
            .iter()
            .filter_map(|joint| match &study.model.joints[joint.0].kind {
                crate::model::JointKind::Revolute { clearance: Some(clearance), .. } => {
                    Some(study.model.contacts[clearance.contact.0].restitution)
                }
                _ => None,
            })
            .collect();
        let needs_nominal_reference = shared.plan.outputs.iter().any(|output| !output.reading.is_position());
        Ok(Self {
            extras: Extras { joints: mechanism.plays.iter().map(joint_name).collect() },
            ideal,
            nominal_ideal,
            nominal_window,
            random: study.random.iter().map(|input| input.quantity).collect(),
            epistemic: study.epistemic.iter().map(|input| input.quantity).collect(),
            restitutions,
            transient_turns: study.cycle.transient_turns,
            recorded_turns: study.cycle.recorded_turns,
            drive_speed: drive.speed,
            settings: Settings { tolerance_m: study.sampling.tolerance_m, ..Settings::for_study() },
            needs_nominal_reference,
            mechanism,
            shared,
            nominal,
        })
    }

    /// Numbers of a row: columns, then extras.
    pub fn row_length(&self) -> usize {
        self.shared.plan.columns.len() + self.extras.count()
    }

    /// How every run is integrated.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Gives every run up after this many evaluations.
    pub fn limit_evaluations(&mut self, largest_evaluations: u64) {
        self.settings.largest_evaluations = largest_evaluations;
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
        let random = self.random.iter().copied().zip(random.iter().copied());
        let epistemic = self.epistemic.iter().copied().zip(epistemic.iter().copied());
        let set: Vec<(QuantityId, f64)> = random.chain(epistemic).collect();
        self.mechanism.model.quantities.evaluate(&set)
    }

    /// One run, alone.
    ///
    /// # Errors
    /// The one reason why the run failed.
    pub fn run(&self, random: &[f64], epistemic: &[f64], row: &mut [f64]) -> Result<(), RunFailure> {
        let mut inputs = Some((random, epistemic));
        let mut outcome = None;
        self.run_all(Vectors::None, || inputs.take().map(|(x, u)| (0, x, u)), |_, finished| outcome = Some(finished));
        let finished = outcome.unwrap_or(Err(RunFailure::NotFinite { time_s: 0.0 }))?;
        row.copy_from_slice(&finished);
        Ok(())
    }

    /// Runs on the lanes of this thread until `next` gives no more inputs; `finished` gets the rows, or the one reason why
    /// a run failed, under the index that came with the inputs. A row has the same bits whatever the lanes.
    pub fn run_all<'i>(
        &self,
        vectors: Vectors,
        next: impl FnMut() -> Option<(usize, &'i [f64], &'i [f64])>,
        finished: impl FnMut(usize, Result<Vec<f64>, RunFailure>),
    ) {
        let mut queue = StudyQueue { response: self, next, finished };
        conduct(&self.mechanism, &self.shared.readings, &self.settings, vectors, &mut queue);
    }

    /// Everything that a run needs.
    fn prepare(&self, index: usize, random: &[f64], epistemic: &[f64]) -> Result<Run<StudyRun<'_>>, RunFailure> {
        let values = self.values(random, epistemic).map_err(|error| RunFailure::Sample(error.into()))?;
        let sample = Sample::new(&self.mechanism, &values)?;
        let drive = &self.mechanism.model.drives[self.mechanism.model.cycle.drive.0];
        let window = window(values[self.drive_speed], &drive.name, self.transient_turns, self.recorded_turns)?;
        let turn_s = (window.end_s - window.start_s) / self.recorded_turns;
        let mut own = IdealReference::new(&self.ideal, &sample.clone().without_play())?;
        let arms = Arms::new(&self.mechanism, &values);
        let curve = if self.shared.needs_own_ideal {
            Some(IdealCurve::new(
                &mut own,
                &self.shared.plan.outputs,
                &self.shared.is_used,
                &arms,
                window.start_s,
                window.end_s - window.start_s,
                self.recorded_turns,
            )?)
        } else {
            None
        };
        let nominal = if self.needs_nominal_reference {
            Some(IdealReference::new(&self.ideal, &self.nominal_ideal)?)
        } else {
            None
        };
        let references = References { own, curve, nominal, nominal_window: self.nominal_window };
        let recorder = Recorder::new(&self.shared, arms.clone(), references, &window, turn_s);
        let contacts = sample
            .plays
            .iter()
            .zip(&self.restitutions)
            .map(|(play, restitution)| ContactNumbers {
                has_limit: play.largest_valid_impact_speed_m_s.is_finite(),
                nominal_restitution: values[*restitution],
                delivered_restitution: play.delivered_restitution,
            })
            .collect();
        Ok(Run { sample, arms, window, observer: StudyRun { index, recorder, contacts } })
    }

    /// The row of a finished run.
    fn row(&self, mut run: StudyRun<'_>, report: &RunReport) -> Result<Vec<f64>, RunFailure> {
        run.recorder.finish();
        if let Some(failure) = run.recorder.failure.take() {
            return Err(failure.into());
        }
        let change = run.recorder.change_over_last_turn(self.mechanism.size_m);
        let mut row = run.recorder.values;
        row.reserve_exact(self.extras.count());
        row.push(report.energy.map_or(f64::NAN, |account| account.relative_residual()));
        row.push(report.counters.evaluations as f64);
        row.push(report.counters.steps as f64);
        row.push(change.unwrap_or(f64::NAN));
        for (play, contact) in report.plays.iter().zip(&run.contacts) {
            row.extend([
                play.contacts as f64,
                play.floored_contacts as f64,
                if contact.has_limit { play.impacts_beyond_validity as f64 } else { f64::NAN },
                play.largest_penetration_m,
                play.peak_force_n,
                contact.nominal_restitution,
                contact.delivered_restitution,
            ]);
        }
        Ok(row)
    }
}

/// What the row of a run tells of a joint with play beside what the run counted.
struct ContactNumbers {
    has_limit: bool,
    nominal_restitution: f64,
    delivered_restitution: f64,
}

/// A run of the study on its lane.
struct StudyRun<'s> {
    index: usize,
    recorder: Recorder<'s>,
    contacts: Vec<ContactNumbers>,
}

impl Observer for StudyRun<'_> {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        self.recorder.step(step);
    }
}

/// Inputs that wait, and rows that are finished.
struct StudyQueue<'s, N, F> {
    response: &'s StudyResponse,
    next: N,
    finished: F,
}

impl<'s, 'i, N, F> Queue for StudyQueue<'s, N, F>
where
    N: FnMut() -> Option<(usize, &'i [f64], &'i [f64])>,
    F: FnMut(usize, Result<Vec<f64>, RunFailure>),
{
    type Observer = StudyRun<'s>;

    fn next(&mut self) -> Option<Run<StudyRun<'s>>> {
        loop {
            let (index, random, epistemic) = (self.next)()?;
            match self.response.prepare(index, random, epistemic) {
                Ok(run) => return Some(run),
                Err(failure) => (self.finished)(index, Err(failure)),
            }
        }
    }

    fn finished(&mut self, run: StudyRun<'s>, outcome: Result<RunReport, RunFailure>) {
        let index = run.index;
        (self.finished)(index, outcome.and_then(|report| self.response.row(run, &report)));
    }
}

impl Response for StudyResponse {
    fn evaluate(&self, random: &[f64], epistemic: &[f64], columns: &mut [f64]) -> Result<(), Failure> {
        self.run(random, epistemic, columns).map_err(|failure| Failure(failure.number()))
    }
}

/// The drive that the cycle counts must start where it always starts, and turn one way.
fn check_drive(study: &Study) -> Result<(), PrepareError> {
    let drive = &study.model.drives[study.cycle.drive.0];
    let random = study.random.iter().map(|input| {
        let range = [1e-9, 1.0 - 1e-9].map(|probability| input.variable.quantile(probability));
        (&input.path, input.quantity, range)
    });
    let epistemic = study
        .epistemic
        .iter()
        .map(|input| (&input.path, input.quantity, [input.interval.lower(), input.interval.upper()]));
    for (path, quantity, [lower, upper]) in random.chain(epistemic) {
        let roots = |id: QuantityId| id == quantity || study.model.roots(id).contains(&quantity);
        if roots(drive.start) {
            return Err(PrepareError::UncertainStart { path: path.clone() });
        }
        if quantity == drive.speed && lower <= 0.0 && upper >= 0.0 {
            return Err(PrepareError::SpeedThroughZero { path: path.clone() });
        }
    }
    Ok(())
}

/// The recorded part of a run.
fn window(
    drive_speed_rad_s: f64,
    drive: &str,
    transient_turns: f64,
    recorded_turns: f64,
) -> Result<Window, RunFailure> {
    if !(drive_speed_rad_s.abs() > 0.0) {
        return Err(RunFailure::StandsStill { drive: drive.to_owned() });
    }
    let turn_s = std::f64::consts::TAU / drive_speed_rad_s.abs();
    let start_s = transient_turns * turn_s;
    Ok(Window { start_s, end_s: start_s + recorded_turns * turn_s })
}

/// The nominal ideal motion: a table over the recorded part, and its exact values at the poses.
fn share_nominal(
    plan: ColumnPlan,
    is_used: Vec<bool>,
    ideal: &Mechanism,
    nominal: &Values,
    nominal_ideal: &Sample<f64>,
    nominal_window: &Window,
    study: &Study,
) -> Result<Shared, RunFailure> {
    let arms = Arms::new(ideal, nominal);
    let span_s = nominal_window.end_s - nominal_window.start_s;
    let turns = study.cycle.recorded_turns;
    let mut reference = IdealReference::new(ideal, nominal_ideal)?;
    let nominal_curve =
        IdealCurve::new(&mut reference, &plan.outputs, &is_used, &arms, nominal_window.start_s, span_s, turns)?;
    let mut pose_order: Vec<(f64, usize)> = plan
        .columns
        .iter()
        .enumerate()
        .filter_map(|(index, column)| match column.spot {
            Spot::Pose { turns, .. } => Some((turns, index)),
            Spot::Reduced(_) => None,
        })
        .collect();
    pose_order.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let mut nominal_at_pose = vec![f64::NAN; plan.columns.len()];
    let mut reference = IdealReference::new(ideal, nominal_ideal)?;
    for &(at, index) in &pose_order {
        let reading = plan.outputs[plan.columns[index].output].reading;
        let time_s = nominal_window.start_s + at * span_s / turns;
        let dynamics = reference.at(time_s, true)?;
        nominal_at_pose[index] = reading.value(&arms, dynamics);
    }
    let pose_order = pose_order.into_iter().map(|(_, index)| index).collect();
    let needs_own_ideal =
        plan.columns.iter().any(|column| matches!(column.deviation, Deviation::Clearance | Deviation::Dimensional));
    let mut readings = Vec::new();
    let places = plan
        .outputs
        .iter()
        .zip(&is_used)
        .map(|(output, is_used)| {
            (*is_used && output.reading.is_position()).then(|| {
                readings.push(output.reading);
                readings.len() - 1
            })
        })
        .collect();
    Ok(Shared { plan, is_used, needs_own_ideal, readings, places, nominal_curve, nominal_at_pose, pose_order })
}

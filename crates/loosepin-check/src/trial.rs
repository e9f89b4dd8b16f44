//! Moving a mechanism for the first time.

use std::f64::consts::TAU;
use std::sync::atomic::{AtomicBool, Ordering};

use loosepin_mechanics::mechanism::{IdealMotion, Kinematics, Mechanism, Sample};
use loosepin_mechanics::model::{DriveId, Values};
use loosepin_simulate::{FIRST_LOOK_STEPS, Observer, Plan, RunFailure, Settings, Step, Window, input, run};

/// Positions of a turn in which the ideal mechanism is closed; of hundreds of links fewer, since each takes the square of the free
/// coordinates. Between them the motion is followed in steps of a fifth of a radian.
const POSITIONS_PER_TURN: f64 = 360.0;
const MIN_POSITIONS_PER_TURN: f64 = 36.0;
const POSITIONS_TIMES_SQUARES: f64 = 5e7;
/// Turns that are looked at, at most: later ones repeat them unless several drives differ in speed.
const MAX_TURNS: f64 = 20.0;
/// The mechanism is where it was a turn before when no body is further off than this share of its size, or turned by more, rad.
const SAME: f64 = 1e-6;
/// Share of a turn that the dynamic trial lasts.
const TRIAL_TURNS: f64 = 1.0 / 360.0;
/// Evaluations after which the trial has shown enough: a slow mechanism settles into resting contact long before.
const TRIAL_EVALUATIONS: f64 = 100_000.0;
/// Multiplications that the trial may take, a few tenths of a second: of a chain of many links an evaluation alone takes millions.
const TRIAL_MULTIPLICATIONS: f64 = 2e8;
/// Evaluations of the first two steps, without which a trial shows nothing.
const MIN_EVALUATIONS: f64 = 26.0;

/// Result of the trial.
#[derive(Debug)]
pub struct TrialResult {
    /// Positions of all points of each body at the start, m, and the angle of the body, rad; the ground first.
    pub start: Vec<BodyStart>,
    /// Duration of a turn of the cycle's drive, s.
    pub turn_s: f64,
    /// Turns after which the ideal mechanism was followed no further, where they are less than its cycle.
    pub left_after_turns: Option<f64>,
    /// Whether the first steps of the run were made.
    pub is_run: bool,
}

/// Initial position of a body.
#[derive(Debug)]
pub struct BodyStart {
    /// Angle of the body's x axis from the ground's, rad.
    pub angle_rad: f64,
    /// Positions of its points seen from the ground, m.
    pub points_m: Vec<[f64; 2]>,
}

/// Holds the run that the model asks for against the limits of runs.
///
/// # Errors
/// The limit that it exceeds.
pub fn check_run(mechanism: &Mechanism, values: &Values) -> Result<(), RunFailure> {
    Plan::of_model(&mechanism.model).check(mechanism, &Sample::new(mechanism, values)?, values)
}

/// Closes the ideal mechanism all around its cycle where drives move it, and runs the first stretch of the real one.
///
/// # Errors
/// The first position that does not close, or why the run failed; `stop` was set.
pub fn run_trial(mechanism: &Mechanism, values: &Values, stop: &AtomicBool) -> Result<TrialResult, RunFailure> {
    let turn_s = input(mechanism, values, mechanism.model.cycle.span)?.turn_s();
    let sample = Sample::new(mechanism, values)?;
    let (start, left_after_turns) = if mechanism.is_driven() {
        close_all_round((mechanism, values, &sample), turn_s, stop)?
    } else {
        let (ideal, sample) = (mechanism.without_play(), sample.clone().without_play());
        let (coordinates, _) = ideal.start(&sample)?;
        let mut kinematics = Kinematics::new(&ideal.ideal);
        kinematics.set_positions(&ideal.ideal, &sample.ideal, &coordinates);
        let start = body_starts(mechanism, values, &kinematics);
        if !mechanism.plays.is_empty() {
            // What a run is compared with.
            first_steps(&ideal, &sample, turn_s, stop)?;
        }
        (start, None)
    };
    let has_dynamics = mechanism.model.missing_for_runs.is_empty();
    let is_run = has_dynamics && first_steps(mechanism, &sample, turn_s, stop)?;
    Ok(TrialResult { start, turn_s, left_after_turns, is_run })
}

/// Closes the ideal mechanism in all positions of its cycle until they repeat themselves; gives where it starts, and after how many turns
/// it was left, where they are less than the cycle.
fn close_all_round(
    (mechanism, values, sample): (&Mechanism, &Values, &Sample<f64>),
    turn_s: f64,
    stop: &AtomicBool,
) -> Result<(Vec<BodyStart>, Option<f64>), RunFailure> {
    let cycle = &mechanism.model.cycle;
    let mut motion = IdealMotion::new(mechanism, &sample.ideal, &sample.drives)?;
    let start = motion.kinematics().poses.clone();
    let starts = body_starts(mechanism, values, motion.kinematics());
    let asked = cycle.transient_turns + cycle.recorded_turns;
    let turns = asked.min(MAX_TURNS).min(FIRST_LOOK_STEPS / motion.longest_way(motion.time_s() + turn_s).1);
    let square = (mechanism.ideal.free as f64).powi(2);
    let per_turn = (POSITIONS_TIMES_SQUARES / square).floor().clamp(MIN_POSITIONS_PER_TURN, POSITIONS_PER_TURN);
    let positions = (turns * per_turn).ceil() as usize;
    let is_steady = (0..mechanism.model.drives.len()).all(|k| sample.drives.constant_speed(DriveId(k)).is_some());
    for position in 1..=positions {
        let time_s = turns * turn_s * position as f64 / positions as f64;
        if stop.load(Ordering::Relaxed) {
            return Err(RunFailure::Stopped { time_s });
        }
        motion.move_to(time_s)?;
        let is_same = || {
            start.iter().zip(&motion.kinematics().poses).all(|(before, now)| {
                let turned_rad = now.angle_rad() - before.angle_rad();
                (now.position_m - before.position_m).length() <= SAME * mechanism.size_m
                    && (turned_rad - TAU * (turned_rad / TAU).round()).abs() <= SAME
            })
        };
        if is_steady && position.is_multiple_of(per_turn as usize) && is_same() {
            break;
        }
    }
    Ok((starts, (turns < asked.min(1.0)).then_some(turns)))
}

/// Runs the first stretch; false where an evaluation is too long for that.
fn first_steps(
    mechanism: &Mechanism,
    sample: &Sample<f64>,
    turn_s: f64,
    stop: &AtomicBool,
) -> Result<bool, RunFailure> {
    let evaluations = trial_evaluations(mechanism.is_ideal(), mechanism.multiplications());
    if evaluations < MIN_EVALUATIONS {
        return Ok(false);
    }
    let settings = Settings { largest_evaluations: evaluations as u64, ..Settings::for_simulation() };
    let window = Window { start_s: 0.0, end_s: TRIAL_TURNS * turn_s };
    match run(mechanism, sample, &window, &settings, &mut UntilStopped(stop)) {
        Ok(_) => Ok(true),
        Err(RunFailure::TooManyEvaluations { time_s, .. }) => Ok(time_s > 0.0),
        Err(failure) => Err(failure),
    }
}

/// Evaluations of the trial at most. A motion that its drives determine needs none of its equations of motion.
fn trial_evaluations(is_ideal: bool, multiplications: f64) -> f64 {
    if is_ideal { TRIAL_EVALUATIONS } else { TRIAL_EVALUATIONS.min(TRIAL_MULTIPLICATIONS / multiplications) }
}

fn body_starts(mechanism: &Mechanism, values: &Values, ideal: &Kinematics<f64>) -> Vec<BodyStart> {
    let bodies = mechanism.model.bodies.iter().enumerate();
    bodies
        .map(|(index, body)| {
            let pose = &ideal.poses[mechanism.ideal.slot_of_body[index]];
            let point_m = |x: f64, y: f64| {
                let point = pose.point_m(loosepin_math::Vec2::new(x, y));
                [point.x, point.y]
            };
            BodyStart {
                // Whole turns say nothing about a position.
                angle_rad: pose.angle_rad() - TAU * (pose.angle_rad() / TAU).round(),
                points_m: body
                    .points
                    .iter()
                    .map(|point| point_m(values[point.position_m[0]], values[point.position_m[1]]))
                    .collect(),
            }
        })
        .collect()
}

/// Sees nothing of a run, until it is to be given up.
struct UntilStopped<'s>(&'s AtomicBool);

impl Observer for UntilStopped<'_> {
    fn step(&mut self, _step: &mut Step<'_, '_>) {}
    fn is_stopped(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

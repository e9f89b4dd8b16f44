//! Moving a mechanism for the first time.

use std::f64::consts::TAU;

use loosepin::mechanism::{Mechanism, Sample};
use loosepin::model::{DriveId, JointKind, Values};
use loosepin::simulate::{IdealReference, RunFailure, Settings, Window, input, run};
use loosepin::simulate::{Observer, Step};

/// Positions of a turn in which the ideal mechanism is closed.
const POSITIONS_PER_TURN: usize = 360;
/// Turns that are looked at, at most: later ones repeat them unless several drives differ in speed.
const MOST_TURNS: f64 = 20.0;
/// Turns of the fastest drive that are looked at, at most: a second drive may be very much faster than the one that counts.
const MOST_TURNS_OF_THE_FASTEST: f64 = 1000.0;
/// Share of a turn that the dynamic trial lasts.
const TRIAL_TURNS: f64 = 1.0 / 360.0;
/// Evaluations after which the trial has shown enough: a slow mechanism settles into resting contact long before.
const TRIAL_EVALUATIONS: u64 = 100_000;

/// Result of the trial.
#[derive(Debug)]
pub struct Trial {
    /// Positions of all points of each body at the start, m, and the angle of the body, rad; the ground first.
    pub start: Vec<BodyStart>,
    /// Duration of a turn of the cycle's drive, s.
    pub turn_s: f64,
}

/// Where a body is at the start.
#[derive(Debug)]
pub struct BodyStart {
    /// Angle of the body's x axis from the ground's, rad.
    pub angle_rad: f64,
    /// Positions of its points seen from the ground, m.
    pub points_m: Vec<[f64; 2]>,
}

/// Closes the ideal mechanism all around its cycle where drives move it, and runs the first stretch of the real one.
///
/// # Errors
/// The first position that does not close, or why the run failed.
pub fn try_out(mechanism: &Mechanism, values: &Values) -> Result<Trial, RunFailure> {
    let cycle = &mechanism.model.cycle;
    let turn_s = input(mechanism, values, cycle.span)?.turn_s();
    let sample = Sample::new(mechanism, values)?;
    let (ideal, ideal_sample) = (mechanism.without_play(), sample.clone().without_play());
    let settings = Settings { largest_evaluations: TRIAL_EVALUATIONS, ..Settings::for_simulation() };
    let window = Window { start_s: 0.0, end_s: TRIAL_TURNS * turn_s };
    let mut motion = IdealReference::new(&ideal, &ideal_sample, window.end_s, &settings)?;
    let start = body_starts(mechanism, values, motion.at(0.0, false)?);
    let turns = if mechanism.is_driven() {
        (cycle.transient_turns + cycle.recorded_turns)
            .min(MOST_TURNS)
            .min(MOST_TURNS_OF_THE_FASTEST / speed_ratio(mechanism, &sample, turn_s))
    } else {
        0.0
    };
    let positions = (turns * POSITIONS_PER_TURN as f64).ceil() as usize;
    for position in 1..=positions {
        motion.at(turns * turn_s * position as f64 / positions as f64, false)?;
    }
    match run(mechanism, &sample, &window, &settings, &mut Unobserved) {
        Ok(_) | Err(RunFailure::TooManyEvaluations { .. }) => Ok(Trial { start, turn_s }),
        Err(failure) => Err(failure),
    }
}

/// Turns of the fastest drive in one turn of the cycle, >= 1. Lengths count as angles over the size of the mechanism; a motion
/// that is not at constant speed has as many as the cycle.
fn speed_ratio(mechanism: &Mechanism, sample: &Sample<f64>, turn_s: f64) -> f64 {
    let model = &mechanism.model;
    let rates = model.drives.iter().enumerate().filter_map(|(index, drive)| {
        let speed = sample.drives.constant_speed(DriveId(index))?.abs();
        Some(match model.joints[drive.joint.0].kind {
            JointKind::Prismatic { .. } => speed / mechanism.size_m,
            _ => speed,
        })
    });
    (rates.fold(0.0, f64::max) * turn_s / TAU).max(1.0)
}

fn body_starts(
    mechanism: &Mechanism,
    values: &Values,
    ideal: &loosepin::dynamics::Dynamics<'_, f64>,
) -> Vec<BodyStart> {
    let bodies = mechanism.model.bodies.iter().enumerate();
    bodies
        .map(|(index, body)| {
            let pose = &ideal.kinematics.poses[mechanism.ideal.slot_of_body[index]];
            let point_m = |x: f64, y: f64| {
                let point = pose.point_m(loosepin::math::Vec2::new(x, y));
                [point.x, point.y]
            };
            BodyStart {
                // Whole turns say nothing about a position.
                angle_rad: pose.angle_rad - TAU * (pose.angle_rad / TAU).round(),
                points_m: body
                    .points
                    .iter()
                    .map(|point| point_m(values[point.position_m[0]], values[point.position_m[1]]))
                    .collect(),
            }
        })
        .collect()
}

struct Unobserved;

impl Observer for Unobserved {
    fn step(&mut self, _step: &mut Step<'_, '_>) {}
}

//! Runs from the start to the end of their windows.

use super::batch::{Batch, LARGEST_RESIDUAL, LARGEST_STEP_TURNS, Queue, Run, Seats};
use super::column::{Arms, Reading};
use super::execution::Execution;
use super::failure::RunFailure;
use super::gap::GapJet;
use super::motion::Motion;
use super::observer::{Observer, Onset, Separation, Source, Step};
use super::pace::fastest_drive_rad_s;
use super::report::{Counters, RunReport};
use super::resume::MotionState;
use super::settings::{Settings, Window};
use super::work::KinematicAccount;
use loosepin_mechanics::mechanism::{IdealMotion, Mechanism, Sample};

/// Runs one sample to the end of `window`, showing every step to `observer`.
///
/// Starts from the ideal positions and velocities of the sample at time zero, journals centred. A mechanism without play
/// whose drives move every freedom follows them exactly: its loops are solved instead of integrated.
///
/// # Errors
/// The one reason why the run failed.
pub fn run(
    mechanism: &Mechanism,
    sample: &Sample<f64>,
    window: &Window,
    settings: &Settings,
    observer: &mut dyn Observer,
) -> Result<RunReport, RunFailure> {
    run_from(mechanism, sample, window, settings, None, observer)
}

/// [`run`], from where another run ended.
pub(super) fn run_from(
    mechanism: &Mechanism,
    sample: &Sample<f64>,
    window: &Window,
    settings: &Settings,
    resume: Option<MotionState>,
    observer: &mut dyn Observer,
) -> Result<RunReport, RunFailure> {
    let run = Run { sample: sample.clone(), arms: Arms::none(), window: *window, observer, resume };
    let mut queue = One { run: Some(run), outcome: None };
    conduct(mechanism, &[], settings, Execution::Scalar, &mut queue);
    queue.outcome.unwrap_or(Err(RunFailure::NotFinite { time_s: 0.0 }))
}

/// Runs everything in `queue` on this thread, following `readings`. Each run has the same bits whatever the execution.
pub fn conduct<O: Observer>(
    mechanism: &Mechanism,
    readings: &[Reading],
    settings: &Settings,
    execution: Execution,
    queue: &mut dyn Queue<Observer = O>,
) {
    if mechanism.is_ideal() {
        while let Some(run) = queue.next() {
            let Run { sample, arms, window, mut observer, .. } = run;
            let outcome = run_kinematics(mechanism, &sample, &arms, readings, &window, &mut observer);
            queue.finished(observer, outcome);
        }
        return;
    }
    Batch::conduct(mechanism, readings, settings, execution, &mut Seats::new(queue));
}

/// A queue of one run.
struct One<'o> {
    run: Option<Run<&'o mut dyn Observer>>,
    outcome: Option<Result<RunReport, RunFailure>>,
}

impl<'o> Queue for One<'o> {
    type Observer = &'o mut dyn Observer;

    fn next(&mut self) -> Option<Run<Self::Observer>> {
        self.run.take()
    }
    fn finished(&mut self, _observer: Self::Observer, outcome: Result<RunReport, RunFailure>) {
        self.outcome = Some(outcome);
    }
}

impl Observer for &mut dyn Observer {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        (**self).step(step);
    }
    fn contact_begins(&mut self, onset: &Onset) {
        (**self).contact_begins(onset);
    }
    fn contact_ends(&mut self, separation: &Separation) {
        (**self).contact_ends(separation);
    }
    fn is_stopped(&self) -> bool {
        (**self).is_stopped()
    }
}

fn run_kinematics(
    mechanism: &Mechanism,
    sample: &Sample<f64>,
    arms: &Arms,
    readings: &[Reading],
    window: &Window,
    observer: &mut dyn Observer,
) -> Result<RunReport, RunFailure> {
    let mut ideal = IdealMotion::new(mechanism, &sample.ideal, &sample.drives)?;
    let mut motion = Motion::new(mechanism, sample);
    let turn_s = std::f64::consts::TAU / fastest_drive_rad_s(mechanism, sample, window.end_s);
    let ends_s = step_ends_s(sample, window, LARGEST_STEP_TURNS * turn_s);
    let steps = ends_s.len() as u64;
    ideal.move_to(window.start_s)?;
    let mut account = KinematicAccount::is_needed(&motion).then(|| KinematicAccount::new(&mut motion, &ideal));
    let mut failure = None;
    let mut outputs = vec![[[0.0; 3]; 2]; readings.len()];
    let (mut start_s, has_pieces) = (window.start_s, sample.drives.has_pieces());
    for (step, end_s) in ends_s.into_iter().enumerate() {
        if has_pieces {
            let middle_s = 0.5 * (start_s + end_s);
            ideal.hold_pieces(Some(middle_s));
            motion.dynamics.sample_mut().drives.take_pieces_at(middle_s);
        }
        for (side, time_s) in [(0, start_s), (1, end_s)] {
            if readings.is_empty() || (side == 0 && step > 0 && !has_pieces) {
                outputs.iter_mut().for_each(|jets| jets[0] = jets[1]);
                continue;
            }
            ideal.move_to(time_s)?;
            let (coordinates, rates) = ideal.real_state();
            let n = motion.freedoms();
            motion.dynamics.evaluate(time_s, &coordinates[..n], &rates[..n], &motion.states);
            for (jets, reading) in outputs.iter_mut().zip(readings) {
                jets[side] = reading.jet(arms, &motion.dynamics);
            }
        }
        let source = Source::Kinematic {
            motion: &mut motion,
            ideal: &mut ideal,
            failure: &mut failure,
            account: account.as_ref(),
        };
        let time = [start_s, end_s].map(|time_s| GapJet { jet: [time_s, 1.0, 0.0] });
        observer.step(&mut Step { source, start_s, end_s, length: end_s - start_s, time, outputs: &outputs });
        if let Some(error) = failure {
            return Err(error.into());
        }
        if observer.is_stopped() {
            return Err(RunFailure::Stopped { time_s: end_s });
        }
        match &mut account {
            Some(account) => {
                account.close_step(&mut motion, &mut ideal, start_s, end_s)?;
                let mut jams = None;
                motion.dynamics.joint_friction_residuals(|index, residual| {
                    if !(residual <= LARGEST_RESIDUAL) {
                        jams = jams.or(Some(index));
                    }
                });
                if let Some(index) = jams {
                    let joint = mechanism.model.joints[sample.frictions[index].joint.0].name.clone();
                    return Err(RunFailure::Jams { joint, time_s: end_s });
                }
            }
            None => ideal.move_to(end_s)?,
        }
        start_s = end_s;
    }
    let energy = account.map(|account| account.total());
    let counters = Counters { steps, ..Counters::default() };
    Ok(RunReport { counters, plays: Vec::new(), energy, friction_losses: Vec::new() })
}

/// Ends of equal steps of at most `longest_s` over `window`, from one break of the drives to the next.
fn step_ends_s(sample: &Sample<f64>, window: &Window, longest_s: f64) -> Vec<f64> {
    /// Steps between two breaks, at most.
    const MOST_STEPS: f64 = 1e9;
    let mut ends_s = Vec::new();
    let mut start_s = window.start_s;
    while start_s < window.end_s {
        let stop_s = sample.drives.next_break_s(start_s).min(window.end_s);
        let span_s = stop_s - start_s;
        let steps = (span_s / longest_s).ceil().clamp(1.0, MOST_STEPS) as u64;
        ends_s.extend((1..steps).map(|step| start_s + span_s * step as f64 / steps as f64));
        ends_s.push(stop_s);
        start_s = stop_s;
    }
    ends_s
}

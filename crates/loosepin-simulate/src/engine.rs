//! Runs from the start to the end of their windows.

use super::failure::RunFailure;
use super::follow::{Findings, Follow, FollowLayout, FollowedRun, LaneFollow, StepEnds};
use super::observer::{Observer, Onset, Separation, Source, Step};
use super::resume::MotionState;
use super::settings::{Integrator, Settings, Window};
use crate::lanes::batch::{Batch, CompiledCodeCache, HandledQueue, MAX_STEP_TURNS, Queue, Run};
use crate::lanes::execution::Execution;
use crate::lanes::pass::MAX_RESIDUAL;
use crate::recording::report::RunReport;
use crate::recording::work::KinematicAccount;
use crate::stepping::gap::GapJet;
use crate::stepping::motion::Motion;
use crate::stepping::pace::fastest_drive_rad_s;
use loosepin_mechanics::mechanism::{Arms, IdealMotion, Mechanism, Sample};
use loosepin_mechanics::model::{Model, TimeCourse};
use loosepin_result::simulation::RunCounters;

/// Multiplications of an evaluation up to which the equations are written down for many lanes: of more (some 80 links in a row) the
/// programs would take seconds to make and gigabytes to hold, and runs are made one after the other.
const MAX_RECORDED_MULTIPLICATIONS: f64 = 4e5;
/// Points of the tables of loads up to which they are written down: programs look at all of them, and 1440 take three seconds to
/// make; a run alone finds its place among them by halving.
const MAX_RECORDED_POINTS: usize = 1000;

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
    run_from(mechanism, sample, (window, settings), None, &mut CompiledCodeCache::default(), observer)
}

/// [`run`], from where another run ended, with what runs of the same mechanism and settings before it kept.
pub(super) fn run_from<'m>(
    mechanism: &'m Mechanism,
    sample: &Sample<f64>,
    (window, settings): (&Window, &Settings),
    resume: Option<MotionState>,
    kept: &mut CompiledCodeCache<'m>,
    observer: &mut dyn Observer,
) -> Result<RunReport, RunFailure> {
    demand_dynamics(&mechanism.model)?;
    let run = Run {
        sample: sample.clone(),
        arms: Arms::none(),
        window: *window,
        observer,
        followed: FollowedRun::default(),
        resume,
    };
    let mut queue = One { run: Some(run), outcome: None };
    if mechanism.is_ideal() {
        run_batch(mechanism, &Follow::default(), settings, Execution::Scalar, &mut queue);
    } else {
        let later = match execution_of(mechanism, Execution::best()) {
            execution @ Execution::MachineCode(_) if settings.integrator != Integrator::Implicit => Some(execution),
            _ => None,
        };
        Batch::run_alone(mechanism, settings, later, kept, &mut HandledQueue::new(&mut queue));
    }
    queue.outcome.unwrap_or(Err(RunFailure::NotFinite { time_s: 0.0, element: None }))
}

/// Runs everything in `queue` on this thread, following what `follow` says. Each run has the same bits whatever the execution.
pub fn run_batch<O: Observer>(
    mechanism: &Mechanism,
    follow: &Follow,
    settings: &Settings,
    execution: Execution,
    queue: &mut dyn Queue<Observer = O>,
) {
    if let Err(failure) = demand_dynamics(&mechanism.model) {
        while let Some(run) = queue.next() {
            queue.finished(run.observer, Err(failure.clone()));
        }
        return;
    }
    if mechanism.is_ideal() {
        while let Some(run) = queue.next() {
            let Run { sample, arms, window, mut observer, followed, .. } = run;
            let outcome =
                run_kinematics(mechanism, (&sample, &arms), (follow, followed), (&window, settings), &mut observer);
            queue.finished(observer, outcome);
        }
        return;
    }
    let is_implicit = settings.integrator == Integrator::Implicit;
    let execution = if is_implicit { Execution::Scalar } else { execution_of(mechanism, execution) };
    Batch::run(mechanism, follow, settings, execution, &mut HandledQueue::new(queue));
}

/// Refuses a model that is complete for its motion only.
///
/// # Errors
/// What a run needs first of all that is missing.
pub fn demand_dynamics(model: &Model) -> Result<(), RunFailure> {
    match model.missing_for_runs.as_slice() {
        [] => Ok(()),
        [first, others @ ..] => Err(RunFailure::NoDynamics { missing: first.message.clone(), others: others.len() }),
    }
}

/// Execution of the runs of `mechanism` with the available `execution`.
fn execution_of(mechanism: &Mechanism, execution: Execution) -> Execution {
    let points = mechanism.model.loads.iter().map(|load| match &load.course {
        Some(TimeCourse::Table(table)) => table.points.len(),
        _ => 0,
    });
    let is_short =
        mechanism.multiplications() <= MAX_RECORDED_MULTIPLICATIONS && points.sum::<usize>() <= MAX_RECORDED_POINTS;
    // Which sectors of a worn joint touch depends on the state: its equations cannot be written down.
    let is_short = is_short && !mechanism.model.has_worn_geometry();
    if is_short { execution } else { Execution::Scalar }
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
    fn awaits_s(&self) -> f64 {
        (**self).awaits_s()
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
    (sample, arms): (&Sample<f64>, &Arms),
    (follow, followed): (&Follow, FollowedRun),
    (window, settings): (&Window, &Settings),
    observer: &mut dyn Observer,
) -> Result<RunReport, RunFailure> {
    let mut ideal = IdealMotion::new(mechanism, &sample.ideal, &sample.drives)?;
    let mut motion = Motion::new(mechanism, sample);
    let ends_s = step_ends_s(sample, *window, longest_step_s(mechanism, sample, window));
    let limit = settings.largest_evaluations;
    ideal.move_to(window.start_s)?;
    let mut account = KinematicAccount::is_needed(&motion).then(|| KinematicAccount::new(&mut motion, &ideal));
    let mut failure = None;
    let mut outputs = vec![[[0.0; 3]; 2]; follow.readings.len()];
    let (mut start_s, has_pieces) = (window.start_s, sample.drives.has_pieces());
    let mut steps = 0_u64;
    let mut follower = Follower::new(follow, followed, *window);
    for end_s in ends_s {
        if has_pieces {
            let middle_s = 0.5 * (start_s + end_s);
            ideal.hold_pieces(Some(middle_s));
            motion.dynamics.sample_mut().drives.take_pieces_at(middle_s);
        }
        for (side, time_s) in [(0, start_s), (1, end_s)] {
            if follow.readings.is_empty() || (side == 0 && steps > 0 && !has_pieces) {
                outputs.iter_mut().for_each(|jets| jets[0] = jets[1]);
                continue;
            }
            ideal.move_to(time_s)?;
            let (coordinates, rates) = ideal.real_state();
            let n = motion.freedoms();
            motion.dynamics.evaluate(time_s, &coordinates[..n], &rates[..n], &motion.states);
            for (jets, reading) in outputs.iter_mut().zip(&follow.readings) {
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
        if end_s >= observer.awaits_s() {
            observer.step(&mut Step { source, start_s, end_s, length: end_s - start_s, time, outputs: &outputs });
        }
        follower.step([start_s, end_s], &outputs, end_s == window.end_s);
        if let Some(error) = failure {
            return Err(error.into());
        }
        if observer.is_stopped() {
            return Err(RunFailure::Stopped { time_s: end_s });
        }
        match &mut account {
            Some(account) => {
                account.close_step(&mut motion, &mut ideal, start_s, end_s)?;
                if !account.total().supplied_j.is_finite() {
                    return Err(RunFailure::without_value(end_s, motion.dynamics.element_without_value()));
                }
                let mut jams = None;
                motion.dynamics.joint_friction_residuals(|index, residual| {
                    if !(residual <= MAX_RESIDUAL) {
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
        steps += 1;
        start_s = end_s;
        if steps * settings.method.stages.len() as u64 > limit {
            return Err(RunFailure::TooManyEvaluations { time_s: end_s, limit });
        }
    }
    let energy = account.map(|account| account.total());
    let counters = RunCounters { steps, ..RunCounters::default() };
    Ok(RunReport {
        counters,
        plays: Vec::new(),
        energy,
        friction_losses: Vec::new(),
        friction_paths: Vec::new(),
        findings: follower.findings(),
    })
}

/// Follows a run whose steps are equal parts of time.
struct Follower {
    layout: FollowLayout,
    lane: LaneFollow,
    numbers: Vec<f64>,
    /// The readings at both ends of a step.
    readings: [Vec<f64>; 2],
}

impl Follower {
    fn new(follow: &Follow, run: FollowedRun, window: Window) -> Self {
        let layout = FollowLayout::new(follow);
        let mut numbers = vec![0.0; layout.length()];
        let mut lane = LaneFollow::new(&layout, run, window);
        lane.begin(&layout, window.start_s, |place, number| numbers[place] = number);
        Self { layout, lane, numbers, readings: Default::default() }
    }

    /// Follows a step, over which the readings are `outputs`.
    fn step(&mut self, [start_s, end_s]: [f64; 2], outputs: &[[[f64; 3]; 2]], is_last: bool) {
        let Self { layout, lane, numbers, readings } = self;
        if layout.readings() == 0 {
            return;
        }
        for (side, readings) in readings.iter_mut().enumerate() {
            readings.clear();
            readings.extend(outputs.iter().flat_map(|output| output[side]));
        }
        let time = [start_s, end_s].map(|time_s| [time_s, 1.0, 0.0]);
        let step =
            StepEnds { length: end_s - start_s, time, readings: readings.each_ref().map(|readings| &readings[..]) };
        if layout.reduces() {
            lane.take_piece(layout, end_s, |place, number| numbers[place] = number);
            layout.follow(numbers, &step, true);
            if numbers[FollowLayout::IS_EXTREME] > 0.5 {
                layout.take_extremes(numbers, |numbers, place| numbers[place], |numbers, place, e| numbers[place] = e);
            }
        }
        layout.spread(numbers, &step);
        while lane.is_within(end_s, is_last) {
            let (index, instant_s) = lane.take_next();
            numbers[FollowLayout::INSTANT] = instant_s;
            layout.look(numbers, step.time, step.length);
            for (reading, value) in numbers[FollowLayout::VALUES..][..layout.readings()].iter().enumerate() {
                lane.take_instant(index, reading, *value);
            }
        }
    }

    fn findings(mut self) -> Findings {
        self.lane.findings(&self.layout, |place| self.numbers[place])
    }
}

/// The longest step of a run, s.
pub(super) fn longest_step_s(mechanism: &Mechanism, sample: &Sample<f64>, window: &Window) -> f64 {
    MAX_STEP_TURNS * std::f64::consts::TAU / fastest_drive_rad_s(mechanism, sample, window.end_s)
}

/// Least number of evaluations of a run over `window`: those of the longest steps. A step along a motion that its drives determine counts
/// as much as one that is integrated.
pub(super) fn least_evaluations(
    mechanism: &Mechanism,
    sample: &Sample<f64>,
    window: &Window,
    settings: &Settings,
) -> f64 {
    window.end_s / longest_step_s(mechanism, sample, window) * settings.method.stages.len() as f64
}

/// Ends of equal steps of at most `longest_s` over `window`, from one break of drives and loads to the next.
fn step_ends_s(sample: &Sample<f64>, window: Window, longest_s: f64) -> impl Iterator<Item = f64> {
    /// Steps between two breaks, at most.
    const MAX_STEPS: f64 = 1e9;
    let breaks = std::iter::successors(Some(window.start_s), move |&start_s| {
        (start_s < window.end_s).then(|| sample.next_break_s(start_s).min(window.end_s))
    });
    let between = breaks.clone().zip(breaks.skip(1));
    between.flat_map(move |(start_s, stop_s)| {
        let span_s = stop_s - start_s;
        let steps = (span_s / longest_s).ceil().clamp(1.0, MAX_STEPS) as u64;
        let within = (1..steps).map(move |step| start_s + span_s * step as f64 / steps as f64);
        within.chain([stop_s])
    })
}

#[cfg(test)]
mod tests {
    use super::execution_of;
    use crate::lanes::execution::Execution;
    use loosepin_mechanics::mechanism::Mechanism;
    use loosepin_mechanics::model::Model;

    /// A chain of links in a row, each joint that `has_play` names with play.
    fn chain(links: usize, has_play: impl Fn(usize) -> bool) -> Mechanism {
        chain_with(links, has_play, "")
    }

    /// The same with further elements.
    fn chain_with(links: usize, has_play: impl Fn(usize) -> bool, elements: &str) -> Mechanism {
        let link = |k: usize| {
            let bearing = if k == 0 { "ground.o".to_owned() } else { format!("b{}.q", k - 1) };
            let play = if has_play(k) {
                "radial_clearance = \"0.2 mm\"\nbearing_radius = \"9 mm\"\ncontact = \"steel\"\n"
            } else {
                ""
            };
            format!(
                "[body.b{k}]\nmass = \"0.7 kg\"\ninertia = \"2e-3 kg m^2\"\ncentre_of_mass = [\"40 mm\", \"0 mm\"]\n\
                 points = {{ p = [\"0 mm\", \"0 mm\"], q = [\"90 mm\", \"0 mm\"] }}\n\
                 [joint.j{k}]\nkind = \"revolute\"\nbearing = \"{bearing}\"\njournal = \"b{k}.p\"\n{play}\
                 [initial.body.b{k}]\nangle = \"{} deg\"\n",
                7 * k % 50
            )
        };
        let text = format!(
            "name = \"chain\"\ngravity = \"9.81 m/s^2\"\n[body.ground]\npoints = {{ o = [\"0 mm\", \"0 mm\"] }}\n\
             [contact.steel]\nlaw = \"lankarani-nikravesh\"\nrestitution = 0.9\nstiffness = \"1e9 N/m^1.5\"\nexponent = 1.5\n\
             {}{elements}[cycle]\nduration = \"1 s\"\n",
            (0..links).map(link).collect::<String>()
        );
        let model = Model::from_text("model.toml", &text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        Mechanism::new(&model, &model.quantities.nominal()).unwrap_or_else(|error| panic!("{error}"))
    }

    #[test]
    fn equations_too_long_to_be_written_down_are_evaluated_as_they_stand() {
        let best = Execution::Interpreted;
        assert_eq!(execution_of(&chain(30, |_| false), best), best);
        assert_eq!(execution_of(&chain(120, |_| false), best), Execution::Scalar);
    }

    #[test]
    fn tables_too_long_to_be_written_down_are_searched_by_runs_alone() {
        let with_points = |count: usize| {
            let points = (0..count).map(|k| format!("[\"{k} ms\", \"{} N\"]", k % 7)).collect::<Vec<_>>().join(", ");
            let load = "[load.push]\nkind = \"force\"\npoint = \"b0.q\"\ndirection = \"0 deg\"\nof = \"time\"";
            chain_with(1, |_| false, &format!("{load}\npoints = [{points}]\n"))
        };
        let best = Execution::Interpreted;
        assert_eq!(execution_of(&with_points(1000), best), best);
        assert_eq!(execution_of(&with_points(1001), best), Execution::Scalar);
    }

    #[test]
    fn identity_the_equations_of_parts_that_play_separates_grow_with_their_number_alone() {
        let of = |links| chain(links, |k| k % 4 == 0).multiplications();
        let (short, long) = (of(40), of(160));
        // The mass matrix is that of parts of four links; the square is that of reading its rows.
        assert!((short..4.2 * short + 500.0 * 500.0).contains(&long), "{short} and {long}");
        assert!(long < 0.1 * chain(160, |_| false).multiplications());
    }
}

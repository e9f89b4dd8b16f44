//! Recording of one run for a study: values at poses, and the recorded part reduced to single numbers.
//!
//! Positions, and values of other outputs that are reduced, are followed on the lanes ([`loosepin_simulate::Follow`]); everything else is
//! read by looking inside the steps.

use crate::file::{Deviation, Reduction};
use crate::model::outputs::OutputSource;
use crate::response::columns::ColumnPlan;
use loosepin_math::{Vec2, sort_ascending};
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_mechanics::mechanism::SampleError;
use loosepin_mechanics::model::{JointId, WearMeasure};
use loosepin_result::study::Course;
use loosepin_result::study::PathError;
use loosepin_simulate::{
    Arms, DeviationRange, Follow, FollowedDeviation, FollowedPath, FollowedRun, FreeMotion, GAUSS, IdealCurve,
    IdealReference, Observer, Reading, RunReport, Step, WearRecorder, Window, extremes_within, path_error,
    points_within,
};
use loosepin_text::units::distinct;
use std::sync::Arc;

/// Source of the value of a column.
#[derive(Debug, Clone, Copy, PartialEq)]
enum ColumnSource {
    /// A reading at an instant: its index in [`Follow::readings`], and that of the instant.
    Instant { reading: usize, instant: usize },
    /// A deviation that is followed on the lanes: its index in [`Follow::deviations`].
    Followed { deviation: usize, reduction: Reduction },
    /// A part of the error of a point at an instant: indices of x and y in [`Follow::readings`], and that of the instant.
    PathInstant { readings: [usize; 2], part: PathError, instant: usize },
    /// The same followed on the lanes: its index in [`Follow::paths`], and that of the part.
    FollowedPath { path: usize, part: usize, reduction: Reduction },
    /// A value that is followed on the lanes inside the steps: its index in [`Follow::inside`].
    Inside { value: usize, reduction: Reduction },
    /// The wear of a joint over the whole run.
    Wear { joint: JointId, measure: WearMeasure },
    /// A look inside a step at a pose.
    Look,
    /// A deviation that is followed by looks inside the steps: its index in [`Recorder::looked`].
    Looked { deviation: usize, reduction: Reduction },
}

/// Data shared by all runs of a study: the columns, and the nominal ideal motion.
#[derive(Debug)]
pub struct Shared {
    /// The columns.
    pub plan: ColumnPlan,
    /// Quantities followed on the lanes: all used outputs that are positions.
    pub follow: Follow,
    /// Turns since the start of the recorded part at which these are read.
    instants_turns: Vec<f64>,
    /// Source of each column.
    origins: Vec<ColumnSource>,
    /// Outputs and deviations that are followed by looks inside the steps.
    looked: Vec<(usize, Deviation)>,
    /// Whether a column needs an integral of each of these.
    looked_is_integrated: Vec<bool>,
    /// Columns at poses that need a look inside a step, in the order of time.
    looks: Vec<usize>,
    /// Whether any column is of the wear of a joint.
    pub needs_wear: bool,
    /// Whether any of these needs depths.
    needs_depths: bool,
    /// Whether any column asks for a deviation from the sample's own ideal motion.
    pub needs_own_ideal: bool,
    /// Whether any of these columns is of an output without a table.
    pub needs_own_reference: bool,
    /// Nominal ideal positions over the recorded part, by reading.
    pub nominal_curve: Arc<IdealCurve>,
    /// The nominal ideal motion, where forces decide it.
    pub nominal_motion: Option<Arc<FreeMotion>>,
    /// Nominal ideal value of each column's output at its pose; NaN for reduced columns.
    pub nominal_at_pose: Vec<f64>,
}

/// The outputs of `plan` that are positions, those that any column uses, in order.
pub fn positions(plan: &ColumnPlan) -> Vec<Reading> {
    let used = plan.outputs.iter().enumerate().filter(|(output, _)| plan.is_used(*output));
    distinct(used.flat_map(|(_, output)| output.seen.readings()).filter(Reading::is_position))
}

impl Shared {
    /// The columns of `plan`, compared with the nominal ideal motion; `is_integrated`: runs are, and not solved.
    pub fn new(
        plan: ColumnPlan,
        nominal_curve: IdealCurve,
        nominal_motion: Option<Arc<FreeMotion>>,
        nominal_at_pose: Vec<f64>,
        is_integrated: bool,
    ) -> Self {
        let mut follow = Follow::readings(&positions(&plan));
        let (mut looked, mut looks, mut instants_turns) = (Vec::new(), Vec::new(), Vec::new());
        let mut looked_is_integrated = Vec::new();
        for column in &plan.columns {
            instants_turns.extend(column.spot.pose().map(|pose| pose.turns));
        }
        sort_ascending(&mut instants_turns);
        instants_turns.dedup();
        let mut origins = Vec::with_capacity(plan.columns.len());
        for (index, column) in plan.columns.iter().enumerate() {
            let place = |own: Reading| follow.readings.iter().position(|reading| *reading == own);
            let instant = |turns: f64| instants_turns.partition_point(|&instant| instant < turns);
            let of = column.deviation;
            let followed = match plan.outputs[column.output].seen {
                OutputSource::Wear(joint, measure) => Some(ColumnSource::Wear { joint, measure }),
                OutputSource::InSpace(_) => None,
                OutputSource::Reading(reading) => match (place(reading), column.spot.reduction()) {
                    (Some(reading), _) => Some(column.spot.turned_into(
                        |pose| ColumnSource::Instant { reading, instant: instant(pose.turns) },
                        |reduction| follow_deviation(&mut follow.deviations, (reading, of), reduction),
                    )),
                    (None, Some(reduction)) if of.is_value_of_run() && is_integrated && reading.is_on_lanes() => {
                        Some(follow_inside(&mut follow.inside, reading, reduction))
                    }
                    (None, _) => None,
                },
                OutputSource::Path([x, y], part) => place(x).zip(place(y)).map(|(x, y)| {
                    column.spot.turned_into(
                        |pose| ColumnSource::PathInstant { readings: [x, y], part, instant: instant(pose.turns) },
                        |reduction| follow_path(&mut follow.paths, ([x, y], of), part, reduction),
                    )
                }),
            };
            origins.push(followed.unwrap_or_else(|| match column.spot.reduction() {
                None => {
                    looks.push(index);
                    ColumnSource::Look
                }
                Some(reduction) => {
                    let own = (column.output, of);
                    let deviation = looked.iter().position(|known| *known == own).unwrap_or_else(|| {
                        looked.push(own);
                        looked_is_integrated.push(false);
                        looked.len() - 1
                    });
                    looked_is_integrated[deviation] |= reduction.is_of_means();
                    ColumnSource::Looked { deviation, reduction }
                }
            }));
        }
        looks.sort_by(|&a, &b| pose_turns(&plan, a).total_cmp(&pose_turns(&plan, b)).then(a.cmp(&b)));
        let mut of_own = plan.columns.iter().filter(|column| column.deviation.needs_own_ideal());
        let needs_own_ideal = of_own.clone().next().is_some();
        let is_position = |output: usize| plan.outputs[output].seen.readings().all(|reading| reading.is_position());
        let needs_own_reference = of_own.any(|column| !is_position(column.output));
        let needs_wear = origins.iter().any(|origin| matches!(origin, ColumnSource::Wear { .. }));
        let needs_depths =
            origins.iter().any(|origin| matches!(origin, ColumnSource::Wear { measure, .. } if measure.is_depth()));
        Self {
            needs_wear,
            needs_depths,
            follow,
            instants_turns,
            origins,
            looked,
            looked_is_integrated,
            looks,
            needs_own_ideal,
            needs_own_reference,
            nominal_curve: Arc::new(nominal_curve),
            nominal_motion,
            nominal_at_pose,
            plan,
        }
    }

    /// Whether a deviation from the nominal motion is followed by looks inside the steps.
    pub fn needs_nominal_reference(&self) -> bool {
        self.looked.iter().any(|(_, of)| of.is_from_drawing())
    }

    /// References of a run over `window` whose turns last `turn_s`; `own`: the table of its own ideal motion.
    pub fn followed(&self, own: Option<Arc<IdealCurve>>, window: &Window, turn_s: f64) -> FollowedRun {
        let is_read = self
            .origins
            .iter()
            .any(|origin| matches!(origin, ColumnSource::Instant { .. } | ColumnSource::PathInstant { .. }));
        let instants = self.instants_turns.iter().filter(|_| is_read);
        let instants_s = instants.map(|turns| window.start_s + turns * turn_s).collect();
        FollowedRun { instants_s, nominal: Some(self.nominal_curve.clone()), own }
    }
}

/// A number of a deviation, which joins those that are followed.
fn follow_deviation(
    known: &mut Vec<FollowedDeviation>,
    (reading, deviation): (usize, Deviation),
    reduction: Reduction,
) -> ColumnSource {
    let found = known.iter().position(|one| one.reading == reading && one.deviation == deviation);
    let place = found.unwrap_or_else(|| {
        known.push(FollowedDeviation { reading, deviation, is_integrated: false });
        known.len() - 1
    });
    known[place].is_integrated |= reduction.is_of_means();
    ColumnSource::Followed { deviation: place, reduction }
}

/// A number of a part of the error of a point, which joins those that are followed.
fn follow_path(
    known: &mut Vec<FollowedPath>,
    (readings, deviation): ([usize; 2], Deviation),
    part: PathError,
    reduction: Reduction,
) -> ColumnSource {
    let found = known.iter().position(|one| one.readings == readings && one.deviation == deviation);
    let path = found.unwrap_or_else(|| {
        known.push(FollowedPath { readings, deviation, parts: [false; 4], is_integrated: false });
        known.len() - 1
    });
    let part = PathError::ALL.iter().position(|known| *known == part).unwrap_or(0);
    known[path].parts[part] = true;
    known[path].is_integrated |= reduction.is_of_means();
    ColumnSource::FollowedPath { path, part, reduction }
}

/// A number of the value of an output that is no position, which joins those that are followed.
fn follow_inside(known: &mut Vec<Reading>, reading: Reading, reduction: Reduction) -> ColumnSource {
    let value = known.iter().position(|one| *one == reading).unwrap_or_else(|| {
        known.push(reading);
        known.len() - 1
    });
    ColumnSource::Inside { value, reduction }
}

/// Turns of the pose of a column; NaN for a reduced one.
fn pose_turns(plan: &ColumnPlan, column: usize) -> f64 {
    plan.columns[column].spot.pose().map_or(f64::NAN, |pose| pose.turns)
}

/// Follows one run. It owns what belongs to the run alone, since many runs go on side by side.
pub struct Recorder<'r> {
    shared: &'r Shared,
    arms: Arms,
    references: References<'r>,
    /// Time of this sample to time of the nominal one, both from the start of the recorded part.
    nominal_per_own: f64,
    window: Window,
    turn_s: f64,
    /// The joints that wear, where a column is of their wear.
    wear: Option<WearRecorder>,
    /// Of [`Shared::looks`].
    next_look: usize,
    looked: Vec<DeviationRange>,
    /// Poses one turn before the end, and at the end: x, y, angle by slot.
    turn_before: Option<Vec<[f64; 3]>>,
    at_end: Option<Vec<[f64; 3]>>,
    /// The columns of the run.
    pub values: Vec<f64>,
    /// Why the ideal motion could not be followed.
    pub failure: Option<SampleError>,
}

/// The motions that a run is compared with.
pub struct References<'r> {
    /// The ideal motion of the sample, where outputs without a table are compared with it.
    pub own: Option<IdealReference<'r>>,
    /// Its table, where a deviation from it is asked for.
    pub curve: Option<Arc<IdealCurve>>,
    /// The nominal ideal motion, where outputs without a table are used.
    pub nominal: Option<IdealReference<'r>>,
    /// The recorded part of the nominal motion.
    pub nominal_window: Window,
}

impl<'r> Recorder<'r> {
    /// Ready for a run over `window` whose turns last `turn_s`.
    pub fn new(
        shared: &'r Shared,
        (arms, wear): (Arms, Option<WearRecorder>),
        references: References<'r>,
        window: &Window,
        turn_s: f64,
    ) -> Self {
        let Window { start_s, end_s } = references.nominal_window;
        Self {
            shared,
            arms,
            references,
            nominal_per_own: (end_s - start_s) / (window.end_s - window.start_s),
            window: *window,
            turn_s,
            wear,
            next_look: 0,
            looked: vec![DeviationRange::NONE; shared.looked.len()],
            turn_before: None,
            at_end: None,
            values: vec![f64::NAN; shared.plan.columns.len()],
            failure: None,
        }
    }

    /// Fills the columns that were followed on the lanes, and all that are reduced, once the run is over.
    pub fn finish(&mut self, report: &RunReport) {
        let findings = &report.findings;
        let (shared, readings) = (self.shared, self.shared.follow.readings.len());
        let span_s = self.window.end_s - self.window.start_s;
        let turns = span_s / self.turn_s;
        for (index, (column, origin)) in shared.plan.columns.iter().zip(&shared.origins).enumerate() {
            self.values[index] = match *origin {
                ColumnSource::Instant { reading, instant } => {
                    let share = (shared.instants_turns[instant] / turns).min(1.0);
                    let actual = || findings.at_instants.get(instant * readings + reading).copied().unwrap_or(f64::NAN);
                    let own = || self.references.curve.as_ref().map_or(f64::NAN, |curve| curve.value(reading, share));
                    column.deviation.between(actual, own, || shared.nominal_at_pose[index])
                }
                ColumnSource::Followed { deviation, reduction } => {
                    reduced(&findings.deviations[deviation], reduction, span_s)
                }
                ColumnSource::PathInstant { readings: own, part, instant } => {
                    let share = (shared.instants_turns[instant] / turns).min(1.0);
                    let at = |reading| findings.at_instants.get(instant * readings + reading).copied();
                    let actual = own.map(|reading| at(reading).unwrap_or(f64::NAN));
                    self.path_error(column.deviation, part, (own, actual), share)
                }
                ColumnSource::FollowedPath { path, part, reduction } => {
                    reduced(&findings.paths[path][part], reduction, span_s)
                }
                ColumnSource::Inside { value, reduction } => reduced(&findings.inside[value], reduction, span_s),
                ColumnSource::Looked { deviation, reduction } => reduced(&self.looked[deviation], reduction, span_s),
                ColumnSource::Wear { joint, measure } => self.wear_value(joint, measure, report),
                ColumnSource::Look => self.values[index],
            };
        }
    }

    /// The wear of a joint.
    fn wear_value(&self, joint: JointId, measure: WearMeasure, report: &RunReport) -> f64 {
        self.wear.as_ref().map_or(f64::NAN, |wear| wear.value(joint, measure, report))
    }

    /// The joint of a column of wear that is no finite number.
    pub fn wear_not_finite(&self) -> Option<JointId> {
        self.shared.origins.iter().zip(&self.values).find_map(|(origin, value)| match *origin {
            ColumnSource::Wear { joint, .. } if !value.is_finite() => Some(joint),
            _ => None,
        })
    }

    /// Whether every step is looked at for wear: for depths, and of an ideal joint for its friction path too.
    fn looks_for_wear(&self) -> bool {
        let has_ideal = |wear: &WearRecorder| wear.joints.iter().any(|joint| joint.play.is_none());
        // With the worn shape all of it is known before the run.
        let looks = |wear: &WearRecorder| wear.life.is_none() && (self.shared.needs_depths || has_ideal(wear));
        self.wear.as_ref().is_some_and(looks)
    }

    /// A part of the error of a point whose coordinates are the readings `own`, and which is at `actual`, at a share of the recorded part.
    fn path_error(&self, of: Deviation, part: PathError, (own, actual): ([usize; 2], [f64; 2]), share: f64) -> f64 {
        let span_s = self.window.end_s - self.window.start_s;
        let jets = |curve: &IdealCurve| own.map(|reading| curve.jet(reading, share, span_s));
        let nominal = jets(&self.shared.nominal_curve);
        let own = self.references.curve.as_ref().map_or([[f64::NAN; 3]; 2], |curve| jets(curve));
        let error = [0, 1].map(|k| of.between(|| actual[k], || own[k][0], || nominal[k][0]));
        let [x, y] = if of.is_by_play_alone() { own } else { nominal };
        path_error(part, Vec2::new(error[0], error[1]), Vec2::new(x[1], y[1]), Vec2::new(x[2], y[2]))
    }

    /// Largest difference between all poses at the end and one turn before, relative to `size_m` in positions and in rad for
    /// angles. `None` if less than a turn was recorded.
    pub fn change_over_last_turn(&self, size_m: f64) -> Option<f64> {
        let (before, end) = (self.turn_before.as_ref()?, self.at_end.as_ref()?);
        let differences = before.iter().zip(end).map(|(a, b)| {
            let position = (a[0] - b[0]).abs().max((a[1] - b[1]).abs()) / size_m;
            position.max(2.0 * ((a[2] - b[2]) / 2.0).sin().abs())
        });
        Some(differences.fold(0.0, f64::max))
    }

    /// The deviation of an output without a table, given the value of the real mechanism; at a pose the nominal value is known.
    fn looked_deviation(
        &mut self,
        (output, of): (usize, Deviation),
        (actual, time_s): (f64, f64),
        nominal: Option<f64>,
    ) -> f64 {
        let Self { shared, arms, references, failure, .. } = self;
        let OutputSource::Reading(reading) = shared.plan.outputs[output].seen else { return f64::NAN };
        let mut ideal = |reference: &mut Option<IdealReference<'r>>, time_s: f64| match reference {
            Some(reference) => read(reference, failure, |dynamics| reading.value(arms, dynamics), time_s),
            None => f64::NAN,
        };
        let nominal_s = references.nominal_window.start_s + self.nominal_per_own * (time_s - self.window.start_s);
        let own = if of.needs_own_ideal() { ideal(&mut references.own, time_s) } else { f64::NAN };
        let nominal = match nominal {
            Some(nominal) => nominal,
            None if of.is_from_drawing() => ideal(&mut references.nominal, nominal_s),
            None => f64::NAN,
        };
        of.between(|| actual, || own, || nominal)
    }

    /// Columns at poses that need a look inside the step.
    fn look_at_poses(&mut self, step: &mut Step<'_, '_>) {
        while let Some(&column) = self.shared.looks.get(self.next_look) {
            let time_s = self.look_s(column);
            // A pose at the very end may lie behind the last step by round-off.
            if time_s > step.end_s && step.end_s < self.window.end_s {
                return;
            }
            self.next_look += 1;
            let planned = self.shared.plan.columns[column];
            let actual = self.actual(step, planned.output, time_s);
            let nominal = Some(self.shared.nominal_at_pose[column]);
            self.values[column] = self.looked_deviation((planned.output, planned.deviation), (actual, time_s), nominal);
        }
    }

    /// When the pose of a column is passed.
    fn look_s(&self, column: usize) -> f64 {
        self.window.start_s + pose_turns(&self.shared.plan, column) * self.turn_s
    }

    /// Value of an output without a polynomial, by a look inside a step.
    fn actual(&self, step: &mut Step<'_, '_>, output: usize, time_s: f64) -> f64 {
        let OutputSource::Reading(reading) = self.shared.plan.outputs[output].seen else { return f64::NAN };
        let dynamics = if reading.needs_forces() { step.evaluate(time_s) } else { step.set_state(time_s) };
        reading.value(&self.arms, dynamics)
    }

    /// Takes a step into the deviations that are followed by looks.
    fn look_through(&mut self, step: &mut Step<'_, '_>) {
        let (start_s, span_s) = (step.start_s, step.end_s - step.start_s);
        for index in 0..self.looked.len() {
            let of = self.shared.looked[index];
            // A look takes an evaluation: none for integrals where only extremes are asked for.
            let is_integrated = self.shared.looked_is_integrated[index];
            let DeviationRange { largest, smallest, mut integral, mut integral_of_square } = self.looked[index];
            let mut at = |share: f64| {
                let time_s = start_s + share * span_s;
                let actual = self.actual(step, of.0, time_s);
                self.looked_deviation(of, (actual, time_s), None)
            };
            let points = points_within(&mut at);
            let (low, high) =
                points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p.1), h.max(p.1)));
            // Between the points the value can rise above them by a part of their range only.
            let room = 0.25 * (high - low);
            let [largest, smallest] = extremes_within(&points, [low - room, high + room], [largest, smallest], &mut at);
            for (place, weight) in GAUSS.into_iter().filter(|_| is_integrated) {
                let (value, weight_s) = (at(place), weight * span_s);
                integral += weight_s * value;
                integral_of_square += weight_s * value * value;
            }
            self.looked[index] = DeviationRange { largest, smallest, integral, integral_of_square };
        }
    }

    /// One turn before the end, where that lies in the recorded part.
    fn turn_before_s(&self) -> Option<f64> {
        let before_s = self.window.end_s - self.turn_s;
        (before_s >= self.window.start_s - 1e-9 * self.turn_s).then_some(before_s)
    }

    fn note_turn(&mut self, step: &mut Step<'_, '_>) {
        if let Some(before_s) =
            self.turn_before_s().filter(|before_s| self.turn_before.is_none() && *before_s <= step.end_s)
        {
            self.turn_before = Some(poses(step.set_state(before_s.max(step.start_s))));
        }
        if step.end_s >= self.window.end_s {
            self.at_end = Some(poses(step.set_state(self.window.end_s)));
        }
    }
}

impl Observer for Recorder<'_> {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        self.look_through(step);
        if self.looks_for_wear()
            && let Some(wear) = &mut self.wear
        {
            wear.step(step);
        }
        self.look_at_poses(step);
        self.note_turn(step);
    }

    fn awaits_s(&self) -> f64 {
        if !self.looked.is_empty() || self.looks_for_wear() {
            return f64::NEG_INFINITY;
        }
        let look = self.shared.looks.get(self.next_look).map(|&column| self.look_s(column));
        let turn = self.turn_before_s().filter(|_| self.turn_before.is_none());
        look.into_iter().chain(turn).fold(self.window.end_s, f64::min)
    }
}

/// A deviation over a recorded part of `span_s` as one number.
fn reduced(range: &DeviationRange, reduction: Reduction, span_s: f64) -> f64 {
    let DeviationRange { largest, smallest, integral, integral_of_square } = *range;
    reduction.of(&Course { largest, smallest, mean: integral / span_s, mean_square: integral_of_square / span_s })
}

/// Reads an ideal motion, keeping the first reason why it could not be followed.
fn read<'a>(
    reference: &mut IdealReference<'a>,
    failure: &mut Option<SampleError>,
    value: impl Fn(&Dynamics<'a, f64>) -> f64,
    time_s: f64,
) -> f64 {
    match reference.at(time_s, true) {
        Ok(dynamics) => value(dynamics),
        Err(error) => {
            failure.get_or_insert(error);
            f64::NAN
        }
    }
}

fn poses(dynamics: &Dynamics<'_, f64>) -> Vec<[f64; 3]> {
    dynamics.kinematics.poses.iter().map(|p| [p.position_m.x, p.position_m.y, p.angle_rad()]).collect()
}

#[cfg(test)]
mod tests {
    use crate::Study;
    use crate::file::Reduction;
    use crate::places::Location;
    use crate::response::planar_response::PlanarResponse;
    use crate::written::texts::study_with;
    use loosepin_result::study::PathError;
    use loosepin_simulate::{Execution, Plan, simulate};
    use std::path::Path;

    /// The largest deviation of the slider in a turn that begins `transient` turns after the start, and the largest at its poses, m.
    fn largest_m(transient: &str) -> [f64; 2] {
        let path = "cases/slider_crank_worn_pin/study.toml";
        let transient = format!("transient_turns = {transient}\n");
        let response = PlanarResponse::new(&study_with(path, &[("transient_turns = 2\n", &transient)])).unwrap();
        let mut row = vec![0.0; response.row_length()];
        response.run(&[0.05, 0.12], &[2e-5, 0.8], &mut row).unwrap();
        let plan = &response.shared.plan;
        let of = |is_meant: &dyn Fn(&Location) -> bool| {
            let columns = plan.columns.iter().zip(&row);
            let total = columns.filter(|(column, _)| {
                column.deviation == crate::file::Deviation::of_all_causes() && is_meant(&column.spot)
            });
            total.fold(0.0_f64, |most, (_, value)| most.max(value.abs()))
        };
        [of(&|spot| spot.reduction() == Some(Reduction::largest_magnitude())), of(&|spot| spot.pose().is_some())]
    }

    #[test]
    fn identity_a_turn_that_begins_while_the_slider_moves_has_no_larger_deviation_than_its_poses_show() {
        // At a quarter turn the slider moves by 1 mm in a seventh of the longest step: fifty times its play.
        for transient in ["2", "1.23", "0.75"] {
            let [largest_m, at_poses_m] = largest_m(transient);
            // 180 poses may miss a part of a peak.
            assert!((1.0..1.25).contains(&(largest_m / at_poses_m)), "{transient}: {largest_m} m, {at_poses_m} m");
        }
    }

    /// The rows of some runs of the coupler point, asked for every part of its error over the cycle and as numbers of the whole.
    fn rows_of_path(samples_per_turn: usize, execution: Execution) -> (PlanarResponse, Vec<Vec<f64>>) {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/four_bar_coupler_path/study.toml");
        let mut texts = Study::from_path(&path).unwrap().texts();
        let ask = |component: &str, of: &str, place: &str| {
            format!(
                "[[ask]]\noutput = \"tool\"\ncomponent = \"{component}\"\nof = \"{of}\"\n{place}\nstatistics = [\"mean\"]\n"
            )
        };
        let places =
            ["at = \"cycle\"", "reduce = \"maximum\"", "reduce = \"minimum\"", "reduce = \"rms\"", "reduce = \"mean\""];
        let asks = ["total", "clearance", "dimensional"]
            .map(|of| PathError::ALL.map(|part| places.map(|place| ask(part.word(), of, place)).concat()).concat());
        let (head, _) = texts.study.1.split_once("# How far the tool").unwrap();
        let head = head.replace("samples_per_turn = 90", &format!("samples_per_turn = {samples_per_turn}"));
        texts.study.1 = head + &asks.concat();
        let response = PlanarResponse::new(&Study::from_texts(&texts).unwrap()).unwrap();
        const CLEARANCES_M: [[f64; 2]; 3] = [[5e-5, 3e-5], [2e-5, 8e-5], [7e-5, 7e-5]];
        let mut inputs = CLEARANCES_M.iter().enumerate();
        let mut rows = vec![Vec::new(); 3];
        let lengths_m = [0.08001, 0.26002, 0.17999];
        let next = || inputs.next().map(|(index, clearances_m)| (index, &lengths_m[..], &clearances_m[..]));
        response.run_all(0, execution, next, |index, row| rows[index] = row.unwrap());
        (response, rows)
    }

    #[test]
    fn identity_numbers_of_a_path_error_over_the_cycle_are_those_of_its_poses() {
        let (response, rows) = rows_of_path(1600, Execution::best());
        for ask in response.shared.plan.asks.chunks(5) {
            let name = &response.shared.plan.outputs[ask[0].output].name;
            for row in &rows {
                let poses: Vec<f64> = ask[0].columns.iter().map(|&column| row[column]).collect();
                let [high, low, rms, mean] = [1, 2, 3, 4].map(|k| row[ask[k].columns[0]]);
                let largest = poses.iter().fold(f64::NEG_INFINITY, |largest, own| largest.max(*own));
                let smallest = poses.iter().fold(f64::INFINITY, |smallest, own| smallest.min(*own));
                let count = poses.len() as f64;
                let poses_mean = poses.iter().sum::<f64>() / count;
                let poses_rms = (poses.iter().map(|own| own * own).sum::<f64>() / count).sqrt();
                // Between poses an error changes by some hundredths of the play; the sums are those of rectangles.
                let (within, least) = (0.02 * (high - low), -1e-9);
                let told = format!("{name} {:?}: {high} {largest}, {low} {smallest}", ask[0].deviation);
                assert!((least..within).contains(&(high - largest)), "{told}");
                assert!((least..within).contains(&(smallest - low)), "{told}");
                assert!((mean - poses_mean).abs() < within && (rms - poses_rms).abs() < within, "{told}: {mean} {rms}");
                assert!(high - low > 1e-6, "{told}: nothing to be seen");
            }
        }
    }

    #[test]
    fn identity_path_errors_have_the_same_bits_alone_and_on_lanes() {
        let bits = |execution| {
            let rows = rows_of_path(24, execution).1;
            rows.into_iter().flatten().map(f64::to_bits).collect::<Vec<u64>>()
        };
        let alone = bits(Execution::Scalar);
        assert!(alone.iter().all(|bits| f64::from_bits(*bits).is_finite()));
        for execution in Execution::available() {
            assert_eq!(bits(execution), alone, "{}", execution.name());
        }
    }

    #[test]
    fn identity_the_slider_crank_keeps_its_96_nodes() {
        let response = PlanarResponse::new(&study_with("cases/slider_crank_worn_pin/study.toml", &[])).unwrap();
        let nodes = &response.shared.nominal_curve.nodes;
        assert_eq!(nodes.pieces(), [1; 96]);
    }

    /// The slider-crank whose gudgeon wears, with the wear asked for by `components`.
    fn wear_response(components: &[&str]) -> PlanarResponse {
        const STUDY: &str = "name = \"wear\"\nmodel = \"model.toml\"\n[cycle]\ntransient_turns = 0.5\nrecorded_turns = 0.75\n\
            [sampling]\nouter = 8\ninner = 8\ntolerance = \"1e-8 m\"\n\
            [random]\n\"parameter.rod_length\" = { normal = { mean = \"120 mm\", standard_deviation = \"0.03 mm\" } }\n\
            [epistemic]\n\"joint.gudgeon.radial_clearance\" = { interval = [\"0.1 mm\", \"0.5 mm\"] }\n\
            \"joint.gudgeon.wear.bearing.coefficient\" = { interval = [\"1e-16 m^2/N\", \"1e-14 m^2/N\"] }\n";
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slider_crank_worn_pin/study.toml");
        let mut texts = Study::from_path(&path).unwrap().texts();
        let wear = "bearing_length = \"20 mm\"\nwear.bearing.coefficient = \"1e-15 m^2/N\"\n\
            wear.journal = { archard = 2e-6, hardness = \"2 GPa\" }\nradial_clearance";
        texts.model.1 = texts.model.1.replacen("radial_clearance", wear, 1) + "\n[wear]\ncycles = 1e6\n";
        let asked = |component: &&str| {
            let output = format!("[output.{component}]\nwear_of = \"joint.gudgeon\"\ncomponent = \"{component}\"\n");
            let ask = format!(
                "[[ask]]\noutput = \"{component}\"\nof = \"value\"\nreduce = \"maximum\"\nstatistics = [\"mean\"]\n"
            );
            (output, ask)
        };
        let (outputs, asks): (Vec<String>, Vec<String>) = components.iter().map(asked).unzip();
        texts.model.1 += &outputs.concat();
        texts.study.1 = STUDY.to_owned() + &asks.concat();
        PlanarResponse::new(&Study::from_texts(&texts).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))).unwrap()
    }

    const WEAR: [&str; 5] = ["friction_path", "bearing_volume", "journal_volume", "bearing_depth", "journal_depth"];

    #[test]
    fn identity_wear_has_the_same_bits_alone_and_on_lanes() {
        let response = wear_response(&WEAR);
        let bits = |execution| {
            let inputs = [[1e-4, 2e-15], [3e-4, 1e-15], [5e-4, 7e-15], [2.2e-4, 3e-16]];
            let mut next = inputs.iter().enumerate();
            let mut rows = vec![Vec::new(); inputs.len()];
            let next = || next.next().map(|(index, epistemic)| (index, &[0.120_01][..], &epistemic[..]));
            response.run_all(0, execution, next, |index, row| rows[index] = row.unwrap());
            rows.into_iter()
                .map(|row| row[..5].iter().map(|value| value.to_bits()).collect())
                .collect::<Vec<Vec<u64>>>()
        };
        let alone = bits(Execution::Scalar);
        assert!(alone.iter().flatten().all(|bits| f64::from_bits(*bits) > 0.0));
        for execution in Execution::available() {
            assert_eq!(bits(execution), alone, "{}", execution.name());
        }
    }

    /// Sections of a flexible link are no numbers of the lanes, so that each run must be read with its own.
    #[test]
    fn identity_stress_has_the_same_bits_alone_and_on_lanes() {
        const STUDY: &str = "name = \"stress\"\nmodel = \"model.toml\"\n\
            [sampling]\nouter = 8\ninner = 8\ntolerance = \"1e-6 m\"\n\
            [random]\n\"body.rod.beam.density\" = { uniform = { lower = \"7500 kg/m^3\", upper = \"8000 kg/m^3\" } }\n\
            [epistemic]\n\"body.rod.beam.section.height\" = { interval = [\"7 mm\", \"9 mm\"] }\n\
            [[ask]]\noutput = \"rod_stress\"\nof = \"value\"\nreduce = \"maximum\"\nstatistics = [\"mean\"]\n\
            [[ask]]\noutput = \"rod_stress\"\nof = \"value\"\nreduce = \"rms\"\nstatistics = [\"mean\"]\n";
        let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
        let mut texts = Study::from_path(&cases.join("slider_crank_worn_pin/study.toml")).unwrap().texts();
        let model = std::fs::read_to_string(cases.join("flexible_slider_crank/model.toml")).unwrap();
        let short = model.replace("duration = \"10 ms\"", "duration = \"0.5 ms\"");
        assert_ne!(short, model);
        texts.model.1 = short + "\n[output.rod_stress]\nstress_in = \"rod\"\n";
        texts.study.1 = STUDY.to_owned();
        let study = Study::from_texts(&texts).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        let response = PlanarResponse::new(&study).unwrap();
        let bits = |execution| {
            let inputs = [[7600.0, 7.1e-3], [7900.0, 8.8e-3], [7700.0, 8e-3]];
            let mut next = inputs.iter().enumerate();
            let mut rows = vec![Vec::new(); inputs.len()];
            let next = || next.next().map(|(index, values)| (index, &values[..1], &values[1..]));
            response.run_all(0, execution, next, |index, row| rows[index] = row.unwrap());
            rows.into_iter().map(|row| [row[0].to_bits(), row[1].to_bits()]).collect::<Vec<_>>()
        };
        let alone = bits(Execution::Scalar);
        assert!(alone.iter().flatten().all(|bits| f64::from_bits(*bits) > 1e5), "{alone:?}");
        for execution in [Execution::best(), Execution::Interpreted] {
            assert_eq!(bits(execution), alone, "{}", execution.name());
        }
    }

    #[test]
    fn identity_wear_of_a_study_is_that_of_a_single_run() {
        let response = wear_response(&WEAR);
        let mut row = vec![0.0; response.row_length()];
        response.run(&[0.120_01], &[3e-4, 4e-15], &mut row).unwrap();
        let values = response.values(&[0.120_01], &[3e-4, 4e-15]).unwrap();
        let mut plan = Plan::of_model(&response.mechanism().model);
        (plan.cycle.transient_turns, plan.cycle.recorded_turns) = (0.5, 0.75);
        plan.settings = *response.settings();
        let record = simulate(response.mechanism(), &values, &plan).unwrap().record;
        let [bearing, journal] = &record.wear[0].surfaces[..] else { panic!("two surfaces") };
        let single = [
            record.wear[0].friction_path_j,
            bearing.volume_m3,
            journal.volume_m3,
            bearing.greatest_depth_m,
            journal.greatest_depth_m,
        ];
        assert_eq!(row[..5], single);
        assert!((bearing.volume_m3 / (1e6 * 4e-15 * single[0]) - 1.0).abs() < 1e-12);
        assert!((journal.volume_m3 / (1e6 * 1e-15 * single[0]) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn identity_volumes_alone_need_no_look_inside_steps() {
        let [alone, beside_depths] = [&WEAR[..3], &WEAR[..]].map(|components| {
            let response = wear_response(components);
            let mut row = vec![0.0; response.row_length()];
            response.run(&[0.12], &[3e-4, 4e-15], &mut row).unwrap();
            (row[..3].to_vec(), response.extras(&row).evaluations)
        });
        assert_eq!(alone.0, beside_depths.0);
        assert!(alone.1 < beside_depths.1, "{} {}", alone.1, beside_depths.1);
    }
}

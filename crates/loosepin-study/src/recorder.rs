//! What a study keeps of one run: values at poses, and the recorded part reduced to single numbers.

use super::columns::{ColumnPlan, Spot};
use super::file::{Deviation, Reduction};
use super::ideal_curve::IdealCurve;
use loosepin_math::Quintic;
use loosepin_mechanics::mechanism::SampleError;
use loosepin_simulate::{Arms, FreeMotion, IdealReference, Observer, Peak, Reading, Step, Window, maximum_within};
use std::sync::Arc;

/// Points of a step at which a deviation is looked at before its extremes are located, ends included.
const POINTS_PER_STEP: usize = 5;

/// Gauss's points and weights on [0, 1] for integrals over a step: exact to degree five.
const GAUSS: [(f64, f64); 3] =
    [(0.112_701_665_379_258_3, 5.0 / 18.0), (0.5, 4.0 / 9.0), (0.887_298_334_620_741_7, 5.0 / 18.0)];

/// A deviation that is followed through the whole recorded part.
#[derive(Debug, Clone)]
struct Followed {
    output: usize,
    deviation: Deviation,
    maximum: Peak,
    /// Of the negative.
    minimum: Peak,
    /// Integrals over time of the deviation and of its square.
    integral: f64,
    integral_of_square: f64,
    /// Whether any column asks for them.
    is_integrated: bool,
    /// The time up to which it has been followed, and the ideal motions there.
    seen: Option<(f64, IdealJets)>,
}

/// Value, rate and acceleration of the nominal ideal motion, at the same place of the cycle, and of the sample's own, over time; not a
/// number where it is not asked for.
#[derive(Debug, Clone, Copy)]
struct IdealJets {
    nominal: [f64; 3],
    own: [f64; 3],
}

impl Followed {
    fn reduced(&self, reduction: Reduction, span_s: f64) -> f64 {
        let (maximum, minimum) = (self.maximum.value, -self.minimum.value);
        match reduction {
            Reduction::Maximum => maximum,
            Reduction::Minimum => minimum,
            Reduction::MaximumAbsolute => maximum.max(-minimum),
            Reduction::Range => maximum - minimum,
            Reduction::Mean => self.integral / span_s,
            Reduction::RootMeanSquare => (self.integral_of_square / span_s).max(0.0).sqrt(),
        }
    }

    /// Takes in the part of a step from share `from` to share `to` on which the deviation is `f`, a function of the share;
    /// `pace` is dt over the share. Extremes are looked for where `limits` allow a new one.
    fn take(
        &mut self,
        [from, to]: [f64; 2],
        limits: Option<[f64; 2]>,
        pace: impl Fn(f64) -> f64,
        mut f: impl FnMut(f64) -> f64,
    ) {
        let length = to - from;
        let [low, high] = limits.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
        if high > self.maximum.value || -low > self.minimum.value {
            self.take_extremes(from, length, &mut f);
        }
        // Where a position is searched for afresh, what is looked at decides on the last bits of what is looked at next.
        if !self.is_integrated && limits.is_some() {
            return;
        }
        for (place, weight) in GAUSS {
            let share = from + place * length;
            let (value, weight_s) = (f(share), weight * length * pace(share));
            self.integral += weight_s * value;
            self.integral_of_square += weight_s * value * value;
        }
    }

    fn take_extremes(&mut self, from: f64, length: f64, f: &mut impl FnMut(f64) -> f64) {
        let mut points = [(0.0, 0.0); POINTS_PER_STEP];
        for (k, point) in points.iter_mut().enumerate() {
            let share = from + length * k as f64 / (POINTS_PER_STEP - 1) as f64;
            *point = (share, f(share));
        }
        for sign in [1.0, -1.0] {
            let signed = points.map(|(share, value)| (share, sign * value));
            let (low, high) =
                signed.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p.1), h.max(p.1)));
            let peak = if sign > 0.0 { &mut self.maximum } else { &mut self.minimum };
            // Between the points the value can rise above them by a part of their range only.
            if high + 0.25 * (high - low) > peak.value {
                let found = maximum_within(&signed, |share| sign * f(share));
                peak.raise(found.value, found.time_s);
            }
        }
    }
}

/// What every run of a study shares: the columns, and the nominal ideal motion.
#[derive(Debug)]
pub struct Shared {
    /// The columns.
    pub plan: ColumnPlan,
    /// Which outputs any column uses.
    pub is_used: Vec<bool>,
    /// Whether any column asks for a deviation from the sample's own ideal motion.
    pub needs_own_ideal: bool,
    /// Whether any of these columns is of an output without a table.
    pub needs_own_reference: bool,
    /// Used outputs that are positions: they are followed by every run.
    pub readings: Vec<Reading>,
    /// Place of each output among those that are followed.
    pub places: Vec<Option<usize>>,
    /// Nominal ideal positions over the recorded part.
    pub nominal_curve: IdealCurve,
    /// The nominal ideal motion, where forces decide it.
    pub nominal_motion: Option<Arc<FreeMotion>>,
    /// Nominal ideal value of each column's output at its pose; not a number for reduced columns.
    pub nominal_at_pose: Vec<f64>,
    /// Columns at poses in the order of time.
    pub pose_order: Vec<usize>,
}

/// Follows one run. It owns what belongs to the run alone, since many runs go on side by side.
pub struct Recorder<'r> {
    shared: &'r Shared,
    arms: Arms,
    /// The ideal motion of this sample where outputs without a table are compared with it, and its table where others are.
    reference: Option<IdealReference<'r>>,
    curve: Option<Arc<IdealCurve>>,
    /// The nominal ideal motion at this sample's instants, for outputs without a table.
    nominal: Option<IdealReference<'r>>,
    /// Time of this sample to time of the nominal one, both from the start of the recorded part.
    nominal_per_own: f64,
    nominal_start_s: f64,
    window: Window,
    turn_s: f64,
    next_pose: usize,
    followed: Vec<Followed>,
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
    pub fn new(shared: &'r Shared, arms: Arms, references: References<'r>, window: &Window, turn_s: f64) -> Self {
        let mut followed: Vec<Followed> = Vec::new();
        for column in &shared.plan.columns {
            let is_known = followed.iter().any(|f| f.output == column.output && f.deviation == column.deviation);
            if matches!(column.spot, Spot::Reduced(_)) && !is_known {
                let is_integrated = shared.plan.columns.iter().any(|other| {
                    let is_same = other.output == column.output && other.deviation == column.deviation;
                    is_same && matches!(other.spot, Spot::Reduced(Reduction::Mean | Reduction::RootMeanSquare))
                });
                followed.push(Followed {
                    output: column.output,
                    deviation: column.deviation,
                    maximum: Peak::none(),
                    minimum: Peak::none(),
                    integral: 0.0,
                    integral_of_square: 0.0,
                    is_integrated,
                    seen: None,
                });
            }
        }
        let nominal_window = references.nominal_window;
        Self {
            shared,
            arms,
            reference: references.own,
            curve: references.curve,
            nominal: references.nominal,
            nominal_per_own: (nominal_window.end_s - nominal_window.start_s) / (window.end_s - window.start_s),
            nominal_start_s: nominal_window.start_s,
            window: *window,
            turn_s,
            next_pose: 0,
            followed,
            turn_before: None,
            at_end: None,
            values: vec![f64::NAN; shared.plan.columns.len()],
            failure: None,
        }
    }

    /// Fills the reduced columns once the run is over.
    pub fn finish(&mut self) {
        let span_s = self.window.end_s - self.window.start_s;
        for (value, column) in self.values.iter_mut().zip(&self.shared.plan.columns) {
            if let Spot::Reduced(reduction) = column.spot {
                let found = self.followed.iter().find(|f| f.output == column.output && f.deviation == column.deviation);
                *value = found.map_or(f64::NAN, |followed| followed.reduced(reduction, span_s));
            }
        }
    }

    /// Largest difference between all poses at the end and one turn before, relative to `size_m` in positions and in rad for
    /// angles. None where less than a turn was recorded.
    pub fn change_over_last_turn(&self, size_m: f64) -> Option<f64> {
        let (before, end) = (self.turn_before.as_ref()?, self.at_end.as_ref()?);
        let differences = before.iter().zip(end).map(|(a, b)| {
            let position = (a[0] - b[0]).abs().max((a[1] - b[1]).abs()) / size_m;
            position.max(2.0 * ((a[2] - b[2]) / 2.0).sin().abs())
        });
        Some(differences.fold(0.0, f64::max))
    }

    fn share(&self, time_s: f64) -> f64 {
        ((time_s - self.window.start_s) / (self.window.end_s - self.window.start_s)).clamp(0.0, 1.0)
    }

    /// Ideal value of this sample.
    fn own_ideal(&mut self, output: usize, time_s: f64) -> f64 {
        let reading = self.shared.plan.outputs[output].reading;
        if let Some(curve) = self.curve.as_ref().filter(|_| reading.is_position()) {
            return curve.value(output, self.share(time_s));
        }
        match &mut self.reference {
            Some(own) => read(own, &mut self.failure, |dynamics| reading.value(&self.arms, dynamics), time_s),
            None => f64::NAN,
        }
    }

    /// Nominal ideal value at the same place of the cycle.
    fn nominal_ideal(&mut self, output: usize, time_s: f64) -> f64 {
        let reading = self.shared.plan.outputs[output].reading;
        if reading.is_position() {
            return self.shared.nominal_curve.value(output, self.share(time_s));
        }
        let nominal_s = self.nominal_start_s + self.nominal_per_own * (time_s - self.window.start_s);
        match &mut self.nominal {
            Some(nominal) => {
                read(nominal, &mut self.failure, |dynamics| reading.value(&self.arms, dynamics), nominal_s)
            }
            None => f64::NAN,
        }
    }

    /// The deviation, given the value of the real mechanism.
    fn deviation(&mut self, output: usize, deviation: Deviation, actual: f64, time_s: f64) -> f64 {
        match deviation {
            Deviation::Value => actual,
            Deviation::Total => actual - self.nominal_ideal(output, time_s),
            Deviation::Clearance => actual - self.own_ideal(output, time_s),
            Deviation::Dimensional => self.own_ideal(output, time_s) - self.nominal_ideal(output, time_s),
        }
    }

    fn record_poses(&mut self, step: &mut Step<'_, '_>) {
        while let Some(&first) = self.shared.pose_order.get(self.next_pose) {
            let Spot::Pose { turns, .. } = self.shared.plan.columns[first].spot else { return };
            let time_s = self.window.start_s + turns * self.turn_s;
            // A pose at the very end may lie behind the last step by round-off.
            if time_s > step.end_s && step.end_s < self.window.end_s {
                return;
            }
            // All columns of this pose from one look at the step.
            let shared = self.shared;
            let at =
                |column: usize| matches!(shared.plan.columns[column].spot, Spot::Pose { turns: t, .. } if t == turns);
            let count = shared.pose_order[self.next_pose..].iter().take_while(|&&c| at(c)).count();
            let columns = &shared.pose_order[self.next_pose..self.next_pose + count];
            self.next_pose += count;
            let share = step.share(time_s);
            for &column in columns {
                let planned = shared.plan.columns[column];
                let actual = self.actual(step, planned.output, time_s, share);
                let nominal = shared.nominal_at_pose[column];
                self.values[column] = match planned.deviation {
                    Deviation::Value => actual,
                    Deviation::Total => actual - nominal,
                    Deviation::Clearance => actual - self.own_ideal(planned.output, time_s),
                    Deviation::Dimensional => self.own_ideal(planned.output, time_s) - nominal,
                };
            }
        }
    }

    /// Value of the real mechanism within a step: positions from their polynomial, anything else from a look inside.
    fn actual(&self, step: &mut Step<'_, '_>, output: usize, time_s: f64, share: f64) -> f64 {
        let reading = self.shared.plan.outputs[output].reading;
        if let Some(place) = self.shared.places[output] {
            let [start, end] = step.outputs[place];
            return Quintic::new(start, end, step.length).value(share);
        }
        let dynamics = if reading.needs_forces() { step.evaluate(time_s) } else { step.set_state(time_s) };
        reading.value(&self.arms, dynamics)
    }

    fn follow(&mut self, step: &mut Step<'_, '_>) {
        let (start_s, end_s) = (step.start_s.max(self.window.start_s), step.end_s.min(self.window.end_s));
        if self.followed.is_empty() || !(end_s > start_s) {
            return;
        }
        let shares = [step.share(start_s), step.share(end_s)];
        let (time, length) = (step.uneven_time(), step.length);
        let pace = |share: f64| time.as_ref().map_or(1.0, |time| time.slope(share) / length) * length;
        let mut followed = std::mem::take(&mut self.followed);
        for one in &mut followed {
            let (output, deviation) = (one.output, one.deviation);
            if self.shared.places[output].is_some() {
                let quintic = self.deviation_polynomial(step, one);
                one.take(shares, Some(quintic.limits()), pace, |share| quintic.value(share));
            } else {
                // No polynomial: by time, looking inside the step.
                let span_s = end_s - start_s;
                one.take(
                    [0.0, 1.0],
                    None,
                    |_| span_s,
                    |share| {
                        let time_s = start_s + share * span_s;
                        let actual = self.actual(step, output, time_s, 0.0);
                        self.deviation(output, deviation, actual, time_s)
                    },
                );
            }
        }
        self.followed = followed;
    }

    /// The deviation of a position over a step, as a polynomial of the share of the step.
    fn deviation_polynomial(&self, step: &Step<'_, '_>, followed: &mut Followed) -> Quintic {
        let [start_s, end_s] = [0, 1].map(|side| step.time(side)[0]);
        // Most steps begin where the one before ended.
        let start = match followed.seen {
            Some((seen_s, jets)) if seen_s == start_s => jets,
            _ => self.ideal_jets(followed, start_s),
        };
        let end = self.ideal_jets(followed, end_s);
        followed.seen = Some((end_s, end));
        let [start, end] = [(0, start), (1, end)].map(|(side, ideal)| self.deviation_jet(step, side, followed, ideal));
        Quintic::new(start, end, step.length)
    }

    /// The ideal motions at `time_s`, as far as this deviation asks for them.
    #[inline(always)]
    fn ideal_jets(&self, followed: &Followed, time_s: f64) -> IdealJets {
        let (output, share) = (followed.output, self.share(time_s));
        // The nominal motion is read at the same place of the cycle, where its time runs in proportion.
        let nominal = || {
            let [value, rate, acceleration] = self.shared.nominal_curve.jet(output, share);
            [value, rate * self.nominal_per_own, acceleration * self.nominal_per_own * self.nominal_per_own]
        };
        let own = || self.curve.as_ref().map_or([f64::NAN; 3], |curve| curve.jet(output, share));
        let none = [f64::NAN; 3];
        let (nominal, own) = match followed.deviation {
            Deviation::Value => (none, none),
            Deviation::Total => (nominal(), none),
            Deviation::Clearance => (none, own()),
            Deviation::Dimensional => (nominal(), own()),
        };
        IdealJets { nominal, own }
    }

    /// The deviation of a position at an end of a step, with its derivatives over the variable of integration.
    #[inline(always)]
    fn deviation_jet(&self, step: &Step<'_, '_>, side: usize, followed: &Followed, ideal: IdealJets) -> [f64; 3] {
        let (time, IdealJets { nominal, own }) = (step.time(side), ideal);
        let actual = || self.shared.places[followed.output].map_or([f64::NAN; 3], |place| step.outputs[place][side]);
        // d/ds = w d/dt, d²/ds² = w² d²/dt² + w' d/dt.
        let over_step = |[value, rate, acceleration]: [f64; 3]| {
            [value, rate * time[1], acceleration * time[1] * time[1] + rate * time[2]]
        };
        let less = |a: [f64; 3], b: [f64; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
        match followed.deviation {
            Deviation::Value => actual(),
            Deviation::Total => less(actual(), over_step(nominal)),
            Deviation::Clearance => less(actual(), over_step(own)),
            Deviation::Dimensional => less(over_step(own), over_step(nominal)),
        }
    }

    fn note_turn(&mut self, step: &mut Step<'_, '_>) {
        let before_s = self.window.end_s - self.turn_s;
        let slack_s = 1e-9 * self.turn_s;
        if self.turn_before.is_none() && before_s >= self.window.start_s - slack_s && before_s <= step.end_s {
            self.turn_before = Some(poses(step.set_state(before_s.max(step.start_s))));
        }
        if step.end_s >= self.window.end_s {
            self.at_end = Some(poses(step.set_state(self.window.end_s)));
        }
    }
}

impl Observer for Recorder<'_> {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        self.follow(step);
        self.record_poses(step);
        self.note_turn(step);
    }
}

/// Reads an ideal motion, keeping the first reason why it could not be followed.
fn read<'a>(
    reference: &mut IdealReference<'a>,
    failure: &mut Option<SampleError>,
    value: impl Fn(&loosepin_mechanics::dynamics::Dynamics<'a, f64>) -> f64,
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

fn poses(dynamics: &loosepin_mechanics::dynamics::Dynamics<'_, f64>) -> Vec<[f64; 3]> {
    dynamics.kinematics.poses.iter().map(|p| [p.position_m.x, p.position_m.y, p.angle_rad]).collect()
}

#[cfg(test)]
mod tests {
    use crate::columns::Spot;
    use crate::file::Reduction;
    use crate::response::StudyResponse;
    use crate::texts::study_with;

    /// The largest deviation of the slider in a turn that begins `transient` turns after the start, and the largest at its poses, m.
    fn largest_m(transient: &str) -> [f64; 2] {
        let path = "cases/slider_crank_worn_pin/study.toml";
        let transient = format!("transient_turns = {transient}\n");
        let response = StudyResponse::new(&study_with(path, &[("transient_turns = 2\n", &transient)])).unwrap();
        let mut row = vec![0.0; response.row_length()];
        response.run(&[0.05, 0.12], &[2e-5, 0.8], &mut row).unwrap();
        let plan = &response.shared.plan;
        let of = |is_meant: &dyn Fn(&Spot) -> bool| {
            let columns = plan.columns.iter().zip(&row);
            let total = columns
                .filter(|(column, _)| column.deviation == crate::file::Deviation::Total && is_meant(&column.spot));
            total.fold(0.0_f64, |most, (_, value)| most.max(value.abs()))
        };
        [of(&|spot| *spot == Spot::Reduced(Reduction::MaximumAbsolute)), of(&|spot| matches!(spot, Spot::Pose { .. }))]
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
}

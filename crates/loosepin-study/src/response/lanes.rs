//! The runs of a study on the lanes of a thread: from inputs to rows.

use crate::response::extras::{JointExtras, RunExtras};
use crate::response::ideal_tables::{CachedIdealMotion, IdealKey};
use crate::response::planar_response::{PlanarResponse, window};
use crate::response::recorder::{Recorder, References};
use loosepin_mechanics::mechanism::{Mechanism, Sample};
use loosepin_simulate::{
    Arms, Execution, IdealCurve, IdealReference, LifePlan, Observer, PlaySummary, Queue, Run, RunFailure, RunReport,
    Settings, Step, WearRecorder, Window, run_batch, worn_life,
};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

impl PlanarResponse {
    /// One run, alone.
    ///
    /// # Errors
    /// The one reason why the run failed.
    pub fn run(&self, random: &[f64], epistemic: &[f64], row: &mut [f64]) -> Result<(), RunFailure> {
        let mut inputs = Some((random, epistemic));
        let mut outcome = None;
        let next = || inputs.take().map(|(x, u)| (0, x, u));
        self.run_all(self.variant(epistemic), Execution::Scalar, next, |_, finished| outcome = Some(finished));
        let finished = outcome.unwrap_or(Err(RunFailure::NotFinite { time_s: 0.0, element: None }))?;
        row.copy_from_slice(&finished);
        Ok(())
    }

    /// Runs on the lanes of this thread until `next` gives no more inputs, all of them of the mechanism `variant`; `finished` gets the rows, or the one reason why
    /// a run failed, under the index that came with the inputs. A row has the same bits whatever the lanes. Returns how long the
    /// preparation of each run took: its numbers and its ideal motion.
    pub fn run_all<'i>(
        &self,
        variant: usize,
        execution: Execution,
        next: impl FnMut() -> Option<(usize, &'i [f64], &'i [f64])>,
        finished: impl FnMut(usize, Result<Vec<f64>, RunFailure>),
    ) -> Vec<Duration> {
        self.run_all_until(variant, execution, &AtomicBool::new(false), next, finished)
    }

    /// As [`Self::run_all`]; once `stop` is set, a life of wear ends as [`RunFailure::Stopped`]. Other runs end as ever: they are short.
    pub fn run_all_until<'i>(
        &self,
        variant: usize,
        execution: Execution,
        stop: &AtomicBool,
        next: impl FnMut() -> Option<(usize, &'i [f64], &'i [f64])>,
        finished: impl FnMut(usize, Result<Vec<f64>, RunFailure>),
    ) -> Vec<Duration> {
        let mechanism = &self.mechanisms[variant];
        let mut queue = StudyQueue { response: self, mechanism, stop, next, finished, preparing: Vec::new() };
        let settings = Settings { largest_evaluations: self.largest_evaluations, ..self.settings };
        run_batch(mechanism, &self.shared.follow, &settings, execution, &mut queue);
        queue.preparing
    }

    /// Everything that a run needs.
    fn prepare(
        &self,
        mechanism: &Mechanism,
        index: usize,
        random: &[f64],
        epistemic: &[f64],
        stop: &AtomicBool,
    ) -> Result<Run<StudyRun<'_>>, RunFailure> {
        let values = self.values(random, epistemic).map_err(|error| RunFailure::Sample(error.into()))?;
        let mut sample = Sample::new(mechanism, &values)?;
        let input = mechanism.model.input(self.span, &values);
        let window = window(&input, self.transient_turns, self.recorded_turns)?;
        let turn_s = (window.end_s - window.start_s) / self.recorded_turns;
        let arms = Arms::new(mechanism, &values);
        let (own, curve) = self.own_ideal(&sample, &arms, &window)?;
        let nominal = if self.shared.needs_nominal_reference() {
            let (motion, end_s) = (self.shared.nominal_motion.as_ref(), self.nominal_window.end_s);
            Some(IdealReference::with_motion(&self.ideal, &self.nominal_ideal, motion, end_s, &self.settings)?)
        } else {
            None
        };
        let followed = self.shared.followed(curve.clone(), &window, turn_s);
        let references = References { own, curve, nominal, nominal_window: self.nominal_window };
        // The row is that of the last cycle; where the worn shape acts back, those before it are run here.
        let settings = Settings { largest_evaluations: self.largest_evaluations, ..self.settings };
        let life = LifePlan { values: &values, window, turns: self.recorded_turns, settings: &settings };
        let life = worn_life(mechanism, &mut sample, &life, stop)?;
        let mut wear = self.shared.needs_wear.then(|| WearRecorder::new(mechanism, &values));
        if let Some(wear) = &mut wear {
            wear.life = life;
        }
        let recorder = Recorder::new(&self.shared, (arms.clone(), wear), references, &window, turn_s);
        let contacts = sample
            .plays
            .iter()
            .zip(&self.restitutions)
            .map(|(play, restitution)| ContactNumbers {
                has_limit: play.largest_valid_impact_speed_m_s.is_finite(),
                nominal_restitution: restitution.map_or(f64::NAN, |id| values[id]),
                delivered_restitution: play.delivered_restitution.unwrap_or(f64::NAN),
                clearance_m: play.clearance_m,
            })
            .collect();
        Ok(Run { sample, arms, window, observer: StudyRun { index, recorder, contacts }, followed, resume: None })
    }

    /// The ideal motion of a sample: its table where a deviation from it is asked for, and itself where outputs without a table are.
    fn own_ideal(
        &self,
        sample: &Sample<f64>,
        arms: &Arms,
        window: &Window,
    ) -> Result<(Option<IdealReference<'_>>, Option<Arc<IdealCurve>>), RunFailure> {
        let (mut sample, needs_own) = (sample.clone().without_play(), self.shared.needs_own_reference);
        // Where drives move everything, the search for a position begins at the one before, which decides on its last bits.
        let is_shared = !(needs_own && self.ideal.is_driven());
        let key = is_shared.then(|| IdealKey::new(&mut sample, self.ideal.is_driven(), arms, window));
        if let Some(CachedIdealMotion { curve, motion }) = key.as_ref().and_then(|key| self.ideal_tables.find(key)) {
            return Ok((motion.map(|motion| IdealReference::of_motion(&self.ideal, &sample, motion)), curve));
        }
        let mut own = IdealReference::new(&self.ideal, &sample, window.end_s, &self.settings)?;
        let curve = if self.shared.needs_own_ideal {
            let (readings, start_s) = (&self.shared.follow.readings, window.start_s);
            let (span_s, nodes) = (window.end_s - window.start_s, self.shared.nominal_curve.nodes.clone());
            Some(Arc::new(own.curve(readings, arms, (start_s, span_s), nodes)?))
        } else {
            None
        };
        let Some(key) = key else { return Ok((Some(own), curve)) };
        let motion = own.free_motion().filter(|_| needs_own);
        self.ideal_tables.keep(key, CachedIdealMotion { curve: curve.clone(), motion });
        Ok((needs_own.then_some(own), curve))
    }

    /// The row of a finished run.
    fn row(&self, mut run: StudyRun<'_>, report: &RunReport) -> Result<Vec<f64>, RunFailure> {
        report.check_energy(&self.mechanism().model)?;
        run.recorder.finish(report);
        if let Some(failure) = run.recorder.failure.take() {
            return Err(failure.into());
        }
        if let Some(joint) = run.recorder.wear_not_finite() {
            let joint = self.mechanism().model.joints[joint.0].name.clone();
            return Err(RunFailure::WearNotFinite { joint });
        }
        let change = run.recorder.change_over_last_turn(self.mechanism().size_m);
        let joint = |(play, contact): (&PlaySummary, &ContactNumbers)| JointExtras {
            contacts: play.contacts as f64,
            floored: play.floored_contacts as f64,
            beyond_validity: if contact.has_limit { play.impacts_beyond_validity as f64 } else { f64::NAN },
            largest_penetration_m: play.largest_penetration_m,
            peak_force_n: play.peak_force_n,
            nominal_restitution: contact.nominal_restitution,
            delivered_restitution: contact.delivered_restitution,
            largest_penetration_share: play.largest_penetration_m / contact.clearance_m,
        };
        let extras = RunExtras {
            energy_residual: report.energy.map_or(f64::NAN, |account| account.relative_residual()),
            evaluations: report.counters.evaluations as f64,
            steps: report.counters.steps as f64,
            change_over_last_turn: change.unwrap_or(f64::NAN),
            joints: report.plays.iter().zip(&run.contacts).map(joint).collect(),
        };
        let mut row = run.recorder.values;
        extras.write(&mut row);
        Ok(row)
    }
}

/// Numbers of a joint with play in the row of a run, besides its counters.
struct ContactNumbers {
    has_limit: bool,
    nominal_restitution: f64,
    delivered_restitution: f64,
    clearance_m: f64,
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

    fn awaits_s(&self) -> f64 {
        self.recorder.awaits_s()
    }
}

/// Inputs that wait, and rows that are finished.
struct StudyQueue<'s, N, F> {
    response: &'s PlanarResponse,
    mechanism: &'s Mechanism,
    stop: &'s AtomicBool,
    next: N,
    finished: F,
    /// How long each run was prepared.
    preparing: Vec<Duration>,
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
            let begun = Instant::now();
            let prepared = self.response.prepare(self.mechanism, index, random, epistemic, self.stop);
            self.preparing.push(begun.elapsed());
            match prepared {
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

#[cfg(test)]
mod tests {
    use crate::Study;
    use crate::response::planar_response::PlanarResponse;
    use crate::response::study_response::StudyResponse;
    use crate::runs::evaluate::{Work, evaluate};
    use loosepin_bounds::{Purpose, RunInputs};
    use loosepin_mechanics::model::Model;
    use loosepin_simulate::{Execution, Plan, RunFailure, simulate};
    use std::sync::atomic::AtomicBool;

    const MODEL: &str = include_str!("../../../../cases/slider_crank_5000/model.toml");
    const JOINT: &str = "radial_clearance = \"0.1 mm\"\nbearing_length = \"20 mm\"\nwear.sectors = 36\n\
        wear.bearing.coefficient = \"1e-12 m^2/N\"\n";
    const LIFE: &str = "\n[load.press]\nkind = \"force\"\npoint = \"slider.pin\"\ndirection = \"180 deg\"\nforce = \"500 N\"\n\
        [wear]\ncycles = 4000\ngeometry = \"worn\"\njumps = 2\nlimit_of = \"slider\"\nlimit = \"0.115 mm\"\n\
        [output.play]\nwear_of = \"joint.gudgeon\"\ncomponent = \"clearance\"\n\
        [output.life]\nwear_of = \"joint.gudgeon\"\ncomponent = \"life\"\n";
    const STUDY: &str = "name = \"lives\"\nmodel = \"model.toml\"\n[epistemic]\n\
        \"joint.gudgeon.wear.bearing.coefficient\" = { interval = [\"1e-15 m^2/N\", \"1e-12 m^2/N\"] }\n\
        [[ask]]\noutput = \"play\"\nof = \"value\"\nreduce = \"maximum\"\nstatistics = [{ quantile = 0.5 }]\n\
        [[ask]]\noutput = \"life\"\nof = \"value\"\nreduce = \"maximum\"\nstatistics = [{ quantile = 0.5 }]\n";

    fn response() -> PlanarResponse {
        let text = MODEL.replace("radial_clearance = \"0.5 mm\"\n", JOINT).replace("5000 rpm", "300 rpm");
        let text = text.replace("recorded_turns = 2", "recorded_turns = 0.02") + LIFE;
        let model = Model::from_text("model.toml", &text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        let study = Study::from_text("study.toml", STUDY, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        PlanarResponse::new(&study).unwrap_or_else(|error| panic!("{error}"))
    }

    /// Coefficients of the bearing, m²/N: one with which the limit is never passed, and one with which it is.
    const COEFFICIENTS_M2_N: [[f64; 1]; 2] = [[1e-15], [1e-12]];

    #[test]
    fn identity_rows_of_a_study_with_worn_shapes_are_single_lives() {
        let response = response();
        let mut rows = vec![Vec::new(); COEFFICIENTS_M2_N.len()];
        let mut inputs = COEFFICIENTS_M2_N.iter().enumerate();
        let next = || inputs.next().map(|(index, own)| (index, &[][..], &own[..]));
        response.run_all(0, Execution::best(), next, |index, row| rows[index] = row.unwrap_or_else(|e| panic!("{e}")));
        let column = |ask: usize| response.shared.plan.asks[ask].columns[0];
        let mut lives = Vec::new();
        for (row, own) in rows.iter().zip(&COEFFICIENTS_M2_N) {
            let values = response.values(&[], own).unwrap_or_else(|error| panic!("{error}"));
            let mut plan = Plan::of_model(&response.mechanism().model);
            plan.settings = response.settings;
            let single = simulate(response.mechanism(), &values, &plan).unwrap_or_else(|failure| panic!("{failure}"));
            let life = single.record.life.unwrap_or_else(|| panic!("no life"));
            let clearance_m = life.joints[0].largest_clearance_m.last().copied();
            assert_eq!(clearance_m, Some(row[column(0)]));
            let cycles = life.limit.and_then(|limit| limit.cycles);
            assert_eq!(cycles.unwrap_or(4000.0), row[column(1)]);
            lives.push(cycles);
        }
        assert!(lives[0].is_none() && lives[1].is_some_and(|cycles| 0.0 < cycles && cycles < 4000.0), "{lives:?}");
    }

    #[test]
    fn identity_a_stopped_study_leaves_the_life_that_it_is_in_without_a_row() {
        let (response, stop) = (response(), AtomicBool::new(true));
        let mut inputs = COEFFICIENTS_M2_N.iter().enumerate();
        let next = || inputs.next().map(|(index, own)| (index, &[][..], &own[..]));
        let mut failures = Vec::new();
        response.run_all_until(0, Execution::best(), &stop, next, |_, outcome| failures.push(outcome.err()));
        assert_eq!(failures.len(), 2);
        assert!(failures.iter().all(|own| matches!(own, Some(RunFailure::Stopped { .. }))), "{failures:?}");
        let [round, point, replicate, index] = [0; 4];
        let (random, epistemic) = (Vec::new(), COEFFICIENTS_M2_N[1].to_vec());
        let batch = [RunInputs { round, purpose: Purpose::DoubleLoop, point, replicate, index, random, epistemic }];
        let work = Work { batch: &batch, is_waiting: &[true], response: &StudyResponse::of(response), stop: &stop };
        let rows = evaluate(&work, vec![None], &|| false, &|_, _| panic!("a row was kept"));
        assert!(rows.iter().all(Option::is_none));
    }
}

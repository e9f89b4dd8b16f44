//! One run alone: the equations as they stand, on plain numbers.

use crate::follow::{Follow, LOBATTO};
use crate::lanes::memory::LaneLayout;
use crate::lanes::memory::{Memory, MemoryBlocks};
use crate::lanes::pass::Pass;
use crate::settings::{Integrator, Settings};
use crate::stepping::implicit::{Implicit, TOO_LONG, hides_contact};
use crate::stepping::motion::Motion;
use crate::stepping::motion::tolerances;
use crate::stepping::projection::Projection;
use loosepin_math::integrate::{Radau, System};
use loosepin_mechanics::dynamics::PlayState;
use loosepin_mechanics::mechanism::{Arms, Mechanism, Sample};
use loosepin_mechanics::model::Reading;

/// Change of coordinates over which slopes are taken, rad, and m for each metre of the mechanism.
const DIFFERENCE: f64 = 1e-7;

/// The equations of the one lane there is.
pub struct SingleLane<'a> {
    motion: Motion<'a, f64>,
    projection: Option<Projection<f64>>,
    readings: Vec<Reading>,
    /// What is looked at inside the steps, and the state there.
    inside: Vec<Reading>,
    state: Vec<f64>,
    arms: Arms,
    /// Implicit steps, where they are asked for.
    implicit: Option<Implicit>,
}

impl<'a> SingleLane<'a> {
    /// With the numbers of `sample` until another one is loaded; reads what `follow` says.
    pub fn new(
        mechanism: &'a Mechanism,
        sample: &Sample<f64>,
        arms: &Arms,
        follow: &Follow,
        settings: &Settings,
    ) -> Self {
        let motion = Motion::new(mechanism, sample);
        let implicit = || {
            let layout = &motion.layout;
            // Of lengths one, of angles one over the size of the mechanism.
            let units = tolerances(mechanism, layout, sample, 1.0, 1.0, 1.0);
            let differences =
                units[..layout.freedoms].iter().map(|unit| DIFFERENCE * mechanism.size_m * unit).collect();
            let [dimension, integrals] = [layout.dimension, layout.integrals()];
            let radau = Radau::new(layout.freedoms, dimension, integrals, differences, layout.has_dampers);
            Implicit::new(radau)
        };
        Self {
            implicit: (settings.integrator == Integrator::Implicit).then(implicit),
            state: vec![0.0; motion.layout.dimension],
            motion,
            projection: Projection::<f64>::is_needed(mechanism).then(|| Projection::new(mechanism)),
            readings: follow.readings.clone(),
            inside: follow.inside.clone(),
            arms: arms.clone(),
        }
    }

    /// Takes the numbers of a run.
    pub fn load(&mut self, sample: &Sample<f64>, arms: &Arms) {
        if let Some(implicit) = &mut self.implicit {
            implicit.radau.restart();
        }
        self.motion.dynamics.sample_mut().clone_from(sample);
        self.arms.clone_from(arms);
    }

    /// Sets the state of a contact.
    pub fn set_contact(&mut self, contact: usize, state: &PlayState<f64>, has_root: bool) {
        self.motion.states[contact] = *state;
        if let Some(root) = &mut self.motion.unknowns[contact].root {
            root.is_unknown = f64::from(u8::from(has_root));
        }
    }

    /// Evaluates at the start of the step.
    pub fn evaluate_start(&mut self, pass: &Pass, memory: &mut Memory) {
        let MemoryBlocks { rows, end_reads, .. } = MemoryBlocks::new(memory.blocks());
        let end = pass.stepper.end_row() * pass.layout.length();
        self.reading(end_reads).derivative_at_end(rows.start, &mut rows.stages[end..end + pass.layout.length()]);
    }

    /// Tries the step.
    pub fn attempt(&mut self, pass: &Pass, memory: &mut Memory) {
        let mut named = MemoryBlocks::new(memory.blocks());
        pass.choose_step(&mut named);
        if let Some(mut implicit) = self.implicit.take() {
            let is_implicit = self.motion.states.iter().all(|state| state.contact == 0.0);
            implicit.begin(is_implicit);
            if is_implicit {
                self.attempt_implicitly(&mut implicit.radau, pass, &mut named);
            }
            self.implicit = Some(implicit);
            if is_implicit {
                return pass.judge_attempt(self.motion.dynamics.sample(), &mut named);
            }
        }
        self.motion.set_known_angles(&pass.reads, named.start_reads);
        let system = &mut ReadingSystem { is_near: true, ..self.reading(named.end_reads) };
        pass.attempt(&mut named.rows, named.lane, system);
        pass.limit_turns(&mut named);
        pass.judge_attempt(self.motion.dynamics.sample(), &mut named);
    }

    /// Tries an implicit step.
    fn attempt_implicitly(&mut self, radau: &mut Radau, pass: &Pass, named: &mut MemoryBlocks<'_, f64>) {
        let (end_row, weights) = (pass.stepper.end_row(), named.lane[pass.lane.weights()].to_vec());
        let step_s = named.lane[LaneLayout::STEP];
        let found = radau.attempt(&mut named.rows, end_row, step_s, &weights, &mut self.reading(named.end_reads));
        named.lane[LaneLayout::ERROR] = found.error;
        named.lane[LaneLayout::GROWTH] = found.growth;
        if found.error <= 1.0 && hides_contact(pass, &mut self.motion, named, &mut self.state) {
            (named.lane[LaneLayout::ERROR], named.lane[LaneLayout::GROWTH]) = TOO_LONG;
        }
        // Those of an explicit step are counted for every attempt.
        named.lane[LaneLayout::EVALUATIONS] += found.evaluations as f64 - pass.stepper.evaluations_per_attempt() as f64;
        named.lane[LaneLayout::FACTORIZATIONS] += found.factorizations as f64;
    }

    /// Whether loops are held.
    pub fn holds_loops(&self) -> bool {
        self.projection.is_some()
    }

    /// Holds the loops of ideal joints.
    pub fn hold_loops(&mut self, pass: &Pass, memory: &mut Memory) {
        if let Some(projection) = &mut self.projection {
            pass.hold_loops(&mut MemoryBlocks::new(memory.blocks()), &mut self.motion, projection);
        }
    }

    /// Computes what looks inside of the current step need.
    pub fn prepare_dense(&mut self, pass: &Pass, memory: &mut Memory) {
        let MemoryBlocks { lane, mut rows, .. } = MemoryBlocks::new(memory.blocks());
        if self.is_implicit() {
            return pass.stepper.prepare_cubic(&mut rows, lane[LaneLayout::STEP]);
        }
        self.motion.set_near(true);
        pass.prepare_dense(&mut rows, lane, &mut self.motion);
        self.motion.set_near(false);
    }

    /// Whether the current step is an implicit one: its dense output is to be corrected.
    pub fn is_implicit(&self) -> bool {
        self.implicit.as_ref().is_some_and(|implicit| implicit.is_at_hand)
    }

    /// Corrects the state at `share` inside the current implicit step; returns its evaluations.
    pub fn correct(&mut self, pass: &Pass, memory: &mut Memory, share: f64, state: &mut [f64]) -> u64 {
        let Some(implicit) = &mut self.implicit else { return 0 };
        let equations = (pass, &mut self.motion, self.projection.as_mut());
        implicit.correct(equations, &MemoryBlocks::new(memory.blocks()), share, state)
    }

    /// Takes in the values inside the current step, whose dense output is known; gives the evaluations that corrections took.
    pub fn look_inside(&mut self, pass: &Pass, memory: &mut Memory) -> u64 {
        let Self { motion, projection, inside, state, arms, implicit, .. } = self;
        let mut implicit = implicit.as_mut().filter(|implicit| implicit.is_at_hand);
        let mut named = MemoryBlocks::new(memory.blocks());
        let (dimension, mut evaluations) = (state.len(), 0);
        for point in 0..LOBATTO.len() {
            match point {
                0 => state.copy_from_slice(&named.rows.start[..dimension]),
                last if last + 1 == LOBATTO.len() => state.copy_from_slice(&named.rows.end[..dimension]),
                _ => {
                    pass.state_inside(&named.rows, point, state);
                    if let Some(implicit) = &mut implicit {
                        let equations = (pass, &mut *motion, projection.as_mut());
                        evaluations += implicit.correct(equations, &named, LOBATTO[point].0, state);
                    }
                    if let Some(projection) = projection {
                        projection.hold(motion, state[pass.layout.time()], state);
                    }
                }
            }
            motion.evaluate(state[pass.layout.time()], state);
            for (place, reading) in inside.iter().enumerate() {
                let value = pass.first_inside() + pass.follow.inside().value(point, place);
                named.rows.stages[value] = reading.value(arms, &motion.dynamics);
            }
        }
        pass.take_inside(&mut named);
        evaluations
    }

    fn reading<'s>(&'s mut self, reads: &'s mut [f64]) -> ReadingSystem<'s, 'a> {
        ReadingSystem { plain: self, reads, is_near: false }
    }
}

/// The equations, and the destination of the readings at the end of a step.
struct ReadingSystem<'s, 'a> {
    plain: &'s mut SingleLane<'a>,
    reads: &'s mut [f64],
    /// Whether points within the step are near the known angles.
    is_near: bool,
}

impl System for ReadingSystem<'_, '_> {
    fn derivative(&mut self, state: &[f64], slope: &mut [f64]) {
        self.plain.motion.set_near(self.is_near);
        self.plain.motion.derivative(state, slope);
        self.plain.motion.set_near(false);
    }

    fn derivative_at_end(&mut self, state: &[f64], slope: &mut [f64]) {
        let SingleLane { motion, readings, arms, .. } = self.plain;
        motion.derivative(state, slope);
        motion.read(readings, arms, self.reads);
    }
}

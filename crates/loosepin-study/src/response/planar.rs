//! What the response of a mechanism in the plane says of itself: its runs are integrated.

use crate::response::columns::ColumnPlan;
use crate::response::kind::{KindOfResponse, Stepping, WaitingRun};
use crate::response::planar_response::PlanarResponse;
use loosepin_mechanics::mechanism::Sample;
use loosepin_mechanics::model::{Cycle, JointId, PlayId};
use loosepin_result::motion::MotionRecord;
use loosepin_result::simulation::Drawing;
use loosepin_result::study::StudiedLaw;
use loosepin_simulate::accuracy::{MotionPlan, motion};
use loosepin_simulate::{Execution, Plan, Reading, RunFailure, Simulation, contact_basis, simulate_poses, skeleton};
use loosepin_text::numbers::{QuantityError, Values};
use std::sync::atomic::AtomicBool;
use std::time::Duration;

impl KindOfResponse for PlanarResponse {
    fn plan(&self) -> &ColumnPlan {
        &self.shared.plan
    }

    fn nominal(&self) -> &Values {
        &self.nominal
    }

    fn nominal_at_pose(&self) -> &[f64] {
        &self.shared.nominal_at_pose
    }

    fn recorded_turns(&self) -> f64 {
        self.recorded_turns
    }

    fn joints(&self) -> &[String] {
        &self.joints
    }

    fn variants(&self) -> usize {
        self.mechanisms.len()
    }

    fn variant(&self, epistemic: &[f64]) -> usize {
        PlanarResponse::variant(self, epistemic)
    }

    fn values(&self, random: &[f64], epistemic: &[f64]) -> Result<Values, QuantityError> {
        PlanarResponse::values(self, random, epistemic)
    }

    fn run(&self, random: &[f64], epistemic: &[f64], row: &mut [f64]) -> Result<(), RunFailure> {
        PlanarResponse::run(self, random, epistemic, row)
    }

    fn run_waiting<'i>(
        &self,
        variant: usize,
        execution: Execution,
        stop: &AtomicBool,
        next: &mut dyn FnMut() -> Option<WaitingRun<'i>>,
        finished: &mut dyn FnMut(usize, Result<Vec<f64>, RunFailure>),
    ) -> Vec<Duration> {
        self.run_all_until(variant, execution, stop, next, finished)
    }

    fn stepping(&self) -> Option<Stepping<'_>> {
        Some(Stepping {
            settings: self.settings(),
            multiplications: self.mechanism().multiplications(),
            is_driven: self.mechanism().is_driven(),
            nominal_end_s: self.nominal_end_s(),
        })
    }

    fn limit_evaluations(&mut self, largest_evaluations: u64) {
        PlanarResponse::limit_evaluations(self, largest_evaluations);
    }

    fn plays(&self) -> &[PlayId] {
        &self.mechanism().plays
    }

    fn name_of_contact(&self, joint: JointId) -> Option<&str> {
        let mechanism = self.mechanism();
        let has_play = mechanism.plays.contains(&PlayId::Joint(joint));
        has_play.then(|| mechanism.model.joints[joint.0].name.as_str())
    }

    fn laws_of_play(&self, play: usize) -> Vec<StudiedLaw> {
        let mut laws: Vec<StudiedLaw> = Vec::new();
        for mechanism in &self.mechanisms {
            let (model, id) = (&mechanism.model, mechanism.plays[play]);
            let Some(contact) = model.play_contact(id) else { continue };
            let law = model.contacts[contact.0].law.name();
            if laws.iter().any(|known| known.law == law) {
                continue;
            }
            let sample = Sample::<f64>::new(mechanism, &self.nominal).ok();
            let basis = sample.and_then(|sample| contact_basis(mechanism, id, &sample.plays[play], &self.nominal));
            laws.extend(basis.map(|basis| StudiedLaw { law: law.to_owned(), basis }));
        }
        laws
    }

    fn skeleton(&self) -> Drawing {
        skeleton(self.mechanism(), &self.nominal)
    }

    fn drawn_run(&self, random: &[f64], epistemic: &[f64], cycle: &Cycle, has_second_run: bool) -> Option<Simulation> {
        let values = self.values(random, epistemic).ok()?;
        let plan = Plan {
            cycle: cycle.clone(),
            settings: *self.settings(),
            with_states: false,
            lyapunov_turns: None,
            second_run: has_second_run,
            overrides: Vec::new(),
        };
        simulate_poses(&self.mechanisms[self.variant(epistemic)], &values, &plan).ok()
    }

    fn ideal_jets(&self, readings: [Reading; 2], share: f64) -> Option<[[f64; 3]; 2]> {
        let place = |own: Reading| self.shared.follow.readings.iter().position(|reading| *reading == own);
        let (x, y) = place(readings[0]).zip(place(readings[1]))?;
        // The time has no part in a direction.
        Some([x, y].map(|reading| self.shared.nominal_curve.jet(reading, share, 1.0)))
    }

    fn nominal_motion(&self, plan: &MotionPlan) -> Option<MotionRecord> {
        motion(self.mechanism(), &self.nominal, plan).ok()
    }
}

//! The equations of a reference case as straight-line programs, in parts that hold one another, and the integrator's own
//! arithmetic: what `benches/equations.rs` counts and times.

use crate::batch::Case;
use loosepin::contact::PlayState;
use loosepin::dynamics::{ContactUnknowns, DepthRoot, Dynamics};
use loosepin::integrate::{Stepper, System, Tableau};
use loosepin::math::{Real, Vec2};
use loosepin::mechanism::{IdealMotion, Sample};
use loosepin::native::{Program, Slot};
use loosepin::simulate::{Arms, EquationPrograms};
use loosepin::trace::{Traced, record};

// Blocks of all programs of the equations, as `EquationPrograms` has them.
const NUMBERS: u8 = 0;
const CONTACTS: u8 = 1;
const STATE: u8 = 2;
const SLOPE: u8 = 3;

/// Numbers of a contact among the inputs: whether it is closed, 1/v0, m_eff, whether the root of its penetration is an unknown.
const PER_CONTACT: usize = 4;
/// Integrals of the energy account behind the unknowns.
const ACCOUNT: usize = 3;

/// A program and what it computes.
#[derive(Debug, Clone)]
pub struct Part {
    /// In words.
    pub name: &'static str,
    /// Everything of the parts before it, and this.
    pub program: Program,
}

/// The equations of `case` from the sines to what is read at the end of a step. Each program does what the one before does
/// and one thing more, so that the difference of two is what that thing costs.
///
/// # Panics
/// For a case whose joints with play have friction or a law without a root of the penetration.
pub fn parts(case: &Case) -> Vec<Part> {
    let mechanism = &case.mechanism;
    let (sample, arms) = nominal(case);
    let numbers = sample.numbers();
    let recorded = record(|| {
        let mut index = 0;
        let mut traced = Sample::broadcast(&sample);
        traced.visit(&mut |number| {
            let value = numbers[index];
            // As in a batch: what is 0 or ±1 is taken into the program.
            *number = if value == 0.0 || value.abs() == 1.0 { Traced::from_f64(value) } else { input(NUMBERS, index) };
            index += 1;
        });
        let mut dynamics = Dynamics::new(mechanism, &traced);
        let n = mechanism.real.free;
        let state: Vec<Traced> = (0..dimension(case)).map(|k| input(STATE, k)).collect();
        let contacts = 0..mechanism.contacts.len();
        let number = |contact: usize, k: usize| input(CONTACTS, PER_CONTACT * contact + k);
        let states: Vec<_> = contacts
            .clone()
            .map(|contact| PlayState {
                contact: number(contact, 0),
                inverse_impact_speed_s_m: number(contact, 1),
                effective_mass_kg: number(contact, 2),
            })
            .collect();
        let unknowns: Vec<_> = contacts
            .map(|contact| {
                let root = DepthRoot { is_unknown: number(contact, 3), root: state[2 * n + 1 + contact] };
                ContactUnknowns { root: Some(root), bristle_m: None }
            })
            .collect();
        dynamics.evaluate_with_unknowns(state[2 * n], &state[..n], &state[n..2 * n], &states, &unknowns);

        let vector = |vector: Vec2<Traced>| [vector.x, vector.y];
        let sines: Vec<_> = dynamics.kinematics.poses.iter().flat_map(|pose| [pose.sine, pose.cosine]).collect();
        let moves = dynamics
            .plays()
            .iter()
            .flat_map(|motion| [motion.eccentricity_m, motion.eccentricity_rate_m_s].into_iter().flat_map(vector));
        let moves: Vec<_> = sines.iter().copied().chain(moves).collect();
        let forces = dynamics.contacts().iter().flat_map(|force| vector(force.on_journal_n));
        let forces: Vec<_> = moves.iter().copied().chain(forces).collect();
        let accelerations: Vec<_> = forces.iter().chain(dynamics.accelerations()).copied().collect();
        [
            ("sine and cosine", sines),
            ("positions and velocities of the pin", moves),
            ("contact force", forces),
            ("inertia, gravity, solution for the accelerations", accelerations),
        ]
    });
    let (graph, outputs) = recorded.expect("the law of the case has a straight line");
    let mut parts: Vec<Part> = outputs
        .into_iter()
        .map(|(name, values)| {
            let outputs: Vec<_> = values.iter().enumerate().map(|(k, value)| (slot(SLOPE, k), value.value())).collect();
            Part { name, program: Program::new(&graph, &outputs).expect("each output has its own slot") }
        })
        .collect();
    let whole = EquationPrograms::new(mechanism, &sample, &arms, &[case.reading]).expect("a straight line");
    parts.push(Part { name: "energy account, pace of the time", program: whole.slope });
    parts.push(Part { name: "reading at the end of a step", program: whole.end });
    parts
}

/// Numbers to run the programs of [`parts`] on: for each block its values, each for `lanes` lanes that differ a little. Joints
/// are in contact in every other lane.
///
/// # Panics
/// Where the nominal mechanism cannot be assembled.
pub fn blocks(case: &Case, lanes: usize) -> [Vec<f64>; 3] {
    let mechanism = &case.mechanism;
    let (sample, arms) = nominal(case);
    let ideal = IdealMotion::new(mechanism, &sample.ideal, &sample.drives).expect("the case can be assembled");
    let (coordinates, rates) = mechanism.real_coordinates(ideal.kinematics(), &sample.real);
    let n = mechanism.real.free;
    // Off the ideal position, where the pin has no direction; roots of 10 µm.
    let mut state: Vec<f64> = coordinates[..n].iter().chain(&rates[..n]).map(|value| value + 2e-3).collect();
    state.push(1e-5);
    state.resize(dimension(case), 3e-3);
    let numbers: Vec<f64> = sample.numbers().into_iter().chain(arms.numbers()).collect();
    let spread = |values: &[f64]| -> Vec<f64> {
        let lane = |value: f64, lane: usize| value * (1.0 + 1e-4 * lane as f64);
        values.iter().flat_map(|&value| (0..lanes).map(move |k| lane(value, k))).collect()
    };
    let contacts = (0..PER_CONTACT * mechanism.contacts.len() * lanes)
        .map(|place| match (place / lanes % PER_CONTACT, place % 2) {
            (1 | 2, _) => 0.5,
            (_, parity) => parity as f64,
        })
        .collect();
    [spread(&numbers), contacts, spread(&state)]
}

/// Everything that an attempted step of `tableau` computes for `case` outside of the evaluations: the states of the stages and
/// of the end of the step, and the error.
///
/// # Panics
/// Never: sums have a straight line.
pub fn step(case: &Case, tableau: &'static Tableau) -> Program {
    struct Stages {
        stride: usize,
        evaluations: usize,
        states: Vec<Traced>,
    }
    impl System<Traced> for Stages {
        fn derivative(&mut self, _place: Traced, state: &[Traced], slope: &mut [Traced]) {
            self.states.extend(state);
            for (k, value) in slope.iter_mut().enumerate() {
                *value = input(0, self.evaluations * self.stride + k);
            }
            self.evaluations += 1;
        }
    }
    let (dimension, stride) = (dimension(case), dimension(case) + ACCOUNT);
    let recorded = record(|| {
        let mut stages = Stages { stride, evaluations: 0, states: Vec::new() };
        let mut stepper = Stepper::with_integrals(tableau, dimension, ACCOUNT);
        let start: Vec<Traced> = (0..stride).map(|k| input(1, k)).collect();
        stepper.restart(&mut stages, Traced::zero(), &start);
        stages.states.clear();
        let tolerances: Vec<Traced> = (0..dimension).map(|k| input(2, k)).collect();
        let error = stepper.attempt(&mut stages, input(2, dimension), &tolerances);
        stages.states.iter().chain(stepper.end()).copied().chain([error]).collect::<Vec<_>>()
    });
    let (graph, outputs) = recorded.expect("sums have a straight line");
    let outputs: Vec<_> = outputs.iter().enumerate().map(|(k, value)| (slot(3, k), value.value())).collect();
    Program::new(&graph, &outputs).expect("each output has its own slot")
}

/// Coordinates, rates, the time, and a root for each contact.
fn dimension(case: &Case) -> usize {
    2 * case.mechanism.real.free + 1 + case.mechanism.contacts.len()
}

fn nominal(case: &Case) -> (Sample<f64>, Arms) {
    let values = case.mechanism.model.quantities.nominal();
    let sample = Sample::new(&case.mechanism, &values).expect("the nominal sample fits");
    (sample, Arms::new(&case.mechanism, &values))
}

fn slot(block: u8, index: usize) -> Slot {
    Slot { block, index: index as u32 }
}

fn input(block: u8, index: usize) -> Traced {
    Traced::input(slot(block, index))
}

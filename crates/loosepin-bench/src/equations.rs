//! A step of a reference case as straight-line programs, the equations in parts that hold one another: what
//! `benches/equations.rs` counts and times.

use crate::batch::Case;
use loosepin::contact::PlayState;
use loosepin::dynamics::{ContactUnknowns, DepthRoot, Dynamics};
use loosepin::math::{KnownAngle, Numbers, Real, Vec2};
use loosepin::mechanism::{IdealMotion, Sample};
use loosepin::native::{Hoisted, Program, Slot};
use loosepin::simulate::{Arms, Block, Follow, LaneLayout, PassPrograms, Settings};
use loosepin::trace::{Traced, record};

/// Programs and what they compute together.
#[derive(Debug, Clone)]
pub struct ProgramGroup {
    /// In words.
    pub name: &'static str,
    /// In the order in which they run.
    pub programs: Vec<Program>,
}

/// The equations of `case` from the sines to the readings at the end of a step. Each program does what the one before does and one thing
/// more, so that the difference of two is what that thing costs. Behind them, each by itself, what a step does beside its evaluations.
///
/// # Panics
/// For a case whose joints with play have friction or a law without a root of the penetration.
pub fn parts(case: &Case) -> Vec<ProgramGroup> {
    let mechanism = &case.mechanism;
    let (sample, arms) = nominal(case);
    let numbers = sample.numbers();
    let (graph, outputs) = record(|| {
        let mut index = 0;
        let mut traced = Sample::broadcast(&sample);
        traced.visit(&mut |number| {
            let value = numbers[index];
            // As in a batch: what is 0 or ±1 is taken into the program.
            *number =
                if value == 0.0 || value.abs() == 1.0 { Traced::from_f64(value) } else { input(Block::Numbers, index) };
            index += 1;
        });
        let mut dynamics = Dynamics::new(mechanism, &traced);
        // As in a batch: angles are near those at the start of the step.
        for (turning, slot) in mechanism.real.turning_slots().enumerate() {
            let [angle_rad, sine, cosine] = [0, 1, 2].map(|k| input(Block::StartReads, 3 * turning + k));
            dynamics.kinematics.set_known_angle(slot, KnownAngle { angle_rad, sine, cosine });
        }
        dynamics.kinematics.set_near(true);
        let n = mechanism.real.free;
        let state: Vec<Traced> = (0..dimension(case)).map(|k| input(Block::Point, k)).collect();
        let contacts = 0..mechanism.contacts.len();
        let number = |contact: usize, k: usize| input(Block::Lane, LaneLayout::contact(contact) + k);
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
                let (is_unknown, root) = (number(contact, 3), state[2 * n + 1 + contact]);
                let root = DepthRoot { is_unknown, root, may_be_read: true };
                ContactUnknowns { root: Some(root), bristle_m: None }
            })
            .collect();
        dynamics.evaluate_with_unknowns(state[2 * n], &state[..n], &state[n..2 * n], &states, &unknowns);

        let vector = |vector: Vec2<Traced>| [vector.x, vector.y];
        let sines: Vec<_> =
            dynamics.kinematics.poses.iter().flat_map(|pose| [pose.rotation.sine, pose.rotation.cosine]).collect();
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
    // As in a batch: what depends on the numbers of a run alone is computed before.
    let mut hoisted = Hoisted::new(Block::Numbers as u8, numbers.len() + arms.numbers().len());
    let mut parts: Vec<ProgramGroup> = outputs
        .into_iter()
        .map(|(name, values)| {
            let slots = values.iter().enumerate().map(|(k, value)| (slot(Block::Stages, k), value.value()));
            let outputs: Vec<_> = slots.collect();
            ProgramGroup {
                name,
                programs: vec![hoisted.program(&graph, &outputs).expect("each output has its own slot")],
            }
        })
        .collect();
    let whole =
        PassPrograms::new(mechanism, &sample, &arms, &Follow::readings(&[case.reading]), &Settings::for_study());
    let mut push = |name, programs| parts.push(ProgramGroup { name, programs });
    push("energy account, pace of the time", vec![whole.slope]);
    push("reading at the end of a step", vec![whole.end]);
    push("an evaluation without penetrations off positions", whole.slope_by_roots.into_iter().collect());
    push("what depends on the numbers of a run alone", vec![whole.prepare]);
    push("sums of the stages", whole.points);
    push("error, what may have happened", vec![whole.judgement]);
    let accept = std::iter::once(whole.accept).chain(whole.hold_loops).chain(whole.account);
    push("taking over a step, energy account", accept.collect());
    parts
}

/// Numbers to run the programs of [`parts`] on: for each block its values, each for `lanes` lanes that differ a little. Joints
/// are in contact in every other lane.
///
/// # Panics
/// If the nominal mechanism cannot be assembled.
pub fn blocks(case: &Case, lanes: usize) -> Vec<Vec<f64>> {
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
    let contacts = mechanism.contacts.len();
    let lane = (0..LaneLayout::contact(contacts) * lanes).map(|place| {
        let is_of_contact = |contact: usize| place / lanes >= LaneLayout::contact(contact);
        match (0..contacts).rev().find(|&contact| is_of_contact(contact)) {
            Some(contact) if matches!(place / lanes - LaneLayout::contact(contact), 0 | LaneLayout::HAS_ROOT) => {
                (place % 2) as f64
            }
            _ => 0.5,
        }
    });
    vec![spread(&numbers), lane.collect(), spread(&state), Vec::new(), spread(&state)]
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

fn slot(block: Block, index: usize) -> Slot {
    Slot { block: block as u8, index: index as u32 }
}

fn input(block: Block, index: usize) -> Traced {
    Traced::input(slot(block, index))
}

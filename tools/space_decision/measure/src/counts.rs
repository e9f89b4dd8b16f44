//! Operations of a traced evaluation.

use crate::case::{Case, State, Way};
use loosepin_math::{Numbers, Real};
use loosepin_mechanics::contact::PlayState;
use loosepin_mechanics::mechanism::Sample;
use loosepin_tape::native::{Hoisted, Program, Slot};
use loosepin_tape::trace::{Traced, record};

fn slot(block: u8, index: usize) -> Slot {
    Slot { block, index: index as u32 }
}

/// The program of an evaluation, and the one that runs once for a sample. As in the program, numbers of the sample that are 0 or ±1 are constants, and what depends on the
/// sample alone is taken out. Block 0 holds the sample, block 1 time, coordinates and rates, block 2 the contacts, block 3 the
/// accelerations. In flight, contacts are constants, too.
pub fn program(
    case: &Case,
    in_contact: bool,
    way: impl FnOnce(&Sample<Traced>, &State<Traced>) -> Vec<Traced>,
) -> (Program, Program) {
    let numbers = case.sample.numbers();
    let (graph, outputs) = record(|| {
        let mut sample = Sample::broadcast(&case.sample);
        let mut index = 0;
        sample.visit(&mut |number: &mut Traced| {
            let value = numbers[index];
            let is_fixed = value == 0.0 || value.abs() == 1.0;
            *number = if is_fixed { Traced::from_f64(value) } else { Traced::input(slot(0, index)) };
            index += 1;
        });
        let free = case.mechanism.real.free;
        let input = |index: usize| Traced::input(slot(1, index));
        let contact = |contact: usize| PlayState {
            contact: Traced::input(slot(2, 2 * contact)),
            inverse_impact_speed_s_m: Traced::input(slot(2, 2 * contact + 1)),
            effective_mass_kg: Traced::zero(),
        };
        let contacts = 0..case.sample.contacts.len();
        let state = State {
            time_s: input(0),
            coordinates: (0..free).map(|k| input(1 + k)).collect(),
            rates: (0..free).map(|k| input(1 + free + k)).collect(),
            states: contacts.map(|at| if in_contact { contact(at) } else { PlayState::flight() }).collect(),
        };
        let accelerations = way(&sample, &state);
        accelerations.iter().enumerate().map(|(k, value)| (slot(3, k), value.value())).collect::<Vec<_>>()
    });
    let mut hoisted = Hoisted::new(0, numbers.len());
    let often = hoisted.program(&graph, &outputs).expect("one slot each");
    (often, hoisted.own_program().expect("one slot each"))
}

/// The same of any way.
pub fn of<W: Way<Traced>>(
    case: &Case,
    in_contact: bool,
    make: impl FnOnce(&Sample<Traced>) -> W,
) -> (Program, Program) {
    program(case, in_contact, |sample, state| make(sample).evaluate(state).to_vec())
}

/// Choices of one sine with its cosine; nothing else in flight has any.
pub fn choices_of_sin_cos() -> usize {
    let (graph, (sine, cosine)) = record(|| Traced::input(slot(0, 0)).sin_cos());
    let outputs = [(slot(1, 0), sine.value()), (slot(1, 1), cosine.value())];
    Program::new(&graph, &outputs).expect("two slots").counts().choices
}

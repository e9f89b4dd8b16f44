//! The equations of a mechanism as machine code: written down once on [`Traced`] numbers, compiled for the lanes of a batch.

use super::column::{Arms, Reading};
use super::motion::Motion;
use super::projection::Projection;
use super::reads::ReadLayout;
use loosepin_math::integrate::System;
use loosepin_math::{Lanes, Real};
use loosepin_mechanics::dynamics::{DepthRoot, PlayState};
use loosepin_mechanics::mechanism::{Mechanism, Sample};
use loosepin_tape::native::{Graph, Kernel, Level, Program, Slot, Value};
use loosepin_tape::trace::{Traced, record};

// Blocks of all kernels.
const NUMBERS: u8 = 0;
const CONTACTS: u8 = 1;
const STATE: u8 = 2;
const SLOPE: u8 = 3;
const READS: u8 = 4;

/// Numbers of a contact: whether it is closed, 1/v0, m_eff, whether the root of its penetration is an unknown.
const PER_CONTACT: usize = 4;

/// The equations of a mechanism as straight-line programs: what machine code is made of, to be counted and timed.
///
/// Blocks: numbers of the sample and of the points (0); 1 in contact, 1/v0, m_eff and 1 with a root, of each contact (1);
/// state (2); slope (3); what is read at the end of a step (4).
#[derive(Debug, Clone)]
pub struct EquationPrograms {
    /// The slope of the state.
    pub slope: Program,
    /// The slope, and what is read at the end of a step.
    pub end: Program,
    /// The state held on the loops of ideal joints, where there are any.
    pub projection: Option<Program>,
}

impl EquationPrograms {
    /// Writes down the equations of `mechanism` for the numbers of `sample`, of which those that are 0 or ±1 are taken into
    /// the programs. None for a law that has no straight line.
    pub fn new(mechanism: &Mechanism, sample: &Sample<f64>, arms: &Arms, readings: &[Reading]) -> Option<Self> {
        Tracing { mechanism, sample, arms, readings, fixed: &fixed(sample, arms) }.programs()
    }
}

/// The kernels of a mechanism, and what they work on.
///
/// Numbers of a sample that are 0 or ±1 are taken into the code, which leaves out what they multiply; the bits stay the
/// same. A sample in which such a number differs has the kernels compiled again without it.
pub struct Machine<'a, T> {
    mechanism: &'a Mechanism,
    readings: Vec<Reading>,
    level: Level,
    /// Slope of the state.
    slope: Kernel,
    /// Slope, and what is read at the end of a step.
    end: Kernel,
    /// The state held on the loops of ideal joints, where there are any.
    projection: Option<Kernel>,
    /// By number: the value that is in the code.
    fixed: Vec<Option<f64>>,
    numbers: Vec<T>,
    contacts: Vec<T>,
    state: Vec<T>,
    /// What a kernel without reads or slopes of its own may write to.
    spare: Vec<T>,
}

impl<'a, T: Lanes> Machine<'a, T> {
    /// Compiles the equations of `mechanism` for the numbers of `sample`; none where no machine code can be had: then the
    /// equations are evaluated as they stand, with the same bits.
    pub fn new(
        mechanism: &'a Mechanism,
        sample: &Sample<f64>,
        arms: &Arms,
        readings: &[Reading],
        level: Level,
    ) -> Option<Self> {
        Self::with_fixed(mechanism, sample, arms, readings, level, fixed(sample, arms))
    }

    fn with_fixed(
        mechanism: &'a Mechanism,
        sample: &Sample<f64>,
        arms: &Arms,
        readings: &[Reading],
        level: Level,
        fixed: Vec<Option<f64>>,
    ) -> Option<Self> {
        let programs = Tracing { mechanism, sample, arms, readings, fixed: &fixed }.programs()?;
        let compile = |program: &Program| Kernel::compile(program, level, T::COUNT).ok();
        let length = Motion::new(mechanism, sample).layout.length();
        let projection = match &programs.projection {
            Some(program) => Some(compile(program)?),
            None => None,
        };
        Some(Self {
            mechanism,
            readings: readings.to_vec(),
            level,
            slope: compile(&programs.slope)?,
            end: compile(&programs.end)?,
            projection,
            numbers: vec![T::zero(); fixed.len()],
            contacts: vec![T::zero(); PER_CONTACT * mechanism.contacts.len()],
            state: vec![T::zero(); length],
            spare: vec![T::zero(); length],
            fixed,
        })
    }

    /// Puts the numbers of a run into a lane. False where no code fits them any longer.
    pub fn load(&mut self, lane: usize, sample: &Sample<f64>, arms: &Arms) -> bool {
        let values = numbers(sample, arms);
        if self.fixed.iter().zip(&values).any(|(fixed, value)| fixed.is_some_and(|fixed| fixed != *value)) {
            let fixed: Vec<Option<f64>> =
                self.fixed.iter().zip(&values).map(|(fixed, value)| fixed.filter(|fixed| fixed == value)).collect();
            let (mechanism, readings, level) = (self.mechanism, self.readings.clone(), self.level);
            let Some(fresh) = Self::with_fixed(mechanism, sample, arms, &readings, level, fixed) else { return false };
            let (numbers, contacts) = (std::mem::take(&mut self.numbers), std::mem::take(&mut self.contacts));
            *self = Self { numbers, contacts, ..fresh };
        }
        for (number, value) in self.numbers.iter_mut().zip(values) {
            number.set_lane(lane, value);
        }
        true
    }

    /// Sets the state of a contact in a lane.
    pub fn set_contact(&mut self, lane: usize, contact: usize, state: &PlayState<f64>, has_root: bool) {
        let values =
            [state.contact, state.inverse_impact_speed_s_m, state.effective_mass_kg, f64::from(u8::from(has_root))];
        for (number, value) in self.contacts[PER_CONTACT * contact..].iter_mut().zip(values) {
            number.set_lane(lane, value);
        }
    }

    /// The slope of `state`.
    #[inline(always)]
    pub fn slope(&mut self, state: &[T], slope: &mut [T]) {
        self.state[..state.len()].copy_from_slice(state);
        run(&self.slope, [&mut self.numbers, &mut self.contacts, &mut self.state, slope, &mut []]);
    }

    /// The slope of `state`, and what is read there.
    #[inline(always)]
    pub fn slope_and_reads(&mut self, state: &[T], slope: &mut [T], reads: &mut [T]) {
        self.state[..state.len()].copy_from_slice(state);
        run(&self.end, [&mut self.numbers, &mut self.contacts, &mut self.state, slope, reads]);
    }

    /// `state` held on the loops of ideal joints, coordinates and rates alone.
    #[inline(always)]
    pub fn projected(&mut self, state: &[T]) -> &[T] {
        self.state[..state.len()].copy_from_slice(state);
        if let Some(kernel) = &self.projection {
            run(kernel, [&mut self.numbers, &mut self.contacts, &mut self.state, &mut self.spare, &mut []]);
        }
        &self.spare[..2 * self.mechanism.real.free]
    }
}

/// Runs `kernel`. Its blocks have the lengths that it was compiled for, so that it cannot refuse them.
#[inline(always)]
fn run<T: Lanes>(kernel: &Kernel, blocks: [&mut [T]; 5]) {
    let mut blocks = blocks.map(
        #[inline(always)]
        |block| T::in_a_row(block),
    );
    if let Err(error) = kernel.run(&mut blocks) {
        unreachable!("{error}");
    }
}

/// All numbers that the code may read: those of the sample, then the points of the bodies.
fn numbers(sample: &Sample<f64>, arms: &Arms) -> Vec<f64> {
    let mut numbers = sample.numbers();
    numbers.extend(arms.numbers());
    numbers
}

/// By number: its value where the code is to know it.
fn fixed(sample: &Sample<f64>, arms: &Arms) -> Vec<Option<f64>> {
    numbers(sample, arms).into_iter().map(|value| (value == 0.0 || value.abs() == 1.0).then_some(value)).collect()
}

/// What is written down.
struct Tracing<'t, 'a> {
    mechanism: &'a Mechanism,
    sample: &'t Sample<f64>,
    arms: &'t Arms,
    readings: &'t [Reading],
    fixed: &'t [Option<f64>],
}

type Recorded = (Graph, Vec<(Slot, Value)>);

impl Tracing<'_, '_> {
    /// All programs.
    fn programs(&self) -> Option<EquationPrograms> {
        let program = |(graph, outputs): Recorded| Program::new(&graph, &outputs).ok();
        let projection = match Projection::<Traced>::is_needed(self.mechanism) {
            true => Some(program(self.projection()?)?),
            false => None,
        };
        Some(EquationPrograms { slope: program(self.slope(false)?)?, end: program(self.slope(true)?)?, projection })
    }

    /// The equations with their numbers, contacts and state as inputs; and the points of the bodies.
    fn motion(&self) -> (Motion<'_, Traced>, Vec<Traced>, Arms<Traced>) {
        let mut index = 0;
        let mut next = |number: &mut Traced| {
            *number = match self.fixed[index] {
                Some(value) => Traced::from_f64(value),
                None => input(NUMBERS, index),
            };
            index += 1;
        };
        let mut sample = Sample::broadcast(self.sample);
        sample.visit(&mut next);
        let mut arms = Arms::broadcast(self.arms);
        arms.visit(&mut next);
        let mut motion = Motion::new(self.mechanism, &sample);
        for (contact, (state, unknowns)) in motion.states.iter_mut().zip(&mut motion.unknowns).enumerate() {
            let number = |k: usize| input(CONTACTS, PER_CONTACT * contact + k);
            *state =
                PlayState { contact: number(0), inverse_impact_speed_s_m: number(1), effective_mass_kg: number(2) };
            if let Some(root) = &mut unknowns.root {
                *root = DepthRoot { is_unknown: number(3), root: root.root };
            }
        }
        let state = (0..motion.layout.dimension).map(|k| input(STATE, k)).collect();
        (motion, state, arms)
    }

    /// The slope of the state, and the reads of the end of a step.
    fn slope(&self, with_reads: bool) -> Option<Recorded> {
        let (graph, outputs) = record(|| {
            let (mut motion, state, arms) = self.motion();
            let mut slope = vec![Traced::zero(); motion.layout.length()];
            motion.derivative(Traced::zero(), &state, &mut slope);
            let mut outputs = outputs(SLOPE, &slope);
            if with_reads {
                let layout = ReadLayout::new(self.mechanism, self.readings.len());
                let mut reads = vec![Traced::zero(); layout.length()];
                motion.read(self.readings, &arms, &mut reads);
                outputs.extend(self::outputs(READS, &reads));
            }
            outputs
        })?;
        Some((graph, outputs))
    }

    /// The state held on the loops, with the mass matrix at the state itself.
    fn projection(&self) -> Option<Recorded> {
        record(|| {
            let (mut motion, mut state, _) = self.motion();
            let mut projection = Projection::new(self.mechanism);
            let time_s = state[motion.layout.time()];
            motion.evaluate(time_s, &state);
            projection.keep_mass(&motion);
            projection.apply(&mut motion, time_s, &mut state);
            outputs(SLOPE, &state[..2 * motion.freedoms()])
        })
    }
}

fn input(block: u8, index: usize) -> Traced {
    Traced::input(Slot { block, index: index as u32 })
}

fn outputs(block: u8, values: &[Traced]) -> Vec<(Slot, Value)> {
    values.iter().enumerate().map(|(index, value)| (Slot { block, index: index as u32 }, value.value())).collect()
}

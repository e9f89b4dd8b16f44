//! A pass over many lanes at once: its programs as machine code, or evaluated operation by operation where there is none; the
//! bits are the same.

use super::column::{Arms, Reading};
use super::memory::{BLOCKS, Block, Memory};
use super::pass::Pass;
use super::programs::{PassPrograms, Tracing, fixed, numbers};
use loosepin_mechanics::mechanism::{Mechanism, Sample};
use loosepin_tape::native::{Kernel, Level, Program};

/// A program, and its machine code where that is wanted and can be had.
struct Routine {
    program: Program,
    kernel: Option<Kernel>,
}

impl Routine {
    /// Runs on `blocks` of `lanes` lanes, which have the lengths that the program was written for.
    #[inline]
    fn run(&self, lanes: usize, mut blocks: [&mut [f64]; BLOCKS], scratch: &mut Vec<f64>) {
        let outcome = match &self.kernel {
            Some(kernel) => kernel.run(&mut blocks),
            None => self.program.evaluate(lanes, &mut blocks, scratch),
        };
        if let Err(error) = outcome {
            unreachable!("{error}");
        }
    }
}

struct Routines {
    slope: Routine,
    end: Routine,
    points: Vec<Routine>,
    judgement: Routine,
    dense_points: Vec<Routine>,
    dense: Routine,
    take_evaluation: Routine,
    accept: Routine,
    hold_loops: Option<Routine>,
    account: Routine,
}

impl Routines {
    fn new(programs: PassPrograms, level: Option<Level>, lanes: usize) -> Self {
        let kernels = level.map_or_else(Vec::new, |level| kernels(&programs, level, lanes));
        let mut kernels = kernels.into_iter();
        let mut routine = |program| Routine { program, kernel: kernels.next().flatten() };
        // In the order of `PassPrograms::all`.
        Self {
            points: programs.points.into_iter().map(&mut routine).collect(),
            slope: routine(programs.slope),
            end: routine(programs.end),
            judgement: routine(programs.judgement),
            accept: routine(programs.accept),
            hold_loops: programs.hold_loops.map(&mut routine),
            take_evaluation: routine(programs.take_evaluation),
            account: routine(programs.account),
            dense_points: programs.dense_points.into_iter().map(&mut routine).collect(),
            dense: routine(programs.dense),
        }
    }
}

/// Machine code for all programs, or for those of which it can be had.
fn kernels(programs: &PassPrograms, level: Level, lanes: usize) -> Vec<Option<Kernel>> {
    let programs = programs.all();
    match Kernel::compile_together(&programs, level, lanes) {
        Ok(kernels) => kernels.into_iter().map(Some).collect(),
        Err(_) => programs.into_iter().map(|program| Kernel::compile(program, level, lanes).ok()).collect(),
    }
}

/// The routines of a mechanism.
///
/// Numbers of a sample that are 0 or ±1 are taken into the programs, which leave out what they multiply; the bits stay the
/// same. A sample in which such a number differs has the programs written again without it.
pub struct Recorded<'a> {
    mechanism: &'a Mechanism,
    readings: Vec<Reading>,
    level: Option<Level>,
    lanes: usize,
    lengths: [usize; BLOCKS],
    /// By number: the value that is in the programs.
    fixed: Vec<Option<f64>>,
    routines: Routines,
    scratch: Vec<f64>,
}

impl<'a> Recorded<'a> {
    /// Writes down `pass` for the numbers of `sample`: as machine code for `level`, or to be evaluated.
    pub fn new(
        mechanism: &'a Mechanism,
        sample: &Sample<f64>,
        arms: &Arms,
        readings: &[Reading],
        pass: &Pass,
        lengths: [usize; BLOCKS],
        (level, lanes): (Option<Level>, usize),
    ) -> Self {
        let fixed = fixed(sample, arms);
        let programs = Tracing { mechanism, sample, arms, readings, fixed: &fixed, pass, lengths }.programs();
        Self {
            mechanism,
            readings: readings.to_vec(),
            level,
            lanes,
            lengths,
            fixed,
            routines: Routines::new(programs, level, lanes),
            scratch: Vec::new(),
        }
    }

    /// Puts the numbers of a run into a lane.
    pub fn load(&mut self, pass: &Pass, memory: &mut Memory, lane: usize, sample: &Sample<f64>, arms: &Arms) {
        let values = numbers(sample, arms);
        let is_other = |(fixed, value): (&Option<f64>, &f64)| fixed.is_some_and(|fixed| fixed != *value);
        if self.fixed.iter().zip(&values).any(is_other) {
            for (fixed, value) in self.fixed.iter_mut().zip(&values) {
                *fixed = fixed.filter(|fixed| fixed == value);
            }
            let (mechanism, readings, fixed, lengths) = (self.mechanism, &self.readings, &self.fixed, self.lengths);
            let programs = Tracing { mechanism, sample, arms, readings, fixed, pass, lengths }.programs();
            self.routines = Routines::new(programs, self.level, self.lanes);
        }
        for (index, value) in values.into_iter().enumerate() {
            memory.set(Block::Numbers, index, lane, value);
        }
    }

    /// Evaluates at the start of the step.
    pub fn evaluate_start(&mut self, pass: &Pass, memory: &mut Memory) {
        let [numbers, lane, start, stages, _, end, start_reads, end_reads] = memory.blocks();
        let slope = &mut stages[pass.stepper.end_row() * pass.layout.length() * self.lanes..];
        let blocks = [numbers, lane, &mut [], slope, start, end, start_reads, end_reads];
        self.routines.end.run(self.lanes, blocks, &mut self.scratch);
    }

    /// Tries the steps.
    pub fn attempt(&mut self, pass: &Pass, memory: &mut Memory) {
        let Self { routines, lanes, scratch, .. } = self;
        let row = pass.layout.length() * *lanes;
        for (before, point) in routines.points.iter().enumerate() {
            point.run(*lanes, memory.blocks(), scratch);
            let [numbers, lane, start, stages, point, end, start_reads, end_reads] = memory.blocks();
            let slope = &mut stages[(before + 1) * row..];
            if before + 1 < routines.points.len() {
                let blocks = [numbers, lane, start, slope, point, end, start_reads, end_reads];
                routines.slope.run(*lanes, blocks, scratch);
            } else {
                let blocks = [numbers, lane, start, slope, end, &mut [], start_reads, end_reads];
                routines.end.run(*lanes, blocks, scratch);
            }
        }
        routines.judgement.run(*lanes, memory.blocks(), scratch);
    }

    /// Makes what was evaluated last that of the start of the step, in the chosen lanes.
    pub fn take_evaluation(&mut self, memory: &mut Memory) {
        self.routines.take_evaluation.run(self.lanes, memory.blocks(), &mut self.scratch);
    }

    /// Makes the end of the step the start of the next one, in the chosen lanes.
    pub fn accept(&mut self, memory: &mut Memory) {
        self.routines.accept.run(self.lanes, memory.blocks(), &mut self.scratch);
    }

    /// Holds the loops of ideal joints, in the chosen lanes.
    pub fn hold_loops(&mut self, memory: &mut Memory) {
        if let Some(hold_loops) = &self.routines.hold_loops {
            hold_loops.run(self.lanes, memory.blocks(), &mut self.scratch);
        }
    }

    /// Takes the start of the step into the energy account, in the chosen lanes.
    pub fn close_account(&mut self, memory: &mut Memory) {
        self.routines.account.run(self.lanes, memory.blocks(), &mut self.scratch);
    }

    /// Computes what looks inside of the step at hand need.
    pub fn prepare_dense(&mut self, pass: &Pass, memory: &mut Memory) {
        let Self { routines, lanes, scratch, .. } = self;
        let row = pass.layout.length() * *lanes;
        for (before, point) in routines.dense_points.iter().enumerate() {
            point.run(*lanes, memory.blocks(), scratch);
            let [numbers, lane, start, stages, point, end, start_reads, end_reads] = memory.blocks();
            let slope = &mut stages[(pass.stepper.end_row() + 1 + before) * row..];
            routines.slope.run(*lanes, [numbers, lane, start, slope, point, end, start_reads, end_reads], scratch);
        }
        routines.dense.run(*lanes, memory.blocks(), scratch);
    }
}

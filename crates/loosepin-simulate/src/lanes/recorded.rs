//! A pass over many lanes at once: its programs as machine code, or interpreted where there is none; the bits are the same.

use crate::follow::Follow;
use crate::lanes::memory::{BLOCKS, Block, Memory};
use crate::lanes::pass::Pass;
use crate::lanes::programs::{PassPrograms, Tracing, fixed, numbers};
use loosepin_mechanics::mechanism::{Arms, Mechanism, Sample};
use loosepin_tape::native::{BlockStart, Level, Routine, Sequence};
use std::ops::Range;

/// What is done with all lanes.
struct Sequences {
    prepare: Sequence,
    /// Numbers of a run with those that are prepared.
    numbers: usize,
    restart: Sequence,
    attempt: Sequence,
    /// Sequence for lanes in which the root of every closed contact is an unknown.
    attempt_by_roots: Sequence,
    accept: Sequence,
    close_account: Sequence,
    prepare_dense: Sequence,
    follow: Sequence,
    spread: Sequence,
    look: Sequence,
    inside: Sequence,
}

impl Sequences {
    fn new(programs: PassPrograms, pass: &Pass, level: Option<Level>, lanes: usize) -> Self {
        let numbers = programs.prepare.values_per_block().get(Block::Numbers as usize).copied().unwrap_or(0);
        let mut all = Vec::new();
        let programs = programs.map(|program| {
            all.push(program);
            all.len() - 1
        });
        let routines = Routine::all(all, level, lanes);
        let sequence = |calls: &[(usize, [BlockStart; BLOCKS])]| {
            let calls: Vec<_> = calls.iter().map(|(program, places)| (&routines[*program], &places[..])).collect();
            match Sequence::new(&calls) {
                Ok(sequence) => sequence,
                Err(error) => unreachable!("programs and places are of one layout: {error}"),
            }
        };
        let as_written = |program: usize| (program, BlockStart::ALL);
        // A program that gives a slope, with the point and the row of the slope that are meant.
        let slope = |program: usize, point: Block, row: usize| {
            let mut places = BlockStart::ALL;
            places[Block::Point as usize] = BlockStart { block: point as usize, first: 0 };
            places[Block::Stages as usize].first = row * pass.layout.length();
            (program, places)
        };
        let end_row = pass.stepper.end_row();
        let attempt = |slope_within: usize| {
            let mut calls = vec![as_written(programs.choose_step)];
            for (before, point) in programs.points.iter().enumerate() {
                calls.push(as_written(*point));
                calls.push(if before + 1 < programs.points.len() {
                    slope(slope_within, Block::Point, before + 1)
                } else {
                    slope(programs.end, Block::End, end_row)
                });
            }
            calls.push(as_written(programs.judgement));
            sequence(&calls)
        };
        let mut dense = Vec::new();
        for (before, point) in programs.dense_points.iter().enumerate() {
            dense.extend([as_written(*point), slope(programs.slope, Block::Point, end_row + 1 + before)]);
        }
        dense.push(as_written(programs.dense));
        let accept: Vec<_> =
            [Some(programs.accept), programs.hold_loops].into_iter().flatten().map(as_written).collect();
        let mut inside = Vec::new();
        if let Some(own) = &programs.inside {
            // The values at the state in a block, put down behind those of the points before.
            let values = |state: Block, point: usize| {
                let mut places = BlockStart::ALL;
                places[Block::Point as usize] = BlockStart { block: state as usize, first: 0 };
                places[Block::Stages as usize].first = pass.first_inside() + pass.follow.inside().value(point, 0);
                (own.values, places)
            };
            inside.push(values(Block::Start, 0));
            for (before, point) in own.points.iter().enumerate() {
                inside.extend([as_written(*point), values(Block::Point, before + 1)]);
            }
            inside.extend([values(Block::End, own.points.len() + 1), as_written(own.take)]);
        }
        let restart = [slope(programs.end, Block::Start, end_row), as_written(programs.take_evaluation)];
        Self {
            prepare: sequence(&[as_written(programs.prepare)]),
            numbers,
            restart: sequence(&restart),
            attempt: attempt(programs.slope),
            attempt_by_roots: attempt(programs.slope_by_roots.unwrap_or(programs.slope)),
            accept: sequence(&accept),
            close_account: sequence(&programs.account.map(as_written).into_iter().collect::<Vec<_>>()),
            prepare_dense: sequence(&dense),
            follow: sequence(&programs.follow.map(as_written).into_iter().collect::<Vec<_>>()),
            spread: sequence(&programs.spread.map(as_written).into_iter().collect::<Vec<_>>()),
            look: sequence(&programs.look.map(as_written).into_iter().collect::<Vec<_>>()),
            inside: sequence(&inside),
        }
    }
}

/// The pass of a mechanism over many lanes.
///
/// Numbers of a sample that are 0 or ±1 are taken into the programs, which leave out what they multiply; the bits stay the
/// same. A sample in which such a number differs has the programs written again without it.
pub struct Recorded<'a> {
    mechanism: &'a Mechanism,
    follow: Follow,
    level: Option<Level>,
    lanes: usize,
    /// So many of them are computed, the first ones.
    used: usize,
    lengths: [usize; BLOCKS],
    /// By number: the value that is in the programs.
    fixed: Vec<Option<f64>>,
    sequences: Sequences,
    scratch: Vec<f64>,
}

impl<'a> Recorded<'a> {
    /// Writes down `pass` for the numbers of `sample`: as machine code for `level`, or to be evaluated.
    pub fn new(
        mechanism: &'a Mechanism,
        sample: &Sample<f64>,
        arms: &Arms,
        follow: &Follow,
        pass: &Pass,
        lengths: [usize; BLOCKS],
        (level, lanes): (Option<Level>, usize),
    ) -> Self {
        let fixed = fixed(sample, arms);
        let programs = Tracing { mechanism, sample, arms, follow, fixed: &fixed, pass, lengths }.programs();
        Self {
            mechanism,
            follow: follow.clone(),
            level,
            lanes,
            used: lanes,
            lengths,
            fixed,
            sequences: Sequences::new(programs, pass, level, lanes),
            scratch: Vec::new(),
        }
    }

    /// Puts the numbers of a run into a lane.
    pub fn load(&mut self, pass: &Pass, memory: &mut Memory, lane: usize, sample: &Sample<f64>, arms: &Arms) {
        let values = numbers(sample, arms);
        let is_other = |(fixed, value): (&Option<f64>, &f64)| fixed.is_some_and(|fixed| fixed != *value);
        let is_rewritten = self.fixed.iter().zip(&values).any(is_other);
        if is_rewritten {
            for (fixed, value) in self.fixed.iter_mut().zip(&values) {
                *fixed = fixed.filter(|fixed| fixed == value);
            }
            let (mechanism, follow, fixed, lengths) = (self.mechanism, &self.follow, &self.fixed, self.lengths);
            let programs = Tracing { mechanism, sample, arms, follow, fixed, pass, lengths }.programs();
            self.sequences = Sequences::new(programs, pass, self.level, self.lanes);
        }
        memory.lengthen(Block::Numbers, self.sequences.numbers);
        for (index, value) in values.into_iter().enumerate() {
            memory.set(Block::Numbers, index, lane, value);
        }
        // Other programs put what they prepare elsewhere, for the runs at hand as well. Lanes that are prepared again have the same bits.
        let lanes = if is_rewritten { 0..self.lanes } else { lane..lane + 1 };
        run(&self.sequences.prepare, lanes, memory, &mut self.scratch);
    }

    /// Whether attempts are machine code.
    pub fn is_machine_code(&self) -> bool {
        self.sequences.attempt.is_machine_code()
    }

    /// Computes from now on in the first `used` lanes; the others have no run.
    pub fn use_lanes(&mut self, used: usize) {
        self.used = used;
    }

    /// Evaluates at the start of the step, in the chosen lanes, which are some of `lanes`.
    pub fn restart(&mut self, memory: &mut Memory, lanes: Range<usize>) {
        run(&self.sequences.restart, lanes, memory, &mut self.scratch);
    }

    /// Tries the steps; `reads_depths` where some closed contact has no root that is an unknown.
    pub fn attempt(&mut self, memory: &mut Memory, reads_depths: bool) {
        let Sequences { attempt, attempt_by_roots, .. } = &self.sequences;
        run(if reads_depths { attempt } else { attempt_by_roots }, 0..self.used, memory, &mut self.scratch);
    }

    /// Makes the end of the step the start of the next one and holds the loops of ideal joints, in the chosen lanes; or, where there are none,
    /// takes it into the energy account.
    pub fn accept(&mut self, memory: &mut Memory) {
        run(&self.sequences.accept, 0..self.used, memory, &mut self.scratch);
    }

    /// Takes the start of the step into the energy account, in the chosen lanes, where loops are held.
    pub fn close_account(&mut self, memory: &mut Memory) {
        run(&self.sequences.close_account, 0..self.used, memory, &mut self.scratch);
    }

    /// Follows the current step, in the chosen lanes.
    pub fn follow(&mut self, memory: &mut Memory) {
        run(&self.sequences.follow, 0..self.used, memory, &mut self.scratch);
    }

    /// Makes the readings over the current step polynomials, in all lanes.
    pub fn spread(&mut self, memory: &mut Memory) {
        run(&self.sequences.spread, 0..self.used, memory, &mut self.scratch);
    }

    /// Reads at the instants that wait in the first `places` of `memory`, one in each, of whatever step and run.
    pub fn look(&mut self, memory: &mut Memory, places: usize) {
        run(&self.sequences.look, 0..places, memory, &mut self.scratch);
    }

    /// Reads at an instant in each lane, within the current step.
    pub fn look_in_place(&mut self, memory: &mut Memory) {
        run(&self.sequences.look, 0..self.used, memory, &mut self.scratch);
    }

    /// Takes in the values inside the current step, whose dense output is known, in the chosen lanes.
    pub fn look_inside(&mut self, memory: &mut Memory) {
        run(&self.sequences.inside, 0..self.used, memory, &mut self.scratch);
    }

    /// Computes what looks inside of the current step need.
    pub fn prepare_dense(&mut self, memory: &mut Memory) {
        run(&self.sequences.prepare_dense, 0..self.used, memory, &mut self.scratch);
    }
}

/// Runs on these lanes of the blocks of `memory`, which have at least the lengths that the programs need.
fn run(sequence: &Sequence, lanes: Range<usize>, memory: &mut Memory, scratch: &mut Vec<f64>) {
    if let Err(error) = sequence.run_on(lanes, &mut memory.blocks(), scratch) {
        unreachable!("{error}");
    }
}

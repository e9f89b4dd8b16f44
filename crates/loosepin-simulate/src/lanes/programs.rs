//! The programs of a pass: the equations of a mechanism and the arithmetic of a step, evaluated once on
//! [`Traced`] numbers.

use crate::follow::{Follow, LOBATTO};
use crate::lanes::memory::{BLOCKS, Block, LaneLayout, MemoryBlocks};
use crate::lanes::pass::{Pass, play_state};
use crate::settings::Settings;
use crate::stepping::motion::Motion;
use crate::stepping::projection::Projection;
use loosepin_math::integrate::System;
use loosepin_math::{Numbers, Real};
use loosepin_mechanics::dynamics::DepthRoot;
use loosepin_mechanics::mechanism::{Arms, Mechanism, Sample};
use loosepin_tape::native::{Graph, Hoisted, NativeError, Program, Slot, Value};
use loosepin_tape::trace::{Traced, record};

/// Numbers of a lane that are said of an attempt.
const ATTEMPT_OUTPUTS: [usize; 11] = [
    LaneLayout::ERROR,
    LaneLayout::GROWTH,
    LaneLayout::EVENTFUL,
    LaneLayout::NOTABLE,
    LaneLayout::DEEP,
    LaneLayout::IS_DUE,
    LaneLayout::EVALUATIONS,
    LaneLayout::REJECTIONS,
    LaneLayout::ATTENTION,
    LaneLayout::CHOSEN,
    LaneLayout::TURN,
];

/// A pass as straight-line programs on the blocks of [`Block`]: what machine code is made of, to be counted and timed.
#[derive(Debug, Clone)]
pub struct PassPrograms<P = Program> {
    /// Computes the values that depend on the numbers of a run alone, behind them in [`Block::Numbers`]: runs whenever these numbers
    /// change.
    pub prepare: P,
    /// The slope of the state in [`Block::Point`], written to the first row of [`Block::Stages`]. Angles are near those in
    /// [`Block::StartReads`].
    pub slope: P,
    /// The same where the root of every closed contact is an unknown: no penetration is read off the positions. `None` if no root ever
    /// is.
    pub slope_by_roots: Option<P>,
    /// The slope, and the numbers read at an end of a step.
    pub end: P,
    /// The next step, by the attempt before.
    pub choose_step: P,
    /// The points of a step at which the slope is evaluated, one after the other; the last one is its end.
    pub points: Vec<P>,
    /// The error of a step, and what may have happened in it.
    pub judgement: P,
    /// The further points of the dense output.
    pub dense_points: Vec<P>,
    /// The dense output.
    pub dense: P,
    /// The last evaluation becomes that of the start of the step.
    pub take_evaluation: P,
    /// The end of the step becomes the start of the next one; with its energy account where no loops are held.
    pub accept: P,
    /// The state held on the loops of ideal joints, where there are any.
    pub hold_loops: Option<P>,
    /// The energy account of a step behind which loops are held.
    pub account: Option<P>,
    /// Follows a step, if anything is followed.
    pub follow: Option<P>,
    /// Readings over a step as polynomials, where there are any.
    pub spread: Option<P>,
    /// Readings at an instant within a step, where there are any.
    pub look: Option<P>,
    /// Values inside a step, where any are reduced.
    pub inside: Option<InsidePrograms<P>>,
}

/// Values inside a step.
#[derive(Debug, Clone)]
pub struct InsidePrograms<P = Program> {
    /// The states at the points that are no ends, in [`Block::Point`].
    pub points: Vec<P>,
    /// The values at the state in [`Block::Point`], written to the first numbers of [`Block::Stages`].
    pub values: P,
    /// Extremes and integrals of the values.
    pub take: P,
}

impl PassPrograms {
    /// Writes down what a batch does for runs of `mechanism` with the laws of `sample`. Numbers that are 0 or ±1 are taken into the
    /// programs.
    pub fn new(mechanism: &Mechanism, sample: &Sample<f64>, arms: &Arms, follow: &Follow, settings: &Settings) -> Self {
        let pass = Pass::new(mechanism, sample, follow, settings);
        let fixed = fixed(sample, arms);
        let lengths = pass.block_lengths(fixed.len());
        Tracing { mechanism, sample, arms, follow, fixed: &fixed, pass: &pass, lengths }.programs()
    }

    /// Applies `make` to each program, those of a step first.
    pub(crate) fn map<Q>(self, mut make: impl FnMut(Program) -> Q) -> PassPrograms<Q> {
        PassPrograms {
            prepare: make(self.prepare),
            choose_step: make(self.choose_step),
            points: self.points.into_iter().map(&mut make).collect(),
            slope: make(self.slope),
            slope_by_roots: self.slope_by_roots.map(&mut make),
            end: make(self.end),
            judgement: make(self.judgement),
            accept: make(self.accept),
            hold_loops: self.hold_loops.map(&mut make),
            take_evaluation: make(self.take_evaluation),
            account: self.account.map(&mut make),
            follow: self.follow.map(&mut make),
            spread: self.spread.map(&mut make),
            look: self.look.map(&mut make),
            dense_points: self.dense_points.into_iter().map(&mut make).collect(),
            dense: make(self.dense),
            inside: self.inside.map(|inside| InsidePrograms {
                points: inside.points.into_iter().map(&mut make).collect(),
                values: make(inside.values),
                take: make(inside.take),
            }),
        }
    }
}

/// All numbers that the programs may read: those of the sample, then the points of the bodies.
pub fn numbers(sample: &Sample<f64>, arms: &Arms) -> Vec<f64> {
    let mut numbers = sample.numbers();
    numbers.extend(arms.numbers());
    numbers
}

/// By number: its value where the programs are to know it.
pub fn fixed(sample: &Sample<f64>, arms: &Arms) -> Vec<Option<f64>> {
    numbers(sample, arms).into_iter().map(|value| (value == 0.0 || value.abs() == 1.0).then_some(value)).collect()
}

/// Source of the programs.
pub struct Tracing<'t> {
    /// The mechanism.
    pub mechanism: &'t Mechanism,
    /// Its numbers; laws and exponents are taken from here.
    pub sample: &'t Sample<f64>,
    /// Positions of the points of bodies.
    pub arms: &'t Arms,
    /// Readings at the ends of steps, and followed quantities.
    pub follow: &'t Follow,
    /// By number of [`Block::Numbers`]: its value where the programs are to know it.
    pub fixed: &'t [Option<f64>],
    /// The arithmetic.
    pub pass: &'t Pass,
    /// How many numbers a lane has in each block.
    pub lengths: [usize; BLOCKS],
}

impl Tracing<'_> {
    /// Writes all programs down.
    pub fn programs(&self) -> PassPrograms {
        let hoisted = &mut Hoisted::new(Block::Numbers as u8, self.fixed.len());
        let slope = self.equations(hoisted, Evaluated { is_end: false, reads_depths: true });
        let end = self.equations(hoisted, Evaluated { is_end: true, reads_depths: true });
        let has_roots = self.pass.layout.roots.iter().any(Option::is_some);
        let has_readings = self.pass.follow.readings() > 0;
        let slope_by_roots =
            has_roots.then(|| self.equations(hoisted, Evaluated { is_end: false, reads_depths: false }));
        let (points, judgement) = self.attempt(hoisted);
        let (dense_points, dense) = self.dense(hoisted);
        let holds_loops = Projection::<Traced>::is_needed(self.mechanism);
        let hold_loops = holds_loops.then(|| {
            self.written(hoisted, |blocks| {
                let (mut motion, _) = self.motion(true);
                self.pass.hold_loops(blocks, &mut motion, &mut Projection::new(self.mechanism));
            })
        });
        PassPrograms {
            slope,
            slope_by_roots,
            end,
            choose_step: self.written(hoisted, |blocks| self.pass.choose_step(blocks)),
            points,
            judgement,
            dense_points,
            dense,
            take_evaluation: self.written(hoisted, |blocks| self.pass.take_evaluation(blocks)),
            accept: self.written(hoisted, |blocks| {
                self.pass.accept(blocks);
                if !holds_loops {
                    self.pass.close_account(blocks);
                }
            }),
            hold_loops,
            account: holds_loops.then(|| self.written(hoisted, |blocks| self.pass.close_account(blocks))),
            follow: self.pass.follow.reduces().then(|| self.written(hoisted, |blocks| self.pass.follow(blocks))),
            spread: has_readings.then(|| self.written(hoisted, |blocks| self.pass.spread(blocks))),
            look: has_readings.then(|| self.written(hoisted, |blocks| self.pass.look(blocks))),
            inside: (self.pass.follow.inside().count > 0).then(|| self.inside(hoisted)),
            prepare: with_own_slots(hoisted.own_program()),
        }
    }

    /// The slope of the state in [`Block::Point`], and the reads of an end of a step.
    fn equations(&self, hoisted: &mut Hoisted, evaluated: Evaluated) -> Program {
        let (graph, outputs) = record(|| {
            let (mut motion, arms) = self.motion(evaluated.reads_depths);
            let mut memory = self.inputs();
            let [_, _, _, slope, point, _, start_reads, reads] = &mut memory;
            slope.fill(Traced::zero());
            motion.set_known_angles(&self.pass.reads, start_reads);
            motion.set_near(!evaluated.is_end);
            motion.derivative(point, slope);
            let mut outputs = outputs(Block::Stages, &slope[..self.pass.layout.length()]);
            if evaluated.is_end {
                motion.read(&self.follow.readings, &arms, reads);
                outputs.extend(self::outputs(Block::EndReads, reads));
            }
            outputs
        });
        program(hoisted, &graph, &outputs)
    }

    /// The points of a step, and what is said of it.
    fn attempt(&self, hoisted: &mut Hoisted) -> (Vec<Program>, Program) {
        let (graph, (points, judgement)) = record(|| {
            let (sample, _) = self.numbers();
            let mut memory = self.inputs();
            let mut blocks = MemoryBlocks::new(memory.each_mut().map(|block| &mut block[..]));
            let mut points = Points::default();
            self.pass.attempt(&mut blocks.rows, blocks.lane, &mut points);
            self.pass.limit_turns(&mut blocks);
            self.pass.judge_attempt(&sample, &mut blocks);
            let places = ATTEMPT_OUTPUTS.map(|place| (slot(Block::Lane, place), blocks.lane[place].value()));
            (points.0, places)
        });
        (points.iter().map(|point| program(hoisted, &graph, point)).collect(), program(hoisted, &graph, &judgement))
    }

    /// The further points of the dense output, and the dense output.
    fn dense(&self, hoisted: &mut Hoisted) -> (Vec<Program>, Program) {
        let (graph, (points, dense)) = record(|| {
            let mut memory = self.inputs();
            let mut points = Points::default();
            let MemoryBlocks { lane, mut rows, .. } = MemoryBlocks::new(memory.each_mut().map(|block| &mut block[..]));
            self.pass.prepare_dense(&mut rows, lane, &mut points);
            (points.0, changes(&memory, &self.inputs()))
        });
        (points.iter().map(|point| program(hoisted, &graph, point)).collect(), program(hoisted, &graph, &dense))
    }

    /// Values inside a step.
    fn inside(&self, hoisted: &mut Hoisted) -> InsidePrograms {
        let holds = Projection::<Traced>::is_needed(self.mechanism);
        let state = |point: usize| {
            let (graph, outputs) = record(|| {
                let mut memory = self.inputs();
                let mut state = vec![Traced::zero(); self.pass.layout.dimension];
                let MemoryBlocks { rows, .. } = MemoryBlocks::new(memory.each_mut().map(|block| &mut block[..]));
                self.pass.state_inside(&rows, point, &mut state);
                if holds {
                    let (mut motion, _) = self.motion(true);
                    let time_s = state[self.pass.layout.time()];
                    Projection::new(self.mechanism).hold(&mut motion, time_s, &mut state);
                }
                outputs(Block::Point, &state)
            });
            (graph, outputs)
        };
        let points = (1..LOBATTO.len() - 1).map(state).collect::<Vec<_>>();
        let (graph, outputs) = record(|| {
            let (mut motion, arms) = self.motion(true);
            let [_, _, _, _, point, ..] = &self.inputs();
            motion.evaluate(point[self.pass.layout.time()], point);
            let values: Vec<Traced> =
                self.follow.inside.iter().map(|reading| reading.value(&arms, &motion.dynamics)).collect();
            outputs(Block::Stages, &values)
        });
        InsidePrograms {
            points: points.iter().map(|(graph, outputs)| program(hoisted, graph, outputs)).collect(),
            values: program(hoisted, &graph, &outputs),
            take: self.written(hoisted, |blocks| self.pass.take_inside(blocks)),
        }
    }

    /// The program of the operations of `work` on the blocks.
    fn written(&self, hoisted: &mut Hoisted, work: impl FnOnce(&mut MemoryBlocks<'_, Traced>)) -> Program {
        let (graph, outputs) = record(|| {
            let mut memory = self.inputs();
            work(&mut MemoryBlocks::new(memory.each_mut().map(|block| &mut block[..])));
            changes(&memory, &self.inputs())
        });
        program(hoisted, &graph, &outputs)
    }

    /// All blocks before a program runs.
    fn inputs(&self) -> [Vec<Traced>; BLOCKS] {
        let mut block = 0;
        self.lengths.map(|length| {
            block += 1;
            (0..length).map(|index| Traced::input(Slot { block: block - 1, index: index as u32 })).collect()
        })
    }

    /// The numbers of the sample and of the points as inputs.
    fn numbers(&self) -> (Sample<Traced>, Arms<Traced>) {
        let mut index = 0;
        let mut next = |number: &mut Traced| {
            *number = match self.fixed[index] {
                Some(value) => Traced::from_f64(value),
                None => Traced::input(slot(Block::Numbers, index)),
            };
            index += 1;
        };
        let mut sample = Sample::broadcast(self.sample);
        sample.visit(&mut next);
        let mut arms = Arms::broadcast(self.arms);
        arms.visit(&mut next);
        (sample, arms)
    }

    /// The equations with their numbers and contacts as inputs; and the points of the bodies. Penetrations may be read off the positions
    /// where it `reads_depths`.
    fn motion(&self, reads_depths: bool) -> (Motion<'_, Traced>, Arms<Traced>) {
        let (sample, arms) = self.numbers();
        let mut motion = Motion::new(self.mechanism, &sample);
        for (contact, (state, unknowns)) in motion.states.iter_mut().zip(&mut motion.unknowns).enumerate() {
            let place = LaneLayout::contact(contact);
            let of_lane: Vec<Traced> =
                (0..=LaneLayout::HAS_ROOT).map(|k| Traced::input(slot(Block::Lane, place + k))).collect();
            *state = play_state(&of_lane);
            if let Some(root) = &mut unknowns.root {
                *root = DepthRoot { is_unknown: of_lane[LaneLayout::HAS_ROOT], may_be_read: reads_depths, ..*root };
            }
        }
        (motion, arms)
    }
}

/// What an evaluation of the equations gives.
#[derive(Debug, Clone, Copy)]
struct Evaluated {
    /// At an end of a step: the numbers read there, too, and angles without those at its start.
    is_end: bool,
    /// Forces of contacts that may have a root and have none now, too.
    reads_depths: bool,
}

/// Notes the points at which slopes are asked for. Those are computed by a program of their own and are inputs here.
#[derive(Default)]
struct Points(Vec<Vec<(Slot, Value)>>);

impl System<Traced> for Points {
    fn derivative(&mut self, state: &[Traced], _slope: &mut [Traced]) {
        self.0.push(outputs(Block::Point, state));
    }

    fn derivative_at_end(&mut self, state: &[Traced], _slope: &mut [Traced]) {
        self.0.push(outputs(Block::End, state));
    }
}

fn slot(block: Block, index: usize) -> Slot {
    Slot { block: block as u8, index: index as u32 }
}

fn outputs(block: Block, values: &[Traced]) -> Vec<(Slot, Value)> {
    values.iter().enumerate().map(|(index, value)| (slot(block, index), value.value())).collect()
}

/// All numbers of `memory` that are not what they were.
fn changes(memory: &[Vec<Traced>; BLOCKS], inputs: &[Vec<Traced>; BLOCKS]) -> Vec<(Slot, Value)> {
    let mut changes = Vec::new();
    for (block, (numbers, inputs)) in memory.iter().zip(inputs).enumerate() {
        for (index, (number, input)) in numbers.iter().zip(inputs).enumerate() {
            if number.value() != input.value() {
                changes.push((Slot { block: block as u8, index: index as u32 }, number.value()));
            }
        }
    }
    changes
}

fn program(hoisted: &mut Hoisted, graph: &Graph, outputs: &[(Slot, Value)]) -> Program {
    with_own_slots(hoisted.program(graph, outputs))
}

fn with_own_slots(program: Result<Program, NativeError>) -> Program {
    match program {
        Ok(program) => program,
        Err(error) => unreachable!("each output has its own slot: {error}"),
    }
}

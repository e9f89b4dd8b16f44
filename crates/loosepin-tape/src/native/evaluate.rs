//! Running a program without machine code: each operation for several lanes, then the next one.

use super::error::NativeError;
use super::node::{BinaryOperation, FusedSigns, Node, NodeIndex, Slot, UnaryOperation};
use super::program::Program;
use loosepin_math::with_vector_instructions;
use std::cell::Cell;

/// Lanes of a vector of numbers that the compiler makes instructions for.
const WIDTH: usize = 8;
/// Vectors that are done together, so that looking up an operation is paid once for all of them.
const VECTORS: usize = 4;

impl Program {
    /// Runs the program on plain `f64` numbers, with the same bits as machine code. What runs often goes into a
    /// [`super::Sequence`].
    ///
    /// # Errors
    ///
    /// [`NativeError::TooFewBlocks`] and [`NativeError::BlockTooShort`].
    pub fn evaluate(&self, lanes: usize, blocks: &mut [&mut [f64]]) -> Result<(), NativeError> {
        Interpreted::new(self).run(lanes, blocks, &mut Vec::new())
    }
}

/// A program ready to be evaluated. Results whose last reader is past give their row to later ones, so that all rows stay in the
/// nearest cache.
#[derive(Debug, Clone)]
pub(super) struct Interpreted {
    steps: Vec<Step>,
    outputs: Vec<(Slot, NodeIndex)>,
    values_per_block: Vec<usize>,
    rows: usize,
}

/// One operation; its operands are rows.
#[derive(Debug, Clone, Copy)]
struct Step {
    node: Node,
    row: NodeIndex,
}

impl Interpreted {
    /// Of `program`.
    pub fn new(program: &Program) -> Self {
        let nodes = program.nodes();
        let mut last_use: Vec<usize> = (0..nodes.len()).collect();
        for (index, node) in nodes.iter().enumerate() {
            for operand in node.operands() {
                last_use[operand as usize] = index;
            }
        }
        for &(_, node) in program.outputs() {
            last_use[node as usize] = usize::MAX;
        }
        let (mut row_of, mut free, mut rows) = (vec![0; nodes.len()], Vec::new(), 0);
        let mut steps = Vec::with_capacity(nodes.len());
        for (index, node) in nodes.iter().enumerate() {
            let renumbered = node.renumbered(|operand| row_of[operand as usize]);
            for operand in node.operands() {
                if last_use[operand as usize] == index {
                    // An operand that is named twice is given back once.
                    last_use[operand as usize] = usize::MAX;
                    free.push(row_of[operand as usize]);
                }
            }
            let row = free.pop().unwrap_or_else(|| {
                rows += 1;
                rows - 1
            });
            row_of[index] = row;
            steps.push(Step { node: renumbered, row });
        }
        Self {
            steps,
            outputs: program.outputs().iter().map(|&(slot, node)| (slot, row_of[node as usize])).collect(),
            values_per_block: program.values_per_block().to_vec(),
            rows: rows as usize,
        }
    }

    /// Runs on plain `f64` numbers, with the same bits as machine code (except for the bits of NaN). `scratch` is work space, which grows
    /// to what is needed and can be used again.
    ///
    /// # Errors
    ///
    /// [`NativeError::TooFewBlocks`] and [`NativeError::BlockTooShort`].
    pub fn run(&self, lanes: usize, blocks: &mut [&mut [f64]], scratch: &mut Vec<f64>) -> Result<(), NativeError> {
        check_blocks(blocks, &self.values_per_block, lanes)?;
        let needed = self.rows * WIDTH * VECTORS;
        if scratch.len() < needed {
            scratch.resize(needed, 0.0);
        }
        with_vector_instructions(
            #[inline(always)]
            || {
                let mut lane = 0;
                while lane + WIDTH * VECTORS <= lanes {
                    self.run_lanes::<WIDTH, VECTORS>(lane, lanes, blocks, scratch);
                    lane += WIDTH * VECTORS;
                }
                while lane + WIDTH <= lanes {
                    self.run_lanes::<WIDTH, 1>(lane, lanes, blocks, scratch);
                    lane += WIDTH;
                }
                for lane in lane..lanes {
                    self.run_lanes::<1, 1>(lane, lanes, blocks, scratch);
                }
            },
        );
        Ok(())
    }

    /// Runs for `C` vectors of `W` lanes from lane `first` on.
    #[inline(always)]
    fn run_lanes<const W: usize, const C: usize>(
        &self,
        first: usize,
        lanes: usize,
        blocks: &mut [&mut [f64]],
        scratch: &mut [f64],
    ) {
        let rows = Cell::from_mut(scratch.as_chunks_mut::<W>().0).as_slice_of_cells().as_chunks::<C>().0;
        let place = |slot: Slot| slot.index as usize * lanes + first;
        for step in &self.steps {
            let result = &rows[step.row as usize];
            match step.node {
                Node::Input(slot) => {
                    let numbers = blocks[usize::from(slot.block)][place(slot)..][..W * C].as_chunks::<W>().0;
                    for (result, numbers) in result.iter().zip(numbers) {
                        result.set(*numbers);
                    }
                }
                node => operate(node, rows, result),
            }
        }
        for &(slot, row) in &self.outputs {
            let numbers = blocks[usize::from(slot.block)][place(slot)..][..W * C].as_chunks_mut::<W>().0;
            for (number, result) in numbers.iter_mut().zip(&rows[row as usize]) {
                *number = result.get();
            }
        }
    }
}

/// Refuses too few or too short `blocks` for `values` values of `lanes` lanes.
pub(super) fn check_blocks(blocks: &[&mut [f64]], values: &[usize], lanes: usize) -> Result<(), NativeError> {
    if blocks.len() < values.len() {
        return Err(NativeError::TooFewBlocks { given: blocks.len(), needed: values.len() });
    }
    for (block, (numbers, values)) in blocks.iter().zip(values).enumerate() {
        if numbers.len() < values * lanes {
            return Err(NativeError::BlockTooShort { block, given: numbers.len(), needed: values * lanes });
        }
    }
    Ok(())
}

/// A row: the result of an operation in `C` vectors of `W` lanes.
type LaneValues<const W: usize, const C: usize> = [Cell<[f64; W]>; C];

/// Writes the result of a node that is no input from the rows of its operands; a mask is 1 where it holds, else 0. Every arm is a
/// loop of its own over the lanes, which the compiler turns into vector instructions.
#[inline(always)]
fn operate<const W: usize, const C: usize>(node: Node, rows: &[LaneValues<W, C>], result: &LaneValues<W, C>) {
    let value = |row: NodeIndex| &rows[row as usize];
    match node {
        Node::Input(_) => {}
        Node::Constant(bits) => fill(result, f64::from_bits(bits)),
        Node::Unary { operation, operand } => {
            let operand = value(operand);
            match operation {
                UnaryOperation::Negate => one(result, operand, |number| -number),
                UnaryOperation::Absolute => one(result, operand, f64::abs),
                UnaryOperation::SquareRoot => one(result, operand, f64::sqrt),
            }
        }
        Node::Binary { operation, left, right } => {
            let operands = [value(left), value(right)];
            match operation {
                BinaryOperation::Add => two(result, operands, |left, right| left + right),
                BinaryOperation::Subtract => two(result, operands, |left, right| left - right),
                BinaryOperation::Multiply => two(result, operands, |left, right| left * right),
                BinaryOperation::Divide => two(result, operands, |left, right| left / right),
                BinaryOperation::Minimum => {
                    two(result, operands, |left, right| if left < right { left } else { right })
                }
                BinaryOperation::Maximum => {
                    two(result, operands, |left, right| if left > right { left } else { right })
                }
            }
        }
        Node::MulAdd { first, second, addend, signs } => {
            let operands = [value(first), value(second), value(addend)];
            let FusedSigns { negates_product, negates_addend } = signs;
            match (negates_product, negates_addend) {
                (false, false) => three(result, operands, |a, b, c| a.mul_add(b, c)),
                (false, true) => three(result, operands, |a, b, c| a.mul_add(b, -c)),
                (true, false) => three(result, operands, |a, b, c| (-a).mul_add(b, c)),
                (true, true) => three(result, operands, |a, b, c| (-a).mul_add(b, -c)),
            }
        }
        Node::LessThan { left, right, is_negated } => {
            let operands = [value(left), value(right)];
            if is_negated {
                two(result, operands, |left, right| if left < right { 0.0 } else { 1.0 });
            } else {
                two(result, operands, |left, right| if left < right { 1.0 } else { 0.0 });
            }
        }
        Node::Always(answer) => fill(result, f64::from(u8::from(answer))),
        Node::MaskNot { mask } => one(result, value(mask), |holds| 1.0 - holds),
        Node::Select { mask, chosen, otherwise } => {
            let operands = [value(mask), value(chosen), value(otherwise)];
            three(result, operands, |mask, chosen, otherwise| if mask != 0.0 { chosen } else { otherwise });
        }
    }
}

#[inline(always)]
fn fill<const W: usize, const C: usize>(result: &LaneValues<W, C>, number: f64) {
    for result in result {
        result.set([number; W]);
    }
}

#[inline(always)]
fn one<const W: usize, const C: usize>(
    result: &LaneValues<W, C>,
    operand: &LaneValues<W, C>,
    operation: impl Fn(f64) -> f64,
) {
    for vector in 0..C {
        let mut numbers = operand[vector].get();
        for number in &mut numbers {
            *number = operation(*number);
        }
        result[vector].set(numbers);
    }
}

#[inline(always)]
fn two<const W: usize, const C: usize>(
    result: &LaneValues<W, C>,
    [left, right]: [&LaneValues<W, C>; 2],
    operation: impl Fn(f64, f64) -> f64,
) {
    for vector in 0..C {
        let (left, right) = (left[vector].get(), right[vector].get());
        let mut numbers = [0.0; W];
        for lane in 0..W {
            numbers[lane] = operation(left[lane], right[lane]);
        }
        result[vector].set(numbers);
    }
}

#[inline(always)]
fn three<const W: usize, const C: usize>(
    result: &LaneValues<W, C>,
    [first, second, third]: [&LaneValues<W, C>; 3],
    operation: impl Fn(f64, f64, f64) -> f64,
) {
    for vector in 0..C {
        let (first, second, third) = (first[vector].get(), second[vector].get(), third[vector].get());
        let mut numbers = [0.0; W];
        for lane in 0..W {
            numbers[lane] = operation(first[lane], second[lane], third[lane]);
        }
        result[vector].set(numbers);
    }
}

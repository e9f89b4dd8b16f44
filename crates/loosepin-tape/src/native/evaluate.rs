//! Running a program without machine code: each operation for several lanes, then the next one.

use super::error::NativeError;
use super::node::{BinaryOperation, FusedSigns, MaskOperation, Node, NodeIndex, Slot, UnaryOperation};
use super::program::Program;
use loosepin_math::on_vectors;

/// Lanes that are done together, so that looking up an operation is paid once for all of them.
const LANES_AT_ONCE: usize = 8;

impl Program {
    /// Runs the program on plain `f64` numbers, with the same bits as machine code (except for which of the numbers
    /// "not a number" a result is). `scratch` is work space, which grows to what is needed and can be used again.
    ///
    /// # Errors
    ///
    /// [`NativeError::TooFewBlocks`] and [`NativeError::BlockTooShort`].
    pub fn evaluate(&self, lanes: usize, blocks: &mut [&mut [f64]], scratch: &mut Vec<f64>) -> Result<(), NativeError> {
        let needed = self.values_per_block();
        if blocks.len() < needed.len() {
            return Err(NativeError::TooFewBlocks { given: blocks.len(), needed: needed.len() });
        }
        for (block, (numbers, &values)) in blocks.iter().zip(needed).enumerate() {
            check_length(block, numbers, values, lanes)?;
        }
        on_vectors(
            #[inline(always)]
            || {
                let mut lane = 0;
                while lane + LANES_AT_ONCE <= lanes {
                    self.evaluate_lanes::<LANES_AT_ONCE>(lane, lanes, blocks, scratch);
                    lane += LANES_AT_ONCE;
                }
                for lane in lane..lanes {
                    self.evaluate_lanes::<1>(lane, lanes, blocks, scratch);
                }
            },
        );
        Ok(())
    }

    /// Runs the program for `N` lanes from `first` on.
    #[inline(always)]
    fn evaluate_lanes<const N: usize>(
        &self,
        first: usize,
        lanes: usize,
        blocks: &mut [&mut [f64]],
        scratch: &mut Vec<f64>,
    ) {
        scratch.resize(self.nodes().len() * N, 0.0);
        let (values, _) = scratch.as_chunks_mut::<N>();
        let place = |slot: Slot| slot.index as usize * lanes + first;
        for (index, node) in self.nodes().iter().enumerate() {
            let (earlier, rest) = values.split_at_mut(index);
            match *node {
                Node::Input(slot) => rest[0].copy_from_slice(&blocks[usize::from(slot.block)][place(slot)..][..N]),
                _ => evaluate_node(*node, earlier, &mut rest[0]),
            }
        }
        for &(slot, node) in self.outputs() {
            let from = place(slot);
            blocks[usize::from(slot.block)][from..from + N].copy_from_slice(&values[node as usize]);
        }
    }
}

/// Refuses `numbers` that are fewer than `values` of so many `lanes`.
pub(super) fn check_length(block: usize, numbers: &[f64], values: usize, lanes: usize) -> Result<(), NativeError> {
    if numbers.len() < values * lanes {
        return Err(NativeError::BlockTooShort { block, given: numbers.len(), needed: values * lanes });
    }
    Ok(())
}

/// Writes the result of a node that is no input, from those of the nodes before; a mask is 1 where it holds, else 0. Every arm
/// is a loop of its own over the lanes, which the compiler turns into vector instructions.
#[inline(always)]
fn evaluate_node<const N: usize>(node: Node, values: &[[f64; N]], result: &mut [f64; N]) {
    let value = |index: NodeIndex| &values[index as usize];
    match node {
        Node::Input(_) => {}
        Node::Constant(bits) => *result = [f64::from_bits(bits); N],
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
        Node::Always(answer) => *result = [f64::from(u8::from(answer)); N],
        Node::MaskBinary { operation, left, right } => {
            let operands = [value(left), value(right)];
            match operation {
                MaskOperation::And => two(result, operands, |left, right| left * right),
                MaskOperation::Or => two(result, operands, |left, right| if left > right { left } else { right }),
            }
        }
        Node::MaskNot { mask } => one(result, value(mask), |holds| 1.0 - holds),
        Node::Select { mask, chosen, otherwise } => {
            let operands = [value(mask), value(chosen), value(otherwise)];
            three(result, operands, |mask, chosen, otherwise| if mask != 0.0 { chosen } else { otherwise });
        }
    }
}

#[inline(always)]
fn one<const N: usize>(result: &mut [f64; N], operand: &[f64; N], operation: impl Fn(f64) -> f64) {
    for lane in 0..N {
        result[lane] = operation(operand[lane]);
    }
}

#[inline(always)]
fn two<const N: usize>(result: &mut [f64; N], [left, right]: [&[f64; N]; 2], operation: impl Fn(f64, f64) -> f64) {
    for lane in 0..N {
        result[lane] = operation(left[lane], right[lane]);
    }
}

#[inline(always)]
fn three<const N: usize>(
    result: &mut [f64; N],
    [first, second, third]: [&[f64; N]; 3],
    operation: impl Fn(f64, f64, f64) -> f64,
) {
    for lane in 0..N {
        result[lane] = operation(first[lane], second[lane], third[lane]);
    }
}

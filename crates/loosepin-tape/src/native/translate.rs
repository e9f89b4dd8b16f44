//! From a program to bytes: the phases of the compiler, one after another.

use super::allocate::allocate;
use super::assemble::{Code, Layout, assemble};
use super::error::NativeError;
use super::instruction::{Instruction, Memory};
use super::lower::lower;
use super::program::Program;
use super::schedule::schedule;
use super::{Level, MAX_BLOCKS, MAX_FRAME_BYTES, MAX_LANES};

/// Parts of the machine code of a kernel.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct KernelSize {
    /// Vectors that are computed side by side, 1 or 2.
    pub interleaved: usize,
    /// How often the instructions run in one call.
    pub trips: usize,
    /// Vector instructions of one trip, including all below.
    pub instructions: usize,
    /// Of these: loads; most operands are read by the instruction that needs them and are not counted here.
    pub loads: usize,
    /// Of these: instructions other than loads that read their last operand from memory.
    pub reading: usize,
    /// Of these: stores of outputs.
    pub stores: usize,
    /// Of these: stores of results that found no register.
    pub spills: usize,
    /// Of these: copies from register to register.
    pub copies: usize,
    /// Bytes of code and constants.
    pub bytes: usize,
}

/// Reciprocal of the share of extra instructions below which two vectors go side by side.
///
/// Measured on Zen 5, one vector fills gaps of the other and gains 3 to 12 %; what does not fit into the registers loses
/// more than that from about one added instruction in six on.
const INTERLEAVING_DIVISOR: usize = 8;

/// Machine code for `program` on blocks of `lanes` lanes, with two vectors side by side or one, whichever promises more.
pub(super) fn translate(program: &Program, level: Level, lanes: usize) -> Result<(Code, KernelSize), NativeError> {
    let one = translate_interleaved(program, level, lanes, 1)?;
    if !(lanes / level.vector_lanes()).is_multiple_of(2) {
        return Ok(one);
    }
    let is_worth = |size: &KernelSize| {
        let added = size.instructions.saturating_sub(2 * one.1.instructions);
        added * INTERLEAVING_DIVISOR <= 2 * one.1.instructions
    };
    match translate_interleaved(program, level, lanes, 2) {
        Ok(two) if is_worth(&two.1) => Ok(two),
        _ => Ok(one),
    }
}

/// Machine code with `interleaved` vectors side by side, which must divide those of the lanes.
pub(super) fn translate_interleaved(
    program: &Program,
    level: Level,
    lanes: usize,
    interleaved: usize,
) -> Result<(Code, KernelSize), NativeError> {
    if lanes == 0 || lanes > MAX_LANES || !lanes.is_multiple_of(level.vector_lanes()) {
        return Err(NativeError::UnevenLanes { lanes, level });
    }
    let values_per_block = program.values_per_block();
    if values_per_block.len() > MAX_BLOCKS {
        return Err(NativeError::TooManyBlocks { given: values_per_block.len() });
    }
    for (block, &values) in values_per_block.iter().enumerate() {
        if values.saturating_mul(lanes * size_of::<f64>()) > i32::MAX as usize {
            return Err(NativeError::BlockTooLarge { block, values, lanes });
        }
    }
    let order = schedule(program, level);
    let lowered = lower(program, &order, level, lanes, interleaved);
    let allocated = allocate(&lowered, level);
    let frame_bytes = allocated.frame_vectors as usize * level.vector_bytes();
    if frame_bytes > MAX_FRAME_BYTES {
        return Err(NativeError::FrameTooLarge { bytes: frame_bytes });
    }
    let layout = Layout {
        level,
        blocks: values_per_block.len(),
        trips: lanes / level.vector_lanes() / interleaved,
        step_bytes: interleaved * level.vector_bytes(),
    };
    let code = assemble(&allocated, &lowered.constants, layout);
    let count = |is_meant: fn(&Instruction) -> bool| allocated.instructions.iter().filter(|one| is_meant(one)).count();
    let size = KernelSize {
        interleaved,
        trips: layout.trips,
        instructions: allocated.instructions.len(),
        loads: count(|one| matches!(one, Instruction::Load { .. } | Instruction::MaskLoad { .. })),
        reading: count(Instruction::reads_memory),
        stores: count(|one| matches!(one, Instruction::Store { to: Memory::Slot { .. }, .. })),
        spills: count(|one| {
            matches!(one, Instruction::Store { to: Memory::Spill(_), .. } | Instruction::MaskStore { .. })
        }),
        copies: count(|one| matches!(one, Instruction::Move { .. })),
        bytes: code.bytes().len(),
    };
    Ok((code, size))
}

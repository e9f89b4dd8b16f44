//! Instructions on registers and memory, before they become bytes.

use super::node::{BinaryOperation, FusedSigns};

/// The number of a vector register: 0 to 15 for AVX2, 0 to 31 for AVX-512.
pub(super) type VectorRegister = u8;

/// The number of the register of a mask: k1 to k7 for AVX-512, a vector register for AVX2.
pub(super) type MaskRegister = u8;

/// Location of a whole vector.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Memory {
    /// In a block of the caller.
    Slot { block: u8, offset_bytes: i32 },
    /// A constant for all lanes, behind the code.
    Constant(u32),
    /// In the stack frame of the kernel, counted in vectors.
    Spill(u32),
}

/// Last operand of an instruction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Operand {
    Register(VectorRegister),
    Memory(Memory),
}

/// Operations `to = left op right`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Arithmetic {
    Binary(BinaryOperation),
    /// All bits of both.
    And,
    /// The bits in which the two differ.
    ExclusiveOr,
}

impl Arithmetic {
    pub fn is_commutative(self) -> bool {
        match self {
            Self::Binary(operation) => operation.is_commutative(),
            Self::And | Self::ExclusiveOr => true,
        }
    }
}

/// Which of its three operands a fused multiply-add overwrites, in the processor's numbering.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FusedForm {
    /// `accumulator = accumulator · third + second`.
    Form132,
    /// `accumulator = second · accumulator + third`.
    Form213,
    /// `accumulator = second · third + accumulator`.
    Form231,
}

/// Predicate of a comparison; all answers are without exceptions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Predicate {
    Less,
    NotLess,
    Greater,
    NotGreater,
}

/// One instruction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Instruction {
    Load {
        to: VectorRegister,
        from: Memory,
    },
    Store {
        from: VectorRegister,
        to: Memory,
    },
    Move {
        to: VectorRegister,
        from: VectorRegister,
    },
    Arithmetic {
        operation: Arithmetic,
        to: VectorRegister,
        left: VectorRegister,
        right: Operand,
    },
    SquareRoot {
        to: VectorRegister,
        from: Operand,
    },
    MulAdd {
        form: FusedForm,
        signs: FusedSigns,
        accumulator: VectorRegister,
        second: VectorRegister,
        third: Operand,
    },
    Compare {
        predicate: Predicate,
        to: MaskRegister,
        left: VectorRegister,
        right: Operand,
    },
    /// `to = chosen` where the mask holds, else `otherwise`.
    Blend {
        to: VectorRegister,
        mask: MaskRegister,
        otherwise: VectorRegister,
        chosen: Operand,
    },
    /// AVX-512 alone.
    MaskNot {
        to: MaskRegister,
        from: MaskRegister,
    },
    /// AVX-512 alone.
    MaskLoad {
        to: MaskRegister,
        from: Memory,
    },
    /// AVX-512 alone.
    MaskStore {
        from: MaskRegister,
        to: Memory,
    },
}

impl Instruction {
    /// The instruction computes, with an operand that it reads from memory itself.
    pub fn reads_memory(&self) -> bool {
        let last = match self {
            Self::Arithmetic { right, .. } | Self::Compare { right, .. } => right,
            Self::SquareRoot { from, .. } => from,
            Self::MulAdd { third, .. } => third,
            Self::Blend { chosen, .. } => chosen,
            Self::Load { .. }
            | Self::Store { .. }
            | Self::Move { .. }
            | Self::MaskNot { .. }
            | Self::MaskLoad { .. }
            | Self::MaskStore { .. } => return false,
        };
        matches!(last, Operand::Memory(_))
    }
}

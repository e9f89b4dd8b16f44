//! Nodes of an expression graph.

/// A place of a block: `slot.index` counts values, each of which is as many numbers long as there are lanes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Slot {
    /// Which of the blocks that a kernel is called with.
    pub block: u8,
    /// Which value of the block.
    pub index: u32,
}

/// The position of a node: a number or a mask, by what the node computes.
pub(super) type NodeIndex = u32;

/// Operation on one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum UnaryOperation {
    Negate,
    Absolute,
    SquareRoot,
}

impl UnaryOperation {
    pub fn apply(self, value: f64) -> f64 {
        match self {
            Self::Negate => -value,
            Self::Absolute => value.abs(),
            Self::SquareRoot => value.sqrt(),
        }
    }
}

/// Operation on two numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum BinaryOperation {
    Add,
    Subtract,
    Multiply,
    Divide,
    /// `left` where `left < right`, else `right`.
    Minimum,
    /// `left` where `left > right`, else `right`.
    Maximum,
}

impl BinaryOperation {
    pub fn apply(self, left: f64, right: f64) -> f64 {
        match self {
            Self::Add => left + right,
            Self::Subtract => left - right,
            Self::Multiply => left * right,
            Self::Divide => left / right,
            Self::Minimum => {
                if left < right {
                    left
                } else {
                    right
                }
            }
            Self::Maximum => {
                if left > right {
                    left
                } else {
                    right
                }
            }
        }
    }

    /// The operands may change places.
    pub fn is_commutative(self) -> bool {
        matches!(self, Self::Add | Self::Multiply)
    }
}

/// Signs inside a fused multiply-add: `±(a·b) ± c`, rounded once.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub(super) struct FusedSigns {
    pub negates_product: bool,
    pub negates_addend: bool,
}

impl FusedSigns {
    pub fn apply(self, first: f64, second: f64, addend: f64) -> f64 {
        let first = if self.negates_product { -first } else { first };
        let addend = if self.negates_addend { -addend } else { addend };
        first.mul_add(second, addend)
    }
}

/// One operation on earlier nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Node {
    Input(Slot),
    /// The bits of the number, so that nodes can be compared.
    Constant(u64),
    Unary {
        operation: UnaryOperation,
        operand: NodeIndex,
    },
    Binary {
        operation: BinaryOperation,
        left: NodeIndex,
        right: NodeIndex,
    },
    MulAdd {
        first: NodeIndex,
        second: NodeIndex,
        addend: NodeIndex,
        signs: FusedSigns,
    },
    /// `left < right`, or its contrary, which holds for NaN.
    LessThan {
        left: NodeIndex,
        right: NodeIndex,
        is_negated: bool,
    },
    /// A constant answer for every lane; never reaches a program.
    Always(bool),
    MaskNot {
        mask: NodeIndex,
    },
    Select {
        mask: NodeIndex,
        chosen: NodeIndex,
        otherwise: NodeIndex,
    },
}

impl Node {
    /// The nodes that this one is computed from, in order.
    pub fn operands(&self) -> impl Iterator<Item = NodeIndex> + use<> {
        let operands = match *self {
            Self::Input(_) | Self::Constant(_) | Self::Always(_) => [None, None, None],
            Self::Unary { operand, .. } | Self::MaskNot { mask: operand } => [Some(operand), None, None],
            Self::Binary { left, right, .. } | Self::LessThan { left, right, .. } => [Some(left), Some(right), None],
            Self::MulAdd { first, second, addend, .. } => [Some(first), Some(second), Some(addend)],
            Self::Select { mask, chosen, otherwise } => [Some(mask), Some(chosen), Some(otherwise)],
        };
        operands.into_iter().flatten()
    }

    /// The operation on other nodes.
    pub fn renumbered(self, mut new: impl FnMut(NodeIndex) -> NodeIndex) -> Self {
        match self {
            Self::Input(_) | Self::Constant(_) | Self::Always(_) => self,
            Self::Unary { operation, operand } => Self::Unary { operation, operand: new(operand) },
            Self::Binary { operation, left, right } => Self::Binary { operation, left: new(left), right: new(right) },
            Self::MulAdd { first, second, addend, signs } => {
                Self::MulAdd { first: new(first), second: new(second), addend: new(addend), signs }
            }
            Self::LessThan { left, right, is_negated } => {
                Self::LessThan { left: new(left), right: new(right), is_negated }
            }
            Self::MaskNot { mask } => Self::MaskNot { mask: new(mask) },
            Self::Select { mask, chosen, otherwise } => {
                Self::Select { mask: new(mask), chosen: new(chosen), otherwise: new(otherwise) }
            }
        }
    }

    /// The node is read from memory, not computed.
    pub fn is_leaf(&self) -> bool {
        matches!(self, Self::Input(_) | Self::Constant(_))
    }

    /// Whether the node gives a mask instead of a number.
    pub fn is_mask(&self) -> bool {
        matches!(self, Self::LessThan { .. } | Self::Always(_) | Self::MaskNot { .. })
    }
}

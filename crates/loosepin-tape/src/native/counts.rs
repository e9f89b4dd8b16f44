//! Number of operations of each kind in a program.

use std::fmt;

use super::node::{BinaryOperation, Node, UnaryOperation};
use super::program::Program;

/// How many operations of each kind a [`Program`] does for one lane, and how many numbers it reads and writes.
///
/// Counted as written down: what the graph has folded away is not here; what machine code adds to find a register is in
/// [`super::KernelSize`].
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct OperationCounts {
    /// Fused multiply-adds, whatever their signs.
    pub multiply_adds: usize,
    /// Additions and subtractions.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Divisions.
    pub divisions: usize,
    /// Square roots.
    pub square_roots: usize,
    /// Comparisons, the smaller and the larger of two, logic of masks, choices by a mask.
    pub choices: usize,
    /// Turned signs and magnitudes.
    pub signs: usize,
    /// Numbers read from the blocks.
    pub inputs: usize,
    /// Different constants.
    pub constants: usize,
    /// Numbers written to the blocks.
    pub outputs: usize,
}

impl OperationCounts {
    /// All operations; reading and writing are none.
    pub fn operations(&self) -> usize {
        self.arithmetic() + self.choices + self.signs
    }

    /// Operations of the units that multiply and add, and of the divider.
    pub fn arithmetic(&self) -> usize {
        self.multiply_adds + self.additions + self.multiplications + self.divisions + self.square_roots
    }

    /// Floating-point operations by the usual count: a fused multiply-add is two, choices and signs are none.
    pub fn flops(&self) -> usize {
        self.arithmetic() + self.multiply_adds
    }
}

impl fmt::Display for OperationCounts {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            formatter,
            "{} operations: {} multiply-adds, {} additions, {} multiplications, {} divisions, {} square roots, \
             {} choices, {} signs; {} inputs, {} constants, {} outputs",
            self.operations(),
            self.multiply_adds,
            self.additions,
            self.multiplications,
            self.divisions,
            self.square_roots,
            self.choices,
            self.signs,
            self.inputs,
            self.constants,
            self.outputs,
        )
    }
}

impl Program {
    /// How many operations of each kind the program has.
    pub fn counts(&self) -> OperationCounts {
        let mut counts = OperationCounts { outputs: self.outputs().len(), ..OperationCounts::default() };
        for node in self.nodes() {
            let count = match node {
                Node::Input(_) => &mut counts.inputs,
                Node::Constant(_) => &mut counts.constants,
                Node::MulAdd { .. } => &mut counts.multiply_adds,
                Node::Unary { operation, .. } => match operation {
                    UnaryOperation::SquareRoot => &mut counts.square_roots,
                    UnaryOperation::Negate | UnaryOperation::Absolute => &mut counts.signs,
                },
                Node::Binary { operation, .. } => match operation {
                    BinaryOperation::Add | BinaryOperation::Subtract => &mut counts.additions,
                    BinaryOperation::Multiply => &mut counts.multiplications,
                    BinaryOperation::Divide => &mut counts.divisions,
                    BinaryOperation::Minimum | BinaryOperation::Maximum => &mut counts.choices,
                },
                Node::LessThan { .. } | Node::Always(_) | Node::MaskNot { .. } | Node::Select { .. } => {
                    &mut counts.choices
                }
            };
            *count += 1;
        }
        counts
    }
}

#[cfg(test)]
mod tests {
    use super::OperationCounts;
    use crate::native::{Graph, Program, Slot};

    #[test]
    fn analytic_counts_of_a_small_program() {
        let slot = |block, index| Slot { block, index };
        let mut graph = Graph::new();
        let [a, b, c] = [0, 1, 2].map(|index| graph.input(slot(0, index)));
        // Written and never needed: not counted.
        graph.multiply(a, c);
        let square = graph.multiply(a, a);
        let sum = graph.mul_add(b, b, square);
        let root = graph.square_root(sum);
        let quotient = graph.divide(root, c);
        let third = graph.constant(0.3);
        let difference = graph.subtract(quotient, third);
        let magnitude = graph.absolute(difference);
        let is_less = graph.less_than(magnitude, b);
        let chosen = graph.select(is_less, magnitude, quotient);
        let largest = graph.maximum(chosen, a);
        let program = Program::new(&graph, &[(slot(1, 0), largest), (slot(1, 1), root)]).expect("two slots");
        let counts = program.counts();
        let expected = OperationCounts {
            multiply_adds: 1,
            additions: 1,
            multiplications: 1,
            divisions: 1,
            square_roots: 1,
            choices: 3,
            signs: 1,
            inputs: 3,
            constants: 1,
            outputs: 2,
        };
        assert_eq!(counts, expected);
        assert_eq!((counts.operations(), counts.arithmetic(), counts.flops()), (9, 5, 6));
        assert_eq!(counts.operations(), program.operations());
    }
}

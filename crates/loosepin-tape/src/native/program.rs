//! A graph with its outputs: what is computed and where it is stored.

use std::collections::BTreeSet;

use super::error::NativeError;
use super::graph::{Graph, Value};
use super::node::{BinaryOperation, MaskOperation, Node, NodeIndex, Slot, UnaryOperation};

/// Lanes that [`Program::evaluate`] does together, so that looking up an operation is paid once for all of them.
const LANES_AT_ONCE: usize = 8;

/// The operations that some outputs need, in an order in which they can be done, and where the outputs go.
///
/// A program is run on blocks of memory: value `i` of block `b` in lane `l` is `blocks[b][i * lanes + l]`. All inputs are
/// read before any output that takes the place of an input is written, so a program may update its inputs in place.
#[derive(Debug, Clone)]
pub struct Program {
    nodes: Vec<Node>,
    outputs: Vec<(Slot, NodeIndex)>,
    values_per_block: Vec<usize>,
}

impl Program {
    /// The operations of `graph` that `outputs` need.
    ///
    /// # Errors
    ///
    /// [`NativeError::SlotWrittenTwice`] when two outputs go to one slot.
    pub fn new(graph: &Graph, outputs: &[(Slot, Value)]) -> Result<Self, NativeError> {
        let mut slots = BTreeSet::new();
        for &(slot, _) in outputs {
            if !slots.insert(slot) {
                return Err(NativeError::SlotWrittenTwice { block: slot.block, index: slot.index });
            }
        }
        let mut nodes = graph.nodes().to_vec();
        let targets: Vec<NodeIndex> = outputs.iter().map(|&(_, value)| value.0).collect();
        let same_as = absorb_negations(&mut nodes, &targets);
        let targets: Vec<NodeIndex> = targets.iter().map(|&target| same_as[target as usize]).collect();
        let (nodes, targets) = without_dead_nodes(&nodes, &targets, &same_as);
        let outputs: Vec<(Slot, NodeIndex)> =
            outputs.iter().zip(targets).map(|(&(slot, _), target)| (slot, target)).collect();

        let inputs = nodes.iter().filter_map(|node| if let Node::Input(slot) = node { Some(*slot) } else { None });
        let mut values_per_block = Vec::new();
        for slot in inputs.chain(outputs.iter().map(|&(slot, _)| slot)) {
            let block = usize::from(slot.block);
            if values_per_block.len() <= block {
                values_per_block.resize(block + 1, 0);
            }
            values_per_block[block] = values_per_block[block].max(slot.index as usize + 1);
        }
        Ok(Self { nodes, outputs, values_per_block })
    }

    pub(super) fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    pub(super) fn outputs(&self) -> &[(Slot, NodeIndex)] {
        &self.outputs
    }

    /// For each block, how many values it must have at least.
    pub fn values_per_block(&self) -> &[usize] {
        &self.values_per_block
    }

    /// How many operations the program has; reading inputs and constants is none.
    pub fn operations(&self) -> usize {
        self.nodes.iter().filter(|node| !node.is_leaf()).count()
    }

    /// Runs the program on plain `f64` numbers, with the same bits as machine code (except for which of the numbers
    /// "not a number" a result is). `scratch` is work space, which grows to what is needed and can be used again.
    ///
    /// # Errors
    ///
    /// [`NativeError::TooFewBlocks`] and [`NativeError::BlockTooShort`].
    pub fn evaluate(&self, lanes: usize, blocks: &mut [&mut [f64]], scratch: &mut Vec<f64>) -> Result<(), NativeError> {
        if blocks.len() < self.values_per_block.len() {
            return Err(NativeError::TooFewBlocks { given: blocks.len(), needed: self.values_per_block.len() });
        }
        for (block, (numbers, &values)) in blocks.iter().zip(&self.values_per_block).enumerate() {
            check_length(block, numbers, values, lanes)?;
        }
        let mut lane = 0;
        while lane + LANES_AT_ONCE <= lanes {
            self.evaluate_lanes::<LANES_AT_ONCE>(lane, lanes, blocks, scratch);
            lane += LANES_AT_ONCE;
        }
        for lane in lane..lanes {
            self.evaluate_lanes::<1>(lane, lanes, blocks, scratch);
        }
        Ok(())
    }

    /// Runs the program for `N` lanes from `first` on.
    fn evaluate_lanes<const N: usize>(
        &self,
        first: usize,
        lanes: usize,
        blocks: &mut [&mut [f64]],
        scratch: &mut Vec<f64>,
    ) {
        scratch.resize(self.nodes.len() * N, 0.0);
        let (values, _) = scratch.as_chunks_mut::<N>();
        let place = |slot: Slot| slot.index as usize * lanes + first;
        for (index, node) in self.nodes.iter().enumerate() {
            let (earlier, rest) = values.split_at_mut(index);
            rest[0] = match *node {
                Node::Input(slot) => {
                    let numbers = &blocks[usize::from(slot.block)][place(slot)..];
                    std::array::from_fn(|lane| numbers[lane])
                }
                _ => evaluate_node(*node, earlier),
            };
        }
        for &(slot, node) in &self.outputs {
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

/// The result of a node that is no input, from those of the nodes before; a mask is 1 where it holds, else 0.
fn evaluate_node<const N: usize>(node: Node, values: &[[f64; N]]) -> [f64; N] {
    let value = |index: NodeIndex| &values[index as usize];
    let mask = |holds: bool| f64::from(u8::from(holds));
    match node {
        Node::Input(_) => [f64::NAN; N],
        Node::Constant(bits) => [f64::from_bits(bits); N],
        Node::Unary { operation, operand } => value(operand).map(|number| operation.apply(number)),
        Node::Binary { operation, left, right } => {
            let (left, right) = (value(left), value(right));
            std::array::from_fn(|lane| operation.apply(left[lane], right[lane]))
        }
        Node::MulAdd { first, second, addend, signs } => {
            let (first, second, addend) = (value(first), value(second), value(addend));
            std::array::from_fn(|lane| signs.apply(first[lane], second[lane], addend[lane]))
        }
        Node::LessThan { left, right, is_negated } => {
            let (left, right) = (value(left), value(right));
            std::array::from_fn(|lane| mask((left[lane] < right[lane]) != is_negated))
        }
        Node::Always(answer) => [mask(answer); N],
        Node::MaskBinary { operation, left, right } => {
            let (left, right) = (value(left), value(right));
            match operation {
                MaskOperation::And => std::array::from_fn(|lane| left[lane] * right[lane]),
                MaskOperation::Or => std::array::from_fn(|lane| left[lane].max(right[lane])),
            }
        }
        Node::MaskNot { mask } => value(mask).map(|holds| 1.0 - holds),
        Node::Select { mask, chosen, otherwise } => {
            let (mask, chosen, otherwise) = (value(mask), value(chosen), value(otherwise));
            std::array::from_fn(|lane| if mask[lane] != 0.0 { chosen[lane] } else { otherwise[lane] })
        }
    }
}

/// Turns the sign of what is negated and used nowhere else where that costs nothing: `-(a - b)` is `b - a`.
/// Gives for each node the one to use in its place.
fn absorb_negations(nodes: &mut [Node], targets: &[NodeIndex]) -> Vec<NodeIndex> {
    let mut uses = vec![0_u32; nodes.len()];
    for &target in targets {
        uses[target as usize] += 1;
    }
    for index in (0..nodes.len()).rev() {
        if uses[index] > 0 {
            for operand in nodes[index].operands() {
                uses[operand as usize] += 1;
            }
        }
    }
    let mut same_as: Vec<NodeIndex> = (0..nodes.len() as NodeIndex).collect();
    for index in 0..nodes.len() {
        nodes[index] = nodes[index].renumbered(|operand| same_as[operand as usize]);
        if let Node::Unary { operation: UnaryOperation::Negate, operand } = nodes[index]
            && uses[index] > 0
            && turn_sign(nodes, &uses, operand)
        {
            same_as[index] = operand;
            uses[operand as usize] = uses[index];
        }
    }
    same_as
}

/// Turns the sign of node `index` in place, if it is used once and can take it.
fn turn_sign(nodes: &mut [Node], uses: &[u32], index: NodeIndex) -> bool {
    if uses[index as usize] != 1 {
        return false;
    }
    match nodes[index as usize] {
        Node::Binary { operation: BinaryOperation::Subtract, left, right } => {
            nodes[index as usize] = Node::Binary { operation: BinaryOperation::Subtract, left: right, right: left };
            true
        }
        Node::MulAdd { first, second, addend, mut signs } => {
            signs.negates_product = !signs.negates_product;
            signs.negates_addend = !signs.negates_addend;
            nodes[index as usize] = Node::MulAdd { first, second, addend, signs };
            true
        }
        Node::Binary { operation: BinaryOperation::Multiply | BinaryOperation::Divide, left, right } => {
            turn_sign(nodes, uses, left) || turn_sign(nodes, uses, right)
        }
        _ => false,
    }
}

/// The nodes that `targets` need, numbered anew without gaps, and the new numbers of `targets`.
fn without_dead_nodes(nodes: &[Node], targets: &[NodeIndex], same_as: &[NodeIndex]) -> (Vec<Node>, Vec<NodeIndex>) {
    let mut is_needed = vec![false; nodes.len()];
    for &target in targets {
        is_needed[target as usize] = true;
    }
    for index in (0..nodes.len()).rev() {
        if is_needed[index] {
            for operand in nodes[index].operands() {
                is_needed[same_as[operand as usize] as usize] = true;
            }
        }
    }
    let mut kept: Vec<Node> = Vec::new();
    let mut new_index = vec![NodeIndex::MAX; nodes.len()];
    for (index, node) in nodes.iter().enumerate() {
        if is_needed[index] {
            new_index[index] = kept.len() as NodeIndex;
            kept.push(node.renumbered(|operand| new_index[same_as[operand as usize] as usize]));
        }
    }
    (kept, targets.iter().map(|&target| new_index[target as usize]).collect())
}

//! A graph with its outputs: what is computed and where it is stored.

use std::collections::BTreeSet;

use super::block_start::BlockStart;
use super::error::NativeError;
use super::graph::{Graph, Value};
use super::node::{BinaryOperation, Node, NodeIndex, Slot, UnaryOperation};

/// The operations that some outputs need, in an order in which they can be done, and where the outputs go.
///
/// A program is run on blocks of memory: value `i` of block `b` in lane `l` is `blocks[b][i * lanes + l]`. All inputs are
/// read before any output that takes the place of an input is written, so a program may update its inputs in place.
#[derive(Debug, Clone, PartialEq, Eq)]
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
        Ok(Self::with(nodes, outputs))
    }

    fn with(nodes: Vec<Node>, outputs: Vec<(Slot, NodeIndex)>) -> Self {
        let inputs = nodes.iter().filter_map(|node| if let Node::Input(slot) = node { Some(*slot) } else { None });
        let mut values_per_block = Vec::new();
        for slot in inputs.chain(outputs.iter().map(|&(slot, _)| slot)) {
            let block = usize::from(slot.block);
            if values_per_block.len() <= block {
                values_per_block.resize(block + 1, 0);
            }
            values_per_block[block] = values_per_block[block].max(slot.index as usize + 1);
        }
        Self { nodes, outputs, values_per_block }
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

    /// The program with block `b` at `places[b]` of other blocks; a block that it does not use may have no place.
    pub(super) fn placed(&self, places: &[BlockStart]) -> Self {
        let moved = |slot: Slot| {
            let place = places[usize::from(slot.block)];
            Slot { block: place.block as u8, index: place.first as u32 + slot.index }
        };
        let nodes =
            self.nodes.iter().map(|node| if let Node::Input(slot) = node { Node::Input(moved(*slot)) } else { *node });
        let outputs = self.outputs.iter().map(|&(slot, node)| (moved(slot), node));
        Self::with(nodes.collect(), outputs.collect())
    }

    /// How many operations the program has; reading inputs and constants is none.
    pub fn operations(&self) -> usize {
        self.nodes.iter().filter(|node| !node.is_leaf()).count()
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

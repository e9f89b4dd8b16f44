//! A program as a list of instructions without registers: one for each operation and each part of the lanes.

use std::collections::{BTreeMap, BTreeSet};

use super::Level;
use super::instruction::{Arithmetic, Memory};
use super::node::{FusedSigns, Node, NodeIndex, Slot, UnaryOperation};
use super::program::Program;

/// The position of a vector in [`Lowered::values`].
pub(super) type ValueIndex = u32;

/// Operation of a [`Unit`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum UnitOperation {
    Arithmetic(Arithmetic),
    SquareRoot,
    MulAdd(FusedSigns),
    LessThan { is_negated: bool },
    MaskNot,
    Select,
}

/// One instruction to come.
#[derive(Debug, Clone, Copy)]
pub(super) struct Unit {
    pub operation: UnitOperation,
    /// As many as the operation takes; in the order of [`Node::operands`].
    pub operands: [Option<ValueIndex>; 3],
    pub result: ValueIndex,
}

impl Unit {
    pub fn operands(&self) -> impl Iterator<Item = ValueIndex> + use<> {
        self.operands.into_iter().flatten()
    }
}

/// Source of a vector.
#[derive(Debug, Clone, Copy)]
pub(super) struct VectorSource {
    /// Lies there from the start.
    pub memory: Option<Memory>,
    /// Has its own kind of register.
    pub is_mask: bool,
    /// An output will overwrite the place it was read from.
    pub is_overwritten: bool,
}

/// A program ready for the allocation of registers.
#[derive(Debug, Default)]
pub(super) struct Lowered {
    pub values: Vec<VectorSource>,
    pub units: Vec<Unit>,
    /// Stores as soon as the value is known.
    pub early_stores: BTreeMap<ValueIndex, Vec<Memory>>,
    /// Stores after all units, sorted by value: into slots that are inputs as well, or from what is not computed.
    pub late_stores: Vec<(ValueIndex, Memory)>,
    /// The numbers of [`Memory::Constant`].
    pub constants: Vec<u64>,
}

const SIGN_BIT: u64 = 1 << 63;
const ALL_BITS: u64 = u64::MAX;

/// Writes the operations of `program` in the given `order`, each for `parts` vectors of the `lanes`.
pub(super) fn lower(program: &Program, order: &[NodeIndex], level: Level, lanes: usize, parts: usize) -> Lowered {
    let mut lowering = Lowering { level, lanes, lowered: Lowered::default(), constants: BTreeMap::new() };
    let nodes = program.nodes();
    let overwritten: BTreeSet<Slot> = program.outputs().iter().map(|&(slot, _)| slot).collect();
    let mut vectors: Vec<Vec<ValueIndex>> = Vec::with_capacity(nodes.len());
    for node in nodes {
        vectors.push(match *node {
            Node::Constant(bits) => vec![lowering.constant(bits); parts],
            _ => (0..parts).map(|part| lowering.source(*node, part, &overwritten)).collect(),
        });
    }
    for &index in order {
        for part in 0..parts {
            let mut operands = [None; 3];
            for (place, operand) in nodes[index as usize].operands().enumerate() {
                operands[place] = Some(vectors[operand as usize][part]);
            }
            lowering.unit(nodes[index as usize], operands, vectors[index as usize][part]);
        }
    }
    let inputs: BTreeSet<Slot> =
        nodes.iter().filter_map(|node| if let Node::Input(slot) = node { Some(*slot) } else { None }).collect();
    for &(slot, index) in program.outputs() {
        // A value that stays where it is needs no store.
        if nodes[index as usize] == Node::Input(slot) {
            continue;
        }
        for part in 0..parts {
            let value = vectors[index as usize][part];
            let memory = lowering.slot_memory(slot, part);
            if nodes[index as usize].is_leaf() || inputs.contains(&slot) {
                lowering.lowered.late_stores.push((value, memory));
            } else {
                lowering.lowered.early_stores.entry(value).or_default().push(memory);
            }
        }
    }
    lowering.lowered.late_stores.sort_by_key(|&(value, _)| value);
    lowering.lowered
}

struct Lowering {
    level: Level,
    lanes: usize,
    lowered: Lowered,
    constants: BTreeMap<u64, ValueIndex>,
}

impl Lowering {
    fn slot_memory(&self, slot: Slot, part: usize) -> Memory {
        let offset = (slot.index as usize * self.lanes + part * self.level.vector_lanes()) * size_of::<f64>();
        // The size of a block was checked before.
        Memory::Slot { block: slot.block, offset_bytes: offset as i32 }
    }

    fn value(&mut self, source: VectorSource) -> ValueIndex {
        self.lowered.values.push(source);
        (self.lowered.values.len() - 1) as ValueIndex
    }

    fn source(&mut self, node: Node, part: usize, overwritten: &BTreeSet<Slot>) -> ValueIndex {
        let (memory, is_overwritten) = match node {
            Node::Input(slot) => (Some(self.slot_memory(slot, part)), overwritten.contains(&slot)),
            _ => (None, false),
        };
        self.value(VectorSource { memory, is_mask: node.is_mask(), is_overwritten })
    }

    fn constant(&mut self, bits: u64) -> ValueIndex {
        if let Some(&known) = self.constants.get(&bits) {
            return known;
        }
        let memory = Some(Memory::Constant(self.lowered.constants.len() as u32));
        self.lowered.constants.push(bits);
        let value = self.value(VectorSource { memory, is_mask: false, is_overwritten: false });
        self.constants.insert(bits, value);
        value
    }

    fn unit(&mut self, node: Node, mut operands: [Option<ValueIndex>; 3], result: ValueIndex) {
        let operation = match node {
            Node::Unary { operation: UnaryOperation::Negate, .. } => {
                operands[1] = Some(self.constant(SIGN_BIT));
                UnitOperation::Arithmetic(Arithmetic::ExclusiveOr)
            }
            Node::Unary { operation: UnaryOperation::Absolute, .. } => {
                operands[1] = Some(self.constant(!SIGN_BIT));
                UnitOperation::Arithmetic(Arithmetic::And)
            }
            Node::Unary { operation: UnaryOperation::SquareRoot, .. } => UnitOperation::SquareRoot,
            Node::Binary { operation, .. } => UnitOperation::Arithmetic(Arithmetic::Binary(operation)),
            Node::MulAdd { signs, .. } => UnitOperation::MulAdd(signs),
            Node::LessThan { is_negated, .. } => UnitOperation::LessThan { is_negated },
            Node::MaskNot { .. } if self.level == Level::Avx2 => {
                operands[1] = Some(self.constant(ALL_BITS));
                UnitOperation::Arithmetic(Arithmetic::ExclusiveOr)
            }
            Node::MaskNot { .. } => UnitOperation::MaskNot,
            Node::Select { .. } => UnitOperation::Select,
            // Inputs and constants are no units, and a graph folds constant masks away.
            Node::Input(_) | Node::Constant(_) | Node::Always(_) => return,
        };
        self.lowered.units.push(Unit { operation, operands, result });
    }
}

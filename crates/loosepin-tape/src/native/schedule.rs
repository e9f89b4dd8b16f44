//! The order of the operations: long chains first, few values alive.

use super::Level;
use super::node::{BinaryOperation, Node, NodeIndex, UnaryOperation};
use super::program::Program;

/// Operations that the assumed processor starts in a cycle.
const STARTS_PER_CYCLE: u32 = 2;

/// Cycles until the result of `node` can be used, about, on the processors of our day.
fn latency_cycles(node: Node) -> u32 {
    match node {
        Node::Input(_) | Node::Constant(_) | Node::Always(_) => 0,
        Node::Unary { operation: UnaryOperation::SquareRoot, .. } => 20,
        Node::Binary { operation: BinaryOperation::Divide, .. } => 13,
        Node::MulAdd { .. } | Node::LessThan { .. } => 4,
        Node::Binary { operation: BinaryOperation::Minimum | BinaryOperation::Maximum, .. } => 2,
        Node::Binary { .. } => 3,
        Node::Unary { .. } | Node::MaskNot { .. } | Node::Select { .. } => 1,
    }
}

/// How many results may wait for their use before the order favours operations that use up results.
///
/// A quarter of the registers: the rest hold what is loaded, and the other half of the lanes where two vectors go side by
/// side. Measured on right-hand sides of 76 to 850 operations, limits from a quarter to all registers differ by less than
/// 5 %; no limit costs up to 30 %.
fn waiting_limit(level: Level) -> usize {
    level.vector_registers() / 4
}

/// All operations of `program`, each after its operands.
///
/// List scheduling: time runs on an assumed processor, and of the operations whose operands are there the one with the
/// longest chain behind it comes next; when too many results wait, the one that frees most of them. A processor
/// that reorders by itself does the rest.
pub(super) fn schedule(program: &Program, level: Level) -> Vec<NodeIndex> {
    Scheduler::new(program, waiting_limit(level)).run()
}

/// An operation whose operands are all placed.
#[derive(Debug, Clone, Copy)]
struct Ready {
    node: NodeIndex,
    /// When its last operand is there.
    at_cycle: u32,
}

struct Scheduler<'a> {
    nodes: &'a [Node],
    waiting_limit: usize,
    /// For each node the operations that it feeds.
    users: Vec<Vec<NodeIndex>>,
    /// For each node how many of its users are not placed yet.
    users_left: Vec<usize>,
    /// For each node how many of its operands are not placed yet.
    operands_left: Vec<usize>,
    /// For each node the cycles from its start to the end of all that depends on it.
    chain_cycles: Vec<u32>,
    ready: Vec<Ready>,
    /// Results placed and not used up.
    waiting: usize,
}

impl<'a> Scheduler<'a> {
    fn new(program: &'a Program, waiting_limit: usize) -> Self {
        let nodes = program.nodes();
        let mut users: Vec<Vec<NodeIndex>> = vec![Vec::new(); nodes.len()];
        let mut operands_left = vec![0; nodes.len()];
        for (index, node) in nodes.iter().enumerate() {
            for operand in computed_operands(nodes, *node) {
                users[operand as usize].push(index as NodeIndex);
                operands_left[index] += 1;
            }
        }
        let mut chain_cycles = vec![0; nodes.len()];
        for index in (0..nodes.len()).rev() {
            let behind = users[index].iter().map(|&user| chain_cycles[user as usize]).max().unwrap_or(0);
            chain_cycles[index] = latency_cycles(nodes[index]) + behind;
        }
        let ready = (0..nodes.len())
            .filter(|&index| operands_left[index] == 0 && !nodes[index].is_leaf())
            .map(|index| Ready { node: index as NodeIndex, at_cycle: 0 })
            .collect();
        let users_left = users.iter().map(Vec::len).collect();
        Self { nodes, waiting_limit, users, users_left, operands_left, chain_cycles, ready, waiting: 0 }
    }

    fn run(mut self) -> Vec<NodeIndex> {
        let mut order = Vec::new();
        let mut available_cycle = vec![0; self.nodes.len()];
        // In parts of a cycle.
        let mut clock = 0;
        while let Some(best) = self.best(clock / STARTS_PER_CYCLE) {
            let Ready { node, at_cycle } = self.ready.swap_remove(best);
            clock = clock.max(at_cycle * STARTS_PER_CYCLE) + 1;
            order.push(node);
            self.waiting = self.waiting + self.added(node) - self.freed(node);
            for operand in computed_operands(self.nodes, self.nodes[node as usize]) {
                self.users_left[operand as usize] -= 1;
            }
            let end_cycle = clock / STARTS_PER_CYCLE + latency_cycles(self.nodes[node as usize]);
            for user in std::mem::take(&mut self.users[node as usize]) {
                let available = &mut available_cycle[user as usize];
                *available = end_cycle.max(*available);
                self.operands_left[user as usize] -= 1;
                if self.operands_left[user as usize] == 0 {
                    self.ready.push(Ready { node: user, at_cycle: *available });
                }
            }
        }
        order
    }

    /// The position in `ready` of the operation to place next.
    fn best(&self, now_cycle: u32) -> Option<usize> {
        let is_crowded = self.waiting >= self.waiting_limit;
        (0..self.ready.len()).max_by_key(|&position| {
            let Ready { node, at_cycle } = self.ready[position];
            let idle_cycles = i64::from(at_cycle.saturating_sub(now_cycle));
            let chain_cycles = i64::from(self.chain_cycles[node as usize]);
            let net_freed = self.freed(node) as i64 - self.added(node) as i64;
            // The order as written decides between equals, so that a program has one order.
            let written = -i64::from(node);
            if is_crowded {
                [net_freed, -idle_cycles, chain_cycles, written]
            } else {
                [-idle_cycles, chain_cycles, net_freed, written]
            }
        })
    }

    /// Results that nobody needs once `node` is placed.
    fn freed(&self, node: NodeIndex) -> usize {
        computed_operands(self.nodes, self.nodes[node as usize])
            .filter(|&operand| self.users_left[operand as usize] == 1)
            .count()
    }

    /// Results that wait once `node` is placed: its own, unless it is only stored.
    fn added(&self, node: NodeIndex) -> usize {
        usize::from(self.users_left[node as usize] > 0)
    }
}

/// The operands of `node` that are operations themselves, each once.
fn computed_operands(nodes: &[Node], node: Node) -> impl Iterator<Item = NodeIndex> + use<'_> {
    node.operands().enumerate().filter_map(move |(place, operand)| {
        let is_first = node.operands().take(place).all(|earlier| earlier != operand);
        (is_first && !nodes[operand as usize].is_leaf()).then_some(operand)
    })
}

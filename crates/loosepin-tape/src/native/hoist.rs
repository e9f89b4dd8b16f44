//! Moves rarely changing computations out of programs that run often.

use std::collections::HashMap;

use super::error::NativeError;
use super::graph::{Graph, Value};
use super::node::{Node, NodeIndex, Slot};
use super::program::Program;

/// Computations of programs from the first values of one block alone: a program of its own does them when these values change and puts the
/// results behind them; the others read them there. The operations are the same, and so are the bits.
///
/// ```
/// use loosepin_tape::native::{Graph, Hoisted, Slot};
///
/// // y = x/√m, with m in block 0 and x in block 1.
/// let mut graph = Graph::new();
/// let mass = graph.input(Slot { block: 0, index: 0 });
/// let x = graph.input(Slot { block: 1, index: 0 });
/// let root = graph.square_root(mass);
/// let y = graph.divide(x, root);
///
/// let mut hoisted = Hoisted::new(0, 1);
/// let often = hoisted.program(&graph, &[(Slot { block: 1, index: 1 }, y)])?;
/// let seldom = hoisted.own_program()?;
/// assert_eq!((often.operations(), seldom.operations(), hoisted.end()), (1, 1, 2));
///
/// let (masses, values): (&mut [f64], &mut [f64]) = (&mut [4.0, f64::NAN], &mut [3.0, f64::NAN]);
/// seldom.evaluate(1, &mut [masses, values])?;
/// often.evaluate(1, &mut [masses, values])?;
/// assert_eq!(values, [3.0, 1.5]);
/// # Ok::<(), loosepin_tape::native::NativeError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Hoisted {
    block: u8,
    /// So many values of the block are given; those that are computed stand behind them.
    given: usize,
    graph: Graph,
    /// What is computed, in the order of its places.
    computed: Vec<NodeIndex>,
    places: HashMap<NodeIndex, u32>,
}

impl Hoisted {
    /// An empty program; the first `given` values of `block` are those that change seldom.
    pub fn new(block: u8, given: usize) -> Self {
        Self { block, given, graph: Graph::new(), computed: Vec::new(), places: HashMap::new() }
    }

    /// Length of the block with what has been taken out of programs so far.
    pub fn end(&self) -> usize {
        self.given + self.computed.len()
    }

    /// The operations of `graph` that `outputs` need, without those that are done before.
    ///
    /// # Errors
    ///
    /// As for [`Program::new`].
    pub fn program(&mut self, graph: &Graph, outputs: &[(Slot, Value)]) -> Result<Program, NativeError> {
        let is_needed = needed(graph, outputs);
        let is_seldom = self.seldom(graph);
        let mut rest = Graph::new();
        // By node of `graph`: the node of `rest` in its place, and that of the own graph where it changes seldom.
        let (mut of_rest, mut of_own) = (vec![0; graph.nodes().len()], vec![0; graph.nodes().len()]);
        for (index, node) in graph.nodes().iter().enumerate().filter(|&(index, _)| is_needed[index]) {
            if is_seldom[index] {
                of_own[index] = self.graph.adopt(node.renumbered(|operand| of_own[operand as usize]));
            }
        }
        for index in needed_after(graph, outputs, &is_seldom) {
            let node = graph.nodes()[index];
            let kept = if is_taken_out(&node, is_seldom[index]) {
                Node::Input(self.place(of_own[index]))
            } else {
                node.renumbered(|operand| of_rest[operand as usize])
            };
            of_rest[index] = rest.adopt(kept);
        }
        let outputs: Vec<(Slot, Value)> =
            outputs.iter().map(|&(slot, value)| (slot, Value(of_rest[value.0 as usize]))).collect();
        Program::new(&rest, &outputs)
    }

    /// The program with the computations taken out of all others.
    ///
    /// # Errors
    ///
    /// As for [`Program::new`].
    pub fn own_program(&self) -> Result<Program, NativeError> {
        let outputs: Vec<(Slot, Value)> =
            self.computed.iter().map(|&node| (self.slot(self.places[&node]), Value(node))).collect();
        Program::new(&self.graph, &outputs)
    }

    fn slot(&self, index: u32) -> Slot {
        Slot { block: self.block, index }
    }

    /// Slot of a node of the own graph.
    fn place(&mut self, node: NodeIndex) -> Slot {
        let next = self.end() as u32;
        let place = *self.places.entry(node).or_insert(next);
        if place == next {
            self.computed.push(node);
        }
        self.slot(place)
    }

    /// By node: whether it depends on constants and the given values alone.
    fn seldom(&self, graph: &Graph) -> Vec<bool> {
        let mut is_seldom: Vec<bool> = Vec::with_capacity(graph.nodes().len());
        for node in graph.nodes() {
            is_seldom.push(match node {
                Node::Input(slot) => slot.block == self.block && (slot.index as usize) < self.given,
                node => node.operands().all(|operand| is_seldom[operand as usize]),
            });
        }
        is_seldom
    }
}

/// Whether a node that may change seldom is computed before: an operation that gives a number. Masks are no numbers.
fn is_taken_out(node: &Node, is_seldom: bool) -> bool {
    is_seldom && !node.is_leaf() && !node.is_mask()
}

/// By node: whether `outputs` need it.
fn needed(graph: &Graph, outputs: &[(Slot, Value)]) -> Vec<bool> {
    marked(graph, outputs, |_, _| true)
}

/// The nodes that `outputs` need where what is taken out needs nothing, in their order.
fn needed_after(graph: &Graph, outputs: &[(Slot, Value)], is_seldom: &[bool]) -> impl Iterator<Item = usize> {
    let is_needed = marked(graph, outputs, |index, node| !is_taken_out(node, is_seldom[index]));
    is_needed.into_iter().enumerate().filter_map(|(index, is_needed)| is_needed.then_some(index))
}

/// By node: whether `outputs` need it, by way of nodes that need their operands.
fn marked(graph: &Graph, outputs: &[(Slot, Value)], needs_operands: impl Fn(usize, &Node) -> bool) -> Vec<bool> {
    let mut is_needed = vec![false; graph.nodes().len()];
    for (_, value) in outputs {
        is_needed[value.0 as usize] = true;
    }
    for (index, node) in graph.nodes().iter().enumerate().rev() {
        if is_needed[index] && needs_operands(index, node) {
            for operand in node.operands() {
                is_needed[operand as usize] = true;
            }
        }
    }
    is_needed
}

#[cfg(test)]
mod tests {
    use super::super::random_programs::{Random, Shape, comparable, random_graph};
    use super::{Graph, Hoisted, Program, Slot, Value};

    const BLOCKS: usize = 3;
    const OUTPUTS: usize = 7;

    #[test]
    fn identity_programs_give_the_same_bits_with_and_without_what_is_taken_out() {
        let mut random = Random(26);
        let mut taken_out = 0;
        for _ in 0..200 {
            let shape =
                Shape { nodes: 90, inputs: 30, outputs: OUTPUTS, reach: 60, blocks: BLOCKS, is_in_place: false };
            let mut hoisted = Hoisted::new(0, 10);
            let mut pairs = Vec::new();
            for _ in 0..2 {
                let (graph, outputs) = random_graph(&mut random, &shape);
                let to_own_block = |(index, &(_, value)): (usize, &(Slot, Value))| {
                    (Slot { block: BLOCKS as u8, index: index as u32 }, value)
                };
                let outputs: Vec<(Slot, Value)> = outputs.iter().enumerate().map(to_own_block).collect();
                let whole = Program::new(&graph, &outputs).unwrap();
                pairs.push((whole, hoisted.program(&graph, &outputs).unwrap()));
            }
            let given: Vec<f64> = (0..10).map(|_| random.operand()).collect();
            let mut seldom = given.clone();
            seldom.resize(hoisted.end(), f64::NAN);
            let [mut second, mut third] = [(); 2].map(|()| (0..10).map(|_| random.operand()).collect::<Vec<f64>>());
            let own = hoisted.own_program().unwrap();
            own.evaluate(1, &mut [&mut seldom, &mut second, &mut third]).unwrap();
            assert_eq!(
                seldom[..10].iter().copied().map(comparable).collect::<Vec<_>>(),
                given.iter().copied().map(comparable).collect::<Vec<_>>()
            );
            taken_out += own.operations();
            for (whole, often) in pairs {
                let [mut expected, mut found] = [[0.5; OUTPUTS]; 2];
                whole.evaluate(1, &mut [&mut seldom, &mut second, &mut third, &mut expected]).unwrap();
                often.evaluate(1, &mut [&mut seldom, &mut second, &mut third, &mut found]).unwrap();
                assert_eq!(found.map(comparable), expected.map(comparable));
                assert!(often.operations() <= whole.operations());
            }
        }
        assert!(taken_out > 500, "only {taken_out} operations");
    }

    #[test]
    fn identity_what_two_programs_have_in_common_is_computed_once() {
        let mut hoisted = Hoisted::new(0, 2);
        for turned in [false, true] {
            let mut graph = Graph::new();
            let mut pair = [0, 1].map(|index| graph.input(Slot { block: 0, index }));
            if turned {
                pair.reverse();
            }
            let product = graph.multiply(pair[0], pair[1]);
            let root = graph.square_root(product);
            let x = graph.input(Slot { block: 1, index: u32::from(turned) });
            let y = graph.add(root, x);
            let program = hoisted.program(&graph, &[(Slot { block: 2, index: u32::from(turned) }, y)]).unwrap();
            assert_eq!(program.operations(), 1);
        }
        assert_eq!((hoisted.end(), hoisted.own_program().unwrap().operations()), (3, 2));
    }
}

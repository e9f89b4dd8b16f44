//! Expressions as a graph of operations, simplified while they are written down.

use std::collections::HashMap;

use super::node::{BinaryOperation, FusedSigns, Node, NodeIndex, Slot, UnaryOperation};

/// A number of a [`Graph`]; belongs to the graph that gave it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Value(pub(super) NodeIndex);

/// A choice of lanes of a [`Graph`]; belongs to the graph that gave it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Mask(pub(super) NodeIndex);

/// Straight-line arithmetic on `f64`, written down by method calls.
///
/// Equal operations on equal operands are one node. Operations on constants are done at once. What needs no operation
/// gets none: `x + 0`, `x · 1`, `x · 0`, `x - x`, `fma(±1, b, c)`, `fma(a, b, 0)`, `fma(0, b, c)`, division by a power of
/// two, double negation; negations move into the operation that takes them. Nothing is reassociated, and a product and a
/// sum are never fused, so the results are those of the operations as written, bit for bit, with three exceptions:
/// the sign of a zero; `x · 0` and `x - x` are zero although `x` may be infinite or not a number; and which of the
/// numbers "not a number" a result is.
#[derive(Debug, Clone, Default)]
pub struct Graph {
    nodes: Vec<Node>,
    known: HashMap<Node, NodeIndex>,
}

impl Graph {
    /// A graph without nodes.
    pub fn new() -> Self {
        Self::default()
    }

    pub(super) fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    fn node(&self, value: Value) -> Node {
        self.nodes[value.0 as usize]
    }

    fn insert(&mut self, node: Node) -> NodeIndex {
        *self.known.entry(node).or_insert_with(|| {
            self.nodes.push(node);
            // Four thousand million nodes do not fit into memory.
            (self.nodes.len() - 1) as NodeIndex
        })
    }

    /// A node of another graph, whose operands are here already: as it stands there, but for the order of what may change places.
    pub(super) fn adopt(&mut self, node: Node) -> NodeIndex {
        self.insert(match node {
            Node::Binary { operation, left, right } if operation.is_commutative() => {
                Node::Binary { operation, left: left.min(right), right: left.max(right) }
            }
            Node::MulAdd { first, second, addend, signs } => {
                Node::MulAdd { first: first.min(second), second: first.max(second), addend, signs }
            }
            node => node,
        })
    }

    fn unary(&mut self, operation: UnaryOperation, operand: Value) -> Value {
        if let Some(constant) = self.constant_value(operand) {
            return self.constant(operation.apply(constant));
        }
        Value(self.insert(Node::Unary { operation, operand: operand.0 }))
    }

    fn binary(&mut self, operation: BinaryOperation, left: Value, right: Value) -> Value {
        if let (Some(left), Some(right)) = (self.constant_value(left), self.constant_value(right)) {
            return self.constant(operation.apply(left, right));
        }
        let (left, right) =
            if operation.is_commutative() && right.0 < left.0 { (right.0, left.0) } else { (left.0, right.0) };
        Value(self.insert(Node::Binary { operation, left, right }))
    }

    /// The number that `value` is in every lane, if it is a constant.
    pub fn constant_value(&self, value: Value) -> Option<f64> {
        match self.node(value) {
            Node::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    fn is_zero(&self, value: Value) -> bool {
        self.constant_value(value) == Some(0.0)
    }

    /// `(sign, x)` with `value = sign · x`, where `value` is a negation or not.
    fn without_sign(&self, value: Value) -> (bool, Value) {
        match self.node(value) {
            Node::Unary { operation: UnaryOperation::Negate, operand } => (true, Value(operand)),
            _ => (false, value),
        }
    }

    fn negate_if(&mut self, is_negated: bool, value: Value) -> Value {
        if is_negated { self.negate(value) } else { value }
    }

    /// The value at `slot`, as it was before the kernel was called.
    pub fn input(&mut self, slot: Slot) -> Value {
        Value(self.insert(Node::Input(slot)))
    }

    /// `value` in every lane.
    pub fn constant(&mut self, value: f64) -> Value {
        Value(self.insert(Node::Constant(value.to_bits())))
    }

    /// `-operand`.
    pub fn negate(&mut self, operand: Value) -> Value {
        match self.node(operand) {
            Node::Unary { operation: UnaryOperation::Negate, operand } => Value(operand),
            // The constant takes the sign, at no cost.
            Node::Binary { operation: BinaryOperation::Multiply, left, right } => {
                let (left, right) = (Value(left), Value(right));
                if let Some(constant) = self.constant_value(left) {
                    let constant = self.constant(-constant);
                    self.multiply(constant, right)
                } else if let Some(constant) = self.constant_value(right) {
                    let constant = self.constant(-constant);
                    self.multiply(left, constant)
                } else {
                    self.unary(UnaryOperation::Negate, operand)
                }
            }
            _ => self.unary(UnaryOperation::Negate, operand),
        }
    }

    /// `left + right`.
    pub fn add(&mut self, left: Value, right: Value) -> Value {
        if self.is_zero(left) {
            return right;
        }
        if self.is_zero(right) {
            return left;
        }
        match (self.without_sign(left), self.without_sign(right)) {
            ((false, left), (false, right)) => self.binary(BinaryOperation::Add, left, right),
            ((false, left), (true, right)) => self.subtract(left, right),
            ((true, left), (false, right)) => self.subtract(right, left),
            ((true, left), (true, right)) => {
                let sum = self.add(left, right);
                self.negate(sum)
            }
        }
    }

    /// `left - right`.
    pub fn subtract(&mut self, left: Value, right: Value) -> Value {
        if self.is_zero(right) {
            return left;
        }
        if self.is_zero(left) {
            return self.negate(right);
        }
        if left == right {
            return self.constant(0.0);
        }
        match (self.without_sign(left), self.without_sign(right)) {
            ((false, left), (false, right)) => self.binary(BinaryOperation::Subtract, left, right),
            ((false, left), (true, right)) => self.add(left, right),
            ((true, left), (true, right)) => self.subtract(right, left),
            ((true, left), (false, right)) => {
                let sum = self.add(left, right);
                self.negate(sum)
            }
        }
    }

    /// `left · right`.
    pub fn multiply(&mut self, left: Value, right: Value) -> Value {
        for (constant, other) in [(left, right), (right, left)] {
            match self.constant_value(constant) {
                Some(0.0) => return self.constant(0.0),
                Some(1.0) => return other,
                Some(-1.0) => return self.negate(other),
                Some(value) => {
                    if let (true, other) = self.without_sign(other) {
                        let constant = self.constant(-value);
                        return self.multiply(constant, other);
                    }
                }
                None => {}
            }
        }
        let ((left_sign, left), (right_sign, right)) = (self.without_sign(left), self.without_sign(right));
        let product = self.binary(BinaryOperation::Multiply, left, right);
        self.negate_if(left_sign != right_sign, product)
    }

    /// `left / right`.
    pub fn divide(&mut self, left: Value, right: Value) -> Value {
        if let Some(reciprocal) = self.constant_value(right).and_then(exact_reciprocal) {
            let reciprocal = self.constant(reciprocal);
            return self.multiply(left, reciprocal);
        }
        let ((left_sign, left), (right_sign, right)) = (self.without_sign(left), self.without_sign(right));
        let quotient = self.binary(BinaryOperation::Divide, left, right);
        self.negate_if(left_sign != right_sign, quotient)
    }

    /// `first · second + addend`, rounded once.
    pub fn mul_add(&mut self, first: Value, second: Value, addend: Value) -> Value {
        if self.is_zero(addend) {
            return self.multiply(first, second);
        }
        for (constant, other) in [(first, second), (second, first)] {
            match self.constant_value(constant) {
                Some(0.0) => return addend,
                Some(1.0) => return self.add(other, addend),
                Some(-1.0) => return self.subtract(addend, other),
                _ => {}
            }
        }
        let (first_sign, mut first) = self.without_sign(first);
        let (second_sign, mut second) = self.without_sign(second);
        let (negates_addend, addend) = self.without_sign(addend);
        let mut negates_product = first_sign != second_sign;
        let constants = [first, second, addend].map(|operand| self.constant_value(operand));
        if let [Some(first), Some(second), Some(addend)] = constants {
            let signs = FusedSigns { negates_product, negates_addend };
            return self.constant(signs.apply(first, second, addend));
        }
        if negates_product {
            // A constant factor takes the sign, so that equal operations look equal.
            if let Some(constant) = constants[0] {
                first = self.constant(-constant);
                negates_product = false;
            } else if let Some(constant) = constants[1] {
                second = self.constant(-constant);
                negates_product = false;
            }
        }
        let (first, second) = if second.0 < first.0 { (second.0, first.0) } else { (first.0, second.0) };
        let signs = FusedSigns { negates_product, negates_addend };
        Value(self.insert(Node::MulAdd { first, second, addend: addend.0, signs }))
    }

    /// The square root of `operand`.
    pub fn square_root(&mut self, operand: Value) -> Value {
        self.unary(UnaryOperation::SquareRoot, operand)
    }

    /// The magnitude of `operand`.
    pub fn absolute(&mut self, operand: Value) -> Value {
        let (_, operand) = self.without_sign(operand);
        match self.node(operand) {
            Node::Unary { operation: UnaryOperation::Absolute | UnaryOperation::SquareRoot, .. } => operand,
            _ => self.unary(UnaryOperation::Absolute, operand),
        }
    }

    /// `left` where `left < right`, else `right`: with a number that is none, `right`.
    pub fn minimum(&mut self, left: Value, right: Value) -> Value {
        if left == right {
            return left;
        }
        self.binary(BinaryOperation::Minimum, left, right)
    }

    /// `left` where `left > right`, else `right`: with a number that is none, `right`.
    pub fn maximum(&mut self, left: Value, right: Value) -> Value {
        if left == right {
            return left;
        }
        self.binary(BinaryOperation::Maximum, left, right)
    }

    /// The lanes with `left < right`; none if one of the two is NaN.
    pub fn less_than(&mut self, left: Value, right: Value) -> Mask {
        if left == right {
            return self.always(false);
        }
        if let (Some(left), Some(right)) = (self.constant_value(left), self.constant_value(right)) {
            return self.always(left < right);
        }
        Mask(self.insert(Node::LessThan { left: left.0, right: right.0, is_negated: false }))
    }

    /// All lanes, or none.
    pub fn always(&mut self, is_all: bool) -> Mask {
        Mask(self.insert(Node::Always(is_all)))
    }

    fn mask_node(&self, mask: Mask) -> Node {
        self.nodes[mask.0 as usize]
    }

    /// The other lanes.
    pub fn not(&mut self, mask: Mask) -> Mask {
        let node = match self.mask_node(mask) {
            Node::Always(answer) => Node::Always(!answer),
            Node::LessThan { left, right, is_negated } => Node::LessThan { left, right, is_negated: !is_negated },
            Node::MaskNot { mask } => return Mask(mask),
            _ => Node::MaskNot { mask: mask.0 },
        };
        Mask(self.insert(node))
    }

    /// `chosen` in the lanes of `mask`, `otherwise` in the others.
    pub fn select(&mut self, mask: Mask, chosen: Value, otherwise: Value) -> Value {
        if chosen == otherwise {
            return chosen;
        }
        match self.mask_node(mask) {
            Node::Always(answer) => return if answer { chosen } else { otherwise },
            Node::MaskNot { mask } => return self.select(Mask(mask), otherwise, chosen),
            Node::LessThan { is_negated: true, .. } => {
                let mask = self.not(mask);
                return self.select(mask, otherwise, chosen);
            }
            _ => {}
        }
        Value(self.insert(Node::Select { mask: mask.0, chosen: chosen.0, otherwise: otherwise.0 }))
    }
}

/// `1 / value` where that is exact and dividing is the same as multiplying: `value` is a power of two, and neither it nor its
/// reciprocal is subnormal.
fn exact_reciprocal(value: f64) -> Option<f64> {
    let reciprocal = value.recip();
    let is_power_of_two = value.is_normal() && reciprocal.is_normal() && value.to_bits().trailing_zeros() >= 52;
    is_power_of_two.then_some(reciprocal)
}

#[cfg(test)]
mod tests {
    use super::super::random_programs::Random;
    use super::super::{Graph, Mask, Program, Slot, Value};

    const X: Slot = Slot { block: 0, index: 0 };
    const Y: Slot = Slot { block: 0, index: 1 };
    const Z: Slot = Slot { block: 0, index: 2 };
    const OUTPUT: Slot = Slot { block: 1, index: 0 };

    /// Numbers without a short binary fraction, none of them equal.
    const XYZ: [f64; 3] = [0.7, -1.3, 2.9];

    /// Operations and result of what `write` makes of x, y and z.
    fn operations_and_result(write: impl Fn(&mut Graph, Value, Value, Value) -> Value) -> (usize, f64) {
        let mut graph = Graph::new();
        let (x, y, z) = (graph.input(X), graph.input(Y), graph.input(Z));
        let value = write(&mut graph, x, y, z);
        let program = Program::new(&graph, &[(OUTPUT, value)]).expect("one output");
        let (mut inputs, mut output) = (XYZ, [f64::NAN]);
        program.evaluate(1, &mut [&mut inputs, &mut output]).expect("blocks are long enough");
        (program.operations(), output[0])
    }

    #[test]
    fn identity_neutral_operands_need_no_operation() {
        let [x, y, z] = XYZ;
        let zero = |graph: &mut Graph| graph.constant(0.0);
        let one = |graph: &mut Graph| graph.constant(1.0);
        let minus_one = |graph: &mut Graph| graph.constant(-1.0);
        type Write = Box<dyn Fn(&mut Graph, Value, Value, Value) -> Value>;
        let cases: Vec<(&str, usize, f64, Write)> = vec![
            (
                "x + 0",
                0,
                x,
                Box::new(move |g, x, _, _| {
                    let c = zero(g);
                    g.add(x, c)
                }),
            ),
            (
                "0 + x",
                0,
                x,
                Box::new(move |g, x, _, _| {
                    let c = zero(g);
                    g.add(c, x)
                }),
            ),
            (
                "x - 0",
                0,
                x,
                Box::new(move |g, x, _, _| {
                    let c = zero(g);
                    g.subtract(x, c)
                }),
            ),
            (
                "0 - x",
                1,
                -x,
                Box::new(move |g, x, _, _| {
                    let c = zero(g);
                    g.subtract(c, x)
                }),
            ),
            ("x - x", 0, 0.0, Box::new(move |g, x, _, _| g.subtract(x, x))),
            (
                "x 1",
                0,
                x,
                Box::new(move |g, x, _, _| {
                    let c = one(g);
                    g.multiply(x, c)
                }),
            ),
            (
                "0 x",
                0,
                0.0,
                Box::new(move |g, x, _, _| {
                    let c = zero(g);
                    g.multiply(c, x)
                }),
            ),
            (
                "x (-1)",
                1,
                -x,
                Box::new(move |g, x, _, _| {
                    let c = minus_one(g);
                    g.multiply(x, c)
                }),
            ),
            (
                "--x",
                0,
                x,
                Box::new(move |g, x, _, _| {
                    let n = g.negate(x);
                    g.negate(n)
                }),
            ),
            (
                "x / 1",
                0,
                x,
                Box::new(move |g, x, _, _| {
                    let c = one(g);
                    g.divide(x, c)
                }),
            ),
            (
                "fma(x, y, 0)",
                1,
                x * y,
                Box::new(move |g, x, y, _| {
                    let c = zero(g);
                    g.mul_add(x, y, c)
                }),
            ),
            (
                "fma(0, y, z)",
                0,
                z,
                Box::new(move |g, _, y, z| {
                    let c = zero(g);
                    g.mul_add(c, y, z)
                }),
            ),
            (
                "fma(x, 0, z)",
                0,
                z,
                Box::new(move |g, x, _, z| {
                    let c = zero(g);
                    g.mul_add(x, c, z)
                }),
            ),
            (
                "fma(1, y, z)",
                1,
                y + z,
                Box::new(move |g, _, y, z| {
                    let c = one(g);
                    g.mul_add(c, y, z)
                }),
            ),
            (
                "fma(x, -1, z)",
                1,
                z - x,
                Box::new(move |g, x, _, z| {
                    let c = minus_one(g);
                    g.mul_add(x, c, z)
                }),
            ),
            (
                "x + -y",
                1,
                x - y,
                Box::new(move |g, x, y, _| {
                    let n = g.negate(y);
                    g.add(x, n)
                }),
            ),
            (
                "-x + y",
                1,
                y - x,
                Box::new(move |g, x, y, _| {
                    let n = g.negate(x);
                    g.add(n, y)
                }),
            ),
            (
                "x - -y",
                1,
                x + y,
                Box::new(move |g, x, y, _| {
                    let n = g.negate(y);
                    g.subtract(x, n)
                }),
            ),
            (
                "-x - -y",
                1,
                y - x,
                Box::new(move |g, x, y, _| {
                    let (x, y) = (g.negate(x), g.negate(y));
                    g.subtract(x, y)
                }),
            ),
            (
                "-x -y",
                1,
                x * y,
                Box::new(move |g, x, y, _| {
                    let (x, y) = (g.negate(x), g.negate(y));
                    g.multiply(x, y)
                }),
            ),
            (
                "-(2.5 x)",
                1,
                -(2.5 * x),
                Box::new(move |g, x, _, _| {
                    let c = g.constant(2.5);
                    let product = g.multiply(c, x);
                    g.negate(product)
                }),
            ),
            (
                "-(x - y)",
                1,
                y - x,
                Box::new(move |g, x, y, _| {
                    let d = g.subtract(x, y);
                    g.negate(d)
                }),
            ),
            (
                "-(z (x - y))",
                2,
                z * (y - x),
                Box::new(move |g, x, y, z| {
                    let d = g.subtract(x, y);
                    let product = g.multiply(z, d);
                    g.negate(product)
                }),
            ),
            (
                "-fma(x, y, z)",
                1,
                -x.mul_add(y, z),
                Box::new(move |g, x, y, z| {
                    let sum = g.mul_add(x, y, z);
                    g.negate(sum)
                }),
            ),
            (
                "fma(-x, y, -z)",
                1,
                (-x).mul_add(y, -z),
                Box::new(move |g, x, y, z| {
                    let (x, z) = (g.negate(x), g.negate(z));
                    g.mul_add(x, y, z)
                }),
            ),
            (
                "|-x|",
                1,
                x.abs(),
                Box::new(move |g, x, _, _| {
                    let n = g.negate(x);
                    g.absolute(n)
                }),
            ),
            ("min(x, x)", 0, x, Box::new(move |g, x, _, _| g.minimum(x, x))),
            (
                "x y + y x",
                2,
                x * y + x * y,
                Box::new(move |g, x, y, _| {
                    let (one, other) = (g.multiply(x, y), g.multiply(y, x));
                    g.add(one, other)
                }),
            ),
            (
                "select(x < x, x, y)",
                0,
                y,
                Box::new(move |g, x, y, _| {
                    let never = g.less_than(x, x);
                    g.select(never, x, y)
                }),
            ),
            (
                "select(not (x < y), x, y)",
                2,
                x,
                Box::new(move |g, x, y, _| {
                    let less = g.less_than(x, y);
                    let not_less = g.not(less);
                    g.select(not_less, x, y)
                }),
            ),
        ];
        for (name, operations, result, write) in cases {
            assert_eq!(operations_and_result(write), (operations, result), "{name}");
        }
    }

    #[test]
    fn identity_division_by_powers_of_two_alone_becomes_multiplication() {
        for (divisor, is_product) in [(8.0, true), (-0.25, true), (3.0, false), (0.0, false), (f64::INFINITY, false)] {
            let mut graph = Graph::new();
            let (x, divisor_value) = (graph.input(X), graph.constant(divisor));
            let quotient = graph.divide(x, divisor_value);
            let reciprocal = graph.constant(1.0 / divisor);
            assert_eq!(quotient == graph.multiply(x, reciprocal), is_product, "x / {divisor}");
            assert_eq!(
                operations_and_result(|graph, x, _, _| {
                    let divisor = graph.constant(divisor);
                    graph.divide(x, divisor)
                }),
                (1, XYZ[0] / divisor)
            );
        }
    }

    #[test]
    fn identity_constants_are_folded_with_the_operations_of_f64() {
        let (operations, result) = operations_and_result(|graph, _, _, _| {
            let [a, b, c] = [0.1, 0.3, -0.03].map(|number| graph.constant(number));
            let fused = graph.mul_add(a, b, c);
            let root = graph.square_root(b);
            let quotient = graph.divide(root, a);
            let is_less = graph.less_than(a, b);
            let chosen = graph.select(is_less, quotient, a);
            graph.maximum(fused, chosen)
        });
        assert_eq!((operations, result), (0, 0.3_f64.sqrt() / 0.1));
    }

    /// Writes down random operations, neutral constants among them, and does them on numbers at the same time.
    /// Zeros and infinite numbers are not used further: their signs and products are what may differ.
    #[test]
    fn identity_simplified_programs_give_the_numbers_of_the_operations_as_written() {
        let mut random = Random(3);
        for _ in 0..2000 {
            let mut graph = Graph::new();
            let mut pool: Vec<(Value, f64)> = [X, Y, Z].into_iter().map(|slot| graph.input(slot)).zip(XYZ).collect();
            for number in [0.0, 1.0, -1.0, 2.0, 0.5, -3.7] {
                pool.push((graph.constant(number), number));
            }
            let mut masks: Vec<(Mask, bool)> = vec![(graph.always(true), true), (graph.always(false), false)];
            for _ in 0..30 {
                let mut pick = || pool[random.below(pool.len())];
                let ((a, an), (b, bn), (c, cn)) = (pick(), pick(), pick());
                let (mask, holds) = masks[random.below(masks.len())];
                let made = match random.below(15) {
                    0 => (graph.add(a, b), an + bn),
                    1 => (graph.subtract(a, b), an - bn),
                    2 => (graph.multiply(a, b), an * bn),
                    3 => (graph.divide(a, b), an / bn),
                    4 | 5 => (graph.mul_add(a, b, c), an.mul_add(bn, cn)),
                    6 | 7 => (graph.negate(a), -an),
                    8 => (graph.square_root(a), an.sqrt()),
                    9 => (graph.absolute(a), an.abs()),
                    10 => (graph.minimum(a, b), if an < bn { an } else { bn }),
                    11 => (graph.maximum(a, b), if an > bn { an } else { bn }),
                    12 => (graph.select(mask, a, b), if holds { an } else { bn }),
                    13 => {
                        masks.push((graph.less_than(a, b), an < bn));
                        continue;
                    }
                    _ => {
                        masks.push((graph.not(mask), !holds));
                        continue;
                    }
                };
                if made.1.is_finite() && made.1 != 0.0 {
                    pool.push(made);
                }
            }
            let slots = (0..pool.len() as u32).map(|index| Slot { block: 1, index });
            let outputs: Vec<(Slot, Value)> = slots.zip(&pool).map(|(slot, &(value, _))| (slot, value)).collect();
            let program = Program::new(&graph, &outputs).expect("each output has its own slot");
            let (mut inputs, mut results) = (XYZ, vec![f64::NAN; pool.len()]);
            program.evaluate(1, &mut [&mut inputs, &mut results]).expect("long enough");
            let expected: Vec<f64> = pool.iter().map(|&(_, number)| number).collect();
            assert_eq!(results, expected, "{program:?}");
        }
    }
}

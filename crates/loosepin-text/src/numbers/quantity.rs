//! Every number of a model in one table: path, unit, rule, and the expression that gives it.

use crate::diagnostics::{Code, Span, problems};
use crate::document::describe_path;
use crate::units::{Dimension, Expression, Op, Rule, format_apart, format_refused, run};
use crate::work;
use std::collections::HashMap;

/// Key of the clearance of a revolute joint that is radius of the hole minus radius of the pin.
pub const RADIAL: &str = "radial_clearance";
/// Key of the same clearance where it is stated as the difference of the diameters: twice as large.
pub const DIAMETRAL: &str = "diametral_clearance";

/// Index of a quantity in a [`QuantityTable`] and of its value in [`Values`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct QuantityId(pub usize);

/// Stands where a quantity could not be read. No model with diagnostics is handed out, so it is never looked up.
pub const UNREAD: QuantityId = QuantityId(0);

/// One number of the model.
#[derive(Debug, Clone)]
pub struct Quantity {
    /// Path in the file, for example `joint.gudgeon.radial_clearance`.
    pub path: String,
    /// Dimension of its value, which is in the SI unit of it.
    pub dimension: Dimension,
    /// The range it must lie in.
    pub rule: Rule,
    /// Origin of its value.
    pub origin: Origin,
    /// Place of its value in the file; absent for a default.
    pub span: Option<Span>,
}

/// Origin of the value of a quantity.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Origin {
    /// A number in the file.
    Literal,
    /// Not written in the file.
    Default,
    /// An expression over these parameters.
    Expression {
        /// The parameters that it names.
        depends_on: Vec<QuantityId>,
    },
    /// A number in the file that fixes units elsewhere and therefore cannot be set: the exponent of a stiffness.
    Fixed,
}

/// The quantities of a model, each after those that its expression uses.
#[derive(Debug, Clone, Default)]
pub struct QuantityTable {
    quantities: Vec<Quantity>,
    /// Values of the file, SI.
    nominal: Vec<f64>,
    /// The expressions in table order, each ending in a store into its slot.
    program: Vec<Op>,
    orders: Vec<Order>,
    ids: HashMap<String, QuantityId>,
    /// Shares by which warm bodies are longer than drawn.
    elongations: Vec<QuantityId>,
    /// Clearances of warm parts, each with the one that is stated.
    stated: HashMap<QuantityId, QuantityId>,
}

/// One quantity must be below another.
#[derive(Debug, Clone, Copy)]
struct Order {
    smaller: QuantityId,
    larger: QuantityId,
}

/// The values of all quantities of a model, SI, in the order of its table.
#[derive(Debug, Clone, PartialEq)]
pub struct Values(pub Vec<f64>);

impl std::ops::Index<QuantityId> for Values {
    type Output = f64;
    fn index(&self, id: QuantityId) -> &f64 {
        &self.0[id.0]
    }
}

problems! {
    /// Why a set of values is physically impossible.
    #[derive(Debug, Clone, PartialEq)]
    pub enum QuantityError {
        BreaksRule { path: String, value_si: f64, dimension: Dimension, rule: &'static str } =>
            if value_si.is_finite() { Code::BreaksRule } else { Code::NotFinite },
            says("{} {}; must be {rule}", describe_path(path), format_refused(*value_si, *dimension)),
            hint_of(hint_at(path));
        OutOfOrder { path: String, value_si: f64, limit_path: String, limit_si: f64, dimension: Dimension } =>
            Code::OutOfOrder,
            says("{}", out_of_order([path, limit_path], [*value_si, *limit_si], *dimension)),
            hint_of(hint_at(path));
        NotSettable { path: String } => Code::NotSettable,
            says("{path} is not a free number of the model, so it cannot be set"),
            hint_of(hint_at(path));
    }
}

impl QuantityError {
    /// Path of the quantity at fault.
    pub fn path(&self) -> &str {
        match self {
            Self::BreaksRule { path, .. } | Self::OutOfOrder { path, .. } | Self::NotSettable { path } => path,
        }
    }
}

/// Message for two values in the wrong order, with enough digits to differ.
fn out_of_order([path, limit_path]: [&str; 2], values_si: [f64; 2], dimension: Dimension) -> String {
    let [value, limit] = format_apart(values_si, dimension);
    format!("{} {value}; must be below {} {limit}", describe_path(path), describe_path(limit_path))
}

/// The way out where the quantity at `path` is at fault.
fn hint_at(path: &str) -> Option<String> {
    let hint = match path.rsplit('.').next()? {
        RADIAL => "the radial clearance is radius of the hole minus radius of the pin",
        DIAMETRAL => "the diametral clearance is diameter of the hole minus diameter of the pin",
        "radial_clearance_when_warm" | "clearance_when_warm" => {
            "at this temperature, the pin or block is as large as its hole or guide: the joint seizes"
        }
        "restitution" => "a restitution of 90 % is 0.9; with 1 an impact loses no energy, with 0 it would end at rest",
        "lower_speed" => "friction grows from zero at lower_speed to its full value at upper_speed",
        _ => return None,
    };
    Some(hint.to_owned())
}

impl QuantityTable {
    /// The quantities in table order.
    pub fn iter(&self) -> impl Iterator<Item = (QuantityId, &Quantity)> {
        self.quantities.iter().enumerate().map(|(index, quantity)| (QuantityId(index), quantity))
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.quantities.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.quantities.is_empty()
    }

    /// The quantity with this path, settable or not.
    pub fn id(&self, path: &str) -> Option<QuantityId> {
        self.ids.get(path).copied()
    }

    /// The values that the file gives.
    pub fn nominal(&self) -> Values {
        Values(self.nominal.clone())
    }

    /// Takes `values`, which are of this table, for those that the file gives.
    pub fn set_nominal(&mut self, values: Values) {
        self.nominal = values.0;
    }

    /// The values of all quantities when those in `set` replace what the file says. Expressions that use a replaced
    /// quantity follow it.
    ///
    /// # Errors
    /// The first value that breaks its rule, in table order, or that is not below the one it must be below; a quantity
    /// that cannot be set.
    pub fn evaluate(&self, set: &[(QuantityId, f64)]) -> Result<Values, QuantityError> {
        let mut values = self.nominal();
        self.evaluate_into(set, &mut values)?;
        Ok(values)
    }

    /// As [`QuantityTable::evaluate`], into values of this table made before, so that nothing is allocated.
    ///
    /// # Errors
    /// As [`QuantityTable::evaluate`]; the values are then not to be used.
    pub fn evaluate_into(&self, set: &[(QuantityId, f64)], values: &mut Values) -> Result<(), QuantityError> {
        values.0.clone_from(&self.nominal);
        for &(id, value_si) in set {
            if !self[id].is_settable() {
                return Err(QuantityError::NotSettable { path: self[id].path.clone() });
            }
            values.0[id.0] = value_si;
        }
        work::add(self.program.len() + self.quantities.len());
        run(&self.program, &mut values.0);
        for (quantity, value_si) in self.quantities.iter().zip(&values.0) {
            quantity.check(*value_si)?;
        }
        self.orders.iter().try_for_each(|order| self.check_order(*order, values))
    }

    /// Whether a quantity is `other` or depends on it.
    pub fn depends_on(&self, id: QuantityId, other: QuantityId) -> bool {
        id == other || self.roots(id).contains(&other)
    }

    /// The free numbers that a quantity depends on, itself if it is one.
    pub fn roots(&self, id: QuantityId) -> Vec<QuantityId> {
        let mut roots = Vec::new();
        let mut seen = vec![false; self.len()];
        let mut waiting = vec![id];
        work::add(self.len());
        while let Some(id) = waiting.pop() {
            if std::mem::replace(&mut seen[id.0], true) {
                continue;
            }
            match &self[id].origin {
                Origin::Expression { depends_on } => waiting.extend(depends_on),
                _ => roots.push(id),
            }
        }
        roots.sort();
        roots
    }

    /// The values where no body is longer than drawn; the same where none can be. Rules are not checked.
    pub fn at_drawing(&self, values: &Values) -> Values {
        let mut drawn = values.clone();
        if self.elongations.is_empty() {
            return drawn;
        }
        let is_elongation = |op: &Op| matches!(*op, Op::Store(slot) if self.elongations.contains(&QuantityId(slot)));
        let mut program = Vec::with_capacity(self.program.len() + 2 * self.elongations.len());
        for op in &self.program {
            if is_elongation(op) {
                program.extend([Op::Number(0.0), Op::Multiply]);
            }
            program.push(*op);
        }
        run(&program, &mut drawn.0);
        drawn
    }

    /// The clearance that is stated where `id` is that of warm parts; else `id`.
    pub fn stated_clearance(&self, id: QuantityId) -> QuantityId {
        self.stated.get(&id).copied().unwrap_or(id)
    }

    /// Notes that `id` is the share by which a body is longer than drawn.
    pub fn add_elongation(&mut self, id: QuantityId) {
        self.elongations.push(id);
    }

    /// Notes that `warm` is the clearance of warm parts whose drawing states `stated`.
    pub fn add_warm(&mut self, warm: QuantityId, stated: QuantityId) {
        self.stated.insert(warm, stated);
    }

    /// Whether nothing else depends on the value of `id`: no expression uses it, and it has not to be below or above another.
    pub fn is_independent(&self, id: QuantityId) -> bool {
        work::add(self.len() + self.orders.len());
        let is_used = |quantity: &Quantity| matches!(&quantity.origin, Origin::Expression { depends_on } if depends_on.contains(&id));
        !self.quantities.iter().any(is_used)
            && !self.orders.iter().any(|order| order.smaller == id || order.larger == id)
    }

    fn check_order(&self, order: Order, values: &Values) -> Result<(), QuantityError> {
        let (value_si, limit_si) = (values[order.smaller], values[order.larger]);
        if value_si < limit_si {
            return Ok(());
        }
        let (smaller, larger) = (&self[order.smaller], &self[order.larger]);
        Err(QuantityError::OutOfOrder {
            path: smaller.path.clone(),
            value_si,
            limit_path: larger.path.clone(),
            limit_si,
            dimension: smaller.dimension,
        })
    }

    /// Adds a number.
    pub fn add_number(&mut self, quantity: Quantity, value_si: f64) -> QuantityId {
        let id = QuantityId(self.quantities.len());
        self.ids.insert(quantity.path.clone(), id);
        self.quantities.push(quantity);
        self.nominal.push(value_si);
        id
    }

    /// Adds a value given by an expression over quantities added before.
    pub fn add_expression(&mut self, quantity: Quantity, expression: &Expression) -> QuantityId {
        let value_si = run(&expression.ops, &mut self.nominal);
        let id = self.add_number(quantity, value_si);
        self.program.extend_from_slice(&expression.ops);
        self.program.push(Op::Store(id.0));
        id
    }

    /// Demands that one quantity be below another; says whether the values of the file obey.
    ///
    /// # Errors
    /// [`QuantityError::OutOfOrder`] if they do not.
    pub fn demand_order(&mut self, smaller: QuantityId, larger: QuantityId) -> Result<(), QuantityError> {
        let order = Order { smaller, larger };
        self.orders.push(order);
        self.check_order(order, &self.nominal())
    }

    /// The value in the file.
    pub fn nominal_value(&self, id: QuantityId) -> f64 {
        self.nominal[id.0]
    }
}

impl std::ops::Index<QuantityId> for QuantityTable {
    type Output = Quantity;
    fn index(&self, id: QuantityId) -> &Quantity {
        &self.quantities[id.0]
    }
}

impl Quantity {
    /// Whether a study or a setting may give it another value.
    pub fn is_settable(&self) -> bool {
        matches!(self.origin, Origin::Literal | Origin::Default)
    }

    /// Whether a value keeps the rule of this quantity.
    ///
    /// # Errors
    /// [`QuantityError::BreaksRule`].
    pub fn check(&self, value_si: f64) -> Result<(), QuantityError> {
        if self.rule.allows(value_si) {
            return Ok(());
        }
        let rule = if value_si.is_finite() { self.rule.words() } else { Rule::Finite.words() };
        Err(QuantityError::BreaksRule { path: self.path.clone(), value_si, dimension: self.dimension, rule })
    }
}

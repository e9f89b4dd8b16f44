//! Every number of a model in one table: path, unit, rule, and the expression that gives it.

use thiserror::Error;

/// Index of a quantity in a [`QuantityTable`] and of its value in [`Values`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct QuantityId(pub usize);

/// The range that a value must lie in, whether written in a file or drawn in a study.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rule {
    /// Any finite number.
    Finite,
    /// > 0.
    Positive,
    /// >= 0.
    NonNegative,
    /// (0, 1].
    Restitution,
    /// [0, 0.5].
    PoissonRatio,
    /// >= 1.
    AtLeastOne,
}

/// One number of the model.
#[derive(Debug, Clone)]
pub struct Quantity {
    /// Where it stands in the file, for example `joint.gudgeon.radial_clearance`.
    pub path: String,
    /// The range it must lie in.
    pub rule: Rule,
    // The reader adds: dimension, expression, place in the file.
}

/// The quantities of a model, each after those that its expression uses.
#[derive(Debug, Clone, Default)]
pub struct QuantityTable {
    quantities: Vec<Quantity>,
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

/// Why a set of values is physically impossible.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum QuantityError {
    /// A value breaks its rule.
    #[error("{path} is {value_si} (SI); must be {rule}")]
    BreaksRule {
        /// Path of the quantity.
        path: String,
        /// The value, SI.
        value_si: f64,
        /// The rule in words, for example `> 0`.
        rule: &'static str,
    },
}

impl QuantityTable {
    /// The values of all quantities when those in `set` replace what the file says. Expressions that use a replaced
    /// quantity follow it.
    ///
    /// # Errors
    /// The first value that breaks its rule, in table order.
    pub fn evaluate(&self, set: &[(QuantityId, f64)]) -> Result<Values, QuantityError> {
        let _ = (&self.quantities, set);
        unimplemented!("the reader of model files fills this in")
    }
}

//! The parameters read so far.

use crate::units::{Dimension, ExpressionProblem, Names};
use std::collections::{HashMap, HashSet};

/// The parameters read so far.
#[derive(Debug, Default)]
pub struct Parameters {
    /// Slot and dimension of each.
    pub known: HashMap<String, (usize, Dimension)>,
    /// In file order.
    pub order: Vec<String>,
    /// Parameters that were reported: expressions that use them are not reported again.
    pub broken: HashSet<String>,
    /// Parameters that were reported where they are used, since they lack their unit.
    blamed: HashSet<String>,
    used: HashSet<usize>,
}

impl Names for Parameters {
    fn find(&self, name: &str) -> Option<(usize, Dimension)> {
        self.known.get(name).copied()
    }
    fn all(&self) -> Box<dyn Iterator<Item = &str> + '_> {
        Box::new(self.order.iter().map(String::as_str))
    }
    fn is_reported(&self, name: &str) -> bool {
        self.broken.contains(name)
    }
}

impl Parameters {
    /// Whether an expression is wrong since it uses a parameter that was reported: it is not reported again.
    pub fn is_echo(&self, problem: &ExpressionProblem) -> bool {
        matches!(problem, ExpressionProblem::UnknownName { name, .. } if self.is_reported(name))
    }

    /// Notes that a parameter is reported for its missing unit; false where it was before.
    pub fn blame(&mut self, name: &str) -> bool {
        self.blamed.insert(name.to_owned())
    }

    /// Notes that expressions use these slots.
    pub fn mark_used(&mut self, slots: &[usize]) {
        self.used.extend(slots);
    }

    /// Names of those that no expression uses, in file order.
    pub fn unused(&self) -> impl Iterator<Item = &String> {
        self.order.iter().filter(|name| self.known.get(*name).is_some_and(|(slot, _)| !self.used.contains(slot)))
    }
}

//! Reading expressions over variables.

use super::reader::ModelReader;
use crate::model::problem::ModelProblem;
pub(super) use crate::model::values::function::Changing;
use crate::model::values::function::{Beyond, Function, FunctionNames, Variable};
use loosepin_text::document::{Entry, Written};
use loosepin_text::tolerance::for_single_value;
use loosepin_text::units::{Dimension, Names, parse_expression};

impl ModelReader {
    /// Reads an expression over parameters and `variables`. One without variables is a quantity like any other.
    pub fn changing(
        &mut self,
        entry: &Entry<'_>,
        dimension: Dimension,
        rule: loosepin_text::units::Rule,
        variables: &[Variable],
    ) -> Option<Changing> {
        let Written::Text(text) = self.numbers.reader.written(entry)? else {
            return self.numbers.quantity_of(entry, dimension, rule).map(Changing::Constant);
        };
        let names = FunctionNames { parameters: &self.numbers.parameters, variables };
        let expression = match parse_expression(text, &names) {
            Ok(expression) => expression,
            Err(error) => {
                let is_echo = self.numbers.parameters.is_echo(&error.problem);
                if !is_echo {
                    let error = for_single_value(error, text, Some(dimension), Some(&entry.path.dotted()));
                    let span = self.numbers.reader.inside(entry, text, &error.span);
                    self.numbers.reader.report(&error.problem, span);
                }
                return None;
            }
        };
        let reads_variables = |slot: &usize| usize::MAX - slot < variables.len();
        let read: Vec<usize> = expression.reads.iter().copied().filter(reads_variables).collect();
        if read.is_empty() {
            return self.numbers.quantity_of(entry, dimension, rule).map(Changing::Constant);
        }
        for slot in read {
            let (name, _) = variables[usize::MAX - slot];
            if self.numbers.parameters.find(name).is_some() {
                let problem = ModelProblem::NameTaken { entry: entry.path.describe(), name };
                return self.numbers.reader.refuse(&problem, entry.span);
            }
        }
        let slots: Vec<usize> = expression.reads.iter().copied().filter(|slot| !reads_variables(slot)).collect();
        self.numbers.parameters.mark_used(&slots);
        if !self.numbers.reader.measures(entry, expression.dimension, dimension) {
            return None;
        }
        match Function::compile(&expression.ops, dimension, variables.len()) {
            Ok(function) => Some(Changing::Function(function)),
            Err(beyond) => {
                let entry_words = entry.path.describe();
                let problem = match beyond {
                    Beyond::Inverse => ModelProblem::InverseFunction { entry: entry_words },
                };
                self.numbers.reader.refuse(&problem, entry.span)
            }
        }
    }
}

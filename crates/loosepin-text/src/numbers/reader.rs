//! A file with numbers being read: its quantities so far, and the reader of expressions, parameters and names.

use super::parameters::Parameters;
use super::problem::EntryProblem;
use super::quantity::{Origin, Quantity, QuantityId, QuantityTable};
use crate::diagnostics::{Diagnostic, Source, Span, nearest_name};
use crate::document::{Entry, EntryPath, Keys, Reader, Table, Written};
use crate::tolerance::for_single_value;
use crate::units::{Dimension, Expression, Op, Rule, parse_expression, run};
use crate::work;
use std::collections::HashMap;
use std::sync::Arc;

/// Names of the file with the things that they stand for; absent where they were reported already.
pub type NameTable<T> = Vec<(String, Option<T>)>;

/// The way out where a key needs others: what keys mean is known to the kind of file alone.
pub type HintOfNeeds = fn(key: &str, needs: &[&'static str]) -> Option<&'static str>;

/// The reader of a file whose numbers are quantities. What returns nothing has reported.
pub struct NumberReader {
    /// The reader of the document.
    pub reader: Reader,
    /// Whether the file has tables that it cannot have: names that stand there are not missing.
    pub has_unknown_tables: bool,
    /// The quantities so far.
    pub quantities: QuantityTable,
    /// The parameters so far.
    pub parameters: Parameters,
    /// Where tables stand, by their paths.
    pub places: HashMap<String, Span>,
    hint_of_needs: HintOfNeeds,
}

impl NumberReader {
    /// Reader of a file, of which nothing has been read.
    pub fn new(source: &Arc<Source>, hint_of_needs: HintOfNeeds) -> NumberReader {
        NumberReader {
            reader: Reader::new(source),
            has_unknown_tables: false,
            quantities: QuantityTable::default(),
            parameters: Parameters::default(),
            places: HashMap::new(),
            hint_of_needs,
        }
    }

    /// Remembers where a table stands.
    pub fn remember(&mut self, entry: &Entry<'_>) {
        self.places.insert(entry.path.dotted(), entry.key_span);
    }

    /// The quantity behind a key, of the dimension and rule that the table of keys demands; absent where it is not
    /// written or was reported.
    pub fn quantity(&mut self, table: &Table<'_>, key: &str) -> Option<QuantityId> {
        self.quantity_at(&table.get(key)?)
    }

    /// As [`NumberReader::quantity`], with a value for where it is not written.
    pub fn quantity_or(&mut self, table: &Table<'_>, key: &'static str, default_si: f64) -> Option<QuantityId> {
        match table.due_quantity(key) {
            Some((dimension, rule)) if !table.has(key) => {
                Some(self.default_quantity(&table.path.join(key), dimension, rule, default_si))
            }
            _ => self.quantity(table, key),
        }
    }

    /// The quantity at an entry, of the dimension and rule that the table of keys demands.
    pub fn quantity_at(&mut self, entry: &Entry<'_>) -> Option<QuantityId> {
        let (dimension, rule) = entry.due_quantity()?;
        self.quantity_of(entry, dimension, rule)
    }

    /// A quantity that the file does not mention.
    pub fn default_quantity(
        &mut self,
        path: &EntryPath,
        dimension: Dimension,
        rule: Rule,
        default_si: f64,
    ) -> QuantityId {
        let quantity = Quantity { path: path.dotted(), dimension, rule, origin: Origin::Default, span: None };
        self.quantities.add_number(quantity, default_si)
    }

    /// The quantity at an entry, of a given dimension.
    pub fn quantity_of(&mut self, entry: &Entry<'_>, dimension: Dimension, rule: Rule) -> Option<QuantityId> {
        let expression = self.expression_due(entry, dimension)?;
        self.add(entry, &expression, rule)
    }

    /// The expression at an entry, of the dimension that is due.
    pub fn expression_due(&mut self, entry: &Entry<'_>, due: Dimension) -> Option<Expression> {
        let expression = self.expression_of(entry, Some(due))?;
        if expression.dimension != due && self.blames_parameter(entry, due) {
            return None;
        }
        self.reader.measures(entry, expression.dimension, due).then_some(expression)
    }

    /// The text or number at an entry as an expression over parameters.
    pub fn expression(&mut self, entry: &Entry<'_>) -> Option<Expression> {
        self.expression_of(entry, None)
    }

    /// As [`NumberReader::expression`]; where a dimension is due, hints name its units.
    pub fn expression_of(&mut self, entry: &Entry<'_>, due: Option<Dimension>) -> Option<Expression> {
        match self.reader.written(entry)? {
            Written::Number(value) => Some(Expression::number(value)),
            Written::Text(text) => match parse_expression(text, &self.parameters) {
                Ok(expression) => {
                    self.parameters.mark_used(&expression.reads);
                    Some(expression)
                }
                Err(error) => {
                    let is_echo = self.parameters.is_echo(&error.problem);
                    let is_blamed = due.is_some_and(|due| !is_echo && self.blames_parameter(entry, due));
                    if !is_echo && !is_blamed {
                        let error = for_single_value(error, text, due, Some(&entry.path.dotted()));
                        let error = error.for_key(text, entry.example());
                        let span = self.reader.inside(entry, text, &error.span);
                        self.reader.report(&error.problem, span);
                    }
                    None
                }
            },
        }
    }

    /// The quantity in the text at an entry behind its first `skip` bytes, of a given dimension: of values with a word before them.
    pub fn quantity_behind(
        &mut self,
        entry: &Entry<'_>,
        skip: usize,
        dimension: Dimension,
        rule: Rule,
    ) -> Option<QuantityId> {
        let whole = self.reader.text(entry)?;
        let text = whole.get(skip..)?;
        match parse_expression(text, &self.parameters) {
            Ok(expression) => {
                self.parameters.mark_used(&expression.reads);
                let measures = self.reader.measures(entry, expression.dimension, dimension);
                if measures { self.add(entry, &expression, rule) } else { None }
            }
            Err(error) if self.parameters.is_echo(&error.problem) => None,
            Err(error) => {
                let error = for_single_value(error, text, Some(dimension), None);
                let span = self.reader.inside(entry, whole, &(error.span.start + skip..error.span.end + skip));
                self.reader.refuse(&error.problem, span)
            }
        }
    }

    /// Three quantities of a given dimension, along x, y and z, each with a path of its own.
    pub fn three(&mut self, entry: &Entry<'_>, dimension: Dimension) -> Option<[QuantityId; 3]> {
        let [mut x, mut y, mut z] = self.reader.three(entry)?;
        for (element, axis) in [(&mut x, "x"), (&mut y, "y"), (&mut z, "z")] {
            element.path = entry.path.join(axis);
        }
        let [x, y, z] = [x, y, z].map(|element| self.quantity_of(&element, dimension, Rule::Finite));
        Some([x?, y?, z?])
    }

    /// Adds a quantity; reports where its value breaks the rule.
    pub fn add(&mut self, entry: &Entry<'_>, expression: &Expression, rule: Rule) -> Option<QuantityId> {
        let origin = if expression.reads.is_empty() {
            Origin::Literal
        } else {
            Origin::Expression { depends_on: expression.reads.iter().copied().map(QuantityId).collect() }
        };
        self.add_with_origin(entry, expression, rule, origin)
    }

    /// As [`NumberReader::add`], where the origin is known.
    pub fn add_with_origin(
        &mut self,
        entry: &Entry<'_>,
        expression: &Expression,
        rule: Rule,
        origin: Origin,
    ) -> Option<QuantityId> {
        let dimension = expression.dimension;
        let quantity = Quantity { path: entry.path.dotted(), dimension, rule, origin, span: Some(entry.span) };
        let id = if expression.reads.is_empty() {
            self.quantities.add_number(quantity, run(&expression.ops, &mut []))
        } else {
            self.quantities.add_expression(quantity, expression)
        };
        if let Err(problem) = self.quantities[id].check(self.quantities.nominal_value(id)) {
            return self.reader.refuse(&problem, entry.span);
        }
        Some(id)
    }

    /// A number that follows from others, at the place of the first of them.
    pub fn derived(
        &mut self,
        path: String,
        dimension: Dimension,
        rule: Rule,
        ops: Vec<Op>,
        reads: &[QuantityId],
    ) -> QuantityId {
        let expression = Expression { ops, dimension, reads: reads.iter().map(|id| id.0).collect() };
        let span = reads.first().and_then(|id| self.quantities[*id].span);
        let origin = Origin::Expression { depends_on: reads.to_vec() };
        self.quantities.add_expression(Quantity { path, dimension, rule, origin, span }, &expression)
    }

    /// Demands that one quantity be below another; reports at `span` if the values of the file do not obey.
    pub fn demand_order(&mut self, smaller: QuantityId, larger: QuantityId, span: Span) -> bool {
        let Err(problem) = self.quantities.demand_order(smaller, larger) else { return true };
        let mut diagnostic = Diagnostic::error(&problem, Some(self.reader.place(span)));
        if let Some(limit) = self.quantities[larger].span.filter(|limit| *limit != span) {
            diagnostic = diagnostic.with_label(self.reader.place(limit), "it must be below this");
        }
        self.reader.diagnostics.push(diagnostic);
        false
    }

    /// The table at an entry whose keys depend on its `kind`, and that kind.
    pub fn table_of_kind<'t>(
        &mut self,
        entry: &Entry<'t>,
        kinds: &[(&'static str, &'static Keys)],
    ) -> Option<(&'static str, Table<'t>)> {
        let choices: Vec<_> = kinds.iter().map(|&(kind, keys)| (kind, (kind, keys))).collect();
        let (kind, keys) = self.reader.tag(entry, "kind", &choices)?;
        Some((kind, self.reader.table(entry, keys)?))
    }

    /// Reports the first entry of a table that is one too many, `sizes` being keys, what their entries are called and how many there may be; true
    /// where there is one, and nothing is to be read. The ground is none of the bodies.
    pub fn refuses_sizes(&mut self, root: &Table<'_>, sizes: &[(&str, &'static str, usize)]) -> bool {
        let mut is_too_large = false;
        for &(key, what, most) in sizes {
            let Some(entry) = root.get(key).filter(Entry::is_table) else { continue };
            let entries = self.reader.any_keys(&entry);
            let counted: Vec<&Entry<'_>> = entries.iter().filter(|e| (key, e.name) != ("body", "ground")).collect();
            if let Some(surplus) = counted.get(most) {
                self.reader.report(&EntryProblem::TooMany { what, found: counted.len(), most }, surplus.key_span);
                is_too_large = true;
            }
        }
        is_too_large
    }

    /// Reports a key, where it is written, that means nothing beside another.
    pub fn refuse_beside(&mut self, table: &Table<'_>, key: &'static str, beside: &'static str) {
        if let Some(entry) = table.get(key) {
            let problem = EntryProblem::KeyWithoutEffect { entry: table.path.describe(), key, beside };
            self.reader.report(&problem, entry.key_span);
        }
    }

    /// Reports a key that needs others.
    pub fn report_missing(&mut self, table: &Table<'_>, key: &'static str, needs: Vec<&'static str>) {
        // A key that is not known may have been meant for it.
        if table.has_unknown() {
            return;
        }
        let hint = (self.hint_of_needs)(key, &needs);
        let problem = EntryProblem::NeedsKeys { entry: table.path.describe(), key, needs, hint };
        self.reader.report(&problem, table.get(key).map_or(table.span, |entry| entry.key_span));
    }

    /// The thing that `name` stands for in a list of names.
    pub fn named<T: Copy>(
        &mut self,
        entry: &Entry<'_>,
        what: &'static str,
        name: &str,
        list: &[(String, Option<T>)],
    ) -> Option<T> {
        let place = list.iter().position(|(known, _)| known == name);
        work::add(place.unwrap_or(list.len()));
        if let Some(place) = place {
            return list[place].1;
        }
        let known = list.iter().map(|(known, _)| format!("'{known}'")).collect();
        let nearest = nearest_name(name, list.iter().map(|(known, _)| known.as_str())).map(str::to_owned);
        self.unknown(entry, what, name, nearest, known);
        None
    }

    /// Reports a name that stands for nothing.
    pub fn unknown(
        &mut self,
        entry: &Entry<'_>,
        what: &'static str,
        name: &str,
        nearest: Option<String>,
        known: Vec<String>,
    ) {
        // What is meant may stand in a misspelt table, which has its diagnostic.
        if self.has_unknown_tables {
            return;
        }
        let problem = EntryProblem::UnknownReference {
            entry: entry.path.describe(),
            what,
            name: name.to_owned(),
            nearest,
            known,
        };
        self.reader.report(&problem, entry.span);
    }
}

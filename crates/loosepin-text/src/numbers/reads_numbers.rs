//! What reads a file whose numbers are quantities.

use super::quantity::QuantityId;
use super::reader::NumberReader;
use crate::diagnostics::Span;
use crate::document::{DefaultValue, Entry, EntryPath, Reads, Table, Value};
use crate::units::{Dimension, Op, Rule, parse_quantity};

/// Something that reads a file with a [`NumberReader`]. What returns nothing has reported.
pub trait ReadsNumbers: Reads {
    /// The reader of its numbers.
    fn numbers(&mut self) -> &mut NumberReader;

    /// See [`NumberReader::quantity_at`].
    fn quantity_at(&mut self, entry: &Entry<'_>) -> Option<QuantityId> {
        self.numbers().quantity_at(entry)
    }

    /// See [`NumberReader::quantity`].
    fn quantity(&mut self, table: &Table<'_>, key: &str) -> Option<QuantityId> {
        self.numbers().quantity(table, key)
    }

    /// See [`NumberReader::quantity_or`].
    fn quantity_or(&mut self, table: &Table<'_>, key: &'static str, default_si: f64) -> Option<QuantityId> {
        self.numbers().quantity_or(table, key, default_si)
    }

    /// See [`NumberReader::quantity_of`].
    fn quantity_of(&mut self, entry: &Entry<'_>, dimension: Dimension, rule: Rule) -> Option<QuantityId> {
        self.numbers().quantity_of(entry, dimension, rule)
    }

    /// See [`NumberReader::default_quantity`].
    fn default_quantity(&mut self, path: &EntryPath, dimension: Dimension, rule: Rule, default_si: f64) -> QuantityId {
        self.numbers().default_quantity(path, dimension, rule, default_si)
    }

    /// See [`NumberReader::derived`].
    fn derived(
        &mut self,
        path: String,
        dimension: Dimension,
        rule: Rule,
        ops: Vec<Op>,
        reads: &[QuantityId],
    ) -> QuantityId {
        self.numbers().derived(path, dimension, rule, ops, reads)
    }

    /// See [`NumberReader::report_missing`].
    fn report_missing(&mut self, table: &Table<'_>, key: &'static str, needs: Vec<&'static str>) {
        self.numbers().report_missing(table, key, needs);
    }

    /// See [`NumberReader::refuse_beside`].
    fn refuse_beside(&mut self, table: &Table<'_>, key: &'static str, beside: &'static str) {
        self.numbers().refuse_beside(table, key, beside);
    }

    /// See [`NumberReader::demand_order`].
    fn demand_order(&mut self, smaller: QuantityId, larger: QuantityId, span: Span) -> bool {
        self.numbers().demand_order(smaller, larger, span)
    }
}

impl<'t, R: ReadsNumbers + ?Sized> Value<'t, R> for QuantityId {
    fn read(reader: &mut R, entry: &Entry<'t>) -> Option<Self> {
        reader.quantity_at(entry)
    }
}

impl<'t, R: ReadsNumbers + ?Sized> DefaultValue<'t, R, &'static str> for QuantityId {
    fn default_value(reader: &mut R, table: &Table<'t>, key: &'static str, usual: &'static str) -> Option<Self> {
        let usual = parse_quantity(usual).expect("the description of a table states a value with a unit");
        reader.quantity_or(table, key, usual.value_si)
    }
}

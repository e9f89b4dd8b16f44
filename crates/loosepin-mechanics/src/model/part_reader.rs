//! Reader common to every kind of part: the part of the model's reader that all of them know.

use super::ids::{BodyId, JointId, PointId};
use loosepin_text::document::{DefaultValue, Entry, Table, Value};
use loosepin_text::numbers::{QuantityId, ReadsNumbers};

/// The reader of a model with the parts that stand above. What returns nothing has reported.
pub trait PartReader: ReadsNumbers {
    /// A point, written `body.point`.
    fn point(&mut self, entry: &Entry<'_>) -> Option<PointId>;

    /// A body.
    fn body(&mut self, entry: &Entry<'_>) -> Option<BodyId>;

    /// A joint, written `joint.NAME` or by its name alone.
    fn joint(&mut self, entry: &Entry<'_>) -> Option<JointId>;

    /// Name of a body.
    fn body_name(&self, body: BodyId) -> String;

    /// Name of a joint.
    fn joint_name(&self, joint: JointId) -> String;
}

/// A quantity, written or usual, that is read after others: quantities keep the order in which they are read.
pub enum DeferredQuantity<'t> {
    /// As the file has it.
    Written(Entry<'t>),
    /// Omitted from the table under this key, with its default value.
    DefaultValue(Table<'t>, &'static str, &'static str),
}

impl DeferredQuantity<'_> {
    /// Reads it; `None` after a diagnostic.
    pub fn quantity<R: PartReader + ?Sized>(&self, reader: &mut R) -> Option<QuantityId> {
        match self {
            Self::Written(entry) => reader.quantity_at(entry),
            Self::DefaultValue(table, key, usual) => QuantityId::default_value(reader, table, key, usual),
        }
    }
}

impl<'t, R: ?Sized> Value<'t, R> for DeferredQuantity<'t> {
    fn read(_reader: &mut R, entry: &Entry<'t>) -> Option<Self> {
        Some(Self::Written(entry.clone()))
    }
}

impl<'t, R: ?Sized> DefaultValue<'t, R, &'static str> for DeferredQuantity<'t> {
    fn default_value(_reader: &mut R, table: &Table<'t>, key: &'static str, usual: &'static str) -> Option<Self> {
        Some(Self::DefaultValue(table.clone(), key, usual))
    }
}

impl<'t, R: PartReader + ?Sized> Value<'t, R> for PointId {
    fn read(reader: &mut R, entry: &Entry<'t>) -> Option<Self> {
        reader.point(entry)
    }
}

impl<'t, R: PartReader + ?Sized> Value<'t, R> for JointId {
    fn read(reader: &mut R, entry: &Entry<'t>) -> Option<Self> {
        reader.joint(entry)
    }
}

impl<'t, R: PartReader + ?Sized> Value<'t, R> for BodyId {
    fn read(reader: &mut R, entry: &Entry<'t>) -> Option<Self> {
        reader.body(entry)
    }
}

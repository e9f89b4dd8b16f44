//! What every kind of part needs to read its table: the reader of the model, as far as all of them know it.

use super::ids::{BodyId, JointId, PointId};
use super::quantity::QuantityId;
use loosepin_text::document::{Entry, Reader, Table};

/// The reader of a model with the parts that stand above. What returns nothing has complained.
pub trait PartReader {
    /// The reader of the document, for tables in tables, choices and complaints.
    fn document(&mut self) -> &mut Reader;

    /// A point, written `body.point`.
    fn point(&mut self, entry: &Entry<'_>) -> Option<PointId>;

    /// A body.
    fn body(&mut self, entry: &Entry<'_>) -> Option<BodyId>;

    /// A joint, written `joint.NAME` or by its name alone.
    fn joint(&mut self, entry: &Entry<'_>) -> Option<JointId>;

    /// The quantity behind a key; `None` if it is not written.
    fn quantity(&mut self, table: &Table<'_>, key: &str) -> Option<QuantityId>;

    /// The same with a value where it is not written, SI.
    fn quantity_or(&mut self, table: &Table<'_>, key: &'static str, default_si: f64) -> Option<QuantityId>;

    /// Name of a body.
    fn body_name(&self, body: BodyId) -> String;

    /// Name of a joint.
    fn joint_name(&self, joint: JointId) -> String;
}

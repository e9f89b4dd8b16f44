//! Outputs of a model: what each kind reads off a position (`kind.rs`), and how a file says it (`table.rs`). Nothing else names a kind.

mod kind;
mod table;

pub use kind::ModelOutputKind;
pub(super) use kind::OutputValues;
pub(super) use table::SpatialOutputTable;

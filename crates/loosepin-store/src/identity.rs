//! The owner of the runs in a store.

/// What the runs of a store were made by and from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StoreIdentity {
    /// Version of the program: other versions may give other bits.
    pub version: String,
    /// Hash of everything that the runs are computed from.
    pub inputs: String,
}

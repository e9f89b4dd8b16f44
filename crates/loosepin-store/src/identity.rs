//! The owner of the runs in a store.

/// Program and inputs of the runs of a store.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StoreIdentity {
    /// Version of the program: other versions may give other bits.
    pub version: String,
    /// Hash of everything that the runs are computed from.
    pub inputs: String,
}

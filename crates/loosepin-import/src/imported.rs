//! What is made of a file of another program.

/// The text of a model, or its skeleton.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Imported {
    /// Text of `model.toml`.
    pub model: String,
    /// Findings in words, one sentence each.
    pub notes: Vec<String>,
}

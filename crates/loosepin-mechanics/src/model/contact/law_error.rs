//! Why a contact cannot have another law.

use loosepin_text::diagnostics::{Code, problems};

problems! {
    /// Why a contact cannot have a law.
    #[derive(Debug, Clone, PartialEq)]
    pub enum LawError {
        NeedsKey { law: &'static str, key: &'static str, table: String } => Code::LawNotPossible,
            says("{law} needs {key} of {table}, which the model does not give"),
            hint("add {key} to {table}, or remove {law}");
        /// A linear law beside others: its stiffness has another unit and stands in place of the materials.
        OtherStiffness { law: &'static str, beside: &'static str, table: String } => Code::LawNotPossible,
            says("{law} needs another kind of stiffness than {beside}, the law of {table} in the model"),
            hint("remove {law}, or use it in a separate model");
    }
}

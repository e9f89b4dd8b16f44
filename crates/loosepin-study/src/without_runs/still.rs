//! Warnings of outputs that never move.

use crate::written::input_file::InputFile;
use loosepin_mechanics::mechanism::Mechanism;
use loosepin_simulate::still_outputs;
use loosepin_text::diagnostics::Diagnostic;
use loosepin_text::document::describe_path;
use loosepin_text::plausible::ImplausibleNumber;

impl InputFile {
    /// Warnings of outputs of a planar model whose bodies stand still over the whole cycle. Empty where the mechanism cannot be moved, which is
    /// refused elsewhere.
    pub fn still_outputs(&self) -> Vec<Diagnostic> {
        let Some(model) = self.model().planar() else { return Vec::new() };
        let values = model.quantities.nominal();
        let Ok(mechanism) = Mechanism::new(model, &values) else { return Vec::new() };
        let warning = |output: usize| {
            let path = format!("output.{}", model.outputs[output].name);
            let problem = ImplausibleNumber::NeverMoves { entry: describe_path(&path) };
            Diagnostic::warning(&problem, model.place(&path))
        };
        still_outputs(&mechanism, &values).into_iter().map(warning).collect()
    }
}

//! Numbers under `[parameter]` that lack their unit: reported where they stand, not where they are used.

use super::parameters::Parameters;
use super::problem::EntryProblem;
use super::quantity::{Origin, QuantityId};
use super::reader::NumberReader;
use crate::diagnostics::Diagnostic;
use crate::document::{Entry, Written};
use crate::units::{Dimension, Names, parse_expression, referenced_names};
use std::collections::HashSet;

/// The parameters, those without a unit taken for something else.
struct Taken<'p> {
    parameters: &'p Parameters,
    names: &'p [String],
    dimension: Dimension,
}

impl Names for Taken<'_> {
    fn find(&self, name: &str) -> Option<(usize, Dimension)> {
        let (slot, dimension) = self.parameters.find(name)?;
        Some((slot, if self.names.iter().any(|taken| taken == name) { self.dimension } else { dimension }))
    }
    fn all(&self) -> Box<dyn Iterator<Item = &str> + '_> {
        self.parameters.all()
    }
    fn is_reported(&self, name: &str) -> bool {
        self.parameters.is_reported(name)
    }
}

impl NumberReader {
    /// Whether the text at an entry, which does not measure what is due, would measure it if numbers under `[parameter]` had units.
    /// Then these are reported, each once.
    pub(super) fn blames_parameter(&mut self, entry: &Entry<'_>, due: Dimension) -> bool {
        if !entry.is_text() {
            return false;
        }
        let Some(Written::Text(text)) = self.reader.written(entry) else { return false };
        let mut names = referenced_names(text);
        names.retain(|name| self.parameters.find(name).is_some_and(|(_, dimension)| dimension.is_number()));
        let slots = names.iter().filter_map(|name| self.parameters.find(name)).map(|(slot, _)| QuantityId(slot));
        let bare = self.bare_roots(slots.collect());
        let guesses = [due, Dimension::LENGTH, Dimension::ANGLE, Dimension::MASS, Dimension::TIME];
        let meant = guesses.into_iter().filter(|guess| !guess.is_number()).find(|&dimension| {
            let taken = Taken { parameters: &self.parameters, names: &names, dimension };
            parse_expression(text, &taken).is_ok_and(|expression| expression.dimension == due)
        });
        let Some(meant) = meant.filter(|_| !bare.is_empty()) else { return false };
        for id in bare {
            let name = self.quantities[id].path.trim_start_matches("parameter.").to_owned();
            if !self.parameters.blame(&name) {
                continue;
            }
            let problem = EntryProblem::ParameterWithoutUnit {
                name,
                value: self.quantities.nominal_value(id),
                entry: entry.path.describe(),
                due: meant,
            };
            let place = self.quantities[id].span.map(|span| self.reader.place(span));
            let diagnostic =
                Diagnostic::error(&problem, place).with_label(self.reader.place(entry.span), "it is used here");
            self.reader.diagnostics.push(diagnostic);
        }
        true
    }

    /// The numbers without a unit that are written under `[parameter]` and that these parameters follow, themselves if they are some.
    fn bare_roots(&self, mut waiting: Vec<QuantityId>) -> Vec<QuantityId> {
        let (mut bare, mut seen) = (Vec::new(), HashSet::new());
        while let Some(id) = waiting.pop() {
            let quantity = &self.quantities[id];
            if !quantity.dimension.is_number() || !seen.insert(id) {
                continue;
            }
            match &quantity.origin {
                Origin::Expression { depends_on } => waiting.extend(depends_on),
                Origin::Literal => bare.push(id),
                Origin::Default | Origin::Fixed => {}
            }
        }
        bare.sort();
        bare
    }
}

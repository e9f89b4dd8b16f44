//! Warnings of values that are set from outside.

use super::Implausible;
use crate::diagnostics::{Diagnostic, Place, Source};
use crate::numbers::{QuantityId, QuantityTable};

/// Warnings of what is implausible under `settings` (`path=value`) and was not so in the file, each at the setting that is to blame, else at
/// the `place` of its path in the file.
pub fn warnings_of_settings(
    quantities: &QuantityTable,
    settings: &[(QuantityId, &str)],
    in_file: &[Implausible],
    when_set: &[Implausible],
    place: impl Fn(&str) -> Option<Place>,
) -> Vec<Diagnostic> {
    let of_setting = |path: &str| {
        let id = quantities.id(path)?;
        let roots = quantities.roots(id);
        let (_, text) = settings.iter().find(|(set, _)| *set == id || roots.contains(set))?;
        Some(Place::new(&Source::new("--set", *text), 0..text.len()))
    };
    let new = when_set.iter().filter(|found| !in_file.contains(found));
    new.map(|(path, problem)| Diagnostic::warning(problem, of_setting(path).or_else(|| place(path)))).collect()
}

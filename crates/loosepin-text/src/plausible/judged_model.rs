//! Warnings of the numbers of a model, in its file and as they are set from outside: once for all kinds of models.

use super::{Implausible, ImplausibleNumber, JudgedNumbers};
use crate::diagnostics::{Diagnostic, Place, Source};
use crate::document::describe_path;
use crate::numbers::{Origin, QuantityId, QuantityTable, Values};

/// A model whose numbers are judged.
pub trait JudgedModel {
    /// Its quantities.
    fn quantities(&self) -> &QuantityTable;
    /// The text of its file.
    fn source(&self) -> &Source;
    /// Where the entry of a path stands, or the nearest table above it.
    fn place(&self, path: &str) -> Option<Place>;
    /// What is hardly possible at these values.
    fn implausible_at(&self, judged: &JudgedNumbers<'_>) -> Vec<Implausible>;
    /// Outputs that are read off a body as it is seen from the ground: their names, and the numbers of the bodies.
    fn bodies_of_outputs(&self) -> Vec<(&str, usize)>;
    /// Numbers of bodies that a joint holds rigidly together, 0 the ground.
    fn rigid_pairs(&self) -> Vec<[usize; 2]>;

    /// Warnings of outputs whose bodies stand still; `moved` says of each body, the ground first, whether it moves over the cycle.
    fn never_moving(&self, mut moved: Vec<bool>) -> Vec<Diagnostic> {
        // Where nothing moves, a structure is meant.
        if !moved.contains(&true) {
            return Vec::new();
        }
        count_mounts_as_moving(&mut moved, &self.rigid_pairs());
        let outputs = self.bodies_of_outputs().into_iter();
        let still = outputs.filter(|(_, body)| *body != 0 && !moved[*body]);
        let warning = |(output, _): (&str, usize)| {
            let path = format!("output.{output}");
            Diagnostic::warning(&ImplausibleNumber::NeverMoves { entry: describe_path(&path) }, self.place(&path))
        };
        still.map(warning).collect()
    }

    /// Warnings of numbers that are hardly possible, at the values of the file.
    fn implausible_numbers(&self) -> Vec<Diagnostic> {
        let found = implausible_in_file(self);
        found.iter().map(|(path, problem)| Diagnostic::warning(problem, self.place(path))).collect()
    }

    /// Warnings of what is hardly possible under `settings` (`path=value`) and was not so in the file, each at the setting that is to blame,
    /// else at the place of its path in the file; `values` are those under the settings.
    fn implausible_settings(&self, settings: &[(QuantityId, &str)], values: &Values) -> Vec<Diagnostic> {
        if settings.is_empty() {
            return Vec::new();
        }
        let set = |id: QuantityId| settings.iter().find(|(set, _)| *set == id).map(|(_, text)| *text);
        let written = |id: QuantityId| match set(id) {
            Some(text) => text.split_once('=').map(|(_, value)| value.trim().to_owned()),
            None => written_in_file(self, id),
        };
        let when_set = self.implausible_at(&JudgedNumbers { quantities: self.quantities(), values, written: &written });
        let in_file = implausible_in_file(self);
        let of_setting = |path: &str| {
            let id = self.quantities().id(path)?;
            let roots = self.quantities().roots(id);
            let (_, text) = settings.iter().find(|(set, _)| *set == id || roots.contains(set))?;
            Some(Place::new(&Source::new("--set", *text), 0..text.len()))
        };
        let new = when_set.iter().filter(|found| !in_file.contains(found));
        new.map(|(path, problem)| Diagnostic::warning(problem, of_setting(path).or_else(|| self.place(path)))).collect()
    }
}

/// What hangs on the ground by rigid joints alone is a part of it, and is meant to stand still.
fn count_mounts_as_moving(moved: &mut [bool], rigid_pairs: &[[usize; 2]]) {
    let mut is_ground = vec![false; moved.len()];
    is_ground[0] = true;
    while let Some([first, second]) = rigid_pairs.iter().find(|[a, b]| is_ground[*a] != is_ground[*b]) {
        let body = if is_ground[*first] { *second } else { *first };
        (is_ground[body], moved[body]) = (true, true);
    }
}

fn implausible_in_file(model: &(impl JudgedModel + ?Sized)) -> Vec<Implausible> {
    let (values, written) = (model.quantities().nominal(), |id| written_in_file(model, id));
    model.implausible_at(&JudgedNumbers { quantities: model.quantities(), values: &values, written: &written })
}

/// How a number is written in the file, where it is written as it is.
fn written_in_file(model: &(impl JudgedModel + ?Sized), id: QuantityId) -> Option<String> {
    let quantity = &model.quantities()[id];
    let span = quantity.span.filter(|_| quantity.origin == Origin::Literal)?;
    let source = model.source();
    Some(source.text().get(source.clamp(span))?.trim_matches(['"', '\'']).to_owned())
}

//! Files of models in space that do not say so: read as planar ones they would have an error in nearly every line.

use super::problem::SpatialModelProblem;
use loosepin_text::diagnostics::{Diagnostics, Place, Source, Span};
use loosepin_text::document::{describe_path, parse_toml};
use std::sync::Arc;

/// Coordinates of a point in space.
const COORDINATES: usize = 3;

/// Refuses a file without the key `geometry` that has what only models in space have: points with three coordinates, or axes of a body. All else
/// that is wrong with a planar model follows from that.
///
/// # Errors
/// [`SpatialModelProblem::NoGeometry`] at the first such entry.
pub fn refuse_without_geometry(source: &Arc<Source>) -> Result<(), Diagnostics> {
    let Some((path, what, span)) = first_of_space(source) else { return Ok(()) };
    let problem = SpatialModelProblem::NoGeometry { entry: describe_path(&path), what };
    Err(Diagnostics::one(&problem, Some(Place::new(source, span))))
}

fn first_of_space(source: &Arc<Source>) -> Option<(String, &'static str, Span)> {
    let toml = parse_toml(source).ok()?;
    let root = toml.get_ref();
    if root.contains_key("geometry") {
        return None;
    }
    let mut first: Option<(String, &'static str, Span)> = None;
    let mut note = |path: String, what: &'static str, span: Span| {
        if first.as_ref().is_none_or(|(_, _, known)| span.start < known.start) {
            first = Some((path, what, span));
        }
    };
    for (body, value) in root.get("body")?.get_ref().as_table()? {
        let Some(table) = value.get_ref().as_table() else { continue };
        let body = body.get_ref();
        if let Some((key, _)) = table.get_key_value("axes") {
            note(format!("body.{body}.axes"), "gives axes", key.span().into());
        }
        let points = table.get("points").and_then(|points| points.get_ref().as_table());
        for (point, value) in points.into_iter().flatten() {
            if value.get_ref().as_array().is_some_and(|numbers| numbers.len() == COORDINATES) {
                note(format!("body.{body}.points.{}", point.get_ref()), "has three coordinates", value.span().into());
            }
        }
    }
    first
}

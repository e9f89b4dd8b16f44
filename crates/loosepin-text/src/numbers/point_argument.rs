//! Points that a command or a call names: `--path coupler.tool`.

use super::problem::EntryProblem;
use crate::diagnostics::{Diagnostic, Diagnostics, Place, Source, nearest_name};

/// The argument that names points whose paths are recorded.
const PATH: &str = "--path";

/// A body, and its points in their order.
pub struct NamedPoints<'m> {
    /// Name of the body.
    pub body: &'m str,
    /// Names of its points.
    pub points: Vec<&'m str>,
}

/// The points called `names`, each `BODY.POINT`, as the numbers of body and point; a second mention of one counts once.
///
/// # Errors
/// A diagnostic for each name that is no point of the `bodies`, with the nearest one; its place is in the name.
pub fn points_of_paths(names: &[String], bodies: &[NamedPoints<'_>]) -> Result<Vec<[usize; 2]>, Diagnostics> {
    let mut diagnostics = Diagnostics::new();
    let mut points = Vec::new();
    for name in names {
        match point_called(name, bodies) {
            Ok(point) if points.contains(&point) => {}
            Ok(point) => points.push(point),
            Err(problem) => diagnostics.push(Diagnostic::error(&problem, Some(place_in_path_argument(name)))),
        }
    }
    if diagnostics.is_empty() { Ok(points) } else { Err(diagnostics) }
}

/// Where the argument names a point.
pub fn place_in_path_argument(name: &str) -> Place {
    Place::new(&Source::new(PATH, name), 0..name.len())
}

fn point_called(name: &str, bodies: &[NamedPoints<'_>]) -> Result<[usize; 2], EntryProblem> {
    let entry = PATH.to_owned();
    let Some((body_name, point_name)) = name.split_once('.') else {
        return Err(EntryProblem::NotAPoint { entry, text: name.to_owned() });
    };
    let whole_names = |own: &NamedPoints<'_>| -> Vec<String> {
        own.points.iter().map(|point| format!("{}.{point}", own.body)).collect()
    };
    let (nearest, known) = match bodies.iter().position(|own| own.body == body_name) {
        Some(body) => {
            let own = &bodies[body];
            if let Some(point) = own.points.iter().position(|own| *own == point_name) {
                return Ok([body, point]);
            }
            let nearest = nearest_name(point_name, own.points.iter().copied());
            (nearest.map(|nearest| format!("{body_name}.{nearest}")), whole_names(own))
        }
        None => {
            let all: Vec<String> = bodies.iter().flat_map(whole_names).collect();
            (nearest_name(name, all.iter().map(String::as_str)).map(str::to_owned), all)
        }
    };
    let known = known.iter().map(|own| format!("'{own}'")).collect();
    Err(EntryProblem::UnknownReference { entry, what: "point", name: name.to_owned(), nearest, known })
}

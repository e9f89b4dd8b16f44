//! Points that a command or a call names: `--path coupler.tool`.

use crate::model::ids::{BodyId, PointId};
use crate::model::parts::topology::Model;
use crate::model::problem::ModelProblem;
use crate::model::words::part_names::PartNames;
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Place, Source, nearest_name};

/// The argument that names points whose paths are recorded.
const PATH: &str = "--path";

impl Model {
    /// The points called `names`, each `BODY.POINT`; a second mention of one counts once.
    ///
    /// # Errors
    /// A diagnostic for each name that is no point of the model, with the nearest one; its place is in the name.
    pub fn points_of_paths(&self, names: &[String]) -> Result<Vec<PointId>, Diagnostics> {
        let mut diagnostics = Diagnostics::new();
        let mut points = Vec::new();
        for name in names {
            match self.point_called(name) {
                Ok(point) if points.contains(&point) => {}
                Ok(point) => points.push(point),
                Err(problem) => {
                    let source = Source::new(PATH, name);
                    diagnostics.push(Diagnostic::error(&problem, Some(Place::new(&source, 0..name.len()))));
                }
            }
        }
        if diagnostics.is_empty() { Ok(points) } else { Err(diagnostics) }
    }

    fn point_called(&self, name: &str) -> Result<PointId, ModelProblem> {
        let points = || {
            let of_body = |(body, entry): (usize, &crate::model::parts::topology::Body)| {
                (0..entry.points.len()).map(move |point| PointId { body: BodyId(body), point })
            };
            self.bodies.iter().enumerate().flat_map(of_body)
        };
        if let Some(point) = points().find(|point| self.point(*point) == name) {
            return Ok(point);
        }
        let entry = PATH.to_owned();
        if !name.contains('.') {
            return Err(ModelProblem::NotAPoint { entry, text: name.to_owned() });
        }
        let names: Vec<String> = points().map(|point| self.point(point)).collect();
        let nearest = nearest_name(name, names.iter().map(String::as_str)).map(str::to_owned);
        // Of a body that there is, its points are meant.
        let body = name.split_once('.').map(|(body, _)| format!("{body}.")).unwrap_or_default();
        let has_body = names.iter().any(|own| own.starts_with(&body));
        let known =
            names.iter().filter(|own| !has_body || own.starts_with(&body)).map(|own| format!("'{own}'")).collect();
        Err(ModelProblem::UnknownReference { entry, what: "point", name: name.to_owned(), nearest, known })
    }
}

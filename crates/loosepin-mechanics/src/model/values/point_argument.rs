//! Points that a command or a call names: `--path coupler.tool`.

use crate::model::ids::{BodyId, PointId};
use crate::model::parts::topology::{Body, Model};
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Place, Source, nearest_name};
use loosepin_text::numbers::EntryProblem;

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

    fn point_called(&self, name: &str) -> Result<PointId, EntryProblem> {
        let entry = PATH.to_owned();
        let Some((body_name, point_name)) = name.split_once('.') else {
            return Err(EntryProblem::NotAPoint { entry, text: name.to_owned() });
        };
        let unknown = |nearest: Option<String>, known: Vec<String>| EntryProblem::UnknownReference {
            entry: entry.clone(),
            what: "point",
            name: name.to_owned(),
            nearest,
            known,
        };
        if let Some(body) = self.bodies.iter().position(|body| body.name == body_name) {
            let names = || self.bodies[body].points.iter().map(|point| point.name.as_str());
            let Some(point) = names().position(|own| own == point_name) else {
                let nearest = nearest_name(point_name, names()).map(|nearest| format!("{body_name}.{nearest}"));
                return Err(unknown(nearest, names().map(|own| format!("'{body_name}.{own}'")).collect()));
            };
            return Ok(PointId { body: BodyId(body), point });
        }
        let of_body = |body: &Body| -> Vec<String> {
            body.points.iter().map(|point| format!("{}.{}", body.name, point.name)).collect()
        };
        let all: Vec<String> = self.bodies.iter().flat_map(of_body).collect();
        let nearest = nearest_name(name, all.iter().map(String::as_str)).map(str::to_owned);
        Err(unknown(nearest, all.iter().map(|own| format!("'{own}'")).collect()))
    }
}

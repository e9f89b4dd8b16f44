//! Points that a command or a call names: `--path coupler.tool`.

use crate::model::ids::{BodyId, PointId};
use crate::model::parts::topology::Model;
use loosepin_text::diagnostics::Diagnostics;
use loosepin_text::numbers::{NamedPoints, points_of_paths};

impl Model {
    /// The points called `names`, each `BODY.POINT`; a second mention of one counts once.
    ///
    /// # Errors
    /// As for [`points_of_paths`].
    pub fn points_of_paths(&self, names: &[String]) -> Result<Vec<PointId>, Diagnostics> {
        let bodies = self.bodies.iter().map(|body| NamedPoints {
            body: &body.name,
            points: body.points.iter().map(|point| point.name.as_str()).collect(),
        });
        let points = points_of_paths(names, &bodies.collect::<Vec<_>>())?;
        Ok(points.into_iter().map(|[body, point]| PointId { body: BodyId(body), point }).collect())
    }
}

//! Outputs for points that a command names: `--path coupler.tool`.

use super::{Motion, Output, OutputKind, PointPath, Position, Relative};
use crate::model::ids::{Axis, PointId};
use crate::model::parts::topology::Model;
use crate::model::words::part_names::PartNames;
use loosepin_text::diagnostics::Diagnostics;
use loosepin_text::units::ReadableUnit;

impl Model {
    /// The model with the paths of the points called `names` among its outputs, and with the velocities and accelerations of these
    /// points: those that no output is yet, behind all others. Their names are those of their points: `coupler.tool velocity x`.
    ///
    /// # Errors
    /// As for [`Model::points_of_paths`].
    pub fn with_paths(&self, names: &[String]) -> Result<Model, Diagnostics> {
        let points = self.points_of_paths(names)?;
        let mut model = self.clone();
        for point in &points {
            let name = model.name_of_path(*point);
            let seen = Relative::to_ground(*point);
            let mut add = |suffix: &str, kind: OutputKind| {
                if model.outputs.iter().all(|own| own.kind != kind) {
                    let unit = ReadableUnit::default_for(kind.dimension());
                    model.outputs.push(Output { name: format!("{name}{suffix}"), kind, unit });
                }
            };
            add("", OutputKind::PointPath(PointPath { point: seen }));
            for (what, of) in
                [(" velocity", Motion::velocity as fn(Position) -> Motion), (" acceleration", Motion::acceleration)]
            {
                for (axis, letter) in [(Axis::X, "x"), (Axis::Y, "y")] {
                    add(&format!("{what} {letter}"), OutputKind::Motion(of(Position::Point(seen, axis))));
                }
            }
        }
        model.asked_paths = points;
        Ok(model)
    }

    /// The name of the output that is the path of a point, or of the point.
    fn name_of_path(&self, point: PointId) -> String {
        let is_own = |own: &&Output| own.kind.path() == Some(Relative::to_ground(point));
        self.outputs.iter().find(is_own).map_or_else(|| self.point(point), |own| own.name.clone())
    }
}

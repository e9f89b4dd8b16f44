//! Numbers of a model in space that are allowed and hardly possible.

use super::parts::SpatialModel;
use loosepin_text::diagnostics::{Place, Source};
use loosepin_text::numbers::{QuantityTable, Values};
use loosepin_text::plausible::{Implausible, JudgedModel, JudgedNumbers};

impl JudgedModel for SpatialModel {
    fn quantities(&self) -> &QuantityTable {
        &self.quantities
    }

    fn source(&self) -> &Source {
        &self.source
    }

    fn place(&self, path: &str) -> Option<Place> {
        self.place(path)
    }

    fn implausible_at(&self, judged: &JudgedNumbers<'_>) -> Vec<Implausible> {
        let mut found = judged.by_key();
        let extent_m = self.largest_extent_m(judged.values);
        for joint in &self.joints {
            let radius = self.quantities.id(&format!("joint.{}.bearing_radius", joint.name));
            let [radial, axial] = joint.play.map_or([None; 2], |play| play.clearances_m());
            for (clearance, radius) in [(radial, radius), (axial, None)] {
                let Some(clearance) = clearance else { continue };
                found.extend(judged.clearance(self.quantities[clearance].path.clone(), clearance, radius, extent_m));
            }
        }
        found
    }

    fn bodies_of_outputs(&self) -> Vec<(&str, usize)> {
        self.outputs.iter().map(|output| (output.name.as_str(), output.kind.body())).collect()
    }

    fn rigid_pairs(&self) -> Vec<[usize; 2]> {
        let rigid = self.joints.iter().filter(|joint| joint.kind.freedoms() == 0);
        rigid.map(|joint| [joint.bearing.point.body, joint.journal.point.body]).collect()
    }
}

impl SpatialModel {
    /// The largest coordinate of a point in the frame of its body, m: the scale of the mechanism.
    pub fn largest_extent_m(&self, values: &Values) -> f64 {
        let points = self.bodies.iter().flat_map(|body| &body.points);
        points.flat_map(|point| point.position_m).map(|id| values[id].abs()).fold(0.0, f64::max)
    }
}

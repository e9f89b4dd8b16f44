//! Numbers of a model in space that are allowed and hardly possible.

use super::parts::SpatialModel;
use loosepin_text::diagnostics::Diagnostic;
use loosepin_text::numbers::{Origin, QuantityId, Values};
use loosepin_text::plausible::{Implausible, JudgedNumbers, warnings_of_settings};

impl SpatialModel {
    /// Warnings of numbers that are hardly possible, at the values of the file.
    pub(super) fn implausible_numbers(&self) -> Vec<Diagnostic> {
        let found = self.implausible_in_file();
        found.iter().map(|(path, problem)| Diagnostic::warning(problem, self.place(path))).collect()
    }

    /// Warnings of what is hardly possible under settings `path=value`, and was not so in the file; `values` are those under them.
    pub fn implausible_settings(&self, settings: &[(QuantityId, &str)], values: &Values) -> Vec<Diagnostic> {
        if settings.is_empty() {
            return Vec::new();
        }
        let written = |id: QuantityId| match settings.iter().find(|(set, _)| *set == id) {
            Some((_, text)) => text.split_once('=').map(|(_, value)| value.trim().to_owned()),
            None => self.written(id),
        };
        let when_set = self.implausible_at(values, &written);
        let in_file = self.implausible_in_file();
        warnings_of_settings(&self.quantities, settings, &in_file, &when_set, |path| self.place(path))
    }

    fn implausible_in_file(&self) -> Vec<Implausible> {
        self.implausible_at(&self.quantities.nominal(), &|id| self.written(id))
    }

    /// How a number is written in the file, where it is written as it is.
    fn written(&self, id: QuantityId) -> Option<String> {
        let quantity = &self.quantities[id];
        let span = quantity.span.filter(|_| quantity.origin == Origin::Literal)?;
        Some(self.source.text().get(self.source.clamp(span))?.trim_matches(['"', '\'']).to_owned())
    }

    fn implausible_at(&self, values: &Values, written: &dyn Fn(QuantityId) -> Option<String>) -> Vec<Implausible> {
        let judged = JudgedNumbers { quantities: &self.quantities, values, written };
        let mut found = judged.by_key();
        let extent_m = self.largest_extent_m(values);
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

    /// The largest coordinate of a point in the frame of its body, m: the scale of the mechanism.
    pub fn largest_extent_m(&self, values: &Values) -> f64 {
        let points = self.bodies.iter().flat_map(|body| &body.points);
        points.flat_map(|point| point.position_m).map(|id| values[id].abs()).fold(0.0, f64::max)
    }
}

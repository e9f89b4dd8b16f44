//! Bodies with their points and axes.

use super::direction::{Direction, LENGTHS};
use super::parts::{ModelBody, ModelPoint};
use super::problem::SpatialModelProblem;
use super::reader::{NAMED_AXIS, SpaceReader};
use loosepin_text::document::{Entry, Kind, quantity};
use loosepin_text::numbers::{QuantityId, ReadsNumbers};
use loosepin_text::record;
use loosepin_text::units::{Dimension as D, Rule};

/// Keys of the plane that bodies in space do not have yet.
const PLANNED: &[(&str, &str)] = &[
    ("beam", "bodies in space are rigid; flexible links are known in planar models"),
    ("thermal_expansion", "warm parts are known in planar models"),
];

record! {
    /// the ground: points and axes that do not move
    pub(super) struct SpatialGroundTable for ReadsNumbers, planned PLANNED;
    /// named points in the frame of the ground
    optional points: Entry<'t> = Kind::Values(&LENGTHS), "{ o = [\"0 mm\", \"100 mm\", \"120 mm\"] }";
    /// named axes in the frame of the ground: x, y, z, three numbers or expressions, or from one point to another
    optional axes: Entry<'t> = Kind::Values(&NAMED_AXIS), "{ hinge = [0.6, 0.8, 0] }";
}

record! {
    /// a rigid body in space
    pub(super) struct SpatialBodyTable for ReadsNumbers, planned PLANNED;
    /// mass; checked, and not used yet
    optional mass: QuantityId = quantity(D::MASS, Rule::Positive), "\"0.3 kg\"";
    /// centre of mass in the frame of the body; not used yet
    optional centre_of_mass: Entry<'t> = LENGTHS, "[\"25 mm\", \"0 mm\", \"0 mm\"]";
    /// moments of inertia about the centre of mass, xx, yy, zz, and xy, xz, yz where the axes of the frame are not principal axes; checked, and
    /// not used yet
    optional inertia: Entry<'t> =
        Kind::List(&quantity(D::INERTIA, Rule::Finite)), "[\"1e-4 kg m^2\", \"2e-4 kg m^2\", \"2e-4 kg m^2\"]";
    /// named points in the frame of the body
    optional points: Entry<'t> = Kind::Values(&LENGTHS), "{ pin = [\"50 mm\", \"0 mm\", \"0 mm\"] }";
    /// named axes in the frame of the body: x, y, z, three numbers or expressions, or from one point to another
    optional axes: Entry<'t> = Kind::Values(&NAMED_AXIS), "{ hinge = { from = \"a\", to = \"b\" } }";
}

impl SpaceReader {
    /// Reads the table of bodies.
    pub fn read_bodies(&mut self, entry: &Entry<'_>) {
        for entry in self.numbers.reader.named(entry, "a body") {
            self.numbers.remember(&entry);
            if entry.name == "ground" {
                if let Some(own) = SpatialGroundTable::read(self, &entry) {
                    self.points_and_axes(0, &own.points, &own.axes);
                }
                continue;
            }
            let number = self.bodies.len();
            self.bodies.push(ModelBody {
                name: entry.name.to_owned(),
                mass_kg: None,
                centre_of_mass_m: None,
                inertia_kg_m2: Vec::new(),
                points: Vec::new(),
                axes: Vec::new(),
            });
            // A body that could not be read keeps its name, so that joints are not reported as well.
            let Some(own) = SpatialBodyTable::read(self, &entry) else {
                self.without_points.insert(number);
                continue;
            };
            let centre = own.centre_of_mass.as_ref().and_then(|entry| self.numbers.three(entry, D::LENGTH));
            let inertia = own.inertia.as_ref().and_then(|entry| self.inertia(entry)).unwrap_or_default();
            if let Some(body) = self.bodies.get_mut(number) {
                (body.mass_kg, body.centre_of_mass_m, body.inertia_kg_m2) = (own.mass, centre, inertia);
            }
            self.points_and_axes(number, &own.points, &own.axes);
        }
    }

    fn points_and_axes(&mut self, body: usize, points: &Option<Entry<'_>>, axes: &Option<Entry<'_>>) {
        for entry in points.iter().flat_map(|points| self.numbers.reader.named(points, "a point")).collect::<Vec<_>>() {
            self.numbers.remember(&entry);
            match self.numbers.three(&entry, D::LENGTH) {
                Some(position_m) => {
                    let point = ModelPoint { name: entry.name.to_owned(), position_m };
                    self.bodies[body].points.push(point);
                }
                None => {
                    self.without_points.insert(body);
                }
            }
        }
        for entry in axes.iter().flat_map(|axes| self.numbers.reader.named(axes, "an axis")).collect::<Vec<_>>() {
            self.numbers.remember(&entry);
            if Direction::from_word(entry.name).is_some() {
                let problem =
                    SpatialModelProblem::AxisName { entry: entry.path.describe(), name: entry.name.to_owned() };
                self.numbers.reader.report(&problem, entry.key_span);
            } else if let Some(direction) = self.named_axis(&entry, body) {
                self.bodies[body].axes.push((entry.name.to_owned(), direction));
            }
        }
    }

    /// Moments of inertia, three or six.
    fn inertia(&mut self, entry: &Entry<'_>) -> Option<Vec<QuantityId>> {
        let elements = self.numbers.reader.list(entry)?;
        if ![3, 6].contains(&elements.len()) {
            let problem = SpatialModelProblem::InertiaCount { entry: entry.path.describe(), found: elements.len() };
            return self.numbers.reader.refuse(&problem, entry.span);
        }
        let mut ids = Vec::new();
        for (mut element, name) in elements.into_iter().zip(["xx", "yy", "zz", "xy", "xz", "yz"]) {
            element.path = entry.path.join(name);
            ids.push(self.numbers.quantity_of(&element, D::INERTIA, Rule::Finite)?);
        }
        let value = |number: usize| ids.get(number).map_or(0.0, |id| self.numbers.quantities.nominal_value(*id));
        if !is_inertia([0, 1, 2, 3, 4, 5].map(value)) {
            let problem = SpatialModelProblem::NotAnInertia { entry: entry.path.describe() };
            return self.numbers.reader.refuse(&problem, entry.span);
        }
        Some(ids)
    }
}

/// Share of the largest moment by which a principal moment may exceed the sum of the other two: those of a flat body are equal to it, but for
/// round-off.
const ROUND_OFF: f64 = 1e-9;

/// Whether xx, yy, zz, xy, xz, yz are moments of inertia of a body: positive definite, and ½ tr(I) - I, the second moments of its mass, has no
/// negative eigenvalue, which is the triangle inequality of the principal moments.
pub fn is_inertia([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> bool {
    let determinant = |[a, b, c, d, e, f]: [f64; 6]| a * (b * c - f * f) - d * (d * c - f * e) + e * (d * f - b * e);
    let own = [xx, yy, zz, xy, xz, yz];
    let is_definite = xx > 0.0 && xx * yy - xy * xy > 0.0 && determinant(own) > 0.0;
    let half = 0.5 * (xx + yy + zz);
    let size = half * ROUND_OFF;
    let [a, b, c] = [half - xx, half - yy, half - zz].map(|moment| moment + size);
    let minors = [a, b, c, a * b - xy * xy, a * c - xz * xz, b * c - yz * yz, determinant([a, b, c, -xy, -xz, -yz])];
    is_definite && minors.iter().all(|minor| *minor >= 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_inertias_of_turned_bodies() {
        // Principal moments 1, 2, 3 (a flat body), turned by 0.3 rad about z, then axes x and y mix.
        let (sine, cosine) = 0.3_f64.sin_cos();
        let turned = |a: f64, b: f64, c: f64| {
            [
                a * cosine * cosine + b * sine * sine,
                a * sine * sine + b * cosine * cosine,
                c,
                (a - b) * sine * cosine,
                0.0,
                0.0,
            ]
        };
        assert!(is_inertia(turned(1.0, 2.0, 3.0)));
        assert!(is_inertia(turned(2.0, 2.0, 1e-3)));
        // Beyond the sum of the others by 1 %, below it by as much.
        assert!(!is_inertia(turned(1.0, 2.0, 3.03)) && is_inertia(turned(1.0, 2.0, 2.97)));
        assert!(!is_inertia(turned(1.0, -2.0, 1.0)) && !is_inertia([0.0; 6]) && !is_inertia([f64::NAN; 6]));
    }
}

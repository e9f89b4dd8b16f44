//! Masses: `<inertial>`, or those of the geoms of a body.

use super::compiler::{Compiler, chosen};
use super::defaults::Styled;
use super::orientation::{frame, z_axis};
use crate::robot::description::Inertial;
use crate::robot::problem::RobotProblem;
use crate::robot::turns::turned_inertia;
use crate::robot::xml::Element;
use loosepin_space::{Frame, Vec3};
use loosepin_text::diagnostics::Diagnostics;
use std::f64::consts::PI;

/// Density of a geom that has none, kg/m³: that of water.
const DENSITY: f64 = 1000.0;

/// Reads `<inertial>`: principal moments in its own frame, or all six in that of the body.
pub(super) fn of_inertial(element: Element<'_>, around: &Frame, compiler: &Compiler) -> Result<Inertial, Diagnostics> {
    let own = frame(|name| element.attribute(name), compiler)?;
    let mass_kg = element.required_attribute("mass")?.number()?;
    let moments = match (element.attribute("fullinertia"), element.attribute("diaginertia")) {
        (Some(full), Some(_)) => {
            let (one, other) = ("fullinertia", "diaginertia");
            return Err(full.error(&RobotProblem::Together { element: full.of(), one, other }));
        }
        // In the order of a model: xx, yy, zz, xy, xz, yz.
        (Some(full), None) => full.numbers()?,
        (None, Some(diagonal)) => {
            let [xx, yy, zz] = diagonal.numbers()?;
            [xx, yy, zz, 0.0, 0.0, 0.0]
        }
        (None, None) => return Err(missing(element, "attribute 'diaginertia' or 'fullinertia'")),
    };
    let in_body = around.compose(&own);
    Ok(Inertial { mass_kg, centre_m: in_body.origin_m, inertia_kg_m2: turned_inertia(&in_body.axes, moments) })
}

fn missing(element: Element<'_>, what: &str) -> Diagnostics {
    element.error(&RobotProblem::Missing { element: element.words(), what: what.to_owned() })
}

/// A shape that has a volume of its own.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Solid {
    Sphere,
    Capsule,
    Ellipsoid,
    Cylinder,
    Box,
}

/// What types of geoms are: a solid, a shape without mass, or one of which only its file knows the mass.
const TYPES: [(&str, Option<Solid>); 9] = [
    ("sphere", Some(Solid::Sphere)),
    ("capsule", Some(Solid::Capsule)),
    ("ellipsoid", Some(Solid::Ellipsoid)),
    ("cylinder", Some(Solid::Cylinder)),
    ("box", Some(Solid::Box)),
    ("plane", None),
    ("hfield", None),
    ("mesh", None),
    ("sdf", None),
];

/// Mass of a geom in the frame of its body; `None` where only a mesh knows it. The mass may be zero.
pub(super) fn of_geom(
    geom: &Styled<'_, '_>,
    around: &Frame,
    compiler: &Compiler,
) -> Result<Option<Inertial>, Diagnostics> {
    let kind = match geom.attribute("type") {
        Some(own) => chosen(&own, "type", &TYPES)?,
        None => Some(Solid::Sphere),
    };
    let given_mass_kg = geom.attribute("mass").map(|own| own.number()).transpose()?;
    let density = geom.attribute("density").map_or(Ok(DENSITY), |own| own.number())?;
    if given_mass_kg == Some(0.0) || (given_mass_kg.is_none() && density == 0.0) {
        let none = Inertial { mass_kg: 0.0, centre_m: Vec3::ZERO, inertia_kg_m2: [0.0; 6] };
        return Ok(Some(none));
    }
    let is_shell = geom.attribute("shellinertia").is_some_and(|own| own.text == "true");
    // A geom that shows a mesh by a solid is fitted to it.
    let is_fitted = geom.element.attribute("mesh").is_some();
    let Some(solid) = kind.filter(|_| !is_shell && !is_fitted) else { return Ok(None) };
    let (own, sizes) = placed(geom, solid, compiler)?;
    let (volume_m3, per_mass) = of_solid(solid, sizes);
    let mass_kg = given_mass_kg.unwrap_or(density * volume_m3);
    let [xx, yy, zz] = per_mass.map(|moment| moment * mass_kg);
    let in_body = around.compose(&own);
    let inertia_kg_m2 = turned_inertia(&in_body.axes, [xx, yy, zz, 0.0, 0.0, 0.0]);
    Ok(Some(Inertial { mass_kg, centre_m: in_body.origin_m, inertia_kg_m2 }))
}

/// The frame of a geom and its sizes along its axes: radius and half of the length, semi-axes, or halves of the edges.
fn placed(geom: &Styled<'_, '_>, solid: Solid, compiler: &Compiler) -> Result<(Frame, [f64; 3]), Diagnostics> {
    let Some(size) = geom.attribute("size") else { return Err(missing(geom.element, "attribute 'size'")) };
    let ends = if solid == Solid::Sphere { None } else { geom.attribute("fromto") };
    let count = match solid {
        Solid::Sphere => 1,
        Solid::Capsule | Solid::Cylinder => 2,
        Solid::Ellipsoid | Solid::Box => 3,
    };
    let given = if ends.is_some() { count - 1 } else { count };
    // Sizes beyond those that a type has are ignored, as MuJoCo ignores them.
    let list = size.numbers_between(given, 3)?;
    if list.iter().take(given).any(|own| *own <= 0.0) {
        let (attribute, found) = ("size".to_owned(), size.shown());
        return Err(size.error(&RobotProblem::NotPositive { element: size.of(), attribute, found }));
    }
    let mut sizes = [0.0; 3];
    sizes.iter_mut().zip(list.iter().take(given)).for_each(|(own, value)| *own = *value);
    let Some(ends) = ends else { return Ok((frame(|name| geom.attribute(name), compiler)?, sizes)) };
    let [a, b, c, d, e, f] = ends.numbers()?;
    let (from, to) = (Vec3::new(a, b, c), Vec3::new(d, e, f));
    if from == to {
        return Err(ends.error(&RobotProblem::NoDirection { element: ends.of(), attribute: "fromto" }));
    }
    sizes[given] = 0.5 * (to - from).length();
    Ok((Frame { origin_m: (from + to) * 0.5, axes: z_axis(from - to) }, sizes))
}

/// Volume, and principal moments of inertia over the mass.
fn of_solid(solid: Solid, [a, b, c]: [f64; 3]) -> (f64, [f64; 3]) {
    match solid {
        Solid::Sphere => (4.0 / 3.0 * PI * a * a * a, [0.4 * a * a; 3]),
        Solid::Ellipsoid => {
            let moments = [(b * b + c * c) / 5.0, (a * a + c * c) / 5.0, (a * a + b * b) / 5.0];
            (4.0 / 3.0 * PI * a * b * c, moments)
        }
        Solid::Box => {
            let moments = [(b * b + c * c) / 3.0, (a * a + c * c) / 3.0, (a * a + b * b) / 3.0];
            (8.0 * a * b * c, moments)
        }
        // Radius a, half of the length b.
        Solid::Cylinder => {
            let across = a * a / 4.0 + b * b / 3.0;
            (2.0 * PI * a * a * b, [across, across, 0.5 * a * a])
        }
        // A cylinder and the two halves of a ball: of these, 2/5 a² + b² + 3/4 a b about an axis across.
        Solid::Capsule => {
            let (middle, ends) = (2.0 * PI * a * a * b, 4.0 / 3.0 * PI * a * a * a);
            let volume = middle + ends;
            let (middle, ends) = (middle / volume, ends / volume);
            let across = middle * (a * a / 4.0 + b * b / 3.0) + ends * (0.4 * a * a + b * b + 0.75 * a * b);
            (volume, [across, across, middle * 0.5 * a * a + ends * 0.4 * a * a])
        }
    }
}

/// Several masses as one, about their common centre; `None` without any.
pub(super) fn together(parts: &[Inertial]) -> Option<Inertial> {
    let mass_kg: f64 = parts.iter().map(|part| part.mass_kg).sum();
    if mass_kg == 0.0 {
        return None;
    }
    let sum = parts.iter().fold(Vec3::ZERO, |sum, part| sum + part.centre_m * part.mass_kg);
    let centre_m = sum / mass_kg;
    let mut inertia_kg_m2 = [0.0; 6];
    for part in parts {
        let Vec3 { x, y, z } = part.centre_m - centre_m;
        let steiner = [y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z];
        for ((own, moment), shift) in inertia_kg_m2.iter_mut().zip(part.inertia_kg_m2).zip(steiner) {
            *own += moment + part.mass_kg * shift;
        }
    }
    Some(Inertial { mass_kg, centre_m, inertia_kg_m2 })
}

//! Turns of frames: `quat`, `axisangle`, `euler`, `xyaxes` and `zaxis`.

use super::compiler::Compiler;
use crate::robot::problem::RobotProblem;
use crate::robot::turns::{about, clean};
use crate::robot::xml::Attribute;
use loosepin_space::{Frame, Quaternion, Rotation, Vec3};
use loosepin_text::diagnostics::Diagnostics;

/// The forms of a turn.
const FORMS: [&str; 5] = ["quat", "axisangle", "euler", "xyaxes", "zaxis"];

/// The frame of an element by its position and its turn.
pub(super) fn frame<'d>(
    attribute: impl Fn(&str) -> Option<Attribute<'d>>,
    compiler: &Compiler,
) -> Result<Frame, Diagnostics> {
    let origin_m = attribute("pos").map_or(Ok(Vec3::ZERO), |own| own.vector())?;
    let axes = orientation(attribute, compiler)?.unwrap_or(Rotation::IDENTITY);
    Ok(Frame { origin_m, axes })
}

/// The turn of an element; `None` where it has none.
pub(super) fn orientation<'d>(
    attribute: impl Fn(&str) -> Option<Attribute<'d>>,
    compiler: &Compiler,
) -> Result<Option<Rotation>, Diagnostics> {
    let mut given = FORMS.into_iter().filter_map(|form| Some((form, attribute(form)?)));
    let Some((form, own)) = given.next() else { return Ok(None) };
    if let Some((other, second)) = given.next() {
        return Err(second.error(&RobotProblem::Together { element: second.of(), one: form, other }));
    }
    let turn = match form {
        "quat" => quaternion(own.numbers()?).ok_or_else(|| no_direction(&own, "quat"))?,
        "axisangle" => {
            let [x, y, z, angle] = own.numbers()?;
            let axis = Vec3::new(x, y, z).normalised().ok_or_else(|| no_direction(&own, "axisangle"))?;
            Quaternion::from_rotation_vector(axis * (angle * compiler.radians)).rotation()
        }
        "euler" => {
            let angles: [f64; 3] = own.numbers()?;
            compiler.euler.iter().zip(angles).fold(Rotation::IDENTITY, |turn, ((axis, moves), angle)| {
                let next = about(*axis, angle * compiler.radians);
                if *moves { turn.compose(&next) } else { next.compose(&turn) }
            })
        }
        "xyaxes" => {
            let [a, b, c, d, e, f] = own.numbers()?;
            let axes = axes(Vec3::new(a, b, c), Vec3::new(d, e, f));
            axes.ok_or_else(|| no_direction(&own, "xyaxes"))?
        }
        _ => z_axis(own.direction("zaxis")?),
    };
    Ok(Some(clean(&turn)))
}

fn no_direction(attribute: &Attribute<'_>, name: &'static str) -> Diagnostics {
    attribute.error(&RobotProblem::NoDirection { element: attribute.of(), attribute: name })
}

/// The turn of a quaternion (w, x, y, z) of any length but zero.
pub(super) fn quaternion([w, x, y, z]: [f64; 4]) -> Option<Rotation> {
    let own = Quaternion::new(w, x, y, z);
    let size = own.size();
    (size > 0.0 && size.is_finite()).then(|| clean(&own.normalised().rotation()))
}

/// x along the first vector, y along the part of the second one across it.
fn axes(x: Vec3, y: Vec3) -> Option<Rotation> {
    let x = x.normalised()?;
    let across = y - x * x.dot(y);
    // What is left of a parallel vector is round-off.
    let y = across.normalised().filter(|_| across.length() > 1e-9 * y.length())?;
    Some(Rotation { x, y, z: x.cross(y) })
}

/// The shortest turn that takes z into a direction; half a turn about x where it is against z.
pub(super) fn z_axis(direction: Vec3) -> Rotation {
    let z = direction.normalised().unwrap_or(Vec3::Z);
    let axis = Vec3::Z.cross(z);
    let angle = libm::atan2(axis.length(), z.z);
    let axis = axis.normalised().unwrap_or(Vec3::X);
    Quaternion::from_rotation_vector(axis * angle).rotation()
}

//! Directions of a path in space.

use loosepin_math::Vec3;

/// The unit vectors of a path: along it, towards its centre of curvature, and across both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathFrame {
    /// t = v/|v|.
    pub tangent: Vec3,
    /// n, the direction of a - t(a·t).
    pub normal: Vec3,
    /// b = t × n.
    pub binormal: Vec3,
}

impl PathFrame {
    /// From a point's velocity and acceleration. A path that is straight there has a normal anywhere across it. `None` where the point rests,
    /// slower than `rest_m_s`: then only the length of a displacement has a meaning.
    pub fn new(velocity_m_s: Vec3, acceleration_m_s2: Vec3, rest_m_s: f64) -> Option<Self> {
        let speed = velocity_m_s.length();
        let tangent = (speed > rest_m_s).then(|| velocity_m_s.normalised()).flatten()?;
        let across = acceleration_m_s2 - tangent * acceleration_m_s2.dot(tangent);
        let is_curved = across.length() > STRAIGHT * acceleration_m_s2.length();
        let normal = if is_curved { across.normalised()? } else { tangent.across()? };
        Some(Self { tangent, normal, binormal: tangent.cross(normal) })
    }
}

/// Part of an acceleration across the path, relative to all of it, that is round-off.
const STRAIGHT: f64 = 1e-9;

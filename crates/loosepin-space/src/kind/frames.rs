//! The two markers of a joint in ground axes.

use loosepin_math::{Frame, Rotation, Vec3};

/// An axis of a marker.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axis {
    /// Its x axis.
    X,
    /// Its y axis.
    Y,
    /// Its z axis: the axis of the joint.
    Z,
}

impl Axis {
    /// This axis of three.
    pub(crate) fn of(self, axes: &Rotation) -> Vec3 {
        match self {
            Self::X => axes.x,
            Self::Y => axes.y,
            Self::Z => axes.z,
        }
    }
}

/// How far play takes the bearing's marker, seen in its own axes: the displaced marker meets the rows of the ideal joint exactly.
///
/// The origin moves by `shift_m`; the journal's axis has the slope (w1, w2), so that its direction is along (w1, w2, 1).
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct MarkerShift {
    /// Displacement of the origin along the marker's axes, m.
    pub shift_m: Vec3,
    /// Slope of the journal's axis along x and y.
    pub slope: [f64; 2],
}

/// Markers i (bearing) and j (journal) of a joint, all vectors in ground axes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct JointFrames {
    /// ρ_i: from the origin of body i to the displaced marker.
    pub arm_i: Vec3,
    /// ρ_j: from the origin of body j to its marker.
    pub arm_j: Vec3,
    /// d = P_j - P_i, from the displaced marker.
    pub separation: Vec3,
    /// x - w1 z, y - w2 z and z of marker i: the first two are across the journal's axis.
    pub constrained: Rotation,
    /// Axes of marker i.
    pub bearing: Rotation,
    /// Axes of marker j.
    pub journal: Rotation,
}

impl JointFrames {
    /// From the poses of both bodies, the markers in body axes, and what play does.
    pub(crate) fn new(
        [body_i, body_j]: [&Frame; 2],
        [point_i, point_j]: [Vec3; 2],
        [axes_i, axes_j]: [&Rotation; 2],
        play: &MarkerShift,
    ) -> Self {
        let bearing = body_i.axes.compose(axes_i);
        let arm_i = body_i.axes.apply(point_i) + bearing.apply(play.shift_m);
        let arm_j = body_j.axes.apply(point_j);
        Self {
            arm_i,
            arm_j,
            separation: body_j.origin_m + arm_j - body_i.origin_m - arm_i,
            constrained: Rotation {
                x: bearing.x - bearing.z * play.slope[0],
                y: bearing.y - bearing.z * play.slope[1],
                z: bearing.z,
            },
            bearing,
            journal: body_j.axes.compose(axes_j),
        }
    }

    /// Cosine and sine of the joint's angle, x_i·x_j and y_i·x_j; not normalised where the journal leans.
    fn turn(&self) -> (f64, f64) {
        (self.bearing.x.dot(self.journal.x), self.bearing.y.dot(self.journal.x))
    }

    /// φ = atan2(y_i·x_j, x_i·x_j), rad.
    pub(crate) fn angle_rad(&self) -> f64 {
        let (cosine, sine) = self.turn();
        libm::atan2(sine, cosine)
    }

    /// z_i·d, m.
    pub(crate) fn slide_m(&self) -> f64 {
        self.bearing.z.dot(self.separation)
    }

    /// Derivative of φ by the turning of body j; that of body i is the negative. z_i where both axes are parallel, and where x_j is along z_i, so
    /// that there is no angle.
    pub(crate) fn angle_gradient(&self) -> Vec3 {
        let (cosine, sine) = self.turn();
        let (by_sine, by_cosine) = (self.bearing.y.cross(self.journal.x), self.bearing.x.cross(self.journal.x));
        let square = cosine * cosine + sine * sine;
        if square > MIN_SQUARE { (by_cosine * sine - by_sine * cosine) / square } else { self.bearing.z }
    }
}

/// cos² + sin² of the angle below which x_j counts as along z_i.
const MIN_SQUARE: f64 = 1e-18;

/// The angle between -π and π that is `angle_rad` but for whole turns.
pub(crate) fn within_half_a_turn(angle_rad: f64) -> f64 {
    let turn = std::f64::consts::TAU;
    angle_rad - turn * (angle_rad / turn).round()
}

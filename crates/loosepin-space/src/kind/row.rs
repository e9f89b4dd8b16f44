//! The rows that ideal joints are made of, with their derivatives.
//!
//! d = P_j - P_i, ρ = arm of a marker from its body's origin, a an axis of marker i, b one of marker j. Columns are for the quasi-velocities
//! (v_i, ω_i | v_j, ω_j), v of the bodies' origins, all in ground axes; a row times the accelerations equals γ.
//!
//! | Row | Residual | Columns | γ |
//! |---|---|---|---|
//! | coincide, e = x, y, z of the ground | e·d | (-e, -ρ_i×e \| e, ρ_j×e) | -e·(ω_j×(ω_j×ρ_j) - ω_i×(ω_i×ρ_i)) |
//! | perpendicular | a·b | (0, a×b \| 0, -a×b) | -((ω_i×a)×b + a×(ω_j×b))·(ω_i - ω_j) |
//! | across | a·d | (-a, a×d - ρ_i×a \| a, ρ_j×a) | -((ω_i×(ω_i×a))·d + 2(ω_i×a)·ḋ + a·(ω_j×(ω_j×ρ_j) - ω_i×(ω_i×ρ_i))) |
//! | helix, pitch p | z_i·d - (p/2π) φ | across of z_i, less p/2π times the angle's | alike |
//! | driven angle | φ - f, φ = atan2(y_i·x_j, x_i·x_j) | (0, -z_i \| 0, z_i) | f̈ - (ω_i×z_i)·(ω_j - ω_i) |
//! | driven slide | z_i·d - f | across of z_i | that of across + f̈ |

use crate::kind::frames::{Axis, JointFrames, within_half_a_turn};
use loosepin_math::Vec3;

/// A condition on two markers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Row {
    /// Their points coincide: three rows.
    Coincident,
    /// An axis of the bearing's marker is at a right angle to one of the journal's.
    Perpendicular(Axis, Axis),
    /// The line from point to point has no part along an axis of the bearing's marker.
    Across(Axis),
    /// The journal moves along z by the pitch for each turn.
    Helix {
        /// Advance in one turn, m.
        pitch_m: f64,
    },
}

impl Row {
    /// The scalar rows that it is.
    pub(crate) fn scalars(self) -> Vec<ScalarRow> {
        match self {
            Self::Coincident => Vec3::AXES.map(ScalarRow::Coincident).to_vec(),
            Self::Perpendicular(bearing, journal) => vec![ScalarRow::Perpendicular(bearing, journal)],
            Self::Across(axis) => vec![ScalarRow::Across(axis)],
            Self::Helix { pitch_m } => vec![ScalarRow::Helix { pitch_m }],
        }
    }
}

/// Whether axes that rows hold parallel point against each other: rows of right angles alone do not tell.
pub(crate) fn is_reversed(rows: &[Row], at: &JointFrames) -> bool {
    let has = |a, b| rows.contains(&Row::Perpendicular(a, b));
    let is_against = |axis: Axis| axis.of(&at.bearing).dot(axis.of(&at.journal)) < 0.0;
    (has(Axis::X, Axis::Z) && has(Axis::Y, Axis::Z) && is_against(Axis::Z))
        || (has(Axis::X, Axis::Y) && is_against(Axis::X))
}

/// One equation of a joint or of a drive.
#[derive(Debug, Clone, Copy)]
pub(crate) enum ScalarRow {
    /// e·d = 0, for e of the ground.
    Coincident(Vec3),
    /// a·b = 0.
    Perpendicular(Axis, Axis),
    /// a·d = 0.
    Across(Axis),
    /// z_i·d = (p/2π) φ.
    Helix { pitch_m: f64 },
    /// φ = f.
    DrivenAngle,
    /// z_i·d = f.
    DrivenSlide,
}

/// Derivatives of a row by velocities and turning of its two bodies.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RowColumns {
    pub v_i: Vec3,
    pub w_i: Vec3,
    pub v_j: Vec3,
    pub w_j: Vec3,
}

/// What γ depends on: turning of both bodies and ḋ.
#[derive(Debug, Clone, Copy)]
pub(crate) struct JointRates {
    pub w_i: Vec3,
    pub w_j: Vec3,
    pub separation_rate: Vec3,
}

impl ScalarRow {
    /// Whether the residual is a length, m; it is a cosine or an angle otherwise.
    pub(crate) fn is_length(self) -> bool {
        !matches!(self, Self::Perpendicular(..) | Self::DrivenAngle)
    }

    /// The residual; `drive` is the value f of a drive.
    pub(crate) fn residual(self, at: &JointFrames, drive: f64) -> f64 {
        match self {
            Self::Coincident(direction) => direction.dot(at.separation),
            Self::Perpendicular(a, b) => a.of(&at.constrained).dot(b.of(&at.journal)),
            Self::Across(axis) => axis.of(&at.constrained).dot(at.separation),
            Self::Helix { pitch_m } => {
                // The slide says which turn it is.
                let slope = pitch_m / std::f64::consts::TAU;
                -slope * within_half_a_turn(at.angle_rad() - at.slide_m() / slope)
            }
            Self::DrivenAngle => within_half_a_turn(at.angle_rad() - drive),
            Self::DrivenSlide => at.slide_m() - drive,
        }
    }

    /// The columns of the table above.
    pub(crate) fn columns(self, at: &JointFrames) -> RowColumns {
        match self {
            Self::Coincident(e) => RowColumns { v_i: -e, w_i: -at.arm_i.cross(e), v_j: e, w_j: at.arm_j.cross(e) },
            Self::Perpendicular(a, b) => {
                let across = a.of(&at.constrained).cross(b.of(&at.journal));
                RowColumns { v_i: Vec3::ZERO, w_i: across, v_j: Vec3::ZERO, w_j: -across }
            }
            Self::Across(axis) => across_columns(at, axis.of(&at.constrained)),
            Self::DrivenSlide => across_columns(at, at.bearing.z),
            Self::DrivenAngle => {
                let turn = at.angle_gradient();
                RowColumns { v_i: Vec3::ZERO, w_i: -turn, v_j: Vec3::ZERO, w_j: turn }
            }
            Self::Helix { pitch_m } => {
                let turn = at.angle_gradient() * (pitch_m / std::f64::consts::TAU);
                let along = across_columns(at, at.bearing.z);
                RowColumns { w_i: along.w_i + turn, w_j: along.w_j - turn, ..along }
            }
        }
    }

    /// γ of the table above; `drive_acceleration` is f̈.
    pub(crate) fn gamma(self, at: &JointFrames, rates: &JointRates, drive_acceleration: f64) -> f64 {
        let JointRates { w_i, w_j, .. } = *rates;
        let centripetal = w_j.cross(w_j.cross(at.arm_j)) - w_i.cross(w_i.cross(at.arm_i));
        let across = |a: Vec3| {
            let turning = w_i.cross(a);
            -(w_i.cross(turning).dot(at.separation) + 2.0 * turning.dot(rates.separation_rate) + a.dot(centripetal))
        };
        let angle = -w_i.cross(at.bearing.z).dot(w_j - w_i);
        match self {
            Self::Coincident(e) => -e.dot(centripetal),
            Self::Perpendicular(a, b) => {
                let (a, b) = (a.of(&at.constrained), b.of(&at.journal));
                -(w_i.cross(a).cross(b) + a.cross(w_j.cross(b))).dot(w_i - w_j)
            }
            Self::Across(axis) => across(axis.of(&at.constrained)),
            Self::DrivenSlide => across(at.bearing.z) + drive_acceleration,
            Self::DrivenAngle => angle + drive_acceleration,
            Self::Helix { pitch_m } => across(at.bearing.z) - pitch_m / std::f64::consts::TAU * angle,
        }
    }

    /// Derivatives of the residual by the shift of the bearing's marker, along its axes, and by the slope of the journal's axis.
    pub(crate) fn by_play(self, at: &JointFrames) -> (Vec3, [f64; 2]) {
        let slope = |axis: Axis, by_axis: f64| match axis {
            Axis::X => [-by_axis, 0.0],
            Axis::Y => [0.0, -by_axis],
            Axis::Z => [0.0, 0.0],
        };
        match self {
            Self::Coincident(e) => (-at.bearing.apply_transposed(e), [0.0; 2]),
            Self::Perpendicular(a, b) => (Vec3::ZERO, slope(a, at.bearing.z.dot(b.of(&at.journal)))),
            Self::Across(a) => {
                (-at.bearing.apply_transposed(a.of(&at.constrained)), slope(a, at.bearing.z.dot(at.separation)))
            }
            Self::Helix { .. } | Self::DrivenSlide => (-Vec3::Z, [0.0; 2]),
            Self::DrivenAngle => (Vec3::ZERO, [0.0; 2]),
        }
    }
}

fn across_columns(at: &JointFrames, a: Vec3) -> RowColumns {
    RowColumns { v_i: -a, w_i: a.cross(at.separation) - at.arm_i.cross(a), v_j: a, w_j: at.arm_j.cross(a) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kind::frames::MarkerShift;
    use loosepin_math::{Frame, Pose, Quaternion};

    fn turned(x: f64, y: f64, z: f64) -> Quaternion {
        Quaternion::from_rotation_vector(Vec3::new(x, y, z))
    }

    fn frames(poses: [&Pose; 2], play: &MarkerShift) -> JointFrames {
        let axes = [turned(0.2, -0.5, 0.3).rotation(), turned(-0.4, 0.1, 0.9).rotation()];
        let points = [Vec3::new(0.11, -0.07, 0.05), Vec3::new(-0.03, 0.13, 0.02)];
        JointFrames::new(poses.map(Frame::from).each_ref(), points, axes.each_ref(), play)
    }

    #[test]
    fn identity_columns_and_derivatives_by_play_are_central_differences_of_the_residual() {
        const STEP: f64 = 1e-5;
        // Step² times third derivatives of order one, and round-off over the step.
        const TOLERANCE: f64 = 1e-9;
        let poses = [
            Pose::new(Vec3::new(0.3, 0.1, -0.2), turned(0.7, 0.4, -0.3)),
            Pose::new(Vec3::new(0.37, 0.02, -0.11), turned(0.1, 0.5, 0.6)),
        ];
        let play = MarkerShift { shift_m: Vec3::new(0.01, -0.02, 0.015), slope: [0.05, -0.08] };
        let axes = [Axis::X, Axis::Y, Axis::Z];
        let mut rows = Vec3::AXES.map(ScalarRow::Coincident).to_vec();
        rows.extend(axes.map(ScalarRow::Across));
        rows.extend(axes.iter().flat_map(|&a| axes.map(|b| ScalarRow::Perpendicular(a, b))));
        rows.extend([ScalarRow::DrivenAngle, ScalarRow::DrivenSlide, ScalarRow::Helix { pitch_m: 0.4 }]);
        let at = frames(poses.each_ref(), &play);
        for row in rows {
            let columns = row.columns(&at);
            let difference = |change: &dyn Fn(f64) -> JointFrames| {
                (row.residual(&change(STEP), 0.4) - row.residual(&change(-STEP), 0.4)) / (2.0 * STEP)
            };
            for axis in Vec3::AXES {
                for (body, v, w) in [(0, columns.v_i, columns.w_i), (1, columns.v_j, columns.w_j)] {
                    let moved = |displacement: Vec3, turn: Vec3| {
                        let mut poses = poses;
                        poses[body] = poses[body].moved(displacement, turn);
                        frames(poses.each_ref(), &play)
                    };
                    let along = difference(&|step| moved(axis * step, Vec3::ZERO));
                    let about = difference(&|step| moved(Vec3::ZERO, axis * step));
                    assert!((along - v.dot(axis)).abs() < TOLERANCE, "{row:?}");
                    assert!((about - w.dot(axis)).abs() < TOLERANCE, "{row:?}");
                }
                let (by_shift, _) = row.by_play(&at);
                let shifted = difference(&|step| {
                    frames(poses.each_ref(), &MarkerShift { shift_m: play.shift_m + axis * step, ..play })
                });
                // The screw has no play: its row counts the shift along z by the pitch alone.
                if !matches!(row, ScalarRow::Helix { .. }) {
                    assert!((shifted - by_shift.dot(axis)).abs() < TOLERANCE, "{row:?}");
                }
            }
            for k in 0..2 {
                let sloped = difference(&|step| {
                    let mut slope = play.slope;
                    slope[k] += step;
                    frames(poses.each_ref(), &MarkerShift { slope, ..play })
                });
                assert!((sloped - row.by_play(&at).1[k]).abs() < TOLERANCE, "{row:?}");
            }
        }
    }
}

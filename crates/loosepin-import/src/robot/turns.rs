//! Turns as robot descriptions write them.

use libm::{cos, sin};
use loosepin_space::{Rotation, Vec3};

/// Components of axes below this are round-off: no π/2 of a file is exactly a quarter of a turn.
const ROUND_OFF: f64 = 4e-16;

fn without_round_off(vector: Vec3) -> Vec3 {
    vector.map(|component| if component.abs() <= ROUND_OFF { 0.0 } else { component })
}

/// The turn with components at the size of round-off taken as zero.
pub(super) fn clean(rotation: &Rotation) -> Rotation {
    Rotation { x: without_round_off(rotation.x), y: without_round_off(rotation.y), z: without_round_off(rotation.z) }
}

/// The turn by an angle about a coordinate axis, 0 for x.
pub(super) fn about(axis: usize, angle_rad: f64) -> Rotation {
    let (s, c) = (sin(angle_rad), cos(angle_rad));
    match axis {
        0 => Rotation { x: Vec3::X, y: Vec3::new(0.0, c, s), z: Vec3::new(0.0, -s, c) },
        1 => Rotation { x: Vec3::new(c, 0.0, -s), y: Vec3::Y, z: Vec3::new(s, 0.0, c) },
        _ => Rotation { x: Vec3::new(c, s, 0.0), y: Vec3::new(-s, c, 0.0), z: Vec3::Z },
    }
}

/// R = Rz(yaw) Ry(pitch) Rx(roll): turns about axes that stay, first about x.
pub(super) fn roll_pitch_yaw([roll, pitch, yaw]: [f64; 3]) -> Rotation {
    clean(&about(2, yaw).compose(&about(1, pitch)).compose(&about(0, roll)))
}

/// The roll, pitch and yaw of a turn: the inverse of [`roll_pitch_yaw`], with -π/2 <= pitch <= π/2; roll 0 where the pitch is a quarter of a turn.
pub(crate) fn of_roll_pitch_yaw(rotation: &Rotation) -> [f64; 3] {
    // x = (cp cy, cp sy, -sp), y.z = cp sr, z.z = cp cr
    let level = libm::hypot(rotation.x.x, rotation.x.y);
    let pitch = libm::atan2(-rotation.x.z, level);
    if level > 1e-9 {
        let (roll, yaw) = (libm::atan2(rotation.y.z, rotation.z.z), libm::atan2(rotation.x.y, rotation.x.x));
        return [roll, pitch, yaw];
    }
    // Roll and yaw turn about the same axis: y = (-sin(yaw), cos(yaw), 0) with roll 0.
    [0.0, pitch, libm::atan2(-rotation.y.x, rotation.y.y)]
}

/// R I Rᵀ for xx, yy, zz, xy, xz, yz.
pub(super) fn turned_inertia(rotation: &Rotation, [xx, yy, zz, xy, xz, yz]: [f64; 6]) -> [f64; 6] {
    if *rotation == Rotation::IDENTITY {
        return [xx, yy, zz, xy, xz, yz];
    }
    let rows = [Vec3::new(xx, xy, xz), Vec3::new(xy, yy, yz), Vec3::new(xz, yz, zz)];
    // Rows of R.
    let turn = rotation.transposed();
    let axes = [turn.x, turn.y, turn.z];
    let element = |i: usize, j: usize| {
        let right = Vec3::new(rows[0].dot(axes[j]), rows[1].dot(axes[j]), rows[2].dot(axes[j]));
        axes[i].dot(right)
    };
    [element(0, 0), element(1, 1), element(2, 2), element(0, 1), element(0, 2), element(1, 2)]
}

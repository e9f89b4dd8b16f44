//! Rates of all bodies.

use crate::closure::bordered::Bordered;
use crate::closure::loops::Loops;
use crate::closure::position::Position;
use crate::kind::row::JointRates;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::mobility::idle::{IdleKind, IdleMotion, idle_motions};
use loosepin_math::{Pose, Vec3};

/// Rates of a body, in ground axes.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct BodyRates {
    /// Velocity of the origin of its frame, m/s.
    pub velocity_m_s: Vec3,
    /// Angular velocity ω, rad/s.
    pub angular_velocity_rad_s: Vec3,
    /// Acceleration of the origin of its frame, m/s².
    pub acceleration_m_s2: Vec3,
    /// Angular acceleration, rad/s².
    pub angular_acceleration_rad_s2: Vec3,
}

/// Velocities and accelerations in a position.
///
/// J ν = drive rates, J ν̇ = γ with the drives' accelerations in γ. Parts that may turn alone do not: ω·u = 0 about that axis u.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// Rates of each body, the ground first.
    pub bodies: Vec<BodyRates>,
}

impl Motion {
    /// Velocity of a point of a body, v + ω × ρ, m/s; `arm_m` is ρ in ground axes. Zero for a body that is not there.
    pub fn point_velocity_m_s(&self, body: usize, arm_m: Vec3) -> Vec3 {
        let rates = self.bodies.get(body).copied().unwrap_or_default();
        rates.velocity_m_s + rates.angular_velocity_rad_s.cross(arm_m)
    }

    /// Acceleration of a point of a body, a + ω̇ × ρ + ω × (ω × ρ), m/s²; `arm_m` is ρ in ground axes.
    pub fn point_acceleration_m_s2(&self, body: usize, arm_m: Vec3) -> Vec3 {
        let rates = self.bodies.get(body).copied().unwrap_or_default();
        let w = rates.angular_velocity_rad_s;
        rates.acceleration_m_s2 + rates.angular_acceleration_rad_s2.cross(arm_m) + w.cross(w.cross(arm_m))
    }
}

/// Rates of all bodies in a position, at the rates and accelerations of its drives.
pub fn motion(mechanism: &SpatialMechanism, position: &Position) -> Motion {
    let loops = Loops::new(mechanism);
    let frames = loops.frames(&position.poses, &[]);
    let jacobian = loops.jacobian(&frames);
    let system = Bordered::new(&loops, &frames, &position.borders);
    let idle = idle_motions(&loops, &jacobian, &position.poses);
    let drive = |number: Option<usize>| number.and_then(|number| position.drives.get(number)).copied();

    let rates: Vec<f64> =
        loops.rows.iter().map(|row| drive(row.drive).map_or(0.0, |drive| drive.rate) / loops.scale(row)).collect();
    let (velocities, _) = system.solve(&rates);
    let mut bodies: Vec<(Vec3, Vec3)> =
        (0..position.poses.len()).map(|body| loops.velocities(&velocities, body)).collect();
    without_idle_turns(&mut bodies, &idle, &position.poses);

    let gamma: Vec<f64> = loops
        .rows
        .iter()
        .map(|row| {
            let (joint, at) = (&mechanism.joints()[row.joint], &frames[row.joint]);
            let (v_i, w_i) = bodies[joint.bearing.body];
            let (v_j, w_j) = bodies[joint.journal.body];
            let separation_rate = v_j + w_j.cross(at.arm_j) - v_i - w_i.cross(at.arm_i);
            let acceleration = drive(row.drive).map_or(0.0, |drive| drive.acceleration);
            row.row.gamma(at, &JointRates { w_i, w_j, separation_rate }, acceleration) / loops.scale(row)
        })
        .collect();
    let (accelerations, _) = system.solve(&gamma);
    let mut second: Vec<(Vec3, Vec3)> =
        (0..position.poses.len()).map(|body| loops.velocities(&accelerations, body)).collect();
    // (ω·u)˙ = ω̇·u, since u turns with the body.
    without_idle_turns(&mut second, &idle, &position.poses);

    let bodies = bodies.into_iter().zip(second);
    let bodies =
        bodies.map(|((velocity_m_s, angular_velocity_rad_s), (acceleration_m_s2, angular_acceleration_rad_s2))| {
            BodyRates { velocity_m_s, angular_velocity_rad_s, acceleration_m_s2, angular_acceleration_rad_s2 }
        });
    Motion { bodies: bodies.collect() }
}

/// Takes out of the rates what parts turn about their idle axes.
fn without_idle_turns(rates: &mut [(Vec3, Vec3)], idle: &[IdleMotion], poses: &[Pose]) {
    for motion in idle {
        let (IdleKind::Turn { point_m }, Some(first)) = (motion.kind, motion.bodies.first()) else { continue };
        let spin = motion.direction * rates[*first].1.dot(motion.direction);
        for body in &motion.bodies {
            let (velocity, turning) = &mut rates[*body];
            *turning -= spin;
            *velocity -= spin.cross(poses[*body].position_m - point_m);
        }
    }
}

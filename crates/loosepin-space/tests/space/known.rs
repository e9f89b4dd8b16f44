//! Mechanisms with known answers.

use crate::build::{Build, v};
use loosepin_space::{CylindricalPlay, Marker, RevolutePlay, SpatialMechanism, SpatialPlay, Vec3};

/// Spatial slider-crank of the IFToMM library of benchmarks: crank about x at (0, 0.1, 0.12) m, radius 0.08, rod 0.3, slider along x. Bodies
/// crank, rod, slider; joints bearing, crankpin (ball), wrist (ball), guide. Drawn with the crank up.
pub fn rssp(bearing: Option<SpatialPlay>, wrist: Option<SpatialPlay>) -> SpatialMechanism {
    let (bearing_point, pin, slider) = (v(0.0, 0.1, 0.12), v(0.0, 0.1, 0.2), v(0.2, 0.0, 0.0));
    let mut build = Build::new(3).joint("revolute", [0, 1], bearing_point, Vec3::X, Vec3::Y).driven();
    if let Some(play) = bearing {
        build = build.play(play);
    }
    build = build.ball([1, 2], pin).ball([2, 3], slider);
    if let Some(play) = wrist {
        build = build.play(play);
    }
    let guide = Marker::new(0, Vec3::ZERO, Vec3::X, Vec3::Y).unwrap();
    let end = Marker::new(3, slider, Vec3::X, Vec3::Y).unwrap();
    build.push(crate::build::kind("prismatic"), guide, end).mechanism()
}

/// Place of the slider: √(L² - B_y² - B_z²).
pub fn rssp_slider(angle: f64, length: f64) -> f64 {
    let (y, z) = (0.1 - 0.08 * angle.sin(), 0.12 + 0.08 * angle.cos());
    (length * length - y * y - z * z).sqrt()
}

/// Numbers of the four-bar with two balls.
const CRANK: f64 = 0.05;
pub const COUPLER: f64 = 0.25;
const ROCKER: f64 = 0.12;

fn rocker_axes() -> [Vec3; 3] {
    let a2 = v(0.6, 0.8, 0.0);
    [Vec3::Z, a2.cross(Vec3::Z), a2]
}

const PIVOT: Vec3 = Vec3::new(0.22, 0.04, 0.06);

/// ψ = atan2(Q, P) + acos(S/√(P² + Q²)).
pub fn rssr_angle(angle: f64, length: f64) -> f64 {
    let [e2, across, _] = rocker_axes();
    let apart = PIVOT - v(CRANK * angle.cos(), CRANK * angle.sin(), 0.0);
    let (p, q) = (2.0 * ROCKER * apart.dot(e2), 2.0 * ROCKER * apart.dot(across));
    let s = length * length - ROCKER * ROCKER - apart.dot(apart);
    q.atan2(p) + (s / p.hypot(q)).acos()
}

/// The angle of the rocker with its coupler through its axis that is nearest to `near`: acos is 0 or π there.
pub fn rssr_dead_angle(angle: f64, near: f64) -> f64 {
    let [e2, across, _] = rocker_axes();
    let apart = PIVOT - v(CRANK * angle.cos(), CRANK * angle.sin(), 0.0);
    let base = apart.dot(across).atan2(apart.dot(e2));
    base + ((near - base) / std::f64::consts::PI).round() * std::f64::consts::PI
}

/// dψ/dθ = (C - B)·B'/((C - B)·C').
pub fn rssr_rate(angle: f64) -> f64 {
    let [e2, across, _] = rocker_axes();
    let psi = rssr_angle(angle, COUPLER);
    let pin = v(CRANK * angle.cos(), CRANK * angle.sin(), 0.0);
    let ball = PIVOT + (e2 * psi.cos() + across * psi.sin()) * ROCKER;
    let pin_rate = v(-CRANK * angle.sin(), CRANK * angle.cos(), 0.0);
    let ball_rate = (across * psi.cos() - e2 * psi.sin()) * ROCKER;
    (ball - pin).dot(pin_rate) / (ball - pin).dot(ball_rate)
}

/// Four-bar with two balls: crank about z at the origin, angle from x; rocker about (.6, .8, 0) at (.22, .04, .06), angle from z. Bodies
/// crank, coupler, rocker; joints bearing, crankpin (ball), ball with play, pivot. Drawn with the crank along x.
pub fn rssr(ball: Option<SpatialPlay>) -> SpatialMechanism {
    rssr_drawn(COUPLER, 0.0, ball)
}

/// The same with another coupler, drawn at another angle of the crank, from which its drive counts.
pub fn rssr_drawn(length: f64, angle: f64, ball: Option<SpatialPlay>) -> SpatialMechanism {
    let [e2, across, a2] = rocker_axes();
    let psi = rssr_angle(angle, length);
    let along = e2 * psi.cos() + across * psi.sin();
    let tip = PIVOT + along * ROCKER;
    let mut build = Build::new(3).joint("revolute", [0, 1], Vec3::ZERO, Vec3::Z, Vec3::X).driven();
    build = build.ball([1, 2], v(CRANK * angle.cos(), CRANK * angle.sin(), 0.0)).ball([2, 3], tip);
    if let Some(play) = ball {
        build = build.play(play);
    }
    let bearing = Marker::new(0, PIVOT, a2, e2).unwrap();
    let journal = Marker::new(3, PIVOT, a2, along).unwrap();
    build.push(crate::build::kind("revolute"), bearing, journal).mechanism()
}

/// Planar slider-crank whose rod may lean: crank 50 mm about z, crankpin a ball, gudgeon a revolute joint with play, slider along x; rod
/// 120 mm. Drawn with the crank along x.
pub fn leaning_slider_crank(gudgeon: Option<SpatialPlay>) -> SpatialMechanism {
    let slider = v(0.17, 0.0, 0.0);
    let mut build = Build::new(3).joint("revolute", [0, 1], Vec3::ZERO, Vec3::Z, Vec3::X).driven();
    build = build.ball([1, 2], v(0.05, 0.0, 0.0)).joint("revolute", [2, 3], slider, Vec3::Z, Vec3::X);
    if let Some(play) = gudgeon {
        build = build.play(play);
    }
    let guide = Marker::new(0, Vec3::ZERO, Vec3::X, Vec3::Y).unwrap();
    let end = Marker::new(3, slider, Vec3::X, Vec3::Y).unwrap();
    build.push(crate::build::kind("prismatic"), guide, end).mechanism()
}

/// Bricard's mechanism of six bars of 1 m, axes at right angles, fixed at P5 - P0.
pub fn bricard() -> SpatialMechanism {
    let points =
        [v(0.0, 0.0, 0.0), v(1.0, 0.0, 0.0), v(1.0, -1.0, 0.0), v(1.0, -1.0, 1.0), v(0.0, -1.0, 1.0), v(0.0, 0.0, 1.0)];
    let axes = [Vec3::Y, Vec3::Z, Vec3::X, Vec3::Y, Vec3::Z, Vec3::X];
    let mut build = Build::new(5);
    for k in 0..6 {
        build = build.about("revolute", [k, (k + 1) % 6], points[k], axes[k]);
        if k == 0 {
            build = build.driven();
        }
    }
    build.mechanism()
}

/// Axes of base, middle and platform of each leg of the spherical platform, from the notes that its check values come from.
pub const LEGS: [[[f64; 3]; 3]; 3] = [
    [
        [0.766044443118978, 0.0, -0.6427876096865394],
        [0.7558142029965635, -0.42502696236723575, 0.49809333644363274],
        [0.17209290563706026, 0.7044350089802219, 0.6885893914027638],
    ],
    [
        [-0.38302222155948884, 0.6634139481689384, -0.6427876096865394],
        [-0.14090853214889773, 0.8306702750425854, 0.5386387283962402],
        [-0.8730072530595924, -0.22097021486232163, 0.4347763795896052],
    ],
    [
        [-0.38302222155948934, -0.6634139481689382, -0.6427876096865394],
        [-0.7870842498598087, -0.3948696510038643, 0.4738948642248707],
        [0.46301606997900435, -0.6791214095091356, 0.569570215239107],
    ],
];

/// Spherical platform of three legs, each a driven revolute joint and two cylindrical ones whose axes meet in the centre: axes of base, of the
/// middle and of the platform; bearings at 0.20, 0.18, 0.15 m from the centre, all with play. The driven angles count from the middle axis, which
/// matters to second order. Bodies 1, 2 of each leg, then the platform, 7.
pub fn platform() -> SpatialMechanism {
    let revolute = RevolutePlay { bearing_length_m: 0.02, radial_clearance_m: 2e-5, axial_clearance_m: 3e-5 };
    let cylindrical = CylindricalPlay { bearing_length_m: 0.02, radial_clearance_m: 2e-5 };
    let mut build = Build::new(7);
    for (leg, axes) in LEGS.into_iter().enumerate() {
        let [base, middle, end] = axes.map(Vec3::from);
        let (first, second) = (2 * leg + 1, 2 * leg + 2);
        build = build.joint("revolute", [0, first], base * 0.20, base, middle).play(revolute).driven();
        build = build.about("cylindrical", [first, second], middle * 0.18, middle).play(cylindrical);
        build = build.about("cylindrical", [second, 7], end * 0.15, end).play(cylindrical);
    }
    build.mechanism()
}

//! Random mechanisms of many kinds, drawn in a closed position with all bodies at the ground's frame.

use crate::build::{Build, v};
use crate::random::Random;
use loosepin_space::{
    CylindricalPlay, Marker, PointOutput, Quaternion, RevolutePlay, Rotation, RotationOutput, SpatialMechanism,
    SpatialOutput, SphericalPlay, Vec3,
};

/// A way to draw a mechanism; the number is the share of joints that have play.
type Drawing = fn(&mut Random, f64) -> Build;

/// The classes of mechanisms.
pub const CLASSES: [(&str, Drawing); 14] = [
    ("RSSR", rssr),
    ("RSRC", rsrc),
    ("RSSP", rssp),
    ("RUSR", rusr),
    ("RCCC", rccc),
    ("Cardan shafts", cardan),
    ("3-RCC platform", |random, share| platform(random, share, "cylindrical")),
    ("3-RRR platform", |random, share| platform(random, share, "revolute")),
    ("spherical four-bar", spherical_four_bar),
    ("Bennett", bennett),
    ("planar four-bar", planar_four_bar),
    ("planar slider-crank", planar_slider_crank),
    ("open arm", open_arm),
    ("shaft in several bearings", several_bearings),
];

/// A mechanism of a class; at least one of its joints has play.
pub fn mechanism(class: usize, random: &mut Random) -> SpatialMechanism {
    loop {
        let share = [0.4, 0.7, 1.0][random.below(3)];
        let mechanism = (CLASSES[class].1)(random, share).mechanism();
        if mechanism.joints().iter().any(|joint| joint.play.is_some()) {
            return mechanism;
        }
    }
}

/// Displacement of a point, or the turn about an axis, of a body that moves.
pub fn output(random: &mut Random, mechanism: &SpatialMechanism) -> SpatialOutput {
    let body = 1 + random.below(mechanism.bodies().len() - 1);
    if random.below(3) == 0 {
        RotationOutput { body, axis: random.direction() }.into()
    } else {
        PointOutput { body, point_m: random.vector() * 0.2, direction: random.direction() }.into()
    }
}

/// A joint with play, if it is drawn to have some.
fn joint(build: Build, random: &mut Random, share: f64, kind: &str, pair: [usize; 2], point: Vec3, z: Vec3) -> Build {
    joint_from(build, random, share, kind, pair, point, z, random_across(z))
}

/// Any direction that is not along z.
fn random_across(z: Vec3) -> Vec3 {
    z.across().unwrap_or(Vec3::X)
}

#[allow(clippy::too_many_arguments, reason = "the parts of a joint")]
fn joint_from(
    build: Build,
    random: &mut Random,
    share: f64,
    kind: &str,
    pair: [usize; 2],
    point: Vec3,
    z: Vec3,
    x: Vec3,
) -> Build {
    // The bearing is on either body.
    let pair = if random.below(2) == 0 { pair } else { [pair[1], pair[0]] };
    let build = build.joint(kind, pair, point, z, x);
    let radial_clearance_m = 10.0_f64.powf(random.between(-5.0, -3.7));
    let bearing_length_m = random.between(0.015, 0.04);
    let axial_clearance_m = radial_clearance_m * random.between(0.3, 2.0);
    if random.between(0.0, 1.0) > share {
        return build;
    }
    match kind {
        "revolute" => build.play(RevolutePlay { bearing_length_m, radial_clearance_m, axial_clearance_m }),
        "cylindrical" => build.play(CylindricalPlay { bearing_length_m, radial_clearance_m }),
        "spherical" => build.play(SphericalPlay { radial_clearance_m }),
        _ => build,
    }
}

/// A loop of joints at random points about random axes, the first driven.
fn closed_loop(random: &mut Random, share: f64, kinds: &[&str]) -> Build {
    let bodies = kinds.len() - 1;
    let mut build = Build::new(bodies);
    for (k, kind) in kinds.iter().enumerate() {
        let (pair, point, z) = ([k, (k + 1) % (bodies + 1)], random.vector() * 0.2, random.direction());
        build = if *kind == "universal" {
            universal(build, pair, point, z, random_across(z))
        } else {
            joint(build, random, share, kind, pair, point, z)
        };
        if k == 0 {
            build = build.driven();
        }
    }
    build
}

fn universal(build: Build, pair: [usize; 2], point: Vec3, first: Vec3, second: Vec3) -> Build {
    let marker = |body, axis| Marker::along(body, point, axis).unwrap();
    let kind = crate::build::kind("universal");
    build.push(kind, marker(pair[0], first), marker(pair[1], second))
}

fn rssr(random: &mut Random, share: f64) -> Build {
    closed_loop(random, share, &["revolute", "spherical", "spherical", "revolute"])
}

fn rsrc(random: &mut Random, share: f64) -> Build {
    closed_loop(random, share, &["revolute", "spherical", "revolute", "cylindrical"])
}

fn rssp(random: &mut Random, share: f64) -> Build {
    closed_loop(random, share, &["revolute", "spherical", "spherical", "prismatic"])
}

fn rusr(random: &mut Random, share: f64) -> Build {
    closed_loop(random, share, &["revolute", "universal", "spherical", "revolute"])
}

fn rccc(random: &mut Random, share: f64) -> Build {
    closed_loop(random, share, &["revolute", "cylindrical", "cylindrical", "cylindrical"])
}

/// Two shafts whose axes meet in a cross, each in one bearing, in a random place.
fn cardan(random: &mut Random, share: f64) -> Build {
    let (centre, first) = (random.vector() * 0.1, random.direction());
    let bend = random.between(0.2, 1.0);
    let second = first * bend.cos() + random_across(first) * bend.sin();
    let pin = Quaternion::from_rotation_vector(first * random.between(0.0, 6.0)).rotation().apply(random_across(first));
    let build = Build::new(2);
    let build = joint(build, random, share, "revolute", [0, 1], centre - first * 0.3, first).driven();
    let build = universal(build, [1, 2], centre, pin, second.cross(pin));
    let distance = random.between(0.1, 0.4);
    joint(build, random, share, "revolute", [0, 2], centre + second * distance, second)
}

/// Three legs on a platform, all axes through one point; each leg is driven at the base.
fn platform(random: &mut Random, share: f64, kind: &str) -> Build {
    let (centre, turn) = (random.vector() * 0.1, Quaternion::from_rotation_vector(random.vector() * 3.0).rotation());
    let mut build = Build::new(7);
    for leg in 0..3 {
        let azimuth = f64::from(leg) * 2.1 + 0.3 * random.number();
        let from_pole =
            |polar: f64, azimuth: f64| v(polar.sin() * azimuth.cos(), polar.sin() * azimuth.sin(), polar.cos());
        let base = from_pole(2.3 + 0.3 * random.number(), azimuth);
        let middle = from_pole(1.3 + 0.3 * random.number(), azimuth + 0.9 + 0.3 * random.number());
        let end = from_pole(0.9 + 0.3 * random.number(), azimuth + 0.2 + 0.3 * random.number());
        let leg = leg as usize;
        let pairs = [[0, 2 * leg + 1], [2 * leg + 1, 2 * leg + 2], [2 * leg + 2, 7]];
        for (k, (axis, pair)) in [base, middle, end].into_iter().zip(pairs).enumerate() {
            let (axis, distance) = (turn.apply(axis), random.between(0.12, 0.25));
            let kind = if k == 0 { "revolute" } else { kind };
            build = joint(build, random, share, kind, pair, centre + axis * distance, axis);
            if k == 0 {
                build = build.driven();
            }
        }
    }
    build
}

fn spherical_four_bar(random: &mut Random, share: f64) -> Build {
    let centre = random.vector() * 0.1;
    let mut build = Build::new(3);
    for k in 0..4 {
        let (axis, distance) = (random.direction(), random.between(0.1, 0.3));
        build = joint(build, random, share, "revolute", [k, (k + 1) % 4], centre + axis * distance, axis);
        if k == 0 {
            build = build.driven();
        }
    }
    build
}

/// Bennett's loop: opposite links alike, sin α/a = sin β/b. Of tan(θ1/2) tan(θ2/2) = ±sin((α + β)/2)/sin((α - β)/2) that sign which closes it.
fn bennett(random: &mut Random, share: f64) -> Build {
    let (alpha, beta) = (random.between(0.5, 0.9), random.between(1.2, 2.2));
    let a = random.between(0.08, 0.15);
    let b = a * beta.sin() / alpha.sin();
    let first = random.between(0.6, 2.4);
    let start = (random.vector() * 0.1, Quaternion::from_rotation_vector(random.vector() * 2.0).rotation());
    let about = |axis: Vec3, angle: f64| Quaternion::from_rotation_vector(axis * angle).rotation();
    let frames = |second: f64| {
        let mut frames: Vec<(Vec3, Rotation)> = vec![start];
        for (turn, length, twist) in [(first, a, alpha), (second, b, beta), (-first, a, alpha), (-second, b, beta)] {
            let (place, axes) = frames[frames.len() - 1];
            let axes = axes.compose(&about(Vec3::Z, turn));
            frames.push((place + axes.x * length, axes.compose(&about(Vec3::X, twist))));
        }
        frames
    };
    let ratio = (0.5 * (alpha + beta)).sin() / (0.5 * (alpha - beta)).sin();
    let found = [ratio, -ratio].map(|ratio| frames(2.0 * (ratio / (0.5 * first).tan()).atan()));
    let is_closed = |frames: &&Vec<(Vec3, Rotation)>| {
        let (place, axes) = frames[4];
        (place - start.0).length() < 1e-12
            && (axes.z - start.1.z).length() < 1e-12
            && (axes.x - start.1.x).length() < 1e-12
    };
    let frames = found.iter().find(is_closed).expect("Bennett's loop closes");
    let mut build = Build::new(3);
    for k in 0..4 {
        let (place, axes) = frames[k];
        let point = place + axes.z * (0.03 * random.number());
        build = joint(build, random, share, "revolute", [k, (k + 1) % 4], point, axes.z);
        if k == 0 {
            build = build.driven();
        }
    }
    build
}

/// A plane in space: its origin, its axes, and its points at random heights.
struct Plane {
    origin: Vec3,
    axes: Rotation,
}

impl Plane {
    fn drawn(random: &mut Random) -> Self {
        let axes = Quaternion::from_rotation_vector(random.vector() * 3.0).rotation();
        Self { origin: random.vector() * 0.1, axes }
    }
    fn point(&self, random: &mut Random, x: f64, y: f64) -> Vec3 {
        let [x, y] = [x, y].map(|value| value + 0.02 * random.number());
        self.origin + self.axes.apply(v(x, y, 0.04 * random.number()))
    }
}

fn planar_four_bar(random: &mut Random, share: f64) -> Build {
    let plane = Plane::drawn(random);
    let mut build = Build::new(3);
    for (k, [x, y]) in [[0.0, 0.0], [0.03, 0.05], [0.16, 0.12], [0.15, 0.0]].into_iter().enumerate() {
        let point = plane.point(random, x, y);
        build = joint(build, random, share, "revolute", [k, (k + 1) % 4], point, plane.axes.z);
        if k == 0 {
            build = build.driven();
        }
    }
    build
}

fn planar_slider_crank(random: &mut Random, share: f64) -> Build {
    let plane = Plane::drawn(random);
    let points = [[0.0, 0.0], [0.04, 0.05], [0.2, 0.02]].map(|[x, y]| plane.point(random, x, y));
    let mut build = Build::new(3);
    for (k, point) in points.into_iter().enumerate() {
        build = joint(build, random, share, "revolute", [k, k + 1], point, plane.axes.z);
        if k == 0 {
            build = build.driven();
        }
    }
    let lean = random.between(-0.4, 0.4);
    let along = plane.axes.x * lean.cos() + plane.axes.y * lean.sin();
    joint_from(build, random, share, "prismatic", [0, 3], points[2], along, plane.axes.z)
}

/// Two to four driven joints in a row.
fn open_arm(random: &mut Random, share: f64) -> Build {
    let joints = 2 + random.below(3);
    let mut build = Build::new(joints);
    for k in 0..joints {
        let kind = ["revolute", "revolute", "cylindrical", "prismatic"][random.below(4)];
        let (point, z) = (random.vector() * 0.3, random.direction());
        build = joint(build, random, share, kind, [k, k + 1], point, z);
        build = match kind {
            "revolute" => build.driven(),
            "prismatic" => build.slid(),
            _ => build.driven().slid(),
        };
    }
    build
}

/// RSSR whose crank and rocker turn in two or three bearings on one axis.
fn several_bearings(random: &mut Random, share: f64) -> Build {
    let mut build = Build::new(3);
    for (body, is_driven) in [(1, true), (3, false)] {
        let (point, z) = (random.vector() * 0.2, random.direction());
        // Without play in one of them the others have to fit a shaft that is held.
        build = joint(build, random, 1.0, "revolute", [0, body], point, z);
        if is_driven {
            build = build.driven();
        }
        for number in 0..random.below(3) {
            let along = 0.05 + 0.06 * number as f64 + 0.02 * random.number();
            build = joint(build, random, 1.0, "cylindrical", [0, body], point + z * along, z);
        }
    }
    for pair in [[1, 2], [2, 3]] {
        let point = random.vector() * 0.2;
        build = joint(build, random, share, "spherical", pair, point, Vec3::Z);
    }
    build
}

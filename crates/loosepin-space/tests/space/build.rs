//! Mechanisms drawn in the ground's frame in a position in which they are closed.

use loosepin_space::{
    Body, Cylindrical, Drive, DriveValue, Joint, JointCoordinate, Marker, Planar, Pose, Prismatic, Revolute, Rigid,
    SpatialKind, SpatialMechanism, SpatialPlay, Spherical, Universal, Vec3,
};

pub fn v(x: f64, y: f64, z: f64) -> Vec3 {
    Vec3::new(x, y, z)
}

/// A mechanism in the making. Body frames coincide with the ground's frame in the drawn position.
#[derive(Default)]
pub struct Build {
    bodies: Vec<Body>,
    joints: Vec<Joint>,
    drives: Vec<Drive>,
}

impl Build {
    /// The ground, 0, and bodies 1, 2, ...
    pub fn new(bodies: usize) -> Self {
        let moving = (1..=bodies).map(|number| Body::new(format!("body {number}"), Pose::GROUND));
        Self { bodies: std::iter::once(Body::ground()).chain(moving).collect(), ..Self::default() }
    }

    /// A joint with both markers at `point`, z along `z` and x along `x`.
    pub fn joint(self, kind: &str, pair: [usize; 2], point: Vec3, z: Vec3, x: Vec3) -> Self {
        let kind = self::kind(kind);
        let marker = |body| Marker::new(body, point, z, x).unwrap();
        self.push(kind, marker(pair[0]), marker(pair[1]))
    }

    /// A joint whose x axes do not matter.
    pub fn about(self, kind: &str, pair: [usize; 2], point: Vec3, z: Vec3) -> Self {
        let marker = |body| Marker::along(body, point, z).unwrap();
        let kind = self::kind(kind);
        self.push(kind, marker(pair[0]), marker(pair[1]))
    }

    pub fn ball(self, pair: [usize; 2], point: Vec3) -> Self {
        self.joint("spherical", pair, point, Vec3::Z, Vec3::X)
    }

    pub fn push(mut self, kind: SpatialKind, bearing: Marker, journal: Marker) -> Self {
        let name = format!("joint {}", self.joints.len());
        self.joints.push(Joint::new(name, kind, bearing, journal));
        self
    }

    /// Play of the last joint.
    pub fn play(mut self, play: impl Into<SpatialPlay>) -> Self {
        let last = self.joints.pop().unwrap();
        self.joints.push(last.with_play(play));
        self
    }

    /// A drive of the last joint's angle.
    pub fn driven(mut self) -> Self {
        self.drives.push(Drive { joint: self.joints.len() - 1, coordinate: JointCoordinate::Angle });
        self
    }

    /// A drive of the last joint's slide.
    pub fn slid(mut self) -> Self {
        self.drives.push(Drive { joint: self.joints.len() - 1, coordinate: JointCoordinate::Slide });
        self
    }

    pub fn mechanism(self) -> SpatialMechanism {
        SpatialMechanism::new(self.bodies, self.joints, self.drives).unwrap()
    }
}

/// One drive at unit speed.
pub fn turning(angle: f64) -> Vec<DriveValue> {
    vec![DriveValue::at_rate(angle, 1.0)]
}

/// 0, 1, ..., over a turn, rad.
pub fn turn(steps: usize) -> Vec<f64> {
    (0..=steps).map(|k| std::f64::consts::TAU * k as f64 / steps as f64).collect()
}

/// An angle between -π and π.
pub fn wrapped(angle: f64) -> f64 {
    let turn = std::f64::consts::TAU;
    angle - turn * (angle / turn).round()
}

/// The kind of this name, of those without a number of their own.
pub fn kind(word: &str) -> SpatialKind {
    let all: [SpatialKind; 7] = [
        Revolute.into(),
        Prismatic.into(),
        Cylindrical.into(),
        Spherical.into(),
        Universal.into(),
        Planar.into(),
        Rigid.into(),
    ];
    all.into_iter().find(|kind| kind.word() == word).unwrap()
}

//! The slider-crank in closed form, its drawing, and a made-up path of the journal.

use std::f64::consts::{PI, TAU};

use loosepin::simulate::record::{
    Drawing, DrawnBody, DrawnDrive, DrawnJoint, DrawnJointKind, DrawnOutput, DrawnPoint, DriveSense, JournalOrbit,
    PointReference, PoseTable,
};

pub const CRANK_M: f64 = 0.05;
pub const ROD_M: f64 = 0.12;
pub const SPEED_RAD_S: f64 = 5000.0 * PI / 30.0;

/// Repeatable numbers, uniform in (0, 1): a linear congruential generator is enough for pictures.
pub struct Numbers(u64);

impl Numbers {
    pub fn new(seed: u64) -> Self {
        Numbers(seed.wrapping_mul(2).wrapping_add(0x9E37_79B9_7F4A_7C15))
    }

    pub fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 11) as f64 + 0.5) / (1u64 << 53) as f64
    }

    /// Standard normal, by the sum of twelve uniform numbers.
    pub fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.uniform()).sum::<f64>() - 6.0
    }
}

/// One mechanism: its lengths, its clearance, and two numbers that shape the journal's path.
#[derive(Debug, Clone, Copy)]
pub struct Sample {
    pub crank_m: f64,
    pub rod_m: f64,
    pub clearance_m: f64,
    pub restitution: f64,
    pub phase: f64,
}

impl Sample {
    pub fn nominal(clearance_m: f64) -> Self {
        Sample { crank_m: CRANK_M, rod_m: ROD_M, clearance_m, restitution: 0.8, phase: 0.0 }
    }

    /// Eccentricity of the journal at a crank angle: mostly on the rim, thrown across twice a turn, with rebounds.
    pub fn eccentricity_m(&self, angle_rad: f64) -> (f64, f64) {
        let side = PI * (0.5 + 0.5 * (5.0 * (angle_rad + 0.35 + 0.15 * self.phase).cos()).tanh());
        let direction = side + 0.5 * (2.0 * angle_rad + 0.6 * self.phase).sin() + 0.2 * self.phase;
        let since_flight = [1.15, 1.15 + PI].map(|onset| (angle_rad - onset - 0.1 * self.phase).rem_euclid(TAU));
        let lift: f64 = since_flight
            .iter()
            .map(|since| {
                let bounce = (9.0 * since).cos().abs();
                0.9 * (1.0 - bounce) * (-since / (0.25 + self.restitution)).exp()
            })
            .fold(0.0, f64::max);
        let radius_m = self.clearance_m * (1.0 - lift.clamp(0.0, 0.98));
        (radius_m * direction.cos(), radius_m * direction.sin())
    }

    /// Slider position and rod angle with play.
    pub fn slider(&self, angle_rad: f64) -> (f64, f64) {
        self.slider_with(angle_rad, self.eccentricity_m(angle_rad))
    }

    /// Slider position and rod angle without play.
    pub fn ideal_slider(&self, angle_rad: f64) -> (f64, f64) {
        self.slider_with(angle_rad, (0.0, 0.0))
    }

    fn slider_with(&self, angle_rad: f64, (e_x, e_y): (f64, f64)) -> (f64, f64) {
        let rod_sine = (-e_y - self.crank_m * angle_rad.sin()) / self.rod_m;
        let rod_angle_rad = rod_sine.asin();
        (self.crank_m * angle_rad.cos() + self.rod_m * rod_angle_rad.cos() + e_x, rod_angle_rad)
    }
}

/// Angles from 0 to `turns` turns, ends included.
pub fn angles_rad(turns: f64, points: usize) -> Vec<f64> {
    (0..points).map(|point| turns * TAU * point as f64 / (points - 1) as f64).collect()
}

pub fn drawing(sample: &Sample, with_play: bool) -> Drawing {
    const POSES: usize = 361;
    let point = |name: &str, x_m: f64, y_m: f64| DrawnPoint { name: name.to_owned(), x_m, y_m };
    let body =
        |name: &str, is_ground: bool, points: Vec<DrawnPoint>| DrawnBody { name: name.to_owned(), is_ground, points };
    let joint = |name: &str, kind, first: (usize, usize), second: (usize, usize), radial_clearance_m| DrawnJoint {
        name: name.to_owned(),
        kind,
        first: PointReference { body: first.0, point: first.1 },
        second: PointReference { body: second.0, point: second.1 },
        guide_angle_rad: 0.0,
        radial_clearance_m,
    };
    let gudgeon = if with_play { DrawnJointKind::RevoluteWithClearance } else { DrawnJointKind::Revolute };
    Drawing {
        bodies: vec![
            body("ground", true, vec![point("o", 0.0, 0.0)]),
            body("crank", false, vec![point("main", 0.0, 0.0), point("pin", CRANK_M, 0.0)]),
            body("rod", false, vec![point("big_end", 0.0, 0.0), point("small_end", ROD_M, 0.0)]),
            body("slider", false, vec![point("pin", 0.0, 0.0)]),
        ],
        joints: vec![
            joint("main", DrawnJointKind::Revolute, (0, 0), (1, 0), 0.0),
            joint("crankpin", DrawnJointKind::Revolute, (1, 1), (2, 0), 0.0),
            joint("gudgeon", gudgeon, (2, 1), (3, 0), if with_play { sample.clearance_m } else { 0.0 }),
            joint("guide", DrawnJointKind::Prismatic, (0, 0), (3, 0), 0.0),
        ],
        drives: vec![DrawnDrive { name: "crank".to_owned(), joint: 0, sense: DriveSense::Forward }],
        output_points: vec![DrawnOutput { name: "slider".to_owned(), point: PointReference { body: 3, point: 0 } }],
        poses: poses(sample, POSES, with_play),
        ideal_poses: if with_play { poses(sample, POSES, false) } else { PoseTable::default() },
        beams: Vec::new(),
    }
}

fn poses(sample: &Sample, count: usize, with_play: bool) -> PoseTable {
    let drive_angle_rad = angles_rad(1.0, count);
    let place = |angle: &f64| if with_play { sample.slider(*angle) } else { sample.ideal_slider(*angle) };
    let zeros = vec![0.0; count];
    let slider: Vec<(f64, f64)> = drive_angle_rad.iter().map(place).collect();
    PoseTable {
        x_m: vec![
            zeros.clone(),
            zeros.clone(),
            drive_angle_rad.iter().map(|angle| sample.crank_m * angle.cos()).collect(),
            slider.iter().map(|(x_m, _)| *x_m).collect(),
        ],
        y_m: vec![
            zeros.clone(),
            zeros.clone(),
            drive_angle_rad.iter().map(|angle| sample.crank_m * angle.sin()).collect(),
            zeros.clone(),
        ],
        angle_rad: vec![
            zeros.clone(),
            drive_angle_rad.clone(),
            slider.iter().map(|(_, rod_angle_rad)| *rod_angle_rad).collect(),
            zeros,
        ],
        drive_angle_rad,
    }
}

pub fn orbit(sample: &Sample, label: &str, turns: f64) -> JournalOrbit {
    let drive_angle_rad = angles_rad(turns, 1500);
    let path: Vec<(f64, f64)> = drive_angle_rad.iter().map(|angle| sample.eccentricity_m(*angle)).collect();
    // The force that a slider of 0.3 kg would need, where the journal is on the rim.
    let force_n = |(angle, (x_m, y_m)): (&f64, &(f64, f64))| {
        let is_on_rim = x_m.hypot(*y_m) >= 0.999 * sample.clearance_m;
        if is_on_rim { 0.3 * sample.crank_m * SPEED_RAD_S * SPEED_RAD_S * angle.cos().abs() } else { 0.0 }
    };
    JournalOrbit {
        joint: "gudgeon".to_owned(),
        label: label.to_owned(),
        radial_clearance_m: sample.clearance_m,
        x_m: path.iter().map(|(x_m, _)| *x_m).collect(),
        y_m: path.iter().map(|(_, y_m)| *y_m).collect(),
        force_n: drive_angle_rad.iter().zip(&path).map(force_n).collect(),
        drive_angle_rad,
    }
}

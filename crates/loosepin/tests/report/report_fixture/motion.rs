//! The ideal motion and the quasi-static answer.

use loosepin::accuracy::record::*;
use loosepin::units::{DisplayUnits, SiUnit};

use super::kinematics::{CRANK_M, ROD_M, SPEED_RAD_S, Sample, angles_rad, drawing};

const GUDGEON_CLEARANCE_M: f64 = 5e-4;
const SLIDER_KG: f64 = 0.14;
const CRANKPIN_CLEARANCE_M: f64 = 5e-5;

/// The ideal slider-crank with play in two joints.
pub fn worn_pin() -> MotionRecord {
    let sample = Sample::nominal(GUDGEON_CLEARANCE_M);
    let angles = angles_rad(1.0, 361);
    let rod = |angle: f64| sample.ideal_slider(angle).1;
    let over = |value: &dyn Fn(f64) -> f64| -> Vec<f64> { angles.iter().map(|angle| value(*angle)).collect() };
    // v = dx/dt and a = d²x/dt² of x = r cos t + l cos b with sin b = -(r/l) sin t, at constant speed.
    let rod_rate = |angle: f64| -CRANK_M / ROD_M * angle.cos() / rod(angle).cos();
    let velocity = |angle: f64| SPEED_RAD_S * (-CRANK_M * angle.sin() - ROD_M * rod(angle).sin() * rod_rate(angle));
    let acceleration = |angle: f64| (velocity(angle + 1e-5) - velocity(angle - 1e-5)) / 2e-5 * SPEED_RAD_S;
    let gain = |angle: f64| 1.0 / rod(angle).cos();
    let contributors = vec![
        JointContributor {
            joint: "gudgeon".to_owned(),
            radial_clearance_m: GUDGEON_CLEARANCE_M,
            first_order_si: over(&|angle| GUDGEON_CLEARANCE_M * gain(angle)),
            ..JointContributor::default()
        },
        JointContributor {
            joint: "crankpin".to_owned(),
            radial_clearance_m: CRANKPIN_CLEARANCE_M,
            first_order_si: over(&|angle| CRANKPIN_CLEARANCE_M * gain(angle)),
            ..JointContributor::default()
        },
    ];
    let play = |angle: f64| (GUDGEON_CLEARANCE_M + CRANKPIN_CLEARANCE_M) * gain(angle);
    let root_sum_square = GUDGEON_CLEARANCE_M.hypot(CRANKPIN_CLEARANCE_M);
    MotionRecord {
        model: "slider-crank with a worn pin".to_owned(),
        version: loosepin::VERSION.to_owned(),
        repeat: Default::default(),
        overrides: Vec::new(),
        drive: "crank".to_owned(),
        drive_speed_rad_s: Some(SPEED_RAD_S),
        mobility: "1 degree of freedom, 1 drive".to_owned(),
        singular_positions: vec![SingularPosition {
            drive_angle_rad: 0.0,
            words: "dead centre: the slider cannot drive the crank here".to_owned(),
        }],
        kinematics: Default::default(),
        guide_overhangs: Vec::new(),
        unproven_spans: Vec::new(),
        is_proven_between_angles: true,
        remarks: Vec::new(),
        requirements: Vec::new(),
        allowances: Vec::new(),
        asked: Vec::new(),
        display_units: DisplayUnits::default(),
        outputs: vec![OutputMotion {
            name: "slider".to_owned(),
            words: "x of slider.pin".to_owned(),
            unit: SiUnit::LENGTH,
            coordinate_of: None,
            path_error: None,
            value_si: over(&|angle| sample.ideal_slider(angle).0),
            velocity_si: over(&velocity),
            acceleration_si: over(&acceleration),
            clearance: ClearanceAnswer {
                first_order_si: over(&|angle| play(angle)),
                held_first_order_si: Vec::new(),
                worst_case_si: over(&|angle| 1.002 * play(angle)),
                lowest_si: over(&|angle| -1.002 * play(angle)),
                highest_si: over(&|angle| 0.999 * play(angle)),
                proven_lowest_si: over(&|angle| -1.004 * play(angle)),
                proven_highest_si: over(&|angle| 1.001 * play(angle)),
                witness: None,
                searched: Vec::new(),
                disc_standard_deviation_si: over(&|angle| 0.5 * root_sum_square * gain(angle)),
                rim_standard_deviation_si: over(&|angle| root_sum_square * gain(angle) / 2f64.sqrt()),
                contributors,
            },
            dimensional_standard_deviation_si: over(&|angle| {
                (2e-5 * (angle.cos() + rod(angle).tan() * angle.sin())).hypot(3e-5 * gain(angle))
            }),
            dimensional_contributors: vec![
                DimensionContributor {
                    path: "parameter.crank_length".to_owned(),
                    standard_deviation_si: over(&|angle| 2e-5 * (angle.cos() + rod(angle).tan() * angle.sin()).abs()),
                },
                DimensionContributor {
                    path: "parameter.rod_length".to_owned(),
                    standard_deviation_si: over(&|angle| 3e-5 * gain(angle)),
                },
            ],
        }],
        // The power that the slider takes is m a v.
        paths: Vec::new(),
        efforts: vec![EffortMotion {
            name: "torque".to_owned(),
            words: "torque of drive crank".to_owned(),
            unit: SiUnit::MOMENT,
            value_si: over(&|angle| SLIDER_KG * acceleration(angle) * velocity(angle) / SPEED_RAD_S),
        }],
        drawing: drawing(&sample, false),
        picture: Default::default(),
        time_s: Vec::new(),
        drive_angle_rad: angles,
    }
}

/// A four-bar whose rocker has play in its fixed bearing; the coupler carries a tracer.
pub fn four_bar() -> MotionRecord {
    use loosepin::simulate::record::{
        Drawing, DrawnBody, DrawnDrive, DrawnJoint, DrawnJointKind, DrawnOutput, DrawnPoint, DriveSense,
        PointReference, PoseTable,
    };
    const GROUND_M: f64 = 0.16;
    const COUPLER_M: f64 = 0.14;
    const ROCKER_M: f64 = 0.11;
    const CLEARANCE_M: f64 = 3e-4;
    let angles = angles_rad(1.0, 181);
    // Where coupler and rocker meet: the upper crossing of two circles about (c_x, c_y) and (GROUND_M, 0).
    let closed = |angle: f64, e: f64| {
        let (c_x, c_y) = (CRANK_M * angle.cos(), CRANK_M * angle.sin());
        let (r_x, r_y) = (GROUND_M + e, 0.0);
        let (d_x, d_y) = (r_x - c_x, r_y - c_y);
        let distance = d_x.hypot(d_y);
        let along = (COUPLER_M * COUPLER_M - ROCKER_M * ROCKER_M + distance * distance) / (2.0 * distance);
        let across = (COUPLER_M * COUPLER_M - along * along).sqrt();
        let (x, y) = (c_x + (along * d_x - across * d_y) / distance, c_y + (along * d_y + across * d_x) / distance);
        ((y - c_y).atan2(x - c_x), (y - r_y).atan2(x - r_x))
    };
    let poses = |e: f64| {
        let list = |value: &dyn Fn(f64) -> f64| -> Vec<f64> { angles.iter().map(|angle| value(*angle)).collect() };
        PoseTable {
            x_m: vec![list(&|_| 0.0), list(&|_| 0.0), list(&|angle| CRANK_M * angle.cos()), list(&|_| GROUND_M + e)],
            y_m: vec![list(&|_| 0.0), list(&|_| 0.0), list(&|angle| CRANK_M * angle.sin()), list(&|_| 0.0)],
            angle_rad: vec![
                list(&|_| 0.0),
                list(&|angle| angle),
                list(&|angle| closed(angle, e).0),
                list(&|angle| closed(angle, e).1),
            ],
            drive_angle_rad: angles.clone(),
        }
    };
    let body = |name: &str, is_ground: bool, points: &[(&str, f64, f64)]| DrawnBody {
        name: name.to_owned(),
        is_ground,
        points: points
            .iter()
            .map(|(name, x_m, y_m)| DrawnPoint { name: (*name).to_owned(), x_m: *x_m, y_m: *y_m })
            .collect(),
    };
    let joint = |name: &str, kind, first: (usize, usize), second: (usize, usize), radial_clearance_m| DrawnJoint {
        name: name.to_owned(),
        kind,
        first: PointReference { body: first.0, point: first.1 },
        second: PointReference { body: second.0, point: second.1 },
        guide_angle_rad: 0.0,
        radial_clearance_m,
    };
    let over = |value: &dyn Fn(f64) -> f64| -> Vec<f64> { angles.iter().map(|angle| value(*angle)).collect() };
    let rocker = |angle: f64| closed(angle, 0.0).1;
    let rate = |angle: f64| (rocker(angle + 1e-5) - rocker(angle - 1e-5)) / 2e-5 * SPEED_RAD_S;
    let gain = |angle: f64| (closed(angle, 1e-6).1 - rocker(angle)).abs() / 1e-6 + 2.0;
    MotionRecord {
        model: "four-bar with a worn rocker bearing".to_owned(),
        paths: Vec::new(),
        efforts: Vec::new(),
        drawing: Drawing {
            bodies: vec![
                body("ground", true, &[("a", 0.0, 0.0), ("d", GROUND_M, 0.0)]),
                body("crank", false, &[("a", 0.0, 0.0), ("b", CRANK_M, 0.0)]),
                body("coupler", false, &[("b", 0.0, 0.0), ("c", COUPLER_M, 0.0), ("tracer", 0.06, 0.05)]),
                body("rocker", false, &[("d", 0.0, 0.0), ("c", ROCKER_M, 0.0)]),
            ],
            joints: vec![
                // Written with the ground as the journal, which must be drawn as well as the other way round.
                joint("a", DrawnJointKind::Revolute, (1, 0), (0, 0), 0.0),
                joint("b", DrawnJointKind::Revolute, (1, 1), (2, 0), 0.0),
                joint("c", DrawnJointKind::Revolute, (2, 1), (3, 1), 0.0),
                joint("d", DrawnJointKind::RevoluteWithClearance, (0, 1), (3, 0), CLEARANCE_M),
            ],
            drives: vec![DrawnDrive { name: "crank".to_owned(), joint: 0, sense: DriveSense::Backward }],
            output_points: vec![DrawnOutput { name: "tracer".to_owned(), point: PointReference { body: 2, point: 2 } }],
            poses: poses(CLEARANCE_M),
            ideal_poses: poses(0.0),
            beams: Vec::new(),
        },
        outputs: vec![OutputMotion {
            name: "rocker".to_owned(),
            words: "angle of rocker".to_owned(),
            unit: SiUnit::ANGLE,
            coordinate_of: None,
            path_error: None,
            value_si: over(&rocker),
            velocity_si: over(&rate),
            acceleration_si: over(&|angle| (rate(angle + 1e-4) - rate(angle - 1e-4)) / 2e-4 * SPEED_RAD_S),
            clearance: ClearanceAnswer {
                first_order_si: over(&|angle| CLEARANCE_M * gain(angle)),
                disc_standard_deviation_si: over(&|angle| 0.5 * CLEARANCE_M * gain(angle)),
                rim_standard_deviation_si: over(&|angle| CLEARANCE_M * gain(angle) / 2f64.sqrt()),
                contributors: vec![JointContributor {
                    joint: "d".to_owned(),
                    radial_clearance_m: CLEARANCE_M,
                    first_order_si: over(&|angle| CLEARANCE_M * gain(angle)),
                    ..JointContributor::default()
                }],
                ..ClearanceAnswer::default()
            },
            dimensional_standard_deviation_si: Vec::new(),
            dimensional_contributors: Vec::new(),
        }],
        singular_positions: Vec::new(),
        kinematics: Default::default(),
        guide_overhangs: Vec::new(),
        drive_angle_rad: angles,
        ..worn_pin()
    }
}

//! The ideal motion and the quasi-static answer.

use loosepin::accuracy::record::*;
use loosepin::units::{DisplayUnits, SiUnit};

use super::kinematics::{CRANK_M, ROD_M, SPEED_RAD_S, Sample, angles_rad, drawing};

const GUDGEON_CLEARANCE_M: f64 = 5e-4;
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
            worst_case_si: over(&|angle| GUDGEON_CLEARANCE_M * gain(angle)),
        },
        JointContributor {
            joint: "crankpin".to_owned(),
            radial_clearance_m: CRANKPIN_CLEARANCE_M,
            worst_case_si: over(&|angle| CRANKPIN_CLEARANCE_M * gain(angle)),
        },
    ];
    let root_sum_square = GUDGEON_CLEARANCE_M.hypot(CRANKPIN_CLEARANCE_M);
    MotionRecord {
        model: "slider-crank with a worn pin".to_owned(),
        version: loosepin::VERSION.to_owned(),
        overrides: Vec::new(),
        drive: "crank".to_owned(),
        drive_speed_rad_s: Some(SPEED_RAD_S),
        mobility: "1 degree of freedom, 1 drive".to_owned(),
        singular_positions: vec![SingularPosition {
            drive_angle_rad: 0.0,
            words: "dead centre: the slider cannot drive the crank here".to_owned(),
        }],
        display_units: DisplayUnits::default(),
        outputs: vec![OutputMotion {
            name: "slider".to_owned(),
            words: "x of slider.pin".to_owned(),
            unit: SiUnit::LENGTH,
            value_si: over(&|angle| sample.ideal_slider(angle).0),
            velocity_si: over(&velocity),
            acceleration_si: over(&acceleration),
            clearance: ClearanceAnswer {
                worst_case_si: over(&|angle| (GUDGEON_CLEARANCE_M + CRANKPIN_CLEARANCE_M) * gain(angle)),
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
        drawing: drawing(&sample, false),
        drive_angle_rad: angles,
    }
}

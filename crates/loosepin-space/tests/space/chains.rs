//! Open chains against the loop equations.

use crate::build::v;
use crate::known;
use loosepin_space::{
    Body, ChainError, CylindricalPlay, Drive, DriveValue, Joint, JointCoordinate, Marker, OpenChain, Pose,
    PoseAccuracy, Quaternion, RevolutePlay, SpatialKind, SpatialMechanism, Vec3, assemble,
};

/// Turret, lift, shaft and screw, one joint with its bearing on the far side, all driven.
pub fn arm() -> SpatialMechanism {
    let poses = [
        Pose::GROUND,
        Pose::new(v(0.1, 0.02, 0.2), Quaternion::from_rotation_vector(v(0.3, -0.2, 0.5))),
        Pose::new(v(0.3, -0.05, 0.4), Quaternion::from_rotation_vector(v(-0.6, 0.1, 0.2))),
        Pose::new(v(0.4, 0.1, 0.3), Quaternion::from_rotation_vector(v(0.1, 0.9, -0.4))),
        Pose::new(v(0.55, 0.0, 0.35), Quaternion::from_rotation_vector(v(0.7, 0.3, 0.2))),
        Pose::new(v(0.6, 0.1, 0.5), Quaternion::from_rotation_vector(v(-0.2, -0.3, 1.2))),
    ];
    let revolute = RevolutePlay { bearing_length_m: 0.03, radial_clearance_m: 3e-4, axial_clearance_m: 2e-4 };
    let cylindrical = CylindricalPlay { bearing_length_m: 0.05, radial_clearance_m: 2e-4 };
    let kind = |word| crate::build::kind(word);
    let joint = |name: &str, kind: SpatialKind, [i, j]: [usize; 2], point: Vec3, z: Vec3| {
        let marker = |body: usize| Marker::in_pose(body, &poses[body], point, z, v(0.3, 1.0, -0.2)).unwrap();
        Joint::new(name, kind, marker(i), marker(j))
    };
    let joints = vec![
        joint("turret", kind("revolute"), [0, 1], v(0.0, 0.0, 0.1), v(0.1, 0.0, 1.0)).with_play(revolute),
        joint("lift", kind("prismatic"), [1, 2], v(0.2, 0.0, 0.3), v(0.5, 0.2, 1.0)),
        joint("elbow", kind("revolute"), [3, 2], v(0.35, 0.05, 0.35), v(1.0, -0.4, 0.3)).with_play(revolute),
        joint("shaft", kind("cylindrical"), [3, 4], v(0.5, 0.05, 0.3), v(0.2, 1.0, 0.4)).with_play(cylindrical),
        joint(
            "spindle",
            loosepin_space::Screw { pitch_m: 0.012 }.into(),
            [4, 5],
            v(0.58, 0.05, 0.4),
            v(-0.3, 0.2, 1.0),
        ),
    ];
    let angle = |joint| Drive { joint, coordinate: JointCoordinate::Angle };
    let slide = |joint| Drive { joint, coordinate: JointCoordinate::Slide };
    let drives = vec![angle(0), slide(1), angle(2), angle(3), slide(3), angle(4)];
    let bodies = poses
        .iter()
        .enumerate()
        .map(|(k, pose)| if k == 0 { Body::ground() } else { Body::new(format!("link {k}"), *pose) });
    SpatialMechanism::new(bodies.collect(), joints, drives).unwrap()
}

#[test]
fn identity_an_open_chain_is_the_solution_of_the_loop_equations() {
    let mechanism = arm();
    let values = [0.7, 0.03, -1.1, 0.4, -0.02, 2.3];
    let drives: Vec<DriveValue> = values.iter().map(|value| DriveValue::held(*value)).collect();
    let position = assemble(&mechanism, &drives).unwrap();
    assert_eq!((position.rank, position.redundant_rows(), position.free_motions()), (30, 0, 0));
    let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
    let count = accuracy.play_set().variables();
    assert_eq!(count, 14);
    for scale in [0.0, 1.0] {
        let variables: Vec<f64> = (0..count).map(|k| scale * 1.2e-4 * (1.7 * k as f64 + 0.3).sin()).collect();
        let solved = accuracy.displaced(&variables).unwrap();
        for body in 1..=5 {
            let chain = OpenChain::new(&mechanism, body).unwrap();
            let end = chain.sample(&variables, None).end(&chain.pose(&values));
            for point in [Vec3::ZERO, v(0.1, -0.2, 0.15), v(-0.05, 0.3, 0.1)] {
                let apart = end.point_m(point) - solved.poses[body].point_m(point);
                assert!(apart.length() < 1e-12, "body {body}: {apart:?}");
            }
        }
    }
}

#[test]
fn identity_markers_that_scatter_move_the_end_by_their_gains() {
    let mechanism = arm();
    let values = [0.7, 0.03, -1.1, 0.4, -0.02, 2.3];
    let drives: Vec<DriveValue> = values.iter().map(|value| DriveValue::held(*value)).collect();
    let position = assemble(&mechanism, &drives).unwrap();
    let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
    let chain = OpenChain::new(&mechanism, 5).unwrap();
    let tip = v(0.1, -0.2, 0.15);
    let pose = chain.pose(&values);
    let still = vec![0.0; accuracy.play_set().variables()];
    let end = |markers: &[[Marker; 2]]| chain.sample(&still, Some(markers)).end(&pose).point_m(tip);
    let nominal: Vec<[Marker; 2]> = mechanism.joints().iter().map(|joint| [joint.bearing, joint.journal]).collect();
    // Central differences: step² times third derivatives of order one.
    const STEP: f64 = 1e-5;
    for (axis, output) in loosepin_space::SpatialOutput::displacement(5, tip).into_iter().enumerate() {
        let gains = accuracy.marker_gains(&accuracy.gains(&output).unwrap());
        for joint in 0..5 {
            for side in 0..2 {
                let own = if side == 0 { gains[joint].bearing } else { gains[joint].journal };
                for k in 0..3 {
                    let moved = |step: f64, is_turn: bool| {
                        let mut markers = nominal.clone();
                        let marker = &mut markers[joint][side];
                        let direction = marker.axes.apply(Vec3::AXES[k]) * step;
                        if is_turn {
                            marker.axes = Quaternion::from_rotation_vector(direction).rotation().compose(&marker.axes);
                        } else {
                            marker.point_m += direction;
                        }
                        end(&markers).to_array()[axis]
                    };
                    let found = |is_turn| (moved(STEP, is_turn) - moved(-STEP, is_turn)) / (2.0 * STEP);
                    assert!((found(false) - own.by_displacement.to_array()[k]).abs() < 1e-9, "{joint} {side} {k}");
                    assert!((found(true) - own.by_turning.to_array()[k]).abs() < 1e-9, "{joint} {side} {k}");
                }
            }
        }
    }
}

#[test]
fn what_is_no_open_chain_is_refused() {
    let loops = known::rssr(None);
    assert_eq!(OpenChain::new(&loops, 2).unwrap_err(), ChainError::NotAChain { body: "body 2".to_owned() });
    assert_eq!(OpenChain::new(&loops, 0).unwrap_err(), ChainError::NoBody { body: 0 });
    assert_eq!(OpenChain::new(&loops, 9).unwrap_err(), ChainError::NoBody { body: 9 });
    let mechanism = arm();
    let free = SpatialMechanism::new(
        mechanism.bodies().to_vec(),
        mechanism.joints().to_vec(),
        mechanism.drives().iter().copied().filter(|drive| drive.joint != 2).collect(),
    )
    .unwrap();
    assert_eq!(OpenChain::new(&free, 5).unwrap_err(), ChainError::NotDriven { joint: "elbow".to_owned() });
    assert!(OpenChain::new(&free, 2).is_ok());
}

//! What is refused, word for word.

use crate::build::{Build, turning, v};
use loosepin_space::{
    Body, ClosureError, Drive, DriveValue, Joint, JointCoordinate, Marker, MechanismError, Pose, PoseAccuracy,
    Quaternion, RevolutePlay, SpatialKind, SpatialMechanism, SpatialOutput, SphericalPlay, Vec3, assemble,
};

fn marker(body: usize) -> Marker {
    Marker::new(body, v(0.1, 0.2, 0.3), Vec3::Z, Vec3::X).unwrap()
}

fn revolute() -> SpatialKind {
    crate::build::kind("revolute")
}

fn message(bodies: Vec<Body>, joints: Vec<Joint>, drives: Vec<Drive>) -> String {
    SpatialMechanism::new(bodies, joints, drives).unwrap_err().to_string()
}

fn two() -> Vec<Body> {
    vec![Body::ground(), Body::new("link", Pose::GROUND)]
}

fn pin() -> Joint {
    Joint::new("pin", revolute(), marker(0), marker(1))
}

#[test]
fn mechanisms_that_cannot_be() {
    let twisted = Pose::new(Vec3::ZERO, Quaternion::new(1.0, 0.1, 0.0, 0.0));
    let mut bad = marker(1);
    bad.axes.x = v(1.0, 0.1, 0.0);
    let angle = Drive { joint: 0, coordinate: JointCoordinate::Angle };
    let slide = Drive { joint: 0, coordinate: JointCoordinate::Slide };
    let play = |length, radial, axial| RevolutePlay {
        bearing_length_m: length,
        radial_clearance_m: radial,
        axial_clearance_m: axial,
    };
    for (found, expected) in [
        (message(vec![], vec![], vec![]), "the first body must be the ground, at the origin and not turned"),
        (
            message(vec![Body::ground(), Body::new("link", twisted)], vec![], vec![]),
            "body 'link': the start pose must be of finite numbers, with a unit quaternion",
        ),
        (
            message(two(), vec![Joint::new("pin", revolute(), marker(0), marker(2))], vec![]),
            "joint 'pin': there is no body number 2",
        ),
        (
            message(two(), vec![Joint::new("pin", revolute(), marker(1), marker(1))], vec![]),
            "joint 'pin': both markers are on body 'link'; a joint connects two bodies",
        ),
        (
            message(two(), vec![Joint::new("pin", revolute(), marker(0), bad)], vec![]),
            "joint 'pin': the point of a marker must be of finite numbers, and its axes orthonormal and right-handed",
        ),
        (
            message(
                two(),
                vec![Joint::new("nut", loosepin_space::Screw { pitch_m: 0.0 }, marker(0), marker(1))],
                vec![],
            ),
            "joint 'nut': the pitch of a screw must be a number other than 0",
        ),
        (
            message(two(), vec![pin().with_play(SphericalPlay { radial_clearance_m: 1e-4 })], vec![]),
            "joint 'pin': a revolute joint has no play of kind 'spherical', which is that of a spherical joint",
        ),
        (
            message(two(), vec![pin().with_play(play(0.02, -1e-4, 0.0))], vec![]),
            "joint 'pin': radial clearance, m is -0.0001; it must be >= 0",
        ),
        (
            message(two(), vec![pin().with_play(play(0.02, 0.01, 0.0))], vec![]),
            "joint 'pin': largest lean 2c/l is 1; it must be <= 0.5",
        ),
        (message(two(), vec![pin()], vec![Drive { joint: 3, ..angle }]), "drive number 0: there is no joint number 3"),
        (message(two(), vec![pin()], vec![slide]), "joint 'pin': a revolute joint does not have the driven coordinate"),
        (message(two(), vec![pin()], vec![angle, angle]), "joint 'pin': its coordinate has two drives"),
    ] {
        assert_eq!(found, expected);
    }
    assert_eq!(SpatialMechanism::new(vec![], vec![], vec![]).unwrap_err(), MechanismError::NoGround);
}

#[test]
fn positions_that_cannot_be() {
    let mechanism = Build::new(1).joint("revolute", [0, 1], Vec3::ZERO, Vec3::Z, Vec3::X).driven().mechanism();
    for drives in [vec![], vec![DriveValue::held(f64::NAN)]] {
        let found = assemble(&mechanism, &drives).unwrap_err();
        assert_eq!(found.to_string(), "the mechanism has 1 drives and takes as many finite values, not 0");
    }
    let against = Build::new(1)
        .push(
            revolute(),
            Marker::new(0, Vec3::ZERO, Vec3::Z, Vec3::X).unwrap(),
            Marker::new(1, Vec3::ZERO, -Vec3::Z, Vec3::X).unwrap(),
        )
        .driven()
        .mechanism();
    let found = assemble(&against, &turning(0.0)).unwrap_err();
    assert_eq!(found, ClosureError::Reversed { joint: "joint 0".to_owned() });
    // Turned by half a turn about z, a rigid joint meets all its right angles.
    let half = Build::new(1)
        .push(
            crate::build::kind("rigid"),
            Marker::new(0, Vec3::ZERO, Vec3::Z, Vec3::X).unwrap(),
            Marker::new(1, Vec3::ZERO, Vec3::Z, -Vec3::X).unwrap(),
        )
        .mechanism();
    assert_eq!(assemble(&half, &[]).unwrap_err(), ClosureError::Reversed { joint: "joint 0".to_owned() });
}

#[test]
fn outputs_that_have_no_ideal_value() {
    // The second body hangs on a free pin.
    let mechanism = Build::new(2)
        .joint("revolute", [0, 1], Vec3::ZERO, Vec3::Z, Vec3::X)
        .driven()
        .joint("revolute", [1, 2], v(0.1, 0.0, 0.0), Vec3::Z, Vec3::X)
        .mechanism();
    let position = assemble(&mechanism, &turning(0.4)).unwrap();
    let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
    let [along_x, _, along_z] = SpatialOutput::displacement(2, v(0.2, 0.0, 0.0));
    assert_eq!(accuracy.gains(&along_x).unwrap_err(), loosepin_space::AccuracyError::OutputIsFree);
    assert!(accuracy.gains(&along_z).is_ok());
    let [beyond, ..] = SpatialOutput::displacement(3, Vec3::ZERO);
    assert_eq!(accuracy.gains(&beyond).unwrap_err(), loosepin_space::AccuracyError::OutputDoesNotFit);
}

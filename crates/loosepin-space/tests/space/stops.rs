//! Where a motion ends: locks and change points are reported with their place.

use crate::build::{Build, turn, turning, v};
use loosepin_space::{ClosureError, Marker, SpatialMechanism, Vec3, assemble, cycle};
use loosepin_text::units::{Dimension, format_value};

/// A planar four-bar in space with the crank at an angle, drawn with the rocker's tip given.
fn four_bar(crank: Vec3, tip: Vec3, pivot: Vec3) -> SpatialMechanism {
    Build::new(3)
        .push(
            crate::build::kind("revolute"),
            Marker::new(0, Vec3::ZERO, Vec3::Z, Vec3::X).unwrap(),
            Marker::new(1, Vec3::ZERO, Vec3::Z, crank).unwrap(),
        )
        .driven()
        .about("revolute", [1, 2], crank, Vec3::Z)
        .about("revolute", [2, 3], tip, Vec3::Z)
        .about("revolute", [0, 3], pivot, Vec3::Z)
        .mechanism()
}

#[test]
fn analytic_a_drive_locks_where_coupler_and_rocker_are_in_line() {
    // Crank 0.1, coupler 0.05, rocker 0.06, frame 0.12: cos θ = (0.1² + 0.12² - 0.11²)/(2·0.1·0.12) at the end.
    let crank = v(0.1, 0.0, 0.0);
    // |tip - crank| = 0.05, |tip - pivot| = 0.06 with the pivot at x = 0.12.
    let x = (0.05_f64.powi(2) - 0.06_f64.powi(2) + 0.12_f64.powi(2) - 0.1_f64.powi(2)) / (2.0 * (0.12 - 0.1));
    let tip = v(x, (0.05_f64.powi(2) - (x - 0.1).powi(2)).sqrt(), 0.0);
    let mechanism = four_bar(crank, tip, v(0.12, 0.0, 0.0));
    let end = ((0.1_f64.powi(2) + 0.12_f64.powi(2) - 0.11_f64.powi(2)) / (2.0 * 0.1 * 0.12)).acos();
    let inputs: Vec<f64> = (0..40).map(|k| 0.05 * f64::from(k)).collect();
    let found = cycle(&mechanism, &inputs, &turning);
    let Some(ClosureError::Locked { place, joint }) = found.stopped else { panic!("{:?}", found.stopped) };
    assert_eq!((place.driven_joint.as_str(), joint.as_str()), ("joint 0", "joint 2"));
    assert!((place.value - end).abs() < 1e-6, "{} {end}", place.value);
    assert_eq!(found.positions.len(), (end / 0.05) as usize + 1);
}

#[test]
fn analytic_the_change_point_of_a_parallelogram_is_no_way_through() {
    let mechanism = four_bar(v(0.03, 0.04, 0.0), v(0.15, 0.04, 0.0), v(0.12, 0.0, 0.0));
    let start = 0.04_f64.atan2(0.03);
    // On steps that meet 180° and on steps that pass it.
    for steps in [36, 37] {
        let inputs: Vec<f64> = turn(steps).iter().map(|angle| start + angle).collect();
        let through: Vec<f64> = if steps == 36 {
            let rest = std::f64::consts::PI - start;
            (0..=20).map(|k| start + rest * f64::from(k) / 10.0).collect()
        } else {
            inputs
        };
        let found = cycle(&mechanism, &through, &turning);
        let Some(ClosureError::ChangePoint { place, .. }) = found.stopped else { panic!("{:?}", found.stopped) };
        assert!((place.value - std::f64::consts::PI).abs() < 1e-6, "{}", place.value);
    }
}

#[test]
fn loops_that_cannot_close_are_reported_with_the_joint() {
    // A coupler that is too short by 20 mm.
    let mechanism = Build::new(3)
        .joint("revolute", [0, 1], Vec3::ZERO, Vec3::Z, Vec3::X)
        .driven()
        .about("revolute", [1, 2], v(0.05, 0.0, 0.0), Vec3::Z)
        .push(
            crate::build::kind("revolute"),
            Marker::along(2, v(0.06, 0.0, 0.0), Vec3::Z).unwrap(),
            Marker::along(3, v(0.2, 0.0, 0.0), Vec3::Z).unwrap(),
        )
        .about("revolute", [0, 3], v(0.3, 0.0, 0.0), Vec3::Z)
        .mechanism();
    let found = cycle(&mechanism, &[0.0], &turning);
    // Crank, coupler of 0.01 and rocker of 0.1 m in line are 0.14 m short of the pivot.
    let Some(ClosureError::Contradiction(open)) = &found.stopped else { panic!("{:?}", found.stopped) };
    assert!(open.is_length && open.apart > 0.01 && open.apart < 0.14, "{open}");
    assert!(found.positions.is_empty());
}

#[test]
fn axes_that_are_not_parallel_contradict_each_other() {
    // A planar four-bar whose last axis is tilted by 1e-4.
    let tilted = v(1e-4, 0.0, 1.0);
    let mechanism = Build::new(3)
        .joint("revolute", [0, 1], Vec3::ZERO, Vec3::Z, Vec3::X)
        .driven()
        .about("revolute", [1, 2], v(0.03, 0.04, 0.0), Vec3::Z)
        .about("revolute", [2, 3], v(0.13, 0.09, 0.0), Vec3::Z)
        .push(
            crate::build::kind("revolute"),
            Marker::along(0, v(0.12, 0.0, 0.0), tilted).unwrap(),
            Marker::along(3, v(0.12, 0.0, 0.0), Vec3::Z).unwrap(),
        )
        .mechanism();
    let Err(ClosureError::FewDigits(open)) = assemble(&mechanism, &turning(0.0)) else { panic!() };
    assert!(open.apart > 1e-7 && open.apart < 1e-4, "{open}");
    let message = ClosureError::FewDigits(open.clone()).to_string();
    // To three digits, as people read it.
    let apart = format!("{:.2e}", open.apart).parse().unwrap();
    let expected = format!(
        "the joints fit to a few digits only: as near as they come, joint '{}' is {} apart; constraints that repeat each other need dimensions \
         that fit to nine digits: write one as an expression of the others",
        open.joint,
        format_value(apart, Dimension::ANGLE)
    );
    assert!(!open.is_length);
    assert_eq!(message, expected);
}

//! Against closed forms: cosine law for four-bars, dead centres of the offset slider-crank.

use std::f64::consts::{PI, TAU};
use std::path::Path;

use loosepin_mechanics::mechanism::Mechanism;
use loosepin_mechanics::model::Model;
use loosepin_result::kinematics::{KinematicProperties, LoopClass, MotionRange};

use super::loops::{grashof_class, slider_crank_class};
use crate::accuracy::{MotionPlan, motion};

/// Round-off of angles and lengths of order one after closing loops; time ratios too.
const ROUND_OFF: f64 = 1e-9;

fn properties(case: &str, change: &[(&str, &str)]) -> KinematicProperties {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases").join(case).join("model.toml");
    let mut text = std::fs::read_to_string(path).expect("a case");
    for (from, to) in change {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    let model = Model::from_text("model.toml", &text).unwrap_or_else(|found| panic!("{found}"));
    let values = model.quantities.evaluate(&[]).expect("sound values");
    let mechanism = Mechanism::new(&model, &values).expect("a mechanism");
    let span = mechanism.model.cycle.span;
    let plan = MotionPlan {
        span,
        positions: 72,
        scatter: Vec::new(),
        correlations: Vec::new(),
        paths: Vec::new(),
        asked: Vec::new(),
        overrides: Vec::new(),
    };
    motion(&mechanism, &values, &plan).expect("it moves").kinematics
}

fn range<'p>(found: &'p KinematicProperties, name: &str) -> &'p MotionRange {
    found.ranges.iter().find(|range| range.name == name).unwrap_or_else(|| panic!("{name}: {found:?}"))
}

fn close(found: f64, due: f64) {
    assert!((found - due).abs() < ROUND_OFF, "{found} is not {due}");
}

/// Angle opposite to `c` in a triangle with the sides `a`, `b`, `c`.
fn opposite(a: f64, b: f64, c: f64) -> f64 {
    ((a * a + b * b - c * c) / (2.0 * a * b)).acos()
}

#[test]
fn analytic_swing_time_ratio_and_transmission_of_a_crank_rocker() {
    let found = properties("four_bar_600", &[]);
    let [ground, crank, coupler, rocker] = [0.3, 0.08, 0.26, 0.18];
    let [entry] = &found.loops[..] else { panic!("{:?}", found.loops) };
    assert_eq!((entry.class, entry.shortest.as_deref()), (LoopClass::CrankRocker, Some("crank")));
    // The rocker's ends: crank and coupler on one line.
    let [far, near] = [coupler + crank, coupler - crank];
    let swing = range(&found, "rocker");
    close(swing.extent_si, opposite(ground, rocker, far) - opposite(ground, rocker, near));
    let apart = PI + opposite(ground, near, rocker) - opposite(ground, far, rocker);
    close(swing.time_ratio.expect("constant speed"), apart.max(TAU - apart) / apart.min(TAU - apart));
    let [angle] = &found.transmission_angles[..] else { panic!("{:?}", found.transmission_angles) };
    assert_eq!((&angle.bodies[..], angle.is_pressure_angle), (&["coupler".to_owned(), "rocker".to_owned()][..], false));
    close(angle.extremes_rad[0], opposite(coupler, rocker, ground - crank));
    close(angle.extremes_rad[1], opposite(coupler, rocker, ground + crank));
}

#[test]
fn analytic_stroke_time_ratio_and_pressure_angle_of_an_offset_slider_crank() {
    let offset = (
        "points = { o = [\"0 mm\", \"0 mm\"] }",
        "points = { o = [\"0 mm\", \"0 mm\"], rail = [\"0 mm\", \"20 mm\"] }",
    );
    let rail = ("point = \"ground.o\"", "point = \"ground.rail\"");
    let found = properties("slider_crank_5000", &[offset, rail]);
    let [crank, rod, offset] = [0.05_f64, 0.12_f64, 0.02_f64];
    assert_eq!(found.loops[0].class, LoopClass::TurningCrank);
    close(found.loops[0].lengths_m[2], offset);
    let [far, near] = [rod + crank, rod - crank];
    let stroke = range(&found, "guide");
    close(stroke.extent_si, (far * far - offset * offset).sqrt() - (near * near - offset * offset).sqrt());
    let more = (offset / near).asin() - (offset / far).asin();
    close(stroke.time_ratio.expect("constant speed"), (PI + more) / (PI - more));
    let [angle] = &found.transmission_angles[..] else { panic!("{:?}", found.transmission_angles) };
    assert!(angle.is_pressure_angle);
    close(angle.extremes_rad[0], 0.0);
    close(angle.extremes_rad[1], ((crank + offset) / rod).asin());
}

#[test]
fn analytic_dead_centres_of_a_central_slider_crank_at_the_start_of_the_turn_are_found_once() {
    let found = properties("slider_crank_5000", &[]);
    let stroke = range(&found, "guide");
    close(stroke.extent_si, 0.1);
    close(stroke.time_ratio.expect("constant speed"), 1.0);
    assert_eq!(stroke.dead_centres_rad.len(), 2);
}

#[test]
fn analytic_grashof_classes_and_their_boundary() {
    for (lengths_m, class) in [
        ([0.3, 0.08, 0.26, 0.18], LoopClass::CrankRocker),
        ([0.08, 0.3, 0.26, 0.18], LoopClass::DoubleCrank),
        ([0.3, 0.26, 0.08, 0.18], LoopClass::DoubleRocker),
        ([0.3, 0.1, 0.15, 0.2], LoopClass::TripleRocker),
        ([0.3, 0.1, 0.3, 0.1], LoopClass::ChangePoint),
        ([0.5, 0.2, 0.3, 0.4], LoopClass::ChangePoint),
        ([0.5 - 1e-6, 0.2, 0.3, 0.4], LoopClass::CrankRocker),
        ([0.5 + 1e-6, 0.2, 0.3, 0.4], LoopClass::TripleRocker),
    ] {
        assert_eq!(grashof_class(lengths_m), class, "{lengths_m:?}");
    }
    assert_eq!(slider_crank_class(0.05, 0.07, 0.02), LoopClass::TurningCrankAtLimit);
    assert_eq!(slider_crank_class(0.05, 0.07, -0.019), LoopClass::TurningCrank);
    assert_eq!(slider_crank_class(0.05, 0.07, 0.021), LoopClass::RockingCrank);
}

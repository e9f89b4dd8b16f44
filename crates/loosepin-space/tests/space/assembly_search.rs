//! Loops that close from other poses than those in which bodies are placed, and what is said where they do not close.

use crate::sampling::{SLIDER_CRANK, model};
use std::f64::consts::TAU;

/// Bennett's linkage: opposite links alike, lengths as the sines of their twists. Without a guess the last joint is 144 mm apart at the start.
fn bennett(length: &str) -> String {
    let link = |name: &str, length: &str, twist: &str| {
        format!(
            "[body.{name}]\npoints = {{ o = [\"0 mm\", \"0 mm\", \"0 mm\"], far = [\"{length}\", \"0 mm\", \"0 mm\"] }}\n\
             axes = {{ far = [0, \"-sin({twist})\", \"cos({twist})\"] }}\n"
        )
    };
    let joint = |name: &str, bearing: &str, journal: &str| {
        format!(
            "[joint.{name}]\nkind = \"revolute\"\nbearing = \"{bearing}\"\njournal = \"{journal}\"\nbearing_axis = \"far\"\n\
             journal_axis = \"z\"\nbearing_across = \"x\"\njournal_across = \"x\"\n"
        )
    };
    let head = format!(
        "name = \"Bennett\"\ngeometry = \"space\"\n[parameter]\na = \"100 mm\"\nalpha = \"30 deg\"\nbeta = \"70 deg\"\nb = \"{length}\"\n"
    );
    let bodies = [("ground", "a", "alpha"), ("rocker", "b", "beta"), ("coupler", "a", "alpha"), ("crank", "b", "beta")];
    let joints = [
        ("j1", "ground.far", "rocker.o"),
        ("j2", "rocker.far", "coupler.o"),
        ("j3", "coupler.far", "crank.o"),
        ("j4", "crank.far", "ground.o"),
    ];
    let drive = "[drive.crank]\njoint = \"j4\"\nspeed = \"60 rpm\"\nstart_angle = \"60 deg\"\n[cycle]\ndrive = \"crank\"\nsamples_per_turn = 36\n";
    let bodies: String = bodies.into_iter().map(|(name, length, twist)| link(name, length, twist)).collect();
    let joints: String = joints.into_iter().map(|(name, bearing, journal)| joint(name, bearing, journal)).collect();
    head + &bodies + &joints + drive
}

/// What keeps a model from moving.
fn refusal(text: &str) -> String {
    let model = model(text);
    let found = model.motion_record(&model.quantities.nominal()).unwrap_err();
    let first = found.sorted()[0];
    assert!(first.place.is_some(), "{}", first.message);
    first.message.clone()
}

/// The product of the tangents of half the angles between neighbouring links: tan(θ/2) tan(φ/2) = sin((β + α)/2)/sin((β - α)/2), θ and φ the angles between neighbouring links (G. T. Bennett 1903).
#[test]
fn known_answer_a_bennett_linkage_without_a_guess() {
    let model = model(&bennett("a * sin(beta) / sin(alpha)"));
    let values = model.quantities.nominal();
    let mechanism = model.mechanism(&values).unwrap();
    let positions = model.positions_until(&mechanism, &values, &|| false).unwrap();
    assert!(positions.iter().all(|position| position.is_other_start));
    let (alpha, beta) = (30_f64.to_radians(), 70_f64.to_radians());
    let ratio = (0.5 * (beta + alpha)).sin() / (0.5 * (beta - alpha)).sin();
    for (number, position) in positions.iter().enumerate() {
        let theta = 60_f64.to_radians() + TAU * number as f64 / 36.0;
        // The rocker's x axis against that of the ground, about the ground's far axis.
        let x = position.poses[1].orientation.rotation().x;
        let phi = (-alpha.sin() * -x.z + alpha.cos() * x.y).atan2(x.x);
        let (left, right) = ((0.5 * theta).sin() * (0.5 * phi).sin(), (0.5 * theta).cos() * (0.5 * phi).cos() * ratio);
        assert!((left - right).abs() < 1e-12, "{theta} {phi}");
    }
}

#[test]
fn numbers_with_few_digits_are_named() {
    let found = refusal(&bennett("187.94 mm"));
    assert!(found.starts_with("the joints fit to a few digits only: as near as they come, joint 'j"), "{found}");
    assert!(found.ends_with("write one as an expression of the others"), "{found}");
    let found = refusal(&bennett("187.9385 mm"));
    assert!(found.contains("constraints that repeat each other contradict each other from there on"), "{found}");
}

/// A crank, a rod between two balls and a slider: with a drive of the slider as well, one freedom has two drives.
#[test]
fn drives_that_hold_what_others_hold_are_named() {
    let second = "\n[drive.second]\njoint = \"guide\"\nspeed = \"1 mm/s\"\nstart_position = \"START\"\n";
    let one_turn = SLIDER_CRANK.replace("drive = \"crank\"\nsamples_per_turn", "duration = \"1 s\"\nsamples_per_turn");
    let start = |position: &str| one_turn.clone() + &second.replace("START", position);
    let held = "the drive cannot move from 'guide' at 200 mm: the joints or other drives hold it";
    assert_eq!(refusal(&start("100 mm")), held);
    assert_eq!(refusal(&start("200 mm")), held.replace("'guide' at 200 mm", "'main' at 0 deg"));
}

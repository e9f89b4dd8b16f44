//! What the energy account says of a run as a whole: runs that it does not bear out have failed, by name.

use super::elements::{Built, build, file, report};
use loosepin_result::simulation::StopReason;
use loosepin_simulate::{Plan, RunFailure, Settings, Simulation, simulate};
use std::path::Path;

/// The slider-crank with friction, with another friction law in its gudgeon.
fn slider_crank_with(friction: &str) -> Built {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slider_crank_friction/model.toml");
    let text = std::fs::read_to_string(path).expect("the case is there");
    let own = "friction = { law = \"ambrosio\", coefficient = 0.03 }";
    assert!(text.contains(own));
    build(&text.replace(own, &format!("friction = {friction}")))
}

fn simulated(built: &Built, tolerance_m: f64) -> Simulation {
    let mut plan = Plan::of_model(&built.mechanism.model);
    plan.settings = Settings { tolerance_m, ..plan.settings };
    simulate(&built.mechanism, &built.values, &plan).unwrap_or_else(|failure| panic!("{failure}"))
}

fn lugre(coefficient: f64) -> String {
    let with_static = 1.5 * coefficient;
    format!(
        "{{ law = \"lugre\", coefficient = {coefficient:?}, static_coefficient = {with_static:?}, \
         stribeck_speed = \"10 mm/s\", bristle_stiffness = \"1e5 m^-1\" }}"
    )
}

/// A sled and its arm turn about each other for ever: what goes to and fro between them is a share of what they have.
#[test]
fn identity_the_round_off_of_a_free_motion_is_measured_by_its_energy() {
    /// Of a hundred steps that are each right to 1e-16, with room.
    const ROUND_OFF: f64 = 1e-13;
    let account = report(&build(&file("sled_with_arm.toml")), 0.1).energy.expect("it is integrated");
    assert!(account.relative_residual() < ROUND_OFF, "{account:?}");
    assert!(account.largest_exchange_j > 0.5, "the kinetic energy is that of 0.9 kg at 1.3 m/s: {account:?}");
}

/// Bristles that never slip are springs as stiff as the normal force is large: no friction any more.
#[test]
fn a_law_that_gains_energy_is_a_failed_run_that_keeps_what_was_computed() {
    let gaining = simulated(&slider_crank_with(&lugre(1e4)), 1e-8);
    let Some(RunFailure::LawGainsEnergy { law, joint, gained_j, .. }) = &gaining.failure else {
        panic!("{:?}", gaining.failure)
    };
    assert_eq!((*law, joint.as_deref()), ("friction", Some("gudgeon")));
    let account = gaining.report.energy.expect("it is integrated");
    // One friction alone: its own loss is the whole of friction's.
    assert!((gained_j + account.friction_loss_j).abs() < 1e-9 * gained_j, "{gained_j} {account:?}");
    assert!(account.relative_residual() < 1e-6, "the steps follow the law: {account:?}");
    assert_eq!(gaining.record.time_s.len(), 251);
    let StopReason::Failed { code, words } = &gaining.record.stop else { panic!("{:?}", gaining.record.stop) };
    assert_eq!(code, "law_gains_energy");
    assert!(words.starts_with("friction in joint 'gudgeon' released "), "{words}");

    let losing = simulated(&slider_crank_with(&lugre(0.1)), 1e-8);
    assert_eq!((losing.failure, losing.record.stop), (None, StopReason::Finished));
    assert!(losing.report.friction_losses[0].loss_j > 1.0);
}

/// The gain of one joint is seen beside the loss of another.
/// (With 0.9 in place of 0.4 the motion is so irregular that the last digits decide whether the joint gains.)
#[test]
fn a_law_that_gains_energy_does_not_hide_behind_another_that_loses_more() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slider_crank_friction/model.toml");
    let text = std::fs::read_to_string(path).expect("the case is there");
    let own = "friction = { law = \"ambrosio\", coefficient = 0.03 }";
    let (pin, rubbing) = ("journal = \"rod.big_end\"\n", "friction = { coefficient = 0.4 }\npin_radius = \"9 mm\"\n");
    let text = text.replace(own, &format!("friction = {}", lugre(1e4)));
    let built = build(&text.replace(pin, &format!("{pin}{rubbing}")));
    let run = simulated(&built, 1e-8);
    let account = run.report.energy.expect("it is integrated");
    assert!(account.friction_loss_j > 0.0, "all frictions together lose: {account:?}");
    assert!(matches!(run.failure, Some(RunFailure::LawGainsEnergy { joint: Some(_), .. })), "{:?}", run.failure);
}

/// Steps as long as they may be, too long for its contacts: 2 mm is asked for, the clearance is 0.5 mm.
#[test]
fn a_run_whose_energy_account_does_not_close_is_a_failed_run() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slider_crank_5000/model.toml");
    let built = build(&std::fs::read_to_string(path).expect("the case is there"));
    let coarse = simulated(&built, 2e-3);
    let share = coarse.record.energy.relative_residual;
    assert!(share > 1e-4, "{share}");
    assert!(matches!(coarse.failure, Some(RunFailure::EnergyNotBalanced { .. })), "{:?}", coarse.failure);
    let StopReason::Failed { code, .. } = &coarse.record.stop else { panic!("{:?}", coarse.record.stop) };
    assert_eq!(code, "energy_not_balanced");
    assert_eq!(simulated(&built, 1e-6).failure, None);
}

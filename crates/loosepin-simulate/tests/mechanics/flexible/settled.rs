//! Beams that start settled: statics, the rigid limit by another program, and that they do not ring.

use super::{case_text, four_bar_with_rigid_coupler, outcome, record};
use crate::elements::{build, file};
use loosepin_result::simulation::SimulationRecord;
use loosepin_simulate::RunFailure;

fn values<'r>(record: &'r SimulationRecord, output: &str) -> &'r [f64] {
    &record.outputs.iter().find(|history| history.name == output).expect("an output").value_si
}

/// The blade of 8 m on a hub that stands still for 0.5 s.
fn blade(gravity_m_s2: f64, angle_deg: f64, shapes: usize) -> String {
    let text = file("flexible_spin_up.toml");
    let motion = text.lines().find(|line| line.starts_with("motion = ")).expect("a motion");
    text.replace(motion, "motion = { kind = \"expression\", position = \"0 rad/s * time\" }")
        .replace("gravity = \"0 m/s^2\"", &format!("gravity = \"{gravity_m_s2} m/s^2\""))
        .replace("angle = \"0 deg\"", &format!("angle = \"{angle_deg} deg\""))
        .replace("duration = \"15 s\"", "duration = \"0.5 s\"")
        .replace("lateral_shapes = 3", &format!("lateral_shapes = {shapes}\nstart = \"settled\""))
}

/// Under its own weight the tip of a cantilever hangs down by ρA g L⁴/(8 EI), and stays there.
#[test]
fn analytic_a_cantilever_hangs_by_its_own_weight() {
    /// What shapes beyond the eighth add, and the second order of the slope of 0.002.
    const RELATIVE: f64 = 2e-5;
    let record = record(&blade(0.1, 0.0, 8));
    let across = values(&record, "across");
    let due_m = -2766.7 * 72.968e-6 * 0.1 * 8.0_f64.powi(4) / (8.0 * 68.952e9 * 8.2189e-9);
    assert!(record.bending[0].starts_settled);
    for found_m in across {
        assert!((found_m / due_m - 1.0).abs() < RELATIVE, "{found_m} m for {due_m} m");
    }
    let [least, most] = [f64::min, f64::max].map(|of| across.iter().copied().reduce(of).expect("rows"));
    assert!(most - least < 1e-9 * due_m.abs(), "{least} to {most}");
}

/// A column that stands on its root bears its own weight up to ρA g L³/EI = 7.8373 (Greenhill); beyond, its start is refused.
#[test]
fn analytic_a_column_that_buckles_by_its_own_weight_has_no_settled_start() {
    let critical_m_s2 = 7.83735 * 68.952e9 * 8.2189e-9 / (2766.7 * 72.968e-6 * 512.0);
    let straight = outcome(&blade(0.999 * critical_m_s2, 90.0, 3)).unwrap_or_else(|failure| panic!("{failure}"));
    assert!(straight.bending[0].largest_angle_rad < 1e-9, "{:?}", straight.bending);
    let refusal = outcome(&blade(1.001 * critical_m_s2, 90.0, 3)).expect_err("it buckles");
    assert_eq!(refusal, RunFailure::NotSettled);
    assert_eq!(refusal.code(), "not_settled");
    assert_eq!(
        refusal.to_string(),
        "a flexible body with start = \"settled\" has no stable static shape under the forces at the start"
    );
}

/// The four-bar of the case with 1 + 1 shapes, Young's modulus of the coupler times 1, 10, 100, 1000, its contact as it is: onset and speed
/// of the first contact come to those of the rigid coupler as 1/E, by the differences that the other program found.
#[test]
fn peer_the_rigid_limit_from_a_settled_start() {
    /// Of the four digits of the other program.
    const RELATIVE: f64 = 5e-4;
    /// The other program takes the speeds to this.
    const SPEED_M_S: f64 = 1.2e-9;
    let short = |text: String| text.replace("duration = \"20 ms\"", "duration = \"1.1 ms\"");
    let rigid = record(&short(four_bar_with_rigid_coupler())).impacts.swap_remove(0);
    let text = short(case_text("flexible_four_bar"))
        .replace("lateral_shapes = 3\naxial_shapes = 2", "lateral_shapes = 1\naxial_shapes = 1\nstart = \"settled\"");
    let known = [
        (207e9, 1.163e-6, 4.769e-4),
        (207e10, 1.167e-7, 4.762e-5),
        (207e11, 1.167e-8, 4.749e-6),
        (207e12, 1.167e-9, 4.741e-7),
    ];
    for (modulus_pa, onset_s, speed_m_s) in known {
        let stiff = format!("youngs_modulus = \"{modulus_pa} Pa\"\ndensity");
        let first = record(&text.replace("youngs_modulus = \"207 GPa\"\ndensity", &stiff)).impacts.swap_remove(0);
        let (later_s, faster_m_s) = (first.time_s - rigid.time_s, first.speed_m_s - rigid.speed_m_s);
        assert!((later_s / onset_s - 1.0).abs() < RELATIVE, "{modulus_pa:e} Pa: {later_s:e} s for {onset_s:e}");
        assert!(
            (faster_m_s - speed_m_s).abs() < RELATIVE * speed_m_s + SPEED_M_S,
            "{modulus_pa:e} Pa: {faster_m_s:e} m/s for {speed_m_s:e}"
        );
    }
}

/// The four-bar as a closed loop without play: what elasticity adds to the angular velocity of the rocker goes as 1/E from a settled start;
/// a coupler that rings from an undeformed one leaves E^-½.
#[test]
fn identity_a_coupler_that_starts_settled_does_not_ring() {
    let largest_rad_s = |modulus: &str, start: &str| {
        let text = case_text("flexible_four_bar")
            .replace("duration = \"20 ms\"", "duration = \"1.5 ms\"")
            .replace("lateral_shapes = 3\naxial_shapes = 2", "lateral_shapes = 1\naxial_shapes = 1")
            .replace("radial_clearance = \"0.2 mm\"", "radial_clearance = \"0 mm\"")
            .replace(
                "youngs_modulus = \"207 GPa\"\ndensity",
                &format!("youngs_modulus = \"{modulus}\"\n{start}density"),
            );
        let built = build(&text);
        assert_eq!(built.mechanism.real.cuts.len(), 1);
        let record = record(&text);
        assert!(record.energy.relative_residual < 1e-9, "{:e}", record.energy.relative_residual);
        let spin = record.outputs.iter().find(|history| history.name == "rocker_speed").expect("an output");
        spin.deviation_si.iter().fold(0.0_f64, |largest, deviation| largest.max(deviation.abs()))
    };
    let settled = ["2070 GPa", "20700 GPa"].map(|modulus| largest_rad_s(modulus, "start = \"settled\"\n"));
    let undeformed = ["2070 GPa", "20700 GPa"].map(|modulus| largest_rad_s(modulus, ""));
    assert!((settled[0] / settled[1] / 10.0 - 1.0).abs() < 0.05, "{settled:?}");
    assert!((undeformed[0] / undeformed[1] / 10.0_f64.sqrt() - 1.0).abs() < 0.1, "{undeformed:?}");
}

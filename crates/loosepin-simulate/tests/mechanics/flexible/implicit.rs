//! Implicit steps: against another program, and against explicit steps.

use super::{apart, case_text, values};
use crate::elements::{build, file};
use loosepin_result::simulation::SimulationRecord;
use loosepin_simulate::{Integrator, Plan, RunFailure, Settings, simulate};

fn outcome(text: &str, tolerance_m: f64, integrator: Integrator) -> Result<SimulationRecord, RunFailure> {
    let built = build(text);
    let plan = Plan {
        settings: Settings { tolerance_m, integrator, ..Settings::for_simulation() },
        ..Plan::of_model(&built.mechanism.model)
    };
    simulate(&built.mechanism, &built.values, &plan).map(|simulation| simulation.record)
}

fn record(text: &str, tolerance_m: f64, integrator: Integrator) -> SimulationRecord {
    outcome(text, tolerance_m, integrator).unwrap_or_else(|failure| panic!("{failure}"))
}

/// A case with its rod or coupler in absolute nodal coordinates, of a settled start, over a short time.
fn nodal(name: &str, [shapes, keys]: [&str; 2], [duration, short]: [&str; 2]) -> String {
    let text = case_text(name);
    let with = text.replace(shapes, &format!("formulation = \"absolute-nodal\"\n{keys}"));
    assert_ne!(text, with);
    with.replace(&format!("duration = \"{duration}\""), &format!("duration = \"{short}\""))
}

fn slider_crank(keys: &str, short: &str) -> String {
    nodal("flexible_slider_crank", ["lateral_shapes = 2\naxial_shapes = 2", keys], ["10 ms", short])
}

fn four_bar(keys: &str, short: &str) -> String {
    nodal("flexible_four_bar", ["lateral_shapes = 3\naxial_shapes = 2", keys], ["20 ms", short])
}

/// The soft pendulum of another program, which folds: the error falls with the tolerance as order five says.
#[test]
fn peer_the_soft_pendulum_by_implicit_steps() {
    let rows: Vec<Vec<f64>> = include_str!("../../../../loosepin-flexible/src/tests/soft_pendulum.csv")
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|number| number.parse().expect("a number")).collect())
        .collect();
    let error_m = |tolerance_m: f64| {
        let record = record(&file("nodal_pendulum.toml"), tolerance_m, Integrator::Implicit);
        let tips = values(&record, "tip_x").iter().zip(values(&record, "tip_y"));
        assert_eq!(rows.len(), record.time_s.len());
        let errors = rows.iter().zip(tips).map(|(row, (x, y))| (x - row[1]).hypot(y - row[2]));
        (errors.fold(0.0, f64::max), record.counters.steps as f64)
    };
    let [(coarse_m, few), (fine_m, many)] = [1e-3, 1e-5].map(error_m);
    assert!(coarse_m < 1e-6 && fine_m < 5e-9, "{coarse_m:e} m, {fine_m:e} m");
    let order = (coarse_m / fine_m).ln() / (many / few).ln();
    assert!(order > 4.0, "{order}");
}

/// First contacts of two mechanisms with 16 elements, by another program; the peak of one of them.
#[test]
fn peer_first_contacts_by_implicit_steps() {
    let keys = "elements = 16";
    let known = [(slider_crank(keys, "0.7 ms"), 2.84637e-4, Some(4085.4)), (four_bar(keys, "1 ms"), 9.942158e-4, None)];
    for (text, onset_s, peak_n) in known {
        let record = record(&text, 1e-5, Integrator::Implicit);
        let first = &record.impacts[0];
        assert!((first.time_s - onset_s).abs() < 1e-9, "{:e} s for {onset_s:e}", first.time_s);
        if let Some(peak_n) = peak_n {
            assert!((first.peak_force_n / peak_n - 1.0).abs() < 1e-3, "{} N for {peak_n}", first.peak_force_n);
        }
        assert!(record.energy.relative_residual < 1e-6, "{:e}", record.energy.relative_residual);
    }
}

/// A closed loop without play: places, forces and stresses come to those of explicit steps, with a tenth of their evaluations.
#[test]
fn identity_a_closed_loop_by_both_kinds_of_steps() {
    let text = slider_crank("elements = 4\nstart = \"settled\"", "1 ms")
        .replace("radial_clearance = \"0.2 mm\"", "radial_clearance = \"0 mm\"")
        + "\n[output.stress]\nstress_in = \"rod\"\n[output.torque]\ntorque_of = \"drive.crank\"\n";
    let explicit = record(&text, 1e-8, Integrator::Explicit);
    for (tolerance_m, slider_m, share, evaluations) in [(1e-4, 2e-8, 1e-2, 10), (1e-6, 2e-11, 5e-5, 3)] {
        let implicit = record(&text, tolerance_m, Integrator::Implicit);
        assert!(evaluations * implicit.counters.evaluations < explicit.counters.evaluations);
        let off_m = apart(&explicit, &implicit, "slider");
        assert!(off_m < slider_m, "{off_m:e} m");
        for output in ["gudgeon_force", "stress", "torque"] {
            let size = values(&explicit, output).iter().fold(0.0_f64, |most, value| most.max(value.abs()));
            let off = apart(&explicit, &implicit, output) / size;
            assert!(off < share, "{output}: {off:e}");
        }
    }
}

/// Damping of the material, friction and impacts: the energy account closes, and histories are those of explicit steps.
#[test]
fn identity_two_floating_links_by_both_kinds_of_steps() {
    let text = file("nodal_two_floating_links.toml").replace("duration = \"6 ms\"", "duration = \"2 ms\"");
    let [explicit, implicit] = [(1e-9, Integrator::Explicit), (1e-6, Integrator::Implicit)]
        .map(|(tolerance_m, integrator)| record(&text, tolerance_m, integrator));
    assert!(!explicit.impacts.is_empty() && explicit.impacts.len() == implicit.impacts.len());
    let off_m = apart(&explicit, &implicit, "head_x");
    assert!(off_m < 1e-8, "{off_m:e} m");
    assert!(implicit.energy.relative_residual < 1e-7, "{:e}", implicit.energy.relative_residual);
}

/// Without nodes there is nothing that implicit steps are for.
#[test]
fn messages_of_implicit_steps_without_nodes() {
    let refusal = outcome(&case_text("flexible_slider_crank"), 1e-6, Integrator::Implicit).expect_err("it is refused");
    assert_eq!(refusal, RunFailure::ImplicitWithoutNodes);
    assert_eq!(refusal.code(), "implicit_without_nodes");
    assert_eq!(
        refusal.to_string(),
        "implicit steps are for mechanisms with a flexible body in absolute nodal coordinates, and this one has none"
    );
}

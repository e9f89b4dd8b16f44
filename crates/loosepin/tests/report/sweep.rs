//! Sweeps: many values of a quantity, looked at once a turn.

use loosepin::mechanism::Mechanism;
use loosepin::model::Model;
use loosepin::report::{sweep_page, sweep_text};
use loosepin::simulate::{Plan, Settings, simulate};
use loosepin::sweep::record::{SweepRecord, SweptJoint};
use loosepin::sweep::{SweepPlan, sections_csv, sweep, sweep_csv};
use std::path::Path;
use std::sync::atomic::AtomicBool;

fn model(case: &str) -> Model {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases").join(case).join("model.toml");
    Model::from_path(&path).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

fn plan(model: &Model, over: &str, points: usize, transient_turns: u32, recorded_turns: u32) -> SweepPlan {
    SweepPlan {
        range: model.parse_setting_range(over).unwrap_or_else(|diagnostic| panic!("{diagnostic:?}")),
        points,
        listed_si: None,
        transient_turns,
        recorded_turns,
        settings: Settings::for_study(),
        overrides: Vec::new(),
    }
}

/// Sweeps with the settings `set`, compiled for the last value.
fn swept(model: &Model, set: &[String], plan: &SweepPlan, threads: usize) -> SweepRecord {
    let set = model.set_values(set).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let values = model.quantities.evaluate(&[(plan.range.id, plan.range.to_si)]).expect("the last value is sound");
    let mechanism = Mechanism::new(model, &values).expect("the model compiles");
    sweep(&mechanism, &set, plan, threads, &|_| (), &AtomicBool::new(false)).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn identity_the_same_for_one_and_two_threads() {
    let model = model("slider_crank_5000");
    let plan = plan(&model, "joint.gudgeon.radial_clearance=0.05mm..0.5mm", 37, 1, 2);
    let [one, two] = [1, 2].map(|threads| swept(&model, &[], &plan, threads));
    assert_eq!(one, two);
    assert_eq!(sweep_csv(&one), sweep_csv(&two));
    assert_eq!(sections_csv(&one).lines().count(), 1 + 37 * 2);
}

#[test]
fn identity_a_section_is_what_a_simulation_shows_at_the_end_of_a_turn() {
    let model = model("slider_crank_5000");
    let plan = plan(&model, "joint.gudgeon.radial_clearance=0.1mm..0.3mm", 3, 0, 2);
    let record = swept(&model, &[], &plan, 1);
    for point in &record.points {
        let values = model.quantities.evaluate(&[(plan.range.id, point.value_si)]).expect("the values are sound");
        let mechanism = Mechanism::new(&model, &values).expect("the model compiles");
        let mut cycle = model.cycle.clone();
        (cycle.transient_turns, cycle.recorded_turns, cycle.samples_per_turn) = (0.0, 2.0, 1);
        let plan = Plan {
            cycle,
            settings: plan.settings,
            with_states: false,
            lyapunov_turns: None,
            second_run: false,
            overrides: Vec::new(),
        };
        let simulation = simulate(&mechanism, &values, &plan).expect("the run is sound");
        let output = &simulation.record.outputs[0];
        assert_eq!((output.name.as_str(), record.outputs[0].name.as_str()), ("slider", "slider"));
        assert_eq!(output.deviation_si[1..], point.sections_si[0][..]);
        let joint = &simulation.record.joints[0];
        assert_eq!(point.joints[0].impacts_per_turn, joint.impacts as f64 / 2.0);
        // The simulation looks for the peak at its samples too.
        assert!(point.joints[0].peak_force_n <= joint.peak_force_n);
        assert!(point.joints[0].flight_share > 0.0 && point.joints[0].flight_share < 1.0);
        assert_eq!(point.joints[0].flight_share, joint.flight_share);
        assert_eq!(point.joints[0].losses_per_turn, joint.losses_per_turn);
        // Every contact that began within the run ended, or lasts to its end; the run began in flight.
        let ended = joint.losses_per_turn * 2.0;
        assert!(ended == joint.contacts as f64 || ended + 1.0 == joint.contacts as f64, "{joint:?}");
        // Contact takes the rest of the time. Gentle contacts are no impacts, and short.
        let touching_s: f64 = simulation.record.impacts.iter().map(|impact| impact.duration_s).sum();
        let end_s = simulation.record.time_s[2];
        assert!((touching_s / end_s + joint.flight_share - 1.0).abs() < 1e-2, "{joint:?}");
        let kind = simulation.record.kind.as_ref().expect("two turns were looked at");
        assert_eq!((kind.turns, kind.period_turns), (2, point.period_turns));
        assert_eq!(kind.outputs[0].deviation_si, point.sections_si[0]);
    }
}

#[test]
fn identity_a_small_play_repeats_itself_and_a_large_play_does_not() {
    let model = model("slider_crank_5000");
    let quiet = plan(&model, "joint.gudgeon.radial_clearance=0.02mm..0.03mm", 2, 60, 6);
    let record = swept(&model, &[], &quiet, 2);
    assert!(record.points.iter().all(|point| point.period_turns == Some(1)), "{:?}", record.points);
    // Held against its bearing all the time: no impacts.
    assert!(record.points.iter().all(|point| point.joints[0].impacts_per_turn == 0.0));
    let wild = plan(&model, "joint.gudgeon.radial_clearance=0.45mm..0.5mm", 2, 20, 12);
    let record = swept(&model, &[], &wild, 2);
    assert!(record.points.iter().all(|point| point.period_turns.is_none()), "{:?}", record.points);
    let text = sweep_text(&record);
    assert!(text.contains("repeats at none of the 2 values of joint.gudgeon.radial_clearance"), "{text}");
}

#[test]
fn identity_a_run_without_clearance_is_of_a_mechanism_of_its_own() {
    let model = model("slider_crank_5000");
    let plan = |over: &str, points| plan(&model, over, points, 0, 2);
    let record = swept(&model, &[], &plan("joint.gudgeon.radial_clearance=0mm..0.3mm", 3), 2);
    assert!(record.points.iter().all(|point| point.failure.is_none()), "{:?}", record.points);
    let without = &record.points[0];
    assert_eq!((without.period_turns, without.joints.as_slice()), (Some(1), &[SweptJoint::without_play()][..]));
    assert!(without.sections_si.iter().flatten().all(|deviation_si| deviation_si.abs() < 1e-15), "{without:?}");
    // The others are as without it.
    let others = swept(&model, &[], &plan("joint.gudgeon.radial_clearance=0.15mm..0.3mm", 2), 1);
    assert_eq!(record.points[1..], others.points);
    assert!(sweep_page(&record).contains("Bifurcation diagram"));
}

#[test]
fn a_run_that_fails_is_a_row_with_its_reason() {
    let model = model("slider_crank_5000");
    // A rod that is shorter than the crank.
    let plan = plan(&model, "parameter.rod_length=20mm..120mm", 3, 0, 2);
    let record = swept(&model, &[], &plan, 1);
    let reason = record.points[0].failure.as_deref().expect("the links cannot close");
    assert!(!reason.is_empty());
    assert!(record.points[1..].iter().all(|point| point.failure.is_none()));
    assert!(
        sweep_csv(&record).lines().nth(1).is_some_and(|row| row.starts_with("0.02,,,,,,,")),
        "{}",
        sweep_csv(&record)
    );
    assert!(sweep_text(&record).contains("1 run failed. The first reason: "), "{}", sweep_text(&record));
    assert!(sweep_page(&record).contains("Bifurcation diagram"));
}

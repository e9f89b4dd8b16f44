//! `loosepin sweep`: what it prints, what it writes, what it refuses.

use super::command_line::{Columns, Desk};

const OVER: &str = "joint.gudgeon.radial_clearance=0.02mm..0.5mm";

#[test]
fn a_sweep_writes_its_files_and_the_same_ones_for_any_number_of_threads() {
    let desk = Desk::with_model("slider_crank_5000");
    let run = |threads: &str, folder: &str| {
        let short = ["--points", "5", "--transient", "3", "--turns", "4", "--threads", threads, "--out", folder];
        desk.succeed(&[&["sweep", "model.toml", "--over", OVER][..], &short].concat())
    };
    let said = run("1", "one");
    assert!(said.output.starts_with("slider-crank at 5000 rpm, play in the gudgeon\n\nThe motion repeats at"));
    run("2", "two");
    for file in ["sweep.csv", "sections.csv", "summary.json", "report.html"] {
        assert_eq!(desk.read(&format!("one/{file}")), desk.read(&format!("two/{file}")), "{file}");
    }
    let sweep = Columns::from_csv(&desk.read("one/sweep.csv"));
    for (value, expected) in sweep.column("value").iter().zip([2e-5, 1.4e-4, 2.6e-4, 3.8e-4, 5e-4]) {
        assert!((value - expected).abs() < 1e-18, "{value} {expected}");
    }
    assert!(sweep.column("gudgeon.peak_force_n").iter().all(|force_n| *force_n > 100.0));
    let sections = Columns::from_csv(&desk.read("one/sections.csv"));
    assert_eq!(sections.names(), ["value", "turn", "slider_m"]);
    assert_eq!(sections.column("turn").len(), 5 * 4);
    // The same words from the stored record.
    let page = desk.read("one/report.html");
    assert_eq!(desk.succeed(&["report", "one"]).output, said.output);
    assert_eq!(desk.read("one/report.html"), page);
}

#[test]
fn what_cannot_be_swept_is_refused_at_its_place() {
    let desk = Desk::with_model("slider_crank_5000");
    let refuse = |over: &str, messages: &str| desk.fail(&["sweep", "model.toml", "--over", over], messages);
    refuse(
        "joint.gudgeon.radial_clearance=0.3mm",
        "--over:1:1: error[E0407]: 'joint.gudgeon.radial_clearance=0.3mm' is not written path=from..to\n\
         hint: for example --over joint.gudgeon.radial_clearance=0.1mm..0.5mm",
    );
    refuse(
        "joint.gudgeon.clearance=0.1mm..0.3mm",
        "--over:1:1: error[E0405]: the model has no quantity 'joint.gudgeon.clearance'\n\
         hint: did you mean 'joint.gudgeon.radial_clearance'?",
    );
    refuse(
        "joint.gudgeon.radial_clearance=0.1..0.3mm",
        "--over:1:32: error[E0303]: joint.gudgeon.radial_clearance is 0.1 without a unit; must be a length\n\
         hint: for example 0.5 mm",
    );
    refuse(
        "joint.gudgeon.radial_clearance=0.2mm..200um",
        "--over:1:1: error[E0501]: joint.gudgeon.radial_clearance goes from 0.2 mm to the same value; must be two different values",
    );
    desk.fail(
        &["sweep", "model.toml", "--over", OVER, "--set", "joint.gudgeon.radial_clearance=0.1mm"],
        "error[E0409]: 'joint.gudgeon.radial_clearance' is set a second time",
    );
}

//! `loosepin simulate` against the numbers of the reference cases, read from the files that it writes.

use super::command_line::{Columns, Desk, Said, case_text};

/// Position over the whole revolution, m: the histories agree with a second run of their own program to better than
/// this, and the play is 5e-4 m.
const POSITION_TOLERANCE_M: f64 = 1e-8;
/// Angles over the whole revolution, rad: the same lengths over links of a tenth of a metre.
const ANGLE_TOLERANCE_RAD: f64 = 1e-7;
/// Velocity, m/s: a time shift of 1e-9 s at accelerations of 3e5 m/s² is 3e-4 m/s.
const VELOCITY_TOLERANCE_M_S: f64 = 1e-3;
/// Share of the largest energy exchanged that may be missing.
const ENERGY_TOLERANCE: f64 = 1e-8;
/// Half a unit of the sixth digit of the smallest of the onsets, s.
const ONSET_TOLERANCE_S: f64 = 5e-10;
/// Six digits of the largest impact speed, m/s.
const IMPACT_SPEED_TOLERANCE_M_S: f64 = 2e-6;

fn largest_difference(ours: &[f64], theirs: &[f64]) -> f64 {
    assert_eq!(ours.len(), theirs.len());
    ours.iter().zip(theirs).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

fn run_with_states(case: &str) -> (Desk, Columns, Columns) {
    let desk = Desk::with_model(case);
    desk.succeed(&[
        "simulate",
        "model.toml",
        "--states",
        "--samples",
        "500",
        "--turns",
        "1",
        "--transient",
        "0",
        "--out",
        "run",
    ]);
    let history = Columns::from_csv(&desk.read("run/history.csv"));
    let reference = Columns::from_csv(&case_text(case, "reference.csv"));
    (desk, history, reference)
}

#[test]
fn peer_history_of_the_slider_crank() {
    let (_desk, history, reference) = run_with_states("slider_crank_5000");
    for (ours, theirs, tolerance) in [
        ("slider", "b3_x", POSITION_TOLERANCE_M),
        ("slider.x_m", "b3_x", POSITION_TOLERANCE_M),
        ("rod.x_m", "b2_x", POSITION_TOLERANCE_M),
        ("rod.y_m", "b2_y", POSITION_TOLERANCE_M),
        ("rod.angle_rad", "b2_a", ANGLE_TOLERANCE_RAD),
        ("slider.vx_m_s", "b3_vx", VELOCITY_TOLERANCE_M_S),
        ("slider_velocity_m_s", "b3_vx", VELOCITY_TOLERANCE_M_S),
    ] {
        let name = if ours == "slider" { "slider_m" } else { ours };
        let difference = largest_difference(&history.column(name), &reference.column(theirs));
        assert!(difference < tolerance, "{name}: {difference:e}");
    }
}

#[test]
fn peer_history_of_the_four_bar() {
    let (_desk, history, reference) = run_with_states("four_bar_600");
    for (body, number) in [("crank", 1), ("coupler", 2), ("rocker", 3)] {
        for (quantity, column, tolerance) in [
            ("x_m", "x", POSITION_TOLERANCE_M),
            ("y_m", "y", POSITION_TOLERANCE_M),
            ("angle_rad", "a", ANGLE_TOLERANCE_RAD),
        ] {
            let ours = history.column(&format!("{body}.{quantity}"));
            let difference = largest_difference(&ours, &reference.column(&format!("b{number}_{column}")));
            assert!(difference < tolerance, "{body}.{quantity}: {difference:e}");
        }
    }
}

#[test]
fn peer_impacts_and_extremes_of_the_slider_crank() {
    let desk = Desk::with_model("slider_crank_5000");
    desk.succeed(&["simulate", "model.toml", "--out", "run"]);
    let impacts = Columns::from_csv(&desk.read("run/impacts.csv"));
    assert_eq!(impacts.names(), ["time_s", "joint", "speed_m_s", "duration_s", "peak_force_n", "separation_speed_m_s"]);
    let (times_s, speeds_m_s) = (impacts.column("time_s"), impacts.column("speed_m_s"));
    assert_eq!(times_s.len(), 26, "contacts in 24 ms");
    let expected =
        [(2.272849e-4, 4.385827), (6.364283e-4, 2.748345), (7.491400e-4, 1.825504), (1.0795440e-3, 1.084726)];
    for (index, (time_s, speed_m_s)) in expected.into_iter().enumerate() {
        assert!((times_s[index] - time_s).abs() < ONSET_TOLERANCE_S, "onset {index}: {:e} s", times_s[index]);
        assert!((speeds_m_s[index] - speed_m_s).abs() < IMPACT_SPEED_TOLERANCE_M_S, "{} m/s", speeds_m_s[index]);
    }
    let summary: serde_json::Value = serde_json::from_str(&desk.read("run/summary.json")).expect("JSON");
    let four_digits = |found: f64, expected: f64| {
        assert!((found - expected).abs() < 1e-4 * expected.abs(), "{found} against {expected}");
    };
    four_digits(summary["joints"][0]["peak_force_n"].as_f64().expect("a force"), 45_870.0);
    let extremes = summary["extremes"].as_array().expect("a list");
    let acceleration =
        extremes.iter().find(|extreme| extreme["name"] == "slider_acceleration").expect("the output is there");
    four_digits(acceleration["minimum"]["value_si"].as_f64().expect("a value"), -327_334.0);
    four_digits(acceleration["maximum"]["value_si"].as_f64().expect("a value"), 141_579.0);
    let residual = summary["energy"]["relative_residual"].as_f64().expect("a share");
    assert!(residual < ENERGY_TOLERANCE, "{residual:e}");
}

/// 0.5 mm of 0.5 mm: the steps are as long as they may be, too long for the contacts.
#[test]
fn a_run_whose_energy_balance_does_not_close_is_an_error_and_keeps_its_files() {
    let desk = Desk::with_model("slider_crank_5000");
    let run = ["simulate", "model.toml", "--tolerance", "0.5 mm", "--out", "run"];
    let said = desk.run(&run);
    assert_eq!(said.status, 2);
    let begins = "warning[E0822]: the tolerance 0.5 mm is more than a hundredth of the smallest clearance, 0.5 mm in joint \
                  'gudgeon'\nhint: a tolerance of at most 0.005 mm resolves it\n";
    assert!(said.messages.starts_with(begins), "{}", said.messages);
    assert!(said.messages.contains("error[E0820]: the energy balance has an error of "), "{}", said.messages);
    assert!(said.output.contains("the run failed: the energy balance has an error of "), "{}", said.output);
    assert!(desk.read("run/history.csv").lines().count() > 250);
    assert!(desk.read("run/report.html").contains("The run failed"));
    let summary: serde_json::Value = serde_json::from_str(&desk.read("run/summary.json")).expect("JSON");
    assert_eq!(summary["stop"]["code"], "energy_not_balanced");
    // What is there already does not turn into a success.
    assert_eq!(desk.run(&run).status, 2);
    assert_eq!(desk.run(&["report", "run"]).status, 2);
}

#[test]
fn a_tolerance_above_the_smallest_clearance_is_refused_before_anything_is_computed() {
    let desk = Desk::with_model("slider_crank_5000");
    let above = |clearance: &str| {
        format!(
            "error[E0822]: the tolerance 0.1 mm is larger than the smallest clearance, {clearance} in joint 'gudgeon'\nhint: a tolerance of at most "
        )
    };
    let refuse = |arguments: &[&str], clearance: &str| {
        let said = desk.run(&[arguments, &["--tolerance", "0.1 mm", "--out", "run"]].concat());
        assert_eq!(said.status, 2);
        assert!(said.messages.starts_with(&above(clearance)), "{}", said.messages);
        assert!(!desk.path("run").exists());
    };
    refuse(&["simulate", "model.toml", "--set", "joint.gudgeon.radial_clearance=0.09mm"], "0.09 mm");
    refuse(
        &["sweep", "model.toml", "--over", "joint.gudgeon.radial_clearance=0mm..0.5mm", "--points", "11"],
        "0.05 mm",
    );
    // Without play there is nothing to hold it against.
    let ideal = [
        "simulate",
        "model.toml",
        "--set",
        "joint.gudgeon.radial_clearance=0mm",
        "--tolerance",
        "0.1 mm",
        "--out",
        "ideal",
    ];
    assert_eq!(desk.succeed(&ideal).messages.matches("E0822").count(), 0);
}

#[test]
fn the_columns_of_a_history() {
    let desk = Desk::with_model("slider_crank_5000");
    desk.succeed(&["simulate", "model.toml", "--turns", "0.1", "--samples", "20", "--out", "plain"]);
    let history = Columns::from_csv(&desk.read("plain/history.csv"));
    let outputs =
        ["time_s", "crank_rad", "slider_m", "slider_velocity_m_s", "slider_acceleration_m_s2", "gudgeon_force_n"];
    let beside = [
        "slider_ideal_m",
        "slider_deviation_m",
        "slider_velocity_ideal_m_s",
        "slider_velocity_deviation_m_s",
        "slider_acceleration_ideal_m_s2",
        "slider_acceleration_deviation_m_s2",
        "gudgeon_force_ideal_n",
        "gudgeon_force_deviation_n",
    ];
    let outputs = [&outputs[..], &beside[..]].concat();
    assert_eq!(history.names(), outputs);
    // Equidistant, 20 rows a turn plus the end; a turn takes 12 ms.
    let expected_s = [0.0, 0.6e-3, 1.2e-3];
    assert!(largest_difference(&history.column("time_s"), &expected_s) < 1e-15);
    desk.succeed(&["simulate", "model.toml", "--turns", "0.1", "--samples", "20", "--states", "--out", "states"]);
    let history = Columns::from_csv(&desk.read("states/history.csv"));
    let bodies = ["crank", "rod", "slider"];
    let mut names: Vec<String> = outputs.iter().map(|name| (*name).to_owned()).collect();
    for quantities in
        [["x_m", "y_m", "angle_rad"], ["vx_m_s", "vy_m_s", "omega_rad_s"], ["ax_m_s2", "ay_m_s2", "alpha_rad_s2"]]
    {
        for body in bodies {
            names.extend(quantities.map(|quantity| format!("{body}.{quantity}")));
        }
    }
    assert_eq!(history.names(), names);
}

#[test]
fn analytic_ideal_values_and_deviations_stand_beside_the_outputs() {
    const ROUND_OFF_M: f64 = 1e-15;
    let desk = Desk::with_model("slider_crank_5000");
    desk.succeed(&["simulate", "model.toml", "--turns", "0.5", "--samples", "40", "--out", "run"]);
    let history = Columns::from_csv(&desk.read("run/history.csv"));
    let [angle_rad, value_m, ideal_m, deviation_m] =
        ["crank_rad", "slider_m", "slider_ideal_m", "slider_deviation_m"].map(|name| history.column(name));
    for row in 0..angle_rad.len() {
        let closed_form_m =
            0.05 * angle_rad[row].cos() + (0.12_f64.powi(2) - (0.05 * angle_rad[row].sin()).powi(2)).sqrt();
        assert!((ideal_m[row] - closed_form_m).abs() < ROUND_OFF_M, "{} against {closed_form_m}", ideal_m[row]);
        assert!((value_m[row] - ideal_m[row] - deviation_m[row]).abs() < ROUND_OFF_M, "row {row}");
    }
    // 0.5 mm of play along the rod, which is inclined by up to asin(50/120): 0.5 mm/0.909 = 0.55 mm, and the penetration.
    let largest_m = deviation_m.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    assert!((0.3e-3..0.56e-3).contains(&largest_m), "{largest_m}");
}

#[test]
fn settings_and_flags_reach_the_run() {
    let desk = Desk::with_model("slider_crank_5000");
    desk.succeed(&[
        "simulate",
        "model.toml",
        "--set",
        "joint.gudgeon.radial_clearance=0.3mm",
        "--set",
        "drive.crank.speed=1000 rpm",
        "--turns",
        "0.25",
        "--transient",
        "0.5",
        "--samples",
        "8",
        "--tolerance",
        "1e-8 m",
        "--out",
        "run",
    ]);
    let summary: serde_json::Value = serde_json::from_str(&desk.read("run/summary.json")).expect("JSON");
    assert_eq!(summary["overrides"][0]["path"], "joint.gudgeon.radial_clearance");
    assert_eq!(summary["overrides"][0]["written"], "0.3mm");
    assert_eq!(summary["joints"][0]["radial_clearance_m"], 0.0003);
    assert_eq!(summary["settings"]["tolerance_m"], 1e-8);
    let history = Columns::from_csv(&desk.read("run/history.csv"));
    assert!(largest_difference(&history.column("time_s"), &[0.03, 0.0375, 0.045]) < 1e-15);
}

#[test]
fn the_kind_of_motion_is_told_and_stored() {
    let desk = Desk::with_model("slider_crank_5000");
    let run =
        ["simulate", "model.toml", "--set", "joint.gudgeon.radial_clearance=0.02mm", "--turns", "4", "--samples", "50"];
    let said = desk.succeed(&[&run[..], &["--transient", "40", "--lyapunov", "20", "--out", "run"]].concat());
    let words = said.output.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("The motion repeats every turn (4 turns examined)."), "{words}");
    assert!(
        words.contains("Largest Lyapunov exponent -") && words.contains("Small differences shrink tenfold"),
        "{words}"
    );
    let summary: serde_json::Value = serde_json::from_str(&desk.read("run/summary.json")).expect("JSON");
    assert_eq!(summary["kind"]["period_turns"], 1);
    assert_eq!(summary["lyapunov"]["kind"], "meet");
    assert_eq!(summary["lyapunov"]["growth"].as_array().map(Vec::len), Some(20));
    assert!(desk.read("run/report.html").contains("Kind of motion"));
}

#[test]
fn identity_a_clearance_of_zero_is_the_ideal_mechanism() {
    let desk = Desk::with_model("slider_crank_5000");
    desk.succeed(&["simulate", "model.toml", "--set", "joint.gudgeon.radial_clearance=0mm", "--out", "run"]);
    let history = Columns::from_csv(&desk.read("run/history.csv"));
    for (angle_rad, x_m) in history.column("crank_rad").into_iter().zip(history.column("slider_m")) {
        let ideal_m = 0.05 * angle_rad.cos() + (0.12_f64.powi(2) - (0.05 * angle_rad.sin()).powi(2)).sqrt();
        assert!((x_m - ideal_m).abs() < 1e-15, "{x_m} against {ideal_m}");
    }
}

#[test]
fn a_finished_run_is_told_and_its_report_written_again() {
    let desk = Desk::with_model("slider_crank_5000");
    let arguments = ["simulate", "model.toml", "--turns", "0.5", "--all"];
    let Said { output, messages, .. } = desk.succeed(&arguments);
    let report = messages.trim_end().strip_prefix("report: ").expect("the place of the report").to_owned();
    let folder = report.strip_suffix("/report.html").expect("in the folder").to_owned();
    let hash = folder.strip_prefix("results/slider-crank-at-5000-rpm-play-in-the-gudgeon/").expect("name and hash");
    assert!(hash.len() == 8 && hash.chars().all(|digit| digit.is_ascii_hexdigit()));
    let history = desk.read(&format!("{folder}/history.csv"));
    let first_page = desk.read(&report);
    desk.write(&report, "spoilt");
    let again = desk.succeed(&arguments);
    assert_eq!(again.output, output);
    assert_eq!(
        again.messages,
        format!(
            "{folder} already holds this simulation: the report is written again (--force runs it again)\nreport: {report}\n"
        )
    );
    assert_eq!(desk.read(&report), first_page);
    desk.write(&report, "spoilt");
    assert_eq!(desk.succeed(&["report", &folder, "--all"]).output, output);
    assert_eq!(desk.read(&report), first_page);
    // Made anew, it is the same.
    desk.succeed(&["simulate", "model.toml", "--turns", "0.5", "--force"]);
    assert_eq!(desk.read(&format!("{folder}/history.csv")), history);
    // Other inputs, another folder.
    let other = desk.succeed(&["simulate", "model.toml", "--turns", "0.4", "--all"]).messages;
    assert_ne!(other.trim_end(), format!("report: {report}"));
}

#[test]
fn two_runs_do_not_write_into_one_folder() {
    let desk = Desk::with_model("slider_crank_5000");
    let others = ["simulate", "model.toml", "--turns", "0.4", "--out", "run", "--force"];
    // Of minutes, so that it is at work when the other one comes.
    let mut first =
        desk.command(&["simulate", "model.toml", "--turns", "2000", "--out", "run"]).spawn().expect("it starts");
    while !desk.path("run/loosepin.json").exists() {
        assert!(first.try_wait().expect("it can be asked").is_none(), "it ended before it had a folder");
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    let second = desk.run(&others);
    first.kill().expect("it is at work still");
    first.wait().expect("it ends");
    assert_eq!(second.status, 2, "{}", second.messages);
    let holder = format!("error[E0907]: run is in use by process {} on ", first.id());
    assert!(second.messages.starts_with(&holder), "{}", second.messages);
    assert!(second.messages.contains(" (simulation 'slider-crank at 5000 rpm, play in the gudgeon', since "));
    // Nobody holds it now, though the file of its lock was left.
    desk.succeed(&others);
    let names =
        std::fs::read_dir(desk.path("run")).expect("a folder").map(|entry| entry.expect("readable").file_name());
    let mut names: Vec<_> = names.map(|name| name.to_string_lossy().into_owned()).collect();
    names.sort();
    assert_eq!(names, ["history.csv", "impacts.csv", "loosepin.json", "report.html", "summary.json"]);
}

#[test]
fn a_result_whose_files_were_changed_is_refused() {
    let desk = Desk::with_model("slider_crank_5000");
    let arguments = ["simulate", "model.toml", "--turns", "0.1", "--out", "run"];
    desk.succeed(&arguments);
    let history = desk.read("run/history.csv");
    desk.write("run/history.csv", &history.replacen('0', "1", 1));
    let refused = "error[E0913]: run/history.csv is not the file that the simulation 'slider-crank at 5000 rpm, play in the \
                   gudgeon' wrote: its BLAKE3 hash is not the one in loosepin.json\n\
                   hint: restore the original file, or run the command again with --force";
    desk.fail(&["report", "run"], refused);
    desk.fail(&arguments, refused);
    std::fs::remove_file(desk.path("run/history.csv")).expect("removable");
    desk.fail(
        &["report", "run"],
        "error[E0913]: run/history.csv is missing; it belongs to the finished simulation 'slider-crank at 5000 rpm, play in the \
         gudgeon'\n\
         hint: restore the file, or run the command again with --force",
    );
    desk.write("run/history.csv", &history);
    desk.succeed(&["report", "run"]);
}

#[test]
fn folders_that_hold_something_else_are_refused() {
    let desk = Desk::with_model("slider_crank_5000");
    desk.succeed(&["simulate", "model.toml", "--turns", "0.5", "--out", "run"]);
    let marker: serde_json::Value = serde_json::from_str(&desk.read("run/loosepin.json")).expect("JSON");
    let inputs = marker["inputs_blake3"].as_str().expect("a hash")[..8].to_owned();
    let before = desk.read("run/history.csv");
    let version = env!("CARGO_PKG_VERSION");
    desk.fail(
        &["simulate", "model.toml", "--turns", "0.4", "--out", "run"],
        &format!(
            "error[E0901]: run contains another simulation, 'slider-crank at 5000 rpm, play in the gudgeon' (inputs {inputs}, version {version}); nothing is overwritten\n\
             hint: give another folder, or replace these results with --force"
        ),
    );
    desk.fail(
        &["motion", "model.toml", "--out", "run"],
        &format!(
            "error[E0901]: run contains a simulation, 'slider-crank at 5000 rpm, play in the gudgeon' (inputs {inputs}, version {version}); nothing is overwritten\n\
             hint: give another folder, or replace these results with --force"
        ),
    );
    assert_eq!(desk.read("run/history.csv"), before);
    desk.fail(
        &["simulate", "model.toml", "--out", "."],
        "error[E0901]: . contains files that are not results, for example 'model.toml'; nothing is overwritten\n\
         hint: give another folder; --force keeps these files, but overwrites those with the same names",
    );
    desk.fail(
        &["simulate", "model.toml", "--out", "model.toml"],
        "error[E0903]: model.toml is a file; expected a folder",
    );
    desk.fail(
        &["report", "."],
        "error[E0902]: . contains no results: it has no loosepin.json\nhint: results are in results/NAME/HASH, or in the folder given with --out",
    );
    desk.fail(
        &["report", "nowhere"],
        "error[E0903]: there is no folder nowhere\nhint: results are in results/NAME/HASH, or in the folder given with --out",
    );
    desk.succeed(&["simulate", "model.toml", "--turns", "0.4", "--out", "run", "--force"]);
    assert_ne!(desk.read("run/history.csv"), before);
}

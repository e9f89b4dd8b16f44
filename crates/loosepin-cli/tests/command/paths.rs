//! Errors of a path against two histories of the same mechanism, one with play and one without.

use super::command_line::{Columns, Desk, case_text};

/// Positions of a history and of a study, each within 1e-8 m.
const TOLERANCE_M: f64 = 2e-8;
/// Poses of a turn.
const POSES: usize = 90;

/// The tool over a turn, m: x, y, and the velocity.
fn tool(history: &Columns) -> Vec<[f64; 4]> {
    let [x, y, angle] = ["coupler.x_m", "coupler.y_m", "coupler.angle_rad"].map(|name| history.column(name));
    let [vx, vy, rate] = ["coupler.vx_m_s", "coupler.vy_m_s", "coupler.omega_rad_s"].map(|name| history.column(name));
    (0..x.len())
        .map(|k| {
            // States are those of the centre of mass, halfway along the coupler.
            let (sine, cosine) = angle[k].sin_cos();
            let arm = [-0.09 * sine, 0.09 * cosine];
            [x[k] + arm[0], y[k] + arm[1], vx[k] - rate[k] * arm[1], vy[k] + rate[k] * arm[0]]
        })
        .collect()
}

#[test]
fn peer_errors_of_a_path_are_those_of_two_histories() {
    let desk = Desk::with_model("four_bar_coupler_path");
    let history = |folder: &str, clearance: &str| {
        let set = ["crank_pin", "coupler_pin"].map(|joint| format!("joint.{joint}.radial_clearance={clearance}"));
        desk.succeed(&[
            "simulate",
            "model.toml",
            "--states",
            "--samples",
            "90",
            "--turns",
            "1",
            "--transient",
            "1",
            "--set",
            &set[0],
            "--set",
            &set[1],
            "--out",
            folder,
        ]);
        tool(&Columns::from_csv(&desk.read(&format!("{folder}/history.csv"))))
    };
    let (real, ideal) = (history("real", "0.05mm"), history("ideal", "0mm"));
    // The study at these clearances alone: each error at each pose.
    let study = case_text("four_bar_coupler_path", "study.toml");
    let (head, _) = study.split_once("[random]").expect("a study with random inputs");
    let ask = |component: &str| {
        format!(
            "[[ask]]\noutput = \"tool\"\ncomponent = \"{component}\"\nof = \"total\"\nat = \"cycle\"\nstatistics = [\"mean\"]\n"
        )
    };
    let tight = head.replace("tolerance = \"1e-7 m\"", "tolerance = \"1e-8 m\"");
    // A study needs something that is uncertain: a clearance, by less than an atom.
    let known =
        "[epistemic]\n\"joint.crank_pin.radial_clearance\" = { interval = [\"0.05 mm\", \"0.0500000001 mm\"] }\n";
    desk.write("one.toml", &format!("{tight}{known}{}", ["along", "normal", "magnitude"].map(ask).concat()));
    desk.succeed(&["study", "one.toml", "--out", "one"]);
    let text = desk.read("one/bounds.csv");
    let (rows, names) = (text.lines().skip(1), Columns::from_csv(&text));
    let [poses, lower, upper] = ["pose_rad", "lower", "upper"].map(|name| names.column(name));
    let outputs: Vec<&str> = rows.map(|row| row.split(',').next().unwrap_or_default()).collect();
    for (component, error) in [
        ("along", (|e: [f64; 2], t: [f64; 2]| e[0] * t[0] + e[1] * t[1]) as fn([f64; 2], [f64; 2]) -> f64),
        ("normal", |e, t| t[0] * e[1] - t[1] * e[0]),
        ("magnitude", |e, _| e[0].hypot(e[1])),
    ] {
        let own: Vec<usize> = (0..outputs.len()).filter(|&k| outputs[k] == format!("tool {component}")).collect();
        assert_eq!(own.len(), POSES, "{component}");
        let mut largest: f64 = 0.0;
        for (pose, &row) in own.iter().enumerate() {
            let ([x, y, ..], [ideal_x, ideal_y, vx, vy]) = (real[pose], ideal[pose]);
            let tangent = [vx, vy].map(|part| part / vx.hypot(vy));
            let expected = error([x - ideal_x, y - ideal_y], tangent);
            largest = largest.max(expected.abs());
            for found in [lower[row], upper[row]] {
                let difference = (found - expected).abs();
                assert!(difference < TOLERANCE_M, "{component} at {} rad: {found} {expected}", poses[row]);
            }
        }
        // A play of 0.05 mm at both ends of the coupler is to be seen.
        assert!(largest > 5e-5, "{component}: {largest}");
    }
}

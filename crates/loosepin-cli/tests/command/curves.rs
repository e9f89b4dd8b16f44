//! Paths of points and curves over the angle of the drive, by command.

use super::command_line::{Columns, Desk, case_text};

/// Positions of two runs of the same mechanism, each within 1e-8 m; the same run read twice is exact but for rounding.
const ROUND_OFF_M: f64 = 1e-12;

#[test]
fn a_path_has_a_figure_numbers_and_columns() {
    let desk = Desk::with_model("four_bar_coupler_path");
    let said = desk.succeed(&["motion", "model.toml", "--path", "coupler.head", "--out", "motion"]);
    assert!(said.output.contains("coupler.head") && said.output.contains("most across"), "{}", said.output);
    let save = ["report", "motion", "--figure", "path.coupler-head", "--svg", "path.svg", "--csv", "path.csv"];
    desk.succeed(&save);
    assert!(desk.read("path.svg").starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"figure trace\""));
    let rows = desk.read("path.csv");
    let head = "angle [deg],x [mm],y [mm],direction of motion [deg],play along [mm],play across [mm]";
    assert_eq!(rows.lines().nth(1), Some(head));
    assert_eq!(rows.lines().count(), 2 + 361);
    let columns = Columns::from_csv(&desk.read("motion/motion.csv"));
    // The end of the coupler is that of the rocker: 180 mm from the bearing at (300, 0) mm.
    for (x_m, y_m) in columns.column("coupler.head_x_m").iter().zip(columns.column("coupler.head_y_m")) {
        assert!(((x_m - 0.3).hypot(y_m) - 0.18).abs() < ROUND_OFF_M, "{x_m} {y_m}");
    }
    for name in ["tool_x_velocity_m_s", "tool_play_along_m", "coupler_rocker_transmission_angle_rad"] {
        assert_eq!(columns.column(name).len(), 361, "{name}");
    }
    assert!(desk.read("motion/report.html").contains("loosepin motion model.toml --path coupler.head"));
    // Without it, it is another result.
    assert_eq!(desk.run(&["motion", "model.toml", "--out", "motion"]).status, 2);
}

#[test]
fn a_point_that_is_not_there_is_told_at_its_place() {
    let desk = Desk::with_model("four_bar_coupler_path");
    let near = "--path:1:1: error[E0401]: --path: there is no point 'coupler.tol'\nhint: did you mean 'coupler.tool'?";
    desk.write("study.toml", &case_text("four_bar_coupler_path", "study.toml"));
    desk.fail(&["study", "study.toml", "--path", "coupler.tol"], near);
    for command in ["motion", "simulate"] {
        desk.fail(&[command, "model.toml", "--path", "coupler.tol"], near);
        desk.fail(
            &[command, "model.toml", "--path", "tool"],
            "--path:1:1: error[E0401]: --path is 'tool'; must be body.point\nhint: for example \"crank.pin\": point 'pin' of body 'crank'",
        );
    }
}

#[test]
fn identity_a_run_records_a_point_as_the_states_of_its_body_have_it() {
    let desk = Desk::with_model("four_bar_coupler_path");
    let short = ["--samples", "40", "--turns", "1", "--transient", "0", "--no-second-run", "--out", "run"];
    desk.succeed(&[&["simulate", "model.toml", "--states", "--path", "coupler.head"][..], &short].concat());
    let history = Columns::from_csv(&desk.read("run/history.csv"));
    let [x, y, angle] = ["coupler.x_m", "coupler.y_m", "coupler.angle_rad"].map(|name| history.column(name));
    let [vx, vy, rate] = ["coupler.vx_m_s", "coupler.vy_m_s", "coupler.omega_rad_s"].map(|name| history.column(name));
    let [ax, ay, second] =
        ["coupler.ax_m_s2", "coupler.ay_m_s2", "coupler.alpha_rad_s2"].map(|name| history.column(name));
    let own = |what: &str| ["x", "y"].map(|axis| history.column(&format!("coupler.head_{}", what.replace('.', axis))));
    let ([px, py], [ux, uy], [bx, by]) = (own("._m"), own("velocity_._m_s"), own("acceleration_._m_s2"));
    for k in 0..x.len() {
        // From the centre of mass, halfway along the coupler, to its end.
        let (sine, cosine) = angle[k].sin_cos();
        let arm = [0.13 * cosine, 0.13 * sine];
        let due = [
            (px[k], x[k] + arm[0], 1.0),
            (py[k], y[k] + arm[1], 1.0),
            (ux[k], vx[k] - rate[k] * arm[1], 1e3),
            (uy[k], vy[k] + rate[k] * arm[0], 1e3),
            (bx[k], ax[k] - second[k] * arm[1] - rate[k] * rate[k] * arm[0], 1e7),
            (by[k], ay[k] + second[k] * arm[0] - rate[k] * rate[k] * arm[1], 1e7),
        ];
        for (found, due, scale) in due {
            assert!((found - due).abs() < ROUND_OFF_M * scale, "{k}: {found} is not {due}");
        }
    }
    desk.succeed(&["report", "run", "--figure", "path.coupler-head", "--svg", "path.svg"]);
    assert!(desk.read("run/report.html").contains("--path coupler.head"), "the command is in the page");
}

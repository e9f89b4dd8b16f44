//! Loads by tables.

use super::{Built, build, crank};
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_mechanics::mechanism::Sample;
use loosepin_mechanics::model::Model;
use loosepin_simulate::{Observer, RunReport, Settings, Step, Window, run};

/// Relative round-off of a few dozen operations.
const ROUND_OFF: f64 = 1e-13;
/// Residual of the energy account over the largest energy exchanged.
const ACCOUNT: f64 = 1e-7;
/// Tolerance of a simulation, m.
const MOTION_M: f64 = 1e-8;

/// A driven crank against loads whose curve is known: through points on a line, or at its points.
#[test]
fn analytic_torque_of_a_drive_against_tables() {
    let speed_rad_s = 7.0 * std::f64::consts::PI;
    let torque = |keys: &str| format!("[load.twist]\nkind = \"torque\"\nbody = \"crank\"\n{keys}\n");
    type Torque = fn(f64, f64) -> f64;
    let cases: [(String, Torque); 5] = [
        // On a line, and level beyond its ends.
        (
            torque("of = \"time\"\npoints = [[\"10 ms\", \"1 N m\"], [\"30 ms\", \"2 N m\"], [\"130 ms\", \"7 N m\"]]"),
            |time, _| 1.0 + 50.0 * (time.clamp(0.01, 0.13) - 0.01),
        ),
        (
            torque("of = \"speed\"\njoint = \"main\"\ncurve = \"spline\"\npoints = [[\"0 rpm\", \"3 N m\"], [\"100 rpm\", \"2 N m\"], [\"300 rpm\", \"0 N m\"]]"),
            |_, _| 0.9,
        ),
        // Round and round, closed by itself and by its last point: 20 deg, 46.46 deg and 196.4 deg are met.
        (
            torque("of = \"angle\"\nperiod = \"90 deg\"\njoint = \"main\"\npoints = [[\"-70 deg\", \"3 N m\"], [\"-43.54 deg\", \"-2 N m\"], [\"-20 deg\", \"5 N m\"]]"),
            |time, _| if time == 0.0 { 3.0 } else if time < 0.1 { -2.0 } else { f64::NAN },
        ),
        (
            torque("of = \"angle\"\nperiod = \"4 rev\"\njoint = \"main\"\ncurve = \"spline\"\npoints = [[\"20 deg\", \"1 N m\"], [\"46.46 deg\", \"-2 N m\"], [\"196.4 deg\", \"5 N m\"], [\"1460 deg\", \"1 N m\"]]"),
            |time, _| if time == 0.0 { 1.0 } else if time < 0.1 { -2.0 } else { 5.0 },
        ),
        // (2.5 bar - 1 bar) 4 cm² = 60 N, at right angles on an arm of 50 mm.
        (
            "[load.gas]\nkind = \"force\"\npoint = \"crank.pin\"\ndirection = \"90 deg\"\nframe = \"body\"\nof = \"time\"\narea = \"4 cm^2\"\nback_pressure = \"1 bar\"\npoints = [[\"0 s\", \"2.5 bar\"], [\"1 s\", \"2.5 bar\"], [\"2 s\", \"2.5 bar\"]]\n".to_owned(),
            |_, _| 3.0,
        ),
    ];
    for (text, torque_n_m) in cases {
        let built = crank("210 rpm", &text);
        let sample = built.sample();
        let mut dynamics = Dynamics::new(&built.mechanism, &sample);
        for time_s in [0.0, 0.021, 0.14] {
            dynamics.evaluate(time_s, &[], &[], &[]);
            let angle_rad = 20.0_f64.to_radians() + speed_rad_s * time_s;
            let expected_n_m = torque_n_m(time_s, angle_rad);
            let found_n_m = -dynamics.drive_force(0);
            let is_told = !expected_n_m.is_nan();
            assert!(
                !is_told || (found_n_m - expected_n_m).abs() < 100.0 * ROUND_OFF,
                "{text}\n{found_n_m} {expected_n_m}"
            );
            assert!((dynamics.powers().loads_w - found_n_m * speed_rad_s).abs() < 100.0 * ROUND_OFF);
        }
    }
}

/// A slider of 0.7 kg that a load moves, from `initial`.
fn slider(load: &str, initial: &str) -> Built {
    build(&format!(
        r#"
name = "slider"
gravity = "0 m/s^2"
[body.ground]
points = {{ o = ["0 mm", "0 mm"] }}
[body.slider]
mass = "0.7 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["0 mm", "0 mm"]
points = {{ pin = ["0 mm", "0 mm"] }}
[joint.rail]
kind = "prismatic"
guide = {{ point = "ground.o", angle = "0 deg" }}
slider = "slider.pin"
[initial.joint.rail]
{initial}
[load.push]
kind = "force"
point = "slider.pin"
direction = "0 deg"
{load}
[cycle]
duration = "1 s"
"#
    ))
}

/// Ends of steps, and position and velocity there.
#[derive(Default)]
struct Ends(Vec<[f64; 3]>);

impl Observer for Ends {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        let time_s = step.end_s;
        let kinematics = &step.end().kinematics;
        self.0.push([time_s, kinematics.poses[1].position_m.x, kinematics.twists[1].linear.x]);
    }
}

fn motion(built: &Built, end_s: f64) -> (Vec<[f64; 3]>, RunReport) {
    let mut ends = Ends::default();
    let window = Window { start_s: 0.0, end_s };
    let report = run(&built.mechanism, &built.sample(), &window, &Settings::for_simulation(), &mut ends)
        .unwrap_or_else(|failure| panic!("{failure}"));
    (ends.0, report)
}

/// A force that grows evenly from 0.1 s to 0.3 s, and rests before and after; and a pulse that comes again every 0.2 s. Steps end where
/// it bends.
#[test]
fn analytic_motion_by_a_force_over_time() {
    let rest = "position = \"0 mm\"\nvelocity = \"0 m/s\"";
    let ramp = "of = \"time\"\npoints = [[\"0.1 s\", \"0 N\"], [\"0.15 s\", \"3.5 N\"], [\"0.3 s\", \"14 N\"]]";
    let (ends, report) = motion(&slider(ramp, rest), 0.5);
    for [time_s, x_m, v_m_s] in &ends {
        // The acceleration grows by 100 m/s³, then it is 20 m/s².
        let (u, w) = ((time_s - 0.1).clamp(0.0, 0.2), (time_s - 0.3).max(0.0));
        let due_m = 100.0 * u.powi(3) / 6.0 + (50.0 * u * u * w + 10.0 * w * w);
        assert!((x_m - due_m).abs() < MOTION_M, "{time_s}: {x_m} {due_m}");
        assert!((v_m_s - 50.0 * u * u - 20.0 * w).abs() < 10.0 * MOTION_M);
    }
    for at_s in [0.1, 0.15, 0.3] {
        assert!(ends.iter().any(|[time_s, ..]| *time_s == at_s), "a step ends at {at_s}");
    }
    let account = report.energy.expect("it is integrated");
    let (_, _, v_m_s) = (0, 0, ends.last().expect("steps")[2]);
    assert!((account.supplied_j - 0.35 * v_m_s * v_m_s).abs() < ACCOUNT && account.relative_residual() < ACCOUNT);

    let pulse = "of = \"time\"\nperiod = \"0.2 s\"\npoints = [[\"0.05 s\", \"0 N\"], [\"0.1 s\", \"4 N\"], [\"0.15 s\", \"0 N\"]]";
    let (ends, _) = motion(&slider(pulse, rest), 0.6);
    let speed_at = |at_s: f64| {
        let end = ends.iter().find(|[time_s, ..]| (time_s - at_s).abs() < 1e-12);
        end.unwrap_or_else(|| panic!("a step ends at {at_s}"))[2]
    };
    let gained = speed_at(0.25) - speed_at(0.05);
    assert!(gained > 0.1 && (speed_at(0.55) - 3.0 * gained + gained - speed_at(0.15)).abs() < 10.0 * MOTION_M);
}

/// F = -k x up to 20 mm and even beyond: harmonic motion inside, parabolas outside. No step ends on the bend by itself.
#[test]
fn analytic_motion_by_a_force_over_the_position() {
    let load = "joint = \"rail\"\nof = \"position\"\npoints = [[\"-20 mm\", \"7 N\"], [\"0 mm\", \"0 N\"], [\"20 mm\", \"-7 N\"]]";
    let built = slider(load, "position = \"0 mm\"\nvelocity = \"1 m/s\"");
    let frequency_rad_s = (350.0_f64 / 0.7).sqrt();
    let leaves_s = (0.02 * frequency_rad_s).asin() / frequency_rad_s;
    let leaves_m_s = (frequency_rad_s * leaves_s).cos();
    let flight_s = 2.0 * leaves_m_s / 10.0;
    let turn_s = leaves_s + 0.5 * flight_s;
    let (ends, _) = motion(&built, turn_s);
    let [_, x_m, v_m_s] = ends.last().expect("steps");
    assert!((x_m - 0.02 - leaves_m_s * leaves_m_s / 20.0).abs() < MOTION_M && v_m_s.abs() < 10.0 * MOTION_M);
    let period_s = 4.0 * leaves_s + 2.0 * flight_s;
    let (ends, report) = motion(&built, 2.0 * period_s);
    let [_, x_m, v_m_s] = ends.last().expect("steps");
    assert!(x_m.abs() < 4.0 * MOTION_M && (v_m_s - 1.0).abs() < 40.0 * MOTION_M, "{x_m} {v_m_s}");
    let account = report.energy.expect("it is integrated");
    // The force of a position gives back all of its work.
    assert!(account.supplied_j.abs() < ACCOUNT && account.relative_residual() < ACCOUNT, "{account:?}");
}

/// A motor whose torque falls evenly from 4 N m at rest to nothing at 150 rad/s runs up a rotor: J ω' = T₀ (1 - ω/ω₀), so
/// ω = ω₀ (1 - exp(-t/τ)) with τ = J ω₀/T₀. Beyond the last point it keeps the torque there and brakes.
#[test]
fn analytic_a_motor_by_its_torque_curve_runs_up() {
    const INERTIA_KG_M2: f64 = 0.01;
    let built = |start: &str| {
        build(&format!(
            r#"
name = "rotor"
gravity = "0 m/s^2"
[body.ground]
points = {{ o = ["0 mm", "0 mm"] }}
[body.rotor]
mass = "2 kg"
inertia = "{INERTIA_KG_M2} kg m^2"
centre_of_mass = ["0 mm", "0 mm"]
points = {{ hub = ["0 mm", "0 mm"] }}
[joint.shaft]
kind = "revolute"
bearing = "ground.o"
journal = "rotor.hub"
[initial.joint.shaft]
angle = "0 deg"
angular_velocity = "{start}"
[load.motor]
kind = "torque"
body = "rotor"
joint = "shaft"
of = "speed"
points = [["0 rad/s", "4 N m"], ["150 rad/s", "0 N m"], ["180 rad/s", "-0.8 N m"]]
[cycle]
duration = "1 s"
"#
        ))
    };
    let ends = |built: &Built, end_s: f64| {
        let mut ends = Turns::default();
        let window = Window { start_s: 0.0, end_s };
        let report = run(&built.mechanism, &built.sample(), &window, &Settings::for_simulation(), &mut ends)
            .unwrap_or_else(|failure| panic!("{failure}"));
        (ends.0, report)
    };
    let tau_s = INERTIA_KG_M2 * 150.0 / 4.0;
    let (run_up, report) = ends(&built("0 rad/s"), 1.0);
    for [time_s, rate_rad_s] in &run_up {
        let due_rad_s = 150.0 * (1.0 - (-time_s / tau_s).exp());
        assert!((rate_rad_s - due_rad_s).abs() < 1e-8 * 150.0, "{time_s}: {rate_rad_s} {due_rad_s}");
    }
    let rate_rad_s = run_up.last().expect("steps")[1];
    let account = report.energy.expect("it is integrated");
    let kinetic_j = 0.5 * INERTIA_KG_M2 * rate_rad_s * rate_rad_s;
    assert!((account.supplied_j - kinetic_j).abs() < 1e-8 * kinetic_j, "{account:?}");
    // From 200 rad/s it brakes with 0.8 N m until 180 rad/s.
    let (braked, _) = ends(&built("200 rad/s"), 0.2);
    for [time_s, rate_rad_s] in &braked {
        assert!((rate_rad_s - (200.0 - 80.0 * time_s)).abs() < 1e-8 * 200.0, "{time_s}: {rate_rad_s}");
    }
}

/// Ends of steps, and angular velocity there.
#[derive(Default)]
struct Turns(Vec<[f64; 2]>);

impl Observer for Turns {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        let time_s = step.end_s;
        self.0.push([time_s, step.end().kinematics.twists[1].angular]);
    }
}

#[test]
fn values_that_do_not_fit_the_period_are_refused() {
    let load =
        "of = \"time\"\nperiod = \"0.2 s\"\npoints = [[\"0 s\", \"3 N\"], [\"0.1 s\", \"4 N\"], [\"0.2 s\", \"3 N\"]]";
    let mechanism = slider(load, "position = \"0 mm\"\nvelocity = \"0 m/s\"").mechanism;
    let refused = |setting: &str| {
        let set =
            mechanism.model.set_values(&[setting.to_owned()]).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        Sample::<f64>::new(&mechanism, &set.values)
            .expect_err("it does not fit")
            .diagnostic(&mechanism.model)
            .to_string()
    };
    assert_eq!(
        refused("load.push.period=0.15s"),
        "model.toml:18:7: error[E0412]: load 'push': the points span 200 ms; they must span at most the period of 150 ms"
    );
    assert_eq!(
        refused("load.push.points.3.force=3.1N"),
        "model.toml:18:7: error[E0412]: load 'push': the last point, one period after the first, is 3.1 N; it must be 3 N, as the first point\nhint: remove the last point: the curve then continues from the point before it to the first point of the next period"
    );
}

/// A table in a file is the table in the model.
#[test]
fn identity_a_file_of_pressures_is_the_table_in_the_model() {
    let with = |keys: &str| {
        let text = format!(
            "[load.gas]\nkind = \"force\"\npoint = \"crank.pin\"\ndirection = \"90 deg\"\njoint = \"main\"\nof = \"angle\"\nperiod = \"720 deg\"\narea = \"50 cm^2\"\n{keys}\n"
        );
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("model.toml");
        std::fs::write(
            &path,
            super::crank_text("speed = \"210 rpm\"\nstart_angle = \"0 deg\"", "drive = \"crank\"", &text),
        )
        .expect("written");
        std::fs::write(
            folder.path().join("diagram.csv"),
            "crank angle [deg], pressure [bar]\n0, 1.2\n370, 54\n720, 1.2\n",
        )
        .expect("written");
        let model = Model::from_path(&path).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        let values = model.quantities.nominal();
        let mechanism = loosepin_mechanics::mechanism::Mechanism::new(&model, &values).expect("it moves");
        Sample::<f64>::new(&mechanism, &values).expect("it fits").numbers()
    };
    let points = "points = [[\"0 deg\", \"1.2 bar\"], [\"370 deg\", \"54 bar\"], [\"720 deg\", \"1.2 bar\"]]";
    assert_eq!(with("csv = \"diagram.csv\""), with(points));
}

//! Curves over the angle of the drive against closed forms: path, velocity, acceleration, transmission angle, mechanical advantage.

use super::motion::plan;
use super::{Built, build_case, build_text};
use loosepin_result::motion::MotionRecord;
use loosepin_simulate::accuracy::{MotionPlan, motion};

/// Round-off of closed loops, relative to the largest value of a curve.
const ROUND_OFF: f64 = 1e-11;

fn with_path(built: &Built, name: &str) -> MotionRecord {
    let paths = built.mechanism.model.points_of_paths(&[name.to_owned()]).expect("a point");
    motion(&built.mechanism, &built.values, &MotionPlan { paths, ..plan(built, 72) }).expect("it turns")
}

fn same(found: &[f64], due: &[f64]) {
    let scale = due.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    assert_eq!(found.len(), due.len());
    for (k, (found, due)) in found.iter().zip(due).enumerate() {
        assert!((found - due).abs() <= ROUND_OFF * scale, "{k}: {found} is not {due}");
    }
}

/// Value and first two derivatives by the angle of the crank.
type Jet = [f64; 3];

/// The coupler's angle by the cosine law, and its derivatives by the loop a e^{iθ} + b e^{iβ} = d + c e^{iγ}: differentiated once and twice,
/// and solved for β' and β'' by the components across the rocker.
fn coupler_angle([d, a, b, c]: [f64; 4], theta: f64) -> Jet {
    let [x, y] = [d - a * theta.cos(), -a * theta.sin()];
    let f = x.hypot(y);
    // Between the diagonal from the crank pin to the rocker's bearing and the coupler.
    let beta = y.atan2(x) + ((b * b + f * f - c * c) / (2.0 * b * f)).acos();
    let gamma = (a * theta.sin() + b * beta.sin()).atan2(a * theta.cos() + b * beta.cos() - d);
    let first = -a / b * (theta - gamma).sin() / (beta - gamma).sin();
    let of_rocker = a / c * (theta - beta).sin() / (gamma - beta).sin();
    let centripetal = a * (theta - gamma).cos() + b * first * first * (beta - gamma).cos() - c * of_rocker * of_rocker;
    [beta, first, -centripetal / (b * (beta - gamma).sin())]
}

#[test]
fn analytic_path_of_a_coupler_point_is_that_of_the_cosine_law_with_its_rates() {
    let built = build_case("four_bar_coupler_path");
    let record = with_path(&built, "coupler.tool");
    let [path] = &record.paths[..] else { panic!("the point of the output, once") };
    let speed = record.drive_speed_rad_s.expect("constant");
    let lengths = [0.3, 0.08, 0.26, 0.18];
    // The tool in the frame of the coupler.
    let [along, across] = [0.13, 0.09];
    let [mut x, mut y] = [[const { Vec::new() }; 3], [const { Vec::new() }; 3]];
    for theta in &record.drive_angle_rad {
        let [beta, first, second] = coupler_angle(lengths, *theta);
        // Complex numbers: r = a e^{iθ} + t e^{iβ}, r' = i a e^{iθ} + i β' t e^{iβ}, r'' = -a e^{iθ} + (i β'' - β'²) t e^{iβ}.
        let arm = [along * beta.cos() - across * beta.sin(), along * beta.sin() + across * beta.cos()];
        let pin = [lengths[1] * theta.cos(), lengths[1] * theta.sin()];
        x[0].push(pin[0] + arm[0]);
        y[0].push(pin[1] + arm[1]);
        x[1].push(speed * (-pin[1] - first * arm[1]));
        y[1].push(speed * (pin[0] + first * arm[0]));
        x[2].push(speed * speed * (-pin[0] - second * arm[1] - first * first * arm[0]));
        y[2].push(speed * speed * (-pin[1] + second * arm[0] - first * first * arm[1]));
    }
    for (found, due) in [&path.x_m, &path.velocity_x_m_s, &path.acceleration_x_m_s2].into_iter().zip(&x) {
        same(found, due);
    }
    for (found, due) in [&path.y_m, &path.velocity_y_m_s, &path.acceleration_y_m_s2].into_iter().zip(&y) {
        same(found, due);
    }
    // Of the path, force along its motion per torque of the crank: ω/|v|.
    let advantage = record.kinematics.mechanical_advantages.iter().find(|each| each.name == "tool").expect("it moves");
    let due: Vec<f64> = x[1].iter().zip(&y[1]).map(|(x, y)| speed / x.hypot(*y)).collect();
    assert_eq!(advantage.unit.symbol(), "1/m");
    same(&advantage.value_si, &due);
    assert!(record.kinematics.mechanical_advantages.iter().all(|each| !each.name.starts_with("tool ")));
}

#[test]
fn analytic_transmission_angle_of_a_four_bar_over_the_cycle() {
    let built = build_case("four_bar_coupler_path");
    let record = with_path(&built, "coupler.tool");
    let [ground, crank, coupler, rocker] = [0.3_f64, 0.08, 0.26, 0.18];
    // The diagonal from crank pin to rocker's bearing, twice by the cosine law.
    let due = record.drive_angle_rad.iter().map(|theta| {
        let square = ground * ground + crank * crank - 2.0 * ground * crank * theta.cos();
        ((coupler * coupler + rocker * rocker - square) / (2.0 * coupler * rocker)).acos()
    });
    same(&record.kinematics.transmission_angles[0].value_rad, &due.collect::<Vec<f64>>());
}

#[test]
fn analytic_rates_pressure_angle_and_advantage_of_a_slider_crank() {
    let built = build_case("slider_crank_5000");
    let record = with_path(&built, "slider.pin");
    let [path] = &record.paths[..] else { panic!("one path") };
    let speed = record.drive_speed_rad_s.expect("constant");
    let [r, l] = [0.05_f64, 0.12];
    let [mut velocities, mut accelerations, mut pressure] = [const { Vec::new() }; 3];
    for theta in &record.drive_angle_rad {
        let (s, c) = theta.sin_cos();
        let root = (l * l - r * r * s * s).sqrt();
        velocities.push(speed * (-r * s - r * r * s * c / root));
        let second = -r * c - r * r * (c * c - s * s) / root - r.powi(4) * s * s * c * c / root.powi(3);
        accelerations.push(speed * speed * second);
        pressure.push((r * s / l).asin().abs());
    }
    same(&path.velocity_x_m_s, &velocities);
    same(&path.acceleration_x_m_s2, &accelerations);
    same(&record.outputs[0].velocity_si, &velocities);
    same(&record.kinematics.transmission_angles[0].value_rad, &pressure);
    let of = |name: &str| {
        &record.kinematics.mechanical_advantages.iter().find(|each| each.name == name).expect(name).value_si
    };
    for (k, velocity) in velocities.iter().enumerate() {
        // Both dead centres are positions of the record.
        let is_dead_centre = k % 36 == 0;
        let due = if is_dead_centre { f64::INFINITY } else { speed / velocity.abs() };
        for found in [of("slider")[k], of("slider.pin")[k]] {
            assert!(found == due || (found - due).abs() < 1e-9 * due, "{k}: {found} is not {due}");
        }
    }
}

/// Golden section on the speed of a slider in closed form: its largest magnitude per rad of the crank.
fn largest_slider_speed_m(r: f64, l: f64) -> f64 {
    let speed = |theta: f64| {
        let (s, c) = theta.sin_cos();
        r * s + r * r * s * c / (l * l - r * r * s * s).sqrt()
    };
    let share = 0.5 * (5.0_f64.sqrt() - 1.0);
    let [mut from, mut to] = [0.5, 2.0];
    for _ in 0..80 {
        let [first, second] = [to - share * (to - from), from + share * (to - from)];
        if speed(first) > speed(second) { to = second } else { from = first }
    }
    speed(0.5 * (from + to))
}

#[test]
fn analytic_the_least_mechanical_advantage_lies_between_the_positions() {
    let built = build_case("slider_crank_5000");
    let paths = built.mechanism.model.points_of_paths(&["slider.pin".to_owned()]).expect("a point");
    let coarse = MotionPlan { paths, ..plan(&built, 40) };
    let record = motion(&built.mechanism, &built.values, &coarse).expect("it turns");
    let due = 1.0 / largest_slider_speed_m(0.05, 0.12);
    for name in ["slider", "slider.pin"] {
        let each = record.kinematics.mechanical_advantages.iter().find(|each| each.name == name).expect(name);
        let least = each.least_si.expect("it is known");
        // The speed changes by the square of the error of the angle.
        assert!((least - due).abs() < 1e-11 * due, "{least} is not {due}");
        let sampled = each.value_si.iter().copied().fold(f64::INFINITY, f64::min);
        assert!(sampled > due * (1.0 + 1e-4), "no position is the one: {sampled}");
    }
}

/// Crank and rocker of a parallelogram turn alike: A = 1, as that of the drive with itself. The drive alone has none.
#[test]
fn analytic_the_rocker_of_a_parallelogram_has_a_mechanical_advantage_and_the_drive_none() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/four_bar_coupler_path/model.toml");
    let mut text = std::fs::read_to_string(path).expect("a case");
    for (from, to) in [
        ("coupler_length = \"260 mm\"", "coupler_length = \"300 mm\""),
        ("rocker_length = \"180 mm\"", "rocker_length = \"80 mm\""),
        ("rocker = \"94 deg\"", "rocker = \"34 deg\""),
    ] {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    text.push_str("\n[output.own]\nangle_of = \"crank\"\n\n[output.follower]\nangle_of = \"rocker\"\n");
    text.push_str("\n[output.back]\nangle_of = \"ground\"\nrelative_to = \"crank\"\n");
    let built = build_text(&text);
    let record = motion(&built.mechanism, &built.values, &plan(&built, 72)).expect("it turns");
    let advantages = &record.kinematics.mechanical_advantages;
    let names: Vec<&str> = advantages.iter().map(|each| each.name.as_str()).collect();
    assert_eq!(names, ["follower", "tool"]);
    assert!(advantages[0].value_si.iter().all(|value| (value - 1.0).abs() < 1e-9), "{:?}", advantages[0].value_si);
    // Each point of the coupler moves on a circle as large as that of the crank.
    assert!(advantages[1].value_si.iter().all(|value| (value * 0.08 - 1.0).abs() < 1e-9));
}

#[test]
fn names_of_points_that_are_not_there_are_told_with_the_nearest() {
    let built = build_case("four_bar_coupler_path");
    let names = ["coupler.toll", "cuopler.tool", "coupler.mid", "tool"].map(str::to_owned);
    let found = built.mechanism.model.points_of_paths(&names).expect_err("no such points").to_string();
    let lines: Vec<&str> = found.lines().collect();
    assert_eq!(
        lines,
        [
            "--path:1:1: error[E0401]: --path: there is no point 'coupler.toll'",
            "hint: did you mean 'coupler.tool'?",
            "--path:1:1: error[E0401]: --path: there is no point 'cuopler.tool'",
            "hint: did you mean 'coupler.tool'?",
            "--path:1:1: error[E0401]: --path: there is no point 'coupler.mid'",
            "hint: available: 'coupler.tail', 'coupler.head' and 'coupler.tool'",
            "--path:1:1: error[E0401]: --path is 'tool'; must be body.point",
            "hint: for example \"crank.pin\": point 'pin' of body 'crank'",
        ]
    );
    let twice = ["crank.pin", "crank.pin"].map(str::to_owned);
    assert_eq!(built.mechanism.model.points_of_paths(&twice).expect("a point").len(), 1);
}

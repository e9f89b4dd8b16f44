//! Actuators that follow a reference.

use super::{Built, build};
use loosepin_math::Vec2;
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_mechanics::mechanism::acceleration_at;
use loosepin_simulate::record::OscillationTrend;
use loosepin_simulate::{Observer, RunReport, Settings, Step, Window, run};

/// Residual of the energy account over the largest energy exchanged.
const ACCOUNT: f64 = 1e-7;
/// Tolerance of the runs below, m: a hundredth of that of a simulation, so that what is left is the law.
const TOLERANCE_M: f64 = 1e-11;
/// Error that this leaves in angles over a few hundred steps, rad.
const ANGLE_RAD: f64 = 1e-9;

/// Values that `look` gives at the ends of all steps.
struct Looks<F, R> {
    look: F,
    found: Vec<(f64, R)>,
}

impl<R, F: FnMut(&Dynamics<'_, f64>) -> R> Observer for Looks<F, R> {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        let time_s = step.end_s;
        let found = (self.look)(step.evaluate(time_s));
        self.found.push((time_s, found));
    }
}

fn looked<R>(built: &Built, end_s: f64, look: impl FnMut(&Dynamics<'_, f64>) -> R) -> (Vec<(f64, R)>, RunReport) {
    let settings = Settings { tolerance_m: TOLERANCE_M, ..Settings::for_simulation() };
    let mut looks = Looks { look, found: Vec::new() };
    let report = run(&built.mechanism, &built.sample(), &Window { start_s: 0.0, end_s }, &settings, &mut looks)
        .unwrap_or_else(|failure| panic!("{failure}"));
    assert!(looks.found.len() > 20, "only {} steps", looks.found.len());
    (looks.found, report)
}

/// Moment of inertia of the arm below about its pivot, kg m².
const INERTIA_KG_M2: f64 = 2e-4 + 0.3 * 0.04 * 0.04;

/// An arm on a pivot, controlled.
fn arm(gravity: &str, control: &str, initial: &str) -> Built {
    build(&format!(
        r#"
name = "arm"
gravity = "{gravity}"
[body.ground]
points = {{ o = ["10 mm", "20 mm"] }}
[body.arm]
mass = "0.3 kg"
inertia = "2e-4 kg m^2"
centre_of_mass = ["40 mm", "0 mm"]
points = {{ eye = ["0 mm", "0 mm"], tip = ["100 mm", "0 mm"] }}
[joint.pivot]
kind = "revolute"
bearing = "ground.o"
journal = "arm.eye"
[control.servo]
joint = "pivot"
{control}
{initial}
[cycle]
duration = "0.7 s"
[output.arm]
angle_of = "arm"
"#
    ))
}

/// Gains that put the closed loop I s³ + k_d s² + k_p s + k_i = 0 to -7 and -5 ± 23i 1/s.
fn gains() -> String {
    let (a, b, w) = (7.0, 5.0, 23.0);
    let proportional = INERTIA_KG_M2 * (2.0 * a * b + b * b + w * w);
    let integral = INERTIA_KG_M2 * a * (b * b + w * w);
    let derivative = INERTIA_KG_M2 * (a + 2.0 * b);
    format!(
        "proportional = \"{proportional:e} N m/rad\"\nintegral = \"{integral:e} N m/(rad s)\"\nderivative = \"{derivative:e} N m s/rad\""
    )
}

fn angle_rad(dynamics: &Dynamics<'_, f64>) -> f64 {
    dynamics.kinematics.poses[1].angle_rad()
}

/// With z = ∫ e dt the closed loop is I z''' + k_d z'' + k_p z' + k_i z = 0: z = A exp(-a t) + exp(-b t) (B cos wt + C sin wt).
#[test]
fn analytic_an_arm_under_pid_follows_its_closed_loop() {
    let reference = "motion = { kind = \"polynomial\", coefficients = [\"0.8 rad\"] }";
    let initial = "[initial.joint.pivot]\nangle = \"-0.5 rad\"\nangular_velocity = \"3 rad/s\"";
    let built = arm("0 m/s^2", &format!("{}\n{reference}", gains()), initial);
    let (a, b, w): (f64, f64, f64) = (7.0, 5.0, 23.0);
    // z = 0, z' = e = 1.3 and z'' = -3 at time zero give A = -B, then two equations for A and C.
    let (e, rate) = (1.3, -3.0);
    // (b - a) A + w C = e;  (a² - b² + w²) A - 2 b w C = rate.
    let big_a = (rate + 2.0 * b * e) / (a * a - b * b + w * w + 2.0 * b * (b - a));
    let c = (e - (b - a) * big_a) / w;
    let error = |t: f64| {
        let (sine, cosine) = (w * t).sin_cos();
        -a * big_a * (-a * t).exp()
            + (-b * t).exp() * (-b * (-big_a * cosine + c * sine) + w * (big_a * sine + c * cosine))
    };
    assert!((error(0.0) - e).abs() < 1e-14);
    let (found, report) = looked(&built, 0.7, angle_rad);
    for (t, angle_rad) in found {
        let exact = 0.8 - error(t);
        assert!((angle_rad - exact).abs() < ANGLE_RAD, "at {t}: {angle_rad} {exact}");
    }
    let account = report.energy.expect("it is integrated");
    assert!(account.relative_residual() < ACCOUNT, "{account:?}");
    assert!(account.supplied_j.abs() > 1e-3, "the actuator works: {account:?}");
}

/// While the actuator is at its limit the arm accelerates evenly; then the loop takes over, and the account still closes.
#[test]
fn analytic_an_actuator_at_its_limit_pushes_evenly() {
    let reference = "motion = { kind = \"polynomial\", coefficients = [\"2 rad\"] }";
    let control = "proportional = \"0.9 N m/rad\"\nderivative = \"0.03 N m s/rad\"\nlimit = \"0.4 N m\"";
    let initial = "[initial.joint.pivot]\nangle = \"-0.5 rad\"";
    let built = arm("0 m/s^2", &format!("{control}\n{reference}"), initial);
    let (found, report) = looked(&built, 0.7, |dynamics| [angle_rad(dynamics), dynamics.actuators()[0].effort]);
    let alpha = 0.4 / INERTIA_KG_M2;
    // 0.9 e - 0.03 ω falls to 0.4 at 0.9 (2.5 - α t²/2) - 0.03 α t = 0.4.
    let leaves_s = {
        let (p, q) = (0.03 / 0.45, (0.9 * 2.5 - 0.4) / (0.45 * alpha));
        -p / 2.0 + (p * p / 4.0 + q).sqrt()
    };
    let mut at_limit = 0;
    for (t, [angle_rad, effort]) in &found {
        assert!(effort.abs() <= 0.4, "{effort}");
        if *t <= leaves_s {
            at_limit += 1;
            let exact = -0.5 + 0.5 * alpha * t * t;
            assert!((angle_rad - exact).abs() < ANGLE_RAD && *effort == 0.4, "at {t}: {angle_rad} {exact} {effort}");
        }
    }
    assert!(at_limit > 5 && found.iter().any(|(_, [_, effort])| *effort == -0.4), "it meets both limits");
    let ([angle_rad, _], account) = (found[found.len() - 1].1, report.energy.expect("it is integrated"));
    assert!((angle_rad - 2.0).abs() < 1e-3, "it arrives: {angle_rad}");
    assert!(account.relative_residual() < ACCOUNT, "{account:?}");
}

/// Without anything under [initial] a controlled joint starts on its reference, as fast; with what weight and inertia need fed
/// forward, it stays there.
#[test]
fn identity_inverse_dynamics_fed_forward_keep_a_two_link_arm_on_its_references() {
    let text = r#"
name = "two-link arm"
gravity = "9.81 m/s^2"
[body.ground]
points = { o = ["10 mm", "20 mm"] }
[body.upper]
mass = "1.3 kg"
inertia = "4e-3 kg m^2"
centre_of_mass = ["110 mm", "7 mm"]
points = { eye = ["0 mm", "0 mm"], elbow = ["240 mm", "0 mm"] }
[body.lower]
mass = "0.7 kg"
inertia = "2e-3 kg m^2"
centre_of_mass = ["80 mm", "-4 mm"]
points = { elbow = ["0 mm", "0 mm"], tip = ["190 mm", "0 mm"] }
[body.carriage]
mass = "0.2 kg"
inertia = "3e-4 kg m^2"
centre_of_mass = ["5 mm", "3 mm"]
points = { pin = ["0 mm", "0 mm"] }
[joint.shoulder]
kind = "revolute"
bearing = "ground.o"
journal = "upper.eye"
[joint.elbow]
kind = "revolute"
bearing = "lower.elbow"
journal = "upper.elbow"
[joint.reach]
kind = "prismatic"
guide = { point = "lower.tip", angle = "30 deg" }
slider = "carriage.pin"
[control.shoulder]
joint = "shoulder"
proportional = "20 N m/rad"
derivative = "1.5 N m s/rad"
feed_forward = "inverse dynamics"
motion = { kind = "harmonic", mean = "40 deg", amplitude = "25 deg", frequency = "1.3 Hz" }
[control.elbow]
joint = "elbow"
proportional = "8 N m/rad"
integral = "30 N m/(rad s)"
feed_forward = "inverse dynamics"
motion = { kind = "expression", position = "0.4 rad + 0.9 rad * sin(7 rad/s * time)" }
[control.reach]
joint = "reach"
proportional = "900 N/m"
derivative = "30 N s/m"
feed_forward = "inverse dynamics"
motion = { kind = "cycloidal", from = "0 mm", to = "60 mm", duration = "0.3 s", dwell = "0.1 s" }
[cycle]
duration = "0.8 s"
"#;
    let (found, report) = looked(&build(text), 0.8, |dynamics| {
        let actuators = dynamics.actuators();
        ([actuators[0].error, actuators[1].error, actuators[2].error], actuators[0].effort)
    });
    for (t, (errors, _)) in &found {
        // The errors follow from the tolerance; without the feed-forward they are 1e-2.
        assert!(errors.iter().all(|error| error.abs() < ANGLE_RAD), "at {t}: {errors:?}");
    }
    let largest = found.iter().fold(0.0_f64, |largest, (_, (_, effort))| largest.max(effort.abs()));
    assert!(largest > 3.0, "the arm is heavy: {largest} N m");
    let account = report.energy.expect("it is integrated");
    assert!(account.relative_residual() < ACCOUNT, "{account:?}");
}

/// Linear momentum, kg m/s, and angular momentum about the origin, kg m²/s.
pub(super) fn momentum(dynamics: &Dynamics<'_, f64>) -> [f64; 3] {
    let (mut linear, mut angular) = (Vec2::new(0.0, 0.0), 0.0);
    for (index, numbers) in dynamics.sample().real.links.iter().enumerate() {
        let (pose, twist) = (&dynamics.kinematics.poses[index + 1], &dynamics.kinematics.twists[index + 1]);
        let arm = pose.turn(numbers.centre_of_mass_m);
        let velocity = twist.at(arm);
        linear += velocity * numbers.mass_kg;
        angular += numbers.mass_kg * (pose.position_m + arm).cross(velocity) + numbers.inertia_kg_m2 * twist.angular;
    }
    [linear.x, linear.y, angular]
}

/// Forces of an actuator are internal: a satellite that swings its arm and pushes its boom keeps its momentum.
#[test]
fn identity_actuators_keep_the_momentum_of_a_free_base() {
    let built = build(
        r#"
name = "satellite"
gravity = "0 m/s^2"
[body.ground]
points = { o = ["0 mm", "0 mm"] }
[body.base]
mass = "4 kg"
inertia = "0.05 kg m^2"
centre_of_mass = ["20 mm", "-10 mm"]
points = { hinge = ["120 mm", "30 mm"], rail = ["-90 mm", "40 mm"] }
[body.arm]
mass = "0.7 kg"
inertia = "2e-3 kg m^2"
centre_of_mass = ["80 mm", "-4 mm"]
points = { eye = ["0 mm", "0 mm"], tip = ["190 mm", "0 mm"] }
[body.boom]
mass = "0.5 kg"
inertia = "9e-4 kg m^2"
centre_of_mass = ["5 mm", "33 mm"]
points = { pin = ["0 mm", "0 mm"] }
[joint.hinge]
kind = "revolute"
bearing = "base.hinge"
journal = "arm.eye"
[joint.rail]
kind = "prismatic"
guide = { point = "base.rail", angle = "100 deg" }
slider = { point = "boom.pin", angle = "80 deg" }
[control.hinge]
joint = "hinge"
proportional = "6 N m/rad"
integral = "9 N m/(rad s)"
derivative = "0.4 N m s/rad"
feed_forward = "0.2 N m * cos(8 rad/s * time) - 0.05 N m s/rad * speed"
speed = "40 deg/s"
start_angle = "15 deg"
[control.rail]
joint = "rail"
measured = "hinge"
proportional = "11 N/rad"
motion = { kind = "harmonic", mean = "10 deg", amplitude = "20 deg", frequency = "0.9 Hz" }
[initial.body.base]
position = ["30 mm", "50 mm"]
velocity = ["0.2 m/s", "-0.1 m/s"]
angle = "20 deg"
angular_velocity = "0.7 rad/s"
[initial.joint.hinge]
angle = "-10 deg"
angular_velocity = "0.3 rad/s"
[initial.joint.rail]
position = "15 mm"
velocity = "0.1 m/s"
[cycle]
duration = "0.9 s"
"#,
    );
    let (found, report) = looked(&built, 0.9, momentum);
    let start = found[0].1;
    for (t, momentum) in &found {
        let departs = momentum.iter().zip(start).fold(0.0_f64, |most, (now, then)| most.max((now - then).abs()));
        // The tolerance on velocities, m/s, times the masses.
        assert!(departs < 1e-9, "at {t}: {momentum:?} {start:?}");
    }
    let account = report.energy.expect("it is integrated");
    assert!(account.relative_residual() < ACCOUNT && account.supplied_j.abs() > 1e-3, "{account:?}");
    // Newton's second law for the boom: its guide, with the actuator, does all of it.
    let (found, _) = looked(&built, 0.9, |dynamics| {
        let mechanism = dynamics.mechanism();
        let slot = mechanism.real.slot_of_body[3];
        let arm = dynamics.kinematics.poses[slot].turn(dynamics.sample().real.links[slot - 1].centre_of_mass_m);
        let acceleration = acceleration_at(&dynamics.acceleration(slot), &dynamics.kinematics.twists[slot], arm);
        let joint = mechanism.model.joints.iter().position(|joint| joint.name == "rail").expect("it is there");
        (acceleration * 0.5 - dynamics.joint_force_n(loosepin_mechanics::model::JointId(joint))).length()
    });
    assert!(found.iter().all(|(_, defect_n)| *defect_n < 1e-12), "{found:?}");
}

/// Amplitude, rad, and period, s, of the swings of the load of `backlash.toml`, by `backlash_limit_cycle.py 12`.
const BACKLASH_SWING: [f64; 2] = [0.003_540_77, 0.391_812_19];
/// Difference allowed between the two programs, relative: the largest error lies between rows 0.5 ms and 0.1 ms apart.
const SWING: f64 = 2e-4;

/// Integral action through backlash never comes to rest; without the play it does.
#[test]
fn peer_backlash_keeps_a_servo_swinging() {
    let text = super::file("backlash.toml");
    let built = build(&text);
    let record = super::initial::simulated(&built).record;
    let swing = record.controls[0].swing.expect("it keeps swinging");
    assert_eq!(swing.course, OscillationTrend::Steady);
    let [amplitude_rad, period_s] = BACKLASH_SWING;
    assert!((swing.amplitude_si / amplitude_rad - 1.0).abs() < SWING, "{swing:?}");
    assert!((swing.period_s / period_s - 1.0).abs() < SWING, "{swing:?}");
    assert!(record.energy.relative_residual < ACCOUNT, "{}", record.energy.relative_residual);

    let without = build(&text.replace("radial_clearance = \"0.3 mm\"", "radial_clearance = \"0 mm\""));
    let record = super::initial::simulated(&without).record;
    assert_eq!(record.controls[0].swing, None);
    let last = record.controls[0].error_si[record.controls[0].error_si.len() - 1];
    assert!(last.abs() < 1e-6, "without play it comes to rest: {last}");
}

/// Contact and friction are internal as well: with an arm that hangs on its base with play, linear and angular momentum are kept to
/// round-off.
#[test]
fn identity_a_free_floating_arm_with_friction_in_its_joint_keeps_its_momentum() {
    let built = build(
        r#"
name = "free-floating arm"
gravity = "0 m/s^2"
[body.ground]
points = { o = ["0 mm", "0 mm"] }
[body.base]
mass = "4 kg"
inertia = "0.05 kg m^2"
centre_of_mass = ["20 mm", "-10 mm"]
points = { hinge = ["120 mm", "30 mm"] }
[body.arm]
mass = "0.7 kg"
inertia = "2e-3 kg m^2"
centre_of_mass = ["80 mm", "-4 mm"]
points = { eye = ["0 mm", "0 mm"], tip = ["190 mm", "0 mm"] }
[contact.bush]
restitution = 0.6
stiffness = "3e8 N/m^1.5"
exponent = 1.5
friction = { coefficient = 0.13 }
[joint.hinge]
kind = "revolute"
bearing = "base.hinge"
journal = "arm.eye"
bearing_radius = "8 mm"
radial_clearance = "0.2 mm"
contact = "bush"
[control.hinge]
joint = "hinge"
proportional = "3 N m/rad"
derivative = "0.1 N m s/rad"
motion = { kind = "harmonic", mean = "10 deg", amplitude = "30 deg", frequency = "4 Hz" }
[initial.body.base]
position = ["30 mm", "50 mm"]
velocity = ["0.2 m/s", "-0.1 m/s"]
angle = "20 deg"
angular_velocity = "0.7 rad/s"
[initial.joint.hinge]
angle = "-10 deg"
angular_velocity = "0.3 rad/s"
[cycle]
duration = "0.3 s"
"#,
    );
    assert_eq!((built.mechanism.degrees_of_freedom, built.mechanism.dynamic_freedoms), (4, 6));
    let (found, report) = looked(&built, 0.3, momentum);
    assert!(report.plays[0].contacts > 2, "{:?}", report.plays);
    let start = found[0].1;
    let largest = start.iter().fold(0.0_f64, |largest, part| largest.max(part.abs()));
    for (t, momentum) in &found {
        let departs = momentum.iter().zip(start).fold(0.0_f64, |most, (now, then)| most.max((now - then).abs()));
        // Round-off of a few thousand steps.
        assert!(departs < 1e-12 * largest, "at {t}: {departs} {momentum:?} {start:?}");
    }
    let account = report.energy.expect("it is integrated");
    assert!(account.relative_residual() < ACCOUNT && account.friction_loss_j > 1e-6, "{account:?}");
}

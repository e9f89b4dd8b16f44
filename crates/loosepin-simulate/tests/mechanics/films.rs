//! Mechanisms with a film of oil: where a journal settles, the energy account, what happens at the edge of dry contact, and what
//! is refused.

use loosepin_mechanics::contact::FILM_LAWS;
use loosepin_mechanics::mechanism::{Mechanism, Sample, SampleError};
use loosepin_mechanics::model::Model;
use loosepin_simulate::{Observer, RunReport, Settings, Step, Window, run};
use std::path::Path;

/// Largest residual over largest exchange of energy: what is asked of a run with a lubricated joint.
const ENERGY_RESIDUAL: f64 = 1e-7;

fn compiled(text: &str) -> Mechanism {
    let model = Model::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    Mechanism::new(&model, &model.quantities.nominal()).unwrap_or_else(|error| panic!("{error}"))
}

/// The last eccentricity of the first joint with play, the largest one, and the signs that w had.
#[derive(Default)]
struct Watcher {
    last_m: [f64; 2],
    largest_m: f64,
    has_wedge: [bool; 2],
}

impl Observer for Watcher {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        let motion = step.set_state(step.end_s).plays()[0];
        let (e, rate) = (motion.eccentricity_m, motion.eccentricity_rate_m_s);
        self.last_m = [e.x, e.y];
        self.largest_m = self.largest_m.max(e.length());
        // w |e|² = (ω_i + ω_j)|e|² - 2 e × ė.
        let wedge = (motion.spins_rad_s[0] + motion.spins_rad_s[1]) * e.length_squared() - 2.0 * e.cross(rate);
        self.has_wedge[usize::from(wedge > 0.0)] = true;
    }
}

fn watched(mechanism: &Mechanism, end_s: f64, settings: &Settings) -> (Watcher, RunReport) {
    let sample = Sample::new(mechanism, &mechanism.model.quantities.nominal()).expect("the sample fits");
    let mut watcher = Watcher::default();
    let window = Window { start_s: 0.0, end_s };
    let report = run(mechanism, &sample, &window, settings, &mut watcher);
    (watcher, report.unwrap_or_else(|failure| panic!("{failure}")))
}

fn residual(report: &RunReport) -> f64 {
    report.energy.expect("a run has an energy account").relative_residual()
}

/// A shaft that turns in a bearing of the ground and carries 21.6 N; it may move along x and y.
fn loaded_journal(law: &str, viscosity_pa_s: f64, length_m: f64) -> Mechanism {
    compiled(&format!(
        r#"
name = "loaded journal"
gravity = "9.81 m/s^2"
[body.ground]
points = {{ o = ["0 mm", "0 mm"] }}
[body.saddle]
mass = "0.4 kg"
inertia = "2e-4 kg m^2"
centre_of_mass = ["0 mm", "0 mm"]
points = {{ p = ["0 mm", "0 mm"] }}
[body.slide]
mass = "0.9 kg"
inertia = "3e-4 kg m^2"
centre_of_mass = ["0 mm", "0 mm"]
points = {{ p = ["0 mm", "0 mm"] }}
[body.shaft]
mass = "1.3 kg"
inertia = "5e-4 kg m^2"
centre_of_mass = ["0 mm", "0 mm"]
points = {{ axis = ["0 mm", "0 mm"] }}
[contact.oiled]
restitution = 0.8
youngs_modulus = "207 GPa"
poisson_ratio = 0.3
film = {{ law = "{law}", viscosity = "{viscosity_pa_s} Pa s", roughness = "2 um" }}
[joint.along_x]
kind = "prismatic"
guide = {{ point = "ground.o", angle = "0 deg" }}
slider = "saddle.p"
[joint.along_y]
kind = "prismatic"
guide = {{ point = "saddle.p", angle = "90 deg" }}
slider = {{ point = "slide.p", angle = "90 deg" }}
[joint.spindle]
kind = "revolute"
bearing = "slide.p"
journal = "shaft.axis"
[joint.bearing]
kind = "revolute"
bearing = "ground.o"
journal = "shaft.axis"
bearing_radius = "12 mm"
bearing_length = "{length_m} m"
radial_clearance = "80 um"
contact = "oiled"
[drive.motor]
joint = "spindle"
speed = "300 rad/s"
start_angle = "0 deg"
[cycle]
drive = "motor"
transient_turns = 0
recorded_turns = 1
samples_per_turn = 100
"#
    ))
}

#[test]
fn analytic_a_loaded_journal_settles_at_its_attitude_angle() {
    /// Positions keep 1e-9 m of a clearance of 80 µm; the angles are given with three digits.
    const CLOSED_FORM: [f64; 2] = [2e-3, 2e-5];
    /// At L/D = 0.02 the bearing is a little longer than infinitely short.
    const FINITE: [f64; 2] = [0.1, 1e-3];
    let (radius_m, clearance_m, speed_rad_s, load_n) = (12e-3, 80e-6, 300.0, (0.9 + 1.3) * 9.81);
    // F_r and F_t of a steady load at ε = 0.5 over μ ω and the factor of the film (`docs/lubrication.md`).
    let short = f64::hypot(0.25 / 0.5625, std::f64::consts::PI * 0.5 / (4.0 * 0.75_f64.powf(1.5)));
    let long = f64::hypot(1.777_778, 4.836_798);
    let viscosity_pa_s = |force: f64, length_m: f64, power: i32| {
        let factor = (length_m / radius_m).powi(power) * radius_m.powi(4) / (clearance_m * clearance_m);
        load_n / (force * speed_rad_s * factor)
    };
    for (law, length_m, force, power, attitude_deg, [of_attitude_deg, of_clearance]) in [
        ("ocvirk", 6e-3, short, 3, 53.680, CLOSED_FORM),
        ("ocvirk-printed", 6e-3, short, 3, 53.680, CLOSED_FORM),
        ("pinkus-sternlicht", 0.2, long, 1, 69.819, CLOSED_FORM),
        ("finite-length", 0.48e-3, short, 3, 53.680, FINITE),
        ("reynolds", 0.48e-3, short, 3, 53.680, FINITE),
    ] {
        let mechanism = loaded_journal(law, viscosity_pa_s(force, length_m, power), length_m);
        let (watcher, report) = watched(&mechanism, 0.5, &Settings::for_simulation());
        let [x_m, y_m] = watcher.last_m;
        let found_deg = x_m.atan2(-y_m).to_degrees();
        let ratio = x_m.hypot(y_m) / clearance_m;
        assert!((found_deg - attitude_deg).abs() < of_attitude_deg, "{law}: {found_deg}, {:?}", report.counters);
        assert!((ratio - 0.5).abs() < of_clearance, "{law}: {ratio}");
        assert!(residual(&report) < ENERGY_RESIDUAL, "{law}: {:e}", residual(&report));
        assert_eq!(report.plays[0].contacts, 0, "{law}: oil keeps them apart");
    }
}

/// The slider-crank at 5000 rpm with oil in its gudgeon: an oscillating pin, so that w goes through zero.
fn slider_crank(film: &str, clearance: &str, friction: &str) -> Mechanism {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slider_crank_5000/model.toml");
    let text = std::fs::read_to_string(file).expect("the case is there");
    compiled(
        &text
            .replace("[joint.main]", &format!("film = {film}\n{friction}\n[joint.main]"))
            .replace("bearing_radius", "bearing_length = \"20 mm\"\nbearing_radius")
            .replace("radial_clearance = \"0.5 mm\"", &format!("radial_clearance = \"{clearance}\"")),
    )
}

#[test]
fn identity_an_oiled_gudgeon_keeps_the_energy_account() {
    for law in FILM_LAWS {
        let film = format!("{{ law = \"{}\", viscosity = \"0.1 Pa s\", roughness = \"4 um\" }}", law.name);
        let mechanism = slider_crank(&film, "0.2 mm", "");
        let (watcher, report) = watched(&mechanism, 0.012, &Settings::for_simulation());
        assert_eq!(watcher.has_wedge, [true, true], "{}: w goes through zero", law.name);
        assert!(watcher.largest_m > 0.16e-3, "{}: {}", law.name, watcher.largest_m);
        assert!(report.energy.is_some_and(|energy| energy.friction_loss_j > 0.0), "{}", law.name);
        assert!(residual(&report) < ENERGY_RESIDUAL, "{}: {:e}", law.name, residual(&report));
    }
}

#[test]
fn identity_a_pin_that_breaks_through_its_film_keeps_the_energy_account() {
    for friction in ["", "friction = { coefficient = 0.06 }"] {
        let film = "{ viscosity = \"0.002 Pa s\", roughness = \"9 um\" }";
        let mechanism = slider_crank(film, "0.45 mm", friction);
        let (watcher, report) = watched(&mechanism, 0.006, &Settings::for_simulation());
        assert!(report.plays[0].contacts > 3 && watcher.largest_m > 0.45e-3, "{:?}", report.plays);
        assert!(residual(&report) < ENERGY_RESIDUAL, "{friction}: {:e}", residual(&report));
    }
}

#[test]
fn identity_much_oil_takes_the_pin_along_its_ideal_motion() {
    // A pin in honey hardly moves in its hole.
    let thick = slider_crank("{ viscosity = \"20 Pa s\", roughness = \"4 um\" }", "0.2 mm", "");
    let (watcher, _) = watched(&thick, 0.003, &Settings::for_study());
    assert!(watcher.largest_m < 0.03e-3, "{}", watcher.largest_m);
}

#[test]
fn a_roughness_that_does_not_go_with_the_clearance_is_refused() {
    let mechanism = slider_crank("{ viscosity = \"0.1 Pa s\", roughness = \"4 um\" }", "0.2 mm", "");
    let roughness = mechanism.model.quantities.id("contact.steel_pin.film.roughness").expect("it has one");
    let sample = |roughness_m: f64| {
        let values = mechanism.model.quantities.evaluate(&[(roughness, roughness_m)]).expect("possible");
        Sample::<f64>::new(&mechanism, &values)
    };
    assert!(sample(0.41e-6).is_ok() && sample(99e-6).is_ok());
    let error = sample(0.39e-6).expect_err("too thin");
    assert_eq!(
        error.to_string(),
        "joint 'gudgeon' has a film by reynolds with a roughness of 0.00039 mm at a radial clearance of 0.2 mm; must be between 0.0004 mm and 0.1 mm"
    );
    assert!(matches!(sample(101e-6), Err(SampleError::RoughnessOutsideFilm { .. })));
    let diagnostic = error.diagnostic(&mechanism.model).to_string();
    assert!(diagnostic.contains("error[E0811]") && diagnostic.contains("hint: the roughness is"), "{diagnostic}");
}

/// The load that Butenschön's table gives for ε = 0.8, L/D = 1 holds a shaft there; the half-Sommerfeld film lets it sink.
#[test]
fn published_a_loaded_journal_settles_where_the_table_says() {
    /// The table and the equation differ by 0.2 % of the load, and its attitude by 0.55°: a film that begins at the widest gap.
    const RATIO: f64 = 1e-3;
    const ATTITUDE_DEG: f64 = 0.7;
    let (radius_m, clearance_m, speed_rad_s, load_n) = (12e-3_f64, 80e-6_f64, 300.0, (0.9 + 1.3) * 9.81);
    let (sommerfeld, attitude_deg) = (3.5663, 36.235);
    let length_m = 2.0 * radius_m;
    let viscosity_pa_s = load_n / (2.0 * sommerfeld * speed_rad_s * length_m * radius_m.powi(3) / clearance_m.powi(2));
    for (law, is_held) in [("reynolds", true), ("finite-length", false)] {
        let mechanism = loaded_journal(law, viscosity_pa_s, length_m);
        let (watcher, report) = watched(&mechanism, 2.0, &Settings::for_simulation());
        let [x_m, y_m] = watcher.last_m;
        let (ratio, found_deg) = (x_m.hypot(y_m) / clearance_m, x_m.atan2(-y_m).to_degrees());
        let is_near = (ratio - 0.8).abs() < RATIO && (found_deg - attitude_deg).abs() < ATTITUDE_DEG;
        assert_eq!(is_near, is_held, "{law}: {ratio} {found_deg}");
        assert!(residual(&report) < ENERGY_RESIDUAL, "{law}: {:e}", residual(&report));
    }
}

#[test]
fn a_bearing_that_is_too_long_for_its_film_is_refused() {
    let mechanism = slider_crank("{ viscosity = \"0.1 Pa s\", roughness = \"4 um\" }", "0.2 mm", "");
    let length = mechanism.model.quantities.id("joint.gudgeon.bearing_length").expect("it has one");
    let sample = |length_m: f64| {
        let values = mechanism.model.quantities.evaluate(&[(length, length_m)]).expect("possible");
        Sample::<f64>::new(&mechanism, &values)
    };
    assert!(sample(79.9e-3).is_ok());
    let error = sample(90e-3).expect_err("too long");
    assert_eq!(
        error.to_string(),
        "joint 'gudgeon' has a film by reynolds with a bearing 4.5 times as long as its diameter; at most 4 times are possible"
    );
    let diagnostic = error.diagnostic(&mechanism.model).to_string();
    assert!(diagnostic.contains("error[E0825]") && diagnostic.contains("hint: use the film"), "{diagnostic}");
}

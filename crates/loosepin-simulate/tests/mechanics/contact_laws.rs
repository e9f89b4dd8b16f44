//! Contact laws in mechanisms: what is refused, what ends a run, and the mass that a contact meets.

use loosepin_mechanics::contact::{FrictionLaw, LINE_LAWS, PlayState};
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_mechanics::mechanism::{IdealMotion, Mechanism, Sample, SampleError, acceleration_at};
use loosepin_mechanics::model::Model;
use loosepin_simulate::{Observer, Onset, RunFailure, Separation, Settings, Step, Window, run};
use std::path::Path;

fn case_text(name: &str) -> String {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases").join(name).join("model.toml");
    std::fs::read_to_string(file).expect("the case is there")
}

/// The slider-crank with a line-contact law.
fn slider_crank(law: &str, youngs_modulus: &str) -> Mechanism {
    let text = case_text("slider_crank_5000")
        .replace("lankarani-nikravesh", law)
        .replace("207 GPa", youngs_modulus)
        .replace("bearing_radius", "bearing_length = \"20 mm\"\nbearing_radius");
    let model = Model::from_text("model.toml", &text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    Mechanism::new(&model, &model.quantities.nominal()).unwrap_or_else(|error| panic!("{error}"))
}

struct Nobody;
impl Observer for Nobody {
    fn step(&mut self, _step: &mut Step<'_, '_>) {}
}

#[test]
fn a_clearance_outside_of_the_fit_is_refused() {
    let mechanism = slider_crank("pereira", "207 GPa");
    let clearance = mechanism.model.quantities.id("joint.gudgeon.radial_clearance").expect("it has one");
    let sample = |clearance_m: f64| {
        Sample::<f64>::new(
            &mechanism,
            &mechanism.model.quantities.evaluate(&[(clearance, clearance_m)]).expect("possible"),
        )
    };
    assert!(sample(5.1e-6).is_ok() && sample(9.9e-3).is_ok());
    let error = sample(4.9e-6).expect_err("too small");
    assert_eq!(
        error.to_string(),
        "joint 'gudgeon' has a radial clearance of 0.0049 mm; 'pereira' was fitted to clearances from 0.005 mm to 10 mm"
    );
    assert!(matches!(error, SampleError::ClearanceOutsideFit { .. }));
    let diagnostic = error.diagnostic(&mechanism.model).to_string();
    assert!(diagnostic.contains("error[E0810]") && diagnostic.contains("hint: use another law"), "{diagnostic}");
}

#[test]
fn identity_a_run_beyond_the_inverse_of_its_law_fails_by_name() {
    let window = Window { start_s: 0.0, end_s: 0.012 };
    for (law, share) in [("johnson", 4.0 / std::f64::consts::E.powi(2)), ("radzimovsky", 0.7165)] {
        // As soft as rubber.
        let mechanism = slider_crank(law, "0.1 GPa");
        let sample = Sample::new(&mechanism, &mechanism.model.quantities.nominal()).expect("the sample fits");
        let failure = run(&mechanism, &sample, &window, &Settings::for_study(), &mut Nobody).expect_err("too deep");
        assert_eq!(failure.code(), "beyond_contact_law", "{failure}");
        let RunFailure::BeyondLaw { penetration_m, limit_m, .. } = failure else { panic!("{failure}") };
        // The limit is known to four digits; a step ends a little beyond it.
        assert!((limit_m / (share * 0.5e-3) - 1.0).abs() < 1e-4, "{limit_m}");
        assert!(penetration_m > limit_m && penetration_m < 1.5 * limit_m, "{penetration_m} {limit_m}");
    }
    // A law without such a limit goes on.
    let mechanism = slider_crank("liu", "0.1 GPa");
    let sample = Sample::new(&mechanism, &mechanism.model.quantities.nominal()).expect("the sample fits");
    let report = run(&mechanism, &sample, &window, &Settings::for_study(), &mut Nobody).expect("no limit");
    assert!(report.plays[0].largest_penetration_m > 0.3e-3, "{:?}", report.plays);
}

#[test]
fn identity_effective_mass_is_the_answer_to_a_contact_force() {
    /// Round-off of accelerations that differ by much more than their size.
    const ROUND_OFF: f64 = 1e-9;
    for name in ["slider_crank_two_clearances", "six_bar", "four_bar_floating_coupler", "five_bar_driven_slider"] {
        let model = Model::from_text(name, &case_text(name)).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        let mechanism = Mechanism::new(&model, &model.quantities.nominal()).expect("it moves");
        let mut sample = Sample::<f64>::new(&mechanism, &model.quantities.nominal()).expect("the sample fits");
        // Friction pushes too.
        sample.plays.iter_mut().for_each(|play| play.friction = FrictionLaw::None);
        let ideal = IdealMotion::new(&mechanism, &sample.ideal, &sample.drives).expect("the start closes");
        let (mut coordinates, rates) = mechanism.real_coordinates(ideal.kinematics(), &sample.real);
        // Off the centres of the bearings, by more than the clearances.
        for (k, coordinate) in coordinates.iter_mut().enumerate() {
            *coordinate += 0.013 * (1.0 + 0.37 * k as f64);
        }
        let n = mechanism.real.free;
        let mut dynamics = Dynamics::new(&mechanism, &sample);
        for play in 0..mechanism.plays.len() {
            let mut states = vec![PlayState::flight(); mechanism.plays.len()];
            let mut along_normal = |states: &[PlayState<f64>]| {
                dynamics.evaluate(0.0, &coordinates[..n], &rates[..n], states);
                let (motion, force) = (&dynamics.plays()[play], &dynamics.contacts()[play]);
                let [bearing, journal] = dynamics.play_slots()[play];
                let twists = &dynamics.kinematics.twists;
                let difference =
                    acceleration_at(&dynamics.acceleration(journal), &twists[journal], motion.journal_arm_m)
                        - acceleration_at(&dynamics.acceleration(bearing), &twists[bearing], motion.bearing_arm_m);
                let normal = motion.eccentricity_m * (1.0 / motion.eccentricity_m.length());
                (difference.dot(normal), force.normal_n, dynamics.inverse_mass_along_normal_1_kg(play))
            };
            let (before, _, inverse_mass_1_kg) = along_normal(&states);
            states[play].contact = 1.0;
            let (after, force_n, again_1_kg) = along_normal(&states);
            assert_eq!(inverse_mass_1_kg, again_1_kg, "{name}: it does not depend on the forces");
            assert!(force_n > 0.0 && inverse_mass_1_kg > 0.1, "{name}: {force_n} {inverse_mass_1_kg}");
            let found_1_kg = (before - after) / force_n;
            assert!(
                (found_1_kg / inverse_mass_1_kg - 1.0).abs() < ROUND_OFF,
                "{name}: {found_1_kg} {inverse_mass_1_kg}"
            );
        }
    }
}

/// Speeds at which contacts begin and end.
#[derive(Default)]
struct Speeds {
    onset_m_s: f64,
    pairs_m_s: Vec<[f64; 2]>,
}
impl Observer for Speeds {
    fn step(&mut self, _step: &mut Step<'_, '_>) {}
    fn contact_begins(&mut self, onset: &Onset) {
        self.onset_m_s = onset.speed_m_s;
    }
    fn contact_ends(&mut self, separation: &Separation) {
        self.pairs_m_s.push([self.onset_m_s, separation.speed_m_s]);
    }
}

#[test]
fn identity_laws_that_promise_a_restitution_deliver_it_in_a_mechanism() {
    /// Effect of the other forces of the mechanism while a contact lasts: slow as it turns, 0.006 with the softest law. Half or twice
    /// the mass that the contact meets would change the restitution by 0.05.
    const OTHER_FORCES: f64 = 8e-3;
    const RESTITUTION: f64 = 0.83;
    let linear = "law = \"exact-linear-restitution\"\nrestitution = 0.83\nstiffness = \"3e9 N/m\"";
    let steel =
        "restitution = 0.83\nyoungs_modulus = \"207 GPa\"\npoisson_ratio = 0.3\ndamping = \"exact-restitution\"";
    let mut laws: Vec<String> = LINE_LAWS.iter().map(|law| format!("law = \"{}\"\n{steel}", law.name)).collect();
    laws.push(linear.to_owned());
    let text = case_text("slider_crank_5000").replace("5000 rpm", "200 rpm");
    let (before, rest) = text.split_once("[contact.steel_pin]").expect("there is a contact");
    let (_, after) = rest.split_once("[joint.main]").expect("joints follow");
    let after = after.replace("bearing_radius", "bearing_length = \"20 mm\"\nbearing_radius");
    for law in laws {
        let text = format!("{before}[contact.steel_pin]\n{law}\n[joint.main]{after}");
        let model = Model::from_text("model.toml", &text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        let mechanism = Mechanism::new(&model, &model.quantities.nominal()).expect("it moves");
        let sample = Sample::new(&mechanism, &model.quantities.nominal()).expect("the sample fits");
        let delivered = sample.plays[0].delivered_restitution.expect("it is known");
        assert!((delivered - RESTITUTION).abs() < 1e-12, "{law}: {delivered}");
        let window = Window { start_s: 0.0, end_s: 0.1 };
        let mut speeds = Speeds::default();
        run(&mechanism, &sample, &window, &Settings::for_study(), &mut speeds).expect("the run is sound");
        let impacts: Vec<&[f64; 2]> = speeds.pairs_m_s.iter().filter(|[onset, _]| *onset > 0.13).collect();
        assert!(!impacts.is_empty(), "{law}: {:?}", speeds.pairs_m_s);
        for [onset_m_s, separation_m_s] in impacts {
            let found = separation_m_s / onset_m_s;
            assert!((found - RESTITUTION).abs() < OTHER_FORCES, "{law}: {onset_m_s} m/s, {found}");
        }
    }
}

//! A follower that may lift off its cam.

use super::{build, file};
use loosepin_simulate::{Observer, Onset, RunReport, Separation, Settings, Step, Window, run};

/// Residual of the energy account over the largest energy exchanged.
const ACCOUNT: f64 = 1e-8;
/// Mass of the follower, kg; amplitude of its lift A (1 - cos θ), m; stiffness of the spring, N/m, and its force at the lowest
/// place, N.
const MASS_KG: f64 = 0.2;
const AMPLITUDE_M: f64 = 6e-3;
const STIFFNESS_N_M: f64 = 500.0;
const LOWEST_N: f64 = 10.0;
const GRAVITY_M_S2: f64 = 9.81;

/// Times at which contact ends, and speeds of the follower's impacts.
#[derive(Default)]
struct Seen {
    separations_s: Vec<f64>,
    onsets_m_s: Vec<f64>,
}

impl Observer for Seen {
    fn step(&mut self, _step: &mut Step<'_, '_>) {}
    fn contact_begins(&mut self, onset: &Onset) {
        self.onsets_m_s.push(onset.speed_m_s);
    }
    fn contact_ends(&mut self, separation: &Separation) {
        self.separations_s.push(separation.time_s);
    }
}

/// One turn of the cam at a speed.
fn turned(speed_rad_s: f64) -> (Seen, RunReport) {
    let text = file("cam_lift_off.toml").replace("1200 rpm", &format!("{speed_rad_s} rad/s"));
    let built = build(&text);
    assert!(built.mechanism.is_driven() && built.mechanism.contact_name(0) == "lift");
    let mut seen = Seen::default();
    let window = Window { start_s: 0.0, end_s: std::f64::consts::TAU / speed_rad_s };
    let report = run(&built.mechanism, &built.sample(), &window, &Settings::for_simulation(), &mut seen)
        .unwrap_or_else(|failure| panic!("{failure}"));
    (seen, report)
}

/// On a stiff cam N = m A ω² cos θ + m g + F0 + k A (1 - cos θ), least at θ = 180°: the follower lifts off above
/// ω² = (m g + F0 + 2 k A)/(m A), where cos θ = -(m g + F0 + k A)/(A (m ω² - k)).
#[test]
fn analytic_a_follower_lifts_off_at_the_speed_and_angle_of_theory() {
    /// The profile is a spline through every third degree, whose curvature errs by 2e-4; and the contact gives way, with a time
    /// D/K of 3e-5 s.
    const ANGLE_DEG: f64 = 0.3;
    let held_n = MASS_KG * GRAVITY_M_S2 + LOWEST_N;
    let critical_rad_s = ((held_n + 2.0 * STIFFNESS_N_M * AMPLITUDE_M) / (MASS_KG * AMPLITUDE_M)).sqrt();
    for share in [0.9, 0.98, 0.995] {
        let (seen, report) = turned(share * critical_rad_s);
        assert_eq!((seen.separations_s.len(), report.plays[0].contacts), (0, 1), "at {share} of the speed");
    }
    for share in [1.01, 1.03, 1.2] {
        let speed_rad_s = share * critical_rad_s;
        let (seen, report) = turned(speed_rad_s);
        let found_deg = (seen.separations_s[0] * speed_rad_s).to_degrees();
        let cosine = -(held_n + STIFFNESS_N_M * AMPLITUDE_M)
            / (AMPLITUDE_M * (MASS_KG * speed_rad_s * speed_rad_s - STIFFNESS_N_M));
        let due_deg = cosine.acos().to_degrees();
        println!("{share}: {found_deg} {due_deg}");
        assert!((found_deg - due_deg).abs() < ANGLE_DEG, "at {share} of the speed: {found_deg} {due_deg}");
        assert!(report.plays[0].contacts > 1 && seen.onsets_m_s[1] > 0.0, "it comes back: {:?}", report.plays);
        let account = report.energy.expect("it is integrated");
        assert!(account.relative_residual() < ACCOUNT && account.contact_loss_j > 0.0, "{account:?}");
    }
}

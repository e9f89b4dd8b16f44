//! Momenta, energy and power.

use super::{POWER_OUTPUTS, assert_power_of_the_drive, case_text};
use crate::elements::{build, file};
use loosepin_math::Vec2;
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_simulate::{Observer, Plan, Settings, Step, Window, run, simulate};

/// Momentum, kg m/s, and angular momentum about the origin, kg m²/s, of all flexible bodies, point by point, and of their lumps.
fn momenta(dynamics: &Dynamics<'_, f64>) -> [f64; 3] {
    let tree = &dynamics.mechanism().real;
    let (coordinates, rates) = dynamics.free_state();
    let mut sums = [0.0; 3];
    for (place, numbers) in tree.beams.iter().zip(&dynamics.sample().real.beams) {
        let (pose, twist) = (&dynamics.kinematics.poses[place.slot], &dynamics.kinematics.twists[place.slot]);
        let axis = pose.turn(numbers.axis);
        let (q, q_rates) = (&coordinates[place.coordinates.clone()], &rates[place.coordinates.clone()]);
        for point in &place.shapes.points {
            let mass_kg = numbers.beam.mass_kg * point.weight;
            let reach = pose.turn(numbers.root_m) + numbers.beam.point_m(&point.station, q).rotated(axis.y, axis.x);
            let rate = numbers.beam.rate_m_s(&point.station, q, q_rates).rotated(axis.y, axis.x);
            let velocity: Vec2<f64> = twist.at(reach) + rate;
            sums[0] += mass_kg * velocity.x;
            sums[1] += mass_kg * velocity.y;
            sums[2] += mass_kg * (pose.position_m + reach).cross(velocity);
        }
    }
    for (index, (link, numbers)) in tree.links.iter().zip(&dynamics.sample().real.links).enumerate() {
        if !link.has_own_mass {
            continue;
        }
        let (pose, twist) = (&dynamics.kinematics.poses[index + 1], &dynamics.kinematics.twists[index + 1]);
        let reach = pose.turn(numbers.centre_of_mass_m);
        let momentum = twist.at(reach) * numbers.mass_kg;
        sums[0] += momentum.x;
        sums[1] += momentum.y;
        sums[2] += (pose.position_m + reach).cross(momentum) + numbers.inertia_kg_m2 * twist.angular;
    }
    sums
}

/// Force and couple of a contact with friction act on the sections: nothing is gained or lost but by friction, impacts and damping.
#[test]
fn identity_momenta_and_energy_of_two_floating_links_with_friction() {
    watched_momenta(&file("flexible_two_floating_links.toml"), 6 + 5 + 3);
}

/// The same with lumps that have inertia, at ends and beside the axis.
#[test]
fn identity_momenta_and_energy_of_two_floating_links_with_lumps() {
    watched_momenta(&file("flexible_lumps.toml"), 6 + 7 + 5);
}

/// Runs two floating links, of `free` coordinates, and demands that momenta and energy are kept.
pub(super) fn watched_momenta(text: &str, free: usize) {
    struct Watched {
        momenta: Vec<[f64; 3]>,
        energy_j: Vec<f64>,
    }
    impl Observer for Watched {
        fn step(&mut self, step: &mut Step<'_, '_>) {
            let closed = step.is_in_contact(0);
            let dynamics = step.end();
            self.momenta.push(momenta(dynamics));
            self.energy_j.push(dynamics.energy(|_| closed).total_j());
        }
    }
    let built = build(text);
    assert_eq!(built.mechanism.real.beams.len(), 2);
    assert_eq!(built.mechanism.real.free, free);
    let window = Window { start_s: 0.0, end_s: 6e-3 };
    let settings = Settings { tolerance_m: 1e-11, ..Settings::for_simulation() };
    let mut watched = Watched { momenta: Vec::new(), energy_j: Vec::new() };
    let report = run(&built.mechanism, &built.sample(), &window, &settings, &mut watched)
        .unwrap_or_else(|failure| panic!("{failure}"));
    let account = report.energy.expect("it is integrated");
    assert!(account.relative_residual() < 1e-9, "{:e}", account.relative_residual());
    assert!(
        account.friction_loss_j > 1e-4 && account.contact_loss_j > 1e-4 && account.damping_loss_j > 1e-5,
        "{account:?}"
    );
    assert!(report.plays[0].contacts > 3, "{:?}", report.plays);
    let start = watched.momenta[0];
    for (index, found) in watched.momenta.iter().enumerate() {
        for k in 0..3 {
            assert!((found[k] - start[k]).abs() < 1e-9 * start[k].abs(), "step {index}: {found:?} and {start:?}");
        }
    }
    // What is lost is lost by all three.
    let lost_j = watched.energy_j[0] - watched.energy_j[watched.energy_j.len() - 1];
    assert!(lost_j > account.friction_loss_j && lost_j > account.contact_loss_j, "{lost_j} J");
}

/// The crank turns evenly about its centre of mass: the power of its drive is that of the force in the crank pin, which is what the
/// rod beyond it needs.
#[test]
fn identity_the_force_that_a_flexible_rod_needs_has_the_power_of_the_drive() {
    let built = build(&(case_text("flexible_slider_crank") + POWER_OUTPUTS));
    let record = simulate(&built.mechanism, &built.values, &Plan::of_model(&built.mechanism.model))
        .unwrap_or_else(|failure| panic!("{failure}"))
        .record;
    assert_power_of_the_drive(&record);
}

/// Beside the loss of its damping a rod keeps its account.
#[test]
fn identity_damping_of_a_flexible_rod_stands_in_the_energy_account() {
    let text =
        case_text("flexible_slider_crank").replace("lateral_shapes = 2", "lateral_shapes = 2\ndamping_ratio = 0.02");
    let built = build(&text);
    let record = simulate(&built.mechanism, &built.values, &Plan::of_model(&built.mechanism.model))
        .unwrap_or_else(|failure| panic!("{failure}"))
        .record;
    let energy = &record.energy;
    assert!(energy.relative_residual < 1e-9, "{:e}", energy.relative_residual);
    let lost_j = energy.damping_loss_j.last().expect("a loss");
    assert!(*lost_j > 1e-3, "{lost_j}");
    assert!(energy.damping_loss_j.windows(2).all(|pair| pair[0] <= pair[1] + 1e-12));
}

/// The friction path of a joint at the end of a flexible rod, by the integrator and by Gauss's rule on its dense output.
#[test]
fn identity_a_joint_of_a_flexible_rod_wears() {
    let text = case_text("flexible_slider_crank");
    let wearing = text.replace(
        "[joint.gudgeon]\n",
        "[joint.gudgeon]\nbearing_length = \"20 mm\"\nwear.bearing.coefficient = \"1e-15 m^2/N\"\n",
    );
    assert_ne!(wearing, text);
    let built = build(&wearing);
    let record = simulate(&built.mechanism, &built.values, &Plan::of_model(&built.mechanism.model))
        .unwrap_or_else(|failure| panic!("{failure}"))
        .record;
    let wear = &record.wear[0];
    assert!(wear.friction_path_j > 1.0, "{} J", wear.friction_path_j);
    let error = wear.checks.path_error.unwrap_or(f64::NAN);
    assert!(error.abs() < 1e-6, "{error}");
}

//! Energy and momentum of the equations of motion, exactly.

use super::{build_case, build_text, case_names, ideal_at, spread};
use crate::power_balance::{assert_powers_balance, with_rates};
use loosepin_math::{Dual, Vec2};
use loosepin_mechanics::dynamics::{Dynamics, PlayState};
use loosepin_mechanics::mechanism::{ContactPlace, Sample, acceleration_at};

/// Round-off relative to the largest power, force or moment at work.
const ROUND_OFF: f64 = 1e-10;

/// d(mechanical energy)/dt along the motion equals the power of the drives minus what contacts and friction turn into heat.
#[test]
fn identity_power_balance_of_all_cases() {
    let mut in_contact = 0;
    for case in case_names() {
        let built = build_case(&case);
        let mechanism = &built.mechanism;
        let sample = built.sample();
        let dual_sample = Sample::<Dual<f64>>::new(mechanism, &built.values).expect("the values fit");
        let turn_s = built.input().turn_s();
        for trial in 0..6 {
            let time_s = turn_s * (0.11 + 0.13 * f64::from(trial));
            let ideal = ideal_at(&built, &sample, time_s);
            let (mut q, mut rates) = mechanism.real_coordinates(ideal.kinematics(), &sample.real);
            let n = mechanism.real.free;
            if mechanism.real.constraint_rows() == 0 {
                // Away from the ideal motion, so that pins are pressed into their bearings. Loops of ideal joints would open.
                for k in 0..n {
                    q[k] += 0.013 * spread(k + trial as usize, 0.017);
                    rates[k] *= 1.0 + 0.31 * spread(k + trial as usize, 0.039);
                }
            }
            let mut plain = Dynamics::new(mechanism, &sample);
            plain.set_state(time_s, &q[..n], &rates[..n]);
            let is_touched =
                |at: &ContactPlace| plain.plays()[at.play].penetration_at_m(&sample.plays[at.play], at.place) > 0.0;
            let touches: Vec<bool> = sample.contacts.iter().map(is_touched).collect();
            in_contact += touches.iter().filter(|touch| **touch).count();
            let states: Vec<PlayState<f64>> = touches
                .iter()
                .map(|touch| PlayState {
                    contact: f64::from(*touch),
                    inverse_impact_speed_s_m: 2.3,
                    effective_mass_kg: 0.41,
                })
                .collect();
            plain.evaluate(time_s, &q[..n], &rates[..n], &states);
            let powers = plain.powers();

            let [moving, turning] = with_rates([&q[..n], &rates[..n], plain.accelerations()]);
            let mut dual = Dynamics::new(mechanism, &dual_sample);
            dual.set_state(Dual::variable(time_s), &moving, &turning);
            let energy = dual.energy(|contact| touches[contact]);
            assert_powers_balance(&energy, &powers, ROUND_OFF, &format!("{case}, trial {trial}"));
        }
    }
    assert!(in_contact > 30, "only {in_contact} contacts were looked at");
}

/// Two bodies that float between two driven cranks: only clearance joints hold them.
const FLOATING_PAIR: &str = r#"
name = "floating pair"
gravity = "0 m/s^2"
[body.ground]
points = { left = ["0 mm", "0 mm"], right = ["185 mm", "14 mm"] }
[body.left_crank]
mass = "0.25 kg"
inertia = "1.5e-4 kg m^2"
centre_of_mass = ["21 mm", "-3 mm"]
points = { main = ["0 mm", "0 mm"], pin = ["52 mm", "0 mm"] }
[body.left_link]
mass = "0.34 kg"
inertia = "9.6e-4 kg m^2"
centre_of_mass = ["78 mm", "6 mm"]
points = { low = ["0 mm", "0 mm"], high = ["176 mm", "0 mm"] }
[body.right_crank]
mass = "0.22 kg"
inertia = "1.2e-4 kg m^2"
centre_of_mass = ["16 mm", "4 mm"]
points = { main = ["0 mm", "0 mm"], pin = ["43 mm", "0 mm"] }
[body.right_link]
mass = "0.31 kg"
inertia = "8.3e-4 kg m^2"
centre_of_mass = ["72 mm", "-7 mm"]
points = { low = ["0 mm", "0 mm"], high = ["163 mm", "0 mm"] }
[contact.rough]
law = "lankarani-nikravesh"
restitution = 0.75
youngs_modulus = "207 GPa"
poisson_ratio = 0.3
friction = { law = "ambrosio", coefficient = 0.17, sliding_velocity = "READING" }
[joint.left_main]
kind = "revolute"
bearing = "ground.left"
journal = "left_crank.main"
[joint.right_main]
kind = "revolute"
bearing = "ground.right"
journal = "right_crank.main"
[joint.left_pin]
kind = "revolute"
bearing = "left_crank.pin"
journal = "left_link.low"
bearing_radius = "8 mm"
radial_clearance = "0.2 mm"
contact = "rough"
[joint.right_pin]
kind = "revolute"
bearing = "right_crank.pin"
journal = "right_link.low"
bearing_radius = "8 mm"
radial_clearance = "0.3 mm"
contact = "rough"
[joint.apex]
kind = "revolute"
bearing = "left_link.high"
journal = "right_link.high"
bearing_radius = "9 mm"
radial_clearance = "0.25 mm"
contact = "rough"
[drive.left]
joint = "left_main"
speed = "480 rpm"
start_angle = "75 deg"
[drive.right]
joint = "right_main"
speed = "-300 rpm"
start_angle = "110 deg"
[assembly]
guess = { left_link = "60 deg", right_link = "115 deg" }
[cycle]
drive = "left"
[output.apex]
path_of = "left_link.high"
"#;

#[test]
fn identity_a_floating_pair_in_contact_keeps_its_momenta() {
    for reading in ["material", "literal"] {
        let built = build_text(&FLOATING_PAIR.replace("READING", reading));
        let mechanism = &built.mechanism;
        let sample = built.sample();
        let model = &mechanism.model;
        let tree = &mechanism.real;
        let apex = mechanism.plays.iter().position(|&play| model.play_name(play) == "apex").expect("it has play");
        let floating: Vec<(usize, usize)> = tree
            .links
            .iter()
            .enumerate()
            .filter_map(|(index, link)| link.joint().is_none().then_some((index, link.coordinates.start)))
            .collect();
        assert_eq!((floating.len(), tree.free), (2, 6), "two bodies float");
        let ideal = ideal_at(&built, &sample, 0.0137);
        let (mut q, mut rates) = mechanism.real_coordinates(ideal.kinematics(), &sample.real);
        // One body is moved by more than the clearance of the apex, and both fly and spin.
        q[floating[0].1] += 2.3e-4;
        q[floating[0].1 + 1] -= 1.9e-4;
        for (k, rate) in rates[..6].iter_mut().enumerate() {
            *rate += 3.0 * spread(k, 0.023);
        }
        let states: Vec<PlayState<f64>> = (0..mechanism.plays.len())
            .map(|play| PlayState {
                contact: f64::from(play == apex),
                inverse_impact_speed_s_m: 0.7,
                effective_mass_kg: 0.41,
            })
            .collect();
        let mut dynamics = Dynamics::new(mechanism, &sample);
        dynamics.evaluate(0.0137, &q[..6], &rates[..6], &states);
        let (motion, force) = (&dynamics.plays()[apex], &dynamics.contacts()[apex]);
        assert!(motion.penetration_m(sample.plays[apex].clearance_m) > 1e-5, "the pin is pressed into its bearing");
        assert!(force.friction_loss_w != 0.0 && force.moment_on_journal_n_m != 0.0, "friction acts");

        let (mut linear_n, mut angular_n_m) = (Vec2::zero(), 0.0);
        let (mut force_scale_n, mut moment_scale_n_m) = (0.0_f64, 0.0_f64);
        for &(index, _) in &floating {
            let (slot, numbers) = (index + 1, &sample.real.links[index]);
            let pose = &dynamics.kinematics.poses[slot];
            let arm_m = pose.turn(numbers.centre_of_mass_m);
            let change = dynamics.acceleration(slot);
            let acceleration = acceleration_at(&change, &dynamics.kinematics.twists[slot], arm_m);
            let rate_n = acceleration * numbers.mass_kg;
            linear_n += rate_n;
            let (orbital, spin) = ((pose.position_m + arm_m).cross(rate_n), numbers.inertia_kg_m2 * change.angular);
            angular_n_m += orbital + spin;
            force_scale_n = force_scale_n.max(rate_n.length());
            moment_scale_n_m = moment_scale_n_m.max(orbital.abs()).max(spin.abs());
        }
        assert!(force_scale_n > 1.0);
        assert!(linear_n.length() < ROUND_OFF * force_scale_n, "{reading}: {linear_n:?} of {force_scale_n} N");
        assert!(angular_n_m.abs() < ROUND_OFF * moment_scale_n_m, "{reading}: {angular_n_m:e} of {moment_scale_n_m}");
    }
}

//! The quasi-static worst case: first order, exact, and as the check of a run.

use super::motion::{motion_of, output};
use super::{Built, build_case, build_case_with, ideal_at};
use loosepin_math::Vec2;
use loosepin_simulate::accuracy::{
    DisplacedLoops, PlayReach, first_order_si, play_gradients, position_outputs, starts_on_borders, worst_case_extremes,
};

/// The gudgeon of the case `slider_crank_5000`.
const GUDGEON: PlayReach = PlayReach::Disc { radius_m: 5e-4 };

/// Round-off of positions of order 0.1 m, m.
const ROUND_OFF_M: f64 = 1e-15;

/// Slider of r = 50 mm, l = 120 mm with the eccentricity c at ψ in the gudgeon, in closed form, m.
fn slider_m(angle: f64, c: f64, psi: f64) -> f64 {
    let (r, l): (f64, f64) = (0.05, 0.12);
    let height = r * angle.sin() + c * psi.sin();
    r * angle.cos() + (l * l - height * height).sqrt() + c * psi.cos()
}

/// Largest of `f` over a turn, to round-off: a fine grid, then ternary search around its best point.
fn largest(f: impl Fn(f64) -> f64) -> f64 {
    let step = std::f64::consts::TAU / 3600.0;
    let best = (0..3600).map(|k| step * f64::from(k)).max_by(|a, b| f(*a).total_cmp(&f(*b))).unwrap_or(0.0);
    let (mut low, mut high) = (best - step, best + step);
    for _ in 0..200 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if f(a) < f(b) { low = a } else { high = b }
    }
    f(0.5 * (low + high))
}

#[test]
fn analytic_first_order_answer_of_the_slider_crank() {
    let record = motion_of(&build_case("slider_crank_5000"), 72);
    let answer = &output(&record, "slider").clearance;
    assert_eq!(answer.contributors.len(), 1);
    assert_eq!((answer.contributors[0].joint.as_str(), answer.contributors[0].radial_clearance_m), ("gudgeon", 5e-4));
    for (k, angle) in record.drive_angle_rad.iter().enumerate() {
        // g = (1, tan φ) with l sin φ = -r sin θ, so that |g| = 1/cos φ.
        let cosine = (1.0 - (0.05 * angle.sin() / 0.12).powi(2)).sqrt();
        assert!((answer.first_order_si[k] - 5e-4 / cosine).abs() < ROUND_OFF_M);
        assert!((answer.disc_standard_deviation_si[k] - 5e-4 / cosine / 2.0).abs() < ROUND_OFF_M);
        assert!((answer.rim_standard_deviation_si[k] - 5e-4 / cosine / 2f64.sqrt()).abs() < ROUND_OFF_M);
        assert_eq!(answer.contributors[0].first_order_si[k], answer.first_order_si[k]);
    }
}

#[test]
fn identity_variances_are_those_of_sampled_journals() {
    // Midpoint sums over disc and rim for one joint: exact up to the square of the cell.
    let gradient = Vec2::new(0.83, -1.27);
    let clearance_m = 3e-4;
    let (mut disc, mut rim, mut weight) = (0.0, 0.0, 0.0);
    let (rings, spokes) = (400, 360);
    for spoke in 0..spokes {
        let angle = std::f64::consts::TAU * (f64::from(spoke) + 0.5) / f64::from(spokes);
        let direction = Vec2::new(angle.cos(), angle.sin()) * clearance_m;
        rim += gradient.dot(direction).powi(2) / f64::from(spokes);
        for ring in 0..rings {
            let share = (f64::from(ring) + 0.5) / f64::from(rings);
            disc += gradient.dot(direction * share).powi(2) * share;
            weight += share;
        }
    }
    let joints = [(PlayReach::Disc { radius_m: clearance_m }, gradient)];
    let exact = loosepin_simulate::accuracy::disc_standard_deviation_si(&joints).powi(2);
    assert!((disc / weight / exact - 1.0).abs() < 1e-5);
    let exact = loosepin_simulate::accuracy::rim_standard_deviation_si(&joints).powi(2);
    assert!((rim / exact - 1.0).abs() < 1e-12);
}

#[test]
fn analytic_exact_worst_case_of_the_slider_crank() {
    let built = build_case("slider_crank_5000");
    let sample = built.sample();
    let reading = position_outputs(&built.mechanism)[0].reading;
    let mut loops = DisplacedLoops::new(&built.mechanism, &built.values);
    for step in 0..24 {
        let angle = 0.05 + 0.26 * f64::from(step);
        let state = ideal_at(&built, &sample, angle / built.input().speed_rad_s);
        loops.set_position(state.coordinates());
        let exact = worst_case_extremes(&mut loops, reading, &[GUDGEON], &starts_on_borders(&[GUDGEON]));
        let centred = slider_m(angle, 0.0, 0.0);
        let highest = largest(|psi| slider_m(angle, 5e-4, psi)) - centred;
        let lowest = -largest(|psi| -slider_m(angle, 5e-4, psi)) - centred;
        assert!((exact.highest.deviation_si - highest).abs() < ROUND_OFF_M, "{angle}");
        assert!((exact.lowest.deviation_si - lowest).abs() < ROUND_OFF_M, "{angle}");
        for worst in [&exact.lowest, &exact.highest] {
            assert!((worst.displacements[0].length() - 5e-4).abs() < 1e-16, "the extremes lie on the rim");
        }
    }
}

#[test]
fn published_first_order_is_exceeded_by_0_17_micrometres_at_60_degrees() {
    let built = build_case("slider_crank_5000");
    let sample = built.sample();
    let reading = position_outputs(&built.mechanism)[0].reading;
    let state = ideal_at(&built, &sample, 60f64.to_radians() / built.input().speed_rad_s);
    let mut loops = DisplacedLoops::new(&built.mechanism, &built.values);
    loops.set_position(state.coordinates());
    let gradient = play_gradients(&mut loops, &[reading]).expect("it is regular")[0][0];
    let first_order = first_order_si(&[(GUDGEON, gradient)]);
    let exact = worst_case_extremes(&mut loops, reading, &[GUDGEON], &[]);
    let excess_m = -exact.lowest.deviation_si - first_order;
    // 0.17 µm, to its two digits: what the first-order worst case lacks.
    assert!((excess_m - 0.17e-6).abs() < 0.005e-6, "{excess_m:e}");
}

/// The largest output over a grid of directions of all journals on their rims.
fn brute_force(
    built: &Built,
    loops: &mut DisplacedLoops<'_>,
    output: usize,
    radii_m: &[f64],
    per_joint: usize,
) -> [f64; 2] {
    let reading = position_outputs(&built.mechanism)[output].reading;
    let (mut lowest, mut highest) = (f64::INFINITY, f64::NEG_INFINITY);
    for mut index in 0..per_joint.pow(radii_m.len() as u32) {
        let eccentricities_m: Vec<Vec2<f64>> = radii_m
            .iter()
            .map(|radius_m| {
                let angle = std::f64::consts::TAU * (index % per_joint) as f64 / per_joint as f64;
                index /= per_joint;
                Vec2::new(angle.cos(), angle.sin()) * *radius_m
            })
            .collect();
        loops.displace(&eccentricities_m).expect("the clearances are harmless");
        lowest = f64::min(lowest, loops.value(reading));
        highest = f64::max(highest, loops.value(reading));
    }
    loops.centre();
    [lowest, highest].map(|value| value - loops.value(reading))
}

#[test]
fn identity_exact_worst_case_holds_against_a_grid_of_directions() {
    for (case, per_joint) in [("slider_crank_two_clearances", 48), ("four_bar_three_clearances", 18)] {
        let built = build_case(case);
        let sample = built.sample();
        let radii_m: Vec<f64> = sample.plays.iter().map(|play| play.clearance_m).collect();
        let reaches: Vec<PlayReach> = radii_m.iter().map(|&radius_m| PlayReach::Disc { radius_m }).collect();
        let turn_s = built.input().turn_s();
        for share in [0.07, 0.41, 0.83] {
            let state = ideal_at(&built, &sample, share * turn_s);
            let mut loops = DisplacedLoops::new(&built.mechanism, &built.values);
            loops.set_position(state.coordinates());
            let reading = position_outputs(&built.mechanism)[0].reading;
            let exact = worst_case_extremes(&mut loops, reading, &reaches, &starts_on_borders(&reaches));
            let [lowest, highest] = brute_force(&built, &mut loops, 0, &radii_m, per_joint);
            // A grid of directions falls short by the square of half its step, 1.5 % for 18 directions.
            let short = 1.6 * (std::f64::consts::PI / per_joint as f64).powi(2);
            assert!(
                highest <= exact.highest.deviation_si * (1.0 + 1e-12)
                    && lowest >= exact.lowest.deviation_si * (1.0 + 1e-12)
            );
            assert!(highest >= exact.highest.deviation_si * (1.0 - short), "{case} {share}");
            assert!(lowest <= exact.lowest.deviation_si * (1.0 - short), "{case} {share}");
        }
    }
}

#[test]
fn analytic_a_dead_point_within_the_clearances_is_in_the_way() {
    // At 89.9° the rod, 0.1 mm longer than the crank, stands almost across the guide: 0.5 mm of play lets it pass.
    let built = build_case_with("slider_crank_5000", &[("parameter.rod_length", 0.0501)]);
    let sample = built.sample();
    let state = ideal_at(&built, &sample, 89.9_f64.to_radians() / built.input().speed_rad_s);
    let mut loops = DisplacedLoops::new(&built.mechanism, &built.values);
    loops.set_position(state.coordinates());
    let before = loops.coordinates().to_vec();
    let reading = position_outputs(&built.mechanism)[0].reading;
    let found = worst_case_extremes(&mut loops, reading, &[GUDGEON], &starts_on_borders(&[GUDGEON]));
    assert!(found.is_blocked && found.lowest.deviation_si < 0.0, "{found:?}");
    loops.centre();
    assert_eq!(loops.coordinates(), before);
}

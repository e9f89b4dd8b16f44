//! The quasi-static answer of a slider with play in its guide.

use super::{Built, build_text, ideal_at};
use crate::elements::file;
use loosepin_math::Vec2;
use loosepin_mechanics::model::Cycle;
use loosepin_simulate::accuracy::{
    DisplacedLoops, PlayReach, first_order_si, play_gradients, position_outputs, quasi_static_check, starts_on_borders,
    worst_case_extremes,
};
use loosepin_simulate::record::SimulationRecord;
use loosepin_simulate::{Plan, Settings, simulate};

const CLEARANCE_M: f64 = 2e-4;

fn text() -> String {
    file("slider_with_play_in_its_guide.toml")
}

/// The model with its guide as a cut of the tree, as a link of it, and as a link whose guide hangs on the slider.
fn variants() -> [String; 3] {
    let cut = text();
    let (before, rest) = cut.split_at(cut.find("[joint.crank_pin]").expect("there is one"));
    let (pins, guide) = rest.split_at(rest.find("[joint.guide]").expect("there is one"));
    let (guide, after) = guide.split_at(guide.find("[drive.crank]").expect("there is one"));
    let link = format!("{before}{guide}{pins}{after}");
    let turned = link
        .replace("point = \"ground.rail\", angle = \"12 deg\"", "point = \"slider.middle\", angle = \"5 deg\"")
        .replace(
            "point = \"slider.middle\", angle = \"5 deg\" }\nhalf",
            "point = \"ground.rail\", angle = \"12 deg\" }\nhalf",
        );
    [cut, link, turned]
}

fn reaches(built: &Built) -> Vec<PlayReach> {
    let sample = built.sample();
    PlayReach::of_sample(&built.mechanism, &sample, [0.0]).expect("it cannot turn over")
}

#[test]
fn identity_gradients_of_ordinate_and_angle_are_differences_of_the_closed_loops() {
    /// Steps, m and rad; the differences err by their squares times third derivatives, and by round-off over them.
    const STEP: f64 = 1e-6;
    for (variant, text) in variants().into_iter().enumerate() {
        let built = build_text(&text);
        let sample = built.sample();
        let readings: Vec<_> = position_outputs(&built.mechanism).iter().map(|output| output.reading).collect();
        let mut loops = DisplacedLoops::new(&built.mechanism, &built.values);
        loops.set_position(ideal_at(&built, &sample, 0.0123).coordinates());
        let at = Vec2::new(7e-5, -0.0031);
        loops.displace(&[at]).expect("it is harmless");
        let gradients = play_gradients(&mut loops, &readings).expect("the position is regular");
        let mut sum = 0.0;
        for direction in [Vec2::new(1.0, 0.0), Vec2::new(0.0, 1.0)] {
            let [below, above] = [-STEP, STEP].map(|step| {
                loops.displace(&[at + direction * step]).expect("a small step is harmless");
                readings.iter().map(|reading| loops.value(*reading)).collect::<Vec<f64>>()
            });
            for (k, gradient) in gradients.iter().enumerate() {
                let difference = (above[k] - below[k]) / (2.0 * STEP);
                let exact = gradient[0].dot(direction);
                assert!((exact - difference).abs() < 1e-8, "variant {variant} output {k}: {exact} {difference}");
                sum += exact.abs();
            }
        }
        assert!(sum > 1.0, "the outputs move");
    }
}

#[test]
fn identity_cut_and_link_give_the_same_answer() {
    /// Round-off of positions, m or rad.
    const ROUND_OFF: f64 = 1e-14;
    let [cut, link, _] = variants().map(|text| build_text(&text));
    let answers = [&cut, &link].map(|built| {
        let sample = built.sample();
        let mut loops = DisplacedLoops::new(&built.mechanism, &built.values);
        loops.set_position(ideal_at(built, &sample, 0.0123).coordinates());
        loops.displace(&[Vec2::new(-1.1e-4, 0.0017)]).expect("it is harmless");
        position_outputs(&built.mechanism).iter().map(|output| loops.value(output.reading)).collect::<Vec<f64>>()
    });
    for (a, b) in answers[0].iter().zip(&answers[1]) {
        assert!((a - b).abs() < ROUND_OFF, "{a} {b}");
    }
}

#[test]
fn analytic_worst_case_across_the_guide_and_by_its_tilt() {
    /// Round-off of positions of order 0.1 m, m.
    const ROUND_OFF_M: f64 = 1e-15;
    // The pin in the middle of the slider, the guide along x through the crank's shaft.
    let text = text()
        .replace("pin = [\"-7 mm\", \"3 mm\"]", "pin = [\"2 mm\", \"6 mm\"]")
        .replace("rail = [\"70 mm\", \"15 mm\"]", "rail = [\"0 mm\", \"0 mm\"]")
        .replace("angle = \"12 deg\"", "angle = \"0 deg\"")
        .replace("angle = \"5 deg\"", "angle = \"0 deg\"");
    let built = build_text(&text);
    let reaches = reaches(&built);
    let PlayReach::Guide { largest_tilt_rad, .. } = reaches[0] else { panic!("a guide") };
    let sample = built.sample();
    let mut loops = DisplacedLoops::new(&built.mechanism, &built.values);
    let (r, l, speed_rad_s) = (0.033_f64, 0.105_f64, built.input().speed_rad_s);
    let (dx, dy) = (0.029, -0.018);
    for time_s in [0.003, 0.019, 0.041, 0.058] {
        let crank_rad = 20f64.to_radians() + speed_rad_s * time_s;
        let tool_m = |y: f64, tilt: f64| {
            let across = r * crank_rad.sin() - y;
            r * crank_rad.cos() + (l * l - across * across).sqrt() + dx * tilt.cos() - dy * tilt.sin()
        };
        loops.set_position(ideal_at(&built, &sample, time_s).coordinates());
        let reading = position_outputs(&built.mechanism)[0].reading;
        let exact = worst_case_extremes(&mut loops, reading, &reaches, &starts_on_borders(&reaches));
        let ends = [
            tool_m(CLEARANCE_M, 0.0),
            tool_m(-CLEARANCE_M, 0.0),
            tool_m(0.0, largest_tilt_rad),
            tool_m(0.0, -largest_tilt_rad),
        ]
        .map(|value| value - tool_m(0.0, 0.0));
        let highest = ends.into_iter().fold(0.0, f64::max);
        let lowest = ends.into_iter().fold(0.0, f64::min);
        assert!((exact.highest.deviation_si - highest).abs() < ROUND_OFF_M, "{:?} {highest}", exact.highest);
        assert!((exact.lowest.deviation_si - lowest).abs() < ROUND_OFF_M, "{:?} {lowest}", exact.lowest);
        let gradient = play_gradients(&mut loops, &[reading]).expect("it is regular")[0][0];
        let first_order = f64::max(CLEARANCE_M * gradient.x.abs(), largest_tilt_rad * 0.018);
        assert!((first_order_si(&[(reaches[0], gradient)]) - first_order).abs() < ROUND_OFF_M);
    }
}

#[test]
fn identity_exact_worst_case_holds_against_a_grid_of_all_places() {
    const STEPS: i32 = 40;
    for text in variants() {
        let built = build_text(&text);
        let (sample, reaches) = (built.sample(), reaches(&built));
        let PlayReach::Guide { half_length_m: a, half_height_m: b, largest_tilt_rad, .. } = reaches[0] else {
            panic!("a guide")
        };
        let mut loops = DisplacedLoops::new(&built.mechanism, &built.values);
        for time_s in [0.004, 0.027, 0.049] {
            loops.set_position(ideal_at(&built, &sample, time_s).coordinates());
            for output in position_outputs(&built.mechanism) {
                let starts = starts_on_borders(&reaches);
                let exact = worst_case_extremes(&mut loops, output.reading, &reaches, &starts);
                loops.centre();
                let centred = loops.value(output.reading);
                let mut largest = [0.0_f64; 2];
                for k in -STEPS..=STEPS {
                    let tilt = largest_tilt_rad * f64::from(k) / f64::from(STEPS);
                    let across_m = CLEARANCE_M + b * (1.0 - tilt.cos()) - a * tilt.abs().sin();
                    for share in [-1.0, -0.5, 0.0, 0.5, 1.0] {
                        loops.displace(&[Vec2::new(share * across_m, tilt)]).expect("it is harmless");
                        let deviation = loops.value(output.reading) - centred;
                        largest = [f64::max(largest[0], -deviation), f64::max(largest[1], deviation)];
                    }
                }
                for (found, worst) in largest.into_iter().zip([&exact.lowest, &exact.highest]) {
                    // The grid holds the ends, at which the worst case is.
                    let share = found / worst.deviation_si.abs();
                    assert!((share - 1.0).abs() < 1e-9, "{} at {time_s}: {share}", output.name);
                }
            }
        }
    }
}

/// A part of a turn in time.
fn simulated(built: &Built) -> SimulationRecord {
    let model = &built.mechanism.model;
    let cycle = Cycle { recorded_turns: 0.7, samples_per_turn: 150, ..model.cycle.clone() };
    let plan = Plan {
        cycle,
        settings: Settings::for_study(),
        with_states: false,
        lyapunov_turns: None,
        second_run: false,
        overrides: Vec::new(),
    };
    simulate(&built.mechanism, &built.values, &plan).expect("the run is sound").record
}

#[test]
fn identity_a_run_stays_within_the_quasi_static_worst_case_of_the_guide() {
    let built = build_text(&text());
    let record = simulated(&built);
    assert!(record.orbits.is_empty(), "a slider has no orbit");
    assert_eq!(record.contact_forces.len(), 4);
    let shares = quasi_static_check(&built.mechanism, &built.values, &record).expect("it is ideal");
    assert_eq!(shares.len(), 3, "two coordinates and an angle");
    for share in shares {
        assert!(!share.is_exceeded && share.samples_without_worst_case == 0, "{share:?}");
        assert!(share.largest_share > 0.6, "the faces are reached: {share:?}");
    }
}

/// Half-length and half-height of the block, m.
const BLOCK_M: [f64; 2] = [0.028, 0.013];

/// How far the block's corners reach along the guide from its ideal centre at any tilt, the centre being off by the play, m.
fn reach_m(play_m: f64) -> f64 {
    let [a, b] = BLOCK_M;
    // a sin θ + b cos θ = √(a² + b²) cos(θ - atan(a/b)) = b + c at the largest tilt.
    let tilt_rad = f64::atan2(a, b) - f64::acos((b + play_m) / f64::hypot(a, b));
    a + b * tilt_rad.sin() + play_m
}

/// The model whose guide ends there.
fn with_end(end_m: f64) -> Built {
    let ends = format!("angle = \"12 deg\", start = \"-90 mm\", end = \"{} mm\" }}", 1e3 * end_m);
    build_text(&text().replace("angle = \"12 deg\" }", &ends))
}

/// Where the slider is along its guide in the ideal motion, m.
fn along_m(built: &Built, time_s: f64) -> f64 {
    let (model, sample) = (&built.mechanism.model, built.sample());
    let guide = model.joints.iter().find(|joint| joint.name == "guide").expect("there is one");
    let [rail, middle] = guide.kind.points();
    let line = Vec2::new(12f64.to_radians().cos(), 12f64.to_radians().sin());
    let state = ideal_at(built, &sample, time_s);
    let at = |point: loosepin_mechanics::model::PointId| {
        let slot = built.mechanism.ideal.slot_of_body[point.body.0];
        let arm = loosepin_mechanics::mechanism::point_m(model, &built.values, point);
        state.kinematics().poses[slot].point_m(arm)
    };
    line.dot(at(middle) - at(rail))
}

/// Samples of a run that have no worst case, by the check; the run stays within it in the others.
fn without_worst_case(built: &Built, record: &SimulationRecord) -> usize {
    let shares = quasi_static_check(&built.mechanism, &built.values, record).expect("it is ideal");
    let without = shares[0].samples_without_worst_case;
    for share in shares {
        assert!(!share.is_exceeded && share.samples_without_worst_case == without, "{share:?}");
    }
    without
}

#[test]
fn identity_samples_in_which_the_slider_overhangs_have_no_worst_case() {
    const END_M: f64 = 0.09;
    let built = with_end(END_M);
    let record = simulated(&built);
    let reach_m = reach_m(CLEARANCE_M + record.joints[0].largest_penetration_m);
    let over = record.time_s.iter().filter(|&&time_s| along_m(&built, time_s) > END_M - reach_m).count();
    let all = record.time_s.len();
    assert!(over > 5 && over < all - 5, "{over} of {all} overhang");
    assert_eq!(without_worst_case(&built, &record), over);
}

#[test]
fn identity_a_slider_that_overhangs_by_its_tilt_alone_has_no_worst_case() {
    let free = build_text(&text());
    let record = simulated(&free);
    let furthest_m = record.time_s.iter().map(|time_s| along_m(&free, *time_s)).fold(f64::NEG_INFINITY, f64::max);
    let play_m = CLEARANCE_M + record.joints[0].largest_penetration_m;
    // Untilted, the block stays within the end even with its play; its corners pass the end as it tilts.
    let by_tilt_m = reach_m(play_m) - BLOCK_M[0] - play_m;
    assert!(by_tilt_m > 9e-5, "{by_tilt_m}");
    let built = with_end(furthest_m + BLOCK_M[0] + play_m + 0.5 * by_tilt_m);
    assert!(without_worst_case(&built, &simulated(&built)) > 0);
    let beyond = with_end(furthest_m + reach_m(play_m) + 1e-6);
    assert_eq!(without_worst_case(&beyond, &simulated(&beyond)), 0);
}

#[test]
fn identity_the_angles_at_which_a_block_overhangs_are_named() {
    const END_M: f64 = 0.09;
    let built = with_end(END_M);
    let record = super::motion::motion_of(&built, 72);
    let [overhang] = &record.guide_overhangs[..] else { panic!("{:?}", record.guide_overhangs) };
    assert_eq!(overhang.joint, "guide");
    let start_rad = record.drive_angle_rad[0];
    let mut over = 0;
    for angle_rad in &record.drive_angle_rad {
        let is_over =
            along_m(&built, (angle_rad - start_rad) / built.input().speed_rad_s) > END_M - reach_m(CLEARANCE_M);
        let is_named = overhang.spans_rad.iter().any(|span_rad| (span_rad[0]..=span_rad[1]).contains(angle_rad));
        assert_eq!(is_named, is_over, "{angle_rad}");
        over += usize::from(is_over);
    }
    assert!(over > 5 && over < 60, "{over}");
    assert!(super::motion::motion_of(&build_text(&text()), 72).guide_overhangs.is_empty(), "no ends");
}

#[test]
fn text_of_a_slider_that_can_turn_over() {
    let built = build_text(&text().replace("clearance = \"0.2 mm\"", "clearance = \"18 mm\""));
    let error = super::motion::try_motion_of(&built, 36).expect_err("it can turn over");
    let text = "joint 'guide': the slider can turn over in its guide, so there is no quasi-static result";
    assert_eq!(error.to_string(), text);
}

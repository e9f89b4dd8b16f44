//! Worst cases over a cycle: found, and proven.

use super::motion::{motion_of, plan};
use super::{Built, build_case, build_case_with, build_text, ideal_at, spread};
use crate::elements::file;
use loosepin_math::Vec2;
use loosepin_result::study::Deviation;
use loosepin_simulate::accuracy::record::MotionRecord;
use loosepin_simulate::accuracy::{
    DeviationQuestion, DimensionLimit, DisplacedLoops, deviation_ends, motion_with_worst_cases, position_outputs,
};
use loosepin_simulate::{Plan, simulate};

pub(super) fn worst_of(built: &Built, positions: usize) -> MotionRecord {
    motion_with_worst_cases(&built.mechanism, &built.values, &plan(built, positions)).expect("it moves")
}

fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}

/// The slider-crank with r = 50 mm, a rod of l = 50.5 mm and one loose pin.
fn near_its_change_point(clearance_m: f64) -> Built {
    let set = [("parameter.rod_length", 0.0505), ("joint.gudgeon.radial_clearance", clearance_m)];
    build_case_with("slider_crank_5000", &set)
}

#[test]
fn analytic_worst_case_near_a_change_point_and_its_proven_end() {
    /// Round-off of a place of 0.1 m that is magnified sevenfold, m.
    const ROUND_OFF_M: f64 = 1e-14;
    let (r, l): (f64, f64) = (0.05, 0.0505);
    // The excess of the proven end over the true one, which is between angles too, grows as the change point comes near.
    for (c, most) in [(1e-4, 0.03), (2e-4, 0.2)] {
        let record = worst_of(&near_its_change_point(c), 360);
        let answer = &record.outputs[0].clearance;
        // At 90° the pin is drawn along the rod: what is left is √((l - c)² - r²).
        let due = (l * l - r * r).sqrt() - ((l - c) * (l - c) - r * r).sqrt();
        assert!((answer.worst_case_si[90] - due).abs() < ROUND_OFF_M, "{} {due}", answer.worst_case_si[90]);
        assert!((largest(&answer.worst_case_si) - due).abs() < ROUND_OFF_M, "the largest of the cycle");
        let first_order = c / (1.0 - (r / l).powi(2)).sqrt();
        assert!((largest(&answer.first_order_si) - first_order).abs() < ROUND_OFF_M && due > 1.05 * first_order);
        let proven = -answer.proven_lowest_si.iter().copied().fold(0.0, f64::min);
        assert!((1.0..1.0 + most).contains(&(proven / due)), "{c}: {proven} {due}");
        assert!(record.unproven_spans.is_empty() && record.is_proven_between_angles);
        let witness = answer.witness.as_ref().expect("play moves it");
        let [x, y] = witness.joints[0].displacement_si;
        assert!((x.hypot(y) - c).abs() < 1e-16 && (witness.deviation_si + due).abs() < ROUND_OFF_M, "{witness:?}");
    }
}

#[test]
fn analytic_ends_are_proven_up_to_close_before_a_change_point() {
    // 0.4 and 0.49 mm of play of the 0.5 mm to the change point, which half a step of the drive does not bring nearer.
    for (c, most) in [(4e-4, 0.1), (4.9e-4, 0.3)] {
        let record = worst_of(&near_its_change_point(c), 360);
        let answer = &record.outputs[0].clearance;
        let due = (0.0505_f64.powi(2) - 0.05_f64.powi(2)).sqrt() - ((0.0505 - c).powi(2) - 0.05_f64.powi(2)).sqrt();
        assert!((largest(&answer.worst_case_si) / due - 1.0).abs() < 1e-9);
        assert!(largest(&answer.first_order_si) < 0.73 * due);
        assert!(record.unproven_spans.is_empty() && record.is_proven_between_angles, "{:?}", record.unproven_spans);
        let proven = -answer.proven_lowest_si.iter().copied().fold(0.0, f64::min);
        assert!((1.0..1.0 + most).contains(&(proven / due)), "{c}: {proven} {due}");
    }
}

#[test]
fn identity_a_preview_holds_the_first_order_and_no_worst_case() {
    let built = build_case("slider_crank_two_clearances");
    let answer = &motion_of(&built, 36).outputs[0].clearance;
    assert!(answer.worst_case_si.is_empty() && answer.proven_highest_si.is_empty() && answer.witness.is_none());
    let full = &worst_of(&built, 36).outputs[0].clearance;
    assert_eq!(answer.first_order_si, full.first_order_si);
    for k in 0..=36 {
        assert!(full.proven_lowest_si[k] <= full.lowest_si[k] && full.highest_si[k] <= full.proven_highest_si[k]);
        assert_eq!(full.worst_case_si[k], f64::max(-full.lowest_si[k], full.highest_si[k]));
    }
}

/// The pose of the cycle that a time belongs to: its nearest angle.
fn row_of(record: &MotionRecord, angle_rad: f64) -> usize {
    let apart = |known: f64| {
        let apart = (known - angle_rad).rem_euclid(std::f64::consts::TAU);
        apart.min(std::f64::consts::TAU - apart)
    };
    let rows = 0..record.drive_angle_rad.len();
    rows.min_by(|a, b| apart(record.drive_angle_rad[*a]).total_cmp(&apart(record.drive_angle_rad[*b]))).expect("rows")
}

#[test]
fn identity_no_run_passes_the_proven_ends() {
    let guide = file("slider_with_play_in_its_guide.toml");
    let mut widest = 0.0_f64;
    let built =
        [build_case("slider_crank_two_clearances"), build_case("four_bar_three_clearances"), build_text(&guide)];
    for built in built {
        let run =
            simulate(&built.mechanism, &built.values, &Plan::of_model(&built.mechanism.model)).expect("it runs").record;
        // Contacts give way: as much play more.
        let set: Vec<(String, f64)> = run
            .joints
            .iter()
            .map(|joint| {
                let key = if built.mechanism.model.quantities.id(&format!("joint.{}.clearance", joint.joint)).is_some()
                {
                    "clearance"
                } else {
                    "radial_clearance"
                };
                let more = joint.radial_clearance_m + joint.largest_penetration_m;
                (format!("joint.{}.{key}", joint.joint), more)
            })
            .collect();
        let set: Vec<(&str, f64)> = set.iter().map(|(path, value)| (path.as_str(), *value)).collect();
        let wider = super::build_model(&built.mechanism.model, &set);
        let record = worst_of(&wider, 120);
        for output in &record.outputs {
            let Some(history) = run.outputs.iter().find(|history| history.name == output.name) else { continue };
            for (k, deviation_si) in history.deviation_si.iter().enumerate() {
                let row = row_of(&record, run.drive_angle_rad[k]);
                let [low, high] = [output.clearance.proven_lowest_si[row], output.clearance.proven_highest_si[row]];
                assert!(low <= deviation_si + 1e-8 && deviation_si - 1e-8 <= high, "{} {row}", output.name);
                widest = widest.max(deviation_si / if *deviation_si < 0.0 { low } else { high });
            }
        }
    }
    assert!(widest > 0.8, "runs come near the ends: {widest}");
}

#[test]
fn identity_ends_of_every_deviation_hold_all_samples_of_parts_and_play() {
    let built = build_case("slider_crank_5000");
    let sample = built.sample();
    let reading = position_outputs(&built.mechanism)[0].reading;
    let paths = ["parameter.crank_length", "parameter.rod_length"];
    let limits: Vec<DimensionLimit> =
        paths.iter().map(|path| DimensionLimit { quantity: built.quantity(path), most_si: 1.5e-4 }).collect();
    let kinds = [Deviation::Value, Deviation::Total, Deviation::Dimensional, Deviation::Clearance];
    let questions: Vec<DeviationQuestion> = kinds.iter().map(|of| DeviationQuestion { reading, of: *of }).collect();
    let span = built.mechanism.model.cycle.span;
    let ends = deviation_ends(&built.mechanism, &built.values, (span, 120), &limits, &questions).expect("it moves");
    assert!(ends.unproven.is_none() && ends.is_whole_turn);
    let radii_m: Vec<f64> = sample.plays.iter().map(|play| play.clearance_m).collect();
    let mut widest = [0.0_f64; 4];
    for index in 0..500 {
        // Corners of the box of the dimensions, rims of the play, any angle within half a step of a recorded one.
        let at = |salt: f64| spread(index, salt);
        let row = ((at(0.011) + 1.0) * 60.0) as usize % 120;
        let angle = ends.of_questions[0].drive_angle_rad[row] + 0.5 * at(0.023) * std::f64::consts::TAU / 120.0;
        let time_s = (angle - built.input().start_rad) / built.input().speed_rad_s;
        let signs = [at(0.037).signum(), at(0.051).signum()];
        let set: Vec<(&str, f64)> =
            (0..2).map(|k| (paths[k], built.values[limits[k].quantity] + signs[k] * limits[k].most_si)).collect();
        let moved = super::build_model(&built.mechanism.model, &set);
        let play: Vec<Vec2<f64>> = radii_m
            .iter()
            .enumerate()
            .map(|(k, radius_m)| {
                let turn = std::f64::consts::PI * at(0.071 + 0.013 * k as f64);
                Vec2::new(turn.cos(), turn.sin()) * *radius_m
            })
            .collect();
        let value = |built: &Built, play: Option<&[Vec2<f64>]>| {
            let sample = built.sample();
            let mut loops = DisplacedLoops::new(&built.mechanism, &built.values);
            loops.set_position(ideal_at(built, &sample, time_s).coordinates());
            if let Some(play) = play {
                loops.displace(play).expect("harmless");
            }
            loops.value(reading)
        };
        let (all, parts, ideal) = (value(&moved, Some(&play)), value(&moved, None), value(&built, None));
        for (kind, deviation) in [all, all - ideal, parts - ideal, all - parts].into_iter().enumerate() {
            let [low, high] = ends.of_questions[kind].proven_si[row];
            assert!(low <= deviation && deviation <= high, "{:?} {row}: {low} {deviation} {high}", kinds[kind]);
            widest[kind] = widest[kind].max(if deviation < 0.0 { deviation / low } else { deviation / high });
        }
    }
    // Samples come near the ends of deviations.
    assert!(widest[1..].iter().all(|share| *share > 0.8), "{widest:?}");
    for (kind, question) in ends.of_questions.iter().enumerate() {
        let [low, high] = [0, 1].map(|side| question.found[side].deviation_si);
        let proven = question
            .proven_si
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |all, [low, high]| [all[0].min(*low), all[1].max(*high)]);
        assert!(proven[0] <= low && high <= proven[1], "{:?}", kinds[kind]);
        let [slack, size] = [f64::max(low - proven[0], proven[1] - high), proven[1] - proven[0]];
        assert!(slack < 0.01 * size, "{:?}: found {low} to {high}, proven {proven:?}", kinds[kind]);
    }
}

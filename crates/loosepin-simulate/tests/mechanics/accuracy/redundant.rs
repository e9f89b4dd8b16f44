//! Play where constraints of joints repeat each other: a coupler on three parallel cranks, of which two are enough.

use super::motion::plan;
use super::{Built, build_text};
use loosepin_result::motion::MotionRecord;
use loosepin_result::point_path::REACH_DIRECTIONS;
use loosepin_result::study::Deviation;
use loosepin_simulate::accuracy::{
    AskedPose, DeviationQuestion, MotionPlan, Scatter, deviation_ends, motion, motion_with_worst_cases,
    position_outputs,
};
use std::f64::consts::TAU;

/// Length of all cranks, m.
const CRANK_M: f64 = 0.08;

/// The coupler lies 200 mm long on the driven crank and a rocker with play at its pivot, and half way on a crank in the middle with play there too.
fn three_cranks(rocker_clearance: &str, middle: &str) -> Built {
    build_text(&three_cranks_text(rocker_clearance, middle))
}

fn three_cranks_text(rocker_clearance: &str, middle: &str) -> String {
    format!(
        r#"
name = "three cranks"

[body.ground]
points = {{ a = ["0 mm", "0 mm"], b = ["200 mm", "0 mm"], c = ["100 mm", "0 mm"] }}
[body.crank]
points = {{ pivot = ["0 mm", "0 mm"], pin = ["80 mm", "0 mm"] }}
[body.rocker]
points = {{ pivot = ["0 mm", "0 mm"], pin = ["80 mm", "0 mm"] }}
[body.middle]
points = {{ pivot = ["0 mm", "0 mm"], pin = ["80 mm", "0 mm"] }}
[body.coupler]
points = {{ a = ["0 mm", "0 mm"], b = ["200 mm", "0 mm"], c = ["100 mm", "0 mm"] }}

[joint.drive]
kind = "revolute"
bearing = "ground.a"
journal = "crank.pivot"
[joint.crank_pin]
kind = "revolute"
bearing = "crank.pin"
journal = "coupler.a"
[joint.rocker_pin]
kind = "revolute"
bearing = "coupler.b"
journal = "rocker.pin"
[joint.rocker_pivot]
kind = "revolute"
bearing = "ground.b"
journal = "rocker.pivot"
bearing_radius = "8 mm"
radial_clearance = "{rocker_clearance}"
[joint.middle_pin]
kind = "revolute"
bearing = "coupler.c"
journal = "middle.pin"
{middle}

[drive.crank]
joint = "drive"
speed = "60 rpm"
start_angle = "60 deg"

[assembly]
guess = {{ rocker = "60 deg", middle = "60 deg" }}

[output.rocker]
angle_of = "rocker"
[output.height]
position_of = "coupler.b"
along = "y"

[cycle]
drive = "crank"
"#
    )
}

fn pivot(clearance: &str) -> String {
    format!(
        "[joint.middle_pivot]\nkind = \"revolute\"\nbearing = \"ground.c\"\njournal = \"middle.pivot\"\nbearing_radius = \"8 mm\"\n\
         radial_clearance = \"{clearance}\""
    )
}

fn recorded(built: &Built) -> MotionRecord {
    motion_with_worst_cases(&built.mechanism, &built.values, &plan(built, 40)).expect("a motion")
}

/// The smallest and largest angle of the rocker from that of the crank where the loops close exactly, by a scan of the places of its pivot: its pin
/// lies on two circles, and the middle crank reaches the middle of the coupler with what play it has.
fn extremes_rad(crank_rad: f64, [clearance_m, middle_m]: [f64; 2]) -> [f64; 2] {
    let (sine, cosine) = crank_rad.sin_cos();
    let crank_pin = [CRANK_M * cosine, CRANK_M * sine];
    let mut found = [0.0_f64; 2];
    for (ring, step) in (0..=100).flat_map(|ring| (0..4000).map(move |step| (ring, step))) {
        let (radius_m, angle_rad) = (clearance_m * f64::from(ring) / 100.0, f64::from(step) * TAU / 4000.0);
        let pivot = [0.2 + radius_m * angle_rad.cos(), radius_m * angle_rad.sin()];
        // The pin is 200 mm from the crank's and 80 mm from the pivot, on the side of the ideal one.
        let [x, y] = [pivot[0] - crank_pin[0], pivot[1] - crank_pin[1]];
        let apart_m = x.hypot(y);
        let along_m = (apart_m * apart_m + 0.2 * 0.2 - CRANK_M * CRANK_M) / (2.0 * apart_m);
        let across_m = (0.2 * 0.2 - along_m * along_m).max(0.0).sqrt();
        // The parallelogram, not the crossed one.
        let side = if sine > 0.0 { 1.0 } else { -1.0 };
        let pin = [
            crank_pin[0] + (along_m * x - side * across_m * y) / apart_m,
            crank_pin[1] + (along_m * y + side * across_m * x) / apart_m,
        ];
        let middle = [0.5 * (crank_pin[0] + pin[0]) - 0.1, 0.5 * (crank_pin[1] + pin[1])];
        if (middle[0].hypot(middle[1]) - CRANK_M).abs() > middle_m + 1e-12 {
            continue;
        }
        let [along, up] = [pin[0] - pivot[0], pin[1] - pivot[1]];
        let turned = (up * cosine - along * sine).atan2(along * cosine + up * sine);
        found = [found[0].min(turned), found[1].max(turned)];
    }
    found
}

/// With u of the rocker's pivot and v of the middle one, e along the cranks and t across them, the coupler turns by φ = u·e/(200 sin θ) =
/// v·e/(100 sin θ) (mm): so u·e = 2 v·e, and the rocker turns by (u·e cot θ - u·t)/80. Over |u| <= c and |v| <= c', with w = min(c |cos θ|, 2c'),
/// that is at most (w |cot θ| + √(c² - w²))/80.
#[test]
fn analytic_play_of_three_parallel_cranks_meets_its_condition() {
    /// Round-off of the position over that of the clearance.
    const ROUND_OFF: f64 = 1e-8;
    /// What a scan in steps of a hundredth of the play may miss, and of a turn in 4,000 parts.
    const SCANNED: f64 = 2e-3;
    for (middle_m, middle) in [(1e-4, "0.1 mm"), (2e-5, "0.02 mm"), (0.0, "0 mm")] {
        let record = recorded(&three_cranks("0.1 mm", &pivot(middle)));
        let rocker = &record.outputs[0].clearance;
        assert_eq!(record.remarks, Vec::<String>::new());
        assert!(rocker.first_order_si.len() > 30);
        for (angle_rad, found) in record.drive_angle_rad.iter().zip(&rocker.first_order_si) {
            let (sine, cosine) = angle_rad.sin_cos();
            let along_m = f64::min(1e-4 * cosine.abs(), 2.0 * middle_m);
            let across_m = (1e-8 - along_m * along_m).sqrt();
            let due = (along_m * (cosine / sine).abs() + across_m) / CRANK_M;
            assert!((found - due).abs() < ROUND_OFF * due, "{middle} at {angle_rad}: {found} {due}");
        }
        let searched = &rocker.searched[0];
        assert_eq!(searched.conditions, 1);
        // A scan hits a condition that leaves no room nowhere.
        let due = (middle_m > 0.0).then(|| extremes_rad(record.drive_angle_rad[searched.position], [1e-4, middle_m]));
        for (found, due) in searched.found_si.iter().zip(due.into_iter().flatten()) {
            assert!((found / due - 1.0).abs() < SCANNED, "{middle}: {found} {due}");
        }
        // No closed form of the standard deviation where plays depend on each other.
        assert!(rocker.disc_standard_deviation_si.is_empty());
        let of_joints: f64 = rocker.contributors.iter().map(|joint| joint.first_order_si[3]).sum();
        assert!((of_joints - rocker.first_order_si[3]).abs() < ROUND_OFF * of_joints);
    }
}

/// A slot has no counterpart in space.
fn held_by_slots() -> Built {
    let slot = "[joint.middle_pivot]\nkind = \"slot\"\nslot = { point = \"ground.c\", angle = \"30 deg\" }\npin = \"middle.pivot\"\n[joint.middle_held]\n\
                kind = \"slot\"\nslot = { point = \"ground.c\", angle = \"120 deg\" }\npin = \"middle.pivot\"";
    three_cranks("0.1 mm", slot)
}

/// Then nothing is said of play, and why: which joints have it, but no effect on an output and no zone of a path. An output that is seen from a body
/// is found to have none only at the first position.
#[test]
fn what_space_does_not_have_is_said_not_guessed() {
    let output = "angle_of = \"rocker\"";
    let seen =
        three_cranks_text("0.1 mm", &pivot("0.1 mm")).replace(output, &format!("{output}\nrelative_to = \"crank\""));
    for (built, joints, reason) in [
        (held_by_slots(), &["rocker_pivot"][..], "there is none like joint 'middle_pivot'"),
        (build_text(&seen), &["rocker_pivot", "middle_pivot"], "output 'rocker' is seen from a body"),
    ] {
        let paths = built.mechanism.model.points_of_paths(&["coupler.c".to_owned()]).expect("a point");
        let record =
            motion_with_worst_cases(&built.mechanism, &built.values, &MotionPlan { paths, ..plan(&built, 40) });
        let record = record.expect("a motion");
        for output in &record.outputs {
            assert!(output.clearance.is_forgotten());
            let contributors = &output.clearance.contributors;
            assert!(
                contributors.iter().map(|joint| joint.joint.as_str()).eq(joints.iter().copied()),
                "{contributors:?}"
            );
            assert!(
                contributors.iter().all(|joint| joint.radial_clearance_m == 1e-4 && joint.first_order_si.is_empty())
            );
        }
        let [path] = &record.paths[..] else { panic!("one path") };
        assert!(path.is_complete() && !path.is_play_known() && !path.has_zone());
        let reaches = [&path.play_reach_m, &path.play_along_m, &path.play_across_m];
        assert!(reaches.into_iter().flatten().all(|reach_m| reach_m.is_nan()));
        let [remark] = &record.remarks[..] else { panic!("{:?}", record.remarks) };
        assert!(remark.contains(reason), "{remark}");
        assert!(record.unproven_spans.is_empty());
    }
}

/// The reach of a path along y is the worst case of that coordinate of its point.
#[test]
fn identity_the_zone_of_a_path_reaches_as_far_as_its_coordinates() {
    /// Round-off of the position over that of the clearance.
    const ROUND_OFF: f64 = 1e-8;
    let built = three_cranks("0.1 mm", &pivot("0.02 mm"));
    let paths = built.mechanism.model.points_of_paths(&["coupler.b".to_owned()]).expect("a point");
    let record = motion(&built.mechanism, &built.values, &MotionPlan { paths, ..plan(&built, 40) }).expect("a motion");
    let [path] = &record.paths[..] else { panic!("one path") };
    let height = &record.outputs[1].clearance.first_order_si;
    for (position, due) in height.iter().enumerate() {
        let found = path.play_reach_m[position * REACH_DIRECTIONS + REACH_DIRECTIONS / 2];
        assert!((found - due).abs() < ROUND_OFF * 1e-4, "{position}: {found} {due}");
    }
    assert!(height.iter().any(|effect_si| *effect_si > 1e-5), "{height:?}");
}

/// The effects of play on the rocker at a pose are those of the closed form, and the scatter is that of the turn; where nothing is known of play
/// the scatter is still there.
#[test]
fn analytic_poses_that_are_asked_about_have_their_effects() {
    /// Round-off of the position over that of the clearance.
    const ROUND_OFF: f64 = 1e-8;
    let middle_m = 2e-5;
    for (built, is_known) in [(three_cranks("0.1 mm", &pivot("0.02 mm")), true), (held_by_slots(), false)] {
        let scatter =
            vec![Scatter { quantity: built.quantity("body.rocker.points.pin.x"), standard_deviation_si: 2e-5 }];
        let walked = recorded(&built).drive_angle_rad;
        let asked = |pose_rad: f64| AskedPose { output: "rocker".to_owned(), pose_rad, is_required: true };
        let asked = vec![asked(walked[3]), asked(100.0_f64.to_radians())];
        let record = motion(&built.mechanism, &built.values, &MotionPlan { scatter, asked, ..plan(&built, 40) });
        let record = record.expect("a motion");
        assert_eq!(record.asked.len(), 2);
        for effect in &record.asked {
            let (sine, cosine) = effect.pose_rad.sin_cos();
            let along_m = f64::min(1e-4 * cosine.abs(), 2.0 * middle_m);
            let due = (along_m * (cosine / sine).abs() + (1e-8 - along_m * along_m).sqrt()) / CRANK_M;
            assert_eq!(effect.joints.len(), if is_known { 2 } else { 0 });
            let of_joints: f64 = effect.joints.iter().map(|joint| joint.value_si).sum();
            match is_known {
                true => assert!((effect.first_order_si - due).abs() < ROUND_OFF * due, "{effect:?} {due}"),
                false => assert!(effect.first_order_si.is_nan()),
            }
            assert!(!is_known || (of_joints - due).abs() < ROUND_OFF * due, "{effect:?}");
            assert!(effect.standard_deviation_si > 0.0 && effect.dimensions.len() == 1);
        }
        let [at_position, _] = &record.asked[..] else { panic!("two poses") };
        assert_eq!(at_position.standard_deviation_si, record.outputs[0].dimensional_standard_deviation_si[3]);
    }
}

/// Searches that count each play by itself would find places at which the loops do not close: what is found is what the motion finds.
#[test]
fn identity_deviations_with_play_are_those_that_the_motion_finds() {
    for middle in ["0 mm", "0.1 mm"] {
        let built = three_cranks("0.1 mm", &pivot(middle));
        let reading = position_outputs(&built.mechanism)[0].reading;
        let questions = [Deviation::Clearance, Deviation::Total].map(|of| DeviationQuestion { reading, of });
        let span = built.mechanism.model.cycle.span;
        let ends = deviation_ends(&built.mechanism, &built.values, (span, 40), &[], &questions).expect("it moves");
        let record = motion_with_worst_cases(&built.mechanism, &built.values, &plan(&built, 40)).expect("a motion");
        let searched = &record.outputs[0].clearance.searched;
        let lowest = searched.iter().map(|own| own.found_si[0]).fold(0.0, f64::min);
        let highest = searched.iter().map(|own| own.found_si[1]).fold(0.0, f64::max);
        for own in &ends.of_questions {
            let found = own.found.map(|found| found.deviation_si);
            let is_same = |a: f64, b: f64| (a - b).abs() <= 1e-12;
            assert!(is_same(found[0], lowest) && is_same(found[1], highest), "{found:?} {lowest} {highest}");
            assert!(own.unproven.iter().all(Option::is_some));
        }
    }
}

/// Three sliders in parallel guides on a bar, of which two are enough; the first is driven. With the bar at β to the guides, u and v the play at the
/// third and at the middle slider and n across the guides, the bar turns by u·n/(L cos β) = 2 v·n/(L cos β), and the third slider moves along its
/// guide by up to w tan β + √(c² - w²), w = min(2c', c sin β).
#[test]
fn analytic_play_of_a_bar_on_three_sliders_meets_its_condition() {
    /// Round-off of the position over that of the clearance.
    const ROUND_OFF: f64 = 1e-8;
    /// The bar turns by 1e-3 rad at most, so that the exact numbers are within that of those of first order.
    const SECOND_ORDER: f64 = 2e-3;
    let clearance_m = 1e-4;
    for (middle_m, middle) in [(1e-4, "0.1 mm"), (2e-5, "0.02 mm")] {
        let record = recorded(&build_text(&SLIDERS.replace("MIDDLE", middle)));
        assert_eq!(record.remarks, Vec::<String>::new());
        // sin β = 0.6.
        let across_m = f64::min(2.0 * middle_m, 0.6 * clearance_m);
        let due = 0.75 * across_m + (clearance_m * clearance_m - across_m * across_m).sqrt();
        let answer = &record.outputs[0].clearance;
        assert!(answer.first_order_si.iter().all(|found| (found - due).abs() < ROUND_OFF * due), "{due} {answer:?}");
        assert_eq!(answer.searched[0].conditions, 1);
        assert!(answer.searched[0].found_si.iter().all(|found| (found.abs() / due - 1.0).abs() < SECOND_ORDER));
    }
}

const SLIDERS: &str = r#"
name = "a bar on three sliders"

[body.ground]
points = { first = ["0 mm", "0 mm"], middle = ["-60 mm", "0 mm"], third = ["-120 mm", "0 mm"] }
[body.first]
points = { pin = ["0 mm", "0 mm"] }
[body.middle]
points = { pin = ["0 mm", "0 mm"] }
[body.third]
points = { pin = ["0 mm", "0 mm"] }
[body.bar]
points = { first = ["0 mm", "0 mm"], middle = ["100 mm", "0 mm"], third = ["200 mm", "0 mm"] }

[joint.push]
kind = "prismatic"
guide = { point = "ground.first", angle = "90 deg" }
slider = { point = "first.pin", angle = "0 deg" }
[joint.middle_guide]
kind = "prismatic"
guide = { point = "ground.middle", angle = "90 deg" }
slider = { point = "middle.pin", angle = "0 deg" }
[joint.third_guide]
kind = "prismatic"
guide = { point = "ground.third", angle = "90 deg" }
slider = { point = "third.pin", angle = "0 deg" }
[joint.first_pin]
kind = "revolute"
bearing = "first.pin"
journal = "bar.first"
[joint.middle_pin]
kind = "revolute"
bearing = "bar.middle"
journal = "middle.pin"
bearing_radius = "8 mm"
radial_clearance = "MIDDLE"
[joint.third_pin]
kind = "revolute"
bearing = "bar.third"
journal = "third.pin"
bearing_radius = "8 mm"
radial_clearance = "0.1 mm"

[drive.push]
joint = "push"
motion = { kind = "harmonic", mean = "30 mm", amplitude = "20 mm", frequency = "1 Hz" }

[assembly]
guess = { bar = "126.87 deg" }

[output.third]
position_of = "third.pin"
along = "y"

[cycle]
duration = "1 s"
"#;

//! Play where constraints of joints repeat each other: a coupler on three parallel cranks, of which two are enough.

use super::motion::plan;
use super::{Built, build_text};
use loosepin_result::motion::MotionRecord;
use loosepin_simulate::accuracy::motion_with_worst_cases;
use std::f64::consts::TAU;

/// Length of all cranks, m.
const CRANK_M: f64 = 0.08;

/// The coupler lies 200 mm long on the driven crank and a rocker with play at its pivot, and half way on a crank in the middle with play there too.
fn three_cranks(rocker_clearance: &str, middle: &str) -> Built {
    build_text(&format!(
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
    ))
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

/// A slot has no counterpart in space: then nothing is said of play, and why.
#[test]
fn what_space_does_not_have_is_said_not_guessed() {
    let slot = "[joint.middle_pivot]\nkind = \"slot\"\nslot = { point = \"ground.c\", angle = \"30 deg\" }\npin = \"middle.pivot\"\n[joint.middle_held]\n\
                kind = \"slot\"\nslot = { point = \"ground.c\", angle = \"120 deg\" }\npin = \"middle.pivot\"";
    let record = recorded(&three_cranks("0.1 mm", slot));
    assert!(record.outputs.iter().all(|output| output.clearance == Default::default()));
    let [remark] = &record.remarks[..] else { panic!("{:?}", record.remarks) };
    assert!(remark.contains("there is none like joint 'middle_pivot'"), "{remark}");
}

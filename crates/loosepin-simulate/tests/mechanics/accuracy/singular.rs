//! Dead points, crossings of branches and positions close to them.

use super::motion::{motion_of, output};
use super::{Built, build_case_with, build_text, cases};
use loosepin_mechanics::mechanism::IdealMotion;

/// Singular positions are located to 1e-12 of a turn; a dead point is found where the loops no longer close to 1e-9 of the
/// size, whose square root is 3e-5 rad away at most.
const LOCATED_RAD: f64 = 1e-7;

/// Four bars between pivots `base` mm apart, the drive starting at `start` degrees.
fn four_bar(lengths_mm: [f64; 3], base: f64, start: f64, guess: &str) -> Built {
    let [crank, coupler, rocker] = lengths_mm;
    build_text(&format!(
        r#"
name = "four bars"
gravity = "9.81 m/s^2"
[body.ground]
points = {{ o = ["0 mm", "0 mm"], p = ["{base} mm", "0 mm"] }}
[body.crank]
mass = "0.3 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["20 mm", "0 mm"]
points = {{ main = ["0 mm", "0 mm"], pin = ["{crank} mm", "0 mm"] }}
[body.coupler]
mass = "0.3 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["20 mm", "0 mm"]
points = {{ tail = ["0 mm", "0 mm"], head = ["{coupler} mm", "0 mm"] }}
[body.rocker]
mass = "0.3 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["20 mm", "0 mm"]
points = {{ pivot = ["0 mm", "0 mm"], pin = ["{rocker} mm", "0 mm"] }}
[contact.steel]
law = "hertz"
restitution = 0.9
stiffness = "6.6e10 N/m^1.5"
exponent = 1.5
[joint.main]
kind = "revolute"
bearing = "ground.o"
journal = "crank.main"
[joint.low]
kind = "revolute"
bearing = "crank.pin"
journal = "coupler.tail"
[joint.high]
kind = "revolute"
bearing = "coupler.head"
journal = "rocker.pin"
bearing_radius = "8 mm"
radial_clearance = "0.1 mm"
contact = "steel"
[joint.pivot]
kind = "revolute"
bearing = "ground.p"
journal = "rocker.pivot"
[drive.crank]
joint = "main"
speed = "60 rpm"
start_angle = "{start} deg"
[cycle]
drive = "crank"
[assembly]
guess = {guess}
[output.rocker]
angle_of = "rocker"
"#
    ))
}

#[test]
fn analytic_dead_points_of_a_slider_crank_with_a_short_rod() {
    // The rod reaches the guide only while r |sin θ| <= l.
    let built = build_case_with("slider_crank_5000", &[("parameter.rod_length", 0.04)]);
    let record = motion_of(&built, 360);
    let limit_rad = (0.04_f64 / 0.05).asin();
    let ends: Vec<f64> = record.singular_positions.iter().map(|position| position.drive_angle_rad).collect();
    assert_eq!(ends.len(), 2, "{:?}", record.singular_positions);
    assert!((ends[0] + limit_rad).abs() < LOCATED_RAD, "{ends:?}");
    assert!((ends[1] - limit_rad).abs() < LOCATED_RAD, "{ends:?}");
    assert!(record.drive_angle_rad.windows(2).all(|pair| pair[0] < pair[1]));
    let (first, last) = (record.drive_angle_rad[0], record.drive_angle_rad[record.drive_angle_rad.len() - 1]);
    let step_rad = std::f64::consts::TAU / 360.0;
    assert!(first > -limit_rad && first < -limit_rad + step_rad);
    assert!(last < limit_rad && last > limit_rad - step_rad);
    for position in &record.singular_positions {
        assert!(position.words.starts_with("dead point: the drive cannot turn further"), "{}", position.words);
    }
    assert_eq!(output(&record, "slider").value_si.len(), record.drive_angle_rad.len());
}

#[test]
fn analytic_dead_points_of_a_four_bar_without_a_crank() {
    // Coupler and rocker are in line where the pin of the crank is b + c away from the other pivot:
    // a² + d² - 2 a d cos θ = (b + c)².
    let (a, b, c, d) = (90.0, 61.0, 73.0, 110.0);
    let built = four_bar([a, b, c], d, 40.0, r#"{ rocker = "110 deg" }"#);
    let record = motion_of(&built, 720);
    let limit_rad = ((a * a + d * d - (b + c) * (b + c)) / (2.0_f64 * a * d)).acos();
    let ends: Vec<f64> = record.singular_positions.iter().map(|position| position.drive_angle_rad).collect();
    assert_eq!(ends.len(), 2, "{:?}", record.singular_positions);
    assert!((ends[0] + limit_rad).abs() < LOCATED_RAD, "{ends:?} {limit_rad}");
    assert!((ends[1] - limit_rad).abs() < LOCATED_RAD, "{ends:?} {limit_rad}");
}

#[test]
fn analytic_nearly_dead_point_of_a_slider_crank() {
    // The transmission angle is the one between rod and guide's normal: cos φ = √(1 - (r/l)²) at 90° and 270°.
    let built = build_case_with("slider_crank_5000", &[("parameter.rod_length", 0.0501)]);
    let record = motion_of(&built, 360);
    let angles: Vec<f64> = record.singular_positions.iter().map(|p| p.drive_angle_rad.to_degrees()).collect();
    assert_eq!(angles.len(), 2, "{:?}", record.singular_positions);
    assert!((angles[0] - 90.0).abs() < 1e-3 && (angles[1] - 270.0).abs() < 1e-3, "{angles:?}");
    let sine = (1.0 - (0.05_f64 / 0.0501).powi(2)).sqrt();
    let words = format!(
        "nearly a dead point: the transmission angle is {:.2}° away from 0°, small errors and forces are magnified by a factor of about {:.0}",
        sine.asin().to_degrees(),
        1.0 / sine
    );
    assert_eq!(record.singular_positions[0].words, words);
}

/// Crank and rocker of 50 mm, coupler and base of 120 mm: the rocker goes on with the crank, or as an antiparallelogram. The
/// second derivative of the loop along the line of the bars gives ψ̇ = -ω (l - r)/(l + r) where the crank points inwards, and
/// ψ̇ = -ω (l + r)/(l - r) where it points outwards.
fn assert_ways_on(record: &loosepin_simulate::accuracy::record::MotionRecord) {
    let (inwards, outwards) = (-60.0 * 70.0 / 170.0, -60.0 * 170.0 / 70.0);
    let said = [format!("{inwards:.5}"), format!("{outwards:.4}")].map(|other_rpm| {
        format!(
            "the links can be assembled in two ways here, and the drives do not determine which one the mechanism follows: \
             'rocker' goes on at 60 rpm or at {other_rpm} rpm"
        )
    });
    let words: Vec<&str> = record.singular_positions.iter().map(|position| position.words.as_str()).collect();
    assert_eq!(words, said);
}

#[test]
fn analytic_branches_of_a_parallelogram_cross_where_it_is_flat() {
    let built = four_bar([50.0, 120.0, 50.0], 120.0, 33.3, r#"{ rocker = "33.3 deg" }"#);
    let record = motion_of(&built, 360);
    let angles: Vec<f64> = record.singular_positions.iter().map(|p| p.drive_angle_rad.to_degrees()).collect();
    assert_eq!(angles.len(), 2, "{angles:?}");
    assert!((angles[0] - 180.0).abs() < 1e-4 && (angles[1] - 360.0).abs() < 1e-4, "{angles:?}");
    // The motion goes on as a parallelogram.
    let rocker = output(&record, "rocker");
    for (angle, value) in record.drive_angle_rad.iter().zip(&rocker.value_si) {
        assert!((angle - value).abs() < 1e-9, "{angle}: {value}");
    }
    assert_ways_on(&record);
}

#[test]
fn analytic_parallelogram_that_is_flat_at_a_sample() {
    let built = four_bar([50.0, 120.0, 50.0], 120.0, 30.0, r#"{ rocker = "30 deg" }"#);
    let record = motion_of(&built, 360);
    let angles: Vec<f64> = record.singular_positions.iter().map(|p| p.drive_angle_rad.to_degrees()).collect();
    assert_eq!(angles.len(), 2, "{angles:?}");
    assert!((angles[0] - 180.0).abs() < 1e-4 && (angles[1] - 360.0).abs() < 1e-4, "{angles:?}");
    // The motion goes on as a parallelogram.
    let rocker = output(&record, "rocker");
    for (angle, value) in record.drive_angle_rad.iter().zip(&rocker.value_si) {
        assert!((angle - value).abs() < 1e-9, "{angle}: {value}");
    }
    assert_ways_on(&record);
}

#[test]
fn identity_sound_mechanisms_have_no_singular_positions() {
    for case in ["slider_crank_5000", "four_bar_600", "six_bar", "scotch_yoke"] {
        let record = motion_of(&super::build_case(case), 90);
        assert!(record.singular_positions.is_empty(), "{case}: {:?}", record.singular_positions);
    }
}

/// The model of a case with every length `factor` times as large; masses stay.
fn scaled(case: &str, factor: f64) -> Built {
    let text = std::fs::read_to_string(cases().join(case).join("model.toml")).expect("the case is there");
    let times = |length: &str| Some(format!("{:e} mm", factor * length.strip_suffix(" mm")?.parse::<f64>().ok()?));
    let parts = text.split('"').map(|part| times(part).unwrap_or_else(|| part.to_owned()));
    build_text(&parts.collect::<Vec<String>>().join("\""))
}

#[test]
fn identity_degrees_of_freedom_are_those_of_any_size() {
    for case in ["slider_crank_worn_pin", "inverted_slider_crank_literal", "four_bar_600"] {
        let natural = scaled(case, 1.0);
        for factor in [1e-9, 1e-3, 1e10] {
            let built = scaled(case, factor);
            let (own, due) = (&built.mechanism, &natural.mechanism);
            assert_eq!(own.degrees_of_freedom, due.degrees_of_freedom, "{case} times {factor}");
            assert_eq!(own.dynamic_freedoms, due.dynamic_freedoms, "{case} times {factor}");
            assert_eq!(own.redundant.len(), due.redundant.len(), "{case} times {factor}");
            let sample = built.sample();
            let start = IdealMotion::new(own, &sample.ideal, &sample.drives);
            assert!(start.is_ok(), "{case} times {factor}: {:?}", start.err());
        }
    }
}

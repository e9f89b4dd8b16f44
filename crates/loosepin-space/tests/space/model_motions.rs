//! Motions of models in files, with their worst cases, against independent programs.

use loosepin_result::motion::{MotionRecord, OutputMotion};
use loosepin_space::SpatialModel;

const SLIDER_CRANK: &str = include_str!("../../../../docs/examples/spatial-slider-crank.toml");

/// Planar slider-crank whose rod may lean: crank 50 mm about z, rod 120 mm, a ball at the crank, the gudgeon with play.
const LEANING: &str = r#"
name = "leaning"
geometry = "space"

[body.ground]
points = { o = ["0 mm", "0 mm", "0 mm"] }
[body.crank]
points = { o = ["0 mm", "0 mm", "0 mm"], pin = ["50 mm", "0 mm", "0 mm"] }
[body.rod]
points = { crank = ["0 mm", "0 mm", "0 mm"], slider = ["120 mm", "0 mm", "0 mm"], tip = ["60 mm", "0 mm", "50 mm"] }
[body.slider]
points = { pin = ["0 mm", "0 mm", "0 mm"] }

[joint.main]
kind = "revolute"
bearing = "ground.o"
journal = "crank.o"
[joint.crankpin]
kind = "spherical"
bearing = "crank.pin"
journal = "rod.crank"
[joint.gudgeon]
kind = "revolute"
bearing = "rod.slider"
journal = "slider.pin"
radial_clearance = "0.2 mm"
bearing_length = "20 mm"
axial_clearance = "0.1 mm"
[joint.guide]
kind = "prismatic"
bearing = "ground.o"
journal = "slider.pin"
axis = "x"

[drive.crank]
joint = "main"
speed = "1500 rpm"
start_angle = "60 deg"
[assembly]
guess = { slider = { at = ["150 mm", "0 mm", "0 mm"] } }
[cycle]
drive = "crank"
samples_per_turn = 6

[output.slider]
position_of = "slider.pin"
along = "x"
[output.tip]
position_of = "rod.tip"
along = "z"
[output.tip_path]
path_of = "rod.tip"
"#;

fn record(text: &str) -> MotionRecord {
    let model = SpatialModel::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let found = model.motion_with_paths_until(&model.quantities.nominal(), &[], true, &|| false);
    found.unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

fn assert_close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance * expected.abs(), "{found} {expected}");
}

/// The parts of all joints make the worst case; what each does alone is at most its part, and all of it at least.
fn assert_parts(output: &OutputMotion) {
    let answer = &output.clearance;
    for (position, worst) in answer.first_order_si.iter().enumerate() {
        let parts: f64 = answer.contributors.iter().map(|own| own.first_order_si[position]).sum();
        // Of a vector, the direction of the longest one is found by a search.
        assert_close(parts, *worst, 1e-9);
        for own in &answer.contributors {
            let at = |effect_si: &[f64]| effect_si.get(position).copied().unwrap_or(0.0);
            let [part, offset, lean, axial] =
                [&own.first_order_si, &own.offset_si, &own.lean_si, &own.axial_si].map(|effect_si| at(effect_si));
            let (radial, slack) = (part - axial, 1e-9 * part + 1e-15);
            assert!(offset <= radial + slack && lean <= radial + slack, "{position} {own:?}");
            assert!(offset + lean + axial + slack >= part, "{position} {own:?}");
        }
    }
}

#[test]
fn peer_worst_cases_of_the_slider_crank_of_the_file() {
    let record = record(&SLIDER_CRANK.replace("samples_per_turn = 36", "samples_per_turn = 6"));
    let [output] = record.outputs.as_slice() else { panic!("one output") };
    // First order and standard deviation at 0, 60, ... 300 deg; an independent program, 12 and 10 digits.
    let rows = [
        (0.00100158563062, 0.0003080516732),
        (0.00100233175353, 0.0003063595991),
        (0.00100022001727, 0.0003056867504),
        (0.0010007970506, 0.0003058075903),
        (0.001002699197, 0.0003068075745),
        (0.00100051991956, 0.0003085947999),
        (0.00100158563062, 0.0003080516732),
    ];
    assert_eq!(output.clearance.first_order_si.len(), rows.len());
    for (sample, (worst, sigma)) in rows.into_iter().enumerate() {
        assert_close(record.drive_angle_rad[sample], std::f64::consts::FRAC_PI_3 * sample as f64, 1e-14);
        assert_close(output.clearance.first_order_si[sample], worst, 2e-11);
        assert_close(output.clearance.disc_standard_deviation_si[sample], sigma, 1e-9);
    }
    // The largest of these is at 240 deg; there the exact ones.
    let [searched] = output.clearance.searched.as_slice() else { panic!("one position") };
    assert_eq!(searched.position, 4);
    let [smallest, largest] = searched.found_si;
    assert_close(largest, 0.00100536901271, 2e-11);
    assert_close(smallest, -0.00100000415992, 2e-11);
    assert_eq!(searched.conditions, 0);
    // The proven ends are outside these numbers of an independent program, and near.
    let [below, above] = searched.proven_si.unwrap();
    assert!(above > 0.00100536901271 && above < 1.002 * 0.00100536901271, "{above}");
    assert!(below < -0.00100000415992 && below > -1.002 * 0.00100000415992, "{below}");
    assert_parts(output);
    // The axial clearance moves the slider along with it: gain 1.
    assert_close(output.clearance.contributors[0].axial_si[4], 2e-4, 1e-9);
}

#[test]
fn peer_worst_cases_of_an_overconstrained_loop() {
    let record = record(LEANING);
    let [slider, tip, path] = record.outputs.as_slice() else { panic!("three outputs") };
    // At 60 deg; independent programs, which minimise numerically for the second.
    assert_close(slider.clearance.first_order_si[0], 0.000214448184772, 2e-11);
    assert_close(tip.clearance.first_order_si[0], 5.00000000063e-05, 1e-9);
    assert!(record.outputs.iter().all(|output| output.clearance.disc_standard_deviation_si.is_empty()));
    for output in &record.outputs {
        let searched = &output.clearance.searched[0];
        assert_eq!(searched.conditions, 1);
        assert_eq!(searched.proven_si, Some([f64::NEG_INFINITY, f64::INFINITY]));
        assert_parts(output);
    }
    // A path is displaced at least as far as in one direction, and has no number of its own.
    assert!(
        path.value_si.is_empty()
            && path.clearance.first_order_si.iter().zip(&tip.clearance.first_order_si).all(|(a, b)| a >= b)
    );
}

#[test]
fn a_motion_needs_a_turn() {
    let without_cycle = SLIDER_CRANK.replace("[cycle]\ndrive = \"crank\"\nsamples_per_turn = 36\n", "");
    let stands_still = SLIDER_CRANK.replace("speed = \"60 rpm\"", "speed = \"0 rpm\"");
    let too_short = SLIDER_CRANK.replace("rod_length = \"300 mm\"", "rod_length = \"200 mm\"");
    for (text, expected) in [
        (without_cycle, "the file has no [cycle]"),
        (stands_still, "drive 'crank': speed is zero, so the turns of its drive cannot be counted"),
        (too_short, "the joints close, but no position was found with the drives where they start"),
    ] {
        let model = SpatialModel::from_text("model.toml", &text).unwrap();
        let diagnostics = model.motion_record(&model.quantities.nominal()).unwrap_err();
        let first = diagnostics.sorted()[0];
        assert!(first.message.starts_with(expected), "{}", first.message);
        // A joint that cannot be closed is shown in the file.
        assert_eq!(first.place.is_some(), expected != "the file has no [cycle]", "{expected}");
    }
}

/// A nut on a spindle: z = p/2π φ, with φ counted through whole turns.
#[test]
fn analytic_a_screw_starts_as_far_along_as_its_turns_say() {
    let record = record(
        r#"
name = "screw"
geometry = "space"
[body.ground]
points = { o = ["0 mm", "0 mm", "0 mm"] }
[body.nut]
points = { o = ["0 mm", "0 mm", "0 mm"] }
[joint.thread]
kind = "screw"
bearing = "ground.o"
journal = "nut.o"
pitch = "20 mm"
[drive.motor]
joint = "thread"
speed = "60 rpm"
start_angle = "740 deg"
[cycle]
drive = "motor"
samples_per_turn = 12
[output.nut]
position_of = "nut.o"
along = "z"
"#,
    );
    let [first, .., last] = record.outputs[0].value_si.as_slice() else { panic!("thirteen positions") };
    assert_close(*first, 0.02 * 740.0 / 360.0, 1e-10);
    assert_close(*last, 0.02 * 1100.0 / 360.0, 1e-10);
}

/// A planar four-bar in a skew plane, whose numbers have few decimals: its redundant rows are about 1e-11 m apart, play or not. Of the lean only the
/// offset is left, so the worst case of first order has no lean in it.
#[test]
fn a_loop_of_rounded_numbers_has_exact_worst_cases() {
    let [axis, x, y] = [[0.0, 0.6, 0.8], [1.0, 0.0, 0.0], [0.0, 0.8, -0.6]];
    let normalise = |v: [f64; 3]| v.map(|own| own / v.iter().map(|own| own * own).sum::<f64>().sqrt());
    // Turned by 1 rad about (1, 2, 3).
    let along = normalise([1.0, 2.0, 3.0]);
    let turned = |v: [f64; 3]| {
        let dot: f64 = v.iter().zip(&along).map(|(a, b)| a * b).sum();
        let cross =
            [along[1] * v[2] - along[2] * v[1], along[2] * v[0] - along[0] * v[2], along[0] * v[1] - along[1] * v[0]];
        [0, 1, 2].map(|k| v[k] * 1f64.cos() + cross[k] * 1f64.sin() + along[k] * dot * (1.0 - 1f64.cos()))
    };
    let [axis, x, y] = [axis, x, y].map(turned);
    let written = |u: f64, v: f64, decimals: usize| {
        let [a, b, c] = [0, 1, 2].map(|k| format!("\"{:.decimals$} mm\"", u * x[k] + v * y[k]));
        format!("[{a}, {b}, {c}]")
    };
    let at = |u: f64, v: f64| written(u, v, 7);
    // One of the parts is known better than its partner.
    let fine = written(271.7, 148.9, 11);
    let axis = format!("[{:.10}, {:.10}, {:.10}]", axis[0], axis[1], axis[2]);
    let [o, b, c, d] = [at(0.0, 0.0), at(23.1, 71.3), at(271.7, 148.9), at(300.0, 0.0)];
    let joint = |name: &str, bearing: &str, journal: &str| {
        format!(
            "[joint.{name}]\nkind = \"revolute\"\nbearing = \"{bearing}\"\njournal = \"{journal}\"\naxis = {axis}\n"
        )
    };
    let text = format!(
        "name = \"skew\"\ngeometry = \"space\"\n[body.ground]\npoints = {{ o = {o}, d = {d} }}\n[body.crank]\npoints = {{ o = {o}, b = {b} }}\n\
         [body.coupler]\npoints = {{ b = {b}, c = {c} }}\n[body.rocker]\npoints = {{ c = {fine}, d = {d} }}\n{}{}{}{}\
         radial_clearance = \"0.1 mm\"\nbearing_length = \"20 mm\"\n\
         [drive.crank]\njoint = \"main\"\nspeed = \"60 rpm\"\nstart_angle = \"0 deg\"\n[cycle]\ndrive = \"crank\"\nsamples_per_turn = 12\n\
         [output.pin]\nposition_of = \"rocker.c\"\nalong = [{:.6}, {:.6}, {:.6}]\n",
        joint("main", "ground.o", "crank.o"),
        joint("crankpin", "crank.b", "coupler.b"),
        joint("pivot", "ground.d", "rocker.d"),
        joint("pin", "rocker.c", "coupler.c"),
        x[0],
        x[1],
        x[2],
    );
    let output = &record(&text).outputs[0];
    // Without axial play nothing reaches the row along the axis.
    let searched = &output.clearance.searched[0];
    assert_eq!(searched.conditions, 2);
    let first_order = output.clearance.first_order_si[searched.position];
    assert!(first_order > 1e-5);
    assert_close(output.clearance.contributors[0].offset_si[searched.position], first_order, 1e-9);
    assert_close(searched.found_si[1], first_order, 1e-2);
    assert_close(-searched.found_si[0], first_order, 1e-2);
}

/// A drive that runs backwards goes through the same positions: records have them by increasing angle, whichever way they are gone through.
#[test]
fn identity_a_drive_that_runs_backwards_has_the_same_record_by_increasing_angle() {
    let forward = record(SLIDER_CRANK);
    let backward = record(&SLIDER_CRANK.replace("\"60 rpm\"", "\"-60 rpm\""));
    let turn = std::f64::consts::TAU;
    let [own, other] = [&forward.outputs[0], &backward.outputs[0]];
    assert!(backward.drive_angle_rad.windows(2).all(|pair| pair[0] < pair[1]));
    for (position, angle_rad) in backward.drive_angle_rad.iter().enumerate() {
        assert!((angle_rad + turn - forward.drive_angle_rad[position]).abs() < 1e-12, "{angle_rad}");
        assert_close(other.value_si[position], own.value_si[position], 1e-10);
        assert_close(other.clearance.first_order_si[position], own.clearance.first_order_si[position], 1e-9);
    }
    assert_eq!(own.clearance.searched[0].position, other.clearance.searched[0].position);
    assert_close(other.clearance.searched[0].found_si[1], own.clearance.searched[0].found_si[1], 1e-9);
}

#[test]
fn a_turn_in_large_steps_is_refused() {
    let text = include_str!("../../../../docs/examples/rssr-four-bar.toml");
    let coarse = text.replace("samples_per_turn = 36", "samples_per_turn = 4");
    assert_ne!(coarse, text);
    let model = SpatialModel::from_text("model.toml", &coarse).unwrap();
    let diagnostics = model.motion_record(&model.quantities.nominal()).unwrap_err();
    let first = diagnostics.sorted()[0];
    assert!(
        first.message.contains("may turn by a quarter of a turn at most") && first.place.is_some(),
        "{}",
        first.message
    );
}

/// A crank of r = 50 mm about z, 60 rpm, whose bearing of length l = 20 mm has c = 0.1 mm and c_a = 0.2 mm.
const CRANK: &str = r#"
name = "crank"
geometry = "space"
[body.ground]
points = { o = ["0 mm", "0 mm", "0 mm"] }
[body.crank]
points = { o = ["0 mm", "0 mm", "0 mm"], tip = ["50 mm", "0 mm", "0 mm"], axle = ["0 mm", "0 mm", "30 mm"] }
[joint.main]
kind = "revolute"
bearing = "ground.o"
journal = "crank.o"
radial_clearance = "0.1 mm"
bearing_length = "20 mm"
axial_clearance = "0.2 mm"
[drive.crank]
joint = "main"
speed = "60 rpm"
start_angle = "0 deg"
[cycle]
drive = "crank"
samples_per_turn = 12
"#;

/// d = ((u1 + u2)/2 across the axis, α + r (u2 - u1)/l along it): c along the path, c_a + 2 r c/l across it, which is the longest as well.
#[test]
fn analytic_the_path_of_a_crank_has_the_reach_of_offset_and_lean_of_its_bearing() {
    let model = SpatialModel::from_text("model.toml", CRANK).unwrap();
    let points = model.points_of_paths(&["crank.tip".into(), "crank.axle".into(), "crank.tip".into()]).unwrap();
    let record = model.motion_with_paths_until(&model.quantities.nominal(), &points, false, &|| false).unwrap();
    let [tip, axle] = &record.paths[..] else { panic!("{:?}", record.paths) };
    assert!(tip.is_complete() && tip.is_in_space() && tip.output.is_none() && axle.is_complete());
    assert_eq!([&tip.name, &tip.point, &axle.name], ["crank.tip", "crank.tip", "crank.axle"]);
    let speed = std::f64::consts::TAU;
    for (k, angle) in record.drive_angle_rad.iter().enumerate() {
        let [x, y] = [0.05 * angle.cos(), 0.05 * angle.sin()];
        for (found, due) in [(tip.x_m[k], x), (tip.y_m[k], y), (tip.z_m[k], 0.0)] {
            assert!((found - due).abs() < 1e-15, "{found} {due}");
        }
        assert_close(tip.speeds_m_s()[k], 0.05 * speed, 1e-13);
        assert_close(tip.acceleration_magnitudes_m_s2()[k], 0.05 * speed * speed, 1e-13);
        assert!((tip.tangent_x[k] * x + tip.tangent_y[k] * y).abs() < 1e-15 && tip.tangent_z[k].abs() < 1e-15);
        assert_close(tip.play_along_m[k], 1e-4, 1e-12);
        assert_close(tip.play_across_m[k], 2e-4 + 2.0 * 0.05 * 1e-4 / 0.02, 1e-12);
        assert_close(tip.play_longest_m[k], 7e-4, 1e-12);
        // On the axis it rests: no direction is along its path. At a height h = 30 mm, c (h/l + 1/2 + h/l - 1/2) = 3 c and c_a.
        assert!(axle.stands_still(k));
        for reach in [axle.play_along_m[k], axle.play_across_m[k], axle.play_longest_m[k]] {
            assert_close(reach, 3e-4_f64.hypot(2e-4), 1e-12);
        }
    }
    // The picture has both, where play takes them.
    let drawn: Vec<(&str, bool)> =
        record.picture.traces.iter().map(|trace| (trace.point.as_str(), !trace.zones.is_empty())).collect();
    assert_eq!(drawn, [("crank.tip", true), ("crank.axle", true)]);
}

#[test]
fn identity_an_output_that_is_a_path_has_its_path_with_its_worst_case() {
    let record = record(LEANING);
    let [path] = &record.paths[..] else { panic!("{:?}", record.paths) };
    assert_eq!(
        (path.name.as_str(), path.point.as_str(), path.output.as_deref()),
        ("tip_path", "rod.tip", Some("tip_path"))
    );
    let output = record.outputs.iter().find(|own| own.name == "tip_path").unwrap();
    assert_eq!(path.play_longest_m, output.clearance.first_order_si);
    let z = record.outputs.iter().find(|own| own.name == "tip").unwrap();
    for k in 0..path.positions() {
        assert_close(path.z_m[k], z.value_si[k], 1e-12);
        assert!(path.play_along_m[k].hypot(path.play_across_m[k]) >= path.play_longest_m[k] * (1.0 - 1e-12));
    }
    // Differences of places have the rates.
    let fine = LEANING.replace("samples_per_turn = 6", "samples_per_turn = 3600");
    let model = SpatialModel::from_text("model.toml", &fine).unwrap();
    let path = &model.motion_record(&model.quantities.nominal()).unwrap().paths[0];
    let step_s = 0.04 / 3600.0;
    for k in (100..3500).step_by(700) {
        for (place, rate, second) in [
            (&path.x_m, &path.velocity_x_m_s, &path.acceleration_x_m_s2),
            (&path.y_m, &path.velocity_y_m_s, &path.acceleration_y_m_s2),
        ] {
            assert!(((place[k + 1] - place[k - 1]) / (2.0 * step_s) - rate[k]).abs() < 1e-4, "{}", rate[k]);
            assert!(((rate[k + 1] - rate[k - 1]) / (2.0 * step_s) - second[k]).abs() < 1e-1, "{}", second[k]);
        }
    }
}

#[test]
fn a_path_of_no_point_is_refused_with_the_nearest_one() {
    let model = SpatialModel::from_text("model.toml", CRANK).unwrap();
    let refused = |name: &str| model.points_of_paths(&[name.to_owned()]).unwrap_err().sorted()[0].message.clone();
    assert_eq!(refused("crank.tpi"), "--path: there is no point 'crank.tpi'");
    assert_eq!(refused("tip"), "--path is 'tip'; must be body.point");
}

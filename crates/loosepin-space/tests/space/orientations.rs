//! The rotation of a body from its ideal orientation as an output, against closed forms of chains that are open.

use crate::sampling::{assert_close, model, part, with};
use loosepin_space::{
    PartOfOutput, PlayDistribution, PlaySide, SamplingError, SpatialModel, SpatialScatterPlan, TurnSampler,
};

/// Two driven pins at right angles that lean by up to 2c/l, and a part that is fixed to the second arm by a joint with a tilt.
const ARM: &str = r#"
name = "arm"
geometry = "space"
[body.ground]
points = { o = ["0 mm", "0 mm", "0 mm"] }
[body.upper]
points = { o = ["0 mm", "0 mm", "0 mm"], elbow = ["300 mm", "0 mm", "0 mm"] }
[body.fore]
points = { o = ["0 mm", "0 mm", "0 mm"], wrist = ["0 mm", "0 mm", "200 mm"] }
[body.tool]
points = { o = ["0 mm", "0 mm", "0 mm"] }
[joint.shoulder]
kind = "revolute"
bearing = "ground.o"
journal = "upper.o"
radial_clearance = "60 um"
bearing_length = "30 mm"
[joint.elbow]
kind = "revolute"
bearing = "upper.elbow"
journal = "fore.o"
axis = "x"
bearing_across = "y"
journal_across = "y"
bearing_tilt = ["0 mrad", "0 mrad", "0 mrad"]
radial_clearance = "35 um"
bearing_length = "25 mm"
[joint.flange]
kind = "rigid"
bearing = "fore.wrist"
journal = "tool.o"
bearing_tilt = ["0 mrad", "0 mrad", "0 mrad"]
[drive.shoulder]
joint = "shoulder"
speed = "60 rpm"
start_angle = "0 deg"
[drive.elbow]
joint = "elbow"
speed = "20 rpm"
start_angle = "25 deg"
[cycle]
drive = "shoulder"
samples_per_turn = 5
[output.tool]
orientation_of = "tool"
"#;

/// Leans of both pins, rad: 2c/l.
const LEANS: [f64; 2] = [4e-3, 2.8e-3];
/// What the second order makes of an angle of [`LEANS`], rad: their products.
const SECOND_ORDER: f64 = 5e-5;
/// The same of the largest angle, whose terms of second order are along no axis of it: of third order, rad.
const THIRD_ORDER: f64 = 2e-7;

fn tilted(model: &SpatialModel, joint: &str, tilt: [f64; 3]) -> loosepin_text::numbers::Values {
    let paths = ["x", "y", "z"].map(|axis| format!("joint.{joint}.bearing_tilt.{axis}"));
    let changes: Vec<(&str, f64)> = paths.iter().map(String::as_str).zip(tilt).collect();
    with(model, &changes)
}

fn length(parts: [f64; 3]) -> f64 {
    parts.iter().map(|part| part * part).sum::<f64>().sqrt()
}

#[test]
fn analytic_leans_of_two_pins_add_up_across_both_axes() {
    let model = model(ARM);
    let record = model.motion_with_paths_until(&model.quantities.nominal(), &[], true, &|| false);
    let record = record.unwrap_or_else(|found| panic!("{found}"));
    let [output] = record.outputs.as_slice() else { panic!("one output") };
    assert!(output.value_si.is_empty());
    assert_eq!((output.words.as_str(), output.unit.clone()), ("rotation of tool", loosepin_text::units::SiUnit::ANGLE));
    let ([first, second], answer) = (LEANS, &output.clearance);
    for (worst, deviation) in answer.first_order_si.iter().zip(&answer.disc_standard_deviation_si) {
        assert_close(*worst, first + second, 1e-12);
        // Both ends anywhere in their circles: c²/4 along each direction, so that a lean has (c/l)².
        assert_close(*deviation, (0.5 * first).hypot(0.5 * second), 1e-12);
    }
    // About an axis across both pins, each lean is a rotation by atan 2c/l.
    let about = first.atan() + second.atan();
    let searched = &answer.searched[0];
    let [smallest, largest] = searched.found_si;
    assert_close(largest, about, THIRD_ORDER);
    assert_close(smallest, -about, THIRD_ORDER);
    let [_, proven] = searched.proven_si.unwrap();
    assert!(proven >= largest && proven < about + SECOND_ORDER, "{proven}");
    let parts: Vec<f64> = answer.contributors.iter().map(|own| own.first_order_si[searched.position]).collect();
    assert_close(parts[0], first, 1e-12);
    assert_close(parts[1], second, 1e-12);
}

#[test]
fn analytic_a_known_rotation_has_its_angle_and_components_whatever_its_size() {
    let model = model(ARM);
    let parts = [PartOfOutput::Magnitude, PartOfOutput::X, PartOfOutput::Y, PartOfOutput::Z].map(|own| part(0, own));
    let sampler = TurnSampler::new(&model, &model.quantities.nominal(), &[0.0, 0.3], &parts).unwrap();
    let sampler = sampler.with_play_side(PlaySide::None).unwrap();
    for tilt in [[0.0; 3], [1e-9, 0.0, -2e-9], [1e-3, -2e-3, 5e-4], [0.3, -1.1, 0.7], [0.0, 2.9, 0.0]] {
        let found = sampler.sample(&tilted(&model, "flange", tilt)).unwrap();
        for place in [0, 1] {
            assert_close(found.from_nominal_si[place], length(tilt), 1e-14);
            assert_close(found.largest_from_nominal_si[place], length(tilt), 1e-14);
            assert_eq!((found.ideal_si[place], found.largest_si[place]), (0.0, 0.0));
            for (axis, component) in tilt.into_iter().enumerate() {
                assert_close(found.from_nominal_si[2 * (axis + 1) + place], component, 1e-14);
            }
        }
    }
}

#[test]
fn analytic_play_adds_to_a_rotation_about_the_same_axis_and_takes_from_it() {
    let model = model(ARM);
    let parts = [part(0, PartOfOutput::Magnitude)];
    let sampler = TurnSampler::new(&model, &model.quantities.nominal(), &[0.0, 0.4], &parts).unwrap();
    let exact = sampler.clone().with_play_side(PlaySide::Exact).unwrap();
    let play = LEANS[0] + LEANS[1];
    let by_play = LEANS[0].atan() + LEANS[1].atan();
    // The first direction of the elbow's marker is across both pins. Less than play makes is taken back in full.
    for tilt in [0.0, 2e-3, -2e-3, 0.05, -0.4] {
        let values = tilted(&model, "elbow", [tilt, 0.0, 0.0]);
        let (first, exact) = (sampler.sample(&values).unwrap(), exact.sample(&values).unwrap());
        let size = f64::abs(tilt);
        for place in [0, 1] {
            assert_close(first.from_nominal_si[place], size, 1e-14);
            assert_close(first.largest_si[place], play, 1e-9);
            assert_close(first.largest_from_nominal_si[place], size + play, 1e-9);
            assert_close(first.smallest_from_nominal_si[place], (size - play).max(0.0), 1e-9);
            assert_close(exact.largest_si[place], by_play, THIRD_ORDER);
            assert_close(exact.largest_from_nominal_si[place], size + by_play, SECOND_ORDER * (play + size));
        }
    }
}

#[test]
fn identity_no_drawn_place_of_the_journals_rotates_more_than_the_search_found() {
    const SAMPLES: usize = 3000;
    let model = model(ARM);
    let parts = [PartOfOutput::Magnitude, PartOfOutput::X, PartOfOutput::Y, PartOfOutput::Z].map(|own| part(0, own));
    let sampler = TurnSampler::new(&model, &model.quantities.nominal(), &[0.2], &parts).unwrap();
    let exact = sampler.clone().with_play_side(PlaySide::Exact).unwrap();
    let drawn = sampler.clone().with_play_distribution(PlayDistribution::OnTheRim);
    let mut state = 11_u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    for tilt in [[0.0; 3], [0.3, -0.5, 0.2]] {
        let values = tilted(&model, "elbow", tilt);
        let (first, limits) = (sampler.sample(&values).unwrap(), exact.sample(&values).unwrap());
        assert_close(first.from_nominal_si[0], length(tilt), 1e-14);
        let [mut most, mut most_in_all] = [0.0; 2];
        for _ in 0..SAMPLES {
            let uniforms: Vec<f64> = (0..drawn.uniforms_per_sample()).map(|_| random()).collect();
            let found = drawn.sample_with_play(&values, &uniforms).unwrap();
            let components = [1, 2, 3].map(|part| found.largest_si[part]);
            // From the nominal orientation all rotations are there as they are; components from the sample's own.
            assert_close(found.largest_si[0], length(components), 1e-14);
            assert!(found.largest_from_nominal_si[0] <= found.from_nominal_si[0] + found.largest_si[0] + 1e-14);
            most = f64::max(most, found.largest_si[0]);
            most_in_all = f64::max(most_in_all, found.largest_from_nominal_si[0]);
        }
        for (most, limit) in [(most, limits.largest_si[0]), (most_in_all, limits.largest_from_nominal_si[0])] {
            assert!(most <= limit + 1e-12, "{most} {limit}");
        }
        // Near the ends, where the second order is small against what play does.
        let play = LEANS[0] + LEANS[1];
        assert!(
            most > 0.97 * play && most_in_all > length(tilt) + 0.9 * (first.largest_from_nominal_si[0] - length(tilt))
        );
        assert_close(limits.largest_from_nominal_si[0], first.largest_from_nominal_si[0], 5.0 * SECOND_ORDER);
    }
}

#[test]
fn analytic_the_mean_square_of_a_random_rotation_is_the_sum_of_those_of_its_components() {
    let model = model(ARM);
    let deviations = [2e-4, 3e-4, 6e-4];
    let paths = ["x", "y", "z"].map(|axis| format!("joint.flange.bearing_tilt.{axis}"));
    let quantities = paths.iter().zip(deviations).map(|(path, own)| (model.quantities.id(path).unwrap(), own));
    let plan = SpatialScatterPlan { quantities: quantities.collect(), ..SpatialScatterPlan::default() };
    let scatter = model.scatter_until(&plan, &|| false).unwrap_or_else(|found| panic!("{found}"));
    for place in 0..6 {
        assert_close(scatter[0].standard_deviation_si[place], 7e-4, 1e-9);
        for (own, deviation) in scatter[0].contributors.iter().zip(deviations) {
            assert_close(own.standard_deviation_si[place], deviation, 1e-9);
        }
    }
}

#[test]
fn an_orientation_has_no_direction_and_no_parts_of_a_path() {
    let refused = |line: &str| {
        let text = ARM.replace("orientation_of = \"tool\"", &format!("orientation_of = \"tool\"\n{line}"));
        SpatialModel::from_text("model.toml", &text).unwrap_err().to_string()
    };
    for (line, key) in [("along = \"x\"", "along"), ("about = \"x\"", "about")] {
        let found = refused(line);
        assert!(found.contains(key) && found.contains("orientation_of"), "{found}");
    }
    assert!(refused("turn_of = \"fore\"").contains("orientation_of"));
    let model = model(ARM);
    for own in [PartOfOutput::Number, PartOfOutput::Along, PartOfOutput::Across] {
        let error = TurnSampler::new(&model, &model.quantities.nominal(), &[0.0], &[part(0, own)]).unwrap_err();
        assert!(
            matches!(error, SamplingError::PartDoesNotFit { .. }) && error.to_string().contains("orientation_of has")
        );
    }
}

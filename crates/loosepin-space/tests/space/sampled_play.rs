//! Samples whose loops close only with play, and samples with drawn places of the journals.

use crate::sampling::{assert_close, model, part, slider_crank_with_tip, turns, with};
use loosepin_space::{
    MarkerError, MarkerSide, PartOfOutput, PlayDistribution, PlaySide, PoseAccuracy, SamplingError, SpatialModel,
    TurnSampler, Vec3, assemble,
};

/// A driven shaft in two bearings, 20 mm long with 50 µm of clearance, 150 mm apart.
const SHAFT: &str = r#"
name = "shaft"
geometry = "space"
[body.ground]
points = { a = ["0 mm", "0 mm", "0 mm"], b = ["0 mm", "0 mm", "150 mm"] }
[body.shaft]
points = { a = ["0 mm", "0 mm", "0 mm"], b = ["0 mm", "0 mm", "150 mm"], tip = ["0 mm", "0 mm", "400 mm"] }
[joint.fixed]
kind = "revolute"
bearing = "ground.a"
journal = "shaft.a"
radial_clearance = "50 um"
bearing_length = "20 mm"
axial_clearance = "0.1 mm"
[joint.loose]
kind = "cylindrical"
bearing = "ground.b"
journal = "shaft.b"
radial_clearance = "50 um"
bearing_length = "20 mm"
[drive.motor]
joint = "fixed"
speed = "60 rpm"
start_angle = "0 deg"
[cycle]
drive = "motor"
[output.tip]
path_of = "shaft.tip"
"#;

const LENGTH: f64 = 0.02;
const APART: f64 = 0.15;
const PLAY: f64 = 5e-5;
const HEIGHT: f64 = 0.4;

/// Largest and smallest a + b Z of lines y = a + b z with |y(∓l/2)| <= c and |y(D ∓ l/2) - δ| <= c, δ between the bearings' middles: of all
/// corners of the polygon of (a, b).
fn shaft_end(offset: f64) -> [f64; 2] {
    let half = 0.5 * LENGTH;
    let planes = [(-half, 0.0), (half, 0.0), (APART - half, offset), (APART + half, offset)];
    let mut ends = [f64::INFINITY, f64::NEG_INFINITY];
    let values = |(z, middle): (f64, f64)| [(z, middle - PLAY), (z, middle + PLAY)];
    for one in planes.into_iter().flat_map(values) {
        for two in planes.into_iter().flat_map(values).filter(|two| two.0 > one.0) {
            let slope = (two.1 - one.1) / (two.0 - one.0);
            let at = |z: f64| one.1 + slope * (z - one.0);
            if planes.iter().all(|(z, middle)| (at(*z) - middle).abs() <= PLAY * (1.0 + 1e-12)) {
                ends = [ends[0].min(at(HEIGHT)), ends[1].max(at(HEIGHT))];
            }
        }
    }
    ends
}

#[test]
fn analytic_a_shaft_in_bearings_that_are_not_in_line() {
    let model = model(SHAFT);
    let parts = [part(0, PartOfOutput::Y), part(0, PartOfOutput::Magnitude)];
    let sampler = TurnSampler::new(&model, &model.quantities.nominal(), &[0.0, 0.3], &parts).unwrap();
    let exact = sampler.clone().with_play_side(PlaySide::Exact).unwrap();
    for offset in [0.0, 1e-4, -3e-4, 7e-4, -7.4e-4, 7.48e-4] {
        let values = with(&model, &[("body.ground.points.b.y", offset)]);
        let [smallest, largest] = shaft_end(offset);
        let (first, exact) = (sampler.sample(&values).unwrap(), exact.sample(&values).unwrap());
        for place in [0, 1] {
            assert_close(first.largest_from_nominal_si[place], largest, 1e-9);
            assert_close(first.smallest_from_nominal_si[place], smallest, 1e-9);
            // The nominal displacement along y and across it are less than that along y.
            let longest = first.largest_from_nominal_si[2 + place];
            let along = largest.max(-smallest);
            assert!(longest >= along - 1e-9 && longest < along.hypot(3e-4), "{longest} {along}");
            // The lean is at most 2c/l = 5e-3, its square times the height is second order.
            assert_close(exact.largest_from_nominal_si[place], largest, 1e-5);
            assert_close(exact.smallest_from_nominal_si[place], smallest, 1e-5);
            assert_close(exact.largest_from_nominal_si[2 + place], longest, 1e-5);
            let own = [first.smallest_si[place], first.largest_si[place]];
            assert!(own[1] > 0.0 && own[0] < 0.0 && offset == 0.0 || (own[0] + own[1]).abs() > 1e-6, "{own:?}");
        }
    }
    // The least play is δ l/(2D): 0.8 mm needs 16/15 of it.
    for sampler in [&sampler, &exact] {
        let error = sampler.sample(&with(&model, &[("body.ground.points.b.y", 8e-4)])).unwrap_err();
        let text = error.to_string();
        let SamplingError::CannotBeAssembled { needed: Some(needed), turn, repeated, .. } = error else {
            panic!("{error}")
        };
        assert_close(needed, 16.0 / 15.0, 1e-6);
        assert_eq!(turn, 0.0);
        // Of the 5 + 4 constraints of the joints and that of the drive, a body has 6 to lose: the 4 of the second bearing repeat others.
        assert_eq!(repeated, 4);
        assert!(text.contains(": 4 constraints of the joints repeat others and contradict them, joint '"), "{text}");
    }
    // Ideal bearings do not allow even the smallest offset.
    let ideal = sampler.with_play_side(PlaySide::None).unwrap();
    let error = ideal.sample(&with(&model, &[("body.ground.points.b.y", 1e-6)])).unwrap_err();
    assert!(matches!(&error, SamplingError::CannotBeAssembled { needed: None, .. }), "{error}");
    assert!(error.to_string().contains("no play takes that up") && error.joint().is_some(), "{error}");
}

#[test]
fn analytic_exact_ends_where_the_first_order_is_zero() {
    // The end of a shaft at height Z is at Z/√(1 + w²) along its bearing, and at most c (1 + 2Z/l)/√(1 + w²) across it, w = 2c/l.
    let alone =
        SHAFT.split("[joint.loose]").next().unwrap().to_owned() + &SHAFT[SHAFT.find("[drive.motor]").unwrap()..];
    let text = alone.replace("50 um", "0.4 mm").replace("axial_clearance = \"0.1 mm\"", "axial_clearance = \"0 mm\"");
    let model = model(&text);
    let parts = [part(0, PartOfOutput::Z), part(0, PartOfOutput::X), part(0, PartOfOutput::Magnitude)];
    let first = TurnSampler::new(&model, &model.quantities.nominal(), &[0.2], &parts).unwrap();
    let exact = first.clone().with_play_side(PlaySide::Exact).unwrap();
    for (clearance, height) in [(4e-4, 0.4), (3e-4, 0.4), (4e-4, 0.5)] {
        let values = with(&model, &[("joint.fixed.radial_clearance", clearance), ("body.shaft.points.tip.z", height)]);
        let (first, exact) = (first.sample(&values).unwrap(), exact.sample(&values).unwrap());
        let slope = 2.0 * clearance / LENGTH;
        let lowest = height / (1.0 + slope * slope).sqrt() - height;
        assert_close(first.largest_si[0], 0.0, 1e-15);
        assert_close(exact.largest_si[0], 0.0, 1e-12);
        assert_close(exact.smallest_si[0], lowest, -1e-9 * lowest);
        let flat = clearance * 2.0 * height / LENGTH;
        assert_close(first.largest_si[1], flat, 1e-9 * flat);
        let across = slope * height / (1.0 + slope * slope).sqrt();
        assert!(
            exact.largest_si[1] >= across * (1.0 - 1e-9) && exact.largest_si[1] < flat,
            "{} {across}",
            exact.largest_si[1]
        );
        assert!(exact.largest_si[2] >= across.hypot(lowest) * (1.0 - 1e-9), "{}", exact.largest_si[2]);
        // What the height changes is the nominal deviation, as far as the drive is held.
        assert_close(exact.from_nominal_si[0], height - HEIGHT, 1e-15);
    }
}

/// Crank 50 mm, coupler 150 mm, rocker 120 mm, pins 160 mm apart, all about z; the pin between coupler and rocker may be tilted on the coupler.
fn four_bar(play: &str) -> SpatialModel {
    let joint = |name: &str, bearing: &str, journal: &str, axes: &str| {
        format!("[joint.{name}]\nkind = \"revolute\"\nbearing = \"{bearing}\"\njournal = \"{journal}\"\n{axes}{play}")
    };
    let tilted = "bearing_axis = \"z\"\njournal_axis = [0, 0, 1]\n";
    let joints = [
        joint("main", "ground.o", "crank.o", ""),
        joint("crankpin", "crank.pin", "coupler.a", ""),
        joint("pin", "rocker.pin", "coupler.b", tilted),
        joint("pivot", "ground.d", "rocker.o", ""),
    ];
    model(&format!(
        "name = \"four-bar\"\ngeometry = \"space\"\n[body.ground]\npoints = {{ o = [\"0 mm\", \"0 mm\", \"0 mm\"], d = [\"160 mm\", \"0 mm\", \"0 mm\"] }}\n\
         [body.crank]\npoints = {{ o = [\"0 mm\", \"0 mm\", \"0 mm\"], pin = [\"50 mm\", \"0 mm\", \"0 mm\"] }}\n\
         [body.coupler]\npoints = {{ a = [\"0 mm\", \"0 mm\", \"0 mm\"], b = [\"150 mm\", \"0 mm\", \"0 mm\"], tip = [\"75 mm\", \"30 mm\", \"20 mm\"] }}\n\
         [body.rocker]\npoints = {{ o = [\"0 mm\", \"0 mm\", \"0 mm\"], pin = [\"0 mm\", \"120 mm\", \"0 mm\"] }}\n{}\
         [assembly]\nguess = {{ rocker = {{ at = [\"160 mm\", \"0 mm\", \"0 mm\"] }} }}\n\
         [drive.crank]\njoint = \"main\"\nspeed = \"60 rpm\"\nstart_angle = \"0 deg\"\n[cycle]\ndrive = \"crank\"\n\
         [output.tip]\nposition_of = \"coupler.tip\"\nalong = \"z\"\n[output.rocker]\nturn_of = \"rocker\"\nabout = \"z\"\n",
        joints.concat()
    ))
}

#[test]
fn identity_a_planar_four_bar_with_a_tilted_pin() {
    let tilt = |model: &SpatialModel, tilt: f64| with(model, &[("joint.pin.journal_axis.x", tilt)]);
    let parts = [part(0, PartOfOutput::Number), part(1, PartOfOutput::Number)];
    let turns = turns(4);
    let ideal = four_bar("");
    let sampler = TurnSampler::new(&ideal, &ideal.quantities.nominal(), &turns, &parts).unwrap();
    let error = sampler.sample(&tilt(&ideal, 1e-3)).unwrap_err();
    assert!(matches!(&error, SamplingError::CannotBeAssembled { needed: None, .. }), "{error}");
    assert_eq!(error.turn(), Some(0.0));
    // In its plane it may have any lengths.
    let longer = with(&ideal, &[("body.coupler.points.b.x", 0.1512)]);
    assert!(sampler.sample(&longer).unwrap().from_nominal_si[turns.len()].abs() > 1e-4);

    let loose = four_bar("radial_clearance = \"20 um\"\nbearing_length = \"20 mm\"\naxial_clearance = \"50 um\"\n");
    let sampler = TurnSampler::new(&loose, &loose.quantities.nominal(), &turns, &parts).unwrap();
    let exact = sampler.clone().with_play_side(PlaySide::Exact).unwrap();
    // By the errors of the marker in the nominal position: a tilt of z by +x is a turn about y.
    let mechanism = loose.mechanism(&loose.quantities.nominal()).unwrap();
    let position = assemble(&mechanism, &loose.drive_values(&loose.quantities.nominal(), 0.0)).unwrap();
    let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
    let error = MarkerError {
        joint: 2,
        side: MarkerSide::Journal,
        displacement_m: Vec3::ZERO,
        turning_rad: accuracy.mechanism().joints()[2].journal.axes.apply_transposed(Vec3::Y),
    };
    let largest = accuracy.assembly_reserve(&[error]).unwrap().factor;
    assert!(largest > 1e-3 && largest < 1e-2, "{largest}");
    let refused = sampler.sample(&tilt(&loose, 1.2 * largest)).unwrap_err();
    let SamplingError::CannotBeAssembled { needed: Some(needed), turn: 0.0, .. } = refused else { panic!("{refused}") };
    assert_close(needed, 1.2, 2e-3);
    // With less tilt the reach is smaller than without, and both ways of counting agree but for the second order.
    let straight = sampler.nominal();
    for share in [0.2, 0.5, 0.9] {
        let values = tilt(&loose, share * largest);
        let (first, exact) = (sampler.sample(&values).unwrap(), exact.sample(&values).unwrap());
        for place in 0..first.ideal_si.len() {
            let width = |sample: &loosepin_space::TurnSample| sample.largest_si[place] - sample.smallest_si[place];
            assert!(width(&first) < width(straight) * (1.0 + 2e-3), "{} {}", width(&first), width(straight));
            for (a, b) in [
                (first.largest_from_nominal_si[place], exact.largest_from_nominal_si[place]),
                (first.smallest_from_nominal_si[place], exact.smallest_from_nominal_si[place]),
            ] {
                assert_close(a, b, 0.02 * width(straight));
            }
        }
        let first_place = width_at(&first, 0) / width_at(straight, 0);
        assert!(share < 0.9 || first_place < 0.75, "{first_place}");
    }
    let error = sampler.sample_with_play(&loose.quantities.nominal(), &[0.5; 20]).unwrap_err();
    assert!(matches!(error, SamplingError::ConditionsOnPlay { conditions: 3 }), "{error}");
}

fn width_at(sample: &loosepin_space::TurnSample, place: usize) -> f64 {
    sample.largest_si[place] - sample.smallest_si[place]
}

#[test]
fn identity_drawn_places_of_journals_are_in_their_play_and_spread_as_it_says() {
    const SAMPLES: usize = 4000;
    let model = slider_crank_with_tip();
    let nominal = model.quantities.nominal();
    let parts = [part(2, PartOfOutput::Number), part(1, PartOfOutput::Magnitude)];
    let sampler = TurnSampler::new(&model, &nominal, &[0.1, 0.4], &parts).unwrap();
    let values = with(&model, &[("parameter.rod_length", 0.3004)]);
    let limits = sampler.clone().with_play_side(PlaySide::Exact).unwrap().sample(&values).unwrap();
    let mut state = 7_u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    for (distribution, count, tolerance) in [(PlayDistribution::Inside, 8, 0.06), (PlayDistribution::OnTheRim, 5, 0.06)]
    {
        let sampler = sampler.clone().with_play_distribution(distribution);
        assert_eq!(sampler.uniforms_per_sample(), count);
        let mut squares = [0.0; 2];
        for _ in 0..SAMPLES {
            let uniforms: Vec<f64> = (0..count).map(|_| random()).collect();
            let found = sampler.sample_with_play(&values, &uniforms).unwrap();
            assert_eq!(found.largest_si, found.smallest_si);
            for k in 0..4 {
                let slack = 1e-9 * limits.largest_si[k];
                assert!(found.largest_si[k] <= limits.largest_si[k] + slack);
                assert!(found.smallest_si[k] >= limits.smallest_si[k] - slack);
                assert!(found.largest_from_nominal_si[k] <= limits.largest_from_nominal_si[k] + slack);
            }
            for (place, square) in squares.iter_mut().enumerate() {
                *square += found.largest_si[place] * found.largest_si[place] / SAMPLES as f64;
            }
        }
        let mechanism = model.mechanism(&values).unwrap();
        for (turn, square) in [0.1, 0.4].into_iter().zip(squares) {
            let drives = model.drive_values(&values, turn);
            let position = assemble(&mechanism, &drives).unwrap();
            let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
            let gains = accuracy.gains(&model.outputs_of(2, &values).unwrap()[0]).unwrap();
            let expected = accuracy.standard_deviation(&gains, distribution).unwrap();
            assert_close(square.sqrt(), expected, tolerance * expected);
        }
    }
}

#[test]
fn a_motion_that_does_not_close_says_how_much_play_it_would_take() {
    let model = model(SHAFT);
    // The least play is δ l/(2D): 0.8 mm needs 16/15 of it, 0.6 mm 4/5.
    let hint = |offset_m: f64| {
        let found = model.motion_record(&with(&model, &[("body.ground.points.b.y", offset_m)])).unwrap_err();
        found.to_string()
    };
    let found = hint(8e-4);
    assert!(found.contains("all joints close: as near as the search came, joint '"), "{found}");
    assert!(found.contains("the parts do not fit: 1.067 times all plays would be needed at motor = "), "{found}");
    let found = hint(6e-4);
    assert!(found.contains("the parts fit by their play: 0.8 of all plays is needed at motor = "), "{found}");
}

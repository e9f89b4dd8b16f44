//! Samples of a model over its turn, against closed forms and against accuracies pose by pose.

use crate::build::v;
use crate::known::{COUPLER, rssr_angle};
use loosepin_space::{
    DriveValue, PartOfOutput, PathFrame, PlaySide, PointOutput, PoseAccuracy, SampledPart, SamplingError,
    SearchOptions, SpatialModel, SpatialOutput, TurnSampler, Vec3, cycle, motion,
};
use loosepin_text::numbers::Values;
use std::f64::consts::TAU;

pub const RSSR: &str = include_str!("../../../../docs/examples/rssr-four-bar.toml");
pub const SLIDER_CRANK: &str = include_str!("../../../../docs/examples/spatial-slider-crank.toml");
/// A point of the rod off its axis: a place in space.
const TIP: &str = "\n[output.tip]\npath_of = \"rod.tip\"\n[output.height]\nposition_of = \"rod.tip\"\nalong = \"z\"\n";

pub fn model(text: &str) -> SpatialModel {
    SpatialModel::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

/// The slider-crank of the file whose rod has a point off its axis and a cross instead of a ball at the crank, so that it does not spin.
pub fn slider_crank_with_tip() -> SpatialModel {
    let text = SLIDER_CRANK
        .replace("slider = [\"rod_length\"", "tip = [\"100 mm\", \"40 mm\", \"30 mm\"], slider = [\"rod_length\"")
        .replace("kind = \"spherical\"\nbearing = \"crank.pin\"", "kind = \"universal\"\nbearing = \"crank.pin\"")
        .replace("journal = \"rod.crank\"", "journal = \"rod.crank\"\nbearing_pin = \"z\"\njournal_pin = \"y\"");
    let ball = "bearing = \"rod.slider\"\njournal = \"slider.pin\"";
    model(&(text.replace(ball, &format!("{ball}\nradial_clearance = \"0.15 mm\"")) + TIP))
}

/// The values with some numbers of the file replaced.
pub fn with(model: &SpatialModel, changes: &[(&str, f64)]) -> Values {
    let id = |path: &str| model.quantities.id(path).unwrap_or_else(|| panic!("{path}"));
    let set: Vec<_> = changes.iter().map(|(path, value)| (id(path), *value)).collect();
    model.quantities.evaluate(&set).unwrap()
}

pub fn turns(count: usize) -> Vec<f64> {
    (0..count).map(|k| k as f64 / count as f64).collect()
}

pub fn part(output: usize, part: PartOfOutput) -> SampledPart {
    SampledPart { output, part }
}

#[track_caller]
pub fn assert_close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found} {expected}");
}

#[test]
fn analytic_a_four_bar_with_balls_is_one_with_another_coupler() {
    let model = model(RSSR);
    let nominal = model.quantities.nominal();
    let turns = turns(12);
    let sampler = TurnSampler::new(&model, &nominal, &turns, &[part(0, PartOfOutput::Number)]).unwrap();
    let exact = sampler.clone().with_play_side(PlaySide::Exact).unwrap();
    for (change, clearance) in [(0.0, 2e-4), (1e-4, 1e-4), (-3e-3, 5e-4)] {
        let length = COUPLER + change;
        let changes = [("body.coupler.points.rocker.x", length), ("joint.ball.radial_clearance", clearance)];
        let values = with(&model, &changes);
        let (first, found) = (sampler.sample(&values).unwrap(), exact.sample(&values).unwrap());
        for (place, turn) in turns.iter().enumerate() {
            let psi = |length: f64| rssr_angle(TAU * turn, length);
            let by_length = psi(length) - psi(COUPLER);
            assert_close(found.from_nominal_si[place], by_length, 1e-12);
            assert_close(found.ideal_si[place], psi(length) - psi_at_start(), 1e-12);
            let (plus, minus) = (psi(length + clearance) - psi(length), psi(length - clearance) - psi(length));
            let (largest, smallest) = if plus > minus { (plus, minus) } else { (minus, plus) };
            assert_close(found.largest_si[place], largest, 1e-12);
            assert_close(found.smallest_si[place], smallest, 1e-12);
            assert_close(found.largest_from_nominal_si[place], largest + by_length, 1e-12);
            assert_close(found.smallest_from_nominal_si[place], smallest + by_length, 1e-12);
            // First order: a central difference over a small change.
            let step = 1e-5;
            let slope = clearance * (psi(length + step) - psi(length - step)).abs() / (2.0 * step);
            assert_close(first.largest_si[place], slope, 1e-6 * slope);
            assert_close(first.smallest_si[place], -slope, 1e-6 * slope);
        }
    }
}

fn psi_at_start() -> f64 {
    rssr_angle(0.0, COUPLER)
}

/// Place of the slider, √(L² - B_y² - B_z²), for a crank of radius r at (0, y, z).
fn slider(turn: f64, crank: f64, rod: f64, y: f64) -> f64 {
    let angle = TAU * turn;
    let (y, z) = (y - crank * angle.sin(), 0.12 + crank * angle.cos());
    (rod * rod - y * y - z * z).sqrt()
}

#[test]
fn analytic_a_slider_crank_with_other_sizes_near_and_far() {
    let model = model(SLIDER_CRANK);
    let turns = turns(9);
    let parts = [part(0, PartOfOutput::Number)];
    let sampler = TurnSampler::new(&model, &model.quantities.nominal(), &turns, &parts).unwrap();
    assert_eq!((sampler.places(), sampler.parts().len()), (9, 1));
    for (crank, rod, y) in [(0.08, 0.3, 0.1), (0.0801, 0.2997, 0.1002), (0.07, 0.32, 0.11), (0.05, 0.5, 0.02)] {
        let changes =
            [("parameter.crank_radius", crank), ("parameter.rod_length", rod), ("body.ground.points.bearing.y", y)];
        let found = sampler.sample(&with(&model, &changes)).unwrap();
        for (place, turn) in turns.iter().enumerate() {
            let expected = slider(*turn, crank, rod, y);
            assert_close(found.ideal_si[place], expected, 1e-13);
            assert_close(found.from_nominal_si[place], expected - slider(*turn, 0.08, 0.3, 0.1), 1e-13);
        }
    }
    let speed = with(&model, &[("drive.crank.speed", 17.0)]);
    let (found, nominal) = (sampler.sample(&speed).unwrap(), sampler.nominal());
    assert!(found.ideal_si.iter().zip(&nominal.ideal_si).all(|(a, b)| (a - b).abs() < 1e-14));
}

/// Accuracies of the sample's own motion, pose by pose.
fn by_pose(model: &SpatialModel, values: &Values, turns: &[f64], read: &mut dyn FnMut(usize, &PoseAccuracy)) {
    let mechanism = model.mechanism(values).unwrap();
    let turn_s = model.cycle_input(values).unwrap().turn_s;
    let drives = |turn: f64| -> Vec<DriveValue> { model.drive_values(values, turn * turn_s) };
    let found = cycle(&mechanism, turns, &drives);
    assert_eq!((found.stopped, found.positions.len()), (None, turns.len()));
    for (place, position) in found.positions.iter().enumerate() {
        read(place, &PoseAccuracy::new(&mechanism, position).unwrap());
    }
}

const CHANGES: [(&str, f64); 6] = [
    ("parameter.crank_radius", 0.0803),
    ("parameter.rod_length", 0.2995),
    ("body.ground.points.bearing.y", 0.1004),
    ("joint.main.radial_clearance", 1.3e-4),
    ("joint.main.axial_clearance", 1.5e-4),
    ("joint.wrist.radial_clearance", 2e-4),
];

#[test]
fn identity_samples_are_the_worst_cases_pose_by_pose() {
    let model = slider_crank_with_tip();
    let nominal = model.quantities.nominal();
    let turns = turns(8);
    let parts = [
        part(0, PartOfOutput::Number),
        part(2, PartOfOutput::Number),
        part(1, PartOfOutput::X),
        part(1, PartOfOutput::Z),
        part(1, PartOfOutput::Along),
    ];
    let sampler = TurnSampler::new(&model, &nominal, &turns, &parts).unwrap();
    let exact = sampler.clone().with_play_side(PlaySide::Exact).unwrap();
    let values = with(&model, &CHANGES);
    let (first, exact, without) = (
        sampler.sample(&values).unwrap(),
        exact.sample(&values).unwrap(),
        sampler.clone().with_play_side(PlaySide::None).unwrap().sample(&values).unwrap(),
    );
    assert!(without.largest_si.iter().chain(&without.smallest_si).all(|value| *value == 0.0));
    assert_eq!(without.largest_from_nominal_si, without.from_nominal_si);
    // The nominal path: its place and its direction.
    let mut path = Vec::new();
    by_pose(&model, &nominal, &turns, &mut |_, accuracy| {
        let [point, ..] = point_of(&model, &nominal);
        let pose = accuracy.position().poses[point.body];
        let arm = pose.orientation.rotation().apply(point.point_m);
        let rates = motion(accuracy.mechanism(), accuracy.position());
        let (v, a) = (rates.point_velocity_m_s(point.body, arm), rates.point_acceleration_m_s2(point.body, arm));
        path.push((pose.point_m(point.point_m), PathFrame::new(v, a, 1e-9).unwrap().tangent));
    });
    by_pose(&model, &values, &turns, &mut |place, accuracy| {
        let points = point_of(&model, &values);
        let (at, tangent) = path[place];
        let displacement = accuracy.position().poses[points[0].body].point_m(points[0].point_m) - at;
        let along = SpatialOutput::from(PointOutput { direction: tangent, ..points[0] });
        let slider = model.outputs_of(0, &values).unwrap()[0];
        let [x, _, z] = points.map(SpatialOutput::from);
        let outputs = [
            (slider, None),
            (z, Some(v(0.0, 0.0, 1.0))),
            (x, Some(Vec3::X)),
            (z, Some(Vec3::Z)),
            (along, Some(tangent)),
        ];
        for (number, (output, direction)) in outputs.into_iter().enumerate() {
            let k = number * turns.len() + place;
            let worst = accuracy.first_order(&accuracy.gains(&output).unwrap()).unwrap().worst;
            assert_close(first.largest_si[k], worst, 1e-9 * worst);
            assert_close(first.smallest_si[k], -worst, 1e-9 * worst);
            let found = accuracy.worst_case(&output, &SearchOptions::default()).unwrap();
            assert_close(exact.largest_si[k], found.largest.deviation, 1e-9 * worst);
            assert_close(exact.smallest_si[k], found.smallest.deviation, 1e-9 * worst);
            if let Some(direction) = direction {
                assert_close(first.from_nominal_si[k], displacement.dot(direction), 1e-13);
            }
            for sample in [&first, &exact] {
                let sums = [sample.smallest_si[k], sample.largest_si[k]].map(|own| own + sample.from_nominal_si[k]);
                assert_eq!(sums, [sample.smallest_from_nominal_si[k], sample.largest_from_nominal_si[k]]);
            }
        }
    });
}

fn point_of(model: &SpatialModel, values: &Values) -> [PointOutput; 3] {
    let outputs = model.outputs_of(1, values).unwrap();
    [0, 1, 2].map(|k| outputs[k].point().unwrap())
}

#[test]
fn brute_force_lengths_over_all_directions() {
    let model = slider_crank_with_tip();
    let nominal = model.quantities.nominal();
    let turns = turns(5);
    let parts = [part(1, PartOfOutput::Magnitude), part(1, PartOfOutput::Across), part(1, PartOfOutput::Along)];
    let sampler = TurnSampler::new(&model, &nominal, &turns, &parts).unwrap();
    let exact = sampler.clone().with_play_side(PlaySide::Exact).unwrap();
    let mut path = Vec::new();
    by_pose(&model, &nominal, &turns, &mut |_, accuracy| {
        let [point, ..] = point_of(&model, &nominal);
        let pose = accuracy.position().poses[point.body];
        let rates = motion(accuracy.mechanism(), accuracy.position());
        let velocity = rates.point_velocity_m_s(point.body, pose.orientation.rotation().apply(point.point_m));
        path.push((pose.point_m(point.point_m), velocity.normalised().unwrap()));
    });
    let mut has_both = [false; 2];
    // The sizes change little, or by more than play does.
    for factor in [1.0, 10.0] {
        let values = with(&model, &CHANGES.map(|(path, value)| (path, changed(&model, path, value, factor))));
        let (found, exact) = (sampler.sample(&values).unwrap(), exact.sample(&values).unwrap());
        by_pose(&model, &values, &turns, &mut |place, accuracy| {
            let points = point_of(&model, &values);
            let (at, tangent) = path[place];
            let moved = accuracy.position().poses[points[0].body].point_m(points[0].point_m) - at;
            let across = tangent.across().unwrap();
            let axes = [across, tangent.cross(across), tangent];
            let gains = points.map(|point| accuracy.gains(&point.into()).unwrap().by_play);
            let reach = |direction: Vec3| -> f64 {
                let n = direction.to_array();
                let along: Vec<f64> =
                    (0..gains[0].len()).map(|k| (0..3).map(|axis| n[axis] * gains[axis][k]).sum()).collect();
                let blocks = accuracy.play_set().blocks().iter();
                blocks.map(|block| block.radius * along[block.range()].iter().map(|g| g * g).sum::<f64>().sqrt()).sum()
            };
            let (mut all, mut flat) = ([0.0_f64; 3], [0.0_f64; 3]);
            const STEPS: usize = 180;
            for k in 0..2 * STEPS {
                let (sine, cosine) = (TAU * k as f64 / (2 * STEPS) as f64).sin_cos();
                for j in 0..=STEPS {
                    let (low, high) = (TAU * j as f64 / (2 * STEPS) as f64).sin_cos();
                    let n = (axes[0] * cosine + axes[1] * sine) * low + axes[2] * high;
                    let values = [reach(n), reach(n) + n.dot(moved), n.dot(moved) - reach(n)];
                    let targets = if 2 * j == STEPS { [Some(&mut flat), None] } else { [None, None] };
                    for own in targets.into_iter().flatten().chain([&mut all]) {
                        own.iter_mut().zip(values).for_each(|(largest, value)| *largest = largest.max(value));
                    }
                }
            }
            for (number, (brute, length)) in
                [(all, moved.length()), (flat, (moved - tangent * moved.dot(tangent)).length())].into_iter().enumerate()
            {
                let k = number * turns.len() + place;
                // A grid of one degree misses a share of 1e-4 at most, and finds no more.
                for (found, brute) in [(found.largest_si[k], brute[0]), (found.largest_from_nominal_si[k], brute[1])] {
                    assert!(found >= brute * (1.0 - 1e-12) && found <= brute * (1.0 + 2e-4), "{found} {brute}");
                }
                // Both are lower bounds of the smallest length.
                let smallest = found.smallest_from_nominal_si[k];
                assert!(
                    smallest >= brute[2] - 1e-12 && smallest <= brute[2] + 2e-4 * brute[1],
                    "{smallest} {}",
                    brute[2]
                );
                has_both[usize::from(smallest > 0.0)] = true;
                assert_eq!(exact.smallest_from_nominal_si[k], smallest);
                assert_close(found.from_nominal_si[k], length, 1e-12);
                for (exact, first) in [
                    (exact.largest_si[k], found.largest_si[k]),
                    (exact.largest_from_nominal_si[k], found.largest_from_nominal_si[k]),
                ] {
                    assert!((exact / first - 1.0).abs() < 0.03, "{exact} {first}");
                }
            }
        });
    }
    assert_eq!(has_both, [true; 2]);
}

#[test]
fn analytic_along_a_path_that_turns_back_or_does_not_move() {
    // The slider is nearest where y² + z² is largest: (y, z) of the bearing and the crank in line. It leaves that place along +x, the farthest one
    // along -x. In between, its velocity has the sign of x'.
    let text =
        SLIDER_CRANK.to_owned() + "[output.slide]\npath_of = \"slider.pin\"\n[output.axis]\npath_of = \"crank.o\"\n";
    let model = model(&text);
    let nominal = model.quantities.nominal();
    let nearest = 1.0 + (-0.1_f64).atan2(0.12) / TAU;
    let turns = [nearest - 0.6, nearest - 0.5, nearest - 0.1, nearest, nearest + 0.1];
    let signs = [1.0, -1.0, -1.0, 1.0, 1.0];
    let parts = [part(1, PartOfOutput::Along), part(1, PartOfOutput::Across), part(1, PartOfOutput::X)];
    let sampler = TurnSampler::new(&model, &nominal, &turns, &parts).unwrap();
    let found = sampler.sample(&with(&model, &[("parameter.rod_length", 0.3005)])).unwrap();
    for (place, (turn, sign)) in turns.into_iter().zip(signs).enumerate() {
        let moved = slider(turn, 0.08, 0.3005, 0.1) - slider(turn, 0.08, 0.3, 0.1);
        assert_close(found.from_nominal_si[place], sign * moved, 1e-13);
        assert_close(found.from_nominal_si[turns.len() + place], 0.0, 1e-13);
        assert_close(found.largest_si[place], found.largest_si[2 * turns.len() + place], 1e-13);
    }
    let along = |own| TurnSampler::new(&model, &nominal, &turns, &[part(2, own)]);
    let error = along(PartOfOutput::Along).unwrap_err();
    assert_eq!(error, SamplingError::AtRest { output: "axis".to_owned(), turn: turns[0] });
    // A lean turns the crank about its bearing's middle: the offset is all.
    let found = along(PartOfOutput::Magnitude).unwrap();
    assert_close(found.nominal().largest_si[0], 2e-4_f64.hypot(1e-4), 1e-12);
}

#[test]
fn one_sampler_serves_many_threads() {
    let model = model(RSSR);
    let nominal = model.quantities.nominal();
    let sampler = TurnSampler::new(&model, &nominal, &turns(6), &[part(0, PartOfOutput::Number)]).unwrap();
    let values: Vec<Values> =
        (0..8).map(|k| with(&model, &[("body.coupler.points.rocker.x", 0.25 + 1e-5 * f64::from(k))])).collect();
    let alone: Vec<_> = values.iter().map(|values| sampler.sample(values).unwrap()).collect();
    let together: Vec<_> = std::thread::scope(|scope| {
        let runs: Vec<_> = values.iter().map(|values| scope.spawn(|| sampler.sample(values).unwrap())).collect();
        runs.into_iter().map(|run| run.join().unwrap()).collect()
    });
    assert_eq!(alone, together);
    assert_eq!(&alone[0], sampler.nominal());
}

/// Sizes changed by more; clearances are what they were.
fn changed(model: &SpatialModel, path: &str, value: f64, factor: f64) -> f64 {
    let nominal = model.quantities.nominal_value(model.quantities.id(path).unwrap());
    if path.contains("clearance") { value } else { nominal + factor * (value - nominal) }
}

#[test]
fn what_cannot_be_sampled_is_said() {
    let model = slider_crank_with_tip();
    let nominal = model.quantities.nominal();
    let number = [part(0, PartOfOutput::Number)];
    let new = |turns: &[f64], parts: &[SampledPart]| TurnSampler::new(&model, &nominal, turns, parts).unwrap_err();
    for turns in [&[][..], &[0.5, 0.2], &[f64::NAN]] {
        assert_eq!(new(turns, &number), SamplingError::BadTurns);
    }
    assert_eq!(new(&[0.0], &[part(7, PartOfOutput::X)]), SamplingError::NoOutput { output: 7, outputs: 3 });
    for (output, own) in [(0, PartOfOutput::Along), (1, PartOfOutput::Number)] {
        let error = new(&[0.0], &[part(output, own)]);
        assert!(matches!(error, SamplingError::PartDoesNotFit { .. }) && error.to_string().contains("path_of has"));
    }
    let sampler = TurnSampler::new(&model, &nominal, &turns(6), &number).unwrap();
    let error = sampler.sample(&with(&model, &[("drive.crank.start_angle", 0.1)])).unwrap_err();
    assert!(error.to_string().starts_with("drive 'crank' at 0 turns: it is at 5.729578 deg"), "{error}");
    // Backwards is another motion, but for the place at time zero.
    let error = sampler.sample(&with(&model, &[("drive.crank.speed", -1.0)])).unwrap_err();
    assert_eq!(error.turn(), Some(1.0 / 6.0));
    // Too short for the place where the crank is down and away: from there the rod cannot reach the slider.
    let error = sampler.sample(&with(&model, &[("parameter.rod_length", 0.23)])).unwrap_err();
    assert!(matches!(error, SamplingError::DoesNotClose { .. }) && error.joint().is_some(), "{error}");
    let error = sampler.sample(&with(&model, &[("parameter.crank_radius", 1e3)])).unwrap_err();
    assert!(matches!(error, SamplingError::DoesNotClose { .. }), "{error}");
    for uniforms in [vec![0.5; 3], vec![1.1; 8], vec![f64::NAN; 8]] {
        let error = sampler.sample_with_play(&nominal, &uniforms).unwrap_err();
        assert!(matches!(error, SamplingError::BadUniforms { expected: 8, .. }), "{error}");
    }
}

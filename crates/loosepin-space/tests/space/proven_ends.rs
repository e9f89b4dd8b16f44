//! Proven ends: never below what is exact, found or drawn at random, and close to it.

use crate::build::{Build, turn, turning, v};
use crate::known;
use crate::random::Random;
use crate::random_mechanisms::drawn;
use loosepin_space::{
    DriveValue, JointCoordinate, JointOutput, PoseAccuracy, ProvenEnds, RevolutePlay, RotationSineOutput,
    SearchOptions, SpatialMechanism, SpatialOutput, SphericalPlay, Vec3, assemble, cycle,
};

/// Round-off of a deviation that a search finds, relative to the worst case.
const ROUND_OFF: f64 = 1e-11;

/// The ends are outside `exact`, and by at most `share` of it.
fn assert_outside(ends: ProvenEnds, exact: [f64; 2], share: f64, what: &str) {
    let size = exact[0].abs().max(exact[1].abs());
    let above = [(ends.largest - exact[0]) / size, (exact[1] - ends.smallest) / size];
    for above in above {
        assert!((-ROUND_OFF..share).contains(&above), "{what}: {ends:?} {exact:?}, {above:e}");
    }
}

fn along_the_slide(mechanism: &SpatialMechanism) -> SpatialOutput {
    let joint = mechanism.joints().len() - 1;
    JointOutput { joint, coordinate: JointCoordinate::Slide }.into()
}

#[test]
fn analytic_a_ball_with_play_is_a_coupler_of_another_length() {
    // s = √((L ± c)² - B_y² - B_z²)
    let clearance = 3e-4;
    let mechanism = known::rssp(None, Some(SphericalPlay { radial_clearance_m: clearance }.into()));
    let found = cycle(&mechanism, &turn(24), &turning);
    for position in &found.positions {
        let accuracy = PoseAccuracy::new(&mechanism, position).unwrap();
        let place = |length: f64| known::rssp_slider(position.input, length);
        let exact = [clearance, -clearance].map(|play| place(0.3 + play) - place(0.3));
        for output in [SpatialOutput::displacement(3, v(0.2, 0.0, 0.0))[0], along_the_slide(&mechanism)] {
            let ends = accuracy.proven_end(&output).unwrap();
            assert_outside(ends, exact, 1e-4, "RSSP");
        }
    }
    // ψ(L ± c)
    let clearance = 2e-4;
    let mechanism = known::rssr(Some(SphericalPlay { radial_clearance_m: clearance }.into()));
    let found = cycle(&mechanism, &turn(24), &turning);
    for position in &found.positions {
        let accuracy = PoseAccuracy::new(&mechanism, position).unwrap();
        let angle = |length: f64| known::rssr_angle(position.input, length);
        let exact = [clearance, -clearance].map(|play| angle(known::COUPLER + play) - angle(known::COUPLER));
        let [larger, smaller] = [exact[0].max(exact[1]), exact[0].min(exact[1])];
        let output = JointOutput { joint: 3, coordinate: JointCoordinate::Angle }.into();
        let ends = accuracy.proven_end(&output).unwrap();
        assert_outside(ends, [larger, smaller], 1e-3, "RSSR");
        let axis = accuracy.position().poses[3].orientation.rotation().apply_transposed(v(0.6, 0.8, 0.0));
        let turned = loosepin_space::RotationOutput { body: 3, axis }.into();
        assert_outside(accuracy.proven_end(&turned).unwrap(), [larger, smaller], 1e-3, "RSSR, rotation vector");
    }
}

#[test]
fn peer_ends_of_the_spherical_platform() {
    let mechanism = known::platform();
    let position = assemble(&mechanism, &[DriveValue::default(); 3]).unwrap();
    let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
    // Independent program.
    let rows = [
        [0.00154467592577, 0.001545575671],
        [0.00148466485988, 0.00148405041789],
        [0.00116257605667, 0.00116548259219],
        [0.0088085556165, 0.0087156532712],
        [0.00845650583574, 0.00841649237986],
        [0.00662108037524, 0.00660024386618],
    ];
    let sines = Vec3::AXES.map(|axis| SpatialOutput::from(RotationSineOutput { body: 7, axis }));
    let outputs = SpatialOutput::displacement(7, Vec3::ZERO).into_iter().chain(sines);
    for (output, [plus, minus]) in outputs.zip(rows) {
        let ends = accuracy.proven_end(&output).unwrap();
        assert_outside(ends, [plus, -minus], 5e-3, "platform");
    }
}

#[test]
fn peer_ends_of_a_crank_bearing_that_leans() {
    let play = RevolutePlay { bearing_length_m: 0.02, radial_clearance_m: 1e-4, axial_clearance_m: 2e-4 };
    let mechanism = known::rssp(Some(play.into()), None);
    let position = assemble(&mechanism, &turning(0.0)).unwrap();
    let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
    let output = SpatialOutput::displacement(3, v(0.2, 0.0, 0.0))[0];
    let ends = accuracy.proven_end(&output).unwrap();
    assert_outside(ends, [1007.50216977e-6, -995.623347743e-6], 1e-3, "crank bearing");
}

/// A place of all journals, m, most of them on a border.
fn drawn_place(accuracy: &PoseAccuracy, random: &mut Random) -> Vec<f64> {
    let mut place = Vec::new();
    for block in accuracy.play_set().blocks() {
        let own: Vec<f64> = (0..block.part.size()).map(|_| random.number()).collect();
        let length = own.iter().map(|value| value * value).sum::<f64>().sqrt().max(1e-9);
        let is_on_border = random.below(4) > 0;
        let share = if is_on_border { 1.0 } else { random.between(0.0, 1.0) };
        place.extend(own.iter().map(|value| value * block.radius * share / length));
    }
    place
}

#[test]
fn identity_no_place_that_is_found_or_drawn_is_outside_the_ends() {
    let count = std::env::var("COUNT").ok().and_then(|text| text.parse().ok()).unwrap_or(70);
    let seed = std::env::var("SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(2027);
    let mut random = Random(seed);
    let (mut gaps, mut none, mut closest) = (Vec::new(), 0, 0.0_f64);
    let mut class = 0;
    while gaps.len() + 2 * none < 2 * count {
        class = (class + 1) % drawn::CLASSES.len();
        let mechanism = drawn::mechanism(class, &mut random);
        let Ok(position) = assemble(&mechanism, &vec![DriveValue::held(0.0); mechanism.drives().len()]) else {
            continue;
        };
        if position.redundant_rows() > 0 {
            continue;
        }
        let Ok(accuracy) = PoseAccuracy::new(&mechanism, &position) else { continue };
        let output = drawn::output(&mut random, &mechanism);
        let Ok(gains) = accuracy.gains(&output) else { continue };
        let first = accuracy.first_order(&gains).unwrap().worst;
        if first < 1e-7 {
            continue;
        }
        let name = drawn::CLASSES[class].0;
        let Some(ends) = accuracy.proven_end(&output) else {
            println!("{name}: none, singular ratio {:.1e}, first order {first:.2e}", position.singular_ratio);
            none += 1;
            continue;
        };
        let worst =
            accuracy.worst_case(&output, &SearchOptions { random_starts: 2, ..SearchOptions::default() }).unwrap();
        let (largest, smallest) = (worst.largest.deviation, worst.smallest.deviation);
        let size = largest.max(-smallest);
        let gap = [(ends.largest - largest) / size, (smallest - ends.smallest) / size];
        println!(
            "{name}: singular ratio {:.1e}, gaps {:.1e} {:.1e}, first order {first:.2e}, to exact {:.1e}",
            position.singular_ratio,
            gap[0],
            gap[1],
            largest / first - 1.0
        );
        assert!(gap.iter().all(|gap| *gap >= -ROUND_OFF), "{name}: {ends:?} {largest} {smallest}");
        gaps.extend(gap);
        for _ in 0..2000 {
            let Ok(displaced) = accuracy.displaced(&drawn_place(&accuracy, &mut random)) else {
                panic!("{name}: a place does not close, though that is proven")
            };
            let deviation = accuracy.deviation(&output, &displaced.poses).unwrap();
            assert!(deviation <= ends.largest + ROUND_OFF * size && deviation >= ends.smallest - ROUND_OFF * size);
            closest = closest.max((deviation / ends.largest).max(deviation / ends.smallest));
        }
    }
    gaps.sort_by(f64::total_cmp);
    let (median, worst) = (gaps[gaps.len() / 2], gaps[gaps.len() - 1]);
    println!(
        "{count} mechanisms, {none} without ends; gaps: median {median:.2e}, worst {worst:.2e}; drawn up to {closest:.3} of the end"
    );
    // Without ends are those whose bodies turn by more than about 0.05 rad within the play.
    assert!(none * 5 <= 2 * count && median < 1e-3 && closest > 0.9, "{none} {median} {worst} {closest}");
}

/// A slider-crank with a rod that is hardly longer than the crank: at 90 degrees the other assembly is close.
fn near_a_change_point(rod: f64, clearance: f64) -> SpatialMechanism {
    let (crank, slider) = (0.05_f64, v(0.05 + rod, 0.0, 0.0));
    Build::new(3)
        .joint("revolute", [0, 1], Vec3::ZERO, Vec3::Z, Vec3::X)
        .driven()
        .ball([1, 2], v(crank, 0.0, 0.0))
        .ball([2, 3], slider)
        .play(SphericalPlay { radial_clearance_m: clearance })
        .joint("prismatic", [0, 3], slider, Vec3::X, Vec3::Y)
        .mechanism()
}

#[test]
fn analytic_near_a_change_point_nothing_is_proven() {
    // s = r cos θ + √((l ± c)² - r² sin² θ): at 90° no position is left where l - c < r.
    let (crank, quarter) = (0.05, std::f64::consts::FRAC_PI_2);
    for (rod, clearance, is_proven) in [
        (0.0505, 1e-5, true),
        (0.0505, 6e-4, false),
        (0.05001, 9e-6, false),
        (0.05001, 1.1e-5, false),
        (0.08, 1e-4, true),
    ] {
        let mechanism = near_a_change_point(rod, clearance);
        let found = cycle(&mechanism, &[0.0, 0.5 * quarter, quarter], &turning);
        let accuracy = PoseAccuracy::new(&mechanism, found.positions.last().unwrap()).unwrap();
        let output = SpatialOutput::displacement(3, v(crank + rod, 0.0, 0.0))[0];
        let ends = accuracy.proven_end(&output);
        assert_eq!(ends.is_some(), is_proven, "{rod} {clearance} {ends:?}");
        if let Some(ends) = ends {
            let place = |length: f64| (length * length - crank * crank).sqrt();
            let exact = [clearance, -clearance].map(|play| place(rod + play) - place(rod));
            assert_outside(ends, exact, 2e-2, "near a change point");
        }
    }
}

#[test]
fn nothing_is_proven_with_redundant_rows_or_for_outputs_without_a_value() {
    let play = RevolutePlay { bearing_length_m: 0.02, radial_clearance_m: 2e-4, axial_clearance_m: 1e-4 };
    let mechanism = known::leaning_slider_crank(Some(play.into()));
    let position = assemble(&mechanism, &turning(0.3)).unwrap();
    let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
    assert_eq!(accuracy.proven_end(&SpatialOutput::displacement(3, Vec3::ZERO)[0]), None);
    // A point beside the axis of a coupler that spins between its balls.
    let mechanism = known::rssr(Some(SphericalPlay { radial_clearance_m: 2e-4 }.into()));
    let position = assemble(&mechanism, &turning(0.3)).unwrap();
    let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
    assert_eq!(accuracy.proven_end(&SpatialOutput::displacement(2, v(0.5, 0.5, 0.5))[0]), None);
    assert_eq!(accuracy.proven_end(&SpatialOutput::displacement(9, Vec3::ZERO)[0]), None);
}

#[test]
fn identity_without_play_the_ends_are_the_ideal_position() {
    let mechanism = known::rssp(None, None);
    let position = assemble(&mechanism, &turning(0.7)).unwrap();
    let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
    let ends = accuracy.proven_end(&SpatialOutput::displacement(3, v(0.2, 0.0, 0.0))[0]).unwrap();
    assert!(ends.smallest <= 0.0 && 0.0 <= ends.largest && ends.largest - ends.smallest < 1e-11, "{ends:?}");
}

/// Times and gaps of three templates, position by position:
/// `cargo test --release -p loosepin-space --test space -- --ignored --nocapture campaign_of_templates`.
#[test]
#[ignore = "prints the figures of a campaign"]
fn campaign_of_templates() {
    use loosepin_space::SpatialModel;
    for (name, text) in [
        ("six-axis arm", include_str!("../../../loosepin-import/templates/six-axis-arm/model.toml")),
        ("spherical platform", include_str!("../../../loosepin-import/templates/spherical-platform/model.toml")),
        ("suspension corner", include_str!("../../../loosepin-import/templates/suspension-corner/model.toml")),
    ] {
        let model = SpatialModel::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        let values = model.quantities.nominal();
        let mechanism = model.mechanism(&values).unwrap();
        let positions = model.positions_until(&mechanism, &values, &|| false).unwrap();
        let (mut seconds, mut proven, mut asked, mut gaps) = (0.0, 0, 0, Vec::new());
        let count = positions.len();
        let mut variables = 0;
        for position in positions.iter().step_by(count.div_ceil(12)) {
            let accuracy = PoseAccuracy::new(&mechanism, position).unwrap();
            variables = accuracy.play_set().variables();
            let outputs = (0..model.outputs.len()).flat_map(|number| model.outputs_of(number, &values).unwrap());
            for output in outputs {
                let started = std::time::Instant::now();
                let ends = accuracy.proven_end(&output);
                seconds += started.elapsed().as_secs_f64();
                asked += 1;
                let Some(ends) = ends else { continue };
                proven += 1;
                let worst = accuracy.worst_case(&output, &SearchOptions::default()).unwrap();
                let size = worst.largest.deviation.max(-worst.smallest.deviation);
                gaps.push((ends.largest - worst.largest.deviation) / size);
                gaps.push((worst.smallest.deviation - ends.smallest) / size);
            }
        }
        gaps.sort_by(f64::total_cmp);
        println!(
            "{name}: {count} positions, {variables} variables, proven {proven} of {asked}, {:.1} ms each, gaps {:.1e} to {:.1e}, median {:.1e}",
            1e3 * seconds / f64::from(asked),
            gaps.first().copied().unwrap_or(f64::NAN),
            gaps.last().copied().unwrap_or(f64::NAN),
            gaps.get(gaps.len() / 2).copied().unwrap_or(f64::NAN)
        );
    }
}

//! Least play with which parts that do not fit can be put together: closed forms, and a second formulation by multipliers alone.

use crate::build::{Build, turning, v};
use crate::random::Random;
use crate::random_mechanisms::drawn;
use loosepin_space::{
    CylindricalPlay, DriveValue, Joint, Marker, MarkerError, MarkerSide, PoseAccuracy, Quaternion, RevolutePlay,
    SpatialMechanism, SpatialModel, Vec3, assemble,
};

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Errors of markers, one for each side of each joint.
fn drawn_errors(random: &mut Random, joints: usize, size: f64) -> Vec<MarkerError> {
    let sides = [MarkerSide::Bearing, MarkerSide::Journal];
    let pairs = (0..joints).flat_map(|joint| sides.map(|side| (joint, side)));
    pairs
        .map(|(joint, side)| {
            let displacement_m = random.vector() * (0.1 * size);
            MarkerError { joint, side, displacement_m, turning_rad: random.vector() * size }
        })
        .collect()
}

/// The mechanism with these errors.
fn with_errors(mechanism: &SpatialMechanism, errors: &[MarkerError]) -> SpatialMechanism {
    let off = |marker: &Marker, error: &MarkerError| Marker {
        point_m: marker.point_m + marker.axes.apply(error.displacement_m),
        axes: marker.axes.compose(&Quaternion::from_rotation_vector(error.turning_rad).rotation()),
        ..*marker
    };
    let joints = mechanism.joints().iter().enumerate().map(|(number, joint)| {
        let of = |side| errors.iter().find(|error| error.joint == number && error.side == side).unwrap();
        Joint {
            bearing: off(&joint.bearing, of(MarkerSide::Bearing)),
            journal: off(&joint.journal, of(MarkerSide::Journal)),
            ..joint.clone()
        }
    });
    SpatialMechanism::new(mechanism.bodies().to_vec(), joints.collect(), mechanism.drives().to_vec()).unwrap()
}

/// Solves a symmetric positive system by Cholesky's factors.
fn solve(matrix: &[Vec<f64>], right: &[f64]) -> Vec<f64> {
    let count = right.len();
    let mut lower = vec![vec![0.0; count]; count];
    for i in 0..count {
        for j in 0..=i {
            let sum = matrix[i][j] - dot(&lower[i][..j], &lower[j][..j]);
            lower[i][j] = if i == j { sum.max(1e-300).sqrt() } else { sum / lower[j][j] };
        }
    }
    let mut x = right.to_vec();
    for i in 0..count {
        x[i] = (x[i] - dot(&lower[i][..i], &x[..i])) / lower[i][i];
    }
    for i in (0..count).rev() {
        let sum: f64 = (i + 1..count).map(|k| lower[k][i] * x[k]).sum();
        x[i] = (x[i] - sum) / lower[i][i];
    }
    x
}

/// By duality alone: s = 1/min Σ c |λ·h| over λ·h0 = 1. With λ the weighted least squares of the weights 1/√(|λ·h|² + ε²), ε → 0 (E. Weiszfeld, 1937).
/// Any λ gives a lower bound.
fn by_multipliers(accuracy: &PoseAccuracy, open: &[f64]) -> f64 {
    let blocks = accuracy.play_set().blocks();
    // Orthonormal combinations of the rows that plays reach, by Gram and Schmidt with the largest left first.
    let mut rows = accuracy.conditions_by_play();
    for block in blocks {
        rows.iter_mut().for_each(|row| row[block.range()].iter_mut().for_each(|entry| *entry *= block.radius));
    }
    let mut right: Vec<f64> = open.iter().map(|value| -value).collect();
    let mut kept: Vec<(Vec<f64>, f64)> = Vec::new();
    let reach = rows.iter().map(|row| dot(row, row).sqrt()).fold(0.0, f64::max);
    for _ in 0..rows.len() {
        let (place, size) =
            (0..rows.len()).map(|k| (k, dot(&rows[k], &rows[k]).sqrt())).max_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
        if size < 1e-9 * reach {
            break;
        }
        let unit: Vec<f64> = rows[place].iter().map(|entry| entry / size).collect();
        let own = right[place] / size;
        for (row, value) in rows.iter_mut().zip(&mut right) {
            let share = dot(row, &unit);
            row.iter_mut().zip(&unit).for_each(|(entry, part)| *entry -= share * part);
            *value -= share * own;
        }
        kept.push((unit, own));
    }
    let count = kept.len();
    let value = |lambda: &[f64], k: usize| -> f64 { (0..count).map(|i| lambda[i] * kept[i].0[k]).sum() };
    let h0: Vec<f64> = kept.iter().map(|(_, own)| *own).collect();
    let mut lambda: Vec<f64> = h0.iter().map(|own| own / dot(&h0, &h0)).collect();
    let lengths = |lambda: &[f64]| -> Vec<f64> {
        blocks.iter().map(|block| block.range().map(|k| value(lambda, k).powi(2)).sum::<f64>().sqrt()).collect()
    };
    let mut least = f64::INFINITY;
    let mut softness = lengths(&lambda).iter().sum::<f64>();
    for step in 0..4000 {
        let own = lengths(&lambda);
        least = least.min(own.iter().sum::<f64>());
        if step % 12 == 0 {
            softness *= 0.85;
        }
        let mut matrix = vec![vec![0.0; count]; count];
        for (block, length) in blocks.iter().zip(&own) {
            let weight = 1.0 / length.hypot(softness);
            for i in 0..count {
                for j in 0..count {
                    matrix[i][j] += weight * dot(&kept[i].0[block.range()], &kept[j].0[block.range()]);
                }
            }
        }
        let next = solve(&matrix, &h0);
        let share = 1.0 / dot(&next, &h0);
        lambda = next.iter().map(|entry| entry * share).collect();
    }
    1.0 / least
}

/// A mechanism with redundant rows and play in all joints that can have it.
fn overconstrained(class: &str, random: &mut Random) -> SpatialMechanism {
    let number = drawn::CLASSES.iter().position(|(own, _)| *own == class).unwrap();
    loop {
        let mechanism = drawn::mechanism(number, random);
        let is_whole = mechanism
            .joints()
            .iter()
            .all(|joint| joint.play.is_some() || ["universal", "prismatic", "spherical"].contains(&joint.kind.word()));
        let held = vec![DriveValue::held(0.0); mechanism.drives().len()];
        let position = assemble(&mechanism, &held).unwrap();
        if is_whole && position.singular_ratio > 3e-3 {
            return mechanism;
        }
    }
}

const CLASSES: [&str; 5] =
    ["Cardan shafts", "spherical four-bar", "Bennett", "planar four-bar", "shaft in several bearings"];

#[test]
fn identity_least_play_by_places_is_that_by_multipliers() {
    let mut random = Random(77);
    for round in 0..15 {
        let class = CLASSES[round % CLASSES.len()];
        let mechanism = overconstrained(class, &mut random);
        let held = vec![DriveValue::held(0.0); mechanism.drives().len()];
        let position = assemble(&mechanism, &held).unwrap();
        let ideal = PoseAccuracy::new(&mechanism, &position).unwrap();
        if ideal.conditions() == 0 {
            continue;
        }
        let errors = drawn_errors(&mut random, mechanism.joints().len(), 1e-4);
        let scaled = |factor: f64| {
            let scaled = errors.iter().map(|error| MarkerError {
                displacement_m: error.displacement_m * factor,
                turning_rad: error.turning_rad * factor,
                ..*error
            });
            with_errors(&mechanism, &scaled.collect::<Vec<_>>())
        };
        // h0 of first order, as a central difference; round-off over the step, and its square times third derivatives.
        let open = |factor: f64| {
            let off = scaled(factor);
            PoseAccuracy::new(&off, &position).unwrap().open_rows().to_vec()
        };
        let h0: Vec<f64> = open(1.0).iter().zip(&open(-1.0)).map(|(plus, minus)| 0.5 * (plus - minus)).collect();
        let by_multipliers = by_multipliers(&ideal, &h0);
        let reserve = ideal.assembly_reserve(&errors).unwrap();
        let product = by_multipliers * reserve.factor;
        assert!((product - 1.0).abs() < 2e-7, "{class}: {by_multipliers} {}, {product}", reserve.factor);
        assert!((reserve.bound / reserve.factor - 1.0).abs() < 1e-10, "{class}: {reserve:?}");
        // The exact one, with errors so small that the second order is nothing: a hundredth.
        let off = scaled(0.01);
        let found = PoseAccuracy::new(&off, &position).unwrap().least_play().unwrap();
        assert!((found.bound - found.factor).abs() < 1e-10 * found.factor, "{class}: {found:?}");
        assert!(
            (found.factor / (0.01 * by_multipliers) - 1.0).abs() < 1e-4,
            "{class}: {} {by_multipliers}",
            found.factor
        );
        assert!((found.by_joint.iter().sum::<f64>() - 1.0).abs() < 1e-9);
    }
}

#[test]
fn identity_at_the_least_play_the_loops_close_at_the_border() {
    let mut random = Random(78);
    for round in 0..15 {
        let class = CLASSES[round % CLASSES.len()];
        let mechanism = overconstrained(class, &mut random);
        let held = vec![DriveValue::held(0.0); mechanism.drives().len()];
        let position = assemble(&mechanism, &held).unwrap();
        // Of the size of the leans.
        let off = with_errors(&mechanism, &drawn_errors(&mut random, mechanism.joints().len(), 1e-3));
        let accuracy = PoseAccuracy::new(&off, &position).unwrap();
        if accuracy.conditions() == 0 {
            continue;
        }
        let found = accuracy.least_play().unwrap();
        assert!(found.factor > 1e-3 && (found.bound - found.factor).abs() < 1e-7 * found.factor, "{class}: {found:?}");
        let closed = accuracy.displaced(&found.variables_m).unwrap();
        assert!(closed.apart < 1e-9, "{class}: {:e}", closed.apart);
        let shares = accuracy.play_set().blocks().iter().map(|block| {
            let own = &found.variables_m[block.range()];
            dot(own, own).sqrt() / block.radius
        });
        let largest = shares.fold(0.0, f64::max);
        assert!((largest / found.factor - 1.0).abs() < 1e-6, "{class}: {largest} {}", found.factor);
        // Within the play, where that is enough, and by least squares.
        let by_play = accuracy.closed_by_play();
        assert_eq!(by_play.is_ok(), found.factor <= 1.0, "{class}: {}", found.factor);
        let Ok(by_play) = by_play else { continue };
        assert!(accuracy.displaced(&by_play.variables_m).unwrap().apart < 1e-9);
        let norm = |variables: &[f64]| -> f64 {
            let blocks = accuracy.play_set().blocks().iter();
            blocks.map(|block| dot(&variables[block.range()], &variables[block.range()]) / block.radius.powi(2)).sum()
        };
        assert!(norm(&by_play.variables_m) <= norm(&found.variables_m) * (1.0 + 1e-6), "{class}");
        for block in accuracy.play_set().blocks() {
            let own = &by_play.variables_m[block.range()];
            assert!(dot(own, own).sqrt() <= block.radius * (1.0 + 1e-9));
        }
    }
}

#[test]
fn analytic_a_shaft_in_two_bearings_that_are_not_in_line() {
    // Bearings of length l at 0 and D, the second off by δ: the best line is δ l/(2D) off at the inner and outer ends.
    let (length, distance, clearance, offset) = (0.02, 0.15, 5e-5, 3e-4);
    let journal = |z: f64, across: Vec3| Marker::new(1, v(0.0, 0.0, z) + across, Vec3::Z, Vec3::X).unwrap();
    let bearing = |z: f64| Marker::new(0, v(0.0, 0.0, z), Vec3::Z, Vec3::X).unwrap();
    let build = |across: Vec3| {
        Build::new(1)
            .push(loosepin_space::Revolute.into(), bearing(0.0), journal(0.0, Vec3::ZERO))
            .driven()
            .play(RevolutePlay { bearing_length_m: length, radial_clearance_m: clearance, axial_clearance_m: 1e-4 })
            .push(loosepin_space::Cylindrical.into(), bearing(distance), journal(distance, across))
            .play(CylindricalPlay { bearing_length_m: length, radial_clearance_m: clearance })
            .mechanism()
    };
    let position = assemble(&build(Vec3::ZERO), &turning(0.0)).unwrap();
    for factor in [1.0, 10.0] {
        let off = build(v(0.6, -0.8, 0.0) * (offset * factor));
        let accuracy = PoseAccuracy::new(&off, &position).unwrap();
        let expected = factor * offset * length / (2.0 * distance * clearance);
        let found = accuracy.least_play().unwrap();
        // The slope δ/D makes lengths along the shaft longer by its square.
        assert!((found.factor - expected).abs() < 1e-3 * expected, "{} {expected}", found.factor);
        assert_eq!(accuracy.closed_by_play().is_ok(), expected < 1.0);
    }
    let fits = build(Vec3::ZERO);
    let found = PoseAccuracy::new(&fits, &position).unwrap().least_play().unwrap();
    assert_eq!((found.factor, found.bound), (0.0, 0.0));
}

#[test]
fn identity_worst_cases_of_parts_that_do_not_fit_are_those_of_an_optimiser_over_poses() {
    use crate::random_mechanisms::{optimiser::maximise, poses::PoseSet};
    use loosepin_space::{AccuracyError, PointOutput, SearchOptions};
    let mut random = Random(79);
    let mut compared = 0;
    for round in 0..12 {
        let class = CLASSES[round % CLASSES.len()];
        let mechanism = overconstrained(class, &mut random);
        let held = vec![DriveValue::held(0.0); mechanism.drives().len()];
        let position = assemble(&mechanism, &held).unwrap();
        let off = with_errors(&mechanism, &drawn_errors(&mut random, mechanism.joints().len(), 4e-4));
        let accuracy = PoseAccuracy::new(&off, &position).unwrap();
        let least = accuracy.least_play().unwrap();
        if accuracy.conditions() == 0 || least.factor > 0.9 {
            continue;
        }
        let body = 1 + random.below(2);
        let output = PointOutput { body, point_m: random.vector() * 0.2, direction: random.direction() }.into();
        let exact = accuracy.worst_case(&output, &SearchOptions::default()).unwrap();
        for extreme in [&exact.largest, &exact.smallest] {
            assert!(accuracy.displaced(&extreme.variables_m).unwrap().apart < 1e-11, "{class}");
        }
        // Both count from poses of their own.
        let range = exact.largest.deviation - exact.smallest.deviation;
        let set = PoseSet::new(&off, &output);
        let mut best = |sign: f64| {
            maximise(&set, sign, 2, &mut random).iter().map(|end| end.value).fold(f64::NEG_INFINITY, f64::max)
        };
        let found = best(1.0) + best(-1.0);
        assert!((found - range).abs() < 1e-5 * range, "{class}: {found} {range}, least play {}", least.factor);
        assert!(found < range * (1.0 + 1e-6), "{class}: {found} {range}");
        let gains = accuracy.gains(&output).unwrap();
        assert_eq!(accuracy.first_order(&gains).unwrap_err(), AccuracyError::PartsDoNotFit);
        compared += 1;
    }
    assert!(compared > 4, "{compared}");
}

/// A planar four-bar whose journals lean, with errors of manufacture.
fn four_bar(lines: &str, bearing_length: Option<&str>) -> SpatialModel {
    let joint = |name: &str, bearing: &str, journal: &str| {
        let play = bearing_length.map_or(String::new(), |length| {
            format!("radial_clearance = \"0.05 mm\"\nbearing_length = \"{length}\"\naxial_clearance = \"0.1 mm\"\n")
        });
        let own = if name == "pin" { lines } else { "" };
        format!("[joint.{name}]\nkind = \"revolute\"\nbearing = \"{bearing}\"\njournal = \"{journal}\"\n{play}{own}")
    };
    let at = |x: f64, y: f64| format!("[\"{x} mm\", \"{y} mm\", \"0 mm\"]");
    let text = format!(
        "name = \"four-bar\"\ngeometry = \"space\"\n[body.ground]\npoints = {{ o = {}, d = {} }}\n[body.crank]\npoints = {{ o = {}, b = {} }}\n\
         [body.coupler]\npoints = {{ b = {}, c = {} }}\n[body.rocker]\npoints = {{ d = {}, c = {} }}\n{}{}{}{}\
         [assembly]\nguess = {{ rocker = {{ at = {}, turned = [\"z 100 deg\"] }} }}\n\
         [drive.crank]\njoint = \"main\"\nspeed = \"60 rpm\"\nstart_angle = \"30 deg\"\n[cycle]\ndrive = \"crank\"\nsamples_per_turn = 12\n",
        at(0.0, 0.0),
        at(150.0, 0.0),
        at(0.0, 0.0),
        at(40.0, 0.0),
        at(0.0, 0.0),
        at(130.0, 0.0),
        at(0.0, 0.0),
        at(90.0, 0.0),
        joint("main", "ground.o", "crank.o"),
        joint("crankpin", "crank.b", "coupler.b"),
        joint("pin", "rocker.c", "coupler.c"),
        joint("pivot", "ground.d", "rocker.d"),
        at(150.0, 0.0),
    );
    SpatialModel::from_text("model.toml", &text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

#[test]
fn a_model_says_with_how_much_play_its_parts_fit() {
    let plain = four_bar("", Some("20 mm"));
    let fits = plain.assembly_until(&plain.quantities.nominal(), &|| false).unwrap();
    assert_eq!((fits.redundant_rows, fits.least_factor, fits.is_possible()), (3, 0.0, true));
    assert_eq!(fits.sentence().unwrap(), "the parts fit: constraints that repeat others close without play");

    // A step along the axis is shared by the stops of all four joints, 0.2 mm of 4 × 0.1 mm, where bearings are too long to lean.
    let step = four_bar("bearing_shift = [\"0 mm\", \"0 mm\", \"0.2 mm\"]\n", Some("20 m"));
    let found = step.assembly_until(&step.quantities.nominal(), &|| false).unwrap();
    assert!((found.least_factor - 0.5).abs() < 3e-3, "{found:?}");
    assert_eq!(found.limits.len(), 4);
    let twice = step.quantities.id("joint.pin.bearing_shift.z").unwrap();
    let values = step.quantities.evaluate(&[(twice, 8e-4)]).unwrap();
    let found = step.assembly_until(&values, &|| false).unwrap();
    assert!((found.least_factor - 2.0).abs() < 1e-2 && !found.is_possible(), "{found:?}");
    let sentence = found.sentence().unwrap();
    assert!(
        sentence.starts_with("the parts do not fit: ") && sentence.contains("times all plays would be needed"),
        "{sentence}"
    );

    // A tilt needs most somewhere; the positions one by one say the same.
    let tilted = four_bar("bearing_tilt = [\"4 mrad\", \"0 mrad\", \"0 mrad\"]\n", Some("20 mm"));
    let values = tilted.quantities.nominal();
    let found = tilted.assembly_until(&values, &|| false).unwrap();
    let (off, aligned) = (tilted.mechanism(&values).unwrap(), tilted.aligned(&values).unwrap());
    let factors: Vec<f64> = tilted
        .positions_until(&aligned, &values, &|| false)
        .unwrap()
        .iter()
        .map(|position| PoseAccuracy::new(&off, position).unwrap().least_play().unwrap().factor)
        .collect();
    let largest = factors.iter().copied().fold(0.0, f64::max);
    assert!((found.least_factor - largest).abs() < 1e-9 && found.least_factor > 0.05, "{found:?}");
    let sentence = found.sentence().unwrap();
    assert!(sentence.starts_with("the parts fit by their play: ") && sentence.contains(" at crank = "), "{sentence}");

    // Ideal joints have no play to give.
    let ideal = four_bar("bearing_tilt = [\"4 mrad\", \"0 mrad\", \"0 mrad\"]\n", None);
    let found = ideal.assembly_until(&ideal.quantities.nominal(), &|| false).unwrap();
    assert!(found.least_factor.is_infinite() && !found.is_possible());
    assert!(found.sentence().unwrap().contains("no play helps"));
}

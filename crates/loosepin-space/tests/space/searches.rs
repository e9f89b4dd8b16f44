//! Exact worst cases against closed forms and against random searches that share nothing with the search but the positions, or not even these.

use crate::build::{Build, turning, v};
use crate::random::Random;
use loosepin_space::{
    ClosureError, CylindricalPlay, MarkerError, MarkerSide, PlayDistribution, PoseAccuracy, Quaternion, RevolutePlay,
    Row, SearchOptions, SpatialMechanism, SpatialOutput, SphericalPlay, UprightPlay, Vec3, assemble,
};

#[test]
fn identity_random_loops_go_round_or_stop_with_a_reason() {
    let mut random = Random(99);
    let (mut whole, mut locked, mut held) = (0, 0, 0);
    for _ in 0..60 {
        let mechanism = drawn_loop(&mut random);
        let found = loosepin_space::cycle(&mechanism, &crate::build::turn(60), &turning);
        for position in &found.positions {
            for joint in mechanism.joints().iter().filter(|joint| joint.kind.rows().contains(&Row::Coincident)) {
                let [bearing, journal] =
                    [joint.bearing, joint.journal].map(|marker| position.poses[marker.body].point_m(marker.point_m));
                assert!((bearing - journal).length() < 1e-12);
            }
        }
        match found.stopped {
            None => {
                whole += 1;
                let (first, last) = (&found.positions[0], &found.positions[60]);
                for (a, b) in first.poses.iter().zip(&last.poses) {
                    let point = v(0.1, 0.2, 0.3);
                    assert!((a.point_m(point) - b.point_m(point)).length() < 1e-9);
                }
            }
            Some(ClosureError::Locked { .. }) => locked += 1,
            Some(ClosureError::DriveHeld { .. }) => held += 1,
            Some(other) => panic!("{other}"),
        }
    }
    assert!(whole > 3 && locked > 20 && held > 3, "{whole} {locked} {held}");
}

/// How far a random search may be above the worst case found, relative.
const ABOVE: f64 = 1e-6;

/// A random loop whose freedoms add up to one, its first joint driven; joints that can have play have some.
pub fn drawn_loop(random: &mut Random) -> SpatialMechanism {
    // Freedoms of the joints beside the driven one add up to six.
    const KINDS: [(&str, usize); 5] =
        [("revolute", 1), ("cylindrical", 2), ("spherical", 3), ("universal", 2), ("prismatic", 1)];
    loop {
        let (mut kinds, mut sum) = (vec!["revolute"], 0);
        while sum < 6 {
            let (kind, freedoms) = KINDS[random.below(5)];
            kinds.push(kind);
            sum += freedoms;
        }
        let prismatic = kinds.iter().filter(|kind| **kind == "prismatic").count();
        if sum != 6 || kinds.len() > 6 || prismatic > 2 {
            continue;
        }
        let bodies = kinds.len() - 1;
        let mut build = Build::new(bodies);
        for (k, kind) in kinds.iter().enumerate() {
            let (pair, point) = ([k, (k + 1) % (bodies + 1)], random.vector() * 0.2);
            let (z, x) = (random.direction(), random.direction());
            let clearance = 2e-4 * (1.2 + random.number());
            if *kind == "universal" {
                // The pins are at a right angle.
                let pin = z.cross(x);
                let [first, second] =
                    [(pair[0], z), (pair[1], pin)].map(|(body, axis)| loosepin_space::Marker::along(body, point, axis));
                let kind = crate::build::kind(kind);
                build = build.push(kind, first.unwrap(), second.unwrap());
                continue;
            }
            build = build.joint(kind, pair, point, z, x);
            let length = 0.03 + 0.01 * random.number();
            build = match *kind {
                "revolute" => build.play(RevolutePlay {
                    bearing_length_m: length,
                    radial_clearance_m: clearance,
                    axial_clearance_m: 0.7 * clearance,
                }),
                "cylindrical" => {
                    build.play(CylindricalPlay { bearing_length_m: length, radial_clearance_m: clearance })
                }
                "spherical" => build.play(SphericalPlay { radial_clearance_m: clearance }),
                _ => build,
            };
            if k == 0 {
                build = build.driven();
            }
        }
        return build.mechanism();
    }
}

pub fn drawn_output(random: &mut Random, bodies: usize) -> SpatialOutput {
    let body = 1 + random.below(bodies);
    if random.below(3) == 0 {
        loosepin_space::RotationOutput { body, axis: random.direction() }.into()
    } else {
        let point_m = random.vector() * 0.2;
        loosepin_space::PointOutput { body, point_m, direction: random.direction() }.into()
    }
}

/// Puts each block back into its ball, or onto its border.
pub fn into_set(accuracy: &PoseAccuracy, variables: &mut [f64], is_border: bool) {
    for block in accuracy.play_set().blocks() {
        let own = &mut variables[block.range()];
        let length = own.iter().map(|value| value * value).sum::<f64>().sqrt();
        if (is_border || length > block.radius) && length > 0.0 {
            own.iter_mut().for_each(|value| *value *= block.radius / length);
        }
    }
}

/// Random places on the borders, and from the best of them random changes that get smaller where they do not improve.
fn random_search(accuracy: &PoseAccuracy, output: &SpatialOutput, sign: f64, random: &mut Random) -> f64 {
    let count = accuracy.play_set().variables();
    let value = |variables: &[f64]| {
        accuracy
            .displaced(variables)
            .map_or(f64::NEG_INFINITY, |at| sign * accuracy.deviation(output, &at.poses).unwrap())
    };
    let mut best = (f64::NEG_INFINITY, vec![0.0; count]);
    for _ in 0..40 {
        let mut place: Vec<f64> = (0..count).map(|_| random.number()).collect();
        into_set(accuracy, &mut place, true);
        let found = value(&place);
        if found > best.0 {
            best = (found, place);
        }
    }
    let mut size = 2e-4;
    for _ in 0..300 {
        let mut place: Vec<f64> = best.1.iter().map(|value| value + size * random.number()).collect();
        into_set(accuracy, &mut place, false);
        let found = value(&place);
        if found > best.0 {
            best = (found, place);
        } else {
            size *= 0.97;
        }
    }
    best.0
}

#[test]
fn identity_no_random_search_finds_more_in_loops_without_redundant_rows() {
    let mut random = Random(20);
    let (mut checked, mut shares) = (0, Vec::new());
    while checked < 20 {
        let mechanism = drawn_loop(&mut random);
        let Ok(position) = assemble(&mechanism, &turning(0.0)) else { continue };
        // Near a singular position play reaches a long way, and other assemblies come near.
        if position.singular_ratio < 3e-3 || position.redundant_rows() > 0 {
            continue;
        }
        let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
        assert_eq!(accuracy.conditions(), 0);
        let output = drawn_output(&mut random, mechanism.bodies().len() - 1);
        let Ok(gains) = accuracy.gains(&output) else { continue };
        let first = accuracy.first_order(&gains).unwrap();
        let exact = accuracy.worst_case(&output, &SearchOptions::default()).unwrap();
        for (sign, extreme) in [(1.0, &exact.largest), (-1.0, &exact.smallest)] {
            let found = random_search(&accuracy, &output, sign, &mut random);
            let worst = sign * extreme.deviation;
            assert!(found <= worst * (1.0 + ABOVE), "{found} above {worst}, first order {}", first.worst);
            shares.push(found / worst);
        }
        checked += 1;
    }
    shares.sort_by(f64::total_cmp);
    assert!(shares[shares.len() / 2] > 0.8, "the random searches are no test: {shares:?}");
}

/// A planar loop of revolute joints whose journals lean, each with its own height, all axes parallel.
struct LeaningFourBar {
    points: [Vec3; 4],
    plays: [RevolutePlay; 4],
}

impl LeaningFourBar {
    fn drawn(random: &mut Random) -> Self {
        let base = [v(0.0, 0.0, 0.0), v(0.02, 0.05, 0.0), v(0.16, 0.12, 0.0), v(0.15, 0.0, 0.0)];
        let points = base.map(|point| {
            let moved = random.vector() * 0.015;
            point + moved
        });
        let plays = points.map(|_| RevolutePlay {
            bearing_length_m: 0.03 + 0.01 * random.number(),
            radial_clearance_m: 1e-4 * (1.5 + random.number()),
            axial_clearance_m: 1e-4 * (1.5 + random.number()),
        });
        Self { points, plays }
    }

    fn mechanism(&self) -> SpatialMechanism {
        let mut build = Build::new(3);
        for k in 0..4 {
            build = build.joint("revolute", [k, (k + 1) % 4], self.points[k], Vec3::Z, Vec3::X).play(self.plays[k]);
            if k == 0 {
                build = build.driven();
            }
        }
        build.mechanism()
    }

    /// A journal in its bearing, both frames drawn parallel to the ground's: turn and displacement of the body behind from that before, about
    /// the joint's point.
    fn step(play: &RevolutePlay, variables: &[f64], angle: f64) -> (Quaternion, Vec3) {
        let [x1, y1, x2, y2, along] = variables.try_into().unwrap();
        let slope = [(x2 - x1) / play.bearing_length_m, (y2 - y1) / play.bearing_length_m];
        let axis = v(slope[0], slope[1], 1.0).normalised().unwrap();
        // atan2(y·x', x·x') = angle with x' across the axis.
        let x = v(angle.cos(), angle.sin(), -(slope[0] * angle.cos() + slope[1] * angle.sin())).normalised().unwrap();
        let rotation = loosepin_space::Rotation { x, y: axis.cross(x), z: axis };
        let middle = v(0.5 * (x1 + x2) + along * slope[0], 0.5 * (y1 + y2) + along * slope[1], along);
        (Quaternion::from_rotation(&rotation), middle)
    }

    /// Poses of the three bodies for plays of the first three joints and angles of the second and the third; the first is held.
    fn bodies(&self, variables: &[f64], angles: [f64; 2]) -> [(Quaternion, Vec3); 3] {
        let (mut turn, mut place) = (Quaternion::IDENTITY, Vec3::ZERO);
        let mut all = [(turn, place); 3];
        for k in 0..3 {
            let angle = if k == 0 { 0.0 } else { angles[k - 1] };
            let (own, shift) = Self::step(&self.plays[k], &variables[5 * k..5 * k + 5], angle);
            let axes = turn.rotation();
            let joint = place + axes.apply(self.points[k] + shift);
            turn = turn.compose(&own);
            place = joint - turn.rotation().apply(self.points[k]);
            all[k] = (turn, place);
        }
        all
    }

    /// How far the last journal, which is on the ground, is outside the play of its bearing on the last body: in units of the play.
    fn outside(&self, (turn, place): (Quaternion, Vec3)) -> f64 {
        let (axes, play) = (turn.rotation(), &self.plays[3]);
        let d = axes.apply_transposed(self.points[3] - place) - self.points[3];
        let b = axes.apply_transposed(Vec3::Z);
        let slope = [b.x / b.z, b.y / b.z];
        let middle = [d.x - d.z * slope[0], d.y - d.z * slope[1]];
        let half = 0.5 * play.bearing_length_m;
        let ends = [-half, half].map(|z| (middle[0] + z * slope[0]).hypot(middle[1] + z * slope[1]));
        let radial = ends.into_iter().fold(0.0, f64::max) / play.radial_clearance_m;
        radial.max(d.z.abs() / play.axial_clearance_m)
    }
}

#[test]
fn identity_no_random_search_finds_more_in_overconstrained_loops() {
    let mut random = Random(7);
    let mut shares = Vec::new();
    for _ in 0..8 {
        let four_bar = LeaningFourBar::drawn(&mut random);
        let mechanism = four_bar.mechanism();
        let position = assemble(&mechanism, &turning(0.0)).unwrap();
        let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
        assert_eq!((position.rank, position.redundant_rows(), accuracy.conditions()), (18, 3, 3));
        let body = 1 + random.below(3);
        let (point_m, direction) = (random.vector() * 0.2, random.direction());
        let output = loosepin_space::PointOutput { body, point_m, direction }.into();
        let first = accuracy.first_order(&accuracy.gains(&output).unwrap()).unwrap();
        assert!((first.reached - first.worst).abs() < 1e-10 * first.worst);
        let exact =
            accuracy.worst_case(&output, &SearchOptions { random_starts: 16, ..SearchOptions::default() }).unwrap();
        for (sign, extreme) in [(1.0, &exact.largest), (-1.0, &exact.smallest)] {
            let value = |at: &[(Quaternion, Vec3); 3]| {
                let (turn, place) = at[body - 1];
                sign * (place + turn.rotation().apply(point_m) - point_m).dot(direction)
            };
            let mut best = (0.0, vec![0.0; 15], [0.0; 2]);
            let mut size = 0.3;
            for _ in 0..60_000 {
                let mut variables = best.1.clone();
                for (k, play) in four_bar.plays[..3].iter().enumerate() {
                    let radii = [play.radial_clearance_m, play.radial_clearance_m, play.axial_clearance_m];
                    for (range, radius) in [0..2, 2..4, 4..5].into_iter().zip(radii) {
                        let own = &mut variables[5 * k..5 * k + 5][range];
                        own.iter_mut().for_each(|value| *value += size * radius * random.number());
                        let length = own.iter().map(|value| value * value).sum::<f64>().sqrt();
                        if length > radius {
                            own.iter_mut().for_each(|value| *value *= radius / length);
                        }
                    }
                }
                let angles = best.2.map(|angle| angle + size * 2e-3 * random.number());
                let at = four_bar.bodies(&variables, angles);
                let found = value(&at);
                if four_bar.outside(at[2]) <= 1.0 && found > best.0 {
                    best = (found, variables, angles);
                } else {
                    size = (size * 0.9997).max(1e-4);
                }
            }
            let worst = sign * extreme.deviation;
            assert!(best.0 <= worst * (1.0 + ABOVE), "{} above {worst}, first order {}", best.0, first.worst);
            shares.push(best.0 / worst);
        }
    }
    shares.sort_by(f64::total_cmp);
    assert!(shares[shares.len() / 2] > 0.8, "the random searches are no test: {shares:?}");
}

#[test]
fn identity_bound_and_place_of_the_first_order_meet_with_many_conditions() {
    // Each joint of a planar four-bar has a second bearing: 16 rows more, all redundant.
    let points = [Vec3::ZERO, v(0.05, 0.0, 0.01), v(0.13, 0.13, -0.01), v(0.14, 0.0, 0.0)];
    let revolute = RevolutePlay { bearing_length_m: 0.02, radial_clearance_m: 2e-5, axial_clearance_m: 1e-4 };
    let cylindrical = CylindricalPlay { bearing_length_m: 0.02, radial_clearance_m: 3e-5 };
    let mut build = Build::new(3);
    for (k, point) in points.into_iter().enumerate() {
        build = build.joint("revolute", [k, (k + 1) % 4], point, Vec3::Z, Vec3::X).play(revolute);
        if k == 0 {
            build = build.driven();
        }
    }
    for (k, point) in points.into_iter().enumerate() {
        let beside = point + v(0.0, 0.0, 0.05);
        build = build.joint("cylindrical", [k, (k + 1) % 4], beside, Vec3::Z, Vec3::X).play(cylindrical);
    }
    let mechanism = build.mechanism();
    let found = loosepin_space::cycle(&mechanism, &[0.0, 0.7], &turning);
    let accuracy = PoseAccuracy::new(&mechanism, &found.positions[1]).unwrap();
    assert_eq!(accuracy.conditions(), 19);
    for output in SpatialOutput::displacement(2, v(0.1, 0.05, 0.02)) {
        let gains = accuracy.gains(&output).unwrap();
        let first = accuracy.first_order(&gains).unwrap();
        // The place is admissible, the multipliers bound it: both are the worst case.
        assert!((first.worst - first.reached).abs() < 1e-10 * first.worst, "{} {}", first.worst, first.reached);
        // The sum with g + λ·h.
        let mut gains_with = gains.by_play.clone();
        for (multiplier, row) in first.multipliers.iter().zip(accuracy.conditions_by_play()) {
            gains_with.iter_mut().zip(row).for_each(|(gain, h)| *gain += multiplier * h);
        }
        let length = |own: &[f64]| own.iter().map(|value| value * value).sum::<f64>().sqrt();
        let blocks = accuracy.play_set().blocks().iter();
        let sum: f64 = blocks.map(|block| block.radius * length(&gains_with[block.range()])).sum();
        assert!((sum - first.worst).abs() < 1e-10 * first.worst, "{sum} {}", first.worst);
        for block in accuracy.play_set().blocks() {
            let own = &first.variables_m[block.range()];
            let length = own.iter().map(|value| value * value).sum::<f64>().sqrt();
            assert!(length <= block.radius * (1.0 + 1e-12));
        }
        assert!(first.worst < 0.95 * accuracy.unconditioned_worst(&gains));
        assert!((first.by_joint.iter().sum::<f64>() - first.worst).abs() < 1e-12 * first.worst);
        // Linear conditions are met to second order: leans of 3e-3, squared.
        assert!(accuracy.displaced(&first.variables_m).unwrap().apart < 1e-5);
        let exact = accuracy.worst_case(&output, &SearchOptions::default()).unwrap();
        for deviation in [exact.largest.deviation, -exact.smallest.deviation] {
            assert!((deviation / first.worst - 1.0).abs() < 5e-3, "{deviation} {}", first.worst);
        }
    }
}

#[test]
fn analytic_a_shaft_in_two_bearings_leans_by_their_outer_ends() {
    // Bearings of length l at z = 0 and z = D, both with clearance c: the shaft's axis is within c at -l/2 and D + l/2, so that the slope is at
    // most 2c/(D + l), and a point at z = Z moves by c (2Z - D)/(D + l) across, without the turning of the drive.
    let (length, distance, clearance, height) = (0.02, 0.15, 5e-5, 0.4);
    let mechanism = Build::new(1)
        .joint("revolute", [0, 1], Vec3::ZERO, Vec3::Z, Vec3::X)
        .driven()
        .play(RevolutePlay { bearing_length_m: length, radial_clearance_m: clearance, axial_clearance_m: 1e-4 })
        .joint("cylindrical", [0, 1], v(0.0, 0.0, distance), Vec3::Z, Vec3::X)
        .play(CylindricalPlay { bearing_length_m: length, radial_clearance_m: clearance })
        .mechanism();
    let position = assemble(&mechanism, &turning(0.0)).unwrap();
    let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
    assert_eq!((position.redundant_rows(), accuracy.conditions()), (4, 4));
    let output = SpatialOutput::displacement(1, v(0.0, 0.0, height))[0];
    let expected = clearance * (2.0 * height - distance) / (distance + length);
    let gains = accuracy.gains(&output).unwrap();
    let first = accuracy.first_order(&gains).unwrap();
    assert!((first.worst - expected).abs() < 1e-10 * expected, "{} {expected}", first.worst);
    assert!((first.reached - expected).abs() < 1e-10 * expected);
    assert_eq!(accuracy.standard_deviation(&gains, PlayDistribution::Inside), None);
    // The slope is that of a tangent, the point on the shaft: second order is w²/2 of it, and α tilts along.
    let exact = accuracy.worst_case(&output, &SearchOptions::default()).unwrap();
    let slope = 2.0 * clearance / (distance + length);
    let from_middle = height - 0.5 * distance;
    let tilted = slope * (from_middle + 1e-4);
    assert!(exact.largest.deviation > expected * (1.0 - 1e-5) && exact.largest.deviation < tilted * (1.0 + 1e-5));
}

#[test]
fn analytic_a_planar_slider_crank_whose_journals_do_not_lean() {
    // Play at the crankpin is a coupler of length L ± c: s = r cos θ + √((L ± c)² - r² sin² θ).
    let (crank, rod, clearance, angle) = (0.05_f64, 0.12_f64, 3e-4, 0.8_f64);
    let slider = v(crank + rod, 0.0, 0.0);
    let mechanism = Build::new(3)
        .joint("revolute", [0, 1], Vec3::ZERO, Vec3::Z, Vec3::X)
        .driven()
        .joint("revolute", [1, 2], v(crank, 0.0, 0.01), Vec3::Z, Vec3::X)
        .play(UprightPlay { radial_clearance_m: clearance, axial_clearance_m: 2e-4 })
        .joint("revolute", [2, 3], slider, Vec3::Z, Vec3::X)
        .joint("prismatic", [0, 3], slider, Vec3::X, Vec3::Y)
        .mechanism();
    let found = loosepin_space::cycle(&mechanism, &[0.0, angle], &turning);
    let position = found.positions.last().unwrap();
    let accuracy = PoseAccuracy::new(&mechanism, position).unwrap();
    // Of three redundant rows only the one along z is reached by this play: it holds the journal in the middle of its stops.
    assert_eq!((position.redundant_rows(), accuracy.conditions()), (3, 1));
    let output = SpatialOutput::displacement(3, slider)[0];
    let place = |length: f64| crank * angle.cos() + (length * length - (crank * angle.sin()).powi(2)).sqrt();
    let exact = accuracy.worst_case(&output, &SearchOptions::default()).unwrap();
    let [plus, minus] = [clearance, -clearance].map(|play| place(rod + play) - place(rod));
    assert!((exact.largest.deviation - plus).abs() < 1e-10 * plus, "{} {plus}", exact.largest.deviation);
    assert!((exact.smallest.deviation - minus).abs() < -1e-10 * minus);
    let gains = accuracy.gains(&output).unwrap();
    let first = accuracy.first_order(&gains).unwrap();
    let slope = clearance * rod / (rod * rod - (crank * angle.sin()).powi(2)).sqrt();
    assert!((first.worst - slope).abs() < 1e-10 * slope);
}

#[test]
fn analytic_least_play_of_a_shaft_in_two_bearings_that_are_not_in_line() {
    // Bearings of length l at 0 and D, the second off by δ: the best line has the slope δ/D and is δ l/(2D) off at the inner and outer ends.
    let (length, distance, clearance, offset) = (0.02, 0.15, 5e-5, 3e-4);
    let mechanism = Build::new(1)
        .joint("revolute", [0, 1], Vec3::ZERO, Vec3::Z, Vec3::X)
        .driven()
        .play(RevolutePlay { bearing_length_m: length, radial_clearance_m: clearance, axial_clearance_m: 1e-4 })
        .joint("cylindrical", [0, 1], v(0.0, 0.0, distance), Vec3::Z, Vec3::X)
        .play(CylindricalPlay { bearing_length_m: length, radial_clearance_m: clearance })
        .mechanism();
    let position = assemble(&mechanism, &turning(0.0)).unwrap();
    let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
    let error = |side, displacement_m, turning_rad| MarkerError { joint: 1, side, displacement_m, turning_rad };
    let across = v(0.6, -0.8, 0.0) * offset;
    let expected = clearance * 2.0 * distance / (offset * length);
    // Either marker may be off, and an offset along the axis does not matter.
    for (side, sign) in [(MarkerSide::Bearing, 1.0), (MarkerSide::Journal, -1.0)] {
        let found = accuracy.assembly_reserve(&[error(side, across * sign + v(0.0, 0.0, 0.01), Vec3::ZERO)]).unwrap();
        assert!((found.factor - expected).abs() < 1e-8 * expected, "{} {expected}", found.factor);
        assert!((found.bound - expected).abs() < 1e-8 * expected, "{} {expected}", found.bound);
    }
    // Both markers off alike leave nothing, against each other twice as much.
    let both = |sign: f64| {
        let journal = error(MarkerSide::Journal, across * sign, Vec3::ZERO);
        accuracy.assembly_reserve(&[error(MarkerSide::Bearing, across, Vec3::ZERO), journal]).unwrap().factor
    };
    assert!(both(1.0) > 1e5 && (both(-1.0) - 0.5 * expected).abs() < 1e-8 * expected);
    // A bearing that is tilted by 2c/l alone has its shaft on the border at both ends, and in the other one a lean of the same size is left.
    let tilt = 2.0 * clearance / length;
    let found = accuracy.assembly_reserve(&[error(MarkerSide::Bearing, Vec3::ZERO, v(tilt, 0.0, 0.0))]).unwrap();
    assert!(found.factor > 1.0 && (found.factor - found.bound).abs() < 1e-8 * found.bound);
    let none = accuracy.assembly_reserve(&[error(MarkerSide::Bearing, v(0.0, 0.0, 0.01), Vec3::ZERO)]).unwrap();
    assert!(none.factor > 1e5);
}

#[test]
fn identity_starts_of_a_neighbour_are_taken_and_wrong_ones_left_out() {
    let mechanism = crate::known::rssr(Some(SphericalPlay { radial_clearance_m: 2e-4 }.into()));
    let position = assemble(&mechanism, &turning(0.3)).unwrap();
    let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
    let output = SpatialOutput::displacement(3, v(0.2, 0.1, 0.1))[1];
    let whole = accuracy.worst_case(&output, &SearchOptions::default()).unwrap();
    assert_eq!((whole.starts, whole.agreeing), (12, [12, 12]));
    let starts_m = vec![vec![3e-4, 0.0, 0.0], vec![0.0; 2], vec![f64::NAN; 3]];
    let options = SearchOptions { random_starts: 0, starts_m, ..SearchOptions::default() };
    let again = accuracy.worst_case(&output, &options).unwrap();
    assert!((again.largest.deviation - whole.largest.deviation).abs() < 1e-14);
}

#[test]
fn analytic_an_extreme_inside_the_play() {
    // The end of a shaft at height Z is at Z/√(1 + w²) along the bearing: highest where the shaft does not lean, wherever it is, and lowest with
    // w = 2c/l.
    let (length, clearance, height) = (0.02, 4e-4, 0.5);
    let mechanism = Build::new(1)
        .joint("revolute", [0, 1], Vec3::ZERO, Vec3::Z, Vec3::X)
        .driven()
        .play(RevolutePlay { bearing_length_m: length, radial_clearance_m: clearance, axial_clearance_m: 0.0 })
        .mechanism();
    let position = assemble(&mechanism, &turning(0.3)).unwrap();
    let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
    let output = SpatialOutput::displacement(1, v(0.0, 0.0, height))[2];
    let exact = accuracy.worst_case(&output, &SearchOptions::default()).unwrap();
    let slope = 2.0 * clearance / length;
    let lowest = height / (1.0 + slope * slope).sqrt() - height;
    assert!(exact.largest.deviation.abs() < 1e-12, "{}", exact.largest.deviation);
    assert!((exact.smallest.deviation - lowest).abs() < -1e-10 * lowest, "{} {lowest}", exact.smallest.deviation);
}

//! Derivatives against differences of exact positions, and directions of paths.

use crate::build::{Build, turning, v};
use crate::known;
use loosepin_space::{
    CylindricalPlay, DriveValue, JointCoordinate, JointOutput, KindOfOutput, OutputState, PathFrame, PlayDistribution,
    PointOutput, Pose, PoseAccuracy, Quaternion, RevolutePlay, RotationOutput, RotationSineOutput, SpatialOutput,
    SpatialPlay, SphericalPlay, UprightPlay, Vec3, assemble, motion,
};

/// Step of central differences: its square times third derivatives, and round-off over it, are below the tolerance.
const STEP: f64 = 1e-5;
const TOLERANCE: f64 = 1e-8;

#[test]
fn identity_gains_are_derivatives_of_exact_deviations() {
    let mechanism = known::platform();
    let position = assemble(&mechanism, &[DriveValue::default(); 3]).unwrap();
    let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
    let outputs: [SpatialOutput; 4] = [
        PointOutput { body: 7, point_m: v(0.1, -0.05, 0.2), direction: v(0.6, 0.0, 0.8) }.into(),
        RotationOutput { body: 7, axis: v(0.0, 0.8, -0.6) }.into(),
        RotationSineOutput { body: 4, axis: Vec3::X }.into(),
        JointOutput { joint: 4, coordinate: JointCoordinate::Slide }.into(),
    ];
    let count = accuracy.play_set().variables();
    for output in outputs {
        let gains = accuracy.gains(&output).unwrap();
        for k in 0..count {
            let moved = |step: f64| {
                let mut variables = vec![0.0; count];
                variables[k] = step;
                accuracy.deviation(&output, &accuracy.displaced(&variables).unwrap().poses).unwrap()
            };
            // Slopes of bearings of 20 mm: third derivatives are those of the step over the length.
            let step = 1e-6;
            let found = (moved(step) - moved(-step)) / (2.0 * step);
            let size = gains.by_play.iter().fold(1.0, |size: f64, gain| size.max(gain.abs()));
            assert!((found - gains.by_play[k]).abs() < 1e-7 * size, "{k}: {found} {}", gains.by_play[k]);
        }
    }
}

#[test]
fn identity_derivatives_of_plays_are_differences_of_their_shifts() {
    let plays: [SpatialPlay; 4] = [
        SphericalPlay { radial_clearance_m: 2e-4 }.into(),
        RevolutePlay { bearing_length_m: 0.03, radial_clearance_m: 3e-4, axial_clearance_m: 2e-4 }.into(),
        CylindricalPlay { bearing_length_m: 0.04, radial_clearance_m: 2e-4 }.into(),
        UprightPlay { radial_clearance_m: 1e-4, axial_clearance_m: 2e-4 }.into(),
    ];
    for play in plays {
        let count: usize = play.blocks().iter().map(|block| block.part.size()).sum();
        let variables: Vec<f64> = (0..count).map(|k| 1e-3 * (1.3 * k as f64 + 0.4).sin()).collect();
        let derivatives = play.derivatives(&variables);
        assert_eq!(derivatives.len(), count);
        for (k, derivative) in derivatives.iter().enumerate() {
            let shift = |step: f64| {
                let mut variables = variables.clone();
                variables[k] += step;
                play.marker_shift(&variables)
            };
            let (after, before) = (shift(STEP), shift(-STEP));
            let by_shift = (after.shift_m - before.shift_m) / (2.0 * STEP);
            assert!((by_shift - derivative.shift_m).length() < TOLERANCE, "{} {k}", play.word());
            for axis in 0..2 {
                let by_slope = (after.slope[axis] - before.slope[axis]) / (2.0 * STEP);
                assert!((by_slope - derivative.slope[axis]).abs() < TOLERANCE, "{} {k}", play.word());
            }
        }
    }
}

#[test]
fn identity_gradients_of_outputs_are_differences() {
    let mechanism = known::rssr(None);
    let pose = |k: f64| {
        let turn = Quaternion::from_rotation_vector(v(0.3 * k, -0.8 * k, 0.5));
        Pose::new(v(0.1 * k, 0.2, -0.1), turn)
    };
    let ideal = vec![Pose::GROUND, pose(1.0), pose(-0.4), pose(0.7)];
    let actual = vec![Pose::GROUND, pose(1.3), pose(-0.9), pose(0.2)];
    let outputs: [SpatialOutput; 5] = [
        PointOutput { body: 2, point_m: v(0.1, -0.05, 0.2), direction: v(0.6, 0.0, 0.8) }.into(),
        RotationOutput { body: 3, axis: v(0.0, 0.8, -0.6) }.into(),
        RotationSineOutput { body: 1, axis: v(0.8, 0.6, 0.0) }.into(),
        JointOutput { joint: 2, coordinate: JointCoordinate::Angle }.into(),
        JointOutput { joint: 1, coordinate: JointCoordinate::Slide }.into(),
    ];
    for output in outputs {
        let gradient = output.gradient(
            &OutputState { mechanism: &mechanism, poses: &ideal },
            &OutputState { mechanism: &mechanism, poses: &actual },
        );
        for body in 1..4 {
            let own = gradient.iter().filter(|part| part.body == body);
            let (by_displacement, by_turning) =
                own.fold((Vec3::ZERO, Vec3::ZERO), |(a, b), part| (a + part.by_displacement, b + part.by_turning));
            for axis in Vec3::AXES {
                let deviation = |displacement: Vec3, turning: Vec3| {
                    let mut actual = actual.clone();
                    actual[body] = actual[body].moved(displacement, turning);
                    output.deviation(
                        &OutputState { mechanism: &mechanism, poses: &ideal },
                        &OutputState { mechanism: &mechanism, poses: &actual },
                    )
                };
                let (step, still) = (axis * STEP, Vec3::ZERO);
                let along = (deviation(step, still) - deviation(-step, still)) / (2.0 * STEP);
                let about = (deviation(still, step) - deviation(still, -step)) / (2.0 * STEP);
                assert!((along - by_displacement.dot(axis)).abs() < TOLERANCE, "{}", output.word());
                assert!((about - by_turning.dot(axis)).abs() < TOLERANCE, "{}", output.word());
            }
        }
    }
}

#[test]
fn analytic_directions_of_a_helix() {
    // x = (r cos φ, r sin φ, p φ/2π): the normal points to the axis.
    let (radius, pitch, angle) = (0.2_f64, 0.05_f64, 0.9_f64);
    let marker = |body| loosepin_space::Marker::new(body, Vec3::ZERO, Vec3::Z, Vec3::X).unwrap();
    let mechanism =
        Build::new(1).push(loosepin_space::Screw { pitch_m: pitch }.into(), marker(0), marker(1)).driven().mechanism();
    let position = assemble(&mechanism, &turning(angle)).unwrap();
    let rates = motion(&mechanism, &position);
    let arm = position.poses[1].orientation.rotation().apply(v(radius, 0.0, 0.0));
    let (velocity, acceleration) = (rates.point_velocity_m_s(1, arm), rates.point_acceleration_m_s2(1, arm));
    let frame = PathFrame::new(velocity, acceleration, 1e-9).unwrap();
    let (sine, cosine) = angle.sin_cos();
    let advance = pitch / std::f64::consts::TAU;
    let tangent = v(-radius * sine, radius * cosine, advance) / radius.hypot(advance);
    assert!((frame.tangent - tangent).length() < 1e-12);
    assert!((frame.normal + v(cosine, sine, 0.0)).length() < 1e-12);
    assert!((frame.binormal - tangent.cross(frame.normal)).length() < 1e-12);
    assert_eq!(PathFrame::new(velocity, acceleration, 1.0), None);
    // On a straight path the normal is any across it.
    let straight = PathFrame::new(velocity, velocity * 3.0, 1e-9).unwrap();
    assert!(straight.normal.dot(tangent).abs() < 1e-12 && (straight.normal.length() - 1.0).abs() < 1e-12);
}

#[test]
fn analytic_deviations_on_rims() {
    // One ball with the gain g: inside c |g|/√5, on its surface c |g|/√3; a bearing that leans: √2 times as much on the rims.
    let at = |bearing: Option<SpatialPlay>, wrist: Option<SpatialPlay>| {
        let mechanism = known::rssp(bearing, wrist);
        let position = assemble(&mechanism, &turning(0.4)).unwrap();
        let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
        let gains = accuracy.gains(&SpatialOutput::displacement(3, Vec3::ZERO)[0]).unwrap();
        let worst = accuracy.first_order(&gains).unwrap().worst;
        let [inside, rim] = [PlayDistribution::Inside, PlayDistribution::OnTheRim]
            .map(|distribution| accuracy.standard_deviation(&gains, distribution).unwrap());
        [inside / worst, rim / worst]
    };
    let [inside, rim] = at(None, Some(SphericalPlay { radial_clearance_m: 1e-4 }.into()));
    assert!((inside - 1.0 / 5.0_f64.sqrt()).abs() < 1e-12 && (rim - 1.0 / 3.0_f64.sqrt()).abs() < 1e-12);
    let bearing = RevolutePlay { bearing_length_m: 0.02, radial_clearance_m: 1e-4, axial_clearance_m: 0.0 };
    let [inside, rim] = at(Some(bearing.into()), None);
    assert!((rim / inside - 2.0_f64.sqrt()).abs() < 1e-12);
}

#[test]
fn analytic_scatter_of_the_lengths_of_a_four_bar() {
    // dψ/dL = L/((C - B)·C_ψ) of the coupler's length, by one marker on it; the other one scatters across the coupler, which turns it only.
    let mechanism = known::rssr(None);
    let position = assemble(&mechanism, &turning(1.0)).unwrap();
    let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
    let output = JointOutput { joint: 3, coordinate: JointCoordinate::Angle }.into();
    let gains = accuracy.gains(&output).unwrap();
    let step = 1e-6;
    let [longer, shorter] = [step, -step].map(|step| known::rssr_angle(1.0, known::COUPLER + step));
    let slope = (longer - shorter) / (2.0 * step);
    // Axes of the ball markers are those of the coupler as drawn.
    let [first, second] = [mechanism.joints()[1].journal, mechanism.joints()[2].bearing];
    let along = (second.point_m - first.point_m).normalised().unwrap();
    let across = along.cross(Vec3::Z).normalised().unwrap();
    let all = accuracy.marker_gains(&gains);
    for (gain, sign) in [(all[1].journal, -1.0), (all[2].bearing, 1.0)] {
        assert!((gain.by_displacement.dot(along) - sign * slope).abs() < 1e-8, "{}", gain.by_displacement.dot(along));
        assert!(gain.by_displacement.dot(across).abs() < 1e-12);
    }
    let sigma = 1e-4;
    let scatter = |joint, side| loosepin_space::MarkerScatter {
        joint,
        side,
        displacement_m: v(sigma, sigma, sigma),
        turning_rad: v(0.1, 0.1, 0.1),
    };
    use loosepin_space::MarkerSide::{Bearing, Journal};
    let found = accuracy.scatter(&gains, &[scatter(1, Journal), scatter(2, Bearing)]);
    assert!((found - slope.abs() * sigma * 2.0_f64.sqrt()).abs() < 1e-8 * sigma);
    assert_eq!(accuracy.scatter(&gains, &[scatter(9, Bearing)]), 0.0);
}

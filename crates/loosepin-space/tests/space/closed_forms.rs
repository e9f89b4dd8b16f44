//! Positions, rates and mobility with closed forms.

use crate::build::{Build, turn, turning, v, wrapped};
use crate::known;
use loosepin_space::{
    IdleKind, JointCoordinate, JointOutput, KindOfOutput, Marker, OutputState, Pose, Position, Quaternion,
    SpatialMechanism, Vec3, assemble, cycle, mobility, motion,
};

/// Round-off of positions and angles of order one along a cycle.
const ROUND_OFF: f64 = 1e-10;

fn positions(mechanism: &SpatialMechanism, inputs: &[f64]) -> Vec<Position> {
    let found = cycle(mechanism, inputs, &turning);
    assert_eq!(found.stopped, None);
    found.positions
}

/// Coordinate of a joint, as its deviation from the start poses.
fn coordinate(mechanism: &SpatialMechanism, position: &Position, joint: usize, coordinate: JointCoordinate) -> f64 {
    let start = mechanism.start_poses();
    JointOutput { joint, coordinate }
        .deviation(&OutputState { mechanism, poses: &start }, &OutputState { mechanism, poses: &position.poses })
}

/// Two shafts at the angle β in the plane x, y and a cross; the input pin along z or in the plane.
fn cardan(bend: f64, is_pin_in_plane: bool) -> SpatialMechanism {
    let out = v(bend.cos(), bend.sin(), 0.0);
    let (first, second) = if is_pin_in_plane { (Vec3::Y, Vec3::Z) } else { (Vec3::Z, v(-bend.sin(), bend.cos(), 0.0)) };
    let cross = [Marker::along(1, Vec3::ZERO, first).unwrap(), Marker::along(2, Vec3::ZERO, second).unwrap()];
    Build::new(2)
        .joint("revolute", [0, 1], v(-0.3, 0.0, 0.0), Vec3::X, Vec3::Y)
        .driven()
        .push(crate::build::kind("universal"), cross[0], cross[1])
        .joint("revolute", [0, 2], out * 0.4, out, Vec3::Z)
        .mechanism()
}

#[test]
fn analytic_cardan_joint() {
    let bend: f64 = 0.6;
    for is_pin_in_plane in [false, true] {
        let mechanism = cardan(bend, is_pin_in_plane);
        let (mut slowest, mut fastest) = (f64::INFINITY, 0.0_f64);
        for position in positions(&mechanism, &turn(72)) {
            let factor = if is_pin_in_plane { 1.0 / bend.cos() } else { bend.cos() };
            let expected = (factor * position.input.sin()).atan2(position.input.cos());
            let found = coordinate(&mechanism, &position, 2, JointCoordinate::Angle);
            assert!(wrapped(found - expected).abs() < ROUND_OFF, "{found} {expected}");
            let rate = motion(&mechanism, &position).bodies[2].angular_velocity_rad_s.length();
            (slowest, fastest) = (slowest.min(rate), fastest.max(rate));
        }
        assert!((slowest - bend.cos()).abs() < ROUND_OFF && (fastest - 1.0 / bend.cos()).abs() < ROUND_OFF);
        let found = mobility(&mechanism, &assemble(&mechanism, &turning(0.3)).unwrap());
        // Each shaft is held by the cross and by its bearing at a point of its axis: all three forces once too often.
        assert_eq!((found.degrees_of_freedom, found.rows, found.rank), (1, 14, 11));
        assert_eq!((found.counted_freedoms, found.redundant.len(), found.undriven_freedoms), (-2, 3, 0));
    }
}

#[test]
fn analytic_screw() {
    let mechanism = Build::new(1)
        .push(
            loosepin_space::Screw { pitch_m: 0.02 }.into(),
            Marker::new(0, v(0.1, 0.2, 0.3), v(0.0, 0.6, 0.8), Vec3::X).unwrap(),
            Marker::new(1, v(0.1, 0.2, 0.3), v(0.0, 0.6, 0.8), Vec3::X).unwrap(),
        )
        .driven()
        .mechanism();
    let inputs: Vec<f64> = (0..20).map(|k| 0.9 * f64::from(k)).collect();
    for position in positions(&mechanism, &inputs) {
        let moved = position.poses[1].point_m(v(0.1, 0.2, 0.3)) - v(0.1, 0.2, 0.3);
        let expected = v(0.0, 0.6, 0.8) * (0.02 * position.input / std::f64::consts::TAU);
        assert!((moved - expected).length() < 1e-12);
        let rates = motion(&mechanism, &position);
        let velocity = rates.point_velocity_m_s(1, position.poses[1].orientation.rotation().apply(v(0.1, 0.2, 0.3)));
        assert!((velocity - v(0.0, 0.6, 0.8) * (0.02 / std::f64::consts::TAU)).length() < 1e-12);
    }
}

#[test]
fn peer_four_bar_with_two_balls() {
    // Independent program, 12 digits of a degree.
    let table =
        [124.492094787, 150.032662359, 181.374838291, 201.064873494, 194.025879341, 151.402504440].map(f64::to_radians);
    let mechanism = known::rssr(None);
    let start = known::rssr_angle(0.0, known::COUPLER);
    for position in positions(&mechanism, &turn(24)) {
        let psi = start + coordinate(&mechanism, &position, 3, JointCoordinate::Angle);
        assert!(wrapped(psi - known::rssr_angle(position.input, known::COUPLER)).abs() < ROUND_OFF);
        let degrees = position.input.to_degrees();
        let row = (degrees / 60.0).round();
        if (degrees - 60.0 * row).abs() < 1e-9 {
            assert!(wrapped(psi - table[row as usize % 6]).abs() < 1e-12 * 60.0, "{degrees}");
        }
        let rates = motion(&mechanism, &position);
        let rate = rates.bodies[3].angular_velocity_rad_s.dot(v(0.6, 0.8, 0.0));
        assert!((rate - known::rssr_rate(position.input)).abs() < ROUND_OFF);
        // The coupler does not spin about the line between its balls.
        let axis = position.poses[2].orientation.rotation().apply(known_coupler_axis(&mechanism));
        assert!(rates.bodies[2].angular_velocity_rad_s.dot(axis).abs() < ROUND_OFF);
    }
    let found = mobility(&mechanism, &assemble(&mechanism, &turning(1.0)).unwrap());
    assert_eq!((found.degrees_of_freedom, found.undriven_freedoms, found.redundant.len()), (2, 0, 0));
    assert_eq!(found.idle.len(), 1);
    assert_eq!(found.idle[0].bodies, [2]);
    let IdleKind::Turn { point_m } = found.idle[0].kind else { panic!("{:?}", found.idle) };
    let position = assemble(&mechanism, &turning(1.0)).unwrap();
    for joint in [1, 2] {
        let marker = [mechanism.joints()[1].journal, mechanism.joints()[2].bearing][joint - 1];
        let off = position.poses[2].point_m(marker.point_m) - point_m;
        assert!(off.cross(found.idle[0].direction).length() < 1e-12, "the axis goes through both balls");
    }
}

#[test]
fn analytic_few_inputs_and_a_position_near_a_change_point_stay_on_the_branch() {
    // s = r cos θ + √(l² - r² sin² θ) with l = 1.0002 r: at 90° the other assembly is 2 mm away from this one.
    let (crank, rod) = (0.05_f64, 0.05001_f64);
    let slider = v(crank + rod, 0.0, 0.0);
    let mechanism = Build::new(3)
        .joint("revolute", [0, 1], Vec3::ZERO, Vec3::Z, Vec3::X)
        .driven()
        .ball([1, 2], v(crank, 0.0, 0.0))
        .ball([2, 3], slider)
        .joint("prismatic", [0, 3], slider, Vec3::X, Vec3::Y)
        .mechanism();
    for steps in [1, 2, 3, 4, 5, 7, 12] {
        for position in positions(&mechanism, &turn(steps)) {
            let (sine, cosine) = position.input.sin_cos();
            let expected = crank * cosine + (rod * rod - crank * crank * sine * sine).sqrt();
            assert!((position.poses[3].point_m(slider).x - expected).abs() < ROUND_OFF, "{steps}");
        }
    }
    for steps in [1, 2, 5] {
        let mechanism = known::rssr(None);
        let start = known::rssr_angle(0.0, known::COUPLER);
        for position in positions(&mechanism, &turn(steps)) {
            let psi = start + coordinate(&mechanism, &position, 3, JointCoordinate::Angle);
            assert!(wrapped(psi - known::rssr_angle(position.input, known::COUPLER)).abs() < ROUND_OFF);
        }
    }
}

fn known_coupler_axis(mechanism: &SpatialMechanism) -> Vec3 {
    let [first, second] = [1, 2].map(|joint: usize| &mechanism.joints()[joint]);
    (second.bearing.point_m - first.journal.point_m).normalised().unwrap()
}

#[test]
fn analytic_crank_ball_pin_and_sliding_shaft() {
    // x = B_x + √(L² - (ρ - h)²), φ = atan2(B_z, B_y), ρ² = B_y² + B_z².
    let (pivot, radius, length, offset) = (v(-0.2, 0.1, 0.01), 0.04, 0.15, 0.02);
    let (ex, ez) = (v(0.96, 0.0, -0.28), v(0.28, 0.0, 0.96));
    let ey = ez.cross(ex);
    let pin = |angle: f64| pivot + (ex * angle.cos() + ey * angle.sin()) * radius;
    let slider = |angle: f64| {
        let pin = pin(angle);
        let distance = pin.y.hypot(pin.z);
        (pin.x + (length * length - (distance - offset) * (distance - offset)).sqrt(), pin.z.atan2(pin.y))
    };
    let (x, phi) = slider(0.0);
    let out = v(0.0, phi.cos(), phi.sin());
    let joint = v(x, 0.0, 0.0) + out * offset;
    let mechanism = Build::new(3)
        .joint("revolute", [0, 1], pivot, ez, ex)
        .driven()
        .ball([1, 2], pin(0.0))
        .joint("revolute", [2, 3], joint, Vec3::X.cross(out), Vec3::X)
        .joint("cylindrical", [0, 3], v(x, 0.0, 0.0), Vec3::X, Vec3::Y)
        .mechanism();
    for position in positions(&mechanism, &turn(36)) {
        let (x_now, phi_now) = slider(position.input);
        let slide = coordinate(&mechanism, &position, 3, JointCoordinate::Slide);
        let angle = coordinate(&mechanism, &position, 3, JointCoordinate::Angle);
        assert!((slide - (x_now - x)).abs() < ROUND_OFF && wrapped(angle - (phi_now - phi)).abs() < ROUND_OFF);
    }
    let found = mobility(&mechanism, &assemble(&mechanism, &turning(0.0)).unwrap());
    assert_eq!((found.degrees_of_freedom, found.redundant.len(), found.idle.len()), (1, 0, 0));
}

#[test]
fn analytic_spatial_slider_crank() {
    let mechanism = known::rssp(None, None);
    for position in positions(&mechanism, &turn(36)) {
        let found = position.poses[3].point_m(v(0.2, 0.0, 0.0)).x;
        assert!((found - known::rssp_slider(position.input, 0.3)).abs() < ROUND_OFF);
    }
}

#[test]
fn peer_rates_of_the_spatial_slider_crank() {
    // Independent program: at ω = 6 rad/s with the crank up ṡ = 0.24 m/s, ω of the rod (1.69411765, -0.84705882, 0.70588235). There a
    // universal joint holds the rod's spin; here it is zero.
    let mechanism = known::rssp(None, None);
    let drive = [loosepin_space::DriveValue::at_rate(0.0, 6.0)];
    let rates = motion(&mechanism, &assemble(&mechanism, &drive).unwrap());
    assert!((rates.bodies[3].velocity_m_s - v(0.24, 0.0, 0.0)).length() < 1e-12);
    let (axis, rod) = (v(2.0, -1.0, -2.0) / 3.0, v(1.69411765, -0.84705882, 0.70588235));
    let expected = rod - axis * rod.dot(axis);
    assert!((rates.bodies[2].angular_velocity_rad_s - expected).length() < 1e-8);
}

#[test]
fn published_mobility_of_bricards_mechanism() {
    let mechanism = known::bricard();
    let found = mobility(&mechanism, &assemble(&mechanism, &turning(0.0)).unwrap());
    assert_eq!((found.rows, found.rank, found.degrees_of_freedom, found.counted_freedoms), (30, 29, 1, 0));
    assert_eq!((found.redundant.len(), found.undriven_freedoms), (1, 0));
    assert!(found.smallest_counted > 1e-3 && found.largest_uncounted < 1e-15, "{found:?}");
    for position in positions(&mechanism, &[0.0, 0.1, 0.2, 0.3]) {
        assert_eq!((position.rank, position.redundant_rows()), (30, 1));
    }
}

/// Bennett's mechanism: opposite bars are alike, a/sin α = b/sin β; tan(θ/2) tan(ψ/2) = sin((β + α)/2)/sin((β - α)/2).
#[test]
fn analytic_bennett() {
    let (a, alpha, beta): (f64, f64, f64) = (0.3, 0.7, 1.2);
    let b = a * beta.sin() / alpha.sin();
    let ratio = (0.5 * (beta + alpha)).sin() / (0.5 * (beta - alpha)).sin();
    let psi = |theta: f64| 2.0 * (ratio / (0.5 * theta).tan()).atan();
    let theta: f64 = 1.1;
    // Denavit and Hartenberg: turn about z, along x, twist about x.
    let link = |turn: f64, length: f64, twist: f64, pose: &Pose| {
        let moved = |pose: &Pose, shift: Vec3, turn: Vec3| {
            let axes = pose.orientation.rotation();
            let orientation = pose.orientation.compose(&Quaternion::from_rotation_vector(turn));
            Pose::new(pose.position_m + axes.apply(shift), orientation)
        };
        let turned = moved(pose, Vec3::ZERO, v(0.0, 0.0, turn));
        moved(&turned, v(length, 0.0, 0.0), v(twist, 0.0, 0.0))
    };
    let turns = [theta, psi(theta), -theta, -psi(theta)];
    let bars = [(a, alpha), (b, beta), (a, alpha), (b, beta)];
    let mut frames = vec![Pose::GROUND];
    for (turn, (length, twist)) in turns.into_iter().zip(bars) {
        frames.push(link(turn, length, twist, frames.last().unwrap()));
    }
    let end = frames[4];
    assert!(end.position_m.length() < 1e-14 && (end.orientation.rotation().z - Vec3::Z).length() < 1e-14);
    // Joint k turns about z of frame k, from the x axis of the bar before to that of the bar behind.
    let mut build = Build::new(3);
    for k in 0..4 {
        let axes = frames[k].orientation.rotation();
        let behind = frames[k + 1].orientation.rotation().x;
        let bearing = Marker::new(k, frames[k].position_m, axes.z, axes.x).unwrap();
        let journal = Marker::new((k + 1) % 4, frames[k].position_m, axes.z, behind).unwrap();
        build = build.push(crate::build::kind("revolute"), bearing, journal);
        if k == 0 {
            build = build.driven();
        }
    }
    let mechanism = build.mechanism();
    let inputs: Vec<f64> = (0..=12).map(|k| theta + 0.3 * f64::from(k)).collect();
    for position in positions(&mechanism, &inputs) {
        let turned = coordinate(&mechanism, &position, 1, JointCoordinate::Angle);
        assert!(wrapped(turned + psi(theta) - psi(position.input)).abs() < ROUND_OFF, "{}", position.input);
    }
    let found = mobility(&mechanism, &assemble(&mechanism, &turning(theta)).unwrap());
    assert_eq!((found.rows, found.rank, found.degrees_of_freedom, found.counted_freedoms), (20, 17, 1, -2));
}

fn planar_four_bar(lengths: [f64; 4], crank_angle: f64) -> (SpatialMechanism, f64) {
    let [crank, coupler, rocker, frame] = lengths;
    let pin = v(crank * crank_angle.cos(), crank * crank_angle.sin(), 0.0);
    let angle = planar_rocker(lengths, crank_angle);
    let tip = v(frame + rocker * angle.cos(), rocker * angle.sin(), 0.0);
    assert!(((tip - pin).length() - coupler).abs() < 1e-14);
    let mechanism = Build::new(3)
        .push(
            crate::build::kind("revolute"),
            Marker::new(0, Vec3::ZERO, Vec3::Z, Vec3::X).unwrap(),
            Marker::new(1, Vec3::ZERO, Vec3::Z, pin).unwrap(),
        )
        .driven()
        .about("revolute", [1, 2], pin + v(0.0, 0.0, 0.01), Vec3::Z)
        .about("revolute", [2, 3], tip + v(0.0, 0.0, -0.02), Vec3::Z)
        .about("revolute", [0, 3], v(frame, 0.0, 0.0), Vec3::Z)
        .mechanism();
    (mechanism, angle)
}

fn planar_rocker([crank, coupler, rocker, frame]: [f64; 4], angle: f64) -> f64 {
    let apart = v(frame - crank * angle.cos(), -crank * angle.sin(), 0.0);
    let (p, q) = (2.0 * rocker * apart.x, 2.0 * rocker * apart.y);
    let s = coupler * coupler - rocker * rocker - apart.dot(apart);
    q.atan2(p) + (s / p.hypot(q)).acos()
}

#[test]
fn analytic_planar_four_bar_in_space() {
    let lengths = [0.05, 0.16, 0.11, 0.14];
    let (mechanism, start) = planar_four_bar(lengths, 0.0);
    for position in positions(&mechanism, &turn(36)) {
        let angle = start + coordinate(&mechanism, &position, 3, JointCoordinate::Angle);
        assert!(wrapped(angle - planar_rocker(lengths, position.input)).abs() < ROUND_OFF);
        assert_eq!((position.rank, position.redundant_rows()), (18, 3));
    }
    let found = mobility(&mechanism, &assemble(&mechanism, &turning(0.4)).unwrap());
    assert_eq!((found.degrees_of_freedom, found.redundant.len(), found.counted_freedoms), (1, 3, -2));
    for direction in &found.redundant {
        let sum: f64 = direction.shares.iter().map(|share| share.of_forces + share.of_moments).sum();
        assert!((sum - 1.0).abs() < 1e-12 && direction.shares.len() == 4);
    }
}

#[test]
fn analytic_planar_four_bar_on_a_plane_with_a_coupler_of_two_bodies() {
    // Balls at both ends of the coupler, which a face on the ground holds in the plane; its two bodies are rigidly joined.
    let lengths = [0.05, 0.16, 0.11, 0.14];
    let start = planar_rocker(lengths, 0.0);
    let (pin, tip) = (v(0.05, 0.0, 0.0), v(0.14 + 0.11 * start.cos(), 0.11 * start.sin(), 0.0));
    let parts = |is_held: bool| {
        let mut build = Build::new(4)
            .joint("revolute", [0, 1], Vec3::ZERO, Vec3::Z, Vec3::X)
            .driven()
            .ball([1, 2], pin)
            .joint("rigid", [2, 4], (pin + tip) * 0.5, v(0.3, 0.1, 1.0), Vec3::X)
            .ball([4, 3], tip)
            .joint("revolute", [0, 3], v(0.14, 0.0, 0.0), Vec3::Z, Vec3::X);
        if is_held {
            build = build.joint("planar", [0, 2], v(0.07, 0.03, 0.02), Vec3::Z, Vec3::X);
        }
        build.mechanism()
    };
    let mechanism = parts(true);
    for position in positions(&mechanism, &turn(24)) {
        let angle = start + coordinate(&mechanism, &position, 4, JointCoordinate::Angle);
        assert!(wrapped(angle - planar_rocker(lengths, position.input)).abs() < ROUND_OFF);
    }
    let found = mobility(&mechanism, &assemble(&mechanism, &turning(0.4)).unwrap());
    // Two places of the coupler are held along z by balls and by the face.
    assert_eq!((found.degrees_of_freedom, found.redundant.len(), found.idle.len()), (1, 2, 0));
    // Without the face the whole coupler spins.
    let spinning = parts(false);
    let position = assemble(&spinning, &turning(0.4)).unwrap();
    let found = mobility(&spinning, &position);
    assert_eq!((found.degrees_of_freedom, found.undriven_freedoms, found.idle.len()), (2, 0, 1));
    assert_eq!(found.idle[0].bodies, [2, 4]);
    let rates = motion(&spinning, &position);
    let axis = found.idle[0].direction;
    for body in [2, 4] {
        assert!(rates.bodies[body].angular_velocity_rad_s.dot(axis).abs() < 1e-12);
    }
}

#[test]
fn analytic_planar_slider_crank_in_space() {
    let (crank, rod) = (0.05_f64, 0.12_f64);
    let slider = v(crank + rod, 0.0, 0.0);
    let mechanism = Build::new(3)
        .joint("revolute", [0, 1], Vec3::ZERO, Vec3::Z, Vec3::X)
        .driven()
        .about("revolute", [1, 2], v(crank, 0.0, 0.0), Vec3::Z)
        .about("revolute", [2, 3], slider, Vec3::Z)
        .joint("prismatic", [0, 3], slider, Vec3::X, Vec3::Y)
        .mechanism();
    for position in positions(&mechanism, &turn(36)) {
        let (sine, cosine) = position.input.sin_cos();
        let expected = crank * cosine + (rod * rod - crank * crank * sine * sine).sqrt();
        assert!((position.poses[3].point_m(slider).x - expected).abs() < ROUND_OFF);
        assert_eq!(position.redundant_rows(), 3);
    }
}

#[test]
fn identity_rates_are_differences_of_positions() {
    const STEP: f64 = 1e-4;
    // Step² times third and fourth derivatives of order one hundred.
    const TOLERANCE: f64 = 2e-5;
    let drive = |input: f64| {
        // φ = s + 0.2 sin 2s
        let (sine, cosine) = (2.0 * input).sin_cos();
        vec![loosepin_space::DriveValue {
            value: input + 0.2 * sine,
            rate: 1.0 + 0.4 * cosine,
            acceleration: -0.8 * sine,
        }]
    };
    // All drives of the arm, which are on moving bodies but for the first, go alike but at a tenth of it along slides.
    let arm = crate::chains::arm();
    let slides: Vec<bool> = arm.drives().iter().map(|drive| drive.coordinate == JointCoordinate::Slide).collect();
    let all = |input: f64| {
        let scaled = |is_slide: &bool| {
            let (factor, own) = (if *is_slide { 0.1 } else { 1.0 }, drive(input)[0]);
            loosepin_space::DriveValue {
                value: factor * own.value,
                rate: factor * own.rate,
                acceleration: factor * own.acceleration,
            }
        };
        slides.iter().map(scaled).collect::<Vec<_>>()
    };
    type Drives<'a> = &'a dyn Fn(f64) -> Vec<loosepin_space::DriveValue>;
    let cases: [(SpatialMechanism, f64, Drives); 5] = [
        (known::rssr(None), 1.3, &drive),
        (known::rssp(None, None), 2.1, &drive),
        (cardan(0.7, false), 0.9, &drive),
        (known::bricard(), 0.4, &drive),
        (arm.clone(), 0.7, &all),
    ];
    for (mechanism, at, drive) in cases {
        let inputs = [0.0, 0.5 * at, at - STEP, at, at + STEP];
        let found = cycle(&mechanism, &inputs, drive);
        assert_eq!(found.stopped, None);
        let [.., before, here, after] = &found.positions[..] else { panic!() };
        let rates = motion(&mechanism, here);
        let local = v(0.03, -0.02, 0.05);
        for body in 1..mechanism.bodies().len() {
            // The spin of idle parts is not that of the positions.
            if mobility(&mechanism, here).idle.iter().any(|idle| idle.bodies.contains(&body)) {
                continue;
            }
            let [p, q, r] = [before, here, after].map(|position| position.poses[body].point_m(local));
            let arm = here.poses[body].orientation.rotation().apply(local);
            let velocity = (r - p) / (2.0 * STEP);
            let acceleration = (r - q * 2.0 + p) / (STEP * STEP);
            assert!((rates.point_velocity_m_s(body, arm) - velocity).length() < TOLERANCE);
            assert!((rates.point_acceleration_m_s2(body, arm) - acceleration).length() < TOLERANCE);
        }
    }
}

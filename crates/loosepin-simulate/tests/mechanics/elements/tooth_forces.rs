//! Forces of gear teeth in the joints of their wheels, against closed forms and against the balance of every body.

use super::{Built, build, file};
use loosepin_math::Vec2;
use loosepin_mechanics::dynamics::{Dynamics, PlayState};
use loosepin_mechanics::mechanism::{IdealMotion, Mechanism, acceleration_at};
use loosepin_mechanics::model::{JointId, Model};
use loosepin_simulate::{Arms, columns};

const ALPHA_DEG: f64 = 20.0;
/// Direction from the first to the second centre, of no special angle.
const LINE_DEG: f64 = 31.0;
const GRAVITY_M_S2: f64 = 9.81;
/// Of forces, relative to the largest.
const ROUND_OFF: f64 = 1e-9;

fn direction(angle_deg: f64) -> Vec2<f64> {
    let (sine, cosine) = angle_deg.to_radians().sin_cos();
    Vec2::new(cosine, sine)
}

fn body(name: &str, centre: [f64; 2], points: &str) -> String {
    format!(
        "[body.{name}]\nmass = \"0.7 kg\"\ninertia = \"9e-4 kg m^2\"\ncentre_of_mass = [\"{} mm\", \"{} mm\"]\n\
         points = {{ {points} }}\n",
        centre[0], centre[1]
    )
}

fn revolute(name: &str, bearing: &str, journal: &str) -> String {
    format!("[joint.{name}]\nkind = \"revolute\"\nbearing = \"{bearing}\"\njournal = \"{journal}\"\n")
}

fn gears([first, second]: [&str; 2], mesh: &str, radii_mm: [f64; 2], angle: &str) -> String {
    let [a, b] = radii_mm;
    format!(
        "[coupling.mesh]\nkind = \"gears\"\nfirst = \"{first}\"\nsecond = \"{second}\"\nmesh = \"{mesh}\"\n\
         radii = [\"{a} mm\", \"{b} mm\"]\noffset = \"25 deg\"\n{angle}"
    )
}

fn with_angle() -> String {
    format!("pressure_angle = \"{ALPHA_DEG} deg\"\n")
}

/// A drive that is faster and faster.
const DRIVE: &str = "[drive.first]\njoint = \"first\"\nmotion = { kind = \"polynomial\", coefficients = [\"50 deg\", \"30 rad/s\", \"40 rad/s^2\"] }\n[cycle]\nduration = \"0.5 s\"\n";

fn head(second_mm: Vec2<f64>) -> String {
    format!(
        "name = \"teeth\"\ngravity = \"{GRAVITY_M_S2} m/s^2\"\n[body.ground]\n\
         points = {{ o = [\"0 mm\", \"0 mm\"], p = [\"{:.17} mm\", \"{:.17} mm\"], q = [\"11 mm\", \"-20 mm\"] }}\n",
        second_mm.x, second_mm.y
    )
}

/// Two wheels on the ground with a torque on the second.
fn pair(mesh: &str, radii_mm: [f64; 2], torque_n_m: f64, centre_mm: [f64; 2], is_turned: bool, angle: &str) -> String {
    let distance_mm = if mesh == "external" { radii_mm[0] + radii_mm[1] } else { (radii_mm[0] - radii_mm[1]).abs() };
    let second = if is_turned { ["second.shaft", "ground.p"] } else { ["ground.p", "second.shaft"] };
    [
        head(direction(LINE_DEG) * distance_mm),
        body("first", [0.0, 0.0], "shaft = [\"0 mm\", \"0 mm\"]"),
        body("second", centre_mm, "shaft = [\"0 mm\", \"0 mm\"]"),
        revolute("first", "ground.o", "first.shaft"),
        revolute("second", second[0], second[1]),
        gears(["first", "second"], mesh, radii_mm, angle),
        format!("[load.brake]\nkind = \"torque\"\nbody = \"second\"\ntorque = \"{torque_n_m} N m\"\n"),
        DRIVE.to_owned(),
    ]
    .concat()
}

/// The mechanism as it is driven, at an instant.
fn at_instant<'a>(built: &'a Built, time_s: f64) -> Dynamics<'a, f64> {
    let sample = built.sample();
    let mut ideal = IdealMotion::new(&built.mechanism, &sample.ideal, &sample.drives).expect("it starts");
    ideal.move_to(time_s).expect("it moves");
    let (coordinates, rates) = ideal.real_state();
    let n = built.mechanism.real.free;
    let mut dynamics = Dynamics::new(&built.mechanism, &sample);
    dynamics.evaluate(time_s, &coordinates[..n], &rates[..n], &[]);
    dynamics
}

/// What a body lacks of its balance: force, N, and moment about `centre_m`, N m.
struct Lack {
    force_n: Vec2<f64>,
    moment_n_m: f64,
    centre_m: Vec2<f64>,
}

/// Of all bodies, the ground included as if it had no mass, by Newton and Euler from joint forces, weights, `torques_n_m` on bodies
/// and the torque of the drive in the first joint.
fn lacks(dynamics: &Dynamics<'_, f64>, torques_n_m: &[(usize, f64)]) -> Vec<Lack> {
    let (mechanism, sample) = (dynamics.mechanism(), dynamics.sample());
    let (model, slots) = (&mechanism.model, &mechanism.real.slot_of_body);
    let mut lacks: Vec<Lack> = (0..model.bodies.len())
        .map(|body| {
            if body == 0 {
                return Lack { force_n: Vec2::zero(), moment_n_m: 0.0, centre_m: Vec2::zero() };
            }
            let slot = slots[body];
            let numbers = &sample.real.links[slot - 1];
            let (pose, twist) = (&dynamics.kinematics.poses[slot], &dynamics.kinematics.twists[slot]);
            let change = dynamics.acceleration(slot);
            let acceleration = acceleration_at(&change, twist, pose.turn(numbers.centre_of_mass_m));
            Lack {
                force_n: (acceleration - Vec2::new(0.0, -GRAVITY_M_S2)) * numbers.mass_kg,
                moment_n_m: numbers.inertia_kg_m2 * change.angular,
                centre_m: pose.point_m(numbers.centre_of_mass_m),
            }
        })
        .collect();
    let mut push = |body: usize, point_m: Vec2<f64>, force_n: Vec2<f64>, torque_n_m: f64| {
        let lack = &mut lacks[body];
        lack.force_n -= force_n;
        lack.moment_n_m -= (point_m - lack.centre_m).cross(force_n) + torque_n_m;
    };
    for (index, joint) in model.joints.iter().enumerate() {
        let [first, second] = joint.kind.bodies().map(|body| body.0);
        let point = joint.kind.points()[1];
        let arm_m = loosepin_mechanics::mechanism::point_m(model, &model.quantities.nominal(), point);
        let point_m = dynamics.kinematics.poses[slots[second]].point_m(arm_m);
        let force_n = dynamics.joint_force_n(JointId(index));
        let torque_n_m = if index == 0 { dynamics.drive_force(0) } else { 0.0 };
        push(second, point_m, force_n, torque_n_m);
        push(first, point_m, -force_n, -torque_n_m);
    }
    for &(body, torque_n_m) in torques_n_m {
        push(body, Vec2::zero(), Vec2::zero(), torque_n_m);
    }
    lacks
}

/// Wheels have exactly the force of their teeth left over, at the pitch point, and others nothing.
fn assert_teeth_close_the_balance(
    lacks: &[Lack],
    wheels: [usize; 2],
    pitch_m: Vec2<f64>,
    first_m: Vec2<f64>,
    apart: f64,
) {
    let [first, second] = wheels.map(|body| &lacks[body]);
    let largest_n = second.force_n.length();
    assert!(largest_n > 0.5, "there is a force: {largest_n}");
    let slack_n = ROUND_OFF * largest_n;
    assert!((first.force_n + second.force_n).length() < slack_n, "{:?} {:?}", first.force_n, second.force_n);
    for wheel in wheels.into_iter().filter(|wheel| *wheel != 0) {
        let Lack { force_n, moment_n_m, centre_m } = lacks[wheel];
        let due_n_m = (pitch_m - centre_m).cross(force_n);
        assert!((moment_n_m - due_n_m).abs() < 0.1 * slack_n, "body {wheel}: {moment_n_m} {due_n_m}");
    }
    // `apart` is one where the second wheel is pushed along the way from the first centre to the pitch point.
    let outwards = (pitch_m - first_m) * (1.0 / (pitch_m - first_m).length());
    let [across_n, along_n] = [outwards, outwards.turned()].map(|axis| axis.dot(second.force_n));
    let due_n = apart * along_n.abs() * ALPHA_DEG.to_radians().tan();
    assert!((across_n - due_n).abs() < slack_n && across_n.abs() > 100.0 * slack_n, "{across_n} {due_n}");
    for (body, lack) in lacks.iter().enumerate().filter(|(body, _)| *body != 0 && !wheels.contains(body)) {
        assert!(
            lack.force_n.length() < slack_n && lack.moment_n_m.abs() < 0.1 * slack_n,
            "body {body}: {:?}",
            lack.force_n
        );
    }
}

#[test]
fn analytic_forces_of_teeth_on_two_fixed_bearings() {
    let weight_n = 0.7 * GRAVITY_M_S2;
    let tan = ALPHA_DEG.to_radians().tan();
    let line = direction(LINE_DEG);
    // Where the pitch point is from the second centre, over the radius, along the line of centres.
    for (mesh, radii_mm, at) in
        [("external", [23.0, 61.0], -1.0), ("internal", [23.0, 61.0], -1.0), ("internal", [61.0, 23.0], 1.0)]
    {
        for torque_n_m in [0.9, -0.9] {
            for is_turned in [false, true] {
                let built = build(&pair(mesh, radii_mm, torque_n_m, [0.0, 0.0], is_turned, &with_angle()));
                let dynamics = at_instant(&built, 0.07);
                let ratio = radii_mm[0] / radii_mm[1] * if mesh == "external" { -1.0 } else { 1.0 };
                // The teeth turn the second wheel against its load and its inertia.
                let turning_n_m = 9e-4 * ratio * 80.0 - torque_n_m;
                let along_n = at * turning_n_m / (1e-3 * radii_mm[1]);
                let apart = if mesh == "external" { 1.0 } else { -1.0 };
                let on_second_n = line.turned() * along_n + line * (apart * along_n.abs() * tan);
                let up_n = Vec2::new(0.0, weight_n);
                let sign = if is_turned { -1.0 } else { 1.0 };
                let due_n = [up_n + on_second_n, (up_n - on_second_n) * sign];
                for (joint, due_n) in due_n.into_iter().enumerate() {
                    let found_n = dynamics.joint_force_n(JointId(joint));
                    let case = format!("{mesh} {radii_mm:?} {torque_n_m} {is_turned}");
                    assert!((found_n - due_n).length() < ROUND_OFF * due_n.length(), "{case}: {found_n:?} {due_n:?}");
                }
                // Both reactions and both weights: the centres of mass are at rest.
                let sum_n = dynamics.joint_force_n(JointId(0)) + dynamics.joint_force_n(JointId(1)) * sign;
                assert!((sum_n - up_n * 2.0).length() < ROUND_OFF * along_n.abs(), "{sum_n:?}");
            }
        }
    }
}

#[test]
fn identity_every_body_is_in_balance_with_the_force_at_the_pitch_point() {
    let line = direction(LINE_DEG);
    for (mesh, radii_mm, pitch_mm, apart) in [
        ("external", [23.0, 61.0], 23.0, 1.0),
        ("internal", [23.0, 61.0], -23.0, 1.0),
        ("internal", [61.0, 23.0], 61.0, -1.0),
    ] {
        for (torque_n_m, is_turned) in [(0.9, false), (-1.1, true)] {
            // The second wheel is out of balance.
            let built = build(&pair(mesh, radii_mm, torque_n_m, [7.0, -3.0], is_turned, &with_angle()));
            for time_s in [0.0, 0.13] {
                let lacks = lacks(&at_instant(&built, time_s), &[(2, torque_n_m)]);
                assert_teeth_close_the_balance(&lacks, [1, 2], line * (1e-3 * pitch_mm), Vec2::zero(), apart);
            }
        }
    }
}

/// Two cranks with gears, and two couplers between their pins. The joint of the second crank closes the loop.
fn geared_five_bar() -> String {
    let points = |far_mm: f64| format!("a = [\"0 mm\", \"0 mm\"], b = [\"{far_mm} mm\", \"0 mm\"]");
    [
        head(direction(LINE_DEG) * 84.0),
        body("first", [7.0, 2.0], &points(45.0)),
        body("left", [31.0, -4.0], &points(77.0)),
        body("right", [29.0, 3.0], &points(81.0)),
        body("second", [-5.0, 6.0], &points(37.0)),
        revolute("first", "ground.o", "first.a"),
        revolute("left", "first.b", "left.a"),
        revolute("knee", "left.b", "right.b"),
        revolute("right", "second.b", "right.a"),
        revolute("second", "ground.p", "second.a"),
        gears(["first", "second"], "external", [23.0, 61.0], &with_angle()),
        "[assembly]\nguess = { left = \"70 deg\", right = \"110 deg\", second = \"10 deg\" }\n".to_owned(),
        DRIVE.to_owned(),
    ]
    .concat()
}

#[test]
fn identity_a_bearing_that_closes_a_loop_carries_the_force_of_teeth() {
    let built = build(&geared_five_bar());
    let second = JointId(4);
    assert!(built.mechanism.real.cuts.iter().any(|cut| cut.joint == second), "the bearing closes the loop");
    for time_s in [0.0, 0.011] {
        let lacks = lacks(&at_instant(&built, time_s), &[]);
        assert_teeth_close_the_balance(&lacks, [1, 4], direction(LINE_DEG) * 0.023, Vec2::zero(), 1.0);
    }
}

#[test]
fn identity_a_planet_on_a_moving_arm_rolls_on_a_wheel_at_rest() {
    // The arm turns; its planet is in mesh with the ground, outside or inside of it.
    for (mesh, radii_mm, torque_n_m, apart) in
        [("external", [33.0, 19.0], 0.6, 1.0), ("internal", [52.0, 19.0], -0.7, -1.0)]
    {
        let arm_mm = if mesh == "external" { radii_mm[0] + radii_mm[1] } else { radii_mm[0] - radii_mm[1] };
        let text = [
            head(Vec2::new(1.0, 2.0)),
            body("arm", [13.0, 2.0], &format!("a = [\"0 mm\", \"0 mm\"], b = [\"{arm_mm} mm\", \"0 mm\"]")),
            body("planet", [4.0, -3.0], "shaft = [\"0 mm\", \"0 mm\"]"),
            revolute("first", "ground.o", "arm.a"),
            revolute("second", "planet.shaft", "arm.b"),
            gears(["first", "second"], mesh, radii_mm, &with_angle()),
            format!("[load.brake]\nkind = \"torque\"\nbody = \"planet\"\ntorque = \"{torque_n_m} N m\"\n"),
            DRIVE.to_owned(),
        ];
        let built = build(&text.concat());
        for time_s in [0.0, 0.09] {
            let dynamics = at_instant(&built, time_s);
            let arm = dynamics.kinematics.poses[built.mechanism.real.slot_of_body[1]];
            let pitch_m = arm.turn(Vec2::new(1e-3 * radii_mm[0], 0.0));
            let mut lacks = lacks(&dynamics, &[(2, torque_n_m)]);
            // The ground gets from the teeth what the planet does not.
            lacks[0].force_n = -lacks[2].force_n;
            assert_teeth_close_the_balance(&lacks, [0, 2], pitch_m, Vec2::zero(), apart);
        }
    }
}

/// A pinion on the ground and a rack with a load, whose guide is a point of the ground or of the rack.
fn rack(way: &str, force_n: f64, is_guide: bool) -> String {
    let rail = "{ point = \"ground.q\", angle = \"17 deg\" }";
    let own = "{ point = \"rack.a\", angle = \"17 deg\" }";
    let [guide, slider] = if is_guide { [own, rail] } else { [rail, own] };
    [
        head(Vec2::new(1.0, 2.0)),
        body("pinion", [3.0, 1.0], "shaft = [\"0 mm\", \"0 mm\"]"),
        body("rack", [8.0, -2.0], "a = [\"0 mm\", \"0 mm\"]"),
        revolute("first", "ground.o", "pinion.shaft"),
        format!("[joint.rail]\nkind = \"prismatic\"\nguide = {guide}\nslider = {slider}\n"),
        format!("[coupling.mesh]\nkind = \"rack\"\nfirst = \"first\"\nsecond = \"rail\"\nradius = \"24 mm\"\ndirection = \"{way}\"\n{}", with_angle()),
        format!("[load.cut]\nkind = \"force\"\npoint = \"rack.a\"\nforce = \"{force_n} N\"\ndirection = \"0 deg\"\n"),
        DRIVE.to_owned(),
    ]
    .concat()
}

#[test]
fn analytic_force_of_a_pinion_on_its_rack() {
    let tan = ALPHA_DEG.to_radians().tan();
    let weight_n = Vec2::new(0.0, -0.7 * GRAVITY_M_S2);
    for force_n in [90.0, -90.0] {
        for (way, sense) in [("forward", 1.0), ("backward", -1.0)] {
            for is_guide in [false, true] {
                let built = build(&rack(way, force_n, is_guide));
                let dynamics = at_instant(&built, 0.02);
                // The body of the rack does not turn, and its line lies in its frame and in the ground's alike.
                let line = direction(17.0);
                // The rack goes along its line, relative to the ground, by r times the angle of the pinion.
                let acceleration_m_s2 = line * (sense * 0.024 * 80.0);
                let missing_n = acceleration_m_s2 * 0.7 - weight_n - Vec2::new(force_n, 0.0);
                let along_n = line.dot(missing_n);
                let out = line.turned() * -sense;
                let on_rack_n = line * along_n + out * (along_n.abs() * tan);
                // The guide gives what is left across it.
                let due_n = missing_n - on_rack_n;
                let found_n = dynamics.joint_force_n(JointId(1)) * if is_guide { -1.0 } else { 1.0 };
                let slack_n = ROUND_OFF * on_rack_n.length();
                let case = format!("{way} {force_n} {is_guide}");
                assert!((found_n - due_n).length() < slack_n, "{case}: {found_n:?} {due_n:?}");
                // The pinion gets the opposite, at the pitch point.
                let lack = &lacks(&dynamics, &[])[1];
                assert!((lack.force_n + on_rack_n).length() < slack_n, "{case}: {:?} {on_rack_n:?}", lack.force_n);
                let due_n_m = (out * 0.024 - lack.centre_m).cross(lack.force_n);
                assert!((lack.moment_n_m - due_n_m).abs() < 0.1 * slack_n, "{case}: {} {due_n_m}", lack.moment_n_m);
            }
        }
    }
}

#[test]
fn identity_flanks_with_backlash_press_their_bearings_as_well() {
    let teeth = "[contact.teeth]\nrestitution = 0.7\nstiffness = \"1e9 N/m^1.5\"\nexponent = 1.5\n";
    let text = pair(
        "external",
        [23.0, 61.0],
        0.9,
        [7.0, -3.0],
        false,
        &format!("{}backlash = \"0.1 mm\"\ncontact = \"teeth\"\n", with_angle()),
    );
    let built = build(&format!("{text}{teeth}"));
    let sample = built.sample();
    let mut dynamics = Dynamics::new(&built.mechanism, &sample);
    assert_eq!(built.mechanism.real.free, 1, "the second wheel");
    let state = PlayState { contact: 1.0, inverse_impact_speed_s_m: 2.3, effective_mass_kg: f64::NAN };
    let ratio = -23.0 / 61.0;
    let first_rad = 50f64.to_radians() + 30.0 * 0.02 + 40.0 * 0.02 * 0.02;
    for behind in [1.0, -1.0] {
        let off_rad = -behind * (0.05e-3 + 4e-6) / 0.061;
        let second_rad = ratio * first_rad + 25f64.to_radians() + off_rad;
        dynamics.evaluate(0.02, &[second_rad], &[ratio * 31.6], &[state; 2]);
        let lacks = lacks(&dynamics, &[(2, 0.9)]);
        assert_teeth_close_the_balance(&lacks, [1, 2], direction(LINE_DEG) * 0.023, Vec2::zero(), 1.0);
    }
}

#[test]
fn identity_teeth_change_bearing_forces_alone() {
    let torque_n_m = 0.9;
    let [felt, not_felt] = [with_angle(), String::new()]
        .map(|angle| build(&pair("external", [23.0, 61.0], torque_n_m, [7.0, -3.0], false, &angle)));
    let [felt, not_felt] = [&felt, &not_felt].map(|built| at_instant(built, 0.13));
    assert_eq!(felt.drive_force(0).to_bits(), not_felt.drive_force(0).to_bits());
    assert_eq!(felt.accelerations(), not_felt.accelerations());
    let [with_n, without_n] = [&felt, &not_felt].map(|dynamics| dynamics.joint_force_n(JointId(1)));
    assert!((with_n - without_n).length() > 10.0, "{with_n:?} {without_n:?}");
}

#[test]
fn analytic_outputs_contain_the_force_of_teeth() {
    let built = build(&file("gears_with_pressure_angle.toml"));
    // 1.8 N m at 45 mm, on a line of centres along (3, 4)/5; the pinion turns from x towards y at even speed, and the wheel's load
    // helps: the teeth hold it back, from x towards y at the wheel's near side.
    let (along_n, apart_n) = (1.8 / 0.045, 1.8 / 0.045 * ALPHA_DEG.to_radians().tan());
    let on_wheel_n = [-0.8 * along_n + 0.6 * apart_n, 0.6 * along_n + 0.8 * apart_n];
    let bearing_n = f64::hypot(-on_wheel_n[0], 0.9 * GRAVITY_M_S2 - on_wheel_n[1]);
    let dynamics = at_instant(&built, 0.03);
    let arms = Arms::new(&built.mechanism, &built.values);
    let found: Vec<f64> =
        columns(&built.mechanism.model).iter().map(|column| column.reading.value(&arms, &dynamics)).collect();
    assert_eq!(found.len(), 2);
    for (found_n, due_n) in found.into_iter().zip([bearing_n, on_wheel_n[0]]) {
        assert!((found_n - due_n).abs() < ROUND_OFF * along_n, "{found_n} {due_n}");
    }
}

#[test]
fn text_of_pitch_circles_that_do_not_touch() {
    let text = pair("external", [23.0, 61.0], 0.9, [7.0, -3.0], false, &with_angle());
    for (radii, due) in [("[\"23 mm\", \"63 mm\"]", "86 mm"), ("[\"2.3 mm\", \"61 mm\"]", "63.3 mm")] {
        let model = Model::from_text("model.toml", &text.replace("[\"23 mm\", \"61 mm\"]", radii)).expect("it reads");
        let error = Mechanism::new(&model, &model.quantities.nominal()).expect_err("they do not touch");
        let expected = format!(
            "coupling 'mesh': the centres of the gears are 84 mm apart; with 'pressure_angle' this must be {due}, from the pitch radii, within 1 %"
        );
        assert_eq!(error.to_string(), expected);
    }
    // Rounded radii are near enough.
    let model = Model::from_text("model.toml", &text.replace("\"61 mm\"", "\"60.5 mm\"")).expect("it reads");
    assert!(Mechanism::new(&model, &model.quantities.nominal()).is_ok());
}

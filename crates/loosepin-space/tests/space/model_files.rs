//! Models in files: the mechanisms that they make against closed forms and against those built by hand, and what is refused.

use crate::build::wrapped;
use crate::known;
use loosepin_space::{
    KindOfOutput, OutputState, PoseAccuracy, Position, RotationOutput, SpatialMechanism, SpatialModel, Vec3, cycle,
    is_spatial,
};
use loosepin_text::diagnostics::Source;

const SLIDER_CRANK: &str = include_str!("../../../../docs/examples/spatial-slider-crank.toml");
const FOUR_BAR: &str = include_str!("../../../../docs/examples/rssr-four-bar.toml");

/// Round-off of positions along a turn.
const ROUND_OFF: f64 = 1e-10;

fn read(text: &str) -> SpatialModel {
    SpatialModel::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

/// The mechanism of a model with its positions over a turn; the inputs are angles of its drive.
fn turn(model: &SpatialModel) -> (SpatialMechanism, Vec<(f64, Position)>) {
    let values = model.quantities.nominal();
    let mechanism = model.mechanism(&values).unwrap();
    let input = model.cycle_input(&values).unwrap();
    let found = cycle(&mechanism, &input.times_s(), &|time_s| model.drive_values(&values, time_s));
    assert_eq!(found.stopped, None);
    let positions = found.positions.into_iter().map(|position| (input.at(position.input), position)).collect();
    (mechanism, positions)
}

#[test]
fn analytic_slider_of_the_file() {
    let model = read(SLIDER_CRANK);
    assert!(model.warnings.is_empty());
    let (_, positions) = turn(&model);
    assert_eq!(positions.len(), 37);
    for (angle, position) in positions {
        let slider = position.poses[3].position_m;
        assert!((slider - Vec3::new(known::rssp_slider(angle, 0.3), 0.0, 0.0)).length() < ROUND_OFF, "{slider:?}");
    }
}

#[test]
fn analytic_rocker_of_the_file() {
    let (mechanism, positions) = turn(&read(FOUR_BAR));
    let ground = mechanism.start_poses();
    let drawn: Vec<_> = ground.iter().map(|_| loosepin_space::Pose::GROUND).collect();
    let output = RotationOutput { body: 3, axis: Vec3::new(0.6, 0.8, 0.0) };
    for (angle, position) in positions {
        let [ideal, actual] = [&drawn, &position.poses].map(|poses| OutputState { mechanism: &mechanism, poses });
        let turn = output.deviation(&ideal, &actual);
        assert!(wrapped(turn - known::rssr_angle(angle, known::COUPLER)).abs() < ROUND_OFF, "{turn}");
    }
}

#[test]
fn peer_gain_of_the_crank_bearing_of_the_file() {
    let model = read(SLIDER_CRANK);
    let values = model.quantities.nominal();
    let (mechanism, positions) = turn(&model);
    let accuracy = PoseAccuracy::new(&mechanism, &positions[0].1).unwrap();
    let output = model.outputs_of(0, &values).unwrap()[0];
    let gains = accuracy.gains(&output).unwrap();
    let worst = accuracy.first_order(&gains).unwrap().worst;
    // Independent program: gain 8.015856 of the radial clearance 0.1 mm, 1 of the axial clearance 0.2 mm; the sum to 12 digits.
    assert!((worst - 0.00100158563062).abs() < 1e-14, "{worst}");
    assert!(((worst - 2e-4) / 1e-4 - 8.015856).abs() < 5e-7, "{worst}");
}

#[test]
fn identity_numbers_are_quantities_that_can_be_set() {
    let model = read(SLIDER_CRANK);
    let set = |path: &str, value: f64| {
        let id = model.quantities.id(path).unwrap_or_else(|| panic!("{path}"));
        model.mechanism(&model.quantities.evaluate(&[(id, value)]).unwrap()).unwrap()
    };
    // The point of the rod and the pin of the crank follow their parameters.
    assert_eq!(set("parameter.rod_length", 0.31).joints()[2].bearing.point_m.x, 0.31);
    assert_eq!(set("parameter.crank_radius", 0.07).joints()[1].bearing.point_m.z, 0.07);
    assert_eq!(set("body.ground.points.bearing.z", 0.13).joints()[0].bearing.point_m.z, 0.13);
    assert!((set("drive.crank.start_angle", 0.3).bodies()[1].start.orientation.w - (0.15_f64).cos()).abs() < 1e-15);
    assert!(model.quantities.id("joint.main.radial_clearance").is_some());
}

#[test]
fn identity_turns_of_a_guess_are_about_the_turned_axes() {
    let text = FOUR_BAR.replace("[\"z -36.87 deg\", \"y 124 deg\", \"z 36.87 deg\"]", "[\"x 90 deg\", \"z 90 deg\"]");
    let model = read(&text);
    let rocker = model.mechanism(&model.quantities.nominal()).unwrap().bodies()[3].start;
    // About x first: the body's z then points along -y of the ground; about it, x of the body goes to its y, which is z of the ground.
    let turned = rocker.orientation.rotation();
    assert!((turned.x - Vec3::Z).length() < 1e-15 && (turned.z + Vec3::Y).length() < 1e-15, "{turned:?}");
}

#[test]
fn analytic_a_guess_turns_about_a_named_axis_of_its_body() {
    let text = FOUR_BAR.replace("[\"z -36.87 deg\", \"y 124 deg\", \"z 36.87 deg\"]", "[\"skew 90 deg\"]");
    let model = read(&text);
    let rocker = model.mechanism(&model.quantities.nominal()).unwrap().bodies()[3].start;
    // A quarter turn about s = (0.6, 0.8, 0) takes z to s × z.
    let turned = rocker.orientation.rotation();
    assert!((turned.z - Vec3::new(0.8, -0.6, 0.0)).length() < 1e-15, "{turned:?}");
    let unknown = SpatialModel::from_text("model.toml", &text.replace("skew 90 deg", "skiw 90 deg")).unwrap_err();
    let said = unknown.to_string();
    assert!(said.contains("body 'rocker' has no axis 'skiw'\nhint: available: 'skew'"), "{said}");
}

#[test]
fn a_bearing_radius_is_compared_with_its_clearance_as_in_the_plane() {
    let radius = |text: &str| SLIDER_CRANK.replacen("radial_clearance", &format!("{text}\nradial_clearance"), 1);
    let model = read(&radius("bearing_radius = \"8 mm\""));
    assert_eq!(model.quantities.nominal()[model.quantities.id("joint.main.bearing_radius").unwrap()], 8e-3);
    assert_eq!(model.warnings, read(SLIDER_CRANK).warnings);
    let tight = SpatialModel::from_text("model.toml", &radius("bearing_radius = \"1 µm\"")).unwrap_err().to_string();
    assert!(tight.contains("error[E0502]: joint 'main': radial clearance "), "{tight}");
    let ball = "kind = \"spherical\"\n";
    let idle = SLIDER_CRANK.replacen(ball, &format!("{ball}bearing_radius = \"8 mm\"\n"), 1);
    let idle = SpatialModel::from_text("model.toml", &idle).unwrap_err().to_string();
    assert!(idle.contains("error[E0205]: joint 'crankpin': 'bearing_radius' needs 'radial_clearance'"), "{idle}");
}

#[test]
fn numbers_in_space_that_are_hardly_possible_are_named() {
    let said = |from: &str, to: &str| {
        assert!(SLIDER_CRANK.contains(from), "{from}");
        let model = read(&SLIDER_CRANK.replacen(from, to, 1));
        model.warnings.iter().map(ToString::to_string).collect::<Vec<_>>()
    };
    let clearance = SLIDER_CRANK.lines().find(|line| line.starts_with("radial_clearance")).unwrap();
    let ball = said("kind = \"spherical\"\n", "kind = \"spherical\"\nradial_clearance = \"100 mm\"\n");
    assert!(
        ball.len() == 1
            && ball[0].contains(
                "joint 'crankpin': radial clearance 100 mm; usual values are up to a twentieth of the largest body, "
            ),
        "{ball:?}"
    );
    let tiny = said(clearance, "radial_clearance = \"1e-7 mm\"");
    assert_eq!(tiny.len(), 1, "{tiny:?}");
    assert!(
        tiny[0].contains(
            "radial clearance 1e-7 mm; usual values are above 0.1 µm, or 0\nhint: did you mean \"1e-7 m\" instead"
        ),
        "{tiny:?}"
    );
    let speed = SLIDER_CRANK.lines().find(|line| line.starts_with("speed")).unwrap();
    let fast = said(speed, "speed = \"1e5 rad/s\"");
    assert!(fast.len() == 1 && fast[0].contains("warning[E0823]: drive 'crank': speed"), "{fast:?}");
}

#[test]
fn bodies_without_a_guess_are_placed_by_their_joints() {
    let model = read(SLIDER_CRANK);
    let mechanism = model.mechanism(&model.quantities.nominal()).unwrap();
    let [_, crank, rod, slider] = mechanism.bodies() else { panic!("four bodies") };
    assert_eq!(crank.start.position_m, Vec3::new(0.0, 0.1, 0.12));
    // The rod begins at the crank's pin and points towards the slider.
    let pin = Vec3::new(0.0, 0.1, 0.2);
    let along = (slider.start.position_m - pin).normalised().unwrap();
    assert!((rod.start.point_m(Vec3::new(0.3, 0.0, 0.0)) - (pin + along * 0.3)).length() < 1e-15);
}

#[test]
fn a_file_says_whether_it_is_spatial() {
    let is_spatial = |text: &str| is_spatial(&Source::new("model.toml", text));
    assert!(is_spatial(SLIDER_CRANK));
    assert!(!is_spatial("geometry = \"plane\"") && !is_spatial("name = \"space\"") && !is_spatial("= ["));
}

/// Each edit of the slider-crank with what its diagnostics say: line, message, hint.
#[test]
fn refusals_have_a_place_and_a_hint() {
    for (from, to, line, message, hint) in [
        (
            "axis = \"x\"\nradial",
            "axis = \"q\"\nradial",
            "axis = \"q\"",
            "joint 'main': axis: body 'ground' has no axis 'q'",
            "write x, y or z, three numbers, or define it under axes of body 'ground'",
        ),
        (
            "bearing_length = \"20 mm\"\n",
            "",
            "radial_clearance",
            "joint 'main': 'radial_clearance' needs 'bearing_length'",
            "play of a pin or a shaft needs its clearance and the length over which it leans; an ideal joint has neither",
        ),
        (
            "kind = \"spherical\"\nbearing = \"crank.pin\"",
            "kind = \"ball\"\nbearing = \"crank.pin\"",
            "kind = \"ball\"",
            "joint 'crankpin': kind is 'ball'; must be \"revolute\", \"prismatic\", \"cylindrical\", \"spherical\", \"universal\", \"planar\", \"screw\" or \"rigid\"",
            "",
        ),
        (
            "journal = \"crank.o\"\naxis",
            "journal = \"crank.q\"\naxis",
            "crank.q",
            "joint 'main': journal: there is no point 'crank.q'",
            "available: 'crank.o' and 'crank.pin'",
        ),
        (
            "[output.slider]",
            "[spring.a]\nkind = \"linear\"\n[output.slider]",
            "[spring.a]",
            "this version does not support spring yet",
            "springs are known in planar models",
        ),
        (
            "speed = \"60 rpm\"",
            "motion = { kind = \"harmonic\" }",
            "motion",
            "this version does not support drive 'crank': motion yet",
            "drives in space move at constant speed; give speed and start_angle or start_position",
        ),
        (
            "start_angle = \"0 deg\"",
            "start_position = \"0 mm\"",
            "start_position",
            "drive 'crank': 'start_position' does not fit the revolute joint 'main'",
            "write start_angle",
        ),
        (
            "joint = \"main\"",
            "joint = \"wrist\"",
            "wrist",
            "drive 'crank': joint 'wrist' is spherical and cannot be driven",
            "drive a revolute, prismatic, cylindrical or screw joint",
        ),
        ("slider = { at", "ground = { at", "guess", "assembly: the ground does not move, so it needs no guess", ""),
        (
            "\"0 mm\"] } }",
            "\"0 mm\"], turned = [\"30 deg\"] } }",
            "guess",
            "assembly guess slider turned 1 is '30 deg'; must be an axis and an angle",
            "for example \"x 30 deg\": a turn about the x axis of the body",
        ),
        ("along = \"x\"", "", "position_of", "output 'slider': 'position_of' needs 'along'", ""),
        (
            "along = \"x\"",
            "along = [0, 0, 0]",
            "along",
            "output 'slider': along has length zero, so it has no direction",
            "",
        ),
        (
            "axis = \"x\"\n\n#",
            "axis = [1, 1, 0]\n\n#",
            "joint.guide",
            "joint 'guide': a prismatic joint about an axis that is not x, y or z needs bearing_across and journal_across",
            "they are directions across the axis that the joint keeps together",
        ),
        (
            "[body.rod]\n",
            "[body.rod]\ninertia = [\"1 kg m^2\", \"1 kg m^2\", \"3 kg m^2\"]\n",
            "inertia",
            "body 'rod': inertia is of no body: each principal moment must be above zero and at most the sum of the other two",
            "xx is the sum of m (y² + z²), xy the negative sum of m x y",
        ),
        (
            "geometry = \"space\"",
            "geometry = \"plane\"",
            "geometry",
            "geometry is 'plane'; must be \"space\"",
            "a planar model has no key geometry, or geometry = \"plane\"",
        ),
        (
            "radial_clearance = \"0.1 mm\"",
            "radial_clearance = \"6 mm\"",
            "joint.main",
            "joint 'main': largest lean 2c/l is 0.6; it must be <= 0.5",
            "",
        ),
    ] {
        assert!(SLIDER_CRANK.contains(from), "{from}");
        let text = SLIDER_CRANK.replacen(from, to, 1);
        let diagnostics = SpatialModel::from_text("model.toml", &text).map(|_| ()).unwrap_err();
        let first = diagnostics.sorted()[0];
        assert_eq!(first.message, message);
        assert_eq!(first.hint.as_deref().unwrap_or_default(), hint, "{message}");
        let (found, _) = first.place.as_ref().unwrap_or_else(|| panic!("{message}")).line_and_column();
        let found = text.lines().nth(found - 1).unwrap();
        assert!(found.contains(line), "{message}: '{found}' has no '{line}'");
    }
}

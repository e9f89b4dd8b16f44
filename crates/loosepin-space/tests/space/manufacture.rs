//! Errors of manufacture in model files: tilts and shifts of the bearings and journals of joints.

use crate::known::LEGS;
use loosepin_space::{
    Gains, MarkerScatter, MarkerSide, PoseAccuracy, RotationSineOutput, SpatialModel, SpatialOutput, Vec3, assemble,
};

const SLIDER_CRANK: &str = include_str!("../../../../docs/examples/spatial-slider-crank.toml");

fn read(text: &str) -> SpatialModel {
    SpatialModel::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

/// The spherical platform with a driven revolute joint and two cylindrical ones in each leg; every bearing may be tilted.
fn platform() -> String {
    let list = |numbers: [f64; 3]| format!("[{:?}, {:?}, {:?}]", numbers[0], numbers[1], numbers[2]);
    let place = |axis: [f64; 3], distance: f64| {
        let [x, y, z] = axis.map(|own| format!("\"{:?} m\"", own * distance));
        format!("[{x}, {y}, {z}]")
    };
    let mut points = vec![String::new(); 8];
    let (mut joints, mut guesses) = (String::new(), Vec::new());
    for (leg, [base, middle, end]) in LEGS.into_iter().enumerate() {
        let (first, second) = (2 * leg + 1, 2 * leg + 2);
        for (kind, pair, axis, distance, across) in [
            ("revolute", [0, first], base, 0.20, Some(middle)),
            ("cylindrical", [first, second], middle, 0.18, None),
            ("cylindrical", [second, 7], end, 0.15, None),
        ] {
            let name = format!("j{}_{}", pair[0], pair[1]);
            for body in pair {
                points[body] += &format!("{name} = {}, ", place(axis, distance));
            }
            let [bearing, journal] = pair.map(body_name);
            joints += &format!(
                "[joint.{name}]\nkind = \"{kind}\"\nbearing = \"{bearing}.{name}\"\njournal = \"{journal}.{name}\"\naxis = {}\n",
                list(axis)
            );
            if let Some(across) = across {
                joints += &format!("bearing_across = {}\njournal_across = {}\n", list(across), list(across));
            }
            joints += "bearing_tilt = [\"0 mrad\", \"0 mrad\", \"0 mrad\"]\n";
        }
        joints += &format!("[drive.d{leg}]\njoint = \"j0_{first}\"\nspeed = \"1 rpm\"\nstart_angle = \"0 deg\"\n");
    }
    let mut text = "name = \"platform\"\ngeometry = \"space\"\n".to_owned();
    for (body, points) in points.iter().enumerate() {
        let name = body_name(body);
        text += &format!("[body.{name}]\npoints = {{ {} }}\n", points.trim_end_matches(", "));
        if body > 0 {
            guesses.push(format!("{name} = {{ at = [\"0 mm\", \"0 mm\", \"0 mm\"] }}"));
        }
    }
    format!("{text}{joints}[assembly]\nguess = {{ {} }}\n", guesses.join(", "))
}

fn body_name(body: usize) -> String {
    match body {
        0 => "ground".to_owned(),
        7 => "platform".to_owned(),
        leg => format!("link{leg}"),
    }
}

/// Standard deviation of each angle, 0.01 degrees.
const SIGMA_DEGREES: f64 = 0.01;
/// Of the centre along x, y and z, m, and of the rotation about them, rad. Independent program, ten digits.
const EXPECTED: [f64; 6] =
    [5.36419326e-05, 4.773188842e-05, 3.498102612e-05, 0.000318800083, 0.0002851531506, 0.0002085569391];

#[test]
fn peer_axis_angle_errors_of_the_platform_through_a_file() {
    let model = read(&platform());
    let sigma = SIGMA_DEGREES.to_radians();
    let nominal = model.quantities.nominal();
    let mechanism = model.mechanism(&nominal).unwrap();
    let drives = model.drive_values(&nominal, 0.0);
    let ideal = assemble(&mechanism, &drives).unwrap();
    let accuracy = PoseAccuracy::new(&mechanism, &ideal).unwrap();
    let outputs: Vec<SpatialOutput> = SpatialOutput::displacement(7, Vec3::ZERO)
        .into_iter()
        .chain(Vec3::AXES.map(|axis| RotationSineOutput { body: 7, axis }.into()))
        .collect();
    // By central differences of closed positions. Step² times third derivatives, and round-off over the step.
    const STEP: f64 = 1e-4;
    let mut variances = [0.0; 6];
    for joint in &model.joints {
        for axis in ["x", "y"] {
            let path = format!("joint.{}.bearing_tilt.{axis}", joint.name);
            let id = model.quantities.id(&path).unwrap_or_else(|| panic!("{path}"));
            let closed = |angle: f64| {
                let values = model.quantities.evaluate(&[(id, angle)]).unwrap();
                assemble(&model.mechanism(&values).unwrap(), &drives).unwrap().poses
            };
            let (plus, minus) = (closed(STEP), closed(-STEP));
            for (variance, output) in variances.iter_mut().zip(&outputs) {
                let change = accuracy.deviation(output, &plus).unwrap() - accuracy.deviation(output, &minus).unwrap();
                *variance += (sigma * change / (2.0 * STEP)).powi(2);
            }
        }
    }
    for (variance, expected) in variances.iter().zip(EXPECTED) {
        assert!((variance.sqrt() - expected).abs() < 1e-6 * expected, "{} {expected}", variance.sqrt());
    }
    // By the gains of the kernel, for the mechanism of the file.
    let turning_rad = Vec3::new(sigma, sigma, 0.0);
    let scatter: Vec<MarkerScatter> = (0..9)
        .map(|joint| MarkerScatter { joint, side: MarkerSide::Bearing, turning_rad, displacement_m: Vec3::ZERO })
        .collect();
    let all: Vec<Gains> = outputs.iter().map(|output| accuracy.gains(output).unwrap()).collect();
    for (gains, expected) in all.iter().zip(EXPECTED) {
        let found = accuracy.scatter(gains, &scatter);
        assert!((found - expected).abs() < 1e-9 * expected, "{found} {expected}");
    }
}

/// The slider-crank with lines added to a joint.
fn with_lines(joint: &str, lines: &str) -> String {
    let head = format!("[joint.{joint}]\n");
    assert!(SLIDER_CRANK.contains(&head));
    SLIDER_CRANK.replace(&head, &format!("{head}{lines}\n"))
}

#[test]
fn identity_errors_of_zero_change_nothing() {
    let plain = read(SLIDER_CRANK);
    let plain = plain.mechanism(&plain.quantities.nominal()).unwrap();
    for joint in ["main", "guide"] {
        let zero = |key: &str, unit: &str| format!("{key} = [\"0 {unit}\", \"0 {unit}\", \"0 {unit}\"]\n");
        let lines = ["bearing_shift", "journal_shift"].map(|key| zero(key, "mm")).concat()
            + &["bearing_tilt", "journal_tilt"].map(|key| zero(key, "deg")).concat();
        let model = read(&with_lines(joint, &lines));
        assert_eq!(model.mechanism(&model.quantities.nominal()).unwrap(), plain);
    }
    let model = read(&with_lines("wrist", "bearing_shift = [\"0 mm\", \"0 mm\", \"0 mm\"]"));
    assert_eq!(model.mechanism(&model.quantities.nominal()).unwrap(), plain);
}

#[test]
fn analytic_shift_and_tilt_are_along_the_axes_of_the_joint() {
    // The bearing is about x, its direction across is y of the ground, so that the third axis is z of the ground.
    let model = read(&with_lines(
        "main",
        "bearing_shift = [\"1 mm\", \"2 mm\", \"3 mm\"]\nbearing_tilt = [\"0 mrad\", \"90 deg\", \"0 mrad\"]\n\
         journal_shift = [\"0.3 mm\", \"0 mm\", \"0 mm\"]\njournal_tilt = [\"0 deg\", \"0 deg\", \"30 deg\"]",
    ));
    let mechanism = model.mechanism(&model.quantities.nominal()).unwrap();
    let joint = &mechanism.joints()[0];
    let near = |found: Vec3, expected: Vec3| assert!((found - expected).length() < 1e-15, "{found:?} {expected:?}");
    near(joint.bearing.point_m, Vec3::new(0.003, 0.101, 0.122));
    // A quarter of a turn about z of the ground takes the axis x to y, and the direction across, y, to -x.
    near(joint.bearing.axes.z, Vec3::Y);
    near(joint.bearing.axes.x, -Vec3::X);
    near(joint.bearing.axes.y, Vec3::Z);
    near(joint.journal.point_m, Vec3::new(0.0, 0.0003, 0.0));
    let (sine, cosine) = 30.0_f64.to_radians().sin_cos();
    near(joint.journal.axes.z, Vec3::X);
    near(joint.journal.axes.x, Vec3::new(0.0, cosine, sine));
}

#[test]
fn wrong_errors_are_refused_at_their_place() {
    for (joint, line, message) in [
        (
            "main",
            "bearing_tilt = [\"1 mm\", \"0 deg\", \"0 deg\"]",
            "joint 'main': bearing tilt x is a length; must be an angle",
        ),
        ("main", "bearing_tilt = [\"1 deg\", \"0 deg\"]", "joint 'main': bearing tilt has 2 entries; expected 3"),
        (
            "main",
            "journal_shift = \"1 mm\"",
            "joint 'main': journal shift is the text \"1 mm\"; expected a list of three",
        ),
        ("wrist", "bearing_tilt = [\"1 deg\", \"0 deg\", \"0 deg\"]", "joint 'wrist' has no key 'bearing_tilt'"),
    ] {
        let text = with_lines(joint, line);
        let diagnostics = SpatialModel::from_text("model.toml", &text).map(|_| ()).unwrap_err();
        let first = diagnostics.sorted()[0];
        assert_eq!(first.message, message);
        let (found, _) = first.place.as_ref().unwrap_or_else(|| panic!("{message}")).line_and_column();
        assert_eq!(text.lines().nth(found - 1), Some(line));
    }
}

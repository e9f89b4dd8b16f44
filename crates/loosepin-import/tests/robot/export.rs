//! Models in space as robot descriptions, and back.

use crate::matrices::{about_y, chain, difference, moved};
use crate::mjcf::{FOUR_BAR, rocker};
use crate::urdf::{POSES, PUMA, flange};
use crate::{ROUND_OFF, imported, model_of, pose_of, position};
use loosepin_import::{Exported, RobotFormat, export_robot};
use loosepin_space::{SpatialModel, mobility};

const SLIDER_CRANK: &str = include_str!("../../../../docs/examples/spatial-slider-crank.toml");
const RSSR: &str = include_str!("../../../../docs/examples/rssr-four-bar.toml");

fn read(text: &str) -> SpatialModel {
    SpatialModel::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

fn exported(model: &SpatialModel, format: RobotFormat) -> Exported {
    export_robot(model, format).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

/// Line and message of a refusal.
fn refused(text: &str, format: RobotFormat) -> (usize, String) {
    let diagnostics = export_robot(&read(text), format).expect_err("a refusal");
    let first = diagnostics.sorted()[0];
    (first.place.as_ref().expect("a place").line_and_column().0, first.message.clone())
}

#[test]
fn published_arm_comes_back_from_both_formats() {
    let model = model_of(PUMA);
    for format in [RobotFormat::Urdf, RobotFormat::Mjcf] {
        let back = model_of(&exported(&model, format).text);
        let names = |model: &SpatialModel| model.drives.iter().map(|drive| drive.name.clone()).collect::<Vec<_>>();
        assert_eq!(names(&back), names(&model));
        for angles in POSES {
            let (_, position) = position(&back, &angles);
            let found = difference(pose_of(&back, &position, "flange"), flange(angles));
            assert!(found < ROUND_OFF, "{format:?} {angles:?}: {found:e}");
        }
        // The one link with a mass has it still.
        let of = |model: &SpatialModel| {
            let body = model.bodies.iter().find(|body| body.name == "link2").unwrap();
            let ids = body.mass_kg.into_iter().chain(body.centre_of_mass_m.unwrap()).chain(body.inertia_kg_m2.clone());
            ids.map(|id| model.quantities.nominal_value(id)).collect::<Vec<_>>()
        };
        assert_eq!(of(&back), of(&model));
    }
}

#[test]
fn analytic_slider_crank_comes_back() {
    let model = read(SLIDER_CRANK);
    let own = exported(&model, RobotFormat::Mjcf);
    assert_eq!(own.notes[0], "the play of joint 'main' is not exported");
    assert!(own.text.contains("<!-- the play of joint 'main' is not exported -->"), "{}", own.text);
    let back = model_of(&own.text);
    assert_eq!(back.drives.iter().map(|drive| drive.name.as_str()).collect::<Vec<_>>(), ["main"]);
    for angle in [0.0_f64, 0.7, -2.0, 3.0] {
        let (_, position) = position(&back, &[angle]);
        // The pin of the crank is straight up, along z, at 0; the rod is 300 mm long.
        let (y, z) = (0.1 - 0.08 * angle.sin(), 0.12 + 0.08 * angle.cos());
        let due = moved((0.09 - y * y - z * z).sqrt(), 0.0, 0.0);
        let found = difference(pose_of(&back, &position, "slider"), due);
        assert!(found < ROUND_OFF, "{angle}: {found:e}");
    }
    // The point that the output reads is there.
    let slider = back.bodies.iter().find(|body| body.name == "slider").unwrap();
    assert!(slider.points.iter().any(|point| point.name == "slider_pin"));
}

#[test]
fn published_rocker_comes_back() {
    // RSSR of the reference tables: the angle of the rocker at crank angles of 0 and 120 degrees.
    let back = model_of(&exported(&read(RSSR), RobotFormat::Mjcf).text);
    for (crank, psi) in [(0.0_f64, 124.492094787_f64), (120.0, 181.374838291)] {
        let (_, position) = position(&back, &[crank.to_radians()]);
        let due = chain(&[moved(0.22, 0.04, 0.06), crate::matrices::about([0.6, 0.8, 0.0], psi.to_radians())]);
        let found = difference(pose_of(&back, &position, "rocker"), due);
        // The table has 12 digits.
        assert!(found < 1e-11, "{crank}: {found:e}");
    }
}

/// The four-bar of pins alone: what closes the loop is a pin, which becomes two points.
#[test]
fn analytic_four_bar_of_pins_comes_back() {
    let text = imported("four_bar.xml", FOUR_BAR).model;
    let pins = text.replace("kind = \"spherical\"", "kind = \"revolute\"\naxis = \"-y\"");
    assert_ne!(text, pins);
    let own = exported(&read(&pins), RobotFormat::Mjcf);
    assert_eq!(own.text.matches("<connect").count(), 2, "{}", own.text);
    let back = model_of(&own.text);
    for angle in [0.4, -1.3, 2.0] {
        let (mechanism, position) = position(&back, &[angle]);
        let due = chain(&[moved(0.4, 0.0, 0.0), about_y(-rocker(angle))]);
        assert!(difference(pose_of(&back, &position, "rocker"), due) < ROUND_OFF);
        assert_eq!(mobility(&mechanism, &position).degrees_of_freedom, 1);
    }
    // The coupler welded to the rocker comes first, and a pin on the ground closes the loop.
    let welded = exported(&read(&text.replace("kind = \"spherical\"", "kind = \"rigid\"")), RobotFormat::Mjcf).text;
    assert!(welded.contains("<connect name=\"pivot\" body1=\"rocker\" body2=\"world\" anchor=\"0 0 0\"/>"), "{welded}");
    let joint = |name: &str, bearing: &str, journal: &str| {
        format!("[joint.{name}]\nkind = \"rigid\"\nbearing = \"{bearing}.o\"\njournal = \"{journal}.o\"\n")
    };
    let bodies: String = ["ground", "a", "b"]
        .map(|name| format!("[body.{name}]\npoints = {{ o = [\"0 mm\", \"0 mm\", \"0 mm\"] }}\n"))
        .concat();
    let triangle = joint("one", "ground", "a") + &joint("two", "ground", "b") + &joint("seam", "a", "b");
    let triangle = format!("name = \"t\"\ngeometry = \"space\"\n{bodies}{triangle}");
    let welded = exported(&read(&triangle), RobotFormat::Mjcf).text;
    assert!(welded.contains("<weld name=\"seam\" body1=\"a\" body2=\"b\"/>"), "{welded}");
}

/// Joints with frames off the origins of their bodies, turned, and the other way round.
const OFFSETS: &str = r#"
name = "offsets & <marks>"
geometry = "space"
[body.ground]
points = { o = ["10 mm", "20 mm", "30 mm"] }
axes = { skew = [0.6, 0, 0.8] }
[body.arm]
mass = "2 kg"
centre_of_mass = ["5 mm", "-7 mm", "11 mm"]
inertia = ["3e-3 kg m^2", "4e-3 kg m^2", "5e-3 kg m^2", "1e-4 kg m^2", "-2e-4 kg m^2", "3e-4 kg m^2"]
points = { a = ["-40 mm", "15 mm", "5 mm"], b = ["60 mm", "-25 mm", "35 mm"] }
[body.slide]
points = { c = ["12 mm", "-8 mm", "3 mm"], d = ["70 mm", "0 mm", "0 mm"] }
[body.shaft]
points = { e = ["-9 mm", "4 mm", "6 mm"], f = ["0 mm", "50 mm", "0 mm"] }
[body.tool]
points = { g = ["1 mm", "2 mm", "3 mm"], tip = ["0 mm", "0 mm", "80 mm"] }
[body.plate]
points = { h = ["0 mm", "0 mm", "-10 mm"] }
[joint.base]
kind = "revolute"
bearing = "arm.a"
journal = "ground.o"
bearing_axis = [0, 0.6, 0.8]
journal_axis = "skew"
bearing_across = "x"
journal_across = "y"
[joint.guide]
kind = "prismatic"
bearing = "slide.c"
journal = "arm.b"
bearing_axis = [1, 2, 2]
journal_axis = "y"
bearing_across = [2, -1, 0]
journal_across = "z"
[joint.sleeve]
kind = "cylindrical"
bearing = "slide.d"
journal = "shaft.e"
bearing_axis = "z"
journal_axis = "-x"
[joint.cross]
kind = "universal"
bearing = "shaft.f"
journal = "tool.g"
bearing_pin = "x"
journal_pin = "y"
[joint.table]
kind = "planar"
bearing = "tool.tip"
journal = "plate.h"
axis = "z"
[joint.seat]
kind = "rigid"
bearing = "plate.h"
journal = "hand.o"
[body.hand]
points = { o = ["0 mm", "0 mm", "0 mm"] }
[drive.base]
joint = "base"
speed = "0 rpm"
start_angle = "25 deg"
[drive.guide]
joint = "guide"
speed = "0 mm/s"
start_position = "40 mm"
[drive.turn]
joint = "sleeve"
speed = "0 rpm"
start_angle = "-50 deg"
[drive.slide]
joint = "sleeve"
speed = "0 mm/s"
start_position = "15 mm"
"#;

#[test]
fn peer_offsets_and_reversed_joints_come_back() {
    let model = read(OFFSETS);
    let starts = [25.0_f64.to_radians(), 0.04, -50.0_f64.to_radians(), 0.015];
    // Bodies of MJCF keep their frames, and coordinates of joints their values.
    let mjcf = exported(&model, RobotFormat::Mjcf).text;
    let back = model_of(&mjcf);
    let of_drives = |model: &SpatialModel, values: &[(&str, f64)]| -> Vec<f64> {
        let value = |name: &str| values.iter().find(|(own, _)| *own == name).map_or(0.0, |(_, value)| *value);
        model.drives.iter().map(|drive| value(&model.joints[drive.joint].name)).collect()
    };
    for values in [starts, [-1.1, 0.07, 0.8, -0.03]] {
        let (_, own) = position(&model, &values);
        let named = [("base", values[0]), ("guide", values[1]), ("sleeve", values[2]), ("sleeve_slide", values[3])];
        let (_, found) = position(&back, &of_drives(&back, &named));
        // What nothing drives moves in another way from the start: the tool and what stands on it.
        let bodies: &[&str] = if values == starts {
            &["arm", "slide", "shaft", "tool", "plate", "hand"]
        } else {
            &["arm", "slide", "shaft"]
        };
        for body in bodies {
            let found = difference(pose_of(&model, &own, body), pose_of(&back, &found, body));
            assert!(found < ROUND_OFF, "{body}: {found:e}\n{mjcf}");
        }
    }
    // Links of URDF stand at the points of their joints.
    let own = exported(&model, RobotFormat::Urdf);
    let back = model_of(&own.text);
    assert_eq!(back.name, "offsets & <marks>");
    let points = [
        ("arm", [-0.04, 0.015, 0.005]),
        ("slide", [0.012, -0.008, 0.003]),
        ("shaft", [-0.009, 0.004, 0.006]),
        ("tool", [0.001, 0.002, 0.003]),
        ("plate", [0.0, 0.0, -0.01]),
        ("hand", [0.0, 0.0, 0.0]),
    ];
    // The plate slides freely on the tool: where it is after a motion is not determined.
    let still = ["25 deg", "40 mm", "-50 deg", "15 mm"].into_iter().fold(OFFSETS.to_owned(), |text, start| {
        let (_, unit) = start.split_once(' ').unwrap();
        text.replace(&format!("= \"{start}\""), &format!("= \"0 {unit}\""))
    });
    let still = read(&still);
    let still_back = model_of(&exported(&still, RobotFormat::Urdf).text);
    for (model, back, starts, determined) in [(&model, &back, starts, 4), (&still, &still_back, [0.0; 4], 6)] {
        let (_, here) = position(model, &starts);
        let named = [("base", starts[0]), ("guide", starts[1]), ("sleeve", starts[2]), ("sleeve_slide", starts[3])];
        let (_, found) = position(back, &of_drives(back, &named));
        for (body, [x, y, z]) in points.into_iter().take(determined) {
            let due = chain(&[pose_of(model, &here, body), moved(x, y, z)]);
            let found = difference(due, pose_of(back, &found, body));
            assert!(found < ROUND_OFF, "{body}: {found:e}\n{}", own.text);
        }
    }
    // The centre of mass is where it was, from the point of the joint: (5, -7, 11) - (-40, 15, 5).
    assert!(own.text.contains("<origin xyz=\"0.045 -0.022 0.006\" rpy=\"0 0 0\"/>"), "{}", own.text);
}

#[test]
fn what_a_format_does_not_know_is_named() {
    let line_of = |text: &str, part: &str| text[..text.find(part).unwrap()].matches('\n').count() + 1;
    let (line, message) = refused(SLIDER_CRANK, RobotFormat::Urdf);
    assert_eq!(message, "joint 'wrist' closes a loop, which URDF does not know");
    assert_eq!(line, line_of(SLIDER_CRANK, "[joint.wrist]"));
    let screw = OFFSETS
        .replace("kind = \"cylindrical\"", "kind = \"screw\"\npitch = \"5 mm\"")
        .replace("[drive.slide]\njoint = \"sleeve\"\nspeed = \"0 mm/s\"\nstart_position = \"15 mm\"\n", "");
    for (format, name) in [(RobotFormat::Urdf, "URDF"), (RobotFormat::Mjcf, "MJCF")] {
        let (line, message) = refused(&screw, format);
        assert_eq!(message, format!("joint 'sleeve' is screw, which {name} does not know"));
        assert_eq!(line, line_of(&screw, "[joint.sleeve]"));
    }
    let ball = OFFSETS
        .replace("kind = \"universal\"", "kind = \"spherical\"")
        .replace("bearing_pin = \"x\"\njournal_pin = \"y\"\n", "");
    assert_eq!(refused(&ball, RobotFormat::Urdf).1, "joint 'cross' is spherical, which URDF does not know");
    assert!(exported(&read(&ball), RobotFormat::Mjcf).text.contains("type=\"ball\""));
    let loose = OFFSETS.replace("[joint.seat]\nkind = \"rigid\"\nbearing = \"plate.h\"\njournal = \"hand.o\"\n", "");
    assert_eq!(refused(&loose, RobotFormat::Mjcf).1, "body 'hand' is connected with the ground by no joint");
    let guided = imported("four_bar.xml", FOUR_BAR)
        .model
        .replace("kind = \"spherical\"", "kind = \"cylindrical\"\naxis = \"-y\"");
    let (_, message) = refused(&guided, RobotFormat::Mjcf);
    assert_eq!(message, "joint 'ball' is cylindrical and closes a loop, which MJCF does not know");
}

//! URDF.

use crate::matrices::{Matrix, about, about_x, about_y, about_z, chain, difference, moved, turned};
use crate::{ROUND_OFF, imported, model_of, pose_of, position};
use loosepin_space::{SpatialModel, Vec3};
use std::f64::consts::FRAC_PI_2;

pub const PUMA: &str = include_str!("puma560.urdf");
const TWO_AXES: &str = include_str!("../../../../docs/examples/two-axis-arm.urdf");

/// Corke and Armstrong-Hélouvry, ICRA 1994, table 1: a, alpha, d.
const PARAMETERS: [[f64; 3]; 6] = [
    [0.0, FRAC_PI_2, 0.0],
    [0.4318, 0.0, 0.0],
    [0.0203, -FRAC_PI_2, 0.15005],
    [0.0, FRAC_PI_2, 0.4318],
    [0.0, -FRAC_PI_2, 0.0],
    [0.0, 0.0, 0.0],
];

pub const POSES: [[f64; 6]; 4] =
    [[0.0; 6], [0.3, -1.1, 0.7, 2.2, -0.4, 1.9], [-2.4, 0.6, 1.8, -0.9, 1.2, -2.8], [1.1, 1.57, -1.57, 0.1, -1.3, 3.0]];

/// The flange of the arm: the product of Rz(θ) Tz(d) Tx(a) Rx(alpha) of all joints.
pub fn flange(angles: [f64; 6]) -> Matrix {
    let links = angles.iter().zip(PARAMETERS);
    let factors = links.map(|(angle, [a, alpha, d])| {
        chain(&[about_z(*angle), moved(0.0, 0.0, d), moved(a, 0.0, 0.0), about_x(alpha)])
    });
    chain(&factors.collect::<Vec<_>>())
}

#[test]
fn published_arm_stands_where_its_parameters_say() {
    let model = model_of(PUMA);
    assert_eq!(model.drives.len(), 6);
    for angles in POSES {
        let (_, position) = position(&model, &angles);
        let found = difference(pose_of(&model, &position, "flange"), flange(angles));
        assert!(found < ROUND_OFF, "{angles:?}: {found:e}");
    }
}

/// A chain with turned frames and skew axes: origin, roll, pitch, yaw, axis, type.
type Row = ([f64; 3], [f64; 3], [f64; 3], &'static str);

const CHAIN: [Row; 5] = [
    ([0.11, -0.23, 0.37], [0.4, -1.2, 2.6], [0.6, 0.0, 0.8], "continuous"),
    ([-0.31, 0.17, 0.05], [-2.1, 0.3, -0.7], [1.0, -2.0, 2.0], "prismatic"),
    ([0.02, 0.41, -0.13], [1.57, 1.571, 0.2], [0.0, -1.0, 0.0], "continuous"),
    ([0.29, 0.07, 0.19], [3.0, -0.9, 1.1], [-0.3, 0.4, 0.2], "revolute"),
    ([0.03, -0.05, 0.27], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], "revolute"),
];

fn chain_text() -> String {
    let words = |numbers: [f64; 3]| numbers.map(|number| number.to_string()).join(" ");
    let mut text = "<robot name='chain'><link name='l0'/>".to_owned();
    for (number, (origin, turns, axis, kind)) in CHAIN.into_iter().enumerate() {
        text += &format!(
            "<link name='l{}'/><joint name='j{number}' type='{kind}'><origin xyz='{}' rpy='{}'/><parent link='l{number}'/>\
             <child link='l{}'/><axis xyz='{}'/><limit lower='-3' upper='3'/></joint>",
            number + 1,
            words(origin),
            words(turns),
            number + 1,
            words(axis)
        );
    }
    text + "</robot>"
}

#[test]
fn analytic_chain_of_skew_axes() {
    let model = model_of(&chain_text());
    for values in [[0.0; 5], [0.7, -0.2, 1.4, -0.5, 2.1], [-1.9, 0.6, 0.3, 2.8, -1.2]] {
        let factors: Vec<Matrix> = CHAIN
            .iter()
            .zip(values)
            .flat_map(|(([x, y, z], [roll, pitch, yaw], axis, kind), value)| {
                let own = if *kind == "prismatic" {
                    let length = axis.iter().map(|component| component * component).sum::<f64>().sqrt();
                    moved(value * axis[0] / length, value * axis[1] / length, value * axis[2] / length)
                } else {
                    about(*axis, value)
                };
                [moved(*x, *y, *z), about_z(*yaw), about_y(*pitch), about_x(*roll), own]
            })
            .collect();
        let (_, position) = position(&model, &values);
        let found = difference(pose_of(&model, &position, "l5"), chain(&factors));
        assert!(found < ROUND_OFF, "{values:?}: {found:e}");
    }
}

fn inertia(model: &SpatialModel, body: &str) -> [[f64; 3]; 3] {
    let own = model.bodies.iter().find(|own| own.name == body).unwrap();
    let value = |number: usize| own.inertia_kg_m2.get(number).map_or(0.0, |id| model.quantities.nominal_value(*id));
    let [xx, yy, zz, xy, xz, yz] = [0, 1, 2, 3, 4, 5].map(value);
    [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
}

#[test]
fn analytic_inertia_is_turned_into_the_axes_of_the_link() {
    // About y by b: xx = c² ixx + s² izz, zz = s² ixx + c² izz, xz = s c (izz - ixx).
    let model = model_of(TWO_AXES);
    let (s, c) = (-0.5235987755982988_f64).sin_cos();
    let found = inertia(&model, "forearm");
    let due = [
        [c * c * 0.0009 + s * s * 0.03, 0.0, s * c * (0.03 - 0.0009)],
        [0.0, 0.03, 0.0],
        [s * c * (0.03 - 0.0009), 0.0, s * s * 0.0009 + c * c * 0.03],
    ];
    for (found, due) in found.iter().flatten().zip(due.iter().flatten()) {
        assert!((found - due).abs() < 1e-15, "{found} {due}");
    }
    let [mass, centre] = [("forearm", 1.4), ("column", 3.2)].map(|(name, mass)| {
        let body = model.bodies.iter().find(|own| own.name == name).unwrap();
        assert_eq!(body.mass_kg.map(|id| model.quantities.nominal_value(id)), Some(mass));
        body.centre_of_mass_m.unwrap().map(|id| model.quantities.nominal_value(id))
    });
    assert!((Vec3::from(mass) - Vec3::new(0.2165063509461097, 0.0, 0.125)).length() < 1e-16);
    assert_eq!(centre, [0.0, 0.0, 0.15]);
}

#[test]
fn analytic_full_inertia_in_a_turned_frame() {
    let (turns, moments) = ([0.4, -1.2, 2.6], [[0.7, 0.05, -0.02], [0.05, 0.9, 0.11], [-0.02, 0.11, 0.6]]);
    let text = "<robot name='r'><link name='b'/><link name='l'><inertial><origin rpy='0.4 -1.2 2.6'/><mass value='2'/>\
        <inertia ixx='0.7' iyy='0.9' izz='0.6' ixy='0.05' ixz='-0.02' iyz='0.11'/></inertial></link>\
        <joint name='j' type='continuous'><parent link='b'/><child link='l'/></joint></robot>";
    let rotation = chain(&[about_z(turns[2]), about_y(turns[1]), about_x(turns[0])]);
    let (found, due) = (inertia(&model_of(text), "l"), turned(rotation, moments));
    for (found, due) in found.iter().flatten().zip(due.iter().flatten()) {
        assert!((found - due).abs() < 4.0 * f64::EPSILON, "{found} {due}");
    }
}

#[test]
fn what_is_read_can_be_moved_and_given_play() {
    let own = imported("two-axis-arm.urdf", TWO_AXES);
    assert_eq!(
        own.notes,
        [
            "3 moving links, 3 joints",
            "the root link 'base' is the ground",
            "1 shape of links, with their meshes, ignored: a model has points and axes",
        ]
    );
    // Each bearing of 0.05 mm and 20 mm leans by 5 mrad; the ends of its journal move by 0.05 mm.
    let with_play =
        own.model.replace("# radial", "radial").replace("# bearing_l", "bearing_l").replace("# axial", "axial");
    assert_ne!(with_play, own.model);
    for (text, is_zero) in [(&own.model, true), (&with_play, false)] {
        let model = SpatialModel::from_text("model.toml", text).unwrap_or_else(|found| panic!("{found}"));
        assert!(model.warnings.is_empty());
        let record = model.motion_record(&model.quantities.nominal()).unwrap_or_else(|found| panic!("{found}"));
        assert_eq!(record.drive_angle_rad.len(), 37);
        assert_eq!(record.picture.joints.iter().any(|joint| joint.has_play), !is_zero);
        for output in &record.outputs {
            let largest = output.clearance.first_order_si.iter().fold(0.0_f64, |largest, value| largest.max(*value));
            assert_eq!(largest == 0.0, is_zero, "{}: {largest}", output.name);
        }
        // A whole turn of the column turns the tool by as much.
        let turn = &record.outputs[1];
        assert_eq!(turn.name, "turn_of_tool");
        let whole = turn.value_si[36] - turn.value_si[0];
        assert!((whole - std::f64::consts::TAU).abs() < 1e-9, "{whole}");
    }
}

#[test]
fn limited_joints_sweep_their_limits_and_held_ones_stay_within() {
    let text = |first: &str, second: &str| {
        format!(
            "<robot name='r'><link name='b'/><link name='l'/><link name='m'/>\
             <joint name='j' type='revolute'><parent link='b'/><child link='l'/>{first}</joint>\
             <joint name='k' type='prismatic'><parent link='l'/><child link='m'/>{second}</joint></robot>"
        )
    };
    let model = imported("r.urdf", &text("<limit lower='-0.5' upper='1'/>", "<limit lower='0.02' upper='0.3'/>")).model;
    for line in [
        "[drive.j]\n# limits of the description: -0.5 rad to 1 rad\njoint = \"j\"\n\
         speed = \"1.5 rad/s\"\nstart_angle = \"-0.5 rad\"\n",
        "[drive.k]\n# limits of the description: 20 to 300 mm\njoint = \"k\"\nspeed = \"0 mm/s\"\nstart_position = \"20 mm\"\n",
        "[cycle]\nduration = \"1 s\"\n",
    ] {
        assert!(model.contains(line), "{line}\n{model}");
    }
}

#[test]
fn names_become_valid_and_stay_apart() {
    let text = "<robot name='two \"arms\"'><link name='world'/><link name='left arm'/><link name='left_arm'/><link name='ground'/>\
        <joint name='1' type='continuous'><parent link='world'/><child link='left arm'/></joint>\
        <joint name='j.2' type='continuous'><origin xyz='1 0 0'/><parent link='left arm'/><child link='left_arm'/></joint>\
        <joint name='j_2' type='continuous'><parent link='left_arm'/><child link='ground'/></joint></robot>";
    let own = imported("r.urdf", text);
    let model = model_of(text);
    let names: Vec<&str> = model.bodies.iter().map(|body| body.name.as_str()).collect();
    assert_eq!(names, ["ground", "left_arm", "left_arm_2", "ground_2"]);
    let names: Vec<&str> = model.joints.iter().map(|joint| joint.name.as_str()).collect();
    assert_eq!(names, ["_1", "j_2", "j_2_2"]);
    assert_eq!(model.name, "two \"arms\"");
    for note in ["'left arm' is called left_arm", "'j.2' is called j_2", "'ground' is called ground_2"] {
        assert!(own.notes.iter().any(|own| own == note), "{note}: {:?}", own.notes);
    }
}

#[test]
fn inertias_of_no_body_are_comments() {
    let text = |moments: &str| {
        format!(
            "<robot name='r'><link name='b'/><link name='l'><inertial><mass value='0'/><inertia {moments}/></inertial></link>\
             <joint name='j' type='continuous'><parent link='b'/><child link='l'/></joint></robot>"
        )
    };
    let heavy = imported("r.urdf", &text("ixx='1' iyy='1' izz='2.1' ixy='0' ixz='0' iyz='0'"));
    assert!(heavy.model.contains("\n# inertia = [\"1 kg m^2\", \"1 kg m^2\", \"2.1 kg m^2\"]   # of no body\n"));
    assert!(
        heavy.notes.iter().any(|note| note.starts_with("the inertia of link 'l' is of no body")),
        "{:?}",
        heavy.notes
    );
    let none = imported("r.urdf", &text("ixx='0' iyy='0' izz='0' ixy='0' ixz='0' iyz='0'"));
    assert!(!none.model.contains("inertia =") && !none.model.contains("mass ="), "{}", none.model);
}

#[test]
fn joints_that_nothing_drives_are_named() {
    let text = "<robot name='r'><link name='b'/><link name='l'/><joint name='table' type='planar'><parent link='b'/><child link='l'/>\
        <axis xyz='0 0 1'/></joint></robot>";
    let own = imported("r.urdf", text);
    let due = "no drive can hold joint 'table': it moves freely, so that the motion is not determined";
    assert!(own.notes.iter().any(|note| note == due), "{:?}", own.notes);
    assert!(own.model.contains("kind = \"planar\"") && !own.model.contains("[cycle]"));
    let mimic = "<robot name='r'><link name='b'/><link name='l'/><link name='m'/><joint name='a' type='continuous'><parent link='b'/>\
        <child link='l'/></joint><joint name='c' type='continuous'><parent link='b'/><child link='m'/><mimic joint='a'/></joint></robot>";
    assert!(imported("r.urdf", mimic).model.contains("[joint.c]\n# follows a in the description\n"));
}

#[test]
fn the_joint_that_moves_is_on_the_way_to_the_tool() {
    let joint = |name: &str, parent: &str, child: &str| {
        format!("<joint name='{name}' type='continuous'><parent link='{parent}'/><child link='{child}'/></joint>")
    };
    let links = ["b", "wheel", "arm", "hand"].map(|name| format!("<link name='{name}'/>")).concat();
    let joints = joint("drive", "b", "wheel") + &joint("shoulder", "b", "arm") + &joint("wrist", "arm", "hand");
    let model = imported("r.urdf", &format!("<robot name='r'>{links}{joints}</robot>")).model;
    assert!(model.contains("[cycle]\ndrive = \"shoulder\"\n"), "{model}");
    assert!(model.contains("[drive.drive]\njoint = \"drive\"\nspeed = \"0 deg/s\"\n"), "{model}");
}

//! MJCF.

use crate::matrices::{Matrix, about, about_x, about_y, about_z, chain, difference, moved};
use crate::urdf::{POSES, flange};
use crate::{ROUND_OFF, imported, model_of, pose_of, position};
use loosepin_space::{SpatialModel, mobility};

pub const PUMA: &str = include_str!("puma560.xml");

#[test]
fn published_arm_stands_where_its_parameters_say() {
    let model = model_of(PUMA);
    assert_eq!(model.drives.len(), 6);
    for angles in POSES {
        let (_, position) = position(&model, &angles);
        let found = difference(pose_of(&model, &position, "flange"), flange(angles));
        assert!(found < ROUND_OFF, "{angles:?}: {found:e}");
    }
    let text = imported("puma560.xml", PUMA).model;
    assert!(text.contains("gravity = [\"0 m/s^2\", \"0 m/s^2\", \"-9.81 m/s^2\"]"));
    // The range of its class; of the class that the last one names instead there is none.
    assert_eq!(text.matches("# limits of the description: -200 deg to 200 deg").count(), 2);
    assert!(text.contains("tip = [\"0 mm\", \"0 mm\", \"50 mm\"]"));
}

/// A body on the ground with a turn, and what `<compiler>` says of it.
fn turned(compiler: &str, turn: &str) -> Matrix {
    let text = format!(
        "<mujoco><compiler {compiler}/><worldbody><body name='b' pos='0.1 0.2 0.3' {turn}/></worldbody></mujoco>"
    );
    let model = model_of(&text);
    let (_, position) = position(&model, &[]);
    pose_of(&model, &position, "b")
}

#[test]
fn analytic_turns_of_all_forms() {
    let at = moved(0.1, 0.2, 0.3);
    let (a, b, c) = (20.0_f64.to_radians(), -70.0_f64.to_radians(), 140.0_f64.to_radians());
    let half = 0.5 * 1.3_f64;
    let quat = format!("quat='{} 0 {} {}'", 2.0 * half.cos(), 2.0 * half.sin() * 0.6, 2.0 * half.sin() * 0.8);
    for (compiler, turn, due) in [
        ("", "euler='20 -70 140'", chain(&[about_x(a), about_y(b), about_z(c)])),
        ("eulerseq='XYZ'", "euler='20 -70 140'", chain(&[about_z(c), about_y(b), about_x(a)])),
        ("eulerseq='zyx'", "euler='20 -70 140'", chain(&[about_z(a), about_y(b), about_x(c)])),
        // The first about z of the frame, the second about y of the parent, the third about x of the frame.
        ("eulerseq='zYx'", "euler='20 -70 140'", chain(&[about_y(b), about_z(a), about_x(c)])),
        ("angle='radian'", "euler='0.3 0.4 0.5'", chain(&[about_x(0.3), about_y(0.4), about_z(0.5)])),
        ("", "axisangle='1 -2 2 140'", about([1.0, -2.0, 2.0], c)),
        ("", quat.as_str(), about([0.0, 0.6, 0.8], 1.3)),
        // z to (1, 0, 0): a quarter of a turn about y.
        ("", "zaxis='3 0 0'", about_y(std::f64::consts::FRAC_PI_2)),
        ("", "zaxis='0 0 -1'", about_x(std::f64::consts::PI)),
        ("", "zaxis='0 -0.6 0.8'", about_x(0.6_f64.asin())),
        // x along the first; the second is made perpendicular.
        ("", "xyaxes='0 2 0 -1 5 0'", about_z(std::f64::consts::FRAC_PI_2)),
    ] {
        let found = difference(turned(compiler, turn), chain(&[at, due]));
        assert!(found < ROUND_OFF, "{compiler} {turn}: {found:e}");
    }
}

#[test]
fn analytic_joints_of_one_body_are_a_chain() {
    let text = "<mujoco><compiler angle='radian'/><worldbody><body name='carrier' pos='0 0.5 0'>
        <frame pos='0.2 0 0' euler='0 0 0.4'>
          <body name='tool' pos='0.1 -0.2 0.3' euler='0.5 0.1 -0.2'>
            <joint name='along' type='slide' axis='0 0.6 0.8' pos='9 9 9'/>
            <frame pos='0 0.05 0'><joint name='first' axis='1 2 -2' pos='0.04 0 0.02'/></frame>
            <joint name='second' axis='0 1 0' pos='0 0.03 -0.06'/>
          </body>
        </frame>
      </body></worldbody></mujoco>";
    let own = imported("r.xml", text);
    assert!(
        own.notes.iter().any(|note| note == "2 links without mass between the joints of one body"),
        "{:?}",
        own.notes
    );
    let model = model_of(text);
    let names: Vec<&str> = model.bodies.iter().map(|body| body.name.as_str()).collect();
    assert_eq!(names, ["ground", "carrier", "tool_along", "tool_first", "tool"]);
    for [slide, first, second] in [[0.0; 3], [0.3, 1.2, -0.7], [-0.1, -2.5, 1.9]] {
        let turn = |at: [f64; 3], axis: [f64; 3], angle: f64| {
            chain(&[moved(at[0], at[1], at[2]), about(axis, angle), moved(-at[0], -at[1], -at[2])])
        };
        let due = chain(&[
            moved(0.0, 0.5, 0.0),
            moved(0.2, 0.0, 0.0),
            about_z(0.4),
            moved(0.1, -0.2, 0.3),
            about_x(0.5),
            about_y(0.1),
            about_z(-0.2),
            moved(0.0, 0.6 * slide, 0.8 * slide),
            turn([0.04, 0.05, 0.02], [1.0, 2.0, -2.0], first),
            turn([0.0, 0.03, -0.06], [0.0, 1.0, 0.0], second),
        ]);
        let (_, position) = position(&model, &[slide, first, second]);
        let found = difference(pose_of(&model, &position, "tool"), due);
        assert!(found < ROUND_OFF, "{found:e}");
    }
}

#[test]
fn classes_inherit_and_nearer_ones_count() {
    let text = "<mujoco><default class='all'><joint axis='1 0 0' range='-10 10'/>
          <default class='arm'><joint axis='0 1 0'/><default class='hand'><joint type='slide'/></default></default>
          <default class='other'><joint axis='0 0 1' limited='false'/></default></default>
        <worldbody><body name='a' childclass='arm'><joint name='of_arm'/>
          <body name='b'><joint name='of_hand' class='hand' range='-0.1 0.2'/>
          <frame childclass='other'><body name='c'><joint name='of_other'/></body></frame>
          <body name='d'><joint name='of_all' class='all'/></body></body></body></worldbody></mujoco>";
    let text = imported("r.xml", text).model;
    for part in [
        "[joint.of_arm]\nkind = \"revolute\"\nbearing = \"ground.o\"\njournal = \"a.o\"\naxis = \"y\"\n",
        "[joint.of_hand]\nkind = \"prismatic\"\nbearing = \"a.o\"\njournal = \"b.o\"\naxis = \"y\"\n",
        "[joint.of_other]\nkind = \"revolute\"\nbearing = \"b.o\"\njournal = \"c.o\"\naxis = \"z\"\n",
        "[joint.of_all]\nkind = \"revolute\"\nbearing = \"b.o\"\njournal = \"d.o\"\naxis = \"x\"\n",
        "[drive.of_arm]\n# limits of the description: -10 deg to 10 deg\n",
        "[drive.of_hand]\n# limits of the description: -100 to 200 mm\n",
        "[drive.of_other]\njoint",
    ] {
        assert!(text.contains(part), "{part}\n{text}");
    }
}

/// Mass, centre and inertia of the only body.
fn mass(inside: &str) -> ([f64; 4], [f64; 6]) {
    let text = format!("<mujoco><worldbody><body name='b'><joint/>{inside}</body></worldbody></mujoco>");
    let model = model_of(&text);
    let body = &model.bodies[1];
    let value = |id| model.quantities.nominal_value(id);
    let centre = body.centre_of_mass_m.unwrap().map(value);
    let moments = [0, 1, 2, 3, 4, 5].map(|number: usize| body.inertia_kg_m2.get(number).map_or(0.0, |id| value(*id)));
    ([value(body.mass_kg.unwrap()), centre[0], centre[1], centre[2]], moments)
}

fn assert_near(found: ([f64; 4], [f64; 6]), due: ([f64; 4], [f64; 6])) {
    let size = due.1.iter().fold(0.0_f64, |size, moment| size.max(moment.abs()));
    for (a, b) in found.0.iter().zip(due.0) {
        assert!((a - b).abs() < 1e-13 * (1.0 + b.abs()), "{found:?}\n{due:?}");
    }
    for (a, b) in found.1.iter().zip(due.1) {
        assert!((a - b).abs() < 1e-13 * size, "{found:?}\n{due:?}");
    }
}

#[test]
fn analytic_masses_of_geoms() {
    let pi = std::f64::consts::PI;
    let ball = 4.0 / 3.0 * pi * 0.027 * 1000.0;
    assert_near(
        mass("<geom size='0.3'/>"),
        ([ball, 0.0, 0.0, 0.0], [0.4 * ball * 0.09, 0.4 * ball * 0.09, 0.4 * ball * 0.09, 0.0, 0.0, 0.0]),
    );
    // Halves of the edges 0.1, 0.2, 0.3: m/12 of the squares of the edges.
    let (a, b, c) = (0.04, 0.16, 0.36);
    assert_near(
        mass("<geom type='box' size='0.1 0.2 0.3' mass='12' pos='1 2 3'/>"),
        ([12.0, 1.0, 2.0, 3.0], [b + c, a + c, a + b, 0.0, 0.0, 0.0]),
    );
    let ellipsoid = 4.0 / 3.0 * pi * 0.006 * 500.0;
    assert_near(
        mass("<geom type='ellipsoid' size='0.1 0.2 0.3' density='500'/>"),
        ([ellipsoid, 0.0, 0.0, 0.0], [ellipsoid * 0.026, ellipsoid * 0.02, ellipsoid * 0.01, 0.0, 0.0, 0.0]),
    );
    // Along x by its ends: radius 0.05, length 0.4, m (3 r² + l²)/12 across.
    let rod = pi * 0.0025 * 0.4 * 2000.0;
    let across = rod * (3.0 * 0.0025 + 0.16) / 12.0;
    assert_near(
        mass("<geom type='cylinder' fromto='0.1 0 0 0.5 0 0' size='0.05' density='2000'/>"),
        ([rod, 0.3, 0.0, 0.0], [rod * 0.00125, across, across, 0.0, 0.0, 0.0]),
    );
    // A capsule of radius 0.05 is a cylinder of 0.4 and two half balls, whose centres are 3/8 of the radius from their faces: 83/320 m r² about
    // an axis across through each.
    let (middle, half) = (pi * 0.0025 * 0.4 * 1000.0, 2.0 / 3.0 * pi * 0.000125 * 1000.0);
    let arm = 0.2 + 3.0 / 8.0 * 0.05;
    let across = middle * (3.0 * 0.0025 + 0.16) / 12.0 + 2.0 * half * (83.0 / 320.0 * 0.0025 + arm * arm);
    let along = middle * 0.00125 + 2.0 * half * 0.001;
    assert_near(
        mass("<geom type='capsule' size='0.05 0.2' euler='90 0 0'/>"),
        ([middle + 2.0 * half, 0.0, 0.0, 0.0], [across, along, across, 0.0, 0.0, 0.0]),
    );
    // Two points, nearly: m d²/2 about axes across (1, 1, 0)/√2, with the product of inertia.
    let two = "<geom size='0.001' mass='2' pos='0.3 0.3 0'/><geom size='0.001' mass='2' pos='-0.3 -0.3 0'/><geom type='mesh' mesh='m' mass='0'/>";
    let own = 2.0 * 0.4 * 2.0 * 1e-6;
    assert_near(mass(two), ([4.0, 0.0, 0.0, 0.0], [0.36 + own, 0.36 + own, 0.72 + own, -0.36, 0.0, 0.0]));
}

#[test]
fn inertial_counts_before_geoms_and_meshes_leave_no_mass() {
    let full = "<inertial pos='0 0 0.1' mass='2' fullinertia='0.3 0.4 0.5 0.01 0.02 0.03'/><geom size='1'/>";
    assert_near(mass(full), ([2.0, 0.0, 0.0, 0.1], [0.3, 0.4, 0.5, 0.01, 0.02, 0.03]));
    // About z by 30 degrees: xx = c² a + s² b, xy = s c (a - b).
    let turned = "<inertial pos='0 0 0' euler='0 0 30' mass='1' diaginertia='0.3 0.5 0.7'/>";
    let (s, c) = 30.0_f64.to_radians().sin_cos();
    let due = [c * c * 0.3 + s * s * 0.5, s * s * 0.3 + c * c * 0.5, 0.7, s * c * -0.2, 0.0, 0.0];
    assert_near(mass(turned), ([1.0, 0.0, 0.0, 0.0], due));
    let text = "<mujoco><asset><mesh name='m' file='m.stl'/></asset><worldbody><body name='b'><joint/><geom type='mesh' mesh='m'/></body></worldbody></mujoco>";
    let own = imported("r.xml", text);
    assert!(own.notes.iter().any(|note| note == "no mass of 'b': meshes are not read"), "{:?}", own.notes);
    assert!(!own.model.contains("mass ="));
}

/// A four-bar in the plane of x and z: crank (0, 0) to (0.06, 0.08), coupler to (0.36, 0.3), rocker from (0.4, 0).
pub const FOUR_BAR: &str = "<mujoco model='four-bar'><worldbody>
    <body name='crank'><joint name='crank' axis='0 -1 0'/>
      <body name='coupler' pos='0.06 0 0.08'><joint name='pin' axis='0 -1 0'/></body></body>
    <body name='rocker' pos='0.4 0 0'><joint name='pivot' axis='0 -1 0'/></body>
  </worldbody>
  <equality><connect name='ball' body1='coupler' body2='rocker' anchor='0.3 0 0.22'/></equality>
  <actuator><motor joint='crank'/></actuator></mujoco>";

/// The turn of the rocker from where it is drawn: C is on circles about B and about D, on the side on which it is drawn.
pub fn rocker(crank_rad: f64) -> f64 {
    let (s, c) = crank_rad.sin_cos();
    let b = [0.06 * c - 0.08 * s, 0.06 * s + 0.08 * c];
    let (coupler, rocker) = ((0.3_f64 * 0.3 + 0.22 * 0.22).sqrt(), (0.04_f64 * 0.04 + 0.3 * 0.3).sqrt());
    let (dx, dz) = (b[0] - 0.4, b[1]);
    let distance = dx.hypot(dz);
    let cosine = (rocker * rocker + distance * distance - coupler * coupler) / (2.0 * rocker * distance);
    dz.atan2(dx) - cosine.acos() - 0.3_f64.atan2(-0.04)
}

#[test]
fn analytic_four_bar_closes() {
    assert!(rocker(0.0).abs() < 1e-15, "{}", rocker(0.0));
    let own = imported("four_bar.xml", FOUR_BAR);
    let model = model_of(FOUR_BAR);
    assert_eq!(own.notes, ["3 moving links, 4 joints"]);
    assert_eq!(model.drives.iter().map(|drive| drive.name.as_str()).collect::<Vec<_>>(), ["crank"]);
    for angle in [0.0, 0.4, -1.3, 2.0, 3.0] {
        let (mechanism, position) = position(&model, &[angle]);
        let due = chain(&[moved(0.4, 0.0, 0.0), about_y(-rocker(angle))]);
        let found = difference(pose_of(&model, &position, "rocker"), due);
        assert!(found < ROUND_OFF, "{angle}: {found:e}");
        let found = mobility(&mechanism, &position);
        assert_eq!((found.degrees_of_freedom, found.undriven_freedoms, found.repeated_drives), (1, 0, 0));
    }
    // Without its motor the first joint that repeats nothing.
    let passive = model_of(&FOUR_BAR.replace("<motor joint='crank'/>", ""));
    assert_eq!(passive.drives.len(), 1);
    let record = model.motion_record(&model.quantities.nominal()).unwrap();
    assert_eq!(record.drive_angle_rad.len(), 37);
}

#[test]
fn welds_and_sites_close_loops() {
    let sites = FOUR_BAR
        .replace(
            "<joint name='pin' axis='0 -1 0'/>",
            "<joint name='pin' axis='0 -1 0'/><site name='c1' pos='0.3 0 0.22'/>",
        )
        .replace(
            "<joint name='pivot' axis='0 -1 0'/>",
            "<joint name='pivot' axis='0 -1 0'/><site name='c2' pos='-0.04 0 0.3'/>",
        )
        .replace("body1='coupler' body2='rocker' anchor='0.3 0 0.22'", "site1='c1' site2='c2'");
    let model = model_of(&sites);
    let (_, found) = position(&model, &[1.1]);
    let due = chain(&[moved(0.4, 0.0, 0.0), about_y(-rocker(1.1))]);
    assert!(difference(pose_of(&model, &found, "rocker"), due) < ROUND_OFF);
    // The coupler welded to the rocker leaves a triangle.
    let welded = FOUR_BAR.replace("connect name='ball'", "weld name='seam'").replace(" anchor='0.3 0 0.22'", "");
    let own = imported("r.xml", &welded);
    assert!(own.model.contains("[joint.seam]\n# closes a loop\nkind = \"rigid\"\n"));
    let model = model_of(&welded);
    assert_eq!(model.drives.len(), 0);
    let off = imported("r.xml", &FOUR_BAR.replace("connect name", "connect active='false' name"));
    assert!(off.notes.iter().any(|note| note == "connect 'ball' is not active, and ignored"), "{:?}", off.notes);
    let other = imported("r.xml", &FOUR_BAR.replace("</equality>", "<joint joint1='pin' joint2='pivot'/></equality>"));
    let due = "<joint> is ignored: only connect and weld become joints";
    assert!(other.notes.iter().any(|note| note == due), "{:?}", other.notes);
    assert_eq!(SpatialModel::from_text("m", &other.model).unwrap().joints.len(), 4);
}

#[test]
fn analytic_coordinates_are_counted_from_their_references() {
    let text = "<mujoco><worldbody><body name='a' pos='0.1 0 0'><joint name='turn' axis='0 0 1' ref='30' range='-40 80'/>
        <body name='b' pos='0 0.2 0'><joint name='way' type='slide' axis='2 0 0' ref='0.05'/></body></body></worldbody></mujoco>";
    let model = model_of(text);
    for [turn, way] in [[30.0_f64, 0.05], [0.0, 0.0], [75.0, -0.12]] {
        let (_, position) = position(&model, &[turn.to_radians(), way]);
        let due = chain(&[
            moved(0.1, 0.0, 0.0),
            about_z((turn - 30.0).to_radians()),
            moved(0.0, 0.2, 0.0),
            moved(way - 0.05, 0.0, 0.0),
        ]);
        let found = difference(pose_of(&model, &position, "b"), due);
        assert!(found < ROUND_OFF, "{turn} {way}: {found:e}");
    }
    let text = imported("r.xml", text).model;
    assert!(
        text.contains("# limits of the description: -40 deg to 80 deg") && text.contains("start_position = \"50 mm\""),
        "{text}"
    );
}

#[test]
fn peer_poses_and_masses_of_all_forms() {
    // forms.py wrote the numbers.
    let model = model_of(include_str!("forms.xml"));
    let value = |id| model.quantities.nominal_value(id);
    let numbers = |words: &[&str]| words.iter().map(|word| word.parse().unwrap()).collect::<Vec<f64>>();
    let mut rows = 0;
    for line in include_str!("forms.csv").lines() {
        let words: Vec<&str> = line.split(',').collect();
        let (name, due) =
            if words[0] == "pose" { (words[6], numbers(&words[7..])) } else { (words[1], numbers(&words[2..])) };
        let found: Vec<f64> = if words[0] == "pose" {
            let (_, position) = position(&model, &numbers(&words[1..6]));
            let pose = pose_of(&model, &position, name);
            [3, 0, 1].iter().flat_map(|column| [pose[0][*column], pose[1][*column], pose[2][*column]]).collect()
        } else {
            let body = model.bodies.iter().find(|body| body.name == name).unwrap();
            let moment = |number: usize| body.inertia_kg_m2.get(number).map_or(0.0, |id| value(*id));
            let [mass, centre] =
                [vec![value(body.mass_kg.unwrap())], body.centre_of_mass_m.unwrap().map(value).to_vec()];
            [mass, centre, [0, 1, 2, 3, 4, 5].map(moment).to_vec()].concat()
        };
        assert_eq!(found.len(), due.len());
        for (found, due) in found.iter().zip(due) {
            assert!((found - due).abs() < ROUND_OFF, "{line}: {found}");
        }
        rows += 1;
    }
    assert_eq!(rows, 16);
}

#[test]
fn sites_without_a_name_are_left_out_with_a_note() {
    let text = PUMA.replace("<site name=", "<site pos='0 0 0.1'/><site pos='0 0 0.2'/><site name=");
    let note = |text: &str| imported("r.xml", text).notes.iter().find(|note| note.contains("site")).cloned();
    assert_eq!(note(&text).as_deref(), Some("2 sites without a name left out: points of a model have names"));
    assert_eq!(note(PUMA), None);
}

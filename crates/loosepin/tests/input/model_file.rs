//! Model files that are right: what is read, and how values are set.

use loosepin::model::{Axis, Derivative, JointKind, Model, Motion, OutputKind, Position, QuantityId, Revolute};

/// The sketch of the model file in the design of the project, with the bodies it leaves out.
const SKETCH: &str = include_str!("../files/sketch.toml");

fn sketch() -> Model {
    Model::from_text("sketch.toml", SKETCH).unwrap_or_else(|complaints| panic!("{complaints}"))
}

fn value(model: &Model, path: &str) -> f64 {
    model.quantities.nominal()[model.quantities.id(path).unwrap_or_else(|| panic!("no {path}"))]
}

#[test]
fn the_sketch_loads_in_file_order() {
    let model = sketch();
    assert_eq!(model.name, "worn pin");
    let bodies: Vec<&str> = model.bodies.iter().map(|body| body.name.as_str()).collect();
    assert_eq!(bodies, ["ground", "crank", "rod", "slider"]);
    let joints: Vec<&str> = model.joints.iter().map(|joint| joint.name.as_str()).collect();
    assert_eq!(joints, ["main", "crank_pin", "gudgeon", "guide"]);
    let outputs: Vec<&str> = model.outputs.iter().map(|output| output.name.as_str()).collect();
    assert_eq!(outputs, ["slider", "pin_force", "path"]);
    assert!(model.warnings.is_empty(), "{:?}", model.warnings);
}

#[test]
fn values_are_in_si() {
    let model = sketch();
    assert_eq!(value(&model, "parameter.crank_length"), 0.05);
    assert_eq!(value(&model, "body.crank.centre_of_mass.x"), 0.025);
    assert_eq!(value(&model, "joint.gudgeon.radial_clearance"), 0.0005);
    assert_eq!(value(&model, "contact.steel_pin.youngs_modulus"), 207e9);
    assert_eq!(value(&model, "contact.steel_pin.density"), 7800.0);
    // 5000 rpm is 5000 · 2π/60 rad/s; both ways of computing it round.
    const ROUNDING_RAD_S: f64 = 1e-12;
    let speed_rad_s = value(&model, "drive.crank.speed");
    assert!((speed_rad_s - 5000.0 * std::f64::consts::PI / 30.0).abs() < ROUNDING_RAD_S);
    // Defaults of the method are quantities like any other.
    assert_eq!(value(&model, "contact.steel_pin.minimum_impact_speed"), 1e-3);
    assert_eq!(value(&model, "contact.steel_pin.friction.lower_speed"), 1e-4);
    assert_eq!(value(&model, "contact.steel_pin.friction.upper_speed"), 1e-3);
    assert_eq!(value(&model, "joint.guide.slider.angle"), 0.0);
}

#[test]
fn topology_refers_to_quantities() {
    let model = sketch();
    let JointKind::Revolute(Revolute { bearing, clearance: Some(clearance), .. }) = &model.joints[2].kind else {
        panic!("the gudgeon is a revolute joint with clearance");
    };
    assert_eq!(model.bodies[bearing.body.0].points[bearing.point].name, "small_end");
    assert_eq!(model.quantities[clearance.radial_clearance_m].path, "joint.gudgeon.radial_clearance");
    let contact = &model.contacts[clearance.contact.0];
    assert_eq!(contact.law.name(), "lankarani-nikravesh");
    let [bearing, journal] = contact.law.materials().expect("stiffness from materials").youngs_modulus_pa;
    assert_eq!(bearing, journal);
    assert!(matches!(
        model.outputs[0].kind,
        OutputKind::Motion(Motion { of: Position::Point(_, Axis::X), derivative: Derivative::Position })
    ));
    assert_eq!(model.outputs[0].unit.text, "mm");
}

#[test]
fn expressions_follow_what_is_set() {
    let model = sketch();
    let crank_length = model.find("parameter.crank_length").expect("settable");
    let values = model.quantities.evaluate(&[(crank_length, 0.06)]).expect("possible");
    assert_eq!(values[model.quantities.id("body.crank.points.pin.x").expect("pin")], 0.06);
    assert_eq!(values[model.quantities.id("body.crank.centre_of_mass.x").expect("centre of mass")], 0.03);
    assert_eq!(model.quantities.evaluate(&[]).expect("nominal"), model.quantities.nominal());
}

#[test]
fn impossible_values_are_named() {
    let model = sketch();
    let refused = |path: &str, value_si: f64| {
        let id = model.find(path).unwrap_or_else(|error| panic!("{error}"));
        model.quantities.evaluate(&[(id, value_si)]).expect_err("impossible").to_string()
    };
    assert_eq!(
        refused("joint.gudgeon.radial_clearance", -5e-5),
        "joint 'gudgeon': radial clearance -0.05 mm; must be >= 0"
    );
    assert_eq!(
        refused("joint.gudgeon.radial_clearance", 0.0123),
        "joint 'gudgeon': radial clearance 12.3 mm; must be below joint 'gudgeon': bearing radius 10 mm"
    );
    assert_eq!(refused("body.rod.mass", 0.0), "body 'rod': mass 0 kg; must be > 0");
    assert_eq!(
        refused("contact.steel_pin.restitution", 1.01),
        "contact 'steel_pin': restitution 1.01; must be in (0, 1]"
    );
    assert_eq!(refused("body.rod.mass", f64::NAN), "body 'rod': mass NaN kg; must be finite");
}

#[test]
fn paths_that_cannot_be_set_say_why() {
    let model = sketch();
    let error = model.find("body.crank.points.pin.x").expect_err("an expression");
    assert_eq!(error.to_string(), "'body.crank.points.pin.x' is given by an expression and cannot be set");
    let complaint = model.parse_setting("body.crank.points.pin.x=3mm").expect_err("an expression");
    assert_eq!(complaint.hint.as_deref(), Some("it depends on 'parameter.crank_length'"));
    let complaint = model.parse_setting("joint.gudgeon.radial_clearence=0.3mm").expect_err("misspelt");
    assert_eq!(
        complaint.to_string(),
        "--set:1:1: error[E0405]: the model has no quantity 'joint.gudgeon.radial_clearence'\n\
         hint: did you mean 'joint.gudgeon.radial_clearance'?"
    );
}

#[test]
fn settings_are_checked_for_unit_dimension_and_rule() {
    let model = sketch();
    let setting = model.parse_setting("joint.gudgeon.radial_clearance=0.3mm").expect("right");
    assert_eq!((setting.id, setting.value_si), (model.find("joint.gudgeon.radial_clearance").expect("path"), 3e-4));
    let refused = |text: &str| model.parse_setting(text).expect_err("wrong").to_string();
    assert_eq!(
        refused("joint.gudgeon.radial_clearance=0.3"),
        "--set:1:32: error[E0303]: joint.gudgeon.radial_clearance is 0.3 without a unit; must be a length\nhint: for example 0.5 mm"
    );
    assert_eq!(
        refused("joint.gudgeon.radial_clearance=0.3 kg"),
        "--set:1:32: error[E0304]: joint.gudgeon.radial_clearance is a mass; must be a length\nhint: for example 0.5 mm"
    );
    assert_eq!(
        refused("joint.gudgeon.radial_clearance=-0.1 mm"),
        "--set:1:32: error[E0501]: joint 'gudgeon': radial clearance -0.1 mm; must be >= 0\n\
         hint: the radial clearance is radius of the hole minus radius of the pin"
    );
    assert_eq!(
        refused("joint.gudgeon.radial_clearance"),
        "--set:1:1: error[E0407]: 'joint.gudgeon.radial_clearance' is not written path=value\n\
         hint: for example --set joint.gudgeon.radial_clearance=0.3mm"
    );
    assert_eq!(
        refused("joint.gudgeon.radial_clearance=0.3 mn"),
        "--set:1:36: error[E0302]: 'mn' is not a known unit\nhint: did you mean 'mm'?"
    );
}

#[test]
fn places_are_kept_for_complaints_about_meaning() {
    let model = sketch();
    let line = |path: &str| model.place(path).map(|place| place.line_and_column());
    assert_eq!(line("joint.gudgeon"), Some((37, 8)));
    assert_eq!(line("joint.gudgeon.radial_clearance"), Some((42, 20)));
    assert_eq!(line("contact.steel_pin.minimum_impact_speed"), line("contact.steel_pin"));
    assert_eq!(line("joint.nowhere"), None);
}

#[test]
fn a_joint_with_zero_clearance_and_nothing_else_is_ideal() {
    let text = SKETCH.replace("journal = \"crank.main\"", "journal = \"crank.main\"\nradial_clearance = \"0 mm\"");
    let model = Model::from_text("zero.toml", &text).unwrap_or_else(|complaints| panic!("{complaints}"));
    assert!(matches!(model.joints[0].kind, JointKind::Revolute(Revolute { clearance: None, .. })));
    let complaint = model.parse_setting("joint.main.radial_clearance=0.1mm").expect_err("needs a contact");
    assert_eq!(
        complaint.to_string(),
        "--set:1:1: error[E0406]: 'joint.main.radial_clearance' cannot be set\n\
         hint: a joint with play needs bearing_radius and contact in the model file"
    );
}

#[test]
fn a_given_stiffness_has_the_unit_of_its_exponent() {
    let materials = "youngs_modulus = \"207 GPa\"\npoisson_ratio = 0.3";
    let text = SKETCH.replace(materials, "stiffness = \"6.6e10 N/m^1.5\"\nexponent = 1.5");
    let model = Model::from_text("given.toml", &text).unwrap_or_else(|complaints| panic!("{complaints}"));
    assert_eq!(value(&model, "contact.steel_pin.stiffness"), 6.6e10);
    assert!(model.find("contact.steel_pin.exponent").is_err());
    let wrong = SKETCH.replace(materials, "stiffness = \"6.6e10 N/m^1.5\"\nexponent = 1.4");
    let complaints = Model::from_text("wrong.toml", &wrong).expect_err("unit and exponent disagree");
    assert_eq!(
        complaints.to_string(),
        "wrong.toml:25:13: error[E0304]: contact 'steel_pin': stiffness is a value in N/m^1.5; must be a value in N/m^1.4\n\
         hint: its unit is N/m^1.4"
    );
}

#[test]
fn ids_are_in_table_order() {
    let model = sketch();
    for (index, (id, quantity)) in model.quantities.iter().enumerate() {
        assert_eq!(id, QuantityId(index));
        assert_eq!(model.quantities.id(&quantity.path), Some(id), "{} stands twice", quantity.path);
    }
}

#[test]
fn what_nothing_uses_is_warned_about() {
    let text = SKETCH.replace("[parameter]", "[parameter]\nspare = \"1 mm\"").replace(
        "[joint.main]",
        "[contact.brass]\nrestitution = 0.8\nstiffness = \"1e10 N/m^1.5\"\nexponent = 1.5\n[joint.main]",
    );
    let model = Model::from_text("unused.toml", &text).unwrap_or_else(|complaints| panic!("{complaints}"));
    let warnings: Vec<String> = model.warnings.iter().map(ToString::to_string).collect();
    assert_eq!(
        warnings,
        [
            "unused.toml:30:10: warning[E0408]: contact 'brass' is not used\nhint: changing it has no effect on the results",
            "unused.toml:4:1: warning[E0408]: parameter 'spare' is not used\nhint: changing it has no effect on the results",
        ]
    );
}

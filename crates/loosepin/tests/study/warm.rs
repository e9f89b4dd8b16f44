//! A study of a mechanism whose temperature is known roughly, against a closed form.

use crate::silent::run;
use loosepin::model::Model;
use loosepin::study::Study;

/// A crank of 80 mm; the file says that it is used at 30 K above its drawing.
const MODEL: &str = r#"
name = "warm crank"
gravity = "0 m/s^2"
temperature_rise = "room - 293 K"
[parameter]
room = "323 K"
[body.ground]
points = { o = ["0 mm", "0 mm"] }
[body.crank]
mass = "0.3 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["25 mm", "0 mm"]
points = { main = ["0 mm", "0 mm"], pin = ["80 mm", "0 mm"] }
thermal_expansion = "23 um/(m K)"
[joint.main]
kind = "revolute"
bearing = "ground.o"
journal = "crank.main"
[drive.crank]
joint = "main"
speed = "60 rpm"
start_angle = "0 deg"
[cycle]
drive = "crank"
[output.pin]
position_of = "crank.pin"
along = "x"
"#;

#[test]
fn analytic_bounds_of_a_roughly_known_temperature_count_from_the_drawing() {
    let text = "name = \"warm\"\nmodel = \"model.toml\"\n[sampling]\nouter = 16\n\
                [random]\n\"body.crank.points.pin.x\" = { uniform = { lower = \"79.99 mm\", upper = \"80.01 mm\" } }\n\
                [epistemic]\n\"parameter.room\" = { interval = [\"273 K\", \"353 K\"] }\n\
                [[ask]]\noutput = \"pin\"\nof = \"total\"\nposes = { crank = [\"60 deg\"] }\nstatistics = [\"mean\"]\n";
    let model = Model::from_text("model.toml", MODEL).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let study = Study::from_text("study.toml", text, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let result = run(&study).result;
    let [bound] = &result.bounds[..] else { panic!("one bound was asked for") };
    // The drawing is that of 0 K, neither that of the file's 30 K nor that of the middle of the interval, 20 K.
    let exact_m = [-20.0, 60.0].map(|rise_k| 0.08 * 23e-6 * rise_k * 60_f64.to_radians().cos());
    let width_m = exact_m[1] - exact_m[0];
    assert!((bound.lower.value_si - exact_m[0]).abs() < 1e-3 * width_m, "{exact_m:?} {bound:?}");
    assert!((bound.upper.value_si - exact_m[1]).abs() < 1e-3 * width_m, "{exact_m:?} {bound:?}");
    assert!(bound.lower.widened_si <= exact_m[0] + 1e-12 && bound.upper.widened_si >= exact_m[1] - 1e-12, "{bound:?}");
    // What is proven without dynamics counts from another mechanism than the drawing: it is not said beside these bands.
    assert!(!result.treatments.is_empty());
    assert!(result.treatments.iter().all(|own| own.proven_without_dynamics_si.is_none()), "{:?}", result.treatments);
}

/// A fit is stated for the drawing: that of warm parts follows from it.
#[test]
fn a_fit_of_a_warm_joint_is_that_of_its_drawing() {
    let text = loosepin::templates::find_template("slider-crank").expect("template").model;
    let warm = "thermal_expansion = \"12e-6 1/K\"\ntemperature_rise = \"60 K\"\nmass = ";
    let text = text
        .replacen("mass = ", warm, 1)
        .replace("[body.slider]\n", "[body.slider]\nthermal_expansion = \"23e-6 1/K\"\ntemperature_rise = \"40 K\"\n");
    let model = Model::from_text("model.toml", &text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let study = "name = \"warm\"\nmodel = \"model.toml\"\n[random]\n\
                 \"joint.gudgeon.radial_clearance\" = { fit = \"H7/f7\", diameter = \"20 mm\" }\n\
                 [[ask]]\noutput = \"slider\"\nof = \"total\"\nat = \"cycle\"\nstatistics = [\"mean\"]\n";
    let study = Study::from_text("study.toml", study, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let id = study.model.find("joint.gudgeon.radial_clearance").expect("a free number");
    let plays = study.model.play_from(id);
    assert_eq!(plays.len(), 1);
    assert_ne!(plays[0].quantity, id, "what runs see is the clearance of the warm parts");
    // What no body states for itself cannot be set for it.
    let hint = study
        .model
        .demand_planar()
        .expect("planar")
        .parse_setting("body.rod.temperature_rise=10K")
        .expect_err("the rod states none")
        .to_string();
    assert!(hint.contains("body 'rod' states no temperature_rise of its own"), "{hint}");
    // A temperature is no clearance.
    let rise = study.model.find("body.slider.temperature_rise").expect("a free number");
    assert_eq!(study.model.play_from(rise).len(), 0);
}

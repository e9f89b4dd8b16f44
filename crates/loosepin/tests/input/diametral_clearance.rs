//! A clearance that is stated on the diameter: one number inside, and no factor of two that is not told.

use loosepin::model::Model;
use loosepin::study::Study;
use loosepin::templates::find_template;
use loosepin::uncertainty::Distribution;

const DIAMETRAL: &str = "joint.gudgeon.diametral_clearance";
const RADIAL: &str = "joint.gudgeon.radial_clearance";

/// The slider-crank with other lines in place of that of the clearance.
fn template_with(clearance: &str) -> Result<Model, String> {
    let text = find_template("slider-crank").expect("template").model;
    let written = "radial_clearance = \"0.5 mm\" ";
    assert_eq!(text.matches(written).count(), 1);
    Model::from_text("model.toml", &text.replace(written, clearance)).map_err(|complaints| complaints.to_string())
}

fn model(clearance: &str) -> Model {
    template_with(clearance).unwrap_or_else(|complaints| panic!("{complaints}"))
}

fn study(model: Model, lines: &str) -> Result<Study, String> {
    let ask = "[[ask]]\noutput = \"slider\"\nof = \"total\"\nat = \"cycle\"\nstatistics = [\"mean\"]\n";
    let text = format!("name = \"on the diameter\"\nmodel = \"model.toml\"\n{lines}\n{ask}");
    Study::from_text("study.toml", &text, model).map_err(|complaints| complaints.to_string())
}

fn read(model: Model, lines: &str) -> Study {
    study(model, lines).unwrap_or_else(|complaints| panic!("{complaints}"))
}

/// The radial clearance of the gudgeon, m, where `path` is set.
fn radial_m(model: &Model, path: &str, value_m: f64) -> f64 {
    let values = model.quantities.evaluate(&[(model.find(path).expect("a free number"), value_m)]);
    values.expect("possible")[model.quantities.id(RADIAL).expect("one place for the clearance")]
}

#[test]
fn identity_a_diametral_clearance_is_the_same_joint_as_half_of_it_on_the_radius() {
    let [on_diameter, on_radius] = ["diametral_clearance = \"0.6 mm\"", "radial_clearance = \"0.3 mm\""].map(model);
    let of = |model: &Model| model.quantities.nominal()[model.quantities.id(RADIAL).expect("a clearance")];
    assert_eq!(of(&on_diameter).to_bits(), of(&on_radius).to_bits());
    // Halving is exact, so that all bits are the same for every value that is set.
    for radial in [1e-6, 0.3e-3, 0.123_456_789e-3] {
        assert_eq!(
            radial_m(&on_diameter, DIAMETRAL, 2.0 * radial).to_bits(),
            radial_m(&on_radius, RADIAL, radial).to_bits()
        );
    }
    let setting = on_diameter.parse_setting(&format!("{DIAMETRAL}=0.4mm")).expect("a setting");
    assert_eq!(setting.value_si, 0.4e-3);
    let range = on_diameter.parse_setting_range(&format!("{DIAMETRAL}=0.1mm..0.4mm")).expect("a range");
    assert_eq!([range.from_si, range.to_si], [0.1e-3, 0.4e-3]);
    assert_eq!(on_diameter.place(RADIAL).map(|place| place.line_and_column()), Some((55, 23)));
}

#[test]
fn a_diametral_clearance_by_a_parameter_is_set_by_the_parameter() {
    let text = find_template("slider-crank").expect("template").model;
    let text = text
        .replace("[parameter]", "[parameter]\nplay = \"0.2 mm\"")
        .replace("radial_clearance = \"0.5 mm\" ", "diametral_clearance = \"2 * play\" ");
    let model = Model::from_text("model.toml", &text).unwrap_or_else(|complaints| panic!("{complaints}"));
    assert_eq!(radial_m(&model, "parameter.play", 0.15e-3), 0.15e-3);
    let refused = model.find(DIAMETRAL).expect_err("an expression");
    assert_eq!(refused.to_string(), format!("'{DIAMETRAL}' is given by an expression and cannot be set"));
}

#[test]
fn analytic_a_fit_is_doubled_on_the_diameter() {
    const RELATIVE_TOLERANCE: f64 = 1e-12; // round-off of micrometres in metres
    let near = |found: f64, expected: f64| assert!((found / expected - 1.0).abs() < RELATIVE_TOLERANCE, "{found}");
    // 20 H7/g6: hole 0 to 21 µm, shaft -20 to -7 µm, so 7 to 41 µm on the diameter.
    let fit = "{ fit = \"H7/g6\", diameter = \"20 mm\" }";
    let written = || model("diametral_clearance = \"0.03 mm\"");
    let known = read(written(), &format!("[epistemic]\n\"{DIAMETRAL}\" = {fit}"));
    let [least, most] = [known.epistemic[0].variable.ends()[0], known.epistemic[0].variable.ends()[1]];
    near(least, 7e-6);
    near(most, 41e-6);
    let scattered = read(written(), &format!("[random]\n\"{DIAMETRAL}\" = {fit}"));
    near(scattered.random[0].variable.mean(), 24e-6);
    near(scattered.random[0].variable.standard_deviation(), (3.5e-6_f64.powi(2) + (13e-6_f64 / 6.0).powi(2)).sqrt());
    // A parameter is on the radius or on the diameter as the joint takes it.
    for (expression, times) in [
        ("radial_clearance = \"play\"", 1.0),
        ("radial_clearance = \"play / 2\"", 2.0),
        ("diametral_clearance = \"play\"", 2.0),
    ] {
        let text = find_template("slider-crank").expect("template").model;
        let text = text
            .replace("[parameter]", "[parameter]\nplay = \"0.03 mm\"")
            .replace("radial_clearance = \"0.5 mm\" ", &format!("{expression} "));
        let model = Model::from_text("model.toml", &text).unwrap_or_else(|complaints| panic!("{complaints}"));
        let study = read(model, &format!("[epistemic]\n\"parameter.play\" = {fit}"));
        near(study.epistemic[0].variable.ends()[1], times * 20.5e-6);
    }
}

#[test]
fn a_fit_of_what_is_neither_on_the_radius_nor_on_the_diameter_is_refused() {
    let text = find_template("slider-crank").expect("template").model;
    let text = text
        .replace("[parameter]", "[parameter]\nplay = \"0.03 mm\"")
        .replace("radial_clearance = \"0.5 mm\" ", "radial_clearance = \"play + 0.1 mm\" ");
    let model = Model::from_text("model.toml", &text).unwrap_or_else(|complaints| panic!("{complaints}"));
    let said = study(model, "[epistemic]\n\"parameter.play\" = { fit = \"H7/g6\", diameter = \"20 mm\" }");
    assert_eq!(
        said.expect_err("no clearance by itself"),
        "study.toml:4:22: error[E0623]: 'parameter.play' is neither the radial nor the diametral clearance of a joint; a fit gives only these\nhint: write a value with its tolerance instead"
    );
}

#[test]
fn analytic_the_loosest_fit_of_a_diametral_clearance_is_asked_on_the_diameter() {
    let lines = format!(
        "[random]\n\"parameter.rod_length\" = {{ normal = {{ mean = \"120 mm\", standard_deviation = \"0.02 mm\" }} }}\n\
         \"{DIAMETRAL}\" = {{ fit = \"H7/g6\", diameter = \"20 mm\" }}\n\
         [allow]\n\"{DIAMETRAL}\" = {{ fit = [\"H7/g6\", \"H8/f7\"], diameter = \"20 mm\" }}\n\
         [[require]]\noutput = \"slider\"\nof = \"total\"\nwithin = \"0.1 mm\"\nover = \"cycle\"\nprobability_at_least = 0.9\n"
    );
    let study = read(model("diametral_clearance = \"0.03 mm\""), &lines);
    // H8/f7 at 20 mm: hole 0 to 33 µm, shaft -41 to -20 µm.
    let fits = &study.allowances[0].fits;
    let clearances = fits.iter().map(|fit| fit.clearance_m.map(|end| (end * 1e6).round())).collect::<Vec<_>>();
    assert_eq!(clearances, [[7.0, 41.0], [20.0, 74.0]]);
    let Distribution::Normal { mean, .. } = &fits[1].scatter else { panic!("{:?}", fits[1].scatter) };
    assert!((mean / 47e-6 - 1.0).abs() < 1e-12, "{mean}");
}

#[test]
fn the_key_that_the_joint_does_not_state_is_never_taken_for_the_other() {
    let on_radius = model("radial_clearance = \"0.5 mm\" ");
    let on_diameter = model("diametral_clearance = \"1 mm\" ");
    let refused = |model: &Model, text: &str| model.parse_setting(text).expect_err("the other key").to_string();
    assert_eq!(
        refused(&on_radius, &format!("{DIAMETRAL}=0.6mm")),
        format!(
            "--set:1:1: error[E0405]: '{DIAMETRAL}' cannot be set: the model gives '{RADIAL}'\n\
             hint: set '{RADIAL}', with half the value"
        )
    );
    assert_eq!(
        refused(&on_diameter, &format!("{RADIAL}=0.3mm")),
        format!(
            "--set:1:1: error[E0405]: '{RADIAL}' cannot be set: the model gives '{DIAMETRAL}'\n\
             hint: set '{DIAMETRAL}', with twice the value"
        )
    );
    assert_eq!(
        refused(&on_radius, "joint.gudgeon.diameter_clearance=0.6mm"),
        format!(
            "--set:1:1: error[E0405]: the model has no quantity 'joint.gudgeon.diameter_clearance'\n\
             hint: did you mean '{RADIAL}'? It is half of the clearance on the diameter"
        )
    );
    let interval = |path: &str| format!("[epistemic]\n\"{path}\" = {{ interval = [\"0.1 mm\", \"0.5 mm\"] }}");
    assert_eq!(
        study(on_radius, &interval(DIAMETRAL)).expect_err("the other key"),
        format!(
            "study.toml:4:1: error[E0405]: '{DIAMETRAL}' cannot be set: the model gives '{RADIAL}'\n\
             hint: set '{RADIAL}', with half the value"
        )
    );
    let study = read(on_diameter, &interval(DIAMETRAL));
    assert_eq!(study.epistemic[0].variable.ends().to_vec(), [0.1e-3, 0.5e-3]);
}

#[test]
fn a_diametral_clearance_of_zero_is_an_ideal_joint_and_one_beyond_the_bearing_is_refused() {
    let text = find_template("slider-crank").expect("template").model;
    let text = text.replace("journal = \"crank.main\"", "journal = \"crank.main\"\ndiametral_clearance = \"0 mm\"");
    let ideal = Model::from_text("model.toml", &text).unwrap_or_else(|complaints| panic!("{complaints}"));
    assert!(ideal.joints[0].kind.play().is_none());
    let said = template_with("diametral_clearance = \"21 mm\" ").expect_err("the bearing has 20 mm");
    assert_eq!(
        said,
        "model.toml:55:23: error[E0502]: joint 'gudgeon': radial clearance 10.5 mm; must be below joint 'gudgeon': bearing \
         radius 10 mm\n\
         model.toml:54:18: note: it must be below this\n\
         hint: the radial clearance is radius of the hole minus radius of the pin"
    );
}

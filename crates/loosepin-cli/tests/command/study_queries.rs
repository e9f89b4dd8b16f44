//! Questions beyond bounds: contributors, small probabilities, and what may be loosened.

use super::command_line::Desk;
use serde_json::Value;

/// A fiftieth of a turn, so that thousands of runs take seconds; the slider departs linearly from the drawing.
const SHORT: &str = r#"
name = "a fiftieth of a turn"
model = "model.toml"
seed = 7

[cycle]
transient_turns = 0
recorded_turns = 0.02
samples_per_turn = 200

[sampling]
outer = 9
inner = 64
replicates = 4

[random]
"parameter.crank_length" = { normal = { mean = "50 mm", standard_deviation = "0.02 mm" } }
"parameter.rod_length" = { normal = { mean = "120 mm", standard_deviation = "0.03 mm" } }
"#;

fn summary(study: &str) -> Value {
    let desk = Desk::with_model("slider_crank_worn_pin");
    desk.write("study.toml", study);
    let said = desk.run(&["study", "study.toml", "--out", "out"]);
    assert!(said.status < 2, "{}", said.messages);
    assert!(said.output.contains("a fiftieth of a turn"));
    serde_json::from_str(&desk.read("out/summary.json")).expect("JSON")
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

#[test]
fn analytic_shares_of_a_linear_deviation() {
    /// Share of the variance: the slider moves by Δr cos θ + Δl (1 + O(λ²)) near the dead centre.
    const LINEAR_TOLERANCE: f64 = 0.01;
    /// Share of the variance: the errors of 1024 pairs of points.
    const MAX_ERROR: f64 = 0.1;
    let ask = "[[ask]]\noutput = \"slider\"\nof = \"dimensional\"\nposes = { crank = [\"5 deg\"] }\nstatistics = [\"contributors\"]\n";
    let result = summary(&format!("{}{ask}", SHORT.replace("inner = 64", "inner = 1024")));
    let found = &result["contributors"][0];
    for (place, (path, expected)) in
        [("parameter.rod_length", 9.0 / 13.0), ("parameter.crank_length", 4.0 / 13.0)].iter().enumerate()
    {
        let input = &found["random"][place];
        assert_eq!(input["paths"][0], *path);
        assert!((number(&input["quasi_static_share"]) - expected).abs() < LINEAR_TOLERANCE, "{input}");
        for share in [&input["first"], &input["total"]] {
            let error = number(&share["error"]);
            assert!(error < MAX_ERROR, "{input}");
            assert!((number(&share["centre"]) - expected).abs() < error + LINEAR_TOLERANCE, "{input}");
        }
    }
    // Nothing is unknown: the band is scatter, and of it 1 - √(1 - share) goes with each.
    let band = number(&found["band_width_si"]);
    assert!((band / (2.0 * 1.96 * 3.6e-5) - 1.0).abs() < 0.1, "{band}");
}

/// Squares of the effects of crank and rod by their standard deviations, mm: of the crank cos θ - λ sin²θ/√(1 - λ² sin²θ), of the rod
/// 1/√(1 - λ² sin²θ).
fn squares_mm2(crank_rad: f64) -> [f64; 2] {
    let (sine, cosine) = crank_rad.sin_cos();
    let ratio = 50.0 / 120.0;
    let root = (1.0 - (ratio * sine).powi(2)).sqrt();
    [0.02 * (cosine - ratio * sine * sine / root), 0.03 / root].map(|effect| effect * effect)
}

/// Shares of a study of the same deviation without runs for contributors, asked at `place`, where these are the squares of the effects.
fn check_shares_without_runs(place: &str, [of_crank, of_rod]: [f64; 2]) {
    /// Of the band: 1 - √(1 - share); over a turn a share is a sum over 72 positions, here over 3600.
    const TOLERANCE: f64 = 1e-4;
    let ask = format!("[[ask]]\noutput = \"slider\"\nof = \"dimensional\"\n{place}\nstatistics = [\"mean\"]\n");
    let result = summary(&format!("{SHORT}{ask}"));
    let found = &result["contributors"][0];
    assert_eq!((&found["output"], &found["pairs"]), (&Value::from("slider"), &Value::from(0)));
    let whole = of_crank + of_rod;
    for (rank, (path, share)) in
        [("parameter.rod_length", of_rod / whole), ("parameter.crank_length", of_crank / whole)].into_iter().enumerate()
    {
        let input = &found["random"][rank];
        assert_eq!(input["paths"][0], path);
        assert_eq!(input["total"]["centre"], "nan", "no indices without runs: {input}");
        let expected = 1.0 - (1.0 - share).sqrt();
        assert!((number(&input["band_share"]) - expected).abs() < TOLERANCE, "{input}, not {expected}");
    }
    let purposes = result["counts"]["by_purpose"].as_array().expect("a list");
    assert!(purposes.iter().all(|part| part["purpose"] != "contributors"), "{purposes:?}");
}

#[test]
fn analytic_shares_at_a_pose_without_runs_for_them_are_those_of_the_pose() {
    // None of the 72 positions: 5.7 degrees.
    check_shares_without_runs("poses = { crank = [\"5.7 deg\"] }", squares_mm2(5.7_f64.to_radians()));
}

#[test]
fn analytic_shares_of_the_largest_deviation_without_runs_for_them_are_those_of_the_turn() {
    let over_the_turn = (0..3600).fold([0.0_f64; 2], |[crank, rod], k| {
        let [of_crank, of_rod] = squares_mm2(std::f64::consts::TAU * f64::from(k) / 3600.0);
        [crank + of_crank, rod + of_rod]
    });
    check_shares_without_runs("at = \"cycle\"", over_the_turn);
}

#[test]
fn analytic_a_small_probability_of_a_linear_deviation() {
    /// Of a probability near 2e-5, whose stated standard error is 5 %.
    const RELATIVE_TOLERANCE: f64 = 0.2;
    let ask = |method: &str| {
        format!(
            "{SHORT}[[ask]]\noutput = \"slider\"\nof = \"dimensional\"\nposes = {{ crank = [\"5 deg\"] }}\n\
             statistics = [\"standard_deviation\", {{ probability_above = \"0.15 mm\", method = \"{method}\" }}]\n"
        )
    };
    // Gradients at 5°: of the crank cos θ - λ sin²θ/√(1 - λ² sin²θ), of the rod 1/√(1 - λ² sin²θ).
    let (sine, cosine) = 5.0_f64.to_radians().sin_cos();
    let ratio = 50.0 / 120.0;
    let root = (1.0 - (ratio * sine).powi(2)).sqrt();
    let deviation_mm = (0.02 * (cosine - ratio * sine * sine / root)).hypot(0.03 / root);
    let expected = loosepin::uncertainty::normal_cdf(-0.15 / deviation_mm);
    for method in ["importance", "automatic"] {
        let result = summary(&ask(method));
        let end = &result["rare"][0]["upper"];
        let found = number(&end["probability"]);
        assert!((found / expected - 1.0).abs() < RELATIVE_TOLERANCE, "{method}: {end}, expected {expected}");
        assert!(number(&end["runs"]) < 20_000.0, "{method}: {end}");
        let bound = &result["bounds"][1]["upper"];
        assert_eq!(number(&bound["value_si"]), found);
        assert!(number(&bound["widened_si"]) > expected, "{method}: {bound}");
    }
}

#[test]
fn identity_direct_studies_agree_with_what_is_allowed() {
    let study = |upper: f64, allow: &str| {
        format!(
            "{SHORT}[epistemic]\n\"joint.gudgeon.radial_clearance\" = {{ interval = [\"0.1 mm\", \"{upper} m\"] }}\n\
             [[require]]\noutput = \"slider\"\nof = \"total\"\nwithin = \"0.3 mm\"\nover = \"cycle\"\nprobability_at_least = 0.9\n{allow}"
        )
    };
    let result = summary(&study(0.0002, "[allow]\n\"joint.gudgeon.radial_clearance\" = { up_to = \"0.6 mm\" }\n"));
    let found = &result["allowances"][0];
    let (allowed, beyond) = (number(&found["allowed_si"]), number(&found["beyond_si"]));
    assert!(allowed < beyond && beyond - allowed <= 1.001 * (6e-4 - 1e-4) / 128.0, "{found}");
    assert_eq!(summary(&study(allowed, ""))["requirements"][0]["verdict"], "met");
    // Beyond, one of the two sets of random numbers does not show it to be met.
    let is_beyond = |check: &&Value| number(&check["value_si"]) == beyond;
    let checks: Vec<&Value> = found["checks"].as_array().expect("checks").iter().filter(is_beyond).collect();
    assert!(checks.iter().any(|check| check["verdict"] != "met"), "{found}");
    assert!(checks.iter().any(|check| check["is_confirmation"] == true), "{found}");
}

#[test]
fn a_pose_that_is_not_recorded_is_refused() {
    let desk = Desk::with_model("slider_crank_worn_pin");
    let ask = |pose: &str| {
        format!(
            "[[ask]]\noutput = \"slider\"\nof = \"total\"\nposes = {{ crank = [\"{pose}\"] }}\nstatistics = [\"mean\"]\n"
        )
    };
    // A fiftieth of a turn is recorded, from 0.
    desk.write("study.toml", &format!("{SHORT}{}", ask("7.3 deg")));
    let said = desk.run(&["study", "study.toml", "--out", "out"]);
    assert_eq!(said.status, 2);
    let words = "output 'slider' is asked at 7.300000 deg; the recorded 0.02 turns do not pass there";
    assert!(said.messages.contains(words), "{}", said.messages);
    assert!(said.messages.contains("hint: record more turns"), "{}", said.messages);
    desk.write("study.toml", &format!("{SHORT}{}", ask("7.2 deg")));
    let said = desk.run(&["study", "study.toml", "--out", "out"]);
    assert_eq!(said.status, 0, "{}", said.messages);
}

#[test]
fn identity_the_cheapest_offers_meet_the_requirement() {
    let allow = "[allow]\n\"parameter.crank_length\" = { up_to = \"0.1 mm\", cost = [[\"0.01 mm\", 9], [\"0.03 mm\", 4], [\"0.09 mm\", 1]] }\n\
                 \"parameter.rod_length\" = { up_to = \"0.1 mm\", cost = [[\"0.01 mm\", 8], [\"0.03 mm\", 5], [\"0.08 mm\", 2]] }\n";
    let require = "[[require]]\noutput = \"slider\"\nof = \"dimensional\"\nwithin = \"0.12 mm\"\nover = \"cycle\"\nprobability_at_least = 0.9\n";
    let result = summary(&format!("{SHORT}{require}{allow}"));
    // P(|d| <= 0.12 mm) >= 0.9 needs a deviation of 0.073 mm, less for the sampling error: 0.09 or 0.08 mm are too much, 0.03 and
    // 0.03 together are 0.042 mm.
    let found = &result["allocation"];
    assert_eq!((number(&found["cost"]), &found["stop"]), (9.0, &Value::from("found")), "{found}");
    // Each combination that is refused takes one direct study or two, the one that is met two.
    assert!(number(&found["studies"]) >= 2.0, "{found}");
    let values: Vec<f64> =
        found["choices"].as_array().expect("choices").iter().map(|c| number(&c["value_si"])).collect();
    assert_eq!(values, [3e-5, 3e-5]);
}

/// A question, so that there is a study.
const ASK: &str = "[[ask]]\noutput = \"slider\"\nof = \"total\"\nreduce = \"maximum\"\nstatistics = [\"mean\"]\n";

/// The largest first-order effect of play over the turn that `motion` tells, of the first output, and what it was found with.
fn first_order(desk: &Desk, arguments: &[&str]) -> (f64, Value) {
    desk.succeed(&[&["motion"][..], arguments, &["--out", "motion", "--force"]].concat());
    let record: Value = serde_json::from_str(&desk.read("motion/summary.json")).expect("JSON");
    let worst = record["outputs"][0]["clearance"]["first_order_si"].as_array().expect("positions");
    (worst.iter().map(number).fold(0.0, f64::max), record["overrides"].clone())
}

#[test]
fn identity_motion_takes_the_most_play_unless_it_is_told_otherwise() {
    /// To first order the effect is in proportion to the clearance; round-off.
    const RELATIVE_TOLERANCE: f64 = 1e-9;
    let gudgeon = "[epistemic]\n\"joint.gudgeon.radial_clearance\" = { interval = [\"0.1 mm\", \"0.5 mm\"] }\n";
    let desk = Desk::with_model("slider_crank_worn_pin");
    desk.write("study.toml", &format!("{SHORT}{gudgeon}{ASK}"));
    let (worst, overrides) = first_order(&desk, &["study.toml"]);
    assert_eq!(overrides[0]["written"], "0.5 mm");
    // The example of the help.
    let (set, overrides) = first_order(&desk, &["study.toml", "--set", "joint.gudgeon.radial_clearance=0.3mm"]);
    assert_eq!((overrides.as_array().expect("a list").len(), &overrides[0]["written"]), (1, &Value::from("0.3mm")));
    assert!((set / worst - 0.6).abs() < RELATIVE_TOLERANCE, "{set} {worst}");
    // A clearance by an expression: the radius of the pin makes it larger where it is smaller.
    let model = desk.read("model.toml");
    let written = model.lines().find(|line| line.starts_with("radial_clearance = ")).expect("a clearance").to_owned();
    let model = model.replacen(&written, "radial_clearance = \"hole_radius - pin_radius\"", 1);
    let model = model.replacen("[parameter]\n", "[parameter]\nhole_radius = \"10.3 mm\"\npin_radius = \"10 mm\"\n", 1);
    desk.write("model.toml", &model);
    let pin = "[epistemic]\n\"parameter.pin_radius\" = { interval = [\"9.8 mm\", \"10.2 mm\"] }\n";
    desk.write("study.toml", &format!("{SHORT}{pin}{ASK}"));
    let (by_expression, overrides) = first_order(&desk, &["study.toml"]);
    assert_eq!(overrides[0]["written"], "9.8 mm");
    assert!((by_expression / worst - 1.0).abs() < RELATIVE_TOLERANCE, "{by_expression} {worst}");
}

#[test]
fn identity_motion_takes_the_most_play_of_a_guide() {
    /// To first order the effect is in proportion to the clearance; round-off.
    const RELATIVE_TOLERANCE: f64 = 1e-9;
    let desk = Desk::with_model("slider_crank_worn_pin");
    let guide = "slider = \"slider.pin\"\nhalf_length = \"50 mm\"\nhalf_height = \"25 mm\"\nclearance = \"0.1 mm\"\n\
                 corner_radius = \"5 mm\"\ncontact = \"steel_pin\"\n";
    desk.write("model.toml", &desk.read("model.toml").replacen("slider = \"slider.pin\"\n", guide, 1));
    let path = "joint.guide.clearance";
    let interval = format!("[epistemic]\n\"{path}\" = {{ interval = [\"0.01 mm\", \"0.3 mm\"] }}\n");
    desk.write("study.toml", &format!("{SHORT}{interval}{ASK}"));
    let (worst, overrides) = first_order(&desk, &["study.toml"]);
    assert_eq!((&overrides[0]["path"], &overrides[0]["written"]), (&Value::from(path), &Value::from("0.3 mm")));
    let (set, _) = first_order(&desk, &["study.toml", "--set", &format!("{path}=0.3mm")]);
    assert!((set / worst - 1.0).abs() < RELATIVE_TOLERANCE, "{set} {worst}");
}

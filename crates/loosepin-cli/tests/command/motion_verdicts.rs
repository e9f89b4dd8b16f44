//! `loosepin motion` judges requirements without dynamics.

use super::command_line::{Desk, Said};
use serde_json::Value;

/// Lengths that scatter and a play that is known roughly; a requirement with `limit` on `output`, and what follows.
fn judged(limit: &str, further: &str) -> (Said, Value) {
    let desk = Desk::with_model("slider_crank_worn_pin");
    let study = format!(
        "name = \"judged\"\nmodel = \"model.toml\"\nseed = 1\n[cycle]\ntransient_turns = 0\nrecorded_turns = 1\nsamples_per_turn = 180\n\
         [sampling]\nouter = 4\ninner = 16\n\
         [random]\n\"parameter.crank_length\" = {{ normal = {{ mean = \"50 mm\", standard_deviation = \"0.02 mm\" }} }}\n\
         \"parameter.rod_length\" = {{ normal = {{ mean = \"120 mm\", standard_deviation = \"0.03 mm\" }} }}\n\
         [epistemic]\n\"joint.gudgeon.radial_clearance\" = {{ interval = [\"0.1 mm\", \"0.5 mm\"] }}\n\
         [[require]]\n{limit}\nover = \"cycle\"\n{further}"
    );
    desk.write("study.toml", &study);
    let said = desk.run(&["motion", "study.toml", "--out", "out"]);
    let record = serde_json::from_str(&desk.read("out/summary.json")).expect("JSON");
    (said, record)
}

fn total(within: &str, probability: &str) -> String {
    format!("output = \"slider\"\nof = \"total\"\nwithin = \"{within}\"\nprobability_at_least = {probability}")
}

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn a_limit_that_the_proven_ends_keep_is_met() {
    let (said, record) = judged(&total("0.9 mm", "0.95"), "");
    let output = one_line(&said.output);
    assert_eq!(said.status, 0, "{output} {}", said.messages);
    assert!(output.contains("All requirements met without dynamics."), "{output}");
    let due = "Met without dynamics: deviation of slider within ±0.9 mm over the whole cycle, in at least 95 % of the mechanisms. \
               Proven: it stays within";
    assert!(output.contains(due), "{output}");
    // Two inputs within 3 standard deviations: 1 - 2 · 0.0027.
    let requirement = &record["requirements"][0];
    let share = requirement["share_within_limits"].as_f64().expect("a number");
    assert!((share - (1.0 - 2.0 * 0.002_699_796)).abs() < 1e-8, "{share}");
    // All lengths at three standard deviations, the pin drawn along the rod.
    let ends: Vec<f64> = [0, 1].map(|side| requirement["found_si"][side].as_f64().expect("a number")).into();
    let proven: Vec<f64> = [0, 1].map(|side| requirement["proven_si"][side].as_f64().expect("a number")).into();
    assert!(
        proven[0] <= ends[0] && ends[1] <= proven[1] && proven[1] < 6.9e-4 && ends[1] > 6.0e-4,
        "{ends:?} {proven:?}"
    );
}

#[test]
fn a_limit_that_the_worst_case_breaks_is_not_met() {
    let (said, _) = judged(&total("0.6 mm", "0.95"), "");
    let output = one_line(&said.output);
    assert_eq!(said.status, 1, "{output}");
    assert!(output.contains("Not all requirements are met in the worst case without dynamics."), "{output}");
    assert!(output.contains("Not met in the worst case: deviation of slider within ±0.6 mm"), "{output}");
    assert!(output.contains("in the worst case of play and parts. `loosepin study` computes how often."), "{output}");
}

#[test]
fn a_share_that_the_limits_of_the_parts_do_not_hold_is_undecided() {
    let (said, _) = judged(&total("0.9 mm", "0.9973"), "");
    let output = one_line(&said.output);
    assert_eq!(said.status, 1, "{output}");
    assert!(output.contains("Undecided without dynamics: deviation of slider within ±0.9 mm"), "{output}");
    assert!(output.contains("but for fewer mechanisms than required. This holds while all parts lie within their stated limits, or ±3 standard deviations: at least 99.46 %"), "{output}");
}

#[test]
fn a_speed_is_not_judged() {
    let limit = "output = \"slider_velocity\"\nof = \"value\"\nbelow = \"40 m/s\"\nprobability_at_least = 0.95";
    let (said, _) = judged(limit, "");
    let output = one_line(&said.output);
    assert_eq!(said.status, 1, "{output}");
    assert!(
        output.contains("Not judged without dynamics: value of slider_velocity below 40 m/s over the whole cycle"),
        "{output}"
    );
}

#[test]
fn analytic_how_far_play_may_be_loosened() {
    let (said, record) =
        judged(&total("0.9 mm", "0.95"), "[allow]\n\"joint.gudgeon.radial_clearance\" = { up_to = \"2 mm\" }\n");
    assert_eq!(said.status, 0, "{}", said.output);
    let loosest = record["allowances"][0]["loosest_si"].as_f64().expect("a number");
    // At 90° with the crank 0.06 mm longer, the rod 0.09 mm shorter and the pin drawn along the rod by c the slider is at
    // √((l - c)² - r²), 0.9 mm short of √(l₀² - r₀²). The range from 0.1 to 2 mm is halved seven times.
    let (r, l) = (0.05006_f64, 0.11991_f64);
    let most = l - (((0.12_f64.powi(2) - 0.05_f64.powi(2)).sqrt() - 9e-4).powi(2) + r * r).sqrt();
    assert!(loosest <= most && most - 1.9e-3 / 128.0 < loosest + 1e-6, "{loosest} {most}");
    let output = one_line(&said.output);
    assert!(output.contains("joint.gudgeon.radial_clearance may increase to 0.6937 mm (of at most 2 mm)"), "{output}");
}

#[test]
fn one_number_stands_for_play_that_reaches_a_dead_centre() {
    let desk = Desk::new();
    desk.write("model.toml", include_str!("../../../loosepin-simulate/tests/files/mend/dead_centre.toml"));
    let study = "name = \"judged\"\nmodel = \"model.toml\"\n[random]\n\"body.crank.mass\" = { tolerance = \"± 0.01 kg\" }\n[[require]]\n\
                 output = \"slider\"\nof = \"clearance\"\nover = \"cycle\"\nwithin = \"5 mm\"\nprobability_at_least = 0.95\n";
    desk.write("study.toml", study);
    let said = desk.run(&["motion", "study.toml", "--out", "out"]);
    let output = one_line(&said.output);
    assert_eq!(said.status, 1, "{output} {}", said.messages);
    let record: Value = serde_json::from_str(&desk.read("out/summary.json")).expect("JSON");
    let lowest = record["outputs"][1]["clearance"]["lowest_si"].as_array().expect("a list");
    let lowest = lowest.iter().filter_map(Value::as_f64).fold(0.0, f64::min);
    // At 87° the pin is drawn along the rod, in the other assembly: from √(l² - h²) to -√((l + c)² - h²).
    let height = 0.05 * 87_f64.to_radians().sin();
    let due = -((0.0511_f64.powi(2) - height * height).sqrt() + (0.0505_f64.powi(2) - height * height).sqrt());
    assert!((lowest / due - 1.0).abs() < 1e-6, "{lowest} {due}");
    assert_eq!(record["requirements"][0]["found_si"][0].as_f64(), Some(lowest));
    for words in [
        "It reaches -18.42 mm at ",
        "Play alone moves the slider by up to ±18.43 mm (largest found, through a dead centre, at ",
        "play takes the mechanism to a dead centre, where it can go over to its other assembly",
        " except from 86.0° to 94.0° and from 266° to 274°",
    ] {
        assert!(output.contains(words), "{words}: {output}");
    }
}

#[test]
fn a_press_is_proven_at_the_dead_centre_of_its_knee() {
    let desk = Desk::new();
    desk.write("model.toml", include_str!("../../../loosepin-simulate/tests/files/mend/press.toml"));
    let said = desk.run(&["motion", "model.toml", "--out", "out"]);
    let output = one_line(&said.output);
    assert_eq!(said.status, 0, "{output} {}", said.messages);
    assert!(
        output.contains(
            "Play alone moves the ram by up to ±0.08807 mm (worst case, at 186°; proven: never more than ±0.08"
        ),
        "{output}"
    );
    assert!(!output.contains("not proven") && !output.contains("without a proven end"), "{output}");
}

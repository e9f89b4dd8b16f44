//! Studies of models in space: what `motion` decides of their requirements, and studies that are interrupted or shared.

use super::command_line::{Desk, Said};
use serde_json::Value;

/// A slider-crank of the IFToMM library. At 0 deg its play takes the slider from -0.99562 mm to 1.00750 mm, by an independent program.
const SLIDER_CRANK: &str = include_str!("../../../../docs/examples/spatial-slider-crank.toml");

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The motion of a study with a clearance that is known roughly, with a requirement and what else is uncertain.
fn judged(requirement: &str, further: &str) -> (Said, Value, String) {
    let desk = Desk::new();
    desk.write("model.toml", &SLIDER_CRANK.replace("[body.rod]", "[body.rod]\nmass = \"0.3 kg\""));
    let study = format!(
        "name = \"judged\"\nmodel = \"model.toml\"\nseed = 1\n[sampling]\nouter = 4\ninner = 16\n{further}\n\
         [epistemic]\n\"joint.main.radial_clearance\" = {{ interval = [\"0.05 mm\", \"0.1 mm\"] }}\n\
         [[require]]\noutput = \"slider\"\nof = \"total\"\n{requirement}\nprobability_at_least = 0.95\n"
    );
    desk.write("study.toml", &study);
    let said = desk.run(&["motion", "study.toml", "--out", "out"]);
    assert!(said.status < 2, "{}", said.messages);
    let again = desk.run(&["motion", "study.toml", "--out", "out"]);
    assert_eq!((again.status, &again.output), (said.status, &said.output), "what is stored is shown again");
    assert!(again.messages.contains("out already holds this motion"), "{}", again.messages);
    let record: Value = serde_json::from_str(&desk.read("out/summary.json")).expect("JSON");
    let output = one_line(&said.output);
    (said, record["requirements"][0].clone(), output)
}

fn ends(requirement: &Value, which: &str) -> [f64; 2] {
    [0, 1].map(|side| requirement[which][side].as_f64().unwrap_or(f64::NAN))
}

#[test]
fn a_limit_in_space_that_the_proven_ends_keep_is_met() {
    let (said, requirement, output) = judged("within = \"1.02 mm\"\nover = \"cycle\"", "");
    assert_eq!(said.status, 0, "{output}");
    assert!(output.contains("All requirements met without dynamics."), "{output}");
    let due = "Met without dynamics: deviation of slider within ±1.02 mm over the whole cycle, in at least 95 % of the mechanisms. \
               Proven: it stays within";
    assert!(output.contains(due), "{output}");
    assert!(output.contains("This holds for all parts within their stated limits."), "{output}");
    let ([low, high], [least, most]) = (ends(&requirement, "found_si"), ends(&requirement, "proven_si"));
    assert!(1.0075e-3 < high && low < -0.9956e-3, "at least as far as at 0 deg: {low} {high}");
    assert!(least <= low && high <= most && most < 1.02e-3, "{least} {most}");
}

#[test]
fn a_limit_in_space_that_play_breaks_is_not_met() {
    let (said, requirement, output) = judged("within = \"1 mm\"\nover = \"cycle\"", "");
    assert_eq!(said.status, 1, "{output}");
    assert!(output.contains("Not all requirements are met in the worst case without dynamics."), "{output}");
    assert!(output.contains("It reaches 1.005 mm at 40.00° of crank, in the worst case of play."), "{output}");
    assert_eq!(requirement["verdict"], "not_met_in_the_worst_case");
    // It goes farther where it does not to first order: what is proven says where to search.
    let (said, requirement, _) = judged("within = \"1.007 mm\"\nover = \"cycle\"", "");
    assert_eq!((said.status, requirement["verdict"].as_str()), (1, Some("not_met_in_the_worst_case")));
    let [_, high] = ends(&requirement, "found_si");
    assert!(high > 1.0075e-3, "{requirement}");
    // Scatter does not help what play alone breaks.
    let scatter = "[random]\n\"parameter.rod_length\" = { normal = { standard_deviation = \"0.02 mm\" } }";
    let (said, requirement, _) = judged("within = \"1 mm\"\nover = \"cycle\"", scatter);
    assert_eq!((said.status, requirement["verdict"].as_str()), (1, Some("not_met_in_the_worst_case")));
}

#[test]
fn peer_a_limit_in_space_is_judged_at_its_pose() {
    let (said, requirement, output) = judged("below = \"1.02 mm\"\nposes = { crank = [\"0 deg\"] }", "");
    assert_eq!(said.status, 0, "{output}");
    let ([low, high], [least, most]) = (ends(&requirement, "found_si"), ends(&requirement, "proven_si"));
    assert!((high - 1.007502170e-3).abs() < 1e-12 && (low + 0.9956233477e-3).abs() < 1e-12, "{low} {high}");
    assert!(least <= low && high <= most && most < 1.02e-3, "{least} {most}");
    assert_eq!(ends(&requirement, "found_at_rad"), [0.0; 2]);
}

#[test]
fn parts_that_scatter_leave_a_limit_in_space_undecided() {
    let scatter = "[random]\n\"parameter.rod_length\" = { normal = { standard_deviation = \"0.02 mm\" } }";
    let (said, requirement, output) = judged("within = \"1.02 mm\"\nover = \"cycle\"", scatter);
    assert_eq!((said.status, requirement["verdict"].as_str()), (1, Some("undecided")), "{output}");
    let due = "nothing is proven: parameter.rod_length is uncertain, and in space only play is bounded without runs. Run `loosepin study` for what \
               is undecided here.";
    assert!(output.contains(due), "{output}");
}

#[test]
fn masses_that_scatter_leave_the_ends_of_play_proven() {
    let mass = "[random]\n\"body.rod.mass\" = { normal = { standard_deviation = \"0.02 kg\" } }";
    let (said, requirement, output) = judged("within = \"1.02 mm\"\nover = \"cycle\"", mass);
    assert_eq!((said.status, requirement["verdict"].as_str()), (0, Some("met")), "{output}");
    assert_eq!(requirement["share_within_limits"], 1.0);
}

#[test]
fn a_path_of_a_study_in_space_is_recorded_and_drawn_with_the_mechanism() {
    let desk = Desk::new();
    desk.write("model.toml", SLIDER_CRANK);
    desk.write(
        "study.toml",
        "name = \"path\"\nmodel = \"model.toml\"\nseed = 1\n[sampling]\nouter = 12\ninner = 16\n\
         [epistemic]\n\"joint.main.radial_clearance\" = { interval = [\"0.05 mm\", \"0.1 mm\"] }\n\
         [[ask]]\noutput = \"slider\"\nof = \"total\"\nposes = { crank = [\"0 deg\"] }\nstatistics = [\"mean\"]\n",
    );
    desk.succeed(&["study", "study.toml", "--path", "rod.slider", "--out", "out"]);
    let record: Value = serde_json::from_str(&desk.read("out/summary.json")).expect("JSON");
    assert_eq!(record["paths"]["paths"][0]["name"], "rod.slider");
    assert_eq!(record["paths"]["paths"], record["motion"]["paths"]);
    assert!(!desk.read("out/report.html").contains("The path and its tolerance zone"), "that figure is of the plane");
}

/// A study whose samples grow over rounds.
#[cfg(unix)]
const INPUTS: &str = r#"
name = "shared in space"
model = "model.toml"
seed = 11

[sampling]
outer = 12
inner = 32
replicates = 4
accuracy = "0.05 um"
budget = "3 rounds"

[random]
"parameter.crank_radius" = { normal = { standard_deviation = "0.02 mm" } }
"joint.main.radial_clearance" = { fit = "H8/f7", diameter = "20 mm" }

[epistemic]
"joint.main.axial_clearance" = { interval = ["0.05 mm", "0.3 mm"] }
"#;

#[cfg(unix)]
fn shared() -> Desk {
    let desk = Desk::new();
    desk.write("model.toml", SLIDER_CRANK);
    let questions = super::shards::questions("0.8 mm", "joint.main.axial_clearance", "0.3 mm");
    desk.write("study.toml", &format!("{INPUTS}{questions}"));
    desk
}

#[cfg(unix)]
#[test]
fn identity_two_shards_in_space_merge_into_the_bytes_of_the_whole() {
    let desk = shared();
    let whole = desk.run(&["study", "study.toml", "--out", "whole"]);
    assert!(whole.status < 2, "{}", whole.messages);
    let (merged, _) = super::shards::finish(&desk, "shared", 2);
    assert_eq!((merged.status, &merged.output), (whole.status, &whole.output), "{}", merged.messages);
    super::shards::assert_same(&desk, "whole", "shared");
}

#[cfg(unix)]
#[test]
fn identity_a_killed_study_in_space_goes_on_to_the_same_bytes() {
    let desk = shared();
    let whole = desk.run(&["study", "study.toml", "--out", "whole"]);
    assert!(whole.status < 2, "{}", whole.messages);
    super::resume::kill_after(&desk, 1);
    assert!(desk.path("killed/runs.sqlite").exists(), "killed too late to show anything");
    let resumed = desk.run(&["study", "study.toml", "--out", "killed", "--resume", "--threads", "1"]);
    assert!(resumed.messages.starts_with("continuing with "), "{}", resumed.messages);
    assert_eq!((resumed.status, &resumed.output), (whole.status, &whole.output));
    super::shards::assert_same(&desk, "whole", "killed");
}

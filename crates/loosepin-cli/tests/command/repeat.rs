//! Results made again from what they hold: the command, the files, and the commands of witnesses.
#![cfg(unix)]

use std::fs;

use serde_json::Value;

use super::command_line::{Desk, case_text};

/// Laws and a play that are unknown; line ends of another system, and no last one.
const STUDY: &str = "name = \"which law\"\r\nmodel = \"../models/crank.toml\"\r\n\
    [cycle]\r\ntransient_turns = 0\r\nrecorded_turns = 0.125\r\nsamples_per_turn = 40\r\n\
    [sampling]\r\nouter = 8\r\ninner = 16\r\n\
    [random]\r\n\"parameter.rod_length\" = { samples = \"data/rods.csv\" }\r\n\
    [epistemic]\r\n\"contact.steel_pin.law\" = { any_of = [\"lankarani-nikravesh\", \"flores\"] }\r\n\
    \"joint.gudgeon.radial_clearance\" = { interval = [\"0.3 mm\", \"0.5 mm\"] }\r\n\
    [[ask]]\r\noutput = \"gudgeon_force\"\r\nof = \"value\"\r\nreduce = \"maximum\"\r\nstatistics = [\"mean\"]";

fn write(desk: &Desk, name: &str, text: &str) {
    fs::create_dir_all(desk.path(name).parent().expect("a folder")).expect("it can be made");
    desk.write(name, text);
}

fn summary(desk: &Desk, folder: &str) -> Value {
    serde_json::from_str(&desk.read(&format!("{folder}/summary.json"))).expect("JSON")
}

/// A desk with nothing but the input files that a summary holds.
fn desk_of(summary: &Value) -> Desk {
    let desk = Desk::new();
    for file in summary["repeat"]["files"].as_array().expect("files") {
        write(&desk, file["name"].as_str().expect("a name"), file["text"].as_str().expect("a text"));
    }
    desk
}

#[test]
fn identity_a_study_is_made_again_from_its_own_files_and_its_witnesses_run() {
    let desk = Desk::new();
    write(&desk, "studies/study.toml", STUDY);
    write(&desk, "models/crank.toml", &case_text("slider_crank_worn_pin", "model.toml"));
    let rods: String = (0..12).map(|row| format!("{}\r\n", 119.96 + 0.007 * f64::from(row))).collect();
    write(&desk, "studies/data/rods.csv", &format!("rod length [mm]\r\n{rods}"));
    let said = desk.run(&["study", "studies/study.toml", "--out", "bounds", "--most-failed", "0.25"]);
    assert_eq!(said.status, 0, "{}", said.messages);
    let first = summary(&desk, "bounds");
    let command = first["repeat"]["command"].as_str().expect("a command");
    assert_eq!(command, "loosepin study inputs/study.toml --most-failed 0.25");
    let again = desk_of(&first);
    for [own, saved] in [
        ["studies/study.toml", "inputs/study.toml"],
        ["studies/data/rods.csv", "inputs/data/rods.csv"],
        ["models/crank.toml", "models/crank.toml"],
    ] {
        assert_eq!(fs::read(desk.path(own)).expect("bytes"), fs::read(again.path(saved)).expect("bytes"), "{own}");
    }
    let said = again.paste(&format!("{command} --out bounds"));
    assert_eq!(said.status, 0, "{}", said.messages);
    assert_eq!(again.read("bounds/summary.json"), desk.read("bounds/summary.json"));
    let witnesses = first["witness_commands"].as_array().expect("commands");
    assert_eq!(witnesses.len(), 2, "those of both ends of one bound: {witnesses:?}");
    for (number, witness) in witnesses.iter().enumerate() {
        let law = witness["witness"]["contact.steel_pin.law"].as_str().expect("a law");
        let command = witness["command"].as_str().expect("a command");
        assert!(command.contains(&format!("--set \"contact.steel_pin.law={law}\"")), "{command}");
        let folder = format!("witness {number}");
        let said = again.paste(&format!("{command} --out '{folder}'"));
        assert_eq!(said.status, 0, "{command}\n{}", said.messages);
        let run = summary(&again, &folder);
        assert_eq!(run["joints"][0]["law"], law);
        assert!(again.path(&folder).join("history.csv").exists());
    }
}

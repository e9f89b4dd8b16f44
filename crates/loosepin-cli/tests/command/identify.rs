//! `loosepin identify`: what it prints, writes, and how it ends.

use super::command_line::{Desk, case_text};

/// The readings of the ear of the rocker, and wrong ones.
const EAR: &str = "[\"0.1501 mm\", \"0.1492 mm\", \"0.1493 mm\"]";
const WRONG: &str = "[\"0.0701 mm\", \"0.0692 mm\", \"0.0693 mm\"]";

fn desk() -> Desk {
    let desk = Desk::with_model("backlash_test");
    for study in ["first.toml", "study.toml"] {
        desk.write(study, &case_text("backlash_test", study));
    }
    desk
}

#[test]
fn text_of_one_reading_says_that_only_the_sum_is_fixed() {
    let said = desk().succeed(&["identify", "first.toml"]);
    for words in [
        "1 reading fixes 1 sum of 3 plays, and none of the plays by itself.",
        "- crank_pin + coupler_pin + rocker_pivot is 0.2",
        "enter the reading with the same factor",
        "- of the 12 that looked best among 13296 readings, this reading would narrow the plays most: lock",
    ] {
        assert!(said.output.contains(words), "{words}\n{}", said.output);
    }
}

#[test]
fn narrowed_studies_are_written_once_and_not_for_a_misfit() {
    let desk = desk();
    let said = desk.succeed(&["identify", "study.toml", "--write", "narrowed.toml"]);
    assert!(said.messages.contains("wrote narrowed.toml: 3 intervals narrowed"), "{}", said.messages);
    let written = desk.read("narrowed.toml");
    assert!(written.contains("# from new to the limit of wear") && !written.contains("0.30 mm"), "{written}");
    desk.succeed(&["check", "narrowed.toml"]);
    let again = desk.run(&["identify", "study.toml", "--write", "narrowed.toml"]);
    assert_eq!(again.status, 2);
    assert!(again.messages.contains("narrowed.toml exists already; nothing is overwritten"), "{}", again.messages);
    desk.write("wrong.toml", &case_text("backlash_test", "study.toml").replace(EAR, WRONG));
    let wrong = desk.run(&["identify", "wrong.toml", "--write", "of_wrong.toml"]);
    assert_eq!(wrong.status, 1);
    assert!(wrong.output.contains("MISFIT: no values of the plays explain all 4 readings"), "{}", wrong.output);
    assert!(wrong.output.contains("- 'ear, up and down' gives "), "{}", wrong.output);
    assert!(wrong.messages.contains("of_wrong.toml is not written"), "{}", wrong.messages);
    assert!(!desk.path("of_wrong.toml").exists());
}

#[test]
fn two_readings_that_contradict_each_other_are_named_as_a_pair() {
    let desk = desk();
    let study = case_text("backlash_test", "study.toml");
    // The ear and the tool again, each a tenth of a millimetre off: whichever reading is left out, one pair is left.
    let again = |name: &str, lines: &str, travel: &str| {
        format!(
            "\n[[measured]]\nname = \"{name}\"\n{lines}\npose = {{ crank = \"60 deg\" }}\nforce = \"15 N\"\n\
             dead_travel = \"{travel}\"\nerror = \"0.003 mm\"\n"
        )
    };
    let ear = again("ear again", "output = \"ear\"", "0.25 mm");
    let tool = again("tool again", "output = \"tool\"\ncomponent = \"x\"", "0.43 mm");
    desk.write("pairs.toml", &format!("{study}{ear}{tool}"));
    let said = desk.run(&["identify", "pairs.toml"]);
    assert_eq!(said.status, 1);
    for words in [
        "- 'ear, up and down' and 'ear again' contradict each other, whatever the other readings are",
        "- 'tool, sideways' and 'tool again' contradict each other, whatever the other readings are",
        "- without any single reading, the others still contradict one another",
    ] {
        assert!(said.output.contains(words), "{words}\n{}", said.output);
    }
}

#[test]
fn json_holds_what_the_text_says() {
    let desk = desk();
    let said = desk.succeed(&["identify", "study.toml", "--json"]).output;
    let json: serde_json::Value = serde_json::from_str(&said).expect("it is JSON");
    let plays =
        json.pointer("/specimens/0/outcome/consistent/plays").and_then(|plays| plays.as_array()).expect("plays");
    let truths_m = [0.062e-3, 0.118e-3, 0.041e-3];
    assert_eq!(plays.len(), truths_m.len());
    for (play, truth_m) in plays.iter().zip(truths_m) {
        let end = |end: usize| play["after_si"][end].as_f64().expect("a number");
        assert!(end(0) <= truth_m && truth_m <= end(1), "{play}");
    }
    desk.write("wrong.toml", &case_text("backlash_test", "study.toml").replace(EAR, WRONG));
    let wrong = desk.run(&["identify", "wrong.toml", "--json"]);
    assert_eq!(wrong.status, 1);
    let json: serde_json::Value = serde_json::from_str(&wrong.output).expect("it is JSON");
    assert_eq!(json.pointer("/specimens/0/outcome/misfit/culprits/0/reading"), Some(&serde_json::json!(3)));
}

/// A study of a crank between 49 and 51 mm whose stroke was measured: 2 r = 100.3 mm ± 0.2 mm.
const STROKE: &str = "name = \"crank\"\nmodel = \"model.toml\"\n[cycle]\ntransient_turns = 0\nrecorded_turns = 1\n\
    [sampling]\nouter = 8\ninner = 8\n[epistemic]\n\"parameter.crank_length\" = { interval = [\"49 mm\", \"51 mm\"] }\n\
    [random]\n\"parameter.rod_length\" = { normal = { mean = \"120 mm\", standard_deviation = \"0.03 mm\" } }\n\
    [[ask]]\noutput = \"slider\"\nof = \"total\"\nreduce = \"maximum_absolute\"\nstatistics = [\"mean\"]\n\
    [[measured]]\nkind = \"motion\"\noutput = \"slider\"\nfeature = \"range\"\nvalue = \"100.3 mm\"\nerror = \"± 0.2 mm\"\n";

/// The worn pin without its play.
fn stroke_desk() -> Desk {
    let desk = Desk::with_model("slider_crank_worn_pin");
    let is_play =
        |line: &&str| !["bearing_radius", "radial_clearance", "contact = "].iter().any(|key| line.starts_with(key));
    let text = case_text("slider_crank_worn_pin", "model.toml");
    desk.write("model.toml", &text.lines().filter(is_play).collect::<Vec<&str>>().join("\n"));
    desk.write("study.toml", STROKE);
    desk
}

#[test]
fn a_page_is_written_once_and_again_from_its_record() {
    let desk = stroke_desk();
    let said = desk.succeed(&["identify", "study.toml", "--points", "40", "--compare", "--out", "identified"]);
    assert!(said.messages.contains("report: identified/report.html"), "{}", said.messages);
    for words in ["The study before (A) and after (B)", "narrowed", "crank length"] {
        assert!(said.output.contains(words), "{words}\n{}", said.output);
    }
    let page = desk.read("identified/report.html");
    for words in [
        "Values consistent with the motion",
        "Measured and predicted",
        "What to measure next",
        "The study before and after",
    ] {
        assert!(page.contains(words), "{words}");
    }
    for name in ["map.first", "features.0", "next.features"] {
        assert!(page.contains(&format!("data-figure=\"{name}\"")), "{name}");
    }
    let again = desk.succeed(&["identify", "study.toml", "--points", "40", "--compare", "--out", "identified"]);
    assert!(again.messages.contains("identified already holds this identification"), "{}", again.messages);
    assert_eq!(again.output, said.output);
    assert_eq!(desk.succeed(&["report", "identified"]).output, said.output);
}

#[test]
fn a_posterior_distribution_is_printed_and_drawn_where_it_is_asked_for() {
    let desk = stroke_desk();
    desk.write("study.toml", &STROKE.replace("error = \"± 0.2 mm\"", "scatter = \"0.3 mm\""));
    let asked = ["identify", "study.toml", "--points", "40", "--confidence", "0.9"];
    assert!(!desk.succeed(&asked).output.contains("Posterior distribution"));
    let with = [&asked[..], &["--posterior", "--out", "identified"]].concat();
    let said = desk.succeed(&with);
    let shown = said.output.replace('\u{a0}', " ");
    for words in ["Posterior distribution", "90 % credible", "- prior: uniform over the intervals of the study"] {
        assert!(shown.contains(words), "{words}\n{}", said.output);
    }
    let page = desk.read("identified/report.html");
    assert!(page.contains("data-figure=\"posterior.0.0\""), "the density is drawn");
    assert!(page.contains("Probability of the values"));
    // Without it, the same folder is asked for something else.
    let other = desk.run(&[&asked[..], &["--out", "identified"]].concat());
    assert_ne!(other.status, 0, "{}", other.output);
    // Features of an ideal motion with nothing that scatters: the set alone.
    let exact = STROKE.replace(
        "[random]\n\"parameter.rod_length\" = { normal = { mean = \"120 mm\", standard_deviation = \"0.03 mm\" } }\n",
        "",
    );
    assert!(!exact.contains("[random]"));
    desk.write("study.toml", &exact);
    let said = desk.succeed(&[&asked[..], &["--posterior"]].concat());
    assert!(said.output.contains("- no posterior distribution: there is no scatter"), "{}", said.output);
}

#[test]
fn lengths_of_a_specimen_are_told_written_and_used() {
    let desk = stroke_desk();
    // The largest position, r + l, with an error as large as the scatter of the rod.
    let ends = STROKE.replace(
        "\"range\"\nvalue = \"100.3 mm\"\nerror = \"± 0.2 mm\"",
        "\"maximum\"\nvalue = \"170.05 mm\"\nscatter = \"0.03 mm\"",
    );
    desk.write("study.toml", &ends);
    let asked = ["identify", "study.toml", "--confidence", "0.9", "--lengths"];
    let said = desk.succeed(&[&asked[..], &["--write", "narrowed.toml", "--compare", "--out", "identified"]].concat());
    let shown = said.output.replace('\u{a0}', " ");
    for words in [
        "Lengths of this specimen",
        "equally probable mechanisms",
        "- rod length is correlated with crank length (rank correlation -0.",
        "Write 'parameter.rod_length' under [epistemic]",
    ] {
        assert!(shown.split_whitespace().collect::<Vec<_>>().join(" ").contains(words), "{words}\n{}", said.output);
    }
    assert!(said.messages.contains("wrote narrowed-specimen.csv"), "{}", said.messages);
    assert!(desk.read("identified/report.html").contains("Lengths of the specimen"));
    assert!(desk.read("narrowed.toml").ends_with("mechanisms = \"narrowed-specimen.csv\"\n"));
    let rows = desk.read("narrowed-specimen.csv");
    assert_eq!((rows.lines().next(), rows.lines().count()), (Some("parameter.rod_length [mm]"), 1001));
    let checked = desk.succeed(&["check", "narrowed.toml"]);
    assert!(checked.output.contains("of the measured specimen, rows of narrowed-specimen.csv"), "{}", checked.output);
    assert!(checked.messages.contains("no bound holds this error"), "{}", checked.messages);
    // Nothing is written where one of the two files is there already.
    std::fs::remove_file(desk.path("narrowed.toml")).expect("it was written");
    let again = desk.run(&[&asked[..], &["--write", "narrowed.toml"]].concat());
    assert!(again.status == 2 && !desk.path("narrowed.toml").exists(), "{}", again.messages);
    // Few points leave few mechanisms.
    desk.write("study.toml", STROKE);
    let given = desk.run(&[&asked[..], &["--points", "20", "--write", "other.toml"]].concat());
    assert!(given.status == 2 && given.messages.contains("--points"), "{} {}", given.output, given.messages);
    desk.write("first.toml", &case_text("backlash_test", "first.toml"));
    desk.write("model.toml", &case_text("backlash_test", "model.toml"));
    let refused = desk.run(&["identify", "first.toml", "--lengths"]);
    assert!(
        refused.messages.contains("only features of a motion (kind = \"motion\") depend on the lengths"),
        "{}",
        refused.messages
    );
}

#[test]
fn nothing_is_compared_for_a_misfit() {
    let desk = stroke_desk();
    desk.write("study.toml", &STROKE.replace("100.3 mm", "103 mm"));
    let said = desk.run(&["identify", "study.toml", "--points", "40", "--compare", "--out", "identified"]);
    assert_eq!(said.status, 1);
    assert!(said.messages.contains("the study is not compared: no values explain the measurements"));
    assert!(desk.read("identified/report.html").contains("Misfit: no values of the unknowns explain the motion."));
    assert_eq!(desk.run(&["report", "identified"]).status, 1);
}

//! Files that are wrong, and what is said about them, word for word.
//!
//! Each `bad/model/NAME.toml` and `bad/study/NAME.toml` has the expected text beside it in `NAME.expected`. With
//! `LOOSEPIN_BLESS=1` in the environment the expected texts are written anew, to be read before they are committed.
//! Studies are read beside the model of the slider-crank template.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use loosepin::bounds::Statistic;
use loosepin::contact::{FRICTION_LAWS, POINT_LAWS};
use loosepin::diagnostics::{CODES, Colour, Complaints};
use loosepin::model::{Model, NormalDescription, model_schema};
use loosepin::study::{InputFile, Study};
use loosepin::templates::find_template;
use loosepin::units::quoted;

fn folder(kind: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bad").join(kind)
}

fn template_model() -> Model {
    let text = find_template("slider-crank").expect("template").model;
    Model::from_text("model.toml", text).unwrap_or_else(|complaints| panic!("{complaints}"))
}

fn files(kind: &str) -> Vec<PathBuf> {
    let mut paths: Vec<PathBuf> = fs::read_dir(folder(kind))
        .expect("the folder of bad files")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .collect();
    paths.sort();
    assert!(!paths.is_empty());
    paths
}

/// The lists of all laws, outputs and statistics as messages show them, and what stands for each in the expected texts: a new one
/// changes none of them.
fn lists() -> [(String, &'static str); 6] {
    let list = |names: Vec<&str>| {
        let quoted: Vec<String> = names.iter().map(|name| format!("\"{name}\"")).collect();
        let (last, others) = quoted.split_last().expect("there are laws");
        format!("must be {} or {last}", others.join(", "))
    };
    let schema = model_schema();
    let output = &schema["properties"]["output"]["additionalProperties"];
    let keys: Vec<&str> = output["properties"].as_object().expect("keys").keys().map(String::as_str).collect();
    let measures = &keys[..keys.iter().position(|key| *key == "along").expect("the first key that measures nothing")];
    [
        (keys.join(", "), "{the keys of an output}"),
        (quoted(measures), "{what an output measures}"),
        (
            list(Statistic::PLAIN.map(Statistic::word).into_iter().chain(["contributors"]).collect()),
            "must be {a statistic}",
        ),
        (list(NormalDescription::all().map(|law| law.name()).collect()), "must be {a normal force law}"),
        (list(POINT_LAWS.iter().map(|law| law.name).collect()), "must be {a point-contact law}"),
        (list(FRICTION_LAWS.iter().map(|law| law.name).collect()), "must be {a friction law}"),
    ]
}

fn check(kind: &str, read: impl Fn(&str, String) -> Option<Complaints>) {
    let mut differences = Vec::new();
    for path in files(kind) {
        let name = path.file_name().and_then(|name| name.to_str()).expect("a name").to_owned();
        let text = fs::read_to_string(&path).expect("UTF-8");
        let Some(complaints) = read(&name, text) else {
            differences.push(format!("{name}: read without complaint"));
            continue;
        };
        let said = lists().into_iter().fold(format!("{complaints}\n"), |said, (list, name)| said.replace(&list, name));
        let expected_path = path.with_extension("expected");
        let mut expected = fs::read_to_string(&expected_path).unwrap_or_default();
        if said != expected && std::env::var_os("LOOSEPIN_BLESS").is_some() {
            fs::write(&expected_path, &said).expect("the expected text can be written");
            expected.clone_from(&said);
        }
        if said != expected {
            differences.push(format!("{name}: expected\n{expected}\nbut said\n{said}"));
        }
        // The rendering for people must show each message and hint too, whatever the place.
        let rendered = complaints.render(Colour::Never);
        for complaint in complaints.sorted().into_iter().take(50) {
            assert!(rendered.contains(complaint.code.as_str()), "{name}: {rendered}");
        }
        assert!(!complaints.render(Colour::Always).is_empty());
    }
    assert!(differences.is_empty(), "{}", differences.join("\n"));
}

#[test]
fn bad_models_are_complained_about_word_for_word() {
    check("model", |name, text| Model::from_text(name, &text).err());
}

#[test]
fn bad_studies_are_complained_about_word_for_word() {
    check("study", |name, text| Study::from_text(name, &text, template_model()).err());
}

/// Codes of complaints that need no bad file: about the file system, sizes (`runaway_files.rs`), settings and sampling (in `model_file.rs` and in
/// the tests of the command).
const TESTED_ELSEWHERE: [&str; 9] = ["E0101", "E0102", "E0103", "E0210", "E0406", "E0407", "E0408", "E0409", "E0611"];

/// From here on codes are about what sound files mean together: mechanisms, runs, folders. The tests of the command provoke
/// those that can be provoked.
const FIRST_BEYOND_FILES: &str = "E0700";

#[test]
fn every_code_is_used() {
    let mut used: BTreeSet<String> = TESTED_ELSEWHERE.iter().map(|code| (*code).to_owned()).collect();
    for kind in ["model", "study"] {
        for path in files(kind) {
            let expected = fs::read_to_string(path.with_extension("expected")).unwrap_or_default();
            used.extend(expected.lines().filter_map(|line| {
                let (_, rest) = line.split_once("error[").or_else(|| line.split_once("warning["))?;
                rest.split_once(']').map(|(code, _)| code.to_owned())
            }));
        }
    }
    let codes = CODES.iter().map(|entry| entry.text).filter(|code| *code < FIRST_BEYOND_FILES);
    let unused: Vec<&str> = codes.filter(|code| !used.contains(*code)).collect();
    assert!(unused.is_empty(), "codes in the table that no test provokes: {unused:?}");
}

#[test]
fn files_that_cannot_be_read_are_named() {
    let missing = Model::from_path(Path::new("nowhere/model.toml")).expect_err("no such file");
    assert_eq!(missing.to_string(), "error[E0101]: cannot read nowhere/model.toml: there is no such file");
    let a_folder = Model::from_path(&folder("model")).expect_err("a folder").to_string();
    assert!(a_folder.starts_with("error[E0101]: cannot read "), "{a_folder}");
    assert!(a_folder.contains("it is a folder\nhint: name a file in it, for example "), "{a_folder}");
    let bytes = b"name = \"Gel\xe4nk\"\n".to_vec();
    let latin = Model::from_bytes("latin.toml", bytes).expect_err("not UTF-8");
    assert_eq!(
        latin.to_string(),
        "latin.toml:1:12: error[E0102]: the file is not UTF-8 text from this position on\nhint: save the file as UTF-8"
    );
    let large = Model::from_text("large.toml", &"#".repeat(2 << 20)).expect_err("too large");
    assert_eq!(large.to_string(), "error[E0103]: large.toml has 2097152 bytes; must be at most 1048576");
}

#[test]
fn an_empty_file_is_neither_a_model_nor_a_study() {
    let folder = std::env::temp_dir().join(format!("loosepin-empty-file-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder for the test");
    let path = folder.join("study.toml");
    fs::write(&path, "# to be written\n").expect("a file for the test");
    let said = InputFile::from_path(&path).expect_err("nothing in it").to_string();
    fs::remove_dir_all(&folder).expect("the folder of the test goes");
    let said = said.replace(&format!("{}{}", folder.display(), std::path::MAIN_SEPARATOR), "");
    assert_eq!(
        said,
        "study.toml:1:1: error[E0905]: the file is empty: neither a model nor a study\n\
         hint: `loosepin new slider-crank` writes an example of both"
    );
}

#[test]
fn a_study_without_its_model_points_at_the_name() {
    let folder = std::env::temp_dir().join(format!("loosepin-bad-files-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder for the test");
    let path = folder.join("study.toml");
    fs::write(&path, "name = \"x\"\nmodel = \"modle.toml\"\nsede = 1\n").expect("a file for the test");
    fs::write(folder.join("model.toml"), "").expect("a file for the test");
    let said = Study::from_path(&path).expect_err("no such model").to_string();
    fs::remove_dir_all(&folder).expect("the folder of the test goes");
    let said = said.replace(&format!("{}{}", folder.display(), std::path::MAIN_SEPARATOR), "");
    assert_eq!(
        said,
        "study.toml:2:9: error[E0101]: cannot read modle.toml: there is no such file\n\
         hint: did you mean 'model.toml'?\n\
         study.toml:3:1: error[E0201]: the file has no key 'sede'\nhint: did you mean 'seed'?"
    );
}

#[test]
fn people_see_the_line() {
    let text = fs::read_to_string(folder("model").join("clearance_negative.toml")).expect("the file");
    let complaints = Model::from_text("model.toml", &text).expect_err("a negative clearance");
    assert_eq!(
        complaints.render(Colour::Never),
        "\
error[E0501]: joint 'pin': radial clearance -0.05 mm; must be >= 0
  --> model.toml:30:20
   |
30 | radial_clearance = \"-0.05 mm\"
   |                    ^^^^^^^^^^
   |
   = hint: the radial clearance is radius of the hole minus radius of the pin

"
    );
}

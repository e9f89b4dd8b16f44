//! Whatever sound-looking numbers stand in a model, `check` describes it or reports. No panic, and no endless run.
//!
//! `LOOSEPIN_FUZZ_CASES` sets how many files are tried (100 if unset; the long campaign tries 100,000 and more).

use std::path::Path;

use loosepin_mechanics::model::Model;
use loosepin_report::article_text;
use loosepin_study::{InputFile, Study};
use loosepin_text::diagnostics::Colour;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

use super::{check, check_until};

/// Cases tried where the environment does not say.
const DEFAULT_CASES: u32 = 100;
/// Studies tried at least: each of them times a run.
const MIN_STUDIES: u32 = 10;

/// Numbers that are put in place of others, units kept.
const NUMBERS: &[&str] = &[
    "0", "-1", "1", "1e-300", "1e-30", "1e-12", "1e-6", "1e-3", "0.1", "0.999999", "45", "60", "90", "180", "270",
    "360", "1e3", "1e6", "1e12", "1e30", "1e300",
];

/// Cases whose models are changed.
const CASES: &[&str] = &[
    "slider_crank_worn_pin",
    "four_bar_600",
    "six_bar",
    "eight_bar",
    "five_bar_two_drives",
    "scotch_yoke",
    "four_bar_three_clearances",
    "four_bar_floating_coupler",
    "inverted_slider_crank_material",
];

#[derive(Debug, Clone)]
enum Change {
    /// Another number in place of one.
    Number { place: prop::sample::Index, number: &'static str },
    /// A number times a factor.
    Scale { place: prop::sample::Index, factor: f64 },
    /// Two texts in quotes exchanged.
    Exchange { first: prop::sample::Index, second: prop::sample::Index },
    /// A table removed.
    Remove { table: prop::sample::Index },
}

fn change() -> impl Strategy<Value = Change> {
    let place = any::<prop::sample::Index>;
    prop_oneof![
        3 => (place(), prop::sample::select(NUMBERS)).prop_map(|(place, number)| Change::Number { place, number }),
        3 => (place(), prop_oneof![0.9..1.1, 0.1..10.0, Just(-1.0)])
            .prop_map(|(place, factor)| Change::Scale { place, factor }),
        1 => (place(), place()).prop_map(|(first, second)| Change::Exchange { first, second }),
        1 => place().prop_map(|table| Change::Remove { table }),
    ]
}

/// Byte ranges of the numbers of a text, those within names left out.
fn numbers(text: &str) -> Vec<std::ops::Range<usize>> {
    let bytes = text.as_bytes();
    let is_part = |byte: u8| byte.is_ascii_digit() || byte == b'.';
    let mut found = Vec::new();
    let mut at = 0;
    while at < bytes.len() {
        let follows_name = at > 0 && (bytes[at - 1].is_ascii_alphabetic() || matches!(bytes[at - 1], b'_' | b'^'));
        if bytes[at].is_ascii_digit() && !follows_name {
            let start = at;
            while at < bytes.len() && is_part(bytes[at]) {
                at += 1;
            }
            found.push(start..at);
        } else {
            at += 1;
        }
    }
    found
}

/// Byte ranges of the texts in quotes.
fn quoted(text: &str) -> Vec<std::ops::Range<usize>> {
    let quotes: Vec<usize> = text.match_indices('"').map(|(at, _)| at).collect();
    quotes.chunks_exact(2).map(|pair| pair[0] + 1..pair[1]).collect()
}

fn apply(text: &str, change: &Change) -> String {
    let mut changed = text.to_owned();
    match change {
        Change::Number { place, number } => {
            let places = numbers(text);
            if !places.is_empty() {
                changed.replace_range(place.get(&places).clone(), number);
            }
        }
        Change::Scale { place, factor } => {
            let places = numbers(text);
            if !places.is_empty() {
                let range = place.get(&places).clone();
                let value: f64 = text[range.clone()].parse().unwrap_or(1.0);
                changed.replace_range(range, &format!("{}", value * factor));
            }
        }
        Change::Exchange { first, second } => {
            let places = quoted(text);
            if !places.is_empty() {
                let (a, b) = (first.get(&places).clone(), second.get(&places).clone());
                let (a, b) = if a.start <= b.start { (a, b) } else { (b, a) };
                let (in_a, in_b) = (text[a.clone()].to_owned(), text[b.clone()].to_owned());
                changed.replace_range(b, &in_a);
                changed.replace_range(a, &in_b);
            }
        }
        Change::Remove { table } => {
            let heads: Vec<usize> = text.match_indices("\n[").map(|(at, _)| at).collect();
            if !heads.is_empty() {
                let start = *table.get(&heads);
                let end = heads.iter().copied().find(|&head| head > start).unwrap_or(text.len());
                changed.replace_range(start..end, "");
            }
        }
    }
    changed
}

fn case_text(case: &str, file: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases").join(case).join(file);
    std::fs::read_to_string(path).expect("the case is there")
}

/// Describes the model, or shows what is wrong with it.
fn describe(text: &str) {
    let described = Model::from_text("model.toml", text).and_then(|model| check(&InputFile::Model(model.into())));
    match described {
        Ok(article) => assert!(article_text(&article, None).contains("A run: ")),
        Err(diagnostics) => {
            assert!(!diagnostics.is_empty());
            assert!(!diagnostics.to_string().is_empty());
            assert!(!diagnostics.render(Colour::Never).is_empty());
        }
    }
}

fn cases() -> u32 {
    std::env::var("LOOSEPIN_FUZZ_CASES").ok().and_then(|text| text.parse().ok()).unwrap_or(DEFAULT_CASES)
}

#[test]
fn no_mutated_model_makes_check_panic() {
    let texts: Vec<String> = CASES.iter().map(|case| case_text(case, "model.toml")).collect();
    let strategy = (prop::sample::select(texts), prop::collection::vec(change(), 1..4));
    let mut runner = TestRunner::new(Config { cases: cases(), failure_persistence: None, ..Config::default() });
    runner
        .run(&strategy, |(text, changes)| {
            describe(&changes.iter().fold(text, |text, change| apply(&text, change)));
            Ok(())
        })
        .unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn no_mutated_study_makes_check_panic() {
    let model_text = case_text("slider_crank_worn_pin", "model.toml");
    let strategy = prop::collection::vec(change(), 1..4);
    let mut runner = TestRunner::new(Config {
        cases: (cases() / 100).max(MIN_STUDIES),
        failure_persistence: None,
        ..Config::default()
    });
    runner
        .run(&strategy, |changes| {
            let study_text = changes
                .iter()
                .fold(case_text("slider_crank_worn_pin", "study.toml"), |text, change| apply(&text, change));
            let model = Model::from_text("model.toml", &model_text).expect("the model is sound");
            let checked = Study::from_text("study.toml", &study_text, model)
                .and_then(|study| check(&InputFile::Study(Box::new(study))));
            assert!(checked.is_ok() || checked.is_err_and(|diagnostics| !diagnostics.is_empty()));
            Ok(())
        })
        .unwrap_or_else(|error| panic!("{error}"));
}

/// What `check` says of a model, or reports about.
fn said(text: &str) -> String {
    let model = Model::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    match check(&InputFile::Model(model.into())) {
        Ok(article) => article_text(&article, None),
        Err(diagnostics) => diagnostics.to_string(),
    }
}

/// A chain of links that hangs on the ground.
fn chain(links: usize) -> String {
    let link = |k: usize| {
        let bearing = if k == 0 { "ground.o".to_owned() } else { format!("b{}.q", k - 1) };
        format!(
            "[body.b{k}]\nmass = \"0.7 kg\"\ninertia = \"2e-3 kg m^2\"\ncentre_of_mass = [\"40 mm\", \"0 mm\"]\n\
             points = {{ p = [\"0 mm\", \"0 mm\"], q = [\"90 mm\", \"0 mm\"] }}\n\
             [joint.j{k}]\nkind = \"revolute\"\nbearing = \"{bearing}\"\njournal = \"b{k}.p\"\n\
             [initial.body.b{k}]\nangle = \"{} deg\"\n",
            7 * k % 50
        )
    };
    format!(
        "name = \"chain\"\ngravity = \"9.81 m/s^2\"\n[body.ground]\npoints = {{ o = [\"0 mm\", \"0 mm\"] }}\n{}\
         [cycle]\nduration = \"1 s\"\n",
        (0..links).map(link).collect::<String>()
    )
}

#[test]
fn a_chain_whose_equations_are_too_long_is_described_without_a_run() {
    assert!(said(&chain(12)).ends_with("\nThe first steps of the run succeed.\n"));
    let long = said(&chain(300));
    assert!(
        long.ends_with("\nThe run was not tested: its equations of motion for 300 coordinates take too long.\n"),
        "{long}"
    );
}

/// An arm on an arm that turns once a second, and shakes fifty thousand times in it.
const SHAKEN: &str = r#"
name = "shaken arm"
gravity = "0 m/s^2"
[body.ground]
points = { o = ["0 mm", "0 mm"] }
[body.arm]
mass = "0.7 kg"
inertia = "2e-3 kg m^2"
centre_of_mass = ["40 mm", "0 mm"]
points = { p = ["0 mm", "0 mm"], q = ["90 mm", "0 mm"] }
[body.hand]
mass = "0.7 kg"
inertia = "2e-3 kg m^2"
centre_of_mass = ["40 mm", "0 mm"]
points = { p = ["0 mm", "0 mm"], q = ["90 mm", "0 mm"] }
[joint.shoulder]
kind = "revolute"
bearing = "ground.o"
journal = "arm.p"
[joint.wrist]
kind = "revolute"
bearing = "arm.q"
journal = "hand.p"
[drive.turn]
joint = "shoulder"
speed = "60 rpm"
start_angle = "0 deg"
[drive.shake]
joint = "wrist"
motion = { kind = "harmonic", mean = "0 deg", amplitude = "1 rad", frequency = "5e4 Hz", phase = "0 deg" }
[cycle]
drive = "turn"
transient_turns = 0
recorded_turns = 1
samples_per_turn = 36
[output.tip]
position_of = "hand.q"
along = "x"
"#;

#[test]
fn a_cycle_with_too_many_steps_is_followed_in_part() {
    // By hand: the wrist goes to and fro 5e4 times, 4 rad each, in steps of 0.2 rad: 1e6 a turn, of which 31416 are 3.1 %.
    let text = said(SHAKEN);
    let expected = "\nThe loops close over the first 3.1 % of the cycle; a drive is so fast that they were not followed further, and the first steps of \
                    the run succeed.\n";
    assert!(text.ends_with(expected), "{text}");
    let slower = said(&SHAKEN.replace("5e4 Hz", "50 Hz"));
    assert!(
        slower.ends_with("\nThe loops close over the whole cycle, and the first steps of the run succeed.\n"),
        "{slower}"
    );
}

#[test]
fn more_turns_than_a_run_can_have_are_refused_with_play_and_without() {
    let text = case_text("slider_crank_5000", "model.toml");
    let turns = text.lines().map(|line| {
        let is_other = line.starts_with("transient_turns") || line.starts_with("recorded_turns");
        if is_other || line.starts_with("samples_per_turn") { "" } else { line }
    });
    let text = turns.collect::<Vec<_>>().join("\n");
    let text = text.replace("[cycle]", "[cycle]\nrecorded_turns = 1e6\nsamples_per_turn = 1");
    let place = 1 + text.lines().position(|line| line == "[cycle]").expect("a cycle");
    let expected = format!(
        "model.toml:{place}:2: error[E0804]: 1000002 turns take at least 1.15e9 evaluations; must be at most 3.00e8\n\
         hint: use fewer turns"
    );
    assert_eq!(said(&text), expected);
    let ideal = text
        .lines()
        .map(|line| if line.starts_with("radial_clearance") { "radial_clearance = \"0 mm\"" } else { line });
    assert_eq!(said(&ideal.collect::<Vec<_>>().join("\n")), expected);
}

#[test]
fn a_check_ends_when_it_is_stopped() {
    let text = include_str!("../../../cases/slider_crank_worn_pin/model.toml");
    let model = Model::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let file = InputFile::Model(model.into());
    let stopped = check_until(&file, &std::sync::atomic::AtomicBool::new(true)).map(|_| ());
    assert!(stopped.is_err_and(|diagnostics| diagnostics.to_string().contains("E0807")));
}

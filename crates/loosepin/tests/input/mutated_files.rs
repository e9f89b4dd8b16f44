//! Valid files with something broken in them at random: whatever stands there, it is read or reported, and
//! diagnostics can be shown. No panic.
//!
//! `LOOSEPIN_FUZZ_CASES` sets how many files are tried (3,000 if unset; the long campaign tries 100,000 and more).

use loosepin::diagnostics::{Colour, Diagnostics};
use loosepin::model::Model;
use loosepin::study::Study;
use loosepin::templates::TEMPLATES;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

/// Cases tried where the environment does not say.
const DEFAULT_CASES: u32 = 3000;

/// What is put in place of numbers and words: limits of number types, words of the format, text that breaks readers.
const INSERTIONS: &[&str] = &[
    "1e308",
    "-1e308",
    "1e309",
    "1e-320",
    "nan",
    "inf",
    "-inf",
    "-1",
    "0",
    "9223372036854775808",
    "0x10",
    "1_000",
    "\"\"",
    "\"nan\"",
    "\"1e400 mm\"",
    "\"-0.5 mm\"",
    "\"0 kg\"",
    "\"1 mm^1e300\"",
    "\"2^(2^(2^9))\"",
    "\"((((((((((((1\"",
    "\"crank_length\"",
    "\"1 / 0 mm\"",
    "\"ground.o\"",
    "\"°%µ²\"",
    "true",
    "1979-05-27",
    "[]",
    "[[]]",
    "{}",
    "{ a = {} }",
    "\u{feff}",
    "\u{0}",
    "\r\n",
    "\t",
    "\n",
    "\"",
    "'''",
    "\"\"\"",
    "#",
    "=",
    ".",
    ",",
    "[",
    "]",
    "[[",
    "{",
    "}",
    "ä",
    "🦀",
    "\u{202e}",
    "kind",
    "ground",
    "parameter",
    "radial_clearance",
    "interval",
    "mean",
    "sin",
    "pi",
    "mm",
];

/// One thing done to a file.
#[derive(Debug, Clone)]
enum Mutation {
    Delete { at: usize, length: usize },
    Insert { at: usize, what: usize },
    ReplaceWord { at: usize, what: usize },
    Duplicate { at: usize, length: usize, to: usize },
    SwapLines { first: usize, second: usize },
    Byte { at: usize, value: u8 },
    Repeat { what: usize, at: usize, times: usize },
}

fn mutation() -> impl Strategy<Value = Mutation> {
    let at = 0..8192_usize;
    let what = 0..INSERTIONS.len();
    prop_oneof![
        1 => (at.clone(), 1..40_usize).prop_map(|(at, length)| Mutation::Delete { at, length }),
        1 => (at.clone(), what.clone()).prop_map(|(at, what)| Mutation::Insert { at, what }),
        4 => (at.clone(), what.clone()).prop_map(|(at, what)| Mutation::ReplaceWord { at, what }),
        1 => (at.clone(), 1..200_usize, at.clone()).prop_map(|(at, length, to)| Mutation::Duplicate { at, length, to }),
        1 => (at.clone(), at.clone()).prop_map(|(first, second)| Mutation::SwapLines { first, second }),
        1 => (at.clone(), any::<u8>()).prop_map(|(at, value)| Mutation::Byte { at, value }),
        1 => (what, at, 1..300_usize).prop_map(|(what, at, times)| Mutation::Repeat { what, at, times }),
    ]
}

fn is_word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'.' | b'-' | b'"')
}

fn apply(bytes: &mut Vec<u8>, mutation: &Mutation) {
    if bytes.is_empty() {
        return;
    }
    let inside = |at: usize, bytes: &[u8]| at % bytes.len();
    match *mutation {
        Mutation::Delete { at, length } => {
            let start = inside(at, bytes);
            bytes.drain(start..(start + length).min(bytes.len()));
        }
        Mutation::Insert { at, what } => {
            let start = inside(at, bytes);
            bytes.splice(start..start, INSERTIONS[what].bytes());
        }
        Mutation::ReplaceWord { at, what } => {
            let mut start = inside(at, bytes);
            while start > 0 && is_word(bytes[start - 1]) {
                start -= 1;
            }
            let mut end = start;
            while end < bytes.len() && is_word(bytes[end]) {
                end += 1;
            }
            bytes.splice(start..end, INSERTIONS[what].bytes());
        }
        Mutation::Duplicate { at, length, to } => {
            let start = inside(at, bytes);
            let piece = bytes[start..(start + length).min(bytes.len())].to_vec();
            let to = inside(to, bytes);
            bytes.splice(to..to, piece);
        }
        Mutation::SwapLines { first, second } => {
            let mut lines: Vec<Vec<u8>> = bytes.split_inclusive(|byte| *byte == b'\n').map(<[u8]>::to_vec).collect();
            let (first, second) = (first % lines.len(), second % lines.len());
            lines.swap(first, second);
            *bytes = lines.concat();
        }
        Mutation::Byte { at, value } => {
            let at = inside(at, bytes);
            bytes[at] = value;
        }
        Mutation::Repeat { what, at, times } => {
            let start = inside(at, bytes);
            bytes.splice(start..start, INSERTIONS[what].repeat(times).into_bytes());
        }
    }
}

fn show(diagnostics: &Diagnostics) {
    assert!(diagnostics.has_errors(), "refused without an error");
    assert!(!diagnostics.to_string().is_empty());
    assert!(!diagnostics.render(Colour::Never).is_empty());
}

/// Reads a model as the commands do; what is read must be computable.
fn read_model(bytes: Vec<u8>) {
    match Model::from_bytes("mutated.toml", bytes) {
        Err(diagnostics) => show(&diagnostics),
        Ok(model) => {
            let values =
                model.quantities.evaluate(&[]).unwrap_or_else(|error| panic!("accepted, and impossible: {error}"));
            assert_eq!(values.0.len(), model.quantities.len());
            for (id, quantity) in model.quantities.iter() {
                assert!(values[id].is_finite(), "{} is {}", quantity.path, values[id]);
                assert_eq!(model.find(&quantity.path).is_ok(), quantity.is_settable());
            }
        }
    }
}

fn read_study(model: &str, bytes: Vec<u8>) {
    let model = Model::from_text("model.toml", model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let text = String::from_utf8_lossy(&bytes);
    match Study::from_text("mutated.toml", &text, model) {
        Err(diagnostics) => show(&diagnostics),
        Ok(study) => assert!(!study.random.is_empty() || !study.epistemic.is_empty()),
    }
}

#[test]
fn no_mutated_file_makes_the_reader_panic() {
    let config = Config { cases: cases(), failure_persistence: None, ..Config::default() };
    let strategy = (0..TEMPLATES.len(), any::<bool>(), proptest::collection::vec(mutation(), 1..6));
    let outcome = TestRunner::new(config).run(&strategy, |(template, is_model, mutations)| {
        let template = &TEMPLATES[template];
        let mut bytes = if is_model { template.model } else { template.study }.as_bytes().to_vec();
        mutations.iter().for_each(|mutation| apply(&mut bytes, mutation));
        if is_model {
            read_model(bytes);
        } else {
            read_study(template.model, bytes);
        }
        Ok(())
    });
    outcome.unwrap_or_else(|failure| panic!("{failure}"));
}

/// Values put in place of others in files that stay TOML: right ones at the wrong place, and wrong ones.
const VALUES: &[&str] = &[
    "1",
    "0",
    "-1",
    "1e308",
    "nan",
    "inf",
    "true",
    "[]",
    "{}",
    "[1, 2]",
    "[\"1 mm\", \"0 mm\"]",
    "[\"2 mm\", \"3 mm\", \"4 mm\"]",
    "\"\"",
    "\"0 mm\"",
    "\"1 mm\"",
    "\"-1 mm\"",
    "\"1e308 mm\"",
    "\"1 kg\"",
    "\"0 kg m^2\"",
    "\"30 deg\"",
    "\"1e300 rpm\"",
    "\"crank_length\"",
    "\"rod_length * 1e200\"",
    "\"crank_length - crank_length\"",
    "\"sqrt(crank_length * rocker_length)\"",
    "\"ground.o\"",
    "\"crank.pin\"",
    "\"rocker.pin\"",
    "\"crank\"",
    "\"main\"",
    "\"gudgeon\"",
    "\"steel_pin\"",
    "\"rigid\"",
    "\"prismatic\"",
    "\"revolute\"",
    "\"cycle\"",
    "\"total\"",
    "\"slider\"",
    "\"rocker\"",
    "\"joint.gudgeon\"",
    "\"x\"",
    "{ point = \"ground.o\", angle = \"1 rad\" }",
    "{ normal = { mean = \"1 mm\", standard_deviation = \"9 mm\" } }",
    "{ interval = [\"0 mm\", \"1 km\"] }",
    "{ interval = [0.1, 1.5] }",
    "[\"mean\", { quantile = 0.5 }]",
    "{ quantile = 2 }",
    "{ uniform = { lower = \"1e-300 m\", upper = \"1e300 m\" } }",
    "{ coefficient = 1e300, lower_speed = \"1 m/s\" }",
    "{ beta = { alpha = 1e-300, beta = 1e300, lower = \"0 mm\", upper = \"1 mm\" } }",
    "{ crank = [\"1e300 deg\"] }",
    "{ lognormal = { mean = \"1e-300 m\", standard_deviation = \"1e300 m\" } }",
    "{ truncated_normal = { mean = 0.5, standard_deviation = 1e-300, lower = 0.4, upper = 0.6 } }",
];

/// Keys put in place of others.
const KEYS: &[&str] = &[
    "o",
    "ground",
    "crank",
    "main",
    "gudgeon",
    "radial_clearance",
    "stiffness",
    "exponent",
    "start_position",
    "slider",
    "path_of",
    "force_in",
    "along",
    "unit",
    "interval",
    "uniform",
    "beta",
    "reduce",
    "poses",
    "a b",
    "",
    "µ",
    "parameter.crank_length",
    "contact.steel_pin.restitution",
    "joint.gudgeon.bearing_radius",
    "gravity",
    "drive.crank.speed",
    "body.rod.mass",
];

/// One thing done to a file that stays TOML.
#[derive(Debug, Clone)]
enum Change {
    Replace { node: usize, what: usize },
    Remove { node: usize },
    Rename { node: usize, what: usize },
    Graft { node: usize, from: usize, what: usize },
}

fn change() -> impl Strategy<Value = Change> {
    let node = 0..1000_usize;
    prop_oneof![
        3 => (node.clone(), 0..VALUES.len()).prop_map(|(node, what)| Change::Replace { node, what }),
        1 => node.clone().prop_map(|node| Change::Remove { node }),
        1 => (node.clone(), 0..KEYS.len()).prop_map(|(node, what)| Change::Rename { node, what }),
        1 => (node.clone(), node, 0..KEYS.len()).prop_map(|(node, from, what)| Change::Graft { node, from, what }),
    ]
}

/// The paths of all entries below `value`.
fn paths(value: &toml::Value, path: &[String], found: &mut Vec<Vec<String>>) {
    let children: Vec<(String, &toml::Value)> = match value {
        toml::Value::Table(table) => table.iter().map(|(key, below)| (key.clone(), below)).collect(),
        toml::Value::Array(list) => list.iter().enumerate().map(|(index, below)| (index.to_string(), below)).collect(),
        _ => Vec::new(),
    };
    for (key, below) in children {
        let path: Vec<String> = path.iter().cloned().chain([key]).collect();
        found.push(path.clone());
        paths(below, &path, found);
    }
}

fn node<'v>(value: &'v mut toml::Value, path: &[String]) -> Option<&'v mut toml::Value> {
    path.iter().try_fold(value, |value, key| match value {
        toml::Value::Table(table) => table.get_mut(key),
        toml::Value::Array(list) => list.get_mut(key.parse::<usize>().ok()?),
        _ => None,
    })
}

fn parsed_value(text: &str) -> toml::Value {
    let table: toml::Table = format!("v = {text}").parse().unwrap_or_else(|error| panic!("{text}: {error}"));
    table["v"].clone()
}

fn make(file: &mut toml::Value, change: &Change) {
    let mut found = Vec::new();
    paths(file, &[], &mut found);
    if found.is_empty() {
        return;
    }
    let (Change::Replace { node: at, .. }
    | Change::Remove { node: at }
    | Change::Rename { node: at, .. }
    | Change::Graft { node: at, .. }) = *change;
    let path = found[at % found.len()].clone();
    let Some((key, above)) = path.split_last() else { return };
    let grafted = match *change {
        Change::Graft { from, .. } => node(file, &found[from % found.len()]).cloned(),
        _ => None,
    };
    match (change, node(file, above)) {
        (Change::Replace { what, .. }, _) => {
            if let Some(place) = node(file, &path) {
                *place = parsed_value(VALUES[*what]);
            }
        }
        (Change::Remove { .. }, Some(toml::Value::Table(table))) => {
            table.remove(key);
        }
        (Change::Rename { what, .. }, Some(toml::Value::Table(table))) => {
            if let Some(value) = table.remove(key) {
                table.insert(KEYS[*what].to_owned(), value);
            }
        }
        (Change::Graft { what, .. }, Some(toml::Value::Table(table))) => {
            if let Some(value) = grafted {
                table.insert(KEYS[*what].to_owned(), value);
            }
        }
        _ => {}
    }
}

fn cases() -> u32 {
    std::env::var("LOOSEPIN_FUZZ_CASES").ok().and_then(|count| count.parse().ok()).unwrap_or(DEFAULT_CASES)
}

#[test]
fn no_file_with_exchanged_values_makes_the_reader_panic() {
    let config = Config { cases: cases(), failure_persistence: None, ..Config::default() };
    let strategy = (0..TEMPLATES.len(), any::<bool>(), proptest::collection::vec(change(), 1..5));
    let outcome = TestRunner::new(config).run(&strategy, |(template, is_model, changes)| {
        let template = &TEMPLATES[template];
        let text = if is_model { template.model } else { template.study };
        let mut file = toml::Value::Table(text.parse().unwrap_or_else(|error| panic!("{error}")));
        changes.iter().for_each(|change| make(&mut file, change));
        let Ok(text) = toml::to_string(&file) else { return Ok(()) };
        if is_model {
            read_model(text.into_bytes());
        } else {
            read_study(template.model, text.into_bytes());
        }
        Ok(())
    });
    outcome.unwrap_or_else(|failure| panic!("{failure}"));
}

#[test]
fn extreme_files_are_reported() {
    let deep_array = format!("name = {}1{}", "[".repeat(100_000), "]".repeat(100_000));
    let deep_table = format!("name = {}1{}", "{ a = ".repeat(100_000), " }".repeat(100_000));
    let dotted = format!("{}a = 1", "a.".repeat(100_000));
    let parentheses = format!("[parameter]\na = \"{}1\"", "(".repeat(900));
    let chain: String = (0..20_000).map(|index| format!("p{index} = \"p{}\"\n", index + 1)).collect();
    let circle = format!("[parameter]\n{chain}p20000 = \"p0\"\n");
    let ends_open = format!("[parameter]\n{chain}p20000 = \"1 mm\"\n");
    let names: String = (0..5000).map(|index| format!("p{index} = \"q{index} + 1 mm\"\n")).collect();
    let unknown = format!("[parameter]\n{names}");
    let long_line = format!("name = \"{}\"\nmass = 1", "x".repeat(500_000));
    for text in [
        "",
        "\u{feff}",
        "\0",
        "\r",
        "=",
        "[",
        &deep_array,
        &deep_table,
        &dotted,
        &parentheses,
        &circle,
        &ends_open,
        &unknown,
        &long_line,
    ] {
        let diagnostics = Model::from_text("extreme.toml", text).expect_err("no model");
        show(&diagnostics);
    }
}

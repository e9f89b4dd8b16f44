//! Differences between the inputs of two studies: uncertain inputs in words, then every other entry of the two texts, and tables.

use serde::Serialize;

use loosepin_result::repeat::{InputRole, InputText, shell_word};
use loosepin_result::study::{InputDescription, StudyResult};
use loosepin_text::diagnostics::Source;
use loosepin_text::document::{Difference, describe_path, differences};

/// Tables of a study whose entries are described in words.
const UNCERTAIN: [&str; 2] = ["random", "epistemic"];
/// Largest number of entries that are shown.
const MOST: usize = 200;
/// Largest number of characters of an entry that are shown.
const LONGEST: usize = 300;

/// Place of an input of a study.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum InputPlace {
    /// An uncertain input.
    Uncertain,
    /// In the model.
    Model,
    /// In the study.
    Study,
    /// In a table of numbers that the study names.
    Table,
    /// In the command.
    Command,
}

/// An input that two studies have differently.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ChangedInput {
    /// Place of the input.
    pub place: InputPlace,
    /// Its path: `joint.gudgeon.radial_clearance`.
    pub path: String,
    /// The same in words.
    pub words: String,
    /// Entry of A, with its unit; `None` if it has no such entry.
    pub before: Option<String>,
    /// Entry of B.
    pub after: Option<String>,
}

/// The differences; and sentences on what could not be compared.
pub fn changed(pair: [&StudyResult; 2]) -> (Vec<ChangedInput>, Vec<String>) {
    let mut left_out = Vec::new();
    let [model, study] = [InputRole::Model, InputRole::Study].map(|role| texts(pair, role));
    if model.is_none() || study.is_none() {
        left_out.push(
            "A result of an older version does not contain its model and study: only uncertain inputs are compared."
                .to_owned(),
        );
    }
    let mut found = uncertain(pair, model.as_ref());
    let told: Vec<String> = found.iter().map(|input| input.path.clone()).collect();
    for (place, word, texts) in [(InputPlace::Model, "model", &model), (InputPlace::Study, "study", &study)] {
        match texts.as_ref().map(|[before, after]| differences(before, after)) {
            None => {}
            Some(Ok(entries)) => {
                found.extend(entries.into_iter().filter(|entry| !is_told(entry, &told)).map(|entry| {
                    let path = entry.path();
                    let words = describe_path(&path);
                    ChangedInput { place, path, words, before: entry.before, after: entry.after }
                }))
            }
            Some(Err(_)) => left_out.push(format!("The text of a {word} can no longer be read.")),
        }
    }
    found.extend(tables(pair));
    found.extend(command(pair));
    if found.len() > MOST {
        left_out.push(format!("{} more inputs differ.", found.len() - MOST));
        found.truncate(MOST);
    }
    let shortened = |text: String| match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{} …", &text[..end]),
        None => text,
    };
    for input in &mut found {
        input.before = input.before.take().map(shortened);
        input.after = input.after.take().map(shortened);
    }
    (found, left_out)
}

/// The text of a kind in both results; `None` if one of them has none.
fn texts(pair: [&StudyResult; 2], role: InputRole) -> Option<[std::sync::Arc<Source>; 2]> {
    let [before, after] = pair.map(|result| result.repeat.file_of(role));
    let source = |file: &InputText| Source::new(file.name.as_str(), file.text.as_str());
    Some([source(before?), source(after?)])
}

/// Inputs that are uncertain in one of the studies at least, where they are not the same in both.
fn uncertain(pair: [&StudyResult; 2], model: Option<&[std::sync::Arc<Source>; 2]>) -> Vec<ChangedInput> {
    let [before, after] = pair;
    let is_new = |input: &&InputDescription| before.inputs.iter().all(|own| own.path != input.path);
    let all = before.inputs.iter().chain(after.inputs.iter().filter(is_new));
    // What stands in the model of a study that knows the number exactly.
    let exact = |which: usize, path: &str| {
        let texts = model.map(|both| &both[which])?;
        let entries = differences(&Source::new("", ""), texts).ok()?;
        let value = entries.into_iter().find(|entry| entry.path() == path)?.after?;
        Some(format!("exactly {value}"))
    };
    let told = |which: usize, path: &str| {
        let input = pair[which].inputs.iter().find(|input| input.path == path);
        input.map(|input| input.words.clone()).or_else(|| exact(which, path))
    };
    let rows = all.map(|input| ChangedInput {
        place: InputPlace::Uncertain,
        path: input.path.clone(),
        words: describe_path(&input.path),
        before: told(0, &input.path),
        after: told(1, &input.path),
    });
    rows.filter(|row| row.before != row.after).collect()
}

/// Whether an entry of a study belongs to an uncertain input that is described in words.
fn is_told(entry: &Difference, told: &[String]) -> bool {
    let [table, path, ..] = &entry.keys[..] else { return false };
    UNCERTAIN.contains(&table.as_str()) && told.contains(path)
}

fn tables(pair: [&StudyResult; 2]) -> Vec<ChangedInput> {
    let is_table = |file: &&InputText| matches!(file.role, InputRole::Table | InputRole::Measured);
    let of =
        |result: &'_ StudyResult| -> Vec<InputText> { result.repeat.files.iter().filter(is_table).cloned().collect() };
    let both = pair.map(of);
    let mut names: Vec<&str> = both.iter().flatten().map(|file| file.name.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    let file = |which: usize, name: &str| both[which].iter().find(|file| file.name == name);
    let changed = names.into_iter().filter(|name| file(0, name).map(|f| &f.text) != file(1, name).map(|f| &f.text));
    let told = |which: usize, name: &str| file(which, name).map(|file| format!("{} lines", file.text.lines().count()));
    changed
        .map(|name| ChangedInput {
            place: InputPlace::Table,
            path: name.to_owned(),
            words: format!("table {name}"),
            before: told(0, name),
            after: told(1, name),
        })
        .collect()
}

/// What stands behind the file in the commands that make the results again.
fn command(pair: [&StudyResult; 2]) -> Option<ChangedInput> {
    let arguments = pair.map(|result| {
        let file = result.repeat.files.first().map(|file| shell_word(&file.name)).unwrap_or_default();
        let rest = result.repeat.command.split_once(&file).map_or("", |(_, rest)| rest).trim();
        (!rest.is_empty()).then(|| rest.to_owned())
    });
    let [before, after] = arguments;
    let words = "arguments of the command".to_owned();
    (before != after).then_some(ChangedInput {
        place: InputPlace::Command,
        path: "command".to_owned(),
        words,
        before,
        after,
    })
}

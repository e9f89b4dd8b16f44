//! Items removed along with another: all that names it, in both texts, and parameters that nothing uses afterwards.

use std::collections::BTreeSet;

use loosepin::diagnostics::Code;
use loosepin::document::describe_path;
use loosepin::model::Model;

use super::edit::Named;
use super::names::{NameReference, mentions};
use crate::edit::toml::lines::EditedText;
use crate::messages::Document;
use crate::network::refusal::Refusal;

/// What can be taken out here.
const TABLES: [&str; 9] = ["body", "joint", "coupling", "cam", "spring", "load", "drive", "control", "output"];
const GROUND: &str = "ground";
/// The time that counts as a turn once nothing turns: that of an empty sheet.
const DURATION: &str = "\"1 s\"";
/// Parameters that describe others, which describe others again: each round reads the model. Those behind so many stay, and a warning
/// says that nothing uses them.
const MAX_ROUNDS: usize = 20;

/// Both texts without an item, and all removed items, in words: first the requested one.
pub struct Removed {
    /// Text of the model.
    pub model: EditedText,
    /// Text of the study.
    pub study: Option<EditedText>,
    /// Removed items.
    pub gone: BTreeSet<Named>,
    /// The same in words, entries of the study last.
    pub words: Vec<String>,
    /// Paths of the entries of the study that went.
    pub of_study: Vec<Vec<String>>,
    /// Paths of the model that come in place of what went.
    pub added: BTreeSet<String>,
}

/// Takes something out of both texts.
///
/// # Errors
/// It is not there, or the cycle counts the turns of what would go, and another drive stays.
pub fn removed(model: &EditedText, study: Option<&EditedText>, what: &Named) -> Result<Removed, Refusal> {
    if !TABLES.contains(&what.table.as_str()) {
        return Err(Refusal::bad(format!("remove a {} in the text", what.table)));
    }
    if what.table == "body" && what.name == GROUND && what.point.is_none() {
        return Err(Refusal::bad("the ground cannot be removed"));
    }
    let named = mentions(Document::Model, &model.scanned()?);
    if !named.iter().any(|mention| mention.is_own && mention.of == *what) {
        return Err(Refusal::bad(format!("{} no longer exists", what.words())));
    }
    let mut gone = BTreeSet::from([what.clone()]);
    // What names something that goes is part of something that goes too.
    loop {
        let before = gone.len();
        for mention in named.iter().filter(|mention| !mention.is_own) {
            gone.extend(holder(mention).filter(|_| is_gone(&gone, &mention.of)));
        }
        if gone.len() == before {
            break;
        }
    }
    let counted = named.iter().find(|mention| is_counted(mention) && is_gone(&gone, &mention.of));
    if let Some(counted) = counted
        && named.iter().any(|mention| mention.is_own && mention.of.table == "drive" && !is_gone(&gone, &mention.of))
    {
        return Err(counted_elsewhere(counted));
    }
    let added = counted.map(|_| "cycle.duration".to_owned()).into_iter().collect();
    let known = unused_parameters(model);
    let mut rounds = 0;
    loop {
        let mut new_model = without(model, &gone_paths(Document::Model, model, &gone)?)?;
        if counted.is_some() {
            new_model.add_entry(&["cycle"], "duration", DURATION)?;
        }
        // Parameters that described what goes describe nothing any more.
        let fresh: Vec<Named> = unused_parameters(&new_model).difference(&known).cloned().collect();
        rounds += 1;
        if fresh.is_empty() || rounds == MAX_ROUNDS {
            let of_study = match study {
                Some(study) => gone_paths(Document::Study, study, &gone)?,
                None => Vec::new(),
            };
            let study = study.map(|study| without(study, &of_study)).transpose()?;
            let others = gone.iter().filter(|one| *one != what);
            let mut words: Vec<String> = std::iter::once(what).chain(others).map(Named::words).collect();
            words.extend(of_study.iter().map(|path| in_study(path)));
            return Ok(Removed { model: new_model, study, gone, words, of_study, added });
        }
        gone.extend(fresh);
    }
}

/// Whether this is the drive whose turns the cycle counts.
fn is_counted(mention: &NameReference) -> bool {
    mention.path.iter().map(String::as_str).eq(["cycle", "drive"])
}

fn counted_elsewhere(mention: &NameReference) -> Refusal {
    Refusal::bad(format!("the cycle counts the turns of {}, which would also be removed", mention.of.words()))
        .with_hint("let the motor turn another joint first")
}

fn is_gone(gone: &BTreeSet<Named>, of: &Named) -> bool {
    gone.contains(of) || of.point.is_some() && gone.contains(&Named::new(&of.table, &of.name))
}

/// The entry of the model that goes with what a place names; `None` if the place alone does.
fn holder(mention: &NameReference) -> Option<Named> {
    match mention.path.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
        ["assembly" | "initial" | "wear" | "cycle", ..] => None,
        [table, name, ..] => Some(Named::new(table, name)),
        _ => None,
    }
}

/// A text without the entries below some paths.
fn without(lines: &EditedText, paths: &[Vec<String>]) -> Result<EditedText, Refusal> {
    let mut new = lines.clone();
    new.remove(paths)?;
    Ok(new)
}

/// The paths of a text that hold what is gone or name it, each once.
fn gone_paths(document: Document, lines: &EditedText, gone: &BTreeSet<Named>) -> Result<Vec<Vec<String>>, Refusal> {
    let mut paths: Vec<Vec<String>> = Vec::new();
    let mut known: BTreeSet<Vec<String>> = BTreeSet::new();
    let all = mentions(document, &lines.scanned()?);
    let is_guess = |mention: &&NameReference| mention.path.starts_with(&["assembly".to_owned(), "guess".to_owned()]);
    let mut guesses = all.iter().filter(is_guess).peekable();
    if guesses.peek().is_some() && guesses.all(|mention| is_gone(gone, &mention.of)) {
        // Without a guess there is nothing to say of the assembly.
        paths.push(vec!["assembly".to_owned()]);
        known.insert(vec!["assembly".to_owned()]);
    }
    for mention in all.into_iter().filter(|mention| is_gone(gone, &mention.of)) {
        let path: Vec<&str> = mention.path.iter().map(String::as_str).collect();
        let steps = match (document, path.as_slice()) {
            (Document::Model, _) if mention.is_own => mention.path.len(),
            (Document::Model, ["assembly" | "initial", ..]) => 3,
            _ => 2,
        };
        let path = mention.path[..steps.min(mention.path.len())].to_vec();
        if path == ["wear", "limit_of"] {
            // A limit is one of something.
            let limit = vec!["wear".to_owned(), "limit".to_owned()];
            known.insert(limit.clone());
            paths.push(limit);
        }
        if !(1..=path.len()).any(|steps| known.contains(&path[..steps])) {
            known.insert(path.clone());
            paths.push(path);
        }
    }
    Ok(paths)
}

/// An entry of the study in words.
fn in_study(path: &[String]) -> String {
    let number = |step: &str| step.trim_start_matches('#').parse::<usize>().map_or(0, |index| index + 1);
    match path.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
        ["random", of] => format!("the distribution of {} in the study", describe_path(of)),
        ["epistemic", of] => format!("the unknown range of {} in the study", describe_path(of)),
        ["allow", of] => format!("what is allowed for {} in the study", describe_path(of)),
        ["ask", index, ..] => format!("question {} of the study", number(index)),
        ["require", index, ..] => format!("requirement {} of the study", number(index)),
        ["measured", index, ..] => format!("reading {} of the study", number(index)),
        ["correlation", index, ..] => format!("correlation {} of the study", number(index)),
        _ => "an entry of the study".to_owned(),
    }
}

/// Parameters that nothing uses; empty if the model cannot be read.
fn unused_parameters(model: &EditedText) -> BTreeSet<Named> {
    let Ok(model) = Model::from_text("model.toml", model.text()) else { return BTreeSet::new() };
    let unused = model.warnings.iter().filter(|warning| warning.code == Code::Unused);
    // The place of such a warning is the name of what is not used.
    let names = unused.filter_map(|warning| {
        let place = warning.place.as_ref()?;
        let written = &place.source.text()[place.source.clamp(place.span)];
        Some(written.trim_matches(['"', '\'']).to_owned())
    });
    let is_parameter = |name: &String| model.quantities.id(&format!("parameter.{name}")).is_some();
    names.filter(is_parameter).map(|name| Named::new("parameter", &name)).collect()
}

//! A copy of a model and its study beside them.

use std::path::Path;

use axum::http::StatusCode;
use loosepin::files::lock_texts;

use crate::edit::toml::lines::EditedText;
use crate::files::folder::{Folder, not_written, refuse_trash, relative};
use crate::network::refusal::Refusal;
use crate::view::texts::{model_beside, plain};

/// Most copies of one file.
const MAX_COPIES: usize = 1000;

/// Paths of a copy.
#[derive(Debug)]
pub struct Copied {
    /// Path of the model; `None` if the study names none that can be read.
    pub model: Option<String>,
    /// Path of the study; `None` for a model without one.
    pub study: Option<String>,
}

/// Copies the study or model at `path`, a study with its model, under the first free number: `study-2.toml`, `model-2.toml`. The copies
/// keep their bytes but for two entries at the top: the study names the new model, and both have the number in their names.
///
/// # Errors
/// The text cannot be read; it names a model in a way that cannot be changed; the file system refuses.
pub fn duplicate(folder: &Folder, path: &str) -> Result<Copied, Refusal> {
    let path = plain(path);
    refuse_trash(&path)?;
    let text = folder.read(&path)?.text;
    let Some(model_path) = model_beside(&path, &text).map(|model| plain(&model)) else {
        for number in 2..=MAX_COPIES {
            let copy = numbered(&path, number);
            if is_free(folder, &copy)? {
                write_new(folder, &[(&copy, &renamed(&text, number)?)])?;
                return Ok(Copied { model: Some(copy), study: None });
            }
        }
        return Err(too_many(&path));
    };
    let model = folder.read(&model_path)?.text;
    for number in 2..=MAX_COPIES {
        let copies = [numbered(&path, number), numbered(&model_path, number)];
        if !is_free(folder, &copies[0])? || !is_free(folder, &copies[1])? {
            continue;
        }
        let study = with_model(&renamed(&text, number)?, number)?;
        if model_beside(&copies[0], &study).map(|named| plain(&named)).as_deref() != Some(copies[1].as_str()) {
            return Err(Refusal::bad(format!("'{path}' names its model in a way that the copy cannot follow"))
                .with_hint("copy both files by hand"));
        }
        write_new(folder, &[(&copies[1], &renamed(&model, number)?), (&copies[0], &study)])?;
        let [study, model] = copies;
        return Ok(Copied { model: Some(model), study: Some(study) });
    }
    Err(too_many(&path))
}

fn too_many(path: &str) -> Refusal {
    Refusal::new(StatusCode::CONFLICT, format!("'{path}' has {MAX_COPIES} copies"))
        .with_hint("delete some of them, or give them other names")
}

fn is_free(folder: &Folder, path: &str) -> Result<bool, Refusal> {
    let found = folder.opened().find(&relative(path)?);
    Ok(found.map_err(|error| not_written(path, &error))?.is_none())
}

/// `rods/study.toml` as `rods/study-2.toml`.
fn numbered(path: &str, number: usize) -> String {
    let (stem, extension) = path.rsplit_once('.').unwrap_or((path, "toml"));
    format!("{stem}-{number}.{extension}")
}

/// The text with the number behind its name, where it has one.
fn renamed(text: &str, number: usize) -> Result<String, Refusal> {
    with_value(text, "name", |name| format!("{name} {number}"))
}

fn with_model(text: &str, number: usize) -> Result<String, Refusal> {
    with_value(text, "model", |model| numbered(model, number))
}

/// The text with another value of an entry at its top, where there is one in simple quotes.
fn with_value(text: &str, key: &str, new: impl Fn(&str) -> String) -> Result<String, Refusal> {
    let mut edited = EditedText::new(text);
    let Some(span) = edited.value_span(&[key])? else { return Ok(text.to_owned()) };
    let written = &text[span.clone()];
    let quote = &written[..1];
    let inner = written.get(1..written.len().saturating_sub(1)).unwrap_or("");
    if !matches!(quote, "\"" | "'") || inner.starts_with(quote) || inner.contains('\\') {
        return Ok(text.to_owned());
    }
    edited.replace([(span, format!("{quote}{}{quote}", new(inner)))])?;
    Ok(edited.text().to_owned())
}

/// Writes files that are not there yet. Where the second cannot be written, the first goes.
fn write_new(folder: &Folder, files: &[(&str, &str)]) -> Result<(), Refusal> {
    for (done, (path, text)) in files.iter().enumerate() {
        if let Err(refusal) = folder.write(path, text, None) {
            for (path, _) in &files[..done] {
                remove(folder, path);
            }
            return Err(refusal);
        }
    }
    Ok(())
}

fn remove(folder: &Folder, path: &str) {
    let path = Path::new(path);
    let parent = folder.opened().open_below(path.parent().unwrap_or(Path::new("")));
    let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    let _ = parent.and_then(|parent| lock_texts(&parent)).and_then(|lock| lock.remove(name));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_entries_change_and_all_other_bytes_stay() {
        let text = "# mine\r\nname = \"worn\"  # the old one\r\nmodel = '../model.toml'\r\n[ask]\r\nname = \"x\"\r\n";
        let study = with_model(&renamed(text, 3).unwrap(), 3).unwrap();
        assert_eq!(study, text.replace("\"worn\"", "\"worn 3\"").replace("model.toml", "model-3.toml"));
        assert_eq!(renamed("[body.crank]\n", 2).unwrap(), "[body.crank]\n");
        assert!(renamed("name = [\n", 2).is_err());
        assert_eq!(numbered("a.b/study.v1.toml", 2), "a.b/study.v1-2.toml");
    }
}

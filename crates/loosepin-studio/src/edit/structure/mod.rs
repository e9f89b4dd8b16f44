//! Links, joints and bodies of a mechanism that come, go, and get other names: from both texts and a wish to new texts.
//!
//! | What | File |
//! |---|---|
//! | what can be wished | `edit.rs` |
//! | which places name a body, a point, a joint, ... | `names.rs` |
//! | what comes: links, points, joints, blocks, outputs | `add.rs` |
//! | what an output records | `watch.rs` |
//! | what goes with something that goes | `remove.rs` |
//! | another name | `rename.rs` |
//! | numbers that dragging leaves as they are | `lock.rs` |
//! | whether the new texts say what they are to say | `checked.rs` |
//!
//! The texts are changed by `edit/toml`.

mod add;
mod checked;
mod edit;
mod lock;
mod names;
mod remove;
mod rename;
mod watch;

use loosepin::document::describe_path;
use loosepin::model::{Model, Origin};
use serde::Serialize;

use add::Draft;
use checked::{IntendedChange, check, said};
use edit::{Joined, Named};
use remove::{Removed, removed};
use rename::renamed;

use super::set_uncertainty::known_texts;
use super::toml::change::changes;
use super::toml::lines::EditedText;
use crate::drawing::still::{NamedPoses, placed};
use crate::files::folder::Folder;
use crate::messages::{Change, Document};
use crate::network::refusal::Refusal;
use crate::view::texts::Texts;

pub use checked::why_not;
pub use edit::Edit;
pub use lock::Locks;

/// The changes of an edit, and notes on them.
#[derive(Debug, Serialize)]
pub struct Restructured {
    /// In units of the texts that were sent, in their order.
    pub changes: Vec<Change>,
    /// Degrees of freedom in words, or what is missing.
    pub says: Vec<String>,
    /// The mechanism moves as its drives say.
    pub is_complete: bool,
    /// Removed items, in words.
    pub gone: Vec<String>,
    /// Name of what came.
    pub name: Option<String>,
    /// Poses of new bodies: x and y, mm, and the angle, degrees.
    pub poses: NamedPoses,
}

/// What comes of an edit before it is checked.
struct New {
    model: EditedText,
    study: Option<EditedText>,
    due: IntendedChange,
    gone: Vec<String>,
    name: Option<String>,
    poses: NamedPoses,
}

/// The changes of both texts that an edit makes, with the bodies at these poses. All bytes that it does not concern stay.
///
/// # Errors
/// Why there is no such change, in words.
pub fn restructured(folder: &Folder, texts: &Texts, edit: &Edit, poses: &NamedPoses) -> Result<Restructured, Refusal> {
    let (after, new) = after(folder, texts, edit, poses)?;
    let said = said(texts, &after);
    let mut list = changes(Document::Model, &texts.model, after.model.text());
    if let (Some(old), Some(new)) = (&texts.study, &after.study) {
        list.extend(changes(Document::Study, old, new.text()));
    }
    Ok(Restructured {
        changes: list,
        says: said.words,
        is_complete: said.is_complete,
        gone: new.gone,
        name: new.name,
        poses: new.poses,
    })
}

/// The texts after an edit: read again, and found to say what they are to say.
fn after(folder: &Folder, texts: &Texts, edit: &Edit, poses: &NamedPoses) -> Result<(Texts, New), Refusal> {
    let model = texts.planar_model()?;
    let new = changed(&model, texts, edit, poses)?;
    let study = new.study.as_ref().map(EditedText::text);
    let mut after = texts.with(folder, Some(new.model.text()), study);
    check(texts, &after, &new.due)?;
    if let (Edit::Join { by: Joined::Pin { play: Some(play) }, .. }, Some(joint)) = (edit, &new.name)
        && !play.trim().is_empty()
    {
        let path = format!("joint.{joint}.radial_clearance");
        let (model, study) = known_texts(folder, &after, &path, play)?;
        after = after.with(folder, model.as_deref(), study.as_deref());
    }
    Ok((after, new))
}

fn changed(model: &Model, texts: &Texts, edit: &Edit, poses: &NamedPoses) -> Result<New, Refusal> {
    let text = texts.model.text();
    let lines = EditedText::new(text);
    let study = texts.study.as_ref().map(|study| EditedText::new(study.text()));
    let draft = || Draft::new(model, &placed(model, poses), text);
    let added = |draft: Draft<'_>, name: String| {
        let drafted = draft.finished();
        let due = IntendedChange { added: drafted.added, ..IntendedChange::default() };
        let (name, poses) = (Some(name), drafted.new_poses);
        New { model: drafted.lines, study: study.clone(), due, gone: Vec::new(), name, poses }
    };
    let plain = |model, study, due, gone| New { model, study, due, gone, name: None, poses: NamedPoses::new() };
    let mut draft = draft();
    Ok(match edit {
        Edit::AddLink { from, to } => {
            let name = draft.add_link(from, to)?;
            added(draft, name)
        }
        Edit::AddPoint { body, to } => {
            let name = draft.add_point(body, to)?;
            added(draft, name)
        }
        Edit::Join { first, second, by } => {
            let name = draft.join(first, second, by)?;
            added(draft, name)
        }
        Edit::AddBlock { on, angle_deg } => {
            let name = draft.add_block(on, *angle_deg)?;
            added(draft, name)
        }
        Edit::Drive { joint } => {
            let name = draft.drive(joint)?;
            added(draft, name)
        }
        Edit::Watch { what } => {
            let name = draft.watch(what)?;
            let mut new = added(draft, name.clone());
            if let Some(study) = new.study.as_mut().filter(|study| asks_nothing(study)) {
                study.insert(study.text().len(), &watch::question(what, &name))?;
                new.due.asked = Some(Named::new("output", &name));
            }
            new
        }
        Edit::Remove { what } => {
            let Removed { model, study, gone, words, of_study, added } = removed(&lines, study.as_ref(), what)?;
            let due = IntendedChange { gone, of_study, added, ..IntendedChange::default() };
            plain(model, study, due, words)
        }
        Edit::Rename { what, to } => {
            let (model, study) = renamed(&lines, study.as_ref(), what, to)?;
            let due = IntendedChange { renamed: Some((what.clone(), to.clone())), ..IntendedChange::default() };
            plain(model, study, due, Vec::new())
        }
        Edit::Lock { path, is_locked } => {
            let quantity = model.quantities.id(path).map(|id| &model.quantities[id]);
            let quantity = quantity.ok_or_else(|| Refusal::bad(format!("the model has no number '{path}'")))?;
            let span = quantity.span.filter(|_| quantity.origin == Origin::Literal).ok_or_else(|| {
                Refusal::bad(format!("{} is not written as a number", describe_path(path)))
                    .with_hint("lock the values on which it depends")
            })?;
            let new = lock::locked(&lines, span.start, *is_locked)?;
            plain(new, study, IntendedChange::default(), Vec::new())
        }
    })
}

/// Whether a study has no question and no requirement; of one that cannot be read nothing is said.
fn asks_nothing(study: &EditedText) -> bool {
    let is_question = |path: &[String]| path.first().is_some_and(|first| first == "ask" || first == "require");
    study.scanned().is_ok_and(|scanned| !scanned.statements.iter().any(|one| is_question(&one.path)))
}

#[cfg(test)]
mod tests;

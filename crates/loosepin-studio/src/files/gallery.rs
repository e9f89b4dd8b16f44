//! Mechanisms moving in small pictures: the templates, and models and studies of the served folder.

use std::sync::atomic::AtomicBool;

use loosepin::diagnostics::Severity;
use loosepin::report::{MovingDrawing, SpaceDrawing, motion_drawing, moving_drawing};
use loosepin::templates::{Template, all_templates};
use serde::Serialize;

use crate::files::folder::Folder;
use crate::messages::{Look, SentText};
use crate::network::refusal::Refusal;
use crate::view::look::answer_look;
use crate::view::texts::{Texts, model_beside, plain};

/// Positions in a turn of a small picture.
const POSITIONS: usize = 36;

/// A template as the page shows it.
#[derive(Debug, Serialize)]
pub struct TemplateCard {
    /// Its name, by which it is made.
    name: &'static str,
    /// What it is, in a few words.
    title: &'static str,
    /// What is to be seen in it.
    words: String,
    /// The mechanism, moving; `None` of one in space.
    drawing: Option<MovingDrawing>,
    /// The mechanism in space, moving.
    space: Option<SpaceDrawing>,
}

/// All templates in the order in which they are listed.
pub fn cards(folder: &Folder) -> Vec<TemplateCard> {
    all_templates().map(|template| card(folder, template)).collect()
}

fn card(folder: &Folder, template: &Template) -> TemplateCard {
    let model = SentText { path: "model.toml".to_owned(), text: template.model.to_owned() };
    let texts = Texts::sent(folder, &Look::of(model, None, POSITIONS));
    let file = texts.read().ok();
    let record = file.as_ref().and_then(|file| file.drawn_motion(POSITIONS).ok());
    let (driven, space) = record.map_or((None, None), |record| motion_drawing(&record));
    let controlled = || moving_drawing(&file.as_ref()?.controlled_drawing(POSITIONS)?, "the cycle");
    TemplateCard {
        name: template.name,
        title: template.description(),
        words: template.paragraph(),
        drawing: driven.or_else(controlled),
        space,
    }
}

/// A model or study of the folder as the page shows it.
#[derive(Debug, Default, Serialize)]
pub struct OwnCard {
    /// The mechanism, moving; `None` of one in space, or if the model cannot be read.
    pub drawing: Option<MovingDrawing>,
    /// The mechanism in space, moving.
    pub space: Option<SpaceDrawing>,
    /// The first error in the texts.
    pub error: Option<String>,
}

/// The model or study at `path`. It comes to its end soon after `stop` is set, and is good for nothing then.
///
/// # Errors
/// There is no such text.
pub fn own_card(folder: &Folder, path: &str, stop: &AtomicBool) -> Result<OwnCard, Refusal> {
    let text = folder.read(path)?.text;
    let sent = |path: &str, text: String| SentText { path: path.to_owned(), text };
    let (model, study) = match model_beside(path, &text).map(|model| plain(&model)) {
        None => (sent(path, text), None),
        Some(model_path) => match folder.read(&model_path) {
            Ok(model) => (sent(&model_path, model.text), Some(sent(path, text))),
            Err(refusal) => return Ok(OwnCard { error: Some(refusal.message), ..OwnCard::default() }),
        },
    };
    let poses = Some(Default::default());
    let (seen, _) = answer_look(folder, &Look { poses, ..Look::of(model, study, POSITIONS) }, stop);
    let error = seen.diagnostics.into_iter().find(|one| one.severity == Severity::Error).map(|one| {
        let name = one.path.as_deref().and_then(|path| path.rsplit('/').next().map(str::to_owned));
        match (name, one.stretch) {
            (Some(name), Some(stretch)) => format!("{name}, line {}: {}", stretch.line, one.message),
            _ => one.message,
        }
    });
    let (drawing, space) = seen.view.map_or((None, None), |view| (view.drawing, view.space));
    Ok(OwnCard { drawing, space, error })
}

//! The templates with their mechanisms moving.

use loosepin::report::{MovingDrawing, moving_drawing};
use loosepin::templates::{TEMPLATES, Template};
use serde::Serialize;

use crate::files::folder::Folder;
use crate::messages::{Look, SentText};
use crate::view::texts::Texts;

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
    /// The mechanism, moving.
    drawing: Option<MovingDrawing>,
}

/// All templates in the order in which they are listed.
pub fn cards(folder: &Folder) -> Vec<TemplateCard> {
    TEMPLATES.iter().map(|template| card(folder, template)).collect()
}

fn card(folder: &Folder, template: &Template) -> TemplateCard {
    let model = SentText { path: "model.toml".to_owned(), text: template.model.to_owned() };
    let texts =
        Texts::sent(folder, &Look { seq: 0, model, study: None, positions: POSITIONS, grip: None, poses: None });
    let file = texts.read().ok();
    let record = file.as_ref().and_then(|file| file.ideal_motion(POSITIONS, &[]).ok());
    let driven = record.and_then(|record| moving_drawing(&record.drawing, &record.drive));
    let controlled = || moving_drawing(&file.as_ref()?.controlled_drawing(POSITIONS)?, "the cycle");
    TemplateCard {
        name: template.name,
        title: template.description(),
        words: template.paragraph(),
        drawing: driven.or_else(controlled),
    }
}

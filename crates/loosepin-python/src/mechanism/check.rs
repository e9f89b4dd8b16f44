//! What is known of a model or a study before it runs, as the command `loosepin check` says it.

use loosepin::article::{Article, Cell, Content, Medium, Section, Text};
use loosepin::check::check_until;
use loosepin::report::article_text;
use loosepin::study::InputFile;
use pyo3::prelude::*;

use crate::error::raise;
use crate::waiting::until_interrupted;

/// A description in sections.
#[pyclass(frozen, module = "loosepin._loosepin")]
pub struct Check(Article);

impl Check {
    /// Moves the mechanism of `file` for the first time, and describes it.
    pub fn of_file(py: Python<'_>, file: InputFile) -> PyResult<Self> {
        until_interrupted(py, |stop| check_until(&file, stop))?.map(Self).map_err(raise)
    }
}

/// Anchor, heading, and facts: each a name, which may be empty, with its lines.
type Part = (&'static str, String, Vec<(String, Vec<String>)>);

#[pymethods]
impl Check {
    /// What the terminal shows.
    fn text(&self) -> String {
        article_text(&self.0, None)
    }

    /// The title.
    #[getter]
    fn title(&self) -> &str {
        &self.0.title
    }

    /// The sections with what a terminal shows of them.
    fn sections(&self) -> Vec<Part> {
        let of = |section: &Section| (section.id, words(&section.heading), facts(section));
        self.0.sections.iter().map(of).collect()
    }
}

fn words(text: &Text) -> String {
    text.words_on(Medium::Terminal)
}

fn facts(section: &Section) -> Vec<(String, Vec<String>)> {
    let nameless = |text: &Text| (String::new(), vec![words(text)]);
    let of_content = |content: &Content| match content {
        Content::Facts(facts) => {
            facts.iter().map(|fact| (fact.name.clone(), fact.lines.iter().map(words).collect())).collect()
        }
        Content::Sentences(texts) | Content::Points(texts) => texts.iter().map(nameless).collect(),
        Content::Heading(text) | Content::Note(text) => vec![nameless(text)],
        Content::Table(table) => {
            let rows = table.groups.iter().flat_map(|group| &group.rows);
            rows.map(|row| (String::new(), row.iter().map(cell_words).collect())).collect()
        }
        Content::Figure(_) => Vec::new(),
    };
    section.blocks_on(Medium::Terminal).flat_map(|block| -> Vec<_> { of_content(&block.content) }).collect()
}

fn cell_words(cell: &Cell) -> String {
    match cell {
        Cell::Text(text) => words(text),
        Cell::Drawn { text, .. } => text.clone(),
        Cell::Nothing => String::new(),
    }
}

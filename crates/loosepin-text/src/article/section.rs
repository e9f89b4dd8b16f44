//! An article and its sections.

use super::table::Table;
use super::text::{Medium, Text};

/// All that is said of one thing.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Article {
    /// Title.
    pub title: String,
    /// Its sections in their order.
    pub sections: Vec<Section>,
}

/// Blocks below a heading.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Section {
    /// Anchor of links on the page.
    pub id: &'static str,
    /// The heading; empty where the section needs none.
    pub heading: Text,
    /// Its blocks in their order.
    pub blocks: Vec<Block>,
}

/// A part of a section.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Block {
    /// Its content.
    pub content: Content,
    /// The only medium that shows it; `None` if both do.
    pub only: Option<Medium>,
    /// Whether a terminal leaves no blank line before it.
    pub is_close: bool,
}

/// Content of a block. A block without content is not shown.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Content {
    /// A heading within the section.
    Heading(Text),
    /// Sentences, each a paragraph; each begins a line of a terminal.
    Sentences(Vec<Text>),
    /// A remark on the content before it, such as where the rest is.
    Note(Text),
    /// Sentences in a list.
    Points(Vec<Text>),
    /// Names and facts about them.
    Facts(Vec<Fact>),
    /// A table.
    Table(Table),
    /// A figure as HTML, for the page alone.
    Figure(String),
}

/// A name and the facts about it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fact {
    /// The name; empty where the lines say themselves what they are of.
    pub name: String,
    /// The facts, one per line.
    pub lines: Vec<Text>,
}

impl Fact {
    /// A name with its lines.
    pub fn new<T: Into<Text>>(name: impl Into<String>, lines: impl IntoIterator<Item = T>) -> Fact {
        Fact { name: name.into(), lines: lines.into_iter().map(Into::into).collect() }
    }

    /// A line that names its subject itself.
    pub fn nameless(line: impl Into<Text>) -> Fact {
        Fact { name: String::new(), lines: vec![line.into()] }
    }
}

impl Content {
    /// Sentences of words, each a paragraph.
    pub fn sentences<T: Into<Text>>(sentences: impl IntoIterator<Item = T>) -> Content {
        Content::Sentences(sentences.into_iter().map(Into::into).collect())
    }

    /// Sentences of words in a list.
    pub fn points<T: Into<Text>>(points: impl IntoIterator<Item = T>) -> Content {
        Content::Points(points.into_iter().map(Into::into).collect())
    }

    /// Whether a medium shows nothing of it.
    pub fn is_empty_on(&self, medium: Medium) -> bool {
        match self {
            Content::Heading(text) | Content::Note(text) => text.is_empty_on(medium),
            Content::Sentences(texts) | Content::Points(texts) => texts.iter().all(|text| text.is_empty_on(medium)),
            Content::Facts(facts) => facts.is_empty(),
            Content::Table(table) => table.groups.iter().all(|group| group.rows.is_empty()),
            Content::Figure(_) => medium == Medium::Terminal,
        }
    }
}

impl Section {
    /// A section without blocks.
    pub fn new(id: &'static str, heading: impl Into<Text>) -> Section {
        Section { id, heading: heading.into(), blocks: Vec::new() }
    }

    /// A section whose heading only the page shows.
    pub fn headed_on_page(id: &'static str, heading: &str) -> Section {
        Section::new(id, Text::by_medium(heading, ""))
    }

    /// Facts below a heading.
    pub fn of_facts(id: &'static str, heading: impl Into<Text>, facts: impl IntoIterator<Item = Fact>) -> Section {
        let mut section = Section::new(id, heading);
        section.push_close(Content::Facts(facts.into_iter().collect()));
        section
    }

    /// Sentences that need no heading.
    pub fn of_sentences<T: Into<Text>>(id: &'static str, sentences: impl IntoIterator<Item = T>) -> Section {
        let mut section = Section::new(id, "");
        section.push(Content::sentences(sentences));
        section
    }

    /// Adds a block, separated from the block before it.
    pub fn push(&mut self, content: Content) {
        self.blocks.push(Block { content, only: None, is_close: false });
    }

    /// Adds a block, without separation from the block before it.
    pub fn push_close(&mut self, content: Content) {
        self.blocks.push(Block { content, only: None, is_close: true });
    }

    /// Adds a block for only one medium, without separation from the block before it.
    pub fn push_close_on(&mut self, medium: Medium, content: Content) {
        self.blocks.push(Block { content, only: Some(medium), is_close: true });
    }

    /// Adds a block for only one medium, separated from the block before it.
    pub fn push_on(&mut self, medium: Medium, content: Content) {
        self.blocks.push(Block { content, only: Some(medium), is_close: false });
    }

    /// The blocks that a medium shows.
    pub fn blocks_on(&self, medium: Medium) -> impl Iterator<Item = &Block> {
        let is_shown =
            move |block: &&Block| block.only.is_none_or(|only| only == medium) && !block.content.is_empty_on(medium);
        self.blocks.iter().filter(is_shown)
    }
}

//! A text with emphasised parts.

/// Medium of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Medium {
    /// A page: typographic minus, superscripts, thousands apart, emphasis, figures.
    Page,
    /// A terminal: characters that can be copied back into a program.
    Terminal,
}

/// Emphasis of a part of a text; a terminal shows all of it as plain text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Emphasis {
    /// It does not.
    Plain,
    /// What is to be seen first.
    Strong,
    /// A remark: small, and below the number in a cell of a table.
    Quiet,
    /// The name of a file, or what is typed.
    Code,
}

/// A part of a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Span {
    /// Its characters.
    pub text: String,
    /// How it stands out.
    pub emphasis: Emphasis,
    /// The only medium that shows it; `None` if both do.
    pub only: Option<Medium>,
}

/// A sentence, the content of a cell, a heading.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Text {
    /// Its parts in their order, with their own spaces between them.
    pub spans: Vec<Span>,
}

impl Text {
    /// A text that each medium has its own words for.
    pub fn by_medium(page: impl Into<Text>, terminal: impl Into<Text>) -> Text {
        Text::default().on(Medium::Page, page).on(Medium::Terminal, terminal)
    }

    /// Adds plain words.
    #[must_use]
    pub fn plain(self, text: impl Into<String>) -> Text {
        self.with(Emphasis::Plain, text)
    }

    /// Adds emphasised words.
    #[must_use]
    pub fn strong(self, text: impl Into<String>) -> Text {
        self.with(Emphasis::Strong, text)
    }

    /// Adds a remark.
    #[must_use]
    pub fn quiet(self, text: impl Into<String>) -> Text {
        self.with(Emphasis::Quiet, text)
    }

    /// Adds the name of a file, or what is typed.
    #[must_use]
    pub fn code(self, text: impl Into<String>) -> Text {
        self.with(Emphasis::Code, text)
    }

    /// Adds what only one medium shows.
    #[must_use]
    pub fn on(mut self, medium: Medium, text: impl Into<Text>) -> Text {
        let spans = text.into().spans.into_iter();
        self.spans.extend(spans.map(|span| Span { only: Some(medium), ..span }));
        self
    }

    /// Adds another text.
    #[must_use]
    pub fn then(mut self, text: impl Into<Text>) -> Text {
        self.spans.extend(text.into().spans);
        self
    }

    fn with(mut self, emphasis: Emphasis, text: impl Into<String>) -> Text {
        self.spans.push(Span { text: text.into(), emphasis, only: None });
        self
    }

    /// The parts that a medium shows.
    pub fn spans_on(&self, medium: Medium) -> impl Iterator<Item = &Span> {
        self.spans.iter().filter(move |span| span.only.is_none_or(|only| only == medium))
    }

    /// The words that a medium shows, without emphasis.
    pub fn words_on(&self, medium: Medium) -> String {
        self.spans_on(medium).map(|span| span.text.as_str()).collect()
    }

    /// Whether a medium shows nothing of it.
    pub fn is_empty_on(&self, medium: Medium) -> bool {
        self.spans_on(medium).all(|span| span.text.is_empty())
    }
}

impl From<String> for Text {
    fn from(text: String) -> Text {
        Text::default().plain(text)
    }
}

impl From<&str> for Text {
    fn from(text: &str) -> Text {
        Text::default().plain(text)
    }
}

#[cfg(test)]
mod tests {
    use super::{Medium, Text};

    #[test]
    fn each_medium_shows_its_own_parts() {
        let text = Text::from("3 more bounds").on(Medium::Page, Text::from(" are")).plain(" in ").code("bounds.csv");
        assert_eq!(text.words_on(Medium::Page), "3 more bounds are in bounds.csv");
        assert_eq!(text.words_on(Medium::Terminal), "3 more bounds in bounds.csv");
        assert!(Text::by_medium("on the page", "").is_empty_on(Medium::Terminal));
    }
}

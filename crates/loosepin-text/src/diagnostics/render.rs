//! Diagnostics as text: plain lines for programs, annotated source for people.

use std::fmt;

use annotate_snippets::{Annotation, AnnotationKind, Group, Level, Renderer, Snippet};

use super::visible::visible;
use super::{Diagnostic, Diagnostics, Severity};

/// Diagnostics shown before the rest is only counted.
const MAX_SHOWN: usize = 50;

/// Whether annotated source is coloured by terminal escapes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Colour {
    /// Plain text.
    Never,
    /// With escapes, for a terminal.
    Always,
}

/// `file:line:column: error[E0102]: message`, and the hint on a line of its own.
impl fmt::Display for Diagnostic {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(place) = &self.place {
            let (line, column) = place.line_and_column();
            write!(formatter, "{}:{line}:{column}: ", visible(place.source.name()))?;
        }
        write!(formatter, "{}[{}]: {}", self.severity, self.code, self.message)?;
        for label in &self.labels {
            let (line, column) = label.place.line_and_column();
            write!(formatter, "\n{}:{line}:{column}: note: {}", visible(label.place.source.name()), label.text)?;
        }
        match &self.hint {
            Some(hint) => write!(formatter, "\nhint: {hint}"),
            None => Ok(()),
        }
    }
}

/// The plain form of each diagnostic, one after the other.
impl fmt::Display for Diagnostics {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, diagnostic) in self.sorted().iter().take(MAX_SHOWN).enumerate() {
            if index > 0 {
                writeln!(formatter)?;
            }
            write!(formatter, "{diagnostic}")?;
        }
        match self.unshown() {
            0 => Ok(()),
            more => write!(formatter, "\nand {more} more"),
        }
    }
}

impl Diagnostics {
    fn unshown(&self) -> usize {
        self.len().saturating_sub(MAX_SHOWN)
    }

    /// The diagnostics with the lines that they are about, for a terminal.
    pub fn render(&self, colour: Colour) -> String {
        let renderer = match colour {
            Colour::Never => Renderer::plain(),
            Colour::Always => Renderer::styled(),
        };
        let mut text = String::new();
        for diagnostic in self.sorted().into_iter().take(MAX_SHOWN) {
            text.push_str(&diagnostic.render(&renderer));
            text.push_str("\n\n");
        }
        if self.unshown() > 0 {
            text.push_str(&format!("and {} more\n", self.unshown()));
        }
        text
    }
}

impl Diagnostic {
    fn render(&self, renderer: &Renderer) -> String {
        let level = match self.severity {
            Severity::Error => Level::ERROR,
            Severity::Warning => Level::WARNING,
        };
        let title = level.primary_title(self.message.as_str()).id(self.code.as_str());
        let mut group = Group::with_title(title);
        if let Some(place) = &self.place {
            group = group.element(
                Snippet::source(place.source.text())
                    .path(visible(place.source.name()))
                    .annotation(AnnotationKind::Primary.span(place.source.clamp(place.span)))
                    .annotations(self.labels_in(place.source.name())),
            );
        }
        for label in &self.labels {
            let same_file = self.place.as_ref().is_some_and(|place| place.source.name() == label.place.source.name());
            if !same_file {
                group = group.element(
                    Snippet::source(label.place.source.text())
                        .path(visible(label.place.source.name()))
                        .annotation(annotation(label)),
                );
            }
        }
        if let Some(hint) = &self.hint {
            group = group.element(Level::HELP.with_name("hint").message(hint.as_str()));
        }
        renderer.render(&[group])
    }

    fn labels_in(&self, file: &str) -> Vec<Annotation<'_>> {
        self.labels.iter().filter(|label| label.place.source.name() == file).map(annotation).collect()
    }
}

fn annotation(label: &super::Label) -> Annotation<'_> {
    AnnotationKind::Context.span(label.place.source.clamp(label.place.span)).label(label.text.as_str())
}

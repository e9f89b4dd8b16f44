//! The frame of every page: head with embedded style and scripts, title, sections, foot. Nothing is loaded.

use std::time::{Duration, SystemTime, UNIX_EPOCH};

use loosepin_result::simulation::{Drawing, Override};
use loosepin_text::date::date_for_reading;
use maud::{DOCTYPE, Markup, PreEscaped, html};

use crate::charts::figure::with_unique_names;
use crate::mechanism::figure::start_deg;
use crate::medium::styles::{COLOURS, FIGURE_STYLE, saved_style};

const STYLE: &str = include_str!("../../assets/report.css");
/// In the head, before anything is shown.
const FIRST_SCRIPT: &str = include_str!("../../assets/live.js");
/// What makes the page live, in the order in which it is needed; written in TypeScript, in `scripts`.
const SHARED_SCRIPTS: [&str; 2] = [include_str!("../../assets/ticks.js"), include_str!("../../assets/cursor.js")];
const FIGURE_SCRIPTS: [&str; 10] = [
    // Closes sections before any figure asks for its room.
    include_str!("../../assets/fold.js"),
    // Takes the figures as they are before the next ones make them live.
    include_str!("../../assets/save.js"),
    include_str!("../../assets/chart.js"),
    include_str!("../../assets/orbit.js"),
    include_str!("../../assets/trace.js"),
    // Hides figures: those before it have been drawn.
    include_str!("../../assets/chooser.js"),
    include_str!("../../assets/mechanism.js"),
    include_str!("../../assets/space-scene.js"),
    include_str!("../../assets/space.js"),
    include_str!("../../assets/what-if.js"),
];
/// What a document in a frame of a notebook has on top.
const FRAME_STYLE: &str = include_str!("../../assets/frame.css");
const FRAME_SCRIPT: &str = include_str!("../../assets/frame.js");
/// The widget around the frame, a module of its own.
const WIDGET_SCRIPT: &str = include_str!("../../assets/widget.js");
/// A browser must not fetch anything for these pages, even if text in them asked for it.
const CONTENT_POLICY: &str =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:; base-uri 'none'";

/// The JavaScript module of anywidget that shows the document of a frame (`simulation_frame`, `study_frame`) in a notebook. Its model has
/// the document, a title, and the angle of the cursor in rad: `_document`, `_title`, `drive_angle_rad`.
pub fn widget_script() -> &'static str {
    WIDGET_SCRIPT
}

/// The first screen of a page as a document for a frame in a notebook.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame {
    /// HTML that needs no network.
    pub document: String,
    /// Where its cursor stands at first, rad, in the angles of the record; `None` if it draws no mechanism.
    pub drive_angle_rad: Option<f64>,
}

/// One section of a page.
pub(crate) struct Section {
    pub id: &'static str,
    pub title: String,
    pub body: Markup,
}

impl Section {
    pub fn new(id: &'static str, title: impl Into<String>, body: Markup) -> Self {
        Section { id, title: title.into(), body }
    }

    /// The section with its heading as the handle that opens and closes it. It is written open, so that it can be read without scripts.
    fn folded(&self) -> Markup {
        html! {
            section id=(self.id) aria-labelledby={ (self.id) "-title" } {
                details.fold open {
                    summary { h2 id={ (self.id) "-title" } { (self.title) } }
                    (self.body)
                }
            }
        }
    }

    fn element(&self) -> Markup {
        html! {
            section id=(self.id) aria-labelledby={ (self.id) "-title" } {
                h2 id={ (self.id) "-title" } { (self.title) }
                (self.body)
            }
        }
    }
}

/// A whole page.
pub(crate) struct Page {
    /// Title of the window and the first heading.
    pub title: String,
    /// Kind of page, above the title.
    pub kicker: &'static str,
    /// The line below the title.
    pub subtitle: Markup,
    /// The answer, before everything else.
    pub answer: Markup,
    /// Whether the chart has room below the answer, beside the mechanism.
    pub is_answer_short: bool,
    /// The mechanism, on the right of the answer.
    pub beside: Markup,
    /// The chart that the answer is about, below both.
    pub below: Markup,
    /// What the first screen has below the chart.
    pub more: Markup,
    /// Whether the sections are closed until a reader opens them; a list of links stands before them otherwise.
    pub is_folded: bool,
    pub sections: Vec<Section>,
    /// Name of the computation: `study 1f3a5b7c`.
    pub identity: String,
    pub version: String,
}

impl Page {
    pub fn into_html(self) -> String {
        let date = written_at();
        let body = html! {
            a.skip href="#content" { "Skip to the answer" }
            header {
                p.kicker { (self.kicker) @if let Some(date) = &date { span.date { " · " (date) } } }
                h1 { (self.title) }
                p.subtitle { (self.subtitle) }
            }
            main id="content" {
                (self.opening())
                @if self.is_folded { (self.folded_sections()) } @else { (self.linked_sections()) }
            }
            footer {
                p.help {
                    "Charts: drag to zoom in, double-click to zoom out. Click a name below a chart to hide or show its \
                     curve. Keyboard: arrows move the cursor, + and − zoom, 0 shows all. One cursor moves mechanism and charts."
                }
                p { "Written by loosepin " (self.version) ". This page works offline and loads nothing." }
            }
        };
        self.document(&foot_of_sheets(&self.title, &self.identity), &body, &[])
    }

    /// The first screen of the page and those of its sections that are named, for a frame in a notebook. The script of the frame exchanges
    /// the angle of the cursor with the notebook, in the angles of the record: `turns_before_deg` more than those of the charts.
    pub fn into_frame(self, sections: &[&str], turns_before_deg: f64, drawing: &Drawing) -> Frame {
        let body = html! {
            main id="content" data-turns-before=(turns_before_deg) {
                h1 { (self.title) }
                (self.opening())
                @for section in self.sections.iter().filter(|section| sections.contains(&section.id)) { (section.element()) }
            }
        };
        Frame {
            document: self.document(FRAME_STYLE, &body, &[FRAME_SCRIPT]),
            drive_angle_rad: start_deg(drawing).map(|start_deg| (turns_before_deg + start_deg).to_radians()),
        }
    }

    fn linked_sections(&self) -> Markup {
        html! {
            nav aria-label="On this page" {
                ol {
                    @for section in &self.sections {
                        li { a href={ "#" (section.id) } { (section.title) } }
                    }
                }
            }
            @for section in &self.sections { (section.element()) }
        }
    }

    fn folded_sections(&self) -> Markup {
        html! {
            div.folds {
                div.fold-all { button type="button" { "Open all sections" } }
                // Written by the script when the page is printed.
                p.left-out hidden {}
                @for section in &self.sections { (section.folded()) }
            }
        }
    }

    /// The first screen: the answer, the mechanism, the chart, and what is to be seen with them.
    fn opening(&self) -> Markup {
        html! {
            div class=(if self.is_answer_short { "opening short" } else { "opening" }) {
                section.answer id="answer" aria-label="The answer" { (self.answer) }
                div.figures {
                    div.beside { (self.beside) }
                    div.below { (self.below) }
                }
                @if !self.more.0.is_empty() { div.more { (self.more) } }
            }
        }
    }

    /// What all documents have; `style` stands behind its styles, and `scripts` run before the figures become live.
    fn document(&self, style: &str, body: &Markup, scripts: &[&str]) -> String {
        let scripts = SHARED_SCRIPTS.iter().chain(scripts).chain(&FIGURE_SCRIPTS);
        let document = html! {
            (DOCTYPE)
            html lang="en" data-origin=(format!("{} (loosepin {})", self.identity, self.version)) {
                head {
                    meta charset="utf-8";
                    meta http-equiv="Content-Security-Policy" content=(CONTENT_POLICY);
                    meta name="viewport" content="width=device-width, initial-scale=1";
                    meta name="color-scheme" content="light dark";
                    meta name="generator" content=(format!("loosepin {}", self.version));
                    title { (self.title) }
                    style { (PreEscaped(COLOURS)) (PreEscaped(STYLE)) (PreEscaped(FIGURE_STYLE)) (PreEscaped(style)) }
                    script { (PreEscaped(FIRST_SCRIPT)) }
                }
                body {
                    (body)
                    script type="text/css" id="saved-style" { (PreEscaped(saved_style())) }
                    @for script in scripts { script { (PreEscaped(script)) } }
                }
            }
        };
        with_unique_names(&document.into_string())
    }
}

/// When the page is written, to the minute. `SOURCE_DATE_EPOCH`, in seconds since 1970, sets the clock, so that a page can be made again
/// byte for byte (<https://reproducible-builds.org/specs/source-date-epoch/>). `None` if neither gives a date.
fn written_at() -> Option<String> {
    let now = match std::env::var("SOURCE_DATE_EPOCH") {
        Ok(seconds) => UNIX_EPOCH.checked_add(Duration::from_secs(seconds.parse().ok()?))?,
        Err(_) => SystemTime::now(),
    };
    date_for_reading(now)
}

/// The foot of every printed sheet: the computation on the left, the number of the sheet on the right.
fn foot_of_sheets(title: &str, identity: &str) -> String {
    let words = in_style(&format!("{title} · {identity}"));
    format!(
        "@media print {{ @page {{ @bottom-left {{ content: \"{words}\"; }} \
         @bottom-right {{ content: \"sheet \" counter(page) \" of \" counter(pages); }} }} }}\n"
    )
}

/// A text inside the quotes of a style sheet: what is neither letter nor digit is written as its number.
fn in_style(text: &str) -> String {
    text.chars()
        .map(|c| if c.is_alphanumeric() || c == ' ' { c.to_string() } else { format!("\\{:x} ", u32::from(c)) })
        .collect()
}

/// What a command has changed in the model: ` · joint.gudgeon.radial_clearance = 0.5 mm`.
pub(crate) fn changes(overrides: &[Override]) -> Markup {
    html! {
        @for change in overrides { " · " code { (change.path) " = " (change.written.replace(' ', "\u{a0}")) } }
    }
}

/// Sentences, the first one as the headline.
pub(crate) fn sentences(sentences: &[String]) -> Markup {
    html! {
        @for (index, sentence) in sentences.iter().enumerate() {
            @if index == 0 { p.headline { (sentence) } } @else { p { (sentence) } }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_title_ends_the_style_of_its_page() {
        let foot = foot_of_sheets("</style>\"; } \\ 5 µm\n", "study 1f3a");
        assert!(
            foot.contains("content: \"\\3c \\2f style\\3e \\22 \\3b  \\7d  \\5c  5 µm\\a  \\b7  study 1f3a\""),
            "{foot}"
        );
    }
}

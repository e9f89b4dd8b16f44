//! Figures: pictures with a name, in the page and as files of their own.
//!
//! A page is the one place where its figures are made. [`figures`] takes them from it, so that what is saved is what is seen.

use maud::{Markup, PreEscaped, html};

use crate::medium::script_data::round_to_digits;
use crate::medium::styles::saved_style;

/// Width of a figure that is saved, unless another one is asked for.
const WIDTH_MM: f64 = 160.0;
/// Digits of numbers in tables beside pictures that are no charts.
const CSV_DIGITS: usize = 9;

/// A picture with the name by which it is saved.
pub(crate) struct Picture {
    /// Stable, unique in its page, and the id of its element: `deviation.slider`.
    pub name: String,
    /// Class of the style: `chart`, `zone`, ...
    pub class: &'static str,
    /// Left, top, width and height in units of the picture.
    pub view: [f64; 4],
    /// Room below the view for what only the saved picture shows: the key of a chart, which the page has as buttons.
    pub below: f64,
    /// Description for those who cannot see it; the title of the saved picture.
    pub alternative: String,
    pub drawn: Markup,
}

impl Picture {
    /// The picture alone.
    pub fn svg(&self) -> Markup {
        html! {
            svg class={ "figure " (self.class) } viewBox=(self.view_box()) data-below=(self.below) role="img"
                aria-label=(self.alternative) { (self.drawn) }
        }
    }

    /// The picture as an SVG document that takes its style from the page into which it is put; `data` are attributes `data-NAME` of it.
    pub fn document(&self, data: &[(&str, String)]) -> String {
        let data: String = data.iter().map(|(name, text)| format!(" data-{name}=\"{text}\"")).collect();
        let label = html! { (self.alternative) }.into_string();
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"figure {}\" viewBox=\"{}\"{data} role=\"img\" \
             aria-label=\"{label}\">{}</svg>",
            self.class,
            self.view_box(),
            self.drawn.0
        )
    }

    fn view_box(&self) -> String {
        let trimmed = |number: f64| format!("{number:.6}").trim_end_matches('0').trim_end_matches('.').to_owned();
        self.view.map(trimmed).join(" ")
    }

    /// The picture with its caption and the numbers behind it as a table of comma-separated values, where it has any.
    pub fn figure(&self, caption: Markup, csv: Option<&str>) -> Markup {
        html! {
            figure class=(self.class) id=(self.name) data-figure=(self.name) {
                (self.svg())
                figcaption { (caption) }
                (csv_element(csv))
            }
        }
    }
}

/// The name of a figure of `kind` about `subject`: letters, digits, `_`, points and hyphens. Names of outputs and joints stay as they are,
/// signs stay too; anything else between words is one hyphen.
pub(crate) fn name_of(kind: &str, subject: &str) -> String {
    let mut name = format!("{kind}.");
    let mut is_between = false;
    for character in subject.chars() {
        // A plus sign is no part of a name, and must not become a minus sign.
        let kept = match character {
            '−' => "-".to_owned(),
            '+' => "plus".to_owned(),
            own if own.is_alphanumeric() || own == '_' || own == '-' => own.to_string(),
            _ => {
                is_between = true;
                continue;
            }
        };
        if is_between && !name.ends_with('.') {
            name.push('-');
        }
        is_between = false;
        name.push_str(&kept);
    }
    name
}

/// A page in which no two figures have one name: a second one gets a number. Subjects with different marks between their words, such
/// as the outputs `tip-along` and the part `along` of `tip`, have one name before.
pub(crate) fn with_unique_names(page: &str) -> String {
    const START: &str = "<figure ";
    let mut parts = page.split(START);
    let mut unique = parts.next().unwrap_or_default().to_owned();
    let mut names: Vec<String> = Vec::new();
    for part in parts {
        unique.push_str(START);
        let (figure, rest) = part.split_at(part.find("</figure>").unwrap_or(part.len()));
        match attribute(figure, "", "data-figure") {
            Some(name) if names.contains(&name) => {
                let free = (2..).map(|number| format!("{name}.{number}")).find(|free| !names.contains(free));
                let free = free.unwrap_or_default();
                // Its element, its script and the frame that cuts its curves are called by it.
                let renamed = figure.replace(&format!("\"{name}\""), &format!("\"{free}\""));
                let clips = [format!("\"clip-{name}\""), format!("#clip-{name})")];
                let [element, reference] = [format!("\"clip-{free}\""), format!("#clip-{free})")];
                unique.push_str(&renamed.replace(&clips[0], &element).replace(&clips[1], &reference));
                names.push(free);
            }
            name => {
                unique.push_str(figure);
                names.extend(name);
            }
        }
        unique.push_str(rest);
    }
    unique
}

/// A cell of a table of comma-separated values.
pub(crate) fn csv_text(text: &str) -> String {
    if text.contains([',', '"']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}

/// A number in a table of comma-separated values; empty if it is not finite.
pub(crate) fn csv_number(value: f64) -> String {
    round_to_digits(value, CSV_DIGITS).map_or(String::new(), |number| number.to_string())
}

/// Numbers behind a figure, for the script and for who saves them.
pub(crate) fn csv_element(csv: Option<&str>) -> Markup {
    html! {
        // Nothing in a table may end the element.
        @if let Some(csv) = csv { script type="text/csv" { (PreEscaped(csv.replace('<', "‹"))) } }
    }
}

/// A figure of a page as it is saved; its texts are those of the page, with the entities of HTML.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Figure {
    /// Its name: `deviation.slider`.
    pub name: String,
    title: String,
    view: String,
    below: String,
    class: String,
    drawn: String,
    csv: Option<String>,
    /// What was computed, by whom: the first line of its numbers.
    origin: String,
}

/// The figures of a page in their order. What is not a page of ours has none.
pub fn figures(page: &str) -> Vec<Figure> {
    let origin = attribute(page, "<html ", "data-origin").unwrap_or_default();
    let mut figures = Vec::new();
    for part in page.split("<figure ").skip(1) {
        let part = part.split("</figure>").next().unwrap_or(part);
        let parsed = || {
            let name = attribute(part, "", "data-figure")?;
            let (_, svg) = part.split_once("<svg class=\"figure ")?;
            let (head, rest) = svg.split_once('>')?;
            let (drawn, _) = rest.split_once("</svg>")?;
            let (class, _) = head.split_once('"')?;
            let csv = part.split_once("<script type=\"text/csv\">").and_then(|(_, csv)| csv.split_once("</script>"));
            Some(Figure {
                name,
                title: attribute(head, "", "aria-label")?,
                view: attribute(head, "", "viewBox")?,
                below: attribute(head, "", "data-below")?,
                class: class.to_owned(),
                drawn: drawn.to_owned(),
                csv: csv.map(|(csv, _)| csv.to_owned()),
                origin: origin.clone(),
            })
        };
        figures.extend(parsed());
    }
    figures
}

/// The figures of a part of a page as image elements.
pub(crate) fn images(part: Markup) -> Markup {
    html! { @for figure in figures(&part.into_string()) { (figure.image()) } }
}

/// The text of an attribute after `after`, as it is written in the page.
fn attribute(text: &str, after: &str, name: &str) -> Option<String> {
    let (_, rest) = text.split_once(after)?;
    let (_, rest) = rest.split_once(&format!("{name}=\""))?;
    rest.split_once('"').map(|(value, _)| value.to_owned())
}

impl Figure {
    /// Title of the figure.
    pub fn title(&self) -> String {
        let entities = [("&nbsp;", "\u{a0}"), ("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&amp;", "&")];
        entities.into_iter().fold(self.title.clone(), |text, (entity, character)| text.replace(entity, character))
    }

    /// The figure as an SVG document, in the light colours of the page, `width_mm` wide or 160 mm.
    pub fn to_svg(&self, width_mm: Option<f64>) -> String {
        let sides: Vec<f64> = self.view.split(' ').filter_map(|number| number.parse().ok()).collect();
        let below: f64 = self.below.parse().unwrap_or(0.0);
        let [left, top, across, down] = <[f64; 4]>::try_from(sides).unwrap_or([0.0, 0.0, 1.0, 1.0]);
        let down = down + below;
        let ratio = if across > 0.0 { down / across } else { 1.0 };
        let view = format!("{left} {top} {across} {down}");
        let width = width_mm.unwrap_or(WIDTH_MM);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"figure {}\" width=\"{width:.1}mm\" height=\"{:.1}mm\" viewBox=\"{}\" \
             role=\"img\"><title>{}</title><style>{}</style>{}</svg>\n",
            self.class,
            width * ratio,
            view,
            self.title,
            saved_style(),
            self.drawn
        )
    }

    /// The figure as an image element, which keeps its style to itself.
    fn image(&self) -> Markup {
        let is_plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-_.~ =:/;,()".contains(&byte);
        let encode = |byte: u8| if is_plain(byte) { char::from(byte).to_string() } else { format!("%{byte:02X}") };
        let source: String = self.to_svg(None).bytes().map(encode).collect();
        // Its letters are dark: the ground of who shows it may be, too.
        html! {
            img src=(format!("data:image/svg+xml;charset=utf-8,{source}")) alt=(self.title()) style="max-width: 100%; background: #ffffff";
        }
    }

    /// The numbers behind the figure as comma-separated values, after a line on where they are from; `None` for a picture that
    /// stands for no numbers.
    pub fn to_csv(&self) -> Option<String> {
        let csv = self.csv.as_ref()?;
        Some(format!("# figure {} of {}\n{csv}", self.name, self.origin))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture() -> Picture {
        Picture {
            name: "deviation.slider".to_owned(),
            class: "zone",
            view: [0.0, 0.0, 200.0, 40.0],
            below: 10.0,
            alternative: "A line & more".to_owned(),
            drawn: html! { path.ideal d="M0 0L1 1" {} },
        }
    }

    #[test]
    fn names_keep_signs_and_the_names_of_outputs() {
        let names = ["slider", "a-", "a--b", "a-b", "-x", "x", "+x", "tracer normal total"];
        let due = ["slider", "a-", "a--b", "a-b", "-x", "x", "plusx", "tracer-normal-total"];
        for (subject, due) in names.into_iter().zip(due) {
            assert_eq!(name_of("output", subject), format!("output.{due}"));
        }
        let label = |value: &str| name_of("orbit", &format!("gudgeon, joint.gudgeon.offset = {value}"));
        assert_eq!(label("0.1 mm"), "orbit.gudgeon-joint-gudgeon-offset-0-1-mm");
        assert_eq!(label("-0.1 mm"), "orbit.gudgeon-joint-gudgeon-offset--0-1-mm");
        assert_eq!(name_of("output", "a <b>"), "output.a-b");
    }

    #[test]
    fn a_second_figure_of_a_name_has_a_number() {
        let mut one = picture();
        one.drawn = html! { clipPath id="clip-deviation.slider" {} g clip-path="url(#clip-deviation.slider)" {} };
        let text = one.figure(html! { "\"slider\"" }, None).into_string();
        let page = with_unique_names(&format!("<p>first</p>{text}<p>between</p>{text}{text}<p>last</p>"));
        let names: Vec<String> = figures(&page).into_iter().map(|figure| figure.name).collect();
        assert_eq!(names, ["deviation.slider", "deviation.slider.2", "deviation.slider.3"]);
        let second = text.replace("deviation.slider", "deviation.slider.2");
        let third = text.replace("deviation.slider", "deviation.slider.3");
        assert_eq!(page, format!("<p>first</p>{text}<p>between</p>{second}{third}<p>last</p>"));
    }

    #[test]
    fn identity_a_figure_is_taken_from_its_page() {
        let figure = picture().figure(html! { "Caption" }, Some("angle [deg],deviation [mm]\n0,1\n"));
        let page = format!(
            "<html data-origin=\"study 1f3a (loosepin 1.0)\">{}{}</html>",
            figure.into_string(),
            "<figure id=\"a\">"
        );
        let found = figures(&page);
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].name, "deviation.slider");
        let svg = found[0].to_svg(Some(100.0));
        assert!(
            svg.contains("width=\"100.0mm\" height=\"25.0mm\"") && svg.contains("<title>A line &amp; more</title>"),
            "{svg}"
        );
        assert!(svg.contains("<path class=\"ideal\" d=\"M0 0L1 1\"></path></svg>"), "{svg}");
        assert!(!svg.contains("var(--"), "{svg}");
        let csv = found[0].to_csv().unwrap();
        assert_eq!(csv, "# figure deviation.slider of study 1f3a (loosepin 1.0)\nangle [deg],deviation [mm]\n0,1\n");
    }
}

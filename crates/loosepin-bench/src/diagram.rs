//! Small diagrams side by side as SVG: both axes logarithmic, the same in all of them, each line labelled at its end.

use std::fmt::Write;

/// A line of a panel.
#[derive(Debug, Clone)]
pub struct Line {
    /// Its label.
    pub label: String,
    /// Points (x, y), both positive and finite.
    pub points: Vec<(f64, f64)>,
    /// Index of the point with a ring.
    pub highlighted: Option<usize>,
}

/// One small diagram.
#[derive(Debug, Clone)]
pub struct Panel {
    /// Its heading.
    pub title: String,
    /// A second line below the heading.
    pub subtitle: String,
    /// Its lines; those at the same place in different panels look the same.
    pub lines: Vec<Line>,
}

/// All panels and what they share.
#[derive(Debug, Clone)]
pub struct Diagram {
    /// Description of the picture for readers who do not see it.
    pub description: String,
    /// Title of the x axes.
    pub x_title: String,
    /// Title of the y axes.
    pub y_title: String,
    /// A value of x with a line of its own.
    pub marked_x: f64,
    /// Note below the panels.
    pub note: String,
    /// The panels, row by row.
    pub panels: Vec<Panel>,
}

/// Panels in a row.
const COLUMNS: usize = 2;
/// Size of a panel's plot, px.
const PLOT: (f64, f64) = (400.0, 220.0);
/// Room around a plot for headings and axes: left, top, right, bottom, px.
const MARGIN: (f64, f64, f64, f64) = (88.0, 50.0, 12.0, 44.0);
/// Room below all panels for the note, px.
const NOTE: f64 = 26.0;
/// Distance between two labels, px.
const LABEL_DISTANCE: f64 = 15.0;
/// Colours that differ for all kinds of colour vision, dark enough for text on white.
const COLOURS: [&str; 4] = ["#0060a0", "#b84a00", "#00735a", "#5b3a8c"];

/// A logarithmic axis: whole decades for x, steps of 1, 2, 5 for y.
struct Axis {
    low: f64,
    high: f64,
    length: f64,
}

impl Axis {
    fn at(&self, value: f64) -> f64 {
        (value / self.low).ln() / (self.high / self.low).ln() * self.length
    }
}

fn power(exponent: i32) -> f64 {
    10_f64.powi(exponent)
}

/// `value` with the digits of a power of ten raised.
fn decade(exponent: i32) -> String {
    format!("10<tspan dy=\"-5\" font-size=\"9\">{}</tspan>", exponent.to_string().replace('-', "\u{2212}"))
}

/// `&`, `<` and `>` as XML wants them.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

impl Diagram {
    /// The picture, the same bytes for the same numbers.
    pub fn to_svg(&self) -> String {
        let (x, y) = self.axes();
        let (left, top, right, bottom) = MARGIN;
        let (cell_width, cell_height) = (left + PLOT.0 + right, top + PLOT.1 + bottom);
        let rows = self.panels.len().div_ceil(COLUMNS);
        let (width, height) = (cell_width * COLUMNS as f64, cell_height * rows as f64 + NOTE);
        let mut svg = String::new();
        let mut put = |line: String| {
            svg.push_str(&line);
            svg.push('\n');
        };
        put(format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}\" height=\"{height:.0}\" viewBox=\"0 0 {width:.0} \
             {height:.0}\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"12\" fill=\"#222\" role=\"img\">"
        ));
        put(format!("<title>{}</title>", escaped(&self.description)));
        put("<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>".to_owned());
        for (index, panel) in self.panels.iter().enumerate() {
            let column = (index % COLUMNS) as f64 * cell_width + left;
            let row = (index / COLUMNS) as f64 * cell_height + top;
            put(format!("<g transform=\"translate({column:.0} {row:.0})\">"));
            put(self.panel(panel, &x, &y));
            put("</g>".to_owned());
        }
        put(format!("<text x=\"{left:.0}\" y=\"{:.0}\">{}</text>", height - 10.0, escaped(&self.note)));
        put("</svg>".to_owned());
        svg
    }

    /// The axes that hold all points, with three decades on the left for the labels.
    fn axes(&self) -> (Axis, Axis) {
        let points = || self.panels.iter().flat_map(|panel| &panel.lines).flat_map(|line| &line.points);
        let over = |value: fn(&(f64, f64)) -> f64| {
            points().map(value).fold((f64::INFINITY, 0.0_f64), |(low, high), v| (low.min(v), high.max(v)))
        };
        let ((x_low, x_high), (y_low, y_high)) = (over(|point| point.0), over(|point| point.1));
        let x = Axis {
            low: power(x_low.log10().floor() as i32 - 3),
            high: power(x_high.log10().ceil() as i32),
            length: PLOT.0,
        };
        let y = Axis { low: nice_below(y_low), high: nice_above(y_high), length: PLOT.1 };
        (x, y)
    }

    fn panel(&self, panel: &Panel, x: &Axis, y: &Axis) -> String {
        let (width, height) = PLOT;
        let mut svg = String::new();
        let mut put = |line: String| {
            svg.push_str(&line);
            svg.push('\n');
        };
        put(format!(
            "<text y=\"-26\" font-size=\"14\" font-weight=\"bold\">{}</text><text y=\"-9\" fill=\"#555\">{}</text>",
            escaped(&panel.title),
            escaped(&panel.subtitle)
        ));
        for exponent in decades(x) {
            let at = x.at(power(exponent));
            put(format!("<path d=\"M{at:.1} 0V{height:.0}\" stroke=\"#e4e4e4\"/>"));
            if exponent % 2 == 0 {
                let (under, label) = (height + 18.0, decade(exponent));
                put(format!("<text x=\"{at:.1}\" y=\"{under:.0}\" text-anchor=\"middle\">{label}</text>"));
            }
        }
        for exponent in decades(&Axis { low: y.low / 10.0, ..*y }) {
            for step in [1.0, 2.0, 5.0] {
                let value = step * power(exponent);
                if value < 0.999 * y.low || value > 1.001 * y.high {
                    continue;
                }
                let at = height - y.at(value);
                put(format!("<path d=\"M0 {at:.1}H{width:.0}\" stroke=\"#e4e4e4\"/>"));
                put(format!(
                    "<text x=\"-7\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
                    at + 4.0,
                    with_thousands_separators(value)
                ));
            }
        }
        let marked = x.at(self.marked_x);
        put(format!("<path d=\"M{marked:.1} 0V{height:.0}\" stroke=\"#777\" stroke-dasharray=\"4 3\"/>"));
        put(format!("<path d=\"M0 0V{height:.0}H{width:.0}\" fill=\"none\" stroke=\"#222\"/>"));
        put(format!(
            "<text x=\"{:.0}\" y=\"{:.0}\" text-anchor=\"middle\">{}</text>",
            width / 2.0,
            height + 36.0,
            escaped(&self.x_title)
        ));
        put(format!(
            "<text transform=\"translate(-70 {:.0}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
            height / 2.0,
            escaped(&self.y_title)
        ));
        for (index, line) in panel.lines.iter().enumerate() {
            put(drawn(line, index, x, y));
        }
        put(labels(panel, x, y));
        svg.pop();
        svg
    }
}

fn decades(axis: &Axis) -> impl Iterator<Item = i32> {
    let (low, high) = (axis.low.log10().round() as i32, axis.high.log10().round() as i32);
    low..=high
}

/// The largest of 1, 2, 5 times a power of ten that is not above `value`.
fn nice_below(value: f64) -> f64 {
    let decade = power(value.log10().floor() as i32);
    decade * [5.0, 2.0].into_iter().find(|step| step * decade <= value).unwrap_or(1.0)
}

/// The smallest of 1, 2, 5 times a power of ten that is not below `value`.
fn nice_above(value: f64) -> f64 {
    let decade = power(value.log10().floor() as i32);
    decade * [1.0, 2.0, 5.0].into_iter().find(|step| step * decade >= value).unwrap_or(10.0)
}

/// A whole number with its thousands apart.
pub fn with_thousands_separators(value: f64) -> String {
    let digits = format!("{value:.0}");
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push('\u{2009}');
        }
        text.push(digit);
    }
    text
}

/// A line with its markers: circles, squares, triangles, diamonds.
fn drawn(line: &Line, index: usize, x: &Axis, y: &Axis) -> String {
    let colour = COLOURS[index % COLOURS.len()];
    let places: Vec<(f64, f64)> = line.points.iter().map(|point| (x.at(point.0), PLOT.1 - y.at(point.1))).collect();
    let mut path = String::new();
    for (k, (px, py)) in places.iter().enumerate() {
        let _ = write!(path, "{}{px:.1} {py:.1}", if k == 0 { "M" } else { "L" });
    }
    let mut svg = format!("<path d=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.5\"/>");
    let mut markers = String::new();
    for (px, py) in &places {
        let _ = match index % 4 {
            0 => write!(markers, "M{:.1} {py:.1}a3 3 0 1 0 6 0a3 3 0 1 0 -6 0z", px - 3.0),
            1 => write!(markers, "M{:.1} {:.1}h5.2v5.2h-5.2z", px - 2.6, py - 2.6),
            2 => write!(markers, "M{px:.1} {:.1}l3.6 6.2h-7.2z", py - 3.8),
            _ => write!(markers, "M{px:.1} {:.1}l3.8 3.8l-3.8 3.8l-3.8 -3.8z", py - 3.8),
        };
    }
    let _ = write!(svg, "<path d=\"{markers}\" fill=\"{colour}\"/>");
    if let Some((px, py)) = line.highlighted.and_then(|index| places.get(index)) {
        let _ = write!(
            svg,
            "<circle cx=\"{px:.1}\" cy=\"{py:.1}\" r=\"6.5\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.5\"/>"
        );
    }
    svg
}

/// The labels left of the lines' upper ends, moved apart where they would meet.
fn labels(panel: &Panel, x: &Axis, y: &Axis) -> String {
    let mut places: Vec<(f64, f64, usize)> = Vec::new();
    for (index, line) in panel.lines.iter().enumerate() {
        let first = line.points.iter().min_by(|a, b| a.0.total_cmp(&b.0));
        places.extend(first.map(|point| (x.at(point.0) - 10.0, PLOT.1 - y.at(point.1) + 4.0, index)));
    }
    places.sort_by(|a, b| a.1.total_cmp(&b.1));
    for k in 1..places.len() {
        places[k].1 = places[k].1.max(places[k - 1].1 + LABEL_DISTANCE);
    }
    let of_label = |(px, py, index): &(f64, f64, usize)| {
        let (colour, label) = (COLOURS[index % COLOURS.len()], escaped(&panel.lines[*index].label));
        format!(
            "<text x=\"{px:.1}\" y=\"{py:.1}\" text-anchor=\"end\" fill=\"{colour}\" stroke=\"#fff\" stroke-width=\"3\" \
             paint-order=\"stroke\">{label}</text>"
        )
    };
    places.iter().map(of_label).collect()
}

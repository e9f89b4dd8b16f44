//! The picture of a chart: bands, grid, curves, marks and axes. `scripts/chart.ts` takes it over and moves what is in it.

use maud::{Markup, html};

use crate::charts::axes::{
    BELOW, HALF_DIGIT, MARGIN, NAME_ABOVE_EDGE, NUMBERS_BELOW, NUMBERS_BESIDE, UPRIGHT_NAME, with_unit,
};
use crate::charts::chart::{Chart, Dots, Entry, EntryValues, TURN_DEG};
use crate::charts::ticks::{tick_text, ticks};

/// Width of a picture; a unit is about a pixel. The script fits it to the width of the page.
const WIDTH: f64 = 760.0;
/// Room above the curves.
const ABOVE: f64 = 10.0;
/// Room for the name of the vertical axis, and for a character of its numbers.
const NAME: f64 = 26.0;
const CHARACTER: f64 = 7.2;
/// Least distances between ticks.
const MIN_ACROSS: f64 = 58.0;
const MIN_UP: f64 = 38.0;
/// Rows and columns of the key, and the room below it.
const KEY_ROW: f64 = 19.0;
const KEY_COLUMNS: usize = 2;
const KEY_MARGIN: f64 = 6.0;
/// Share of the range that is left free above and below.
const FREE_SHARE: f64 = 0.06;

/// Place of the curves in the picture, and the range of their frame, in display units.
pub(crate) struct Plot {
    left: f64,
    top: f64,
    width: f64,
    height: f64,
    x: [f64; 2],
    y: [f64; 2],
}

impl Plot {
    /// For the script: left, top, width, height, and the ends of both axes.
    pub fn to_attribute(&self) -> String {
        let Self { left, top, width, height, x: [x0, x1], y: [y0, y1] } = self;
        [left, top, width, height, x0, x1, y0, y1].map(|number| number.to_string()).join(" ")
    }

    /// Left, top, width and height, in units of the picture.
    pub fn frame(&self) -> String {
        [self.left, self.top, self.width, self.height].map(|number| number.to_string()).join(" ")
    }

    /// The values at both ends of the horizontal axis.
    pub fn ends(&self) -> String {
        self.x.map(|number| number.to_string()).join(" ")
    }

    /// The values at both ends of the vertical axis.
    pub fn y_ends(&self) -> String {
        self.y.map(|number| number.to_string()).join(" ")
    }

    fn x_position(&self, value: f64) -> f64 {
        self.left + (value - self.x[0]) / (self.x[1] - self.x[0]) * self.width
    }

    fn y_position(&self, value: f64) -> f64 {
        self.top + (self.y[1] - value) / (self.y[1] - self.y[0]) * self.height
    }
}

/// A chart as it is drawn.
pub(crate) struct Drawn {
    pub view: [f64; 4],
    /// Room of the key below the view.
    pub below: f64,
    pub plot: Plot,
    pub drawn: Markup,
}

/// The picture, and where its curves stand in it.
pub(crate) fn drawing(chart: &Chart) -> Drawn {
    let height = f64::from(chart.height);
    let y = chart.y_range.unwrap_or_else(|| y_range(chart));
    let plot_height = height - ABOVE - BELOW;
    let (y_ticks, y_step) = ticks(y[0], y[1], (y[1] - y[0]) * MIN_UP / plot_height, false);
    let y_texts: Vec<String> = y_ticks.iter().map(|tick| tick_text(*tick, y_step)).collect();
    let longest = y_texts.iter().map(|text| text.chars().count()).max().unwrap_or(1).max(3);
    let left = NAME + CHARACTER * longest as f64;
    let plot = Plot { left, top: ABOVE, width: WIDTH - left - MARGIN, height: plot_height, x: x_range(chart), y };
    let least = (plot.x[1] - plot.x[0]) * MIN_ACROSS / plot.width;
    let (x_ticks, x_step) = ticks(plot.x[0], plot.x[1], least, chart.is_in_degrees());
    let told = |angle: f64| if is_one_turn(chart, &plot) { angle.rem_euclid(TURN_DEG) } else { angle };
    let bottom = plot.top + plot.height;
    let clip = format!("clip-{}", chart.id);
    let at = |number: f64| format!("{number:.1}");
    let drawn = html! {
        clipPath id=(clip) {
            rect x=(at(plot.left)) y=(at(plot.top)) width=(at(plot.width)) height=(at(plot.height)) {}
        }
        g.curves clip-path=(format!("url(#{clip})")) {
            g {
                @for (index, entry) in chart.entries.iter().enumerate() {
                    @if let EntryValues::Band { lower, upper } = &entry.values {
                        path class={ "fill " (entry.role.class()) } data-of=(index) d=(area(chart, &plot, lower, upper)) {}
                    }
                }
            }
        }
        g.up {
            @for (tick, text) in y_ticks.iter().zip(&y_texts) {
                @let place = at(plot.y_position(*tick));
                line.grid x1=(at(plot.left)) x2=(at(plot.left + plot.width)) y1=(place) y2=(place) {}
                text x=(at(plot.left - NUMBERS_BESIDE)) y=(at(plot.y_position(*tick) + HALF_DIGIT)) text-anchor="end" { (text) }
            }
        }
        g.across {
            @for tick in &x_ticks {
                @let place = at(plot.x_position(*tick));
                line.grid x1=(place) x2=(place) y1=(at(plot.top)) y2=(at(bottom)) {}
                text x=(place) y=(at(bottom + NUMBERS_BELOW)) text-anchor="middle" { (tick_text(told(*tick), x_step)) }
            }
        }
        g.curves clip-path=(format!("url(#{clip})")) {
            g {
                @for (index, entry) in chart.entries.iter().enumerate() {
                    @for list in entry.values.lists() {
                        path class=(line_class(entry)) data-of=(index) d=(line(chart, &plot, list)) {}
                    }
                }
            }
        }
        @if !chart.dots.is_empty() {
            g.curves clip-path=(format!("url(#{clip})")) {
                g { @for dots in &chart.dots { path class={ "dots " (dots.role.class()) } data-of=(dots.entry) d=(points(dots, &plot)) {} } }
            }
        }
        g.marks {
            @for mark in &chart.marks {
                @if let Some(value) = mark.at {
                    @let place = at(plot.x_position(value));
                    line.mark data-at=(value) x1=(place) x2=(place) y1=(at(plot.top)) y2=(at(bottom)) {}
                    text.mark data-at=(value) x=(at(plot.x_position(value) + 5.0)) y=(at(plot.top + 13.0)) { (mark.label) }
                }
            }
        }
        text.name.of-x x=(at(plot.left + 0.5 * plot.width)) y=(at(height - NAME_ABOVE_EDGE)) text-anchor="middle" {
            (with_unit(&chart.x_label, &chart.x_symbol))
        }
        text.name.of-y transform=(format!("translate({UPRIGHT_NAME} {}) rotate(-90)", at(plot.top + 0.5 * plot.height))) text-anchor="middle" {
            (with_unit(&chart.y_label, &chart.y_symbol))
        }
        (key(chart, &plot, height))
    };
    let below = KEY_ROW * chart.entries.len().div_ceil(KEY_COLUMNS) as f64 + KEY_MARGIN;
    Drawn { view: [0.0, 0.0, WIDTH, height], below, plot, drawn }
}

/// What the curves are, below the view: seen in saved pictures alone.
fn key(chart: &Chart, plot: &Plot, top: f64) -> Markup {
    let column = plot.width / KEY_COLUMNS as f64;
    html! {
        g.key {
            @for (index, entry) in chart.entries.iter().enumerate() {
                @let x = plot.left + column * (index % KEY_COLUMNS) as f64;
                @let y = top + KEY_ROW * (0.5 + (index / KEY_COLUMNS) as f64);
                @if matches!(entry.values, EntryValues::Band { .. }) {
                    rect class={ "fill " (entry.role.class()) } x=(format!("{x:.1}")) y=(format!("{:.1}", y - 5.0)) width="24" height="10" {}
                }
                path class=(line_class(entry)) d=(format!("M{x:.1} {y:.1}h24")) {}
                text x=(format!("{:.1}", x + 31.0)) y=(format!("{:.1}", y + HALF_DIGIT)) { (entry.label) }
            }
        }
    }
}

fn line_class(entry: &Entry) -> String {
    let is_edge = matches!(entry.values, EntryValues::Band { .. });
    let dashed = if entry.dashed { " dashed" } else { "" };
    format!("line {}{}{dashed}", entry.role.class(), if is_edge { " edge" } else { "" })
}

/// The ends of the horizontal axis. One turn whose last pose is a step before its end is shown to its end.
fn x_range(chart: &Chart) -> [f64; 2] {
    let [from, to] = range(chart.x.iter().copied().flatten());
    if chart.is_open_turn() {
        return [from, from + TURN_DEG];
    }
    if to > from { [from, to] } else { [from - 0.5, from + 0.5] }
}

fn y_range(chart: &Chart) -> [f64; 2] {
    let lists = chart.entries.iter().flat_map(|entry| entry.values.lists());
    let dots = chart.dots.iter().flat_map(|dots| dots.points.iter().map(|point| point[1]));
    let finite = lists.flatten().copied().flatten().chain(dots).filter(|value| value.is_finite());
    let [from, to] = range(finite);
    let free = if to > from { FREE_SHARE * (to - from) } else { (0.1 * from.abs()).max(f64::MIN_POSITIVE) };
    if from == to && from == 0.0 { [-1.0, 1.0] } else { [from - free, to + free] }
}

/// Least and largest value; 0 and 1 where there is none.
fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let [from, to] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[from, to], v| [from.min(v), to.max(v)]);
    if from.is_finite() && to.is_finite() { [from, to] } else { [0.0, 1.0] }
}

/// Whether the chart is over one turn: also one that does not begin at 0° is shown in angles from 0° to 360°.
fn is_one_turn(chart: &Chart, plot: &Plot) -> bool {
    chart.is_in_degrees() && (plot.x[1] - plot.x[0] - TURN_DEG).abs() < 1e-3 && plot.x[0] != 0.0
}

/// A line through points; it breaks where there is none.
fn line(chart: &Chart, plot: &Plot, values: &[Option<f64>]) -> String {
    let mut path = String::new();
    let mut is_down = false;
    let height = |row: usize| values.get(row).copied().flatten();
    for (row, x) in chart.x.iter().enumerate() {
        let (Some(x), Some(y)) = (x, height(row)) else {
            is_down = false;
            continue;
        };
        // Points within a level stretch say nothing.
        let is_level = is_down && row > 0 && height(row - 1) == Some(y) && height(row + 1) == Some(y);
        if !is_level {
            path.push_str(&format!(
                "{}{:.1} {:.1}",
                if is_down { 'L' } else { 'M' },
                plot.x_position(*x),
                plot.y_position(y)
            ));
        }
        is_down = true;
    }
    path
}

/// A line of no length at each point, which round ends make a dot.
fn points(dots: &Dots, plot: &Plot) -> String {
    let finite = dots.points.iter().filter(|point| point.iter().all(|value| value.is_finite()));
    finite.map(|[x, y]| format!("M{:.1} {:.1}h0", plot.x_position(*x), plot.y_position(*y))).collect()
}

/// The area between two curves: one piece for each stretch in which both have values.
fn area(chart: &Chart, plot: &Plot, lower: &[Option<f64>], upper: &[Option<f64>]) -> String {
    let points: Vec<Option<[f64; 3]>> = chart
        .x
        .iter()
        .zip(lower.iter().zip(upper))
        .map(|(x, (lower, upper))| {
            Some([plot.x_position((*x)?), plot.y_position((*lower)?), plot.y_position((*upper)?)])
        })
        .collect();
    let mut path = String::new();
    for stretch in points.split(|point| point.is_none()).filter(|stretch| stretch.len() > 1) {
        let known = || stretch.iter().flatten();
        let there = known().map(|[x, _, upper]| format!("{x:.1} {upper:.1}"));
        let back = known().rev().map(|[x, lower, _]| format!("{x:.1} {lower:.1}"));
        path.push_str(&format!("M{}Z", there.chain(back).collect::<Vec<String>>().join("L")));
    }
    path
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::charts::chart::Role;
    use crate::numbers::number::NumberWriter;
    use loosepin_text::units::DisplayUnits;

    fn chart(x_deg: &[f64], values: &[f64]) -> Chart {
        let angles: Vec<f64> = x_deg.iter().map(|angle| angle.to_radians()).collect();
        let units = DisplayUnits::default();
        let mut chart = Chart::over_angle("a".to_owned(), "crank", &angles, &NumberWriter::for_page(&units));
        chart.entries.push(Entry::new("", Role::First, false, EntryValues::line(values)));
        chart
    }

    #[test]
    fn analytic_a_turn_is_shown_to_its_end() {
        let angles: Vec<f64> = (0..180).map(|k| 34.0 + 2.0 * f64::from(k)).collect();
        let Drawn { plot, drawn, .. } = drawing(&chart(&angles, &vec![1.0; 180]));
        assert!((plot.x[0] - 34.0).abs() < 1e-4 && (plot.x[1] - 394.0).abs() < 1e-4, "{:?}", plot.x);
        // 360° is told as 0°.
        let text = drawn.into_string();
        assert!(text.contains(">90</text>") && text.contains(">0</text>") && !text.contains(">360</text>"), "{text}");
    }

    #[test]
    fn analytic_values_that_come_back_are_drawn_to_the_end_of_the_turn() {
        let angles: Vec<f64> = (0..180).map(|pose| 2.0 * f64::from(pose)).collect();
        let cosine: Vec<f64> = angles.iter().map(|angle| angle.to_radians().cos()).collect();
        let mut periodic = Chart { is_periodic: true, ..chart(&angles, &cosine) };
        assert!(periodic.close_turn());
        assert_eq!((periodic.x.len(), periodic.x[180]), (181, Some(360.0)));
        let list = periodic.entries[0].values.lists()[0];
        assert_eq!((list.len(), list[180]), (181, list[0]));
        let Drawn { plot, .. } = drawing(&periodic);
        assert_eq!(plot.x, [0.0, 360.0]);
        let path = line(&periodic, &plot, list);
        assert!(path.ends_with(&format!("L{:.1} {:.1}", plot.left + plot.width, plot.y_position(1.0))), "{path}");
        // Not where nobody says so, where the values do not come back, for a part of a turn, nor with a gap at an end.
        assert!(!chart(&angles, &cosine).close_turn());
        assert!(!Chart { is_periodic: true, ..chart(&angles, &angles) }.close_turn());
        assert!(!Chart { is_periodic: true, ..chart(&angles[..170], &cosine[..170]) }.close_turn());
        let whole: Vec<f64> = (0..=180).map(|pose| 2.0 * f64::from(pose)).collect();
        assert!(!Chart { is_periodic: true, ..chart(&whole, &whole) }.close_turn());
        let gapped: Vec<f64> = std::iter::once(f64::NAN).chain(cosine[1..].iter().copied()).collect();
        assert!(!Chart { is_periodic: true, ..chart(&angles, &gapped) }.close_turn());
    }

    #[test]
    fn analytic_points_stand_where_their_values_are_and_gaps_break_the_line() {
        let chart = chart(&[0.0, 90.0, 180.0, 250.0], &[0.0, 2.0, f64::NAN, 1.0]);
        let Drawn { view, plot, .. } = drawing(&chart);
        let path = line(&chart, &plot, chart.entries[0].values.lists()[0]);
        let right = view[2] - MARGIN;
        // 6 % of 2 are free on either side.
        let bottom = ABOVE + (2.12 - 0.0) / 2.24 * plot.height;
        assert!(path.starts_with(&format!("M{:.1} {bottom:.1}L", plot.left)), "{path}");
        assert!(path.ends_with(&format!("M{right:.1} {:.1}", ABOVE + 1.12 / 2.24 * plot.height)), "{path}");
        assert_eq!(path.matches('M').count(), 2);
    }
}

//! Charts over one axis: the picture, the legend, the text alternative and the numbers behind it.

use maud::{Markup, html};

use super::chart_drawing::{Drawn, drawing};
use super::figure::{Picture, csv_element};
use super::number::{NumberWriter, PLAIN_DIGITS};
use super::script_data::rounded;
use loosepin_text::units::SiUnit;

/// Rows that the numbers behind a chart hold at most; longer histories keep the extremes of each stretch.
const MOST_ROWS: usize = 20_000;
/// Points that a picture has at most per curve.
const MOST_POINTS: usize = 1600;
/// Rows of the table behind a chart.
const TABLE_ROWS: usize = 24;

/// Kind of the horizontal axis; decides on the ticks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum HorizontalAxis {
    /// Angle of a drive: ticks at 30°, 45°, 90°.
    Angle,
    /// Anything else.
    Plain,
}

/// The colour of an entry, by its meaning; the style sheet has the colours for light and dark.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    Random,
    Mixed,
    Nominal,
    Mean,
    Worst,
    Probability,
    Limit,
    First,
    Second,
    Third,
    Fourth,
    Fifth,
}

impl Role {
    pub fn class(self) -> &'static str {
        match self {
            Role::Random => "random",
            Role::Mixed => "mixed",
            Role::Nominal => "nominal",
            Role::Mean => "mean",
            Role::Worst => "worst",
            Role::Probability => "probability",
            Role::Limit => "limit",
            Role::First => "first",
            Role::Second => "second",
            Role::Third => "third",
            Role::Fourth => "fourth",
            Role::Fifth => "fifth",
        }
    }

    /// The colour of the n-th of several equal curves.
    pub fn of_index(index: usize) -> Role {
        [Role::First, Role::Second, Role::Third, Role::Fourth, Role::Fifth][index % 5]
    }
}

/// Values of one entry, in the units of the chart.
#[derive(Debug, Clone)]
pub(super) enum EntryValues {
    /// A filled band between two curves.
    Band { lower: Vec<Option<f64>>, upper: Vec<Option<f64>> },
    /// Two curves without a filling.
    Pair { lower: Vec<Option<f64>>, upper: Vec<Option<f64>> },
    /// One curve.
    Line { values: Vec<Option<f64>> },
}

impl EntryValues {
    pub fn band(lower: &[f64], upper: &[f64]) -> Self {
        EntryValues::Band { lower: rounded(lower), upper: rounded(upper) }
    }

    pub fn pair(lower: &[f64], upper: &[f64]) -> Self {
        EntryValues::Pair { lower: rounded(lower), upper: rounded(upper) }
    }

    pub fn line(values: &[f64]) -> Self {
        EntryValues::Line { values: rounded(values) }
    }

    pub fn lists(&self) -> Vec<&Vec<Option<f64>>> {
        match self {
            EntryValues::Band { lower, upper } | EntryValues::Pair { lower, upper } => vec![lower, upper],
            EntryValues::Line { values } => vec![values],
        }
    }

    fn lists_mut(&mut self) -> Vec<&mut Vec<Option<f64>>> {
        match self {
            EntryValues::Band { lower, upper } | EntryValues::Pair { lower, upper } => vec![lower, upper],
            EntryValues::Line { values } => vec![values],
        }
    }
}

/// One line of the legend and what it stands for.
#[derive(Debug, Clone)]
pub(super) struct Entry {
    pub label: String,
    pub role: Role,
    pub dashed: bool,
    pub values: EntryValues,
}

impl Entry {
    pub fn new(label: impl Into<String>, role: Role, dashed: bool, values: EntryValues) -> Entry {
        Entry { label: label.into(), role, dashed, values }
    }

    /// A curve of SI values.
    pub fn line(
        label: &str,
        role: Role,
        dashed: bool,
        values_si: &[f64],
        unit: &SiUnit,
        writer: &NumberWriter,
    ) -> Entry {
        Entry::new(label, role, dashed, EntryValues::line(&scaled(values_si, unit, writer)))
    }
}

/// Single points in the units of the chart, such as peaks between samples.
#[derive(Debug, Clone)]
pub(super) struct Dots {
    pub role: Role,
    pub points: Vec<[f64; 2]>,
}

/// An upright line with a name.
#[derive(Debug, Clone)]
pub(super) struct Mark {
    pub at: Option<f64>,
    pub label: String,
}

/// One chart.
#[derive(Debug, Clone)]
pub(super) struct Chart {
    /// Name of the figure, unique in the page.
    pub id: String,
    pub horizontal: HorizontalAxis,
    pub x_label: String,
    pub x_symbol: String,
    pub x: Vec<Option<f64>>,
    pub y_label: String,
    pub y_symbol: String,
    /// Fixed ends of the vertical axis, where it has any.
    pub y_range: Option<[f64; 2]>,
    pub entries: Vec<Entry>,
    /// Single points beside the curves.
    pub dots: Vec<Dots>,
    /// Upright lines.
    pub marks: Vec<Mark>,
    pub height: u32,
    /// One sentence on what is to be seen, for the caption.
    pub caption: Markup,
    /// Text alternative for readers who cannot see the chart.
    pub alternative: String,
}

/// SI values as the chart shows them.
pub(super) fn scaled(values_si: &[f64], unit: &SiUnit, writer: &NumberWriter) -> Vec<f64> {
    let display = writer.units.of(unit);
    values_si.iter().map(|value_si| display.from_si(*value_si)).collect()
}

impl Chart {
    /// Over values in SI, without entries and words.
    pub fn over(id: String, x_label: &str, x_si: &[f64], x_unit: &SiUnit, writer: &NumberWriter) -> Chart {
        Chart {
            id,
            horizontal: HorizontalAxis::Plain,
            x_label: x_label.to_owned(),
            x_symbol: writer.symbol(x_unit),
            x: rounded(&scaled(x_si, x_unit, writer)),
            y_label: String::new(),
            y_symbol: String::new(),
            y_range: None,
            entries: Vec::new(),
            dots: Vec::new(),
            marks: Vec::new(),
            height: 300,
            caption: html! {},
            alternative: String::new(),
        }
    }

    /// Over angles of a drive.
    pub fn over_angle(id: String, drive: &str, angles_rad: &[f64], writer: &NumberWriter) -> Chart {
        let label = format!("angle of {drive}");
        let chart = Chart::over(id, &label, angles_rad, &SiUnit::ANGLE, writer);
        Chart { horizontal: HorizontalAxis::Angle, ..chart }
    }

    /// The figure: picture, legend with read-out, caption, numbers.
    pub fn figure(mut self) -> Markup {
        self.thin_out(MOST_ROWS);
        let mut drawn = self.clone();
        drawn.thin_out(MOST_POINTS);
        let Drawn { view, below, plot, drawn } = drawing(&drawn);
        let name = self.id.clone();
        let picture = Picture { name, class: "chart", view, below, alternative: self.alternative.clone(), drawn };
        let is_angle = self.horizontal == HorizontalAxis::Angle && self.x_symbol == "°";
        html! {
            figure.chart id=(self.id) data-figure=(self.id) {
                div.plot data-chart=(self.id) data-plot=(plot.to_attribute()) data-x-name=(self.x_label) data-x-unit=(self.x_symbol)
                    data-y-unit=(self.y_symbol) data-angle[is_angle] data-fixed[self.y_range.is_some()] role="group" aria-label=(self.alternative) {
                    (picture.svg())
                }
                div.readout {
                    span.position data-position="" { (self.x_label) }
                    button.reset type="button" hidden { "Show all" }
                }
                ul.legend {
                    @for (index, entry) in self.entries.iter().enumerate() {
                        li {
                            // The script enables what it serves.
                            button type="button" disabled aria-pressed="true" data-entry=(index) data-columns=(entry.values.lists().len()) {
                                span class={ "swatch " (entry.role.class()) " " (swatch_shape(entry)) } aria-hidden="true" {}
                                span.label { (entry.label) }
                                span.value data-value=(index) {}
                            }
                        }
                    }
                }
                figcaption { (self.caption) }
                (self.numbers())
                (csv_element(Some(&self.csv())))
            }
        }
    }

    /// The numbers behind the chart: a column for each curve, units in the header, gaps empty.
    fn csv(&self) -> String {
        let with_unit = |words: &str, symbol: &str| {
            let name = if symbol.is_empty() { words.to_owned() } else { format!("{words} [{symbol}]") };
            if name.contains([',', '"']) { format!("\"{}\"", name.replace('"', "\"\"")) } else { name }
        };
        let mut heads = vec![with_unit(&self.x_label, &self.x_symbol)];
        for entry in &self.entries {
            let parts: &[&str] = if entry.values.lists().len() == 2 { &[", lower", ", upper"] } else { &[""] };
            heads.extend(parts.iter().map(|part| with_unit(&format!("{}{part}", entry.label), &self.y_symbol)));
        }
        let mut text = heads.join(",");
        text.push('\n');
        for row in 0..self.x.len() {
            let cells = self.entries.iter().flat_map(|entry| entry.values.lists());
            let cells = cells.map(|list| list.get(row).copied().flatten());
            let cells: Vec<String> = std::iter::once(self.x[row])
                .chain(cells)
                .map(|cell| cell.map_or(String::new(), |number| number.to_string()))
                .collect();
            text.push_str(&cells.join(","));
            text.push('\n');
        }
        text
    }

    fn numbers(&self) -> Markup {
        let step = self.x.len().div_ceil(TABLE_ROWS).max(1);
        let symbol = |symbol: &str| if symbol.is_empty() { String::new() } else { format!(" ({symbol})") };
        html! {
            details.numbers {
                summary { "Numbers behind this chart" }
                div.scroll tabindex="0" role="region" aria-label="Table of the chart's numbers" {
                    table {
                        thead {
                            tr {
                                th scope="col" { (self.x_label) (symbol(&self.x_symbol)) }
                                @for entry in &self.entries {
                                    @if entry.values.lists().len() == 2 {
                                        th scope="col" { (entry.label) ", lower" (symbol(&self.y_symbol)) }
                                        th scope="col" { (entry.label) ", upper" (symbol(&self.y_symbol)) }
                                    } @else {
                                        th scope="col" { (entry.label) (symbol(&self.y_symbol)) }
                                    }
                                }
                            }
                        }
                        tbody {
                            @for row in (0..self.x.len()).step_by(step) {
                                tr {
                                    th scope="row" { (cell(self.x[row])) }
                                    @for entry in &self.entries {
                                        @for list in entry.values.lists() {
                                            td { (cell(list.get(row).copied().flatten())) }
                                        }
                                    }
                                }
                            }
                        }
                    }
                }
            }
        }
    }

    /// Keeps, of every stretch of points, those where some entry is smallest or largest, so that no peak is lost.
    fn thin_out(&mut self, most: usize) {
        let points = self.x.len();
        if points <= most {
            return;
        }
        let lists: usize = self.entries.iter().map(|entry| entry.values.lists().len()).sum();
        let stretches = (most / (2 * lists.max(1))).max(1);
        let mut kept = vec![0, points - 1];
        for stretch in 0..stretches {
            let from = stretch * points / stretches;
            let to = ((stretch + 1) * points / stretches).min(points);
            for list in self.entries.iter().flat_map(|entry| entry.values.lists()) {
                let values = || (from..to).filter_map(|row| Some((row, list.get(row).copied().flatten()?)));
                kept.extend(values().min_by(|a, b| a.1.total_cmp(&b.1)).map(|(row, _)| row));
                kept.extend(values().max_by(|a, b| a.1.total_cmp(&b.1)).map(|(row, _)| row));
            }
        }
        kept.sort_unstable();
        kept.dedup();
        let pick = |list: &Vec<Option<f64>>| kept.iter().map(|row| list.get(*row).copied().flatten()).collect();
        self.x = pick(&self.x);
        for entry in &mut self.entries {
            for list in entry.values.lists_mut() {
                *list = pick(list);
            }
        }
    }
}

fn swatch_shape(entry: &Entry) -> &'static str {
    match (&entry.values, entry.dashed) {
        (EntryValues::Band { .. }, _) => "area",
        (_, true) => "dashed",
        (_, false) => "line",
    }
}

fn cell(value: Option<f64>) -> String {
    match value {
        Some(value) => {
            super::number::significant(value, PLAIN_DIGITS, super::number::Rounding::Nearest).replace('-', "−")
        }
        None => "–".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use loosepin_text::units::DisplayUnits;

    #[test]
    fn analytic_a_long_history_keeps_its_peak() {
        const POINTS: usize = 100_000;
        const PEAK_AT: usize = 54_321;
        let mut values = vec![0.25; POINTS];
        values[PEAK_AT] = 9.75;
        let x: Vec<f64> = (0..POINTS).map(|point| point as f64).collect();
        let units = DisplayUnits::default();
        let mut chart = Chart::over("a".to_owned(), "", &x, &SiUnit::NONE, &NumberWriter::for_page(&units));
        chart.entries.push(Entry::new("", Role::First, false, EntryValues::line(&values)));
        chart.thin_out(MOST_POINTS);
        assert!(chart.x.len() <= MOST_POINTS + 2, "{} points", chart.x.len());
        let peak = chart.entries[0].values.lists()[0].iter().position(|value| *value == Some(9.75));
        assert_eq!(peak.map(|row| chart.x[row]), Some(Some(PEAK_AT as f64)));
    }
}

//! A chart as a figure of a page: the picture, the legend, the text alternative and the numbers behind it.

use maud::{Markup, html};

use crate::charts::axes::with_unit;
use crate::charts::chart::{Chart, Entry, EntryValues};
use crate::charts::drawing::{Drawn, drawing};
use crate::charts::figure::{Picture, csv_element, csv_text};
use crate::medium::script_data::distinguishing_digits;
use crate::numbers::number::PLAIN_DIGITS;

/// Rows that the numbers behind a chart hold at most; longer histories keep the extremes of each stretch.
const MAX_ROWS: usize = 20_000;
/// Points that a picture has at most per curve.
const MAX_POINTS: usize = 1600;
/// Rows of the table behind a chart.
const TABLE_ROWS: usize = 24;

impl Chart {
    /// The figure: picture, legend with read-out, caption, numbers.
    pub fn figure(mut self) -> Markup {
        self.thin_out(MAX_ROWS);
        let mut drawn = self.clone();
        drawn.thin_out(MAX_POINTS);
        // In the picture alone: the table has the poses of the record.
        let is_closed = drawn.close_turn();
        let Drawn { view, below, plot, drawn } = drawing(&drawn);
        let name = self.id.clone();
        let picture = Picture { name, class: "chart", view, below, alternative: self.alternative.clone(), drawn };
        html! {
            figure.chart id=(self.id) data-figure=(self.id) {
                div.plot data-chart=(self.id) data-plot=(plot.to_attribute()) data-x-name=(self.x_label) data-x-unit=(self.x_symbol)
                    data-y-unit=(self.y_symbol) data-angle[self.is_in_degrees()] data-closed[is_closed] data-fixed[self.y_range.is_some()] role="group" aria-label=(self.alternative) {
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

    /// The picture alone, as an SVG document that takes its style from the page; `data-plot`, `data-x` and `data-y` say where its
    /// curves stand.
    pub fn document(mut self) -> String {
        self.thin_out(MAX_POINTS);
        let Drawn { view, below, plot, drawn } = drawing(&self);
        let picture = Picture {
            name: self.id.clone(),
            class: "chart",
            view,
            below,
            alternative: self.alternative.clone(),
            drawn,
        };
        picture.document(&[("plot", plot.frame()), ("x", plot.ends()), ("y", plot.y_ends())])
    }

    /// The numbers behind the chart: a column for each curve, units in the header, gaps empty.
    fn csv(&self) -> String {
        let head = |words: &str, symbol: &str| csv_text(&with_unit(words, symbol));
        let mut heads = vec![head(&self.x_label, &self.x_symbol)];
        for entry in &self.entries {
            let parts: &[&str] = if entry.values.lists().len() == 2 { &[", lower", ", upper"] } else { &[""] };
            heads.extend(parts.iter().map(|part| head(&format!("{}{part}", entry.label), &self.y_symbol)));
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
        let shown: Vec<f64> = self.x.iter().step_by(step).copied().flatten().collect();
        let digits = distinguishing_digits(&shown, PLAIN_DIGITS);
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
                                    th scope="row" { (cell(self.x[row], digits)) }
                                    @for entry in &self.entries {
                                        @for list in entry.values.lists() {
                                            td { (cell(list.get(row).copied().flatten(), PLAIN_DIGITS)) }
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
                // A gap stays one.
                kept.extend((from..to).find(|row| list.get(*row).copied().flatten().is_none()));
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

fn cell(value: Option<f64>, digits: usize) -> String {
    match value {
        Some(value) => crate::numbers::number::significant(value, digits, crate::numbers::number::Rounding::Nearest)
            .replace('-', "−"),
        None => "–".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::MAX_POINTS;
    use crate::charts::chart::{Chart, Entry, EntryValues, Role};
    use crate::numbers::number::NumberWriter;
    use loosepin_text::units::{DisplayUnits, SiUnit};

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
        chart.thin_out(MAX_POINTS);
        assert!(chart.x.len() <= MAX_POINTS + 2, "{} points", chart.x.len());
        let mut gapped = vec![0.5; POINTS];
        gapped[40_000..60_000].fill(f64::NAN);
        let mut broken = Chart::over("b".to_owned(), "", &x, &SiUnit::NONE, &NumberWriter::for_page(&units));
        broken.entries.push(Entry::new("", Role::First, false, EntryValues::line(&gapped)));
        broken.thin_out(MAX_POINTS);
        assert!(broken.entries[0].values.lists()[0].iter().any(Option::is_none), "a gap stays one");
        let peak = chart.entries[0].values.lists()[0].iter().position(|value| *value == Some(9.75));
        assert_eq!(peak.map(|row| chart.x[row]), Some(Some(PEAK_AT as f64)));
    }
}

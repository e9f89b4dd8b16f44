//! Tables of points: in the file itself, or in a CSV file beside it.

use super::reader::ModelReader;
use crate::model::entry_reader::{Column, EntryReader};
use crate::model::problem::ModelProblem;
use loosepin_text::diagnostics::{Diagnostic, Place, Source};
use loosepin_text::document::{Entry, read_beside};
use loosepin_text::numbers::{Origin, Quantity, QuantityId, UNREAD};
use loosepin_text::units::{Dimension, Rule, parse_quantity};

/// A cubic spline needs two intervals to have a bend.
const MIN_POINTS: usize = 3;

impl EntryReader for ModelReader {
    fn fixed_number(&mut self, entry: &Entry<'_>, rule: Rule) -> Option<(QuantityId, f64)> {
        let written = self.numbers.expression(entry)?;
        if !self.numbers.reader.measures(entry, written.dimension, Dimension::NUMBER) {
            return None;
        }
        let id = self.numbers.add_with_origin(entry, &written, rule, Origin::Fixed)?;
        Some((id, self.numbers.quantities.nominal_value(id)))
    }

    fn table_points(&mut self, given: [&Option<Entry<'_>>; 2], columns: [Column; 2]) -> Option<Vec<[QuantityId; 2]>> {
        match given {
            [_, Some(csv)] => self.points_of_file(csv, columns),
            [points, None] => self.points_of_list(points.as_ref()?, columns),
        }
    }
}

impl ModelReader {
    fn points_of_list(&mut self, list: &Entry<'_>, columns: [Column; 2]) -> Option<Vec<[QuantityId; 2]>> {
        let elements = self.numbers.reader.list(list)?;
        if elements.len() < MIN_POINTS {
            let problem = ModelProblem::TooFewPoints { entry: list.path.describe(), least: MIN_POINTS };
            return self.numbers.reader.refuse(&problem, list.span);
        }
        let mut points: Vec<[QuantityId; 2]> = Vec::new();
        let mut is_sound = true;
        for element in &elements {
            let Some([mut first, mut second]) = self.numbers.reader.pair(element) else {
                is_sound = false;
                continue;
            };
            let [(first_name, first_dimension), (second_name, second_dimension)] = columns;
            first.path = element.path.join(first_name);
            second.path = element.path.join(second_name);
            let first_id = self.numbers.quantity_of(&first, first_dimension, Rule::Finite).unwrap_or(UNREAD);
            let second_id = self.numbers.quantity_of(&second, second_dimension, Rule::Finite).unwrap_or(UNREAD);
            is_sound &= first_id != UNREAD && second_id != UNREAD;
            if is_sound && let Some([before, _]) = points.last() {
                is_sound &= self.numbers.demand_order(*before, first_id, first.span);
            }
            points.push([first_id, second_id]);
        }
        is_sound.then_some(points)
    }

    fn points_of_file(&mut self, entry: &Entry<'_>, columns: [Column; 2]) -> Option<Vec<[QuantityId; 2]>> {
        let name = self.numbers.reader.text(entry)?;
        let source = match read_beside(&self.numbers.reader.source, name) {
            Ok(source) => source,
            Err(diagnostics) => {
                // The place that names the file is where a person looks for the slip.
                for diagnostic in diagnostics.sorted() {
                    let place = diagnostic.place.clone().unwrap_or_else(|| self.numbers.reader.place(entry.span));
                    self.numbers.reader.diagnostics.push(Diagnostic { place: Some(place), ..diagnostic.clone() });
                }
                return None;
            }
        };
        self.tables.push(source.clone());
        let path = entry.path.dotted();
        let report = |reader: &mut Self, problem: ModelProblem, span: std::ops::Range<usize>| {
            reader.numbers.reader.diagnostics.push(Diagnostic::error(&problem, Some(Place::new(&source, span))));
        };
        let mut units: Option<[String; 2]> = None;
        let mut points: Vec<[QuantityId; 2]> = Vec::new();
        let mut is_sound = true;
        for (row, cells) in rows(&source).into_iter().enumerate() {
            let [Some(first), Some(second), None] = [cells.first(), cells.get(1), cells.get(2)] else {
                let span = cells.first().map_or(0, |cell| cell.start)..cells.last().map_or(0, |cell| cell.end);
                let text = source.text()[span.clone()].to_owned();
                report(self, ModelProblem::CsvColumns { found: cells.len(), text }, span);
                return None;
            };
            let cells = [first.clone(), second.clone()];
            let Some(units) = &units else {
                let mut found = [String::new(), String::new()];
                for ((cell, (_, due)), unit) in cells.iter().zip(columns).zip(&mut found) {
                    let text = &source.text()[cell.clone()];
                    let written = text.strip_suffix(']').and_then(|text| text.rsplit_once('['));
                    let measured = written.and_then(|(_, unit)| parse_quantity(&format!("1 {}", unit.trim())).ok());
                    let Some((written, measured)) = written.zip(measured) else {
                        report(self, ModelProblem::CsvHeader { text: text.to_owned() }, cell.clone());
                        return None;
                    };
                    if measured.dimension != due {
                        report(self, ModelProblem::CsvDimension { text: text.to_owned(), due }, cell.clone());
                        return None;
                    }
                    *unit = written.1.trim().to_owned();
                }
                units = Some(found);
                continue;
            };
            let mut ids = [UNREAD; 2];
            for (side, cell) in cells.iter().enumerate() {
                let text = &source.text()[cell.clone()];
                let number = text.parse::<f64>().ok().filter(|number| number.is_finite());
                let value = number.and_then(|_| parse_quantity(&format!("{text} {}", units[side])).ok());
                let Some(value) = value else {
                    report(self, ModelProblem::CsvNumber { text: text.to_owned() }, cell.clone());
                    is_sound = false;
                    continue;
                };
                let (column, dimension) = columns[side];
                let quantity = Quantity {
                    path: format!("{path}.{row}.{column}"),
                    dimension,
                    rule: Rule::Finite,
                    origin: Origin::Fixed,
                    span: None,
                };
                ids[side] = self.numbers.quantities.add_number(quantity, value.value_si);
            }
            if is_sound
                && let Some([before, _]) = points.last()
                && let Err(problem) = self.numbers.quantities.demand_order(*before, ids[0])
            {
                let place = Place::new(&source, cells[0].clone());
                self.numbers.reader.diagnostics.push(Diagnostic::error(&problem, Some(place)));
                is_sound = false;
            }
            points.push(ids);
        }
        if points.len() < MIN_POINTS {
            report(self, ModelProblem::TooFewPoints { entry: entry.path.describe(), least: MIN_POINTS }, 0..0);
            return None;
        }
        is_sound.then_some(points)
    }
}

/// Cells of all rows that are neither empty nor comments, as ranges of the text without the blanks around them.
fn rows(source: &Source) -> Vec<Vec<std::ops::Range<usize>>> {
    let is_blank = |c: char| c.is_whitespace() || matches!(c, '"' | '\u{feff}');
    let text = source.text();
    let mut rows = Vec::new();
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let bare = line.trim_matches(is_blank);
        if !bare.is_empty() && !bare.starts_with('#') {
            let mut at = start;
            let cells = line.split(',').map(|cell| {
                let begin = at + (cell.len() - cell.trim_start_matches(is_blank).len());
                at += cell.len() + 1;
                begin..begin + cell.trim_matches(is_blank).len()
            });
            rows.push(cells.collect());
        }
        start += line.len();
    }
    rows
}

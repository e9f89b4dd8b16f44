//! A motion in space on a terminal.

use crate::medium::article_text::terminal_text;
use loosepin_result::spatial_motion::{SpatialMotionRecord, SpatialOutputRecord};
use loosepin_text::article::{Cell, Column, Content, Section, Table};
use loosepin_text::units::{Dimension, SiUnit, counted, format_number, format_value};

/// A number below this share of those that it stands with is round-off.
const ROUND_OFF: f64 = 1e-12;
/// Digits of deviations.
const DIGITS: i32 = 4;

/// The ideal motion in space, its worst cases by play, and who contributes, as text for a terminal.
pub fn spatial_motion_text(record: &SpatialMotionRecord) -> String {
    let mut sections = vec![outputs(record)];
    if record.has_play {
        sections.extend(record.outputs.iter().map(|output| contributors(record, output)));
    }
    terminal_text(&record.model, sections)
}

fn outputs(record: &SpatialMotionRecord) -> Section {
    let mut section = Section::new("outputs", "");
    let play = match record.has_play {
        true => "worst cases of play in the ideal position of each",
        false => "no joint has play",
    };
    section.push(Content::sentences([format!("{} over a turn, {play}.", counted(record.inputs_si.len(), "position"))]));
    let heads =
        ["smallest", "largest", "worst case, first order", "at", "found, up", "found, down", "standard deviation"];
    let columns = std::iter::once(Column::words("output")).chain(heads.map(Column::numbers)).collect();
    section.push(Content::Table(Table::new(columns, record.outputs.iter().map(|output| row(record, output)))));
    if record.has_play {
        section.push(Content::sentences([
            "The worst case of first order is largest at the place shown, to both sides alike. There a search closes the loops exactly: up and \
             down are the largest deviations it found. The standard deviation is for journals anywhere in their play, all places alike.",
        ]));
    }
    let conditions = record.outputs.iter().map(|output| output.worst.conditions).max().unwrap_or(0);
    if conditions > 0 {
        section.push(Content::sentences([format!(
            "The plays must meet {} together so that the loops close; the worst cases are with them, and the standard deviation has no closed \
             form. What a joint contributes is then its share of the worst case, not what it does alone.",
            counted(conditions, "condition")
        )]));
    }
    if record.has_play && record.outputs.iter().any(|output| output.ideal_si.is_empty()) {
        section.push(Content::sentences([
            "Of a displacement, the worst case is the longest one that a search over directions found, up and down are along that direction, and \
             the standard deviation is the root of the sum of the variances along x, y and z.",
        ]));
    }
    section
}

fn row(record: &SpatialMotionRecord, output: &SpatialOutputRecord) -> Vec<Cell> {
    let deviation = |value_si: f64| shown_deviation(value_si, output);
    let ends = (!output.ideal_si.is_empty()).then(|| {
        let ideal = output.ideal_si.iter().copied();
        let ends = [ideal.clone().fold(f64::INFINITY, f64::min), ideal.fold(f64::NEG_INFINITY, f64::max)];
        let scale_si = ends[0].abs().max(ends[1].abs());
        ends.map(|value_si| shown(value_si, &output.unit, scale_si))
    });
    let [smallest, largest] = ends.map_or([None, None], |ends| ends.map(Some));
    let worst = record.has_play.then(|| output.first_order_si.get(output.worst.sample).copied()).flatten();
    let at = worst.and_then(|_| record.inputs_si.get(output.worst.sample));
    let sigma = worst.and_then(|_| output.standard_deviation_si.get(output.worst.sample));
    let found = worst.map(|_| [output.worst.largest_si, output.worst.smallest_si].map(deviation));
    let [up, down] = found.map_or([None, None], |found| found.map(Some));
    let name = format!("{}: {}", output.name, output.words);
    let cells = [
        Some(name),
        smallest,
        largest,
        worst.map(deviation),
        at.map(|input| shown(*input, &record.input_unit, *input)),
        up,
        down,
        sigma.map(|sigma| deviation(*sigma)),
    ];
    cells.into_iter().map(Cell::from).collect()
}

fn contributors(record: &SpatialMotionRecord, output: &SpatialOutputRecord) -> Section {
    let at = record.inputs_si.get(output.worst.sample).copied().unwrap_or_default();
    let heading = format!("{}: what each joint contributes at {}", output.name, shown(at, &record.input_unit, at));
    let mut section = Section::new("contributors", heading);
    let heads = ["part", "offset alone", "lean alone", "axial"];
    let columns = std::iter::once(Column::words("joint")).chain(heads.map(Column::numbers)).collect();
    let value = |value_si: f64| shown_deviation(value_si, output);
    let rows = output.worst.contributors.iter().map(|own| {
        let cells = [
            Some(own.joint.clone()),
            Some(value(own.part_si)),
            Some(value(own.offset_si)),
            own.lean_si.map(value),
            own.axial_si.map(value),
        ];
        cells.into_iter().map(Cell::from).collect::<Vec<Cell>>()
    });
    section.push_close(Content::Table(Table::new(columns, rows)));
    section
}

/// A deviation in the unit that fits the worst case of its output.
fn shown_deviation(value_si: f64, output: &SpatialOutputRecord) -> String {
    shown(value_si, &output.unit, output.first_order_si.get(output.worst.sample).copied().unwrap_or(value_si))
}

/// A number with the unit that fits a number of the size of `scale_si`.
fn shown(value_si: f64, unit: &SiUnit, scale_si: f64) -> String {
    if *unit == SiUnit::TIME {
        return format_value(rounded(value_si), Dimension::TIME);
    }
    let is_length = *unit == SiUnit::LENGTH;
    let size = scale_si.abs();
    let value_si = if value_si.abs() < ROUND_OFF * size { 0.0 } else { value_si };
    let (per_si, symbol) = match (is_length, size > 0.0 && size < if is_length { 1e-3 } else { 1e-2 }) {
        (true, true) => (1e6, "µm"),
        (true, false) => (1e3, "mm"),
        (false, true) => (1e3, "mrad"),
        (false, false) => (180.0 / std::f64::consts::PI, "deg"),
    };
    format!("{} {symbol}", format_number(rounded(value_si * per_si)))
}

fn rounded(value: f64) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    let digits = DIGITS - 1 - value.abs().log10().floor() as i32;
    let scale = 10_f64.powi(digits);
    // Text that is read back has no digits of round-off.
    if digits >= 0 { (value * scale).round() / scale } else { value.round() }
}

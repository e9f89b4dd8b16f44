//! Charts of a motion in space over its turn: worst cases of play; ideal values.

use super::numbers::{shown, shown_deviation, unit_of_size};
use super::tables::place;
use crate::charts::chart::{Chart, Entry, EntryValues, Mark, Role};
use crate::charts::figure::name_of;
use crate::numbers::number::NumberWriter;
use loosepin_result::spatial_motion::{SpatialMotionRecord, SpatialOutputRecord};
use loosepin_text::article::Medium;
use loosepin_text::units::{DisplayUnit, DisplayUnits, SiUnit};
use maud::{Markup, html};

/// The band of worst cases of first order of an output, with its standard deviation; nothing where no joint has play.
pub(super) fn worst_case_chart(record: &SpatialMotionRecord, output: &SpatialOutputRecord) -> Markup {
    let unit = unit_of_size(&output.unit, output.worst_case_si(), Medium::Page);
    let mut chart = motion_chart(record, name_of("worst-case", &output.name));
    (chart.y_label, chart.y_symbol) = (format!("deviation of {}", output.name), unit.symbol.clone());
    chart.height = 320;
    for (label, role, is_line, values_si) in [
        ("worst case, first order", Role::Mixed, false, &output.first_order_si),
        ("± standard deviation, journals anywhere in their play", Role::Random, false, &output.standard_deviation_si),
    ] {
        if values_si.is_empty() {
            continue;
        }
        let upper = in_order(record, values_si, &unit);
        let lower: Vec<f64> = upper.iter().map(|own| -own).collect();
        chart.entries.push(Entry::new(label, role, is_line, EntryValues::band(&lower, &upper)));
    }
    let at = record.inputs_si.get(output.worst.sample).copied().unwrap_or_default();
    let input_unit = input_unit(record);
    chart.marks.push(Mark { at: Some(input_unit.from_si(at)), label: "largest".to_owned() });
    let largest = shown_deviation(output.worst_case_si(), output, Medium::Page);
    let words = format!("at most {largest} to either side, at {}", place(record, output, Medium::Page));
    chart.caption = html! {
        strong { "Worst case of play on " (output.name) " (" (output.words) ") over the turn." } " To first order " (words) "."
    };
    chart.alternative =
        format!("Chart of the worst case of play on {} ({}) over the turn: {words}.", output.name, output.words);
    chart.figure()
}

/// The ideal value of an output; `None` of a path, which is no number.
pub(super) fn ideal_chart(record: &SpatialMotionRecord, output: &SpatialOutputRecord) -> Option<Markup> {
    let least = output.ideal_si.iter().copied().reduce(f64::min)?;
    let most = output.ideal_si.iter().copied().reduce(f64::max)?;
    let unit = unit_of_size(&output.unit, least.abs().max(most.abs()), Medium::Page);
    let mut chart = motion_chart(record, name_of("position", &output.name));
    (chart.y_label, chart.y_symbol) = (output.name.clone(), unit.symbol.clone());
    chart.height = 240;
    let values = in_order(record, &output.ideal_si, &unit);
    chart.entries.push(Entry::new("ideal value", Role::Nominal, false, EntryValues::line(&values)));
    let [least, most] = [least, most].map(|own| shown(own, &output.unit, own, Medium::Page));
    let range = format!("between {least} and {most}");
    chart.caption = html! { strong { "Ideal " (output.words) " (" (output.name) ")" } ": " (range) "." };
    chart.alternative = format!("Chart of the ideal value of {} over the turn: {range}.", output.name);
    Some(chart.figure())
}

/// A chart over the input of the motion.
pub(crate) fn motion_chart(record: &SpatialMotionRecord, id: String) -> Chart {
    let units = DisplayUnits::default();
    let writer = NumberWriter::for_page(&units);
    let inputs = sorted(record, &record.inputs_si);
    match record.input_unit == SiUnit::ANGLE {
        true => Chart::over_angle(id, &record.input, &inputs, &writer),
        false => Chart::over(id, &record.input, &inputs, &record.input_unit, &writer),
    }
}

/// The unit of the horizontal axis.
fn input_unit(record: &SpatialMotionRecord) -> DisplayUnit {
    DisplayUnits::default().of(&record.input_unit)
}

/// Values in the order in which the input increases: a drive may run backwards.
pub(crate) fn sorted(record: &SpatialMotionRecord, values: &[f64]) -> Vec<f64> {
    let is_backwards = matches!(record.inputs_si[..], [first, .., last] if last < first);
    if is_backwards { values.iter().rev().copied().collect() } else { values.to_vec() }
}

fn in_order(record: &SpatialMotionRecord, values_si: &[f64], unit: &DisplayUnit) -> Vec<f64> {
    sorted(record, values_si).into_iter().map(|own| unit.from_si(own)).collect()
}

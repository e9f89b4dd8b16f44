//! Measured curves over computed ones, and their residuals.

use maud::{Markup, html};

use super::chart::{Chart, Entry, HorizontalAxis, Role, scaled};
use super::number::{NumberWriter, Rounding};
use super::script_data::rounded;
use super::wording::count;
use loosepin_result::simulation::{Abscissa, MeasuredCurve, SimulationRecord};
use loosepin_text::units::SiUnit;

/// The table of residuals, and two charts a curve.
pub(super) fn measured_figures(record: &SimulationRecord, writer: &NumberWriter) -> Markup {
    html! {
        p {
            "Residual: measured minus computed value at the same time or angle. Computed values are interpolated linearly between \
             the samples."
        }
        table.cards {
            thead {
                tr {
                    th scope="col" { "Measured" }
                    th scope="col" { "File" }
                    th.number scope="col" { "Values" }
                    th.number scope="col" { "Root mean square" }
                    th.number scope="col" { "Largest" }
                    th scope="col" { "At" }
                }
            }
            tbody {
                @for curve in &record.measured {
                    tr {
                        th scope="row" { (curve.output) }
                        td data-label="File" { (curve.file) }
                        td.number data-label="Values" { (count(curve.at_si.len() as u64, writer)) }
                        td.number data-label="Root mean square" { (writer.value(curve.rms_si, &curve.unit)) }
                        td.number data-label="Largest" { (writer.value(curve.largest_si, &curve.unit)) }
                        td data-label="At" { (at_words(curve, record, writer)) }
                    }
                }
            }
        }
        @for (index, curve) in record.measured.iter().enumerate() {
            (over(curve, record, index, writer).figure())
            (residual(curve, record, index, writer).figure())
        }
    }
}

/// Where the largest residual of a curve is.
pub(super) fn at_words(curve: &MeasuredCurve, record: &SimulationRecord, writer: &NumberWriter) -> String {
    match curve.abscissa {
        Abscissa::Time => writer.value(curve.largest_at_si, &SiUnit::TIME),
        Abscissa::DriveAngle => {
            let angle = writer.rounded(curve.largest_at_si, &SiUnit::ANGLE, 4, Rounding::Nearest);
            format!("{} at {angle}", record.settings.drive)
        }
    }
}

fn chart(curve: &MeasuredCurve, record: &SimulationRecord, id: String, writer: &NumberWriter) -> Chart {
    let (unit, label) = match curve.abscissa {
        Abscissa::Time => (SiUnit::TIME, "time".to_owned()),
        Abscissa::DriveAngle => (SiUnit::ANGLE, record.settings.drive.clone()),
    };
    Chart {
        id,
        horizontal: HorizontalAxis::Plain,
        x_label: label,
        x_symbol: writer.symbol(&unit),
        x: rounded(&scaled(&curve.at_si, &unit, writer)),
        y_label: curve.output.clone(),
        y_symbol: writer.symbol(&curve.unit),
        y_range: None,
        entries: Vec::new(),
        marks: Vec::new(),
        height: 300,
        caption: html! {},
        alternative: String::new(),
    }
}

fn over(curve: &MeasuredCurve, record: &SimulationRecord, index: usize, writer: &NumberWriter) -> Chart {
    let mut chart = chart(curve, record, format!("measured-{index}"), writer);
    chart.entries.push(Entry::line("computed", Role::First, false, &curve.computed_si, &curve.unit, writer));
    chart.entries.push(Entry::line("measured", Role::Limit, true, &curve.measured_si, &curve.unit, writer));
    chart.caption = html! { strong { (curve.output) } ", measured (" (curve.file) ") and computed." };
    chart.alternative = format!("Chart of {}, measured and computed.", curve.output);
    chart
}

fn residual(curve: &MeasuredCurve, record: &SimulationRecord, index: usize, writer: &NumberWriter) -> Chart {
    let mut chart = chart(curve, record, format!("residual-{index}"), writer);
    chart.height = 200;
    let residuals: Vec<f64> =
        curve.measured_si.iter().zip(&curve.computed_si).map(|(measured, computed)| measured - computed).collect();
    chart.entries.push(Entry::line("measured minus computed", Role::Mixed, false, &residuals, &curve.unit, writer));
    chart.caption = html! { strong { "Residual of " (curve.output) } ": measured minus computed." };
    chart.alternative = format!("Chart of the residual of {}.", curve.output);
    chart
}

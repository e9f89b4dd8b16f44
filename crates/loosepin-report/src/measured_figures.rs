//! Measured curves over computed ones, and their residuals.

use maud::{Markup, html};

use super::chart::{Chart, Entry, Role};
use super::figure::name_of;
use super::number::{NumberWriter, Rounding};
use super::page::cards;
use super::wording::count;
use loosepin_result::simulation::{Abscissa, MeasuredCurve, SimulationRecord};
use loosepin_text::units::SiUnit;

/// The table of residuals, and two charts a curve.
pub(super) fn measured_figures(record: &SimulationRecord, writer: &NumberWriter) -> Markup {
    let rows = record.measured.iter().map(|curve| {
        [
            html! { (curve.output) },
            html! { (curve.file) },
            html! { (count(curve.at_si.len() as u64, writer)) },
            html! { (writer.value(curve.rms_si, &curve.unit)) },
            html! { (writer.value(curve.largest_si, &curve.unit)) },
            html! { (at_words(curve, record, writer)) },
        ]
    });
    html! {
        p {
            "Residual: measured minus computed value at the same time or angle. Computed values are interpolated linearly between \
             the samples."
        }
        (cards(["Measured", "File", "#Values", "#Root mean square", "#Largest", "At"], rows))
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
        Abscissa::Time => (SiUnit::TIME, "time"),
        Abscissa::DriveAngle => (SiUnit::ANGLE, record.settings.drive.as_str()),
    };
    let chart = Chart::over(id, label, &curve.at_si, &unit, writer);
    Chart { y_label: curve.output.clone(), y_symbol: writer.symbol(&curve.unit), ..chart }
}

fn over(curve: &MeasuredCurve, record: &SimulationRecord, index: usize, writer: &NumberWriter) -> Chart {
    let mut chart = chart(curve, record, name_of("measured", &format!("{} {}", curve.output, index + 1)), writer);
    chart.entries.push(Entry::line("computed", Role::First, false, &curve.computed_si, &curve.unit, writer));
    chart.entries.push(Entry::line("measured", Role::Limit, true, &curve.measured_si, &curve.unit, writer));
    chart.caption = html! { strong { (curve.output) } ", measured (" (curve.file) ") and computed." };
    chart.alternative = format!("Chart of {}, measured and computed.", curve.output);
    chart
}

fn residual(curve: &MeasuredCurve, record: &SimulationRecord, index: usize, writer: &NumberWriter) -> Chart {
    let mut chart = chart(curve, record, name_of("residual", &format!("{} {}", curve.output, index + 1)), writer);
    chart.height = 200;
    let residuals: Vec<f64> =
        curve.measured_si.iter().zip(&curve.computed_si).map(|(measured, computed)| measured - computed).collect();
    chart.entries.push(Entry::line("measured minus computed", Role::Mixed, false, &residuals, &curve.unit, writer));
    chart.caption = html! { strong { "Residual of " (curve.output) } ": measured minus computed." };
    chart.alternative = format!("Chart of the residual of {}.", curve.output);
    chart
}

//! Measured curves over computed ones, and their residuals.

use maud::html;

use crate::charts::chart::{Chart, Entry, Role};
use crate::charts::figure::name_of;
use crate::medium::article_page::push_figure;
use crate::numbers::number::{NumberWriter, Rounding};
use crate::words::wording::{count, head};
use loosepin_result::simulation::{Abscissa, MeasuredCurve, SimulationRecord};
use loosepin_text::article::{Column, Content, Medium, Section, Table, Text};
use loosepin_text::units::SiUnit;

/// The table of residuals, and on a page two charts a curve; `None` if nothing was measured.
pub(super) fn measured_section(record: &SimulationRecord, writer: &NumberWriter) -> Option<Section> {
    if record.measured.is_empty() {
        return None;
    }
    let mut section = Section::headed_on_page("measured", "Measured against computed");
    let what = "Residual: measured minus computed value at the same time or angle. Computed values are interpolated linearly between the \
                samples.";
    section.push_on(Medium::Page, Content::sentences([what]));
    let columns = vec![
        Column::words(head("measured")),
        Column { only: Some(Medium::Page), ..Column::words("File") },
        Column::numbers(head("values")),
        Column::numbers(Text::by_medium("Root mean square", "rms")),
        Column::numbers(head("largest")),
        Column::words(head("at")),
    ];
    let row = |curve: &MeasuredCurve| {
        vec![
            curve.output.clone(),
            curve.file.clone(),
            count(curve.at_si.len() as u64, writer),
            writer.value(curve.rms_si, &curve.unit),
            writer.value(curve.largest_si, &curve.unit),
            at_words(curve, record, writer),
        ]
    };
    section.push(Content::Table(Table::new(columns, record.measured.iter().map(row))));
    section.push_close_on(Medium::Terminal, Content::Note("residual: measured minus computed".into()));
    push_figure(&mut section, writer, || {
        html! {
            @for (index, curve) in record.measured.iter().enumerate() {
                (over(curve, record, index, writer).figure())
                (residual(curve, record, index, writer).figure())
            }
        }
    });
    Some(section)
}

/// Place of the largest residual of a curve.
fn at_words(curve: &MeasuredCurve, record: &SimulationRecord, writer: &NumberWriter) -> String {
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
    let mut chart = Chart::over(id, label, &curve.at_si, &unit, writer);
    chart.set_vertical_axis(&curve.output, &curve.unit, writer);
    chart
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

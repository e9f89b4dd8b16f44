//! Charts of a run over the angle of the drive or over time: outputs, deviations, controls, the energy balance.

use maud::{Markup, html};

use crate::charts::chart::{Chart, Entry, Role, turns_before_rad};
use crate::charts::figure::name_of;
use crate::charts::path_figure::{RunCourse, run_path_figure};
use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::Tag;
use crate::words::wording::{all_without_round_off, named_words};
use loosepin_result::simulation::{ImpactRecord, OutputHistory, SimulationRecord};
use loosepin_text::units::SiUnit;

/// Whether the charts of a run are over the angle of the drive: where it turns forwards at constant speed. Others are over time.
fn is_over_angle(record: &SimulationRecord) -> bool {
    record.settings.drive_speed_rad_s.is_some_and(|speed| speed > 0.0)
}

/// A chart over the angle of the drive, from 0° on, or over time.
pub(super) fn run_chart(record: &SimulationRecord, id: String, writer: &NumberWriter) -> Chart {
    if !is_over_angle(record) {
        return Chart::over(id, "time", &record.time_s, &SiUnit::TIME, writer);
    }
    let before_rad = before_rad(record);
    let angles_rad: Vec<f64> = record.drive_angle_rad.iter().map(|angle_rad| angle_rad - before_rad).collect();
    Chart::over_angle(id, &record.settings.drive, &angles_rad, writer)
}

/// Place of an impact in the charts of a run.
pub(super) fn impact_place(record: &SimulationRecord, impact: &ImpactRecord, writer: &NumberWriter) -> f64 {
    if !is_over_angle(record) {
        return writer.scaled(impact.time_s, &SiUnit::TIME);
    }
    writer.scaled(impact.drive_angle_rad - before_rad(record), &SiUnit::ANGLE)
}

/// Whole turns before the recorded part, rad.
pub(super) fn before_rad(record: &SimulationRecord) -> f64 {
    turns_before_rad(&record.drive_angle_rad)
}

/// Words for the abscissa of the charts of a run.
pub(super) fn abscissa_words(record: &SimulationRecord) -> String {
    if is_over_angle(record) { format!("over the angle of {}", record.settings.drive) } else { "over time".to_owned() }
}

/// A chart of each output.
pub(super) fn outputs(record: &SimulationRecord, writer: &NumberWriter) -> Markup {
    html! {
        div.charts {
            @for output in &record.outputs {
                (output_chart(record, output, writer).figure())
            }
        }
    }
}

/// The paths of points, each beside its ideal path; `None` if there are none.
pub(super) fn paths(record: &SimulationRecord, writer: &NumberWriter) -> Option<Markup> {
    let before_rad = before_rad(record);
    let figures = record.paths.iter().filter_map(|path| {
        let [x, y] = record.coordinates(path)?;
        let angles = record.drive_angle_rad.iter().filter(|_| is_over_angle(record));
        let course = RunCourse {
            name: &path.name,
            point: &path.point,
            xy_m: [&x.value_si, &y.value_si],
            ideal_m: [&x.ideal_si, &y.ideal_si],
            tolerance_m: record.settings.tolerance_m,
            drive_angle_rad: angles.map(|angle_rad| angle_rad - before_rad).collect(),
        };
        Some(run_path_figure(&course, writer))
    });
    let figures: Vec<Markup> = figures.collect();
    (!figures.is_empty()).then(|| html! { div.charts { @for figure in figures { (figure) } } })
}

fn output_chart(record: &SimulationRecord, output: &OutputHistory, writer: &NumberWriter) -> Chart {
    let mut chart = run_chart(record, name_of("output", &output.name), writer);
    chart.set_vertical_axis(&output.name, &output.unit, writer);
    let shown = |values_si: &[f64]| all_without_round_off(record, values_si, &output.unit);
    let value_si = shown(&output.value_si);
    chart.entries.push(Entry::line("with play", Role::First, false, &value_si, &output.unit, writer));
    if !output.ideal_si.is_empty() {
        let ideal_si = shown(&output.ideal_si);
        chart.entries.push(Entry::line("ideal", Role::Worst, true, &ideal_si, &output.unit, writer));
    }
    let over = abscissa_words(record);
    chart.caption = html! { strong { (named_words(&output.name, &output.words)) } " " (over) "." };
    chart.alternative = format!("Chart of {} {over}.", named_words(&output.name, &output.words));
    chart
}

/// Outputs with an ideal value.
pub(super) fn outputs_with_deviation(record: &SimulationRecord) -> impl Iterator<Item = &OutputHistory> {
    record.outputs.iter().filter(|output| !output.deviation_si.is_empty())
}

/// A chart of each deviation but the first, which stands below the answer.
pub(super) fn other_deviations(record: &SimulationRecord, writer: &NumberWriter) -> Markup {
    html! {
        div.charts { @for output in outputs_with_deviation(record).skip(1) { (deviation_chart(record, output, writer).figure()) } }
    }
}

/// The deviation of an output from its ideal value.
pub(super) fn deviation_chart(record: &SimulationRecord, output: &OutputHistory, writer: &NumberWriter) -> Chart {
    let mut chart = run_chart(record, name_of("deviation", &output.name), writer);
    chart.set_vertical_axis(format!("deviation of {}", output.name), &output.unit, writer);
    let deviation_si = all_without_round_off(record, &output.deviation_si, &output.unit);
    chart.entries.push(Entry::line("actual minus ideal", Role::Mixed, false, &deviation_si, &output.unit, writer));
    chart.caption = html! { strong { "Deviation of " (named_words(&output.name, &output.words)) } ": actual minus ideal at the same time." };
    chart.alternative = format!(
        "Chart of the deviation of {} from its ideal value {}.",
        named_words(&output.name, &output.words),
        abscissa_words(record)
    );
    chart
}

/// Two charts of each control.
pub(super) fn controls(record: &SimulationRecord, writer: &NumberWriter) -> Markup {
    html! {
        @for control in &record.controls {
            h3 { (control.name) }
            @let about = html! { strong { "Error." } " Reference minus " (control.measured) "." };
            (control_chart(record, name_of("control-error", &control.name), "error", (&control.error_si, &control.unit), about, writer))
            @let about = html! { strong { "Effort." } " Force or torque of the actuator in " (control.joint) "." };
            (control_chart(record, name_of("control-effort", &control.name), "effort", (&control.effort_si, &control.effort_unit), about, writer))
        }
    }
}

fn control_chart(
    record: &SimulationRecord,
    id: String,
    label: &str,
    (values_si, unit): (&[f64], &SiUnit),
    caption: Markup,
    writer: &NumberWriter,
) -> Markup {
    let mut chart = run_chart(record, id, writer);
    chart.set_vertical_axis(label.to_owned(), unit, writer);
    chart.height = 220;
    chart.entries.push(Entry::line(label, Role::Mixed, false, values_si, unit, writer));
    chart.caption = caption;
    chart.alternative = format!("Chart of the {label} of a control {}.", abscissa_words(record));
    chart.figure()
}

/// The parts of the balance, and the residual.
pub(super) fn energy(record: &SimulationRecord, writer: &NumberWriter) -> Markup {
    let account = &record.energy;
    let unit = SiUnit::ENERGY;
    let mut chart = run_chart(record, "energy-account".to_owned(), writer);
    chart.set_vertical_axis("energy", &unit, writer);
    let histories = [
        ("kinetic", Role::First, false, &account.kinetic_j),
        ("potential", Role::Third, false, &account.potential_j),
        ("stored in contacts and springs", Role::Fourth, false, &account.stored_j),
        ("lost in contacts", Role::Second, false, &account.contact_loss_j),
        ("lost in friction", Role::Limit, false, &account.friction_loss_j),
        ("lost in dampers", Role::Mixed, false, &account.damping_loss_j),
        ("supplied", Role::Worst, true, &account.supplied_j),
    ];
    for (label, role, is_dashed, values_j) in histories {
        if values_j.iter().any(|value| *value != 0.0) {
            chart.entries.push(Entry::line(label, role, is_dashed, values_j, &unit, writer));
        }
    }
    chart.caption = html! {
        strong { "Energy balance." } " Kinetic, potential and stored energy, losses, and the work supplied since the start. Parts \
        that are always zero are not drawn."
    };
    chart.alternative = "Chart of the parts of the energy balance over time.".to_owned();
    let mut rest = run_chart(record, "energy-residual".to_owned(), writer);
    rest.set_vertical_axis("residual", &unit, writer);
    rest.height = 200;
    rest.entries.push(Entry::line("residual", Role::Worst, false, &account.residual_j, &unit, writer));
    rest.caption = html! {
        strong { "Residual of the energy balance." } " At most "
        (writer
            .with_tag(&Tag::whole("energy residual", "relative"))
            .rounded(account.relative_residual, &SiUnit::NONE, 2, Rounding::Up))
        " of the largest energy exchanged. It checks the run."
    };
    rest.alternative = "Chart of the energy residual over time.".to_owned();
    html! {
        @if !chart.entries.is_empty() { (chart.figure()) }
        @if !account.residual_j.is_empty() { (rest.figure()) }
    }
}

//! Oscillations in a run: root mean squares, peaks, and amplitudes over orders of the drive.

use maud::html;

use crate::charts::chart::{Chart, Entry, Role};
use crate::charts::figure::name_of;
use crate::medium::article_page::push_figure;
use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::Tag;
use crate::words::wording::{head, listed, named_words, without_round_off};
use loosepin_result::simulation::{SimulationRecord, Spectrum};
use loosepin_text::article::{Column, Content, Medium, Section, Table, Text};
use loosepin_text::units::SiUnit;

/// Dominant orders in the table.
const DOMINANT: usize = 3;
/// Units of the histories whose spectra are drawn: accelerations, forces, torques and powers.
const DRAWN: [&str; 5] = ["m/s^2", "rad/s^2", "N", "N m", "W"];

/// A history with its spectrum.
struct Oscillation {
    /// Its name, and its description in words.
    name: String,
    words: String,
    unit: SiUnit,
    spectrum: Spectrum,
    /// Spectrum of the mechanism without play, if it has such a history.
    ideal: Option<Spectrum>,
    /// The largest magnitude, between samples too where that is known.
    peak_si: f64,
    /// Whether its spectrum is drawn.
    is_drawn: bool,
}

impl Oscillation {
    /// A number of it.
    fn tag(&self, part: &str) -> Tag {
        Tag::joint(&self.name, "oscillation", part)
    }
}

/// All histories of a run that have a spectrum: outputs, then contact forces.
fn oscillations(record: &SimulationRecord) -> Vec<Oscillation> {
    let mut found = Vec::new();
    for output in &record.outputs {
        let Some(spectrum) = record.spectrum(&output.value_si) else { continue };
        let extreme = record.extremes.iter().find(|extreme| extreme.name == output.name && extreme.of.is_value());
        let peak_si = extreme.map_or(spectrum.peak_si, |extreme| {
            f64::max(extreme.minimum.value_si.abs(), extreme.maximum.value_si.abs())
        });
        let (name, words, unit) = (output.name.clone(), output.words.clone(), output.unit.clone());
        let is_drawn = DRAWN.contains(&unit.symbol());
        // Only a chart shows it.
        let ideal = if is_drawn { record.spectrum(&output.ideal_si) } else { None };
        found.push(Oscillation { name, words, unit, spectrum, ideal, peak_si, is_drawn });
    }
    for history in &record.contact_forces {
        let Some(spectrum) = record.spectrum(&history.force_n) else { continue };
        let joint = record.joints.iter().find(|joint| joint.joint == history.joint);
        let peak_si = joint.map_or(spectrum.peak_si, |joint| joint.peak_force_n);
        // The magnitude of the force of a joint stands for its normal force where it is an output.
        let is_drawn =
            !record.outputs.iter().any(|output| output.magnitude_of_force_in.as_ref() == Some(&history.joint));
        let (name, words) = (format!("contact force in {}", history.joint), "normal force".to_owned());
        found.push(Oscillation { name, words, unit: SiUnit::FORCE, spectrum, ideal: None, peak_si, is_drawn });
    }
    found
}

/// The dominant orders with their amplitudes in words; empty where nothing oscillates.
fn dominant_words(record: &SimulationRecord, own: &Oscillation, writer: &NumberWriter) -> String {
    let of_order = |(order, amplitude_si): (f64, f64)| {
        // Eighths have three decimals.
        let order_words = writer.with_tag(&Tag::Given("order")).shortest((order * 1e3).round() / 1e3, &SiUnit::NONE);
        let tag = own.tag(&format!("amplitude of order {order}"));
        format!("{order_words} ({})", writer.with_tag(&tag).rounded(amplitude_si, &own.unit, 3, Rounding::Nearest))
    };
    let moves = |amplitude_si: f64| without_round_off(record, amplitude_si, &own.unit) != 0.0;
    let dominant = own.spectrum.dominant(DOMINANT).into_iter().filter(|(_, amplitude_si)| moves(*amplitude_si));
    dominant.map(of_order).collect::<Vec<_>>().join(", ")
}

/// `None` if no drive turns at constant speed or less than a turn was recorded.
pub(super) fn spectrum_section(record: &SimulationRecord, writer: &NumberWriter) -> Option<Section> {
    let all = oscillations(record);
    if all.is_empty() {
        return None;
    }
    let drive = &record.settings.drive;
    let mut section = Section::headed_on_page("spectra", "Oscillations");
    let what = format!(
        "The order of an oscillation is its number of waves in a turn of {drive}. Root mean squares include the mean. Orders and root mean \
         squares are those of the samples: impacts between them do not show."
    );
    section.push_on(Medium::Page, Content::sentences([what]));
    let columns = vec![
        Column::words(head("quantity")),
        Column::numbers(Text::by_medium("Root mean square", "rms")),
        Column::numbers(head("peak")),
        Column::words(head("largest orders (amplitude)")),
    ];
    let row = |own: &Oscillation| {
        let value = |part: &str, value_si: f64| {
            writer.with_tag(&own.tag(part)).value(without_round_off(record, value_si, &own.unit), &own.unit)
        };
        vec![
            own.name.clone(),
            value("root mean square", own.spectrum.rms_si),
            value("peak", own.peak_si),
            dominant_words(record, own, writer),
        ]
    };
    section.push(Content::Table(Table::new(columns, all.iter().map(row))));
    let short = "largest orders: waves in a turn, of the samples; impacts between two samples do not show";
    section.push_close_on(Medium::Terminal, Content::Note(short.into()));
    let has_none = |name: &&str| !all.iter().any(|own| own.name == **name);
    let outputs = record.outputs.iter().map(|output| output.name.as_str());
    let without: Vec<String> = outputs.filter(has_none).map(str::to_owned).collect();
    if !without.is_empty() {
        let words = format!(
            "No spectrum: {}. Such a history does not return to its first value, for example the angle of a shaft, or has undefined values.",
            listed(&without)
        );
        section.push_on(Medium::Page, Content::Note(words.into()));
    }
    let drawn = || all.iter().filter(|own| own.is_drawn);
    push_figure(&mut section, writer, || {
        html! { div.charts { @for own in drawn() { (spectrum_chart(own, drive, writer).figure()) } } }
    });
    Some(section)
}

fn spectrum_chart(own: &Oscillation, drive: &str, writer: &NumberWriter) -> Chart {
    let label = format!("order of {drive}");
    let mut chart = Chart::over(name_of("spectrum", &own.name), &label, &own.spectrum.orders, &SiUnit::NONE, writer);
    chart.set_vertical_axis("amplitude", &own.unit, writer);
    chart.height = 220;
    let line = |name: &str, role: Role, is_dashed: bool, spectrum: &Spectrum| {
        Entry::line(name, role, is_dashed, &spectrum.amplitudes_si, &own.unit, writer)
    };
    chart.entries.push(line("with play", Role::First, false, &own.spectrum));
    chart.entries.extend(own.ideal.as_ref().map(|ideal| line("ideal", Role::Worst, true, ideal)));
    let words = named_words(&own.name, &own.words);
    chart.caption = html! { strong { (words) } ": amplitude of each order." };
    chart.alternative = format!("Chart of the amplitudes of {words} over orders of {drive}.");
    chart
}

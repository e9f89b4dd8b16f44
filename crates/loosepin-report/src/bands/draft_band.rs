//! Bands over the cycle before a study is finished, each as a picture.

use maud::html;
use serde::Serialize;

use crate::charts::chart::{Chart, Entry, EntryValues, Role, scaled};
use crate::charts::figure::name_of;
use crate::numbers::number::{NumberWriter, Rounding};
use crate::words::limits::limits_words;
use crate::words::wording::{capitalised, deviation_of, deviation_words};
use loosepin_result::study::{Draft, DraftCurve, RequirementOutcome, ResponsePoint};

/// The band of one deviation, from the runs so far.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DraftBand {
    /// Title: `Deviation of slider`.
    pub title: String,
    /// Meaning of the band, and its present limits.
    pub words: String,
    /// The chart as an SVG document that takes its style from the page.
    pub figure: String,
}

/// The bands of a draft, in the order in which the study asks for them.
pub fn draft_bands(draft: &Draft) -> Vec<DraftBand> {
    let writer = NumberWriter::for_page(&draft.display_units);
    draft.curves.iter().map(|curve| band(draft, curve, &writer)).collect()
}

fn band(draft: &Draft, curve: &DraftCurve, writer: &NumberWriter) -> DraftBand {
    let share = writer.percent(curve.probabilities[1] - curve.probabilities[0], Rounding::Nearest);
    let mut chart = Chart::over_angle(name_of("draft", &curve.output), &draft.drive, &curve.pose_rad, writer);
    chart.set_vertical_axis(format!("{} of {}", deviation_words(curve.of), curve.output), &curve.unit, writer);
    chart.height = 240;
    let [lower, upper] = [&curve.band.lower_si, &curve.band.upper_si].map(|list| scaled(list, &curve.unit, writer));
    let runs = writer.count(draft.runs as u64);
    let label = format!("{share} of mechanisms, {runs} runs so far");
    // Its dashed edge says that it is none of the bounds that pages show.
    chart.entries.push(Entry::new(label, Role::Mixed, true, EntryValues::band(&lower, &upper)));
    let concerns = |outcome: &&RequirementOutcome| {
        outcome.output == curve.output && outcome.of == curve.of && outcome.at == ResponsePoint::Whole
    };
    for outcome in draft.requirements.iter().filter(concerns) {
        let words = limits_words(outcome.lower_si, outcome.upper_si, &curve.unit, writer);
        let [lower, upper] = [outcome.lower_si, outcome.upper_si]
            .map(|value_si| vec![writer.scaled(value_si, &curve.unit); curve.pose_rad.len()]);
        let label = format!("required: {words}");
        chart.entries.push(Entry::new(label, Role::Limit, true, EntryValues::pair(&lower, &upper)));
    }
    let title = capitalised(&deviation_of(&curve.output, curve.of, &[]));
    let tried = match curve.unknown_values {
        0 | 1 => String::new(),
        values => format!(", the widest of {values} values of the unknown inputs"),
    };
    let words =
        format!("{share} of mechanisms at each angle, from {runs} runs{tried}. No bound yet: it can still grow.");
    chart.alternative = format!("Chart of the band so far over one cycle. {title}. {words}");
    chart.caption = html! {};
    DraftBand { title, words, figure: chart.document() }
}

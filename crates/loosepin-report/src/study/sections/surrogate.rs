//! Bounds and errors of surrogates beside the direct bounds.

use maud::{Markup, html};

use super::surrogate_words::{output_sentences, runs_sentence, title};
use crate::charts::chart::{Chart, Entry, Role};
use crate::charts::figure::name_of;
use crate::charts::surrogate_figure::surrogate_figure;
use crate::medium::article_page::push_figure;
use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::Tag;
use crate::words::bound::bound_value;
use crate::words::wording::{
    band_digits, deviation_words, head, output_unit, output_words, response_words, share_words, statistic_words,
};
use loosepin_result::study::{
    BoundRecord, ResponsePoint, StudyResult, SurrogateAlong, SurrogateOutput, SurrogateRecord, TreatmentBand,
    TreatmentComparison,
};
use loosepin_text::article::{Cell, Column, Content, Group, Medium, Section, Table, Text};

/// Rows of a table; the others stand in `summary.json`.
const MAX_ROWS: usize = 24;

/// `None` if no surrogate was asked for.
pub(crate) fn surrogate_section(result: &StudyResult, writer: &NumberWriter) -> Option<Section> {
    let record = result.surrogate.as_ref()?;
    let mut section = Section::new("surrogate", title(record));
    let runs = Text::default()
        .on(Medium::Page, "These bounds come from a surrogate: a function fitted to runs. ")
        .plain(runs_sentence(record, writer))
        .on(
            Medium::Page,
            " Means and probabilities are corrected by the check runs. All bounds include the error of the surrogate.",
        );
    section.push(Content::sentences([runs]));
    section.push_close(Content::points(output_sentences(result, record, writer)));
    let single: Vec<&BoundRecord> =
        record.bounds.iter().filter(|bound| !matches!(bound.at, ResponsePoint::Curve { .. })).collect();
    let shown = &single[..single.len().min(MAX_ROWS)];
    section.push(Content::Table(bounds_table(result, shown, writer)));
    let (left_of_table, left_of_all) = (single.len() - shown.len(), record.bounds.len() - shown.len());
    if left_of_all > 0 {
        let more = Text::from(format!("{left_of_all} more of its bounds are in ")).code("summary.json").plain(".");
        section.push_on(Medium::Page, Content::Note(more));
    }
    if left_of_table > 0 {
        section.push_on(Medium::Terminal, Content::Note(format!("{left_of_table} more in summary.json").into()));
    }
    for comparison in &record.treatments {
        section.push(Content::Table(treatments_table(result, comparison, writer)));
    }
    push_figure(&mut section, writer, || html! { @for figure in figures(result, record, writer) { (figure) } });
    Some(section)
}

fn bounds_table(result: &StudyResult, shown: &[&BoundRecord], writer: &NumberWriter) -> Table {
    let columns = vec![
        Column::words(head("statistic")),
        Column::numbers(head("direct")),
        Column::numbers(head("by surrogate")),
        Column::numbers("± surrogate"),
    ];
    let row = |bound: &&BoundRecord| {
        let among = Tag::Group("surrogate".to_owned());
        vec![
            statistic_words(bound.statistic, &output_unit(result, &bound.output), writer).into(),
            direct_bound(result, bound).map(|direct| range_words(direct, writer)).into(),
            range_words(bound, &writer.with_tag(&among)).into(),
            surrogate_error(bound, writer).into(),
        ]
    };
    let groups = shown.chunk_by(|a, b| (&a.output, a.of, a.at) == (&b.output, b.of, b.at)).map(|group| Group {
        heading: response_words(result, (&group[0].output, group[0].of, group[0].at), writer).into(),
        rows: group.iter().map(row).collect(),
    });
    Table { columns, groups: groups.collect(), ..Table::default() }
}

/// The three treatments of a number, directly and by the surrogate.
fn treatments_table(result: &StudyResult, comparison: &TreatmentComparison, writer: &NumberWriter) -> Table {
    let is_same =
        |of: &&TreatmentComparison| (&of.output, of.of, of.at) == (&comparison.output, comparison.of, comparison.at);
    let direct = result.treatments.iter().find(is_same);
    let row = |band: &TreatmentBand| -> Vec<Cell> {
        let of_direct = direct.and_then(|of| Some((of.bands.iter().find(|own| own.treatment == band.treatment)?, of)));
        vec![
            band.treatment.name().into(),
            of_direct.map(|(band, of)| band_words(band, of, writer)).into(),
            band_words(band, comparison, writer).into(),
            band.surrogate_error_si().map_or(String::new(), |error| writer.error(error, &comparison.unit)).into(),
            share_words(band, comparison, writer).into(),
        ]
    };
    // A terminal has the ends of bands one below the other.
    let ends = |words: &str| Column { numbers_on: &[Medium::Page], ..Column::words(head(words)) };
    let columns = vec![
        Column::words(head("treatment")),
        ends("direct"),
        ends("by surrogate"),
        Column::numbers("± surrogate"),
        Column::words(head("share inside")),
    ];
    Table {
        title: response_words(result, (&comparison.output, comparison.of, comparison.at), writer).into(),
        ..Table::new(columns, comparison.bands.iter().map(row))
    }
}

/// What the surrogate of each output looks like.
fn figures(result: &StudyResult, record: &SurrogateRecord, writer: &NumberWriter) -> impl Iterator<Item = Markup> {
    record.outputs.iter().enumerate().flat_map(move |(index, output)| {
        let along = output.along.as_ref().map(|along| along_chart(result, output, along, index, writer));
        let picture = output.picture.as_ref().map(|picture| surrogate_figure(result, output, picture, index, writer));
        along.into_iter().chain(picture)
    })
}

/// The direct bound of the same statistic.
fn direct_bound<'r>(result: &'r StudyResult, bound: &BoundRecord) -> Option<&'r BoundRecord> {
    result.bounds.iter().find(|direct| {
        (&direct.output, direct.of, direct.at, direct.statistic, direct.treatment)
            == (&bound.output, bound.of, bound.at, bound.statistic, bound.treatment)
    })
}

/// "-0.55 mm to 0.55 mm".
fn range_words(bound: &BoundRecord, writer: &NumberWriter) -> String {
    format!(
        "{} to {}",
        bound_value(&bound.lower, bound, Rounding::Down, writer),
        bound_value(&bound.upper, bound, Rounding::Up, writer)
    )
}

/// The larger error of the surrogate at both ends.
fn surrogate_error(bound: &BoundRecord, writer: &NumberWriter) -> String {
    let error = bound.lower.error.surrogate_si.max(bound.upper.error.surrogate_si);
    if bound.statistic.is_probability() {
        writer.percent(error.min(1.0), Rounding::Up)
    } else {
        writer.error(error, &bound.unit)
    }
}

/// "-0.55 mm to 0.55 mm", with the digits that distinguish the bands of `comparison`.
fn band_words(band: &TreatmentBand, comparison: &TreatmentComparison, writer: &NumberWriter) -> String {
    let digits = band_digits(comparison);
    let rounded = |part: &str, value_si: f64, rounding| {
        writer.with_tag(&Tag::band(comparison, band, part)).rounded(value_si, &comparison.unit, digits, rounding)
    };
    format!("{} to {}", rounded("lower", band.lower_si, Rounding::Down), rounded("upper", band.upper_si, Rounding::Up))
}

/// The held-out error over the cycle.
fn along_chart(
    result: &StudyResult,
    output: &SurrogateOutput,
    along: &SurrogateAlong,
    index: usize,
    writer: &NumberWriter,
) -> Markup {
    let name = output_words(&output.output, &result.outputs);
    Chart {
        y_label: format!("held-out error of {}", output.output),
        y_symbol: writer.symbol(&output.unit),
        entries: vec![Entry::line("held-out error", Role::Worst, false, &along.held_out_si, &output.unit, writer)],
        height: 220,
        caption: html! {
            strong { (name) ", " (deviation_words(output.of)) ": error of the surrogate at runs that were not used for training." }
            " Root mean square at each angle."
        },
        alternative: format!("Held-out error of the surrogate of {name} over the cycle."),
        ..Chart::over_angle(name_of("held-out", &format!("{} {}", output.output, index + 1)), &result.cycle.drive, &along.pose_rad, writer)
    }
    .figure()
}

//! The three treatments side by side: band, share inside, whether that is the share that it claims.

use maud::html;

use crate::charts::still_figures::percent_of;
use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::Tag;
use crate::study::sections::treatment_sentences::treatment_sentences;
use crate::words::wording::{
    EQUALLY_PROBABLE, UNKNOWN_INPUTS, band_digits, band_error, deviation_words, has_errors, has_lists, head,
    holds_words, place_words, response_words, share_words,
};
use loosepin_result::study::{StudyResult, TreatmentBand, TreatmentComparison};
use loosepin_text::article::{Cell, Column, Content, Medium, Section, Table, Text};

/// `None` if treatments were not compared.
pub(crate) fn treatments_section(result: &StudyResult, writer: &NumberWriter) -> Option<Section> {
    const TITLE: &str = "Three treatments of the unknown inputs";
    if result.treatments.is_empty() {
        return None;
    }
    let mut section = Section::new("treatments", Text::by_medium(TITLE, ""));
    let counted = if is_learned(result) {
        "tested, with the surrogate. The shares include the error of the surrogate."
    } else {
        "tested, in the runs of the mixed treatment."
    };
    let of_lists = has_lists(&result.inputs).then_some(EQUALLY_PROBABLE);
    let what = format!(
        "Three treatments of the same inputs. Each gives a band that is intended to contain the stated share of mechanisms. The share \
         inside depends on the unknown values. It was counted at all unknown values {counted}{}",
        of_lists.map_or(String::new(), |words| format!(" {words}"))
    );
    section.push_on(Medium::Page, Content::sentences([what]));
    for comparison in &result.treatments {
        let place = place_words(comparison.at, writer);
        let heading = format!("{TITLE}: {} {}, {place}", comparison.output, deviation_words(comparison.of));
        section.push_on(Medium::Terminal, Content::Heading(heading.into()));
        section.push(Content::Table(table(result, comparison, writer)));
        let bands = comparison.bands.iter().zip(treatment_sentences(result, comparison, writer));
        let words = bands.map(|(band, sentence)| {
            let name = Text::default().strong(format!("{}. ", band.treatment.name()));
            Text::default().on(Medium::Page, name).plain(sentence)
        });
        let of_lists = of_lists.map(|words| Text::by_medium("", words));
        section.push_close(Content::points(words.chain(of_lists)));
    }
    Some(section)
}

/// Whether the bands are those of a surrogate that stands alone.
fn is_learned(result: &StudyResult) -> bool {
    result.treatments.iter().flat_map(|comparison| &comparison.bands).any(|band| band.is_by_surrogate)
}

fn table(result: &StudyResult, comparison: &TreatmentComparison, writer: &NumberWriter) -> Table {
    let band_ends = || {
        let ends = comparison.bands.iter().flat_map(|band| [band.lower_si, band.upper_si]);
        ends.filter(|end_si| end_si.is_finite())
    };
    let (from, to) = padded(band_ends().fold(f64::INFINITY, f64::min), band_ends().fold(f64::NEG_INFINITY, f64::max));
    let promised = comparison.promised_coverage;
    let least = comparison.bands.iter().map(TreatmentBand::least_share).fold(promised, f64::min);
    let share_from = ((least - 0.5 * (1.0 - least)).max(0.0) * 20.0).floor() / 20.0;
    let promise = writer.with_tag(&Tag::Given("promised share")).percent(promised, Rounding::Nearest);
    // Records of older versions do not hold the errors of bands of direct runs.
    let has_errors = has_errors(comparison);
    let error = has_errors.then(|| Column::numbers("± error"));
    let columns = [
        Column::words(head("treatment")),
        Column {
            label: Some("Band"),
            ..Column::words(Text::by_medium(format!("Band for {promise} of mechanisms"), "band"))
        },
    ];
    let further = [Column::words(head("share inside")), Column::words(head(&format!("holds {promise}?")))];
    let row = |band: &TreatmentBand| {
        let error: Option<Cell> = has_errors.then(|| band_error(band, comparison, writer).into());
        let cells = [band.treatment.name().into(), band_bar(band, comparison, from, to, writer)];
        let further = [coverage_strip(band, comparison, share_from, writer), holds_cell(band, comparison, writer)];
        cells.into_iter().chain(error).chain(further).collect()
    };
    let given = Tag::Given("axis");
    let axis = writer.with_tag(&given);
    let caption = format!(
        "Bars: the bands on a common scale. Dots: the share inside at each tested value of the {}, from {} to {}. Vertical line: \
         {promise}.",
        UNKNOWN_INPUTS,
        axis.percent(share_from, Rounding::Nearest),
        axis.percent(1.0, Rounding::Nearest)
    );
    Table {
        title: Text::by_medium(response_words(result, (&comparison.output, comparison.of, comparison.at), writer), ""),
        caption: caption.into(),
        ..Table::new(columns.into_iter().chain(error).chain(further).collect(), comparison.bands.iter().map(row))
    }
}

/// Whether a band holds what it claims, on a page in the colour of a verdict.
fn holds_cell(band: &TreatmentBand, comparison: &TreatmentComparison, writer: &NumberWriter) -> Cell {
    let promised = comparison.promised_coverage;
    let words = holds_words(band, comparison, writer);
    let class = if band.is_promise_unknown(promised) {
        "verdict undecided"
    } else if band.keeps_promise(promised) {
        "verdict met"
    } else {
        "verdict not-met"
    };
    Cell::Drawn { html: html! { span class=(class) { (words) } }.into_string(), text: words }
}

fn padded(from: f64, to: f64) -> (f64, f64) {
    let margin = 0.04 * (to - from);
    (from - margin, to + margin)
}

fn band_bar(band: &TreatmentBand, comparison: &TreatmentComparison, from: f64, to: f64, writer: &NumberWriter) -> Cell {
    let rounded = |part: &str, value_si: f64, rounding| {
        let digits = band_digits(comparison);
        writer.with_tag(&Tag::band(comparison, band, part)).rounded(value_si, &comparison.unit, digits, rounding)
    };
    let lower = rounded("lower", band.lower_si, Rounding::Down);
    let upper = rounded("upper", band.upper_si, Rounding::Up);
    // A band without an end goes to the edge.
    let drawn = [band.lower_si.max(from), band.upper_si.min(to)];
    let width = percent_of(drawn[1] - drawn[0], 0.0, to - from);
    let text = format!("{lower} to {upper}");
    let html = html! {
        svg.bar width="100%" height="20" role="img" aria-label=(format!("Band from {lower} to {upper}")) {
            line.axis x1="0%" x2="100%" y1="10" y2="10" {}
            @if from < 0.0 && to > 0.0 {
                @let zero = percent_of(0.0, from, to);
                line.zero x1=(zero) x2=(zero) y1="0" y2="20" {}
            }
            rect class=(band.treatment.colour()) x=(percent_of(drawn[0], from, to)) y="4" width=(width) height="12"
                rx="2" {}
        }
        span.range { (text) }
    };
    Cell::Drawn { html: html.into_string(), text }
}

fn coverage_strip(
    band: &TreatmentBand,
    comparison: &TreatmentComparison,
    share_from: f64,
    writer: &NumberWriter,
) -> Cell {
    let text = share_words(band, comparison, writer);
    let promised = comparison.promised_coverage;
    let place = |share: f64| percent_of(share, share_from - 0.02 * (1.0 - share_from), 1.0 + 0.02 * (1.0 - share_from));
    let html = html! {
        svg.strip width="100%" height="20" role="img" aria-label=(format!("Share inside: {text}")) {
            line.axis x1="0%" x2="100%" y1="10" y2="10" {}
            line.range x1=(place(band.least_share())) x2=(place(band.coverage_maximum)) y1="10" y2="10" {}
            @for point in &band.coverage_at { circle cx=(place(point.coverage)) cy="10" r="2.5" {} }
            line.promise x1=(place(promised)) x2=(place(promised)) y1="1" y2="19" {}
        }
        span.range { (text) }
    };
    Cell::Drawn { html: html.into_string(), text }
}

//! Bounds and errors of surrogates beside the direct bounds.

use maud::{Markup, html};

use crate::chart::{Chart, Entry, Role};
use crate::figure::name_of;
use crate::number::NumberWriter;
use crate::page::cards;
use crate::surrogate_figure::surrogate_figure;
use crate::surrogate_text::{
    MOST_ROWS, direct_bound, output_sentences, range_words, runs_sentence, single_bounds, surrogate_error,
    treatment_rows,
};
use crate::tag::Tag;
use crate::wording::output_unit;
use crate::wording::{deviation_words, output_words, response_words, statistic_words};
use loosepin_result::study::{
    BoundRecord, StudyResult, SurrogateAlong, SurrogateOutput, SurrogateRecord, TreatmentComparison,
};

pub(super) fn surrogate(result: &StudyResult, record: &SurrogateRecord, writer: &NumberWriter) -> Markup {
    let shown = single_bounds(record);
    let others = record.bounds.len() - shown.len().min(MOST_ROWS);
    html! {
        p {
            "These bounds come from a surrogate: a function fitted to runs. "
            (runs_sentence(record, writer))
            " Means and probabilities are corrected by the check runs. All bounds include the error of the surrogate."
        }
        ul { @for sentence in output_sentences(result, record, writer) { li { (sentence) } } }
        @if !shown.is_empty() { (bounds(result, &shown[..shown.len().min(MOST_ROWS)], writer)) }
        @if others > 0 {
            p.quiet { (others) " more of its bounds are in " code { "summary.json" } "." }
        }
        @for comparison in &record.treatments { (treatments(result, comparison, writer)) }
        @for (index, output) in record.outputs.iter().enumerate() {
            @if let Some(along) = &output.along { (along_chart(result, output, along, index, writer)) }
            @if let Some(picture) = &output.picture { (surrogate_figure(result, output, picture, index, writer)) }
        }
    }
}

fn bounds(result: &StudyResult, shown: &[&BoundRecord], writer: &NumberWriter) -> Markup {
    html! {
        table.cards {
            thead {
                tr {
                    th scope="col" { "Statistic" }
                    th.number scope="col" { "Direct" }
                    th.number scope="col" { "By surrogate" }
                    th.number scope="col" { "± surrogate" }
                }
            }
            @for group in shown.chunk_by(|a, b| a.output == b.output && a.of == b.of && a.at == b.at) {
                tbody.group {
                    tr {
                        th scope="rowgroup" colspan="4" {
                            (response_words(result, (&group[0].output, group[0].of, group[0].at), writer))
                        }
                    }
                    @for bound in group {
                        tr {
                            td data-label="Statistic" {
                                (statistic_words(bound.statistic, &output_unit(result, &bound.output), writer))
                            }
                            td.number data-label="Direct" {
                                (direct_bound(result, bound).map_or("–".to_owned(), |direct| range_words(direct, writer)))
                            }
                            td.number data-label="By surrogate" { (range_words(bound, &writer.about(&Tag::Among("surrogate".to_owned())))) }
                            td.number data-label="± surrogate" { (surrogate_error(bound, writer)) }
                        }
                    }
                }
            }
        }
    }
}

/// The three treatments of a number, directly and by the surrogate.
fn treatments(result: &StudyResult, comparison: &TreatmentComparison, writer: &NumberWriter) -> Markup {
    let rows = treatment_rows(result, comparison, writer).into_iter();
    html! {
        h3 { (response_words(result, (&comparison.output, comparison.of, comparison.at), writer)) }
        (cards(
            ["Treatment", "#Direct", "#By surrogate", "#± surrogate", "Share inside"],
            rows.map(|row| row.map(|text| html! { (text) })),
        ))
    }
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

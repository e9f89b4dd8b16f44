//! The key table: every bound that is not a point of a curve.

use maud::{Markup, html};

use crate::bound_words::{bound_error, bound_value, error_parts};
use crate::number::{NumberWriter, Rounding};
use crate::tag::Tag;
use crate::wording::output_unit;
use crate::wording::{
    MASSES_ADD, further, guarantee_words, has_parts, has_unknown, only_curves, reading_beside, response_words,
    statistic_words, unknown_words,
};
use loosepin_result::study::{BoundEnd, BoundRecord, ResponsePoint, StudyResult, Treatment};

/// More rows are left to `bounds.csv`.
const MOST_ROWS: usize = 60;

pub(super) fn bounds_table(result: &StudyResult, writer: &NumberWriter) -> Markup {
    let shown =
        |bound: &&BoundRecord| bound.treatment == Treatment::Mixed && !matches!(bound.at, ResponsePoint::Curve { .. });
    let rows: Vec<&BoundRecord> = result.bounds.iter().filter(shown).take(MOST_ROWS).collect();
    let others = result.bounds.len() - rows.len();
    if rows.is_empty() {
        return html! { @if let Some(words) = only_curves(others, writer) { p { (words) } } };
    }
    html! {
        p {
            "Each statistic lies between its two bounds"
            @if has_unknown(&result.inputs) { " for all values of the " (unknown_words(&result.inputs)) }
            ". The bounds include their numerical error and are rounded outwards."
        }
        @if has_parts(&result.inputs) {
            p { (MASSES_ADD) }
        }
        table.cards {
            thead {
                tr {
                    th scope="col" { "Statistic" }
                    th.number scope="col" { "Lower bound, attained at" }
                    th.number scope="col" { "Upper bound, attained at" }
                    th.number scope="col" { "± numerical error" }
                    th scope="col" { "Guarantee" }
                }
            }
            @for group in rows.chunk_by(|a, b| a.output == b.output && a.of == b.of && a.at == b.at && a.reading == b.reading) {
                tbody.group {
                    tr {
                        th scope="rowgroup" colspan="5" {
                            (response_words(result, (&group[0].output, group[0].of, group[0].at), writer))
                            (reading_beside(result, group[0]))
                        }
                    }
                    @for bound in group { (row(bound, result, writer)) }
                }
            }
        }
        @if others > 0 {
            p.quiet {
                (further(others, "bound", "(points of curves, other treatments) ", writer)) code { "bounds.csv" } "."
            }
        }
    }
}

fn row(bound: &BoundRecord, result: &StudyResult, writer: &NumberWriter) -> Markup {
    let output_unit = output_unit(result, &bound.output);
    let witness =
        |part: &str, end: &BoundEnd| writer.about(&Tag::bound(bound, part)).witness(&end.witness, &result.inputs);
    html! {
        tr {
            td data-label="Statistic" { (statistic_words(bound.statistic, &output_unit, writer)) }
            td.number data-label="Lower bound" {
                (bound_value(&bound.lower, bound, Rounding::Down, writer)) " "
                span.quiet { (witness("lower witness", &bound.lower)) }
            }
            td.number data-label="Upper bound" {
                strong { (bound_value(&bound.upper, bound, Rounding::Up, writer)) } " "
                span.quiet { (witness("upper witness", &bound.upper)) }
            }
            td.number data-label="± numerical error" {
                (bound_error(bound, writer)) " "
                span.quiet { (error_parts(bound, writer)) }
            }
            td data-label="Guarantee" { span.quiet { (guarantee_words(bound.guarantee, writer)) } }
        }
    }
}

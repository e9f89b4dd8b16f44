//! The key table: every bound that is not a point of a curve.

use maud::{Markup, html};

use crate::report::number::{NumberWriter, Rounding};
use crate::report::wording::{
    deviation_words, guarantee_words, output_words, place_words, statistic_words, treatment_words,
};
use crate::study::result::{BoundEnd, BoundRecord, ResponsePoint, StudyResult, TreatmentKind};
use crate::units::SiUnit;

/// More rows are left to `bounds.csv`.
const MOST_ROWS: usize = 60;

pub(super) fn bounds_table(result: &StudyResult, writer: &NumberWriter) -> Markup {
    let shown = |bound: &&BoundRecord| {
        bound.treatment == TreatmentKind::Mixed && !matches!(bound.at, ResponsePoint::Curve { .. })
    };
    let total = result.bounds.iter().filter(shown).count();
    let others = result.bounds.len() - total.min(MOST_ROWS);
    html! {
        p {
            "Each statistic lies between its two bounds, wherever in their ranges the interval inputs are. The bounds are \
             rounded and widened outwards by their numerical error, which stands beside them."
        }
        table.cards {
            thead {
                tr {
                    th scope="col" { "Of what" }
                    th scope="col" { "Statistic" }
                    th.number scope="col" { "Lower bound" }
                    th.number scope="col" { "Upper bound" }
                    th.number scope="col" { "± numerical error" }
                    th scope="col" { "Upper bound attained at" }
                }
            }
            tbody {
                @for bound in result.bounds.iter().filter(shown).take(MOST_ROWS) {
                    (row(bound, result, writer))
                }
            }
        }
        @if others > 0 {
            p.quiet {
                "A further " (others) " bounds (points of the curves, other treatments) stand in " code { "bounds.csv" } "."
            }
        }
    }
}

fn row(bound: &BoundRecord, result: &StudyResult, writer: &NumberWriter) -> Markup {
    let output_unit = result
        .outputs
        .iter()
        .find(|output| output.name == bound.output)
        .map_or(SiUnit::NONE, |output| output.unit.clone());
    html! {
        tr {
            th scope="row" {
                (output_words(&bound.output, &result.outputs)) br;
                span.quiet { (deviation_words(bound.of)) ", " (place_words(bound.at, writer)) }
            }
            td data-label="Statistic" { (statistic_words(bound.statistic, &output_unit, writer)) }
            td.number data-label="Lower bound" { (end_value(&bound.lower, bound, Rounding::Down, writer)) }
            td.number data-label="Upper bound" { strong { (end_value(&bound.upper, bound, Rounding::Up, writer)) } }
            td.number data-label="± numerical error" { (error(bound, writer)) }
            td data-label="Upper bound attained at" {
                @if bound.upper.witness.is_empty() { "–" }
                @else { (writer.witness(&bound.upper.witness, &result.inputs)) }
                details.more {
                    summary { "more" }
                    dl {
                        dt { "Lower bound attained at" }
                        dd { (writer.witness(&bound.lower.witness, &result.inputs)) }
                        dt { "Before widening" }
                        dd {
                            (plain(bound.lower.value_si, bound, writer)) " to " (plain(bound.upper.value_si, bound, writer))
                        }
                        dt { "Error of the upper bound: sampling, search, surrogate" }
                        dd {
                            (part(bound.upper.error.sampling_si, bound, writer)) ", "
                            (part(bound.upper.error.optimisation_si, bound, writer)) ", "
                            (part(bound.upper.error.surrogate_si, bound, writer))
                        }
                        dt { "Kind of guarantee" }
                        dd { (guarantee_words(bound.guarantee, writer)) }
                        dt { "Treatment" }
                        dd { (treatment_words(bound.treatment)) }
                    }
                }
            }
        }
    }
}

/// The widened end, rounded outwards.
pub(in crate::report) fn end_value(
    end: &BoundEnd,
    bound: &BoundRecord,
    rounding: Rounding,
    writer: &NumberWriter,
) -> String {
    if bound.statistic.is_probability() {
        writer.percent(end.widened_si, rounding)
    } else {
        writer.to_error(end.widened_si, end.error.total_si(), &bound.unit, rounding)
    }
}

/// The larger error of both ends.
pub(in crate::report) fn error(bound: &BoundRecord, writer: &NumberWriter) -> String {
    part(bound.lower.error.total_si().max(bound.upper.error.total_si()), bound, writer)
}

fn part(error_si: f64, bound: &BoundRecord, writer: &NumberWriter) -> String {
    if bound.statistic.is_probability() {
        writer.percent(error_si, Rounding::Up)
    } else {
        writer.error(error_si, &bound.unit)
    }
}

fn plain(value_si: f64, bound: &BoundRecord, writer: &NumberWriter) -> String {
    if bound.statistic.is_probability() {
        writer.percent(value_si, Rounding::Nearest)
    } else {
        writer.value(value_si, &bound.unit)
    }
}

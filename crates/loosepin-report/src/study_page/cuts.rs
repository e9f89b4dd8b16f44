//! Bounds in columns: by degree of possibility, where an input is a fuzzy number; by percentile, where a statistic is itself random.

use maud::{Markup, html};

use crate::bound_words::bound_value;
use crate::number::{NumberWriter, Rounding};
use crate::percentile_words::{PERCENTILES_MEAN, percentile_words};
use crate::tag::{Tag, among_cut, among_percentile};
use crate::wording::output_unit;
use crate::wording::{deviation_words, further, output_words, place_words, statistic_words};
use loosepin_result::study::{BoundRecord, ResponsePoint, StudyResult};
use loosepin_text::units::SiUnit;

/// More statistics are left to `bounds.csv`.
const MOST_STATISTICS: usize = 20;

/// Of a study with fuzzy numbers.
pub(super) fn cuts(result: &StudyResult, writer: &NumberWriter) -> Markup {
    let degree = |alpha: f64| writer.about(&Tag::Given("degree")).shortest(alpha, &SiUnit::NONE);
    let columns = result.cuts.iter();
    let columns = columns.map(|cut| (format!("Degree {}", degree(cut.alpha)), among_cut(cut.alpha), &cut.bounds[..]));
    let columns: Vec<Column<'_>> = columns.collect();
    html! {
        p {
            "A fuzzy number gives each value a degree of possibility. At each degree every statistic lies between its two bounds. A \
             higher degree allows fewer values, so its bounds are closer."
        }
        (in_columns(&columns, result, writer))
    }
}

/// Of a study whose parameters have distributions.
pub(super) fn percentiles(result: &StudyResult, writer: &NumberWriter) -> Markup {
    let columns = result.percentiles.iter();
    let columns = columns
        .map(|each| (percentile_words(each.percentile, writer), among_percentile(each.percentile), &each.bounds[..]));
    let columns: Vec<Column<'_>> = columns.collect();
    html! {
        p { (PERCENTILES_MEAN) }
        (in_columns(&columns, result, writer))
    }
}

/// The head of a column, what its bounds are among, and its bounds.
type Column<'r> = (String, Tag, &'r [BoundRecord]);

fn in_columns(columns: &[Column<'_>], result: &StudyResult, writer: &NumberWriter) -> Markup {
    let Some((_, _, first)) = columns.first() else { return html! {} };
    let is_single = |(_, bound): &(usize, &BoundRecord)| !matches!(bound.at, ResponsePoint::Curve { .. });
    let rows: Vec<(usize, &BoundRecord)> = first.iter().enumerate().filter(is_single).collect();
    let others = rows.len().saturating_sub(MOST_STATISTICS);
    html! {
        table.cards {
            thead {
                tr {
                    th scope="col" { "Statistic" }
                    @for (title, _, _) in columns { th.number scope="col" { (title) } }
                }
            }
            tbody {
                @for (index, bound) in rows.iter().take(MOST_STATISTICS) {
                    tr {
                        td data-label="Statistic" {
                            (output_words(&bound.output, &result.outputs)) ", " (deviation_words(bound.of)) ", "
                            (place_words(bound.at, writer)) ": "
                            (statistic_words(bound.statistic, &output_unit(result, &bound.output), writer))
                        }
                        @for (title, among, bounds) in columns {
                            td.number data-label=(title) {
                                @if let Some(bound) = bounds.get(*index) {
                                    (bound_value(&bound.lower, bound, Rounding::Down, &writer.about(among))) " to "
                                    (bound_value(&bound.upper, bound, Rounding::Up, &writer.about(among)))
                                } @else { "–" }
                            }
                        }
                    }
                }
            }
        }
        @if others > 0 {
            p.quiet { (further(others, "statistic", "", writer)) code { "bounds.csv" } "." }
        }
    }
}

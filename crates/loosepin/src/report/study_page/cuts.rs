//! Bounds by degree of possibility, where an input is a fuzzy number.

use maud::{Markup, html};

use crate::report::answer::output_unit;
use crate::report::number::{NumberWriter, Rounding};
use crate::report::study_page::bounds_table::end_value;
use crate::report::wording::{deviation_words, output_words, place_words, statistic_words};
use crate::study::result::{BoundRecord, ResponsePoint, StudyResult};

/// More statistics are left to `bounds.csv`.
const MOST_STATISTICS: usize = 20;

pub(super) fn cuts(result: &StudyResult, writer: &NumberWriter) -> Markup {
    let Some(first) = result.cuts.first() else { return html! {} };
    let is_single = |(_, bound): &(usize, &BoundRecord)| !matches!(bound.at, ResponsePoint::Curve { .. });
    let rows: Vec<(usize, &BoundRecord)> = first.bounds.iter().enumerate().filter(is_single).collect();
    let others = rows.len().saturating_sub(MOST_STATISTICS);
    html! {
        p {
            "A fuzzy number says which values are possible to which degree. At each degree every statistic lies between its two \
             bounds; the higher the degree, the less is possible and the closer they are."
        }
        table.cards {
            thead {
                tr {
                    th scope="col" { "Statistic" }
                    @for cut in &result.cuts { th.number scope="col" { "Degree " (cut.alpha) } }
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
                        @for cut in &result.cuts {
                            @let bound = &cut.bounds[*index];
                            td.number data-label=(format!("Degree {}", cut.alpha)) {
                                (end_value(&bound.lower, bound, Rounding::Down, writer)) " to "
                                (end_value(&bound.upper, bound, Rounding::Up, writer))
                            }
                        }
                    }
                }
            }
        }
        @if others > 0 {
            p.quiet { "A further " (others) " statistics stand in " code { "bounds.csv" } "." }
        }
    }
}

//! Bounds in columns: by degree of possibility, where an input is a fuzzy number; by percentile, where a statistic is itself random.

use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::{Tag, degree_group, percentile_group};
use crate::words::bound::bound_value;
use crate::words::wording::{deviation_words, further, head, output_unit, output_words, place_words, statistic_words};
use loosepin_result::study::{BoundRecord, ResponsePoint, StudyResult};
use loosepin_text::article::{Cell, Column, Content, Medium, Section, Table, Text};
use loosepin_text::units::SiUnit;

/// More statistics are left to `bounds.csv`.
const MAX_STATISTICS: usize = 20;

/// For the page alone; `None` if no input is a fuzzy number.
pub(crate) fn degrees_section(result: &StudyResult, writer: &NumberWriter) -> Option<Section> {
    const DEGREES_MEAN: &str = "A fuzzy number gives each value a degree of possibility. At each degree every statistic lies between its two \
         bounds. A higher degree allows fewer values, so its bounds are closer.";
    let degree = |alpha: f64| writer.with_tag(&Tag::Given("degree")).shortest(alpha, &SiUnit::NONE);
    let of_cut = result
        .cuts
        .iter()
        .map(|cut| (format!("Degree {}", degree(cut.alpha)), degree_group(cut.alpha), &cut.bounds[..]));
    section("degrees", "Bounds by degree of possibility", DEGREES_MEAN, of_cut.collect(), result, writer)
}

/// `None` if no parameter has a distribution.
pub(crate) fn percentiles_section(result: &StudyResult, writer: &NumberWriter) -> Option<Section> {
    const PERCENTILES_MEAN: &str = "The parameters of some distributions have distributions themselves, so each statistic is random. It stays below a \
         percentile with the probability of that percentile. If other inputs are unknown, each percentile has two bounds. Numerical errors are \
         included. All other numbers on this page hold for all values of such a parameter in its range.";
    let percent = |share: f64| writer.with_tag(&Tag::Given("percentile")).percent(share, Rounding::Nearest);
    let of_percentile = result.percentiles.iter().map(|each| {
        (format!("{} percentile", percent(each.percentile)), percentile_group(each.percentile), &each.bounds[..])
    });
    section("percentiles", "Percentiles of the statistics", PERCENTILES_MEAN, of_percentile.collect(), result, writer)
}

/// The head of a column, what its bounds are among, and its bounds.
type Bounds<'r> = (String, Tag, &'r [BoundRecord]);

fn section(
    id: &'static str,
    heading: &str,
    meaning: &str,
    columns: Vec<Bounds<'_>>,
    result: &StudyResult,
    writer: &NumberWriter,
) -> Option<Section> {
    let (_, _, first) = columns.first()?;
    let is_single = |(_, bound): &(usize, &BoundRecord)| !matches!(bound.at, ResponsePoint::Curve { .. });
    let rows: Vec<(usize, &BoundRecord)> = first.iter().enumerate().filter(is_single).collect();
    let row = |(place, bound): &(usize, &BoundRecord)| {
        let statistic = format!(
            "{}, {}, {}: {}",
            output_words(&bound.output, &result.outputs),
            deviation_words(bound.of),
            place_words(bound.at, writer),
            statistic_words(bound.statistic, &output_unit(result, &bound.output), writer)
        );
        let between = |(_, among, bounds): &Bounds<'_>| -> Cell {
            let of_column = writer.with_tag(among);
            let ends = bounds.get(*place).map(|bound| {
                let lower = bound_value(&bound.lower, bound, Rounding::Down, &of_column);
                format!("{lower} to {}", bound_value(&bound.upper, bound, Rounding::Up, &of_column))
            });
            ends.into()
        };
        std::iter::once(statistic.into()).chain(columns.iter().map(between)).collect()
    };
    let heads = columns.iter().map(|(title, ..)| Column::numbers(title.as_str()));
    let heads = std::iter::once(Column::words(head("statistic"))).chain(heads).collect();
    let table = Table::new::<Cell>(heads, rows.iter().take(MAX_STATISTICS).map(row));
    let mut section = Section::new(id, heading);
    section.push_on(Medium::Page, Content::sentences([meaning]));
    section.push(Content::Table(table));
    let others = rows.len().saturating_sub(MAX_STATISTICS);
    if others > 0 {
        let more = further(others, "statistic", "", &Tag::whole("statistics without a row", id), writer);
        section.push(Content::Note(Text::from(more).code("bounds.csv").plain(".")));
    }
    Some(section)
}

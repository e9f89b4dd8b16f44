//! The key table: every bound that is not a point of a curve.

use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::{Tag, same_wording};
use crate::study::output_summary::{OutputSummary, output_summaries};
use crate::study::place_sentence::asked_of_same;
use crate::words::bound::{NO_ERROR, bound_error, bound_value, error_parts, has_no_end};
use crate::words::failed::{finished_words, why_no_end};
use crate::words::wording::{
    MASSES_ADD, UNKNOWN_INPUTS, count, further, guarantee_words, has_parts, has_unknown, only_curves, output_unit,
    reading_beside, response_words, statistic_words,
};
use loosepin_result::study::{BoundEnd, BoundRecord, ResponsePoint, StudyResult};
use loosepin_text::article::{Cell, Column, Content, Group, Medium, Section, Table, Text};

/// More rows are left to `bounds.csv`.
fn most_rows(medium: Medium) -> usize {
    match medium {
        Medium::Page => 60,
        Medium::Terminal => 24,
    }
}

/// Rows of an excerpt, at most.
const EXCERPT_ROWS: usize = 8;

/// " for all values of the unknown inputs", where there are any.
fn over_words(result: &StudyResult) -> String {
    if has_unknown(&result.inputs) { format!(" for all values of the {UNKNOWN_INPUTS}") } else { String::new() }
}

fn terminal_heading(result: &StudyResult) -> String {
    format!("Bounds{}, numerical error included", over_words(result))
}

/// `None` if no bound was asked for.
pub(crate) fn bounds_section(result: &StudyResult, writer: &NumberWriter) -> Option<Section> {
    if result.bounds.is_empty() {
        return None;
    }
    let single = single_bounds(result);
    if single.is_empty() {
        let mut section = Section::headed_on_page("bounds", "Bounds");
        section.push(Content::sentences(only_curves(result.bounds.len(), writer)));
        return Some(section);
    }
    let over = over_words(result);
    let heading = Text::by_medium("Bounds", terminal_heading(result));
    let mut section = Section::new("bounds", heading);
    let what = format!(
        "Each statistic lies between its two bounds{over}. The bounds include their error and are rounded outwards."
    );
    let of_parts = has_parts(&result.inputs).then(|| MASSES_ADD.to_owned());
    section.push_on(Medium::Page, Content::sentences([what].into_iter().chain(of_parts)));
    let shown = &single[..single.len().min(most_rows(writer.medium))];
    section.push(Content::Table(table(result, shown, true, writer)));
    let (left_of_table, left_of_all) = (single.len() - shown.len(), result.bounds.len() - shown.len());
    if left_of_all > 0 {
        let tag = Tag::Count("bounds that are not shown");
        let more = further(left_of_all, "bound", "(points of curves, other treatments) ", &tag, writer);
        section.push_on(Medium::Page, Content::Note(Text::from(more).code("bounds.csv").plain(".")));
    }
    if left_of_table > 0 {
        let more = count(left_of_table as u64, &writer.with_tag(&Tag::Count("bounds that the terminal leaves out")));
        section.push_on(Medium::Terminal, Content::Note(format!("{more} more in bounds.csv").into()));
    }
    Some(section)
}

/// The bound that the first answer is of, or else the first of the key table; `None` if it has none.
pub(super) fn answer_bound(result: &StudyResult) -> Option<&BoundRecord> {
    let single = single_bounds(result);
    let answers = output_summaries(result);
    let is_answer = |bound: &&&BoundRecord| match answers.first() {
        Some(OutputSummary::Largest(first, _) | OutputSummary::Bound(first)) => std::ptr::eq(*first, **bound),
        Some(OutputSummary::Curve(curve)) => (&bound.output, bound.of) == (&curve.output, curve.of),
        None => false,
    };
    single.iter().find(is_answer).or(single.first()).copied()
}

/// The bounds of the number of a run that the first answer is of, or else the first of the key table, for a terminal; `None` if it has none. Where
/// they are attained is left out, unless a bound has no end: then its reason stands there.
pub(crate) fn bounds_excerpt(result: &StudyResult, writer: &NumberWriter) -> Option<Section> {
    let first = answer_bound(result)?;
    let all = asked_of_same(result, first);
    let own = &all[..all.len().min(EXCERPT_ROWS)];
    let mut table = table(result, own, own.iter().any(|bound| has_no_end(bound)), writer);
    // The heading of the only group stands close to that of the section.
    let subjects: Vec<Text> = table.groups.iter_mut().map(|group| std::mem::take(&mut group.heading)).collect();
    let mut section = Section::new("bounds", terminal_heading(result));
    section.push_close(Content::Sentences(subjects));
    section.push_close(Content::Table(table));
    if all.len() > own.len() {
        let more = count(
            (all.len() - own.len()) as u64,
            &writer.with_tag(&Tag::Count("bounds that the first screen leaves out")),
        );
        section.push_close(Content::Note(format!("{more} more with --all").into()));
    }
    Some(section)
}

/// Where the bounds of the key table are attained, for a page; `None` if it has none.
pub(crate) fn places_section(result: &StudyResult, writer: &NumberWriter) -> Option<Section> {
    let single = single_bounds(result);
    let mut section = Section::new("bounds-attained", "Where the bounds are attained");
    section.push(Content::Table(places(result, &single[..single.len().min(most_rows(writer.medium))], writer)));
    (!single.is_empty()).then_some(section)
}

/// The bounds of the mixed treatment that are not points of curves.
fn single_bounds(result: &StudyResult) -> Vec<&BoundRecord> {
    let is_single =
        |bound: &&BoundRecord| bound.treatment.is_mixed() && !matches!(bound.at, ResponsePoint::Curve { .. });
    result.bounds.iter().filter(is_single).collect()
}

/// The key table; of an excerpt, which is for a terminal, without the places where upper bounds are attained.
fn table(result: &StudyResult, shown: &[&BoundRecord], has_places: bool, writer: &NumberWriter) -> Table {
    let columns = vec![
        Column::words(Text::by_medium("Statistic", "statistic")),
        Column { only: Some(Medium::Page), ..Column::numbers("Bounds") },
        Column { only: Some(Medium::Terminal), ..Column::numbers("lower") },
        Column { only: Some(Medium::Terminal), ..Column::numbers("upper") },
        Column::numbers("± error"),
        Column {
            only: Some(if has_places { Medium::Terminal } else { Medium::Page }),
            ..Column::words("upper attained at")
        },
    ];
    let groups = groups(result, shown, writer, &|bound| row(bound, result, writer));
    Table { columns, groups, ..Table::default() }
}

/// Where the bounds are attained, the parts of their errors, and their guarantees.
fn places(result: &StudyResult, shown: &[&BoundRecord], writer: &NumberWriter) -> Table {
    let columns =
        ["Statistic", "Lower bound at", "Upper bound at", "Error from", "Guarantee"].map(Column::words).into();
    let row = |bound: &BoundRecord| -> Vec<Cell> {
        // What is attained is a number of the finished runs.
        let witness = |part: &str, end: &BoundEnd| match end.value_si.is_infinite() {
            true => NO_ERROR.to_owned(),
            false => writer.with_tag(&Tag::bound(bound, part)).witness(&end.witness, &result.inputs),
        };
        vec![
            statistic_words(bound.statistic, &output_unit(result, &bound.output), writer).into(),
            witness("lower witness", &bound.lower).into(),
            witness("upper witness", &bound.upper).into(),
            error_parts(bound, writer).into(),
            Text::default().quiet(guarantee_words(bound.guarantee, writer)).into(),
        ]
    };
    let groups = groups(result, shown, writer, &row);
    Table { columns, groups, ..Table::default() }
}

/// The bounds of each response with its name.
fn groups(
    result: &StudyResult,
    shown: &[&BoundRecord],
    writer: &NumberWriter,
    row: &dyn Fn(&BoundRecord) -> Vec<Cell>,
) -> Vec<Group> {
    let groups = shown
        .chunk_by(|a, b| a.output == b.output && a.of == b.of && a.at == b.at && a.reading == b.reading)
        .map(|group| Group {
            heading: Text::from(response_words(result, (&group[0].output, group[0].of, group[0].at), writer))
                .plain(reading_beside(result, group[0])),
            rows: group.iter().map(|bound| row(bound)).collect(),
        });
    groups.collect()
}

/// The lower end without its unit, where the upper end has the same: `0.18` of `0.18 mm` and `0.61 mm`, `5` of `5 N m` and `7 N m`.
fn without_unit<'t>(lower: &'t str, upper: &str) -> &'t str {
    let mut units = lower.match_indices('\u{a0}').map(|(at, _)| lower.split_at(at));
    // Spaces stand inside of numbers and of units too: a unit begins with no digit.
    let is_unit =
        |word: &str| !word.trim_start_matches('\u{a0}').starts_with(|first: char| first.is_numeric() || first == '·');
    let same = units.find(|(_, unit)| is_unit(unit) && upper.ends_with(unit));
    same.map_or(lower, |(number, _)| number)
}

/// Why failed runs leave no end, and what the finished runs give: "no bound: a failed run may have had any value; finished runs: 0 to 1 mm".
fn no_end_words(bound: &BoundRecord, result: &StudyResult, writer: &NumberWriter) -> Option<String> {
    let why = why_no_end(result, bound, writer)?;
    let found = finished_words(bound, ["; finished runs: ", " to "], writer).unwrap_or_default();
    Some(format!("no bound: {why}{found}"))
}

fn row(bound: &BoundRecord, result: &StudyResult, writer: &NumberWriter) -> Vec<Cell> {
    let tag = Tag::bound(bound, "upper witness");
    let missing = no_end_words(bound, result, writer);
    let upper_witness = match &missing {
        Some(missing) if bound.upper.widened_si.is_infinite() => missing.clone(),
        _ => writer.with_tag(&tag).witness(&bound.upper.witness, &result.inputs),
    };
    // A page has the places in a table of their own.
    let missing = missing.map_or_else(Text::default, |missing| Text::from(" ").quiet(missing));
    let lower = bound_value(&bound.lower, bound, Rounding::Down, writer);
    let upper = bound_value(&bound.upper, bound, Rounding::Up, writer);
    let both = if same_wording(&lower, &upper) {
        lower.clone()
    } else {
        format!("{} to {upper}", without_unit(&lower, &upper))
    };
    let statistic = statistic_words(bound.statistic, &output_unit(result, &bound.output), writer);
    vec![
        Text::from(statistic).on(Medium::Page, missing).into(),
        both.into(),
        lower.into(),
        upper.into(),
        bound_error(bound, writer).into(),
        upper_witness.into(),
    ]
}

#[cfg(test)]
mod tests {
    use super::without_unit;

    #[test]
    fn a_unit_that_both_ends_have_stands_behind_the_second_one_alone() {
        let of = |lower: &str, upper: &str| {
            let [lower, upper] = [lower, upper].map(|end| end.replace(' ', "\u{a0}"));
            without_unit(&lower, &upper).replace('\u{a0}', " ")
        };
        assert_eq!(of("0.18 mm", "0.61 mm"), "0.18");
        assert_eq!(of("5 N m", "7 N m"), "5");
        assert_eq!(of("0 %", "2.3 %"), "0");
        assert_eq!(of("5 · 10⁻⁶ mm", "7 · 10⁻⁶ mm"), "5 · 10⁻⁶");
        assert_eq!(of("0.18 mm", "0.61 m"), "0.18 mm");
        assert_eq!(of("5 N", "7 N m"), "5 N");
    }
}

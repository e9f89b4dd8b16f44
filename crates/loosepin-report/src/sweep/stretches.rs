//! Which kind of motion there is where.

use crate::numbers::number::NumberWriter;
use crate::numbers::tag::Tag;
use crate::words::wording::{count, head};
use loosepin_result::sweep::SweepRecord;
use loosepin_text::article::{Column, Content, Medium, Section, Table, Text};

/// Rows of the table; the others stand in `sweep.csv`.
const MAX_ROWS: usize = 24;

/// Neighbouring values whose motion is of one kind.
pub(super) struct Stretch {
    /// Turns after which the motion repeats itself, `None` if it does not; `Err` if the runs failed.
    pub period: Result<Option<u32>, ()>,
    /// First and last index.
    pub range: [usize; 2],
}

/// The kinds of motion in the order of the values.
pub(super) fn stretches(record: &SweepRecord) -> Vec<Stretch> {
    let mut stretches: Vec<Stretch> = Vec::new();
    for (index, point) in record.points.iter().enumerate() {
        let period = if point.failure.is_some() { Err(()) } else { Ok(point.period_turns) };
        match stretches.last_mut() {
            Some(last) if last.period == period => last.range[1] = index,
            _ => stretches.push(Stretch { period, range: [index, index] }),
        }
    }
    stretches
}

/// `repeats every turn`.
pub(super) fn period_words(period: Result<Option<u32>, ()>, writer: &NumberWriter) -> String {
    match period {
        Ok(Some(1)) => "repeats every turn".to_owned(),
        Ok(Some(turns)) => {
            let turns = writer.with_tag(&Tag::whole("period", &turns.to_string())).count(u64::from(turns));
            format!("repeats every {turns} turns")
        }
        Ok(None) => "does not repeat".to_owned(),
        Err(()) => "could not be computed".to_owned(),
    }
}

/// A swept value, by its place.
pub(super) fn value_words(record: &SweepRecord, place: usize, writer: &NumberWriter) -> String {
    let tag = Tag::whole("swept value", &place.to_string());
    let value = |value_si: f64| writer.with_tag(&tag).value_trimmed(value_si, &record.unit);
    record.points.get(place).map_or_else(String::new, |point| value(point.value_si))
}

/// The kinds of motion in a table, with the caption of a page.
pub(super) fn stretches_section(record: &SweepRecord, writer: &NumberWriter) -> Section {
    let before = count(u64::from(record.transient_turns), &writer.with_tag(&Tag::Given("turns of start-up")));
    let what = format!(
        "A motion that repeats every turn gives one dot above its value, every second turn two dots. A motion that is not periodic gives a \
         cloud. The first {before} turns are not shown."
    );
    let stretches = stretches(record);
    let numbers = ["from", "to", "values"].map(|words| Column::numbers(head(words)));
    let columns = numbers.into_iter().chain([Column::words(head("motion"))]).collect();
    let row = |Stretch { period, range: [first, last] }: &Stretch| {
        let values = Tag::whole("values of one kind", &first.to_string());
        vec![
            value_words(record, *first, writer),
            value_words(record, *last, writer),
            count((last - first + 1) as u64, &writer.with_tag(&values)),
            period_words(*period, writer),
        ]
    };
    let mut section = Section::headed_on_page("sections", "Periodic and non-periodic motion");
    section.push(Content::Table(Table::new(columns, stretches.iter().take(MAX_ROWS).map(row))));
    let left = stretches.len().saturating_sub(MAX_ROWS);
    if left > 0 {
        let more = count(left as u64, &writer.with_tag(&Tag::Count("ranges that are not shown")));
        section.push(Content::Note(Text::from(format!("{more} more in ")).code("sweep.csv").on(Medium::Page, ".")));
    }
    section.push_on(Medium::Page, Content::sentences([what]));
    section
}

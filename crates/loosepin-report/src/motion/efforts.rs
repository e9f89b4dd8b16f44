//! Efforts of the drives for the ideal motion.

use maud::html;

use crate::charts::chart::{Chart, Entry, Role};
use crate::charts::figure::name_of;
use crate::medium::article_page::push_figure;
use crate::numbers::number::{NumberWriter, PLAIN_DIGITS};
use crate::numbers::tag::Tag;
use crate::words::wording::{head, named_words};
use loosepin_result::motion::{EffortMotion, MotionRecord};
use loosepin_text::article::{Column, Content, Medium, Section, Table, Text};

use super::angles::{angle_chart, largest, turn_angle};

/// Least and largest efforts of the drives, and on a page a chart of each effort; `None` if no effort is an output.
pub(super) fn efforts_section(record: &MotionRecord, writer: &NumberWriter) -> Option<Section> {
    if record.efforts.is_empty() {
        return None;
    }
    let mut section = Section::headed_on_page("efforts", "Forces and torques of the drives");
    let what = Text::from(
        "The drives need these forces and torques for the ideal motion, against inertia, weight, springs, loads and friction in joints without play. Play and impacts are not \
         included: use ",
    );
    section.push_on(Medium::Page, Content::Sentences(vec![what.code("simulate").plain(" for them.")]));
    let [smallest, largest] = ["smallest", "largest"].map(|words| Column::numbers(head(words)));
    let at = || Column::numbers(head("at"));
    let columns = vec![Column::words(head("output")), smallest, at(), largest, at()];
    section.push(Content::Table(Table::new(columns, record.efforts.iter().map(|effort| row(record, effort, writer)))));
    push_figure(&mut section, writer, || {
        html! { div.charts { @for effort in drawn_efforts(record) { (effort_chart(record, effort, writer).figure()) } } }
    });
    Some(section)
}

fn row(record: &MotionRecord, effort: &EffortMotion, writer: &NumberWriter) -> Vec<String> {
    let turned: Vec<f64> = effort.value_si.iter().map(|value| -value).collect();
    let (low_rad, low_si) = largest(record, &turned);
    let (high_rad, high_si) = largest(record, &effort.value_si);
    let ends = [("smallest", low_rad, -low_si), ("largest", high_rad, high_si)].map(|(part, angle_rad, value_si)| {
        let tag = Tag::joint(&effort.name, "effort", part);
        let place = turn_angle(record, angle_rad, PLAIN_DIGITS, &writer.with_tag(&tag.part("at")));
        [writer.with_tag(&tag).value(value_si, &effort.unit), place]
    });
    std::iter::once(named_words(&effort.name, &effort.words)).chain(ends.into_iter().flatten()).collect()
}

/// Those whose course is known.
pub(super) fn drawn_efforts(record: &MotionRecord) -> impl Iterator<Item = &EffortMotion> {
    record.efforts.iter().filter(|effort| !effort.value_si.is_empty())
}

pub(super) fn effort_chart(record: &MotionRecord, effort: &EffortMotion, writer: &NumberWriter) -> Chart {
    let EffortMotion { name, words, unit, value_si } = effort;
    let mut chart = angle_chart(record, name_of("effort", name), writer);
    chart.set_vertical_axis(name, unit, writer);
    chart.height = 220;
    chart.entries.push(Entry::line(name, Role::First, false, value_si, unit, writer));
    chart.caption = html! { strong { (named_words(name, words)) } " over one cycle." };
    chart.alternative = format!("Chart of {} over one cycle.", named_words(name, words));
    chart
}

//! Method of a run: its settings, and the work that it took.

use crate::numbers::number::NumberWriter;
use crate::numbers::tag::Tag;
use crate::study::answer::{turn_word, turns};
use crate::words::wording::{count, counted};
use loosepin_result::simulation::SimulationRecord;
use loosepin_text::article::{Content, Fact, Medium, Section, Text};
use loosepin_text::units::SiUnit;

use super::answer::trusted_run;

/// The settings on a page; the work on both.
pub(super) fn method_section(record: &SimulationRecord, writer: &NumberWriter) -> Section {
    let settings = &record.settings;
    let speed_rad_s = settings.drive_speed_rad_s;
    let continued = settings.continued_at_s.map_or_else(String::new, |time_s| {
        let time = writer.with_tag(&Tag::Given("time of the start")).value_shortest(time_s, &SiUnit::TIME);
        format!("continued from the end of another run at {time}; ")
    });
    let cycle = format!(
        "{continued}{} of start-up, then {} recorded, {} samples per {}",
        turns(settings.transient_turns, speed_rad_s, writer),
        turns(settings.recorded_turns, speed_rad_s, writer),
        count(settings.samples_per_turn as u64, &writer.with_tag(&Tag::Given("samples"))),
        turn_word(speed_rad_s)
    );
    let tolerance = writer.with_tag(&Tag::Given("tolerance")).value_shortest(settings.tolerance_m, &SiUnit::LENGTH);
    let work = work_words(record, writer);
    let mut section = Section::headed_on_page("method", "How this was computed");
    section.push_on(Medium::Terminal, Content::sentences([work.clone()]));
    section.push_on(
        Medium::Page,
        Content::Facts(vec![
            Fact::new("Turns", [cycle]),
            Fact::new("Integration", [format!("{}, tolerance {tolerance}", settings.method)]),
            Fact::new("Work", [work]),
            trusted_run(record).fact(writer),
            Fact::new("Version", [format!("loosepin {}", record.version)]),
        ]),
    );
    section
}

/// `2381 steps, 164 rejected, 30214 evaluations, 90 contact changes`.
fn work_words(record: &SimulationRecord, writer: &NumberWriter) -> Text {
    let counters = &record.counters;
    let of = |value: u64, singular: &'static str, tag: &'static str| {
        counted(value, singular, &writer.with_tag(&Tag::Count(tag)))
    };
    let factorizations = match counters.factorizations {
        0 => String::new(),
        number => format!("{}, ", of(number, "factorization", "factorizations")),
    };
    Text::from(format!(
        "{}, {} rejected, {}",
        of(counters.steps, "step", "steps"),
        count(counters.rejections, &writer.with_tag(&Tag::Count("rejections"))),
        of(counters.evaluations, "evaluation", "evaluations"),
    ))
    .on(Medium::Page, " of the equations of motion")
    .plain(format!(", {factorizations}{}", of(counters.contact_changes, "contact change", "contact changes")))
    .on(Medium::Page, " located")
}

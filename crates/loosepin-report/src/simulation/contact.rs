//! Contact and impacts in the joints of a run.

use maud::{Markup, html};

use crate::charts::chart::{Chart, Dots, Entry, Role};
use crate::medium::article_page::push_figure;
use crate::numbers::number::{NumberWriter, PLAIN_DIGITS, Rounding};
use crate::numbers::tag::Tag;
use crate::study::answer::turn_word;
use crate::words::force::{JointForces, min_impact_speed_words};
use crate::words::wording::{count, head, remark};
use loosepin_result::simulation::{ImpactRecord, JointSummary, SimulationRecord};
use loosepin_text::article::{Cell, Column, Content, Fact, Medium, Section, Table, Text};
use loosepin_text::units::SiUnit;

use super::charts::{abscissa_words, impact_place, run_chart};

/// Rows of the table of impacts; the others stand in `impacts.csv`.
const MAX_IMPACTS: usize = 30;

/// `None` if no joint has play.
pub(super) fn contact_section(record: &SimulationRecord, writer: &NumberWriter) -> Option<Section> {
    if record.joints.is_empty() {
        return None;
    }
    let mut section = Section::headed_on_page("contact", "Contact and impacts");
    section.push(Content::Table(largest_table(record, writer)));
    section.push_close(Content::Note(remark(
        "restitution: of a free impact under the contact law (as stated in the file)",
    )));
    section.push(Content::Table(turn_table(record, writer)));
    if record.joints.iter().any(|joint| joint.share_outside_validity.is_some()) {
        section.push_close(Content::Note(remark(
            "too fast: share of the impacts faster than the contact law is valid for",
        )));
    }
    let laws = record.joints.iter().map(|joint| law_fact(joint, writer));
    section.push_on(Medium::Page, Content::Facts(laws.collect()));
    push_figure(&mut section, writer, || impacts(record, writer));
    Some(section)
}

/// What is largest in each joint over the whole run.
fn largest_table(record: &SimulationRecord, writer: &NumberWriter) -> Table {
    let columns = vec![
        Column::words(head("joint")),
        Column::numbers(head("impacts")),
        Column::numbers(head("contacts")),
        Column::numbers(Text::by_medium("Largest approach speed", "fastest")),
        Column::numbers(Text::by_medium("Largest normal contact force", "peak force")),
        Column::numbers(Text::by_medium("Largest penetration", "penetration")),
        Column::numbers(head("clearance")),
        Column::numbers(head("restitution")),
    ];
    let row = |joint: &JointSummary| {
        let tag = |statistic: &str, part: &str| Tag::joint(&joint.joint, statistic, part);
        let restitution = |part: &str, value: Option<f64>| {
            let tag = tag("restitution", part);
            value.map_or("-".to_owned(), |value| writer.with_tag(&tag).value_trimmed(value, &SiUnit::NONE))
        };
        vec![
            joint.joint.clone(),
            count(joint.impacts, &writer.with_tag(&tag("impacts", "number"))),
            count(joint.contacts, &writer.with_tag(&tag("contacts", "number"))),
            writer.with_tag(&tag("impacts", "largest speed")).value(joint.largest_speed_m_s, &SiUnit::VELOCITY),
            writer.with_tag(&tag("normal force", "largest")).value(joint.peak_force_n, &SiUnit::FORCE),
            writer.with_tag(&tag("penetration", "largest")).value(joint.largest_penetration_m, &SiUnit::LENGTH),
            writer.with_tag(&tag("clearance", "radial")).value_trimmed(joint.radial_clearance_m, &SiUnit::LENGTH),
            format!(
                "{} ({})",
                restitution("delivered", joint.delivered_restitution),
                restitution("stated", joint.nominal_restitution)
            ),
        ]
    };
    Table::new(columns, record.joints.iter().map(row))
}

/// Impacts and losses of contact per turn, time without contact, impacts faster than the law is valid for, relative penetration.
fn turn_table(record: &SimulationRecord, writer: &NumberWriter) -> Table {
    let turn = turn_word(record.settings.drive_speed_rad_s);
    let heads = [format!("impacts a {turn}"), format!("losses a {turn}")].map(|words| Column::numbers(head(&words)));
    let further = ["out of contact", "too fast", "penetration/clearance"].map(|words| Column::numbers(head(words)));
    let columns = std::iter::once(Column::words(head("joint"))).chain(heads).chain(further).collect();
    let row = |joint: &JointSummary| -> Vec<Cell> {
        let tag = |statistic: &str, part: &str| Tag::joint(&joint.joint, statistic, part);
        let tenths = |statistic: &str, value: f64| {
            writer.with_tag(&tag(statistic, "per turn")).shortest((value * 10.0).round() / 10.0, &SiUnit::NONE)
        };
        let share = |statistic: &str, part: &str, share: f64, rounding: Rounding| {
            writer.with_tag(&tag(statistic, part)).percent(share, rounding)
        };
        let penetration = (joint.radial_clearance_m > 0.0).then(|| {
            let of_clearance = joint.largest_penetration_m / joint.radial_clearance_m;
            share("penetration", "largest share", of_clearance, Rounding::Up)
        });
        let outside = joint.share_outside_validity;
        vec![
            joint.joint.as_str().into(),
            joint.impacts_per_turn.map(|value| tenths("impacts", value)).into(),
            tenths("losses", joint.losses_per_turn).into(),
            share("flight", "share", joint.flight_share, Rounding::Nearest).into(),
            outside.map(|outside| share("impacts", "outside validity", outside, Rounding::Up)).into(),
            penetration.into(),
        ]
    };
    Table::new(columns, record.joints.iter().map(row))
}

/// The law with what it rests on; in records of older versions its name.
fn law_fact(joint: &JointSummary, writer: &NumberWriter) -> Fact {
    let law = JointForces::run(joint).laws(writer).pop().unwrap_or_else(|| joint.law.clone());
    let slow = min_impact_speed_words(&joint.joint, joint.floored_contacts, writer);
    Fact::new(
        format!("Contact law in {}", joint.joint),
        [law].into_iter().chain(slow.map(|words| format!("Very slow contacts: {words}"))),
    )
}

/// The contact force of each joint, and the first impacts.
fn impacts(record: &SimulationRecord, writer: &NumberWriter) -> Markup {
    let shown = record.impacts.len().min(MAX_IMPACTS);
    let number_shown = count(shown as u64, &writer.with_tag(&Tag::Count("impacts that are shown")));
    html! {
        @if record.contact_forces.iter().any(|history| !history.force_n.is_empty()) {
            (force_chart(record, writer).figure())
        }
        @if !record.impacts.is_empty() {
            details.numbers {
                summary {
                    @if shown < record.impacts.len() {
                        "The first " (number_shown) " of "
                        (count(record.impacts.len() as u64, &writer.with_tag(&Tag::Count("impacts")))) " impacts"
                    }
                    @else if shown == 1 { "The impact" }
                    @else { "All " (number_shown) " impacts" }
                }
                div.scroll tabindex="0" role="region" aria-label="Table of impacts" { (impact_table(record, shown, writer)) }
            }
        }
    }
}

fn impact_table(record: &SimulationRecord, shown: usize, writer: &NumberWriter) -> Markup {
    // The phase of a cycle in which no drive turns tells nothing that the time does not.
    let has_angle = record.settings.drive_speed_rad_s.is_some();
    let row = |place: usize, impact: &ImpactRecord| {
        let number = format!("impact {place}");
        let tag = |part: &str| Tag::joint(&impact.joint, &number, part);
        html! {
            tr {
                th scope="row" { (writer.with_tag(&tag("time")).value(impact.time_s, &SiUnit::TIME)) }
                @if has_angle { td { (writer.with_tag(&tag("angle")).angle_in_turn(impact.drive_angle_rad, PLAIN_DIGITS)) } }
                td { (impact.joint) }
                td { (writer.with_tag(&tag("speed")).value(impact.speed_m_s, &SiUnit::VELOCITY)) }
                td { (writer.with_tag(&tag("duration")).value(impact.duration_s, &SiUnit::TIME)) }
                td { (writer.with_tag(&tag("peak force")).value(impact.peak_force_n, &SiUnit::FORCE)) }
                td {
                    @match impact.separation_speed_m_s {
                        Some(speed) => (writer.with_tag(&tag("separation speed")).value(speed, &SiUnit::VELOCITY)),
                        None => "still touching",
                    }
                }
            }
        }
    };
    html! {
        table {
            thead {
                tr {
                    th scope="col" { "Onset" }
                    @if has_angle { th scope="col" { "Angle of " (record.settings.drive) } }
                    th scope="col" { "Joint" }
                    th scope="col" { "Approach speed" }
                    th scope="col" { "Duration" }
                    th scope="col" { "Peak force" }
                    th scope="col" { "Separation speed" }
                }
            }
            tbody { @for (place, impact) in record.impacts.iter().take(shown).enumerate() { (row(place, impact)) } }
        }
    }
}

fn force_chart(record: &SimulationRecord, writer: &NumberWriter) -> Chart {
    let mut chart = run_chart(record, "contact-force".to_owned(), writer);
    chart.set_vertical_axis("contact force", &SiUnit::FORCE, writer);
    for (index, history) in record.contact_forces.iter().enumerate() {
        let role = Role::of_index(index);
        let own = record.impacts.iter().filter(|impact| impact.joint == history.joint);
        let point = |impact: &ImpactRecord| {
            [impact_place(record, impact, writer), writer.scaled(impact.peak_force_n, &SiUnit::FORCE)]
        };
        chart.dots.push(Dots { entry: index, role, points: own.map(point).collect() });
        chart.entries.push(Entry::line(&history.joint, role, false, &history.force_n, &SiUnit::FORCE, writer));
    }
    chart.caption = html! {
        strong { "Normal contact force" } " at the sample times. Dots: the largest force of each impact, which lies between samples."
    };
    chart.alternative =
        format!("Chart of the normal contact force of each joint with play {}.", abscissa_words(record));
    chart
}

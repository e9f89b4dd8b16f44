//! The page of a sweep: period of the motion, impacts and forces over the swept value.

use maud::{Markup, html};

use crate::charts::chart::{Chart, Entry, Role};
use crate::medium::article_page::{overview, page_section};
use crate::medium::page::{self, Page, changes, sentences};
use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::Tag;
use crate::study::repeat_section::repeat_section;
use crate::words::wording::{capitalised, count};
use loosepin_result::simulation::REPEAT_SHARE;
use loosepin_result::sweep::{SweepRecord, SweptJoint};
use loosepin_text::article::{Fact, Section};
use loosepin_text::units::SiUnit;

use super::answer::headline_sentences;
use super::section_figure::section_figure;
use super::stretches::{stretches_section, value_words};

/// The page of a sweep as one HTML text that needs no network: the answer, the bifurcation diagram of the first output, and which kind of motion there is
/// where; then sections that open: the diagrams of the other positions and angles; impacts, loss of contact and peak forces of each joint. Text from
/// files is escaped.
pub fn sweep_page(record: &SweepRecord) -> String {
    let writer = &NumberWriter::for_page(&record.display_units);
    let (kinds, all_kinds) = overview(Some(stretches_section(record, writer)));
    let figure = |output| section_figure(record, output, writer);
    let others = || html! { @for output in 1..record.outputs.len() { (figure(output)) } };
    let title = "Impacts and forces in the joints";
    let sections = [
        all_kinds,
        (record.outputs.len() > 1).then(|| page::Section::new("others", "The other outputs", others())),
        (!record.joints.is_empty()).then(|| page::Section::new("joints", title, joints(record, writer))),
        page_section(method(record, writer)),
        repeat_section(&record.repeat),
    ];
    Page {
        title: record.model.clone(),
        kicker: "Sweep",
        subtitle: html! {
            (record.path) " from " (value_words(record, 0, writer)) " to "
            (value_words(record, record.points.len() - 1, writer))
            (changes(&record.overrides))
        },
        answer: sentences(&headline_sentences(record, writer)),
        is_answer_short: true,
        beside: html! {},
        below: if record.outputs.is_empty() {
            html! {}
        } else {
            figure(0)
        },
        more: kinds,
        is_folded: true,
        sections: sections.into_iter().flatten().collect(),
        identity: "sweep".to_owned(),
        version: record.version.clone(),
    }
    .into_html()
}

fn method(record: &SweepRecord, writer: &NumberWriter) -> Section {
    let turns = |of: &'static str, turns: u32| count(u64::from(turns), &writer.with_tag(&Tag::Given(of)));
    let runs = format!(
        "{}, each from the ideal position and velocities; {} turns of start-up, {} turns examined",
        count(record.points.len() as u64, &writer.with_tag(&Tag::Count("values"))),
        turns("turns of start-up", record.transient_turns),
        turns("turns that are examined", record.recorded_turns)
    );
    let period = format!(
        "p turns, if every journal is back within {} of its clearance after every p turns; p is at most half of the turns examined",
        writer.with_tag(&Tag::Given("share of a clearance")).percent(REPEAT_SHARE, Rounding::Nearest)
    );
    let tolerance = writer.with_tag(&Tag::Given("tolerance")).value_shortest(record.tolerance_m, &SiUnit::LENGTH);
    let facts = [
        Fact::new("Runs", [runs]),
        Fact::new("Period", [period]),
        Fact::new("Tolerance of a step", [format!("{tolerance}; contacts located as events")]),
        Fact::new("Version", [format!("loosepin {}", record.version)]),
    ];
    Section::of_facts("method", "How this was computed", facts)
}

fn joints(record: &SweepRecord, writer: &NumberWriter) -> Markup {
    let forces = |joint: &SweptJoint| joint.peak_force_n;
    html! {
        (joint_chart(record, "impacts", "impacts a turn", &SiUnit::NONE, |joint| joint.impacts_per_turn, writer))
        (joint_chart(record, "flight", "share of the time without contact", &SiUnit::NONE, |joint| joint.flight_share, writer))
        (joint_chart(record, "force", "largest normal force", &SiUnit::FORCE, forces, writer))
    }
}

fn joint_chart(
    record: &SweepRecord,
    id: &str,
    what: &str,
    unit: &SiUnit,
    read: impl Fn(&SweptJoint) -> f64,
    writer: &NumberWriter,
) -> Markup {
    let values_si: Vec<f64> = record.points.iter().map(|point| point.value_si).collect();
    let entries = record.joints.iter().enumerate().map(|(index, joint)| {
        let of_joint: Vec<f64> =
            record.points.iter().map(|point| point.joints.get(index).map_or(f64::NAN, &read)).collect();
        Entry::line(joint, Role::of_index(index), false, &of_joint, unit, writer)
    });
    let all = record.points.iter().flat_map(|point| point.joints.iter().map(&read));
    let (least, most) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    let number =
        |part: &str, value: f64| writer.with_tag(&Tag::whole(what, part)).rounded(value, unit, 3, Rounding::Nearest);
    let range = if least.is_finite() {
        format!("between {} and {}", number("least", least), number("most", most))
    } else {
        "not computed".to_owned()
    };
    Chart {
        y_label: what.to_owned(),
        y_symbol: writer.symbol(unit),
        entries: entries.collect(),
        height: 240,
        caption: html! { strong { (capitalised(what)) } ": " (range) "." },
        alternative: format!("Chart of {what} over {}: {range}.", record.path),
        ..Chart::over(id.to_owned(), &record.path, &values_si, &record.unit, writer)
    }
    .figure()
}

#[cfg(test)]
mod tests {
    use super::*;
    use loosepin_result::sweep::SweepPoint;
    use loosepin_text::units::DisplayUnits;

    #[test]
    fn a_sweep_that_could_not_be_computed_says_nothing_of_its_motion() {
        let failed = |value_si: f64| SweepPoint {
            value_si,
            failure: Some("the loops cannot be closed".to_owned()),
            period_turns: None,
            sections_si: Vec::new(),
            joints: Vec::new(),
        };
        let record = SweepRecord {
            repeat: Default::default(),
            model: "slider-crank".to_owned(),
            version: "0.1.0".to_owned(),
            overrides: Vec::new(),
            path: "parameter.rod_length".to_owned(),
            unit: SiUnit::LENGTH,
            drive: "crank".to_owned(),
            section_angle_rad: 0.3,
            transient_turns: 20,
            recorded_turns: 8,
            tolerance_m: 1e-8,
            outputs: Vec::new(),
            joints: vec!["gudgeon".to_owned()],
            points: vec![failed(0.02), failed(0.03)],
            display_units: DisplayUnits::default(),
        };
        assert_eq!(
            headline_sentences(&record, &NumberWriter::for_terminal(&record.display_units)),
            [
                "All 2 runs failed: no value of parameter.rod_length gives a motion.",
                "2\u{a0}runs failed. The first reason: the loops cannot be closed"
            ]
        );
        assert!(sweep_page(&record).contains("not computed"));
    }
}

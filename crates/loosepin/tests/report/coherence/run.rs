//! Texts of single runs.

use loosepin::report::{Tag, simulation_page, simulation_text, tagged};
use loosepin::result::json::Stored;
use loosepin::simulate::record::{ExtremePoint, SimulationRecord};
use loosepin::units::SiUnit;

use super::held::{Read, faults};
use super::shown::{Names, Shown, page_numbers, terminal_numbers};
use crate::report_fixture::simulation::worn_pin;

/// Sections of the page of a run whose numbers are not all tagged yet. The list can only shrink.
const SECTIONS_LEFT: [&str; 1] = ["orbits"];

fn read(page: &SimulationRecord, terminal: &SimulationRecord, stored: &SimulationRecord) -> [Read; 3] {
    let summary = stored.to_json().unwrap();
    let names = Names::of(&summary);
    [
        page_numbers(&tagged(|| simulation_page(page)), &names, &SECTIONS_LEFT),
        terminal_numbers(&tagged(|| simulation_text(terminal)), &names, &[]),
        (numbers(&SimulationRecord::from_json(&summary).unwrap()), Vec::new()),
    ]
}

/// Numbers of the record that its texts show.
fn numbers(record: &SimulationRecord) -> Vec<Shown> {
    let mut shown = Vec::new();
    let mut add = |tag: Tag, value_si: f64, unit: &SiUnit| {
        let value = record.display_units.of(unit).from_si(value_si);
        if !value.is_nan() {
            shown.push(Shown::exact("summary.json", tag, value));
        }
    };
    for extreme in &record.extremes {
        let ends: [(&str, &ExtremePoint); 2] = [("minimum", &extreme.minimum), ("maximum", &extreme.maximum)];
        for (part, point) in ends {
            let tag = Tag::extreme(extreme, part);
            add(tag.part("time"), point.time_s, &SiUnit::TIME);
            add(tag, point.value_si, &extreme.unit);
        }
    }
    for joint in &record.joints {
        let tag = |statistic: &str, part: &str| Tag::joint(&joint.joint, statistic, part);
        let tenth = |value: f64| (value * 10.0).round() / 10.0;
        add(tag("impacts", "number"), joint.impacts as f64, &SiUnit::NONE);
        add(tag("contacts", "number"), joint.contacts as f64, &SiUnit::NONE);
        add(tag("impacts", "largest speed"), joint.largest_speed_m_s, &SiUnit::VELOCITY);
        add(tag("normal force", "largest"), joint.peak_force_n, &SiUnit::FORCE);
        add(tag("penetration", "largest"), joint.largest_penetration_m, &SiUnit::LENGTH);
        add(tag("clearance", "radial"), joint.radial_clearance_m, &SiUnit::LENGTH);
        add(tag("losses", "per turn"), tenth(joint.losses_per_turn), &SiUnit::NONE);
        add(tag("flight", "share"), 100.0 * joint.flight_share, &SiUnit::NONE);
        for (statistic, part, value) in [
            ("impacts", "per turn", joint.impacts_per_turn.map(tenth)),
            ("impacts", "outside validity", joint.share_outside_validity.map(|share| 100.0 * share)),
            ("restitution", "stated", joint.nominal_restitution),
            ("restitution", "delivered", joint.delivered_restitution),
        ] {
            if let Some(value) = value {
                add(tag(statistic, part), value, &SiUnit::NONE);
            }
        }
        // The largest force of an impact is none beyond that of the joint.
        let peaks =
            record.impacts.iter().filter(|impact| impact.joint == joint.joint).map(|impact| impact.peak_force_n);
        if let Some(peak) = peaks.reduce(f64::max).filter(|peak| *peak > joint.peak_force_n) {
            add(tag("normal force", "largest"), peak, &SiUnit::FORCE);
        }
    }
    for (place, impact) in record.impacts.iter().enumerate() {
        let number = format!("impact {place}");
        let tag = |part: &str| Tag::joint(&impact.joint, &number, part);
        add(tag("time"), impact.time_s, &SiUnit::TIME);
        add(tag("speed"), impact.speed_m_s, &SiUnit::VELOCITY);
        add(tag("peak force"), impact.peak_force_n, &SiUnit::FORCE);
    }
    add(Tag::whole("energy residual", "relative"), record.energy.relative_residual, &SiUnit::NONE);
    add(Tag::Count("impacts"), record.impacts.len() as f64, &SiUnit::NONE);
    shown
}

#[test]
fn identity_every_number_of_a_run_has_one_value_in_all_its_texts() {
    let run = worn_pin();
    let found = faults(&read(&run, &run, &run));
    assert!(found.is_empty(), "{} faults\n{}", found.len(), found.join("\n"));
}

#[test]
fn planted_contradictions_between_texts_of_a_run_are_found() {
    type Change = fn(&mut SimulationRecord);
    const PLANTED: [(&str, Change); 8] = [
        ("the largest deviation", |r| r.extremes.last_mut().unwrap().maximum.value_si *= 1.05),
        ("the position told as the deviation", |r| {
            let position = r.extremes[0].clone();
            let deviation = r.extremes.last_mut().unwrap();
            (deviation.minimum, deviation.maximum) = (position.minimum, position.maximum);
        }),
        ("a time", |r| r.extremes[0].minimum.time_s *= 1.2),
        ("the largest force", |r| r.joints[0].peak_force_n *= 1.0033),
        ("the penetration", |r| r.joints[0].largest_penetration_m *= 1.5),
        ("the number of impacts", |r| r.joints[0].impacts += 1),
        ("the restitution", |r| r.joints[0].delivered_restitution = Some(0.905)),
        ("the error of the energy balance", |r| r.energy.relative_residual *= 72.0),
    ];
    let run = worn_pin();
    for (what, change) in PLANTED {
        let mut other = worn_pin();
        change(&mut other);
        for records in [[&other, &run, &run], [&run, &other, &run], [&run, &run, &other]] {
            assert!(!faults(&read(records[0], records[1], records[2])).is_empty(), "{what} is not found");
        }
    }
}

#[test]
fn sections_of_a_run_that_are_left_have_untagged_numbers() {
    let run = worn_pin();
    let page = tagged(|| simulation_page(&run));
    let names = Names::of(&run.to_json().unwrap());
    for section in SECTIONS_LEFT {
        let others: Vec<&str> = SECTIONS_LEFT.into_iter().filter(|other| *other != section).collect();
        let (_, untagged) = page_numbers(&page, &names, &others);
        assert!(!untagged.is_empty(), "take '{section}' out of the list: all its numbers are tagged");
    }
}

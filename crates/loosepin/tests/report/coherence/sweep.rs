//! Texts of a sweep.

use loosepin::report::{Tag, sweep_page, sweep_text, tagged};
use loosepin::result::json::Stored;
use loosepin::sweep::record::{SweepPoint, SweepRecord, SweptJoint, SweptOutput};
use loosepin::units::{DisplayUnits, SiUnit};

use super::held::{Read, faults};
use super::shown::{Names, Shown, page_numbers, terminal_numbers};

fn read(page: &SweepRecord, terminal: &SweepRecord, stored: &SweepRecord) -> [Read; 3] {
    let summary = stored.to_json().unwrap();
    let names = Names::of(&summary);
    [
        page_numbers(&tagged(|| sweep_page(page)), &names, &[]),
        terminal_numbers(&tagged(|| sweep_text(terminal)), &names, &[]),
        (numbers(&SweepRecord::from_json(&summary).unwrap()), Vec::new()),
    ]
}

/// Numbers of the record that its texts show.
fn numbers(record: &SweepRecord) -> Vec<Shown> {
    let mut shown = Vec::new();
    let mut add = |tag: Tag, value_si: f64, unit: &SiUnit| {
        shown.push(Shown::exact("summary.json", tag, record.display_units.of(unit).from_si(value_si)));
    };
    let count = |is: &dyn Fn(&SweepPoint) -> bool| record.points.iter().filter(|point| is(point)).count() as f64;
    for (what, value) in [
        ("values", record.points.len() as f64),
        ("values with a period", count(&|point| point.period_turns.is_some())),
        ("values without a period", count(&|point| point.period_turns.is_none() && point.failure.is_none())),
        ("failed runs", count(&|point| point.failure.is_some())),
    ] {
        add(Tag::Count(what), value, &SiUnit::NONE);
    }
    for (place, point) in record.points.iter().enumerate() {
        add(Tag::whole("swept value", &place.to_string()), point.value_si, &record.unit);
    }
    let forces = || record.points.iter().flat_map(|point| point.joints.iter().map(|joint| joint.peak_force_n));
    add(Tag::whole("largest normal force", "least"), forces().fold(f64::INFINITY, f64::min), &SiUnit::FORCE);
    add(Tag::whole("largest normal force", "most"), forces().fold(0.0, f64::max), &SiUnit::FORCE);
    shown
}

/// Five clearances: two of a kind, a doubled period, one that does not repeat, one that fails.
fn swept() -> SweepRecord {
    let point = |value_si: f64, period_turns: Option<u32>, peak_force_n: f64| SweepPoint {
        value_si,
        failure: None,
        period_turns,
        sections_si: vec![vec![0.7 * value_si, -0.4 * value_si]],
        joints: vec![SweptJoint {
            impacts_per_turn: 3.5,
            flight_share: 0.37,
            losses_per_turn: 3.25,
            peak_force_n,
            largest_penetration_m: 2e-6,
        }],
    };
    let failed = SweepPoint {
        failure: Some("the loops cannot be closed".to_owned()),
        sections_si: Vec::new(),
        joints: Vec::new(),
        ..point(6.1e-4, None, 0.0)
    };
    SweepRecord {
        repeat: Default::default(),
        model: "slider-crank with a worn pin".to_owned(),
        version: loosepin::VERSION.to_owned(),
        overrides: Vec::new(),
        path: "joint.gudgeon.radial_clearance".to_owned(),
        unit: SiUnit::LENGTH,
        drive: "crank".to_owned(),
        section_angle_rad: 0.3,
        transient_turns: 23,
        recorded_turns: 8,
        tolerance_m: 1e-8,
        outputs: vec![SweptOutput {
            name: "slider".to_owned(),
            words: "x of slider.pin".to_owned(),
            unit: SiUnit::LENGTH,
        }],
        joints: vec!["gudgeon".to_owned()],
        points: vec![
            point(2.1e-5, Some(1), 1234.0),
            point(4.2e-5, Some(1), 2345.0),
            point(1.3e-4, Some(2), 5678.0),
            point(3.4e-4, None, 43_210.0),
            failed,
        ],
        display_units: DisplayUnits::default(),
    }
}

#[test]
fn identity_every_number_of_a_sweep_has_one_value_in_all_its_texts() {
    let sweep = swept();
    let found = faults(&read(&sweep, &sweep, &sweep));
    assert!(found.is_empty(), "{} faults\n{}", found.len(), found.join("\n"));
}

#[test]
fn planted_contradictions_between_texts_of_a_sweep_are_found() {
    type Change = fn(&mut SweepRecord);
    const PLANTED: [(&str, Change); 2] = [
        ("a value", |r| r.points[1].value_si *= 1.1),
        ("a motion that does not repeat", |r| r.points[3].period_turns = Some(4)),
    ];
    let sweep = swept();
    for (what, change) in PLANTED {
        let mut other = sweep.clone();
        change(&mut other);
        for records in [[&other, &sweep, &sweep], [&sweep, &other, &sweep], [&sweep, &sweep, &other]] {
            assert!(!faults(&read(records[0], records[1], records[2])).is_empty(), "{what} is not found");
        }
    }
    // A terminal has no charts.
    let mut other = sweep.clone();
    other.points[3].joints[0].peak_force_n *= 1.02;
    assert!(!faults(&read(&other, &sweep, &sweep)).is_empty(), "the largest force is not found");
}

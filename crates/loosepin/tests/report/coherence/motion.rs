//! Texts of the ideal motion.

use loosepin::accuracy::record::*;
use loosepin::report::{Tag, motion_page, motion_text, tagged};
use loosepin::result::json::Stored;
use loosepin::study::result::Deviation;
use loosepin::units::SiUnit;

use super::held::{Read, faults};
use super::shown::{Names, Shown, page_numbers, terminal_numbers};
use crate::report_fixture::motion::{four_bar, worn_pin};

fn read(page: &MotionRecord, terminal: &MotionRecord, stored: &MotionRecord) -> [Read; 3] {
    let summary = stored.to_json().unwrap();
    let names = Names::of(&summary);
    [
        page_numbers(&tagged(|| motion_page(page)), &names, &[]),
        terminal_numbers(&tagged(|| motion_text(terminal)), &names, &[]),
        (numbers(&MotionRecord::from_json(&summary).unwrap()), Vec::new()),
    ]
}

/// Numbers of the record that its texts show.
fn numbers(record: &MotionRecord) -> Vec<Shown> {
    let mut shown = Vec::new();
    let mut add = |tag: Tag, value_si: f64, unit: &SiUnit| {
        let value = record.display_units.of(unit).from_si(value_si);
        if value.is_finite() {
            shown.push(Shown::exact("summary.json", tag, value));
        }
    };
    let most = |values: &[f64]| values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = |values: &[f64]| values.iter().copied().fold(f64::INFINITY, f64::min);
    add(Tag::Count("positions"), record.drive_angle_rad.len() as f64, &SiUnit::NONE);
    for output in &record.outputs {
        let tag = |statistic: &str, part: &str| Tag::joint(&output.name, statistic, part);
        let (play, unit) = (&output.clearance, &output.unit);
        let worst = if play.worst_case_si.is_empty() { &play.first_order_si } else { &play.worst_case_si };
        add(tag("play", "largest"), most(worst), unit);
        add(tag("play", "proven"), most(&play.proven_highest_si).max(-least(&play.proven_lowest_si)), unit);
        add(tag("play", "standard deviation on the rims"), most(&play.rim_standard_deviation_si), unit);
        for joint in &play.contributors {
            add(Tag::joint(&joint.joint, "clearance", "radial"), joint.radial_clearance_m, &SiUnit::LENGTH);
        }
        let rate = unit.per_second().unwrap();
        for (what, values_si, unit) in [
            ("ideal position", &output.value_si, unit),
            ("ideal velocity", &output.velocity_si, &rate),
            ("ideal acceleration", &output.acceleration_si, &rate.per_second().unwrap()),
        ] {
            add(tag(what, "smallest"), least(values_si), unit);
            add(tag(what, "largest"), most(values_si), unit);
        }
        add(tag("scatter", "largest"), most(&output.dimensional_standard_deviation_si), unit);
        for dimension in &output.dimensional_contributors {
            let over_cycle = tag("scatter", "over the cycle").at(&dimension.path);
            add(over_cycle, most(&dimension.standard_deviation_si), unit);
        }
    }
    for effort in &record.efforts {
        let tag = |part: &str| Tag::joint(&effort.name, "effort", part);
        add(tag("smallest"), least(&effort.value_si), &effort.unit);
        add(tag("largest"), most(&effort.value_si), &effort.unit);
    }
    for requirement in &record.requirements {
        let tag = |part: &str| Tag::motion_requirement(requirement, part);
        for (place, end) in ["lowest", "highest"].into_iter().enumerate() {
            add(tag(&format!("{end} proven")), requirement.proven_si[place], &requirement.unit);
            add(tag(&format!("{end} found")), requirement.found_si[place], &requirement.unit);
        }
    }
    shown
}

/// The slider-crank with all that a motion may say of a study and of where it is not certain.
fn judged() -> MotionRecord {
    let requirement = |verdict: MotionVerdict, pose_rad: Option<f64>| MotionRequirement {
        output: "slider".to_owned(),
        unit: SiUnit::LENGTH,
        of: Deviation::Total,
        pose_rad,
        lower_si: -5.5e-4,
        upper_si: 5.7e-4,
        probability_at_least: 0.95,
        share_within_limits: 0.9973,
        proven_si: [-6.2e-4, 6.3e-4],
        found_si: [-6.06e-4, 6.04e-4],
        found_at_rad: [1.57, 4.712],
        verdict,
        reason: None,
    };
    let allowance = |loosest_si: Option<f64>, fit: Option<&str>| MotionAllowance {
        path: "joint.gudgeon.radial_clearance".to_owned(),
        unit: SiUnit::LENGTH,
        up_to_si: 4e-4,
        loosest_si,
        fit: fit.map(str::to_owned),
        reason: None,
    };
    MotionRecord {
        kinematics: Default::default(),
        guide_overhangs: vec![GuideOverhang { joint: "rail".to_owned(), spans_rad: vec![[0.3, 0.9], [3.5, 3.5]] }],
        unproven_spans: vec![UnprovenSpan {
            span_rad: [1.2, 1.3],
            words: "a dead point is near".to_owned(),
            reaches_dead_centre: false,
        }],
        requirements: vec![
            requirement(MotionVerdict::Met, None),
            requirement(MotionVerdict::NotMetInTheWorstCase, Some(0.7)),
            requirement(MotionVerdict::Undecided, Some(1.1)),
            requirement(MotionVerdict::NeedsDynamics, Some(1.3)),
        ],
        allowances: vec![allowance(Some(3.1e-4), None), allowance(None, None), allowance(Some(3e-4), Some("H7/f7"))],
        ..worn_pin()
    }
}

#[test]
fn identity_every_number_of_a_motion_has_one_value_in_all_its_texts() {
    for motion in [worn_pin(), four_bar(), judged()] {
        let found = faults(&read(&motion, &motion, &motion));
        assert!(found.is_empty(), "{}: {} faults\n{}", motion.model, found.len(), found.join("\n"));
    }
}

#[test]
fn planted_contradictions_between_texts_of_a_motion_are_found() {
    type Change = fn(&mut MotionRecord);
    const PLANTED: [(&str, Change); 8] = [
        ("the worst case", |r| scale(&mut r.outputs[0].clearance.worst_case_si, 1.02)),
        ("the proven end", |r| scale(&mut r.outputs[0].clearance.proven_lowest_si, 1.02)),
        ("the standard deviation by play", |r| scale(&mut r.outputs[0].clearance.rim_standard_deviation_si, 0.97)),
        ("the clearance of a joint", |r| r.outputs[0].clearance.contributors[1].radial_clearance_m *= 4.0),
        ("the ideal position", |r| scale(&mut r.outputs[0].value_si, 1.01)),
        ("the standard deviation by scatter", |r| scale(&mut r.outputs[0].dimensional_standard_deviation_si, 1.05)),
        ("the torque", |r| scale(&mut r.efforts[0].value_si, 0.98)),
        ("what was found of a requirement", |r| r.requirements[1].found_si[0] *= 1.03),
    ];
    let motion = judged();
    for (what, change) in PLANTED {
        let mut other = motion.clone();
        change(&mut other);
        for records in [[&other, &motion, &motion], [&motion, &other, &motion], [&motion, &motion, &other]] {
            assert!(!faults(&read(records[0], records[1], records[2])).is_empty(), "{what} is not found");
        }
    }
}

fn scale(values: &mut [f64], by: f64) {
    values.iter_mut().for_each(|value| *value *= by);
}

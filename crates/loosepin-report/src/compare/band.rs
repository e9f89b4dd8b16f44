//! The bands of an output of two studies in one picture.

use std::f64::consts::TAU;

use serde::Serialize;

use super::headline::{is_same_curve, reach_si};
use super::outputs::SharedOutputs;
use super::sides::for_both;
use crate::charts::chart::{Chart, Entry, EntryValues, Role, scaled};
use crate::charts::figure::name_of;
use crate::numbers::number::{NumberWriter, Rounding};
use crate::words::limits::requirement_words;
use crate::words::wording::{capitalised, deviation_of, deviation_words};
use loosepin_result::study::{DeviationCurve, RequirementOutcome, ResponsePoint, StudyResult};

/// Angles that differ by less are one.
const SAME_ANGLE_RAD: f64 = 1e-9;
const HEIGHT: u32 = 320;
const DIGITS: usize = 3;

/// Both bands of an output over the cycle.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ComparedBand {
    /// Title: `Deviation of slider`.
    pub title: String,
    /// How far each band reaches, in a sentence.
    pub words: String,
    /// The chart as an SVG document that takes its style from the page.
    pub figure: String,
    /// Angles of the chart, degrees.
    pub angle_deg: Vec<f64>,
    /// From where to where A and B reach at each of them, with units.
    pub reaches: Vec<[String; 2]>,
}

/// The pictures in the order of A; and which bands are not compared, in sentences.
pub fn compared(
    pair: [&StudyResult; 2],
    outputs: &SharedOutputs,
    writer: &NumberWriter,
) -> (Vec<ComparedBand>, Vec<String>) {
    let [before, after] = pair;
    let of = |result: &'_ StudyResult| -> Vec<usize> {
        let is_shown = |curve: &DeviationCurve| outputs.has(&curve.output) && !curve.mixed.lower_si.is_empty();
        let curves = result.curves.iter().enumerate();
        curves.filter(|(_, curve)| is_shown(curve)).map(|(place, _)| place).collect()
    };
    let title = |curve: &DeviationCurve| capitalised(&deviation_of(&curve.output, curve.of, &before.outputs));
    let (mut bands, mut left_out) = (Vec::new(), Vec::new());
    let mut left = of(after);
    for place in of(before) {
        let curve = &before.curves[place];
        let Some(found) = left.iter().position(|other| is_same_curve(curve, &after.curves[*other])) else {
            left_out.push(format!("{}: only A has this band.", title(curve)));
            continue;
        };
        let other = &after.curves[left.remove(found)];
        if before.cycle.drive == after.cycle.drive {
            bands.push(band(pair, [curve, other], title(curve), writer));
        } else {
            let drives = for_both([&before.cycle.drive, &after.cycle.drive]);
            left_out.push(format!("{}: the bands are over the angle of another drive: {drives}.", title(curve)));
        }
    }
    left_out.extend(left.iter().map(|place| format!("{}: only B has this band.", title(&after.curves[*place]))));
    (bands, left_out)
}

fn band(
    results: [&StudyResult; 2],
    curves: [&DeviationCurve; 2],
    title: String,
    writer: &NumberWriter,
) -> ComparedBand {
    let [first, second] = curves;
    let angles = angles(first, second);
    let share = writer.percent(first.probabilities[1] - first.probabilities[0], Rounding::Nearest);
    let mut chart = Chart::over_angle(name_of("compared", &first.output), &results[0].cycle.drive, &angles, writer);
    chart.set_vertical_axis(format!("{} of {}", deviation_words(first.of), first.output), &first.unit, writer);
    chart.height = HEIGHT;
    let entry = |which: usize| {
        let (name, role) = [("A", Role::Mixed), ("B", Role::Random)][which];
        let [lower, upper] = ends_at(curves[which], &angles).map(|list| scaled(&list, &first.unit, writer));
        Entry::new(format!("{name}: {share}, all unknown values"), role, which == 1, EntryValues::band(&lower, &upper))
    };
    let reaches = curves.map(reach_si);
    let reach = |which: usize| reaches[which].map_or(0.0, |(_, reach)| reach);
    // The wider one lies below.
    let order = if reach(1) > reach(0) { [1, 0] } else { [0, 1] };
    chart.entries.extend(order.map(entry));
    for (label, ends_si) in limits(results, first, writer) {
        let [lower, upper] = ends_si.map(|end| vec![writer.scaled(end, &first.unit); angles.len()]);
        chart.entries.push(Entry::new(label, Role::Limit, true, EntryValues::pair(&lower, &upper)));
    }
    let told = [0, 1].map(|which| match reaches[which] {
        Some((angle_rad, reach_si)) => format!(
            "±{} at {}",
            // As the sentences of each study have it.
            writer.for_sentence(reach_si, curves[which].numerical_error_si, &first.unit, Rounding::Up),
            writer.angle_in_turn(angle_rad, DIGITS)
        ),
        None => "nothing known".to_owned(),
    });
    let words = format!("Farthest from zero: {}.", for_both(told));
    chart.alternative = format!("Chart of both bands over one cycle. {title}. {words}");
    let both = curves.map(|curve| ends_at(curve, &angles));
    let reaches = (0..angles.len()).map(|pose| [0, 1].map(|which| reach_words(&both[which], pose, first, writer)));
    let angle_deg = angles.iter().map(|angle| angle.to_degrees()).collect();
    ComparedBand { title, words, reaches: reaches.collect(), angle_deg, figure: chart.document() }
}

/// Both ends of a band at a pose: `-0.15 mm to 0.14 mm`.
fn reach_words(ends: &[Vec<f64>; 2], pose: usize, curve: &DeviationCurve, writer: &NumberWriter) -> String {
    let [lower, upper] = [0, 1].map(|which| ends[which][pose]);
    if !lower.is_finite() || !upper.is_finite() {
        return "nothing known".to_owned();
    }
    let written = |value_si, rounding| writer.rounded(value_si, &curve.unit, DIGITS, rounding);
    format!("{} to {}", written(lower, Rounding::Down), written(upper, Rounding::Up))
}

/// Limits over the whole cycle: once where both studies require the same.
fn limits(
    [before, after]: [&StudyResult; 2],
    curve: &DeviationCurve,
    writer: &NumberWriter,
) -> Vec<(String, [f64; 2])> {
    let of = |result: &'_ StudyResult| -> Vec<(String, [f64; 2])> {
        let concerns = |requirement: &&RequirementOutcome| {
            requirement.output == curve.output && requirement.of == curve.of && requirement.at == ResponsePoint::Whole
        };
        let told = |requirement: &RequirementOutcome| {
            let words = requirement_words(result, requirement, &curve.unit, writer);
            (words, [requirement.lower_si, requirement.upper_si])
        };
        result.requirements.iter().filter(concerns).map(told).collect()
    };
    let (first, second) = (of(before), of(after));
    let named = |side: &str, (words, ends): &(String, [f64; 2])| (format!("required{side}: {words}"), *ends);
    let has = |list: &[(String, [f64; 2])], own: &(String, [f64; 2])| list.iter().any(|other| other.1 == own.1);
    let of_first = first.iter().map(|limit| named(if has(&second, limit) { "" } else { " in A" }, limit));
    let of_second = second.iter().filter(|limit| !has(&first, limit)).map(|limit| named(" in B", limit));
    of_first.chain(of_second).collect()
}

/// The angles of both curves, increasing; those of the second one are taken within the turn of the first.
fn angles(first: &DeviationCurve, second: &DeviationCurve) -> Vec<f64> {
    let from = first.pose_rad.first().copied().unwrap_or(0.0);
    let mut angles: Vec<f64> =
        first.pose_rad.iter().copied().chain(within(second, from).map(|(angle, _)| angle)).collect();
    angles.retain(|angle| angle.is_finite());
    angles.sort_by(f64::total_cmp);
    angles.dedup_by(|a, b| (*a - *b).abs() < SAME_ANGLE_RAD);
    angles
}

/// The poses of a curve with their angles in the turn that begins at `from_rad`. A curve of more than a turn stays as it is.
fn within(curve: &DeviationCurve, from_rad: f64) -> impl Iterator<Item = (f64, usize)> {
    let poses = &curve.pose_rad;
    let span = poses.last().copied().unwrap_or(0.0) - poses.first().copied().unwrap_or(0.0);
    let is_turn = span < TAU - SAME_ANGLE_RAD;
    let shifted = move |angle: f64| {
        let beyond = (angle - from_rad).rem_euclid(TAU);
        // What is a whole turn but for round-off is its beginning.
        if TAU - beyond < SAME_ANGLE_RAD { from_rad } else { from_rad + beyond }
    };
    poses.iter().enumerate().map(move |(pose, angle)| (if is_turn { shifted(*angle) } else { *angle }, pose))
}

/// Both ends of the band at these angles: between poses on the straight line between them, as drawn; unknown beyond the poses.
fn ends_at(curve: &DeviationCurve, angles: &[f64]) -> [Vec<f64>; 2] {
    let from = angles.first().copied().unwrap_or(0.0);
    let mut poses: Vec<(f64, usize)> = within(curve, from).collect();
    poses.sort_by(|a, b| a.0.total_cmp(&b.0));
    [&curve.mixed.lower_si, &curve.mixed.upper_si].map(|list| {
        let value = |place: usize| poses.get(place).and_then(|(_, pose)| list.get(*pose)).copied().unwrap_or(f64::NAN);
        let at = |angle: f64| {
            let after = poses.partition_point(|(own, _)| *own < angle - SAME_ANGLE_RAD);
            let Some((upper, _)) = poses.get(after) else { return f64::NAN };
            if (upper - angle).abs() <= SAME_ANGLE_RAD {
                return value(after);
            }
            let Some((lower, _)) = after.checked_sub(1).and_then(|before| poses.get(before)) else { return f64::NAN };
            let share = (angle - lower) / (upper - lower);
            (1.0 - share) * value(after - 1) + share * value(after)
        };
        angles.iter().map(|angle| at(*angle)).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use loosepin_result::study::{CurveRange, Deviation, Witness};
    use loosepin_text::units::SiUnit;

    fn curve(pose_deg: &[f64], upper_si: &[f64]) -> DeviationCurve {
        DeviationCurve {
            output: "slider".to_owned(),
            of: Deviation::Total,
            unit: SiUnit::LENGTH,
            probabilities: [0.025, 0.975],
            centre: Witness::new(),
            numerical_error_si: 0.0,
            confidence: None,
            pose_rad: pose_deg.iter().map(|angle| angle.to_radians()).collect(),
            ideal_si: Vec::new(),
            nominal_si: Vec::new(),
            random: CurveRange::default(),
            mixed: CurveRange { lower_si: upper_si.iter().map(|value| -value).collect(), upper_si: upper_si.to_vec() },
            simultaneous: Vec::new(),
            at_values: Vec::new(),
            path: None,
        }
    }

    /// The upper end in both curves at each of their angles, degrees.
    fn together(first: &DeviationCurve, second: &DeviationCurve) -> Vec<[f64; 3]> {
        let angles = angles(first, second);
        let both = [first, second].map(|curve| ends_at(curve, &angles));
        for [lower, upper] in &both {
            assert!(lower.iter().zip(upper).all(|(low, high)| *low == -high || low.is_nan() && high.is_nan()));
        }
        let each = angles.iter().enumerate();
        each.map(|(place, angle)| [angle.to_degrees(), both[0][1][place], both[1][1][place]]).collect()
    }

    fn assert_close(found: &[[f64; 3]], due: &[[f64; 3]]) {
        assert_eq!(found.len(), due.len(), "{found:?}");
        for (found, due) in found.iter().zip(due) {
            for (a, b) in found.iter().zip(due) {
                assert!((a - b).abs() < 1e-9 || a.is_nan() && b.is_nan(), "{found:?} {due:?}");
            }
        }
    }

    #[test]
    fn analytic_a_band_lies_straight_between_its_own_poses() {
        let first = curve(&[10.0, 20.0, 30.0, 40.0], &[1.0, 5.0, 2.0, 7.0]);
        let second = curve(&[10.0, 35.0], &[3.0, 8.0]);
        let due = [
            [10.0, 1.0, 3.0],
            [20.0, 5.0, 5.0],
            [30.0, 2.0, 7.0],
            [35.0, 4.5, 8.0],
            // Beyond its poses nothing is known of a band.
            [40.0, 7.0, f64::NAN],
        ];
        assert_close(&together(&first, &second), &due);
    }

    #[test]
    fn analytic_angles_of_another_turn_are_those_of_the_first() {
        let first = curve(&[30.0, 120.0, 210.0, 300.0], &[1.0, 2.0, 3.0, 4.0]);
        // 0° and 90° of the next turn, and a whole turn beyond the first pose but for round-off.
        let second = curve(&[-240.0, -150.0, 0.0, 30.0 - 1e-12], &[5.0, 6.0, 7.0, 8.0]);
        let due =
            [[30.0, 1.0, 8.0], [120.0, 2.0, 5.0], [210.0, 3.0, 6.0], [300.0, 4.0, 6.0 + 0.6], [360.0, f64::NAN, 7.0]];
        assert_close(&together(&first, &second), &due);
    }

    #[test]
    fn a_gap_of_a_band_stays_one() {
        let first = curve(&[0.0, 10.0, 20.0], &[1.0, f64::NAN, 3.0]);
        let second = curve(&[0.0, 5.0, 20.0], &[1.0, 1.0, 1.0]);
        assert_close(
            &together(&first, &second),
            &[[0.0, 1.0, 1.0], [5.0, f64::NAN, 1.0], [10.0, f64::NAN, 1.0], [20.0, 3.0, 1.0]],
        );
    }
}

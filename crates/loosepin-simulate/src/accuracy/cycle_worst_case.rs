//! The worst cases of a cycle, put into the record of its motion.

use super::accuracy_output::AccuracyOutputKind;
use super::play_reach::PlayReach;
use super::worst_case::{CycleOfPositions, CycleWorstCase, WeightedOutput, worst_over_cycle};
use loosepin_mechanics::mechanism::{IdealMotion, Mechanism, Sample};
use loosepin_mechanics::model::{Position, Values};
use loosepin_result::motion::{ClearanceAnswer, OutputMotion, UnprovenSpan, WitnessJoint, WorstCaseWitness};

/// Steps between positions are taken a little longer, so that round-off leaves no gap between them.
const OVERLAP: f64 = 1.0 + 1e-9;

/// A walked cycle of which the worst cases are asked.
pub(super) struct WalkedCycle<'c, 'a> {
    pub mechanism: &'c Mechanism,
    pub values: &'c Values,
    pub sample: &'c Sample<f64>,
    pub states: &'c [IdealMotion<'a>],
    pub drive_angle_rad: &'c [f64],
    pub reaches: &'c [PlayReach],
    pub readings: &'c [Position],
    pub parts: &'c [AccuracyOutputKind],
    /// Velocities of the positions at each state.
    pub velocities: Vec<Vec<f64>>,
    /// The joint of which the block may overhang its guide, at each state.
    pub overhanging: Vec<Option<String>>,
}

/// Coverage of the proofs in the record.
pub(super) struct ProofCoverage {
    pub unproven_spans: Vec<UnprovenSpan>,
    pub is_between_angles: bool,
}

/// Puts the worst cases into `outputs`, until `is_stopped`; `None` if it was stopped.
pub(super) fn add_worst_cases(
    cycle: &WalkedCycle<'_, '_>,
    outputs: &mut [OutputMotion],
    is_stopped: &dyn Fn() -> bool,
) -> Option<ProofCoverage> {
    let weighted: Vec<WeightedOutput> = cycle
        .parts
        .iter()
        .map(|part| WeightedOutput {
            weights: cycle.velocities.iter().map(|velocities| part.weights(velocities)).collect(),
            path: match *part {
                AccuracyOutputKind::Position(_) => None,
                AccuracyOutputKind::Along(coordinates) | AccuracyOutputKind::Normal(coordinates) => Some(coordinates),
            },
        })
        .collect();
    let driven_steps = driven_steps(cycle.mechanism, cycle.sample, cycle.states);
    let is_between_angles = driven_steps.is_some();
    let positions = CycleOfPositions {
        mechanism: cycle.mechanism,
        values: cycle.values,
        reaches: cycle.reaches,
        readings: cycle.readings,
        coordinates: cycle.states.iter().map(|state| state.coordinates()).collect(),
        driven_steps,
    };
    let CycleWorstCase { mut of_outputs, not_proven } = worst_over_cycle(&positions, &weighted, is_stopped)?;
    let reasons: Vec<Option<String>> = not_proven
        .iter()
        .zip(&cycle.overhanging)
        .map(|(coordinate, overhanging)| why_unproven(cycle.mechanism, *coordinate, overhanging.as_deref()))
        .collect();
    for (output, rows) in outputs.iter_mut().zip(&mut of_outputs) {
        let answer = &mut output.clearance;
        for (row, reason) in rows.iter_mut().zip(&reasons) {
            if reason.is_some() {
                row.proven_si = [f64::NEG_INFINITY, f64::INFINITY];
            }
            let [lowest, highest] = [0, 1].map(|side| row.found[side].deviation_si);
            answer.lowest_si.push(lowest);
            answer.highest_si.push(highest);
            // Zero has no sign here.
            answer.worst_case_si.push(f64::max(-lowest, highest) + 0.0);
            answer.proven_lowest_si.push(row.proven_si[0]);
            answer.proven_highest_si.push(row.proven_si[1]);
        }
        let found = |row: usize, side: usize| &rows[row].found[side];
        answer.witness =
            witness(cycle, answer, |row, side| found(row, side).displacements.iter().map(|e| [e.x, e.y]).collect());
    }
    Some(ProofCoverage { unproven_spans: spans(cycle.drive_angle_rad, &reasons), is_between_angles })
}

/// Half of the longest way of each drive from one position to the next, where all run at constant speed.
pub(super) fn driven_steps(
    mechanism: &Mechanism,
    sample: &Sample<f64>,
    states: &[IdealMotion<'_>],
) -> Option<Vec<f64>> {
    let times = states.windows(2).map(|pair| (pair[1].time_s() - pair[0].time_s()).abs());
    let half_s = 0.5 * times.fold(0.0, f64::max) * OVERLAP;
    let drives = mechanism.ideal.drives.iter();
    drives.map(|drive| sample.drives.constant_speed(*drive).map(|speed| speed * half_s)).collect()
}

/// Why no end is proven at a position where `coordinate` is known least and the block of a joint may overhang its guide; `None` if ends are.
pub(super) fn why_unproven(
    mechanism: &Mechanism,
    coordinate: Option<usize>,
    overhanging: Option<&str>,
) -> Option<String> {
    let tree = &mechanism.ideal;
    if tree.free < tree.constraint_rows() {
        return Some("joints are redundant, and the play determines which of them carry the load".to_owned());
    }
    if let Some(joint) = overhanging {
        return Some(format!("the block of '{joint}' may overhang an end of its guide"));
    }
    let coordinate = coordinate?;
    let link = tree.links.iter().find(|link| link.dependences.last().is_some_and(|last| last.coordinate == coordinate));
    let name = link.map_or("a part", |link| &mechanism.model.bodies[link.body.0].name);
    Some(format!("within the play, '{name}' comes close to a position from which it can continue in two ways"))
}

/// Angles in a row with the same words are one span.
fn spans(drive_angle_rad: &[f64], reasons: &[Option<String>]) -> Vec<UnprovenSpan> {
    let mut found: Vec<UnprovenSpan> = Vec::new();
    let mut last: Option<&str> = None;
    for (angle_rad, reason) in drive_angle_rad.iter().zip(reasons) {
        if let Some(words) = reason {
            match found.last_mut() {
                Some(span) if last == Some(words) => span.span_rad[1] = *angle_rad,
                _ => found.push(UnprovenSpan { span_rad: [*angle_rad; 2], words: words.clone() }),
            }
        }
        last = reason.as_deref();
    }
    found
}

/// The place of the largest deviation.
fn witness(
    cycle: &WalkedCycle<'_, '_>,
    answer: &ClearanceAnswer,
    displacements: impl Fn(usize, usize) -> Vec<[f64; 2]>,
) -> Option<WorstCaseWitness> {
    let worst = &answer.worst_case_si;
    let row = (0..worst.len()).max_by(|a, b| worst[*a].total_cmp(&worst[*b])).filter(|row| worst[*row] > 0.0)?;
    let side = usize::from(answer.highest_si[row] >= -answer.lowest_si[row]);
    let model = &cycle.mechanism.model;
    let names = cycle.mechanism.plays.iter().map(|play| model.play_name(*play).to_owned());
    let joints = names.zip(displacements(row, side));
    Some(WorstCaseWitness {
        drive_angle_rad: cycle.drive_angle_rad[row],
        deviation_si: [answer.lowest_si[row], answer.highest_si[row]][side],
        joints: joints.map(|(joint, displacement_si)| WitnessJoint { joint, displacement_si }).collect(),
    })
}

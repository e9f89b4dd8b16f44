//! The worst cases of a cycle, put into the record of its motion.

use super::accuracy_output::AccuracyOutputKind;
use super::cycle::SingularKind;
use super::play_reach::PlayReach;
use super::unproven::{Cause, UnprovenPositions};
use super::worst_case::{CycleOfPositions, CycleWorstCase, PathPart, WeightedOutput, worst_over_cycle};
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
    /// Angles of the drive at which the ideal mechanism is singular.
    pub change_points: Vec<(f64, SingularKind)>,
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
                AccuracyOutputKind::Along(coordinates) => Some(PathPart { coordinates, is_along: true }),
                AccuracyOutputKind::Normal(coordinates) => Some(PathPart { coordinates, is_along: false }),
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
    let CycleWorstCase { mut of_outputs, not_proven, .. } = worst_over_cycle(&positions, &weighted, is_stopped)?;
    let causes = not_proven.iter().zip(&cycle.overhanging);
    let unproven = UnprovenPositions {
        mechanism: cycle.mechanism,
        drive_angle_rad: cycle.drive_angle_rad,
        moved_by: "the play of the joints",
        causes: causes
            .map(|(not_proven, overhanging)| Cause::of(cycle.mechanism, *not_proven, overhanging.as_deref()))
            .collect(),
        change_points: &cycle.change_points,
    };
    for (output, rows) in outputs.iter_mut().zip(&mut of_outputs) {
        let answer = &mut output.clearance;
        for (row, overhanging) in rows.iter_mut().zip(&cycle.overhanging) {
            if overhanging.is_some() {
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
    Some(ProofCoverage { unproven_spans: unproven.spans(), is_between_angles })
}

/// At each position, half of the longest way of each drive to the next one, where all run at constant speed.
///
/// Where a position was left out, since branches cross there, the positions beside the gap have a longer way than the others.
pub(super) fn driven_steps(
    mechanism: &Mechanism,
    sample: &Sample<f64>,
    states: &[IdealMotion<'_>],
) -> Option<Vec<Vec<f64>>> {
    /// Steps that differ by no more are the same but for round-off.
    const SAME: f64 = 1.0 + 1e-6;
    let ways_s: Vec<f64> = states.windows(2).map(|pair| (pair[1].time_s() - pair[0].time_s()).abs()).collect();
    let shortest_s = ways_s.iter().copied().fold(f64::INFINITY, f64::min);
    let usual_s = ways_s.iter().copied().filter(|way_s| *way_s <= SAME * shortest_s).fold(0.0, f64::max);
    let longest_s = ways_s.iter().copied().fold(0.0, f64::max);
    let half_s = |row: usize| {
        let beside = &ways_s[row.saturating_sub(1)..(row + 1).min(ways_s.len())];
        let way_s = if beside.iter().all(|way_s| *way_s <= SAME * shortest_s) { usual_s } else { longest_s };
        0.5 * way_s * OVERLAP
    };
    let speeds: Vec<f64> =
        mechanism.ideal.drives.iter().map(|drive| sample.drives.constant_speed(*drive)).collect::<Option<_>>()?;
    Some((0..states.len()).map(|row| speeds.iter().map(|speed| speed * half_s(row)).collect()).collect())
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

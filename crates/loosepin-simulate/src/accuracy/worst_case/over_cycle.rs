//! The worst cases of all outputs over the positions of a cycle.

use super::super::loops::DisplacedLoops;
use super::super::play_reach::PlayReach;
use super::enclosure::{Encloser, Moving};
use super::search::{Objective, WorstPosition, best_of, starts_on_borders};
use super::upper_end::{Ends, Reference};
use super::variables::Variables;
use loosepin_math::Vec2;
use loosepin_mechanics::mechanism::Mechanism;
use loosepin_mechanics::model::{Position, Values};

/// Number of positions after which the search starts from the middle and from the borders of the play too, not only from the extremes at
/// the positions beside it.
const POSITIONS_BETWEEN_STARTS: usize = 12;
/// Extremes at neighbouring positions that are further apart than this share of the play are taken as starts for each other once more.
const SAME_PLACE: f64 = 0.3;

/// The cycle of a worst case.
pub(in super::super) struct CycleOfPositions<'c> {
    pub mechanism: &'c Mechanism,
    pub values: &'c Values,
    pub reaches: &'c [PlayReach],
    pub readings: &'c [Position],
    /// Coordinates of the ideal tree at each position, free ones first.
    pub coordinates: Vec<&'c [f64]>,
    /// Half the way of each driven coordinate from one position to the next, where drives run at constant speed: the proven ends then hold
    /// between positions too.
    pub driven_steps: Option<Vec<f64>>,
}

/// An output as a sum of positions.
#[derive(Debug, Clone)]
pub(in super::super) struct WeightedOutput {
    /// Which positions count, and how much, at each position of the cycle.
    pub weights: Vec<Vec<(usize, f64)>>,
    /// The coordinates of the path that it is an error of.
    pub path: Option<[usize; 2]>,
}

/// The worst case of one output at one position of the cycle.
#[derive(Debug, Clone)]
pub(in super::super) struct FoundAndProven {
    /// The lowest and the highest deviation that were found.
    pub found: [WorstPosition; 2],
    /// Ends that no deviation passes; infinite where none is proven.
    pub proven_si: [f64; 2],
}

/// The worst cases of `outputs` at all positions, output by output, and at which positions nothing is proven, with the coordinate that is
/// known least.
pub(in super::super) struct CycleWorstCase {
    pub of_outputs: Vec<Vec<FoundAndProven>>,
    pub not_proven: Vec<Option<usize>>,
}

/// Goes over the cycle until `is_stopped`; `None` if it was stopped.
pub(in super::super) fn worst_over_cycle(
    cycle: &CycleOfPositions<'_>,
    outputs: &[WeightedOutput],
    is_stopped: &dyn Fn() -> bool,
) -> Option<CycleWorstCase> {
    let found = found_over_cycle(cycle, outputs, is_stopped)?;
    let variables = Variables::new(cycle.reaches);
    let ends = Ends::new(variables.balls.clone(), 0, cycle.driven_steps.is_some(), Reference::SameParts);
    let moving = Moving {
        mechanism: cycle.mechanism,
        values: cycle.values,
        variables,
        dimensions: Vec::new(),
        driven_steps: cycle.driven_steps.clone(),
    };
    let mut encloser = Encloser::new(moving, cycle.readings.to_vec());
    let mut not_proven = Vec::with_capacity(cycle.coordinates.len());
    let mut of_outputs: Vec<Vec<FoundAndProven>> = found
        .into_iter()
        .map(|rows| {
            rows.into_iter()
                .map(|found| FoundAndProven { found, proven_si: [f64::NEG_INFINITY, f64::INFINITY] })
                .collect()
        })
        .collect();
    for (row, coordinates) in cycle.coordinates.iter().enumerate() {
        if is_stopped() {
            return None;
        }
        let enclosed = match encloser.enclose(coordinates) {
            Ok(enclosed) => enclosed,
            Err(failed) => {
                not_proven.push(Some(failed.coordinate));
                continue;
            }
        };
        not_proven.push(None);
        for (output, rows) in outputs.iter().zip(&mut of_outputs) {
            let weights = &output.weights[row];
            rows[row].proven_si = match (output.path, &weights[..]) {
                (Some(path), [(_, x), (_, y)]) => ends.of_path(&enclosed, path, [*x, *y]),
                _ => ends.of(&enclosed, weights),
            };
        }
    }
    Some(CycleWorstCase { of_outputs, not_proven })
}

/// `[lowest, highest]` of each output at each position.
fn found_over_cycle(
    cycle: &CycleOfPositions<'_>,
    outputs: &[WeightedOutput],
    is_stopped: &dyn Fn() -> bool,
) -> Option<Vec<Vec<[WorstPosition; 2]>>> {
    let mut loops = DisplacedLoops::new(cycle.mechanism, cycle.values);
    let middle = vec![Vec2::zero(); cycle.reaches.len()];
    let borders = starts_on_borders(cycle.reaches);
    let mut found: Vec<Vec<[WorstPosition; 2]>> = vec![Vec::new(); outputs.len()];
    let mut search = |row: usize, output: &WeightedOutput, starts: [&[&[Vec2<f64>]]; 2]| {
        loops.set_position(cycle.coordinates[row]);
        let objective = Objective { readings: cycle.readings, weights: &output.weights[row] };
        [0, 1].map(|side| best_of(&mut loops, objective, cycle.reaches, starts[side], [-1.0, 1.0][side]).0)
    };
    let rows = cycle.coordinates.len();
    for row in 0..rows {
        if is_stopped() {
            return None;
        }
        for (output, found) in outputs.iter().zip(&mut found) {
            let is_fresh = row % POSITIONS_BETWEEN_STARTS == 0;
            let both = [0, 1].map(|side| {
                let before = found.last().map(|before| before[side].displacements.as_slice());
                let fresh = is_fresh.then(|| std::iter::once(&middle).chain(&borders).map(Vec::as_slice));
                before.into_iter().chain(fresh.into_iter().flatten()).collect::<Vec<_>>()
            });
            let next = search(row, output, [&both[0], &both[1]]);
            found.push(next);
        }
    }
    // Back again: an extreme that began between two fresh starts is followed to where it began.
    for row in (0..rows.saturating_sub(1)).rev() {
        if is_stopped() {
            return None;
        }
        for (output, found) in outputs.iter().zip(&mut found) {
            let differs = [0, 1].map(|side| {
                let [here, behind] = [row, row + 1].map(|row| &found[row][side].displacements);
                cycle
                    .reaches
                    .iter()
                    .zip(here.iter().zip(behind))
                    .any(|(reach, (a, b))| reach.distance(*a, *b) > SAME_PLACE)
            });
            if !differs.contains(&true) {
                continue;
            }
            let starts = [0, 1].map(|side| {
                if differs[side] { vec![found[row + 1][side].displacements.as_slice()] } else { Vec::new() }
            });
            let again = search(row, output, [&starts[0], &starts[1]]);
            for (side, again) in again.into_iter().enumerate() {
                let own = &mut found[row][side];
                if again.deviation_si.abs() > own.deviation_si.abs() {
                    *own = again;
                }
            }
        }
    }
    Some(found)
}

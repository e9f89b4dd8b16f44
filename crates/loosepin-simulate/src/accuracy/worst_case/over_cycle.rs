//! The worst cases of all outputs over the positions of a cycle.

use super::super::dead_centre::dead_centre;
use super::super::loops::DisplacedLoops;
use super::super::play_reach::PlayReach;
use super::enclosure::{Encloser, Moving, NotEnclosed};
use super::path_part::PathPart;
use super::positions::{Positions, ends_around};
use super::search::{Objective, WorstPosition, best_across, best_of, starts_on_borders};
use super::upper_end::Ends;
use super::variables::Variables;
use loosepin_math::Vec2;
use loosepin_mechanics::mechanism::Mechanism;
use loosepin_mechanics::model::{Position, Values};
use loosepin_result::study::Reference;

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
    /// At each position, half the way of each driven coordinate to the next, where drives run at constant speed: the proven ends then hold
    /// between positions too.
    pub driven_steps: Option<Vec<Vec<f64>>>,
}

/// An output as a sum of positions.
#[derive(Debug, Clone)]
pub(in super::super) struct WeightedOutput {
    /// Which positions count, and how much, at each position of the cycle.
    pub weights: Vec<Vec<(usize, f64)>>,
    /// The path that it is an error of.
    pub path: Option<PathPart>,
}

/// The worst case of one output at one position of the cycle.
#[derive(Debug, Clone)]
pub(in super::super) struct FoundAndProven {
    /// The lowest and the highest deviation that were found.
    pub found: [WorstPosition; 2],
    /// Ends that no deviation passes; infinite where none is proven.
    pub proven_si: [f64; 2],
}

/// The worst cases of `outputs` at all positions, output by output, and at which positions nothing is proven.
pub(in super::super) struct CycleWorstCase {
    pub of_outputs: Vec<Vec<FoundAndProven>>,
    pub not_proven: Vec<Option<NotProven>>,
    /// Positions of which a proof was tried: the work that was done.
    #[cfg(test)]
    pub proofs: usize,
}

/// A position at which nothing is proven.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) struct NotProven {
    /// The coordinate that moves most where the loops give way; `None` where it was not determined, or they are regular and an end stays open all the same.
    pub coordinate: Option<usize>,
    /// Whether play was found to take the mechanism to a dead centre. The worst case that was found is then that of both assemblies.
    pub reaches_dead_centre: bool,
}

impl NotProven {
    /// Of positions that were not enclosed.
    pub fn of(failed: NotEnclosed) -> Self {
        Self { coordinate: failed.coordinate, reaches_dead_centre: false }
    }

    /// Of ends of which some stay open; `None` if none does.
    pub fn of_ends(ends: &[[f64; 2]]) -> Option<Self> {
        let is_open = ends.iter().flatten().any(|end| !end.is_finite());
        is_open.then_some(Self { coordinate: None, reaches_dead_centre: false })
    }
}

/// The lowest and the highest deviation of `output` that are found at each position, in both assemblies where `not_proven` says that nothing is
/// proven, until `is_stopped`; `None` if it was stopped.
pub(in super::super) fn found_in_both_assemblies(
    cycle: &CycleOfPositions<'_>,
    output: WeightedOutput,
    not_proven: &mut [Option<NotProven>],
    is_stopped: &dyn Fn() -> bool,
) -> Option<Vec<[WorstPosition; 2]>> {
    let outputs = [output];
    let mut found = found_over_cycle(cycle, &outputs, is_stopped)?;
    let is_finished = search_across(cycle, &outputs, &mut found, not_proven, is_stopped);
    found.pop().filter(|_| is_finished)
}

/// Goes over the cycle until `is_stopped`; `None` if it was stopped.
pub(in super::super) fn worst_over_cycle(
    cycle: &CycleOfPositions<'_>,
    outputs: &[WeightedOutput],
    is_stopped: &dyn Fn() -> bool,
) -> Option<CycleWorstCase> {
    let mut found = found_over_cycle(cycle, outputs, is_stopped)?;
    let variables = Variables::new(cycle.reaches);
    let ends = Ends::new(variables.balls.clone(), 0, cycle.driven_steps.is_some(), Reference::SameParts);
    let moving = Moving {
        mechanism: cycle.mechanism,
        values: cycle.values,
        variables,
        dimensions: Vec::new(),
        driven_steps: cycle.driven_steps.as_ref().map(|_| Vec::new()),
    };
    let mut encloser = Encloser::new(moving, cycle.readings.to_vec());
    let mut not_proven = Vec::with_capacity(cycle.coordinates.len());
    let mut proven = vec![vec![[f64::NEG_INFINITY, f64::INFINITY]; cycle.coordinates.len()]; outputs.len()];
    // Where joints repeat each other nothing is proven, whatever the loops are.
    let is_provable = !cycle.mechanism.ideal.is_redundant();
    #[cfg(test)]
    let mut proofs = 0;
    for (row, coordinates) in cycle.coordinates.iter().enumerate() {
        if is_stopped() {
            return None;
        }
        if !is_provable {
            not_proven.push(Some(NotProven { coordinate: None, reaches_dead_centre: false }));
            continue;
        }
        #[cfg(test)]
        {
            proofs += 1;
        }
        encloser.take_steps(cycle.driven_steps.as_ref().map(|steps| steps[row].as_slice()));
        let of_output = |positions: &Positions, output: &WeightedOutput| match (output.path, &output.weights[row][..]) {
            (Some(path), [(_, x), (_, y)]) => ends.of_path(positions, path, [*x, *y]),
            (_, weights) => ends.of(positions, weights),
        };
        let ends_of = |positions: &Positions| outputs.iter().map(|output| of_output(positions, output)).collect();
        match ends_around(&mut encloser, coordinates, ends_of) {
            Ok(all) => {
                not_proven.push(NotProven::of_ends(&all));
                proven.iter_mut().zip(all).for_each(|(rows, ends)| rows[row] = ends);
            }
            Err(failed) => not_proven.push(Some(NotProven::of(failed))),
        }
    }
    // Where joints repeat each other, the rows that are solved are no measure of how regular the loops are.
    let is_finished = !is_provable || search_across(cycle, outputs, &mut found, &mut not_proven, is_stopped);
    let of_output = |(found, proven): (Vec<[WorstPosition; 2]>, Vec<[f64; 2]>)| {
        found.into_iter().zip(proven).map(|(found, proven_si)| FoundAndProven { found, proven_si }).collect()
    };
    is_finished.then(|| CycleWorstCase {
        of_outputs: found.into_iter().zip(proven).map(of_output).collect(),
        not_proven,
        #[cfg(test)]
        proofs,
    })
}

/// Searches the other assembly too wherever nothing is proven and play reaches a dead centre; `false` if it was stopped.
fn search_across(
    cycle: &CycleOfPositions<'_>,
    outputs: &[WeightedOutput],
    found: &mut [Vec<[WorstPosition; 2]>],
    not_proven: &mut [Option<NotProven>],
    is_stopped: &dyn Fn() -> bool,
) -> bool {
    let mut loops = DisplacedLoops::new(cycle.mechanism, cycle.values);
    let borders = starts_on_borders(cycle.reaches);
    let mut before: Vec<Option<[WorstPosition; 2]>> = vec![None; outputs.len()];
    for (row, not_proven) in not_proven.iter_mut().enumerate() {
        let Some(not_proven) = not_proven else { continue };
        if is_stopped() {
            return false;
        }
        loops.set_position(cycle.coordinates[row]);
        let Some(dead_centre) = dead_centre(&mut loops, cycle.reaches) else { continue };
        not_proven.reaches_dead_centre = true;
        let Some(other) = dead_centre.other else { continue };
        for (number, (output, rows)) in outputs.iter().zip(found.iter_mut()).enumerate() {
            let objective = Objective { readings: cycle.readings, weights: &output.weights[row] };
            let across = [0, 1].map(|side| {
                let last = before[number].as_ref().map(|before| before[side].displacements.as_slice());
                let starts = std::iter::once(other.displacements.as_slice()).chain(last);
                let starts: Vec<&[Vec2<f64>]> = starts.chain(borders.iter().map(Vec::as_slice)).collect();
                best_across(&mut loops, &other, objective, cycle.reaches, &starts, [-1.0, 1.0][side])
            });
            for (own, across) in rows[row].iter_mut().zip(&across) {
                if across.deviation_si.abs() > own.deviation_si.abs() {
                    *own = across.clone();
                }
            }
            before[number] = Some(across);
        }
    }
    true
}

/// `[lowest, highest]` of each output at each position, in the assembly of the cycle.
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

#[cfg(test)]
mod tests {
    use super::*;
    use loosepin_mechanics::mechanism::{IdealMotion, Sample};
    use loosepin_mechanics::model::Model;

    /// Thirteen pins, each held by a guide and by its hole: 13 constraints too many.
    const STRIKERS: &str = include_str!("../../../tests/files/mend/slow_motion.toml");

    /// A model, its values, the reaches of its plays and its coordinates in the ideal position.
    struct AtStart<'a> {
        mechanism: &'a Mechanism,
        values: &'a Values,
        reaches: &'a [PlayReach],
        coordinates: Vec<f64>,
    }

    impl AtStart<'_> {
        fn loops(&self) -> DisplacedLoops<'_> {
            let mut loops = DisplacedLoops::new(self.mechanism, self.values);
            loops.set_position(&self.coordinates);
            loops
        }
    }

    fn at_start<R>(text: &str, of: impl FnOnce(AtStart<'_>) -> R) -> R {
        let model = Model::from_text("model.toml", text).expect("the model is sound");
        let values = model.quantities.nominal();
        let mechanism = Mechanism::new(&model, &values).expect("it can be built");
        let sample = Sample::new(&mechanism, &values).expect("the values fit");
        let reaches = PlayReach::of_sample(&mechanism, &sample, sample.plays.iter().map(|_| 0.0)).expect("pins");
        let ideal = IdealMotion::new(&mechanism, &sample.ideal, &sample.drives).expect("it closes");
        let coordinates = ideal.coordinates().to_vec();
        of(AtStart { mechanism: &mechanism, values: &values, reaches: &reaches, coordinates })
    }

    /// Work on one position of a model: proofs that were tried, and Newton steps for one displacement that no loop can follow.
    fn work(text: &str) -> (usize, usize) {
        at_start(text, |at| {
            let readings: Vec<Position> =
                crate::accuracy::position_outputs(at.mechanism).into_iter().map(|output| output.reading).collect();
            let cycle = CycleOfPositions {
                mechanism: at.mechanism,
                values: at.values,
                reaches: at.reaches,
                readings: &readings,
                coordinates: vec![&at.coordinates; 3],
                driven_steps: None,
            };
            let output = WeightedOutput { weights: vec![vec![(0, 1.0)]; 3], path: None };
            let worst = worst_over_cycle(&cycle, &[output], &|| false).expect("nobody stops it");
            let mut loops = at.loops();
            let borders = starts_on_borders(at.reaches);
            let before = loops.newton_steps();
            let _ = loops.displace(&borders[1]);
            (worst.proofs, loops.newton_steps() - before)
        })
    }

    #[test]
    fn no_proof_is_tried_and_no_step_repeated_where_joints_repeat_each_other() {
        let (proofs, newton_steps) = work(STRIKERS);
        assert_eq!(proofs, 0, "what comes of it would be thrown away");
        // Eleven parts of a way, each given up in the step after the one that solves the rows that can be: not in the twelfth.
        assert!(newton_steps <= 11 * 4, "{newton_steps}");
        let slider_crank = include_str!("../../../tests/files/mend/dead_centre.toml");
        assert_eq!(work(slider_crank).0, 3);
    }

    /// A pantograph folded flat: all four pins in one line to 1e-9 rad. Whether loops close there is decided by round-off, also for parts of a
    /// way of 1e-6 and less.
    #[test]
    fn a_walk_to_a_dead_centre_ends_where_only_the_shortest_parts_close() {
        let steps = at_start(include_str!("../../../tests/files/mend/folded_pantograph.toml"), |at| {
            let mut loops = at.loops();
            let before = loops.newton_steps();
            dead_centre(&mut loops, at.reaches);
            loops.newton_steps() - before
        });
        assert!(steps > 0 && steps <= 5 * 128 * 12, "{steps}");
    }
}

//! A mechanism in space as a function from uncertain inputs to numbers: its loops are closed at each position, without dynamics.
//!
//! Play lets an output be anywhere between two ends at a position, whatever it is at others. So each column is an interval, by the arithmetic
//! of intervals over the positions, and the input `play` in [-1, 1] is the place in it:
//!
//! ```text
//! column = lower + (upper - lower) (1 + play)/2
//! ```

use crate::file::{Deviation, MAX_POSES, Reduction, Study};
use crate::response::columns::{ColumnPlan, Location, StudyColumn};
use crate::response::extras::RunExtras;
use crate::response::input_targets::{InputTargets, in_the_middle};
use crate::response::limits::MAX_COLUMNS;
use crate::response::outputs::OutputSource;
use crate::response::planar_response::{POSE_ROUND_OFF, check_poses, check_turns};
use crate::response::problem::PrepareError;
use loosepin_mechanics::model::CycleSpan;
use loosepin_simulate::RunFailure;
use loosepin_space::{PlaySide, SampledPart, SamplingError, SpatialModel, TurnSample, TurnSampler};
use loosepin_text::numbers::{QuantityError, QuantityId, QuantityTable, Values};

/// A prepared study of a mechanism in space.
#[derive(Debug)]
pub struct SpatialResponse {
    /// Columns of a run.
    pub plan: ColumnPlan,
    /// Nominal values with the epistemic inputs in the middle.
    pub nominal: Values,
    /// Nominal ideal value of each column's output at its pose; NaN for reduced columns.
    pub nominal_at_pose: Vec<f64>,
    /// Turns that are looked at.
    pub recorded_turns: f64,
    targets: InputTargets,
    quantities: QuantityTable,
    sampler: TurnSampler,
    /// Places at which the motion is looked at.
    places: usize,
    /// Those of the cycle, with their weights in means; other places are poses that are asked for alone.
    grid: Vec<(usize, f64)>,
    /// The part that each column reads, and the places that it needs.
    reads: Vec<Read>,
}

/// What a column reads.
#[derive(Debug, Clone, Copy)]
struct Read {
    part: usize,
    /// The place of a pose; `None` for the whole cycle.
    place: Option<usize>,
}

/// The ends between which play lets a number be.
#[derive(Debug, Clone, Copy)]
struct Ends {
    lower: f64,
    upper: f64,
}

impl SpatialResponse {
    /// Prepares a study of `model`.
    ///
    /// # Errors
    /// The nominal mechanism does not close over the turn; more columns than a study can bound.
    pub fn new(study: &Study, model: &SpatialModel) -> Result<Self, PrepareError> {
        let nominal = model.quantities.evaluate(&in_the_middle(study))?;
        let input = study.model.input(study.cycle.span, &nominal);
        if input.speed_rad_s == 0.0 {
            return Err(RunFailure::StandsStill { drive: input.name }.into());
        }
        let plan = ColumnPlan::new(study, input.start_rad, input.speed_rad_s.signum());
        if plan.columns.len() > MAX_COLUMNS {
            return Err(PrepareError::TooManyColumns { columns: plan.columns.len() });
        }
        check_turns(study.cycle.transient_turns, study.cycle.recorded_turns)?;
        check_poses(study, &plan)?;
        check_drives(study, model)?;
        let recorded_turns = study.cycle.recorded_turns;
        let poses = (recorded_turns * study.cycle.samples_per_turn as f64).round().max(1.0);
        if poses > MAX_POSES as f64 {
            return Err(PrepareError::TooManyPoses { poses });
        }
        let Places { turns, grid } = Places::new(recorded_turns, poses as usize, &plan);
        let mut parts: Vec<SampledPart> = Vec::new();
        let mut reads = Vec::with_capacity(plan.columns.len());
        for column in &plan.columns {
            let output = &plan.outputs[column.output];
            // Every column has its place in `reads`: none is left out.
            let OutputSource::InSpace(own) = output.seen else {
                return Err(
                    RunFailure::NoPosition { why: format!("output '{}' is not one of space", output.name) }.into()
                );
            };
            let part = parts.iter().position(|known| *known == own).unwrap_or_else(|| {
                parts.push(own);
                parts.len() - 1
            });
            let place = match column.spot {
                Location::Pose { turns: at, .. } => Some(nearest(&turns, at)),
                Location::Reduced(_) => None,
            };
            reads.push(Read { part, place });
        }
        let sampler =
            TurnSampler::new(model, &nominal, &turns, &parts).and_then(|own| own.with_play_side(PlaySide::Exact));
        let sampler = sampler.map_err(failure)?;
        let ideal = &sampler.nominal().ideal_si;
        let at_pose = |read: &Read| read.place.map_or(f64::NAN, |place| ideal[read.part * turns.len() + place]);
        Ok(Self {
            nominal_at_pose: reads.iter().map(at_pose).collect(),
            places: turns.len(),
            grid,
            targets: InputTargets::new(study),
            quantities: model.quantities.clone(),
            plan,
            nominal,
            recorded_turns,
            sampler,
            reads,
        })
    }

    /// The values of the model for these inputs.
    ///
    /// # Errors
    /// A value breaks its rule.
    pub fn values(&self, random: &[f64], epistemic: &[f64]) -> Result<Values, QuantityError> {
        self.targets.values(&self.quantities, random, epistemic)
    }

    /// The row of a run: its columns, then its extras.
    ///
    /// # Errors
    /// A value breaks its rule; the loops do not close.
    pub fn row(&self, random: &[f64], epistemic: &[f64]) -> Result<Vec<f64>, RunFailure> {
        let values = self.values(random, epistemic).map_err(|error| RunFailure::Sample(error.into()))?;
        let sample = self.sampler.sample(&values).map_err(failure)?;
        let share = 0.5 * (1.0 + self.targets.play(epistemic));
        let column = |(read, column): (&Read, &StudyColumn)| {
            let ends = self.ends(&sample, read, column.deviation, column.spot);
            ends.lower + (ends.upper - ends.lower) * share
        };
        let mut row: Vec<f64> = self.reads.iter().zip(&self.plan.columns).map(column).collect();
        let extras = RunExtras {
            energy_residual: f64::NAN,
            evaluations: 0.0,
            steps: self.places as f64,
            change_over_last_turn: f64::NAN,
            joints: Vec::new(),
        };
        extras.write(&mut row);
        Ok(row)
    }

    fn ends(&self, sample: &TurnSample, read: &Read, of: Deviation, spot: Location) -> Ends {
        let at = |place: usize| {
            let own = read.part * self.places + place;
            match of {
                Deviation::Value => Ends {
                    lower: sample.ideal_si[own] + sample.smallest_si[own],
                    upper: sample.ideal_si[own] + sample.largest_si[own],
                },
                Deviation::Dimensional => {
                    Ends { lower: sample.from_nominal_si[own], upper: sample.from_nominal_si[own] }
                }
                Deviation::Clearance => Ends { lower: sample.smallest_si[own], upper: sample.largest_si[own] },
                Deviation::Total => {
                    Ends { lower: sample.smallest_from_nominal_si[own], upper: sample.largest_from_nominal_si[own] }
                }
            }
        };
        match (read.place, spot) {
            (None, Location::Reduced(reduction)) => {
                reduced(reduction, self.grid.iter().map(|&(place, weight)| (at(place), weight)))
            }
            (place, _) => at(place.unwrap_or_default()),
        }
    }
}

/// Places at which a motion is looked at, in turns, and those of the cycle among them with their weights.
struct Places {
    turns: Vec<f64>,
    grid: Vec<(usize, f64)>,
}

impl Places {
    /// `rows` steps over the recorded turns, and the poses that are asked for between them.
    fn new(recorded_turns: f64, rows: usize, plan: &ColumnPlan) -> Self {
        // A whole number of turns ends where it began; what does not has half the weight at its ends.
        let is_closed = recorded_turns.fract() == 0.0;
        let last = rows - usize::from(is_closed);
        let of_cycle: Vec<f64> = (0..=last).map(|row| recorded_turns * row as f64 / rows as f64).collect();
        let asked = plan.columns.iter().filter_map(|column| match column.spot {
            Location::Pose { turns, .. } => Some(turns),
            Location::Reduced(_) => None,
        });
        let is_new = |turns: &f64| (of_cycle[nearest(&of_cycle, *turns)] - turns).abs() > POSE_ROUND_OFF;
        let mut turns: Vec<f64> = of_cycle.iter().copied().chain(asked.filter(is_new)).collect();
        turns.sort_by(f64::total_cmp);
        turns.dedup();
        let weight = |row: usize| if !is_closed && (row == 0 || row == last) { 0.5 } else { 1.0 };
        let grid = of_cycle.iter().enumerate().map(|(row, at)| (nearest(&turns, *at), weight(row))).collect();
        Self { turns, grid }
    }
}

/// The place of `turns`, which ascend, that is nearest to `at`.
fn nearest(turns: &[f64], at: f64) -> usize {
    let above = turns.partition_point(|known| *known < at);
    let distance = |place: usize| turns.get(place).map_or(f64::INFINITY, |known| (known - at).abs());
    let below = above.saturating_sub(1);
    if distance(below) <= distance(above) { below } else { above }
}

/// Every sample must have its drives at the same places.
fn check_drives(study: &Study, model: &SpatialModel) -> Result<(), PrepareError> {
    let random = study.random.iter().map(|input| (&input.path, input.quantity));
    let epistemic = study.epistemic.iter().filter_map(|input| Some((&input.path, input.quantity()?)));
    let counted = match study.cycle.span {
        CycleSpan::Turns(drive) | CycleSpan::Periods(drive) => Some(drive.0),
        CycleSpan::Duration(_) => None,
    };
    for (path, quantity) in random.chain(epistemic) {
        let depends = |id: QuantityId| model.quantities.depends_on(id, quantity);
        if model.drives.iter().any(|drive| depends(drive.start)) {
            return Err(PrepareError::UncertainStart { path: path.clone() });
        }
        // Alone, the drive that the cycle counts is at the same places at any speed.
        let is_free = counted.is_some() && model.drives.len() == 1;
        let is_duration = matches!(study.cycle.span, CycleSpan::Duration(duration) if depends(duration));
        if is_duration || !is_free && model.drives.iter().any(|drive| depends(drive.speed)) {
            return Err(PrepareError::UncertainDrive { path: path.clone() });
        }
    }
    Ok(())
}

/// A number of the curve, each position anywhere between its ends; with the weight of each position in means.
fn reduced(reduction: Reduction, all: impl Iterator<Item = (Ends, f64)> + Clone) -> Ends {
    let (no_less, no_more) = (f64::NEG_INFINITY, f64::INFINITY);
    let highest = |of: fn(Ends) -> f64| all.clone().map(|(ends, _)| of(ends)).fold(no_less, f64::max);
    let lowest = |of: fn(Ends) -> f64| all.clone().map(|(ends, _)| of(ends)).fold(no_more, f64::min);
    let weights: f64 = all.clone().map(|(_, weight)| weight).sum();
    let mean = |of: fn(Ends) -> f64| all.clone().map(|(ends, weight)| weight * of(ends)).sum::<f64>() / weights;
    let mean_square =
        |of: fn(Ends) -> f64| all.clone().map(|(ends, weight)| weight * of(ends).powi(2)).sum::<f64>() / weights;
    // Nearest to zero, and farthest from it.
    let near: fn(Ends) -> f64 = |ends| ends.lower.max(-ends.upper).max(0.0);
    let far: fn(Ends) -> f64 = |ends| ends.upper.max(-ends.lower);
    let lower: fn(Ends) -> f64 = |ends| ends.lower;
    let upper: fn(Ends) -> f64 = |ends| ends.upper;
    match reduction {
        Reduction::Maximum => Ends { lower: highest(lower), upper: highest(upper) },
        Reduction::Minimum => Ends { lower: lowest(lower), upper: lowest(upper) },
        Reduction::MaximumAbsolute => Ends { lower: highest(near), upper: highest(far) },
        Reduction::RootMeanSquare => Ends { lower: mean_square(near).sqrt(), upper: mean_square(far).sqrt() },
        Reduction::Mean => Ends { lower: mean(lower), upper: mean(upper) },
        Reduction::Range => {
            Ends { lower: (highest(lower) - lowest(upper)).max(0.0), upper: highest(upper) - lowest(lower) }
        }
    }
}

fn failure(error: SamplingError) -> RunFailure {
    RunFailure::NoPosition { why: error.to_string() }
}

#[cfg(test)]
mod tests {
    use super::{Ends, reduced};
    use crate::file::Reduction;

    /// Two positions, each anywhere in its interval: every reduction against a grid of all places.
    #[test]
    fn analytic_reductions_of_intervals_are_those_of_all_curves() {
        let all = [Ends { lower: -0.4, upper: 0.1 }, Ends { lower: 0.2, upper: 0.5 }, Ends { lower: -0.1, upper: 0.3 }];
        const STEPS: usize = 20;
        let place = |ends: &Ends, k: usize| ends.lower + (ends.upper - ends.lower) * k as f64 / STEPS as f64;
        for reduction in Reduction::ALL {
            let mut found = [f64::INFINITY, f64::NEG_INFINITY];
            for k in 0..(STEPS + 1).pow(3) {
                let steps = [k % (STEPS + 1), k / (STEPS + 1) % (STEPS + 1), k / (STEPS + 1).pow(2)];
                let curve: Vec<f64> = all.iter().zip(steps).map(|(ends, k)| place(ends, k)).collect();
                let max = curve.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                let min = curve.iter().copied().fold(f64::INFINITY, f64::min);
                let value = match reduction {
                    Reduction::Maximum => max,
                    Reduction::Minimum => min,
                    Reduction::MaximumAbsolute => max.max(-min),
                    Reduction::RootMeanSquare => (curve.iter().map(|y| y * y).sum::<f64>() / 3.0).sqrt(),
                    Reduction::Mean => curve.iter().sum::<f64>() / 3.0,
                    Reduction::Range => max - min,
                };
                found = [found[0].min(value), found[1].max(value)];
            }
            let ends = reduced(reduction, all.into_iter().map(|ends| (ends, 1.0)));
            let is_near = |a: f64, b: f64| (a - b).abs() < 0.02;
            assert!(is_near(ends.lower, found[0]) && is_near(ends.upper, found[1]), "{reduction:?} {ends:?} {found:?}");
        }
    }
}

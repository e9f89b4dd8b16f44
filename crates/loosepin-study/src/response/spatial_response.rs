//! A mechanism in space as a function from uncertain inputs to numbers: its loops are closed at each position, without dynamics.
//!
//! Play lets an output be anywhere between two ends at a position, whatever it is at others. So each column is an interval, by the arithmetic
//! of intervals over the positions, and the input `play` in [-1, 1] is the place in it:
//!
//! ```text
//! column = lower + (upper - lower) (1 + play)/2
//! ```

use crate::file::{Deviation, Reduction, Study};
use crate::response::columns::{ColumnPlan, Location, StudyColumn};
use crate::response::extras::RunExtras;
use crate::response::input_targets::{InputTargets, in_the_middle};
use crate::response::limits::MAX_COLUMNS;
use crate::response::outputs::OutputSource;
use crate::response::problem::PrepareError;
use loosepin_simulate::RunFailure;
use loosepin_space::{PlaySide, SampledPart, SamplingError, SpatialModel, TurnSample, TurnSampler};
use loosepin_text::numbers::{QuantityError, QuantityTable, Values};

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
    /// Places at which the turn is looked at.
    places: usize,
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
        let recorded_turns = study.cycle.recorded_turns;
        let rows = (recorded_turns * study.cycle.samples_per_turn as f64).round().max(1.0) as usize;
        // The cycle first, then poses that are asked for between its positions.
        let mut turns: Vec<f64> = (0..rows).map(|row| recorded_turns * row as f64 / rows as f64).collect();
        let asked = plan.columns.iter().filter_map(|column| match column.spot {
            Location::Pose { turns, .. } => Some(turns),
            Location::Reduced(_) => None,
        });
        turns.extend(asked);
        turns.sort_by(f64::total_cmp);
        turns.dedup();
        let mut parts: Vec<SampledPart> = Vec::new();
        let mut reads = Vec::with_capacity(plan.columns.len());
        for column in &plan.columns {
            let OutputSource::InSpace(own) = plan.outputs[column.output].seen else { continue };
            let part = parts.iter().position(|known| *known == own).unwrap_or_else(|| {
                parts.push(own);
                parts.len() - 1
            });
            let place = match column.spot {
                Location::Pose { turns: at, .. } => Some(turns.partition_point(|known| *known < at)),
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
            (None, Location::Reduced(reduction)) => reduced(reduction, (0..self.places).map(at)),
            (place, _) => at(place.unwrap_or_default()),
        }
    }
}

/// A number of the curve, each position anywhere between its ends.
fn reduced(reduction: Reduction, all: impl Iterator<Item = Ends> + Clone) -> Ends {
    let (no_less, no_more) = (f64::NEG_INFINITY, f64::INFINITY);
    let highest = |of: fn(Ends) -> f64| all.clone().map(of).fold(no_less, f64::max);
    let lowest = |of: fn(Ends) -> f64| all.clone().map(of).fold(no_more, f64::min);
    let mean = |of: fn(Ends) -> f64| all.clone().map(of).sum::<f64>() / all.clone().count() as f64;
    // Nearest to zero, and farthest from it.
    let near: fn(Ends) -> f64 = |ends| ends.lower.max(-ends.upper).max(0.0);
    let far: fn(Ends) -> f64 = |ends| ends.upper.max(-ends.lower);
    let lower: fn(Ends) -> f64 = |ends| ends.lower;
    let upper: fn(Ends) -> f64 = |ends| ends.upper;
    match reduction {
        Reduction::Maximum => Ends { lower: highest(lower), upper: highest(upper) },
        Reduction::Minimum => Ends { lower: lowest(lower), upper: lowest(upper) },
        Reduction::MaximumAbsolute => Ends { lower: highest(near), upper: highest(far) },
        Reduction::RootMeanSquare => {
            let square_of = |of: fn(Ends) -> f64| {
                all.clone().map(|ends| of(ends).powi(2)).sum::<f64>() / all.clone().count() as f64
            };
            Ends { lower: square_of(near).sqrt(), upper: square_of(far).sqrt() }
        }
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
            let ends = reduced(reduction, all.into_iter());
            let is_near = |a: f64, b: f64| (a - b).abs() < 0.02;
            assert!(is_near(ends.lower, found[0]) && is_near(ends.upper, found[1]), "{reduction:?} {ends:?} {found:?}");
        }
    }
}

//! A surrogate along one of its inputs, with the runs that it learned from.

use super::plan::SurrogatePlan;
use super::results::GroupBounds;
use super::space::SurrogateInput;
use crate::data::direction::range_of;
use crate::data::table::{Purpose, SampleTable};
use loosepin_math::sort_ascending;

/// Values at which the surrogate is drawn.
const DRAWN: usize = 61;
/// Values at which it is asked which input matters most.
const ASKED: usize = 9;

/// The surrogate of one column along one input, all others in the middle of the training runs (their medians).
#[derive(Debug, Clone, PartialEq)]
pub struct SurrogateSection {
    /// Position of the column within its group: where the held-out error is largest.
    pub place: usize,
    /// The input along which the surrogate goes furthest; the last one where it goes nowhere.
    pub input: SurrogateInput,
    /// Value of the input and of the column of each training run, the latter moved along the surrogate to the middle of the others.
    pub runs: Vec<[f64; 2]>,
    /// Value of the input, of the surrogate, and by how much it is taken to err.
    pub line: Vec<[f64; 3]>,
}

impl SurrogatePlan {
    /// The section of the surrogates of one group in one combination of the members of lists; `None` if none was learned.
    pub fn section(&self, group: &GroupBounds, combination: usize, table: &SampleTable) -> Option<SurrogateSection> {
        let surrogate = group.learned.surrogates.as_ref().ok()?.get(combination)?;
        let along = &surrogate.outputs().first()?.quality.rms_along;
        let place = (0..along.len()).fold(0, |most, place| if along[place] > along[most] { place } else { most });
        let column = group.learned.group.columns[place];
        let runs: Vec<(Vec<f64>, f64)> = (0..table.len())
            .filter(|&run| table.inputs()[run].purpose == Purpose::Training)
            .filter(|&run| self.space.combination(&table.inputs()[run].epistemic) == combination)
            .map(|run| {
                let inputs = &table.inputs()[run];
                (self.space.point(&inputs.random, &inputs.epistemic), table.values(run)[column])
            })
            .filter(|(_, value)| value.is_finite())
            .collect();
        let inputs = self.space.coordinates();
        let sorted = |axis: usize| {
            let mut values: Vec<f64> = runs.iter().map(|(point, _)| point[axis]).collect();
            sort_ascending(&mut values);
            values
        };
        let sorted: Vec<Vec<f64>> = (0..inputs.len()).map(sorted).collect();
        let middle: Vec<f64> = sorted.iter().map(|values| values[values.len() / 2]).collect();
        let at = |axis: usize, value: f64| {
            let mut point = middle.clone();
            point[axis] = value;
            let answer = surrogate.predict(&point).ok()?.into_iter().next()?;
            Some((answer.values[place], answer.deviations[place]))
        };
        let steps = |axis: usize, count: usize| {
            let (low, high) = (sorted[axis][0], sorted[axis][sorted[axis].len() - 1]);
            (0..count).map(move |step| low + (high - low) * step as f64 / (count - 1) as f64)
        };
        let span = |axis: usize| {
            let values = steps(axis, ASKED).filter_map(|value| Some(at(axis, value)?.0));
            let (low, high) = range_of(values);
            high - low
        };
        let spans: Vec<f64> = (0..inputs.len()).map(span).collect();
        let axis = (0..inputs.len()).fold(0, |most, axis| if spans[axis] >= spans[most] { axis } else { most });
        let moved = |(point, value): &(Vec<f64>, f64)| {
            let own = surrogate.predict(point).ok()?.into_iter().next()?.values[place];
            Some([point[axis], value - own + at(axis, point[axis])?.0])
        };
        Some(SurrogateSection {
            place,
            input: inputs[axis],
            runs: runs.iter().filter_map(moved).collect(),
            line: steps(axis, DRAWN)
                .filter_map(|value| {
                    let (own, deviation) = at(axis, value)?;
                    Some([value, own, group.reach * deviation])
                })
                .collect(),
        })
    }
}

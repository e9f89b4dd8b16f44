//! What a result is made from, and the bounds in it as people are shown them.

use crate::columns::{ColumnPlan, Spot, StudyColumn};
use crate::file::{EpistemicInput, Reduction, Study};
use crate::outputs::Seen;
use crate::rare::Rare;
use crate::response::StudyResponse;
use loosepin_bounds::{Bound, BoundPair, Bounds, SampleTable};
use loosepin_result::study::{BoundEnd, NumericalError, PathError, ResponsePoint, Statistic, Witness, WitnessValue};
use loosepin_text::units::SiUnit;

/// Everything that a result is made from.
pub struct Material<'m> {
    pub study: &'m Study,
    pub response: &'m StudyResponse,
    pub table: &'m SampleTable,
    pub bounds: &'m Bounds,
    /// Those that are looked at: what is possible at all, or to some degree.
    pub pairs: &'m [BoundPair],
    pub rare: &'m [Rare],
}

impl Material<'_> {
    /// The columns.
    pub fn plan(&self) -> &ColumnPlan {
        &self.response.shared.plan
    }

    /// The epistemic inputs by path.
    pub fn witness(&self, epistemic: &[f64]) -> Witness {
        // A percentile is attained at no single value of the parameters that it is taken over.
        let named = self.study.epistemic.iter().zip(epistemic).filter(|(_, value)| !value.is_nan());
        let shown = |input: &EpistemicInput, value: f64| match input.law(value) {
            Some(law) => WitnessValue::Choice(law.name().to_owned()),
            None => WitnessValue::Number(value),
        };
        named.map(|(input, &value)| (input.path.clone(), shown(input, value))).collect()
    }

    /// An end of a bound, not narrowed.
    pub fn end(&self, bound: &Bound) -> BoundEnd {
        BoundEnd {
            value_si: bound.value,
            widened_si: bound.widened,
            witness: bound.witness.as_ref().map(|w| self.witness(&w.epistemic)).unwrap_or_default(),
            error: numerical_error(bound),
        }
    }

    /// The bounds of `statistic` of `column`.
    pub fn pair(&self, column: usize, statistic: Statistic) -> Option<&BoundPair> {
        let is_meant = |pair: &&BoundPair| pair.column == column && pair.statistic == statistic;
        // Nearly always they are in the order of their columns, of which curves have hundreds.
        let first = self.pairs.partition_point(|pair| pair.column < column);
        let own = self.pairs[first..].iter().take_while(|pair| pair.column == column).find(is_meant);
        own.or_else(|| self.pairs.iter().find(is_meant))
    }

    /// Both ends of the bounds of `statistic` of `column`, narrowed to [`Material::limits`].
    pub fn ends(&self, column: usize, statistic: Statistic) -> Option<[BoundEnd; 2]> {
        let pair = self.pair(column, statistic)?;
        let [least, most] = self.limits(column, statistic);
        let (mut lower, mut upper) = (self.end(&pair.lower), self.end(&pair.upper));
        narrow(&mut lower, least);
        narrow(&mut upper, most);
        let is_magnitude = matches!(statistic, Statistic::Mean | Statistic::Quantile(_));
        if is_magnitude && self.is_never_negative(column) && lower.widened_si < 0.0 {
            lower.value_si = lower.value_si.max(0.0);
            set_widened(&mut lower, 0.0);
        }
        Some([lower, upper])
    }

    /// `statistic` of `column` with the epistemic inputs in their middle, as low and as high as failed runs allow, narrowed like the bounds:
    /// it lies between their widened ends.
    pub fn central(&self, column: usize, statistic: Statistic) -> Option<[f64; 2]> {
        let [least, most] = self.limits(column, statistic);
        let central = self.pair(column, statistic)?.central?;
        // What is not a number stays none: `max` and `min` would make it a limit.
        let within = |value: f64| if value.is_nan() { value } else { value.max(least).min(most) };
        Some(central.map(|value| self.possible(column, within(value))))
    }

    /// What is known of `statistic` of `column` from the largest deviation of the whole recorded part: no pose departs further, so
    /// |E d| <= E max|d| and the quantiles of d lie within those of ± max|d|.
    fn limits(&self, column: usize, statistic: Statistic) -> [f64; 2] {
        let planned = self.plan().columns[column];
        let largest = StudyColumn { spot: Spot::Reduced(Reduction::MaximumAbsolute), ..planned };
        let largest = self.plan().columns.iter().position(|known| *known == largest);
        let (Some(largest), Spot::Pose { .. }) = (largest, planned.spot) else {
            return [f64::NEG_INFINITY, f64::INFINITY];
        };
        let most = |statistic| self.pair(largest, statistic).map_or(f64::INFINITY, |pair| pair.upper.widened);
        match statistic {
            Statistic::Mean => [-most(statistic), most(statistic)],
            Statistic::Quantile(probability) => [-most(Statistic::Quantile(1.0 - probability)), most(statistic)],
            _ => [f64::NEG_INFINITY, f64::INFINITY],
        }
    }

    /// `value_si` of a column, or 0 where it is negative and the column is a magnitude.
    pub fn possible(&self, column: usize, value_si: f64) -> f64 {
        if value_si < 0.0 && self.is_never_negative(column) { 0.0 } else { value_si }
    }

    /// Whether the numbers of a column are magnitudes.
    fn is_never_negative(&self, column: usize) -> bool {
        let column = &self.plan().columns[column];
        let seen = self.plan().outputs[column.output].seen;
        let is_distance = matches!(seen, Seen::Path(_, PathError::Magnitude) | Seen::Wear(..));
        // The reductions of a distance are distances.
        is_distance || matches!(column.spot, Spot::Reduced(reduction) if reduction.is_never_negative())
    }

    /// The unit of a column.
    pub fn unit_of(&self, column: usize) -> SiUnit {
        self.plan().outputs[self.plan().columns[column].output].unit.clone()
    }

    /// The output of a column.
    pub fn name_of(&self, column: usize) -> String {
        self.plan().outputs[self.plan().columns[column].output].name.clone()
    }

    /// Where a column is taken; `in_curve` tells that it is a point of a curve.
    pub fn point_of(&self, column: usize, in_curve: bool) -> ResponsePoint {
        match self.plan().columns[column].spot {
            Spot::Pose { angle_rad: pose_rad, .. } => {
                if in_curve {
                    ResponsePoint::Curve { pose_rad }
                } else {
                    ResponsePoint::Pose { pose_rad }
                }
            }
            Spot::Reduced(reduction) => ResponsePoint::Reduced { reduction },
        }
    }
}

/// Both ends of a statistic of which nothing is known.
pub fn unknown_ends(statistic: Statistic) -> [BoundEnd; 2] {
    let range = if statistic.is_probability() { [0.0, 1.0] } else { [f64::NEG_INFINITY, f64::INFINITY] };
    let error = NumericalError { sampling_si: f64::INFINITY, ..NumericalError::default() };
    range.map(|widened_si| BoundEnd { value_si: f64::NAN, widened_si, witness: Witness::new(), error })
}

/// Moves the widened end of a bound back to `limit` where it lies beyond.
fn narrow(end: &mut BoundEnd, limit_si: f64) {
    let outward = if end.widened_si >= end.value_si { 1.0 } else { -1.0 };
    if outward * (end.widened_si - limit_si) > 0.0 && outward * (limit_si - end.value_si) >= 0.0 {
        set_widened(end, limit_si);
    }
}

/// Moves the widened end of a bound to `limit`, and makes its error what is left between them.
fn set_widened(end: &mut BoundEnd, limit_si: f64) {
    let room = (limit_si - end.value_si).abs();
    end.widened_si = limit_si;
    end.error.sampling_si = end.error.sampling_si.min(room);
    end.error.surrogate_si = end.error.surrogate_si.min(room - end.error.sampling_si);
    end.error.optimisation_si = room - end.error.sampling_si - end.error.surrogate_si;
}

/// The error of a bound, part by part.
pub fn numerical_error(bound: &Bound) -> NumericalError {
    let error = &bound.error;
    NumericalError { sampling_si: error.sampling, optimisation_si: error.optimisation, surrogate_si: error.surrogate }
}

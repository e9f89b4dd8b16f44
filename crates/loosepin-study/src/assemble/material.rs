//! Inputs of a result, and its bounds as they are shown.

use super::coherent::{cut_end_to_range, cut_to_range, hold_larger, hold_smaller, narrow, narrow_to_nearest};
use crate::file::{EpistemicInput, Reduction, Sampling, Study};
use crate::model::outputs::OutputSource;
use crate::places::Location;
use crate::question::Rare;
use crate::response::columns::{ColumnPlan, StudyColumn};
use crate::response::study_response::StudyResponse;
use loosepin_bounds::{Bound, BoundPair, Bounds, SampleTable};
use loosepin_result::study::{BoundEnd, NumericalError, PathError, ResponsePoint, Statistic, Witness, WitnessValue};
use loosepin_text::units::SiUnit;

/// Everything that a result is made from.
#[derive(Clone, Copy)]
pub struct Material<'m> {
    pub study: &'m Study,
    pub response: &'m StudyResponse,
    pub table: &'m SampleTable,
    /// The samples that the study came to have.
    pub sampling: Sampling,
    pub bounds: &'m Bounds,
    /// The bounds to show: of all that is possible, or of a degree of possibility.
    pub pairs: &'m [BoundPair],
    pub rare: &'m [Rare],
}

/// What the end of a bound may be narrowed to.
#[derive(Clone, Copy)]
struct Limit {
    value_si: f64,
    /// Bounds of other numbers that it rests on: all of them must hold.
    rests_on: usize,
}

impl Limit {
    const NONE: [Self; 2] =
        [Self { value_si: f64::NEG_INFINITY, rests_on: 0 }, Self { value_si: f64::INFINITY, rests_on: 0 }];
}

impl<'m> Material<'m> {
    /// Inputs from `bounds` of a study with its stated samples; no small probability was estimated otherwise than by counting.
    pub fn of_bounds(
        study: &'m Study,
        response: &'m StudyResponse,
        table: &'m SampleTable,
        bounds: &'m Bounds,
    ) -> Material<'m> {
        Material { study, response, table, sampling: study.sampling, bounds, pairs: &bounds.pairs, rare: &[] }
    }

    /// The same with other bounds. A small probability that was not counted belongs to what is possible at all, by the first reading: here runs
    /// are counted.
    pub fn with_pairs<'p>(&self, pairs: &'p [BoundPair]) -> Material<'p>
    where
        'm: 'p,
    {
        Material { pairs, rare: &[], ..*self }
    }
}

impl Material<'_> {
    /// The columns.
    pub fn plan(&self) -> &ColumnPlan {
        self.response.plan()
    }

    /// The epistemic inputs by path.
    pub fn witness(&self, epistemic: &[f64]) -> Witness {
        // A percentile is attained at no single value of the parameters that it is taken over.
        let named = self.study.epistemic.iter().zip(epistemic).filter(|(_, value)| !value.is_nan());
        let shown = |input: &EpistemicInput, value: f64| match (input.law(value), input.side_of_play(value)) {
            (Some(law), _) => WitnessValue::Choice(law.name().to_owned()),
            (None, Some(side)) => WitnessValue::Choice(side.to_owned()),
            (None, None) => WitnessValue::Number(value),
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

    /// All bounds of a column, where they are in the order of their columns, as nearly always.
    fn pairs_of(&self, column: usize) -> impl Iterator<Item = &BoundPair> {
        let first = self.pairs.partition_point(|pair| pair.column < column);
        self.pairs[first..].iter().take_while(move |pair| pair.column == column)
    }

    /// The bounds of `statistic` of `column`.
    pub fn pair(&self, column: usize, statistic: Statistic) -> Option<&BoundPair> {
        let is_meant = |pair: &&BoundPair| pair.column == column && pair.statistic == statistic;
        // Curves have hundreds of columns.
        self.pairs_of(column).find(is_meant).or_else(|| self.pairs.iter().find(is_meant))
    }

    /// Both ends of the bounds of `statistic` of `column`: within its range, in order with the bounds of the same output, and narrowed to
    /// [`Material::limits`]. This is the one place where bounds become what is shown and stored.
    pub fn ends(&self, column: usize, statistic: Statistic) -> Option<[BoundEnd; 2]> {
        self.ends_and_narrowings(column, statistic).map(|(ends, _)| ends)
    }

    /// [`Self::ends`], or those of a number that may be anything.
    pub fn ends_or_unknown(&self, column: usize, statistic: Statistic) -> [BoundEnd; 2] {
        self.ends(column, statistic).unwrap_or_else(|| unknown_ends(statistic))
    }

    /// Confidence in the sampling errors of the bounds of `statistic` of `column`: where other bounds have narrowed them all must hold, and
    /// misses add (Bonferroni).
    pub fn confidence(&self, column: usize, statistic: Statistic) -> f64 {
        let one: f64 = loosepin_bounds::Sampling::default().confidence;
        let narrowings = self.ends_and_narrowings(column, statistic).map_or(0, |(_, narrowings)| narrowings);
        if narrowings == 0 { one } else { (1.0 - (1 + narrowings) as f64 * (1.0 - one)).max(0.0) }
    }

    /// The ends, and how many bounds of other numbers have narrowed them.
    fn ends_and_narrowings(&self, column: usize, statistic: Statistic) -> Option<([BoundEnd; 2], usize)> {
        let (mut ends, mut narrowings) = self.ordered(column, statistic)?;
        for (end, limit) in ends.iter_mut().zip(self.limits(column, statistic)) {
            if narrow(end, limit.value_si) {
                narrowings += limit.rests_on;
            }
        }
        Some((ends, narrowings))
    }

    /// Both ends within their range, in order with bounds of numbers that never exceed this one, or that it never exceeds: other statistics of
    /// the column, and other reductions of the same curve. And how many of them have narrowed an end.
    fn ordered(&self, column: usize, statistic: Statistic) -> Option<([BoundEnd; 2], usize)> {
        let mut ends = self.within_range(self.pair(column, statistic)?);
        let (mut lower_limits, mut upper_limits) = (Vec::new(), Vec::new());
        for (other, reduced) in self.of_same_curve(column) {
            for pair in self.pairs_of(other) {
                let (own, its) = (statistic, pair.statistic);
                // What was computed on the way and is shown nowhere changes nothing.
                if (other, its) == (column, own) || !self.is_asked(other, its) {
                    continue;
                }
                let is_never_above = |a: Statistic, b: Statistic| a == b || a.never_exceeds(b);
                let [is_smaller, is_larger] = match reduced {
                    None => [its.never_exceeds(own), own.never_exceeds(its)],
                    // X <= Y gives S(X) <= S(Y), and S(Y) <= T(Y).
                    Some([its_smaller, its_larger]) => [
                        its_smaller && own.grows_with_variable() && is_never_above(its, own),
                        its_larger && own.grows_with_variable() && is_never_above(own, its),
                    ],
                };
                if is_smaller {
                    let smaller = self.within_range(pair);
                    hold_smaller(&mut ends, &smaller);
                    lower_limits.push(smaller[0].widened_si);
                }
                if is_larger {
                    let larger = self.within_range(pair);
                    hold_larger(&mut ends, &larger);
                    upper_limits.push(larger[1].widened_si);
                }
            }
        }
        let [lower, upper] = &mut ends;
        let narrowings = narrow_to_nearest(lower, &lower_limits) + narrow_to_nearest(upper, &upper_limits);
        Some((ends, narrowings))
    }

    /// The column, and other reductions of its curve: whether they never exceed it, and whether it never exceeds them.
    fn of_same_curve(&self, column: usize) -> Vec<(usize, Option<[bool; 2]>)> {
        let own = self.plan().columns[column];
        let mut found = vec![(column, None)];
        let Some(own_reduction) = own.spot.reduction() else { return found };
        for (other, planned) in self.plan().columns.iter().enumerate() {
            let Some(reduction) = planned.spot.reduction() else { continue };
            if other != column && (planned.output, planned.deviation) == (own.output, own.deviation) {
                found.push((
                    other,
                    Some([reduction.never_exceeds(own_reduction), own_reduction.never_exceeds(reduction)]),
                ));
            }
        }
        found
    }

    /// Whether somebody asked for `statistic` of `column`.
    fn is_asked(&self, column: usize, statistic: Statistic) -> bool {
        let asks = self.plan().asks.iter();
        asks.filter(|ask| ask.columns.contains(&column)).any(|ask| ask.statistics().any(|own| own == statistic))
    }

    fn within_range(&self, pair: &BoundPair) -> [BoundEnd; 2] {
        let range = self.range(pair.column, pair.statistic);
        let mut ends = [&pair.lower, &pair.upper].map(|bound| self.end(bound));
        cut_to_range(&mut ends, range);
        if pair.unbounded_by_failures {
            // Values and errors stay those of the finished runs.
            ends.iter_mut().zip(range).for_each(|(end, limit_si)| end.widened_si = limit_si);
        }
        ends
    }

    /// An end of a range of values of a column, within what they can be.
    pub fn end_of_values(&self, column: usize, bound: &Bound) -> BoundEnd {
        let mut end = self.end(bound);
        let least = if self.is_never_negative(column) { 0.0 } else { f64::NEG_INFINITY };
        cut_end_to_range(&mut end, [least, f64::INFINITY]);
        end
    }

    /// The least and the greatest value that a statistic of a column can have.
    fn range(&self, column: usize, statistic: Statistic) -> [f64; 2] {
        let least = if self.is_never_negative(column) { 0.0 } else { f64::NEG_INFINITY };
        statistic.range_within([least, f64::INFINITY])
    }

    /// `statistic` of `column` with the epistemic inputs in their middle, as low and as high as failed runs allow, narrowed like the bounds:
    /// it lies between their widened ends.
    pub fn central(&self, column: usize, statistic: Statistic) -> Option<[f64; 2]> {
        let [least, most] = self.limits(column, statistic).map(|limit| limit.value_si);
        let central = self.pair(column, statistic)?.central?;
        // What is not a number stays none: `max` and `min` would make it a limit.
        let within = |value: f64| if value.is_nan() { value } else { value.max(least).min(most) };
        Some(central.map(|value| self.possible(column, within(value))))
    }

    /// Limits of `statistic` of `column` from the largest deviation of the whole recorded part: no pose departs further, so |E d| <= E
    /// max|d|, the quantiles of d lie within those of ± max|d|, and other increasing statistics of d lie within S(- max|d|) and S(max|d|).
    fn limits(&self, column: usize, statistic: Statistic) -> [Limit; 2] {
        let planned = self.plan().columns[column];
        let largest = StudyColumn { spot: Location::reduced(Reduction::largest_magnitude()), ..planned };
        let largest = self.plan().columns.iter().position(|known| *known == largest);
        let (Some(largest), Some(_)) = (largest, planned.spot.pose()) else {
            return Limit::NONE;
        };
        let most = |statistic| match self.ordered(largest, statistic) {
            Some(([_, upper], narrowings)) => Limit { value_si: upper.widened_si, rests_on: 1 + narrowings },
            None => Limit { value_si: f64::INFINITY, rests_on: 0 },
        };
        let opposite = |limit: Limit| Limit { value_si: -limit.value_si, ..limit };
        match statistic.mirrored() {
            Some(mirrored) if statistic.grows_with_variable() => [opposite(most(mirrored)), most(statistic)],
            _ => Limit::NONE,
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
        let is_magnitude = match seen {
            OutputSource::Path(_, PathError::Magnitude) | OutputSource::Wear(..) => true,
            // A deviation of a magnitude has a sign, as that of a largest stress |N|/A + |M| c/I has.
            OutputSource::Reading(reading) => reading.is_never_negative() && column.deviation.is_value(),
            OutputSource::InSpace(own) => own.part.is_never_negative(),
            OutputSource::Path(..) => false,
        };
        // The reductions of a magnitude are magnitudes.
        is_magnitude || column.spot.reduction().is_some_and(Reduction::is_never_negative)
    }

    /// The unit of a column.
    pub fn unit_of(&self, column: usize) -> SiUnit {
        self.plan().outputs[self.plan().columns[column].output].unit.clone()
    }

    /// The unit of a statistic of a column.
    pub fn unit_of_statistic(&self, column: usize, statistic: Statistic) -> SiUnit {
        if statistic.is_probability() { SiUnit::NONE } else { self.unit_of(column) }
    }

    /// The output of a column.
    pub fn name_of(&self, column: usize) -> String {
        self.plan().outputs[self.plan().columns[column].output].name.clone()
    }

    /// Point at which a column is taken; `in_curve` marks a point of a curve.
    pub fn point_of(&self, column: usize, in_curve: bool) -> ResponsePoint {
        let of_pose = |pose_rad: f64| {
            if in_curve { ResponsePoint::Curve { pose_rad } } else { ResponsePoint::Pose { pose_rad } }
        };
        self.plan().columns[column]
            .spot
            .turned_into(|pose| of_pose(pose.angle_rad), |reduction| ResponsePoint::Reduced { reduction })
    }
}

/// Both ends of a statistic of which nothing is known.
fn unknown_ends(statistic: Statistic) -> [BoundEnd; 2] {
    let range = if statistic.is_probability() { [0.0, 1.0] } else { [f64::NEG_INFINITY, f64::INFINITY] };
    let error = NumericalError { sampling_si: f64::INFINITY, ..NumericalError::default() };
    range.map(|widened_si| BoundEnd { value_si: f64::NAN, widened_si, witness: Witness::new(), error })
}

/// The error of a bound, part by part.
fn numerical_error(bound: &Bound) -> NumericalError {
    let error = &bound.error;
    NumericalError { sampling_si: error.sampling, optimisation_si: error.optimisation, surrogate_si: error.surrogate }
}

#[cfg(test)]
mod tests {
    use crate::assemble::few_runs::FewRuns;
    use loosepin_bounds::{BoundPair, Statistic};

    /// The bounds of runs, with widened ends as a search may leave them.
    fn widened(runs: &FewRuns, ends: impl Fn(Statistic) -> [f64; 2]) -> Vec<BoundPair> {
        let mut pairs = runs.bounds.pairs.clone();
        for pair in &mut pairs {
            let [lower, upper] = ends(pair.statistic);
            (pair.lower.widened, pair.lower.error.optimisation) = (lower, pair.lower.value - lower);
            (pair.upper.widened, pair.upper.error.optimisation) = (upper, upper - pair.upper.value);
        }
        pairs
    }

    #[test]
    fn analytic_bounds_of_a_force_magnitude_are_not_negative_and_its_quantiles_are_in_order() {
        let ask = "output = \"gudgeon_force\"\nof = \"value\"\nreduce = \"maximum\"\n\
                   statistics = [\"mean\", { quantile = 0.5 }, { quantile = 0.99 }]\n";
        let runs = FewRuns::asking(0, ask);
        let column = runs.response.plan().asks[0].columns[0];
        // The median has been found less exactly than the 99 % quantile, which it never exceeds.
        let pairs = widened(&runs, |statistic| match statistic {
            Statistic::Quantile(0.5) => [-3100.0, 9.5e5],
            _ => [-2800.0, 8.7e5],
        });
        let material = runs.material(&pairs);
        let ends = |statistic| material.ends(column, statistic).unwrap().map(|end| end.widened_si);
        assert_eq!(ends(Statistic::Mean), [0.0, 8.7e5]);
        assert_eq!(ends(Statistic::Quantile(0.5)), [0.0, 8.7e5]);
        assert_eq!(ends(Statistic::Quantile(0.99)), [0.0, 8.7e5], "what is known better is not widened");
        let confidence = |statistic| material.confidence(column, statistic);
        assert!((confidence(Statistic::Quantile(0.5)) - 0.98).abs() < 1e-12, "both must hold");
        assert_eq!([confidence(Statistic::Mean), confidence(Statistic::Quantile(0.99))], [0.99; 2]);
        for statistic in [Statistic::Mean, Statistic::Quantile(0.5), Statistic::Quantile(0.99)] {
            for end in material.ends(column, statistic).unwrap() {
                let error = (end.widened_si - end.value_si).abs();
                assert!((end.error.total_si() - error).abs() <= 1e-9 * error, "{end:?}");
            }
        }
    }

    #[test]
    fn analytic_a_deviation_keeps_its_sign_and_a_narrowed_bound_says_its_confidence() {
        let ask = "output = \"gudgeon_force\"\nof = \"total\"\nreduce = \"minimum\"\nstatistics = [\"mean\"]\n";
        let runs = FewRuns::asking(0, ask);
        let column = runs.response.plan().asks[0].columns[0];
        let pairs = widened(&runs, |_| [-4.2e6, 5.1e6]);
        let material = runs.material(&pairs);
        assert_eq!(material.ends(column, Statistic::Mean).unwrap()[0].widened_si, -4.2e6);
        assert_eq!(material.confidence(column, Statistic::Mean), 0.99);
        // Points of a curve are cut to the bound of the largest deviation over the cycle: both must hold.
        let runs = FewRuns::after(0);
        let columns = &runs.response.plan().columns;
        let pose = runs.response.plan().asks[0].columns[2];
        let Some(largest) = (0..columns.len()).find(|column| {
            let is_largest = super::Location::reduced(super::Reduction::largest_magnitude());
            columns[*column].spot == is_largest && runs.bounds.pairs.iter().any(|pair| pair.column == *column)
        }) else {
            panic!("the largest deviation narrows curves");
        };
        let mut pairs = runs.bounds.pairs.clone();
        for pair in pairs.iter_mut().filter(|pair| pair.column == pose) {
            pair.upper.widened = 1.0;
        }
        let limit = pairs.iter().find(|pair| pair.column == largest && pair.statistic == Statistic::Mean);
        let limit = limit.map(|pair| pair.upper.widened).expect("its mean is bounded");
        let material = runs.material(&pairs);
        assert_eq!(material.ends(pose, Statistic::Mean).unwrap()[1].widened_si, limit);
        assert!((material.confidence(pose, Statistic::Mean) - 0.98).abs() < 1e-12);
    }
}

//! Finished runs, sorted by the point of the plan that they belong to.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::gathered::{GatheredSamples, PointSamples};
use super::polynomials::inner_basis::InnerBasis;
use super::polynomials::single_runs::{Contradiction, SingleRuns};
use super::polynomials::smoothness::smooth;
use super::sample::Sample;
use crate::data::bound::Witness;
use crate::data::table::{Purpose, RunInputs, SampleTable};
use crate::parallel;

/// The runs of one purpose, point by point, for some of the columns.
#[derive(Debug, Clone)]
pub(crate) struct Pool {
    /// Position of each column in the samples of a point.
    slots: BTreeMap<usize, usize>,
    pub points: Vec<PoolPoint>,
}

/// The runs at one point.
#[derive(Debug, Clone)]
pub(crate) struct PoolPoint {
    pub purpose: Purpose,
    pub point: u32,
    pub epistemic: Vec<f64>,
    /// Random inputs of the only run, empty where there are several.
    pub random: Vec<f64>,
    /// Number of runs.
    pub runs: usize,
    samples: Vec<Arc<Sample>>,
}

impl Pool {
    /// Gathers the runs of `purpose` for `columns`, points in the order of their index.
    pub fn gather(table: &SampleTable, purpose: Purpose, columns: impl IntoIterator<Item = usize>) -> Self {
        let mut slots: BTreeMap<usize, usize> = columns.into_iter().map(|column| (column, 0)).collect();
        for (slot, entry) in slots.values_mut().enumerate() {
            *entry = slot;
        }
        let runs: Vec<(u32, BTreeMap<u32, Vec<usize>>)> = runs_by_point(table, purpose).into_iter().collect();
        let gathered: Arc<GatheredSamples> = table.kept();
        let mut samples: Vec<(Arc<PointSamples>, bool)> = parallel::map(&runs, |(point, replicates)| {
            let mut own = gathered.of_point(purpose, *point, replicates.values().map(Vec::len).sum());
            let missing = own.missing(slots.keys().copied());
            if !missing.is_empty() {
                Arc::make_mut(&mut own).complete(table, replicates.values(), &missing);
            }
            (own, !missing.is_empty())
        });
        for point in 1..samples.len() {
            let (before, own) = samples.split_at_mut(point);
            let ((before, is_before_new), (own, is_new)) = (&before[point - 1], &mut own[0]);
            if *is_new || *is_before_new {
                Arc::make_mut(own).share(before);
                *is_new = true;
            }
        }
        let mut points = Vec::with_capacity(runs.len());
        for ((point, replicates), (samples, is_new)) in runs.into_iter().zip(samples) {
            let row = replicates.values().flatten().next().copied().unwrap_or(0);
            let first = &table.inputs()[row];
            points.push(PoolPoint {
                purpose,
                point,
                epistemic: first.epistemic.clone(),
                random: if samples.runs == 1 { first.random.clone() } else { Vec::new() },
                runs: samples.runs,
                samples: slots.keys().map(|column| samples.samples[column].clone()).collect(),
            });
            if is_new {
                gathered.keep(purpose, point, samples);
            }
        }
        Self { slots, points }
    }

    /// This pool with polynomials of `basis`, column by column, where the response is smooth in the random inputs. The runs at each
    /// point are those that the basis was made of.
    pub fn with_polynomials(self, basis: Option<&InnerBasis>) -> Self {
        self.smoothed(basis, false)
    }

    /// [`Self::with_polynomials`] in a round that others follow: they are kept with the samples, which takes as much memory again for residuals.
    pub fn with_kept_polynomials(self, basis: Option<&InnerBasis>) -> Self {
        self.smoothed(basis, true)
    }

    fn smoothed(mut self, basis: Option<&InnerBasis>, keeps: bool) -> Self {
        let Some(basis) = basis else { return self };
        let mut columns: Vec<Vec<&mut Arc<Sample>>> = self.slots.keys().map(|_| Vec::new()).collect();
        for point in &mut self.points {
            for (column, sample) in columns.iter_mut().zip(&mut point.samples) {
                column.push(sample);
            }
        }
        parallel::for_each_mut(&mut columns, |samples| smooth(basis, samples, keeps));
        self
    }

    /// Whether any column has polynomials.
    pub fn has_polynomials(&self) -> bool {
        self.points.first().is_some_and(|point| point.samples.iter().any(|sample| sample.smooth().is_some()))
    }

    /// This pool with what `runs` show that its samples with polynomials do not.
    pub fn without_contradicted(mut self, runs: &SingleRuns, table: &SampleTable) -> Self {
        let columns: Vec<(usize, Vec<&Sample>)> =
            self.slots.keys().map(|&column| (column, self.samples(column))).collect();
        let found = runs.against(&columns, table);
        for (&slot, found) in self.slots.values().zip(found) {
            let Some(Contradiction { unseen, is_small }) = found else { continue };
            let mut last: Option<(Arc<Sample>, Arc<Sample>)> = None;
            for point in &mut self.points {
                let own = &mut point.samples[slot];
                // What neighbours share stays shared.
                let known = last.take().filter(|(known, _)| Arc::ptr_eq(known, own));
                let (before, after) =
                    known.unwrap_or_else(|| (own.clone(), Arc::new(own.contradicted(unseen, is_small))));
                *own = after.clone();
                last = Some((before, after));
            }
        }
        self
    }

    /// The sample of `column` at each point; empty for a column that was not gathered.
    pub fn samples(&self, column: usize) -> Vec<&Sample> {
        self.slots
            .get(&column)
            .map_or_else(Vec::new, |&slot| self.points.iter().map(|point| &*point.samples[slot]).collect())
    }
}

/// Runs of `purpose` in the order of the table, by point and replicate.
fn runs_by_point(table: &SampleTable, purpose: Purpose) -> BTreeMap<u32, BTreeMap<u32, Vec<usize>>> {
    let mut runs: BTreeMap<u32, BTreeMap<u32, Vec<usize>>> = BTreeMap::new();
    let place = |inputs: &RunInputs| (inputs.purpose, inputs.point, inputs.replicate);
    // Runs of a replicate lie behind one another in the table.
    let mut first = 0;
    for own in table.inputs().chunk_by(|a, b| place(a) == place(b)) {
        let (own_purpose, point, replicate) = place(&own[0]);
        if own_purpose == purpose {
            runs.entry(point).or_default().entry(replicate).or_default().extend(first..first + own.len());
        }
        first += own.len();
    }
    runs
}

impl PoolPoint {
    /// This point as the witness of a bound.
    pub fn witness(&self) -> Witness {
        Witness {
            purpose: self.purpose,
            point: self.point,
            epistemic: self.epistemic.clone(),
            random: self.random.clone(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Pool;
    use crate::data::table::{Purpose, RunInputs, SampleTable};
    use crate::estimators::estimate::Confidence;
    use crate::estimators::moments::mean;

    fn push(table: &mut SampleTable, point: u32, replicate: u32, row: [f64; 2]) {
        let (random, epistemic) = (vec![0.5], vec![f64::from(point)]);
        let inputs =
            RunInputs { round: 0, purpose: Purpose::DoubleLoop, point, replicate, index: 0, random, epistemic };
        table.push(inputs, Ok(&row)).unwrap();
    }

    /// Mean of the second column at every point.
    fn means(table: &SampleTable) -> Vec<f64> {
        let pool = Pool::gather(table, Purpose::DoubleLoop, [1]);
        pool.samples(1).into_iter().map(|sample| mean(sample, &Confidence::new(0.95, 2)).value).collect()
    }

    #[test]
    fn identity_what_is_kept_is_never_that_of_another_table_or_of_fewer_runs() {
        let mut table = SampleTable::new(2);
        for point in 0..2 {
            push(&mut table, point, 0, [f64::NAN, 3.0 + f64::from(point)]);
            push(&mut table, point, 1, [f64::NAN, 5.0 + f64::from(point)]);
        }
        assert_eq!(means(&table), [4.0, 5.0]);
        let mut other = table.clone();
        push(&mut table, 1, 2, [f64::NAN, 11.0]);
        push(&mut other, 1, 2, [f64::NAN, 20.0]);
        assert_eq!(means(&table), [4.0, 7.0]);
        assert_eq!(means(&other), [4.0, 10.0]);
        push(&mut table, 2, 0, [f64::NAN, 7.5]);
        assert_eq!(means(&table), [4.0, 7.0, 7.5]);
    }

    #[test]
    fn identity_columns_of_a_table_that_are_asked_for_one_after_the_other_are_both_there() {
        let mut table = SampleTable::new(2);
        for point in 0..3 {
            // The first column is the same at the first two points, but for the sign of a zero at the third.
            push(&mut table, point, 0, [if point == 2 { -0.0 } else { 0.0 }, f64::from(point)]);
            push(&mut table, point, 1, [2.5, 9.0]);
        }
        assert_eq!(means(&table), [4.5, 5.0, 5.5]);
        let pool = Pool::gather(&table, Purpose::DoubleLoop, [0, 1]);
        let [first, second, third] = pool.samples(0)[..] else { panic!("three points") };
        assert!(core::ptr::eq(first, second) && !core::ptr::eq(second, third));
        assert!(third.values()[0].is_sign_negative() && first.values() == [0.0, 2.5]);
        assert_eq!(pool.samples(1)[2].values(), [2.0, 9.0]);
    }
}

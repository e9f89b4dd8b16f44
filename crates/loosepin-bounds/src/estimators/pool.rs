//! Finished runs, sorted by the point of the plan that they belong to.

use std::collections::BTreeMap;
use std::sync::Arc;

use rayon::prelude::*;

use super::estimate::Confidence;
use super::gathered::{Gathered, OfPoint};
use super::inner_basis::InnerBasis;
use super::sample::Sample;
use super::smoothness::smooth;
use super::together::work_out;
use crate::data::bound::Witness;
use crate::data::problem::Request;
use crate::data::statistic::Statistic;
use crate::data::table::{Purpose, SampleTable};

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
        // Runs of a point lie behind one another in the table, ordered by replicate and index.
        let mut runs: BTreeMap<u32, BTreeMap<u32, Vec<usize>>> = BTreeMap::new();
        for (run, inputs) in table.inputs().iter().enumerate() {
            if inputs.purpose == purpose {
                runs.entry(inputs.point).or_default().entry(inputs.replicate).or_default().push(run);
            }
        }
        let runs: Vec<(u32, BTreeMap<u32, Vec<usize>>)> = runs.into_iter().collect();
        let gathered: Arc<Gathered> = table.kept();
        let mut samples: Vec<OfPoint> = runs
            .par_iter()
            .map(|(point, replicates)| {
                let mut samples = gathered.of_point(purpose, *point, replicates.values().map(Vec::len).sum());
                samples.complete(table, replicates.values(), slots.keys().copied());
                samples
            })
            .collect();
        for point in 1..samples.len() {
            let (before, own) = samples.split_at_mut(point);
            own[0].share(&before[point - 1]);
        }
        let point = |((point, replicates), samples): ((u32, BTreeMap<u32, Vec<usize>>), OfPoint)| {
            let row = replicates.values().flatten().next().copied().unwrap_or(0);
            let first = &table.inputs()[row];
            let own = PoolPoint {
                purpose,
                point,
                epistemic: first.epistemic.clone(),
                random: if samples.runs == 1 { first.random.clone() } else { Vec::new() },
                runs: samples.runs,
                samples: slots.keys().filter_map(|column| samples.samples.get(column).cloned()).collect(),
            };
            gathered.keep(purpose, point, samples);
            own
        };
        let points = runs.into_iter().zip(samples).map(point).collect();
        Self { slots, points }
    }

    /// Works out what `requests` need of every sample, column by column: what is asked of the same sample shares the order of its values.
    pub fn work_out(&self, requests: &[Request], confidence: &Confidence) {
        let mut columns: BTreeMap<usize, Vec<Statistic>> = BTreeMap::new();
        for request in requests {
            columns.entry(request.column).or_default().push(request.statistic);
        }
        let columns: Vec<(usize, Vec<Statistic>)> = columns.into_iter().collect();
        columns.par_iter().for_each(|(column, statistics)| {
            self.samples(*column).into_iter().for_each(|sample| work_out(sample, statistics, confidence));
        });
    }

    /// This pool with polynomials of `basis`, column by column, where the response is smooth in the random inputs. The runs at each
    /// point are those that the basis was made of.
    pub fn with_polynomials(mut self, basis: Option<&InnerBasis>) -> Self {
        let Some(basis) = basis else { return self };
        let mut columns: Vec<Vec<&mut Arc<Sample>>> = self.slots.keys().map(|_| Vec::new()).collect();
        for point in &mut self.points {
            for (column, sample) in columns.iter_mut().zip(&mut point.samples) {
                column.push(sample);
            }
        }
        columns.par_iter_mut().for_each(|samples| smooth(basis, samples));
        self
    }

    /// The sample of `column` at each point; none for a column that was not gathered.
    pub fn samples(&self, column: usize) -> Vec<&Sample> {
        self.slots
            .get(&column)
            .map_or_else(Vec::new, |&slot| self.points.iter().map(|point| &*point.samples[slot]).collect())
    }
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

//! Finished runs, sorted by the point of the plan that they belong to.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::inner_basis::InnerBasis;
use super::sample::Sample;
use super::smoothness::smooth;
use crate::data::bound::Witness;
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
    samples: Vec<Sample>,
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
        let points = runs
            .into_par_iter()
            .map(|(point, replicates)| {
                let sample = |&column: &usize| {
                    Sample::new(replicates.values().map(|runs| runs.iter().map(move |&run| table.values(run)[column])))
                };
                let rows: Vec<usize> = replicates.values().flatten().copied().collect();
                let count = rows.len();
                let first = &table.inputs()[rows.first().copied().unwrap_or(0)];
                PoolPoint {
                    purpose,
                    point,
                    epistemic: first.epistemic.clone(),
                    random: if count == 1 { first.random.clone() } else { Vec::new() },
                    runs: count,
                    samples: slots.keys().map(sample).collect(),
                }
            })
            .collect();
        Self { slots, points }
    }

    /// This pool with polynomials of `basis`, column by column, where the response is smooth in the random inputs. The runs at each
    /// point are those that the basis was made of.
    pub fn with_polynomials(mut self, basis: Option<&InnerBasis>) -> Self {
        let Some(basis) = basis else { return self };
        let mut columns: Vec<Vec<&mut Sample>> = self.slots.keys().map(|_| Vec::new()).collect();
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
            .map_or_else(Vec::new, |&slot| self.points.iter().map(|point| &point.samples[slot]).collect())
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

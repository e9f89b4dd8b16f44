//! Samples that have been gathered from a table, kept beside its rows: of a round only what is new is gathered.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::sample::{Sample, SampleBuilder};
use crate::data::scratch::Scratch;
use crate::data::table::{Purpose, SampleTable};

/// Number of columns that are gathered at once: they lie side by side in memory, row by row, and are read in long pieces.
const COLUMNS_AT_ONCE: usize = 64;
/// Fewer values of a point than these stay in memory: every part of a file has pages of its own, and systems allow some ten thousand.
const MIN_MOVED: usize = 1 << 13;
/// So many values of a point are moved together.
const MAX_WAITING: usize = 1 << 19;

/// The samples of one point by their columns, and the number of runs that they were gathered from.
#[derive(Debug, Clone, Default)]
pub(super) struct PointSamples {
    pub runs: usize,
    pub samples: BTreeMap<usize, Arc<Sample>>,
}

/// The samples of all points.
#[derive(Debug, Default)]
pub(super) struct GatheredSamples(Mutex<BTreeMap<(Purpose, u32), Arc<PointSamples>>>);

impl GatheredSamples {
    /// The samples of `point` gathered from its current number of `runs`; empty if the point has more runs by now.
    pub fn of_point(&self, purpose: Purpose, point: u32, runs: usize) -> Arc<PointSamples> {
        let known = self.points().get(&(purpose, point)).filter(|known| known.runs == runs).cloned();
        known.unwrap_or_else(|| Arc::new(PointSamples { runs, samples: BTreeMap::new() }))
    }

    /// Keeps the samples of `point`.
    pub fn keep(&self, purpose: Purpose, point: u32, samples: Arc<PointSamples>) {
        self.points().insert((purpose, point), samples);
    }

    fn points(&self) -> MutexGuard<'_, BTreeMap<(Purpose, u32), Arc<PointSamples>>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl PointSamples {
    /// The members of `columns` that are missing.
    pub fn missing(&self, columns: impl Iterator<Item = usize>) -> Vec<usize> {
        columns.filter(|column| !self.samples.contains_key(column)).collect()
    }

    /// Gathers the `missing` columns from the rows of each replicate.
    pub fn complete<'r>(
        &mut self,
        table: &SampleTable,
        replicates: impl Iterator<Item = &'r Vec<usize>> + Clone,
        missing: &[usize],
    ) {
        let mut gatherings = vec![SampleBuilder::default(); COLUMNS_AT_ONCE.min(missing.len())];
        let (mut gathered, mut waiting): (Vec<Sample>, Vec<Sample>) = (Vec::with_capacity(missing.len()), Vec::new());
        for columns in missing.chunks(COLUMNS_AT_ONCE) {
            for rows in replicates.clone() {
                for &row in rows {
                    let values = table.values(row);
                    for (&column, own) in columns.iter().zip(&mut gatherings) {
                        own.push(values[column]);
                    }
                }
                gatherings.iter_mut().for_each(SampleBuilder::end_replicate);
            }
            waiting.extend(gatherings[..columns.len()].iter_mut().map(SampleBuilder::finish));
            let values: usize = waiting.iter().map(|sample| sample.values().len()).sum();
            if values >= MAX_WAITING {
                gathered.extend(moved(std::mem::take(&mut waiting), table.scratch()));
            }
        }
        gathered.extend(moved(waiting, table.scratch()));
        if let Some((first, others)) = gathered.split_first_mut() {
            others.iter_mut().for_each(|sample| sample.share_replicates(first));
        }
        self.samples.extend(missing.iter().copied().zip(gathered.into_iter().map(Arc::new)));
    }

    /// Takes over the samples of `other` that are the same as its own: where a column does not depend on the difference between two points,
    /// nothing is computed twice.
    pub fn share(&mut self, other: &Self) {
        for (column, own) in &mut self.samples {
            if let Some(same) = other.samples.get(column)
                && !Arc::ptr_eq(own, same)
                && own.is_same(same)
            {
                *own = same.clone();
            }
        }
    }
}

/// `samples` with their values in `scratch`, one behind the other; unchanged without it, if they are few, or if it has no space.
fn moved(samples: Vec<Sample>, scratch: Option<&Scratch>) -> Vec<Sample> {
    let count: usize = samples.iter().map(|sample| sample.values().len()).sum();
    let Some(scratch) = scratch.filter(|_| count >= MIN_MOVED) else { return samples };
    let values: Vec<f64> = samples.iter().flat_map(|sample| sample.values().iter().copied()).collect();
    let Ok(away) = scratch.put(&values) else { return samples };
    let mut begin = 0;
    let mut next = |sample: Sample| {
        let own = begin..begin + sample.values().len();
        begin = own.end;
        sample.moved(away.at(own))
    };
    samples.into_iter().map(&mut next).collect()
}

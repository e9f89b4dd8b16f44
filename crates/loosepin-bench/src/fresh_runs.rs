//! Mechanisms of a study at values of its unknown inputs, many values in one batch: no bounds, no result, only their numbers.

use loosepin::study::{RunRows, Study};
use loosepin::uncertainty::{QuantileLevel, ScrambledSobol};

/// Values of u in a batch: enough that its end, where lanes stand idle, takes no time.
const VALUES_IN_A_BATCH: usize = 100;

/// Makes runs of a study whose random inputs are independent and have no unknown parameters.
pub struct FreshRuns<'s> {
    study: &'s Study,
    rows: RunRows,
    made: usize,
    failed: usize,
}

/// A set of mechanisms, the same at every u that it is run at.
pub struct Mechanisms {
    random: Vec<Vec<f64>>,
}

/// The mechanisms of a set that finished at one value of u.
pub struct Sample {
    /// Values of the unknown inputs.
    pub at: Vec<f64>,
    /// Columns of the runs, in the order in which the study asks for them; finished runs only.
    pub columns: Vec<Vec<f64>>,
}

impl Mechanisms {
    /// `in_each` points of a low-discrepancy set in each of `replicates` independent scramblings, one scrambling after the other.
    ///
    /// # Panics
    /// If the study has too many random inputs for such a set.
    pub fn new(study: &Study, seed: u64, replicates: u32, in_each: u32) -> Self {
        let sobol = ScrambledSobol::try_new(seed, study.random.len()).expect("few dimensions");
        let value = |replicate, index, place: usize| {
            let level = QuantileLevel::Probability(sobol.point(replicate, index, place));
            study.random[place].variable.at(level)
        };
        let mechanism =
            |replicate, index| (0..study.random.len()).map(|place| value(replicate, index, place)).collect();
        let replicate = |replicate| (0..in_each).map(move |index| mechanism(replicate, index));
        Self { random: (0..replicates).flat_map(replicate).collect() }
    }

    /// A set of the given random inputs.
    pub fn given(random: Vec<Vec<f64>>) -> Self {
        Self { random }
    }

    /// How many.
    pub fn count(&self) -> usize {
        self.random.len()
    }
}

impl<'s> FreshRuns<'s> {
    /// On all processors.
    ///
    /// # Panics
    /// If the study cannot begin.
    pub fn new(study: &'s Study) -> Self {
        assert!(study.correlation.is_none(), "the random inputs are to be independent");
        assert!(study.random.iter().all(|input| input.parameters.is_empty()), "the distributions are to be known");
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        let rows = RunRows::new(study.clone(), threads).unwrap_or_else(|error| panic!("{error}"));
        Self { study, rows, made: 0, failed: 0 }
    }

    /// Runs a set at each value of u; `batch_done` is called with the number of runs made so far.
    ///
    /// # Panics
    /// If a batch cannot be made.
    pub fn at(&mut self, values: &[Vec<f64>], set: &Mechanisms, batch_done: impl Fn(usize)) -> Vec<Sample> {
        let mut samples = Vec::with_capacity(values.len());
        for batch in values.chunks(VALUES_IN_A_BATCH) {
            let inputs = batch.iter().flat_map(|at| set.random.iter().map(|random| [random.clone(), at.clone()]));
            let rows = self.rows.make(&[], inputs).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(rows.len(), batch.len() * set.count(), "a row for each run");
            for (at, rows) in batch.iter().zip(rows.chunks(set.count())) {
                let finished: Vec<&Vec<f64>> = rows.iter().flatten().collect();
                self.failed += rows.len() - finished.len();
                let column = |place: usize| finished.iter().map(|row| row[place]).collect();
                samples.push(Sample { at: at.clone(), columns: (0..self.study.asks.len()).map(column).collect() });
            }
            self.made += rows.len();
            batch_done(self.made);
        }
        samples
    }

    /// Runs made so far.
    pub fn made(&self) -> usize {
        self.made
    }

    /// How many of them had no result.
    pub fn failed(&self) -> usize {
        self.failed
    }
}

//! Runs at values of the unknowns, reduced to the features that were measured.

use loosepin_study::{
    Ask, Deviation, MeasuredMotion, MotionSubject, Reduction, RunRows, Study, StudyError, Where, sampled_feature,
};
use loosepin_uncertainty::{QuantileLevel, hash, normal, uniform};
use std::collections::HashMap;
use std::rc::Rc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Called with the number of values of the unknowns whose runs are made, and the expected number at most; returns whether to continue.
pub type ProgressCallback<'h> = &'h (dyn Fn(usize, usize) -> bool + Sync);

/// Ignores progress and continues.
pub const NO_CALLBACK: ProgressCallback<'static> = &|_, _| true;

/// Numbers of rows that are held at once, at most.
const MAX_NUMBERS: usize = 8_000_000;
/// Streams of random numbers of the seed of the study.
const LENGTHS: u64 = 0x6d6f_7469_6f6e;
const ERRORS: u64 = 0x6572_726f_7273;
const SPECIMEN: u64 = 0x7370_6563_696d;

/// Features of the runs at one point: of each run one number a feature, NaN if it failed.
pub(crate) type Runs = Rc<Vec<Vec<f64>>>;

/// A mechanism with what it would show.
pub(crate) struct Mechanism {
    pub random: Vec<f64>,
    pub epistemic: Vec<f64>,
    /// True value of each feature, SI; NaN if the run failed.
    pub features: Vec<f64>,
}

/// Runs of one study, made when they are asked for and kept.
pub(crate) struct RunCache<'s> {
    pub study: &'s Study,
    pub features: Vec<&'s MeasuredMotion>,
    /// Runs at each point.
    pub runs: usize,
    /// The study that records each stretch of turns.
    stretches: Vec<RunRows>,
    /// Columns of each feature in a row; empty for impacts.
    columns: Vec<Vec<usize>>,
    known: HashMap<Vec<u64>, Runs>,
    heard: ProgressCallback<'s>,
    /// Values that others have before these, and that all have together, about at most.
    before: usize,
    most: usize,
}

impl<'s> RunCache<'s> {
    /// # Errors
    /// The study cannot begin.
    pub fn new(
        study: &'s Study,
        features: &[&'s MeasuredMotion],
        runs: usize,
        threads: usize,
    ) -> Result<Self, StudyError> {
        let mut asked = study.clone();
        asked.asks = Vec::new();
        asked.requirements = Vec::new();
        let mut asks: Vec<Option<usize>> = Vec::new();
        for feature in features {
            let (output, deviation, location) = match feature.subject {
                MotionSubject::Located { output, deviation, reduction } => {
                    (output, deviation, Where::reduced(reduction))
                }
                MotionSubject::Sampled { output, .. } => (output, Deviation::of_value(), Where::over_cycle()),
                MotionSubject::Impacts { .. } => {
                    asks.push(None);
                    continue;
                }
            };
            asks.push(Some(asked.asks.len()));
            asked.asks.push(Ask::of_values(output, deviation, location));
        }
        if asked.asks.is_empty() {
            // A row of impacts alone still needs a column.
            asked.asks.push(Ask::of_values(0, Deviation::of_value(), Where::reduced(Reduction::Mean)));
        }
        let most = features.iter().map(|feature| feature.repeats).max().unwrap_or(1);
        let stretches = (0..most).map(|stretch| {
            let mut later = asked.clone();
            later.cycle.transient_turns += stretch as f64 * later.cycle.recorded_turns;
            RunRows::new(later, threads)
        });
        let stretches = stretches.collect::<Result<Vec<_>, StudyError>>()?;
        let columns = match stretches.first() {
            Some(first) => first.asked_columns()?,
            None => Vec::new(),
        };
        let columns = asks.into_iter().map(|ask| ask.map_or_else(Vec::new, |ask| columns[ask].clone())).collect();
        Ok(Self {
            study,
            features: features.to_vec(),
            runs,
            stretches,
            columns,
            known: HashMap::new(),
            heard: NO_CALLBACK,
            before: 0,
            most: 0,
        })
    }

    /// Tells `heard` of values that have their runs, `before` of them elsewhere and at most about `most` together.
    pub fn tell(&mut self, heard: ProgressCallback<'s>, before: usize, most: usize) {
        (self.heard, self.before, self.most) = (heard, before, most);
    }

    /// Values that have their runs.
    pub fn count(&self) -> usize {
        self.known.len()
    }

    /// Features of the runs at each point, each with its own independent error.
    ///
    /// # Errors
    /// The study cannot begin.
    pub fn at(&mut self, points: &[Vec<f64>]) -> Result<Vec<Runs>, StudyError> {
        let key = |point: &Vec<f64>| -> Vec<u64> { point.iter().map(|value| value.to_bits()).collect() };
        let mut new: Vec<&Vec<f64>> = Vec::new();
        for point in points {
            if !self.known.contains_key(&key(point)) && !new.contains(&point) {
                new.push(point);
            }
        }
        let together = (MAX_NUMBERS / (self.width() * self.runs)).max(1);
        for batch in new.chunks(together) {
            let made = self.made(batch)?;
            all_made(made.len(), batch.len())?;
            self.known.extend(batch.iter().copied().map(key).zip(made));
        }
        let of_point = |point: &Vec<f64>| {
            let known = self.known.get(&key(point)).cloned();
            known.ok_or_else(|| StudyError::NotMade { reason: "a value of the unknowns has no runs".to_owned() })
        };
        points.iter().map(of_point).collect()
    }

    /// Numbers of a run, about.
    fn width(&self) -> usize {
        self.columns.iter().map(Vec::len).sum::<usize>() + 64
    }

    fn made(&self, points: &[&Vec<f64>]) -> Result<Vec<Runs>, StudyError> {
        let key = |run: usize| hash(hash(self.study.seed, LENGTHS), run as u64);
        let inputs: Vec<[Vec<f64>; 2]> = points
            .iter()
            .flat_map(|point| (0..self.runs).map(move |run| [self.random(point, key(run)), point.to_vec()]))
            .collect();
        let mut sums = self.without_errors(&inputs, self.before + self.known.len())?;
        for (index, values) in sums.iter_mut().enumerate() {
            let run = (index % self.runs) as u64;
            for (place, (value, feature)) in values.iter_mut().zip(&self.features).enumerate() {
                let deviation = feature.scatter.size / (feature.repeats as f64).sqrt();
                let key = hash(hash(self.study.seed, ERRORS), run);
                let error = deviation * normal(key, place as u64);
                *value += if feature.scatter.is_share { *value * error } else { error };
            }
        }
        Ok(sums.chunks(self.runs).map(|runs| Rc::new(runs.to_vec())).collect())
    }

    /// Further mechanisms, from number `first` on, one at each of `points`: their random inputs and their features without errors, which are
    /// not kept.
    ///
    /// # Errors
    /// The study cannot begin.
    pub fn mechanisms(&self, first: usize, points: &[Vec<f64>]) -> Result<Vec<Mechanism>, StudyError> {
        let key = |number: usize| hash(hash(self.study.seed, SPECIMEN), number as u64);
        let inputs: Vec<[Vec<f64>; 2]> = points
            .iter()
            .enumerate()
            .map(|(index, point)| [self.random(point, key(first + index)), point.clone()])
            .collect();
        let mut features = Vec::with_capacity(inputs.len());
        for part in inputs.chunks((MAX_NUMBERS / self.width()).max(1)) {
            let already = self.before + self.known.len() + (first + features.len()) / self.runs;
            features.extend(self.without_errors(part, already)?);
        }
        all_made(features.len(), inputs.len())?;
        let mechanism =
            |([random, epistemic], features): ([Vec<f64>; 2], Vec<f64>)| Mechanism { random, epistemic, features };
        Ok(inputs.into_iter().zip(features).map(mechanism).collect())
    }

    /// Features of runs with these random and epistemic inputs, means over their repeats, without the errors of instruments; as many
    /// values as `already` have their runs.
    fn without_errors(&self, inputs: &[[Vec<f64>; 2]], already: usize) -> Result<Vec<Vec<f64>>, StudyError> {
        let mut sums = vec![vec![0.0; self.features.len()]; inputs.len()];
        let (runs, runs_per_value) = (AtomicUsize::new(0), self.runs * self.stretches.len());
        let (heard, most) = (self.heard, self.most);
        let finished = || {
            let finished = runs.fetch_add(1, Ordering::Relaxed) + 1;
            let values = already + finished / runs_per_value;
            !finished.is_multiple_of(runs_per_value) || heard(values, most.max(values))
        };
        if !heard(already, most.max(already)) {
            return Ok(Vec::new());
        }
        for (stretch, rows) in self.stretches.iter().enumerate() {
            let made = rows.make_until(&[], inputs.iter().cloned(), &finished)?;
            all_made(made.len(), inputs.len())?;
            for (row, sums) in made.into_iter().zip(&mut sums) {
                let row = row.ok();
                for (place, feature) in self.features.iter().enumerate().filter(|(_, known)| stretch < known.repeats) {
                    let value = match &row {
                        Some(row) => self.feature(rows, row, place)?,
                        None => f64::NAN,
                    };
                    sums[place] += value / feature.repeats as f64;
                }
            }
        }
        Ok(sums)
    }

    fn feature(&self, rows: &RunRows, row: &[f64], place: usize) -> Result<f64, StudyError> {
        let turns = self.study.cycle.recorded_turns;
        let columns = &self.columns[place];
        Ok(match self.features[place].subject {
            MotionSubject::Impacts { play } => rows.contacts(row)?[play] / turns,
            MotionSubject::Located { .. } => row[columns[0]],
            MotionSubject::Sampled { feature, highest_order, .. } => {
                let samples: Vec<f64> = columns.iter().map(|column| row[*column]).collect();
                sampled_feature(&samples, turns as usize, feature, highest_order)
            }
        })
    }

    /// Random inputs of a run: the same levels at every point for the same key.
    fn random(&self, point: &[f64], key: u64) -> Vec<f64> {
        let random = &self.study.random;
        let cube: Vec<f64> = (0..random.len()).map(|input| uniform(key, input as u64)).collect();
        let levels = match &self.study.correlation {
            Some(correlation) => correlation.copula.levels(&cube),
            None => cube.into_iter().map(QuantileLevel::Probability).collect(),
        };
        let value = |(input, level): (&loosepin_study::RandomInput, QuantileLevel)| {
            let parameters = input.parameters.iter().map(|known| (known.parameter, point[known.epistemic]));
            match input.variable.with_parameters(parameters) {
                Ok(variable) => variable.at(level),
                Err(_) => f64::NAN,
            }
        };
        random.iter().zip(levels).map(value).collect()
    }
}

/// Refuses rows of which some are missing: the others would be taken for those of other values.
fn all_made(found: usize, due: usize) -> Result<(), StudyError> {
    if found == due {
        return Ok(());
    }
    Err(StudyError::NotMade { reason: format!("{found} of {due} rows were made") })
}

#[cfg(test)]
mod tests {
    use super::all_made;

    #[test]
    fn rows_that_are_missing_are_refused() {
        assert!(all_made(3, 3).is_ok());
        let refused = all_made(2, 3).expect_err("one is missing").to_string();
        assert!(refused.contains("2 of 3 rows"), "{refused}");
    }
}

//! Inversion of the joint test: the values of the unknowns at which it keeps the measurement.

use super::grid::{Axis, Grid, TestedCell};
use super::joint_test::{Verdict, joint_test, runs_for};
use super::lengths::lengths;
use super::posterior::{Question, posterior};
use super::run_cache::{ProgressCallback, RunCache, Runs};
use super::scatter::Observation;
use super::unknowns::{axis, bounds, value};
use crate::error::IdentifyProblem;
use loosepin_result::motion_identification::{
    ConsistentMembers, InconsistentFeature, MotionFeature, MotionMisfit, MotionSpecimen, TestedPoint,
};
use loosepin_study::{EpistemicInput, MeasuredMotion, Study, StudyError};
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Place};
use std::rc::Rc;

/// Unknowns, at most: cells grow as a power of them.
const MAX_UNKNOWNS: usize = 6;
/// Runs at each value, at most.
const MAX_RUNS: f64 = 100_000.0;

/// Settings for the values of the unknowns of a motion.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionValues {
    /// Probability with which the set holds the true values, at least.
    pub confidence: f64,
    /// Values of the unknowns that are tested, about at most.
    pub points: usize,
    /// Number of threads; the result is the same for any.
    pub threads: usize,
    /// Whether a posterior distribution is given beside the set.
    pub with_posterior: bool,
    /// Whether mechanisms that agree with the measurement are drawn from the remaining runs.
    pub with_lengths: bool,
}

/// Values of the unknowns, and of each run at them its features, SI.
pub type RunsOfValue = (Vec<f64>, Vec<Vec<f64>>);

/// A study whose runs are made once, for any number of measurements of the same features.
pub struct MotionRig<'s> {
    pub(super) bank: RunCache<'s>,
    pub(super) axes: Vec<Axis>,
    alpha: f64,
    points: usize,
    with_lengths: bool,
}

impl<'s> MotionRig<'s> {
    /// A study with the features of one specimen; `beside` further runs at each value take no part in the test.
    ///
    /// # Errors
    /// Nothing is unknown or too much, a confidence that needs too many runs, a study that cannot begin.
    pub fn new(
        study: &'s Study,
        features: &[&'s MeasuredMotion],
        asked: &MotionValues,
        beside: usize,
    ) -> Result<Self, Diagnostics> {
        let alpha = 1.0 - asked.confidence;
        let runs = runs_for(alpha);
        if !(0.5..1.0).contains(&asked.confidence) || !(runs <= MAX_RUNS) {
            return Err(Diagnostics::one(&IdentifyProblem::MotionConfidence { found: asked.confidence }, None));
        }
        let axes: Vec<Axis> = study.epistemic.iter().map(axis).collect();
        if axes.is_empty() || axes.len() > MAX_UNKNOWNS {
            let place = Place::new(study.source(), 0..0);
            let problem = IdentifyProblem::Unknowns { found: axes.len(), most: MAX_UNKNOWNS };
            return Err(Diagnostic::error(&problem, Some(place)).into());
        }
        let is_fixed = study.random.is_empty() && features.iter().all(|feature| feature.scatter.size == 0.0);
        let runs = if is_fixed { 1 } else { runs as usize };
        let bank =
            RunCache::new(study, features, runs + beside, asked.threads).map_err(|error| refused(study, &error))?;
        Ok(Self { bank, axes, alpha, points: asked.points, with_lengths: asked.with_lengths })
    }

    /// Values of the unknowns at shares of the box.
    pub(super) fn values(&self, shares: &[f64]) -> Vec<f64> {
        self.bank.study.epistemic.iter().zip(shares).map(|(input, share)| value(input, *share)).collect()
    }

    pub(super) fn runs_at(&mut self, points: &[Vec<f64>]) -> Result<Vec<Runs>, Diagnostics> {
        let study = self.bank.study;
        let all = self.bank.at(points).map_err(|error| refused(study, &error))?;
        if all.len() != points.len() {
            let reason = format!("{} values of the unknowns were run instead of {}", all.len(), points.len());
            return Err(refused(study, &StudyError::NotMade { reason }));
        }
        Ok(all)
    }

    pub(super) fn test(&self, runs: &[Vec<f64>], places: &[usize], seen: &Observation) -> Verdict {
        joint_test(runs, places, seen, self.alpha)
    }

    /// The measurement of the features with these mean values over their repeats, SI.
    pub(super) fn observation(&self, values_si: Vec<f64>) -> Observation {
        let mut names: Vec<&str> = Vec::new();
        let instruments = self.bank.features.iter().map(|feature| {
            let known = names.iter().position(|name| *name == feature.instrument);
            known.unwrap_or_else(|| {
                names.push(&feature.instrument);
                names.len() - 1
            })
        });
        let instruments = instruments.collect();
        Observation { values_si, errors: self.bank.features.iter().map(|feature| feature.error).collect(), instruments }
    }

    /// The consistent values where the features were measured as `values_si`, means over their repeats; `with_posterior` their distribution
    /// too.
    ///
    /// # Errors
    /// The study cannot begin.
    pub fn invert(
        &mut self,
        name: Option<String>,
        values_si: &[f64],
        with_posterior: bool,
    ) -> Result<MotionSpecimen, Diagnostics> {
        let seen = self.observation(values_si.to_vec());
        let places: Vec<usize> = (0..values_si.len()).collect();
        let mut tested: Vec<(Vec<f64>, Verdict, Runs)> = Vec::new();
        let mut cells: Vec<(TestedCell, Runs)> = Vec::new();
        let (axes, study, alpha, points) = (self.axes.clone(), self.bank.study, self.alpha, self.points);
        // Middles as shares of the box; of each what the test says, and its runs.
        let mut test = |middles: Vec<Vec<f64>>| {
            let values: Vec<Vec<f64>> = middles.iter().map(|middle| self.values(middle)).collect();
            let all = self.runs_at(&values)?;
            let found: Vec<(Verdict, Runs)> =
                all.into_iter().map(|runs| (self.test(&runs, &places, &seen), runs)).collect();
            tested.extend(
                values.into_iter().zip(&found).map(|(point, (verdict, runs))| (point, *verdict, Rc::clone(runs))),
            );
            Ok::<_, Diagnostics>(found)
        };
        let (grid, is_coarse) =
            Grid::refined(&axes, points, with_posterior, &mut |grid: &mut Grid, waiting: &[usize]| {
                let found = test(waiting.iter().map(|cell| grid.middle(*cell)).collect())?;
                for (cell, (verdict, runs)) in waiting.iter().zip(found) {
                    grid.decide(*cell, verdict);
                    cells.push((TestedCell { at: grid.middle(*cell), widths: grid.widths() }, runs));
                }
                Ok::<(), Diagnostics>(())
            })?;
        // What is tested further does not change the set.
        let given = if with_posterior {
            let left = points.saturating_sub(cells.len());
            let question = Question { study, seen: &seen, alpha };
            Some(posterior(&question, grid.clone(), cells, left, &mut test)?)
        } else {
            None
        };
        let mut found = self.specimen(name, &seen, &grid, &tested, is_coarse);
        found.posterior = given;
        if self.with_lengths {
            let most = self.points.saturating_sub(tested.len()) * self.bank.runs;
            let drawn = lengths(&self.bank, &seen, &grid, most);
            found.lengths = Some(drawn.map_err(|error| refused(self.bank.study, &error))?);
        }
        Ok(found)
    }

    /// The values that the test keeps on a grid of `counts` values along each unknown, evenly over the box: brute force, to check an
    /// inversion.
    ///
    /// # Errors
    /// The study cannot begin.
    pub fn kept(&mut self, counts: &[usize], values_si: &[f64]) -> Result<Vec<Vec<f64>>, Diagnostics> {
        let grid = Grid::untested(&self.axes, counts.to_vec());
        let cells = grid.cells.len();
        let points: Vec<Vec<f64>> = (0..cells).map(|cell| self.values(&grid.middle(cell))).collect();
        let all = self.runs_at(&points)?;
        let (seen, places) = (self.observation(values_si.to_vec()), (0..values_si.len()).collect::<Vec<usize>>());
        let is_kept = |runs: &Runs| self.test(runs, &places, &seen).is_consistent;
        Ok(points.into_iter().zip(&all).filter(|(_, runs)| is_kept(runs)).map(|(point, _)| point).collect())
    }

    /// So many values along each unknown, evenly over the box, each with the features of its runs; those of failed runs are left out.
    ///
    /// # Errors
    /// The study cannot begin.
    pub fn predicted(&mut self, counts: &[usize]) -> Result<Vec<RunsOfValue>, Diagnostics> {
        let grid = Grid::untested(&self.axes, counts.to_vec());
        let points: Vec<Vec<f64>> = (0..grid.cells.len()).map(|cell| self.values(&grid.middle(cell))).collect();
        let all = self.runs_at(&points)?;
        let is_whole = |run: &&Vec<f64>| run.iter().all(|value| value.is_finite());
        let whole = |runs: Runs| runs.iter().filter(is_whole).cloned().collect();
        Ok(points.into_iter().zip(all.into_iter().map(whole)).collect())
    }

    fn specimen(
        &self,
        name: Option<String>,
        seen: &Observation,
        grid: &Grid,
        tested: &[(Vec<f64>, Verdict, Runs)],
        is_coarse: bool,
    ) -> MotionSpecimen {
        let study = self.bank.study;
        let of_axis = |(k, axis): (usize, &Axis)| {
            let count = grid.counts[k] as f64;
            let input = &study.epistemic[k];
            let after_si = match (grid.extent(k), axis) {
                (None, _) => input.variable.ends(),
                // As far as the middle of the next cell, which was tested itself and is rejected.
                (Some([first, last]), Axis::Continuous) => {
                    [first as f64 - 0.5, last as f64 + 1.5].map(|end| value(input, (end / count).clamp(0.0, 1.0)))
                }
                (Some(_), Axis::Members(_)) => {
                    let kept: Vec<f64> =
                        grid.consistent().map(|cell| value(input, grid.place(cell)[k] as f64)).collect();
                    [
                        kept.iter().copied().fold(f64::INFINITY, f64::min),
                        kept.iter().copied().fold(f64::NEG_INFINITY, f64::max),
                    ]
                }
            };
            bounds(study, input, after_si)
        };
        let consistent: Vec<usize> = grid.consistent().collect();
        let mut widened: Vec<usize> =
            consistent.iter().flat_map(|cell| grid.neighbours(*cell)).chain(consistent.clone()).collect();
        widened.sort_unstable();
        widened.dedup();
        let cells = grid.cells.len() as f64;
        let failed = |run: &&Vec<f64>| run.iter().any(|value| !value.is_finite());
        let range = |place: usize, is_kept: &dyn Fn(&Verdict) -> bool| {
            let runs = tested.iter().filter(|(_, verdict, _)| is_kept(verdict)).flat_map(|(_, _, runs)| runs.iter());
            let values = runs.map(|run| run[place]).filter(|value| value.is_finite());
            values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
        };
        let features: Vec<MotionFeature> = self
            .bank
            .features
            .iter()
            .enumerate()
            .map(|(place, feature)| MotionFeature {
                name: feature.name.clone(),
                unit: feature.unit.clone(),
                measured_si: seen.values_si[place],
                repeats: feature.repeats,
                found_si: seen.found_si(place),
                predicted_before_si: range(place, &|_| true),
                predicted_after_si: (!consistent.is_empty()).then(|| range(place, &|verdict| verdict.is_consistent)),
            })
            .collect();
        let misfit = consistent.is_empty().then(|| {
            let apart = |(place, feature): (usize, &MotionFeature)| {
                let [least, largest] = feature.predicted_before_si;
                let [low, high] = feature.found_si;
                let apart_si = if low > largest {
                    low - largest
                } else if high < least {
                    high - least
                } else {
                    0.0
                };
                (apart_si != 0.0).then_some(InconsistentFeature { feature: place, apart_si })
            };
            let least_distance = tested.iter().map(|(_, verdict, _)| verdict.distance).fold(f64::INFINITY, f64::min);
            MotionMisfit { least_distance, culprits: features.iter().enumerate().filter_map(apart).collect() }
        });
        let list = |(k, input): (usize, &EpistemicInput)| {
            let before = input.members_written(&study.model)?;
            let is_kept = |place: &usize| consistent.iter().any(|cell| grid.place(*cell)[k] == *place);
            let after = (0..before.len()).filter(is_kept).map(|place| before[place].clone()).collect();
            Some(ConsistentMembers { unknown: k, before, after })
        };
        MotionSpecimen {
            name,
            unknowns: grid.axes.iter().enumerate().map(of_axis).collect(),
            lists: study.epistemic.iter().enumerate().filter_map(list).collect(),
            share_of_box: [consistent.len() as f64 / cells, widened.len() as f64 / cells],
            grid: grid.counts.clone(),
            cells: consistent.clone(),
            points: tested
                .iter()
                .map(|(values, verdict, _)| TestedPoint {
                    values_si: values.clone(),
                    is_consistent: verdict.is_consistent,
                    distance: verdict.distance,
                })
                .collect(),
            runs_per_point: self.bank.runs,
            failed: tested.iter().map(|(_, _, runs)| runs.iter().filter(failed).count()).sum(),
            is_coarse,
            misfit,
            posterior: None,
            lengths: None,
            features,
        }
    }
}

/// The error of runs that cannot be made, with code and hint of the refusal.
fn refused(study: &Study, error: &StudyError) -> Diagnostics {
    error.diagnostic(study).into()
}

/// The consistent values of each specimen of `study`, in the order of the file, or of the one that is named.
///
/// # Errors
/// A feature without a value, and what [`MotionRig::new`] refuses.
pub(crate) fn identify_motion(
    study: &Study,
    specimen: Option<&String>,
    asked: &MotionValues,
    heard: ProgressCallback<'_>,
) -> Result<Vec<MotionSpecimen>, Diagnostics> {
    let mut names: Vec<&Option<String>> = Vec::new();
    for feature in &study.motion {
        let is_asked = specimen.is_none_or(|wanted| feature.specimen.as_ref() == Some(wanted));
        if is_asked && !names.contains(&&feature.specimen) {
            names.push(&feature.specimen);
        }
    }
    let (mut before, most) = (0, asked.points * names.len());
    let of_specimen = |name: &Option<String>| {
        let features: Vec<&MeasuredMotion> = study.motion.iter().filter(|feature| feature.specimen == *name).collect();
        let values = features.iter().map(|feature| {
            feature.mean_si().ok_or_else(|| {
                let problem = IdentifyProblem::NotMeasured { feature: feature.name.clone() };
                Diagnostics::from(Diagnostic::error(&problem, Some(feature.place.clone())))
            })
        });
        let values: Vec<f64> = values.collect::<Result<_, _>>()?;
        let mut rig = MotionRig::new(study, &features, asked, 0)?;
        rig.bank.tell(heard, before, most);
        let found = rig.invert(name.clone(), &values, asked.with_posterior);
        before += rig.bank.count();
        found
    };
    names.into_iter().map(of_specimen).collect()
}

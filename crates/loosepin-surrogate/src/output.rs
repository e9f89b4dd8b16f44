//! The surrogate of one output: a number, or a curve.

use super::data::TrainingOutput;
use super::design::Design;
use super::error::SurrogateError;
use super::fitted::{Fitted, Kind};
use super::held_out::{Candidate, Runs};
use super::modes::Modes;
use super::options::Options;
use super::quality::Quality;
use super::residual::{Residual, SHARES};
use super::spread::Spread;
use loosepin_uncertainty::hash;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// Share of the held-out squared error of all modes from which on a mode is worth a network.
const WORTH_A_NETWORK: f64 = 0.02;
/// Share of held-out squared error in the variance of the output from which on networks are tried: below it they cannot be better by more
/// than this in Q².
const WORTH_ANY_NETWORK: f64 = 1e-4;
/// Something must be better than the mean by this factor in the squared error before it is believed to be something.
const BETTER_THAN_THE_MEAN: f64 = 0.95;

/// A fitted output with its quality.
#[derive(Clone, Serialize, Deserialize)]
pub struct OutputSurrogate {
    /// Name of the output.
    pub name: String,
    /// Mean curve and modes; a number is a curve of one place.
    pub modes: Modes,
    /// The score of each mode as a function of the inputs.
    pub fits: Vec<Fitted>,
    /// Held-out error.
    pub quality: Quality,
    /// The residual.
    pub residual: Residual,
    spread: Spread,
}

impl OutputSurrogate {
    pub(super) fn fit(design: &Design, output: &TrainingOutput, options: &Options) -> Result<Self, SurrogateError> {
        let known: Vec<usize> = (0..output.rows.len()).filter(|&run| output.rows[run].is_some()).collect();
        let curves: Vec<&[f64]> = output.rows.iter().flatten().map(Vec::as_slice).collect();
        let missing = output.rows.len() - curves.len();
        let noise = known.iter().map(|&run| output.noise.as_ref().map_or(0.0, |noise| noise[run])).collect();
        let runs = Runs::new(design.subset(&known), curves, noise, options);
        let chosen = choose(&runs, options).ok_or_else(|| SurrogateError::NotFitted {
            output: output.name.clone(),
            kind: options.kind_name(),
            runs: known.len(),
        })?;
        let held_out: Vec<Vec<(f64, f64)>> = chosen.iter().map(|mode| mode.best().held_out.clone()).collect();
        let residuals = runs.residuals(&held_out);
        let errors: Vec<&[f64]> = residuals.iter().map(|(errors, _)| errors.as_slice()).collect();
        let mut quality = Quality::new(&runs.curves, &errors, missing, runs.folds.len());
        quality.tried = chosen
            .iter()
            .map(|mode| mode.candidates.iter().map(|c| (c.kind, (c.square / known.len() as f64).sqrt())).collect())
            .collect();
        let spread = Spread::new(
            &residuals
                .iter()
                .map(|(errors, variances)| (errors.iter().map(|e| e * e).sum(), variances.iter().sum()))
                .collect::<Vec<_>>(),
        );
        let residual = judge(&runs, &chosen, &errors, &quality);
        let fits = chosen.into_iter().map(Chosen::into_fit).collect();
        Ok(Self { name: output.name.clone(), modes: runs.modes, fits, quality, residual, spread })
    }

    /// Values and standard deviations at every place.
    pub(super) fn predict(&self, scaled: &[f64], germ: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let (scores, spreads): (Vec<f64>, Vec<f64>) = self.fits.iter().map(|fit| fit.predict(scaled, germ)).unzip();
        let squares = self.quality.rms_along.iter().map(|rms| rms * rms);
        let variances = self.modes.variance(&spreads).into_iter().zip(squares);
        let deviations = variances.map(|(own, square)| self.spread.variance(own, square).sqrt()).collect();
        (self.modes.curve(&scores), deviations)
    }

    /// The kind of each mode.
    pub fn kinds(&self) -> Vec<Kind> {
        self.fits.iter().map(Fitted::kind).collect()
    }
}

/// All that was tried for a mode, and which of it is taken.
struct Chosen {
    candidates: Vec<Candidate>,
    best: usize,
}

impl Chosen {
    fn new(candidates: Vec<Candidate>) -> Option<Self> {
        let mut best = 0;
        for (place, candidate) in candidates.iter().enumerate() {
            let factor = if candidates[best].is_constant() { BETTER_THAN_THE_MEAN } else { 1.0 };
            if candidate.square < factor * candidates[best].square {
                best = place;
            }
        }
        (!candidates.is_empty()).then_some(Self { candidates, best })
    }

    fn best(&self) -> &Candidate {
        &self.candidates[self.best]
    }

    fn into_fit(mut self) -> Fitted {
        self.candidates.swap_remove(self.best).fit
    }
}

/// The best kind for every mode. A network, which costs most, is tried where another kind leaves an error worth it.
fn choose(runs: &Runs, options: &Options) -> Option<Vec<Chosen>> {
    let modes = runs.modes.shapes.len();
    let kinds = options.kinds();
    let is_alone = kinds.len() == 1;
    let (first, networks): (Vec<Kind>, Vec<Kind>) =
        kinds.into_iter().partition(|kind| is_alone || *kind != Kind::Network);
    let all = |tasks: Vec<(usize, Kind)>| -> Vec<(usize, Option<Candidate>)> {
        tasks.into_par_iter().map(|(mode, kind)| (mode, runs.candidate(mode, kind))).collect()
    };
    let mut candidates: Vec<Vec<Candidate>> = (0..modes).map(|_| Vec::new()).collect();
    let tasks = (0..modes).flat_map(|mode| first.iter().map(move |kind| (mode, *kind))).collect();
    for (mode, candidate) in all(tasks) {
        candidates[mode].extend(candidate);
    }
    if !networks.is_empty() {
        let least = |tried: &Vec<Candidate>| tried.iter().map(|c| c.square).fold(f64::INFINITY, f64::min);
        let total: f64 = candidates.iter().map(least).sum();
        let constant = |tried: &Vec<Candidate>| {
            tried.iter().find(|candidate| candidate.kind == Kind::Constant).map_or(0.0, |candidate| candidate.square)
        };
        let variance: f64 = candidates.iter().map(constant).sum();
        let worth: Vec<(usize, Kind)> = (0..modes)
            .filter(|&mode| total > WORTH_ANY_NETWORK * variance && least(&candidates[mode]) >= WORTH_A_NETWORK * total)
            .map(|mode| (mode, Kind::Network))
            .collect();
        for (mode, candidate) in all(worth) {
            candidates[mode].extend(candidate);
        }
    }
    candidates.into_iter().map(Chosen::new).collect()
}

/// Measures the error at several numbers of runs, and judges.
fn judge(runs: &Runs, chosen: &[Chosen], errors: &[&[f64]], quality: &Quality) -> Residual {
    let (mut lowest, mut highest) = (f64::INFINITY, f64::NEG_INFINITY);
    for value in runs.curves.iter().flat_map(|curve| curve.iter()) {
        (lowest, highest) = (lowest.min(*value), highest.max(*value));
    }
    let variance = quality.q2.map_or(0.0, |q2| quality.rms * quality.rms / (1.0 - q2).max(1e-300));
    let mut learning = Vec::new();
    for share in SHARES {
        let held_out: Option<Vec<_>> = chosen
            .par_iter()
            .enumerate()
            .map(|(mode, chosen)| {
                let best = chosen.best();
                if share == 1.0 {
                    return Some(best.held_out.clone());
                }
                let seed = hash(runs.seed, mode as u64);
                runs.hold_out(mode, best.kind, &best.fit.warm_start(), seed, share).map(|(held_out, _)| held_out)
            })
            .collect();
        let Some(held_out) = held_out else { continue };
        let learned = runs.folds.iter().map(|fold| fold.learned.len()).sum::<usize>() / runs.folds.len();
        let squares = runs.residuals(&held_out).iter().map(|(errors, _)| errors.iter().map(|e| e * e).sum()).collect();
        learning.push(((learned as f64 * share).round() as usize, squares));
    }
    Residual::new(&runs.design.scaled, errors, highest - lowest, variance, quality.q2, &learning)
}

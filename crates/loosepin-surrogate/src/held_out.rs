//! Held-out predictions: predictions for runs that were not used for the fit.
//!
//! Everything that learns is done anew for each fold on the runs outside it: mean curve and modes, choice of terms, length
//! scales, weights. Two things are taken over from the fit to all runs, and only as a beginning: kernel and first parameters
//! of a Gaussian process, and the number of neurons, which is itself chosen by this error.

use super::design::Design;
use super::fitted::{Fitted, Form, Kind, WarmStart};
use super::modes::Modes;
use super::options::Options;
use crate::network::ensemble::Ensemble;
use loosepin_uncertainty::hash;

/// Folds, and the number of different points below which each point is a fold of its own.
const FOLDS: usize = 5;
const LEAVE_ONE_OUT_BELOW: usize = 16;
/// Number of runs below which there are ten folds: four fifths of few runs are too few to stand for all.
const MORE_FOLDS_BELOW: usize = 80;
const MORE_FOLDS: usize = 10;

/// Value and spread of a score for each run, when it was held out.
type HeldOut = Vec<(f64, f64)>;

/// Runs of one output: their points, their curves, and how they are split.
pub(super) struct Runs<'a> {
    pub design: Design,
    pub curves: Vec<&'a [f64]>,
    /// Known variance of each run's values.
    pub noise: Vec<f64>,
    pub modes: Modes,
    pub folds: Vec<Fold>,
    pub seed: u64,
    most_neurons: usize,
}

/// One part of the runs that is held out from the rest.
pub(super) struct Fold {
    pub held_out: Vec<usize>,
    pub learned: Vec<usize>,
    /// Modes of the learned runs alone.
    pub modes: Modes,
}

/// One mode fitted by one kind.
pub(super) struct Candidate {
    pub kind: Kind,
    pub fit: Fitted,
    /// For each run, value and spread of its score when it was held out.
    pub held_out: Vec<(f64, f64)>,
    /// Σ of squared errors of the held-out scores.
    pub square: f64,
}

impl<'a> Runs<'a> {
    pub fn new(design: Design, curves: Vec<&'a [f64]>, noise: Vec<f64>, options: &Options) -> Self {
        let seed = options.seed;
        let modes = Modes::new(&curves, options.left_share, options.most_modes);
        let first = design.first_equals();
        let different = (0..first.len()).filter(|&i| first[i] == i).count();
        let count = match different {
            few if few < LEAVE_ONE_OUT_BELOW => few,
            few if few < MORE_FOLDS_BELOW => MORE_FOLDS,
            _ => FOLDS,
        };
        let fold_of = design.folds(count, seed);
        let folds = (0..count)
            .map(|fold| {
                let (held_out, learned): (Vec<usize>, Vec<usize>) =
                    (0..curves.len()).partition(|&run| fold_of[run] == fold);
                let modes =
                    Modes::new(&learned.iter().map(|&run| curves[run]).collect::<Vec<_>>(), 0.0, modes.shapes.len());
                Fold { held_out, learned, modes }
            })
            .collect();
        Self { design, curves, noise, modes, folds, seed, most_neurons: options.most_neurons }
    }

    /// Score number `mode` of a run; 0 where there are fewer modes.
    pub fn score(&self, modes: &Modes, run: usize, mode: usize) -> f64 {
        modes.scores(self.curves[run]).get(mode).copied().unwrap_or(0.0)
    }

    /// `mode` fitted by `kind`; `None` if that cannot be fitted.
    pub fn candidate(&self, mode: usize, kind: Kind) -> Option<Candidate> {
        let values: Vec<f64> = (0..self.curves.len()).map(|run| self.score(&self.modes, run, mode)).collect();
        let seed = hash(self.seed, mode as u64);
        if kind == Kind::Network {
            let sizes = Ensemble::sizes(self.design.inputs(), values.len(), self.most_neurons);
            let mut best: Option<(usize, HeldOut, f64)> = None;
            for neurons in sizes {
                let (held_out, square) = self.hold_out(mode, kind, &WarmStart::Neurons(neurons), seed, 1.0)?;
                // A larger network that is no better ends the search: the next one costs eight times as much.
                if best.as_ref().is_some_and(|(_, _, least)| square >= *least) {
                    break;
                }
                best = Some((neurons, held_out, square));
            }
            let (neurons, held_out, square) = best?;
            let fit = Fitted::fit(kind, &self.design, &values, &self.noise, seed, &WarmStart::Neurons(neurons))?;
            return Some(Candidate { kind, fit, held_out, square });
        }
        let fit = Fitted::fit(kind, &self.design, &values, &self.noise, seed, &WarmStart::Nothing)?;
        let (held_out, square) = self.hold_out(mode, kind, &fit.warm_start(), seed, 1.0)?;
        Some(Candidate { kind, fit, held_out, square })
    }

    /// Held-out value and spread of the score of every run, and the sum of squared errors, where the fits see only the share
    /// `share` of the runs that they may learn from.
    pub fn hold_out(&self, mode: usize, kind: Kind, like: &WarmStart, seed: u64, share: f64) -> Option<(HeldOut, f64)> {
        let mut held_out = vec![(0.0, 0.0); self.curves.len()];
        let mut square = 0.0;
        for fold in &self.folds {
            let learned = fold.share_of(share, self.seed);
            let design = self.design.subset(&learned);
            let values: Vec<f64> = learned.iter().map(|&run| self.score(&fold.modes, run, mode)).collect();
            let noise: Vec<f64> = learned.iter().map(|&run| self.noise[run]).collect();
            let fit = Fitted::fit(kind, &design, &values, &noise, seed, like)?;
            for &run in &fold.held_out {
                held_out[run] = fit.predict(&self.design.scaled[run], &self.design.germs[run]);
                let error = held_out[run].0 - self.score(&fold.modes, run, mode);
                square += error * error;
            }
        }
        Some((held_out, square))
    }

    /// Held-out errors of every run, place by place, and the variances that go with them, from those of all modes.
    pub fn residuals(&self, held_out: &[Vec<(f64, f64)>]) -> Vec<(Vec<f64>, Vec<f64>)> {
        let mut residuals = vec![(Vec::new(), Vec::new()); self.curves.len()];
        for fold in &self.folds {
            for &run in &fold.held_out {
                let (scores, spreads): (Vec<f64>, Vec<f64>) = held_out.iter().map(|mode| mode[run]).unzip();
                let curve = fold.modes.curve(&scores);
                let errors = self.curves[run].iter().zip(curve).map(|(y, value)| y - value).collect();
                residuals[run] = (errors, fold.modes.variance(&spreads));
            }
        }
        residuals
    }
}

impl Fold {
    /// The share of the learned runs whose random number is least, in the order of the runs.
    fn share_of(&self, share: f64, seed: u64) -> Vec<usize> {
        let mut order = self.learned.clone();
        order.sort_by_key(|&run| (hash(hash(seed, 0x5175), run as u64), run));
        order.truncate(((self.learned.len() as f64 * share).round() as usize).max(2));
        order.sort_unstable();
        order
    }
}

impl Candidate {
    /// Whether the fit is only the mean.
    pub fn is_constant(&self) -> bool {
        matches!(self.fit.form(), Form::Constant)
    }
}

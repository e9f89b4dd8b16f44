//! Whether play takes a mechanism to a dead centre: a position where the loop equations are singular, so that they can go over to their other
//! assembly.
//!
//! Let y and w be the unit vectors with J w = σ y and Jᵀy = σ w, σ the smallest singular value. Where the loops stay closed, the variables p of
//! play change it by
//!
//! ```text
//! dσ = s·dp,   s = -zᵀK,   Jᵀz = c,   c = d(Jᵀy)/da along poses moved by a w,   K = ∂Φ/∂p
//! ```
//!
//! (but for what p does to J directly, which is small beside it). Near a dead centre σ² is linear in p, not σ: with β = c·w and k·p = -y·K p the
//! loops close, to second order, where
//!
//! ```text
//! σ a + β a²/2 = k·p,   σ + β a = ± (σ² + 2 β k·p)^½
//! ```
//!
//! (the normal form of a fold: W. Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria, 2000, 3.2), and s = β k/σ. The two signs are
//! the two assemblies; they meet where 2 σ s·p = -σ². So the search goes along the p with the smallest s·p, again and again, and follows the
//! loops exactly. Past a dead centre they do not close on either branch.

use crate::accuracy::extreme::SearchOptions;
use crate::accuracy::linear::slice::largest;
use crate::accuracy::linear::vectors::dot;
use crate::accuracy::placed::{Placed, Start};
use crate::accuracy::play_set::PlaySet;
use crate::accuracy::pose_accuracy::PoseAccuracy;
use crate::accuracy::search::random_starts;
use crate::closure::bordered::{Bordered, Weakest};

/// Most steps of a descent; three are usual.
const MAX_STEPS: usize = 40;
/// Most parts of a step; some 30 are usual where it leads to a dead centre.
const MAX_PARTS: usize = 200;
/// Random starts where the first descent ends at no dead centre.
const OTHER_STARTS: usize = 6;
/// Share of σ² that 2 σ s·p may be for the dead centre to be far.
const FAR: f64 = 0.1;
/// Share from which other starts are tried.
const NEAR: f64 = 0.5;
/// Share of σ² of a step that is given up.
const LAST_SHARE: f64 = 0.01;
/// Part of a step from which the dead centre is near enough, and the shortest one.
const SHORT_PART: f64 = 2e-4;
const LAST_PART: f64 = 1e-8;
/// Share of σ² that a part must be on which the loops do not close, as it leads past the dead centre.
const PAST: f64 = 0.25;
/// Share of the σ of the ideal position that is none: σ² is then a ten-thousandth.
const NEARLY_NONE: f64 = 1e-2;
/// Half of the way along w over which c is a difference, lengths over L and rad.
const DIFFERENCE: f64 = 1e-4;

/// How near to a dead centre play takes the loops.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct DeadCentreNearness {
    /// Whether a place of the journals was found that takes them there: see [`PoseAccuracy::reaches_dead_centre`].
    pub is_reached: bool,
    /// Whether it is reached, or would be as far as second derivatives in the ideal position tell.
    pub is_near: bool,
}

/// A position on the branch that is next to a dead centre, and the one across from it.
pub(crate) struct DeadCentre {
    /// A place of the journals, in units of the radii.
    pub scaled: Vec<f64>,
    /// The other assembly there, if it was found.
    pub other: Option<Placed>,
}

/// The fold that is nearest to a place.
struct Fold {
    sigma: f64,
    beta: f64,
    /// w.
    motion: Vec<f64>,
    /// s, of variables in units of their radii.
    gains: Vec<f64>,
}

impl Fold {
    /// The largest share over all plays, without conditions.
    fn largest_share(&self, set: &PlaySet) -> f64 {
        2.0 * set.support(&self.gains).iter().sum::<f64>() / self.sigma
    }

    /// -2 s·p over σ: at 1 the fold is reached.
    fn share(&self, change: &[f64]) -> f64 {
        -2.0 * dot(&self.gains, change) / self.sigma
    }
}

impl PoseAccuracy<'_> {
    /// Whether a place of the journals was found that takes the loops to a dead centre, drives held. There the mechanism can go over to its other
    /// assembly, and deviations are no more those of a small displacement. `false` is no proof.
    pub fn reaches_dead_centre(&self) -> bool {
        self.dead_centre().is_some()
    }

    /// How near to a dead centre play takes the loops.
    pub fn dead_centre_nearness(&self) -> DeadCentreNearness {
        let Some((middle, fold)) = self.middle_and_fold() else {
            return DeadCentreNearness { is_reached: false, is_near: true };
        };
        let is_far = fold.largest_share(&self.set) < 1.0;
        let is_reached = self.dead_centre_from(middle, fold).is_some();
        DeadCentreNearness { is_reached, is_near: is_reached || !is_far }
    }

    /// The largest -2 s·p over σ in the ideal position, over all p of the plays: at 1 they reach the dead centre, as far as second derivatives tell.
    pub(crate) fn dead_centre_share(&self) -> f64 {
        self.middle_and_fold().map_or(f64::INFINITY, |(_, fold)| fold.largest_share(&self.set))
    }

    pub(crate) fn dead_centre(&self) -> Option<DeadCentre> {
        let (middle, fold) = self.middle_and_fold()?;
        self.dead_centre_from(middle, fold)
    }

    fn middle_and_fold(&self) -> Option<(Placed, Fold)> {
        let middle = self.placed(vec![0.0; self.set.variables()], self.ideal_start())?;
        let fold = self.fold(&middle);
        Some((middle, fold))
    }

    fn dead_centre_from(&self, middle: Placed, fold: Fold) -> Option<DeadCentre> {
        // Without the conditions first: most mechanisms are far from it.
        if !(fold.largest_share(&self.set) > FAR) {
            return None;
        }
        let none = NEARLY_NONE * fold.sigma;
        let is_near = fold.largest_share(&self.set) > NEAR;
        let from_middle = self.descended(middle.clone(), fold, none);
        if from_middle.is_some() || !is_near {
            return from_middle;
        }
        // As a descent ends where σ has a minimum, others begin elsewhere.
        let options = SearchOptions { random_starts: OTHER_STARTS, ..SearchOptions::default() };
        let starts = random_starts(self.set.variables(), &options);
        starts.iter().find_map(|objective| {
            let change = self.best_change(&middle, objective)?;
            match self.followed(&middle, &change, none) {
                Followed::ToAFold(last) => Some(self.reached(last)),
                Followed::ToItsEnd(start) => {
                    let fold = self.fold(&start);
                    self.descended(start, fold, none)
                }
                Followed::Lost => None,
            }
        })
    }

    /// Goes along the steepest descent of σ until that is none or the loops do not close.
    fn descended(&self, mut now: Placed, mut fold: Fold, none: f64) -> Option<DeadCentre> {
        for _ in 0..MAX_STEPS {
            if fold.sigma < none {
                return Some(self.reached(now));
            }
            let objective: Vec<f64> = fold.gains.iter().map(|gain| -gain).collect();
            let mut change = self.best_change(&now, &objective)?;
            if !(fold.share(&change) > FAR) {
                return None;
            }
            (now, fold) = loop {
                match self.followed(&now, &change, none) {
                    Followed::ToAFold(last) => return Some(self.reached(last)),
                    Followed::ToItsEnd(next) => {
                        let found = self.fold(&next);
                        if found.sigma < fold.sigma {
                            break (next, found);
                        }
                    }
                    Followed::Lost => {}
                }
                // Farther than the fold that was seen is another one.
                change.iter_mut().for_each(|change| *change *= 0.5);
                if !(fold.share(&change) > LAST_SHARE) {
                    return None;
                }
            };
        }
        None
    }

    fn reached(&self, last: Placed) -> DeadCentre {
        DeadCentre { other: self.across(&last), scaled: last.scaled }
    }

    /// To the place that is best for an objective to first order.
    fn best_change(&self, from: &Placed, objective: &[f64]) -> Option<Vec<f64>> {
        let (planes, right) = self.linear_conditions(from);
        let target = largest(&self.set, objective, None, &planes, &right)?.place;
        Some(target.iter().zip(&from.scaled).map(|(to, from)| to - from).collect())
    }

    /// Follows the loops along a change of the variables.
    fn followed(&self, from: &Placed, change: &[f64], none: f64) -> Followed {
        let (mut now, mut done, mut part) = (from.clone(), 0.0, 1.0);
        for _ in 0..MAX_PARTS {
            if done >= 1.0 {
                return Followed::ToItsEnd(now);
            }
            let next = f64::min(done + part, 1.0);
            let scaled = from.scaled.iter().zip(change).map(|(from, change)| from + next * change).collect();
            if let Some(placed) = self.placed(scaled, now.start()) {
                (now, done, part) = (placed, next, f64::min(2.0 * part, 1.0));
                continue;
            }
            if part < SHORT_PART {
                let rest: Vec<f64> = change.iter().map(|change| part * change).collect();
                let fold = self.fold(&now);
                if fold.share(&rest) > PAST || fold.sigma < none {
                    return Followed::ToAFold(now);
                }
                if part < LAST_PART {
                    return Followed::Lost;
                }
            }
            part *= 0.5;
        }
        Followed::Lost
    }

    /// The other assembly with the journals where they are, close to a dead centre: a = -2σ/β.
    fn across(&self, at: &Placed) -> Option<Placed> {
        let fold = self.fold(at);
        let step: Vec<f64> = fold.motion.iter().map(|entry| -2.0 * fold.sigma / fold.beta * entry).collect();
        let poses = self.loops.moved(&at.closed.poses, &step);
        let shifts = self.plays.shifts_in_metres(&self.loops, &self.set.in_metres(&at.scaled));
        let system = Bordered::new(&self.loops, &self.loops.frames(&poses, &shifts), &self.position.borders);
        let orientation = -self.ideal_start().orientation;
        self.placed(at.scaled.clone(), Start { poses: &poses, system: &system, orientation })
    }

    fn fold(&self, at: &Placed) -> Fold {
        let Weakest { sigma, row, motion } = at.closed.system.weakest();
        let metres = self.set.in_metres(&at.scaled);
        let shifts = self.plays.shifts_in_metres(&self.loops, &metres);
        let [before, after] = [-DIFFERENCE, DIFFERENCE].map(|share| {
            let step: Vec<f64> = motion.iter().map(|entry| share * entry).collect();
            let poses = self.loops.moved(&at.closed.poses, &step);
            self.loops.combined(&self.loops.frames(&poses, &shifts), &row)
        });
        let change: Vec<f64> =
            after.iter().zip(&before).map(|(after, before)| (after - before) / (2.0 * DIFFERENCE)).collect();
        let (by_rows, _) = at.closed.system.solve_transposed(&change);
        let mut gains = Vec::with_capacity(metres.len());
        self.plays.gains(&self.loops, &at.closed.frames, &by_rows, Some(&metres), &mut gains);
        Fold { sigma, beta: dot(&change, &motion), motion, gains }
    }
}

enum Followed {
    ToItsEnd(Placed),
    /// The last place before the loops do not close any more.
    ToAFold(Placed),
    Lost,
}

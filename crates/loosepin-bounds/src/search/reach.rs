//! How far models let a target go.

use super::climb::Climb;
use super::furthest::Furthest;
use super::search_box::{Axes, Region};
use super::target::Target;
use crate::data::direction::Direction;
use crate::search::models::local::LocalFits;
use crate::search::models::of_points::{Branch, Search};
use crate::search::models::prediction::{Allowance, Prediction};
use crate::search::models::target_model::TargetModel;
use crate::search::rough::broken_reach::reach_of_break;

/// Summits that are climbed to, at most, and how far their candidates lie apart along some axis, in units of the box.
const MAX_SUMMITS: usize = 3;
const APART: f64 = 0.25;

/// How far a target may go beyond what has been attained, by its model.
#[derive(Debug, Clone)]
pub(super) struct Reach {
    /// Most that the model allows, at `optimistic_at`.
    pub optimistic: f64,
    pub optimistic_at: Vec<f64>,
    /// Most that the model expects, at `expected_at`.
    pub expected: f64,
    pub expected_at: Vec<f64>,
}

impl Search<'_> {
    /// The most that the model of `target` in one combination, `branch`, allows in `direction`, anywhere in `region`; infinite
    /// without one.
    pub fn reach(&self, target: &Target, branch: &Branch<'_>, direction: Direction, region: &Region) -> f64 {
        let Some(model) = &branch.model else { return direction.sign() * f64::INFINITY };
        let most = if self.is_of_curves() {
            climbed_reach(self.axes, model, direction, region, target.range())
        } else {
            located_reach(self.axes, model, direction, region)
        };
        // Noise does not become less towards an extreme, so that it looks like a kink or an edge.
        let beyond_break = if branch.is_regressing() {
            None
        } else {
            reach_of_break(self.axes, self.points, &target.values, &branch.defined, direction, region)
        };
        let most = beyond_break.map_or(most, |further| direction.further(most, further));
        most + target.conceded(direction)
    }

    /// The furthest that any of the models of `target` allows in `direction`, anywhere in `region`.
    pub fn furthest_reach(
        &self,
        target: &Target,
        branches: &[Branch<'_>],
        direction: Direction,
        region: &Region,
    ) -> f64 {
        let reaches = branches.iter().map(|branch| self.reach(target, branch, direction, region));
        reaches.reduce(|a, b| direction.further(a, b)).unwrap_or(direction.sign() * f64::INFINITY)
    }
}

/// How far the model lets its target go in `direction`, with an `allowance`, over all candidates and points in `region`.
pub(super) fn reach(model: &TargetModel<'_>, direction: Direction, region: &Region, allowance: Allowance) -> Reach {
    let all = all_places(model, direction, region, allowance);
    all.unwrap_or_else(|| reach_where(model, direction, region, allowance, |_| true))
}

/// [`reach`] where no place has to be asked about: nearly all models are smooth ones of all points over the whole box.
fn all_places(model: &TargetModel<'_>, direction: Direction, region: &Region, allowance: Allowance) -> Option<Reach> {
    let TargetModel::Plain(fits) = model else { return None };
    let fit = fits.whole().filter(|fit| fit.are_all_in(region))?;
    if allowance.concedes_roughness() && fit.is_rough() {
        return None;
    }
    let sign = direction.sign();
    let [optimistic, expected] = fit.furthest(allowance, sign);
    Some(Reach::of(model, direction, region, (optimistic, expected)))
}

/// [`reach`] over those of the candidates and points alone that are `meant`.
pub(super) fn reach_where(
    model: &TargetModel<'_>,
    direction: Direction,
    region: &Region,
    allowance: Allowance,
    is_meant: impl Fn(&[f64]) -> bool,
) -> Reach {
    let sign = direction.sign();
    // Nearly all models are plain ones: what is asked at thousands of places is then one straight loop, where nothing is rough without
    // a question.
    let (optimistic, expected) = match model {
        TargetModel::Plain(fit) => {
            let all_in = fit.are_all_in(region);
            let is_held = |place: usize| {
                let at = &fit.places()[place];
                (all_in || region.holds(at)) && is_meant(at)
            };
            let ends = |at: Prediction| (sign * at.moved(allowance, sign), sign * at.mean);
            if allowance.concedes_roughness() && fit.is_rough() {
                furthest(fit.at_places(allowance).map(ends), is_held)
            } else {
                furthest(fit.smooth_at_places().map(ends), is_held)
            }
        }
        _ => {
            let at_places = model.at_places(allowance);
            let ends = at_places.map(|at| (sign * at.moved(allowance, sign), sign * at.mean()));
            furthest(ends, |place| {
                let at = &model.places()[place];
                region.holds(at) && is_meant(at)
            })
        }
    };
    Reach::of(model, direction, region, (optimistic, expected))
}

impl Reach {
    /// The furthest values in `direction`, each with its place.
    fn of(
        model: &TargetModel<'_>,
        direction: Direction,
        region: &Region,
        (optimistic, expected): (Furthest, Furthest),
    ) -> Self {
        let sign = direction.sign();
        if optimistic.0 == f64::NEG_INFINITY {
            // No place of the region is known: the model says nothing there.
            let centre = region.at(&vec![0.5; region.lower.len()]);
            let unlimited = sign * f64::INFINITY;
            let (optimistic_at, expected_at) = (centre.clone(), centre);
            return Self { optimistic: unlimited, optimistic_at, expected: f64::NAN, expected_at };
        }
        Self {
            optimistic: sign * optimistic.0,
            optimistic_at: model.places()[optimistic.1].clone(),
            expected: sign * expected.0,
            expected_at: model.places()[expected.1].clone(),
        }
    }
}

/// The most that is allowed, and the most that is expected, at all places that are `held`, each with its place.
fn furthest(ends: impl Iterator<Item = (f64, f64)>, is_held: impl Fn(usize) -> bool) -> (Furthest, Furthest) {
    let (mut optimistic, mut expected) = ((f64::NEG_INFINITY, 0), (f64::NEG_INFINITY, 0));
    for (place, (most, expectation)) in ends.enumerate() {
        // A model that overflows allows anything.
        let most = if most.is_nan() { f64::INFINITY } else { most };
        // Few places go further than those before: no others are asked for.
        if !(most > optimistic.0 || expectation > expected.0) || !is_held(place) {
            continue;
        }
        if most > optimistic.0 {
            optimistic = (most, place);
        }
        if expectation > expected.0 {
            expected = (expectation, place);
        }
    }
    (optimistic, expected)
}

/// How far the model of a target with this `range` lets it go over the whole region: the most that it concedes at a candidate, and where
/// climbs from the best candidates end; of an index from the best in what is hoped for, as in [`located_reach`].
fn climbed_reach(axes: &Axes, model: &TargetModel<'_>, direction: Direction, region: &Region, range: f64) -> f64 {
    let coarse = reach(model, direction, region, Allowance::CONCESSION);
    if !coarse.optimistic.is_finite() || range == 0.0 {
        return coarse.optimistic;
    }
    let climb = Climb::new(axes, model, direction, region, range);
    let TargetModel::Plain(fits) = model else {
        let hoped = reach(model, direction, region, Allowance::HOPED);
        return direction.further(coarse.optimistic, climb.concession_above(&hoped.optimistic_at));
    };
    let furthest = direction.further(coarse.optimistic, climb.concession_above(&coarse.optimistic_at));
    let reach_of_kinks = with_kinks(fits, direction, region).map(|(most, _)| most);
    let mut furthest = reach_of_kinks.fold(furthest, |most, own| direction.further(most, own));
    // Beside what is noisy or rough a summit that is a little higher than the best candidate says nothing.
    if model.is_regressing() {
        return furthest;
    }
    // The mean distance of neighbours.
    let spacing = (model.places().len() as f64).powf(-1.0 / region.lower.len() as f64);
    let mut starts = vec![coarse.optimistic_at];
    for _ in 1..MAX_SUMMITS {
        let is_apart = |place: &[f64]| {
            let away = |start: &Vec<f64>| (0..place.len()).any(|k| axes.step(k, start[k], place[k]).abs() > APART);
            starts.iter().all(away)
        };
        let next = reach_where(model, direction, region, Allowance::CONCESSION, is_apart);
        if !next.optimistic.is_finite() {
            break;
        }
        if climb.may_exceed(furthest, &next.optimistic_at, 2.0 * spacing) {
            furthest = direction.further(furthest, climb.concession_above(&next.optimistic_at));
        }
        starts.push(next.optimistic_at);
    }
    furthest
}

/// How far values that may have kinks let a target go, and where, part by part of the box: the points of curves are nowhere so dense that they
/// show a kink.
fn with_kinks<'f>(
    fits: &'f LocalFits<'_>,
    direction: Direction,
    region: &'f Region,
) -> impl Iterator<Item = (f64, &'f Vec<f64>)> {
    let sign = direction.sign();
    fits.parts().iter().filter_map(move |fit| {
        let kinked = fit.with_kinks()?;
        let all_in = fit.are_all_in(region);
        let at_places = fit.places().iter().zip(fit.kinked_at_places(kinked));
        let held = at_places.filter(|(place, _)| all_in || region.holds(place));
        let most = |at: Prediction| {
            let miss = Allowance::HOPED.deviations() * at.deviation;
            at.mean + sign * miss.min(kinked.largest_miss)
        };
        let most = held.map(|(place, at)| (most(at), place));
        most.reduce(|furthest, own| if direction.is_beyond(own.0, furthest.0) { own } else { furthest })
    })
}

/// The furthest that values that may have kinks let the target of `model` go, and where.
pub(super) fn reach_with_kinks<'m>(
    model: &'m TargetModel<'_>,
    direction: Direction,
    region: &'m Region,
) -> Option<(f64, &'m Vec<f64>)> {
    let TargetModel::Plain(fits) = model else { return None };
    with_kinks(fits, direction, region).reduce(|a, b| if direction.is_beyond(b.0, a.0) { b } else { a })
}

/// How far the model lets its target go over the whole region: the most that it concedes, located from the best of the places in what
/// is hoped for and from the best in what is conceded, for a model may be unsure far from the extreme that it expects. An index without
/// roughness is located from the first alone: it has kinks, beside which its model is unsure however far the extreme is.
fn located_reach(axes: &Axes, model: &TargetModel<'_>, direction: Direction, region: &Region) -> f64 {
    let from = |place: Vec<f64>| {
        let place = locate(axes, model, direction, Allowance::CONCESSION, place, region);
        model.at(&place, Allowance::CONCESSION).moved(Allowance::CONCESSION, direction.sign())
    };
    let hoped = reach(model, direction, region, Allowance::HOPED);
    let most = |place: &[f64]| direction.further(from(place.to_vec()), hoped.optimistic);
    let is_index = !matches!(model, TargetModel::Plain(_));
    if is_index && !model.is_rough() {
        return most(&hoped.optimistic_at);
    }
    let conceded = reach(model, direction, region, Allowance::CONCESSION);
    let most = direction.further(most(&hoped.optimistic_at), conceded.optimistic);
    // Mostly both begin at the same place, and end there.
    if conceded.optimistic_at == hoped.optimistic_at {
        most
    } else {
        direction.further(most, from(conceded.optimistic_at))
    }
}

/// Moves `place` to the nearest local extreme of what an allowance lets it be: pattern search along the axes and the last
/// successful move, step halved down to 1e-7 of the box.
pub(super) fn locate(
    axes: &Axes,
    model: &TargetModel<'_>,
    direction: Direction,
    allowance: Allowance,
    mut place: Vec<f64>,
    region: &Region,
) -> Vec<f64> {
    let inside = |axis: usize, value: f64| axes.inside(axis, value, [region.lower[axis], region.upper[axis]]);
    const FIRST_STEP: f64 = 0.1;
    const LAST_STEP: f64 = 1e-7;
    const MAX_MOVES: usize = 400;
    const FACE_THICKNESS: f64 = 1e-4;
    let sign = direction.sign();
    let value = |place: &[f64]| sign * model.at(place, allowance).moved(allowance, sign);
    let values = |places: &[Vec<f64>]| -> Vec<f64> {
        model.at_each(places, allowance).into_iter().map(|at| sign * at.moved(allowance, sign)).collect()
    };
    // Whether the last step led nowhere: then half of it hardly leads further along the first axes.
    let mut has_ended = false;
    let mut best = value(&place);
    let mut step = FIRST_STEP;
    let mut moves = 0;
    while step >= LAST_STEP && moves < MAX_MOVES {
        let before = place.clone();
        let (mut has_moved, mut first) = (false, 0);
        // Where no trial is expected to be better, those along all axes are worked out side by side; behind one that is they begin anew.
        while first < place.len() {
            let mut trials: Vec<Vec<f64>> = Vec::with_capacity(2 * place.len());
            let mut axes_of_trials = Vec::with_capacity(2 * place.len());
            let last = if has_ended { place.len() } else { first + 1 };
            for axis in first..last {
                for signed in [step, -step] {
                    let moved = inside(axis, place[axis] + signed);
                    if moved != place[axis] {
                        let mut trial = place.clone();
                        trial[axis] = moved;
                        trials.push(trial);
                        axes_of_trials.push(axis);
                    }
                }
            }
            first = last;
            let better = if has_ended {
                values(&trials).into_iter().enumerate().find(|(_, found)| *found > best)
            } else {
                trials.iter().map(|trial| value(trial)).enumerate().find(|(_, found)| *found > best)
            };
            if let Some((better, found)) = better {
                (best, place, has_moved) = (found, trials.swap_remove(better), true);
                first = axes_of_trials[better] + 1;
            }
        }
        has_ended = !has_moved;
        if has_moved {
            moves += 1;
            let ahead = place.iter().zip(&before).enumerate();
            let trial: Vec<f64> = ahead.map(|(axis, (x, y))| inside(axis, 2.0 * x - y)).collect();
            let found = value(&trial);
            if found > best {
                (best, place) = (found, trial);
            }
        } else {
            step *= 0.5;
        }
    }
    // What the model cannot tell from a face is a face: corners and edges are then met exactly.
    for (axis, (coordinate, (lower, upper))) in place.iter_mut().zip(region.lower.iter().zip(&region.upper)).enumerate()
    {
        if axes.is_periodic(axis) {
            continue;
        }
        if *coordinate < lower + FACE_THICKNESS {
            *coordinate = *lower;
        } else if *coordinate > upper - FACE_THICKNESS {
            *coordinate = *upper;
        }
    }
    place
}

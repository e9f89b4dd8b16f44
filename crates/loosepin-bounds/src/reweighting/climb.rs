//! Up from a place to the nearest one from which no step gains.

use super::Beyond;
use crate::search_box::{Axes, Place, Region};

/// Each step is this part of the one before.
const SHORTER: f64 = 0.25;
/// A parabola through three points, the middle one highest, rises above that by no more than this part of the larger drop.
const PARABOLA: f64 = 0.125;
/// A place as near to a face as this lies on it.
const FACE_THICKNESS: f64 = 1e-9;

/// The nearest place of `region` from which no step along an axis gains, of lengths from `first` down to `last` in units of the box; to
/// its gain is added what a parabola through the last steps may rise above it.
///
/// # Errors
///
/// A place at which the gain is not known.
pub fn climb(
    axes: &Axes,
    mut place: Place,
    region: &Region,
    [first, last]: [f64; 2],
    gain: &impl Fn(&Place) -> Option<f64>,
) -> Result<Beyond, Place> {
    let known = |place: &Place| gain(place).filter(|gain| !gain.is_nan()).ok_or_else(|| place.clone());
    let mut best = known(&place)?;
    let mut step = first;
    loop {
        let mut has_moved = false;
        let mut between = 0.0;
        for axis in 0..place.at.len() {
            let beside = |signed: f64| {
                let mut trial = place.clone();
                trial.at[axis] = axes.inside(axis, trial.at[axis] + signed, [region.lower[axis], region.upper[axis]]);
                ((trial.at[axis] - place.at[axis]).abs() > FACE_THICKNESS).then_some(trial)
            };
            let trials: Vec<Place> = [step, -step].into_iter().filter_map(beside).collect();
            let is_inside = trials.len() > 1;
            let mut drop = 0.0_f64;
            for trial in trials {
                let at_trial = known(&trial)?;
                if at_trial > best {
                    (best, place, has_moved) = (at_trial, trial, true);
                    break;
                }
                drop = drop.max(best - at_trial);
            }
            between += if is_inside { PARABOLA * drop } else { 0.0 };
        }
        if has_moved {
            continue;
        }
        if step <= last {
            return Ok(Beyond { gain: best + between, place });
        }
        step = (SHORTER * step).max(last);
    }
}

#[cfg(test)]
mod tests {
    use super::climb;
    use crate::search_box::{Axes, Place, Region};

    #[test]
    fn analytic_what_lies_between_the_last_steps_is_conceded() {
        // Round-off.
        const TOLERANCE: f64 = 1e-12;
        let of = |u: &[f64]| 2.0 - 3.0 * (u[0] - 0.377).powi(2) - 0.5 * (u[1] - 1.25).powi(2);
        let from = Place { combination: 0, at: vec![0.8, 0.2] };
        for last in [0.05, 0.01] {
            let gain = |place: &Place| Some(of(&place.at));
            let top = climb(&Axes::open(2), from.clone(), &Region::whole(2), [0.1, last], &gain).unwrap();
            let most = of(&[0.377, 1.0]);
            // Inside along the first axis, at a face along the second.
            assert!(top.gain >= most - TOLERANCE && top.gain < most + 3.0 * last * last, "{top:?}");
            assert!((top.place.at[1] - 1.0).abs() < TOLERANCE && (top.place.at[0] - 0.377).abs() < last, "{top:?}");
        }
    }

    #[test]
    fn where_nothing_is_known_the_place_is_told() {
        let from = Place { combination: 0, at: vec![0.5] };
        let gain = |place: &Place| (place.at[0] < 0.75).then_some(place.at[0]);
        let unknown = climb(&Axes::open(1), from, &Region::whole(1), [0.125, 0.01], &gain).unwrap_err();
        assert_eq!(unknown.at, [0.75]);
    }
}

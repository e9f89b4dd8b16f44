//! Combinations of the inputs that are no play, and the linear model at each of them.
//!
//! Inputs: every length, stiffness and coefficient of the study that is no play, and the locked angle with its error. Of up to six of them
//! all corners are looked at; of more the two, for each joint, at which every input stands where it alone widens the factor. The changes
//! that each input makes alone are added as well, a hundredth more: the wider of both counts.

use super::friction::{Friction, coefficients};
use super::locked::Test;
use super::nominal::Nominal;
use super::rig::{ALL_CORNERS, Rig};
use loosepin_mechanics::model::QuantityId;
use loosepin_simulate::accuracy::AccuracyError;

/// What changes of single inputs are multiplied by when they are added: between the corners a sum may be a little larger.
const ADDED_TIMES: f64 = 1.01;

/// The linear model of a reading at one set of values.
pub(crate) struct State {
    /// Inputs that are not in the middle.
    pub changes: Vec<(QuantityId, f64)>,
    pub nominal: Nominal,
    pub friction: Friction,
}

/// The linear model of a reading wherever its inputs may be.
pub(crate) struct States {
    pub middle: State,
    /// Each input at its lower and at its upper end, the others in the middle.
    pub alone: Vec<[State; 2]>,
    /// All inputs at an end.
    pub together: Vec<State>,
}

impl States {
    /// # Errors
    /// The mechanism cannot be locked at some of the values.
    pub fn new(rig: &Rig<'_>, test: &Test) -> Result<Self, AccuracyError> {
        let coefficients = match test.friction {
            Some(stated) => vec![stated; rig.mechanism.plays.len()],
            None => coefficients(rig)?,
        };
        let inputs = rig.others.len() + usize::from(test.pose_error_rad > 0.0);
        // An end of each input, or none for the middle.
        let at = |ends: &dyn Fn(usize) -> Option<usize>| -> Result<State, AccuracyError> {
            let own = rig.others.iter().enumerate();
            let changes: Vec<(QuantityId, f64)> = own
                .filter_map(|(input, other)| ends(input).map(|end| (other.quantity, other.interval_si[end])))
                .collect();
            let turned_rad = match ends(rig.others.len()) {
                Some(0) => -test.pose_error_rad,
                Some(_) => test.pose_error_rad,
                None => 0.0,
            };
            let values = rig.values_with(&changes)?;
            let pose_rad = test.pose_rad + turned_rad;
            let nominal = Nominal::at(&rig.mechanism, &values, &Test { pose_rad, ..*test })?;
            let friction = Friction::new(rig, &values, &nominal.coordinates, &nominal.loads, &coefficients)?;
            Ok(State { changes, nominal, friction })
        };
        let middle = at(&|_| None)?;
        let mut alone = Vec::with_capacity(inputs);
        for input in 0..inputs {
            let end = |which: usize| at(&|other| (other == input).then_some(which));
            alone.push([end(0)?, end(1)?]);
        }
        let mut states = Self { middle, alone, together: Vec::new() };
        let mut corners: Vec<Vec<usize>> = Vec::new();
        if inputs > ALL_CORNERS {
            for sign in [-1.0, 1.0] {
                let factors = |state: &State| states.widest_factors(state, sign);
                let ends: Vec<[Vec<f64>; 2]> =
                    states.alone.iter().map(|ends| [factors(&ends[0]), factors(&ends[1])]).collect();
                for joint in 0..coefficients.len() {
                    let widens = |[low, high]: &[Vec<f64>; 2]| usize::from(sign * high[joint] > sign * low[joint]);
                    corners.push(ends.iter().map(widens).collect());
                }
            }
            corners.sort();
            corners.dedup();
        } else if inputs > 1 {
            corners.extend((0..1_usize << inputs).map(|bits| (0..inputs).map(|input| (bits >> input) & 1).collect()));
        }
        for corner in &corners {
            // Without an error the locked angle is no input, and its place is beyond the corner.
            states.together.push(at(&|input| corner.get(input).copied())?);
        }
        Ok(states)
    }

    /// Least (`sign` -1) or largest factors at a state.
    fn widest_factors(&self, state: &State, sign: f64) -> Vec<f64> {
        let factors = state.nominal.factors_with_friction(&state.friction);
        factors.iter().map(|[least, _, largest]| if sign < 0.0 { *least } else { *largest }).collect()
    }

    /// Largest (`sign` 1) or least (-1) entries of `of` wherever the inputs may be.
    pub fn furthest(&self, sign: f64, of: impl Fn(&State) -> Vec<f64>) -> Vec<f64> {
        let alone: Vec<[Vec<f64>; 2]> = self.alone.iter().map(|ends| [of(&ends[0]), of(&ends[1])]).collect();
        let together: Vec<Vec<f64>> = self.together.iter().map(&of).collect();
        let furthest = |(entry, middle): (usize, f64)| {
            let grows = |value: f64| (sign * (value - middle)).max(0.0);
            let added: f64 = alone.iter().map(|[low, high]| grows(low[entry]).max(grows(high[entry]))).sum();
            let at_once = together.iter().map(|values| grows(values[entry])).fold(0.0, f64::max);
            middle + sign * f64::max(ADDED_TIMES * added, at_once)
        };
        of(&self.middle).into_iter().enumerate().map(furthest).collect()
    }

    /// Largest (`sign` 1) or least (-1) entries of `of`, none of them negative: what each input changes by itself is multiplied, as powers
    /// of loads and stiffnesses do, and added where it is zero in the middle.
    pub fn furthest_by_ratio<E>(&self, sign: f64, of: impl Fn(&State) -> Result<Vec<f64>, E>) -> Result<Vec<f64>, E> {
        let mut found = of(&self.middle)?;
        let middle = found.clone();
        let wider = |a: f64, b: f64| if sign < 0.0 { a.min(b) } else { a.max(b) };
        for ends in &self.alone {
            let [low, high] = [of(&ends[0])?, of(&ends[1])?];
            for (entry, found) in found.iter_mut().enumerate() {
                let own = wider(wider(low[entry], high[entry]), middle[entry]);
                if middle[entry] > 0.0 {
                    *found *= own / middle[entry];
                } else {
                    *found += own - middle[entry];
                }
            }
        }
        for state in &self.together {
            for (found, own) in found.iter_mut().zip(of(state)?) {
                *found = wider(*found, own);
            }
        }
        Ok(found)
    }
}

//! The inverse question for several inputs at once: all by the same share, or two of them against each other.

use super::one::{HALVINGS, described, is_met_twice, least_tried_si};
use crate::error::StudyError;
use crate::file::{Allowance, Study};
use crate::runs::all_runs::Runs;
use loosepin_result::study::{LoosenedInput, Together, TogetherCheck, TogetherRecord};

/// Values of the first input for which a frontier has the loosest value of the second.
const COLUMNS: usize = 7;
/// Times that the range of the second input is halved at each of them.
const COLUMN_HALVINGS: usize = 5;

/// Combinations that are tried at most, for the plan.
pub fn most_tried_together(how: Together) -> usize {
    match how {
        Together::Proportional => 2 + HALVINGS,
        // Both ends of the first input, and each column.
        Together::Frontier => 2 + HALVINGS + COLUMNS * (1 + COLUMN_HALVINGS),
    }
}

/// How far the inputs of `[allow]` may be loosened together; `None` if that is not asked.
///
/// A combination is met where two direct studies are, with two sets of random numbers. Looser is taken to be never better: what is at
/// least as loose in every input as a refused combination is refused without a run, and what is at least as tight as one that is met is met.
///
/// # Errors
/// Those of the studies.
pub fn together(runs: &Runs<'_>) -> Result<Option<TogetherRecord>, StudyError> {
    let Some(how) = runs.study.together else { return Ok(None) };
    let allowances = &runs.study.allowances;
    let (mut checks, mut made) = (Vec::new(), 0);
    let ranges: Vec<[f64; 2]> =
        allowances.iter().map(|allowance| [least_tried_si(allowance), allowance.up_to_si]).collect();
    let found = search(how, &ranges, |values_si| {
        let set: Vec<(&Allowance, f64)> = allowances.iter().zip(values_si.iter().copied()).collect();
        is_met_twice(runs, &set, |answer, is_confirmation| {
            made += answer.runs as u64;
            checks.push(TogetherCheck { values_si: values_si.to_vec(), answer: answer.check(is_confirmation) });
        })
    })?;
    Ok(Some(TogetherRecord {
        how,
        inputs: loosened_inputs(runs.study, &ranges),
        allowed_si: found.allowed,
        beyond_si: found.beyond,
        checks,
        runs: made,
    }))
}

fn loosened_inputs(study: &Study, ranges: &[[f64; 2]]) -> Vec<LoosenedInput> {
    let one = |(allowance, &[least_si, up_to_si]): (&Allowance, &[f64; 2])| {
        let (what, unit) = described(study, allowance);
        LoosenedInput { path: allowance.path.clone(), what, unit, least_si, up_to_si }
    };
    study.allowances.iter().zip(ranges).map(one).collect()
}

/// The loosest combinations that are met, and for each the next looser one that is not.
#[derive(Debug, PartialEq)]
struct Found {
    allowed: Vec<Vec<f64>>,
    beyond: Vec<Vec<f64>>,
}

/// Combinations within `ranges` (least and largest value of each input) up to which `is_met`.
fn search<E>(how: Together, ranges: &[[f64; 2]], is_met: impl FnMut(&[f64]) -> Result<bool, E>) -> Result<Found, E> {
    let mut known = Known { is_met, met: Vec::new(), refused: Vec::new() };
    let least: Vec<f64> = ranges.iter().map(|range| range[0]).collect();
    let largest: Vec<f64> = ranges.iter().map(|range| range[1]).collect();
    if known.holds(&largest)? {
        return Ok(Found { allowed: vec![largest], beyond: Vec::new() });
    }
    if !known.holds(&least)? {
        return Ok(Found { allowed: Vec::new(), beyond: vec![least] });
    }
    match how {
        Together::Proportional => {
            // Below its least value no input goes, however small the share is.
            let at = |share: f64| ranges.iter().map(|&[least, up_to]| least.max(share * up_to)).collect();
            let [allowed, beyond] = known.halve(HALVINGS, [0.0, 1.0], at)?;
            Ok(Found { allowed: vec![at(allowed)], beyond: vec![at(beyond)] })
        }
        Together::Frontier => {
            let [of_first, of_second] = [ranges[0], ranges[1]];
            let widest = vec![of_first[1], of_second[0]];
            // Nothing is to be seen beyond the loosest value of the first input.
            let mut found = Found { allowed: Vec::new(), beyond: Vec::new() };
            let most = if known.holds(&widest)? {
                of_first[1]
            } else {
                let [met, refused] = known.halve(HALVINGS, of_first, |first| vec![first, of_second[0]])?;
                found.beyond.push(vec![refused, of_second[0]]);
                met
            };
            for column in 0..COLUMNS {
                let share = column as f64 / (COLUMNS - 1) as f64;
                let first = if column + 1 == COLUMNS { most } else { of_first[0] + share * (most - of_first[0]) };
                // Where the first input has no room, all columns are one.
                if found.allowed.last().is_some_and(|last| last[0] == first) {
                    continue;
                }
                let at = |second: f64| vec![first, second];
                if known.holds(&at(of_second[1]))? {
                    found.allowed.push(at(of_second[1]));
                    continue;
                }
                let [allowed, beyond] = known.halve(COLUMN_HALVINGS, of_second, at)?;
                found.allowed.push(at(allowed));
                found.beyond.push(at(beyond));
            }
            Ok(found)
        }
    }
}

/// What is known about combinations.
struct Known<F> {
    is_met: F,
    met: Vec<Vec<f64>>,
    refused: Vec<Vec<f64>>,
}

impl<F> Known<F> {
    /// Whether `values` are met: by earlier results, or else by a trial.
    fn holds<E>(&mut self, values: &[f64]) -> Result<bool, E>
    where
        F: FnMut(&[f64]) -> Result<bool, E>,
    {
        let is_within = |tight: &[f64], loose: &[f64]| tight.iter().zip(loose).all(|(tight, loose)| tight <= loose);
        if self.refused.iter().any(|refused| is_within(refused, values)) {
            return Ok(false);
        }
        if self.met.iter().any(|met| is_within(values, met)) {
            return Ok(true);
        }
        let is_met = (self.is_met)(values)?;
        if is_met { &mut self.met } else { &mut self.refused }.push(values.to_vec());
        Ok(is_met)
    }

    /// The last met and the first refused value between a met and a refused one, after a given number of halvings.
    fn halve<E>(
        &mut self,
        halvings: usize,
        [mut met, mut refused]: [f64; 2],
        at: impl Fn(f64) -> Vec<f64>,
    ) -> Result<[f64; 2], E>
    where
        F: FnMut(&[f64]) -> Result<bool, E>,
    {
        for _ in 0..halvings {
            let middle = 0.5 * (met + refused);
            if self.holds(&at(middle))? {
                met = middle;
            } else {
                refused = middle;
            }
        }
        Ok([met, refused])
    }
}

#[cfg(test)]
mod tests {
    use std::convert::Infallible;

    use super::{COLUMN_HALVINGS, COLUMNS, Together, most_tried_together, search};

    /// Inside an ellipse with half axes 3 and 5.
    fn is_inside(values: &[f64]) -> bool {
        (values[0] / 3.0).powi(2) + (values[1] / 5.0).powi(2) <= 1.0
    }

    fn counted(how: Together, ranges: &[[f64; 2]]) -> (super::Found, usize) {
        let mut tried = 0;
        let found = search(how, ranges, |values| {
            tried += 1;
            Ok::<bool, Infallible>(is_inside(values))
        });
        (found.unwrap(), tried)
    }

    #[test]
    fn analytic_the_same_share_of_both() {
        // s² (8/3)² + s² (6/5)² = 1 at s = 1 / hypot(8/3, 6/5) = 0.34197…
        let (found, tried) = counted(Together::Proportional, &[[0.0, 8.0], [0.0, 6.0]]);
        let share = 1.0 / (8.0_f64 / 3.0).hypot(1.2);
        let [allowed, beyond] = [found.allowed[0][0] / 8.0, found.beyond[0][0] / 8.0];
        assert!(allowed <= share && share < beyond && beyond - allowed <= 1.0 / 128.0, "{allowed} {beyond}");
        assert_eq!(found.allowed[0][1] / 6.0, allowed);
        assert!(tried <= most_tried_together(Together::Proportional));
    }

    #[test]
    fn analytic_no_input_goes_below_its_least_value() {
        let (found, _) = counted(Together::Proportional, &[[2.5, 8.0], [0.0, 6.0]]);
        // 2.5 leaves 5 sqrt(1 - (2.5/3)²) = 2.763… for the second, a share of 0.46; the first is above its least from 0.3125 on.
        let values = &found.allowed[0];
        assert!(values[0] >= 2.5 && is_inside(values) && !is_inside(&found.beyond[0]), "{found:?}");
    }

    #[test]
    fn analytic_a_frontier_is_the_arc_of_an_ellipse() {
        let (found, tried) = counted(Together::Frontier, &[[0.0, 8.0], [0.0, 6.0]]);
        // Beyond the last column there is the first input that is refused.
        assert_eq!((found.allowed.len(), found.beyond.len()), (COLUMNS, COLUMNS + 1));
        for (allowed, beyond) in found.allowed.iter().zip(&found.beyond[1..]) {
            let arc = 5.0 * (1.0 - (allowed[0] / 3.0).powi(2)).sqrt();
            assert_eq!(allowed[0], beyond[0]);
            assert!(allowed[1] <= arc && arc < beyond[1], "{allowed:?} {arc} {beyond:?}");
            assert!(beyond[1] - allowed[1] <= 6.0 / f64::from(1 << COLUMN_HALVINGS));
        }
        let last = found.allowed.last().unwrap();
        assert!(last[0] <= 3.0 && 3.0 - last[0] <= 8.0 / 128.0, "{last:?}");
        assert!(tried <= most_tried_together(Together::Frontier) - COLUMNS, "{tried}");
    }

    #[test]
    fn analytic_everything_and_nothing() {
        let (all, tried) = counted(Together::Frontier, &[[0.0, 1.0], [0.0, 1.0]]);
        assert_eq!((all.allowed, all.beyond, tried), (vec![vec![1.0, 1.0]], Vec::new(), 1));
        let (none, tried) = counted(Together::Frontier, &[[4.0, 8.0], [0.0, 1.0]]);
        assert_eq!((none.allowed, none.beyond, tried), (Vec::new(), vec![vec![4.0, 0.0]], 2));
        // The whole range of the second input is allowed where the first is small.
        let (part, _) = counted(Together::Frontier, &[[0.0, 8.0], [0.0, 4.0]]);
        assert_eq!(part.allowed[0], vec![0.0, 4.0]);
        assert!(part.allowed.len() == COLUMNS && part.beyond.len() <= COLUMNS);
    }

    #[test]
    fn analytic_a_limit_of_the_first_input_alone_and_one_without_room() {
        let of = |ranges: &[[f64; 2]], limit: f64| {
            search(Together::Frontier, ranges, |values| Ok::<bool, Infallible>(values[0] <= limit && values[1] <= 1.5))
                .unwrap()
        };
        let found = of(&[[0.0, 8.0], [0.0, 1.0]], 3.0);
        assert_eq!((found.allowed.len(), found.beyond.len()), (COLUMNS, 1));
        assert!(found.allowed.iter().all(|pair| pair[1] == 1.0) && found.beyond[0][0] > 3.0, "{found:?}");
        let narrow = of(&[[0.1, 8.0], [0.0, 6.0]], 0.12);
        assert_eq!(narrow.allowed.len(), 1, "{narrow:?}");
    }
}

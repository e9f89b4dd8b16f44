//! Grids of models, made once for all searches over the same points.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use crate::data::table::{Purpose, SampleTable};
use crate::search::models::grid::Grid;

/// Numbers of points, and a part of them.
type Key = (Vec<usize>, usize);

/// The grids of some of the same points, part by part.
#[derive(Default)]
pub(crate) struct SharedGrids {
    made: Mutex<BTreeMap<Key, Option<Arc<Grid>>>>,
    /// Grids of the points of the round before.
    earlier: Vec<Arc<Grid>>,
}

/// Grids of the last round, kept beside its rows.
#[derive(Default)]
struct KeptGrids(Mutex<BTreeMap<Purpose, Vec<Arc<Grid>>>>);

impl SharedGrids {
    /// None so far, of points that have been appended to those of the last round that was kept for this purpose.
    pub fn after(table: &SampleTable, purpose: Purpose) -> Self {
        let kept = table.kept::<KeptGrids>();
        let rounds = kept.0.lock().unwrap_or_else(PoisonError::into_inner);
        Self { made: Mutex::default(), earlier: rounds.get(&purpose).cloned().unwrap_or_default() }
    }

    /// Keeps the grids to which points may be appended, in the place of those of the round before.
    pub fn keep(self, table: &SampleTable, purpose: Purpose) {
        let made = self.made.into_inner().unwrap_or_else(PoisonError::into_inner).into_values().flatten();
        let grids = made.filter(|grid| grid.may_be_appended_to()).collect();
        let kept = table.kept::<KeptGrids>();
        kept.0.lock().unwrap_or_else(PoisonError::into_inner).insert(purpose, grids);
    }

    /// The cached grid of the part of the `points` with these numbers, or the result of `make`, which is then kept; `make` is given the
    /// earlier grids. Nobody waits for another who makes it: both make the same.
    pub fn of(
        &self,
        points: &[usize],
        part: usize,
        make: impl FnOnce(&[Arc<Grid>]) -> Option<Grid>,
    ) -> Option<Arc<Grid>> {
        let key = (points.to_vec(), part);
        let known = || self.made.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(grid) = known().get(&key) {
            return grid.clone();
        }
        let grid = make(&self.earlier).map(Arc::new);
        known().entry(key).or_insert(grid).clone()
    }
}

#[cfg(test)]
mod tests {
    use super::{Grid, SharedGrids};
    use crate::data::table::{Purpose, SampleTable};
    use crate::search::design::first_points;
    use crate::search::search_box::Axes;
    use std::sync::Arc;

    #[test]
    fn identity_the_same_points_have_one_grid_and_others_another() {
        let grids = SharedGrids::default();
        let points = first_points(3, 2, 12).unwrap();
        let of = |numbers: &[usize], part: usize| {
            let own: Vec<Vec<f64>> = numbers.iter().map(|&number| points[number].clone()).collect();
            grids.of(numbers, part, |earlier| Grid::try_new(&own, true, &Axes::open(2), earlier))
        };
        let [all, again] = [0, 0].map(|part| of(&[0, 1, 2, 3, 4, 5, 6, 7], part).expect("a grid"));
        assert!(Arc::ptr_eq(&all, &again));
        let few = of(&[0, 1, 2, 4, 5, 6, 7], 0).expect("a grid");
        assert!(!Arc::ptr_eq(&all, &few) && few.seen.len() == 7);
        assert!(!Arc::ptr_eq(&all, &of(&[0, 1, 2, 3, 4, 5, 6, 7], 1).expect("a grid")));
        // A single point has no model, now and later.
        assert!(of(&[3], 0).is_none() && of(&[3], 0).is_none());
    }

    #[test]
    fn identity_a_grid_of_appended_points_has_the_bits_of_one_made_anew() {
        let (table, axes) = (SampleTable::new(1), Axes::open(2));
        let points = first_points(3, 2, 40).unwrap();
        let value = |at: &Vec<f64>| (3.0 * at[0]).sin() + at[1] * at[1];
        let mut appended_to = 0;
        for count in [20, 26, 27, 40] {
            let grids = SharedGrids::after(&table, Purpose::DoubleLoop);
            let own = &points[..count];
            let numbers: Vec<usize> = (0..count).collect();
            let grid = grids.of(&numbers, 0, |earlier| Grid::try_new(own, true, &axes, earlier)).expect("a grid");
            let anew = Grid::try_new(own, true, &axes, &[]).expect("a grid");
            appended_to += usize::from(grid.is_appended());
            let values: Vec<f64> = own.iter().map(value).collect();
            for level in 0..grid.levels() {
                for (model, expected) in grid.level(level).iter().zip(anew.level(level)) {
                    let [own, expected] = [model, expected].map(|model| {
                        let rest = model.whitened_rest(&values);
                        let numbers = [&rest[..], &model.errors(&rest), &[model.ln_determinants()]].concat();
                        (model.place(), numbers.into_iter().map(f64::to_bits).collect::<Vec<_>>())
                    });
                    assert_eq!(own, expected, "{count} points");
                }
                assert_eq!(grid.level(level).len(), anew.level(level).len());
            }
            grids.keep(&table, Purpose::DoubleLoop);
        }
        assert_eq!(appended_to, 3);
        // Of other points, and for another purpose, nothing is known.
        let others: Vec<Vec<f64>> = points.iter().rev().cloned().collect();
        let after = |purpose| SharedGrids::after(&table, purpose);
        let made = |grids: &SharedGrids, points: &[Vec<f64>]| {
            let make = |earlier: &[Arc<Grid>]| Grid::try_new(points, true, &axes, earlier);
            grids.of(&[0], 0, make).expect("a grid").is_appended()
        };
        assert!(!made(&after(Purpose::DoubleLoop), &others) && !made(&after(Purpose::Extreme), &points));
    }
}

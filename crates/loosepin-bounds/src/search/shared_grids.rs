//! Grids of models, made once for all searches over the same points.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use super::grid::Grid;

/// Numbers of points, and a part of them.
type Key = (Vec<usize>, usize);

/// The grids of some of the same points, part by part.
#[derive(Default)]
pub(crate) struct SharedGrids(Mutex<BTreeMap<Key, Option<Arc<Grid>>>>);

impl SharedGrids {
    /// The grid of a part of those `points` (their numbers), or what `make` gives, which is then kept. Nobody waits for another who makes it:
    /// both make the same.
    pub fn of(&self, points: &[usize], part: usize, make: impl FnOnce() -> Option<Grid>) -> Option<Arc<Grid>> {
        let key = (points.to_vec(), part);
        let known = || self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(grid) = known().get(&key) {
            return grid.clone();
        }
        let grid = make().map(Arc::new);
        known().entry(key).or_insert(grid).clone()
    }
}

#[cfg(test)]
mod tests {
    use super::{Grid, SharedGrids};
    use crate::search::design::first_points;
    use crate::search::search_box::Axes;
    use std::sync::Arc;

    #[test]
    fn identity_the_same_points_have_one_grid_and_others_another() {
        let grids = SharedGrids::default();
        let points = first_points(3, 2, 12).unwrap();
        let of = |numbers: &[usize], part: usize| {
            let own: Vec<Vec<f64>> = numbers.iter().map(|&number| points[number].clone()).collect();
            grids.of(numbers, part, || Grid::try_new(&own, true, &Axes::open(2)))
        };
        let [all, again] = [0, 0].map(|part| of(&[0, 1, 2, 3, 4, 5, 6, 7], part).expect("a grid"));
        assert!(Arc::ptr_eq(&all, &again));
        let few = of(&[0, 1, 2, 4, 5, 6, 7], 0).expect("a grid");
        assert!(!Arc::ptr_eq(&all, &few) && few.seen.len() == 7);
        assert!(!Arc::ptr_eq(&all, &of(&[0, 1, 2, 3, 4, 5, 6, 7], 1).expect("a grid")));
        // A single point has no model, now and later.
        assert!(of(&[3], 0).is_none() && of(&[3], 0).is_none());
    }
}

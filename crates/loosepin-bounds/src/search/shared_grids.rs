//! Grids of models, made once for all searches over the same points.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use super::grid::Grid;

/// The grids of some of the same points, part by part.
#[derive(Default)]
pub(crate) struct SharedGrids(Mutex<BTreeMap<(Vec<usize>, usize), Option<Arc<Grid>>>>);

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

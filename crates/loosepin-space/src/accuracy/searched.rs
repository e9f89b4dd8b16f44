//! Searches for worst cases over a turn: in which positions, and what they find.

use crate::accuracy::error::AccuracyError;
use crate::accuracy::extreme::SearchOptions;
use crate::accuracy::pose_accuracy::PoseAccuracy;
use crate::output::SpatialOutput;
use crate::stop::IsStopped;
use loosepin_result::motion::SearchedPosition;

/// Relative difference of worst cases that is round-off.
const SAME: f64 = 1e-9;

/// The position with the largest worst case of first order, and that of the positions in which play comes near no dead centre.
#[derive(Debug, Clone)]
pub struct WorstPlaces<T> {
    worst: Option<Worst<T>>,
    worst_regular: Option<Worst<T>>,
}

/// The largest worst case of first order so far.
#[derive(Debug, Clone)]
pub struct Worst<T> {
    /// Number of the position.
    pub position: usize,
    /// What is kept of it.
    pub place: T,
    size: f64,
}

impl<T> Default for WorstPlaces<T> {
    fn default() -> Self {
        Self { worst: None, worst_regular: None }
    }
}

impl<T: Clone> WorstPlaces<T> {
    /// Takes the next position, with the size of the worst case of first order. Play comes near no dead centre in one that is regular.
    /// One whose effect is no number is left out.
    pub fn add(&mut self, position: usize, size: f64, is_regular: bool, place: &T) {
        if size.is_nan() {
            return;
        }
        let rivals = [Some(&mut self.worst), is_regular.then_some(&mut self.worst_regular)];
        for known in rivals.into_iter().flatten() {
            // Round-off decides nothing: the first of several alike.
            if known.as_ref().is_none_or(|known| size > known.size * (1.0 + SAME)) {
                *known = Some(Worst { position, place: place.clone(), size });
            }
        }
    }

    /// The position with the largest worst case.
    pub fn worst(&self) -> Option<&Worst<T>> {
        self.worst.as_ref()
    }

    /// Where worst cases are searched: in the worst position, then in the worst regular one where that is another.
    pub fn searched(&self) -> impl Iterator<Item = &Worst<T>> {
        let worst = self.worst.iter();
        let is_other = |own: &&Worst<T>| self.worst.as_ref().is_none_or(|worst| worst.position != own.position);
        worst.chain(self.worst_regular.iter().filter(is_other))
    }
}

impl PoseAccuracy<'_> {
    /// What a search for the worst case of an output finds in this position, which has a number in its turn; with proven ends on demand. Until it is
    /// stopped.
    ///
    /// # Errors
    ///
    /// As for [`Self::worst_case_until`].
    pub fn searched(
        &self,
        position: usize,
        output: &SpatialOutput,
        is_proven: bool,
        is_stopped: IsStopped,
    ) -> Result<SearchedPosition, AccuracyError> {
        let exact = self.worst_case_until(output, &SearchOptions::default(), is_stopped)?;
        let proven = || self.proven_end(output).map(|ends| [ends.smallest, ends.largest]);
        Ok(SearchedPosition {
            position,
            found_si: [exact.smallest.deviation, exact.largest.deviation],
            proven_si: is_proven.then(|| proven().unwrap_or([f64::NEG_INFINITY, f64::INFINITY])),
            conditions: self.conditions(),
        })
    }
}

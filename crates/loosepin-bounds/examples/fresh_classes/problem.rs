//! A problem with exact bounds, and what tells whether it is visible.

use crate::exact::{Case, Exact, NORMAL, UNIT};
use std::sync::Arc;

/// A shared function of u.
pub type Shared = Arc<dyn Fn(&[f64]) -> f64 + Send + Sync>;

pub struct Problem {
    pub case: Case,
    /// What is looked at to tell whether the problem is visible, with its ends and the scatter of a run beside it.
    pub location: Shared,
    pub location_ends: [f64; 2],
    pub scatter: f64,
    /// Probability of what happens in the fewest mechanisms.
    pub rarest: f64,
}

impl Problem {
    /// A response of so many standard normal inputs and numbers in unit intervals.
    pub fn new(
        [random, unknown]: [usize; 2],
        (location, location_ends): (Shared, [f64; 2]),
        scatter: f64,
        response: impl Fn(&[f64], &[f64]) -> f64 + Send + Sync + 'static,
        exact: Vec<Exact>,
    ) -> Self {
        let mut case = Case::new("drawn", &vec![NORMAL; random], &vec![UNIT; unknown], response);
        case.exact = exact;
        Self { case, location, location_ends, scatter, rarest: 1.0 }
    }

    pub fn with_magnitude(self, magnitude: f64) -> Self {
        Self { case: self.case.with_magnitude(magnitude), ..self }
    }
}

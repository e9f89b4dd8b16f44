//! Cost of a study.

use loosepin_bounds::PromisePlan;

/// Estimated cost of a study.
#[derive(Debug, Clone, Copy)]
pub struct CostEstimate {
    /// As [`crate::plan_runs`].
    pub most_runs: usize,
    /// Those among them that seek the loosest values.
    pub search_runs: usize,
    /// Mean processor time of a run on the lanes of one thread, s; `None` if the first steps do not show it.
    pub run_s: Option<f64>,
    /// Cost of the runs of a promise, if there is one.
    pub promise: Option<PromiseCost>,
}

/// Cost of a promise.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PromiseCost {
    /// Ends that are promised together.
    pub ends: usize,
    /// Boxes: combinations of the members of lists and focal elements.
    pub boxes: usize,
    /// Values in each box.
    pub values: usize,
    /// Runs at each value.
    pub inner: usize,
    /// All of them.
    pub runs: usize,
}

impl PromiseCost {
    pub(crate) fn new(plan: &PromisePlan) -> Self {
        Self { ends: plan.ends(), boxes: plan.boxes(), values: plan.values(), inner: plan.inner(), runs: plan.runs() }
    }
}

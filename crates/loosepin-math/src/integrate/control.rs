//! The next step from the error of the last one.

/// Step-size control by the local error: h_new = h · 0.9 · error^(-1/order), within limits.
#[derive(Debug, Clone, Copy)]
pub struct StepControl {
    order: u32,
    was_rejected: bool,
}

impl StepControl {
    /// For a method of this order.
    pub fn new(order: u32) -> Self {
        Self { order, was_rejected: false }
    }

    /// error^(-1/order); the eighth root by square roots, which are cheaper and correctly rounded.
    fn inverse_root(&self, error: f64) -> f64 {
        if self.order == 8 { 1.0 / error.sqrt().sqrt().sqrt() } else { libm::pow(error, -1.0 / f64::from(self.order)) }
    }

    /// Factor for the next step after an accepted one; no growth directly after a rejection.
    pub fn after_acceptance(&mut self, error: f64) -> f64 {
        let largest = if self.was_rejected { 1.0 } else { 6.0 };
        self.was_rejected = false;
        if error == 0.0 { largest } else { (0.9 * self.inverse_root(error)).clamp(0.2, largest) }
    }

    /// Factor for another try of a rejected step.
    pub fn after_rejection(&mut self, error: f64) -> f64 {
        self.was_rejected = true;
        // An error that is not a number comes from a step far too long.
        if error.is_finite() { (0.9 * self.inverse_root(error)).clamp(0.1, 0.9) } else { 0.1 }
    }
}

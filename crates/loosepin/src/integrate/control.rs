//! The next step from the error of the last one.

/// Step-size control by the local error: h_new = h · 0.9 · error^(-1/order), within limits.
#[derive(Debug, Clone, Copy)]
pub struct StepControl {
    exponent: f64,
    was_rejected: bool,
}

impl StepControl {
    /// For a method of this order.
    pub fn new(order: u32) -> Self {
        Self { exponent: -1.0 / f64::from(order), was_rejected: false }
    }

    /// Factor for the next step after an accepted one; no growth directly after a rejection.
    pub fn after_acceptance(&mut self, error: f64) -> f64 {
        let largest = if self.was_rejected { 1.0 } else { 6.0 };
        self.was_rejected = false;
        if error == 0.0 { largest } else { (0.9 * libm::pow(error, self.exponent)).clamp(0.2, largest) }
    }

    /// Factor for another try of a rejected step.
    pub fn after_rejection(&mut self, error: f64) -> f64 {
        self.was_rejected = true;
        // An error that is not a number comes from a step far too long.
        if error.is_finite() { (0.9 * libm::pow(error, self.exponent)).clamp(0.1, 0.9) } else { 0.1 }
    }
}

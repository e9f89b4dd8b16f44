//! Rare events that no run of a sample shows, but single runs that were made for something else do.
//!
//! ```text
//! p <= 1 - γ^(1/N),   mean:       p D,   upwards and downwards
//!                     variance:   p D² + 2 D σ √p upwards, 2 D σ √p downwards
//! ```
//!
//! with N runs in the sample, γ the chance of a miss on one side (C. J. Clopper and E. S. Pearson, "The use of confidence or fiducial limits
//! illustrated in the case of the binomial", Biometrika 26 (1934) 404-413, for no hit of N), D by how much the response jumps, the largest
//! that was seen, and σ the standard deviation without the event: |Cov(y, D·1)| <= σ D √p for any dependence of the two. A share of runs needs
//! nothing added: the limits of Clopper and Pearson for N independent runs hold for any response.

use super::estimate::{Confidence, Estimate};

/// How far single runs lie from what a sample lets expect of them; not negative.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct UnsampledEvents {
    pub below: f64,
    pub above: f64,
}

impl UnsampledEvents {
    /// The larger of both.
    pub fn largest(&self) -> f64 {
        self.below.max(self.above)
    }

    /// The largest share p of runs with the event of which a sample of `runs` may have none.
    fn largest_share(runs: usize, confidence: &Confidence) -> f64 {
        -libm::expm1(libm::log(confidence.miss_of_one_side()) / runs as f64)
    }

    /// `mean` over `runs` with what the event may add to its error.
    pub fn added_to_mean(&self, mean: Estimate, runs: usize, confidence: &Confidence) -> Estimate {
        let share = Self::largest_share(runs, confidence);
        Estimate { below: mean.below + share * self.below, above: mean.above + share * self.above, ..mean }
    }

    /// `variance` over `runs` with what the event may add to its error.
    pub fn added_to_variance(&self, variance: Estimate, runs: usize, confidence: &Confidence) -> Estimate {
        let share = Self::largest_share(runs, confidence);
        let jump = self.largest();
        let of_covariance = 2.0 * jump * (share * variance.value.max(0.0)).sqrt();
        let above = variance.above + share * jump * jump + of_covariance;
        Estimate { below: variance.below + of_covariance, above, ..variance }
    }

    /// The same for `change` of the response, a convex function of it, over the values from `low` to `high`.
    pub fn changed(&self, [low, high]: [f64; 2], change: impl Fn(f64) -> f64) -> Self {
        let steps = [low, high]
            .into_iter()
            .flat_map(|value| [value - self.below, value + self.above].map(|moved| change(moved) - change(value)));
        let of_steps = steps.fold([0.0_f64; 2], |[below, above], step| [below.max(-step), above.max(step)]);
        Self { below: of_steps[0], above: of_steps[1] }
    }

    /// How many of `runs` may have the event.
    pub fn most_runs(runs: usize, confidence: &Confidence) -> usize {
        ((Self::largest_share(runs, confidence) * runs as f64).ceil() as usize).min(runs)
    }
}

#[cfg(test)]
mod tests {
    use super::UnsampledEvents;
    use crate::estimators::estimate::{Confidence, Estimate};

    #[test]
    fn analytic_an_event_of_that_share_is_missed_by_the_sample_as_often_as_stated() {
        let confidence = Confidence::new(0.99, 8);
        let share = UnsampledEvents::largest_share(256, &confidence);
        assert!(((1.0 - share).powi(256) / 0.005 - 1.0).abs() < 1e-9, "{share}");
        assert_eq!(UnsampledEvents::most_runs(256, &confidence), 6);
    }

    #[test]
    fn analytic_mean_and_variance_with_an_event_of_that_share_lie_in_their_intervals() {
        let confidence = Confidence::new(0.99, 8);
        let unseen = UnsampledEvents { below: 0.0, above: 4.0 };
        let (p, exact) = (UnsampledEvents::largest_share(256, &confidence), Estimate::symmetric(1.0, 0.0));
        let mean = unseen.added_to_mean(exact, 256, &confidence);
        assert!(mean.below == 0.0 && (mean.above - 4.0 * p).abs() < 1e-15, "{mean:?}");
        let variance = unseen.added_to_variance(exact, 256, &confidence);
        // The event where the response is greatest, least, or anywhere, of a response with variance 1: ±1 each in half of the runs.
        for covariance in [4.0 * p, -4.0 * p, 0.0] {
            let with = 1.0 + 16.0 * p * (1.0 - p) + 2.0 * covariance;
            assert!(with <= 1.0 + variance.above && with >= 1.0 - variance.below, "{with} {variance:?}");
        }
    }

    #[test]
    fn analytic_what_a_jump_does_to_the_square_of_a_distance() {
        let square = |y: f64| (y - 1.0) * (y - 1.0);
        let unseen = UnsampledEvents { below: 0.5, above: 2.0 }.changed([0.0, 2.0], square);
        // From 2 to 4: from 1 to 9; from 2 to 1.5: from 1 to 0.25.
        assert_eq!(unseen, UnsampledEvents { below: 0.75, above: 8.0 });
    }
}

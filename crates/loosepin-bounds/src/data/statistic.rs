//! Statistics of a scalar response, and the functions whose means some of them are.

pub use loosepin_terms::{Estimation, Event, Statistic};

/// f where the statistic is the mean of f(Y).
pub(crate) fn function_averaged(statistic: Statistic) -> Option<Box<dyn Fn(f64) -> f64>> {
    match statistic.estimation()? {
        Estimation::Mean => Some(Box::new(|value| value)),
        Estimation::Counted(event) => Some(Box::new(move |value| if event.holds(value) { 1.0 } else { 0.0 })),
        Estimation::RootOfVariance | Estimation::Ordered(_) | Estimation::Sampled => None,
    }
}

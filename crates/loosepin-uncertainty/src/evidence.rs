//! Evidence: intervals with masses, and probability boxes as such.

use thiserror::Error;

use super::interval::Interval;

/// Masses that sum to 1 within this are taken for a sum of 1 that was rounded; they are then divided by their sum.
pub const MASS_TOLERANCE: f64 = 1e-6;

/// Elements that a box from least value, greatest value and mean is divided into.
const ELEMENTS_OF_A_MEAN: usize = 16;

/// An interval with its Dempster-Shafer mass; no distribution inside it is assumed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FocalElement {
    /// The interval.
    pub interval: Interval,
    /// Its mass, > 0.
    pub mass: f64,
}

/// A Dempster-Shafer structure on the line: focal elements whose masses sum to 1. They may overlap and leave gaps.
///
/// ```text
/// belief(A) = sum of m_e over e inside A,   plausibility(A) = sum of m_e over e that meet A
/// ```
///
/// G. Shafer, "A mathematical theory of evidence" (1976).
#[derive(Debug, Clone, PartialEq)]
pub struct Evidence {
    elements: Vec<FocalElement>,
    hull: Interval,
    is_scattering: bool,
}

/// Errors of intervals with masses.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum EvidenceError {
    #[error("evidence without an element; give at least one")]
    Empty,
    #[error("mass {mass} of element {element}; must be > 0 and at most 1")]
    Mass {
        /// Position of the element, counted from 1.
        element: usize,
        mass: f64,
    },
    #[error("the masses sum to {sum}; must be 1, within {MASS_TOLERANCE}")]
    Sum { sum: f64 },
    #[error(
        "quantile {second} at probability {second_probability} after {first} at {first_probability}; both must increase"
    )]
    NotIncreasing { first_probability: f64, first: f64, second_probability: f64, second: f64 },
    #[error("quantile at probability {probability}; must lie between 0 and 1, both excluded")]
    Probability { probability: f64 },
    #[error("{what} {value}; must lie between the ends {lower} and {upper} of the support")]
    OutsideSupport { what: &'static str, value: f64, lower: f64, upper: f64 },
}

impl Evidence {
    /// Evidence on a value that is fixed but unknown.
    ///
    /// # Errors
    ///
    /// [`EvidenceError`] where a mass is not in (0, 1] or the masses do not sum to 1 within [`MASS_TOLERANCE`].
    pub fn try_new(elements: Vec<FocalElement>) -> Result<Self, EvidenceError> {
        let first = elements.first().ok_or(EvidenceError::Empty)?.interval;
        for (index, element) in elements.iter().enumerate() {
            if !(element.mass > 0.0 && element.mass <= 1.0) {
                return Err(EvidenceError::Mass { element: index + 1, mass: element.mass });
            }
        }
        let sum: f64 = elements.iter().map(|element| element.mass).sum();
        // Three times 0.333333 is within: the sum itself is rounded.
        if (sum - 1.0).abs() > MASS_TOLERANCE + elements.len() as f64 * f64::EPSILON {
            return Err(EvidenceError::Sum { sum });
        }
        let elements: Vec<FocalElement> =
            elements.into_iter().map(|element| FocalElement { mass: element.mass / sum, ..element }).collect();
        let hull = elements.iter().fold(first, |hull, element| hull.hull(element.interval));
        Ok(Self { elements, hull, is_scattering: false })
    }

    /// The set of all distributions with these quantiles `(probability, value)` and this `support`: between neighbouring
    /// quantiles lies the mass between their probabilities. Exact: the bounds of the distribution function are the steps that
    /// all such distributions share, and each is attained (S. Ferson et al., "Constructing probability boxes and
    /// Dempster-Shafer structures", SAND2002-4015 (2003), section 3.4).
    ///
    /// # Errors
    ///
    /// [`EvidenceError`] where probabilities or values do not increase, or values leave the support.
    pub fn from_quantiles(quantiles: &[(f64, f64)], support: Interval) -> Result<Self, EvidenceError> {
        let (lower, upper) = (support.lower(), support.upper());
        for &(probability, value) in quantiles {
            if !(probability > 0.0 && probability < 1.0) {
                return Err(EvidenceError::Probability { probability });
            }
            if !(value >= lower && value <= upper) {
                return Err(EvidenceError::OutsideSupport { what: "quantile", value, lower, upper });
            }
        }
        for pair in quantiles.windows(2) {
            if !(pair[0].0 < pair[1].0 && pair[0].1 <= pair[1].1) {
                return Err(EvidenceError::NotIncreasing {
                    first_probability: pair[0].0,
                    first: pair[0].1,
                    second_probability: pair[1].0,
                    second: pair[1].1,
                });
            }
        }
        let starts = std::iter::once((0.0, lower)).chain(quantiles.iter().copied());
        let ends = quantiles.iter().copied().chain(std::iter::once((1.0, upper)));
        let elements = starts.zip(ends).filter_map(|((from, low), (to, high))| {
            Some(FocalElement { interval: Interval::try_new(low, high).ok()?, mass: to - from })
        });
        Ok(Self { is_scattering: true, ..Self::try_new(elements.collect())? })
    }

    /// A set that contains all distributions with this `mean` on this `support` [a, b]: their distribution functions lie
    /// between F_low = 0 up to m, then (x - m)/(x - a), and F_up = (b - m)/(b - x) up to m, then 1 (Markov's inequality; sharp
    /// at every x: S. Ferson et al. as above, section 3.2). The box is divided outwards into elements of mass 1/16, from the quantile
    /// of F_up at the lower end of each step to that of F_low at its upper end, so that nothing is lost; it is wider than the box
    /// by one step, and holds distributions with other means.
    ///
    /// # Errors
    ///
    /// [`EvidenceError::OutsideSupport`] where the mean is not inside the support.
    pub fn from_mean(mean: f64, support: Interval) -> Result<Self, EvidenceError> {
        let (lower, upper) = (support.lower(), support.upper());
        if !(mean > lower && mean < upper) {
            return Err(EvidenceError::OutsideSupport { what: "mean", value: mean, lower, upper });
        }
        let steps = ELEMENTS_OF_A_MEAN;
        let share = |step: usize| step as f64 / steps as f64;
        let elements = (0..steps).filter_map(|step| {
            let low = if step == 0 { lower } else { (upper - (upper - mean) / share(step)).max(lower) };
            let high =
                if step + 1 == steps { upper } else { (lower + (mean - lower) / (1.0 - share(step + 1))).min(upper) };
            Some(FocalElement { interval: Interval::try_new(low, high).ok()?, mass: 1.0 / steps as f64 })
        });
        Ok(Self { is_scattering: true, ..Self::try_new(elements.collect())? })
    }

    /// The elements, masses summing to 1.
    pub fn elements(&self) -> &[FocalElement] {
        &self.elements
    }

    /// From the least to the greatest end of all elements.
    pub fn hull(&self) -> Interval {
        self.hull
    }

    /// Whether the value differs from sample to sample within an element (a probability box), rather than being fixed.
    pub fn is_scattering(&self) -> bool {
        self.is_scattering
    }

    /// The value at `fraction` in \[0, 1\] when each element is taken by its mass and its values as uniform.
    pub fn at(&self, fraction: f64) -> f64 {
        let mut rest = fraction;
        for element in &self.elements {
            if rest < element.mass {
                return element.interval.at(rest / element.mass);
            }
            rest -= element.mass;
        }
        self.elements.last().map_or(f64::NAN, |element| element.interval.upper())
    }
}

#[cfg(test)]
mod tests {
    use super::{Evidence, FocalElement};
    use crate::Interval;

    fn interval(lower: f64, upper: f64) -> Interval {
        Interval::try_new(lower, upper).unwrap()
    }

    #[test]
    fn what_is_no_evidence_is_refused() {
        let refused = |masses: &[f64]| {
            let elements = masses.iter().map(|&mass| FocalElement { interval: interval(0.5, 0.75), mass }).collect();
            Evidence::try_new(elements).unwrap_err().to_string()
        };
        assert_eq!(refused(&[]), "evidence without an element; give at least one");
        assert_eq!(refused(&[0.3, 0.6]), "the masses sum to 0.8999999999999999; must be 1, within 0.000001");
        assert_eq!(refused(&[1.25, -0.25]), "mass 1.25 of element 1; must be > 0 and at most 1");
    }

    #[test]
    fn analytic_quantiles_become_the_intervals_between_them() {
        let evidence = Evidence::from_quantiles(&[(0.05, 2.5), (0.5, 3.5), (0.95, 6.0)], interval(1.5, 9.0)).unwrap();
        let found: Vec<(f64, f64)> =
            evidence.elements().iter().map(|e| (e.interval.lower(), e.interval.upper())).collect();
        assert_eq!(found, [(1.5, 2.5), (2.5, 3.5), (3.5, 6.0), (6.0, 9.0)]);
        const TOLERANCE: f64 = 1e-15;
        for (element, mass) in evidence.elements().iter().zip([0.05, 0.45, 0.45, 0.05]) {
            assert!((element.mass - mass).abs() < TOLERANCE);
        }
        let refused =
            |quantiles: &[(f64, f64)]| Evidence::from_quantiles(quantiles, interval(1.5, 9.0)).unwrap_err().to_string();
        assert_eq!(
            refused(&[(0.5, 4.5), (0.75, 3.5)]),
            "quantile 3.5 at probability 0.75 after 4.5 at 0.5; both must increase"
        );
        assert_eq!(refused(&[(0.5, 9.5)]), "quantile 9.5; must lie between the ends 1.5 and 9 of the support");
    }

    #[test]
    fn analytic_every_distribution_with_the_mean_lies_in_its_box() {
        // Two values a' and b' with the mean 4: the extreme distributions of Markov's inequality.
        let (support, mean) = (interval(1.5, 9.0), 4.0);
        let evidence = Evidence::from_mean(mean, support).unwrap();
        let below = |y: f64, is_sure: bool| -> f64 {
            let end = |e: &FocalElement| if is_sure { e.interval.upper() } else { e.interval.lower() };
            evidence.elements().iter().filter(|e| end(e) <= y).map(|e| e.mass).sum()
        };
        const ROUND_OFF: f64 = 1e-12;
        for (low, high) in [(1.5, 9.0), (1.5, 5.0), (3.0, 9.0), (2.5, 4.5), (3.9, 4.1)] {
            let share = (high - mean) / (high - low);
            for step in 0..=100 {
                let y = 1.5 + 0.075 * f64::from(step);
                let exact = if y < low {
                    0.0
                } else if y < high {
                    share
                } else {
                    1.0
                };
                assert!(
                    below(y, true) <= exact + ROUND_OFF && exact <= below(y, false) + ROUND_OFF,
                    "{low} {high} {y}"
                );
            }
        }
        // Not wider than the sharp box by more than a step.
        for step in 0..50 {
            let y = 4.05 + 0.098 * f64::from(step);
            let sharp = (y - mean) / (y - 1.5);
            assert!(below(y, true) >= sharp - 1.0 / 16.0 - ROUND_OFF, "{y}");
        }
    }
}

//! Unknown (epistemic) inputs: a number between two ends, or one of a few, without known probabilities.
//!
//! An angle that may be any has no ends: after a whole turn it begins again.

use thiserror::Error;

use super::evidence::Evidence;
use super::fuzzy::FuzzyNumber;
use super::interval::Interval;
use crate::variables::second_order::SecondOrder;

/// Two or more different numbers, in the order in which they were given.
///
/// What is no number (a law of contact) is numbered by whoever asks.
#[derive(Debug, Clone, PartialEq)]
pub struct Members {
    values: Vec<f64>,
}

/// Errors of a list of possible values.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum MembersError {
    #[error("a list of {count}; must hold at least 2 numbers")]
    TooFew { count: usize },
    #[error("{value} in a list; every number must be finite")]
    NotFinite { value: f64 },
    #[error("{value} stands in a list twice")]
    Twice { value: f64 },
}

impl Members {
    /// The list of these values.
    ///
    /// # Errors
    ///
    /// [`MembersError`] where there are fewer than two, one is not finite, or two are equal.
    pub fn try_new(values: Vec<f64>) -> Result<Self, MembersError> {
        if values.len() < 2 {
            return Err(MembersError::TooFew { count: values.len() });
        }
        for (index, &value) in values.iter().enumerate() {
            if !value.is_finite() {
                return Err(MembersError::NotFinite { value });
            }
            if values[..index].contains(&value) {
                return Err(MembersError::Twice { value });
            }
        }
        Ok(Self { values })
    }

    /// The numbers, in the order in which they were given.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Which member `value` is; `None` if it is none.
    pub fn index_of(&self, value: f64) -> Option<usize> {
        self.values.iter().position(|&member| member == value)
    }

    /// The member on which `fraction` in \[0, 1\] falls when each takes the same share.
    pub fn at(&self, fraction: f64) -> f64 {
        let place = (fraction * self.values.len() as f64) as usize;
        self.values[place.min(self.values.len() - 1)]
    }
}

/// Structure of an epistemic input.
#[derive(Debug, Clone, PartialEq)]
pub enum EpistemicVariable {
    /// A number between two ends.
    Interval(Interval),
    /// An angle, or the phase of a periodic process: the interval is one period, its two ends are the same.
    Periodic(Interval),
    /// One of a few numbers.
    OneOf(Members),
    /// A number in one of a few intervals, each with a mass.
    Evidence(Evidence),
    /// A parameter with a distribution over its values.
    SecondOrder(SecondOrder),
    /// A number in nested intervals, each with a degree of possibility.
    Fuzzy(FuzzyNumber),
}

impl EpistemicVariable {
    /// The value at `fraction` in \[0, 1\] where the structure is taken as probability: along an interval, or the member whose equal share
    /// it falls on; elements of evidence by their masses; cuts of a fuzzy number by their degrees; a parameter by its distribution. A
    /// uniform fraction therefore takes every interval as uniform and every member as equally probable.
    pub fn at(&self, fraction: f64) -> f64 {
        match self {
            Self::Interval(interval) | Self::Periodic(interval) => interval.at(fraction),
            Self::OneOf(members) => members.at(fraction),
            Self::Evidence(evidence) => evidence.at(fraction),
            Self::SecondOrder(parameter) => parameter.at(fraction),
            Self::Fuzzy(fuzzy) => fuzzy.at(fraction),
        }
    }

    /// The interval that holds all possible values; `None` if it is one of a list.
    pub fn range(&self) -> Option<Interval> {
        match self {
            Self::Interval(interval) | Self::Periodic(interval) => Some(*interval),
            Self::OneOf(_) => None,
            Self::Evidence(evidence) => Some(evidence.hull()),
            Self::SecondOrder(parameter) => Some(parameter.range()),
            Self::Fuzzy(fuzzy) => Some(fuzzy.support()),
        }
    }

    /// From how many the true one is chosen: the members of a list, 1 for an interval.
    pub fn choices(&self) -> usize {
        match self {
            Self::OneOf(members) => members.values.len(),
            _ => 1,
        }
    }

    /// The least and the greatest value.
    pub fn ends(&self) -> [f64; 2] {
        match (self, self.range()) {
            (Self::OneOf(members), _) => members
                .values
                .iter()
                .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &value| [low.min(value), high.max(value)]),
            (_, range) => range.map_or([f64::NAN; 2], |range| [range.lower(), range.upper()]),
        }
    }

    /// A representative value: the middle of an interval, the first member of a list.
    pub fn middle(&self) -> f64 {
        match self {
            Self::OneOf(members) => members.values[0],
            _ => self.range().map_or(f64::NAN, |range| range.at(0.5)),
        }
    }

    /// The same, held at [`EpistemicVariable::middle`].
    #[must_use]
    pub fn at_middle(&self) -> Self {
        let middle = self.middle();
        Interval::try_new(middle, middle).map_or_else(|_| self.clone(), Self::Interval)
    }

    /// Values that show its range: the ends of an interval, every member of a list.
    pub fn representative_values(&self) -> Vec<f64> {
        match self {
            Self::OneOf(members) => members.values.clone(),
            _ => self.ends().to_vec(),
        }
    }

    /// Whether its ends are the same.
    pub fn is_periodic(&self) -> bool {
        matches!(self, Self::Periodic(_))
    }

    /// Whether it is a parameter that has a distribution of its own.
    pub fn is_second_order(&self) -> bool {
        matches!(self, Self::SecondOrder(_))
    }

    /// Whether it is made of several intervals, with masses or degrees.
    pub fn is_structured(&self) -> bool {
        matches!(self, Self::Evidence(_) | Self::Fuzzy(_))
    }
}

macro_rules! from_known {
    ($($variant:ident($known:ident)),+) => {
        $(impl From<$known> for EpistemicVariable {
            fn from(known: $known) -> Self {
                Self::$variant(known)
            }
        })+
    };
}

from_known!(Evidence(Evidence), SecondOrder(SecondOrder), Fuzzy(FuzzyNumber), Interval(Interval), OneOf(Members));

#[cfg(test)]
mod tests {
    use super::{EpistemicVariable, Members};

    #[test]
    fn what_is_no_list_is_refused() {
        let refused = |values: &[f64]| Members::try_new(values.to_vec()).unwrap_err().to_string();
        assert_eq!(refused(&[0.5]), "a list of 1; must hold at least 2 numbers");
        assert_eq!(refused(&[0.5, f64::NAN]), "NaN in a list; every number must be finite");
        assert_eq!(refused(&[0.5, 0.25, 0.5]), "0.5 stands in a list twice");
    }

    #[test]
    fn identity_every_member_takes_the_same_share() {
        let variable = EpistemicVariable::from(Members::try_new(vec![7.0, -2.5, 3.0, 4.5]).unwrap());
        let mut counts = [0; 4];
        for step in 0..400 {
            let value = variable.at((f64::from(step) + 0.5) / 400.0);
            counts[[7.0, -2.5, 3.0, 4.5].iter().position(|&member| member == value).unwrap()] += 1;
        }
        assert_eq!(counts, [100; 4]);
        assert_eq!((variable.at(0.0), variable.at(1.0)), (7.0, 4.5));
        assert_eq!((variable.ends(), variable.middle()), ([-2.5, 7.0], 7.0));
    }
}

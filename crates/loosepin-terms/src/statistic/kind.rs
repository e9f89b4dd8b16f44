//! Interface of a statistic. Whoever works with statistics asks for these properties, never for a statistic by its name.

use std::any::Any;

use super::event::Event;

/// Names of a statistic.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Description {
    /// Word in study files, in results and in Python.
    pub word: &'static str,
    /// In a sentence: "a mean".
    pub with_article: &'static str,
    /// In a table, with {} where its number stands: "{} quantile".
    pub words: &'static str,
    /// Its names elsewhere, with the spelling of study files.
    pub synonyms: &'static [(&'static str, &'static str)],
    /// Its form.
    pub form: Form,
    /// Its number, where it has one.
    pub number: Option<Number>,
}

/// The random variable of a statistic.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// One number for each column.
    Number,
    /// All probabilities of a column at once.
    DistributionFunction,
    /// Two ends at each point of a whole curve; a single column has none.
    Curve,
}

/// The number that belongs to a statistic.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Number {
    /// Name in results.
    pub name: &'static str,
    /// Which numbers are allowed.
    pub kind: NumberKind,
    /// An example, as a study file has it.
    pub example: &'static str,
    /// Meaning of the key of a study file.
    pub meaning: &'static str,
}

/// Which numbers a statistic can have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NumberKind {
    /// A pure number between 0 and 1, both excluded.
    Share,
    /// A value in the unit of the output.
    Limit,
    /// A value in the unit of the output, 0 or more.
    LimitOfMagnitude,
}

impl NumberKind {
    /// Whether it can be `number`.
    pub fn allows(self, number: f64) -> bool {
        match self {
            Self::Share => number > 0.0 && number < 1.0,
            Self::Limit => number.is_finite(),
            Self::LimitOfMagnitude => number.is_finite() && number >= 0.0,
        }
    }
}

/// How a statistic of one number follows from runs: which of the estimators that know more than the values is right for it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Estimation {
    /// The mean of the values.
    Mean,
    /// The root of their variance.
    RootOfVariance,
    /// The share of the values with a property.
    Counted(Event),
    /// The value at this probability in their order.
    Ordered(f64),
    /// [`StatisticKind::of_sorted`] of all values, with the error that replicates and changed samples show. Nothing more is known of it.
    Sampled,
}

/// Relation of S(-Y) to S(Y).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Mirrored {
    /// No used relation.
    Unrelated,
    /// S(-Y) = -S(Y).
    Opposite,
    /// S(-Y) = -T(Y), T the same statistic with this number.
    OppositeWith(f64),
}

/// Effect of errors e of the values on a statistic.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ErrorEffect {
    /// For |e| <= h it lies between its values for Y - h and Y + h, that for Y itself among them.
    Shifts,
    /// By √E(e²) at most.
    RootMeanSquare,
    /// Unknown: the statistic may take any value.
    Unknown,
}

/// Properties of a statistic S of a random variable Y. Where nothing is stated the answer is the careful one: bounds are then wider, never
/// wrong.
pub trait StatisticKind: Any {
    /// S of a sample, whose values are in increasing order and finite, each with the same weight. Not a number of none, and for a statistic
    /// that is more than one number.
    fn of_sorted(&self, sorted: &[f64]) -> f64;

    /// Which estimator is right for it.
    fn estimation(&self) -> Estimation {
        Estimation::Sampled
    }

    /// The least and the greatest S where Y lies between two values, which may be infinite.
    fn range_within(&self, values: [f64; 2]) -> [f64; 2] {
        let _ = values;
        [f64::NEG_INFINITY, f64::INFINITY]
    }

    /// Whether S exceeds `other` for no random variable.
    fn never_exceeds(&self, other: &dyn StatisticKind) -> bool {
        let _ = other;
        false
    }

    /// Whether S falls short of `other` for no random variable: what `other` cannot state, since it was there before.
    fn never_falls_short_of(&self, other: &dyn StatisticKind) -> bool {
        let _ = other;
        false
    }

    /// Whether S does not fall where Y grows, whatever the dependence: X <= Y for every mechanism gives S(X) <= S(Y).
    fn grows_with_variable(&self) -> bool {
        false
    }

    /// What S(-Y) is.
    fn mirrored(&self) -> Mirrored {
        Mirrored::Unrelated
    }

    /// What errors of the values do to it.
    fn effect_of_errors(&self) -> ErrorEffect {
        ErrorEffect::Unknown
    }
}

/// `other` where it is of kind `K`: how the order of two statistics is stated.
pub(super) fn as_kind<K: StatisticKind>(other: &dyn StatisticKind) -> Option<&K> {
    let other: &dyn Any = other;
    other.downcast_ref()
}

//! Statistics of a scalar response: one a file, a struct with its number, its `DESCRIPTION` and [`StatisticKind`], and one line in the
//! list below. Nobody outside of this folder asks which statistic it is: they ask what it is like.

mod cdf;
#[cfg(test)]
mod claims;
mod event;
mod json;
mod kind;
mod mean;
mod mean_absolute_deviation;
mod probability;
mod quantile;
mod simultaneous_band;
mod standard_deviation;
#[cfg(test)]
mod tests;

pub use event::Event;
pub use kind::{Description, ErrorEffect, Estimation, Form, Mirrored, Number, NumberKind, StatisticKind};
pub use quantile::between_order_statistics;

/// The enum of all statistics, their lists, and what each hands on to its own file.
macro_rules! statistics {
    (
        plain { $($(#[$plain_doc:meta])* $plain:ident in $plain_file:ident,)+ }
        with_number { $($(#[$doc:meta])* $variant:ident in $file:ident,)+ }
    ) => {
        /// Statistic of a response Y for fixed epistemic inputs.
        ///
        /// In files `{ "kind": word, name of its number: number }`, for example `{ "kind": "quantile", "probability": 0.975 }`.
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub enum Statistic {
            $($(#[$plain_doc])* $plain,)+
            $($(#[$doc])* $variant(f64),)+
        }

        impl Statistic {
            /// Every statistic without a parameter.
            pub const PLAIN: [Self; [$(stringify!($plain)),+].len()] = [$(Self::$plain),+];

            /// Every statistic with a parameter, each with this one.
            pub const fn with_parameter(number: f64) -> [Self; [$(stringify!($variant)),+].len()] {
                [$(Self::$variant(number)),+]
            }

            /// Its names.
            pub const fn description(self) -> &'static Description {
                match self {
                    $(Self::$plain => &$plain_file::$plain::DESCRIPTION,)+
                    $(Self::$variant(_) => &$file::$variant::DESCRIPTION,)+
                }
            }

            /// Parameter where there is one: a probability, a share, or a limit in SI.
            pub const fn parameter(self) -> Option<f64> {
                match self {
                    $(Self::$plain => None,)+
                    $(Self::$variant(number) => Some(number),)+
                }
            }

            fn with_kind<R>(self, of: impl FnOnce(&dyn StatisticKind) -> R) -> R {
                match self {
                    $(Self::$plain => of(&$plain_file::$plain),)+
                    $(Self::$variant(number) => of(&$file::$variant(number)),)+
                }
            }
        }
    };
}

statistics! {
    plain {
        /// E(Y).
        Mean in mean,
        /// Standard deviation of Y.
        StandardDeviation in standard_deviation,
        /// E|Y - E Y|.
        MeanAbsoluteDeviation in mean_absolute_deviation,
        /// The whole distribution function.
        Cdf in cdf,
    }
    with_number {
        /// The value that Y stays below with this probability, in (0, 1).
        Quantile in quantile,
        /// P(Y > limit).
        ProbabilityAbove in probability,
        /// P(Y < limit).
        ProbabilityBelow in probability,
        /// P(|Y| > limit), limit >= 0.
        ProbabilityBeyond in probability,
        /// A point of the band in which this share of mechanisms, in (0, 1), stays for the whole cycle. It belongs to a curve: bounds of a
        /// single column have none.
        SimultaneousBand in simultaneous_band,
    }
}

/// Statistics that plans and charts use for every question.
impl Statistic {
    /// The quantile at `probability`.
    pub const fn quantile_at(probability: f64) -> Self {
        Self::Quantile(probability)
    }

    /// Statistics in the chart of a curve at each of its points: its middle, and both ends of a band between two quantiles.
    pub const fn of_curve_point(band: [f64; 2]) -> [Self; 3] {
        [Self::Mean, Self::Quantile(band[0]), Self::Quantile(band[1])]
    }

    /// The band in which `share` of the mechanisms stays for a whole curve.
    pub const fn band_of_curve(share: f64) -> Self {
        Self::SimultaneousBand(share)
    }

    /// Statistic in the chart of a single number: its distribution function.
    pub const fn of_single_number() -> Self {
        Self::Cdf
    }

    /// Statistic of the squared error of every value that bounds a statistic with [`ErrorEffect::RootMeanSquare`].
    pub const fn of_squared_error() -> Self {
        Self::Mean
    }
}

impl Statistic {
    /// Statistic of a word and its parameter; `None` if they do not go together.
    pub fn from_word(word: &str, parameter: Option<f64>) -> Option<Self> {
        let is_named = |statistic: &Self| statistic.word() == word;
        match parameter {
            None => Self::PLAIN.into_iter().find(is_named),
            Some(number) => Self::with_parameter(number).into_iter().find(is_named),
        }
    }

    /// Word in files and in Python.
    pub const fn word(self) -> &'static str {
        self.description().word
    }

    /// Whether it is one number for each column.
    pub const fn is_single(self) -> bool {
        matches!(self.description().form, Form::Number)
    }

    /// Whether it is all probabilities of a column at once.
    pub const fn is_distribution_function(self) -> bool {
        matches!(self.description().form, Form::DistributionFunction)
    }

    /// Whether it belongs to a whole curve, so that a single column has none.
    pub const fn is_of_curve(self) -> bool {
        matches!(self.description().form, Form::Curve)
    }

    /// Whether its number, where it has one, is allowed.
    pub fn has_allowed_number(self) -> bool {
        match (self.description().number, self.parameter()) {
            (Some(number), Some(value)) => number.kind.allows(value),
            _ => true,
        }
    }

    /// Which estimator is right for it; `None` if it is more than one number.
    pub fn estimation(self) -> Option<Estimation> {
        self.is_single().then(|| self.with_kind(StatisticKind::estimation))
    }

    /// The event whose probability it is.
    pub fn event(self) -> Option<Event> {
        match self.estimation() {
            Some(Estimation::Counted(event)) => Some(event),
            _ => None,
        }
    }

    /// Whether it is the mean.
    pub fn is_mean(self) -> bool {
        matches!(self.estimation(), Some(Estimation::Mean))
    }

    /// Whether it is the root of the variance.
    pub fn is_root_of_variance(self) -> bool {
        matches!(self.estimation(), Some(Estimation::RootOfVariance))
    }

    /// The probability at which it is a quantile.
    pub fn probability_of_quantile(self) -> Option<f64> {
        match self.estimation() {
            Some(Estimation::Ordered(probability)) => Some(probability),
            _ => None,
        }
    }

    /// Whether it is a probability, a pure number from 0 to 1; all others have the unit of the output.
    pub fn is_probability(self) -> bool {
        self.event().is_some()
    }

    /// Whether it asks of each value only on which side of others or of a limit it lies. Runs that failed, or that say no more than "at least
    /// this", have such a side or either; of all other statistics they leave nothing known.
    pub fn is_by_shares(self) -> bool {
        matches!(self.estimation(), None | Some(Estimation::Counted(_) | Estimation::Ordered(_)))
    }

    /// Whether it never falls where no value falls, or never rises: a mean, and what is counted on one side of others or of a limit. Such a
    /// statistic is largest and smallest where all values are.
    pub fn is_monotone(self) -> bool {
        let is_of_both_sides = matches!(self.event(), Some(Event::Beyond(_)));
        self == Self::Mean || self.is_by_shares() && !is_of_both_sides
    }

    /// The statistic of a sample whose values are finite and in increasing order; NaN if there are none, and if it is more than one number.
    pub fn of_sorted(self, sorted: &[f64]) -> f64 {
        self.with_kind(|kind| kind.of_sorted(sorted))
    }

    /// The least and the greatest value that it can have.
    pub fn range(self) -> [f64; 2] {
        self.range_within([f64::NEG_INFINITY, f64::INFINITY])
    }

    /// The same where the random variable lies between these two values.
    pub fn range_within(self, values: [f64; 2]) -> [f64; 2] {
        self.with_kind(|kind| kind.range_within(values))
    }

    /// Whether it exceeds `other` for no random variable.
    pub fn never_exceeds(self, other: Self) -> bool {
        self.with_kind(|own| other.with_kind(|other| own.never_exceeds(other) || other.never_falls_short_of(own)))
    }

    /// Whether it does not fall where the random variable grows, whatever the dependence: X <= Y for every mechanism gives S(X) <= S(Y).
    pub fn grows_with_variable(self) -> bool {
        self.with_kind(StatisticKind::grows_with_variable)
    }

    /// The T with S(-Y) = -T(Y) for every Y, where there is one.
    pub fn mirrored(self) -> Option<Self> {
        match self.with_kind(StatisticKind::mirrored) {
            Mirrored::Unrelated => None,
            Mirrored::Opposite => Some(self),
            Mirrored::OppositeWith(number) => Self::from_word(self.word(), Some(number)),
        }
    }

    /// Effect of errors of the values.
    pub fn effect_of_errors(self) -> ErrorEffect {
        self.with_kind(StatisticKind::effect_of_errors)
    }
}

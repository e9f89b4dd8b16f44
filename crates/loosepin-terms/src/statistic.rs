//! Statistics of a scalar response.

use serde::de::Error;
use serde::ser::SerializeMap;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// Statistic of a response Y for fixed epistemic inputs.
///
/// In files `{ "kind": word, parameter: number }`, for example `{ "kind": "quantile", "probability": 0.975 }`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Statistic {
    /// E(Y).
    Mean,
    /// Standard deviation of Y.
    StandardDeviation,
    /// The whole distribution function.
    Cdf,
    /// The value that Y stays below with this probability, in (0, 1).
    Quantile(f64),
    /// A point of the band in which this share of mechanisms, in (0, 1), stays for the whole cycle. It belongs to a curve: bounds of a
    /// single column have none.
    SimultaneousBand(f64),
    /// P(Y > limit).
    ProbabilityAbove(f64),
    /// P(Y < limit).
    ProbabilityBelow(f64),
    /// P(|Y| > limit), limit >= 0.
    ProbabilityBeyond(f64),
}

/// Names of the parameters in files.
const PROBABILITY: &str = "probability";
const SHARE: &str = "share";
const LIMIT: &str = "limit_si";

impl Statistic {
    /// Every statistic without a parameter.
    pub const PLAIN: [Self; 3] = [Self::Mean, Self::StandardDeviation, Self::Cdf];

    /// Every statistic with a parameter, each with this one.
    pub const fn with_parameter(number: f64) -> [Self; 5] {
        [
            Self::Quantile(number),
            Self::ProbabilityAbove(number),
            Self::ProbabilityBelow(number),
            Self::ProbabilityBeyond(number),
            Self::SimultaneousBand(number),
        ]
    }

    /// Whether it is one number for each column.
    pub const fn is_single(self) -> bool {
        !matches!(self, Self::Cdf | Self::SimultaneousBand(_))
    }

    /// The least and the greatest value that it can have.
    pub fn range(self) -> [f64; 2] {
        match self {
            Self::StandardDeviation => [0.0, f64::INFINITY],
            _ if self.is_probability() => [0.0, 1.0],
            _ => [f64::NEG_INFINITY, f64::INFINITY],
        }
    }

    /// Whether it exceeds `other` for no random variable.
    ///
    /// ```text
    /// p <= q: Q_p <= Q_q                          a distribution function does not fall
    /// a >= b: P(Y > a) <= P(Y > b)                the event on the left implies that on the right; so for the next three
    /// a <= b: P(Y < a) <= P(Y < b)
    /// a >= b: P(|Y| > a) <= P(|Y| > b)
    /// a >= b: P(Y > a) <= P(|Y| > b),   -a >= b: P(Y < a) <= P(|Y| > b)
    /// ```
    ///
    /// Nothing of this kind holds between a mean and a quantile: the mean of a rare large number lies beyond nearly all quantiles.
    pub fn never_exceeds(self, other: Self) -> bool {
        match (self, other) {
            (Self::Quantile(p), Self::Quantile(q)) => p <= q,
            (Self::ProbabilityAbove(a), Self::ProbabilityAbove(b))
            | (Self::ProbabilityBeyond(a), Self::ProbabilityBeyond(b))
            | (Self::ProbabilityAbove(a), Self::ProbabilityBeyond(b)) => a >= b,
            (Self::ProbabilityBelow(a), Self::ProbabilityBelow(b)) => a <= b,
            (Self::ProbabilityBelow(a), Self::ProbabilityBeyond(b)) => -a >= b,
            _ => false,
        }
    }

    /// Whether it does not fall where the random variable grows, whatever the dependence: X <= Y for every mechanism gives S(X) <= S(Y).
    pub fn grows_with_variable(self) -> bool {
        matches!(self, Self::Mean | Self::Quantile(_) | Self::ProbabilityAbove(_))
    }

    /// Whether it is a probability, a pure number from 0 to 1.
    pub fn is_probability(self) -> bool {
        matches!(self, Self::ProbabilityAbove(_) | Self::ProbabilityBelow(_) | Self::ProbabilityBeyond(_))
    }

    /// Word in files and in Python.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Mean => "mean",
            Self::StandardDeviation => "standard_deviation",
            Self::Cdf => "cdf",
            Self::Quantile(_) => "quantile",
            Self::SimultaneousBand(_) => "simultaneous_band",
            Self::ProbabilityAbove(_) => "probability_above",
            Self::ProbabilityBelow(_) => "probability_below",
            Self::ProbabilityBeyond(_) => "probability_beyond",
        }
    }

    /// Parameter where there is one: a probability, a share, or a limit in SI.
    pub fn parameter(self) -> Option<f64> {
        self.named_parameter().map(|(_, value)| value)
    }

    /// Statistic of a word and its parameter; nothing where they do not go together.
    pub fn from_word(word: &str, parameter: Option<f64>) -> Option<Self> {
        let is_named = |statistic: &Self| statistic.word() == word;
        match parameter {
            None => Self::PLAIN.into_iter().find(is_named),
            Some(number) => Self::with_parameter(number).into_iter().find(is_named),
        }
    }

    fn named_parameter(self) -> Option<(&'static str, f64)> {
        match self {
            Self::Mean | Self::StandardDeviation | Self::Cdf => None,
            Self::Quantile(probability) => Some((PROBABILITY, probability)),
            Self::SimultaneousBand(share) => Some((SHARE, share)),
            Self::ProbabilityAbove(limit) | Self::ProbabilityBelow(limit) | Self::ProbabilityBeyond(limit) => {
                Some((LIMIT, limit))
            }
        }
    }
}

impl Serialize for Statistic {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let parameter = self.named_parameter();
        let mut map = serializer.serialize_map(Some(1 + usize::from(parameter.is_some())))?;
        map.serialize_entry("kind", self.word())?;
        if let Some((name, value)) = parameter {
            map.serialize_entry(name, &value)?;
        }
        map.end()
    }
}

/// What stands in a file.
#[derive(Deserialize)]
struct Written {
    kind: String,
    probability: Option<f64>,
    share: Option<f64>,
    limit_si: Option<f64>,
}

impl<'de> Deserialize<'de> for Statistic {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Written { kind, probability, share, limit_si } = Written::deserialize(deserializer)?;
        let named = [(PROBABILITY, probability), (SHARE, share), (LIMIT, limit_si)];
        let parameter = named.into_iter().find_map(|(name, value)| Some((name, value?)));
        let statistic = Self::from_word(&kind, parameter.map(|(_, value)| value));
        statistic.filter(|statistic| statistic.named_parameter() == parameter).ok_or_else(|| {
            D::Error::custom(format!("statistic '{kind}' has another parameter, or there is none of this name"))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Statistic;

    const ALL: [(Statistic, &str); 8] = [
        (Statistic::Mean, r#"{"kind":"mean"}"#),
        (Statistic::StandardDeviation, r#"{"kind":"standard_deviation"}"#),
        (Statistic::Cdf, r#"{"kind":"cdf"}"#),
        (Statistic::Quantile(0.975), r#"{"kind":"quantile","probability":0.975}"#),
        (Statistic::SimultaneousBand(0.9), r#"{"kind":"simultaneous_band","share":0.9}"#),
        (Statistic::ProbabilityAbove(-0.25), r#"{"kind":"probability_above","limit_si":-0.25}"#),
        (Statistic::ProbabilityBelow(0.5), r#"{"kind":"probability_below","limit_si":0.5}"#),
        (Statistic::ProbabilityBeyond(0.125), r#"{"kind":"probability_beyond","limit_si":0.125}"#),
    ];

    #[test]
    fn identity_every_statistic_is_read_back_from_its_text() {
        for (statistic, text) in ALL {
            assert_eq!(serde_json::to_string(&statistic).unwrap(), text);
            assert_eq!(serde_json::from_str::<Statistic>(text).unwrap(), statistic);
            assert_eq!(Statistic::from_word(statistic.word(), statistic.parameter()), Some(statistic));
        }
    }

    #[test]
    fn analytic_statistics_of_a_sample_are_in_the_order_that_is_stated() {
        use Statistic::{Mean, ProbabilityAbove, ProbabilityBelow, ProbabilityBeyond, Quantile};
        // Most values are small and one is large: the mean lies beyond the upper quantile.
        let sample = [-1.5, -0.25, 0.125, 0.5, 0.75, 0.875, 1.25, 1.5, 1.75, 400.0];
        let share = |holds: &dyn Fn(f64) -> bool| sample.iter().filter(|&&y| holds(y)).count() as f64 / 10.0;
        let value = |statistic| match statistic {
            Mean => sample.iter().sum::<f64>() / 10.0,
            Quantile(p) => sample[((p * 10.0) as usize).min(9)],
            ProbabilityAbove(limit) => share(&|y| y > limit),
            ProbabilityBelow(limit) => share(&|y| y < limit),
            ProbabilityBeyond(limit) => share(&|y| y.abs() > limit),
            Statistic::StandardDeviation | Statistic::Cdf | Statistic::SimultaneousBand(_) => f64::NAN,
        };
        let limits = [-2.0, -0.5, 0.25, 1.0, 1.625, 500.0];
        let mut all = vec![Mean, Quantile(0.05), Quantile(0.5), Quantile(0.85)];
        all.extend(limits.into_iter().flat_map(|limit| [ProbabilityAbove(limit), ProbabilityBelow(limit)]));
        all.extend(limits.into_iter().filter(|limit| *limit >= 0.0).map(ProbabilityBeyond));
        let mut stated = 0;
        for (a, b) in all.iter().flat_map(|&a| all.iter().map(move |&b| (a, b))) {
            if a.never_exceeds(b) {
                stated += 1;
                assert!(value(a) <= value(b), "{a:?} {b:?}");
            }
        }
        assert!(stated > 60, "{stated}");
        assert!(value(Mean) > value(Quantile(0.85)) && !Mean.never_exceeds(Quantile(0.85)));
    }

    #[test]
    fn a_parameter_of_another_statistic_is_refused() {
        let read = |text: &str| serde_json::from_str::<Statistic>(text).map_err(|error| error.to_string());
        assert!(read(r#"{"kind":"mean","share":0.9}"#).is_err());
        assert!(read(r#"{"kind":"quantile"}"#).is_err());
        assert!(read(r#"{"kind":"quantile","share":0.9}"#).is_err());
        assert!(read(r#"{"kind":"median"}"#).unwrap_err().contains("'median'"));
        assert_eq!(Statistic::from_word("mean", Some(0.5)), None);
    }
}

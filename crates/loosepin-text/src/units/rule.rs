//! The range that a value must lie in.

/// The range that a value must lie in, whether written in a file or drawn in a study.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rule {
    /// Any finite number.
    Finite,
    /// > 0.
    Positive,
    /// >= 0.
    NonNegative,
    /// (0, 1].
    Restitution,
    /// [0, 0.5].
    PoissonRatio,
    /// >= 1.
    AtLeastOne,
    /// [0, 1e6], for turns run before recording.
    Turns,
    /// (0, 1e6], for turns recorded.
    SomeTurns,
    /// (0, 1).
    Probability,
    /// (0, 1].
    RequiredProbability,
}

/// Turns in one run, at most: far more than anybody waits for, and few enough that counters hold them.
const MOST_TURNS: f64 = 1e6;

impl Rule {
    /// Whether a value keeps the rule. No value that is not finite keeps any.
    pub fn allows(self, value_si: f64) -> bool {
        value_si.is_finite()
            && match self {
                Rule::Finite => true,
                Rule::Positive => value_si > 0.0,
                Rule::NonNegative => value_si >= 0.0,
                Rule::Restitution => value_si > 0.0 && value_si <= 1.0,
                Rule::PoissonRatio => (0.0..=0.5).contains(&value_si),
                Rule::AtLeastOne => value_si >= 1.0,
                Rule::Turns => (0.0..=MOST_TURNS).contains(&value_si),
                Rule::SomeTurns => value_si > 0.0 && value_si <= MOST_TURNS,
                Rule::Probability => value_si > 0.0 && value_si < 1.0,
                Rule::RequiredProbability => value_si > 0.0 && value_si <= 1.0,
            }
    }

    /// The rule in words, to follow "must be".
    pub fn words(self) -> &'static str {
        match self {
            Rule::Finite => "finite",
            Rule::Positive => "> 0",
            Rule::NonNegative => ">= 0",
            Rule::Restitution => "in (0, 1]",
            Rule::PoissonRatio => "in [0, 0.5]",
            Rule::AtLeastOne => ">= 1",
            Rule::Turns => "in [0, 1e6]",
            Rule::SomeTurns => "in (0, 1e6]",
            Rule::Probability => "in (0, 1)",
            Rule::RequiredProbability => "in (0, 1]",
        }
    }
}

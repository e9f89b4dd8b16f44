//! What can be wrong with a study beyond its single entries.

use thiserror::Error;

use loosepin_mechanics::model::{LawError, PathError, QuantityError};
use loosepin_text::diagnostics::{Code, Problem};
use loosepin_text::document::{describe_path, listed};
use loosepin_text::units::{Dimension, format_value};
use loosepin_uncertainty::DistributionError;

/// What can be wrong with a study file. `entry` is a path in words.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum StudyProblem {
    /// A path that names no quantity that can be uncertain.
    #[error(transparent)]
    Path(#[from] PathError),
    /// A path written without quotes, which TOML takes apart.
    #[error("'{path}' is not in quotes; TOML takes it for tables within tables")]
    UnquotedPath {
        /// The path, as far as it can be told.
        path: String,
    },
    /// A statistic that is written in another form.
    #[error("{entry}: '{word}' is written {form}")]
    StatisticForm {
        /// The entry.
        entry: String,
        /// What is written.
        word: String,
        /// How it is written.
        form: &'static str,
    },
    /// A probability as text.
    #[error("{entry} is \"{found}\"; expected a number between 0 and 1")]
    Percent {
        /// The entry.
        entry: String,
        /// The text.
        found: String,
    },
    /// The part of the deviation that comes from play, where there is none.
    #[error("{entry} is \"clearance\"; no joint of the model has play, so that this part of the deviation is zero")]
    NoPlay {
        /// The entry.
        entry: String,
    },
    /// A share of all parts, where quantities scatter.
    #[error("{entry} is 1; no number of samples shows that none lies beyond the limit, so that this stays undecided")]
    CertaintyOfSamples {
        /// The entry.
        entry: String,
    },
    /// A quantity both random and epistemic.
    #[error("'{path}' is both random and epistemic")]
    InputTwice {
        /// The path.
        path: String,
    },
    /// A parameter of a distribution that is itself uncertain.
    #[error("{entry} is itself uncertain; this is not yet supported by this version")]
    UncertainParameter {
        /// The entry.
        entry: String,
    },
    /// An uncertain parameter of the distribution of a parameter.
    #[error("{entry} is itself uncertain; the distribution of a parameter has numbers for parameters")]
    ParameterOfAParameter {
        /// The entry.
        entry: String,
    },
    /// A distribution of a parameter beside what leaves statistics without a single value at it.
    #[error("'{path}' has a distribution, which cannot be used with {beside}")]
    SecondOrderBeside {
        /// The parameter in words.
        path: String,
        /// What it does not go with.
        beside: &'static str,
    },
    /// More uncertain parameters of one distribution than are checked together.
    #[error("{entry} has {found} uncertain parameters; at most {most} are accepted")]
    TooManyParameters {
        /// The entry.
        entry: String,
        /// How many there are.
        found: usize,
        /// The most that are accepted.
        most: usize,
    },
    /// A number of a distribution that breaks its rule.
    #[error("{entry} {found}; must be {rule}")]
    DistributionRule {
        /// The entry.
        entry: String,
        /// The value with its unit.
        found: String,
        /// The rule, with the other value where there is one.
        rule: String,
    },
    /// A distribution whose numbers are right one by one and still describe none.
    #[error("{entry}: {}", without_hint(.error, *.dimension))]
    Distribution {
        /// The entry.
        entry: String,
        /// Why.
        error: DistributionError,
        /// What the numbers measure.
        dimension: Dimension,
    },
    /// An interval whose lower end lies above its upper end.
    #[error("{entry} begins at {lower} and ends at {upper}; the lower end must be first")]
    IntervalTurnedRound {
        /// The entry.
        entry: String,
        /// First number with its unit.
        lower: String,
        /// Second number with its unit.
        upper: String,
    },
    /// An interval with equal ends.
    #[error("{entry} begins and ends at {value}; nothing is uncertain")]
    IntervalWithoutWidth {
        /// The entry.
        entry: String,
        /// Both ends, with their unit.
        value: String,
    },
    /// A period of an angle after which it does not begin again.
    #[error("{entry} is {found} wide; must be a whole turn (360°) or a whole fraction of it")]
    Period {
        /// The entry.
        entry: String,
        /// Its width with its unit.
        found: String,
    },
    /// Intervals that do not fit together.
    #[error("{entry}: {words}")]
    Structure {
        /// The entry.
        entry: String,
        /// What is wrong, with units.
        words: String,
    },
    /// Corners of a fuzzy number that are too few or too many.
    #[error("{entry} has {found} corners; must be {due}")]
    Corners {
        /// The entry.
        entry: String,
        /// How many there are.
        found: usize,
        /// How many are due.
        due: usize,
    },
    /// Degrees beside cuts that have their own.
    #[error("{entry} stands beside cuts, which have degrees of their own")]
    DegreesTwice {
        /// The entry.
        entry: String,
    },
    /// Quantiles or a mean without ends.
    #[error("{entry} needs a support: between which ends does the quantity lie?")]
    NoSupport {
        /// The entry.
        entry: String,
    },
    /// A support without quantiles or a mean.
    #[error("{entry} needs quantiles or a mean")]
    SupportAlone {
        /// The entry.
        entry: String,
    },
    /// A list with nothing to choose.
    #[error("{entry} has 1 entry; give at least 2")]
    SingleMember {
        /// The list.
        entry: String,
    },
    /// The same member again.
    #[error("{entry} holds {value} twice")]
    MemberTwice {
        /// The list.
        entry: String,
        /// The member.
        value: String,
    },
    /// A law that the contact cannot have.
    #[error("{entry}: {error}")]
    Law {
        /// The list.
        entry: String,
        /// Why.
        error: LawError,
    },
    /// A law among the random inputs.
    #[error("'{path}' is a law; no distribution tells how probable it is")]
    RandomLaw {
        /// The path.
        path: String,
    },
    /// A law between two ends.
    #[error("'{path}' is a law; it cannot have an interval")]
    IntervalOfLaws {
        /// The path.
        path: String,
    },
    /// An interval at whose end a joint loses its clearance.
    #[error(
        "'{path}' reaches {end}, where {} becomes 0: a joint without play is another mechanism, and one study cannot mix both",
        describe_path(.clearance)
    )]
    ClearanceTouchesZero {
        /// The input.
        path: String,
        /// The end with its unit.
        end: String,
        /// Path of the clearance.
        clearance: String,
        /// Whether the end is one of a list.
        is_member: bool,
    },
    /// A value within the inputs that is impossible.
    #[error("'{path}' reaches {end}, which is impossible: {error}")]
    ImpossibleEnd {
        /// The input.
        path: String,
        /// The end with its unit.
        end: String,
        /// Why.
        error: QuantityError,
    },
    /// Intervals and lists that are possible one by one and impossible together.
    #[error("the intervals together allow what is impossible: {error}")]
    ImpossibleTogether {
        /// Why.
        error: QuantityError,
    },
    /// A distribution too much of which is impossible.
    #[error(
        "'{path}' is impossible with a probability of {share_percent} %; at most {most_percent} % are accepted: {error}"
    )]
    ImpossibleShare {
        /// The input.
        path: String,
        /// The share, per cent.
        share_percent: String,
        /// The most that is accepted, per cent.
        most_percent: f64,
        /// The first impossible value.
        error: QuantityError,
    },
    /// An output that the model does not have.
    #[error("{entry}: the model has no output '{name}'")]
    UnknownOutput {
        /// The entry.
        entry: String,
        /// The name.
        name: String,
        /// The nearest output.
        nearest: Option<String>,
        /// All outputs.
        known: Vec<String>,
    },
    /// A question about a path of a point.
    #[error("{entry}: output '{name}' is a path of two columns and has no single deviation")]
    PathOutput {
        /// The entry.
        entry: String,
        /// The output.
        name: String,
    },
    /// Poses of a drive that the cycle does not count.
    #[error("{entry}: '{name}' is not the drive that the cycle counts; must be '{due}'")]
    WrongDrive {
        /// The entry.
        entry: String,
        /// The name.
        name: String,
        /// The drive of the cycle.
        due: String,
    },
    /// Two poses whose numbers would have the same name.
    #[error(
        "{entry}: {pose} is {apart} beside an angle asked of the same output before; must be the same, or more than 1e-9 rad away"
    )]
    PosesTooNear {
        /// The entry.
        entry: String,
        /// The angle.
        pose: String,
        /// How far apart they are.
        apart: String,
    },
    /// A method for what is no probability.
    #[error("{entry}: {of} has no method")]
    MethodOfQuantile {
        /// The entry.
        entry: String,
        /// What it is.
        of: &'static str,
    },
    /// A band for whole curves of what is no curve.
    #[error("{entry}: a simultaneous band is of a whole curve")]
    BandOfPoint {
        /// The entry.
        entry: String,
    },
    /// A small probability where nothing scatters.
    #[error("{entry}: nothing is random, so that no probability is small")]
    NothingRandom {
        /// The entry.
        entry: String,
    },
    /// A value of the model that the study does not come to.
    #[error("'{path}' is {value} in the model, and from {from} to {to} here")]
    FarFromModel {
        /// The input.
        path: String,
        /// The value of the model with its unit.
        value: String,
        /// About where the input begins, with its unit.
        from: String,
        /// About where it ends, with its unit.
        to: String,
    },
    /// The same question again.
    #[error("{entry}: {what} is already asked, of the same output at the same place")]
    AskedTwice {
        /// The entry.
        entry: String,
        /// What is asked, as it is written.
        what: String,
    },
    /// An angle that stands in a list twice.
    #[error("{entry}: {pose} is already in this list")]
    PoseTwice {
        /// The entry.
        entry: String,
        /// The angle.
        pose: String,
    },
    /// Percentiles over nothing.
    #[error("{entry}: no parameter of a distribution has a distribution, so there are no percentiles")]
    PercentilesOfNothing {
        /// The entry.
        entry: String,
    },
    /// Direct runs that confirm no surrogate.
    #[error("{entry} is \"confirming\"; the study has no surrogate to confirm")]
    NothingToConfirm {
        /// The entry.
        entry: String,
    },
    /// A question that the surrogate alone does not answer.
    #[error("{entry}: {of} need direct runs")]
    NeedsDirectRuns {
        /// The entry.
        entry: String,
        /// What is asked.
        of: &'static str,
    },
    /// A small probability of which only sums over focal elements, or belief and plausibility, are wanted.
    #[error("{entry}: a method finds where the probability is largest over fixed values; it knows no {of}")]
    RareOfSets {
        /// The entry.
        entry: String,
        /// What of: a reading or masses.
        of: &'static str,
    },
    /// Something to loosen that is no interval and has no standard deviation.
    #[error(
        "'{path}' under [allow] is neither a plain interval of [epistemic] nor a normal, lognormal or truncated_normal of [random] \
         with a known standard deviation"
    )]
    AllowedInput {
        /// The path.
        path: String,
    },
    /// A value that is no looser than the least.
    #[error("{entry} {found}; must be above {least}")]
    AllowedRange {
        /// The entry.
        entry: String,
        /// The value with its unit.
        found: String,
        /// The lower end of the interval, or zero.
        least: String,
    },
    /// What may be fitted otherwise and is no fit.
    #[error(
        "'{path}' under [allow] is neither a plain interval of [epistemic] nor a known normal distribution of [random]"
    )]
    FittedInput {
        /// The path.
        path: String,
    },
    /// A key that does not go with fits, or only with them.
    #[error("{entry} {}", if *.has_fits { "cannot be used with fits: they have no cost" } else { "needs fits" })]
    BesideFits {
        /// The entry.
        entry: String,
        /// Whether there are fits.
        has_fits: bool,
    },
    /// An offer beyond what is asked about.
    #[error("{entry}: {offer} is offered; the largest value that is asked about is {up_to}")]
    OfferBeyond {
        /// The entry.
        entry: String,
        /// The offer with its unit.
        offer: String,
        /// The largest value.
        up_to: String,
    },
    /// Prices in which what is looser costs no less.
    #[error("{entry}: give each value once, with its cost; a looser value must cost less")]
    Costs {
        /// The entry.
        entry: String,
    },
    /// Something to loosen as far as nothing allows.
    #[error("[allow] without a requirement: anything would be allowed")]
    NothingRequired,
    /// An empty list.
    #[error("{entry} is empty; give at least one")]
    Empty {
        /// The entry.
        entry: String,
    },
    /// A limit of a magnitude that is negative or zero.
    #[error("{entry} {found}; must be {rule}")]
    Limit {
        /// The entry.
        entry: String,
        /// The value with its unit.
        found: String,
        /// The rule.
        rule: &'static str,
    },
    /// No random and no epistemic input.
    #[error("the study has no uncertain input")]
    NothingUncertain,
    /// No question and no requirement.
    #[error("the study asks no question")]
    NothingAsked,
}

/// The text of a distribution error, with units where it says more than the rules checked before.
fn without_hint(error: &DistributionError, dimension: Dimension) -> String {
    let text = |value_si: f64| format_value(value_si, dimension);
    match *error {
        DistributionError::NothingKept { mean, standard_deviation, lower, upper, .. } => format!(
            "a normal distribution with mean {} and standard deviation {} has almost no probability between {} and {}",
            text(mean),
            text(standard_deviation),
            text(lower),
            text(upper)
        ),
        DistributionError::NothingLeft { family, lower, upper, .. } => {
            let ends = match (lower.is_finite(), upper.is_finite()) {
                (true, true) => format!("between {} and {}", text(lower), text(upper)),
                (true, false) => format!("above {}", text(lower)),
                _ => format!("below {}", text(upper)),
            };
            format!("the {family} distribution has almost no probability {ends}")
        }
        _ => error.to_string(),
    }
}

impl Problem for StudyProblem {
    fn code(&self) -> Code {
        match self {
            Self::Path(error) => error.code(),
            Self::UnquotedPath { .. } => Code::UnknownPath,
            Self::InputTwice { .. } => Code::InputTwice,
            Self::FarFromModel { .. } => Code::FarFromModel,
            Self::UncertainParameter { .. } => Code::NotYetSupported,
            Self::DistributionRule { .. }
            | Self::Distribution { .. }
            | Self::TooManyParameters { .. }
            | Self::ParameterOfAParameter { .. }
            | Self::SecondOrderBeside { .. } => Code::BadDistribution,
            Self::SingleMember { .. } | Self::MemberTwice { .. } => Code::BadList,
            Self::Structure { .. }
            | Self::Corners { .. }
            | Self::DegreesTwice { .. }
            | Self::NoSupport { .. }
            | Self::SupportAlone { .. } => Code::BadEvidence,
            Self::Law { error, .. } => error.code(),
            Self::RandomLaw { .. } | Self::IntervalOfLaws { .. } => Code::BadList,
            Self::IntervalTurnedRound { .. } => Code::IntervalTurnedRound,
            Self::IntervalWithoutWidth { .. } => Code::IntervalWithoutWidth,
            Self::Period { .. } => Code::BadPeriod,
            Self::ClearanceTouchesZero { .. } => Code::ClearanceTouchesZero,
            Self::ImpossibleEnd { error, .. } | Self::ImpossibleTogether { error } => error.code(),
            Self::ImpossibleShare { .. } => Code::ImpossibleShare,
            Self::UnknownOutput { .. } => Code::UnknownReference,
            Self::PathOutput { .. }
            | Self::WrongDrive { .. }
            | Self::AskedTwice { .. }
            | Self::PoseTwice { .. }
            | Self::PercentilesOfNothing { .. }
            | Self::NothingToConfirm { .. }
            | Self::PosesTooNear { .. }
            | Self::Empty { .. }
            | Self::Limit { .. }
            | Self::MethodOfQuantile { .. }
            | Self::BandOfPoint { .. }
            | Self::NothingRandom { .. }
            | Self::RareOfSets { .. }
            | Self::NeedsDirectRuns { .. }
            | Self::AllowedInput { .. }
            | Self::AllowedRange { .. }
            | Self::FittedInput { .. }
            | Self::BesideFits { .. }
            | Self::OfferBeyond { .. }
            | Self::Costs { .. }
            | Self::NothingRequired => Code::AskNotPossible,
            Self::StatisticForm { .. } | Self::NoPlay { .. } | Self::CertaintyOfSamples { .. } => Code::AskNotPossible,
            Self::Percent { .. } => Code::BadProbability,
            Self::NothingUncertain => Code::NothingUncertain,
            Self::NothingAsked => Code::NothingAsked,
        }
    }

    fn hint(&self) -> Option<String> {
        match self {
            Self::Path(error) => error.hint(),
            Self::UnquotedPath { path } => Some(format!("write \"{path}\" = {{ ... }}")),
            Self::InputTwice { .. } => Some("keep one of the two".to_owned()),
            Self::TooManyParameters { .. } => Some("write one number for those that matter least".to_owned()),
            Self::SecondOrderBeside { .. } => Some("state the parameter as an interval".to_owned()),
            Self::ParameterOfAParameter { .. } | Self::UncertainParameter { .. } => {
                Some("write one number with its unit".to_owned())
            }
            Self::Distribution {
                error: DistributionError::NothingKept { .. } | DistributionError::NothingLeft { .. },
                ..
            } => Some("cut nearer to the mean, or state a uniform distribution".to_owned()),
            Self::NoSupport { .. } => Some("write support = [least, greatest] beside it".to_owned()),
            Self::SupportAlone { .. } => Some("for two ends and nothing else write interval = [...]".to_owned()),
            Self::FarFromModel { .. } => Some(
                "correct the wrong value, or ignore this if it is intended: deviations are from the ideal motion of the model"
                    .to_owned(),
            ),
            Self::DegreesTwice { .. } => Some("leave it out".to_owned()),
            Self::AskedTwice { .. } | Self::PoseTwice { .. } => Some("leave one of the two out".to_owned()),
            Self::PercentilesOfNothing { .. } => {
                Some("leave it out, or give a parameter of a random input a distribution of its own".to_owned())
            }
            Self::NothingToConfirm { .. } => Some("leave it out, or write kind = \"auto\"".to_owned()),
            Self::SingleMember { .. } => Some("write the value in the model file, or name the others".to_owned()),
            Self::MemberTwice { .. } => Some("keep one of the two".to_owned()),
            Self::Law { error, .. } => error.hint(),
            Self::RandomLaw { path } | Self::IntervalOfLaws { path } => Some(format!(
                "write \"{path}\" = {{ any_of = [\"lankarani-nikravesh\", \"flores\"] }} under [epistemic]"
            )),
            Self::IntervalTurnedRound { lower, upper, .. } => Some(format!("write [\"{upper}\", \"{lower}\"]")),
            Self::IntervalWithoutWidth { .. } => {
                Some("write the value in the model file, or widen the interval".to_owned())
            }
            Self::Period { .. } => Some("for an angle between two ends write interval = [...]".to_owned()),
            Self::ClearanceTouchesZero { end, is_member: true, .. } => {
                Some(format!("leave {end} out, and run the ideal joint as a study of its own"))
            }
            Self::ClearanceTouchesZero { .. } => {
                Some("begin the interval above zero, and run the ideal joint as a study of its own".to_owned())
            }
            Self::ImpossibleEnd { error, .. } | Self::ImpossibleTogether { error } => error.hint(),
            Self::ImpossibleShare { .. } => {
                Some("choose a distribution that stays in the range: truncated_normal, lognormal or beta".to_owned())
            }
            Self::UnknownOutput { nearest: Some(nearest), .. } => Some(format!("did you mean '{nearest}'?")),
            Self::UnknownOutput { known, .. } if known.is_empty() => Some("the model has no outputs".to_owned()),
            Self::UnknownOutput { known, .. } => Some(format!("there is {}", listed(known, "and"))),
            Self::PathOutput { .. } => {
                Some("give the model an output position_of the point along x or y, and ask for that".to_owned())
            }
            Self::OfferBeyond { offer, .. } => Some(format!("write up_to = \"{offer}\", or leave the offer out")),
            Self::BesideFits { .. } => Some("leave it out".to_owned()),
            Self::AllowedInput { .. } | Self::FittedInput { .. } => {
                Some("name the input under [epistemic] or [random] first".to_owned())
            }
            Self::NothingRequired => Some("add [[require]]".to_owned()),
            Self::Costs { .. } => Some("leave out offers that are no cheaper".to_owned()),
            Self::BandOfPoint { .. } => {
                Some("write at = \"cycle\", or ask for two quantiles of a single number".to_owned())
            }
            Self::PosesTooNear { .. } => Some("write the angle in the same way wherever it is asked for".to_owned()),
            Self::MethodOfQuantile { .. } => Some("methods are for probability_above, _below and _beyond".to_owned()),
            Self::NothingRandom { .. } | Self::RareOfSets { .. } => Some("leave 'method' out".to_owned()),
            Self::NeedsDirectRuns { .. } => Some("write direct = \"double-loop\", or do not ask for them".to_owned()),
            Self::NothingUncertain => {
                Some("name uncertain quantities under [random] or [epistemic]; for one run use simulate".to_owned())
            }
            Self::Percent { .. } => Some("probabilities are written as numbers, 97.5 % is 0.975".to_owned()),
            Self::NoPlay { .. } => {
                Some("ask for of = \"dimensional\", or give a joint play in the model file".to_owned())
            }
            Self::CertaintyOfSamples { .. } => Some(
                "require a share below 1, such as 0.9973, or state ends of what scatters under [epistemic]".to_owned(),
            ),
            Self::NothingAsked => Some("add [[ask]] or [[require]]".to_owned()),
            _ => None,
        }
    }
}

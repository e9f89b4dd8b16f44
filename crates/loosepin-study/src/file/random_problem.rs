//! What can be wrong with random inputs that are not stated as a distribution, and with correlations.

use thiserror::Error;

use crate::iso_286::FitError;
use loosepin_text::diagnostics::{Code, Problem};
use loosepin_text::document::listed;
use loosepin_text::units::{Dimension, format_number, format_value};
use loosepin_uncertainty::{FEWEST_FITTED, SampleFitError};

/// What can be wrong with them. `entry` is a path in words.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum RandomProblem {
    /// A key that says more about something that is not there.
    #[error("{entry} belongs to {to}, which is not there")]
    StrayKey {
        /// The entry.
        entry: String,
        /// The key that it belongs to.
        to: &'static str,
    },
    /// A cut that cuts nothing.
    #[error("{entry} has neither lower nor upper")]
    NoCut {
        /// The entry.
        entry: String,
    },
    /// A column that measures something else.
    #[error("{entry}: the column '{column}' is {found}; expected {due}")]
    SampleDimension {
        /// The entry.
        entry: String,
        /// The column.
        column: String,
        /// What it measures.
        found: Dimension,
        /// What is due.
        due: Dimension,
    },
    /// A sample that a family cannot be fitted to.
    #[error("{entry}: no {family} distribution fits the column '{column}': {}", fit_words(.error, *.dimension))]
    NoFit {
        /// The entry.
        entry: String,
        /// The family.
        family: &'static str,
        /// The column.
        column: String,
        /// Why.
        error: SampleFitError,
        /// What it measures.
        dimension: Dimension,
    },
    /// A fitted family that its own samples would hardly be as far from.
    #[error(
        "{entry}: the fitted {family} distribution is far from the column '{column}': Anderson-Darling distance \
         {distance}, which samples of this family exceed in less than 5 % of cases"
    )]
    PoorFit {
        /// The entry.
        entry: String,
        /// The family.
        family: &'static str,
        /// The column.
        column: String,
        /// The distance.
        distance: String,
    },
    /// Text that is no value with a tolerance.
    #[error("{entry}: '{text}' is no value with its tolerance")]
    NoTolerance {
        /// The entry.
        entry: String,
        /// The text.
        text: String,
    },
    /// Limits that leave nothing between them.
    #[error("{entry}: limits {lower} and {upper}; the lower one must be below the upper one")]
    NoRoom {
        /// The entry.
        entry: String,
        /// Lower limit with its unit.
        lower: String,
        /// Upper limit with its unit.
        upper: String,
    },
    /// A capability that is no positive number.
    #[error("{entry} {found}; must be > 0")]
    Capability {
        /// The entry.
        entry: String,
        /// The number.
        found: String,
    },
    /// A Cpk above the Cp.
    #[error("{entry} {cpk} is greater than cp {cp}; Cpk is Cp less what the mean is off centre")]
    CapabilitiesExchanged {
        /// The entry.
        entry: String,
        /// Cpk.
        cpk: String,
        /// Cp.
        cp: String,
    },
    /// Probabilities that do not fit the values.
    #[error("{entry} has {found}; {due}")]
    Probabilities {
        /// The entry.
        entry: String,
        /// How many, or their sum.
        found: String,
        /// The rule.
        due: String,
    },
    /// A fit that is none.
    #[error("{entry}: {error}")]
    Fit {
        /// The entry.
        entry: String,
        /// Why.
        error: FitError,
    },
    /// A fit for what is no radial clearance.
    #[error("'{path}' is no radial clearance of a joint; a fit gives nothing else")]
    FitElsewhere {
        /// The path.
        path: String,
    },
    /// A fit at another diameter than that of its bearing.
    #[error("{entry} {diameter}; the bearing of joint '{joint}' has {bearing}, and tolerances go by the size")]
    OtherDiameter {
        /// The entry.
        entry: String,
        /// The diameter of the fit.
        diameter: String,
        /// The joint.
        joint: String,
        /// The diameter of its bearing.
        bearing: String,
    },
    /// Fewer than two fits.
    #[error("{entry} has {found} {}; the loosest of several is asked for", if *.found == 1 { "fit" } else { "fits" })]
    SingleFit {
        /// The entry.
        entry: String,
        /// How many there are.
        found: usize,
    },
    /// Two fits with the same clearances.
    #[error("{fit} has the same clearances as {other}, which is in the list too")]
    SameFit {
        /// The fit.
        fit: String,
        /// The other one.
        other: String,
    },
    /// A fit that can interfere.
    #[error(
        "{entry}: {fit} at {diameter} can interfere: radial clearance from {least} to {most}; must be > 0 for a joint with play"
    )]
    Interference {
        /// The entry.
        entry: String,
        /// The fit.
        fit: String,
        /// The nominal diameter with its unit.
        diameter: String,
        /// Least radial clearance.
        least: String,
        /// Greatest radial clearance.
        most: String,
    },
    /// A correlation with an epistemic input.
    #[error("{entry}: '{path}' is epistemic; only random inputs can be correlated")]
    Epistemic {
        /// The entry.
        entry: String,
        /// The path.
        path: String,
    },
    /// A correlation with what is not random.
    #[error("{entry}: '{path}' is no random input of this study")]
    NotRandom {
        /// The entry.
        entry: String,
        /// The path.
        path: String,
        /// The random inputs.
        known: Vec<String>,
    },
    /// A correlation of an input with itself.
    #[error("{entry} names '{path}' twice")]
    WithItself {
        /// The entry.
        entry: String,
        /// The path.
        path: String,
    },
    /// The same pair again.
    #[error("{entry}: a second correlation of '{first}' and '{second}'")]
    PairTwice {
        /// The entry.
        entry: String,
        /// One path.
        first: String,
        /// The other one.
        second: String,
    },
    /// A correlation that is none.
    #[error("{entry} {found}; must be between -1 and 1, both excluded")]
    Range {
        /// The entry.
        entry: String,
        /// The number.
        found: String,
    },
    /// A linear correlation that the two distributions cannot have.
    #[error("{entry} {found}; the distributions of '{first}' and '{second}' can have {least} to {most}")]
    Unattainable {
        /// The entry.
        entry: String,
        /// The number.
        found: String,
        /// One path.
        first: String,
        /// The other one.
        second: String,
        /// Least linear correlation.
        least: String,
        /// Greatest linear correlation.
        most: String,
    },
    /// A linear correlation with a probability box.
    #[error("{entry}: '{path}' has an uncertain parameter, and with it its linear correlations")]
    LinearOfBox {
        /// The entry.
        entry: String,
        /// The path.
        path: String,
    },
    /// Correlations that contradict each other.
    #[error(
        "the correlations of {} contradict each other: the least eigenvalue of their matrix is {least_eigenvalue}; must be > 0",
        listed(.pairs, "and")
    )]
    NotPositiveDefinite {
        /// The pairs.
        pairs: Vec<String>,
        /// The least eigenvalue.
        least_eigenvalue: String,
        /// By what they can be multiplied at most.
        factor: String,
    },
}

fn fit_words(error: &SampleFitError, dimension: Dimension) -> String {
    match error {
        SampleFitError::NotPositive { value } => {
            format!("it holds {}, and this family has positive values only", format_value(*value, dimension))
        }
        _ => error.to_string(),
    }
}

impl Problem for RandomProblem {
    fn code(&self) -> Code {
        match self {
            Self::StrayKey { .. } => Code::ConflictingKeys,
            Self::NoCut { .. } | Self::Probabilities { .. } => Code::BadDistribution,
            Self::SampleDimension { .. } | Self::NoFit { .. } | Self::PoorFit { .. } => Code::BadSample,
            Self::NoTolerance { .. }
            | Self::NoRoom { .. }
            | Self::Capability { .. }
            | Self::CapabilitiesExchanged { .. } => Code::BadTolerance,
            Self::Fit { .. }
            | Self::FitElsewhere { .. }
            | Self::OtherDiameter { .. }
            | Self::SingleFit { .. }
            | Self::SameFit { .. }
            | Self::Interference { .. } => Code::FitNotPossible,
            Self::Epistemic { .. }
            | Self::NotRandom { .. }
            | Self::WithItself { .. }
            | Self::PairTwice { .. }
            | Self::Range { .. }
            | Self::Unattainable { .. }
            | Self::LinearOfBox { .. }
            | Self::NotPositiveDefinite { .. } => Code::BadCorrelation,
        }
    }

    fn hint(&self) -> Option<String> {
        match self {
            Self::NoCut { .. } => Some("for example truncated = { upper = 1 }".to_owned()),
            Self::SampleDimension { column, due, .. } => {
                let unit = due.si_unit();
                Some(format!("write the unit in the header, for example {column} [{unit}]"))
            }
            Self::NoFit { error: SampleFitError::TooFew { .. }, .. } => {
                Some(format!("measure at least {FEWEST_FITTED} parts, or state an interval under [epistemic]"))
            }
            Self::NoFit { error: SampleFitError::NotPositive { .. }, .. } => {
                Some("normal and gumbel have values of either sign".to_owned())
            }
            Self::OtherDiameter { bearing, .. } => {
                Some(format!("write diameter = \"{bearing}\", or correct bearing_radius"))
            }
            Self::SameFit { .. } => Some("keep one of the two".to_owned()),
            Self::NoFit { .. } => Some("leave fitted out to take the sample as it is".to_owned()),
            Self::PoorFit { .. } => {
                Some("try another family, or leave fitted out to take the sample as it is".to_owned())
            }
            Self::NoTolerance { text, .. } if text.contains(',') => {
                Some(format!("decimal numbers have a point: \"{}\"", text.replace(',', ".")))
            }
            Self::NoTolerance { .. } => Some("write \"50 ± 0.05 mm\" (or +/-) or \"50 +0.02 -0.01 mm\"".to_owned()),
            Self::CapabilitiesExchanged { .. } => Some("exchange them, or leave cp out".to_owned()),
            Self::Fit { error: FitError::NotAFit { .. }, .. } => {
                Some("write the hole first, in capital letters, for example \"H7/g6\"".to_owned())
            }
            Self::Fit { error: FitError::Letter { .. } | FitError::Grade { .. }, .. } => {
                Some("write the limits as an interval, or as a value with its tolerance".to_owned())
            }
            Self::FitElsewhere { .. } => Some("write a value with its tolerance instead".to_owned()),
            Self::Interference { .. } => Some(
                "holes H fit shafts d to g with play at all sizes; a joint without play is another mechanism"
                    .to_owned(),
            ),
            Self::Epistemic { .. } => Some("a value that is fixed but unknown has no correlation".to_owned()),
            Self::NotRandom { known, .. } if known.is_empty() => Some("there are no random inputs".to_owned()),
            Self::NotRandom { known, .. } => Some(format!("there is {}", listed(known, "and"))),
            Self::PairTwice { .. } => Some("keep one of the two".to_owned()),
            Self::Range { .. } => {
                Some("quantities that always go together follow from one parameter of the model".to_owned())
            }
            Self::LinearOfBox { .. } => {
                Some("write it as a rank correlation, which holds for every value of the parameter".to_owned())
            }
            Self::NotPositiveDefinite { factor, .. } => {
                Some(format!("no quantities can be correlated so; multiplied by less than {factor} they could be"))
            }
            _ => None,
        }
    }
}

/// A pair of paths in words.
pub fn pair_words(first: &str, second: &str) -> String {
    format!("'{first}' with '{second}'")
}

/// A number with as many digits as say by how much a rule is missed.
pub fn short_number(value: f64) -> String {
    format_number(format!("{value:.3e}").parse().unwrap_or(value))
}

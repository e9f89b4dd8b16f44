//! Problems of random inputs that are not stated as a distribution, and of correlations.

use loosepin_text::diagnostics::{Code, problems};
use loosepin_text::document::listed;
use loosepin_text::tolerance::{FitError, limits_of_class};
use loosepin_text::units::{Dimension, format_number, format_value};
use loosepin_uncertainty::{FEWEST_FITTED, SampleFitError};

problems! {
    /// Problems of random inputs. `entry` is a path in words.
    #[derive(Debug, Clone, PartialEq)]
    pub enum RandomProblem {
        /// A key that says more about something that is not there.
        StrayKey { entry: String, to: &'static str } => Code::ConflictingKeys,
            says("{entry} needs {to}, which is missing");
        /// A cut that cuts nothing.
        NoCut { entry: String } => Code::BadDistribution,
            says("{entry} has neither lower nor upper"),
            hint("for example truncated = {{ upper = 1 }}");
        /// A column that measures something else.
        SampleDimension { entry: String, column: String, found: Dimension, due: Dimension } => Code::BadSample,
            says("{entry}: the column '{column}' is {found}; expected {due}"),
            hint("write the unit in the header, for example {column} [{}]", due.si_unit());
        /// A sample that a family cannot be fitted to.
        NoFit { entry: String, family: &'static str, column: String, error: SampleFitError, dimension: Dimension } =>
            Code::BadSample,
            says("{entry}: no {family} distribution fits the column '{column}': {}", fit_words(error, *dimension)),
            hint_of(Some(match error {
                SampleFitError::TooFew { .. } => {
                    format!("measure at least {FEWEST_FITTED} parts, or give an interval under [epistemic]")
                }
                SampleFitError::NotPositive { .. } => "normal and gumbel have values of either sign".to_owned(),
                _ => "omit fitted to use the sample as it is".to_owned(),
            }));
        /// A fitted family that its own samples would hardly be as far from.
        PoorFit { entry: String, family: &'static str, column: String, distance: String } => Code::BadSample,
            says("{entry}: the fitted {family} distribution is far from the column '{column}': Anderson-Darling \
                  distance {distance}, which samples of this family exceed in less than 5 % of cases"),
            hint("try another family, or omit fitted to use the sample as it is");
        /// Text that is no value with a tolerance. `nominal` is the value of the model where the text is a limit alone.
        NoTolerance { entry: String, text: String, nominal: Option<String> } => Code::BadTolerance,
            says("{entry}: '{text}' is not a nominal value with its limits"),
            hint_of(Some(match nominal {
                _ if text.contains(',') => format!("decimal numbers have a point: \"{}\"", text.replace(',', ".")),
                _ if limits_of_class(text).is_some() => match limits_of_class(text).flatten() {
                    Some(class) => format!("by ISO 286 write \"{}\"", class.deviations),
                    None => "write the limits of the class: for 50 mm, \"+0.02 -0.01 mm\"".to_owned(),
                },
                Some(nominal) => format!("write \"± {text}\" about the value of the model, or \"{nominal} ± {text}\""),
                None => "write the nominal value and its limits: for 50 mm, \"50 ± 0.05 mm\" (or +/-) or \"50 +0.02 -0.01 mm\"".to_owned(),
            }));
        /// A value with its tolerance, where a table is due that says what is made of it.
        BareTolerance { entry: String, found: String, path: String, table: String } => Code::WrongType,
            says("{entry} is {found}; expected a table"),
            hint("write \"{path}\" = {table}");
        /// Limits that leave nothing between them.
        NoRoom { entry: String, lower: String, upper: String } => Code::BadTolerance,
            says("{entry}: limits {lower} and {upper}; the lower one must be below the upper one");
        /// A capability that is no positive number.
        Capability { entry: String, found: String } => Code::BadTolerance,
            says("{entry} {found}; must be > 0");
        /// A Cpk above the Cp.
        CapabilitiesExchanged { entry: String, cpk: String, cp: String } => Code::BadTolerance,
            says("{entry} {cpk} is greater than cp {cp}; Cpk is Cp reduced by the offset of the mean"),
            hint("exchange them, or omit cp");
        /// Probabilities that do not fit the values.
        Probabilities { entry: String, found: String, due: String } => Code::BadDistribution,
            says("{entry} has {found}; {due}");
        /// A fit that is none.
        Fit { entry: String, error: FitError } => Code::FitNotPossible,
            says("{entry}: {error}"),
            hint_of(match error {
                FitError::NotAFit { .. } => Some("write the hole first, in capital letters, for example \"H7/g6\""),
                FitError::Letter { .. } | FitError::Grade { .. } => {
                    Some("write the limits as an interval, or as a value with its tolerance")
                }
                _ => None,
            }.map(str::to_owned));
        /// A fit for what is no radial clearance.
        FitElsewhere { path: String } => Code::FitNotPossible,
            says("'{path}' is neither the radial nor the diametral clearance of a joint; a fit gives only these"),
            hint("write a value with its tolerance instead");
        /// A fit at another diameter than that of its bearing.
        OtherDiameter { entry: String, diameter: String, joint: String, bearing: String } => Code::FitNotPossible,
            says("{entry} {diameter}, but the bearing of joint '{joint}' has {bearing}, and tolerances depend on the size"),
            hint("write diameter = \"{bearing}\", or correct bearing_radius");
        /// Fewer than two fits.
        SingleFit { entry: String, found: usize } => Code::FitNotPossible,
            says("{entry} has {found} {}; must have several, of which the loosest is sought", if *found == 1 { "fit" } else { "fits" });
        /// Two fits with the same clearances.
        SameFit { fit: String, other: String } => Code::FitNotPossible,
            says("{fit} has the same clearances as {other}, which is also in the list"),
            hint("keep one of the two");
        /// A fit that can interfere.
        Interference { entry: String, fit: String, diameter: String, least: String, most: String } =>
            Code::FitNotPossible,
            says("{entry}: {fit} at {diameter} can interfere: radial clearance from {least} to {most}; must be > 0 for \
                  a joint with play"),
            hint("holes H with shafts d to g have play at all sizes; a joint without play is another mechanism");
        /// A correlation with an epistemic input.
        Epistemic { entry: String, path: String } => Code::BadCorrelation,
            says("{entry}: '{path}' is an unknown (epistemic) input; only random inputs can be correlated"),
            hint("a value that is fixed but unknown has no correlation");
        /// A correlation with what is not random.
        NotRandom { entry: String, path: String, known: Vec<String> } => Code::BadCorrelation,
            says("{entry}: '{path}' is not a random input of this study"),
            hint_of(Some(match known.is_empty() {
                true => "there are no random inputs".to_owned(),
                false => format!("available: {}", listed(known, "and")),
            }));
        /// A correlation of an input with itself.
        WithItself { entry: String, path: String } => Code::BadCorrelation,
            says("{entry} names '{path}' twice");
        /// The same pair again.
        PairTwice { entry: String, first: String, second: String } => Code::BadCorrelation,
            says("{entry}: a second correlation of '{first}' and '{second}'"),
            hint("keep one of the two");
        /// A correlation that is none.
        Range { entry: String, found: String } => Code::BadCorrelation,
            says("{entry} {found}; must be between -1 and 1, both excluded"),
            hint("for a correlation of 1 or -1, define both quantities by one parameter of the model");
        /// A linear correlation that the two distributions cannot have.
        Unattainable { entry: String, found: String, first: String, second: String, least: String, most: String } =>
            Code::BadCorrelation,
            says("{entry} {found}; the distributions of '{first}' and '{second}' can have {least} to {most}");
        /// A linear correlation with a probability box.
        LinearOfBox { entry: String, path: String } => Code::BadCorrelation,
            says("{entry}: '{path}' has an uncertain parameter, so its linear correlations are also uncertain"),
            hint("give a rank correlation, which holds for every value of the parameter");
        /// Correlations that contradict each other.
        NotPositiveDefinite { pairs: Vec<String>, least_eigenvalue: String, factor: String } => Code::BadCorrelation,
            says("the correlations of {} contradict each other: the smallest eigenvalue of their matrix is \
                  {least_eigenvalue}; must be > 0", listed(pairs, "and")),
            hint("no quantities can have these correlations; multiplied by less than {factor}, they are possible");
    }
}

fn fit_words(error: &SampleFitError, dimension: Dimension) -> String {
    match error {
        SampleFitError::NotPositive { value } => {
            format!("it contains {}, and this family has positive values only", format_value(*value, dimension))
        }
        _ => error.to_string(),
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

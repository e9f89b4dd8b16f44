//! Inputs and runs as a study file describes them, checked and in SI.

use crate::model::StudyModel;
use loosepin_mechanics::model::{ContactId, NormalDescription, QuantityId};
pub use loosepin_result::study::{Budget, Deviation, Reduction};
use loosepin_surrogate::Choice;
use loosepin_text::units::{Dimension, SiUnit, format_value};
use loosepin_uncertainty::{
    Copula, Distribution, EpistemicParameter, EpistemicVariable, Interval, Parameter, RandomVariable,
};

impl RandomInput {
    /// The quantity, where it is one.
    pub fn quantity(&self) -> Option<QuantityId> {
        match self.subject {
            RandomSubject::Quantity(quantity) => Some(quantity),
            RandomSubject::Journal { .. } => None,
        }
    }

    /// Its path; of a number that the place of a journal is drawn from, that of the place.
    pub fn whole_path(&self) -> &str {
        match &self.subject {
            RandomSubject::Quantity(_) => &self.path,
            RandomSubject::Journal { place } => place,
        }
    }

    /// Dimension of its values; a pure number for the place of a journal.
    pub fn dimension(&self, model: &StudyModel) -> Dimension {
        self.quantity().map_or(Dimension::NUMBER, |quantity| model.quantities()[quantity].dimension)
    }

    /// The unit of its values.
    pub fn unit(&self, model: &StudyModel) -> SiUnit {
        SiUnit::of_dimension(self.dimension(model))
    }

    /// Parameters of the distributions of `random` that are epistemic inputs.
    pub fn epistemic_parameters(random: &[Self]) -> Vec<EpistemicParameter> {
        let of_input = |(random, input): (usize, &RandomInput)| {
            let own = input.parameters.clone().into_iter();
            own.map(move |UncertainParameter { parameter, epistemic }| EpistemicParameter {
                random,
                parameter,
                epistemic,
            })
        };
        random.iter().enumerate().flat_map(of_input).collect()
    }

    /// The largest standard deviation of its distributions, uncertain parameters at the ends.
    pub fn largest_standard_deviation(&self, epistemic: &[EpistemicInput]) -> f64 {
        let deviations = self.variables(epistemic, |known| known.ends().to_vec()).into_iter();
        deviations.map(|variable| variable.standard_deviation()).fold(0.0, f64::max)
    }

    /// Its distribution with every combination of the values that `shown` gives for an uncertain parameter.
    pub fn variables(
        &self,
        epistemic: &[EpistemicInput],
        shown: impl Fn(&EpistemicVariable) -> Vec<f64>,
    ) -> Vec<RandomVariable> {
        let values: Vec<(Parameter, Vec<f64>)> = self
            .parameters
            .iter()
            .map(|uncertain| (uncertain.parameter, shown(&epistemic[uncertain.epistemic].variable)))
            .collect();
        let combinations = values.iter().fold(1, |product, (_, values)| product * values.len());
        (0..combinations)
            .filter_map(|combination| {
                let mut rest = combination;
                let parameters = values.iter().map(|(parameter, values)| {
                    let value = values[rest % values.len()];
                    rest /= values.len();
                    (*parameter, value)
                });
                self.variable.with_parameters(parameters).ok()
            })
            .collect()
    }
}

/// How many runs, and how accurate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sampling {
    /// Points in the box of the epistemic inputs.
    pub outer: usize,
    /// Samples of the random inputs at each of them.
    pub inner: usize,
    /// Independent randomisations of the inner samples, for the sampling error.
    pub replicates: usize,
    /// Tolerance of a step, m: it may err by 0.5 % of it.
    pub tolerance_m: f64,
    /// The share of the runs of the double loop that may fail, in (0, 1]; where more do, the study ends after their round
    /// (default: 0.1). Results do not depend on it.
    pub most_failed: f64,
}

/// A surrogate, and the runs that it is given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StudySurrogate {
    /// Which kind (default: automatic).
    pub choice: Choice,
    /// Runs to learn from, for each combination of the members of lists (default: 25 for each uncertain input, at least 100).
    pub training_runs: usize,
    /// Direct runs at each witness (default: 16 in each replicate).
    pub confirming_runs: usize,
    /// Whether the direct double loop is not run at all, so that the bounds are those of the surrogate (default: it is run).
    pub is_alone: bool,
}

/// Something that scatters with a known distribution.
#[derive(Debug, Clone, PartialEq)]
pub struct RandomInput {
    /// Path in the model; of the place of a journal its own.
    pub path: String,
    /// What scatters.
    pub subject: RandomSubject,
    /// Its distribution, SI, uncertain parameters in the middle.
    pub variable: RandomVariable,
    /// Source of the distribution, in words, if it is not stated itself: a tolerance, a fit, a sample.
    pub origin: Option<String>,
    /// Parameters of the distribution that are epistemic inputs.
    pub parameters: Vec<UncertainParameter>,
}

/// What a random input is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RandomSubject {
    /// A number of the model.
    Quantity(QuantityId),
    /// One of the numbers from 0 to 1 from which the place of a journal in its play is drawn, in a mechanism in space.
    Journal {
        /// Path of the place as a whole.
        place: String,
    },
}

/// A parameter of a distribution that is an epistemic input.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct UncertainParameter {
    /// The parameter.
    pub parameter: Parameter,
    /// Position among the epistemic inputs.
    pub epistemic: usize,
}

/// How random inputs go together: a Gaussian copula, or rows of a joint sample.
#[derive(Debug, Clone, PartialEq)]
pub struct Correlation {
    /// The correlations in file order; empty for a joint sample.
    pub stated: Vec<StatedCorrelation>,
    /// All of them.
    pub copula: Copula,
}

/// Mechanisms that agree with the measurement, in place of the distributions of the random inputs.
#[derive(Debug, Clone, PartialEq)]
pub struct SpecimenRows {
    /// The file, as it is written.
    pub file: String,
    /// Values of the random inputs in their order, SI, a mechanism a row; all rows are equally probable.
    pub rows_si: Vec<Vec<f64>>,
    /// Number of different rows, equally probable, that say as much.
    pub effective: f64,
}

/// A correlation of two random inputs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StatedCorrelation {
    /// One input, by its place in [`Study::random`](super::Study::random).
    pub first: usize,
    /// The other one.
    pub second: usize,
    /// Measure of the value.
    pub measure: CorrelationMeasure,
    /// The value as stated.
    pub value: f64,
    /// The correlation of the normal variables behind the inputs.
    pub normal: f64,
}

/// Measure of a correlation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CorrelationMeasure {
    /// Ranks (Spearman).
    Rank,
    /// The values themselves (Pearson).
    Linear,
}

/// An unknown input: in an interval, or one of a list.
#[derive(Debug, Clone)]
pub struct EpistemicInput {
    /// Path in the model.
    pub path: String,
    /// Its subject.
    pub subject: EpistemicSubject,
    /// Its structure: SI, laws by their index in the list.
    pub variable: EpistemicVariable,
}

/// The subject of an epistemic input.
#[derive(Debug, Clone)]
pub enum EpistemicSubject {
    /// A number of the model.
    Quantity(QuantityId),
    /// A parameter of the distribution of a random input.
    Parameter {
        /// Position of the random input.
        random: usize,
        /// The parameter.
        parameter: Parameter,
        /// What it measures.
        dimension: Dimension,
    },
    /// The normal force law of a contact.
    Law {
        /// The contact.
        contact: ContactId,
        /// The laws, in file order; a sample has the place of one of them as its value.
        laws: Vec<NormalDescription>,
    },
    /// The places of all journals of a mechanism in space: -1 where play makes an output smallest, 1 where it makes it largest.
    Play,
}

impl EpistemicInput {
    /// The quantity, where it is one.
    pub fn quantity(&self) -> Option<QuantityId> {
        match self.subject {
            EpistemicSubject::Quantity(quantity) => Some(quantity),
            EpistemicSubject::Parameter { .. } | EpistemicSubject::Law { .. } | EpistemicSubject::Play => None,
        }
    }

    /// Dimension of its values; a pure number for a law.
    pub fn dimension(&self, model: &StudyModel) -> Dimension {
        match self.subject {
            EpistemicSubject::Quantity(quantity) => model.quantities()[quantity].dimension,
            EpistemicSubject::Parameter { dimension, .. } => dimension,
            EpistemicSubject::Law { .. } | EpistemicSubject::Play => Dimension::NUMBER,
        }
    }

    /// The interval that holds all possible values; `None` if it is one of a list.
    pub fn interval(&self) -> Option<Interval> {
        self.variable.range()
    }

    /// The law that `value` stands for, where the input is a law.
    pub fn law(&self, value: f64) -> Option<NormalDescription> {
        match &self.subject {
            EpistemicSubject::Quantity(_) | EpistemicSubject::Parameter { .. } | EpistemicSubject::Play => None,
            EpistemicSubject::Law { laws, .. } => laws.get(value as usize).copied(),
        }
    }

    /// Where the journals are, where the input stands for their places and `value` is an end of them.
    pub fn side_of_play(&self, value: f64) -> Option<&'static str> {
        match self.subject {
            EpistemicSubject::Play if value >= 1.0 => Some("largest"),
            EpistemicSubject::Play if value <= -1.0 => Some("smallest"),
            _ => None,
        }
    }

    /// Whether a measurement can find its value: the places of journals are others at each instant.
    pub fn can_be_measured(&self) -> bool {
        !matches!(self.subject, EpistemicSubject::Play)
    }

    /// The unit of its values; that of a pure number for a law.
    pub fn unit(&self, model: &StudyModel) -> SiUnit {
        SiUnit::of_dimension(self.dimension(model))
    }

    /// `value` as it is written: with its unit, or the name of a law.
    pub fn written(&self, model: &StudyModel, value: f64) -> String {
        match self.law(value) {
            Some(law) => law.name().to_owned(),
            None => format_value(value, self.dimension(model)),
        }
    }

    /// Values of an input from a list, one by one, as written.
    pub fn members_written(&self, model: &StudyModel) -> Option<Vec<String>> {
        match &self.variable {
            EpistemicVariable::OneOf(members) => {
                Some(members.values().iter().map(|&value| self.written(model, value)).collect())
            }
            _ => None,
        }
    }
}

/// How a small probability is estimated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RareMethod {
    /// By sampling around design points; by subset simulation where these cannot be relied on.
    Importance,
    /// By subset simulation.
    Subset,
    /// As by importance, where the double loop counts too few.
    Automatic,
}

/// An allowance: an input that is loosened as far as the requirements allow.
#[derive(Debug, Clone, PartialEq)]
pub struct Allowance {
    /// Path of the input.
    pub path: String,
    /// The loosened number of the input.
    pub input: AllowedInput,
    /// The least value, SI: the lower end of the interval, or 0.
    pub least_si: f64,
    /// The largest value that is asked about, SI: of fits the greatest clearance of the loosest.
    pub up_to_si: f64,
    /// Fits that are asked about, the tightest first; empty where something else is loosened.
    pub fits: Vec<AllowedFit>,
    /// Values that are offered, tightest first, each with its cost; empty where it is not priced.
    pub costs: Vec<[f64; 2]>,
}

/// A fit that is asked about.
#[derive(Debug, Clone, PartialEq)]
pub struct AllowedFit {
    /// As it is written, `H7/g6`.
    pub name: String,
    /// Least and greatest radial clearance, m.
    pub clearance_m: [f64; 2],
    /// The radial clearance as a random variable, as `fit` under `[random]` takes it.
    pub scatter: Distribution,
}

/// The loosened number of an input.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AllowedInput {
    /// Both ends of the interval of this epistemic input, the radial clearance of a fit.
    FitInterval(usize),
    /// The distribution of this random input, the radial clearance of a fit.
    FitScatter(usize),
    /// The upper end of the interval of this epistemic input.
    UpperEnd(usize),
    /// The standard deviation of this random input.
    StandardDeviation(usize),
}

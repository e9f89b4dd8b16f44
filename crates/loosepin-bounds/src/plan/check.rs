//! Rules that a problem must keep before it is planned.

use thiserror::Error;

use crate::data::problem::{Problem, Reading, Sampling};
use crate::search::design::structural_point_count;
use crate::search::parts::{Structure, element_count};
use crate::search::search_box::SearchBox;
use loosepin_terms::NumberKind;
use loosepin_uncertainty::{EpistemicParameter, EpistemicVariable, MAXIMUM_DIMENSIONS};

/// Why a problem cannot be planned.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum ProblemError {
    #[error("request {request} asks for column {column}; the response has {columns} columns, counted from 0")]
    NoSuchColumn {
        /// Position of the request, or of the column among the compared ones.
        request: usize,
        column: usize,
        columns: usize,
    },
    #[error("quantile {probability}; must lie between 0 and 1, both excluded")]
    QuantileOutside { probability: f64 },
    #[error(
        "request {request} asks for a simultaneous band of a single column; such a band belongs to the columns of a curve\n\
         hint: `DoubleLoop::simultaneous_band` gives it from the finished runs"
    )]
    BandOfSingleColumn { request: usize },
    #[error("limit {limit} of a probability; must be finite, and >= 0 where it limits a magnitude")]
    BadLimit { limit: f64 },
    #[error("{name} {value}; must lie between 0 and 1, both excluded")]
    ProbabilityOutside { name: &'static str, value: f64 },
    #[error("cut at {standard_deviations} standard deviations; must be > 0 and at most 8")]
    BadCut { standard_deviations: f64 },
    /// A parameter with a distribution beside what gives statistics no single value at it.
    #[error(
        "a parameter with a distribution stands beside {}; must be the only one with probabilities, intervals read as fixed but unknown",
        if *.has_evidence { "evidence" } else { "another reading of intervals" }
    )]
    SecondOrderBeside {
        /// Evidence; else another reading.
        has_evidence: bool,
    },
    #[error("{replicates} replicates; must be at least 2\nhint: 8 give a useful estimate of the sampling error")]
    TooFewReplicates { replicates: usize },
    #[error(
        "parameter {parameter} belongs to random input {random} of {randoms} and is epistemic input {epistemic} of {epistemics}, \
         counted from 0"
    )]
    NoSuchInput { parameter: usize, random: usize, randoms: usize, epistemic: usize, epistemics: usize },
    #[error(
        "{name} {count}; must be a multiple of the {replicates} replicates, at least 2 runs in each, at most 2^31\n\
         hint: {replicates} times a power of two is best"
    )]
    NotAMultiple { name: &'static str, count: usize, replicates: usize },
    #[error(
        "{name} {count}; the corners and the centre of a box with {} need at least {least}\n\
         hint: {recommended} is a good start",
        inputs_words(*.dimensions)
    )]
    TooFewPoints { name: &'static str, count: usize, dimensions: usize, least: usize, recommended: usize },
    #[error(
        "{name} {count}; {combinations} combinations of members, each with the corners and the centre of a box with \
         {}, need at least {least}\n\
         hint: {recommended} is a good start",
        inputs_words(*.dimensions)
    )]
    TooFewForCombinations {
        name: &'static str,
        count: usize,
        /// Combinations of the members of lists.
        combinations: usize,
        dimensions: usize,
        least: usize,
        recommended: usize,
    },
    #[error(
        "{combinations} combinations of the members of lists; must be at most {MAX_COMBINATIONS}\n\
         hint: shorten the lists, or take numbers that lie close together as an interval"
    )]
    TooManyCombinations { combinations: usize },
    #[error(
        "{name} {count}; the corners and centres of all focal elements and cuts need at least {least}\n\
         hint: {recommended} is a good start, and elements that share ends need fewer"
    )]
    TooFewForElements { name: &'static str, count: usize, least: usize, recommended: usize },
    #[error(
        "{elements} combinations of focal elements; must be at most {MAX_ELEMENTS}\n\
         hint: join elements of the inputs that matter least"
    )]
    TooManyElements { elements: usize },
    #[error("{name} {count}; must be at most {most}\nhint: more inner runs reduce the sampling error")]
    TooManyPoints { name: &'static str, count: usize, most: usize },
    #[error("{inputs} uncertain inputs; at most {MAXIMUM_DIMENSIONS}\nhint: fix the inputs that matter least")]
    TooManyInputs { inputs: usize },
    #[error("correlations of {found} random inputs; there are {expected}")]
    OtherCopula { found: usize, expected: usize },
}

/// "1 input", "2 inputs".
fn inputs_words(inputs: usize) -> String {
    format!("{inputs} input{}", if inputs == 1 { "" } else { "s" })
}

/// Every combination of focal elements has bounds of its own.
const MAX_ELEMENTS: usize = 256;

/// Every combination of members is run, and searched by itself.
const MAX_COMBINATIONS: usize = 64;

/// Points in the box of the epistemic inputs at most, with all combinations of the members of lists: with as many, a search takes
/// longer than all else.
pub const MAX_OUTER: usize = 1 << 20;

impl ProblemError {
    /// The number of runs, of points or of replicates that it is about, by the name of its field.
    pub fn key(&self) -> Option<&'static str> {
        match self {
            Self::NotAMultiple { name, .. }
            | Self::TooFewPoints { name, .. }
            | Self::TooFewForCombinations { name, .. }
            | Self::TooFewForElements { name, .. }
            | Self::TooManyPoints { name, .. } => Some(name),
            Self::TooFewReplicates { .. } => Some("replicates"),
            _ => None,
        }
    }
}

impl Problem {
    /// Checks everything that does not need a run.
    pub(crate) fn check(&self) -> Result<(), ProblemError> {
        let inputs = self.random.len() + self.epistemic.len();
        if inputs > MAXIMUM_DIMENSIONS {
            return Err(ProblemError::TooManyInputs { inputs });
        }
        if let Some(copula) = self.copula.as_ref().filter(|copula| copula.inputs() != self.random.len()) {
            return Err(ProblemError::OtherCopula { found: copula.inputs(), expected: self.random.len() });
        }
        self.check_requests()?;
        for (parameter, of) in self.parameters.iter().enumerate() {
            let (randoms, epistemics) = (self.random.len(), self.epistemic.len());
            let EpistemicParameter { random, epistemic, .. } = *of;
            if random >= randoms || epistemic >= epistemics {
                return Err(ProblemError::NoSuchInput { parameter, random, randoms, epistemic, epistemics });
            }
        }
        let Sampling { outer, inner, replicates, mixture, extreme, confidence, .. } = self.sampling;
        check_probability("confidence", confidence)?;
        check_probability("band probability", self.band_probability)?;
        for &percentile in &self.percentiles {
            check_probability("percentile", percentile)?;
        }
        self.check_second_order()?;
        if !(self.cut_standard_deviations > 0.0 && self.cut_standard_deviations <= 8.0) {
            return Err(ProblemError::BadCut { standard_deviations: self.cut_standard_deviations });
        }
        if replicates < 2 {
            return Err(ProblemError::TooFewReplicates { replicates });
        }
        if !self.random.is_empty() {
            check_multiple("inner", inner, replicates)?;
        }
        let search_box = SearchBox::new(self.epistemic.clone());
        let (wide, combinations) = (search_box.dimensions(), search_box.combinations());
        if combinations > MAX_COMBINATIONS {
            return Err(ProblemError::TooManyCombinations { combinations });
        }
        if !search_box.is_a_point() {
            check_points("outer", outer, wide, combinations)?;
        }
        let elements = element_count(&self.epistemic);
        if elements > MAX_ELEMENTS {
            return Err(ProblemError::TooManyElements { elements });
        }
        let structure = Structure::new(&search_box);
        if structure.is_divided() {
            let least = combinations * structure.points(wide).len();
            if outer < least {
                let recommended = (2 * least).max(64);
                return Err(ProblemError::TooFewForElements { name: "outer", count: outer, least, recommended });
            }
        }
        if !self.compared_columns.is_empty() {
            if !search_box.is_a_point() {
                check_multiple("mixture", mixture, replicates)?;
            }
            if !self.random.is_empty() {
                // Parameters of distributions are no dimensions of the joint box.
                let epistemic = self.epistemic.iter().enumerate();
                let is_searched = |(index, _): &(usize, _)| !self.is_parameter(*index);
                let joint = SearchBox::new(epistemic.filter(is_searched).map(|(_, known)| known.clone()).collect());
                let dimensions = self.random.len() + joint.dimensions();
                check_points("extreme", extreme, dimensions, joint.combinations())?;
            }
        }
        Ok(())
    }

    /// A parameter with a distribution is one value for all samples, and no mass of evidence goes with it.
    fn check_second_order(&self) -> Result<(), ProblemError> {
        let mut known = self.epistemic.iter();
        if !known.any(EpistemicVariable::is_second_order) {
            return Ok(());
        }
        let has_evidence = self.epistemic.iter().any(|known| matches!(known, EpistemicVariable::Evidence(_)));
        if has_evidence || self.reading != Reading::FixedButUnknown {
            return Err(ProblemError::SecondOrderBeside { has_evidence });
        }
        Ok(())
    }

    fn check_requests(&self) -> Result<(), ProblemError> {
        let asked = self.requests.iter().map(|request| request.column).enumerate();
        for (request, column) in asked.chain(self.compared_columns.iter().copied().enumerate()) {
            if column >= self.columns {
                return Err(ProblemError::NoSuchColumn { request, column, columns: self.columns });
            }
        }
        for (position, request) in self.requests.iter().enumerate() {
            let statistic = request.statistic;
            if statistic.is_of_curve() {
                return Err(ProblemError::BandOfSingleColumn { request: position });
            }
            if let (false, Some(number)) = (statistic.has_allowed_number(), statistic.parameter()) {
                return Err(match statistic.description().number.map(|number| number.kind) {
                    Some(NumberKind::Share) => ProblemError::QuantileOutside { probability: number },
                    _ => ProblemError::BadLimit { limit: number },
                });
            }
        }
        Ok(())
    }
}

fn check_probability(name: &'static str, value: f64) -> Result<(), ProblemError> {
    if value > 0.0 && value < 1.0 { Ok(()) } else { Err(ProblemError::ProbabilityOutside { name, value }) }
}

fn check_multiple(name: &'static str, count: usize, replicates: usize) -> Result<(), ProblemError> {
    if count.is_multiple_of(replicates) && count >= 2 * replicates && count <= 1 << 31 {
        Ok(())
    } else {
        Err(ProblemError::NotAMultiple { name, count, replicates })
    }
}

fn check_points(name: &'static str, count: usize, dimensions: usize, combinations: usize) -> Result<(), ProblemError> {
    let least = combinations * structural_point_count(dimensions);
    if count < least {
        let recommended = (3 * least).max(64);
        return Err(if combinations == 1 {
            ProblemError::TooFewPoints { name, count, dimensions, least, recommended }
        } else {
            ProblemError::TooFewForCombinations { name, count, combinations, dimensions, least, recommended }
        });
    }
    if count > MAX_OUTER {
        return Err(ProblemError::TooManyPoints { name, count, most: MAX_OUTER });
    }
    Ok(())
}

//! The inverse question: what may be loosened, and what is cheapest.

use serde::{Deserialize, Serialize};

use super::verdict::Verdict;
use loosepin_text::units::{SiUnit, extended};

/// The loosest value of one input that still meets every requirement for every value of the epistemic inputs, the others as in the
/// study.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct AllowanceRecord {
    /// Path of the input.
    pub path: String,
    /// The loosened number of the input.
    pub what: Loosened,
    /// Its unit.
    pub unit: SiUnit,
    /// The loosest value that was asked about.
    #[serde(with = "extended")]
    pub up_to_si: f64,
    /// The loosest value at which all requirements are met, and met again with other random numbers; `None` if there is none.
    #[serde(with = "extended")]
    pub allowed_si: Option<f64>,
    /// The next value above it that was tried, at which they are not met or not decided; `None` if `allowed_si` is `up_to_si`.
    #[serde(with = "extended")]
    pub beyond_si: Option<f64>,
    /// The loosest fit that is allowed, if fits were asked about.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub allowed_fit: Option<String>,
    /// The next looser one of the list.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub beyond_fit: Option<String>,
    /// Every study that was run, in its order.
    pub checks: Vec<AllowanceCheck>,
    /// Runs of all of them.
    pub runs: u64,
}

/// The loosened number of an input.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Loosened {
    /// The upper end of an interval.
    UpperEnd,
    /// The standard deviation of a distribution.
    StandardDeviation,
    /// The fit of a joint with play; values are its greatest radial clearance.
    Fit,
}

/// A direct study at one value.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct AllowanceCheck {
    /// The fit, where fits are asked about.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fit: Option<String>,
    /// The value.
    #[serde(with = "extended")]
    pub value_si: f64,
    /// Result of the study.
    #[serde(flatten)]
    pub answer: CheckAnswer,
}

/// Result of a direct study on the requirements.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CheckAnswer {
    /// Whether other random numbers were used than in the search, to confirm it.
    pub is_confirmation: bool,
    /// The least share of the requirement that is nearest to its limit, numerical error taken off.
    #[serde(with = "extended")]
    pub share: f64,
    /// The share that it requires.
    #[serde(with = "extended")]
    pub required_share: f64,
    /// Over all requirements.
    pub verdict: Verdict,
}

/// The cheapest of all combinations of offers with which every requirement is met.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct AllocationRecord {
    /// The inputs and what is chosen for each; empty where no combination that was tried meets the requirements.
    pub choices: Vec<AllocatedInput>,
    /// The sum of their costs.
    #[serde(with = "extended")]
    pub cost: f64,
    /// Combinations of offers.
    pub combinations: u64,
    /// Why no more of them were run.
    pub stop: AllocationStop,
    /// Direct studies that were run: one for each combination that was tried, a second one where the first met the requirements.
    pub studies: u64,
    /// Cheaper combinations that were run and do not meet the requirements, or are looser than such a one.
    pub excluded: u64,
    /// Runs of all studies.
    pub runs: u64,
}

/// Why a search for the cheapest combination ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum AllocationStop {
    /// One meets the requirements, and every cheaper one is excluded.
    Found,
    /// All are excluded.
    AllExcluded,
    /// As many were run as may be; others are not excluded.
    TriedEnough,
    /// There are more than are searched.
    TooManyCombinations,
}

/// An input and the offer that is chosen for it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct AllocatedInput {
    /// Path of the input.
    pub path: String,
    /// The chosen number of the input.
    pub what: Loosened,
    /// Its unit.
    pub unit: SiUnit,
    /// The value.
    #[serde(with = "extended")]
    pub value_si: f64,
    /// Its cost.
    #[serde(with = "extended")]
    pub cost: f64,
}

/// How far several inputs may be loosened together, the others as in the study.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TogetherRecord {
    /// How they go together.
    pub how: Together,
    /// The inputs; values below are in their order.
    pub inputs: Vec<LoosenedInput>,
    /// Combinations at which all requirements are met, and met again with other random numbers: the loosest one, or those of the
    /// frontier with the first input rising. Empty where there is none.
    pub allowed_si: Vec<Vec<f64>>,
    /// The next looser combinations that were tried, at which they are not met or not decided, in the same order.
    pub beyond_si: Vec<Vec<f64>>,
    /// Every study that was run, in its order.
    pub checks: Vec<TogetherCheck>,
    /// Runs of all of them.
    pub runs: u64,
}

/// How several inputs are loosened together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Together {
    /// Each has the same share of its largest value.
    Proportional,
    /// For each value of the first of two, the loosest value of the second.
    Frontier,
}

/// An input that is loosened together with others.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LoosenedInput {
    /// Its path.
    pub path: String,
    /// The loosened number of the input.
    pub what: Loosened,
    /// Its unit.
    pub unit: SiUnit,
    /// The least value that is tried.
    #[serde(with = "extended")]
    pub least_si: f64,
    /// The loosest value that was asked about.
    #[serde(with = "extended")]
    pub up_to_si: f64,
}

/// A direct study at one combination.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TogetherCheck {
    /// A value for each input.
    pub values_si: Vec<f64>,
    /// Result of the study.
    #[serde(flatten)]
    pub answer: CheckAnswer,
}
